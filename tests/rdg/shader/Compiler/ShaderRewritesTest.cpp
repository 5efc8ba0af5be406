// Uniform buffers and enums reach the front end in words that it knows, on the lines where they stood.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ShaderHarness.h"
#include "ShaderRewrites.h"

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::ElementsAre;
using testing::HasSubstr;

std::string Rewrite(const std::string& Text)
{
	std::set<std::string> Used;
	return RewriteUniformBuffers(Text, {{"View", {"ViewSize", "Exposure"}, ""}}, Used);
}

/** What a compute shader writes at (0, 0), by the interpreter. */
float RunStatement(const std::string& Globals, const std::string& Expression)
{
	FShaderHarness Harness("RWTexture2D<float4> Out;\n" + Globals +
							   "\n[numthreads(1, 1, 1)] void Main(uint3 Id : SV_DispatchThreadID)\n{\n\tOut[Id.xy] = " +
							   Expression + ";\n}\n",
		"Main", EShaderStage::Compute);
	Harness.Textures["Out"] = FTestTexture(1, 1);
	Harness.RunModel(1, 1);
	return *Harness.Textures["Out"].Texel(0, 0);
}

} // namespace

TEST(RewriteUniformBuffers, JoinsBufferAndMember)
{
	EXPECT_EQ(
		"float2 s = View_ViewSize.xy * View_Exposure;", Rewrite("float2 s = View.ViewSize.xy * View . Exposure;"));
}

TEST(RewriteUniformBuffers, LeavesCommentsStringsAndOtherNamesAlone)
{
	const std::string Text =
		"// View.ViewSize\n/* View.Exposure */ \"View.ViewSize\" MyView.ViewSize In.View.Exposure View2.X View";
	EXPECT_EQ(Text, Rewrite(Text));
}

TEST(RewriteUniformBuffers, KeepsTheLines)
{
	EXPECT_EQ("a\nView_Exposure\nb", Rewrite("a\nView.Exposure\nb"));
	EXPECT_EQ("View_Exposure\n;", Rewrite("View\n.Exposure;"));
}

TEST(RewriteUniformBuffers, AVariableOfTheSameNameIsLeftAlone)
{
	EXPECT_EQ("float3 View = F(); float x = View.z;", Rewrite("float3 View = F(); float x = View.z;"));
	EXPECT_EQ("return View_Nothing;", Rewrite("return View.Nothing;"));
}

TEST(DeclareUniformBuffers, DeclaresWhatIsRead)
{
	const std::vector<FShaderUniformBuffer> Buffers = {
		{"View", {"A"}, "cbuffer View { float View_A; };\n"}, {"Scene", {"B"}, "cbuffer Scene { float Scene_B; };\n"}};
	EXPECT_EQ("#line 1 \"/Engine/Generated/GeneratedUniformBuffers.ush\"\ncbuffer View { float View_A; };\nView_A",
		DeclareUniformBuffers("View.A", Buffers));
	EXPECT_EQ("nothing", DeclareUniformBuffers("nothing", Buffers));
}

TEST(UniformBuffersOfShaders, MacrosThatExpandToThemWork)
{
	FShaderHarness Harness("#define PrimaryView View\n#define MEMBER(Name) View.Name\n#define GetView() PrimaryView\n"
						   "RWTexture2D<float4> Out;\n[numthreads(1, 1, 1)] void Main()\n{\n"
						   "\tOut[int2(0, 0)] = float4(PrimaryView.A, MEMBER(A), GetView().A, 1);\n}\n",
		"Main", EShaderStage::Compute);
	Harness.Request.UniformBuffers = {{"View", {"A"}, "cbuffer View { float View_A; };\n"}};
	Harness.SetFloats("View_A", {3.5f});
	Harness.Textures["Out"] = FTestTexture(1, 1);
	Harness.RunModel(1, 1);
	EXPECT_THAT(std::vector<float>(Harness.Textures["Out"].Texel(0, 0), Harness.Textures["Out"].Texel(0, 0) + 3),
		ElementsAre(3.5f, 3.5f, 3.5f));
}

TEST(UniformBuffersOfShaders, WhatIsNotCalledReadsNothing)
{
	FShaderHarness Harness("float F() { return View.A; }\nRWTexture2D<float4> Out;\n"
						   "[numthreads(1, 1, 1)] void Main() { Out[int2(0, 0)] = 1; }\n",
		"Main", EShaderStage::Compute);
	Harness.Request.UniformBuffers = {{"View", {"A"}, "cbuffer View { float View_A; };\n"}};
	EXPECT_TRUE(ReflectShader(Harness.Request).Constants.empty());
}

TEST(RewriteEnums, ConstantsOnTheSameLines)
{
	EXPECT_EQ("static const int A = int(0); static const int B = int( 4); static const int C = int(B + 1); "
			  "\n\n\n\nint a;\n",
		RewriteEnums("enum EKind\n{\n\tA, B = 4, C,\n};\nint a;\n"));
}

TEST(RewriteEnums, ValuesAreThoseOfCpp)
{
	enum EPlain
	{
		A,
		B = 4,
		C,
		D = B << 2 | 1,
	};
	enum class EScoped : uint32_t
	{
		One = 1,
		Two = One * 2,
		Three,
	};
	const std::string Text = "enum EPlain { A, B = 4, C, D = B << 2 | 1, };\n"
							 "enum class EScoped : uint { One = 1, Two = One * 2, Three };\n"
							 "uint F(EScoped S) { switch (S) { case EScoped::Three: return 30; default: return 7; } }\n"
							 "static const float Table[EPlain::B] = {1, 2, 3, 4};\n";
	EXPECT_EQ(float(C), RunStatement(Text, "C"));
	EXPECT_EQ(float(D), RunStatement(Text, "EPlain::D"));
	EXPECT_EQ(float(uint32_t(EScoped::Three)), RunStatement(Text, "(float)EScoped::Three"));
	EXPECT_EQ(30.0f, RunStatement(Text, "F(EScoped::Three) + 0 * Table[0]"));
	EXPECT_EQ(7.0f, RunStatement(Text, "F((EScoped)2u)"));
}

TEST(RewriteEnums, LeavesTheRestAlone)
{
	for (const std::string Text : {"int enumerate; enum", "enum EForward;", "enum X {"})
	{
		EXPECT_EQ(Text, RewriteEnums(Text));
	}
}

TEST(RewriteLoads, TakesTwoOfThreeComponents)
{
	EXPECT_EQ("RWTexture2D<float4> A; A.Load((int2)(int3(P, 0))); B.Load(int3(P, 0));",
		RewriteLoads("RWTexture2D<float4> A; A.Load(int3(P, 0)); B.Load(int3(P, 0));"));
	EXPECT_EQ("RWTexture2D<float4> A; A.Load(P, Status); A.Load(",
		RewriteLoads("RWTexture2D<float4> A; A.Load(P, Status); A.Load("));
	EXPECT_EQ(0.0f, RunStatement("", "Out.Load(int3(Id.xy, 0))"));
}
