// Convolution bloom against a direct sum in double, its split of energy, pre-filter and padding.
#include "FFTBloomTestUtils.h"

#include "Bloom/ToonBloomSetup.h"

#include <functional>

using namespace Drydock;

using namespace PassTest;
using PassReference::MaxDifference;
using PassReference::SumOf;

namespace
{

/** The shape that is convolved with: sums to 1, the middle no brighter than the rest. */
FImage NormalizeKernel(FImage Kernel)
{
	const int Middle = Kernel.Height / 2 * Kernel.Width + Kernel.Width / 2;
	for (size_t Channel = 0; Channel < 3; ++Channel)
	{
		double Largest = 0;
		for (int Index = 0; Index < int(Kernel.Texels.size()); ++Index)
		{
			Largest = Index == Middle ? Largest : std::max(Largest, Kernel.Texels[size_t(Index)][Channel]);
		}
		double& Center = Kernel.Texels[size_t(Middle)][Channel];
		Center = std::min(Center, Largest);
		const double Sum = SumOf(Kernel, int(Channel));
		for (FTexel& Texel : Kernel.Texels)
		{
			Texel[Channel] /= Sum;
		}
	}
	return Kernel;
}

/** Part of a kernel's energy that lies outside its middle texel. */
double GetScatter(const FImage& Kernel, int Channel)
{
	const double Total = SumOf(Kernel, Channel);
	return 1 - Kernel.At(Kernel.Width / 2, Kernel.Height / 2)[size_t(Channel)] / Total;
}

/** Sum over all offsets from the kernel's middle; black outside the picture. Scale: by channel. */
FImage ConvolveDirectly(const FImage& Picture, const FImage& Shape, const FTexel& Scale)
{
	FImage Result(Picture.Width, Picture.Height);
	const int MiddleX = Shape.Width / 2, MiddleY = Shape.Height / 2;
	for (int Y = 0; Y < Picture.Height; ++Y)
	{
		for (int X = 0; X < Picture.Width; ++X)
		{
			for (int J = 0; J < Shape.Height; ++J)
			{
				for (int I = 0; I < Shape.Width; ++I)
				{
					const int FromX = X - (I - MiddleX), FromY = Y - (J - MiddleY);
					if (FromX >= 0 && FromX < Picture.Width && FromY >= 0 && FromY < Picture.Height)
					{
						for (size_t Channel = 0; Channel < 3; ++Channel)
						{
							Result.At(X, Y)[Channel] +=
								Picture.At(FromX, FromY)[Channel] * Shape.At(I, J)[Channel] * Scale[Channel];
						}
					}
				}
			}
		}
	}
	return Result;
}

/** Tint times the part that is moved, for s = 1. */
FTexel GetBloomEnergy(const FImage& Kernel)
{
	const double Largest = std::max({SumOf(Kernel, 0), SumOf(Kernel, 1), SumOf(Kernel, 2)});
	FTexel Energy{};
	for (int Channel = 0; Channel < 3; ++Channel)
	{
		Energy[size_t(Channel)] = SumOf(Kernel, Channel) / Largest * GetScatter(Kernel, Channel);
	}
	return Energy;
}

double LargestOf(const FImage& Image)
{
	return MaxDifference(Image, FImage(Image.Width, Image.Height));
}

} // namespace

class FFTBloom : public testing::TestWithParam<EArithmetic>
{
};
INSTANTIATE_TEST_SUITE_P(Arithmetic, FFTBloom, testing::ValuesIn(SnappedArithmetic), FArithmeticName());

TEST_P(FFTBloom, EqualsTheDirectConvolution)
{
	for (const FIntPoint Size : {FIntPoint(129, 67), FIntPoint(67, 129)})
	{
		const FImage Picture = FImage::Noise(Size.X, Size.Y, 16.0), Kernel = MakeAsymmetricKernel(31, 21);
		const FTestKernel Pixels(Kernel);
		const FImage Expected = ConvolveDirectly(Picture, NormalizeKernel(Kernel), GetBloomEnergy(Kernel));
		const FBloom Result = MakeBloom(Picture, MakeSettings(Picture, Kernel), GetParam());
		EXPECT_LT(MaxDifference(Expected, Result.Bloom), 1e-5 * LargestOf(Expected)) << Size.X << "x" << Size.Y;
	}
}

