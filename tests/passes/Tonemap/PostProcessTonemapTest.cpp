// The tonemapper against the film curve in double, the engine's golden table, vignette, bloom composite, and hazards.
#include "PassTestUtils.h"
#include "ToneReference.h"

#include "RenderGraphUtils.h"
#include "Tonemap/PostProcessTonemap.h"
#include "Tonemap/TonemapLens.h"

#include <optional>

using namespace Drydock;

using namespace PassTest;
using PassReference::MaxDifference;

namespace
{

struct FTonemap
{
	float Vignette = 0.0f;
	float ExposureScale = 1.0f;
	float PreExposure = 1.0f;
	bool bCompute = false;
	bool bAlpha = false;
	EPixelFormat OutputFormat = PF_A32B32G32R32F;
	ToneReference::FFilm Film{};
	FImage Bloom{};
};

FImage Tonemap(const FImage& Image, const FTonemap& Setup = {}, EArithmetic Arithmetic = EArithmetic::Float32)
{
	FPassRun Run(Image, Arithmetic, PF_A32B32G32R32F);
	Run.View.PreExposure = Setup.PreExposure;
	Run.View.InitViewUniformBuffer(Run.Input.Texture->Desc.Extent);
	Run.View.bUseComputePasses = Setup.bCompute;
	FFinalPostProcessSettings& Settings = Run.View.FinalPostProcessSettings;
	Settings.VignetteIntensity = Setup.Vignette;
	Settings.FilmSlope = static_cast<float>(Setup.Film.Slope);
	Settings.FilmToe = static_cast<float>(Setup.Film.Toe);
	Settings.FilmShoulder = static_cast<float>(Setup.Film.Shoulder);
	Settings.FilmBlackClip = static_cast<float>(Setup.Film.BlackClip);
	Settings.FilmWhiteClip = static_cast<float>(Setup.Film.WhiteClip);
	Settings.BlueCorrection = static_cast<float>(Setup.Film.BlueCorrection);
	Settings.ExpandGamut = static_cast<float>(Setup.Film.ExpandGamut);
	Settings.ToneCurveAmount = static_cast<float>(Setup.Film.ToneCurveAmount);

	FTonemapInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(Run.GraphBuilder, Setup.ExposureScale);
	Inputs.OutputFormat = Setup.OutputFormat;
	Inputs.bWriteAlphaChannel = Setup.bAlpha;
	if (Setup.Bloom.Width > 0)
	{
		Inputs.Bloom = Run.AddInput(Setup.Bloom, PF_A32B32G32R32F, TEXT("Bloom"));
	}
	return Run.Execute(AddTonemapPass(Run.GraphBuilder, Run.View, Inputs));
}

FTexel TonemapPixel(const FTexel& Color, const FTonemap& Setup = {})
{
	return Tonemap(FImage(1, 1, Color), Setup).At(0, 0);
}

FTexel Encode(const ToneReference::FVec& Linear)
{
	return {ToneReference::EncodeSrgb(Linear[0]), ToneReference::EncodeSrgb(Linear[1]),
		ToneReference::EncodeSrgb(Linear[2]), 0};
}

FImage Expected(const FImage& Image, const ToneReference::FFilm& Film = {})
{
	return FImage::Make(Image.Width, Image.Height,
		[&](int X, int Y)
		{
			const FTexel& Color = Image.At(X, Y);
			return Encode(ToneReference::Tonemap({Color[0], Color[1], Color[2]}, Film));
		});
}

/** Saturated and dull colours from 2^-8 to 2^5. */
FImage Swatches(unsigned Seed = 3)
{
	std::mt19937 Random(Seed);
	std::uniform_real_distribution<float> Stops(-8, 5), Unit(0, 1);
	return FImage::Make(32, 24,
		[&](int, int)
		{
			const double Level = std::exp2(Stops(Random));
			const double Dullness = Unit(Random);
			const auto Channel = [&]
			{
				return static_cast<double>(static_cast<float>(Level * (Dullness + (1 - Dullness) * Unit(Random))));
			};
			const double R = Channel(), G = Channel(), B = Channel();
			return FTexel{R, G, B, 1};
		});
}

class TonemapReference : public testing::TestWithParam<EArithmetic>
{
};

} // namespace

TEST(ToneCurve, GreysMatchTheEnginesTable)
{
	const std::pair<double, double> Table[] = {{0.001, 0.000033}, {0.01, 0.001657}, {0.05, 0.024837}, {0.09, 0.064363},
		{0.18, 0.18}, {0.36, 0.401678}, {0.5, 0.518408}, {1, 0.723359}, {2, 0.861613}, {4, 0.944155}, {8, 0.989889},
		{16, 1.014185}};
	for (const auto& [In, Out] : Table)
	{
		const FTexel Result = TonemapPixel({In, In, In, 1});
		for (int Channel = 0; Channel < 3; ++Channel)
		{
			// Six printed digits, and float arithmetic through the matrices.
			EXPECT_NEAR(Out, ToneReference::DecodeSrgb(Result[Channel]), 2e-6 + 2e-6 * Out)
				<< In << " channel " << Channel;
		}
	}
}

