// The tree is in the house's format: clang-format has nothing to change in any C++ file.
#include <gtest/gtest.h>

#include "IncludeGraph.h"

#include <array>
#include <cstdio>

namespace
{

struct FProcess
{
	FILE* Pipe = nullptr;
	std::string Output;

	void Start(const std::string& Command) { Pipe = popen(Command.c_str(), "r"); }

	int Finish()
	{
		std::array<char, 4096> Buffer;
		while (const size_t Count = std::fread(Buffer.data(), 1, Buffer.size(), Pipe))
		{
			Output.append(Buffer.data(), Count);
		}
		return pclose(Pipe);
	}
};

const std::string GEnterRoot = "cd '" DRYDOCK_TEST_SOURCE_DIR "' && ";

} // namespace

TEST(Format, EveryFileIsFormatted)
{
	FProcess Version;
	Version.Start("clang-format --version 2>&1");
	ASSERT_EQ(0, Version.Finish()) << "clang-format is missing: ./dev setup installs it";

	// Two processes share the files.
	std::array<std::string, 2> Lists;
	size_t Index = 0;
	for (const auto& [Path, Text] : Drydock::Test::ReadSources(
			 DRYDOCK_TEST_SOURCE_DIR, {"rdg", "settings", "passes", "pipeline", "tests", "bench", "templates"}))
	{
		Lists[Index++ % Lists.size()] += " '" + Path + "'";
	}
	std::array<FProcess, 2> Processes;
	for (size_t List = 0; List < Lists.size(); ++List)
	{
		Processes[List].Start(GEnterRoot + "clang-format --dry-run --ferror-limit=1 -Werror" + Lists[List] + " 2>&1");
	}
	for (FProcess& Process : Processes)
	{
		EXPECT_EQ(0, Process.Finish()) << "not as " << Version.Output << "would write it (clang-format -i):\n"
									   << Process.Output;
	}
}
