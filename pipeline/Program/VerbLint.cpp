// `drydock lint`: what of shaders fails on platforms that drydock is not.
#include "EngineNames.h"
#include "GlobalShader.h"
#include "Program/FindingsOption.h"
#include "Program/ProgramOutput.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Run/Run.h"
#include "Run/RunSetup.h"
#include "ShaderCompilation.h"
#include "ShaderDirectories.h"
#include "ShaderLint.h"
#include "SpirvFile.h"
#include "Text/ConfigErrors.h"
#include "Text/Fmt.inl"
#include "Text/JsonWriter.h"
#include "Text/TextFile.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <regex>
#include <set>

namespace Drydock
{

namespace
{

namespace fs = std::filesystem;

struct FLintOptions
{
	FRunOptions Run; // for configs
	std::vector<std::string> Targets;
	std::vector<std::string> Platforms;
	std::string Entry;   // of shaders that no class names; empty: all
	int EngineMinor = 0; // whose names shaders may use; 0: any
	FFindingsOptions Findings;
	bool bList = false;
	bool bJson = false;
};

uint8_t GetPlatforms(const FLintOptions& Options)
{
	uint8_t Platforms = 0;
	for (const std::string& Name : Options.Platforms)
	{
		const auto Known = std::find(GetLintPlatforms().begin(), GetLintPlatforms().end(), Name);
		Platforms |= uint8_t(1 << (Known - GetLintPlatforms().begin()));
	}
	return Platforms != 0 ? Platforms : uint8_t(0xFF);
}

/** The virtual directory of a file that is mapped only for checking. */
constexpr const char* OwnDirectory = "/Lint";

constexpr int ErrorNoEntryPoint = 6011;

/** A file as its user named it: by the engine's path where it has one, else by that on disk. */
std::string GetShownPath(const std::string& VirtualPath)
{
	if (!VirtualPath.starts_with(std::string(OwnDirectory) + "/"))
	{
		return VirtualPath;
	}
	std::error_code Error;
	const fs::path Shown = fs::proximate(FindShaderFile(VirtualPath), Error);
	return Error ? VirtualPath : Shown.generic_string();
}

std::vector<FDiagnostic> WithShownPaths(std::vector<FDiagnostic> Diagnostics)
{
	for (FDiagnostic& Each : Diagnostics)
	{
		Each.File = GetShownPath(Each.File);
	}
	return Diagnostics;
}

/** The findings, each once: permutations of one shader share findings. */
struct FFound
{
	std::set<FLintFinding> Findings;
	size_t NumShaders = 0;
	uint8_t Platforms = 0;

