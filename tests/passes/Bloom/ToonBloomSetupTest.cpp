// Toon bloom in the bloom setup: corrected and as printed, on images computed by hand, against an independent double
// computation, and its hazards.
#include "ToonBloomRun.h"

#include "Bloom/PostProcessGaussianBloom.h"

#include <cstring>

using namespace Drydock;

using namespace PassTest;
using PassReference::CeilHalf;
using PassReference::MaxDifference;

namespace
{

FImage SetUpBloom(
	const FImage& Color, const FImage& Ids, const FToon& Toon, EArithmetic Arithmetic = EArithmetic::Float32)
{
	FToonRun Run(Color, Ids, {0, 0, Color.Width, Color.Height}, FIntPoint(Color.Width, Color.Height), Toon, Arithmetic);
	return Run.Run.Execute(Run.AddSetup());
}

/** The bloom that comes of it. */
FImage Bloom(const FImage& Color, const FImage& Ids, const FToon& Toon)
{
	FToonRun Run(
		Color, Ids, {0, 0, Color.Width, Color.Height}, FIntPoint(Color.Width, Color.Height), Toon, EArithmetic::Double);
	FTextureDownsampleChain Chain;
	Chain.Init(Run.Run.GraphBuilder, Run.Run.View, Run.AddSetup(), EDownsampleQuality::High, TEXT("Chain"));
	return Run.Run.Execute(AddGaussianBloomPasses(Run.Run.GraphBuilder, Run.Run.View, &Chain));
}

/** From the formula: colour times factor, downsampled; the ramp of the unmasked colour. */
FImage Expected(const FImage& Color, const FImage& Ids, const FToon& Toon)
{
	const FRect In{0, 0, Color.Width, Color.Height};
	const FRect Out{0, 0, CeilHalf(Color.Width), CeilHalf(Color.Height)};
	const bool bHigh = Toon.Quality == EDownsampleQuality::High;
	const FImage Masked = FImage::Make(Color.Width, Color.Height,
		[&](int X, int Y)
		{ return Color.At(X, Y) * (Ids.At(X, Y)[0] == Cloth ? static_cast<double>(*Toon.Factor) : 1.0); });
	const FImage Half = PassReference::Downsample(Color, In, Out, bHigh, true);
	const FImage MaskedHalf = PassReference::Downsample(Masked, In, Out, bHigh, true);
	return FImage::Make(Out.Width(), Out.Height(),
		[&](int X, int Y)
		{
			const double Luminance = PassReference::Luminance(Half.At(X, Y));
			const double Threshold = static_cast<double>(Toon.Threshold);
			const double Amount = Threshold > -1 ? std::clamp((Luminance - Threshold) / 2, 0.0, 1.0) : 1.0;
			FTexel Texel = MaskedHalf.At(X, Y) * Amount;
			Texel[3] = 0;
			return Texel;
		});
}

std::vector<double> Reds(const FImage& Image)
{
	std::vector<double> Values;
	for (const FTexel& Texel : Image.Texels)
	{
		Values.push_back(Texel[0]);
	}
	return Values;
}

FTexel SetUpToonPixel(const FTexel& Color, float Factor, float Threshold = -1.0f)
{
	return SetUpBloom(FImage(2, 2, Color), FImage(2, 2, {Cloth, 0, 0, 0}), {Factor, Threshold}).At(0, 0);
}

/** The left third is toon; noise exact in every format. */
struct FToonScene
{
	FImage Color = FImage::Noise(64, 36, 4);
	FImage Ids = MakeIds(64, 36, [](int X, int) { return X < 21; });
};

class ToonBloomReference : public testing::TestWithParam<EArithmetic>
{
};

} // namespace

