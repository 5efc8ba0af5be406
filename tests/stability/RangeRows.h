// What is stated of settings that span a range together, or with a fixed end: where the range is empty, inverted or far
// away. One line to a case; RangeTest.cpp runs them in the frames of SweepScene.h.
#pragma once

namespace Stability
{

struct FRangeCase
{
	/** The settings that make it. */
	const char* Range;
	const char* Kind;
	/** Assignments, separated by blanks. */
	const char* Given;
	/** Others, whose pictures have the same bits; empty: only that all is finite and the final picture within 0..1. */
	const char* As;
	/** In words. */
	const char* Result;
	/** Convolution bloom and basic metering, not the sum of Gaussians and the histogram. */
	bool bPrinted = false;
};

inline constexpr FRangeCase RangeCases[] = {
	{"HistogramLogMin .. HistogramLogMax", "empty", "HistogramLogMin=2 HistogramLogMax=2",
		"HistogramLogMin=1 HistogramLogMax=2", "the 1 below its upper end"},
	{"HistogramLogMin .. HistogramLogMax", "inverted", "HistogramLogMin=4 HistogramLogMax=-3",
		"HistogramLogMin=-4 HistogramLogMax=-3", "the 1 below its upper end"},
	{"HistogramLogMin .. HistogramLogMax", "far below", "HistogramLogMax=-1e9",
		"HistogramLogMin=-60 HistogramLogMax=-59", "-60 .. -59"},
	{"HistogramLogMin .. HistogramLogMax", "far above", "HistogramLogMin=1e38 HistogramLogMax=1e38",
		"HistogramLogMin=59 HistogramLogMax=60", "59 .. 60"},
	{"HistogramLogMin .. HistogramLogMax", "wide", "HistogramLogMin=-1e38 HistogramLogMax=1e38",
		"HistogramLogMin=-60 HistogramLogMax=60", "-60 .. 60"},
	{"AutoExposureMinBrightness .. AutoExposureMaxBrightness", "empty",
		"AutoExposureMinBrightness=2 AutoExposureMaxBrightness=2",
		"AutoExposureMinBrightness=2 AutoExposureMaxBrightness=2 AutoExposureLowPercent=45",
		"that brightness, whatever is metered"},
	{"AutoExposureMinBrightness .. AutoExposureMaxBrightness", "inverted",
		"AutoExposureMinBrightness=5 AutoExposureMaxBrightness=1",
		"AutoExposureMinBrightness=5 AutoExposureMaxBrightness=5", "AutoExposureMinBrightness alone"},
	{"AutoExposureMinBrightness .. AutoExposureMaxBrightness", "below 0",
		"AutoExposureMinBrightness=-2 AutoExposureMaxBrightness=-1",
		"AutoExposureMinBrightness=0 AutoExposureMaxBrightness=0", "0, both"},
	{"AutoExposureLowPercent .. AutoExposureHighPercent", "empty",
		"AutoExposureLowPercent=50 AutoExposureHighPercent=50", "AutoExposureLowPercent=80 AutoExposureHighPercent=80",
		"nothing is metered: an average luminance of 1"},
	{"AutoExposureLowPercent .. AutoExposureHighPercent", "inverted",
		"AutoExposureLowPercent=80 AutoExposureHighPercent=20", "AutoExposureLowPercent=80 AutoExposureHighPercent=80",
		"as an empty one"},
	{"AutoExposureLowPercent .. AutoExposureHighPercent", "outside 0..100",
		"AutoExposureLowPercent=-50 AutoExposureHighPercent=200", "AutoExposureLowPercent=1 AutoExposureHighPercent=99",
		"1 .. 99"},
	{"ColorCorrectionHighlightsMin .. ColorCorrectionHighlightsMax", "empty",
		"ColorCorrectionHighlightsMin=0.5 ColorCorrectionHighlightsMax=0.5",
		"ColorCorrectionHighlightsMin=0.5 ColorCorrectionHighlightsMax=0.50000006", "a step"},
	{"ColorCorrectionHighlightsMin .. ColorCorrectionHighlightsMax", "inverted",
		"ColorCorrectionHighlightsMin=1 ColorCorrectionHighlightsMax=0.5", "",
		"the weight falls from the upper end on: highlights are what is dark"},
	{"0 .. ColorCorrectionShadowsMax", "empty", "ColorCorrectionShadowsMax=0", "ColorCorrectionShadowsMax=1e-37",
		"black alone is shadow"},
	{"0 .. ColorCorrectionShadowsMax", "inverted", "ColorCorrectionShadowsMax=-0.5", "ColorCorrectionShadowsMax=1e30",
		"all is shadow"},
	{"FilmGrainHighlightsMin .. FilmGrainHighlightsMax", "empty",
		"FilmGrainHighlightsMin=0.5 FilmGrainHighlightsMax=0.5",
		"FilmGrainHighlightsMin=0.5 FilmGrainHighlightsMax=0.50000006", "a step"},
	{"FilmGrainHighlightsMin .. FilmGrainHighlightsMax", "inverted",
		"FilmGrainHighlightsMin=1 FilmGrainHighlightsMax=0.5", "",
		"the weight falls from the upper end on: highlights are what is dark"},
	{"0 .. FilmGrainShadowsMax", "empty", "FilmGrainShadowsMax=0", "FilmGrainShadowsMax=1e-37",
		"black alone is shadow"},
	{"0 .. FilmGrainShadowsMax", "inverted", "FilmGrainShadowsMax=-0.5", "FilmGrainShadowsMax=1e30", "all is shadow"},
	{"BloomConvolutionPreFilterMin .. BloomConvolutionPreFilterMax", "empty",
		"BloomConvolutionPreFilterMin=1 BloomConvolutionPreFilterMax=1",
		"BloomConvolutionPreFilterMin=1e30 BloomConvolutionPreFilterMax=2e30", "no pixel is boosted", true},
	{"BloomConvolutionPreFilterMin .. BloomConvolutionPreFilterMax", "inverted",
		"BloomConvolutionPreFilterMin=9 BloomConvolutionPreFilterMax=1",
		"BloomConvolutionPreFilterMin=1e30 BloomConvolutionPreFilterMax=2e30", "no pixel is boosted", true},
	{"DepthOfFieldMinFstop .. DepthOfFieldFstop", "empty", "DepthOfFieldMinFstop=2 DepthOfFieldFstop=2",
		"DepthOfFieldMinFstop=2 DepthOfFieldFstop=2 DepthOfFieldBladeCount=9", "a disc: the blades do not show"},
	{"DepthOfFieldMinFstop .. DepthOfFieldFstop", "inverted", "DepthOfFieldMinFstop=5 DepthOfFieldFstop=2",
		"DepthOfFieldMinFstop=2 DepthOfFieldFstop=2", "as an empty one"},
	{"0 .. DepthOfFieldDepthBlurAmount", "empty", "DepthOfFieldDepthBlurAmount=0", "DepthOfFieldDepthBlurAmount=1e-5",
		"one centimetre"},
	{"0 .. DepthOfFieldDepthBlurAmount", "inverted", "DepthOfFieldDepthBlurAmount=-1",
		"DepthOfFieldDepthBlurAmount=1e-5", "one centimetre"},
	{"REDDofFocalDistance + REDDofFocalRegion", "inverted", "REDDofFocalRegion=-300", "",
		"what lies behind is blurred from before the focus on"},
	{"REDDofNearTransition", "empty", "REDDofNearTransition=0", "REDDofNearTransition=1e-25", "a step"},
	{"REDDofNearTransition", "inverted", "REDDofNearTransition=-100", "REDDofNearTransition=0", "as an empty one"},
	{"REDDofFarTransition", "empty", "REDDofFarTransition=0", "REDDofFarTransition=1e-25", "a step"},
	{"REDDofFarTransition", "inverted", "REDDofFarTransition=-100", "REDDofFarTransition=0", "as an empty one"},
	{"UnityBloomThreshold - UnityBloomSoftKnee", "empty", "UnityBloomSoftKnee=0", "UnityBloomSoftKnee=1e-30",
		"a sharp threshold"},
	{"UnityBloomThreshold - UnityBloomSoftKnee", "inverted", "UnityBloomSoftKnee=-1", "UnityBloomSoftKnee=0",
		"a sharp threshold"},
	{"ChromaticAberrationStartOffset .. 1", "empty", "ChromaticAberrationStartOffset=1",
		"ChromaticAberrationStartOffset=2", "no fringe"},
};

} // namespace Stability
