// The settings of a view at a place: defaults, volumes in ascending priority, camera, command line, console variables
// and show flags, in the engine's order. Source: engine SceneView.cpp (StartFinalPostprocessSettings,
// OverridePostProcessSettings, EndFinalPostprocessSettings) and World.cpp (AddPostProcessingSettings); the ledger and
// the warnings are drydock's.
#pragma once

#include "BlendLedger.h"
#include "BlendSource.h"
#include "EngineProfile.h"
#include "FinalPostProcessSettings.h"
#include "PostProcessVolumeWeight.h"
#include "Engine/PostProcessVolume.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** All that takes part. */
struct FBlendInputs
{
	std::vector<APostProcessVolume> Volumes; // in the order of declaration
	FPostProcessSettings Camera;
	float CameraWeight = 1.0f;
	FPostProcessSettings CommandLine; // after the camera, at full weight
	FEngineShowFlags ShowFlags;
	FEngineProfile Engine = GetDefaultEngineProfile();
};

/** Two volumes of one priority that both act, and give these settings different values: their order decides. */
struct FBlendTie
{
	size_t First = 0; // index in FBlendInputs::Volumes
	size_t Second = 0;
	std::vector<std::string> Settings;
};

/** A NaN or infinite value of a source; it was left out. */
struct FNonFiniteSetting
{
	std::string Source; // the volume's name, "camera", ...
	std::string Setting;
};

/** The relation of a place to a volume. */
struct FVolumeAtPlace
{
	size_t Volume = 0;              // index in FBlendInputs::Volumes
	std::optional<double> Distance; // cm; of bounded volumes
	FVolumeInfluence Influence;
};

struct FBlendedSettings
{
	FFinalPostProcessSettings Settings;
	std::vector<FSettingGate> Gates; // what console variables and show flags changed
	std::vector<FBlendTie> Ties;
	std::vector<FNonFiniteSetting> NonFinite; // of sources that have a weight here
};

/** Prepared once, asked at any number of places. Reads console variables at every call. Threads may ask at the same
 * time. */
class DRYDOCK_API FSettingsBlender
{
public:
	explicit FSettingsBlender(FBlendInputs Inputs);

	/** Location: cm. Ledger: empty, or null if the reasons are not needed. The result depends on nothing but the
	 * inputs, the console variables and the location. */
	FBlendedSettings At(const FVector& Location, FBlendLedger* Ledger = nullptr) const;

	/** All volumes in the order in which they are blended. */
	std::vector<FVolumeAtPlace> FindVolumes(const FVector& Location) const;

	const FBlendInputs& GetInputs() const { return Inputs; }

private:
	struct FPass;

	FVolumeAtPlace MeasureVolume(size_t Index, const FVector& Location, bool bMeasured) const;

	FBlendInputs Inputs;
	std::vector<FOverriddenFields> VolumeFields; // by index in Inputs.Volumes
	FOverriddenFields CameraFields;
	FOverriddenFields CommandLineFields;
	std::vector<size_t> Order;   // of volumes: ascending priority, equal ones as declared
	std::vector<uint8> bTouched; // by field: some source overrides it
	bool bEqualPriorities = false;
};

} // namespace Drydock
