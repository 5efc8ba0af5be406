// The lens and the passes of depth of field. Source: engine file PostProcess/DiaphragmDOF.cpp (lens, limits).
#include "Lens/DiaphragmDOF.h"

#include "GlobalShader.h"
#include "PixelShaderUtils.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"
#include "Screen/RasterTarget.h"
#include "ShaderParameterStruct.h"

#include <cmath>

namespace
{

TAutoConsoleVariable<float> CVarMaxForegroundRadius(TEXT("r.DOF.Kernel.MaxForegroundRadius"), 0.025f,
	TEXT("Largest blur before the focus, as a part of the view's width (0.025)."),
	ECVF_Scalability | ECVF_RenderThreadSafe);
TAutoConsoleVariable<float> CVarMaxBackgroundRadius(TEXT("r.DOF.Kernel.MaxBackgroundRadius"), 0.025f,
	TEXT("Largest blur behind the focus, as a part of the view's width (0.025)."),
	ECVF_Scalability | ECVF_RenderThreadSafe);

constexpr int32 GTileSize = 16; // pixels of half size

BEGIN_SHADER_PARAMETER_STRUCT(FDOFParameters, )
	SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
	SHADER_PARAMETER_STRUCT_INCLUDE(FSceneTextureShaderParameters, SceneTextures)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Color)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Layer)
	SHADER_PARAMETER(FIntPoint, HalfSize)
	SHADER_PARAMETER(FIntPoint, TileCount)
	SHADER_PARAMETER(int32, TileReach)
	SHADER_PARAMETER(FVector4f, CocModel)  // focus distance, radius at infinity, least, largest
	SHADER_PARAMETER(FVector4f, DepthBlur) // radius, 1 / half depth
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ColorTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, SetupTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, TileTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, BackgroundTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ForegroundTexture)
	SHADER_PARAMETER_SAMPLER(SamplerState, LayerSampler)
	RENDER_TARGET_BINDING_SLOTS()
END_SHADER_PARAMETER_STRUCT()

class FDOFSetupPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FDOFSetupPS);
	SHADER_USE_PARAMETER_STRUCT(FDOFSetupPS, FGlobalShader);
	using FParameters = FDOFParameters;
};

class FDOFTileMaxPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FDOFTileMaxPS);
	SHADER_USE_PARAMETER_STRUCT(FDOFTileMaxPS, FGlobalShader);
	using FParameters = FDOFParameters;
};

class FDOFNeighborMaxPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FDOFNeighborMaxPS);
	SHADER_USE_PARAMETER_STRUCT(FDOFNeighborMaxPS, FGlobalShader);
	using FParameters = FDOFParameters;
};

class FDOFGatherPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FDOFGatherPS);
	SHADER_USE_PARAMETER_STRUCT(FDOFGatherPS, FGlobalShader);

	class FForegroundDimension : SHADER_PERMUTATION_BOOL("DIM_FOREGROUND");
	using FPermutationDomain = TShaderPermutationDomain<FForegroundDimension>;
	using FParameters = FDOFParameters;
};

class FDOFRecombinePS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FDOFRecombinePS);
	SHADER_USE_PARAMETER_STRUCT(FDOFRecombinePS, FGlobalShader);
	using FParameters = FDOFParameters;
};

IMPLEMENT_GLOBAL_SHADER(FDOFSetupPS, "/Engine/Private/DiaphragmDOF.usf", "SetupPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FDOFTileMaxPS, "/Engine/Private/DiaphragmDOF.usf", "TileMaxPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FDOFNeighborMaxPS, "/Engine/Private/DiaphragmDOF.usf", "NeighborMaxPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FDOFGatherPS, "/Engine/Private/DiaphragmDOF.usf", "GatherPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FDOFRecombinePS, "/Engine/Private/DiaphragmDOF.usf", "RecombinePS", SF_Pixel);

class FDOFPasses
{
public:
	FDOFPasses(FRDGBuilder& InGraphBuilder, const FViewInfo& InView,
		TRDGUniformBufferRef<FSceneTextureUniformParameters> InSceneTextures, const FScreenPassTexture& InSceneColor,
		const DiaphragmDOF::FPhysicalCocModel& InModel)
		: GraphBuilder(InGraphBuilder)
		, View(InView)
		, SceneTextures(InSceneTextures)
		, SceneColor(InSceneColor)
		, Model(InModel)
		, HalfSize(FIntPoint::DivideAndRoundUp(InSceneColor.ViewRect.Size(), 2))
		, TileCount(FIntPoint::DivideAndRoundUp(HalfSize, GTileSize))
	{
	}

