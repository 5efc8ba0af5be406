// View extensions: code from outside that the renderer calls at fixed moments of a frame. Derive from
// FSceneViewExtensionBase, create with FSceneViewExtensions::NewExtension and keep the reference: letting go of it
// unregisters.
//
//     class FMyExtension : public FSceneViewExtensionBase
//     {
//     public:
//         FMyExtension(const FAutoRegister& AutoRegister) : FSceneViewExtensionBase(AutoRegister) {}
//         void SubscribeToPostProcessingPass(EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks,
//             bool bIsPassEnabled) override
//         {
//             if (Pass == EPostProcessingPass::Tonemap)
//             {
//                 Callbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FMyExtension::AddPasses));
//             }
//         }
//     };
//     TSharedPtr<FMyExtension, ESPMode::ThreadSafe> Extension = FSceneViewExtensions::NewExtension<FMyExtension>();
//
// The interface is a superset of engine 5.1 to 5.8: both signatures of what changed are virtual. The version that a
// plugin is compiled for (ENGINE_MINOR_VERSION) decides which one is called; the other is reported.
// Source: engine file SceneViewExtension.h.
#pragma once

#include "Camera/CameraTypes.h"
#include "CoreMinimal.h"
#include "Engine/Engine.h"
#include "Misc/EngineApi.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "RenderingThread.h"
#include "SceneTextureParameters.h"
#include "SceneView.h"
#include "SceneViewExtensionHooks.h"
#include "ScreenPass.h"

class APlayerController;
class FSceneViewExtensions;
class FViewport;
class ISceneRenderer;
class UWorld;
struct FMobilePostProcessingInputs;
struct FPostProcessMaterialInputs;
struct FPostProcessingInputs;

/** The wishes of an extension to the renderer. */
enum class ESceneViewExtensionFlags : uint32
{
	None = 0,
	SubscribesToPostTLASBuild = 1 << 0,
	RequiresHardwareInlineRayTracing = 1 << 1,
};
ENUM_CLASS_FLAGS(ESceneViewExtensionFlags)

/** The context that an extension is asked with whether it is active. */
class FSceneViewExtensionContext
{
public:
	FSceneViewExtensionContext() = default;
	explicit FSceneViewExtensionContext(FViewport* InViewport)
		: Viewport(InViewport)
	{
	}
	explicit FSceneViewExtensionContext(FSceneInterface* InScene)
		: Scene(InScene)
	{
	}
	virtual ~FSceneViewExtensionContext() = default;

	/** World of the scene; null without one. */
	virtual UWorld* GetWorld() const { return Scene != nullptr ? Scene->GetWorld() : nullptr; }
	bool IsHMDSupported() const { return false; }

	FViewport* Viewport = nullptr;
	FSceneInterface* Scene = nullptr;
	bool bStereoDisabled = false;
};

/** Asked before IsActiveThisFrame_Internal; the first functor with an answer decides. */
struct FSceneViewExtensionIsActiveFunctor
{
	TFunction<TOptional<bool>(const ISceneViewExtension*, const FSceneViewExtensionContext&)> IsActiveFunction;

	TOptional<bool> operator()(const ISceneViewExtension* Extension, const FSceneViewExtensionContext& Context) const
	{
		return IsActiveFunction ? IsActiveFunction(Extension, Context) : TOptional<bool>();
	}
};

/** Called after a post-processing pass. Returns the picture from then on: the input untouched, a new texture with its
 * rect, or, where Inputs.OverrideOutput is valid, that one, drawn to. */
using FPostProcessingPassDelegate =
	TDelegate<FScreenPassTexture(FRDGBuilder&, const FSceneView&, const FPostProcessMaterialInputs&)>;
using FPostProcessingPassDelegateArray = TArray<FPostProcessingPassDelegate>;
using FAfterPassCallbackDelegate = FPostProcessingPassDelegate;
using FAfterPassCallbackDelegateArray = FPostProcessingPassDelegateArray;

