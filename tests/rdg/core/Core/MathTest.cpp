// Vectors, rectangles, matrices, colours and FMath agree with values from their definitions.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "CoreMinimal.h"
#include "MathUtil.h"

namespace
{

constexpr double Tolerance = 1e-12;

void ExpectNear(const FVector& Expected, const FVector& Actual)
{
	EXPECT_TRUE(Expected.Equals(Actual, Tolerance)) << *Expected.ToString() << " against " << *Actual.ToString();
}

} // namespace

TEST(Layout, IsWhatConstantBuffersExpect)
{
	EXPECT_EQ(8u, sizeof(FVector2f));
	EXPECT_EQ(12u, sizeof(FVector3f));
	EXPECT_EQ(16u, alignof(FVector4f));
	EXPECT_EQ(64u, sizeof(FMatrix44f));
	EXPECT_EQ(16u, alignof(FMatrix44f));
	EXPECT_EQ(16u, sizeof(FLinearColor));
	EXPECT_EQ(16u, sizeof(FIntRect));
	EXPECT_EQ(4u, sizeof(FColor));
}

TEST(IntPoint, RoundsUpAndDown)
{
	EXPECT_EQ(FIntPoint(321, 180), FIntPoint::DivideAndRoundUp(FIntPoint(641, 359), 2));
	EXPECT_EQ(FIntPoint(320, 179), FIntPoint::DivideAndRoundDown(FIntPoint(641, 359), 2));
	EXPECT_EQ(FIntPoint(321, 359), FIntPoint::DivideAndRoundUp(FIntPoint(641, 359), FIntPoint(2, 1)));
}

TEST(IntPoint, RoundingUpIsTheSmallestMultipleThatCovers)
{
	const bool bOk = (rc::check)(
		[]
		{
			const int32 Value = *rc::gen::inRange(0, 100000);
			const int32 Divisor = *rc::gen::inRange(1, 1000);
			const int32 Count = FMath::DivideAndRoundUp(Value, Divisor);
			RC_ASSERT(Count * Divisor >= Value);
			RC_ASSERT((Count - 1) * Divisor < Value);
		});
	EXPECT_TRUE(bOk);
}

TEST(IntPoint, ComputesByComponent)
{
	EXPECT_EQ(FIntPoint(4, 6), FIntPoint(1, 2) + FIntPoint(3, 4));
	EXPECT_EQ(FIntPoint(-2, -2), FIntPoint(1, 2) - FIntPoint(3, 4));
	EXPECT_EQ(FIntPoint(3, 6), FIntPoint(1, 2) * 3);
	EXPECT_EQ(FIntPoint(5, 3), FIntPoint(10, 7) / 2);
	EXPECT_EQ(FIntPoint(-1, -2), -FIntPoint(1, 2));
	EXPECT_EQ(FIntPoint(1, 7), FIntPoint(1, 9).ComponentMin(FIntPoint(3, 7)));
	EXPECT_EQ(FIntPoint(3, 9), FIntPoint(1, 9).ComponentMax(FIntPoint(3, 7)));
}

TEST(IntPoint, ChangesInPlace)
{
	FIntPoint Point(1, 2);
	Point += FIntPoint(3, 3);
	Point *= 2;
	Point /= FIntPoint(4, 5);
	EXPECT_EQ(FIntPoint(2, 2), Point);
}

TEST(IntVector, DividesForThreadGroups)
{
	EXPECT_EQ(FIntVector(2, 1, 1), FIntVector::DivideAndRoundUp(FIntVector(9, 8, 1), FIntVector(8, 8, 1)));
	EXPECT_EQ(FIntVector(5, 7, 9), FIntVector(1, 2, 3) + FIntVector(4, 5, 6));
}

TEST(IntRect, MeasuresFromMinToMax)
{
	const FIntRect Rect(10, 20, 110, 70);
	EXPECT_EQ(FIntPoint(100, 50), Rect.Size());
	EXPECT_EQ(5000, Rect.Area());
	EXPECT_FALSE(Rect.IsEmpty());
	EXPECT_TRUE(FIntRect().IsEmpty());
}

TEST(IntRect, ContainsMinAndNotMax)
{
	const FIntRect Rect(1, 2, 4, 5);
	EXPECT_TRUE(Rect.Contains(FIntPoint(1, 2)));
	EXPECT_FALSE(Rect.Contains(FIntPoint(4, 2)));
	EXPECT_FALSE(Rect.Contains(FIntPoint(1, 5)));
}

