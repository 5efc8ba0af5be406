// The program: parses the command line, calls a verb, turns errors into exit codes. Source: drydock.
#include <CLI/CLI.hpp>

#include "Program/Verbs.h"

#include "Text/Version.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <map>

namespace
{

using namespace Drydock;

/** Options that repeat take one value each, so that a config may follow them. */
void AddRepeated(CLI::App& Verb, const char* Name, const char* Type, std::vector<std::string>& Values, const char* Doc)
{
	Verb.add_option(Name, Values, Doc)
		->expected(1)
		->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
		->allow_extra_args(false)
		->type_name(Type);
}

/** --set and --exec keep their order among each other. */
void AddVariables(CLI::App& Verb, FVerbOptions& Options)
{
	const auto Add = [&Verb](const char* Name, const char* Type,
						 const std::function<void(const std::string&)>& Function, const char* Doc)
	{
		Verb.add_option_function<std::string>(Name, Function, Doc)
			->expected(1)
			->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
			->trigger_on_parse()
			->type_name(Type);
	};
	FRunOptions& Run = Options.Run;
	Add(
		"--set", "r.NAME=VALUE", [&Run](const std::string& Text) { Run.Variables.push_back(Text); },
		"Set a console variable; repeats; beats the config");
	Add(
		"--exec", "\"A 1, B\"",
		[&Run](const std::string& Text) {
			Run.Exec.push_back({Text, Run.Variables.size()});
		},
		"Tell the console: \"r.A 1, r.B=2, r.C\" sets two, prints the third; repeats; beats --set");
}

void AddConfig(CLI::App& Verb, FVerbOptions& Options)
{
	Verb.add_option("CONFIG", Options.Run.ConfigFile, "JSON config, such as configs/toon_bloom.json")->required();
	AddVariables(Verb, Options);
	AddRepeated(
		Verb, "--pp", "SETTING=VALUE", Options.Run.Settings, "Set a post-process setting; repeats; beats all volumes");
	Verb.add_option("--frame", Options.Run.Frame, "Which frame of a sequence, by default the first; shaders see it too")
		->check(CLI::Range(0, 1 << 30).description(""))
		->type_name("N");
}

void AddArithmetic(CLI::App& Verb, FVerbOptions& Options)
{
	Verb.add_option_function<std::string>(
			"--precision", [&Options](const std::string& Name) { Options.Run.bDouble = Name == "double"; },
			"Arithmetic of the shaders: float (default) or double, with 64-bit storage")
		->type_name("float|double")
		->check(CLI::IsMember({"float", "double"}).description(""));
	static const std::map<std::string, ERunStorage> Storages = {
		{"native", ERunStorage::Native}, {"float32", ERunStorage::Float32}, {"float64", ERunStorage::Float64}};
	Verb.add_option_function<std::string>(
			"--storage", [&Options](const std::string& Name) { Options.Run.Storage = Storages.at(Name); },
			"Storage of textures: native (their own formats, default), float32, float64")
		->type_name("native|float32|float64")
		->check(CLI::IsMember({"native", "float32", "float64"}).description(""));
	Verb.add_option_function<int>(
			"--threads", [&Options](int Threads) { Options.Run.Threads = Threads; },
			"Threads; 0: all cores (default). The result is the same bits for any number")
		->check(CLI::Range(0, 1024).description(""))
		->type_name("N");
}

void AddSheetVerb(CLI::App& Program, FSheetVerbOptions& Options, int& ExitCode)
{
	CLI::App* Sheet = Program.add_subcommand("sheet", "Put pictures side by side into one, each with a caption");
	Sheet->add_option("PICTURE", Options.Pictures, "Pictures, or folders of runs, whose final.png it is")->required();
	Sheet->add_option("--out", Options.OutputFile, "The picture to write")->type_name("FILE.png")->required();
	Sheet->add_option("--columns", Options.Columns, "Pictures in a row; by default as many as rows")
		->check(CLI::Range(1, 100).description(""))
		->type_name("N");
	Sheet->add_option("--width", Options.TileWidth, "Width of each picture in pixels; 320 by default")
		->check(CLI::Range(16, 4096).description(""))
		->type_name("N");
	AddRepeated(*Sheet, "--caption", "TEXT", Options.Captions,
		"Of the first picture, then of the second ...; repeats; by default the name of file or folder");
	Sheet->add_option("--crop", Options.Crop, "Only this part of each picture")->type_name("X,Y,WIDTH,HEIGHT");
	Sheet->add_option("--inset", Options.Inset, "This part once more beneath, enlarged, its light times GAIN")
		->type_name("X,Y,WIDTH,HEIGHT[,GAIN]");
	Sheet->callback([&] { ExitCode = SheetVerb(Options); });
}

/** The verbs under `settings`. */
void AddSettingsVerbs(
	CLI::App& Settings, FSettingsVerbOptions& Options, FSettingsPlanOptions& PlanOptions, int& ExitCode)
{
	Settings.require_subcommand(1);
	CLI::App* Import =
		Settings.add_subcommand("import", "Print the config's \"volumes\" of settings or actors copied in the editor");
	Import->add_option("TEXT", Options.File, "File of engine text, or - for stdin")->required();
	Import->add_flag("--upgrade", Options.bUpgrade,
		"As the engine upgrades assets from before convolution bloom had an intensity: BM_FFT sets intensities to 1");
	Import->add_flag("--json", Options.bJson, "Print an object of volumes and messages");
	Import->callback([&] { ExitCode = SettingsImportVerb(Options); });

	CLI::App* Export =
		Settings.add_subcommand("export", "Print the volumes of a config as actors to paste into the editor");
	Export->add_option("CONFIG", Options.File, "JSON config")->required();
	CLI::Option* Volume =
		Export->add_option("--volume", Options.Volume, "Only the volume of this name")->type_name("NAME");
	Export->add_option("--at", Options.At, "What all volumes and the camera come to at this place, cm, as one volume")
		->type_name("X,Y,Z")
		->excludes(Volume);
	Export->add_flag("--struct", Options.bStruct, "Only the settings (..), to paste into a volume's Settings");
	Export->add_flag("--full", Options.bFull, "All settings, not only those that are overridden or changed");
	Export->callback([&] { ExitCode = SettingsExportVerb(Options); });

	CLI::App* Plan = Settings.add_subcommand("plan", "Print every place that an engine patch for one setting touches");
	Plan->add_option("SETTING", PlanOptions.Name, "Name, such as BloomToonIntensity")->required();
	Plan->add_option("--type", PlanOptions.Type, "Of a setting that is not in the table: float, bool, int, color, ...")
		->type_name("TYPE");
	Plan->add_option("--default", PlanOptions.Default, "Likewise its default; 0 by default")->type_name("VALUE");
	Plan->add_option("--category", PlanOptions.Category, "Likewise its category")->type_name("A|B");
	Plan->add_option("--doc", PlanOptions.Doc, "Likewise its description")->type_name("TEXT");
	Plan->add_flag("--json", PlanOptions.bJson, "Print an array of places");
	Plan->callback([&] { ExitCode = SettingsPlanVerb(PlanOptions); });
}

/** What is wrong with the arguments, in one sentence with the nearest verb or option where that is what was misspelt.
 */
std::string ExplainMistake(
	const CLI::App& Program, const std::vector<std::string>& Arguments, const std::string& Otherwise)
{
	const auto Explain = [](const char* Kind, const std::string& Name, const std::vector<std::string>& Candidates)
	{
		const std::string Nearest = FindNearestName(Name, Candidates);
		return std::string("there is no ") + Kind + " " + Name +
			   (Nearest.empty() ? "" : "; did you mean " + Nearest + "?");
	};
	const CLI::App* Chosen = &Program;
	for (size_t Level = 0; Chosen->get_subcommands([](const CLI::App*) { return true; }).size() > 0; ++Level)
	{
		std::vector<std::string> Verbs;
		const CLI::App* Next = nullptr;
		for (const CLI::App* Verb : Chosen->get_subcommands([](const CLI::App*) { return true; }))
		{
			Verbs.push_back(Verb->get_name());
			Next = Level < Arguments.size() && Verb->get_name() == Arguments[Level] ? Verb : Next;
		}
		if (Next == nullptr)
		{
			return Level < Arguments.size() ? Explain("verb", Arguments[Level], Verbs)
				   : Level == 0             ? "a verb is missing: run, check, explain, blend, graph or list"
											: "a verb is missing after " + Arguments[Level - 1];
		}
		Chosen = Next;
	}
	std::vector<std::string> Options;
	for (const CLI::Option* Option : Chosen->get_options())
	{
		Options.push_back(Option->get_name());
	}
	for (const std::string& Argument : Arguments)
	{
		const std::string Name = Argument.substr(0, Argument.find('='));
		if (Name.rfind("--", 0) == 0 && std::find(Options.begin(), Options.end(), Name) == Options.end())
		{
			return Explain("option", Name, Options);
		}
	}
	return Otherwise;
}

/** CLI11's words to ours. */
void SetLabels(CLI::App& Program)
{
	Program.get_formatter()->label("SUBCOMMAND", "VERB ...");
	Program.get_formatter()->label("REQUIRED", "");
	Program.get_formatter()->label("TEXT", "");
	Program.get_formatter()->column_width(34);
}

int ParseAndRun(int NumArguments, char** Arguments)
{
	CLI::App Program("drydock runs Unreal-style post-process passes on a rendered frame, on the CPU.", "drydock");
	Program.set_version_flag("--version", std::string("drydock ") + GetVersion());
	Program.require_subcommand(1);
	SetLabels(Program);
	Program.footer(
		"Exit codes: 0 done, 1 a policy failed, 2 usage, config or graph error, 3 a file cannot be read or written,\n"
		"70 a fault of drydock's own. `drydock VERB --help` explains a verb.");
	FVerbOptions Options;
	int ExitCode = ExitDone;

	CLI::App* Run = Program.add_subcommand("run", "Run the frame of a config and write its pictures and reports");
	AddConfig(*Run, Options);
	AddArithmetic(*Run, Options);
	Run->add_option("--out", Options.OutputFolder, "Folder for the outputs; out/NAME of the config by default")
		->type_name("DIR");
	AddRepeated(*Run, "--dump", "PATTERN", Options.Run.Dump,
		"Keep what matches: a pass, a resource or Pass.Resource, with * and ?; repeats");
	Run->add_flag("--no-skip", Options.Run.bNoSkip,
		"Leave nothing out because nobody needs it: slower, the same bits; what is switched off stays off");
	Run->add_flag("--measure-effects", Options.Run.bMeasureEffects,
		"Measure what effects come to (bleed of toon bloom, banding of the toon shadow) and add it to run.json");
	CLI::Option* Frames =
		Run->add_option("--frames", Options.Frames,
			   "Frames of a sequence, each with what lives on from the one before: all, 1-8, 1-9x2 (every second) or "
			   "1,3,5-8; the config's scene.frames by default. A run that was stopped goes on where it stood")
			->type_name("LIST")
			->excludes(Run->get_option("--frame"));
	Run->add_flag("--restart", Options.bRestart, "Render all frames again, whatever the folder holds");
	Run->add_option("--video", Options.Video, "Video of the frames, such as walk.mp4; needs ffmpeg")->type_name("FILE");
	Run->add_flag("--watch", Options.bWatch, "Run again whenever the config, its scene or a shader changes")
		->excludes(Frames);
	Run->add_flag("--json", Options.bJson, "Print run.json instead of the summary");
	Run->callback([&] { ExitCode = RunVerb(Options); });

	CLI::App* Check = Program.add_subcommand("check", "Read and validate a config and its scene's header; run nothing");
	AddConfig(*Check, Options);
	Check->add_flag("--json", Options.bJson, "Print the messages as JSON");
	Check->callback([&] { ExitCode = CheckVerb(Options); });

	CLI::App* Blend =
		Program.add_subcommand("blend", "Print the post-process settings at a place, and how each came about");
	AddConfig(*Blend, Options);
	CLI::Option* At =
		Blend->add_option("--at", Options.At, "Where, in cm; the view's location by default")->type_name("X,Y,Z");
	CLI::Option* Path = Blend
							->add_option("--path", Options.Path,
								"Along these points: a JSON file, or \"scene\" for the cameras of the scene's frames")
							->type_name("FILE|scene")
							->excludes(At);
	Blend->add_option("--steps", Options.Steps, "Places between two points of the path; some 240 in all by default")
		->check(CLI::Range(0, 100000).description(""))
		->type_name("N")
		->needs(Path);
	Blend->add_option("--out", Options.OutputFolder, "Folder for walk.csv and walk.svg; out/NAME by default")
		->type_name("DIR")
		->needs(Path);
	AddRepeated(*Blend, "--setting", "NAME", Options.Names,
		"Only these settings, with * and ?; repeats; by default those that changed");
	Blend->add_flag("--json", Options.bJson, "Print all settings with their whole ledger as JSON");
	Blend->callback([&] { ExitCode = Options.Path.empty() ? BlendVerb(Options) : BlendPathVerb(Options); });

	CLI::App* Graph = Program.add_subcommand("graph", "Print the compiled graph of a config without running it");
	AddConfig(*Graph, Options);
	AddArithmetic(*Graph, Options);
	Graph->add_option("--format", Options.Format, "text (default), dot, svg (needs Graphviz) or json")
		->check(CLI::IsMember({"text", "dot", "svg", "json"}).description(""))
		->type_name("F");
	Graph->add_flag("--json", Options.bJson, "The same as --format json");
	Graph->callback([&] { ExitCode = GraphVerb(Options); });

	CLI::App* Study = Program.add_subcommand("study", "Measure what accuracy costs: the variants of a config's study");
	AddConfig(*Study, Options);
	Study
		->add_option_function<int>(
			"--threads", [&Options](int Threads) { Options.Run.Threads = Threads; }, "Threads; 0: all cores (default)")
		->check(CLI::Range(0, 1024).description(""))
		->type_name("N");
	Study
		->add_option("--out", Options.OutputFolder, "Folder for tables and pictures; out/NAME of the config by default")
		->type_name("DIR");
	Study->add_flag("--json", Options.bJson, "Print study.json instead of the table");
	Study->callback([&] { ExitCode = StudyVerb(Options); });

	FDiffOptions DiffOptions;
	CLI::App* Diff =
		Program.add_subcommand("diff", "Print how far two images are apart, or two runs picture by picture");
	Diff->add_option("A", DiffOptions.A, "Image, or folder of a run")->required();
	Diff->add_option("B", DiffOptions.B, "What A is measured against: another one of the same kind and size")
		->required();
	Diff->add_option("--max", DiffOptions.Max, "Exit code 1 where a value differs by more than this")
		->check(CLI::NonNegativeNumber.description(""))
		->type_name("M");
	Diff->add_option("--heatmap", DiffOptions.HeatMap,
			"PNG of where the error is, over four decades of it; of two runs a folder, with one of each picture")
		->type_name("FILE");
	Diff->add_flag("--json", DiffOptions.bJson, "Print the figures as JSON");
	Diff->callback([&] { ExitCode = DiffVerb(DiffOptions); });

	CLI::App* Explain = Program.add_subcommand(
		"explain", "Print which effects and passes run, which do not and why, and what leaving out saves");
	AddConfig(*Explain, Options);
	AddArithmetic(*Explain, Options);
	CLI::Option* Pass = Explain
							->add_option("--pass", Options.Pass,
								"Only this pass, by name or index: what it reads and "
								"writes, who reads that, why it is culled")
							->type_name("PASS");
	CLI::Option* Effect = Explain->add_option("--effect", Options.Effect, "Only this effect, with its passes")
							  ->type_name("EFFECT")
							  ->excludes(Pass);
	AddRepeated(
		*Explain, "--setting", "NAME", Options.Names, "How this setting came about, as `drydock blend` says it");
	Explain->get_option("--setting")->excludes(Pass)->excludes(Effect);
	Explain->add_flag("--measure", Options.bMeasure,
		"Run the frame as it is and with --no-skip, interleaved, and give medians in place of estimates");
	Explain->add_flag("--json", Options.bJson, "Print effects, passes and costs as JSON");
	Explain->callback([&] { ExitCode = Options.Names.empty() ? ExplainVerb(Options) : BlendVerb(Options); });

	std::string Things;
	std::string Filter;
	CLI::App* List =
		Program.add_subcommand("list", "List what there is: passes, settings, cvars, effects, extensions, hooks");
	List->add_option("THINGS", Things, "passes, settings, cvars, effects, extensions or hooks")->required();
	List->add_option("FILTER", Filter,
		"Only names that contain this, or match it where it has * or ? (settings, cvars), ignoring case; for hooks a "
		"config, whose chain is listed");
	List->add_option("--config", Options.Run.ConfigFile, "cvars: as this config sets them")->type_name("CONFIG");
	AddVariables(*List, Options);
	List->add_flag("--json", Options.bJson, "Print an array of objects");
	List->callback(
		[&] {
			ExitCode = Things == "cvars" ? ListVariablesVerb(Options, Filter) : ListVerb(Things, Filter, Options.bJson);
		});

	FSheetVerbOptions SheetOptions;
	AddSheetVerb(Program, SheetOptions, ExitCode);

	FSettingsVerbOptions SettingsOptions;
	FSettingsPlanOptions PlanOptions;
	AddSettingsVerbs(
		*Program.add_subcommand("settings", "Engine paste text of settings to and from configs: import, export, plan"),
		SettingsOptions, PlanOptions, ExitCode);

	FNewPatchOptions NewOptions;
	CLI::App* New =
		Program.add_subcommand("new", "Make a patch to begin with: sources, shader, config, test, build file");
	New->add_option("NAME", NewOptions.Name, "Name of the patch, such as MyPatch: a C++ identifier")->required();
	New->add_option("--dir", NewOptions.Folder, "Folder that the folder NAME is made in; here by default")
		->type_name("DIR");
	New->add_flag("--json", NewOptions.bJson, "Print name, folder, files and the commands to go on with");
	New->callback([&] { ExitCode = NewVerb(NewOptions); });

	std::vector<std::string> Configs;
	std::string CacheFolder;
	CLI::App* Warm = Program.add_subcommand("warm", "Compile the shaders of configs into the shader cache");
	Warm->add_option("CONFIG", Configs, "JSON configs")->required();
	Warm->add_option("--cache", CacheFolder, "Folder of the cache; the usual one by default")->type_name("DIR");
	Warm->callback([&] { ExitCode = WarmVerb(Configs, CacheFolder); });

	for (CLI::App* Verb : Program.get_subcommands([](const CLI::App*) { return true; }))
	{
		Verb->group("Verbs");
	}
	try
	{
		Program.parse(NumArguments, Arguments);
	}
	catch (const CLI::Success& Success)
	{
		return Program.exit(Success, std::cout, std::cerr); // --help and --version
	}
	catch (const CLI::ParseError& Error)
	{
		const std::string Mistake = ExplainMistake(Program, {Arguments + 1, Arguments + NumArguments}, Error.what());
		std::fprintf(stderr, "drydock: %s\nTry drydock --help.\n", Mistake.c_str());
		return ExitUsage;
	}
	return ExitCode;
}

} // namespace

int main(int NumArguments, char** Arguments)
{
	try
	{
		return ParseAndRun(NumArguments, Arguments);
	}
	catch (const Drydock::FError& Error)
	{
		Drydock::PrintDiagnostics(Error.GetDiagnostics());
		return Error.GetExitCode();
	}
	catch (const std::exception& Error)
	{
		std::fprintf(stderr, "drydock: internal error: %s\n", Error.what());
		return Drydock::ExitInternal;
	}
}
