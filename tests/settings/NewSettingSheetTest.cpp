// The plan of an engine patch for a setting. Expected places: the toon-bloom article and the engine's rules for
// settings.
#include <gtest/gtest.h>

#include "NewSettingSheet.h"

#include <algorithm>

using namespace Drydock;

namespace
{

std::vector<FSettingPlace> PlanOf(const char* Name)
{
	return MakeSettingPlan({DescribeNewSetting(*FindSettingField(Name))});
}

/** "file name: first line" of every place. */
std::vector<std::string> Summary(const std::vector<FSettingPlace>& Places)
{
	std::vector<std::string> Lines;
	for (const FSettingPlace& Place : Places)
	{
		const std::string& Text = Place.Text;
		const size_t Begin = Text.rfind('\n') == std::string::npos ? 0 : Text.rfind('\n') + 1;
		Lines.push_back(Place.File.substr(Place.File.rfind('/') + 1) + ": " + Text.substr(Begin));
	}
	return Lines;
}

/** The text of the one place of this file whose Where contains this. */
std::string TextAt(const std::vector<FSettingPlace>& Places, const std::string& File, const std::string& Where)
{
	for (const FSettingPlace& Place : Places)
	{
		if (Place.File.find(File) != std::string::npos && Place.Where.find(Where) != std::string::npos)
		{
			return Place.Text;
		}
	}
	return "";
}

FNewSetting Make(const std::string& Name, const std::string& Type, const std::string& Default)
{
	std::string Error;
	const std::optional<FNewSetting> Setting = MakeNewSetting(Name, Type, Default, Error);
	EXPECT_EQ("", Error);
	return Setting.value();
}

std::string ErrorOf(const std::string& Name, const std::string& Type, const std::string& Default)
{
	std::string Error;
	EXPECT_FALSE(MakeNewSetting(Name, Type, Default, Error));
	return Error;
}

} // namespace

TEST(SettingPlan, ToonBloomTouchesTheArticlesPlacesInEngineOrder)
{
	EXPECT_EQ(
		(std::vector<std::string>{
			"Scene.h: uint8 bOverride_BloomToonIntensity:1;",
			"Scene.h: float BloomToonIntensity;",
			"Scene.h: float ToonIntensity;",
			"Scene.cpp: ToonIntensity = 0.675f;",
			"Scene.cpp: OutPostProcessSettings->BloomToonIntensity = ToonIntensity;",
			"Scene.cpp: BloomToonIntensity = 0.675f;",
			"Scene.cpp: BloomToonIntensity = 1.0f;",
			"SceneView.cpp: LERP_PP(BloomToonIntensity);",
			"SceneView.cpp: FinalPostProcessSettings.BloomToonIntensity = 0.0f;",
			"SceneView.cpp: FinalPostProcessSettings.BloomToonIntensity = 0.0f;",
			"SceneView.cpp: FinalPostProcessSettings.BloomToonIntensity = 0.0f;",
			"PostProcessBloomSetup.h: float ToonIntensity = 0;",
			"PostProcessBloomSetup.cpp: SHADER_PARAMETER(float, ToonIntensity)",
			"PostProcessBloomSetup.cpp: Parameters.ToonIntensity = Inputs.ToonIntensity;",
			"PostProcessing.cpp: || View.FinalPostProcessSettings.BloomToonIntensity != 1.0f",
			"PostProcessing.cpp: SetupPassInputs.ToonIntensity = View.FinalPostProcessSettings.BloomToonIntensity;",
			"PostProcessBloom.usf: #include \"DeferredShadingCommon.ush\"",
			"PostProcessBloom.usf: }",
			"PostProcessBloom.usf: OutColor.rgb *= GetToonIntensity(UV);",
			"PostProcessBloom.usf: OutColor.rgb *= GetToonIntensity(UV);",
		}),
		Summary(PlanOf("BloomToonIntensity")));
}

TEST(SettingPlan, BloomsSwitchesLeaveTheIntensityOfConvolutionAlone)
{
	const std::vector<FSettingPlace> Plan = PlanOf("BloomConvolutionIntensity");
	EXPECT_EQ("", TextAt(Plan, "SceneView.cpp", "r.DefaultFeature.Bloom"));
	EXPECT_EQ("", TextAt(Plan, "SceneView.cpp", "ShowFlag.Bloom"));
	EXPECT_EQ("", TextAt(Plan, "Scene.cpp", "PostSerialize"));
	EXPECT_NE("", TextAt(PlanOf("BloomIntensity"), "SceneView.cpp", "ShowFlag.Bloom"));
}

