// Malformed engine text: one clear message each, with its place and what was expected.
#include <gtest/gtest.h>

#include "PostProcessSettingsTextVolume.h"

using namespace Drydock;

namespace
{

struct FMistake
{
	const char* Name;
	const char* Text;
	const char* Message; // after "clip.txt:"
};

void PrintTo(const FMistake& Mistake, std::ostream* Stream)
{
	*Stream << Mistake.Name;
}

class SettingsTextMistake : public testing::TestWithParam<FMistake>
{
};

const FMistake GMistakes[] = {
	{"Empty", "",
		"1:1: error DD3009: there are no post-process settings in this text: expected (NAME=VALUE,..) or an actor with "
		"Settings=(..)"},
	{"OnlySpace", "\n \n",
		"3:1: error DD3009: there are no post-process settings in this text: expected (NAME=VALUE,..) or an actor with "
		"Settings=(..)"},
	{"NeverClosed", "\n(FilmToe=0.55", "2:1: error DD3001: this ( is never closed"},
	{"NeverClosedAfterComma", "(FilmToe=0.55,", "1:1: error DD3001: this ( is never closed"},
	{"InnerNeverClosed", "(SceneColorTint=(R=1,G=1", "1:17: error DD3001: this ( is never closed"},
	{"TrailingComma", "(FilmToe=0.55,)", "1:15: error DD3001: expected NAME=VALUE, found ')'"},
	{"LeadingComma", "(,FilmToe=0.55)", "1:2: error DD3001: expected NAME=VALUE, found ','"},
	{"NoComma", "(FilmToe=0.55 FilmSlope=0.88)",
		"1:15: error DD3001: expected , or ) after the value of FilmToe, found FilmSlope"},
	{"TwoEquals", "(FilmToe==0.55)", "1:10: error DD3001: expected a value, found '='"},
	{"NameOnly", "(FilmToe)", "1:2: error DD3001: expected NAME=VALUE, found FilmToe"},
	{"NoName", "(=1)", "1:2: error DD3001: expected NAME=VALUE, found '='"},
	{"NumberAsName", "(12=1)", "1:2: error DD3001: expected a name before '=', found 12"},
	{"ValueEnds", "(FilmToe=", "1:2: error DD3001: FilmToe has no value: the text ends here"},
	{"TextBehind", "(FilmToe=0.55) x", "1:16: error DD3001: expected the end of the text after the closing ), found x"},
	{"Json", "{\"FilmToe\": 0.5}", "1:1: error DD3001: expected (NAME=VALUE,..), Settings=(..) or Begin Map, found {"},
	{"Prose", "some text", "1:1: error DD3001: expected (NAME=VALUE,..), Settings=(..) or Begin Map, found some"},
	{"OpenString", "(New=\"abc,\nFilmToe=0.5)", "1:6: error DD3001: this \" has no closing \" on its line"},
	{"OpenObject", "(BloomDirtMask=Texture2D'/Game/A.A)", "1:25: error DD3001: this ' has no closing ' on its line"},
	{"OpenCall", "(New=INVTEXT(\"a)\"", "1:13: error DD3001: this ( is not closed on its line"},
	{"BadIndex", "(LensFlareTints[x]=(R=1))", "1:16: error DD3001: expected an index such as [0] after LensFlareTints"},
	{"NegativeIndex", "(LensFlareTints[-1]=(R=1))",
		"1:16: error DD3001: expected an index such as [0] after LensFlareTints"},
	{"IndexWithoutValue", "(LensFlareTints[0])", "1:19: error DD3001: expected = after LensFlareTints[0], found ')'"},
	{"ControlByte", "(FilmToe=\x01)", "1:10: error DD3004 at FilmToe: expected a number, found ?"},
	{"GivenTwice", "(FilmToe=0.55,filmtoe=0.55)",
		"1:15: error DD3003 at FilmToe: FilmToe is given twice, first at 1:2"},
	{"UnknownGivenTwice", "(New=1,new=2)", "1:8: error DD3003 at new: new is given twice, first at 1:2"},
	{"TextForNumber", "(FilmToe=high)", "1:10: error DD3004 at FilmToe: expected a number, found high"},
	{"BoolForNumber", "(FilmToe=True)", "1:10: error DD3004 at FilmToe: expected a number, found True"},
	{"StructForNumber", "(FilmToe=(X=1))", "1:10: error DD3004 at FilmToe: expected a number, found a struct"},
	{"NothingForNumber", "(FilmToe=,FilmSlope=0.88)",
		"1:10: error DD3004 at FilmToe: expected a number, found nothing"},
	{"SuffixedNumber", "(FilmToe=0.5f)", "1:10: error DD3004 at FilmToe: expected a number, found 0.5f"},
	{"NotANumber", "(FilmToe=-nan(ind))", "1:10: error DD3006 at FilmToe: expected a finite number, found -nan(ind)"},
	{"Infinity", "(FilmToe=inf)", "1:10: error DD3006 at FilmToe: expected a finite number, found inf"},
	{"BeyondFloat", "(FilmToe=1e39)", "1:10: error DD3006 at FilmToe: expected a finite number, found 1e39"},
	{"BeyondDouble", "(BloomConvolutionCenterUV=(X=1e999))",
		"1:30: error DD3006 at BloomConvolutionCenterUV: expected a finite number, found 1e999"},
	{"FractionForInt", "(DepthOfFieldBladeCount=5.5)",
		"1:25: error DD3004 at DepthOfFieldBladeCount: expected a whole number, found 5.5"},
	{"NumberForBit", "(bOverride_FilmToe=2)",
		"1:20: error DD3004 at bOverride_FilmToe: expected True or False, found 2"},
	{"WordForBit", "(bOverride_FilmToe=yes)",
		"1:20: error DD3004 at bOverride_FilmToe: expected True or False, found yes"},
	{"MisspeltEnum", "(BloomMethod=BM_FTF)",
		"1:14: error DD3005 at BloomMethod: expected one of BM_SOG, BM_FFT, found BM_FTF; did you mean BM_FFT?"},
	{"NumberBeyondEnum", "(BloomMethod=2)",
		"1:14: error DD3004 at BloomMethod: expected one of BM_SOG, BM_FFT, found 2"},
	{"NumberForColour", "(SceneColorTint=1)",
		"1:17: error DD3004 at SceneColorTint: expected (R=..,G=..,B=..,A=..), found 1"},
	{"VectorForColour", "(SceneColorTint=(X=1))",
		"1:18: error DD3005 at SceneColorTint: expected R, G, B, A in (R=..,G=..,B=..,A=..), found X"},
	{"ArrayForColour", "(SceneColorTint=(1,1,1,1))",
		"1:18: error DD3005 at SceneColorTint: expected R, G, B, A in (R=..,G=..,B=..,A=..), found 1"},
	{"WordInColour", "(SceneColorTint=(R=red))", "1:20: error DD3004 at SceneColorTint: expected a number, found red"},
	{"NumberForObject", "(BloomDirtMask=5)",
		"1:16: error DD3004 at BloomDirtMask: expected an object such as "
		"/Script/Engine.Texture2D'/Game/Folder/Name.Name', or None, found 5"},
	{"IndexOnNoArray", "(FilmToe[1]=0.5)",
		"1:13: error DD3007 at FilmToe[1]: FilmToe is not an array and has no index"},
	{"IndexOnBit", "(bOverride_FilmToe[0]=True)",
		"1:2: error DD3007 at bOverride_FilmToe[0]: bOverride_FilmToe is not an array and has no index"},
	{"IndexBeyondEnd", "(LensFlareTints[8]=(R=1))",
		"1:20: error DD3007 at LensFlareTints[8]: LensFlareTints has indices 0 to 7"},
	{"ArrayWithoutIndex", "(LensFlareTints=(R=1))",
		"1:17: error DD3007 at LensFlareTints: expected an index: LensFlareTints[0] to LensFlareTints[7]"},
	{"BlendableMember", "(WeightedBlendables=(Array=((Size=1))))",
		"1:30: error DD3005 at WeightedBlendables: expected Weight or Object, found Size"},
	{"BlendablesWithoutBrackets", "(WeightedBlendables=1)",
		"1:21: error DD3004 at WeightedBlendables: expected (Array=((Weight=..,Object=..))), found 1"},
	{"Utf16", "\xFF\xFE(", "1:1: error DD3010: the text is not UTF-8: save it as UTF-8"},
	{"Latin1", "Settings=()\nActorLabel=\"K\xFChl\"\n", "2:14: error DD3010: the text is not UTF-8: save it as UTF-8"},
	{"BeginWithoutEnd", "Begin Map\nBegin Actor Class=PostProcessVolume Name=A\nSettings=()\nbUnbound=True\n",
		"2:1: error DD3008: Begin Actor has no End Actor"},
	{"EndWithoutBegin", "Settings=()\nEnd Actor\n", "2:1: error DD3008: End Actor has no Begin Actor"},
	{"WrongEnd", "Begin Map\nBegin Actor Name=A\nbUnbound=True\nSettings=()\nEnd Map\n",
		"5:1: error DD3008: expected End Actor for the Begin Actor at 2:1, found End Map"},
	{"TextBehindSettings", "Settings=() Priority=1\n",
		"1:13: error DD3001 at Settings: expected the end of the line after the value of Settings, found Priority"},
	{"SettingsTwice", "Settings=()\nSettings=()\n",
		"2:1: error DD3003 at Settings: Settings is given twice, first at 1:1"},
	{"ActorWithoutSettings", "Begin Map\nBegin Actor Class=/Script/Engine.StaticMeshActor Name=A\nEnd Actor\nEnd Map\n",
		"1:1: error DD3009: there are no post-process settings in this text: expected (NAME=VALUE,..) or an actor with "
		"Settings=(..)"},
	{"WordForPriority", "Settings=()\nPriority=high\n",
		"2:10: error DD3004 at Priority: expected a number, found high"},
	{"NumberForUnbound", "Settings=()\nbUnbound=7\n",
		"2:10: error DD3004 at bUnbound: expected True or False, found 7"},
	{"WordInLocation",
		"Begin Actor Name=A\nBegin Object Name=\"BrushComponent0\"\nRelativeLocation=(X=0,Q=1)\nEnd "
		"Object\nbUnbound=True\nSettings=()\nEnd Actor",
		"3:23: error DD3005 at A.RelativeLocation: expected (X=..,Y=..,Z=..), found Q"},
};

} // namespace

