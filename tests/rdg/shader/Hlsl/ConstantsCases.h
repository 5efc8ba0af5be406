// Expressions twice: of constants, which the front end folds, and of values from a buffer, which the interpreter
// computes.
#pragma once

#include "RunText.h"
#include "SpirvOps.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

namespace Drydock::Hlsl::Tests
{

/** An expression of A, B and C, of one type each, that gives Result. */
struct FConstantsCase
{
	std::string Type;
	std::string Result;
	std::string Expression;
};

inline constexpr size_t GConstantsWords = 16; // of one operand and of one result

inline uint32_t CountOf(const std::string& Type)
{
	const char Last = Type.back();
	const bool bMatrix = Type.size() > 2 && Type[Type.size() - 2] == 'x';
	return bMatrix ? uint32_t(Type[Type.size() - 3] - '0') * uint32_t(Last - '0')
				   : (Last >= '1' && Last <= '4' && Type != "float16_t" ? uint32_t(Last - '0') : 1);
}

inline std::string ScalarOf(const std::string& Type)
{
	return Type.substr(0, Type.find_first_of("1234"));
}

/** The operand out of the words from First on: of a scalar type of 32 bits. */
inline std::string Operand(const std::string& Type, const std::vector<std::string>& Words, size_t First)
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
			const FSpirvModule Module = CompileText(Text);
			Results[bRun] = RunModule(Module, Text, In, Cases.size() * GConstantsWords);
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

} // namespace Drydock::Hlsl::Tests
