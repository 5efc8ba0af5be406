// The scene textures of one frame, as graph resources. A null one is absent. Source: engine file SceneTextures.h.
#pragma once

#include "CoreMinimal.h"
#include "RenderGraphUtils.h"
#include "SceneTexturesConfig.h"

#include <map>
#include <string>

struct FSceneTextures
{
	FSceneTexturesConfig Config;

	FRDGTextureMSAA Color;
	FRDGTextureMSAA Depth; // reversed device depth: near 1, far 0
	FRDGTextureRef Velocity = nullptr;
	FRDGTextureRef GBufferA = nullptr;
	FRDGTextureRef GBufferB = nullptr;
	FRDGTextureRef GBufferC = nullptr;
	FRDGTextureRef GBufferD = nullptr;
	FRDGTextureRef GBufferE = nullptr;
	FRDGTextureRef GBufferF = nullptr;
	FRDGTextureRef ScreenSpaceAO = nullptr;
	FRDGTextureRef CustomDepth = nullptr;
	FRDGTextureSRVRef CustomStencil = nullptr;
	/** drydock: what CustomStencil views, PF_R8G8_UINT with the value in green, where the engine's shaders look for it.
	 * The engine has it as a plane of CustomDepth. */
	FRDGTextureRef CustomStencilTexture = nullptr;
	/** drydock: R projected shadow of the main light, G the character's self shadow, 1 = lit; 8 bit. */
	FRDGTextureRef ToonShadow = nullptr;
	/** drydock: what is composed over the picture after depth of field: premultiplied radiance, pre-exposed, and in
	 * alpha the transmittance of what lies behind. The engine keeps it in FTranslucencyPassResources. */
	FRDGTextureRef SeparateTranslucency = nullptr;
	/** drydock: channels of the scene file that the config names as textures (scene.textures), as they stand, by name. A
	 * patch of the engine would add a member for each. */
	std::map<std::string, FRDGTextureRef> Named;

	/** The texture of Named; null where there is none. */
	FRDGTextureRef FindNamed(const TCHAR* Name) const
	{
		const auto Found = Named.find(Name);
		return Found != Named.end() ? Found->second : nullptr;
	}
};
