// Finds the files of a shader and has them preprocessed and rewritten.
#include "ShaderSource.h"

#include "ContentHash.h"
#include "LeftOutStages.h"
#include "RegularFile.h"
#include "ShaderDirectories.h"
#include "ShaderPreprocessor.h"
#include "ShaderPrints.h"
#include "SpirvFile.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace Drydock
{

namespace
{

/** The end of the message "cannot open '...'": why, the nearest name, and where files are looked for. */
std::string DescribeAbsence(const std::string& Path, const std::string& Unreadable)
{
	if (!Unreadable.empty())
	{
		return Unreadable;
	}
	const std::string Nearest = FindNearestShaderFile(Path);
	std::string Folders;
	std::set<std::string> Listed;
	for (const FShaderDirectory& Directory : GetShaderDirectories())
	{
		std::error_code Ignored;
		const bool bThere = std::filesystem::is_directory(Directory.Real, Ignored);
		const std::string Mapping = Directory.Virtual + " to " + Directory.Real + (bThere ? "" : " (no such folder)");
		if (Listed.insert(Mapping).second) // a plugin may map what drydock_add_plugin has mapped
		{
			Folders += (Folders.empty() ? "" : ", ") + Mapping;
		}
	}
	return (Nearest.empty() ? std::string() : "; did you mean " + Nearest + "?") +
		   (Nearest.empty() ? "; mapped by AddShaderSourceDirectoryMapping: " : " Mapped: ") +
		   (Folders.empty() ? "nothing" : Folders);
}

class FFlattener
{
public:
	explicit FFlattener(const FShaderCompileRequest& InRequest)
		: Request(InRequest)
		, Preprocessor([this](const std::string& Target, const std::string& Includer, int Line)
			  { return FindInclude(Target, Includer, Line); })
	{
	}

	FShaderSource Run();

private:
	FShaderSource RunSpirv();
	void Define();
	const std::string* FindFile(const std::string& Path);
	std::pair<std::string, const std::string*> FindIncluded(const std::string& Target, const std::string& Includer);
	std::string Fingerprint();
	void DefineDxcMacros();
	FShaderInclude FindInclude(const std::string& Target, const std::string& Includer, int Line);

	const FShaderCompileRequest& Request;
	FShaderPreprocessor Preprocessor;
	FShaderSource Result;
	std::map<std::string, std::string> Files; // virtual path, normalised text
	std::string Unreadable;                   // the last file that is there and cannot be read, and why
};

const std::string* FFlattener::FindFile(const std::string& Path)
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
		else if (!Path.starts_with("/Engine/Generated/")) // nobody generated it: there is nothing to declare
		{
			return nullptr;
		}
	}
	return &Files.emplace(Path, NormalizeShaderText(Bytes)).first->second;
}

/** The path and text of an include; the text is null where the file does not exist. */
std::pair<std::string, const std::string*> FFlattener::FindIncluded(
	const std::string& Target, const std::string& Includer)
{
	std::string Path = ResolveVirtualPath(Target, Includer);
	const std::string* Text = FindFile(Path);
	if (!Text && Target[0] != '/')
	{
		// The engine lets any shader name its private files without a folder.
		const std::string Private = ResolveVirtualPath("/Engine/Private/" + Target, Includer);
		Text = FindFile(Private);
		Path = Text ? Private : Path;
	}
	return {Path, Text};
}

/** Covers the file and all that it may include, whatever conditions the includes stand in, so that all permutations
 * have the same. */
std::string FFlattener::Fingerprint()
{
	std::map<std::string, const std::string*> Read;
	std::vector<std::pair<std::string, const std::string*>> Open; // from what was read: a macro may have named a file
	for (const auto& [Path, Text] : Files)
	{
		Open.emplace_back(Path, &Text);
	}
	while (!Open.empty())
	{
		const auto [Path, Text] = Open.back();
		Open.pop_back();
		if (!Text || !Read.emplace(Path, Text).second)
		{
			continue;
		}
		for (size_t At = Text->find('#'); At != std::string::npos; At = Text->find('#', At + 1))
		{
			const std::string Line = Text->substr(At, Text->find('\n', At) - At);
			if (const std::string Target = FindQuotedInclude(Line); !Target.empty())
			{
				Open.push_back(FindIncluded(Target, Path));
			}
		}
	}
	FContentHash Hash;
	for (const auto& [Path, Text] : Read)
	{
		Hash.Add(Path);
		Hash.Add(*Text);
	}
	return Hash.Finish().substr(0, 16);
}

FShaderInclude FFlattener::FindInclude(const std::string& Target, const std::string& Includer, int Line)
{
	const auto [Path, Text] = FindIncluded(Target, Includer);
	if (!Text)
	{
		const bool bRelative = Path != Target && Target[0] != '/';
		Preprocessor.GetErrors().push_back({ESeverity::Error, 6001,
			"cannot open include file '" + Target + "'" + (bRelative ? " (" + Path + ")" : "") +
				DescribeAbsence(Path, Unreadable),
			Includer, Line, 0, {}});
	}
	return {Path, Text};
}

