// Engine text to configs and back, as the verbs do it: what is printed is a config's "volumes", and leads back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Config/ReadConfig.h"
#include "Config/SettingsJson.h"
#include "PostProcessSettingsReflection.h"
#include "SettingObjects.h"
#include "Text/JsonWriter.h"
#include "pipeline/ProgramTestUtils.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sys/wait.h>
#include <unistd.h>

using namespace Drydock;

namespace
{

std::vector<FVolumeText> ReadText(const std::string& Text)
{
	std::vector<FDiagnostic> Diagnostics;
	return ReadVolumesText(Text, "clip.txt", Diagnostics);
}

std::string MakeVolumesJson(const std::vector<FVolumeText>& Volumes)
{
	FJsonWriter Writer;
	WriteVolumes(Writer, Volumes);
	return Writer.GetText();
}

/** The volumes of a config that has what import prints; no errors. */
std::vector<FConfigVolume> Configure(const std::vector<FVolumeText>& Volumes)
{
	std::vector<FDiagnostic> Diagnostics;
	const FConfig Config = ReadConfig("{\"volumes\": " + MakeVolumesJson(Volumes) + "}", "a.json", Diagnostics);
	for (const FDiagnostic& Diagnostic : Diagnostics)
	{
		EXPECT_NE(ESeverity::Error, Diagnostic.Severity) << Diagnostic.ToString();
	}
	return Config.Volumes;
}

FVolumeText ThroughConfig(const FVolumeText& Volume)
{
	std::vector<FDiagnostic> Diagnostics;
	const FVolumeText Again = MakeVolumeText(Configure({Volume}).at(0), "a.json", Diagnostics);
	EXPECT_TRUE(Diagnostics.empty()) << Diagnostics[0].ToString();
	return Again;
}

std::string WriteFull(const FVolumeText& Volume)
{
	std::vector<FDiagnostic> Diagnostics;
	return WriteVolumesText({Volume}, ESettingsTextForm::Full, Diagnostics);
}

std::string ReadFile(const std::filesystem::path& Path)
{
	std::ifstream Stream(Path, std::ios::binary);
	EXPECT_TRUE(Stream) << Path;
	return std::string(std::istreambuf_iterator<char>(Stream), {});
}

const std::string GSample = "(bOverride_BloomIntensity=True,BloomIntensity=1.200000)";

/** The verb in a folder of its own. */
class SettingsVerb : public testing::Test
{
protected:
	SettingsVerb()
		: Folder(std::filesystem::temp_directory_path() / ("drydock_settings_" + std::to_string(getpid())))
	{
		std::filesystem::remove_all(Folder);
		std::filesystem::create_directories(Folder);
	}
	~SettingsVerb() override { std::filesystem::remove_all(Folder); }

	/** Sets ExitCode, Out and Err. */
	void Call(const std::string& Arguments)
	{
		const std::string Command = "cd '" + Folder.string() +
									"' && '" DRYDOCK_TEST_BINARY_DIR "/bin/drydock' settings " + Arguments +
									" >out.txt 2>err.txt";
		ExitCode = WEXITSTATUS(std::system(Command.c_str()));
		Out = ReadFile(Folder / "out.txt");
		Err = ReadFile(Folder / "err.txt");
	}

	void Write(const std::string& Name, const std::string& Text) const
	{
		std::ofstream(Folder / Name, std::ios::binary) << Text;
	}

	const std::filesystem::path Folder;
	int ExitCode = -1;
	std::string Out;
	std::string Err;
};

bool Contains(const std::string& Text, const std::string& Part)
{
	return Text.find(Part) != std::string::npos;
}

} // namespace

TEST(SettingsJson, OverriddenSettingsAreNamed)
{
	EXPECT_EQ(R"([
  {
    "name": "A",
    "bUnbound": true,
    "Priority": 0,
    "Settings": {
      "BloomMethod": "BM_FFT",
      "BloomIntensity": 1.2,
      "Bloom1Tint": [0.5, 0.3465, 0.3465, 1]
    }
  }
]
)",
		MakeVolumesJson(ReadText("Begin Actor Name=A\nbUnbound=True\nSettings=(bOverride_BloomIntensity=True,"
								 "BloomIntensity=1.2,bOverride_BloomMethod=True,BloomMethod=BM_FFT,"
								 "bOverride_Bloom1Tint=True,Bloom1Tint=(R=0.5))\nEnd Actor\n")));
}

TEST(SettingsJson, InertValuesKeepTheirBitOff)
{
	const FConfigVolume Volume = Configure(ReadText("(BloomIntensity=3)")).at(0);
	EXPECT_EQ(3.0f, Volume.Settings.Settings.BloomIntensity);
	EXPECT_FALSE(Volume.Settings.Settings.bOverride_BloomIntensity);
}

