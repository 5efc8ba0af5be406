// Small inputs that an older front end answered wrongly without a word: each runs to what D3D gives.
#include "RunText.h"

#include <gtest/gtest.h>

#include <bit>

namespace Drydock::Hlsl::Tests
{
namespace
{

struct FAnswer
{
	const char* Name;
	const char* Before;
	const char* Body; // Set(N, Value) gives the result N
	std::vector<float> Results;
};

// In[0] to In[3] are 1, 2, 3 and 4 as floats, In[4] is 0 as a number: what is known at run time alone.
const std::vector<FAnswer> Answers = {
	{"fmod of constants", "static const float K = fmod(-7.5, 2.0);",
		"Set(0, fmod(-7.5, 2.0)); Set(1, fmod(-1, 3)); Set(2, K); const float L = fmod(7.5, -2.0); Set(3, L);",
		{-1.5f, -1, -1.5f, 1.5f}},
	{"remainders of constants", "static const float K = 7.5 % 2.0;",
		"Set(0, 7.0 % 6.2831853); Set(1, -7.5 % 2.0); Set(2, 6.5 % 6.0); Set(3, K); Set(4, -7 % 2);",
		{0.7168147f, -1.5f, 0.5f, 1.5f, -1}},
	{"constant vectors compared", "static const float2 S = float2(4, 1);",
		"const float2 A = float2(1, 5), B = float2(2, 3); Set(0, any(A > B)); Set(1, all(A < B)); if (any(S > "
		"float2(5, "
		"0.5))) Set(2, 1); else Set(2, 2); Set(3, all(float3(1, 2, 3) > float3(-4.5, 0.5, 6))); float3 C = "
		"select(float3(1, 2, 3) > float3(2, 2, 2), float3(1, 1, 1), float3(5, 5, 5)); Set(4, C.x); Set(5, C.z); Set(6, "
		"(A > B).y);",
		{1, 0, 1, 0, 5, 1, 1}},
	{"flat initializers", "static const float2 O[] = {1, 2, 3, 4};",
		"float4 A[] = {10, 20, 30, 40, 50, 60, 70, 80}; Set(0, A[1].x); Set(1, A[1].w); Set(2, O[1].x); float2 B[2] = "
		"{float2(1, 2), 3, 4}; Set(3, B[1].y);",
		{50, 80, 3, 4}},
	{"inout of a texel", "RWBuffer<float> Texels; void F(inout float X) { X += 10; }",
		"Texels[0] = 1; F(Texels[0]); Set(0, Texels[0]);", {11}},
	{"lit", "",
		"float4 L = lit(1.2, 2, 3); Set(0, L.x); Set(1, L.y); Set(2, L.z); L = lit(X(0) + 0.2, X(1), X(2)); Set(3, "
		"L.z);",
		{1, 1.2f, 8, 8}},
	{"initializers in each other", "",
		"float4 A = {1, {{{2, {3}}, 4}}}; Set(0, A.x); Set(1, A.y); Set(2, A.z); Set(3, A.w);", {1, 2, 3, 4}},
	{"sides that are not run",
		"static int Calls = 0; bool G() { ++Calls; return true; } bool H(out int V) { V = 7; return true; }",
		"bool Z = In[4] != 0; int K = 1, V = 2; if (Z && G()) K = 9; bool B = Z && K++ == 0; int C = Z ? K++ : 5; if "
		"(!Z || "
		"H(V)) C += 1; Set(0, Calls); Set(1, K); Set(2, C); Set(3, V); Set(4, B);",
		{0, 1, 6, 2, 0}},
	{"the stride of a structured buffer", "struct FS { uint A; float3 B; }; RWStructuredBuffer<FS> Wide;",
		"uint N, Stride; Wide.GetDimensions(N, Stride); Set(0, Stride);", {16}},
	{"shadowed members",
		"struct A { float bb; }; struct B : A { float c; }; struct C : B { float bb; float Own() { return bb; } };",
		"C V; V.bb = 3; ((A)V).bb; V.c = 1; Set(0, V.bb); Set(1, V.Own());", {3, 3}},
	{"members named like their type",
		"struct IA { float X; }; struct IB { IA IA; float2 Y; }; struct IC { IB IB[2]; float IA; };",
		"IC V; V.IB[1].IA.X = 3; V.IB[1].Y = float2(4, 5); V.IA = 6; Set(0, V.IB[1].IA.X); Set(1, V.IB[1].Y.y); Set(2, "
		"V.IA);",
		{3, 5, 6}},
	{"overloads of float", "float F(half A) { return 1; } float F(double A) { return 2; }", "Set(0, F(X(0)));", {2}},
	{"overloads of int", "float F(uint A) { return 1; } float F(min16int A) { return 2; }",
		"int I = In[4]; Set(0, F(I));", {1}},
	{"overloads of vectors", "float F(float2 A) { return 1; } float F(double A) { return 2; }", "Set(0, F(X(0)));",
		{1}},
	{"orders of matrices", "typedef column_major float2x2 T; void F(T M) { }",
		"T M = {1, 2, 3, 4}; row_major float2x2 N = {1, 2, 3, 4}; Set(0, M[0][1]); Set(1, N[0][1]); Set(2, mul(M, "
		"N)[1][0]);",
		{2, 2, 15}},
	{"an index by a call", "static int K = 0; int Next() { return K++; } float2 Both() { return float2(Next(), 5); }",
		"Set(0, Both()[1]); Set(1, K);", {5, 1}},
	{"atan2 of a negative zero", "", "Set(0, atan2(-0.0, -1)); Set(1, atan2(-X(4), -X(0)));",
		{3.14159274f, 3.14159274f}},
	{"a matrix of one", "",
		"Set(0, determinant(float1x1(X(2)))); float1 F = 2; Set(1, mul(F, float1x4(1, 2, 3, 4)).w); Set(2, "
		"determinant(float1x1(5)));",
		{3, 8, 5}},
	{"any and all of matrices", "",
		"float2x2 M = {X(0), X(1), X(2), X(3)}; Set(0, all(M)); Set(1, any(M - M)); Set(2, any(float2x2(0, 0, 0, 1)));",
		{1, 0, 1}},
	{"frexp", "", "float E; float M = frexp(X(3), E); Set(0, M); Set(1, E);", {0.5f, 3}},
	{"the base as inout", "struct B { float A; }; struct D : B { float C; }; void F(inout B V) { V.A += 1; }",
		"D V; V.A = 1; V.C = 5; F(V); Set(0, V.A); Set(1, V.C);", {2, 5}},
	{"the least int64_t", "", "int64_t I = -9223372036854775808; Set(0, I < 0); Set(1, I == (1ll << 63));", {1, 1}},
	{"a literal as a double", "",
		"double D = 5.57; Set(0, float((D - 5.57L) * 1e10L)); float F = 5.57; Set(1, F == 5.57f);", {0, 1}},
	{"shifts of literals", "", "uint U = In[4] + 31; Set(0, (1 << U) > 0); int I = 31 + In[4]; Set(1, (1 << I) > 0);",
		{1, 0}},
	{"unsigned where one is", "",
		"int I = -1; uint16_t W = 1; Set(0, (I + W - 1) > 0 ? 1 : 0); uint U = 1; int64_t L = -2; Set(1, U + L > 0);",
		{1, 1}},
	{"a parameter of an empty struct", "struct FNone { static const int K = 4; }; int F(FNone N) { return N.K; }",
		"FNone N; Set(0, F(N) + FNone::K);", {8}},
};

TEST(HlslShaderAnswers, EachIsRight)
{
	for (const FAnswer& Answer : Answers)
	{
		SCOPED_TRACE(Answer.Name);
		const std::string Text = "StructuredBuffer<uint> In;\nRWStructuredBuffer<uint> Out;\nvoid Set(uint At, float "
								 "Value) { Out[At] = asuint(Value); "
								 "}\nfloat X(int At) { return asfloat(In[At]); }\n" +
								 std::string(Answer.Before) + "\n[numthreads(1, 1, 1)] void MainCS() { " + Answer.Body +
								 " }\n";
		std::vector<uint32_t> In = {0x3F800000, 0x40000000, 0x40400000, 0x40800000, 0, 0, 0, 0};
		std::vector<uint32_t> Typed(16, 0);
		try
		{
			const std::vector<uint32_t> Out = RunModule(CompileText(Text), Text, In, 8, &Typed);
			for (size_t i = 0; i < Answer.Results.size(); ++i)
			{
				EXPECT_EQ(std::bit_cast<float>(Out[i]), Answer.Results[i]) << "result " << i;
			}
		}
		catch (const FError& Error)
		{
			ADD_FAILURE() << Error.what();
		}
	}
}

} // namespace
} // namespace Drydock::Hlsl::Tests
