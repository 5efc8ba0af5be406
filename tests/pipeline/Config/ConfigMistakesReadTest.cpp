// Reading configs: each mistake with its number, place and suggestion.
#include "ConfigTestRead.h"
#include "PostProcessSettingsReflection.h"
#include "SettingObjects.h"
#include "Text/ConfigErrors.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

using namespace Drydock;
using namespace ConfigTest;

TEST(ConfigMistakes, RotationsNameTheirAngles)
{
	const auto Message = [](const std::string& Rotation)
	{
		return OnlyText(R"({"view": {"rotation": )" + Rotation + "}}");
	};
	EXPECT_EQ("a rotation has only Pitch, Yaw and Roll, not \"Yow\"; did you mean Yaw?", Message(R"({"Yow": 20})"));
	const std::string Expected =
		"expected an angle each: [pitch, yaw, roll] or {\"Pitch\": p, \"Yaw\": y, \"Roll\": r}";
	EXPECT_EQ(Expected + ", found an object", Message(R"({"Yaw": "20"})"));
	EXPECT_EQ(Expected + ", found an object", Message("{}"));
	EXPECT_EQ(Expected + ", found a number", Message("20"));
	EXPECT_EQ("1004 error 1:30 /view/rotation/Yaw", Only(R"({"view": {"rotation": {"Yaw":NaN}}})"));
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
	EXPECT_EQ("/keys \"keys\" of AutoExposureBiasCurve must be an array of at least one [time, value]",
		Message(R"({"keys": []})"));
	EXPECT_EQ("/keys/1 a key of AutoExposureBiasCurve must be [time, value], two numbers",
		Message(R"({"keys": [[0, 1], [2]]})"));
	EXPECT_EQ("/keys/0 a key of AutoExposureBiasCurve must be [time, value], two numbers",
		Message(R"({"keys": [[0, 1e39], [2, 1]]})"));
	EXPECT_EQ(
		"/keys/1 the times of the keys of AutoExposureBiasCurve must ascend", Message(R"({"keys": [[0, 1], [0, 2]]})"));
	EXPECT_EQ("/interp \"interp\" of AutoExposureBiasCurve must be linear, constant or cubic; did you mean linear?",
		Message(R"({"keys": [[0, 1]], "interp": "linar"})"));
	EXPECT_EQ("/key a curve has only \"keys\" and \"interp\", not \"key\"; did you mean keys?",
		Message(R"({"key": [], "keys": [[0, 1]]})"));
	EXPECT_EQ(0u, Message("5").find(" AutoExposureBiasCurve must be keys, {\"keys\": ")) << Message("5");
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
	EXPECT_EQ("1001 error 1:12 ", Only(R"({"scen": {}, }})"));
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
	EXPECT_EQ("\"4.27\" is not one of 5.1, 5.2, 5.3, 5.4, 5.5, 5.6, 5.7, 5.8", OnlyText(R"({"engine": "4.27"})"));
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
	EXPECT_EQ("BloomIntensity must be a number", OnlyText(Volume(R"("BloomIntensity": "1")")));
	EXPECT_EQ("BloomMethod must be one of BM_SOG, BM_FFT; did you mean BM_FFT?",
		OnlyText(Volume(R"("BloomMethod": "BM_FTT")")));
	EXPECT_EQ("BloomMethod must be one of BM_SOG, BM_FFT", OnlyText(Volume(R"("BloomMethod": 2)")));
	EXPECT_EQ("Bloom1Tint must be a colour: [R, G, B], [R, G, B, A] or {\"R\": .., \"G\": .., \"B\": .., \"A\": ..}",
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
	EXPECT_EQ("r.Tonemapper.Quality must be a whole number, but is \"2.5\"",
		OnlyText(R"({"cvars": {"r.Tonemapper.Quality": 2.5}})"));
	EXPECT_EQ("r.ExposureOffset must be a number, but is \"bright\"",
		OnlyText(R"({"cvars": {"r.ExposureOffset": "bright"}})"));
	EXPECT_EQ("1006 error 1:32 /cvars/r.ExposureOffset", Only(R"({"cvars": {"r.ExposureOffset": [1]}})"));
}

TEST(ConfigMistakes, UnknownShowFlagNamesTheNearest)
{
	EXPECT_EQ("unknown show flag; did you mean Vignette?", OnlyText(R"({"showFlags": {"Vignete": true}})"));
	EXPECT_EQ("1006 error 1:25 /showFlags/Bloom", Only(R"({"showFlags": {"Bloom": 1}})"));
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
	EXPECT_EQ("min must not be above max in Y",
		OnlyText(R"({"volumes": [{"bounds": {"min": [0, 5, 0], "max": [1, 1, 1]}}]})"));
}
