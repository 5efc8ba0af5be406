// The settings table and its reflection. Expected values: the engine's published defaults, and arithmetic by hand.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "Engine/Scene.h"
#include "PostProcessSettingsReflection.h"

#include <cmath>
#include <limits>
#include <set>

using namespace Drydock;

namespace
{

const FSettingField& Field(const std::string& Name)
{
	const FSettingField* Found = FindSettingField(Name);
	EXPECT_NE(nullptr, Found) << Name;
	return *Found;
}

FSettingValue FromText(const std::string& Name, const std::string& Text)
{
	FSettingValue Value;
	std::string Error;
	EXPECT_TRUE(SettingFromText(Field(Name), Text, Value, Error)) << Error;
	return Value;
}

std::string ErrorOf(const std::string& Name, const std::string& Text)
{
	FSettingValue Value;
	std::string Error;
	EXPECT_FALSE(SettingFromText(Field(Name), Text, Value, Error)) << Text;
	return Error;
}

/** Volume over default, one field. */
float Blend(const std::string& Name, float Base, float Volume, float Weight)
{
	FPostProcessSettings Target;
	FPostProcessSettings Source;
	Field(Name).Set(Target, {ESettingType::Float, {Base}});
	Field(Name).Set(Source, {ESettingType::Float, {Volume}});
	Field(Name).BlendFrom(Target, Source, Weight);
	return static_cast<float>(Field(Name).Get(Target).Components[0]);
}

} // namespace

TEST(PostProcessSettings, BloomDefaultsAreTheEngines)
{
	const FPostProcessSettings Settings;
	EXPECT_EQ(0.675f, Settings.BloomIntensity);
	EXPECT_EQ(-1.0f, Settings.BloomThreshold);
	EXPECT_EQ(4.0f, Settings.BloomSizeScale);
	EXPECT_EQ(BM_SOG, Settings.BloomMethod);
}

TEST(PostProcessSettings, BloomTintsSumToTheEngines)
{
	const FPostProcessSettings Settings;
	const float Sum = Settings.Bloom1Tint.R + Settings.Bloom2Tint.G + Settings.Bloom3Tint.B + Settings.Bloom4Tint.R +
					  Settings.Bloom5Tint.G + Settings.Bloom6Tint.B;
	EXPECT_NEAR(0.7951f, Sum, 1e-6f);
}

TEST(PostProcessSettings, BloomSizesAreTheEngines)
{
	const FPostProcessSettings Settings;
	const float Sizes[] = {Settings.Bloom1Size, Settings.Bloom2Size, Settings.Bloom3Size, Settings.Bloom4Size,
		Settings.Bloom5Size, Settings.Bloom6Size};
	const float Expected[] = {0.3f, 1.0f, 2.0f, 10.0f, 30.0f, 64.0f};
	for (int Index = 0; Index < 6; ++Index)
	{
		EXPECT_EQ(Expected[Index], Sizes[Index]);
	}
}

TEST(PostProcessSettings, FilmAndVignetteDefaultsAreTheEngines)
{
	const FPostProcessSettings Settings;
	EXPECT_EQ(0.88f, Settings.FilmSlope);
	EXPECT_EQ(0.55f, Settings.FilmToe);
	EXPECT_EQ(0.26f, Settings.FilmShoulder);
	EXPECT_EQ(0.0f, Settings.FilmBlackClip);
	EXPECT_EQ(0.04f, Settings.FilmWhiteClip);
	EXPECT_EQ(0.4f, Settings.VignetteIntensity);
}

TEST(PostProcessSettings, EngineMarkupIsIgnored)
{
	struct FPatched
	{
		UPROPERTY(interp, BlueprintReadWrite, Category = "Lens|Bloom", meta = (ClampMin = "0.0", UIMax = "8.0"))
		float BloomToonIntensity = 0.675f;
	};
	EXPECT_EQ(FPatched().BloomToonIntensity, FPostProcessSettings().BloomToonIntensity);
}

TEST(PostProcessSettings, NewSettingsOverrideNothing)
{
	const FPostProcessSettings Settings;
	for (const FSettingField& Each : GetSettingFields())
	{
		EXPECT_FALSE(Each.IsOverridden(Settings)) << Each.Name;
	}
}

TEST(PostProcessSettings, SetBaseValuesForgetsValuesAndOverrides)
{
	FPostProcessSettings Settings;
	Settings.bOverride_BloomIntensity = true;
	Settings.BloomIntensity = 7.0f;
	Settings.SetBaseValues();
	EXPECT_EQ(0.675f, Settings.BloomIntensity);
	EXPECT_FALSE(Settings.bOverride_BloomIntensity);
}

TEST(SettingFields, NamesAreUnique)
{
	std::set<std::string> Names;
	for (const FSettingField& Each : GetSettingFields())
	{
		EXPECT_TRUE(Names.insert(Each.Name).second) << Each.Name;
	}
}

TEST(SettingFields, UnknownNameIsNull)
{
	EXPECT_EQ(nullptr, FindSettingField("BloomIntensty"));
	EXPECT_EQ(nullptr, FindSettingField("bloomintensity"));
}