TEST(SettingPlan, ToonBloomBringsTheSceneTexturesFromTheCallToTheBranch)
{
	const std::vector<FSettingPlace> Plan = PlanOf("BloomToonIntensity");
	const auto First = [&](const char* File, const char* Where)
	{
		const std::string Text = TextAt(Plan, File, Where);
		return Text.substr(0, Text.find('\n'));
	};
	EXPECT_EQ("TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures = nullptr;",
		First("PostProcessBloomSetup.h", "FBloomSetupInputs"));
	EXPECT_EQ("SHADER_PARAMETER_RDG_UNIFORM_BUFFER(FSceneTextureUniformParameters, SceneTextures)",
		First("PostProcessBloomSetup.cpp", "FBloomSetupParameters"));
	EXPECT_EQ("Parameters.SceneTextures = Inputs.SceneTextures;", First("PostProcessBloomSetup.cpp", "are filled"));
	EXPECT_EQ("SetupPassInputs.SceneTextures = Inputs.SceneTextures;",
		First("PostProcessing.cpp", "SetupPassInputs are filled"));
	const std::vector<FSettingPlace> Printed =
		MakeSettingPlan({DescribeNewSetting(*FindSettingField("BloomToonIntensity"))}, ESettingPlanForm::Printed);
	EXPECT_NE(std::string::npos,
		TextAt(Printed, "PostProcessBloom.usf", "a function")
			.find("GetScreenSpaceData(UV).GBuffer.ShadingModelID == SHADINGMODELID_CLOTH ? ToonIntensity : 1.0f"));
	const std::string Corrected = TextAt(Plan, "PostProcessBloom.usf", "a function");
	EXPECT_NE(std::string::npos, Corrected.find("bMarked ? Color * ToonIntensity : Color;"));
	EXPECT_EQ(std::string::npos, Corrected.find("GetScreenSpaceData(UV)"));
	EXPECT_EQ("OutColor.rgb *= GetToonIntensity(UV);", TextAt(Plan, "PostProcessBloom.usf", "BloomSetupPS, "));
	EXPECT_EQ("OutColor.rgb *= GetToonIntensity(UV);", TextAt(Plan, "PostProcessBloom.usf", "BloomSetupCS, "));
}

TEST(SettingPlan, NewStrengthsOfBloomAreMaskedAndTheEnginesOwnAreNot)
{
	const std::string Text = FormatSettingPlan({Make("BloomHairIntensity", "float", "1")});
	for (const char* Line : {"HairIntensity = 0;", "SHADER_PARAMETER(float, HairIntensity)", "float HairIntensity;",
			 "OutColor.rgb *= GetHairIntensity(UV);", "SceneTextures = Inputs.SceneTextures;"})
	{
		EXPECT_NE(std::string::npos, Text.find(Line)) << Line << " is not in\n" << Text;
	}
	EXPECT_EQ(std::string::npos, Text.find("Toon"));
	EXPECT_EQ("int Method;", TextAt(PlanOf("BloomMethod"), "PostProcessBloom.usf", "globals"));
	for (const char* Name : {"BloomIntensity", "BloomThreshold", "Bloom1Size", "VignetteIntensity"})
	{
		EXPECT_EQ(
			std::string::npos, FormatSettingPlan({DescribeNewSetting(*FindSettingField(Name))}).find("SceneTextures"))
			<< Name;
	}
}

