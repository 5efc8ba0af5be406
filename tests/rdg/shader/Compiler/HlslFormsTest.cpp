// Forms of HLSL 2021 in shaders that run: the numbers are worked out by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ShaderSnippets.h"

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::AllOf;
using testing::HasSubstr;

/** The messages about a compute shader whose line 1 is Globals and whose line 3 is Statement. */
std::string ErrorsOf(const std::string& Globals, const std::string& Statement)
{
	const std::string Text =
		Globals + "\n[numthreads(1, 1, 1)] void Main(uint3 Id : SV_DispatchThreadID) {\n\t" + Statement + "\n}\n";
	return ErrorOf([&] { ReflectShader(FShaderHarness(Text, "Main", EShaderStage::Compute).Request); });
}

/** The floats that a compute shader with RWTexture2D<float4> Out leaves in the texels from (0, 0), which was (1, 2, 3,
 * 4). */
std::vector<float> RunStore(const std::string& Statement)
{
	std::vector<float> Result;
	for (const int32_t Lanes : GetLaneCounts())
	{
		FShaderHarness Harness("RWTexture2D<float4> Out;\n[numthreads(1, 1, 1)] void Main(uint3 Id : "
							   "SV_DispatchThreadID) {\n" +
								   Statement + "\n}\n",
			"Main", EShaderStage::Compute);
		Harness.Textures["Out"] = FTestTexture(2, 1);
		for (int i = 0; i < 8; ++i)
		{
			Harness.Textures["Out"].Texel(i / 4, 0)[i % 4] = float(i + 1);
		}
		Harness.Run(Lanes, 1, 1);
		const float* Texels = Harness.Textures["Out"].Texel(0, 0);
		Result.assign(Texels, Texels + 8);
	}
	return Result;
}

using FFloats = std::vector<float>;

} // namespace

// The snippets are tables: one line each.
// clang-format off
TEST(HlslForms, NamesOfToday)
{
	ExpectSnippets("using float2s = float2;\ntypedef uint32_t FIndex;\nfloat32_t3 Twice(float32_t3 V) { return V * 2; }\nstatic const int32_t2 Pair = int32_t2(3, 4);\n",
		{
			{"sized vectors", "uint32_t2 V = uint32_t2(u, 7); R = V.x * 10 + V.y;", {7, 17, 27, 37}},
			{"sized matrix", "float32_t2x2 M = float32_t2x2(1, 2, 3, 4); R = M[1][0];", {3}},
			{"sized scalar and cast", "R = (int32_t)(x + 0.9) - Pair.y + (float32_t)FIndex(u);", {-4, -2, 0, 2}},
			{"function of sized types", "R = Twice(float32_t3(1, x, 2)).y;", {0, 2, 4, 6}},
			{"using", "float2s V = float2s(x, 1); R = V.x + V.y;", {1, 2, 3, 4}},
		});
}

TEST(HlslForms, SelectAndLogicByComponent)
{
	ExpectSnippets("float2 First(float2 A, float2 B) { return select(A > B, A, B); }\n",
		{
			{"scalar", "R = select(n > 1, 10.0, 20.0);", {20, 20, 10, 10}},
			{"vector", "float3 V = select(float3(x, 1, 5) > 1.5, float3(1, 2, 3), float3(10, 20, 30)); R = V.x + V.y + V.z;", {33, 33, 24, 24}},
			{"vector and scalar", "float3 V = select(float3(x, 1, 5) > 1.5, float3(1, 2, 3), 0.5f); R = V.x + V.y + V.z;", {4, 4, 4.5f, 4.5f}},
			{"float and integer", "float2 V = select(bool2(n > 0, n > 1), x, 7); R = V.x * 10 + V.y;", {77, 17, 22, 33}},
			{"one condition of a vector", "float2 V = select(n == 2, float2(1, 2), float2(3, 4)); R = V.x * 10 + V.y;", {34, 34, 12, 34}},
			{"nested", "R = select(n > 0, select(n > 2, 3.0, 2.0), 1.0);", {1, 2, 2, 3}},
			{"with commas inside", "R = select(any(float2(x, 0) > 2), min(x, 2), max(x, 1));", {1, 1, 2, 2}},
			{"and", "bool2 B = and(bool2(n > 0, n > 1), bool2(true, n < 3)); R = (B.x ? 1 : 0) + (B.y ? 10 : 0);", {0, 1, 11, 1}},
			{"or", "R = or(n == 0, n == 3) ? 1 : 0;", {1, 0, 0, 1}},
			{"in a function", "R = First(float2(x, 2), float2(1, x)).y;", {2, 2, 2, 3}},
		});
}

