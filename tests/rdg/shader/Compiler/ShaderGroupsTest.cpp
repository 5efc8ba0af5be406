// Threads that work together: groupshared memory and barriers. Kernels at every lane count and the interpreter,
// against plain C++.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ShaderForms.h"
#include "ShaderCache.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::HasSubstr;

std::vector<uint32_t> DrawNumbers(size_t Count, uint32_t Limit, uint32_t Seed)
{
	std::mt19937 Random(Seed);
	std::vector<uint32_t> Numbers(Count);
	for (uint32_t& Number : Numbers)
	{
		Number = uint32_t(Random() % Limit);
	}
	return Numbers;
}

std::vector<float> DrawFloats(size_t Count, uint32_t Seed)
{
	std::mt19937 Random(Seed);
	std::uniform_real_distribution<float> Values(-4.0f, 4.0f);
	std::vector<float> Floats(Count);
	for (float& Float : Floats)
	{
		Float = Values(Random);
	}
	return Floats;
}

std::string ErrorOfBody(const std::string& Globals, const std::string& Body)
{
	const std::string Text = Globals +
							 "\nRWBuffer<uint> Out;\n[numthreads(64, 1, 1)]\n"
							 "void MainCS(uint I : SV_GroupIndex, uint3 G : SV_GroupID)\n{\n" +
							 Body + "\n}\n";
	FShaderHarness Harness(Text, "MainCS", EShaderStage::Compute);
	Harness.Buffers["Out"].assign(64, 0);
	return ErrorOf([&] { Harness.Run(0, 64, 1); });
}

} // namespace

TEST(ShaderGroups, AReductionSumsEachGroup)
{
	const std::string Text = R"(
StructuredBuffer<uint> In;
RWStructuredBuffer<uint> Out;
groupshared uint Sums[64];
[numthreads(8, 4, 2)]
void MainCS(uint3 Id : SV_DispatchThreadID, uint3 Local : SV_GroupThreadID, uint3 G : SV_GroupID, uint I : SV_GroupIndex)
{
	const uint Place = (Id.z * 8 + Id.y) * 24 + Id.x;
	Sums[(Local.z * 4 + Local.y) * 8 + Local.x] = In[Place];
	GroupMemoryBarrierWithGroupSync();
	for (uint Half = 32; Half > 0; Half >>= 1)
	{
		if (I < Half)
		{
			Sums[I] += Sums[I + Half];
		}
		GroupMemoryBarrierWithGroupSync();
	}
	if (I == 0)
	{
		Out[(G.z * 2 + G.y) * 3 + G.x] = Sums[0];
	}
}
)";
	const std::vector<uint32_t> In = DrawNumbers(24 * 8 * 4, 1u << 30, 1);
	std::vector<uint32_t> Expected(12);
	for (uint32_t i = 0; i < In.size(); ++i)
	{
		const uint32_t X = i % 24, Y = i / 24 % 8, Z = i / 24 / 8;
		Expected[(Z / 2 * 2 + Y / 4) * 3 + X / 8] += In[i];
	}
	ForEachForm(
		Text, 24, 8, 4,
		[&](FShaderHarness& H)
		{
			H.Buffers["In"] = In;
			H.Buffers["Out"].assign(12, 0);
		},
		[&](FShaderHarness& H) { EXPECT_EQ(Expected, H.Buffers["Out"]); });
}

