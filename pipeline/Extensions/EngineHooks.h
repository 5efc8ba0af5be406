// Lists the hooks and insertion points of each engine version: one table of hook signatures, one of insertion points. A
// config's `engine` chooses the version of a run; a plugin's ENGINE_MINOR_VERSION which hooks it gets. Source: public
// plugins that are written for several versions.
#pragma once

#include "EngineProfile.h"
#include "SceneViewExtension.h"

#include <string>
#include <vector>

namespace Drydock
{

/** A hook's signature and the versions 5.First to 5.Last that call it; First above Last: none does. */
struct FHookVersions
{
	EExtensionHook Hook;
	std::string Signature;
	int32 First;
	int32 Last;
	std::string Instead;   // what those versions call that do not call this; empty: overriding it is not a mistake
	std::string NeverHere; // why drydock never calls it, whatever the version; goes on after "which "; empty: it may
};

/** By EExtensionHook. */
DRYDOCK_API const std::vector<FHookVersions>& GetHookVersions();

DRYDOCK_API const FHookVersions& GetHookVersions(EExtensionHook Hook);

/** "SetupView": without its arguments and the suffix of its thread. */
DRYDOCK_API std::string GetHookName(EExtensionHook Hook);

/** EngineMinor: one of EngineProfile.h. */
DRYDOCK_API bool IsHookCalled(EExtensionHook Hook, int32 EngineMinor);

enum class EColorSpace : uint8
{
	LinearHDR,      // scene-linear, multiplied by View.PreExposure
	DisplayEncoded, // after the tonemapper: sRGB
};

/** "linear HDR, pre-exposed", "display-encoded". */
DRYDOCK_API const char* ToString(EColorSpace Space);

/** An insertion point, what it sees and since when there is one. */
struct FInsertionPoint
{
	ISceneViewExtension::EPostProcessingPass Pass;
	EColorSpace Space;
	int32 First; // engine 5.First
	const char* Doc;
};

/** In the order of a frame. */
DRYDOCK_API const std::vector<FInsertionPoint>& GetInsertionPoints();

DRYDOCK_API const FInsertionPoint& GetInsertionPoint(ISceneViewExtension::EPostProcessingPass Pass);

/** EngineMinor: as of IsHookCalled. */
DRYDOCK_API bool HasInsertionPoint(ISceneViewExtension::EPostProcessingPass Pass, int32 EngineMinor);

/** 4 to "5.4". */
DRYDOCK_API std::string GetEngineVersionText(int32 EngineMinor);

} // namespace Drydock
