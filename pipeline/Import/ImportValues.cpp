// The formulas of depth, normals and velocity. Sources: engine Common.ush (device depth, NDC velocity), Blender's
// Cycles (motion passes: last position less this one), the channels' units in configs/scenes/README.md.
#include "Import/ImportConvert.h"

#include "SceneFile/SceneCamera.h"

#include <cmath>

namespace Drydock
{

namespace
{

double GetDistance(double Value, const FImportEncoding& Encoding)
{
	const double Metres = GetMetres(Encoding.Unit);
	return Encoding.Depth == EImportDepth::Inverse  ? Metres / Value
		   : Encoding.Depth == EImportDepth::Device ? 0.01 * SceneNearPlane / Value
		   : Encoding.Depth != EImportDepth::Mist   ? Value * Metres
		   : Value < 1.0                            ? Encoding.Mist.Start + Value * Encoding.Mist.Depth
													: HUGE_VAL;
}

std::array<double, 3> TurnToWorld(
	const std::array<double, 3>& N, EImportNormalSpace Space, const std::array<double, 3>& Rotation)
{
	switch (Space)
	{
	case EImportNormalSpace::Unreal:
		return {N[0], -N[1], N[2]};
	case EImportNormalSpace::YUp:
		return {N[0], -N[2], N[1]};
	case EImportNormalSpace::Camera:
		return CameraToWorld(N, Rotation);
	default:
		return N;
	}
}

} // namespace

std::optional<float> ConvertDepth(
	float Value, const FImportEncoding& Encoding, const FImportPixel& Pixel, double FocalLength)
{
	double Distance = GetDistance(static_cast<double>(Value), Encoding);
	if (Encoding.Depth == EImportDepth::Ray)
	{
		const double X = (Pixel.X + 0.5 - 0.5 * Pixel.Width) / FocalLength;
		const double Y = (Pixel.Y + 0.5 - 0.5 * Pixel.Height) / FocalLength;
		Distance /= std::sqrt(1.0 + X * X + Y * Y);
	}
	// Half floats end at 65504: further away is stored as that, in whatever unit.
	const bool bSurface = Distance > 0.0 && Distance < static_cast<double>(NoSurfaceDepth) && Value != NoSurfaceDepth;
	return bSurface ? std::optional(static_cast<float>(Distance)) : std::nullopt;
}

std::array<float, 3> ConvertNormal(
	const std::array<float, 3>& Value, const FImportEncoding& Encoding, const std::array<double, 3>& Rotation)
{
	constexpr double Exact = 1e-3;      // as near to 1 as halves come
	constexpr double LeastLength = 0.1; // the mean of a surface and none, or noise
	if (Value[0] == 0.0f && Value[1] == 0.0f && Value[2] == 0.0f)
	{
		return {};
	}
	std::array<double, 3> N = {};
	for (size_t Axis = 0; Axis < 3; ++Axis)
	{
		const double Component = static_cast<double>(Value[Axis]);
		N[Axis] = Encoding.bHalved ? 2.0 * Component - 1.0 : Component;
	}
	const double Length = std::sqrt(N[0] * N[0] + N[1] * N[1] + N[2] * N[2]);
	if (!(Length >= LeastLength) || !std::isfinite(Length))
	{
		return {};
	}
	N = TurnToWorld(N, Encoding.NormalSpace, Rotation);
	const double Scale = std::abs(Length - 1.0) <= Exact ? 1.0 : 1.0 / Length;
	return {static_cast<float>(N[0] * Scale), static_cast<float>(N[1] * Scale), static_cast<float>(N[2] * Scale)};
}

std::array<float, 2> ConvertVelocity(
	const std::array<float, 2>& Value, const FImportEncoding& Encoding, int Width, int Height)
{
	double X = static_cast<double>(Value[0]);
	double Y = static_cast<double>(Value[1]);
	if (!std::isfinite(X) || !std::isfinite(Y))
	{
		return {};
	}
	switch (Encoding.Velocity)
	{
	case EImportVelocity::PixelsUp:
		Y = -Y;
		break;
	case EImportVelocity::Ndc:
		X *= 0.5 * Width;
		Y *= -0.5 * Height;
		break;
	case EImportVelocity::Unreal:
		X = (X - 0.5) * 2.0 * Width;
		Y = (Y - 0.5) * -2.0 * Height;
		break;
	case EImportVelocity::Blender:
		X = -X; // to where it was, y up: the way back
		break;
	default:
		break;
	}
	const double Sign = Encoding.bFlipVelocity ? -1.0 : 1.0;
	// Without a minus before zeros.
	return {static_cast<float>(X * Sign + 0.0), static_cast<float>(Y * Sign + 0.0)};
}

} // namespace Drydock
