// Flattens a shader and its includes. Conditions are left to the front end's preprocessor, so a file that stands inside
// #if is wrapped in a guard of ours at every place that includes it; one that stands outside of any #if is simply there
// once. Source of the mapping of paths and of the rule "every file once": the engine's shader preprocessor.
#include "ShaderSource.h"

#include "RegularFile.h"
#include "ShaderDirectories.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

namespace Drydock
{

namespace
{

constexpr size_t MaxText = 32u << 20;
constexpr int MaxDepth = 64;

bool IsWordCharacter(char c)
{
	return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/** A line of a normalised text without its comments: what the preprocessor would see of a directive. */
class FLineScanner
{
public:
	/** Text of the line with comments replaced by a blank; keeps track of block comments that span lines. */
	std::string Strip(const std::string& Line)
	{
		std::string Result;
		for (size_t i = 0; i < Line.size(); ++i)
		{
			const char Next = i + 1 < Line.size() ? Line[i + 1] : '\0';
			if (bInComment)
			{
				if (Line[i] == '*' && Next == '/')
				{
					bInComment = false;
					++i;
				}
			}
			else if (Line[i] == '/' && Next == '*')
			{
				bInComment = true;
				Result += ' ';
				++i;
			}
			else if (Line[i] == '/' && Next == '/')
			{
				break;
			}
			else if (Line[i] == '"')
			{
				const size_t Close = Line.find('"', i + 1);
				const size_t End = Close == std::string::npos ? Line.size() : Close + 1;
				Result.append(Line, i, End - i);
				i = End - 1;
			}
			else
			{
				Result += Line[i];
			}
		}
		return Result;
	}

private:
	bool bInComment = false;
};

/** "include" of `  # include "x"`, and what follows it; empty when the line is no directive. */
std::pair<std::string, std::string> SplitDirective(const std::string& Line)
{
	size_t i = Line.find_first_not_of(" \t");
	if (i == std::string::npos || Line[i] != '#')
	{
		return {};
	}
	i = Line.find_first_not_of(" \t", i + 1);
	if (i == std::string::npos)
	{
		return {};
	}
	const size_t Start = i;
	while (i < Line.size() && IsWordCharacter(Line[i]))
	{
		++i;
	}
	const size_t Rest = Line.find_first_not_of(" \t", i);
	return {Line.substr(Start, i - Start), Rest == std::string::npos ? std::string() : Line.substr(Rest)};
}

std::string QuotedPath(const std::string& Text)
{
	if (Text.empty() || (Text[0] != '"' && Text[0] != '<'))
	{
		return {};
	}
	const size_t Close = Text.find(Text[0] == '"' ? '"' : '>', 1);
	return Close == std::string::npos ? std::string() : Text.substr(1, Close - 1);
}

class FFlattener
{
public:
	explicit FFlattener(const FShaderCompileRequest& InRequest)
		: Request(InRequest)
	{
	}

	FShaderSource Run();

private:
	struct FFile
	{
		std::string Text;
		int Guard = 0;
		bool bPlacedForGood = false; // stands outside of any condition
	};

	void AppendDefines();
	void AppendFile(const std::string& Path, int ConditionDepth);
	void AppendInclude(const std::string& Target, const std::string& Includer, int Line, int ConditionDepth);
	FFile* FindFile(const std::string& Path);
	std::string DescribeAbsence() const
	{
		return Unreadable.empty() ? "; is its directory mapped by AddShaderSourceDirectoryMapping?" : Unreadable;
	}
	void Error(int Code, const std::string& Message, const std::string& File, int Line)
	{
		Errors.push_back({ESeverity::Error, Code, Message, File, Line, 0, {}});
	}
	void AppendLine(int Line, const std::string& Path)
	{
		Result.Text += "#line " + std::to_string(Line) + " \"" + Path + "\"\n";
	}

	const FShaderCompileRequest& Request;
	FShaderSource Result;
	std::map<std::string, FFile> Files;
	std::vector<std::string> Open; // files being appended
	std::string Unreadable;        // the last file that is there and cannot be read, and why
	std::vector<FDiagnostic> Errors;
};

FFlattener::FFile* FFlattener::FindFile(const std::string& Path)
{
	const auto Known = Files.find(Path);
	if (Known != Files.end())
	{
		return &Known->second;
	}
	std::string Bytes;
	const auto Generated = std::find_if(Request.GeneratedFiles.begin(), Request.GeneratedFiles.end(),
		[&Path](const std::pair<std::string, std::string>& File) { return File.first == Path; });
	if (Generated != Request.GeneratedFiles.end())
	{
		Bytes = Generated->second;
	}
	else
	{
		const std::string Real = FindShaderFile(Path);
		if (!Real.empty())
		{
			FFileBytes Read = ReadRegularFile(Real);
			if (!Read.Bytes)
			{
				Unreadable = ": " + Real + ": " + Read.Problem;
				return nullptr;
			}
			Bytes = std::move(*Read.Bytes);
			if (std::find(Result.Files.begin(), Result.Files.end(), Real) == Result.Files.end())
			{
				Result.Files.push_back(Real);
			}
		}
		else if (Path.rfind("/Engine/Generated/", 0) != 0) // nobody generated it: there is nothing to declare
		{
			return nullptr;
		}
	}
	FFile File;
	File.Text = RewriteUniformBuffers(NormalizeShaderText(Bytes), Request.UniformBuffers);
	File.Guard = int(Files.size());
	return &Files.emplace(Path, std::move(File)).first->second;
}

void FFlattener::AppendInclude(const std::string& Target, const std::string& Includer, int Line, int ConditionDepth)
{
	if (Target.empty())
	{
		Error(6003, "#include needs a path in quotes", Includer, Line);
		return;
	}
	std::string Path = ResolveVirtualPath(Target, Includer);
	FFile* File = FindFile(Path);
	if (!File && Target[0] != '/')
	{
		// The engine lets any shader name its private files without a folder.
		const std::string Private = ResolveVirtualPath("/Engine/Private/" + Target, Includer);
		File = FindFile(Private);
		Path = File ? Private : Path;
	}
	if (!File)
	{
		const bool bMapped = Path != Target && Target[0] != '/';
		Error(6001,
			"cannot open include file '" + Target + "'" + (bMapped ? " (" + Path + ")" : "") + DescribeAbsence(),
			Includer, Line);
		return;
	}
	if (File->bPlacedForGood || std::find(Open.begin(), Open.end(), Path) != Open.end())
	{
		return;
	}
	if (Open.size() >= MaxDepth || Result.Text.size() > MaxText)
	{
		Error(6003, "includes are nested too deeply", Includer, Line);
		return;
	}
	File->bPlacedForGood = ConditionDepth == 0;
	const std::string Guard = "DRYDOCK_FILE_" + std::to_string(File->Guard);
	Result.Text += "#ifndef " + Guard + "\n#define " + Guard + " 1\n";
	AppendFile(Path, ConditionDepth);
	Result.Text += "#endif\n";
	AppendLine(Line + 1, Includer);
}

void FFlattener::AppendFile(const std::string& Path, int ConditionDepth)
{
	Open.push_back(Path);
	AppendLine(1, Path);
	FLineScanner Scanner;
	std::istringstream Stream(Files.at(Path).Text);
	std::string Line;
	int Number = 0;
	bool bContinued = false;
	while (std::getline(Stream, Line))
	{
		++Number;
		const std::string Stripped = Scanner.Strip(Line);
		const auto [Directive, Rest] = bContinued ? std::pair<std::string, std::string>() : SplitDirective(Stripped);
		bContinued = !Stripped.empty() && Stripped.back() == '\\';
		if (Directive == "include")
		{
			const size_t Before = Result.Text.size();
			AppendInclude(QuotedPath(Rest), Path, Number, ConditionDepth);
			if (Result.Text.size() == Before)
			{
				Result.Text += '\n';
			}
			continue;
		}
		if (Directive == "pragma" && Rest.rfind("once", 0) == 0)
		{
			Result.Text += '\n';
			continue;
		}
		if (Directive == "if" || Directive == "ifdef" || Directive == "ifndef")
		{
			++ConditionDepth;
		}
		else if (Directive == "endif")
		{
			--ConditionDepth;
		}
		Result.Text += Line;
		Result.Text += '\n';
	}
	Open.pop_back();
}

void FFlattener::AppendDefines()
{
	// What the engine's compile environment defines before the first line of a shader.
	std::vector<std::pair<std::string, std::string>> Defines = {
		{"DRYDOCK", "1"},
		{"PIXELSHADER", Request.Stage == EShaderStage::Pixel ? "1" : "0"},
		{"COMPUTESHADER", Request.Stage == EShaderStage::Compute ? "1" : "0"},
		{"VERTEXSHADER", "0"},
		{"GEOMETRYSHADER", "0"},
		{"HULLSHADER", "0"},
		{"DOMAINSHADER", "0"},
		{"MESHSHADER", "0"},
		{"RAYHITGROUPSHADER", "0"},
		{"SM5_PROFILE", "1"},
		{"SM6_PROFILE", "0"},
		{"ES3_1_PROFILE", "0"},
		{"COMPILER_HLSL", "1"},
		{"COMPILER_DXC", "0"},
		{"PLATFORM_SUPPORTS_SM6_0_WAVE_OPERATIONS", "0"},
	};
	for (const auto& [Name, Value] : Request.Defines)
	{
		const auto Known = std::find_if(
			Defines.begin(), Defines.end(), [&Name = Name](const auto& Define) { return Define.first == Name; });
		if (Known != Defines.end())
		{
			Known->second = Value;
		}
		else
		{
			Defines.emplace_back(Name, Value);
		}
	}
	// The engine packs matrices by rows, which is how FMatrix44f lies in memory.
	Result.Text += "#pragma pack_matrix(row_major)\n";
	for (const auto& [Name, Value] : Defines)
	{
		Result.Text += "#define " + Name + " " + Value + "\n";
	}
}

FShaderSource FFlattener::Run()
{
	AppendDefines();
	if (FindFile(Request.VirtualPath))
	{
		Open.clear();
		AppendFile(Request.VirtualPath, 0);
	}
	else
	{
		Error(6001, "cannot open shader '" + Request.VirtualPath + "'" + DescribeAbsence(), {}, 0);
	}
	if (!Errors.empty())
	{
		throw FError(std::move(Errors), ExitUsage);
	}
	return std::move(Result);
}

} // namespace

FShaderSource FlattenShader(const FShaderCompileRequest& Request)
{
	return FFlattener(Request).Run();
}

std::string NormalizeShaderText(const std::string& Bytes)
{
	size_t i = Bytes.rfind("\xEF\xBB\xBF", 0) == 0 ? 3 : 0;

	// Valid UTF-8 has no ASCII byte inside a character, so only other encodings need their byte pairs taken together.
	bool bUtf8 = true;
	for (size_t k = i; k < Bytes.size() && bUtf8; ++k)
	{
		const unsigned char c = static_cast<unsigned char>(Bytes[k]);
		const int Following = c < 0x80                ? 0
							  : c >= 0xF0 && c < 0xF8 ? 3
							  : c >= 0xE0 && c < 0xF0 ? 2
							  : c >= 0xC2 && c < 0xE0 ? 1
													  : -1;
		bUtf8 = Following >= 0 && k + size_t(Following) < Bytes.size();
		for (int n = 0; bUtf8 && n < Following; ++n)
		{
			bUtf8 = (static_cast<unsigned char>(Bytes[++k]) & 0xC0) == 0x80;
		}
	}

	std::string Result;
	Result.reserve(Bytes.size());
	for (; i < Bytes.size(); ++i)
	{
		const unsigned char c = static_cast<unsigned char>(Bytes[i]);
		const bool bLineEndNext = i + 1 < Bytes.size() && Bytes[i + 1] == '\n';
		if (c == '\r')
		{
			Result += bLineEndNext ? "" : "\n";
		}
		else if (c >= 0x80)
		{
			Result += '?';
			if (!bUtf8 && c > 0x80 && i + 1 < Bytes.size() && static_cast<unsigned char>(Bytes[i + 1]) >= 0x40)
			{
				Result += '?';
				++i;
			}
		}
		else
		{
			Result += c == '\0' ? ' ' : char(c);
		}
	}
	return Result;
}

std::string ResolveVirtualPath(const std::string& Path, const std::string& Includer)
{
	std::string Slashed = Path;
	std::replace(Slashed.begin(), Slashed.end(), '\\', '/');
	namespace fs = std::filesystem;
	const fs::path Full =
		!Slashed.empty() && Slashed[0] == '/' ? fs::path(Slashed) : fs::path(Includer).parent_path() / Slashed;
	return Full.lexically_normal().generic_string();
}

std::string RewriteUniformBuffers(const std::string& Text, const FUniformBufferNames& Buffers)
{
	if (Buffers.empty())
	{
		return Text;
	}
	std::string Result;
	Result.reserve(Text.size() + Text.size() / 64);
	for (size_t i = 0; i < Text.size();)
	{
		const size_t Start = i;
		const char c = Text[i];
		if (c == '/' && i + 1 < Text.size() && (Text[i + 1] == '/' || Text[i + 1] == '*'))
		{
			const bool bBlock = Text[i + 1] == '*';
			const size_t Close = Text.find(bBlock ? "*/" : "\n", i + 2);
			i = Close == std::string::npos ? Text.size() : Close + (bBlock ? 2 : 0);
		}
		else if (c == '"')
		{
			const size_t Close = Text.find_first_of("\"\n", i + 1);
			i = Close == std::string::npos ? Text.size() : Close + (Text[Close] == '"');
		}
		else if (IsWordCharacter(c))
		{
			while (i < Text.size() && IsWordCharacter(Text[i]))
			{
				++i;
			}
			const std::string Word = Text.substr(Start, i - Start);
			const auto Buffer = std::find_if(
				Buffers.begin(), Buffers.end(), [&Word](const auto& Entry) { return Entry.first == Word; });
			size_t Dot = Text.find_first_not_of(" \t", i);
			const bool bMember = Start > 0 && Text[Start - 1] == '.'; // In.View.X is a struct's own member
			if (Buffer != Buffers.end() && !bMember && Dot != std::string::npos && Text[Dot] == '.')
			{
				const size_t Begin = Text.find_first_not_of(" \t", Dot + 1);
				size_t End = std::min(Begin, Text.size());
				while (End < Text.size() && IsWordCharacter(Text[End]))
				{
					++End;
				}
				const std::string Member = Begin == std::string::npos ? std::string() : Text.substr(Begin, End - Begin);
				Result += Word + "_" + Member;
				i = std::max(End, Dot + 1);
				continue;
			}
		}
		else
		{
			++i;
		}
		Result.append(Text, Start, i - Start);
	}
	return Result;
}

} // namespace Drydock
