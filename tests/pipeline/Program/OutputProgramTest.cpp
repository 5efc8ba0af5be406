// The program and the folder it writes to: what is in the way, who else is at work there, and signals.
#include <gtest/gtest.h>

#include "SequenceTestUtils.h"
#include "Text/FolderLock.h"

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <sys/wait.h>
#include <thread>
#include <vector>

using namespace SequenceTest;

namespace
{

const std::string Configs = DRYDOCK_TEST_SOURCE_DIR "/configs/";
const std::string Program = DRYDOCK_TEST_BINARY_DIR "/bin/drydock";

class OutputProgram : public testing::Test
{
protected:
	/** `drydock ARGUMENTS` in the test's folder, with further variables of the environment; its words go to log.txt. */
	pid_t Start(const std::vector<std::string>& Arguments, const std::vector<std::string>& Variables = {}) const
	{
		const pid_t Child = fork();
		if (Child == 0)
		{
			std::signal(SIGHUP, SIG_DFL); // whoever runs the tests may ignore it
			const int Log = open((Temporary.Path / "log.txt").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
			dup2(Log, STDOUT_FILENO);
			dup2(Log, STDERR_FILENO);
			std::vector<char*> Pointers = {const_cast<char*>(Program.c_str())};
			for (const std::string& Argument : Arguments)
			{
				Pointers.push_back(const_cast<char*>(Argument.c_str()));
			}
			Pointers.push_back(nullptr);
			for (const std::string& Variable : Variables)
			{
				putenv(const_cast<char*>(Variable.c_str()));
			}
			if (chdir(Temporary.Path.c_str()) == 0)
			{
				execv(Program.c_str(), Pointers.data());
			}
			_exit(127);
		}
		return Child;
	}

	/** Its exit code; -1 where a signal ended it. */
	static int WaitFor(pid_t Child)
	{
		int Status = 0;
		waitpid(Child, &Status, 0);
		return WIFEXITED(Status) ? WEXITSTATUS(Status) : -1;
	}

	int Run(const std::vector<std::string>& Arguments) const { return WaitFor(Start(Arguments)); }

	/** A minute at most. */
	template<typename TFunction>
	static bool WaitUntil(const TFunction& Condition)
	{
		constexpr std::chrono::milliseconds Interval(2);
		for (int Try = 0; Try < 30000; ++Try)
		{
			if (Condition())
			{
				return true;
			}
			std::this_thread::sleep_for(Interval);
		}
		return false;
	}

	std::string Log() const { return ReadBytes(Temporary.Path / "log.txt"); }

	/** One line at most, which begins so. */
	bool IsEmptyOr(const std::string& Begin) const
	{
		const std::string Text = Log();
		return Text.empty() || (Text.starts_with(Begin) && Text.find('\n') == Text.size() - 1);
	}

	bool Says(const std::string& Part) const { return Log().find(Part) != std::string::npos; }

	/** Names of all that is in the folder and means that something is not finished. */
	static std::string FindLeftovers(const Files::path& Folder)
	{
		std::string Names;
		for (const Files::directory_entry& Entry : Files::recursive_directory_iterator(Folder))
		{
			const std::string Name = Entry.path().filename().string();
			const bool bLeftover = Name.find(".writing.") != std::string::npos || Name == ".drydock.lock";
			Names += bLeftover ? Name + " " : "";
		}
		return Names;
	}

	const FTemporaryFolder Temporary{"drydock_out"};
};

} // namespace

TEST_F(OutputProgram, RunIntoASourceTreeTakesNothing)
{
	const Files::path Source = Temporary.Path / "passes/Bloom/Bloom.cpp";
	Files::create_directories(Source.parent_path());
	std::ofstream(Source) << "mine";
	EXPECT_EQ(2, Run({"run", Configs + "neutral.json", "--out", "."}));
	EXPECT_TRUE(Says("passes/Bloom: error DD1080: drydock did not write this")) << Log();
	EXPECT_EQ("mine", ReadBytes(Source));
	EXPECT_EQ(2, std::distance(Files::directory_iterator(Temporary.Path), {})); // and log.txt
}

TEST_F(OutputProgram, RunAndStudyOfOneFolderKeepOutOfEachOthersWay)
{
	std::ofstream(Temporary.Path / "a.json")
		<< R"({"scene": {"file": ")" << Configs << R"(scenes/two_boxes.exr"}, "study": {"repetitions": 1,
			"axes": [{"name": "r.BloomQuality", "values": [1, 5]}]}})";
	EXPECT_EQ(0, Run({"run", "a.json"})) << Log();
	EXPECT_EQ(0, Run({"study", "a.json"})) << Log();
	EXPECT_EQ(0, Run({"run", "a.json", "--dump", "Tonemap"})) << Log();
	for (const char* Name : {"final.png", "passes", "study.json", "insets", "study.svg"})
	{
		EXPECT_TRUE(Files::exists(Temporary.Path / "out/a" / Name)) << Name;
	}
	EXPECT_EQ("", FindLeftovers(Temporary.Path));
	std::ofstream(Temporary.Path / "out/a/insets/mine.png") << "mine";
	EXPECT_EQ(2, Run({"study", "a.json"}));
	EXPECT_TRUE(Says("insets/mine.png: error DD1080")) << Log();
	EXPECT_EQ("mine", ReadBytes(Temporary.Path / "out/a/insets/mine.png"));
}

