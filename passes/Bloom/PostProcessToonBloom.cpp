// The passes that mask toon pixels for their own bloom strength, or show them.
#include "Bloom/PostProcessToonBloom.h"

#include "HAL/IConsoleManager.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "SceneRendering.h"
#include "Screen/RasterTarget.h"
#include "Screen/ScreenShaderPass.h"
#include "ShaderParameterStruct.h"

namespace Drydock
{

namespace
{

TAutoConsoleVariable<int32> CVarToonBloom(TEXT("r.ToonBloom"), -1,
	TEXT("Own bloom strength of toon pixels. -1: where a volume, the camera or --pp names BloomToonIntensity and it is "
		 "not 1, or r.DefaultFeature.Bloom made it 0 (default); 0: never; 1: always."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarToonBloomAsPrinted(TEXT("r.ToonBloom.AsPrinted"), 0,
	TEXT("1: as the article prints it: one shading model id for each half-resolution pixel, pixel shaders only. 0: "
		 "masked at full resolution (default)."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarToonBloomVisualizeMask(TEXT("r.ToonBloom.VisualizeMask"), 0,
	TEXT("1: shows toon pixels in magenta over the dimmed scene, without bloom. Default 0."), ECVF_RenderThreadSafe);

BEGIN_SHADER_PARAMETER_STRUCT(FToonBloomParameters, )
	SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
	SHADER_PARAMETER_RDG_UNIFORM_BUFFER(FSceneTextureUniformParameters, SceneTextures)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Input)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
	SHADER_PARAMETER_SAMPLER(SamplerState, InputSampler)
	SHADER_PARAMETER(float, ToonIntensity)
END_SHADER_PARAMETER_STRUCT()

class FToonVisualizeDimension : SHADER_PERMUTATION_BOOL("VISUALIZE");

using FToonBloomPermutation = TShaderPermutationDomain<FToonVisualizeDimension>;

DRYDOCK_SCREEN_SHADERS(FToonBloom, FToonBloomParameters, FToonBloomPermutation, OutComputeTexture);

IMPLEMENT_GLOBAL_SHADER(FToonBloomPS, "/Drydock/Private/PostProcessToonBloom.usf", "MainPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FToonBloomCS, "/Drydock/Private/PostProcessToonBloom.usf", "MainCS", SF_Compute);

struct FToonPassNames
{
	const TCHAR* Pass;
	const TCHAR* Output;
};

FScreenPassTexture AddToonPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FToonBloomInputs& Inputs,
	bool bVisualize, const FToonPassNames& Names, const std::optional<FIntRect>& DrawRect = {})
{
	check(Inputs.SceneColor.IsValid());
	check(Inputs.SceneTextures);
	const Drydock::FRDGEffectScope EffectScope(GraphBuilder, "ToonBloom");
	const bool bCompute = View.bUseComputePasses;
	const FScreenPassRenderTarget Output = CreateScreenTarget(
		GraphBuilder, Inputs.SceneColor.Texture->Desc, Inputs.SceneColor.ViewRect, Names.Output, bCompute);

	FToonBloomParameters Common;
	Common.View = View.ViewUniformBuffer;
	Common.SceneTextures = Inputs.SceneTextures;
	Common.Input = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Inputs.SceneColor));
	Common.Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	Common.InputTexture = Inputs.SceneColor.Texture;
	Common.InputSampler = TStaticSamplerState<SF_Point, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	Common.ToonIntensity = Inputs.ToonIntensity;

	TShaderPermutationDomain<FToonVisualizeDimension> Permutation;
	Permutation.Set<FToonVisualizeDimension>(bVisualize);
	const FIntPoint Size = DrawRect.value_or(Output.ViewRect).Size();
	const FString Name = FString::Printf(TEXT("%s %dx%d"), Names.Pass, Size.X, Size.Y);
	return AddScreenShaderPass<FToonBloomPS, FToonBloomCS>(GraphBuilder, View, {Name, Output, bCompute, DrawRect},
		Common, Permutation, &FToonBloomCS::FParameters::OutComputeTexture);
}

} // namespace

int32 GetToonBloomMode()
{
	return CVarToonBloom.GetValueOnAnyThread();
}

bool IsToonBloomAsPrinted()
{
	return CVarToonBloomAsPrinted.GetValueOnAnyThread() != 0;
}

bool IsToonBloomMaskVisualized()
{
	return CVarToonBloomVisualizeMask.GetValueOnAnyThread() != 0;
}

FScreenPassTexture AddToonBloomMaskPass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FToonBloomInputs& Inputs, const std::optional<FIntRect>& DrawRect)
{
	return AddToonPass(
		GraphBuilder, View, Inputs, false, {TEXT("ToonBloomMask"), TEXT("ToonBloomSceneColor")}, DrawRect);
}

FScreenPassTexture AddToonBloomVisualizePass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FToonBloomInputs& Inputs)
{
	return AddToonPass(
		GraphBuilder, View, Inputs, true, {TEXT("ToonBloomVisualizeMask"), TEXT("ToonBloomVisualizeMask")});
}

} // namespace Drydock
