// Source: drydock; the order is the engine's.
#include "Run/FinalSettings.h"

#include "Config/ConfigReader.h"
#include "Exposure/PostProcessEyeAdaptation.h"
#include "HAL/IConsoleManager.h"
#include "ShowFlags.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

FVector ToVector(const FConfigVector& Vector)
{
	return FVector(Vector[0], Vector[1], Vector[2]);
}

FVolumeShape MakeShape(const FConfigBounds& Bounds)
{
	const FVector Center = ToVector(Bounds.Center);
	const FRotator Rotation(Bounds.Rotation[0], Bounds.Rotation[1], Bounds.Rotation[2]);
	switch (Bounds.Shape)
	{
	case EConfigShape::Sphere:
		return FVolumeShape::MakeSphere(Center, Bounds.Radius);
	case EConfigShape::Capsule:
		return FVolumeShape::MakeCapsule(Center, Bounds.Radius, Bounds.HalfHeight, Rotation);
	case EConfigShape::Convex:
	{
		std::vector<FVector> Points;
		std::transform(Bounds.Points.begin(), Bounds.Points.end(), std::back_inserter(Points), ToVector);
		return FVolumeShape::MakeConvex(std::move(Points));
	}
	case EConfigShape::Box:
		break;
	}
	return FVolumeShape::MakeBox(Center, ToVector(Bounds.Extent), Rotation);
}

APostProcessVolume MakeVolume(const FConfig& Config, size_t Index)
{
	const FConfigVolume& Volume = Config.Volumes[Index];
	APostProcessVolume Made;
	Made.Settings = Volume.Settings.Settings;
	Made.Priority = static_cast<float>(Volume.Priority);
	Made.BlendRadius = static_cast<float>(Volume.BlendRadius);
	Made.BlendWeight = static_cast<float>(Volume.BlendWeight);
	Made.bEnabled = Volume.bEnabled;
	Made.bUnbound = Volume.bUnbound;
	Made.Shape = Volume.Bounds ? MakeShape(*Volume.Bounds) : FVolumeShape();
	Made.Name = GetVolumeName(Config, Index).c_str();
	return Made;
}

FEngineShowFlags MakeShowFlags(const FConfig& Config)
{
	FEngineShowFlags ShowFlags;
	for (const FConfigShowFlag& Flag : Config.ShowFlags)
	{
		ShowFlags.SetSingleFlag(static_cast<uint32>(FEngineShowFlags::FindIndexByName(Flag.Name.c_str())), Flag.bValue);
	}
	return ShowFlags;
}

/** "A, B, C and 4 more". */
std::string ListSome(const std::vector<std::string>& Names)
{
	constexpr size_t MaxNamed = 3;
	std::string Text;
	for (size_t Index = 0; Index < std::min(Names.size(), MaxNamed); ++Index)
	{
		Text += (Index > 0 ? ", " : "") + Names[Index];
	}
	return Names.size() > MaxNamed ? Text + " and " + std::to_string(Names.size() - MaxNamed) + " more" : Text;
}

void WarnOfBlend(const FConfig& Config, const FBlendedSettings& Blended, std::vector<FDiagnostic>& Diagnostics)
{
	FConfigMessages Messages(Config.File, Diagnostics);
	for (const FBlendTie& Tie : Blended.Ties)
	{
		Messages.Warn(WarnEqualPriority, Config.Volumes[Tie.Second].Place,
			"same Priority as " + GetVolumeName(Config, Tie.First) +
				", and both act here: the order of declaration decides " + ListSome(Tie.Settings));
	}
	for (const FNonFiniteSetting& Setting : Blended.NonFinite)
	{
		Messages.Warn(WarnNonFiniteSetting, FConfigPlace(),
			Setting.Setting + " of " + Setting.Source + " is NaN or infinite: it is left out of the blend");
	}
}

