// A run reports what its overlays did: places that were not called, functions that fill no place, files that nothing
// reads; the engine's own forms of condition and default act.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "OverlayTestUtils.h"
#include "pipeline/ProgramTestUtils.h"

#include <array>
#include <regex>
#include <thread>

using namespace OverlayTest;
using ProgramTest::FOutcome;
using ProgramTest::FProgramFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace
{

class OverlayUse : public testing::Test
{
protected:
	void SetUp() override
	{
		Folder.WriteFrame("frame.json", R"(, "camera": {"Settings": {"BloomIntensity": 1}})");
		ASSERT_EQ(0, Folder.Call("overlay new MyPatch --pass BloomSetup").ExitCode);
	}

	/** Puts New in place of Old, which the file must hold. */
	void Edit(const std::string& File, const std::string& Old, const std::string& New)
	{
		std::string Text = Folder.Read(File);
		ASSERT_NE(std::string::npos, Text.find(Old)) << File;
		Folder.Write(File, Text.replace(Text.find(Old), Old.size(), New));
	}

	std::string Run(const std::string& Arguments, int ExitCode = 0)
	{
		const FOutcome Outcome = Folder.Call("run frame.json --out out " + Arguments);
		EXPECT_EQ(ExitCode, Outcome.ExitCode) << Outcome.Printed;
		return Outcome.Printed;
	}

	std::string GetPicture(const std::string& Arguments)
	{
		Run(Arguments);
		return Folder.Read("out/final.exr");
	}

	const FProgramFolder Folder{"overlay_use"};
	const std::string Chain = "MyPatch/" + Renderer + "PostProcessing.cpp";
	const std::string Setup = "MyPatch/" + Renderer + "PostProcessBloomSetup.cpp";
};

} // namespace

TEST_F(OverlayUse, APlaceThatWasNotCalledIsNamedWithTheReason)
{
	const std::string Off = Run("--overlay MyPatch --pp BloomThreshold=-1");
	EXPECT_THAT(
		Off, HasSubstr("DD1137: the overlay MyPatch's AddBloomSetupPass was not called: BloomThreshold is -1 and "
					   "local exposure does not act on bloom"));
	EXPECT_THAT(Off, HasSubstr("/Engine/Private/PostProcessBloom.usf is in no pass of this frame"));
	EXPECT_THAT(Off, Not(HasSubstr("adds the bloom setup")));
	EXPECT_THAT(Run("--overlay MyPatch --pp BloomThreshold=0.5"), Not(HasSubstr("DD1137")));
	EXPECT_THAT(Run("--overlay MyPatch --pp BloomIntensity=0"),
		HasSubstr(
			"PostProcessing.cpp: if (bBloomSetupRequiredEnabled) was not called: Bloom does not run: BloomIntensity"));
}

TEST_F(OverlayUse, TheOverlaysConditionDecides)
{
	Edit(Chain, "\tif (bBloomSetupRequiredEnabled)",
		"\t// bool bBloomSetupRequiredEnabled = false;\n\tconst bool bBloomSetupRequiredEnabled = BloomThreshold > "
		"-1.0f ||\n"
		"\t\tView.FinalPostProcessSettings.BloomToonIntensity != 1.0f;\n\n\tif (bBloomSetupRequiredEnabled)");
	EXPECT_THAT(Run("--overlay MyPatch --pp BloomThreshold=-1 --pp BloomToonIntensity=0.5"), Not(HasSubstr("DD1137")));
	EXPECT_THAT(Run("--overlay MyPatch --pp BloomThreshold=-1 --pp BloomToonIntensity=1"), HasSubstr("was not called"));
}

