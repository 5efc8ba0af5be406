// Compilers that hang, are killed, crash, or have nowhere to write: each ends in a message that names whose fault it
// is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "CacheTestUtils.h"
#include "ChildProcess.h"
#include "TemporaryFolder.h"
#include "ToolFault.h"

#include <chrono>
#include <csignal>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class FCompilerFaults : public testing::Test
{
protected:
	/** A shader of the test's own, with the C++ compiler that this script is. */
	FShaderRun RunWithCompiler(const std::string& Script) const
	{
		const FScopedVariable Compiler("DRYDOCK_CXX", Scratch.AddScript("compiler", Script));
		return RunCacheShader("31");
	}

	/** The same with a compiler of HLSL. */
	FShaderRun RunWithFrontEnd(const std::string& Script, const std::string& Comment = "") const
	{
		const FScopedVariable FrontEnd("DRYDOCK_HLSL_COMPILER", Scratch.AddScript("dxc", Script));
		return RunCacheShader("31", Comment);
	}

	const FScratchFolder Scratch;
	const FScratchFolder Temporary;
	const FScopedVariable Cache{"DRYDOCK_CACHE_DIR", (Scratch.Path / "cache").string()};
	const FScopedVariable Parent{"TMPDIR", Temporary.Path.string()};
};

/** RunCacheShader in a process that can write no more than so many bytes to a file, as on a full disk. */
FShaderRun RunWithFileLimit(rlim_t Bytes, const std::string& Comment)
{
	int Pipe[2];
	if (pipe(Pipe) != 0)
	{
		return {};
	}
	const pid_t Child = fork();
	if (Child == 0)
	{
		std::signal(SIGXFSZ, SIG_IGN); // so that writes fail
		const rlimit Limit{Bytes, Bytes};
		setrlimit(RLIMIT_FSIZE, &Limit);
		ForgetCompiledShaders();
		FShaderRun Run;
		try
		{
			FShaderHarness Harness = MakeCacheShader("32", Comment);
			Harness.Run(4, 4, 1);
			Run.Value = Harness.BufferFloat("Out", 2);
		}
		catch (const FError& Error)
		{
			Run.ExitCode = Error.GetExitCode();
			Run.Error = Error.what();
		}
		const std::string Text = std::to_string(Run.ExitCode) + " " + std::to_string(Run.Value) + " " + Run.Error;
		_exit(write(Pipe[1], Text.data(), Text.size()) == ssize_t(Text.size()) ? 0 : 1);
	}
	close(Pipe[1]);
	std::string Text;
	char Buffer[4096];
	for (ssize_t Count; (Count = read(Pipe[0], Buffer, sizeof(Buffer))) > 0;)
	{
		Text.append(Buffer, size_t(Count));
	}
	close(Pipe[0]);
	int Status = 0;
	waitpid(Child, &Status, 0);
	EXPECT_EQ(0, Status);
	FShaderRun Run;
	std::istringstream Stream(Text);
	Stream >> Run.ExitCode >> Run.Value;
	std::getline(Stream >> std::ws, Run.Error, '\0');
	return Run;
}

} // namespace

TEST_F(FCompilerFaults, ClangCompilesKernelsAsGccDoes)
{
	const std::string Clang = FindProgram("clang++");
	if (Clang.empty())
	{
		GTEST_SKIP() << "there is no clang++";
	}
	const FScopedVariable Compiler("DRYDOCK_CXX", Clang);
	const FShaderRun Run = RunCacheShader("31");
	EXPECT_EQ("", Run.Error);
	EXPECT_EQ(31.0f, Run.Value);
}

TEST_F(FCompilerFaults, OneThatHangsIsEndedWithAllItStarted)
{
	const fs::path Number = Scratch.Path / "number";
	const FScopedVariable Limit("DRYDOCK_CXX_SECONDS", "1");
	const auto Start = std::chrono::steady_clock::now();
	const FShaderRun Run = RunWithCompiler("sleep 100 & echo $! >" + Number.string() + "; wait");
	EXPECT_LT(std::chrono::steady_clock::now() - Start, std::chrono::seconds(60));
	EXPECT_EQ(ExitUsage, Run.ExitCode);
	EXPECT_THAT(Run.Error,
		AllOf(HasSubstr("/Test/Shader.usf: error DD6033: the C++ compiler took longer than 1 s"), HasSubstr("'Main'")));

	const pid_t Started = std::atoi(ReadBytes(Number).c_str());
	ASSERT_GT(Started, 0);
	const auto IsRunning = [Started]
	{
		const std::string Status = ReadBytes("/proc/" + std::to_string(Started) + "/stat");
		return !Status.empty() && Status.find(") Z ") == std::string::npos;
	};
	for (int Look = 0; Look < 100 && IsRunning(); ++Look)
	{
		std::this_thread::sleep_for(std::chrono::milliseconds(50));
	}
	EXPECT_FALSE(IsRunning());
	EXPECT_TRUE(ListFiles(Temporary.Path).empty());
}

