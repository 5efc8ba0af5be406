// What the emitter writes is SPIR-V that Khronos' validator and the tier's reader accept, and gives HLSL's numbers when
// the interpreter runs it, optimised or not.
#include "HlslFrontEnd.h"
#include "HlslModule.h"
#include "KernelLimits.h"
#include "SpirvInterpreter.h"
#include "SpirvModule.h"
#include "SpirvStructure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <spirv-tools/libspirv.hpp>

#include <algorithm>
#include <cstring>
#include <map>

namespace
{

using namespace Drydock;
using testing::HasSubstr;

std::vector<uint32_t> CompileEmitted(
	const std::string& Text, bool bKeep = false, EShaderStage Stage = EShaderStage::Compute)
{
	FShaderCompileRequest Request;
	Request.VirtualPath = "/Test/Emitter.usf";
	Request.EntryPoint = "Main";
	Request.Stage = Stage;
	Request.bKeepFunctions = bKeep;
	return Hlsl::Compile(Text, Request);
}

std::string ValidateEmitted(const std::vector<uint32_t>& Words)
{
	std::string Messages;
	spvtools::SpirvTools Tools(Words[1] >= 0x10300 ? SPV_ENV_UNIVERSAL_1_3 : SPV_ENV_UNIVERSAL_1_0);
	Tools.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t&, const char* Message)
		{ Messages += Message + std::string("\n"); });
	return Tools.Validate(Words) ? std::string() : Messages + "invalid";
}

/** Text with all that is around it: Out[Id.x] are floats, n and x are the thread's number. */
std::string MakeEmitted(const std::string& Globals, const std::string& Body)
{
	return Globals +
		   "\nRWStructuredBuffer<float> Out;\n[numthreads(4, 1, 1)]\nvoid Main(uint3 Id : SV_DispatchThreadID)\n{\n"
		   "uint n = Id.x; float x = float(n); float R = 0;\n" +
		   Body + "\nOut[Id.x] = R;\n}\n";
}

std::vector<float> RunEmitted(const std::vector<uint32_t>& Words, const std::string& Text)
{
	const FSpirvModule Module = ReadSpirv(Words);
	const FSpirvReflection Reflection = ReflectSpirv(Module, BuildSpirvStructure(Module), Text);
	std::map<std::string, std::vector<uint32_t>> Memory; // views of a buffer have its name
	std::vector<FKernelBuffer> Buffers;
	for (const FShaderResource& Resource : Reflection.Reflection.RWBuffers)
	{
		std::vector<uint32_t>& Bytes = Memory[Resource.Name];
		Bytes.resize(64, 0);
		Buffers.push_back({reinterpret_cast<uint8_t*>(Bytes.data()), uint32_t(Bytes.size() * 4), Resource.Stride,
			ETexelStorage::R32_FLOAT});
	}
	std::vector<uint8_t> Zeros(4096, 0);
	const uint8_t* const Constants[] = {Zeros.data(), Zeros.data(), Zeros.data()};
	FKernelCounters Counters = {};
	FKernelArgs Args = {Constants, nullptr, nullptr, nullptr, nullptr, Buffers.data(), nullptr, nullptr, 0, &Counters,
		GetKernelLimits()};
	FSpirvInterpreter Interpreter(Module, Reflection);
	for (int32_t i = 0; i < 4 && !Reflection.Reflection.bGroups; ++i)
	{
		Interpreter.Run(Args, i, 0, 0);
	}
	if (Reflection.Reflection.bGroups)
	{
		Interpreter.RunGroup(Args, 0, 0, 0);
	}
	std::vector<float> Result(4);
	std::memcpy(Result.data(), Memory["Out"].data(), sizeof(float) * 4);
	return Result;
}

struct FEmittedCase
{
	const char* Globals;
	const char* Body;
	std::vector<float> Expected;
};

