// A shader says of its parameters what its HLSL declares.
#include <gtest/gtest.h>

#include "ShaderCache.h"
#include "ShaderHarness.h"

#include <algorithm>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

FShaderReflection Reflect(const std::string& Text, EShaderStage Stage = EShaderStage::Compute)
{
	return ReflectShader(FShaderHarness(Text, "Main", Stage).Request);
}

/** Globals and one expression that uses them. */
FShaderReflection ReflectUse(const std::string& Globals, const std::string& Expression)
{
	return Reflect(
		Globals +
		"\nRWTexture2D<float4> Out;\n[numthreads(8, 4, 2)] void Main(uint3 Id : SV_DispatchThreadID) { Out[Id.xy] = " +
		Expression + "; }\n");
}

const FShaderConstant& Find(const FShaderReflection& Reflection, const std::string& Name)
{
	const auto Found = std::find_if(Reflection.Constants.begin(), Reflection.Constants.end(),
		[&](const FShaderConstant& C) { return C.Name == Name; });
	EXPECT_NE(Reflection.Constants.end(), Found) << Name;
	static const FShaderConstant None;
	return Found == Reflection.Constants.end() ? None : *Found;
}

int32_t TapsOf(const std::string& Body)
{
	return Reflect("Texture2D T; SamplerState S; int K; RWTexture2D<float4> Out;\n[numthreads(8, 8, 1)] void "
				   "Main(uint3 Id : SV_DispatchThreadID) { float2 UV = Id.xy * 0.1; float4 C = 0;\n" +
				   Body + "\nOut[Id.xy] = C; }\n")
		.StaticSamples;
}

} // namespace

TEST(ShaderReflection, GroupSizeIsThatOfNumthreads)
{
	const FShaderReflection Reflection = ReflectUse("", "1");
	EXPECT_EQ(8, Reflection.GroupSize[0]);
	EXPECT_EQ(4, Reflection.GroupSize[1]);
	EXPECT_EQ(2, Reflection.GroupSize[2]);
	EXPECT_EQ(EShaderStage::Compute, Reflection.Stage);
}

TEST(ShaderReflection, LooseGlobalsFollowThePackingOfHlsl)
{
	const FShaderReflection Reflection = ReflectUse("float A; float3 B; float2 C; float4 D;", "A + B.x + C.x + D");
	EXPECT_EQ("$Global", Reflection.ConstantBuffers.at(0).Name);
	EXPECT_EQ(48u, Reflection.ConstantBuffers.at(0).Size);
	EXPECT_EQ(0u, Find(Reflection, "A").Offset);
	EXPECT_EQ(4u, Find(Reflection, "B").Offset);  // fits behind A
	EXPECT_EQ(16u, Find(Reflection, "C").Offset); // would cross a register
	EXPECT_EQ(32u, Find(Reflection, "D").Offset);
}

TEST(ShaderReflection, ScalarsFollowTheLastElementOfAnArray)
{
	const FShaderReflection Reflection =
		ReflectUse("float A[3]; float B; float3x3 C; float D;", "A[2] + B + C[0][0] + D");
	EXPECT_EQ(36u, Find(Reflection, "B").Offset); // 2 * 16 + 4
	EXPECT_EQ(48u, Find(Reflection, "C").Offset);
	EXPECT_EQ(92u, Find(Reflection, "D").Offset); // 48 + 2 * 16 + 12
}

TEST(ShaderReflection, StructuredBuffersAreTightlyPacked)
{
	const FShaderReflection Reflection =
		ReflectUse("struct FE { float A; float3 B; float2 C; float3x3 M; float F[3]; }; StructuredBuffer<FE> S;",
			"S[Id.x].A + S[Id.x].B.x + S[Id.x].M[1][1] + S[Id.x].F[2]");
	EXPECT_EQ(uint32_t(4 + 12 + 8 + 36 + 12), Reflection.Buffers.at(0).Stride);
}

TEST(ShaderReflection, UnusedConstantsAreKnown)
{
	const FShaderReflection Reflection = ReflectUse("float Used; float Unused;", "Used");
	EXPECT_TRUE(Find(Reflection, "Used").bUsed);
	EXPECT_FALSE(Find(Reflection, "Unused").bUsed);
	EXPECT_EQ("/Test/Shader.usf:3", Find(Reflection, "Used").Where);
}

TEST(ShaderReflection, ArraysHaveAStrideOfSixteen)
{
	const FShaderConstant Array = Find(ReflectUse("float2 A[3];", "A[Id.x].xyxy"), "A");
	EXPECT_EQ(3, Array.NumElements);
	EXPECT_EQ(2, Array.Columns);
	EXPECT_EQ(16u, Array.ArrayStride);
}

