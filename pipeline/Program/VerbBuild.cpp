// `drydock build`: a plugin's folder, as the engine has it, becomes a shared object that a config can name.
#include "Diagnostics.h"
#include "Extensions/Plugins.h"
#include "Patch/EngineApi.h"
#include "Patch/PluginBuild.h"
#include "Program/ProgramOutput.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Text/JsonWriter.h"
#include "Text/TextFile.h"

#include <filesystem>
#include <memory>

namespace Drydock
{

namespace
{

struct FBuildOptions
{
	FPluginBuild Build;
	bool bJson = false;
};

std::string MakeBuildJson(const FBuiltPlugin& Built)
{
	FJsonWriter Writer('{');
	Writer.Members({{"name", Built.Name}, {"engine", "5." + std::to_string(Built.EngineMinor)},
		{"library", std::filesystem::absolute(Built.Library).lexically_normal().string()}});
	Writer.Array("notes", Built.Notes, [&](const std::string& Note) { Writer.Value(Note); });
	return Writer.GetText();
}

std::string MakeBuildText(const FBuiltPlugin& Built)
{
	return Built.Name + ": built for engine 5." + std::to_string(Built.EngineMinor) + "\n" + ListLines(Built.Notes) +
		   Built.Library + "\n";
}

int Build(const FBuildOptions& Options)
{
	FPluginBuild Named = Options.Build;
	const bool bNamed = Named.EngineMinor != 0;
	Named.EngineNames = bNamed ? 2 : 1; // a version that was asked for is held to
	const FBuiltPlugin Built = BuildPlugin(Named);
	std::string Lines; // a run of the plugin repeats them
	const std::filesystem::path Folder = std::filesystem::path(Built.Library).parent_path().parent_path();
	for (const std::string& Message : FindVersionMessages(RememberBuildSteps(Folder)))
	{
		Lines += !bNamed && Message.find(" does not have ") != std::string::npos ? Message + "\n" : "";
	}
	WriteTextFile(GetVersionNotesFile(Built.Library), Lines);
	PrintResult((Options.bJson ? MakeBuildJson : MakeBuildText)(Built), Options.bJson);
	return ExitDone;
}

} // namespace

FVerbCall AddBuildOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FBuildOptions>();
	Verb.Add("PLUGIN_DIR", Options->Build.Folder, "Folder of a plugin, with its .uplugin").Require();
	Verb.Add("--out", Options->Build.BuildFolder, "Folder of the build; build/NAME by default").SetType("DIR");
	Verb.Add("--name", Options->Build.Name, "Name of the library; the name of the .uplugin by default").SetType("NAME");
	Verb.Add("--engine-minor", Options->Build.EngineMinor,
			"Compile for engine 5.X, and refuse names that it does not have; by default for the version in the "
			".uplugin or "
			".uproject, else for 5.4")
		.SetType("X")
		.RequireRange(1, 99);
	Verb.AddRepeated("--exclude", "PATTERN", Options->Build.Excludes,
		"Leave out a file, folder or module: a path relative to PLUGIN_DIR, or a name; with * and ?");
	Verb.Add("--compiler", Options->Build.Compiler, "C++ compiler; CMake's choice by default").SetType("PATH");
	Verb.AddFlag("--json", Options->bJson, "Print JSON: name, engine, library and the files left out");
	return CallWith(Options, Build);
}

} // namespace Drydock