TEST_P(SettingsTextMistake, IsOneMessageWithItsPlace)
{
	const FMistake& Mistake = GetParam();
	std::vector<FDiagnostic> Diagnostics;
	ReadVolumesText(Mistake.Text, "clip.txt", Diagnostics);
	std::string Errors;
	for (const FDiagnostic& Diagnostic : Diagnostics)
	{
		Errors += Diagnostic.Severity == ESeverity::Error ? Diagnostic.ToString() + "\n" : "";
	}
	EXPECT_EQ(std::string("clip.txt:") + Mistake.Message + "\n", Errors);
}

INSTANTIATE_TEST_SUITE_P(Texts, SettingsTextMistake, testing::ValuesIn(GMistakes),
	[](const testing::TestParamInfo<FMistake>& Info) { return Info.param.Name; });

TEST(SettingsTextMistakes, AllThatCanBeFoundAreReportedTogether)
{
	std::vector<FDiagnostic> Diagnostics;
	ReadVolumesText("(FilmToe=high,BloomMethod=BM_X,SceneColorTint=1,\nFilmSlope=nan)", "clip.txt", Diagnostics);
	ASSERT_EQ(4u, Diagnostics.size());
	EXPECT_EQ(2, Diagnostics[3].Line);
}

TEST(SettingsTextMistakes, OneBrokenVolumeDoesNotHideTheOthers)
{
	std::vector<FDiagnostic> Diagnostics;
	ReadVolumesText("Begin Actor Name=A\nSettings=(FilmToe=0.5 x)\nbUnbound=True\nEnd Actor\n"
					"Begin Actor Name=B\nSettings=(FilmToe=x)\nbUnbound=True\nEnd Actor\n",
		"clip.txt", Diagnostics);
	ASSERT_EQ(2u, Diagnostics.size());
	EXPECT_EQ("Settings", Diagnostics[0].Where);
	EXPECT_EQ("B.FilmToe", Diagnostics[1].Where);
}

TEST(SettingsTextMistakes, DeepNestingIsRefused)
{
	std::vector<FDiagnostic> Diagnostics;
	ReadVolumesText("(New=" + std::string(100000, '('), "clip.txt", Diagnostics);
	ASSERT_EQ(1u, Diagnostics.size());
	EXPECT_EQ(3002, Diagnostics[0].Code);
}
