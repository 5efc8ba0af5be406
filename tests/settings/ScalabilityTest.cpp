// sg.PostProcessQuality: its values, and that scalability is the weakest setter. Values: the engine's documented
// presets (BloomQuality is 4, 4, 5, 5, 5 in Epic's guide to scalability; Low is 0 or off where it can be).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "HAL/ConsoleVariableTools.h"
#include "Scalability.h"

using namespace Drydock;
using testing::HasSubstr;

namespace
{

struct Scalability : testing::Test
{
	void SetUp() override
	{
		ResetConsoleVariables();
		OldHandler =
			SetLogHandler([this](const TCHAR*, ELogVerbosity::Type, const std::string& Text) { Log += Text + "\n"; });
	}
	void TearDown() override
	{
		ResetConsoleVariables();
		SetLogHandler(OldHandler);
	}

	static IConsoleVariable* Find(const char* Name) { return IConsoleManager::Get().FindConsoleVariable(Name); }
	static std::string SetterOf(const char* Name) { return GetConsoleVariableSetByName(Find(Name)->GetFlags()); }

	FLogHandler OldHandler;
	std::string Log;
};

} // namespace

TEST_F(Scalability, EveryRowIsAVariableThatTakesItsValues)
{
	for (const FScalabilityRow& Row : GetPostProcessQualityRows())
	{
		const IConsoleVariable* Variable = Find(Row.Variable);
		ASSERT_NE(nullptr, Variable) << Row.Variable;
		for (const char* Value : Row.Values)
		{
			EXPECT_TRUE(Value == nullptr || DoesConsoleVariableTake(*Variable, Value)) << Row.Variable;
		}
	}
}

TEST_F(Scalability, SettingTheGroupSetsItsVariables)
{
	const int32 BloomQuality[] = {4, 4, 5, 5, 5};
	for (int32 Level = 0; Level < NumScalabilityLevels; ++Level)
	{
		Find("sg.PostProcessQuality")->Set(Level, ECVF_SetByConsole);
		EXPECT_EQ(BloomQuality[Level], Find("r.BloomQuality")->GetInt()) << Level;
	}
	EXPECT_EQ("Scalability", SetterOf("r.BloomQuality"));
	EXPECT_EQ("Console", SetterOf("sg.PostProcessQuality"));
}

TEST_F(Scalability, LowTurnsTheTonemappersExtrasOff)
{
	Find("sg.PostProcessQuality")->Set(0, ECVF_SetByCommandline);
	EXPECT_EQ(0, Find("r.Tonemapper.Quality")->GetInt());
	EXPECT_EQ(0, Find("r.SceneColorFringeQuality")->GetInt());
	EXPECT_EQ(0.6f, Find("r.Filter.SizeScale")->GetFloat());
}

TEST_F(Scalability, UntilItIsSetEverythingHasItsDefault)
{
	EXPECT_EQ(3, Find("sg.PostProcessQuality")->GetInt());
	EXPECT_EQ(7.0f, Find("r.FastBlurThreshold")->GetFloat());
	EXPECT_EQ("Constructor", SetterOf("r.FastBlurThreshold"));
}

TEST_F(Scalability, WhoSetAVariableBeatsThePreset)
{
	Find("r.BloomQuality")->Set(2, ECVF_SetByConsoleVariablesIni);
	Find("sg.PostProcessQuality")->Set(0, ECVF_SetByConsole);
	EXPECT_EQ(2, Find("r.BloomQuality")->GetInt());
	EXPECT_THAT(Log, HasSubstr("'r.BloomQuality' with 'SetByScalability' was ignored as it is lower priority than the "
							   "previous 'SetByConsoleVariablesIni'. Value remains '2'"));
}

TEST_F(Scalability, PresetNeverBeatsALaterConfig)
{
	Find("sg.PostProcessQuality")->Set(0, ECVF_SetByConsole);
	Find("r.BloomQuality")->Set(2, ECVF_SetByConsoleVariablesIni);
	EXPECT_EQ(2, Find("r.BloomQuality")->GetInt());
	EXPECT_EQ("", Log);
}

TEST_F(Scalability, LevelsOutsideAreClamped)
{
	ApplyPostProcessQuality(9);
	EXPECT_EQ(4, Find("r.DepthOfFieldQuality")->GetInt());
	ApplyPostProcessQuality(-9);
	EXPECT_EQ(0, Find("r.DepthOfFieldQuality")->GetInt());
}

TEST_F(Scalability, SnapshotPutsBackTheGroupAndItsVariables)
{
	Find("r.BloomQuality")->Set(2, ECVF_SetByCode);
	{
		const FConsoleVariableSnapshot Snapshot;
		Find("sg.PostProcessQuality")->Set(0, ECVF_SetByConsole);
	}
	EXPECT_EQ("Constructor", SetterOf("sg.PostProcessQuality"));
	EXPECT_EQ(7.0f, Find("r.FastBlurThreshold")->GetFloat());
	EXPECT_EQ("Constructor", SetterOf("r.FastBlurThreshold"));
	EXPECT_EQ("Code", SetterOf("r.BloomQuality"));
}

TEST_F(Scalability, WhatNothingReadsSaysSo)
{
	for (const FConsoleVariableInfo& Info : ListConsoleVariables())
	{
		EXPECT_EQ(Info.bNotSimulated, Info.Help.StartsWith("Not simulated")) << *Info.Name;
	}
	EXPECT_TRUE(Find("r.DOF.Gather.RingCount")->TestFlags(ECVF_NotSimulated));
	EXPECT_FALSE(Find("r.BloomQuality")->TestFlags(ECVF_NotSimulated));
}