TEST_F(FCompilerFaults, OneThatWasKilledIsSaidToBe)
{
	const FShaderRun Run = RunWithCompiler("kill -KILL $$");
	EXPECT_EQ(ExitFiles, Run.ExitCode);
	EXPECT_THAT(Run.Error, HasSubstr("DD6032: the C++ compiler was killed by signal 9 (out of memory?)"));
	EXPECT_THAT(Run.Error, Not(HasSubstr("fault of drydock")));
}

TEST_F(FCompilerFaults, OneWhoseProgramWasKilledIsSaidToBe)
{
	const char* const OfGcc = "g++: fatal error: Killed signal terminated program cc1plus";
	const char* const OfClang = "clang: error: unable to execute command: Killed";
	for (const char* const Line : {OfGcc, OfClang})
	{
		const FShaderRun Run = RunWithCompiler(std::string("echo '") + Line + "' >&2; exit 1");
		EXPECT_EQ(ExitFiles, Run.ExitCode);
		EXPECT_THAT(Run.Error, HasSubstr("was killed by signal 9 (out of memory?)")) << Line;
	}
}

TEST_F(FCompilerFaults, OneThatRunsShortNamesWhatItLacks)
{
	const FShaderRun Run =
		RunWithCompiler("echo '/x/cc.s: Fatal error: cannot write: No space left on device'; exit 1");
	EXPECT_EQ(ExitFiles, Run.ExitCode);
	EXPECT_THAT(Run.Error, HasSubstr("DD6032"));
	EXPECT_THAT(Run.Error, HasSubstr("No space left on device"));
}

TEST_F(FCompilerFaults, OneThatWritesNothingIsSaidTo)
{
	for (const char* const Script : {"exit 0", "while [ \"$1\" != -o ]; do shift; done; mkfifo \"$2\""})
	{
		const FShaderRun Run = RunWithCompiler(Script);
		EXPECT_EQ(ExitUsage, Run.ExitCode);
		EXPECT_THAT(Run.Error, AllOf(HasSubstr("DD6031"), HasSubstr("ended well and wrote no kernel")));
	}
}

TEST_F(FCompilerFaults, OneThatIsNoProgramIsSaidToBe)
{
	const FScopedVariable Compiler("DRYDOCK_CXX", Scratch.Add("compiler", "\x7f"
																		  "ELF"));
	chmod((Scratch.Path / "compiler").c_str(), 0700);
	const FShaderRun Run = RunCacheShader("31");
	EXPECT_EQ(ExitFiles, Run.ExitCode);
	EXPECT_THAT(Run.Error, HasSubstr("the C++ compiler could not be started"));
}

TEST_F(FCompilerFaults, CodeThatItRefusesIsKeptUnderANameThatNobodyGuesses)
{
	const std::string Victim = Scratch.Add("victim", "precious");
	fs::create_symlink(Victim, Temporary.Path / "drydock-failed-Main.cpp");
	const FShaderRun Run = RunWithCompiler("echo 'kernel.cpp:7: error: no'; exit 1");
	EXPECT_EQ(ExitInternal, Run.ExitCode);
	EXPECT_EQ("precious", ReadBytes(Victim));
	EXPECT_THAT(Run.Error, AllOf(HasSubstr("DD6030"), HasSubstr(": kernel.cpp:7: error: no")));

	const std::string Before = "(the code is in ";
	const size_t At = Run.Error.find(Before) + Before.size();
	const fs::path Kept = Run.Error.substr(At, Run.Error.find(')', At) - At);
	EXPECT_EQ(Temporary.Path, Kept.parent_path());
	EXPECT_THAT(ReadBytes(Kept), HasSubstr("DrydockShaderKernel"));
	EXPECT_EQ(0600, GetMode(Kept));

	const FShaderRun Again = RunWithCompiler("echo 'kernel.cpp:7: error: no'; exit 1");
	EXPECT_NE(Run.Error, Again.Error);
}

TEST_F(FCompilerFaults, ToolsSpeakEnglishAndWriteWhereAllOfItGoes)
{
	const fs::path Seen = Scratch.Path / "seen";
	const FScopedVariable Language("LC_ALL", "de_DE.UTF-8");
	RunWithCompiler("echo \"$LC_ALL $TMPDIR\" >" + Seen.string() + "; exit 1");
	EXPECT_THAT(ReadBytes(Seen), StartsWith("C " + (Temporary.Path / "drydock-").string()));
}

