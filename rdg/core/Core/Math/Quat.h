// FQuat: a rotation as a unit quaternion; A * B applies B first. Source: engine Math/Quat.h.
#pragma once

#include "Math/Matrix.h"
#include "Math/Rotator.h"

#include <glm/gtc/quaternion.hpp>

namespace UE::Math
{

template<typename T>
struct alignas(16) TQuat
{
	using FReal = T;

	T X = 0;
	T Y = 0;
	T Z = 0;
	T W = 1;

	static const TQuat Identity;

	/** The identity. */
	constexpr TQuat() = default;
	constexpr TQuat(T InX, T InY, T InZ, T InW)
		: X(InX)
		, Y(InY)
		, Z(InZ)
		, W(InW)
	{
	}
	/** About a unit axis, by radians. */
	TQuat(const TVector<T>& Axis, T Angle)
		: TQuat(FromGlm(glm::angleAxis(Angle, UE::Math::ToGlm(Axis))))
	{
	}
	explicit TQuat(const TRotator<T>& Rotator)
		: TQuat(Rotator.Quaternion())
	{
	}

	/** The rotation of a matrix whose axes have length 1. */
	explicit TQuat(const TMatrix<T>& Matrix);

	constexpr bool operator==(const TQuat&) const = default;
	TRotator<T> Rotator() const { return FromAxes(GetForwardVector(), GetRightVector(), GetUpVector()); }
	TQuat operator*(const TQuat& Other) const { return FromGlm(ToGlm() * Other.ToGlm()); }
	TVector<T> RotateVector(const TVector<T>& Vector) const
	{
		return UE::Math::FromGlm<TVector<T>>(ToGlm() * UE::Math::ToGlm(Vector));
	}
	TVector<T> UnrotateVector(const TVector<T>& Vector) const { return Inverse().RotateVector(Vector); }
	TQuat Inverse() const { return {-X, -Y, -Z, W}; }
	TQuat GetNormalized() const { return FromGlm(glm::normalize(ToGlm())); }
	T Size() const { return std::sqrt(X * X + Y * Y + Z * Z + W * W); }
	TVector<T> GetForwardVector() const { return RotateVector(TVector<T>::ForwardVector); }
	TVector<T> GetRightVector() const { return RotateVector(TVector<T>::RightVector); }
	TVector<T> GetUpVector() const { return RotateVector(TVector<T>::UpVector); }
	bool Equals(const TQuat& Other, T Tolerance = UE_KINDA_SMALL_NUMBER) const
	{
		// A quaternion and its negative are one rotation.
		const T Dot = X * Other.X + Y * Other.Y + Z * Other.Z + W * Other.W;
		return T(1) - std::fabs(Dot) <= Tolerance;
	}
	static TQuat Slerp(const TQuat& A, const TQuat& B, T Alpha)
	{
		return FromGlm(glm::slerp(A.ToGlm(), B.ToGlm(), Alpha));
	}

private:
	using GlmQuat = glm::qua<T, glm::defaultp>;

	/** Yaw and pitch lead the forward axis; the heights of the others tell the roll. Looking straight up or down, yaw
	 * and roll turn about one line: all of it is yaw. */
	static TRotator<T> FromAxes(const TVector<T>& Forward, const TVector<T>& Right, const TVector<T>& Up)
	{
		const T Flat = std::hypot(Forward.X, Forward.Y);
		const bool bUpright = Flat > T(1e-6);
		return TRotator<T>(FMath::RadiansToDegrees(std::atan2(Forward.Z, Flat)),
			FMath::RadiansToDegrees(bUpright ? std::atan2(Forward.Y, Forward.X) : std::atan2(-Right.X, Right.Y)),
			bUpright ? FMath::RadiansToDegrees(std::atan2(-Right.Z, Up.Z)) : T(0));
	}

	GlmQuat ToGlm() const { return GlmQuat(W, X, Y, Z); }
	static TQuat FromGlm(const GlmQuat& Quat) { return {Quat.x, Quat.y, Quat.z, Quat.w}; }
};

template<typename T>
inline const TQuat<T> TQuat<T>::Identity(0, 0, 0, 1);

template<typename T>
TQuat<T>::TQuat(const TMatrix<T>& Matrix)
	: TQuat(FromAxes(Matrix.GetScaledAxis(0), Matrix.GetScaledAxis(1), Matrix.GetScaledAxis(2)).Quaternion())
{
}

template<typename T>
TQuat<T> TRotator<T>::Quaternion() const
{
	// Turning about an axis of a left-handed frame looks reversed in GLM's formulas for pitch and roll only.
	const TQuat<T> AboutZ(TVector<T>(0, 0, 1), FMath::DegreesToRadians(Yaw));
	const TQuat<T> AboutY(TVector<T>(0, 1, 0), -FMath::DegreesToRadians(Pitch));
	const TQuat<T> AboutX(TVector<T>(1, 0, 0), -FMath::DegreesToRadians(Roll));
	return AboutZ * AboutY * AboutX;
}

} // namespace UE::Math
