// Texture sampling against a direct implementation of the rules in double, texel by texel, for every format, filter and
// address mode; and the same bits at every lane width.
#include <gtest/gtest.h>

#include "LanesDispatch.h"
#include "LanesResources.h"
#include "LanesTestTexture.h"

#include <cmath>
#include <limits>
#include <string>

namespace Drydock::Tests
{
namespace
{

using Lanes::TSampling;
using FTexel = FTestTexture::FTexel;

constexpr double GInf = std::numeric_limits<double>::infinity();
constexpr float GNanF = std::numeric_limits<float>::quiet_NaN();

// ---- The rules, written down once more: in double, with the product form of filtering.

int32_t ModelAddress(int64_t X, int64_t Size, EKernelAddress Mode)
{
	switch (Mode)
	{
	case EKernelAddress::Wrap:
		return int32_t(((X % Size) + Size) % Size);
	case EKernelAddress::Mirror:
	{
		const int64_t R = ((X % (2 * Size)) + 2 * Size) % (2 * Size);
		return int32_t(std::min(R, 2 * Size - 1 - R));
	}
	case EKernelAddress::Clamp:
		return int32_t(std::clamp<int64_t>(X, 0, Size - 1));
	default:
		return X < 0 || X >= Size ? -1 : int32_t(X);
	}
}

struct FModelTap
{
	int32_t Texels[2];
	double Weight;
};

/** Product: the coordinate times the size, in the arithmetic of the shader, as is the snapping. */
template<typename Real>
FModelTap ModelAxis(Real Product, int32_t Size, bool bPoint, EKernelAddress Mode, int SampleBits)
{
	const Real Bounded = std::isnan(Product) ? Real(0) : std::clamp(Product, Real(-4194304), Real(4194304));
	const double X = SampleBits == 8 ? std::floor(Bounded * 256 + Real(0.5)) / 256 : Bounded;
	const double Place = bPoint ? X : X - 0.5;
	const double First = std::floor(Place);
	return {{ModelAddress(int64_t(First), Size, Mode), ModelAddress(int64_t(First) + 1, Size, Mode)},
		bPoint ? 0 : Place - First};
}

double ModelMix(double A, double B, double Weight)
{
	return Weight == 0 ? A : A * (1 - Weight) + B * Weight;
}

template<typename Real>
FTexel ModelSample(FTestTexture& T, const FKernelSampler& S, Real ProductU, Real ProductV, int32_t Z, int32_t Mip)
{
	const FKernelMip& M = T.Mips[size_t(Mip)];
	const bool bPoint = S.Filter == EKernelFilter::Point;
	const FModelTap X = ModelAxis(ProductU, M.SizeX, bPoint, S.AddressU, S.SampleBits);
	const FModelTap Y = ModelAxis(ProductV, M.SizeY, bPoint, S.AddressV, S.SampleBits);
	const auto Read = [&](int i, int j) -> FTexel
	{
		if (X.Texels[i] < 0 || Y.Texels[j] < 0)
		{
			return {S.Border[0], S.Border[1], S.Border[2], S.Border[3]};
		}
		return T.Read(X.Texels[i], Y.Texels[j], Z, Mip);
	};
	FTexel Result;
	for (size_t c = 0; c < 4; ++c)
	{
		const double Left = ModelMix(Read(0, 0)[c], Read(0, 1)[c], Y.Weight);
		const double Right = ModelMix(Read(1, 0)[c], Read(1, 1)[c], Y.Weight);
		Result[c] = ModelMix(Left, Right, X.Weight);
	}
	return Result;
}

// ---- Running the real thing.

template<typename Real>
struct TSamples
{
	std::vector<Real> U;
	std::vector<Real> V;
	std::vector<std::array<Real, 4>> Out;
};

/** Samples everything in groups of N; the count is a multiple of 16. */
template<typename Real, int N>
std::vector<std::array<Real, 4>> RunSample2D(const FKernelTexture& T, const FKernelSampler& S,
	const std::vector<Real>& U, const std::vector<Real>& V, Real Level = 0)
{
	std::vector<std::array<Real, 4>> Results(U.size());
	for (size_t i = 0; i + N <= U.size(); i += N)
	{
		alignas(64) Real Out[4 * N];
		alignas(64) Real LaneU[N];
		alignas(64) Real LaneV[N];
		std::copy_n(&U[i], N, LaneU);
		std::copy_n(&V[i], N, LaneV);
		TSampling<Real, N>::Sample2D(T, S, LaneU, LaneV, nullptr, &Level, true, Out);
		for (size_t Lane = 0; Lane < N; ++Lane)
		{
			Results[i + Lane] = {Out[Lane], Out[N + Lane], Out[2 * N + Lane], Out[3 * N + Lane]};
		}
	}
	return Results;
}

template<typename Real>
void ExpectSameBits(const std::vector<std::array<Real, 4>>& Expected, const std::vector<std::array<Real, 4>>& Actual,
	const std::string& What)
{
	for (size_t i = 0; i < Expected.size(); ++i)
	{
		for (size_t c = 0; c < 4; ++c)
		{
			const bool bBothNan = std::isnan(Expected[i][c]) && std::isnan(Actual[i][c]);
			ASSERT_TRUE(bBothNan || std::memcmp(&Expected[i][c], &Actual[i][c], sizeof(Real)) == 0)
				<< What << " sample " << i << " channel " << c << ": " << Expected[i][c] << " and " << Actual[i][c];
		}
	}
}

template<typename Real>
void ExpectNear(const FTexel& Expected, const std::array<Real, 4>& Actual, double Scale, const std::string& What)
{
	for (size_t c = 0; c < 4; ++c)
	{
		if (std::isnan(Expected[c]) || std::isinf(Expected[c]))
		{
			ASSERT_TRUE(std::isnan(Expected[c]) ? std::isnan(Actual[c]) : double(Actual[c]) == Expected[c])
				<< What << " channel " << c << ": " << Expected[c] << " and " << Actual[c];
		}
		else
		{
			ASSERT_NEAR(Expected[c], double(Actual[c]), Scale) << What << " channel " << c;
		}
	}
}

/** Coordinates of the patterns that have code of their own, and of none: a full row of lanes each. */
template<typename Real>
TSamples<Real> MakeCoordinates(int32_t SizeX, int32_t SizeY, uint32_t Seed)
{
	TSamples<Real> Samples;
	std::mt19937 Engine(Seed);
	std::uniform_real_distribution<double> Anywhere(-1.5, 2.5);
	std::uniform_int_distribution<int32_t> StartX(-20, SizeX + 4);
	std::uniform_int_distribution<int32_t> StartY(-3, SizeY + 3);
	const double Rates[] = {1, 2, 0.5, 0.25, 1.5, 0, -1, 3, 7};
	const double Offsets[][2] = {{0.5, 0.5}, {0, 0}, {1, 0.5}, {0.5, 0.25}, {0.25, 0.625}, {0.7, 0.1}};
	for (double Rate : Rates)
	{
		for (const auto& Offset : Offsets)
		{
			const double X0 = StartX(Engine) + Offset[0];
			const double Y0 = StartY(Engine) + Offset[1];
			for (int Lane = 0; Lane < 16; ++Lane)
			{
				Samples.U.push_back(Real((X0 + Rate * Lane) / SizeX));
				Samples.V.push_back(Real(Y0 / SizeY));
			}
		}
	}
	for (int i = 0; i < 64; ++i)
	{
		Samples.U.push_back(Real(Anywhere(Engine)));
		Samples.V.push_back(Real(Anywhere(Engine)));
	}
	// Huge rows beside consecutive columns.
	for (int Lane = 0; Lane < 16; ++Lane)
	{
		Samples.U.push_back(Real((0.5 + (Lane < 8 ? Lane : 2 * Lane)) / SizeX));
		Samples.V.push_back(Real(8000000.3 / SizeY));
	}
	for (Real Strange :
		{Real(1e30), Real(-1e30), Real(GInf), Real(-GInf), Real(GNanF), Real(1e9), Real(-0.0), Real(12345.678)})
	{
		for (int i = 0; i < 2; ++i)
		{
			Samples.U.push_back(i ? Strange : Real(0.3));
			Samples.V.push_back(i ? Real(0.3) : Strange);
		}
	}
	return Samples;
}

struct FSize
{
	int32_t X;
	int32_t Y;
};
constexpr FSize GSizes[] = {{64, 5}, {37, 21}, {16, 1}, {1, 1}, {1, 9}, {7, 3}, {33, 2}};
constexpr EKernelFilter GFilters[] = {EKernelFilter::Point, EKernelFilter::Bilinear};
constexpr EKernelAddress GAddresses[] = {
	EKernelAddress::Wrap, EKernelAddress::Clamp, EKernelAddress::Mirror, EKernelAddress::Border};

std::string Describe(ETexelStorage Storage, FSize Size, const FKernelSampler& S)
{
	return std::string(GetTexelStorageInfo(Storage).Name) + " " + std::to_string(Size.X) + "x" +
		   std::to_string(Size.Y) + " filter " + std::to_string(int(S.Filter)) + " address " +
		   std::to_string(int(S.AddressU)) + " bits " + std::to_string(S.SampleBits);
}

class FLanesSamplingFormat : public testing::TestWithParam<int>
{
protected:
	ETexelStorage Storage = ETexelStorage(GetParam());

