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

/** The Halton sequence: 0..1, evenly spread. */
double GetHalton(uint32 Index, uint32 Base)
{
	double Result = 0.0;
	for (double Digit = 1.0 / Base; Index > 0; Index /= Base, Digit /= Base)
	{
		Result += Digit * (Index % Base);
	}
	return Result;
}

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

FFilmGrainPicture MakeFilmGrainPicture(const FFilmGrain& Grain, FRHITexture& Picture)
{
	const FIntPoint Size = Picture.GetSizeXY();
	FVector Sum(0.0, 0.0, 0.0);
	for (int32 Y = 0; Y < Size.Y; ++Y)
	{
		for (int32 X = 0; X < Size.X; ++X)
		{
			const FVector4 Texel = Picture.ReadTexelDouble(X, Y);
			const auto Part = [](double Value)
			{
				return std::isfinite(Value) ? std::max(Value, 0.0) : 0.0;
			};
			Sum += FVector(Part(Texel.X), Part(Texel.Y), Part(Texel.Z));
		}
	}
	const auto Invert = [&](double Total)
	{
		return Total > 0.0 ? static_cast<float>(static_cast<double>(Size.X) * Size.Y / Total) : 0.0f;
	};
	const auto Move = [&](uint32 Base, int32 Count)
	{
		return static_cast<float>(std::floor(GetHalton(Grain.Frame + 1, Base) * Count)) / static_cast<float>(Count);
	};
	FFilmGrainPicture Result;
	Result.UVPerPixel =
		FVector2f(Grain.Ranges.W / static_cast<float>(Size.X), Grain.Ranges.W / static_cast<float>(Size.Y));
	Result.UVOffset = FVector2f(Move(2, Size.X), Move(3, Size.Y));
	Result.MeanInverse = FVector3f(Invert(Sum.X), Invert(Sum.Y), Invert(Sum.Z));
	return Result;
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
	return OutputFormat == PF_B8G8R8A8 || OutputFormat == PF_R8G8B8A8 ? 1.0f / 255.0f
		   : OutputFormat == PF_A2B10G10R10                           ? 1.0f / 1023.0f
																	  : 0.0f;
}

} // namespace Drydock
