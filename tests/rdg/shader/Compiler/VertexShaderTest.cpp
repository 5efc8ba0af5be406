// Vertex shaders from HLSL to positions and TEXCOORDs, and what of them is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ShaderHarness.h"

#include <cmath>
#include <cstdlib>
#include <random>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

FShaderCompileRequest MakeRequest(const std::string& Text, const std::string& EntryPoint = "Main")
{
	return FShaderHarness(Text, EntryPoint, EShaderStage::Vertex).Request;
}

FVertexOutput RunVertex(
	const FShaderCompileRequest& Request, const FVertexInput& Input, const std::vector<float>& Loose = {})
{
	const std::shared_ptr<const FCompiledShader> Shader = CompileShader(Request);
	EXPECT_EQ(nullptr, Shader->Run);
	std::vector<std::vector<uint8_t>> Constants;
	std::vector<const uint8_t*> Pointers;
	for (const FShaderConstantBuffer& Buffer : Shader->Reflection.ConstantBuffers)
	{
		Constants.emplace_back(Buffer.Size, uint8_t(0));
		std::memcpy(Constants.back().data(), Loose.data(), std::min<size_t>(Buffer.Size, Loose.size() * 4));
	}
	for (const std::vector<uint8_t>& Data : Constants)
	{
		Pointers.push_back(Data.data());
	}
	FKernelArgs Args = {};
	Args.ConstantBuffers = Pointers.data();
	return Shader->Vertex->Run(Args, Input);
}

std::string ErrorsOf(const std::string& Text)
{
	return ErrorOf([&] { ReflectShader(MakeRequest(Text)); });
}

} // namespace

TEST(VertexShader, ReadsAttributesNumbersAndConstants)
{
	const FShaderCompileRequest Request = MakeRequest(R"(
float4 Offset;
float Scale;
float4 Main(float4 Position : ATTRIBUTE0, float2 UV : ATTRIBUTE3, uint Bits : ATTRIBUTE1, uint Id : SV_VertexID,
	uint Instance : SV_InstanceID, out float3 A : TEXCOORD2) : SV_POSITION
{
	A = float3(UV * Scale, Id * 10 + Instance);
	return Position * Scale + Offset + (Bits >> 1);
})");
	std::mt19937 Random(3);
	std::uniform_real_distribution<float> Values(-2, 2);
	for (uint32_t Round = 0; Round < 20; ++Round)
	{
		FVertexInput Input;
		Input.VertexId = Round;
		Input.InstanceId = Round % 3;
		for (int i = 0; i < 4; ++i)
		{
			Input.Attributes[0][i] = double(Values(Random));
			Input.Attributes[3][i] = double(Values(Random));
		}
		Input.Attributes[1][0] = 5 + Round;
		const std::vector<float> Loose = {
			Values(Random), Values(Random), Values(Random), Values(Random), Values(Random)};
		const FVertexOutput Output = RunVertex(Request, Input, Loose);
		for (int i = 0; i < 4; ++i)
		{
			const double Expected =
				Input.Attributes[0][i] * double(Loose[4]) + double(Loose[size_t(i)]) + (5 + Round) / 2;
			EXPECT_NEAR(Expected, Output.Position[i], 1e-5);
		}
		EXPECT_FLOAT_EQ(float(Input.Attributes[3][0]) * Loose[4], Output.TexCoords[2][0]);
		EXPECT_FLOAT_EQ(float(Input.Attributes[3][1]) * Loose[4], Output.TexCoords[2][1]);
		EXPECT_EQ(float(Round * 10 + Round % 3), Output.TexCoords[2][2]);
		EXPECT_EQ(0, Output.TexCoords[2][3]);
	}
	const std::shared_ptr<const FCompiledShader> Shader = CompileShader(Request);
	EXPECT_EQ(1u | 2u | 8u, Shader->Vertex->GetAttributesRead());
	EXPECT_EQ(4u, Shader->Vertex->GetTexCoordsWritten());
	EXPECT_EQ(EShaderStage::Vertex, Shader->Reflection.Stage);
	EXPECT_EQ(3, Shader->Reflection.NumInterpolants);
}

