// Runs in a row decode a scene once, and see when it has changed.
#include <gtest/gtest.h>

#include "Picture/ExrWriter.h"
#include "PostProcess/PostProcessInputs.h"
#include "RenderGraphUtils.h"
#include "Run/Run.h"
#include "SameBits.h"
#include "SceneFile/SceneCache.h"
#include "SceneFile/SceneTexturePacking.h"
#include "SceneViewExtension.h"
#include "SequenceTestUtils.h"

#include <limits>

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

	/** More: of the scene's object. */
	FPicture Run(const std::shared_ptr<FSceneCache>& Cache, const std::string& More = "",
		const std::vector<std::string>& Variables = {}) const
	{
		FRunOptions Options;
		Options.ConfigFile = (Temporary.Path / "test.json").string();
		Options.ConfigText =
			R"({"scene": {"file": "scene.exr")" + More + R"(}, "camera": {"Settings": {"BloomIntensity": 0}}})";
		Options.SceneCache = Cache;
		Options.Variables = Variables;
		return RunConfig(Options).SceneLinear;
	}

	/** Scene colour as the cache holds it; null: not at all. */
	static const FRHITexture* FindColor(const FSceneCache& Cache)
	{
		const FKeptSceneTexture* const Kept = Cache.FindTexture(GetScenePackings().front().Name);
		return Kept != nullptr ? Kept->Texture.GetReference() : nullptr;
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

TEST_F(SceneCache, TheSecondRunFillsNoTexture)
{
	const auto Cache = std::make_shared<FSceneCache>();
	Run(Cache);
	const TRefCountPtr<const FRHITexture> Color = FindColor(*Cache);
	ASSERT_TRUE(Color != nullptr);
	Run(Cache, "", {"r.TonemapperGamma=2.2"});
	EXPECT_EQ(Color.GetReference(), FindColor(*Cache));
	Run(Cache, "", {"r.Drydock.SceneColorClamp=0.125"});
	EXPECT_NE(Color.GetReference(), FindColor(*Cache));
}

// Whatever decides a texel of a scene texture is another texture of the cache.
TEST_F(SceneCache, OtherTexelsAreFilledAnew)
{
	const auto Cache = std::make_shared<FSceneCache>();
	const std::vector<float> Bad(16 * 8, std::numeric_limits<float>::infinity());
	WriteExrPlanes(
		Path, 16, 8, {Bad, std::vector<float>(16 * 8, 0.25f), std::vector<float>(16 * 8, 0.75f)}, {"R", "G", "B"}, {});
	const std::pair<std::string, std::vector<std::string>> Others[] = {{"", {}}, {R"(, "screenPercentage": 50)", {}},
		{R"(, "padding": 3)", {}}, {R"(, "channels": {"R": "G"})", {}}, {"", {"r.Drydock.SceneColorClamp=0.5"}},
		{"", {"r.Drydock.NonFinite=1"}}, {"", {"r.Drydock.Storage=1"}},
		{"", {"r.EyeAdaptation.PreExposureOverride=4"}}};
	for (int Round = 0; Round < 2; ++Round)
	{
		for (const auto& [More, Variables] : Others)
		{
			EXPECT_TRUE(SameBits::AreSameBits(Run(nullptr, More, Variables), Run(Cache, More, Variables)))
				<< More << (Variables.empty() ? "" : Variables[0]);
		}
	}
}

TEST_F(SceneCache, ATextureThatAPassWritesIsOfThatFrameAlone)
{
	class FBlackens final : public FSceneViewExtensionBase
	{
	public:
		using FSceneViewExtensionBase::FSceneViewExtensionBase;
		void PrePostProcessPass_RenderThread(
			FRDGBuilder& GraphBuilder, const FSceneView&, const FPostProcessingInputs& Inputs) override
		{
			AddClearRenderTargetPass(
				GraphBuilder, (*Inputs.SceneTextures)->SceneColorTexture, FLinearColor(0.0f, 0.0f, 0.0f, 1.0f));
		}
	};
	const auto Cache = std::make_shared<FSceneCache>();
	EXPECT_EQ(0.25, Run(Cache).Get(3, 3, 0));
	{
		const auto Extension = FSceneViewExtensions::NewExtension<FBlackens>();
		EXPECT_EQ(0.0, Run(Cache).Get(3, 3, 0));
	}
	EXPECT_EQ(nullptr, FindColor(*Cache));
	EXPECT_EQ(0.25, Run(Cache).Get(3, 3, 0));
}

TEST_F(SceneCache, AFileThatChangedIsReadAgain)
{
	const auto Cache = std::make_shared<FSceneCache>();
	EXPECT_EQ(0.25, Run(Cache).Get(0, 0, 0));
	WriteScene(0.5f);
	Files::last_write_time(Path, Files::last_write_time(Path) + std::chrono::seconds(1));
	EXPECT_EQ(0.5, Run(Cache).Get(0, 0, 0));
}