TEST(SettingsJson, BoundedVolumeHasABox)
{
	FVolumeText Volume;
	Volume.Box = FVolumeTextBox{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
	const FConfigVolume Configured = Configure({Volume}).at(0);
	EXPECT_EQ(EConfigShape::Box, Configured.Bounds.value().Shape);
	EXPECT_EQ((FConfigVector{1, 2, 3}), Configured.Bounds->Center);
	EXPECT_EQ(Volume.Box, ThroughConfig(Volume).Box);
}

TEST(SettingsJson, VolumesPropertiesSurvive)
{
	FVolumeText Volume;
	Volume.Name = "Stage \"left\"";
	Volume.bEnabled = false;
	Volume.bUnbound = true;
	Volume.Priority = 2.5;
	Volume.BlendRadius = 50.0;
	Volume.BlendWeight = 0.25;
	EXPECT_EQ(WriteFull(Volume), WriteFull(ThroughConfig(Volume)));
}

TEST(SettingsJson, EveryFieldSurvives)
{
	const FVolumeText Volume = ReadText(ReadFile(DRYDOCK_TEST_SOURCE_DIR "/tests/settings/full_export.txt")).at(0);
	EXPECT_EQ(WriteFull(Volume), WriteFull(ThroughConfig(Volume)));
}

TEST(SettingsJson, ObjectsAndBlendablesSurvive)
{
	const FVolumeText Volume =
		ReadText("(bOverride_BloomDirtMask=True,BloomDirtMask=Texture2D'/Game/A.A',WeightedBlendables=(Array=("
				 "(Weight=0.5,Object=Material'/Game/M.M'),(Weight=1.0,Object=None))))")
			.at(0);
	const FPostProcessSettings Settings = ThroughConfig(Volume).Settings.Settings;
	EXPECT_EQ(FindOrAddTexture("/Game/A.A"), Settings.BloomDirtMask.Get());
	ASSERT_EQ(2, Settings.WeightedBlendables.Array.Num());
	EXPECT_EQ(FWeightedBlendable(0.5f, FindOrAddObject("/Game/M.M")), Settings.WeightedBlendables.Array[0]);
	EXPECT_EQ(FWeightedBlendable(1.0f, nullptr), Settings.WeightedBlendables.Array[1]);
}

TEST(SettingsJson, UnknownFieldsSurvive)
{
	const FVolumeText Volume = ReadText("(BloomIntensity=0.675,New=(A=\"b \\\" c\"),bOverride_New=True)").at(0);
	EXPECT_EQ(2u, Volume.Settings.Unknown.size());
	EXPECT_EQ(Volume.Settings.Unknown, ThroughConfig(Volume).Settings.Unknown);
}

TEST(SettingsJson, UnknownFieldsOfAConfigCannotBreakTheText)
{
	FConfigVolume Volume;
	Volume.UnknownSettings = {{"New", "1),Priority=(", ""}, {"BloomIntensity", "1", ""}, {"Good", "1", ""}};
	std::vector<FDiagnostic> Diagnostics;
	EXPECT_EQ(1u, MakeVolumeText(Volume, "a.json", Diagnostics).Settings.Unknown.size());
	ASSERT_EQ(2u, Diagnostics.size());
	EXPECT_EQ(ESeverity::Error, Diagnostics[0].Severity);
}

TEST(SettingsJson, OtherShapesAreLeftOutWithAWarning)
{
	FConfigVolume Volume;
	Volume.Bounds = FConfigBounds();
	Volume.Bounds->Shape = EConfigShape::Sphere;
	std::vector<FDiagnostic> Diagnostics;
	EXPECT_FALSE(MakeVolumeText(Volume, "a.json", Diagnostics).Box);
	ASSERT_EQ(1u, Diagnostics.size());
	EXPECT_EQ(3025, Diagnostics[0].Code);
}

TEST_F(SettingsVerb, ImportPrintsVolumesOfAFile)
{
	Write("clip.txt", GSample);
	Call("import clip.txt");
	EXPECT_EQ(0, ExitCode);
	EXPECT_EQ("", Err);
	EXPECT_EQ(0u, Out.find("[\n  {\n    \"name\": \"clip\","));
	EXPECT_TRUE(Contains(Out, "\"BloomIntensity\": 1.2\n")) << Out;
}

TEST_F(SettingsVerb, ImportReadsStdin)
{
	Write("clip.txt", GSample);
	Call("import - < clip.txt");
	EXPECT_EQ(0, ExitCode);
	EXPECT_TRUE(Contains(Out, "\"name\": \"Pasted\"")) << Out;
}

TEST_F(SettingsVerb, MistakesAreExitTwoAndPrintNothing)
{
	Write("clip.txt", "(BloomIntensity=high,FilmToe=)");
	Call("import clip.txt");
	EXPECT_EQ(2, ExitCode);
	EXPECT_EQ("", Out);
	EXPECT_EQ("clip.txt:1:17: error DD3004 at BloomIntensity: expected a number, found high\n"
			  "clip.txt:1:30: error DD3004 at FilmToe: expected a number, found nothing\n",
		Err);
}

TEST_F(SettingsVerb, MissingFilesAreExitThree)
{
	Call("import none.txt");
	EXPECT_EQ(3, ExitCode);
	Call("export none.json");
	EXPECT_EQ(3, ExitCode);
}

TEST_F(SettingsVerb, ImportAsJsonHasVolumesAndMessages)
{
	Write("clip.txt", "(BloomIntensity=2)");
	Call("import clip.txt --json");
	EXPECT_EQ(0, ExitCode);
	EXPECT_EQ("", Err);
	EXPECT_EQ(0u, Out.find("{\n  \"volumes\": [\n"));
	EXPECT_TRUE(Contains(Out, "\"code\": \"DD3020\"")) << Out;
}

TEST_F(SettingsVerb, UpgradeActsWhenAskedFor)
{
	Write("clip.txt", "(bOverride_BloomMethod=True,BloomMethod=BM_FFT,bOverride_BloomIntensity=True,BloomIntensity=8)");
	Call("import clip.txt");
	EXPECT_TRUE(Contains(Out, "\"BloomIntensity\": 8")) << Out;
	Call("import clip.txt --upgrade");
	EXPECT_TRUE(Contains(Out, "\"BloomIntensity\": 1\n")) << Out;
	EXPECT_TRUE(Contains(Err, "note DD3026")) << Err;
}

TEST_F(SettingsVerb, ExportPrintsActors)
{
	Write("a.json", R"({"volumes": [{"name": "A", "bUnbound": true, "Settings": {"BloomIntensity": 1.2}},
		{"name": "B", "bUnbound": true, "Priority": 1, "Settings": {"FilmToe": 0.4}}]})");
	Call("export a.json");
	EXPECT_EQ(0, ExitCode) << Err;
	EXPECT_EQ(0u, Out.find("Begin Map\n"));
	EXPECT_TRUE(Contains(Out, "Settings=" + GSample)) << Out;
	EXPECT_TRUE(Contains(Out, "ActorLabel=\"B\"")) << Out;
}

