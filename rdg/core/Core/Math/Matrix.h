// FMatrix44f and FMatrix: 4x4 matrices stored by rows and applied to row vectors, so that A * B applies A first; and
// the projections and translations the renderer builds. GLM stores columns and applies them to column vectors: the same
// numbers in memory, with products in the opposite order. Source: engine Math/Matrix.h and its specialisations.
#pragma once

#include "Math/Rotator.h"

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include <cstring>

namespace UE::Math
{

template<typename T>
struct alignas(16) TMatrix
{
	using FReal = T;
	using GlmMatrix = glm::mat<4, 4, T, glm::defaultp>;

	T M[4][4] = {};

	static const TMatrix Identity;

	/** All zeros. */
	constexpr TMatrix() = default;
	constexpr explicit TMatrix(EForceInit) {}
	/** Rows; the last one is the translation. */
	constexpr TMatrix(const TVector<T>& X, const TVector<T>& Y, const TVector<T>& Z, const TVector<T>& W)
		: M{{X.X, X.Y, X.Z, 0}, {Y.X, Y.Y, Y.Z, 0}, {Z.X, Z.Y, Z.Z, 0}, {W.X, W.Y, W.Z, 1}}
	{
	}
	constexpr TMatrix(const TVector4<T>& X, const TVector4<T>& Y, const TVector4<T>& Z, const TVector4<T>& W)
		: M{{X.X, X.Y, X.Z, X.W}, {Y.X, Y.Y, Y.Z, Y.W}, {Z.X, Z.Y, Z.Z, Z.W}, {W.X, W.Y, W.Z, W.W}}
	{
	}
	template<typename Other>
	requires(!std::is_same_v<Other, T>) constexpr explicit TMatrix(const TMatrix<Other>& Matrix)
	{
		for (int32 Row = 0; Row < 4; ++Row)
		{
			for (int32 Column = 0; Column < 4; ++Column)
			{
				M[Row][Column] = static_cast<T>(Matrix.M[Row][Column]);
			}
		}
	}

	constexpr bool operator==(const TMatrix&) const = default;
	bool Equals(const TMatrix& Other, T Tolerance = UE_KINDA_SMALL_NUMBER) const
	{
		for (int32 Index = 0; Index < 16; ++Index)
		{
			if (!(std::fabs(M[Index / 4][Index % 4] - Other.M[Index / 4][Index % 4]) <= Tolerance))
			{
				return false;
			}
		}
		return true;
	}
	void SetIdentity() { *this = Identity; }

	TMatrix operator*(const TMatrix& Other) const { return FromGlm(Other.ToGlm() * ToGlm()); }
	TMatrix& operator*=(const TMatrix& Other) { return *this = *this * Other; }
	TMatrix operator*(T Scale) const { return FromGlm(ToGlm() * Scale); }
	TMatrix operator+(const TMatrix& Other) const { return FromGlm(ToGlm() + Other.ToGlm()); }
	TMatrix GetTransposed() const { return FromGlm(glm::transpose(ToGlm())); }
	T Determinant() const { return glm::determinant(ToGlm()); }
	/** The identity if there is no inverse, as in the engine. */
	TMatrix Inverse() const { return Determinant() == T(0) ? Identity : FromGlm(glm::inverse(ToGlm())); }

