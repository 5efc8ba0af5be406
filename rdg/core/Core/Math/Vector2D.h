// FVector2f and FVector2D: two reals. Source: engine Math/Vector2D.h.
#pragma once

#include "Math/IntVector.h"

namespace UE::Math
{

template<typename T>
struct TVector2
{
	using FReal = T;
	using GlmType = glm::vec<2, T, glm::defaultp>;

	T X = 0;
	T Y = 0;

	static const TVector2 ZeroVector;
	static const TVector2 UnitVector;
	static const TVector2 One() { return UnitVector; }
	static const TVector2 Zero() { return ZeroVector; }

	constexpr TVector2() = default;
	constexpr TVector2(T InX, T InY)
		: X(InX)
		, Y(InY)
	{
	}
	constexpr explicit TVector2(T InValue)
		: X(InValue)
		, Y(InValue)
	{
	}
	constexpr explicit TVector2(EForceInit) {}
	template<typename IntType>
	constexpr TVector2(TIntPoint<IntType> Point)
		: X(static_cast<T>(Point.X))
		, Y(static_cast<T>(Point.Y))
	{
	}
	template<typename Other>
	requires(!std::is_same_v<Other, T>) constexpr explicit TVector2(const TVector2<Other>& Vector)
		: X(static_cast<T>(Vector.X))
		, Y(static_cast<T>(Vector.Y))
	{
	}
	constexpr explicit TVector2(const TVector<T>& Vector);
	constexpr explicit TVector2(const TVector4<T>& Vector);

	constexpr bool operator==(const TVector2&) const = default;
	T& operator[](int32 Index) { return Index == 0 ? X : Y; }
	T operator[](int32 Index) const { return Index == 0 ? X : Y; }
	T& Component(int32 Index) { return (*this)[Index]; }
	T Component(int32 Index) const { return (*this)[Index]; }
	void Set(T InX, T InY)
	{
		X = InX;
		Y = InY;
	}

	/** Dot product. */
	constexpr T operator|(const TVector2& Other) const { return X * Other.X + Y * Other.Y; }
	/** Cross product: z of the three-dimensional one. */
	constexpr T operator^(const TVector2& Other) const { return X * Other.Y - Y * Other.X; }
	static constexpr T DotProduct(const TVector2& A, const TVector2& B) { return A | B; }
	static constexpr T CrossProduct(const TVector2& A, const TVector2& B) { return A ^ B; }
	static T Distance(const TVector2& A, const TVector2& B) { return (B - A).Size(); }
	static constexpr T DistSquared(const TVector2& A, const TVector2& B) { return (B - A).SizeSquared(); }
	static constexpr TVector2 Min(const TVector2& A, const TVector2& B)
	{
		return {FMath::Min(A.X, B.X), FMath::Min(A.Y, B.Y)};
	}
	static constexpr TVector2 Max(const TVector2& A, const TVector2& B)
	{
		return {FMath::Max(A.X, B.X), FMath::Max(A.Y, B.Y)};
	}
	static constexpr TVector2 Clamp(const TVector2& V, const TVector2& Low, const TVector2& High)
	{
		return Max(Min(V, High), Low);
	}
	constexpr T SizeSquared() const { return *this | *this; }
	T Size() const { return std::sqrt(SizeSquared()); }
	constexpr T SquaredLength() const { return SizeSquared(); }
	T Length() const { return Size(); }
	constexpr T GetMax() const { return FMath::Max(X, Y); }
	constexpr T GetMin() const { return FMath::Min(X, Y); }
	constexpr T GetAbsMax() const { return GetAbs().GetMax(); }
	constexpr TVector2 GetAbs() const { return {FMath::Abs(X), FMath::Abs(Y)}; }
	/** The vector with length 1, or zero if the squared length is below the tolerance. */
	/** Makes it of length 1; (0, 0) where it is shorter than Tolerance's root, and false. */
	bool Normalize(T Tolerance = UE_SMALL_NUMBER)
	{
		const bool bLong = SizeSquared() > Tolerance;
		*this = GetSafeNormal(Tolerance);
		return bLong;
	}
	TVector2 GetSafeNormal(T Tolerance = UE_SMALL_NUMBER) const
	{
		const T Squared = SizeSquared();
		return Squared > Tolerance ? *this * (T(1) / std::sqrt(Squared)) : TVector2();
	}
	bool IsNearlyZero(T Tolerance = UE_KINDA_SMALL_NUMBER) const { return Equals(TVector2(), Tolerance); }
	constexpr bool IsZero() const { return X == 0 && Y == 0; }
	bool Equals(const TVector2& Other, T Tolerance = UE_KINDA_SMALL_NUMBER) const
	{
		return std::fabs(X - Other.X) <= Tolerance && std::fabs(Y - Other.Y) <= Tolerance;
	}
	bool ContainsNaN() const { return !FMath::IsFinite(X) || !FMath::IsFinite(Y); }
	/** Towards zero. */
	constexpr TIntPoint<int32> IntPoint() const { return TIntPoint<int32>(*this); }
	TVector2 RoundToVector() const { return {std::floor(X + T(0.5)), std::floor(Y + T(0.5))}; }
	FString ToString() const
	{
		return FString::Printf("X=%3.3f Y=%3.3f", static_cast<double>(X), static_cast<double>(Y));
	}
};

template<typename T>
inline const TVector2<T> TVector2<T>::ZeroVector(0, 0);
template<typename T>
inline const TVector2<T> TVector2<T>::UnitVector(1, 1);

template<typename T>
uint32 GetTypeHash(const TVector2<T>& Vector)
{
	return HashCombine(::GetTypeHash(Vector.X), ::GetTypeHash(Vector.Y));
}

} // namespace UE::Math