TEST_F(SettingsVerb, ExportOfOneVolumeIsAStructWhenAskedFor)
{
	Write("a.json", R"({"volumes": [{"name": "A", "bUnbound": true, "Settings": {"BloomIntensity": 1.2}},
		{"name": "B", "bUnbound": true, "Priority": 1, "Settings": {"FilmToe": 0.4}}]})");
	Call("export a.json --volume A --struct");
	EXPECT_EQ(GSample + "\n", Out);
	Call("export a.json --struct");
	EXPECT_EQ(2, ExitCode);
	EXPECT_TRUE(Contains(Err, "--volume")) << Err;
}

TEST_F(SettingsVerb, ExportAtAPlaceIsWhatTheVolumesComeTo)
{
	// Halfway out of B's radius of 100: B weighs one half, 1 + (3 - 1) / 2 = 2.
	Write("a.json", R"({"volumes": [{"name": "A", "bUnbound": true, "Settings": {"BloomIntensity": 1}},
		{"name": "B", "bounds": {"min": [-10, -10, -10], "max": [10, 10, 10]}, "BlendRadius": 100, "Priority": 1,
		"Settings": {"BloomIntensity": 3}}]})");
	Call("export a.json --at 60,0,0 --struct");
	EXPECT_EQ(0, ExitCode) << Err;
	EXPECT_EQ("(bOverride_BloomIntensity=True,BloomIntensity=2.000000)\n", Out);
	Call("export a.json --at 60,0 --struct");
	EXPECT_EQ(2, ExitCode);
	EXPECT_TRUE(Contains(Err, "--at")) << Err;
}

TEST_F(SettingsVerb, ExportOfAnUnknownVolumeNamesTheNearest)
{
	Write("a.json", R"({"volumes": [{"name": "Stage", "bUnbound": true}]})");
	Call("export a.json --volume Stge");
	EXPECT_EQ(2, ExitCode);
	EXPECT_TRUE(Contains(Err, "did you mean Stage?")) << Err;
}

TEST_F(SettingsVerb, ExportOfABrokenConfigIsExitTwo)
{
	Write("a.json", R"({"volumes": [{"bUnbound": true, "Settings": {"BloomIntensty": 1}}]})");
	Call("export a.json");
	EXPECT_EQ(2, ExitCode);
	EXPECT_TRUE(Contains(Err, "DD1012")) << Err;
	EXPECT_EQ("", Out);
}

