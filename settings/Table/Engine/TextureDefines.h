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
	TEXTUREGROUP_WorldNormalMap,
	TEXTUREGROUP_WorldSpecular,
	TEXTUREGROUP_Character,
	TEXTUREGROUP_CharacterNormalMap,
	TEXTUREGROUP_CharacterSpecular,
	TEXTUREGROUP_Weapon,
	TEXTUREGROUP_WeaponNormalMap,
	TEXTUREGROUP_WeaponSpecular,
	TEXTUREGROUP_Vehicle,
	TEXTUREGROUP_VehicleNormalMap,
	TEXTUREGROUP_VehicleSpecular,
	TEXTUREGROUP_Cinematic,
	TEXTUREGROUP_Effects,
	TEXTUREGROUP_EffectsNotFiltered,
	TEXTUREGROUP_Skybox,
	TEXTUREGROUP_UI,
	TEXTUREGROUP_Lightmap,
	TEXTUREGROUP_RenderTarget,
	TEXTUREGROUP_MobileFlattened,
	TEXTUREGROUP_ProcBuilding_Face,
	TEXTUREGROUP_ProcBuilding_LightMap,
	TEXTUREGROUP_Shadowmap,
	TEXTUREGROUP_ColorLookupTable,
	TEXTUREGROUP_Terrain_Heightmap,
	TEXTUREGROUP_Terrain_Weightmap,
	TEXTUREGROUP_Bokeh,
	TEXTUREGROUP_IESLightProfile,
	TEXTUREGROUP_Pixels2D,
};
