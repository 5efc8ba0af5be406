// Viewports, their shader parameters and screen transforms, against the formulas of the engine's header.
#include <gtest/gtest.h>

#include "ScreenPass.h"

namespace
{

using EBasis = FScreenTransform::ETextureBasis;

void ExpectVector(double X, double Y, const FVector2f& Vector, double Tolerance = 1e-6)
{
	EXPECT_NEAR(X, Vector.X, Tolerance);
	EXPECT_NEAR(Y, Vector.Y, Tolerance);
}

const FIntPoint GExtent(64, 32);
const FIntRect GRect(10, 4, 50, 24);

} // namespace

TEST(ScreenPassViewport, OfARectEndsAtItsMax)
{
	EXPECT_EQ(FIntPoint(50, 24), FScreenPassTextureViewport(GRect).Extent);
}

TEST(ScreenPassViewport, IsFullscreenOnlyWhenTheRectIsAllOfTheExtent)
{
	EXPECT_TRUE(FScreenPassTextureViewport(GExtent).IsFullscreen());
	EXPECT_FALSE(FScreenPassTextureViewport(GExtent, FIntRect(0, 0, 63, 32)).IsFullscreen());
	EXPECT_FALSE(FScreenPassTextureViewport(GExtent, FIntRect(1, 0, 64, 32)).IsFullscreen());
}

TEST(ScreenPassViewport, DownscaleRoundsExtentAndMaxUpAndMinTowardsZero)
{
	const FScreenPassTextureViewport Half = GetDownscaledViewport(
		FScreenPassTextureViewport(FIntPoint(1919, 1079), FIntRect(3, 5, 1919, 1079)), FIntPoint(2, 2));
	EXPECT_EQ(FIntPoint(960, 540), Half.Extent);
	EXPECT_EQ(FIntRect(1, 2, 960, 540), Half.Rect);
}

TEST(ScreenPassViewport, DownscaleNeverGoesBelowOneTexel)
{
	EXPECT_EQ(
		FIntPoint(1, 1), GetDownscaledViewport(FScreenPassTextureViewport(FIntPoint(1, 1)), FIntPoint(2, 2)).Extent);
}

TEST(ScreenPassViewportParameters, OfAnEmptyViewportAreZero)
{
	const FScreenPassTextureViewportParameters Parameters =
		GetScreenPassTextureViewportParameters(FScreenPassTextureViewport());
	ExpectVector(0, 0, Parameters.ExtentInverse);
	ExpectVector(0, 0, Parameters.UVViewportSizeInverse);
}

TEST(ScreenPassViewportParameters, FollowTheFormulas)
{
	const FScreenPassTextureViewportParameters Parameters =
		GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(GExtent, GRect));
	ExpectVector(64, 32, Parameters.Extent);
	ExpectVector(1.0 / 64, 1.0 / 32, Parameters.ExtentInverse);
	ExpectVector(20, -10, Parameters.ScreenPosToViewportScale);
	ExpectVector(30, 14, Parameters.ScreenPosToViewportBias);
	EXPECT_EQ(GRect.Min, Parameters.ViewportMin);
	EXPECT_EQ(GRect.Max, Parameters.ViewportMax);
	ExpectVector(40, 20, Parameters.ViewportSize);
	ExpectVector(1.0 / 40, 1.0 / 20, Parameters.ViewportSizeInverse);
	ExpectVector(10.0 / 64, 4.0 / 32, Parameters.UVViewportMin);
	ExpectVector(50.0 / 64, 24.0 / 32, Parameters.UVViewportMax);
	ExpectVector(40.0 / 64, 20.0 / 32, Parameters.UVViewportSize);
	ExpectVector(64.0 / 40, 32.0 / 20, Parameters.UVViewportSizeInverse);
	ExpectVector(10.5 / 64, 4.5 / 32, Parameters.UVViewportBilinearMin);
	ExpectVector(49.5 / 64, 23.5 / 32, Parameters.UVViewportBilinearMax);
}

TEST(ScreenPassViewportParameters, AreNamedInHlslAsTheViewportMacroDeclaresThem)
{
	const FShaderParametersMetadata::FMember* Member =
		FScreenPassTextureViewportParameters::FTypeInfo::GetStructMetadata()->FindMemberByName(
			TEXT("UVViewportBilinearMax"));
	ASSERT_NE(nullptr, Member);
	EXPECT_EQ(UBMT_FLOAT32, Member->GetBaseType());
	EXPECT_EQ(2u, Member->GetNumColumns());
}

TEST(ScreenTransform, IsFourFloatsToAShader)
{
	static_assert(sizeof(FScreenTransform) == 16 && alignof(FScreenTransform) == 16);
	EXPECT_EQ(4, TShaderParameterTypeInfo<FScreenTransform>::NumColumns);
}

