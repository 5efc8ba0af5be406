// FRotator: pitch, yaw and roll in degrees; yaw turns about Z first, then pitch lifts the nose, then roll about
// forward. Left-handed, X forward, Y right, Z up. Source: engine Math/Rotator.h.
#pragma once

#include "Math/Vector.h"

namespace UE::Math
{

template<typename T>
struct TRotator
{
	using FReal = T;

	T Pitch = 0;
	T Yaw = 0;
	T Roll = 0;

	static const TRotator ZeroRotator;

	constexpr TRotator() = default;
	constexpr TRotator(T InPitch, T InYaw, T InRoll)
		: Pitch(InPitch)
		, Yaw(InYaw)
		, Roll(InRoll)
	{
	}
	constexpr explicit TRotator(EForceInit) {}
	template<typename Other>
	requires(!std::is_same_v<Other, T>) constexpr explicit TRotator(const TRotator<Other>& Rotator)
		: Pitch(static_cast<T>(Rotator.Pitch))
		, Yaw(static_cast<T>(Rotator.Yaw))
		, Roll(static_cast<T>(Rotator.Roll))
	{
	}

	constexpr bool operator==(const TRotator&) const = default;
	constexpr TRotator operator*(T Scale) const { return {Pitch * Scale, Yaw * Scale, Roll * Scale}; }
	friend constexpr TRotator operator*(T Scale, const TRotator& Rotator) { return Rotator * Scale; }
	bool Equals(const TRotator& Other, T Tolerance = UE_KINDA_SMALL_NUMBER) const
	{
		return std::fabs(Pitch - Other.Pitch) <= Tolerance && std::fabs(Yaw - Other.Yaw) <= Tolerance &&
			   std::fabs(Roll - Other.Roll) <= Tolerance;
	}

	/** The direction it looks to, of length 1. */
	TVector<T> Vector() const { return GetForward(); }
	TVector<T> GetForward() const
	{
		const FSinCos P(Pitch), Y(Yaw);
		return {P.Cos * Y.Cos, P.Cos * Y.Sin, P.Sin};
	}
	TVector<T> GetRight() const
	{
		const FSinCos P(Pitch), Y(Yaw), R(Roll);
		return {R.Sin * P.Sin * Y.Cos - R.Cos * Y.Sin, R.Sin * P.Sin * Y.Sin + R.Cos * Y.Cos, -R.Sin * P.Cos};
	}
	TVector<T> GetUp() const
	{
		const FSinCos P(Pitch), Y(Yaw), R(Roll);
		return {-(R.Cos * P.Sin * Y.Cos + R.Sin * Y.Sin), Y.Cos * R.Sin - R.Cos * P.Sin * Y.Sin, R.Cos * P.Cos};
	}
	TVector<T> RotateVector(const TVector<T>& V) const { return GetForward() * V.X + GetRight() * V.Y + GetUp() * V.Z; }
	TQuat<T> Quaternion() const;
	bool IsZero() const { return Pitch == 0 && Yaw == 0 && Roll == 0; }
	bool IsNearlyZero(T Tolerance = UE_KINDA_SMALL_NUMBER) const { return Equals(ZeroRotator, Tolerance); }
	FString ToString() const
	{
		return FString::Printf(
			"P=%f Y=%f R=%f", static_cast<double>(Pitch), static_cast<double>(Yaw), static_cast<double>(Roll));
	}

private:
	struct FSinCos
	{
		T Sin;
		T Cos;

		explicit FSinCos(T Degrees)
			: Sin(std::sin(FMath::DegreesToRadians(Degrees)))
			, Cos(std::cos(FMath::DegreesToRadians(Degrees)))
		{
		}
	};
};

template<typename T>
inline const TRotator<T> TRotator<T>::ZeroRotator(0, 0, 0);

template<typename T>
TRotator<T> TVector<T>::Rotation() const
{
	return TRotator<T>(FMath::RadiansToDegrees(std::atan2(Z, Size2D())), FMath::RadiansToDegrees(std::atan2(Y, X)), 0);
}

} // namespace UE::Math
