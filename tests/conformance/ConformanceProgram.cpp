// Runs tests that are written in the format of LLVM's offload test suite, each in a process of its own, and prints what
// became of them: `conformance [OPTIONS] FOLDER|FILE...`.
#include "ConformanceRun.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

using namespace Drydock::Conformance;
namespace fs = std::filesystem;

struct FVerdictName
{
	EVerdict Verdict;
	const char* Name;
};

constexpr FVerdictName GVerdicts[] = {{EVerdict::Passed, "passed"}, {EVerdict::Refused, "refused"},
	{EVerdict::RefusedNowhere, "refused without a line"}, {EVerdict::Wrong, "wrong"}, {EVerdict::Crashed, "crashed"},
	{EVerdict::Hung, "hung"}, {EVerdict::NotRead, "not read"}};

const char* GetName(EVerdict Verdict)
{
	return GVerdicts[size_t(Verdict)].Name;
}

struct FTestFile
{
	fs::path Path;
	std::string Name;
};

/** A test that runs in a process of its own, which writes its verdict into a pipe. */
struct FRunning
{
	size_t Test = 0;
	pid_t Process = 0;
	int Pipe = -1;
	std::string Output;
	std::chrono::steady_clock::time_point End;
};

FRunning Start(const FTestFile& Test, size_t Index, const FOptions& Options, int Seconds)
{
	int Pipe[2];
	if (pipe(Pipe) != 0)
	{
		std::perror("conformance: pipe");
		std::exit(3);
	}
	std::fflush(stdout);
	const pid_t Process = fork();
	if (Process < 0)
	{
		std::perror("conformance: fork");
		std::exit(3);
	}
	if (Process == 0)
	{
		setpgid(0, 0);
		close(Pipe[0]);
		const FVerdict Verdict = RunTest(Test.Path.string(), Test.Name, Options);
		const std::string Line = std::string(1, char('0' + int(Verdict.Verdict))) + Verdict.Message;
		const bool bWritten = write(Pipe[1], Line.data(), Line.size()) == ssize_t(Line.size());
		_exit(bWritten ? 0 : 3);
	}
	close(Pipe[1]);
	return {Index, Process, Pipe[0], {}, std::chrono::steady_clock::now() + std::chrono::seconds(Seconds)};
}

FVerdict Finish(FRunning& Running, bool bTimeOver)
{
	if (bTimeOver)
	{
		kill(-Running.Process, SIGKILL);
	}
	int Status = 0;
	waitpid(Running.Process, &Status, 0);
	close(Running.Pipe);
	if (bTimeOver)
	{
		return {EVerdict::Hung, {}};
	}
	if (WIFSIGNALED(Status) || WEXITSTATUS(Status) != 0 || Running.Output.empty())
	{
		return {EVerdict::Crashed, WIFSIGNALED(Status) ? fmt::format("signal {}", WTERMSIG(Status))
													   : fmt::format("exit code {}", WEXITSTATUS(Status))};
	}
	return {EVerdict(Running.Output[0] - '0'), Running.Output.substr(1)};
}

/** Runs them all, so many at a time. */
std::vector<FVerdict> RunAll(const std::vector<FTestFile>& Tests, const FOptions& Options, size_t Jobs, int Seconds)
{
	std::vector<FVerdict> Verdicts(Tests.size());
	std::vector<FRunning> Running;
	size_t Next = 0;
	while (Next < Tests.size() || !Running.empty())
	{
		while (Next < Tests.size() && Running.size() < Jobs)
		{
			Running.push_back(Start(Tests[Next], Next, Options, Seconds));
			++Next;
		}
		std::vector<pollfd> Polls;
		for (const FRunning& One : Running)
		{
			Polls.push_back({One.Pipe, POLLIN, 0});
		}
		poll(Polls.data(), Polls.size(), 1000);
		for (size_t i = Running.size(); i-- > 0;)
		{
			FRunning& One = Running[i];
			const bool bTimeOver = std::chrono::steady_clock::now() > One.End;
			std::array<char, 4096> Buffer;
			const ssize_t Count = Polls[i].revents ? read(One.Pipe, Buffer.data(), Buffer.size()) : -1;
			One.Output.append(Buffer.data(), size_t(std::max<ssize_t>(Count, 0)));
			if (Count == 0 || bTimeOver)
			{
				Verdicts[One.Test] = Finish(One, bTimeOver);
				Running.erase(Running.begin() + ptrdiff_t(i));
			}
		}
	}
	return Verdicts;
}

