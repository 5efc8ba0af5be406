// What strangers, and a broken machine, put in the place of files and streams: the program names it and ends with 3,
// and waits for nobody.
#include <gtest/gtest.h>

#include "Picture/ExrWriter.h"
#include "Program/ProgramOutput.h"
#include "RHITexture.h"

#include <array>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

namespace Files = std::filesystem;
using namespace std::string_literals;

const std::string Program = DRYDOCK_TEST_BINARY_DIR "/bin/drydock";
const std::string Configs = DRYDOCK_TEST_SOURCE_DIR "/configs/";

struct FOutcome
{
	int ExitCode = -1;
	std::string Out;
	std::string Err;
};

class HostileFiles : public testing::Test
{
protected:
	HostileFiles()
		: Folder(Files::temp_directory_path() / ("drydock_hostile_" + std::to_string(getpid())))
	{
		Files::create_directories(Folder);
	}
	~HostileFiles() override { Files::remove_all(Folder); }

	/** Arguments as a shell takes them, which may redirect stdout. In the test's own folder. */
	FOutcome Call(const std::string& Arguments, const std::string& Before = "") const
	{
		const std::string Err = (Folder / "stderr.txt").string();
		const std::string Command =
			"cd '" + Folder.string() + "' && " + Before + " timeout 60 '" + Program + "' 2>'" + Err + "' " + Arguments;
		FOutcome Outcome;
		FILE* const Pipe = popen(Command.c_str(), "r");
		std::array<char, 4096> Buffer;
		for (size_t NumRead; (NumRead = fread(Buffer.data(), 1, Buffer.size(), Pipe)) > 0;)
		{
			Outcome.Out.append(Buffer.data(), NumRead);
		}
		Outcome.ExitCode = WEXITSTATUS(pclose(Pipe));
		Outcome.Err = ReadFile("stderr.txt");
		return Outcome;
	}

	std::string ReadFile(const std::string& Name) const
	{
		std::ifstream Stream(Folder / Name, std::ios::binary);
		return std::string(std::istreambuf_iterator<char>(Stream), {});
	}

	void Write(const std::string& Name, const std::string& Text) const
	{
		std::ofstream(Folder / Name, std::ios::binary) << Text;
	}

	/** Exit code 3 and one message, which holds all of Parts. */
	void ExpectRefused(const FOutcome& Outcome, const std::vector<std::string>& Parts) const
	{
		EXPECT_EQ(3, Outcome.ExitCode) << Outcome.Err;
		for (const std::string& Part : Parts)
		{
			EXPECT_NE(std::string::npos, Outcome.Err.find(Part)) << Part << " is not in " << Outcome.Err;
		}
	}

	const Files::path Folder;
};

} // namespace

TEST_F(HostileFiles, AConfigThatIsNoFileIsNamed)
{
	ASSERT_EQ(0, mkfifo((Folder / "pipe.json").c_str(), 0600));
	Files::create_symlink("loop.json", Folder / "loop.json");
	Files::create_directory(Folder / "folder.json");
	ExpectRefused(Call("check pipe.json"), {"pipe.json", "DD5001", "it is a pipe"});
	ExpectRefused(Call("check /dev/zero"), {"/dev/zero", "DD5001", "it is a device"});
	ExpectRefused(Call("check loop.json"), {"loop.json", "DD5001", "Too many levels of symbolic links"});
	ExpectRefused(Call("check folder.json"), {"folder.json", "DD5001", "it is a folder"});
	const std::string Long(300, 'n');
	ExpectRefused(Call("check " + Long + ".json"), {Long, "DD5001", "File name too long"});
}

TEST_F(HostileFiles, OtherTextsThatAreNoFilesAreNamed)
{
	ASSERT_EQ(0, mkfifo((Folder / "pipe").c_str(), 0600));
	ExpectRefused(Call("settings import pipe"), {"pipe: error DD5001", "it is a pipe"});
	ExpectRefused(Call("settings import - < /dev/zero"), {"standard input: error DD5007", "no more are read"});
	ExpectRefused(Call("blend '" + Configs + "volumes_walk.json' --path pipe"), {"pipe: error DD5001", "it is a pipe"});
}