/** Settings of metering where every exposure is a number. */
void WarnOfMetering(const FConfig& Config, std::vector<FDiagnostic>& Diagnostics)
{
	const bool bAuto = Config.View.bAutoExposure || std::any_of(Config.Views.begin(), Config.Views.end(),
														[](const FConfigView& View) { return View.bAutoExposure; });
	FConfigMessages Messages(Config.File, Diagnostics);
	const auto Warn = [&](const FConfigSettings& Settings)
	{
		for (const auto& [Name, Place] : Settings.Places)
		{
			if (!bAuto && IsMeteringSetting(Name))
			{
				Messages.Warn(WarnIneffectiveValue, Place,
					Name + " does nothing here: view.exposure is a number, and not \"auto\"");
			}
		}
	};
	for (const FConfigVolume& Volume : Config.Volumes)
	{
		Warn(Volume.Settings);
	}
	Warn(Config.Camera.Settings);
	Warn(Config.CommandLine);
}

/** The scene's own exposure at the default bias. */
float ComputeExposureScale(const FConfig& Config, const FChainSettings& Chain)
{
	if (!Chain.ShowFlags.EyeAdaptation || (Chain.bAutoExposure && !IsEyeAdaptationAllowed()))
	{
		return 1.0f;
	}
	const float DefaultBias = StartFinalPostProcessSettings().AutoExposureBias;
	return static_cast<float>(
		Config.View.Exposure.Value * std::exp2(static_cast<double>(Chain.Settings.AutoExposureBias) - DefaultBias));
}

} // namespace

FSettingsBlender MakeSettingsBlender(const FConfig& Config)
{
	FBlendInputs Inputs;
	for (size_t Index = 0; Index < Config.Volumes.size(); ++Index)
	{
		Inputs.Volumes.push_back(MakeVolume(Config, Index));
	}
	Inputs.Camera = Config.Camera.Settings.Settings;
	Inputs.CameraWeight = static_cast<float>(Config.Camera.PostProcessBlendWeight);
	Inputs.CommandLine = Config.CommandLine.Settings;
	Inputs.ShowFlags = MakeShowFlags(Config);
	Inputs.Engine = Config.GetEngineProfile();
	return FSettingsBlender(std::move(Inputs));
}

FBlendedSettings BlendSettingsAt(const FConfig& Config, const FVector& Location, FBlendLedger* Ledger)
{
	return MakeSettingsBlender(Config).At(Location, Ledger);
}

FVector GetViewLocation(const FConfig& Config)
{
	return ToVector(Config.View.Location.IsSet() ? Config.View.Location.Value
												 : Config.Scene.CameraLocation.value_or(FConfigVector{}));
}

std::string GetVolumeName(const FConfig& Config, size_t Index)
{
	const std::string& Name = Config.Volumes[Index].Name;
	return Name.empty() ? "volumes/" + std::to_string(Index) : Name;
}

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

FChainSettings MakeChainSettings(const FConfig& Config, std::vector<FDiagnostic>* Diagnostics)
{
	FBlendedSettings Blended = BlendSettingsAt(Config, GetViewLocation(Config));
	if (Diagnostics != nullptr)
	{
		WarnOfBlend(Config, Blended, *Diagnostics);
		WarnOfMetering(Config, *Diagnostics);
	}
	FChainSettings Chain;
	Chain.Engine = Config.GetEngineProfile();
	Chain.ShowFlags = MakeShowFlags(Config);
	Chain.Settings = std::move(Blended.Settings);
	Chain.Gates = std::move(Blended.Gates);
	Chain.ScreenPercentage = Config.Scene.ScreenPercentage;
	Chain.bAutoExposure = Config.View.bAutoExposure;
	Chain.ExposureScale = ComputeExposureScale(Config, Chain);
	Chain.bNoSkip = Config.bNoSkip;
	Chain.NamedSettings = GetNamedSettings(Config);
	Chain.bToonBloomConfigured = std::find(Chain.NamedSettings.begin(), Chain.NamedSettings.end(),
									 "BloomToonIntensity") != Chain.NamedSettings.end();
	return Chain;
}

} // namespace Drydock
