// Settings that a plugin adds: in the table, in the blend against plain loops in double, in the paste text, and gone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "BlendSettings.h"
#include "PostProcessSetting.h"
#include "PostProcessSettingErrors.h"
#include "PostProcessSettingsReflection.h"
#include "PostProcessSettingsText.h"

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <unordered_map>

using namespace Drydock;
using testing::HasSubstr;

namespace
{

enum class EAddedMode : uint8
{
	First,
	Second,
	Third,
};

/** One of each kind, for as long as a test lasts. */
class AddedSettings : public testing::Test
{
protected:
	const TPostProcessSetting<float> Strength{TEXT("AddedStrength"), 0.25f, 0.0, 8.0, TEXT("Strength.")};
	const TPostProcessSetting<float> Focus{
		TEXT("AddedFocus"), 0.0f, {.Unit = TEXT("cm"), .Blend = ESettingBlend::FocalDistance}};
	const TPostProcessSetting<int32> Steps{TEXT("AddedSteps"), 3};
	const TPostProcessSetting<bool> On{TEXT("bAddedOn"), true};
	const TPostProcessSetting<EAddedMode> Mode{
		TEXT("AddedMode"), EAddedMode::Second, {.EnumNames = {"First", "Second", "Third"}}};
	const TPostProcessSetting<FLinearColor> Color{TEXT("AddedColor"), FLinearColor(1.0f, 0.5f, 0.25f, 1.0f)};
	const TPostProcessSetting<FVector4f> Four{TEXT("AddedFour"), FVector4f(1.0f, 2.0f, 3.0f, 4.0f)};
	const TPostProcessSetting<FVector2D> Two{TEXT("AddedTwo"), FVector2D(0.5, 0.25)};
	const TPostProcessSetting<float> Kept{TEXT("AddedKept"), 7.0f, {.Blend = ESettingBlend::SetIfNonZero}};
};

/** Codes and words of what registrations were refused for. */
std::string TakeProblems()
{
	std::string Text;
	for (const FDiagnostic& Problem : TakeSettingProblems())
	{
		Text += std::to_string(Problem.Code) + " " + Problem.Message + "\n";
	}
	return Text;
}

template<typename T>
std::string Refusal(const TCHAR* Name, const T& Default, const FPostProcessSettingInfo& Info = {})
{
	const size_t NumBefore = GetSettingFields().size();
	{
		const TPostProcessSetting<T> Setting(Name, Default, Info);
		EXPECT_EQ(NumBefore, GetSettingFields().size());
		FPostProcessSettings Settings;
		Setting.Set(Settings, Default);
		EXPECT_FALSE(Setting.IsOverridden(Settings));
		EXPECT_EQ(Default, Setting.Get(Settings)) << "a refused one has its default";
	}
	return TakeProblems();
}

} // namespace

TEST_F(AddedSettings, AreFieldsBehindTheTablesOwn)
{
	const FSettingField* const Field = FindSettingField("AddedStrength");
	ASSERT_NE(nullptr, Field);
	EXPECT_EQ(Field, FindSettingFieldByOverride("bOverride_AddedStrength"));
	EXPECT_EQ(GetNumTableSettings(), static_cast<size_t>(Field - GetSettingFields().data()));
	EXPECT_EQ(static_cast<int32>(GetNumTableSettings()), FindSettingIndex("AddedStrength"));
	EXPECT_EQ(0.25, Field->Default.Components[0]);
	EXPECT_EQ(ESettingBlend::Lerp, Field->Blend);
	EXPECT_EQ(ESettingBlend::Set, FindSettingField("AddedMode")->Blend);
	EXPECT_STREQ("Third", FindSettingField("AddedMode")->EnumNames[2]);
	EXPECT_EQ("", TakeProblems());
}

