// The expectations of blend rules. Every rule is tried as a function from a base, a source's value and a weight to the
// numbers that come of it.
#include "CheckPass.h"

#include "settings/BlendTesting.h"

#include "Engine/PostProcessUtils.h"
#include "PostProcessVolumeWeight.h"
#include "SettingObjects.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <sstream>

namespace Stability
{

namespace
{

using Drydock::FSettingField;
using Drydock::FSettingValue;

using FNumbers = std::vector<double>;

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double Base = 0.25;

enum class EBlendForm
{
	Volumes,   // the setting, in two unbound volumes
	Table,     // weight of a colour grading table, by ColorGradingIntensity
	Cubemap,   // colour of a cubemap, by AmbientCubemapIntensity
	Blendable, // weight of a blendable
	Distance,  // weight of a volume of radius 100, by the distance
	Parts,     // FPostProcessUtils::BlendPostProcessSettings
};

EBlendForm GetForm(const FRow& Row)
{
	static const std::map<std::string, EBlendForm> Forms = {{"Volumes", EBlendForm::Volumes},
		{"Table", EBlendForm::Table}, {"Cubemap", EBlendForm::Cubemap}, {"Blendable", EBlendForm::Blendable},
		{"Distance", EBlendForm::Distance}, {"Parts", EBlendForm::Parts}};
	return Forms.at(Row.Words.at(0));
}

const FSettingField& GetField(const FRow& Row)
{
	return *Drydock::FindSettingField(Row.Words.at(1));
}

/** Objects stand for numbers: null for 0. */
FPostProcessSettings Give(const FSettingField& Field, double Value)
{
	FPostProcessSettings Settings;
	FSettingValue Packed = Field.Default;
	if (Field.FindOrAddObject != nullptr)
	{
		Packed.Object = Value == 0.0 ? nullptr : Field.FindOrAddObject("/Game/Number" + std::to_string(Value));
	}
	for (int32 Component = 0; Component < Field.GetNumComponents(); ++Component)
	{
		Packed.Components[Component] = Value;
	}
	Field.Set(Settings, Packed);
	Field.SetOverridden(Settings, true);
	return Settings;
}

FNumbers Read(const FSettingField& Field, const FPostProcessSettings& Settings)
{
	const FSettingValue Value = Field.Get(Settings);
	if (Field.FindOrAddObject != nullptr)
	{
		const std::string Path = Drydock::GetObjectPath(Value.Object);
		const size_t Digits = Path.find("Number");
		return {Digits == std::string::npos ? 0.0 : std::stod(Path.substr(Digits + 6))};
	}
	return FNumbers(Value.Components, Value.Components + Field.GetNumComponents());
}

FFinalPostProcessSettings BlendVolumes(
	const FPostProcessSettings& First, const FPostProcessSettings& Second, float Weight)
{
	return Drydock::Blended({Drydock::Unbound(0, 1, First), Drydock::Unbound(1, Weight, Second)});
}

FPostProcessSettings GiveTable(double Intensity)
{
	FPostProcessSettings Settings;
	Settings.bOverride_ColorGradingLUT = true;
	Settings.ColorGradingLUT = Drydock::FindOrAddTexture("/Game/Table");
	Settings.ColorGradingIntensity = static_cast<float>(Intensity);
	return Settings;
}

FPostProcessSettings GiveCubemap(double Intensity)
{
	FPostProcessSettings Settings;
	Settings.bOverride_AmbientCubemap = Settings.bOverride_AmbientCubemapIntensity = true;
	Settings.AmbientCubemap = Drydock::FindOrAddTextureCube("/Game/Sky");
	Settings.AmbientCubemapIntensity = static_cast<float>(Intensity);
	return Settings;
}

FPostProcessSettings GiveBlendable(double Weight)
{
	FPostProcessSettings Settings;
	Settings.WeightedBlendables.Array.Add(
		FWeightedBlendable(static_cast<float>(Weight), Drydock::FindOrAddTexture("/Game/Material")));
	return Settings;
}

FNumbers Blend(const FRow& Row, double From, double Source, float Weight)
{
	switch (GetForm(Row))
	{
	case EBlendForm::Volumes:
		return Read(GetField(Row), BlendVolumes(Give(GetField(Row), From), Give(GetField(Row), Source), Weight));
	case EBlendForm::Table:
	{
		const auto Blended = BlendVolumes(GiveTable(From), GiveTable(Source), Weight);
		FNumbers Weights = {0.0};
		for (const FFinalPostProcessSettings::FLUTEntry& Entry : Blended.ContributingLUTs)
		{
			Weights[0] += Entry.LUT.Get() != nullptr ? static_cast<double>(Entry.Weight) : 0.0;
		}
		return Weights;
	}
	case EBlendForm::Cubemap:
	{
		const auto Blended = BlendVolumes(GiveCubemap(From), GiveCubemap(Source), Weight);
		FNumbers Colors;
		for (const FFinalPostProcessSettings::FCubemapEntry& Entry : Blended.ContributingCubemaps)
		{
			Colors.push_back(static_cast<double>(Entry.AmbientCubemapTintMulScaleValue.G));
		}
		return Colors;
	}
	case EBlendForm::Blendable:
	{
		const auto Blended = BlendVolumes({}, GiveBlendable(Source), Weight);
		FNumbers Weights;
		for (const FWeightedBlendable& Blendable : Blended.BlendableManager.Blendables)
		{
			Weights.push_back(static_cast<double>(Blendable.Weight));
		}
		return Weights;
	}
	case EBlendForm::Distance:
	{
		FPostProcessVolumeProperties Volume;
		Volume.bIsEnabled = true;
		Volume.BlendRadius = 100.0f;
		Volume.BlendWeight = Weight;
		return {static_cast<double>(Drydock::GetInfluence(Volume, Source).Weight)};
	}
	case EBlendForm::Parts:
	{
		FPostProcessSettings Settings = Give(GetField(Row), From);
		FPostProcessUtils::BlendPostProcessSettings(Settings, Give(GetField(Row), Source), Weight);
		return Read(GetField(Row), Settings);
	}
	}
	return {};
}

std::string Say(const std::string& What, const FNumbers& Found)
{
	std::ostringstream Text;
	Text << What << ":";
	for (const double Number : Found)
	{
		Text << " " << Number;
	}
	return Text.str();
}

bool HaveSameBits(const FNumbers& A, const FNumbers& B)
{
	return A.size() == B.size() && (A.empty() || std::memcmp(A.data(), B.data(), A.size() * sizeof(double)) == 0);
}

/** The source's value that a hazard stands for. */
double GetValue(EHazard Hazard)
{
	switch (Hazard)
	{
	case EHazard::NaN:
		return NotANumber;
	case EHazard::PlusInf:
		return Infinity;
	case EHazard::MinusInf:
		return -Infinity;
	case EHazard::LargestHalf:
		return 65504;
	case EHazard::BeyondHalf:
		return 65520;
	case EHazard::Huge:
		return static_cast<double>(1e30f);
	case EHazard::Denormals:
		return static_cast<double>(1e-40f);
	case EHazard::NegativeZero:
		return -0.0;
	case EHazard::NegativeColors:
		return -3;
	case EHazard::Black:
		return 0;
	default:
		return 1;
	}
}

/** Over weights from 0 to 1, from the base to the source. */
std::string CheckBetweenEnds(const FRow& Row, double Source)
{
	const FNumbers First = Blend(Row, Base, Source, 0.0f), Last = Blend(Row, Base, Source, 1.0f);
	FNumbers Before = First;
	for (int Step = 1; Step <= 64; ++Step)
	{
		const FNumbers Now = Blend(Row, Base, Source, static_cast<float>(Step) / 64.0f);
		for (size_t Index = 0; Index < Now.size(); ++Index)
		{
			const bool bRising = Last[Index] >= First[Index];
			const bool bMonotone = bRising ? Now[Index] >= Before[Index] : Now[Index] <= Before[Index];
			const double Low = std::min(First[Index], Last[Index]), High = std::max(First[Index], Last[Index]);
			if (!bMonotone || !(Now[Index] >= Low && Now[Index] <= High))
			{
				return Say("not between, at weight " + std::to_string(Step / 64.0), Now);
			}
		}
		Before = Now;
	}
	return First == FNumbers(First.size(), Base) && Last == FNumbers(Last.size(), Source)
			   ? ""
			   : Say("not exact at its ends", Last);
}

std::string CheckClamped(const FRow& Row, EHazard Hazard)
{
	if (Hazard != EHazard::WeightOutside)
	{
		const double Value = GetValue(Hazard);
		const double Nearest = std::isnan(Value) ? 0.0 : std::clamp(Value, 0.0, 1.0);
		const FNumbers Found = Blend(Row, Base, Value, 1.0f);
		return HaveSameBits(Found, Blend(Row, Base, Nearest, 1.0f)) ? "" : Say("not as in 0..1", Found);
	}
	const std::pair<float, float> Weights[] = {
		{-1.0f, 0.0f}, {std::numeric_limits<float>::quiet_NaN(), 0.0f}, {2.0f, 1.0f}};
	for (const auto& [Weight, Nearest] : Weights)
	{
		const double Source = GetForm(Row) == EBlendForm::Distance ? 25.0 : 1.0;
		const FNumbers Found = Blend(Row, Base, Source, Weight);
		if (!HaveSameBits(Found, Blend(Row, Base, Source, Nearest)))
		{
			return Say("at weight " + std::to_string(Weight), Found);
		}
	}
	return "";
}

std::string CheckByDeclaration(const FRow& Row)
{
	const FSettingField& Field = GetField(Row);
	const double First = Field.Type == Drydock::ESettingType::Bool ? 0 : 2;
	const auto Inputs =
		Drydock::Inputs({Drydock::Unbound(5, 1, Give(Field, First)), Drydock::Unbound(5, 1, Give(Field, 1))});
	const Drydock::FBlendedSettings Blended = Drydock::BlendAt(Inputs);
	const FNumbers Found = Read(Field, Blended.Settings);
	const FNumbers Last = Read(Field, Give(Field, 1));
	return !HaveSameBits(Found, Last) ? Say("the later one does not win", Found)
		   : Blended.Ties.size() != 1 ? "the tie is not reported"
									  : "";
}

/** So many blends of a quarter each towards 1. */
std::string CheckSettles(const FRow& Row, double Bound)
{
	FFinalPostProcessSettings Settings;
	const FPostProcessSettings Source = GetForm(Row) == EBlendForm::Table     ? GiveTable(1)
										: GetForm(Row) == EBlendForm::Cubemap ? GiveCubemap(1)
																			  : Give(GetField(Row), 1);
	FPostProcessSettings Parts = GetForm(Row) == EBlendForm::Parts ? Give(GetField(Row), Base) : FPostProcessSettings();
	constexpr int NumBlends = 10000;
	for (int Index = 0; Index < NumBlends; ++Index)
	{
		if (GetForm(Row) == EBlendForm::Parts)
		{
			FPostProcessUtils::BlendPostProcessSettings(Parts, Source, 0.25f);
		}
		else
		{
			Drydock::OverridePostProcessSettings(Settings, Source, 0.25f);
		}
	}
	FNumbers Found;
	double Expected = 1;
	if (GetForm(Row) == EBlendForm::Table)
	{
		double Sum = 0;
		for (const FFinalPostProcessSettings::FLUTEntry& Entry : Settings.ContributingLUTs)
		{
			Sum += static_cast<double>(Entry.Weight);
		}
		Found = {Sum};
	}
	else if (GetForm(Row) == EBlendForm::Cubemap)
	{
		Expected = 0.25 * NumBlends;
		Found = {static_cast<double>(Settings.ContributingCubemaps[0].AmbientCubemapTintMulScaleValue.G)};
	}
	else
	{
		Found = Read(GetField(Row), GetForm(Row) == EBlendForm::Parts ? Parts : Settings);
		Expected = Read(GetField(Row), Source)[0];
	}
	return std::all_of(Found.begin(), Found.end(),
			   [=](double Number) { return std::abs(Number - Expected) <= Bound * Expected; })
			   ? ""
			   : Say("after 10,000 blends", Found);
}

} // namespace

std::string CheckBlend(const FRow& Row, EHazard Hazard)
{
	const FCell& Cell = Row.Cells[Hazard];
	const double Value = GetValue(Hazard);
	switch (Cell.Expect)
	{
	case EExpect::DoesNotApply:
		return "";
	case EExpect::LeftOut:
	{
		const FNumbers Found = Blend(Row, Base, Value, 1.0f);
		return HaveSameBits(Found, Blend(Row, Base, Value, 0.0f)) ? "" : Say("it takes part", Found);
	}
	case EExpect::Assigned:
	{
		// A bound is the least weight that assigns.
		for (const float Weight : {1.0f, Cell.Bound > 0.0 ? static_cast<float>(Cell.Bound) : 1.0f})
		{
			const FNumbers Found = Blend(Row, Base, Value, Weight);
			if (!HaveSameBits(Found, FNumbers(Found.size(), Value)))
			{
				return Say("not assigned", Found);
			}
		}
		return "";
	}
	case EExpect::BetweenEnds:
		return CheckBetweenEnds(Row, Value);
	case EExpect::Kept:
	{
		for (const float Weight : {0.1f, 0.3f, 0.7f, 1.0f})
		{
			const FNumbers Found = Blend(Row, 1, 1, Weight);
			if (!HaveSameBits(Found, FNumbers(Found.size(), 1)))
			{
				return Say("not the same", Found);
			}
		}
		return "";
	}
	case EExpect::Zero:
	{
		const FNumbers Found = Blend(Row, Base, Value, 1.0f);
		return HaveSameBits(Found, FNumbers(Found.size(), 0.0)) ? "" : Say("not 0", Found);
	}
	case EExpect::Finite:
	{
		const FNumbers Found = Blend(Row, Value, Value, 1.0f);
		return std::all_of(Found.begin(), Found.end(), [](double Number) { return std::isfinite(Number); })
				   ? ""
				   : Say("not finite", Found);
	}
	case EExpect::Clamped:
		return CheckClamped(Row, Hazard);
	case EExpect::ByDeclaration:
		return CheckByDeclaration(Row);
	case EExpect::Settles:
		return CheckSettles(Row, Cell.Bound);
	default:
		return "not an expectation of a rule";
	}
}

} // namespace Stability
