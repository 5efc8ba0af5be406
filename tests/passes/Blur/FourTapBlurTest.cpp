// Kawase's blur and the pyramid, against their closed forms.
#include "NativeTestUtils.h"

#include "DualKawaseBlurReference.h"

#include "Blur/FourTapBlur.h"
#include "NativeFallback.h"

using namespace Drydock;

using namespace PassTest;
using PassReference::MaxDifference;

namespace
{

enum class EBlur
{
	Kawase,
	Pyramid,
};

FImage Blur(const FImage& Image, EBlur Kind, double Sigma, EArithmetic Arithmetic = EArithmetic::Float32)
{
	FPassRun Run(Image, Arithmetic);
	return Run.Execute(Kind == EBlur::Kawase ? AddKawaseBlurPasses(Run.GraphBuilder, Run.View, Run.Input, Sigma)
											 : AddPyramidBlurPasses(Run.GraphBuilder, Run.View, Run.Input, Sigma));
}

/** One direction of the Gaussian in double, to 7 deviations; the edge texel goes on beyond the image. */
FImage BlurAxisWithoutEnd(const FImage& Image, double Sigma, int StepX, int StepY)
{
	const int Reach = static_cast<int>(7 * Sigma);
	return FImage::Make(Image.Width, Image.Height,
		[&](int X, int Y)
		{
			FTexel Color{0, 0, 0, 0};
			double Sum = 0;
			for (int Tap = -Reach; Tap <= Reach; ++Tap)
			{
				const double Weight = std::exp(-0.5 * (Tap / Sigma) * (Tap / Sigma));
				Color = Color + Image.At(std::clamp(X + Tap * StepX, 0, Image.Width - 1),
									std::clamp(Y + Tap * StepY, 0, Image.Height - 1)) *
									Weight;
				Sum += Weight;
			}
			return Color * (1 / Sum);
		});
}

FImage BlurWithoutEnd(const FImage& Image, double Sigma)
{
	return BlurAxisWithoutEnd(BlurAxisWithoutEnd(Image, Sigma, 1, 0), Sigma, 0, 1);
}

} // namespace

TEST(KawaseBlur, FirstPassAveragesTheNeighboursByTheBinomialKernel)
{
	// Taps at half a texel average 2x2; the four of them make [1 2 1]/4 along each axis, whose variance is 1/2.
	const FImage Result = Blur(DualKawaseReference::Impulse(9, 9, 4, 4), EBlur::Kawase, std::sqrt(0.5));
	EXPECT_NEAR(0.25, Result.At(4, 4)[0], 1e-6);
	EXPECT_NEAR(0.125, Result.At(5, 4)[0], 1e-6);
	EXPECT_NEAR(0.0625, Result.At(3, 5)[0], 1e-6);
	EXPECT_EQ(0.0, Result.At(6, 4)[0]);
}

TEST(KawaseBlur, DistancesGrowByOneAndTheLastMakesUpTheRest)
{
	// 1/2 + 5/2 = 3 of 4 after two passes; the third has 1: at distance 1 exactly.
	const TArray<double> Distances = Drydock::GetKawaseDistances(2.0);
	ASSERT_EQ(3, Distances.Num());
	EXPECT_EQ(0.5, Distances[0]);
	EXPECT_EQ(1.5, Distances[1]);
	EXPECT_EQ(1.0, Distances[2]);
	EXPECT_EQ(4.0, Drydock::GetKawaseVariance(Distances));
}

TEST(KawaseBlur, VarianceIsWhatIsAskedForWithinTheSamplersGrid)
{
	for (const double Sigma : {0.6, 1.3, 4.0, 10.0, 50.0, 128.0})
	{
		const double Variance = Drydock::GetKawaseVariance(Drydock::GetKawaseDistances(Sigma));
		EXPECT_NEAR(1.0, std::sqrt(Variance) / Sigma, 2e-3) << Sigma;
	}
	EXPECT_EQ(0, Drydock::GetKawaseDistances(0.0).Num());
}

