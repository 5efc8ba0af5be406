// Blends all sources of a view's settings, and warns of ties. Source: engine World.cpp and SceneView.cpp for the order.
#include "BlendSettings.h"

#include "BlendContributions.h"
#include "RangeTools.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace Drydock
{

namespace
{

/** Something that overrides settings, at the place in question. */
struct FActor
{
	EBlendSource Kind;
	const char* Source;
	const FPostProcessSettings& Settings;
	const FOverriddenFields& Fields;
	float Weight = 0.0f;
	std::optional<double> Distance;
	std::string Skipped; // why it does nothing
};

constexpr size_t NoVolume = static_cast<size_t>(-1);

/** Whether nothing is left of what was there before. */
bool Covers(const FSettingField& Field, const FPostProcessSettings& Source, float Weight)
{
	switch (Field.Blend)
	{
	case ESettingBlend::Set:
		return true;
	case ESettingBlend::SetIfNonZero:
		return !IsIneffective(Field, Field.Get(Source));
	case ESettingBlend::Lerp:
	case ESettingBlend::FocalDistance:
		return Weight >= 1.0f;
	case ESettingBlend::Accumulate:
	case ESettingBlend::LUT:
		break;
	}
	return false;
}

} // namespace

/** One walk through the sources. */
struct FSettingsBlender::FPass
{
	/** Which volumes of equal priority have given a setting different values, unless something covered it since. */
	struct FFieldTie
	{
		size_t FirstOfGroup = NoVolume; // of the group in hand, that acted on the field
		size_t First = NoVolume;
		size_t Second = NoVolume;
	};

	const FSettingsBlender& Blender;
	FBlendLedger* Ledger;
	FBlendedSettings Result;
	std::vector<FFieldTie> Ties;

	void Apply(const FActor& Actor)
	{
		const std::vector<FSettingField>& Fields = GetSettingFields();
		if (Actor.Skipped.empty())
		{
			for (const uint32 Index : Actor.Fields.NonFinite)
			{
				Result.NonFinite.push_back({Actor.Source, Fields[Index].Name});
			}
			BlendContributions(Result.Settings, Actor.Settings, Actor.Weight);
		}
		if (Ledger != nullptr)
		{
			ApplyAndRecord(Actor);
		}
		else if (Actor.Skipped.empty())
		{
			for (const uint32 Index : Actor.Fields.Fields)
			{
				Fields[Index].BlendFrom(Result.Settings, Actor.Settings, Actor.Weight);
				Fields[Index].SetOverridden(Result.Settings, true);
			}
		}
	}

	/** Describes the lists that hold such a field's contributions. */
	std::string Describe(const FSettingField& Field) const
	{
		return Field.Blend == ESettingBlend::LUT          ? DescribeLUTs(Result.Settings)
			   : Field.Blend == ESettingBlend::Accumulate ? DescribeCubemaps(Result.Settings)
														  : "";
	}

	static std::string FindSkip(const FActor& Actor, const FSettingField& Field)
	{
		const FSettingValue Value = Field.Get(Actor.Settings);
		return !Field.IsOverridden(Actor.Settings) ? "override off"
			   : !Actor.Skipped.empty()            ? Actor.Skipped
			   : !Value.IsFinite()                 ? "the value is not finite"
			   : IsIneffective(Field, Value)       ? "zero or null replaces nothing"
												   : "";
	}

	void ApplyAndRecord(const FActor& Actor)
	{
		const std::vector<FSettingField>& Fields = GetSettingFields();
		for (uint32 Index = 0; Index < Fields.size(); ++Index)
		{
			const FSettingField& Field = Fields[Index];
			if (!Blender.bTouched[Index])
			{
				continue;
			}
			const bool bOverridden = Field.IsOverridden(Actor.Settings);
			if (!bOverridden && Actor.Kind != EBlendSource::Volume)
			{
				continue;
			}
			FBlendLedgerEntry Entry{Actor.Kind, Actor.Source, ToString(Field.Blend), Actor.Weight, Actor.Distance,
				Field.Get(Result.Settings), {}, FindSkip(Actor, Field), ""};
			if (bOverridden && Actor.Skipped.empty() && Field.Get(Actor.Settings).IsFinite())
			{
				Field.BlendFrom(Result.Settings, Actor.Settings, Actor.Weight);
				Field.SetOverridden(Result.Settings, true);
				Entry.Detail = Describe(Field);
			}
			Entry.After = Field.Get(Result.Settings);
			Ledger->Add(Index, std::move(Entry));
		}
	}

	/** Volume: index of one that acts. */
	void NoteTies(size_t Volume, float Weight)
	{
		const FPostProcessSettings& Settings = Blender.Inputs.Volumes[Volume].Settings;
		for (const uint32 Index : Blender.VolumeFields[Volume].Fields)
		{
			const FSettingField& Field = GetSettingFields()[Index];
			FFieldTie& Tie = Ties[Index];
			const size_t First = Tie.FirstOfGroup;
			if (First == NoVolume || !SharePriority(First, Volume))
			{
				Tie.FirstOfGroup = Volume;
				Tie.First = Covers(Field, Settings, Weight) ? NoVolume : Tie.First;
				continue;
			}
			const FSettingValue FirstValue = Field.Get(Blender.Inputs.Volumes[First].Settings);
			const FSettingValue Value = Field.Get(Settings);
			const bool bOrderMatters = Field.Blend != ESettingBlend::Accumulate && !(FirstValue == Value) &&
									   !IsIneffective(Field, FirstValue) && !IsIneffective(Field, Value);
			if (bOrderMatters)
			{
				Tie.First = First;
				Tie.Second = Volume;
			}
		}
	}

	/** Camera and command line decide alone what they cover. */
	void ForgetTies(const FOverriddenFields& Fields, const FPostProcessSettings& Settings, float Weight)
	{
		for (const uint32 Index : Fields.Fields)
		{
			if (Covers(GetSettingFields()[Index], Settings, Weight))
			{
				Ties[Index].First = NoVolume;
			}
		}
	}

	bool SharePriority(size_t A, size_t B) const
	{
		return Blender.Inputs.Volumes[A].Priority == Blender.Inputs.Volumes[B].Priority;
	}

	/** One entry per pair of volumes. */
	void CollectTies()
	{
		for (size_t Index = 0; Index < Ties.size(); ++Index)
		{
			const FFieldTie& Tie = Ties[Index];
			if (Tie.First == NoVolume)
			{
				continue;
			}
			auto Found = std::ranges::find_if(Result.Ties,
				[&](const FBlendTie& Each) { return Each.First == Tie.First && Each.Second == Tie.Second; });
			if (Found == Result.Ties.end())
			{
				Found = Result.Ties.insert(Found, {Tie.First, Tie.Second, {}});
			}
			Found->Settings.emplace_back(GetSettingFields()[Index].Name);
		}
		std::ranges::sort(Result.Ties, [](const FBlendTie& A, const FBlendTie& B)
			{ return std::pair(A.Second, A.First) < std::pair(B.Second, B.First); });
	}
};

FSettingsBlender::FSettingsBlender(FBlendInputs InInputs)
	: Inputs(std::move(InInputs))
	, CameraFields(FindOverriddenFields(Inputs.Camera))
	, CommandLineFields(FindOverriddenFields(Inputs.CommandLine))
	, Order(Inputs.Volumes.size())
	, bTouched(GetSettingFields().size())
{
	for (APostProcessVolume& Volume : Inputs.Volumes)
	{
		Volume.Priority = std::isnan(Volume.Priority) ? 0.0f : Volume.Priority; // what has no order cannot be sorted
	}
	std::iota(Order.begin(), Order.end(), size_t{0});
	std::ranges::stable_sort(
		Order, [this](size_t A, size_t B) { return Inputs.Volumes[A].Priority < Inputs.Volumes[B].Priority; });
	bEqualPriorities = std::ranges::adjacent_find(Order, [this](size_t A, size_t B)
						   { return Inputs.Volumes[A].Priority == Inputs.Volumes[B].Priority; }) != Order.end();
	const auto Note = [this](const FOverriddenFields& Fields)
	{
		for (const std::vector<uint32>* Indices : {&Fields.Fields, &Fields.NonFinite})
		{
			for (const uint32 Index : *Indices)
			{
				bTouched[Index] = 1;
			}
		}
	};
	for (const APostProcessVolume& Volume : Inputs.Volumes)
	{
		VolumeFields.push_back(FindOverriddenFields(Volume.Settings));
		Note(VolumeFields.back());
	}
	Note(CameraFields);
	Note(CommandLineFields);
}

FVolumeAtPlace FSettingsBlender::MeasureVolume(size_t Index, const FVector& Location, bool bMeasured) const
{
	const APostProcessVolume& Volume = Inputs.Volumes[Index];
	FVolumeAtPlace Place{Index, std::nullopt, {}};
	if (bMeasured)
	{
		Place.Distance = Volume.Shape.GetDistance(Location);
	}
	Place.Influence = GetInfluence(Volume.GetProperties(), Place.Distance.value_or(0.0));
	return Place;
}

std::vector<FVolumeAtPlace> FSettingsBlender::FindVolumes(const FVector& Location) const
{
	return ToVector<FVolumeAtPlace>(
		Order, [&](const size_t Index) { return MeasureVolume(Index, Location, !Inputs.Volumes[Index].bUnbound); });
}

FBlendedSettings FSettingsBlender::At(const FVector& Location, FBlendLedger* Ledger) const
{
	FPass Pass{*this, Ledger, {}, std::vector<FPass::FFieldTie>(GetSettingFields().size())};
	Pass.Result.Settings = StartFinalPostProcessSettings(Ledger, Inputs.Engine);
	for (const size_t Index : Order)
	{
		const APostProcessVolume& Volume = Inputs.Volumes[Index];
		const bool bMeasured = !Volume.bUnbound && (Volume.bEnabled || Ledger != nullptr);
		const FVolumeAtPlace Place = MeasureVolume(Index, Location, bMeasured);
		if (Place.Influence.Skip != EVolumeSkip::None && Ledger == nullptr)
		{
			continue;
		}
		Pass.Apply({EBlendSource::Volume, *Volume.Name, Volume.Settings, VolumeFields[Index], Place.Influence.Weight,
			Place.Distance, ExplainSkip(Place.Influence.Skip, Volume.GetProperties(), Place.Distance.value_or(0.0))});
		if (Place.Influence.Skip == EVolumeSkip::None && bEqualPriorities)
		{
			Pass.NoteTies(Index, Place.Influence.Weight);
		}
	}
	const float CameraWeight = Inputs.CameraWeight > 0.0f ? std::min(Inputs.CameraWeight, 1.0f) : 0.0f;
	Pass.Apply({EBlendSource::Camera, "camera", Inputs.Camera, CameraFields, CameraWeight, {},
		CameraWeight > 0.0f ? "" : "PostProcessBlendWeight is 0"});
	Pass.Apply({EBlendSource::CommandLine, "--pp", Inputs.CommandLine, CommandLineFields, 1.0f, {}, ""});
	Pass.ForgetTies(CameraFields, Inputs.Camera, CameraWeight);
	Pass.ForgetTies(CommandLineFields, Inputs.CommandLine, 1.0f);
	Pass.CollectTies();
	Pass.Result.Gates = EndFinalPostProcessSettings(Pass.Result.Settings, Inputs.ShowFlags, Ledger);
	return std::move(Pass.Result);
}

} // namespace Drydock
