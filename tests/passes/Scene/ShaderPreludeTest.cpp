// The shader prelude: every header compiles alone in both stages, and its functions give their values.
#include "PassTestUtils.h"

#include "GlobalShader.h"
#include "RenderGraphUtils.h"
#include "ShaderCompilation.h"
#include "ShaderCompiler.h"
#include "ShaderCore.h"
#include "ShaderParameterStruct.h"

#include <filesystem>
#include <fstream>

using namespace PassTest;

namespace
{

class FPreludeProbeCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FPreludeProbeCS);
	SHADER_USE_PARAMETER_STRUCT(FPreludeProbeCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER(FVector4f, A)
		SHADER_PARAMETER(FVector4f, B)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutTexture)
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FPreludeProbeCS, "/DrydockTests/PreludeProbe.usf", "MainCS", SF_Compute);

constexpr int NumProbes = 14;

/** All probes for two sets of arguments. */
FImage Probe(const FVector4f& A, const FVector4f& B)
{
	AddShaderSourceDirectoryMapping(TEXT("/DrydockTests"), TEXT(DRYDOCK_TEST_SOURCE_DIR "/tests/Shaders"));
	FPassRun Run(FImage(1, 1), EArithmetic::Float32);
	const FRDGTextureDesc Desc = FRDGTextureDesc::Create2D(
		FIntPoint(NumProbes, 1), PF_A32B32G32R32F, FClearValueBinding::None, TexCreate_UAV | TexCreate_ShaderResource);
	FRDGTextureRef Output = Run.GraphBuilder.CreateTexture(Desc, TEXT("Probes"));

	FPreludeProbeCS::FParameters* Parameters = Run.GraphBuilder.AllocParameters<FPreludeProbeCS::FParameters>();
	Parameters->A = A;
	Parameters->B = B;
	Parameters->OutTexture = Run.GraphBuilder.CreateUAV(Output);
	TShaderMapRef<FPreludeProbeCS> ComputeShader(Run.View.ShaderMap);
	FComputeShaderUtils::AddPass(
		Run.GraphBuilder, RDG_EVENT_NAME("Probe"), ComputeShader, Parameters, FIntVector(NumProbes, 1, 1));
	return Run.Execute(FScreenPassTexture(Output));
}

void ExpectProbe(const FTexel& Expected, const FImage& Probes, int Index)
{
	for (int Channel = 0; Channel < 4; ++Channel)
	{
		EXPECT_NEAR(Expected[Channel], Probes.At(Index, 0)[Channel], 1e-6 * std::max(1.0, std::abs(Expected[Channel])))
			<< "probe " << Index << "." << Channel;
	}
}

const FImage& CommonProbes()
{
	static const FImage Probes =
		Probe(FVector4f(2, 3, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()),
			FVector4f(0.5f, 0.25f, 0.75f, -1));
	return Probes;
}

} // namespace

TEST(ShaderPrelude, EveryHeaderCompilesAloneInBothStages)
{
	namespace fs = std::filesystem;
	const fs::path Engine = DRYDOCK_TEST_SOURCE_DIR "/rdg/graph/Shaders/Engine";
	const fs::path Folder = fs::path(DRYDOCK_TEST_BINARY_DIR) / "PreludeShaders";
	fs::create_directories(Folder);
	AddShaderSourceDirectoryMapping(TEXT("/PreludeShaders"), FString(Folder.c_str()));

	const Drydock::FShaderRef Probe(FPreludeProbeCS::GetStaticType().FindOrCreateShader(0));
	int Headers = 0;
	for (const fs::directory_entry& Entry : fs::recursive_directory_iterator(Engine))
	{
		if (Entry.path().extension() != ".ush")
		{
			continue;
		}
		const std::string Virtual = "/Engine/" + fs::relative(Entry.path(), Engine).generic_string();
		const std::string Name = Entry.path().stem().string() + ".usf";
		std::ofstream(Folder / Name)
			<< "#include \"" << Virtual << "\"\n"
			<< "RWTexture2D<float4> Out;\n"
			<< "[numthreads(8, 8, 1)] void MainCS(uint2 Id : SV_DispatchThreadID) { Out[Id] = 1.0f; }\n"
			<< "float4 MainPS(float4 Position : SV_POSITION) : SV_Target0 { return Position; }\n";
		for (const Drydock::EShaderStage Stage : {Drydock::EShaderStage::Compute, Drydock::EShaderStage::Pixel})
		{
			// As a shader class asks: any registered uniform buffer may be named.
			Drydock::FShaderCompileRequest Request =
				Drydock::MakeShaderCompileRequest(Probe, FPreludeProbeCS::GetRootParametersMetadata());
			Request.VirtualPath = "/PreludeShaders/" + Name;
			Request.EntryPoint = Stage == Drydock::EShaderStage::Compute ? "MainCS" : "MainPS";
			Request.Stage = Stage;
			EXPECT_NO_THROW(Drydock::ReflectShader(Request)) << Virtual;
		}
		++Headers;
	}
	EXPECT_GE(Headers, 16);
}

