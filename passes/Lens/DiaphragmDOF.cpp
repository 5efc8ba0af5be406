// The passes of depth of field. Source: engine file PostProcess/DiaphragmDOF.cpp (order of passes).
#include "Lens/DiaphragmDOF.h"

#include "Lens/DiaphragmDOFShaders.h"
#include "Math/ToInteger.h"
#include "PassFunctions.h"
#include "PixelShaderUtils.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"
#include "Screen/RasterTarget.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace Drydock
{

IMPLEMENT_GLOBAL_SHADER(FDOFSetupPS, "/Drydock/Private/DiaphragmDOF.usf", "SetupPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FDOFTileMaxPS, "/Drydock/Private/DiaphragmDOF.usf", "TileMaxPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FDOFNeighborMaxPS, "/Drydock/Private/DiaphragmDOF.usf", "NeighborMaxPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FDOFGatherPS, "/Drydock/Private/DiaphragmDOF.usf", "GatherPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FDOFRecombinePS, "/Drydock/Private/DiaphragmDOF.usf", "RecombinePS", SF_Pixel);

} // namespace Drydock

namespace
{

using namespace Drydock;

constexpr int32 GMaxRings = 8;
constexpr int32 GReachSteps = 128; // per spacing of the samples

/** The places around a pixel that a gather looks at, and what it needs to weigh them. */
struct FBokehSamples
{
	/** From the centre outwards: offset in spacings, and its distance as the bokeh measures it. */
	std::vector<FVector4f> Samples;
	/** Element i: how many samples a bokeh of radius i / GReachSteps spacings reaches, those on its edge in part. */
	std::vector<float> ReachSums;
};

FBokehSamples MakeBokehSamples(const DiaphragmDOF::FBokehModel& Bokeh)
{
	constexpr double Farthest = GMaxRings + 0.5;          // an edge is one spacing wide
	constexpr int32 FarthestCorner = 2 * (GMaxRings + 1); // of four straight blades it is at 1.26 times the radius
	const int32 Side = Drydock::ToCount(std::ceil(Farthest * Bokeh.CocRadiusToCircumscribedRadius), 0, FarthestCorner);
	FBokehSamples Result;
	for (int32 Y = -Side; Y <= Side; ++Y)
	{
		for (int32 X = -Side; X <= Side; ++X)
		{
			const double Distance = Bokeh.MeasureDistance(X, Y);
			if (Distance < Farthest)
			{
				Result.Samples.emplace_back(X, Y, Distance, 0.0f);
			}
		}
	}
	std::ranges::stable_sort(Result.Samples, {}, &FVector4f::Z);
	for (int32 Step = 0; Step <= GMaxRings * GReachSteps; ++Step)
	{
		const double Radius = static_cast<double>(Step) / GReachSteps;
		double Sum = 0.0;
		for (const FVector4f& Sample : Result.Samples)
		{
			Sum += std::clamp(Radius - Sample.Z + 0.5, 0.0, 1.0);
		}
		Result.ReachSums.push_back(static_cast<float>(Sum));
	}
	return Result;
}

template<typename ElementType>
FRDGBufferSRVRef UploadElements(FRDGBuilder& GraphBuilder, const TCHAR* Name, const std::vector<ElementType>& Elements)
{
	return GraphBuilder.CreateSRV(CreateStructuredBuffer(GraphBuilder, Name, sizeof(ElementType),
		static_cast<uint32>(Elements.size()), Elements.data(), sizeof(ElementType) * Elements.size()));
}

class FDOFPasses
{
public:
	FDOFPasses(FRDGBuilder& InGraphBuilder, const FViewInfo& InView,
		TRDGUniformBufferRef<FSceneTextureUniformParameters> InSceneTextures, const FScreenPassTexture& InSceneColor,
		const DiaphragmDOF::FPhysicalCocModel& InModel, const DiaphragmDOF::FBokehModel& InBokeh)
		: GraphBuilder(InGraphBuilder)
		, View(InView)
		, SceneTextures(InSceneTextures)
		, SceneColor(InSceneColor)
		, Model(InModel)
		, Bokeh(InBokeh)
		, HalfSize(FIntPoint::DivideAndRoundUp(InSceneColor.ViewRect.Size(), 2))
		, TileCount(FIntPoint::DivideAndRoundUp(HalfSize, GDOFTileSize))
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

		const FBokehSamples Samples = MakeBokehSamples(Bokeh);
		BokehSampleCount = static_cast<int32>(Samples.Samples.size());
		BokehSamples = UploadElements(GraphBuilder, TEXT("DOF.BokehSamples"), Samples.Samples);
		ReachSums = UploadElements(GraphBuilder, TEXT("DOF.ReachSums"), Samples.ReachSums);
		const FScreenPassRenderTarget Background = AddGather(false, Setup.Texture, Tiles.Texture);
		const FScreenPassRenderTarget Foreground = AddGather(true, Setup.Texture, Tiles.Texture);

		const FScreenPassRenderTarget Output =
			Drydock::CreateRasterTargetLike(GraphBuilder, SceneColor, TEXT("DOF.Recombine"));
		Parameters = MakeParameters(Output);
		Parameters->ColorTexture = SceneColor.Texture;
		Parameters->BackgroundTexture = Background.Texture;
		Parameters->ForegroundTexture = Foreground.Texture;
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
		Parameters->BokehSampleCount = BokehSampleCount;
		Parameters->BokehSamples = BokehSamples;
		Parameters->ReachSums = ReachSums;
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
		// To the farthest corner, and half the width of the edge.
		const double Reach = (0.5 * Largest * (1.0 + 0.5 / GMaxRings) + 1.0) * Bokeh.CocRadiusToCircumscribedRadius;
		Parameters->TileReach = Drydock::ToCount(std::ceil(Reach / GDOFTileSize), 0, TileCount.GetMax() - 1);
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
	const DiaphragmDOF::FBokehModel& Bokeh;
	const FIntPoint HalfSize;
	const FIntPoint TileCount;
	int32 BokehSampleCount = 0;
	FRDGBufferSRVRef BokehSamples = nullptr;
	FRDGBufferSRVRef ReachSums = nullptr;
};

} // namespace

FScreenPassTexture Drydock::BuiltInAddPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures, const FScreenPassTexture& SceneColor,
	const DiaphragmDOF::FPhysicalCocModel& Model, const DiaphragmDOF::FBokehModel& Bokeh)
{
	check(SceneColor.IsValid());
	check(SceneTextures);
	if (!(Model.FocusDistance > 0.0f) || !(Model.InfinityRadius > 0.0f || Model.DepthBlurRadius > 0.0f))
	{
		return SceneColor;
	}
	RDG_EVENT_SCOPE(GraphBuilder, "DepthOfField");
	return FDOFPasses(GraphBuilder, View, SceneTextures, SceneColor, Model, Bokeh).AddAll();
}