	FScreenPassTexture AddAll()
	{
		const FScreenPassRenderTarget Setup = CreateSmall(HalfSize, TEXT("DOF.Setup"));
		AddPass(TShaderMapRef<FDOFSetupPS>(View.ShaderMap), "DOF Setup", Setup, MakeParameters(Setup));

		const FScreenPassRenderTarget TileMax = CreateSmall(TileCount, TEXT("DOF.TileMax"));
		FDOFParameters* Parameters = MakeParameters(TileMax);
		Parameters->SetupTexture = Setup.Texture;
		AddPass(TShaderMapRef<FDOFTileMaxPS>(View.ShaderMap), "DOF TileMax", TileMax, Parameters);

		const FScreenPassRenderTarget Tiles = CreateSmall(TileCount, TEXT("DOF.NeighborMax"));
		Parameters = MakeParameters(Tiles);
		Parameters->TileTexture = TileMax.Texture;
		AddPass(TShaderMapRef<FDOFNeighborMaxPS>(View.ShaderMap), "DOF NeighborMax", Tiles, Parameters);

		const FScreenPassRenderTarget Background = AddGather(false, Setup.Texture, Tiles.Texture);
		const FScreenPassRenderTarget Foreground = AddGather(true, Setup.Texture, Tiles.Texture);

		const FScreenPassRenderTarget Output =
			Drydock::CreateRasterTargetLike(GraphBuilder, SceneColor, TEXT("DOF.Recombine"));
		Parameters = MakeParameters(Output);
		Parameters->ColorTexture = SceneColor.Texture;
		Parameters->BackgroundTexture = Background.Texture;
		Parameters->ForegroundTexture = Foreground.Texture;
		Parameters->Layer = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Background));
		AddPass(TShaderMapRef<FDOFRecombinePS>(View.ShaderMap), "DOF Recombine", Output, Parameters);
		return FScreenPassTexture(Output.Texture, Output.ViewRect);
	}

private:
	FScreenPassRenderTarget AddGather(bool bForeground, FRDGTextureRef Setup, FRDGTextureRef Tiles)
	{
		const FScreenPassRenderTarget Output =
			CreateSmall(HalfSize, bForeground ? TEXT("DOF.Foreground") : TEXT("DOF.Background"));
		FDOFParameters* Parameters = MakeParameters(Output);
		Parameters->SetupTexture = Setup;
		Parameters->TileTexture = Tiles;
		FDOFGatherPS::FPermutationDomain Permutation;
		Permutation.Set<FDOFGatherPS::FForegroundDimension>(bForeground);
		AddPass(TShaderMapRef<FDOFGatherPS>(View.ShaderMap, Permutation),
			bForeground ? "DOF Gather(Foreground)" : "DOF Gather(Background)", Output, Parameters);
		return Output;
	}

	FScreenPassRenderTarget CreateSmall(FIntPoint Size, const TCHAR* Name) const
	{
		return Drydock::CreateSmallRasterTarget(GraphBuilder, SceneColor, Size, Name, PF_FloatRGBA);
	}

	FDOFParameters* MakeParameters(const FScreenPassRenderTarget& Output) const
	{
		auto* Parameters = GraphBuilder.AllocParameters<FDOFParameters>();
		Parameters->View = View.ViewUniformBuffer;
		Parameters->SceneTextures = GetSceneTextureShaderParameters(SceneTextures);
		Parameters->Color = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(SceneColor));
		Parameters->ColorTexture = SceneColor.Texture;
		Parameters->LayerSampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
		Parameters->HalfSize = HalfSize;
		Parameters->TileCount = TileCount;
		const float Largest = FMath::Max3(Model.MaxForegroundRadius, Model.MaxBackgroundRadius, Model.DepthBlurRadius);
		Parameters->TileReach = FMath::DivideAndRoundUp(FMath::CeilToInt(0.5f * Largest) + 1, GTileSize);
		Parameters->CocModel =
			FVector4f(Model.FocusDistance, Model.InfinityRadius, -Model.MaxForegroundRadius, Model.MaxBackgroundRadius);
		Parameters->DepthBlur = FVector4f(Model.DepthBlurRadius, 1.0f / Model.DepthBlurHalfDepth, 0.0f, 0.0f);
		Parameters->RenderTargets[0] = Output.GetRenderTargetBinding();
		return Parameters;
	}

	template<typename TShaderRef>
	void AddPass(const TShaderRef& PixelShader, const char* Name, const FScreenPassRenderTarget& Output,
		FDOFParameters* Parameters)
	{
		FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
			RDG_EVENT_NAME("%s %dx%d", Name, Output.ViewRect.Width(), Output.ViewRect.Height()), PixelShader,
			Parameters, Output.ViewRect);
	}

	FRDGBuilder& GraphBuilder;
	const FViewInfo& View;
	const TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures;
	const FScreenPassTexture& SceneColor;
	const DiaphragmDOF::FPhysicalCocModel& Model;
	const FIntPoint HalfSize;
	const FIntPoint TileCount;
};

} // namespace

