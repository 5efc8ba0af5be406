// FPostProcessUtils: the rule of the engine's documentation, which is not that of a world's volumes.
#include <gtest/gtest.h>

#include "Engine/PostProcessUtils.h"
#include "Engine/Scene.h"
#include "PostProcessSettingsReflection.h"
#include "SettingObjects.h"
#include "SettingSamples.h"

#include <cmath>
#include <limits>

using namespace Drydock;

namespace
{

FPostProcessSettings VignetteOf(float Intensity)
{
	FPostProcessSettings Settings;
	Settings.bOverride_VignetteIntensity = true;
	Settings.VignetteIntensity = Intensity;
	return Settings;
}

FPostProcessSettings MethodOf(EBloomMethod Method)
{
	FPostProcessSettings Settings;
	Settings.bOverride_BloomMethod = true;
	Settings.BloomMethod = Method;
	return Settings;
}

class PostProcessUtilsField : public testing::TestWithParam<const FSettingField*>
{
};

} // namespace

TEST(PostProcessUtils, BothOverriddenBlendsLinearly)
{
	FPostProcessSettings Settings = VignetteOf(0.0f);
	EXPECT_TRUE(FPostProcessUtils::BlendPostProcessSettings(Settings, VignetteOf(1.0f), 0.25f));
	EXPECT_EQ(0.25f, Settings.VignetteIntensity);
}

TEST(PostProcessUtils, FromADefaultToAValue)
{
	// Default 0.4, value 0.8: halfway is 0.6.
	FPostProcessSettings Settings;
	FPostProcessUtils::BlendPostProcessSettings(Settings, VignetteOf(0.8f), 0.5f);
	EXPECT_FLOAT_EQ(0.6f, Settings.VignetteIntensity);
	EXPECT_TRUE(Settings.bOverride_VignetteIntensity);
}

TEST(PostProcessUtils, FromAValueBackToTheDefault)
{
	FPostProcessSettings Settings = VignetteOf(0.8f);
	FPostProcessUtils::BlendPostProcessSettings(Settings, FPostProcessSettings(), 1.0f);
	EXPECT_EQ(0.4f, Settings.VignetteIntensity);
	EXPECT_TRUE(Settings.bOverride_VignetteIntensity);
}

TEST(PostProcessUtils, FieldsThatNeitherOverridesStay)
{
	FPostProcessSettings Settings = VignetteOf(0.0f);
	FPostProcessSettings Other = VignetteOf(1.0f);
	Other.BloomIntensity = 5.0f;
	FPostProcessUtils::BlendPostProcessSettings(Settings, Other, 1.0f);
	EXPECT_EQ(0.675f, Settings.BloomIntensity);
	EXPECT_FALSE(Settings.bOverride_BloomIntensity);
}

TEST(PostProcessUtils, EnumsFlipAboveOneHalf)
{
	FPostProcessSettings Settings = MethodOf(BM_SOG);
	FPostProcessUtils::BlendPostProcessSettings(Settings, MethodOf(BM_FFT), 0.5f);
	EXPECT_EQ(BM_SOG, Settings.BloomMethod);
	FPostProcessUtils::BlendPostProcessSettings(Settings, MethodOf(BM_FFT), 0.501f);
	EXPECT_EQ(BM_FFT, Settings.BloomMethod);
}

TEST(PostProcessUtils, TexturesFlipAlsoToNone)
{
	FPostProcessSettings Settings;
	Settings.bOverride_AmbientCubemap = true;
	Settings.AmbientCubemap = FindOrAddTextureCube("/Game/Sky.Sky");
	FPostProcessUtils::BlendPostProcessSettings(Settings, FPostProcessSettings(), 0.5f);
	EXPECT_TRUE(Settings.AmbientCubemap != nullptr);
	FPostProcessUtils::BlendPostProcessSettings(Settings, FPostProcessSettings(), 0.75f);
	EXPECT_TRUE(Settings.AmbientCubemap == nullptr);
}