TEST(HlslForms, FunctionsOfTheseNamesAreTheAuthors)
{
	ExpectSnippets("float select(float A, float B, float C) { return A * 100 + B * 10 + C; }\nstruct FMask { float V; float dot(float A) { return V + A; } };\n",
		{
			{"select", "R = select(x, 2, 3);", {23, 123, 223, 323}},
			{"method", "FMask M; M.V = 5; R = M.dot(x);", {5, 6, 7, 8}},
		});
}

TEST(HlslForms, FunctionTemplates)
{
	ExpectSnippets("template<typename T> T Square(T V) { return V * V; }\n"
		"template<typename T, int N = 3> T Sum(T V)\n{\n\tT Result = 0;\n\tfor (int i = 0; i < N; ++i) Result += V;\n\treturn Result;\n}\n"
		"template<typename T> T SumOfSquares(T A, T B) { return Square(A) + Square<T>(B); }\n"
		"template<typename T> T Pick(T A) { return A; }\ntemplate<typename T> T Pick(T A, T B) { return B; }\n"
		"template<> float Sum<float, 2>(float V) { return V * 200; }\n"
		"template<int Count> float Power(float V) { float Result = 1; for (int i = 0; i < Count; ++i) Result *= V; return Result; }\n"
		"template<typename T, int N> T First(vector<T, N> V) { return V[0] + N; }\nfloat Plain(float V) { return V; }\ntemplate<typename T> T Plain(T V) { return V * 10; }\n",
		{
			{"explicit", "R = Square<float>(x + 0.5);", {0.25f, 2.25f, 6.25f, 12.25f}},
			{"explicit int truncates", "R = Square<int>(x + 0.5);", {0, 1, 4, 9}},
			{"deduced vector", "R = Square(float2(x, 2)).y + Square(float2(x, 2)).x;", {4, 5, 8, 13}},
			{"deduced from a literal", "R = Square(3) / 2;", {4}},
			{"deduced from an expression", "R = Square(u * 2u + 1u);", {1, 9, 25, 49}},
			{"default argument", "R = Sum<float>(x);", {0, 3, 6, 9}},
			{"value argument", "R = Sum<float, 5>(x);", {0, 5, 10, 15}},
			{"specialization", "R = Sum<float, 2>(x);", {0, 200, 400, 600}},
			{"template calls templates", "R = SumOfSquares(x, 2.0);", {4, 5, 8, 13}},
			{"overloads", "R = Pick(x) * 10 + Pick(x, 3.0);", {3, 13, 23, 33}},
			{"value alone", "R = Power<3>(x);", {0, 1, 8, 27}},
			{"vector of any size", "R = First(float3(x, 0, 0)) * 10 + First(int2(n, 0));", {32, 43, 54, 65}},
			{"a function that fits better", "R = Plain(x) + Plain(n);", {0, 11, 22, 33}},
		});
}

