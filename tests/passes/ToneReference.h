// The film curve in double, from published primaries and formulas. Shares no code or numbers with the shader.
// Sources: ITU-R BT.709, SMPTE ST 2065-1, S-2014-004, Bradford adaptation, ACES 1.0 rendering transform.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace ToneReference
{

using FVec = std::array<double, 3>;
using FMat = std::array<FVec, 3>;

inline FVec Mul(const FMat& M, const FVec& V)
{
	FVec Result{};
	for (int Row = 0; Row < 3; ++Row)
	{
		Result[Row] = M[Row][0] * V[0] + M[Row][1] * V[1] + M[Row][2] * V[2];
	}
	return Result;
}

inline FMat Mul(const FMat& A, const FMat& B)
{
	FMat Result{};
	for (int Row = 0; Row < 3; ++Row)
	{
		for (int Column = 0; Column < 3; ++Column)
		{
			for (int Index = 0; Index < 3; ++Index)
			{
				Result[Row][Column] += A[Row][Index] * B[Index][Column];
			}
		}
	}
	return Result;
}

/** By cofactors. */
inline FMat Inverse(const FMat& M)
{
	const auto Cofactor = [&M](int Row, int Column)
	{
		const int R0 = (Row + 1) % 3, R1 = (Row + 2) % 3, C0 = (Column + 1) % 3, C1 = (Column + 2) % 3;
		return M[R0][C0] * M[R1][C1] - M[R0][C1] * M[R1][C0];
	};
	const double Determinant = M[0][0] * Cofactor(0, 0) + M[0][1] * Cofactor(0, 1) + M[0][2] * Cofactor(0, 2);
	FMat Result{};
	for (int Row = 0; Row < 3; ++Row)
	{
		for (int Column = 0; Column < 3; ++Column)
		{
			Result[Row][Column] = Cofactor(Column, Row) / Determinant;
		}
	}
	return Result;
}

struct FChromaticity
{
	double X, Y;

	FVec ToXYZ() const { return {X / Y, 1, (1 - X - Y) / Y}; }
};

constexpr FChromaticity D65{0.3127, 0.3290};
constexpr FChromaticity AcesWhite{0.32168, 0.33767};

inline FMat ToXYZ(FChromaticity Red, FChromaticity Green, FChromaticity Blue, FChromaticity White)
{
	const FMat Primaries{{{Red.X, Green.X, Blue.X}, {Red.Y, Green.Y, Blue.Y},
		{1 - Red.X - Red.Y, 1 - Green.X - Green.Y, 1 - Blue.X - Blue.Y}}};
	const FVec Scale = Mul(Inverse(Primaries), White.ToXYZ());
	return Mul(Primaries, FMat{{{Scale[0], 0, 0}, {0, Scale[1], 0}, {0, 0, Scale[2]}}});
}

inline FMat Bradford(FChromaticity From, FChromaticity To)
{
	const FMat Cone{{{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};
	const FVec A = Mul(Cone, From.ToXYZ()), B = Mul(Cone, To.ToXYZ());
	return Mul(Inverse(Cone), Mul(FMat{{{B[0] / A[0], 0, 0}, {0, B[1] / A[1], 0}, {0, 0, B[2] / A[2]}}}, Cone));
}

struct FMatrices
{
	FMat Rec709 = ToXYZ({0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, D65);
	FMat AP0 = ToXYZ({0.7347, 0.2653}, {0, 1}, {0.0001, -0.077}, AcesWhite);
	FMat AP1 = ToXYZ({0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, AcesWhite);
	FMat Wide = ToXYZ({0.6965, 0.3065}, {0.245, 0.718}, {0.1302, 0.0456}, D65);

	FMat Rec709ToAP1 = Mul(Inverse(AP1), Mul(Bradford(D65, AcesWhite), Rec709));
	FMat AP1ToRec709 = Inverse(Rec709ToAP1);
	FMat AP1ToAP0 = Mul(Inverse(AP0), AP1);
	FMat AP0ToAP1 = Inverse(AP1ToAP0);
	FMat ExpandGamut = Mul(Mul(Inverse(AP1), Wide), AP1ToRec709);
	FMat BlueCorrect =
		Mul(AP0ToAP1, Mul(FMat{{{0.9404372683, -0.0183068787, 0.0778696104}, {0.0083786969, 0.8286599939, 0.1629613092},
							  {0.0005471261, -0.0008833746, 1.0003362486}}},
						  AP1ToAP0));
	FMat BlueCorrectInverse = Inverse(BlueCorrect);
	FVec LuminanceAP1 = AP1[1];
};

inline const FMatrices& Matrices()
{
	static const FMatrices Instance;
	return Instance;
}

/** The engine's defaults. */
struct FFilm
{
	double Slope = 0.88, Toe = 0.55, Shoulder = 0.26, BlackClip = 0, WhiteClip = 0.04;
	double BlueCorrection = 0.6, ExpandGamut = 1, ToneCurveAmount = 1;

	double ToeScale() const { return 1 + BlackClip - Toe; }
	double ShoulderScale() const { return 1 + WhiteClip - Shoulder; }
	double ToeMatch() const
	{
		if (Toe > 0.8)
		{
			return (1 - Toe - 0.18) / Slope + std::log10(0.18);
		}
		const double B = (0.18 + BlackClip) / ToeScale() - 1;
		return std::log10(0.18) - 0.5 * std::log((1 + B) / (1 - B)) * ToeScale() / Slope;
	}
	double StraightMatch() const { return (1 - Toe) / Slope - ToeMatch(); }
	double ShoulderMatch() const { return Shoulder / Slope - StraightMatch(); }
};

inline double Curve(double Value, const FFilm& Film)
{
	if (Value <= 0)
	{
		return -Film.BlackClip;
	}
	const double X = std::log10(Value);
	const double ToeMatch = Film.ToeMatch(), ShoulderMatch = Film.ShoulderMatch();
	const double Straight = Film.Slope * (X + Film.StraightMatch());
	const double Toe =
		X < ToeMatch
			? -Film.BlackClip + 2 * Film.ToeScale() / (1 + std::exp(-2 * Film.Slope / Film.ToeScale() * (X - ToeMatch)))
			: Straight;
	const double Shoulder =
		X > ShoulderMatch
			? 1 + Film.WhiteClip -
				  2 * Film.ShoulderScale() / (1 + std::exp(2 * Film.Slope / Film.ShoulderScale() * (X - ShoulderMatch)))
			: Straight;
	double T = std::clamp((X - ToeMatch) / (ShoulderMatch - ToeMatch), 0.0, 1.0);
	T = ShoulderMatch < ToeMatch ? 1 - T : T;
	T = (3 - 2 * T) * T * T;
	return Toe + (Shoulder - Toe) * T;
}

inline double Dot(const FVec& A, const FVec& B)
{
	return A[0] * B[0] + A[1] * B[1] + A[2] * B[2];
}
inline FVec Lerp(const FVec& A, const FVec& B, double T)
{
	return {A[0] + (B[0] - A[0]) * T, A[1] + (B[1] - A[1]) * T, A[2] + (B[2] - A[2]) * T};
}
inline FVec NotNegative(const FVec& V)
{
	return {std::max(V[0], 0.0), std::max(V[1], 0.0), std::max(V[2], 0.0)};
}

inline FVec GlowAndRedModifier(FVec Color)
{
	const double Largest = std::max({Color[0], Color[1], Color[2]}),
				 Smallest = std::min({Color[0], Color[1], Color[2]});
	const double Saturation = (std::max(Largest, 1e-10) - std::max(Smallest, 1e-10)) / std::max(Largest, 1e-2);

	const double R = Color[0], G = Color[1], B = Color[2];
	const double Yc = (B + G + R + 1.75 * std::sqrt(std::max(0.0, B * (B - G) + G * (G - R) + R * (R - B)))) / 3;
	const double X = (Saturation - 0.4) / 0.2;
	const double T = std::max(1 - std::abs(X / 2), 0.0);
	const double Gain = 0.05 * (1 + (X > 0 ? 1 : X < 0 ? -1 : 0) * (1 - T * T)) / 2;
	const double Mid = 0.08;
	const double Glow = Yc <= 2.0 / 3 * Mid ? Gain : Yc >= 2 * Mid ? 0 : Gain * (Mid / Yc - 0.5);
	for (double& Channel : Color)
	{
		Channel *= 1 + Glow;
	}

	double Hue =
		Color[0] == Color[1] && Color[1] == Color[2]
			? 0
			: 180 / M_PI * std::atan2(std::sqrt(3.0) * (Color[1] - Color[2]), 2 * Color[0] - Color[1] - Color[2]);
	const double Ramp = std::clamp(1 - std::abs(2 * Hue / 135), 0.0, 1.0);
	const double Smooth = Ramp * Ramp * (3 - 2 * Ramp);
	Color[0] += Smooth * Smooth * Saturation * (0.03 - Color[0]) * (1 - 0.82);
	return Color;
}

inline FVec ExpandGamut(const FVec& AP1, double Amount)
{
	const FMatrices& M = Matrices();
	const double Y = Dot(AP1, M.LuminanceAP1);
	if (!(Y > 0))
	{
		return AP1;
	}
	double Chroma = 0;
	for (double Channel : AP1)
	{
		Chroma += (Channel / Y - 1) * (Channel / Y - 1);
	}
	return Lerp(AP1, Mul(M.ExpandGamut, AP1), (1 - std::exp2(-4 * Chroma)) * (1 - std::exp2(-4 * Amount * Y * Y)));
}

/** AP1, after grading, to display-linear Rec.709. */
inline FVec FilmFromAP1(FVec AP1, const FFilm& Film)
{
	const FMatrices& M = Matrices();
	AP1 = Lerp(AP1, Mul(M.BlueCorrect, AP1), Film.BlueCorrection);

	FVec Filmed = NotNegative(Mul(M.AP0ToAP1, GlowAndRedModifier(Mul(M.AP1ToAP0, AP1))));
	double Grey = Dot(Filmed, M.LuminanceAP1);
	Filmed = Lerp({Grey, Grey, Grey}, Filmed, 0.96);
	Filmed = {Curve(Filmed[0], Film), Curve(Filmed[1], Film), Curve(Filmed[2], Film)};
	Grey = Dot(Filmed, M.LuminanceAP1);
	Filmed = NotNegative(Lerp({Grey, Grey, Grey}, Filmed, 0.93));

	AP1 = Lerp(AP1, Filmed, Film.ToneCurveAmount);
	AP1 = Lerp(AP1, Mul(M.BlueCorrectInverse, AP1), Film.BlueCorrection);
	return NotNegative(Mul(M.AP1ToRec709, AP1));
}

/** Linear Rec.709 to display-linear Rec.709. */
inline FVec Tonemap(const FVec& Color, const FFilm& Film = {})
{
	return FilmFromAP1(ExpandGamut(Mul(Matrices().Rec709ToAP1, Color), Film.ExpandGamut), Film);
}

/** One range's colour correction, global values and the range's own multiplied (offsets added). */
struct FGrade
{
	FVec Saturation{1, 1, 1}, Contrast{1, 1, 1}, Gamma{1, 1, 1}, Gain{1, 1, 1}, Offset{0, 0, 0};
};

inline FVec Correct(const FVec& AP1, const FGrade& Grade)
{
	const double Y = Dot(AP1, Matrices().LuminanceAP1);
	FVec Result{};
	for (int Channel = 0; Channel < 3; ++Channel)
	{
		const double Saturated = std::max(Y + (AP1[Channel] - Y) * Grade.Saturation[Channel], 0.0);
		const double Contrasted = 0.18 * std::pow(Saturated / 0.18, Grade.Contrast[Channel]);
		Result[Channel] = std::pow(Contrasted, 1 / Grade.Gamma[Channel]) * Grade.Gain[Channel] + Grade.Offset[Channel];
	}
	return Result;
}

inline double SmoothStep(double Begin, double End, double X)
{
	const double T = std::clamp((X - Begin) / (End - Begin), 0.0, 1.0);
	return T * T * (3 - 2 * T);
}

/** By luminance: shadows, midtones, highlights. */
inline FVec CorrectAll(const FVec& AP1, const std::array<FGrade, 3>& Grades, double ShadowsMax = 0.09,
	double HighlightsMin = 0.5, double HighlightsMax = 1)
{
	const double Y = Dot(AP1, Matrices().LuminanceAP1);
	const double Dark = 1 - SmoothStep(0, ShadowsMax, Y), Bright = SmoothStep(HighlightsMin, HighlightsMax, Y);
	const FVec A = Correct(AP1, Grades[0]), B = Correct(AP1, Grades[1]), C = Correct(AP1, Grades[2]);
	FVec Result{};
	for (int Channel = 0; Channel < 3; ++Channel)
	{
		Result[Channel] = A[Channel] * Dark + B[Channel] * (1 - Dark - Bright) + C[Channel] * Bright;
	}
	return Result;
}

inline double EncodeSrgb(double Linear)
{
	return Linear <= 0.0031308 ? 12.92 * Linear : 1.055 * std::pow(Linear, 1 / 2.4) - 0.055;
}
inline double DecodeSrgb(double Encoded)
{
	return Encoded <= 0.04045 ? Encoded / 12.92 : std::pow((Encoded + 0.055) / 1.055, 2.4);
}

/** Position from the viewport's centre, -1..1. */
inline double Vignette(double X, double Y, int Width, int Height, double Intensity)
{
	const double Aspect = static_cast<double>(Height) / Width;
	const double Scale = std::sqrt(2.0 / (1 + Aspect * Aspect)) * Intensity;
	const double Distance2 = Scale * Scale * (X * X + Y * Y * Aspect * Aspect);
	return 1 / ((1 + Distance2) * (1 + Distance2));
}

} // namespace ToneReference