TEST(SettingPlan, SeveralSettingsShareTheirPlaces)
{
	const FNewSetting Toon = DescribeNewSetting(*FindSettingField("BloomToonIntensity"));
	const FNewSetting Hair = Make("BloomHairIntensity", "float", "1");
	const FNewSetting Tint = Make("DuskTint", "color", "1,1,1");
	const std::vector<FSettingPlace> Plan = MakeSettingPlan({Toon, Hair});
	EXPECT_EQ(MakeSettingPlan({Toon}).size(), Plan.size());
	EXPECT_EQ("LERP_PP(BloomToonIntensity);\nLERP_PP(BloomHairIntensity);",
		TextAt(Plan, "SceneView.cpp", "OverridePostProcessSettings"));
	EXPECT_EQ(
		"TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures = nullptr;\nfloat ToonIntensity = 0;\n"
		"float HairIntensity = 0;",
		TextAt(Plan, "PostProcessBloomSetup.h", "FBloomSetupInputs"));

	// The pass of the tint has a place in PostProcessing.cpp too: the files stand together all the same.
	std::vector<std::string> Files;
	for (const FSettingPlace& Place : MakeSettingPlan({Toon, Tint}))
	{
		if (Files.empty() || Files.back() != Place.File)
		{
			EXPECT_EQ(0, std::count(Files.begin(), Files.end(), Place.File)) << Place.File;
			Files.push_back(Place.File);
		}
	}
	EXPECT_EQ(10u, Files.size()); // three of the settings, four of the bloom setup and its chain, three of the new pass
}

TEST(SettingPlan, TheThreeSwitchesOfBloomAreNamed)
{
	const std::vector<FSettingPlace> Plan = PlanOf("BloomToonIntensity");
	for (const char* Switch : {"r.DefaultFeature.Bloom", "r.BloomQuality", "ShowFlag.Bloom"})
	{
		EXPECT_NE("", TextAt(Plan, "SceneView.cpp", Switch)) << Switch;
	}
}

TEST(SettingPlan, DeclarationHasTheTablesRangeCategoryAndBit)
{
	const std::string Text = TextAt(PlanOf("BloomToonIntensity"), "Scene.h", "among the values");
	for (const char* Part : {"Category=\"Lens|Bloom\"", "ClampMin = \"0.0\"", "UIMax = \"8.0\"",
			 "editcondition = \"bOverride_BloomToonIntensity\"", "DisplayName = \"Bloom Toon Intensity\""})
	{
		EXPECT_NE(std::string::npos, Text.find(Part)) << Part << " in " << Text;
	}
}

TEST(SettingPlan, SizesAndTintsAreNotSwitchedOff)
{
	EXPECT_EQ("", TextAt(PlanOf("Bloom1Size"), "SceneView.cpp", "r.BloomQuality"));
	EXPECT_EQ("float Filter1Size;",
		TextAt(PlanOf("Bloom1Size"), "Scene.h", "FGaussianSumBloomSettings")
			.substr(TextAt(PlanOf("Bloom1Size"), "Scene.h", "FGaussianSumBloomSettings").rfind('\n') + 1));
}

TEST(SettingPlan, BlendRulesAreTheTables)
{
	const auto Blending = [](const char* Name)
	{
		return TextAt(PlanOf(Name), "SceneView.cpp", "OverridePostProcessSettings");
	};
	EXPECT_EQ("LERP_PP(BloomIntensity);", Blending("BloomIntensity"));
	EXPECT_EQ("SET_PP(BloomMethod);", Blending("BloomMethod"));
	EXPECT_EQ("IF_PP(BloomDirtMask);", Blending("BloomDirtMask"));
	EXPECT_NE(std::string::npos, Blending("DepthOfFieldFocalDistance").find("== 0.0f"));
	EXPECT_NE(std::string::npos, Blending("LensFlareTints").find("Index < 8"));
}

TEST(SettingPlan, TypesAreTheEngines)
{
	const auto Declaration = [](const char* Name)
	{
		const std::string Text = TextAt(PlanOf(Name), "Scene.h", "among the values");
		return Text.substr(Text.rfind('\n') + 1);
	};
	EXPECT_EQ("FLinearColor Bloom1Tint;", Declaration("Bloom1Tint"));
	EXPECT_EQ("FVector4 ColorGain;", Declaration("ColorGain"));
	EXPECT_EQ("int32 DepthOfFieldBladeCount;", Declaration("DepthOfFieldBladeCount"));
	EXPECT_EQ("TObjectPtr<class UTexture> BloomDirtMask;", Declaration("BloomDirtMask"));
	EXPECT_EQ("FLinearColor LensFlareTints[8];", Declaration("LensFlareTints"));
}

