// What is written reads back: every field, any values, a whole volume's text altered by hand.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "PostProcessSettingsReflection.h"
#include "PostProcessSettingsText.h"
#include "PostProcessSettingsTextValue.h"
#include "SettingObjects.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

using namespace Drydock;

namespace
{

/** The same bits in every field, override bit and blendable. */
bool IsSame(const FPostProcessSettings& A, const FPostProcessSettings& B)
{
	bool bSame = A.WeightedBlendables.Array.Num() == B.WeightedBlendables.Array.Num();
	for (int32 Index = 0; bSame && Index < A.WeightedBlendables.Array.Num(); ++Index)
	{
		bSame = A.WeightedBlendables.Array[Index] == B.WeightedBlendables.Array[Index];
	}
	for (const FSettingField& Field : GetSettingFields())
	{
		const FSettingValue ValueA = Field.Get(A);
		const FSettingValue ValueB = Field.Get(B);
		bSame &= Field.IsOverridden(A) == Field.IsOverridden(B) && ValueA.Object == ValueB.Object &&
				 std::memcmp(ValueA.Components, ValueB.Components, sizeof(ValueA.Components)) == 0;
	}
	return bSame;
}

std::string Write(const FSettingsText& Settings, ESettingsTextForm Form)
{
	std::vector<FDiagnostic> Diagnostics;
	return WriteSettingsText(Settings, Form, Diagnostics);
}

FSettingsText Read(const std::string& Text)
{
	std::vector<FDiagnostic> Diagnostics;
	FSettingsText Settings = ReadSettingsText(Text, "", Diagnostics);
	for (const FDiagnostic& Diagnostic : Diagnostics)
	{
		EXPECT_NE(ESeverity::Error, Diagnostic.Severity) << Diagnostic.ToString();
	}
	return Settings;
}

/** A number typed with six decimals or fewer. */
double AnyDecimal()
{
	const int Number = *rc::gen::inRange(-2000000000, 2000000000);
	return Number / *rc::gen::element(1.0, 1000.0, 1e6);
}

/** Any finite float of at least this magnitude, all bit patterns alike. */
float AnyFloatFrom(float Least)
{
	const uint32_t Bits = *rc::gen::inRange(std::bit_cast<uint32_t>(Least), 0x7F800000u);
	return std::bit_cast<float>(Bits | (*rc::gen::arbitrary<bool>() ? 0x80000000u : 0u));
}

FSettingValue AnyValue(const FSettingField& Field)
{
	FSettingValue Value{Field.Type};
	switch (Field.Type)
	{
	case ESettingType::Bool:
		Value.Components[0] = *rc::gen::inRange(0, 2);
		break;
	case ESettingType::Int:
		Value.Components[0] = *rc::gen::arbitrary<int32_t>();
		break;
	case ESettingType::Enum:
		Value.Components[0] = *rc::gen::inRange(0, static_cast<int>(Field.EnumNames.Num()));
		break;
	case ESettingType::Object:
		Value.Object = Field.FindOrAddObject(*rc::gen::element<std::string>(
			"None", "/Game/A.A", "/Game/B_1.B_1", "/Game/Umlaut\xC3\xA4.X", "/Game/\"Quoted\\\".X"));
		break;
	default:
		for (int32 Index = 0; Index < Field.GetNumComponents(); ++Index)
		{
			Value.Components[Index] = AnyDecimal();
		}
	}
	return Value;
}

FSettingsText AnySettings()
{
	FSettingsText Settings;
	for (const FSettingField& Field : GetSettingFields())
	{
		if (*rc::gen::inRange(0, 4) == 0)
		{
			Field.Set(Settings.Settings, AnyValue(Field));
		}
		Field.SetOverridden(Settings.Settings, *rc::gen::arbitrary<bool>());
	}
	for (int Count = *rc::gen::inRange(0, 4); Count > 0; --Count)
	{
		const std::string Path = "/Game/M" + std::to_string(Count);
		Settings.Settings.AddBlendable(FindOrAddObject(Path), static_cast<float>(*rc::gen::inRange(0, 1001)) / 1000.0f);
	}
	return Settings;
}

std::string ReadFixture(const char* Name)
{
	std::ifstream Stream(std::string(DRYDOCK_TEST_SOURCE_DIR "/tests/settings/") + Name, std::ios::binary);
	EXPECT_TRUE(Stream) << Name;
	return std::string(std::istreambuf_iterator<char>(Stream), {});
}

} // namespace

