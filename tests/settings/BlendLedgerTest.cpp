// The ledger: the story of every setting's value, in order.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "BlendTesting.h"
#include "HAL/ConsoleVariableTools.h"
#include "SettingObjects.h"

#include <limits>

using namespace Drydock;

namespace
{

using FEntries = std::vector<FBlendLedgerEntry>;

FEntries StoryOf(const char* Setting, const FBlendInputs& Scene, const FVector& Location = FVector(0, 0, 0))
{
	FBlendLedger Ledger;
	BlendAt(Scene, Location, &Ledger);
	return Ledger.GetEntries(Setting);
}

FPostProcessSettings Scale(double Value)
{
	return Give({{"BloomSizeScale", Value}});
}

/** "source: before -> after" or "source: why it was skipped", a line each. */
std::string Tell(const FEntries& Entries)
{
	const FSettingField& Field = *FindSettingField("BloomSizeScale");
	std::string Text;
	for (const FBlendLedgerEntry& Entry : Entries)
	{
		const std::string Values = SettingToText(Field, Entry.Before) + " -> " + SettingToText(Field, Entry.After);
		Text += Entry.Source + ": " + (Entry.Skipped.empty() ? Values : Entry.Skipped) + "\n";
	}
	return Text;
}

APostProcessVolume Named(const char* Name, APostProcessVolume Volume)
{
	Volume.Name = Name;
	return Volume;
}

const FVolumeShape Ball = FVolumeShape::MakeSphere(FVector(0, 0, 0), 50);

} // namespace

TEST(BlendLedger, BeginsWithTheDefault)
{
	const FEntries Story = StoryOf("BloomSizeScale", Inputs({}));
	ASSERT_EQ(1u, Story.size());
	EXPECT_EQ(EBlendSource::Default, Story[0].Kind);
	EXPECT_EQ(4.0, Story[0].After.Components[0]);
}

TEST(BlendLedger, TellsOfVolumesInTheOrderOfPriority)
{
	EXPECT_EQ("default: 4 -> 4\nRoom: 4 -> 6\nStage: 6 -> 11\n",
		Tell(StoryOf("BloomSizeScale",
			Inputs({Named("Stage", Unbound(1, 0.5f, Scale(16))), Named("Room", Unbound(0, 0.5f, Scale(8)))}))));
}

TEST(BlendLedger, KnowsDistanceWeightAndRule)
{
	const FEntries Story = StoryOf("BloomSizeScale", Inputs({Bounded(0, Ball, 100, Scale(8))}), FVector(0, 0, 75));
	ASSERT_EQ(2u, Story.size());
	EXPECT_EQ(25.0, Story[1].Distance);
	EXPECT_EQ(0.75f, Story[1].Weight);
	EXPECT_EQ("Lerp", Story[1].Rule);
}

TEST(BlendLedger, UnboundVolumesHaveNoDistance)
{
	EXPECT_FALSE(StoryOf("BloomSizeScale", Inputs({Unbound(0, 1, Scale(8))}))[1].Distance.has_value());
}

TEST(BlendLedger, TellsHowFarAVolumeIsThatDoesNotReach)
{
	EXPECT_EQ("default: 4 -> 4\nvolume of priority 0: out of radius: 950.0 cm away, BlendRadius 100.0\n",
		Tell(StoryOf("BloomSizeScale", Inputs({Bounded(0, Ball, 100, Scale(8))}), FVector(1000, 0, 0))));
}

TEST(BlendLedger, TellsOfADisabledVolumeWithItsDistance)
{
	APostProcessVolume Volume = Bounded(0, Ball, 100, Scale(8));
	Volume.bEnabled = false;
	const FEntries Story = StoryOf("BloomSizeScale", Inputs({Volume}), FVector(60, 0, 0));
	EXPECT_EQ("disabled", Story.at(1).Skipped);
	EXPECT_EQ(10.0, Story[1].Distance);
	EXPECT_EQ(0.0f, Story[1].Weight);
}

