// Numbers of 16 and 64 bits in atomic operations, buffers of bytes, matrices and functions: kernels at every lane
// count, the interpreter and the shader as it is looked into, against plain C++ on random numbers.
#include <gtest/gtest.h>

#include "ShaderForms.h"

#include <cmath>
#include <random>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

std::vector<uint32_t> DrawWords(size_t Count, uint32_t Seed)
{
	std::mt19937 Random(Seed);
	std::vector<uint32_t> Words(Count);
	std::generate(Words.begin(), Words.end(), [&Random] { return uint32_t(Random()); });
	return Words;
}

template<typename T>
T Read(const std::vector<uint32_t>& Words, size_t Byte)
{
	T Value;
	std::memcpy(&Value, reinterpret_cast<const uint8_t*>(Words.data()) + Byte, sizeof(T));
	return Value;
}

template<typename T>
void Write(std::vector<uint32_t>& Words, size_t Byte, T Value)
{
	std::memcpy(reinterpret_cast<uint8_t*>(Words.data()) + Byte, &Value, sizeof(T));
}

constexpr size_t NumThreads = 96; // two groups of 48: a wave and a half each

} // namespace

TEST(ShaderWideForms, InterlockedOfSixtyFourBits)
{
	const std::string Text = R"(
StructuredBuffer<uint64_t> In;
RWStructuredBuffer<uint64_t> Unsigned;
RWStructuredBuffer<int64_t> Signed;
RWByteAddressBuffer Bytes;
RWStructuredBuffer<uint64_t> Out;
groupshared uint64_t Shared[3];
groupshared int64_t Least;
[numthreads(48, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID, uint I : SV_GroupIndex, uint3 Group : SV_GroupID)
{
	const uint64_t V = In[Id.x];
	uint64_t Old[6];
	int64_t OldSigned;
	InterlockedAdd(Unsigned[0], V, Old[0]);
	InterlockedAnd(Unsigned[1], V | 0xFF00FF00FF00FF00ull);
	InterlockedOr(Unsigned[2], V & 0x1111111111111111ull);
	InterlockedXor(Unsigned[3], V);
	InterlockedExchange(Unsigned[4], V, Old[1]);
	InterlockedCompareExchange(Unsigned[5], Id.x % 7 == 6 ? 5 : In[(Id.x + 95) % 96], V, Old[2]);
	InterlockedCompareStore(Unsigned[6], Id.x == 3 ? 12 : 13, V);
	InterlockedMin(Unsigned[7], V);
	InterlockedMax(Unsigned[8], V, Old[3]);
	InterlockedAdd(Unsigned[900], V, Old[4]);
	InterlockedMin(Signed[0], (int64_t)V);
	InterlockedMax(Signed[1], (int64_t)V, OldSigned);
	Bytes.InterlockedAdd64(8 * (Id.x % 3), V);
	Bytes.InterlockedMax64(24, V, Old[5]);
	Bytes.InterlockedCompareStore64(32, Bytes.Load(44) - 1, V);
	if (I == 0)
	{
		Least = 0x7FFFFFFFFFFFFFFFll;
	}
	GroupMemoryBarrierWithGroupSync();
	InterlockedAdd(Shared[I % 3], V);
	InterlockedMin(Least, (int64_t)V);
	GroupMemoryBarrierWithGroupSync();
	for (uint k = 0; k < 6; ++k)
	{
		Out[Id.x * 8 + k] = Old[k];
	}
	Out[Id.x * 8 + 6] = (uint64_t)OldSigned;
	Out[Id.x * 8 + 7] = I == 3 ? (uint64_t)Least : Shared[I % 3];
}
)";
	const std::vector<uint32_t> In = DrawWords(NumThreads * 2, 1);
	std::vector<uint32_t> Unsigned = DrawWords(9 * 2, 2);
	std::vector<uint32_t> Signed = DrawWords(2 * 2, 3);
	std::vector<uint32_t> Bytes = DrawWords(12, 4);
	Write<uint64_t>(Unsigned, 48, 12);
	Write<uint64_t>(Bytes, 32, 76);
	Bytes[11] = 77;
	std::vector<uint32_t> Out(NumThreads * 16);

	std::vector<uint32_t> U = Unsigned, S = Signed, B = Bytes;
	for (size_t i = 0; i < NumThreads; ++i)
	{
		const uint64_t V = Read<uint64_t>(In, i * 8);
		const auto Change = [&](std::vector<uint32_t>& Memory, size_t Byte, auto New)
		{
			const uint64_t Old = Read<uint64_t>(Memory, Byte);
			Write<uint64_t>(Memory, Byte, New(Old));
			return Old;
		};
		const auto Tell = [&](size_t k, uint64_t Old)
		{
			Write<uint64_t>(Out, (i * 8 + k) * 8, Old);
		};
		const auto Max = [V](uint64_t Old)
		{
			return std::max(Old, V);
		};
		const auto Exchange = [V](uint64_t)
		{
			return V;
		};
		const uint64_t Compare = i % 7 == 6 ? 5 : Read<uint64_t>(In, (i + 95) % 96 * 8);
		Tell(0, Change(U, 0, [V](uint64_t Old) { return Old + V; }));
		Change(U, 8, [V](uint64_t Old) { return Old & (V | 0xFF00FF00FF00FF00u); });
		Change(U, 16, [V](uint64_t Old) { return Old | (V & 0x1111111111111111u); });
		Change(U, 24, [V](uint64_t Old) { return Old ^ V; });
		Tell(1, Change(U, 32, Exchange));
		Tell(2, Change(U, 40, [&](uint64_t Old) { return Old == Compare ? V : Old; }));
		Change(U, 48, [&](uint64_t Old) { return Old == (i == 3 ? 12u : 13u) ? V : Old; });
		Change(U, 56, [V](uint64_t Old) { return std::min(Old, V); });
		Tell(3, Change(U, 64, Max));
		Tell(4, 0);
		Change(S, 0, [V](uint64_t Old) { return uint64_t(std::min(int64_t(Old), int64_t(V))); });
		Tell(6, Change(S, 8, [V](uint64_t Old) { return uint64_t(std::max(int64_t(Old), int64_t(V))); }));
		Change(B, i % 3 * 8, [V](uint64_t Old) { return Old + V; });
		Tell(5, Change(B, 24, Max));
		Change(B, 32, [V](uint64_t Old) { return Old == 76 ? V : Old; });
	}
	for (size_t i = 0; i < NumThreads; ++i)
	{
		uint64_t Sum = 0;
		int64_t Least = std::numeric_limits<int64_t>::max();
		for (size_t k = i / 48 * 48; k < i / 48 * 48 + 48; ++k)
		{
			const uint64_t V = Read<uint64_t>(In, k * 8);
			Sum += k % 48 % 3 == i % 48 % 3 ? V : 0;
			Least = std::min(Least, int64_t(V));
		}
		Write<uint64_t>(Out, (i * 8 + 7) * 8, i % 48 == 3 ? uint64_t(Least) : Sum);
	}
	ForEachForm(
		Text, NumThreads, 1, 1,
		[&](FShaderHarness& H)
		{
			H.Buffers["In"] = In;
			H.Buffers["Unsigned"] = Unsigned;
			H.Buffers["Signed"] = Signed;
			H.Buffers["Bytes"] = Bytes;
			H.Buffers["Out"].assign(NumThreads * 16, 0);
		},
		[&](FShaderHarness& H)
		{
			EXPECT_EQ(U, H.Buffers["Unsigned"]);
			EXPECT_EQ(S, H.Buffers["Signed"]);
			EXPECT_EQ(B, H.Buffers["Bytes"]);
			EXPECT_EQ(Out, H.Buffers["Out"]);
		});
}

