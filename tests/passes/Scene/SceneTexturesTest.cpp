// Scene textures through their uniform buffer: what a shader reads of present and absent ones.
#include "PassTestUtils.h"

#include "GlobalShader.h"
#include "RenderGraphObserver.h"
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

/** The same parameters for the probes that write one picture. */
BEGIN_SHADER_PARAMETER_STRUCT(FSmallProbeParameters, )
	SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
	SHADER_PARAMETER_STRUCT_INCLUDE(FSceneTextureShaderParameters, SceneTextures)
	SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutColor)
END_SHADER_PARAMETER_STRUCT()

class FShadingModelProbeCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FShadingModelProbeCS);
	SHADER_USE_PARAMETER_STRUCT(FShadingModelProbeCS, FGlobalShader);
	using FParameters = FSmallProbeParameters;
};

class FVelocityProbeCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FVelocityProbeCS);
	SHADER_USE_PARAMETER_STRUCT(FVelocityProbeCS, FGlobalShader);
	using FParameters = FSmallProbeParameters;
};

IMPLEMENT_GLOBAL_SHADER(FShadingModelProbeCS, "/DrydockTests/SceneTexturesProbe.usf", "ShadingModelCS", SF_Compute);
IMPLEMENT_GLOBAL_SHADER(FVelocityProbeCS, "/DrydockTests/SceneTexturesProbe.usf", "VelocityCS", SF_Compute);

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

/** Notes which textures a graph wants filled: "Name" where it is read, "Name?" where it may be. */
class FLoadObserver final : public Drydock::IRDGObserver
{
public:
	void OnLoadExternals(const std::vector<Drydock::FRDGExternalLoad>& Loads) override
	{
		for (const Drydock::FRDGExternalLoad& Load : Loads)
		{
			Log += std::string(Load.Texture->Name) + (Load.bIsRead ? " " : "? ");
		}
	}

	std::string Log;
};

/** Scene textures whose GBufferA and GBufferB are there, default lit (1) and a normal along X. */
struct FSmallProbe
{
	FSmallProbe()
		: Run(FImage(Width, Height), EArithmetic::Float32, PF_A32B32G32R32F)
	{
		AddShaderSourceDirectoryMapping(TEXT("/DrydockTests"), TEXT(DRYDOCK_TEST_SOURCE_DIR "/tests/Shaders"));
		SceneTextures.GBufferA =
			Run.AddInput(FImage(Width, Height, {1, 0.5, 0.5, 0}), PF_B8G8R8A8, TEXT("GBufferA")).Texture;
		SceneTextures.GBufferB =
			Run.AddInput(FImage(Width, Height, {0, 0, 0, 1 / 255.0}), PF_B8G8R8A8, TEXT("GBufferB")).Texture;
		Run.View.SceneTextures = &SceneTextures;
		Run.GraphBuilder.SetObserver(&Observer);
		Color = Run.GraphBuilder.CreateTexture(FRDGTextureDesc::Create2D(FIntPoint(Width, Height), PF_A32B32G32R32F,
												   FClearValueBinding::None, TexCreate_UAV | TexCreate_ShaderResource),
			TEXT("Color"));
		Parameters = Run.GraphBuilder.AllocParameters<FSmallProbeParameters>();
		Parameters->View = Run.View.ViewUniformBuffer;
		Parameters->SceneTextures = CreateSceneTextureShaderParameters(Run.GraphBuilder, Run.View);
		Parameters->OutColor = Run.GraphBuilder.CreateUAV(Color);
	}

	template<typename TShader>
	FImage Execute()
	{
		TShaderMapRef<TShader> ComputeShader(Run.View.ShaderMap);
		FComputeShaderUtils::AddPass(Run.GraphBuilder, RDG_EVENT_NAME("Probe"), ComputeShader, Parameters,
			FComputeShaderUtils::GetGroupCount(FIntPoint(Width, Height), FComputeShaderUtils::kGolden2DGroupSize));
		return Run.Execute(FScreenPassTexture(Color));
	}

	FPassRun Run;
	FSceneTextures SceneTextures;
	FLoadObserver Observer;
	FRDGTextureRef Color;
	FSmallProbeParameters* Parameters;
};

} // namespace

TEST(SceneTextures, OneByOneTheyAreThoseOfTheUniformBuffer)
{
	FPassRun Run(FImage::Noise(Width, Height), EArithmetic::Float32, PF_A32B32G32R32F);
	FSceneTextures SceneTextures;
	SceneTextures.Color = Run.Input.Texture;
	SceneTextures.GBufferB = Run.Input.Texture;
	Run.View.SceneTextures = &SceneTextures;
	const FSceneTextureParameters OfTextures = GetSceneTextureParameters(Run.GraphBuilder, SceneTextures);
	const FSceneTextureParameters OfView = GetSceneTextureParameters(Run.GraphBuilder, Run.View);
	const FSceneTextureParameters OfBuffer =
		GetSceneTextureParameters(Run.GraphBuilder, CreateSceneTextureUniformBuffer(Run.GraphBuilder, Run.View));
	for (const FSceneTextureParameters& Parameters : {OfTextures, OfView, OfBuffer})
	{
		EXPECT_EQ(Run.Input.Texture, Parameters.GBufferBTexture);
		EXPECT_STREQ("BlackDummy", Parameters.GBufferATexture->Name);
		EXPECT_STREQ("BlackDummy", Parameters.SceneDepthTexture->Name);
		EXPECT_NE(nullptr, Parameters.SceneStencilTexture);
	}
	Run.GraphBuilder.Discard();
}

TEST(SceneTextures, OnlyWhatTheShaderReadsIsLoaded)
{
	FSmallProbe Probe;
	EXPECT_EQ(1, Probe.Execute<FShadingModelProbeCS>().At(3, 2)[0]);
	EXPECT_EQ("GBufferB ", Probe.Observer.Log);
}

TEST(SceneTextures, ALambdaMayReadAllThatItsUniformBufferNames)
{
	FSmallProbe Probe;
	Probe.Run.GraphBuilder.AddPass(RDG_EVENT_NAME("Raw"), Probe.Parameters, ERDGPassFlags::Compute,
		[Color = Probe.Color](FRHIComputeCommandList&) { Color->GetRHI()->Fill(FLinearColor(2, 2, 2, 2)); });
	EXPECT_EQ(2, Probe.Run.Execute(FScreenPassTexture(Probe.Color)).At(0, 0)[0]);
	EXPECT_NE(std::string::npos, Probe.Observer.Log.find("GBufferA? GBufferB? ")) << Probe.Observer.Log;
}

TEST(SceneTextures, VelocityComesBackFromItsEncoding)
{
	FSmallProbe Probe;
	const FImage Velocity = Probe.Execute<FVelocityProbeCS>();
	EXPECT_NEAR(-2, Velocity.At(0, 0)[0], 1e-5);
	EXPECT_EQ(0, Velocity.At(2, 0)[0]);
	EXPECT_NEAR(1.5, Velocity.At(3, 3)[1], 1e-5);
	// Stored: sqrt(2 * 2) * 0.499 / 2 below the bias 32767/65535.
	EXPECT_NEAR(0.4999924 - 0.499, Velocity.At(0, 0)[2], 1e-6);
}

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
