// White balance, and the ranges of colour grading with the global values in them. Source: CIE 15, Krystek 1985; engine
// file PostProcessCombineLUTs.cpp (meaning).
#include "Tonemap/ColorGrading.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

/** In the CIE 1931 diagram. */
struct FChromaticity
{
	double X;
	double Y;
};

constexpr FChromaticity D65{0.3127, 0.3290};
constexpr double NeutralTemperature = 6500.0;

/** Linear Rec.709 to XYZ, from the primaries of ITU-R BT.709 and D65. */
const FColorMatrix& GetRec709ToXYZ()
{
	static const FColorMatrix Matrix = {{{0.4123907993, 0.3575843394, 0.1804807884},
		{0.2126390059, 0.7151686788, 0.0721923154}, {0.0193308187, 0.1191947798, 0.9505321522}}};
	return Matrix;
}

/** Chromaticity of phase D of daylight. The polynomials are for the temperatures of 1968, before c2 was 1.4388. */
FChromaticity GetDaylight(double Temperature)
{
	const double T = Temperature * 1.4388 / 1.438;
	const double X = T <= 7000.0 ? 0.244063 + (0.09911e3 + (2.9678e6 - 4.6070e9 / T) / T) / T
								 : 0.237040 + (0.24748e3 + (1.9018e6 - 2.0064e9 / T) / T) / T;
	return {X, -3.0 * X * X + 2.87 * X - 0.275};
}

/** Place of a black body in the CIE 1960 diagram, and the direction in which it moves as the temperature rises. */
struct FPlanckian
{
	double U;
	double V;
	double DirectionU;
	double DirectionV;
};

FPlanckian GetPlanckian(double T)
{
	const double NumeratorU = 0.860117757 + 1.54118254e-4 * T + 1.28641212e-7 * T * T;
	const double DenominatorU = 1.0 + 8.42420235e-4 * T + 7.08145163e-7 * T * T;
	const double NumeratorV = 0.317398726 + 4.22806245e-5 * T + 4.20481691e-8 * T * T;
	const double DenominatorV = 1.0 - 2.89741816e-5 * T + 1.61456053e-7 * T * T;
	const auto Derive = [](double N, double D, double SlopeN, double SlopeD)
	{
		return (SlopeN * D - N * SlopeD) / (D * D);
	};
	const double SlopeU = Derive(
		NumeratorU, DenominatorU, 1.54118254e-4 + 2.0 * 1.28641212e-7 * T, 8.42420235e-4 + 2.0 * 7.08145163e-7 * T);
	const double SlopeV = Derive(
		NumeratorV, DenominatorV, 4.22806245e-5 + 2.0 * 4.20481691e-8 * T, -2.89741816e-5 + 2.0 * 1.61456053e-7 * T);
	const double Length = std::hypot(SlopeU, SlopeV);
	return {NumeratorU / DenominatorU, NumeratorV / DenominatorV, SlopeU / Length, SlopeV / Length};
}

FChromaticity FromUV(double U, double V)
{
	const double D = 2.0 * U - 8.0 * V + 4.0;
	return {3.0 * U / D, 2.0 * V / D};
}

/** White under a light of this temperature, moved across the black bodies' line by the tint. */
FChromaticity GetWhite(double Temperature, double Tint)
{
	const FPlanckian Planckian = GetPlanckian(Temperature);
	const FChromaticity BlackBody = FromUV(Planckian.U, Planckian.V);
	const FChromaticity Light = Temperature < 4000.0 ? BlackBody : GetDaylight(Temperature);
	const double Distance = 0.05 * Tint;
	const FChromaticity Shifted =
		FromUV(Planckian.U - Distance * Planckian.DirectionV, Planckian.V + Distance * Planckian.DirectionU);
	return {Light.X + Shifted.X - BlackBody.X, Light.Y + Shifted.Y - BlackBody.Y};
}

