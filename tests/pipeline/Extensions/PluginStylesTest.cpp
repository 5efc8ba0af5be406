// Seventeen plugins in the styles of public ones (tests/plugins), loaded as a config loads them. Each does something
// whose result a line of arithmetic tells, on a picture of 16 x 8: red x / 16, green y / 8, blue 1/4.
#include <gtest/gtest.h>

#include "DispatchReuse.h"
#include "Picture/ImageFile.h"
#include "Run/Run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <unistd.h>

using namespace Drydock;

namespace
{

namespace Files = std::filesystem;

using FColor3 = std::array<double, 3>;

constexpr int Width = 16;
constexpr int Height = 8;

FColor3 SourceColor(int X, int Y)
{
	return {X / 16.0, Y / 8.0, 0.25};
}

/** Near (10 m) on the left, far (100 m) on the right; cloth (8) in the upper half, default lit (1) below. */
std::string WriteScene()
{
	FImage Image{Width, Height, 5, {}};
	for (int Y = 0; Y < Height; ++Y)
	{
		for (int X = 0; X < Width; ++X)
		{
			const FColor3 Color = SourceColor(X, Y);
			const double More[] = {X < 8 ? 10.0 : 100.0, Y < 4 ? 8.0 : 1.0};
			Image.Values.insert(Image.Values.end(), Color.begin(), Color.end());
			Image.Values.insert(Image.Values.end(), std::begin(More), std::end(More));
		}
	}
	const Files::path Path = Files::temp_directory_path() / ("drydock_styles_" + std::to_string(getpid()) + ".exr");
	WriteExr(Path.string(), Image, {"R", "G", "B", "depth.Z", "shadingmodel.ID"});
	return Path.string();
}

struct FFrame
{
	std::string Cvars; // members of "cvars"
	std::function<FColor3(int, int, FColor3)> Expected;
};

struct FStyle
{
	const char* Plugin;
	std::vector<FFrame> Frames;
	const char* Engine = "5.4";
	bool bDisplay = false; // compare the encoded picture instead of the tonemapper's input
};

void PrintTo(const FStyle& Style, std::ostream* Stream)
{
	*Stream << Style.Plugin;
}

FRunResult RunFrame(const std::string& Scene, const FStyle& Style, const FFrame& Frame,
	const std::shared_ptr<FReuseCache>& Cache = nullptr)
{
	FRunOptions Options;
	Options.ReuseCache = Cache;
	Options.ConfigFile = Scene + ".json";
	Options.ConfigText = R"({"scene": {"file": ")" + Scene + R"("}, "showFlags": {"Bloom": false}, "engine": ")" +
						 std::string(Style.Engine) + R"(", "cvars": {)" + Frame.Cvars +
						 R"(}, "plugins": [")" DRYDOCK_TEST_BINARY_DIR "/lib/lib" + Style.Plugin + R"(.so"]})";
	return RunConfig(Options);
}

class PluginStyles : public testing::TestWithParam<FStyle>
{
};

void ExpectArithmetic(const FRunResult& Result, const FStyle& Style, const FFrame& Frame)
{
	const FImage Picture = (Style.bDisplay ? Result.Final : Result.SceneLinear).ToImage();
	// What a half float resolves up to 16, or half a step of 8 bits.
	const double Tolerance = Style.bDisplay ? 0.501 / 255 : 1.0 / 1024;
	ASSERT_EQ(Width, Picture.Width);
	ASSERT_EQ(Height, Picture.Height);
	for (int Y = 0; Y < Height; ++Y)
	{
		for (int X = 0; X < Width; ++X)
		{
			const FColor3 Expected = Frame.Expected(X, Y, SourceColor(X, Y));
			for (int Channel = 0; Channel < 3; ++Channel)
			{
				ASSERT_NEAR(Expected[static_cast<size_t>(Channel)], Picture.Get(X, Y, Channel), Tolerance)
					<< "pixel (" << X << ", " << Y << "), channel " << Channel;
			}
		}
	}
}

