// Calls dxc and slangc. Source of the options: their own lists (dxc -help, slangc -h).
#include "HlslCompiler.h"

#include "HlslTokens.h"
#include "KernelCompiler.h"
#include "SpirvFile.h"
#include "TextTools.h"

#include <algorithm>
#include <cstdlib>

namespace Drydock
{

namespace
{

/** The program that a variable of the environment names; null where it names none. */
const char* GetChosenProgram(const char* Name)
{
	const char* const Text = std::getenv(Name);
	return Text && *Text ? Text : nullptr;
}

const char* Choose(EShaderStage Stage, const char* Compute, const char* Pixel, const char* Vertex)
{
	return Stage == EShaderStage::Pixel ? Pixel : Stage == EShaderStage::Vertex ? Vertex : Compute;
}

/** "/X.usf:3:14" or "/X.usf(3,14)" or with the line alone -> file, line and column. */
bool SplitPlace(const std::string& Text, FDiagnostic& Place)
{
	std::string Head = Text;
	const bool bParenthesis = !Head.empty() && Head.back() == ')';
	if (bParenthesis)
	{
		Head.pop_back();
	}
	int Numbers[2] = {0, 0};
	int NumNumbers = 0;
	while (NumNumbers < 2)
	{
		const size_t Digits = Head.find_last_not_of("0123456789");
		const bool bNumber = Digits != std::string::npos && Digits + 1 < Head.size() &&
							 (Head[Digits] == ':' || Head[Digits] == '(' || Head[Digits] == ',');
		if (!bNumber)
		{
			break;
		}
		Numbers[NumNumbers++] = std::atoi(Head.c_str() + Digits + 1);
		Head.resize(Digits);
	}
	Place.File = Head;
	Place.Line = NumNumbers == 2 ? Numbers[1] : Numbers[0];
	Place.Column = NumNumbers == 2 ? Numbers[0] : 0;
	return NumNumbers > 0 && !Head.empty();
}

} // namespace

std::optional<FHlslCompiler> FindHlslCompiler(const FShaderCompileRequest& Request)
{
	const char* const Chosen = GetChosenProgram("DRYDOCK_HLSL_COMPILER");
	if (!Chosen)
	{
		return {};
	}
	const auto Fail = [&](const std::string& Message)
	{
		return FError(
			{ESeverity::Error, 6012, "DRYDOCK_HLSL_COMPILER: " + Message, Request.VirtualPath, 0, 0, {}}, ExitUsage);
	};
	FHlslCompiler Compiler{FindProgram(Chosen), EHlslCompiler::Dxc};
	if (Compiler.Program.empty())
	{
		throw Fail(std::string("there is no program '") + Chosen + "'");
	}
	const std::string Name = Compiler.GetName();
	if (Name.starts_with("slangc"))
	{
		Compiler.Kind = EHlslCompiler::Slang;
	}
	else if (!Name.starts_with("dxc"))
	{
		throw Fail("'" + Name + "' is not known; a program is called as its name begins: dxc or slangc");
	}
	return Compiler;
}

std::string GetHlslCompilerId(const FShaderCompileRequest& Request)
{
	if (IsSpirvFile(Request.VirtualPath))
	{
		return {};
	}
	const std::optional<FHlslCompiler> Compiler = FindHlslCompiler(Request);
	return Compiler ? GetCompilerId(Compiler->Program) : std::string();
}

std::string WriteForCompiler(const std::string& Text, const FShaderCompileRequest& Request)
{
	FHlslText Read(Text, Request.VirtualPath);
	FHlslTokens Written;
	Written.reserve(Read.Size());
	for (size_t At = 0; At < Read.Size(); ++At)
	{
		const auto IsRead = [&](const FShaderUniformBuffer& Buffer)
		{
			return Read[At].Text == Buffer.Name &&
				   std::ranges::find(Buffer.Members, Read[At + 2].Text) != Buffer.Members.end();
		};
		const bool bPoint = Read.IsWord(At) && Read.Is(At + 1, ".") && Read.IsWord(At + 2);
		Written.push_back(Read[At]);
		if (bPoint && (At == 0 || !Read.Is(At - 1, ".")) && std::ranges::any_of(Request.UniformBuffers, IsRead))
		{
			Written.back().Text += "_" + Read[At + 2].Text;
			At += 2;
		}
	}
	Read.Tokens = std::move(Written);
	return Read.Join();
}

std::vector<std::string> MakeHlslCompilerArguments(const FHlslCompiler& Compiler, const FShaderCompileRequest& Request,
	const std::string& Input, const std::string& Output)
{
	const std::string& Entry = Request.EntryPoint;
	const EShaderStage Stage = Request.Stage;
	std::vector<std::string> Arguments;
	switch (Compiler.Kind)
	{
	case EHlslCompiler::Dxc:
		// Rows and D3D's packing, as the C++ structs lie; semantics and lines are kept; no more than Vulkan 1.0 has.
		Arguments = {Compiler.Program, "-spirv", "-T", Choose(Stage, "cs_6_0", "ps_6_0", "vs_6_0"), "-E", Entry, "-HV",
			"2021", "-Zpr", "-Zi", "-fvk-use-dx-layout", "-fspv-reflect", "-fspv-target-env=vulkan1.1", "-Fo", Output};
		break;
	case EHlslCompiler::Slang:
		Arguments = {Compiler.Program, "-target", "spirv", "-profile", "sm_6_0", "-stage",
			Choose(Stage, "compute", "fragment", "vertex"), "-entry", Entry, "-fvk-use-entrypoint-name",
			"-matrix-layout-row-major", "-fvk-use-dx-layout", "-g", "-o", Output};
		break;
	}
	if (Request.bKeepFunctions)
	{
		Arguments.push_back(Compiler.Kind == EHlslCompiler::Slang ? "-O0" : "-Od");
	}
	Arguments.push_back(Input);
	return Arguments;
}

std::vector<FDiagnostic> ParseCompilerMessages(const std::string& Output, const FShaderCompileRequest& Request)
{
	std::vector<FDiagnostic> Errors;
	for (const std::string& Text : SplitText(Output))
	{
		// "...: error: text", "...: fatal error: text", "...: error 30015: text"
		size_t Severity = Text.find(": error");
		Severity = Severity == std::string::npos ? Text.find(": fatal error") : Severity;
		const size_t Colon = Severity == std::string::npos ? Severity : Text.find(": ", Severity + 2);
		const bool bAlone = Text.starts_with("error: ") || Text.starts_with("fatal error: ");
		if (Colon == std::string::npos && !bAlone)
		{
			continue;
		}
		FDiagnostic Error{ESeverity::Error, 6010, {}, Request.VirtualPath, 0, 0, {}};
		Error.Message = Text.substr((bAlone ? Text.find(": ") : Colon) + 2);
		Error.Message.erase(Error.Message.find_last_not_of(" \t\r") + 1);
		FDiagnostic Place;
		if (!bAlone && SplitPlace(Text.substr(0, Severity), Place))
		{
			Error.File = Place.File;
			Error.Line = Place.Line;
			Error.Column = Place.Column;
		}
		const bool bEntry = Error.Message.find("entry point") != std::string::npos ||
							Error.Message.find("entry function") != std::string::npos;
		Error.Code = bEntry && Error.Message.find(Request.EntryPoint) != std::string::npos ? 6011 : Error.Code;
		Errors.push_back(std::move(Error));
	}
	return Errors;
}

} // namespace Drydock