void ExpectEmitted(const std::vector<FEmittedCase>& Cases)
{
	for (const FEmittedCase& Case : Cases)
	{
		SCOPED_TRACE(Case.Body);
		const std::string Text = MakeEmitted(Case.Globals, Case.Body);
		try
		{
			EXPECT_EQ("", ValidateEmitted(CompileEmitted(Text, true)));
			ReadWholeSpirv(CompileEmitted(Text, true));
			const std::vector<uint32_t> Words = CompileEmitted(Text);
			EXPECT_EQ("", ValidateEmitted(Words));
			EXPECT_EQ(Case.Expected, RunEmitted(Words, Text));
		}
		catch (const std::exception& Error)
		{
			ADD_FAILURE() << Error.what();
		}
	}
}

std::string ErrorOfEmitted(const std::string& Globals, const std::string& Body)
{
	try
	{
		CompileEmitted(MakeEmitted(Globals, Body));
	}
	catch (const FError& Error)
	{
		return Error.what();
	}
	return {};
}

} // namespace

/** An argument of another type is converted on its way in and out, never taken over bit by bit. */
TEST(HlslEmitter, ArgumentsOfOtherTypesAreConverted)
{
	ExpectEmitted({
		{"void F(inout int V) { V += 1; }", "float f = 2.75; F(f); R = f + x;", {3, 4, 5, 6}},
		{"void F(out uint4 V) { V = asuint(float4(1, 2, 3, 4)); }", "float4 f; F(f); R = f.x;",
			{1065353216, 1065353216, 1065353216, 1065353216}},
		{"void F(out bool B) { B = true; }", "float f; F(f); R = f;", {1, 1, 1, 1}},
		{"void F(out int2 V) { V = int2(1, 2); }", "float4 f = 0; F(f.yz); R = f.y * 10 + f.z;", {12, 12, 12, 12}},
		{"void F(out float V) { V = 1.5; }", "int i; F(i); R = i + n;", {1, 2, 3, 4}},
		{"void F(inout float3 V) { V *= 1.5; }", "int4 i = int4(1, 2, 3, n); F(i.zyx); R = i.x * 10 + i.z;",
			{14, 14, 14, 14}},
		{"void F(out float2x2 M) { M = float2x2(1.5, 2.5, 3.5, 4.5); }", "int2x2 M; F(M); R = M._m11 * 10 + M._m00;",
			{41, 41, 41, 41}},
	});
}

TEST(HlslEmitter, CharactersAreTheirCodes)
{
	ExpectEmitted({
		{"uint ToUpper(uint C) { return C >= 'a' && C <= 'z' ? C - 'a' + 'A' : C; }", "R = ToUpper('q');",
			{81, 81, 81, 81}},
		{"static const uint Line[3] = {'\\n', '\\'', '\\0'};", "R = Line[n % 3];", {10, 39, 0, 10}},
	});
	EXPECT_THAT(ErrorOfEmitted("", "R = 'ab';"), HasSubstr("'ab' is not one character"));
	EXPECT_THAT(ErrorOfEmitted("", "R = 'a;"), HasSubstr("expected ''' at the end of the character"));
}

TEST(HlslEmitter, BitsWithoutANameAreAGap)
{
	ExpectEmitted({
		{"struct F { uint A : 3; uint : 2; uint B : 4; uint : 0; uint C : 5; }; RWStructuredBuffer<uint2> In;",
			"F f = (F)0; f.A = 7; f.B = 9; f.C = n; R = f.A * 100 + f.B * 10 + f.C;", {790, 791, 792, 793}},
	});
	EXPECT_THAT(ErrorOfEmitted("struct F { uint A : 0; };", "F f; R = 1;"), HasSubstr("has 1 to 32 bits"));
}

TEST(HlslEmitter, AStructMayBeDeclaredFirst)
{
	ExpectEmitted({
		{"struct Item; struct Packed { uint Bits; Item Unpack(); }; struct Item { float Value; };\n"
		 "Item Packed::Unpack() { Item I; I.Value = asfloat(Bits); return I; }",
			"Packed P; P.Bits = 0x3f800000; R = P.Unpack().Value + x;", {1, 2, 3, 4}},
	});
}

