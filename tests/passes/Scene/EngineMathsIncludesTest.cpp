// The functions of engine-named includes for angles, directions, hashes, harmonics and reflection, each computed a
// second time in plain double from its published formula.
#include "EngineProbes.h"

using namespace EngineProbes;

namespace
{

using FVector3 = std::array<double, 3>;

FVector3 GetN(const FArguments& S)
{
	return Normalize({S.X() - 0.5, S.Y() - 0.5, S.U() - 0.5});
}
FVector3 GetH(const FArguments& S)
{
	return Normalize({S.Y() - 0.5, S.X() - 0.5, S.V()});
}
double Dot(const FVector3& A, const FVector3& B)
{
	return A[0] * B[0] + A[1] * B[1] + A[2] * B[2];
}

} // namespace

TEST(EngineMathsIncludes, AnglesAreAsNearAsStated)
{
	const auto Angles = [](const FArguments& S)
	{
		return FExpected{std::acos(2 * S.X() - 1), std::asin(2 * S.Y() - 1), std::atan(8 * S.X() - 4),
			std::atan2(S.Y() - 0.5, S.U() - 0.5)};
	};
	ExpectProbe(Probe_FastAngles, 0.01, Angles);
	ExpectProbe(Probe_FastAngles4, 1e-4,
		[&](const FArguments& S)
		{
			FExpected Expected = Angles(S);
			Expected[3] = 4 * S.X() + 3 * S.Y() + S.U() + S.V();
			return Expected;
		});
}

// The octahedron |x| + |y| + |z| = 1; its lower half is folded over the edges of the upper one.
TEST(EngineMathsIncludes, OctahedralDirections)
{
	ExpectProbe(Probe_Octahedral, 2e-6,
		[](const FArguments& S)
		{
			const FVector3 N = GetN(S);
			const double Sum = std::abs(N[0]) + std::abs(N[1]) + std::abs(N[2]);
			const double X = N[0] / Sum, Y = N[1] / Sum;
			const double FoldedX = std::copysign(1 - std::abs(Y), X), FoldedY = std::copysign(1 - std::abs(X), Y);
			return FExpected{N[2] > 0 ? X : FoldedX, N[2] > 0 ? Y : FoldedY, N[0], N[2]};
		});
	ExpectProbe(Probe_HemiOctahedral, 2e-6,
		[](const FArguments& S)
		{
			const FVector3 H = GetH(S);
			const double Sum = std::abs(H[0]) + std::abs(H[1]) + H[2];
			return FExpected{(H[0] + H[1]) / Sum, (H[0] - H[1]) / Sum, H[0], H[2]};
		});
}

TEST(EngineMathsIncludes, Hashes)
{
	ExpectProbe(Probe_Hash, 0,
		[](const FArguments& S)
		{
			const auto Turn = [](unsigned X, unsigned Bits)
			{
				return (X << Bits) | (X >> (32 - Bits));
			};
			unsigned Mixed = unsigned(S.B.Z);
			Mixed = (Mixed ^ (Mixed >> 16)) * 0x85ebca6bu;
			Mixed = (Mixed ^ (Mixed >> 13)) * 0xc2b2ae35u;
			Mixed ^= Mixed >> 16;
			const unsigned Element = Turn(unsigned(S.B.W) * 0xcc9e2d51u, 15) * 0x1b873593u;
			const unsigned Added = Turn(S.I() ^ Element, 13) * 5u + 0xe6546b64u;
			unsigned Spread = 0;
			for (unsigned Bit = 0; Bit < 10; ++Bit)
			{
				Spread |= ((S.I() >> Bit) & 1u) << (3 * Bit);
			}
			return FExpected{double(Mixed >> 8), double(Added >> 8), double(Spread), double(0x09249249u >> 8)};
		});
}

// By the addition theorem: the basis of band l in two directions sums up to (2l + 1) / (4 pi) P_l of their cosine.
TEST(EngineMathsIncludes, SphericalHarmonics)
{
	ExpectProbe(Probe_SH, 5e-6,
		[](const FArguments& S)
		{
			const double C = Dot(GetN(S), GetH(S));
			const auto Sum = [](double Cosine, const FVector3& Scale)
			{
				const double Bands[] = {1.0, 3.0 * Cosine, 5.0 * (3.0 * Cosine * Cosine - 1.0) / 2.0};
				return (Bands[0] * Scale[0] + Bands[1] * Scale[1] + Bands[2] * Scale[2]) / (4 * Pi);
			};
			// The lobe cos^n over the half sphere: 2 pi times the integral of t^n P_l(t) from 0 to 1.
			const auto Lobe = [](double n)
			{
				return FVector3{2 * Pi / (n + 1), 2 * Pi / (n + 2), Pi * (3 / (n + 3) - 1 / (n + 1))};
			};
			const FVector3 Two = {Lobe(1)[0], Lobe(1)[1], 0};
			const FVector3 All = {1, 1, 1};
			return FExpected{
				Sum(C, All), Sum(C, Two), Sum(C, Lobe(4)), 2 * (Sum(C, All) + Sum(1, All)) + 3 * Sum(C, {1, 1, 0})};
		});
}

