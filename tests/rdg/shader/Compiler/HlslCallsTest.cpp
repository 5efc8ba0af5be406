// Intrinsics, matrices, buffers of bytes and choices in shaders that run: the numbers are worked out by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ShaderSnippets.h"

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

} // namespace

// The snippets are tables: one line each.
// clang-format off
TEST(HlslCalls, NewerIntrinsics)
{
	ExpectSnippets("",
		{
			{"AddUint64 carries", "R = AddUint64(uint2(0xffffffffu, u), uint2(1, 5)).y;", {6, 7, 8, 9}},
			{"AddUint64 of two", "uint4 V = AddUint64(uint4(1, 2, 0xfffffffeu, u), uint4(3, 4, 3, 0)); R = V.x * 1000 + V.y * 100 + V.z * 10 + V.w;", {4611, 4612, 4613, 4614}},
			{"dot4add_u8packed", "R = dot4add_u8packed(0x01020304u, 0xff000000u | u, 7u);", {262, 266, 270, 274}},
			{"dot4add_i8packed", "R = dot4add_i8packed(0x01020304u, 0xff000000u | u, 7);", {6, 10, 14, 18}},
			{"dot2add", "R = dot2add(float2(x, 2), float2(3, 4), 0.5);", {8.5f, 11.5f, 14.5f, 17.5f}},
			{"msad4", "uint4 V = msad4(0x00000a05u, uint2(0x00000507u + u, 0), uint4(0, 100, 200, 300)); R = V.x;", {7, 8, 9, 10}},
			{"msad4 slides", "uint4 V = msad4(0x0a00u, uint2(0x04030201u, 0x05u), uint4(0, 0, 0, 0)); R = V.x + V.y * 10 + V.z * 100 + V.w * 1000;", {8 + 70 + 600 + 5000}},
			{"normalize of a scalar", "R = normalize(x - 2.0f + 0.5f);", {-1, -1, 1, 1}},
			{"unsigned", "unsigned int A = 7; unsigned B = u; R = A + B;", {7, 8, 9, 10}},
			{"any and all of constants", "R = (any(float4(0, 0, 0, 0.5)) ? 1 : 0) + (all(uint2(1, 0)) ? 2 : 0) + (all(int3(1, 2, 3)) ? 4 : 0);", {5}},
			{"an author's own", "R = NonUniformResourceIndex(n) + 1;", {1, 2, 3, 4}},
		});
}

TEST(HlslCalls, AFunctionOfThatNameIsTheAuthors)
{
	ExpectSnippets("uint dot2add(uint A) { return A + 40; }\n", {{"own", "R = dot2add(u);", {40, 41, 42, 43}}});
}

TEST(HlslCalls, ComparedStores)
{
	ExpectSnippets("groupshared int Shared[4];\nRWByteAddressBuffer Bytes;\n",
		{
			{"groupshared", "Shared[n] = n; if (n > 1) InterlockedCompareStore(Shared[n], n, 50); R = Shared[n];", {0, 1, 50, 50}},
			{"another value", "Shared[n] = 5; InterlockedCompareStore(Shared[n], 6, 1); R = Shared[n];", {5}},
			{"bytes", "Bytes.Store(u * 4, u); Bytes.InterlockedCompareStore(u * 4, 2u, 70u); R = Bytes.Load(u * 4);", {0, 1, 70, 3}},
		},
		[](FShaderHarness& Harness) { Harness.Buffers["Bytes"].assign(4, 0); });
}

TEST(HlslCalls, MatricesOfAnyParts)
{
	ExpectSnippets("float Corner(float3x2 M) { return M[2][1]; }\n",
		{
			{"vectors across rows", "float3x2 M = float3x2(float3(x, 2, 3), float3(4, 5, 6)); R = M[0][0] * 100 + M[1][0] * 10 + M[2][1];", {36, 136, 236, 336}},
			{"initializer list", "float2x2 M = {float2(x, 1), 2, 3}; R = M[0][0] + M[1][0] * 10 + M[1][1] * 100;", {320, 321, 322, 323}},
			{"matrices and scalars", "float2x2 A = float2x2(1, 2, 3, x); float3x2 M = float3x2(A, 5, 6); R = M[1][1] * 10 + M[2][0];", {5, 15, 25, 35}},
			{"a row", "float1x3 M = float1x3(x, 5, 7); R = M[0][0] + M[0].y * 10 + M._m02 * 100;", {750, 751, 752, 753}},
			{"a column", "float3x1 M = float3x1(x, 5, 7); R = M[0] + M[1][0] * 10 + M._m20 * 100;", {750, 751, 752, 753}},
			{"a row turned", "float3x1 M = transpose(float1x3(x, 5, 7)); R = M[2][0] + M[0][0];", {7, 8, 9, 10}},
			{"as an argument", "R = Corner(float3x2(float3(1, 2, 3), float3(4, 5, x)));", {0, 1, 2, 3}},
			{"constants", "float2x2 M = step(float2x2(0, 1, -1, 2), float2x2(0, 0.5, -1, 3)); R = M[0][0] + M[0][1] * 10 + M[1][0] * 100 + M[1][1] * 1000;", {1101}},
			{"of bool", "bool2x2 M = bool2x2(n > 0, n > 1, 0.5, true); R = (M[0][0] ? 1 : 0) + (M[0][1] ? 10 : 0) + (M[1][0] ? 100 : 0);", {100, 101, 111, 111}},
			{"and, or", "bool2x2 A = bool2x2(true, false, n == 1, true); bool2x2 B = bool2x2(n == 1, true, true, false); bool2x2 C = and(A, B); bool2x2 D = or(A, B); R = (C[0][0] ? 1 : 0) + (C[1][0] ? 10 : 0) + (C[1][1] ? 100 : 0) + (D[0][1] ? 1000 : 0);", {1000, 1011, 1000, 1000}},
		});
}