TEST(SettingRange, ClampsAreInclusive)
{
	EXPECT_TRUE(Field("BloomIntensity").IsInRange({ESettingType::Float, {0.0}}));
	EXPECT_FALSE(Field("BloomIntensity").IsInRange({ESettingType::Float, {-0.001}}));
	EXPECT_TRUE(Field("VignetteIntensity").IsInRange({ESettingType::Float, {1.0}}));
	EXPECT_FALSE(Field("VignetteIntensity").IsInRange({ESettingType::Float, {1.001}}));
}

TEST(SettingRange, NaNIsOutside)
{
	EXPECT_FALSE(Field("VignetteIntensity").IsInRange({ESettingType::Float, {std::nan("")}}));
}

TEST(SettingBlend, LerpGoesHalfwayAtHalfWeight)
{
	EXPECT_EQ(2.0f, Blend("BloomIntensity", 1.0f, 3.0f, 0.5f));
}

TEST(SettingBlend, WeightOneAssignsExactly)
{
	// 1e8 + 1 * (0.1 - 1e8) is 0 in float.
	EXPECT_EQ(0.1f, Blend("BloomIntensity", 1e8f, 0.1f, 1.0f));
}

TEST(SettingBlend, WeightZeroAndNaNDoNothing)
{
	EXPECT_EQ(1.0f, Blend("BloomIntensity", 1.0f, 3.0f, 0.0f));
	EXPECT_EQ(1.0f, Blend("BloomIntensity", 1.0f, 3.0f, std::nanf("")));
}

TEST(SettingBlend, SetActsAtAnyWeight)
{
	FPostProcessSettings Target;
	FPostProcessSettings Source;
	Source.BloomMethod = BM_FFT;
	Field("BloomMethod").BlendFrom(Target, Source, 0.001f);
	EXPECT_EQ(BM_FFT, Target.BloomMethod);
}

TEST(SettingBlend, SetIfNonZeroKeepsTheOldForZero)
{
	EXPECT_EQ(0.25f, Blend("BloomConvolutionBufferScale", 0.5f, 0.25f, 0.1f));
	EXPECT_EQ(0.5f, Blend("BloomConvolutionBufferScale", 0.5f, 0.0f, 1.0f));
}

TEST(SettingBlend, ColoursBlendByComponent)
{
	FPostProcessSettings Target;
	FPostProcessSettings Source;
	Target.SceneColorTint = FLinearColor(0.0f, 1.0f, 2.0f, 1.0f);
	Source.SceneColorTint = FLinearColor(4.0f, 1.0f, 0.0f, 0.0f);
	Field("SceneColorTint").BlendFrom(Target, Source, 0.25f);
	EXPECT_EQ(FLinearColor(1.0f, 1.0f, 1.5f, 0.75f), Target.SceneColorTint);
}

TEST(SettingBlend, FarEndsDoNotOverflow)
{
	// The difference of the ends is no float: 3e38 - -3e38.
	EXPECT_EQ(0.0f, Blend("AutoExposureBias", -3e38f, 3e38f, 0.5f));
}

RC_GTEST_PROP(SettingBlend, LerpStaysBetweenItsEnds, ())
{
	const float Base = *rc::gen::inRange(-1000, 1000) / 8.0f;
	const float Volume = *rc::gen::inRange(-1000, 1000) / 8.0f;
	const float Result = Blend("AutoExposureBias", Base, Volume, *rc::gen::inRange(0, 257) / 256.0f);
	RC_ASSERT(Result >= std::min(Base, Volume) && Result <= std::max(Base, Volume));
}

TEST(SettingText, FloatsAreShortest)
{
	EXPECT_EQ("0.675", SettingToText(Field("BloomIntensity"), Field("BloomIntensity").Default));
	EXPECT_EQ("-1", SettingToText(Field("BloomThreshold"), Field("BloomThreshold").Default));
}

TEST(SettingText, EnumsAreNames)
{
	EXPECT_EQ("BM_SOG", SettingToText(Field("BloomMethod"), Field("BloomMethod").Default));
	EXPECT_EQ("AEM_Manual", SettingToText(Field("AutoExposureMethod"), {ESettingType::Enum, {2}}));
}

TEST(SettingText, ColoursAreArrays)
{
	EXPECT_EQ("[0.138, 0.138, 0.138, 1]", SettingToText(Field("Bloom2Tint"), Field("Bloom2Tint").Default));
}

RC_GTEST_PROP(SettingText, AnyFiniteFloatReadsBack, (uint32_t Bits))
{
	float Number;
	std::memcpy(&Number, &Bits, sizeof(Number));
	RC_PRE(std::isfinite(Number));
	const FSettingValue Value{ESettingType::Float, {Number}};
	RC_ASSERT(FromText("BloomIntensity", SettingToText(Field("BloomIntensity"), Value)).Components[0] ==
			  static_cast<double>(Number));
}

TEST(SettingText, NumberIsRoundedToTheFieldsType)
{
	EXPECT_EQ(static_cast<double>(0.1f), FromText("BloomIntensity", " 0.1 ").Components[0]);
	EXPECT_EQ(0.1, FromText("BloomConvolutionCenterUV", "[0.1, 0]").Components[0]);
}

