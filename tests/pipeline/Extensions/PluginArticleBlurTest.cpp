// The dual Kawase extension of its article as a plugin (tests/plugins/ArticleBlur), drydock's own of the same name
// beside it in one graph: each blurs as its own parameters say, as plain loops in double have it.
#include <gtest/gtest.h>

#include "Picture/ImageFile.h"
#include "Run/Run.h"

#include "passes/DualKawaseBlurReference.h"

#include <cmath>
#include <filesystem>
#include <unistd.h>

using namespace Drydock;

namespace
{

namespace Files = std::filesystem;

using FReference = PassReference::FImage;
using FTexel = PassReference::FTexel;
using PassReference::operator+;
using PassReference::operator*;

// What the plugin's module makes its extension with.
constexpr int PluginPasses = 2;
constexpr double PluginOffset = 1.5;

struct FTap
{
	double X, Y, Weight;
};

/** The texel that a point sampler with clamped addresses takes at a UV, which counts in steps of 1/256 texel. */
int GetTexel(double UV, int Size)
{
	return std::clamp(static_cast<int>(std::floor(std::floor(UV * Size * 256 + 0.5) / 256)), 0, Size - 1);
}

/** One pass of the article: taps in half pixels of what is written, times Offset. */
FReference RunPass(const FReference& In, int Width, int Height, double Offset, const std::vector<FTap>& Taps)
{
	return FReference::Make(Width, Height,
		[&](int X, int Y)
		{
			FTexel Sum = {0, 0, 0, 0};
			double Weight = 0;
			for (const FTap& Tap : Taps)
			{
				const int FromX = GetTexel((X + 0.5 + Tap.X * 0.5 * Offset) / Width, In.Width);
				const int FromY = GetTexel((Y + 0.5 + Tap.Y * 0.5 * Offset) / Height, In.Height);
				Sum = Sum + In.At(FromX, FromY) * Tap.Weight;
				Weight += Tap.Weight;
			}
			return Sum * (1 / Weight);
		});
}

/** The article's passes: down from the picture's own size, halving and doubling whole numbers. */
FReference RunArticle(FReference Picture, int NumPasses, double Offset)
{
	int Width = Picture.Width, Height = Picture.Height;
	for (int Pass = 0; Pass < NumPasses; ++Pass)
	{
		Picture = RunPass(Picture, Width, Height, Offset, {{0, 0, 4}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}});
		Width /= 2;
		Height /= 2;
	}
	for (int Pass = 0; Pass < NumPasses; ++Pass)
	{
		Width *= 2;
		Height *= 2;
		Picture = RunPass(Picture, Width, Height, Offset,
			{{-2, 0, 1}, {2, 0, 1}, {0, -2, 1}, {0, 2, 1}, {-1, -1, 2}, {1, -1, 2}, {-1, 1, 2}, {1, 1, 2}});
	}
	return Picture;
}

double GetLargestDifference(const FReference& A, const FReference& B)
{
	double Largest = 0;
	for (size_t Texel = 0; Texel < A.Texels.size(); ++Texel)
	{
		for (size_t Channel = 0; Channel < 3; ++Channel)
		{
			Largest = std::max(Largest, std::abs(A.Texels[Texel][Channel] - B.Texels[Texel][Channel]));
		}
	}
	return Largest;
}

/** Light that differs from pixel to pixel, up to 8, as a scene and as numbers. */
class PluginArticleBlur : public testing::TestWithParam<std::pair<int, int>>
{
protected:
	PluginArticleBlur()
		: Source(FReference::Noise(GetParam().first, GetParam().second, 8.0, 17))
	{
		FImage Image{Source.Width, Source.Height, 3, {}};
		for (const FTexel& Texel : Source.Texels)
		{
			Image.Values.insert(Image.Values.end(), Texel.begin(), Texel.begin() + 3);
		}
		WriteExr(Scene.string(), Image, {"R", "G", "B"});
	}
	~PluginArticleBlur() override { Files::remove(Scene); }

