// FVector4f and FVector4: four reals, aligned to 16 bytes. W is 1 unless given, as in the engine.
// Source: engine Math/Vector4.h.
#pragma once

#include "Math/IntRect.h"
#include "Math/Vector.h"

namespace UE::Math
{

template<typename T>
struct alignas(16) TVector4
{
	using FReal = T;
	using GlmType = glm::vec<4, T, glm::defaultp>;

	T X = 0;
	T Y = 0;
	T Z = 0;
	T W = 1;

	static constexpr TVector4 Zero() { return TVector4(0, 0, 0, 0); }
	static constexpr TVector4 One() { return TVector4(1, 1, 1, 1); }

	constexpr TVector4() = default;
	constexpr TVector4(T InX, T InY, T InZ, T InW)
		: X(InX)
		, Y(InY)
		, Z(InZ)
		, W(InW)
	{
	}
	constexpr explicit TVector4(T InX, T InY = 0, T InZ = 0)
		: TVector4(InX, InY, InZ, 1)
	{
	}
	constexpr explicit TVector4(EForceInit)
		: W(0)
	{
	}
	constexpr TVector4(const TVector<T>& Vector, T InW = 1)
		: TVector4(Vector.X, Vector.Y, Vector.Z, InW)
	{
	}
	constexpr explicit TVector4(const TVector2<T>& XY, const TVector2<T>& ZW = TVector2<T>())
		: TVector4(XY.X, XY.Y, ZW.X, ZW.Y)
	{
	}
	constexpr TVector4(const FLinearColor& Color);
	constexpr TVector4(const FLinearColor& Color, T InW);
	/** Min in XY, Max in ZW. */
	template<typename IntType>
	constexpr TVector4(const TIntRect<IntType>& Rect)
		: TVector4(static_cast<T>(Rect.Min.X), static_cast<T>(Rect.Min.Y), static_cast<T>(Rect.Max.X),
			  static_cast<T>(Rect.Max.Y))
	{
	}
	template<typename IntType>
	constexpr explicit TVector4(const TIntVector4<IntType>& Vector)
		: TVector4(
			  static_cast<T>(Vector.X), static_cast<T>(Vector.Y), static_cast<T>(Vector.Z), static_cast<T>(Vector.W))
	{
	}
	template<typename Other>
	requires(!std::is_same_v<Other, T>) constexpr explicit TVector4(const TVector4<Other>& Vector)
		: TVector4(
			  static_cast<T>(Vector.X), static_cast<T>(Vector.Y), static_cast<T>(Vector.Z), static_cast<T>(Vector.W))
	{
	}

	constexpr bool operator==(const TVector4&) const = default;
	T& operator[](int32 Index) { return Index == 0 ? X : Index == 1 ? Y : Index == 2 ? Z : W; }
	T operator[](int32 Index) const { return Index == 0 ? X : Index == 1 ? Y : Index == 2 ? Z : W; }
	T& Component(int32 Index) { return (*this)[Index]; }
	T Component(int32 Index) const { return (*this)[Index]; }
	void Set(T InX, T InY, T InZ, T InW) { *this = TVector4(InX, InY, InZ, InW); }

	constexpr T SizeSquared3() const { return X * X + Y * Y + Z * Z; }
	T Size3() const { return std::sqrt(SizeSquared3()); }
	constexpr T SizeSquared() const { return SizeSquared3() + W * W; }
	T Size() const { return std::sqrt(SizeSquared()); }
	bool Equals(const TVector4& Other, T Tolerance = UE_KINDA_SMALL_NUMBER) const
	{
		return std::fabs(X - Other.X) <= Tolerance && std::fabs(Y - Other.Y) <= Tolerance &&
			   std::fabs(Z - Other.Z) <= Tolerance && std::fabs(W - Other.W) <= Tolerance;
	}
	bool ContainsNaN() const
	{
		return !FMath::IsFinite(X) || !FMath::IsFinite(Y) || !FMath::IsFinite(Z) || !FMath::IsFinite(W);
	}
	FString ToString() const
	{
		return FString::Printf("X=%3.3f Y=%3.3f Z=%3.3f W=%3.3f", static_cast<double>(X), static_cast<double>(Y),
			static_cast<double>(Z), static_cast<double>(W));
	}
};

template<typename T>
constexpr T Dot3(const TVector4<T>& A, const TVector4<T>& B)
{
	return A.X * B.X + A.Y * B.Y + A.Z * B.Z;
}
template<typename T>
constexpr T Dot4(const TVector4<T>& A, const TVector4<T>& B)
{
	return Dot3(A, B) + A.W * B.W;
}

template<typename T>
constexpr TVector<T>::TVector(const TVector4<T>& Vector)
	: X(Vector.X)
	, Y(Vector.Y)
	, Z(Vector.Z)
{
}
template<typename T>
constexpr TVector2<T>::TVector2(const TVector4<T>& Vector)
	: X(Vector.X)
	, Y(Vector.Y)
{
}

template<typename T>
uint32 GetTypeHash(const TVector4<T>& Vector)
{
	return HashCombine(HashCombine(::GetTypeHash(Vector.X), ::GetTypeHash(Vector.Y)),
		HashCombine(::GetTypeHash(Vector.Z), ::GetTypeHash(Vector.W)));
}

} // namespace UE::Math
