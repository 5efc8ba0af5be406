// Console variables of the engine's post processing that nothing in drydock reads: known by name, type and default, so
// that a project's settings and the presets of Scalability.cpp are understood; setting one warns. When a pass registers
// one of these names, that registration takes its place and the row here may go. Source: engine (names, defaults,
// meanings, as publicly documented).
#include "HAL/IConsoleManager.h"

namespace
{

constexpr EConsoleVariableFlags Plain = ECVF_NotSimulated;
const EConsoleVariableFlags Scaled = ECVF_NotSimulated | ECVF_Scalability;

const FAutoConsoleVariable NotSimulated[] = {
	{TEXT("r.AmbientOcclusionLevels"), -1, TEXT("Not simulated. Mips of ambient occlusion; -1: chosen by the engine."),
		Scaled},
	{TEXT("r.AmbientOcclusionMaxQuality"), 100.0f, TEXT("Not simulated. Limit on AmbientOcclusionQuality, percent."),
		Scaled},
	{TEXT("r.AmbientOcclusionMipLevelFactor"), 0.5f, TEXT("Not simulated. Which mips of the depth are sampled."),
		Scaled},
	{TEXT("r.AmbientOcclusionRadiusScale"), 1.0f, TEXT("Not simulated. Factor on the radius."), Scaled},
	{TEXT("r.CustomDepth"), 1, TEXT("Not simulated. Custom depth: 0 off, 1 on, 3 with stencil."), Plain},
	{TEXT("r.DOF.Gather.AccumulatorQuality"), 1, TEXT("Not simulated. Quality of the gathering: 0 low, 1 high."),
		Scaled},
	{TEXT("r.DOF.Gather.EnableBokehSettings"), 1, TEXT("Not simulated. Bokeh shape while gathering: 0 off, 1 on."),
		Scaled},
	{TEXT("r.DOF.Gather.PostfilterMethod"), 1, TEXT("Not simulated. 0 none, 1 median of 3x3, 2 maximum of 3x3."),
		Scaled},
	{TEXT("r.DOF.Gather.ResolutionDivisor"), 2, TEXT("Not simulated. Gathering at 1/1 or 1/2 resolution."), Scaled},
	{TEXT("r.DOF.Gather.RingCount"), 5, TEXT("Not simulated. Rings of the gathering kernel, 3 to 5."), Scaled},
	{TEXT("r.DOF.Recombine.EnableBokehSettings"), 1, TEXT("Not simulated. Bokeh shape in slight out-of-focus: 0, 1."),
		Scaled},
	{TEXT("r.DOF.Recombine.Quality"), 2, TEXT("Not simulated. Slight out-of-focus at full resolution: 0 to 2."),
		Scaled},
	{TEXT("r.DOF.Scatter.BackgroundCompositing"), 2, TEXT("Not simulated. Scattered background: 0 off, 1, 2."), Scaled},
	{TEXT("r.DOF.Scatter.EnableBokehSettings"), 1, TEXT("Not simulated. Bokeh shape while scattering: 0 off, 1 on."),
		Scaled},
	{TEXT("r.DOF.Scatter.ForegroundCompositing"), 1, TEXT("Not simulated. Scattered foreground: 0 off, 1 on."), Scaled},
	{TEXT("r.DOF.Scatter.MaxSpriteRatio"), 0.1f, TEXT("Not simulated. Largest part of pixels that is scattered."),
		Scaled},
	{TEXT("r.DOF.TemporalAAQuality"), 1, TEXT("Not simulated. Temporal stabilisation of the inputs: 0, 1."), Scaled},
	{TEXT("r.EyeAdaptation.PreExposureOverride"), 0.0f, TEXT("Not simulated: see view.preExposure of a config."),
		Plain},
	{TEXT("r.GBufferFormat"), 1, TEXT("Not simulated. Precision of the G-buffer."), Plain},
	{TEXT("r.Histogram.UseAtomic"), 1, TEXT("Not simulated. How the GPU counts the histogram."), Plain},
	{TEXT("r.LensFlareQuality"), 2, TEXT("Not simulated. Lens flares: 0 off, 1 low, 2 good, 3 very good."), Scaled},
	{TEXT("r.LightShaftQuality"), 1, TEXT("Not simulated. Light shafts: 0 off, 1 on."), Scaled},
	{TEXT("r.MotionBlur.HalfResGather"), 0, TEXT("Not simulated. Long blurs at half resolution: 0 off, 1 on."), Scaled},
	{TEXT("r.PostProcessing.PropagateAlpha"), 0, TEXT("Not simulated. 1: alpha goes through the whole chain."), Plain},
	{TEXT("r.PostProcessing.QuarterResolutionDownsample"), 0,
		TEXT("Not simulated. 1: the downsample chain starts at a quarter of the resolution."), Scaled},
	{TEXT("r.RenderTargetPoolMin"), 400, TEXT("Not simulated. Size of the GPU's pool of targets, MB."), Scaled},
	{TEXT("r.SceneColorFormat"), 4, TEXT("Not simulated: the scene file's format holds."), Scaled},
	{TEXT("r.SSR.HalfResSceneColor"), 0, TEXT("Not simulated. 1: reflections read the half-resolution colour."),
		Scaled},
	{TEXT("r.Tonemapper.GrainQuantization"), 1, TEXT("Not simulated. Dither of the 8-bit output: 0 off, 1 on."),
		Scaled},
};

} // namespace
