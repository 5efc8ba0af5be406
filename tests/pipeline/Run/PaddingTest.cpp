// A view that does not begin at its textures' corner, in textures larger than the view: the same bits as a frame of its
// own, for every shipped config. The outside is poison: NaN in colour, toon everywhere in the G-buffer.
#include <gtest/gtest.h>

#include "Config/ReadConfig.h"
#include "Picture/ImageFile.h"
#include "Run/Run.h"
#include "SceneFile/SceneTexturePacking.h"
#include "Text/ConfigErrors.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <unistd.h>

using namespace Drydock;

namespace
{

namespace Files = std::filesystem;

const Files::path ConfigFolder = DRYDOCK_TEST_SOURCE_DIR "/configs";

std::string ReadText(const Files::path& Path)
{
	std::ifstream Stream(Path);
	std::ostringstream Text;
	Text << Stream.rdbuf();
	return Text.str();
}

/** The config with members added to its scene, whose first key is "file". */
std::string WithScene(const std::string& Text, const std::string& Members)
{
	const size_t Scene = Text.find("\"scene\"");
	const size_t Brace = Text.find('{', Scene);
	return Text.substr(0, Brace + 1) + Members + ", " + Text.substr(Brace + 1);
}

FRunResult RunText(const std::string& Text, const std::vector<std::string>& Variables = {})
{
	FRunOptions Options;
	Options.ConfigFile = (ConfigFolder / "text.json").string();
	Options.ConfigText = Text;
	Options.Variables = Variables;
	return RunConfig(Options);
}

const FRunResult& GetPlainRun(const std::string& Text)
{
	static std::map<std::string, FRunResult> Runs;
	const auto Found = Runs.find(Text);
	return Found != Runs.end() ? Found->second : Runs.emplace(Text, RunText(Text)).first->second;
}

bool AreSameBits(const FPicture& PictureA, const FPicture& PictureB)
{
	const FImage A = PictureA.ToImage(), B = PictureB.ToImage();
	return A.Width == B.Width && A.Height == B.Height && A.Values.size() == B.Values.size() &&
		   std::memcmp(A.Values.data(), B.Values.data(), A.Values.size() * sizeof(double)) == 0;
}

/** Configs whose passes sample anywhere between texels (colour fringe, FXAA, upscale; bloom of the studies' picture of
 * 641 x 359, whose levels are no whole halves): over another extent a texture coordinate rounds otherwise, and one on
 * the border of two steps of 1/256 texel takes the other. */
bool SamplesBetweenTexels(const std::string& Config)
{
	return Config == "film_look" || Config == "fxaa" || Config == "screen_percentage" || Config == "frame_full" ||
		   Config.starts_with("study_");
}

/** The same bits; where a config samples between texels, the same 8-bit codes give or take one, in one of 1000 values.
 */
void ExpectSameFinal(const std::string& Config, const FPicture& PictureA, const FPicture& PictureB)
{
	if (!SamplesBetweenTexels(Config))
	{
		EXPECT_TRUE(AreSameBits(PictureA, PictureB));
		return;
	}
	const FImage A = PictureA.ToImage(), B = PictureB.ToImage();
	ASSERT_EQ(A.Values.size(), B.Values.size());
	size_t NumOthers = 0;
	for (size_t Index = 0; Index < A.Values.size(); ++Index)
	{
		const double Difference = std::abs(A.Values[Index] - B.Values[Index]);
		EXPECT_LE(Difference, 1.01 / 255) << Index;
		NumOthers += Difference > 0.0 ? 1 : 0;
	}
	EXPECT_LT(NumOthers, A.Values.size() / 1000);
}

std::vector<std::string> FindShippedConfigs()
{
	std::vector<std::string> Names;
	for (const Files::directory_entry& Entry : Files::directory_iterator(ConfigFolder))
	{
		if (Entry.path().extension() == ".json")
		{
			Names.push_back(Entry.path().stem().string());
		}
	}
	std::sort(Names.begin(), Names.end());
	return Names;
}

/** 1/64 is the narrowest level of the bloom's chain, and its rows are blurred at half that width: corners at multiples
 * of these stay whole pixels on every level. */
const std::string WholeOnEveryLevel = R"("padding": {"left": 128, "top": 64, "right": 37, "bottom": 51})";

class Padding : public testing::TestWithParam<std::string>
{
};

/** A scene file of a part of the picture, in a folder of its own; its path. */
std::string WriteCropped(const std::string& Scene, int MinX, int MinY, int MaxX, int MaxY)
{
	FImageFile File((ConfigFolder / Scene).string());
	std::vector<int> Indices;
	for (size_t Index = 0; Index < File.GetChannels().size(); ++Index)
	{
		Indices.push_back(static_cast<int>(Index));
	}
	const std::vector<std::vector<float>> Planes = File.Read(Indices);
	FImage Part{MaxX - MinX, MaxY - MinY, static_cast<int>(Indices.size()), {}};
	for (int Y = MinY; Y < MaxY; ++Y)
	{
		for (int X = MinX; X < MaxX; ++X)
		{
			for (const std::vector<float>& Plane : Planes)
			{
				Part.Values.push_back(static_cast<double>(Plane[static_cast<size_t>(Y * File.GetWidth() + X)]));
			}
		}
	}
	const Files::path Folder = Files::temp_directory_path() / ("drydock_padding_" + std::to_string(getpid()));
	Files::create_directories(Folder);
	WriteExr((Folder / "part.exr").string(), Part, File.GetChannels(),
		{{"drydock:camera_json", File.GetAttribute("drydock:camera_json")}});
	return (Folder / "part.exr").string();
}

std::vector<FDiagnostic> Check(const std::string& PaddingText)
{
	std::vector<FDiagnostic> Diagnostics;
	ReadConfig(R"({"scene": {"file": "a.exr", "padding": )" + PaddingText + "}}", "a.json", Diagnostics);
	return Diagnostics;
}

FConfigPadding Read(const std::string& PaddingText)
{
	std::vector<FDiagnostic> Diagnostics;
	return ReadConfig(R"({"scene": {"file": "a.exr", "padding": )" + PaddingText + "}}", "a.json", Diagnostics)
		.Scene.Padding;
}

} // namespace

