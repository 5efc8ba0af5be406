// HLSL as plugins write it, one feature at a time: the numbers are worked out by hand. All snippets share a few
// shaders, since compiling is what costs time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ShaderSnippets.h"

#include <limits>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

constexpr float Inf = std::numeric_limits<float>::infinity();

} // namespace

// The snippets are tables: one line each.
// clang-format off
TEST(ShaderLanguage, Expressions)
{
	ExpectSnippets("float3 Twice(float3 v) { return v * 2; }\nvoid Split(float v, out float a, inout float b) { a = v + 1; b *= v; }\nfloat Pick(float v) { if (v > 1) return 10; if (v > 0) return 5; return 1; }\n"
		"struct FPair { float A; float2 B; };\nFPair MakePair(float v) { FPair P; P.A = v; P.B = float2(v * 2, v * 3); return P; }\nstatic const float Table[4] = { 1, 10, 100, 1000 };\nstatic float Global = 7;\n",
		{
			{"swizzle of a scalar", "R = x.xxx.y;", {0, 1, 2, 3}},
			{"swizzle assignment", "float4 v = float4(1, 2, 3, 4); v.zx = float2(x, 9); R = v.x * 100 + v.z;", {900, 901, 902, 903}},
			{"function", "R = Twice(float3(1, x, 3)).y;", {0, 2, 4, 6}},
			{"out and inout", "float a; float b = 3; Split(x, a, b); R = a * 10 + b;", {10, 23, 36, 49}},
			{"early return", "R = Pick(x);", {1, 5, 10, 10}},
			{"struct", "FPair P = MakePair(x); P.B.y += 1; R = P.A + P.B.x + P.B.y;", {1, 7, 13, 19}},
			{"constant array", "R = Table[n];", {1, 10, 100, 1000}},
			{"local array, varying index", "float a[4] = { 0, 0, 0, 0 }; a[n] = 5; a[(n + 1) % 4] += 2; R = a[0] * 1000 + a[1] * 100 + a[2] * 10 + a[3];", {5200, 520, 52, 2005}},
			{"two-dimensional array", "float a[2][3] = { { 1, 2, 3 }, { 4, 5, 6 } }; a[n % 2][1] = 9; R = a[0][1] * 10 + a[1][n % 3];", {94, 29, 96, 24}},
			{"vector component by index", "float4 v = float4(5, 6, 7, 8); v[n] = 1; R = v[(n + 1) % 4] * 10 + v[n];", {61, 71, 81, 51}},
			{"select on vectors", "float2 v = select(float2(x, 3 - x) > float2(1, 1), float2(1, 1), float2(2, 4)); R = v.x * 10 + v.y;", {21, 21, 14, 14}},
			{"any and all", "R = (any(float2(x, 0) > 1.5) ? 1 : 0) + (all(float2(x, 3) > 1.5) ? 10 : 0);", {0, 0, 11, 11}},
			{"static global", "Global += x; R = Global; Global = 7;", {7, 8, 9, 10}},
			{"cast of vectors", "R = (float)((int2)float2(x + 0.75, 1)).x;", {0, 1, 2, 3}},
			{"matrix product", "float2x2 m = float2x2(1, 2, 3, 4); float2 v = mul(m, float2(x, 1)); R = v.x * 10 + v.y;", {24, 37, 50, 63}},
			{"row vector times matrix", "float2x2 m = float2x2(1, 2, 3, 4); float2 v = mul(float2(x, 1), m); R = v.x * 10 + v.y;", {34, 46, 58, 70}},
			{"matrix element", "float3x3 m = float3x3(1, 2, 3, 4, 5, 6, 7, 8, 9); R = m[1][2] * 10 + m._m20 + transpose(m)[0][2];", {74}},
			{"determinant", "R = determinant(float3x3(2, 0, 0, 0, 3, 1, 0, 0, x));", {0, 6, 12, 18}},
			{"comma, compound and increments", "int a = 1; int b = a++ + ++a; a <<= 2; R = a * 100 + b;", {1204}},
		});
}

