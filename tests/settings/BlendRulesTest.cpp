// Rules of blending, one by one: those of the engine, by hand, and what must hold for all inputs. A little past 500
// lines: rules and properties share their volumes and generators.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "BlendTesting.h"
#include "SettingObjects.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

using namespace Drydock;

namespace
{

FPostProcessSettings Scale(double Value)
{
	return Give({{"BloomSizeScale", Value}});
}

FPostProcessSettings Table(const char* Path, double Intensity)
{
	FPostProcessSettings Settings = Give({{"ColorGradingIntensity", Intensity}});
	Settings.bOverride_ColorGradingLUT = true;
	Settings.ColorGradingLUT = FindOrAddTexture(Path);
	return Settings;
}

FPostProcessSettings Cubemap(const char* Path, double Intensity)
{
	FPostProcessSettings Settings = Give({{"AmbientCubemapIntensity", Intensity}});
	Settings.bOverride_AmbientCubemap = true;
	Settings.AmbientCubemap = FindOrAddTextureCube(Path);
	return Settings;
}

float GenerateNumber()
{
	return static_cast<float>(*rc::gen::inRange(-8000, 8001)) / 8.0f;
}

float GenerateWeight()
{
	return static_cast<float>(*rc::gen::inRange(0, 257)) / 256.0f;
}

/** Up to eight unbound volumes of priorities 0, 1, 2, ..., each with some fields. */
std::vector<APostProcessVolume> GenerateVolumes()
{
	std::vector<APostProcessVolume> Volumes;
	const int Num = *rc::gen::inRange(0, 9);
	for (int Index = 0; Index < Num; ++Index)
	{
		APostProcessVolume Volume = Unbound(static_cast<float>(Index), GenerateWeight(), {});
		for (const char* Name : {"BloomSizeScale", "AutoExposureBias", "SceneColorTint", "MotionBlurTargetFPS"})
		{
			const FSettingField& Field = *FindSettingField(Name);
			FSettingValue Value = Field.Default;
			for (int32 Component = 0; Component < Field.GetNumComponents(); ++Component)
			{
				Value.Components[Component] =
					Field.Type == ESettingType::Int ? *rc::gen::inRange(0, 120) : static_cast<double>(GenerateNumber());
			}
			Field.Set(Volume.Settings, Value);
			Field.SetOverridden(Volume.Settings, *rc::gen::inRange(0, 3) > 0);
		}
		Volumes.push_back(Volume);
	}
	return Volumes;
}

bool HaveSameValues(const FPostProcessSettings& A, const FPostProcessSettings& B)
{
	return std::all_of(GetSettingFields().begin(), GetSettingFields().end(),
		[&](const FSettingField& Field)
		{ return Field.Get(A) == Field.Get(B) && Field.IsOverridden(A) == Field.IsOverridden(B); });
}

/** Of a value's numbers: the bits, so that -0 and 0 differ. */
bool IsSameFloat(float A, float B)
{
	return std::memcmp(&A, &B, sizeof(A)) == 0;
}

} // namespace

TEST(BlendRules, NothingInsideGivesTheDefaults)
{
	const FFinalPostProcessSettings Settings = Blended({});
	EXPECT_EQ(0.675f, Settings.BloomIntensity);
	EXPECT_EQ(4.0f, Settings.BloomSizeScale);
	EXPECT_FALSE(Settings.bOverride_BloomIntensity);
}

TEST(BlendRules, E1HighestPriorityWinsWhateverTheOrder)
{
	EXPECT_EQ(16.0f, Blended({Unbound(2, 1, Scale(16)), Unbound(1, 1, Scale(8))}).BloomSizeScale);
	EXPECT_EQ(16.0f, Blended({Unbound(1, 1, Scale(8)), Unbound(2, 1, Scale(16))}).BloomSizeScale);
}

