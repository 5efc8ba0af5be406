// Transforms, planes, bounds, random numbers and half floats agree with values from their definitions.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "CoreMinimal.h"

namespace
{

FTransform MakeTransform(std::mt19937& Random, bool bMirror = false)
{
	std::uniform_real_distribution<double> Number(-1.0, 1.0);
	const auto Next = [&]
	{
		return Number(Random);
	};
	const double Scale = 1.5 + Next();
	return FTransform(FRotator(80.0 * Next(), 180.0 * Next(), 180.0 * Next()), FVector(Next(), Next(), Next()) * 100.0,
		FVector(bMirror ? -Scale : Scale, Scale, Scale));
}

} // namespace

TEST(Transform, ComposesAsMatricesDo)
{
	std::mt19937 Random(3);
	for (int Run = 0; Run < 40; ++Run)
	{
		SCOPED_TRACE("seed 3, run " + std::to_string(Run));
		const FTransform A = MakeTransform(Random, Run % 4 == 1);
		const FTransform B = MakeTransform(Random, Run % 4 == 2);
		const FVector Point(3.0, -2.0, 5.0);
		// First A, then B.
		const FVector Expected = B.TransformPosition(A.TransformPosition(Point));
		EXPECT_TRUE(Expected.Equals((A * B).TransformPosition(Point), 1e-8)) << *Expected.ToString();
		EXPECT_TRUE((A * B).ToMatrixWithScale().Equals(A.ToMatrixWithScale() * B.ToMatrixWithScale(), 1e-8));
		EXPECT_TRUE(FVector(A.ToMatrixWithScale().TransformPosition(Point)).Equals(A.TransformPosition(Point), 1e-9));
		EXPECT_TRUE(Point.Equals(A.InverseTransformPosition(A.TransformPosition(Point)), 1e-9));
		EXPECT_TRUE(Point.Equals(A.InverseTransformVector(A.TransformVector(Point)), 1e-9));
		EXPECT_TRUE(FTransform(A.ToMatrixWithScale()).ToMatrixWithScale().Equals(A.ToMatrixWithScale(), 1e-8));
		if (Run % 4 == 0)
		{
			EXPECT_TRUE(FTransform::Identity.Equals(A * A.Inverse(), 1e-9));
			EXPECT_TRUE((A * B.Inverse()).Equals(A.GetRelativeTransform(B), 1e-8));
		}
	}
}

TEST(Transform, RotatorsComeBack)
{
	for (const FRotator& Rotator :
		{FRotator(10.0, 20.0, 30.0), FRotator(-80.0, 170.0, -100.0), FRotator(90.0, 35.0, 0.0)})
	{
		EXPECT_TRUE(Rotator.Equals(Rotator.Quaternion().Rotator(), 1e-5)) << *Rotator.ToString();
		EXPECT_TRUE(Rotator.Equals(FTransform(FRotationMatrix(Rotator)).Rotator(), 1e-5)) << *Rotator.ToString();
	}
	EXPECT_TRUE(FTransform::GetSafeScaleReciprocal(FVector(2.0, 0.0, -4.0)).Equals(FVector(0.5, 0.0, -0.25), 0.0));
}

TEST(Plane, SidesAndPoints)
{
	const FPlane Plane(FVector(0, 0, 4), FVector(5, 0, 4), FVector(0, 5, 4));
	EXPECT_EQ(FPlane(0, 0, 1, 4), Plane);
	EXPECT_EQ(6.0, Plane.PlaneDot(FVector(7, 8, 10)));
	EXPECT_EQ(-6.0, Plane.Flip().PlaneDot(FVector(7, 8, 10)));
	EXPECT_EQ(FVector(0, 0, 4), Plane.GetOrigin());
	FPlane Long(0, 3, 4, 10);
	EXPECT_TRUE(Long.Normalize());
	EXPECT_TRUE(Long.Equals(FPlane(0, 0.6, 0.8, 2)));
}

TEST(BoxSphereBounds, UnitesAndTransforms)
{
	const FBoxSphereBounds A(FBox(FVector(0, 0, 0), FVector(2, 2, 2)));
	const FBoxSphereBounds B(FBox(FVector(4, 0, 0), FVector(6, 2, 2)));
	EXPECT_NEAR(std::sqrt(3.0), A.SphereRadius, 1e-12);
	const FBoxSphereBounds Both = A + B;
	EXPECT_EQ(FVector(3, 1, 1), Both.Origin);
	EXPECT_EQ(FVector(3, 1, 1), Both.BoxExtent);
	EXPECT_NEAR(std::sqrt(11.0), Both.SphereRadius, 1e-12);
	const FBoxSphereBounds Turned = A.TransformBy(FTransform(FRotator(0, 90, 0), FVector(10, 0, 0), FVector(2, 2, 2)));
	EXPECT_TRUE(Turned.Origin.Equals(FVector(8, 2, 2), 1e-9)) << *Turned.Origin.ToString();
	EXPECT_TRUE(Turned.BoxExtent.Equals(FVector(2, 2, 2), 1e-9));
	EXPECT_NEAR(2.0 * std::sqrt(3.0), Turned.SphereRadius, 1e-9);
	EXPECT_FALSE(FBoxSphereBounds::SpheresIntersect(A, B));
	EXPECT_EQ(4.0, A.ComputeSquaredDistanceFromBoxToPoint(FVector(4, 1, 1)));
}

