// `drydock vet`: everything that drydock can find in a plugin, by one verb with one table.
#include "ChildProcess.h"
#include "Matrix/Matrix.h"
#include "Patch/PluginBuild.h"
#include "Program/FindingsOption.h"
#include "Program/ProgramOutput.h"
#include "Program/ProgressBar.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Text/ConfigErrors.h"
#include "Text/Fmt.inl"
#include "Text/Json.h"
#include "Text/JsonWriter.h"
#include "Text/TextFile.h"
#include "Text/TextTable.h"
#include "TextTools.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>

namespace Drydock
{

namespace
{

namespace fs = std::filesystem;

constexpr int StepSeconds = 1800;

struct FVetOptions
{
	std::string Folder; // of the plugin
	std::string Config; // empty: drydock's own small frame
	std::string Output; // empty: build/NAME-vet
	FFindingsOptions Findings;
	bool bJson = false;
};

struct FVetRow
{
	std::string Step;
	int ExitCode = ExitDone;
	double Seconds = 0.0;
	size_t NumErrors = 0;
	size_t NumWarnings = 0;
	std::string First;                 // of the findings; of none what the step has to say
	std::vector<FDiagnostic> Messages; // of a build that failed
};

double GetSecondsSince(std::chrono::steady_clock::time_point Begin)
{
	return std::chrono::duration<double>(std::chrono::steady_clock::now() - Begin).count();
}

/** Builds the plugin. Empty: it does not compile, which the row tells. */
std::string Build(const FVetOptions& Options, const std::string& Output, FVetRow& Row)
{
	FPluginBuild Request;
	Request.Folder = Options.Folder;
	Request.BuildFolder = Output + "/build";
	try
	{
		const FBuiltPlugin Built = BuildPlugin(Request);
		Row.First = Built.Library;
		return Built.Library;
	}
	catch (const FError& Error)
	{
		PrintDiagnostics(Error.GetDiagnostics());
		Row.ExitCode = Error.GetExitCode();
		Row.Messages = Error.GetDiagnostics();
		Row.NumErrors = Row.Messages.size();
		const std::string& Message = Error.GetDiagnostics().front().Message;
		Row.First = Message.substr(0, Message.find('\n'));
		return "";
	}
}

std::string MakeOneLine(const std::string& Text)
{
	return JoinText(SplitText(Text), " ", [](const std::string& Line) { return Trim(Line); });
}

/** Counts the findings of a SARIF file, and takes them over. */
void ReadFindings(const std::string& File, FVetRow& Row, FJUnitSuite& Suite)
{
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = false;
	const FJsonValue Root = ParseJson(TryReadTextFile(File).value_or(""), File, Ignored, bSyntaxError);
	const std::vector<FJsonValue>& Runs = Root.GetElements("runs");
	for (const FJsonValue& Result : Runs.empty() ? Runs : Runs.front().GetElements("results"))
	{
		const std::string Level = Result.GetString("level");
		const FJsonValue* const Message = Result.Find("message");
		const std::string Text = Message != nullptr ? Message->GetString("text") : "";
		const bool bError = Level == "error";
		Row.NumErrors += bError ? 1 : 0;
		Row.NumWarnings += Level == "warning" ? 1 : 0;
		if (Level != "note")
		{
			const bool bFirstError = bError && Row.NumErrors == 1;
			Row.First = Row.First.empty() || bFirstError ? MakeOneLine(Text) : Row.First;
			Suite.Findings.push_back(
				{{.Severity = bError ? ESeverity::Error : ESeverity::Warning, .Message = Row.Step + ": " + Text},
					Result.GetString("ruleId")});
		}
	}
}

FVetRow RunStep(
	const std::string& Step, std::vector<std::string> Arguments, const std::string& Output, FJUnitSuite& Suite)
{
	FVetRow Row;
	Row.Step = Step;
	const auto Begin = std::chrono::steady_clock::now();
	const std::string Sarif = Output + "/" + Step + ".sarif";
	Arguments.insert(Arguments.begin(), FindThisProgram());
	Arguments.insert(Arguments.end(), {"--sarif", Sarif, "--junit", Output + "/" + Step + ".xml"});
	const FChildResult Child = RunChild(Arguments, StepSeconds);
	constexpr int FirstSignal = 128;
	Row.ExitCode = Child.Signal > 0                     ? FirstSignal + Child.Signal
				   : Child.bStarted && !Child.bTimedOut ? Child.ExitCode
														: ExitInternal;
	Row.Seconds = GetSecondsSince(Begin);
	WriteTextFile(Output + "/" + Step + ".log", Child.Output);
	ReadFindings(Sarif, Row, Suite);
	if (Row.First.empty() && !Child.Succeeded())
	{
		Row.First = Child.Describe(StepSeconds) + "; see " + Output + "/" + Step + ".log";
	}
	return Row;
}

std::string DescribeRow(const FVetRow& Row)
{
	const auto Count = [](size_t Number, const char* What)
	{
		return Number == 0 ? "" : fmt::format("{} {}{}", Number, What, Number == 1 ? "" : "s");
	};
	const std::string Errors = Count(Row.NumErrors, "error");
	const std::string Warnings = Count(Row.NumWarnings, "warning");
	const std::string Both = Errors + (Errors.empty() || Warnings.empty() ? "" : ", ") + Warnings;
	return !Both.empty() ? Both : Row.ExitCode == ExitDone ? "ok" : fmt::format("exit code {}", Row.ExitCode);
}

std::string MakeVetTable(const std::vector<FVetRow>& Rows)
{
	FTextTable Table{{{ETextColumn::Name}, {ETextColumn::Name}, {ETextColumn::Number}, {ETextColumn::Text}},
		{{"step", "result", "s", ""}}};
	for (const FVetRow& Row : Rows)
	{
		Table.Rows.push_back({Row.Step, DescribeRow(Row), fmt::format("{:.1f}", Row.Seconds), Row.First});
	}
	return Table.Format(GetOutputWidth());
}

std::string MakeVetJson(const std::vector<FVetRow>& Rows)
{
	FJsonWriter Writer('{');
	Writer.Objects("steps", Rows,
		[&](const FVetRow& Row)
		{
			Writer.Members({{"step", Row.Step}, {"exitCode", Row.ExitCode}, {"seconds", Row.Seconds},
				{"errors", static_cast<uint64_t>(Row.NumErrors)}, {"warnings", static_cast<uint64_t>(Row.NumWarnings)},
				{"first", Row.First}});
		});
	Writer.Key("messages");
	WriteDiagnostics(Writer, Rows.front().Messages);
	return Writer.GetText();
}

int Vet(const FVetOptions& Options, FJUnitSuite& Suite)
{
	const std::string Name = FindPluginName(Options.Folder);
	const std::string Output = Options.Output.empty() ? "build/" + Name + "-vet" : Options.Output;
	const std::string Config = Options.Config.empty() ? FindStockConfig() : Options.Config;
	std::vector<FVetRow> Rows(1);
	Rows.front().Step = "build";
	FProgressBar Bar;
	constexpr int NumSteps = 6;
	Bar.Show(0, NumSteps, "build");
	const auto Begin = std::chrono::steady_clock::now();
	const std::string Library = Build(Options, Output, Rows.front());
	Rows.front().Seconds = GetSecondsSince(Begin);
	const std::vector<std::string> Common = {Config, "--plugin", Library};
	const std::vector<std::pair<const char*, std::vector<std::string>>> Steps = {
		{"check", {}}, {"lint", {}}, {"run", {"--out", Output + "/run"}}, {"prove", {}}, {"hazards", {}}};
	for (const auto& [Step, More] : Steps)
	{
		const bool bRuns =
			!Library.empty() && (Rows.size() < 3 || Rows[1].ExitCode <= ExitPolicy); // not what check refused
		if (bRuns)
		{
			Bar.Show(static_cast<int>(Rows.size()), NumSteps, Step);
			std::vector<std::string> Arguments = {Step};
			Arguments.insert(Arguments.end(), Common.begin(), Common.end());
			Arguments.insert(Arguments.end(), More.begin(), More.end());
			Rows.push_back(RunStep(Step, Arguments, Output, Suite));
		}
	}
	Bar.Clear();
	int ExitCode = ExitDone;
	for (const FVetRow& Row : Rows)
	{
		ExitCode = std::max(ExitCode, Row.ExitCode);
		Suite.Cases.push_back({.Name = Row.Step,
			.Outcome = Row.ExitCode == ExitDone ? EJUnitOutcome::Passed : EJUnitOutcome::Failed,
			.Message = Row.ExitCode == ExitDone ? "" : DescribeRow(Row) + "; " + Row.First,
			.Output = Row.ExitCode == ExitDone ? DescribeRow(Row) : "",
			.Seconds = Row.Seconds});
	}
	Suite.Name = Name + " on " + (Options.Config.empty() ? "drydock's own small frame" : Options.Config);
	PrintResult(Options.bJson ? MakeVetJson(Rows)
							  : Suite.Name + "\n" + MakeVetTable(Rows) + "logs and findings: " + Output + "\n",
		Options.bJson);
	return ExitCode;
}

} // namespace

FVerbCall AddVetOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FVetOptions>();
	Verb.Add("PLUGIN_DIR", Options->Folder, "Folder of a plugin, with its .uplugin").Require();
	Verb.Add("CONFIG", Options->Config,
		"Run the plugin in this JSON config, which need not name it; in a small built-in frame by default");
	Verb.Add("--out", Options->Output, "Folder for the build, the run, logs and findings; build/NAME-vet by default")
		.SetType("DIR");
	AddFindings(Verb, Options->Findings, "a case for each step");
	Verb.AddFlag("--json", Options->bJson, "Print the table as JSON");
	return [Options]
	{
		return CallWithFindings(
			Options->Findings, "vet", Options->Folder, [&Options](FJUnitSuite& Suite) { return Vet(*Options, Suite); });
	};
}

} // namespace Drydock