TEST(BlendRules, E1PrioritiesMayBeNegativeOrFractional)
{
	EXPECT_EQ(16.0f, Blended({Unbound(-0.25f, 1, Scale(16)), Unbound(-0.5f, 1, Scale(8))}).BloomSizeScale);
	EXPECT_EQ(8.0f, Blended({Unbound(-1e9f, 1, Scale(16)), Unbound(1e-9f, 1, Scale(8))}).BloomSizeScale);
}

TEST(BlendRules, E1PriorityThatIsNaNIsZero)
{
	const std::vector<APostProcessVolume> Volumes = {
		Unbound(1, 1, Scale(16)), Unbound(std::nanf(""), 1, Scale(8)), Unbound(-1, 1, Scale(2))};
	EXPECT_EQ(16.0f, Blended(Volumes).BloomSizeScale);
	EXPECT_EQ(8.0f, Blended({Volumes[1], Volumes[2]}).BloomSizeScale);
}

TEST(BlendRules, E1TieOfDisagreeingVolumesIsReported)
{
	const FBlendedSettings Result =
		BlendAt(Inputs({Unbound(3, 0.5f, Give({{"BloomSizeScale", 8}, {"BloomThreshold", 1}})),
			Unbound(3, 0.5f, Give({{"BloomSizeScale", 16}, {"BloomThreshold", 1}}))}));
	ASSERT_EQ(1u, Result.Ties.size());
	EXPECT_EQ(0u, Result.Ties[0].First);
	EXPECT_EQ(1u, Result.Ties[0].Second);
	EXPECT_EQ(std::vector<std::string>{"BloomSizeScale"}, Result.Ties[0].Settings);
}

TEST(BlendRules, E1NoTieWhereOneOfThemDoesNotReach)
{
	const FVolumeShape Sphere = FVolumeShape::MakeSphere(FVector(0, 0, 0), 10);
	const FBlendInputs Scene = Inputs({Unbound(0, 1, Scale(8)), Bounded(0, Sphere, 100, Scale(16))});
	EXPECT_EQ(1u, BlendAt(Scene, FVector(50, 0, 0)).Ties.size());
	EXPECT_EQ(0u, BlendAt(Scene, FVector(500, 0, 0)).Ties.size());
}

TEST(BlendRules, E1NoTieWhereSomethingCoversBoth)
{
	std::vector<APostProcessVolume> Volumes = {
		Unbound(0, 1, Scale(8)), Unbound(0, 1, Scale(16)), Unbound(1, 1, Scale(2))};
	EXPECT_EQ(0u, BlendAt(Inputs(Volumes)).Ties.size());
	Volumes[2].BlendWeight = 0.5f;
	EXPECT_EQ(1u, BlendAt(Inputs(Volumes)).Ties.size());
	FBlendInputs Scene = Inputs(Volumes);
	Scene.CommandLine = Scale(1);
	EXPECT_EQ(0u, BlendAt(Scene).Ties.size());
}

TEST(BlendRules, E1NoTieWherePrioritiesDiffer)
{
	EXPECT_EQ(0u, BlendAt(Inputs({Unbound(0, 1, Scale(8)), Unbound(0.5f, 1, Scale(16))})).Ties.size());
}

TEST(BlendRules, E1TiesOfThreeNameThePairs)
{
	// The second agrees with the first, the third does not.
	const FBlendedSettings Result =
		BlendAt(Inputs({Unbound(0, 0.5f, Scale(8)), Unbound(0, 0.5f, Scale(8)), Unbound(0, 0.5f, Scale(16))}));
	ASSERT_EQ(1u, Result.Ties.size());
	EXPECT_EQ(0u, Result.Ties[0].First);
	EXPECT_EQ(2u, Result.Ties[0].Second);
}

TEST(BlendRules, E6FieldsWithoutOverrideBitDoNotMove)
{
	FPostProcessSettings Settings = Scale(8);
	Settings.BloomIntensity = 100.0f;
	EXPECT_EQ(0.675f, Blended({Unbound(0, 1, Settings)}).BloomIntensity);
}