TEST(ShaderGroups, AGaussianReadsItsNeighboursFromTheGroup)
{
	const std::string Text = R"(
StructuredBuffer<float> In;
RWStructuredBuffer<float> Out;
cbuffer Parameters { float4 Weights[3]; }
groupshared float Row[64 + 16];
[numthreads(64, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID, uint I : SV_GroupIndex)
{
	Row[I + 8] = In[Id.x];
	if (I < 8)
	{
		Row[I] = In[max(int(Id.x) - 8, 0)];
		Row[I + 72] = In[min(Id.x + 64, 255u)];
	}
	GroupMemoryBarrierWithGroupSync();
	float Sum = 0;
	for (int k = -8; k <= 8; ++k)
	{
		Sum += Row[int(I) + 8 + k] * Weights[abs(k) / 4][abs(k) % 4];
	}
	Out[Id.x] = Sum;
}
)";
	const std::vector<float> In = DrawFloats(256, 2);
	std::vector<float> Weights(12);
	for (size_t k = 0; k < 9; ++k)
	{
		Weights[k] = float(std::exp(-double(k * k) / 18.0));
	}
	ForEachForm(
		Text, 256, 1, 1,
		[&](FShaderHarness& H)
		{
			H.SetFloatBuffer("In", In);
			H.SetFloats("Weights", Weights);
			H.Buffers["Out"].assign(256, 0);
		},
		[&](FShaderHarness& H)
		{
			for (int x = 0; x < 256; ++x)
			{
				double Sum = 0;
				for (int k = -8; k <= 8; ++k)
				{
					Sum += double(In[size_t(std::clamp(x + k, 0, 255))]) * double(Weights[size_t(std::abs(k))]);
				}
				EXPECT_NEAR(Sum, H.BufferFloat("Out", size_t(x)), 17 * 16 * 0x1p-24) << x;
			}
		});
}

TEST(ShaderGroups, AHistogramCountsByAtomics)
{
	const std::string Text = R"(
StructuredBuffer<uint> In;
RWStructuredBuffer<uint> Out;
groupshared uint Bins[16];
[numthreads(100, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID, uint I : SV_GroupIndex)
{
	if (I < 16)
	{
		Bins[I] = 0;
	}
	GroupMemoryBarrierWithGroupSync();
	InterlockedAdd(Bins[In[Id.x] % 16], 1);
	GroupMemoryBarrierWithGroupSync();
	if (I < 16)
	{
		InterlockedAdd(Out[I], Bins[I]);
	}
}
)";
	const std::vector<uint32_t> In = DrawNumbers(700, 1u << 30, 3);
	std::vector<uint32_t> Expected(16);
	for (const uint32_t Number : In)
	{
		++Expected[Number % 16];
	}
	ForEachForm(
		Text, 700, 1, 1,
		[&](FShaderHarness& H)
		{
			H.Buffers["In"] = In;
			H.Buffers["Out"].assign(16, 0);
		},
		[&](FShaderHarness& H) { EXPECT_EQ(Expected, H.Buffers["Out"]); });
}

TEST(ShaderGroups, ABitonicSortSortsEachGroup)
{
	const std::string Text = R"(
RWStructuredBuffer<uint> Data;
groupshared uint Keys[128];
[numthreads(128, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID, uint I : SV_GroupIndex)
{
	Keys[I] = Data[Id.x];
	GroupMemoryBarrierWithGroupSync();
	for (uint Size = 2; Size <= 128; Size <<= 1)
	{
		for (uint Stride = Size >> 1; Stride > 0; Stride >>= 1)
		{
			const uint Other = I ^ Stride;
			const uint Mine = Keys[I];
			const uint Its = Keys[Other];
			const bool bUp = (I & Size) == 0;
			const bool bKeepLess = (I < Other) == bUp;
			GroupMemoryBarrierWithGroupSync();
			Keys[I] = bKeepLess ? min(Mine, Its) : max(Mine, Its);
			GroupMemoryBarrierWithGroupSync();
		}
	}
	Data[Id.x] = Keys[I];
}
)";
	const std::vector<uint32_t> In = DrawNumbers(384, 1000, 4);
	std::vector<uint32_t> Expected = In;
	for (size_t Group = 0; Group < 3; ++Group)
	{
		std::sort(Expected.begin() + std::ptrdiff_t(Group * 128), Expected.begin() + std::ptrdiff_t(Group * 128 + 128));
	}
	ForEachForm(
		Text, 384, 1, 1, [&](FShaderHarness& H) { H.Buffers["Data"] = In; },
		[&](FShaderHarness& H) { EXPECT_EQ(Expected, H.Buffers["Data"]); });
}

