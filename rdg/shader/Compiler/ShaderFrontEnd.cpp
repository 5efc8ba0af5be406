// Asks glslang, or runs glslangValidator (written for the options of version 12) or the compiler that
// DRYDOCK_HLSL_COMPILER names, and reads the messages.
#include "ShaderFrontEnd.h"

#include "FrontEndCrash.h"
#include "FrontEndProcess.h"
#include "HlslCompiler.h"
#include "HlslFrontEnd.h"
#include "HlslTokens.h"
#include "InstallPaths.h"
#include "RegularFile.h"
#include "SpirvFile.h"
#include "SpirvOps.h"
#include "TemporaryFolder.h"
#include "TextTools.h"
#include "TimeLimit.h"
#include "ToolFault.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <sstream>

namespace Drydock
{

namespace
{

constexpr int DefaultFrontEndSeconds = 60;

/** "/X.usf:12: text" or "/X.usf(12): text" -> file, line and text; false when there is no such head. */
bool SplitPosition(const std::string& Text, std::string& File, int& Line, std::string& Rest)
{
	for (size_t i = 1; i + 1 < Text.size(); ++i)
	{
		if ((Text[i] != ':' && Text[i] != '(') || !IsDigit(Text[i + 1]))
		{
			continue;
		}
		char* End = nullptr;
		const long Number = std::strtol(Text.c_str() + i + 1, &End, 10);
		const char* const Close = Text[i] == ':' ? ": " : "): ";
		if (std::strncmp(End, Close, std::strlen(Close)) == 0)
		{
			File = Text.substr(0, i);
			Line = int(Number);
			Rest = End + std::strlen(Close);
			return true;
		}
	}
	return false;
}

/** Explains a message in the author's words where glslang's do not. */
std::string Explain(const std::string& Message, const FShaderCompileRequest& Request)
{
	// 'View_Foo' : unknown variable  ->  the uniform buffer's member as it was written
	if (Message[0] == '\'' && Message.find("unknown variable") != std::string::npos)
	{
		const std::string Name = Message.substr(1, Message.find('\'', 1) - 1);
		for (const auto& [Buffer, Members, Declaration] : Request.UniformBuffers)
		{
			if (Name.starts_with(Buffer + "_"))
			{
				const std::string Member = Name.substr(Buffer.size() + 1);
				return "uniform buffer '" + Buffer + "' has no member '" + Member + "'" + SuggestName(Member, Members);
			}
		}
	}
	if (Message.find("partial image updates") != std::string::npos)
	{
		return Message + "; write the whole texel (Out[p] = float4(...)) instead of one component";
	}
	return Message;
}

/** "    F(i1; calling G(i1;" -> "'F' calls 'G'"; empty for other lines. */
std::string ExplainCall(const std::string& Text)
{
	const size_t Calling = Text.find(" calling ");
	if (Calling == std::string::npos)
	{
		return {};
	}
	const auto NameOf = [](const std::string& Mangled)
	{
		std::string Name(1, '\'');
		Name.append(Mangled, 0, Mangled.find('('));
		return Name + "'";
	};
	return NameOf(Text.substr(0, Calling)) + " calls " + NameOf(Text.substr(Calling + 9));
}

} // namespace

std::vector<FDiagnostic> ParseFrontEndMessages(const std::string& Output, const FShaderCompileRequest& Request)
{
	std::vector<FDiagnostic> Errors;
	std::istringstream Lines(Output);
	std::string Text;
	bool bEntryPointMissing = false;
	bool bRecursion = false; // the calls are listed on the lines that follow
	while (std::getline(Lines, Text))
	{
		Text = Trim(Text);
		if (const std::string Call = bRecursion ? ExplainCall(Text) : std::string(); !Call.empty())
		{
			Errors.back().Message += (Errors.back().Message.back() == ':' ? " " : ", ") + Call;
			continue;
		}
		bRecursion = Text.find("Recursion detected:") != std::string::npos;
		if (bRecursion)
		{
			Errors.push_back({ESeverity::Error, 6010,
				"functions of HLSL cannot call themselves, not even through others; write a loop. Here:",
				Request.VirtualPath, 0, 0, {}});
			continue;
		}
		bEntryPointMissing = bEntryPointMissing || Text.find("Entry point not found") != std::string::npos;
		const bool bError = Text.starts_with("ERROR: ");
		std::string File;
		std::string Message;
		int Line = 0;
		const bool bPositioned = SplitPosition(bError ? Text.substr(7) : Text, File, Line, Message);
		const bool bSummary =
			!bError && bPositioned && Message.starts_with("error at column "); // the parser's last words
		const bool bSameLine = !Errors.empty() && Errors.back().File == File && Errors.back().Line == Line;
		if (bSummary && !bSameLine)
		{
			Errors.push_back({ESeverity::Error, 6010, "syntax error", File, Line, 0, {}});
		}
		else if (bError && bPositioned)
		{
			// After the first fault of a line the parser also lists every rule it was in.
			const bool bConsequence =
				bSameLine && (Message.find(" : Expected") != std::string::npos || Errors.back().Message == Message);
			if (!bConsequence)
			{
				Errors.push_back({ESeverity::Error, 6010, Explain(Trim(Message), Request), File, Line, 0, {}});
			}
		}
		else if (bError && Text.find("compilation errors") == std::string::npos)
		{
			Errors.push_back({ESeverity::Error, 6010, Trim(Text.substr(7)), Request.VirtualPath, 0, 0, {}});
		}
	}
	if (Errors.empty() && bEntryPointMissing)
	{
		Errors.push_back({ESeverity::Error, 6011,
			"entry point '" + Request.EntryPoint + "' does not exist in this shader", Request.VirtualPath, 0, 0, {}});
	}
	return Errors;
}

namespace
{

/** Compiles in a child of its own that writes a file. */
FFrontEndReply RunCompiler(
	const FHlslCompiler& Compiler, const std::string& Text, const FShaderCompileRequest& Request, int TimeLimitSeconds)
{
	const FTemporaryFolder Folder;
	const std::string Output = Folder.Reserve("shader.spv");
	const std::vector<std::string> Arguments =
		MakeHlslCompilerArguments(Compiler, Request, Folder.WriteFile("shader.hlsl", Text), Output);
	FFrontEndReply Reply;
	Reply.Child = RunChild(Arguments, TimeLimitSeconds, MakeToolEnvironment(Folder));
	const FFileBytes Read = ReadRegularFile(Output);
	if (!Read.Bytes && Reply.Child.Succeeded())
	{
		throw FError({ESeverity::Error, 6012,
						 Compiler.GetName() + " has written nothing that can be read for '" + Request.EntryPoint +
							 "': " + Read.Problem,
						 Request.VirtualPath, 0, 0, {}},
			ExitUsage);
	}
	const std::string Bytes = Read.Bytes.value_or("");
	Reply.Words.resize(Bytes.size() / 4);
	if (!Reply.Words.empty()) // memcpy takes no null pointer, not even for nothing
	{
		std::memcpy(Reply.Words.data(), Bytes.data(), Reply.Words.size() * 4);
	}
	return Reply;
}

/** The front end that is there, and its time. */
class FFrontEnd
{
public:
	/** Throws FError DD6012 where there is none. */
	explicit FFrontEnd(const FShaderCompileRequest& InRequest)
		: Request(InRequest)
	{
		if (const std::optional<FHlslCompiler> Own = FindHlslCompiler(Request))
		{
			Compiler = *Own;
			return;
		}
		const char* const Chosen = GetChosenGlslang();
		bKept = !Chosen;
		Compiler.Program = bKept ? FindFrontEndProgram() : FindProgram(Chosen);
		if (Compiler.Program.empty())
		{
			// No other glslang takes its place: it rounds sums of constants otherwise, and the cache would keep them.
			const std::string Missing =
				bKept ? "libexec/drydock/drydock_front_end is not beside " + GetLibraryPath() +
							"; build or install drydock again"
					  : std::string("there is no program '") + Chosen + "', which DRYDOCK_GLSLANG names";
			throw FError({ESeverity::Error, 6012, "cannot compile '" + Request.EntryPoint + "': " + Missing,
							 Request.VirtualPath, 0, 0, {}},
				bKept ? ExitFiles : ExitUsage);
		}
	}

