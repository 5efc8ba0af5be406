// NaN and infinities of a scene: counted, named, followed to the final picture, mended or refused.
#include "RunTestScene.h"

using namespace Drydock;
using namespace RunTest;

TEST(RunNonFinite, IsCountedZeroedOrRefusedByPolicy)
{
	const std::filesystem::path Folder = MakeTemporaryFolder();
	std::filesystem::create_directories(Folder);
	FImage Image{32, 16, 3, std::vector<double>(32 * 16 * 3, 0.5)};
	Image.Values[(7 * 32 + 9) * 3 + 1] = std::nan("");
	WriteExr((Folder / "nan.exr").string(), Image, {"R", "G", "B"});
	FRunOptions Options;
	Options.ConfigFile = (Folder / "a.json").string();
	Options.ConfigText = R"({"scene": {"file": "nan.exr"}})";

	const FRunResult Result = RunConfig(Options);
	ASSERT_FALSE(Result.Diagnostics.empty());
	EXPECT_EQ(WarnNonFinite, Result.Diagnostics[0].Code);
	EXPECT_EQ("1 value is NaN or infinite, first at pixel (9, 7)", Result.Diagnostics[0].Message);
	EXPECT_TRUE(std::isnan(Result.SceneLinear.Get(9, 7, 1)));

	Options.Variables = {"r.Drydock.NonFinite=1"};
	EXPECT_EQ(0.0, RunConfig(Options).SceneLinear.Get(9, 7, 1));
	Options.Variables = {"r.Drydock.NonFinite=2"};
	EXPECT_EQ("4002 1", ErrorOf(Options));
	std::filesystem::remove_all(Folder);
}

TEST(RunNonFinite, PassesThatSpreadThemAndTheFinalPictureAreNamed)
{
	const std::filesystem::path Folder = MakeTemporaryFolder();
	std::filesystem::create_directories(Folder);
	FImage Image{96, 64, 3, std::vector<double>(96 * 64 * 3, 0.05)};
	for (int Channel = 0; Channel < 3; ++Channel)
	{
		Image.Values[static_cast<size_t>((20 * 96 + 30) * 3 + Channel)] = std::numeric_limits<double>::infinity();
	}
	WriteExr((Folder / "inf.exr").string(), Image, {"R", "G", "B"});
	FRunOptions Options;
	Options.ConfigFile = (Folder / "a.json").string();
	Options.ConfigText = R"({"scene": {"file": "inf.exr"}})";
	Options.Dump = {"*"};
	const FRunResult Result = RunConfig(Options);
	Options.Variables = {"r.Drydock.NonFinite=1"};
	const FRunResult Zeroed = RunConfig(Options);

	// The largest share among the textures that passes wrote, counted in the dumps.
	double Largest = 0.0;
	std::string Pass;
	for (const FRunDump& Dump : Result.Dumps)
	{
		const FImage Image = Dump.Image.ToImage();
		const size_t NumChannels = static_cast<size_t>(Image.NumChannels);
		size_t NumBad = 0, NumPixels = Image.Values.size() / NumChannels;
		for (size_t Pixel = 0; Pixel < NumPixels; ++Pixel)
		{
			const double* const Values = &Image.Values[Pixel * NumChannels];
			NumBad +=
				std::all_of(Values, Values + NumChannels, [](double Value) { return std::isfinite(Value); }) ? 0 : 1;
		}
		const double Share = static_cast<double>(NumBad) / static_cast<double>(NumPixels);
		Pass = Dump.PassIndex > 0 && Share > Largest ? Dump.Pass : Pass;
		Largest = Dump.PassIndex > 0 ? std::max(Largest, Share) : Largest;
	}
	ASSERT_FALSE(Result.NonFinite.Passes.empty());
	EXPECT_EQ(Pass, Result.NonFinite.Passes.back().Pass);
	EXPECT_EQ(Largest, Result.NonFinite.Passes.back().GetShare());
	EXPECT_GT(Largest, 0.5); // bloom

	uint64_t NumChanged = 0, NumWhite = 0;
	const FImage ResultFinal = Result.Final.ToImage();
	const FImage ZeroedFinal = Zeroed.Final.ToImage();
	for (size_t Pixel = 0; Pixel < 96 * 64; ++Pixel)
	{
		const double* const A = &ResultFinal.Values[4 * Pixel];
		const double* const B = &ZeroedFinal.Values[4 * Pixel];
		NumChanged += std::equal(A, A + 4, B) ? 0 : 1;
		NumWhite += A[0] == 1.0 && A[1] == 1.0 && A[2] == 1.0 && B[0] < 1.0 ? 1 : 0; // grey: all three or none
	}
	ASSERT_TRUE(Result.NonFinite.Final.has_value());
	EXPECT_EQ(96u * 64u, Result.NonFinite.Final->NumPixels);
	EXPECT_EQ(NumChanged, Result.NonFinite.Final->Changed);
	EXPECT_EQ(NumWhite, Result.NonFinite.Final->White);
	EXPECT_EQ(0u, Result.NonFinite.Final->NotFinite);
	const FDiagnostic& Said = Result.Diagnostics.back();
	EXPECT_EQ(WarnNonFiniteSpread, Said.Code);
	EXPECT_NE(std::string::npos, Said.Message.find(Pass)) << Said.Message;
	EXPECT_NE(std::string::npos, Said.Message.find(" " + std::to_string(NumWhite) + " (")) << Said.Message;

	EXPECT_TRUE(Zeroed.NonFinite.Passes.empty());
	EXPECT_FALSE(Zeroed.NonFinite.Final.has_value());
	std::filesystem::remove_all(Folder);
}