TEST(IntRect, ClipsToWhatBothHave)
{
	FIntRect Rect(0, 0, 10, 10);
	Rect.Clip(FIntRect(5, -5, 20, 8));
	EXPECT_EQ(FIntRect(5, 0, 10, 8), Rect);
}

TEST(IntRect, ClippedByAStrangerHasNoArea)
{
	FIntRect Rect(0, 0, 10, 10);
	Rect.Clip(FIntRect(20, 20, 30, 30));
	EXPECT_EQ(0, Rect.Area());
}

TEST(IntRect, UnionCoversBoth)
{
	FIntRect Rect(0, 0, 2, 2);
	Rect.Union(FIntRect(5, -1, 6, 1));
	EXPECT_EQ(FIntRect(0, -1, 6, 2), Rect);
}

TEST(IntRect, ScalesOutwards)
{
	EXPECT_EQ(FIntRect(0, 1, 4, 6), FIntRect(1, 3, 7, 11).Scale(0.5f));
	EXPECT_EQ(FIntRect(1, 2, 4, 6), FIntRect::DivideAndRoundUp(FIntRect(1, 3, 7, 11), 2));
}

TEST(IntRect, MovesAndMultiplies)
{
	EXPECT_EQ(FIntRect(2, 3, 4, 5), FIntRect(1, 1, 3, 3) + FIntPoint(1, 2));
	EXPECT_EQ(FIntRect(2, 2, 6, 6), FIntRect(1, 1, 3, 3) * 2);
}

TEST(Vector2, ConvertsFromPointsAsInTheEngine)
{
	const FVector2f Extent = FIntPoint(4, 8);
	EXPECT_EQ(FVector2f(0.25f, 0.5f), FVector2f(1, 4) / FIntPoint(4, 8));
	EXPECT_EQ(FVector2f(4, 8), Extent);
	EXPECT_EQ(FIntPoint(1, -1), FVector2f(1.9f, -1.9f).IntPoint());
}

TEST(Vector2, MixesWithScalars)
{
	EXPECT_EQ(FVector2f(2, 4), FVector2f(1, 2) * 2);
	EXPECT_EQ(FVector2f(2, 4), 2.0 * FVector2f(1, 2));
	EXPECT_EQ(FVector2f(3, 4), FVector2f(1, 2) + 2.0f);
	EXPECT_EQ(FVector2f(-1, -2), -FVector2f(1, 2));
}

TEST(Vector3, HasTheProductsOfItsDefinition)
{
	EXPECT_EQ(32.0, FVector(1, 2, 3) | FVector(4, 5, 6));
	EXPECT_EQ(FVector(-3, 6, -3), FVector(1, 2, 3) ^ FVector(4, 5, 6));
	EXPECT_EQ(7.0, FVector(2, 3, 6).Size());
	ExpectNear(FVector(0, 0.6, 0.8), FVector(0, 3, 4).GetSafeNormal());
	EXPECT_EQ(FVector(0, 0, 0), FVector(0, 0, 0).GetSafeNormal());
}

TEST(Vector4, HasWOneUnlessGiven)
{
	EXPECT_EQ(1.0f, FVector4f().W);
	EXPECT_EQ(FVector4f(1, 2, 3, 1), FVector4f(FVector3f(1, 2, 3)));
	EXPECT_EQ(FVector4f(1, 2, 3, 4), FVector4f(FIntRect(1, 2, 3, 4)));
	EXPECT_EQ(FVector4f(1, 2, 3, 4), FVector4f(FVector2f(1, 2), FVector2f(3, 4)));
	EXPECT_EQ(0.0f, FVector4f(ForceInitToZero).W);
}

TEST(LinearColor, ComputesAndConverts)
{
	EXPECT_EQ(FLinearColor(1.5f, 2.5f, 3.5f, 1.5f), FLinearColor(1, 2, 3) + FLinearColor(0.5f, 0.5f, 0.5f, 0.5f));
	EXPECT_EQ(FLinearColor(2, 4, 6, 2), FLinearColor(1, 2, 3) * 2.0f);
	EXPECT_EQ(FVector4f(1, 2, 3, 4), FVector4f(FLinearColor(1, 2, 3, 4)));
	EXPECT_EQ(FLinearColor(0, 0, 0, 0), FLinearColor::Transparent);
}

TEST(Color, SrgbRoundTripsEveryByte)
{
	for (int32 Value = 0; Value < 256; ++Value)
	{
		const FColor Color(static_cast<uint8>(Value), static_cast<uint8>(255 - Value), 7, static_cast<uint8>(Value));
		EXPECT_EQ(Color, FLinearColor(Color).ToFColor(true));
	}
}