TEST(KawaseBlur, MeasuredVarianceIsTheClosedForm)
{
	const FImage Result = Blur(DualKawaseReference::Impulse(61, 61, 30, 30), EBlur::Kawase, 3.7);
	const DualKawaseReference::FMoments Moments = DualKawaseReference::GetMoments(Result, 30, 30);
	EXPECT_NEAR(1.0, Moments.Sum, 1e-5);
	EXPECT_NEAR(Drydock::GetKawaseVariance(Drydock::GetKawaseDistances(3.7)), Moments.XX / Moments.Sum, 1e-3);
}

TEST(PyramidBlur, LevelsLeaveTheGaussianThreeAndAHalfTexels)
{
	// One level spreads by 3/2, two by 15/2, three by 63/2: sqrt((64 - 1.5) / 4) = 3.95, sqrt((64 - 7.5) / 16) = 1.88.
	EXPECT_EQ(1, Drydock::GetPyramidSetting(8.0).Levels);
	EXPECT_NEAR(3.9528, Drydock::GetPyramidSetting(8.0).LowStandardDeviation, 1e-4);
	EXPECT_EQ(2, Drydock::GetPyramidSetting(16.0).Levels);
	EXPECT_NEAR(3.9410, Drydock::GetPyramidSetting(16.0).LowStandardDeviation, 1e-4);
	EXPECT_EQ(0, Drydock::GetPyramidSetting(1.0).Levels);
	EXPECT_EQ(1.0, Drydock::GetPyramidSetting(1.0).LowStandardDeviation);
	EXPECT_EQ(1, Drydock::GetPyramidSetting(3.0, 5).Levels); // two leave sqrt((9 - 7.5) / 16), below half a texel
}

TEST(PyramidBlur, ResponseToAStepIsThatOfAGaussian)
{
	// Where the step is, half; 8 pixels beside it, one deviation: 0.8413 of the way. A step is black up to column 63.
	const FImage Step = FImage::Make(128, 16,
		[](int X, int) {
			return X < 64 ? FTexel{0, 0, 0, 0} : FTexel{1, 1, 1, 1};
		});
	const FImage Result = Blur(Step, EBlur::Pyramid, 8.0);
	EXPECT_NEAR(0.5, (Result.At(63, 8)[0] + Result.At(64, 8)[0]) / 2, 2e-4);
	// Off by the small Gaussian's end, and by the mean of two texels, 5e-4.
	EXPECT_NEAR(0.841345, (Result.At(71, 8)[0] + Result.At(72, 8)[0]) / 2, 1e-3);
}

TEST(PyramidBlur, IsWithinTheStatedBoundOfAGaussianToTheBorders)
{
	std::mt19937 Random(7);
	for (int Case = 0; Case < 24; ++Case)
	{
		const double Sigma = std::exp(std::uniform_real_distribution<double>(std::log(1.9), std::log(40.0))(Random));
		const int Width = std::uniform_int_distribution<int>(1, 150)(Random);
		const int Height = std::uniform_int_distribution<int>(1, 90)(Random);
		// Black and white blocks of any size are the worst a picture can do.
		const int Block = std::uniform_int_distribution<int>(1, 24)(Random);
		std::vector<double> Blocks(size_t(Width / Block + 1) * size_t(Height / Block + 1));
		for (double& Value : Blocks)
		{
			Value = std::uniform_int_distribution<int>(0, 1)(Random);
		}
		const FImage Image = FImage::Make(Width, Height,
			[&](int X, int Y)
			{
				const double Value = Blocks[size_t(Y / Block) * size_t(Width / Block + 1) + size_t(X / Block)];
				return FTexel{Value, 1 - Value, Value, 1};
			});
		const double Bound = Sigma >= 7.2 ? 1e-3 : Sigma >= 4.0 ? 4e-3 : 3.5e-2;
		EXPECT_LE(MaxDifference(Blur(Image, EBlur::Pyramid, Sigma), BlurWithoutEnd(Image, Sigma)), Bound)
			<< "case " << Case << ", sigma " << Sigma << ", " << Width << " x " << Height << ", blocks of " << Block;
	}
}

