// Short words for blending tests.
#pragma once

#include "BlendSettings.h"

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace Drydock
{

/** Settings that override these fields; a colour's value goes to all of its components. */
inline FPostProcessSettings Give(std::initializer_list<std::pair<const char*, double>> Values)
{
	FPostProcessSettings Settings;
	for (const auto& [Name, Number] : Values)
	{
		const FSettingField& Field = *FindSettingField(Name);
		FSettingValue Value = Field.Default;
		for (int32 Index = 0; Index < Field.GetNumComponents(); ++Index)
		{
			Value.Components[Index] = Number;
		}
		Field.Set(Settings, Value);
		Field.SetOverridden(Settings, true);
	}
	return Settings;
}

inline APostProcessVolume Unbound(float Priority, float Weight, const FPostProcessSettings& Settings)
{
	APostProcessVolume Volume;
	Volume.Name = FString::Printf(TEXT("volume of priority %g"), static_cast<double>(Priority));
	Volume.Priority = Priority;
	Volume.BlendWeight = Weight;
	Volume.bUnbound = true;
	Volume.Settings = Settings;
	return Volume;
}

inline APostProcessVolume Bounded(
	float Priority, const FVolumeShape& Shape, float BlendRadius, const FPostProcessSettings& Settings)
{
	APostProcessVolume Volume = Unbound(Priority, 1.0f, Settings);
	Volume.bUnbound = false;
	Volume.Shape = Shape;
	Volume.BlendRadius = BlendRadius;
	return Volume;
}

inline FBlendInputs Inputs(std::vector<APostProcessVolume> Volumes)
{
	FBlendInputs Made;
	Made.Volumes = std::move(Volumes);
	return Made;
}

inline FBlendedSettings BlendAt(
	const FBlendInputs& Inputs, const FVector& Location = FVector(0, 0, 0), FBlendLedger* Ledger = nullptr)
{
	return FSettingsBlender(Inputs).At(Location, Ledger);
}

inline FFinalPostProcessSettings Blended(
	std::vector<APostProcessVolume> Volumes, const FVector& Location = FVector(0, 0, 0))
{
	return BlendAt(Inputs(std::move(Volumes)), Location).Settings;
}

} // namespace Drydock
