// Random programs: the compiled kernel and the interpreter, also of the program with its functions, agree bit for bit.
#include <gtest/gtest.h>

#include "ProgramGenerator.h"
#include "RandomPrograms.h"

#include <random>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

constexpr int32_t Width = 37; // no multiple of any lane count
constexpr int32_t Height = 3;

void FillInputs(FShaderHarness& Harness, uint32_t Seed, int NumFunctions)
{
	std::mt19937 Random(Seed);
	std::uniform_real_distribution<float> Values(-4.0f, 4.0f);
	const auto Floats = [&](size_t Count)
	{
		std::vector<float> Result(Count);
		for (float& Value : Result)
		{
			Value = Values(Random);
		}
		return Result;
	};
	const size_t Threads = size_t(Width) * Height;
	Harness.SetFloatBuffer("Data", Floats(Threads * 4));
	Harness.Buffers["OutFloat"].assign(Threads * size_t(NumFunctions) * 4, 0);
	Harness.Buffers["OutInt"].assign(Threads * size_t(NumFunctions), 0);
	Harness.Buffers["Log"].assign(Threads * size_t(NumFunctions), 0);
	Harness.Constants["UniformInt"] = {uint32_t(Random() % 5)};
	Harness.Constants["Width"] = {uint32_t(Width)};
	Harness.SetFloats("UniformFloat", Floats(1));
	Harness.SetFloats("Table", Floats(32));
	Harness.SetFloats("Matrix", Floats(16));
}

/** Name of the first function and thread that differ, empty when none does. */
std::string FindDifference(FShaderHarness& A, FShaderHarness& B, int NumFunctions)
{
	for (size_t Slot = 0; Slot < A.Buffers["OutInt"].size(); ++Slot)
	{
		bool bSame =
			A.Buffers["OutInt"][Slot] == B.Buffers["OutInt"][Slot] && A.Buffers["Log"][Slot] == B.Buffers["Log"][Slot];
		for (size_t c = 0; c < 4; ++c)
		{
			bSame =
				bSame && SameFloat(A.BufferFloat("OutFloat", Slot * 4 + c), B.BufferFloat("OutFloat", Slot * 4 + c));
		}
		if (!bSame)
		{
			const size_t Thread = Slot / size_t(NumFunctions);
			return "Function" + std::to_string(Slot % size_t(NumFunctions)) + " at (" + std::to_string(Thread % Width) +
				   ", " + std::to_string(Thread / Width) + ")";
		}
	}
	return {};
}

} // namespace

class FRandomProgram : public testing::TestWithParam<int>
{
};

TEST_P(FRandomProgram, KernelsAgreeWithTheModelBitForBit)
{
	constexpr int NumFunctions = 3;
	const uint32_t Seed = uint32_t(GetParam());
	ExpectFormsAgree(
		Seed, FProgramGenerator(Seed).Make(NumFunctions), EShaderStage::Compute, Width, Height,
		[&](FShaderHarness& Harness) { FillInputs(Harness, Seed, NumFunctions); },
		[](FShaderHarness& A, FShaderHarness& B) { return FindDifference(A, B, NumFunctions); });
}

INSTANTIATE_TEST_SUITE_P(Seeds, FRandomProgram, RandomSeeds(35));
