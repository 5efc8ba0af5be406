// Calls of Core: numbers, vectors, matrices, colours.
#include "Calls.h"

#include "CoreMinimal.h"
#include "Math/BoxSphereBounds.h"
#include "Math/Float16Color.h"
#include "Math/Halton.h"
#include "Math/Plane.h"
#include "Math/RandomStream.h"
#include "Math/Transform.h"
#include "Math/Vector2DHalf.h"

namespace
{

constexpr Calls::EArea Area = Calls::EArea::Core;

} // namespace

TEST(CallsOfCore, Numbers)
{
	CALL("FMath::Max", FMath::Max(2, 3.5f) == 3.5f);
	CALL("FMath::Min", FMath::Min(2u, 3u) == 2u);
	CALL("FMath::Max3", FMath::Max3(1, 5, 2) == 5);
	CALL("FMath::Min3", FMath::Min3(1.0f, 5.0f, 2.0f) == 1.0f);
	CALL("FMath::Clamp", FMath::Clamp(7, 0, 4) == 4);
	CALL("FMath::Abs", FMath::Abs(-2.5) == 2.5);
	CALL("FMath::Sign", FMath::Sign(-2.5f) == -1.0f);
	CALL("FMath::Lerp", FMath::Lerp(1.0f, 3.0f, 0.25f) == 1.5f);
	CALL("FMath::SmoothStep", FMath::SmoothStep(0.0f, 1.0f, 0.25f) == 0.15625f);
	CALL("FMath::Square", FMath::Square(3) == 9);
	CALL("FMath::Cube", FMath::Cube(2.0f) == 8.0f);
	CALL("FMath::Sqrt", FMath::Sqrt(9.0f) == 3.0f);
	CALL("FMath::InvSqrt", FMath::IsNearlyEqual(FMath::InvSqrt(4.0f), 0.5f, 1e-6f));
	CALL("FMath::Pow", FMath::Pow(2.0f, 3.0f) == 8.0f);
	CALL("FMath::Exp", FMath::Exp(0.0f) == 1.0f);
	CALL("FMath::Exp2", FMath::Exp2(3.0f) == 8.0f);
	CALL("FMath::Loge", FMath::Loge(1.0f) == 0.0f);
	CALL("FMath::LogX", FMath::IsNearlyEqual(FMath::LogX(10.0f, 1000.0f), 3.0f, 1e-6f));
	CALL("FMath::Log2", FMath::Log2(8.0f) == 3.0f);
	CALL("FMath::Sin", FMath::Sin(0.0f) == 0.0f);
	CALL("FMath::Cos", FMath::Cos(0.0f) == 1.0f);
	CALL("FMath::Tan", FMath::IsNearlyEqual(FMath::Tan(UE_PI / 4), 1.0f, 1e-6f));
	CALL("FMath::Asin", FMath::IsNearlyEqual(FMath::Asin(1.0f), UE_HALF_PI, 1e-6f));
	CALL("FMath::Acos", FMath::Acos(1.0f) == 0.0f);
	CALL("FMath::Atan", FMath::IsNearlyEqual(FMath::Atan(1.0f), UE_PI / 4, 1e-6f));
	CALL("FMath::Atan2", FMath::IsNearlyEqual(FMath::Atan2(1.0f, -1.0f), UE_PI * 0.75f, 1e-6f));
	float Sine = 0.0f, Cosine = 0.0f;
	FMath::SinCos(&Sine, &Cosine, 0.0f);
	CALL("FMath::SinCos", Sine == 0.0f && Cosine == 1.0f);
	CALL("FMath::DegreesToRadians", FMath::IsNearlyEqual(FMath::DegreesToRadians(180.0f), UE_PI, 1e-6f));
	CALL("FMath::RadiansToDegrees", FMath::IsNearlyEqual(FMath::RadiansToDegrees(UE_PI), 180.0f, 1e-4f));
	CALL("FMath::FloorToInt", FMath::FloorToInt(-1.5f) == -2);
	CALL("FMath::FloorToInt32", FMath::FloorToInt32(-1.5) == -2);
	CALL("FMath::CeilToInt", FMath::CeilToInt(1.25f) == 2);
	CALL("FMath::CeilToInt32", FMath::CeilToInt32(1.25) == 2);
	CALL("FMath::RoundToInt", FMath::RoundToInt(2.5f) == 3);
	CALL("FMath::RoundToInt32", FMath::RoundToInt32(-2.5) == -2);
	CALL("FMath::TruncToInt", FMath::TruncToInt(-1.75f) == -1);
	CALL("FMath::FloorToFloat", FMath::FloorToFloat(1.75f) == 1.0f);
	CALL("FMath::CeilToFloat", FMath::CeilToFloat(1.25f) == 2.0f);
	CALL("FMath::Frac", FMath::Frac(-0.25f) == 0.75f);
	CALL("FMath::Fractional", FMath::Fractional(-1.25f) == -0.25f);
	CALL("FMath::Fmod", FMath::Fmod(5.5f, 2.0f) == 1.5f);
	CALL("FMath::GridSnap", FMath::GridSnap(7.0f, 4.0f) == 8.0f);
	CALL("FMath::DivideAndRoundUp", FMath::DivideAndRoundUp(7, 4) == 2);
	CALL("FMath::DivideAndRoundDown", FMath::DivideAndRoundDown(7, 4) == 1);
	CALL("FMath::DivideAndRoundNearest", FMath::DivideAndRoundNearest(7, 4) == 2);
	CALL("FMath::IsPowerOfTwo", FMath::IsPowerOfTwo(64) && !FMath::IsPowerOfTwo(65));
	CALL("FMath::RoundUpToPowerOfTwo", FMath::RoundUpToPowerOfTwo(65) == 128);
	CALL("FMath::FloorLog2", FMath::FloorLog2(65) == 6);
	CALL("FMath::CeilLogTwo", FMath::CeilLogTwo(65) == 7);
	CALL("FMath::CountBits", FMath::CountBits(255) == 8);
	CALL("FMath::CountLeadingZeros", FMath::CountLeadingZeros(1u) == 31);
	CALL("FMath::CountTrailingZeros", FMath::CountTrailingZeros(8u) == 3);
	CALL("FMath::IsNearlyEqual", FMath::IsNearlyEqual(1.0f, 1.0f + 1e-9f));
	CALL("FMath::IsNearlyZero", FMath::IsNearlyZero(1e-9f));
	CALL("FMath::IsNaN", FMath::IsNaN(std::nanf("")));
	CALL("FMath::IsFinite", FMath::IsFinite(1.0f));
	CALL("FMath::IsWithin", FMath::IsWithin(1, 0, 2) && !FMath::IsWithin(2, 0, 2));
	CALL("FMath::IsWithinInclusive", FMath::IsWithinInclusive(2, 0, 2));
	CALL("FMath::GetMappedRangeValueClamped",
		FMath::GetMappedRangeValueClamped(FVector2f(0, 10), FVector2f(0, 1), 20.0f) == 1.0f);
	CALL("FMath::GetMappedRangeValueUnclamped",
		FMath::GetMappedRangeValueUnclamped(FVector2f(0, 10), FVector2f(0, 1), 20.0f) == 2.0f);
	CALL("FMath::GetRangePct", FMath::GetRangePct(0.0f, 4.0f, 1.0f) == 0.25f);
	CALL("FMath::FInterpTo", FMath::FInterpTo(0.0, 1.0, 1.0, 0.0) == 1.0);
	CALL("FMath::FRandRange", FMath::FRandRange(2.0f, 2.0f) == 2.0f);
	CALL("FMath::RandRange", FMath::RandRange(3, 3) == 3);
	CALL("FMath::FRand", FMath::FRand() < 1.0f);
	CALL("FMath::VRand", FMath::IsNearlyEqual(FMath::VRand().Size(), 1.0, 1e-6));
	CALL("FMath::RandInit", (FMath::RandInit(3), true));
	CALL("Halton", Halton(5, 2) == 0.625f && FMath::IsNearlyEqual(Halton(5, 3), 7.0f / 9.0f, 1e-6f));
	CALL("Align", Align(5, 4) == 8);
	CALL("AlignDown", AlignDown(5, 4) == 4);
	CALL("IsAligned", IsAligned(8, 4));
	CALL("TNumericLimits", TNumericLimits<uint8>::Max() == 255 && TNumericLimits<float>::Lowest() < 0.0f);
	CALL("MAX_int32, MIN_int32, MAX_uint32, MAX_flt",
		MAX_int32 > 0 && MIN_int32 < 0 && MAX_uint32 > 1u && MAX_flt > 1.0f);
	CALL("INDEX_NONE", INDEX_NONE == -1);
	CALL("UE_PI, UE_KINDA_SMALL_NUMBER, UE_SMALL_NUMBER, PI", UE_PI == PI && UE_KINDA_SMALL_NUMBER > UE_SMALL_NUMBER);
	CALL("FRandomStream", FRandomStream(3).GetFraction() == FRandomStream(3).GetFraction());
	CALL("FRandomStream::RandRange, FRandRange",
		FRandomStream(3).RandRange(4, 4) == 4 && FRandomStream(3).FRandRange(1.0f, 1.0f) == 1.0f);
	CALL("FRandomStream::VRand", FMath::IsNearlyEqual(FRandomStream(3).VRand().Size(), 1.0, 1e-6));
	CALL("FFloat16", FFloat16(0.5f).GetFloat() == 0.5f && FFloat16(0.5f).Encoded == 0x3800);
	CALL("FFloat16Color", FFloat16Color(FLinearColor(1, 2, 3, 4)).B.GetFloat() == 3.0f);
	CALL("FVector2DHalf", FVector2D(FVector2DHalf(FVector2D(1.0, 2.0))).Y == 2.0);
}

