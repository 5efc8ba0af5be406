// Constants against run time: the same expressions, once of constants, which the front end folds, and once of values
// from a buffer, which the interpreter computes, give the same bits.
#include <gtest/gtest.h>

#include "HlslFrontEnd.h"
#include "SpirvInterpreter.h"
#include "SpirvModule.h"
#include "SpirvOps.h"
#include "SpirvReflect.h"
#include "SpirvStructure.h"
#include "TileExecutor.h"

#include <bit>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

namespace Drydock::Hlsl::Tests
{
namespace
{

/** An expression of A, B and C, of one type each, that gives Result. */
struct FConstantsCase
{
	std::string Type;
	std::string Result;
	std::string Expression;
};

constexpr size_t GConstantsWords = 16; // of one operand and of one result

FSpirvModule CompileConstants(const std::string& Text)
{
	FShaderCompileRequest Request;
	Request.VirtualPath = "/Test/Constants.usf";
	Request.EntryPoint = "MainCS";
	Request.Stage = EShaderStage::Compute;
	return ReadSpirv(Compile(Text, Request));
}

std::vector<uint32_t> RunConstants(
	const FSpirvModule& Module, const std::string& Text, std::vector<uint32_t>& In, size_t NumOut)
{
	const FSpirvReflection Reflection = ReflectSpirv(Module, BuildSpirvStructure(Module), Text);
	std::vector<uint32_t> Out(NumOut, 0xCDCDCDCD);
	const auto View = [](std::vector<uint32_t>& Words)
	{
		return FKernelBuffer{
			reinterpret_cast<uint8_t*>(Words.data()), uint32_t(Words.size() * 4), 4, ETexelStorage::R32_UINT};
	};
	const FKernelBuffer Ins[1] = {View(In)};
	const FKernelBuffer Outs[1] = {View(Out)};
	FKernelCounters Counters = {};
	FKernelArgs Args = {};
	Args.Buffers = Ins;
	Args.RWBuffers = Outs;
	Args.Counters = &Counters;
	FSpirvInterpreter Interpreter(Module, Reflection);
	const FScopedDenormals Denormals(EDenormals::Flush);
	Interpreter.Run(Args, 0, 0, 0);
	return Out;
}

uint32_t CountOf(const std::string& Type)
{
	const char Last = Type.back();
	const bool bMatrix = Type.size() > 2 && Type[Type.size() - 2] == 'x';
	return bMatrix ? uint32_t(Type[Type.size() - 3] - '0') * uint32_t(Last - '0')
				   : (Last >= '1' && Last <= '4' && Type != "float16_t" ? uint32_t(Last - '0') : 1);
}

std::string ScalarOf(const std::string& Type)
{
	return Type.substr(0, Type.find_first_of("1234"));
}

/** The operand out of the words from First on: of a scalar type of 32 bits. */
std::string Operand(const std::string& Type, const std::vector<std::string>& Words, size_t First)
{
	const std::string Scalar = ScalarOf(Type);
	const std::string Cast = Scalar == "float"  ? "asfloat"
							 : Scalar == "int"  ? "asint"
							 : Scalar == "uint" ? ""
												: "asfloat";
	std::string Text = Type + "(";
	for (uint32_t i = 0; i < CountOf(Type); ++i)
	{
		Text += (i ? ", " : "") +
				(Scalar == "bool" ? "(" + Words[First + i] + " & 1u) != 0u" : Cast + "(" + Words[First + i] + ")");
	}
	return Text + ")";
}

class HlslConstantsRun : public ::testing::Test
{
protected:
	std::mt19937 Random{38};

	uint32_t Pick(const std::string& Type)
	{
		static constexpr float Reals[] = {
			0, -0.0f, 1, -1, 0.5f, -7.5f, 2, 2.5f, 3.5f, 1e-30f, 1e30f, -3e9f, 5e9f, 0.3f, 100, 1e-38f};
		static constexpr uint32_t Words[] = {0, 1, 2, 3, 5, 7, 31, 32, 33, 0xFFFFFFFF, 0x80000000, 0x7FFFFFFF, 0xF0F0};
		const uint32_t Which = Random();
		if (ScalarOf(Type) == "int" || ScalarOf(Type) == "uint" || ScalarOf(Type) == "bool")
		{
			return Which % 3 ? Words[Random() % std::size(Words)] : Random();
		}
		const float Any = float(int32_t(Random())) / float(1 << (Random() % 31));
		return std::bit_cast<uint32_t>(Which % 2 ? Reals[Random() % std::size(Reals)] : Any);
	}