class SettingsTextField : public testing::TestWithParam<size_t>
{
protected:
	const FSettingField& Field = GetSettingFields()[GetParam()];

	/** One that is not the default and that six decimals hold: 1/8 more, the other bool, the next name. */
	FSettingValue MakeOther() const
	{
		FSettingValue Value = Field.Default;
		const double NumNames = static_cast<double>(Field.EnumNames.Num());
		switch (Field.Type)
		{
		case ESettingType::Bool:
			Value.Components[0] = 1.0 - Value.Components[0];
			break;
		case ESettingType::Int:
			Value.Components[0] += 3.0;
			break;
		case ESettingType::Enum:
			Value.Components[0] = Value.Components[0] + 1.0 < NumNames ? Value.Components[0] + 1.0 : 0.0;
			break;
		case ESettingType::Object:
			Value.Object = Field.FindOrAddObject("/Game/Folder/Name.Name");
			break;
		default:
			for (int32 Index = 0; Index < Field.GetNumComponents(); ++Index)
			{
				Value.Components[Index] = 0.125 * (Index + 1);
			}
		}
		return Value;
	}
};

TEST_P(SettingsTextField, OtherValueReadsBack)
{
	FSettingsText Settings;
	Field.Set(Settings.Settings, MakeOther());
	Field.SetOverridden(Settings.Settings, true);
	EXPECT_FALSE(IsSame({}, Settings.Settings));
	EXPECT_TRUE(IsSame(Settings.Settings, Read(Write(Settings, ESettingsTextForm::Delta)).Settings));
	EXPECT_TRUE(IsSame(Settings.Settings, Read(Write(Settings, ESettingsTextForm::Full)).Settings));
}

TEST_P(SettingsTextField, DefaultSurvivesSixDecimals)
{
	FSettingsText Settings;
	Field.SetOverridden(Settings.Settings, true);
	std::vector<FDiagnostic> Diagnostics;
	const std::string Text = WriteSettingsText(Settings, ESettingsTextForm::Delta, Diagnostics);
	EXPECT_TRUE(Diagnostics.empty()) << Diagnostics[0].ToString();
	EXPECT_TRUE(IsSame(Settings.Settings, Read(Text).Settings)) << Text;
}

INSTANTIATE_TEST_SUITE_P(Table, SettingsTextField, testing::Range<size_t>(0, GetSettingFields().size()),
	[](const testing::TestParamInfo<size_t>& Info) { return std::string(GetSettingFields()[Info.param].Name); });

RC_GTEST_PROP(SettingsTextRoundTrip, AnySettingsOfSixDecimalsReadBack, ())
{
	const FSettingsText Settings = AnySettings();
	const ESettingsTextForm Form = *rc::gen::element(ESettingsTextForm::Delta, ESettingsTextForm::Full);
	RC_ASSERT(IsSame(Settings.Settings, Read(Write(Settings, Form)).Settings));
}

RC_GTEST_PROP(SettingsTextRoundTrip, WritingIsStable, ())
{
	const ESettingsTextForm Form = *rc::gen::element(ESettingsTextForm::Delta, ESettingsTextForm::Full);
	const std::string Text = Write(AnySettings(), Form);
	RC_ASSERT(Text == Write(Read(Text), Form));
}

RC_GTEST_PROP(SettingsTextRoundTrip, AnyFloatReadsBackOrIsReported, ())
{
	FSettingsText Settings;
	Settings.Settings.AutoExposureBias = AnyFloatFrom(0.0f);
	std::vector<FDiagnostic> Diagnostics;
	const std::string Text = WriteSettingsText(Settings, ESettingsTextForm::Full, Diagnostics);
	RC_ASSERT(IsSame(Settings.Settings, Read(Text).Settings) == Diagnostics.empty());
}