TEST(CallsOfCore, Vectors)
{
	const FIntPoint Point(7, 5);
	CALL("FIntPoint, FIntPoint::X, Y", Point.X == 7 && FIntPoint(3) == FIntPoint(3, 3));
	CALL("FIntPoint::ZeroValue, NoneValue", FIntPoint::ZeroValue == FIntPoint(0, 0) && FIntPoint::NoneValue.X == -1);
	CALL("FIntPoint::DivideAndRoundUp", FIntPoint::DivideAndRoundUp(Point, 2) == FIntPoint(4, 3));
	CALL("FIntPoint::DivideAndRoundDown", FIntPoint::DivideAndRoundDown(Point, 2) == FIntPoint(3, 2));
	CALL("FIntPoint::ComponentMin, ComponentMax", Point.ComponentMin(FIntPoint(6, 6)) == FIntPoint(6, 5) &&
													  Point.ComponentMax(FIntPoint(6, 6)) == FIntPoint(7, 6));
	CALL("FIntPoint::GetMax, GetMin", Point.GetMax() == 7 && Point.GetMin() == 5);
	CALL("FIntPoint::Size, SizeSquared", FIntPoint(3, 4).Size() == 5 && FIntPoint(3, 4).SizeSquared() == 25);
	CALL("FIntPoint operators",
		Point + Point == Point * 2 && Point / 2 == FIntPoint(3, 2) && Point - 1 == FIntPoint(6, 4));
	CALL("FIntPoint::ToString", Point.ToString() == TEXT("X=7 Y=5"));
	const FIntRect Rect(1, 2, 5, 8);
	CALL("FIntRect, FIntRect::Min, Max", Rect.Min == FIntPoint(1, 2) && Rect.Max == FIntPoint(5, 8));
	CALL("FIntRect::Width, Height", Rect.Width() == 4 && Rect.Height() == 6);
	CALL("FIntRect::Size", Rect.Size() == FIntPoint(4, 6));
	CALL("FIntRect::Area", Rect.Area() == 24);
	CALL("FIntRect::IsEmpty", FIntRect().IsEmpty() && !Rect.IsEmpty());
	CALL("FIntRect::Scale", Rect.Scale(0.5f).Width() >= 2);
	CALL("FIntRect::Contains", Rect.Contains(FIntPoint(1, 2)) && !Rect.Contains(FIntPoint(5, 8)));
	CALL(
		"FIntRect::Intersect, Union", Rect.Intersect(FIntRect(2, 0, 3, 9)) &&
										  [&]
										  {
											  FIntRect R = Rect;
											  R.Union(FIntRect(0, 0, 1, 1));
											  return R.Min == FIntPoint(0, 0);
										  }());
	CALL("FIntRect::Clip",
		[&]
		{
			FIntRect R = Rect;
			R.Clip(FIntRect(2, 2, 4, 4));
			return R == FIntRect(2, 2, 4, 4);
		}());
	CALL("FIntRect::InflateRect",
		[&]
		{
			FIntRect R = Rect;
			R.InflateRect(1);
			return R.Width() == 6;
		}());
	CALL("FIntRect::DivideAndRoundUp", FIntRect::DivideAndRoundUp(FIntRect(0, 0, 5, 5), 2) == FIntRect(0, 0, 3, 3));
	CALL("FIntRect operators",
		Rect + FIntPoint(1, 1) == FIntRect(2, 3, 6, 9) && Rect == Rect && Rect * 2 == FIntRect(2, 4, 10, 16));
	CALL("FIntVector", FIntVector(1, 2, 3).Z == 3 && FIntVector(4) == FIntVector(4, 4, 4));
	CALL("FIntVector::DivideAndRoundUp", FIntVector::DivideAndRoundUp(FIntVector(5, 6, 7), 4) == FIntVector(2, 2, 2));
	CALL("FIntVector4, FUintVector2, FUintVector4",
		FIntVector4(1, 2, 3, 4).W == 4 && FUintVector2(1, 2).Y == 2u && FUintVector4(1, 2, 3, 4).W == 4u);
	const FVector2f Vector2(3, 4);
	CALL("FVector2f", Vector2.X == 3.0f && FVector2f(FIntPoint(1, 2)).Y == 2.0f);
	CALL("FVector2f::Size, Length", Vector2.Size() == 5.0f && Vector2.Length() == 5.0f);
	CALL("FVector2f operators",
		Vector2 / Vector2 == FVector2f(1, 1) && Vector2 * 2.0f == FVector2f(6, 8) && -Vector2 == FVector2f(-3, -4));
	CALL("FVector2f::ZeroVector, UnitVector", FVector2f::ZeroVector.X == 0.0f && FVector2f::UnitVector.Y == 1.0f);
	CALL("FVector2D", FVector2D(Vector2).Y == 4.0 && FVector2D(1.0, 2.0).IntPoint() == FIntPoint(1, 2));
	CALL("FVector2D::GetMax, GetMin, GetAbs", FVector2D(-1, 2).GetMax() == 2.0 && FVector2D(-1, 2).GetAbs().X == 1.0);
	CALL("FVector2D::DotProduct", FVector2D::DotProduct(FVector2D(1, 2), FVector2D(3, 4)) == 11.0);
	CALL("FVector2D::GetSafeNormal", FVector2D(3, 4).GetSafeNormal().Equals(FVector2D(0.6, 0.8), 1e-6));
	const FVector Vector(1, 2, 2);
	CALL("FVector", Vector.Z == 2.0 && FVector(FVector3f(1, 2, 3)).Y == 2.0 && FVector(3.0).X == 3.0);
	CALL("FVector::Size, Length, SizeSquared",
		Vector.Size() == 3.0 && Vector.Length() == 3.0 && Vector.SizeSquared() == 9.0);
	CALL("FVector::Size2D", FVector(3, 4, 9).Size2D() == 5.0);
	CALL("FVector::DotProduct, operator|", FVector::DotProduct(Vector, Vector) == 9.0 && (Vector | Vector) == 9.0);
	CALL("FVector::CrossProduct, operator^",
		FVector::CrossProduct(FVector(1, 0, 0), FVector(0, 1, 0)) == FVector(0, 0, 1) &&
			(FVector(1, 0, 0) ^ FVector(0, 1, 0)).Z == 1.0);
	CALL("FVector::GetSafeNormal", Vector.GetSafeNormal().Equals(Vector / 3.0, 1e-9));
	CALL("FVector::Normalize",
		[&]
		{
			FVector V = Vector;
			return V.Normalize() && FMath::IsNearlyEqual(V.Size(), 1.0, 1e-9);
		}());
	CALL("FVector::GetAbs, GetMax, GetMin",
		FVector(-1, 2, 3).GetAbs().X == 1.0 && Vector.GetMax() == 2.0 && Vector.GetMin() == 1.0);
	CALL("FVector::Distance, DistSquared",
		FVector::Distance(Vector, FVector(1, 2, 5)) == 3.0 && FVector::DistSquared(Vector, FVector(1, 2, 5)) == 9.0);
	CALL("FVector::IsNearlyZero, IsZero", FVector(0, 0, 0).IsZero() && FVector(1e-9, 0, 0).IsNearlyZero());
	CALL("FVector::Equals", Vector.Equals(FVector(1, 2, 2.00001), 1e-3));
	CALL("FVector::ZeroVector, OneVector, UpVector, ForwardVector, RightVector",
		FVector::UpVector == FVector(0, 0, 1) && FVector::ForwardVector == FVector(1, 0, 0) &&
			FVector::RightVector == FVector(0, 1, 0) && FVector::OneVector - FVector::ZeroVector == FVector(1, 1, 1));
	CALL("FVector::ToString", FVector(1, 2, 3).ToString().Contains(TEXT("X=1")));
	CALL("FVector::Rotation", FVector(0, 1, 0).Rotation().Equals(FRotator(0, 90, 0), 1e-6));
	CALL("FVector::ContainsNaN", !Vector.ContainsNaN());
	CALL("FVector3f", FVector3f(Vector).Z == 2.0f && FVector3f::ZeroVector.X == 0.0f);
	CALL("FVector4", FVector4(Vector, 1.0).W == 1.0 && FVector4(1, 2, 3, 4).Z == 3.0);
	CALL("FVector4f", FVector4f(1, 2, 3, 4).W == 4.0f && FVector4f(FLinearColor(1, 2, 3, 4)).Y == 2.0f &&
						  FVector4f(FVector3f(1, 2, 3), 4.0f).X == 1.0f);
	CALL("FVector::Dist2D, DistXY, DistSquared2D",
		FVector::Dist2D(FVector(0, 0, 9), FVector(3, 4, 0)) == 5.0 &&
			FVector::DistSquared2D(FVector(0, 0, 9), FVector(3, 4, 0)) == 25.0);
	CALL("FVector2D::Normalize",
		[]
		{
			FVector2D Long(3, 4);
			FVector2D None(0, 0);
			return Long.Normalize() && Long.Equals(FVector2D(0.6, 0.8), 1e-12) && !None.Normalize() && None.X == 0.0;
		}());
	CALL("FMath::FRandRange (of whole numbers)", FMath::FRandRange(2, 3) >= 2.0 && FMath::FRandRange(2, 3) <= 3.0);
	const FRotator Rotator(10, 20, 30);
	CALL("FRotator * number", Rotator * 0.5f == FRotator(5, 10, 15) && 0.5 * Rotator == FRotator(5, 10, 15));
	CALL("FRotator", Rotator.Pitch == 10.0 && Rotator.Yaw == 20.0 && Rotator.Roll == 30.0);
	CALL("FRotator::Vector", FRotator(0, 90, 0).Vector().Equals(FVector(0, 1, 0), 1e-9));
	CALL("FRotator::Quaternion",
		FRotator(0, 90, 0).Quaternion().RotateVector(FVector(1, 0, 0)).Equals(FVector(0, 1, 0), 1e-9));
	CALL("FRotator::RotateVector", FRotator(90, 0, 0).RotateVector(FVector(1, 0, 0)).Equals(FVector(0, 0, 1), 1e-9));
	CALL("FRotator::ZeroRotator, IsNearlyZero", FRotator::ZeroRotator.IsNearlyZero());
	CALL("FQuat", FQuat::Identity.RotateVector(Vector) == Vector);
	CALL("FQuat(Axis, Angle)",
		FQuat(FVector(0, 0, 1), UE_DOUBLE_PI / 2).RotateVector(FVector(1, 0, 0)).Equals(FVector(0, 1, 0), 1e-9));
	CALL("FQuat::Rotator, Inverse",
		FQuat(FRotator(0, 90, 0)).Inverse().RotateVector(FVector(0, 1, 0)).Equals(FVector(1, 0, 0), 1e-9) &&
			FQuat(FRotator(0, 90, 0)).Rotator().Equals(FRotator(0, 90, 0), 1e-6));
	CALL("FQuat operator*", (FQuat(FRotator(0, 90, 0)) * FQuat(FRotator(0, 90, 0)))
								.RotateVector(FVector(1, 0, 0))
								.Equals(FVector(-1, 0, 0), 1e-9));
	const FMatrix Move = FTranslationMatrix(FVector(1, 2, 3));
	CALL("FMatrix, FMatrix::M", Move.M[3][1] == 2.0 && FMatrix::Identity.M[0][0] == 1.0);
	CALL("FMatrix::TransformPosition", FVector(Move.TransformPosition(Vector)) == FVector(2, 4, 5));
	CALL("FMatrix::TransformVector", FVector(Move.TransformVector(Vector)) == Vector);
	CALL("FMatrix::TransformFVector4", Move.TransformFVector4(FVector4(0, 0, 0, 1)).Z == 3.0);
	CALL("FMatrix::Inverse", FVector(Move.Inverse().TransformPosition(FVector(1, 2, 3))).IsNearlyZero());
	CALL("FMatrix::GetTransposed", Move.GetTransposed().M[1][3] == 2.0);
	CALL("FMatrix operator*", FVector((Move * Move).TransformPosition(FVector(0, 0, 0))) == FVector(2, 4, 6));
	CALL("FMatrix::GetOrigin", Move.GetOrigin() == FVector(1, 2, 3));
	CALL("FMatrix::GetColumn", Move.GetColumn(0) == FVector(1, 0, 0));
	CALL("FMatrix::Determinant", FMath::IsNearlyEqual(FScaleMatrix(FVector(1, 2, 3)).Determinant(), 6.0, 1e-9));
	CALL("FMatrix44f", FMatrix44f(Move).M[3][2] == 3.0f);
	CALL("FRotationMatrix",
		FVector(FRotationMatrix(FRotator(0, 90, 0)).TransformVector(FVector(1, 0, 0))).Equals(FVector(0, 1, 0), 1e-9));
	CALL("FInverseRotationMatrix", FVector(FInverseRotationMatrix(FRotator(0, 90, 0)).TransformVector(FVector(0, 1, 0)))
									   .Equals(FVector(1, 0, 0), 1e-9));
	CALL("FReversedZPerspectiveMatrix", FReversedZPerspectiveMatrix(UE_PI / 4, 2.0f, 1.0f, 10.0f).M[2][3] == 1.0);
	const FTransform Transform(FRotator(0, 90, 0), FVector(1, 2, 3), FVector(2, 2, 2));
	CALL("FTransform", Transform.GetLocation() == FVector(1, 2, 3) && Transform.GetScale3D() == FVector(2, 2, 2));
	CALL("FTransform::TransformPosition", Transform.TransformPosition(FVector(1, 0, 0)).Equals(FVector(1, 4, 3), 1e-9));
	CALL("FTransform::GetRotation, Rotator", Transform.Rotator().Equals(FRotator(0, 90, 0), 1e-6) &&
												 Transform.GetRotation().Equals(FQuat(FRotator(0, 90, 0)), 1e-9));
	CALL("FTransform::Inverse", Transform.Inverse().TransformPosition(FVector(1, 4, 3)).Equals(FVector(1, 0, 0), 1e-9));
	CALL("FTransform::ToMatrixWithScale",
		FVector(Transform.ToMatrixWithScale().TransformPosition(FVector(1, 0, 0))).Equals(FVector(1, 4, 3), 1e-9));
	CALL("FTransform::Identity", FTransform::Identity.TransformPosition(Vector) == Vector);
	CALL("FPlane", FPlane(FVector(0, 0, 2), FVector(0, 0, 1)).PlaneDot(FVector(0, 0, 5)) == 3.0);
	CALL("FBox", FBox(FVector(0, 0, 0), FVector(2, 4, 6)).GetCenter() == FVector(1, 2, 3));
	CALL("FBox::GetExtent, GetSize, IsInside",
		FBox(FVector(0, 0, 0), FVector(2, 4, 6)).GetExtent() == FVector(1, 2, 3) &&
			FBox(FVector(0, 0, 0), FVector(2, 4, 6)).IsInside(FVector(1, 1, 1)));
	CALL("FBoxSphereBounds", FBoxSphereBounds(FBox(FVector(0, 0, 0), FVector(2, 4, 4))).SphereRadius == 3.0);
}