TEST(ShaderGroups, VariablesKeepTheirValuesOverBarriers)
{
	// Local arrays, values of branches that threads took differently, and loop counters, all live over barriers.
	const std::string Text = R"(
RWStructuredBuffer<float> Out;
cbuffer Parameters { uint Turns; }
groupshared float Shared[48];
[numthreads(48, 1, 1)]
void MainCS(uint I : SV_GroupIndex)
{
	float Mine[5];
	for (uint k = 0; k < 5; ++k)
	{
		Mine[k] = float(I * 5 + k);
	}
	float Chosen = -1;
	if (I % 3 == 0)
	{
		Chosen = Mine[I % 5];
	}
	float Sum = 0;
	uint Count = 0;
	for (uint Turn = 0; Turn < Turns; ++Turn)
	{
		Shared[I] = Mine[(I + Turn) % 5] + Chosen;
		GroupMemoryBarrierWithGroupSync();
		const float Neighbour = Shared[(I + Turn + 1) % 48];
		if (Turn % 2 == 1)
		{
			Mine[Turn % 5] += Neighbour;
			GroupMemoryBarrierWithGroupSync();
			Count += I;
		}
		else
		{
			GroupMemoryBarrierWithGroupSync();
			Sum += Neighbour;
		}
		if (Turn == 5)
		{
			break;
		}
	}
	Out[I] = Sum + float(Count) * 1000.0f + Mine[1];
}
)";
	for (const uint32_t Turns : {0u, 1u, 4u, 9u})
	{
		std::vector<std::vector<float>> Mine(48, std::vector<float>(5));
		std::vector<float> Chosen(48, -1), Sum(48), Shared(48);
		std::vector<uint32_t> Count(48);
		for (uint32_t i = 0; i < 48; ++i)
		{
			for (uint32_t k = 0; k < 5; ++k)
			{
				Mine[i][k] = float(i * 5 + k);
			}
			Chosen[i] = i % 3 == 0 ? Mine[i][i % 5] : -1;
		}
		for (uint32_t Turn = 0; Turn < Turns && Turn < 6; ++Turn)
		{
			for (uint32_t i = 0; i < 48; ++i)
			{
				Shared[i] = Mine[i][(i + Turn) % 5] + Chosen[i];
			}
			for (uint32_t i = 0; i < 48; ++i)
			{
				const float Neighbour = Shared[(i + Turn + 1) % 48];
				(Turn % 2 ? Mine[i][Turn % 5] : Sum[i]) += Neighbour;
				Count[i] += Turn % 2 ? i : 0;
			}
		}
		SCOPED_TRACE(std::to_string(Turns) + " turns");
		ForEachForm(
			Text, 48, 1, 1,
			[&](FShaderHarness& H)
			{
				H.Constants["Turns"] = {Turns};
				H.Buffers["Out"].assign(48, 0);
			},
			[&](FShaderHarness& H)
			{
				for (uint32_t i = 0; i < 48; ++i)
				{
					EXPECT_EQ(Sum[i] + float(Count[i]) * 1000.0f + Mine[i][1], H.BufferFloat("Out", i)) << i;
				}
			});
	}
}

TEST(ShaderGroups, ThreadsThatReturnedAreNotWaitedFor)
{
	const std::string Text = R"(
RWStructuredBuffer<uint> Out;
groupshared uint Shared[64];
[numthreads(64, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID, uint I : SV_GroupIndex)
{
	if (Id.x >= 50)
	{
		return;
	}
	Shared[I] = I * I;
	GroupMemoryBarrierWithGroupSync();
	Out[Id.x] = Shared[(I + 1) % 50];
}
)";
	ForEachForm(
		Text, 64, 1, 1, [&](FShaderHarness& H) { H.Buffers["Out"].assign(64, 7); },
		[&](FShaderHarness& H)
		{
			for (uint32_t i = 0; i < 64; ++i)
			{
				EXPECT_EQ(i < 50 ? (i + 1) % 50 * ((i + 1) % 50) : 7, H.Buffers["Out"][i]) << i;
			}
		});
}

