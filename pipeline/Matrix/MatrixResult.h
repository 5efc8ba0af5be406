// Holds the results of `drydock matrix` for one plugin under several engine versions: plain data, which table, JSON and
// tests read.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Drydock
{

/** A message of a compiler or of drydock. */
struct FMatrixMessage
{
	int Code = 0;           // 2070 of DD2070; 0: the compiler's, or no message of drydock's
	std::string File = {};  // of the plugin: relative to its folder; empty: none
	int Line = 0;           // 1-based, 0: unknown
	std::string Where = {}; // as in drydock's messages: "plugin libTint.so, SetupView of extension FTint"
	std::string Text = {};

	bool operator==(const FMatrixMessage&) const = default;
};

struct FMatrixBuild
{
	bool bBuilt = false;
	std::optional<FMatrixMessage> FirstError; // of a plugin that does not compile
	std::vector<FMatrixMessage> Warnings;     // of the compiler, each once
	std::vector<std::string> InEngine;        // names that the version lacks or deprecates; see FindVersionMessages
	std::vector<std::string> Notes;           // what was left out and why
	std::string Library;                      // path of the shared object
	std::string Log;                          // path of all that cmake and the compiler said
};

/** A texture that a pass wrote, by what it held then. */
using FMatrixTexture = std::pair<std::string, std::string>; // name, fingerprint

/** A pass of a frame, as run.json has it. */
struct FMatrixPass
{
	std::string Name; // of the event: "MyPatch 320x180"
	bool bExecuted = false;
	std::string Shader = {}; // class
	std::vector<FMatrixTexture> Written = {};
};

struct FMatrixRun
{
	int ExitCode = 0;                         // EExitCode; of one that a signal ended 128 and its number
	std::optional<FMatrixMessage> FirstError; // where ExitCode is not 0
	std::vector<FMatrixMessage> Warnings;
	std::vector<FMatrixPass> Passes;     // in the order of the graph, culled ones too
	std::vector<std::string> Extensions; // that subscribed, drew or were asked for something, each once
	std::string Folder;                  // of the outputs

	bool Ran() const { return ExitCode == 0; }
};

/** The difference of two pictures. */
struct FPictureDifference
{
	bool bOtherSize = false; // then nothing else is known
	double Max = 0.0;        // largest |a - b|, display-encoded; infinite where only one is finite
	uint64_t NumPixels = 0;  // that differ in any channel
	int X = 0;               // the first of them, row by row from the top
	int Y = 0;

	bool operator==(const FPictureDifference&) const = default;
};

struct FMatrixPicture
{
	std::string Fingerprint;
	std::optional<int> Before;                    // 5.x that it is compared with; none: it is the first
	std::optional<FPictureDifference> Difference; // from that one; none: the same bits
	std::optional<int> SameAs;                    // an older one that it equals, where it differs from Before
};

/** The first pass that parts from the version before. */
struct FPassDifference
{
	std::string Pass;
	std::string What; // "draws something else", "is new", ...

	bool operator==(const FPassDifference&) const = default;
};

/** One engine version. */
struct FMatrixRow
{
	int Minor = 0; // engine 5.Minor
	FMatrixBuild Build;
	std::optional<FMatrixRun> Run;         // where it was built
	std::optional<FMatrixPicture> Picture; // where it ran
	std::optional<FPassDifference> FirstDifference;

	bool Succeeded() const { return Build.bBuilt && Run && Run->Ran(); }
};

struct FVersionMatrix
{
	std::string Name;   // of the plugin
	std::string Folder; // of the plugin
	std::string Config; // that was run
	bool bStockConfig = false;
	std::string OutputFolder;
	std::vector<FMatrixRow> Rows; // by version, ascending
};

} // namespace Drydock
