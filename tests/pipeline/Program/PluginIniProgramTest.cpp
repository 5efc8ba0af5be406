// The ini files of a plugin are inputs of a run: an edit is seen by --watch, and a sequence that was begun with other
// values is not gone on with.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ProgramTestUtils.h"

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <thread>

using ProgramTest::FOutcome;
using ProgramTest::FProgramFolder;
using testing::ContainsRegex;
using testing::HasSubstr;

namespace
{

namespace Files = std::filesystem;

class PluginIniProgram : public testing::Test
{
protected:
	PluginIniProgram() { WriteIni(0.25); }

	/** Secret is what the plugin (tests/plugins/Tuned, a copy) adds to red. */
	void WriteIni(double Secret) const
	{
		std::ofstream(IniFile) << "[/Script/Tuned.TunedSettings]\nMode=Off\nLabel=\nSecret=" << Secret << "\n";
	}

	/** Red of the first pixel, which is black; -1 where the file is not whole. */
	double ReadRed(const std::string& File) const
	{
		try
		{
			Drydock::FImageFile Picture((Folder.Path / File).string());
			return Picture.Read({Picture.FindChannel("R")})[0][0];
		}
		catch (const std::exception&)
		{
			return -1;
		}
	}

	/** Waits for a run of the watching program to draw that; a minute is long enough on any machine. */
	bool WaitForRed(double Red) const
	{
		for (int Look = 0; Look < 600; ++Look)
		{
			if (Folder.Read("log.txt").find("watching") != std::string::npos && ReadRed("out/scene_linear.exr") == Red)
			{
				return true;
			}
			std::this_thread::sleep_for(std::chrono::milliseconds(100));
		}
		return false;
	}

	const FProgramFolder Folder{"plugin_ini"};
	const std::string IniFile = DRYDOCK_TEST_BINARY_DIR "/tests/plugins/edited/Tuned/Config/DefaultGame.ini";
	const std::string IniName = "/Tuned/Config/DefaultGame.ini"; // the path is from the config
	const std::string Plugin = R"(, "plugins": [")" DRYDOCK_TEST_BINARY_DIR R"(/lib/libEditedTuned.so"])";
};

} // namespace

TEST_F(PluginIniProgram, WatchRendersAgainWhenOneIsEdited)
{
	Folder.WriteFrame("a.json", Plugin);
	const pid_t Child = fork();
	if (Child == 0)
	{
		const int Log = open((Folder.Path / "log.txt").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
		dup2(Log, STDOUT_FILENO);
		dup2(Log, STDERR_FILENO);
		if (chdir(Folder.Path.c_str()) == 0)
		{
			execl(DRYDOCK_TEST_BINARY_DIR "/bin/drydock", "drydock", "run", "a.json", "--watch", "--outputs", "exr",
				"--out", "out", nullptr);
		}
		_exit(127);
	}
	ASSERT_GT(Child, 0);
	EXPECT_TRUE(WaitForRed(0.25)) << Folder.Read("log.txt");
	WriteIni(0.5);
	EXPECT_TRUE(WaitForRed(0.5)) << Folder.Read("log.txt");
	Files::remove(IniFile); // the constructor's value holds again
	EXPECT_TRUE(WaitForRed(0.0)) << Folder.Read("log.txt");
	kill(Child, SIGTERM);
	int Status = 0;
	waitpid(Child, &Status, 0);
	EXPECT_TRUE(WIFEXITED(Status) && WEXITSTATUS(Status) == 128 + SIGTERM);
}

TEST_F(PluginIniProgram, BlendPrintsAPluginsSettingByName)
{
	Folder.WriteFrame(
		"a.json", Plugin + R"(, "volumes": [{"name": "V", "bUnbound": true, "Settings": {"TunedGlow": 2}}])");
	const FOutcome Blend = Folder.Call("blend a.json --setting TunedGlow");
	EXPECT_EQ(0, Blend.ExitCode) << Blend.Printed;
	EXPECT_THAT(Blend.Printed, HasSubstr("TunedGlow = 2"));
}

TEST_F(PluginIniProgram, ASequenceWithAnotherOneIsNotTakenForDone)
{
	const std::string Scene =
		R"({"scene": {"file": ")" DRYDOCK_TEST_SOURCE_DIR R"(/configs/scenes/moving_camera.####.exr"})";
	Folder.Write("a.json", Scene + Plugin + "}");
	const std::string Run = "run a.json --frames 2-3 --out out";
	ASSERT_EQ(0, Folder.Call("run a.json --frames 2 --out out").ExitCode);
	EXPECT_EQ(0, Folder.Call(Run).ExitCode);
	WriteIni(0.5);
	const FOutcome Changed = Folder.Call(Run);
	EXPECT_EQ(2, Changed.ExitCode);
	EXPECT_THAT(Changed.Printed, HasSubstr("DD1070"));
	EXPECT_THAT(Changed.Printed, ContainsRegex("frames of another sequence: file [^ ]*" + IniName + " has changed;"));
	Files::remove(IniFile);
	EXPECT_THAT(Folder.Call(Run).Printed, ContainsRegex("file [^ ]*" + IniName + " is gone;"));
	WriteIni(0.25);
	EXPECT_EQ(0, Folder.Call(Run).ExitCode);

	// A plugin of the command line likewise.
	Folder.Write("b.json", Scene + "}");
	const std::string Argument =
		"run b.json --frames 2 --out other --plugin '" DRYDOCK_TEST_BINARY_DIR "/lib/libEditedTuned.so'";
	ASSERT_EQ(0, Folder.Call(Argument).ExitCode);
	WriteIni(0.5);
	EXPECT_EQ(2, Folder.Call(Argument).ExitCode);
}