TEST_F(OverlayUse, AFunctionThatFillsNoPlaceIsAnErrorWithTheSignature)
{
	// Without its header, which is drydock's then, and with another place's function that is not one.
	std::filesystem::remove(Folder.Path / ("MyPatch/" + Renderer + "PostProcessBloomSetup.h"));
	EXPECT_THAT(Run("--overlay MyPatch --pp BloomThreshold=0.5"), HasSubstr("PostProcessBloom.usf, AddBloomSetupPass"));
	Edit(Setup, "const FBloomSetupInputs& Inputs)\n{\n\tcheck",
		"const FBloomSetupInputs& Inputs, int Extra)\n{\n\tcheck");
	Folder.Write("MyPatch/" + Renderer + "PostProcessCombineLUTs.cpp",
		"#include \"PostProcess/PostProcessCombineLUTs.h\"\n#if 0\n"
		"FRDGTextureRef AddCombineLUTPass(FRDGBuilder& GraphBuilder, const FViewInfo& View) { return nullptr; "
		"}\n#endif\n");
	const std::string Printed = Run("--overlay MyPatch --pp BloomThreshold=0.5", 2);
	EXPECT_THAT(Printed, HasSubstr("stands in for /Engine/Private/PostProcessBloom.usf, PostProcessing.cpp: if"));
	EXPECT_THAT(Printed, Not(HasSubstr("DD2084")));
	EXPECT_THAT(Printed,
		AllOf(HasSubstr("PostProcessCombineLUTs.cpp:3: error DD1131: AddCombineLUTPass does not stand in"),
			HasSubstr(
				"expected the function FRDGTextureRef AddCombineLUTPass(FRDGBuilder& GraphBuilder, const FViewInfo&")));
	EXPECT_THAT(
		Printed, HasSubstr("expected the function FScreenPassTexture AddBloomSetupPass(FRDGBuilder& GraphBuilder, "
						   "const FViewInfo& View, const FBloomSetupInputs& Inputs)"));
}

TEST_F(OverlayUse, AFailedCheckIsTheOverlays)
{
	Edit(Setup, "check(Inputs.EyeAdaptationBuffer);", "check(Inputs.Threshold > 1.0f);");
	const std::string Printed = Run("--overlay MyPatch --pp BloomThreshold=0.5", 71);
	const std::string Said = "a check of the plugin failed: ";
	EXPECT_THAT(Printed, HasSubstr("plugin libMyPatch.so, PostProcessing.cpp: if (bBloomSetupRequiredEnabled)"));
	ASSERT_THAT(Printed, HasSubstr(Said));
	EXPECT_EQ(std::string::npos, Printed.find(Said, Printed.find(Said) + 1)) << Printed;

	// Without the block the function itself is called, and it crashes.
	std::filesystem::remove(Folder.Path / Chain);
	Edit(Setup, "check(Inputs.Threshold > 1.0f);", "*static_cast<volatile int*>(nullptr) = 1;");
	EXPECT_THAT(Run("--overlay MyPatch --pp BloomThreshold=0.5", 71),
		AllOf(HasSubstr("DD2086"), HasSubstr("plugin libMyPatch.so, AddBloomSetupPass")));
}

TEST_F(OverlayUse, DefaultsOfKnownSettingsAct)
{
	Folder.Write("Only/" + SceneSource,
		"FPostProcessSettings::FPostProcessSettings()\n{\n\tVignetteIntensity = 0.9f;\n\tBloomThreshold = -1.0f;\n"
		"\tColorSaturation = FVector4(1.0f, 1.0f, 1.0f, 1.0f);\n\tBloomMethod = BM_SOG;\n}\n");
	const std::string Given = GetPicture("--pp VignetteIntensity=0.9");
	EXPECT_EQ(Given, GetPicture("--overlay Only"));
	EXPECT_NE(Given, GetPicture("--overlay Only --pp VignetteIntensity=0.4"));
	EXPECT_NE(Given, GetPicture(""));
	EXPECT_THAT(
		Run("--overlay Only"), AllOf(HasSubstr("the overlay Only stands in for the default of VignetteIntensity\n"),
								   Not(HasSubstr("BloomThreshold"))));
	EXPECT_THAT(Folder.Call("blend frame.json --overlay Only --setting VignetteIntensity").Printed, HasSubstr("0.9"));
}

TEST_F(OverlayUse, AddedSettingsAreKnownToEveryVerb)
{
	Folder.Write("Dusk/" + SceneHeader, DuskHeader);
	Folder.Write("Dusk/" + SceneSource, DuskSource);
	Folder.WriteFrame("dusk.json", R"(, "overlay": "Dusk", "volumes": [{"name": "Night", "bUnbound": true,
		"Settings": {"DuskMode": "Cold", "DuskAmount": 0.5}}])");
	for (const char* const Call : {"blend dusk.json --setting 'Dusk*'", "explain dusk.json --setting DuskAmount",
			 "settings export dusk.json", "settings export dusk.json --at 0,0,0", "schema dusk.json",
			 "list settings dusk.json", "list settings Dusk --config dusk.json"})
	{
		const FOutcome Outcome = Folder.Call(Call + std::string(" 2>/dev/null #"));
		EXPECT_EQ(0, Outcome.ExitCode) << Call;
		EXPECT_THAT(Outcome.Printed, HasSubstr("DuskAmount")) << Call;
	}
	EXPECT_THAT(Folder.Call("settings export dusk.json").Printed, HasSubstr("DuskMode=Cold"));
}

