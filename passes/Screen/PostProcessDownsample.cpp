// The pass that halves an image, its chain and its factory. Source: engine file PostProcessDownsample.cpp.
#include "Screen/PostProcessDownsample.h"

#include "HAL/IConsoleManager.h"
#include "PassFactory.h"
#include "PassFunctions.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "SceneRendering.h"
#include "Screen/DownsampleShaders.h"
#include "Screen/RasterTarget.h"

namespace Drydock
{

IMPLEMENT_GLOBAL_SHADER(FDownsamplePS, "/Engine/Private/PostProcessDownsample.usf", "MainPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FDownsampleCS, "/Engine/Private/PostProcessDownsample.usf", "MainCS", SF_Compute);

} // namespace Drydock

namespace
{

using namespace Drydock;

TAutoConsoleVariable<int32> CVarDownsampleQuality(TEXT("r.PostProcessing.DownsampleQuality"), 0,
	TEXT("Quality of the half-resolution scene colour: 0 low (2x2 box, default), 1 high (4x4 box)."),
	ECVF_Scalability | ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarDownsampleChainQuality(TEXT("r.PostProcessing.DownsampleChainQuality"), 1,
	TEXT("Quality of the downsample chain: 0 low (2x2 box), 1 high (4x4 box, default)."),
	ECVF_Scalability | ECVF_RenderThreadSafe);

EDownsampleQuality ToDownsampleQuality(int32 Value)
{
	return static_cast<EDownsampleQuality>(FMath::Clamp(Value, 0, static_cast<int32>(EDownsampleQuality::MAX) - 1));
}

FScreenPassRenderTarget CreateOutput(FRDGBuilder& GraphBuilder, const FDownsamplePassInputs& Inputs, bool bCompute)
{
	FRDGTextureDesc Desc = Inputs.SceneColor.Texture->Desc;
	Desc.Extent = FIntPoint::DivideAndRoundUp(Desc.Extent, 2);
	Desc.Extent.X = FMath::Max(1, Desc.Extent.X);
	Desc.Extent.Y = FMath::Max(1, Desc.Extent.Y);
	Desc.ClearValue = FClearValueBinding(FLinearColor(0.0f, 0.0f, 0.0f, 0.0f));
	if (Inputs.FormatOverride != PF_Unknown)
	{
		Desc.Format = Inputs.FormatOverride;
	}
	FIntRect Rect(FIntPoint::DivideAndRoundUp(Inputs.SceneColor.ViewRect.Min, 2),
		FIntPoint::DivideAndRoundUp(Inputs.SceneColor.ViewRect.Max, 2));
	// A rect one pixel wide that starts at an odd position would ceil-divide to nothing.
	Rect.Min.X = FMath::Min(Rect.Min.X, Rect.Max.X - 1);
	Rect.Min.Y = FMath::Min(Rect.Min.Y, Rect.Max.Y - 1);
	return Drydock::CreateScreenTarget(GraphBuilder, Desc, Rect, Inputs.Name, bCompute);
}

} // namespace

namespace Drydock
{

namespace
{

const FPassFactoryRegistration GDownsample({
	.Type = "Downsample",
	.Doc = "Halves an image.",
	.Inputs = {{"Input", PictureResource, "The image."}},
	.Parameters = {FParameterSpec::Text(
		"Quality", "High", {"Low", "High"}, "Low: one bilinear tap; High: four, a 4x4 box.")},
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		FDownsamplePassInputs Inputs;
		Inputs.Name = TEXT("Downsample");
		Inputs.SceneColor = Arguments.GetInput("Input");
		Inputs.Quality =
			Arguments.Values.GetText("Quality") == "Low" ? EDownsampleQuality::Low : EDownsampleQuality::High;
		return AddDownsamplePass(GraphBuilder, View, Inputs);
	},
});

} // namespace

} // namespace Drydock

EDownsampleQuality GetDownsampleQuality()
{
	return ToDownsampleQuality(CVarDownsampleQuality.GetValueOnRenderThread());
}

EDownsampleQuality GetDownsampleChainQuality()
{
	return ToDownsampleQuality(CVarDownsampleChainQuality.GetValueOnRenderThread());
}

FScreenPassTexture Drydock::BuiltInAddDownsamplePass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FDownsamplePassInputs& Inputs)
{
	check(Inputs.SceneColor.IsValid());

	const bool bCompute = View.bUseComputePasses && !EnumHasAnyFlags(Inputs.Flags, EDownsampleFlags::ForceRaster);
	const FScreenPassRenderTarget Output =
		Inputs.UserSuppliedOutput.IsValid() ? Inputs.UserSuppliedOutput : CreateOutput(GraphBuilder, Inputs, bCompute);

	const FScreenPassTextureViewport InputViewport(Inputs.SceneColor);
	const FScreenPassTextureViewport OutputViewport(Output);

	FDownsampleParameters Common;
	Common.Input = GetScreenPassTextureViewportParameters(InputViewport);
	Common.Output = GetScreenPassTextureViewportParameters(OutputViewport);
	Common.InputTexture = Inputs.SceneColor.Texture;
	Common.InputSampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();

	FDownsamplePS::FPermutationDomain Permutation;
	Permutation.Set<FDownsampleQualityDimension>(static_cast<int32>(Inputs.Quality));

	const FIntPoint Size = Inputs.DrawRect.value_or(Output.ViewRect).Size();
	const FString Name = FString::Printf(TEXT("%s(%s) %dx%d"), Output.Texture->Name,
		Inputs.Quality == EDownsampleQuality::High ? TEXT("High") : TEXT("Low"), Size.X, Size.Y);
	return Drydock::AddScreenShaderPass<FDownsamplePS, FDownsampleCS>(GraphBuilder, View,
		{Name, Output, bCompute, Inputs.DrawRect}, Common, Permutation, &FDownsampleCS::FParameters::OutComputeTexture);
}

void FTextureDownsampleChain::Init(FRDGBuilder& GraphBuilder, const FViewInfo& View, FScreenPassTexture HalfResolution,
	EDownsampleQuality Quality, const TCHAR* Name, uint32 Levels)
{
	check(HalfResolution.IsValid());
	check(Levels >= 1);
	RDG_EVENT_SCOPE(GraphBuilder, "%s", Name);

	Textures.Reset();
	Textures.Add(HalfResolution);
	for (uint32 Level = 1; Level < Levels; ++Level)
	{
		FDownsamplePassInputs PassInputs;
		PassInputs.Name = Name;
		PassInputs.SceneColor = Textures.Last();
		PassInputs.Quality = Quality;
		Textures.Add(AddDownsamplePass(GraphBuilder, View, PassInputs));
	}
}