TEST_F(AddedSettings, ValuesAreCopiedWithTheSettings)
{
	FPostProcessSettings First;
	EXPECT_EQ(0.25f, Strength.Get(First));
	EXPECT_FALSE(Strength.IsOverridden(First));
	Strength.Set(First, 0.1f);
	FPostProcessSettings Second = First;
	Strength.Set(Second, 2.0f);
	Color.Set(Second, FLinearColor(0.0f, 1.0f, 2.0f, 3.0f));
	EXPECT_EQ(0.1f, Strength.Get(First)) << "a copy's change is the copy's";
	EXPECT_EQ(2.0f, Strength.Get(Second));
	EXPECT_EQ(FLinearColor(1.0f, 0.5f, 0.25f, 1.0f), Color.Get(First));
	EXPECT_EQ(FLinearColor(0.0f, 1.0f, 2.0f, 3.0f), Color.Get(Second));
	Second.SetBaseValues();
	EXPECT_EQ(0.25f, Strength.Get(Second));
	EXPECT_FALSE(Strength.IsOverridden(Second));
}

TEST_F(AddedSettings, NothingIsKeptOfWhatIsNotUsed)
{
	FPostProcessSettings Settings;
	for (const FSettingField& Field : GetSettingFields())
	{
		Field.Set(Settings, Field.Default);
		Field.SetOverridden(Settings, false);
	}
	for (const FSettingField& Field : GetSettingFields())
	{
		EXPECT_EQ(nullptr, Settings.AddedSettings.Find(Field.AddedId));
	}
}

// Ten volumes with random weights and overrides at random places, 200 times (seed 17): Lerp is a + (b - a) w, Set the
// last that acts, SetIfNonZero the last that is not 0, FocalDistance Set where either is 0.
TEST_F(AddedSettings, AreBlendedAsPlainLoopsSay)
{
	std::mt19937 Random(17);
	std::uniform_real_distribution<double> Uniform(0.0, 1.0);
	const auto Chance = [&](double Probability)
	{
		return Uniform(Random) < Probability;
	};
	for (int Round = 0; Round < 200; ++Round)
	{
		FBlendInputs Inputs;
		double WantedStrength = 0.25;
		double WantedFocus = 0.0;
		double WantedKept = 7.0;
		int WantedSteps = 3;
		int WantedMode = 1;
		std::array<double, 4> WantedColor = {1.0, 0.5, 0.25, 1.0};
		std::array<double, 4> WantedFour = {1.0, 2.0, 3.0, 4.0};
		for (int Index = 0; Index < 10; ++Index)
		{
			APostProcessVolume Volume;
			Volume.bUnbound = true;
			Volume.Priority = static_cast<float>(Index);
			Volume.BlendWeight = Chance(0.2) ? 1.0f : Chance(0.2) ? 0.0f : static_cast<float>(Uniform(Random));
			const double Weight = Volume.BlendWeight;
			const auto Lerp = [Weight](double From, double To)
			{
				return From + (To - From) * Weight;
			};
			if (Chance(0.6))
			{
				const float Value = static_cast<float>(Uniform(Random) * 8.0);
				Strength.Set(Volume.Settings, Value);
				WantedStrength = Lerp(WantedStrength, Value);
			}
			if (Chance(0.6))
			{
				const float Value = Chance(0.3) ? 0.0f : static_cast<float>(Uniform(Random) * 100.0);
				Focus.Set(Volume.Settings, Value);
				WantedFocus = Weight == 0.0                         ? WantedFocus
							  : WantedFocus == 0.0 || Value == 0.0f ? Value
																	: Lerp(WantedFocus, Value);
				Kept.Set(Volume.Settings, Value);
				WantedKept = Weight > 0.0 && Value != 0.0f ? Value : WantedKept;
			}
			if (Chance(0.5))
			{
				const int Value = static_cast<int>(Uniform(Random) * 3.0);
				Steps.Set(Volume.Settings, Value);
				Mode.Set(Volume.Settings, static_cast<EAddedMode>(Value));
				WantedSteps = Weight > 0.0 ? Value : WantedSteps;
				WantedMode = Weight > 0.0 ? Value : WantedMode;
			}
			if (Chance(0.5))
			{
				FLinearColor NewColor;
				FVector4f NewFour(0.0f, 0.0f, 0.0f, 0.0f);
				for (int Component = 0; Component < 4; ++Component)
				{
					const float Value = static_cast<float>(Uniform(Random) * 4.0 - 1.0);
					NewColor.Component(Component) = Value;
					(&NewFour.X)[Component] = -Value;
					const size_t At = static_cast<size_t>(Component);
					WantedColor[At] = Lerp(WantedColor[At], Value);
					WantedFour[At] = Lerp(WantedFour[At], -Value);
				}
				Color.Set(Volume.Settings, NewColor);
				Four.Set(Volume.Settings, NewFour);
			}
			Inputs.Volumes.push_back(Volume);
		}
		const FFinalPostProcessSettings Blended = FSettingsBlender(std::move(Inputs)).At(FVector(0, 0, 0)).Settings;
		ASSERT_NEAR(WantedStrength, Strength.Get(Blended), 1e-5) << "round " << Round;
		ASSERT_NEAR(WantedFocus, Focus.Get(Blended), 1e-4) << "round " << Round;
		ASSERT_EQ(static_cast<float>(WantedKept), Kept.Get(Blended)) << "round " << Round;
		ASSERT_EQ(WantedSteps, Steps.Get(Blended)) << "round " << Round;
		ASSERT_EQ(WantedMode, static_cast<int>(Mode.Get(Blended))) << "round " << Round;
		for (int Component = 0; Component < 4; ++Component)
		{
			const size_t At = static_cast<size_t>(Component);
			ASSERT_NEAR(WantedColor[At], Color.Get(Blended).Component(Component), 1e-5) << "round " << Round;
			const FVector4f Vector = Four.Get(Blended);
			ASSERT_NEAR(WantedFour[At], (&Vector.X)[Component], 1e-5) << "round " << Round;
		}
	}
}

