// Lists findings of `drydock run --check` in the shipped shaders that are not faults, with the reasons: rows of
// docs/stability.md.
#pragma once

namespace Drydock
{

/** A finding in one of drydock's own shaders that is not a fault. `run --check` leaves it out. */
struct FStatedFinding
{
	const char* Check;
	const char* File; // of the shader, without folders
	const char* Reason;
};

inline constexpr FStatedFinding StatedFindings[] = {
	{"nan", "FilmCurve.ush",
		"far from the film curve's toe or shoulder an exponential overflows: one over infinity is the 0 that is meant, "
		"or "
		"the other branch is taken"},
	{"nan", "PostProcessLocalExposureCommon.ush", "an empty cell of the bilateral grid is divided by and not taken"},
	{"nan", "PostProcessEyeAdaptation.usf",
		"the local exposure of the average is computed and not taken where local exposure is off"},
	{"nan", "Common.ush", "device depth 0, of a scene without custom depth, is infinitely far"},
	{"bounds", "SceneTexturesCommon.ush",
		"a scene without custom stencil has a texture of one texel in its place, as in the engine: beyond it is 0"},
	{"nan", "PostProcessMotionBlur.usf",
		"where a pixel stands still, one over its length of 0 is computed and not taken"},
	{"negative", "PostProcessMotionBlur.usf", "velocities have both signs"},
	{"negative", "PostProcessLocalExposure.usf", "logarithms of luminance have both signs"},
	{"negative", "FilterPixelShader.usf", "those logarithms, blurred"},
	{"negative", "PostProcessFFTBloom.usf", "the numbers of a spectrum have both signs"},
	{"denormal", "FilterPixelShader.usf", "a Gaussian's tail fades away through the smallest numbers of a format"},
	{"denormal", "DiaphragmDOF.usf", "the opacity of a layer fades away through the smallest numbers of a format"},
	{"denormal", "PostProcessDownsample.usf", "the edge of such a tail, made smaller"},
	{"denormal", "REDPostProcess.usf", "a blur's tail fades away through the smallest numbers of a format"},
	{"denormal", "UnityBloom.usf", "a blur's tail fades away through the smallest numbers of a format"},
};

} // namespace Drydock
