// What a check finds in shaders that do something wrong: the line, the operation with its numbers, the pixels.
#include <gtest/gtest.h>

#include "InspectTestUtils.h"
#include "KernelCheck.h"

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

constexpr int32_t Width = InspectWidth;
constexpr int32_t Height = InspectHeight;

FCheckSet All()
{
	FCheckSet Checks;
	Checks.bOn.fill(true);
	return Checks;
}

std::vector<FCheckFinding> Check(FShaderHarness& Harness, const FCheckSet& Checks = All())
{
	FInspectedShader& Shader = Harness.Inspect();
	return CheckThreads(Shader, MakeBound(Harness), Harness.GetArgs(), InspectWhole, {}, Checks);
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

using FLines = std::vector<std::string>;

TEST(KernelCheck, ASoundShaderIsClean)
{
	FShaderHarness Harness =
		MakeInspectedPixel("OutColor = Source.Load(int3(SvPosition.xy, 0)) + pow(SvPosition.x, 2.2);");
	EXPECT_EQ(FLines{}, Describe(Check(Harness)));
}

TEST(KernelCheck, NamesTheDivisionThatMakesNaN)
{
	FShaderHarness Harness = MakeInspectedPixel("float W = SvPosition.x < 2 ? 0 : 1;\n"
												"float Mean = (W * 3) / W;\n"
												"OutColor = Mean * 2;");
	EXPECT_EQ((FLines{"nan 6: 0 / 0 is NaN, first (0, 0), 8 threads"}), Describe(Check(Harness)));
}

TEST(KernelCheck, NamesThePowerOfANegativeNumber)
{
	FShaderHarness Harness = MakeInspectedPixel("float X = 1 - SvPosition.x;\nOutColor = pow(X, 2.5);");
	EXPECT_EQ((FLines{"nan 6: pow(-0.5, 2.5) is NaN, first (1, 0), 20 threads"}), Describe(Check(Harness)));
}

TEST(KernelCheck, WhatIsReadAsNaNIsNotToBlame)
{
	FShaderHarness Harness = MakeInspectedPixel("OutColor = Source.Load(int3(SvPosition.xy, 0)) * 2;");
	Harness.Textures["Source"].Texel(2, 1)[0] = std::numeric_limits<float>::quiet_NaN();
	EXPECT_EQ(FLines{}, Describe(Check(Harness)));
}

TEST(KernelCheck, NamesAReadOutsideATexture)
{
	FShaderHarness Harness = MakeInspectedPixel("OutColor = Source.Load(int3(SvPosition.xy + int2(2, 0), 0));");
	EXPECT_EQ((FLines{"bounds 5: a read of Source at (6, 0), which is 6 x 4; it gives 0, first (4, 0), 8 threads"}),
		Describe(Check(Harness)));
}

TEST(KernelCheck, NamesAnIndexOutsideAnArray)
{
	FShaderHarness Harness = MakeInspectedPixel("float Table[4];\nfor (int i = 0; i < 4; ++i) { Table[i] = i; }\n"
												"OutColor = Table[int(SvPosition.x)];");
	EXPECT_EQ((FLines{"bounds 7: element 4 of an array that has 4; the nearest is taken, first (4, 0), 8 threads"}),
		Describe(Check(Harness)));
}

TEST(KernelCheck, NamesAVariableThatNothingWrote)
{
	FShaderHarness Harness = MakeInspectedPixel("float4 Sum;\nif (SvPosition.y > 2) { Sum = 0; }\n"
												"OutColor = Sum + 1;");
	const FLines Found = Describe(Check(Harness));
	ASSERT_EQ(1u, Found.size());
	EXPECT_EQ("uninit 7: 'Sum' is used before it is written (component 0), first (0, 0), 12 threads", Found[0]);
}

TEST(KernelCheck, NamesAnOutputThatIsNotWholeByItsName)
{
	FShaderHarness Harness = MakeInspectedPixel("OutColor.rgb = SvPosition.x;");
	const FLines Found = Describe(Check(Harness));
	ASSERT_EQ(1u, Found.size());
	EXPECT_NE(std::string::npos, Found[0].find("'OutColor' is used before it is written (component 3)")) << Found[0];
}

TEST(KernelCheck, NamesANegativeColourAndOnlyThen)
{
	FShaderHarness Harness = MakeInspectedPixel("float3 Color = SvPosition.x - 1;\nOutColor = float4(Color, -1);");
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

TEST(KernelCheck, NamesASampleBehindTheLastLevel)
{
	FShaderHarness Harness =
		MakeInspectedPixel("OutColor = Source.SampleLevel(Linear, SvPosition.xy / 6, 1);", "SamplerState Linear; ");
	EXPECT_EQ((FLines{"bounds 5: a sample of Source at level 1, which has 1 level; the last is taken, first (0, 0), 24 "
					  "threads"}),
		Describe(Check(Harness)));
}

TEST(KernelCheck, NamesStoresOfTwoThreadsToOneTexel)
{
	FShaderHarness Harness(
		"RWTexture2D<float4> Out;\nRWStructuredBuffer<uint> Sum;\n[numthreads(2, 2, 1)]\n"
		"void MainCS(uint3 Id : SV_DispatchThreadID)\n{\n\tOut[Id.xy] = Id.x;\n"
		"\tOut[uint2(Id.x + 1, Id.y)] = Id.x + 1;\n\tSum[0] = 7;\n\tif (Id.y == 1) Sum[1] = Id.x / 4;\n}\n",
		"MainCS", EShaderStage::Compute);
	Harness.Textures["Out"] = FTestTexture(Width + 1, Height);
	Harness.Buffers["Sum"].assign(2, 0);
	EXPECT_EQ(
		(FLines{"overlap 9: a store to Sum[1], where thread (0, 1) stores another value in line 9, first (4, 1), 2 "
				"threads"}),
		Describe(Check(Harness)))
		<< "the texel to the right gets what its own thread stores, and all store 7";
}

TEST(KernelCheck, NamesTheNeighboursStore)
{
	FShaderHarness Harness("RWTexture2D<float4> Out;\n[numthreads(2, 2, 1)]\n"
						   "void MainCS(uint3 Id : SV_DispatchThreadID)\n{\n\tOut[Id.xy] = 1;\n"
						   "\tOut[uint2(Id.x + 1, Id.y)] = 2;\n}\n",
		"MainCS", EShaderStage::Compute);
	Harness.Textures["Out"] = FTestTexture(Width + 1, Height);
	const FLines Found = Describe(Check(Harness));
	ASSERT_EQ(1u, Found.size());
	EXPECT_EQ(
		"overlap 5: a store to Out at (1, 0), where thread (0, 0) stores another value in line 6, first (1, 0), 20 "
		"threads",
		Found[0]);
}

TEST(KernelCheck, CountsAssertionsThatFailAndListsTheirValues)
{
	FShaderHarness Harness = MakeInspectedPixel("float3 Color = float3(1, SvPosition.x, 2);\nint Count = 3;\n"
												"DrydockAssert(Color.y < 4 || Count > 3);\nOutColor = Color.y;");
	EXPECT_EQ((FLines{"assert 7: Color.y < 4 || Count > 3 does not hold: Color = (1, 4.5, 2), Count = 3, first (4, 0), "
					  "8 threads"}),
		Describe(Check(Harness)));
}

TEST(KernelCheck, LooksAtTheThreadsThatItIsGiven)
{
	FShaderHarness Harness = MakeInspectedPixel("OutColor = 1 / (SvPosition.x - SvPosition.x);");
	FInspectedShader& Shader = Harness.Inspect();
	const std::vector<FCheckFinding> Found =
		CheckThreads(Shader, MakeBound(Harness), Harness.GetArgs(), InspectWhole, {{{3, 2, 0}}, {{1, 1, 0}}}, All());
	EXPECT_EQ((FLines{"nan 5: 1 / 0 is Inf, first (3, 2), 2 threads"}), Describe(Found));
}

/** Findings of a compute shader of two groups of 32, whose body is given. */
std::vector<std::string> CheckGroups(const std::string& Body)
{
	FShaderHarness Harness(
		"RWStructuredBuffer<uint> Out;\ngroupshared uint Shared[32];\ngroupshared uint Count;\n"
		"[numthreads(32, 1, 1)]\nvoid MainCS(uint3 Id : SV_DispatchThreadID, uint I : SV_GroupIndex)\n{\n" +
			Body + "\n}\n",
		"MainCS", EShaderStage::Compute);
	Harness.Buffers["Out"].assign(64, 0);
	FInspectedShader& Shader = Harness.Inspect();
	return Describe(CheckThreads(Shader, MakeBound(Harness), Harness.GetArgs(), {0, 0, 0, 64, 1, 1}, {}, All()));
}

TEST(KernelCheck, NamesBothLinesOfARace)
{
	EXPECT_EQ(
		(FLines{"race 7: a write to Shared[16], which thread (15, 0) reads in line 8: no barrier is between, first "
				"(16, 0), 32 threads",
			"race 8: a read of Shared[15], which thread (15, 0) writes in line 7: no barrier is between, first (16, "
			"0), "
			"32 threads"}),
		CheckGroups("Shared[I] = I * I;\nOut[Id.x] = Shared[31 - I];"));
	EXPECT_EQ(
		FLines{}, CheckGroups("Shared[I] = I * I;\nGroupMemoryBarrierWithGroupSync();\nOut[Id.x] = Shared[31 - I];"));
}

TEST(KernelCheck, WhatThreadsAgreeOnIsNoRace)
{
	EXPECT_EQ(FLines{}, CheckGroups("Count = 5;\nShared[I] = Count;\nOut[Id.x] = Shared[I];"));
	EXPECT_EQ(FLines{}, CheckGroups("Count = 0;\nGroupMemoryBarrierWithGroupSync();\nInterlockedAdd(Count, I);\n"
									"GroupMemoryBarrierWithGroupSync();\nOut[Id.x] = Count;"));
}

TEST(KernelCheck, APlainReadBesideAnAtomicOperationIsARace)
{
	// Both sides of ?: are evaluated, by thread 0 too.
	EXPECT_EQ(
		(FLines{"race 7: an atomic operation on Count, which thread (0, 0) reads in line 8: no barrier is between, "
				"first (1, 0), 62 threads",
			"race 8: a read of Count, which thread (0, 0) changes atomically in line 7: no barrier is between, "
			"first (1, 0), 62 threads"}),
		CheckGroups("InterlockedAdd(Count, 1);\nOut[Id.x] = I == 0 ? 0 : Count;"));
}

} // namespace