TEST(RunNonFinite, ThoseOfDepthVelocityAndMasksAreNamedAndFollowedToTheFinalPicture)
{
	const std::filesystem::path Folder = MakeTemporaryFolder();
	std::filesystem::create_directories(Folder);
	constexpr double Infinity = std::numeric_limits<double>::infinity();
	const std::vector<std::string> Names = {"R", "G", "B", "Z", "velocity.X", "velocity.Y", "custommask.B"};
	FImage Image{96, 64, 7, {}};
	for (int Pixel = 0; Pixel < 96 * 64; ++Pixel)
	{
		const double Grey = 0.1 * (Pixel % 96 / 8 % 2);
		Image.Values.insert(Image.Values.end(), {Grey, Grey, Grey, 2.0, 4.0, 0.0, 0.5});
	}
	const auto At = [&Image](int X, int Y, int Channel) -> double&
	{
		return Image.Values[static_cast<size_t>((Y * 96 + X) * 7 + Channel)];
	};
	At(90, 60, 3) = Infinity; // where nothing is
	WriteExr((Folder / "sound.exr").string(), Image, Names);
	At(30, 20, 3) = std::nan("");
	At(31, 20, 3) = -Infinity;
	At(40, 22, 5) = Infinity;
	At(50, 24, 6) = std::nan("");
	WriteExr((Folder / "nan.exr").string(), Image, Names);
	FRunOptions Options;
	Options.ConfigFile = (Folder / "a.json").string();
	const auto Choose = [&Options](const std::string& File)
	{
		Options.ConfigText =
			R"({"scene": {"file": ")" + File + R"(", "channels": {"depth.Z": "Z"}}, "camera": {"Settings": {
			"DepthOfFieldFocalDistance": 100, "DepthOfFieldFstop": 1, "DepthOfFieldSensorWidth": 200, "MotionBlurAmount": 0.5,
			"CharaGlowArea": 3, "CharaGlowColor": [1, 1, 1, 1]}}})";
	};
	const auto GetWarnings = [&Folder](const FRunResult& Result)
	{
		std::vector<std::string> Warnings;
		for (const FDiagnostic& Diagnostic : Result.Diagnostics)
		{
			if (Diagnostic.Severity == ESeverity::Warning && Diagnostic.Code == WarnNonFinite)
			{
				EXPECT_EQ((Folder / "nan.exr").string(), Diagnostic.File);
				Warnings.push_back(Diagnostic.Where + ": " + Diagnostic.Message);
			}
		}
		return Warnings;
	};
	Choose("sound.exr");
	EXPECT_TRUE(GetWarnings(RunConfig(Options)).empty());

	Choose("nan.exr");
	const FRunResult Result = RunConfig(Options);
	EXPECT_EQ((std::vector<std::string>{"channel Z: 2 values are NaN or infinite, first at pixel (30, 20)",
				  "channel custommask.B: 1 value is NaN or infinite, first at pixel (50, 24)",
				  "channel velocity.Y: 1 value is NaN or infinite, first at pixel (40, 22)"}),
		GetWarnings(Result));
	EXPECT_EQ(WarnNonFiniteSpread, Result.Diagnostics.back().Code);
	EXPECT_EQ("channel Z, channel custommask.B, channel velocity.Y", Result.Diagnostics.back().Where);
	ASSERT_TRUE(Result.NonFinite.Final.has_value());
	EXPECT_GT(Result.NonFinite.Final->Changed, 0u);

	Options.Variables = {"r.Drydock.NonFinite=1"};
	const FRunResult Zeroed = RunConfig(Options);
	EXPECT_EQ(3u, GetWarnings(Zeroed).size());
	EXPECT_TRUE(Zeroed.NonFinite.Passes.empty());
	Options.Variables = {"r.Drydock.NonFinite=2"};
	EXPECT_EQ("4002 1", ErrorOf(Options));
	std::filesystem::remove_all(Folder);
}

