// Atomic operations: what they do, and in which order threads come. Kernels at every lane count and the interpreter,
// against plain C++.
#include <gtest/gtest.h>

#include "ShaderForms.h"

#include <algorithm>
#include <array>
#include <random>
#include <utility>

using namespace Drydock;
using namespace Drydock::Test;

TEST(ShaderAtomics, OldValuesComeInTheOrderOfThreadsWaveByWave)
{
	// Every thread takes two numbers: those of a wave of 32 take the first ones together, then the second ones.
	const std::string Text = R"(
RWStructuredBuffer<uint> Counter;
RWStructuredBuffer<uint> Out;
[numthreads(40, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID)
{
	uint First, Second;
	InterlockedAdd(Counter[0], 1, First);
	InterlockedAdd(Counter[0], 1, Second);
	Out[Id.x * 2] = First;
	Out[Id.x * 2 + 1] = Second;
}
)";
	std::vector<uint32_t> Expected(160);
	uint32_t Next = 0;
	for (uint32_t Group = 0; Group < 2; ++Group)
	{
		for (const auto& [First, Last] : {std::pair(0u, 32u), std::pair(32u, 40u)})
		{
			for (uint32_t Time = 0; Time < 2; ++Time)
			{
				for (uint32_t i = First; i < Last; ++i)
				{
					Expected[(Group * 40 + i) * 2 + Time] = Next++;
				}
			}
		}
	}
	ForEachForm(
		Text, 80, 1, 1,
		[&](FShaderHarness& H)
		{
			H.Buffers["Counter"] = {0};
			H.Buffers["Out"].assign(160, 0);
		},
		[&](FShaderHarness& H)
		{
			EXPECT_EQ(Expected, H.Buffers["Out"]);
			EXPECT_EQ(160u, H.Buffers["Counter"][0]);
		});
}

TEST(ShaderAtomics, ThreadsThatPartedMeetAgainBeforeTheNextAtomic)
{
	const std::string Text = R"(
RWStructuredBuffer<uint> Counter;
RWStructuredBuffer<uint> Out;
[numthreads(32, 1, 1)]
void MainCS(uint I : SV_GroupIndex)
{
	uint Old = 0;
	for (uint k = 0; k < I % 3; ++k)
	{
		InterlockedAdd(Counter[0], 1, Old);
		Out[I * 4 + k] = Old;
	}
	if (I & 1)
	{
		InterlockedAdd(Counter[0], 100, Old);
		Out[I * 4 + 2] = Old;
	}
	InterlockedAdd(Counter[0], 10000, Old);
	Out[I * 4 + 3] = Old;
}
)";
	std::vector<uint32_t> Expected(128);
	uint32_t Counter = 0;
	const auto Take = [&](uint32_t Place, uint32_t Value)
	{
		Expected[Place] = Counter;
		Counter += Value;
	};
	for (uint32_t k = 0; k < 2; ++k)
	{
		for (uint32_t i = 0; i < 32; ++i)
		{
			if (k < i % 3)
			{
				Take(i * 4 + k, 1);
			}
		}
	}
	for (uint32_t i = 1; i < 32; i += 2)
	{
		Take(i * 4 + 2, 100);
	}
	for (uint32_t i = 0; i < 32; ++i)
	{
		Take(i * 4 + 3, 10000);
	}
	ForEachForm(
		Text, 32, 1, 1,
		[&](FShaderHarness& H)
		{
			H.Buffers["Counter"] = {0};
			H.Buffers["Out"].assign(128, 0);
		},
		[&](FShaderHarness& H) { EXPECT_EQ(Expected, H.Buffers["Out"]); });
}

