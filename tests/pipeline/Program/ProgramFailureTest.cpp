// Who is to blame for what: what the machine refuses is exit code 3 and named, and only what nobody foresaw is 70.
#include <gtest/gtest.h>

#include "DiagnosticList.h"
#include "Program/ProgramFailure.h"

#include <filesystem>
#include <new>
#include <system_error>

using namespace Drydock;

namespace
{

template<typename T>
std::pair<int, std::string> Explain(const T& Thrown)
{
	const FError Error = ExplainFailure(std::make_exception_ptr(Thrown));
	return {Error.GetExitCode(), Error.what()};
}

using FExplained = std::pair<int, std::string>;

} // namespace

TEST(ProgramFailure, WhatAVerbThrowsStaysAsItIs)
{
	const FError Error({.Code = 1012, .Message = "wrong"}, ExitUsage);
	EXPECT_EQ((FExplained{ExitUsage, "error DD1012: wrong"}), Explain(Error));
}

TEST(ProgramFailure, FilesThatTheSystemRefusesAreNamed)
{
	const std::error_code Loop = std::make_error_code(std::errc::too_many_symbolic_link_levels);
	EXPECT_EQ((FExplained{ExitFiles, "a/b: error DD5001: cannot access the file: Too many levels of symbolic links"}),
		Explain(std::filesystem::filesystem_error("status", "a/b", Loop)));
}

TEST(ProgramFailure, ThreadsAndMemoryAreTheMachines)
{
	const std::error_code Again = std::make_error_code(std::errc::resource_unavailable_try_again);
	EXPECT_EQ((FExplained{ExitFiles, "error DD5001: system error: Resource temporarily unavailable"}),
		Explain(std::system_error(Again)));
	EXPECT_EQ((FExplained{ExitFiles, "error DD5008: out of memory"}), Explain(std::bad_alloc()));
	EXPECT_EQ((FExplained{ExitFiles, "error DD5008: out of memory: 64 bytes are needed for the texture A, 4 x 4"}),
		Explain(MakeMemoryError("the texture A, 4 x 4", 64)));
}

TEST(ProgramFailure, OnlyWhatNobodyForesawIsDrydocksFault)
{
	EXPECT_EQ((FExplained{ExitInternal, "error: internal error: vector"}), Explain(std::out_of_range("vector")));
	EXPECT_EQ(ExitInternal, Explain(5).first);
}