TEST(HlslEmitter, ValuesAndPlaces)
{
	ExpectEmitted({
		{"", "float4 v = float4(1, 2, 3, 4); v.zx = v.xy + x; R = v.x * 10 + v.z;", {21, 32, 43, 54}},
		{"", "float v[3] = {1, 2, 3}; v[n % 3] += 10; R = v[0] + v[1] * 2 + v[2] * 3;", {24, 34, 44, 24}},
		{"", "float2x3 M = {1, 2, 3, 4, 5, 6}; M._m01_m12 = float2(x, 9); R = M[0][1] * 100 + M[1].z;",
			{9, 109, 209, 309}},
		{"", "int2x2 M = {1, 2, 3, int(n)}; int2 v = mul(M, int2(1, 2)); R = v.x * 10 + v.y;", {53, 55, 57, 59}},
		{"", "bool2x2 M = {true, false, n > 1, true}; R = M[1][0] ? 5 : 6;", {6, 6, 5, 5}},
		{"", "float1x3 M = {1, 2, 3}; M[0][n % 3] = 7; R = M._m00 * 100 + M._m01 * 10 + M._m02;", {723, 173, 127, 723}},
		{"static const float T[4] = {1, 10, 100, 1000};", "R = T[n];", {1, 10, 100, 1000}},
		{"static float S = 3;", "S += x; R = S;", {3, 4, 5, 6}},
		{"struct FS { bool B; float2 V; int A[2]; };\nRWStructuredBuffer<FS> Items;",
			"FS s; s.B = n > 1; s.V = x; s.A[0] = 1; s.A[1] = int(n); Items[n % 2] = s; FS t = Items[n % 2]; t.V.y += "
			"1; "
			"R = (t.B ? 100 : 0) + t.V.y + t.A[1];",
			{1, 3, 105, 107}},
		{"", "int a = 1; (++a) += 5; ++(++a); R = a;", {9, 9, 9, 9}},
		{"", "int a = 1; int b = a++ + ++a; a <<= 2; R = a * 100 + b + x;", {1204, 1205, 1206, 1207}},
		{"", "R = (-7 + int(n)) % 3;", {-1, 0, -2, -1}},
		{"", "R = fmod(x - 5.5, 2.0);", {-1.5f, -0.5f, -1.5f, -0.5f}},
	});
}

TEST(HlslEmitter, FlowAndFunctions)
{
	ExpectEmitted({
		{"float F(float v) { if (v > 2) return 10; for (int i = 0; i < 5; ++i) { if (i > v) return i; } return 7; }",
			"R = F(x);", {1, 2, 3, 10}},
		{"", "for (uint i = 0; i < 6; ++i) { if (i == n) continue; if (i == 4) break; R += i; }", {6, 5, 4, 3}},
		{"", "switch (n) { case 0: R = 5; break; case 1: case 3: R = 6; break; default: R = 7; }", {5, 6, 7, 6}},
		{"", "uint i = 0; do { ++i; R += 2; } while (i < n);", {2, 2, 4, 6}},
		{"", "[unroll(2)] for (uint i = 0; i < n; ++i) R += 1;", {0, 1, 2, 2}},
		{"static int Calls = 0; bool G() { ++Calls; return true; }",
			"bool B = n > 1 && G(); R = Calls * 10 + (B ? 1 : 0);", {0, 0, 11, 11}},
		{"static int Calls = 0; int G() { ++Calls; return 4; }", "int B = n > 1 ? G() : 2; R = Calls * 10 + B;",
			{2, 2, 14, 14}},
		{"void F(inout float a, out float b) { a += 1; b = a * 2; }", "float b; R = x; F(R, b); R += b;",
			{3, 6, 9, 12}},
		{"RWStructuredBuffer<float> D;\nvoid F(inout float X) { X += 10; }", "D[n] = x; F(D[n]); R = D[n];",
			{10, 11, 12, 13}},
		{"struct FS { float A; void Add(float v) { A += v; } float Get() { return A * 2; } };",
			"FS s; s.A = x; s.Add(3); R = s.Get();", {6, 8, 10, 12}},
	});
}

