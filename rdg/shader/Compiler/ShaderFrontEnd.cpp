// Has drydock's own front end read the text, or the compiler that DRYDOCK_HLSL_COMPILER names.
#include "ShaderFrontEnd.h"

#include "HlslCompiler.h"
#include "HlslFrontEnd.h"
#include "RegularFile.h"
#include "SpirvFile.h"
#include "SpirvOps.h"
#include "TemporaryFolder.h"
#include "TextTools.h"
#include "TimeLimit.h"
#include "ToolFault.h"

#include <atomic>
#include <cstring>

namespace Drydock
{

namespace
{

std::atomic<int64_t> GNumCompiledTexts{0};

constexpr int DefaultCompilerSeconds = 60;
constexpr size_t MaxOwnWords = 2000; // of a compiler's output, in a message

/** The error of a compiler that failed without a message about the shader: what it wrote is shown. */
FError ExplainFailure(
	const FHlslCompiler& Compiler, const FChildResult& Child, const FShaderCompileRequest& Request, int Seconds)
{
	const std::string OnWhat = " on '" + Request.EntryPoint + "'";
	const bool bCrashed = Child.bStarted && !Child.bTimedOut && Child.Signal && !IsSignalFromOutside(Child.Signal);
	if (const std::string Fault = bCrashed ? std::string() : FindToolFault(Child); !Fault.empty())
	{
		return FError(
			{ESeverity::Error, 6032, Compiler.GetName() + " " + Fault + OnWhat, Request.VirtualPath, 0, 0, {}},
			ExitFiles);
	}
	FTemporaryFolder().CheckSpace();
	const std::string Words = Trim(Child.Output).substr(0, MaxOwnWords);
	return FError({ESeverity::Error, 6012,
					  Compiler.GetName() + " " + Child.Describe(Seconds) + OnWhat +
						  (Words.empty() ? " and wrote nothing" : "; its words:\n" + Words),
					  Request.VirtualPath, 0, 0, {}},
		ExitUsage);
}

/** Whether these are the words of a whole module: one that was cut short does not end with the end of a function. */
bool IsWhole(const std::vector<uint32_t>& Words)
{
	size_t At = Spirv::HeaderWords;
	uint32_t Last = 0;
	while (At < Words.size() && Words[At] >> 16)
	{
		Last = Words[At] & 0xffff;
		At += Words[At] >> 16;
	}
	return At == Words.size() && Last == Spirv::OpFunctionEnd;
}

/** Compiles in a child that writes a file. */
std::vector<uint32_t> RunCompiler(
	const FHlslCompiler& Compiler, const std::string& Text, const FShaderCompileRequest& Request)
{
	const int Seconds = GetTimeLimitSeconds("DRYDOCK_HLSL_COMPILER_SECONDS", DefaultCompilerSeconds);
	const FTemporaryFolder Folder;
	const std::string Output = Folder.Reserve("shader.spv");
	const std::string Input = Folder.WriteFile("shader.hlsl", WriteForCompiler(Text, Request));
	const FChildResult Child =
		RunChild(MakeHlslCompilerArguments(Compiler, Request, Input, Output), Seconds, MakeToolEnvironment(Folder));
	if (std::vector<FDiagnostic> Errors = ParseCompilerMessages(Child.Output, Request); !Errors.empty())
	{
		throw FError(std::move(Errors), ExitUsage);
	}
	if (!Child.Succeeded())
	{
		throw ExplainFailure(Compiler, Child, Request, Seconds);
	}
	const FFileBytes Read = ReadRegularFile(Output);
	if (!Read.Bytes)
	{
		throw FError({ESeverity::Error, 6012,
						 Compiler.GetName() + " has written nothing that can be read for '" + Request.EntryPoint +
							 "': " + Read.Problem,
						 Request.VirtualPath, 0, 0, {}},
			ExitUsage);
	}
	std::vector<uint32_t> Words(Read.Bytes->size() / 4);
	if (!Words.empty()) // memcpy takes no null pointer, not even for nothing
	{
		std::memcpy(Words.data(), Read.Bytes->data(), Words.size() * 4);
	}
	if (!IsWhole(Words))
	{
		Folder.CheckSpace(); // a compiler may not look whether all was written
	}
	return Words;
}

} // namespace

std::vector<uint32_t> CompileToSpirv(const FShaderSource& Source, const FShaderCompileRequest& Request)
{
	const auto Ready = [&Request](std::vector<uint32_t> Words)
	{
		return Request.bKeepFunctions ? Words : InlineSpirvCalls(std::move(Words));
	};
	if (IsSpirvFile(Request.VirtualPath))
	{
		return Ready(GetSpirvWords(Source.Text));
	}
	++GNumCompiledTexts;
	const std::optional<FHlslCompiler> Compiler = FindHlslCompiler(Request);
	return Compiler ? Ready(RunCompiler(*Compiler, Source.Text, Request)) : Hlsl::Compile(Source.Text, Request);
}

int64_t GetNumCompiledTexts()
{
	return GNumCompiledTexts;
}

} // namespace Drydock
