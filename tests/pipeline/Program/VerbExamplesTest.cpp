// The examples that --help prints: each verb has two or three, all of them run, and --help ends with them.
#include <gtest/gtest.h>

#include "../ProgramTestUtils.h"

#include "Program/CommandLine.h"

#include <algorithm>
#include <cstdlib>
#include <map>

using namespace Drydock;
using namespace ProgramTest;

namespace
{

/** Verbs whose examples compile a plugin take minutes: the long test runs them (DRYDOCK_EXAMPLES=all). */
bool IsLong(const FVerbExample& Example)
{
	return std::ranges::any_of(std::initializer_list<const char*>{"build", "matrix", "vet"},
		[&](const std::string& Verb) { return Example.Verb == Verb; });
}

/** The arguments as the test calls them, and the exit code. `live` runs until somebody ends it. */
std::pair<std::string, int> MakeCall(const FVerbExample& Example)
{
	const std::string Arguments = Example.GetCommand().substr(sizeof("drydock ") - 1);
	return std::string(Example.Verb) == "live"
			   ? std::pair("live --no-open" + Arguments.substr(4) + " & sleep 3; kill -TERM $!; wait $!", 128 + 15)
			   : std::pair(Arguments, 0);
}

} // namespace

TEST(VerbExamples, EachVerbHasTwoOrThreeAndItsHelpEndsWithThem)
{
	std::map<std::string, int> Counts;
	for (const FVerbExample& Example : GetVerbExamples())
	{
		++Counts[Example.Verb];
		EXPECT_LE(Example.GetCommand().size() + 2, 80u) << Example.GetCommand();
	}
	const FProgramFolder Folder("examples_help");
	for (const FVerbModel& Verb : MakeProgramModel())
	{
		const std::string Help = Folder.Call(Verb.Name + " --help").Printed;
		const size_t At = Help.rfind("Examples:\n");
		ASSERT_NE(std::string::npos, At) << Verb.Name;
		const long Lines = std::count(Help.begin() + static_cast<long>(At), Help.end(), '\n') - 1;
		EXPECT_GE(Lines, 2) << Verb.Name;
		EXPECT_LE(Lines, Verb.Verbs.empty() || Verb.Name.empty() ? 3 : 2 * static_cast<long>(Verb.Verbs.size()))
			<< Verb.Name;
		EXPECT_TRUE(!Verb.Verbs.empty() || Counts[Verb.Name] >= 2) << Verb.Name;
		Counts.erase(Verb.Name);
	}
	EXPECT_TRUE(Counts.empty()) << Counts.begin()->first << " is not a verb";
}

TEST(VerbExamples, AllRunInTheirOrder)
{
	const FProgramFolder Folder("examples");
	unsetenv("CI"); // a build server cannot bless, and the examples are a person's
	Files::create_directories(Folder.Path / "out");
	Files::create_symlink(DRYDOCK_TEST_SOURCE_DIR "/configs", Folder.Path / "configs");
	const char* const All = std::getenv("DRYDOCK_EXAMPLES");
	for (const FVerbExample& Example : GetVerbExamples())
	{
		if (All != nullptr || !IsLong(Example))
		{
			const auto [Call, ExitCode] = MakeCall(Example);
			const FOutcome Outcome = Folder.Call(Call);
			EXPECT_EQ(ExitCode, Outcome.ExitCode) << Example.GetCommand() << "\n" << Outcome.Printed;
		}
	}
}
