// The colour functions of the engine-named includes (ACES pieces, primaries, hue, white balance) against a second
// computation in plain double.
#include "EngineProbes.h"

#include "Tonemap/ColorGrading.h"

using namespace EngineProbes;

TEST(EngineIncludes, AcesPieces)
{
	ExpectProbe(Probe_Aces, 3e-5,
		[](const FArguments& S)
		{
			const double R = S.X(), G = S.Y(), B = S.U();
			const double Largest = std::max(R, G), Smallest = std::min(R, G);
			const double Chroma = std::sqrt(B * (B - G) + G * (G - R) + R * (R - B));
			double Hue = 180 / Pi * std::atan2(std::sqrt(3.0) * (G - B), 2 * R - G - B);
			Hue = Hue < 0 ? Hue + 360 : Hue;
			double Centered = R * 360 - 200;
			Centered = Centered < -180 ? Centered + 360 : Centered > 180 ? Centered - 360 : Centered;
			return FExpected{
				(Largest - Smallest) / std::max(Largest, 1e-2), (R + G + B + 1.75 * Chroma) / 3, Hue, Centered};
		});
	ExpectProbe(Probe_Bump, 1e-5,
		[](const FArguments& S)
		{
			// The published form: knots at -w/2, -w/4, 0, w/4, w/2 and one row of the B-spline's matrix for each span.
			const auto Bump = [](double X, double W)
			{
				const double M[4][4] = {{-1.0 / 6, 3.0 / 6, -3.0 / 6, 1.0 / 6}, {3.0 / 6, -6.0 / 6, 3.0 / 6, 0},
					{-3.0 / 6, 0, 3.0 / 6, 0}, {1.0 / 6, 4.0 / 6, 1.0 / 6, 0}};
				if (X <= -W / 2 || X >= W / 2)
				{
					return 0.0;
				}
				const double Coordinate = (X + W / 2) * 4 / W;
				const int Span = std::min(3, int(Coordinate));
				const double T = Coordinate - Span;
				const double Monomials[4] = {T * T * T, T * T, T, 1};
				double Y = 0;
				for (int i = 0; i < 4; ++i)
				{
					Y += Monomials[i] * M[i][3 - Span];
				}
				return 1.5 * Y;
			};
			const double X = S.X() - 0.5, T = std::max(0.0, 1 - std::abs(X / 2));
			const double Y = S.Y() * 0.1;
			const double Glow = Y <= 2.0 / 3 * 0.08 ? 0.05 : Y >= 0.16 ? 0 : 0.05 * (0.08 / Y - 0.5);
			return FExpected{
				Bump(S.X() * 60, 135), Bump(-S.Y() * 60, 135), (1 + (X < 0 ? -1 : 1) * (1 - T * T)) / 2, Glow};
		});
}

TEST(EngineIncludes, ColourMatricesAreThoseOfTheirPrimaries)
{
	const std::array<double, 3> D65 = FromXY(0.3127, 0.3290), D60 = FromXY(0.32168, 0.33767);
	const FMatrix3 AP1 = MakeToXYZ({{{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}}}, D60);
	const FMatrix3 AP0 = MakeToXYZ({{{0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.0770}}}, D60);
	const FMatrix3 P3 = MakeToXYZ({{{0.68, 0.32}, {0.265, 0.69}, {0.15, 0.06}}}, D65);
	const FMatrix3 Rec2020 = MakeToXYZ({{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}}}, D65);
	ExpectProbe(Probe_Color, 2e-6,
		[&](const FArguments& S)
		{
			const std::array<double, 3> C = {S.X(), S.Y(), S.U()};
			const auto P = Apply(Multiply(Invert(P3), Multiply(MakeBradford(D60, D65), AP1)), C);
			const auto A = Apply(Multiply(Invert(AP0), Multiply(MakeBradford(D65, D60), Rec2020)), C);
			return FExpected{P[0], P[1], P[2], A[1]};
		});
}

TEST(EngineIncludes, HueSaturationValueAndYCoCg)
{
	ExpectProbe(Probe_HSV, 3e-6,
		[](const FArguments& S)
		{
			const double C[3] = {S.X(), S.Y(), S.U()};
			int Largest = 0, Smallest = 0;
			for (int i = 1; i < 3; ++i)
			{
				Largest = C[i] > C[Largest] ? i : Largest;
				Smallest = C[i] < C[Smallest] ? i : Smallest;
			}
			const double Chroma = C[Largest] - C[Smallest];
			const double Sextant = 2.0 * Largest + (C[(Largest + 1) % 3] - C[(Largest + 2) % 3]) / Chroma;
			return FExpected{Fraction(Sextant / 6 + 1), Chroma / C[Largest], C[Largest], C[1]};
		});
	ExpectProbe(Probe_YCoCg, 1e-6,
		[](const FArguments& S) {
			return FExpected{S.X(), S.Y(), S.U(), 0.25 * S.X() + 0.5 * S.Y() + 0.25 * S.U()};
		});
}

TEST(EngineIncludes, WhiteBalanceIsThatOfTheSettings)
{
	ExpectProbe(Probe_WhiteBalance, 2e-5,
		[](const FArguments& S)
		{
			const double C[3] = {S.X(), S.Y(), S.U()};
			const auto Balance = [&](double Temperature, ETemperatureMethod Method, int Row)
			{
				const Drydock::FColorMatrix M = Drydock::ComputeWhiteBalance(Temperature, S.Y() - 0.5, Method);
				return M[Row][0] * C[0] + M[Row][1] * C[1] + M[Row][2] * C[2];
			};
			const double T = 3000 + 4000 * S.X();
			return FExpected{Balance(T, TEMP_WhiteBalance, 0), Balance(T, TEMP_WhiteBalance, 1),
				Balance(T, TEMP_WhiteBalance, 2), Balance(3000 + 9000 * S.X(), TEMP_ColorTemperature, 2)};
		});
}
