// The engine-named functions of shaders, each run on arguments drawn at random, and the plain double that they are
// compared with. One probe is one pixel of tests/Shaders/EngineProbe.usf.
#pragma once

#include "PassTestUtils.h"

#include "GlobalShader.h"
#include "RenderGraphUtils.h"
#include "ShaderCore.h"
#include "ShaderParameterStruct.h"

#include <array>
#include <random>

namespace EngineProbes
{

using PassTest::EArithmetic;
using PassTest::FImage;
using PassTest::FPassRun;

class FEngineProbeCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FEngineProbeCS);
	SHADER_USE_PARAMETER_STRUCT(FEngineProbeCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER(FVector4f, A)
		SHADER_PARAMETER(FVector4f, B)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutTexture)
	END_SHADER_PARAMETER_STRUCT()
};

enum EProbe
{
	Probe_Hammersley,
	Probe_Disk,
	Probe_Sphere,
	Probe_Hemisphere,
	Probe_Cosine,
	Probe_Cone,
	Probe_GGX,
	Probe_VisibleGGX,
	Probe_Basis,
	Probe_MIS,
	Probe_Random,
	Probe_Aces,
	Probe_Bump,
	Probe_Color,
	Probe_HSV,
	Probe_YCoCg,
	Probe_Morton,
	Probe_Groups,
	Probe_Bicubic,
	Probe_Select,
	Probe_Boxes,
	Probe_Sphere2,
	Probe_WhiteBalance,
	Probe_Noise,
	Probe_FastAngles,
	Probe_FastAngles4,
	Probe_Octahedral,
	Probe_HemiOctahedral,
	Probe_Hash,
	Probe_SH,
	Probe_Distributions,
	Probe_AnisotropicAndFresnel,
	Probe_Visibility,
	Probe_Diffuse,
	Probe_Phases,
	Probe_SubUvs,
	NumProbes,
};

struct FArguments
{
	FVector4f A; // xy 0..1, zw whole numbers
	FVector4f B; // xy 0..1, zw whole numbers

	double X() const { return A.X; }
	double Y() const { return A.Y; }
	double U() const { return B.X; }
	double V() const { return B.Y; }
	unsigned I() const { return unsigned(A.Z); }
	unsigned J() const { return unsigned(A.W); }
};

constexpr int NumSets = 24;
constexpr double Pi = 3.14159265358979323846;

/** Drawn at random, the same in every run. */
const std::vector<FArguments>& GetArguments();

/** All probes for each set of arguments. */
const std::vector<FImage>& GetProbes();

using FExpected = std::array<double, 4>;

/** Float arithmetic of a few operations; Scale: of the values. */
template<typename F>
void ExpectProbe(EProbe Probe, double Tolerance, F Compute)
{
	for (int Set = 0; Set < NumSets; ++Set)
	{
		const FExpected Expected = Compute(GetArguments()[Set]);
		for (int Channel = 0; Channel < 4; ++Channel)
		{
			EXPECT_NEAR(Expected[Channel], GetProbes()[Set].At(Probe, 0)[Channel],
				Tolerance * std::max(1.0, std::abs(Expected[Channel])))
				<< "probe " << Probe << "." << Channel << " set " << Set;
		}
	}
}

inline double Fraction(double X)
{
	return X - std::floor(X);
}

inline unsigned Reverse(unsigned Bits)
{
	unsigned Result = 0;
	for (int i = 0; i < 32; ++i)
	{
		Result |= ((Bits >> i) & 1u) << (31 - i);
	}
	return Result;
}

inline std::array<double, 3> Normalize(std::array<double, 3> V)
{
	const double Length = std::sqrt(V[0] * V[0] + V[1] * V[1] + V[2] * V[2]);
	return {V[0] / Length, V[1] / Length, V[2] / Length};
}

using FMatrix3 = std::array<std::array<double, 3>, 3>;

inline FMatrix3 Multiply(const FMatrix3& A, const FMatrix3& B)
{
	FMatrix3 Result{};
	for (int i = 0; i < 3; ++i)
	{
		for (int j = 0; j < 3; ++j)
		{
			for (int k = 0; k < 3; ++k)
			{
				Result[i][j] += A[i][k] * B[k][j];
			}
		}
	}
	return Result;
}

/** By Gauss and Jordan. */
inline FMatrix3 Invert(FMatrix3 M)
{
	FMatrix3 Result = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
	for (int c = 0; c < 3; ++c)
	{
		int Pivot = c;
		for (int r = c; r < 3; ++r)
		{
			Pivot = std::abs(M[r][c]) > std::abs(M[Pivot][c]) ? r : Pivot;
		}
		std::swap(M[c], M[Pivot]);
		std::swap(Result[c], Result[Pivot]);
		for (int r = 0; r < 3; ++r)
		{
			const double Factor = r == c ? 0.0 : M[r][c] / M[c][c];
			for (int k = 0; k < 3; ++k)
			{
				M[r][k] -= Factor * M[c][k];
				Result[r][k] -= Factor * Result[c][k];
			}
		}
		const double Scale = M[c][c];
		for (int k = 0; k < 3; ++k)
		{
			M[c][k] /= Scale;
			Result[c][k] /= Scale;
		}
	}
	return Result;
}

inline std::array<double, 3> Apply(const FMatrix3& M, const std::array<double, 3>& V)
{
	std::array<double, 3> Result{};
	for (int i = 0; i < 3; ++i)
	{
		Result[i] = M[i][0] * V[0] + M[i][1] * V[1] + M[i][2] * V[2];
	}
	return Result;
}

inline std::array<double, 3> FromXY(double X, double Y)
{
	return {X / Y, 1.0, (1.0 - X - Y) / Y};
}

/** RGB of these primaries and white to XYZ. */
inline FMatrix3 MakeToXYZ(const std::array<std::array<double, 2>, 3>& Primaries, const std::array<double, 3>& White)
{
	FMatrix3 M{};
	for (int i = 0; i < 3; ++i)
	{
		const std::array<double, 3> Color = FromXY(Primaries[i][0], Primaries[i][1]);
		for (int k = 0; k < 3; ++k)
		{
			M[k][i] = Color[k];
		}
	}
	const std::array<double, 3> Amount = Apply(Invert(M), White);
	for (int k = 0; k < 3; ++k)
	{
		for (int i = 0; i < 3; ++i)
		{
			M[k][i] *= Amount[i];
		}
	}
	return M;
}

inline FMatrix3 MakeBradford(const std::array<double, 3>& From, const std::array<double, 3>& To)
{
	const FMatrix3 Cone = {{{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};
	const std::array<double, 3> A = Apply(Cone, From), B = Apply(Cone, To);
	const FMatrix3 Scale = {{{B[0] / A[0], 0, 0}, {0, B[1] / A[1], 0}, {0, 0, B[2] / A[2]}}};
	return Multiply(Invert(Cone), Multiply(Scale, Cone));
}

} // namespace EngineProbes
