// Random programs whose threads work together: barriers in loops and conditions, groupshared memory, atomics, waves.
// The compiled kernel, the interpreter, and the interpreter of the program with its functions agree bit for bit.
#include <gtest/gtest.h>

#include "RandomPrograms.h"

#include <random>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

constexpr int32_t NumGroups = 3;

/** Threads touch groupshared memory between barriers only, each its own element: there are no races. */
class FGroupProgram
{
public:
	explicit FGroupProgram(uint32_t Seed)
		: Random(Seed)
	{
		static constexpr int32_t Sizes[][3] = {{64, 1, 1}, {8, 6, 1}, {5, 3, 2}, {40, 1, 1}, {1, 1, 1}};
		std::copy_n(Sizes[Choose(5)], 3, Size);
		bBarriersInFlow = Choose(2);
		Commuting = Operations[Choose(5)];
	}

	std::string Make()
	{
		const std::string Helper = "uint Mix(uint A, uint B)\n{\n\tif (A % 5 == 2)\n\t{\n\t\treturn B * 3 + " +
								   Number(100) + ";\n\t}\n\treturn A ^ (B << " + Number(9) + ");\n}\n";
		std::string Body;
		for (uint32_t i = 0; i < 6; ++i)
		{
			Body += Statement(1, true);
		}
		const std::string Threads = std::to_string(Count());
		return "StructuredBuffer<uint> In;\nRWStructuredBuffer<uint> Out;\nRWStructuredBuffer<uint> Sums;\n"
			   "groupshared uint Shared[" +
			   Threads + "];\ngroupshared uint Bins[16];\n" + Helper + "[numthreads(" + std::to_string(Size[0]) + ", " +
			   std::to_string(Size[1]) + ", " + std::to_string(Size[2]) +
			   ")]\nvoid MainCS(uint3 Id : SV_DispatchThreadID, uint3 Local : SV_GroupThreadID, uint3 G : SV_GroupID, "
			   "uint I "
			   ": SV_GroupIndex)\n{\n\tuint Old = 0;\n\tconst uint Place = G.x * " +
			   Threads + " + I;\n\tuint V[3] = {In[Place], Local.x * 7 + Local.y, Local.z + G.x};\n" + Body +
			   "\tOut[Place] = V[0] ^ V[1] * 3 ^ V[2] * 7;\n\tGroupMemoryBarrierWithGroupSync();\n\tif (I < 16)\n\t{\n"
			   "\t\tSums[G.x * 16 + I] = Bins[I];\n\t}\n}\n";
	}

	int32_t Count() const { return Size[0] * Size[1] * Size[2]; }
	const int32_t* GetSize() const { return Size; }

private:
	uint32_t Choose(uint32_t Limit) { return uint32_t(Random() % Limit); }
	std::string Number(uint32_t Limit) { return std::to_string(1 + Choose(Limit)) + "u"; }
	std::string Value() { return "V[" + std::to_string(Choose(3)) + "]"; }
	std::string Expression()
	{
		const char* const Operators[] = {" + ", " ^ ", " * ", " - ", " & ", " | "};
		switch (Choose(4))
		{
		case 0:
			return "Mix(" + Value() + ", " + Value() + ")";
		case 1:
			return "min(" + Value() + ", " + Value() + " >> " + Number(7) + ")";
		default:
			return Value() + Operators[Choose(6)] + (Choose(2) ? Number(50) : Value());
		}
	}
	std::string Block(int Depth, bool bUniform)
	{
		std::string Text = Tabs(Depth) + "{\n";
		for (uint32_t i = 0; i < 1 + Choose(3); ++i)
		{
			Text += Statement(Depth + 1, bUniform);
		}
		return Text + Tabs(Depth) + "}\n";
	}
	static std::string Tabs(int Depth) { return std::string(size_t(Depth), '\t'); }