TEST(BlendLedger, TellsOfAVolumeOfNoWeight)
{
	EXPECT_EQ("BlendWeight is 0", StoryOf("BloomSizeScale", Inputs({Unbound(0, 0, Scale(8))})).at(1).Skipped);
}

TEST(BlendLedger, TellsOfVolumesThatLeaveTheSettingAlone)
{
	FPostProcessSettings Inert = Scale(8);
	Inert.bOverride_BloomSizeScale = false;
	const FEntries Story = StoryOf("BloomSizeScale", Inputs({Unbound(0, 1, Inert), Unbound(1, 1, Scale(2))}));
	EXPECT_EQ("override off", Story.at(1).Skipped);
	EXPECT_EQ(2.0, Story.at(2).After.Components[0]);
}

TEST(BlendLedger, SettingsThatNothingNamesHaveAShortStory)
{
	EXPECT_EQ(1u, StoryOf("BloomIntensity", Inputs({Unbound(0, 1, Scale(2))})).size());
}

TEST(BlendLedger, TellsOfAValueThatIsNotFinite)
{
	const FEntries Story =
		StoryOf("BloomSizeScale", Inputs({Unbound(0, 1, Scale(std::numeric_limits<double>::infinity()))}));
	EXPECT_EQ("the value is not finite", Story.at(1).Skipped);
	EXPECT_EQ(4.0, Story[1].After.Components[0]);
}

TEST(BlendLedger, TellsOfANullThatReplacesNothing)
{
	FPostProcessSettings None;
	None.bOverride_BloomDirtMask = true;
	EXPECT_EQ("zero or null replaces nothing", StoryOf("BloomDirtMask", Inputs({Unbound(0, 1, None)})).at(1).Skipped);
}

TEST(BlendLedger, CameraAndCommandLineFollow)
{
	FBlendInputs Scene = Inputs({Named("Room", Unbound(0, 1, Scale(8)))});
	Scene.Camera = Scale(16);
	Scene.CameraWeight = 0.5f;
	Scene.CommandLine = Scale(1);
	EXPECT_EQ(
		"default: 4 -> 4\nRoom: 4 -> 8\ncamera: 8 -> 12\n--pp: 12 -> 1\n", Tell(StoryOf("BloomSizeScale", Scene)));
}

TEST(BlendLedger, CameraOfNoWeightIsSkipped)
{
	FBlendInputs Scene;
	Scene.Camera = Scale(16);
	Scene.CameraWeight = 0.0f;
	EXPECT_EQ("default: 4 -> 4\ncamera: PostProcessBlendWeight is 0\n", Tell(StoryOf("BloomSizeScale", Scene)));
}

TEST(BlendLedger, DefaultFeatureStandsBeforeTheVolumes)
{
	const FScopedConsoleVariable Off(TEXT("r.DefaultFeature.Bloom"), 0);
	const FEntries Story = StoryOf("BloomIntensity", Inputs({Unbound(0, 1, Give({{"BloomIntensity", 2}}))}));
	ASSERT_EQ(3u, Story.size());
	EXPECT_EQ("r.DefaultFeature.Bloom", Story[1].Source);
	EXPECT_EQ(EBlendSource::Variable, Story[1].Kind);
	EXPECT_EQ(0.0, Story[1].After.Components[0]);
	EXPECT_EQ(0.0, Story[2].Before.Components[0]);
}

TEST(BlendLedger, ShowFlagStandsLast)
{
	FBlendInputs Scene = Inputs({Unbound(0, 1, Give({{"BloomIntensity", 2}}))});
	Scene.ShowFlags.SetBloom(false);
	const FEntries Story = StoryOf("BloomIntensity", Scene);
	EXPECT_EQ("ShowFlag.Bloom", Story.back().Source);
	EXPECT_EQ(EBlendSource::ShowFlag, Story.back().Kind);
	EXPECT_EQ(2.0, Story.back().Before.Components[0]);
	EXPECT_EQ(0.0, Story.back().After.Components[0]);
}