TEST(ShaderLanguage, ControlFlow)
{
	ExpectSnippets("int One;",
		{
			{"uniform value stored under a varying branch", "float a[3] = { 1, 2, 3 }; if (n > 1) a[One] = 5; R = a[One] * 10 + a[One + 1];", {23, 23, 53, 53}},
			{"uniform break while others wait at the end of the body", "int k = 0; for (int i = 0; i < 6; ++i) { k += 1; if (i < 2 * n) continue; if (i == 4) break; R += 1; } R = R * 10 + k;", {45, 25, 5, 6}},
			{"loop with varying bound", "for (int i = 0; i <= n; ++i) R += i + 1;", {1, 3, 6, 10}},
			{"break", "for (int i = 0; i < 10; ++i) { if (i == n) break; R += 1; }", {0, 1, 2, 3}},
			{"continue", "for (int i = 0; i < 4; ++i) { if (i == n) continue; R += i + 1; }", {9, 8, 7, 6}},
			{"while", "float v = x; while (v < 5) { v += 2; R += 1; }", {3, 2, 2, 1}},
			{"do", "float v = x; do { v *= 2; R += 1; } while (v < 5 && R < 6);", {6, 3, 2, 1}},
			{"value after a loop left at different times", "int i = 0; for (; i < 8; ++i) { if (i * i >= n) break; } R = i;", {0, 1, 2, 2}},
			{"nested loops", "for (int i = 0; i < 3; ++i) for (int j = 0; j < n; ++j) { if (j > i) break; R += 1; }", {0, 3, 5, 6}},
			{"switch", "switch (n) { case 0: R = 5; break; case 2: R = 7; break; default: R = 9; break; }", {5, 9, 7, 9}},
			{"switch with shared labels", "switch (n) { case 0: case 3: R = 5; break; case 1: R = 6; break; }", {5, 6, 0, 5}},
			{"switch inside a loop", "for (int i = 0; i < 3; ++i) { switch (n) { case 0: R += 1; break; case 1: R += 10; continue; default: R += 100; break; } R += 0.5; }", {4.5f, 30, 301.5f, 301.5f}},
			{"loop that some threads never enter", "if (n > 1) { for (int i = 0; i < n; ++i) R += 2; } else R = -1;", {-1, -1, 4, 6}},
			{"uniform loop under a varying branch", "if (n != 2) { for (int i = 0; i < 3; ++i) R += x; }", {0, 3, 0, 9}},
			{"uniform break after a varying continue", "for (int i = 0; i < 6; ++i) { if (i < n) continue; if (i == 4) break; R += 1; }", {4, 3, 2, 1}},
		},
		[](FShaderHarness& H) { H.Constants["One"] = {1}; });
}