TEST(SettingText, EnumsReadFromNamesAndNumbers)
{
	EXPECT_EQ(1.0, FromText("BloomMethod", "BM_FFT").Components[0]);
	EXPECT_EQ(2.0, FromText("AutoExposureMethod", "2").Components[0]);
	EXPECT_EQ("expected one of BM_SOG, BM_FFT", ErrorOf("BloomMethod", "BM_GAUSS"));
	ErrorOf("BloomMethod", "2");
}

TEST(SettingText, BoolsReadFromWordsAndDigits)
{
	EXPECT_EQ(0.0, FromText("AutoExposureApplyPhysicalCameraExposure", "False").Components[0]);
	EXPECT_EQ(1.0, FromText("AutoExposureApplyPhysicalCameraExposure", "1").Components[0]);
	EXPECT_EQ("expected true or false", ErrorOf("AutoExposureApplyPhysicalCameraExposure", "yes"));
}

TEST(SettingText, ColoursReadFromArraysAndTheEnginesForm)
{
	EXPECT_EQ((FSettingValue{ESettingType::Color, {1, 0.5, 0.25, 1}}), FromText("SceneColorTint", "[1, 0.5, 0.25]"));
	EXPECT_EQ(
		(FSettingValue{ESettingType::Color, {1, 0.5, 0.25, 0}}), FromText("SceneColorTint", "(R=1,G=0.5,B=0.25,A=0)"));
}

TEST(SettingText, WrongColoursAreRefused)
{
	EXPECT_EQ("expected 4 numbers such as [1, 1, 1, 1]", ErrorOf("SceneColorTint", "1, 2"));
	ErrorOf("SceneColorTint", "(G=1,R=0.5,B=0.25,A=0)");
	ErrorOf("SceneColorTint", "[1, red, 0]");
	ErrorOf("SceneColorTint", "[1, 1, 1, 1, 1]");
}

TEST(SettingText, VectorsAreDoubles)
{
	EXPECT_EQ((FSettingValue{ESettingType::Vector4, {0.1, 2, 3, 4}}), FromText("ColorGain", "(X=0.1,Y=2,Z=3,W=4)"));
	EXPECT_EQ("expected 4 numbers such as [1, 1, 1, 1]", ErrorOf("ColorGain", "[1, 2, 3]"));
}

TEST(SettingText, WholeNumbersAreWhole)
{
	EXPECT_EQ(60.0, FromText("MotionBlurTargetFPS", "60").Components[0]);
	EXPECT_EQ("expected a whole number", ErrorOf("MotionBlurTargetFPS", "29.97"));
	ErrorOf("MotionBlurTargetFPS", "3000000000");
}

TEST(SettingText, ObjectsArePaths)
{
	EXPECT_EQ("None", SettingToText(Field("BloomDirtMask"), Field("BloomDirtMask").Default));
	const FSettingValue Value = FromText("BloomDirtMask", "Texture2D'/Game/Dirt.Dirt'");
	EXPECT_EQ("/Game/Dirt.Dirt", SettingToText(Field("BloomDirtMask"), Value));
	EXPECT_EQ(nullptr, FromText("BloomDirtMask", "None").Object);
	EXPECT_EQ("expected a path such as /Game/Folder/Name.Name, or None", ErrorOf("BloomDirtMask", ""));
}

TEST(SettingText, FlareTintsAreColoursInBrackets)
{
	const FSettingValue Value = FromText(
		"LensFlareTints", "[[1,2,3],[1,1,1,1],[1,1,1,1],[1,1,1,1],[1,1,1,1],[1,1,1,1],[1,1,1,1],(R=5,G=6,B=7,A=8)]");
	EXPECT_EQ(1.0, Value.Components[3]);
	EXPECT_EQ(8.0, Value.Components[31]);
	EXPECT_EQ("expected 8 colours such as [1, 1, 1, 1], in brackets", ErrorOf("LensFlareTints", "[[1,2,3,4]]"));
	ErrorOf("LensFlareTints", "[1,2,3,4,5,6,7,8]");
}

TEST(SettingText, JsonQuotesNamesAndPaths)
{
	EXPECT_EQ("\"BM_SOG\"", SettingToJson(Field("BloomMethod"), Field("BloomMethod").Default));
	EXPECT_EQ("null", SettingToJson(Field("BloomDirtMask"), Field("BloomDirtMask").Default));
	EXPECT_EQ("\"/Game/A\\\"B\"", SettingToJson(Field("BloomDirtMask"), FromText("BloomDirtMask", "/Game/A\"B")));
	EXPECT_EQ("0.675", SettingToJson(Field("BloomIntensity"), Field("BloomIntensity").Default));
}

TEST(SettingText, WrongNumbersAreRefused)
{
	EXPECT_EQ("expected a number", ErrorOf("BloomIntensity", "1.2f"));
	for (const char* Text : {"", "nan", "inf", "1e999", "1e39", "1,5", "0x10"})
	{
		ErrorOf("BloomIntensity", Text);
	}
}
