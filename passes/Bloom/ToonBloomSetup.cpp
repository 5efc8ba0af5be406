// Adds the bloom setup in which toon pixels have a strength of their own.
#include "Bloom/ToonBloomSetup.h"

#include "Bloom/ToonBloomSetupShaders.h"
#include "RenderGraphBuilder.h"
#include "Screen/DrawRegion.h"
#include "Screen/RasterTarget.h"

namespace Drydock
{

IMPLEMENT_GLOBAL_SHADER(FToonBloomSetupPS, "/Drydock/Private/ToonBloomSetup.usf", "ToonBloomSetupPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FToonBloomSetupCS, "/Drydock/Private/ToonBloomSetup.usf", "ToonBloomSetupCS", SF_Compute);

namespace
{

/** Colour at the resolution of the ids. */
FScreenPassTexture FindFullResolution(
	const FViewInfo& View, const FBloomSetupInputs& Inputs, const FToonBloomInputs& Toon)
{
	if (Toon.SceneColor.IsValid())
	{
		return Toon.SceneColor;
	}
	const FRDGTextureRef SceneColor = Toon.SceneTextures->GetContents()->SceneColorTexture;
	const FIntPoint Extent = SceneColor ? SceneColor->Desc.Extent : FIntPoint(0, 0);
	const bool bHoldsView = Extent.X >= View.ViewRect.Max.X && Extent.Y >= View.ViewRect.Max.Y;
	const bool bIsInput = Inputs.SceneColor.ViewRect.Size() == View.ViewRect.Size();
	return bHoldsView && !bIsInput ? FScreenPassTexture(SceneColor, View.ViewRect) : Inputs.SceneColor;
}

/** The setup's input, over which what toon pixels reach is drawn with the factor in it. */
FScreenPassTexture AddToonColorWithin(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomSetupInputs& Inputs,
	const FToonBloomInputs& MaskInputs, EDownsampleQuality DownsampleQuality)
{
	// A downsampled texel reads at most three texels around its place; one more for the rounding of the scale.
	constexpr int32 Reach = 4;
	const FIntRect& Full = MaskInputs.SceneColor.ViewRect;
	const FIntRect& Half = Inputs.SceneColor.ViewRect;
	const FIntRect Reached =
		GrowRect(ScaleRectOutward(GrowRect(*MaskInputs.ToonBounds, Reach, Reach), Full.Size(), Half.Size()), 1, 1);
	FIntRect Drawn = PlaceRect(Reached, Half);
	const FIntRect Read = GrowRect(ScaleRectOutward(Drawn - Half.Min, Half.Size(), Full.Size()), Reach, Reach);
	const FScreenPassTexture Masked = AddToonBloomMaskPass(GraphBuilder, View, MaskInputs, PlaceRect(Read, Full));

	FScreenPassRenderTarget Output =
		CreateRasterTargetLike(GraphBuilder, Inputs.SceneColor, TEXT("ToonBloomHalfResolution"));
	AddCopyTexturePass(GraphBuilder, Inputs.SceneColor.Texture, Output.Texture, Half.Min, Half.Min, Half.Size());
	if (Full.Size() == Half.Size())
	{
		Drawn = PlaceRect(*MaskInputs.ToonBounds, Half);
		AddCopyTexturePass(
			GraphBuilder, Masked.Texture, Output.Texture, Drawn.Min - Half.Min + Full.Min, Drawn.Min, Drawn.Size());
		return FScreenPassTexture(Output.Texture, Half);
	}
	Output.LoadAction = ERenderTargetLoadAction::ELoad;
	FDownsamplePassInputs DownsampleInputs;
	DownsampleInputs.SceneColor = Masked;
	DownsampleInputs.Quality = DownsampleQuality;
	DownsampleInputs.UserSuppliedOutput = Output;
	DownsampleInputs.DrawRect = Drawn;
	return AddDownsamplePass(GraphBuilder, View, DownsampleInputs);
}

/** The setup's input with the factor in it: masked at full resolution, then downsampled as the input was. */
FScreenPassTexture AddToonColor(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomSetupInputs& Inputs,
	const FToonBloomInputs& Toon, EDownsampleQuality DownsampleQuality)
{
	const FRDGEffectScope EffectScope(GraphBuilder, "ToonBloom");
	FToonBloomInputs MaskInputs = Toon;
	MaskInputs.SceneColor = FindFullResolution(View, Inputs, Toon);
	if (MaskInputs.ToonBounds && !View.bUseComputePasses)
	{
		return AddToonColorWithin(GraphBuilder, View, Inputs, MaskInputs, DownsampleQuality);
	}
	const FScreenPassTexture Masked = AddToonBloomMaskPass(GraphBuilder, View, MaskInputs);
	if (Masked.ViewRect.Size() == Inputs.SceneColor.ViewRect.Size())
	{
		return Masked;
	}
	FDownsamplePassInputs DownsampleInputs;
	DownsampleInputs.Name = TEXT("ToonBloomHalfResolution");
	DownsampleInputs.SceneColor = Masked;
	DownsampleInputs.Quality = DownsampleQuality;
	DownsampleInputs.FormatOverride = Inputs.SceneColor.Texture->Desc.Format;
	return AddDownsamplePass(GraphBuilder, View, DownsampleInputs);
}

} // namespace

FScreenPassTexture AddToonBloomSetupPass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FBloomSetupInputs& Inputs, const FToonBloomInputs& Toon, EDownsampleQuality DownsampleQuality)
{
	check(Inputs.SceneColor.IsValid());
	check(Inputs.EyeAdaptationBuffer);
	check(Toon.ToonIntensity > -1.0f);

	const bool bCompute = View.bUseComputePasses;
	const bool bAsPrinted = IsToonBloomAsPrinted();
	if (bAsPrinted && bCompute)
	{
		return AddBloomSetupPass(GraphBuilder, View, Inputs);
	}
	const FScreenPassRenderTarget Output = CreateScreenTarget(
		GraphBuilder, Inputs.SceneColor.Texture->Desc, Inputs.SceneColor.ViewRect, TEXT("BloomSetup"), bCompute);

	FToonBloomSetupParameters Parameters;
	Parameters.BloomSetup =
		GetBloomSetupParameters(GraphBuilder, View, FScreenPassTextureViewport(Inputs.SceneColor), Inputs);
	Parameters.SceneTextures = Toon.SceneTextures;
	Parameters.ToonIntensity = Toon.ToonIntensity;
	if (!bAsPrinted)
	{
		const FScreenPassTexture ToonColor = AddToonColor(GraphBuilder, View, Inputs, Toon, DownsampleQuality);
		Parameters.ToonTexture = ToonColor.Texture;
		Parameters.SvPositionToToonTextureUV =
			FScreenTransform::SvPositionToViewportUV(Output.ViewRect) *
			FScreenTransform::ChangeTextureBasisFromTo(FScreenPassTextureViewport(ToonColor),
				FScreenTransform::ETextureBasis::ViewportUV, FScreenTransform::ETextureBasis::TextureUV);
	}
	FToonBloomSetupPermutation Permutation;
	Permutation.Set<FToonAsPrintedDimension>(bAsPrinted);
	Permutation.Set<FBloomSetupPS::FPermutationDomain>(
		ChooseBloomSetupPermutation(View, Inputs.Threshold, Inputs.LocalExposureTexture != nullptr));

	const FString Name = FString::Printf(TEXT("BloomSetup %dx%d"), Output.ViewRect.Width(), Output.ViewRect.Height());
	return AddScreenShaderPass<FToonBloomSetupPS, FToonBloomSetupCS>(GraphBuilder, View, {Name, Output, bCompute},
		Parameters, Permutation, &FToonBloomSetupCS::FParameters::BloomOutput);
}

} // namespace Drydock
