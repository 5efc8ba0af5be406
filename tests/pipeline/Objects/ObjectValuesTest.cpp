// A plugin tuned from outside (tests/plugins/Tuned): by its ini files, by the config's "objects", by settings of its
// own that volumes blend. What it draws is computed here from its formula, on a picture of 16 x 8: red x / 16, green y
// / 8, blue 1/4.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Config/SettingList.h"
#include "Objects/ObjectErrors.h"
#include "Picture/ImageFile.h"
#include "PostProcessSettingsReflection.h"
#include "PostProcessSettingsText.h"
#include "RangeTools.h"
#include "Run/Run.h"
#include "Run/RunSetup.h"
#include "Text/ConfigErrors.h"

#include <cmath>
#include <filesystem>
#include <unistd.h>

using namespace Drydock;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

namespace
{

namespace Files = std::filesystem;

class ObjectValues : public testing::Test
{
protected:
	ObjectValues()
		: Scene(Files::temp_directory_path() / ("drydock_objects_" + std::to_string(getpid()) + ".exr"))
	{
		FImage Image{16, 8, 3, {}};
		for (int Pixel = 0; Pixel < 16 * 8; ++Pixel)
		{
			const double Color[] = {Pixel % 16 / 16.0, Pixel / 16 / 8.0, 0.25};
			Image.Values.insert(Image.Values.end(), std::begin(Color), std::end(Color));
		}
		WriteExr(Scene.string(), Image, {"R", "G", "B"});
	}
	~ObjectValues() override { Files::remove(Scene); }

	FRunOptions MakeOptions(const std::string& More) const
	{
		FRunOptions Options;
		Options.ConfigFile = Scene.string() + ".json";
		Options.ConfigText = R"({"scene": {"file": ")" + Scene.string() + R"("}, "showFlags": {"Bloom": false},
			"plugins": [")" DRYDOCK_TEST_BINARY_DIR R"(/lib/libTuned.so"])" +
							 More + "}";
		return Options;
	}

