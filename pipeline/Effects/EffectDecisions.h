// Which effects a frame calls for, and why the others do not run. Pure: looks at settings, and at what the scene was
// found to hold. Source: engine PostProcess/PostProcessing.cpp (conditions of settings); content and the record are
// drydock's.
#pragma once

#include "Effects/Banding.h"
#include "Effects/ToonBleed.h"
#include "EngineProfile.h"
#include "FinalPostProcessSettings.h"
#include "SceneFile/ViewContent.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace Drydock
{

/** Whether an effect runs, and why. */
struct FEffectDecision
{
	std::string Name; // "Bloom", "ToonBloom", ... (see GetEffectNames)
	bool bActive = false;
	bool bConfigured = false; // the config asks for it: not running is worth a line
	std::string Reason;
	bool bNothingToDo = false; // not active only because of what the scene holds: running it would change nothing
	std::optional<FIntRect> Region = {};          // of an effect that works on a part of the view: from its corner
	std::optional<FToonBleed> Bleed = {};         // of an executed ToonBloom
	std::optional<FBandingFigures> Banding = {};  // of an executed ToonShadowBlur: the blurred shadow as it is stored
	std::optional<FDarkDeviation> Deviation = {}; // likewise: from what it would be without rounding
};

/** The decision on that effect, or null. */
DRYDOCK_API const FEffectDecision* FindEffect(const std::vector<FEffectDecision>& Effects, std::string_view Name);
DRYDOCK_API FEffectDecision* FindEffect(std::vector<FEffectDecision>& Effects, std::string_view Name);

/** Whether that effect runs. */
DRYDOCK_API bool IsEffectActive(const std::vector<FEffectDecision>& Effects, std::string_view Name);

/** Every effect there is or will be, in the order of the frame. */
DRYDOCK_API const std::vector<std::string>& GetEffectNames();

/** What decisions are made of. */
struct FChainSettings
{
	FFinalPostProcessSettings Settings; // after show flags and console variables
	FEngineProfile Engine = GetDefaultEngineProfile();
	FEngineShowFlags ShowFlags;
	std::vector<FSettingGate> Gates;        // what those two changed
	bool bAutoExposure = false;             // asked for: see IsAutoExposureActive (ExposureDecisions.h)
	float ExposureScale = 1.0f;             // final; of an automatic exposure once the frame has run
	double ScreenPercentage = 100.0;        // of the config, whatever the show flag says
	std::vector<std::string> NamedSettings; // by a volume, the camera or --pp, sorted
	bool bToonBloomConfigured = false;      // a volume, the camera or --pp names BloomToonIntensity
	bool bNoSkip = false;                   // neutral values are no reason not to run
	FViewContent Content;                   // empty: settings alone decide
	bool bDualKawaseExtension = false;      // one is active: it makes the effect's passes, wherever it subscribes
};

/** Rendered size in percent of the output's: 100 where ShowFlag.ScreenPercentage is off. */
DRYDOCK_API double GetScreenPercentage(const FChainSettings& Chain);

/** r.PostProcessing.PreferCompute. */
bool IsComputePreferred();

/** What of the scene could leave out or confine an effect that is active in Effects. */
DRYDOCK_API FContentQuestions AskContent(const FChainSettings& Chain, const std::vector<FEffectDecision>& Effects);

/** One decision per effect name, in their order. */
DRYDOCK_API std::vector<FEffectDecision> DecideEffects(const FChainSettings& Chain);

} // namespace Drydock
