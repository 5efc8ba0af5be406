// FBox: an axis-aligned box, empty until a point is added. Source: engine Math/Box.h.
#pragma once

#include "Math/Vector.h"

namespace UE::Math
{

template<typename T>
struct TBox
{
	using FReal = T;

	TVector<T> Min;
	TVector<T> Max;
	uint8 IsValid = 0;

	constexpr TBox() = default;
	constexpr explicit TBox(EForceInit) {}
	constexpr TBox(const TVector<T>& InMin, const TVector<T>& InMax)
		: Min(InMin)
		, Max(InMax)
		, IsValid(1)
	{
	}

	constexpr bool operator==(const TBox&) const = default;
	constexpr TBox& operator+=(const TVector<T>& Point)
	{
		Min = IsValid ? Min.ComponentMin(Point) : Point;
		Max = IsValid ? Max.ComponentMax(Point) : Point;
		IsValid = 1;
		return *this;
	}
	constexpr TBox& operator+=(const TBox& Other)
	{
		if (Other.IsValid)
		{
			*this += Other.Min;
			*this += Other.Max;
		}
		return *this;
	}
	constexpr TVector<T> GetCenter() const { return (Min + Max) * T(0.5); }
	/** Half of the size. */
	constexpr TVector<T> GetExtent() const { return (Max - Min) * T(0.5); }
	constexpr TVector<T> GetSize() const { return Max - Min; }
	/** Strictly inside. */
	constexpr bool IsInside(const TVector<T>& Point) const
	{
		return Point.X > Min.X && Point.X < Max.X && Point.Y > Min.Y && Point.Y < Max.Y && Point.Z > Min.Z &&
			   Point.Z < Max.Z;
	}
	constexpr bool IsInsideOrOn(const TVector<T>& Point) const
	{
		return Point.X >= Min.X && Point.X <= Max.X && Point.Y >= Min.Y && Point.Y <= Max.Y && Point.Z >= Min.Z &&
			   Point.Z <= Max.Z;
	}
	constexpr TVector<T> GetClosestPointTo(const TVector<T>& Point) const
	{
		return Point.ComponentMax(Min).ComponentMin(Max);
	}
	/** 0 inside. */
	constexpr T ComputeSquaredDistanceToPoint(const TVector<T>& Point) const
	{
		return (Point - GetClosestPointTo(Point)).SizeSquared();
	}
	constexpr TBox ExpandBy(T Amount) const { return {Min - TVector<T>(Amount), Max + TVector<T>(Amount)}; }
};

} // namespace UE::Math
