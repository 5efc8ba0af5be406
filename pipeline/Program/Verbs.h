// The program's verbs: one function each, from options to exit code, in a file of its own (VerbRun.cpp, ...). stdout is
// the result, stderr the log. They throw FError; Main prints it and exits with its code. Source: drydock.
#pragma once

#include "Budget/RunOptions.h"
#include "Diagnostics.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

class FJsonWriter;
struct FEffectDecision;
struct FRunResult;

/** Arguments that several verbs have. */
struct FVerbOptions
{
	FRunOptions Run;
	std::string OutputFolder; // empty: GetDefaultOutputFolder
	std::string Format = "text";
	bool bJson = false;
	bool bWatch = false;
	std::string Frames;             // run: a list of frames (FrameList.h); empty: the config's, or one frame
	bool bRestart = false;          // run: render frames again that are there
	std::string Video;              // run: file of a video of the frames; empty: none
	std::string At;                 // blend: "X,Y,Z", cm; empty: the view's location
	std::vector<std::string> Names; // blend: settings, with * and ?; empty: those that changed
	std::string Pass;               // explain: this one, by name or index
	std::string Effect;             // explain: this one
	bool bMeasure = false;          // explain: run the frame, with and without skipping
	std::string Path;               // blend: a file of points, or "scene"; empty: one place only
	std::optional<int> Steps;       // between two points of the path
};

/** Runs the frames of a sequence and writes each into its folder, sequence.json, and a video where one is asked for. */
DRYDOCK_API int RunSequenceVerb(const FVerbOptions& Options);

/** Runs the frame and writes its outputs; with bWatch again and again, until interrupted. */
DRYDOCK_API int RunVerb(const FVerbOptions& Options);

/** Reads and validates everything, runs nothing. */
DRYDOCK_API int CheckVerb(const FVerbOptions& Options);

/** Prints the settings at a place, and the story of each: text or JSON. */
DRYDOCK_API int BlendVerb(const FVerbOptions& Options);

/** Walks Options.Path and writes walk.csv and walk.svg; prints the weights at its points, text or JSON. */
DRYDOCK_API int BlendPathVerb(const FVerbOptions& Options);

/** Prints which effects and passes run, which do not, why, and what is saved by it; or of one pass, effect or setting.
 */
DRYDOCK_API int ExplainVerb(const FVerbOptions& Options);

/** Prints the compiled graph: text, dot, svg (needs Graphviz's dot) or json. */
DRYDOCK_API int GraphVerb(const FVerbOptions& Options);

/** Things: passes, settings, effects, extensions, hooks. Filter: only names that contain it; for hooks a config, whose
 * chain is listed. */
DRYDOCK_API int ListVerb(const std::string& Things, const std::string& Filter, bool bJson);

/** Prints the console variables whose name matches Filter (FilterConsoleVariables); of a single one its whole help.
 * With a config, --set or --exec: as these set them. */
DRYDOCK_API int ListVariablesVerb(const FVerbOptions& Options, const std::string& Filter);

/** Arguments of `new`. */
struct FNewPatchOptions
{
	std::string Name;
	std::string Folder; // that the project's folder is made in; empty: here
	bool bJson = false;
};

/** Makes a patch of that name: sources, shader, config, test, build file. Overwrites nothing. */
DRYDOCK_API int NewVerb(const FNewPatchOptions& Options);

/** Arguments of `settings`. */
struct FSettingsVerbOptions
{
	std::string File;                  // engine text or config; "-": stdin
	std::optional<std::string> Volume; // only the volume of this name
	std::string At;                    // "X,Y,Z", cm: the settings there, blended, in place of the volumes
	bool bFull = false;                // not only what differs from the defaults
	bool bStruct = false;              // the settings alone, without an actor around them
	bool bUpgrade = false;             // as the engine upgrades old assets
	bool bJson = false;
};

/** Engine text to the volumes of a config. */
DRYDOCK_API int SettingsImportVerb(const FSettingsVerbOptions& Options);

/** The volumes of a config to engine text. */
DRYDOCK_API int SettingsExportVerb(const FSettingsVerbOptions& Options);

/** Arguments of `settings plan`. */
struct FSettingsPlanOptions
{
	std::string Name;
	std::string Type;    // of a setting that the table does not have
	std::string Default; // likewise, and what follows; empty: left to the plan
	std::string Category;
	std::string Doc;
	bool bJson = false;
};

/** Every place that an engine patch for one setting touches. */
DRYDOCK_API int SettingsPlanVerb(const FSettingsPlanOptions& Options);

/** Runs the study of the config; prints its table, or study.json, and writes study.json, study.csv, study_taps.svg and,
 * with times, study_timing.json, study_timing.csv, study.svg; and study_insets.svg with insets/. */
DRYDOCK_API int StudyVerb(const FVerbOptions& Options);

/** Arguments of `diff`. */
struct FDiffOptions
{
	std::string A; // an image, or the folder of a run
	std::string B; // likewise: what A is measured against
	std::optional<double> Max;
	std::string HeatMap; // PNG to write; of two folders the folder for one of each image; empty: none
	bool bJson = false;
};

/** Prints error figures between two images, or between two runs picture by picture. ExitPolicy where one is above Max,
 * or is there once only. Throws FError when they cannot be compared. */
DRYDOCK_API int DiffVerb(const FDiffOptions& Options);

/** Arguments of `sheet`. */
struct FSheetVerbOptions
{
	std::vector<std::string> Pictures; // files, or folders of runs
	std::string OutputFile;
	std::vector<std::string> Captions; // of the first pictures, in place of their names
	int Columns = 0;                   // 0: chosen
	int TileWidth = 320;
	std::string Crop;  // "X,Y,WIDTH,HEIGHT"; empty: all
	std::string Inset; // "X,Y,WIDTH,HEIGHT[,GAIN]"; empty: none
};

/** Puts pictures side by side into one. */
DRYDOCK_API int SheetVerb(const FSheetVerbOptions& Options);

/** Compiles the shaders of configs into the cache (in Folder, or the usual place when that is empty). */
DRYDOCK_API int WarmVerb(const std::vector<std::string>& Configs, const std::string& Folder);

/** As JSON, for editors and scripts: an array of objects. */
DRYDOCK_API void WriteDiagnostics(FJsonWriter& Writer, const std::vector<FDiagnostic>& Diagnostics);

/** "X,Y,Z" of --at, in cm. Throws FError (exit code 2). */
std::array<double, 3> ParseLocation(const std::string& Text);

/** Prints diagnostics to stderr, one a line, coloured on a terminal (unless NO_COLOR is set). */
DRYDOCK_API void PrintDiagnostics(const std::vector<FDiagnostic>& Diagnostics);

/** One line for each effect that was configured and does not run, and why. */
DRYDOCK_API std::vector<std::string> MakeClosingLines(const std::vector<FEffectDecision>& Effects);

/** What a person wants to know of a run: passes with times, memory, where the picture is. */
DRYDOCK_API std::string MakeRunSummary(const FRunResult& Result, const std::string& Folder, double SaveMs);

} // namespace Drydock
