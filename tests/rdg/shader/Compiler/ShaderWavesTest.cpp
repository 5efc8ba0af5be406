// Wave operations: kernels at every lane count and the interpreter, at every wave size, against plain C++.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ShaderHarness.h"

#include <functional>
#include <random>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::HasSubstr;

constexpr uint32_t NumThreads = 80; // the last wave of 32 and that of 64 are not full

std::vector<uint32_t> DrawNumbers(uint32_t Seed)
{
	std::mt19937 Random(Seed);
	std::vector<uint32_t> Numbers(NumThreads);
	for (uint32_t& Number : Numbers)
	{
		Number = uint32_t(Random() % 100);
	}
	return Numbers;
}

/** `Out[I] = Expression` for threads with bRuns of the number in V, 777 for others. */
std::string MakeShader(const std::string& Expression)
{
	return "StructuredBuffer<uint> In;\nRWStructuredBuffer<uint> Out;\n[numthreads(80, 1, 1)]\n"
		   "void MainCS(uint I : SV_GroupIndex)\n{\n\tconst uint V = In[I];\n\tuint Result = 777;\n"
		   "\tif (V % 3 != 0)\n\t{\n\t\tResult = " +
		   Expression + ";\n\t}\n\tOut[I] = Result;\n}\n";
}

using FExpected = std::function<uint32_t(
	const std::vector<uint32_t>& Values, const std::vector<uint32_t>& Lanes, uint32_t Lane, uint32_t WaveSize)>;

/** Expected is asked with the numbers of all lanes of the wave, those that run, and the one whose result is wanted. */
void CheckWave(const std::string& Expression, const FExpected& Expected)
{
	const std::vector<uint32_t> In = DrawNumbers(7);
	const std::string Text = MakeShader(Expression);
	const auto Check = [&](FShaderHarness& Harness, uint32_t WaveSize, const std::string& Form)
	{
		for (uint32_t First = 0; First < NumThreads; First += WaveSize)
		{
			std::vector<uint32_t> Values(WaveSize);
			std::vector<uint32_t> Lanes;
			for (uint32_t i = 0; i < WaveSize && First + i < NumThreads; ++i)
			{
				Values[i] = In[First + i];
				if (Values[i] % 3 != 0)
				{
					Lanes.push_back(i);
				}
			}
			for (uint32_t i = 0; i < WaveSize && First + i < NumThreads; ++i)
			{
				const uint32_t Wanted = Values[i] % 3 != 0 ? Expected(Values, Lanes, i, WaveSize) : 777;
				EXPECT_EQ(Wanted, Harness.Buffers["Out"][First + i])
					<< Expression << ", thread " << First + i << ", waves of " << WaveSize << ", " << Form;
			}
		}
	};
	for (const uint32_t WaveSize : {4u, 64u})
	{
		for (const int32_t Lanes : GetLaneCounts())
		{
			FShaderHarness Harness(Text, "MainCS", EShaderStage::Compute);
			Harness.WaveSize = int32_t(WaveSize);
			Harness.Buffers["In"] = In;
			Harness.Buffers["Out"].assign(NumThreads, 0);
			Harness.Run(Lanes, int32_t(NumThreads), 1);
			Check(Harness, WaveSize, std::to_string(Lanes) + " lanes");
		}
		FShaderHarness Harness(Text, "MainCS", EShaderStage::Compute);
		Harness.WaveSize = int32_t(WaveSize);
		Harness.Buffers["In"] = In;
		Harness.Buffers["Out"].assign(NumThreads, 0);
		Harness.RunModel(int32_t(NumThreads), 1);
		Check(Harness, WaveSize, "interpreter");
	}
}

} // namespace