TEST(PostProcessUtils, FocalDistanceThatIsOffFlips)
{
	FPostProcessSettings Settings;
	FPostProcessSettings Other;
	Other.bOverride_DepthOfFieldFocalDistance = true;
	Other.DepthOfFieldFocalDistance = 100.0f;
	FPostProcessUtils::BlendPostProcessSettings(Settings, Other, 0.25f);
	EXPECT_EQ(0.0f, Settings.DepthOfFieldFocalDistance);
	FPostProcessUtils::BlendPostProcessSettings(Settings, Other, 0.75f);
	EXPECT_EQ(100.0f, Settings.DepthOfFieldFocalDistance);
}

TEST(PostProcessUtils, NothingOverriddenIsFalse)
{
	FPostProcessSettings Settings;
	EXPECT_FALSE(FPostProcessUtils::BlendPostProcessSettings(Settings, FPostProcessSettings(), 1.0f));
	EXPECT_FALSE(FPostProcessUtils::OverridePostProcessSettings(Settings, FPostProcessSettings()));
}

TEST(PostProcessUtils, FactorsAreClampedAndNaNDoesNothing)
{
	FPostProcessSettings Settings = VignetteOf(0.0f);
	EXPECT_FALSE(FPostProcessUtils::BlendPostProcessSettings(Settings, VignetteOf(1.0f), std::nanf("")));
	FPostProcessUtils::BlendPostProcessSettings(Settings, VignetteOf(1.0f), -2.0f);
	EXPECT_EQ(0.0f, Settings.VignetteIntensity);
	FPostProcessUtils::BlendPostProcessSettings(Settings, VignetteOf(1.0f), 2.0f);
	EXPECT_EQ(1.0f, Settings.VignetteIntensity);
}

TEST(PostProcessUtils, NotFiniteValuesStayOut)
{
	FPostProcessSettings Settings;
	EXPECT_FALSE(FPostProcessUtils::BlendPostProcessSettings(Settings, VignetteOf(std::nanf("")), 1.0f));
	EXPECT_FALSE(FPostProcessUtils::OverridePostProcessSettings(Settings, VignetteOf(HUGE_VALF)));
	EXPECT_EQ(0.4f, Settings.VignetteIntensity);
	EXPECT_FALSE(Settings.bOverride_VignetteIntensity);
}

TEST(PostProcessUtils, BlendablesStay)
{
	FPostProcessSettings Settings = VignetteOf(0.0f);
	FPostProcessSettings Other = VignetteOf(1.0f);
	Other.AddBlendable(FindOrAddObject("/Game/Material.Material"), 1.0f);
	FPostProcessUtils::BlendPostProcessSettings(Settings, Other, 1.0f);
	EXPECT_EQ(0, Settings.WeightedBlendables.Array.Num());
}

INSTANTIATE_TEST_SUITE_P(Each, PostProcessUtilsField, AllSettingFields(), FNameOfSetting());

TEST_P(PostProcessUtilsField, OverrideCopiesItOnlyIfOverridden)
{
	const FSettingField& Field = *GetParam();
	FPostProcessSettings Other;
	Field.Set(Other, MakeOtherValue(Field));
	FPostProcessSettings Settings;
	EXPECT_FALSE(FPostProcessUtils::OverridePostProcessSettings(Settings, Other));
	EXPECT_EQ(Field.Default, Field.Get(Settings));
	Field.SetOverridden(Other, true);
	EXPECT_TRUE(FPostProcessUtils::OverridePostProcessSettings(Settings, Other));
	EXPECT_EQ(MakeOtherValue(Field), Field.Get(Settings));
	EXPECT_TRUE(Field.IsOverridden(Settings));
}

TEST_P(PostProcessUtilsField, FullBlendAssignsExactlyAndZeroKeeps)
{
	const FSettingField& Field = *GetParam();
	FPostProcessSettings Other;
	Field.Set(Other, MakeOtherValue(Field));
	Field.SetOverridden(Other, true);
	FPostProcessSettings Settings;
	FPostProcessUtils::BlendPostProcessSettings(Settings, Other, 0.0f);
	EXPECT_EQ(Field.Default, Field.Get(Settings));
	FPostProcessUtils::BlendPostProcessSettings(Settings, Other, 1.0f);
	EXPECT_EQ(MakeOtherValue(Field), Field.Get(Settings));
}
