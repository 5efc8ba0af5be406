// Calls the hooks of the active view extensions, in the engine's order, and records the result of each call. The order
// is the engine's.
#pragma once

#include "Extensions/EngineHooks.h"
#include "Extensions/HookLog.h"
#include "FinalPostProcessSettings.h"
#include "RenderGraphCompiled.h"
#include "SceneRendering.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** A view of the frame and what messages call it. */
struct FNamedView
{
	FViewInfo* View = nullptr;
	std::string Name;
};

/** A subscribed callback and whose it is. */
struct FPassCallback
{
	FPostProcessingPassDelegate Delegate;
	std::string Extension;
	FCodeOwner Owner = {};
};

/** The extensions of one frame. Made for a frame and gone with it. */
class DRYDOCK_API FViewExtensionFrame
{
public:
	FViewExtensionFrame(const FEngineProfile& InEngine, FHookLog& InLog);

	const FEngineProfile& GetEngine() const { return Engine; }
	FHookLog& GetLog() { return Log; }

	/** Plugins: those whose extensions take part; empty optional: all. Gathers the active extensions into
	 * Family.ViewExtensions, which holds them for the frame, and reports those that the engine version does not suit.
	 */
	void Gather(FSceneViewFamily& Family, const std::optional<std::vector<std::string>>& Plugins);
	bool IsEmpty() const { return Extensions.empty(); }
	/** Names of all active extensions: the class without namespaces; an extension of a config bears the name of its
	 * type. */
	std::vector<std::string> GetNames() const;

	// Game thread, in this order; the three in the middle view by view.
	void SetupViewFamily(FSceneViewFamily& Family);
	void SetupViewPoint(const std::string& ViewName, FMinimalViewInfo& ViewInfo);
	void SetupViewProjectionMatrix(const std::string& ViewName, FSceneViewProjectionData& ProjectionData);
	/** The settings that extensions change are appended to Gates, and recorded in Ledger unless that is null. */
	void SetupView(FSceneViewFamily& Family, const FNamedView& View, std::vector<FSettingGate>& Gates,
		FBlendLedger* Ledger = nullptr);
	void BeginRenderViewFamily(FSceneViewFamily& Family);
	void PostCreateSceneRenderer(const FSceneViewFamily& Family);

	// Render thread, in this order. Each extension has its family hook called and then those of its views.
	void PreRender(FRDGBuilder& GraphBuilder, FSceneViewFamily& Family, const std::vector<FNamedView>& Views);
	void PreInitViews(FRDGBuilder& GraphBuilder);
	void PreRenderBasePass(FRDGBuilder& GraphBuilder);
	void PostRenderBasePass(FRDGBuilder& GraphBuilder, const std::vector<FNamedView>& Views,
		const FRenderTargetBindingSlots& RenderTargets,
		TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures);
	void PrePostProcess(
		FRDGBuilder& GraphBuilder, const std::vector<FNamedView>& Views, const FPostProcessingInputs& Inputs);
	/** The callbacks that extensions subscribe to one point, in calling order. */
	std::vector<FPassCallback> Subscribe(
		ISceneViewExtension::EPostProcessingPass Pass, const FNamedView& View, bool bIsPassEnabled);
	void PostRender(FRDGBuilder& GraphBuilder, FSceneViewFamily& Family, const std::vector<FNamedView>& Views);

	/** Completes the log with the passes that each call added. */
	void Finish(const FRDGCompiledGraph& Graph);

private:
	struct FExtension
	{
		TSharedRef<ISceneViewExtension, ESPMode::ThreadSafe> Extension;
		FExtensionInfo Info;
		std::string Label;
		int32 EngineMinor; // that decides which hooks it gets
	};

	void ReportVersion(const FExtension& Extension);
	void ReportIdlePlugins();
	template<typename TFunction>
	void Call(FExtension& Extension, EExtensionHook Hook, const std::string& ViewName, TFunction Function);
	template<typename TFunction>
	void CallInGraph(FRDGBuilder& GraphBuilder, FExtension& Extension, EExtensionHook Hook, const std::string& ViewName,
		TFunction Function);

	FEngineProfile Engine;
	FHookLog& Log;
	std::vector<FExtension> Extensions;
	std::vector<std::string> Plugins; // that the frame was given
};

/** A warning or error about an extension. */
FDiagnostic MakeExtensionDiagnostic(
	ESeverity Severity, int Code, const std::string& Extension, const std::string& Message);

} // namespace Drydock
