// Taps: what was learned at one pack gives at others what the sampler gives there, bit for bit, at every float width.
#include <gtest/gtest.h>

#include "LanesResources.h"
#include "LanesTapReads.h"
#include "LanesTaps.h"
#include "LanesTestRandom.h"
#include "LanesTestTexture.h"

#include <cmath>
#include <limits>
#include <string>

namespace Drydock::Tests
{
namespace
{

using Lanes::EWholeTexels;
using Lanes::FKernelTap;
using Lanes::TSampling;

constexpr int GColumns = 96;
constexpr int GRows = 5;

struct FCase
{
	std::string Name;
	FKernelTexture Texture;
	FKernelSampler Sampler;
	float U[GColumns]; // of a pixel of column X
	float V[GRows];
	int32_t X[GColumns];
	int32_t Y[GRows];
	float Level;
	int32_t Mip;
};

/** Kernels compare these members of a tap that has learned nothing. A memory checker names a member that is not
 * written. */
TEST(LanesTap, ForgottenOnesAreWrittenAsFarAsTheyAreCompared)
{
	FKernelTap Taps[2];
	std::memset(static_cast<void*>(Taps), 0xCD, sizeof(Taps));
	Lanes::ForgetTaps(Taps);
	for (const FKernelTap& Tap : Taps)
	{
		EXPECT_EQ(0, Tap.Begin);
		EXPECT_EQ(0u, Tap.Length);
	}
}

/** Visits the packs of a tile in turn, as a kernel does: reads what the tap knows, learns the rest. Gives the number of
 *  packs that were read. */
template<int N, typename FLearn, typename FReference>
int Visit(const FCase& Case, FLearn Learn, FReference Reference)
{
	FKernelTap Tap;
	Tap.Length = 0;
	int NumKnown = 0;
	for (int Row = 0; Row < GRows; ++Row)
	{
		for (int Column = 0; Column < GColumns; Column += N)
		{
			alignas(64) float Actual[4 * N];
			alignas(64) float Expected[4 * N];
			Reference(Row, Column, Expected);
			const bool bInside = uint32_t(Column) - uint32_t(Tap.Begin) < Tap.Length && Tap.Row == Row;
			const bool bKnown = bInside && Tap.Function(Tap, Column, Actual);
			if (!bKnown)
			{
				Learn(Row, Column, Actual, Tap);
			}
			NumKnown += bKnown;
			EXPECT_EQ(0, std::memcmp(Expected, Actual, sizeof(Actual)))
				<< Case.Name << ", " << N << " lanes, row " << Row << ", column " << Column
				<< (bKnown ? ", known" : "");
			if (bKnown && Tap.Kind != EWholeTexels::None)
			{
				// The kernel reads whole texels by itself.
				const bool bHalf = Tap.Kind == EWholeTexels::Half;
				const uint8_t* const Texels = Tap.Row0 + Tap.Column + int64_t(Column) * Tap.Stride;
				for (int Lane = 0; Lane < N; ++Lane)
				{
					float Texel[4];
					DecodeTexel(bHalf ? ETexelStorage::RGBA16_FLOAT : ETexelStorage::RGBA32_FLOAT,
						Texels + Lane * (bHalf ? 8 : 16), Texel);
					for (int c = 0; c < 4; ++c)
					{
						EXPECT_EQ(0, std::memcmp(&Texel[c], &Expected[c * N + Lane], 4)) << Case.Name;
					}
				}
			}
		}
	}
	return NumKnown;
}

template<int N>
int VisitSamples(const FCase& Case)
{
	const auto Fill = [](float Value)
	{
		std::array<float, N> Lanes;
		Lanes.fill(Value);
		return Lanes;
	};
	return Visit<N>(
		Case,
		[&](int Row, int Column, float* Out, FKernelTap& Tap)
		{
			TSampling<float, N>::LearnSample2D(Case.Texture, Case.Sampler, Case.U + Column, Fill(Case.V[Row]).data(),
				Case.Level, Out, Tap, Column, Row);
		},
		[&](int Row, int Column, float* Out)
		{
			for (int Lane = 0; Lane < N; ++Lane)
			{
				float One[4];
				TSampling<float, 1>::Sample2D(
					Case.Texture, Case.Sampler, &Case.U[Column + Lane], &Case.V[Row], nullptr, &Case.Level, true, One);
				for (int c = 0; c < 4; ++c)
				{
					Out[c * N + Lane] = One[c];
				}
			}
		});
}

template<int N>
int VisitLoads(const FCase& Case)
{
	const auto Fill = [](int32_t Value)
	{
		std::array<int32_t, N> Lanes;
		Lanes.fill(Value);
		return Lanes;
	};
	return Visit<N>(
		Case,
		[&](int Row, int Column, float* Out, FKernelTap& Tap)
		{
			TSampling<float, N>::LearnLoad2D(
				Case.Texture, Case.X + Column, Fill(Case.Y[Row]).data(), Case.Mip, Out, Tap, Column, Row);
		},
		[&](int Row, int Column, float* Out)
		{
			for (int Lane = 0; Lane < N; ++Lane)
			{
				float One[4];
				TSampling<float, 1>::Load(
					Case.Texture, &Case.X[Column + Lane], &Case.Y[Row], nullptr, &Case.Mip, true, One);
				for (int c = 0; c < 4; ++c)
				{
					Out[c * N + Lane] = One[c];
				}
			}
		});
}

/** f<N>(Case) for every width; the numbers of packs read, summed. */
template<typename F>
int SumOverWidths(F f)
{
	int Sum = f.template operator()<4>();
	if (AreLanesSupported(false, 8))
	{
		Sum += f.template operator()<8>();
	}
	if (AreLanesSupported(false, 16))
	{
		Sum += f.template operator()<16>();
	}
	return Sum;
}

void MakeAxis(FTestRandom& Random, int32_t Size, int32_t Count, float* Coordinates, int32_t* Indices)
{
	const float Rates[] = {1, 1, 1, 2, 2, 0.5f, -1, 0, 0.3f, 3, 1e8f, std::numeric_limits<float>::quiet_NaN()};
	const float Offsets[] = {0, 0.5f, -0.5f, 1, -3, 0.25f, 1.0f / 512, 1e6f, -1e30f};
	const float Rate = Random.Pick(Rates);
	const float Offset = Random.Pick(Offsets);
	const int32_t Shift = Random.Int(-4, 4);
	const bool bClamped = Random.Int(0, 1) != 0;
	for (int32_t i = 0; i < Count; ++i)
	{
		const float Texel = (float(i) + 0.5f) * Rate + Offset;
		Coordinates[i] = Texel * (1.0f / float(Size));
		Indices[i] = i + Shift;
		if (bClamped)
		{
			Coordinates[i] = std::min(std::max(Coordinates[i], 0.0f), 1.0f);
			Indices[i] = std::min(std::max(Indices[i], 0), Size - 1);
		}
	}
}

} // namespace

TEST(FLanesTap, WhatIsKnownIsWhatTheSamplerGives)
{
	const ETexelStorage Storages[] = {ETexelStorage::RGBA32_FLOAT, ETexelStorage::RGBA16_FLOAT,
		ETexelStorage::R11G11B10_FLOAT, ETexelStorage::R32_FLOAT, ETexelStorage::R16_FLOAT, ETexelStorage::RG16_FLOAT,
		ETexelStorage::RGBA8_UNORM, ETexelStorage::BGRA8_UNORM, ETexelStorage::RGB10A2_UNORM, ETexelStorage::R8_UNORM,
		ETexelStorage::RGBA8_SRGB, ETexelStorage::RGBA16_UNORM, ETexelStorage::RG32_FLOAT};
	const EKernelAddress Addresses[] = {
		EKernelAddress::Wrap, EKernelAddress::Clamp, EKernelAddress::Mirror, EKernelAddress::Border};
	const EKernelFilter Filters[] = {EKernelFilter::Point, EKernelFilter::Bilinear, EKernelFilter::Trilinear};
	FTestRandom Random(1);
	int NumKnown = 0;
	for (int Round = 0; Round < 600; ++Round)
	{
		const ETexelStorage Storage = Random.Pick(Storages);
		const int32_t Size = Random.Int(0, 2) ? Random.Int(60, 200) : Random.Int(1, 67);
		FTestTexture Texture(Storage, Size, Random.Int(1, 9), 1, Random.Int(1, 2));
		Texture.FillRandom(uint32_t(Round), -1, 2);
		const bool bFloat = Storage == ETexelStorage::RGBA32_FLOAT || Storage == ETexelStorage::RGBA16_FLOAT;
		for (int i = Random.Int(0, 2); bFloat && i > 0; --i)
		{
			const double Strange[] = {
				std::numeric_limits<double>::quiet_NaN(), -0.0, std::numeric_limits<double>::infinity(), 1e-6};
			Texture.Write({Random.Pick(Strange), 1, Random.Pick(Strange), 1}, Random.Int(0, Size - 1), 0);
		}
		FCase Case = {"round " + std::to_string(Round), Texture.Texture,
			{Random.Pick(Filters), Random.Pick(Addresses), Random.Pick(Addresses), EKernelAddress::Clamp,
				uint8_t(Random.Int(0, 7) ? 8 : 0), 0, {0.5f, -0.0f, 2, 1}},
			{}, {}, {}, {}, Random.Int(0, 1) ? 0.0f : Random.Float(-1, 2), Random.Int(0, 1)};
		MakeAxis(Random, Texture.Texture.Mips[0].SizeX, GColumns, Case.U, Case.X);
		MakeAxis(Random, Texture.Texture.Mips[0].SizeY, GRows, Case.V, Case.Y);
		NumKnown += SumOverWidths([&]<int N>() { return VisitSamples<N>(Case) + VisitLoads<N>(Case); });
		ASSERT_FALSE(HasFailure()) << "round " << Round;
	}
	EXPECT_GT(NumKnown, 1000);
}

// A picture as large as the tile, sampled where its texels lie: all but the first row and the first pack of the others.
TEST(FLanesTap, ATileIsLearnedFromItsEdges)
{
	FTestTexture Texture(ETexelStorage::RGBA16_FLOAT, GColumns, GRows);
	Texture.FillRandom(1, 0, 1);
	FCase Case = {"whole texels", Texture.Texture,
		{EKernelFilter::Bilinear, EKernelAddress::Clamp, EKernelAddress::Clamp, EKernelAddress::Clamp, 8, 0, {}}, {},
		{}, {}, {}, 0, 0};
	for (int i = 0; i < GColumns; ++i)
	{
		Case.U[i] = (float(i) + 0.5f) / GColumns;
		Case.X[i] = i;
	}
	for (int i = 0; i < GRows; ++i)
	{
		Case.V[i] = (float(i) + 0.5f) / GRows;
		Case.Y[i] = i;
	}
	const auto Expect = []<int N>(int NumKnown)
	{
		EXPECT_EQ((GRows - 1) * (GColumns / N - 1), NumKnown) << N << " lanes";
		return 0;
	};
	SumOverWidths([&]<int N>() { return Expect.template operator()<N>(VisitSamples<N>(Case)); });
	SumOverWidths([&]<int N>() { return Expect.template operator()<N>(VisitLoads<N>(Case)); });
}

// A picture of half the tile's size, drawn large: what its own texels reach, whichever way weights take turns.
TEST(FLanesTap, AMagnifiedTileIsLearned)
{
	for (const ETexelStorage Storage : {ETexelStorage::RGBA32_FLOAT, ETexelStorage::RGBA16_FLOAT})
	{
		FTestTexture Texture(Storage, GColumns / 2, GRows);
		Texture.FillRandom(2, -1, 1);
		Texture.Write({-0.0, std::numeric_limits<double>::infinity(), 1, 0}, 20, 1);
		for (const float Offset : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f / 256, 0.5f - 1.0f / 256})
		{
			FCase Case = {"magnified", Texture.Texture,
				{EKernelFilter::Bilinear, EKernelAddress::Clamp, EKernelAddress::Clamp, EKernelAddress::Clamp, 8, 0,
					{}},
				{}, {}, {}, {}, 0, 0};
			for (int i = 0; i < GColumns; ++i)
			{
				Case.U[i] = (float(i) * 0.5f + 0.25f + Offset) / (GColumns / 2);
			}
			for (int i = 0; i < GRows; ++i)
			{
				Case.V[i] = (float(i) * 0.5f + 0.25f) / GRows;
			}
			const auto Expect = []<int N>(int NumKnown)
			{
				// But those at the borders, the one that learns, and what infinity makes a NaN.
				EXPECT_LE(N == 4 ? 0 : (GRows - 1) * (GColumns / N - 2) / 2, NumKnown) << N << " lanes";
				return 0;
			};
			SumOverWidths([&]<int N>() { return Expect.template operator()<N>(VisitSamples<N>(Case)); });
		}
	}
}

} // namespace Drydock::Tests
