// The uniform buffer of a view. Source: engine file SceneRendering.cpp.
#include "SceneRendering.h"

#include "HAL/IConsoleManager.h"
#include "RHIStaticStates.h"

namespace
{

TAutoConsoleVariable<int32> CVarPreferCompute(TEXT("r.PostProcessing.PreferCompute"), 0,
	TEXT("1: post-processing uses compute shaders where a pass has one. Default 0, pixel shaders."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarTemporalAASamples(TEXT("r.TemporalAASamples"), 8,
	TEXT("Number of jitter samples, 1 to 255, that shaders read as View.TemporalAAParams.y; 8 by default. A scene's "
		 "frames bring their own jitter."),
	ECVF_RenderThreadSafe);

} // namespace

FViewInfo::FViewInfo()
{
	bIsViewInfo = true;
	bUseComputePasses = CVarPreferCompute.GetValueOnRenderThread() != 0;
	ShaderMap = GetGlobalShaderMap(GMaxRHIFeatureLevel);
}

FViewInfo::FViewInfo(
	const FSceneViewFamily* InFamily, const FIntRect& Rect, FIntPoint BufferExtent, float InPreExposure)
	: FViewInfo()
{
	Family = InFamily;
	ViewRect = Rect;
	UnscaledViewRect = Rect;
	UnconstrainedViewRect = Rect;
	PreExposure = InPreExposure;
	InitViewUniformBuffer(BufferExtent);
}

void FViewInfo::InitViewUniformBuffer(FIntPoint BufferExtent)
{
	check(PreExposure > 0.0f);
	FViewUniformShaderParameters Parameters = UniformParameters;

	const FVector2f Min(static_cast<float>(ViewRect.Min.X), static_cast<float>(ViewRect.Min.Y));
	const FVector2f Size(static_cast<float>(ViewRect.Width()), static_cast<float>(ViewRect.Height()));
	const FVector2f Extent(static_cast<float>(BufferExtent.X), static_cast<float>(BufferExtent.Y));

	Parameters.ViewRectMin = FVector4f(Min.X, Min.Y, 0.0f, 0.0f);
	Parameters.ViewSizeAndInvSize = FVector4f(Size.X, Size.Y, 1.0f / Size.X, 1.0f / Size.Y);
	Parameters.ViewRectMinAndSize = FUintVector4(ViewRect.Min.X, ViewRect.Min.Y, ViewRect.Width(), ViewRect.Height());
	Parameters.BufferSizeAndInvSize = FVector4f(Extent.X, Extent.Y, 1.0f / Extent.X, 1.0f / Extent.Y);
	Parameters.BufferBilinearUVMinMax = FVector4f((Min.X + 0.5f) / Extent.X, (Min.Y + 0.5f) / Extent.Y,
		(Min.X + Size.X - 0.5f) / Extent.X, (Min.Y + Size.Y - 0.5f) / Extent.Y);

	// Screen position (-1..1, y up) to buffer UV: x by scale.x and bias.w, y by scale.y and bias.z.
	Parameters.ScreenPositionScaleBias = FVector4f(0.5f * Size.X / Extent.X, -0.5f * Size.Y / Extent.Y,
		(0.5f * Size.Y + Min.Y) / Extent.Y, (0.5f * Size.X + Min.X) / Extent.X);

	Parameters.TemporalAAJitter = FVector4f(
		FVector2f(ViewMatrices.GetTemporalAAJitter()), FVector2f(PrevViewInfo.ViewMatrices.GetTemporalAAJitter()));
	const uint32 NumSamples =
		TemporalJitterPixels == FVector2D(0.0, 0.0)
			? 1u
			: static_cast<uint32>(FMath::Clamp(CVarTemporalAASamples.GetValueOnAnyThread(), 1, 255));
	Parameters.TemporalAAParams =
		FVector4f(static_cast<float>(Parameters.StateFrameIndex % NumSamples), static_cast<float>(NumSamples),
			static_cast<float>(TemporalJitterPixels.X), static_cast<float>(TemporalJitterPixels.Y));
	Parameters.MaterialTextureDerivativeMultiply = 1.0f;
	Parameters.CullingSign = 1.0f;
	Parameters.CameraCut = bCameraCut ? 1.0f : 0.0f;
	Parameters.PrevFrameGameTime = Parameters.GameTime - Parameters.DeltaTime;
	Parameters.PrevGameTime = Parameters.PrevFrameGameTime;
	Parameters.PrevFrameRealTime = Parameters.RealTime - Parameters.DeltaTime;
	Parameters.Random = Parameters.StateFrameIndex * 747796405u + 2891336453u; // one step of a congruential generator

	Parameters.PreExposure = PreExposure;
	Parameters.OneOverPreExposure = 1.0f / PreExposure;

	Parameters.SharedPointWrappedSampler = TStaticSamplerState<SF_Point, AM_Wrap, AM_Wrap, AM_Wrap>::GetRHI();
	Parameters.SharedPointClampedSampler = TStaticSamplerState<SF_Point, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	Parameters.SharedBilinearWrappedSampler = TStaticSamplerState<SF_Bilinear, AM_Wrap, AM_Wrap, AM_Wrap>::GetRHI();
	Parameters.SharedBilinearClampedSampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	Parameters.SharedTrilinearWrappedSampler = TStaticSamplerState<SF_Trilinear, AM_Wrap, AM_Wrap, AM_Wrap>::GetRHI();
	Parameters.SharedTrilinearClampedSampler =
		TStaticSamplerState<SF_Trilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();

	CachedViewUniformShaderParameters = MakeShared<FViewUniformShaderParameters>(Parameters);
	ViewUniformBuffer = TUniformBufferRef<FViewUniformShaderParameters>::CreateUniformBufferImmediate(
		Parameters, UniformBuffer_SingleFrame);
}