TEST(ToonBloomSetup, AnEdgeWeighsWhatItCovers)
{
	// 8 * (2 * 0.25 + 2) / 4 = 5, 8 * 0.25 = 2, 8, and 8 * (0.25 + 3) / 4 = 6.5.
	EXPECT_EQ((std::vector<double>{5, 2, 8, 6.5}), Reds(SetUpBloom(Grey(4, 4, 8), QuadIds(), {0.25f})));
}

TEST(ToonBloomSetup, AsPrintedTakesTheTexelAtTheLowerRightOfTheCorner)
{
	// The ids at (1, 1), (3, 1), (1, 3) and (3, 3): toon, toon, not, toon.
	FToon Toon{0.25f};
	Toon.bAsPrinted = true;
	EXPECT_EQ((std::vector<double>{2, 2, 8, 2}), Reds(SetUpBloom(Grey(4, 4, 8), QuadIds(), Toon)));
}

TEST(ToonBloomSetup, AsPrintedIsLostInCompute)
{
	FToon Toon{0.25f};
	Toon.bAsPrinted = true;
	Toon.bCompute = true;
	EXPECT_EQ((std::vector<double>{8, 8, 8, 8}), Reds(SetUpBloom(Grey(4, 4, 8), QuadIds(), Toon)));
}

TEST(ToonBloomSetup, AsPrintedMultipliesWhatTheSetupGives)
{
	// Luminance 2 above a threshold of 1: half of it, then the factor.
	FToon Toon{0.25f, 1.0f};
	Toon.bAsPrinted = true;
	EXPECT_EQ((std::vector<double>{0.25, 0.25, 1, 0.25}), Reds(SetUpBloom(Grey(4, 4, 2), QuadIds(), Toon)));
}

TEST(ToonBloomSetup, TheRampIsThatOfTheUnmaskedColour)
{
	// Luminance 2 above a threshold of 1 keeps half, whatever the factor makes of the colour.
	const std::vector<double> Halved = Reds(SetUpBloom(Grey(4, 4, 2), QuadIds(), {0.25f, 1.0f}));
	const std::vector<double> Expected = {2 * 0.625 / 2, 2 * 0.25 / 2, 1, 2 * 0.8125 / 2};
	for (size_t Quad = 0; Quad < Expected.size(); ++Quad)
	{
		EXPECT_FLOAT_EQ(static_cast<float>(Expected[Quad]), static_cast<float>(Halved[Quad]));
	}
}

TEST(ToonBloomSetup, OnlyClothIsToon)
{
	for (int Id = 0; Id < 16; ++Id)
	{
		EXPECT_EQ(Id == 8 ? 2 : 8,
			SetUpBloom(Grey(2, 2, 8), FImage(2, 2, {static_cast<double>(Id), 0, 0, 0}), {0.25f}).At(0, 0)[0])
			<< Id;
	}
}

TEST(ToonBloomSetup, TheSelectiveOutputMaskDoesNotHideTheId)
{
	EXPECT_EQ(2, SetUpBloom(Grey(2, 2, 8), FImage(2, 2, {0xF0 | 8, 0, 0, 0}), {0.25f}).At(0, 0)[0]);
}

TEST(ToonBloomSetup, FactorOneGivesTheBitsOfAFrameWithoutTheSetup)
{
	const FToonScene Scene;
	for (const EArithmetic Arithmetic : {EArithmetic::Native, EArithmetic::Double})
	{
		FToon Toon{1.0f};
		Toon.Format = PF_FloatRGB;
		Toon.PreExposure = 0.3f;
		FToonRun Run(Scene.Color, Scene.Ids, {0, 0, 64, 36}, FIntPoint(64, 36), Toon, Arithmetic);
		const FScreenPassTexture Output = Run.AddSetup();
		TRefCountPtr<IPooledRenderTarget> Half;
		Run.Run.GraphBuilder.QueueTextureExtraction(Run.Half.Texture, &Half);
		const FImage Result = Run.Run.Execute(Output);
		EXPECT_EQ(0, MaxDifference(ReadTexture(Half->GetRHI()), Result)) << ToString(Arithmetic);
	}
}

