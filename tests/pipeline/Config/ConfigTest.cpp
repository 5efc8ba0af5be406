// Reading configs: what is read of each object.
#include "ConfigTestRead.h"
#include "PostProcessSettingsReflection.h"
#include "SettingObjects.h"
#include "Text/ConfigErrors.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

using namespace Drydock;
using namespace ConfigTest;

TEST(Config, EmptyObjectIsAllDefaults)
{
	const FRead Result = ReadClean("{}");
	EXPECT_EQ("5.4", Result.Config.Engine.Value);
	EXPECT_EQ(1.0, Result.Config.View.Exposure.Value);
	EXPECT_EQ(1.0, Result.Config.View.PreExposure.Value);
	EXPECT_FALSE(Result.Config.Scene.File.IsSet());
}

TEST(Config, ReadsTheSceneAndResolvesItBesideTheConfig)
{
	const FRead Result = ReadClean(R"({"scene": {"file": "scenes/a.exr", "screenPercentage": 100}})");
	EXPECT_EQ("scenes/a.exr", Result.Config.Scene.File.Value);
	EXPECT_EQ("configs/scenes/a.exr", Result.Config.Resolve(Result.Config.Scene.File.Value));
	EXPECT_EQ("/abs/a.exr", Result.Config.Resolve("/abs/a.exr"));
}

TEST(Config, ScreenPercentageIsAboveZeroAndAtMostFourHundred)
{
	EXPECT_EQ(50.0, ReadClean(R"({"scene": {"file": "a", "screenPercentage": 50}})").Config.Scene.ScreenPercentage);
	for (const char* Value : {"0", "-50", "401"})
	{
		EXPECT_EQ("screenPercentage must be above 0 and at most 400",
			OnlyText(std::string(R"({"scene": {"file": "a", "screenPercentage": )") + Value + "}}"));
	}
}

TEST(Config, ReadsChannelsAndDefaults)
{
	const FRead Result = ReadClean(R"({"scene": {"file": "a", "channels": {"R": "X.R"}, "defaults": {"A": 0.5}}})");
	EXPECT_EQ("X.R", Result.Config.Scene.Channels.at("R").Value);
	EXPECT_EQ(0.5, Result.Config.Scene.Defaults.at("A").Value);
}

TEST(Config, ReadsTheView)
{
	const FRead Result =
		ReadClean(R"({"view": {"location": [1, 2, 3], "rect": [0, 1, 20, 30], "exposure": 2, "preExposure": 0.5}})");
	EXPECT_EQ((FConfigVector{1, 2, 3}), Result.Config.View.Location.Value);
	EXPECT_EQ((std::array<int, 4>{0, 1, 20, 30}), Result.Config.View.Rect.Value);
	EXPECT_EQ(2.0, Result.Config.View.Exposure.Value);
	EXPECT_EQ(0.5, Result.Config.View.PreExposure.Value);
}

TEST(Config, ReadsTheCamera)
{
	const FRead Result = ReadClean(R"({"view": {"rotation": [-10, 20, 5], "fov": 60}})");
	EXPECT_EQ((FConfigVector{-10, 20, 5}), Result.Config.View.Rotation.Value);
	EXPECT_EQ(60.0, Result.Config.View.Fov.Value);
	EXPECT_EQ("1010 error 1:18 /view/fov", Only(R"({"view": {"fov": 180}})"));
}

TEST(Config, ReadsTheUnitsOfTheScene)
{
	const FSceneUnits Default = ReadClean(R"({"scene": {"file": "a"}})").Config.Scene.Units;
	EXPECT_FALSE(Default.bDepthInCentimetres || Default.bVelocityIsNdc || Default.bNormalIsLeftHanded);
	const FSceneUnits Units =
		ReadClean(R"({"scene": {"file": "a", "units": {"depth": "cm", "velocity": "ndc", "normal": "leftHanded"}}})")
			.Config.Scene.Units;
	EXPECT_TRUE(Units.bDepthInCentimetres && Units.bVelocityIsNdc && Units.bNormalIsLeftHanded);
	EXPECT_NE("", Only(R"({"scene": {"file": "a", "units": {"depth": "inch"}}})"));
}

TEST(Config, VectorsMayBeObjects)
{
	EXPECT_EQ((FConfigVector{1, 2, 3}),
		ReadClean(R"({"view": {"location": {"Z": 3, "X": 1, "Y": 2}}})").Config.View.Location.Value);
}