TEST_F(AddedSettings, TheLedgerTellsTheirStory)
{
	FBlendInputs Inputs;
	Strength.Set(Inputs.Camera, 4.0f);
	Inputs.CameraWeight = 0.5f;
	FBlendLedger Ledger;
	FSettingsBlender(std::move(Inputs)).At(FVector(0, 0, 0), &Ledger);
	const std::vector<FBlendLedgerEntry>& Story = Ledger.GetEntries("AddedStrength");
	ASSERT_EQ(2u, Story.size());
	EXPECT_EQ(EBlendSource::Default, Story[0].Kind);
	EXPECT_EQ(0.25, Story[0].After.Components[0]);
	EXPECT_EQ(EBlendSource::Camera, Story[1].Kind);
	EXPECT_EQ(0.25 + (4.0 - 0.25) * 0.5, Story[1].After.Components[0]);
}

TEST_F(AddedSettings, PasteTextGoesThereAndBack)
{
	FSettingsText Text;
	Strength.Set(Text.Settings, 1.5f);
	On.Set(Text.Settings, false);
	Mode.Set(Text.Settings, EAddedMode::Third);
	Color.Set(Text.Settings, FLinearColor(0.5f, 0.25f, 0.125f, 0.0f));
	Four.Set(Text.Settings, FVector4f(4.0f, 3.0f, 2.0f, 1.0f));
	Two.Set(Text.Settings, FVector2D(1.0, 2.0));
	Steps.Set(Text.Settings, -5);
	std::vector<FDiagnostic> Diagnostics;
	const std::string Written = WriteSettingsText(Text, ESettingsTextForm::Delta, Diagnostics);
	EXPECT_THAT(Written, HasSubstr("bOverride_AddedStrength=True"));
	EXPECT_THAT(Written, HasSubstr("AddedStrength=1.500000"));
	EXPECT_THAT(Written, HasSubstr("AddedMode=Third"));
	const FSettingsText Read = ReadSettingsText(Written, "text", Diagnostics);
	EXPECT_TRUE(Diagnostics.empty()) << Diagnostics[0].ToString();
	EXPECT_TRUE(Read.Unknown.empty());
	EXPECT_EQ(1.5f, Strength.Get(Read.Settings));
	EXPECT_FALSE(On.Get(Read.Settings));
	EXPECT_TRUE(On.IsOverridden(Read.Settings));
	EXPECT_EQ(EAddedMode::Third, Mode.Get(Read.Settings));
	EXPECT_EQ(FLinearColor(0.5f, 0.25f, 0.125f, 0.0f), Color.Get(Read.Settings));
	EXPECT_EQ(FVector4f(4.0f, 3.0f, 2.0f, 1.0f), Four.Get(Read.Settings));
	EXPECT_EQ(FVector2D(1.0, 2.0), Two.Get(Read.Settings));
	EXPECT_EQ(-5, Steps.Get(Read.Settings));
	EXPECT_EQ(Written, WriteSettingsText(Read, ESettingsTextForm::Delta, Diagnostics));
}

