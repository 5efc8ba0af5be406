// Provides what generated kernels need beyond the lane vocabulary: array elements at run-time indices, offsets into
// buffers, counters, and values kept over a tile. Included by generated code only.
#pragma once

#include "Lanes.h"
#include "LanesAtomics.h"
#include "LanesQuads.h"
#include "LanesSamples.h"
#include "LanesTapReads.h"
#include "LanesWaves.h"
#include "LanesWide.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** Index into an array of Count elements; what is out of range (also negative) becomes the last element. */
DRYDOCK_LANES_INLINE int32_t ClampIndex(uint32_t Index, uint32_t Count)
{
	return int32_t(Index < Count ? Index : Count - 1);
}
template<int N>
DRYDOCK_LANES_INLINE TInt<N> ClampIndex(TUint<N> Index, uint32_t Count)
{
	return AsInt(Min(Index, TUint<N>(Count - 1)));
}
template<int N>
DRYDOCK_LANES_INLINE TInt<N> ClampIndex(TInt<N> Index, uint32_t Count)
{
	return ClampIndex(AsUint(Index), Count);
}

/** Elements[Index], the index per lane and in range. */
template<int N, CUniform T>
DRYDOCK_LANES_INLINE auto PickElement(const T* Elements, TInt<N> Index)
{
	using FReal = std::conditional_t<std::is_same_v<T, double>, double, float>;
	std::conditional_t<std::is_same_v<T, int32_t>, TInt<N>,
		std::conditional_t<std::is_same_v<T, uint32_t>, TUint<N>,
			std::conditional_t<std::is_same_v<T, bool>, TMask<N>, TReal<FReal, N>>>>
		Result;
	for (int Lane = 0; Lane < N; ++Lane)
	{
		if constexpr (std::is_same_v<T, bool>)
		{
			Result.V[Lane] = -int32_t(Elements[Index.V[Lane]]);
		}
		else
		{
			Result.V[Lane] = Elements[Index.V[Lane]];
		}
	}
	return Result;
}
template<int N, CLanes T>
DRYDOCK_LANES_INLINE T PickElement(const T* Elements, TInt<N> Index)
{
	T Result;
	for (int Lane = 0; Lane < N; ++Lane)
	{
		Result.V[Lane] = Elements[Index.V[Lane]].V[Lane];
	}
	return Result;
}
template<typename T>
DRYDOCK_LANES_INLINE const T& PickElement(const T* Elements, int32_t Index)
{
	return Elements[Index];
}

/** Elements[Index] = Value in the lanes of the mask. */
template<int N, CLanes T>
DRYDOCK_LANES_INLINE void PutElement(TMask<N> Mask, T* Elements, TInt<N> Index, T Value)
{
	for (int Lane = 0; Lane < N; ++Lane)
	{
		if (Mask[Lane])
		{
			Elements[Index.V[Lane]].V[Lane] = Value.V[Lane];
		}
	}
}

/** A constant at a byte offset per lane, which is in range. */
template<typename T, int N>
DRYDOCK_LANES_INLINE auto ReadConstant(const uint8_t* Data, TInt<N> Offset)
{
	std::conditional_t<std::is_same_v<T, int32_t>, TInt<N>,
		std::conditional_t<std::is_same_v<T, uint32_t>, TUint<N>, TReal<float, N>>>
		Result;
	for (int Lane = 0; Lane < N; ++Lane)
	{
		Result.V[Lane] = ReadConstant<T>(Data, uint32_t(Offset.V[Lane]));
	}
	return Result;
}
template<typename Real, int N>
DRYDOCK_LANES_INLINE TReal<Real, N> WidenReal(TReal<float, N> X)
{
	return TReal<Real, N>(__builtin_convertvector(X.V, TRaw<Real, N>));
}
template<typename Real>
DRYDOCK_LANES_INLINE Real WidenReal(float X)
{
	return Real(X);
}

/** Byte offset of a member of an element; an element that does not exist has an offset past every buffer. */
DRYDOCK_LANES_INLINE uint32_t ElementOffset(
	const FKernelBuffer& Buffer, uint32_t Index, uint32_t Stride, uint32_t Member)
{
	return Index < Buffer.SizeInBytes / Stride ? Index * Stride + Member : 0xFFFFFFFFu;
}
template<int N>
DRYDOCK_LANES_INLINE TUint<N> ElementOffset(
	const FKernelBuffer& Buffer, TUint<N> Index, uint32_t Stride, uint32_t Member)
{
	return Select(Index < TUint<N>(Buffer.SizeInBytes / Stride), Index * TUint<N>(Stride) + TUint<N>(Member),
		TUint<N>(0xFFFFFFFFu));
}
template<int N>
DRYDOCK_LANES_INLINE TUint<N> ElementOffset(
	const FKernelBuffer& Buffer, TInt<N> Index, uint32_t Stride, uint32_t Member)
{
	return ElementOffset(Buffer, AsUint(Index), Stride, Member);
}

/** Adds the lanes of the mask to one counter, if the run counts. */
template<int N>
DRYDOCK_LANES_INLINE void CountLanesOf(const FKernelArgs& Args, uint64_t FKernelCounters::*Counter, TMask<N> Mask)
{
	if (__builtin_expect(Args.Counters != nullptr, 0))
	{
		Args.Counters->*Counter += CountLanes(Mask);
	}
}

/** Turns that a loop may take; never one more than these. */
DRYDOCK_LANES_INLINE uint32_t GetLoopTurns(const FKernelArgs& Args)
{
	return Args.Limits ? Args.Limits->LoopTurns : 0xFFFFFFFFu;
}

/** Reports a loop that took more turns. The call does not return, so no state has to be kept for it, and counting costs
 * next to nothing. */
[[noreturn]] DRYDOCK_LANES_INLINE void EndLoop(
	const FKernelArgs& Args, const char* File, int32_t Line, int32_t X, int32_t Y, int32_t Z)
{
	Args.Limits->OnEndlessLoop(File, Line, X, Y, Z);
	__builtin_unreachable();
}

/** Values that are computed anew in each turn of a loop, and alike by all packs of a tile: the first packs that come to
 * a turn compute them for the others. */
template<typename Real>
class TTurns
{
public:
	template<typename F>
	DRYDOCK_LANES_INLINE Real Get(uint32_t Turn, F Compute)
	{
		if (Turn < NumKnown)
		{
			return Values[Turn];
		}
		const Real Value = Compute();
		if (Turn == NumKnown && Turn < Capacity)
		{
			Values[Turn] = Value;
			++NumKnown;
		}
		return Value;
	}

private:
	static constexpr uint32_t Capacity = 64;
	uint32_t NumKnown = 0;
	Real Values[Capacity];
};

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