TEST(ToonBloomSetup, FactorOneGivesTheBitsOfTheSetupWithoutThePatch)
{
	const FToonScene Scene;
	for (const EArithmetic Arithmetic : {EArithmetic::Native, EArithmetic::Double})
	{
		EXPECT_EQ(SetUpBloom(Scene.Color, Scene.Ids, {std::nullopt, 0.75f}, Arithmetic).Texels,
			SetUpBloom(Scene.Color, Scene.Ids, {1.0f, 0.75f}, Arithmetic).Texels)
			<< ToString(Arithmetic);
	}
}

TEST(ToonBloomSetup, FactorOneGivesThoseBitsWithLocalExposureAndBeyondTheClamp)
{
	const FToonScene Scene;
	FImage Color = Scene.Color;
	const double Hard[] = {Infinity, NaN, 1e6, 70000, -3, 65536};
	for (size_t Index = 0; Index < Color.Texels.size(); Index += 7)
	{
		Color.Texels[Index][Index % 3] = Hard[Index / 7 % std::size(Hard)];
	}
	for (const int Case : {0, 1, 2, 3})
	{
		const FScopedConsoleVariable Native(TEXT("r.Drydock.NativeKernels"), Case % 2);
		FToon Toon{std::nullopt, Case < 2 ? -1.0f : 0.75f};
		Toon.PreExposure = 0.6f;
		Toon.bLocalExposure = true;
		const FImage Without = SetUpBloom(Color, Scene.Ids, Toon);
		Toon.Factor = 1.0f;
		EXPECT_EQ(0, MaxDifference(Without, SetUpBloom(Color, Scene.Ids, Toon))) << Case;
	}
}

TEST(ToonBloomSetup, TexelsThatNoToonReachesHaveTheSameBitsForAllFactors)
{
	const FToonScene Scene;
	for (const float Threshold : {-1.0f, 0.75f})
	{
		const FImage Unmasked = SetUpBloom(Scene.Color, Scene.Ids, {1.0f, Threshold}, EArithmetic::Native);
		for (const float Factor : {0.0f, 0.1f, 0.675f, 3.0f})
		{
			const FImage Masked = SetUpBloom(Scene.Color, Scene.Ids, {Factor, Threshold}, EArithmetic::Native);
			// Pixels 0 to 20 are toon: texels 0 to 10 hold some.
			EXPECT_EQ(PassReference::Crop(Unmasked, {11, 0, 32, 18}).Texels,
				PassReference::Crop(Masked, {11, 0, 32, 18}).Texels)
				<< Factor;
			EXPECT_NE(Unmasked.At(10, 4), Masked.At(10, 4)) << Factor;
		}
	}
}

TEST(ToonBloomSetup, BloomIsLinearInTheFactor)
{
	const FToonScene Scene;
	for (const float Threshold : {-1.0f, 0.75f})
	{
		const FImage Zero = Bloom(Scene.Color, Scene.Ids, {0.0f, Threshold});
		const FImage One = Bloom(Scene.Color, Scene.Ids, {1.0f, Threshold});
		for (const float Factor : {0.1f, 0.675f, 4.0f})
		{
			const FImage Actual = Bloom(Scene.Color, Scene.Ids, {Factor, Threshold});
			for (size_t Index = 0; Index < Actual.Texels.size(); ++Index)
			{
				const double Linear = Zero.Texels[Index][1] +
									  static_cast<double>(Factor) * (One.Texels[Index][1] - Zero.Texels[Index][1]);
				ASSERT_NEAR(1.0, Actual.Texels[Index][1] / Linear, 1e-6) << Factor << " at " << Index;
			}
		}
	}
}

