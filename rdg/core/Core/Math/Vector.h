// FVector3f and FVector: three reals. Source: engine Math/Vector.h.
#pragma once

#include "Math/Vector2D.h"

namespace UE::Math
{

template<typename T>
struct TVector
{
	using FReal = T;
	using GlmType = glm::vec<3, T, glm::defaultp>;

	T X = 0;
	T Y = 0;
	T Z = 0;

	static const TVector ZeroVector;
	static const TVector OneVector;
	static const TVector ForwardVector;
	static const TVector RightVector;
	static const TVector UpVector;
	static constexpr TVector Zero() { return TVector(); }
	static constexpr TVector One() { return TVector(1, 1, 1); }

	constexpr TVector() = default;
	constexpr TVector(T InX, T InY, T InZ)
		: X(InX)
		, Y(InY)
		, Z(InZ)
	{
	}
	constexpr explicit TVector(T InValue)
		: X(InValue)
		, Y(InValue)
		, Z(InValue)
	{
	}
	constexpr explicit TVector(EForceInit) {}
	constexpr explicit TVector(const TVector2<T>& Vector, T InZ)
		: X(Vector.X)
		, Y(Vector.Y)
		, Z(InZ)
	{
	}
	constexpr TVector(const TVector4<T>& Vector);
	constexpr explicit TVector(const FLinearColor& Color);
	template<typename IntType>
	constexpr explicit TVector(const TIntVector3<IntType>& Vector)
		: X(static_cast<T>(Vector.X))
		, Y(static_cast<T>(Vector.Y))
		, Z(static_cast<T>(Vector.Z))
	{
	}
	template<typename Other>
	requires(!std::is_same_v<Other, T>) constexpr explicit TVector(const TVector<Other>& Vector)
		: X(static_cast<T>(Vector.X))
		, Y(static_cast<T>(Vector.Y))
		, Z(static_cast<T>(Vector.Z))
	{
	}

	constexpr bool operator==(const TVector&) const = default;
	T& operator[](int32 Index) { return Index == 0 ? X : Index == 1 ? Y : Z; }
	T operator[](int32 Index) const { return Index == 0 ? X : Index == 1 ? Y : Z; }
	T& Component(int32 Index) { return (*this)[Index]; }
	T Component(int32 Index) const { return (*this)[Index]; }
	void Set(T InX, T InY, T InZ)
	{
		X = InX;
		Y = InY;
		Z = InZ;
	}