void FFlattener::Define()
{
	// The engine's compile environment defines these before the first line of a shader.
	const std::vector<std::pair<std::string, std::string>> Defines = {
		{"DRYDOCK", "1"},
		{"PIXELSHADER", Request.Stage == EShaderStage::Pixel ? "1" : "0"},
		{"COMPUTESHADER", Request.Stage == EShaderStage::Compute ? "1" : "0"},
		{"VERTEXSHADER", Request.Stage == EShaderStage::Vertex ? "1" : "0"},
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
	for (const auto& [Name, Value] : Defines)
	{
		Preprocessor.Define(Name, Value);
	}
	const auto IsFxc = [](const auto& Each)
	{
		return Each.first == FxcRulesDefine && Each.second != "0";
	};
	if (std::ranges::none_of(Request.Defines, IsFxc))
	{
		DefineDxcMacros();
	}
	for (const auto& [Name, Value] : Request.Defines)
	{
		Preprocessor.Define(Name, Value);
	}
}

/** DXC's own macros: https://github.com/microsoft/DirectXShaderCompiler/wiki/Predefined-Version-Macros */
void FFlattener::DefineDxcMacros()
{
	Preprocessor.Define("__hlsl_dx_compiler", "1");
	Preprocessor.Define("__HLSL_VERSION", "2021");
	Preprocessor.Define("__SHADER_TARGET_MAJOR", "6");
	Preprocessor.Define("__SHADER_TARGET_MINOR", "6");
	Preprocessor.Define("__SHADER_STAGE_PIXEL", "0"); // the numbers of D3D12_SHADER_VERSION_TYPE
	Preprocessor.Define("__SHADER_STAGE_VERTEX", "1");
	Preprocessor.Define("__SHADER_STAGE_COMPUTE", "5");
	Preprocessor.Define("__SHADER_TARGET_STAGE", Request.Stage == EShaderStage::Pixel    ? "0"
												 : Request.Stage == EShaderStage::Vertex ? "1"
																						 : "5");
}

FShaderSource FFlattener::RunSpirv()
{
	std::string Problem = DescribeAbsence(Request.VirtualPath, {});
	const std::string Real = FindShaderFile(Request.VirtualPath);
	if (!Real.empty())
	{
		const FFileBytes Read = ReadRegularFile(Real);
		if (Read.Bytes)
		{
			FShaderSource Source = ReadSpirvFile(*Read.Bytes, Request);
			Source.Files = {Real};
			return Source;
		}
		Problem = ": " + Real + ": " + Read.Problem;
	}
	throw FError({ESeverity::Error, 6001, "cannot open shader '" + Request.VirtualPath + "'" + Problem, {}, 0, 0, {}},
		ExitUsage);
}

FShaderSource FFlattener::Run()
{
	if (IsSpirvFile(Request.VirtualPath))
	{
		return RunSpirv();
	}
	Define();
	if (const std::string* Text = FindFile(Request.VirtualPath))
	{
		Preprocessor.Append(Request.VirtualPath, *Text);
	}
	else
	{
		Preprocessor.GetErrors().push_back({ESeverity::Error, 6001,
			"cannot open shader '" + Request.VirtualPath + "'" + DescribeAbsence(Request.VirtualPath, Unreadable), {},
			0, 0, {}});
	}
	if (!Preprocessor.GetErrors().empty())
	{
		throw FError(std::move(Preprocessor.GetErrors()), ExitUsage);
	}
	Result.Fingerprint = Fingerprint();
	// The engine packs matrices by rows, which is how FMatrix44f lies in memory.
	const std::string Printing = RewritePrints(Preprocessor.GetText(), Request.bKeepFunctions, Result.Strings);
	Result.Text = "#pragma pack_matrix(row_major)\n" + DeclarePrints(Printing);
	for (const FShaderUniformBuffer& Buffer : Request.UniformBuffers)
	{
		Result.Text += "#line 1 \"/Engine/Generated/UniformBuffers/" + Buffer.Name + ".ush\"\n" + Buffer.Declaration;
	}
	Result.Text += "\n" + Printing;
	if (std::optional<FDiagnostic> LeftOut = FindLeftOutEntry(Result.Text, Request))
	{
		throw FError(*LeftOut, ExitUsage);
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
	size_t i = Bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0;

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

std::string ReadShaderText(const std::string& VirtualPath, const FShaderCompileRequest& Request)
{
	const auto Generated = std::find_if(Request.GeneratedFiles.begin(), Request.GeneratedFiles.end(),
		[&VirtualPath](const std::pair<std::string, std::string>& Each) { return Each.first == VirtualPath; });
	if (Generated != Request.GeneratedFiles.end())
	{
		return NormalizeShaderText(Generated->second);
	}
	const std::string Real = FindShaderFile(VirtualPath);
	return Real.empty() ? std::string() : NormalizeShaderText(ReadRegularFile(Real).Bytes.value_or(""));
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

} // namespace Drydock
