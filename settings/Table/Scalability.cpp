// The presets of sg.PostProcessQuality. Source: engine Scalability.cpp (a group's variable sets the others),
// BaseScalability (values, as documented).
#include "Scalability.h"

#include "HAL/IConsoleManager.h"

#include <algorithm>

namespace Drydock
{

namespace
{

/** Runs when sg.PostProcessQuality was set; not when it is put back to "nobody has set it". */
void OnPostProcessQualityChanged(IConsoleVariable* Variable)
{
	if ((Variable->GetFlags() & ECVF_SetByMask) != ECVF_SetByConstructor)
	{
		ApplyPostProcessQuality(Variable->GetInt());
	}
}

TAutoConsoleVariable<int32> CVarPostProcessQuality(TEXT("sg.PostProcessQuality"), 3,
	TEXT("Sets the console variables of post processing together, as scalability does: who sets one of them by\n"
		 "config, command line or console beats it.\n")
		TEXT("0: low. 1: medium. 2: high. 3: epic. 4: cinematic. Until it is set, every variable has its own default."),
	FConsoleVariableDelegate::CreateStatic(&OnPostProcessQualityChanged), ECVF_ScalabilityGroup);

} // namespace

const std::vector<FScalabilityRow>& GetPostProcessQualityRows()
{
	static const std::vector<FScalabilityRow> Rows = {
		{"r.MotionBlurQuality", {"0", "3", "3", "4", "4"}},
		{"r.MotionBlur.HalfResGather", {"1", "1", "1", "0", "0"}},
		{"r.AmbientOcclusionMipLevelFactor", {"1.0", "1.0", "0.6", "0.4", "0.4"}},
		{"r.AmbientOcclusionMaxQuality", {"0", "60", "100", "100", "100"}},
		{"r.AmbientOcclusionLevels", {"0", "-1", "-1", "-1", "-1"}},
		{"r.AmbientOcclusionRadiusScale", {"1.2", "1.5", "1.5", "1.0", "1.0"}},
		{"r.DepthOfFieldQuality", {"0", "1", "2", "2", "4"}},
		{"r.RenderTargetPoolMin", {"300", "350", "400", "400", "1000"}},
		{"r.LensFlareQuality", {"0", "0", "2", "2", "3"}},
		{"r.SceneColorFringeQuality", {"0", "0", "1", "1", "1"}},
		{"r.EyeAdaptationQuality", {"2", "2", "2", "2", "2"}},
		{"r.BloomQuality", {"4", "4", "5", "5", "5"}},
		{"r.FastBlurThreshold", {"0", "2", "3", "100", "100"}},
		{"r.Upscale.Quality", {"1", "2", "2", "3", "3"}},
		{"r.Tonemapper.GrainQuantization", {"0", "0", "1", "1", "1"}},
		{"r.LightShaftQuality", {"0", "0", "1", "1", "1"}},
		{"r.Filter.SizeScale", {"0.6", "0.7", "0.8", "1", "1"}},
		{"r.Tonemapper.Quality", {"0", "2", "5", "5", "5"}},
		{"r.DOF.Gather.ResolutionDivisor", {"2", "2", "2", "2", "1"}},
		{"r.DOF.Gather.AccumulatorQuality", {"0", "0", "0", "1", "1"}},
		{"r.DOF.Gather.PostfilterMethod", {"2", "2", "2", "1", "1"}},
		{"r.DOF.Gather.EnableBokehSettings", {"0", "0", "0", "0", "1"}},
		{"r.DOF.Gather.RingCount", {"3", "3", "4", "4", "5"}},
		{"r.DOF.Scatter.ForegroundCompositing", {"0", "0", "1", "1", "1"}},
		{"r.DOF.Scatter.BackgroundCompositing", {"0", "0", "1", "2", "2"}},
		{"r.DOF.Scatter.EnableBokehSettings", {nullptr, nullptr, "0", "0", "1"}},
		{"r.DOF.Scatter.MaxSpriteRatio", {nullptr, nullptr, "0.04", "0.1", "0.25"}},
		{"r.DOF.Recombine.Quality", {"0", "0", "0", "1", "2"}},
		{"r.DOF.Recombine.EnableBokehSettings", {nullptr, nullptr, nullptr, "0", "1"}},
		{"r.DOF.TemporalAAQuality", {"0", "0", "0", "1", "1"}},
		{"r.DOF.Kernel.MaxForegroundRadius", {"0.006", "0.006", "0.012", "0.025", "0.025"}},
		{"r.DOF.Kernel.MaxBackgroundRadius", {"0.006", "0.006", "0.012", "0.025", "0.025"}},
	};
	return Rows;
}

void ApplyPostProcessQuality(int32 Level)
{
	const size_t Index = static_cast<size_t>(std::clamp(Level, 0, NumScalabilityLevels - 1));
	for (const FScalabilityRow& Row : GetPostProcessQualityRows())
	{
		IConsoleVariable* Variable = IConsoleManager::Get().FindConsoleVariable(Row.Variable);
		if (Variable != nullptr && Row.Values[Index] != nullptr)
		{
			Variable->Set(Row.Values[Index], ECVF_SetByScalability);
		}
	}
}

} // namespace Drydock
