// Convolution bloom in whole frames: kernels from files, what it falls back to, toon bloom and RED beside it, and the
// kernel that a view keeps.
#include <gtest/gtest.h>

#include "pipeline/EffectTestUtils.h"
#include "ExtensionTestUtils.h"

#include "Picture/ImageFile.h"
#include "Run/Run.h"
#include "Text/ConfigErrors.h"

#include <algorithm>
#include <filesystem>

using namespace ExtensionTest;

namespace
{

const std::string ConfigFolder = DRYDOCK_TEST_SOURCE_DIR "/configs/";

FRunResult RunFFT(const std::string& Settings, const std::vector<std::string>& Variables = {},
	const std::string& Method = R"("BloomMethod": "BM_FFT", )")
{
	FRunOptions Options;
	Options.ConfigFile = ConfigFolder + "text.json";
	Options.ConfigText = R"({"scene": {"file": "scenes/toon_character_641x359.exr"}, "volumes": [{"bUnbound": true,
		"Settings": {)" + Method +
						 R"("BloomConvolutionSize": 0.2, )" + Settings + R"("BloomIntensity": 1}}]})";
	Options.Variables = Variables;
	return RunConfig(Options);
}

bool HasPass(const FRDGCompiledGraph& Graph, const std::string& Begin)
{
	return std::any_of(Graph.Passes.begin(), Graph.Passes.end(),
		[&](const FRDGCompiledPass& Pass) { return !Pass.bCulled && Pass.Name.starts_with(Begin); });
}

/** A file with a kernel of 5 x 3 texels, while it lives. */
class FKernelFile
{
public:
	FKernelFile()
		: Path((std::filesystem::temp_directory_path() / "FFTBloomRunTest.exr").string())
	{
		FImage Kernel{5, 3, 3, std::vector<double>(45, 0.25)};
		std::fill_n(Kernel.Values.begin() + 7 * 3, 3, 16.0);
		WriteExr(Path, Kernel, {"R", "G", "B"});
	}
	~FKernelFile() { std::filesystem::remove(Path); }

	std::string GetSetting() const { return R"("BloomConvolutionTexture": ")" + Path + R"(", )"; }

private:
	std::string Path;
};

} // namespace

TEST(FFTBloomRun, TakesThePlaceOfTheSumOfGaussians)
{
	const FRunResult Result = RunFFT("");
	EXPECT_TRUE(HasPass(Result.Graph, "FFTBloom.Multiply"));
	EXPECT_FALSE(HasPass(Result.Graph, "Bloom6"));
	EXPECT_FALSE(HasPass(Result.Graph, "HalfResolutionSceneColor"));
	EXPECT_TRUE(FindEffect(Result, "Bloom").bActive);
}

TEST(FFTBloomRun, HalfTheResolutionReadsTheHalfResolutionPicture)
{
	const FRunResult Result = RunFFT("", {"r.Bloom.ScreenPercentage=50"});
	EXPECT_TRUE(HasPass(Result.Graph, "FFTBloom.PreFilter 321x180"));
	EXPECT_TRUE(HasPass(Result.Graph, "HalfResolutionSceneColor"));
}

TEST(FFTBloomRun, KernelsComeFromFiles)
{
	const FKernelFile File;
	const FRunResult Result = RunFFT(File.GetSetting());
	EXPECT_TRUE(HasPass(Result.Graph, "FFTBloom.ClampKernel 5x3"));
}

TEST(FFTBloomRun, ALineTakesLittleMemory)
{
	const std::filesystem::path Folder = std::filesystem::temp_directory_path() / "FFTBloomRunTest";
	std::filesystem::create_directories(Folder);
	for (const FIntPoint Size : {FIntPoint(16384, 1), FIntPoint(1, 16384)})
	{
		WriteExr((Folder / "line.exr").string(), FImage{Size.X, Size.Y, 3, std::vector<double>(3 * 16384, 0.5)},
			{"R", "G", "B"});
		FRunOptions Options;
		Options.ConfigFile = (Folder / "line.json").string();
		Options.ConfigText = R"({"scene": {"file": "line.exr"}, "volumes": [{"bUnbound": true,
			"Settings": {"BloomMethod": "BM_FFT", "BloomIntensity": 1}}]})";
		const FRunResult Result = RunConfig(Options);
		EXPECT_LT(Result.Graph.Memory.TransientPeakBytes, 8u << 20) << Size.X; // docs/fft-bloom.md
		EXPECT_EQ(FIntPoint(Result.Final.Width, Result.Final.Height), Size);
	}
	std::filesystem::remove_all(Folder);
}

