// `drydock import` as a user types it: table, exit codes, and toon bloom on what it wrote.
#include "pipeline/Import/ImportTestUtils.h"

#include <OpenImageIO/imageio.h>
#include <array>
#include <cstdio>
#include <fstream>
#include <sys/wait.h>

using namespace ImportTest;

namespace
{

struct FOutcome
{
	int ExitCode = -1;
	std::string Out; // with what goes to stderr, unless Arguments send that elsewhere
};

class ImportProgram : public FImportFolder
{
protected:
	/** In the test's own folder. */
	FOutcome Call(const std::string& Arguments) const
	{
		const std::string Command =
			"cd '" + Folder.string() + "' && '" DRYDOCK_TEST_BINARY_DIR "/bin/drydock' 2>&1 " + Arguments;
		FOutcome Outcome;
		FILE* Pipe = popen(Command.c_str(), "r");
		std::array<char, 4096> Buffer;
		for (size_t NumRead; (NumRead = fread(Buffer.data(), 1, Buffer.size(), Pipe)) > 0;)
		{
			Outcome.Out.append(Buffer.data(), NumRead);
		}
		Outcome.ExitCode = WEXITSTATUS(pclose(Pipe));
		return Outcome;
	}

	/** Mean of red in the left or right half of a picture. */
	double GetMean(const std::string& Name, bool bRight) const
	{
		const std::vector<float> Red = Read(Name, "R");
		const int Width = FImageFile(PathOf(Name)).GetWidth();
		double Sum = 0.0;
		for (size_t Pixel = 0; Pixel < Red.size(); ++Pixel)
		{
			Sum += (static_cast<int>(Pixel) % Width >= Width / 2) == bRight ? static_cast<double>(Red[Pixel]) : 0.0;
		}
		return Sum / static_cast<double>(Red.size() / 2);
	}
};

/** 64 x 32 of light grey; in the right half toon by its id. */
FPart MakeFrame()
{
	FPart Part;
	Part.Width = 64;
	Part.Height = 32;
	const auto Id = [](int X, int)
	{
		return X >= 32 ? 8.0 : 1.0;
	};
	Part.Channels = Join({MakeLayer("", "RGB", {0.25}), MakeLayer("FinalImagePreTonemapHDRColor", "RGB", {0.25}),
		MakeLayer("FinalImageMovieRenderQueue_WorldDepth", "R", {350}), {{"FinalImageDrydockIds.R", Id}}});
	return Part;
}

bool Contains(const std::string& Text, const std::string& Part)
{
	return Text.find(Part) != std::string::npos;
}

} // namespace

TEST_F(ImportProgram, ToonBloomRunsOnTheOutcome)
{
	Write("shot.exr", MakeFrame());
	const FOutcome Import = Call("import shot.exr --out scene.exr");
	ASSERT_EQ(0, Import.ExitCode) << Import.Out;
	EXPECT_TRUE(Contains(Import.Out, "scene.json: drydock run scene.json")) << Import.Out;
	EXPECT_TRUE(Contains(Import.Out, "8 (50.0 %)")) << Import.Out;
	const FOutcome Run = Call("run scene.json --out with");
	ASSERT_EQ(0, Run.ExitCode) << Run.Out;
	ASSERT_EQ(0, Call("run scene.json --out without --set r.ToonBloom=0").ExitCode);
	// The same light everywhere: less of it comes back where a tenth blooms.
	EXPECT_LT(GetMean("with/final.exr", true), GetMean("without/final.exr", true) - 0.02);
	EXPECT_LT(GetMean("with/final.exr", true), GetMean("with/final.exr", false) - 0.02);
}

TEST_F(ImportProgram, MistakesHaveNumbersAndExitCodes)
{
	Write("shot.exr", MakeFrame());
	const FOutcome Unknown = Call("import shot.exr --out scene.exr --map FinalImageWorldDepth=depth --toon Hero");
	EXPECT_EQ(2, Unknown.ExitCode);
	EXPECT_TRUE(Contains(Unknown.Out, "error DD1090 at --map")) << Unknown.Out;
	EXPECT_TRUE(Contains(Unknown.Out, "error DD1090 at --toon")) << Unknown.Out;
	EXPECT_EQ(2, Call("import shot.exr --out scene.exr --unit inch").ExitCode);
	EXPECT_EQ(2, Call("import shot.exr --out scene.exr --mist 3").ExitCode);
	EXPECT_EQ(2, Call("import shot.exr --out scene.png").ExitCode);
	EXPECT_EQ(2, Call("import shot.exr").ExitCode);
	EXPECT_EQ(3, Call("import nothing.exr --out scene.exr").ExitCode);
	EXPECT_EQ(3, Call("import shot.exr --out shot.exr").ExitCode);
	EXPECT_FALSE(std::filesystem::exists(PathOf("scene.exr")));
	EXPECT_FALSE(std::filesystem::exists(PathOf("scene.json")));
}

TEST_F(ImportProgram, JsonIsForMachines)
{
	Write("shot.exr", MakeFrame());
	const FOutcome Import = Call("import shot.exr --out scene.exr --dry-run --json 2>/dev/null");
	EXPECT_EQ(0, Import.ExitCode);
	EXPECT_EQ('{', Import.Out.at(0));
	EXPECT_TRUE(Contains(Import.Out, "\"missing\": [\"normal.X\"")) << Import.Out;
	EXPECT_FALSE(std::filesystem::exists(PathOf("scene.exr")));
}
