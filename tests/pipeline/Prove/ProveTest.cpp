// `drydock prove` finds what breaks its promises: a plugin that breaks one each (tests/plugins/BrokenPromises).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ProgramTestUtils.h"
#include "Prove/Prove.h"

#include <cmath>
#include <nlohmann/json.hpp>

using ProgramTest::FOutcome;
using ProgramTest::FProgramFolder;
using testing::HasSubstr;
using testing::Not;

namespace
{

constexpr int Width = 256;
constexpr int Height = 32;

class BrokenPromises : public testing::Test
{
protected:
	BrokenPromises()
	{
		Drydock::FImage Scene{Width, Height, 3, {}};
		for (int Index = 0; Index < Width * Height * 3; ++Index)
		{
			Scene.Values.push_back(0.1 + (Index * 7 % 64) / 128.0);
		}
		Drydock::WriteExr((Folder.Path / "scene.exr").string(), Scene, {"R", "G", "B"});
		Folder.Write(
			"promises.json", R"({"scene": {"file": "scene.exr"}, "camera": {"Settings": {"BloomIntensity": 0}}})");
	}

	FOutcome Prove(int Fault, const std::string& More) const
	{
		return Folder.Call("prove promises.json --plugin " DRYDOCK_TEST_BINARY_DIR
						   "/lib/libBrokenPromises.so --set r.BrokenPromises=" +
						   std::to_string(Fault) + " " + More);
	}

	const FProgramFolder Folder{"promises"};
};

} // namespace

TEST_F(BrokenPromises, NoneIsBrokenByAPassThatBehaves)
{
	const FOutcome Outcome = Prove(0, "");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	EXPECT_THAT(Outcome.Printed, HasSubstr("all of which hold"));
}

TEST_F(BrokenPromises, AHalfThatWasNotDrawnIsRead)
{
	const FOutcome Outcome = Prove(1, "--only 'Clobbered*'");
	EXPECT_EQ(1, Outcome.ExitCode) << Outcome.Printed;
	EXPECT_THAT(Outcome.Printed, HasSubstr("3 equivalences, 3 broken"));
	EXPECT_THAT(Outcome.Printed, HasSubstr("first in pass BrokenPromises, FBrokenPromisesPS, of libBrokenPromises.so: "
										   "BrokenPromises pixel (128, 0) is "));
	EXPECT_THAT(Outcome.Printed, HasSubstr("it reads BrokenHalf: 128 x 32 of 256 x 32 was written before"));
	EXPECT_THAT(Outcome.Printed, HasSubstr("likely: something is read that nothing wrote"));
}

TEST_F(BrokenPromises, WhatAComputeShaderDidNotStoreIsRead)
{
	const FOutcome Outcome = Prove(2, "--only ClobberedNaN --json");
	EXPECT_EQ(1, Outcome.ExitCode) << Outcome.Printed;
	const nlohmann::json Found = nlohmann::json::parse(Outcome.Printed).at("equivalences").at(0);
	EXPECT_EQ(false, Found.at("holds").get<bool>());
	// The pass that stores every second texel is not to blame: who reads the others is.
	EXPECT_EQ("BrokenPromises", Found.at("firstPass").at("pass"));
	EXPECT_EQ(1, Found.at("firstPass").at("pixel").at("x"));
	EXPECT_EQ("nan", Found.at("firstPass").at("pixel").at("other").at(0));
	EXPECT_EQ("BrokenHelper: by pass BrokenFillEven, all but 4096 pixels (the first is (1, 0))",
		Found.at("firstPass").at("partlyDrawn").at(0));
}

TEST_F(BrokenPromises, MemoryIsKeptBeyondItsTime)
{
	const FOutcome Outcome = Prove(3, "--only NoAliasing");
	EXPECT_EQ(1, Outcome.ExitCode) << Outcome.Printed;
	EXPECT_THAT(Outcome.Printed, HasSubstr("first in pass BrokenCopy, of libBrokenPromises.so: BrokenResult pixel"));
	EXPECT_THAT(Outcome.Printed, HasSubstr("likely: a pass uses memory that is not its own"));
}

