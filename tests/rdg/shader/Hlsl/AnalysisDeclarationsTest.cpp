// Declarations: functions, structs, templates, variables of the file, each as the program that they become.
#include "AnalysisTesting.h"

namespace Drydock::Hlsl
{

namespace
{

TEST(HlslAnalysis, OverloadsByTheirTypes)
{
	ExpectMain("float F(float A) { return 1; } float F(int A) { return 2; } float F(float2 A) { return 3; }",
		"float A = F(1) + F(1.0) + F(P.x) + F(float2(1, 2));",
		"float F(int A)\n"
		"{\n"
		"\treturn 2.0\n"
		"}\n"
		"float F(float A)\n"
		"{\n"
		"\treturn 1.0\n"
		"}\n"
		"float F(float2 A)\n"
		"{\n"
		"\treturn 3.0\n"
		"}\n"
		"{\n"
		"\tfloat A = (((F(1) + F(1.0)) + F(int(P.x))) + F(float2(1.0, 2.0)))\n"
		"}\n");
}

TEST(HlslAnalysis, DefaultArguments)
{
	ExpectMain("float F(float A, float B = 2, float C = 1 + 2) { return A + B + C; }", "float A = F(1) + F(1, 5);",
		"float F(float A, float B, float C)\n"
		"{\n"
		"\treturn ((A + B) + C)\n"
		"}\n"
		"{\n"
		"\tfloat A = (F(1.0, 2.0, 3.0) + F(1.0, 5.0, 3.0))\n"
		"}\n");
}

TEST(HlslAnalysis, Prototypes)
{
	ExpectMain("float F(float A, float B = 4); float G() { return F(1); } float F(float A, float B) { return B; }",
		"float A = G();",
		"float F(float A, float B)\n"
		"{\n"
		"\treturn B\n"
		"}\n"
		"float G()\n"
		"{\n"
		"\treturn F(1.0, 4.0)\n"
		"}\n"
		"{\n"
		"\tfloat A = G()\n"
		"}\n");
}

TEST(HlslAnalysis, MethodsBasesShadowedMembers)
{
	ExpectMain("struct B { float X; float Get() { return X; } void Set(float V) { X = V; } }; struct C : B { float X; "
			   "static const float K = 3; static float Twice(float V) { return V * 2; } float Both() { return X + B::X "
			   "+ Get() + this.X; } };",
		"C c = (C)0; c.Set(2); c.X = c.Both() + C::K + C::Twice(4); B b = c; ((B)c).X = 1;",
		"static float C::K = 3.0\n"
		"void B::Set(inout C this, float V)\n"
		"{\n"
		"\t(this.X#0 = V)\n"
		"}\n"
		"float B::Get(inout C this)\n"
		"{\n"
		"\treturn this.X#0\n"
		"}\n"
		"float C::Both(inout C this)\n"
		"{\n"
		"\treturn (((this.X#1 + this.X#0) + B::Get(this)) + this.X#1)\n"
		"}\n"
		"float C::Twice(float V)\n"
		"{\n"
		"\treturn (V * 2.0)\n"
		"}\n"
		"{\n"
		"\tC c = C{0}\n"
		"\tB::Set(c, 2.0)\n"
		"\t(c.X#1 = ((C::Both(c) + C::K) + C::Twice(4.0)))\n"
		"\tB b = (B)c\n"
		"\t(c.X#0 = 1.0)\n"
		"}\n");
}

TEST(HlslAnalysis, OperatorsOfStructs)
{
	ExpectMain("struct V { float X; V operator+(V O) { V R; R.X = X + O.X; return R; } float operator[](int I) { "
			   "return X * I; } float operator()(float A) { return A; } bool operator==(V O) { return X == O.X; } };",
		"V A = {1}; V B = A + A; float C = B[2] + A(3); bool D = A == B;",
		"V V::operator+(inout V this, V O)\n"
		"{\n"
		"\tV R\n"
		"\t(R.X = (this.X + O.X))\n"
		"\treturn R\n"
		"}\n"
		"float V::operator[](inout V this, int I)\n"
		"{\n"
		"\treturn (this.X * float(I))\n"
		"}\n"
		"float V::operator()(inout V this, float A)\n"
		"{\n"
		"\treturn A\n"
		"}\n"
		"bool V::operator==(inout V this, V O)\n"
		"{\n"
		"\treturn (this.X == O.X)\n"
		"}\n"
		"{\n"
		"\tV A = V{1.0}\n"
		"\tV B = V::operator+(A, A)\n"
		"\tfloat C = (V::operator[](B, 2) + V::operator()(A, 3.0))\n"
		"\tbool D = V::operator==(A, B)\n"
		"}\n");
}

TEST(HlslAnalysis, Enumerations)
{
	ExpectMain("enum A { A0, A1 = 5, A2 }; enum class B : uint { X = 3, Y };",
		"int I = A2; B E = B::Y; uint U = (uint)E; bool C = E == B::X; float F = A1 + 1; switch (E) { case B::X: I = "
		"1; break; default: break; }",
		"{\n"
		"\tint I = 6\n"
		"\tB E = 4u\n"
		"\tuint U = uint(E)\n"
		"\tbool C = (uint(E) == 3u)\n"
		"\tfloat F = 6.0\n"
		"\tswitch uint(E)\n"
		"\tcase 3:\n"
		"\t\t(I = 1)\n"
		"\tcase default:\n"
		"}\n");
}

TEST(HlslAnalysis, NamespacesUsing)
{
	ExpectMain("namespace N { float F(float A) { return A; } namespace M { static const float K = 2; struct R { int I; "
			   "}; } } using namespace N; using N::M::K; typedef N::M::R TR; using TF = float[2];",
		"float A = F(K) + N::M::K; TR R = {1}; TF Q = {1, 2};",
		"static float N::M::K = 2.0\n"
		"float N::F(float A)\n"
		"{\n"
		"\treturn A\n"
		"}\n"
		"{\n"
		"\tfloat A = (N::F(N::M::K) + N::M::K)\n"
		"\tN::M::R R = N::M::R{1}\n"
		"\tfloat[2] Q = float[2]{1.0, 2.0}\n"
		"}\n");
}

TEST(HlslAnalysis, TemplatesOfFunctions)
{
	ExpectMain("template<typename U> U Max2(U A, U B) { return A > B ? A : B; } template<typename U, int N> U Sum(U "
			   "A[N]) { U R = 0; for (int i = 0; i < N; ++i) R += A[i]; return R; } template<> float Max2<float>(float "
			   "A, float B) { return 7; } template<typename U, int N = 2> U Mul(vector<U, 3> A) { return A.x * N; }",
		"int A = Max2(1, 2); float B = Max2(1.0, 2.0); float C[3] = {1, 2, 3}; float D = Sum(C); float E = "
		"Mul(float3(1, 2, 3)) + Mul<float, 5>(float3(1, 2, 3)) + Max2<float>(1, 2);",
		"int Max2<int>(int A, int B)\n"
		"{\n"
		"\treturn ((A > B) ? A : B)\n"
		"}\n"
		"float Max2<float>(float A, float B)\n"
		"{\n"
		"\treturn 7.0\n"
		"}\n"
		"float Sum<float, 3>(float[3] A)\n"
		"{\n"
		"\tfloat R = 0.0\n"
		"\tloop (i < 3) next ++i\n"
		"\t{\n"
		"\t\tint i = 0\n"
		"\t}\n"
		"\t{\n"
		"\t\t(R += A[i])\n"
		"\t}\n"
		"\treturn R\n"
		"}\n"
		"float Mul<float, 2>(float3 A)\n"
		"{\n"
		"\treturn (A.x * 2.0)\n"
		"}\n"
		"float Mul<float, 5>(float3 A)\n"
		"{\n"
		"\treturn (A.x * 5.0)\n"
		"}\n"
		"{\n"
		"\tint A = Max2<int>(1, 2)\n"
		"\tfloat B = Max2<float>(1.0, 2.0)\n"
		"\tfloat[3] C = float[3]{1.0, 2.0, 3.0}\n"
		"\tfloat D = Sum<float, 3>(C)\n"
		"\tfloat E = ((Mul<float, 2>(float3(1.0, 2.0, 3.0)) + Mul<float, 5>(float3(1.0, 2.0, 3.0))) + Max2<float>(1.0, "
		"2.0))\n"
		"}\n");
}

TEST(HlslAnalysis, TemplatesOfStructs)
{
	ExpectMain("template<typename U, int N = 2> struct P2 { U A[N]; U First() { return A[0]; } static const int Count "
			   "= N; }; template<> struct P2<int, 1> { int Only; }; template<typename U> struct P2<U, 3> { U X; }; "
			   "template<typename U> using Q2 = P2<U, 4>;",
		"P2<float> A; A.A[1] = 1; P2<int, 1> B; B.Only = 2; P2<float, 3> C; C.X = A.First(); Q2<int> D; D.A[3] = "
		"P2<int>::Count;",
		"static int P2<int, 2>::Count = 2\n"
		"float P2<float, 2>::First(inout P2<float, 2> this)\n"
		"{\n"
		"\treturn this.A[0]\n"
		"}\n"
		"{\n"
		"\tP2<float, 2> A\n"
		"\t(A.A[1] = 1.0)\n"
		"\tP2<int, 1> B\n"
		"\t(B.Only = 2)\n"
		"\tP2<float, 3> C\n"
		"\t(C.X = P2<float, 2>::First(A))\n"
		"\tP2<int, 4> D\n"
		"\t(D.A[3] = P2<int, 2>::Count)\n"
		"}\n");
}

TEST(HlslAnalysis, ATemplateThatSaysMoreIsTaken)
{
	ExpectMain("template<typename U> float F(U A) { return 1; } template<typename U, int N> float F(vector<U, N> A) { "
			   "return 2; } float F(int A) { return 3; }",
		"float A = F(1.0) + F(float2(1, 2)) + F(1);",
		"float F<float>(float A)\n"
		"{\n"
		"\treturn 1.0\n"
		"}\n"
		"float F<float, 2>(float2 A)\n"
		"{\n"
		"\treturn 2.0\n"
		"}\n"
		"float F(int A)\n"
		"{\n"
		"\treturn 3.0\n"
		"}\n"
		"{\n"
		"\tfloat A = ((F<float>(1.0) + F<float, 2>(float2(1.0, 2.0))) + F(1))\n"
		"}\n");
}

TEST(HlslAnalysis, StaticVariablesAreRunBeforeTheEntry)
{
	ExpectMain("float G() { return Weight; } static float A = G() + 1; static const float2 O[] = {1, 2, 3, 4}; static "
			   "float B;",
		"B = A + O[P.x].y + O[1].x; static int C = 3; static float D = P.x; C++;",
		"cbuffer $Global { float Weight @0; }\n"
		"static float A = (G() + 1.0)\n"
		"static float2[2] O = float2[2](1.0, 2.0, 3.0, 4.0)\n"
		"static float B\n"
		"static int C = 3\n"
		"static bool D_initialised = false\n"
		"static float D\n"
		"float G()\n"
		"{\n"
		"\treturn Weight\n"
		"}\n"
		"{\n"
		"\t(B = ((A + O[P.x].y) + 3.0))\n"
		"\tif !D_initialised\n"
		"\t{\n"
		"\t\t(D = float(P.x))\n"
		"\t\t(D_initialised = true)\n"
		"\t}\n"
		"\tC++\n"
		"}\n");
}

TEST(HlslAnalysis, AParameterThatIsWrittenIsCopied)
{
	ExpectMain("float4 Par; const float4 Kon; struct FP { float X; float Get() { return X; } }; FP Str;",
		"Par.x = 2; float4 A = Par + Kon; A.y = Str.Get();",
		"cbuffer $Global { float4 Par @0; float4 Kon @16; FP Str @32; }\n"
		"static float4 Par = Par\n"
		"static FP Str = Str\n"
		"float FP::Get(inout FP this)\n"
		"{\n"
		"\treturn this.X\n"
		"}\n"
		"{\n"
		"\t(Par.x = 2.0)\n"
		"\tfloat4 A = (Par + Kon)\n"
		"\t(A.y = FP::Get(Str))\n"
		"}\n");
}

TEST(HlslAnalysis, Buffers)
{
	ExpectMain("cbuffer CB { float3 A; float B; float2 C[2]; float D : packoffset(c7.y); }; tbuffer TB { int E; }; "
			   "struct FC { float2 X; float Y; }; ConstantBuffer<FC> Con; float Fun(FC F) { return F.Y; }",
		"float Q = A.x + B + C[1].y + D + E + Con.X.y; FC W = Con; Q = Fun(Con);",
		"cbuffer CB { float3 A @0; float B @12; float2[2] C @16; float D @116; }\n"
		"tbuffer TB { int E @0; }\n"
		"resource ConstantBuffer<FC> Con\n"
		"float Fun(FC F)\n"
		"{\n"
		"\treturn F.Y\n"
		"}\n"
		"{\n"
		"\tfloat Q = (((((A.x + B) + C[1].y) + D) + float(E)) + Con.X.y)\n"
		"\tFC W = FC{Con.X, Con.Y}\n"
		"\t(Q = Fun(FC{Con.X, Con.Y}))\n"
		"}\n");
}

TEST(HlslAnalysis, UniformBuffers)
{
	ExpectMain("", "float A = View.PreExposure;",
		"cbuffer $Global { float View_PreExposure @0; }\n"
		"{\n"
		"\tfloat A = View_PreExposure\n"
		"}\n");
}

TEST(HlslAnalysis, ResourcesAsValues)
{
	ExpectMain("struct FS { Texture2D<float4> Tex; SamplerState Sam; float2 UV; float4 Read() { return "
			   "Tex.SampleLevel(Sam, UV, 0); } }; float4 Sample2(Texture2D<float4> A, float2 UV) { return "
			   "A.SampleLevel(S, UV, 0); } Texture2D Many[4];",
		"FS A; A.Tex = T; A.Sam = S; A.UV = 0; float4 R = A.Read() + Sample2(T, 1) + Many[2][P]; Texture2D<float4> L = "
		"T; R += L[P];",
		"resource Texture2D<float4>[4] Many\n"
		"float4 FS::Read(inout FS this)\n"
		"{\n"
		"\treturn this.Tex.SampleLevel(this.Sam, this.UV, 0.0)\n"
		"}\n"
		"float4 Sample2(Texture2D<float4> A, float2 UV)\n"
		"{\n"
		"\treturn A.SampleLevel(S, UV, 0.0)\n"
		"}\n"
		"{\n"
		"\tFS A\n"
		"\t(A.Tex = T)\n"
		"\t(A.Sam = S)\n"
		"\t(A.UV = float2(0.0, 0.0))\n"
		"\tfloat4 R = ((FS::Read(A) + Sample2(T, float2(1.0, 1.0))) + Many[2]{P})\n"
		"\tTexture2D<float4> L = T\n"
		"\t(R += L{P})\n"
		"}\n");
}

TEST(HlslAnalysis, WhatNothingCallsIsNotJudged)
{
	ExpectMain("float Wrong(Foo A) { return Bar + 1; } float4 AlsoWrong = Nothing;", "Out[0] = 1;",
		"{\n"
		"\t(Out{0u} = float4(1.0, 1.0, 1.0, 1.0))\n"
		"}\n");
}

} // namespace

} // namespace Drydock::Hlsl
