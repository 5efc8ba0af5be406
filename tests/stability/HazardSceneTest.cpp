// The hazard scene, configs/scenes/hazards.exr: what is in it, and what every sample config makes of it. Run with
// DRYDOCK_BLESS=1 to write the scene anew.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "HazardScene.h"

#include "Picture/ImageFile.h"
#include "Run/Run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <regex>
#include <sstream>

using namespace Drydock;

namespace
{

const std::filesystem::path Configs = DRYDOCK_TEST_SOURCE_DIR "/configs";
const std::string SceneFile = (Configs / "scenes/hazards.exr").string();

constexpr int Width = 64;
constexpr int Height = 36;

const std::vector<std::string> Channels = {"R", "G", "B", "A", "depth.Z", "normal.X", "normal.Y", "normal.Z",
	"velocity.X", "velocity.Y", "basecolor.R", "basecolor.G", "basecolor.B", "shadingmodel.ID", "custommask.B",
	"shadow.R", "shadow.G"};

/** Single pixels, two rows of four, as configs/scenes/README.md lists them. */
struct FSpot
{
	int X;
	int Y;
	double Value;
};
const FSpot Spots[] = {{8, 6, std::numeric_limits<double>::quiet_NaN()},
	{24, 6, std::numeric_limits<double>::infinity()}, {40, 6, -std::numeric_limits<double>::infinity()}, {56, 6, 65504},
	{8, 14, 65520}, {24, 14, 1e30}, {40, 14, 60000}, {56, 14, 4096}};

/** Areas of 8 x 6 from row 20 on, side by side from column 4. */
const std::array<double, 3> Areas[] = {{-0.5, 0.25, -0.125}, {0x1p-20, 0x1p-22, 0x1p-24}, {1e-40, 1e-41, 1e-42},
	{-0.0, -0.0, -0.0}, {0, 0, 0}, {0.75, 0.5, 0.25}, {0.59, -0.3, 0}};

std::array<double, 3> GetColor(int X, int Y)
{
	for (const FSpot& Spot : Spots)
	{
		if (Spot.X == X && Spot.Y == Y)
		{
			return {Spot.Value, Spot.Value, Spot.Value};
		}
	}
	const int Area = (X - 4) / 8;
	if (Y >= 20 && Y < 26 && X >= 4 && Area < static_cast<int>(std::size(Areas)))
	{
		return Areas[Area];
	}
	const double Ramp = 0.125 + X / 128.0;
	return {Ramp, Ramp, Ramp * 0.5};
}

FImage MakeScene()
{
	const int NumChannels = static_cast<int>(Channels.size());
	FImage Image{Width, Height, NumChannels, std::vector<double>(static_cast<size_t>(Width * Height * NumChannels))};
	double* Value = Image.Values.data();
	for (int Y = 0; Y < Height; ++Y)
	{
		for (int X = 0; X < Width; ++X)
		{
			const std::array<double, 3> Color = GetColor(X, Y);
			const bool bSky = Y < 3, bMoves = X >= 48;
			const bool bMask = X >= 20 && X < 40 && Y >= 10 && Y < 30;
			const double Depth = bSky ? 65504 : X == 60 && Y == 33 ? 0x1p-10 : X < 32 ? 3 : 20;
			const double Velocity = X == 61 && Y == 33 ? 3000 : bMoves ? 5 : 0;
			for (const double Each :
				{Color[0], Color[1], Color[2], 1.0, Depth, 0.0, bSky ? 0.0 : -1.0, 0.0, Velocity, 0.0, 0.5, 0.5, 0.5,
					X < 32 ? 8.0 : 1.0, bMask ? 1.0 : 0.0, (X / 4 + Y / 4) % 2 == 0 ? 1.0 : 0.2, 1.0})
			{
				*Value++ = Each;
			}
		}
	}
	return Image;
}

/** The camera of another small scene, of this one's size. */
std::string MakeCamera()
{
	std::ifstream File(Configs / "scenes/two_boxes.json");
	nlohmann::ordered_json Camera = nlohmann::ordered_json::parse(File);
	Camera["scene"] = "hazards";
	Camera["width"] = Width;
	Camera["height"] = Height;
	Camera["focal_length_px"] = 60.444445;
	return Camera.dump(1);
}

std::string ReadText(const std::filesystem::path& Path)
{
	std::ifstream File(Path);
	std::ostringstream Text;
	Text << File.rdbuf();
	return Text.str();
}

std::vector<std::string> ListConfigs()
{
	std::vector<std::string> Names;
	for (const auto& Entry : std::filesystem::directory_iterator(Configs))
	{
		if (Entry.path().extension() == ".json")
		{
			Names.push_back(Entry.path().stem().string());
		}
	}
	std::sort(Names.begin(), Names.end());
	return Names;
}

/** Rects of views are those of a scene of 960 x 540. */
std::string ScaleRects(const std::string& Text)
{
	const std::regex Rect(R"re("rect"\s*:\s*\[\s*(\d+),\s*(\d+),\s*(\d+),\s*(\d+)\s*\])re");
	std::string Result, Rest = Text;
	for (std::smatch Match; std::regex_search(Rest, Match, Rect); Rest = Match.suffix())
	{
		Result += Match.prefix().str() + "\"rect\": [";
		for (int Side = 0; Side < 4; ++Side)
		{
			Result += std::to_string(std::stoi(Match[Side + 1]) / 15) + (Side < 3 ? ", " : "]");
		}
	}
	return Result + Rest;
}

FRunResult RunHazards(const std::string& Config, const std::vector<std::string>& Variables)
{
	std::string Text = ReadText(Configs / (Config + ".json"));
	Text =
		std::regex_replace(Text, std::regex(R"re("file"\s*:\s*"scenes/[^"]*")re"), R"("file": "scenes/hazards.exr")");
	Text = std::regex_replace(Text, std::regex(R"re(,\s*"frames"\s*:\s*"[^"]*")re"), "");
	Text = ScaleRects(Text);
	FRunOptions Options;
	Options.ConfigFile = (Configs / (Config + ".json")).string();
	Options.ConfigText = Text;
	Options.Variables = Variables;
	Options.bUseBudget = false;
	return RunConfig(Options);
}

size_t CountNonFinite(const FImage& Image)
{
	size_t Count = 0;
	for (const double Value : Image.Values)
	{
		Count += std::isfinite(Value) ? 0 : 1;
	}
	return Count;
}

const FRunResult& GetPlainRun(const std::string& Config)
{
	static std::map<std::string, FRunResult> Runs;
	const auto Found = Runs.find(Config);
	return Found != Runs.end() ? Found->second : Runs.emplace(Config, RunHazards(Config, {})).first->second;
}

class HazardSceneConfig : public testing::TestWithParam<std::string>
{
};

} // namespace

TEST(HazardScene, HoldsWhatItsDescriptionSays)
{
	const FImage Scene = MakeScene();
	if (std::getenv("DRYDOCK_BLESS") != nullptr)
	{
		WriteExr(SceneFile, Scene, Channels, {{"drydock:camera_json", MakeCamera()}});
		std::ofstream(Configs / "scenes/hazards.json") << MakeCamera() << "\n";
	}
	EXPECT_LT(std::filesystem::file_size(SceneFile), 60'000u);
	EXPECT_EQ(MakeCamera() + "\n", ReadText(Configs / "scenes/hazards.json"));
	FImageFile File(SceneFile);
	EXPECT_EQ(MakeCamera(), File.GetAttribute("drydock:camera_json"));
	std::vector<int> Indices;
	for (const std::string& Channel : Channels)
	{
		Indices.push_back(File.FindChannel(Channel));
	}
	const std::vector<std::vector<float>> Planes = File.Read(Indices);
	for (size_t Index = 0; Index < Scene.Values.size(); ++Index)
	{
		const float Expected = static_cast<float>(Scene.Values[Index]);
		const float Value = Planes[Index % Channels.size()][Index / Channels.size()];
		ASSERT_TRUE(std::memcmp(&Expected, &Value, sizeof(Value)) == 0 || (std::isnan(Expected) && std::isnan(Value)))
			<< Channels[Index % Channels.size()] << " of pixel " << Index / Channels.size() << ": " << Value;
	}
}

TEST_P(HazardSceneConfig, FinalPictureIsFinite)
{
	EXPECT_EQ(0u, CountNonFinite(GetPlainRun(GetParam()).Final.ToImage()));
}

TEST_P(HazardSceneConfig, LinearPictureIsNotFiniteWhereStatedOnly)
{
	const Stability::FStatedConfig* const Stated = Stability::FindStatedConfig(GetParam());
	const size_t Count = CountNonFinite(GetPlainRun(GetParam()).SceneLinear.ToImage());
	if (Stated == nullptr)
	{
		EXPECT_EQ(3 * Stability::NumBadPixels, Count);
	}
	else if (Stated->NumValues != 0)
	{
		EXPECT_EQ(Stated->NumValues, Count) << Stated->Reason;
	}
	else
	{
		EXPECT_GT(Count, 3 * Stability::NumBadPixels) << "no longer: " << Stated->Reason;
	}
}

TEST_P(HazardSceneConfig, EverythingIsFiniteOnceTheInputIsZeroedAndClamped)
{
	const FRunResult Result = RunHazards(GetParam(), {"r.Drydock.NonFinite=1", "r.Drydock.SceneColorClamp=1000"});
	EXPECT_EQ(0u, CountNonFinite(Result.SceneLinear.ToImage()));
	EXPECT_EQ(0u, CountNonFinite(Result.Final.ToImage()));
}

INSTANTIATE_TEST_SUITE_P(
	Configs, HazardSceneConfig, testing::ValuesIn(ListConfigs()), [](const auto& Info) { return Info.param; });
