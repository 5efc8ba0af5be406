// The engine's property text: what is read, what is written. Samples are the engine's own spelling; values by hand.
#include <gtest/gtest.h>

#include "PostProcessSettingsReflection.h"
#include "PostProcessSettingsText.h"
#include "SettingObjects.h"

using namespace Drydock;

namespace
{

struct FRead
{
	FSettingsText Text;
	std::vector<FDiagnostic> Diagnostics;
};

FRead Read(const std::string& Text)
{
	FRead Result;
	Result.Text = ReadSettingsText(Text, "clip.txt", Result.Diagnostics);
	return Result;
}

FPostProcessSettings ReadClean(const std::string& Text)
{
	const FRead Result = Read(Text);
	EXPECT_TRUE(Result.Diagnostics.empty()) << Result.Diagnostics[0].ToString();
	return Result.Text.Settings;
}

/** The only message, as it is printed. */
std::string Message(const std::string& Text)
{
	const FRead Result = Read(Text);
	EXPECT_EQ(1u, Result.Diagnostics.size()) << Text;
	return Result.Diagnostics.empty() ? "" : Result.Diagnostics[0].ToString();
}

std::string Write(const FSettingsText& Settings, ESettingsTextForm Form = ESettingsTextForm::Delta)
{
	std::vector<FDiagnostic> Diagnostics;
	const std::string Text = WriteSettingsText(Settings, Form, Diagnostics);
	EXPECT_TRUE(Diagnostics.empty()) << Diagnostics[0].ToString();
	return Text;
}

/** What comes out for what goes in. */
std::string Rewrite(const std::string& Text)
{
	return Write(Read(Text).Text);
}

const std::string GSample =
	"(bOverride_BloomIntensity=True,BloomIntensity=1.200000,bOverride_BloomMethod=True,BloomMethod=BM_SOG,"
	"bOverride_Bloom1Tint=True,Bloom1Tint=(R=0.346500,G=0.346500,B=0.346500,A=1.000000))";

} // namespace

TEST(SettingsText, EnginesSampleIsRead)
{
	const FPostProcessSettings Settings = ReadClean(GSample);
	EXPECT_EQ(1.2f, Settings.BloomIntensity);
	EXPECT_EQ(BM_SOG, Settings.BloomMethod);
	EXPECT_EQ(FLinearColor(0.3465f, 0.3465f, 0.3465f, 1.0f), Settings.Bloom1Tint);
}

TEST(SettingsText, EnginesSampleSetsItsThreeBitsAndNoOther)
{
	const FPostProcessSettings Settings = ReadClean(GSample);
	int NumOverridden = 0;
	for (const FSettingField& Field : GetSettingFields())
	{
		NumOverridden += Field.IsOverridden(Settings);
	}
	EXPECT_EQ(3, NumOverridden);
	EXPECT_TRUE(Settings.bOverride_BloomIntensity && Settings.bOverride_BloomMethod && Settings.bOverride_Bloom1Tint);
}

TEST(SettingsText, ImportSetsOnlyWhatIsNamed)
{
	const FPostProcessSettings Settings = ReadClean(GSample);
	EXPECT_EQ(-1.0f, Settings.BloomThreshold);
	EXPECT_EQ(4.0f, Settings.BloomSizeScale);
}

TEST(SettingsText, EmptyStructIsAllDefaults)
{
	ReadClean("()");
	EXPECT_EQ("()", Rewrite("()"));
}

TEST(SettingsText, SpacesAndLineBreaksAreAccepted)
{
	const FPostProcessSettings Settings =
		ReadClean(" ( bOverride_BloomIntensity = True ,\r\n\tBloomIntensity\t= 2.5\n)\n\n");
	EXPECT_EQ(2.5f, Settings.BloomIntensity);
	EXPECT_TRUE(Settings.bOverride_BloomIntensity);
}

TEST(SettingsText, OrderDoesNotMatter)
{
	const FPostProcessSettings Settings = ReadClean("(BloomIntensity=2.5,bOverride_BloomIntensity=True)");
	EXPECT_EQ(2.5f, Settings.BloomIntensity);
	EXPECT_TRUE(Settings.bOverride_BloomIntensity);
}