TEST_F(BrokenPromises, ASumDependsOnTheOrderOfThreads)
{
	const FOutcome Outcome = Prove(4, "--only FourLanes --set r.Drydock.Threads=1");
	if (Outcome.Printed.find("has no code for it") != std::string::npos)
	{
		GTEST_SKIP() << "DRYDOCK_INSTRUCTION_SETS=native";
	}
	EXPECT_EQ(1, Outcome.ExitCode) << Outcome.Printed;
	EXPECT_THAT(Outcome.Printed, HasSubstr("first in pass BrokenSum, FBrokenSumCS, of libBrokenPromises.so: "
										   "BrokenHelper pixel (0, 0) is "));
	EXPECT_THAT(Outcome.Printed, HasSubstr("likely: threads of one dispatch write one texel"));
}

TEST_F(BrokenPromises, AnEffectIgnoresTheViewsRect)
{
	const FOutcome Outcome = Prove(5, "--only OffsetRect");
	EXPECT_EQ(1, Outcome.ExitCode) << Outcome.Printed;
	// In a texture of its own the middle is at 128; at (128, 64) of one that is 128 + 256 + 37 wide, at 210.5 - 128.
	EXPECT_THAT(Outcome.Printed, HasSubstr("first in pass BrokenPromises, FBrokenPromisesPS, of libBrokenPromises.so: "
										   "BrokenPromises pixel (82, 0) is "));
	EXPECT_THAT(Outcome.Printed, HasSubstr("likely: a shader takes its place from the texture's extent"));
	EXPECT_EQ(0, Prove(5, "--only 'Clobbered*'").ExitCode);
}

TEST_F(BrokenPromises, AnExtensionCountsFrames)
{
	const FOutcome Outcome = Prove(6, "--only SecondRun");
	EXPECT_EQ(1, Outcome.ExitCode) << Outcome.Printed;
	EXPECT_THAT(Outcome.Printed, HasSubstr("likely: an extension keeps something from one frame to the next"));
}

TEST_F(BrokenPromises, AMisspeltEquivalenceIsNamed)
{
	const FOutcome Outcome = Prove(0, "--only OneThred");
	EXPECT_EQ(2, Outcome.ExitCode);
	EXPECT_THAT(Outcome.Printed, HasSubstr("there is no equivalence 'OneThred'; did you mean OneThread?"));
}

TEST(ComparePixels, RoundingIsOneStepInFewValues)
{
	const auto MakePicture = [](int NumOthers, float Value)
	{
		const FRHITextureDesc Desc = FRHITextureDesc::Create2D(
			FIntPoint(100, 40), PF_A32B32G32R32F, FClearValueBinding::None, ETextureCreateFlags::ShaderResource);
		TRefCountPtr<FRHITexture> Texture = new FRHITexture(Desc, TEXT("Compared"));
		Texture->EnsureMemory();
		for (int Y = 0; Y < 40; ++Y)
		{
			for (int X = 0; X < 100; ++X)
			{
				const bool bOther = Y * 100 + X < NumOthers;
				const float Red = bOther ? Value : 0.5f;
				Texture->WriteTexelDouble(X, Y, FVector4(Red, 0.5, 0.5, 1));
			}
		}
		return Drydock::FPicture(Texture, FIntRect(0, 0, 100, 40), 4);
	};
	using Drydock::ComparePixels;
	using Drydock::EAlike;
	const Drydock::FPicture Base = MakePicture(0, 0.5f);
	EXPECT_FALSE(ComparePixels(Base, Base, EAlike::SameBits));
	EXPECT_TRUE(ComparePixels(Base, MakePicture(1, std::nextafter(0.5f, 1.0f)), EAlike::SameBits));
	EXPECT_FALSE(ComparePixels(Base, MakePicture(16, 0.5f + 1 / 255.0f), EAlike::SameButForRounding));
	EXPECT_TRUE(ComparePixels(Base, MakePicture(17, 0.5f + 1 / 255.0f), EAlike::SameButForRounding));
	EXPECT_TRUE(ComparePixels(Base, MakePicture(1, 0.5f + 2 / 255.0f), EAlike::SameButForRounding));
}
