// FIntVector and its siblings of two, three and four signed or unsigned integers. Source: engine Math/IntVector.h.
#pragma once

#include "Math/IntPoint.h"

namespace UE::Math
{

template<typename IntType>
struct TIntVector2
{
	using FReal = IntType;
	using GlmType = glm::vec<2, IntType, glm::defaultp>;

	IntType X = 0;
	IntType Y = 0;

	constexpr TIntVector2() = default;
	constexpr TIntVector2(IntType InX, IntType InY)
		: X(InX)
		, Y(InY)
	{
	}
	constexpr explicit TIntVector2(IntType InValue)
		: X(InValue)
		, Y(InValue)
	{
	}
	constexpr explicit TIntVector2(EForceInit) {}
	template<typename OtherType>
	constexpr explicit TIntVector2(const TIntPoint<OtherType>& Point)
		: X(static_cast<IntType>(Point.X))
		, Y(static_cast<IntType>(Point.Y))
	{
	}

	constexpr bool operator==(const TIntVector2&) const = default;
	IntType& operator[](int32 Index) { return Index == 0 ? X : Y; }
	IntType operator[](int32 Index) const { return Index == 0 ? X : Y; }
	FString ToString() const { return FString("X=") + LexToString(X) + " Y=" + LexToString(Y); }
};

template<typename IntType>
struct TIntVector3
{
	using FReal = IntType;
	using GlmType = glm::vec<3, IntType, glm::defaultp>;

	IntType X = 0;
	IntType Y = 0;
	IntType Z = 0;

	static const TIntVector3 ZeroValue;
	/** (-1, -1, -1). */
	static const TIntVector3 NoneValue;

	constexpr TIntVector3() = default;
	constexpr TIntVector3(IntType InX, IntType InY, IntType InZ)
		: X(InX)
		, Y(InY)
		, Z(InZ)
	{
	}
	constexpr explicit TIntVector3(IntType InValue)
		: X(InValue)
		, Y(InValue)
		, Z(InValue)
	{
	}
	constexpr explicit TIntVector3(EForceInit) {}
	template<typename OtherType>
	requires(!std::is_same_v<OtherType, IntType>) constexpr explicit TIntVector3(const TIntVector3<OtherType>& Other)
		: X(static_cast<IntType>(Other.X))
		, Y(static_cast<IntType>(Other.Y))
		, Z(static_cast<IntType>(Other.Z))
	{
	}

	constexpr bool operator==(const TIntVector3&) const = default;
	IntType& operator[](int32 Index) { return Index == 0 ? X : Index == 1 ? Y : Z; }
	IntType operator[](int32 Index) const { return Index == 0 ? X : Index == 1 ? Y : Z; }
	IntType& operator()(int32 Index) { return (*this)[Index]; }
	IntType operator()(int32 Index) const { return (*this)[Index]; }
	constexpr IntType GetMax() const { return FMath::Max3(X, Y, Z); }
	constexpr IntType GetMin() const { return FMath::Min3(X, Y, Z); }
	static constexpr int32 Num() { return 3; }
	FString ToString() const
	{
		return FString("X=") + LexToString(X) + " Y=" + LexToString(Y) + " Z=" + LexToString(Z);
	}

	static constexpr TIntVector3 DivideAndRoundUp(TIntVector3 Left, IntType Divisor)
	{
		return DivideAndRoundUp(Left, TIntVector3(Divisor));
	}
	static constexpr TIntVector3 DivideAndRoundUp(TIntVector3 Left, TIntVector3 Divisor)
	{
		return {FMath::DivideAndRoundUp(Left.X, Divisor.X), FMath::DivideAndRoundUp(Left.Y, Divisor.Y),
			FMath::DivideAndRoundUp(Left.Z, Divisor.Z)};
	}
};

template<typename IntType>
inline const TIntVector3<IntType> TIntVector3<IntType>::ZeroValue(0, 0, 0);
template<typename IntType>
inline const TIntVector3<IntType> TIntVector3<IntType>::NoneValue(static_cast<IntType>(-1));

template<typename IntType>
struct TIntVector4
{
	using FReal = IntType;
	using GlmType = glm::vec<4, IntType, glm::defaultp>;

	IntType X = 0;
	IntType Y = 0;
	IntType Z = 0;
	IntType W = 0;

	constexpr TIntVector4() = default;
	constexpr TIntVector4(IntType InX, IntType InY, IntType InZ, IntType InW)
		: X(InX)
		, Y(InY)
		, Z(InZ)
		, W(InW)
	{
	}
	constexpr explicit TIntVector4(IntType InValue)
		: TIntVector4(InValue, InValue, InValue, InValue)
	{
	}
	constexpr explicit TIntVector4(EForceInit) {}
	/** Min in XY, Max in ZW. */
	template<typename OtherType>
	constexpr explicit TIntVector4(const TIntRect<OtherType>& Rect)
		: X(static_cast<IntType>(Rect.Min.X))
		, Y(static_cast<IntType>(Rect.Min.Y))
		, Z(static_cast<IntType>(Rect.Max.X))
		, W(static_cast<IntType>(Rect.Max.Y))
	{
	}

	constexpr bool operator==(const TIntVector4&) const = default;
	IntType& operator[](int32 Index) { return (&X)[Index]; }
	IntType operator[](int32 Index) const { return (&X)[Index]; }
	FString ToString() const
	{
		return FString("X=") + LexToString(X) + " Y=" + LexToString(Y) + " Z=" + LexToString(Z) +
			   " W=" + LexToString(W);
	}
};

template<typename IntType>
uint32 GetTypeHash(const TIntVector2<IntType>& Vector)
{
	return HashCombine(::GetTypeHash(Vector.X), ::GetTypeHash(Vector.Y));
}
template<typename IntType>
uint32 GetTypeHash(const TIntVector3<IntType>& Vector)
{
	return HashCombine(HashCombine(::GetTypeHash(Vector.X), ::GetTypeHash(Vector.Y)), ::GetTypeHash(Vector.Z));
}
template<typename IntType>
uint32 GetTypeHash(const TIntVector4<IntType>& Vector)
{
	return HashCombine(HashCombine(::GetTypeHash(Vector.X), ::GetTypeHash(Vector.Y)),
		HashCombine(::GetTypeHash(Vector.Z), ::GetTypeHash(Vector.W)));
}

} // namespace UE::Math
