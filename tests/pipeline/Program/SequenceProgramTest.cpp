// The program killed in the middle of a sequence: what it writes afterwards is what an undisturbed run writes.
#include <gtest/gtest.h>

#include "SequenceTestUtils.h"

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <random>
#include <sys/wait.h>
#include <thread>

using namespace SequenceTest;

namespace
{

using FSeconds = std::chrono::duration<double>;

const std::string Scenes = DRYDOCK_TEST_SOURCE_DIR "/configs/scenes/";
const std::string Program = DRYDOCK_TEST_BINARY_DIR "/bin/drydock";

class SequenceProgram : public testing::Test
{
protected:
	SequenceProgram()
	{
		std::ofstream(Temporary.Path / "a.json") << MakeConfigText(
			Scenes, R"(, "view": {"exposure": "auto", "preExposure": "auto"}, "cvars": {"r.AntiAliasingMethod": 2})");
	}

	/** `drydock run a.json --frames FRAMES --out OUT` in the test's folder; its output goes to a file. */
	pid_t Start(const std::string& Frames, const std::string& Out, const std::string& Config = "a.json") const
	{
		const pid_t Child = fork();
		if (Child == 0)
		{
			const int Log = open((Temporary.Path / "log.txt").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
			dup2(Log, STDOUT_FILENO);
			dup2(Log, STDERR_FILENO);
			if (chdir(Temporary.Path.c_str()) == 0)
			{
				execl(Program.c_str(), Program.c_str(), "run", Config.c_str(), "--report", "off", "--frames",
					Frames.c_str(), "--out", Out.c_str(), nullptr);
			}
			_exit(127);
		}
		return Child;
	}

	static int WaitFor(pid_t Child)
	{
		int Status = 0;
		waitpid(Child, &Status, 0);
		return Status;
	}

	void RunToTheEnd(const std::string& Frames, const std::string& Out, const std::string& Config = "a.json") const
	{
		const int Status = WaitFor(Start(Frames, Out, Config));
		EXPECT_TRUE(WIFEXITED(Status) && WEXITSTATUS(Status) == 0) << ReadBytes(Temporary.Path / "log.txt");
	}

	/** Those that a run leaves where it is killed after it makes or empties one and before its mark stands or falls. */
	void RemoveEmptyFolders(const std::string& Out) const
	{
		std::vector<std::filesystem::path> Empty;
		for (const std::filesystem::directory_entry& Entry : std::filesystem::directory_iterator(Temporary.Path / Out))
		{
			if (Entry.is_directory() && Entry.path().string().find(".writing.") != std::string::npos &&
				std::filesystem::is_empty(Entry.path()))
			{
				Empty.push_back(Entry.path());
			}
		}
		for (const std::filesystem::path& Path : Empty)
		{
			std::filesystem::remove(Path);
		}
	}

	const FTemporaryFolder Temporary{"drydock_killed"};
};

} // namespace

TEST_F(SequenceProgram, KilledAtAnyMomentLosesNothing)
{
	const std::string Frames = "2-4";
	RunToTheEnd(Frames, "warm"); // compiles shaders where the cache lacks them
	const auto Begin = std::chrono::steady_clock::now();
	RunToTheEnd(Frames, "whole");
	const double Duration = FSeconds(std::chrono::steady_clock::now() - Begin).count();

	// Four runs to the end, each killed five times on the way: 20 moments, in the later ones of each with frames there.
	std::mt19937 Random(1234);
	std::uniform_real_distribution<double> Moment(0.0, 1.0);
	int NumKilled = 0;
	for (int Run = 0; Run < 4; ++Run)
	{
		const std::string Out = "killed" + std::to_string(Run);
		for (int Kill = 0; Kill < 5; ++Kill)
		{
			const pid_t Child = Start(Frames, Out);
			ASSERT_GT(Child, 0); // to kill -1 is to kill everybody
			std::this_thread::sleep_for(FSeconds(Duration * Moment(Random)));
			kill(Child, SIGKILL);
			NumKilled += WIFSIGNALED(WaitFor(Child)) ? 1 : 0;
		}
		RunToTheEnd(Frames, Out);
		RemoveEmptyFolders(Out);
		EXPECT_TRUE(AreSameFolders(Temporary.Path / "whole", Temporary.Path / Out)) << "run " << Run;
	}
	EXPECT_GT(NumKilled, 5);
}

TEST_F(SequenceProgram, PluginsHistoryIsMadeAgain)
{
	const std::string Plugin = DRYDOCK_TEST_BINARY_DIR "/lib/libHistoryPlugin.so";
	std::ofstream(Temporary.Path / "plugin.json")
		<< R"({"scene": {"file": ")" << Scenes << R"(moving_camera.####.exr"}, "plugins": [")" << Plugin << R"("]})";
	RunToTheEnd("2-4", "whole", "plugin.json");
	RunToTheEnd("2-3", "parts", "plugin.json");
	RunToTheEnd("2-4", "parts", "plugin.json");
	EXPECT_TRUE(AreSameFolders(Temporary.Path / "whole", Temporary.Path / "parts"));
	EXPECT_NE(std::string::npos, ReadBytes(Temporary.Path / "log.txt").find("2 of them computed again"));
	// 0.25 for each frame so far: the plugin has seen all three.
	EXPECT_NE(std::string::npos,
		ReadBytes(Temporary.Path / "parts/frames/0004/run.json").find("\"VignetteIntensity\": 0.75"));
}
