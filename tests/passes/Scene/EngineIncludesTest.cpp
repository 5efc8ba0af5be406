// The functions of the engine-named includes against the formulas that their names stand for, each computed a second
// time in plain double, on arguments drawn at random.
#include "EngineProbes.h"

using namespace EngineProbes;

IMPLEMENT_GLOBAL_SHADER(FEngineProbeCS, "/DrydockTests/EngineProbe.usf", "MainCS", SF_Compute);

namespace EngineProbes
{

const std::vector<FArguments>& GetArguments()
{
	static const std::vector<FArguments> Sets = []
	{
		std::mt19937 Random(17); // the seed
		const auto Unit = [&Random]
		{
			return float((Random() >> 8) + 0.5) / float(1 << 24);
		};
		std::vector<FArguments> Result;
		for (int Set = 0; Set < NumSets; ++Set)
		{
			const auto Whole = [&Random](unsigned Count)
			{
				return float(Random() % Count);
			};
			FArguments Arguments;
			Arguments.A = FVector4f(Unit(), Unit(), Whole(64), 64.0f + Whole(100));
			Arguments.B = FVector4f(Unit(), 0.05f + 0.9f * Unit(), Whole(65536), Whole(65536));
			Result.push_back(Arguments);
		}
		return Result;
	}();
	return Sets;
}

const std::vector<FImage>& GetProbes()
{
	static const std::vector<FImage> Probes = []
	{
		AddShaderSourceDirectoryMapping(TEXT("/DrydockTests"), TEXT(DRYDOCK_TEST_SOURCE_DIR "/tests/Shaders"));
		std::vector<FImage> Result;
		for (const FArguments& Arguments : GetArguments())
		{
			FPassRun Run(FImage(1, 1), EArithmetic::Float32);
			FRDGTextureRef Output =
				Run.GraphBuilder.CreateTexture(FRDGTextureDesc::Create2D(FIntPoint(NumProbes, 1), PF_A32B32G32R32F,
												   FClearValueBinding::None, TexCreate_UAV | TexCreate_ShaderResource),
					TEXT("Probes"));
			FEngineProbeCS::FParameters* Parameters = Run.GraphBuilder.AllocParameters<FEngineProbeCS::FParameters>();
			Parameters->A = Arguments.A;
			Parameters->B = Arguments.B;
			Parameters->OutTexture = Run.GraphBuilder.CreateUAV(Output);
			TShaderMapRef<FEngineProbeCS> ComputeShader(Run.View.ShaderMap);
			FComputeShaderUtils::AddPass(
				Run.GraphBuilder, RDG_EVENT_NAME("Probe"), ComputeShader, Parameters, FIntVector(NumProbes, 1, 1));
			Result.push_back(Run.Execute(FScreenPassTexture(Output)));
		}
		return Result;
	}();
	return Probes;
}

} // namespace EngineProbes

TEST(EngineIncludes, HammersleyPoints)
{
	ExpectProbe(Probe_Hammersley, 3e-7,
		[](const FArguments& S)
		{
			const double X = Fraction(double(S.I()) / S.J() + double(S.B.Z) / 65536.0);
			const double Y = double(Reverse(S.I()) ^ unsigned(S.B.W)) / 4294967296.0;
			const double Y16 = double((Reverse(S.I()) >> 16) ^ unsigned(S.B.W)) / 65536.0;
			return FExpected{X, Y, X, Y16};
		});
}

TEST(EngineIncludes, DiscsAndDirections)
{
	ExpectProbe(Probe_Disk, 3e-6,
		[](const FArguments& S)
		{
			// Concentric: the square ring at distance r becomes the circle of radius r, arc length in proportion.
			const double X = 2 * S.X() - 1, Y = 2 * S.Y() - 1;
			const double R = std::max(std::abs(X), std::abs(Y));
			const double Phi = std::abs(X) > std::abs(Y) ? Pi / 4 * Y / X + (X < 0 ? Pi : 0)
														 : Pi / 2 - Pi / 4 * X / Y + (Y < 0 ? Pi : 0);
			const double T = 2 * Pi * S.X();
			return FExpected{
				std::sqrt(S.Y()) * std::cos(T), std::sqrt(S.Y()) * std::sin(T), R * std::cos(Phi), R * std::sin(Phi)};
		});
	const auto Direction = [](const FArguments& S, double Z, double Density)
	{
		const double T = 2 * Pi * S.X(), R = std::sqrt(1 - Z * Z);
		return FExpected{R * std::cos(T), R * std::sin(T), Z, Density};
	};
	ExpectProbe(Probe_Sphere, 3e-6, [&](const FArguments& S) { return Direction(S, 1 - 2 * S.Y(), 0.25 / Pi); });
	ExpectProbe(Probe_Hemisphere, 3e-6, [&](const FArguments& S) { return Direction(S, S.Y(), 0.5 / Pi); });
	ExpectProbe(
		Probe_Cosine, 3e-6, [&](const FArguments& S) { return Direction(S, std::sqrt(S.Y()), std::sqrt(S.Y()) / Pi); });
	ExpectProbe(Probe_Cone, 1e-5,
		[&](const FArguments& S) { return Direction(S, S.U() + (1 - S.U()) * S.Y(), 1 / (2 * Pi * (1 - S.U()))); });
}

