// The two passes of the engine's Gaussian blur, and their factory; the kernel itself is in GaussianKernel.cpp. Source:
// engine file PostProcessWeightedSampleSum.cpp.
#include "Blur/PostProcessWeightedSampleSum.h"

#include "Blur/FilterShaders.h"
#include "HAL/IConsoleManager.h"
#include "PassFactory.h"
#include "PassFunctions.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "SceneRendering.h"
#include "Screen/RasterTarget.h"
#include "Screen/SampleSteps.h"

#include <cmath>

namespace Drydock
{

IMPLEMENT_GLOBAL_SHADER(FFilterPS, "/Engine/Private/FilterPixelShader.usf", "MainPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FFilterCS, "/Engine/Private/FilterPixelShader.usf", "MainCS", SF_Compute);

} // namespace Drydock

namespace
{

using namespace Drydock;

/** How texels outside the filter's rect are addressed. */
enum class EGaussianBlurAddress : uint8
{
	Black,
	Mirror,
	Clamp,
};

/** One direction of the blur. */
struct FFilterPassInputs
{
	const TCHAR* Name = nullptr;
	FScreenPassTexture Filter;
	FScreenPassTexture Additive;
	FIntPoint OutputExtent = FIntPoint(0, 0);
	FIntRect OutputRect;
	TConstArrayView<Drydock::FGaussianTap> Taps;
	FVector2f Direction = FVector2f(0.0f, 0.0f); // texels
	FLinearColor Tint = FLinearColor(1.0f, 1.0f, 1.0f, 1.0f);
	EGaussianBlurAddress Address = EGaussianBlurAddress::Black;
};

/** Pixels of the output lie on the sampler's steps: at texel centres, corners or quarters. */
bool IsAligned(const FIntRect& Filter, const FIntRect& Output)
{
	const auto Fits = [](int32 From, int32 To)
	{
		return From == To || From == 2 * To || 2 * From == To;
	};
	return Fits(Filter.Width(), Output.Width()) && Fits(Filter.Height(), Output.Height());
}

/** Packs the taps that weigh anything; one of zero weight would still multiply an infinite texel into NaN. Offsets are
 * snapped here, once, where that gives what the sampler would: then no rounding of UV can tip one over. */
void SetTaps(const FFilterPassInputs& Inputs, FFilterParameters& Parameters)
{
	const double Steps = Drydock::GetSampleSteps();
	const bool bSnapHere = Steps > 0.0 && IsAligned(Inputs.Filter.ViewRect, Inputs.OutputRect);
	Parameters.SampleSteps = static_cast<float>(Steps);
	Parameters.bSnapTaps = Steps > 0.0 && !bSnapHere ? 1 : 0;
	Parameters.SampleCount = 0;
	for (const Drydock::FGaussianTap& Tap : Inputs.Taps)
	{
		const float Weight = static_cast<float>(Tap.Weight);
		if (Weight == 0.0f)
		{
			continue;
		}
		const double Snapped = bSnapHere ? std::floor(Tap.Offset * Steps + 0.5) / Steps : Tap.Offset;
		const FVector2f Offset = Inputs.Direction * static_cast<float>(Snapped);
		FVector4f& Pair = Parameters.SampleOffsets[Parameters.SampleCount / 2];
		Pair = Parameters.SampleCount % 2 == 0 ? FVector4f(Offset.X, Offset.Y, 0.0f, 0.0f)
											   : FVector4f(Pair.X, Pair.Y, Offset.X, Offset.Y);
		Parameters.SampleWeights[Parameters.SampleCount] =
			FVector4f(Inputs.Tint.R * Weight, Inputs.Tint.G * Weight, Inputs.Tint.B * Weight, Inputs.Tint.A * Weight);
		++Parameters.SampleCount;
	}
}

ERectBorder ChooseRectBorder(const FScreenPassTextureViewport& Viewport, EGaussianBlurAddress Address)
{
	return Address == EGaussianBlurAddress::Clamp    ? ERectBorder::Clamp
		   : Viewport.IsFullscreen()                 ? ERectBorder::Sampler
		   : Address == EGaussianBlurAddress::Mirror ? ERectBorder::Mirror
													 : ERectBorder::Black;
}

FRHISamplerState* ChooseFilterSampler(ERectBorder RectBorder, EGaussianBlurAddress Address)
{
	return RectBorder != ERectBorder::Sampler ? TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI()
		   : Address == EGaussianBlurAddress::Mirror
			   ? TStaticSamplerState<SF_Bilinear, AM_Mirror, AM_Mirror, AM_Clamp>::GetRHI()
			   : TStaticSamplerState<SF_Bilinear, AM_Border, AM_Border, AM_Clamp>::GetRHI();
}

/** A slice's texture, which is a copy if the slice is one layer of an array. */
FScreenPassTexture GetPlainTexture(FRDGBuilder& GraphBuilder, const Drydock::FScreenPassInput& Input)
{
	return Input.TextureSRV ? FScreenPassTexture::CopyFromSlice(GraphBuilder, Input) : FScreenPassTexture(Input);
}

FScreenPassTexture AddFilterPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FFilterPassInputs& Inputs)
{
	const bool bCompute = View.bUseComputePasses;

	FRDGTextureDesc OutputDesc = Inputs.Filter.Texture->Desc;
	OutputDesc.Extent = Inputs.OutputExtent;
	const FScreenPassRenderTarget Output =
		Drydock::CreateScreenTarget(GraphBuilder, OutputDesc, Inputs.OutputRect, Inputs.Name, bCompute);

	const FScreenPassTextureViewport FilterViewport(Inputs.Filter);
	const ERectBorder RectBorder = ChooseRectBorder(FilterViewport, Inputs.Address);

	FFilterParameters Common;
	Common.Filter = GetScreenPassTextureInput(Inputs.Filter, ChooseFilterSampler(RectBorder, Inputs.Address));
	if (Inputs.Additive.IsValid())
	{
		Common.Additive = GetScreenPassTextureInput(
			Inputs.Additive, TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI());
	}
	Common.Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	SetTaps(Inputs, Common);

	FFilterPermutation Permutation;
	Permutation.Set<FAdditiveDimension>(Inputs.Additive.IsValid());
	Permutation.Set<FRectBorderDimension>(RectBorder);

	const FString Name =
		FString::Printf(TEXT("%s %dx%d"), Inputs.Name, Output.ViewRect.Width(), Output.ViewRect.Height());
	return Drydock::AddScreenShaderPass<FFilterPS, FFilterCS>(
		GraphBuilder, View, {Name, Output, bCompute}, Common, Permutation, &FFilterCS::FParameters::RWOutputTexture);
}

EGaussianBlurAddress GetAddress(const FGaussianBlurInputs& Inputs)
{
	if (Inputs.UseClampAddressMode)
	{
		return EGaussianBlurAddress::Clamp;
	}
	return Inputs.UseMirrorAddressMode ? EGaussianBlurAddress::Mirror : EGaussianBlurAddress::Black;
}

/** Half the width, ceil-divided, never empty. */
FScreenPassTextureViewport HalveWidth(const FScreenPassTextureViewport& Viewport)
{
	FScreenPassTextureViewport Half = Viewport;
	Half.Extent.X = FMath::DivideAndRoundUp(Viewport.Extent.X, 2);
	Half.Rect.Max.X = FMath::DivideAndRoundUp(Viewport.Rect.Max.X, 2);
	Half.Rect.Min.X = FMath::Min(FMath::DivideAndRoundUp(Viewport.Rect.Min.X, 2), Half.Rect.Max.X - 1);
	return Half;
}

} // namespace