TEST(ToonBloomSetup, AllToonIsTheBloomTimesTheFactor)
{
	const FImage Color = FImage::Noise(16, 8, 4);
	const FImage All(16, 8, {Cloth, 0, 0, 0});
	const FImage Quarter = SetUpBloom(Color, All, {0.25f});
	FImage Expected = SetUpBloom(Color, All, {std::nullopt});
	for (FTexel& Texel : Expected.Texels)
	{
		Texel = Texel * 0.25;
	}
	EXPECT_EQ(0, MaxDifference(Expected, Quarter));
}

TEST_P(ToonBloomReference, EverySizeQualityAndThreshold)
{
	for (const auto& [Width, Height] : {std::pair(64, 36), {41, 23}, {1, 1}, {1, 9}, {7, 1}, {3, 5}})
	{
		for (FToon Toon : {FToon{0.0f}, {0.1f}, {0.675f, 0.5f}, {2.5f, 1.0f}})
		{
			for (const EDownsampleQuality Quality : {EDownsampleQuality::Low, EDownsampleQuality::High})
			{
				Toon.Quality = Quality;
				const FImage Color = FImage::Noise(Width, Height, 4);
				const FImage Ids = MakeIds(Width, Height, [](int X, int Y) { return (X / 3 + Y / 2) % 2 == 0; });
				// Values to 10: an ulp of 8 for each of the dozen operations on the way; halves keep 11 bits.
				const double Tolerance = GetParam() == EArithmetic::Native ? 1e-5 : 8e-6;
				EXPECT_LE(
					MaxDifference(Expected(Color, Ids, Toon), SetUpBloom(Color, Ids, Toon, GetParam()), 4), Tolerance)
					<< Width << "x" << Height << " factor " << *Toon.Factor << " threshold " << Toon.Threshold;
			}
		}
	}
}

INSTANTIATE_TEST_SUITE_P(Arithmetic, ToonBloomReference, testing::ValuesIn(SnappedArithmetic), FArithmeticName());

TEST(ToonBloomSetup, ComputeAndPixelShaderGiveTheSameBits)
{
	const FToonScene Scene;
	for (const float Threshold : {-1.0f, 0.75f})
	{
		FToon Compute{0.1f, Threshold};
		Compute.bCompute = true;
		EXPECT_EQ(SetUpBloom(Scene.Color, Scene.Ids, {0.1f, Threshold}, EArithmetic::Native).Texels,
			SetUpBloom(Scene.Color, Scene.Ids, Compute, EArithmetic::Native).Texels);
	}
}

TEST(ToonBloomSetup, PreExposureChangesTheUnitsOnly)
{
	const FToonScene Scene;
	FImage Brighter = Scene.Color;
	for (FTexel& Texel : Brighter.Texels)
	{
		Texel = Texel * 4;
	}
	FToon Toon{0.25f, 0.75f};
	FImage Expected = SetUpBloom(Scene.Color, Scene.Ids, Toon);
	for (FTexel& Texel : Expected.Texels)
	{
		Texel = Texel * 4;
	}
	Toon.PreExposure = 4.0f;
	EXPECT_EQ(0, MaxDifference(Expected, SetUpBloom(Brighter, Scene.Ids, Toon)));
}

TEST(ToonBloomSetup, ARectElsewhereGivesTheSameBits)
{
	// Outside, colour is NaN and everything is toon. The downsample halves the rect's corner: even.
	const FImage Color = FImage::Noise(9, 7, 4);
	const FImage Ids = MakeIds(9, 7, [](int X, int Y) { return X + Y < 6; });
	for (const bool bAsPrinted : {false, true})
	{
		FToon Toon{0.1f, 0.5f};
		Toon.bAsPrinted = bAsPrinted;
		const FImage Cropped = SetUpBloom(Color, Ids, Toon, EArithmetic::Native);
		FToonRun Run(Color, Ids, {4, 2, 13, 9}, FIntPoint(20, 12), Toon, EArithmetic::Native);
		const FImage Offset = Run.Run.Execute(Run.AddSetup());
		if (!bAsPrinted) // which takes the input's UV for the buffer's: odd extents do not agree
		{
			EXPECT_EQ(Cropped.Texels, Offset.Texels);
		}
		for (const FTexel& Texel : Offset.Texels)
		{
			EXPECT_TRUE(std::isfinite(Texel[0] + Texel[1] + Texel[2]));
		}
	}
}

