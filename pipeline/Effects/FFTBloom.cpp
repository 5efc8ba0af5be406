// Bloom by convolution with a kernel's picture, in place of the Gaussian sum. Source: engine
// PostProcess/PostProcessFFTBloom.cpp (conditions); the wording is drydock's.
#include "Bloom/PostProcessFFTBloom.h"

#include "Effects/Bloom.h"
#include "Text/TextFormat.h"

namespace Drydock
{

namespace
{

constexpr FSettingClaim FFTBloomSettings[] = {
	{"BloomMethod"},
	{"BloomConvolution"},
	{"BloomConvolutionIntensity", "it came with engine 5.6, whose convolution bloom is not simulated"},
};

FEffectDecision DecideFFTBloom(const FEffect&, const FEffectInputs& Inputs)
{
	FEffectDecision Decision;
	const FFinalPostProcessSettings& Values = Inputs.Settings;
	const std::string NoBloom = FindNoBloomReason(Inputs);
	if (Values.BloomMethod != BM_FFT)
	{
		Decision.Reason = "BloomMethod is BM_SOG";
	}
	else if (!NoBloom.empty())
	{
		Decision.Reason = "there is no bloom: " + NoBloom;
	}
	else if (const std::string Obstacle = GetFFTBloomObstacle(Values, true); !Obstacle.empty())
	{
		Decision.Reason = Obstacle + ": the Gaussian sum runs";
	}
	else
	{
		Decision.bActive = Decision.bConfigured = true;
		Decision.Reason = "BloomMethod is BM_FFT, BloomConvolutionScatterDispersion " +
						  NumberText(Values.BloomConvolutionScatterDispersion);
	}
	return Decision;
}

} // namespace

const FEffect GFFTBloomEffect{
	.Id = EEffect::FFTBloom,
	.Name = "FFTBloom",
	.Doc = "Bloom by convolution with the picture of a lens.",
	.Settings = FFTBloomSettings,
	.bMayBrightenBeforeBloom = false,
	.Decide = &DecideFFTBloom,
	.Content = FContentGate{},
	.Complete = nullptr,
	.GetPlace =
		[] {
			return FChainPlace{EChainPlace::Bloom, 1};
		},
	.AddPasses = nullptr,
	.Measurement = FMeasurement{},
};

} // namespace Drydock
