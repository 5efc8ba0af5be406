// Transforms against their definition, sizes, and the circular convolution that products of spectra make.
#include "PassTestUtils.h"

#include "Bloom/FFTConvolution.h"
#include "Native/FourierTransform.h"
#include "RenderGraphUtils.h"

#include <numbers>

using namespace PassTest;
using Drydock::EFourierDirection;
using Drydock::FComplex;
using Drydock::FFFTDomain;
using Drydock::FFourierTransform;
using PassReference::MaxDifference;
using PassReference::SumOf;

namespace
{

std::vector<FComplex> SumByDefinition(const std::vector<FComplex>& Values, double Sign)
{
	std::vector<FComplex> Result;
	for (size_t K = 0; K < Values.size(); ++K)
	{
		FComplex Sum = 0.0;
		for (size_t J = 0; J < Values.size(); ++J)
		{
			Sum += Values[J] * std::polar(1.0, Sign * 2 * std::numbers::pi * double(J * K) / double(Values.size()));
		}
		Result.push_back(Sum);
	}
	return Result;
}

double LargestDifference(const std::vector<FComplex>& A, const std::vector<FComplex>& B)
{
	double Largest = 0;
	for (size_t Index = 0; Index < A.size(); ++Index)
	{
		Largest = std::max(Largest, std::abs(A[Index] - B[Index]));
	}
	return Largest;
}

const std::vector<FComplex> Eight = {{1, 2}, {-3, 0.5}, {0, 0}, {4, -1}, {0.25, 7}, {-2, -2}, {5, 0}, {1, 1}};

std::vector<FComplex> Transform(const std::vector<FComplex>& Values, EFourierDirection Direction)
{
	std::vector<FComplex> Result(Values.size());
	FFourierTransform(int32(Values.size()), Direction).Run(Values.data(), Result.data());
	return Result;
}

/** The picture convolved with the kernel, all of the transform's extent. Both start at the origin. */
FImage Convolve(const FImage& Image, const FImage& Kernel, const FFFTDomain& Domain, EArithmetic Arithmetic)
{
	FPassRun Run(Image, Arithmetic, PF_A32B32G32R32F);
	const FScreenPassTexture KernelInput = Run.AddInput(Kernel, PF_A32B32G32R32F, TEXT("Kernel"));
	const FVector4f One(1, 1, 1, 1);
	const FRDGBufferRef Factor =
		CreateStructuredBuffer(Run.GraphBuilder, TEXT("Factor"), sizeof(One), 1, &One, sizeof(One));
	const FRDGTextureRef Product = Drydock::AddMultiplySpectraPass(Run.GraphBuilder, Run.View, Domain,
		Drydock::AddForwardFFTPasses(Run.GraphBuilder, Domain, Run.Input, TEXT("ImageSpectrum")),
		Drydock::AddForwardFFTPasses(Run.GraphBuilder, Domain, KernelInput, TEXT("KernelSpectrum")), Factor);
	const FScreenPassTexture Output(
		Run.GraphBuilder.CreateTexture(FRDGTextureDesc::Create2D(Domain.FrequencySize, PF_A32B32G32R32F,
										   FClearValueBinding::None, TexCreate_ShaderResource | TexCreate_UAV),
			TEXT("Output")));
	Drydock::AddInverseFFTPasses(Run.GraphBuilder, Domain, Product, Output);
	return Run.Execute(Output);
}

/** By its definition, circular over Size. */
FImage ConvolveDirectly(const FImage& Image, const FImage& Kernel, FIntPoint Size)
{
	FImage Result(Size.X, Size.Y);
	for (int Y = 0; Y < Image.Height; ++Y)
	{
		for (int X = 0; X < Image.Width; ++X)
		{
			for (int J = 0; J < Kernel.Height; ++J)
			{
				for (int I = 0; I < Kernel.Width; ++I)
				{
					FTexel& Target = Result.At((X + I) % Size.X, (Y + J) % Size.Y);
					for (size_t Channel = 0; Channel < 3; ++Channel)
					{
						Target[Channel] += Image.At(X, Y)[Channel] * Kernel.At(I, J)[Channel];
					}
				}
			}
		}
	}
	return Result;
}

double LargestOf(const FImage& Image)
{
	return MaxDifference(Image, FImage(Image.Width, Image.Height));
}

} // namespace

TEST(FourierTransform, IsTheSumOfItsDefinition)
{
	EXPECT_LT(LargestDifference(SumByDefinition(Eight, -1), Transform(Eight, EFourierDirection::Forward)), 1e-13);
	EXPECT_LT(LargestDifference(SumByDefinition(Eight, 1), Transform(Eight, EFourierDirection::Inverse)), 1e-13);
}