TEST(Color, SrgbHasItsDefiningValues)
{
	// IEC 61966-2-1: 0.5 encodes to 0.735357, which is 187.5 of 255; 0.2 to 0.484529, which is 123.55.
	EXPECT_EQ(188, FLinearColor(0.5f, 0, 0).ToFColor(true).R);
	EXPECT_EQ(124, FLinearColor(0.2f, 0, 0).ToFColor(true).R);
	EXPECT_EQ(128, FLinearColor(0.5f, 0, 0).ToFColor(false).R);
}

TEST(Color, OutOfRangeIsClampedAndNanIsZero)
{
	const FColor Color = FLinearColor(2.0f, -1.0f, std::nanf(""), 1.0f).ToFColor(false);
	EXPECT_EQ(FColor(255, 0, 0, 255), Color);
}

TEST(Color, HsvRoundTrips)
{
	EXPECT_EQ(FLinearColor(120, 1, 1), FLinearColor::Green.LinearRGBToHSV());
	EXPECT_TRUE(
		FLinearColor(0.2f, 0.7f, 0.4f).Equals(FLinearColor(0.2f, 0.7f, 0.4f).LinearRGBToHSV().HSVToLinearRGB(), 1e-6f));
}

TEST(Color, ReadsItsText)
{
	FLinearColor Color;
	EXPECT_TRUE(Color.InitFromString("(R=0.5,G=1,B=-2)"));
	EXPECT_EQ(FLinearColor(0.5f, 1, -2, 1), Color);
	EXPECT_FALSE(Color.InitFromString("(R=0.5,G=1)"));
}

TEST(Matrix, LeftFactorAppliesFirst)
{
	const FMatrix ScaleThenMove = FScaleMatrix(2.0) * FTranslationMatrix(FVector(10, 0, 0));
	ExpectNear(FVector(12, 2, 2), ScaleThenMove.TransformPosition(FVector(1, 1, 1)));
	ExpectNear(FVector(2, 2, 2), ScaleThenMove.TransformVector(FVector(1, 1, 1)));
}

TEST(Matrix, ProductIsRowsTimesColumns)
{
	FMatrix A, B;
	for (int32 Index = 0; Index < 16; ++Index)
	{
		A.M[Index / 4][Index % 4] = Index + 1;
		B.M[Index / 4][Index % 4] = (Index * 7) % 5;
	}
	const FMatrix Product = A * B;
	double Expected = 0;
	for (int32 Index = 0; Index < 4; ++Index)
	{
		Expected += A.M[1][Index] * B.M[Index][2];
	}
	EXPECT_EQ(Expected, Product.M[1][2]);
}

TEST(Matrix, InverseUndoes)
{
	const FMatrix Matrix =
		FRotationMatrix(FRotator(20, 30, 40)) * FScaleMatrix(FVector(1, 2, 3)) * FTranslationMatrix(FVector(4, 5, 6));
	EXPECT_TRUE((Matrix * Matrix.Inverse()).Equals(FMatrix::Identity, Tolerance));
	EXPECT_NEAR(6.0, Matrix.Determinant(), Tolerance);
	EXPECT_EQ(FMatrix::Identity, FMatrix().Inverse());
	EXPECT_EQ(4.0, Matrix.GetTransposed().M[0][3]);
}

TEST(Matrix, ReversedProjectionHasDepthOneAtTheNearPlane)
{
	const FReversedZPerspectiveMatrix Projection(0.7, 1920, 1080, 10);
	const FVector4 Near = Projection.TransformPosition(FVector(0, 0, 10));
	const FVector4 Far = Projection.TransformPosition(FVector(0, 0, 1e12));
	EXPECT_EQ(1.0, Near.Z / Near.W);
	EXPECT_NEAR(0.0, Far.Z / Far.W, 1e-10);
	EXPECT_NEAR(1.0, Projection.TransformPosition(FVector(std::tan(0.7), 0, 1)).X, Tolerance);
}

TEST(Rotator, PointsWhereItSays)
{
	ExpectNear(FVector(0, 1, 0), FRotator(0, 90, 0).Vector());
	ExpectNear(FVector(0, 0, 1), FRotator(90, 0, 0).Vector());
	ExpectNear(FVector(1, 0, 0), FRotator(0, 0, 90).Vector());
	ExpectNear(FVector(0, 0, -1), FRotator(0, 0, 90).GetRight());
}