TEST(ShaderWideForms, BuffersOfBytesHoldTypesOfEveryWidth)
{
	// Each thread copies a struct, whose members begin where C++ would have them, and one half of a word that it shares
	// with its neighbour.
	const std::string Text = R"(
struct FInner { int16_t3 A; double B; };
struct FItem { uint16_t A; FInner Inner; int64_t2 B; float16_t C; uint D; float16_t2 E[2]; uint64_t F; };
ByteAddressBuffer In;
RWByteAddressBuffer Out;
RWByteAddressBuffer Halves;
[numthreads(32, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID)
{
	FItem Item = In.Load<FItem>(Id.x * 80);
	Out.Store<FItem>(Id.x * 80, Item);
	Halves.Store(Id.x * 2, In.Load<uint16_t>((63 - Id.x) * 2));
}
)";
	struct FInner
	{
		int16_t A[3];
		double B;
	};
	struct FItem
	{
		uint16_t A;
		FInner Inner;
		int64_t B[2];
		uint16_t C;
		uint32_t D;
		uint16_t E[2][2];
		uint64_t F;
	};
	static_assert(sizeof(FItem) == 64);
	std::vector<uint32_t> In = DrawWords(64 * 20, 5);
	std::vector<uint32_t> Copied(64 * 20, 0xABABABAB);
	std::vector<uint32_t> Halves(33, 0xABABABAB);
	for (size_t i = 0; i < 64; ++i)
	{
		FItem From = Read<FItem>(In, i * 80);
		From.Inner.B = double(In[i]) / 3;                   // a number in any case
		From.C = uint16_t(From.C & 0x3FFF);                 // and so are these
		From.E[0][0] = From.E[0][1] = uint16_t(0x3C00 + i); // 1 and above
		From.E[1][0] = From.E[1][1] = 0x8001;               // a denormal
		Write(In, i * 80, From);
		FItem To = Read<FItem>(Copied, i * 80);
		To.A = From.A;
		std::copy_n(From.Inner.A, 3, To.Inner.A);
		To.Inner.B = From.Inner.B;
		std::copy_n(From.B, 2, To.B);
		To.C = From.C;
		To.D = From.D;
		std::memcpy(To.E, From.E, sizeof(To.E));
		To.F = From.F;
		Write(Copied, i * 80, To);
	}
	for (size_t i = 0; i < 64; ++i)
	{
		Write(Halves, i * 2, Read<uint16_t>(In, (63 - i) * 2));
	}
	ForEachForm(
		Text, 64, 1, 1,
		[&](FShaderHarness& H)
		{
			H.Buffers["In"] = In;
			H.Buffers["Out"].assign(64 * 20, 0xABABABAB);
			H.Buffers["Halves"].assign(33, 0xABABABAB);
		},
		[&](FShaderHarness& H)
		{
			EXPECT_EQ(Copied, H.Buffers["Out"]);
			EXPECT_EQ(Halves, H.Buffers["Halves"]);
		});
}

