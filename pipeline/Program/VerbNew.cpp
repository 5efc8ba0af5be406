// `drydock new`: makes a patch to begin with, of sources, shader, config, test and build file.
#include "InstallPaths.h"
#include "Patch/PatchErrors.h"
#include "Patch/PatchName.h"
#include "Patch/PatchTemplate.h"
#include "PrintText.h"
#include "Program/ArgumentParser.h"
#include "Program/ProgramOutput.h"
#include "Program/Verbs.h"
#include "RangeTools.h"
#include "Text/JsonWriter.h"
#include "Text/ShellText.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

struct FNewPatchOptions
{
	std::string Name;
	std::string Folder; // that the project's folder is made in; empty: here
	bool bJson = false;
};

void CheckName(const std::string& Name)
{
	const std::set<std::string> Taken = FindTakenNames();
	const std::string Why = ExplainBadPatchName(Name, Taken);
	if (Why.empty())
	{
		return;
	}
	const std::string Near = SuggestPatchName(Name, Taken);
	const std::string Hint = Near.empty() ? "; MyPatch would do" : "; did you mean " + Near + "?";
	throw FError(
		{.Code = ErrorPatchName, .Message = "\"" + Name + "\" cannot be a patch's name: " + Why + Hint}, ExitUsage);
}

/** The prefix that this program is installed in; empty when it runs from its build folder. */
std::string FindPrefix()
{
	const std::string Share = FindInstalled("share/drydock/templates");
	return Share.empty() ? std::string() : Files::path(Share).parent_path().parent_path().parent_path().string();
}

/** The commands to type next. */
std::vector<std::string> GetCommands(const std::string& Folder, const std::string& Name)
{
	const std::string Prefix = FindPrefix();
	return {
		"cd " + QuoteForShell(Folder),
		"cmake -B build -DCMAKE_PREFIX_PATH=" + (Prefix.empty() ? "PREFIX" : QuoteForShell(Prefix)),
		"cmake --build build",
		"ctest --test-dir build",
		"drydock run configs/" + Name + ".json",
	};
}

std::string MakePatchJson(
	const FNewPatchOptions& Options, const std::string& Folder, const std::vector<FPatchFile>& Project)
{
	FJsonWriter Writer('{');
	Writer.Members({{"name", Options.Name}, {"folder", Files::absolute(Folder).lexically_normal().string()}});
	Writer.Array("files", Project, [&](const FPatchFile& File) { Writer.Value(File.Path); });
	Writer.Array(
		"commands", GetCommands(Folder, Options.Name), [&](const std::string& Command) { Writer.Value(Command); });
	return Writer.GetText();
}

std::string MakePatchText(
	const FNewPatchOptions& Options, const std::string& Folder, const std::vector<FPatchFile>& Project)
{
	std::string Text = Folder + ": a patch of " + std::to_string(Project.size()) + " files\n";
	Text += ListLines(ToVector<std::string>(Project, &FPatchFile::Path));
	Text += FindPrefix().empty() ? "build and run it, with drydock installed by ./dev install PREFIX:\n"
								 : "build and run it:\n";
	return Text + ListLines(GetCommands(Folder, Options.Name));
}

int MakePatch(const FNewPatchOptions& Options)
{
	CheckName(Options.Name);
	const std::string Folder = (Files::path(Options.Folder) / Options.Name).string();
	const std::vector<FPatchFile> Project = MakePatchFiles(Options.Name);
	WritePatch(Folder, Project);
	PrintText(stdout, (Options.bJson ? MakePatchJson : MakePatchText)(Options, Folder, Project));
	return ExitDone;
}

} // namespace

FVerbCall AddNewOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FNewPatchOptions>();
	Verb.Add("NAME", Options->Name, "Name of the patch, such as MyPatch: a C++ identifier").Require();
	Verb.Add("--dir", Options->Folder, "Make the folder NAME in this folder; in the current one by default")
		.SetType("DIR");
	Verb.AddFlag("--json", Options->bJson, "Print JSON: name, folder, files and the next commands");
	return CallWith(Options, MakePatch);
}

} // namespace Drydock