TEST(BlendRules, E6NumbersColoursAndVectorsLerp)
{
	const FPostProcessSettings Settings =
		Give({{"BloomSizeScale", 8}, {"SceneColorTint", 0}, {"BloomConvolutionCenterUV", 1}, {"ColorSaturation", 3}});
	const FFinalPostProcessSettings Result = Blended({Unbound(0, 0.25f, Settings)});
	EXPECT_EQ(5.0f, Result.BloomSizeScale);
	EXPECT_EQ(FLinearColor(0.75f, 0.75f, 0.75f, 0.75f), Result.SceneColorTint);
	EXPECT_EQ(FVector2D(0.625, 0.625), Result.BloomConvolutionCenterUV);
	EXPECT_EQ(FVector4(1.5, 1.5, 1.5, 1.5), Result.ColorSaturation);
}

TEST(BlendRules, E6FlareTintsLerp)
{
	const FFinalPostProcessSettings Result = Blended({Unbound(0, 0.5f, Give({{"LensFlareTints", 0}}))});
	const FPostProcessSettings Defaults;
	EXPECT_EQ(0.5f * Defaults.LensFlareTints[0].R, Result.LensFlareTints[0].R);
	EXPECT_EQ(0.5f * Defaults.LensFlareTints[7].A, Result.LensFlareTints[7].A);
}

TEST(BlendRules, E6EnumsBoolsAndWholeNumbersReplaceAtAnyWeight)
{
	const FPostProcessSettings Settings = Give({{"BloomMethod", BM_FFT}, {"AutoExposureApplyPhysicalCameraExposure", 0},
		{"MotionBlurTargetFPS", 60}, {"DepthOfFieldBladeCount", 8}});
	const FFinalPostProcessSettings Result = Blended({Unbound(0, 1e-6f, Settings)});
	EXPECT_EQ(BM_FFT, Result.BloomMethod);
	EXPECT_FALSE(Result.AutoExposureApplyPhysicalCameraExposure);
	EXPECT_EQ(60, Result.MotionBlurTargetFPS);
	EXPECT_EQ(8, Result.DepthOfFieldBladeCount);
}

TEST(BlendRules, E6NullTextureReplacesNothing)
{
	FPostProcessSettings Dirt;
	Dirt.bOverride_BloomDirtMask = true;
	Dirt.BloomDirtMask = FindOrAddTexture("/Game/Dirt.Dirt");
	FPostProcessSettings None;
	None.bOverride_BloomDirtMask = true;
	EXPECT_EQ(FindOrAddTexture("/Game/Dirt.Dirt"),
		Blended({Unbound(0, 0.125f, Dirt), Unbound(1, 1, None)}).BloomDirtMask.Get());
}

TEST(BlendRules, E6BufferScaleIsAssignedAndZeroReplacesNothing)
{
	EXPECT_EQ(0.5f, Blended({Unbound(0, 0.125f, Give({{"BloomConvolutionBufferScale", 0.5}})),
								Unbound(1, 1, Give({{"BloomConvolutionBufferScale", 0}}))})
						.BloomConvolutionBufferScale);
}

TEST(BlendRules, E8LUTsShareAWeightOfOne)
{
	const FFinalPostProcessSettings Result =
		Blended({Unbound(0, 0.5f, Table("/Game/A", 1)), Unbound(1, 0.5f, Table("/Game/B", 0.5))});
	// None 1/2, A 1/2; then B takes 1/2 * 1/2 = 1/4 of all.
	ASSERT_EQ(3, Result.ContributingLUTs.Num());
	EXPECT_EQ(nullptr, Result.ContributingLUTs[0].LUT.Get());
	EXPECT_EQ(0.375f, Result.ContributingLUTs[0].Weight);
	EXPECT_EQ(FindOrAddTexture("/Game/A"), Result.ContributingLUTs[1].LUT.Get());
	EXPECT_EQ(0.375f, Result.ContributingLUTs[1].Weight);
	EXPECT_EQ(0.25f, Result.ContributingLUTs[2].Weight);
}

