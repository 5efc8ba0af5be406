// Every field of the settings table on its way through paste text and through a blend with its ledger, each as a test
// of its own name.
#include <gtest/gtest.h>

#include "BlendSettings.h"
#include "PostProcessSettingsText.h"
#include "SettingSamples.h"

#include <cmath>

using namespace Drydock;

namespace
{

class SettingFieldPaths : public testing::TestWithParam<const FSettingField*>
{
protected:
	const FSettingField& Field = *GetParam();

	/** The only field that is overridden, with a value of at most six decimals, which paste text can hold. */
	FPostProcessSettings MakeSettings() const
	{
		FSettingValue Value = MakeOtherValue(Field);
		for (double& Component : Value.Components)
		{
			Component = std::round(Component * 1e6) / 1e6;
		}
		FPostProcessSettings Settings;
		Field.Set(Settings, Value);
		Field.SetOverridden(Settings, true);
		return Settings;
	}

	void ExpectReadsBack(ESettingsTextForm Form)
	{
		FSettingsText Source;
		Source.Settings = MakeSettings();
		std::vector<FDiagnostic> Diagnostics;
		const std::string Text = WriteSettingsText(Source, Form, Diagnostics);
		const FSettingsText Read = ReadSettingsText(Text, "paste.txt", Diagnostics);
		for (const FDiagnostic& Diagnostic : Diagnostics) // a value outside its range warns
		{
			EXPECT_EQ(ESeverity::Warning, Diagnostic.Severity) << Diagnostic.ToString();
		}
		EXPECT_TRUE(Read.Unknown.empty()) << Read.Unknown[0].Key;
		for (const FSettingField& Each : GetSettingFields())
		{
			EXPECT_EQ(Each.Get(Source.Settings), Each.Get(Read.Settings)) << Each.Name;
			EXPECT_EQ(&Each == &Field, Each.IsOverridden(Read.Settings)) << Each.Name;
		}
	}
};

} // namespace

INSTANTIATE_TEST_SUITE_P(Each, SettingFieldPaths, AllSettingFields(), FNameOfSetting());

TEST_P(SettingFieldPaths, PasteTextOfWhatIsSetReadsBack)
{
	ExpectReadsBack(ESettingsTextForm::Delta);
}

TEST_P(SettingFieldPaths, FullPasteTextReadsBack)
{
	ExpectReadsBack(ESettingsTextForm::Full);
}

TEST_P(SettingFieldPaths, LedgerTellsWhatAVolumeDid)
{
	FBlendInputs Inputs;
	APostProcessVolume Volume;
	Volume.Name = "Fog";
	Volume.bUnbound = true;
	Volume.BlendWeight = 0.5f;
	Volume.Settings = MakeSettings();
	Inputs.Volumes.push_back(Volume);
	FBlendLedger Ledger;
	const FBlendedSettings Blended = FSettingsBlender(Inputs).At(FVector(), &Ledger);

	const std::vector<FBlendLedgerEntry>& Entries = Ledger.GetEntries(Field.Name);
	ASSERT_LE(2u, Entries.size());
	EXPECT_EQ(EBlendSource::Default, Entries.front().Kind);
	EXPECT_EQ(Field.Default, Entries.front().After);
	const FBlendLedgerEntry& Entry = Entries.back();
	EXPECT_EQ(EBlendSource::Volume, Entry.Kind);
	EXPECT_EQ("Fog", Entry.Source);
	EXPECT_EQ(ToString(Field.Blend), Entry.Rule);
	EXPECT_EQ(std::optional<float>(0.5f), Entry.Weight);
	EXPECT_EQ(Entries[Entries.size() - 2].After, Entry.Before); // r.DefaultFeature.* may stand between
	FPostProcessSettings Expected;
	Field.Set(Expected, Entry.Before);
	Field.BlendFrom(Expected, Volume.Settings, 0.5f);
	EXPECT_EQ(Field.Get(Expected), Entry.After);
	EXPECT_EQ(Field.Get(Expected), Field.Get(Blended.Settings));
}
