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

#include "FrontEndIntegers.h"
#include "FrontEndProtocol.h"
#include "ShaderReflection.h"

#include <algorithm>
#include <iterator>
#include <sys/resource.h>
#include <unistd.h>

namespace
{

using namespace Drydock;
using namespace Drydock::FrontEnd;

constexpr rlim_t MemoryLimit = rlim_t(4) << 30; // bytes
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

/** The optimiser drops loops without an effect, those without an end too. So each header gets an effect that it knows
 * nothing of, an instruction that no pixel or compute shader has; without bMark that is taken away again. */
void MarkLoops(std::vector<unsigned int>& Words, bool bMark)
{
	constexpr unsigned int Mark = 1u << spv::WordCountShift | spv::OpEmitVertex;
	std::vector<unsigned int> Result(Words.begin(), Words.begin() + GModuleHeaderWords);
	ForEachInstruction(Words,
		[&](unsigned int Op, size_t First, unsigned int Count)
		{
			if (bMark && Op == spv::OpLoopMerge)
			{
				Result.push_back(Mark);
			}
			if (Words[First] != Mark)
			{
				Result.insert(Result.end(), Words.data() + First, Words.data() + First + Count);
			}
		});
	Words = std::move(Result);
}

/** By the passes that glslang has for HLSL, each operation of floats rounded as it stands: `x * 3 * 5` does not become
 * `x * 15`, so that the program with its functions gives the same bits. Nothing is folded in a module that declares how
 * it rounds. Source: SPIRV-Tools, Instruction::IsFloatingPointFoldingAllowed. */
void Optimise(const glslang::TIntermediate& Intermediate, std::vector<unsigned int>& Words, spv::SpvBuildLogger& Logger,
	const glslang::SpvOptions& Options)
{
	CorrectIntegers(Words);
	MarkLoops(Words, true);
	const unsigned int Capability[] = {2u << spv::WordCountShift | spv::OpCapability, spv::CapabilityRoundingModeRTE};
	Words.insert(Words.begin() + GModuleHeaderWords, std::begin(Capability), std::end(Capability));
	glslang::SpirvToolsTransform(Intermediate, Words, &Logger, &Options);
	// Only here: that is what the optimiser shall keep to, and nothing that a driver need be able to do.
	const auto Found = std::search(Words.begin(), Words.end(), std::begin(Capability), std::end(Capability));
	if (Found != Words.end())
	{
		Words.erase(Found, Found + std::ssize(Capability));
	}
	MarkLoops(Words, false);
	RestoreDivisions(Words);
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