TEST(HlslEmitter, Resources)
{
	ExpectEmitted({
		{"RWStructuredBuffer<float> A[2][2];", "A[n / 2][n % 2][0] = x + 1; R = A[1][1][0] + A[n / 2][n % 2][0];",
			{1, 2, 3, 8}},
		{"RWStructuredBuffer<float> A; RWStructuredBuffer<float> B;\nfloat F(RWStructuredBuffer<float> P) { P[1] += 1; "
		 "return P[1]; }",
			"RWStructuredBuffer<float> L = A; if (n > 1) L = B; R = F(L);", {1, 2, 1, 2}},
		{"struct FR { RWStructuredBuffer<float> P; float S; };\nRWStructuredBuffer<float> A;",
			"FR r; r.P = A; r.S = x; r.P[n] = r.S + 1; R = r.P[n];", {1, 2, 3, 4}},
		{"RWByteAddressBuffer A;\nstruct FI { float2 V; int16_t S; uint64_t L; };",
			"FI i; i.V = x; i.S = int16_t(n); i.L = 5; A.Store<FI>(n * 24, i); FI k = A.Load<FI>(n * 24); uint Size; "
			"A.GetDimensions(Size); R = k.V.y * 100 + float(uint(k.L)) * 10 + float(k.S) + Size;",
			{306, 407, 508, 609}},
		{"RWStructuredBuffer<uint> C;", "uint i = C.IncrementCounter(); R = i;", {0, 1, 2, 3}},
		{"groupshared uint G;", "InterlockedAdd(G, 2u); GroupMemoryBarrierWithGroupSync(); R = G;", {8, 8, 8, 8}},
		{"", "R = WavePrefixSum(n) * 10 + WaveActiveMax(n);", {3, 3, 13, 33}},
	});
}

TEST(HlslEmitter, Functions)
{
	ExpectEmitted({
		{"", "R = lit(x - 1, 2, 3).z;", {0, 8, 8, 8}},
		{"", "float e; float m = frexp(x - 6, e); R = m * 100 + e;", {-72, -59.5f, -47, -73}},
		{"", "R = firstbithigh(n + 8u) * 100 + countbits(n) * 10 + firstbitlow(n + 8u);", {303, 310, 311, 320}},
		{"", "R = msad4(0x01020304u, uint2(n, 0), uint4(0, 0, 0, 0)).x;", {10, 9, 8, 7}},
		{"", "R = sign(x - 1) * 10 + round(x + 0.5);", {-10, 2, 12, 14}},
		{"", "float i; R = modf(x - 1.25, i) * 100 + i;", {-26, -25, 75, 76}},
		{"", "R = asuint(f16tof32(f32tof16(x))) == asuint(x);", {1, 1, 1, 1}},
		{"", "R = dot(int3(1, 2, int(n)), int3(1, 1, 2));", {3, 5, 7, 9}},
		{"int Zero;", "R = (7u / uint(Zero)) == 0xFFFFFFFFu;", {1, 1, 1, 1}},
		{"", "double d = x; uint a, b; asuint(d + 0.5L, a, b); R = asdouble(a, b) * 2;", {1, 3, 5, 7}},
	});
}