/** The tests below each place, by name. */
std::vector<FTestFile> FindTests(const std::vector<std::string>& Places)
{
	std::vector<FTestFile> Tests;
	for (const std::string& Place : Places)
	{
		if (!fs::is_directory(Place))
		{
			Tests.push_back({Place, fs::path(Place).filename().string()});
			continue;
		}
		for (const fs::directory_entry& Entry : fs::recursive_directory_iterator(Place))
		{
			if (Entry.path().extension() == ".test")
			{
				Tests.push_back({Entry.path(), fs::relative(Entry.path(), Place).string()});
			}
		}
	}
	std::sort(Tests.begin(), Tests.end(), [](const FTestFile& A, const FTestFile& B) { return A.Name < B.Name; });
	return Tests;
}

} // namespace

int main(int ArgumentCount, char** Arguments)
{
	CLI::App App("Runs tests in the format of LLVM's offload test suite; without a place those of the folder that "
				 "DRYDOCK_CONFORMANCE_TESTS names");
	std::vector<std::string> Places;
	FOptions Options;
	size_t Jobs = 2;
	int Seconds = 300;
	bool bAll = false;
	App.add_option("places", Places, "Folders, searched for *.test, and files")->check(CLI::ExistingPath);
	App.add_option("--lanes", Options.Lanes.Lanes, "Lanes of a kernel; 0: the widest")->capture_default_str();
	App.add_option("--wave", Options.Lanes.WaveSize, "Threads of a wave, where a test asks for none")
		->capture_default_str();
	App.add_flag("--double", Options.Lanes.bDouble, "Kernels of double arithmetic");
	App.add_flag("--interpreter", Options.bInterpreter, "The interpreter in place of kernels");
	App.add_flag("--sabotage", Options.bSabotage, "Changes each expected value: each change has to be found");
	App.add_flag("--all", bAll, "Fails where a test does not pass, for whatever reason");
	App.add_option("--jobs", Jobs, "Tests at a time")->capture_default_str()->check(CLI::Range(1, 256));
	App.add_option("--seconds", Seconds, "Time of a test")->capture_default_str()->check(CLI::Range(1, 86400));
	CLI11_PARSE(App, ArgumentCount, Arguments);
	const char* const Folder = std::getenv("DRYDOCK_CONFORMANCE_TESTS");
	if (Places.empty() && Folder && *Folder)
	{
		Places.push_back(Folder);
	}
	const std::vector<FTestFile> Tests = FindTests(Places);
	if (Tests.empty())
	{
		fmt::print("no tests; DRYDOCK_CONFORMANCE_TESTS can name a folder of them\n");
		return bAll ? 1 : 0;
	}
	const std::vector<FVerdict> Verdicts = RunAll(Tests, Options, Jobs, Seconds);
	std::map<EVerdict, size_t> Counts;
	for (size_t i = 0; i < Tests.size(); ++i)
	{
		const auto& [Verdict, Message] = Verdicts[i];
		++Counts[Verdict];
		fmt::print("{}: {}{}{}\n", GetName(Verdict), Tests[i].Name, Message.empty() ? "" : ": ", Message);
	}
	fmt::print("\n{} tests:", Tests.size());
	for (const FVerdictName& Name : GVerdicts)
	{
		fmt::print("{} {} {}", Name.Verdict == EVerdict::Passed ? "" : ",", Counts[Name.Verdict], Name.Name);
	}
	fmt::print("\n");
	const size_t Faults = Counts[EVerdict::Wrong] + Counts[EVerdict::Crashed] + Counts[EVerdict::Hung];
	return Faults > 0 || (bAll && Counts[EVerdict::Passed] < Tests.size()) ? 1 : 0;
}
