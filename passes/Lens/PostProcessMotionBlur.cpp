// The passes of motion blur. Source: engine file PostProcess/PostProcessMotionBlur.cpp (passes).
#include "Lens/PostProcessMotionBlur.h"

#include "Lens/MotionBlurShaders.h"
#include "Math/ToInteger.h"
#include "PassFunctions.h"
#include "PixelShaderUtils.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"
#include "Screen/LimitErrors.h"
#include "Screen/RasterTarget.h"

namespace Drydock
{

IMPLEMENT_GLOBAL_SHADER(
	FMotionBlurVelocityFlattenPS, "/Engine/Private/PostProcessMotionBlur.usf", "VelocityFlattenPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(
	FMotionBlurVelocityTileMaxPS, "/Engine/Private/PostProcessMotionBlur.usf", "VelocityTileMaxPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(
	FMotionBlurVelocityNeighborMaxPS, "/Engine/Private/PostProcessMotionBlur.usf", "VelocityNeighborMaxPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FMotionBlurFilterPS, "/Engine/Private/PostProcessMotionBlur.usf", "FilterPS", SF_Pixel);

} // namespace Drydock

namespace
{

using namespace Drydock;

TAutoConsoleVariable<int32> CVarMotionBlurQuality(TEXT("r.MotionBlurQuality"), 4,
	TEXT("Most samples along the movement. 0: motion blur off. 1: 8. 2: 16. 3: 32. 4: 64 (default)."),
	ECVF_Scalability | ECVF_RenderThreadSafe);

int32 GetMaxSamples(EMotionBlurQuality Quality)
{
	return 4 << static_cast<uint32>(Quality);
}

/** The state that the four passes share; each reads what it needs. */
class FMotionBlurPasses
{
public:
	FMotionBlurPasses(FRDGBuilder& InGraphBuilder, const FViewInfo& InView, const FMotionBlurInputs& InInputs)
		: GraphBuilder(InGraphBuilder)
		, View(InView)
		, Inputs(InInputs)
		, Size(InInputs.SceneColor.ViewRect.Size())
		, TileCount(FIntPoint::DivideAndRoundUp(Size, GMotionBlurTileSize))
	{
	}

	FRDGTextureRef AddFlatten()
	{
		const FScreenPassRenderTarget Output = Drydock::CreateSmallRasterTarget(
			GraphBuilder, Inputs.SceneColor, Size, TEXT("MotionBlur.VelocityFlat"), PF_FloatRGBA);
		AddPass<FMotionBlurVelocityFlattenPS>("MotionBlur VelocityFlatten", Output, MakeParameters(Output));
		return Output.Texture;
	}

	FRDGTextureRef AddTileMax(FRDGTextureRef Flat)
	{
		const FScreenPassRenderTarget Output = CreateTiles(TEXT("MotionBlur.VelocityTileMax"));
		FMotionBlurParameters* Parameters = MakeParameters(Output);
		Parameters->FlatTexture = Flat;
		AddPass<FMotionBlurVelocityTileMaxPS>("MotionBlur VelocityTileMax", Output, Parameters);
		return Output.Texture;
	}

	FRDGTextureRef AddNeighborMax(FRDGTextureRef Tiles)
	{
		const FScreenPassRenderTarget Output = CreateTiles(TEXT("MotionBlur.VelocityNeighborMax"));
		FMotionBlurParameters* Parameters = MakeParameters(Output);
		Parameters->TileTexture = Tiles;
		AddPass<FMotionBlurVelocityNeighborMaxPS>("MotionBlur VelocityNeighborMax", Output, Parameters);
		return Output.Texture;
	}

	FScreenPassTexture AddFilter(FRDGTextureRef Flat, FRDGTextureRef Tiles)
	{
		const FScreenPassRenderTarget Output =
			Inputs.OverrideOutput.IsValid()
				? Inputs.OverrideOutput
				: Drydock::CreateRasterTargetLike(GraphBuilder, Inputs.SceneColor, TEXT("MotionBlur"));
		FMotionBlurParameters* Parameters = MakeParameters(Output);
		Parameters->ColorTexture = Inputs.SceneColor.Texture;
		Parameters->FlatTexture = Flat;
		Parameters->TileTexture = Tiles;
		AddPass<FMotionBlurFilterPS>("MotionBlur Filter", Output, Parameters);
		return FScreenPassTexture(Output.Texture, Output.ViewRect);
	}

private:
	FScreenPassRenderTarget CreateTiles(const TCHAR* Name) const
	{
		return Drydock::CreateSmallRasterTarget(GraphBuilder, Inputs.SceneColor, TileCount, Name, PF_FloatRGBA);
	}

