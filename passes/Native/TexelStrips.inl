// Rows of texels as floats side by side, 1, 2 or 4 to a texel, and back: filters that treat all channels alike then
// need no channel apart, and the wide formats are a plain load and store. Included by the lanes code of native kernels
// only.
#pragma once

#include "LanesSamplingGeneral.inl"
#include "Native/LaneShuffle.inl"
#include "Native/TapSum.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** Floats to a texel of a strip that is to be stored in this format. */
inline int32_t GetStripChannels(ETexelStorage Storage)
{
	const int32_t Channels = GetTexelStorageInfo(Storage).NumChannels;
	return Channels == 3 ? 4 : Channels;
}

/** f(std::integral_constant<int, C>) for 1, 2 or 4 floats to a texel. */
template<typename F>
DRYDOCK_LANES_INLINE void VisitStripChannels(int32_t Channels, F f)
{
	if (Channels == 1)
	{
		f(std::integral_constant<int, 1>{});
	}
	else if (Channels == 2)
	{
		f(std::integral_constant<int, 2>{});
	}
	else
	{
		f(std::integral_constant<int, 4>{});
	}
}

/** Every second texel of A and B side by side, from First, 0 or 1, on. */
template<int C, int First, typename FFloat>
DRYDOCK_LANES_INLINE FFloat PickTexels(FFloat A, FFloat B)
{
	return ShuffleLanes(A, B, [](int Lane) { return (Lane / C * 2 + First) * C + Lane % C; });
}

/** Texels that one step of a strip reads or writes. */
template<int N, int C, typename FFormat>
constexpr int TexelsOfStep = C == 4 && FFormat::bWide ? N / 4 : N;

template<int N, int C, typename FFormat>
DRYDOCK_LANES_INLINE void DecodeStep(FFormat Format, const uint8_t* P, float* Out)
{
	using FFloat = TRaw<float, N>;
	using FUint = TRaw<uint32_t, N>;
	if constexpr (C == 4 && FFormat::bWide)
	{
		StoreRaw(Out, FFormat::template Load<N>(P));
		return;
	}
	FFloat Channels[4];
	if constexpr (std::is_same_v<FFormat, FAnyFormat>)
	{
		LoadTexels<float, N>(Format.Storage, P, Channels);
	}
	else
	{
		LoadTexelsOf<FFormat, float, N>(P, Channels);
	}
	if constexpr (C == 1)
	{
		StoreRaw(Out, Channels[0]);
	}
	else if constexpr (C == 2)
	{
		const FUint Words[2] = {FUint(Channels[0]), FUint(Channels[1])};
		FUint Rows[2];
		TLaneOps<N>::Interleave(Words, Rows);
		StoreRaw(Out, Rows);
	}
	else
	{
		FFloat Texels[4];
		TLaneOps<N>::Join(Channels, Texels);
		StoreRaw(Out, Texels);
	}
}

/** Count texels from P on. Out takes whole steps: up to N texels more. Later: bytes to texels that are read soon and
 *  asked for meanwhile; all at once, they would wait for each other. */
template<int N, int C>
inline void DecodeStrip(ETexelStorage Storage, const uint8_t* P, int32_t Count, float* Out, ptrdiff_t Later = 0)
{
	const auto Decode = [&](auto Format)
	{
		constexpr int32_t Step = TexelsOfStep<N, C, decltype(Format)>;
		int32_t X = 0;
		for (; X + Step <= Count; X += Step)
		{
			const uint8_t* const Texels = P + int64_t(X) * Format.Bytes;
			__builtin_prefetch(Texels + Later);
			DecodeStep<N, C>(Format, Texels, Out + int64_t(X) * C);
		}
		if (X < Count)
		{
			alignas(64) uint8_t Copy[N * 16] = {};
			__builtin_memcpy(Copy, P + int64_t(X) * Format.Bytes, size_t(Count - X) * size_t(Format.Bytes));
			DecodeStep<N, C>(Format, Copy, Out + int64_t(X) * C);
		}
		return true;
	};
	if (!VisitPictureFormat(Storage, Decode))
	{
		Decode(FAnyFormat{Storage, GetTexelStorageInfo(Storage).BytesPerTexel});
	}
}

/** Asks for texels of a row that is decoded soon: a tile's rows lie far apart, and the processor does not foresee them.
 */
inline void PrefetchTexels(const FKernelMip& Mip, int32_t Bytes, int32_t Row, int32_t First, int32_t Count)
{
	constexpr int32_t Line = 64;
	const int32_t Begin = First < 0 ? 0 : First;
	const int32_t End = First + Count < Mip.SizeX ? First + Count : Mip.SizeX;
	const uint8_t* const Texels = Mip.Data + int64_t(Row) * Mip.RowPitch;
	for (int32_t X = Begin * Bytes; X < End * Bytes; X += Line)
	{
		__builtin_prefetch(Texels + X);
	}
}

