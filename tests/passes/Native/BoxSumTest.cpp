// The native box of CharaGlow against its shader and a plain sum in double: within the stated bound, with the same bits
// for every lane width and thread count, around texels that are no numbers, and that it does the work.
#include "NativeTestUtils.h"

#include "NativeFallback.h"
#include "SceneTextureParameters.h"
#include "SceneTextures.h"
#include "Toon/CharaGlow.h"

using namespace Drydock;
using namespace PassTest;

namespace
{

FImage Widen(const FPlace& Place, float Area, EArithmetic Arithmetic)
{
	FPassRun Run(Place.Image, Place.Rect, Place.Extent, Arithmetic, PF_FloatRGBA);
	FSceneTextures SceneTextures;
	SceneTextures.GBufferD =
		Run.AddInput(Place.Image, Place.Rect, Place.Extent, Place.Format, TEXT("GBufferD")).Texture;
	FCharaGlowInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.Area = Area;
	Inputs.SceneTextures = CreateSceneTextureUniformBuffer(Run.GraphBuilder, &SceneTextures);
	return Run.Execute(AddCharaGlowPasses(Run.GraphBuilder, Run.View, Inputs));
}

FPlace DrawMask(std::mt19937& Random)
{
	FPlace Place = DrawPlace(Random);
	const EPixelFormat Formats[] = {PF_A32B32G32R32F, PF_FloatRGBA, PF_B8G8R8A8, PF_FloatR11G11B10};
	Place.Format = Formats[std::uniform_int_distribution<size_t>(0, std::size(Formats) - 1)(Random)];
	return Place;
}

} // namespace

TEST(BoxSum, IsWithinTheStatedBoundOfTheShader)
{
	std::mt19937 Random(11);
	for (int Case = 0; Case < 30; ++Case)
	{
		FPlace Place = DrawMask(Random);
		Place.Image = Draw(Random, Place.Rect.Width(), Place.Rect.Height(), false);
		// Whole areas have no fraction at the ends.
		const float Drawn = std::uniform_real_distribution<float>(0.5f, 40.0f)(Random);
		const float Area = Case % 2 == 0 ? Drawn : std::ceil(Drawn);
		const FImage Native = Widen(Place, Area, EArithmetic::Float32);
		const FScopedConsoleVariable Switch(TEXT("r.Drydock.NativeKernels"), 0);
		const FImage Shader = Widen(Place, Area, EArithmetic::Float32);
		// Values reach 4; the largest partial sum is about the whole one, the mean that over the weights. Two
		// directions.
		const double Bound = 2 * (2 * std::floor(Area) + 8) * 4 * std::exp2(-24.0);
		for (size_t i = 0; i < Native.Texels.size(); ++i)
		{
			ASSERT_NEAR(Shader.Texels[i][0], Native.Texels[i][0], Bound)
				<< "case " << Case << ", " << Describe(Place) << ", area " << Area << ", texel " << i;
		}
	}
}

TEST(BoxSum, BitsAreThoseOfAnyLanesAndThreads)
{
	std::mt19937 Random(12);
	for (int Case = 0; Case < 16; ++Case)
	{
		// Large enough that one thread's tiles are taller and wider than those of many.
		const int Width = std::uniform_int_distribution<int>(1, 700)(Random);
		const int Height = std::uniform_int_distribution<int>(40, 200)(Random);
		FPlace Place = DrawMask(Random);
		Place.Image = Draw(Random, Width, Height, false);
		Place.Rect = {5, 3, Width + 5, Height + 3};
		Place.Extent = FIntPoint(Width + 9, Height + 4);
		for (const double Hazard : {NaN, Infinity})
		{
			const size_t At = std::uniform_int_distribution<size_t>(0, Place.Image.Texels.size() - 1)(Random);
			Place.Image.Texels[At][2] = Case % 2 == 0 ? Hazard : 1.0;
		}
		const float Drawn = std::uniform_real_distribution<float>(0.5f, 30.0f)(Random);
		const float Area = Case % 2 == 0 ? Drawn : std::ceil(Drawn);
		const auto Run = [&](int Lanes, int Threads)
		{
			const FScopedConsoleVariable Width_(TEXT("r.Drydock.LaneWidth"), static_cast<float>(Lanes));
			const FScopedConsoleVariable Threads_(TEXT("r.Drydock.Threads"), static_cast<float>(Threads));
			return Widen(Place, Area, Case % 3 == 0 ? EArithmetic::Float32 : EArithmetic::Native);
		};
		const FImage First = Run(0, 1);
		for (const auto& [Lanes, Threads] : {std::pair(8, 2), {4, 7}, {0, 7}})
		{
			EXPECT_EQ("", Compare(First, Run(Lanes, Threads)))
				<< "case " << Case << ", " << Describe(Place) << ", area " << Area << ", " << Lanes << " lanes, "
				<< Threads << " threads";
		}
	}
}

TEST(BoxSum, OnlyRowsBesideWhatIsNoNumberAreLeftToTheShader)
{
	FPlace Place = {FImage::Noise(90, 70), {0, 0, 90, 70}, FIntPoint(90, 70), PF_FloatRGBA};
	uint64_t Before = GetNativeFallbacks();
	Widen(Place, 4.0f, EArithmetic::Native);
	EXPECT_EQ(Before, GetNativeFallbacks());

	Place.Image.Texels[size_t(69 * 90 + 3)][2] = NaN;
	Before = GetNativeFallbacks();
	const FImage Result = Widen(Place, 4.0f, EArithmetic::Native);
	EXPECT_EQ(Before + 2, GetNativeFallbacks()); // the last rows of either direction
	EXPECT_TRUE(std::isnan(Result.At(3, 69)[0]));
	EXPECT_FALSE(std::isnan(Result.At(3, 60)[0]));
	EXPECT_FALSE(std::isnan(Result.At(20, 69)[0]));
}
