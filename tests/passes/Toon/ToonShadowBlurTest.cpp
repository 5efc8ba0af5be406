// Toon-shadow blur: setup, the sum of Gaussians and the three stores, against the article's formulas in double.
#include "PassTestUtils.h"

#include "Toon/ToonShadowBlur.h"

#include <set>

using namespace Drydock;

using namespace PassTest;
using PassReference::FRect;
using PassReference::MaxDifference;

namespace
{

constexpr EToonShadowBlurStore AllStores[] = {
	EToonShadowBlurStore::EightBit, EToonShadowBlurStore::SixteenBit, EToonShadowBlurStore::SqrtEightBit};

FToonShadowBlurInputs MakeInputs(
	EToonShadowBlurStore Store = EToonShadowBlurStore::SqrtEightBit, bool bAsPrinted = false)
{
	FFinalPostProcessSettings Settings;
	Settings.ToonShadowBlurStore = Store;
	FToonShadowBlurInputs Inputs = FToonShadowBlurInputs::FromSettings(Settings, FScreenPassTexture());
	Inputs.bAsPrinted = bAsPrinted;
	return Inputs;
}

FImage Blur(const FImage& Shadow, FToonShadowBlurInputs Inputs)
{
	FPassRun Run(Shadow, EArithmetic::Native, PF_R8G8B8A8);
	Inputs.ToonShadow = Run.Input;
	return Run.Execute(AddToonShadowBlurPasses(Run.GraphBuilder, Run.View, Inputs));
}

/** A lit field with a dark half. */
FImage HalfDark(int Width, int Height)
{
	return FImage::Make(Width, Height,
		[&](int X, int) {
			return X < Width / 2 ? FTexel{0, 1, 0, 0} : FTexel{1, 1, 0, 0};
		});
}

/** Different values of the blurred shadow that are darker than 1/20. */
size_t CountDarkLevels(const FImage& Image, EToonShadowBlurStore Store)
{
	std::set<float> Levels;
	for (const FTexel& Texel : Image.Texels)
	{
		const float Value = Drydock::DecodeToonShadowBlur(static_cast<float>(Texel[3]), Store);
		if (Value < 0.05f)
		{
			Levels.insert(Value);
		}
	}
	return Levels.size();
}

} // namespace

TEST(ToonShadowBlur, OneGaussianEqualsItsFormulaInDouble)
{
	FToonShadowBlurInputs Inputs = MakeInputs(EToonShadowBlurStore::SixteenBit);
	for (FGaussianSumStage& Stage : Inputs.Blur.Stages)
	{
		Stage.Size = 0;
	}
	Inputs.Blur.Stages[5].Size = 10; // of half resolution
	Inputs.Blur.SizeScale = 1;
	for (const auto& [Width, Height] : {std::pair(64, 32), {63, 31}})
	{
		const FImage Shadow = FImage::Noise(Width, Height, 1.0);
		FPassRun Run(Shadow, EArithmetic::Exact, PF_R8G8B8A8);
		Inputs.ToonShadow = Run.Input;
		const FImage Result = Run.Execute(AddToonShadowBlurPasses(Run.GraphBuilder, Run.View, Inputs));

		const FImage Darker = FImage::Make(Width, Height,
			[&](int X, int Y)
			{
				const double Value = std::min(Shadow.At(X, Y)[0], Shadow.At(X, Y)[1]);
				return FTexel{Value, Value, Value, 1};
			});
		const FRect Half{0, 0, (Width + 1) / 2, (Height + 1) / 2};
		const double Radius = Half.MaxX * 0.1 / 2;
		const FImage Blurred =
			PassReference::GaussianBlur(PassReference::Downsample(Darker, {0, 0, Width, Height}, Half, false, false),
				Radius, static_cast<int>(std::ceil(Radius)), PassReference::EAddress::Clamp);
		double Largest = 0;
		for (int Y = 0; Y < Height; ++Y)
		{
			for (int X = 0; X < Width; ++X)
			{
				const FTexel Expected = PassReference::SampleInRect(
					Blurred, Half, (X + 0.5) * Half.MaxX / Width, (Y + 0.5) * Half.MaxY / Height, false);
				Largest = std::max(Largest, std::abs(Expected[0] - Result.At(X, Y)[3]));
			}
		}
		EXPECT_LE(Largest, 1e-5) << Width << "x" << Height;
	}
}

TEST(ToonShadowBlur, ConstantShadowStaysThatConstantToTheEdge)
{
	for (const auto& [Width, Height] : {std::pair(64, 36), {65, 37}, {1, 1}, {7, 1}})
	{
		const FImage Result = Blur(FImage(Width, Height, {0.6, 1, 0, 0}), MakeInputs(EToonShadowBlurStore::SixteenBit));
		EXPECT_LE(MaxDifference(FImage(Width, Height, {0.6, 1, 0, 0.6}), Result, 4), 1e-9) << Width << "x" << Height;
	}
}

TEST(ToonShadowBlur, DarkerOfTheTwoShadowsIsBlurred)
{
	const EToonShadowBlurStore Store = EToonShadowBlurStore::SixteenBit;
	EXPECT_NEAR(0.2, Blur(FImage(32, 32, {0.8, 0.2, 0, 0}), MakeInputs(Store)).At(16, 16)[3], 1e-9);
	EXPECT_NEAR(0.2, Blur(FImage(32, 32, {0.2, 0.8, 0, 0}), MakeInputs(Store)).At(16, 16)[3], 1e-9);
}