TEST(ShaderWaves, ReductionsAndPrefixes)
{
	// One shader for all: a compiler run each would take long.
	const FExpected Expected =
		[](const std::vector<uint32_t>& Values, const std::vector<uint32_t>& Lanes, uint32_t Lane, uint32_t)
	{
		uint32_t Sum = 0, Product = 1, Least = ~0u, Most = 0, And = ~0u, Or = 0, Xor = 0;
		int32_t SignedLeast = 0x7FFFFFFF, SignedMost = -0x7FFFFFFF - 1;
		uint32_t SumBefore = 0, ProductBefore = 1;
		for (const uint32_t Other : Lanes)
		{
			const uint32_t V = Values[Other];
			Sum += V;
			Product *= V | 1;
			Least = std::min(Least, V);
			Most = std::max(Most, V);
			And &= V | 64;
			Or |= V;
			Xor ^= V;
			SignedLeast = std::min(SignedLeast, int32_t(V) - 50);
			SignedMost = std::max(SignedMost, int32_t(V) - 50);
			SumBefore += Other < Lane ? V : 0;
			ProductBefore *= Other < Lane ? V | 1 : 1;
		}
		return Sum + Product * 3 + Least * 5 + Most * 7 + And * 11 + Or * 13 + Xor * 17 + uint32_t(SignedLeast) * 19 +
			   uint32_t(SignedMost) * 23 + SumBefore * 29 + ProductBefore * 31;
	};
	CheckWave("WaveActiveSum(V) + WaveActiveProduct(V | 1) * 3 + WaveActiveMin(V) * 5 + WaveActiveMax(V) * 7"
			  " + WaveActiveBitAnd(V | 64) * 11 + WaveActiveBitOr(V) * 13 + WaveActiveBitXor(V) * 17"
			  " + uint(WaveActiveMin(int(V) - 50)) * 19 + uint(WaveActiveMax(int(V) - 50)) * 23"
			  " + WavePrefixSum(V) * 29 + WavePrefixProduct(V | 1) * 31",
		Expected);
}

TEST(ShaderWaves, VotesAndBallots)
{
	const FExpected Expected =
		[](const std::vector<uint32_t>& Values, const std::vector<uint32_t>& Lanes, uint32_t Lane, uint32_t)
	{
		bool bAny = false, bAll = true, bEqual = true;
		uint64_t Ballot = 0;
		uint32_t Count = 0, Before = 0;
		for (const uint32_t Other : Lanes)
		{
			const uint32_t V = Values[Other];
			bAny = bAny || V > 90;
			bAll = bAll && V > 1;
			bEqual = bEqual && V / 50 == Values[Lanes[0]] / 50;
			Ballot |= uint64_t(V > 40) << Other;
			Count += V > 40;
			Before += V > 40 && Other < Lane;
		}
		return uint32_t(bAny) + uint32_t(bAll) * 2 + uint32_t(bEqual) * 4 + uint32_t(Lane == Lanes[0]) * 8 +
			   uint32_t(Ballot) * 17 + uint32_t(Ballot >> 32) * 19 + Count * 23 + Before * 29;
	};
	CheckWave(
		"uint(WaveActiveAnyTrue(V > 90)) + uint(WaveActiveAllTrue(V > 1)) * 2 + uint(WaveActiveAllEqual(V / 50)) * 4"
		" + uint(WaveIsFirstLane()) * 8 + WaveActiveBallot(V > 40).x * 17 + WaveActiveBallot(V > 40).y * 19"
		" + WaveActiveCountBits(V > 40) * 23 + WavePrefixCountBits(V > 40) * 29",
		Expected);
}

TEST(ShaderWaves, ReadsOfOtherLanesAndQuads)
{
	const FExpected Expected =
		[](const std::vector<uint32_t>& Values, const std::vector<uint32_t>& Lanes, uint32_t Lane, uint32_t WaveSize)
	{
		const auto Read = [&](uint32_t From)
		{
			return std::find(Lanes.begin(), Lanes.end(), From) == Lanes.end() ? 0 : Values[From];
		};
		return Read(Lanes[0]) + Read(2) * 3 + Read((Lane * 5 + 1) % WaveSize) * 5 + Read(Lane ^ 1) * 7 +
			   Read(Lane ^ 2) * 11 + Read(Lane ^ 3) * 13 + Read((Lane & ~3u) + 3) * 17 + Lane * 19 + WaveSize * 23;
	};
	CheckWave("WaveReadLaneFirst(V) + WaveReadLaneAt(V, 2) * 3"
			  " + WaveReadLaneAt(V, (WaveGetLaneIndex() * 5 + 1) % WaveGetLaneCount()) * 5 + QuadReadAcrossX(V) * 7"
			  " + QuadReadAcrossY(V) * 11 + QuadReadAcrossDiagonal(V) * 13 + QuadReadLaneAt(V, 3) * 17"
			  " + WaveGetLaneIndex() * 19 + WaveGetLaneCount() * 23",
		Expected);
}