TEST(ShaderLanguage, Numbers)
{
	ExpectSnippets("float Big; float NotANumber; int Zero;\n",
		{
			{"remainder keeps the sign of the dividend", "R = (-7 + n) % 3;", {-1, 0, -2, -1}},
			{"fmod keeps the sign of the dividend", "R = fmod(x - 5.5, 2.0);", {-1.5f, -0.5f, -1.5f, -0.5f}},
			{"float remainder", "R = (x - 5.5) % 2.0;", {-1.5f, -0.5f, -1.5f, -0.5f}},
			{"unsigned division by zero", "R = (u / (uint)Zero) == 0xFFFFFFFFu;", {1}},
			{"unsigned compare", "R = (uint)(n - 1) > 5u;", {1, 0, 0, 0}},
			{"logical against arithmetic shift", "R = ((uint)(-8 + n) >> 28) * 100 + ((-8 + n) >> 1);", {1496, 1496, 1497, 1497}},
			{"shifts use five bits", "R = (1u << (u + 32u));", {1, 2, 4, 8}},
			{"float to int saturates", "R = (int)(Big * (1 + x)) == 2147483647;", {1}},
			{"float to uint saturates", "R = (uint)(-Big) == 0u && (uint)Big == 0xFFFFFFFFu;", {1}},
			{"not a number to int", "R = (int)(NotANumber + x);", {0}},
			{"min and max drop a not-a-number", "R = min(NotANumber, x) + max(x, NotANumber);", {0, 2, 4, 6}},
			{"saturate of a not-a-number", "R = saturate(NotANumber * (x + 1));", {0}},
			{"a not-a-number differs from itself", "float v = NotANumber + x; R = (v != v ? 1 : 0) + (v == v ? 10 : 0) + (isnan(v) ? 100 : 0);", {101}},
			{"bits of a float", "R = asfloat(asuint(x) ^ 0x80000000u) + (asint(-0.0) < 0);", {1, 0, -1, -2}},
			{"halves", "R = f16tof32(f32tof16(x + 0.1));", {0.0999755859375f, 1.099609375f, 2.099609375f, 3.099609375f}},
			{"bit counts", "R = countbits(u * 5u) * 10000 + firstbithigh(u + 8u) * 100 + firstbitlow(u + 8u);", {303, 20300, 20301, 40300}},
			{"round to even", "R = round(x + 0.5) * 10 + trunc(-1.5 - x);", {-1, 18, 17, 36}},
			{"rounding", "R = floor(x - 0.5) + ceil(x + 0.25) * 10 + frac(x + 0.25) * 4;", {10, 21, 32, 43}},
			{"interpolation", "R = lerp(10, 20, x * 0.5) + step(1, x) * 100 + smoothstep(0, 2, x) * 1000;", {10, 615, 1120, 1125}},
			{"lengths", "R = length(float2(3, 4)) + distance(float2(x, 0), float2(0, 0)) + dot(float3(1, 2, 3), float3(1, 1, x));", {8, 12, 16, 20}},
			{"normalize and cross", "float3 v = cross(float3(1, 0, 0), float3(0, 1, 0)); R = v.z + normalize(float3(0, 0, x + 1)).z * 10;", {11}},
			{"sign and abs", "R = sign(x - 1) * 10 + abs(x - 2);", {-8, 1, 10, 11}},
			{"modf", "float w; float f = modf(x + 2.25, w); R = w * 10 + f;", {20.25f, 30.25f, 40.25f, 50.25f}},
			{"mixed int and float", "R = 3 / 2 + 3 / 2.0 + n * 0.5;", {2.5f, 3.0f, 3.5f, 4.0f}},
			{"negative power", "R = isnan(pow(-1 - x, 0.5));", {1}},
		},
		[](FShaderHarness& H)
		{
			H.SetFloats("Big", {1e20f});
			H.SetFloats("NotANumber", {std::numeric_limits<float>::quiet_NaN()});
			H.Constants["Zero"] = {0};
		});
}

TEST(ShaderLanguage, Parameters)
{
	ExpectSnippets("bool Flag; int3 I3; float2 F2[3]; float3x3 M3; float2x4 M24; row_major float2x2 RM; column_major float2x2 CM; cbuffer Own { float2 InBuffer; float Behind; };\n"
		"struct FItem { float A; float3 B; int C; }; StructuredBuffer<FItem> Items; Buffer<float4> Typed; ByteAddressBuffer Bytes;\n",
		{
			{"bool", "R = Flag ? 1 : 2;", {1}},
			{"int3", "R = I3.x * 100 + I3.y * 10 + I3.z;", {123}},
			{"array by uniform index", "R = F2[I3.x].x * 10 + F2[I3.x].y;", {34}},
			{"array by varying index", "R = F2[n % 3].y;", {2, 4, 6, 2}},
			{"matrix by rows", "R = M3[0][1] * 100 + M3[1][0] * 10 + M3[2][2];", {249}},
			{"matrix times vector", "R = mul(M3, float3(1, x, 0)).y;", {4, 9, 14, 19}},
			{"wide matrix", "R = M24[1][3] * 10 + mul(float2(1, x), M24).x;", {81, 86, 91, 96}},
			{"row_major and column_major", "R = RM[0][1] * 10 + CM[0][1];", {23}},
			{"constant buffer", "R = InBuffer.y * 10 + Behind;", {56}},
			{"structured buffer", "R = Items[n % 2].A * 1000 + Items[n % 2].B.z * 10 + Items[n % 2].C;", {1045, 6100, 1045, 6100}},
			{"structured buffer past its end", "R = Items[n + 2].A + Items[1000000000u].B.x + Items[0xFFFFFFFFu].C;", {0}},
			{"typed buffer", "R = Typed[n].y;", {2, 6, 0, 0}},
			{"byte buffer", "R = asfloat(Bytes.Load(n * 4)) + asfloat(Bytes.Load2(0)).y;", {3, 4, 5, 2}},
			{"elements of a buffer", "uint Count; uint Stride; Items.GetDimensions(Count, Stride); R = Count;", {2}},
		},
		[](FShaderHarness& H)
		{
			const auto Bits = [](float Value) { uint32_t Result; std::memcpy(&Result, &Value, 4); return Result; };
			H.Constants["Flag"] = {1};
			H.Constants["I3"] = {1, 2, 3};
			H.SetFloats("F2", {1, 2, 0, 0, 3, 4, 0, 0, 5, 6});
			H.SetFloats("M3", {1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9});
			H.SetFloats("M24", {1, 2, 3, 4, 5, 6, 7, 8});
			H.SetFloats("RM", {1, 2, 0, 0, 3, 4});
			H.SetFloats("CM", {1, 2, 0, 0, 3, 4});
			H.SetFloats("InBuffer", {4, 5});
			H.SetFloats("Behind", {6});
			H.Buffers["Items"] = {Bits(1), Bits(2), Bits(3), Bits(4), 5, Bits(6), Bits(8), Bits(9), Bits(9), 10};
			H.SetFloatBuffer("Typed", {1, 2, 3, 4, 5, 6, 7, 8});
			H.SetFloatBuffer("Bytes", {1, 2, 3});
		});
}