TEST(FourTapBlur, NativeKernelsHaveTheShadersBits)
{
	std::mt19937 Random(23);
	const uint64_t Before = GetNativeFallbacks();
	for (int Case = 0; Case < 30; ++Case)
	{
		const FPlace Place = DrawPlace(Random);
		const double Sigma = std::exp(std::uniform_real_distribution<double>(-0.5, 3.4)(Random));
		const auto Run = [&]
		{
			FPassRun Run(Place.Image, Place.Rect, Place.Extent, EArithmetic::Native, Place.Format);
			return Run.Execute(Case % 2 == 0 ? AddPyramidBlurPasses(Run.GraphBuilder, Run.View, Run.Input, Sigma)
											 : AddKawaseBlurPasses(Run.GraphBuilder, Run.View, Run.Input, Sigma));
		};
		ExpectSameBits(
			Run, "case " + std::to_string(Case) + ", " + Describe(Place) + ", sigma " + std::to_string(Sigma));
	}
	EXPECT_EQ(Before, GetNativeFallbacks());
}

TEST(FourTapBlur, ConstantStaysConstantToTheEdgeOfAnOffsetRect)
{
	const FImage Constant(19, 13, {0.75, 0.5, 3, 1});
	for (const EBlur Kind : {EBlur::Kawase, EBlur::Pyramid})
	{
		FPassRun Run(Constant, {3, 2, 22, 15}, FIntPoint(32, 24), EArithmetic::Native);
		const FScreenPassTexture Output = Kind == EBlur::Kawase
											  ? AddKawaseBlurPasses(Run.GraphBuilder, Run.View, Run.Input, 5.0)
											  : AddPyramidBlurPasses(Run.GraphBuilder, Run.View, Run.Input, 5.0);
		EXPECT_EQ(Constant.Texels, Run.Execute(Output).Texels);
	}
}

TEST(FourTapBlur, OffsetRectGivesTheBitsOfTheCroppedImage)
{
	const FImage Image = FImage::Noise(23, 17);
	for (const EBlur Kind : {EBlur::Kawase, EBlur::Pyramid})
	{
		const FImage Cropped = Blur(Image, Kind, 4.0, EArithmetic::Native);
		FPassRun Run(Image, {5, 9, 28, 26}, FIntPoint(40, 33), EArithmetic::Native);
		const FScreenPassTexture Output = Kind == EBlur::Kawase
											  ? AddKawaseBlurPasses(Run.GraphBuilder, Run.View, Run.Input, 4.0)
											  : AddPyramidBlurPasses(Run.GraphBuilder, Run.View, Run.Input, 4.0);
		EXPECT_EQ(Cropped.Texels, Run.Execute(Output).Texels);
	}
}

TEST(FourTapBlur, OnePixelStaysAsItIs)
{
	const FImage Pixel(1, 1, {0.5, 0.25, 0.125, 1});
	EXPECT_EQ(Pixel.Texels, Blur(Pixel, EBlur::Kawase, 5.0, EArithmetic::Native).Texels);
	EXPECT_EQ(Pixel.Texels, Blur(Pixel, EBlur::Pyramid, 5.0, EArithmetic::Native).Texels);
}

TEST(FourTapBlur, NothingToDoIsTheInput)
{
	FPassRun Run(FImage::Noise(8, 8), EArithmetic::Native);
	EXPECT_EQ(Run.Input, AddKawaseBlurPasses(Run.GraphBuilder, Run.View, Run.Input, 0.0));
	EXPECT_EQ(Run.Input, AddPyramidBlurPasses(Run.GraphBuilder, Run.View, Run.Input, 0.0));
	Run.GraphBuilder.Execute();
}