TEST(ToonBloomSetup, FactorZeroMakesAnyToonBlack)
{
	for (const double Value : {Infinity, -Infinity, NaN, 65504.0})
	{
		EXPECT_EQ((FTexel{0, 0, 0, 0}), SetUpToonPixel({Value, Value, Value, 1}, 0.0f)) << Value;
		EXPECT_EQ((FTexel{0, 0, 0, 0}), SetUpToonPixel({Value, Value, Value, 1}, 0.0f, 0.0f)) << Value;
	}
}

TEST(ToonBloomSetup, BelowTheClampStrongToonKeepsItsStrength)
{
	EXPECT_EQ(480000, SetUpToonPixel({60000, 60000, 60000, 1}, 8.0f, 0.0f)[0]);
	EXPECT_EQ(8 * 65536.0, SetUpToonPixel({1e6, 1e6, 1e6, 1}, 8.0f, 0.0f)[0]);
	// Eight times infinity is infinity: clamped as if the factor were not there.
	EXPECT_EQ(65536.0, SetUpToonPixel({Infinity, Infinity, Infinity, 1}, 8.0f, 0.0f)[0]);
}

TEST(ToonBloomSetup, LargestHalfStaysFiniteBelowOne)
{
	FToon Toon{0.5f};
	Toon.Format = PF_FloatRGBA;
	EXPECT_EQ(
		32752, SetUpBloom(Grey(2, 2, 65504), FImage(2, 2, {Cloth, 0, 0, 0}), Toon, EArithmetic::Native).At(0, 0)[0]);
}

TEST(ToonBloomSetup, NonFiniteSceneStaysWithItsTexel)
{
	FImage Color = Grey(4, 4, 1);
	Color.At(0, 3)[0] = NaN;
	const FImage Result = SetUpBloom(Color, QuadIds(), {0.5f});
	EXPECT_TRUE(std::isnan(Result.At(0, 1)[0]));
	EXPECT_EQ(0.75, Result.At(0, 0)[0]);
	EXPECT_EQ(0.875, Result.At(1, 1)[0]);
}

TEST(ToonBloomSetup, NegativesAreMultipliedToo)
{
	EXPECT_EQ(-0.5, SetUpToonPixel({-2, 8, 0, 1}, 0.25f)[0]);
}

TEST(ToonBloomSetup, TheSceneTexturesColourStandsInForAMissingFullResolution)
{
	const FToonScene Scene;
	const FImage Expected = SetUpBloom(Scene.Color, Scene.Ids, {0.1f}, EArithmetic::Native);
	FToonRun Run(Scene.Color, Scene.Ids, {0, 0, 64, 36}, FIntPoint(64, 36), {0.1f}, EArithmetic::Native);
	EXPECT_EQ(Expected.Texels, Run.Run.Execute(Run.AddSetup(FScreenPassTexture())).Texels);
}

TEST(ToonBloomSetup, AnInputOfTheIdsSizeIsMaskedPixelByPixel)
{
	FToonRun Run(Grey(4, 4, 8), QuadIds(), {0, 0, 4, 4}, FIntPoint(4, 4), {0.25f}, EArithmetic::Native);
	Run.Half = Run.Run.Input;
	const FImage Result = Run.Run.Execute(Run.AddSetup(FScreenPassTexture()));
	EXPECT_EQ((std::vector<double>{2, 8, 2, 2, 8, 2, 2, 2, 8, 8, 8, 8, 8, 8, 8, 2}), Reds(Result));
}
