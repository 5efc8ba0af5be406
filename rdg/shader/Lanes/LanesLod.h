// The mip level that a sample's gradients ask for: log2 of the longer of the two steps, in texels of the view's first
// mip. T is Real or TReal<Real, N>, one operation after the other, so that the interpreter has the bits of the lanes.
// The sampler adds its bias, clamps, and picks or blends mips (LanesCoordinates.inl); NaN is level 0.
// Source: Direct3D 11 functional specification 7.18.11 (isotropic; gradients of cubes).
#pragma once

#include "LanesElementary.h"
#include "LanesResources.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** Finds the longest component of a direction (z before y before x where they are equally long), and how the cube's
 * face there turns vectors. A direction that is not a number points at some face. */
template<typename T>
struct TCubeFrame
{
	using FMask = decltype(T() < T());
	FMask bZ;
	FMask bY;
	FMask bNegative;

	DRYDOCK_LANES_INLINE explicit TCubeFrame(const TVec<T, 3>& Direction)
	{
		const T X = Abs(Direction[0]);
		const T Y = Abs(Direction[1]);
		const T Z = Abs(Direction[2]);
		bZ = Z >= X && Z >= Y;
		bY = !bZ && Y >= X;
		bNegative = Select(bZ, Direction[2], Select(bY, Direction[1], Direction[0])) < T(0);
	}

	/** Along the face's columns, along its rows, and out of it. */
	DRYDOCK_LANES_INLINE TVec<T, 3> Turn(const TVec<T, 3>& V) const
	{
		const T X = Select(bNegative, -V[0], V[0]);
		const T Z = Select(bNegative, -V[2], V[2]);
		const T Out = Select(bZ, Z, Select(bY, Select(bNegative, -V[1], V[1]), X));
		return {Select(bZ, X, Select(bY, V[0], -Z)), Select(!bZ && bY, Z, -V[1]), Out};
	}
};

/** DX, DY: of the coordinates, 0..1 across the texture; 2 axes, 3 of a Texture3D. */
template<typename T, int Axes>
DRYDOCK_LANES_INLINE T GradientLevel(const FKernelTexture& Texture, const TVec<T, Axes>& DX, const TVec<T, Axes>& DY)
{
	const FKernelMip& Mip = Texture.Mips[0];
	const int32_t Sizes[3] = {Mip.SizeX, Mip.SizeY, Mip.SizeZ};
	T SquareX(0);
	T SquareY(0);
	for (int Axis = 0; Axis < Axes; ++Axis)
	{
		const T Size(static_cast<decltype(First(T()))>(Sizes[Axis]));
		const T X = DX[Axis] * Size;
		const T Y = DY[Axis] * Size;
		SquareX = SquareX + X * X;
		SquareY = SquareY + Y * Y;
	}
	return T(0.5f) * Log2(Max(SquareX, SquareY)); // of the lengths, without their roots
}

/** DX, DY: of the direction. */
template<typename T>
DRYDOCK_LANES_INLINE T GradientLevelCube(
	const FKernelTexture& Texture, const TVec<T, 3>& Direction, const TVec<T, 3>& DX, const TVec<T, 3>& DY)
{
	const TCubeFrame<T> Frame(Direction);
	const TVec<T, 3> At = Frame.Turn(Direction);
	const auto OnFace = [&At, &Frame](const TVec<T, 3>& Step)
	{
		const TVec<T, 3> Turned = Frame.Turn(Step);
		const T Scale = T(0.5f) / (At[2] * At[2]); // a face is 2 long, and 1 across the texture
		return TVec<T, 2>(
			(At[2] * Turned[0] - At[0] * Turned[2]) * Scale, (At[2] * Turned[1] - At[1] * Turned[2]) * Scale);
	};
	return GradientLevel(Texture, OnFace(DX), OnFace(DY));
}

/** A level that is not below a sample's own clamp once the sampler has added its bias: Direct3D and Vulkan apply the
 * clamp so, before the sampler's MaxLevel. A level that is not a number gives the clamp. */
template<typename T>
DRYDOCK_LANES_INLINE T ClampLevel(const FKernelSampler& Sampler, const T& Level, const T& Clamp)
{
	const T Bias(static_cast<decltype(First(T()))>(Sampler.MipBias));
	return Select(Level + Bias >= Clamp, Level, Clamp - Bias);
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
