// Resources in arrays, local variables and structs, as numbers: what is read and written where, worked out by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ShaderHarness.h"

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

using FWords = std::map<std::string, std::vector<uint32_t>>;

/** The buffers after four threads, by kernels of every lane count, which have to agree with the interpreter. */
FWords RunShader(const std::string& Globals, const std::string& Body, const FWords& Before)
{
	FShaderHarness Harness(Globals +
							   "\n[numthreads(4, 1, 1)] void Main(uint3 Id : SV_DispatchThreadID)\n{\n\tuint i = "
							   "Id.x;\n" +
							   Body + "\n}\n",
		"Main", EShaderStage::Compute);
	Harness.Buffers = Before;
	Harness.RunModel(4, 1);
	const FWords Result = Harness.Buffers;
	for (const int32_t Lanes : GetLaneCounts())
	{
		Harness.Buffers = Before;
		Harness.Run(Lanes, 4, 1);
		EXPECT_EQ(Result, Harness.Buffers) << Lanes << " lanes";
	}
	return Result;
}

std::string ErrorsOf(const std::string& Globals, const std::string& Statement)
{
	const std::string Text =
		Globals + "\n[numthreads(4, 1, 1)] void Main(uint3 Id : SV_DispatchThreadID) {\n\t" + Statement + "\n}\n";
	return ErrorOf([&] { ReflectShader(FShaderHarness(Text, "Main", EShaderStage::Compute).Request); });
}

} // namespace

TEST(HlslResources, AnArrayIsOneBufferForEachElement)
{
	const FWords Words =
		RunShader("RWStructuredBuffer<uint> A[2][2];", "\tA[i / 2][i % 2][0] = A[1][0][1] + i;\n\tA[1][1][1] = 9;",
			{{"A_0", {0, 0}}, {"A_1", {0, 0}}, {"A_2", {0, 50}}, {"A_3", {0, 0}}});
	EXPECT_THAT(Words.at("A_0"), ElementsAre(50, 0));
	EXPECT_THAT(Words.at("A_1"), ElementsAre(51, 0));
	EXPECT_THAT(Words.at("A_2"), ElementsAre(52, 50));
	EXPECT_THAT(Words.at("A_3"), ElementsAre(53, 9));
}

TEST(HlslResources, ALocalVariableIsWhatItWasGivenLast)
{
	const FWords Words = RunShader("RWByteAddressBuffer First;\nRWByteAddressBuffer Second;",
		"\tRWByteAddressBuffer Buffers = First;\n\tBuffers.Store(i * 4, 1);\n\tif (i > 1) Buffers = Second;\n"
		"\tBuffers.Store(i * 4, Buffers.Load(i * 4) + 5);",
		{{"First", {0, 0, 0, 0}}, {"Second", {10, 20, 30, 40}}});
	EXPECT_THAT(Words.at("First"), ElementsAre(6, 6, 1, 1));
	EXPECT_THAT(Words.at("Second"), ElementsAre(10, 20, 35, 45));
}

TEST(HlslResources, FunctionsTakeWhatTheyAreGiven)
{
	const FWords Words = RunShader(
		"RWStructuredBuffer<uint> A[4];\nRWStructuredBuffer<uint> Out;\n"
		"uint Sum(RWStructuredBuffer<uint> Pair[2]) { return Pair[0][0] + Pair[1][0]; }\n"
		"uint Twice(RWStructuredBuffer<uint> One) { return One[0] * 2; }\n"
		"uint Local(uint i) { RWStructuredBuffer<uint> Two[2]; Two[0] = A[i]; Two[1] = A[3 - i]; return Sum(Two); }",
		"\tOut[i] = Twice(A[i]) + Local(i);",
		{{"A_0", {1}}, {"A_1", {2}}, {"A_2", {3}}, {"A_3", {4}}, {"Out", {0, 0, 0, 0}}});
	EXPECT_THAT(Words.at("Out"), ElementsAre(7, 9, 11, 13));
}

TEST(HlslResources, AStructOfTheShaderAndOneOfAFunction)
{
	const FWords Words =
		RunShader("struct FInner { RWBuffer<uint> Out; };\nstruct FPair { RWBuffer<uint> In; FInner Inner; "
				  "uint Read(uint i) { return this.In[i] + In[0]; } };\nFPair Pairs[2];\nFInner One;",
			"\tFPair P = Pairs[i % 2];\n\tP.Inner.Out[i] = P.Read(i);\n\tOne.Out[i] = Pairs[1].In[i];",
			{{"Pairs_0_In", {1, 2, 3, 4}}, {"Pairs_1_In", {10, 20, 30, 40}}, {"Pairs_0_Inner_Out", {0, 0, 0, 0}},
				{"Pairs_1_Inner_Out", {0, 0, 0, 0}}, {"One_Out", {0, 0, 0, 0}}});
	EXPECT_THAT(Words.at("Pairs_0_Inner_Out"), ElementsAre(2, 0, 4, 0));
	EXPECT_THAT(Words.at("Pairs_1_Inner_Out"), ElementsAre(0, 30, 0, 50));
	EXPECT_THAT(Words.at("One_Out"), ElementsAre(10, 20, 30, 40));
}