TEST(Config, RotationsMayBeRotators)
{
	const auto RotationOf = [](const std::string& Rotation)
	{
		const FRead Result = ReadClean(R"({"view": {"rotation": )" + Rotation + R"(}, "volumes": [{"bounds":
			{"type": "box", "center": [0, 0, 0], "extent": [1, 1, 1], "rotation": )" +
									   Rotation + "}}]}");
		EXPECT_EQ(Result.Config.View.Rotation.Value, Result.Config.Volumes.at(0).Bounds->Rotation);
		return Result.Config.View.Rotation.Value;
	};
	EXPECT_EQ((FConfigVector{10, 20, 30}), RotationOf("[10, 20, 30]"));
	EXPECT_EQ((FConfigVector{10, 20, 30}), RotationOf(R"({"Yaw": 20, "Roll": 30, "Pitch": 10})"));
	EXPECT_EQ((FConfigVector{0, 20, 0}), RotationOf(R"({"Yaw": 20})"));
	EXPECT_EQ((FConfigVector{10, 20, 30}), RotationOf(R"({"X": 10, "Y": 20, "Z": 30})"));
}

TEST(Config, CurvesMayBeGivenByTheirKeys)
{
	const auto PathOf = [](const std::string& Curve)
	{
		const FRead Result = Read(Volume(R"("AutoExposureBiasCurve": )" + Curve));
		EXPECT_FALSE(HasErrors(Result.Diagnostics));
		return GetObjectPath(Result.Config.Volumes.at(0).Settings.Settings.AutoExposureBiasCurve);
	};
	EXPECT_EQ("linear(-4 1, 0 0, 4 -0.5)", PathOf(R"({"keys": [[-4, 1], [0, 0], [4, -0.5]]})"));
	EXPECT_EQ("cubic(1 2)", PathOf(R"({"interp": "cubic", "keys": [[1, 2]]})"));
	EXPECT_EQ("/Game/C.C", PathOf(R"("/Game/C.C")"));
	EXPECT_EQ("None", PathOf("null"));
}

TEST(Config, ReadsAnUnboundVolume)
{
	const FRead Result = ReadClean(
		R"({"volumes": [{"name": "Base", "bUnbound": true, "Priority": 3, "BlendRadius": 50, "BlendWeight": 0.5}]})");
	const FConfigVolume& Base = Result.Config.Volumes.at(0);
	EXPECT_EQ("Base", Base.Name);
	EXPECT_TRUE(Base.bUnbound && Base.bEnabled);
	EXPECT_EQ(3.0, Base.Priority);
	EXPECT_EQ(50.0, Base.BlendRadius);
	EXPECT_EQ(0.5, Base.BlendWeight);
}

TEST(Config, NamingASettingSetsItsOverrideBit)
{
	const FRead Result = ReadClean(Volume(R"("BloomIntensity": 1.25)"));
	EXPECT_EQ(1.25f, SettingsOf(Result).BloomIntensity);
	EXPECT_TRUE(SettingsOf(Result).bOverride_BloomIntensity);
	EXPECT_FALSE(SettingsOf(Result).bOverride_BloomThreshold);
}

TEST(Config, SettingsOfEveryTypeAreRead)
{
	const FRead Result = ReadClean(Volume(
		R"("BloomMethod": "BM_SOG", "Bloom1Tint": [0.5, 0.25, 1], "SceneColorTint": {"R": 1, "G": 2, "B": 3, "A": 4})"));
	EXPECT_EQ(FLinearColor(0.5f, 0.25f, 1.0f, 1.0f), SettingsOf(Result).Bloom1Tint);
	EXPECT_EQ(FLinearColor(1.0f, 2.0f, 3.0f, 4.0f), SettingsOf(Result).SceneColorTint);
	EXPECT_TRUE(SettingsOf(Result).bOverride_BloomMethod);
}

TEST(Config, EnumsAcceptNumbers)
{
	EXPECT_EQ(BM_FFT, SettingsOf(Read(Volume(R"("BloomMethod": 1)"))).BloomMethod);
}

TEST(Config, ReadsCameraVariablesFlagsAndDumps)
{
	const FRead Result = ReadClean(R"({"camera": {"PostProcessBlendWeight": 0.25, "Settings": {"FilmToe": 0.5}},
		"cvars": {"r.ExposureOffset": 0.5}, "showFlags": {"Bloom": false}, "outputs": {"dump": ["*Blur*"]}})");
	EXPECT_EQ(0.25, Result.Config.Camera.PostProcessBlendWeight);
	EXPECT_EQ(0.5f, Result.Config.Camera.Settings.Settings.FilmToe);
	EXPECT_EQ("0.5", Result.Config.Variables.at(0).Value);
	EXPECT_FALSE(Result.Config.ShowFlags.at(0).bValue);
	EXPECT_EQ("*Blur*", Result.Config.Dump.at(0).Value);
}

