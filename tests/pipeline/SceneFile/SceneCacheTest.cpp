// Runs in a row decode a scene once, and see when it has changed.
#include <gtest/gtest.h>

#include "Picture/ExrWriter.h"
#include "Run/Run.h"
#include "SameBits.h"
#include "SceneFile/SceneCache.h"
#include "SequenceTestUtils.h"

using namespace Drydock;
using namespace SequenceTest;

namespace
{

class SceneCache : public testing::Test
{
protected:
	SceneCache() { WriteScene(0.25f); }

	void WriteScene(float Value) const
	{
		const std::vector<float> Plane(16 * 8, Value);
		WriteExrPlanes(Path, 16, 8, {Plane, Plane, Plane}, {"R", "G", "B"}, {});
	}

	FPicture Run(const std::shared_ptr<FSceneCache>& Cache) const
	{
		FRunOptions Options;
		Options.ConfigFile = (Temporary.Path / "test.json").string();
		Options.ConfigText = R"({"scene": {"file": "scene.exr"}, "camera": {"Settings": {"BloomIntensity": 0}}})";
		Options.SceneCache = Cache;
		return RunConfig(Options).SceneLinear;
	}

	const FTemporaryFolder Temporary{"drydock_scene_cache"};
	const std::string Path = (Temporary.Path / "scene.exr").string();
};

} // namespace

TEST_F(SceneCache, RunsAreTheSameWithAndWithoutOne)
{
	const auto Cache = std::make_shared<FSceneCache>();
	const FPicture Alone = Run(nullptr);
	EXPECT_TRUE(SameBits::AreSameBits(Alone, Run(Cache)));
	EXPECT_TRUE(SameBits::AreSameBits(Alone, Run(Cache)));
}

TEST_F(SceneCache, TheSecondRunDecodesNothing)
{
	const auto Cache = std::make_shared<FSceneCache>();
	Run(Cache);
	const FSceneCache::FPlane Blue = Cache->Find(2);
	ASSERT_NE(nullptr, Blue);
	Run(Cache);
	EXPECT_EQ(Blue, Cache->Find(2));
	EXPECT_EQ(nullptr, Cache->Find(3));
}

TEST_F(SceneCache, AFileThatChangedIsReadAgain)
{
	const auto Cache = std::make_shared<FSceneCache>();
	EXPECT_EQ(0.25, Run(Cache).Get(0, 0, 0));
	WriteScene(0.5f);
	Files::last_write_time(Path, Files::last_write_time(Path) + std::chrono::seconds(1));
	EXPECT_EQ(0.5, Run(Cache).Get(0, 0, 0));
}
