// Random cases for operations on texels, and how what every width gives is compared with one lane.
#pragma once

#include <gtest/gtest.h>

#include "LanesResources.h"
#include "LanesScalarCalls.h"
#include "LanesTestRandom.h"
#include "LanesTestTexture.h"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

namespace Drydock::Tests
{

using Lanes::TSampling;

/** Lanes of a case: the widest pack, two of the middle one, four of the narrowest. */
inline constexpr int GLanes = 16;

using FFloats = std::array<float, GLanes>;
using FInts = std::array<int32_t, GLanes>;

inline constexpr EKernelFilter GFilters[] = {EKernelFilter::Point, EKernelFilter::Bilinear, EKernelFilter::Trilinear};
inline constexpr EKernelAddress GAddresses[] = {
	EKernelAddress::Wrap, EKernelAddress::Clamp, EKernelAddress::Mirror, EKernelAddress::Border};

class FLanesRandom : public FTestRandom
{
public:
	using FTestRandom::FTestRandom;

	FKernelSampler Sampler()
	{
		return {Pick(GFilters), Pick(GAddresses), Pick(GAddresses), Pick(GAddresses), uint8_t(Int(0, 3) ? 8 : 0),
			Int(0, 3) ? 0.0f : Float(-1, 2), {Float(0, 1), Float(0, 1), Float(0, 1), Float(0, 1)}};
	}

	/** Normalised coordinates of a row of pixels or of scattered ones; now and then what is no place at all. */
	FFloats Coordinates(int32_t Size)
	{
		const float Rates[] = {0, 0, 1, 1, 2, 0.5f, -1, 0.3f, 5};
		const float Strange[] = {
			std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1e30f, 12345.678f, -0.0f};
		const float First = Float(-Size, 2 * Size);
		const float Rate = Pick(Rates);
		const bool bScattered = Int(0, 2) == 0;
		FFloats Result;
		for (int Lane = 0; Lane < GLanes; ++Lane)
		{
			const float Texel = bScattered ? Float(-1.5 * Size, 2.5 * Size) : First + Rate * float(Lane);
			Result[size_t(Lane)] = (Int(0, 1) ? Texel : std::floor(Texel) + 0.5f) / float(Size);
			if (Int(0, 99) == 0)
			{
				Result[size_t(Lane)] = Pick(Strange);
			}
		}
		return Result;
	}

	/** Texel indices, a few of them outside. */
	FInts Indices(int32_t Size)
	{
		const int32_t Strange[] = {-1, 0x7FFFFFFF, int32_t(0x80000000), 1 << 24};
		const int32_t Kind = Int(0, 2);
		const int32_t First = Int(-3, Size);
		FInts Result;
		for (int Lane = 0; Lane < GLanes; ++Lane)
		{
			Result[size_t(Lane)] = Kind == 0 ? First : Kind == 1 ? First + Lane : Int(-1, Size);
			if (Int(0, 59) == 0)
			{
				Result[size_t(Lane)] = Pick(Strange);
			}
		}
		return Result;
	}

	FInts Mask()
	{
		const int32_t Kind = Int(0, 2);
		FInts Result;
		for (int32_t& Lane : Result)
		{
			Lane = Kind == 0 ? -Int(0, 1) : -1;
		}
		return Result;
	}
};

/** f(First lane) of each pack of N of a case. */
template<int N, typename F>
void ForEachPack(F f)
{
	for (int First = 0; First < GLanes; First += N)
	{
		f(First);
	}
}

/** Four channels of all lanes. */
template<typename Scalar>
using TOutput = std::array<std::array<Scalar, GLanes>, 4>;

/** Call(First, Out) for packs of N; Out is [4][N]. */
template<int N, typename Scalar, typename F>
TOutput<Scalar> Collect(F Call)
{
	TOutput<Scalar> Result;
	ForEachPack<N>(
		[&](int First)
		{
			alignas(64) Scalar Out[4 * N];
			Call(First, Out);
			for (int i = 0; i < 4 * N; ++i)
			{
				Result[size_t(i / N)][size_t(First + i % N)] = Out[i];
			}
		});
	return Result;
}

/** Runs f<N>() for one lane and for every width, and compares what it gives. */
template<typename F>
void ExpectTheSame(const std::string& What, F f)
{
	const auto Expected = f.template operator()<1>();
	const uint64_t ScalarCalls = GetScalarCalls();
	const auto Compare = [&](const auto& Actual, int N)
	{
		for (size_t i = 0; i < Expected.size(); ++i)
		{
			ASSERT_EQ(0, std::memcmp(&Expected[i], &Actual[i], sizeof(Expected[i])))
				<< What << ", " << N << " lanes, differs in part " << i;
		}
	};
	ASSERT_NO_FATAL_FAILURE(Compare(f.template operator()<4>(), 4));
	if (AreLanesSupported(false, 8))
	{
		ASSERT_NO_FATAL_FAILURE(Compare(f.template operator()<8>(), 8));
	}
	if (AreLanesSupported(false, 16))
	{
		ASSERT_NO_FATAL_FAILURE(Compare(f.template operator()<16>(), 16));
	}
	ASSERT_EQ(ScalarCalls, GetScalarCalls()) << What << " went lane by lane";
}

} // namespace Drydock::Tests