/** The last group that is done adds up what all have written, as in AMD's single pass downsampler. */
TEST(ShaderGroups, AConditionFromGroupsharedMemoryIsTheSameForAllThreads)
{
	const std::string Text = R"(
globallycoherent RWStructuredBuffer<uint> Counter;
RWStructuredBuffer<uint> Out;
groupshared uint NumDone;
groupshared uint Part[64];
bool IsLast() { GroupMemoryBarrierWithGroupSync(); return NumDone == 3; }
[numthreads(64, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID, uint I : SV_GroupIndex)
{
	if (I == 0)
	{
		InterlockedAdd(Counter[0], 1, NumDone);
	}
	if (IsLast())
	{
		Part[I] = I * 2;
		GroupMemoryBarrierWithGroupSync();
		const uint Turns = Part[2];
		for (uint k = 0; k < Turns; ++k)
		{
			Part[I] += Part[63 - I] * 0;
			GroupMemoryBarrierWithGroupSync();
		}
		Out[I] = Part[63 - I] + Turns;
	}
}
)";
	ForEachForm(
		Text, 256, 1, 1,
		[&](FShaderHarness& H)
		{
			H.Buffers["Counter"].assign(1, 0);
			H.Buffers["Out"].assign(64, 7);
		},
		[&](FShaderHarness& H)
		{
			EXPECT_EQ(4u, H.Buffers["Counter"][0]);
			for (uint32_t i = 0; i < 64; ++i)
			{
				EXPECT_EQ((63 - i) * 2 + 4, H.Buffers["Out"][i]) << i;
			}
		});
}

TEST(ShaderGroups, ABarrierThatNotAllThreadsReachIsNamed)
{
	const std::string If =
		ErrorOfBody("groupshared uint S;", "if (I < 3)\n{\nGroupMemoryBarrierWithGroupSync();\n}\nOut[I] = S;");
	EXPECT_THAT(
		If, HasSubstr("/Test/Shader.usf:8: error: a barrier (GroupMemoryBarrierWithGroupSync) under a condition "
					  "that is not known to be the same for all threads of the group (line 6)"));
	const std::string Between =
		ErrorOfBody("groupshared uint S;", "GroupMemoryBarrierWithGroupSync();\nS = I;\n"
										   "if (S < 3)\n{\nGroupMemoryBarrierWithGroupSync();\n}\nOut[I] = S;");
	EXPECT_THAT(Between, HasSubstr("/Test/Shader.usf:10: error: a barrier"));
	const std::string Loop = ErrorOfBody(
		"groupshared uint S;", "for (uint k = 0; k < I; ++k)\n{\nGroupMemoryBarrierWithGroupSync();\n}\nOut[I] = S;");
	EXPECT_THAT(Loop, HasSubstr("/Test/Shader.usf:8: error: a barrier (GroupMemoryBarrierWithGroupSync) in a loop that "
								"threads of a group may leave at different times"));
}

TEST(ShaderGroups, LimitsAreThoseOfDirect3D)
{
	EXPECT_THAT(ErrorOfBody("groupshared float4 S[2049];",
					"S[I] = I;\nGroupMemoryBarrierWithGroupSync();\nOut[I] = S[I ^ 1].x;"),
		HasSubstr("groupshared variables of 32784 bytes; Direct3D's limit is 32768 a group"));
	EXPECT_EQ("", ErrorOfBody("groupshared float4 S[2048];",
					  "S[I] = I;\nGroupMemoryBarrierWithGroupSync();\nOut[I] = S[I ^ 1].x;"));
}

TEST(ShaderGroups, ABarrierThatSomeThreadsMissIsInTheReflection)
{
	const auto Reflect = [](const std::string& Body)
	{
		const std::string Text =
			"groupshared uint S[64];\nRWBuffer<uint> Out;\n"
			"[numthreads(64, 1, 1)] void MainCS(uint I : SV_GroupIndex, uint3 G : SV_GroupID)\n{\n" +
			Body + "\nS[I] = I;\nGroupMemoryBarrierWithGroupSync();\nOut[I] = S[I ^ 1];\n}\n";
		const FShaderReflection Reflection =
			ReflectShader(FShaderHarness(Text, "MainCS", EShaderStage::Compute).Request);
		const std::optional<FShaderReflection> FromCache = ReflectionFromJson(ReflectionToJson(Reflection));
		return FromCache ? FromCache->PartedBarrier : "unreadable";
	};
	EXPECT_EQ("", Reflect(""));
	EXPECT_EQ("", Reflect("if (G.x == 3) { return; }"));
	EXPECT_EQ("/Test/Shader.usf:7", Reflect("if (I > 59) { return; }"));
}