TEST_P(Padding, GivesTheSameBits)
{
	const std::string Text = ReadText(ConfigFolder / (GetParam() + ".json"));
	const FRunResult Padded = RunText(WithScene(Text, WholeOnEveryLevel));
	const FRunResult& Plain = GetPlainRun(Text);
	EXPECT_EQ(FIntPoint(128, 64), Padded.ViewRect.Min);
	EXPECT_TRUE(AreSameBits(Plain.SceneLinear, Padded.SceneLinear));
	ExpectSameFinal(GetParam(), Plain.Final, Padded.Final);
}

TEST_P(Padding, GivesTheSameBitsInCompute)
{
	const std::string Text = ReadText(ConfigFolder / (GetParam() + ".json"));
	const FRunResult Padded = RunText(WithScene(Text, WholeOnEveryLevel), {"r.PostProcessing.PreferCompute=1"});
	ExpectSameFinal(GetParam(), RunText(Text, {"r.PostProcessing.PreferCompute=1"}).Final, Padded.Final);
}

TEST_P(Padding, OnTheRightAndBelowNeedsNoMultiple)
{
	const std::string Text = ReadText(ConfigFolder / (GetParam() + ".json"));
	ExpectSameFinal(GetParam(), GetPlainRun(Text).Final, RunText(WithScene(Text, R"("padding": [0, 0, 1, 3])")).Final);
}

INSTANTIATE_TEST_SUITE_P(ShippedConfigs, Padding, testing::ValuesIn(FindShippedConfigs()),
	[](const testing::TestParamInfo<std::string>& Info) { return Info.param; });