TEST(ShaderWaves, APrefixSumOfAWholeGroup)
{
	// Each wave sums its own numbers; groupshared memory adds what the waves before have.
	const std::string Text = R"(
StructuredBuffer<float> In;
RWStructuredBuffer<float> Out;
groupshared float WaveSums[64];
[numthreads(256, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID, uint I : SV_GroupIndex)
{
	const float Value = In[Id.x];
	const float Before = WavePrefixSum(Value);
	const uint Wave = I / WaveGetLaneCount();
	if (WaveGetLaneIndex() == WaveGetLaneCount() - 1)
	{
		WaveSums[Wave] = Before + Value;
	}
	GroupMemoryBarrierWithGroupSync();
	float Sum = 0;
	for (uint k = 0; k < Wave; ++k)
	{
		Sum += WaveSums[k];
	}
	Out[Id.x] = Sum + Before;
}
)";
	std::vector<float> In(512);
	std::mt19937 Random(3);
	for (float& Value : In)
	{
		Value = float(Random() % 1000); // sums are exact
	}
	for (const int32_t WaveSize : {8, 16, 32})
	{
		FShaderHarness Model(Text, "MainCS", EShaderStage::Compute);
		FShaderHarness Kernel(Text, "MainCS", EShaderStage::Compute);
		for (FShaderHarness* const Harness : {&Model, &Kernel})
		{
			Harness->WaveSize = WaveSize;
			Harness->SetFloatBuffer("In", In);
			Harness->Buffers["Out"].assign(512, 0);
		}
		Model.RunModel(512, 1);
		Kernel.Run(0, 512, 1);
		double Sum = 0;
		for (size_t i = 0; i < 512; ++i)
		{
			Sum = i % 256 ? Sum + double(In[i - 1]) : 0;
			EXPECT_EQ(Sum, Kernel.BufferFloat("Out", i)) << i;
			EXPECT_EQ(Sum, Model.BufferFloat("Out", i)) << i;
		}
	}
}

TEST(ShaderWaves, TexturesAreReadByWavesToo)
{
	const std::string Text = R"(
Texture2D<float4> In;
SamplerState InSampler;
RWTexture2D<float4> Out;
[numthreads(8, 8, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID)
{
	const float2 UV = (float2(Id.xy) + 0.5f) / float2(16, 8);
	const float4 Sampled = In.SampleLevel(InSampler, UV * 0.9f, 0) + In.Load(int3(Id.xy, 0)) * 0.25f + sin(UV.x);
	Out[Id.xy] = Sampled + WaveActiveMax(Sampled);
}
)";
	std::mt19937 Random(11);
	FTestTexture In(16, 8);
	for (int32_t i = 0; i < 16 * 8 * 4; ++i)
	{
		In.Texel(i / 4 % 16, i / 64)[i % 4] = float(Random() % 1000) / 100.0f;
	}
	FShaderHarness Model(Text, "MainCS", EShaderStage::Compute);
	Model.Textures["In"] = In;
	Model.Textures["Out"] = FTestTexture(16, 8);
	Model.RunModel(16, 8);
	for (const int32_t Lanes : GetLaneCounts())
	{
		FShaderHarness Kernel(Text, "MainCS", EShaderStage::Compute);
		Kernel.Textures["In"] = In;
		Kernel.Textures["Out"] = FTestTexture(16, 8);
		Kernel.Run(Lanes, 16, 8);
		for (int32_t i = 0; i < 16 * 8 * 4; ++i)
		{
			ASSERT_TRUE(SameFloat(Model.Textures["Out"].Texel(i / 4 % 16, i / 64)[i % 4],
				Kernel.Textures["Out"].Texel(i / 4 % 16, i / 64)[i % 4]))
				<< i << ", " << Lanes << " lanes";
		}
	}
}

TEST(ShaderWaves, PixelShadersHaveNone)
{
	FShaderHarness Harness("float4 MainPS(float2 UV : TEXCOORD0) : SV_Target0\n{\n\treturn WaveActiveSum(UV.x);\n}\n",
		"MainPS", EShaderStage::Pixel);
	EXPECT_THAT(ErrorOf([&] { Harness.Run(0, 4, 4); }),
		HasSubstr("/Test/Shader.usf:3: error: WaveActiveSum: wave operations run in compute shaders only"));
}

TEST(ShaderWaves, TheSizeOfAWaveIsAPowerOfTwo)
{
	FShaderHarness Harness(MakeShader("WaveActiveSum(V)"), "MainCS", EShaderStage::Compute);
	Harness.WaveSize = 12;
	EXPECT_THAT(ErrorOf([&] { Harness.Run(0, 80, 1); }),
		HasSubstr("waves cannot have 12 threads (r.Drydock.WaveSize); they have 4, 8, 16, 32 or 64"));
}