TEST(RunNonFinite, DepthIsMendedByWhatLiesBesideIt)
{
	const std::filesystem::path Folder = MakeTemporaryFolder();
	std::filesystem::create_directories(Folder);
	FImage Image{96, 64, 4, {}};
	for (int Pixel = 0; Pixel < 96 * 64; ++Pixel)
	{
		const double Grey = 0.1 * (Pixel % 96 / 8 % 2);
		Image.Values.insert(Image.Values.end(), {Grey, Grey, Grey, Pixel % 96 < 48 ? 1.0 : 9.0});
	}
	const auto Run = [&](const char* Policy)
	{
		WriteExr((Folder / "a.exr").string(), Image, {"R", "G", "B", "depth.Z"});
		FRunOptions Options;
		Options.ConfigFile = (Folder / "a.json").string();
		Options.ConfigText = R"({"scene": {"file": "a.exr"}, "camera": {"Settings": {
			"DepthOfFieldFocalDistance": 100, "DepthOfFieldFstop": 1, "DepthOfFieldSensorWidth": 200}}})";
		Options.Variables = {std::string("r.Drydock.NonFinite=") + Policy};
		return RunConfig(Options);
	};
	const FImage Sound = Run("2").Final.ToImage();
	for (int Pixel = 0; Pixel < 16 * 12; ++Pixel)
	{
		Image.Values[static_cast<size_t>(((20 + Pixel / 16) * 96 + 24 + Pixel % 16) * 4 + 3)] = std::nan("");
	}
	Image.Values[(21 * 96 + 95) * 4 + 3] = -std::numeric_limits<double>::infinity();
	EXPECT_EQ(Sound.Values, Run("1").Final.ToImage().Values);

	// A run reports the final picture's distance to that of a sound frame.
	const FRunResult Result = Run("0");
	const FImage Final = Result.Final.ToImage();
	uint64_t NumChanged = 0;
	for (size_t Pixel = 0; Pixel < 96 * 64; ++Pixel)
	{
		NumChanged +=
			std::equal(&Sound.Values[4 * Pixel], &Sound.Values[4 * Pixel] + 4, &Final.Values[4 * Pixel]) ? 0 : 1;
	}
	EXPECT_GT(NumChanged, 0u);
	EXPECT_EQ(NumChanged, Result.NonFinite.Final->Changed);

	// None within reach: infinitely far, as where nothing is.
	for (int Pixel = 0; Pixel < 96 * 64; ++Pixel)
	{
		Image.Values[static_cast<size_t>(Pixel * 4 + 3)] = std::nan("");
	}
	const FImage Lost = Run("1").Final.ToImage();
	for (int Pixel = 0; Pixel < 96 * 64; ++Pixel)
	{
		Image.Values[static_cast<size_t>(Pixel * 4 + 3)] = std::numeric_limits<double>::infinity();
	}
	EXPECT_EQ(Run("2").Final.ToImage().Values, Lost.Values); // and not an error
	std::filesystem::remove_all(Folder);
}

TEST(RunNonFinite, SceneColorClampCutsSpikesAndInfinitiesOnly)
{
	const std::filesystem::path Folder = MakeTemporaryFolder();
	std::filesystem::create_directories(Folder);
	FImage Image{32, 16, 4, std::vector<double>(32 * 16 * 4, 0.5)};
	const auto At = [](int X, int Y, int Channel)
	{
		return static_cast<size_t>((Y * 32 + X) * 4 + Channel);
	};
	Image.Values[At(9, 7, 0)] = 60000.0; // a spike of a resolve
	Image.Values[At(9, 7, 1)] = 10.0;
	Image.Values[At(9, 7, 2)] = -20.0; // its ring
	Image.Values[At(9, 7, 3)] = 20.0;
	Image.Values[At(10, 7, 0)] = std::numeric_limits<double>::infinity();
	Image.Values[At(10, 7, 1)] = std::nan("");
	WriteExr((Folder / "spike.exr").string(), Image, {"R", "G", "B", "A"});
	FRunOptions Options;
	Options.ConfigFile = (Folder / "a.json").string();
	Options.ConfigText = R"({"scene": {"file": "spike.exr"}})";
	const auto Color = [](const FRunResult& Result, int X)
	{
		return std::vector<double>{Result.SceneLinear.Get(X, 7, 0), Result.SceneLinear.Get(X, 7, 1),
			Result.SceneLinear.Get(X, 7, 2), Result.SceneLinear.Get(X, 7, 3)};
	};
	EXPECT_EQ((std::vector<double>{60000.0, 10.0, -20.0, 20.0}), Color(RunConfig(Options), 9));

	Options.Variables = {"r.Drydock.SceneColorClamp=10"};
	const FRunResult Clamped = RunConfig(Options);
	EXPECT_EQ((std::vector<double>{10.0, 10.0, -10.0, 20.0}), Color(Clamped, 9));
	EXPECT_EQ(10.0, Color(Clamped, 10)[0]);
	EXPECT_TRUE(std::isnan(Color(Clamped, 10)[1]));
	EXPECT_EQ("1 value is NaN or infinite, first at pixel (10, 7)", Clamped.Diagnostics[0].Message);

	// Clamp first, then the policy: infinity is cut off, NaN is zeroed.
	Options.Variables = {"r.Drydock.SceneColorClamp=10", "r.Drydock.NonFinite=1"};
	EXPECT_EQ((std::vector<double>{10.0, 0.0, 0.5, 0.5}), Color(RunConfig(Options), 10));
	Options.Variables = {"r.Drydock.SceneColorClamp=-3"}; // off
	EXPECT_EQ((std::vector<double>{60000.0, 10.0, -20.0, 20.0}), Color(RunConfig(Options), 9));
	std::filesystem::remove_all(Folder);
}
