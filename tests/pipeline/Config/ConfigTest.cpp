// Reading configs: what is read, and each mistake with its number, place and suggestion. A little past 500 lines: one
// reader, one set of helpers, and each case a few lines.
#include <gtest/gtest.h>

#include "Config/ReadConfig.h"
#include "PostProcessSettingsReflection.h"
#include "SettingObjects.h"
#include "Text/ConfigErrors.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

using namespace Drydock;

namespace
{

struct FRead
{
	FConfig Config;
	std::vector<FDiagnostic> Diagnostics;
};

FRead Read(const std::string& Text)
{
	FRead Result;
	Result.Config = ReadConfig(Text, "configs/a.json", Result.Diagnostics);
	return Result;
}

FRead ReadClean(const std::string& Text)
{
	const FRead Result = Read(Text);
	EXPECT_TRUE(Result.Diagnostics.empty()) << Result.Diagnostics[0].ToString();
	return Result;
}

/** "code severity line:column pointer" of every message, and their texts. */
std::string Summary(const FDiagnostic& Diagnostic)
{
	return std::to_string(Diagnostic.Code) + (Diagnostic.Severity == ESeverity::Error ? " error " : " warning ") +
		   std::to_string(Diagnostic.Line) + ":" + std::to_string(Diagnostic.Column) + " " + Diagnostic.Where;
}

std::string Only(const std::string& Text)
{
	const FRead Result = Read(Text);
	EXPECT_EQ(1u, Result.Diagnostics.size()) << Text;
	return Result.Diagnostics.empty() ? "" : Summary(Result.Diagnostics[0]);
}

std::string OnlyText(const std::string& Text)
{
	const FRead Result = Read(Text);
	EXPECT_EQ(1u, Result.Diagnostics.size()) << Text;
	return Result.Diagnostics.empty() ? "" : Result.Diagnostics[0].Message;
}

/** A config with one unbound volume of these settings. The first one's key begins in column 46. */
std::string Volume(const std::string& Settings)
{
	return R"({"volumes": [{"bUnbound": true, "Settings": {)" + Settings + "}}]}";
}

const FPostProcessSettings& SettingsOf(const FRead& Result)
{
	return Result.Config.Volumes.at(0).Settings.Settings;
}

} // namespace

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

