// Lists the names that differ from the words of the member. Source: the labels of UE 5.4's details panel.
#include "SettingDisplayNames.h"

#include "PostProcessSettingsReflection.h"
#include "TextTools.h"

#include <cctype>
#include <map>
#include <string_view>

namespace Drydock
{

namespace
{

bool IsUpper(char Character)
{
	return Character >= 'A' && Character <= 'Z';
}

/** The words of a member, as the engine parts them: "Scene Color Tint" of SceneColorTint, "Auto" of bAuto. */
std::string SplitWords(const std::string& Name, bool bBool)
{
	const size_t First = bBool && Name.size() > 1 && Name[0] == 'b' && IsUpper(Name[1]) ? 1 : 0;
	std::string Words;
	for (size_t At = First; At < Name.size(); ++At)
	{
		const char Character = Name[At];
		const char Before = At > First ? Name[At - 1] : '\0';
		const char Next = At + 1 < Name.size() ? Name[At + 1] : '\0';
		const bool bWord = IsUpper(Character) && (!IsUpper(Before) || (Next >= 'a' && Next <= 'z'));
		const bool bNumber = IsDigit(Character) && !IsDigit(Before) && !IsUpper(Before);
		Words += Before != '\0' && (bWord || bNumber) ? " " : "";
		Words += Character == '_' ? ' ' : At == First ? static_cast<char>(std::toupper(Character)) : Character;
	}
	return Words;
}

/** Members whose name begins with a word that the category says already: the editor leaves it out. */
constexpr std::string_view Shortened[] = {"AmbientCubemapIntensity", "AmbientCubemapTint", "AmbientOcclusionBias",
	"AmbientOcclusionFadeRadius", "AmbientOcclusionIntensity", "AmbientOcclusionMipBlend", "AmbientOcclusionMipScale",
	"AmbientOcclusionMipThreshold", "AmbientOcclusionPower", "AmbientOcclusionQuality", "AmbientOcclusionRadius",
	"AmbientOcclusionStaticFraction", "AmbientOcclusionTemporalBlendWeight", "AutoExposureHighPercent",
	"AutoExposureLowPercent", "AutoExposureSpeedDown", "AutoExposureSpeedUp", "BloomIntensity", "BloomMethod",
	"BloomThreshold", "ChromaticAberrationStartOffset", "ColorContrast", "ColorGain", "ColorGamma", "ColorOffset",
	"ColorSaturation", "DepthOfFieldDepthBlurRadius", "DepthOfFieldFarBlurSize", "DepthOfFieldFarTransitionRegion",
	"DepthOfFieldFocalDistance", "DepthOfFieldFocalRegion", "DepthOfFieldNearBlurSize",
	"DepthOfFieldNearTransitionRegion", "DepthOfFieldOcclusion", "DepthOfFieldScale", "DepthOfFieldSqueezeFactor",
	"DepthOfFieldVignetteSize", "FilmShoulder", "FilmSlope", "FilmToe", "LensFlareIntensity", "LensFlareThreshold",
	"LensFlareTint", "LensFlareTints", "LocalExposureDetailStrength", "LocalExposureMethod", "MotionBlurAmount",
	"MotionBlurMax", "MotionBlurPerObjectSize", "MotionBlurTargetFPS", "SceneFringeIntensity",
	"ScreenSpaceReflectionIntensity", "ScreenSpaceReflectionMaxRoughness", "ScreenSpaceReflectionQuality"};

constexpr std::string_view Beginnings[] = {"AmbientCubemap", "AmbientOcclusion", "AutoExposure", "Bloom",
	"ChromaticAberration", "Color", "DepthOfField", "Film", "LensFlare", "LocalExposure", "MotionBlur", "SceneFringe",
	"ScreenSpaceReflection"};

const std::map<std::string_view, std::string_view> Others = {
	{"AmbientCubemap", "Cubemap Texture"},
	{"AmbientOcclusionFadeDistance", "Fade Out Distance"},
	{"AmbientOcclusionRadiusInWS", "Radius in WorldSpace"},
	{"AutoExposureBias", "Exposure Compensation"},
	{"AutoExposureBiasCurve", "Exposure Compensation Curve"},
	{"AutoExposureMaxBrightness", "Max EV100"},
	{"AutoExposureMeterMask", "Exposure Metering Mask"},
	{"AutoExposureMethod", "Metering Mode"},
	{"AutoExposureMinBrightness", "Min EV100"},
	{"AutoExposureApplyPhysicalCameraExposure", "Apply Physical Camera Exposure"},
	{"Bloom1Size", "#1 Size"},
	{"Bloom1Tint", "#1 Tint"},
	{"Bloom2Size", "#2 Size"},
	{"Bloom2Tint", "#2 Tint"},
	{"Bloom3Size", "#3 Size"},
	{"Bloom3Tint", "#3 Tint"},
	{"Bloom4Size", "#4 Size"},
	{"Bloom4Tint", "#4 Tint"},
	{"Bloom5Size", "#5 Size"},
	{"Bloom5Tint", "#5 Tint"},
	{"Bloom6Size", "#6 Size"},
	{"Bloom6Tint", "#6 Tint"},
	{"BloomConvolutionBufferScale", "Convolution Buffer"},
	{"BloomConvolutionCenterUV", "Convolution Center"},
	{"BloomConvolutionPreFilterMax", "Convolution Boost Max"},
	{"BloomConvolutionPreFilterMin", "Convolution Boost Min"},
	{"BloomConvolutionPreFilterMult", "Convolution Boost Mult"},
	{"BloomConvolutionSize", "Convolution Scale"},
	{"BloomConvolutionTexture", "Convolution Kernel"},
	{"BloomDirtMask", "Dirt Mask Texture"},
	{"BloomDirtMaskIntensity", "Dirt Mask Intensity"},
	{"BloomDirtMaskTint", "Dirt Mask Tint"},
	{"BloomSizeScale", "Size scale"},
	{"CameraISO", "ISO"},
	{"CameraShutterSpeed", "Shutter Speed (1/s)"},
	{"ColorCorrectionHighlightsMax", "HighlightsMax"},
	{"ColorCorrectionHighlightsMin", "HighlightsMin"},
	{"ColorCorrectionShadowsMax", "ShadowsMax"},
	{"ColorGradingIntensity", "Color Grading LUT Intensity"},
	{"DepthOfFieldBladeCount", "Number of diaphragm blades"},
	{"DepthOfFieldDepthBlurAmount", "Depth Blur km for 50%"},
	{"DepthOfFieldFstop", "Aperture (F-stop)"},
	{"DepthOfFieldMinFstop", "Maximum Aperture (min F-stop)"},
	{"DepthOfFieldSensorWidth", "Sensor Width (mm)"},
	{"DepthOfFieldSkyFocusDistance", "Sky Distance"},
	{"FilmBlackClip", "Black clip"},
	{"FilmWhiteClip", "White clip"},
	{"HistogramLogMax", "Histogram Max EV100"},
	{"HistogramLogMin", "Histogram Min EV100"},
	{"LensFlareBokehShape", "BokehShape"},
	{"LensFlareBokehSize", "BokehSize"},
	{"LocalExposureHighlightContrastScale", "Highlight Contrast"},
	{"LocalExposureShadowContrastScale", "Shadow Contrast"},
	{"WhiteTemp", "Temp"},
	{"WhiteTint", "Tint"},
};

} // namespace

std::string GetDisplayName(const FSettingField& Field)
{
	std::string Name = Field.Name;
	if (const auto Other = Others.find(Name); Other != Others.end())
	{
		return std::string(Other->second);
	}
	for (const std::string_view Range : {"Shadows", "Midtones", "Highlights"})
	{
		const std::string Category = "Color Grading|" + std::string(Range);
		if (Field.Category == Category && Name.ends_with(Range))
		{
			Name.resize(Name.size() - Range.size()); // ColorGainShadows: a Gain, as ColorGain is
		}
	}
	if (std::ranges::find(Shortened, Name) != std::end(Shortened))
	{
		const auto IsBeginning = [&](std::string_view Begin)
		{
			return Name.starts_with(Begin);
		};
		Name.erase(0, std::ranges::find_if(Beginnings, IsBeginning)->size());
	}
	return SplitWords(Name, Field.Type == ESettingType::Bool);
}

} // namespace Drydock