TEST_F(FCompilerFaults, AMissingTemporaryFolderIsNamed)
{
	const std::string Missing = (Scratch.Path / "missing").string();
	const FScopedVariable Variable("TMPDIR", Missing);
	const FShaderRun Run = RunCacheShader("33");
	EXPECT_EQ(ExitFiles, Run.ExitCode);
	EXPECT_THAT(Run.Error,
		AllOf(StartsWith(Missing + ": error DD5004: "), HasSubstr("No such file or directory"), HasSubstr("TMPDIR")));
}

TEST_F(FCompilerFaults, ATemporaryFolderThatIsAFileIsNamed)
{
	const std::string File = Scratch.Add("file", "");
	const FScopedVariable Variable("TMPDIR", File);
	const FShaderRun Run = RunCacheShader("33");
	EXPECT_EQ(ExitFiles, Run.ExitCode);
	EXPECT_THAT(Run.Error, AllOf(StartsWith(File + ": error DD5004: "), HasSubstr("Not a directory")));
}

TEST_F(FCompilerFaults, AFullDiskIsNamedAndLeavesNothingHalf)
{
	const std::string Comment = "// " + std::string(2000, 'x'); // text above the first limits, SPIR-V below it
	int NumFailed = 0;
	for (const rlim_t Bytes : {0, 100, 1000, 2300, 3000, 6000, 12000, 40000})
	{
		const FShaderRun Run = RunWithFileLimit(Bytes, Comment);
		if (Run.ExitCode == 0)
		{
			EXPECT_EQ(32.0f, Run.Value) << Bytes << " bytes";
			continue;
		}
		++NumFailed;
		EXPECT_EQ(ExitFiles, Run.ExitCode) << Bytes << " bytes: " << Run.Error;
		EXPECT_THAT(Run.Error, HasSubstr("File too large")) << Bytes << " bytes";
		EXPECT_TRUE(ListFiles(Temporary.Path).empty()) << Bytes << " bytes";
	}
	EXPECT_GE(NumFailed, 4);
	const FShaderRun Whole = RunCacheShader("32", Comment);
	EXPECT_EQ("", Whole.Error);
	EXPECT_EQ(32.0f, Whole.Value);
}

TEST_F(FCompilerFaults, ASpirvFileThatIsCutShortOnAFullDiskIsNoFaultOfTheShader)
{
	const FScopedVariable Compiler("DRYDOCK_HLSL_COMPILER",
		Scratch.AddScript("dxc", "while [ \"$1\" != -Fo ]; do shift; done; head -c 4000 /dev/zero >\"$2\"; exit 0"));
	const FShaderRun Run = RunWithFileLimit(1000, ""); // less than the module, more than the text
	EXPECT_EQ(ExitFiles, Run.ExitCode);
	EXPECT_THAT(
		Run.Error, AllOf(StartsWith(Temporary.Path.string()), HasSubstr("DD5004"), HasSubstr("File too large")));
}

TEST_F(FCompilerFaults, TheWordsOfACompilerThatFailsAreShown)
{
	const FShaderRun Run = RunWithFrontEnd("echo \"invalid source type 'hlsl'\"; exit 3");
	EXPECT_EQ(ExitUsage, Run.ExitCode);
	EXPECT_THAT(Run.Error, HasSubstr("dxc ended with exit code 3 on 'Main'; its words:\ninvalid source type 'hlsl'"));
}

TEST_F(FCompilerFaults, ACrashOfACompilerOfHlslIsNamed)
{
	const FShaderRun Run = RunWithFrontEnd("kill -SEGV $$");
	EXPECT_EQ(ExitUsage, Run.ExitCode);
	EXPECT_THAT(Run.Error, HasSubstr("dxc was ended by signal 11 on 'Main' and wrote nothing"));
}

TEST_F(FCompilerFaults, ACompilerOfHlslThatWasKilledIsNoFaultOfTheShader)
{
	const FShaderRun Run = RunWithFrontEnd("kill -KILL $$");
	EXPECT_EQ(ExitFiles, Run.ExitCode);
	EXPECT_THAT(Run.Error, HasSubstr("DD6032: dxc was killed by signal 9 (out of memory?) on 'Main'"));
}

TEST(ToolFault, IsNoneWhereTheToolFoundAFault)
{
	FChildResult Child;
	Child.bStarted = true;
	Child.ExitCode = 1;
	Child.Output = "kernel.cpp:1: error: expected ';'\n";
	EXPECT_EQ("", FindToolFault(Child));
	Child.bTimedOut = true;
	Child.Signal = SIGKILL; // ours
	EXPECT_EQ("", FindToolFault(Child));
}