TEST(ShaderWideForms, MatricesOfIntegersAreComputedByElements)
{
	const std::string Text = R"(
StructuredBuffer<int64_t> In;
RWStructuredBuffer<int64_t> Out;
[numthreads(8, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID)
{
	const uint At = Id.x * 12;
	int64_t2x3 A = int64_t2x3(In[At], In[At + 1], In[At + 2], In[At + 3], In[At + 4], In[At + 5]);
	int64_t3x2 B = int64_t3x2(In[At + 6], In[At + 7], In[At + 8], In[At + 9], In[At + 10], In[At + 11]);
	int64_t2x2 Product = mul(A, B);
	int64_t3x2 Turned = transpose(A);
	int64_t2x3 Scaled = mul(In[At], A);
	int64_t2 Vector = mul(int64_t2(In[At], In[At + 1]), Product);
	int16_t2x2 Short = int16_t2x2(int16_t(In[At]), int16_t(In[At + 1]), int16_t(In[At + 2]), int16_t(In[At + 3]));
	int16_t2x2 Square = mul(Short, Short);
	for (uint i = 0; i < 4; ++i)
	{
		Out[Id.x * 24 + i] = Product[i / 2][i % 2];
		Out[Id.x * 24 + 4 + i] = Square[i / 2][i % 2];
	}
	for (uint k = 0; k < 6; ++k)
	{
		Out[Id.x * 24 + 8 + k] = Turned[k / 2][k % 2];
		Out[Id.x * 24 + 14 + k] = Scaled[k / 3][k % 3];
	}
	Out[Id.x * 24 + 20] = Vector.x;
	Out[Id.x * 24 + 21] = Vector.y;
	Out[Id.x * 24 + 22] = select(In[At] & 1, In[At + 1], In[At + 2]);
	Out[Id.x * 24 + 23] = sign(In[At + 3]) * 10 + sign(uint16_t(In[At + 4] & 1));
}
)";
	const std::vector<uint32_t> In = DrawWords(8 * 24, 6);
	std::vector<uint32_t> Expected(8 * 48);
	for (size_t i = 0; i < 8; ++i)
	{
		const auto Number = [&](size_t k)
		{
			return Read<uint64_t>(In, (i * 12 + k) * 8);
		};
		const auto Put = [&](size_t k, uint64_t Value)
		{
			Write(Expected, (i * 24 + k) * 8, Value);
		};
		uint64_t Product[4] = {};
		for (size_t k = 0; k < 4; ++k)
		{
			uint32_t Square = 0;
			for (size_t m = 0; m < 3; ++m)
			{
				Product[k] += Number(k / 2 * 3 + m) * Number(6 + m * 2 + k % 2);
			}
			for (size_t m = 0; m < 2; ++m)
			{
				Square += uint32_t(uint16_t(Number(k / 2 * 2 + m))) * uint32_t(uint16_t(Number(m * 2 + k % 2)));
			}
			Put(k, Product[k]);
			Put(4 + k, uint64_t(int64_t(int16_t(uint16_t(Square)))));
		}
		for (size_t k = 0; k < 6; ++k)
		{
			Put(8 + k, Number(k % 2 * 3 + k / 2));
			Put(14 + k, Number(0) * Number(k));
		}
		Put(20, Number(0) * Product[0] + Number(1) * Product[2]);
		Put(21, Number(0) * Product[1] + Number(1) * Product[3]);
		Put(22, Number(0) & 1 ? Number(1) : Number(2));
		const int64_t Signed = int64_t(Number(3));
		Put(23, uint64_t(int64_t((Signed > 0) - (Signed < 0)) * 10 + int64_t(Number(4) & 1)));
	}
	ForEachForm(
		Text, 8, 1, 1,
		[&](FShaderHarness& H)
		{
			H.Buffers["In"] = In;
			H.Buffers["Out"].assign(8 * 48, 0);
		},
		[&](FShaderHarness& H) { EXPECT_EQ(Expected, H.Buffers["Out"]); });
}