TEST(SettingPlan, DefaultsAreCpp)
{
	const auto Default = [](const char* Name)
	{
		return TextAt(PlanOf(Name), "Scene.cpp", "FPostProcessSettings::FPostProcessSettings");
	};
	EXPECT_EQ("Bloom2Tint = FLinearColor(0.138f, 0.138f, 0.138f, 1.0f);", Default("Bloom2Tint"));
	EXPECT_EQ("BloomConvolutionCenterUV = FVector2D(0.5, 0.5);", Default("BloomConvolutionCenterUV"));
	EXPECT_EQ("BloomMethod = BM_SOG;", Default("BloomMethod"));
	EXPECT_EQ("BloomDirtMask = nullptr;", Default("BloomDirtMask"));
	EXPECT_EQ("AutoExposureApplyPhysicalCameraExposure = true;", Default("AutoExposureApplyPhysicalCameraExposure"));
	EXPECT_EQ("BloomThreshold = -1.0f;", Default("BloomThreshold"));
}

class SettingPlanOfField : public testing::TestWithParam<size_t>
{
};

TEST(SettingPlan, DescriptionIsWithoutTheProjectsRemark)
{
	EXPECT_EQ(0u, TextAt(PlanOf("BloomToonIntensity"), "Scene.h", "among the values").find("/** Multiplies "));
}

TEST_P(SettingPlanOfField, NamesFieldAndBitInEveryStage)
{
	const FSettingField& Field = GetSettingFields()[GetParam()];
	const std::string Text = FormatSettingPlan({DescribeNewSetting(Field)});
	for (const char* File : {"Scene.h", "Scene.cpp", "SceneView.cpp", "PostProcessing.cpp", ".usf"})
	{
		EXPECT_NE(std::string::npos, Text.find(File)) << File;
	}
	EXPECT_NE(std::string::npos, Text.find(std::string(Field.OverrideName) + ":1;"));
}

INSTANTIATE_TEST_SUITE_P(Table, SettingPlanOfField, testing::Range<size_t>(0, GetSettingFields().size()),
	[](const testing::TestParamInfo<size_t>& Info) { return std::string(GetSettingFields()[Info.param].Name); });

TEST(NewSetting, IsOneLineOfTheTable)
{
	EXPECT_EQ("DRYDOCK_SETTING(float, BloomSparkle, 0.5f, Anything, \"\", \"Lens|Bloom\", Lerp, \"Effect of "
			  "BloomSparkle.\")",
		MakeTableLine(Make("BloomSparkle", "float", "0.5")));
	EXPECT_NE(std::string::npos,
		FormatSettingPlan({Make("BloomSparkle", "float", "0.5")}).find("PostProcessSettingsTable.h"));
}

TEST(NewSetting, LineOfATablesFieldIsTheTables)
{
	EXPECT_EQ(
		"DRYDOCK_SETTING(float, BloomSizeScale, 4.0f, AtLeast(0, 64), \"\", \"Lens|Bloom\", Lerp, \"Multiplies all "
		"bloom sizes.\")",
		MakeTableLine(DescribeNewSetting(*FindSettingField("BloomSizeScale"))));
}

TEST(NewSetting, TypesHaveShortNamesAndDefaults)
{
	EXPECT_EQ("FLinearColor(1.0f, 0.5f, 0.0f, 1.0f)", Make("GlowTint", "color", "1,0.5,0").Default);
	EXPECT_EQ("FVector4(0.0, 0.0, 0.0, 0.0)", Make("GlowRange", "vector4", "").Default);
	EXPECT_EQ("true", Make("bGlow", "bool", "true").Default);
	EXPECT_EQ("int32", Make("GlowSteps", "int", "3").Type);
	EXPECT_EQ(ESettingBlend::Set, Make("GlowSteps", "int", "3").Blend);
}

TEST(NewSetting, MistakesAreAnswered)
{
	EXPECT_EQ(
		"there is no type real; there are float, bool, int, color, vector2, vector4", ErrorOf("Glow", "real", "0"));
	EXPECT_EQ("the default high is not of type float: expected a number", ErrorOf("Glow", "float", "high"));
	EXPECT_EQ("\"2Glow\" is not a name: use letters, digits and underscores, and no digit first",
		ErrorOf("2Glow", "float", "0"));
}