TEST(SettingsText, NamesIgnoreCase)
{
	const FPostProcessSettings Settings = ReadClean("(boverride_bloomintensity=True,BLOOMINTENSITY=2.5)");
	EXPECT_EQ(2.5f, Settings.BloomIntensity);
	EXPECT_TRUE(Settings.bOverride_BloomIntensity);
}

TEST(SettingsText, ByteOrderMarkIsSkipped)
{
	EXPECT_EQ(2.5f, ReadClean("\xEF\xBB\xBF(bOverride_BloomIntensity=True,BloomIntensity=2.5)").BloomIntensity);
}

class SettingsTextTrue : public testing::TestWithParam<const char*>
{
};

TEST_P(SettingsTextTrue, SwitchesABitOn)
{
	EXPECT_TRUE(ReadClean(std::string("(BloomIntensity=1,bOverride_BloomIntensity=") + GetParam() + ")")
					.bOverride_BloomIntensity);
}

INSTANTIATE_TEST_SUITE_P(Spellings, SettingsTextTrue, testing::Values("True", "true", "TRUE", "1"));

class SettingsTextNumber : public testing::TestWithParam<std::pair<const char*, float>>
{
};

TEST_P(SettingsTextNumber, IsRead)
{
	EXPECT_EQ(GetParam().second,
		ReadClean(std::string("(bOverride_AutoExposureBias=True,AutoExposureBias=") + GetParam().first + ")")
			.AutoExposureBias);
}

INSTANTIATE_TEST_SUITE_P(Spellings, SettingsTextNumber,
	testing::Values(std::pair("1.200000", 1.2f), std::pair("5", 5.0f), std::pair("-2", -2.0f), std::pair("+3.5", 3.5f),
		std::pair(".25", 0.25f), std::pair("7.", 7.0f), std::pair("1e-3", 0.001f), std::pair("-0.000000", -0.0f),
		std::pair("1e-400", 0.0f)));

class SettingsTextEnum : public testing::TestWithParam<const char*>
{
};

TEST_P(SettingsTextEnum, IsRead)
{
	EXPECT_EQ(
		BM_FFT, ReadClean(std::string("(bOverride_BloomMethod=True,BloomMethod=") + GetParam() + ")").BloomMethod);
}

INSTANTIATE_TEST_SUITE_P(Spellings, SettingsTextEnum,
	testing::Values(
		"BM_FFT", "EBloomMethod::BM_FFT", "bm_fft", "1", "\"BM_FFT\"", "/Script/Engine.EBloomMethod::BM_FFT"));

TEST(SettingsText, EnumClassesAreReadByTheirShortNames)
{
	EXPECT_EQ(EReflectionMethod::ScreenSpace,
		ReadClean("(bOverride_ReflectionMethod=True,ReflectionMethod=ScreenSpace)").ReflectionMethod);
	EXPECT_EQ(
		EReflectionMethod::None, ReadClean("(bOverride_ReflectionMethod=True,ReflectionMethod=None)").ReflectionMethod);
}

TEST(SettingsText, ComponentsComeInAnyOrderAndUnnamedOnesKeepTheirDefaults)
{
	// Bloom1Tint is (0.3465, 0.3465, 0.3465, 1) by default.
	EXPECT_EQ(FLinearColor(0.3465f, 2.0f, 0.5f, 1.0f),
		ReadClean("(bOverride_Bloom1Tint=True,Bloom1Tint=(B=0.5,g=2))").Bloom1Tint);
}

TEST(SettingsText, VectorsAreRead)
{
	const FPostProcessSettings Settings =
		ReadClean("(bOverride_BloomConvolutionCenterUV=True,BloomConvolutionCenterUV=(X=0.1,Y=0.2),"
				  "bOverride_ColorGain=True,ColorGain=(X=1.000000,Y=2.000000,Z=3.000000,W=4.000000))");
	EXPECT_EQ(FVector2D(0.1, 0.2), Settings.BloomConvolutionCenterUV);
	EXPECT_EQ(FVector4(1.0, 2.0, 3.0, 4.0), Settings.ColorGain);
}

