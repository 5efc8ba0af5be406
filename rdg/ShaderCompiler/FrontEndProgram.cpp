// The program that glslang runs in: reads requests from its standard input, which is a socket, until that is closed.
// Does what glslangValidator does with the options of ShaderFrontEnd.cpp, but that the optimiser leaves arithmetic of
// floats as it is written; glslang's tables are made once for all shaders.
#ifndef ENABLE_OPT
#define ENABLE_OPT 1 // else SpvTools.h declares nothing
#endif
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <glslang/SPIRV/SpvTools.h>
#include <glslang/SPIRV/spirv.hpp>

#include "FrontEndProtocol.h"
#include "ShaderReflection.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <sys/resource.h>
#include <unistd.h>

namespace
{

using namespace Drydock;
using namespace Drydock::FrontEnd;

constexpr rlim_t MemoryLimit = rlim_t(4) << 30; // bytes
constexpr std::ptrdiff_t HeaderWords = 5;
constexpr size_t BoundWord = 3;                 // of the header: above all ids
constexpr const char* FileName = "shader.hlsl"; // of text above the first #line; there is none

struct FResult
{
	std::string Output;
	std::vector<unsigned int> Words;
};

EShLanguage GetStage(uint32_t Stage)
{
	return EShaderStage(Stage) == EShaderStage::Pixel    ? EShLangFragment
		   : EShaderStage(Stage) == EShaderStage::Vertex ? EShLangVertex
														 : EShLangCompute;
}

/** A name that is not one of these costs a newer SPIR-V at worst. */
bool UsesWaves(const std::string& Text)
{
	for (const char* Name :
		{"WaveActive", "WaveAll", "WaveAny", "WaveGet", "WaveIs", "WavePrefix", "WaveRead", "QuadRead"})
	{
		if (Text.find(Name) != std::string::npos)
		{
			return true;
		}
	}
	return false;
}

void AddLog(const char* Log, std::string& Output)
{
	if (*Log)
	{
		Output += Log;
		Output += '\n';
	}
}

/** Calls f(Op, First, Count) for each instruction: First its first word. */
template<typename F>
void ForEachInstruction(const std::vector<unsigned int>& Words, F f)
{
	for (size_t At = size_t(HeaderWords); At < Words.size() && Words[At] >> spv::WordCountShift != 0;
		 At += Words[At] >> spv::WordCountShift)
	{
		f(Words[At] & spv::OpCodeMask, At, Words[At] >> spv::WordCountShift);
	}
}

/** What is left over has the sign of the left side in HLSL (`-7 % 4` is -3). glslang writes OpSMod, whose results of
 * constants have that of the right. */
void CorrectRemainders(std::vector<unsigned int>& Words)
{
	ForEachInstruction(Words,
		[&Words](unsigned int Op, size_t First, unsigned int)
		{
			if (Op == spv::OpSMod)
			{
				Words[First] = (Words[First] & ~spv::OpCodeMask) | spv::OpSRem;
			}
		});
}

/** A shift by a number takes its low 5 bits (6, 4 for integers of 64 and 16 bits) in HLSL. The optimiser makes 0 of
 * constants that are shifted by more: each count that is no constant below the width goes through an `&` with width
 * - 1. */
void CorrectShifts(std::vector<unsigned int>& Words)
{
	struct FType
	{
		unsigned int Width = 0;
		unsigned int Element = 0; // of a vector, else 0
		unsigned int Count = 1;
	};
	std::map<unsigned int, FType> Types;
	std::map<unsigned int, unsigned int> TypeOf;                         // of constants and of what functions compute
	std::map<unsigned int, unsigned int> Small;                          // constants of one word
	std::map<std::pair<unsigned int, unsigned int>, unsigned int> Masks; // by type and number
	std::vector<unsigned int> Constants;
	std::vector<unsigned int> Result(Words.begin(), Words.begin() + HeaderWords);
	size_t Functions = 0;
	unsigned int Bound = Words[BoundWord];
	const auto Add = [](std::vector<unsigned int>& To, unsigned int Op, std::initializer_list<unsigned int> Operands)
	{
		To.push_back(static_cast<unsigned int>(Operands.size() + 1) << spv::WordCountShift | Op);
		To.insert(To.end(), Operands);
	};
	const auto GetScalarMask = [&](unsigned int Type, unsigned int Number)
	{
		unsigned int& Id = Masks[{Type, Number}];
		if (Id == 0)
		{
			Id = Bound++;
			Types[Type].Width > 32 ? Add(Constants, spv::OpConstant, {Type, Id, Number, 0})
								   : Add(Constants, spv::OpConstant, {Type, Id, Number});
		}
		return Id;
	};
	const auto GetMask = [&](unsigned int Type, unsigned int Number)
	{
		const FType Known = Types[Type];
		if (Known.Element == 0)
		{
			return GetScalarMask(Type, Number);
		}
		const unsigned int Scalar = GetScalarMask(Known.Element, Number);
		unsigned int& Id = Masks[{Type, Number}];
		if (Id == 0)
		{
			Id = Bound++;
			Constants.push_back((3 + Known.Count) << spv::WordCountShift | spv::OpConstantComposite);
			Constants.insert(Constants.end(), {Type, Id});
			Constants.insert(Constants.end(), Known.Count, Scalar);
		}
		return Id;
	};
	ForEachInstruction(Words,
		[&](unsigned int Op, size_t First, unsigned int Count)
		{
			const unsigned int* const I = Words.data() + First;
			if (Op == spv::OpTypeInt)
			{
				Types[I[1]] = {I[2], 0, 1};
			}
			else if (Op == spv::OpTypeVector && Types.count(I[2]))
			{
				Types[I[1]] = {Types[I[2]].Width, I[2], I[3]};
			}
			else if (Op == spv::OpFunction && Functions == 0)
			{
				Functions = Result.size();
			}
			if (Count > 2 && Types.count(I[1]))
			{
				TypeOf[I[2]] = I[1];
			}
			if (Op == spv::OpConstant && Count == 4)
			{
				Small[I[2]] = I[3];
			}
			const bool bShift =
				Op == spv::OpShiftLeftLogical || Op == spv::OpShiftRightLogical || Op == spv::OpShiftRightArithmetic;
			const auto By = bShift ? TypeOf.find(I[4]) : TypeOf.end();
			const auto Known = bShift ? Small.find(I[4]) : Small.end();
			const unsigned int Width = bShift && Types.count(I[1]) ? Types[I[1]].Width : 0;
			if (Width == 0 || By == TypeOf.end() || (Known != Small.end() && Known->second < Width))
			{
				Result.insert(Result.end(), I, I + Count);
				return;
			}
			const unsigned int Mask = GetMask(By->second, Width - 1);
			const unsigned int Id = Bound++;
			Add(Result, spv::OpBitwiseAnd, {By->second, Id, I[4], Mask});
			Add(Result, Op, {I[1], I[2], I[3], Id});
		});
	Result.insert(Result.begin() + std::ptrdiff_t(Functions), Constants.begin(), Constants.end());
	Result[BoundWord] = Bound;
	Words = std::move(Result);
}

/** By the passes that glslang has for HLSL, each operation of floats rounded as it stands: `x * 3 * 5` is no `x * 15`,
 * so that the program with its functions gives the same bits. Nothing is folded in a module that says how it rounds.
 * Source: SPIRV-Tools, Instruction::IsFloatingPointFoldingAllowed. */
void Optimise(const glslang::TIntermediate& Intermediate, std::vector<unsigned int>& Words, spv::SpvBuildLogger& Logger,
	const glslang::SpvOptions& Options)
{
	CorrectRemainders(Words);
	CorrectShifts(Words);
	const unsigned int Capability[] = {2u << spv::WordCountShift | spv::OpCapability, spv::CapabilityRoundingModeRTE};
	Words.insert(Words.begin() + HeaderWords, std::begin(Capability), std::end(Capability));
	glslang::SpirvToolsTransform(Intermediate, Words, &Logger, &Options);
	// Only here: that is what the optimiser shall keep to, and nothing that a driver need be able to do.
	const auto Found = std::search(Words.begin(), Words.end(), std::begin(Capability), std::end(Capability));
	if (Found != Words.end())
	{
		Words.erase(Found, Found + std::ssize(Capability));
	}
}

FResult Compile(const FRequestHead& Head, const std::string& Entry, const std::string& Text)
{
	FResult Result;
	const EShLanguage Stage = GetStage(Head.Stage);
	EShMessages Messages =
		EShMessages(EShMsgSpvRules | EShMsgVulkanRules | EShMsgReadHlsl | EShMsgHlslOffsets | EShMsgDebugInfo);
	if (Head.bKeepFunctions)
	{
		Messages = EShMessages(Messages | EShMsgHlslLegalization);
	}
	glslang::TShader Shader(Stage); // before the program, which must go first
	glslang::TProgram Program;
	const char* const TextStart = Text.data();
	const int TextSize = int(Text.size());
	Shader.setStringsWithLengthsAndNames(&TextStart, &TextSize, &FileName, 1);
	Shader.setEntryPoint(Entry.c_str());
	Shader.setAutoMapBindings(true);
	Shader.setAutoMapLocations(true);
	Shader.setNanMinMaxClamp(true); // min, max and clamp by D3D's NaN rules
	Shader.setEnvInput(glslang::EShSourceHlsl, Stage, glslang::EShClientVulkan, 100);
	const bool bWaves = UsesWaves(Text); // SPIR-V 1.0 has none, and the optimiser refuses what is not of its version
	Shader.setEnvClient(glslang::EShClientVulkan, bWaves ? glslang::EShTargetVulkan_1_1 : glslang::EShTargetVulkan_1_0);
	Shader.setEnvTarget(glslang::EShTargetSpv, bWaves ? glslang::EShTargetSpv_1_3 : glslang::EShTargetSpv_1_0);
	Shader.setEnvTargetHlslFunctionality1(); // semantics of inputs are kept
	constexpr int DefaultVersion = 100;
	bool bGood = Shader.parse(GetDefaultResources(), DefaultVersion, false, Messages);
	AddLog(FileName, Result.Output);
	AddLog(Shader.getInfoLog(), Result.Output);
	AddLog(Shader.getInfoDebugLog(), Result.Output);
	Program.addShader(&Shader);
	bGood = Program.link(Messages) && bGood;
	bGood = Program.mapIO() && bGood;
	AddLog(Program.getInfoLog(), Result.Output);
	AddLog(Program.getInfoDebugLog(), Result.Output);
	const glslang::TIntermediate* const Intermediate = bGood ? Program.getIntermediate(Stage) : nullptr;
	if (Intermediate)
	{
		spv::SpvBuildLogger Logger;
		glslang::SpvOptions Options;
		Options.generateDebugInfo = true;
		Options.disableOptimizer = true;
		glslang::GlslangToSpv(*Intermediate, Result.Words, &Logger, &Options);
		if (!Head.bKeepFunctions && !Result.Words.empty())
		{
			Optimise(*Intermediate, Result.Words, Logger, Options);
		}
		Result.Output += Logger.getAllMessages();
	}
	return Result;
}

/** False at the end of the input. */
bool Receive(void* Bytes, size_t Size)
{
	for (size_t Done = 0; Done < Size;)
	{
		const ssize_t Count = read(STDIN_FILENO, static_cast<char*>(Bytes) + Done, Size - Done);
		if (Count == 0 || (Count < 0 && errno != EINTR))
		{
			return false;
		}
		Done += Count > 0 ? size_t(Count) : 0;
	}
	return true;
}

} // namespace

int main()
{
	const rlimit Limit{MemoryLimit, MemoryLimit};
	setrlimit(RLIMIT_DATA, &Limit);
	glslang::InitializeProcess();
	FRequestHead Head;
	while (Receive(&Head, sizeof(Head)))
	{
		std::string Entry(Head.EntrySize, '\0');
		std::string Text(Head.TextSize, '\0');
		if (!Receive(Entry.data(), Entry.size()) || !Receive(Text.data(), Text.size()))
		{
			break;
		}
		alarm(Head.Seconds + 1);
		const FResult Result = Compile(Head, Entry, Text);
		alarm(0);
		const FReplyHead Reply = {!Result.Words.empty(), uint32_t(Result.Output.size()), uint32_t(Result.Words.size())};
		if (!Send(STDIN_FILENO, &Reply, sizeof(Reply)) ||
			!Send(STDIN_FILENO, Result.Output.data(), Result.Output.size()) ||
			!Send(STDIN_FILENO, Result.Words.data(), Result.Words.size() * sizeof(uint32_t)))
		{
			break;
		}
	}
	_exit(0); // the tables need no taking apart
}
