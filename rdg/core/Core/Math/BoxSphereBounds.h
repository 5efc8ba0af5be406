// FBoxSphereBounds: a box and a sphere about one centre. Source: engine Math/BoxSphereBounds.h.
#pragma once

#include "Math/Box.h"
#include "Math/Transform.h"

namespace UE::Math
{

template<typename T>
struct TBoxSphereBounds
{
	using FReal = T;

	TVector<T> Origin;
	/** Half of the box's size. */
	TVector<T> BoxExtent;
	T SphereRadius = 0;

	constexpr TBoxSphereBounds() = default;
	constexpr explicit TBoxSphereBounds(EForceInit) {}
	constexpr TBoxSphereBounds(const TVector<T>& InOrigin, const TVector<T>& InBoxExtent, T InSphereRadius)
		: Origin(InOrigin)
		, BoxExtent(InBoxExtent)
		, SphereRadius(InSphereRadius)
	{
	}
	/** The sphere goes through the box's corners. */
	explicit TBoxSphereBounds(const TBox<T>& Box)
		: TBoxSphereBounds(Box.GetCenter(), Box.GetExtent(), Box.GetExtent().Size())
	{
	}
	constexpr bool operator==(const TBoxSphereBounds&) const = default;
	constexpr TBox<T> GetBox() const { return TBox<T>(Origin - BoxExtent, Origin + BoxExtent); }
	/** Bounds of both: the box of both boxes, and a sphere that holds both spheres but no more than the box's. */
	TBoxSphereBounds operator+(const TBoxSphereBounds& Other) const
	{
		TBox<T> Box = GetBox();
		Box += Other.GetBox();
		TBoxSphereBounds Result(Box);
		Result.SphereRadius =
			FMath::Min(Result.SphereRadius, FMath::Max(TVector<T>::Dist(Origin, Result.Origin) + SphereRadius,
												TVector<T>::Dist(Other.Origin, Result.Origin) + Other.SphereRadius));
		return Result;
	}
	constexpr TBoxSphereBounds ExpandBy(T Amount) const
	{
		return TBoxSphereBounds(Origin, BoxExtent + TVector<T>(Amount), SphereRadius + Amount);
	}
	/** Bounds of the transformed bounds. The sphere grows by the longest axis, but not beyond the box's corners. */
	TBoxSphereBounds TransformBy(const TMatrix<T>& Matrix) const
	{
		TBoxSphereBounds Result;
		T Longest = 0;
		for (int32 Axis = 0; Axis < 3; ++Axis)
		{
			const TVector<T> Row = Matrix.GetScaledAxis(Axis);
			Result.BoxExtent += Row.GetAbs() * BoxExtent[Axis];
			Longest = FMath::Max(Longest, Row.SizeSquared());
		}
		Result.Origin = TVector<T>(Matrix.TransformPosition(Origin));
		Result.SphereRadius = FMath::Min(std::sqrt(Longest) * SphereRadius, Result.BoxExtent.Size());
		return Result;
	}
	TBoxSphereBounds TransformBy(const TTransform<T>& Transform) const
	{
		return TransformBy(Transform.ToMatrixWithScale());
	}
	/** 0 inside. */
	constexpr T ComputeSquaredDistanceFromBoxToPoint(const TVector<T>& Point) const
	{
		return GetBox().ComputeSquaredDistanceToPoint(Point);
	}
	static bool SpheresIntersect(
		const TBoxSphereBounds& A, const TBoxSphereBounds& B, T Tolerance = UE_KINDA_SMALL_NUMBER)
	{
		return TVector<T>::DistSquared(A.Origin, B.Origin) <=
			   FMath::Square(FMath::Max(T(0), A.SphereRadius + B.SphereRadius + Tolerance));
	}
};

} // namespace UE::Math
