// The native kernel of the separable Gaussian against the shader that it stands for: the same stored bits for drawn
// pictures, sizes, rects, formats, widths, lanes, and pictures full of hazards; and that it does the work.
#include "NativeTestUtils.h"

#include "Blur/MatchedGaussianBlur.h"
#include "NativeFallback.h"

using namespace Drydock;
using namespace PassTest;

namespace
{

FImage Blur(const FPlace& Place, double StandardDeviation, bool bSeparable = true)
{
	FPassRun Run(Place.Image, Place.Rect, Place.Extent, EArithmetic::Native, Place.Format);
	FMatchedGaussianBlurInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.StandardDeviation = StandardDeviation;
	Inputs.bSeparable = bSeparable;
	return Run.Execute(AddMatchedGaussianBlurPasses(Run.GraphBuilder, Run.View, Inputs));
}

} // namespace

TEST(TexelSum, GaussianHasTheShadersBits)
{
	std::mt19937 Random(19);
	for (int Case = 0; Case < 60; ++Case)
	{
		const FPlace Place = DrawPlace(Random);
		const double Sigma = std::exp(std::uniform_real_distribution<double>(-0.7, 3.5)(Random));
		ExpectSameBits([&] { return Blur(Place, Sigma); },
			"case " + std::to_string(Case) + ", " + Describe(Place) + ", sigma " + std::to_string(Sigma));
	}
}

TEST(TexelSum, GaussiansAreNotLeftToTheShader)
{
	const uint64_t Before = GetNativeFallbacks();
	for (const EPixelFormat Format : {PF_A32B32G32R32F, PF_FloatRGBA, PF_FloatR11G11B10, PF_B8G8R8A8, PF_R16F})
	{
		const FPlace Place = {FImage::Noise(53, 47), {3, 2, 56, 49}, FIntPoint(60, 60), Format};
		Blur(Place, 3.0);
		Blur(Place, 40.0);
	}
	EXPECT_EQ(Before, GetNativeFallbacks());
}

TEST(TexelSum, SquaresOfTexelsAreLeftToTheShader)
{
	const FPlace Place = {FImage::Noise(20, 10), {0, 0, 20, 10}, FIntPoint(20, 10), PF_FloatRGBA};
	const uint64_t Before = GetNativeFallbacks();
	ExpectSameBits([&] { return Blur(Place, 1.5, false); }, "a square of texels");
	EXPECT_LT(Before, GetNativeFallbacks());
}