TEST(BlendRules, E8SameLUTIsOneEntry)
{
	const FFinalPostProcessSettings Result =
		Blended({Unbound(0, 0.5f, Table("/Game/A", 1)), Unbound(1, 0.5f, Table("/Game/A", 1))});
	ASSERT_EQ(2, Result.ContributingLUTs.Num());
	EXPECT_EQ(0.75f, Result.ContributingLUTs[1].Weight);
}

TEST(BlendRules, E8FullLUTLeavesNoOther)
{
	const FFinalPostProcessSettings Result =
		Blended({Unbound(0, 0.5f, Table("/Game/A", 1)), Unbound(1, 1, Table("/Game/B", 1))});
	ASSERT_EQ(1, Result.ContributingLUTs.Num());
	EXPECT_EQ(FindOrAddTexture("/Game/B"), Result.ContributingLUTs[0].LUT.Get());
	EXPECT_EQ(1.0f, Result.ContributingLUTs[0].Weight);
}

TEST(BlendRules, E8LUTIntensityIsClamped)
{
	EXPECT_EQ(0.5f, Blended({Unbound(0, 0.5f, Table("/Game/A", 7))}).ContributingLUTs[1].Weight);
	EXPECT_EQ(1, Blended({Unbound(0, 0.5f, Table("/Game/A", -7))}).ContributingLUTs.Num());
}

TEST(BlendRules, E8WithoutLUTThereIsTheNeutralOne)
{
	const FFinalPostProcessSettings Result = Blended({});
	ASSERT_EQ(1, Result.ContributingLUTs.Num());
	EXPECT_EQ(nullptr, Result.ContributingLUTs[0].LUT.Get());
	EXPECT_EQ(1.0f, Result.ContributingLUTs[0].Weight);
}

TEST(BlendRules, E8CubemapsAddUp)
{
	const FFinalPostProcessSettings Result = Blended({Unbound(0, 0.5f, Cubemap("/Game/Sky", 2)),
		Unbound(1, 1, Cubemap("/Game/Room", 0.5)), Unbound(2, 0.25f, Cubemap("/Game/Sky", 4))});
	// Sky 1/2 * 2 + 1/4 * 4, Room 1/2.
	ASSERT_EQ(2, Result.ContributingCubemaps.Num());
	EXPECT_EQ(2.0f, Result.ContributingCubemaps[0].AmbientCubemapTintMulScaleValue.R);
	EXPECT_EQ(0.5f, Result.ContributingCubemaps[1].AmbientCubemapTintMulScaleValue.G);
}

TEST(BlendRules, E8CubemapIsTinted)
{
	FPostProcessSettings Settings = Cubemap("/Game/Sky", 2);
	Settings.bOverride_AmbientCubemapTint = true;
	Settings.AmbientCubemapTint = FLinearColor(1.0f, 0.5f, 0.25f, 1.0f);
	const FLinearColor Color =
		Blended({Unbound(0, 0.5f, Settings)}).ContributingCubemaps[0].AmbientCubemapTintMulScaleValue;
	EXPECT_EQ(FLinearColor(1.0f, 0.5f, 0.25f, 1.0f), Color);
}

TEST(BlendRules, E9BlendablesKeepTheirOrderAndMultiplyWeights)
{
	FPostProcessSettings First;
	First.WeightedBlendables.Array.Add(FWeightedBlendable(5.0f, FindOrAddObject("/Game/A")));
	First.WeightedBlendables.Array.Add(FWeightedBlendable(0.0f, FindOrAddObject("/Game/Off")));
	First.WeightedBlendables.Array.Add(FWeightedBlendable(0.5f, FindOrAddObject("/Game/B")));
	FPostProcessSettings Second;
	Second.WeightedBlendables.Array.Add(FWeightedBlendable(1.0f, FindOrAddObject("/Game/A")));
	const FFinalPostProcessSettings Result = Blended({Unbound(1, 1, Second), Unbound(0, 0.5f, First)});
	const TArray<FWeightedBlendable>& Blendables = Result.BlendableManager.Blendables;
	// min(1, 5) * 1/2, then 1/2 * 1/2, then 1 * 1.
	ASSERT_EQ(3, Blendables.Num());
	EXPECT_EQ(FWeightedBlendable(0.5f, FindOrAddObject("/Game/A")), Blendables[0]);
	EXPECT_EQ(FWeightedBlendable(0.25f, FindOrAddObject("/Game/B")), Blendables[1]);
	EXPECT_EQ(FWeightedBlendable(1.0f, FindOrAddObject("/Game/A")), Blendables[2]);
}