TEST(HlslForms, StructTemplates)
{
	ExpectSnippets("template<typename T> struct TPair { T A; T B; T Sum() { return A + B; } };\n"
		"template<typename T, int N>\nstruct TRow\n{\n\tT Values[N];\n};\n"
		"TPair<float> MakePair(float V) { TPair<float> P; P.A = V; P.B = V * 2; return P; }\n"
		"template<typename T> T SumOf(TPair<T> P) { return P.A + P.B; }\nstruct FOuter { TPair<int2> Inner; };\ntemplate<typename T> struct TBox { T A; T B; };\n",
		{
			{"method", "TPair<float> P = MakePair(x); R = P.Sum();", {0, 3, 6, 9}},
			{"other argument", "TPair<int> P; P.A = n; P.B = 7; R = P.Sum() / 2;", {3, 4, 4, 5}},
			{"array by value argument", "TRow<float, 3> V; V.Values[0] = 1; V.Values[1] = x; V.Values[2] = 4; R = V.Values[1] + V.Values[2];", {4, 5, 6, 7}},
			{"in another template", "TBox<TPair<float> > P; P.A = MakePair(x); P.B = MakePair(1); R = P.A.B + P.B.B;", {2, 4, 6, 8}},
			{"closed at once", "TBox<TPair<int> > P; P.A.A = n; P.A.B = 1; TPair<int> I = P.A; R = I.Sum();", {1, 2, 3, 4}},
			{"deduced", "R = SumOf(MakePair(x));", {0, 3, 6, 9}},
			{"member", "FOuter O; O.Inner.A = int2(n, 1); O.Inner.B = int2(1, 1); TPair<int2> I = O.Inner; R = I.Sum().x;", {1, 2, 3, 4}},
		});
}

TEST(HlslForms, BoundsOfLoops)
{
	ExpectSnippets("static int Calls = 0;\nbool Count() { Calls += 1; return true; }\n",
		{
			{"for", "[unroll(3)] for (int i = 0; i < n + 2; ++i) R += 1;", {2, 3, 3, 3}},
			{"for without a condition", "[unroll(4)] for (int i = 0; ; ++i) { if (i > n) break; R += 1; }", {1, 2, 3, 4}},
			{"while", "int i = 0; [unroll(2)] while (i < n) { ++i; R += 1; } R += 10;", {10, 11, 12, 12}},
			{"do", "int i = 0; [unroll(2)] do { ++i; R += 1; } while (i < n);", {1, 1, 2, 2}},
			{"only statement of an if", "if (n > 1) [unroll(2)] for (int i = 0; i < 9 + n; ++i) R += 1; else R = 7;", {7, 7, 2, 2}},
			{"nested", "[unroll(2)] for (int i = 0; i < n + 1; ++i) [unroll(3)] for (int j = 0; j < n; ++j) R += 1;", {0, 2, 4, 6}},
			{"not reached", "[unroll(8)] for (int i = 0; i < 4; ++i) { R += i; }", {6}},
			{"reached", "[unroll(3)] for (int i = 0; i < 4; ++i) { R += i; }", {3}},
			{"counter changed inside", "[unroll(4)] for (int i = 0; i < 4; ++i) { R += 1; i -= n > 1; }", {4}},
			{"in capitals", "[Unroll(2)] for (int i = 0; i < 4 + n; ++i) { R += 1; }", {2}},
		});
}

TEST(HlslForms, ElementsOfMatrices)
{
	ExpectSnippets("struct FItem { float3x3 M; };\nfloat2x2 Make(float v) { return float2x2(v, 2, 3, v); }\n",
		{
			{"read", "float3x3 m = float3x3(1, 2, 3, 4, x, 6, 7, 8, 9); float2 v = m._m01_m11; R = v.x * 10 + v.y;", {20, 21, 22, 23}},
			{"read by ones", "float3x3 m = float3x3(1, 2, 3, 4, x, 6, 7, 8, 9); float3 v = m._12_22_33; R = v.x * 100 + v.y * 10 + v.z;", {209, 219, 229, 239}},
			{"of constants", "float2x2 m = float2x2(1, 2, 3, 4); R = dot(m._m00_m11, float2(1, 10));", {41}},
			{"of a member", "FItem I; I.M = float3x3(1, 2, 3, 4, 5, 6, 7, 8, 9) * (x + 1); R = I.M._m20_m02.x;", {7, 14, 21, 28}},
			{"of a call", "R = Make(x)._m00_m10.y + Make(x)._m11_m01.x;", {3, 4, 5, 6}},
			{"written", "float3x3 m = (float3x3)0; m._m01_m22 = float2(x, 5); R = m[0][1] * 10 + m[2][2];", {5, 15, 25, 35}},
			{"exchanged", "float2x2 m = float2x2(1, x, 3, 4); m._m01_m10 = m._m10_m01; R = m[0][1] * 10 + m[1][0];", {30, 31, 32, 33}},
			{"compound", "int2x2 m = int2x2(1, 2, 3, n); m._m00_m11 += int2(4, 1); m._11_22 *= 2; R = m[0][0] * 100 + m[1][1];", {1002, 1004, 1006, 1008}},
			{"spread", "float2x2 m = float2x2(1, 2, 3, 4); if (n > 1) m._m00_m11 = 7; R = m[0][0] * 10 + m[1][1];", {14, 14, 77, 77}},
		});
}

