// Bloom setup against its formula, the neutral threshold, pre-exposure and hazards.
#include "PassTestUtils.h"

#include "Bloom/PostProcessBloomSetup.h"

using namespace Drydock;

using namespace PassTest;
using PassReference::MaxDifference;

namespace
{

struct FSetup
{
	float Threshold = -1.0f;
	float ExposureScale = 1.0f;
	float PreExposure = 1.0f;
	bool bCompute = false;
	EPixelFormat Format = PF_A32B32G32R32F;
	Drydock::FEngineProfile Engine = Drydock::GetDefaultEngineProfile();
};

FImage BloomSetup(const FImage& Image, const FSetup& Setup, EArithmetic Arithmetic = EArithmetic::Float32)
{
	FPassRun Run(Image, Arithmetic, Setup.Format);
	Run.View.EngineProfile = Setup.Engine;
	Run.View.PreExposure = Setup.PreExposure;
	Run.View.InitViewUniformBuffer(Run.Input.Texture->Desc.Extent);
	Run.View.bUseComputePasses = Setup.bCompute;

	FBloomSetupInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(Run.GraphBuilder, Setup.ExposureScale);
	Inputs.Threshold = Setup.Threshold;
	return Run.Execute(AddBloomSetupPass(Run.GraphBuilder, Run.View, Inputs));
}

FImage Expected(const FImage& Image, const FSetup& Setup)
{
	return FImage::Make(Image.Width, Image.Height,
		[&](int X, int Y)
		{ return PassReference::BloomSetup(Image.At(X, Y), Setup.Threshold, Setup.ExposureScale, Setup.PreExposure); });
}

FTexel SetUpPixel(const FTexel& Color, const FSetup& Setup = {})
{
	return BloomSetup(FImage(1, 1, Color), Setup).At(0, 0);
}

class BloomSetupReference : public testing::TestWithParam<EArithmetic>
{
};

} // namespace

TEST_P(BloomSetupReference, EverySizeThresholdAndExposure)
{
	for (const auto& [Width, Height] : {std::pair(16, 8), {641, 359}, {1, 1}, {1, 9}})
	{
		for (const FSetup& Setup : {FSetup{}, {0.0f}, {1.0f, 0.5f}, {0.25f, 3.0f, 2.0f}, {1.0f, 1.0f, 0.125f}, {8.0f}})
		{
			// Values in 0..4: one ulp of 4 for a dozen float operations; the pre-exposure is a power of two.
			const FImage Image = FImage::Noise(Width, Height, 4);
			EXPECT_LE(MaxDifference(Expected(Image, Setup), BloomSetup(Image, Setup, GetParam()), 4), 4e-6)
				<< Width << "x" << Height << " threshold " << Setup.Threshold << " exposure " << Setup.ExposureScale;
		}
	}
}

INSTANTIATE_TEST_SUITE_P(Arithmetic, BloomSetupReference, testing::ValuesIn(SnappedArithmetic), FArithmeticName());

TEST(BloomSetup, WithoutThresholdColourPassesBitExactly)
{
	FImage Image = FImage::Noise(17, 5, 100);
	for (FTexel& Texel : Image.Texels)
	{
		Texel[3] = 0;
	}
	EXPECT_EQ(Image.Texels, BloomSetup(Image, {}).Texels);
	EXPECT_EQ(Image.Texels, BloomSetup(Image, {-7.0f}).Texels);
}

TEST(BloomSetup, RampIsTwoUnitsWide)
{
	const FSetup Setup{1.0f};
	EXPECT_EQ(0, SetUpPixel({1, 1, 1, 1}, Setup)[0]);
	EXPECT_FLOAT_EQ(1.0, static_cast<float>(SetUpPixel({2, 2, 2, 1}, Setup)[0]));
	EXPECT_FLOAT_EQ(3.0, static_cast<float>(SetUpPixel({3, 3, 3, 1}, Setup)[0]));
	EXPECT_FLOAT_EQ(4.0, static_cast<float>(SetUpPixel({4, 4, 4, 1}, Setup)[0]));
}

TEST(BloomSetup, WithoutThresholdTheRampIsThatOfTheEngineVersion)
{
	for (const Drydock::FEngineProfile& Engine : Drydock::GetEngineProfiles())
	{
		FSetup Setup;
		Setup.Engine = Engine;
		const double Half = Engine.bBloomRampWithoutThreshold ? 0.375 : 0.5;
		EXPECT_NEAR(Half, SetUpPixel({0.5, 0.5, 0.5, 1}, Setup)[0], 1e-6) << Engine.GetVersion();
		EXPECT_NEAR(2.0, SetUpPixel({2, 2, 2, 1}, Setup)[0], 1e-6) << Engine.GetVersion();
	}
}

