// FIntRect: a rectangle of pixels from Min (inside) to Max (outside). Source: engine Math/IntRect.h.
#pragma once

#include "Math/IntPoint.h"

namespace UE::Math
{

template<typename IntType>
struct TIntRect
{
	using IntPointType = TIntPoint<IntType>;

	IntPointType Min;
	IntPointType Max;

	constexpr TIntRect() = default;
	constexpr TIntRect(IntType X0, IntType Y0, IntType X1, IntType Y1)
		: Min(X0, Y0)
		, Max(X1, Y1)
	{
	}
	constexpr TIntRect(IntPointType InMin, IntPointType InMax)
		: Min(InMin)
		, Max(InMax)
	{
	}
	template<typename OtherType>
	requires(!std::is_same_v<OtherType, IntType>) constexpr explicit TIntRect(const TIntRect<OtherType>& Other)
		: Min(Other.Min)
		, Max(Other.Max)
	{
	}

	constexpr bool operator==(const TIntRect&) const = default;

	constexpr IntType Width() const { return Max.X - Min.X; }
	constexpr IntType Height() const { return Max.Y - Min.Y; }
	constexpr IntPointType Size() const { return {Width(), Height()}; }
	constexpr IntType Area() const { return Width() * Height(); }
	/** No pixel inside: both sides are zero. A negative size is not valid, but not empty in the engine's sense. */
	constexpr bool IsEmpty() const { return Width() == 0 && Height() == 0; }
	constexpr bool IsValid() const { return Max.X >= Min.X && Max.Y >= Min.Y; }
	constexpr bool Contains(IntPointType Point) const
	{
		return Point.X >= Min.X && Point.X < Max.X && Point.Y >= Min.Y && Point.Y < Max.Y;
	}
	/** Whether the two share at least one pixel. */
	constexpr bool Intersect(const TIntRect& Other) const
	{
		return Other.Min.X < Max.X && Other.Max.X > Min.X && Other.Min.Y < Max.Y && Other.Max.Y > Min.Y;
	}

	/** Shrinks to what is inside Other too; apart from it, to a rectangle without area. */
	constexpr void Clip(const TIntRect& Other)
	{
		Min = Min.ComponentMax(Other.Min);
		Max = Max.ComponentMin(Other.Max).ComponentMax(Min);
	}
	/** Grows to what covers both. */
	constexpr void Union(const TIntRect& Other)
	{
		Min = Min.ComponentMin(Other.Min);
		Max = Max.ComponentMax(Other.Max);
	}
	constexpr void Include(IntPointType Point)
	{
		Min = Min.ComponentMin(Point);
		Max = Max.ComponentMax(Point);
	}
	constexpr void InflateRect(IntType Amount)
	{
		Min -= IntPointType(Amount);
		Max += IntPointType(Amount);
	}
	constexpr TIntRect Inner(IntPointType Shrink) const { return {Min + Shrink, Max - Shrink}; }
	/** Min rounded down, Max rounded up. */
	constexpr TIntRect Scale(double Fraction) const
	{
		return {IntPointType(Drydock::ToInteger<IntType>(std::floor(Min.X * Fraction)),
					Drydock::ToInteger<IntType>(std::floor(Min.Y * Fraction))),
			IntPointType(Drydock::ToInteger<IntType>(std::ceil(Max.X * Fraction)),
				Drydock::ToInteger<IntType>(std::ceil(Max.Y * Fraction)))};
	}
	static constexpr TIntRect DivideAndRoundUp(TIntRect Left, IntType Divisor)
	{
		return DivideAndRoundUp(Left, IntPointType(Divisor));
	}
	/** Both corners rounded up. */
	static constexpr TIntRect DivideAndRoundUp(TIntRect Left, IntPointType Divisor)
	{
		return {IntPointType::DivideAndRoundUp(Left.Min, Divisor), IntPointType::DivideAndRoundUp(Left.Max, Divisor)};
	}
	static constexpr int32 Num() { return 2; }
	FString ToString() const { return FString("Min=(") + Min.ToString() + ") Max=(" + Max.ToString() + ")"; }

	friend constexpr TIntRect operator+(const TIntRect& A, IntPointType Offset)
	{
		return {A.Min + Offset, A.Max + Offset};
	}
	friend constexpr TIntRect operator-(const TIntRect& A, IntPointType Offset)
	{
		return {A.Min - Offset, A.Max - Offset};
	}
	friend constexpr TIntRect operator+(const TIntRect& A, const TIntRect& B) { return {A.Min + B.Min, A.Max + B.Max}; }
	friend constexpr TIntRect operator-(const TIntRect& A, const TIntRect& B) { return {A.Min - B.Min, A.Max - B.Max}; }
	friend constexpr TIntRect operator*(const TIntRect& A, IntType Scale) { return {A.Min * Scale, A.Max * Scale}; }
	friend constexpr TIntRect operator/(const TIntRect& A, IntType Divisor)
	{
		return {A.Min / Divisor, A.Max / Divisor};
	}
	friend constexpr TIntRect operator/(const TIntRect& A, IntPointType Divisor)
	{
		return {A.Min / Divisor, A.Max / Divisor};
	}
	constexpr TIntRect& operator+=(IntPointType Offset) { return *this = *this + Offset; }
	constexpr TIntRect& operator-=(IntPointType Offset) { return *this = *this - Offset; }
	constexpr TIntRect& operator*=(IntType Scale) { return *this = *this * Scale; }
	constexpr TIntRect& operator/=(IntType Divisor) { return *this = *this / Divisor; }
};

template<typename IntType>
uint32 GetTypeHash(const TIntRect<IntType>& Rect)
{
	return HashCombine(GetTypeHash(Rect.Min), GetTypeHash(Rect.Max));
}

} // namespace UE::Math