TEST(HlslForms, ConstantsOfEdges)
{
	ExpectSnippets("static const int2 Ten = int2(10, 20);\nstatic const float NotANumber = 0.0 / 0.0;\nstatic const float Bits = asfloat(0x7FC00000);\n",
		{
			{"dot of integers", "R = dot(int2(100, 4), int2(25, 3));", {2512}},
			{"dot of named integers", "R = dot(Ten, int2(1, 2)) + dot(uint3(1, 2, 3), uint3(4, 5, 6));", {82}},
			{"abs of uint", "R = abs(u + 0xFFFFFFF0u) == u + 0xFFFFFFF0u && abs(0xFFFFFFF0u) > 5u;", {1}},
			{"sign of uint", "R = sign(u * 0x80000000u) * 10 + sign(0xFFFFFFFFu) + sign(uint2(u, 9)).x * 100;", {1, 111, 101, 111}},
			{"atan2 of matrices", "float2x2 m = atan2(float2x2(0, 1, 0, 0), float2x2(1, 0, 1, 2)); R = m[0][1];", {1.57079632679f}},
			{"not a number equals nothing", "R = (NotANumber == 1.0) + (0.0 / 0.0 == 0.0 / 0.0) * 10 + (NotANumber >= 1.0) * 100 + (NotANumber != 1.0) * 1000;", {1000}},
			{"bits that are not a number", "R = (Bits == 1.0) + (asfloat(0x7FC00000) >= 2.0) * 10 + isnan(asfloat(0xFFC00000u)) * 100;", {100}},
			{"root of a negative number", "R = (sqrt(-1.0) == 1.0) + (log(-1.0) >= 1.0) * 10 + (log2(-2.0) <= 1.0) * 100;", {0}},
			{"infinity stays", "R = 1.0 / 0.0 > 1e30;", {1}},
		});
}

TEST(HlslForms, GlobalsThatAreWritten)
{
	ExpectSnippets("float Global; float2 Vector; int Unwritten;\nvoid Add(float V) { Global += V; }\nfloat Local() { float Global = 5; Global = 6; return Global; }\n",
		{
			{"in a function", "Global = 1; Add(x); R = Global;", {1, 2, 3, 4}},
			{"a component", "Vector.y = x; R = Vector.y * 10 + Vector.x;", {3, 13, 23, 33}},
			{"a local variable of that name", "R = Local() + Unwritten;", {15}},
		},
		[](FShaderHarness& H)
		{
			H.SetFloats("Global", {0});
			H.SetFloats("Vector", {3, 4});
			H.Constants["Unwritten"] = {9};
		});
}
// clang-format on