TEST(ShaderWideForms, WhatCannotBeSaysSo)
{
	const auto Refuse = [](const std::string& Declarations, const std::string& Body, bool bPixel = false)
	{
		FShaderHarness Harness(Declarations +
								   (bPixel ? "void Main(float4 P : SV_POSITION, out float4 Out : SV_Target0) {"
										   : "[numthreads(8, 1, 1)] void Main(uint3 P : SV_DispatchThreadID) {") +
								   Body + "}",
			"Main", bPixel ? EShaderStage::Pixel : EShaderStage::Compute);
		return ErrorOf([&] { CompileShader(Harness.Request); });
	};
	const std::string Texture = "Texture2D T; SamplerState S; RWStructuredBuffer<float4> O;\n";
	EXPECT_NE(
		std::string::npos, Refuse(Texture, "O[0] = T.Sample(S, 0.5, int2(0, 0), 1.5);").find("write SampleLevel"));
	EXPECT_NE(std::string::npos, Refuse(Texture, "uint Status; Out = T.Sample(S, P.xy, int2(0, 0), 1.5, Status);", true)
									 .find("leave that argument out"));
	EXPECT_NE(std::string::npos, Refuse(Texture, "uint Status; Out = T.Load(int3(0, 0, 0), int2(0, 0), Status);", true)
									 .find("leave that argument out"));
	EXPECT_NE(std::string::npos, Refuse("RWTexture2D<uint64_t> T;\n", "T[P.xy] = 1;").find("Shader.usf:1"));
	EXPECT_EQ(
		"", Refuse("groupshared uint64_t G[4096]; RWStructuredBuffer<uint64_t> O;\n", "G[P.x] = 1; O[P.x] = G[P.x];"));
	EXPECT_NE(std::string::npos,
		Refuse("groupshared uint64_t G[4097]; RWStructuredBuffer<uint64_t> O;\n", "G[P.x] = 1; O[P.x] = G[P.x];")
			.find("32776 bytes"));
}

