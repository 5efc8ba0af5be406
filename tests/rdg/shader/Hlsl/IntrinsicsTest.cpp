// Functions of HLSL: results and parameters by Microsoft's reference, and what wrong calls are told.
#include "HlslIntrinsics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace Drydock::Hlsl
{

namespace
{

const FType* MakeIntrinsicStruct(FTypes& Types)
{
	FStructType Struct;
	Struct.Name = "FItem";
	return Types.Struct(Struct);
}

/** "1" and "1.0" are literals, "S" is a struct, everything else is a numeric type. */
const FType* ReadIntrinsicType(FTypes& Types, const std::string& Name)
{
	return Name == "1"     ? Types.Scalar(EScalar::LiteralInt)
		   : Name == "1.0" ? Types.Scalar(EScalar::LiteralFloat)
		   : Name == "S"   ? MakeIntrinsicStruct(Types)
		   : Name == "!"   ? Types.Error()
						   : Types.FindNumeric(Name, EOrder::Row);
}

/** "lerp(float3, float)" -> "float3(float3, float3)"; what is written stands behind >. */
std::string CallIntrinsic(const std::string& Text, bool bRealHalf = true)
{
	FTypes Types(bRealHalf);
	const size_t Open = Text.find('(');
	std::vector<const FType*> Arguments;
	size_t At = Open + 1;
	while (Text[At] != ')')
	{
		const size_t End = Text.find_first_of(",)", At);
		Arguments.push_back(ReadIntrinsicType(Types, Text.substr(At, End - At)));
		EXPECT_NE(Arguments.back(), nullptr) << Text;
		At = Text[End] == ',' ? End + 2 : End;
	}
	const FIntrinsicCall Call = FindIntrinsicCall(Types, Text.substr(0, Open), Arguments);
	if (!Call.Error.empty())
	{
		return Call.Error;
	}
	EXPECT_EQ(Call.Name, Text.substr(0, Open));
	EXPECT_EQ(Call.Parameters.size(), Arguments.size());
	std::string Result = (Call.Result->Kind == EType::Void ? "void" : GetName(Call.Result)) + "(";
	for (size_t i = 0; i < Call.Parameters.size(); ++i)
	{
		Result += (i ? ", " : "") + std::string(Call.bOut[i] ? ">" : "") + GetName(Call.Parameters[i]);
	}
	return Result + ")";
}

struct FExpectedCall
{
	const char* Call;
	const char* Result;
};

void CheckIntrinsics(std::initializer_list<FExpectedCall> Calls)
{
	for (const FExpectedCall& Expected : Calls)
	{
		EXPECT_EQ(CallIntrinsic(Expected.Call), Expected.Result) << Expected.Call;
	}
}

} // namespace

TEST(HlslIntrinsics, RealsGoByComponents)
{
	// D3D's compilers make floats of doubles with a warning. Here they stay what SPIR-V has for them.
	const std::set<std::string> Wide = {"ceil", "floor", "frac", "round", "rsqrt", "sqrt", "trunc"};
	for (const std::string Name : {"acos", "asin", "atan", "ceil", "cos", "cosh", "degrees", "exp", "exp2", "floor",
			 "frac", "log", "log10", "log2", "radians", "round", "rsqrt", "sin", "sinh", "sqrt", "tan", "tanh", "trunc",
			 "ddx", "ddy", "ddx_coarse", "ddx_fine", "ddy_coarse", "ddy_fine", "fwidth"})
	{
		EXPECT_EQ(CallIntrinsic(Name + "(float)"), "float(float)") << Name;
		EXPECT_EQ(CallIntrinsic(Name + "(float3)"), "float3(float3)") << Name;
		EXPECT_EQ(CallIntrinsic(Name + "(float16_t2)"), "float16_t2(float16_t2)") << Name;
		EXPECT_EQ(CallIntrinsic(Name + "(int2)"), "float2(float2)") << Name;
		EXPECT_EQ(CallIntrinsic(Name + "(double)"), Wide.count(Name) ? "double(double)" : "float(float)") << Name;
		EXPECT_EQ(CallIntrinsic(Name + "(bool)"), "float(float)") << Name;
		EXPECT_EQ(CallIntrinsic(Name + "(1)"), "float(float)") << Name;
		EXPECT_EQ(CallIntrinsic(Name + "(1.0)"), "float(float)") << Name;
		EXPECT_EQ(CallIntrinsic(Name + "(float2x3)"), "float2x3(float2x3)") << Name;
	}
	for (const std::string Name : {"atan2", "fmod", "ldexp", "pow", "step"})
	{
		EXPECT_EQ(CallIntrinsic(Name + "(float, float)"), "float(float, float)") << Name;
		EXPECT_EQ(CallIntrinsic(Name + "(float3, 1.0)"), "float3(float3, float3)") << Name;
		EXPECT_EQ(CallIntrinsic(Name + "(1, float2)"), "float2(float2, float2)") << Name;
		EXPECT_EQ(CallIntrinsic(Name + "(int, int)"), "float(float, float)") << Name;
		EXPECT_EQ(CallIntrinsic(Name + "(float16_t, 1.0)"), "float16_t(float16_t, float16_t)") << Name;
		EXPECT_EQ(CallIntrinsic(Name + "(float4, float3)"), "float3(float3, float3)") << Name;
	}
	for (const std::string Name : {"lerp", "smoothstep"})
	{
		EXPECT_EQ(CallIntrinsic(Name + "(float3, float3, float)"), "float3(float3, float3, float3)") << Name;
		EXPECT_EQ(CallIntrinsic(Name + "(1, 1, float2)"), "float2(float2, float2, float2)") << Name;
		EXPECT_EQ(
			CallIntrinsic(Name + "(float16_t3, float16_t3, 1.0)"), "float16_t3(float16_t3, float16_t3, float16_t3)")
			<< Name;
		EXPECT_EQ(CallIntrinsic(Name + "(int, int, int)"), "float(float, float, float)") << Name;
	}
}

TEST(HlslIntrinsics, NumbersKeepTheirScalar)
{
	CheckIntrinsics({{"abs(float3)", "float3(float3)"}, {"abs(int)", "int(int)"}, {"abs(uint2)", "uint2(uint2)"},
		{"abs(double)", "double(double)"}, {"abs(bool)", "int(int)"}, {"abs(1)", "int(int)"},
		{"abs(1.0)", "float(float)"}, {"sign(float3)", "int3(float3)"}, {"sign(int)", "int(int)"},
		{"sign(uint2)", "int2(uint2)"}, {"sign(double)", "int(double)"}, {"max(int, int)", "int(int, int)"},
		{"max(int, uint)", "uint(uint, uint)"}, {"max(uint, 1)", "uint(uint, uint)"},
		{"min(int, 1.0)", "float(float, float)"}, {"min(float16_t2, 1)", "float16_t2(float16_t2, float16_t2)"},
		{"min(double, float)", "double(double, double)"}, {"min(1, 1)", "int(int, int)"},
		{"min(1, 1.0)", "float(float, float)"}, {"min(int16_t, 1)", "int16_t(int16_t, int16_t)"},
		{"max(bool, bool)", "int(int, int)"}, {"max(float2x2, 1)", "float2x2(float2x2, float2x2)"},
		{"max(uint64_t, uint)", "uint64_t(uint64_t, uint64_t)"},
		{"clamp(float3, 1, 1.0)", "float3(float3, float3, float3)"}, {"clamp(int2, 1, int)", "int2(int2, int2, int2)"},
		{"mad(int, int, int)", "int(int, int, int)"}, {"mad(float3, float, float3)", "float3(float3, float3, float3)"},
		{"mad(uint2, uint2, uint2)", "uint2(uint2, uint2, uint2)"}, {"saturate(float3)", "float3(float3)"},
		{"saturate(double)", "double(double)"}, {"saturate(int)", "float(float)"}, {"rcp(float2)", "float2(float2)"},
		{"rcp(double2)", "double2(double2)"}, {"rcp(int)", "float(float)"},
		{"fma(double, double, double)", "double(double, double, double)"},
		{"fma(double2, double2, double)", "double2(double2, double2, double2)"}});
}

TEST(HlslIntrinsics, Outputs)
{
	CheckIntrinsics({{"modf(float3, float3)", "float3(float3, >float3)"}, {"modf(float, int)", "float(float, >int)"},
		{"modf(float2, int2)", "float2(float2, >int2)"}, {"frexp(float2, float2)", "float2(float2, >float2)"},
		{"sincos(float, float, float)", "void(float, >float, >float)"},
		{"sincos(float16_t3, float16_t3, float16_t3)", "void(float16_t3, >float16_t3, >float16_t3)"},
		{"sincos(int, float, float)", "void(float, >float, >float)"}, {"clip(float)", "void(float)"},
		{"clip(float4)", "void(float4)"}, {"clip(int)", "void(float)"}});
}

TEST(HlslIntrinsics, Conditions)
{
	CheckIntrinsics({{"all(float3)", "bool(bool3)"}, {"any(bool4)", "bool(bool4)"}, {"any(int)", "bool(bool)"},
		{"all(float2x2)", "bool(bool2x2)"}, {"isnan(float3)", "bool3(float3)"}, {"isinf(float)", "bool(float)"},
		{"isfinite(float16_t2)", "bool2(float16_t2)"}, {"isnan(int)", "bool(float)"},
		{"and(bool2, bool2)", "bool2(bool2, bool2)"}, {"or(bool, bool)", "bool(bool, bool)"},
		{"or(int3, bool3)", "bool3(bool3, bool3)"}, {"select(bool3, float3, float3)", "float3(bool3, float3, float3)"},
		{"select(bool3, 1.0, float)", "float3(bool3, float3, float3)"},
		{"select(bool, bool, bool)", "bool(bool, bool, bool)"},
		{"select(bool, float3, 1)", "float3(bool3, float3, float3)"},
		{"select(float2, int2, uint)", "uint2(bool2, uint2, uint2)"}, {"select(bool, 1, 1)", "int(bool, int, int)"}});
}

TEST(HlslIntrinsics, Bits)
{
	CheckIntrinsics({{"asfloat(uint3)", "float3(uint3)"}, {"asfloat(int)", "float(int)"},
		{"asfloat(float)", "float(float)"}, {"asint(float2)", "int2(float2)"}, {"asuint(float4)", "uint4(float4)"},
		{"asuint(1)", "uint(int)"}, {"asfloat(1)", "float(int)"}, {"asuint(1.0)", "uint(float)"},
		{"asuint(float2x2)", "uint2x2(float2x2)"}, {"asuint(double, uint, uint)", "void(double, >uint, >uint)"},
		{"asuint(double2, uint2, uint2)", "void(double2, >uint2, >uint2)"},
		{"asdouble(uint, uint)", "double(uint, uint)"}, {"asdouble(uint2, uint2)", "double2(uint2, uint2)"},
		{"asuint16(float16_t2)", "uint16_t2(float16_t2)"}, {"asint16(uint16_t)", "int16_t(uint16_t)"},
		{"asfloat16(int16_t3)", "float16_t3(int16_t3)"}, {"f16tof32(uint2)", "float2(uint2)"},
		{"f32tof16(float3)", "uint3(float3)"}, {"f32tof16(1)", "uint(float)"}, {"countbits(uint)", "uint(uint)"},
		{"countbits(int3)", "uint3(int3)"}, {"countbits(uint64_t)", "uint(uint64_t)"},
		{"firstbithigh(int)", "uint(int)"}, {"firstbithigh(uint2)", "uint2(uint2)"}, {"firstbitlow(1)", "uint(int)"},
		{"reversebits(uint4)", "uint4(uint4)"}, {"reversebits(int)", "int(int)"},
		{"AddUint64(uint2, uint2)", "uint2(uint2, uint2)"}, {"AddUint64(uint4, uint4)", "uint4(uint4, uint4)"},
		{"msad4(uint, uint2, uint4)", "uint4(uint, uint2, uint4)"},
		{"dot2add(float16_t2, float16_t2, float)", "float(float16_t2, float16_t2, float)"},
		{"dot4add_u8packed(uint, uint, uint)", "uint(uint, uint, uint)"},
		{"dot4add_i8packed(uint, uint, int)", "int(uint, uint, int)"}, {"pack_u8(uint4)", "uint(uint4)"},
		{"pack_u8(uint16_t4)", "uint(uint16_t4)"}, {"pack_s8(int4)", "uint(int4)"},
		{"pack_s8(int16_t4)", "uint(int16_t4)"}, {"pack_clamp_u8(int4)", "uint(int4)"},
		{"pack_clamp_s8(int16_t4)", "uint(int16_t4)"}, {"unpack_u8u32(uint)", "uint4(uint)"},
		{"unpack_s8s32(uint)", "int4(uint)"}, {"unpack_u8u16(uint)", "uint16_t4(uint)"},
		{"unpack_s8s16(uint)", "int16_t4(uint)"}, {"D3DCOLORtoUBYTE4(float4)", "int4(float4)"},
		{"NonUniformResourceIndex(uint)", "uint(uint)"}, {"NonUniformResourceIndex(1)", "int(int)"}});
}

TEST(HlslIntrinsics, Vectors)
{
	CheckIntrinsics({{"dot(float3, float3)", "float(float3, float3)"}, {"dot(int2, int2)", "int(int2, int2)"},
		{"dot(uint4, uint4)", "uint(uint4, uint4)"}, {"dot(float4, float3)", "float(float3, float3)"},
		{"dot(float3, 1)", "float(float3, float3)"}, {"dot(float, float)", "float(float, float)"},
		{"dot(float16_t2, float16_t2)", "float16_t(float16_t2, float16_t2)"},
		{"dot(float1x3, float3)", "float(float3, float3)"}, {"length(float3)", "float(float3)"},
		{"length(float)", "float(float)"}, {"length(int2)", "float(float2)"},
		{"distance(float3, float3)", "float(float3, float3)"}, {"normalize(float16_t3)", "float16_t3(float16_t3)"},
		{"normalize(float)", "float(float)"}, {"reflect(float3, float3)", "float3(float3, float3)"},
		{"refract(float3, float3, float)", "float3(float3, float3, float)"},
		{"refract(float3, float3, 1.0)", "float3(float3, float3, float)"},
		{"faceforward(float2, float2, float2)", "float2(float2, float2, float2)"},
		{"cross(float3, float3)", "float3(float3, float3)"}, {"cross(float4, float16_t3)", "float3(float3, float3)"},
		{"dst(float4, float4)", "float4(float4, float4)"}, {"lit(float, float, 1)", "float4(float, float, float)"},
		{"determinant(float3x3)", "float(float3x3)"}, {"determinant(float1x1)", "float(float1x1)"},
		{"transpose(float2x3)", "float3x2(float2x3)"}, {"transpose(bool4x1)", "bool1x4(bool4x1)"},
		{"transpose(int3x3)", "int3x3(int3x3)"}});
}

TEST(HlslIntrinsics, NineProducts)
{
	CheckIntrinsics({{"mul(float, float)", "float(float, float)"}, {"mul(float, float3)", "float3(float, float3)"},
		{"mul(int, int2x3)", "int2x3(int, int2x3)"}, {"mul(float3, 1)", "float3(float3, float)"},
		{"mul(float3, float3)", "float(float3, float3)"}, {"mul(uint4, uint4)", "uint(uint4, uint4)"},
		{"mul(float2, float2x3)", "float3(float2, float2x3)"}, {"mul(float2x3, 1.0)", "float2x3(float2x3, float)"},
		{"mul(float2x3, float3)", "float2(float2x3, float3)"},
		{"mul(float2x3, float3x4)", "float2x4(float2x3, float3x4)"}, {"mul(int3x3, int3)", "int3(int3x3, int3)"},
		{"mul(int3x3, float3)", "float3(float3x3, float3)"},
		{"mul(float16_t3, float16_t3x3)", "float16_t3(float16_t3, float16_t3x3)"},
		{"mul(double2x2, double2)", "double2(double2x2, double2)"},
		// What is too long is cut.
		{"mul(float4, float3x3)", "float3(float3, float3x3)"}, {"mul(float3, float4x4)", "float4(float3, float3x4)"},
		{"mul(float4x3, float4x4)", "float4x4(float4x3, float3x4)"},
		{"mul(float1, float4x4)", "float4(float1, float1x4)"},
		{"mul(float3x1, float1x3)", "float3x3(float3x1, float1x3)"}, {"mul(bool2, bool2)", "int(int2, int2)"}});
}

TEST(HlslIntrinsics, GroupsAndWaves)
{
	for (const std::string Name : {"GroupMemoryBarrier", "GroupMemoryBarrierWithGroupSync", "DeviceMemoryBarrier",
			 "DeviceMemoryBarrierWithGroupSync", "AllMemoryBarrier", "AllMemoryBarrierWithGroupSync"})
	{
		EXPECT_EQ(CallIntrinsic(Name + "()"), "void()") << Name;
	}
	for (const std::string Name : {"InterlockedAdd", "InterlockedAnd", "InterlockedOr", "InterlockedXor",
			 "InterlockedMin", "InterlockedMax", "InterlockedExchange"})
	{
		EXPECT_EQ(CallIntrinsic(Name + "(uint, 1, uint)"), "void(>uint, uint, >uint)") << Name;
		EXPECT_EQ(CallIntrinsic(Name + "(int, float, uint)"), "void(>int, int, >int)") << Name;
		EXPECT_EQ(CallIntrinsic(Name + "(uint64_t, 1, uint64_t)"), "void(>uint64_t, uint64_t, >uint64_t)") << Name;
	}
	for (const std::string Name :
		{"WaveActiveSum", "WaveActiveProduct", "WaveActiveMin", "WaveActiveMax", "WavePrefixSum", "WavePrefixProduct"})
	{
		EXPECT_EQ(CallIntrinsic(Name + "(float3)"), "float3(float3)") << Name;
		EXPECT_EQ(CallIntrinsic(Name + "(uint)"), "uint(uint)") << Name;
		EXPECT_EQ(CallIntrinsic(Name + "(bool)"), "int(int)") << Name;
	}
	for (const std::string Name : {"WaveActiveBitAnd", "WaveActiveBitOr", "WaveActiveBitXor"})
	{
		EXPECT_EQ(CallIntrinsic(Name + "(uint2)"), "uint2(uint2)") << Name;
	}
	for (const std::string Name : {"WaveReadLaneFirst", "QuadReadAcrossX", "QuadReadAcrossY", "QuadReadAcrossDiagonal"})
	{
		EXPECT_EQ(CallIntrinsic(Name + "(float16_t2)"), "float16_t2(float16_t2)") << Name;
		EXPECT_EQ(CallIntrinsic(Name + "(bool)"), "bool(bool)") << Name;
		EXPECT_EQ(CallIntrinsic(Name + "(1)"), "int(int)") << Name;
	}
	CheckIntrinsics({{"InterlockedAdd(int, 1)", "void(>int, int)"},
		{"InterlockedExchange(float, 1, float)", "void(>float, float, >float)"},
		{"InterlockedCompareStore(uint, 1, 1)", "void(>uint, uint, uint)"},
		{"InterlockedCompareExchange(int, 1, int, int)", "void(>int, int, int, >int)"},
		{"InterlockedCompareStoreFloatBitwise(float, 1.0, float)", "void(>float, float, float)"},
		{"InterlockedCompareExchangeFloatBitwise(float, 1, float, float)", "void(>float, float, float, >float)"},
		{"WaveGetLaneIndex()", "uint()"}, {"WaveGetLaneCount()", "uint()"}, {"WaveIsFirstLane()", "bool()"},
		{"WaveActiveBallot(bool)", "uint4(bool)"}, {"WaveActiveAnyTrue(int)", "bool(bool)"},
		{"WaveActiveAllTrue(bool)", "bool(bool)"}, {"WaveActiveAllEqual(float3)", "bool3(float3)"},
		{"WaveActiveCountBits(bool)", "uint(bool)"}, {"WavePrefixCountBits(bool)", "uint(bool)"},
		{"WaveReadLaneAt(float4, int)", "float4(float4, uint)"}, {"QuadReadLaneAt(uint, 1)", "uint(uint, uint)"},
		{"QuadAny(bool)", "bool(bool)"}, {"QuadAll(bool)", "bool(bool)"}, {"WaveMatch(float3)", "uint4(float3)"},
		{"WaveMultiPrefixSum(float2, uint4)", "float2(float2, uint4)"},
		{"WaveMultiPrefixProduct(uint, uint4)", "uint(uint, uint4)"},
		{"WaveMultiPrefixBitAnd(uint, uint4)", "uint(uint, uint4)"},
		{"WaveMultiPrefixBitOr(uint, uint4)", "uint(uint, uint4)"},
		{"WaveMultiPrefixBitXor(uint, uint4)", "uint(uint, uint4)"},
		{"WaveMultiPrefixCountBits(bool, uint4)", "uint(bool, uint4)"}, {"IsHelperLane()", "bool()"},
		{"GetRenderTargetSampleCount()", "uint()"}, {"GetRenderTargetSamplePosition(int)", "float2(int)"},
		{"EvaluateAttributeCentroid(float2)", "float2(float2)"},
		{"EvaluateAttributeAtSample(float4, 1)", "float4(float4, uint)"},
		{"EvaluateAttributeSnapped(float4, int2)", "float4(float4, int2)"},
		{"CheckAccessFullyMapped(uint)", "bool(uint)"}});
}

TEST(HlslIntrinsics, WithoutRealHalf)
{
	EXPECT_EQ(CallIntrinsic("lerp(half3, half3, 1.0)", false), "half3(half3, half3, half3)");
	EXPECT_EQ(CallIntrinsic("lerp(half3, float3, 1.0)", false), "float3(float3, float3, float3)");
	EXPECT_EQ(CallIntrinsic("asuint(half2)", false), "uint2(float2)");
	EXPECT_EQ(CallIntrinsic("min(min16int, 1)", false), "min16int(min16int, min16int)");
	EXPECT_EQ(CallIntrinsic("asfloat16(uint16_t)", false), "float16_t(uint16_t)");
	EXPECT_EQ(CallIntrinsic("dot2add(half2, half2, 1)", false), "float(half2, half2, float)");
	EXPECT_EQ(CallIntrinsic("dot2add(float16_t2, half2, float)", false), "float(half2, half2, float)");
	EXPECT_THAT(CallIntrinsic("asuint16(half)", false), testing::HasSubstr("a number of 16 bits"));
}

TEST(HlslIntrinsics, WrongCallsSayHowToWriteThem)
{
	CheckIntrinsics({
		{"lerp(float3, float3)",
			"X3013: 'lerp' takes 3 arguments, but 2 are given; write lerp(float3, float3, float3)"},
		{"sin()", "X3013: 'sin' takes 1 argument, but none is given; write sin(float)"},
		{"cross(float3, float3, float3)",
			"X3013: 'cross' takes 2 arguments, but 3 are given; write cross(float3, float3)"},
		{"InterlockedAdd(uint)",
			"X3013: 'InterlockedAdd' takes 2 or 3 arguments, but 1 is given; write InterlockedAdd(inout uint, uint)"},
		{"asuint(double, uint)", "X3013: 'asuint' takes 1 or 3 arguments, but 2 are given; write asuint(float)"},
		{"cross(float2, float3)",
			"X3013: argument 1 of 'cross' has the type float2, but float3 is expected; write cross(float3, float3)"},
		{"lerp(S, float, float)", "X3013: argument 1 of 'lerp' has the type FItem, but a number is expected; write "
								  "lerp(float, float, float)"},
		{"countbits(float2)",
			"X3013: argument 1 of 'countbits' has the type float2, but an integer is expected; write countbits(uint2)"},
		{"asuint(double)",
			"X3013: argument 1 of 'asuint' has the type double, but a number of 32 bits (float, int, uint) is "
			"expected; write asuint(float)"},
		{"asfloat(int64_t)",
			"X3013: argument 1 of 'asfloat' has the type int64_t, but a number of 32 bits (float, int, uint) is "
			"expected; write asfloat(float)"},
		{"length(float2x2)", "X3013: argument 1 of 'length' has the type float2x2, but a scalar or a vector is "
							 "expected; write length(float)"},
		{"determinant(float2x3)",
			"X3013: argument 1 of 'determinant' has the type float2x3, but a square matrix is expected; "
			"write determinant(float3x3)"},
		{"transpose(float3)", "X3013: argument 1 of 'transpose' has the type float3, but a matrix is expected; write "
							  "transpose(float3x3)"},
		{"InterlockedAdd(float, 1.0)",
			"X3013: argument 1 of 'InterlockedAdd' has the type float, but an integer is expected; "
			"write InterlockedAdd(inout uint, uint)"},
		{"InterlockedAdd(int2, 1)",
			"X3013: argument 1 of 'InterlockedAdd' has the type int2, but a place of int, uint, int64_t "
			"or uint64_t is expected; write InterlockedAdd(inout int, int)"},
		{"tex2D(float, float2)", "'tex2D' cannot be called: it is of Direct3D 9; write Texture.Sample(Sampler, UV)"},
		{"frobnicate(float)", "X3004: undeclared identifier 'frobnicate'"},
	});
	EXPECT_THAT(CallIntrinsic("max(float3, float2x2)"),
		testing::StartsWith("X3013: the arguments of 'max' do not fit each other: X3020"));
	EXPECT_THAT(CallIntrinsic("TraceRay()"), testing::HasSubstr("march through the depth texture"));
	EXPECT_THAT(CallIntrinsic("mul(S, float3)"), testing::HasSubstr("argument 1 of 'mul' has the type FItem"));
}

TEST(HlslIntrinsics, WhatWasReportedFitsEverything)
{
	FTypes Types(false);
	const FIntrinsicCall Call = FindIntrinsicCall(Types, "lerp", {Types.Error(), Types.Scalar(EScalar::Float)});
	EXPECT_EQ(Call.Error, "");
	EXPECT_EQ(Call.Result, Types.Error());
	EXPECT_EQ(Call.Parameters.size(), 2u);
}

TEST(HlslIntrinsics, NamesAndPurity)
{
	EXPECT_TRUE(IsIntrinsic("lerp"));
	EXPECT_TRUE(IsIntrinsic("tex2D"));
	EXPECT_FALSE(IsIntrinsic("Sample"));
	EXPECT_THAT(ListIntrinsics(), testing::IsSupersetOf({"mul", "WaveActiveSum"}));
	EXPECT_THAT(ListIntrinsics(), testing::Not(testing::Contains("tex2D")));
	for (const char* const Name : {"lerp", "mul", "asuint", "select", "transpose", "countbits", "msad4"})
	{
		EXPECT_TRUE(IsPure(Name)) << Name;
	}
	for (const char* const Name : {"ddx", "clip", "sincos", "InterlockedAdd", "WaveActiveSum", "QuadAny", "tex2D",
			 "Sample", "GroupMemoryBarrier", "Nothing"})
	{
		EXPECT_FALSE(IsPure(Name)) << Name;
	}
}

/** The order of a matrix's rows and columns in memory is the argument's: nothing is turned for a call. */
TEST(HlslIntrinsics, MatricesKeepTheirOrder)
{
	FTypes Types(false);
	const FType* const Columns = Types.Matrix(EScalar::Float, 2, 3, EOrder::Column);
	const FType* const Rows = Types.Matrix(EScalar::Float, 2, 3, EOrder::Row);
	const FIntrinsicCall Call = FindIntrinsicCall(Types, "max", {Columns, Rows});
	EXPECT_EQ(Call.Parameters[0], Columns);
	EXPECT_EQ(Call.Parameters[1], Rows);
	EXPECT_EQ(FindIntrinsicCall(Types, "transpose", {Columns}).Parameters[0], Columns);
	EXPECT_EQ(FindIntrinsicCall(Types, "mul", {Columns, Types.Vector(EScalar::Float, 3)}).Parameters[0], Columns);
}

} // namespace Drydock::Hlsl