TEST(RandomStream, IsTheSequenceOfItsConstants)
{
	const FRandomStream Stream(1234);
	uint64 Seed = 1234;
	for (int Index = 0; Index < 100; ++Index)
	{
		Seed = (Seed * 196314165u + 907633515u) % 4294967296u;
		const double Expected = static_cast<double>(Seed / 512) / 8388608.0;
		EXPECT_EQ(static_cast<float>(Expected), Stream.GetFraction());
		EXPECT_EQ(static_cast<int32>(static_cast<uint32>(Seed)), Stream.GetCurrentSeed());
	}
	Stream.Reset();
	EXPECT_EQ(1234, Stream.GetCurrentSeed());
	const FRandomStream Same(1234);
	const float Fraction = Same.GetFraction();
	EXPECT_EQ(10 + static_cast<int32>(Fraction * 5.0f), Stream.RandRange(10, 14));
	EXPECT_EQ(0, Stream.RandHelper(0));
	for (int Index = 0; Index < 500; ++Index)
	{
		const int32 Whole = Stream.RandRange(-3, 3);
		EXPECT_TRUE(Whole >= -3 && Whole <= 3);
		const float Real = Stream.FRandRange(2.0f, 4.0f);
		EXPECT_TRUE(Real >= 2.0f && Real < 4.0f);
		EXPECT_NEAR(1.0, Stream.VRand().Size(), 1e-12);
	}
}

TEST(RandomStream, MathFunctionsRepeatAfterTheirSeed)
{
	FMath::RandInit(5);
	const int32 First = FMath::RandRange(0, 1000000);
	const float Second = FMath::FRand();
	FMath::RandInit(5);
	EXPECT_EQ(First, FMath::RandRange(0, 1000000));
	EXPECT_EQ(Second, FMath::FRand());
	FMath::SRandInit(9);
	EXPECT_EQ(FRandomStream(9).GetFraction(), FMath::SRand());
	EXPECT_TRUE(FMath::Rand() >= 0);
	EXPECT_NEAR(1.0, FMath::VRand().Size(), 1e-12);
}

TEST(Float16, AllCodesComeBackAndRoundingIsToTheNearest)
{
	for (uint32 Code = 0; Code < 65536; ++Code)
	{
		FFloat16 Half;
		Half.Encoded = static_cast<uint16>(Code);
		const float Value = Half.GetFloat();
		const uint32 Exponent = Code >> 10 & 31;
		const double Mantissa = Code & 1023;
		if (Exponent == 31)
		{
			EXPECT_EQ(Mantissa == 0.0, std::isinf(Value));
			EXPECT_EQ(Mantissa != 0.0, std::isnan(Value));
			continue;
		}
		const double Magnitude =
			Exponent == 0 ? std::ldexp(Mantissa, -24) : std::ldexp(1024.0 + Mantissa, static_cast<int>(Exponent) - 25);
		ASSERT_EQ(static_cast<float>(Code & 32768 ? -Magnitude : Magnitude), Value);
		ASSERT_EQ(Code, FFloat16(Value).Encoded);
		if (Exponent < 30 && Code < 32768)
		{
			// Halfway to the next code: to the even one.
			FFloat16 Next;
			Next.Encoded = static_cast<uint16>(Code + 1);
			const float Middle = 0.5f * (Value + Next.GetFloat());
			ASSERT_EQ(Code % 2 == 0 ? Code : Code + 1, FFloat16(Middle).Encoded);
			ASSERT_EQ(Code, FFloat16(std::nextafter(Middle, 0.0f)).Encoded);
			ASSERT_EQ(Code + 1, FFloat16(std::nextafter(Middle, 1e9f)).Encoded);
		}
	}
	EXPECT_EQ(0x7bff, FFloat16(65519.0f).Encoded);
	EXPECT_EQ(0x7c00, FFloat16(65520.0f).Encoded);
	EXPECT_EQ(0xfc00, FFloat16(-std::numeric_limits<float>::infinity()).Encoded);
	EXPECT_TRUE(std::isnan(FFloat16(std::numeric_limits<float>::quiet_NaN()).GetFloat()));
	EXPECT_EQ(8u, sizeof(FFloat16Color));
	EXPECT_EQ(FLinearColor(0.5f, 2.0f, -1.0f, 0.0f), FFloat16Color(FLinearColor(0.5f, 2.0f, -1.0f, 0.0f)).GetFloats());
	EXPECT_EQ(FVector2D(0.25, -3.0), FVector2D(FVector2DHalf(0.25f, -3.0f)));
}

TEST(Color, NamesHaveTheirBytes)
{
	EXPECT_EQ(FColor(0, 255, 255), FColor::Cyan);
	EXPECT_EQ(FColor(255, 0, 255), FColor::Magenta);
	EXPECT_EQ(FColor(243, 156, 18), FColor::Orange);
	EXPECT_EQ(FColor(169, 7, 228), FColor::Purple);
	EXPECT_EQ(FColor(26, 188, 156), FColor::Turquoise);
	EXPECT_EQ(FColor(189, 195, 199), FColor::Silver);
	EXPECT_EQ(FColor(46, 204, 113), FColor::Emerald);
	EXPECT_EQ(FColor(255, 255, 0), FColor::Yellow);
}
