// What must hold for any .usf text: it flattens so that every line keeps its place, or there is a message; whatever the
// front end prints is read; and a module that goes with the text is walked to the end or refused. The front end itself
// is a program of its own (drydock_front_end) and stands in here as what it makes: modules of a corpus, changed as the
// text says. Used by the fuzzer, and by a test that runs its corpus.
#pragma once

#include "FuzzSpirvChecks.h"
#include "FuzzSpirvMutate.h"
#include "ShaderFrontEnd.h"
#include "ShaderRewrites.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

namespace Drydock
{

/** A fuzzed text: sections that begin with a line `//@ /Virtual/path`, `//@ messages`, `//@ define NAME VALUE` or
 *  `//@ uniform BUFFER MEMBER`; what stands before the first is the shader. */
struct FUsfInput
{
	FShaderCompileRequest Request;
	std::string Messages; // as the front end might print them
};

inline FUsfInput ReadUsfInput(const std::string& Text)
{
	FUsfInput Input;
	Input.Request.VirtualPath = "/Fuzz/Main.usf";
	Input.Request.EntryPoint = "Main";
	Input.Request.GeneratedFiles = {{Input.Request.VirtualPath, ""}};
	std::string* Section = &Input.Request.GeneratedFiles[0].second;
	for (size_t At = 0; At < Text.size();)
	{
		const size_t End = std::min(Text.find('\n', At), Text.size() - 1) + 1;
		const std::string Line = Text.substr(At, End - At);
		At = End;
		if (!Line.starts_with("//@ "))
		{
			*Section += Line;
			continue;
		}
		std::istringstream Words(Line.substr(4));
		std::string Kind, Name, Value;
		Words >> Kind >> Name >> Value;
		if (std::any_of(Line.begin(), Line.end(), [](char c) { return c < ' ' && c != '\t' && c != '\n'; }))
		{
			continue; // paths, names and values come from C++, not from a shader's author
		}
		if (Kind == "messages")
		{
			Section = &Input.Messages;
		}
		else if (Kind == "define")
		{
			Input.Request.Defines.emplace_back(Name, Value);
		}
		else if (Kind == "uniform")
		{
			Input.Request.UniformBuffers.push_back({Name, {Value}, {}});
		}
		else if (!Kind.empty() && Kind[0] == '/')
		{
			Input.Request.GeneratedFiles.emplace_back(Kind, "");
			Section = &Input.Request.GeneratedFiles.back().second;
		}
	}
	return Input;
}

inline std::vector<std::string> SplitLines(const std::string& Text)
{
	std::vector<std::string> Lines;
	std::istringstream Stream(Text);
	for (std::string Line; std::getline(Stream, Line);)
	{
		Lines.push_back(Line);
	}
	return Lines;
}

inline std::string TrimEnd(const std::string& Line)
{
	return Line.substr(0, Line.find_last_not_of(" \t") + 1);
}

/** By its #line directives, every line of the flattened text that claims to be of the shader is at one that the shader
 * has; and where nothing replaces words (macros, comments, joined lines) it is that line itself. */
inline std::string CheckLinesKeepTheirPlace(const FUsfInput& Input, const std::string& Flattened)
{
	const std::string Main = NormalizeShaderText(Input.Request.GeneratedFiles[0].second);
	const std::vector<std::string> Expected = SplitLines(Main);
	std::string All;
	for (const auto& [Path, Text] : Input.Request.GeneratedFiles)
	{
		All += Text;
	}
	const std::string Pragma = "#pragma pack_matrix(row_major)";
	const std::string Mine = " \"" + Input.Request.VirtualPath + "\"";
	bool bPlain = Input.Request.Defines.empty();
	for (const char* const Changed : {"define", "//", "/*", "\\", "SHADER", "_", "DRYDOCK"})
	{
		bPlain = bPlain && All.find(Changed) == std::string::npos;
	}
	bool bMain = false;
	size_t Number = 0;
	for (const std::string& Line : SplitLines(Flattened))
	{
		if (Line.starts_with("#line "))
		{
			bMain = Line.size() > Mine.size() && Line.compare(Line.size() - Mine.size(), Mine.size(), Mine) == 0;
			Number = size_t(std::atoi(Line.c_str() + 6));
			continue;
		}
		const bool bPlace = Number >= 1 && Number <= Expected.size();
		if (bMain && !Line.empty() && Line != Pragma && (!bPlace || (bPlain && TrimEnd(Expected[Number - 1]) != Line)))
		{
			return "line " + std::to_string(Number) + " of the shader became '" + Line + "'";
		}
		++Number;
	}
	return "";
}

/** What does not hold, or nothing. Modules: what the front end might have made of the text. */
inline std::string CheckUsfText(const std::string& Text, const std::vector<std::vector<uint32_t>>& Modules)
{
	const FUsfInput Input = ReadUsfInput(Text);
	for (const FDiagnostic& Found : ParseFrontEndMessages(Input.Messages, Input.Request))
	{
		if (Found.Code < 6010 || Found.Code > 6012)
		{
			return "a message of the front end with the number " + std::to_string(Found.Code);
		}
	}
	FShaderSource Source;
	try
	{
		Source = FlattenShader(Input.Request);
	}
	catch (const FError& Error)
	{
		for (const FDiagnostic& Found : Error.GetDiagnostics())
		{
			if (Found.Message.empty() || !std::set<int>{6001, 6002, 6003, 6010, 6020}.contains(Found.Code))
			{
				return "an error without a number of its own: " + Found.ToString();
			}
		}
		return "";
	}
	if (std::any_of(Source.Text.begin(), Source.Text.end(), [](char c) { return c == '\r' || c == '\0' || c < 0; }))
	{
		return "the flattened text is not plain";
	}
	const bool bOwnLines = Text.find("#line") != std::string::npos || Text.find("DRYDOCK_FILE_") != std::string::npos;
	if (const std::string Problem = bOwnLines ? "" : CheckLinesKeepTheirPlace(Input, Source.Text); !Problem.empty())
	{
		return Problem;
	}
	std::mt19937 Random(uint32_t(std::hash<std::string>()(Text)));
	if (Random() % 8 != 0)
	{
		return ""; // a module takes longer than a text, and has a fuzzer of its own
	}
	std::vector<uint32_t> Words = Modules[Random() % Modules.size()];
	MutateSpirv(Words, Random);
	std::string Message;
	const ESpirvWalk Walk = WalkSpirv(Words, Message, Source.Text);
	return Walk != ESpirvWalk::Run && Message.empty() ? "refused without a message" : "";
}

/** The modules of tests/fuzz/corpus/spirv, in the order of their names. */
inline std::vector<std::vector<uint32_t>> ReadModules(const std::string& Folder)
{
	std::vector<std::filesystem::path> Paths;
	for (const auto& Entry : std::filesystem::directory_iterator(Folder))
	{
		Paths.push_back(Entry.path());
	}
	std::sort(Paths.begin(), Paths.end());
	std::vector<std::vector<uint32_t>> Modules;
	for (const std::filesystem::path& Path : Paths)
	{
		std::ifstream Stream(Path, std::ios::binary);
		const std::string Bytes((std::istreambuf_iterator<char>(Stream)), {});
		Modules.emplace_back(Bytes.size() / 4);
		std::memcpy(Modules.back().data(), Bytes.data(), Modules.back().size() * 4);
	}
	return Modules;
}

} // namespace Drydock