	/** Dot product. */
	constexpr T operator|(const TVector& Other) const { return X * Other.X + Y * Other.Y + Z * Other.Z; }
	/** Cross product. */
	constexpr TVector operator^(const TVector& Other) const
	{
		return {Y * Other.Z - Z * Other.Y, Z * Other.X - X * Other.Z, X * Other.Y - Y * Other.X};
	}
	constexpr T Dot(const TVector& Other) const { return *this | Other; }
	constexpr TVector Cross(const TVector& Other) const { return *this ^ Other; }
	static constexpr T DotProduct(const TVector& A, const TVector& B) { return A | B; }
	static constexpr TVector CrossProduct(const TVector& A, const TVector& B) { return A ^ B; }
	static T Dist(const TVector& A, const TVector& B) { return (B - A).Size(); }
	static T Distance(const TVector& A, const TVector& B) { return Dist(A, B); }
	/** Without Z. */
	static T Dist2D(const TVector& A, const TVector& B) { return std::sqrt(DistSquared2D(A, B)); }
	static T DistXY(const TVector& A, const TVector& B) { return Dist2D(A, B); }
	static constexpr T DistSquared2D(const TVector& A, const TVector& B)
	{
		return (B.X - A.X) * (B.X - A.X) + (B.Y - A.Y) * (B.Y - A.Y);
	}
	static constexpr T DistSquaredXY(const TVector& A, const TVector& B) { return DistSquared2D(A, B); }
	static constexpr T DistSquared(const TVector& A, const TVector& B) { return (B - A).SizeSquared(); }
	static constexpr TVector Min(const TVector& A, const TVector& B) { return A.ComponentMin(B); }
	static constexpr TVector Max(const TVector& A, const TVector& B) { return A.ComponentMax(B); }
	constexpr TVector ComponentMin(const TVector& Other) const
	{
		return {FMath::Min(X, Other.X), FMath::Min(Y, Other.Y), FMath::Min(Z, Other.Z)};
	}
	constexpr TVector ComponentMax(const TVector& Other) const
	{
		return {FMath::Max(X, Other.X), FMath::Max(Y, Other.Y), FMath::Max(Z, Other.Z)};
	}
	constexpr T SizeSquared() const { return *this | *this; }
	T Size() const { return std::sqrt(SizeSquared()); }
	constexpr T SquaredLength() const { return SizeSquared(); }
	T Length() const { return Size(); }
	T SizeSquared2D() const { return X * X + Y * Y; }
	T Size2D() const { return std::sqrt(SizeSquared2D()); }
	/** Pitch and yaw that turn +x towards this vector; roll 0. */
	TRotator<T> Rotation() const;
	constexpr T GetMax() const { return FMath::Max3(X, Y, Z); }
	constexpr T GetMin() const { return FMath::Min3(X, Y, Z); }
	constexpr T GetAbsMax() const { return GetAbs().GetMax(); }
	constexpr TVector GetAbs() const { return {FMath::Abs(X), FMath::Abs(Y), FMath::Abs(Z)}; }
	/** The vector with length 1, or ResultIfZero if the squared length is below the tolerance. */
	TVector GetSafeNormal(T Tolerance = UE_SMALL_NUMBER, const TVector& ResultIfZero = TVector()) const
	{
		const T Squared = SizeSquared();
		return Squared > Tolerance ? *this * (T(1) / std::sqrt(Squared)) : ResultIfZero;
	}
	/** Makes the length 1; false, and unchanged, if the squared length is below the tolerance. */
	bool Normalize(T Tolerance = UE_SMALL_NUMBER)
	{
		const bool bLongEnough = SizeSquared() > Tolerance;
		*this = GetSafeNormal(Tolerance, *this);
		return bLongEnough;
	}
	bool IsNearlyZero(T Tolerance = UE_KINDA_SMALL_NUMBER) const { return Equals(TVector(), Tolerance); }
	constexpr bool IsZero() const { return X == 0 && Y == 0 && Z == 0; }
	bool Equals(const TVector& Other, T Tolerance = UE_KINDA_SMALL_NUMBER) const
	{
		return std::fabs(X - Other.X) <= Tolerance && std::fabs(Y - Other.Y) <= Tolerance &&
			   std::fabs(Z - Other.Z) <= Tolerance;
	}
	bool ContainsNaN() const { return !FMath::IsFinite(X) || !FMath::IsFinite(Y) || !FMath::IsFinite(Z); }
	FString ToString() const
	{
		return FString::Printf(
			"X=%3.3f Y=%3.3f Z=%3.3f", static_cast<double>(X), static_cast<double>(Y), static_cast<double>(Z));
	}
};

template<typename T>
inline const TVector<T> TVector<T>::ZeroVector(0, 0, 0);
template<typename T>
inline const TVector<T> TVector<T>::OneVector(1, 1, 1);
template<typename T>
inline const TVector<T> TVector<T>::ForwardVector(1, 0, 0);
template<typename T>
inline const TVector<T> TVector<T>::RightVector(0, 1, 0);
template<typename T>
inline const TVector<T> TVector<T>::UpVector(0, 0, 1);

template<typename T>
constexpr TVector2<T>::TVector2(const TVector<T>& Vector)
	: X(Vector.X)
	, Y(Vector.Y)
{
}

template<typename T>
uint32 GetTypeHash(const TVector<T>& Vector)
{
	return HashCombine(HashCombine(::GetTypeHash(Vector.X), ::GetTypeHash(Vector.Y)), ::GetTypeHash(Vector.Z));
}

} // namespace UE::Math