TEST(ShaderReflection, MatricesArePackedByRows)
{
	const FShaderConstant Matrix = Find(ReflectUse("float4x3 A;", "mul(float4(1, 2, 3, 4), A).xyzz"), "A");
	EXPECT_EQ(4, Matrix.Rows);
	EXPECT_EQ(3, Matrix.Columns);
	EXPECT_EQ(16u, Matrix.MatrixStride);
	EXPECT_TRUE(Matrix.bRowMajor);
}

TEST(ShaderReflection, ScalarTypesAreTold)
{
	const FShaderReflection Reflection = ReflectUse("int2 I; uint U; float F;", "I.x + (int)U + F");
	EXPECT_EQ(EShaderScalar::Int, Find(Reflection, "I").Scalar);
	EXPECT_EQ(EShaderScalar::Uint, Find(Reflection, "U").Scalar);
	EXPECT_EQ(EShaderScalar::Float, Find(Reflection, "F").Scalar);
}

TEST(ShaderReflection, WidthsOfTypesAreTold)
{
	const FShaderReflection Reflection = ReflectUse(
		"int64_t L; uint64_t M; double D; float16_t H; int16_t S; uint16_t T; StructuredBuffer<int64_t> Wide; "
		"StructuredBuffer<float16_t2> Narrow;",
		"float(L) + float(M) + float(D) + float(H) + float(S) + float(T) + float(Wide[0]) + float(Narrow[0].x)");
	EXPECT_EQ(EShaderScalar::Long, Find(Reflection, "L").Scalar);
	EXPECT_EQ(EShaderScalar::Ulong, Find(Reflection, "M").Scalar);
	EXPECT_EQ(EShaderScalar::Double, Find(Reflection, "D").Scalar);
	EXPECT_EQ(EShaderScalar::Half, Find(Reflection, "H").Scalar);
	EXPECT_EQ(EShaderScalar::Short, Find(Reflection, "S").Scalar);
	EXPECT_EQ(EShaderScalar::Ushort, Find(Reflection, "T").Scalar);
	ASSERT_EQ(2u, Reflection.Buffers.size());
	EXPECT_EQ(EShaderScalar::Long, Reflection.Buffers[0].Scalar);
	EXPECT_EQ(EShaderScalar::Half, Reflection.Buffers[1].Scalar);
	const std::optional<FShaderReflection> Read = ReflectionFromJson(ReflectionToJson(Reflection));
	ASSERT_TRUE(Read);
	EXPECT_EQ(EShaderScalar::Ulong, Find(*Read, "M").Scalar);
}

TEST(ShaderReflection, ConstantBuffersKeepTheirNames)
{
	const FShaderReflection Reflection = ReflectUse("cbuffer View { float4 View_A; float View_B; };", "View_B");
	ASSERT_EQ(1u, Reflection.ConstantBuffers.size());
	EXPECT_EQ("View", Reflection.ConstantBuffers[0].Name);
	EXPECT_EQ(16u, Find(Reflection, "View_B").Offset);
	EXPECT_FALSE(Find(Reflection, "View_A").bUsed);
}

TEST(ShaderReflection, RowsOfAMatrixAreInputsOneBehindTheOther)
{
	const auto Count = [](const std::string& Row)
	{
		return Reflect(
			"float4 Main(float4x4 M : TEXCOORD1) : SV_Target0 { return M[" + Row + "]; }\n", EShaderStage::Pixel)
			.NumInterpolants;
	};
	EXPECT_EQ(2, Count("0"));
	EXPECT_EQ(4, Count("2"));
}

TEST(ShaderReflection, OnlyUsedResourcesAreListed)
{
	const FShaderReflection Reflection =
		ReflectUse("Texture2D A; Texture2D B; SamplerState S; SamplerState Z;", "A.SampleLevel(S, 0.5, 0)");
	ASSERT_EQ(1u, Reflection.Textures.size());
	EXPECT_EQ("A", Reflection.Textures[0].Name);
	ASSERT_EQ(1u, Reflection.Samplers.size());
	EXPECT_EQ("S", Reflection.Samplers[0].Name);
	ASSERT_EQ(1u, Reflection.RWTextures.size());
	EXPECT_EQ("Out", Reflection.RWTextures[0].Name);
}