/** Texels First to First + Count of a row whose texels RectMin to RectMax are known; beyond them the edge texel. */
template<int N, int C>
inline void DecodeHeldStrip(ETexelStorage Storage, const uint8_t* Row, int32_t RectMin, int32_t RectMax, int32_t First,
	int32_t Count, float* Out, ptrdiff_t Later = 0)
{
	const int32_t Bytes = GetTexelStorageInfo(Storage).BytesPerTexel;
	const int32_t End = First + Count;
	// One texel of the rect is decoded at least: the edge.
	const int32_t RunBegin = First < RectMin ? RectMin : First > RectMax - 1 ? RectMax - 1 : First;
	const int32_t RunEnd = End > RectMax ? RectMax : End < RunBegin + 1 ? RunBegin + 1 : End;
	const int32_t Before = RunBegin - First;
	if (Before < 0 || Before >= Count)
	{
		// All of the strip lies on one side of the rect.
		alignas(64) float Edge[4 * N];
		DecodeStrip<N, C>(Storage, Row + int64_t(RunBegin) * Bytes, 1, Edge);
		for (int32_t X = 0; X < Count; ++X)
		{
			__builtin_memcpy(Out + int64_t(X) * C, Edge, C * sizeof(float));
		}
		return;
	}
	DecodeStrip<N, C>(Storage, Row + int64_t(RunBegin) * Bytes, RunEnd - RunBegin, Out + int64_t(Before) * C, Later);
	float Edge[C];
	__builtin_memcpy(Edge, Out + int64_t(Before) * C, sizeof(Edge));
	for (int32_t X = 0; X < Before; ++X)
	{
		__builtin_memcpy(Out + int64_t(X) * C, Edge, sizeof(Edge));
	}
	__builtin_memcpy(Edge, Out + int64_t(RunEnd - 1 - First) * C, sizeof(Edge));
	for (int32_t X = RunEnd - First; X < Count; ++X)
	{
		__builtin_memcpy(Out + int64_t(X) * C, Edge, sizeof(Edge));
	}
}

/** One step, as EncodeTexel does it. */
template<int N, int C, typename FFormat>
DRYDOCK_LANES_INLINE void EncodeStep(FFormat Format, bool bSaturate, const float* From, uint8_t* P)
{
	using FFloat = TRaw<float, N>;
	using FUint = TRaw<uint32_t, N>;
	if constexpr (C == 4 && FFormat::bWide)
	{
		FFormat::template Store<N>(P, LoadRaw<FFloat>(From));
		return;
	}
	FFloat Channels[4] = {};
	if constexpr (C == 1)
	{
		Channels[0] = LoadRaw<FFloat>(From);
	}
	else if constexpr (C == 2)
	{
		FUint Words[2];
		TLaneOps<N>::Deinterleave(LoadRaw<FUint>(From), LoadRaw<FUint>(From + N), Words);
		Channels[0] = FFloat(Words[0]);
		Channels[1] = FFloat(Words[1]);
	}
	else
	{
		FFloat Texels[4];
		__builtin_memcpy(Texels, From, sizeof(Texels));
		TLaneOps<N>::Split(Texels, Channels);
	}
	if constexpr (std::is_same_v<FFormat, FAnyFormat>)
	{
		alignas(64) float Values[4 * N];
		__builtin_memcpy(Values, Channels, sizeof(Values));
		StoreTexels<float, N>(Format.Storage, bSaturate, P, Values);
	}
	else
	{
		StoreTexelsOf<FFormat, float, N>(P, Channels);
	}
}

/** Count texels to P, with the bits of EncodeTexel. From is read in whole steps. */
template<int N, int C>
inline void EncodeStrip(const FKernelTexture& Target, const float* From, int32_t Count, uint8_t* P)
{
	const bool bSaturate = Target.bSaturateStore != 0;
	const auto Encode = [&](auto Format)
	{
		constexpr int32_t Step = TexelsOfStep<N, C, decltype(Format)>;
		int32_t X = 0;
		for (; X + Step <= Count; X += Step)
		{
			EncodeStep<N, C>(Format, bSaturate, From + int64_t(X) * C, P + int64_t(X) * Format.Bytes);
		}
		if (X < Count)
		{
			alignas(64) uint8_t Copy[N * 16];
			EncodeStep<N, C>(Format, bSaturate, From + int64_t(X) * C, Copy);
			__builtin_memcpy(P + int64_t(X) * Format.Bytes, Copy, size_t(Count - X) * size_t(Format.Bytes));
		}
		return true;
	};
	if (bSaturate || !VisitPictureFormat(Target.Storage, Encode))
	{
		Encode(FAnyFormat{Target.Storage, GetTexelStorageInfo(Target.Storage).BytesPerTexel});
	}
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
