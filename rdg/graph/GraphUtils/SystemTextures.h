// Small constant textures that stand in for absent inputs. Source: engine SystemTextures.h.
#pragma once

#include "RenderGraphBuilder.h"
#include "RenderResource.h"

/** One-texel textures registered with a graph. */
class DRYDOCK_API FRDGSystemTextures
{
public:
	/** Registers them on first use in this graph. */
	static const FRDGSystemTextures& Get(FRDGBuilder& GraphBuilder);

	FRDGTextureRef White = nullptr;         // (1, 1, 1, 1)
	FRDGTextureRef Black = nullptr;         // (0, 0, 0, 0)
	FRDGTextureRef BlackAlphaOne = nullptr; // (0, 0, 0, 1)
	FRDGTextureRef MidGrey = nullptr;       // (0.5, 0.5, 0.5, 0.5)
	FRDGTextureRef Green = nullptr;         // (0, 1, 0, 1)
	FRDGTextureRef MaxFP16Depth = nullptr;  // 65504, the largest half
	FRDGTextureRef DepthDummy = nullptr;    // 0: far
	FRDGTextureRef StencilDummy = nullptr;  // 0, PF_R8_UINT
	FRDGTextureSRVRef StencilDummySRV = nullptr;
	FRDGTextureRef VolumetricBlack = nullptr; // 3D
	FRDGTextureRef VolumetricBlackAlphaOne = nullptr;
	FRDGTextureRef CubeBlack = nullptr;
};

namespace Drydock
{

/** A plain texture as a graph registers it; made on first use, never freed. */
class DRYDOCK_API FPooledPlainTexture
{
public:
	constexpr FPooledPlainTexture(const TCHAR* InName, const FPlainTexture& InTexture)
		: Name(InName)
		, Texture(InTexture)
	{
	}

	const TRefCountPtr<IPooledRenderTarget>& Get() const;
	operator const TRefCountPtr<IPooledRenderTarget>&() const { return Get(); }
	IPooledRenderTarget* operator->() const { return Get().GetReference(); }

private:
	const TCHAR* Name;
	const FPlainTexture& Texture;
	mutable TRefCountPtr<IPooledRenderTarget>* Pooled = nullptr;
};

} // namespace Drydock

/** The same as pooled textures, for code outside a graph. */
class DRYDOCK_API FSystemTextures
{
public:
	Drydock::FPooledPlainTexture WhiteDummy{TEXT("WhiteDummy"), GWhiteTexture};
	Drydock::FPooledPlainTexture BlackDummy{TEXT("BlackDummy"), GTransparentBlackTexture};
	Drydock::FPooledPlainTexture BlackAlphaOneDummy{TEXT("BlackAlphaOneDummy"), GBlackTexture};

	FRDGTextureRef GetBlackDummy(FRDGBuilder& GraphBuilder) const
	{
		return FRDGSystemTextures::Get(GraphBuilder).Black;
	}
	FRDGTextureRef GetWhiteDummy(FRDGBuilder& GraphBuilder) const
	{
		return FRDGSystemTextures::Get(GraphBuilder).White;
	}
	FRDGTextureRef GetBlackAlphaOneDummy(FRDGBuilder& GraphBuilder) const
	{
		return FRDGSystemTextures::Get(GraphBuilder).BlackAlphaOne;
	}
	FRDGTextureRef GetCubeBlackDummy(FRDGBuilder& GraphBuilder) const
	{
		return FRDGSystemTextures::Get(GraphBuilder).CubeBlack;
	}
	FRDGTextureRef GetVolumetricBlackDummy(FRDGBuilder& GraphBuilder) const
	{
		return FRDGSystemTextures::Get(GraphBuilder).VolumetricBlack;
	}
	FRDGTextureRef GetVolumetricBlackAlphaOneDummy(FRDGBuilder& GraphBuilder) const
	{
		return FRDGSystemTextures::Get(GraphBuilder).VolumetricBlackAlphaOne;
	}
};

extern DRYDOCK_API FSystemTextures GSystemTextures;
