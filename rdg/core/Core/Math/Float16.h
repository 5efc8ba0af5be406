// FFloat16: a number of 16 bits, IEEE 754 binary16; and colours and vectors of them. Source: engine Math/Float16.h,
// Math/Float16Color.h, Math/Vector2DHalf.h.
#pragma once

#include "Math/Color.h"
#include "Math/Vector2D.h"

/** From -65504 to 65504. Other numbers are rounded to the nearest, a tie to the even one, and beyond the range
 * they are infinite.
 */
class FFloat16
{
public:
	uint16 Encoded = 0;

	FFloat16() = default;
	FFloat16(float Value) { Set(Value); }

	DRYDOCK_API void Set(float Value);
	DRYDOCK_API float GetFloat() const;
	operator float() const { return GetFloat(); }
	bool operator==(const FFloat16&) const = default;
};

class FFloat16Color
{
public:
	FFloat16 R;
	FFloat16 G;
	FFloat16 B;
	FFloat16 A;

	/** All zero. */
	FFloat16Color() = default;
	FFloat16Color(const FLinearColor& Color)
		: R(Color.R)
		, G(Color.G)
		, B(Color.B)
		, A(Color.A)
	{
	}
	FLinearColor GetFloats() const { return FLinearColor(R.GetFloat(), G.GetFloat(), B.GetFloat(), A.GetFloat()); }
	bool operator==(const FFloat16Color&) const = default;
};

struct FVector2DHalf
{
	FFloat16 X;
	FFloat16 Y;

	FVector2DHalf() = default;
	FVector2DHalf(float InX, float InY)
		: X(InX)
		, Y(InY)
	{
	}
	FVector2DHalf(const FVector2D& Vector)
		: FVector2DHalf(static_cast<float>(Vector.X), static_cast<float>(Vector.Y))
	{
	}
	operator FVector2D() const
	{
		return FVector2D(static_cast<double>(X.GetFloat()), static_cast<double>(Y.GetFloat()));
	}
};