TEST(FourierTransform, SizeOneIsTheNumberItself)
{
	EXPECT_EQ(FComplex(3, -4), Transform({{3, -4}}, EFourierDirection::Forward)[0]);
}

TEST(FFTDomain, RoundsUpToPowersOfTwo)
{
	EXPECT_EQ(FIntPoint(256, 128), FFFTDomain::Make(FIntPoint(129, 67), FIntPoint(145, 83)).FrequencySize);
	EXPECT_EQ(FIntPoint(128, 64), FFFTDomain::Make(FIntPoint(10, 10), FIntPoint(128, 64)).FrequencySize);
}

TEST(FFTDomain, HoldsTheImageWhateverIsAskedFor)
{
	EXPECT_EQ(FIntPoint(64, 2), FFFTDomain::Make(FIntPoint(33, 1), FIntPoint(0, 0)).FrequencySize);
}

TEST(FFTDomain, TransformsTheAxisFirstThatLeavesLess)
{
	// 258 x 67 = 17286 texels against 129 x 130 = 16770.
	EXPECT_FALSE(FFFTDomain::Make(FIntPoint(129, 67), FIntPoint(145, 83)).bHorizontalFirst);
	EXPECT_TRUE(FFFTDomain::Make(FIntPoint(67, 129), FIntPoint(83, 145)).bHorizontalFirst);
}

TEST(FFTDomain, SpectraAreTwoTexelsLonger)
{
	EXPECT_EQ(FIntPoint(256, 130), FFFTDomain::Make(FIntPoint(129, 67), FIntPoint(145, 83)).GetSpectrumExtent());
	EXPECT_EQ(FIntPoint(130, 256), FFFTDomain::Make(FIntPoint(67, 129), FIntPoint(83, 145)).GetSpectrumExtent());
}

class FFTConvolution : public testing::TestWithParam<EArithmetic>
{
};
INSTANTIATE_TEST_SUITE_P(Arithmetic, FFTConvolution, testing::ValuesIn(SnappedArithmetic), FArithmeticName());

TEST_P(FFTConvolution, EqualsTheDirectCircularSum)
{
	for (const FIntPoint Size : {FIntPoint(13, 7), FIntPoint(7, 13), FIntPoint(1, 1), FIntPoint(2, 1), FIntPoint(1, 5)})
	{
		const FImage Image = FImage::Noise(Size.X, Size.Y), Kernel = FImage::Noise(5, 3, 1.0, 2);
		const FFFTDomain Domain = FFFTDomain::Make(Size, FIntPoint(FMath::Max(Size.X, 5), FMath::Max(Size.Y, 3)));
		const FImage Expected = ConvolveDirectly(Image, Kernel, Domain.FrequencySize);
		EXPECT_LT(MaxDifference(Expected, Convolve(Image, Kernel, Domain, GetParam())), 1e-6 * LargestOf(Expected))
			<< Size.X << "x" << Size.Y;
	}
}

TEST_P(FFTConvolution, WritesNoAlpha)
{
	const FFFTDomain Domain = FFFTDomain::Make(FIntPoint(5, 4), FIntPoint(5, 4));
	EXPECT_EQ(0, SumOf(Convolve(FImage::Noise(5, 4), FImage::Noise(3, 3), Domain, GetParam()), 3));
}

TEST_P(FFTConvolution, KeepsTheEnergyOverThePaddedExtent)
{
	const FImage Image = FImage::Noise(129, 67, 100.0), Kernel = FImage::Noise(31, 21, 1.0, 3);
	const FFFTDomain Domain = FFFTDomain::Make(FIntPoint(129, 67), FIntPoint(145, 83));
	const FImage Result = Convolve(Image, Kernel, Domain, GetParam());
	for (int Channel = 0; Channel < 3; ++Channel)
	{
		const double Expected = SumOf(Image, Channel) * SumOf(Kernel, Channel);
		EXPECT_NEAR(1, SumOf(Result, Channel) / Expected, 1e-6);
	}
}

TEST(FFTConvolutionThreads, GiveTheSameBits)
{
	const FImage Image = FImage::Noise(97, 53), Kernel = FImage::Noise(11, 17, 1.0, 3);
	const FFFTDomain Domain = FFFTDomain::Make(FIntPoint(97, 53), FIntPoint(110, 70));
	const auto RunOn = [&](float NumThreads)
	{
		const FScopedConsoleVariable Threads(TEXT("r.Drydock.Threads"), NumThreads);
		return Convolve(Image, Kernel, Domain, EArithmetic::Native);
	};
	EXPECT_EQ(RunOn(1).Texels, RunOn(7).Texels);
}
