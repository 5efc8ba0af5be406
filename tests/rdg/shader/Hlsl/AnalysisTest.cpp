// Expressions and statements: conversions, places, initialisers, loops, each as the program that they become.
#include "AnalysisTesting.h"

namespace Drydock::Hlsl
{

namespace
{

TEST(HlslAnalysis, LiteralsTakeTheTypeThatIsAskedFor)
{
	ExpectMain("",
		"float A = 1; double B = 0.1; uint C = 3; half D = 2; float E = P.x > 1 ? 1 : 2; double F = P.x > 1 ? 0.1 : "
		"0.2; int64_t G = 5000000000;",
		"{\n"
		"\tfloat A = 1.0\n"
		"\tdouble B = 0.1\n"
		"\tuint C = 3u\n"
		"\thalf D = 2.0\n"
		"\tfloat E = ((P.x > 1u) ? 1.0 : 2.0)\n"
		"\tdouble F = ((P.x > 1u) ? 0.1 : 0.2)\n"
		"\tint64_t G = 5000000000\n"
		"}\n");
}

TEST(HlslAnalysis, ConversionsAreWrittenOut)
{
	ExpectMain("",
		"float3 A = 1; float2 B = A.xy; int C = A.x; bool D = C; float4 E = float4(A, C); float F = (float)C; uint2 G "
		"= (uint2)B;",
		"{\n"
		"\tfloat3 A = float3(1.0, 1.0, 1.0)\n"
		"\tfloat2 B = A.xy\n"
		"\tint C = int(A.x)\n"
		"\tbool D = bool(C)\n"
		"\tfloat4 E = float4{A, float(C)}\n"
		"\tfloat F = float(C)\n"
		"\tuint2 G = uint2(B)\n"
		"}\n");
}

TEST(HlslAnalysis, ComparisonsGiveBoolsByComponents)
{
	ExpectMain("", "float2 A = 1; bool2 B = A > 2; bool C = any(A == B); bool D = !C; bool2 E = !B;",
		"{\n"
		"\tfloat2 A = float2(1.0, 1.0)\n"
		"\tbool2 B = (A > float2(2.0, 2.0))\n"
		"\tbool C = any((A == float2(B)))\n"
		"\tbool D = !C\n"
		"\tbool2 E = !B\n"
		"}\n");
}

TEST(HlslAnalysis, ConstantsAreFolded)
{
	ExpectMain("static const float K = 2; static const int N = 3 * 4;",
		"float A[N]; float B = K * 3 + fmod(-7.5, 2.0) + 7.5 % 2.0; const int C = N + 1; int D[C]; D[1] = C; A[0] = B; "
		"uint E = 1 << 4;",
		"static float K = 2.0\n"
		"static int N = 12\n"
		"{\n"
		"\tfloat[12] A\n"
		"\tfloat B = 6.0\n"
		"\tint C = 13\n"
		"\tint[13] D\n"
		"\t(D[1] = C)\n"
		"\t(A[0] = B)\n"
		"\tuint E = 16u\n"
		"}\n");
}

TEST(HlslAnalysis, SidesOfAndStayApart)
{
	ExpectMain("bool G(inout int K) { return ++K > 2; }",
		"int K = 0; bool A = Weight > 1 && G(K); bool B = A || K; int C = A ? K++ : K--;",
		"cbuffer $Global { float Weight @0; }\n"
		"bool G(inout int K)\n"
		"{\n"
		"\treturn (++K > 2)\n"
		"}\n"
		"{\n"
		"\tint K = 0\n"
		"\tbool A = ((Weight > 1.0) && G(K))\n"
		"\tbool B = (A || bool(K))\n"
		"\tint C = (A ? K++ : K--)\n"
		"}\n");
}

TEST(HlslAnalysis, SwizzlesAreValuesAndTargets)
{
	ExpectMain("",
		"float4 A = 1; A.zx = A.yy; float B = Weight.xxx.y; A.rgb *= 2; float3 C = 2.0.xxx; A.x++; float4x4 M = 0; "
		"M._m00_m11 = M._12_21; M[1][2] = 3; M[0] = A; M._m33 += 1;",
		"cbuffer $Global { float Weight @0; }\n"
		"{\n"
		"\tfloat4 A = float4(1.0, 1.0, 1.0, 1.0)\n"
		"\t(A.zx = A.yy)\n"
		"\tfloat B = Weight.xxx.y\n"
		"\t(A.xyz *= float3(2.0, 2.0, 2.0))\n"
		"\tfloat3 C = float3(2.0, 2.0, 2.0)\n"
		"\tA.x++\n"
		"\tfloat4x4 M = float4x4(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)\n"
		"\t(M._m00_m11 = M._m01_m10)\n"
		"\t(M[1][2] = 3.0)\n"
		"\t(M[0] = A)\n"
		"\t(M._m33 += 1.0)\n"
		"}\n");
}

TEST(HlslAnalysis, InitializersAreFlat)
{
	ExpectMain("struct F { float2 A; int B; };",
		"float4 A = {1, {{{2, {3}}, 4}}}; float2 B[] = {1, 2, A}; F C = {A.xyz}; F D[2] = {C, 1, 2, 3}; float2x2 E = "
		"{A.xy, 1, 2}; F G = {1, 2.5, 3}; int H = {7};",
		"{\n"
		"\tfloat4 A = float4(1.0, 2.0, 3.0, 4.0)\n"
		"\tfloat2[3] B = float2[3]{1.0, 2.0, A}\n"
		"\tfloat3 temporary\n"
		"\tF C = ((temporary = A.xyz), F{temporary[0u], temporary[1u], int(temporary[2u])})\n"
		"\tF[2] D = F[2]{C, 1.0, 2.0, 3}\n"
		"\tfloat2x2 E = float2x2{A.xy, 1.0, 2.0}\n"
		"\tF G = F{1.0, 2.5, 3}\n"
		"\tint H = 7\n"
		"}\n");
}

TEST(HlslAnalysis, AValueThatIsTakenApartIsRunOnce)
{
	ExpectMain("struct F { float A; int B; }; float2 Two() { return 1; }", "F C = {Two()};",
		"float2 Two()\n"
		"{\n"
		"\treturn float2(1.0, 1.0)\n"
		"}\n"
		"{\n"
		"\tfloat2 temporary\n"
		"\tF C = ((temporary = Two()), F{temporary[0u], int(temporary[1u])})\n"
		"}\n");
}

TEST(HlslAnalysis, ConstructorsAndCasts)
{
	ExpectMain("struct F { float2 A; int B; };",
		"float4 A = float4(1, float2(2, 3), Weight); float2x2 M = float2x2(1, 2, 3, 4); F Z = (F)0; float3x3 N = "
		"(float3x3)1; float2 C = (float2)A; float4 D = (float4)M; float X[2] = (float[2])C;",
		"cbuffer $Global { float Weight @0; }\n"
		"{\n"
		"\tfloat4 A = float4{1.0, float2(2.0, 3.0), Weight}\n"
		"\tfloat2x2 M = float2x2(1.0, 2.0, 3.0, 4.0)\n"
		"\tF Z = F{0}\n"
		"\tfloat3x3 N = float3x3(1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0)\n"
		"\tfloat2 C = float2(A)\n"
		"\tfloat4 D = float4{M}\n"
		"\tfloat[2] X = (float[2])C\n"
		"}\n");
}

TEST(HlslAnalysis, AssignmentsConvertToTheLeft)
{
	ExpectMain("",
		"int A = 1; A += 1.5; A <<= P.x; float3 B = 1; B *= Weight; float C = 1; C = A = 3; bool D = true; D &= false; "
		"(A = 2) += 3; ++A; A--;",
		"cbuffer $Global { float Weight @0; }\n"
		"{\n"
		"\tint A = 1\n"
		"\t(A += 1.5)\n"
		"\t(A <<= int(P.x))\n"
		"\tfloat3 B = float3(1.0, 1.0, 1.0)\n"
		"\t(B *= float3(Weight))\n"
		"\tfloat C = 1.0\n"
		"\t(C = float((A = 3)))\n"
		"\tbool D = true\n"
		"\t(D &= 0)\n"
		"\t((A = 2) += 3)\n"
		"\t++A\n"
		"\tA--\n"
		"}\n");
}

TEST(HlslAnalysis, TexelsAndElementsArePlaces)
{
	ExpectMain("",
		"RW[P].rgb = 1; RW[P] += 2; Out[P.x].y = T[P].x; float4 A = T.mips[2][P]; float4 B = T.Load(int3(P, 0)); "
		"float4 C = T.SampleLevel(S, P, 0, int2(-8, 7)); uint W, H; RW.GetDimensions(W, H); float FW, FH; "
		"T.GetDimensions(FW, FH);",
		"{\n"
		"\t(RW{P}.xyz = float3(1.0, 1.0, 1.0))\n"
		"\t(RW{P} += float4(2.0, 2.0, 2.0, 2.0))\n"
		"\t(Out{P.x}.y = T{P}.x)\n"
		"\tfloat4 A = T.Load(int3{int2(P), 2})\n"
		"\tfloat4 B = T.Load(int3{int2(P), 0})\n"
		"\tfloat4 C = T.SampleLevel(S, float2(P), 0.0, int2(-8, 7))\n"
		"\tuint W\n"
		"\tuint H\n"
		"\tRW.GetDimensions(W, H)\n"
		"\tfloat FW\n"
		"\tfloat FH\n"
		"\tT.GetDimensions(FW, FH)\n"
		"}\n");
}

TEST(HlslAnalysis, ArgumentsThatAreWrittenArePlaces)
{
	ExpectMain("void F(inout float4 A, out int B) { A += 1; B = 2; }",
		"float C; F(RW[P], C); float V, W; sincos(Weight, V, W); int X, Y; half Q; Q = modf(Weight, X);",
		"cbuffer $Global { float Weight @0; }\n"
		"void F(inout float4 A, out int B)\n"
		"{\n"
		"\t(A += float4(1.0, 1.0, 1.0, 1.0))\n"
		"\t(B = 2)\n"
		"}\n"
		"{\n"
		"\tfloat C\n"
		"\tF(RW{P}, C)\n"
		"\tfloat V\n"
		"\tfloat W\n"
		"\tsincos(Weight, V, W)\n"
		"\tint X\n"
		"\tint Y\n"
		"\thalf Q\n"
		"\t(Q = half(modf(Weight, X)))\n"
		"}\n");
}

TEST(HlslAnalysis, Loops)
{
	ExpectMain("",
		"for (int i = 0, j = 4; i < j; ++i, --j) { if (i == 2) continue; break; } [unroll(3)] while (P.x > 1) { } do { "
		"Weight; } while (Weight > 1); [loop] for (;;) { break; }",
		"cbuffer $Global { float Weight @0; }\n"
		"{\n"
		"\tloop (i < j) next (++i, --j)\n"
		"\t{\n"
		"\t\tint i = 0\n"
		"\t\tint j = 4\n"
		"\t}\n"
		"\t{\n"
		"\t\tif (i == 2)\n"
		"\t\t{\n"
		"\t\t\tcontinue\n"
		"\t\t}\n"
		"\t\tbreak\n"
		"\t}\n"
		"\tloop (P.x > 1u) unroll 3\n"
		"\t{\n"
		"\t}\n"
		"\tdo (Weight > 1.0)\n"
		"\t{\n"
		"\t\tWeight\n"
		"\t}\n"
		"\tloop  loop\n"
		"\t{\n"
		"\t\tbreak\n"
		"\t}\n"
		"}\n");
}

TEST(HlslAnalysis, Switches)
{
	ExpectMain("",
		"int A = 0; switch (P.x) { case 0: case 1: A = 1; break; case 2: { A = 2; break; } default: if (A) break; A = "
		"3; } switch (A) { case -1: A = 5; case 4: A = 6; break; case 7: return; }",
		"{\n"
		"\tint A = 0\n"
		"\tswitch P.x\n"
		"\tcase 0 1:\n"
		"\t\t(A = 1)\n"
		"\tcase 2:\n"
		"\t\t{\n"
		"\t\t\t(A = 2)\n"
		"\t\t\tbreak\n"
		"\t\t}\n"
		"\tcase default:\n"
		"\t\tif bool(A)\n"
		"\t\t{\n"
		"\t\t\tbreak\n"
		"\t\t}\n"
		"\t\t(A = 3)\n"
		"\tswitch A\n"
		"\tcase -1:\n"
		"\t\t(A = 5)\n"
		"\t\t(A = 6)\n"
		"\tcase 4:\n"
		"\t\t(A = 6)\n"
		"\tcase 7:\n"
		"\t\treturn\n"
		"}\n");
}

TEST(HlslAnalysis, Conditions)
{
	ExpectMain("",
		"if (P.x) Out[0] = 1; else if (Weight > 1) Out[1] = 2; else { return; } if (int K = P.y) Out[2] = K;",
		"cbuffer $Global { float Weight @0; }\n"
		"{\n"
		"\tif bool(P.x)\n"
		"\t{\n"
		"\t\t(Out{0u} = float4(1.0, 1.0, 1.0, 1.0))\n"
		"\t}\n"
		"\telse\n"
		"\t{\n"
		"\t\tif (Weight > 1.0)\n"
		"\t\t{\n"
		"\t\t\t(Out{1u} = float4(2.0, 2.0, 2.0, 2.0))\n"
		"\t\t}\n"
		"\t\telse\n"
		"\t\t{\n"
		"\t\t\treturn\n"
		"\t\t}\n"
		"\t}\n"
		"\tint K = int(P.y)\n"
		"\tif bool(K)\n"
		"\t{\n"
		"\t\t(Out{2u} = float4(float(K)))\n"
		"\t}\n"
		"}\n");
}

TEST(HlslAnalysis, BlocksMayHideNames)
{
	ExpectMain("", "float A = 1; { float A = 2; Out[0] = A; } for (int A = 0; A < 2; ++A) { }",
		"{\n"
		"\tfloat A = 1.0\n"
		"\t{\n"
		"\t\tfloat A = 2.0\n"
		"\t\t(Out{0u} = float4(A))\n"
		"\t}\n"
		"\tloop (A < 2) next ++A\n"
		"\t{\n"
		"\t\tint A = 0\n"
		"\t}\n"
		"\t{\n"
		"\t}\n"
		"}\n");
}

TEST(HlslAnalysis, Precise)
{
	ExpectMain("", "precise float A = Weight * 2 + 1; float B = A; sizeof(float3);",
		"cbuffer $Global { float Weight @0; }\n"
		"{\n"
		"\tfloat A = ((Weight * 2.0) + 1.0)\n"
		"\tfloat B = A\n"
		"\t12u\n"
		"}\n");
}

TEST(HlslAnalysis, BothShiftsAndBits)
{
	ExpectMain("",
		"int A = 1; uint B = 5; int C = A << B; uint D = B >> 1; int E = ~A & 3 | 4 ^ A; uint F = true + true; bool G "
		"= true & false;",
		"{\n"
		"\tint A = 1\n"
		"\tuint B = 5u\n"
		"\tint C = (A << int(B))\n"
		"\tuint D = (B >> 1u)\n"
		"\tint E = ((~A & 3) | (4 ^ A))\n"
		"\tuint F = 2u\n"
		"\tbool G = false\n"
		"}\n");
}

TEST(HlslAnalysis, VectorsOfOneComponent)
{
	ExpectMain("", "float1 A = 1; float B = A; float2 C = A; bool D = A ? true : false; float E = A[0];",
		"{\n"
		"\tfloat1 A = float1(1.0)\n"
		"\tfloat B = float(A)\n"
		"\tfloat2 C = float2(float(A))\n"
		"\tbool D = (bool(float(A)) ? true : false)\n"
		"\tfloat E = A[0]\n"
		"}\n");
}

TEST(HlslAnalysis, SelectOfStructs)
{
	ExpectMain("struct F { float2 A; };",
		"F A = {1, 2}, B = {3, 4}; F C = select(Weight > 1, A, B); float2 D = select(A.A > 1, A.A, 2);",
		"cbuffer $Global { float Weight @0; }\n"
		"{\n"
		"\tF A = F{1.0, 2.0}\n"
		"\tF B = F{3.0, 4.0}\n"
		"\tF C = ((Weight > 1.0) ? A : B)\n"
		"\tfloat2 D = select((A.A > float2(1.0, 1.0)), A.A, float2(2.0, 2.0))\n"
		"}\n");
}

} // namespace

} // namespace Drydock::Hlsl