	/** The codes and places of the errors that a run ends with. */
	std::vector<std::string> GetErrors(const std::string& More) const
	{
		std::vector<std::string> Errors;
		try
		{
			RunConfig(MakeOptions(More));
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

	/** Every pixel is Scale times the source's plus Lift. */
	void ExpectPicture(const FRunResult& Result, const double (&Scale)[3], const double (&Lift)[3]) const
	{
		for (const FDiagnostic& Diagnostic : Result.Diagnostics)
		{
			ADD_FAILURE() << Diagnostic.ToString();
		}
		for (int Pixel = 0; Pixel < 16 * 8; ++Pixel)
		{
			const double Color[] = {Pixel % 16 / 16.0, Pixel / 16 / 8.0, 0.25};
			for (int Channel = 0; Channel < 3; ++Channel)
			{
				const double Expected = Color[Channel] * Scale[Channel] + Lift[Channel];
				ASSERT_NEAR(
					Expected, Result.SceneLinear.Get(Pixel % 16, Pixel / 16, Channel), std::abs(Expected) / 1024 + 1e-4)
					<< "pixel " << Pixel << ", channel " << Channel;
			}
		}
	}

	const Files::path Scene;
};

} // namespace

// Config/DefaultGame.ini: Tint (0.5, 2, 1), Weights.Scale 2, Lift.Y 0.5, Offsets 0.125 + 0.25, Secret 0.5, the Label,
// which adds 1; DefaultEngine.ini: r.Tuned.Gain 4, r.Tuned.On True, without which red is 64 more. Nothing is blended:
// TunedGlow 0, TunedColor white, TunedMix Replace.
TEST_F(ObjectValues, IniFilesAreReadBeforeTheFirstFrame)
{
	ExpectPicture(RunConfig(MakeOptions("")), {0.5 * 2.0, 2.0 * 4.0, 0.0}, {0.5, 0.5, 0.375 + 1.0});
}

TEST_F(ObjectValues, TheConfigsObjectsComeAfterTheIniFiles)
{
	const FRunResult Result = RunConfig(MakeOptions(R"(, "cvars": {"r.Tuned.Gain": 3}, "objects": {
		"UTunedSettings": {"Tint": [1, 1, 0.5], "Weights": {"Lift": [0, 0.25, 0]}, "Offsets": [1, 2], "Steps": 3,
			"Secret": 0.25, "bInvert": true, "Label": "another"}})"));
	ExpectPicture(Result, {1.0 * 2.0 * 3.0, 1.0 * 3.0, 0.0}, {0.25, 0.25 + 16.0, 3.0});
	// Nothing of it stays.
	ExpectPicture(RunConfig(MakeOptions("")), {0.5 * 2.0, 2.0 * 4.0, 0.0}, {0.5, 0.5, 0.375 + 1.0});
}

// Code 188 is 0.737255, and ((0.737255 + 0.055) / 1.055)^2.4 = 0.502886; an EXR's values are linear.
TEST_F(ObjectValues, ATexturePropertyIsGivenAPicture)
{
	const Files::path Png = Scene.string() + ".mask.png", Exr = Scene.string() + ".mask.exr";
	WritePng(Png.string(), FImage{1, 1, 3, {188 / 255.0, 1, 0}});
	WriteExr(Exr.string(), FImage{1, 1, 1, {0.25}}, {"Y"});
	const auto Give = [&](const Files::path& Picture)
	{
		return RunConfig(MakeOptions(R"(, "objects": {"UTunedSettings": {"Mode": "Off", "Label": "", "Mask": ")" +
									 Picture.filename().string() + R"("}})"));
	};
	ExpectPicture(Give(Png), {0.502886, 1, 0}, {0.5, 0.5, 0.375});
	ExpectPicture(Give(Exr), {0.25, 0.25, 0.25}, {0.5, 0.5, 0.375});
	// Nothing of it stays.
	ExpectPicture(RunConfig(MakeOptions(R"(, "objects": {"UTunedSettings": {"Mode": "Off", "Label": ""}})")), {1, 1, 1},
		{0.5, 0.5, 0.375});
	Files::remove(Png);
	Files::remove(Exr);
	EXPECT_THAT(GetErrors(R"(, "objects": {"UTunedSettings": {"Mask": "nowhere.png"}})"),
		ElementsAre(AllOf(HasSubstr("/objects/UTunedSettings/Mask"), HasSubstr("nowhere.png"))));
	EXPECT_THAT(GetErrors(R"(, "objects": {"UTunedSettings": {"Mask": "/Game/A.A"}})"),
		ElementsAre(AllOf(HasSubstr("2122"), HasSubstr("the name of a picture file"))));
}

// Render targets of "assets" reach fields, calls and LoadObject, and are written as they are after the frame; a picture
// reaches a call. A later run of the process begins with a cleared target.
TEST_F(ObjectValues, RenderTargetsAreGivenAndWritten)
{
	const Files::path Png = Scene.string() + ".three.png";
	WritePng(Png.string(), FImage{3, 1, 3, std::vector<double>(9, 1.0)});
	const std::string Assets = R"(, "assets": {
		"RT_A": {"SizeX": 5, "SizeY": 2, "RenderTargetFormat": "RTF_RGBA32f", "bCanCreateUAV": true},
		"/Game/RT_B": {"SizeX": 1, "SizeY": 1},
		"RT_Asset": {"SizeX": 2, "SizeY": 2, "ClearColor": [0.5, 0, 0, 1]},
		"T_Three": {"file": ")" +
							   Png.filename().string() + R"("}})";
	const auto Find = [](const FRunResult& Result, const std::string& Name)
	{
		const FRunDump* const Dump = FindItem(Result.Dumps, Name, &FRunDump::Resource);
		return Dump != nullptr ? Dump->Image.Crop({0, 0, 1, 1}).ToImage().Values : std::vector<double>();
	};
	const FRunResult Result = RunConfig(MakeOptions(Assets + R"(, "objects": {"ATunedActor": {
		"Target": "/Game/RT_B.RT_B", "call": [{"Paint": ["RT_A", "T_Three"]}, "PaintAsset"]}})"));
	EXPECT_THAT(Find(Result, "RT_A"), ElementsAre(3, 0.25, 0.5, 1));
	EXPECT_THAT(Find(Result, "/Game/RT_B"), ElementsAre(0, 3, 0, 1));
	EXPECT_THAT(Find(Result, "RT_Asset"), ElementsAre(4, 3, 2, 1));
	EXPECT_EQ(5, FindItem(Result.Dumps, std::string("RT_A"), &FRunDump::Resource)->Image.Width);
	const FRunResult Unused =
		RunConfig(MakeOptions(Assets + R"(, "objects": {"ATunedActor": {"Target": "RT_Asset"}})"));
	EXPECT_THAT(Find(Unused, "RT_Asset"), ElementsAre(0.5, 0, 0, 1));
	EXPECT_THAT(
		GetErrors(
			Assets + R"(, "objects": {"ATunedActor": {"Target": "T_Three", "call": [{"Paint": ["RT_A", "RT_A"]}]}})"),
		ElementsAre(AllOf(HasSubstr("2122 /objects/ATunedActor/Target"), HasSubstr("of that class")),
			AllOf(HasSubstr("2122 /objects/ATunedActor/call/0/Paint/1"), HasSubstr("of that class"))));
	EXPECT_THAT(
		GetErrors(R"(, "assets": {"A": {"SizeX": 0, "SizeY": 1.5}, "B": {"file": "x.png", "SizeX": 1}, "C": {}})"),
		ElementsAre(HasSubstr("/assets/A/SizeX"), HasSubstr("/assets/A/SizeY"), HasSubstr("/assets/B"),
			HasSubstr("/assets/C")));
	Files::remove(Png);
}

