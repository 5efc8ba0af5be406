// Text goes to stdout and stderr by PrintText alone, so that no stranger's text steers a terminal.
#include <gtest/gtest.h>

#include "IncludeGraph.h"

#include <algorithm>
#include <regex>
#include <set>

TEST(OutputStreams, AreWrittenByPrintText)
{
	// Some of these write text that only drydock makes, one writes where nothing may be called, one under a debugger.
	const std::set<std::string> Exceptions = {"rdg/core/Core/FaultHandlers.cpp", "pipeline/Program/EndingSignals.cpp",
		"pipeline/Program/ProgressBar.cpp", "pipeline/Program/ProgramOutput.cpp",
		"rdg/core/Kernel/DebugKernelSupport.h"};
	const std::regex Direct(
		"\\b(printf|puts|putchar|perror) ?\\(|\\bstd::(cout|cerr|clog)\\b|"
		"\\b(fprintf|vfprintf|fputs|fputc|fwrite|write)\\([^;]{0,300}\\b(stdout|stderr|STD(OUT|ERR)_FILENO)\\b");
	const char* const Words[] = {"printf", "puts", "putchar", "perror", "std::c", "stdout", "stderr", "_FILENO"};
	std::set<std::string> Found;
	for (const auto& [Path, Text] :
		Drydock::Test::ReadSources(DRYDOCK_TEST_SOURCE_DIR, {"rdg", "settings", "passes", "pipeline"}))
	{
		// Most files have none of these words: the search takes seconds, this takes none.
		const bool bMayWrite = std::any_of(std::begin(Words), std::end(Words),
			[&Source = Text](const char* Word) { return Source.find(Word) != std::string::npos; });
		std::smatch Match;
		if (bMayWrite && std::regex_search(Text, Match, Direct))
		{
			Found.insert(Path);
			EXPECT_TRUE(Exceptions.count(Path) > 0) << Path << " writes by itself: " << Match.str();
		}
	}
	EXPECT_EQ(Exceptions, Found);
}
