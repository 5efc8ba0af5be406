// How the rows of metering, adaptation and local exposure are run, and their formulas.
#include "Runs.h"

#include "Cases.h"
#include "passes/ExposureTestUtils.h"

#include "Bloom/PostProcessBloomSetup.h"
#include "Exposure/PostProcessExposureCurve.h"
#include "Exposure/PostProcessLocalExposure.h"
#include "SettingObjects.h"

#include <cmath>

using namespace Drydock;

namespace Stability
{

namespace
{

constexpr double FirstScale = 0.25; // of the frame before the first

/** Black counts, so that the buckets of a picture sum to 1. */
class FBlackCounts
{
	PassTest::FScopedConsoleVariable Influence{TEXT("r.EyeAdaptation.BlackHistogramBucketInfluence"), 1.0f};
};

PassTest::FMeteringRun MakeRun(const FCase& Case, const PassTest::FMetering& Metering)
{
	const FIntPoint Extent(
		Case.Offset.X + Case.Image.Width + Case.Padding.X, Case.Offset.Y + Case.Image.Height + Case.Padding.Y);
	return PassTest::FMeteringRun(Case.Image,
		{Case.Offset.X, Case.Offset.Y, Case.Offset.X + Case.Image.Width, Case.Offset.Y + Case.Image.Height}, Extent,
		Metering);
}

FImage ExecuteAndRead(FRDGBuilder& GraphBuilder, FRDGBufferRef EyeAdaptation)
{
	FRHIGPUBufferReadback Readback(TEXT("EyeAdaptation"));
	AddEnqueueCopyPass(GraphBuilder, &Readback, EyeAdaptation, EyeAdaptation->Desc.GetSize());
	GraphBuilder.Execute();
	const FVector4f Entry = *static_cast<const FVector4f*>(Readback.Lock(sizeof(FVector4f)));
	Readback.Unlock();
	return FImage(1, 1, {Entry.X, Entry.Y, Entry.Z, 1});
}

/** 64 x 1: the buckets, numbers laid out as a picture. */
FImage RunHistogram(const FCase& Case)
{
	const FBlackCounts BlackCounts;
	const auto Buckets = MakeRun(Case, {}).GetHistogram();
	return FImage::Make(64, 1, [&](int X, int) { return FTexel{Buckets[X], Buckets[X], Buckets[X], 1}; });
}

/** Counted texel by texel, range -8 to 4 EV. */
FImage HistogramFormula(const FCase& Case)
{
	std::vector<double> Buckets(64);
	for (const FTexel& Texel : Case.Image.Texels)
	{
		const double Mean = (Texel[0] + Texel[1] + Texel[2]) / 3;
		if (std::isnan(Mean))
		{
			continue;
		}
		const double Luminance = std::max(std::clamp(Mean, 0.0, 65536.0), 1e-10);
		const double Position = std::clamp((std::log2(Luminance) + 8) / 12, 0.0, 1.0) * 63;
		const int First = std::min(static_cast<int>(Position), 62);
		Buckets[First] += (1 - (Position - First)) / static_cast<double>(Case.Image.Texels.size());
		Buckets[First + 1] += (Position - First) / static_cast<double>(Case.Image.Texels.size());
	}
	return FImage::Make(64, 1, [&](int X, int) { return FTexel{Buckets[X], Buckets[X], Buckets[X], 1}; });
}

/** 1 x 1: scale, target, average. Variants: histogram, basic. Frames: so many of 1/60 s. */
FImage RunEyeAdaptation(const FCase& Case)
{
	PassTest::FMetering Metering;
	Metering.Method = Case.Variant == 0 ? AEM_Histogram : AEM_Basic;
	Metering.LastScale = static_cast<float>(FirstScale);
	if (Case.Frames == 1)
	{
		const FVector4f Entry = MakeRun(Case, Metering).GetEyeAdaptation()[0];
		return FImage(1, 1, {Entry.X, Entry.Y, Entry.Z, 1});
	}
	// All frames see one flat picture, in one graph.
	PassTest::FMeteringRun Metered(PassTest::Grey(0.25), Metering);
	FRDGBuilder& GraphBuilder = Metered.Run.GraphBuilder;
	const FViewInfo& View = Metered.Run.View;
	FEyeAdaptationInputs Inputs;
	Inputs.Parameters = Metered.Parameters;
	Inputs.LastEyeAdaptationBuffer = CreateEyeAdaptationBuffer(GraphBuilder, *Metering.LastScale);
	const FRDGTextureRef Histogram = AddHistogramPass(GraphBuilder, View, Inputs.Parameters, Metered.Run.Input);
	const FScreenPassTexture Setup =
		AddBasicEyeAdaptationSetupPass(GraphBuilder, View, Inputs.Parameters, Metered.Run.Input);
	for (int Frame = 0; Frame < Case.Frames; ++Frame)
	{
		Inputs.LastEyeAdaptationBuffer = Case.Variant == 0
											 ? AddHistogramEyeAdaptationPass(GraphBuilder, View, Inputs, Histogram)
											 : AddBasicEyeAdaptationPass(GraphBuilder, View, Inputs, Setup);
	}
	return ExecuteAndRead(GraphBuilder, Inputs.LastEyeAdaptationBuffer);
}

/** Settled: 2^1 * 0.18 / 0.25, the bias of the default settings being 1 EV. */
FImage EyeAdaptationFormula(const FCase&)
{
	return FImage(1, 1, {2 * 0.18 / 0.25, 2 * 0.18 / 0.25, 0.25, 1});
}

FImage RunExposureCurve(const FCase& Case)
{
	PassTest::FMeteringRun Metered = MakeRun(Case, {});
	FRDGBuilder& GraphBuilder = Metered.Run.GraphBuilder;
	const FViewInfo& View = Metered.Run.View;
	FEyeAdaptationInputs Inputs;
	Inputs.Parameters = Metered.Parameters;
	Inputs.Parameters.ForceTarget = 1.0f;
	Inputs.LastEyeAdaptationBuffer = CreateEyeAdaptationBuffer(GraphBuilder, 1.0f);
	const FRDGTextureRef Histogram = AddHistogramPass(GraphBuilder, View, Inputs.Parameters, Metered.Run.Input);
	FFinalPostProcessSettings Settings;
	Settings.AutoExposureBiasCurve = FindOrAddCurve("linear(-20 1000, 20 -1000)");
	return ExecuteAndRead(GraphBuilder, AddExposureCurvePass(GraphBuilder, Settings,
											AddHistogramEyeAdaptationPass(GraphBuilder, View, Inputs, Histogram)));
}

/** The picture times its factor. Intensity: the contrast of highlights, 0.5; Sigma: kernel in percent, 10. */
FImage RunLocalExposure(const FCase& Case)
{
	FFrameRun Run(Case);
	FFinalPostProcessSettings& Settings = Run.View.FinalPostProcessSettings;
	Settings.LocalExposureHighlightContrastScale = static_cast<float>(Case.Intensity.value_or(0.5));
	Settings.LocalExposureShadowContrastScale = 0.5f;
	Settings.LocalExposureHighlightThreshold = static_cast<float>(Case.Threshold.value_or(0.0));
	FLocalExposureTextures Textures;
	Textures.EyeAdaptation = GetEyeAdaptationParameters(Run.View, AEM_Histogram, true);
	Textures.Parameters =
		GetLocalExposureParameters(Run.View, Run.Input.ViewRect.Size(), Textures.EyeAdaptation, false);
	Textures.BilateralGrid = AddLocalExposurePass(Run.GraphBuilder, Run.View, Textures.EyeAdaptation, Run.Input);
	Textures.BlurredLogLuminance = AddLocalExposureBlurredLogLuminancePass(
		Run.GraphBuilder, Run.View, Textures.EyeAdaptation, Run.Input, static_cast<float>(Case.Sigma.value_or(10.0)));
	FBloomSetupInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(Run.GraphBuilder, 1.0f);
	Inputs.Threshold = -1.0f;
	Textures.GiveTo(Inputs);
	return Run.Execute(AddBloomSetupPass(Run.GraphBuilder, Run.View, Inputs));
}

/** The formula for a flat picture: the base is the mean of the channels, middle grey 0.18, the contrast 0.5 on both
 * sides. */
FImage LocalExposureFormula(const FCase& Case)
{
	const FTexel& Flat = Case.Image.At(0, 0);
	const double Mean = (Flat[0] + Flat[1] + Flat[2]) / 3;
	return FImage(Case.Image.Width, Case.Image.Height, Flat * std::sqrt(0.18 / Mean));
}

const FRunRegistration ExposureRuns({
	{"Histogram", {.Run = RunHistogram, .Formula = HistogramFormula}},
	{"Eye adaptation: histogram, basic", {.Run = RunEyeAdaptation, .Formula = EyeAdaptationFormula, .NumVariants = 2}},
	{"Exposure curve", {.Run = RunExposureCurve}},
	{"Local exposure", {.Run = RunLocalExposure, .Formula = LocalExposureFormula}},
});

} // namespace

} // namespace Stability