TEST_P(FFTBloom, EqualsTheDirectConvolutionWhereMostOfTheKernelReachesNoPixel)
{
	for (const int Height : {1, 2, 3, 9})
	{
		const FImage Picture = FImage::Noise(129, Height, 16.0), Kernel = MakeAsymmetricKernel(31, 61);
		const FTestKernel Pixels(Kernel);
		const FImage Expected = ConvolveDirectly(Picture, NormalizeKernel(Kernel), GetBloomEnergy(Kernel));
		const FBloom Result = MakeBloom(Picture, MakeSettings(Picture, Kernel), GetParam());
		EXPECT_LT(MaxDifference(Expected, Result.Bloom), 1e-5 * LargestOf(Expected)) << Height;
		// A line of 31 texels and half of it: 256 wide. No offset is larger than the height less 1.
		const int Lines = Height == 1 ? 2 : Height == 9 ? 32 : Height == 3 ? 8 : 4;
		EXPECT_TRUE(Contains(Result.Passes, "FFTBloom.ResizeKernel 256x" + std::to_string(Lines) + " ")) << Height;
		EXPECT_TRUE(Contains(Result.Passes, "FFTBloom.SumWholeKernel"));
	}
}

TEST_P(FFTBloom, AnySize)
{
	for (const FIntPoint Size : {FIntPoint(1, 1), FIntPoint(2, 1), FIntPoint(1, 7), FIntPoint(3, 2), FIntPoint(31, 17),
			 FIntPoint(64, 64), FIntPoint(97, 53)})
	{
		const FImage Picture = FImage::Noise(Size.X, Size.Y), Kernel = MakeAsymmetricKernel(Size.X > 5 ? 5 : 1, 3);
		const FTestKernel Pixels(Kernel);
		const FImage Expected = ConvolveDirectly(Picture, NormalizeKernel(Kernel), GetBloomEnergy(Kernel));
		const FBloom Result = MakeBloom(Picture, MakeSettings(Picture, Kernel), GetParam());
		EXPECT_LT(MaxDifference(Expected, Result.Bloom), 1e-5) << Size.X << "x" << Size.Y;
	}
}

TEST_P(FFTBloom, AnImpulseGivesTheKernel)
{
	const FImage Picture = MakeImpulse(33, 33), Kernel = MakeAsymmetricKernel(9, 9), Shape = NormalizeKernel(Kernel);
	const FTestKernel Pixels(Kernel);
	const FImage Bloom = MakeBloom(Picture, MakeSettings(Picture, Kernel), GetParam()).Bloom;
	const FTexel Energy = GetBloomEnergy(Kernel);
	for (int Y = 0; Y < 9; ++Y)
	{
		for (int X = 0; X < 9; ++X)
		{
			EXPECT_NEAR(Shape.At(X, Y)[1] * Energy[1], Bloom.At(12 + X, 12 + Y)[1], 1e-7) << X << ", " << Y;
		}
	}
}

TEST_P(FFTBloom, TheCenterUVLiesOnTheSource)
{
	// The centre of texel (6, 3) in place of (4, 4): all comes two pixels farther left and one lower.
	const FImage Picture = MakeImpulse(33, 33), Kernel = MakeAsymmetricKernel(9, 9);
	const FTestKernel Pixels(Kernel);
	FFinalPostProcessSettings Settings = MakeSettings(Picture, Kernel);
	const FImage Centred = MakeBloom(Picture, Settings, GetParam()).Bloom;
	Settings.BloomConvolutionCenterUV = FVector2D(6.5 / 9, 3.5 / 9);
	const FImage Moved = MakeBloom(Picture, Settings, GetParam()).Bloom;
	for (int Y = 2; Y < 31; ++Y)
	{
		for (int X = 2; X < 31; ++X)
		{
			EXPECT_NEAR(Centred.At(X, Y)[0], Moved.At(X - 2, Y + 1)[0], 1e-7) << X << ", " << Y;
		}
	}
}

