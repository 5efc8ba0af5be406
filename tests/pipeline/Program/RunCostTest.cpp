// What a run costs, in counts that no clock is needed for: libraries loaded, memory a pixel, and parts of its time that
// add up.
#include <gtest/gtest.h>

#include "Config/ConfigReader.h"
#include "Picture/ExrWriter.h"
#include "SequenceTestUtils.h"
#include "Text/Json.h"

#include <fcntl.h>
#include <set>
#include <sys/resource.h>
#include <sys/wait.h>

using namespace Drydock;
using namespace SequenceTest;

namespace
{

const std::string Configs = DRYDOCK_TEST_SOURCE_DIR "/configs/";
const std::string Program = DRYDOCK_TEST_BINARY_DIR "/bin/drydock";

class RunCost : public testing::Test
{
protected:
	/** `drydock ARGUMENTS` in the test's folder; the linker's words about libraries go to log.txt. Returns what it
	 * cost.
	 */
	rusage Run(std::vector<std::string> Arguments, int ExpectedExitCode = 0) const
	{
		const pid_t Child = fork();
		if (Child == 0)
		{
			const int Log = open((Temporary.Path / "log.txt").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
			dup2(Log, STDOUT_FILENO);
			dup2(Log, STDERR_FILENO);
			std::vector<char*> Pointers = {const_cast<char*>(Program.c_str())};
			for (std::string& Argument : Arguments)
			{
				Pointers.push_back(Argument.data());
			}
			Pointers.push_back(nullptr);
			setenv("LD_DEBUG", "files", 1);
			if (chdir(Temporary.Path.c_str()) == 0)
			{
				execv(Program.c_str(), Pointers.data());
			}
			_exit(127);
		}
		int Status = 0;
		rusage Usage = {};
		wait4(Child, &Status, 0, &Usage);
		EXPECT_EQ(ExpectedExitCode, WIFEXITED(Status) ? WEXITSTATUS(Status) : -1) << Arguments[0];
		return Usage;
	}

	/** File names of the libraries that the last call loaded, shaders that were compiled for it left out. */
	std::set<std::string> GetLibraries() const
	{
		std::set<std::string> Names;
		std::istringstream Lines(ReadBytes(Temporary.Path / "log.txt"));
		for (std::string Line; std::getline(Lines, Line);)
		{
			const std::string Mark = "calling init: ";
			const size_t At = Line.find(Mark);
			if (At != std::string::npos && Line.find("shader-cache") == std::string::npos)
			{
				Names.insert(Files::path(Line.substr(At + Mark.size())).filename().string());
			}
		}
		return Names;
	}

	bool LoadsOpenImageIO() const
	{
		for (const std::string& Name : GetLibraries())
		{
			if (Name.find("OpenImageIO") != std::string::npos)
			{
				return true;
			}
		}
		return false;
	}

	const FTemporaryFolder Temporary{"drydock_cost"};
};

/** Red, green and blue of a picture that is no constant. */
void WriteScene(const std::string& Path, int Width, int Height)
{
	FExrDescription Description;
	Description.Width = Width;
	Description.Height = Height;
	Description.Channels = {"R", "G", "B"};
	Description.Half = {true, true, true};
	WriteExrRows(Path, Description,
		[Width](int Y, float* Row)
		{
			for (int Index = 0; Index < 3 * Width; ++Index)
			{
				Row[Index] = static_cast<float>((Index * 7 + Y * 13) % 64) / 32.0f;
			}
		});
}

} // namespace

TEST_F(RunCost, FewLibrariesAreLoadedAndOpenImageIOOnlyForItsFormats)
{
	const std::vector<std::vector<std::string>> Calls = {{"--version"}, {"list", "passes"},
		{"check", Configs + "toon_bloom.json"}, {"blend", Configs + "toon_bloom.json"},
		{"run", Configs + "neutral.json", "--out", "out"}};
	for (const std::vector<std::string>& Call : Calls)
	{
		Run(Call);
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
		const size_t OfSanitizers = 2;
#else
		const size_t OfSanitizers = 0;
#endif
		EXPECT_LE(GetLibraries().size(), 25u + OfSanitizers) << Call[0];
		EXPECT_GE(GetLibraries().size(), 5u) << Call[0] << ": the linker says nothing any more";
		EXPECT_FALSE(LoadsOpenImageIO()) << Call[0];
	}
	std::ofstream(Temporary.Path / "grey.hdr", std::ios::binary) << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n"
																 << std::string("\x80\x80\x80\x81", 4);
	std::ofstream(Temporary.Path / "grey.json") << R"({"scene": {"file": "grey.hdr"}})";
	Run({"run", "grey.json", "--out", "grey"});
	EXPECT_TRUE(LoadsOpenImageIO());
}

TEST_F(RunCost, MemoryIsAFewBytesAPixel)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
	GTEST_SKIP() << "a sanitizer's own memory counts here";
#endif
	WriteScene(Temporary.Path / "small.exr", 320, 180);
	WriteScene(Temporary.Path / "large.exr", 3200, 1800);
	std::vector<long> Kilobytes;
	for (const std::string Name : {"small", "large"})
	{
		std::ofstream(Temporary.Path / (Name + ".json"))
			<< R"({"scene": {"file": ")" << Name << R"(.exr"}, "camera": {"Settings": {"BloomIntensity": 1}}})";
		Kilobytes.push_back(Run({"run", Name + ".json", "--out", Name}).ru_maxrss);
	}
	const double Pixels = 3200.0 * 1800.0 - 320.0 * 180.0;
	EXPECT_LT(1024.0 * static_cast<double>(Kilobytes[1] - Kilobytes[0]) / Pixels, 48.0);
}

TEST_F(RunCost, PartsOfTheTimeAddUp)
{
	Run({"run", Configs + "toon_bloom.json", "--out", "out"});
	std::vector<FDiagnostic> Diagnostics;
	bool bSyntaxError = false;
	const FJsonValue Timing =
		ParseJson(ReadBytes(Temporary.Path / "out/timing.json"), "timing.json", Diagnostics, bSyntaxError);
	ASSERT_FALSE(bSyntaxError);
	double Sum = 0.0;
	for (const char* const Part : {"startMs", "setupMs", "loadMs", "compileMs", "executeMs", "reportMs", "saveMs"})
	{
		ASSERT_NE(nullptr, Timing.Find(Part)) << Part;
		EXPECT_LE(0.0, Timing.Find(Part)->Number) << Part;
		Sum += Timing.Find(Part)->Number;
	}
	const double Wall = Timing.Find("wallMs")->Number;
	EXPECT_LT(0.95 * Wall, Sum);
	EXPECT_LE(Sum, Wall);
}