TEST(VertexShader, ElementsOfArraysHaveTexCoordsOfTheirOwn)
{
	const FShaderCompileRequest Request = MakeRequest(R"(
struct FOut { float2 UV[3] : TEXCOORD1; float4 Position : SV_POSITION; };
FOut Main(float4 Position : ATTRIBUTE, out float4 More[2] : TEXCOORD5)
{
	FOut Out;
	Out.Position = Position;
	[unroll] for (int i = 0; i < 3; ++i) Out.UV[i] = float2(i, Position.x);
	More[0] = 50;
	More[1] = 60;
	return Out;
})");
	FVertexInput Input;
	Input.Attributes[0][0] = 0.5;
	const FVertexOutput Output = RunVertex(Request, Input);
	for (int i = 0; i < 3; ++i)
	{
		EXPECT_EQ(float(i), Output.TexCoords[1 + i][0]);
		EXPECT_EQ(0.5f, Output.TexCoords[1 + i][1]);
	}
	EXPECT_EQ(50, Output.TexCoords[5][3]);
	EXPECT_EQ(60, Output.TexCoords[6][0]);
	EXPECT_EQ(0xEu | 0x60u, CompileShader(Request)->Vertex->GetTexCoordsWritten());
}

TEST(VertexShader, ColoursAndIntegersAreHandedOn)
{
	const FShaderCompileRequest Request = MakeRequest(R"(
float4 Main(uint Id : SV_VertexID, out float4 C : COLOR1, nointerpolation out uint2 A : TEXCOORD3,
	nointerpolation out int B : TEXCOORD4) : SV_POSITION
{
	C = float4(0.5, 1, 2, Id);
	A = uint2(0xFFFFFFFFu - Id, 16777217);
	B = -2147483647 + (int)Id;
	return 1;
})");
	FVertexInput Input;
	Input.VertexId = 2;
	const FVertexOutput Output = RunVertex(Request, Input);
	EXPECT_EQ(0.5, Output.TexCoords[GMaxTexCoords + 1][0]);
	EXPECT_EQ(2, Output.TexCoords[GMaxTexCoords + 1][3]);
	EXPECT_EQ(4294967293.0, Output.TexCoords[3][0]);
	EXPECT_EQ(16777217.0, Output.TexCoords[3][1]);
	EXPECT_EQ(-2147483645.0, Output.TexCoords[4][0]);
	const std::shared_ptr<const FCompiledShader> Shader = CompileShader(Request);
	EXPECT_EQ(1u << 17 | 1u << 3 | 1u << 4, Shader->Vertex->GetTexCoordsWritten());
	EXPECT_EQ(1u << 3 | 1u << 4, Shader->Reflection.IntegerInterpolants);
}

TEST(VertexShader, OutputsOfAnyNameAreHandedOn)
{
	const FShaderCompileRequest Request = MakeRequest(R"(
struct FOut { float4 Position : SV_POSITION; float3 Normal : NORMAL; nointerpolation uint Id : IDENTITY; };
FOut Main(uint Id : SV_VertexID, out float4 More[2] : COLOR3)
{
	FOut Out = {1, 1, 1, 1, 2, 3, 4, Id + 7};
	More[0] = 50;
	More[1] = 60;
	return Out;
})");
	FVertexInput Input;
	Input.VertexId = 4294967280u;
	const FVertexOutput Output = RunVertex(Request, Input);
	const std::shared_ptr<const FCompiledShader> Shader = CompileShader(Request);
	const std::vector<std::string>& Named = Shader->Reflection.NamedInterpolants;
	ASSERT_EQ((std::vector<std::string>{"", "COLOR4", "NORMAL0", "IDENTITY0"}), Named);
	const auto At = [&](const std::string& Name)
	{
		return GFirstNamedInterpolant + (std::find(Named.begin(), Named.end(), Name) - Named.begin());
	};
	EXPECT_EQ(4, Output.TexCoords[At("NORMAL0")][2]);
	EXPECT_EQ(4294967287.0, Output.TexCoords[At("IDENTITY0")][0]);
	EXPECT_EQ(50, Output.TexCoords[19][0]);
	EXPECT_EQ(60, Output.TexCoords[At("COLOR4")][0]);
	EXPECT_EQ(1u << 19 | 7u << 21, Shader->Vertex->GetTexCoordsWritten());
	EXPECT_EQ(1u << At("IDENTITY0"), Shader->Reflection.IntegerInterpolants);
}

