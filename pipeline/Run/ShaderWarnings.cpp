// Reads each shader of a plugin or overlay once more, for the warnings that its compilation leaves out.
#include "Run/ShaderWarnings.h"

#include "EngineNames.h"
#include "InstallPaths.h"
#include "Run/RunErrors.h"
#include "ShaderDirectories.h"
#include "ShaderLint.h"
#include "ShaderSource.h"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <map>
#include <regex>
#include <set>

namespace Drydock
{

namespace
{

std::set<std::string> FindDefined(const std::string& Text)
{
	static const std::regex Define(R"(#\s*define\s+(\w+))");
	std::set<std::string> Names;
	for (std::sregex_iterator At(Text.begin(), Text.end(), Define), End; At != End; ++At)
	{
		Names.insert((*At)[1]);
	}
	return Names;
}

/** The names of a condition that stand for 0, because no text of the shader defines them: not those of defined(). */
std::vector<std::string> FindUndefined(std::string Condition, const std::set<std::string>& Known)
{
	static const std::regex Ignored(R"(defined\s*\(?\s*\w+|//.*|/\*.*?\*/|\b\d\w*)");
	static const std::regex Word(R"([A-Za-z_]\w*)");
	Condition = std::regex_replace(Condition, Ignored, " ");
	std::vector<std::string> Names;
	for (std::sregex_iterator At(Condition.begin(), Condition.end(), Word), End; At != End; ++At)
	{
		const std::string Name = At->str();
		if (!Known.contains(Name) && Name != "true" && Name != "false" && !Name.starts_with("__"))
		{
			Names.push_back(Name);
		}
	}
	return Names;
}

/** Warnings about `#if NAME` in the files of a shader that drydock does not ship. */
void AddUndefined(const FShaderCompileRequest& Request, std::map<std::string, FDiagnostic>& Found)
{
	static const std::regex If(R"(^\s*#\s*(?:el)?if\b(.*)$)");
	std::set<std::string> Known;
	std::vector<std::pair<std::string, std::string>> Own; // file, text
	const auto Read = [&Known](const std::string& Text)
	{
		Known.merge(FindDefined(Text));
	};
	for (const auto& [Name, Value] : Request.Defines)
	{
		Known.insert(Name);
	}
	for (const auto& [Name, Text] : Request.GeneratedFiles)
	{
		Read(Text);
	}
	for (const std::string& File : FlattenShader(Request).Files)
	{
		const std::string Text = TryReadTextFile(File).value_or("");
		Read(Text);
		if (!File.starts_with(FindShippedShaders() + "/"))
		{
			Own.emplace_back(File, Text);
		}
	}
	for (const auto& [File, Text] : Own)
	{
		int Line = 0;
		for (const std::string& Each : SplitText(Text))
		{
			++Line;
			std::smatch Condition;
			if (Each.size() > 500 || !std::regex_match(Each, Condition, If))
			{
				continue;
			}
			for (const std::string& Name : FindUndefined(Condition[1], Known))
			{
				const std::string Near = SuggestName(Name, {Known.begin(), Known.end()});
				Found.emplace(File + ":" + std::to_string(Line) + Name,
					FDiagnostic{.Severity = Near.empty() ? ESeverity::Note : ESeverity::Warning,
						.Code = WarnShader,
						.Message =
							"no text of the shader and no class defines '" + Name + "', which counts as 0" + Near,
						.File = File,
						.Line = Line});
			}
		}
	}
}

} // namespace

FShaderWarnings::FShaderWarnings()
	: Listener(
		  [this](const FShaderCompileRequest& Request)
		  {
			  if (!IsShipped(Request.VirtualPath, Request))
			  {
				  Requests.push_back(Request);
			  }
		  })
{
}

std::vector<FDiagnostic> FShaderWarnings::Find() const
{
	constexpr uint8_t AllPlatforms = 0xFF;
	std::set<FLintFinding> Found;
	std::map<std::string, FDiagnostic> Undefined;
	for (const FShaderCompileRequest& Request : Requests)
	{
		try
		{
			AddUndefined(Request, Undefined);
			std::vector<FDiagnostic> Refused; // the run reports it
			for (FLintFinding& Finding : LintShader(Request, AllPlatforms, &Refused))
			{
				const std::string Rule = Finding.Rule->Id;
				if ((Rule == "compiler-warning" || Rule == "out-not-set") && !IsShipped(Finding.File, Request))
				{
					Found.insert(std::move(Finding));
				}
			}
		}
		catch (const FError&)
		{
			// The run reports it.
		}
	}
	std::vector<FDiagnostic> Diagnostics;
	for (const FLintFinding& Finding : Found)
	{
		Diagnostics.push_back({.Severity = ESeverity::Warning,
			.Code = WarnShader,
			.Message = Finding.What,
			.File = Finding.File,
			.Line = Finding.Line});
	}
	for (const auto& [Place, Each] : Undefined)
	{
		Diagnostics.push_back(Each);
	}
	return Diagnostics;
}

} // namespace Drydock