TEST(ShaderReflection, BuffersTellKindAndStride)
{
	const FShaderReflection Reflection =
		ReflectUse("struct FE { float3 P; uint K; }; StructuredBuffer<FE> A; ByteAddressBuffer B; Buffer<float4> C; "
				   "RWStructuredBuffer<uint> D; StructuredBuffer<uint> E;",
			"A[Id.x].K + B.Load(4) + C[Id.y] + D[0] + E[1]");
	ASSERT_EQ(4u, Reflection.Buffers.size());
	const auto Buffer = [&](const std::string& Name)
	{
		return *std::find_if(Reflection.Buffers.begin(), Reflection.Buffers.end(),
			[&](const FShaderResource& R) { return R.Name == Name; });
	};
	EXPECT_EQ(EShaderDimension::StructuredBuffer, Buffer("A").Dimension);
	EXPECT_EQ(16u, Buffer("A").Stride);
	EXPECT_EQ(EShaderDimension::ByteAddressBuffer, Buffer("B").Dimension);
	EXPECT_EQ(EShaderDimension::TypedBuffer, Buffer("C").Dimension);
	EXPECT_EQ(EShaderDimension::StructuredBuffer, Buffer("E").Dimension);
	ASSERT_EQ(1u, Reflection.RWBuffers.size());
	EXPECT_EQ(EShaderScalar::Uint, Reflection.RWBuffers[0].Scalar);
}

TEST(ShaderReflection, TexturesTellDimensionAndType)
{
	const FShaderReflection Reflection =
		ReflectUse("Texture2D A; Texture3D B; Texture2D<uint> C; Texture2DArray D; SamplerState S;",
			"A.Load(int3(0, 0, 0)) + B.SampleLevel(S, 0.5, 0) + C.Load(int3(0, 0, 0)).x + D.SampleLevel(S, float3(0, "
			"0, 1), 0)");
	ASSERT_EQ(4u, Reflection.Textures.size());
	const auto Texture = [&](const std::string& Name)
	{
		return *std::find_if(Reflection.Textures.begin(), Reflection.Textures.end(),
			[&](const FShaderResource& R) { return R.Name == Name; });
	};
	EXPECT_EQ(EShaderDimension::Texture2D, Texture("A").Dimension);
	EXPECT_EQ(EShaderDimension::Texture3D, Texture("B").Dimension);
	EXPECT_EQ(EShaderScalar::Uint, Texture("C").Scalar);
	EXPECT_EQ(EShaderDimension::Texture2DArray, Texture("D").Dimension);
}

TEST(ShaderReflection, RWTexturesTellTheirComponents)
{
	const FShaderReflection Reflection = Reflect(
		"RWTexture2D<float2> Out; [numthreads(8, 8, 1)] void Main(uint2 Id : SV_DispatchThreadID) { Out[Id] = 1; }\n");
	EXPECT_EQ(2, Reflection.RWTextures.at(0).NumComponents);
}

TEST(ShaderReflection, TargetsAndInterpolantsAreCounted)
{
	const FShaderReflection Reflection =
		Reflect("void Main(float4 P : SV_POSITION, noperspective float4 A : TEXCOORD1, out float4 X : SV_Target0, out "
				"float4 Y : SV_Target2) { X = A; Y = P; clip(A.x); }\n",
			EShaderStage::Pixel);
	EXPECT_EQ(3, Reflection.NumTargets);
	EXPECT_EQ(0u, Reflection.IntegerTargets);
	EXPECT_EQ(2, Reflection.NumInterpolants);
	EXPECT_TRUE(Reflection.bUsesDiscard);
}

TEST(ShaderReflection, TargetsOfIntegersAreNamed)
{
	const FShaderReflection Reflection =
		Reflect("void Main(out int2 X : SV_Target0, out float4 Y : SV_Target1, out uint Z : SV_Target2)\n"
				"{ X = 1; Y = 2; Z = 3; }\n",
			EShaderStage::Pixel);
	EXPECT_EQ(5u, Reflection.IntegerTargets);
	EXPECT_EQ(5u, ReflectionFromJson(ReflectionToJson(Reflection))->IntegerTargets);
}

TEST(ShaderReflection, TapsAreCountedThroughConstantLoops)
{
	EXPECT_EQ(0, TapsOf(""));
	EXPECT_EQ(2, TapsOf("C = T.SampleLevel(S, UV, 0) + T.Load(int3(0, 0, 0));"));
	EXPECT_EQ(15,
		TapsOf(
			"for (int i = -2; i <= 2; ++i) for (int j = 0; j < 3; ++j) C += T.SampleLevel(S, UV + float2(i, j), 0);"));
	EXPECT_EQ(1, TapsOf("if (UV.x > 0.5) C = T.SampleLevel(S, UV, 0); else C = T.SampleLevel(S, -UV, 0);"));
}