TEST(ConfigMistakes, RotationsNameTheirAngles)
{
	const auto Message = [](const std::string& Rotation)
	{
		return OnlyText(R"({"view": {"rotation": )" + Rotation + "}}");
	};
	EXPECT_EQ("a rotation has Pitch, Yaw and Roll, and no \"Yow\"; did you mean Yaw?", Message(R"({"Yow": 20})"));
	const std::string Expected =
		"expected an angle each: [pitch, yaw, roll] or {\"Pitch\": p, \"Yaw\": y, \"Roll\": r}";
	EXPECT_EQ(Expected + ", found an object", Message(R"({"Yaw": "20"})"));
	EXPECT_EQ(Expected + ", found an object", Message("{}"));
	EXPECT_EQ(Expected + ", found a number", Message("20"));
	EXPECT_EQ("1004 error 1:30 /view/rotation/Yaw", Only(R"({"view": {"rotation": {"Yaw":NaN}}})"));
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

TEST(ConfigMistakes, CurvesNameWhatIsWrongWithThem)
{
	const auto Message = [](const std::string& Curve)
	{
		const FRead Result = Read(Volume(R"("AutoExposureBiasCurve": )" + Curve));
		return Result.Diagnostics.at(0).Where.substr(std::string("/volumes/0/Settings/AutoExposureBiasCurve").size()) +
			   " " + Result.Diagnostics[0].Message;
	};
	EXPECT_EQ(" \"keys\" is missing: AutoExposureBiasCurve is a curve through [time, value]", Message("{}"));
	EXPECT_EQ("/keys \"keys\" of AutoExposureBiasCurve is an array of one [time, value] at least",
		Message(R"({"keys": []})"));
	EXPECT_EQ(
		"/keys/1 a key of AutoExposureBiasCurve is [time, value], two numbers", Message(R"({"keys": [[0, 1], [2]]})"));
	EXPECT_EQ("/keys/0 a key of AutoExposureBiasCurve is [time, value], two numbers",
		Message(R"({"keys": [[0, 1e39], [2, 1]]})"));
	EXPECT_EQ(
		"/keys/1 the times of the keys of AutoExposureBiasCurve must ascend", Message(R"({"keys": [[0, 1], [0, 2]]})"));
	EXPECT_EQ("/interp \"interp\" of AutoExposureBiasCurve is linear, constant or cubic; did you mean linear?",
		Message(R"({"keys": [[0, 1]], "interp": "linar"})"));
	EXPECT_EQ("/key a curve has \"keys\" and \"interp\", and no \"key\"; did you mean keys?",
		Message(R"({"key": [], "keys": [[0, 1]]})"));
	EXPECT_EQ(0u, Message("5").find(" AutoExposureBiasCurve is keys, {\"keys\": ")) << Message("5");
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

TEST(ConfigMistakes, FiveMistakesGiveFiveMessagesInTheOrderOfTheFile)
{
	const FRead Result = Read("{\n"
							  "  \"scen\": {},\n"
							  "  \"volumes\": [ { \"bUnbound\": 1, \"bounds\": {\"min\": [0,0,0], \"max\": [1,1,1]},\n"
							  "    \"Settings\": { \"BloomIntensty\": 1,\n"
							  "                  \"BloomThreshold\": 1e999 } } ],\n"
							  "  \"showFlags\": { \"Blom\": true }\n"
							  "}\n");
	std::vector<std::string> Errors;
	for (const FDiagnostic& Diagnostic : Result.Diagnostics)
	{
		if (Diagnostic.Severity == ESeverity::Error)
		{
			Errors.push_back(Summary(Diagnostic));
		}
	}
	const std::vector<std::string> Expected = {"1005 error 2:3 /scen", "1006 error 3:30 /volumes/0/bUnbound",
		"1012 error 4:19 /volumes/0/Settings/BloomIntensty", "1004 error 5:37 /volumes/0/Settings/BloomThreshold",
		"1014 error 6:18 /showFlags/Blom"};
	EXPECT_EQ(Expected, Errors);
}

TEST(ConfigMistakes, SyntaxErrorIsTheOnlyMessage)
{
	EXPECT_EQ("1001 error 1:14 ", Only(R"({"scen": {}, }})"));
}

TEST(ConfigMistakes, MessageReadsAsDesigned)
{
	const FRead Result = Read(Volume(R"("BloomIntensty": 1)"));
	EXPECT_EQ("configs/a.json:1:46: error DD1012 at /volumes/0/Settings/BloomIntensty: unknown setting; did you mean "
			  "BloomIntensity?",
		Result.Diagnostics.at(0).ToString());
}

TEST(ConfigMistakes, UnknownKeyNamesTheNearest)
{
	EXPECT_EQ("1005 error 1:2 /volume", Only(R"({"volume": []})"));
	EXPECT_EQ("unknown key \"volume\"; did you mean volumes?", OnlyText(R"({"volume": []})"));
}

TEST(ConfigMistakes, UnknownKeyFarFromAllNamesNone)
{
	EXPECT_EQ("unknown key \"zzzzzzzz\"", OnlyText(R"({"zzzzzzzz": []})"));
}

TEST(ConfigMistakes, DuplicateKeyIsReported)
{
	EXPECT_EQ("1003 error 1:17 /engine", Only(R"({"engine":"5.4","engine":"5.4"})"));
}

TEST(ConfigMistakes, RootMustBeAnObject)
{
	EXPECT_EQ("1006 error 1:1 ", Only("[]"));
}

TEST(ConfigMistakes, WrongTypesSayWhatWasExpected)
{
	EXPECT_EQ("expected an object, found an array", OnlyText(R"({"scene": []})"));
	EXPECT_EQ("expected a string, found a number", OnlyText(R"({"scene": {"file": 1}})"));
	EXPECT_EQ("expected an array of objects or \"fromScene\", found an object", OnlyText(R"({"volumes": {}})"));
	EXPECT_EQ("expected a number or \"auto\", found true or false", OnlyText(R"({"view": {"exposure": true}})"));
	EXPECT_EQ("expected an array of strings, found a string", OnlyText(R"({"outputs": {"dump": "x"}})"));
	EXPECT_EQ("expected a string, found a number", OnlyText(R"({"outputs": {"dump": [1]}})"));
	EXPECT_EQ("expected a number, found a string", OnlyText(R"({"scene": {"file": "a", "defaults": {"A": "1"}}})"));
}

TEST(ConfigMistakes, UnknownTextNamesTheAllowedOnes)
{
	EXPECT_EQ("1007 error 1:12 /engine", Only(R"({"engine": "4.27"})"));
	EXPECT_EQ("\"4.27\" is none of 5.1, 5.2, 5.3, 5.4, 5.5, 5.6, 5.7, 5.8", OnlyText(R"({"engine": "4.27"})"));
}

TEST(ConfigMistakes, MissingKeyIsReportedAtItsObject)
{
	EXPECT_EQ("1008 error 1:11 /scene", Only(R"({"scene": {}})"));
}

TEST(ConfigMistakes, ArraysOfAnotherLengthAreReported)
{
	EXPECT_EQ("1009 error 1:19 /view/rect", Only(R"({"view": {"rect": [0, 0, 1]}})"));
	EXPECT_EQ("1009 error 1:23 /view/location", Only(R"({"view": {"location": [0, 0]}})"));
}

TEST(ConfigMistakes, EmptyAndFractionalRectsMakeNoSense)
{
	EXPECT_EQ("1010 error 1:19 /view/rect", Only(R"({"view": {"rect": [5, 0, 5, 9]}})"));
	EXPECT_EQ("1010 error 1:20 /view/rect/0", Only(R"({"view": {"rect": [0.5, 0, 5, 9]}})"));
	EXPECT_EQ("1010 error 1:20 /view/rect/0", Only(R"({"view": {"rect": [-1, 0, 5, 9]}})"));
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

TEST(ConfigMistakes, ExposureMustBeAboveZero)
{
	EXPECT_EQ("1010 error 1:23 /view/exposure", Only(R"({"view": {"exposure": 0}})"));
	EXPECT_EQ("1010 error 1:26 /view/preExposure", Only(R"({"view": {"preExposure": 1e-60}})"));
}

TEST(ConfigMistakes, SettingOutsideItsRangeWarnsAndIsUsed)
{
	const std::string Text = Volume(R"("BloomIntensity": -2)");
	EXPECT_EQ("1011 warning 1:64 /volumes/0/Settings/BloomIntensity", Only(Text));
	EXPECT_EQ("BloomIntensity is outside its range, at least 0; it is used as it is", OnlyText(Text));
	EXPECT_EQ(-2.0f, SettingsOf(Read(Text)).BloomIntensity);
}

TEST(ConfigMistakes, SettingsOfWrongTypeSayWhatTheyAre)
{
	EXPECT_EQ("BloomIntensity is a number", OnlyText(Volume(R"("BloomIntensity": "1")")));
	EXPECT_EQ(
		"BloomMethod is one of BM_SOG, BM_FFT; did you mean BM_FFT?", OnlyText(Volume(R"("BloomMethod": "BM_FTT")")));
	EXPECT_EQ("BloomMethod is one of BM_SOG, BM_FFT", OnlyText(Volume(R"("BloomMethod": 2)")));
	EXPECT_EQ("Bloom1Tint is a colour: [R, G, B], [R, G, B, A] or {\"R\": .., \"G\": .., \"B\": .., \"A\": ..}",
		OnlyText(Volume(R"("Bloom1Tint": [1, 2])")));
}

TEST(ConfigMistakes, NumberTooLargeForAFloatIsNotFinite)
{
	EXPECT_EQ("1004 error 1:64 /volumes/0/Settings/BloomIntensity", Only(Volume(R"("BloomIntensity": 1e39)")));
}

TEST(ConfigMistakes, NotFiniteInsideAColourIsReportedOnce)
{
	EXPECT_EQ("1004 error 1:64 /volumes/0/Settings/Bloom1Tint/1", Only(Volume(R"("Bloom1Tint": [1, NaN, 1])")));
}

TEST(ConfigMistakes, UnknownVariableNamesTheNearest)
{
	EXPECT_EQ("1013 error 1:12 /cvars/r.ExposureOfset", Only(R"({"cvars": {"r.ExposureOfset": 1}})"));
	EXPECT_EQ("unknown console variable r.ExposureOfset; did you mean r.ExposureOffset?",
		OnlyText(R"({"cvars": {"r.ExposureOfset": 1}})"));
}

TEST(ConfigMistakes, VariableOfAnotherTypeIsReported)
{
	EXPECT_EQ(
		"r.Tonemapper.Quality is a whole number, not \"2.5\"", OnlyText(R"({"cvars": {"r.Tonemapper.Quality": 2.5}})"));
	EXPECT_EQ("r.ExposureOffset is a number, not \"bright\"", OnlyText(R"({"cvars": {"r.ExposureOffset": "bright"}})"));
	EXPECT_EQ("1006 error 1:32 /cvars/r.ExposureOffset", Only(R"({"cvars": {"r.ExposureOffset": [1]}})"));
}

TEST(ConfigMistakes, UnknownShowFlagNamesTheNearest)
{
	EXPECT_EQ("unknown show flag; did you mean Vignette?", OnlyText(R"({"showFlags": {"Vignete": true}})"));
	EXPECT_EQ("1006 error 1:25 /showFlags/Bloom", Only(R"({"showFlags": {"Bloom": 1}})"));
}

TEST(Config, VolumesMayComeFromTheScene)
{
	EXPECT_TRUE(ReadClean(R"({"volumes": "fromScene"})").Config.VolumesFromScene.Value);
	EXPECT_FALSE(ReadClean(R"({"volumes": []})").Config.VolumesFromScene.Value);
}

TEST(ConfigMistakes, StudyAndItsAxesAreChecked)
{
	EXPECT_EQ("1008 error 1:11 /study", Only(R"({"study": {"repetitions": 7}})"));
	EXPECT_EQ("unknown key \"repetition\"; did you mean repetitions?",
		OnlyText(R"({"study": {"axes": [], "repetition": 7}})"));
	EXPECT_EQ("1008 error 1:21 /study/axes/0", Only(R"({"study": {"axes": [{"name": "r.BloomQuality"}]}})"));
}

TEST(ConfigMistakes, NegativeRadiusOfABoundedVolumeWarns)
{
	EXPECT_EQ("1011 warning 1:94 /volumes/0/BlendRadius",
		Only(R"({"volumes": [{"bounds": {"type": "sphere", "center": [0, 0, 0], "radius": 1}, "BlendRadius": -5}]})"));
	ReadClean(R"({"volumes": [{"bUnbound": true, "BlendRadius": -5}]})");
}

TEST(ConfigMistakes, ConvexWithoutPointsIsAnError)
{
	EXPECT_EQ(
		"1010 error 1:25 /volumes/0/bounds", Only(R"({"volumes": [{"bounds": {"type": "convex", "points": []}}]})"));
}

TEST(ConfigMistakes, OverrideBitOffWarnsWhereverItStands)
{
	const std::string Text = Volume(R"("bOverride_BloomIntensity": false, "BloomIntensity": 2)");
	EXPECT_EQ("1016 warning 1:46 /volumes/0/Settings/bOverride_BloomIntensity", Only(Text));
	EXPECT_FALSE(SettingsOf(Read(Text)).bOverride_BloomIntensity);
	EXPECT_EQ(2.0f, SettingsOf(Read(Text)).BloomIntensity);
}

TEST(ConfigMistakes, OverrideOfAnUnknownSettingNamesTheNearest)
{
	EXPECT_EQ("unknown setting; did you mean bOverride_BloomIntensity?",
		OnlyText(Volume(R"("bOverride_BloomIntensty": true)")));
}

TEST(ConfigMistakes, WeightOutsideZeroToOneIsClamped)
{
	const std::string Text = R"({"camera": {"PostProcessBlendWeight": 1.5}})";
	EXPECT_EQ("1018 warning 1:39 /camera/PostProcessBlendWeight", Only(Text));
	EXPECT_EQ(1.0, Read(Text).Config.Camera.PostProcessBlendWeight);
}

TEST(ConfigMistakes, VolumeWithoutBoundsIsAnError)
{
	EXPECT_EQ("1019 error 1:14 /volumes/0", Only(R"({"volumes": [{"Priority": 1}]})"));
}

TEST(ConfigMistakes, IncompleteBoundsNameWhatIsMissing)
{
	EXPECT_EQ(
		"a sphere needs \"radius\"", OnlyText(R"({"volumes": [{"bounds": {"type": "sphere", "center": [0, 0, 0]}}]})"));
}

TEST(ConfigMistakes, BoundsUpsideDownAreRefused)
{
	EXPECT_EQ(
		"min lies above max in Y", OnlyText(R"({"volumes": [{"bounds": {"min": [0, 5, 0], "max": [1, 1, 1]}}]})"));
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
	EXPECT_EQ("r.Bloom.ApplyLocalExposure is true or false, not \"maybe\"",
		OnlyText(R"({"cvars": {"r.Bloom.ApplyLocalExposure": "maybe"}})"));
	EXPECT_EQ("r.BloomQuality is a whole number, not \"4294967296\"",
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
