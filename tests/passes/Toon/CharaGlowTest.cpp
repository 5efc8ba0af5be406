// CharaGlow: the box, its fractional ring and its native kernel, the composition, both forms, hazards.
#include "PassTestUtils.h"

#include "Toon/CharaGlow.h"

using namespace Drydock;

using namespace PassTest;
using PassReference::FRect;
using PassReference::MaxDifference;

namespace
{

/** The mask lies in blue, as in the G-buffer. */
FImage MakeMask(int Width, int Height, const std::function<double(int, int)>& Mask)
{
	return FImage::Make(Width, Height, [&](int X, int Y) { return FTexel{0, 0, Mask(X, Y), 0}; });
}

FImage Square(int Size)
{
	return MakeMask(
		Size, Size, [=](int X, int Y) { return std::abs(X - Size / 2) <= 2 && std::abs(Y - Size / 2) <= 2; });
}

struct FGlowRun
{
	FCharaGlowInputs Inputs;
	FTexel Color = {0.25, 0.5, 1, 0.5};
	EArithmetic Arithmetic = EArithmetic::Float32;
	FIntPoint Padding = FIntPoint(0, 0);
	bool bOnlyMask = false;

	FImage Run(const FImage& Mask) const
	{
		const FRect Rect{Padding.X, Padding.Y, Padding.X + Mask.Width, Padding.Y + Mask.Height};
		const FIntPoint Extent(Mask.Width + 2 * Padding.X, Mask.Height + 2 * Padding.Y);
		FPassRun Pass(FImage(Mask.Width, Mask.Height, Color), Rect, Extent, Arithmetic, PF_A32B32G32R32F);
		FSceneTextures SceneTextures;
		SceneTextures.GBufferD = Pass.AddInput(Mask, Rect, Extent, PF_A32B32G32R32F, TEXT("GBufferD")).Texture;
		FCharaGlowInputs Glow = Inputs;
		Glow.SceneColor = Pass.Input;
		Glow.SceneTextures = CreateSceneTextureUniformBuffer(Pass.GraphBuilder, &SceneTextures);
		return Pass.Execute(bOnlyMask ? AddCharaGlowPasses(Pass.GraphBuilder, Pass.View, Glow)
									  : AddCharaGlow(Pass.GraphBuilder, Pass.View, Glow));
	}
};

FImage Widen(const FImage& Mask, float Area, bool bAsPrinted = false, EArithmetic Arithmetic = EArithmetic::Float32)
{
	FGlowRun Run;
	Run.Inputs.Area = Area;
	Run.Inputs.bAsPrinted = bAsPrinted;
	Run.Arithmetic = Arithmetic;
	Run.bOnlyMask = true;
	return Run.Run(Mask);
}

/** The box as a double sum over texels, edge texels repeated. */
double Box(const FImage& Mask, int X, int Y, double Area)
{
	const int Radius = static_cast<int>(Area);
	const double Fraction = Area - Radius;
	double Sum = 0, Weights = 0;
	for (int TapY = -Radius - 1; TapY <= Radius + 1; ++TapY)
	{
		for (int TapX = -Radius - 1; TapX <= Radius + 1; ++TapX)
		{
			const double Weight = (std::abs(TapX) > Radius ? Fraction : 1) * (std::abs(TapY) > Radius ? Fraction : 1);
			Sum +=
				Weight * Mask.At(std::clamp(X + TapX, 0, Mask.Width - 1), std::clamp(Y + TapY, 0, Mask.Height - 1))[2];
			Weights += Weight;
		}
	}
	return Sum / Weights;
}

double MaxError(const FImage& Mask, const FImage& Widened, double Area)
{
	double Largest = 0;
	for (int Y = 0; Y < Mask.Height; ++Y)
	{
		for (int X = 0; X < Mask.Width; ++X)
		{
			Largest = std::max(Largest, std::abs(Box(Mask, X, Y, Area) - Widened.At(X, Y)[0]));
		}
	}
	return Largest;
}

} // namespace

