// Random programs over numbers of 16, 32 and 64 bits, in branches, loops and functions: the compiled kernel and the
// interpreter, also of the program with its functions, agree bit for bit.
#include <gtest/gtest.h>

#include "RandomPrograms.h"

#include <random>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

constexpr int32_t NumThreads = 40; // no multiple of 16

struct FKind
{
	const char* Name;
	bool bReal;
};

constexpr FKind Kinds[] = {{"float16_t", true}, {"int16_t", false}, {"uint16_t", false}, {"double", true},
	{"int64_t", false}, {"uint64_t", false}, {"float", true}, {"int", false}};
constexpr uint32_t NumKinds = uint32_t(std::size(Kinds));

/** Three variables of each kind in an array, and a function of each kind. */
class FWideProgram
{
public:
	explicit FWideProgram(uint32_t Seed)
		: Random(Seed)
	{
	}

	std::string Make()
	{
		std::string Text = "StructuredBuffer<float> In;\nstruct FAll\n{\n";
		for (uint32_t t = 0; t < NumKinds; ++t)
		{
			Text += std::string("\t") + Kinds[t].Name + " m" + std::to_string(t) + ";\n";
		}
		Text += "};\nRWStructuredBuffer<FAll> Out;\n";
		for (uint32_t t = 0; t < NumKinds; ++t)
		{
			Text += Function(t);
		}
		Text += "[numthreads(8, 1, 1)]\nvoid MainCS(uint3 Id : SV_DispatchThreadID)\n{\n";
		for (uint32_t t = 0; t < NumKinds; ++t)
		{
			const std::string Type = Kinds[t].Name;
			Text += "\t" + Type + " v" + std::to_string(t) + "[3] = {" + Type + "(In[Id.x * 2]), " + Type +
					"(int(In[Id.x * 2 + 1])), " + Type + "(" + std::to_string(Choose(100)) + ")};\n";
		}
		for (int i = 0; i < 20; ++i)
		{
			Text += Statement(1);
		}
		Text += "\tFAll All;\n";
		for (uint32_t t = 0; t < NumKinds; ++t)
		{
			// Which NaN an operation gives is nobody's promise.
			const std::string Of = "v" + std::to_string(t) + "[Id.x % 3]";
			Text += "\tAll.m" + std::to_string(t) + " = " +
					(Kinds[t].bReal ? Of + " == " + Of + " ? " + Of + " : " + Kinds[t].Name + "(-77)" : Of) + ";\n";
		}
		return Text + "\tOut[Id.x] = All;\n}\n";
	}

private:
	uint32_t Choose(uint32_t Limit) { return uint32_t(Random() % Limit); }
	static std::string Tabs(int Depth) { return std::string(size_t(Depth), '\t'); }
	std::string Operator(uint32_t Kind)
	{
		static constexpr const char* Reals[] = {" + ", " - ", " * ", " / "};
		static constexpr const char* Integers[] = {
			" + ", " - ", " * ", " / ", " % ", " << ", " >> ", " & ", " | ", " ^ "};
		return Kinds[Kind].bReal ? Reals[Choose(4)] : Integers[Choose(10)];
	}
	std::string Function(uint32_t Kind)
	{
		const std::string Type = Kinds[Kind].Name;
		return Type + " F" + std::to_string(Kind) + "(" + Type + " A, " + Type +
			   " B)\n{\n\tif (A < B)\n\t{\n\t\treturn A" + Operator(Kind) + "B;\n\t}\n\treturn B" + Operator(Kind) +
			   Type + "(" + std::to_string(1 + Choose(9)) + ")" + Operator(Kind) + "A;\n}\n";
	}
	std::string Variable(uint32_t Kind) { return "v" + std::to_string(Kind) + "[" + std::to_string(Choose(3)) + "]"; }
	std::string Value(uint32_t Kind)
	{
		const std::string Pair = "(" + Variable(Kind) + ", " + Variable(Kind) + ")";
		switch (Choose(7))
		{
		case 0:
			return (Choose(2) ? "min" : "max") + Pair;
		case 1:
			return "F" + std::to_string(Kind) + Pair;
		case 2:
		case 3:
			return std::string(Kinds[Kind].Name) + "(" + Variable(Choose(NumKinds)) + ")";
		default:
			return Variable(Kind) + Operator(Kind) + Variable(Kind);
		}
	}
	std::string Block(int Depth)
	{
		std::string Text = Tabs(Depth) + "{\n";
		for (uint32_t i = 0; i < 1 + Choose(3); ++i)
		{
			Text += Statement(Depth + 1);
		}
		return Text + Tabs(Depth) + "}\n";
	}
	std::string Statement(int Depth)
	{
		const std::string Tab = Tabs(Depth);
		const uint32_t Compared = Choose(NumKinds);
		switch (Choose(Depth < 3 ? 6 : 4))
		{
		case 4:
			return Tab + "if (" + Variable(Compared) + " < " + Variable(Compared) + ")\n" + Block(Depth) +
				   (Choose(2) ? Tab + "else\n" + Block(Depth) : std::string());
		case 5:
		{
			const std::string Counter = "k" + std::to_string(NumCounters++);
			return Tab + "for (uint " + Counter + " = 0; " + Counter + " < (Id.x & 3u); ++" + Counter + ")\n" +
				   Block(Depth);
		}
		default:
		{
			const uint32_t Kind = Choose(NumKinds);
			return Tab + Variable(Kind) + " = " + Value(Kind) + ";\n";
		}
		}
	}

	std::mt19937 Random;
	uint32_t NumCounters = 0;
};

void Fill(FShaderHarness& Harness, uint32_t Seed)
{
	std::mt19937 Random(Seed);
	std::vector<float> In;
	for (int32_t i = 0; i < 2 * NumThreads; ++i)
	{
		In.push_back(float(int32_t(Random() % 2000) - 1000) * (i % 5 == 0 ? 1000.0f : 0.07f));
	}
	Harness.SetFloatBuffer("In", In);
	constexpr size_t WordsOfAll = 12;
	Harness.Buffers["Out"].assign(WordsOfAll * NumThreads, 0);
}

std::string FindDifference(FShaderHarness& A, FShaderHarness& B)
{
	const std::vector<uint32_t>& First = A.Buffers["Out"];
	const std::vector<uint32_t>& Second = B.Buffers["Out"];
	for (size_t i = 0; i < First.size(); ++i)
	{
		if (First[i] != Second[i])
		{
			return "word " + std::to_string(i) + ": " + std::to_string(First[i]) + " and " + std::to_string(Second[i]);
		}
	}
	return {};
}

} // namespace

class FRandomWide : public testing::TestWithParam<int>
{
};

TEST_P(FRandomWide, KernelsAgreeWithTheModelBitForBit)
{
	const uint32_t Seed = uint32_t(GetParam());
	ExpectFormsAgree(
		Seed, FWideProgram(Seed).Make(), EShaderStage::Compute, NumThreads, 1,
		[Seed](FShaderHarness& Harness) { Fill(Harness, Seed); }, &FindDifference);
}

INSTANTIATE_TEST_SUITE_P(Seeds, FRandomWide, RandomSeeds(10));