TEST(EngineMathsIncludes, ReflectionOfSurfaces)
{
	const auto GGX = [](double A2, double Cosine)
	{
		return A2 / (Pi * std::pow(Cosine * Cosine * (A2 - 1) + 1, 2));
	};
	const auto Schlick = [](double F0, double Cosine)
	{
		return F0 + (1 - F0) * std::pow(1 - Cosine, 5);
	};
	ExpectProbe(Probe_Distributions, 2e-5,
		[&](const FArguments& S)
		{
			const double A2 = S.V(), C = 0.3 + 0.7 * S.X(), Tan2 = 1 / (C * C) - 1, Power = 2 / A2 - 2;
			return FExpected{GGX(A2, S.X()), std::exp(-Tan2 / A2) / (Pi * A2 * std::pow(C, 4)),
				(Power + 2) / (2 * Pi) * std::pow(S.X(), Power), Schlick(0.04, S.Y())};
		});
	ExpectProbe(Probe_AnisotropicAndFresnel, 5e-5,
		[&](const FArguments& S)
		{
			const FVector3 H = GetH(S);
			const double ax = S.V(), ay = 0.5 * S.V();
			const double Sum = std::pow(H[0] / ax, 2) + std::pow(H[1] / ay, 2) + H[2] * H[2];
			// Below 2 % the light at grazing angles fades with the colour's green.
			const double Grazing = std::pow(1 - S.Y(), 5);
			// Lazarov's curves as Karis fits them.
			const double R = S.X(), X = 1 - R;
			const double Mix = std::min(X * X, std::exp2(-9.28 * S.Y())) * X + 0.0425 - 0.0275 * R;
			return FExpected{1 / (Pi * ax * ay * Sum * Sum), 0.5 * Grazing + (1 - Grazing) * 0.01,
				0.5 * Grazing + (1 - Grazing) * 0.5,
				0.04 * (-1.04 * Mix + 1.04 - 0.572 * R) + 1.04 * Mix - 0.04 + 0.022 * R};
		});
	ExpectProbe(Probe_Visibility, 2e-5,
		[](const FArguments& S)
		{
			// G / (4 NoL NoV); Smith: G1 = 2 / (1 + sqrt(1 + a2 tan2)).
			const double A2 = S.V(), A = std::sqrt(A2), V = S.X(), L = S.Y(), K = A / 2;
			const auto Lambda = [A2](double C)
			{
				return (std::sqrt(1 + A2 * (1 / (C * C) - 1)) - 1) / 2;
			};
			const auto G1 = [K](double C)
			{
				return C / (C * (1 - K) + K);
			};
			const double LerpV = L * (V + (1 - V) * A), LerpL = V * (L + (1 - L) * A);
			return FExpected{G1(V) * G1(L) / (4 * V * L), 1 / (1 + Lambda(V)) / (1 + Lambda(L)) / (4 * V * L),
				0.5 / (LerpV + LerpL), 1 / (1 + Lambda(V) + Lambda(L)) / (4 * V * L)};
		});
	ExpectProbe(Probe_Diffuse, 1e-5,
		[](const FArguments& S)
		{
			const double F90 = 0.5 + 2 * S.U() * S.U() * S.V();
			const auto Term = [F90](double C)
			{
				return 1 + (F90 - 1) * std::pow(1 - C, 5);
			};
			return FExpected{S.X() / Pi * Term(S.X()) * Term(S.Y()), S.X() / Pi + S.Y(),
				1 / (4 * std::max(S.X(), S.Y())), 1 / (4 * std::pow(0.1 + S.X(), 2) + 1e-5) + 0.25};
		});
}

TEST(EngineMathsIncludes, PhasesAndTables)
{
	ExpectProbe(Probe_Phases, 1e-5,
		[](const FArguments& S)
		{
			const double C = 2 * S.X() - 1, G = 0.9 * (2 * S.Y() - 1);
			const auto Outside = [](double X)
			{
				return std::clamp(5 * std::abs(2.4 * X - 1.2) - 4, 0.0, 1.0);
			};
			return FExpected{1 / (4 * Pi), 3 / (16 * Pi) * (1 + C * C),
				(1 - G * G) / (4 * Pi * std::pow(1 + G * G + 2 * G * C, 1.5)),
				std::clamp(1 - std::pow(Outside(S.X()), 2) - std::pow(Outside(S.Y()), 2), 0.0, 1.0)};
		});
	ExpectProbe(Probe_SubUvs, 2e-6,
		[](const FArguments& S)
		{
			const double W = S.J();
			return FExpected{(S.X() * W + 0.5) / (W + 1), (S.Y() * 16 + 0.5) / 17, (S.X() * W - 0.5) / (W - 1),
				(S.Y() * 16 - 0.5) / 15};
		});
}