TEST(BlendLedger, ToonStrengthIsSwitchedOffWithBloom)
{
	FBlendInputs Scene = Inputs({Unbound(0, 0.5f, Give({{"BloomToonIntensity", 1}}))});
	const auto Steps = [&]
	{
		std::string Text;
		for (const FBlendLedgerEntry& Entry : StoryOf("BloomToonIntensity", Scene))
		{
			Text += Entry.Source + " " + SettingToText(*FindSettingField("BloomToonIntensity"), Entry.After) + "; ";
		}
		return Text;
	};
	{
		const FScopedConsoleVariable Off(TEXT("r.DefaultFeature.Bloom"), 0);
		EXPECT_NE(std::string::npos, Steps().find("r.DefaultFeature.Bloom 0; ")) << Steps();
		EXPECT_TRUE(Steps().ends_with(" 0.5; ")) << Steps();
	}
	{
		const FScopedConsoleVariable Off(TEXT("r.BloomQuality"), 0);
		EXPECT_TRUE(Steps().ends_with("r.BloomQuality 0; ")) << Steps();
	}
	Scene.ShowFlags.SetBloom(false);
	EXPECT_TRUE(Steps().ends_with("ShowFlag.Bloom 0; ")) << Steps();
}

TEST(BlendLedger, VariablesSayWhatTheyDo)
{
	const FScopedConsoleVariable Offset(TEXT("r.ExposureOffset"), FString("0.5"));
	const FEntries Story = StoryOf("AutoExposureBias", Inputs({}));
	EXPECT_EQ("r.ExposureOffset", Story.back().Source);
	EXPECT_EQ("Add", Story.back().Rule);
	EXPECT_EQ(1.5, Story.back().After.Components[0]);
}

TEST(BlendLedger, LUTsAreTold)
{
	FPostProcessSettings Settings = Give({{"ColorGradingIntensity", 0.5}});
	Settings.bOverride_ColorGradingLUT = true;
	Settings.ColorGradingLUT = FindOrAddTexture("/Game/Warm.Warm");
	const FEntries Story = StoryOf("ColorGradingLUT", Inputs({Unbound(0, 0.5f, Settings)}));
	EXPECT_EQ("None 75 %, /Game/Warm.Warm 25 %", Story.at(1).Detail);
}

TEST(BlendLedger, CubemapsAreTold)
{
	FPostProcessSettings Settings = Give({{"AmbientCubemapIntensity", 2}});
	Settings.bOverride_AmbientCubemap = true;
	Settings.AmbientCubemap = FindOrAddTextureCube("/Game/Sky.Sky");
	const FEntries Story = StoryOf("AmbientCubemap", Inputs({Unbound(0, 0.25f, Settings)}));
	EXPECT_EQ("/Game/Sky.Sky (0.5, 0.5, 0.5)", Story.at(1).Detail);
}

TEST(BlendLedger, ExtensionsStandAfterEverything)
{
	FBlendLedger Ledger;
	FFinalPostProcessSettings Settings = BlendAt(Inputs({}), FVector(0, 0, 0), &Ledger).Settings;
	const FFinalPostProcessSettings Before = Settings;
	Settings.BloomSizeScale = 12.0f;
	const std::vector<FSettingGate> Gates = RecordExtensionEdits(Before, Settings, "MyExtension", &Ledger);
	EXPECT_EQ("default: 4 -> 4\nMyExtension: 4 -> 12\n", Tell(Ledger.GetEntries("BloomSizeScale")));
	ASSERT_EQ(1u, Gates.size());
	EXPECT_EQ("BloomSizeScale", Gates[0].Setting);
	EXPECT_EQ("MyExtension set it", Gates[0].Reason);
}

