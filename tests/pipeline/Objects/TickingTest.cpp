// Time reaches a plugin's objects (tests/plugins/Ticking), and a config calls what a Blueprint would.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Run/Run.h"

using namespace Drydock;
using testing::ElementsAre;
using testing::HasSubstr;

namespace
{

FRunOptions MakeOptions(const std::string& Objects)
{
	FRunOptions Options;
	Options.ConfigFile = DRYDOCK_TEST_SOURCE_DIR "/configs/ticking.json";
	Options.ConfigText =
		R"({"scene": {"file": "scenes/moving_camera.####.exr", "fps": 4}, "showFlags": {"Bloom": false},
		"plugins": [")" DRYDOCK_TEST_BINARY_DIR R"(/lib/libTicking.so"], "objects": {)" +
		Objects + "}}";
	return Options;
}

std::vector<double> GetColor(const FRunResult& Result)
{
	return {Result.SceneLinear.Get(3, 2, 0), Result.SceneLinear.Get(3, 2, 1), Result.SceneLinear.Get(3, 2, 2)};
}

std::vector<std::string> GetErrors(const std::string& Objects)
{
	std::vector<std::string> Errors;
	try
	{
		FRunSession(MakeOptions(Objects)).Run(1, {});
	}
	catch (const FError& Error)
	{
		for (const FDiagnostic& Diagnostic : Error.GetDiagnostics())
		{
			Errors.push_back(std::to_string(Diagnostic.Code) + " " + Diagnostic.Where + ": " + Diagnostic.Message);
		}
	}
	return Errors;
}

} // namespace

// A frame has a quarter of a second. The component ticks each half second; the timer's rate is the actor's.
TEST(Ticking, EachFrameTicksWithItsSeconds)
{
	FRunSession Session(MakeOptions(R"("ATickingActor": {"Rate": 0.125})"));
	std::vector<double> Blue;
	std::vector<FViewHistory> Last;
	for (const int Frame : {1, 2, 3})
	{
		FRunResult Result = Session.Run(Frame, Last);
		Last = Result.ViewStates;
		const std::vector<double> Color = GetColor(Result);
		EXPECT_EQ(0.25 * Frame + (Frame >= 2 ? 16 * 0.5 : 0), Color[0]) << Frame;
		EXPECT_EQ(2 * Frame + 16, Color[1]) << Frame;
		Blue.push_back(Color[2]);
	}
	EXPECT_EQ(0.25 * 17, Blue[1] - Blue[0]);
	EXPECT_EQ(0.25 * 17, Blue[2] - Blue[1]);
}

// A frame that is left out is part of the next one's time.
TEST(Ticking, ALeftOutFrameCounts)
{
	FRunSession Session(MakeOptions(R"("ATickingActor": {})"));
	const FRunResult First = Session.Run(1, {});
	EXPECT_EQ(17 * 1.25, GetColor(Session.Run(5, First.ViewStates))[0]);
}

TEST(Ticking, TheConfigCallsFunctions)
{
	const std::string Call = R"("ATickingActor": {"call": [{"SetFactor": [2]},
		{"SetGlow": ["Glowing", [0.5, 1, 2], "name"]}, {"AddGlow": [null, 0.25]}]})";
	const double Before = GetColor(FRunSession(MakeOptions(Call)).Run(1, {}))[0];
	const std::vector<double> Color = GetColor(FRunSession(MakeOptions(Call)).Run(1, {}));
	EXPECT_EQ(0.25, Color[0] - Before); // a static variable stays
	EXPECT_EQ(2 * 1 + 4, Color[1]);

	const auto GetBlue = [](const std::string& First)
	{
		return GetColor(
			FRunSession(MakeOptions(R"("UTickingSubsystem": {"call": [{"Start": [)" + First + "]}]}")).Run(1, {}))[2];
	};
	const double Blue = GetBlue("0");
	EXPECT_EQ(8 + 0.25 * 17, GetBlue("8") - Blue);
}

TEST(Ticking, AComponentThatTheConfigNamesIsPlaced)
{
	const auto GetRed = [](const std::string& Objects)
	{
		return GetColor(FRunSession(MakeOptions(Objects)).Run(1, {}))[0];
	};
	EXPECT_EQ(0.0, GetRed(""));
	EXPECT_EQ(1024 * 3.0, GetRed(R"("ULevelComponent": {"Amount": 3, "call": []})"));
	EXPECT_EQ(1024 * 6.0, GetRed(R"("ULevelComponent": {"Amount": 3, "call": ["Double"]})"));
	EXPECT_EQ(1024 * 0.5, GetRed(R"("UTickingComponent": {})"));
	// The actor has one, whatever comes first.
	EXPECT_EQ(0.25, GetRed(R"("UTickingComponent": {}, "ATickingActor": {})"));
	EXPECT_EQ(0.0, GetRed("")); // nothing of it stays
}

TEST(Ticking, AnActionThatAFunctionReturnsIsActivated)
{
	const std::string Actor = R"("ATickingActor": {"call": [{"SetGlow": ["Glowing", [0, 0, 0], "name"]}]})";
	const double Before = GetColor(FRunSession(MakeOptions(Actor)).Run(1, {}))[0];
	const std::string Call = Actor + R"(, "UTickingAction": {"call": [{"AddLater": [null, 0.5]}]})";
	EXPECT_EQ(0.5, GetColor(FRunSession(MakeOptions(Call)).Run(1, {}))[0] - Before);
}

TEST(Ticking, WhatCannotBeCalledIsToldAtItsPlace)
{
	EXPECT_THAT(GetErrors(R"("ATickingActor": {"call": [{"SetGlov": []}, "OnGlow", "Undefined"]})"),
		ElementsAre(
			HasSubstr("2121 /objects/ATickingActor/call/0/SetGlov: ATickingActor has no UFUNCTION(BlueprintCallable) "
					  "SetGlov; did you mean SetGlow?"),
			HasSubstr("/call/1: ATickingActor has no UFUNCTION(BlueprintCallable) OnGlow"),
			HasSubstr("/call/2: ATickingActor has no UFUNCTION(BlueprintCallable) Undefined")));
	EXPECT_THAT(GetErrors(R"("ATickingActor": {"call": [{"SetGlow": ["Glow", [1, 1, 1], "a"]}, {"SetFactor": [1, 2]},
		{"SetGlow": ["Still", [1, "x", 1], "a"]}, 7]})"),
		ElementsAre(HasSubstr("2122 /objects/ATickingActor/call/0/SetGlow/0: expected one of Still, Glowing"),
			HasSubstr("2122 /objects/ATickingActor/call/1/SetFactor: ATickingActor::SetFactor has 1 parameters, and 2 "
					  "arguments are given"),
			HasSubstr("2122 /objects/ATickingActor/call/2/SetGlow/1: expected [R, G, B, A]"),
			HasSubstr("2122 /objects/ATickingActor/call/3: expected a function's name, or an object with one name")));
	EXPECT_THAT(GetErrors(R"("ATickingActor": {"call": {"SetFactor": [1]}})"),
		ElementsAre(HasSubstr("2122 /objects/ATickingActor/call: expected a list of calls")));
	EXPECT_THAT(GetErrors(R"("UTickingLibrary": {"call": [{"Say": [1]}]})"),
		ElementsAre(HasSubstr("2123 /objects/UTickingLibrary/call/0: Say is not called: there is no object of "
							  "UTickingLibrary")));
}
