// What it takes from the text of a shipped shader to SPIR-V: drydock's front end, and glslang's in the same process
// where this was built beside it (package glslang-dev). Prints milliseconds of CPU time for a tonemap permutation and
// for the longest text, medians of rounds in which each is compiled once.
//
//     bench_front_end [ROUNDS]
#ifdef DRYDOCK_BENCH_GLSLANG // before the engine's macros
#define ENABLE_OPT 1         // else SpvTools.h declares nothing
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#endif

#include "HlslFrontEnd.h"
#include "ShaderCompilation.h"
#include "ShaderSource.h"
#include "TextTools.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <map>

namespace Drydock::Bench
{
namespace
{

struct FSubject
{
	std::string Name;
	FShaderCompileRequest Request;
	std::string Text;
};

/** The last permutation of the tonemapper, and the longest text of all last permutations. */
std::vector<FSubject> ChooseSubjects()
{
	std::map<std::string, FSubject> Chosen;
	ForEachShaderType(
		[&](const FShaderType& Type)
		{
			int32 Last = Type.GetPermutationCount() - 1;
			while (Last >= 0 && !Type.ShouldCompilePermutation(Last))
			{
				--Last;
			}
			if (Last < 0)
			{
				return;
			}
			const FShaderCompileRequest Request =
				MakeShaderCompileRequest(FShaderRef(Type.FindOrCreateShader(Last)), Type.GetRootParametersMetadata());
			FSubject Subject{Type.GetName(), Request, FlattenShader(Request).Text};
			FSubject& Longest = Chosen["longest"];
			if (Subject.Text.size() > Longest.Text.size())
			{
				Longest = Subject;
			}
			if (Subject.Name == "FTonemapPS")
			{
				Chosen["tonemap"] = Subject;
			}
		});
	std::vector<FSubject> Subjects;
	for (auto& [Key, Subject] : Chosen)
	{
		Subjects.push_back(std::move(Subject));
	}
	return Subjects;
}

double MeasureMs(const std::function<void()>& Work)
{
	const std::clock_t Begin = std::clock();
	Work();
	return double(std::clock() - Begin) * 1e3 / CLOCKS_PER_SEC;
}

double GetMedian(std::vector<double> Values)
{
	std::sort(Values.begin(), Values.end());
	return Values[Values.size() / 2];
}

#ifdef DRYDOCK_BENCH_GLSLANG
/** What glslang's HLSL lacks of HLSL 2021, in its own words; members of uniform buffers by their other names. */
std::string WriteForGlslang(const FSubject& Subject)
{
	std::string Text = Subject.Text;
	for (const FShaderUniformBuffer& Buffer : Subject.Request.UniformBuffers)
	{
		for (const std::string& Member : Buffer.Members)
		{
			const std::string Name = Buffer.Name + "." + Member;
			for (size_t At = Text.find(Name); At != std::string::npos; At = Text.find(Name, At + 1))
			{
				Text[At + Buffer.Name.size()] = '_';
			}
		}
	}
	for (const char* const Name : {"select", "and", "or"})
	{
		for (size_t At = Text.find(Name + std::string("(")); At != std::string::npos;
			 At = Text.find(Name + std::string("("), At + 1))
		{
			const bool bWord = At == 0 || !IsWordCharacter(Text[At - 1]);
			Text[At] = bWord ? char(Text[At] - 'a' + 'A') : Text[At];
		}
	}
	std::string Functions;
	for (const char* const Type : {"float", "float2", "float3", "float4"})
	{
		const std::string Bool = "bool" + std::string(Type + 5);
		Functions += std::string(Type) + " Select(" + Bool + " C, " + Type + " A, " + Type +
					 " B) { return C ? A : B; }\n" + Bool + " And(" + Bool + " A, " + Bool +
					 " B) { return A && B; }\n" + Bool + " Or(" + Bool + " A, " + Bool + " B) { return A || B; }\n";
	}
	return Functions + Text;
}

void CompileByGlslang(const std::string& Text, const FShaderCompileRequest& Request)
{
	const EShLanguage Stage = Request.Stage == EShaderStage::Pixel    ? EShLangFragment
							  : Request.Stage == EShaderStage::Vertex ? EShLangVertex
																	  : EShLangCompute;
	const auto Messages =
		EShMessages(EShMsgSpvRules | EShMsgVulkanRules | EShMsgReadHlsl | EShMsgHlslOffsets | EShMsgDebugInfo);
	glslang::TShader Shader(Stage); // before the program, which must go first
	glslang::TProgram Program;
	const char* const Start = Text.c_str();
	Shader.setStrings(&Start, 1);
	Shader.setEntryPoint(Request.EntryPoint.c_str());
	Shader.setAutoMapBindings(true);
	Shader.setAutoMapLocations(true);
	Shader.setEnvInput(glslang::EShSourceHlsl, Stage, glslang::EShClientVulkan, 100);
	Shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
	Shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
	Shader.setEnvTargetHlslFunctionality1();
	constexpr int DefaultVersion = 100;
	bool bGood = Shader.parse(GetDefaultResources(), DefaultVersion, false, Messages);
	Program.addShader(&Shader);
	bGood = bGood && Program.link(Messages) && Program.mapIO();
	if (!bGood)
	{
		std::fprintf(stderr, "glslang: %s\n", Shader.getInfoLog());
		std::exit(1);
	}
	std::vector<unsigned int> Words;
	spv::SpvBuildLogger Logger;
	glslang::SpvOptions Options;
	Options.generateDebugInfo = true;
	Options.disableOptimizer = false;
	glslang::GlslangToSpv(*Program.getIntermediate(Stage), Words, &Logger, &Options);
}
#endif

void Run(int Rounds)
{
#ifdef DRYDOCK_BENCH_GLSLANG
	glslang::InitializeProcess();
#endif
	std::printf(
		"| shader | text kB | drydock ms | without the optimiser | glslang ms | ratio |\n|---|--:|--:|--:|--:|--:|\n");
	for (const FSubject& Subject : ChooseSubjects())
	{
		FShaderCompileRequest Kept = Subject.Request;
		Kept.bKeepFunctions = true;
		std::vector<double> Times[3];
		for (int Round = 0; Round < Rounds; ++Round)
		{
			Times[0].push_back(MeasureMs([&] { Hlsl::Compile(Subject.Text, Subject.Request); }));
			Times[1].push_back(MeasureMs([&] { Hlsl::Compile(Subject.Text, Kept); }));
#ifdef DRYDOCK_BENCH_GLSLANG
			const std::string Text = WriteForGlslang(Subject);
			Times[2].push_back(MeasureMs([&] { CompileByGlslang(Text, Subject.Request); }));
#endif
		}
		const double Own = GetMedian(Times[0]);
		const double Other = Times[2].empty() ? 0 : GetMedian(Times[2]);
		std::printf("| %s | %.0f | %.2f | %.2f | %.2f | %.2f |\n", Subject.Name.c_str(),
			double(Subject.Text.size()) / 1e3, Own, GetMedian(Times[1]), Other, Other > 0 ? Own / Other : 0);
	}
}

} // namespace
} // namespace Drydock::Bench

int main(int NumArguments, char** Arguments)
{
	Drydock::Bench::Run(NumArguments > 1 ? std::max(1, std::atoi(Arguments[1])) : 25);
	return 0;
}
