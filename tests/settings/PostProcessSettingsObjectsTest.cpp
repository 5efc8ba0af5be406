// Textures and curves by path, and weighted blendables.
#include <gtest/gtest.h>

#include "Engine/Scene.h"
#include "Engine/Texture2D.h"
#include "PostProcessSettingsReflection.h"
#include "SettingObjects.h"

using namespace Drydock;

TEST(SettingObjects, OnePathIsOneObject)
{
	EXPECT_EQ(FindOrAddTexture("/Game/A.A"), FindOrAddTexture("/Game/A.A"));
	EXPECT_NE(FindOrAddTexture("/Game/A.A"), FindOrAddTexture("/Game/B.B"));
}

TEST(SettingObjects, NoneIsNull)
{
	EXPECT_EQ(nullptr, FindOrAddTexture("None"));
	EXPECT_EQ(nullptr, FindOrAddCurve(""));
	EXPECT_EQ("None", GetObjectPath(nullptr));
}

TEST(SettingObjects, PathAndNameComeBack)
{
	EXPECT_EQ("/Game/Maps/Dirt.Dirt", GetObjectPath(FindOrAddTexture("/Game/Maps/Dirt.Dirt")));
	EXPECT_EQ(FString("Dirt"), FindOrAddTexture("/Game/Maps/Dirt.Dirt")->GetName());
}

TEST(SettingObjects, ObjectsFromElsewhereGoByName)
{
	UTexture2D Texture;
	Texture.SetFName(FName("Mine"));
	EXPECT_EQ("Mine", GetObjectPath(&Texture));
}

TEST(SettingObjects, ClassIsStripped)
{
	EXPECT_EQ("/Game/A.A", StripObjectClass("/Game/A.A"));
	EXPECT_EQ("/Game/A.A", StripObjectClass("Texture2D'/Game/A.A'"));
	EXPECT_EQ("/Game/A.A", StripObjectClass("/Script/Engine.Texture2D'\"/Game/A.A\"'"));
}

TEST(SettingObjects, SpaceAndQuotesAroundAPathAreStripped)
{
	for (const char* const Reference : {" /Game/A.A", "/Game/A.A\r\r", "\"/Game/A.A\"", "Texture2D' /Game/A.A\t'\n",
			 "A'B'/Game/A.A''", "A'\"\"/Game/A.A\"\"'"})
	{
		EXPECT_EQ("/Game/A.A", StripObjectClass(Reference)) << Reference;
	}
	EXPECT_EQ("", StripObjectClass(" \r"));
	EXPECT_EQ("", StripObjectClass("Texture2D''"));
	EXPECT_EQ("Texture2D'/Game/A.A", StripObjectClass("Texture2D'/Game/A.A")) << "an open quote is part of it";
	EXPECT_EQ("'", StripObjectClass("'"));
}

TEST(SettingObjects, EngineCodeAssignsAndCompares)
{
	FPostProcessSettings Settings;
	EXPECT_TRUE(Settings.BloomDirtMask == nullptr);
	UTexture* Texture = FindOrAddTexture("/Game/A.A");
	Settings.BloomDirtMask = Texture;
	EXPECT_TRUE(Settings.BloomDirtMask != nullptr);
	EXPECT_TRUE(Settings.BloomDirtMask == Texture);
	Settings.BloomDirtMask = nullptr;
	EXPECT_FALSE(Settings.BloomDirtMask);
}

TEST(SettingObjects, ObjectOfAnotherClassIsNoValue)
{
	FPostProcessSettings Settings;
	FSettingValue Value{ESettingType::Object};
	Value.Object = FindOrAddCurve("/Game/Curve.Curve");
	FindSettingField("BloomDirtMask")->Set(Settings, Value);
	EXPECT_TRUE(Settings.BloomDirtMask == nullptr);
}

TEST(SettingObjects, LensFlareTintsAreAnArray)
{
	FPostProcessSettings Settings;
	EXPECT_EQ(8u, std::size(Settings.LensFlareTints));
	EXPECT_EQ(FLinearColor(0.9f, 0.7f, 0.7f, 0.15f), Settings.LensFlareTints[7]);
}

TEST(WeightedBlendables, AddingTwiceKeepsOneWithTheNewWeight)
{
	FPostProcessSettings Settings;
	UObject* Object = FindOrAddObject("/Game/Material.Material");
	Settings.AddBlendable(Object, 0.25f);
	Settings.AddBlendable(Object, 0.5f);
	ASSERT_EQ(1, Settings.WeightedBlendables.Array.Num());
	EXPECT_EQ(FWeightedBlendable(0.5f, Object), Settings.WeightedBlendables.Array[0]);
}

TEST(WeightedBlendables, RemovedOnesAreGone)
{
	FPostProcessSettings Settings;
	UObject* Object = FindOrAddObject("/Game/Material.Material");
	Settings.AddBlendable(nullptr, 1.0f);
	Settings.AddBlendable(Object, 1.0f);
	Settings.RemoveBlendable(Object);
	EXPECT_EQ(0, Settings.WeightedBlendables.Array.Num());
}

TEST(WeightedBlendables, BaseValuesHaveNone)
{
	FPostProcessSettings Settings;
	Settings.AddBlendable(FindOrAddObject("/Game/Material.Material"), 1.0f);
	Settings.SetBaseValues();
	EXPECT_EQ(0, Settings.WeightedBlendables.Array.Num());
}
