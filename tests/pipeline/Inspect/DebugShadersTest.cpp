// Shaders under a debugger: a gdb session as docs/see-inside.md has it, what the shaders of shipped configs give when
// they are built for it, and that nobody's picture is another.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Inspect/DebugCapture.h"
#include "PixelFormatConversion.h"
#include "ProgramTestUtils.h"
#include "Run/Run.h"
#include "Sandbox.h"
#include "Shader.h"
#include "ShaderCompilation.h"
#include "TileExecutor.h"

#include <cstdlib>
#include <cstring>
#include <map>
#include <random>

using namespace Drydock;
using ProgramTest::FOutcome;
using ProgramTest::FProgramFolder;
using testing::HasSubstr;

namespace
{

constexpr int ThreadsPerDispatch = 10;

const uint8_t* FindTexel(const FKernelTexture& Texture, int32_t Mip, int64_t X, int64_t Y, int64_t Z)
{
	const FKernelMip& Level = Texture.Mips[Mip];
	return Level.Data + Z * Level.SlicePitch + Y * Level.RowPitch +
		   X * GetTexelStorageInfo(Texture.Storage).BytesPerTexel;
}

/** Runs random threads of each dispatch as a debugger would, and compares with what the kernel then stores. */
class FDebuggedThreads final : public IDispatchObserver
{
public:
	void BeforeDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) override
	{
		Expected.clear();
		std::unique_ptr<FDebuggedShader>& Debugged = Shaders[Shader.Permutation];
		if (!Debugged)
		{
			const FShaderRef Permutation(Shader.Permutation);
			Debugged = std::make_unique<FDebuggedShader>(
				MakeShaderCompileRequest(Permutation, Permutation.GetRootParametersMetadata()), Shader.GetReflection());
		}
		const FSandbox Sandbox(Args, Shader.GetReflection());
		const auto Draw = [this](int32_t Min, int32_t Max)
		{
			return int32_t(Random() % uint32_t(std::max(1, Max - Min))) + Min;
		};
		const FScopedDenormals Denormals(EDenormals::Flush);
		for (int i = 0; i < ThreadsPerDispatch; ++i)
		{
			const std::array<int32_t, 3> At = {
				Draw(Whole.MinX, Whole.MaxX), Draw(Whole.MinY, Whole.MaxY), Draw(Whole.MinZ, Whole.MaxZ)};
			AddTargets(Args, Debugged->Run(Sandbox.GetArgs(), Whole, At, 1'000'000'000), At);
		}
		for (size_t Slot = 0; Slot < Shader.RWTextures.size(); ++Slot)
		{
			AddStores(Shader.RWTextures[Slot], Sandbox.GetArgs().RWTextures[Slot]);
		}
	}

	void AfterDispatch(const FBoundShader& Shader, const FKernelArgs&, const FKernelTile&) override
	{
		for (const auto& [Address, Bytes] : Expected)
		{
			++NumTexels;
			if (std::memcmp(Address, Bytes.data(), Bytes.size()) != 0)
			{
				Differences.insert(Shader.Name);
			}
		}
	}

	size_t NumTexels = 0;
	size_t NumStored = 0; // of them, by compute shaders
	std::set<std::string> Differences;
	std::map<FShader*, std::unique_ptr<FDebuggedShader>> Shaders;

private:
	void AddTargets(const FKernelArgs& Args, const FDebuggedThread& Thread, const std::array<int32_t, 3>& At)
	{
		for (size_t Target = 0; Target < Thread.Targets.size() && int32_t(Target) < Args.NumTargets; ++Target)
		{
			const FKernelTarget& View = Args.Targets[Target];
			float Color[4] = {0, 0, 0, 1};
			std::copy_n(Thread.Targets[Target].begin(), std::min<size_t>(4, Thread.Targets[Target].size()), Color);
			std::vector<uint8_t> Bytes(size_t(GetTexelStorageInfo(View.Texture.Storage).BytesPerTexel));
			EncodeTexel(View.Texture.Storage, Color, Bytes.data(), View.Texture.bSaturateStore != 0);
			if (!View.bBlend && View.WriteMask == 15)
			{
				Expected[FindTexel(View.Texture, 0, At[0], At[1], 0)] = Bytes;
			}
		}
	}

	/** Texels that the threads changed in the sandbox. */
	void AddStores(const FKernelTexture& Before, const FKernelTexture& After)
	{
		const int64_t Size = GetTexelStorageInfo(Before.Storage).BytesPerTexel;
		const FKernelMip& Mip = Before.Mips[0];
		for (int64_t i = 0; i < int64_t(Mip.SizeX) * Mip.SizeY * Mip.SizeZ; ++i)
		{
			const int64_t X = i % Mip.SizeX;
			const int64_t Y = i / Mip.SizeX % Mip.SizeY;
			const int64_t Z = i / Mip.SizeX / Mip.SizeY;
			const uint8_t* const Stored = FindTexel(After, 0, X, Y, Z);
			const uint8_t* const There = FindTexel(Before, 0, X, Y, Z);
			if (std::memcmp(Stored, There, size_t(Size)) != 0)
			{
				Expected[There] = {Stored, Stored + Size};
				++NumStored;
			}
		}
	}

	std::mt19937 Random{19};
	std::map<const uint8_t*, std::vector<uint8_t>> Expected; // by address
};

/** Those that are looked at always: loops, branches, structs, matrices, stores; and with the variable set, all. */
std::vector<std::string> FindConfigs()
{
	const std::string Folder = DRYDOCK_TEST_SOURCE_DIR "/configs/";
	std::vector<std::string> Found = {Folder + "toon_bloom.json", Folder + "bloom_fft.json"};
	if (!std::getenv("DRYDOCK_DEBUG_ALL_SHADERS"))
	{
		return Found;
	}
	Found.clear();
	for (const auto& Entry : std::filesystem::directory_iterator(Folder))
	{
		if (Entry.path().extension() != ".json")
		{
			continue;
		}
		std::ifstream Stream(Entry.path());
		const std::string Text(std::istreambuf_iterator<char>(Stream), {});
		if (Text.find("\"scene\"") != std::string::npos)
		{
			Found.push_back(Entry.path().string());
		}
	}
	return Found;
}

TEST(DebugShaders, GiveTheTexelsOfTheKernels)
{
	size_t NumTexels = 0;
	size_t NumStored = 0;
	size_t NumShaders = 0;
	for (const std::string& Config : FindConfigs())
	{
		FDebuggedThreads Threads;
		FRunOptions Options;
		Options.ConfigFile = Config;
		{
			const FScopedDispatchObserver Scope(Threads);
			RunConfig(Options);
		}
		EXPECT_EQ(std::set<std::string>(), Threads.Differences) << Config;
		NumTexels += Threads.NumTexels;
		NumStored += Threads.NumStored;
		NumShaders += Threads.Shaders.size();
	}
	RecordProperty("shaders", int(NumShaders));
	RecordProperty("texels", int(NumTexels));
	EXPECT_GE(NumShaders, 8u);
	EXPECT_GE(NumTexels, 200u);
	EXPECT_GE(NumStored, 20u);
}

class DebuggedRun : public testing::Test
{
protected:
	DebuggedRun()
	{
		const FImage Scene{6, 5, 3, std::vector<double>(6 * 5 * 3, 0.5)};
		WriteExr((Folder.Path / "scene.exr").string(), Scene, {"R", "G", "B"});
		Folder.Write(
			"faults.json", R"({"scene": {"file": "scene.exr"}, "camera": {"Settings": {"BloomIntensity": 0}}})");
	}

	/** The first mistake of tests/plugins/PlantedFaults: a blur of three taps, 0, Strength and 2 * Strength. */
	std::string Run(const std::string& More) const
	{
		return "run faults.json --plugin " DRYDOCK_TEST_BINARY_DIR
			   "/lib/libPlantedFaults.so --set r.PlantedFaults=1 --out out " +
			   More;
	}

	/** What gdb prints; empty where there is none. */
	std::string CallGdb(const std::string& Script, const std::string& More) const
	{
		Folder.Write("script.gdb", "set breakpoint pending on\nset pagination off\n" + Script);
		const std::string Command = "cd '" + Folder.Path.string() +
									"' && command -v gdb >/dev/null && gdb -nx -batch -x script.gdb --args "
									"'" DRYDOCK_TEST_BINARY_DIR "/bin/drydock' " +
									Run(More) + " 2>&1";
		std::string Printed;
		FILE* const Pipe = popen(Command.c_str(), "r");
		for (int Letter; (Letter = std::fgetc(Pipe)) != EOF;)
		{
			Printed += char(Letter);
		}
		pclose(Pipe);
		return Printed;
	}

	const FProgramFolder Folder{"debugged"};
};

// Pixel (4, 3) has Strength 1; the scene is (0.5, 0.5, 0.5, 1).
TEST_F(DebuggedRun, GdbStopsAtALineAndShowsTheAuthorsVariables)
{
	const std::string Printed = CallGdb("break PlantedFaults.usf:14 if i == 2\n"
										"run\n"
										"print Tap\nprint Sum\nprint Weight\nprint Fault\nwhatis Pixel\n"
										"info locals\n"
										"next\nprint Sum\n"
										"finish\n"
										"set var DrydockPixel.x = 3\nset var DrydockPixel.y = 4\n"
										"continue\nprint DrydockPixel\n"
										"delete\nbreak PlantedFaults.usf:32\n"
										"skip -gfi */rdg/inspect/*\n" // where drydock itself has debug information
										"set var DrydockPixel.x = 2\nset var DrydockPixel.y = 1\ncontinue\n"
										"step\nprint Strength\n"
										"kill\n",
		"--debug-shaders 4,3 --pass PlantedFaults");
	if (Printed.empty())
	{
		GTEST_SKIP() << "there is no gdb";
	}
	std::vector<std::string> Parts = {"PlantedFaults.usf:14", "Sum += Tap * Source.Load(int3(Pixel, 0));", "$1 = 2",
		"$2 = {x = 0.5, y = 0.5, z = 0.5, w = 1}", "$3 = 1", "$4 = 1", "type = int2",
		"Sum = {x = 0.5, y = 0.5, z = 0.5, w = 1}", "Weight = 1", "i = 2", "Tap = 2", "Weight += Tap;",
		"$5 = {x = 1.5, y = 1.5, z = 1.5, w = 3}", "Value returned is $6 = {x = 0.5, y = 0.5, z = 0.5, w = 1}",
		"$7 = {x = 3, y = 4, z = 0}", "PlantedFaults.usf:32", "Blur (", "Strength=1", "PlantedFaults.usf:9", "$8 = 1"};
	size_t From = 0;
	for (const std::string& Part : Parts)
	{
		const bool bLocal = Part.find(" = ") != std::string::npos && Part[0] != '$' && Part[0] != 'V';
		const size_t At = Printed.find(Part, bLocal ? 0 : From);
		ASSERT_NE(std::string::npos, At) << "no '" << Part << "' in\n" << Printed;
		From = bLocal ? From : At;
	}
}

TEST_F(DebuggedRun, AFunctionOrAVariableChoosesTheNextPixel)
{
	const std::string Outside = "outside of what this pass draws";
	const std::string More = "--debug-shaders 4,3 --pass PlantedFaults";
	const std::string Set = CallGdb("break PlantedFaults.usf:14 if i == 2\nrun\ndelete\n"
									"set var DrydockPixel.x = 6\ncontinue\n",
		More);
	if (Set.empty())
	{
		GTEST_SKIP() << "there is no gdb";
	}
	EXPECT_NE(std::string::npos, Set.find("DrydockPixel: " + Outside)) << Set;
	const std::string Called = CallGdb("break PlantedFaults.usf:14 if i == 2\nrun\n"
									   "call DrydockDebugPixel(6, 0)\ncall DrydockDebugPixel(3, 4)\n"
									   "continue\nprint DrydockPixel\nkill\n",
		More);
	if (Called.find("Couldn't write extended state status") != std::string::npos)
	{
		GTEST_SKIP() << "this gdb cannot call functions on this CPU";
	}
	for (const char* const Part : {Outside.c_str(), "this pixel is next: continue", "{x = 3, y = 4, z = 0}"})
	{
		EXPECT_NE(std::string::npos, Called.find(Part)) << "no '" << Part << "' in\n" << Called;
	}
}

TEST_F(DebuggedRun, TheVariablesCanBeSet)
{
	const std::string Printed = CallGdb("break PlantedFaults.usf:17\nrun\n"
										"set var Weight = 6\nfinish\n"
										"kill\n",
		"--debug-shaders 4,3 --pass PlantedFaults");
	if (Printed.empty())
	{
		GTEST_SKIP() << "there is no gdb";
	}
	EXPECT_THAT(Printed, HasSubstr("Value returned is $1 = {x = 0.25, y = 0.25, z = 0.25, w = 0.5}"));
}

TEST_F(DebuggedRun, ThePictureIsTheSame)
{
	ASSERT_EQ(0, Folder.Call(Run("--outputs exr")).ExitCode);
	const std::string Before = Folder.Read("out/final.exr");
	const FOutcome Outcome = Folder.Call(Run("--outputs exr --debug-shaders 4,3"));
	ASSERT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	ASSERT_FALSE(Before.empty());
	EXPECT_TRUE(Before == Folder.Read("out/final.exr"));
	EXPECT_THAT(Outcome.Printed, HasSubstr("warning DD6060 at --debug-shaders: no debugger holds this process"));
}

TEST_F(DebuggedRun, WhatIsNotThereIsSaid)
{
	const FOutcome Outside = Folder.Call(Run("--debug-shaders 6,3"));
	EXPECT_EQ(2, Outside.ExitCode);
	EXPECT_THAT(Outside.Printed, HasSubstr("'6,3' is not a pixel of the frame, which is 6 x 5"));
	const FOutcome Word = Folder.Call(Run("--debug-shaders 4,x"));
	EXPECT_EQ(2, Word.ExitCode);
	EXPECT_THAT(Word.Printed, HasSubstr("'4,x' is not a pixel"));
	const FOutcome Pass = Folder.Call(Run("--debug-shaders 4,3 --pass Tonemop"));
	EXPECT_EQ(2, Pass.ExitCode);
	EXPECT_THAT(Pass.Printed, HasSubstr("no pass of this run draws that pixel with a shader that matches 'Tonemop'"));
	EXPECT_THAT(Pass.Printed, HasSubstr("PlantedFaults"));
}

} // namespace
