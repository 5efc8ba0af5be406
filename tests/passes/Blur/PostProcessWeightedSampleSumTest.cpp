// The two-pass Gaussian blur against direct sums, its addressing, rects, additive input and hazards.
#include "PassTestUtils.h"

#include "Blur/PostProcessWeightedSampleSum.h"

using namespace PassTest;
using PassReference::EAddress;
using PassReference::MaxDifference;

namespace
{

struct FBlur
{
	float Radius = 5.0f;
	bool bMirror = false;
	bool bCompute = false;
	FLinearColor Tint = FLinearColor(1.0f, 1.0f, 1.0f, 1.0f);
};

FGaussianBlurInputs MakeInputs(const FPassRun& Run, const FBlur& Blur)
{
	FGaussianBlurInputs Inputs;
	Inputs.NameX = TEXT("BlurX");
	Inputs.NameY = TEXT("BlurY");
	Inputs.Filter = Run.Input;
	Inputs.KernelSizePercent = 200.0f * Blur.Radius / Run.Input.ViewRect.Width();
	Inputs.TintColor = Blur.Tint;
	Inputs.UseMirrorAddressMode = Blur.bMirror;
	return Inputs;
}

FImage Blur(const FImage& Image, const FBlur& Blur, EArithmetic Arithmetic = EArithmetic::Float32)
{
	FPassRun Run(Image, Arithmetic, PF_A32B32G32R32F);
	Run.View.bUseComputePasses = Blur.bCompute;
	return Run.Execute(AddGaussianBlurPass(Run.GraphBuilder, Run.View, MakeInputs(Run, Blur)));
}

FImage Expected(const FImage& Image, float Radius, EAddress Address)
{
	const int Reach = std::min(31, static_cast<int>(std::ceil(Radius)));
	const double Width = std::min(Radius, 31.0f);
	return Radius >= 7 ? PassReference::FastGaussianBlur(Image, Width, Reach, Address)
					   : PassReference::GaussianBlur(Image, Width, Reach, Address);
}

/** Exact: offsets and coordinates from float parameters, a few 2^-24 of the size, values in 0..1, two passes.
 *  Snapped: every tap moves by at most 1/512 texel in the direction of its pass and, where its position is itself not a
 *  multiple of 1/256, by as much across; two passes, weights sum to 1. */
double Tolerance(const FImage& Image, EArithmetic Arithmetic)
{
	const double Size = std::max(Image.Width, Image.Height);
	return IsSnapped(Arithmetic) ? 2 * 2.0 / 512 : 2 * 8 * Size * std::exp2(-24) + 1e-7;
}

class GaussianBlurReference : public testing::TestWithParam<EArithmetic>
{
};

} // namespace

TEST_P(GaussianBlurReference, EverySizeAndRadius)
{
	for (const auto& [Width, Height] : {std::pair(64, 36), {65, 37}, {17, 40}, {1, 1}, {1, 9}, {9, 1}, {2, 3}})
	{
		for (const float Radius : {0.2f, 1.0f, 3.84f, 5.76f, 9.6f, 24.0f, 40.0f})
		{
			const FImage Image = FImage::Noise(Width, Height);
			EXPECT_LE(MaxDifference(Expected(Image, Radius, EAddress::Border), Blur(Image, {Radius}, GetParam()), 4),
				Tolerance(Image, GetParam()))
				<< Width << "x" << Height << " radius " << Radius;
		}
	}
}

TEST_P(GaussianBlurReference, MirrorAddressing)
{
	for (const float Radius : {3.0f, 12.0f})
	{
		const FImage Image = FImage::Noise(33, 20);
		EXPECT_LE(MaxDifference(Expected(Image, Radius, EAddress::Mirror), Blur(Image, {Radius, true}, GetParam()), 4),
			Tolerance(Image, GetParam()))
			<< Radius;
	}
}

INSTANTIATE_TEST_SUITE_P(Arithmetic, GaussianBlurReference, testing::ValuesIn(AllArithmetic), FArithmeticName());

