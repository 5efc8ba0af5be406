// Inlines calls and makes values of variables, by SPIRV-Tools. Arithmetic that SPIRV-Tools would compute by rules of
// its own is hidden from it.
#include "HlslEmitter.h"

#include "HlslModule.h"

#include <spirv-tools/optimizer.hpp>

#include <algorithm>
#include <map>
#include <utility>

namespace Drydock::Hlsl
{

using namespace Spirv;

namespace
{

constexpr uint32_t OptimiseMark = 218; // OpEmitVertex, which no shader here has
constexpr uint32_t OptimiseWaveVersion = 0x10300;

// The optimiser takes a minute for what is beyond them. The largest shipped shaders have 3,000 and 100.
constexpr uint64_t OptimiseMaxInstructions = 400000;
constexpr uint64_t OptimiseMaxBlocks = 16384;

// Divisions as operations that the optimiser computes nothing of and that HLSL has no word for: OpIAddCarry and the
// three behind it.
constexpr std::pair<uint16_t, uint16_t> OptimiseHidden[] = {
	{OpSDiv, 149},
	{OpUDiv, 150},
	{OpSRem, 151},
	{OpUMod, 152},
};

/** Calls f(First, Count) for each instruction. */
template<typename F>
void ForEachOptimised(const FWords& Words, F f)
{
	for (size_t At = HeaderWords; At < Words.size() && Words[At] >> 16 != 0; At += Words[At] >> 16)
	{
		f(At, Words[At] >> 16);
	}
}

/** How many instructions and blocks there are once each call has the function's own in its place. */
struct FOptimiseSize
{
	uint64_t NumInstructions = 0;
	uint64_t NumBlocks = 0;
	std::vector<uint32_t> Calls;

