// What D3D's compilers refuse or warn of, a small input each; the messages have their numbers, lines and columns.
#include "AnalysisTesting.h"
#include "HlslFrontEnd.h"

namespace Drydock::Hlsl
{

namespace
{

struct FRule
{
	EStage Stage;
	const char* Before; // in line 8
	const char* Body;   // in line 12
	const char* Messages;
};

const std::vector<FRule> Rules = {
	{EStage::Compute, "", "double D = 2; D = D % 1.5L;",
		"12:22: X3684: modulo cannot be used with doubles, cast to float first"},
	{EStage::Compute, "", "min16int A = 4; A = A / 2;",
		"12:24: X3706: signed integer division is not supported on minimum-precision types; cast to int"},
	{EStage::Compute, "", "bool B = true; B += 1;", "12:19: X3020: '+=': operator cannot be used with a bool lvalue"},
	{EStage::Compute, "", "bool B = true; B++;", "12:18: X3020: '++': operator cannot be used with a bool lvalue"},
	{EStage::Compute, "", "uint2 Q = P; Out[0] = RW[Q.x];",
		"12:29: X3120: invalid type for index: 'uint'; 'RWTexture2D<float4>' takes uint2"},
	{EStage::Compute, "", "float4 A = T[0];",
		"12:15: X3120: invalid type for index: 'literal int'; 'Texture2D<float4>' takes uint2"},
	{EStage::Compute, "Texture2D<double4> Wide;", "float A = Wide[P].x;",
		"8:1: X3037: elements of typed buffers and textures must fit in four 32-bit quantities, which 'double4' does "
		"not; use a StructuredBuffer"},
	{EStage::Compute, "RWTexture2D Bare;", "Bare[P] = 1;",
		"8:1: X3000: 'RWTexture2D' needs the type of its elements: RWTexture2D<float4>"},
	{EStage::Compute, "row_major float3 V;", "Out[0] = V.x;",
		"8:11: X3077: non-matrix types cannot be declared 'row_major' or 'column_major'"},
	{EStage::Compute, "row_major column_major float3x3 M;", "Out[0] = M[0][0];",
		"8:33: X3048: matrix types cannot be both column_major and row_major"},
	{EStage::Compute, "unorm int2 V;", "Out[0] = V.x;",
		"8:7: X3085: unorm and snorm are of floats, not of 'unorm int2'"},
	{EStage::Compute, "Texture2D U0 : register(u1);", "Out[0] = U0[P];",
		"8:16: X3530: a texture or a buffer that is read requires a 't' register, not 'u1'"},
	{EStage::Compute, "RWTexture2D<float4> T1 : register(t1);", "T1[P] = 1;",
		"8:26: X3530: a UAV requires a 'u' register, not 't1'"},
	{EStage::Compute, "cbuffer CB : register(t0) { float Cb; };", "Out[0] = Cb;",
		"8:14: X3591: a constant buffer requires a 'b' register, not 't0'"},
	{EStage::Compute, "SamplerState S1 : register(ps_5_0, u0);", "Out[0] = T.SampleLevel(S1, P, 0);",
		"8:19: X3530: a sampler requires an 's' register, not 'u0'"},
	{EStage::Compute, "", "float A : TEXCOORD0 = 1;", "12:12: X3043: 'A': local variables cannot have semantics"},
	{EStage::Compute, "", "uniform float A = 1;",
		"12:16: X3047: a local variable cannot be declared with uniform; leave it out"},
	{EStage::Compute, "", "groupshared float A;",
		"12:20: X3010: a local variable cannot be declared with groupshared; leave it out"},
	{EStage::Compute, "", "linear float A = 1;",
		"12:15: X3047: a local variable cannot be declared with words of interpolation; leave it out"},
	{EStage::Compute, "volatile float A;", "Out[0] = 1;",
		"8:16: X3008: a global variable cannot be declared with volatile; leave it out"},
	{EStage::Compute, "static uniform float A;", "Out[0] = 1;",
		"8:22: X3007: static and uniform cannot stand together: a static variable is not a parameter"},
	{EStage::Compute, "typedef groupshared float FA;", "Out[0] = 1;",
		"8:27: X3010: a typedef cannot be declared with groupshared; leave it out"},
	{EStage::Compute, "out float F() { return 1; }", "Out[0] = F();",
		"8:11: X3047: a function cannot be declared with in, out and inout; leave it out"},
	{EStage::Compute, "struct FS { const float A; };", "Out[0] = 1;",
		"8:25: X3035: a member of a struct cannot be declared with const; leave it out"},
	{EStage::Compute, "struct FS { float A; void operator+=(float B) {} };", "Out[0] = 1;",
		"8:27: X3000: overloading 'operator+=' is not allowed; write a method with a name"},
	{EStage::Compute, "void F(int A = 1, int B) {}", "F(1, 2);",
		"8:23: X3000: the parameter 'B' needs a default value: one before it has one"},
	{EStage::Compute, "void F(int A = 1); void F(int A = 2) {}", "F();",
		"8:31: X3003: 'A' has its default value already, in line 8"},
	{EStage::Compute, "template<typename U> struct FW { U A; };", "FW<FW<float>> V;",
		"12:14: X3000: a space is required between consecutive right angle brackets (use '> >')"},
	{EStage::Compute, "int M;", "[unroll] for (int i = 0; i < M; ++i) Out[i] = 1;",
		"12:29: X3511: forced to unroll loop, but unrolling failed: how often it turns is known only when the shader "
		"runs; write [loop], or [unroll(N)] with the most turns"},
	{EStage::Compute, "int M;", "int N = M * 2; [unroll] for (int i = 0; i < N; ++i) Out[i] = 1;",
		"12:44: X3511: forced to unroll loop, but unrolling failed: how often it turns is known only when the shader "
		"runs; write [loop], or [unroll(N)] with the most turns"},
	{EStage::Compute, "int M;",
		"[unroll(4)] for (int i = 0; i < M; ++i) Out[i] = 1; [unroll] for (int j = 0; j < 4; ++j) { if (j > M) break; "
		"Out[j] = 2; }",
		""},
	{EStage::Compute, "Texture2D<uint4> Ints;", "Out[0] = Ints.SampleLevel(S, P, 0);",
		"12:16: X4582: cannot sample from non-floating point texture formats: 'Texture2D<uint4>'; write "
		"Load(int3(Position, 0))"},
	{EStage::Compute, "", "Out[0] = ResourceDescriptorHeap[0];",
		"12:11: 'ResourceDescriptorHeap' does not run on the CPU tier: a pass binds its resources by name; declare one "
		"as a parameter of the shader"},
	{EStage::Compute, "", "float X; if (P.x) X = 1; Out[0] = X;",
		"12:36: warning X4000: use of potentially uninitialized variable 'X': not every path to here sets it"},
	{EStage::Compute, "", "float X; for (int i = 0; i < 3; ++i) X = i; Out[0] = X;", ""},
	{EStage::Compute, "", "float X; switch (P.x) { case 0: X = 1; break; default: X = 2; } Out[0] = X;", ""},
	{EStage::Compute, "", "float X; switch (P.x) { case 0: X = 1; break; case 1: break; default: X = 2; } Out[0] = X;",
		"12:90: warning X4000: use of potentially uninitialized variable 'X': not every path to here sets it"},
	{EStage::Compute, "void F(out float A, inout float B) { A = B; }", "float X, Y; F(X, Y); Out[0] = X;",
		"12:19: warning X4000: use of potentially uninitialized variable 'Y': not every path to here sets it"},
	{EStage::Compute, "", "uint W, H; RW.GetDimensions(W, H); float A, B; sincos(1, A, B); Out[W] = A + B + H;", ""},
	{EStage::Compute, "", "float X; if (P.x) { X = 1; } else { return; } Out[0] = X;", ""},
	{EStage::Compute, "", "float X; bool B = P.x && (X = 1); Out[0] = X;",
		"12:45: warning X4000: use of potentially uninitialized variable 'X': not every path to here sets it"},
	{EStage::Compute, "", "float4 X; X.xy = 1; X[2] = 2; Out[0] = X.y + X.z;", ""},
	{EStage::Compute, "", "float4 X; X.xy = 1; X[2] = 2; Out[0] = dot(X, X);",
		"12:45: warning X4000: use of potentially uninitialized variable 'X': not every path to here sets X.w"},
	{EStage::Compute, "struct FParts { float A; float2 B; };",
		"FParts X; X.A = 1; X.B.x = 2; FParts Y = X; Out[0] = Y.A;", ""},
	{EStage::Compute, "struct FParts { float A; float2 B; };", "FParts X; X.A = 1; Out[0] = X.B.x;",
		"12:32: warning X4000: use of potentially uninitialized variable 'X': not every path to here sets X.B"},
	{EStage::Compute, "void F(uint I, out float A)\n{ if (I) { A = 1; return; }\n}", "float X; F(P.x, X); Out[0] = X;",
		"8:26: warning X3508: output parameter 'A' not completely initialized: not every way to the function's end "
		"sets "
		"A"},
	{EStage::Compute, "void F(uint I, out float3 A) { A.xy = 1; A.z = I; }", "float3 X; F(P.x, X); Out[0] = X.x;", ""},
	{EStage::Compute, "struct FBits { uint A : 4; float B : 8; int C : 33; };", "FBits X;",
		"8:34: the bit field 'B' is of int or uint and has 1 to 32 bits\n8:45: the bit field 'C' is of int or uint and "
		"has "
		"1 to 32 bits"},
	{EStage::Compute, "struct FBits { uint A : 4; uint B : 8; };", "FBits X; X.A = 1; X.B = 2; Out[0] = X.A + X.B;",
		""},
	{EStage::Compute, "int4 Count;", "Count.x = 3; Out[0] = Count;",
		"12:8: warning X3025: global variables are implicitly constant: 'Count' is a parameter of the shader, which "
		"DXC refuses to write; copy it into a local variable"},
	{EStage::Compute, "groupshared int A = 1;", "A = 1; Out[0] = A;",
		"8:21: warning 'A': groupshared variables have no initial values, and this one is not used; set it in the "
		"shader, and wait by GroupMemoryBarrierWithGroupSync()"},
	{EStage::Compute, "", "float3x4 M = 0; float3 V = 1; Out[0].xyz = mul(M, V);",
		"12:45: X3020: type mismatch: 'mul' of float3x4 and float3: the vector on the right has to have as many "
		"components as the matrix has columns; cast the matrix"},
	{EStage::Compute, "", "float2 A = float4(1, 2, 3, 4); int2 B = P.x; A = B.xyx;",
		"12:13: warning X3206: implicit truncation of 'float4' to 'float2'\n12:53: warning X3206: implicit truncation "
		"of 'int3' to 'float2'"},
	{EStage::Compute, "float4 F(half A) { return 1; } float4 F(double A) { return 2; }", "Out[0] = F(P.x * 0.5);", ""},
	{EStage::Compute, "", "Out[0] = 1 / 0;", "12:13: X4010: division of an integer by zero"},
	{EStage::Compute, "", "const uint Z = 0; Out[0] = P.x / Z;", "12:33: X4010: division of an integer by zero"},
	{EStage::Compute, "", "int A = 5 % 0;", "12:12: X4010: division of an integer by zero"},
	{EStage::Pixel, "", "AllMemoryBarrierWithGroupSync(); return 0;",
		"12:2: X4532: AllMemoryBarrierWithGroupSync in a pixel shader is an error: only compute shaders have groups of "
		"threads; write DeviceMemoryBarrier()"},
	{EStage::Pixel, "", "if (A.x > 0) return 1;",
		"10:8: X3507: 'Main': not all control paths return a value (float4); write a return at its end"},
};

TEST(HlslAnalysisRules, EachIsSaidWithItsPlace)
{
	for (const FRule& Rule : Rules)
	{
		std::string Text = MakeComputeText(Rule.Before, Rule.Body);
		if (Rule.Stage == EStage::Pixel)
		{
			const size_t Head = Text.find("[numthreads");
			const size_t Open = Text.find("{\n\t" + std::string(Rule.Body));
			Text.replace(Head, Open - Head, "\nfloat4 Main(float2 A : TEXCOORD0) : SV_Target\n");
		}
		EXPECT_EQ(AnalyseText(Text, Rule.Stage).Messages, Rule.Messages) << Rule.Before << "\n" << Rule.Body;
	}
}

TEST(HlslAnalysisRules, WarningsAreData)
{
	FShaderCompileRequest Request;
	Request.VirtualPath = "/Test/Rules.usf";
	Request.EntryPoint = "Main";
	const std::vector<FDiagnostic> Warnings =
		Read(MakeComputeText("", "float2 A = float4(1, 2, 3, 4); float X; Out[0] = X;"), Request).Warnings;
	ASSERT_EQ(Warnings.size(), 2u);
	EXPECT_EQ(Warnings[0].Severity, ESeverity::Warning);
	EXPECT_EQ(Warnings[0].File, "/Test/Rules.usf");
	EXPECT_EQ(Warnings[0].Line, 12);
	EXPECT_THROW(Read("syntax error", Request), FError);
	const FAnalysisOptions Options;
	EXPECT_FALSE(Options.bFxcRules);
}

/** FXC's rules: ?:, && and || by components. */
TEST(HlslAnalysisRules, VectorsInLogicWhereAskedFor)
{
	const std::string Text = MakeComputeText(
		"", "float2 A = P, B = 2; float2 C = A > B ? A : B; bool2 D = A > B && B > 1; Out[0] = any(D) + C.x;");
	std::vector<FDiagnostic> Errors;
	const FTree Tree = Parse(Text, "/Test.usf", Errors);
	FAnalysisOptions Options;
	Options.EntryPoint = "Main";
	EXPECT_EQ(Analyse(Tree, Options).Errors.size(), 2u);
	Options.bFxcRules = true;
	EXPECT_TRUE(Analyse(Tree, Options).Errors.empty());
}

TEST(HlslAnalysisRules, FxcRefusesContinueInASwitch)
{
	FShaderCompileRequest Request;
	Request.EntryPoint = "Main";
	const std::string Loop = "for (int i = 0; i < 4; ++i) { switch (i) { case 1: ";
	const std::string Inner =
		MakeComputeText("", Loop + "for (;;) { break; } for (int j = 0; j < 2; ++j) continue; break; } }");
	const std::string Text = MakeComputeText("", Loop + "continue; } Out[i] = 1; }");
	EXPECT_NO_THROW(Read(Text, Request));
	Request.Defines = {{FxcRulesDefine, "1"}};
	EXPECT_NO_THROW(Read(Inner, Request));
	EXPECT_THROW(Read(Text, Request), FError);
}

TEST(HlslAnalysisRules, ARequestAsksForFxcsRules)
{
	FShaderCompileRequest Request;
	Request.EntryPoint = "Main";
	const std::string Text = MakeComputeText("", "int K = 0; bool B = P.x > 9 && K++ == 0; Out[0] = K + B;");
	const auto HasChoice = [&Request](const std::string& Of)
	{
		const FAnalysis Analysis = Read(Of, Request);
		return FProgramPrinter(*Analysis.Program).Print().find("&&") != std::string::npos;
	};
	EXPECT_TRUE(HasChoice(Text));
	Request.Defines = {{FxcRulesDefine, "1"}};
	EXPECT_FALSE(HasChoice(Text));
	EXPECT_NO_THROW(Read(MakeComputeText("", "float2 A = P; float2 C = A > 1 ? A : 2; Out[0] = C.x;"), Request));
}

/** FXC's textures have their sizes as a member. */
TEST(HlslAnalysisRules, TexturesHaveALengthByFxcsRules)
{
	FShaderCompileRequest Request;
	Request.EntryPoint = "Main";
	const std::string Text = MakeComputeText("Texture2D<float4> Flat; RWTexture3D<float> Solid; TextureCube Cube;",
		"int2 S = min(int2(5, 5), Flat.Length.xy - 1); Out[0] = S.x + Solid.Length.z + Cube.Length.y;");
	EXPECT_THROW(Read(Text, Request), FError);
	Request.Defines = {{FxcRulesDefine, "1"}};
	EXPECT_NO_THROW(Compile(Text, Request));
	EXPECT_THROW(Read(MakeComputeText("Texture2D Flat;", "Flat.Length = 1; Out[0] = 1;"), Request), FError);
	EXPECT_THROW(Read(MakeComputeText("Texture2D Flat;", "Out[0] = Flat.Width;"), Request), FError);
}

TEST(HlslAnalysisRules, FxcTakesMoreNamesAndRegisters)
{
	FShaderCompileRequest Request;
	Request.EntryPoint = "Main";
	const std::string Texts[] = {MakeComputeText("", "for (int i = 0; i < 4; ++i) { } Out[0] = i;"),
		MakeComputeText(
			"", "int i; for (int i = 0; i < 4; ++i) { } for (int i = 0; i < 2; ++i) { } int k = i; Out[0] = k;"),
		MakeComputeText("", "for (int i = 0; i < 4; ++i) { } float i = 2; Out[0] = i;"),
		MakeComputeText("struct FNames { float3 float; uint half : TEXCOORD; };",
			"FNames N = (FNames)0; float2 bool = 1, int = bool; N.float = float3(bool, int.x); Out[0] = N.float.x + "
			"int.y;"),
		MakeComputeText("cbuffer Old : register(c0) { float Value; };", "Out[0] = Value;")};
	for (const std::string& Text : Texts)
	{
		Request.Defines = {{FxcRulesDefine, "1"}};
		EXPECT_NO_THROW(Compile(Text, Request)) << Text;
		Request.Defines.clear();
		if (&Text == &Texts[1] || &Text == &Texts[2])
		{
			EXPECT_NO_THROW(Read(Text, Request)) << Text;
		}
		else
		{
			EXPECT_THROW(Read(Text, Request), FError) << Text;
		}
	}
	Request.Defines = {{FxcRulesDefine, "1"}};
	for (const char* const Statement : {"{ for (int i = 0; i < 4; ++i) { } } Out[0] = i;",
			 "float2 float2 = 1; Out[0] = 1;", "int i = 0; int i = 1; Out[0] = i;", "Out[0] = float;"})
	{
		EXPECT_THROW(Read(MakeComputeText("", Statement), Request), FError) << Statement;
	}
	EXPECT_THROW(
		Read(MakeComputeText("Texture2D Flat : register(c0);", "Out[0] = Flat[uint2(0, 0)].x;"), Request), FError);
}

TEST(HlslAnalysisRules, EachStageHasItsOwnValues)
{
	const std::string Head = "[numthreads(1, 1, 1)] void Main(";
	EXPECT_EQ(AnalyseText(Head + "uint P : SV_DispatchThreadID, float2 UV : TEXCOORD0) { }", EStage::Compute).Messages,
		"1:70: X4502: a compute shader has no input 'TEXCOORD0'; it has SV_DispatchThreadID, SV_GroupID, "
		"SV_GroupThreadID and SV_GroupIndex");
	EXPECT_EQ(AnalyseText(Head + "uint P : SV_GroupIndx) { }", EStage::Compute).Messages,
		"1:38: X4502: 'SV_GROUPINDX' is not a system value; did you mean SV_GroupIndex?");
	EXPECT_EQ(AnalyseText(Head + "out float4 C : SV_Target0) { C = 0; }", EStage::Compute).Messages,
		"1:44: a compute shader has no outputs, and 'SV_TARGET0' is one: write into a UAV");
	EXPECT_EQ(AnalyseText("float4 Main() : SV_Target8 { return 0; }", EStage::Pixel).Messages,
		"1:8: X4571: 'SV_TARGET8': a pixel shader has the targets SV_Target0 to SV_Target7");
	EXPECT_EQ(AnalyseText("float4 Main(float4 P : SV_Posision) : SV_Target { return P; }", EStage::Pixel).Messages,
		"1:20: X4502: 'SV_POSISION' is not a system value; did you mean SV_Position?");
}

TEST(HlslAnalysisRules, SemanticsStandOnce)
{
	EXPECT_EQ(
		AnalyseText("float4 Main(float2 A : TEXCOORD0, float2 B : TEXCOORD) : SV_Target { return 0; }", EStage::Pixel)
			.Messages,
		"1:42: X3000: the semantic 'TEXCOORD0' stands twice among the inputs of the entry; give each an index of its "
		"own");
	EXPECT_EQ(
		AnalyseText(
			"void Main(float4 P : SV_Position, out float4 A : SV_Target0, out float4 B : SV_Target1) { A = B = P; }",
			EStage::Pixel)
			.Messages,
		"");
}

} // namespace

} // namespace Drydock::Hlsl