TEST(ToneCurve, MatchPointsOfTheDefaults)
{
	const ToneReference::FFilm Film;
	EXPECT_NEAR(-0.390277, Film.ToeMatch(), 1e-6);
	EXPECT_NEAR(0.901641, Film.StraightMatch(), 1e-6);
	EXPECT_NEAR(-0.606186, Film.ShoulderMatch(), 1e-6);
}

TEST_P(TonemapReference, Colours)
{
	// Float: the log-domain curve amplifies 2^-24 relative errors by its slope, and the matrices of dark saturated
	// colours subtract; the sRGB encode has slope 13 near black. Double: float parameters (0.88 is off by 2e-8).
	const FImage Image = Swatches();
	EXPECT_LE(MaxDifference(Expected(Image), Tonemap(Image, {}, GetParam())),
		GetParam() == EArithmetic::Double ? 1e-6 : 1e-5);
}

TEST_P(TonemapReference, FilmParametersAndCorrections)
{
	const ToneReference::FFilm Films[] = {{1.1, 0.4, 0.4, 0.02, 0.1, 0, 0, 1}, {0.7, 0.9, 0.2, 0, 0, 0.6, 1, 1},
		{0.88, 0.55, 0.26, 0, 0.04, 0.6, 1, 0}, {0.88, 0.55, 0.26, 0, 0.04, 1, 0.5, 0.5}};
	for (const ToneReference::FFilm& Candidate : Films)
	{
		FTonemap Setup;
		Setup.Film = Candidate;
		const FImage Image = Swatches(5);
		// Results reach 5 where the curve is off.
		EXPECT_LE(MaxDifference(Expected(Image, Candidate), Tonemap(Image, Setup, GetParam())), 4e-5)
			<< Candidate.Toe << " amount " << Candidate.ToneCurveAmount;
	}
}

INSTANTIATE_TEST_SUITE_P(Arithmetic, TonemapReference, testing::ValuesIn(SnappedArithmetic), FArithmeticName());

TEST(Tonemap, MiddleGreyBecomesCode118)
{
	const FImage Result =
		Tonemap(FImage(1, 1, {0.18, 0.18, 0.18, 1}), {.OutputFormat = PF_B8G8R8A8}, EArithmetic::Native);
	EXPECT_NEAR(118.0 / 255, Result.At(0, 0)[0], 1e-9);
	EXPECT_NEAR(117.65 / 255, TonemapPixel({0.18, 0.18, 0.18, 1})[0], 0.01 / 255);
}

TEST(Tonemap, EightBitStoreIsTheRoundedFloat)
{
	const FImage Image = Swatches();
	const FImage Exact = Tonemap(Image), Stored = Tonemap(Image, {.OutputFormat = PF_B8G8R8A8}, EArithmetic::Native);
	EXPECT_LE(MaxDifference(FImage::Make(32, 24,
								[&](int X, int Y)
								{
									FTexel Color = Exact.At(X, Y);
									for (double& Channel : Color)
									{
										Channel = std::clamp(Channel, 0.0, 1.0);
									}
									return Color;
								}),
				  Stored),
		0.5 / 255 + 1e-6);
}

TEST_P(TonemapReference, SceneColorApplyParametersMultiplySceneColourAlone)
{
	const FImage Image = FImage::Noise(9, 7, 4.0), Bloom = FImage::Noise(9, 7, 1.0, 2);
	const auto Run = [&](const FImage& SceneColor, std::optional<FVector4f> Factor)
	{
		FPassRun PassRun(SceneColor, GetParam(), PF_A32B32G32R32F);
		FTonemapInputs Inputs;
		Inputs.SceneColor = PassRun.Input;
		Inputs.Bloom = PassRun.AddInput(Bloom, PF_A32B32G32R32F, TEXT("Bloom"));
		Inputs.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(PassRun.GraphBuilder, 1.0f);
		Inputs.OutputFormat = PF_A32B32G32R32F;
		if (Factor)
		{
			Inputs.SceneColorApplyParamaters = CreateStructuredBuffer(
				PassRun.GraphBuilder, TEXT("Factor"), sizeof(FVector4f), 1, &*Factor, sizeof(FVector4f));
		}
		return PassRun.Execute(AddTonemapPass(PassRun.GraphBuilder, PassRun.View, Inputs));
	};
	const FImage Scaled = FImage::Make(9, 7,
		[&](int X, int Y)
		{
			const FTexel& Color = Image.At(X, Y);
			return FTexel{Color[0] * 0.5, Color[1] * 0.25, Color[2], Color[3]};
		});
	EXPECT_EQ(Run(Scaled, {}).Texels, Run(Image, FVector4f(0.5f, 0.25f, 1.0f, 1.0f)).Texels);
	EXPECT_EQ(Run(Image, {}).Texels, Run(Image, FVector4f(1.0f, 1.0f, 1.0f, 1.0f)).Texels);
}