TEST(BlendRules, E10CommandLineComesAfterTheCamera)
{
	FBlendInputs Scene = Inputs({Unbound(0, 1, Scale(8))});
	Scene.Camera = Scale(16);
	Scene.CommandLine = Scale(2);
	EXPECT_EQ(2.0f, BlendAt(Scene).Settings.BloomSizeScale);
}

TEST(BlendRules, E10CameraOfWeightZeroOrNaNDoesNothing)
{
	FBlendInputs Scene = Inputs({Unbound(0, 1, Scale(8))});
	Scene.Camera = Scale(16);
	for (const float Weight : {0.0f, -1.0f, std::nanf("")})
	{
		Scene.CameraWeight = Weight;
		EXPECT_EQ(8.0f, BlendAt(Scene).Settings.BloomSizeScale);
	}
	Scene.CameraWeight = 7.0f;
	EXPECT_EQ(16.0f, BlendAt(Scene).Settings.BloomSizeScale);
}

TEST(BlendRules, E11EachViewHasItsOwnBlend)
{
	const FSettingsBlender Blender(Inputs({Bounded(0, FVolumeShape::MakeSphere(FVector(0, 0, 0), 10), 10, Scale(8))}));
	EXPECT_EQ(8.0f, Blender.At(FVector(0, 0, 0)).Settings.BloomSizeScale);
	EXPECT_EQ(4.0f, Blender.At(FVector(100, 0, 0)).Settings.BloomSizeScale);
	EXPECT_EQ(8.0f, Blender.At(FVector(0, 0, 0)).Settings.BloomSizeScale);
}

TEST(BlendRules, NonFiniteValuesAreReportedWithTheirSource)
{
	const FBlendedSettings Result = BlendAt(Inputs({Unbound(7, 1, Scale(std::numeric_limits<double>::quiet_NaN()))}));
	ASSERT_EQ(1u, Result.NonFinite.size());
	EXPECT_EQ("volume of priority 7", Result.NonFinite[0].Source);
	EXPECT_EQ("BloomSizeScale", Result.NonFinite[0].Setting);
	EXPECT_EQ(4.0f, Result.Settings.BloomSizeScale);
}

TEST(BlendRules, NonFiniteValuesOfSkippedVolumesAreNot)
{
	APostProcessVolume Volume = Unbound(7, 1, Scale(std::numeric_limits<double>::infinity()));
	Volume.bEnabled = false;
	EXPECT_TRUE(BlendAt(Inputs({Volume})).NonFinite.empty());
}

TEST(BlendRules, OneNonFiniteComponentKeepsTheWholeColourOut)
{
	FPostProcessSettings Settings = Give({{"SceneColorTint", 2}});
	Settings.SceneColorTint.B = std::numeric_limits<float>::infinity();
	EXPECT_EQ(FLinearColor(1, 1, 1, 1), Blended({Unbound(0, 1, Settings)}).SceneColorTint);
}

TEST(BlendRules, EndsOfOppositeSignsDoNotOverflow)
{
	constexpr float Largest = std::numeric_limits<float>::max();
	const float Result = Blended({Unbound(0, 1, Give({{"AutoExposureBias", -Largest}})),
									 Unbound(1, 0.5f, Give({{"AutoExposureBias", Largest}}))})
							 .AutoExposureBias;
	EXPECT_EQ(0.0f, Result);
}

TEST(BlendRules, ThousandHalvesEndAtTheirValue)
{
	std::vector<APostProcessVolume> Volumes;
	for (int Index = 0; Index < 1000; ++Index)
	{
		Volumes.push_back(Unbound(static_cast<float>(Index), 0.5f, Scale(8)));
	}
	EXPECT_EQ(8.0f, Blended(Volumes).BloomSizeScale);
}