TEST(ShaderLanguage, Textures)
{
	ExpectSnippets("Texture2D T; Texture2D<uint> Ids; SamplerState S; RWTexture2D<float4> Image;\nfloat4 Read(Texture2D Tex, SamplerState Sam, float2 UV) { return Tex.SampleLevel(Sam, UV, 0); }\n",
		{
			{"load", "R = T.Load(int3(n, 1, 0)).y;", {101, 111, 121, 131}},
			{"index", "R = T[uint2(n, 0)].x;", {0, 10, 20, 30}},
			{"load past the edge", "R = T.Load(int3(n - 10, 0, 0)).x + T[uint2(0, 50)].x;", {0}},
			{"sample at a texel centre", "R = T.SampleLevel(S, float2((x + 0.5) / 4, 0.25), 0).x;", {0, 10, 20, 30}},
			{"sample between texels", "R = T.SampleLevel(S, float2((x + 1.0) / 4, 0.5), 0).x;", {55, 65, 75, 80}},
			{"Sample is the first mip", "R = T.SampleLevel(S, float2(0.5, 0.5), 0).x;", {65}},
			{"texture as parameter", "R = Read(T, S, float2((x + 0.5) / 4, 0.75)).x;", {100, 110, 120, 130}},
			{"integer texture", "R = Ids.Load(int3(n, 0, 0));", {7, 8, 9, 10}},
			{"sizes", "uint w, h; T.GetDimensions(w, h); R = w * 10 + h;", {42}},
			{"read back", "Image[uint2(n, 0)] = float4(x, 1, 2, 3); R = Image[uint2(n, 0)].x + Image[uint2(n, 0)].w;", {3, 4, 5, 6}},
		},
		[](FShaderHarness& H)
		{
			H.Textures["T"] = FTestTexture(4, 2);
			H.Textures["Ids"] = FTestTexture(4, 1, true);
			H.Textures["Image"] = FTestTexture(4, 1);
			for (int x = 0; x < 4; ++x)
			{
				H.Textures["Ids"].Uint(x, 0) = uint32_t(7 + x);
				for (int y = 0; y < 2; ++y)
				{
					for (int c = 0; c < 4; ++c)
					{
						H.Textures["T"].Texel(x, y)[c] = float(100 * y + 10 * x + c);
					}
				}
			}
		});
}

// clang-format on