TEST(GaussianBlur, BigOddFrameMatchesTheDirectSum)
{
	const FImage Image = FImage::Noise(641, 359);
	EXPECT_LE(MaxDifference(Expected(Image, 5.0f, EAddress::Border), Blur(Image, {5.0f}, EArithmetic::Exact), 4),
		Tolerance(Image, EArithmetic::Exact));
}

TEST(GaussianBlur, ImpulseIsTheProductOfTwoKernels)
{
	FImage Image(41, 41);
	Image.At(20, 20) = {1, 1, 1, 1};
	const FImage Result = Blur(Image, {6.0f}, EArithmetic::Exact);
	const std::vector<double> Weights = PassReference::GaussianWeights(6, 6);
	for (int X = -6; X <= 6; ++X)
	{
		EXPECT_NEAR(Weights[6 + X] * Weights[8], Result.At(20 + X, 22)[0], 1e-6) << X;
	}
	EXPECT_NEAR(1, PassReference::SumOf(Result, 0), 1e-6);
}

TEST(GaussianBlur, KeepsTheCentroidOfAnImpulse)
{
	for (const float Radius : {2.0f, 5.0f, 6.9f})
	{
		FImage Image(60, 50);
		Image.At(31, 24) = {1, 1, 1, 1};
		const FImage Result = Blur(Image, {Radius}, EArithmetic::Exact);
		double X = 0, Y = 0;
		for (int Row = 0; Row < Result.Height; ++Row)
		{
			for (int Column = 0; Column < Result.Width; ++Column)
			{
				X += Column * Result.At(Column, Row)[0];
				Y += Row * Result.At(Column, Row)[0];
			}
		}
		EXPECT_NEAR(31, X / PassReference::SumOf(Result, 0), 1e-4) << Radius;
		EXPECT_NEAR(24, Y / PassReference::SumOf(Result, 0), 1e-4) << Radius;
	}
}

TEST(GaussianBlur, FastPathKeepsTheLightOfAPairOfColumns)
{
	// One column alone is weighed by up to 1.93 or as little as 0.07 (radius 31): its taps fall between texels.
	const auto SumFrom = [](int Column)
	{
		FImage Image(160, 70);
		Image.At(Column, 34) = {1, 1, 1, 1};
		return PassReference::SumOf(Blur(Image, {31.0f}, EArithmetic::Exact), 0);
	};
	const double Even = SumFrom(80), Odd = SumFrom(81);
	EXPECT_NEAR(2, Even + Odd, 1e-4);
	EXPECT_NEAR(1.9256, Even, 1e-3);
}

TEST(GaussianBlur, BorderDarkensTheEdgesMirrorDoesNot)
{
	const FImage White(40, 40, {1, 1, 1, 1});
	const FImage Border = Blur(White, {6.0f});
	const FImage Mirror = Blur(White, {6.0f, true});
	EXPECT_NEAR(1, Border.At(20, 20)[0], 1e-6);
	// The tail of a kernel whose centre weighs Weights[6]: what lies within the image, half of it twice over.
	const double Kept = 0.5 + 0.5 * PassReference::GaussianWeights(6, 6)[6];
	EXPECT_NEAR(Kept * Kept, Border.At(0, 0)[0], 2e-3);
	EXPECT_LE(MaxDifference(White, Mirror), 1e-6);
}

TEST(GaussianBlur, RectInsideATextureEqualsTheCroppedImage)
{
	const FImage Image = FImage::Noise(40, 24);
	for (const FBlur& Setup : {FBlur{3.0f}, {3.0f, true}, {9.0f}, {9.0f, true}})
	{
		const FImage Cropped = Blur(Image, Setup, EArithmetic::Double);
		FPassRun Run(Image, {10, 6, 50, 30}, FIntPoint(64, 40), EArithmetic::Double, PF_A32B32G32R32F);
		const FImage Result = Run.Execute(AddGaussianBlurPass(Run.GraphBuilder, Run.View, MakeInputs(Run, Setup)));
		EXPECT_LE(MaxDifference(Cropped, Result, 4), Tolerance(Image, EArithmetic::Double))
			<< Setup.Radius << " mirror " << Setup.bMirror;
	}
}

