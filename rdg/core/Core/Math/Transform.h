// FTransform: a scale, then a rotation, then a translation. A * B applies A first, as with matrices. Source: engine
// Math/TransformNonVectorized.h.
#pragma once

#include "Math/Matrix.h"
#include "Math/Quat.h"

namespace UE::Math
{

template<typename T>
struct TTransform
{
	using FReal = T;

	static const TTransform Identity;

	TTransform() = default;
	explicit TTransform(const TVector<T>& InTranslation)
		: Translation(InTranslation)
	{
	}
	explicit TTransform(const TQuat<T>& InRotation)
		: Rotation(InRotation)
	{
	}
	explicit TTransform(const TRotator<T>& InRotation)
		: TTransform(InRotation.Quaternion())
	{
	}
	TTransform(
		const TQuat<T>& InRotation, const TVector<T>& InTranslation, const TVector<T>& InScale3D = TVector<T>(1, 1, 1))
		: Rotation(InRotation)
		, Translation(InTranslation)
		, Scale3D(InScale3D)
	{
	}
	TTransform(const TRotator<T>& InRotation, const TVector<T>& InTranslation,
		const TVector<T>& InScale3D = TVector<T>(1, 1, 1))
		: TTransform(InRotation.Quaternion(), InTranslation, InScale3D)
	{
	}
	/** A matrix without shear. If it mirrors, the scale of X is negative. */
	explicit TTransform(const TMatrix<T>& Matrix)
		: Translation(Matrix.GetOrigin())
	{
		TVector<T> Axes[3] = {Matrix.GetScaledAxis(0), Matrix.GetScaledAxis(1), Matrix.GetScaledAxis(2)};
		Scale3D = TVector<T>(Axes[0].Size(), Axes[1].Size(), Axes[2].Size());
		if (((Axes[0] ^ Axes[1]) | Axes[2]) < 0)
		{
			Scale3D.X = -Scale3D.X;
		}
		for (int32 Axis = 0; Axis < 3; ++Axis)
		{
			Axes[Axis] = Axes[Axis] * Reciprocal(Scale3D[Axis]);
		}
		Rotation = TQuat<T>(TMatrix<T>(Axes[0], Axes[1], Axes[2], TVector<T>()));
	}

	bool Equals(const TTransform& Other, T Tolerance = UE_KINDA_SMALL_NUMBER) const
	{
		return Rotation.Equals(Other.Rotation, Tolerance) && Translation.Equals(Other.Translation, Tolerance) &&
			   Scale3D.Equals(Other.Scale3D, Tolerance);
	}
	/** First this, then Other. Rotations, and scales that differ by axis, do not mix in one transform: what both leave
	 * of shear is lost, as in the engine. */
	TTransform operator*(const TTransform& Other) const
	{
		if (HasNegativeScale() || Other.HasNegativeScale())
		{
			// A mirror does not compose by quaternions.
			const TVector<T> Scale = Scale3D * Other.Scale3D;
			const TMatrix<T> Both = ToMatrixWithScale() * Other.ToMatrixWithScale();
			TMatrix<T> Axes = TMatrix<T>::Identity;
			for (int32 Axis = 0; Axis < 3; ++Axis)
			{
				const TVector<T> Row = Both.GetScaledAxis(Axis).GetSafeNormal() * (Scale[Axis] < T(0) ? T(-1) : T(1));
				Axes.M[Axis][0] = Row.X;
				Axes.M[Axis][1] = Row.Y;
				Axes.M[Axis][2] = Row.Z;
			}
			return TTransform(TQuat<T>(Axes), Both.GetOrigin(), Scale);
		}
		return TTransform(Other.Rotation * Rotation, Other.TransformPosition(Translation), Scale3D * Other.Scale3D);
	}
	TTransform& operator*=(const TTransform& Other) { return *this = *this * Other; }
	/** Undoes this, if the scale is the same on all axes. A scale of 0 stays 0. */
	TTransform Inverse() const
	{
		const TQuat<T> Back = Rotation.Inverse();
		const TVector<T> Scale = GetSafeScaleReciprocal(Scale3D);
		return TTransform(Back, Back.RotateVector(Scale * (Translation * T(-1))), Scale);
	}
	/** The transform from Other's frame to this: this * Other.Inverse(). */
	TTransform GetRelativeTransform(const TTransform& Other) const
	{
		const TVector<T> Scale = GetSafeScaleReciprocal(Other.Scale3D);
		return TTransform(Other.Rotation.Inverse() * Rotation,
			Other.Rotation.UnrotateVector(Translation - Other.Translation) * Scale, Scale3D * Scale);
	}

	TVector<T> TransformPosition(const TVector<T>& V) const { return Rotation.RotateVector(V * Scale3D) + Translation; }
	TVector<T> TransformPositionNoScale(const TVector<T>& V) const { return Rotation.RotateVector(V) + Translation; }
	TVector<T> TransformVector(const TVector<T>& V) const { return Rotation.RotateVector(V * Scale3D); }
	TVector<T> TransformVectorNoScale(const TVector<T>& V) const { return Rotation.RotateVector(V); }
	TQuat<T> TransformRotation(const TQuat<T>& Q) const { return Rotation * Q; }
	TVector<T> InverseTransformPosition(const TVector<T>& V) const
	{
		return Rotation.UnrotateVector(V - Translation) * GetSafeScaleReciprocal(Scale3D);
	}
	TVector<T> InverseTransformVector(const TVector<T>& V) const
	{
		return Rotation.UnrotateVector(V) * GetSafeScaleReciprocal(Scale3D);
	}

	TMatrix<T> ToMatrixWithScale() const
	{
		return TMatrix<T>(Rotation.GetForwardVector() * Scale3D.X, Rotation.GetRightVector() * Scale3D.Y,
			Rotation.GetUpVector() * Scale3D.Z, Translation);
	}

	TQuat<T> GetRotation() const { return Rotation; }
	TRotator<T> Rotator() const { return Rotation.Rotator(); }
	TVector<T> GetTranslation() const { return Translation; }
	TVector<T> GetLocation() const { return Translation; }
	TVector<T> GetScale3D() const { return Scale3D; }
	void SetRotation(const TQuat<T>& InRotation) { Rotation = InRotation; }
	void SetTranslation(const TVector<T>& InTranslation) { Translation = InTranslation; }
	void SetLocation(const TVector<T>& InTranslation) { Translation = InTranslation; }
	void SetScale3D(const TVector<T>& InScale3D) { Scale3D = InScale3D; }
	void AddToTranslation(const TVector<T>& Delta) { Translation = Translation + Delta; }
	/** 1 / Scale by component; 0 where the scale is within the tolerance of 0. */
	static TVector<T> GetSafeScaleReciprocal(const TVector<T>& Scale, T Tolerance = UE_SMALL_NUMBER)
	{
		return {Reciprocal(Scale.X, Tolerance), Reciprocal(Scale.Y, Tolerance), Reciprocal(Scale.Z, Tolerance)};
	}

private:
	static T Reciprocal(T Value, T Tolerance = UE_SMALL_NUMBER)
	{
		return std::fabs(Value) <= Tolerance ? T(0) : T(1) / Value;
	}
	bool HasNegativeScale() const { return Scale3D.GetMin() < T(0); }

	TQuat<T> Rotation;
	TVector<T> Translation;
	TVector<T> Scale3D = TVector<T>(1, 1, 1);
};

template<typename T>
inline const TTransform<T> TTransform<T>::Identity;

} // namespace UE::Math