	/** bUniform: all threads of the group come here. */
	std::string Statement(int Depth, bool bUniform)
	{
		const std::string Tab = Tabs(Depth);
		const std::string Counter = "k" + std::to_string(NumCounters++);
		const bool bNest = Depth < 4;
		switch (Choose(9))
		{
		case 0:
			if (bUniform && (Depth == 1 || bBarriersInFlow))
			{
				return Tab + "GroupMemoryBarrierWithGroupSync();\n" + Tab + "Shared[I] = " + Value() + ";\n" + Tab +
					   "GroupMemoryBarrierWithGroupSync();\n" + Tab + Value() + " += Shared[(I * " + Number(11) +
					   " + " + Number(60) + ") % " + std::to_string(Count()) + "];\n";
			}
			break;
		case 1:
			if (bNest)
			{
				const std::string Turns = bUniform && Choose(2) ? Number(3) : Value() + " % 4";
				const bool bSame = Turns.back() == 'u';
				return Tab + "for (uint " + Counter + " = 0; " + Counter + " < " + Turns + "; ++" + Counter + ")\n" +
					   Block(Depth, bUniform && bSame);
			}
			break;
		case 2:
			if (bNest)
			{
				const bool bSame = bUniform && Choose(2);
				const std::string Condition = bSame ? "(G.x & 1) == 0" : "(" + Value() + " & 3) != 0";
				return Tab + "if (" + Condition + ")\n" + Block(Depth, bSame) +
					   (Choose(2) ? Tab + "else\n" + Block(Depth, bSame) : std::string());
			}
			break;
		case 3:
		{
			const std::string Operation = bBarriersInFlow ? Commuting : Operations[Choose(5)];
			const std::string Head = Tab + "Interlocked" + Operation + "(Bins[" + Value() + " % 16], " + Value();
			return bBarriersInFlow || Choose(2) ? Head + ");\n" : Head + ", Old);\n" + Tab + Value() + " ^= Old;\n";
		}
		case 4:
		{
			const std::string Calls[] = {"WaveActiveSum(" + Value() + ")", "WavePrefixSum(" + Value() + ")",
				"WaveActiveMax(" + Value() + ")", "WaveReadLaneFirst(" + Value() + ")",
				"WaveReadLaneAt(" + Value() + ", " + Value() + " % 32)",
				"WaveActiveBallot((" + Value() + " & 1) != 0).x", "WavePrefixCountBits((" + Value() + " & 2) != 0)",
				"uint(WaveIsFirstLane())", "QuadReadAcrossX(" + Value() + ")"};
			return Tab + Value() + " += " + Calls[Choose(9)] + ";\n";
		}
		default:
			break;
		}
		return Tab + Value() + " = " + Expression() + ";\n";
	}

	static constexpr const char* Operations[] = {"Add", "Max", "Xor", "Or", "Min"};

	std::mt19937 Random;
	int32_t Size[3];
	/** Barriers in loops and conditions; then atomics are of one kind, and nobody looks at what was there before: only
	 * so their order around such barriers is the same however the program is run (docs/shaders.md). */
	bool bBarriersInFlow = false;
	std::string Commuting;
	uint32_t NumCounters = 0;
};

void Fill(FShaderHarness& Harness, uint32_t Seed, int32_t NumThreads)
{
	std::mt19937 Random(Seed);
	std::vector<uint32_t> In(size_t(NumThreads) * NumGroups);
	for (uint32_t& Number : In)
	{
		Number = uint32_t(Random());
	}
	Harness.Buffers["In"] = std::move(In);
	Harness.Buffers["Out"].assign(size_t(NumThreads) * NumGroups, 0);
	Harness.Buffers["Sums"].assign(16 * NumGroups, 0);
}

} // namespace

class FRandomGroups : public testing::TestWithParam<int>
{
};

TEST_P(FRandomGroups, KernelsAgreeWithTheModelBitForBit)
{
	const uint32_t Seed = uint32_t(GetParam());
	const FRandomForm Form(Seed);
	FGroupProgram Program(Seed);
	const std::string Text = Program.Make();
	SCOPED_TRACE(Text);
	const int32_t X = Program.GetSize()[0] * NumGroups;
	const int32_t Y = Program.GetSize()[1];
	const int32_t Z = Program.GetSize()[2];
	FShaderHarness Model(Text, "MainCS", EShaderStage::Compute);
	Fill(Model, Seed, Program.Count());
	Model.RunModel(X, Y, Z);
	const auto Compare = [&](FShaderHarness& Other, const std::string& Name)
	{
		EXPECT_EQ(Model.Buffers["Out"], Other.Buffers["Out"]) << "seed " << Seed << ", " << Name;
		EXPECT_EQ(Model.Buffers["Sums"], Other.Buffers["Sums"]) << "seed " << Seed << ", " << Name;
	};
	FShaderHarness Kernel(Text, "MainCS", EShaderStage::Compute);
	Fill(Kernel, Seed, Program.Count());
	Kernel.Run(Form.Lanes, X, Y, Z, Form.bDouble);
	Compare(Kernel, Form.GetName());
	FShaderHarness Inspected(Text, "MainCS", EShaderStage::Compute);
	Fill(Inspected, Seed, Program.Count());
	Inspected.RunInspected(X, Y, Z);
	Compare(Inspected, "with its functions");
}

INSTANTIATE_TEST_SUITE_P(Seeds, FRandomGroups, RandomSeeds(30));
