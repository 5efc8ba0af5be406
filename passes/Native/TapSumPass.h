// Declares what the native kernels of blurs share: the pixels that a tile stands for, the axes of a screen pass, and
// the way back to the shader.
#pragma once

#include "BoundShader.h"
#include "CoreMinimal.h"
#include "Native/TapSum.h"
#include "ScreenPass.h"

namespace Drydock
{

/** The place where a tile of a screen shader is stored. */
struct FTapTarget
{
	const FKernelTexture* Texture = nullptr;
	FKernelTile Pixels = {};
};

/** Target of a pixel shader: its first target, pixel for pixel. */
FTapTarget GetPixelTarget(const FNativeKernelArgs& Args, const FKernelTile& Tile);

/** Target of a compute shader that stores thread (x, y) at Min + (x, y), below Max. */
FTapTarget GetComputeTarget(
	const FNativeKernelArgs& Args, const FKernelTile& Tile, const char* HlslName, FIntPoint Min, FIntPoint Max);

/** The texture and sampler of those names, and the rect of a viewport in it. */
FTapSource MakeTapSource(const FNativeKernelArgs& Args, const char* Texture, const char* Sampler,
	const FScreenPassTextureViewportParameters& Viewport);

/** The axis, 0 or 1, of a shader that maps its viewport onto UV of another and stays inside its bilinear rect. */
FTapAxis MakeStretchAxis(
	const FScreenPassTextureViewportParameters& Output, const FScreenPassTextureViewportParameters& Input, int Axis);

/** The axis, 0 or 1, of a shader that takes a tap at pixel * InputPerOutput + Corner + Offset, in texels, and stays
 * inside the bilinear rect. */
FTapAxis MakeOffsetAxis(const FScreenPassTextureViewportParameters& Input, FVector2f InputPerOutput, FVector2f Corner,
	float Offset, int Axis);

/** Stores the sum of a tile, by the shader where there is no other way. Origin: of the pixels that the axes of the taps
 * count. */
void SumTapsOrRunShader(const FTapSum& Sum, const FNativeKernelArgs& Args, const FKernelTile& Tile,
	const FTapTarget& Target, FIntPoint Origin = FIntPoint(0, 0));

} // namespace Drydock