TEST(CharaGlow, BoxEqualsTheDirectSum)
{
	const FImage Mask = FImage::Noise(37, 23);
	for (const float Area : {1.0f, 2.5f, 7.75f, 40.0f})
	{
		EXPECT_LE(MaxError(Mask, Widen(Mask, Area), Area), 2e-6) << Area;
	}
}

TEST(CharaGlow, ShaderEqualsTheDirectSum)
{
	const FScopedConsoleVariable Native(TEXT("r.Drydock.NativeKernels"), 0);
	const FImage Mask = FImage::Noise(37, 23);
	for (const float Area : {1.0f, 2.5f, 7.75f})
	{
		EXPECT_LE(MaxError(Mask, Widen(Mask, Area), Area), 2e-6) << Area;
	}
}

TEST(CharaGlow, NativeKernelAndShaderAgreeWithinTheStatedBound)
{
	const FImage Mask = FImage::Noise(130, 70); // several tiles
	const FImage Native = Widen(Mask, 12.25f);
	const FScopedConsoleVariable Switch(TEXT("r.Drydock.NativeKernels"), 0);
	EXPECT_LE(MaxDifference(Widen(Mask, 12.25f), Native, 1), 2e-6);
}

TEST(CharaGlow, PrintedBoxTakesTheWholePartOfTheArea)
{
	const FImage Mask = FImage::Noise(21, 13);
	EXPECT_LE(MaxError(Mask, Widen(Mask, 2.9f, true), 2), 2e-6);
}

TEST(CharaGlow, BothFormsAgreeOnWholeAreas)
{
	const FImage Mask = FImage::Noise(21, 13);
	EXPECT_LE(MaxDifference(Widen(Mask, 3.0f, true), Widen(Mask, 3.0f), 1), 2e-6);
}

TEST(CharaGlow, AreaGrowsWithoutASteep)
{
	// From just below a whole area to it, the corrected form moves by no more than the small step; the printed one
	// pops.
	const FImage Mask = Square(21);
	EXPECT_LE(MaxDifference(Widen(Mask, 2.999f), Widen(Mask, 3.0f), 1), 0.001);
	EXPECT_GE(MaxDifference(Widen(Mask, 2.999f, true), Widen(Mask, 3.0f, true), 1), 0.05);
}

TEST(CharaGlow, ConstantMaskStaysConstantToTheEdge)
{
	const FImage Mask = MakeMask(9, 5, [](int, int) { return 0.5; });
	for (const float Area : {0.5f, 3.0f, 100.0f})
	{
		EXPECT_LE(MaxError(Mask, Widen(Mask, Area), Area), 1e-6) << Area;
	}
}

TEST(CharaGlow, GlowIsWhatTheWidenedMaskHasOutsideTheMask)
{
	FGlowRun Run;
	Run.Inputs.Area = 1.0f;
	Run.Inputs.Color = FLinearColor(1.0f, 0.5f, 2.0f, 0.5f);
	const FImage Mask = MakeMask(8, 8, [](int X, int) { return X >= 4; });
	const FImage Result = Run.Run(Mask);
	// One column left of the mask a third of the box is inside; half of that by the colour's alpha.
	EXPECT_NEAR(0.25 + 1.0 / 6, Result.At(3, 4)[0], 1e-6);
	EXPECT_NEAR(0.5 + 0.5 / 6, Result.At(3, 4)[1], 1e-6);
	EXPECT_NEAR(1 + 2.0 / 6, Result.At(3, 4)[2], 1e-6);
	EXPECT_EQ(0.5, Result.At(3, 4)[3]);
	// Inside the mask and far from it nothing changes.
	EXPECT_EQ((FTexel{0.25, 0.5, 1, 0.5}), Result.At(5, 4));
	EXPECT_EQ((FTexel{0.25, 0.5, 1, 0.5}), Result.At(1, 4));
}