TEST(ShaderEntries, ThreadAndGroupIndices)
{
	FShaderHarness Harness(
		"RWStructuredBuffer<uint> Out; int Width;\n[numthreads(3, 2, 1)] void Main(uint3 D : SV_DispatchThreadID, "
		"uint3 G : SV_GroupID, uint3 T : SV_GroupThreadID, uint I : SV_GroupIndex)\n"
		"{ Out[D.y * Width + D.x] = G.x * 100000 + G.y * 10000 + T.x * 1000 + T.y * 100 + I; }\n",
		"Main", EShaderStage::Compute);
	Harness.Constants["Width"] = {7};
	for (const int32_t Lanes : GetLaneCounts())
	{
		Harness.Buffers["Out"].assign(7 * 5, 0);
		Harness.Run(Lanes, 7, 5);
		for (uint32_t y = 0; y < 5; ++y)
		{
			for (uint32_t x = 0; x < 7; ++x)
			{
				EXPECT_EQ(x / 3 * 100000 + y / 2 * 10000 + x % 3 * 1000 + y % 2 * 100 + y % 2 * 3 + x % 3,
					Harness.Buffers["Out"][y * 7 + x]);
			}
		}
	}
}

TEST(ShaderEntries, ThreadsOutsideTheTileWriteNothing)
{
	FShaderHarness Harness("RWTexture2D<float4> Image;\n[numthreads(8, 8, 1)] void Main(uint2 D : SV_DispatchThreadID) "
						   "{ Image[D] = 1; }\n",
		"Main", EShaderStage::Compute);
	Harness.Textures["Image"] = FTestTexture(20, 3);
	Harness.Run(4, 5, 2);
	EXPECT_EQ(1.0f, Harness.Textures["Image"].Texel(4, 1)[0]);
	EXPECT_EQ(0.0f, Harness.Textures["Image"].Texel(5, 1)[0]);
	EXPECT_EQ(0.0f, Harness.Textures["Image"].Texel(4, 2)[0]);
}

TEST(ShaderEntries, ThirdDimensionRuns)
{
	FShaderHarness Harness(
		"RWStructuredBuffer<uint> Out;\n[numthreads(2, 2, 2)] void Main(uint3 D : SV_DispatchThreadID, uint I : "
		"SV_GroupIndex) { Out[D.z * 4 + D.y * 2 + D.x] = I + D.z * 10; }\n",
		"Main", EShaderStage::Compute);
	Harness.Buffers["Out"].assign(12, 0);
	Harness.Run(4, 2, 2, 3);
	EXPECT_THAT(Harness.Buffers["Out"], testing::ElementsAre(0, 1, 2, 3, 14, 15, 16, 17, 20, 21, 22, 23));
}

TEST(ShaderEntries, PixelPositionIsAtTheCentre)
{
	FShaderHarness Harness(
		"float4 Main(float4 P : SV_POSITION) : SV_Target0 { return P; }\n", "Main", EShaderStage::Pixel);
	Harness.Targets = {FTestTexture(5, 3)};
	Harness.Run(4, 5, 3);
	const float* Texel = Harness.Targets[0].Texel(4, 2);
	EXPECT_THAT(std::vector<float>(Texel, Texel + 4), testing::ElementsAre(4.5f, 2.5f, 0.0f, 1.0f));
}

TEST(ShaderEntries, InterpolantsGoByTheirTexcoord)
{
	// TEXCOORD1 is declared first: the number decides, not the order.
	FShaderHarness Harness("float4 Main(noperspective float4 B : TEXCOORD1, float2 A : TEXCOORD0) : SV_Target0 { "
						   "return float4(A, B.zw); }\n",
		"Main", EShaderStage::Pixel);
	Harness.Interpolants[0] = {{1, 2, 0, 0}, {10, 0, 0, 0}, {0, 100, 0, 0}};
	Harness.Interpolants[1] = {{0, 0, 5, 6}, {0, 0, 0, 0}, {0, 0, 0, 0}};
	Harness.Targets = {FTestTexture(4, 2)};
	Harness.Run(4, 4, 2);
	const float* Texel = Harness.Targets[0].Texel(3, 1);
	EXPECT_THAT(std::vector<float>(Texel, Texel + 4), testing::ElementsAre(36.0f, 152.0f, 5.0f, 6.0f));
}