TEST(ShaderWideForms, WavesCompareEachComponent)
{
	const std::string Text = R"(
StructuredBuffer<int64_t2> In;
StructuredBuffer<uint16_t3> Short;
RWStructuredBuffer<uint> Out;
[numthreads(32, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID)
{
	const bool2 Long = WaveActiveAllEqual(In[Id.x]);
	const bool3 All = WaveActiveAllEqual(Short[Id.x]);
	Out[Id.x] = (Long.x ? 1 : 0) | (Long.y ? 2 : 0) | (All.x ? 4 : 0) | (All.y ? 8 : 0) | (All.z ? 16 : 0);
}
)";
	constexpr size_t NumWaves = 8;
	std::mt19937 Random(7);
	std::vector<uint32_t> In(NumWaves * 32 * 4);
	std::vector<uint32_t> Short(NumWaves * 16 * 3);
	std::vector<uint32_t> Expected;
	for (size_t Wave = 0; Wave < NumWaves; ++Wave)
	{
		const uint32_t Equal = uint32_t(Random()) & 31;
		for (size_t i = 0; i < 32; ++i)
		{
			for (size_t c = 0; c < 5; ++c)
			{
				// One thread alone differs, of 64 bits in the upper half.
				const bool bOther = i == Wave * 3 && !(Equal >> c & 1);
				const size_t Thread = Wave * 32 + i;
				c < 2 ? Write<uint64_t>(In, (Thread * 2 + c) * 8, uint64_t(bOther) << 40 | 5)
					  : Write<uint16_t>(Short, (Thread * 3 + c - 2) * 2, uint16_t(bOther ? 0x8005 : 5));
			}
		}
		Expected.insert(Expected.end(), 32, Equal);
	}
	ForEachForm(
		Text, NumWaves * 32, 1, 1,
		[&](FShaderHarness& H)
		{
			H.Buffers["In"] = In;
			H.Buffers["Short"] = Short;
			H.Buffers["Out"].assign(NumWaves * 32, 0);
		},
		[&](FShaderHarness& H) { EXPECT_EQ(Expected, H.Buffers["Out"]); });
}

TEST(ShaderWideForms, RefractionOfHalvesIsRoundedOnce)
{
	const std::string Text = R"(
StructuredBuffer<float4> In;
RWStructuredBuffer<float3> Out;
[numthreads(16, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID)
{
	const float16_t3 I = float16_t3(In[Id.x * 2].xyz);
	const float16_t3 N = float16_t3(In[Id.x * 2 + 1].xyz);
	Out[Id.x] = float3(refract(I, N, float16_t(In[Id.x * 2].w * 2)));
}
)";
	constexpr size_t NumThreads = 64;
	std::mt19937 Random(8);
	std::uniform_int_distribution<int> Value(-256, 256); // of 1/256: exact as halves
	std::vector<float> In(NumThreads * 8);
	for (float& One : In)
	{
		One = float(Value(Random)) / 256;
	}
	ForEachForm(
		Text, NumThreads, 1, 1,
		[&](FShaderHarness& H)
		{
			H.SetFloatBuffer("In", In);
			H.Buffers["Out"].assign(NumThreads * 3, 0);
		},
		[&](FShaderHarness& H)
		{
			for (size_t i = 0; i < NumThreads; ++i)
			{
				const float* const I = &In[i * 8];
				const float* const N = I + 4;
				const double Ratio = 2 * double(I[3]);
				double Dot = 0;
				for (size_t c = 0; c < 3; ++c)
				{
					Dot += double(I[c]) * double(N[c]);
				}
				const double Under = 1 - Ratio * Ratio * (1 - Dot * Dot);
				for (size_t c = 0; c < 3 && std::abs(Under) > 0.01; ++c) // nearer to 0 rounding decides
				{
					const double Expected =
						Under < 0 ? 0 : Ratio * double(I[c]) - (Ratio * Dot + std::sqrt(Under)) * double(N[c]);
					// Half of a half's last bit, and a few roundings of float.
					EXPECT_NEAR(
						Expected, double(H.BufferFloat("Out", i * 3 + c)), std::abs(Expected) * (1.0 / 2048) + 1e-5);
				}
			}
		});
}
