// Separate translucency over the picture: the formula in double, what must not change, rects, hazards.
#include "PassTestUtils.h"

#include "Screen/SeparateTranslucencyComposition.h"

using namespace Drydock;

using namespace PassTest;
using PassReference::FRect;
using PassReference::MaxDifference;

namespace
{

FImage Compose(const FImage& Color, const FImage& Translucency, EArithmetic Arithmetic = EArithmetic::Double)
{
	FPassRun Run(Color, Arithmetic, PF_A32B32G32R32F);
	const FScreenPassTexture Input = Run.AddInput(Translucency, PF_A32B32G32R32F, TEXT("Translucency"));
	return Run.Execute(AddSeparateTranslucencyCompositionPass(Run.GraphBuilder, Run.View, Run.Input, Input));
}

} // namespace

TEST(SeparateTranslucency, IsPremultipliedRadianceAndTransmittance)
{
	const FImage Color = FImage::Noise(31, 17, 8.0), Translucency = FImage::Noise(31, 17, 1.0, 2);
	const FImage Expected = FImage::Make(31, 17,
		[&](int X, int Y)
		{
			const FTexel Behind = Color.At(X, Y), Over = Translucency.At(X, Y);
			return FTexel{
				Behind[0] * Over[3] + Over[0], Behind[1] * Over[3] + Over[1], Behind[2] * Over[3] + Over[2], Behind[3]};
		});
	EXPECT_LE(MaxDifference(Expected, Compose(Color, Translucency), 4), 1e-9);
}

TEST(SeparateTranslucency, NothingThereLeavesThePictureBitForBit)
{
	const FImage Color = FImage::Noise(13, 9, 60000.0);
	EXPECT_EQ(Color.Texels, Compose(Color, FImage(13, 9, {0, 0, 0, 1}), EArithmetic::Float32).Texels);
}

TEST(SeparateTranslucency, WhatIsNotFiniteStaysAtItsPixel)
{
	FImage Color(8, 8, {0.5, 0.5, 0.5, 1}), Translucency(8, 8, {0.25, 0.25, 0.25, 0.5});
	Color.At(2, 2) = {NaN, Infinity, -Infinity, 1};
	Translucency.At(5, 5) = {NaN, Infinity, 0.25, 0.5};
	const FImage Result = Compose(Color, Translucency, EArithmetic::Float32);
	for (int Y = 0; Y < 8; ++Y)
	{
		for (int X = 0; X < 8; ++X)
		{
			if ((X != 2 || Y != 2) && (X != 5 || Y != 5))
			{
				EXPECT_EQ((FTexel{0.5, 0.5, 0.5, 1}), Result.At(X, Y)) << X << ", " << Y;
			}
		}
	}
	EXPECT_TRUE(std::isnan(Result.At(2, 2)[0]));
	EXPECT_EQ(Infinity, Result.At(2, 2)[1]);
	EXPECT_TRUE(std::isnan(Result.At(5, 5)[0]));
	EXPECT_EQ(Infinity, Result.At(5, 5)[1]);
}

TEST(SeparateTranslucency, RectsMayLieAnywhere)
{
	const FImage Color = FImage::Noise(16, 8, 2.0), Translucency = FImage::Noise(16, 8, 1.0, 2);
	const FImage Cropped = Compose(Color, Translucency, EArithmetic::Float32);
	FPassRun Run(Color, {8, 4, 24, 12}, FIntPoint(64, 32), EArithmetic::Float32, PF_A32B32G32R32F);
	const FScreenPassTexture Input =
		Run.AddInput(Translucency, {3, 5, 19, 13}, FIntPoint(40, 20), PF_A32B32G32R32F, TEXT("Translucency"));
	const FScreenPassTexture Output =
		AddSeparateTranslucencyCompositionPass(Run.GraphBuilder, Run.View, Run.Input, Input);
	EXPECT_EQ(FIntRect(8, 4, 24, 12), Output.ViewRect);
	EXPECT_EQ(Cropped.Texels, Run.Execute(Output).Texels);
}

TEST(SeparateTranslucency, SmallerOnesAreStretched)
{
	const FImage Result = Compose(FImage(9, 7, {1, 1, 1, 1}), FImage(1, 1, {0.25, 0.5, 0.75, 0.5}));
	EXPECT_LE(MaxDifference(FImage(9, 7, {0.75, 1, 1.25, 1}), Result, 4), 1e-9);
}
