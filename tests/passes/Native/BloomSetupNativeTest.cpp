// The bloom setup's native kernel against its shader: the same stored bits for drawn pictures, rects, formats,
// thresholds and local exposure, hazards included, with toon bloom and without; and that it does the work.
#include "NativeTestUtils.h"

#include "Bloom/ToonBloomSetup.h"
#include "NativeFallback.h"

using namespace Drydock;
using namespace PassTest;

namespace
{

struct FSetup
{
	float Threshold = -1.0f;
	bool bLocalExposure = false;
	bool bToon = false;
	bool bCompute = false;
	unsigned Seed = 1;
};

FImage SetUpBloom(const FPlace& Place, const FSetup& Setup)
{
	std::mt19937 Random(Setup.Seed);
	FPassRun Run(Place.Image, Place.Rect, Place.Extent, EArithmetic::Native, Place.Format);
	Run.View.PreExposure = 0.6f;
	Run.View.bUseComputePasses = Setup.bCompute;
	Run.View.InitViewUniformBuffer(Place.Extent);
	FSceneTextures SceneTextures;
	SceneTextures.Color = Run.Input.Texture;
	const FImage Ids = FImage::Make(Place.Image.Width, Place.Image.Height,
		[](int X, int Y)
		{
			constexpr double Cloth = 8.0 / 255.0;
			return FTexel{0, 0, 0, (X / 5 + Y / 3) % 2 == 0 ? Cloth : 1.0 / 255.0};
		});
	SceneTextures.GBufferB = Run.AddInput(Ids, Place.Rect, Place.Extent, PF_B8G8R8A8, TEXT("GBufferB")).Texture;
	Run.View.SceneTextures = &SceneTextures;
	FLocalExposureTextures LocalExposure;
	FBloomSetupInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(Run.GraphBuilder, 1.7f);
	Inputs.Threshold = Setup.Threshold;
	if (Setup.bLocalExposure)
	{
		LocalExposure = DrawLocalExposure(Run, Random);
		LocalExposure.GiveTo(Inputs);
	}
	if (Setup.bToon)
	{
		return Run.Execute(AddToonBloomSetupPass(Run.GraphBuilder, Run.View, Inputs,
			{Run.Input, CreateSceneTextureUniformBuffer(Run.GraphBuilder, Run.View), 1.5f}));
	}
	return Run.Execute(AddBloomSetupPass(Run.GraphBuilder, Run.View, Inputs));
}

} // namespace

TEST(BloomSetupNative, HasTheShadersBits)
{
	std::mt19937 Random(6);
	for (unsigned Case = 0; Case < 32; ++Case)
	{
		const FPlace Place = DrawPlace(Random);
		FSetup Setup;
		Setup.Threshold = Case % 2 == 0 ? -1.0f : std::uniform_real_distribution<float>(-0.5f, 3.0f)(Random);
		Setup.bLocalExposure = Case % 4 >= 2;
		Setup.bToon = Case % 8 >= 4;
		Setup.bCompute = Case == 9;
		Setup.Seed = Case + 1;
		ExpectSameBits(
			[&] { return SetUpBloom(Place, Setup); }, "case " + std::to_string(Case) + ", " + Describe(Place));
	}
}

// One thread takes tiles wider than what is set up at a time.
TEST(BloomSetupNative, HasTheBitsOfTheShaderInWidePictures)
{
	std::mt19937 Random(21);
	for (const int Width : {256, 257, 700})
	{
		FPlace Place = {Draw(Random, Width, 9, true), {3, 2, Width + 3, 11}, FIntPoint(Width + 5, 12), PF_FloatRGBA};
		for (const bool bEverything : {false, true})
		{
			ExpectSameBits([&]
				{ return SetUpBloom(Place, {.Threshold = 0.5f, .bLocalExposure = bEverything, .bToon = bEverything}); },
				std::to_string(Width) + " pixels wide");
		}
	}
}

TEST(BloomSetupNative, PicturesOfAnySizeAreNotLeftToTheShader)
{
	const uint64_t Before = GetNativeFallbacks();
	for (const auto& [Width, Height] : {std::pair(641, 359), {1, 1}, {2, 130}})
	{
		const FPlace Place = {
			FImage::Noise(Width, Height), {0, 0, Width, Height}, FIntPoint(Width, Height), PF_FloatR11G11B10};
		SetUpBloom(Place, {.Threshold = 1.0f, .bLocalExposure = true});
	}
	EXPECT_EQ(Before, GetNativeFallbacks());
}
