// Messages: what D3D's compilers refuse, with the line, the column and how to write it.
#include "AnalysisTesting.h"

#include <algorithm>

namespace Drydock::Hlsl
{

namespace
{

struct FRefusal
{
	EStage Stage;
	const char* Before;
	const char* Body;
	const char* Messages;
};

std::string MakeRefusalText(const FRefusal& Refusal)
{
	const bool bPixel = Refusal.Stage == EStage::Pixel;
	return std::string("//\nfloat View_PreExposure;\nRWStructuredBuffer<float4> Out; RWTexture2D<float4> RW; Texture2D "
					   "T; SamplerState S; float Weight; cbuffer CB { float4 Cb; };\n") +
		   Refusal.Before + "\n" +
		   (bPixel ? "float4 Main(float2 P : TEXCOORD) : SV_Target"
				   : "[numthreads(1, 1, 1)]\nvoid Main(uint2 P : SV_DispatchThreadID)") +
		   "\n{\n\t" + Refusal.Body + "\n" + (bPixel ? "\treturn 0;\n" : "") + "}\n";
}

const std::vector<FRefusal> Refusals = {
	{EStage::Compute, "", "float W = Weigth * 2;\n\tW = Weigth;",
		"8:12: X3004: undeclared identifier 'Weigth'; did you mean Weight? (also in line 9)"},
	{EStage::Compute, "", "Foo X;", "8:2: X3000: unknown type 'Foo'"},
	{EStage::Compute, "", "float3 V; V.q = 1;", "8:14: X3018: invalid subscript 'q': 'float3' has the components xyz"},
	{EStage::Compute, "void F(int A) {}", "F(1, 2);",
		"8:2: X3013: no matching function F(literal int, literal int): it takes 1 argument, not 2; there is void "
		"F(int) (line 4)"},
	{EStage::Compute, "void F(int A) {} void F(uint A) {}", "F(3);",
		"8:2: X3067: ambiguous call of F(literal int); cast the argument to one of: void F(int) (line 4); void F(uint) "
		"(line 4)"},
	{EStage::Compute, "", "float F; F(2);", "8:11: X3005: 'F' is a variable and no function"},
	{EStage::Compute, "", "float2 V = 1; V.xx = 2;",
		"8:18: X3025: '=' needs something that can be written to: a component stands in the swizzle twice"},
	{EStage::Compute, "", "Cb = 1;",
		"8:2: X3025: '=' needs something that can be written to: 'Cb' is a member of a cbuffer, which shaders can only "
		"read"},
	{EStage::Compute, "", "T[P] = 1;",
		"8:3: X3025: '=' needs something that can be written to: 'Texture2D<float4>' can only be read; declare it as "
		"RWTexture2D"},
	{EStage::Compute, "", "const float A = 1; A = 2;",
		"8:21: X3025: '=' needs something that can be written to: 'A' is const"},
	{EStage::Compute, "", "float4 A; int B = A == A;",
		"8:20: warning X4000: use of potentially uninitialized variable 'A': nothing sets it\n8:22: warning X3206: "
		"implicit truncation of 'bool4' to 'int'"},
	{EStage::Compute, "", "float A = 1; while (true) { A *= 2; }",
		"8:15: warning X3696: infinite loop: its condition is always true, and no break and no return leaves it"},
	{EStage::Compute, "", "float A = 1; for (uint i = 3; i >= 0; --i) { A *= 2; }",
		"8:15: warning X3696: infinite loop: a uint is never below 0, so its condition is always true, and no break "
		"and "
		"no return leaves it"},
	{EStage::Compute, "", "float A = 1; while (true) { if (A > 9) { return; } A *= 2; }", ""},
	{EStage::Compute, "", "float A = 1; for (;;) { if (A > 9) { break; } A *= 2; }", ""},
	{EStage::Compute, "", "float A = Weight * (1 / 2);",
		"8:24: warning a division of whole numbers loses its fraction before it becomes 'float'; write 1.0 for 1"},
	{EStage::Compute, "", "float A = Weight * (4 / 2) + 1.0 / 2; int B = 7 / 2;", ""},
	{EStage::Compute, "", "float3 A = float2(1,2);", "8:13: X3017: cannot convert from 'float2' to 'float3'"},
	{EStage::Compute, "", "float A = T.Sample(S, P).x;",
		"8:14: X4532: .Sample in a compute shader is an error: only pixel shaders have the derivatives that choose the "
		"mip; write SampleLevel(Sampler, UV, 0)"},
	{EStage::Compute, "", "float A = ddx(Weight);",
		"8:12: X4532: ddx in a compute shader is an error: only pixel shaders have neighbours to take a difference "
		"from; compute the step from the size of a texel"},
	{EStage::Pixel, "", "GroupMemoryBarrier();",
		"7:2: X4532: GroupMemoryBarrier in a pixel shader is an error: only compute shaders have groups of threads; "
		"write DeviceMemoryBarrier()"},
	{EStage::Compute, "", "float4 A = T.Load(int3(P, 0), int2(8, 1));",
		"8:32: X4577: offsets of Load go from -8 to 7, not 8; add it to the position instead"},
	{EStage::Compute, "", "float4 A = T.SampleLevel(S, P, 0, int2(-9, 1));",
		"8:36: X4577: offsets of SampleLevel go from -8 to 7, not -9; add it to the position instead"},
	{EStage::Compute, "", "[loop] [unroll(1)] for (int i = 0; i < 2; ++i) {}",
		"8:21: X3524: [loop] and [unroll] cannot stand before one loop; leave one out"},
	{EStage::Compute, "float4 X; float4 X;", "", "4:18: X3003: redefinition of 'X', which line 4 declares"},
	{EStage::Compute, "", "float A; float A;", "8:17: X3003: redefinition of 'A', which line 8 declares"},
	{EStage::Compute, "", "float4 A = 1, B = 2; float4 C = A > B ? A : B;",
		"8:36: X3019: the condition of '?:' takes a scalar, not 'bool4'; write select(C, A, B) to choose by "
		"components"},
	{EStage::Compute, "", "float4 A = 1; if (A && A) {}",
		"8:20: X3019: '&&' takes a scalar, not 'float4'; write and(A, B) for components, or all(...) or any(...) "
		"around each side"},
	{EStage::Compute, "", "float4 A = 1; if (A) {}",
		"8:20: X3019: if takes a scalar, not 'float4'; write any(...) or all(...)"},
	{EStage::Compute, "", "float2x2 M = 0; float3 A = (float3)M;",
		"8:37: X3017: cannot convert from 'float2x2' to 'float3'"},
	{EStage::Compute, "", "float4 V = 1; V.xzzx = 1;",
		"8:18: X3025: '=' needs something that can be written to: a component stands in the swizzle twice"},
	{EStage::Compute, "", "float4x4 M = 0; M._m01_m01 = 1;",
		"8:20: X3025: '=' needs something that can be written to: a component stands in the swizzle twice"},
	{EStage::Compute, "void F(inout float2 A) {}", "float2 x = 1; F(x.yy);",
		"8:20: X3025: argument 1 (inout) needs something that can be written to: a component stands in the swizzle "
		"twice"},
	{EStage::Compute, "", "switch (P.x) { case 1: break; case 2: }",
		"8:40: X3000: a label at the end of a switch needs a statement; write break"},
	{EStage::Compute, "", "switch (P.x) { case 1: Weight; case 2: break; }",
		"8:33: warning X3533: the case before this label goes on into it, which FXC refuses: non-empty case statements "
		"must have break or return"},
	{EStage::Compute, "", "for (int i = 0; i < 4; ++i) { switch (i) { case 1: continue; } Out[i] = 1; }",
		"8:53: warning X3708: continue stands in a switch, which FXC refuses; set a flag, and write continue behind "
		"the "
		"switch"},
	{EStage::Compute, "", "const int x = 1, y = 0; int z = x / y;", "8:36: X4010: division of an integer by zero"},
	{EStage::Compute, "float F(int A) { if (A > 1) return 2; }", "float A = F(P.x);",
		"4:7: X3507: 'F': not all control paths return a value (float); write a return at its end"},
	{EStage::Compute, "", "float A; Out[0] = A;",
		"8:20: warning X4000: use of potentially uninitialized variable 'A': nothing sets it"},
	{EStage::Compute, "struct S2 { float A = 5; };", "S2 s = (S2)0;",
		"4:23: 'A': members of a struct have no initial values in HLSL; set it where a variable of 'S2' is made"},
	{EStage::Compute, "", "break;",
		"8:2: X3518: break stands outside of a loop or switch; to end the function write return"},
	{EStage::Compute, "", "continue;", "8:2: X3519: continue stands outside of a loop"},
	{EStage::Compute, "", "float2 A = float2(1);",
		"8:13: X3014: incorrect number of arguments to numeric-type constructor: 'float2' takes 2 numbers, not 1; "
		"write (float2)X to repeat it"},
	{EStage::Compute, "", "float4 A[2] = {1,2,3,4};",
		"8:16: X3037: initializer does not match type 'float4[2]': it has 4 values, and the type takes 8"},
	{EStage::Compute, "", "float4 A[] = {1,2,3};",
		"8:15: X3037: initializer does not match type 'float4[]': it has 3 values, and each element takes 4"},
	{EStage::Compute, "void G(int A); void F(int A) { G(A); } void G(int A) { F(A); }", "F(1);",
		"4:56: X3500: functions of HLSL cannot call themselves, not even through others; write a loop: 'F' calls 'G', "
		"'G' calls 'F'"},
	{EStage::Compute, "", "RayQuery<0> Q; Q.Proceed();",
		"8:2: ray tracing ('RayQuery') does not run on the CPU tier; march through the depth texture, or read what the "
		"G-buffer has"},
	{EStage::Compute, "", "Texture2DMS<float4> Q;",
		"8:2: a multisampled texture ('Texture2DMS') does not run on the CPU tier; resolve it into a Texture2D first"},
	{EStage::Compute, "sampler2D S9;", "float4 A = tex2D(S9, P);",
		"4:1: 'sampler2D' is of Direct3D 9; declare a Texture2D and a SamplerState, and write Texture.Sample(Sampler, "
		"UV)"},
	{EStage::Compute, "", "Later();", "8:2: X3004: undeclared identifier 'Later': there is no such function"},
	{EStage::Compute, "", "float A = View.PreExposre;",
		"8:17: uniform buffer 'View' has no member 'PreExposre'; did you mean PreExposure?"},
	{EStage::Compute, "", "float A = Veiw.PreExposre;",
		"8:12: X3004: undeclared identifier 'Veiw', and no uniform buffer of that name is registered; did you mean "
		"View?"},
	{EStage::Compute, "", "int A[2]; A[2] = 1;", "8:14: X3504: array index out of bounds: 'int[2]' has 0 to 1, not 2"},
	{EStage::Compute, "", "float3 V = 0; V[3] = 1;",
		"8:18: X3504: array index out of bounds: 'float3' has 0 to 2, not 3"},
	{EStage::Compute, "", "int A[P.x];",
		"8:10: X3058: the size of an array must be a constant expression; mark what it depends on as static const"},
	{EStage::Compute, "template<int N> void F(int A) {}", "F<int>(1);",
		"8:2: X3013: no matching function F(literal int); there is template in line 4: template argument 1 does not "
		"fit"},
	{EStage::Compute, "template<typename U> void F(U A, U B) {}", "F(1, 2.0);",
		"8:2: X3013: no matching function F(literal int, literal float); there is template in line 4: 'U' would be "
		"<int> and <float>"},
	{EStage::Compute, "template<int N> void F() { F<N + 1>(); }", "F<0>();",
		"4:28: instances of 'F' call each other more than 64 times deep (in F<63>)"},
	{EStage::Compute, "template<int N> struct SS { SS<N + 1> A; };", "SS<1> A;",
		"4:29: types are nested in each other more than 128 times"},
	{EStage::Compute, "enum class E { A };", "E e = 1;",
		"8:8: X3017: cannot convert from 'literal int' to 'E'; if it is meant, write (E)"},
	{EStage::Compute, "enum class E { A };", "int e = E::A;",
		"8:10: X3017: cannot convert from 'E' to 'int'; if it is meant, write (int)"},
	{EStage::Compute, "enum class E { A };", "int e = E::B;", "8:10: X3018: 'E' has no 'B'"},
	{EStage::Compute, "", "uint64_t A = 1; switch (A) { case 1: break; }",
		"8:26: X3000: switch takes an int or a uint, not 'uint64_t'; cast it: switch (int(...))"},
	{EStage::Compute, "", "return 1;", "8:9: X3079: 'Main' is void and cannot return a value"},
	{EStage::Compute, "struct SS { void Fooo() {} };", "SS A; A.Foo();",
		"8:10: X3018: 'SS' has no method 'Foo'; did you mean Fooo?"},
	{EStage::Compute, "struct SS { int Fooo; };", "SS A; A.Foo = 1;",
		"8:10: X3018: 'SS' has no member 'Foo'; did you mean Fooo?"},
	{EStage::Compute, "", "T.Foo(1);", "8:4: X3018: Texture2D<float4> has no method 'Foo'"},
	{EStage::Compute, "", "Out.Length();", "8:6: X3018: RWStructuredBuffer<float4> has no method 'Length'"},
	{EStage::Compute, "", "float4 A = lerp(1, 2);",
		"8:13: X3013: 'lerp' takes 3 arguments, but 2 are given; write lerp(float, float, float)"},
	{EStage::Compute, "", "float A = 1 << 1.5;",
		"8:14: X3082: int or unsigned int type required for '<<', not 'literal float'"},
	{EStage::Compute, "", "float A = float4(1,2,3,4) + float1x4(1,2,3,4);",
		"8:28: warning X3206: implicit truncation of 'float4' to 'float'"},
	{EStage::Compute, "struct SB { float X; }; struct SA { SB SB; SB Other; };", "SA A; A.Other.X = 1;",
		"4:44: X3000: 'SB' is not a type here: line 4 declares something else of this name"},
	{EStage::Compute, "struct SA { SA B; };", "SA A; A.B = 1;", "4:8: X3000: the struct 'SA' is made of itself"},
	{EStage::Compute, "", "groupshared int A;",
		"8:18: X3010: a local variable cannot be declared with groupshared; leave it out"},
	{EStage::Compute, "groupshared int A = 1;", "A = 1;",
		"4:21: warning 'A': groupshared variables have no initial values, and this one is not used; set it in the "
		"shader, and wait by GroupMemoryBarrierWithGroupSync()"},
	{EStage::Compute, "", "discard;", "8:2: X4532: discard is only in pixel shaders; write return"},
	{EStage::Compute, "", "clip(1);",
		"8:2: X4532: clip in a compute shader is an error: only pixel shaders have pixels to discard; write return"},
	{EStage::Compute, "", "float A = Weight.xy.z;",
		"8:19: X3018: invalid subscript 'xy': 'float' has the components x"},
	{EStage::Compute, "", "InterlockedAdd(Weight, 1);",
		"8:2: X3013: argument 1 of 'InterlockedAdd' has the type float, but an integer is expected; write "
		"InterlockedAdd(inout uint, uint)"},
	{EStage::Compute, "", "min16float A = 1.0; A++; true++;",
		"8:31: X3020: '++': operator cannot be used with a bool lvalue"},
	{EStage::Compute, "", "float3 A = float3(float4(1,2,3,4));",
		"8:13: X3014: incorrect number of arguments to numeric-type constructor: 'float3' takes 3 numbers, not 4; "
		"write (float3)X to cut it"},
	{EStage::Compute, "", "static_assert(1 == 2, \"no\");", "8:2: static_assert failed: \"no\""},
	{EStage::Compute, "", "int A = 1; A.F();", "8:15: X3018: 'int' has no method 'F'"},
	{EStage::Compute, "", "Weight();", "8:2: X3005: 'Weight' is a variable and no function"},
	{EStage::Compute, "", "void X;", "8:7: X3038: 'X': variables cannot be void"},
	{EStage::Compute, "void F(); ", "F();",
		"8:2: X3004: 'F' is declared in line 4, but nothing defines it: it has no body"},
	{EStage::Compute, "namespace N { float C; }", "float A = 1; A = N::B;", "8:19: X3018: 'N' has no 'B'"},
	{EStage::Compute, "", "float A = this.x;", "8:12: X3004: 'this' is known only in methods that are not static"},
	{EStage::Compute, "", "int i = 5; i += float2(1,2);",
		"8:18: warning X3206: implicit truncation of 'float2' to 'float'"},
};

TEST(HlslAnalysisErrors, EachIsSaidWithItsPlace)
{
	for (const FRefusal& Refusal : Refusals)
	{
		EXPECT_EQ(AnalyseText(MakeRefusalText(Refusal), Refusal.Stage).Messages, Refusal.Messages) << Refusal.Body;
	}
}

TEST(HlslAnalysisErrors, TheEntryIsJudged)
{
	EXPECT_EQ(AnalyseText("[numthreads(1, 1, 1)] void Mian() {}").Messages,
		"0:0: entry point 'Main' does not exist in this shader; did you mean Mian?");
	EXPECT_EQ(AnalyseText("float MainX() { return 1; } [numthreads(1, 1, 1)] void Edge() {}").Messages,
		"0:0: entry point 'Main' does not exist in this shader; it has Edge");
	EXPECT_EQ(AnalyseText("void Main() {}").Messages,
		"1:6: the compute shader 'Main' has no [numthreads(X, Y, Z)] before it: its group's size");
	EXPECT_EQ(AnalyseText("[numthreads(0, 1, 1)] void Main() {}").Messages,
		"1:13: [numthreads] of 'Main' has a 0; wanted are three from 1 on");
	EXPECT_EQ(AnalyseText("[numthreads(-1, 1, 1)] void Main() {}").Messages,
		"1:13: [numthreads] of 'Main' has a negative number; wanted are three from 1 on");
	EXPECT_EQ(AnalyseText("[numthreads(1, 1)] void Main() {}").Messages,
		"1:2: [numthreads] of 'Main' has 2 numbers; wanted are three from 1 on");
	EXPECT_EQ(AnalyseText("[numthreads(64, 64, 1)] void Main() {}").Messages,
		"1:17: X3663: [numthreads] of 'Main' has too many threads: a group has at most 1024, and at most 64 in z");
	EXPECT_EQ(AnalyseText("float4 Main(float2 A) : SV_Target { return 0; }", EStage::Pixel).Messages,
		"1:20: X3502: 'A' of the entry is missing its semantic; write : TEXCOORD0, : SV_Position, : SV_Target0 or the "
		"like "
		"behind it");
}

TEST(HlslAnalysisErrors, NoMoreThanTwentyAreSaid)
{
	std::string Body;
	for (int i = 0; i < 40; ++i)
	{
		Body += "Missing" + std::to_string(i) + "x();\n";
	}
	const std::string Messages = AnalyseText(MakeComputeText("", Body)).Messages;
	EXPECT_EQ(std::count(Messages.begin(), Messages.end(), '\n'), 19);
}

TEST(HlslAnalysisErrors, WhatWouldNotEndIsRefused)
{
	std::string Structs = "struct S0 { float4 A[1024]; };";
	for (int i = 1; i < 20; ++i)
	{
		Structs += " struct S" + std::to_string(i) + " { S" + std::to_string(i - 1) + " A, B; };";
	}
	EXPECT_THAT(AnalyseText(MakeComputeText(Structs, "S19 A;")).Messages,
		::testing::HasSubstr("has more than 1048576 numbers"));
	std::string Chain = "static const int K0 = 1;";
	for (int i = 1; i < 5000; ++i)
	{
		Chain += " static const int K" + std::to_string(i) + " = K" + std::to_string(i - 1) + " + 1;";
	}
	EXPECT_THAT(
		AnalyseText(MakeComputeText(Chain, "int A = K4999;")).Messages, ::testing::HasSubstr("nested more than"));
	EXPECT_THAT(AnalyseText(MakeComputeText("template<int N> struct Q { Q<N + 1> A; };", "Q<0> A;")).Messages,
		::testing::HasSubstr("nested in each other"));
	EXPECT_THAT(
		AnalyseText(MakeComputeText("template<int N> void F() { F<N + 1>(); F<N + 2>(); }", "F<0>();")).Messages,
		::testing::HasSubstr("times deep"));
}

} // namespace

} // namespace Drydock::Hlsl