/** A range's value with the global one: both X, Y, Z, and W for all three. */
FVector3f Combine(const FVector4& Global, const FVector4& Range)
{
	const double Both = Global.W * Range.W;
	return FVector3f(static_cast<float>(Global.X * Range.X * Both), static_cast<float>(Global.Y * Range.Y * Both),
		static_cast<float>(Global.Z * Range.Z * Both));
}

FVector3f CombineOffset(const FVector4& Global, const FVector4& Range)
{
	const double Both = Global.W + Range.W;
	return FVector3f(static_cast<float>(Global.X + Range.X + Both), static_cast<float>(Global.Y + Range.Y + Both),
		static_cast<float>(Global.Z + Range.Z + Both));
}

bool AreAll(const std::array<FVector3f, 3>& Values, float Wanted)
{
	return std::all_of(Values.begin(), Values.end(),
		[&](const FVector3f& Value) { return Value.X == Wanted && Value.Y == Wanted && Value.Z == Wanted; });
}

} // namespace

FColorMatrix ComputeWhiteBalance(double Temperature, double Tint, ETemperatureMethod Method)
{
	if (Temperature == NeutralTemperature && Tint == 0.0)
	{
		return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
	}
	const FChromaticity Light = GetWhite(std::clamp(Temperature, 1500.0, 15000.0), Tint);
	const FColorVector White = MakeWhite(D65.X, D65.Y), Lit = MakeWhite(Light.X, Light.Y);
	const FColorMatrix Adaptation =
		Method == TEMP_ColorTemperature ? MakeAdaptation(White, Lit) : MakeAdaptation(Lit, White);
	return Multiply(Invert(GetRec709ToXYZ()), Multiply(Adaptation, GetRec709ToXYZ()));
}

FColorGrading MakeColorGrading(const FPostProcessSettings& Settings)
{
	FColorGrading Grading;
	Grading.WhiteBalance = ComputeWhiteBalance(Settings.WhiteTemp, Settings.WhiteTint, Settings.TemperatureType);
	Grading.Saturation = {Combine(Settings.ColorSaturation, Settings.ColorSaturationShadows),
		Combine(Settings.ColorSaturation, Settings.ColorSaturationMidtones),
		Combine(Settings.ColorSaturation, Settings.ColorSaturationHighlights)};
	Grading.Contrast = {Combine(Settings.ColorContrast, Settings.ColorContrastShadows),
		Combine(Settings.ColorContrast, Settings.ColorContrastMidtones),
		Combine(Settings.ColorContrast, Settings.ColorContrastHighlights)};
	Grading.Gamma = {Combine(Settings.ColorGamma, Settings.ColorGammaShadows),
		Combine(Settings.ColorGamma, Settings.ColorGammaMidtones),
		Combine(Settings.ColorGamma, Settings.ColorGammaHighlights)};
	Grading.Gain = {Combine(Settings.ColorGain, Settings.ColorGainShadows),
		Combine(Settings.ColorGain, Settings.ColorGainMidtones),
		Combine(Settings.ColorGain, Settings.ColorGainHighlights)};
	Grading.Offset = {CombineOffset(Settings.ColorOffset, Settings.ColorOffsetShadows),
		CombineOffset(Settings.ColorOffset, Settings.ColorOffsetMidtones),
		CombineOffset(Settings.ColorOffset, Settings.ColorOffsetHighlights)};
	Grading.ShadowsMax = Settings.ColorCorrectionShadowsMax;
	Grading.HighlightsMin = Settings.ColorCorrectionHighlightsMin;
	Grading.HighlightsMax = Settings.ColorCorrectionHighlightsMax;
	Grading.bNeutral = Settings.WhiteTemp == static_cast<float>(NeutralTemperature) && Settings.WhiteTint == 0.0f &&
					   AreAll(Grading.Saturation, 1.0f) && AreAll(Grading.Contrast, 1.0f) &&
					   AreAll(Grading.Gamma, 1.0f) && AreAll(Grading.Gain, 1.0f) && AreAll(Grading.Offset, 0.0f);
	return Grading;
}

} // namespace Drydock
