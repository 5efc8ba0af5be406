// Computes colour grading from the settings: white balance as a matrix, and the five operations for shadows, midtones
// and highlights, each including the global one. Pure functions. Source: engine file PostProcessCombineLUTs.cpp
// (meaning); formulas: CIE 15 (daylight), Krystek 1985 (black body), Bradford adaptation.
#pragma once

#include "CoreMinimal.h"
#include "PostProcessSettings.h"
#include "Tonemap/ColorMatrix.h"

#include <array>

namespace Drydock
{

/** The matrix acts on linear Rec.709. TEMP_WhiteBalance: a surface that looks white under a light of Temperature (K)
 * and Tint comes out white. TEMP_ColorTemperature: white comes out as that light. Tint moves along the line of equal
 * temperature, 0.05 of the CIE 1960 diagram for each 1; above 0 the light is more magenta. Below 4000 K the light is a
 * black body, else daylight; the temperature is kept in 1500..15000. 6500 K without tint is exactly the identity. */
DRYDOCK_API FColorMatrix ComputeWhiteBalance(double Temperature, double Tint, ETemperatureMethod Method);

struct FColorGrading
{
	FColorMatrix WhiteBalance = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
	// For shadows, midtones, highlights.
	std::array<FVector3f, 3> Saturation;
	std::array<FVector3f, 3> Contrast;
	std::array<FVector3f, 3> Gamma;
	std::array<FVector3f, 3> Gain;
	std::array<FVector3f, 3> Offset;
	float ShadowsMax = 0.0f;
	float HighlightsMin = 0.0f;
	float HighlightsMax = 0.0f;
	/** Nothing of the above changes a colour. */
	bool bNeutral = true;
};

DRYDOCK_API FColorGrading MakeColorGrading(const FPostProcessSettings& Settings);

} // namespace Drydock