TEST(FFTBloomRun, AMissingFileIsAnError)
{
	try
	{
		RunFFT(R"("BloomConvolutionTexture": "nowhere/kernel.exr", )");
		FAIL();
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(ExitFiles, Error.GetExitCode());
		EXPECT_EQ(ErrorFileMissing, Error.GetDiagnostics().back().Code);
	}
}

TEST(FFTBloomRun, AnEngineAssetHasNoPixelsSoTheSumOfGaussiansRuns)
{
	const FRunResult Result = RunFFT(R"("BloomConvolutionTexture": "/Game/Lens/Kernel.Kernel", )");
	EXPECT_TRUE(HasPass(Result.Graph, "Bloom6"));
	EXPECT_EQ(RunFFT("", {}, "").Final.ToImage().Values, Result.Final.ToImage().Values);
	ASSERT_FALSE(Result.Diagnostics.empty());
	EXPECT_EQ(WarnIneffectiveValue, Result.Diagnostics[0].Code);
	EXPECT_EQ("BloomMethod BM_FFT: there are no pixels for BloomConvolutionTexture /Game/Lens/Kernel.Kernel, so the "
			  "Gaussian sum runs",
		Result.Diagnostics[0].Message);
}

TEST(FFTBloomRun, ToonBloomMasksTheWholeResolution)
{
	const FRunResult Less = RunFFT(R"("BloomToonIntensity": 0.1, )"), More = RunFFT(R"("BloomToonIntensity": 0.9, )");
	EXPECT_TRUE(HasPass(Less.Graph, "BloomSetup 641x359"));
	EXPECT_TRUE(HasPass(Less.Graph, "FFTBloom.Multiply"));
	EXPECT_TRUE(FindEffect(Less, "ToonBloom").bActive);
	EXPECT_NE(Less.Final.ToImage().Values, More.Final.ToImage().Values);
}

TEST(FFTBloomRun, AToonFactorOfOneGivesTheBitsOfAFrameWithoutIt)
{
	for (const char* Percentage : {"100", "50", "25"})
	{
		const std::string Resolution = std::string("r.Bloom.ScreenPercentage=") + Percentage;
		const FRunResult Without = RunFFT("", {Resolution});
		const FRunResult Forced = RunFFT(R"("BloomToonIntensity": 1, )", {Resolution, "r.ToonBloom=1"});
		EXPECT_TRUE(HasPass(Forced.Graph, "BloomSetup"));
		EXPECT_EQ(Without.Final.ToImage().Values, Forced.Final.ToImage().Values) << Percentage;
	}
}

TEST(FFTBloomRun, WhatREDReadsHasBloomAndTheRestOfTheSceneColour)
{
	const FRunResult Result = RunFFT(R"("DiffusionFilterIntensity": 0.5, )", {"r.REDPostprocessAfterTranslucency=2"});
	EXPECT_TRUE(HasPass(Result.Graph, "FFTBloom.ApplySceneColor"));
	EXPECT_TRUE(HasPass(Result.Graph, "BloomComposite"));
}

TEST(FFTBloomFrame, AViewKeepsItsKernelForTheNextFrame)
{
	FFrameInputs Inputs = MakeFrame();
	Inputs.Views[0].Settings.Settings.BloomMethod = BM_FFT;
	Inputs.Views[0].Settings.Settings.BloomIntensity = 1.0f;
	Inputs.Views[0].State = std::make_shared<FSceneViewState>(1);
	const FFrameResult First = Render(Inputs);
	const FFrameResult Second = Render(Inputs);
	Inputs.bExecute = false;
	const FFrameResult Third = Render(Inputs);
	EXPECT_EQ(First.Final.ToImage().Values, Second.Final.ToImage().Values);
	EXPECT_TRUE(HasPass(Third.Graph, "FFTBloom.Multiply"));
	EXPECT_FALSE(HasPass(Third.Graph, "FFTBloom.FindKernelCenter"));
	Inputs.Views[0].State = nullptr;
	EXPECT_TRUE(HasPass(Render(Inputs).Graph, "FFTBloom.FindKernelCenter"));
}
