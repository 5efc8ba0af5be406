// Which settings the chain reads. Source: drydock.
#include "Config/ConfigReader.h"

namespace Drydock
{

namespace
{

constexpr const char* Acts = "";
constexpr const char* NoPass = "no pass reads it; it is blended and reported all the same";
constexpr const char* NewerConvolution = "it came with engine 5.6, whose convolution bloom is not simulated";
constexpr const char* GrainTexture = "the grain is a noise of its own, not a picture's";
constexpr const char* Curve = "a config has no keys of curves: it counts as a curve of no effect";

/** What becomes of settings whose names begin so: the longest beginning counts. */
constexpr struct
{
	const char* Beginning;
	const char* NotBuilt;
} Settings[] = {
	{"", NoPass},
	{"BlueCorrection", Acts},
	{"ExpandGamut", Acts},
	{"ToneCurveAmount", Acts},
	{"SceneColorTint", Acts},
	{"Film", Acts},
	{"FilmGrain", Acts},
	{"FilmGrainTexture", GrainTexture},
	{"TemperatureType", Acts},
	{"White", Acts},
	{"ColorSaturation", Acts},
	{"ColorContrast", Acts},
	{"ColorGamma", Acts},
	{"ColorGain", Acts},
	{"ColorOffset", Acts},
	{"ColorCorrection", Acts},
	{"ColorGrading", Acts},
	{"Sharpen", Acts},
	{"SceneFringeIntensity", Acts},
	{"ChromaticAberration", Acts},
	{"Bloom", Acts},
	{"BloomConvolutionIntensity", NewerConvolution},
	{"VignetteIntensity", Acts},
	{"AutoExposure", Acts},
	{"AutoExposureBiasBackup", NoPass},
	{"AutoExposureBiasCurve", Curve},
	{"AutoExposureCalibrationConstant", NoPass},
	{"Histogram", Acts},
	{"Camera", Acts},
	{"DepthOfFieldFocalDistance", Acts},
	{"DepthOfFieldFstop", Acts},
	{"DepthOfFieldSensorWidth", Acts},
	{"DepthOfFieldDepthBlur", Acts},
	{"LocalExposure", Acts},
	{"LocalExposureHighlightContrastCurve", Curve},
	{"LocalExposureShadowContrastCurve", Curve},
	{"MotionBlur", Acts},
	{"MotionBlurPerObjectSize", NoPass},
	{"DualKawaseBlur", Acts},
	{"ToonShadowBlur", Acts},
	{"DiffusionFilter", Acts},
	{"SoftFocus", Acts},
	{"GlowIntensity", Acts},
	{"CharaGlow", Acts},
	{"REDDof", Acts},
	{"UnityBloom", Acts},
};

} // namespace

bool IsMeteringSetting(const std::string& Name)
{
	const auto Begins = [&](const char* Beginning)
	{
		return Name.rfind(Beginning, 0) == 0;
	};
	return (Begins("AutoExposure") && !Begins("AutoExposureBias")) || Begins("Histogram") || Begins("Camera");
}

std::string GetSettingNotBuiltReason(const std::string& Name)
{
	std::string Beginning;
	const char* NotBuilt = NoPass;
	for (const auto& Setting : Settings)
	{
		if (Name.rfind(Setting.Beginning, 0) == 0 && std::string(Setting.Beginning).size() >= Beginning.size())
		{
			Beginning = Setting.Beginning;
			NotBuilt = Setting.NotBuilt;
		}
	}
	return NotBuilt;
}

} // namespace Drydock