TEST(EngineIncludes, Microfacets)
{
	// The distribution of Walter et al., of roughness a: D = a^2 / (pi (cos^2 (a^2 - 1) + 1)^2), by its angle.
	ExpectProbe(Probe_GGX, 2e-5,
		[](const FArguments& S)
		{
			const double A2 = S.V();
			const double Tan2 = A2 * S.Y() / (1 - S.Y());
			const double Z = 1 / std::sqrt(1 + Tan2), R = std::sqrt(1 - Z * Z), T = 2 * Pi * S.X();
			const double D = A2 / (Pi * std::pow(Z * Z * (A2 - 1) + 1, 2));
			return FExpected{R * std::cos(T), R * std::sin(T), Z, D * Z};
		});
	ExpectProbe(Probe_VisibleGGX, 1e-4,
		[](const FArguments& S)
		{
			// Heitz 2018: stretch the view, take a point of the visible half disc, unstretch the normal.
			const double A = std::sqrt(double(S.V())), A2 = S.V();
			const std::array<double, 3> V = Normalize({S.X(), S.Y(), S.U()});
			const std::array<double, 3> H0 = Normalize({A * V[0], A * V[1], V[2]});
			const double L = std::hypot(H0[0], H0[1]);
			const std::array<double, 3> T1 = {-H0[1] / L, H0[0] / L, 0};
			const std::array<double, 3> T2 = {-H0[2] * T1[1], H0[2] * T1[0], H0[0] * T1[1] - H0[1] * T1[0]};
			const double R = std::sqrt(S.Y()), Phi = 2 * Pi * S.X();
			const double P1 = R * std::cos(Phi);
			const double Half = 0.5 * (1 + H0[2]);
			const double P2 = (1 - Half) * std::sqrt(1 - P1 * P1) + Half * R * std::sin(Phi);
			const double P3 = std::sqrt(std::max(0.0, 1 - P1 * P1 - P2 * P2));
			std::array<double, 3> N{};
			for (int i = 0; i < 3; ++i)
			{
				N[i] = P1 * T1[i] + P2 * T2[i] + P3 * H0[i];
			}
			const std::array<double, 3> H = Normalize({A * N[0], A * N[1], std::max(0.0, N[2])});
			// D_V = G1 D max(V.H, 0) / V.z
			const double D = A2 / (Pi * std::pow(H[2] * H[2] * (A2 - 1) + 1, 2));
			const double Lambda = 0.5 * (std::sqrt(1 + A2 * (1 / (V[2] * V[2]) - 1)) - 1);
			const double VoH = V[0] * H[0] + V[1] * H[1] + V[2] * H[2];
			return FExpected{H[0], H[1], H[2], D * VoH / ((1 + Lambda) * V[2])};
		});
}

TEST(EngineIncludes, TangentFramesAreOrthonormal)
{
	for (int Set = 0; Set < NumSets; ++Set)
	{
		const FArguments& S = GetArguments()[Set];
		const auto Probe = GetProbes()[Set].At(Probe_Basis, 0);
		const double Length = S.X() * S.X() + S.Y() * S.Y() + 0.25;
		const std::array<double, 3> N = Normalize({S.U(), S.V(), S.X() - 0.5});
		EXPECT_NEAR(Length, Probe[0] * Probe[0] + Probe[1] * Probe[1] + Probe[2] * Probe[2], 2e-6 * Length);
		EXPECT_NEAR(0.5, N[0] * Probe[0] + N[1] * Probe[1] + N[2] * Probe[2], 2e-6);
		EXPECT_NEAR(1.0, Probe[3], 1e-6);
	}
}

TEST(EngineIncludes, WeightsOfSeveralEstimators)
{
	ExpectProbe(Probe_MIS, 2e-6,
		[](const FArguments& S)
		{
			const double A = S.X() * S.X(), B = S.Y() * S.Y();
			return FExpected{4 * A / (4 * A + 9 * B), A / (A + B), B / (A + B), 0.5};
		});
}

TEST(EngineIncludes, BlumBlumShubIsTwoSquaringsModulo4093)
{
	for (int Set = 0; Set < NumSets; ++Set)
	{
		for (int Channel = 0; Channel < 2; ++Channel)
		{
			// In whole numbers: x -> x^2 mod 4093, twice.
			long State = long(Channel ? GetArguments()[Set].J() : GetArguments()[Set].I()) % 4093;
			State = State * State % 4093;
			State = State * State % 4093;
			const double Error = GetProbes()[Set].At(Probe_Random, 0)[Channel] - State / 4093.0;
			// Floats lose 12 bits in each squaring.
			EXPECT_NEAR(0.0, Error - std::round(Error), 1e-2) << "set " << Set;
		}
		EXPECT_GE(GetProbes()[Set].At(Probe_Random, 0)[2], 0.0);
		EXPECT_LT(GetProbes()[Set].At(Probe_Random, 0)[2], 1.0);
	}
}