/** The hooks, in the order in which a frame calls them. All do nothing by default. */
class DRYDOCK_API ISceneViewExtension
{
public:
	/** The pass that a callback follows. Passes that the run's engine version does not have are never asked for;
	 * numbers differ between versions. */
	enum class EPostProcessingPass : uint32
	{
		BeforeDOF DRYDOCK_API_BeforeDOF,                       // 5.5
		AfterDOF DRYDOCK_API_AfterDOF,                         // 5.5
		TranslucencyAfterDOF DRYDOCK_API_TranslucencyAfterDOF, // 5.5
		SSRInput,                                              // 5.1
		ReplacingTonemapper DRYDOCK_API_ReplacingTonemapper,   // 5.5
		MotionBlur,
		Tonemap,
		FXAA,
		SMAA DRYDOCK_API_SMAA, // 5.7
		VisualizeDepthOfField,
		MAX
	};

	using FPostProcessingPassDelegate = ::FPostProcessingPassDelegate;
	using FPostProcessingPassDelegateArray = ::FPostProcessingPassDelegateArray;
	using FAfterPassCallbackDelegate = ::FPostProcessingPassDelegate;
	using FAfterPassCallbackDelegateArray = ::FPostProcessingPassDelegateArray;

	virtual ~ISceneViewExtension();

	// On the game thread ----------------------------------------------------------------------------------------------

	virtual void SetupViewFamily(FSceneViewFamily& InViewFamily);
	virtual void SetupViewPoint(APlayerController* Player, FMinimalViewInfo& InViewInfo);
	virtual void SetupViewProjectionMatrix(FSceneViewProjectionData& InOutProjectionData);
	virtual void SetupView(FSceneViewFamily& InViewFamily, FSceneView& InView);
	virtual void BeginRenderViewFamily(FSceneViewFamily& InViewFamily);
	/** From 5.7. Renderer is null: there is none to hand out, and the type is incomplete here. */
	virtual void PostCreateSceneRenderer(const FSceneViewFamily& InViewFamily, ISceneRenderer* Renderer);

	// On the render thread --------------------------------------------------------------------------------------------

	virtual void PreRenderViewFamily_RenderThread(FRDGBuilder& GraphBuilder, FSceneViewFamily& InViewFamily);
	virtual void PreRenderView_RenderThread(FRDGBuilder& GraphBuilder, FSceneView& InView);
	virtual void PreInitViews_RenderThread(FRDGBuilder& GraphBuilder);
	virtual void PreRenderBasePass_RenderThread(FRDGBuilder& GraphBuilder, bool bDepthBufferIsPopulated);
	virtual void PostRenderBasePassDeferred_RenderThread(FRDGBuilder& GraphBuilder, FSceneView& InView,
		const FRenderTargetBindingSlots& RenderTargets,
		TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures);
	/** Never called: the renderer here is the deferred one. So is the next but one. */
	virtual void PostRenderBasePassMobile_RenderThread(FRHICommandList& RHICmdList, FSceneView& InView);
	/** As up to 5.2. */
	virtual void PostRenderBasePassMobile_RenderThread(FRHICommandListImmediate& RHICmdList, FSceneView& InView);
	/** From 5.7, for those whose flags ask for it. Never called: there is no ray-tracing scene here. */
	virtual void PostTLASBuild_RenderThread(FRDGBuilder& GraphBuilder, FSceneView& InView);
	/** Scene colour may be edited in place. */
	virtual void PrePostProcessPass_RenderThread(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessingInputs& Inputs);
	virtual void PrePostProcessPassMobile_RenderThread(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FMobilePostProcessingInputs& Inputs);
	/** Called once for each pass and view. bIsPassEnabled is information: a callback of a disabled pass runs all the
	 * same, but what it returns after the last enabled pass is dropped. Up to 5.4. */
	virtual void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& InOutPassCallbacks, bool bIsPassEnabled);
	/** From 5.5. */
	virtual void SubscribeToPostProcessingPass(EPostProcessingPass Pass, const FSceneView& InView,
		FPostProcessingPassDelegateArray& InOutPassCallbacks, bool bIsPassEnabled);
	virtual void PostRenderView_RenderThread(FRDGBuilder& GraphBuilder, FSceneView& InView);
	virtual void PostRenderViewFamily_RenderThread(FRDGBuilder& GraphBuilder, FSceneViewFamily& InViewFamily);

	// Signatures of 5.0; no version here calls them.
	virtual void PreRenderViewFamily_RenderThread(FRHICommandListImmediate& RHICmdList, FSceneViewFamily& InViewFamily);
	virtual void PreRenderView_RenderThread(FRHICommandListImmediate& RHICmdList, FSceneView& InView);
	virtual void PostRenderBasePass_RenderThread(FRHICommandListImmediate& RHICmdList, FSceneView& InView);
	virtual void PostRenderView_RenderThread(FRHICommandListImmediate& RHICmdList, FSceneView& InView);
	virtual void PostRenderViewFamily_RenderThread(
		FRHICommandListImmediate& RHICmdList, FSceneViewFamily& InViewFamily);

	// Registration ----------------------------------------------------------------------------------------------------

	/** Higher is called first; equal ones in the order of registration. */
	virtual int32 GetPriority() const;
	/** From 5.7. Nothing that they ask for is here. */
	virtual ESceneViewExtensionFlags GetFlags() const;
	virtual bool IsActiveThisFrame(const FSceneViewExtensionContext& Context) const;
};

