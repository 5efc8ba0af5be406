// The program with configs and caches that are not trusted: what it refuses, what it leaves alone, how it ends.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

namespace Files = std::filesystem;

class TrustProgram : public testing::Test
{
protected:
	TrustProgram() { Files::create_directories(Folder); }
	~TrustProgram() override { Files::remove_all(Folder); }

	/** Before: variables for the shell. The exit code; what was printed is left in Printed. */
	int Call(const std::string& Before, const std::string& Arguments)
	{
		const std::string Command = "cd '" + Folder.string() + "' && " + Before +
									" '" DRYDOCK_TEST_BINARY_DIR "/bin/drydock' " + Arguments + " 2>&1";
		FILE* const Pipe = popen(Command.c_str(), "r");
		std::array<char, 4096> Buffer;
		Printed.clear();
		for (size_t NumRead; (NumRead = fread(Buffer.data(), 1, Buffer.size(), Pipe)) > 0;)
		{
			Printed.append(Buffer.data(), NumRead);
		}
		return WEXITSTATUS(pclose(Pipe));
	}

	std::string WriteConfig(const std::string& Text) const
	{
		const std::string Path = (Folder / "config.json").string();
		std::ofstream(Path) << Text;
		return Path;
	}

	size_t Count(const std::string& Part) const
	{
		size_t Number = 0;
		for (size_t At = Printed.find(Part); At != std::string::npos; At = Printed.find(Part, At + 1))
		{
			++Number;
		}
		return Number;
	}

	const Files::path Folder = Files::temp_directory_path() / ("drydock_trust_" + std::to_string(getpid()));
	const std::string Cache = (Folder / "cache").string();
	const std::string WithCache = "DRYDOCK_CACHE_DIR='" + Cache + "'";
	const std::string Shipped = DRYDOCK_TEST_SOURCE_DIR "/configs/toon_bloom.json";
	std::string Printed;
};

} // namespace

TEST_F(TrustProgram, NoPluginsRefusesEachByName)
{
	const std::string Plugin = DRYDOCK_TEST_BINARY_DIR "/lib/libTestPlugin.so";
	const std::string Config =
		WriteConfig("{\n\t\"plugins\": [\n\t\t\"" + Plugin + "\",\n\t\t\"libOther.so\"\n\t]\n}\n");
	for (const char* const Verb : {"check ", "run ", "graph ", "blend ", "explain ", "study ", "warm ", "list hooks ",
			 "settings export --at 0,0,0 ", "list cvars --config "})
	{
		EXPECT_EQ(2, Call(WithCache, Verb + Config + " --no-plugins")) << Verb << Printed;
		EXPECT_EQ(2u, Count("error DD2079")) << Verb << Printed;
		EXPECT_EQ(1u, Count(Config + ":3:3: error DD2079 at /plugins/0: the plugin " + Plugin + " is not loaded"));
		EXPECT_EQ(1u, Count(Config + ":4:3: error DD2079 at /plugins/1: the plugin libOther.so is not loaded"));
	}
}

TEST_F(TrustProgram, NoPluginsChangesNothingWhereThereAreNone)
{
	EXPECT_EQ(0, Call(WithCache, "check --no-plugins " + Shipped)) << Printed;
}

TEST_F(TrustProgram, ReadOnlyCacheStaysAsItIs)
{
	EXPECT_EQ(0, Call(WithCache, "graph --read-only-cache --no-plugins " + Shipped)) << Printed;
	EXPECT_EQ(0u, Count("warning DD6"));
	EXPECT_FALSE(Files::exists(Cache));
}

TEST_F(TrustProgram, WarmFailsWhereTheChosenCacheCannotBeWritten)
{
	std::ofstream(Folder / "file") << "";
	const std::string BelowAFile = (Folder / "file" / "cache").string();
	EXPECT_EQ(3, Call("", "warm --cache '" + BelowAFile + "' " + Shipped)) << Printed;
	EXPECT_EQ(1u, Count(BelowAFile + ": error DD6051: the shader cache cannot be written: Not a directory")) << Printed;
	EXPECT_EQ(0u, Count("warmed"));
}

TEST_F(TrustProgram, WarmFailsWhereTheChosenCacheIsNotTrusted)
{
	Files::create_directories(Cache);
	chmod(Cache.c_str(), 0777);
	EXPECT_EQ(3, Call("", "warm --cache '" + Cache + "' " + Shipped)) << Printed;
	EXPECT_EQ(1u, Count(Cache + ": error DD6050: ")) << Printed;
	EXPECT_TRUE(Files::is_empty(Cache));
}

TEST_F(TrustProgram, AnUntrustedCacheIsAWarningElsewhere)
{
	Files::create_directories(Cache);
	chmod(Cache.c_str(), 0777);
	EXPECT_EQ(0, Call(WithCache, "graph " + Shipped)) << Printed;
	EXPECT_EQ(1u, Count(Cache + ": warning DD6050: ")) << Printed;
	EXPECT_TRUE(Files::is_empty(Cache));
}

TEST_F(TrustProgram, AMissingTemporaryFolderIsExitThreeAndNamed)
{
	const std::string Missing = (Folder / "missing").string();
	EXPECT_EQ(3, Call(WithCache + " TMPDIR='" + Missing + "'", "graph --format svg " + Shipped)) << Printed;
	EXPECT_EQ(1u, Count(Missing + ": error DD5004: no temporary folder can be made here")) << Printed;
	EXPECT_EQ(0u, Count("internal error"));
}