	template<typename F>
	void ForEachCase(F f)
	{
		for (FSize Size : GSizes)
		{
			FTestTexture T(Storage, Size.X, Size.Y);
			T.FillRandom(uint32_t(GetParam()), 0, GetTexelStorageInfo(Storage).Kind == ETexelKind::Uint ? 200 : 1);
			for (EKernelFilter Filter : GFilters)
			{
				for (EKernelAddress Address : GAddresses)
				{
					for (uint8_t Bits : {uint8_t(8), uint8_t(0)})
					{
						FKernelSampler S = MakeSampler(Filter, Address, Bits);
						S.Border[0] = 0.75f;
						S.Border[3] = 0.5f;
						f(T, Size, S);
						if (HasFatalFailure())
						{
							return;
						}
					}
				}
			}
		}
	}
};

TEST_P(FLanesSamplingFormat, FloatFollowsTheModel)
{
	ForEachCase(
		[this](FTestTexture& T, FSize Size, const FKernelSampler& S)
		{
			const TSamples<float> Samples = MakeCoordinates<float>(Size.X, Size.Y, 1);
			const auto Out = RunSample2D<float, 4>(T.Texture, S, Samples.U, Samples.V);
			const double Scale = GetTexelStorageInfo(Storage).Kind == ETexelKind::Uint ? 200 : 1;
			for (size_t i = 0; i < Out.size(); ++i)
			{
				const float ProductU = Samples.U[i] * float(Size.X);
				const float ProductV = Samples.V[i] * float(Size.Y);
				// Unsnapped, x - 0.5 is rounded to float: half a unit in the last place of x, times a step of at most 1
				// per texel.
				const double Far =
					S.SampleBits == 8
						? 0
						: 6e-8 * (std::fmin(std::abs(ProductU), 4.2e6f) + std::fmin(std::abs(ProductV), 4.2e6f));
				ExpectNear(ModelSample(T, S, ProductU, ProductV, 0, 0), Out[i], (4e-7 + Far) * Scale,
					Describe(Storage, Size, S) + " at " + std::to_string(ProductU) + "," + std::to_string(ProductV));
				if (HasFatalFailure())
				{
					return;
				}
			}
		});
}

TEST_P(FLanesSamplingFormat, DoubleFollowsTheModel)
{
	ForEachCase(
		[this](FTestTexture& T, FSize Size, const FKernelSampler& S)
		{
			const TSamples<double> Samples = MakeCoordinates<double>(Size.X, Size.Y, 1);
			const auto Out = RunSample2D<double, 2>(T.Texture, S, Samples.U, Samples.V);
			const double Scale = GetTexelStorageInfo(Storage).Kind == ETexelKind::Uint ? 200 : 1;
			for (size_t i = 0; i < Out.size(); ++i)
			{
				ExpectNear(ModelSample(T, S, Samples.U[i] * Size.X, Samples.V[i] * Size.Y, 0, 0), Out[i], 1e-15 * Scale,
					Describe(Storage, Size, S));
				if (HasFatalFailure())
				{
					return;
				}
			}
		});
}

TEST_P(FLanesSamplingFormat, EveryWidthGivesTheSameBits)
{
	ForEachCase(
		[this](FTestTexture& T, FSize Size, const FKernelSampler& S)
		{
			const TSamples<float> Samples = MakeCoordinates<float>(Size.X, Size.Y, 2);
			const TSamples<double> Exact = MakeCoordinates<double>(Size.X, Size.Y, 2);
			const auto Four = RunSample2D<float, 4>(T.Texture, S, Samples.U, Samples.V);
			const auto Two = RunSample2D<double, 2>(T.Texture, S, Exact.U, Exact.V);
			if (AreLanesSupported(false, 8))
			{
				ExpectSameBits(Four, RunSample2D<float, 8>(T.Texture, S, Samples.U, Samples.V),
					Describe(Storage, Size, S) + " float 8");
				ExpectSameBits(Two, RunSample2D<double, 4>(T.Texture, S, Exact.U, Exact.V),
					Describe(Storage, Size, S) + " double 4");
			}
			if (AreLanesSupported(false, 16))
			{
				ExpectSameBits(Four, RunSample2D<float, 16>(T.Texture, S, Samples.U, Samples.V),
					Describe(Storage, Size, S) + " float 16");
				ExpectSameBits(Two, RunSample2D<double, 8>(T.Texture, S, Exact.U, Exact.V),
					Describe(Storage, Size, S) + " double 8");
			}
		});
}

INSTANTIATE_TEST_SUITE_P(EveryStorage, FLanesSamplingFormat, testing::Range(0, int(ETexelStorage::Count)),
	[](const testing::TestParamInfo<int>& Info) { return GetTexelStorageInfo(ETexelStorage(Info.param)).Name; });

// ---- Single rules.

/** The first lane of a sample of all-equal lanes. */
FTexel SampleOne(const FKernelTexture& T, const FKernelSampler& S, float U, float V, float Level = 0)
{
	const auto Out = RunSample2D<float, 4>(T, S, std::vector<float>(4, U), std::vector<float>(4, V), Level);
	return {Out[0][0], Out[0][1], Out[0][2], Out[0][3]};
}

TEST(LanesSampling, AConstantStaysConstantBitForBit)
{
	FTestTexture T(ETexelStorage::RGBA32_FLOAT, 40, 7);
	const float Value = 0.1f;
	T.ForEachTexel(
		[&](int32_t X, int32_t Y, int32_t Z, int32_t Mip) {
			T.Write({Value, Value, Value, Value}, X, Y, Z, Mip);
		});
	const TSamples<float> Samples = MakeCoordinates<float>(40, 7, 3);
	for (uint8_t Bits : {uint8_t(8), uint8_t(0)})
	{
		for (const auto& Out : RunSample2D<float, 4>(
				 T.Texture, MakeSampler(EKernelFilter::Bilinear, EKernelAddress::Clamp, Bits), Samples.U, Samples.V))
		{
			ASSERT_EQ(Value, Out[2]);
		}
	}
}

TEST(LanesSampling, ANeighbourOfWeightZeroIsNotRead)
{
	FTestTexture T(ETexelStorage::RGBA32_FLOAT, 3, 3);
	T.Write({GInf, GInf, std::nan(""), 1}, 1, 0);
	T.Write({GInf, GInf, std::nan(""), 1}, 0, 1);
	T.Write({2, 3, 4, 5}, 0, 0);
	EXPECT_EQ((FTexel{2, 3, 4, 5}),
		SampleOne(T.Texture, MakeSampler(EKernelFilter::Bilinear, EKernelAddress::Clamp), 0.5f / 3, 0.5f / 3));
}

TEST(LanesSampling, InfinityBesideANumberStaysInfinityFromBothSides)
{
	for (int32_t Side : {0, 1})
	{
		FTestTexture T(ETexelStorage::RGBA16_FLOAT, 2, 1);
		T.Write({1, 1, 1, 1}, 1 - Side, 0);
		T.Write({GInf, -GInf, GInf, 1}, Side, 0);
		EXPECT_EQ((FTexel{GInf, -GInf, GInf, 1}),
			SampleOne(T.Texture, MakeSampler(EKernelFilter::Bilinear, EKernelAddress::Clamp), 0.5f, 0.5f));
	}
}

TEST(LanesSampling, CoordinatesAreSnappedToTheNearest256th)
{
	FTestTexture T(ETexelStorage::R32_FLOAT, 4, 1);
	T.Write({256, 0, 0, 0}, 2, 0);
	const FKernelSampler S = MakeSampler(EKernelFilter::Bilinear, EKernelAddress::Clamp);
	EXPECT_EQ(3, SampleOne(T.Texture, S, (1.5f + 3.49f / 256) / 4, 0.5f)[0]);
	EXPECT_EQ(4, SampleOne(T.Texture, S, (1.5f + 3.5f / 256) / 4, 0.5f)[0]);
}

TEST(LanesSampling, APointSampleJustBelowATexelBorderTakesTheNextTexel)
{
	FTestTexture T(ETexelStorage::R32_FLOAT, 4, 1);
	T.Write({1, 0, 0, 0}, 2, 0);
	const FKernelSampler Snapped = MakeSampler(EKernelFilter::Point, EKernelAddress::Clamp);
	const FKernelSampler Exact = MakeSampler(EKernelFilter::Point, EKernelAddress::Clamp, 0);
	EXPECT_EQ(1, SampleOne(T.Texture, Snapped, 1.999f / 4, 0.5f)[0]);
	EXPECT_EQ(0, SampleOne(T.Texture, Exact, 1.999f / 4, 0.5f)[0]);
}

TEST(LanesSampling, MissingChannelsReadZeroZeroOne)
{
	FTestTexture T(ETexelStorage::R16_FLOAT, 20, 2);
	T.FillRandom(1, 5, 6);
	const FTexel Texel = SampleOne(T.Texture, MakeSampler(EKernelFilter::Bilinear, EKernelAddress::Wrap), 0.4f, 0.9f);
	EXPECT_EQ((FTexel{Texel[0], 0, 0, 1}), Texel);
}

TEST(LanesSampling, NonFiniteTexelsFollowTheModelAtEveryWidth)
{
	for (ETexelStorage Storage : {ETexelStorage::RGBA32_FLOAT, ETexelStorage::RGBA16_FLOAT,
			 ETexelStorage::R11G11B10_FLOAT, ETexelStorage::R16_FLOAT, ETexelStorage::R32_FLOAT})
	{
		FTestTexture T(Storage, 70, 9);
		T.FillRandom(5, 0, 1);
		std::mt19937 Engine(6);
		for (int i = 0; i < 60; ++i)
		{
			const double Strange[] = {GInf, std::nan(""), -GInf};
			const double Value = Strange[Engine() % 3];
			T.Write({Value, 1, Value, Value}, int32_t(Engine() % 70), int32_t(Engine() % 9));
		}
		const FKernelSampler S = MakeSampler(EKernelFilter::Bilinear, EKernelAddress::Clamp);
		const TSamples<float> Samples = MakeCoordinates<float>(70, 9, 7);
		const auto Four = RunSample2D<float, 4>(T.Texture, S, Samples.U, Samples.V);
		for (size_t i = 0; i < Four.size(); ++i)
		{
			ASSERT_NO_FATAL_FAILURE(ExpectNear(ModelSample(T, S, Samples.U[i] * 70.0f, Samples.V[i] * 9.0f, 0, 0),
				Four[i], 4e-7, "sample " + std::to_string(i)));
		}
		if (AreLanesSupported(false, 16))
		{
			ASSERT_NO_FATAL_FAILURE(
				ExpectSameBits(Four, RunSample2D<float, 16>(T.Texture, S, Samples.U, Samples.V), "16"));
		}
		if (AreLanesSupported(false, 8))
		{
			ASSERT_NO_FATAL_FAILURE(
				ExpectSameBits(Four, RunSample2D<float, 8>(T.Texture, S, Samples.U, Samples.V), "8"));
		}
	}
}

} // namespace
} // namespace Drydock::Tests