TEST_F(OutputProgram, FolderInUseIsRefusedAtOnceByEveryVerb)
{
	const Drydock::FFolderLock Lock(Temporary.Path / "out");
	for (const std::vector<std::string>& Arguments : {std::vector<std::string>{"run", Configs + "neutral.json"},
			 {"run", Configs + "sequence.json"}, {"study", Configs + "study_storage.json"}})
	{
		std::vector<std::string> All = Arguments;
		All.insert(All.end(), {"--out", "out"});
		EXPECT_EQ(3, Run(All));
		EXPECT_TRUE(Says("out: error DD5021: process " + std::to_string(getpid()) + " is writing to this folder"))
			<< Log();
	}
}

TEST_F(OutputProgram, SignalLeavesFinishedFramesAndNothingElse)
{
	std::ofstream(Temporary.Path / "a.json") << MakeConfigText(Configs + "scenes/");
	for (const int Signal : {SIGINT, SIGTERM, SIGHUP})
	{
		const std::string Out = "out" + std::to_string(Signal);
		const pid_t Child = Start({"run", "a.json", "--frames", "all", "--out", Out});
		ASSERT_GT(Child, 0);
		EXPECT_TRUE(WaitUntil([&] { return Files::exists(Temporary.Path / Out / "frames/0001"); }));
		kill(Child, Signal);
		kill(Child, Signal); // as `timeout` does, to process and group
		EXPECT_EQ(128 + Signal, WaitFor(Child));
		EXPECT_TRUE(IsEmptyOr("note DD2066 at extension Shown")) << Log(); // its picture is of another size
		EXPECT_EQ("", FindLeftovers(Temporary.Path));
	}
}

TEST_F(OutputProgram, SignalTakesTemporaryFoldersAndCompilersAlong)
{
	const Files::path Tmp = Temporary.Path / "tmp";
	Files::create_directories(Tmp);
	const pid_t Child = Start({"run", Configs + "neutral.json", "--precision", "double", "--out", "deep/out"},
		{"TMPDIR=" + Tmp.string(), "DRYDOCK_CACHE_DIR=" + (Temporary.Path / "cache").string(),
			"XDG_CACHE_HOME=" + (Temporary.Path / "cache").string(), "HOME=" + Temporary.Path.string()});
	ASSERT_GT(Child, 0);
	const bool bCompiling = WaitUntil([&] { return !Files::is_empty(Tmp) || waitpid(Child, nullptr, WNOHANG) != 0; });
	ASSERT_TRUE(bCompiling && !Files::is_empty(Tmp)) << Log();
	kill(Child, SIGTERM);
	EXPECT_EQ(128 + SIGTERM, WaitFor(Child));
	EXPECT_TRUE(Files::is_empty(Tmp));
	EXPECT_FALSE(Files::exists(Temporary.Path / "deep")); // it was made for outputs, and there are none
}