TEST(BlendRules, InputsStayAsTheyAre)
{
	const FSettingsBlender Blender(Inputs({Unbound(0, 0.5f, Scale(8))}));
	Blender.At(FVector(0, 0, 0));
	EXPECT_EQ(8.0f, Blender.GetInputs().Volumes[0].Settings.BloomSizeScale);
}

RC_GTEST_PROP(BlendRules, LerpedFieldsStayInsideTheirContributions, ())
{
	const std::vector<APostProcessVolume> Volumes = GenerateVolumes();
	float Least = 4.0f;
	float Largest = 4.0f;
	for (const APostProcessVolume& Volume : Volumes)
	{
		if (Volume.Settings.bOverride_BloomSizeScale && Volume.BlendWeight > 0.0f)
		{
			Least = std::min(Least, Volume.Settings.BloomSizeScale);
			Largest = std::max(Largest, Volume.Settings.BloomSizeScale);
		}
	}
	// From + Weight * (To - From) rounds three times.
	const float Rounding = 8.0f * 3.0f * std::max(std::fabs(Least), std::fabs(Largest)) * 6e-8f;
	const float Result = Blended(Volumes).BloomSizeScale;
	RC_ASSERT(Result >= Least - Rounding && Result <= Largest + Rounding);
}

RC_GTEST_PROP(BlendRules, SequentialLerpsAreTheClosedForm, ())
{
	// base * prod(1 - w) + sum over i of v_i * w_i * prod over later j of (1 - w_j), in double.
	const std::vector<APostProcessVolume> Volumes = GenerateVolumes();
	double Expected = 0.0;
	double Left = 1.0;
	for (auto Volume = Volumes.rbegin(); Volume != Volumes.rend(); ++Volume)
	{
		if (Volume->Settings.bOverride_AutoExposureBias)
		{
			const double Weight = static_cast<double>(Volume->BlendWeight);
			Expected += Left * Weight * static_cast<double>(Volume->Settings.AutoExposureBias);
			Left *= 1.0 - Weight;
		}
	}
	Expected += Left * 1.0;
	RC_ASSERT(std::fabs(Expected - static_cast<double>(Blended(Volumes).AutoExposureBias)) < 2e-3);
}

RC_GTEST_PROP(BlendRules, WeightZeroKeepsTheBaseBitForBit, ())
{
	std::vector<APostProcessVolume> Volumes = GenerateVolumes();
	const FFinalPostProcessSettings Base = Blended(Volumes);
	APostProcessVolume Nothing = Unbound(1000, 0.0f,
		Give({{"BloomSizeScale", GenerateNumber()}, {"SceneColorTint", GenerateNumber()}, {"MotionBlurTargetFPS", 1},
			{"BloomMethod", BM_FFT}}));
	Volumes.push_back(Nothing);
	RC_ASSERT(HaveSameValues(Base, Blended(Volumes)));
}

RC_GTEST_PROP(BlendRules, WeightOneLeavesNoResidue, ())
{
	std::vector<APostProcessVolume> Volumes = GenerateVolumes();
	const float Value = GenerateNumber() * 1.1f;
	Volumes.push_back(Unbound(1000, 1.0f, Give({{"BloomSizeScale", Value}, {"SceneColorTint", Value}})));
	const FFinalPostProcessSettings Result = Blended(Volumes);
	RC_ASSERT(IsSameFloat(Value, Result.BloomSizeScale));
	RC_ASSERT(IsSameFloat(Value, Result.SceneColorTint.G));
}

RC_GTEST_PROP(BlendRules, OrderOfDeclarationDoesNotMatterWherePrioritiesDiffer, ())
{
	std::vector<APostProcessVolume> Volumes = GenerateVolumes();
	const FFinalPostProcessSettings Base = Blended(Volumes);
	for (size_t Index = Volumes.size(); Index > 1; --Index)
	{
		std::swap(Volumes[Index - 1], Volumes[static_cast<size_t>(*rc::gen::inRange<int>(0, static_cast<int>(Index)))]);
	}
	RC_ASSERT(HaveSameValues(Base, Blended(Volumes)));
}

