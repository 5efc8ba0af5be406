// What a check finds in shaders that do something wrong: the line, the operation with its numbers, the pixels.
#include <gtest/gtest.h>

#include "../ShaderCompiler/ShaderHarness.h"
#include "KernelCheck.h"

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

constexpr int32_t Width = 6;
constexpr int32_t Height = 4;

FCheckSet All()
{
	FCheckSet Checks;
	Checks.bOn.fill(true);
	return Checks;
}

std::vector<FCheckFinding> Check(FShaderHarness& Harness, const FCheckSet& Checks = All())
{
	FInspectedShader& Shader = Harness.Inspect();
	FBoundShader Bound;
	Bound.Reflection = std::make_shared<FShaderReflection>(Harness.GetReflection());
	return CheckThreads(Shader, Bound, Harness.GetArgs(), {0, 0, 0, Width, Height, 1}, {}, Checks);
}

/** "nan 3: 0 / 0 is NaN, first (1, 0), 4 threads" of each. */
std::vector<std::string> Describe(const std::vector<FCheckFinding>& Findings)
{
	std::vector<std::string> Lines;
	for (const FCheckFinding& Finding : Findings)
	{
		Lines.push_back(std::string(GetCheckName(Finding.Check)) + " " + std::to_string(Finding.Line) + ": " +
						Finding.What + ", first (" + std::to_string(Finding.First[0]) + ", " +
						std::to_string(Finding.First[1]) + "), " + std::to_string(Finding.Threads) + " threads");
		EXPECT_EQ(Finding.Threads, Finding.Pixels.size());
	}
	return Lines;
}

/** A pixel shader around some lines, of which the first is line 5. */
FShaderHarness MakePixel(const std::string& Lines)
{
	FShaderHarness Harness("Texture2D Source;\nfloat Zero;\n"
						   "void MainPS(float4 SvPosition : SV_POSITION, out float4 OutColor : SV_Target0)\n{\n" +
							   Lines + "\n}\n",
		"MainPS", EShaderStage::Pixel);
	Harness.SetFloats("Zero", {0});
	Harness.Textures["Source"] = FTestTexture(Width, Height);
	Harness.Targets.emplace_back(Width, Height);
	return Harness;
}

using FLines = std::vector<std::string>;

TEST(KernelCheck, ASoundShaderIsClean)
{
	FShaderHarness Harness = MakePixel("OutColor = Source.Load(int3(SvPosition.xy, 0)) + pow(SvPosition.x, 2.2);");
	EXPECT_EQ(FLines{}, Describe(Check(Harness)));
}

TEST(KernelCheck, NamesTheDivisionThatMakesNaN)
{
	FShaderHarness Harness = MakePixel("float W = SvPosition.x < 2 ? 0 : 1;\n"
									   "float Mean = (W * 3) / W;\n"
									   "OutColor = Mean * 2;");
	EXPECT_EQ((FLines{"nan 6: 0 / 0 is NaN, first (0, 0), 8 threads"}), Describe(Check(Harness)));
}

TEST(KernelCheck, NamesThePowerOfANegativeNumber)
{
	FShaderHarness Harness = MakePixel("float X = 1 - SvPosition.x;\nOutColor = pow(X, 2.5);");
	EXPECT_EQ((FLines{"nan 6: pow(-0.5, 2.5) is NaN, first (1, 0), 20 threads"}), Describe(Check(Harness)));
}

TEST(KernelCheck, WhatIsReadAsNaNIsNotToBlame)
{
	FShaderHarness Harness = MakePixel("OutColor = Source.Load(int3(SvPosition.xy, 0)) * 2;");
	Harness.Textures["Source"].Texel(2, 1)[0] = std::numeric_limits<float>::quiet_NaN();
	EXPECT_EQ(FLines{}, Describe(Check(Harness)));
}

TEST(KernelCheck, NamesAReadOutsideATexture)
{
	FShaderHarness Harness = MakePixel("OutColor = Source.Load(int3(SvPosition.xy + int2(2, 0), 0));");
	EXPECT_EQ((FLines{"bounds 5: a read of Source at (6, 0), which is 6 x 4; it gives 0, first (4, 0), 8 threads"}),
		Describe(Check(Harness)));
}

TEST(KernelCheck, NamesAnIndexOutsideAnArray)
{
	FShaderHarness Harness = MakePixel("float Table[4];\nfor (int i = 0; i < 4; ++i) { Table[i] = i; }\n"
									   "OutColor = Table[int(SvPosition.x)];");
	EXPECT_EQ((FLines{"bounds 7: element 4 of an array that has 4; the nearest is taken, first (4, 0), 8 threads"}),
		Describe(Check(Harness)));
}

TEST(KernelCheck, NamesAVariableThatNothingWrote)
{
	FShaderHarness Harness = MakePixel("float4 Sum;\nif (SvPosition.y > 2) { Sum = 0; }\n"
									   "OutColor = Sum + 1;");
	const FLines Found = Describe(Check(Harness));
	ASSERT_EQ(1u, Found.size());
	EXPECT_EQ("uninit 7: 'Sum' is used before it is written (component 0), first (0, 0), 12 threads", Found[0]);
}

TEST(KernelCheck, NamesAnOutputThatIsNotWholeByItsName)
{
	FShaderHarness Harness = MakePixel("OutColor.rgb = SvPosition.x;");
	const FLines Found = Describe(Check(Harness));
	ASSERT_EQ(1u, Found.size());
	EXPECT_NE(std::string::npos, Found[0].find("'OutColor' is used before it is written (component 3)")) << Found[0];
}

TEST(KernelCheck, NamesANegativeColourAndOnlyThen)
{
	FShaderHarness Harness = MakePixel("float3 Color = SvPosition.x - 1;\nOutColor = float4(Color, -1);");
	EXPECT_EQ(
		(FLines{"negative 6: -0.5 is stored to SV_Target0 (red), first (0, 0), 4 threads"}), Describe(Check(Harness)));
}

TEST(KernelCheck, NamesABufferThatIsTooShort)
{
	FShaderHarness Harness("RWStructuredBuffer<float> Out;\nStructuredBuffer<float> In;\n[numthreads(6, 4, 1)]\n"
						   "void MainCS(uint3 Id : SV_DispatchThreadID)\n{\n"
						   "\tOut[Id.y * 6 + Id.x] = In[Id.x] + 1;\n}\n",
		"MainCS", EShaderStage::Compute);
	Harness.Buffers["Out"].assign(24, 0);
	Harness.Buffers["In"].assign(5, 0);
	EXPECT_EQ((FLines{"bounds 6: a read of In[5], which has 5 elements; it gives 0, first (5, 0), 4 threads"}),
		Describe(Check(Harness)));
	EXPECT_EQ(std::vector<uint32_t>(24, 0), Harness.Buffers["Out"]) << "a check writes to copies";
}

TEST(KernelCheck, LooksAtTheThreadsThatItIsGiven)
{
	FShaderHarness Harness = MakePixel("OutColor = 1 / (SvPosition.x - SvPosition.x);");
	FInspectedShader& Shader = Harness.Inspect();
	FBoundShader Bound;
	Bound.Reflection = std::make_shared<FShaderReflection>(Harness.GetReflection());
	const std::vector<FCheckFinding> Found =
		CheckThreads(Shader, Bound, Harness.GetArgs(), {0, 0, 0, Width, Height, 1}, {{{3, 2, 0}}, {{1, 1, 0}}}, All());
	EXPECT_EQ((FLines{"nan 5: 1 / 0 is Inf, first (3, 2), 2 threads"}), Describe(Found));
}

} // namespace
