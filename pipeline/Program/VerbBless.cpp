// `drydock bless`: a person accepts the pictures of a run as a baseline, which `drydock diff --baseline` compares with.
#include "Program/Baseline.h"
#include "Program/ProgramOutput.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Text/ConfigErrors.h"

#include <cstdlib>
#include <filesystem>
#include <memory>

namespace Drydock
{

namespace
{

namespace fs = std::filesystem;

struct FBlessOptions
{
	std::string Run;
	std::string Folder;  // empty: baselines/NAME of the run's folder
	std::string Because; // the reason
};

std::vector<std::string> ListFiles(const std::string& Run)
{
	std::vector<std::string> Names;
	std::error_code Error;
	for (const char* const Name : {"final.exr", "final.png", "scene_linear.exr"})
	{
		if (fs::is_regular_file(fs::path(Run) / Name, Error))
		{
			Names.emplace_back(Name);
		}
	}
	for (fs::directory_iterator Entry(fs::path(Run) / "passes", Error), End; !Error && Entry != End;
		 Entry.increment(Error))
	{
		if (Entry->path().extension() == ".exr")
		{
			Names.push_back("passes/" + Entry->path().filename().string());
		}
	}
	if (Names.empty())
	{
		throw FError(
			{.Code = ErrorFileMissing, .Message = "is not the folder of a run: it has no final.exr", .File = Run},
			ExitFiles);
	}
	return Names;
}

int Bless(const FBlessOptions& Options)
{
	if (const char* const Ci = std::getenv("CI"); Ci != nullptr && *Ci != '\0' && std::string(Ci) != "false")
	{
		throw BadArgument(
			"a build server (CI is set) cannot accept a picture; a person runs drydock bless and commits the baseline");
	}
	if (Options.Because.find_first_not_of(" \t") == std::string::npos)
	{
		throw BadArgument("a reason is missing, such as --because \"the glow is wider now\"", "--because");
	}
	const fs::path Run = (fs::path(Options.Run) / ".").lexically_normal().parent_path();
	const std::string Folder =
		Options.Folder.empty() ? (fs::path("baselines") / Run.filename()).string() : Options.Folder;
	const std::vector<std::string> Files = ListFiles(Options.Run);
	WriteBaseline(Options.Run, Folder, Files, Options.Because);
	PrintResult(Folder + ": a baseline of " + std::to_string(Files.size()) + " files\n" + ListLines(Files) +
				"compare with it: drydock diff " + Options.Run + " " + Folder + " --baseline --max 0\n");
	return ExitDone;
}

} // namespace

FVerbCall AddBlessOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FBlessOptions>();
	Verb.Add("RUN", Options->Run, "Folder of a run").Require();
	Verb.Add("--to", Options->Folder, "Folder of the baseline; baselines/NAME of the run by default").SetType("DIR");
	Verb.Add("--because", Options->Because, "Reason that the pictures are right, for the record")
		.SetType("REASON")
		.Require();
	return CallWith(Options, Bless);
}

} // namespace Drydock
