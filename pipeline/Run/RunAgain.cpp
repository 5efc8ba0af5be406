// Turns run.json, and the place of the config in timing.json, into the options of the same run.
#include "Run/RunAgain.h"

#include "Text/ConfigErrors.h"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <filesystem>

namespace Drydock
{

namespace
{

FJsonValue ReadJsonFile(const std::string& File)
{
	std::vector<FDiagnostic> Diagnostics;
	bool bSyntaxError = false;
	FJsonValue Root = ParseJson(ReadTextFile(File), File, Diagnostics, bSyntaxError);
	if (HasErrors(Diagnostics))
	{
		throw FError(Diagnostics, ExitUsage);
	}
	return Root;
}

[[noreturn]] void Refuse(const std::string& File, const std::string& Message)
{
	throw FError({.Code = ErrorBadArgument, .Message = Message, .File = File, .Where = "--again"}, ExitUsage);
}

} // namespace

FRunAgain ReadRunAgain(const std::string& RunJson, const std::string& ConfigFile)
{
	const FJsonValue Root = ReadJsonFile(RunJson);
	if (Root.Find("arguments") == nullptr || Root.Find("passes") == nullptr)
	{
		Refuse(RunJson, "this is not the run.json of a run that records how to repeat it");
	}
	if (Root.Find("history") != nullptr)
	{
		Refuse(RunJson, "this frame began with the history of the frame before: repeat its sequence, with --frames");
	}
	FRunAgain Again;
	Again.Options.ConfigFile = ConfigFile;
	if (ConfigFile.empty())
	{
		const std::filesystem::path Folder = std::filesystem::path(RunJson).parent_path();
		const std::string Timing = (Folder / "timing.json").string();
		const std::string Config = TryReadTextFile(Timing) ? ReadJsonFile(Timing).GetString("config") : std::string();
		if (Config.empty())
		{
			Refuse(RunJson, "timing.json, which names the place of " + Root.GetString("config") +
								", is not beside it: name the config too");
		}
		Again.Options.ConfigFile = (Folder / Config).lexically_normal().string();
	}
	std::vector<std::string> Words;
	for (const FJsonValue& Word : Root.GetElements("arguments"))
	{
		Words.push_back(Word.String);
	}
	if (!TakeRunArguments(Words, Again.Options.ConfigFile, Again.Options))
	{
		Refuse(RunJson, "its arguments are not those of this drydock: " + JoinText(Words, " "));
	}
	if (const FJsonValue* const Inputs = Root.Find("inputs"))
	{
		for (const FJsonMember& Input : Inputs->Members)
		{
			Again.Inputs[Input.Key] = Input.Value.String;
		}
	}
	Again.Options.bRecordInputs = true;
	return Again;
}

std::vector<FDiagnostic> FindChangedInputs(const FRunInputs& Before, const FRunInputs& Now, const std::string& RunJson)
{
	const std::vector<std::string> Changes = DescribeChanges(Before, Now);
	if (Changes.empty())
	{
		return {};
	}
	return {{.Severity = ESeverity::Warning,
		.Code = WarnInputsChanged,
		.Message = "the run is not the same any more: " + JoinText(Changes, ", "),
		.File = RunJson,
		.Where = "--again"}};
}

} // namespace Drydock
