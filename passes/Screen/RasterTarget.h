// Creates textures that full-screen passes write: they are not loaded or cleared, because the pass writes every texel
// of the rect. Written after the engine's FScreenPassRenderTarget::CreateFromInput, which keeps the flags and so may
// not be a render target.
#pragma once

#include "RenderGraphBuilder.h"
#include "ScreenPass.h"

namespace Drydock
{

/** Creates a target of this extent and format, readable by shaders; Rect in texels, inside the extent. Name is kept as
 * a pointer. bCompute: written by a compute shader, as a UAV, and not a render target. */
inline FScreenPassRenderTarget CreateScreenTarget(
	FRDGBuilder& GraphBuilder, FRDGTextureDesc Desc, const FIntRect& Rect, const TCHAR* Name, bool bCompute)
{
	Desc.Reset();
	Desc.Flags &= ~(TexCreate_RenderTargetable | TexCreate_UAV);
	Desc.Flags |= TexCreate_ShaderResource | (bCompute ? TexCreate_UAV : TexCreate_RenderTargetable);
	return FScreenPassRenderTarget(GraphBuilder.CreateTexture(Desc, Name), Rect, ERenderTargetLoadAction::ENoAction);
}

/** Creates a target for a pass that draws. */
inline FScreenPassRenderTarget CreateRasterTarget(
	FRDGBuilder& GraphBuilder, const FRDGTextureDesc& Desc, const FIntRect& Rect, const TCHAR* Name)
{
	return CreateScreenTarget(GraphBuilder, Desc, Rect, Name, false);
}

/** Creates a target of Like's extent and rect; PF_Unknown: of its format too. */
inline FScreenPassRenderTarget CreateRasterTargetLike(
	FRDGBuilder& GraphBuilder, const FScreenPassTexture& Like, const TCHAR* Name, EPixelFormat Format = PF_Unknown)
{
	FRDGTextureDesc Desc = Like.Texture->Desc;
	Desc.Format = Format != PF_Unknown ? Format : Desc.Format;
	return CreateRasterTarget(GraphBuilder, Desc, Like.ViewRect, Name);
}

/** Holds a rect of this size, in texels, and nothing else: it starts at the texture's origin. */
inline FScreenPassRenderTarget CreateSmallRasterTarget(FRDGBuilder& GraphBuilder, const FScreenPassTexture& Like,
	FIntPoint Size, const TCHAR* Name, EPixelFormat Format = PF_Unknown)
{
	FRDGTextureDesc Desc = Like.Texture->Desc;
	Desc.Extent = FIntPoint(FMath::Max(1, Size.X), FMath::Max(1, Size.Y));
	Desc.Format = Format != PF_Unknown ? Format : Desc.Format;
	return CreateRasterTarget(GraphBuilder, Desc, FIntRect(FIntPoint::ZeroValue, Desc.Extent), Name);
}

} // namespace Drydock
