// FPlane: the points P with X * P.X + Y * P.Y + Z * P.Z = W; (X, Y, Z) is the normal. Source: engine Math/Plane.h.
#pragma once

#include "Math/Vector4.h"

namespace UE::Math
{

template<typename T>
struct alignas(16) TPlane : TVector<T>
{
	using TVector<T>::X;
	using TVector<T>::Y;
	using TVector<T>::Z;

	T W = 0;

	constexpr TPlane() = default;
	constexpr TPlane(const TVector4<T>& Vector)
		: TPlane(Vector.X, Vector.Y, Vector.Z, Vector.W)
	{
	}
	constexpr TPlane(T InX, T InY, T InZ, T InW)
		: TVector<T>(InX, InY, InZ)
		, W(InW)
	{
	}
	constexpr TPlane(const TVector<T>& Normal, T InW)
		: TVector<T>(Normal)
		, W(InW)
	{
	}
	/** Through a point. */
	constexpr TPlane(const TVector<T>& Base, const TVector<T>& Normal)
		: TPlane(Normal, Base | Normal)
	{
	}
	/** Through three points; the normal is (B - A) x (C - A). */
	TPlane(const TVector<T>& A, const TVector<T>& B, const TVector<T>& C)
		: TPlane(A, ((B - A) ^ (C - A)).GetSafeNormal())
	{
	}

	constexpr bool operator==(const TPlane&) const = default;
	/** Distance along the normal, times its length: above 0 on the normal's side. */
	constexpr T PlaneDot(const TVector<T>& Point) const { return (*this | Point) - W; }
	constexpr TVector<T> GetNormal() const { return *this; }
	/** The point nearest to the origin, if the normal has length 1. */
	constexpr TVector<T> GetOrigin() const { return GetNormal() * W; }
	constexpr TPlane Flip() const { return TPlane(-X, -Y, -Z, -W); }
	/** Makes the normal's length 1; false, and unchanged, if it is too short. */
	bool Normalize(T Tolerance = UE_SMALL_NUMBER)
	{
		const T Squared = TVector<T>::SizeSquared();
		if (!(Squared > Tolerance))
		{
			return false;
		}
		*this = *this * (T(1) / std::sqrt(Squared));
		return true;
	}
	constexpr TPlane operator*(T Scale) const { return TPlane(X * Scale, Y * Scale, Z * Scale, W * Scale); }
	bool Equals(const TPlane& Other, T Tolerance = UE_KINDA_SMALL_NUMBER) const
	{
		return TVector<T>::Equals(Other, Tolerance) && std::fabs(W - Other.W) <= Tolerance;
	}
};

} // namespace UE::Math
