// Extent of the scene textures and the parts of them a pass asks for. Source: engine file SceneTexturesConfig.h.
#pragma once

#include "CoreMinimal.h"

/** The scene textures that a uniform buffer holds; the others point to black dummies. */
enum class ESceneTextureSetupMode : uint32
{
	None = 0,
	SceneColor = 1 << 0,
	SceneDepth = 1 << 1,
	SceneVelocity = 1 << 2,
	GBufferA = 1 << 3,
	GBufferB = 1 << 4,
	GBufferC = 1 << 5,
	GBufferD = 1 << 6,
	GBufferE = 1 << 7,
	GBufferF = 1 << 8,
	SSAO = 1 << 9,
	CustomDepth = 1 << 10,
	GBuffers = GBufferA | GBufferB | GBufferC | GBufferD | GBufferE | GBufferF,
	All = SceneColor | SceneDepth | SceneVelocity | GBuffers | SSAO | CustomDepth,
};
ENUM_CLASS_FLAGS(ESceneTextureSetupMode);

struct FSceneTexturesConfig
{
	FIntPoint Extent = FIntPoint(0, 0);
};