	/** Compares Cases, each with operands of its own. */
	void Check(const std::vector<FConstantsCase>& Cases)
	{
		std::vector<uint32_t> In;
		std::vector<std::string> Literals;
		std::vector<std::string> Loads;
		std::string Texts[2];
		for (size_t i = 0; i < Cases.size(); ++i)
		{
			const FConstantsCase& Case = Cases[i];
			const size_t First = In.size();
			for (size_t k = 0; k < 3 * GConstantsWords; ++k)
			{
				In.push_back(Pick(Case.Type));
				char Literal[16];
				std::snprintf(Literal, sizeof(Literal), "0x%08Xu", In.back());
				Literals.push_back(Literal);
				Loads.push_back("In[" + std::to_string(In.size() - 1) + "]");
			}
			for (const bool bRun : {false, true})
			{
				std::string& Text = Texts[bRun];
				Text += "\t{\n";
				for (size_t k = 0; k < 3; ++k)
				{
					Text += "\t\tconst " + Case.Type + " " + std::string(1, char('A' + k)) + " = " +
							Operand(Case.Type, bRun ? Loads : Literals, First + k * GConstantsWords) + ";\n";
				}
				Text += "\t\tconst " + Case.Result + " R = " + Case.Expression + ";\n";
				for (uint32_t c = 0; c < CountOf(Case.Result); ++c)
				{
					const bool bMatrix = Case.Result.find('x') != std::string::npos;
					const uint32_t Columns = uint32_t(Case.Result.back() - '0');
					const std::string Part =
						bMatrix ? "R[" + std::to_string(c / Columns) + "][" + std::to_string(c % Columns) + "]"
						: CountOf(Case.Result) > 1 ? "R[" + std::to_string(c) + "]"
												   : "R";
					const bool bReal = ScalarOf(Case.Result) == "float";
					Text += "\t\tOut[" + std::to_string(i * GConstantsWords + c) +
							"] = " + (bReal ? "asuint(" + Part + ")" : "uint(" + Part + ")") + ";\n";
				}
				Text += "\t}\n";
			}
		}
		std::vector<uint32_t> Results[2];
		for (const bool bRun : {false, true})
		{
			const std::string Text =
				"StructuredBuffer<uint> In;\nRWStructuredBuffer<uint> Out;\n[numthreads(1, 1, 1)]\nvoid "
				"MainCS()\n{\n\tOut[0] = In[0];\n" +
				Texts[bRun] + "}\n";
			const FSpirvModule Module = CompileConstants(Text);
			Results[bRun] = RunConstants(Module, Text, In, Cases.size() * GConstantsWords);
			NumInstructions[bRun] = CountArithmetic(Module);
		}
		for (size_t i = 0; i < Cases.size(); ++i)
		{
			const FConstantsCase& Case = Cases[i];
			for (uint32_t c = 0; c < CountOf(Case.Result); ++c)
			{
				const uint32_t Folded = Results[0][i * GConstantsWords + c];
				const uint32_t Run = Results[1][i * GConstantsWords + c];
				const auto IsNan = [&Case](uint32_t Word)
				{
					return ScalarOf(Case.Result) == "float" && (Word & 0x7FFFFFFF) > 0x7F800000;
				};
				EXPECT_TRUE(Folded == Run || (IsNan(Folded) && IsNan(Run)))
					<< Case.Type << " " << Case.Expression << " [" << c << "]: folded " << std::hex << Folded
					<< ", run " << Run << " of " << Literals[i * 48 + c] << " " << Literals[i * 48 + 16 + c] << " "
					<< Literals[i * 48 + 32 + c];
			}
		}
	}

	/** Instructions that compute. */
	static size_t CountArithmetic(const FSpirvModule& Module)
	{
		size_t Count = 0;
		for (const FSpirvBlock& Block : Module.Blocks)
		{
			for (const FSpirvInstruction& I : Block.Instructions)
			{
				Count += I.Op == Spirv::OpExtInst || (I.Op >= Spirv::OpConvertFToU && I.Op <= Spirv::OpBitCount);
			}
		}
		return Count;
	}

