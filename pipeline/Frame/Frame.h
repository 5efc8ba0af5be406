// One frame: the views of a family, their extensions' hooks, the graph and the pictures, in the engine's order. It
// knows no config: RunConfig and RenderFrame both come here. The order is the engine's.
#pragma once

#include "Effects/Effect.h"
#include "Effects/ExposureReport.h"
#include "EngineProfile.h"
#include "Extensions/HookLog.h"
#include "Picture/Picture.h"
#include "RenderGraphCompiled.h"
#include "SceneFile/SceneCamera.h"
#include "SceneTextures.h"
#include "SceneViewExtension.h"
#include "SceneViewState.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

class IRDGObserver;

struct FFrameView
{
	std::string Name;   // for reports; empty where there is only one view
	FIntRect Rect;      // of the output, and of the scene textures where SceneRect is empty
	FIntRect SceneRect; // of the scene textures, at another resolution than the output
	FMinimalViewInfo Camera;
	/** The camera's projection; Camera holds its place and, once an extension has changed it, its field of view.
	 * */
	FSceneCamera Lens;
	FIntRect PictureRect; // what the lens sees, in the scene textures; empty: the view's own Rect
	float PreExposure = 1.0f;
	FViewSettings Settings;
	/** Keeps caches from frame to frame; null: each frame makes its own. State that changes pictures is passed by
	 * ViewStates. */
	std::shared_ptr<FSceneViewState> State;
	/** Settings for another camera, asked for when an extension moves it; empty: Settings hold everywhere. */
	std::function<FViewSettings(const FMinimalViewInfo&)> MakeSettings;
};

struct FFrameInputs
{
	FEngineProfile Engine = GetDefaultEngineProfile();
	FIntPoint Extent = FIntPoint(0, 0);       // of the scene textures
	FIntPoint OutputExtent = FIntPoint(0, 0); // 0: the same
	FEngineShowFlags ShowFlags;
	FLinearColor LightColor = FLinearColor(1.0f, 1.0f, 1.0f, 1.0f); // of the main light, relative
	uint32 FrameNumber = 0;
	FGameTime Time;
	std::vector<FFrameView> Views; // one at least
	/** The state that the frame before left, view by view; empty before the first frame. */
	std::vector<FViewHistory> ViewStates;
	/** Files of the plugins whose extensions take part; empty optional: all. Extensions of no plugin always do. */
	std::optional<std::vector<std::string>> Plugins;
	/** Registers the scene's textures in the frame's graph. */
	std::function<FSceneTextures(FRDGBuilder&)> RegisterSceneTextures;
	/** Looks at the scene's content for a view, ViewRect in the scene textures. Empty: settings alone decide what runs;
	 * so they do where view extensions take part, which may change what the scene textures hold. */
	std::function<FViewContent(const FIntRect& ViewRect, const FContentQuestions& Questions)> MeasureContent;
	IRDGObserver* Observer = nullptr;
	bool bExecute = true; // false: the graph is compiled only
	/** Keeps the textures that active effects are measured on (FEffect::Measured). */
	bool bKeepMeasured = false;
};

struct FFrameViewResult
{
	std::string Name;
	FIntRect Rect;
	FFinalPostProcessSettings Settings; // as the passes saw them
	float ExposureScale = 1.0f;         // of an automatic exposure the metered one, once the frame has run
	float PreExposure = 1.0f;
	std::vector<FEffectDecision> Effects;
	std::map<std::string, FKeptTexture> Kept; // of an executed frame, where bKeepMeasured asked for it
	std::optional<FExposureReport> Exposure;  // of an executed frame whose exposure is automatic
};

struct FFrameResult
{
	std::vector<FFrameViewResult> Views;
	FIntRect Rect; // of all views
	FHookLog Log;
	double Milliseconds = 0.0; // from the first hook to the end of the graph

	// Only of an executed frame.
	std::vector<FViewHistory> ViewStates; // for the next frame
	FPicture SceneLinear;                 // RGBA: the tonemapper's input, of all SceneRects; black where no view is
	FPicture Final;                       // of all Rects; black where no view is

	// Only of one that was not.
	FRDGCompiledGraph Graph;
};

/** Throws FError for mistakes of the graph, and of extensions with r.RDG.Validation 2. Not for two threads at once. */
DRYDOCK_API FFrameResult RenderViewFamily(const FFrameInputs& Inputs);

} // namespace Drydock