using FSceneViewExtensionRef = TSharedRef<ISceneViewExtension, ESPMode::ThreadSafe>;

/** Only the registry can make one: it is the proof that an extension was made by NewExtension. */
class FAutoRegister
{
	friend class FSceneViewExtensions;
	FAutoRegister() {}
};

/** The base of extensions. */
class DRYDOCK_API FSceneViewExtensionBase : public ISceneViewExtension,
											public TSharedFromThis<FSceneViewExtensionBase, ESPMode::ThreadSafe>
{
public:
	explicit FSceneViewExtensionBase(const FAutoRegister&);
	~FSceneViewExtensionBase() override;

	/** The functors in order, then IsActiveThisFrame_Internal. */
	bool IsActiveThisFrame(const FSceneViewExtensionContext& Context) const final;

	TArray<FSceneViewExtensionIsActiveFunctor> IsActiveThisFrameFunctions;

protected:
	virtual bool IsActiveThisFrame_Internal(const FSceneViewExtensionContext& Context) const;
};

/** Active where its world is rendered: unless a context names another one. */
class DRYDOCK_API FWorldSceneViewExtension : public FSceneViewExtensionBase
{
public:
	FWorldSceneViewExtension(const FAutoRegister& AutoRegister, UWorld* InWorld);

	UWorld* GetWorld() const { return World; }

protected:
	bool IsActiveThisFrame_Internal(const FSceneViewExtensionContext& Context) const override;

private:
	UWorld* World;
};