TEST(SettingsText, ElementsOfArraysAreReadOneByOne)
{
	const FPostProcessSettings Settings = ReadClean(
		"(bOverride_LensFlareTints=True,LensFlareTints[7]=(R=0.5,G=0.25,B=0.125,A=1.0),LensFlareTints[ 0 ]=(R=9))");
	EXPECT_EQ(FLinearColor(0.5f, 0.25f, 0.125f, 1.0f), Settings.LensFlareTints[7]);
	EXPECT_EQ(9.0f, Settings.LensFlareTints[0].R);
	EXPECT_EQ(FPostProcessSettings().LensFlareTints[0].G, Settings.LensFlareTints[0].G);
}

class SettingsTextObject : public testing::TestWithParam<const char*>
{
};

TEST_P(SettingsTextObject, IsReadByItsPath)
{
	EXPECT_EQ(FindOrAddTexture("/Game/Lens/Dirt.Dirt"),
		ReadClean(std::string("(bOverride_BloomDirtMask=True,BloomDirtMask=") + GetParam() + ")").BloomDirtMask.Get());
}

INSTANTIATE_TEST_SUITE_P(Spellings, SettingsTextObject,
	testing::Values("Texture2D'/Game/Lens/Dirt.Dirt'", "Texture2D'\"/Game/Lens/Dirt.Dirt\"'",
		"/Script/Engine.Texture2D'/Game/Lens/Dirt.Dirt'", "\"/Script/Engine.Texture2D'/Game/Lens/Dirt.Dirt'\"",
		"/Game/Lens/Dirt.Dirt", "\"/Game/Lens/Dirt.Dirt\""));

TEST(SettingsText, NoneIsNoObject)
{
	EXPECT_EQ(nullptr, ReadClean("(bOverride_BloomDirtMask=True,BloomDirtMask=None)").BloomDirtMask.Get());
	EXPECT_EQ(nullptr, ReadClean("(bOverride_BloomDirtMask=True,BloomDirtMask=\"\")").BloomDirtMask.Get());
}

TEST(SettingsText, BlendablesAreRead)
{
	const FWeightedBlendables Blendables =
		ReadClean("(WeightedBlendables=(Array=((Weight=0.500000,Object=\"/Script/Engine.Material'/Game/M.M'\"),"
				  "(Weight=1.000000,Object=Material'/Game/N.N'))))")
			.WeightedBlendables;
	ASSERT_EQ(2, Blendables.Array.Num());
	EXPECT_EQ(FWeightedBlendable(0.5f, FindOrAddObject("/Game/M.M")), Blendables.Array[0]);
	EXPECT_EQ(FWeightedBlendable(1.0f, FindOrAddObject("/Game/N.N")), Blendables.Array[1]);
}

TEST(SettingsText, EmptyBlendablesHaveThreeSpellings)
{
	for (const char* Text :
		{"(WeightedBlendables=(Array=))", "(WeightedBlendables=())", "(WeightedBlendables=(Array=()))"})
	{
		EXPECT_EQ(0, ReadClean(Text).WeightedBlendables.Array.Num()) << Text;
	}
}

TEST(SettingsText, ValueWithoutItsBitIsKeptAndReported)
{
	EXPECT_EQ("clip.txt:1:2: warning DD3020 at Settings: kept, but without effect, for the override bit is off: "
			  "FilmToe, BloomIntensity",
		Message("(BloomIntensity=2.000000,FilmToe=0.5)"));
	const FPostProcessSettings Settings = Read("(BloomIntensity=2.000000)").Text.Settings;
	EXPECT_EQ(2.0f, Settings.BloomIntensity);
	EXPECT_FALSE(Settings.bOverride_BloomIntensity);
}

TEST(SettingsText, BitThatIsOffCountsAsOff)
{
	EXPECT_EQ("clip.txt:1:33: warning DD3020 at Settings: kept, but without effect, for the override bit is off: "
			  "BloomIntensity",
		Message("(bOverride_BloomIntensity=False,BloomIntensity=2)"));
}

TEST(SettingsText, DefaultWithoutItsBitIsNoNews)
{
	ReadClean("(bOverride_BloomIntensity=False,BloomIntensity=0.675000)");
}

TEST(SettingsText, BitWithoutAValueIsTheDefault)
{
	EXPECT_EQ("clip.txt:1:2: note DD3021 at Settings: overridden without a value, so with the default: BloomIntensity",
		Message("(bOverride_BloomIntensity=True)"));
	const FPostProcessSettings Settings = Read("(bOverride_BloomIntensity=True)").Text.Settings;
	EXPECT_EQ(0.675f, Settings.BloomIntensity);
	EXPECT_TRUE(Settings.bOverride_BloomIntensity);
}

