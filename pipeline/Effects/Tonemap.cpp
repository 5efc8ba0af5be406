// The tonemapper with its table of colour grading, lens effects and encoding for the display. Source: engine
// PostProcess/PostProcessTonemap.cpp (conditions); the wording is drydock's.
#include "Effects/Effect.h"
#include "Tonemap/ColorGrading.h"
#include "Tonemap/PostProcessCombineLUTs.h"
#include "Tonemap/TonemapOutputDevice.h"

namespace Drydock
{

namespace
{

constexpr FSettingClaim TonemapSettings[] = {
	{"BlueCorrection"},
	{"ExpandGamut"},
	{"ToneCurveAmount"},
	{"SceneColorTint"},
	{"Film"},
	{"TemperatureType"},
	{"White"},
	{"ColorSaturation"},
	{"ColorContrast"},
	{"ColorGamma"},
	{"ColorGain"},
	{"ColorOffset"},
	{"ColorCorrection"},
	{"ColorGrading"},
	{"Sharpen"},
	{"SceneFringeIntensity"},
	{"ChromaticAberration"},
	{"VignetteIntensity"},
};

FEffectDecision DecideTonemap(const FEffect&, const FEffectInputs& Inputs)
{
	FEffectDecision Decision;
	Decision.bActive = Decision.bConfigured = true;
	const std::string Off = Inputs.FindShowFlagOff(Inputs.Conditions.ShowFlags.Tonemapper, "Tonemapper");
	if (!Off.empty())
	{
		Decision.Reason = "always; gamma only, no curve, bloom or lens: " + Off;
		return Decision;
	}
	const EDisplayOutputFormat Device = GetTonemapperOutputDeviceParameters().OutputDevice;
	Decision.Reason = IsTonemapLUTUsed() ? "always; by the combined table" : "always; evaluated for each pixel";
	if (!MakeColorGrading(Inputs.Settings).bNeutral)
	{
		Decision.Reason += ", with colour grading";
	}
	if (Device != EDisplayOutputFormat::SDR_sRGB)
	{
		Decision.Reason += std::string(", for ") + GetEncodingName(Device);
	}
	return Decision;
}

} // namespace

const FEffect GTonemapEffect{
	.Id = EEffect::Tonemap,
	.Name = "Tonemap",
	.Doc = "From scene-linear colour to the display, with grading and the lens.",
	.Settings = TonemapSettings,
	.bMayBrightenBeforeBloom = false,
	.Decide = &DecideTonemap,
	.Content = FContentGate{},
	.Complete = nullptr,
	.GetPlace = [] { return FChainPlace{EChainPlace::Tonemap}; },
	.AddPasses = nullptr,
	.Measurement = FMeasurement{},
};

} // namespace Drydock
