// glslang in a process that is kept: one for all shaders, and the next one where it ends.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "CacheTestUtils.h"
#include "FrontEndProcess.h"
#include "ShaderFrontEnd.h"
#include "ShaderSource.h"

#include <csignal>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::HasSubstr;

std::vector<uint32_t> Compile(const std::string& Value, const std::string& Comment = "")
{
	const FShaderHarness Harness = MakeCacheShader(Value, Comment);
	return CompileToSpirv(FlattenShader(Harness.Request), Harness.Request);
}

/** Processes of that program whose parent is this process. */
std::vector<pid_t> ListFrontEnds()
{
	std::vector<pid_t> Result;
	std::error_code Ignored;
	for (const fs::directory_entry& Entry : fs::directory_iterator("/proc", Ignored))
	{
		const pid_t Process = std::atoi(Entry.path().filename().c_str());
		const std::string Status = Process > 0 ? ReadBytes(Entry.path() / "stat") : std::string();
		const size_t NameEnd = Status.rfind(") ");
		char State = 0;
		int Parent = 0;
		if (NameEnd != std::string::npos && Status.find("(drydock_front_") != std::string::npos &&
			std::sscanf(Status.c_str() + NameEnd + 2, "%c %d", &State, &Parent) == 2 && Parent == getpid() &&
			State != 'Z')
		{
			Result.push_back(Process);
		}
	}
	return Result;
}

} // namespace

TEST(FrontEndProcess, IsStartedOnceForAllShaders)
{
	Compile("1");
	const FFrontEndCounts Before = GetFrontEndCounts();
	for (int Value = 2; Value <= 5; ++Value)
	{
		Compile(std::to_string(Value));
	}
	const FFrontEndCounts After = GetFrontEndCounts();
	EXPECT_EQ(4, After.Shaders - Before.Shaders);
	EXPECT_EQ(0, After.Processes - Before.Processes);
	EXPECT_EQ(1u, ListFrontEnds().size());
}

TEST(FrontEndProcess, GivesTheSameWordsEveryTime)
{
	const std::vector<uint32_t> First = Compile("6");
	EXPECT_NE(First, Compile("7"));
	EXPECT_EQ(First, Compile("6"));
}

TEST(FrontEndProcess, ThatWasKilledIsReplacedWithoutAWord)
{
	const std::vector<uint32_t> Words = Compile("8");
	const std::vector<pid_t> Processes = ListFrontEnds();
	ASSERT_EQ(1u, Processes.size());
	kill(Processes[0], SIGKILL);
	EXPECT_EQ(Words, Compile("8"));
	EXPECT_NE(Processes, ListFrontEnds());
	EXPECT_EQ(1u, ListFrontEnds().size());
}

TEST(FrontEndProcess, ThatHangsIsEndedAndTheNextShaderGetsAnother)
{
	const std::vector<uint32_t> Words = Compile("9");
	const std::vector<pid_t> Processes = ListFrontEnds();
	ASSERT_EQ(1u, Processes.size());
	const FScopedVariable Limit("DRYDOCK_GLSLANG_SECONDS", "1");
	kill(Processes[0], SIGSTOP);
	EXPECT_THAT(ErrorOf([] { Compile("10"); }), HasSubstr("error DD6012: glslang took longer than 1 s on 'Main'"));
	EXPECT_TRUE(ListFrontEnds().empty());
	EXPECT_EQ(Words, Compile("9"));
}

TEST(FrontEndProcess, ACrashNamesTheLineAndTheNextShaderGetsAnother)
{
	// glslang's parser calls itself for every parenthesis, until its stack ends
	const std::string Deep = std::string(400000, '(') + "1" + std::string(400000, ')');
	const std::string Error = ErrorOf([&] { Compile("11", "// first\nstatic const float Deep = " + Deep + ";"); });
	EXPECT_THAT(Error, HasSubstr("/Test/Shader.usf:2: error: glslang was ended by signal 11 on 'Main'"));
	EXPECT_FALSE(Compile("12").empty());
}

TEST(FrontEndProcess, AChildThatForkedOffHasItsOwn)
{
	const std::vector<uint32_t> Words = Compile("13");
	const pid_t Child = fork();
	if (Child == 0)
	{
		_exit(Compile("13") == Words && ListFrontEnds().size() == 1 ? 0 : 1);
	}
	int Status = 1;
	waitpid(Child, &Status, 0);
	EXPECT_EQ(0, Status);
	EXPECT_EQ(Words, Compile("13"));
}

TEST(FrontEndProcess, ServesThreadsInTurn)
{
	const std::vector<uint32_t> Words[2] = {Compile("14"), Compile("15")};
	std::vector<std::thread> Threads;
	std::vector<uint32_t> Results[8];
	for (int Index = 0; Index < 8; ++Index)
	{
		Threads.emplace_back([&Results, Index] { Results[Index] = Compile(Index % 2 == 0 ? "14" : "15"); });
	}
	for (std::thread& Thread : Threads)
	{
		Thread.join();
	}
	for (int Index = 0; Index < 8; ++Index)
	{
		EXPECT_EQ(Words[Index % 2], Results[Index]);
	}
	EXPECT_EQ(1u, ListFrontEnds().size());
}