TEST_F(HostileFiles, ScenesThatAreNoFilesAreNamed)
{
	ASSERT_EQ(0, mkfifo((Folder / "pipe.exr").c_str(), 0600));
	Files::create_symlink("loop.exr", Folder / "loop.exr");
	const std::string Long = std::string(300, 'n') + ".exr";
	Write("pipe.json", R"({"scene": {"file": "pipe.exr"}})");
	Write("loop.json", R"({"scene": {"file": "loop.exr"}, "plugins": ["loop.exr"]})");
	Write("long.json", R"({"scene": {"file": ")" + Long + R"("}, "plugins": [")" + Long + R"("]})");
	ExpectRefused(Call("check pipe.json"), {"pipe.exr: error DD5001", "it is a pipe"});
	ExpectRefused(Call("check loop.json"),
		{"loop.exr: error DD5001", "Too many levels of symbolic links", "loop.exr cannot be read"});
	ExpectRefused(Call("check long.json"), {".exr: error DD5001", "File name too long", ".exr cannot be read"});
	ExpectRefused(Call("diff loop.exr pipe.exr"), {"loop.exr: error DD5001", "Too many levels of symbolic links"});
}

TEST_F(HostileFiles, NulInAPathIsSaid)
{
	Write("nul.json", R"({"scene": {"file": "a\u0000.exr"}})");
	const FOutcome Outcome = Call("check nul.json");
	EXPECT_EQ(2, Outcome.ExitCode);
	EXPECT_NE(std::string::npos, Outcome.Err.find("nul.json:1:20: error DD1010 at /scene/file")) << Outcome.Err;
	EXPECT_NE(std::string::npos, Outcome.Err.find("NUL")) << Outcome.Err;
}

TEST_F(HostileFiles, MemoryThatTheSystemDoesNotGiveIsNotDrydocksFault)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
	GTEST_SKIP() << "a sanitizer wants more address space than there is";
#endif
	// 16000 x 16000 grey pixels that are there, by runs of 128: 4 MB.
	std::string Targa("\0\0\x0B\0\0\0\0\0\0\0\0\0\x80\x3E\x80\x3E\x08\0", 18);
	for (int Run = 0; Run < 16000 * 16000 / 128; ++Run)
	{
		Targa += "\xFF\x40";
	}
	Write("large.tga", Targa);
	ExpectRefused(Call("diff large.tga large.tga", "ulimit -v 800000 && "), {"error DD5008", "large.tga"});
}

TEST_F(HostileFiles, AStackTooSmallForARunIsNotDrydocksFault)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
	GTEST_SKIP() << "a sanitizer takes more of the stack";
#endif
	for (const std::string Limit : {"32", "64", "128"})
	{
		ExpectRefused(Call("run '" + Configs + "toon_bloom.json' --out o", "ulimit -S -s " + Limit + " && "),
			{"error DD5009", "limited to " + Limit + " kB here, and a run needs 1024: ulimit -s 1024"});
	}
	EXPECT_FALSE(Files::exists(Folder / "o"));
}

namespace
{

/** Ends the process with the exit code of what is thrown, and its message. */
[[noreturn]] void MakeTextureWithoutMemory()
{
	const rlimit Limit = {rlim_t(3) << 30, rlim_t(3) << 30};
	setrlimit(RLIMIT_AS, &Limit);
	try
	{
		const TRefCountPtr<FRHITexture> Texture =
			new FRHITexture(FRHITextureDesc::Create2D(FIntPoint(16384, 16384), PF_A32B32G32R32F,
								FClearValueBinding::Black, TexCreate_ShaderResource),
				TEXT("Large"));
		Texture->EnsureMemory(); // 4 GB
	}
	catch (const Drydock::FError& Error)
	{
		std::fputs(Error.what(), stderr);
		_exit(Error.GetExitCode());
	}
	_exit(0);
}

} // namespace

TEST(MemoryOfTextures, ThatIsNotGivenIsNamed)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
	GTEST_SKIP() << "a sanitizer wants more address space than there is";
#endif
	EXPECT_EXIT(MakeTextureWithoutMemory(), testing::ExitedWithCode(3), "DD5008.*the texture Large, 16384 x 16384");
}