TEST(CallsOfCore, Colours)
{
	CALL("FLinearColor, R, G, B, A", FLinearColor(0.1f, 0.2f, 0.3f).A == 1.0f);
	CALL("FLinearColor::Black, White, Transparent, Red, Green, Blue, Yellow, Gray",
		FLinearColor::Black.A == 1.0f && FLinearColor::Transparent.A == 0.0f && FLinearColor::Red.R == 1.0f &&
			FLinearColor::Green.G == 1.0f && FLinearColor::Blue.B == 1.0f && FLinearColor::Yellow.G == 1.0f &&
			FLinearColor::Gray.R == 0.5f && FLinearColor::White.B == 1.0f);
	CALL("FLinearColor operators", FLinearColor(1, 2, 3, 4) * 2.0f == FLinearColor(2, 4, 6, 8) &&
									   FLinearColor(1, 2, 3, 4) + FLinearColor(1, 1, 1, 1) == FLinearColor(2, 3, 4, 5));
	CALL("FLinearColor::ToFColor", FLinearColor(1, 0, 0).ToFColor(true) == FColor(255, 0, 0));
	CALL("FLinearColor(FColor)", FLinearColor(FColor(255, 0, 0)) == FLinearColor(1, 0, 0));
	CALL("FLinearColor::LinearRGBToHSV, HSVToLinearRGB",
		FLinearColor(0, 1, 0).LinearRGBToHSV().R == 120.0f && FLinearColor(120, 1, 1).HSVToLinearRGB().G == 1.0f);
	CALL("FLinearColor::GetLuminance", FMath::IsNearlyEqual(FLinearColor::White.GetLuminance(), 1.0f, 1e-6f));
	CALL("FLinearColor::Desaturate",
		FLinearColor(1, 0, 0).Desaturate(1.0f).Equals(FLinearColor(0.3f, 0.3f, 0.3f), 1e-6f));
	CALL("FLinearColor::GetClamped", FLinearColor(2, -1, 0).GetClamped() == FLinearColor(1, 0, 0));
	CALL("FLinearColor::CopyWithNewOpacity", FLinearColor(1, 2, 3).CopyWithNewOpacity(0.5f).A == 0.5f);
	CALL("FLinearColor::FromSRGBColor", FLinearColor::FromSRGBColor(FColor(188, 0, 0)).R > 0.5f);
	CALL("FColor, R, G, B, A", FColor(1, 2, 3, 4).B == 3);
	CALL("FColor::Black, White, Red, Green, Blue, Yellow, Cyan, Magenta, Orange, Purple",
		FColor::Cyan == FColor(0, 255, 255) && FColor::Magenta == FColor(255, 0, 255) && FColor::White.R == 255 &&
			FColor::Black.R == 0 && FColor::Red.R == 255 && FColor::Green.G == 255 && FColor::Blue.B == 255 &&
			FColor::Yellow.B == 0 && FColor::Orange.R > FColor::Orange.B && FColor::Purple.B > FColor::Purple.G);
	CALL("FColor::ReinterpretAsLinear", FColor(51, 0, 0).ReinterpretAsLinear().R == 0.2f);
	CALL("FColor::ToPackedARGB, DWColor",
		FColor(1, 2, 3, 4).ToPackedARGB() == 0x04010203u && FColor(1, 2, 3, 4).DWColor() == 0x04010203u);
}