TEST(EngineIncludes, BitsAndIndices)
{
	ExpectProbe(Probe_Morton, 0.0,
		[](const FArguments& S)
		{
			unsigned Code = 0;
			for (int i = 0; i < 16; ++i)
			{
				Code |= ((S.I() >> i) & 1u) << (2 * i) | ((S.J() >> i) & 1u) << (2 * i + 1);
			}
			return FExpected{double(Code), double(S.I()), double(S.J()), double(Reverse(S.I()) >> 8)};
		});
	ExpectProbe(Probe_Groups, 0.0,
		[](const FArguments& S) {
			return FExpected{((2.0 * 128 + S.J()) * 128 + S.I()) * 64 + 5, 90.0, 0.0, 1.0};
		});
}

TEST(EngineIncludes, BicubicTapsAreTheCatmullRomSpline)
{
	ExpectProbe(Probe_Bicubic, 2e-5,
		[](const FArguments& S)
		{
			// Through p(-1), p(0), p(1), p(2), texel i at i + 0.5 holding i^2: the spline gives squares exactly.
			const auto Spline = [](double Position)
			{
				const double I = std::floor(Position - 0.5), T = Position - 0.5 - I;
				const double P[4] = {(I - 1) * (I - 1), I * I, (I + 1) * (I + 1), (I + 2) * (I + 2)};
				return P[1] +
					   0.5 * T *
						   (P[2] - P[0] +
							   T * (2 * P[0] - 5 * P[1] + 4 * P[2] - P[3] + T * (3 * (P[1] - P[2]) + P[3] - P[0])));
			};
			const auto Weights = [](double Position)
			{
				const double T = Fraction(Position - 0.5);
				const double W0 = 0.5 * (-T * T * T + 2 * T * T - T), W3 = 0.5 * (T * T * T - T * T);
				return std::array<double, 3>{W0, 1 - W0 - W3, W3};
			};
			const auto X = Weights(S.X() * 16), Y = Weights(S.Y() * 16);
			const double Cross = X[1] * Y[0] + X[0] * Y[1] + X[1] * Y[1] + X[2] * Y[1] + X[1] * Y[2];
			return FExpected{Spline(S.I() + S.X()), Spline(S.J() + S.Y()), 1 / Cross, 0};
		});
}

TEST(EngineIncludes, SelectChoosesByComponent)
{
	ExpectProbe(Probe_Select, 0.0,
		[](const FArguments& S) {
			return FExpected{S.X() > 0.5 ? 1.0 : 0.0, S.Y() > 0.5 ? 2.0 : 0.0, S.X() > 0.5 ? 3.0 : 0.0, 1.0};
		});
}

TEST(EngineIncludes, BoxesAndRays)
{
	ExpectProbe(Probe_Boxes, 3e-6,
		[](const FArguments& S)
		{
			const double C[3] = {S.X(), S.Y(), 0}, E[3] = {S.U(), 0.25, 0.125};
			double Squared = 0;
			for (int i = 0; i < 3; ++i)
			{
				const double Nearest = std::clamp(1.5, C[i] - E[i], C[i] + E[i]);
				Squared += (1.5 - Nearest) * (1.5 - Nearest);
			}
			const double Corner = std::sqrt(std::pow(2 - S.Y(), 2) + std::pow(2 - S.X(), 2) + 1.0);
			return FExpected{Squared, Corner, 0.25, 0.75}; // only the planes x = -1 and x = 1 are met
		});
	ExpectProbe(Probe_Sphere2, 2e-5,
		[](const FArguments& S)
		{
			const double D[3] = {double(0.1f) * S.X(), double(0.1f) * S.Y(), 1}, O[3] = {-S.X(), -S.Y(), -3.5};
			double A = 0, B = 0, C = -2.25;
			for (int i = 0; i < 3; ++i)
			{
				A += D[i] * D[i];
				B += D[i] * O[i];
				C += O[i] * O[i];
			}
			const double Root = std::sqrt(B * B - A * C);
			return FExpected{(-B - Root) / A, (-B + Root) / A, -1, -1};
		});
}

TEST(EngineIncludes, ValueNoiseIsBoundedAndTiles)
{
	for (int Set = 0; Set < NumSets; ++Set)
	{
		const auto Probe = GetProbes()[Set].At(Probe_Noise, 0);
		EXPECT_LE(std::abs(Probe[0]), 1.0);
		EXPECT_NEAR(0.0, Probe[1], 1e-5); // one period of 5 apart
		const double T = GetArguments()[Set].X();
		EXPECT_NEAR(6 * std::pow(T, 5) - 15 * std::pow(T, 4) + 10 * T * T * T, Probe[2], 1e-6);
		EXPECT_LE(std::abs(Probe[3]), 1.0);
	}
}
