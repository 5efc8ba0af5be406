// Runs a small scene of odd size in a test, and looks at the graph, the report and the pictures.
#pragma once

#include <gtest/gtest.h>

#include "Budget/RunOptions.h"
#include "Run/Run.h"
#include "Run/RunDump.h"
#include "Run/RunOutputs.h"
#include "Run/RunSetup.h"
#include "Text/ConfigErrors.h"
#include "Text/GlobPattern.h"
#include "Text/Json.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <unistd.h>

namespace RunTest
{

using namespace Drydock;

/** The source tree, with a slash at its end. */
inline const std::string Root = DRYDOCK_TEST_SOURCE_DIR "/";

/** A config of the odd-sized scene; More: further members of the root object. */
inline FRunOptions SmallScene(const std::string& More = "")
{
	FRunOptions Options;
	Options.ConfigFile = Root + "configs/test.json";
	Options.ConfigText =
		R"({"scene": {"file": "scenes/toon_character_641x359.exr"})" + (More.empty() ? "" : ", " + More) + "}";
	return Options;
}

inline FRunResult Compile(const std::string& More)
{
	FRunOptions Options = SmallScene(More);
	Options.bExecute = false;
	return RunConfig(Options);
}

inline int CountPasses(const FRDGCompiledGraph& Graph, bool bCulled)
{
	return static_cast<int>(std::count_if(Graph.Passes.begin(), Graph.Passes.end(),
		[&](const FRDGCompiledPass& Pass) { return !Pass.bIsSentinel && Pass.bCulled == bCulled; }));
}

/** Survivors whose name contains a text. */
inline int CountNamed(const FRDGCompiledGraph& Graph, const std::string& Part)
{
	return static_cast<int>(std::count_if(Graph.Passes.begin(), Graph.Passes.end(),
		[&](const FRDGCompiledPass& Pass)
		{ return !Pass.bIsSentinel && !Pass.bCulled && Pass.Name.find(Part) != std::string::npos; }));
}

/** "code exit" of the first error. */
inline std::string ErrorOf(const FRunOptions& Options)
{
	try
	{
		RunConfig(Options);
	}
	catch (const FError& Error)
	{
		for (const FDiagnostic& Diagnostic : Error.GetDiagnostics())
		{
			if (Diagnostic.Severity == ESeverity::Error)
			{
				return std::to_string(Diagnostic.Code) + " " + std::to_string(Error.GetExitCode());
			}
		}
	}
	return "none";
}

inline FJsonValue ParseReport(const std::string& Text)
{
	std::vector<FDiagnostic> Diagnostics;
	bool bSyntaxError = false;
	FJsonValue Value = ParseJson(Text, "run.json", Diagnostics, bSyntaxError);
	EXPECT_TRUE(Diagnostics.empty());
	return Value;
}

inline double MaxDifference(const FImage& A, const FImage& B)
{
	double Largest = 0.0;
	for (size_t Index = 0; Index < A.Values.size(); ++Index)
	{
		Largest = std::max(Largest, std::fabs(A.Values[Index] - B.Values[Index]));
	}
	return Largest;
}

inline std::filesystem::path MakeTemporaryFolder()
{
	const std::filesystem::path Folder =
		std::filesystem::temp_directory_path() / ("drydock_run_" + std::to_string(getpid()));
	std::filesystem::remove_all(Folder);
	return Folder;
}

inline std::string ReadBytes(const std::filesystem::path& Path)
{
	std::ifstream Stream(Path, std::ios::binary);
	return std::string(std::istreambuf_iterator<char>(Stream), {});
}

} // namespace RunTest