TEST(GaussianBlur, TintMultipliesTheBlurNotTheAdditive)
{
	FPassRun Run(FImage(40, 40, {1, 1, 1, 1}), EArithmetic::Float32, PF_A32B32G32R32F);
	FGaussianBlurInputs Inputs = MakeInputs(Run, {3.0f, true, false, FLinearColor(0.5f, 0.25f, 2.0f, 0.125f)});
	Inputs.Additive = Run.AddInput(FImage(20, 20, {1, 2, 3, 4}), PF_A32B32G32R32F, TEXT("Additive"));
	const FImage Result = Run.Execute(AddGaussianBlurPass(Run.GraphBuilder, Run.View, Inputs));
	EXPECT_LE(MaxDifference(FImage(40, 40, {1.5, 2.25, 5, 4.125}), Result, 4), 1e-5);
}

TEST(GaussianBlur, AdditiveIsStretchedOverTheViewBilinearlyWithClampedEdges)
{
	const FImage Additive = FImage::Noise(7, 5);
	FPassRun Run(FImage(14, 10), EArithmetic::Exact, PF_A32B32G32R32F);
	FGaussianBlurInputs Inputs = MakeInputs(Run, {1.0f});
	Inputs.Additive = Run.AddInput(Additive, {2, 1, 9, 6}, FIntPoint(12, 8), PF_A32B32G32R32F, TEXT("Additive"));
	const FImage Result = Run.Execute(AddGaussianBlurPass(Run.GraphBuilder, Run.View, Inputs));
	const FImage Stretched = FImage::Make(14, 10,
		[&](int X, int Y) {
			return PassReference::SampleInRect(Additive, {0, 0, 7, 5}, (X + 0.5) / 2, (Y + 0.5) / 2, false);
		});
	EXPECT_LE(MaxDifference(Stretched, Result), 1e-5);
}

TEST(GaussianBlur, ComputeAndPixelShaderGiveTheSameBits)
{
	const FImage Image = FImage::Noise(65, 37);
	for (const float Radius : {4.0f, 12.0f})
	{
		EXPECT_EQ(Blur(Image, {Radius}).Texels, Blur(Image, {Radius, false, true}).Texels);
	}
}

TEST(GaussianBlur, FastPathHalvesTheHorizontalPass)
{
	FPassRun Run(FImage::Noise(65, 37), EArithmetic::Native);
	const FScreenPassTexture Output = AddGaussianBlurPass(Run.GraphBuilder, Run.View, MakeInputs(Run, {8.0f}));
	EXPECT_EQ(FIntPoint(65, 37), Output.Texture->Desc.Extent);
	Run.Execute(Output);
}

TEST(GaussianBlur, TinyRadiusCopies)
{
	const FImage Image = FImage::Noise(20, 10);
	EXPECT_EQ(Image.Texels, Blur(Image, {0.0f}).Texels);
	EXPECT_EQ(Image.Texels, Blur(Image, {0.2f}).Texels);
}

TEST(GaussianBlur, InfinityStaysWithinTheKernel)
{
	FImage Image(40, 40, {1, 1, 1, 1});
	Image.At(20, 20)[0] = Infinity;
	const FImage Result = Blur(Image, {4.0f});
	EXPECT_EQ(Infinity, Result.At(20, 20)[0]);
	// Five texels off: outside the four of the radius.
	EXPECT_NEAR(1, Result.At(26, 20)[0], 1e-5);
	EXPECT_NEAR(1, Result.At(20, 20)[1], 1e-5);
}