TEST_F(ObjectValues, ClassesMayBeNamedWithoutTheirPrefixAndByPath)
{
	ExpectPicture(RunConfig(MakeOptions(R"(, "objects": {"TunedSettings": {"Mode": "Off", "Label": ""}})")), {1, 1, 1},
		{0.5, 0.5, 0.375});
	ExpectPicture(RunConfig(MakeOptions(R"(, "objects": {"/Script/Tuned.TunedSettings": {"Mode": 0}})")), {1, 1, 1},
		{0.5, 0.5, 1.375});
}

// An actor that "objects" names is in the world from its BeginPlay on, with its value, for that run: it ticks once.
TEST_F(ObjectValues, AnActorThatTheConfigNamesIsPlaced)
{
	const double Scale[] = {0.5 * 2.0, 2.0 * 4.0, 0.0};
	for (int Run = 0; Run < 2; ++Run)
	{
		ExpectPicture(RunConfig(MakeOptions(R"(, "objects": {"ATunedActor": {"Lift": 0.25}})")),
			{Scale[0], Scale[1], Scale[2]}, {0.5 + 0.25, 0.5 + 0.25, 1.375 + 0.25 + 1.0});
		ExpectPicture(RunConfig(MakeOptions(R"(, "objects": {"TunedActor": {}})")), {Scale[0], Scale[1], Scale[2]},
			{0.5, 0.5, 1.375 + 1.0});
		ExpectPicture(RunConfig(MakeOptions("")), {Scale[0], Scale[1], Scale[2]}, {0.5, 0.5, 1.375});
	}
}

// Two volumes at weights 1 and 0.5, then the command line.
TEST_F(ObjectValues, SettingsOfThePluginAreBlendedByVolumes)
{
	const std::string Volumes = R"(, "volumes": [
		{"bUnbound": true, "Priority": 1, "Settings": {"TunedGlow": 4, "TunedMix": "Keep", "TunedColor": [1, 0.5, 2]}},
		{"bUnbound": true, "Priority": 2, "BlendWeight": 0.25, "Settings": {"TunedGlow": 2, "TunedColor": [0, 1.5, 2, 1]}}])";
	const double Glow = 4 + (2 - 4) * 0.25;
	const double Red = 1 + (0 - 1) * 0.25;
	const double Green = 0.5 + (1.5 - 0.5) * 0.25;
	ExpectPicture(RunConfig(MakeOptions(Volumes)), {1.0 * Red, 8.0 * Green, 2.0}, {Glow + 0.5, 0.5, 1.375});

	FRunOptions Options = MakeOptions(Volumes);
	Options.Settings = {"TunedGlow=1", "TunedMix=Replace"};
	ExpectPicture(RunConfig(Options), {1.0 * Red, 8.0 * Green, 0.0}, {1.5, 0.5, 1.375});
}

