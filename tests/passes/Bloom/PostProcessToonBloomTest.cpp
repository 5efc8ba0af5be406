// Toon bloom's switches, and its mask drawn over the scene.
#include "ToonBloomRun.h"

using namespace Drydock;
using namespace PassTest;

TEST(ToonBloom, TheMaskCanBeSeenOverTheScene)
{
	FToonRun Run(Grey(4, 4, 0.5), QuadIds(), {0, 0, 4, 4}, FIntPoint(4, 4), {0.25f}, EArithmetic::Float32);
	FToonBloomInputs Inputs;
	Inputs.SceneColor = Run.Run.Input;
	Inputs.SceneTextures = CreateSceneTextureUniformBuffer(Run.Run.GraphBuilder, Run.Run.View);
	const FImage Picture = Run.Run.Execute(AddToonBloomVisualizePass(Run.Run.GraphBuilder, Run.Run.View, Inputs));
	EXPECT_FLOAT_EQ(0.625f, static_cast<float>(Picture.At(0, 0)[0]));
	EXPECT_FLOAT_EQ(0.125f, static_cast<float>(Picture.At(0, 0)[1]));
	EXPECT_FLOAT_EQ(0.125f, static_cast<float>(Picture.At(1, 0)[0]));
}

TEST(ToonBloom, DefaultsAreTheArticles)
{
	EXPECT_EQ(-1, GetToonBloomMode());
	EXPECT_FALSE(IsToonBloomAsPrinted());
	EXPECT_FALSE(IsToonBloomMaskVisualized());
	EXPECT_EQ(0.675f, FPostProcessSettings().BloomToonIntensity);
}