TEST(HlslEmitter, NamesAndLayoutsAreThoseThatTheTierReads)
{
	const std::string Text = MakeEmitted("float4 Tint; bool Flag; cbuffer View { float3 A; float B; };\n"
										 "AppendStructuredBuffer<uint> Items; Texture2D T[2];",
		"if (Flag) { Items.Append(3); R = Tint.y + A.z + B + T[n][uint2(0, 0)].x; }");
	const FSpirvModule Module = ReadSpirv(CompileEmitted(Text));
	const FSpirvReflection Reflection = ReflectSpirv(Module, BuildSpirvStructure(Module), Text);
	std::vector<std::string> Names;
	for (const FShaderConstant& Constant : Reflection.Reflection.Constants)
	{
		Names.push_back(Constant.Name + "@" + std::to_string(Constant.Offset));
	}
	EXPECT_THAT(Names, testing::UnorderedElementsAre("Tint@0", "Flag@16", "A@0", "B@12"));
	std::vector<std::string> Resources;
	for (const auto* List : {&Reflection.Reflection.Textures, &Reflection.Reflection.RWBuffers})
	{
		for (const FShaderResource& Resource : *List)
		{
			Resources.push_back(Resource.Name + (Resource.CounterOf.empty() ? "" : " of " + Resource.CounterOf));
		}
	}
	EXPECT_THAT(Resources, testing::UnorderedElementsAre("T_0", "T_1", "Out", "Items", "Items@count of Items"));

	const FSpirvModule Whole =
		ReadWholeSpirv(CompileEmitted(MakeEmitted("float F(float V) { return V; }", "R = F(x);"), true));
	EXPECT_TRUE(std::ranges::any_of(Whole.Functions, [](const FSpirvFunction& F) { return F.Name == "F"; }));
	EXPECT_TRUE(std::ranges::any_of(Whole.Functions, [](const FSpirvFunction& F) { return F.Name == "Main"; }));
}

TEST(HlslEmitter, PixelShadersTakeAndGiveBySemantic)
{
	const std::string Text =
		"struct FIn { float4 P : SV_POSITION; float2 UV[2] : TEXCOORD1; };\nstruct FOut { float4 A : SV_Target0; "
		"float4 "
		"B : SV_Target2; };\nTexture2D T; SamplerState S;\nFOut Main(FIn In, bool bFront : SV_IsFrontFace)\n{ FOut O; "
		"clip(In.P.x - 2); O.A = T.Sample(S, In.UV[1], int2(1, 0)) + ddx(In.P.x); O.B = bFront ? 1 : In.UV[0].xyxy; "
		"return O; }";
	const std::vector<uint32_t> Words = CompileEmitted(Text, false, EShaderStage::Pixel);
	EXPECT_EQ("", ValidateEmitted(Words));
	EXPECT_EQ("", ValidateEmitted(CompileEmitted(Text, true, EShaderStage::Pixel)));
	const FSpirvModule Module = ReadSpirv(Words);
	std::vector<std::string> Found;
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		if (!Variable.Semantic.empty())
		{
			Found.push_back(Variable.Name + ":" + Variable.Semantic + "@" + std::to_string(Variable.Location));
		}
	}
	EXPECT_THAT(Found,
		testing::IsSupersetOf({std::string("In.UV[1]:TEXCOORD2@1"), std::string("@entryPointOutput.B:SV_TARGET2@2")}));
}

TEST(HlslEmitter, WhatItCannotWriteIsAMessageWithItsPlace)
{
	EXPECT_THAT(ErrorOfEmitted("RWStructuredBuffer<float> A[];", "A[n][0] = 1;"), HasSubstr("without a size"));
	EXPECT_THAT(ErrorOfEmitted("struct FM { RWBuffer<uint> A; float B; };\nFM Mix;", "Mix.A[0] = uint(Mix.B);"),
		HasSubstr("the number 'B' beside its resources"));
	EXPECT_THAT(ErrorOfEmitted("RWTexture2D<uint64_t> T;", "T[Id.xy] = 1;"), HasSubstr("texels have 32 bits"));
}

TEST(HlslEmitter, ArithmeticOfFloatsStaysAsItIsWritten)
{
	const std::vector<uint32_t> Words =
		CompileEmitted(MakeEmitted("", "R = x * 3 * 5; while (true) { if (R > 1) R = R / 7; else break; }"));
	std::map<uint16_t, int> Count;
	for (size_t At = Spirv::HeaderWords; At < Words.size(); At += Words[At] >> 16)
	{
		++Count[uint16_t(Words[At])];
	}
	EXPECT_EQ(2, Count[Spirv::OpFMul]);
	EXPECT_EQ(1, Count[Spirv::OpFDiv]);
	EXPECT_EQ(1, Count[Spirv::OpLoopMerge]);
	EXPECT_EQ(0, Count[218]);
}
