// Vignette, fringe, sharpening, grain and dithering out of the settings. Source: engine file PostProcessTonemap.cpp.
#include "Tonemap/TonemapLens.h"

#include "HAL/IConsoleManager.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

TAutoConsoleVariable<float> CVarSharpen(TEXT("r.Tonemapper.Sharpen"), -1.0f,
	TEXT("Sharpening in the tonemapper, 0 to 10; below 0: the setting's (default)."),
	ECVF_Scalability | ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarFilmGrain(
	TEXT("r.FilmGrain"), 1, TEXT("Film grain: 0 off, 1 on (default)."), ECVF_Scalability | ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarFilmGrainSequenceLength(TEXT("r.FilmGrain.SequenceLength"), 97,
	TEXT("Frames after which the grain repeats; 97 by default."), ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarGrainQuantization(TEXT("r.Tonemapper.GrainQuantization"), 0,
	TEXT("Noise of up to half a code before an output is rounded to 8 or 10 bits: 0 off (default; the engine's is 1), "
		 "1 on."),
	ECVF_Scalability | ECVF_RenderThreadSafe);

} // namespace

FVector2f ComputeVignetteScale(FIntPoint ViewSize)
{
	const float HeightOverWidth = static_cast<float>(ViewSize.Y) / static_cast<float>(ViewSize.X);
	const float Scale = std::sqrt(2.0f) / std::sqrt(1.0f + HeightOverWidth * HeightOverWidth);
	return FVector2f(Scale, Scale * HeightOverWidth);
}

FVector4f ComputeChromaticAberration(float Intensity, float StartOffset)
{
	constexpr float Red = 611.3f, Green = 549.1f, Blue = 464.3f; // nm
	const float Strength = StartOffset < 1.0f - 1e-4f ? 0.01f * Intensity / (1.0f - StartOffset) : 0.0f;
	return FVector4f(Strength * 0.007f * (Red - Blue), Strength * 0.007f * (Green - Blue), StartOffset, 0.0f);
}

bool HasChromaticAberration(const FPostProcessSettings& Settings)
{
	return Settings.SceneFringeIntensity > 0.01f;
}

float GetSharpenAmount(const FPostProcessSettings& Settings)
{
	const float Variable = CVarSharpen.GetValueOnAnyThread();
	return Variable < 0.0f ? Settings.Sharpen : std::clamp(Variable, 0.0f, 10.0f);
}

FFilmGrain MakeFilmGrain(const FPostProcessSettings& Settings, uint32 FrameNumber)
{
	// Smaller grains than this would only be other noise, and 0 none at all.
	const float TexelSize = std::max(Settings.FilmGrainTexelSize, 1.0f / 64.0f);
	const int32 Length = std::max(CVarFilmGrainSequenceLength.GetValueOnAnyThread(), 1);
	FFilmGrain Grain;
	Grain.Intensities = FVector3f(Settings.FilmGrainIntensityShadows, Settings.FilmGrainIntensityMidtones,
							Settings.FilmGrainIntensityHighlights) *
						Settings.FilmGrainIntensity;
	Grain.Ranges = FVector4f(Settings.FilmGrainShadowsMax, Settings.FilmGrainHighlightsMin,
		Settings.FilmGrainHighlightsMax, 1.0f / TexelSize);
	Grain.Frame = FrameNumber % static_cast<uint32>(Length);
	return Grain;
}

bool HasFilmGrain(const FPostProcessSettings& Settings)
{
	return Settings.FilmGrainIntensity > 0.0f && CVarFilmGrain.GetValueOnAnyThread() != 0;
}

float GetGrainQuantizationStep(EPixelFormat OutputFormat)
{
	if (CVarGrainQuantization.GetValueOnAnyThread() == 0)
	{
		return 0.0f;
	}
	switch (OutputFormat)
	{
	case PF_B8G8R8A8:
	case PF_R8G8B8A8:
		return 1.0f / 255.0f;
	case PF_A2B10G10R10:
		return 1.0f / 1023.0f;
	default:
		return 0.0f;
	}
}

} // namespace Drydock
