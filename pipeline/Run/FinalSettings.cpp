// Blends a config's settings, in the engine's order.
#include "Run/FinalSettings.h"

#include "Config/ConfigReader.h"
#include "Effects/Effects.h"
#include "Effects/Exposure.h"
#include "Exposure/PostProcessEyeAdaptation.h"
#include "HAL/IConsoleManager.h"
#include "RangeTools.h"
#include "ShowFlags.h"
#include "Text/ConfigErrors.h"
#include "Text/TextFormat.h"
#include "TextTools.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

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

/** Every place where a setting is given, in the order of the file; bCommandLine: by --pp. */
void ForEachNamedSetting(const FConfig& Config,
	const std::function<void(const std::string& Name, const FConfigPlace& Place, bool bCommandLine)>& Function)
{
	const auto Visit = [&](const FConfigSettings& Settings, bool bCommandLine)
	{
		for (const auto& [Name, Place] : Settings.Places)
		{
			Function(Name, Place, bCommandLine);
		}
	};
	for (const FConfigVolume& Volume : Config.Volumes)
	{
		Visit(Volume.Settings, false);
	}
	Visit(Config.Camera.Settings, false);
	Visit(Config.CommandLine, true);
}

void WarnOfBlend(const FConfig& Config, const FBlendedSettings& Blended, std::vector<FDiagnostic>& Diagnostics)
{
	FConfigMessages Messages(Config.File, Diagnostics);
	for (const FBlendTie& Tie : Blended.Ties)
	{
		Messages.Warn(WarnEqualPriority, Config.Volumes[Tie.Second].Place,
			"same Priority as " + GetVolumeName(Config, Tie.First) +
				", and both act here: the order of declaration decides " + ListSome(Tie.Settings, 3));
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
	if (Config.View.bAutoExposure || Contains(Config.Views, true, &FConfigView::bAutoExposure))
	{
		return;
	}
	FConfigMessages Messages(Config.File, Diagnostics);
	ForEachNamedSetting(Config,
		[&](const std::string& Name, const FConfigPlace& Place, bool)
		{
			if (IsMeteringSetting(Name))
			{
				Messages.Warn(WarnIneffectiveValue, Place,
					Name + " does nothing here: view.exposure is a number, and not \"auto\"");
			}
		});
}

/** The scene's own exposure at the default bias. */
float ComputeExposureScale(const FConfig& Config, const FViewSettings& View)
{
	if (!View.ShowFlags.EyeAdaptation || (View.bAutoExposure && !IsEyeAdaptationAllowed()))
	{
		return 1.0f;
	}
	const float DefaultBias = StartFinalPostProcessSettings().AutoExposureBias;
	const float Scale = static_cast<float>(
		Config.View.Exposure.Value * std::exp2(static_cast<double>(View.Settings.AutoExposureBias) - DefaultBias));
	if (!View.bAutoExposure && !(Scale > 0.0f && std::isfinite(Scale)))
	{
		throw FError(
			{.Code = ErrorBadValue,
				.Message = "AutoExposureBias is " + NumberText(View.Settings.AutoExposureBias) +
						   ": the exposure's scale, view.exposure times 2 to the power of the bias, is " +
						   NumberText(Scale) + "; expected a finite number above 0, as a bias from -100 to 100 gives",
				.File = Config.File,
				.Where = "AutoExposureBias"},
			ExitUsage);
	}
	return Scale;
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
	std::set<std::string> Names;
	ForEachNamedSetting(Config, [&](const std::string& Name, const FConfigPlace&, bool) { Names.insert(Name); });
	return {Names.begin(), Names.end()};
}

void WarnOfUnreadSettings(const FConfig& Config, std::vector<FDiagnostic>& Diagnostics)
{
	const std::string CommandLine = CommandLineName;
	FConfigMessages OfFile(Config.File, Diagnostics);
	FConfigMessages OfCommandLine(CommandLine, Diagnostics);
	ForEachNamedSetting(Config,
		[&](const std::string& Name, const FConfigPlace& Place, bool bCommandLine)
		{
			const std::string NotBuilt = GetSettingNotBuiltReason(Name);
			if (!NotBuilt.empty())
			{
				(bCommandLine ? OfCommandLine : OfFile)
					.Warn(WarnNotBuilt, Place, Name + " is not built yet: " + NotBuilt);
			}
		});
}

FViewSettings MakeViewSettings(const FConfig& Config, std::vector<FDiagnostic>* Diagnostics)
{
	FBlendedSettings Blended = BlendSettingsAt(Config, GetViewLocation(Config));
	if (Diagnostics != nullptr)
	{
		WarnOfBlend(Config, Blended, *Diagnostics);
		WarnOfMetering(Config, *Diagnostics);
	}
	FViewSettings View;
	View.Engine = Config.GetEngineProfile();
	View.ShowFlags = MakeShowFlags(Config);
	View.Settings = std::move(Blended.Settings);
	View.Gates = std::move(Blended.Gates);
	View.ScreenPercentage = Config.Scene.ScreenPercentage;
	View.bAutoExposure = Config.View.bAutoExposure;
	View.ExposureScale = ComputeExposureScale(Config, View);
	View.bNoSkip = Config.bNoSkip;
	View.bOverlaid = !Config.Overlays.empty();
	View.NamedSettings = GetNamedSettings(Config);
	return View;
}

} // namespace Drydock