TEST(BloomSetup, NoEngineVersionHasARampFromMinusInfinity)
{
	FSetup Setup{-std::numeric_limits<float>::infinity()};
	Setup.Engine = *Drydock::FindEngineProfile(3);
	EXPECT_EQ(0.5, SetUpPixel({0.5, 0.5, 0.5, 1}, Setup)[0]);
}

TEST(BloomSetup, ThresholdIsInExposedUnits)
{
	EXPECT_EQ(0, SetUpPixel({2, 2, 2, 1}, {1.0f, 0.5f})[1]);
	EXPECT_FLOAT_EQ(2.0f, static_cast<float>(SetUpPixel({2, 2, 2, 1}, {1.0f, 1.5f})[1]));
}

TEST(BloomSetup, PreExposureChangesTheUnitsOnly)
{
	const FImage Image = FImage::Noise(8, 8, 4);
	const FImage Reference = BloomSetup(Image, {1.0f});
	for (const float PreExposure : {1e-4f, 1e4f})
	{
		FImage Scaled = Image;
		for (FTexel& Texel : Scaled.Texels)
		{
			Texel = Texel * static_cast<double>(PreExposure);
		}
		FImage Result = BloomSetup(Scaled, {1.0f, 1.0f, PreExposure});
		for (FTexel& Texel : Result.Texels)
		{
			Texel = Texel * (1 / static_cast<double>(PreExposure));
		}
		EXPECT_LE(MaxDifference(Reference, Result), 1e-5);
	}
}

TEST(BloomSetup, ComputeAndPixelShaderGiveTheSameBits)
{
	const FImage Image = FImage::Noise(65, 37, 4);
	for (const float Threshold : {-1.0f, 0.5f})
	{
		EXPECT_EQ(BloomSetup(Image, {Threshold}).Texels, BloomSetup(Image, {Threshold, 1.0f, 1.0f, true}).Texels);
	}
}

TEST(BloomSetup, InfinityAndNaNBecomeTheClamp)
{
	EXPECT_EQ((FTexel{65536, 0, 1, 0}), SetUpPixel({Infinity, 0, 1, 1}));
	EXPECT_EQ((FTexel{65536, 0, 1, 0}), SetUpPixel({NaN, 0, 1, 1}));
	EXPECT_EQ((FTexel{65536, 65536, 1, 0}), SetUpPixel({1e30, 65537, 1, 1}));
}

TEST(BloomSetup, NegativesPassUnlessTheLuminanceFails)
{
	EXPECT_EQ((FTexel{-1, 8, 0, 0}), SetUpPixel({-1, 8, 0, 1}, {0.0f}));
	EXPECT_EQ(0, SetUpPixel({-8, 1, 0, 1}, {0.0f})[0]);
	EXPECT_EQ(0, BloomSetup(FImage(1, 1, {-1, 8, 0, 1}), {-1.0f, 1.0f, 1.0f, false, PF_FloatRGB}, EArithmetic::Native)
					 .At(0, 0)[0]);
}

TEST(BloomSetup, BlackStaysBlack)
{
	EXPECT_EQ((FTexel{0, 0, 0, 0}), SetUpPixel({0, 0, 0, 1}));
	EXPECT_EQ((FTexel{0, 0, 0, 0}), SetUpPixel({0, 0, 0, 1}, {0.0f}));
}

TEST(BloomSetup, LargestHalfFitsItsFormat)
{
	EXPECT_EQ((FTexel{65504, 65504, 65504, 0}), BloomSetup(FImage(1, 1, {65504, 65504, 65504, 1}),
													{-1.0f, 1.0f, 1.0f, false, PF_FloatRGBA}, EArithmetic::Native)
													.At(0, 0));
}

TEST(BloomSetup, ReadsNothingOutsideItsRect)
{
	const FImage Image = FImage::Noise(7, 5);
	FPassRun Run(Image, {3, 2, 10, 7}, FIntPoint(16, 12), EArithmetic::Float32);
	FBloomSetupInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(Run.GraphBuilder, 1.0f);
	Inputs.Threshold = -1.0f;
	const FScreenPassTexture Output = AddBloomSetupPass(Run.GraphBuilder, Run.View, Inputs);
	EXPECT_EQ(Run.Input.ViewRect, Output.ViewRect);
	EXPECT_EQ(0, MaxDifference(Image, Run.Execute(Output)));
}