TEST(ShaderPrelude, Powers)
{
	ExpectProbe({4, 8, 16, 32}, CommonProbes(), 0);
	ExpectProbe({std::sqrt(2.0), std::sqrt(2.0), 0, 0}, CommonProbes(), 1);
}

TEST(ShaderPrelude, FiniteGuards)
{
	ExpectProbe({2, 0, 65504, 0}, CommonProbes(), 2);
	ExpectProbe({2, -2, 65504, 0}, CommonProbes(), 3);
}

TEST(ShaderPrelude, GuardedDivision)
{
	ExpectProbe({0.5, 0, 7, 0}, CommonProbes(), 4);
	ExpectProbe({1, 0, 0, 13}, CommonProbes(), 5);
}

TEST(ShaderPrelude, MinimaAndMaxima)
{
	ExpectProbe({0.5, 3, 0.25, 3}, CommonProbes(), 6);
}

TEST(ShaderPrelude, LuminanceAndMasks)
{
	ExpectProbe({0.3 * 2 + 0.59 * 3 + 0.11 * 0.5, 1 - 0.0625 - 0.5625, 0.75, 0.25}, CommonProbes(), 7);
}

TEST(ShaderPrelude, Srgb)
{
	ExpectProbe({1.055 * std::pow(0.5, 1 / 2.4) - 0.055, 12.92e-3, std::pow((0.25 + 0.055) / 1.055, 2.4), 0.01 / 12.92},
		CommonProbes(), 8);
}

TEST(ShaderPrelude, ScreenTransforms)
{
	ExpectProbe({2 * 0.5 + 0.75, 3 * 0.25 - 1, 2 * 0.5 + 0.75, 3 * 0.25 - 1}, CommonProbes(), 9);
	ExpectProbe({0, 0.5, 0.75, 0.375}, CommonProbes(), 10);
}

TEST(ShaderPrelude, ShadingModelsAndNormals)
{
	ExpectProbe({8, 128, 2, 3}, CommonProbes(), 11);
}

TEST(ShaderPrelude, NoiseIsInTheUnitInterval)
{
	const FTexel Probe = CommonProbes().At(12, 0);
	EXPECT_TRUE(Probe[0] >= 0 && Probe[0] < 1);
	EXPECT_TRUE(Probe[1] >= 0 && Probe[1] < 1);
	EXPECT_NEAR(1.099 * std::pow(0.25, 0.45) - 0.099, Probe[2], 1e-6);
	EXPECT_EQ(0, Probe[3]);
}

TEST(ShaderPrelude, HashMatchesIntegerArithmetic)
{
	uint32_t X = 1 * 1664525u + 1013904223u, Y = 2 * 1664525u + 1013904223u, Z = 3 * 1664525u + 1013904223u;
	const auto Mix = [&]
	{
		X += Y * Z;
		Y += Z * X;
		Z += X * Y;
	};
	Mix();
	uint32_t X32 = X ^ (X >> 16), Y32 = Y ^ (Y >> 16), Z32 = Z ^ (Z >> 16);
	Mix();
	X32 += Y32 * Z32;
	ExpectProbe({static_cast<double>(X >> 16), static_cast<double>(Y >> 16), static_cast<double>(Z >> 16),
					static_cast<double>(X32 >> 16)},
		CommonProbes(), 13);
}
