// Scene textures of things that move, for tests of passes that follow velocities.
#pragma once

#include "PassTestUtils.h"

#include <functional>

namespace PassTest
{

struct FMotion
{
	double X = 0.0;       // pixels since the frame before
	double Y = 0.0;       // down
	double Depth = 500.0; // cm
};

using FMotionAt = std::function<FMotion(int, int)>;

/** As the G-buffer stores it: square roots of screen position, y up. */
inline FTexel EncodeMotion(const FMotion& Motion, int Width, int Height)
{
	const auto Root = [](double Velocity)
	{
		return std::copysign(std::sqrt(std::abs(Velocity)), Velocity) * std::sqrt(2.0) * 0.2495 + 32767.0 / 65535.0;
	};
	return {Root(2 * Motion.X / Width), Root(-2 * Motion.Y / Height), 0, 0};
}

/** Depth, reversed for a near plane at 10 cm (z = 10 / d), and velocity of each pixel of Rect, in 32-bit floats. */
inline FSceneTextures AddMotion(FPassRun& Pass, const FRect& Rect, FIntPoint Extent, const FMotionAt& Motion)
{
	const auto Add = [&](const std::function<FTexel(int, int)>& Texel, EPixelFormat Format, const TCHAR* Name)
	{
		return Pass.AddInput(FImage::Make(Rect.Width(), Rect.Height(), Texel), Rect, Extent, Format, Name).Texture;
	};
	FSceneTextures SceneTextures;
	SceneTextures.Depth = Add(
		[&](int X, int Y) {
			return FTexel{10 / Motion(X, Y).Depth, 0, 0, 0};
		},
		PF_R32_FLOAT, TEXT("Depth"));
	SceneTextures.Velocity = Add([&](int X, int Y) { return EncodeMotion(Motion(X, Y), Rect.Width(), Rect.Height()); },
		PF_A32B32G32R32F, TEXT("Velocity"));
	return SceneTextures;
}

} // namespace PassTest
