// One infinite pixel in a whole frame: the share of the final picture that it turns white, as a run says it and as the
// bloom's footprint gives it by plain loops.
#include <gtest/gtest.h>

#include "WholeFrame.h"

#include "Run/Run.h"
#include "Text/ConfigErrors.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <vector>

#include <unistd.h>

using namespace Drydock;

namespace
{

const std::string Scenes = DRYDOCK_TEST_SOURCE_DIR "/configs/scenes/";

/** toon_character's colour with one infinite pixel, in a folder of this test. */
class FInfiniteScene
{
public:
	FInfiniteScene()
		: Folder(std::filesystem::temp_directory_path() / ("drydock_infinite_" + std::to_string(getpid())))
	{
		FImageFile File(Scenes + "toon_character.exr");
		const std::vector<std::vector<float>> Planes =
			File.Read({File.FindChannel("R"), File.FindChannel("G"), File.FindChannel("B")});
		Image = {File.GetWidth(), File.GetHeight(), 3, {}};
		for (size_t Pixel = 0; Pixel < Planes[0].size(); ++Pixel)
		{
			for (const std::vector<float>& Plane : Planes)
			{
				Image.Values.push_back(static_cast<double>(Plane[Pixel]));
			}
		}
		const size_t Bad = static_cast<size_t>(Stability::InfinitePixelY * Image.Width + Stability::InfinitePixelX);
		std::fill_n(
			Image.Values.begin() + static_cast<std::ptrdiff_t>(3 * Bad), 3, std::numeric_limits<double>::infinity());
		std::filesystem::create_directories(Folder);
		WriteExr((Folder / "infinite.exr").string(), Image, {"R", "G", "B"});
	}
	~FInfiniteScene() { std::filesystem::remove_all(Folder); }

	FRunResult Run(const std::vector<std::string>& Variables = {}) const
	{
		FRunOptions Options;
		Options.ConfigFile = (Folder / "infinite.json").string();
		Options.ConfigText = R"({"scene": {"file": "infinite.exr"}})";
		Options.Variables = Variables;
		return RunConfig(Options);
	}

	FImage Image;

private:
	const std::filesystem::path Folder;
};

bool IsWhite(const FImage& Image, int X, int Y)
{
	return Image.Get(X, Y, 0) >= 1.0 && Image.Get(X, Y, 1) >= 1.0 && Image.Get(X, Y, 2) >= 1.0;
}

/** Which texels are infinite. */
struct FMask
{
	int Width = 0;
	int Height = 0;
	std::vector<char> Texels;

	FMask(int InWidth, int InHeight)
		: Width(InWidth)
		, Height(InHeight)
		, Texels(static_cast<size_t>(InWidth * InHeight))
	{
	}
	bool Get(int X, int Y) const
	{
		X = std::clamp(X, 0, Width - 1);
		Y = std::clamp(Y, 0, Height - 1);
		return Texels[static_cast<size_t>(Y * Width + X)] != 0;
	}

	/** Whether a bilinear tap at a position of texels mixes an infinite one in: positions are whole 1/256, and a texel
	 * that weighs nothing is not in the mix. */
	bool Sample(double X, double Y) const
	{
		const double SnappedX = std::floor(X * 256 + 0.5) / 256 - 0.5, SnappedY = std::floor(Y * 256 + 0.5) / 256 - 0.5;
		const int Left = static_cast<int>(std::floor(SnappedX)), Top = static_cast<int>(std::floor(SnappedY));
		const int NumX = SnappedX > Left ? 2 : 1, NumY = SnappedY > Top ? 2 : 1;
		bool bFound = false;
		for (int Index = 0; Index < NumX * NumY; ++Index)
		{
			bFound = bFound || Get(Left + Index % NumX, Top + Index / NumX);
		}
		return bFound;
	}

