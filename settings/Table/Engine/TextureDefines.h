// The settings of a texture asset. Source: engine Engine/TextureDefines.h, Engine/EngineTypes.h.
#pragma once

#include "CoreTypes.h"

/** How the engine's editor packs an asset. Nothing is packed here. */
enum TextureCompressionSettings : int
{
	TC_Default,
	TC_Normalmap,
	TC_Masks,
	TC_Grayscale,
	TC_Displacementmap,
	TC_VectorDisplacementmap,
	TC_HDR,
	TC_EditorIcon,
	TC_Alpha,
	TC_DistanceFieldFont,
	TC_HDR_Compressed,
	TC_BC7,
	TC_HalfFloat,
	TC_MAX,
};

enum TextureFilter : int
{
	TF_Nearest,
	TF_Bilinear,
	TF_Trilinear,
	TF_Default, // that of the group: linear
	TF_MAX,
};

enum TextureAddress : int
{
	TA_Wrap,
	TA_Clamp,
	TA_Mirror,
	TA_MAX,
};

/** How the engine's editor makes mips. None are made here. */
enum TextureMipGenSettings : int
{
	TMGS_FromTextureGroup,
	TMGS_SimpleAverage,
	TMGS_NoMipmaps = 13,
	TMGS_LeaveExistingMips,
};

/** Groups share limits of size in the engine; there are no limits here. */
enum TextureGroup : int
{
	TEXTUREGROUP_World,
	TEXTUREGROUP_Lightmap = 12,
	TEXTUREGROUP_UI = 15,
	TEXTUREGROUP_RenderTarget = 19,
	TEXTUREGROUP_Pixels2D = 26,
};