	size_t NumInstructions[2] = {};
};

std::vector<FConstantsCase> MakeConstantsCases(
	const std::vector<std::string>& Types, const std::vector<std::string>& Expressions, const std::string& Result = "")
{
	std::vector<FConstantsCase> Cases;
	for (const std::string& Type : Types)
	{
		for (const std::string& Expression : Expressions)
		{
			const std::string Size = Type.substr(ScalarOf(Type).size());
			Cases.push_back({Type,
				Result.empty()                                            ? Type
				: Result == "bool" || Result == "int" || Result == "uint" ? Result + Size
																		  : Result.substr(1),
				Expression});
		}
	}
	return Cases;
}

TEST_F(HlslConstantsRun, OperatorsAndFunctions)
{
	const std::vector<std::string> Floats = {"float", "float2", "float3", "float4", "float2x2", "float3x4"};
	const std::vector<std::string> Vectors = {"float2", "float3", "float4"};
	const std::vector<std::string> Integers = {"int", "uint", "int3", "uint4", "int2x2"};
	std::vector<FConstantsCase> Cases;
	const auto Add = [&Cases](const std::vector<FConstantsCase>& More)
	{
		Cases.insert(Cases.end(), More.begin(), More.end());
	};
	Add(MakeConstantsCases(
		Floats, {"A + B", "A - B", "A * B", "A / B", "A % B", "-A", "A * 2 + 1.5", "abs(A)", "floor(A)", "ceil(A)",
					"trunc(A)", "round(A)", "frac(A)", "sqrt(A)", "rsqrt(A)", "rcp(A)", "exp(A)", "exp2(A)", "log(A)",
					"log2(A)", "log10(A)", "sin(A)", "cos(A)", "tan(A)", "asin(A)", "acos(A)", "atan(A)", "sinh(A)",
					"cosh(A)", "tanh(A)", "degrees(A)", "radians(A)", "saturate(A)", "fmod(A, B)", "atan2(A, B)",
					"pow(A, B)", "step(A, B)", "min(A, B)", "max(A, B)", "ldexp(A, B)", "clamp(A, B, C)",
					"mad(A, B, C)", "lerp(A, B, C)", "smoothstep(A, B, C)", "select(A < B, A, C)"}));
	Add(MakeConstantsCases(Floats,
		{"A < B", "A > B", "A <= B", "A >= B", "A == B", "A != B", "isnan(A)", "isinf(A)", "isfinite(A)"}, "bool"));
	Add(MakeConstantsCases(Floats, {"int(1) * sign(A)", "A"}, "int"));
	Add(MakeConstantsCases(Floats, {"A", "asuint(A)", "f32tof16(A)"}, "uint"));
	Add(MakeConstantsCases(Vectors, {"normalize(A)", "reflect(A, B)", "refract(A, B, 0.7)", "faceforward(A, B, C)"}));
	Add(MakeConstantsCases(Vectors, {"dot(A, B)", "length(A)", "distance(A, B)"}, "=float"));
	Add(MakeConstantsCases({"float3"}, {"cross(A, B)"}));
	Add(MakeConstantsCases({"float4"}, {"dst(A, B)", "lit(A.x, B.y, C.z)"}));
	Add(MakeConstantsCases({"float2x2", "float3x3", "float4x4"}, {"mul(A, B)", "transpose(A)", "mul(A, 3)", "A * B"}));
	Add(MakeConstantsCases({"float2x2", "float3x3", "float4x4"}, {"determinant(A)", "dot(A[0], A[1])"}, "=float"));
	Add(MakeConstantsCases({"float3x3", "float2x3"}, {"mul(A, B[1])"}, "=float3"));
	Cases.back().Result = "float2";
	Add(MakeConstantsCases({"float3x3", "float3x2"}, {"mul(float3(1, -2, 0.3), A)"}, "=float3"));
	Cases.back().Result = "float2";
	Add(MakeConstantsCases({"float2x3"}, {"mul(A, float3x2(B))"}, "=float2x2"));
	Add(MakeConstantsCases(Integers,
		{"A + B", "A - B", "A * B", "A / (B | 1)", "A % (B | 1)", "-A", "~A", "A & B", "A | B", "A ^ B", "A << B",
			"A >> B", "abs(A)", "min(A, B)", "max(A, B)", "clamp(A, B, C)", "mad(A, B, C)", "reversebits(A)"}));
	Add(MakeConstantsCases(Integers, {"sign(A)"}, "int"));
	Add(MakeConstantsCases(Integers, {"countbits(A)", "firstbithigh(A)", "firstbitlow(A)"}, "uint"));
	Add(MakeConstantsCases(Integers, {"A < B", "A > B", "A <= B", "A >= B", "A == B", "A != B", "A"}, "bool"));
	Add(MakeConstantsCases({"uint", "uint3", "int", "int2"}, {"A", "A * 0.1"}, "=float"));
	for (size_t i = Cases.size() - 8; i < Cases.size(); ++i)
	{
		Cases[i].Result = "float" + Cases[i].Type.substr(ScalarOf(Cases[i].Type).size());
	}
	Add(MakeConstantsCases({"uint", "uint2"}, {"asint(A)", "A"}, "int"));
	Add(MakeConstantsCases({"int3", "int4"}, {"dot(A, B)"}, "=int"));
	Add(MakeConstantsCases({"int2x2"}, {"mul(A, B)", "transpose(A)"}));
	Add(MakeConstantsCases({"bool", "bool3"}, {"and(A, B)", "or(A, B)", "!A", "A == B", "A != B"}));
	Add(MakeConstantsCases({"bool3", "bool2x2"}, {"any(A)", "all(A)"}, "=bool"));
	Add(MakeConstantsCases({"bool3"}, {"A + B", "A * 3", "-A"}, "int"));
	Add(MakeConstantsCases({"bool3"}, {"A * 1.5"}, "=float3"));
	Add(MakeConstantsCases(
		{"float"}, {"float(half(A))", "float(double(A) * 1.0000001L + B)", "A < B || C > 0 ? A : B", "(A, B)"}));
	Add(MakeConstantsCases({"float"}, {"int(double(A) * 3.0L)", "int(int64_t(A))"}, "int"));
	Add(MakeConstantsCases(
		{"int"}, {"int(int64_t(A) * B >> 7)", "int(int64_t(A) / (int64_t(B) | 1))", "int(int16_t(A) * int16_t(B))",
					 "int(uint16_t(A) >> uint16_t(B & 15))", "int(uint64_t(A) % 1000ull)"}));
	Add(MakeConstantsCases({"float"}, {"float(float16_t(A) * float16_t(B))", "float(sqrt(float16_t(A)))",
										  "float(float16_t(A) / float16_t(B) + float16_t(C))"}));
	Add(MakeConstantsCases({"float"}, {"int(int16_t(A))", "int(uint16_t(A))", "int(int64_t(uint64_t(A)))"}, "int"));
	for (int Round = 0; Round < 3; ++Round)
	{
		Check(Cases);
	}
	EXPECT_EQ(NumInstructions[0], 0u) << "not everything is folded";
	EXPECT_GT(NumInstructions[1], Cases.size());
}

/** Random expressions of one type. */
std::string MakeConstantsText(std::mt19937& Random, const std::string& Type, int Depth)
{
	const bool bReal = ScalarOf(Type) == "float";
	const auto Next = [&]
	{
		return MakeConstantsText(Random, Type, Depth - 1);
	};
	if (Depth == 0)
	{
		return std::vector<std::string>{"A", "B", "C", "2", bReal ? "0.5" : "3", "A"}[Random() % 6];
	}
	switch (Random() % 7)
	{
	case 0:
		return "(" + Next() + " + " + Next() + ")";
	case 1:
		return "(" + Next() + " * " + Next() + ")";
	case 2:
		return "(" + Next() + " - " + Next() + ")";
	case 3:
		return "min(" + Next() + ", (" + Type + ")(" + Next() + "))";
	case 4:
		return bReal ? "frac(" + Next() + " * 0.25)" : "(" + Next() + " >> 3)";
	case 5:
		return "select(A < B, (" + Type + ")(" + Next() + "), (" + Type + ")(" + Next() + "))";
	default:
		return bReal ? "abs((" + Type + ")(" + Next() + ")) / 3" : "(" + Next() + " ^ 5)";
	}
}

TEST_F(HlslConstantsRun, RandomExpressions)
{
	for (int Round = 0; Round < 5; ++Round)
	{
		std::vector<FConstantsCase> Cases;
		for (int i = 0; i < 100; ++i)
		{
			const std::string Type = std::vector<std::string>{"float", "float3", "int", "uint", "int2"}[Random() % 5];
			Cases.push_back(
				{Type, Type, "(" + Type + ")(" + MakeConstantsText(Random, Type, 1 + int(Random() % 4)) + ")"});
		}
		Check(Cases);
	}
}

} // namespace
} // namespace Drydock::Hlsl::Tests