TEST_P(FFTBloom, MovesEnergyAndAddsNone)
{
	// All light is farther than the kernel's radius from the picture's edges.
	FImage Picture(61, 47);
	const FImage Light = FImage::Noise(21, 15, 64.0, 5);
	for (int Y = 0; Y < 15; ++Y)
	{
		std::copy_n(&Light.At(0, Y), 21, &Picture.At(20, 16 + Y));
	}
	const FImage Kernel = MakeGreyKernel(15);
	const FTestKernel Pixels(Kernel);
	FFinalPostProcessSettings Settings = MakeSettings(Picture, Kernel);
	for (const float Dispersion : {0.25f, 0.5f, 1.0f, 2.0f})
	{
		Settings.BloomConvolutionScatterDispersion = Dispersion;
		const FBloom Result = MakeBloom(Picture, Settings, GetParam());
		EXPECT_NEAR(1 - double(Dispersion) / 3, Result.SceneColor[0], 1e-6);
		for (int Channel = 0; Channel < 3; ++Channel)
		{
			const double Scene = SumOf(Picture, Channel) * Result.SceneColor[size_t(Channel)];
			EXPECT_NEAR(1, (Scene + SumOf(Result.Bloom, Channel)) / SumOf(Picture, Channel), 1e-6) << Dispersion;
		}
	}
}

TEST(FFTBloomEnergy, IntensityTimesDispersionCounts)
{
	const FImage Picture = MakeImpulse(21, 21), Kernel = MakeGreyKernel(5);
	const FTestKernel Pixels(Kernel);
	FFinalPostProcessSettings Settings = MakeSettings(Picture, Kernel);
	Settings.BloomIntensity = 0.5f;
	Settings.BloomConvolutionScatterDispersion = 1.5f;
	// 1 - 0.75 / 3.
	EXPECT_NEAR(0.75, MakeBloom(Picture, Settings).SceneColor[1], 1e-6);
}

TEST(FFTBloomEnergy, NoMoreIsMovedThanThereIs)
{
	const FImage Picture = MakeImpulse(21, 21), Kernel = MakeGreyKernel(5);
	const FTestKernel Pixels(Kernel);
	FFinalPostProcessSettings Settings = MakeSettings(Picture, Kernel);
	Settings.BloomConvolutionScatterDispersion = 20.0f;
	const FBloom Result = MakeBloom(Picture, Settings);
	EXPECT_EQ(0, Result.SceneColor[0]);
	EXPECT_NEAR(1, SumOf(Result.Bloom, 0), 1e-6);
}

TEST(FFTBloomEnergy, TheKernelsColourTintsBoth)
{
	const FImage Picture = MakeImpulse(21, 21);
	FImage Kernel = MakeGreyKernel(5);
	for (FTexel& Texel : Kernel.Texels)
	{
		Texel = {Texel[0], Texel[1] * 0.5, 0, 1};
	}
	const FTestKernel Pixels(Kernel);
	const FBloom Result = MakeBloom(Picture, MakeSettings(Picture, Kernel));
	EXPECT_NEAR(2.0 / 3, Result.SceneColor[0], 1e-6);
	EXPECT_NEAR(0.5 * 2.0 / 3, Result.SceneColor[1], 1e-6);
	EXPECT_EQ(0, Result.SceneColor[2]);
	EXPECT_NEAR(1.0 / 3, SumOf(Result.Bloom, 0), 1e-6);
	EXPECT_NEAR(0.5 / 3, SumOf(Result.Bloom, 1), 1e-6);
	EXPECT_EQ(0, SumOf(Result.Bloom, 2));
}

TEST(FFTBloomEnergy, KernelsWithoutScatterLeaveThePicture)
{
	const FImage Picture = FImage::Noise(21, 21);
	for (const FImage& Kernel :
		{MakeImpulse(5, 5), FImage(5, 5), FImage(1, 1, {1, 1, 1, 1}), FImage(3, 3, {NaN, NaN, NaN, 1})})
	{
		const FTestKernel Pixels(Kernel);
		const FBloom Result = MakeBloom(Picture, MakeSettings(Picture, Kernel));
		EXPECT_EQ((FTexel{1, 1, 1, 1}), Result.SceneColor);
		EXPECT_EQ(0, LargestOf(Result.Bloom));
	}
}