TEST(SettingsText, OutOfRangeIsUsedAndReported)
{
	EXPECT_EQ(
		"clip.txt:1:47: warning DD3023 at BloomIntensity: BloomIntensity is outside its range; it is used as it is",
		Message("(bOverride_BloomIntensity=True,BloomIntensity=-1)"));
	EXPECT_EQ(-1.0f, Read("(bOverride_BloomIntensity=True,BloomIntensity=-1)").Text.Settings.BloomIntensity);
}

TEST(SettingsText, UnknownFieldsAreOneWarning)
{
	EXPECT_EQ("clip.txt:1:2: warning DD3022 at Settings: no settings of drydock's, kept as text: bOverride_NewFeature, "
			  "NewFeature",
		Message("(bOverride_NewFeature=True,NewFeature=(A=1,B=(C=2)))"));
}

TEST(SettingsText, UnknownFieldNearAKnownOneIsSuggested)
{
	EXPECT_EQ(
		"clip.txt:1:2: warning DD3022 at Settings: no settings of drydock's, kept as text: BloomIntensty (did you "
		"mean BloomIntensity?)",
		Message("(BloomIntensty=1)"));
}

TEST(SettingsText, UnknownFieldsAreWrittenInTheirPlace)
{
	const std::string Text = "(First=1,bOverride_BloomIntensity=True,bOverride_NewFeature=True,BloomIntensity=1.200000,"
							 "NewFeature=(A=1,B=\"x, (y)\"),NewArray[1]=NSLOCTEXT(\"a\", \"b\", \"c)\"),Empty=)";
	EXPECT_EQ(Text, Rewrite(Text));
}

TEST(SettingsText, UnknownFieldsFollowTheirNeighbourToItsPlace)
{
	EXPECT_EQ("(bOverride_FilmToe=True,bOverride_BloomIntensity=True,FilmToe=0.500000,BloomIntensity=1.200000,New=1)",
		Rewrite("(BloomIntensity=1.2,New=1,FilmToe=0.5,bOverride_BloomIntensity=True,bOverride_FilmToe=True)"));
}

TEST(SettingsText, UnknownFieldStaysWhereItsNeighbourIsNotWritten)
{
	EXPECT_EQ("(bOverride_BloomIntensity=True,New=1,BloomIntensity=1.200000)",
		Rewrite("(FilmToe=0.550000,New=1,bOverride_BloomIntensity=True,BloomIntensity=1.2)"));
}

TEST(SettingsText, UnknownValuesLoseTheirSpacesAndNothingElse)
{
	EXPECT_EQ("(New=(A=1,B=(C=0.10,\"d e\")))", Rewrite("( New = ( A = 1 ,\n B = ( C = 0.10 , \"d e\" ) ) )"));
}

TEST(SettingsText, DeltaHasBitsFirstThenValuesInTheTablesOrder)
{
	FSettingsText Settings;
	Settings.Settings.bOverride_BloomIntensity = true;
	Settings.Settings.BloomIntensity = 1.2f;
	Settings.Settings.bOverride_FilmToe = true;
	EXPECT_EQ("(bOverride_FilmToe=True,bOverride_BloomIntensity=True,FilmToe=0.550000,BloomIntensity=1.200000)",
		Write(Settings));
}

TEST(SettingsText, DeltaKeepsInertValues)
{
	FSettingsText Settings;
	Settings.Settings.BloomIntensity = 2.0f;
	EXPECT_EQ("(BloomIntensity=2.000000)", Write(Settings));
}

