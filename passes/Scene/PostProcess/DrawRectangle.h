// The rectangle of screen passes with the engine's newer name. Source: engine file PostProcess/DrawRectangle.h.
#pragma once

#include "ScreenPass.h"

namespace UE::Renderer::PostProcess
{

/** Inside a raster lambda. The rectangle covers X..X+SizeX of a target of TargetSize; the UV rectangle is U..U+SizeU of
 * a texture of TextureSize. */
template<typename TVertexShader>
void DrawRectangle(FRHICommandList& RHICmdList, const TShaderRef<TVertexShader>& VertexShader, float X, float Y,
	float SizeX, float SizeY, float U, float V, float SizeU, float SizeV, FIntPoint TargetSize, FIntPoint TextureSize,
	EDrawRectangleFlags = EDRF_Default, uint32 = 1)
{
	::DrawRectangle(RHICmdList, X, Y, SizeX, SizeY, U, V, SizeU, SizeV, TargetSize, TextureSize, VertexShader);
}

} // namespace UE::Renderer::PostProcess