TEST_F(AddedSettings, NamesThatAreTakenAreRefused)
{
	EXPECT_EQ(
		"2128 the setting BloomIntensity of the program cannot be added: FPostProcessSettings has one of that name\n",
		Refusal("BloomIntensity", 1.0f));
	EXPECT_THAT(Refusal("bloomintensity", 1.0f), HasSubstr("2128"));
	EXPECT_THAT(
		Refusal("AddedStrength", 1.0f), HasSubstr("2128 the setting AddedStrength of the program cannot be added: "
												  "the program has one of that name"));
}

TEST_F(AddedSettings, WhatMakesNoSenseIsRefused)
{
	const double NaN = std::numeric_limits<double>::quiet_NaN();
	EXPECT_THAT(Refusal("1Name", 1.0f), HasSubstr("2129"));
	EXPECT_THAT(Refusal("A Name", 1.0f), HasSubstr("2129"));
	EXPECT_THAT(Refusal("bOverride_Name", 1.0f), HasSubstr("2129"));
	EXPECT_THAT(Refusal("Name", 1.0f, {.Min = 2.0, .Max = 1.0}), HasSubstr("its range is empty"));
	EXPECT_THAT(Refusal("Name", 1.0f, {.Min = NaN}), HasSubstr("its range is empty"));
	EXPECT_THAT(Refusal("Name", 3.0f, {.Min = 0.0, .Max = 1.0}), HasSubstr("outside its range"));
	EXPECT_THAT(Refusal("Name", EAddedMode::Third, {.EnumNames = {"A", "B"}}), HasSubstr("EnumNames"));
	EXPECT_THAT(Refusal("Name", 1.0f, {.Blend = ESettingBlend::LUT}), HasSubstr("2129"));
	EXPECT_THAT(
		Refusal("Name", true, {.Blend = ESettingBlend::Lerp}), HasSubstr("nothing between two values of a bool"));
}

TEST(AddedSettingsEnd, TheFieldGoesWithItsHandleAndOldValuesAreNoOnesElse)
{
	const size_t NumBefore = GetSettingFields().size();
	FPostProcessSettings Settings;
	{
		const TPostProcessSetting<float> Setting(TEXT("AddedOnce"), 1.0f);
		EXPECT_EQ(NumBefore + 1, GetSettingFields().size());
		Setting.Set(Settings, 5.0f);
	}
	EXPECT_EQ(NumBefore, GetSettingFields().size());
	EXPECT_EQ(nullptr, FindSettingField("AddedOnce"));
	const TPostProcessSetting<float> Again(TEXT("AddedOnce"), 2.0f);
	EXPECT_EQ(2.0f, Again.Get(Settings));
	EXPECT_EQ("", TakeProblems());
}