	bool IsTooLarge() const { return NumInstructions > OptimiseMaxInstructions || NumBlocks > OptimiseMaxBlocks; }
};

void AddOptimiseCalls(std::map<uint32_t, FOptimiseSize>& Functions, uint32_t Id)
{
	FOptimiseSize& Size = Functions[Id];
	for (const uint32_t Callee : std::exchange(Size.Calls, {}))
	{
		AddOptimiseCalls(Functions, Callee);
		Size.NumInstructions = std::min(Size.NumInstructions + Functions[Callee].NumInstructions, UINT64_MAX / 2);
		Size.NumBlocks = std::min(Size.NumBlocks + Functions[Callee].NumBlocks, UINT64_MAX / 2);
	}
}

FOptimiseSize MeasureInlined(const FWords& Words)
{
	std::map<uint32_t, FOptimiseSize> Functions;
	uint32_t Current = 0;
	uint32_t Entry = 0;
	ForEachOptimised(Words,
		[&](size_t First, uint32_t)
		{
			const uint16_t Opcode = uint16_t(Words[First]);
			Entry = Opcode == OpEntryPoint ? Words[First + 2] : Entry;
			Current = Opcode == OpFunction ? Words[First + 2] : Current;
			FOptimiseSize& Size = Functions[Current];
			++Size.NumInstructions;
			Size.NumBlocks += Opcode == OpLabel ? 1 : 0;
			if (Opcode == OpFunctionCall)
			{
				Size.Calls.push_back(Words[First + 3]);
			}
		});
	AddOptimiseCalls(Functions, Entry);
	return Functions[Entry];
}

/** The optimiser drops loops without an effect, those without an end too: each header gets an effect. It makes 0 of
 * what is divided by 0, ends by a signal at the least number divided by -1, and makes x / -2 of -(x / 2), which is
 * wrong for uint: divisions of integers are hidden, but for remainders of safe constants. */
FWords HideFromOptimiser(const FWords& Words)
{
	FWords Result(Words.begin(), Words.begin() + HeaderWords);
	AddWords(Result, OpCapability, {CapabilityRoundingModeRTE}); // nothing of floats is folded in such a module
	std::map<uint32_t, uint32_t> Numbers;
	ForEachOptimised(Words,
		[&](size_t First, uint32_t Count)
		{
			const uint16_t Opcode = uint16_t(Words[First]);
			if (Opcode == OpConstant && Count == 4)
			{
				Numbers[Words[First + 2]] = Words[First + 3];
			}
			if (Opcode == OpLoopMerge)
			{
				Result.push_back(1u << 16 | OptimiseMark);
			}
			Result.insert(Result.end(), Words.begin() + ptrdiff_t(First), Words.begin() + ptrdiff_t(First + Count));
			const auto Hidden = std::ranges::find(OptimiseHidden, Opcode, [](const auto& Pair) { return Pair.first; });
			if (Hidden != std::end(OptimiseHidden))
			{
				const auto Divisor = Numbers.find(Words[First + 4]);
				const bool bRemainder = Opcode == OpSRem || Opcode == OpUMod;
				const bool bSafe =
					bRemainder && Divisor != Numbers.end() && Divisor->second != 0 && Divisor->second != ~0u;
				Result[Result.size() - Count] = Count << 16 | (bSafe ? Opcode : Hidden->second);
			}
		});
	return Result;
}

FWords ShowAgain(const FWords& Words)
{
	FWords Result(Words.begin(), Words.begin() + HeaderWords);
	ForEachOptimised(Words,
		[&](size_t First, uint32_t Count)
		{
			const uint16_t Opcode = uint16_t(Words[First]);
			if (Opcode == OptimiseMark || (Opcode == OpCapability && Words[First + 1] == CapabilityRoundingModeRTE))
			{
				return;
			}
			Result.insert(Result.end(), Words.begin() + ptrdiff_t(First), Words.begin() + ptrdiff_t(First + Count));
			const auto Hidden = std::ranges::find(OptimiseHidden, Opcode, [](const auto& Pair) { return Pair.second; });
			if (Hidden != std::end(OptimiseHidden))
			{
				Result[Result.size() - Count] = Count << 16 | Hidden->first;
			}
		});
	return Result;
}

void RegisterOptimiserPasses(spvtools::Optimizer& Optimizer)
{
	Optimizer.RegisterPass(spvtools::CreateWrapOpKillPass())
		.RegisterPass(spvtools::CreateMergeReturnPass())
		.RegisterPass(spvtools::CreateInlineExhaustivePass())
		.RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
		.RegisterPass(spvtools::CreateScalarReplacementPass())
		.RegisterPass(spvtools::CreateLocalAccessChainConvertPass())
		.RegisterPass(spvtools::CreateLocalSingleBlockLoadStoreElimPass())
		.RegisterPass(spvtools::CreateLocalSingleStoreElimPass())
		.RegisterPass(spvtools::CreateSimplificationPass())
		.RegisterPass(spvtools::CreateAggressiveDCEPass())
		.RegisterPass(spvtools::CreateVectorDCEPass())
		.RegisterPass(spvtools::CreateDeadBranchElimPass())
		.RegisterPass(spvtools::CreateBlockMergePass())
		.RegisterPass(spvtools::CreateLocalMultiStoreElimPass())
		.RegisterPass(spvtools::CreateIfConversionPass())
		.RegisterPass(spvtools::CreateSimplificationPass())
		.RegisterPass(spvtools::CreateAggressiveDCEPass())
		.RegisterPass(spvtools::CreateVectorDCEPass())
		.RegisterPass(spvtools::CreateCFGCleanupPass());
}

} // namespace

std::vector<uint32_t> Optimise(const std::vector<uint32_t>& Words, std::string& Error)
{
	const FOptimiseSize Size = MeasureInlined(Words);
	if (Size.IsTooLarge())
	{
		Error = "the shader is too large: once its calls are inlined it has " + std::to_string(Size.NumInstructions) +
				" instructions in " + std::to_string(Size.NumBlocks) + " branches. It may have " +
				std::to_string(OptimiseMaxInstructions) + " in " + std::to_string(OptimiseMaxBlocks) +
				"; write a loop in place of repeated code, or call less";
		return {};
	}
	const bool bWaves = Words.at(1) >= OptimiseWaveVersion;
	spvtools::Optimizer Optimizer(bWaves ? SPV_ENV_VULKAN_1_1 : SPV_ENV_VULKAN_1_0);
	Optimizer.SetMessageConsumer(
		[&Error](spv_message_level_t Level, const char*, const spv_position_t&, const char* Message)
		{
			if (Level <= SPV_MSG_ERROR)
			{
				Error += Error.empty() ? Message : std::string("; ") + Message;
			}
		});
	RegisterOptimiserPasses(Optimizer);
	spvtools::OptimizerOptions Options;
	Options.set_run_validator(false);
	const FWords Hidden = HideFromOptimiser(Words);
	FWords Result;
	if (!Optimizer.Run(Hidden.data(), Hidden.size(), &Result, Options))
	{
		Error = "the optimiser of the shader failed: " + (Error.empty() ? "it gave no result" : Error);
		return {};
	}
	Error.clear();
	return ShowAgain(Result);
}

} // namespace Drydock::Hlsl