TEST(Tonemap, ComputeAndPixelShaderGiveTheSameBits)
{
	const FImage Image = Swatches();
	EXPECT_EQ(Tonemap(Image, {.Vignette = 0.4f}).Texels, Tonemap(Image, {.Vignette = 0.4f, .bCompute = true}).Texels);
}

TEST(Vignette, CornerIsTheSameForAnyAspectRatio)
{
	for (const FIntPoint Size : {FIntPoint(1920, 1080), FIntPoint(100, 100), FIntPoint(300, 700)})
	{
		const FVector2f Scale = Drydock::ComputeVignetteScale(Size);
		const double Distance2 = 0.16 * (Scale.X * Scale.X + Scale.Y * Scale.Y);
		EXPECT_NEAR(0.5739, 1 / ((1 + Distance2) * (1 + Distance2)), 5e-5);
	}
}

TEST(Vignette, DarkensByTheCosineToTheFourth)
{
	FTonemap Setup{.Vignette = 0.7f};
	Setup.Film.ToneCurveAmount = 0;
	Setup.Film.BlueCorrection = 0;
	Setup.Film.ExpandGamut = 0;
	const FImage Result = Tonemap(FImage(31, 17, {0.5, 0.5, 0.5, 1}), Setup);
	for (int Y = 0; Y < 17; Y += 4)
	{
		for (int X = 0; X < 31; X += 5)
		{
			const double Mask = ToneReference::Vignette((X + 0.5) / 31 * 2 - 1, (Y + 0.5) / 17 * 2 - 1, 31, 17, 0.7f);
			EXPECT_NEAR(ToneReference::EncodeSrgb(0.5 * Mask), Result.At(X, Y)[1], 2e-6);
		}
	}
}

TEST(Tonemap, BloomIsAddedAtTheSameExposure)
{
	FTonemap Setup{.ExposureScale = 2.0f, .PreExposure = 4.0f};
	Setup.Film.ToneCurveAmount = 0;
	Setup.Film.BlueCorrection = 0;
	Setup.Film.ExpandGamut = 0;
	Setup.Bloom = FImage(4, 4, {0.25, 0.5, 0.125, 1});
	const FTexel Result = Tonemap(FImage(8, 8, {0.5, 0.25, 1, 1}), Setup).At(3, 3);
	EXPECT_NEAR(ToneReference::EncodeSrgb(0.375), Result[0], 2e-6);
	EXPECT_NEAR(ToneReference::EncodeSrgb(0.375), Result[1], 2e-6);
	EXPECT_NEAR(ToneReference::EncodeSrgb(0.5625), Result[2], 2e-6);
}

TEST(Tonemap, BloomIsStretchedBilinearlyWithinItsRect)
{
	const FImage Bloom = FImage::Noise(5, 4);
	FTonemap Setup;
	Setup.Film.ToneCurveAmount = 0;
	Setup.Film.BlueCorrection = 0;
	Setup.Film.ExpandGamut = 0;
	Setup.Bloom = Bloom;
	const FImage Result = Tonemap(FImage(10, 8), Setup, EArithmetic::Exact);
	const FImage Stretched = FImage::Make(10, 8,
		[&](int X, int Y)
		{
			const FTexel Color = PassReference::SampleInRect(Bloom, {0, 0, 5, 4}, (X + 0.5) / 2, (Y + 0.5) / 2, false);
			return Encode({Color[0], Color[1], Color[2]});
		});
	EXPECT_LE(MaxDifference(Stretched, Result), 1e-5);
}

TEST(Tonemap, PreExposureCancels)
{
	const FImage Image = Swatches();
	for (const float PreExposure : {1e-4f, 1e4f})
	{
		FImage Scaled = Image;
		for (FTexel& Texel : Scaled.Texels)
		{
			Texel = Texel * static_cast<double>(PreExposure);
		}
		EXPECT_LE(MaxDifference(Tonemap(Image), Tonemap(Scaled, {.PreExposure = PreExposure})), 1e-5);
	}
}

TEST(Tonemap, AlphaIsLumaWhenAskedForElseZero)
{
	const FTexel Color{0.5, 0.25, 0.75, 1};
	EXPECT_EQ(0, TonemapPixel(Color)[3]);
	const FTexel Result = TonemapPixel(Color, {.bAlpha = true});
	EXPECT_NEAR(0.299 * Result[0] + 0.587 * Result[1] + 0.114 * Result[2], Result[3], 1e-6);
}

