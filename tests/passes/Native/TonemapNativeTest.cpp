// The tonemapper's native kernel against its shader: the same stored bits for drawn pictures, rects, formats, lens and
// exposure, hazards included; and that it does the work.
#include "NativeTestUtils.h"

#include "NativeFallback.h"
#include "Tonemap/PostProcessCombineLUTs.h"
#include "Tonemap/PostProcessTonemap.h"

using namespace Drydock;
using namespace PassTest;

namespace
{

struct FParts
{
	bool bBloom = false;
	bool bVignette = false;
	bool bFringe = false;
	bool bSharpen = false;
	bool bGrain = false;
	bool bLocalExposure = false;
	bool bCompute = false;
	bool bTable = true;
	float Contrast = 1.0f; // of the table
	EPixelFormat OutputFormat = PF_B8G8R8A8;
	unsigned Seed = 1;
};

FImage Tonemap(const FPlace& Place, const FParts& Parts)
{
	std::mt19937 Random(Parts.Seed);
	const auto Draw = [&Random](double Low, double High)
	{
		return static_cast<float>(std::uniform_real_distribution<double>(Low, High)(Random));
	};
	FPassRun Run(Place.Image, Place.Rect, Place.Extent, EArithmetic::Native, Place.Format);
	FFinalPostProcessSettings& Settings = Run.View.FinalPostProcessSettings;
	Settings.VignetteIntensity = Parts.bVignette ? Draw(0.1, 1.0) : 0.0f;
	Settings.SceneFringeIntensity = Parts.bFringe ? Draw(0.5, 5.0) : 0.0f;
	Settings.ChromaticAberrationStartOffset = Draw(0.0, 0.5);
	Settings.Sharpen = Parts.bSharpen ? Draw(0.1, 3.0) : 0.0f;
	Settings.FilmGrainIntensity = Parts.bGrain ? Draw(0.1, 1.0) : 0.0f;
	Settings.ColorContrast = FVector4(1.0f, 1.0f, 1.0f, Parts.Contrast);
	Settings.SceneColorTint = FLinearColor(1.0f, 0.75f, 0.5f);
	Run.View.PreExposure = 0.7f;
	Run.View.bUseComputePasses = Parts.bCompute;
	Run.View.InitViewUniformBuffer(Place.Extent);
	FLocalExposureTextures LocalExposure;
	FTonemapInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(Run.GraphBuilder, Draw(0.2, 3.0));
	Inputs.OutputFormat = Parts.OutputFormat;
	Inputs.bWriteAlphaChannel = Parts.bSharpen;
	if (Parts.bTable)
	{
		Inputs.ColorGradingTexture = AddCombineLUTPass(Run.GraphBuilder, Run.View);
	}
	if (Parts.bLocalExposure)
	{
		LocalExposure = DrawLocalExposure(Run, Random);
		LocalExposure.GiveTo(Inputs);
	}
	if (Parts.bBloom)
	{
		const int Width = (Place.Rect.Width() + 1) / 2;
		const int Height = (Place.Rect.Height() + 1) / 2;
		Inputs.Bloom = Run.AddInput(FImage::Noise(Width, Height), {2, 1, Width + 2, Height + 1},
			FIntPoint(Width + 4, Height + 3), PF_FloatR11G11B10, TEXT("Bloom"));
	}
	return Run.Execute(AddTonemapPass(Run.GraphBuilder, Run.View, Inputs));
}

/** Few: each is a shader to compile. */
const std::vector<FParts> GPermutations = {
	{},
	{.bBloom = true},
	{.bVignette = true, .bSharpen = true},
	{.bBloom = true, .bFringe = true, .bGrain = true},
	{.bBloom = true, .bVignette = true, .bFringe = true, .bSharpen = true, .bGrain = true, .bLocalExposure = true},
};

FPlace FillTexture(int Width, int Height)
{
	return {FImage::Noise(Width, Height), {0, 0, Width, Height}, FIntPoint(Width, Height), PF_FloatRGBA};
}

} // namespace

TEST(TonemapNative, HasTheShadersBits)
{
	std::mt19937 Random(18);
	const EPixelFormat Formats[] = {PF_B8G8R8A8, PF_A2B10G10R10, PF_FloatRGBA, PF_A32B32G32R32F};
	for (unsigned Case = 0; Case < 40; ++Case)
	{
		const FPlace Place = DrawPlace(Random);
		FParts Parts = GPermutations[Case % GPermutations.size()];
		Parts.OutputFormat = Formats[Case / GPermutations.size() % std::size(Formats)];
		Parts.Seed = Case + 1;
		ExpectSameBits([&] { return Tonemap(Place, Parts); }, "case " + std::to_string(Case) + ", " + Describe(Place));
	}
}

TEST(TonemapNative, HasTheBitsOfTheComputeShader)
{
	std::mt19937 Random(4);
	for (unsigned Case = 0; Case < 4; ++Case)
	{
		const FPlace Place = DrawPlace(Random);
		FParts Parts = GPermutations[1];
		Parts.bCompute = true;
		ExpectSameBits([&] { return Tonemap(Place, Parts); }, "case " + std::to_string(Case) + ", " + Describe(Place));
	}
}

// Pictures with more pixels than twice the table's texels: each of their passes looks up in a copy of its own table.
TEST(TonemapNative, HasTheShadersBitsByACopyOfTheTable)
{
	std::mt19937 Random(29);
	for (const float TableSize : {16.0f, 21.0f, 32.0f})
	{
		const FScopedConsoleVariable Size(TEXT("r.LUT.Size"), TableSize);
		const int Width = 307;
		const int Height = static_cast<int>(2 * TableSize * TableSize * TableSize) / Width + 1;
		for (const bool bHazards : {false, true})
		{
			FPlace Place = FillTexture(Width, Height);
			Place.Image = Draw(Random, Width, Height, bHazards);
			ExpectSameBits([&] { return Tonemap(Place, {.Contrast = bHazards ? 1.4f : 1.0f}); },
				"a table of " + std::to_string(TableSize) + (bHazards ? ", hazards" : ""));
		}
	}
}

TEST(TonemapNative, PicturesOfAnySizeAreNotLeftToTheShader)
{
	const uint64_t Before = GetNativeFallbacks();
	for (const auto& [Width, Height] : {std::pair(640, 360), {641, 359}, {1, 1}, {3, 200}})
	{
		Tonemap(FillTexture(Width, Height), GPermutations.back());
	}
	EXPECT_EQ(Before, GetNativeFallbacks());
}

TEST(TonemapNative, WithoutTheTableTheShaderDoesIt)
{
	const uint64_t Before = GetNativeFallbacks();
	FParts Parts;
	Parts.bTable = false;
	Tonemap(FillTexture(20, 10), Parts);
	EXPECT_LT(Before, GetNativeFallbacks());
}