TEST_F(HostileFiles, AnOutputThatCannotBeWrittenIsSaid)
{
	const std::string Config = " '" + Configs + "volumes_walk.json'";
	const std::vector<std::string> Verbs = {"--version", "--help", "list settings", "list cvars --json", "list hooks",
		"check" + Config, "check --json" + Config, "blend" + Config, "settings export" + Config, "settings plan --help",
		"explain --help"};
	for (const std::string& Verb : Verbs)
	{
		ExpectRefused(Call(Verb + " > /dev/full"), {"standard output: error DD5004", "No space left on device"});
		ExpectRefused(Call(Verb + " >&-"), {"standard output: error DD5004"});
		EXPECT_EQ(0, Call(Verb + " > /dev/null").ExitCode) << Verb;
	}
}

TEST_F(HostileFiles, TextOfStrangersDoesNotSteerATerminal)
{
	const std::string Steering = "\\u001b]0;owned\\u0007\\u001b[2J\\u009b1m";
	const std::string Raw = "\x1b[2J\xC2\x9B\x9B\x07";
	Write("key.json", "{\"" + Steering + "\": 1}");
	Write("volume.json",
		R"({"volumes": [{"name": ")" + Steering + R"(", "bUnbound": true, "Settings": {"BloomIntensity": 2}}]})");
	Write(Raw + ".json", "{\"x\": 1}");
	for (const std::string& Arguments :
		{"check key.json"s, "check key.json --json"s, "blend volume.json"s, "settings export volume.json"s,
			"check '" + Raw + ".json'", "check '" + Raw + "'", "'" + Raw + "'", "check key.json '--" + Raw + "'",
			"list settings '" + Raw + "'", "list cvars '" + Raw + "'", "diff '" + Raw + "' '" + Raw + "'"})
	{
		const FOutcome Outcome = Call(Arguments);
		const std::string Printed = Outcome.Out + Outcome.Err;
		EXPECT_FALSE(Printed.empty()) << Arguments;
		EXPECT_EQ(std::string::npos, Printed.find_first_of("\x1b\x07\x7f\r")) << Arguments << Printed;
		EXPECT_EQ(std::string::npos, Printed.find("\xC2\x9B")) << Arguments << Printed;
		EXPECT_EQ(std::string::npos, Printed.find("\x9B\x07")) << Arguments << Printed;
	}
	EXPECT_NE(std::string::npos, Call("check key.json").Err.find("at /\\u001b]0;owned\\u0007\\u001b[2J\\u009b1m"));
	EXPECT_NE(std::string::npos, Call("blend volume.json").Out.find("\\u001b]0;owned"));
}

TEST_F(HostileFiles, APictureThatNoTextureHoldsIsRefusedAtItsHeader)
{
	for (const int Width : {16384, 16385})
	{
		Drydock::WriteExrPlanes((Folder / "wide.exr").string(), Width, 1,
			std::vector(3, std::vector<float>(static_cast<size_t>(Width), 0.5f)), {"R", "G", "B"}, {});
		Write("wide.json", R"({"scene": {"file": "wide.exr"}})");
		for (const char* const Arguments :
			{"check wide.json", "run wide.json --out out", "import wide.exr --out scene.exr"})
		{
			const FOutcome Outcome = Call(Arguments);
			if (Width == 16384)
			{
				EXPECT_EQ(0, Outcome.ExitCode) << Arguments << Outcome.Err;
				continue;
			}
			ExpectRefused(
				Outcome, {"wide.exr: error DD5005: ", "has 16385 x 1 pixels; the largest frame is 16384 a side"});
		}
		Files::remove_all(Folder / "out");
		Files::remove(Folder / "scene.exr");
		Files::remove(Folder / "scene.json");
	}
}

TEST_F(HostileFiles, AFileBeyondTheLimitIsAnErrorOfWriting)
{
	const std::string Run = "run '" + Configs + "neutral.json' --read-only-cache --out out";
	ExpectRefused(Call(Run, "ulimit -f 16;"), {"error DD5004", "File too large"});
	EXPECT_FALSE(Files::exists(Folder / "out"));
}

/** The number of a closed stream is given to the next file that is opened, and gets what is printed. */
TEST(StandardStreams, ClosedOnesKeepTheirPlaces)
{
	const auto OpenAfterClosing = [](int Stream)
	{
		close(Stream);
		Drydock::HoldStandardStreams();
		_exit(open("/dev/null", O_RDONLY) > STDERR_FILENO ? 0 : 1);
	};
	for (const int Stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
	{
		EXPECT_EXIT(OpenAfterClosing(Stream), testing::ExitedWithCode(0), "") << Stream;
	}
}