TEST(FFTBloomPadding, IsHalfOfWhatReachesOut)
{
	// ceil(0.5 * min(1, 0.133) * 1920) = ceil(127.68)
	EXPECT_EQ(128, Drydock::ComputeFFTBloomPadding(FIntPoint(1920, 1080), 1.0f, 0.133f));
	EXPECT_EQ(960, Drydock::ComputeFFTBloomPadding(FIntPoint(1920, 1080), 1.0f, 0.0f));
	EXPECT_EQ(96, Drydock::ComputeFFTBloomPadding(FIntPoint(1920, 1080), 0.1f, 0.133f));
	EXPECT_EQ(0, Drydock::ComputeFFTBloomPadding(FIntPoint(1920, 1080), 0.0f, 0.133f));
}

TEST(FFTBloomPadding, KeepsOneSideFromTheOther)
{
	// A light at the right edge of 127 pixels, a kernel that reaches 15: padded to 256 it stays on its side; with a
	// padding of 1 the transform is 128 wide and the kernel's right part comes in from the left, up to pixel 13.
	FImage Picture(127, 16);
	Picture.At(126, 8) = {1, 1, 1, 1};
	const FImage Kernel = MakeGreyKernel(31);
	const FTestKernel Pixels(Kernel);
	FFinalPostProcessSettings Settings = MakeSettings(Picture, Kernel);
	EXPECT_NEAR(0, MakeBloom(Picture, Settings).Bloom.At(0, 8)[0], 1e-9);
	Settings.BloomConvolutionBufferScale = 1e-6f;
	const FImage Wrapped = MakeBloom(Picture, Settings).Bloom;
	const double Expected = 1.0 / 3 / (31 * 31);
	EXPECT_NEAR(Expected, Wrapped.At(0, 8)[0], 1e-8);
	EXPECT_NEAR(Expected, Wrapped.At(13, 8)[0], 1e-8);
	EXPECT_NEAR(0, Wrapped.At(14, 8)[0], 1e-8);
}

TEST(FFTBloomPreFilter, BoostsFromTheMinimumToTheMaximum)
{
	// min(15 * (L - 7) + 7, 100) above 7: 8 becomes 22, 1000 becomes 100, 7 and 2 stay. A third of it is bloom.
	const FImage Kernel = MakeGreyKernel(3);
	const FTestKernel Pixels(Kernel);
	for (const auto& [Light, Boosted] :
		std::vector<std::pair<double, double>>{{8, 22}, {1000, 100}, {7, 7}, {2, 2}, {0, 0}})
	{
		const FImage Picture = MakeImpulse(17, 17, Light);
		FFinalPostProcessSettings Settings = MakeSettings(Picture, Kernel);
		Settings.BloomConvolutionPreFilterMin = 7.0f;
		Settings.BloomConvolutionPreFilterMax = 100.0f;
		Settings.BloomConvolutionPreFilterMult = 15.0f;
		EXPECT_NEAR(Boosted / 3, SumOf(MakeBloom(Picture, Settings).Bloom, 0), 1e-5) << Light;
	}
}

TEST(FFTBloomPreFilter, KeepsTheHue)
{
	// Luminance 0.3 * 20 = 6 becomes 2 * (6 - 1) + 1 = 11: red 20 * 11 / 6.
	FImage Picture(17, 17);
	Picture.At(8, 8) = {20, 0, 0, 1};
	const FImage Kernel = MakeGreyKernel(3);
	const FTestKernel Pixels(Kernel);
	FFinalPostProcessSettings Settings = MakeSettings(Picture, Kernel);
	Settings.BloomConvolutionPreFilterMin = 1.0f;
	Settings.BloomConvolutionPreFilterMax = 100.0f;
	Settings.BloomConvolutionPreFilterMult = 2.0f;
	const FImage Bloom = MakeBloom(Picture, Settings).Bloom;
	EXPECT_NEAR(20 * 11 / 6.0 / 3, SumOf(Bloom, 0), 1e-4);
	EXPECT_EQ(0, SumOf(Bloom, 1));
}

