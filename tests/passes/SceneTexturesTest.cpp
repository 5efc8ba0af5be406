// Scene textures through their uniform buffer: what a shader reads of present and absent ones.
#include "PassTestUtils.h"

#include "GlobalShader.h"
#include "RenderGraphUtils.h"
#include "SceneTextureParameters.h"
#include "ShaderCore.h"
#include "ShaderParameterStruct.h"

using namespace PassTest;

namespace
{

class FSceneTexturesProbeCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FSceneTexturesProbeCS);
	SHADER_USE_PARAMETER_STRUCT(FSceneTexturesProbeCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
		SHADER_PARAMETER_STRUCT_INCLUDE(FSceneTextureShaderParameters, SceneTextures)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutColor)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutGBuffer)
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FSceneTexturesProbeCS, "/DrydockTests/SceneTexturesProbe.usf", "MainCS", SF_Compute);

constexpr int Width = 6;
constexpr int Height = 4;

struct FProbes
{
	FImage Color;   // scene colour, depth in centimetres
	FImage GBuffer; // shading model id, base colour red, ambient occlusion, custom data blue
};

/** Cloth in the left half, default lit in the right, distances of 100 cm and more. */
FProbes Probe(ESceneTextureSetupMode Mode)
{
	AddShaderSourceDirectoryMapping(TEXT("/DrydockTests"), TEXT(DRYDOCK_TEST_SOURCE_DIR "/tests/Shaders"));
	FPassRun Run(FImage::Noise(Width, Height), EArithmetic::Float32, PF_A32B32G32R32F);
	// Reversed depth of a near plane at 10 cm: z = 10 / d.
	Run.View.UniformParameters.InvDeviceZToWorldZTransform = FVector4f(0.0f, 0.0f, 0.1f, 0.0f);
	Run.View.InitViewUniformBuffer(FIntPoint(Width, Height));

	const auto Add = [&Run](EPixelFormat Format, const TCHAR* Name, const std::function<FTexel(int, int)>& Texel)
	{
		return Run.AddInput(FImage::Make(Width, Height, Texel), Format, Name).Texture;
	};
	FSceneTextures SceneTextures;
	SceneTextures.Color = Run.Input.Texture;
	SceneTextures.Depth = Add(PF_R32_FLOAT, TEXT("Depth"),
		[](int X, int Y) {
			return FTexel{10.0 / (100 + 10 * X + Y), 0, 0, 0};
		});
	SceneTextures.GBufferB = Add(PF_B8G8R8A8, TEXT("GBufferB"),
		[](int X, int) {
			return FTexel{0, 0.5, 0.5, (X < Width / 2 ? 0x80 | 8 : 1) / 255.0};
		});
	SceneTextures.GBufferC = Add(PF_A32B32G32R32F, TEXT("GBufferC"),
		[](int X, int) {
			return FTexel{X / 8.0, 0, 0, 1};
		});
	SceneTextures.GBufferD = Add(PF_B8G8R8A8, TEXT("GBufferD"), [](int, int) { return FTexel{0, 0, 1, 0}; });
	Run.View.SceneTextures = &SceneTextures;

	const FRDGTextureDesc Desc = FRDGTextureDesc::Create2D(
		FIntPoint(Width, Height), PF_A32B32G32R32F, FClearValueBinding::None, TexCreate_UAV | TexCreate_ShaderResource);
	FRDGTextureRef Color = Run.GraphBuilder.CreateTexture(Desc, TEXT("Color"));
	FRDGTextureRef GBuffer = Run.GraphBuilder.CreateTexture(Desc, TEXT("GBuffer"));

	auto* Parameters = Run.GraphBuilder.AllocParameters<FSceneTexturesProbeCS::FParameters>();
	Parameters->View = Run.View.ViewUniformBuffer;
	Parameters->SceneTextures = CreateSceneTextureShaderParameters(Run.GraphBuilder, Run.View, Mode);
	Parameters->OutColor = Run.GraphBuilder.CreateUAV(Color);
	Parameters->OutGBuffer = Run.GraphBuilder.CreateUAV(GBuffer);
	TShaderMapRef<FSceneTexturesProbeCS> ComputeShader(Run.View.ShaderMap);
	FComputeShaderUtils::AddPass(Run.GraphBuilder, RDG_EVENT_NAME("Probe"), ComputeShader, Parameters,
		FComputeShaderUtils::GetGroupCount(FIntPoint(Width, Height), FComputeShaderUtils::kGolden2DGroupSize));

	TRefCountPtr<IPooledRenderTarget> Extracted;
	Run.GraphBuilder.QueueTextureExtraction(GBuffer, &Extracted);
	FProbes Probes;
	Probes.Color = Run.Execute(FScreenPassTexture(Color));
	Probes.GBuffer = ReadTexture(Extracted->GetRHI());
	return Probes;
}

} // namespace

TEST(SceneTextures, ColourAndDepth)
{
	const FProbes Probes = Probe(ESceneTextureSetupMode::All);
	const FImage Color = FImage::Noise(Width, Height);
	EXPECT_EQ(Color.At(4, 3)[1], Probes.Color.At(4, 3)[1]);
	EXPECT_NEAR(100, Probes.Color.At(0, 0)[3], 1e-3);
	EXPECT_NEAR(143, Probes.Color.At(4, 3)[3], 1e-3);
}

TEST(SceneTextures, ShadingModelAndMaterial)
{
	const FProbes Probes = Probe(ESceneTextureSetupMode::All);
	EXPECT_EQ((FTexel{8, 0.125, 1, 1}), Probes.GBuffer.At(1, 2));
	// Default lit has no custom data, whatever the texture holds.
	EXPECT_EQ((FTexel{1, 0.625, 1, 0}), Probes.GBuffer.At(5, 2));
}

TEST(SceneTextures, PartsNotAskedForReadAsDummies)
{
	const FProbes Probes = Probe(ESceneTextureSetupMode::SceneColor);
	EXPECT_EQ(FImage::Noise(Width, Height).At(4, 3)[1], Probes.Color.At(4, 3)[1]);
	EXPECT_EQ((FTexel{0, 0, 1, 0}), Probes.GBuffer.At(1, 2));
}