TEST(HlslCalls, ProductsOfIntegers)
{
	ExpectSnippets("",
		{
			{"vector and matrix", "int2x3 M = int2x3(1, 2, 3, 4, 5, 6); int3 V = mul(int2(n, 2), M); R = V.x * 100 + V.y * 10 + V.z;", {912, 1035, 1158, 1281}},
			{"matrix and vector", "int2x3 M = int2x3(1, 2, 3, 4, 5, 6); R = mul(M, int3(n, 1, 1)).y;", {11, 15, 19, 23}},
			{"matrices", "uint2x2 M = uint2x2(1, 2, 3, u); uint2x2 P = mul(M, M); R = P[1][1];", {6, 7, 10, 15}},
			{"beyond a float", "int2x2 M = int2x2(16777217, 0, 0, 1); R = mul(M, int2(1, n)).x == 16777217;", {1}},
			{"matrix and scalar", "int2x2 M = int2x2(1, 2, 3, 16777217); int2x2 P = mul(M, n); R = P[1][0] + (P[1][1] == 16777217 * n ? 100 : 0);", {100, 103, 106, 109}},
		});
}

TEST(HlslCalls, TypesInBuffersOfBytes)
{
	ExpectSnippets("struct FPart { float2 A; bool B; };\nstruct FItem { int C[2]; FPart P; float2x2 M; };\nRWByteAddressBuffer Bytes;\n"
		"float Read(RWByteAddressBuffer B, uint At) { return B.Load<float>(At); }\n",
		{
			{"vectors", "Bytes.Store<float3>(u * 64, float3(x, 2.5, -1)); float3 V = Bytes.Load<float3>(u * 64); R = V.x + V.y + V.z;", {1.5f, 2.5f, 3.5f, 4.5f}},
			{"bits of floats", "Bytes.Store<float>(u * 64, 1.0f); R = Bytes.Load(u * 64) == 0x3f800000u;", {1}},
			{"without the type", "Bytes.Store(u * 64, 2.0f); R = asfloat(Bytes.Load(u * 64)) + Bytes.Load<float>(u * 64);", {4}},
			{"structs", "FItem I; I.C[0] = n; I.C[1] = -7; I.P.A = float2(x, 2); I.P.B = n > 1; I.M = float2x2(1, 2, 3, x); Bytes.Store<FItem>(u * 64, I); FItem J = Bytes.Load<FItem>(u * 64); R = J.C[0] + J.C[1] + J.P.A.y + (J.P.B ? 100 : 0) + J.M[1][1] * 1000;", {-5, 996, 2097, 3098}},
			{"a parameter of a function", "Bytes.Store<float>(u * 64, x + 2); R = Read(Bytes, u * 64);", {2, 3, 4, 5}},
			{"rows in memory", "Bytes.Store<float2x2>(u * 64, float2x2(1, 2, 3, x)); R = asfloat(Bytes.Load(u * 64 + 8)) * 10 + asfloat(Bytes.Load(u * 64 + 12));", {30, 31, 32, 33}},
		},
		[](FShaderHarness& Harness) { Harness.Buffers["Bytes"].assign(64, 0); });
}

TEST(HlslCalls, StructsWithBases)
{
	ExpectSnippets("struct FBase { float A; float Twice() { return A * 2; } };\nstruct FItem : FBase { float B; float Sum() { return A + B; } };\n",
		{{"members and methods", "FItem I; I.A = x; I.B = 10; R = I.Twice() + I.Sum();", {10, 13, 16, 19}}});
}

TEST(HlslCalls, ChoicesOfWavesAreForThoseWhoCome)
{
	ExpectSnippets("float Total(float V) { return WaveActiveSum(V); }\n",
		{
			{"declared", "float S = n > 1 ? WaveActiveSum(x) : -1; R = S;", {-1, -1, 5, 5}},
			{"assigned", "R = n > 1 ? -1 : WaveActiveSum(x + 1);", {3, 3, -1, -1}},
			{"added", "R = 10; R += n < 1 ? WaveActiveSum(1.0f) : 2;", {11, 12, 12, 12}},
			{"in each other", "R = n == 0 ? 100 : n == 1 ? 200 : WaveActiveSum(x);", {100, 200, 5, 5}},
			{"through a function", "R = n > 2 ? Total(x) : 0;", {0, 0, 0, 3}},
			{"and", "bool B = n > 1 && WaveActiveMin(x) == x; R = B;", {0, 0, 1, 0}},
			{"or", "bool B = n > 1 || WaveActiveMax(x) == x; R = B;", {0, 1, 1, 1}},
			{"if", "if (n > 0 && WaveActiveMin(x) == x) R = 5; else R = 7;", {7, 5, 7, 7}},
			{"of a loop", "R = 0; for (int i = 0; i < 3 && WaveActiveAnyTrue(n > i + 1); ++i) R += 1;", {2}},
			{"in an argument", "R = abs(n > 2 ? WaveActiveSum(-1.0f) : 0);", {0, 0, 0, 1}},
			{"not behind one", "R = WaveActiveSum(x) > 5 ? x : 9;", {0, 1, 2, 3}},
			{"in another argument", "R = max(n > 1 ? 1 : 2, WaveActiveSum(x));", {6}},
			{"vectors", "float2 V = float2(x, 1); bool2 B = WaveActiveAllEqual(V); R = (B.x ? 1 : 0) + (B.y ? 10 : 0);", {10}},
		});
}
// clang-format on