	FFrontEndReply Run(const std::string& Text) const
	{
		return bKept ? AskFrontEnd(Compiler.Program, Text, Request, TimeLimitSeconds)
					 : RunCompiler(Compiler, Text, Request, TimeLimitSeconds);
	}
	std::vector<FDiagnostic> ParseMessages(const std::string& Output) const
	{
		return Compiler.Kind == EHlslCompiler::Glslang ? ParseFrontEndMessages(Output, Request)
													   : ParseCompilerMessages(Output, Request);
	}
	std::string GetName() const
	{
		return bKept ? "glslang" : Compiler.Kind == EHlslCompiler::Glslang ? "glslangValidator" : Compiler.GetName();
	}

	const FShaderCompileRequest& Request;
	const int TimeLimitSeconds = GetTimeLimitSeconds("DRYDOCK_GLSLANG_SECONDS", DefaultFrontEndSeconds);

private:
	FHlslCompiler Compiler;
	bool bKept = false; // a process of ours that is kept, not a child for every shader
};

/** The error of a front end that failed without a message about the shader. */
FError ExplainFailure(const FFrontEnd& FrontEnd, const FChildResult& Child, const FShaderSource& Source)
{
	const FShaderCompileRequest& Request = FrontEnd.Request;
	const std::string Name = FrontEnd.GetName() + " ";
	const std::string OnWhat = " on '" + Request.EntryPoint + "'";
	const bool bCrashed = Child.bStarted && !Child.bTimedOut && Child.Signal && !IsSignalFromOutside(Child.Signal);
	const std::string Fault = bCrashed ? std::string() : FindToolFault(Child);
	if (!Fault.empty())
	{
		return FError({ESeverity::Error, 6032, Name + Fault + OnWhat, Request.VirtualPath, 0, 0, {}}, ExitFiles);
	}
	FTemporaryFolder().CheckSpace();
	FCrashPlace Place{Request.VirtualPath, 0, {}};
	if (bCrashed)
	{
		Place = FindCrashPlace(Source.Text, Request,
			[&](const std::string& Text) { return FrontEnd.Run(Text).Child.Signal == Child.Signal; });
	}
	return FError({ESeverity::Error, 6012, Name + Child.Describe(FrontEnd.TimeLimitSeconds) + OnWhat + Place.When,
					  Place.File, Place.Line, 0, {}},
		ExitUsage);
}

/** Some messages of glslang about types stand on line 0: the line is that up to which the text gives them. */
void FindLines(const FFrontEnd& FrontEnd, const FShaderSource& Source, std::vector<FDiagnostic>& Errors)
{
	for (FDiagnostic& Error : Errors)
	{
		if (Error.Code == 6010 && Error.Line == 0 && Error.File != FrontEnd.Request.VirtualPath)
		{
			const auto IsSame = [&](const FDiagnostic& Other)
			{
				return Other.Line == 0 && Other.Message == Error.Message;
			};
			const FCrashPlace Place = FindCrashPlace(Source.Text, FrontEnd.Request,
				[&](const std::string& Text)
				{
					const std::vector<FDiagnostic> Others = FrontEnd.ParseMessages(FrontEnd.Run(Text).Child.Output);
					return std::any_of(Others.begin(), Others.end(), IsSame);
				});
			Error.File = Place.File;
			Error.Line = Place.Line;
			return; // those behind it follow from it
		}
	}
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

/** Whether the group of each entry has three numbers: glslang leaves one that is negative out. */
bool AreGroupsWhole(const std::vector<uint32_t>& Words)
{
	constexpr uint32_t LocalSize = 17;
	for (size_t At = Spirv::HeaderWords; At + 2 < Words.size() && Words[At] >> 16; At += Words[At] >> 16)
	{
		if ((Words[At] & 0xffff) == Spirv::OpExecutionMode && Words[At + 2] == LocalSize && Words[At] >> 16 != 6)
		{
			return false;
		}
	}
	return true;
}

/** A compute shader's entry whose [numthreads] is missing: glslang takes 1, 1, 1 for it. */
std::optional<FDiagnostic> FindMissingGroupSize(const std::string& Text, const FShaderCompileRequest& Request)
{
	const FHlslText Tokens(Text, Request.VirtualPath);
	std::optional<FDiagnostic> Missing;
	for (size_t Name = 1; Name < Tokens.Size(); ++Name)
	{
		if (!Tokens.Is(Name, Request.EntryPoint.c_str()) || !Tokens.Is(Name + 1, "(") || !Tokens.IsWord(Name - 1))
		{
			Name = std::max(Name, Tokens.FindClose(Name));
			continue;
		}
		for (size_t At = Name; At > 0 && !Tokens.Is(At - 1, "}") && !Tokens.Is(At - 1, ";"); --At)
		{
			if (Tokens.Is(At - 1, "numthreads"))
			{
				return std::nullopt;
			}
		}
		Missing = Tokens.MakeError(Name,
			"the compute shader '" + Request.EntryPoint + "' has no [numthreads(X, Y, Z)] before it: its group's size");
	}
	return Missing;
}

} // namespace

std::vector<uint32_t> CompileToSpirv(const FShaderSource& Source, const FShaderCompileRequest& Request)
{
	if (IsSpirvFile(Request.VirtualPath))
	{
		return GetSpirvWords(Source.Text);
	}
	if (UsesOwnFrontEnd())
	{
		return Hlsl::Compile(Source.Text, Request);
	}
	const FFrontEnd FrontEnd(Request);
	FFrontEndReply Reply = FrontEnd.Run(Source.Text);
	std::vector<FDiagnostic> Errors = FrontEnd.ParseMessages(Reply.Child.Output);
	if (Errors.empty() && !Reply.Child.Succeeded())
	{
		throw ExplainFailure(FrontEnd, Reply.Child, Source);
	}
	if (!Errors.empty())
	{
		FindLines(FrontEnd, Source, Errors);
		throw FError(std::move(Errors), ExitUsage);
	}
	if (const auto Missing =
			Request.Stage == EShaderStage::Compute ? FindMissingGroupSize(Source.Text, Request) : std::nullopt)
	{
		throw FError(*Missing, ExitUsage);
	}
	if (!IsWhole(Reply.Words))
	{
		FTemporaryFolder().CheckSpace(); // glslangValidator does not look whether all was written
	}
	if (!AreGroupsWhole(Reply.Words))
	{
		throw FError(
			{ESeverity::Error, 6010,
				"[numthreads] of '" + Request.EntryPoint + "' has a negative number; wanted are three from 1 on",
				Request.VirtualPath, 0, 0, {}},
			ExitUsage);
	}
	return std::move(Reply.Words);
}

} // namespace Drydock