TEST(ToonShadowBlur, ShadowsThemselvesAreKeptBitForBit)
{
	const FImage Shadow = HalfDark(33, 17);
	EXPECT_LE(MaxDifference(Shadow, Blur(Shadow, MakeInputs()), 3), 0.0);
}

TEST(ToonShadowBlur, SquareRootStoreHoldsTheRoot)
{
	// sqrt(0.36) = 0.6 = 153/255, exactly a level.
	const FImage Result = Blur(FImage(32, 32, {92 / 255.0, 1, 0, 0}), MakeInputs());
	EXPECT_NEAR(std::round(std::sqrt(92 / 255.0) * 255) / 255, Result.At(16, 16)[3], 1e-9);
}

TEST(ToonShadowBlur, EncodeAndDecodeAreInverse)
{
	for (const EToonShadowBlurStore Store : AllStores)
	{
		for (const float Value : {0.0f, 0.01f, 0.5f, 1.0f})
		{
			EXPECT_NEAR(Value, Drydock::DecodeToonShadowBlur(Drydock::EncodeToonShadowBlur(Value, Store), Store), 1e-7);
		}
	}
	EXPECT_EQ(0.5f, Drydock::EncodeToonShadowBlur(0.25f, EToonShadowBlurStore::SqrtEightBit));
}

TEST(ToonShadowBlur, BlurFallsMonotonelyIntoTheDark)
{
	for (const EToonShadowBlurStore Store : AllStores)
	{
		const FImage Result = Blur(HalfDark(128, 64), MakeInputs(Store));
		for (int X = 1; X < 128; ++X)
		{
			// Bands may be flat, but never step back by more than the rounding of an 8-bit temporary.
			EXPECT_LE(
				Result.At(X - 1, 32)[3], Result.At(X, 32)[3] + (Store == EToonShadowBlurStore::EightBit ? 0.03 : 0))
				<< X;
		}
		EXPECT_LT(Result.At(0, 32)[3], 0.5);
		EXPECT_GT(Result.At(127, 32)[3], 0.5);
	}
}

TEST(ToonShadowBlur, SquareRootStoreHasMoreLevelsInTheDark)
{
	// A faint light far away: what is stored lies in the lowest levels.
	const auto Corner = [](int X, int Y)
	{
		return X > 250 && Y > 140 ? FTexel{1, 1, 0, 0} : FTexel{0, 1, 0, 0};
	};
	const FImage Shadow = FImage::Make(256, 144, Corner);
	const auto Count = [&](EToonShadowBlurStore Store)
	{
		return CountDarkLevels(Blur(Shadow, MakeInputs(Store)), Store);
	};
	// Below 1/20 lie 13 linear levels of 8 bit, and 57 squares of them.
	EXPECT_LE(Count(EToonShadowBlurStore::SixteenBit), 13u);
	EXPECT_GE(Count(EToonShadowBlurStore::SqrtEightBit), 26u);
}

TEST(ToonShadowBlur, TemporariesHaveTheFormatOfTheStore)
{
	EXPECT_EQ(PF_G8, Drydock::GetToonShadowBlurFormat(EToonShadowBlurStore::EightBit));
	EXPECT_EQ(PF_R16F, Drydock::GetToonShadowBlurFormat(EToonShadowBlurStore::SixteenBit));
	EXPECT_EQ(PF_R16F, Drydock::GetToonShadowBlurFormat(EToonShadowBlurStore::SqrtEightBit));
}

TEST(ToonShadowBlur, AsPrintedTheEdgeOfTheFrameDarkens)
{
	const FImage Lit(512, 288, {1, 1, 0, 0}); // wide enough for kernels of some texels on the coarse levels
	EXPECT_EQ(1, Blur(Lit, MakeInputs(EToonShadowBlurStore::SixteenBit)).At(0, 0)[3]);
	// A corner keeps a quarter of the wide stages, which are a quarter of the tints: about 0.8.
	EXPECT_NEAR(0.8, Blur(Lit, MakeInputs(EToonShadowBlurStore::SixteenBit, true)).At(0, 0)[3], 0.05);
}

TEST(ToonShadowBlur, WithoutAnyStageTheShadowCountsAsLit)
{
	FToonShadowBlurInputs Inputs = MakeInputs();
	Inputs.Blur.StageCount = 0;
	EXPECT_EQ(1, Blur(FImage(8, 8, {0, 0, 0, 0}), Inputs).At(4, 4)[3]);
}

TEST(ToonShadowBlur, OffsetRectEqualsTheCroppedShadow)
{
	const FImage Shadow = HalfDark(32, 16);
	const FImage Cropped = Blur(Shadow, MakeInputs());
	FPassRun Run(Shadow, {8, 4, 40, 20}, FIntPoint(64, 32), EArithmetic::Native, PF_R8G8B8A8);
	FToonShadowBlurInputs Inputs = MakeInputs();
	Inputs.ToonShadow = Run.Input;
	const FScreenPassTexture Output = AddToonShadowBlurPasses(Run.GraphBuilder, Run.View, Inputs);
	EXPECT_EQ(FIntRect(8, 4, 40, 20), Output.ViewRect);
	EXPECT_LE(MaxDifference(Cropped, Run.Execute(Output), 4), 1.0 / 255);
}

TEST(ToonShadowBlur, QualityIsClampedAndChoosesTheStages)
{
	FFinalPostProcessSettings Settings;
	Settings.ToonShadowBlurQuality = 0;
	EXPECT_EQ(3u, FToonShadowBlurInputs::FromSettings(Settings, {}).Blur.StageCount);
	Settings.ToonShadowBlurQuality = 9;
	EXPECT_EQ(6u, FToonShadowBlurInputs::FromSettings(Settings, {}).Blur.StageCount);
}
