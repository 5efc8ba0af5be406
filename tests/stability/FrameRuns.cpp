// How the row of the whole frame is run.
#include "Runs.h"

#include "Cases.h"

#include "Frame/Frame.h"
#include "RenderGraphBuilder.h"
#include "RenderTargetPool.h"

using namespace Drydock;

namespace Stability
{

namespace
{

/** Scene colour is a texture of half floats, whatever the case would like; outside of the view it is NaN. */
FSceneTextures RegisterScene(FRDGBuilder& GraphBuilder, const FCase& Case, const FIntRect& Rect, FIntPoint Extent)
{
	const FRDGTextureDesc Desc = FRDGTextureDesc::Create2D(Extent, PF_FloatRGBA, FClearValueBinding::Black,
		ETextureCreateFlags::ShaderResource | ETextureCreateFlags::RenderTargetable | ETextureCreateFlags::UAV);
	const FTextureRHIRef Texture = new FRHITexture(Desc, TEXT("SceneColor"));
	for (int Y = 0; Y < Extent.Y; ++Y)
	{
		for (int X = 0; X < Extent.X; ++X)
		{
			const bool bInside = Rect.Contains(FIntPoint(X, Y));
			const FTexel Color = bInside ? Case.Image.At(X - Rect.Min.X, Y - Rect.Min.Y)
										 : FTexel{PassTest::NaN, PassTest::NaN, PassTest::NaN, PassTest::NaN};
			Texture->WriteTexelDouble(X, Y, FVector4(Color[0], Color[1], Color[2], Color[3]));
		}
	}
	FSceneTextures SceneTextures;
	SceneTextures.Config.Extent = Extent;
	SceneTextures.Color = GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Texture, TEXT("SceneColor")));
	return SceneTextures;
}

/** Final picture at default settings. Intensity, Threshold: the bloom's; Sigma: its size scale, 4; Power: gamma of the
 *  grading. Bloom is off by the show flag. */
template<bool bBloom>
FImage RunFrame(const FCase& Case)
{
	const bool bDouble = PassTest::IsDouble(Case.Arithmetic);
	const PassTest::FScopedConsoleVariable Precision(TEXT("r.Drydock.Precision"), bDouble ? 1 : 0);
	const PassTest::FScopedConsoleVariable Storage(TEXT("r.Drydock.Storage"), bDouble ? 2 : 0);
	const FIntPoint Size(Case.Image.Width, Case.Image.Height);
	const FIntRect Rect(Case.Offset, Case.Offset + Size);
	const FIntPoint Extent = Case.Offset + Size + Case.Padding;
	FFrameInputs Inputs;
	Inputs.Extent = Extent;
	FFrameView View;
	View.Rect = Rect;
	FFinalPostProcessSettings& Settings = View.Settings.Settings;
	Settings = StartFinalPostProcessSettings();
	Settings.BloomIntensity = static_cast<float>(Case.Intensity.value_or(0.675));
	Settings.BloomThreshold = static_cast<float>(Case.Threshold.value_or(-1.0));
	Settings.BloomSizeScale = static_cast<float>(Case.Sigma.value_or(4.0));
	Settings.ColorGamma = FVector4(1, 1, 1, Case.Power.value_or(1.0));
	Inputs.ShowFlags.SetSingleFlag(static_cast<uint32>(FEngineShowFlags::FindIndexByName(TEXT("Bloom"))), bBloom);
	View.Settings.ShowFlags = Inputs.ShowFlags;
	View.Settings.Gates = EndFinalPostProcessSettings(Settings, Inputs.ShowFlags);
	Inputs.Views.push_back(View);
	Inputs.RegisterSceneTextures = [&](FRDGBuilder& GraphBuilder)
	{
		return RegisterScene(GraphBuilder, Case, Rect, Extent);
	};
	const Drydock::FImage Final = RenderViewFamily(Inputs).Final.ToImage();
	return FImage::Make(Final.Width, Final.Height,
		[&](int X, int Y) {
			return FTexel{Final.Get(X, Y, 0), Final.Get(X, Y, 1), Final.Get(X, Y, 2), Final.Get(X, Y, 3)};
		});
}

const FRunRegistration FrameRuns({{"Whole frame", {.Run = RunFrame<true>, .Formula = RunFrame<false>}}});

} // namespace

} // namespace Stability