TEST_F(SettingsVerb, ExportedTextImportsToTheSameVolumes)
{
	Write("clip.txt", "Begin Actor Name=A\nBegin Object Name=\"BrushComponent0\"\nRelativeScale3D=(X=2)\nEnd Object\n"
					  "Settings=(bOverride_LensFlareTints=True,LensFlareTints[2]=(R=0.5),FilmToe=0.25,New=(1,2))\n"
					  "Priority=3\nEnd Actor\n");
	Call("import clip.txt");
	const std::string First = Out;
	Write("a.json", "{\"volumes\": " + First + "}");
	Call("export a.json --full");
	Write("again.txt", Out);
	Call("import again.txt");
	EXPECT_EQ(First, Out);
}

TEST_F(SettingsVerb, MisspeltSubVerbNamesTheNearest)
{
	Call("imprt clip.txt");
	EXPECT_EQ(2, ExitCode);
	EXPECT_TRUE(Contains(Err, "did you mean import?")) << Err;
}

TEST_F(SettingsVerb, MissingSubVerbIsAUsageError)
{
	Call("");
	EXPECT_EQ(2, ExitCode);
	EXPECT_TRUE(Contains(Err, "a verb is missing after settings")) << Err;
}

TEST_F(SettingsVerb, PlanPrintsThePlaces)
{
	Call("plan BloomToonIntensity");
	EXPECT_EQ(0, ExitCode) << Err;
	EXPECT_EQ(0u, Out.find("BloomToonIntensity: float, default 0.675f, Lens|Bloom, blends by Lerp\n"));
	EXPECT_TRUE(Contains(Out, "    LERP_PP(BloomToonIntensity);\n")) << Out;
}

TEST_F(SettingsVerb, PlanOfANewSettingNeedsItsType)
{
	Call("plan BloomTonIntensity");
	EXPECT_EQ(2, ExitCode);
	EXPECT_TRUE(Contains(Err, "did you mean BloomToonIntensity?")) << Err;
	EXPECT_TRUE(Contains(Err, "--type")) << Err;
	Call("plan BloomSparkle --type float --default 0.5 --doc 'Sparkles.'");
	EXPECT_EQ(0, ExitCode) << Err;
	EXPECT_TRUE(Contains(Out, "DRYDOCK_SETTING(float, BloomSparkle, 0.5f,")) << Out;
}

TEST_F(SettingsVerb, PlanAsJsonIsAnArrayOfPlaces)
{
	Call("plan BloomToonIntensity --json");
	EXPECT_EQ(0u, Out.find("[\n  {\n    \"file\": \"Engine/Source/")) << Out;
}

TEST_F(SettingsVerb, PlanOfSettingsAndPatternsShareOnePlanAndOneDiff)
{
	const ProgramTest::FProgramFolder Folder("settings_plan");
	const ProgramTest::FOutcome Plan =
		Folder.Call("settings plan BloomToonIntensity 'REDDof*Size' DuskTint --type color --diff a.diff");
	ASSERT_EQ(0, Plan.ExitCode) << Plan.Printed;
	const std::string SceneView = "Engine/Source/Runtime/Engine/Private/SceneView.cpp";
	const std::string Diff = Folder.Read("a.diff");
	for (const std::string Name : {"BloomToonIntensity", "REDDofNearBlurSize", "REDDofFarBlurSize", "DuskTint"})
	{
		EXPECT_THAT(Plan.Printed, testing::HasSubstr("LERP_PP(" + Name + ");"));
		EXPECT_THAT(Diff, testing::HasSubstr("\n+LERP_PP(" + Name + ");\n"));
	}
	EXPECT_THAT(Diff, testing::HasSubstr("\n--- " + SceneView + "\n+++ " + SceneView +
										 "\n@@ FSceneView::OverridePostProcessSettings @@\n+LERP_PP("));
	EXPECT_EQ(Diff.find("+++ " + SceneView), Diff.rfind("+++ " + SceneView));
	EXPECT_THAT(Diff, testing::HasSubstr("bMarked ? Color * ToonIntensity : Color;"));

	EXPECT_EQ(0, Folder.Call("settings plan BloomToonIntensity --form printed --diff b.diff").ExitCode);
	EXPECT_THAT(Folder.Read("b.diff"), testing::HasSubstr("? ToonIntensity : 1.0f;"));
	const ProgramTest::FOutcome Nothing = Folder.Call("settings plan 'Nowhere*'");
	EXPECT_EQ(2, Nothing.ExitCode);
	EXPECT_THAT(Nothing.Printed, testing::HasSubstr("no setting fits Nowhere*"));
}