TEST(ShaderAtomics, AWaveGoesOnToItsBarrierPastWhatTheOptimiserLeft)
{
	// The assignment that nobody reads leaves a block of its own behind the branches: no other wave comes in there.
	const std::string Text = R"(
StructuredBuffer<uint> In;
RWStructuredBuffer<uint> Out;
groupshared uint Bins[16];
uint Mix(uint A, uint B) { if (A % 5 == 2) { return B * 3 + 18; } return A ^ (B << 8); }
[numthreads(64, 1, 1)]
void MainCS(uint3 G : SV_GroupID, uint I : SV_GroupIndex)
{
	uint Old = 0;
	uint V[3] = {In[G.x * 64 + I], I * 7, G.x};
	if ((V[2] & 3) != 0)
	{
		V[2] = V[1] & 6;
		if ((V[2] & 3) != 0)
		{
			if ((V[0] & 3) != 0) { InterlockedAdd(Bins[V[0] % 16], V[1], Old); V[1] ^= Old; }
			else { InterlockedXor(Bins[V[1] % 16], V[2], Old); V[2] ^= Old; }
			V[0] = V[2] - V[0];
		}
	}
	if ((G.x & 1) == 0) { V[2] = V[1] | 6; }
	V[1] = Mix(V[1], V[0]);
	V[2] = Mix(V[1], V[0]);
	if ((V[0] & 3) != 0) { InterlockedXor(Bins[V[2] % 16], V[0]); }
	Out[G.x * 64 + I] = V[0] ^ V[1] * 3 ^ V[2] * 7;
}
)";
	const auto Mix = [](uint32_t A, uint32_t B)
	{
		return A % 5 == 2 ? B * 3 + 18 : A ^ (B << 8);
	};
	std::mt19937 Random(1);
	std::vector<uint32_t> In(192);
	std::generate(In.begin(), In.end(), [&Random] { return uint32_t(Random()); });
	std::vector<uint32_t> Expected(In.size());
	for (uint32_t Group = 0; Group < 3; ++Group)
	{
		uint32_t Bins[16] = {};
		for (uint32_t First = 0; First < 64; First += 32)
		{
			std::array<std::array<uint32_t, 3>, 32> Values;
			for (uint32_t Lane = 0; Lane < 32; ++Lane)
			{
				Values[Lane] = {In[Group * 64 + First + Lane], (First + Lane) * 7, Group};
			}
			// Those of one branch first, then those of the other.
			const auto Before = Values;
			for (const bool bAdds : {true, false})
			{
				for (uint32_t Lane = 0; Lane < 32; ++Lane)
				{
					const auto [Number, Sevens, GroupX] = Before[Lane];
					const uint32_t Bits = Sevens & 6;
					if ((GroupX & 3) == 0 || (Bits & 3) == 0 || ((Number & 3) != 0) != bAdds)
					{
						continue;
					}
					uint32_t& Bin = Bins[(bAdds ? Number : Sevens) % 16];
					const uint32_t Old = Bin;
					Bin = bAdds ? Old + Sevens : Old ^ Bits;
					Values[Lane][0] = (bAdds ? Bits : Bits ^ Old) - Number;
					Values[Lane][1] = bAdds ? Sevens ^ Old : Sevens;
				}
			}
			for (uint32_t Lane = 0; Lane < 32; ++Lane)
			{
				auto& V = Values[Lane];
				V[1] = Mix(V[1], V[0]);
				V[2] = Mix(V[1], V[0]);
				if ((V[0] & 3) != 0)
				{
					Bins[V[2] % 16] ^= V[0];
				}
				Expected[Group * 64 + First + Lane] = V[0] ^ V[1] * 3 ^ V[2] * 7;
			}
		}
	}
	ForEachForm(
		Text, 192, 1, 1,
		[&](FShaderHarness& H)
		{
			H.Buffers["In"] = In;
			H.Buffers["Out"].assign(In.size(), 0);
		},
		[&](FShaderHarness& H) { EXPECT_EQ(Expected, H.Buffers["Out"]); });
}

TEST(ShaderAtomics, EveryInterlockedOperationDoesWhatItSays)
{
	const std::string Text = R"(
RWStructuredBuffer<uint> Unsigned;
RWStructuredBuffer<int> Signed;
RWByteAddressBuffer Bytes;
RWTexture2D<uint> Texels;
RWBuffer<uint> Typed;
groupshared int Shared;
groupshared uint Marks[4];
[numthreads(64, 1, 1)]
void MainCS(uint I : SV_GroupIndex)
{
	if (I == 0)
	{
		Shared = 1000;
	}
	GroupMemoryBarrierWithGroupSync();
	InterlockedMin(Shared, int(I * 7 % 64) - 20);
	InterlockedOr(Marks[I % 4], 1u << (I % 32));
	InterlockedMax(Unsigned[0], I * 7 % 64);
	InterlockedMin(Signed[0], int(I * 7 % 64) - 20);
	InterlockedMax(Signed[1], -int(I) - 5);
	Bytes.InterlockedAdd(8, I);
	Bytes.InterlockedXor(12, 1u << (I % 32));
	Bytes.InterlockedAdd(4000, 1u);
	InterlockedAdd(Texels[uint2(I % 3, 1)], I);
	InterlockedAdd(Texels[uint2(7, 7)], 1u);
	InterlockedAnd(Typed[1], ~(1u << (I % 31)));
	InterlockedAdd(Typed[77], 1u);
	GroupMemoryBarrierWithGroupSync();
	if (I == 0)
	{
		Signed[2] = Shared;
		Unsigned[1] = Marks[0] | Marks[1];
	}
}
)";
	ForEachForm(
		Text, 64, 1, 1,
		[&](FShaderHarness& H)
		{
			H.Buffers["Unsigned"] = {5, 0};
			H.Buffers["Signed"] = {100, uint32_t(-1000), 0};
			H.Buffers["Bytes"].assign(4, 0);
			H.Buffers["Typed"] = {0, ~0u};
			H.Textures["Texels"] = FTestTexture(3, 2, true);
		},
		[&](FShaderHarness& H)
		{
			EXPECT_EQ(63u, H.Buffers["Unsigned"][0]);
			EXPECT_EQ(0x33333333u, H.Buffers["Unsigned"][1]);
			EXPECT_EQ(-20, int32_t(H.Buffers["Signed"][0]));
			EXPECT_EQ(-5, int32_t(H.Buffers["Signed"][1]));
			EXPECT_EQ(-20, int32_t(H.Buffers["Signed"][2]));
			EXPECT_EQ(63u * 32, H.Buffers["Bytes"][2]);
			EXPECT_EQ(0u, H.Buffers["Bytes"][3]);
			EXPECT_EQ(1u << 31, H.Buffers["Typed"][1]);
			EXPECT_EQ(693u, H.Textures["Texels"].Uint(0, 1));
			EXPECT_EQ(651u, H.Textures["Texels"].Uint(1, 1));
			EXPECT_EQ(672u, H.Textures["Texels"].Uint(2, 1));
		});
}

