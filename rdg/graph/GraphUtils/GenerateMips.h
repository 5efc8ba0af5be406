// FGenerateMips: fills the mips of a texture from the one above. Source: engine GenerateMips.h.
#pragma once

#include "RenderGraphUtils.h"

/** How texels beyond the edges are read. The filter is bilinear. */
struct FGenerateMipsParams
{
	ESamplerFilter Filter = SF_Bilinear;
	ESamplerAddressMode AddressU = AM_Clamp;
	ESamplerAddressMode AddressV = AM_Clamp;
	ESamplerAddressMode AddressW = AM_Clamp;
};

enum class EGenerateMipsPass
{
	AutoDetect,
	Compute,
	Raster
};

class DRYDOCK_API FGenerateMips
{
public:
	/** A texel of a mip is the one above it, sampled at its middle: the mean of four where the size is even. One pass a
	 * mip; edges are clamped whatever Params says. A texture of one mip stays as it is. */
	static void Execute(FRDGBuilder& GraphBuilder, ERHIFeatureLevel::Type FeatureLevel, FRDGTextureRef Texture,
		FGenerateMipsParams Params = {}, EGenerateMipsPass Pass = EGenerateMipsPass::AutoDetect);
};