namespace Drydock
{

namespace
{

const FPassFactoryRegistration GGaussianBlur({
	.Type = "GaussianBlur",
	.Doc = "Blurs an image by a separable Gaussian, as the bloom does; darkens towards the edges unless mirrored.",
	.Inputs = {{"Input", PictureResource, "The image."}},
	.Parameters =
		{
			FParameterSpec::Number("KernelSizePercent", 4.0, 0.0, 100.0,
				"Diameter of the kernel in percent of the image's width; at most 63 texels."),
			FParameterSpec::Color("Tint", FLinearColor(1.0f, 1.0f, 1.0f, 1.0f), "Multiplies the result, alpha too."),
			FParameterSpec::Bool("Mirror", true, "Texels outside: the image's mirror, or black."),
		},
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		FGaussianBlurInputs Inputs;
		Inputs.NameX = TEXT("GaussianBlurX");
		Inputs.NameY = TEXT("GaussianBlurY");
		Inputs.Filter = Arguments.GetInput("Input");
		Inputs.KernelSizePercent = Arguments.Values.GetFloat("KernelSizePercent");
		Inputs.TintColor = Arguments.Values.GetColor("Tint");
		Inputs.UseMirrorAddressMode = Arguments.Values.GetBool("Mirror");
		return AddGaussianBlurPass(GraphBuilder, View, Inputs);
	},
});

} // namespace

} // namespace Drydock

FScreenPassTexture Drydock::BuiltInAddGaussianBlurPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FGaussianBlurInputs& Inputs)
{
	check(Inputs.Filter.IsValid());
	const FScreenPassTexture Filter = GetPlainTexture(GraphBuilder, Inputs.Filter);
	checkf(!FMath::IsNaN(Inputs.KernelSizePercent), TEXT("The kernel size of %s is not a number."), Inputs.NameX);

	const FScreenPassTextureViewport Viewport(Filter);
	const float Radius = Drydock::GetBlurRadius(Viewport.Rect.Width(), Inputs.KernelSizePercent);
	const int32 SampleCountMax = Drydock::GetFilterSampleCountMax();
	const FScreenPassTextureViewport HorizontalViewport =
		Drydock::IsFastBlurEnabled(Radius) ? HalveWidth(Viewport) : Viewport;

	const TArray<Drydock::FGaussianTap> TapsX =
		Drydock::ComputeGaussianKernel(SampleCountMax, Radius, Inputs.CrossCenterWeight.X);
	FFilterPassInputs Horizontal;
	Horizontal.Name = Inputs.NameX;
	Horizontal.Filter = Filter;
	Horizontal.OutputExtent = HorizontalViewport.Extent;
	Horizontal.OutputRect = HorizontalViewport.Rect;
	Horizontal.Taps = TapsX;
	Horizontal.Direction = FVector2f(1.0f, 0.0f);
	Horizontal.Address = GetAddress(Inputs);

	const TArray<Drydock::FGaussianTap> TapsY =
		Drydock::ComputeGaussianKernel(SampleCountMax, Radius, Inputs.CrossCenterWeight.Y);
	FFilterPassInputs Vertical;
	Vertical.Name = Inputs.NameY;
	Vertical.Filter = AddFilterPass(GraphBuilder, View, Horizontal);
	Vertical.Additive = GetPlainTexture(GraphBuilder, Inputs.Additive);
	Vertical.OutputExtent = Viewport.Extent;
	Vertical.OutputRect = Viewport.Rect;
	Vertical.Taps = TapsY;
	Vertical.Direction = FVector2f(0.0f, 1.0f);
	Vertical.Tint = Inputs.TintColor;
	Vertical.Address = GetAddress(Inputs);
	return AddFilterPass(GraphBuilder, View, Vertical);
}