TEST(ScreenTransform, ProductAppliesTheLeftOneFirst)
{
	const FScreenTransform Double(FVector2f(2, 2), FVector2f(0, 0));
	const FScreenTransform Shift(FVector2f(1, 1), FVector2f(3, 5));
	ExpectVector(5, 9, FVector2f(1, 2) * (Double * Shift));
	ExpectVector(8, 14, FVector2f(1, 2) * (Shift * Double));
}

TEST(ScreenTransform, QuotientAppliesTheInverse)
{
	const FScreenTransform A(FVector2f(2, 3), FVector2f(5, 7));
	ExpectVector(11, 13, FVector2f(11, 13) * (A / A), 1e-5);
	ExpectVector(3, 2, FVector2f(11, 13) * FScreenTransform::Invert(A), 1e-5);
}

TEST(ScreenTransform, MapsTheCornersOfTheScreenToTheRect)
{
	const FScreenTransform ToTexel =
		FScreenTransform::ChangeTextureBasisFromTo(GExtent, GRect, EBasis::ScreenPosition, EBasis::TexelPosition);
	ExpectVector(10, 4, FVector2f(-1, 1) * ToTexel);
	ExpectVector(50, 24, FVector2f(1, -1) * ToTexel);
}

TEST(ScreenTransform, MapsViewportUVToTextureUV)
{
	const FScreenTransform ToTexture = FScreenTransform::ChangeTextureBasisFromTo(
		FScreenPassTextureViewport(GExtent, GRect), EBasis::ViewportUV, EBasis::TextureUV);
	ExpectVector(30.0 / 64, 14.0 / 32, FVector2f(0.5f, 0.5f) * ToTexture);
}

TEST(ScreenTransform, GoesBackTheWayItCame)
{
	for (const EBasis From : {EBasis::ScreenPosition, EBasis::ViewportUV, EBasis::TexelPosition, EBasis::TextureUV})
	{
		for (const EBasis To : {EBasis::ScreenPosition, EBasis::ViewportUV, EBasis::TexelPosition, EBasis::TextureUV})
		{
			const FScreenTransform There = FScreenTransform::ChangeTextureBasisFromTo(GExtent, GRect, From, To);
			const FScreenTransform Back = FScreenTransform::ChangeTextureBasisFromTo(GExtent, GRect, To, From);
			ExpectVector(0.3, 0.7, FVector2f(0.3f, 0.7f) * There * Back, 1e-4);
		}
	}
}

TEST(ScreenTransform, SvPositionOfTheFirstPixelIsHalfAPixelIntoTheViewport)
{
	ExpectVector(0.5 / 40, 0.5 / 20, FVector2f(10.5f, 4.5f) * FScreenTransform::SvPositionToViewportUV(GRect));
}

TEST(ScreenTransform, DispatchThreadIdCountsFromTheViewportAndTakesPixelCentres)
{
	ExpectVector(0.5 / 40, 0.5 / 20, FVector2f(0, 0) * FScreenTransform::DispatchThreadIdToViewportUV(GRect));
	ExpectVector(39.5 / 40, 19.5 / 20, FVector2f(39, 19) * FScreenTransform::DispatchThreadIdToViewportUV(GRect));
}

TEST(ScreenTransform, ChangesRects)
{
	const FScreenTransform Change = FScreenTransform::ChangeRectFromTo(GRect, FIntRect(0, 0, 20, 10));
	ExpectVector(0, 0, FVector2f(10, 4) * Change);
	ExpectVector(20, 10, FVector2f(50, 24) * Change);
}

TEST(ComputeShaderUtils, GroupCountsCoverTheThreads)
{
	EXPECT_EQ(FIntVector(121, 68, 1),
		FComputeShaderUtils::GetGroupCount(FIntPoint(961, 540), FComputeShaderUtils::kGolden2DGroupSize));
	EXPECT_EQ(FIntVector(1, 1, 1), FComputeShaderUtils::GetGroupCount(1, 64));
	EXPECT_EQ(FIntVector(2, 3, 4), FComputeShaderUtils::GetGroupCount(FIntVector(9, 17, 25), FIntVector(8, 8, 8)));
	EXPECT_EQ(FIntVector(4, 2, 1), FComputeShaderUtils::GetGroupCount(FIntPoint(64, 32), FIntPoint(16, 16)));
}

TEST(ComputeShaderUtils, WrapsWhatOneAxisCannotHold)
{
	EXPECT_EQ(FIntVector(65535, 1, 1), FComputeShaderUtils::GetGroupCountWrapped(65535));
	EXPECT_EQ(FIntVector(128, 512, 1), FComputeShaderUtils::GetGroupCountWrapped(65536));
}
