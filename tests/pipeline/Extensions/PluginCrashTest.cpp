// A plugin that crashes, throws, ends the program, hangs or calls what cannot be done: one message names plugin,
// function and pass, and the exit code says whose fault it is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Picture/ImageFile.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

using testing::HasSubstr;
using testing::Not;

namespace
{

namespace Files = std::filesystem;

struct FOutcome
{
	int ExitCode = -1;
	std::string Err;

	int CountErrors() const
	{
		int Count = 0;
		for (size_t At = Err.find("error DD"); At != std::string::npos; At = Err.find("error DD", At + 1))
		{
			++Count;
		}
		return Count;
	}
};

/** Runs the program on a picture of 16 x 8 with the plugin, in a folder of its own. */
class FPluginCrash : public testing::Test
{
protected:
	FPluginCrash()
		: Folder(Files::temp_directory_path() / ("drydock_crash_" + std::to_string(getpid())))
	{
		Files::remove_all(Folder);
		Files::create_directories(Folder);
		Drydock::FImage Image{16, 8, 3, std::vector<double>(16 * 8 * 3, 0.5)};
		Drydock::WriteExr((Folder / "scene.exr").string(), Image, {"R", "G", "B"});
		std::ofstream(Folder / "crash.json")
			<< R"({"scene": {"file": "scene.exr"}, "showFlags": {"Bloom": false}, "cvars": {"r.Drydock.PluginSeconds": 1,
				"r.Drydock.Threads": 4}, "plugins": [")" DRYDOCK_TEST_BINARY_DIR R"(/lib/libCrashPlugin.so"]})";
	}
	~FPluginCrash() override { Files::remove_all(Folder); }

	FOutcome Run(const std::string& Environment) const
	{
		const std::string Command = "cd '" + Folder.string() + "' && ulimit -c 0 && " + Environment +
									" '" DRYDOCK_TEST_BINARY_DIR
									"/bin/drydock' run crash.json --out out 2>&1 >/dev/null";
		FOutcome Outcome;
		FILE* const Pipe = popen(Command.c_str(), "r");
		std::array<char, 4096> Buffer;
		for (size_t NumRead; (NumRead = fread(Buffer.data(), 1, Buffer.size(), Pipe)) > 0;)
		{
			Outcome.Err.append(Buffer.data(), NumRead);
		}
		const int Status = pclose(Pipe);
		Outcome.ExitCode = WIFEXITED(Status) ? WEXITSTATUS(Status) : -WTERMSIG(Status);
		return Outcome;
	}

	const Files::path Folder;
};

/** How it goes wrong, where, and what the message says of both. */
struct FCrash
{
	const char* Kind;
	const char* Place;
	const char* Where;
	const char* What;
	bool bSignal = false; // sanitizers tell it in their own way
};

constexpr const char* SetupView = "plugin libCrashPlugin.so, SetupView of extension FCrashExtension";
constexpr const char* Callback = "plugin libCrashPlugin.so, the callback at Tonemap of extension FCrashExtension";
constexpr const char* InPass =
	"plugin libCrashPlugin.so, the callback at Tonemap of extension FCrashExtension, pass Fatal";