TEST(Rotator, QuaternionAndMatrixTurnAlike)
{
	const FRotator Rotator(20, -130, 75);
	const FVector Vector(1, -2, 3);
	ExpectNear(Rotator.RotateVector(Vector), Rotator.Quaternion().RotateVector(Vector));
	ExpectNear(Rotator.RotateVector(Vector), FRotationMatrix(Rotator).TransformVector(Vector));
	ExpectNear(Vector, FInverseRotationMatrix(Rotator).TransformVector(Rotator.RotateVector(Vector)));
}

TEST(Box, MeasuresTheDistanceOfAPoint)
{
	const FBox Box(FVector(0, 0, 0), FVector(10, 10, 10));
	EXPECT_EQ(0.0, Box.ComputeSquaredDistanceToPoint(FVector(5, 5, 10)));
	EXPECT_EQ(25.0, Box.ComputeSquaredDistanceToPoint(FVector(13, 14, 5)));
	EXPECT_TRUE(Box.IsInsideOrOn(FVector(0, 5, 10)));
	EXPECT_FALSE(Box.IsInside(FVector(0, 5, 10)));
}

TEST(Math, RoundsAsTheEngine)
{
	EXPECT_EQ(3, FMath::RoundToInt(2.5f));
	EXPECT_EQ(-2, FMath::RoundToInt(-2.5f));
	EXPECT_EQ(-3, FMath::FloorToInt(-2.1f));
	EXPECT_EQ(-2, FMath::CeilToInt(-2.9f));
	EXPECT_FLOAT_EQ(0.75f, FMath::Frac(-1.25f));
	EXPECT_FLOAT_EQ(-0.25f, FMath::Fractional(-1.25f));
}

TEST(Math, PowersOfTwo)
{
	EXPECT_EQ(1u, FMath::RoundUpToPowerOfTwo(1));
	EXPECT_EQ(1024u, FMath::RoundUpToPowerOfTwo(641));
	EXPECT_EQ(512u, FMath::RoundDownToPowerOfTwo(641));
	EXPECT_EQ(9u, FMath::FloorLog2(641));
	EXPECT_EQ(10u, FMath::CeilLogTwo(641));
	EXPECT_EQ(10u, FMath::CeilLogTwo(1024));
	EXPECT_EQ(0u, FMath::CeilLogTwo(1));
}

TEST(Math, MixesTypes)
{
	EXPECT_EQ(2.5f, FMath::Max(1, 2.5f));
	EXPECT_EQ(7, FMath::Max3(3, 7, 5));
	EXPECT_EQ(1.0f, FMath::Clamp(3.0f, 0, 1));
	EXPECT_EQ(2.5f, FMath::Lerp(2.0f, 3.0f, 0.5f));
	EXPECT_EQ(FLinearColor(0.5f, 0.5f, 0.5f), FMath::Lerp(FLinearColor::Black, FLinearColor::White, 0.5f));
}

TEST(Math, SmoothStepIsItsCubic)
{
	EXPECT_EQ(0.0f, FMath::SmoothStep(1.0f, 3.0f, 0.5f));
	EXPECT_EQ(1.0f, FMath::SmoothStep(1.0f, 3.0f, 3.0f));
	EXPECT_FLOAT_EQ(0.15625f, FMath::SmoothStep(1.0f, 3.0f, 1.5f));
}

TEST(Math, AlignsUpAndDown)
{
	EXPECT_EQ(64, Align(33, 32));
	EXPECT_EQ(32, Align(32, 32));
	EXPECT_EQ(32, AlignDown(63, 32));
	EXPECT_EQ(21, AlignArbitrary(15, 7));
	EXPECT_FALSE(IsAligned(33, 32));
}

TEST(Math, LowestIsTheMostNegative)
{
	EXPECT_LT(TNumericLimits<float>::Lowest(), -1e38f);
	EXPECT_GT(TNumericLimits<float>::Min(), 0.0f);
	EXPECT_EQ(255, TNumericLimits<uint8>::Max());
}

TEST(MathUtil, IsTheMathsOfOneType)
{
	static_assert(std::is_same_v<float, decltype(FMathf::Lerp(1, 2, 0))>);
	EXPECT_EQ(2.5f, FMathf::Lerp(2.0f, 4.0f, 0.25f));
	EXPECT_EQ(8.0f, FMathf::Pow(2, 3));
	EXPECT_NEAR(std::exp(1.0), FMathd::Exp(1), 1e-15);
	EXPECT_NEAR(1.5 * M_PI, FMathd::Atan2Positive(-1.0, 0.0), 1e-15);
	EXPECT_EQ(-1.0, FMathd::Sign(-3.0));
	EXPECT_EQ(0.0, FMathd::Sign(0.0));
	EXPECT_EQ(0.00001f, DELTA);
}
