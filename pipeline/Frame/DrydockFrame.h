// The one entry of drydock's own for code from outside: one frame through all hooks of the registered view extensions
// and the post-processing chain at default settings, from pixels to pixels.
#pragma once

#include "CoreMinimal.h"
#include "Runtime/Launch/Resources/Version.h"

namespace Drydock
{

struct FFrameDesc
{
	FIntPoint Extent = FIntPoint(0, 0); // of the scene textures, above 0
	FIntRect ViewRect;                  // empty: all of them
	/** Row-major, Extent.X * Extent.Y; linear, pre-exposure 1. */
	TArray<FLinearColor> SceneColor;
	/** Row-major, 0 to 15 (SHADINGMODELID_*); may be empty. Goes to GBufferB's alpha. */
	TArray<uint8> ShadingModelID;
	/** Show flags by name, "Bloom"; others are as in a game. */
	TMap<FString, bool> ShowFlags;
	/** Version of engine 5 whose hooks are called; that of the code which fills this in. */
	int32 EngineMinorVersion = ENGINE_MINOR_VERSION;
};

struct FFrameOutput
{
	FIntPoint Extent = FIntPoint(0, 0); // size of the view's rect
	TArray<FLinearColor> Color;         // row-major, display-encoded
};

/** Calls every hook of every active extension, once, for one view. Needs no initialisation. Mistakes of extensions are
 * printed on stderr. Throws FError: a description that makes no sense, mistakes of the graph, and of extensions with
 * r.RDG.Validation 2. Not for two threads at once. */
DRYDOCK_API FFrameOutput RenderFrame(const FFrameDesc& Desc);

} // namespace Drydock