TEST(ShaderAtomics, ExchangesSeeWhatTheThreadBeforeLeft)
{
	const std::string Text = R"(
RWStructuredBuffer<uint> Chain;
RWStructuredBuffer<uint> Out;
[numthreads(8, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID)
{
	uint Before, Taken;
	InterlockedExchange(Chain[0], Id.x + 1, Before);
	InterlockedCompareExchange(Chain[1], Id.x % 8 == 3 ? 0u : 99u, Id.x, Taken);
	Out[Id.x] = Before * 1000 + Taken;
}
)";
	ForEachForm(
		Text, 16, 1, 1,
		[&](FShaderHarness& H)
		{
			H.Buffers["Chain"] = {0, 0};
			H.Buffers["Out"].assign(16, 0);
		},
		[&](FShaderHarness& H)
		{
			for (uint32_t i = 0; i < 16; ++i)
			{
				EXPECT_EQ(i * 1000 + (i > 3 ? 3 : 0), H.Buffers["Out"][i]) << i;
			}
		});
}

TEST(ShaderAtomics, WhatCommutesIsTheSameWhereverItLiesAndWhoeverTakesPart)
{
	// Words that a tile gathers and words that it does not; lanes side by side, apart and on one word; some that do not
	// take part; the end of a buffer, and behind it.
	const std::string Text = R"(
RWStructuredBuffer<uint> Sums;
RWStructuredBuffer<int> Least;
RWStructuredBuffer<int> Most;
RWByteAddressBuffer Bits;
RWBuffer<uint> Kept;
RWStructuredBuffer<uint> Flipped;
[numthreads(24, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID, uint I : SV_GroupIndex)
{
	InterlockedAdd(Sums[Id.x * 37 % 1500], Id.x);
	if (Id.x % 3 != 1)
	{
		InterlockedAdd(Sums[I + 1010], 1000);
	}
	InterlockedMin(Least[I % 5], int(Id.x * 31 % 97) - 50);
	InterlockedMax(Most[I], int(Id.x * 31 % 97) - 50);
	Bits.InterlockedOr(I % 3 * 4, 1u << Id.x % 32);
	InterlockedAnd(Kept[I], ~(1u << Id.x % 32));
	InterlockedXor(Flipped[Id.x % 7], Id.x);
}
)";
	constexpr uint32_t NumThreads = 240;
	std::vector<uint32_t> Sums(1300, 7);
	std::vector<int32_t> Least(5, 20);
	std::vector<int32_t> Most(24, -40);
	std::vector<uint32_t> Bits(3, 0);
	std::vector<uint32_t> Kept(20, ~0u);
	std::vector<uint32_t> Flipped(7, 5);
	for (uint32_t x = 0; x < NumThreads; ++x)
	{
		const uint32_t I = x % 24;
		const uint32_t At = x * 37 % 1500;
		if (At < Sums.size())
		{
			Sums[At] += x;
		}
		Sums[I + 1010] += x % 3 != 1 ? 1000 : 0;
		Least[I % 5] = std::min(Least[I % 5], int32_t(x * 31 % 97) - 50);
		Most[I] = std::max(Most[I], int32_t(x * 31 % 97) - 50);
		Bits[I % 3] |= 1u << x % 32;
		if (I < Kept.size())
		{
			Kept[I] &= ~(1u << x % 32);
		}
		Flipped[x % 7] ^= x;
	}
	ForEachForm(
		Text, NumThreads, 1, 1,
		[&](FShaderHarness& H)
		{
			H.Buffers["Sums"].assign(Sums.size(), 7);
			H.Buffers["Least"].assign(5, 20);
			H.Buffers["Most"].assign(24, uint32_t(-40));
			H.Buffers["Bits"].assign(3, 0);
			H.Buffers["Kept"].assign(20, ~0u);
			H.Buffers["Flipped"].assign(7, 5);
		},
		[&](FShaderHarness& H)
		{
			EXPECT_EQ(Sums, H.Buffers["Sums"]);
			EXPECT_EQ(std::vector<uint32_t>(Least.begin(), Least.end()), H.Buffers["Least"]);
			EXPECT_EQ(std::vector<uint32_t>(Most.begin(), Most.end()), H.Buffers["Most"]);
			EXPECT_EQ(Bits, H.Buffers["Bits"]);
			EXPECT_EQ(Kept, H.Buffers["Kept"]);
			EXPECT_EQ(Flipped, H.Buffers["Flipped"]);
		});
}
