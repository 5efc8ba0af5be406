// Custom depth and stencil in whole frames: what a shader reads of them, and what is said where a scene has none.
// Values are drawn at random (seed 5).
#include <gtest/gtest.h>

#include "pipeline/ExtensionTestUtils.h"

#include "GlobalShader.h"
#include "Picture/ImageFile.h"
#include "RenderGraphUtils.h"
#include "Run/Run.h"
#include "SceneRendering.h"
#include "SceneTextureParameters.h"
#include "ShaderCore.h"
#include "ShaderParameterStruct.h"

#include <algorithm>
#include <filesystem>
#include <random>
#include <unistd.h>

using namespace Drydock;

namespace
{

class FCustomStencilProbeCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FCustomStencilProbeCS);
	SHADER_USE_PARAMETER_STRUCT(FCustomStencilProbeCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
		SHADER_PARAMETER_STRUCT_INCLUDE(FSceneTextureShaderParameters, SceneTextures)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutColor)
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FCustomStencilProbeCS, "/DrydockTests/CustomStencilProbe.usf", "MainCS", SF_Compute);

constexpr int Width = 20;
constexpr int Height = 12;

FScreenPassTexture AddProbe(const ExtensionTest::FCall& Call)
{
	const auto& View = static_cast<const FViewInfo&>(Call.View);
	const FRDGTextureRef Output =
		Call.GraphBuilder.CreateTexture(FRDGTextureDesc::Create2D(FIntPoint(Width, Height), PF_A32B32G32R32F,
											FClearValueBinding::None, TexCreate_UAV | TexCreate_ShaderResource),
			TEXT("Probed"));
	auto* Parameters = Call.GraphBuilder.AllocParameters<FCustomStencilProbeCS::FParameters>();
	Parameters->View = View.ViewUniformBuffer;
	Parameters->SceneTextures = Call.Inputs.SceneTextures;
	Parameters->OutColor = Call.GraphBuilder.CreateUAV(Output);
	TShaderMapRef<FCustomStencilProbeCS> ComputeShader(View.ShaderMap);
	FComputeShaderUtils::AddPass(Call.GraphBuilder, RDG_EVENT_NAME("Probe"), ComputeShader, Parameters,
		FComputeShaderUtils::GetGroupCount(FIntPoint(Width, Height), FIntPoint(8, 8)));
	return FScreenPassTexture(Output, View.ViewRect);
}

/** A scene with the channels named; stencil anything, custom depth metres or none. */
struct FStencilScene
{
	explicit FStencilScene(const std::vector<std::string>& More)
		: Path((std::filesystem::temp_directory_path() / ("drydock_stencil_" + std::to_string(getpid()) + ".exr"))
				   .string())
	{
		std::mt19937 Random(5);
		std::uniform_int_distribution<int> Stencil(0, 255);
		std::uniform_real_distribution<double> Metres(0.5, 50.0);
		std::vector<std::string> Names = {"R", "G", "B", "depth.Z"};
		Names.insert(Names.end(), More.begin(), More.end());
		FImage Image{Width, Height, static_cast<int>(Names.size()), {}};
		for (int Pixel = 0; Pixel < Width * Height; ++Pixel)
		{
			Stencils.push_back(Stencil(Random));
			Depths.push_back(Stencils.back() < 64 ? 0.0 : Metres(Random));
			for (const std::string& Name : Names)
			{
				Image.Values.push_back(Name == "customstencil.ID" ? Stencils.back()
									   : Name == "customdepth.Z"  ? Depths.back()
																  : 3.0);
			}
		}
		WriteExr(Path, Image, Names);
	}
	~FStencilScene() { std::filesystem::remove(Path); }

	FRunResult Run(const std::string& SceneMore = "") const
	{
		AddShaderSourceDirectoryMapping(TEXT("/DrydockTests"), TEXT(DRYDOCK_TEST_SOURCE_DIR "/tests/Shaders"));
		const auto Extension = ExtensionTest::MakeExtension(ExtensionTest::EPoint::MotionBlur, AddProbe);
		FRunOptions Options;
		Options.ConfigFile = "stencil.json";
		Options.ConfigText = R"({"scene": {"file": ")" + Path + "\"" + SceneMore +
							 R"(}, "volumes": [{"bUnbound": true, "Settings": {"BloomIntensity": 0}}]})";
		return RunConfig(Options);
	}

	std::string Path;
	std::vector<int> Stencils;
	std::vector<double> Depths;
};

int CountWarnings(const FRunResult& Result, const std::string& Part)
{
	return static_cast<int>(std::count_if(Result.Diagnostics.begin(), Result.Diagnostics.end(),
		[&Part](const FDiagnostic& Diagnostic)
		{ return Diagnostic.Code == 5032 && Diagnostic.ToString().find(Part) != std::string::npos; }));
}

} // namespace

TEST(CustomStencilRun, ShadersReadWhatTheSceneHas)
{
	const FStencilScene Scene({"customdepth.Z", "customstencil.ID"});
	const FRunResult Result = Scene.Run();
	ASSERT_EQ(Width, Result.SceneLinear.Width);
	for (int Pixel = 0; Pixel < Width * Height; ++Pixel)
	{
		const size_t Index = static_cast<size_t>(Pixel);
		const double Centimetres = Scene.Depths[Index] > 0.0 ? 100.0 * Scene.Depths[Index] : 1e8;
		EXPECT_EQ(Scene.Stencils[Index], Result.SceneLinear.Get(Pixel % Width, Pixel / Width, 0)) << Pixel;
		EXPECT_NEAR(1.0, Result.SceneLinear.Get(Pixel % Width, Pixel / Width, 1) / Centimetres, 1e-4) << Pixel;
	}
	EXPECT_EQ(0, CountWarnings(Result, ""));
}

TEST(CustomStencilRun, ASceneWithoutIsSaidOnceEach)
{
	const FRunResult Result = FStencilScene({}).Run();
	EXPECT_EQ(0.0, Result.SceneLinear.Get(3, 3, 0));
	EXPECT_NEAR(1e8, Result.SceneLinear.Get(3, 3, 1), 10.0);
	EXPECT_EQ(2, CountWarnings(Result, "Probe"));
	EXPECT_EQ(1, CountWarnings(Result, "\"customdepth.Z\""));
	EXPECT_EQ(1, CountWarnings(Result, "\"customstencil.ID\""));
}

TEST(CustomStencilRun, ADefaultIsAChannel)
{
	const FRunResult Result = FStencilScene({}).Run(R"(, "defaults": {"customstencil.ID": 7})");
	EXPECT_EQ(7.0, Result.SceneLinear.Get(3, 3, 0));
	EXPECT_EQ(1, CountWarnings(Result, ""));
}

TEST(CustomStencilRun, TheShippedPortraitHasBoth)
{
	const auto Extension = ExtensionTest::MakeExtension(ExtensionTest::EPoint::MotionBlur,
		[](const ExtensionTest::FCall& Call)
		{
			EXPECT_STREQ("CustomDepth", Call.Inputs.CustomDepthTexture->Name);
			return Call.Untouched();
		});
	FRunOptions Options;
	Options.ConfigFile = DRYDOCK_TEST_SOURCE_DIR "/configs/toon_shadow_blur.json";
	Options.bExecute = false;
	RunConfig(Options);
	EXPECT_EQ(1, Extension->NumCalls);
}