TEST(FFTBloomPreFilter, CountsInSceneUnits)
{
	const FImage Kernel = MakeGreyKernel(3), Picture = MakeImpulse(17, 17, 2);
	const FTestKernel Pixels(Kernel);
	FPassRun Run(Picture, EArithmetic::Native, PF_A32B32G32R32F);
	Run.View.FinalPostProcessSettings = MakeSettings(Picture, Kernel);
	Run.View.FinalPostProcessSettings.BloomConvolutionPreFilterMin = 7.0f;
	Run.View.FinalPostProcessSettings.BloomConvolutionPreFilterMax = 100.0f;
	Run.View.FinalPostProcessSettings.BloomConvolutionPreFilterMult = 15.0f;
	Run.View.PreExposure = 0.25f;
	Run.View.InitViewUniformBuffer(FIntPoint(17, 17));
	// 2 / 0.25 = 8 becomes 22.
	EXPECT_NEAR(22 * 0.25 / 3, SumOf(Execute(Run, {Run.Input, {}, {}}).Bloom, 0), 1e-5);
}

TEST(FFTBloomPreFilter, BadPixelsAreReplacedAndSpoilNothingElse)
{
	const FImage Clean = FImage::Noise(23, 19), Kernel = MakeAsymmetricKernel(5, 5);
	const FTestKernel Pixels(Kernel);
	const FFinalPostProcessSettings Settings = MakeSettings(Clean, Kernel);
	for (const auto& [Bad, Counted] : std::vector<std::pair<double, double>>{
			 {NaN, 0}, {Infinity, 65504}, {-Infinity, 0}, {1e30, 65504}, {-1e30, 0}, {-3, -3}})
	{
		FImage Dirty = Clean, Replaced = Clean;
		Dirty.At(11, 9) = {Bad, Bad, Bad, 1};
		Replaced.At(11, 9) = {Counted, Counted, Counted, 1};
		EXPECT_EQ(MakeBloom(Replaced, Settings).Bloom.Texels, MakeBloom(Dirty, Settings).Bloom.Texels) << Bad;
	}
}

TEST(FFTBloomResolution, IsAPartOfTheView)
{
	EXPECT_EQ(1.0f, GetFFTBloomResolutionFraction(FIntPoint(1920, 1080)));
	EXPECT_EQ(0.5f, GetFFTBloomResolutionFraction(FIntPoint(16384, 16)));
	const FScopedConsoleVariable Percentage(TEXT("r.Bloom.ScreenPercentage"), 50.0f);
	EXPECT_EQ(0.5f, GetFFTBloomResolutionFraction(FIntPoint(1920, 1080)));
	const FScopedConsoleVariable Least(TEXT("r.Bloom.ScreenPercentage"), 1.0f);
	EXPECT_EQ(0.1f, GetFFTBloomResolutionFraction(FIntPoint(1920, 1080)));
}

TEST(FFTBloomResolution, LessGivesTheSameEnergyInFewerPixels)
{
	const FScopedConsoleVariable Percentage(TEXT("r.Bloom.ScreenPercentage"), 50.0f);
	FImage Picture(40, 30);
	for (const FIntPoint Pixel : {FIntPoint(20, 14), FIntPoint(21, 14), FIntPoint(20, 15), FIntPoint(21, 15)})
	{
		Picture.At(Pixel.X, Pixel.Y) = {4, 4, 4, 1};
	}
	const FImage Kernel = MakeGreyKernel(5);
	const FTestKernel Pixels(Kernel);
	const FImage Bloom = MakeBloom(Picture, MakeSettings(Picture, Kernel)).Bloom;
	EXPECT_EQ(20, Bloom.Width);
	EXPECT_EQ(15, Bloom.Height);
	// One pixel of 4, the mean of the four.
	EXPECT_NEAR(4.0 / 3, SumOf(Bloom, 0), 1e-5);
}

TEST(FFTBloomInput, ReadsNothingOutsideTheRect)
{
	const FImage Picture = FImage::Noise(20, 14), Kernel = MakeAsymmetricKernel(5, 5);
	const FTestKernel Pixels(Kernel);
	const FFinalPostProcessSettings Settings = MakeSettings(Picture, Kernel);
	const FImage Expected = MakeBloom(Picture, Settings).Bloom;
	FPassRun Run(Picture, {3, 5, 23, 19}, FIntPoint(32, 32), EArithmetic::Native, PF_A32B32G32R32F);
	Run.View.FinalPostProcessSettings = Settings;
	EXPECT_EQ(Expected.Texels, Execute(Run, {Run.Input, {}, {}}).Bloom.Texels);
}

