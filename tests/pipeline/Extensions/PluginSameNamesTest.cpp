// A plugin whose global classes and functions bear the names of the articles' and of drydock's own (tests/plugins/
// SameNames) gets its own, and drydock's effect of that name still works beside it.
#include <gtest/gtest.h>

#include "Picture/ImageFile.h"
#include "Run/Run.h"

#include <cmath>

using namespace Drydock;

namespace
{

const std::string OwnBlur = R"(, "extensions": [{"type": "DualKawaseBlur", "pass": "MotionBlur", "PassNum": 3}])";
const std::string SameNames =
	R"(, "plugins": [")" DRYDOCK_TEST_BINARY_DIR R"(/lib/libSameNames.so"], "cvars": {"r.SameNames": 1})";

FImage RunWith(const std::string& More)
{
	FRunOptions Options;
	Options.ConfigFile = DRYDOCK_TEST_SOURCE_DIR "/configs/test.json";
	Options.ConfigText =
		R"({"scene": {"file": "scenes/toon_character_641x359.exr"}, "showFlags": {"Bloom": false})" + More + "}";
	return RunConfig(Options).SceneLinear.ToImage();
}

/** Half of Picture plus one, within what two half floats of up to 32 resolve. */
void ExpectHalfPlusOne(const FImage& Picture, const FImage& Result)
{
	ASSERT_EQ(Picture.Width, Result.Width);
	ASSERT_EQ(Picture.Height, Result.Height);
	for (int Y = 0; Y < Picture.Height; ++Y)
	{
		for (int X = 0; X < Picture.Width; ++X)
		{
			const double Expected = 0.5 * static_cast<double>(Picture.Get(X, Y, 1)) + 1.0;
			ASSERT_NEAR(Expected, Result.Get(X, Y, 1), Expected / 256) << "pixel (" << X << ", " << Y << ")";
		}
	}
}

} // namespace

TEST(PluginSameNames, APluginGetsItsOwnClassesAndFunctions)
{
	ExpectHalfPlusOne(RunWith(""), RunWith(SameNames));
}

TEST(PluginSameNames, DrydocksEffectOfTheNameWorksInTheSameFrame)
{
	ExpectHalfPlusOne(RunWith(OwnBlur), RunWith(OwnBlur + SameNames));
}

TEST(PluginSameNames, DrydocksEffectOfTheNameIsTheSameAfterwards)
{
	const FImage Before = RunWith(OwnBlur);
	RunWith(SameNames);
	EXPECT_EQ(Before.Values, RunWith(OwnBlur).Values);
	EXPECT_NE(Before.Values, RunWith("").Values);
}
