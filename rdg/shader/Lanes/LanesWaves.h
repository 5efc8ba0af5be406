// Wave operations: the running lanes of a wave exchange values. A wave is one pack of lanes. Sums and products go from
// the lowest lane to the highest. A lane that does not run reads as 0. Included by generated code only.
#pragma once

#include "Lanes.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

struct FWaveAdd
{
	template<typename T>
	static T Apply(T A, T B)
	{
		return A + B;
	}
};
struct FWaveMultiply
{
	template<typename T>
	static T Apply(T A, T B)
	{
		return A * B;
	}
};
struct FWaveMin
{
	template<typename T>
	static T Apply(T A, T B)
	{
		if constexpr (std::is_integral_v<T>)
		{
			return A < B ? A : B;
		}
		else
		{
			return Min(A, B);
		}
	}
};
struct FWaveMax
{
	template<typename T>
	static T Apply(T A, T B)
	{
		if constexpr (std::is_integral_v<T>)
		{
			return A > B ? A : B;
		}
		else
		{
			return Max(A, B);
		}
	}
};
struct FWaveAnd
{
	template<typename T>
	static T Apply(T A, T B)
	{
		return A & B;
	}
};
struct FWaveOr
{
	template<typename T>
	static T Apply(T A, T B)
	{
		return A | B;
	}
};
struct FWaveXor
{
	template<typename T>
	static T Apply(T A, T B)
	{
		return A ^ B;
	}
};

/** Reduces the values of the running lanes; the result is in all lanes. */
template<typename TOperation, int N, CLanes T>
DRYDOCK_LANES_INLINE T WaveReduce(TMask<N> e, T Value)
{
	auto Result = Value[0];
	bool bFirst = true;
	for (int Lane = 0; Lane < N; ++Lane)
	{
		if (e[Lane])
		{
			Result = bFirst ? Value[Lane] : TOperation::Apply(Result, Value[Lane]);
			bFirst = false;
		}
	}
	return T(Result);
}

/** Reduces the values of the running lanes before each lane; the first has Identity. */
template<typename TOperation, int N, CLanes T, CUniform S>
DRYDOCK_LANES_INLINE T WavePrefix(TMask<N> e, T Value, S Identity)
{
	T Result{};
	S Sum = Identity;
	for (int Lane = 0; Lane < N; ++Lane)
	{
		if (e[Lane])
		{
			Result.V[Lane] = Sum;
			Sum = TOperation::Apply(Sum, S(Value[Lane]));
		}
	}
	return Result;
}

template<int N, CLanes T>
DRYDOCK_LANES_INLINE T WaveRead(TMask<N> e, T Value, TUint<N> From)
{
	T Result{};
	for (int Lane = 0; Lane < N; ++Lane)
	{
		const uint32_t Source = From[Lane];
		if (Source < uint32_t(N) && e[int(Source)])
		{
			Result.V[Lane] = Value.V[Source];
		}
	}
	return Result;
}

template<int N>
DRYDOCK_LANES_INLINE int FirstLane(TMask<N> e)
{
	return __builtin_ctzll(uint64_t(MaskBits(e)) | uint64_t(1) << 63);
}

template<int N, CLanes T>
DRYDOCK_LANES_INLINE T WaveReadFirst(TMask<N> e, T Value)
{
	return WaveRead(e, Value, TUint<N>(uint32_t(FirstLane(e))));
}

template<int N>
DRYDOCK_LANES_INLINE TMask<N> WaveIsFirst(TMask<N> e)
{
	return e & (LaneIndex<N>() == TInt<N>(FirstLane(e)));
}

template<int N, CLanes T>
DRYDOCK_LANES_INLINE TMask<N> WaveAllEqual(TMask<N> e, T Value)
{
	return TMask<N>(!AnyLane(e & (Value != WaveReadFirst(e, Value))));
}
template<int N>
DRYDOCK_LANES_INLINE TMask<N> WaveAllTrue(TMask<N> e, TMask<N> Value)
{
	return TMask<N>(!AnyLane(e & !Value));
}
template<int N>
DRYDOCK_LANES_INLINE TMask<N> WaveAnyTrue(TMask<N> e, TMask<N> Value)
{
	return TMask<N>(AnyLane(e & Value));
}

/** 32 lanes of the ballot: the first ones, or those behind. */
template<int N>
DRYDOCK_LANES_INLINE TUint<N> WaveBallot(TMask<N> e, TMask<N> Value, int Word)
{
	return TUint<N>(uint32_t(uint64_t(MaskBits(e & Value)) >> (32 * Word)));
}

/** Bits of a ballot of two words; bPrefix: of the lanes before each one. */
template<int N>
DRYDOCK_LANES_INLINE TUint<N> WaveCountBits(TUint<N> Low, TUint<N> High, bool bPrefix)
{
	TUint<N> Result{};
	for (int Lane = 0; Lane < N; ++Lane)
	{
		const uint64_t Bits = uint64_t(High[Lane]) << 32 | Low[Lane];
		Result.V[Lane] = uint32_t(__builtin_popcountll(bPrefix ? Bits & ((uint64_t(1) << Lane) - 1) : Bits));
	}
	return Result;
}

/** The lane of the same quad: Index 0 to 3, or, bAcross, 1: across x, 2: across y, 3: both. */
template<int N, CLanes T>
DRYDOCK_LANES_INLINE T QuadRead(TMask<N> e, T Value, TUint<N> Index, bool bAcross)
{
	const TUint<N> Lane = AsUint(LaneIndex<N>());
	return WaveRead(e, Value, bAcross ? Lane ^ Index : (Lane & TUint<N>(~3u)) | (Index & TUint<N>(3u)));
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