TEST(HlslResources, PartsOfElementsAreStored)
{
	const FWords Words = RunShader("struct FItem { uint A; uint2 B; };\nRWStructuredBuffer<FItem> Items[2];",
		"\tItems[i / 2][i % 2].B.y = i + 1;\n\tItems[i / 2][i % 2].A += 5;",
		{{"Items_0", {1, 2, 3, 4, 5, 6}}, {"Items_1", {0, 0, 0, 0, 0, 0}}});
	EXPECT_THAT(Words.at("Items_0"), ElementsAre(6, 2, 1, 9, 5, 2));
	EXPECT_THAT(Words.at("Items_1"), ElementsAre(5, 0, 3, 5, 0, 4));
}

TEST(HlslResources, ElementsAreUsedInAnyExpression)
{
	const FWords Words = RunShader("RWStructuredBuffer<uint> A[2];\nRWByteAddressBuffer Bytes[2];",
		"\tuint Old;\n\tBytes[i % 2].InterlockedAdd(i / 2 * 4, i + 1, Old);\n"
		"\tfor (A[i % 2][2 + i / 2] = Old; A[i % 2][2 + i / 2] < 12;) A[i % 2][2 + i / 2] += 10;\n"
		"\tA[A[0][i / 2]][i % 2] = A[0][i / 2] + i;",
		{{"A_0", {1, 1, 0, 0}}, {"A_1", {0, 0, 0, 0}}, {"Bytes_0", {5, 7}}, {"Bytes_1", {6, 8}}});
	EXPECT_THAT(Words.at("Bytes_0"), ElementsAre(6, 10));
	EXPECT_THAT(Words.at("Bytes_1"), ElementsAre(8, 12));
	EXPECT_THAT(Words.at("A_0"), ElementsAre(1, 1, 15, 17));
	EXPECT_THAT(Words.at("A_1"), ElementsAre(3, 4, 16, 18));
}

TEST(HlslResources, WhatCannotBeBoundSaysSo)
{
	EXPECT_THAT(ErrorsOf("RWStructuredBuffer<uint> A[];", "A[Id.x][0] = 1;"),
		AllOf(HasSubstr("Shader.usf:3"), HasSubstr("'A'"), HasSubstr("give it a size")));
	EXPECT_THAT(ErrorsOf("struct FMix { RWBuffer<uint> A; float B; };\nFMix Mix;", "Mix.A[0] = uint(Mix.B);"),
		AllOf(HasSubstr("Shader.usf:2"), HasSubstr("the number 'B'")));
}

TEST(HlslResources, ATextureHasItsSizesAsAMemberByFxcsRules)
{
	FShaderHarness Harness("Texture2D T;\nRWStructuredBuffer<int> Out;\n"
						   "[numthreads(1, 1, 1)] void Main(uint3 Id : SV_DispatchThreadID)\n"
						   "{ Out[0] = min(9, T.Length.x - 1); Out[1] = T.Length.y; Out[2] = T[T.Length.xy - 1].x; }\n",
		"Main", EShaderStage::Compute);
	Harness.Request.Defines = {{FxcRulesDefine, "1"}};
	Harness.Textures["T"] = FTestTexture(6, 5);
	*Harness.Textures["T"].Texel(5, 4) = 7;
	Harness.Buffers["Out"].resize(3);
	Harness.Run(4, 1, 1);
	EXPECT_THAT(Harness.Buffers["Out"], ElementsAre(5, 5, 7));
}

TEST(HlslResources, AVariableOfALoopStaysBehindItByFxcsRules)
{
	FShaderHarness Harness(
		"RWStructuredBuffer<int> Out;\n"
		"[numthreads(1, 1, 1)] void Main(uint3 Id : SV_DispatchThreadID)\n"
		"{ int i = 9; for (int i = 0; i < 4; ++i) { Out[1] = i; } Out[0] = i;\n"
		"  [unroll] for (i = 5; i < 7; ++i) { Out[2] = i; } float float = 3; Out[3] = i + float; }\n",
		"Main", EShaderStage::Compute);
	Harness.Request.Defines = {{FxcRulesDefine, "1"}};
	Harness.Buffers["Out"].resize(4);
	Harness.Run(4, 1, 1);
	EXPECT_THAT(Harness.Buffers["Out"], ElementsAre(4, 3, 6, 10));
}