	TVector4<T> TransformFVector4(const TVector4<T>& Vector) const
	{
		return UE::Math::FromGlm<TVector4<T>>(ToGlm() * UE::Math::ToGlm(Vector));
	}
	TVector4<T> TransformPosition(const TVector<T>& Position) const
	{
		return TransformFVector4(TVector4<T>(Position, T(1)));
	}
	/** A direction: without translation. */
	TVector4<T> TransformVector(const TVector<T>& Vector) const { return TransformFVector4(TVector4<T>(Vector, T(0))); }
	TVector<T> GetOrigin() const { return {M[3][0], M[3][1], M[3][2]}; }
	void SetOrigin(const TVector<T>& Origin)
	{
		M[3][0] = Origin.X;
		M[3][1] = Origin.Y;
		M[3][2] = Origin.Z;
	}
	/** Row 0, 1 or 2 without its last number. */
	TVector<T> GetScaledAxis(int32 Axis) const { return {M[Axis][0], M[Axis][1], M[Axis][2]}; }
	TVector<T> GetColumn(int32 Column) const { return {M[0][Column], M[1][Column], M[2][Column]}; }
	FString ToString() const
	{
		FString Text;
		for (const auto& Row : M)
		{
			Text.Appendf("[%g %g %g %g] ", static_cast<double>(Row[0]), static_cast<double>(Row[1]),
				static_cast<double>(Row[2]), static_cast<double>(Row[3]));
		}
		return Text;
	}

private:
	GlmMatrix ToGlm() const
	{
		GlmMatrix Result;
		std::memcpy(&Result, M, sizeof(M));
		return Result;
	}
	static TMatrix FromGlm(const GlmMatrix& Matrix)
	{
		TMatrix Result;
		std::memcpy(Result.M, &Matrix, sizeof(Result.M));
		return Result;
	}
};

template<typename T>
inline const TMatrix<T> TMatrix<T>::Identity(
	TVector<T>(1, 0, 0), TVector<T>(0, 1, 0), TVector<T>(0, 0, 1), TVector<T>(0, 0, 0));

/** Moves by Delta. */
template<typename T>
struct TTranslationMatrix : TMatrix<T>
{
	constexpr explicit TTranslationMatrix(const TVector<T>& Delta)
		: TMatrix<T>(TVector<T>(1, 0, 0), TVector<T>(0, 1, 0), TVector<T>(0, 0, 1), Delta)
	{
	}
};

template<typename T>
struct TScaleMatrix : TMatrix<T>
{
	constexpr explicit TScaleMatrix(const TVector<T>& Scale)
		: TMatrix<T>(TVector<T>(Scale.X, 0, 0), TVector<T>(0, Scale.Y, 0), TVector<T>(0, 0, Scale.Z), TVector<T>())
	{
	}
	constexpr explicit TScaleMatrix(T Scale)
		: TScaleMatrix(TVector<T>(Scale))
	{
	}
};

/** Turns the axes to forward, right and up of a rotator. */
template<typename T>
struct TRotationMatrix : TMatrix<T>
{
	explicit TRotationMatrix(const TRotator<T>& Rotator)
		: TMatrix<T>(Rotator.GetForward(), Rotator.GetRight(), Rotator.GetUp(), TVector<T>())
	{
	}
};

/** Undoes TRotationMatrix. */
template<typename T>
struct TInverseRotationMatrix : TMatrix<T>
{
	explicit TInverseRotationMatrix(const TRotator<T>& Rotator)
		: TMatrix<T>(TRotationMatrix<T>(Rotator).GetTransposed())
	{
	}
};

/** Perspective with device depth 1 at MinZ and 0 at infinity. HalfFOV in radians, horizontal; the view looks along +Z.
 */
template<typename T>
struct TReversedZPerspectiveMatrix : TMatrix<T>
{
	TReversedZPerspectiveMatrix(T HalfFOV, T Width, T Height, T MinZ)
		: TMatrix<T>(TVector4<T>(T(1) / std::tan(HalfFOV), 0, 0, 0),
			  TVector4<T>(0, Width / std::tan(HalfFOV) / Height, 0, 0), TVector4<T>(0, 0, 0, 1),
			  TVector4<T>(0, 0, MinZ, 0))
	{
	}
};

} // namespace UE::Math

using FTranslationMatrix = UE::Math::TTranslationMatrix<double>;
using FTranslationMatrix44f = UE::Math::TTranslationMatrix<float>;
using FScaleMatrix = UE::Math::TScaleMatrix<double>;
using FScaleMatrix44f = UE::Math::TScaleMatrix<float>;
using FRotationMatrix = UE::Math::TRotationMatrix<double>;
using FRotationMatrix44f = UE::Math::TRotationMatrix<float>;
using FInverseRotationMatrix = UE::Math::TInverseRotationMatrix<double>;
using FReversedZPerspectiveMatrix = UE::Math::TReversedZPerspectiveMatrix<double>;
using FReversedZPerspectiveMatrix44f = UE::Math::TReversedZPerspectiveMatrix<float>;