TEST(SettingsText, TypesAreWrittenAsTheEngineWritesThem)
{
	FSettingsText Settings;
	FPostProcessSettings& Values = Settings.Settings;
	Values.BloomMethod = BM_FFT;
	Values.Bloom2Tint = FLinearColor(1.0f, 0.5f, 0.25f, 0.0f);
	Values.BloomConvolutionCenterUV = FVector2D(0.25, -1.0);
	Values.BloomDirtMask = FindOrAddTexture("/Game/Lens/Dirt.Dirt");
	Values.AutoExposureApplyPhysicalCameraExposure = false;
	Values.DepthOfFieldBladeCount = 7;
	Values.LensFlareTints[1].R = 0.5f;
	Values.AddBlendable(FindOrAddObject("/Game/M.M"), 0.5f);
	EXPECT_EQ("(BloomMethod=BM_FFT,Bloom2Tint=(R=1.000000,G=0.500000,B=0.250000,A=0.000000),"
			  "BloomConvolutionCenterUV=(X=0.250000,Y=-1.000000),"
			  "BloomDirtMask=\"/Script/Engine.Texture2D'/Game/Lens/Dirt.Dirt'\","
			  "DepthOfFieldBladeCount=7,AutoExposureApplyPhysicalCameraExposure=False,"
			  "LensFlareTints[1]=(R=0.500000,G=1.000000,B=0.600000,A=0.530000),"
			  "WeightedBlendables=(Array=((Weight=0.500000,Object=\"/Game/M.M\"))))",
		Write(Settings));
}

TEST(SettingsText, FullNamesEveryField)
{
	const std::string Full = Write({}, ESettingsTextForm::Full);
	for (const FSettingField& Field : GetSettingFields())
	{
		EXPECT_NE(std::string::npos, Full.find(std::string(Field.OverrideName) + "=False,")) << Field.Name;
	}
	EXPECT_NE(std::string::npos, Full.find(",BloomIntensity=0.675000,"));
	EXPECT_NE(std::string::npos, Full.find("WeightedBlendables=(Array=))"));
}

TEST(SettingsText, ValuesThatSixDecimalsDoNotHoldAreOneWarning)
{
	FSettingsText Settings;
	Settings.Settings.BloomIntensity = 1e-7f;
	Settings.Settings.FilmToe = 1.0f / 3.0f;
	Settings.Settings.Bloom6Size = 1234567.0f;
	std::vector<FDiagnostic> Diagnostics;
	WriteSettingsText(Settings, ESettingsTextForm::Delta, Diagnostics);
	ASSERT_EQ(1u, Diagnostics.size());
	EXPECT_EQ("warning DD3024: six decimals do not hold these values: FilmToe (0.33333334), BloomIntensity (1e-07)",
		Diagnostics[0].ToString());
}

TEST(SettingsUpgrade, ConvolutionBloomSetsGivenIntensitiesToOne)
{
	FPostProcessSettings Settings =
		ReadClean("(bOverride_BloomMethod=True,BloomMethod=BM_FFT,bOverride_BloomIntensity=True,BloomIntensity=8,"
				  "bOverride_BloomToonIntensity=True,BloomToonIntensity=0.1)");
	EXPECT_EQ((std::vector<std::string>{"BloomIntensity", "BloomToonIntensity"}), UpgradeSettings(Settings));
	EXPECT_EQ(1.0f, Settings.BloomIntensity);
	EXPECT_EQ(1.0f, Settings.BloomToonIntensity);
}

TEST(SettingsUpgrade, OtherBloomAndNoBloomStay)
{
	FPostProcessSettings Gaussian;
	Gaussian.BloomIntensity = 8.0f;
	FPostProcessSettings Off;
	Off.BloomMethod = BM_FFT;
	Off.BloomIntensity = 0.0f;
	EXPECT_TRUE(UpgradeSettings(Gaussian).empty());
	EXPECT_TRUE(UpgradeSettings(Off).empty());
	EXPECT_EQ(8.0f, Gaussian.BloomIntensity);
	EXPECT_EQ(0.0f, Off.BloomIntensity);
}

TEST(SettingsUpgrade, ConvolutionsOwnIntensityStays)
{
	FPostProcessSettings Settings =
		ReadClean("(bOverride_BloomMethod=True,BloomMethod=BM_FFT,bOverride_BloomConvolutionIntensity=True,"
				  "BloomConvolutionIntensity=2)");
	EXPECT_TRUE(UpgradeSettings(Settings).empty());
	EXPECT_EQ(2.0f, Settings.BloomConvolutionIntensity);
}

TEST(SettingsUpgrade, WhatIsNotGivenStays)
{
	FPostProcessSettings Settings = ReadClean("(bOverride_BloomMethod=True,BloomMethod=BM_FFT)");
	EXPECT_TRUE(UpgradeSettings(Settings).empty());
	EXPECT_EQ(0.675f, Settings.BloomIntensity);
}