namespace DiaphragmDOF
{

FPhysicalCocModel FPhysicalCocModel::Compile(
	const FFinalPostProcessSettings& Settings, int32 ViewWidth, float CotHalfFov)
{
	constexpr float MillimetresPerCentimetre = 10.0f;
	constexpr float CentimetresPerKilometre = 100000.0f;
	const float Width = static_cast<float>(ViewWidth);
	const float SensorWidth = Settings.DepthOfFieldSensorWidth;
	const float FocalLength = 0.5f * SensorWidth * CotHalfFov;
	const float Aperture = FocalLength / Settings.DepthOfFieldFstop;
	const float Focus = MillimetresPerCentimetre * Settings.DepthOfFieldFocalDistance;

	FPhysicalCocModel Model;
	Model.FocusDistance = Settings.DepthOfFieldFocalDistance;
	// A lens cannot focus nearer than its focal length.
	const float Diameter = Focus > FocalLength ? Aperture * FocalLength / (Focus - FocalLength) : 0.0f;
	Model.InfinityRadius = 0.5f * Diameter / SensorWidth * Width;
	Model.MaxForegroundRadius = FMath::Max(CVarMaxForegroundRadius.GetValueOnRenderThread(), 0.0f) * Width;
	Model.MaxBackgroundRadius = FMath::Max(CVarMaxBackgroundRadius.GetValueOnRenderThread(), 0.0f) * Width;
	Model.DepthBlurRadius = FMath::Max(Settings.DepthOfFieldDepthBlurRadius, 0.0f) * Width / 1920.0f;
	Model.DepthBlurHalfDepth = FMath::Max(Settings.DepthOfFieldDepthBlurAmount * CentimetresPerKilometre, 1.0f);
	return Model;
}

float FPhysicalCocModel::DepthToCocRadius(float Depth) const
{
	if (!(Depth > 0.0f) || !std::isfinite(Depth))
	{
		return 0.0f;
	}
	const float Lens =
		FMath::Clamp(InfinityRadius * (1.0f - FocusDistance / Depth), -MaxForegroundRadius, MaxBackgroundRadius);
	const float Air = DepthBlurRadius * (1.0f - std::exp2(-Depth / DepthBlurHalfDepth));
	return Depth > FocusDistance ? FMath::Max(Lens, Air) : Lens;
}

bool IsEnabled(const FFinalPostProcessSettings& Settings)
{
	return Settings.DepthOfFieldFocalDistance > 0.0f && Settings.DepthOfFieldFstop > 0.0f &&
		   Settings.DepthOfFieldSensorWidth > 0.0f;
}

FScreenPassTexture AddPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures, const FScreenPassTexture& SceneColor,
	const FPhysicalCocModel& Model)
{
	check(SceneColor.IsValid());
	check(SceneTextures);
	if (!(Model.FocusDistance > 0.0f) || !(Model.InfinityRadius > 0.0f || Model.DepthBlurRadius > 0.0f))
	{
		return SceneColor;
	}
	RDG_EVENT_SCOPE(GraphBuilder, "DepthOfField");
	return FDOFPasses(GraphBuilder, View, SceneTextures, SceneColor, Model).AddAll();
}

} // namespace DiaphragmDOF