TEST_F(OverlayUse, ATraceShowsTheOverlaysText)
{
	const std::string Shader = "MyPatch/Engine/Shaders/Private/PostProcessBloom.usf";
	Folder.Write(Shader, "// A line of the overlay's\n// and another\n" + Folder.Read(Shader));
	Folder.Write("Only/Engine/Shaders/Private/PostProcessBloom.usf", Folder.Read(Shader));
	const std::string Trace = "trace frame.json --pass 'BloomSetup*' --pixel 2,2 --pp BloomThreshold=0.5";
	const std::string Plain = Folder.Call(Trace).Printed;
	const std::string Overlaid = Folder.Call(Trace + " --overlay Only").Printed;
	// The same line of source, two further down.
	std::smatch Line;
	ASSERT_TRUE(std::regex_search(Plain, Line, std::regex("\n +([0-9]+)   (float2 UV = [^\n]*)\n"))) << Plain;
	EXPECT_THAT(Overlaid, HasSubstr(" " + std::to_string(std::stoi(Line[1]) + 2) + "   " + Line[2].str())) << Overlaid;
	const std::string Probe = Folder.Call("probe frame.json 3,3").Printed;
	EXPECT_THAT(Probe, HasSubstr(" at the pixel, read: "));
	EXPECT_THAT(Probe, testing::ContainsRegex("read: [0-9]+,[0-9]+( x [0-9.]+)? = "));
}

TEST_F(OverlayUse, RunsShareABuild)
{
	const std::string Constructor = "FPostProcessSettings::FPostProcessSettings()\n{\n\tVignetteIntensity = ";
	Folder.Write("Only/" + SceneSource, Constructor + "0.5f;\n}\n");
	Folder.Write("Other/Only/" + SceneSource, Constructor + "0.75f;\n}\n");
	std::array<FOutcome, 2> Both;
	std::thread First([&] { Both[0] = Folder.Call("run frame.json --out first --overlay Only"); });
	std::thread Second([&] { Both[1] = Folder.Call("run frame.json --out second --overlay Only"); });
	First.join();
	Second.join();
	size_t NumBuilt = 0;
	for (const FOutcome& Each : Both)
	{
		EXPECT_EQ(0, Each.ExitCode) << Each.Printed;
		NumBuilt += Each.Printed.find("building the C++ of the overlay Only") != std::string::npos ? 1 : 0;
	}
	EXPECT_EQ(1u, NumBuilt);
	EXPECT_EQ(Folder.Read("first/final.exr"), Folder.Read("second/final.exr"));
	EXPECT_THAT(Run("--overlay Other/Only"), HasSubstr("building the C++"));
	EXPECT_THAT(Run("--overlay Only"), Not(HasSubstr("building the C++"))) << "they took turns in one folder";
}

TEST_F(OverlayUse, ShadersThatNothingReadsAreNamedWithTheNearestPath)
{
	const std::string Shader = Folder.Read("MyPatch/Engine/Shaders/Private/PostProcessBloom.usf");
	Folder.Write("Only/Engine/Shaders/Private/PostProcesBloom.usf", Shader);
	Folder.Write("Only/Engine/Shaders/PostProcessBloom.usf", Shader);
	Folder.Write("Only/Engine/Shaders/Private/PostProcessFFTBloom.usf", "#error \"never in this frame\"\n");
	const std::string Printed = Run("--overlay Only");
	EXPECT_THAT(Printed, HasSubstr("the overlay Only stands in for /Engine/Private/PostProcessFFTBloom.usf\n"));
	EXPECT_THAT(Printed, HasSubstr("PostProcesBloom.usf (did you mean /Engine/Private/PostProcessBloom.usf?)"));
	EXPECT_THAT(
		Printed, HasSubstr("/Engine/PostProcessBloom.usf (did you mean /Engine/Private/PostProcessBloom.usf?)"));
	EXPECT_THAT(Printed, HasSubstr("PostProcessFFTBloom.usf is in no pass of this frame"));
	const FOutcome Check = Folder.Call("check frame.json --overlay Only");
	EXPECT_EQ(2, Check.ExitCode) << Check.Printed;
	EXPECT_THAT(Check.Printed, HasSubstr("never in this frame"));

	std::filesystem::create_symlink("nowhere", Folder.Path / "Only/Engine/Shaders/Private/Gone.usf");
	EXPECT_THAT(Run("--overlay Only", 2), HasSubstr("Gone.usf: error DD1130: is a link to a file that does not exist"));
}
