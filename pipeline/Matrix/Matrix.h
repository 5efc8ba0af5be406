// `drydock matrix`: one plugin compiled for and run under several engine versions, each in a process of its own, with
// the results side by side.
#pragma once

#include "DrydockAPI.h"
#include "Matrix/MatrixResult.h"

#include <functional>
#include <string>
#include <vector>

namespace Drydock
{

struct FMatrixRequest
{
	std::string Folder;                // of the plugin
	std::string Config;                // empty: drydock's own small frame
	std::vector<int> Minors;           // ascending; see ParseMatrixVersions
	std::string OutputFolder;          // empty: build/NAME-matrix, below the working folder
	std::vector<std::string> Excludes; // as of FPluginBuild
	std::string Compiler;              // as of FPluginBuild
	std::string Program;               // drydock's own, which is started for each version; empty: this process's
	/** The text of matrix.html, which is written beside the others; none: it is not. */
	std::function<std::string(const FVersionMatrix& Matrix)> MakePage;
	/** Called from one thread at a time. */
	std::function<void(int Done, int Total, const std::string& What)> Progress;
};

/** Builds, runs, compares, and writes matrix.txt, matrix.json, matrix.png (the pictures side by side) and what MakePage
 * makes to the output folder; below it 5.X/ is the build of 5.X, 5.X/run/ its run. Failed builds and crashes are in the
 * result. Throws FError: exit code 2 where there is nothing to build or no tool to build it with, 3 where files cannot
 * be read or written. */
DRYDOCK_API FVersionMatrix RunMatrix(const FMatrixRequest& Request);

/** The config of drydock's own small frame. Throws FError (exit code 3) where it is not installed. */
DRYDOCK_API std::string FindStockConfig();

/** Path of the running program, to start it once more. Throws FError (exit code 3) where the system does not tell. */
DRYDOCK_API std::string FindThisProgram();

/** The arguments of `drydock run` for one version. */
DRYDOCK_API std::vector<std::string> MakeRunArguments(
	const std::string& Program, const FVersionMatrix& Matrix, const FMatrixRow& Row);

} // namespace Drydock