TEST(Config, BoundsOfEveryShapeAreRead)
{
	const FRead Result = Read(R"({"volumes": [
		{"bounds": {"min": [0, 0, 0], "max": [2, 4, 6]}, "Priority": 0},
		{"bounds": {"type": "box", "center": [1, 1, 1], "extent": [2, 2, 2], "rotation": [0, 90, 0]}, "Priority": 1},
		{"bounds": {"type": "sphere", "center": [1, 1, 1], "radius": 5}, "Priority": 2},
		{"bounds": {"type": "capsule", "center": [1, 1, 1], "radius": 5, "halfHeight": 9}, "Priority": 3},
		{"bounds": {"type": "convex", "points": [[0, 0, 0], [1, 0, 0]]}, "Priority": 4}]})");
	ASSERT_FALSE(HasErrors(Result.Diagnostics));
	const std::vector<FConfigVolume>& Volumes = Result.Config.Volumes;
	EXPECT_EQ((FConfigVector{1, 2, 3}), Volumes[0].Bounds->Center);
	EXPECT_EQ((FConfigVector{1, 2, 3}), Volumes[0].Bounds->Extent);
	EXPECT_EQ(90.0, Volumes[1].Bounds->Rotation[1]);
	EXPECT_EQ(EConfigShape::Sphere, Volumes[2].Bounds->Shape);
	EXPECT_EQ(9.0, Volumes[3].Bounds->HalfHeight);
	EXPECT_EQ(2u, Volumes[4].Bounds->Points.size());
}

TEST(Config, ExposureIsANumberOrAutomatic)
{
	EXPECT_TRUE(ReadClean(R"({"view": {"exposure": "auto"}})").Config.View.bAutoExposure);
	EXPECT_FALSE(ReadClean(R"({"view": {"exposure": 1}})").Config.View.bAutoExposure);
	const FConfig Config =
		ReadClean(R"({"views": [{"rect": [0, 0, 1, 1], "exposure": "auto"}, {"rect": [1, 0, 2, 1]}]})").Config;
	EXPECT_TRUE(Config.Views.at(0).bAutoExposure);
	EXPECT_FALSE(Config.Views.at(1).bAutoExposure);
}

TEST(Config, VolumesMayComeFromTheScene)
{
	EXPECT_TRUE(ReadClean(R"({"volumes": "fromScene"})").Config.VolumesFromScene.Value);
	EXPECT_FALSE(ReadClean(R"({"volumes": []})").Config.VolumesFromScene.Value);
}

TEST(ConfigArguments, SettingOfTheCommandLineIsOverridden)
{
	FRead Result = Read("{}");
	AddSettingArgument(Result.Config, "BloomIntensity=3", Result.Diagnostics);
	EXPECT_TRUE(Result.Diagnostics.empty());
	EXPECT_EQ(3.0f, Result.Config.CommandLine.Settings.BloomIntensity);
	EXPECT_TRUE(Result.Config.CommandLine.Settings.bOverride_BloomIntensity);
}

TEST(ConfigArguments, MistakesAreNamed)
{
	FRead Result = Read("{}");
	AddSettingArgument(Result.Config, "BloomIntensty=3", Result.Diagnostics);
	AddSettingArgument(Result.Config, "BloomIntensity", Result.Diagnostics);
	AddSettingArgument(Result.Config, "BloomIntensity=a", Result.Diagnostics);
	AddSettingArgument(Result.Config, "BloomIntensity=-1", Result.Diagnostics);
	AddVariableArgument(Result.Config, "r.ExposureOfset=1", Result.Diagnostics);
	AddVariableArgument(Result.Config, "=1", Result.Diagnostics);
	const std::vector<std::string> Expected = {"1012 error 0:0 --pp", "1020 error 0:0 --pp", "1006 error 0:0 --pp",
		"1011 warning 0:0 --pp", "1013 error 0:0 --set", "1020 error 0:0 --set"};
	std::vector<std::string> Found;
	for (const FDiagnostic& Diagnostic : Result.Diagnostics)
	{
		Found.push_back(Summary(Diagnostic));
	}
	EXPECT_EQ(Expected, Found);
}