TEST(VertexShader, APixelShaderReadsTheSameElements)
{
	FShaderHarness Harness("struct FIn { float2 UV[3] : TEXCOORD1; };\n"
						   "float4 Main(FIn In) : SV_Target0 { return float4(In.UV[0], In.UV[1].x, In.UV[2].y); }\n",
		"Main", EShaderStage::Pixel);
	for (int i = 0; i < 4; ++i)
	{
		Harness.Interpolants[i].Base[0] = 10 * i;
		Harness.Interpolants[i].Base[1] = 10 * i + 1;
	}
	Harness.Targets.emplace_back(1, 1);
	for (const bool bModel : {false, true})
	{
		bModel ? Harness.RunModel(1, 1) : void(Harness.Run(4, 1, 1));
		const float* const Texel = Harness.Targets[0].Texel(0, 0);
		EXPECT_EQ(10, Texel[0]);
		EXPECT_EQ(11, Texel[1]);
		EXPECT_EQ(20, Texel[2]);
		EXPECT_EQ(31, Texel[3]);
	}
}

TEST(VertexShader, IsCompiledAsOne)
{
	const FVertexOutput Output = RunVertex(
		MakeRequest("float4 Main() : SV_POSITION { return float4(VERTEXSHADER, PIXELSHADER, COMPUTESHADER, 1); }"), {});
	EXPECT_EQ(1, Output.Position[0]);
	EXPECT_EQ(0, Output.Position[1]);
	EXPECT_EQ(0, Output.Position[2]);
}

TEST(VertexShader, ComesFromTheCacheWithoutAFrontEnd)
{
	const FShaderCompileRequest Request =
		MakeRequest("// kept\nfloat4 Main(float4 P : ATTRIBUTE0) : SV_POSITION { return P * 3; }");
	FVertexInput Input;
	Input.Attributes[0][1] = 2;
	EXPECT_EQ(6, RunVertex(Request, Input).Position[1]);
	ForgetCompiledShaders();
	const int64_t Before = GetNumCompiledTexts();
	EXPECT_EQ(6, RunVertex(Request, Input).Position[1]);
	EXPECT_EQ(Before, GetNumCompiledTexts());
}

TEST(VertexShader, WhatNobodyFeedsOrReadsIsRefusedByName)
{
	using testing::HasSubstr;
	EXPECT_THAT(ErrorsOf("float4 Main(float4 Where : POSITION) : SV_POSITION { return Where; }"),
		HasSubstr(
			"vertex input 'Where' has the semantic POSITION0, which no vertex declaration feeds; use ATTRIBUTEn"));
	EXPECT_THAT(ErrorsOf("float4 Main(out uint L : SV_RenderTargetArrayIndex) : SV_POSITION { L = 1; return 0; }"),
		HasSubstr("vertex output 'L' (SV_RENDERTARGETARRAYINDEX, uint) is not supported"));
	EXPECT_THAT(ErrorsOf("float4 Main(out double2 M : TEXCOORD0) : SV_POSITION { M = 1; return 0; }"),
		HasSubstr("(TEXCOORD0, double2)"));
	EXPECT_THAT(ErrorsOf("float4 Main(out float4 C[13] : NORMAL) : SV_POSITION { C[12] = 1; return 0; }"),
		HasSubstr("'C[12]' (NORMAL12, float4) is not supported on the CPU tier; outputs are SV_POSITION"));
	EXPECT_THAT(ErrorsOf("float4 Main(float4 P : ATTRIBUTE0) : TEXCOORD0 { return P; }"),
		HasSubstr("the vertex shader writes no SV_POSITION"));
}

TEST(VertexShader, ThatDoesNotEndIsAMessage)
{
	FVertexInput Input;
	Input.Attributes[0][0] = 1;
	const FShaderCompileRequest Request = MakeRequest(
		"float4 Main(float4 P : ATTRIBUTE0) : SV_POSITION { [loop] while (P.x > 0) P.x *= 1.5f; return P; }");
	EXPECT_THAT(ErrorOf([&] { RunVertex(Request, Input); }), testing::HasSubstr("did not end"));
}