namespace Drydock
{

/** Calls the functions of overrides that not every engine version has, which the compiler reports by EngineApi.h. */
template<typename T>
struct TVersionedOverrides
{
	DRYDOCK_API_GetFlags static void GetFlags() {}
	DRYDOCK_API_PostCreateSceneRenderer static void PostCreateSceneRenderer() {}
	DRYDOCK_API_PostTLASBuild static void PostTLASBuild() {}
	DRYDOCK_API_PreRenderBasePass static void PreRenderBasePass() {}
	DRYDOCK_API_Subscribe static void Subscribe() {}
	DRYDOCK_API_SubscribeWithView static void SubscribeWithView() {}
};

template<typename T>
void CheckOverrides()
{
	using FPass = ISceneViewExtension::EPostProcessingPass;
	using FCallbacks = FPostProcessingPassDelegateArray;
	using FCheck = TVersionedOverrides<T>;
	if constexpr (requires {
					  requires !std::is_same_v<decltype(&T::GetFlags), decltype(&ISceneViewExtension::GetFlags)>;
				  })
	{
		FCheck::GetFlags();
	}
	if constexpr (DRYDOCK_HAS_HOOK(T, PostCreateSceneRenderer, const FSceneViewFamily&, ISceneRenderer*))
	{
		FCheck::PostCreateSceneRenderer();
	}
	if constexpr (DRYDOCK_HAS_HOOK(T, PostTLASBuild_RenderThread, FRDGBuilder&, FSceneView&))
	{
		FCheck::PostTLASBuild();
	}
	if constexpr (DRYDOCK_HAS_HOOK(T, PreRenderBasePass_RenderThread, FRDGBuilder&, bool))
	{
		FCheck::PreRenderBasePass();
	}
	if constexpr (DRYDOCK_HAS_HOOK(T, SubscribeToPostProcessingPass, FPass, FCallbacks&, bool))
	{
		FCheck::Subscribe();
	}
	if constexpr (DRYDOCK_HAS_HOOK(T, SubscribeToPostProcessingPass, FPass, const FSceneView&, FCallbacks&, bool))
	{
		FCheck::SubscribeWithView();
	}
}

template<typename T>
FExtensionInfo DescribeExtension(int32 EngineMinor)
{
	FExtensionInfo Info;
	Info.Name = GetTypeName(typeid(T));
	Info.EngineMinor = EngineMinor;
	const auto Note = [&Info](EExtensionHook Hook, bool bHas)
	{
		Info.Overrides |= bHas ? 1u << static_cast<uint32>(Hook) : 0u;
	};
	using enum EExtensionHook;
	using FPass = ISceneViewExtension::EPostProcessingPass;
	using FCallbacks = FPostProcessingPassDelegateArray;
	using FSceneTexturesRef = TRDGUniformBufferRef<FSceneTextureUniformParameters>;
	using FCommandList = FRHICommandListImmediate;
	Note(SetupViewFamily, DRYDOCK_HAS_HOOK(T, SetupViewFamily, FSceneViewFamily&));
	Note(SetupViewPoint, DRYDOCK_HAS_HOOK(T, SetupViewPoint, APlayerController*, FMinimalViewInfo&));
	Note(SetupViewProjectionMatrix, DRYDOCK_HAS_HOOK(T, SetupViewProjectionMatrix, FSceneViewProjectionData&));
	Note(SetupView, DRYDOCK_HAS_HOOK(T, SetupView, FSceneViewFamily&, FSceneView&));
	Note(BeginRenderViewFamily, DRYDOCK_HAS_HOOK(T, BeginRenderViewFamily, FSceneViewFamily&));
	Note(PostCreateSceneRenderer,
		DRYDOCK_HAS_HOOK(T, PostCreateSceneRenderer, const FSceneViewFamily&, ISceneRenderer*));
	Note(PreRenderViewFamily, DRYDOCK_HAS_HOOK(T, PreRenderViewFamily_RenderThread, FRDGBuilder&, FSceneViewFamily&));
	Note(PreRenderViewFamilyCommandList,
		DRYDOCK_HAS_HOOK(T, PreRenderViewFamily_RenderThread, FCommandList&, FSceneViewFamily&));
	Note(PreRenderView, DRYDOCK_HAS_HOOK(T, PreRenderView_RenderThread, FRDGBuilder&, FSceneView&));
	Note(PreRenderViewCommandList, DRYDOCK_HAS_HOOK(T, PreRenderView_RenderThread, FCommandList&, FSceneView&));
	Note(PreInitViews, DRYDOCK_HAS_HOOK(T, PreInitViews_RenderThread, FRDGBuilder&));
	Note(PreRenderBasePass, DRYDOCK_HAS_HOOK(T, PreRenderBasePass_RenderThread, FRDGBuilder&, bool));
	Note(PostRenderBasePassDeferred, DRYDOCK_HAS_HOOK(T, PostRenderBasePassDeferred_RenderThread, FRDGBuilder&,
										 FSceneView&, const FRenderTargetBindingSlots&, FSceneTexturesRef));
	Note(PostRenderBasePassMobile,
		DRYDOCK_HAS_HOOK(T, PostRenderBasePassMobile_RenderThread, FRHICommandList&, FSceneView&));
	Note(PostRenderBasePassMobileImmediate,
		DRYDOCK_HAS_HOOK(T, PostRenderBasePassMobile_RenderThread, FCommandList&, FSceneView&));
	Note(PostRenderBasePass, DRYDOCK_HAS_HOOK(T, PostRenderBasePass_RenderThread, FCommandList&, FSceneView&));
	Note(PostTLASBuild, DRYDOCK_HAS_HOOK(T, PostTLASBuild_RenderThread, FRDGBuilder&, FSceneView&));
	Note(PrePostProcessPass, DRYDOCK_HAS_HOOK(T, PrePostProcessPass_RenderThread, FRDGBuilder&, const FSceneView&,
								 const FPostProcessingInputs&));
	Note(PrePostProcessPassMobile, DRYDOCK_HAS_HOOK(T, PrePostProcessPassMobile_RenderThread, FRDGBuilder&,
									   const FSceneView&, const FMobilePostProcessingInputs&));
	Note(Subscribe, DRYDOCK_HAS_HOOK(T, SubscribeToPostProcessingPass, FPass, FCallbacks&, bool));
	Note(SubscribeWithView,
		DRYDOCK_HAS_HOOK(T, SubscribeToPostProcessingPass, FPass, const FSceneView&, FCallbacks&, bool));
	Note(PostRenderView, DRYDOCK_HAS_HOOK(T, PostRenderView_RenderThread, FRDGBuilder&, FSceneView&));
	Note(PostRenderViewCommandList, DRYDOCK_HAS_HOOK(T, PostRenderView_RenderThread, FCommandList&, FSceneView&));
	Note(PostRenderViewFamily, DRYDOCK_HAS_HOOK(T, PostRenderViewFamily_RenderThread, FRDGBuilder&, FSceneViewFamily&));
	Note(PostRenderViewFamilyCommandList,
		DRYDOCK_HAS_HOOK(T, PostRenderViewFamily_RenderThread, FCommandList&, FSceneViewFamily&));
	if constexpr (DRYDOCK_ENGINE_NAMES != 0)
	{
		CheckOverrides<T>();
	}
	return Info;
}

} // namespace Drydock

