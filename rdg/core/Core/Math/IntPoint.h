// FIntPoint: two integers. Source: engine Math/IntPoint.h.
#pragma once

#include "Containers/UnrealString.h"
#include "Math/UnrealMathUtility.h"
#include "Math/VectorOperators.h"

namespace UE::Math
{

template<typename IntType>
struct TIntPoint
{
	using FReal = IntType;
	using GlmType = glm::vec<2, IntType, glm::defaultp>;
	using IntPointType = TIntPoint;

	IntType X = 0;
	IntType Y = 0;

	static const TIntPoint ZeroValue;
	/** (-1, -1). */
	static const TIntPoint NoneValue;

	constexpr TIntPoint() = default;
	constexpr TIntPoint(IntType InX, IntType InY)
		: X(InX)
		, Y(InY)
	{
	}
	constexpr explicit TIntPoint(IntType InXY)
		: X(InXY)
		, Y(InXY)
	{
	}
	constexpr explicit TIntPoint(EForceInit) {}
	template<typename OtherType>
	requires(!std::is_same_v<OtherType, IntType>) constexpr explicit TIntPoint(TIntPoint<OtherType> Other)
		: X(static_cast<IntType>(Other.X))
		, Y(static_cast<IntType>(Other.Y))
	{
	}
	/** Rounds towards zero; values that an integer cannot hold are converted as in ToInteger.h. */
	template<typename T>
	constexpr explicit TIntPoint(const TVector2<T>& Vector)
		: X(Drydock::ToInteger<IntType>(Vector.X))
		, Y(Drydock::ToInteger<IntType>(Vector.Y))
	{
	}

	constexpr bool operator==(const TIntPoint&) const = default;
	IntType& operator[](int32 Index) { return Index == 0 ? X : Y; }
	IntType operator[](int32 Index) const { return Index == 0 ? X : Y; }
	IntType& operator()(int32 Index) { return (*this)[Index]; }
	IntType operator()(int32 Index) const { return (*this)[Index]; }

	constexpr TIntPoint ComponentMin(const TIntPoint& Other) const
	{
		return {FMath::Min(X, Other.X), FMath::Min(Y, Other.Y)};
	}
	constexpr TIntPoint ComponentMax(const TIntPoint& Other) const
	{
		return {FMath::Max(X, Other.X), FMath::Max(Y, Other.Y)};
	}
	constexpr IntType GetMax() const { return FMath::Max(X, Y); }
	constexpr IntType GetMin() const { return FMath::Min(X, Y); }
	constexpr IntType SizeSquared() const { return X * X + Y * Y; }
	/** Length, rounded down. */
	IntType Size() const
	{
		return Drydock::ToInteger<IntType>(std::sqrt(static_cast<double>(X) * X + static_cast<double>(Y) * Y));
	}
	static constexpr int32 Num() { return 2; }
	FString ToString() const { return FString("X=") + LexToString(X) + " Y=" + LexToString(Y); }

	static constexpr TIntPoint DivideAndRoundUp(TIntPoint Left, IntType Divisor)
	{
		return {FMath::DivideAndRoundUp(Left.X, Divisor), FMath::DivideAndRoundUp(Left.Y, Divisor)};
	}
	static constexpr TIntPoint DivideAndRoundUp(TIntPoint Left, TIntPoint Divisor)
	{
		return {FMath::DivideAndRoundUp(Left.X, Divisor.X), FMath::DivideAndRoundUp(Left.Y, Divisor.Y)};
	}
	static constexpr TIntPoint DivideAndRoundDown(TIntPoint Left, IntType Divisor)
	{
		return {FMath::DivideAndRoundDown(Left.X, Divisor), FMath::DivideAndRoundDown(Left.Y, Divisor)};
	}
	static constexpr TIntPoint DivideAndRoundDown(TIntPoint Left, TIntPoint Divisor)
	{
		return {FMath::DivideAndRoundDown(Left.X, Divisor.X), FMath::DivideAndRoundDown(Left.Y, Divisor.Y)};
	}
};

template<typename IntType>
inline const TIntPoint<IntType> TIntPoint<IntType>::ZeroValue(0, 0);
template<typename IntType>
inline const TIntPoint<IntType> TIntPoint<IntType>::NoneValue(static_cast<IntType>(-1), static_cast<IntType>(-1));

template<typename IntType>
uint32 GetTypeHash(const TIntPoint<IntType>& Point)
{
	return HashCombine(::GetTypeHash(Point.X), ::GetTypeHash(Point.Y));
}

} // namespace UE::Math
