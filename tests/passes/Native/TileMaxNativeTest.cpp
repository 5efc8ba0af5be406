// The native tile maxima of motion blur and depth of field against their shaders: the blurs that follow them have the
// same bits for drawn movements and depths, hazards included; and that they do the work.
#include "NativeTestUtils.h"

#include "Lens/DiaphragmDOF.h"
#include "Lens/PostProcessMotionBlur.h"
#include "NativeFallback.h"

using namespace Drydock;
using namespace PassTest;

namespace
{

/** A scene with drawn depths and velocities; bHazards: some are NaN or infinite, many are equal. */
class FScene
{
public:
	FScene(FPassRun& Run, const FPlace& Place, unsigned Seed)
	{
		std::mt19937 Random(Seed);
		const auto Draw = [&Random](double Low, double High)
		{
			return std::uniform_real_distribution<double>(Low, High)(Random);
		};
		const auto Add = [&](const std::function<FTexel(int, int)>& Texel, EPixelFormat Format, const TCHAR* Name)
		{
			const FImage Image = FImage::Make(Place.Image.Width, Place.Image.Height, Texel);
			return Run.AddInput(Image, Place.Rect, Place.Extent, Format, Name).Texture;
		};
		Run.View.UniformParameters.InvDeviceZToWorldZTransform = FVector4f(0.0f, 0.0f, 0.1f, 0.0f);
		Run.View.InitViewUniformBuffer(Place.Extent);
		Textures.Depth = Add(
			[&](int, int) {
				return FTexel{10 / Draw(50.0, 900.0), 0, 0, 0};
			},
			PF_R32_FLOAT, TEXT("Depth"));
		// Few values, so that tiles have several longest ones; 0 is what nothing was drawn on.
		Textures.Velocity = Add(
			[&](int, int)
			{
				const double Steps = std::floor(Draw(-3.0, 4.0));
				const double Other = std::floor(Draw(-3.0, 4.0));
				return Draw(0.0, 1.0) < 0.02 ? FTexel{NaN, Infinity, 0, 0}
											 : FTexel{0.5 + 0.02 * Steps, 0.5 + 0.02 * Other, 0, 0};
			},
			PF_A32B32G32R32F, TEXT("Velocity"));
	}

	FSceneTextures Textures;
};

FImage BlurMotion(const FPlace& Place, unsigned Seed)
{
	FPassRun Run(Place.Image, Place.Rect, Place.Extent, EArithmetic::Native, Place.Format);
	FScene Scene(Run, Place, Seed);
	FMotionBlurInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.SceneTextures = CreateSceneTextureUniformBuffer(Run.GraphBuilder, &Scene.Textures);
	Inputs.VelocityScale = 1.0f;
	Inputs.MaxLength = 40.0f;
	Inputs.Quality = EMotionBlurQuality::Low;
	return Run.Execute(AddMotionBlurPass(Run.GraphBuilder, Run.View, Inputs));
}

FImage BlurDepth(const FPlace& Place, unsigned Seed)
{
	FPassRun Run(Place.Image, Place.Rect, Place.Extent, EArithmetic::Native, Place.Format);
	FScene Scene(Run, Place, Seed);
	DiaphragmDOF::FPhysicalCocModel Model;
	Model.FocusDistance = 300.0f;
	Model.InfinityRadius = 12.0f;
	Model.MaxForegroundRadius = Model.MaxBackgroundRadius = 20.0f;
	const auto Textures = CreateSceneTextureUniformBuffer(Run.GraphBuilder, &Scene.Textures);
	return Run.Execute(
		DiaphragmDOF::AddPasses(Run.GraphBuilder, Run.View, Textures, Run.Input, Model, DiaphragmDOF::FBokehModel()));
}

} // namespace

TEST(TileMaxNative, MotionBlurHasTheShadersBits)
{
	std::mt19937 Random(12);
	for (unsigned Case = 0; Case < 12; ++Case)
	{
		const FPlace Place = DrawPlace(Random);
		ExpectSameBits(
			[&] { return BlurMotion(Place, Case); }, "case " + std::to_string(Case) + ", " + Describe(Place));
	}
}

TEST(TileMaxNative, DepthOfFieldHasTheShadersBits)
{
	std::mt19937 Random(13);
	for (unsigned Case = 0; Case < 12; ++Case)
	{
		const FPlace Place = DrawPlace(Random);
		ExpectSameBits([&] { return BlurDepth(Place, Case); }, "case " + std::to_string(Case) + ", " + Describe(Place));
	}
}

TEST(TileMaxNative, NothingIsLeftToTheShader)
{
	const uint64_t Before = GetNativeFallbacks();
	for (const auto& [Width, Height] : {std::pair(641, 359), {1, 1}, {17, 33}})
	{
		const FPlace Place = {
			FImage::Noise(Width, Height), {0, 0, Width, Height}, FIntPoint(Width, Height), PF_FloatRGBA};
		BlurMotion(Place, 1);
		BlurDepth(Place, 1);
	}
	EXPECT_EQ(Before, GetNativeFallbacks());
}