	/** Checks a shader. If more entry points of its file follow, Of is the file's linter. */
	void Look(const FShaderCompileRequest& Request, FFileLinter* Of = nullptr)
	{
		++NumShaders;
		std::vector<FDiagnostic> Refused;
		for (FLintFinding& Finding :
			Of ? Of->Lint(Request, Platforms, &Refused) : LintShader(Request, Platforms, &Refused))
		{
			Finding.File = GetShownPath(Finding.File);
			Findings.insert(std::move(Finding));
		}
		PrintDiagnostics(WithShownPaths(std::move(Refused)));
	}
};

/** Maps the shaders of the plugin that a file lies in as a run does: to "/Plugin/NAME", and to the names that its C++
 * gives to AddShaderSourceDirectoryMapping. */
void MapPluginOf(const fs::path& File)
{
	static const std::regex Mapping(R"x(AddShaderSourceDirectoryMapping\s*\(\s*(?:TEXT\s*\(\s*)?"(/[^"]+)")x");
	std::error_code Error;
	fs::path Plugin = File;
	std::string Name;
	while (Name.empty() && Plugin.has_relative_path())
	{
		Plugin = Plugin.parent_path();
		for (const fs::directory_entry& Entry : fs::directory_iterator(Plugin, Error))
		{
			Name = Entry.path().extension() == ".uplugin" ? Entry.path().stem().string() : Name;
		}
	}
	const std::string Shaders = (Plugin / "Shaders").string();
	if (Name.empty() || !fs::is_directory(Shaders, Error))
	{
		return;
	}
	AddShaderDirectory("/Plugin/" + Name, Shaders);
	for (fs::recursive_directory_iterator Entry(Plugin / "Source", Error), End; !Error && Entry != End;
		 Entry.increment(Error))
	{
		std::smatch Found;
		const std::string Text =
			Entry->path().extension() == ".cpp" ? TryReadTextFile(Entry->path().string()).value_or("") : "";
		if (std::regex_search(Text, Found, Mapping))
		{
			AddShaderDirectory(Found[1], Shaders);
		}
	}
}

/** The virtual path of a file; where its folder is not mapped, it is now. */
std::string GetVirtualPath(const std::string& Target)
{
	if (!FindShaderFile(Target).empty())
	{
		return Target;
	}
	std::error_code Error;
	const fs::path File = fs::canonical(Target, Error);
	if (Error || !fs::is_regular_file(File))
	{
		throw FError(
			{.Code = ErrorFileMissing, .Message = "there is no shader file of this name", .File = Target}, ExitFiles);
	}
	MapPluginOf(File);
	for (const FShaderDirectory& Directory : GetShaderDirectories())
	{
		const fs::path Folder = fs::weakly_canonical(Directory.Real, Error);
		const std::string Relative = File.lexically_relative(Folder).generic_string();
		if (!Relative.empty() && !Relative.starts_with(".."))
		{
			return Directory.Virtual + "/" + Relative;
		}
	}
	AddShaderDirectory(OwnDirectory, File.parent_path().string());
	return std::string(OwnDirectory) + "/" + File.filename().string();
}

/** One file may be mapped to several folders of the engine's. */
bool IsSameFile(const std::string& A, const std::string& B)
{
	std::error_code Error;
	return A == B || fs::equivalent(FindShaderFile(A), FindShaderFile(B), Error);
}

/** An entry point may hide behind a bracket that is missing: then that is the mistake. */
void ThrowWhatIsWrong(const FShaderCompileRequest& Request)
{
	try
	{
		LintShader(Request, 0);
	}
	catch (const FError& Error)
	{
		if (Error.GetDiagnostics().front().Code != ErrorNoEntryPoint)
		{
			throw;
		}
	}
}

/** Every permutation of the classes that name the file; where none does, the entry points that the text declares. */
void LintFile(const std::string& Target, const FLintOptions& Options, FFound& Found)
{
	std::optional<FRunSetup> Setup; // while it lives, the variables are as the command line sets them
	if (!Options.Run.Variables.empty() || !Options.Run.Exec.empty())
	{
		FRunOptions Run = Options.Run;
		Run.ConfigText = "{}";
		Setup.emplace(Run);
	}
	MakeShaderCompileRequest("", "", EShaderStage::Compute); // maps the shipped shaders
	const std::string Path = GetVirtualPath(Target);
	bool bNamed = false;
	ForEachShaderType(
		[&](const FShaderType& Type)
		{
			if (!IsSameFile(Type.GetShaderFilename(), Path) ||
				(!Options.Entry.empty() && Type.GetFunctionName() != Options.Entry))
			{
				return;
			}
			bNamed = true;
			for (int32 Id = 0; Id < Type.GetPermutationCount(); ++Id)
			{
				if (Type.ShouldCompilePermutation(Id))
				{
					const FShaderRef Shader(Type.FindOrCreateShader(Id));
					Found.Look(MakeShaderCompileRequest(Shader, Shader.GetRootParametersMetadata()));
				}
			}
		});
	if (bNamed)
	{
		return;
	}
	const std::vector<FShaderEntry> Entries =
		FindShaderEntries(MakeShaderCompileRequest(Path, Options.Entry, EShaderStage::Compute));
	size_t NumLooked = 0;
	std::vector<std::string> Names;
	FFileLinter Linter;
	for (const FShaderEntry& Entry : Entries)
	{
		Names.push_back(Entry.Name);
		if (Options.Entry.empty() || Entry.Name == Options.Entry)
		{
			Found.Look(MakeShaderCompileRequest(Path, Entry.Name, Entry.Stage), IsSpirvFile(Path) ? nullptr : &Linter);
			++NumLooked;
		}
	}
	if (NumLooked == 0)
	{
		ThrowWhatIsWrong(MakeShaderCompileRequest(Path, Options.Entry, EShaderStage::Compute));
		throw FError({.Code = ErrorNoEntryPoint,
						 .Message = "no shader class names this file, and it has no entry point" +
									(Options.Entry.empty() ? std::string() : " '" + Options.Entry + "'") +
									": a function with [numthreads], or one that writes SV_Target" +
									SuggestName(Options.Entry, Names),
						 .File = Target},
			ExitUsage);
	}
}

/** Looks at all shaders that the config's frame compiles, and at every shader class of its plugins. */
void LintConfig(const std::string& Target, const FLintOptions& Options, FFound& Found)
{
	FRunOptions Run = Options.Run;
	Run.ConfigFile = Target;
	const FScopedCompileListener Listener([&Found](const FShaderCompileRequest& Request) { Found.Look(Request); });
	PrintDiagnostics(CheckRun(Run).Diagnostics);
}

void WriteRule(FJsonWriter& Writer, const FLintRule& Rule)
{
	Writer.Members({{"rule", Rule.Id}, {"severity", Rule.Severity == ESeverity::Error ? "error" : "warning"}});
	Writer.Key("platforms").BeginArray(true);
	for (size_t i = 0; i < GetLintPlatforms().size(); ++i)
	{
		if (Rule.Platforms >> i & 1)
		{
			Writer.Value(GetLintPlatforms()[i]);
		}
	}
	Writer.EndArray();
	Writer.Members({{"message", Rule.Sentence}, {"wayRound", Rule.WayRound}, {"source", Rule.Source}});
}

std::string MakeRulesText()
{
	std::string Text;
	for (const FLintRule& Rule : GetLintRules())
	{
		Text += fmt::format("{} [{}] ({})\n  {}; {}\n  {}\n", Rule.Severity == ESeverity::Error ? "error" : "warning",
			Rule.Id, DescribeLintPlatforms(Rule.Platforms), Rule.Sentence, Rule.WayRound, Rule.Source);
	}
	return Text;
}

std::string MakeRulesJson()
{
	FJsonWriter Writer('{');
	Writer.Objects("rules", GetLintRules(), [&](const FLintRule& Rule) { WriteRule(Writer, Rule); });
	return Writer.GetText();
}

std::string MakeLintJson(const FFound& Found)
{
	FJsonWriter Writer('{');
	Writer.Objects("findings", Found.Findings,
		[&](const FLintFinding& Finding)
		{
			Writer.Members({{"file", Finding.File}, {"line", Finding.Line}, {"what", Finding.What}});
			WriteRule(Writer, *Finding.Rule);
		});
	Writer.Member("shaders", static_cast<uint64_t>(Found.NumShaders));
	return Writer.GetText();
}

std::string MakeLintText(const FFound& Found)
{
	std::string Text;
	for (const FLintFinding& Finding : Found.Findings)
	{
		const FLintRule& Rule = *Finding.Rule;
		Text += fmt::format("{}{}: {}: {}{}: {} ({}) [{}]\n", Finding.File,
			Finding.Line > 0 ? ":" + std::to_string(Finding.Line) : "",
			Rule.Severity == ESeverity::Error ? "error" : "warning", Finding.What.empty() ? "" : Finding.What + ": ",
			Rule.Sentence, Rule.WayRound, DescribeLintPlatforms(uint8_t(Rule.Platforms & Found.Platforms)), Rule.Id);
	}
	return Text + fmt::format("{} {} looked at, {} {}\n", Found.NumShaders,
					  Found.NumShaders == 1 ? "shader" : "shaders", Found.Findings.size(),
					  Found.Findings.size() == 1 ? "finding" : "findings");
}

/** A case for each rule of the platforms. Rules of warnings do not fail. */
void AddCases(const FFound& Found, FJUnitSuite& Suite)
{
	for (const FLintRule& Rule : GetLintRules())
	{
		FJUnitCase Case{.Name = Rule.Id};
		for (const FLintFinding& Finding : Found.Findings)
		{
			if (Finding.Rule == &Rule)
			{
				Suite.Findings.push_back(
					{{.Severity = Rule.Severity,
						 .Message = (Finding.What.empty() ? "" : Finding.What + ": ") + Rule.Sentence + " (" +
									Rule.WayRound + ")",
						 .File = Finding.File.starts_with('/') ? FindShaderFile(Finding.File) : Finding.File,
						 .Line = Finding.Line},
						Rule.Id});
				std::string& Text = Rule.Severity == ESeverity::Error ? Case.Message : Case.Output;
				Text += Suite.Findings.back().Diagnostic.ToString() + "\n";
			}
		}
		Case.Outcome = Case.Message.empty() ? EJUnitOutcome::Passed : EJUnitOutcome::Failed;
		Suite.Cases.push_back(std::move(Case));
	}
}

int Lint(const FLintOptions& Options, FJUnitSuite& Suite)
{
	if (Options.bList)
	{
		PrintResult(Options.bJson ? MakeRulesJson() : MakeRulesText(), Options.bJson);
		return ExitDone;
	}
	if (Options.Targets.empty())
	{
		throw BadArgument("a shader or a config is missing; --list shows the rules");
	}
	FFound Found;
	Found.Platforms = GetPlatforms(Options);
	SetLintEngine(Options.EngineMinor);
	const auto Print = [&]
	{
		AddCases(Found, Suite);
		PrintResult(Options.bJson ? MakeLintJson(Found) : MakeLintText(Found), Options.bJson);
	};
	try
	{
		for (const std::string& Target : Options.Targets)
		{
			fs::path(Target).extension() == ".json" ? LintConfig(Target, Options, Found)
													: LintFile(Target, Options, Found);
		}
	}
	catch (const FError& Error)
	{
		if (!Found.Findings.empty()) // a shader that does not compile hides nothing of the others
		{
			Print();
		}
		throw FError(WithShownPaths(Error.GetDiagnostics()), Error.GetExitCode());
	}
	Print();
	const bool bFails = std::any_of(Found.Findings.begin(), Found.Findings.end(),
		[](const FLintFinding& Finding) { return Finding.Rule->Severity == ESeverity::Error; });
	return bFails ? ExitPolicy : ExitDone;
}

} // namespace

FVerbCall AddLintOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FLintOptions>();
	Verb.Add("SHADER", Options->Targets,
		"Shader files (.usf, .spv), by path or virtual path, or configs (.json): the shaders of their frames and all "
		"shader classes of their plugins");
	Verb.AddRepeated(
			"--platform", "", Options->Platforms, "Report only findings for this platform; repeats; all by default")
		.RequireOneOf(GetLintPlatforms());
	Verb.Add("--entry", Options->Entry, "Check only this entry point; all by default").SetType("NAME");
	Verb.Add("--engine-minor", Options->EngineMinor, "Report the engine's names that engine 5.X does not have")
		.SetType("X")
		.RequireRange(1, 99);
	AddVariables(Verb, Options->Run);
	AddPlugins(Verb, Options->Run);
	AddTrust(Verb, Options->Run);
	AddFindings(Verb, Options->Findings, "a case for each rule");
	Verb.AddFlag("--list", Options->bList, "List the rules, each with its source document");
	Verb.AddFlag("--json", Options->bJson, "Print JSON");
	return [Options]
	{
		const std::string About = Options->Targets.empty() ? "rules" : Options->Targets.front();
		return CallWithFindings(
			Options->Findings, "lint", About, [&Options](FJUnitSuite& Suite) { return Lint(*Options, Suite); });
	};
}

} // namespace Drydock