TEST(Tonemap, NaNAndNegativeChannelsCountAsZero)
{
	EXPECT_EQ(TonemapPixel({0, 0.5, 0.25, 1}), TonemapPixel({NaN, 0.5, 0.25, 1}));
	EXPECT_EQ(TonemapPixel({0, 0.5, 0.25, 1}), TonemapPixel({-3, 0.5, 0.25, 1}));
	EXPECT_EQ(TonemapPixel({0, 0.5, 0.25, 1}), TonemapPixel({-Infinity, 0.5, 0.25, 1}));
}

TEST(Tonemap, InfinityCountsAsTheLargestHalf)
{
	EXPECT_EQ(TonemapPixel({65504, 65504, 65504, 1}), TonemapPixel({Infinity, Infinity, 1e30, 1}));
	for (int Channel = 0; Channel < 3; ++Channel)
	{
		// Just below the white clip of 1.04.
		EXPECT_NEAR(1.04, ToneReference::DecodeSrgb(TonemapPixel({Infinity, Infinity, Infinity, 1})[Channel]), 1e-3);
	}
}

TEST(Tonemap, BlackIsBlackBitExactly)
{
	EXPECT_EQ((FTexel{0, 0, 0, 0}), TonemapPixel({0, 0, 0, 1}));
	EXPECT_EQ((FTexel{0, 0, 0, 0}), TonemapPixel({-0.0, 0, 0, 1}));
}

TEST(Tonemap, EveryResultIsWithinTheDisplay)
{
	for (const FTexel& Color : {FTexel{65504, 0, 0, 1}, {0, 65504, 0, 1}, {0, 0, 65504, 1}, {1e-30, 0, 0, 1},
			 {0, 1e-7, 65504, 1}, {NaN, NaN, NaN, NaN}})
	{
		const FTexel Result = Tonemap(FImage(1, 1, Color), {.OutputFormat = PF_A32B32G32R32F}).At(0, 0);
		for (int Channel = 0; Channel < 3; ++Channel)
		{
			EXPECT_TRUE(Result[Channel] >= 0 && Result[Channel] < 1.2)
				<< Color[0] << " " << Color[1] << " " << Color[2];
		}
	}
}

TEST(Tonemap, GreysRiseMonotonically)
{
	const FImage Ramp = FImage::Make(512, 1,
		[](int X, int)
		{
			const double Grey = std::exp2((X - 400) / 20.0);
			return FTexel{Grey, Grey, Grey, 1};
		});
	const FImage Result = Tonemap(Ramp);
	for (int X = 1; X < 512; ++X)
	{
		EXPECT_GE(Result.At(X, 0)[1], Result.At(X - 1, 0)[1] - 1e-7) << X;
	}
}

TEST(Tonemap, OddFrameInsideALargerTexture)
{
	const FImage Image = FImage::Noise(641, 359);
	FPassRun Run(Image, {5, 3, 646, 362}, FIntPoint(700, 400), EArithmetic::Float32, PF_A32B32G32R32F);
	Run.View.FinalPostProcessSettings.VignetteIntensity = 0;
	FTonemapInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(Run.GraphBuilder, 1.0f);
	Inputs.OutputFormat = PF_A32B32G32R32F;
	EXPECT_LE(MaxDifference(Expected(Image), Run.Execute(AddTonemapPass(Run.GraphBuilder, Run.View, Inputs))), 1e-5);
}

TEST(Tonemap, OverrideOutputIsWritten)
{
	FPassRun Run(FImage(8, 6, {0.18, 0.18, 0.18, 1}), EArithmetic::Float32, PF_A32B32G32R32F);
	Run.View.FinalPostProcessSettings.VignetteIntensity = 0;
	const FRDGTextureDesc Desc = FRDGTextureDesc::Create2D(FIntPoint(20, 20), PF_A32B32G32R32F,
		FClearValueBinding::Black, TexCreate_RenderTargetable | TexCreate_ShaderResource);
	FTonemapInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(Run.GraphBuilder, 1.0f);
	Inputs.OverrideOutput = FScreenPassRenderTarget(Run.GraphBuilder.CreateTexture(Desc, TEXT("Override")),
		FIntRect(4, 5, 12, 11), ERenderTargetLoadAction::EClear);
	const FScreenPassTexture Output = AddTonemapPass(Run.GraphBuilder, Run.View, Inputs);
	EXPECT_EQ(Inputs.OverrideOutput.Texture, Output.Texture);
	EXPECT_NEAR(117.65 / 255, Run.Execute(Output).At(7, 5)[2], 0.01 / 255);
}