const FCrash GCrashes[] = {
	{"write", "SetupView", SetupView, "crashed: segmentation fault (SIGSEGV) at address 0x8 in ", true},
	{"divide", "SetupView", SetupView, "crashed: arithmetic fault (SIGFPE)", true},
	{"bus", "SetupView", SetupView, "crashed: bus error (SIGBUS)", true},
	{"trap", "SetupView", SetupView, "crashed: illegal instruction (SIGILL)", true},
	{"abort", "SetupView", SetupView, "called abort", true},
	{"overflow", "SetupView", SetupView, "overflowed its stack in ", true},
	{"terminate", "SetupView", SetupView, "called std::terminate", true},
	{"noexcept", "SetupView", SetupView, "let an exception out where none may leave: nobody may see this", true},
	{"exit", "SetupView", SetupView, "called exit", true},
	{"exception", "SetupView", SetupView, "threw std::runtime_error: the cup is empty"},
	{"int", "SetupView", SetupView, "threw int"},
	{"foreign", "SetupView", SetupView, "threw an exception that is not of C++"},
	{"check", "SetupView", SetupView, "a check of the plugin failed: Assertion failed"},
	{"deadlock", "SetupView", SetupView, "has not come back for 1 s"},
	{"write", "loading", "plugin libCrashPlugin.so, constructors of static variables (dlopen)", "SIGSEGV", true},
	{"exception", "loading", "plugin libCrashPlugin.so, constructors of static variables (dlopen)", "the cup is empty",
		true},
	{"write", "startup", "plugin libCrashPlugin.so, StartupModule of module CrashPlugin", "SIGSEGV", true},
	{"int", "startup", "plugin libCrashPlugin.so, StartupModule of module CrashPlugin", "threw int"},
	{"write", "asking", "plugin libCrashPlugin.so, IsActiveThisFrame of extension FCrashExtension", "SIGSEGV", true},
	{"write", "subscribing",
		"plugin libCrashPlugin.so, SubscribeToPostProcessingPass(Tonemap) of extension FCrashExtension", "SIGSEGV",
		true},
	{"write", "callback", Callback, "SIGSEGV", true},
	{"int", "callback", Callback, "threw int"},
	{"write", "pass", InPass, "SIGSEGV", true},
	{"overflow", "pass", InPass, "overflowed its stack", true},
	{"int", "pass", InPass, "threw int"},
	{"deadlock", "pass", InPass, "has not come back for 1 s"},
	{"write", "tile", InPass, "SIGSEGV", true},
	{"overflow", "tile", InPass, "overflowed its stack", true},
	{"exception", "tile", InPass, "the cup is empty"},
	{"write", "shutdown", "plugin libCrashPlugin.so, ShutdownModule of module CrashPlugin", "SIGSEGV", true},
};

/** "/.../CrashPlugin.cpp:41", by the comment in that line. */
std::string FindCrashLine(const std::string& Kind)
{
	const std::string Path = DRYDOCK_TEST_SOURCE_DIR "/tests/plugins/CrashPlugin.cpp";
	std::ifstream Stream(Path);
	std::string Line;
	for (int Number = 1; std::getline(Stream, Line); ++Number)
	{
		if (Line.ends_with("// crash: " + Kind))
		{
			return Path + ":" + std::to_string(Number);
		}
	}
	return "no line";
}

bool HasSanitizer()
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
	return true;
#else
	return false;
#endif
}

} // namespace

TEST_F(FPluginCrash, ARunWithoutOneIsDone)
{
	const FOutcome Outcome = Run("DRYDOCK_TEST_CRASH=");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Err;
	EXPECT_EQ(0, Outcome.CountErrors()) << Outcome.Err;
}

TEST_F(FPluginCrash, EndsInOneMessageAndACodeOfItsOwn)
{
	for (const FCrash& Crash : GCrashes)
	{
		if (Crash.bSignal && HasSanitizer())
		{
			continue;
		}
		SCOPED_TRACE(std::string(Crash.Kind) + " at " + Crash.Place);
		const FOutcome Outcome = Run("DRYDOCK_TEST_CRASH='" + std::string(Crash.Kind) + " at " + Crash.Place + "'");
		EXPECT_EQ(71, Outcome.ExitCode) << Outcome.Err;
		EXPECT_EQ(1, Outcome.CountErrors()) << Outcome.Err;
		EXPECT_THAT(Outcome.Err, HasSubstr(Crash.Where));
		EXPECT_THAT(Outcome.Err, HasSubstr(Crash.What));
	}
}

TEST_F(FPluginCrash, NamesTheLineOfThePlugin)
{
	if (HasSanitizer())
	{
		return;
	}
	for (const std::string Kind : {"write", "nowhere"})
	{
		const FOutcome Outcome = Run("DRYDOCK_TEST_CRASH='" + Kind + " at pass'");
		EXPECT_EQ(71, Outcome.ExitCode) << Outcome.Err;
		EXPECT_THAT(Outcome.Err, HasSubstr(InPass));
		EXPECT_THAT(Outcome.Err, HasSubstr(" in " + FindCrashLine(Kind) + " (libCrashPlugin.so+0x"));
	}
}