TEST(GaussianBlur, NaNAtTheEdgeOfARectReachesNoFurtherThanTheKernel)
{
	FImage Image(30, 20, {1, 1, 1, 1});
	Image.At(0, 10)[0] = NaN;
	FPassRun Run(Image, {8, 8, 38, 28}, FIntPoint(48, 36), EArithmetic::Float32, PF_A32B32G32R32F);
	const FImage Result = Run.Execute(AddGaussianBlurPass(Run.GraphBuilder, Run.View, MakeInputs(Run, {4.0f, true})));
	EXPECT_TRUE(std::isnan(Result.At(0, 10)[0]));
	EXPECT_NEAR(1, Result.At(6, 10)[0], 1e-5);
	EXPECT_NEAR(1, Result.At(0, 16)[0], 1e-5);
}

TEST(GaussianBlur, InfinityAtTheEdgeOfARectDoesNotBecomeNaN)
{
	FImage Image(30, 20, {1, 1, 1, 1});
	Image.At(0, 10)[0] = Infinity;
	FPassRun Run(Image, {8, 8, 38, 28}, FIntPoint(48, 36), EArithmetic::Float32, PF_A32B32G32R32F);
	const FImage Result = Run.Execute(AddGaussianBlurPass(Run.GraphBuilder, Run.View, MakeInputs(Run, {4.0f})));
	EXPECT_EQ(Infinity, Result.At(0, 10)[0]);
	EXPECT_EQ(Infinity, Result.At(2, 10)[0]);
	EXPECT_NEAR(1, Result.At(6, 10)[0], 1e-5);
}

TEST(GaussianBlur, NegativesPassAndLargestHalfDoesNotOverflow)
{
	EXPECT_NEAR(-2, Blur(FImage(32, 32, {-2, 1, 1, 1}), {3.0f}).At(16, 16)[0], 1e-5);
	FPassRun Run(FImage(32, 32, {65504, 1, 1, 1}), EArithmetic::Native);
	EXPECT_EQ(
		65504, Run.Execute(AddGaussianBlurPass(Run.GraphBuilder, Run.View, MakeInputs(Run, {3.0f}))).At(16, 16)[0]);
}

// From 5.4 on the filter is a slice; one layer of an array is taken out first.
TEST(GaussianBlur, BlursASliceAsItsTexture)
{
	const FImage Image = FImage::Noise(24, 16);
	const FImage Expected = Blur(Image, {4.0f}, EArithmetic::Float32);
	{
		FPassRun Run(Image, EArithmetic::Float32, PF_A32B32G32R32F);
		FGaussianBlurInputs Inputs = MakeInputs(Run, {4.0f});
		Inputs.Filter = FScreenPassTextureSlice::CreateFromScreenPassTexture(Run.GraphBuilder, Run.Input);
		EXPECT_EQ(
			0.0, MaxDifference(Expected, Run.Execute(AddGaussianBlurPass(Run.GraphBuilder, Run.View, Inputs)), 4));
	}

	FPassRun Layers(Image, EArithmetic::Float32, PF_A32B32G32R32F);
	const FRDGTextureRef Array = Layers.GraphBuilder.CreateTexture(
		FRDGTextureDesc::Create2DArray(FIntPoint(24, 16), PF_A32B32G32R32F, FClearValueBinding::None,
			TexCreate_ShaderResource | TexCreate_RenderTargetable, 2),
		TEXT("Layers"));
	FRHICopyTextureInfo Copy;
	Copy.DestSliceIndex = 1;
	AddCopyTexturePass(Layers.GraphBuilder, Layers.Input.Texture, Array, Copy);
	FGaussianBlurInputs Inputs = MakeInputs(Layers, {4.0f});
	Inputs.Filter = FScreenPassTextureSlice(
		Layers.GraphBuilder.CreateSRV(FRDGTextureSRVDesc::CreateForSlice(Array, 1)), Layers.Input.ViewRect);
	EXPECT_EQ(
		0.0, MaxDifference(Expected, Layers.Execute(AddGaussianBlurPass(Layers.GraphBuilder, Layers.View, Inputs)), 4));
}