TEST(FFTBloomEnabled, NeedsMethodIntensityStateAndKernel)
{
	FViewInfo View(nullptr, FIntRect(0, 0, 8, 8), FIntPoint(8, 8));
	FSceneViewState State(1);
	View.State = &State;
	View.FinalPostProcessSettings.BloomMethod = BM_FFT;
	EXPECT_TRUE(IsFFTBloomEnabled(View)) << "None is the built-in kernel";
	View.FinalPostProcessSettings.BloomConvolutionTexture = Drydock::FindOrAddTexture("Nowhere/Kernel");
	EXPECT_FALSE(IsFFTBloomEnabled(View));
	View.FinalPostProcessSettings.BloomConvolutionTexture = Drydock::FindOrAddTexture("Builtin/Disc");
	EXPECT_TRUE(IsFFTBloomEnabled(View));
	View.State = nullptr;
	EXPECT_FALSE(IsFFTBloomEnabled(View));
	View.State = &State;
	View.FinalPostProcessSettings.BloomIntensity = 0.0f;
	EXPECT_FALSE(IsFFTBloomEnabled(View));
	View.FinalPostProcessSettings.BloomIntensity = 1.0f;
	View.FinalPostProcessSettings.BloomMethod = BM_SOG;
	EXPECT_FALSE(IsFFTBloomEnabled(View));
}

TEST(FFTBloomToon, TheSetupMasksWhatIsConvolved)
{
	const FImage Picture = FImage::Noise(33, 17, 4.0), Kernel = MakeAsymmetricKernel(5, 5);
	const FTestKernel Pixels(Kernel);
	const FFinalPostProcessSettings Settings = MakeSettings(Picture, Kernel);
	const auto IsToon = [](int X, int Y)
	{
		return (X / 3 + Y) % 2 == 0;
	};
	const FImage Masked = FImage::Make(33, 17,
		[&](int X, int Y)
		{
			const FTexel& Color = Picture.At(X, Y);
			const double Factor = IsToon(X, Y) ? 0.25 : 1;
			return FTexel{Color[0] * Factor, Color[1] * Factor, Color[2] * Factor, 1};
		});
	const FImage Expected = MakeBloom(Masked, Settings).Bloom;

	FPassRun Run(Picture, EArithmetic::Native, PF_A32B32G32R32F);
	const FImage Ids = FImage::Make(33, 17,
		[&](int X, int Y) {
			return FTexel{0, 0, 0, (IsToon(X, Y) ? 8 : 1) / 255.0};
		});
	FSceneTextures SceneTextures;
	SceneTextures.Color = Run.Input.Texture;
	SceneTextures.GBufferB = Run.AddInput(Ids, PF_B8G8R8A8, TEXT("GBufferB")).Texture;
	Run.View.SceneTextures = &SceneTextures;
	Run.View.FinalPostProcessSettings = Settings;
	FBloomSetupInputs Setup;
	Setup.SceneColor = Run.Input;
	Setup.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(Run.GraphBuilder, 1.0f);
	Setup.Threshold = -1.0f;
	const FToonBloomInputs Toon = {Run.Input, CreateSceneTextureUniformBuffer(Run.GraphBuilder, Run.View), 0.25f};
	const FBloom Result = Execute(Run, {AddToonBloomSetupPass(Run.GraphBuilder, Run.View, Setup, Toon), {}, {}});
	EXPECT_EQ(Expected.Texels, Result.Bloom.Texels);
}

TEST(FFTBloomApply, MultipliesTheSceneColour)
{
	const FImage Picture = FImage::Noise(9, 7), Kernel = MakeGreyKernel(3);
	const FTestKernel Pixels(Kernel);
	FPassRun Run(Picture, EArithmetic::Native, PF_A32B32G32R32F);
	Run.View.FinalPostProcessSettings = MakeSettings(Picture, Kernel);
	const FFFTBloomOutput Bloom = AddFFTBloomPass(Run.GraphBuilder, Run.View, {Run.Input, {}, {}});
	const FImage Result = Run.Execute(
		Drydock::AddApplyFFTBloomPass(Run.GraphBuilder, Run.View, Run.Input, Bloom.SceneColorApplyParameters));
	EXPECT_NEAR(Picture.At(4, 2)[1] * 2 / 3, Result.At(4, 2)[1], 1e-6);
	EXPECT_EQ(1, Result.At(4, 2)[3]);
}