/** The registry; GEngine->ViewExtensions. It watches extensions and owns none. */
class DRYDOCK_API FSceneViewExtensions
{
public:
	/** Makes an extension and registers it for as long as a reference to it exists. */
	template<typename ExtensionType, typename... ArgumentTypes>
	static TSharedRef<ExtensionType, ESPMode::ThreadSafe> NewExtension(ArgumentTypes&&... Arguments)
	{
		const FAutoRegister AutoRegister;
		TSharedRef<ExtensionType, ESPMode::ThreadSafe> Extension =
			MakeShared<ExtensionType, ESPMode::ThreadSafe>(AutoRegister, Forward<ArgumentTypes>(Arguments)...);
		RegisterExtension(Extension, Drydock::DescribeExtension<ExtensionType>(ENGINE_MINOR_VERSION));
		return Extension;
	}

	/** The active ones in calling order: higher priority first, equal ones as they were registered. */
	TArray<TSharedRef<ISceneViewExtension, ESPMode::ThreadSafe>> GatherActiveExtensions(
		const FSceneViewExtensionContext& InContext) const;

	// Drydock's own -------------------------------------------------------------------------------------------------

	/** Null for an extension that NewExtension did not make. */
	const Drydock::FExtensionInfo* FindInfo(const ISceneViewExtension& Extension) const;

	/** Changes the result of FindInfo. */
	void SetInfo(const ISceneViewExtension& Extension, const Drydock::FExtensionInfo& Info);

	/** Number of the next registration; they only go up. */
	uint64 GetNextRegistration() const { return NextRegistration; }

	/** Notes that all registered since First belong to a plugin. Returns how many these are. */
	int32 MarkPlugin(const std::string& Plugin, uint64 First);

	/** Names of the extensions that a plugin registered, by its file, in their order. */
	std::vector<std::string> GetNamesOfPlugin(const std::string& Plugin) const;

	/** Forgets a plugin's extensions, before its library goes away. */
	void ForgetPlugin(const std::string& Plugin);

private:
	struct FEntry
	{
		TWeakPtr<ISceneViewExtension, ESPMode::ThreadSafe> Extension;
		const ISceneViewExtension* Address = nullptr;
		uint64 Registration = 0;
		Drydock::FExtensionInfo Info;
	};

	static void RegisterExtension(
		const TSharedRef<ISceneViewExtension, ESPMode::ThreadSafe>& Extension, Drydock::FExtensionInfo Info);
	FEntry* FindEntry(const ISceneViewExtension& Extension);

	TArray<FEntry> Entries;
	uint64 NextRegistration = 0;
};

#include "PostProcess/PostProcessInputs.h"
#include "PostProcess/PostProcessMaterialInputs.h"