TEST(ShaderReflection, TapsAreUnknownWhereTheyDependOnParametersOrPixels)
{
	EXPECT_EQ(-1, TapsOf("for (int i = 0; i < K; ++i) C += T.SampleLevel(S, UV + i, 0);"));
	EXPECT_EQ(-1, TapsOf("if (UV.x > 0.5) C = T.SampleLevel(S, UV, 0);"));
	EXPECT_EQ(-1, TapsOf("for (int i = 0; i < 4; ++i) { if (UV.x > i) break; C += T.SampleLevel(S, UV + i, 0); }"));
}

TEST(ShaderReflection, TapsOfDeepNestingAreCountedOnce)
{
	// 2^20 of 20 loops, and one behind 60 branches: a count that walks a branch twice would take 2^60 steps.
	std::string Loops;
	std::string Branches;
	std::string Ends;
	for (int i = 0; i < 20; ++i)
	{
		const std::string Name = "i" + std::to_string(i);
		Loops += "for (int " + Name + " = 0; " + Name + " < 2; ++" + Name + ") ";
	}
	for (int i = 0; i < 60; ++i)
	{
		Branches += "if (UV.x > " + std::to_string(i) + ") { C.x += UV.y;\n";
		Ends += "}";
	}
	EXPECT_EQ(1 << 20, TapsOf(Loops + "C += T.SampleLevel(S, UV + C.xy, 0);"));
	EXPECT_EQ(1, TapsOf(Branches + Ends + "C += T.SampleLevel(S, UV, 0);"));
	EXPECT_EQ(-1, TapsOf(Branches + "C += T.SampleLevel(S, UV, 0);" + Ends));
}

TEST(ShaderReflection, TapsFollowTheStepsOfALoop)
{
	const auto Count = [](const std::string& Head)
	{
		return TapsOf("for (" + Head + ") C += T.SampleLevel(S, UV + i, 0);");
	};
	EXPECT_EQ(4, Count("int i = 1; i < 11; i += 3"));
	EXPECT_EQ(4, Count("int i = 1; i <= 10; i += 3"));
	EXPECT_EQ(5, Count("int i = 10; i > 0; i += -2"));
	EXPECT_EQ(6, Count("int i = 10; i >= 0; i += -2"));
	EXPECT_EQ(5, Count("int i = 10; i != 0; i += -2"));
	EXPECT_EQ(0, Count("int i = 10; i < 0; i += 1"));
	EXPECT_EQ(-1, Count("int i = 0; i < 10000000; i += 1")) << "more than a count is worth";
}

TEST(ShaderReflection, TapsAreUnknownBehindADiscard)
{
	const std::string Head =
		"Texture2D T; SamplerState S; void Check(float v) { if (v < 0) discard; }\n"
		"float4 Main(float4 P : SV_POSITION) : SV_Target0 { float4 C = T.SampleLevel(S, P.xy, 0);\n";
	const std::string Tail = "return C + T.SampleLevel(S, C.xy, 0); }\n";
	EXPECT_EQ(2, Reflect(Head + Tail, EShaderStage::Pixel).StaticSamples);
	EXPECT_EQ(-1, Reflect(Head + "Check(C.x);" + Tail, EShaderStage::Pixel).StaticSamples);
	EXPECT_EQ(
		-1, Reflect(Head + "for (int i = 0; i < 3; ++i) Check(C.x - i);" + Tail, EShaderStage::Pixel).StaticSamples);
}

TEST(ShaderReflection, SurvivesJson)
{
	const FShaderReflection Reflection =
		ReflectUse("float4x3 A; Texture2D T; SamplerState S; StructuredBuffer<float2> B;",
			"mul(float4(1, 2, 3, 4), A).xyzz + T.SampleLevel(S, B[0], 0)");
	const std::string Json = ReflectionToJson(Reflection);
	const std::optional<FShaderReflection> Back = ReflectionFromJson(Json);
	ASSERT_TRUE(Back);
	EXPECT_EQ(Json, ReflectionToJson(*Back));
	EXPECT_EQ(Find(Reflection, "A").MatrixStride, Find(*Back, "A").MatrixStride);
	EXPECT_EQ("B", Back->Buffers.at(0).Name);
}

TEST(ShaderReflection, DamagedJsonIsNothing)
{
	EXPECT_FALSE(ReflectionFromJson(""));
	EXPECT_FALSE(ReflectionFromJson("{}"));
	EXPECT_FALSE(ReflectionFromJson("{\"stage\": \"x\"}"));
}