TEST(BlendLedger, NaNOfAnExtensionIsPutBack)
{
	FBlendLedger Ledger;
	const FFinalPostProcessSettings Before;
	FFinalPostProcessSettings After;
	After.BloomSizeScale = std::numeric_limits<float>::quiet_NaN();
	EXPECT_EQ(1u, RecordExtensionEdits(Before, After, "MyExtension", &Ledger).size());
	EXPECT_EQ(4.0f, After.BloomSizeScale);
	EXPECT_EQ("the value is not finite", Ledger.GetEntries("BloomSizeScale").back().Skipped);
}

TEST(BlendLedger, ExtensionThatEditsNothingLeavesNoTrace)
{
	FBlendLedger Ledger;
	const FFinalPostProcessSettings Before;
	FFinalPostProcessSettings After = Before;
	EXPECT_TRUE(RecordExtensionEdits(Before, After, "MyExtension", &Ledger).empty());
	EXPECT_TRUE(Ledger.GetEntries("BloomSizeScale").empty());
}

TEST(BlendLedger, KindsHaveNames)
{
	EXPECT_STREQ("commandLine", ToString(EBlendSource::CommandLine));
	EXPECT_STREQ("showFlag", ToString(EBlendSource::ShowFlag));
}

TEST(BlendLedger, FieldsAreFoundByExactName)
{
	EXPECT_EQ("BloomSizeScale",
		std::string(GetSettingFields()[static_cast<size_t>(FindSettingIndex("BloomSizeScale"))].Name));
	EXPECT_EQ(-1, FindSettingIndex("bloomsizescale"));
}

RC_GTEST_PROP(BlendLedger, EveryStoryIsAChainFromTheDefaultToTheResult, ())
{
	FBlendInputs Scene;
	const int Num = *rc::gen::inRange(0, 8);
	for (int Index = 0; Index < Num; ++Index)
	{
		FPostProcessSettings Settings = Give({{"BloomSizeScale", *rc::gen::inRange(0, 64)},
			{"SceneColorTint", *rc::gen::inRange(0, 4)}, {"MotionBlurTargetFPS", *rc::gen::inRange(0, 120)}});
		Settings.bOverride_SceneColorTint = *rc::gen::inRange(0, 2) > 0;
		const float Priority = static_cast<float>(*rc::gen::inRange(-3, 4));
		Scene.Volumes.push_back(*rc::gen::inRange(0, 2) > 0
									? Unbound(Priority, *rc::gen::inRange(0, 5) / 4.0f, Settings)
									: Bounded(Priority, Ball, 100, Settings));
		Scene.Volumes.back().bEnabled = *rc::gen::inRange(0, 4) > 0;
	}
	Scene.Camera = Give({{"BloomSizeScale", 2}});
	Scene.CameraWeight = *rc::gen::inRange(0, 5) / 4.0f;
	const FVector Location(*rc::gen::inRange(0, 300), 0, 0);
	FBlendLedger Ledger;
	const FBlendedSettings With = BlendAt(Scene, Location, &Ledger);
	const FBlendedSettings Without = BlendAt(Scene, Location);
	for (size_t Index = 0; Index < GetSettingFields().size(); ++Index)
	{
		const FSettingField& Field = GetSettingFields()[Index];
		FSettingValue Value = Field.Default;
		for (const FBlendLedgerEntry& Entry : Ledger.GetEntries(Index))
		{
			RC_ASSERT(Entry.Before == Value);
			RC_ASSERT(Entry.Skipped.empty() || Entry.After == Entry.Before);
			Value = Entry.After;
		}
		RC_ASSERT(Field.Get(With.Settings) == Value);
		// Asking why does not change the answer.
		RC_ASSERT(Field.Get(Without.Settings) == Value);
		RC_ASSERT(Field.IsOverridden(Without.Settings) == Field.IsOverridden(With.Settings));
	}
	RC_ASSERT(With.Ties.size() == Without.Ties.size());
}