TEST(ConfigArguments, ValueMayContainEqualsSigns)
{
	FRead Result = Read("{}");
	AddSettingArgument(Result.Config, "SceneColorTint=(R=1,G=0.5,B=0,A=1)", Result.Diagnostics);
	EXPECT_EQ(FLinearColor(1.0f, 0.5f, 0.0f, 1.0f), Result.Config.CommandLine.Settings.SceneColorTint);
}

TEST(ConfigFile, MissingFileIsDD5001WithExitCodeThree)
{
	std::vector<FDiagnostic> Diagnostics;
	try
	{
		LoadConfig("/nowhere/a.json", Diagnostics);
		FAIL();
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(ExitFiles, Error.GetExitCode());
		EXPECT_EQ(ErrorFileMissing, Error.GetDiagnostics().at(0).Code);
	}
}

TEST(ConfigFile, EveryShippedConfigIsReadWithoutErrors)
{
	int NumRead = 0;
	for (const auto& Entry : std::filesystem::directory_iterator(DRYDOCK_TEST_SOURCE_DIR "/configs"))
	{
		if (Entry.path().extension() == ".json")
		{
			std::vector<FDiagnostic> Diagnostics;
			LoadConfig(Entry.path().string(), Diagnostics);
			EXPECT_TRUE(Diagnostics.empty()) << Diagnostics[0].ToString();
			++NumRead;
		}
	}
	EXPECT_GE(NumRead, 4);
}

TEST(ConfigArguments, ExecIsWhatAConsoleTakes)
{
	FRead Result = Read("{}");
	AddExecArgument(
		Result.Config, "r.BloomQuality 3, r.ExposureOffset=0.5,r.Tonemapper.Quality , ", Result.Diagnostics);
	EXPECT_TRUE(Result.Diagnostics.empty());
	ASSERT_EQ(3u, Result.Config.Variables.size());
	EXPECT_EQ("3", Result.Config.Variables[0].Value);
	EXPECT_EQ("r.ExposureOffset", Result.Config.Variables[1].Name);
	EXPECT_EQ("0.5", Result.Config.Variables[1].Value);
	EXPECT_EQ("", Result.Config.Variables[2].Value);
	EXPECT_EQ(EVariableSource::Console, Result.Config.Variables[2].Source);
}

TEST(ConfigArguments, ExecMistakesAreNamed)
{
	FRead Result = Read("{}");
	AddExecArgument(Result.Config, "r.BloomQualty 3, r.BloomQuality high", Result.Diagnostics);
	AddExecArgument(Result.Config, " , ", Result.Diagnostics);
	ASSERT_EQ(3u, Result.Diagnostics.size());
	EXPECT_EQ("1013 error 0:0 --exec", Summary(Result.Diagnostics[0]));
	EXPECT_EQ("unknown console variable r.BloomQualty; did you mean r.BloomQuality?", Result.Diagnostics[0].Message);
	EXPECT_EQ("1006 error 0:0 --exec", Summary(Result.Diagnostics[1]));
	EXPECT_EQ("1020 error 0:0 --exec", Summary(Result.Diagnostics[2]));
}

TEST(Config, VariablesIgnoreCase)
{
	EXPECT_TRUE(Read(R"({"cvars": {"R.BLOOMQUALITY": 3}})").Diagnostics.empty());
}

TEST(Config, BoolAndHugeVariablesAreChecked)
{
	EXPECT_EQ("r.Bloom.ApplyLocalExposure must be true or false, but is \"maybe\"",
		OnlyText(R"({"cvars": {"r.Bloom.ApplyLocalExposure": "maybe"}})"));
	EXPECT_EQ("r.BloomQuality must be a whole number, but is \"4294967296\"",
		OnlyText(R"({"cvars": {"r.BloomQuality": 4294967296}})"));
}

TEST(Config, ScalabilityLevelsAreZeroToFour)
{
	EXPECT_TRUE(Read(R"({"cvars": {"sg.PostProcessQuality": 4}})").Diagnostics.empty());
	EXPECT_EQ("1010 error 1:12 /cvars/sg.PostProcessQuality", Only(R"({"cvars": {"sg.PostProcessQuality": 5}})"));
}

TEST(Config, VariablesThatNothingReadsWarn)
{
	EXPECT_EQ("1022 warning 1:12 /cvars/r.DOF.Gather.RingCount", Only(R"({"cvars": {"r.DOF.Gather.RingCount": 5}})"));
}