// clang-format off
const std::vector<FStyle> GStyles = {
	{"SwapChannels", {{"", [](int, int, FColor3 C) -> FColor3 { return {C[2], C[1], C[0]}; }}}},
	{"HalfBright", {{"", [](int, int, FColor3 C) -> FColor3 { return {C[0] / 2, C[1] / 2, C[2] / 2}; }}}},
	{"ShowUV", {{"", [](int X, int Y, FColor3) -> FColor3 { return {(X + 0.5) / 16, (Y + 0.5) / 8, 0.0}; }}}, "5.4",
		true},
	// The subsystem's base doubles the light of (1, 0.5, 0.25).
	{"AddLight", {{"", [](int, int, FColor3 C) -> FColor3 { return {C[0] + 2, C[1] + 1, C[2] + 0.5}; }}}},
	{"Variants",
		{{"", [](int, int, FColor3 C) -> FColor3 { return C; }},
			{R"("r.Variants.Steps": 1, "r.Variants.Channel": 2)",
				[](int, int, FColor3 C) -> FColor3 { return {C[0], C[1], C[2] + 0.25}; }},
			{R"("r.Variants.Double": 1, "r.Variants.Steps": 3, "r.Variants.Channel": 1)",
				[](int, int, FColor3 C) -> FColor3 { return {2 * C[0], 2 * (C[1] + 0.75), 2 * C[2]}; }}}},
	// (c + 1) - 2 c
	{"TwoTargets", {{"", [](int, int, FColor3 C) -> FColor3 { return {1 - C[0], 1 - C[1], 1 - C[2]}; }}}},
	// Half of (0, own green, 4) over half of the picture.
	{"HalfScreen",
		{{"", [](int X, int, FColor3 C) -> FColor3 { return X < 8 ? C : FColor3{C[0] / 2, C[1], C[2] / 2 + 2}; }}},
		"5.5"},
	// The mean of the frame before and three times the picture.
	{"Trails",
		{{R"("r.Trails.Gain": 1)", [](int, int, FColor3 C) -> FColor3 { return C; }},
			{R"("r.Trails.Gain": 3)", [](int, int, FColor3 C) -> FColor3 { return {2 * C[0], 2 * C[1], 2 * C[2]}; }}}},
	{"Gate",
		{{"", [](int, int, FColor3 C) -> FColor3 { return C; }},
			{R"("r.Gate.Enable": 1)", [](int X, int, FColor3 C) -> FColor3 { return X >= 8 ? C : FColor3{0, 0, 0}; }},
			{R"("r.Gate.Enable": 1, "r.Gate.Invert": 1, "r.Gate.Fill": 2)",
				[](int X, int, FColor3 C) -> FColor3 { return X >= 8 ? FColor3{2, 2, 2} : C; }}}},
	{"Spotlight",
		{{"",
			[](int X, int Y, FColor3 C) -> FColor3
			{
				const bool bInside = X >= 4 && X < 12 && Y >= 2 && Y < 6;
				return bInside ? FColor3{2 * C[0], 2 * C[1], 2 * C[2]} : FColor3{0, 0, 0};
			}}}},
	// A row's mean is 7.5 / 16; its sum at weight 2, which the next frame reads back, 2 (0 + ... + 15) / 16 = 15.
	{"RowAverage",
		{{"", [](int, int, FColor3) -> FColor3 { return {7.5 / 16, 0, 0}; }},
			{"", [](int, int, FColor3) -> FColor3 { return {7.5 / 16, 15, 0}; }}}},
	{"Grading", {{"", [](int, int, FColor3 C) -> FColor3 { return {2 * C[0], C[1] + 0.5, 4}; }}}},
	{"DepthFog",
		{{"", [](int X, int Y, FColor3 C) -> FColor3 { return X >= 8 && Y >= 4 ? FColor3{0.25, 0.5, 8} : C; }}}},
	{"WorldTint", {{"", [](int, int, FColor3 C) -> FColor3 { return {C[0] / 2, 2 * C[1], 0}; }}}},
	// Raw, lambda and shared pointer add 1 to a channel each, the static function doubles, the object adds 4 to red.
	{"ManyDelegates",
		{{"", [](int, int, FColor3 C) -> FColor3 { return {2 * (C[0] + 1) + 4, 2 * (C[1] + 1), 2 * (C[2] + 1)}; }}}},
	// Means of the four diagonal neighbours; blue is the UV of a triangle made from vertex numbers.
	{"FourTaps",
		{{"",
			[](int X, int Y, FColor3) -> FColor3
			{
				return {(std::max(X - 1, 0) + std::min(X + 1, Width - 1)) / 2.0 / 16,
					(std::max(Y - 1, 0) + std::min(Y + 1, Height - 1)) / 2.0 / 8, (X + 0.5) / 16};
			}}}},
	// Means of blocks of 4 x 4.
	{"Pyramid",
		{{"",
			[](int X, int Y, FColor3) -> FColor3
			{ return {(X / 4 * 4 + 1.5) / 16, (Y / 4 * 4 + 1.5) / 8, 0.25}; }}}},
};
// clang-format on

} // namespace

TEST_P(PluginStyles, DoWhatTheirArithmeticSays)
{
	const std::string Scene = WriteScene();
	for (const FFrame& Frame : GetParam().Frames)
	{
		SCOPED_TRACE("cvars {" + Frame.Cvars + "}");
		const FRunResult Result = RunFrame(Scene, GetParam(), Frame);
		for (const FDiagnostic& Diagnostic : Result.Diagnostics)
		{
			// A gate that is shut does nothing, and the run remarks on it.
			EXPECT_EQ(ESeverity::Note, Diagnostic.Severity) << Diagnostic.ToString();
		}
		ExpectArithmetic(Result, GetParam(), Frame);
	}
	Files::remove(Scene);
}

TEST_P(PluginStyles, DoTheSameWithPassesOfTheFrameBefore)
{
	const std::string Plugin = GetParam().Plugin;
	if (Plugin == "RowAverage" || Plugin == "Trails")
	{
		GTEST_SKIP() << "each of its frames takes something from the frame before";
	}
	const std::string Scene = WriteScene();
	const auto Cache = std::make_shared<FReuseCache>();
	for (int Repetition = 0; Repetition < 2; ++Repetition)
	{
		for (const FFrame& Frame : GetParam().Frames)
		{
			SCOPED_TRACE("cvars {" + Frame.Cvars + "}, repetition " + std::to_string(Repetition));
			const FRunResult Result = RunFrame(Scene, GetParam(), Frame, Cache);
			ExpectArithmetic(Result, GetParam(), Frame);
			EXPECT_TRUE(Repetition == 0 || std::ranges::any_of(Result.Passes, &FRunPass::IsReused));
		}
	}
	Files::remove(Scene);
}

INSTANTIATE_TEST_SUITE_P(Seventeen, PluginStyles, testing::ValuesIn(GStyles),
	[](const testing::TestParamInfo<FStyle>& Info) { return std::string(Info.param.Plugin); });
