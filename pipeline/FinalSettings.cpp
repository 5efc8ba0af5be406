// Source: drydock; the order is the engine's.
#include "FinalSettings.h"

#include "HAL/IConsoleManager.h"
#include "ShowFlags.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

/** Unbound, enabled volumes, lowest priority first; equal ones in the order of declaration. */
std::vector<const FConfigVolume*> SortVolumes(const FConfig& Config)
{
	std::vector<const FConfigVolume*> Volumes;
	for (const FConfigVolume& Volume : Config.Volumes)
	{
		if (Volume.bEnabled && Volume.bUnbound)
		{
			Volumes.push_back(&Volume);
		}
	}
	std::stable_sort(Volumes.begin(), Volumes.end(),
		[](const FConfigVolume* A, const FConfigVolume* B) { return A->Priority < B->Priority; });
	return Volumes;
}

/** The scene's own exposure at the default bias. */
float ComputeExposureScale(const FConfig& Config, const FChainSettings& Chain)
{
	if (!Chain.ShowFlags.EyeAdaptation)
	{
		return 1.0f;
	}
	const float DefaultBias = StartFinalPostProcessSettings().AutoExposureBias;
	return static_cast<float>(
		Config.View.Exposure.Value * std::exp2(static_cast<double>(Chain.Settings.AutoExposureBias) - DefaultBias));
}

} // namespace

std::vector<std::string> GetNamedSettings(const FConfig& Config)
{
	std::vector<std::string> Names;
	const auto Add = [&](const FConfigSettings& Settings)
	{
		for (const auto& [Name, Place] : Settings.Places)
		{
			Names.push_back(Name);
		}
	};
	for (const FConfigVolume& Volume : Config.Volumes)
	{
		Add(Volume.Settings);
	}
	Add(Config.Camera.Settings);
	Add(Config.CommandLine);
	std::sort(Names.begin(), Names.end());
	Names.erase(std::unique(Names.begin(), Names.end()), Names.end());
	return Names;
}

FChainSettings MakeChainSettings(const FConfig& Config)
{
	FChainSettings Chain;
	for (const FConfigShowFlag& Flag : Config.ShowFlags)
	{
		Chain.ShowFlags.SetSingleFlag(
			static_cast<uint32>(FEngineShowFlags::FindIndexByName(Flag.Name.c_str())), Flag.bValue);
	}
	Chain.Settings = StartFinalPostProcessSettings();
	for (const FConfigVolume* Volume : SortVolumes(Config))
	{
		OverridePostProcessSettings(Chain.Settings, Volume->Settings.Settings, static_cast<float>(Volume->BlendWeight));
	}
	OverridePostProcessSettings(
		Chain.Settings, Config.Camera.Settings.Settings, static_cast<float>(Config.Camera.PostProcessBlendWeight));
	OverridePostProcessSettings(Chain.Settings, Config.CommandLine.Settings, 1.0f);
	Chain.Gates = EndFinalPostProcessSettings(Chain.Settings, Chain.ShowFlags);
	Chain.ExposureScale = ComputeExposureScale(Config, Chain);
	const std::vector<std::string> Named = GetNamedSettings(Config);
	Chain.bToonBloomConfigured = std::find(Named.begin(), Named.end(), "BloomToonIntensity") != Named.end();
	return Chain;
}

} // namespace Drydock