// A header's function is compiled into the plugin, a library's is not; the plugin's line is that of the call.
TEST_F(FPluginCrash, InDrydocksCodeIsNotThePluginsFault)
{
	if (HasSanitizer())
	{
		return;
	}
	for (const std::string Kind : {"header", "library"})
	{
		const FOutcome Outcome = Run("DRYDOCK_TEST_CRASH='" + Kind + " at SetupView'");
		EXPECT_EQ(70, Outcome.ExitCode) << Outcome.Err;
		EXPECT_EQ(0, Outcome.CountErrors()) << Outcome.Err;
		EXPECT_THAT(Outcome.Err, HasSubstr("drydock crashed in " + std::string(SetupView) + ": it crashed: "));
		EXPECT_THAT(Outcome.Err, HasSubstr(", called at " + FindCrashLine(Kind) + " (libCrashPlugin.so+0x"));
		EXPECT_THAT(Outcome.Err, HasSubstr("; drydock's code is at fault, or what the plugin gave it"));
		EXPECT_EQ(Kind == "header", Outcome.Err.find(" in rdg/core/Core/Containers/Array.h:") != std::string::npos)
			<< Outcome.Err;
	}
}

TEST_F(FPluginCrash, LeavesWhatWasThereAsItWas)
{
	ASSERT_EQ(0, Run("DRYDOCK_TEST_CRASH=").ExitCode);
	const auto Read = [](const Files::path& Path)
	{
		std::ifstream Stream(Path, std::ios::binary);
		return std::string(std::istreambuf_iterator<char>(Stream), {});
	};
	const std::string Before = Read(Folder / "out" / "run.json");
	EXPECT_EQ(71, Run("DRYDOCK_TEST_CRASH='int at pass'").ExitCode);
	EXPECT_EQ(Before, Read(Folder / "out" / "run.json"));
	for (const auto& Entry : Files::recursive_directory_iterator(Folder / "out"))
	{
		EXPECT_THAT(Entry.path().filename().string(), Not(HasSubstr(".writing")));
	}
}

TEST_F(FPluginCrash, ACallThatCannotBeDoneIsTheUsersMistake)
{
	struct FMisuse
	{
		const char* Call;
		const char* Number;
		const char* Place;
	};
	const FMisuse Misuses[] = {
		{"copy null", "DD2006", "AddCopyTexturePass, parameter InputTexture: "},
		{"copy gone", "DD2013", "AddCopyTexturePass, parameter OutputTexture: "},
		{"copy formats", "DD2016", "pass CopyTexture(Small -> Small): a copy does not convert"},
		{"copy mip", "DD2016", "the copy is of mip 3, but Small has 1"},
		{"copy beyond", "DD2016", "the copy of 3 x 3 x 1 texels at 2 x 2 x 0 goes beyond mip 0 of Small"},
		{"draw null", "DD2015",
			"pass Spoilt, parameter InputTexture: FCopyRectPS's required shader parameter FParameters::InputTexture "
			"was not "
			"set."},
		{"draw nowhere", "DD2021", "pass Spoilt: "},
		{"draw gone", "DD2013", "pass Spoilt, parameter InputTexture: "},
		{"draw parameters", "DD2006", "pass Spoilt, AddDrawScreenPass, parameter Parameters: "},
		{"srv null", "DD2006", "CreateSRV"},
		{"srv gone", "DD2013", "CreateSRV"},
		{"srv mip", "DD2009", "texture "},
		{"register null", "DD2006", "NULL external texture"},
		{"extract null", "DD2006", "QueueTextureExtraction"},
		{"clear null", "DD2006", "AddClearRenderTargetPass, parameter Texture: "},
		{"clear uav null", "DD2006", "AddClearUAVPass, parameter UAV: "},
		{"list null", "DD2088", "pass Spoilt: the plugin called what cannot be done: "},
		{"return gone", "DD2013", "what it returned, parameter Texture: "},
		{"builder", "DD2001", "only one may be alive at a time"},
	};
	for (const FMisuse& Misuse : Misuses)
	{
		SCOPED_TRACE(Misuse.Call);
		const FOutcome Outcome = Run("DRYDOCK_TEST_MISUSE='" + std::string(Misuse.Call) + "'");
		EXPECT_EQ(2, Outcome.ExitCode) << Outcome.Err;
		EXPECT_EQ(1, Outcome.CountErrors()) << Outcome.Err;
		EXPECT_THAT(Outcome.Err, HasSubstr(std::string("error ") + Misuse.Number + " at " + Callback + ", "));
		EXPECT_THAT(Outcome.Err, HasSubstr(Misuse.Place));
		EXPECT_THAT(Outcome.Err, Not(HasSubstr("internal error")));
	}
}