TEST(ShaderEntries, SeveralTargetsByParametersAndStruct)
{
	const std::string ByParameters =
		"void Main(float4 P : SV_POSITION, out float4 A : SV_Target0, out float4 B : SV_Target1) { A = 1; B = P.x; }\n";
	const std::string ByStruct =
		"struct FIn { float4 P : SV_POSITION; float2 UV : TEXCOORD0; }; struct FOut { float4 A : SV_Target0; float4 B "
		": SV_Target1; };\nFOut Main(FIn I) { FOut O; O.A = 1; O.B = I.P.x; return O; }\n";
	for (const std::string& Text : {ByParameters, ByStruct})
	{
		FShaderHarness Harness(Text, "Main", EShaderStage::Pixel);
		Harness.Targets = {FTestTexture(4, 1), FTestTexture(4, 1)};
		Harness.Run(4, 4, 1);
		EXPECT_EQ(1.0f, Harness.Targets[0].Texel(2, 0)[0]);
		EXPECT_EQ(2.5f, Harness.Targets[1].Texel(2, 0)[0]);
	}
}

TEST(ShaderEntries, DiscardedPixelsKeepTheirTarget)
{
	FShaderHarness Harness("float4 Main(float4 P : SV_POSITION) : SV_Target0 { float4 C = 2; for (int i = 0; i < 3; "
						   "++i) { clip(P.x - 2.0 * i + 1.0); C.x += P.x; } if (P.y > 1) discard; return C; }\n",
		"Main", EShaderStage::Pixel);
	for (const int32_t Lanes : GetLaneCounts())
	{
		Harness.Targets = {FTestTexture(6, 2)};
		Harness.Run(Lanes, 6, 2);
		EXPECT_EQ(0.0f, Harness.Targets[0].Texel(2, 0)[0]); // 2.5 - 4 + 1 < 0
		EXPECT_EQ(2.0f + 3 * 3.5f, Harness.Targets[0].Texel(3, 0)[0]);
		EXPECT_EQ(0.0f, Harness.Targets[0].Texel(3, 1)[0]);
	}
}

TEST(ShaderEntries, EarlyReturnOfTheEntryPoint)
{
	FShaderHarness Harness("void Main(float4 P : SV_POSITION, out float4 O : SV_Target0) { O = 1; if (P.x < 2) return; "
						   "O = 2; if (P.x > 4) { O.x = 3; return; } O.y = 5; }\n",
		"Main", EShaderStage::Pixel);
	for (const int32_t Lanes : GetLaneCounts())
	{
		Harness.Targets = {FTestTexture(6, 1)};
		Harness.Run(Lanes, 6, 1);
		const auto Texel = [&](int32_t X)
		{
			return std::pair(Harness.Targets[0].Texel(X, 0)[0], Harness.Targets[0].Texel(X, 0)[1]);
		};
		EXPECT_EQ(std::pair(1.0f, 1.0f), Texel(1));
		EXPECT_EQ(std::pair(2.0f, 5.0f), Texel(3));
		EXPECT_EQ(std::pair(3.0f, 2.0f), Texel(5));
	}
}

TEST(ShaderEntries, StageMacrosTellTheStage)
{
	FShaderHarness Harness(
		"float4 Main() : SV_Target0 {\n#if PIXELSHADER && !COMPUTESHADER\nreturn VALUE;\n#else\nreturn 0;\n#endif\n}\n",
		"Main", EShaderStage::Pixel);
	Harness.Request.Defines = {{"VALUE", "4"}};
	Harness.Targets = {FTestTexture(1, 1)};
	Harness.Run(4, 1, 1);
	EXPECT_EQ(4.0f, Harness.Targets[0].Texel(0, 0)[0]);
}

TEST(ShaderEntries, CountersCountThreadsThatRun)
{
	FShaderHarness Harness("Texture2D T; SamplerState S;\nfloat4 Main(float4 P : SV_POSITION) : SV_Target0 { float4 C "
						   "= T.SampleLevel(S, 0.5, 0); if (P.x > 3) C += T.Load(int3(0, 0, 0)); return C; }\n",
		"Main", EShaderStage::Pixel);
	Harness.Textures["T"] = FTestTexture(2, 2);
	Harness.Targets = {FTestTexture(5, 2)};
	Harness.Run(4, 5, 2);
	EXPECT_EQ(10u, Harness.Counters.Samples);
	EXPECT_EQ(4u, Harness.Counters.Loads); // x = 3, 4 in two rows
	EXPECT_EQ(10u, Harness.Counters.Stores);
}
