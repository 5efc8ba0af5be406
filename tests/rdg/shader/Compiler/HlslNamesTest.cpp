// Names of uniform buffers, enums and texels in shaders that run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ShaderHarness.h"

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::ElementsAre;

/** The value that a compute shader writes at (0, 0), by the interpreter. */
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

TEST(HlslEnums, ValuesAreThoseOfCpp)
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

TEST(HlslTexels, ALoadTakesTwoOfThreeComponents)
{
	EXPECT_EQ(0.0f, RunStatement("", "Out.Load(int3(Id.xy, 0))"));
}