RC_GTEST_PROP(SettingsTextRoundTrip, FloatsFrom16UpSurvive, ())
{
	const float Number = AnyFloatFrom(16.0f);
	FSettingsText Settings;
	Settings.Settings.AutoExposureBias = Number;
	RC_ASSERT(Number == Read(Write(Settings, ESettingsTextForm::Delta)).Settings.AutoExposureBias);
}

RC_GTEST_PROP(SettingsTextRoundTrip, NoTextIsTooStrange, (const std::string& Noise))
{
	std::vector<FDiagnostic> Diagnostics;
	const FSettingsText First = ReadSettingsText("(" + Noise + ")", "", Diagnostics);
	const std::string Text = Write(First, ESettingsTextForm::Delta);
	RC_ASSERT(Text == Write(Read(Text), ESettingsTextForm::Delta));
}

// full_export.txt: our own full export, then by hand: fields moved, line breaks and spaces, other spellings of enums
// and objects, fields of another engine version, a second value changed here and there.
class SettingsTextFixture : public testing::Test
{
protected:
	std::vector<FDiagnostic> Diagnostics;
	const FSettingsText Text = ReadSettingsText(ReadFixture("full_export.txt"), "full_export.txt", Diagnostics);
	const FPostProcessSettings& Settings = Text.Settings;
};

TEST_F(SettingsTextFixture, HasNoErrorAndOneWarningForUnknownFields)
{
	ASSERT_EQ(1u, Diagnostics.size());
	EXPECT_EQ(3022, Diagnostics[0].Code) << Diagnostics[0].ToString();
}

TEST_F(SettingsTextFixture, AlteredValuesAreRead)
{
	EXPECT_EQ(1.2f, Settings.BloomIntensity);
	EXPECT_EQ(BM_FFT, Settings.BloomMethod);
	EXPECT_EQ(AEM_Manual, Settings.AutoExposureMethod);
	EXPECT_EQ(FLinearColor(0.3465f, 0.2f, 0.1f, 1.0f), Settings.Bloom1Tint);
	EXPECT_EQ(FVector4(1.0, 0.9, 0.8, 1.0), Settings.ColorGain);
	EXPECT_EQ(FLinearColor(0.5f, 0.4f, 0.3f, 0.2f), Settings.LensFlareTints[3]);
	EXPECT_EQ(FindOrAddTexture("/Game/Lens/T_Dirt.T_Dirt"), Settings.BloomDirtMask.Get());
}

TEST_F(SettingsTextFixture, TheirBitsAndNoOthersAreOn)
{
	std::vector<std::string> Overridden;
	for (const FSettingField& Field : GetSettingFields())
	{
		if (Field.IsOverridden(Settings))
		{
			Overridden.emplace_back(Field.Name);
		}
	}
	EXPECT_EQ((std::vector<std::string>{"ColorGain", "BloomMethod", "BloomIntensity", "Bloom1Tint", "BloomDirtMask",
				  "AutoExposureMethod", "LensFlareTints"}),
		Overridden);
}

TEST_F(SettingsTextFixture, AllOtherValuesAreTheDefaults)
{
	for (const FSettingField& Field : GetSettingFields())
	{
		if (!Field.IsOverridden(Settings))
		{
			EXPECT_EQ(Field.Default, Field.Get(Settings)) << Field.Name;
		}
	}
}

TEST_F(SettingsTextFixture, UnknownFieldsAreKept)
{
	EXPECT_EQ((std::vector<FUnknownSetting>{{"bOverride_SkyLightCatcher", "False", "bOverride_BloomIntensity"},
				  {"SkyLightCatcher", "(Mode=Fast,Steps=(3,5,8),Note=\"a, b) \\\" c\")", "BloomIntensity"}}),
		Text.Unknown);
}

TEST_F(SettingsTextFixture, WritesToItself)
{
	const std::string Full = Write(Text, ESettingsTextForm::Full);
	const FSettingsText Again = Read(Full);
	EXPECT_TRUE(IsSame(Settings, Again.Settings));
	EXPECT_EQ(Full, Write(Again, ESettingsTextForm::Full));
}
