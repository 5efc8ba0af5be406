// FPackedNormal: a direction as four signed bytes, -127 for -1 to 127 for 1. Source: engine PackedNormal.h.
#pragma once

#include "Math/Vector4.h"

struct FPackedNormal
{
	struct
	{
		int8 X = 0;
		int8 Y = 0;
		int8 Z = 0;
		int8 W = 0;
	} Vector;

	FPackedNormal() = default;
	FPackedNormal(const FVector4f& InVector) { Set(InVector); }
	/** W becomes 1. */
	FPackedNormal(const FVector3f& InVector) { Set(FVector4f(InVector, 1.0f)); }

	/** Numbers outside of -1 to 1 are clamped. */
	void Set(const FVector4f& InVector)
	{
		Vector = {Pack(InVector.X), Pack(InVector.Y), Pack(InVector.Z), Pack(InVector.W)};
	}
	FVector4f ToFVector4f() const
	{
		return FVector4f(Vector.X / 127.0f, Vector.Y / 127.0f, Vector.Z / 127.0f, Vector.W / 127.0f);
	}
	FVector3f ToFVector3f() const { return FVector3f(ToFVector4f()); }
	FVector ToFVector() const { return FVector(ToFVector3f()); }

private:
	static int8 Pack(float Value)
	{
		return static_cast<int8>(FMath::Clamp(FMath::RoundToInt(Value * 127.0f), -127, 127));
	}
};