TEST(HlslForms, PartsOfTexels)
{
	EXPECT_EQ((FFloats{9, 2, 3, 4, 5, 6, 7, 8}), RunStore("Out[Id.xy].x = 9;"));
	EXPECT_EQ((FFloats{1, 2, 3, 4, 8, 7, 9, 8}), RunStore("Out[int2(1, 0)].grb = float3(7, 8, 9);"));
	EXPECT_EQ(
		(FFloats{1, 2, 3, 40, 5, 6, 7, 8}), RunStore("if (Id.x == 0) Out[Id.xy].a *= 10; else Out[Id.xy].r = 0;"));
	EXPECT_EQ((FFloats{5, 2, 3, 4, 5, 6, 7, 8}), RunStore("Out[Id.xy].r = Out[Id.xy + uint2(1, 0)].r;"));
	EXPECT_EQ((FFloats{1, 3, 3, 3, 5, 6, 7, 8}), RunStore("Out[Id.xy].y++; --Out[Id.xy].w;"));
	EXPECT_EQ((FFloats{1, 2, 6, 4, 5, 6, 7, 8}), RunStore("for (int i = 0; i < 3; ++i) Out[Id.xy][2] += 1;"));
	EXPECT_EQ((FFloats{1, 2, 3, 4, 5, 6, 7, 8}), RunStore("Out[uint2(7, 7)].x = 9;")); // beyond the edge: dropped
	EXPECT_EQ((FFloats{9, 2, 10, 4, 5, 6, 7, 8}), RunStore("float A = Out[Id.xy].x = 9; Out[Id.xy].z = A + 1;"));
}

TEST(HlslForms, GroupSizesInAnyLetters)
{
	FShaderHarness Harness(
		"RWTexture2D<float4> Out;\n[NumThreads(4, 2, 1)] void Main(uint3 Id : SV_DispatchThreadID) { "
		"Out[Id.xy] = 1; }\n",
		"Main", EShaderStage::Compute);
	const FShaderReflection Reflection = ReflectShader(Harness.Request);
	EXPECT_EQ(4, Reflection.GroupSize[0]);
	EXPECT_EQ(2, Reflection.GroupSize[1]);
}

TEST(HlslForms, MacrosInParenthesesAreAskedFor)
{
	FShaderHarness Harness("#define ON 1\nfloat4 Main() : SV_Target0 {\n#ifdef(ON)\n#ifndef (OFF)\nreturn 3;\n#endif\n"
						   "#endif\nreturn 0; }\n",
		"Main", EShaderStage::Pixel);
	Harness.Targets = {FTestTexture(1, 1)};
	Harness.RunModel(1, 1);
	EXPECT_EQ(3.0f, Harness.Targets[0].Texel(0, 0)[0]);
}

TEST(HlslForms, WhatIsWrongIsAMessageWithItsPlace)
{
	EXPECT_THAT(ErrorsOf("template<typename T> T F() { return 0; }", "float A = F();"),
		AllOf(HasSubstr("/Test/Shader.usf:3:12: error: "),
			HasSubstr("the template argument 'T' cannot be found from this call: write it between < and >")));
	EXPECT_THAT(ErrorsOf("", "float2 A = Nothing._m00_m11;"),
		HasSubstr("/Test/Shader.usf:3:13: error: X3004: undeclared identifier 'Nothing'"));
	EXPECT_THAT(ErrorsOf("struct S { float A; float B; }; float F(S V) { return V.A; }", "float A = F({1, 2});"),
		AllOf(HasSubstr("/Test/Shader.usf:3:14: error: "),
			HasSubstr("a list in braces stands only behind the '=' of a declaration")));
}

TEST(HlslForms, TemplatesInStructs)
{
	ExpectSnippets("struct S { float Factor; template<typename T> T F(T V) { return V * (T)Factor; } };\n",
		{{"method", "S A; A.Factor = 3; R = A.F(x) + A.F(int2(n, 2)).y;", {6, 9, 12, 15}}});
}

TEST(HlslForms, ErrorsInACopyOfATemplateAreOnTheTemplatesLine)
{
	const std::string Errors = ErrorsOf(
		"\n\ntemplate<typename T>\nT F(T V)\n{\n\treturn V + Nothing;\n}", "RWTexture2D<float4> T; float A = F(1.0);");
	EXPECT_THAT(Errors, AllOf(HasSubstr("/Test/Shader.usf:6"), HasSubstr("'Nothing'")));
}