TEST_F(ObjectValues, MistakesNameTheClassTheFieldAndTheNearestName)
{
	EXPECT_THAT(GetErrors(R"(, "objects": {"UTunedSetings": {"Steps": 1}})"),
		ElementsAre("2120 /objects/UTunedSetings: no plugin has a class UTunedSetings; did you mean UTunedSettings?"));
	EXPECT_THAT(GetErrors(R"(, "objects": {"UTunedSettings": {"Step": 1}})"),
		ElementsAre("2121 /objects/UTunedSettings/Step: UTunedSettings has no UPROPERTY Step; did you mean Steps?"));
	EXPECT_THAT(GetErrors(R"(, "objects": {"UTunedSettings": {"Steps": 1.5, "Mode": "Multipl",
		"Weights": {"Lift": [0, 1]}, "Mask": "/Game/A.A", "OnlyInTheEditor": 1}})"),
		ElementsAre(
			HasSubstr("2122 /objects/UTunedSettings/Steps: UTunedSettings::Steps (int32): expected a whole number"),
			HasSubstr("2122 /objects/UTunedSettings/Mode: UTunedSettings::Mode (ETunedMode): expected one of Off, "
					  "Multiply, Add, found \"Multipl\"; did you mean Multiply?"),
			HasSubstr("2122 /objects/UTunedSettings/Weights/Lift: expected [X, Y, Z]"),
			HasSubstr(
				"2122 /objects/UTunedSettings/Mask: UTunedSettings::Mask (TObjectPtr<UTexture2D>): expected the name "
				"of a picture file, or of an entry of \"assets\", of that class, found \"/Game/A.A\""),
			HasSubstr("2121 /objects/UTunedSettings/OnlyInTheEditor")));
	EXPECT_THAT(GetErrors(R"(, "camera": {"Settings": {"TunedGlw": 1}})"),
		ElementsAre("1012 /camera/Settings/TunedGlw: unknown setting; did you mean TunedGlow?"));
}

TEST_F(ObjectValues, WithoutPluginsTheMessagesSayWhatIsNotKnown)
{
	FRunOptions Options = MakeOptions(R"(, "camera": {"Settings": {"TunedGlowing": 1}})");
	Options.bNoPlugins = true;
	try
	{
		RunConfig(Options);
		FAIL();
	}
	catch (const FError& Error)
	{
		ASSERT_EQ(2u, Error.GetDiagnostics().size());
		EXPECT_EQ(2079, Error.GetDiagnostics()[0].Code);
		EXPECT_THAT(Error.GetDiagnostics()[1].Message, HasSubstr("(or a plugin that could not be loaded has it)"));
	}
}

TEST_F(ObjectValues, AddedSettingsAreInTheLedgerTheListAndThePasteText)
{
	const FRunSetup Setup(MakeOptions(R"(, "camera": {"Settings": {"TunedGlow": 2.5, "TunedMix": "Keep"}})"));
	EXPECT_EQ("TunedGlow: float = 0, 0 .. 8, Lerp",
		[]
		{
			const std::string Text = FormatSettings(FindSettingFields("TunedGlow"));
			const size_t Begin = Text.find("TunedGlow:");
			return Text.substr(Begin, Text.find('\n', Begin) - Begin);
		}());
	FSettingsText Text;
	Text.Settings = Setup.Config.Camera.Settings.Settings;
	std::vector<FDiagnostic> Diagnostics;
	const std::string Written = WriteSettingsText(Text, ESettingsTextForm::Delta, Diagnostics);
	EXPECT_THAT(Written, HasSubstr("bOverride_TunedGlow=True"));
	EXPECT_THAT(Written, HasSubstr("TunedGlow=2.500000"));
	EXPECT_THAT(Written, HasSubstr("TunedMix=Keep"));
	const FSettingField& Glow = *FindSettingField("TunedGlow");
	EXPECT_EQ(2.5, Glow.Get(Setup.Settings.Settings).Components[0]);
	EXPECT_TRUE(Glow.IsOverridden(Setup.Settings.Settings));
}