TEST(CharaGlow, PrintedLastPassWritesAlphaOneEverywhere)
{
	FGlowRun Run;
	Run.Inputs.Area = 1.0f;
	Run.Inputs.bAsPrinted = true;
	Run.Inputs.MaskBounds = FIntRect(4, 0, 8, 8); // the glow reaches two columns further
	const FImage Result = Run.Run(MakeMask(8, 8, [](int X, int) { return X >= 4; }));
	EXPECT_EQ((FTexel{0.25, 0.5, 1, 1}), Result.At(0, 4));
	EXPECT_NEAR(0.25 + 1.0 / 3, Result.At(3, 4)[0], 1e-6);
	EXPECT_EQ(1.0, Result.At(3, 4)[3]);
	EXPECT_EQ(1.0, Result.At(6, 4)[3]);
}

TEST(CharaGlow, NoAreaBuildsNothing)
{
	for (const float Area : {0.0f, -2.0f, std::numeric_limits<float>::quiet_NaN()})
	{
		FGlowRun Run;
		Run.Inputs.Area = Area;
		const FImage Mask = Square(9);
		EXPECT_EQ(FImage(9, 9, {0.25, 0.5, 1, 0.5}).Texels, Run.Run(Mask).Texels);
	}
}

TEST(CharaGlow, MaskEverywhereOrNowhereGlowsNot)
{
	FGlowRun Run;
	Run.Inputs.Area = 4.0f;
	for (const double Value : {0.0, 1.0})
	{
		EXPECT_LE(MaxDifference(
					  FImage(9, 9, {0.25, 0.5, 1, 0.5}), Run.Run(MakeMask(9, 9, [=](int, int) { return Value; })), 4),
			1e-6);
	}
}

TEST(CharaGlow, OffsetRectEqualsTheCroppedMask)
{
	// Outside the rect the mask is NaN: no tap may see it.
	FGlowRun Run;
	Run.Inputs.Area = 6.5f;
	const FImage Mask = FImage::Noise(40, 24);
	const FImage Cropped = Run.Run(Mask);
	Run.Padding = FIntPoint(11, 7);
	EXPECT_LE(MaxDifference(Cropped, Run.Run(Mask), 4), 1e-6);
}

TEST(CharaGlow, SmallestSizes)
{
	FGlowRun Run;
	Run.Inputs.Area = 5.0f;
	for (const auto& [Width, Height] : {std::pair(1, 1), {1, 4}, {3, 1}})
	{
		EXPECT_EQ(Width, Run.Run(MakeMask(Width, Height, [](int, int) { return 1.0; })).Width);
	}
}

TEST(CharaGlow, DoubleArithmeticIsExactlyTheShader)
{
	const FImage Mask = FImage::Noise(21, 13);
	EXPECT_LE(MaxError(Mask, Widen(Mask, 2.5f, false, EArithmetic::Double), 2.5), 1e-7);
}

TEST(CharaGlow, BoxOfAnArea)
{
	const Drydock::FCharaGlowBox Box = Drydock::GetCharaGlowBox(2.5f, false);
	EXPECT_EQ(2, Box.Radius);
	EXPECT_EQ(0.5f, Box.Fraction);
	EXPECT_FLOAT_EQ(1.0f / 6.0f, Box.Scale); // five texels and two halves
	EXPECT_EQ(0.0f, Drydock::GetCharaGlowBox(2.5f, true).Fraction);
	EXPECT_EQ(128, Drydock::GetCharaGlowBox(1e9f, false).Radius);
	EXPECT_EQ(0, Drydock::GetCharaGlowBox(-1.0f, false).Radius);
}

TEST(CharaGlow, DefaultSettingsGlowNot)
{
	EXPECT_EQ(0.0f, FCharaGlowInputs::FromSettings(FFinalPostProcessSettings(), {}).Area);
}