TEST(ViewRect, APartOfThePictureIsTheCroppedPicture)
{
	const std::string Settings = R"("volumes": [{"bUnbound": true, "Settings": {"BloomIntensity": 2,
		"BloomToonIntensity": 0.1, "VignetteIntensity": 0.4}}])";
	const std::string Scene = "scenes/toon_character.exr";
	const std::string Part = WriteCropped(Scene, 256, 128, 256 + 320, 128 + 240);
	const FRunResult Cropped = RunText(R"({"scene": {"file": ")" + Part + R"("}, )" + Settings + "}");
	const FRunResult Rect =
		RunText(R"({"scene": {"file": ")" + Scene + R"("}, "view": {"rect": [256, 128, 576, 368]}, )" + Settings + "}");
	EXPECT_TRUE(AreSameBits(Cropped.Final, Rect.Final));
	Files::remove_all(Files::path(Part).parent_path());
}

TEST(ViewRect, OddCornersLeaveNoPoisonInThePicture)
{
	const FRunResult Result = RunText(WithScene(ReadText(ConfigFolder / "toon_bloom.json"), R"("padding": 7)"));
	const FImage ResultFinal = Result.Final.ToImage();
	EXPECT_TRUE(std::all_of(
		ResultFinal.Values.begin(), ResultFinal.Values.end(), [](double Value) { return std::isfinite(Value); }));
}

TEST(PaddedScene, TheOutsideIsNeitherReadNorWritten)
{
	FRunOptions Options;
	Options.ConfigFile = (ConfigFolder / "text.json").string();
	Options.ConfigText = WithScene(ReadText(ConfigFolder / "toon_bloom.json"), R"("padding": [128, 64, 8, 8])");
	Options.Variables = {"r.RDG.ClobberResources=1"};
	Options.Dump = {"*"};
	const FRunResult Result = RunConfig(Options);
	ASSERT_FALSE(Result.Dumps.empty());
	for (const FRunDump& Dump : Result.Dumps)
	{
		// Corners are outside every rect: NaN in what comes in, what the clobber left in what passes make. The image is
		// the whole extent; files hold what was drawn.
		const double Corner = Dump.Image.Get(0, 0, 0);
		const bool bScene = Dump.PassIndex == 0;
		const FScenePacking* Packing = FindScenePacking(Dump.Resource);
		if (bScene && Packing != nullptr && std::isnan(Packing->Outside.R))
		{
			EXPECT_TRUE(std::isnan(Corner)) << Dump.Resource;
		}
		else if (!bScene && Dump.Resource != "ViewFamilyTexture" && Dump.Resource != "CombineLUTs") // without a rect
		{
			EXPECT_EQ(1000.0, Corner) << Dump.Pass << "." << Dump.Resource;
		}
	}
}

TEST(ConfigPadding, IsANumberAnArrayOrAnObject)
{
	EXPECT_EQ(5, Read("5").Left);
	EXPECT_EQ(5, Read("5").Bottom);
	EXPECT_EQ(2, Read("[1, 2, 3, 4]").Top);
	EXPECT_EQ(4, Read("[1, 2, 3, 4]").Bottom);
	EXPECT_EQ(9, Read(R"({"right": 9})").Right);
	EXPECT_EQ(0, Read(R"({"right": 9})").Left);
	EXPECT_TRUE(Check(R"({"right": 9})").empty());
}

TEST(ConfigPadding, MistakesAreNamed)
{
	EXPECT_EQ(ErrorBadValue, Check("-1").at(0).Code);
	EXPECT_EQ(ErrorBadValue, Check("[0, 1.5, 0, 0]").at(0).Code);
	EXPECT_EQ("/scene/padding/1", Check("[0, 1.5, 0, 0]").at(0).Where);
	EXPECT_EQ(ErrorWrongLength, Check("[1, 2]").at(0).Code);
	EXPECT_EQ(ErrorWrongType, Check("\"7\"").at(0).Code);
	EXPECT_EQ(ErrorUnknownKey, Check(R"({"lefft": 1})").at(0).Code);
	EXPECT_EQ(1u, Check("4097").size());
}