RC_GTEST_PROP(BlendRules, OnlyTheOrderOfPrioritiesMatters, ())
{
	std::vector<APostProcessVolume> Volumes = GenerateVolumes();
	const FFinalPostProcessSettings Base = Blended(Volumes);
	float Priority = -1e6f;
	for (APostProcessVolume& Volume : Volumes)
	{
		Priority += static_cast<float>(*rc::gen::inRange(1, 1000));
		Volume.Priority = Priority;
	}
	RC_ASSERT(HaveSameValues(Base, Blended(Volumes)));
}

RC_GTEST_PROP(BlendRules, NaNAndInfinityNeverEnter, ())
{
	std::vector<APostProcessVolume> Volumes = GenerateVolumes();
	for (APostProcessVolume& Volume : Volumes)
	{
		const auto AnyFloat = []
		{
			const uint32 Bits = *rc::gen::oneOf(rc::gen::arbitrary<uint32>(),
				rc::gen::element(0x7f800000u, 0xff800000u, 0x7fc00000u, 0x7f7fffffu, 0xff7fffffu, 0x00000001u));
			float Number;
			std::memcpy(&Number, &Bits, sizeof(Number));
			return Number;
		};
		Volume.Settings.BloomSizeScale = AnyFloat();
		Volume.Settings.SceneColorTint.R = AnyFloat();
		Volume.Settings.bOverride_ColorGradingIntensity = true;
		Volume.Settings.ColorGradingIntensity = AnyFloat();
		Volume.Settings.bOverride_AmbientCubemap = Volume.Settings.bOverride_AmbientCubemapIntensity = true;
		Volume.Settings.AmbientCubemap = FindOrAddTextureCube("/Game/Sky");
		Volume.Settings.AmbientCubemapIntensity = AnyFloat();
	}
	const FFinalPostProcessSettings Result = Blended(Volumes);
	for (const FSettingField& Field : GetSettingFields())
	{
		RC_ASSERT(Field.Get(Result).IsFinite());
	}
	for (const FFinalPostProcessSettings::FCubemapEntry& Entry : Result.ContributingCubemaps)
	{
		RC_ASSERT(std::isfinite(Entry.AmbientCubemapTintMulScaleValue.R));
	}
}

RC_GTEST_PROP(BlendRules, WeightsOfLUTsSumToOne, ())
{
	std::vector<APostProcessVolume> Volumes;
	const int Num = *rc::gen::inRange(0, 20);
	for (int Index = 0; Index < Num; ++Index)
	{
		const char* const Path = *rc::gen::element("/Game/A", "/Game/B", "/Game/C", "None");
		Volumes.push_back(
			Unbound(static_cast<float>(Index), GenerateWeight(), Table(Path, static_cast<double>(GenerateWeight()))));
	}
	float Sum = 0.0f;
	for (const FFinalPostProcessSettings::FLUTEntry& Entry : Blended(Volumes).ContributingLUTs)
	{
		Sum += Entry.Weight;
	}
	RC_ASSERT(std::fabs(Sum - 1.0f) < 1e-5f);
}

RC_GTEST_PROP(BlendRules, OverrideIsWhatTheBlenderDoes, ())
{
	// The engine's function, source by source, against the prepared blender.
	const std::vector<APostProcessVolume> Volumes = GenerateVolumes();
	FFinalPostProcessSettings Expected = StartFinalPostProcessSettings();
	for (const APostProcessVolume& Volume : Volumes)
	{
		OverridePostProcessSettings(Expected, Volume.Settings, Volume.BlendWeight);
	}
	EndFinalPostProcessSettings(Expected, FEngineShowFlags());
	RC_ASSERT(HaveSameValues(Expected, Blended(Volumes)));
}