	FRunResult RunWith(const std::string& More) const
	{
		FRunOptions Options;
		Options.ConfigFile = Scene.string() + ".json";
		Options.ConfigText =
			R"({"scene": {"file": ")" + Scene.string() + R"("}, "showFlags": {"Bloom": false})" + More + "}";
		Options.Dump = {"ArticleUpPass", "DualKawaseUp1"};
		return RunConfig(Options);
	}

	/** What the last pass that wrote a texture of this name left. */
	static FReference FindDump(const FRunResult& Result, const std::string& Resource, int& OutPass)
	{
		FReference Picture;
		for (const FRunDump& Dump : Result.Dumps)
		{
			if (Dump.Resource == Resource)
			{
				OutPass = Dump.PassIndex;
				Picture = FReference::Make(Dump.Image.Width, Dump.Image.Height,
					[&](int X, int Y) {
						return FTexel{Dump.Image.Get(X, Y, 0), Dump.Image.Get(X, Y, 1), Dump.Image.Get(X, Y, 2), 1};
					});
			}
		}
		return Picture;
	}

	/** Up to what the half floats of as many passes round away. */
	static void ExpectSame(const FReference& Expected, const FReference& Found, int NumPasses)
	{
		ASSERT_EQ(Expected.Width, Found.Width);
		ASSERT_EQ(Expected.Height, Found.Height);
		EXPECT_LT(GetLargestDifference(Expected, Found), NumPasses * 8.0 / 2048);
	}

	const Files::path Scene = Files::temp_directory_path() / ("drydock_article_" + std::to_string(getpid()) + ".exr");
	const FReference Source;
	const std::string Plugin = R"(, "plugins": [")" DRYDOCK_TEST_BINARY_DIR R"(/lib/libArticleBlur.so"])";
	const std::string Own =
		R"(, "extensions": [{"type": "DualKawaseBlur", "pass": "MotionBlur", "Offset": 0.75, "PassNum": 1}])";
};

} // namespace

TEST_P(PluginArticleBlur, DrawsTheArticlesPicture)
{
	int Pass = 0;
	const FReference Found = FindDump(RunWith(Plugin), "ArticleUpPass", Pass);
	ExpectSame(RunArticle(Source, PluginPasses, PluginOffset), Found, 2 * PluginPasses);
	// Far from what other parameters would give, and from no blur.
	EXPECT_GT(GetLargestDifference(Found, RunArticle(Source, PluginPasses, 1.0)), 0.5);
	EXPECT_GT(GetLargestDifference(Found, RunArticle(Source, 1, PluginOffset)), 0.5);
}

TEST_P(PluginArticleBlur, DrydocksOwnBesideItBlursByItsParameters)
{
	for (const bool bAsPrinted : {false, true})
	{
		const FRunResult Result =
			RunWith(Plugin + Own + (bAsPrinted ? R"(, "cvars": {"r.DualKawase.AsPrinted": 1})" : ""));
		int PluginPass = 0, OwnPass = 0;
		const FReference OfPlugin = FindDump(Result, "ArticleUpPass", PluginPass);
		const FReference OfOwn = FindDump(Result, "DualKawaseUp1", OwnPass);
		ASSERT_GT(PluginPass, 0);
		ASSERT_GT(OwnPass, 0);
		const auto BlurOwn = [&](const FReference& In)
		{
			return bAsPrinted ? RunArticle(In, 1, 0.75) : DualKawaseReference::Blur(In, 1, 0.75);
		};
		// The one that comes second blurs what the first one drew.
		const FReference& PluginInput = PluginPass < OwnPass ? Source : OfOwn;
		const FReference& OwnInput = PluginPass < OwnPass ? OfPlugin : Source;
		ExpectSame(RunArticle(PluginInput, PluginPasses, PluginOffset), OfPlugin, 2 * PluginPasses);
		ExpectSame(BlurOwn(OwnInput), OfOwn, 2);
		EXPECT_GT(GetLargestDifference(OwnInput, OfOwn), 0.03);
	}
}

INSTANTIATE_TEST_SUITE_P(Sizes, PluginArticleBlur, testing::Values(std::pair(48, 32), std::pair(43, 27)));
