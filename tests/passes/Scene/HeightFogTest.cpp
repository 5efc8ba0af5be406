// Height fog against its density, added up along the ray.
#include "PassTestUtils.h"

#include "FogRendering.h"
#include "GlobalShader.h"
#include "RenderGraphUtils.h"
#include "ShaderCore.h"
#include "ShaderParameterStruct.h"

using namespace PassTest;

namespace
{

class FFogProbeCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FFogProbeCS);
	SHADER_USE_PARAMETER_STRUCT(FFogProbeCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_REF(FFogUniformParameters, FogStruct)
		SHADER_PARAMETER_ARRAY(FVector4f, Points, [8])
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutTexture)
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FFogProbeCS, "/DrydockTests/FogProbe.usf", "MainCS", SF_Compute);

} // namespace

TEST(EngineIncludes, HeightFogIsTheIntegralOfItsDensity)
{
	AddShaderSourceDirectoryMapping(TEXT("/DrydockTests"), TEXT(DRYDOCK_TEST_SOURCE_DIR "/tests/Shaders"));
	FPassRun Run(FImage(1, 1), EArithmetic::Float32);
	FRDGTextureRef Output =
		Run.GraphBuilder.CreateTexture(FRDGTextureDesc::Create2D(FIntPoint(8, 1), PF_A32B32G32R32F,
										   FClearValueBinding::None, TexCreate_UAV | TexCreate_ShaderResource),
			TEXT("Fog"));
	FFogUniformParameters Fog;
	Fog.ExponentialFogParameters = FVector4f(4e-4f, 2e-3f, 0.0f, 100.0f);
	Fog.ExponentialFogParameters2 = FVector4f(1e-4f, 5e-4f, 0.0f, 0.0f);
	Fog.ExponentialFogColorParameter = FVector4f(0.5f, 0.75f, 1.0f, 0.01f);
	Fog.ExponentialFogParameters3 = FVector4f(0.0f, 0.0f, 0.0f, 0.0f);
	Fog.InscatteringLightDirection = FVector4f(0.0f, 0.0f, 1.0f, -1.0f);
	Fog.DirectionalInscatteringColor = FVector4f(0.0f, 0.0f, 0.0f, 1.0f);
	const FVector4f Points[8] = {{1000, 0, 0, 0}, {1000, 500, 1500, 0}, {2000, 0, -800, 0}, {50, 0, 0, 0},
		{0, 3000, 20, 0}, {0, 0, 4000, 0}, {9000, 0, 0, 0}, {400, -300, 200, 0}};
	FFogProbeCS::FParameters* Parameters = Run.GraphBuilder.AllocParameters<FFogProbeCS::FParameters>();
	Parameters->FogStruct =
		TUniformBufferRef<FFogUniformParameters>::CreateUniformBufferImmediate(Fog, UniformBuffer_SingleFrame);
	for (int i = 0; i < 8; ++i)
	{
		Parameters->Points[i] = Points[i];
	}
	Parameters->OutTexture = Run.GraphBuilder.CreateUAV(Output);
	TShaderMapRef<FFogProbeCS> ComputeShader(Run.View.ShaderMap);
	FComputeShaderUtils::AddPass(
		Run.GraphBuilder, RDG_EVENT_NAME("Fog"), ComputeShader, Parameters, FIntVector(8, 1, 1));
	const FImage Image = Run.Execute(FScreenPassTexture(Output));
	for (int i = 0; i < 8; ++i)
	{
		// The density added up along the ray in short steps, from 100 cm on.
		const double X = Points[i].X, Y = Points[i].Y, Z = Points[i].Z;
		const double Length = std::sqrt(X * X + Y * Y + Z * Z);
		constexpr int NumSteps = 20000;
		const double Step = std::max(0.0, Length - 100.0) / NumSteps;
		double Depth = 0.0;
		for (int s = 0; s < NumSteps; ++s)
		{
			const double Height = Z / Length * (100.0 + (s + 0.5) * Step);
			Depth += Step * (4e-4 * std::exp2(-2e-3 * Height) + 1e-4 * std::exp2(-5e-4 * Height));
		}
		// The engine's density is per halving: ln 2 times the integral, in powers of 2.
		const double Transmittance = std::max(0.01, std::exp2(-std::log(2.0) * Depth));
		EXPECT_NEAR(Transmittance, Image.At(i, 0)[3], 2e-5) << i;
		EXPECT_NEAR(0.75 * (1 - Transmittance), Image.At(i, 0)[1], 2e-5) << i;
	}
}