	static FMask Make(int Width, int Height, const std::function<bool(int X, int Y)>& Is)
	{
		FMask Mask(Width, Height);
		for (int Y = 0; Y < Height; ++Y)
		{
			for (int X = 0; X < Width; ++X)
			{
				Mask.Texels[static_cast<size_t>(Y * Width + X)] = Is(X, Y) ? 1 : 0;
			}
		}
		return Mask;
	}
};

/** Half the size: one tap at the centre, or four around it. */
FMask Halve(const FMask& Mask, bool bFourTaps)
{
	const int Width = (Mask.Width + 1) / 2, Height = (Mask.Height + 1) / 2;
	return FMask::Make(Width, Height,
		[&](int X, int Y)
		{
			const double AtX = (X + 0.5) * Mask.Width / Width, AtY = (Y + 0.5) * Mask.Height / Height;
			return bFourTaps ? Mask.Sample(AtX - 1, AtY - 1) || Mask.Sample(AtX + 1, AtY - 1) ||
								   Mask.Sample(AtX - 1, AtY + 1) || Mask.Sample(AtX + 1, AtY + 1)
							 : Mask.Sample(AtX, AtY);
		});
}

/** Offsets of the taps of a kernel exp(-16.7 (x / R)^2), two texels to a tap from -Reach up. */
std::vector<double> MakeTaps(double Radius)
{
	const double Clamped = std::min(Radius, 31.0);
	const int Reach = static_cast<int>(std::ceil(Clamped));
	std::vector<double> Offsets;
	for (int Texel = -Reach; Texel <= Reach; Texel += 2)
	{
		const auto Weigh = [&](int At)
		{
			return At > Reach ? 0.0 : std::exp(-16.7 * (At / Clamped) * (At / Clamped));
		};
		Offsets.push_back(Texel + Weigh(Texel + 1) / (Weigh(Texel) + Weigh(Texel + 1)));
	}
	return Offsets;
}

/** One direction of the blur to a picture of Width; outside lies black. */
FMask Blur(const FMask& Mask, int Width, const std::vector<double>& Taps, bool bAlongX)
{
	return FMask::Make(Width, Mask.Height,
		[&](int X, int Y)
		{
			return std::any_of(Taps.begin(), Taps.end(),
				[&](double Offset)
				{
					const double AtX = (X + 0.5) * Mask.Width / Width + (bAlongX ? Offset : 0.0);
					const double AtY = Y + 0.5 + (bAlongX ? 0.0 : Offset);
					const double SnappedX = std::floor(AtX * 256 + 0.5) / 256,
								 SnappedY = std::floor(AtY * 256 + 0.5) / 256;
					// A whole texel beyond the edge nothing of it is mixed in.
					return SnappedX > -0.5 && SnappedX < Mask.Width + 0.5 && SnappedY > -0.5 &&
						   SnappedY < Mask.Height + 0.5 && Mask.Sample(AtX, AtY);
				});
		});
}

/** Where the picture is white for an infinite pixel: bloom at its defaults, no threshold. */
FMask FindFlooded(int Width, int Height, int BadX, int BadY)
{
	const FMask Scene = FMask::Make(Width, Height, [&](int X, int Y) { return X == BadX && Y == BadY; });
	std::vector<FMask> Levels = {Halve(Scene, false)};
	while (Levels.size() < 6)
	{
		Levels.push_back(Halve(Levels.back(), true));
	}
	const double Sizes[] = {0.3, 1, 2, 10, 30, 64}; // percent of the width, times 4
	FMask Sum(1, 1);
	for (size_t Level = 6; Level-- > 0;)
	{
		const FMask& Source = Levels[Level];
		const double Radius = Source.Width * Sizes[Level] * 4 / 200;
		const std::vector<double> Taps = MakeTaps(Radius);
		const int Across = Radius >= 7 ? (Source.Width + 1) / 2 : Source.Width; // r.FastBlurThreshold
		const FMask Horizontal = Blur(Source, Across, Taps, true);
		const FMask Vertical = Blur(Horizontal, Source.Width, Taps, false);
		Sum = FMask::Make(Source.Width, Source.Height,
			[&](int X, int Y)
			{
				return Vertical.Get(X, Y) ||
					   Sum.Sample((X + 0.5) * Sum.Width / Source.Width, (Y + 0.5) * Sum.Height / Source.Height);
			});
	}
	return FMask::Make(Width, Height,
		[&](int X, int Y)
		{ return Scene.Get(X, Y) || Sum.Sample((X + 0.5) * Sum.Width / Width, (Y + 0.5) * Sum.Height / Height); });
}

} // namespace

TEST(WholeFrame, OneInfinitePixelTurnsTheStatedShareWhite)
{
	const FInfiniteScene Scene;
	const FRunResult Result = Scene.Run();
	const FRunResult Zeroed = Scene.Run({"r.Drydock.NonFinite=1"});
	const FMask Flooded =
		FindFlooded(Scene.Image.Width, Scene.Image.Height, Stability::InfinitePixelX, Stability::InfinitePixelY);
	const FImage Final = Result.Final.ToImage(), FinalAnyway = Zeroed.Final.ToImage();
	uint64_t NumWhite = 0, NumFlooded = 0, NumOthers = 0, NumPixels = 0;
	for (int Y = 0; Y < Final.Height; ++Y)
	{
		for (int X = 0; X < Final.Width; ++X, ++NumPixels)
		{
			const bool bWhite = IsWhite(Final, X, Y), bWhiteAnyway = IsWhite(FinalAnyway, X, Y);
			NumWhite += bWhite && !bWhiteAnyway ? 1 : 0;
			NumFlooded += Flooded.Get(X, Y) && !bWhiteAnyway ? 1 : 0;
			NumOthers += Flooded.Get(X, Y) != bWhite && !bWhiteAnyway ? 1 : 0;
		}
	}
	EXPECT_EQ(NumFlooded, NumWhite);
	EXPECT_EQ(0u, NumOthers);
	EXPECT_NEAR(Stability::ShareTurnedWhite, static_cast<double>(NumWhite) / static_cast<double>(NumPixels), 0.005)
		<< "docs/stability.md says it";
	ASSERT_TRUE(Result.NonFinite.Final.has_value());
	EXPECT_EQ(NumWhite, Result.NonFinite.Final->White);
	EXPECT_EQ(0u, Result.NonFinite.Final->NotFinite);
	EXPECT_EQ(WarnNonFiniteSpread, Result.Diagnostics.back().Code);
}