	FMotionBlurParameters* MakeParameters(const FScreenPassRenderTarget& Output) const
	{
		auto* Parameters = GraphBuilder.AllocParameters<FMotionBlurParameters>();
		Parameters->View = View.ViewUniformBuffer;
		Parameters->SceneTextures = GetSceneTextureShaderParameters(Inputs.SceneTextures);
		Parameters->Color = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Inputs.SceneColor));
		Parameters->Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
		Parameters->FlatSize = Size;
		Parameters->TileCount = TileCount;
		// A blur reaches half its length to either side; beyond the farthest tile there is none.
		Parameters->TileReach =
			Drydock::ToCount(std::ceil(0.5f * Inputs.MaxLength / GMotionBlurTileSize), 0, TileCount.GetMax() - 1);
		Parameters->MaxSamples = GetMaxSamples(Inputs.Quality);
		Parameters->VelocityScale = Inputs.VelocityScale;
		Parameters->MaxLength = Inputs.MaxLength;
		Parameters->RenderTargets[0] = Output.GetRenderTargetBinding();
		return Parameters;
	}

	template<typename TShader>
	void AddPass(const char* Name, const FScreenPassRenderTarget& Output, FMotionBlurParameters* Parameters)
	{
		TShaderMapRef<TShader> PixelShader(View.ShaderMap);
		FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
			RDG_EVENT_NAME("%s %dx%d", Name, Output.ViewRect.Width(), Output.ViewRect.Height()), PixelShader,
			Parameters, Output.ViewRect);
	}

	FRDGBuilder& GraphBuilder;
	const FViewInfo& View;
	const FMotionBlurInputs& Inputs;
	const FIntPoint Size;
	const FIntPoint TileCount;
};

/** The longest blur in a picture of this size: half of it, to either side, leads from any pixel across the picture. */
float GetLargestMaxLength(FIntPoint Size)
{
	constexpr float LargestHalf = 65504.0f; // velocities are stored in half floats
	return FMath::Min(2.0f * (static_cast<float>(Size.X) + static_cast<float>(Size.Y)), LargestHalf);
}

} // namespace

EMotionBlurQuality GetMotionBlurQuality()
{
	return static_cast<EMotionBlurQuality>(FMath::Clamp(CVarMotionBlurQuality.GetValueOnRenderThread(), 0, 4));
}

FMotionBlurInputs FMotionBlurInputs::FromSettings(
	const FFinalPostProcessSettings& Settings, const FScreenPassTexture& SceneColor, float DeltaTime)
{
	FMotionBlurInputs Inputs;
	Inputs.SceneColor = SceneColor;
	Inputs.Quality = GetMotionBlurQuality();
	const float FPS = static_cast<float>(Settings.MotionBlurTargetFPS);
	const bool bRelative = FPS > 0.0f && DeltaTime > 0.0f;
	Inputs.VelocityScale = Settings.MotionBlurAmount * (bRelative ? 1.0f / (FPS * DeltaTime) : 1.0f);
	Inputs.MaxLength = 0.01f * Settings.MotionBlurMax * static_cast<float>(SceneColor.ViewRect.Width());
	return Inputs;
}

FScreenPassTexture Drydock::BuiltInAddMotionBlurPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FMotionBlurInputs& Inputs)
{
	check(Inputs.SceneColor.IsValid());
	check(Inputs.SceneTextures);
	if (Inputs.Quality == EMotionBlurQuality::Off || !(Inputs.VelocityScale > 0.0f) || !(Inputs.MaxLength > 0.0f))
	{
		return Inputs.SceneColor;
	}
	FMotionBlurInputs Limited = Inputs;
	Limited.MaxLength = FMath::Min(Inputs.MaxLength, GetLargestMaxLength(Inputs.SceneColor.ViewRect.Size()));
	if (Limited.MaxLength < Inputs.MaxLength)
	{
		const FString Message = FString::Printf(
			TEXT("a blur of up to %g pixels is asked for (MotionBlurMax, r.MotionBlur.Max); %g are taken, which reach "
				 "across the picture from any pixel"),
			Inputs.MaxLength, Limited.MaxLength);
		Drydock::AddLimitNote(GraphBuilder, "MotionBlur", *Message);
	}
	RDG_EVENT_SCOPE(GraphBuilder, "MotionBlur");
	FMotionBlurPasses Passes(GraphBuilder, View, Limited);
	const FRDGTextureRef Flat = Passes.AddFlatten();
	return Passes.AddFilter(Flat, Passes.AddNeighborMax(Passes.AddTileMax(Flat)));
}
