// The frame around a pass (Cases.h).
#include "Cases.h"

#include <cmath>

namespace Stability
{

namespace
{

PassReference::FRect GetRect(const FCase& Case)
{
	return {Case.Offset.X, Case.Offset.Y, Case.Offset.X + Case.Image.Width, Case.Offset.Y + Case.Image.Height};
}

FIntPoint GetExtent(const FCase& Case)
{
	return FIntPoint(
		Case.Offset.X + Case.Image.Width + Case.Padding.X, Case.Offset.Y + Case.Image.Height + Case.Padding.Y);
}

} // namespace

FFrameRun::FFrameRun(const FCase& InCase)
	: FPassRun(InCase.Image, GetRect(InCase), GetExtent(InCase), InCase.Arithmetic, InCase.Format)
	, Case(InCase)
{
	// Reversed depth of a near plane at 10 cm: z = 10 / d.
	View.UniformParameters.InvDeviceZToWorldZTransform = FVector4f(0.0f, 0.0f, 0.1f, 0.0f);
	View.InitViewUniformBuffer(GetExtent(Case));
}

FRDGTextureRef FFrameRun::Add(const std::function<FTexel(int, int)>& Texel, EPixelFormat Format, const TCHAR* Name)
{
	return AddInput(
		FImage::Make(Case.Image.Width, Case.Image.Height, Texel), GetRect(Case), GetExtent(Case), Format, Name)
		.Texture;
}

TRDGUniformBufferRef<FSceneTextureUniformParameters> FFrameRun::GetSceneTextures()
{
	if (Buffer != nullptr)
	{
		return Buffer;
	}
	const auto IsBehind = [](int X)
	{
		return X < 44;
	};
	SceneTextures.Color = Input.Texture;
	SceneTextures.Depth = Add(
		[&](int X, int) {
			return FTexel{10.0 / (IsBehind(X) ? 2000.0 : 300.0), 0, 0, 0};
		},
		PF_R32_FLOAT, TEXT("Depth"));
	// As the G-buffer stores it: square roots of screen position.
	SceneTextures.Velocity = Add(
		[&](int X, int)
		{
			const double Screen = IsBehind(X) ? 2.0 * 3.7 / Case.Image.Width : 0.0;
			return FTexel{std::sqrt(Screen) * std::sqrt(2.0) * 0.2495 + 32767.0 / 65535.0, 32767.0 / 65535.0, 0, 0};
		},
		PF_A32B32G32R32F, TEXT("Velocity"));
	SceneTextures.GBufferB = Add(
		[](int X, int) {
			return FTexel{0, 0, 0, (IsCloth(X) ? 8 : 1) / 255.0};
		},
		PF_B8G8R8A8, TEXT("GBufferB"));
	SceneTextures.GBufferC = Add([](int, int) { return FTexel{1, 1, 1, 1}; }, PF_B8G8R8A8, TEXT("GBufferC"));
	SceneTextures.GBufferD = Add(
		[](int X, int Y) {
			return FTexel{0, 0, GetMask(X, Y), 0};
		},
		PF_B8G8R8A8, TEXT("GBufferD"));
	View.SceneTextures = &SceneTextures;
	Buffer = CreateSceneTextureUniformBuffer(GraphBuilder, View);
	return Buffer;
}

} // namespace Stability
