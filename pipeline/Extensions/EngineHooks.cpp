// The tables of hooks and insertion points, and what is asked of them.
#include "Extensions/EngineHooks.h"

#include <algorithm>

namespace Drydock
{

const std::vector<FHookVersions>& GetHookVersions()
{
	using enum EExtensionHook;
	const int32 Oldest = GetEngineProfiles().front().Minor;
	const int32 Newest = GetEngineProfiles().back().Minor;
	constexpr int32 Never = 0;
	const char* const Mobile = "is the mobile renderer's: the deferred one never calls it";
	const char* const RayTracing =
		"follows the building of a ray-tracing scene, which there is none of here: it is never called";
	// clang-format off
	static const std::vector<FHookVersions> Versions = {
		{SetupViewFamily, "SetupViewFamily(FSceneViewFamily&)", Oldest, Newest, ""},
		{SetupViewPoint, "SetupViewPoint(APlayerController*, FMinimalViewInfo&)", Oldest, Newest, ""},
		{SetupViewProjectionMatrix, "SetupViewProjectionMatrix(FSceneViewProjectionData&)", Oldest, Newest, ""},
		{SetupView, "SetupView(FSceneViewFamily&, FSceneView&)", Oldest, Newest, ""},
		{BeginRenderViewFamily, "BeginRenderViewFamily(FSceneViewFamily&)", Oldest, Newest, ""},
		{PostCreateSceneRenderer, "PostCreateSceneRenderer(const FSceneViewFamily&, ISceneRenderer*)", 7, Newest, ""},
		{PreRenderViewFamily, "PreRenderViewFamily_RenderThread(FRDGBuilder&, FSceneViewFamily&)", Oldest, Newest, ""},
		{PreRenderViewFamilyCommandList, "PreRenderViewFamily_RenderThread(FRHICommandListImmediate&, FSceneViewFamily&)", Oldest, Never, "PreRenderViewFamily_RenderThread(FRDGBuilder&, FSceneViewFamily&)"},
		{PreRenderView, "PreRenderView_RenderThread(FRDGBuilder&, FSceneView&)", Oldest, Newest, ""},
		{PreRenderViewCommandList, "PreRenderView_RenderThread(FRHICommandListImmediate&, FSceneView&)", Oldest, Never, "PreRenderView_RenderThread(FRDGBuilder&, FSceneView&)"},
		{PreInitViews, "PreInitViews_RenderThread(FRDGBuilder&)", Oldest, Newest, ""},
		{PreRenderBasePass, "PreRenderBasePass_RenderThread(FRDGBuilder&, bool)", 4, Newest, "PreInitViews_RenderThread(FRDGBuilder&)"},
		{PostRenderBasePassDeferred, "PostRenderBasePassDeferred_RenderThread(FRDGBuilder&, FSceneView&, const FRenderTargetBindingSlots&, TRDGUniformBufferRef<FSceneTextureUniformParameters>)", Oldest, Newest, ""},
		{PostRenderBasePassMobile, "PostRenderBasePassMobile_RenderThread(FRHICommandList&, FSceneView&)", Oldest, Never, "PostRenderBasePassDeferred_RenderThread(FRDGBuilder&, FSceneView&, const FRenderTargetBindingSlots&, TRDGUniformBufferRef<FSceneTextureUniformParameters>)", Mobile},
		{PostRenderBasePassMobileImmediate, "PostRenderBasePassMobile_RenderThread(FRHICommandListImmediate&, FSceneView&)", Oldest, Never, "PostRenderBasePassDeferred_RenderThread(FRDGBuilder&, FSceneView&, const FRenderTargetBindingSlots&, TRDGUniformBufferRef<FSceneTextureUniformParameters>)", Mobile},
		{PostRenderBasePass, "PostRenderBasePass_RenderThread(FRHICommandListImmediate&, FSceneView&)", Oldest, Never, "PostRenderBasePassDeferred_RenderThread(FRDGBuilder&, FSceneView&, const FRenderTargetBindingSlots&, TRDGUniformBufferRef<FSceneTextureUniformParameters>)"},
		{PostTLASBuild, "PostTLASBuild_RenderThread(FRDGBuilder&, FSceneView&)", 7, Never, "", RayTracing},
		{PrePostProcessPass, "PrePostProcessPass_RenderThread(FRDGBuilder&, const FSceneView&, const FPostProcessingInputs&)", Oldest, Newest, ""},
		{PrePostProcessPassMobile, "PrePostProcessPassMobile_RenderThread(FRDGBuilder&, const FSceneView&, const FMobilePostProcessingInputs&)", Oldest, Never, "PrePostProcessPass_RenderThread(FRDGBuilder&, const FSceneView&, const FPostProcessingInputs&)", Mobile},
		{Subscribe, "SubscribeToPostProcessingPass(EPostProcessingPass, FAfterPassCallbackDelegateArray&, bool)", Oldest, 4, "SubscribeToPostProcessingPass(EPostProcessingPass, const FSceneView&, FPostProcessingPassDelegateArray&, bool)"},
		{SubscribeWithView, "SubscribeToPostProcessingPass(EPostProcessingPass, const FSceneView&, FPostProcessingPassDelegateArray&, bool)", 5, Newest, "SubscribeToPostProcessingPass(EPostProcessingPass, FAfterPassCallbackDelegateArray&, bool)"},
		{PostRenderView, "PostRenderView_RenderThread(FRDGBuilder&, FSceneView&)", Oldest, Newest, ""},
		{PostRenderViewCommandList, "PostRenderView_RenderThread(FRHICommandListImmediate&, FSceneView&)", Oldest, Never, "PostRenderView_RenderThread(FRDGBuilder&, FSceneView&)"},
		{PostRenderViewFamily, "PostRenderViewFamily_RenderThread(FRDGBuilder&, FSceneViewFamily&)", Oldest, Newest, ""},
		{PostRenderViewFamilyCommandList, "PostRenderViewFamily_RenderThread(FRHICommandListImmediate&, FSceneViewFamily&)", Oldest, Never, "PostRenderViewFamily_RenderThread(FRDGBuilder&, FSceneViewFamily&)"},
	};
	// clang-format on
	return Versions;
}

const FHookVersions& GetHookVersions(EExtensionHook Hook)
{
	const FHookVersions& Versions = GetHookVersions()[static_cast<size_t>(Hook)];
	check(Versions.Hook == Hook);
	return Versions;
}

std::string GetHookName(EExtensionHook Hook)
{
	const std::string Signature = GetHookVersions(Hook).Signature;
	const std::string Name = Signature.substr(0, Signature.find('('));
	return Name.substr(0, Name.find("_RenderThread"));
}

bool IsHookCalled(EExtensionHook Hook, int32 EngineMinor)
{
	const FHookVersions& Versions = GetHookVersions(Hook);
	return EngineMinor >= Versions.First && EngineMinor <= Versions.Last;
}

const char* ToString(EColorSpace Space)
{
	return Space == EColorSpace::LinearHDR ? "linear HDR, pre-exposed" : "display-encoded";
}

const std::vector<FInsertionPoint>& GetInsertionPoints()
{
	using enum ISceneViewExtension::EPostProcessingPass;
	constexpr EColorSpace Linear = EColorSpace::LinearHDR;
	constexpr EColorSpace Display = EColorSpace::DisplayEncoded;
	// clang-format off
	static const std::vector<FInsertionPoint> Points = {
		{BeforeDOF, Linear, 5, "before depth of field"},
		{AfterDOF, Linear, 5, "after depth of field"},
		{TranslucencyAfterDOF, Linear, 5, "the separate translucency, alpha = transmittance"},
		{SSRInput, Linear, 1, "what the next frame's screen-space reflections read; the picture goes on unmodified"},
		{MotionBlur, Linear, 1, "after motion blur; exposure and bloom see the result"},
		{ReplacingTonemapper, Linear, 5, "in place of the tonemapper: reads colour and bloom, writes display-encoded"},
		{Tonemap, Display, 1, "after the tonemapper"},
		{FXAA, Display, 1, "after antialiasing"},
		{SMAA, Display, 7, "after the antialiasing of that name, which is not simulated: the pass is never enabled"},
		{VisualizeDepthOfField, Display, 1, "the last one"},
	};
	// clang-format on
	return Points;
}

const FInsertionPoint& GetInsertionPoint(ISceneViewExtension::EPostProcessingPass Pass)
{
	const std::vector<FInsertionPoint>& Points = GetInsertionPoints();
	const auto Found =
		std::find_if(Points.begin(), Points.end(), [&](const FInsertionPoint& Point) { return Point.Pass == Pass; });
	check(Found != Points.end());
	return *Found;
}

bool HasInsertionPoint(ISceneViewExtension::EPostProcessingPass Pass, int32 EngineMinor)
{
	return EngineMinor >= GetInsertionPoint(Pass).First;
}

std::string GetEngineVersionText(int32 EngineMinor)
{
	return FEngineProfile{.Minor = EngineMinor}.GetVersion();
}

} // namespace Drydock
