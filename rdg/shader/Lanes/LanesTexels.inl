// N texels of any format at once: read from a row or from anywhere, filtered from separate taps, written to a row. The
// one way of whatever has no tuned path of its own: borders, volumes, layers per lane, gathers, texel loads and stores,
// blending, typed buffers. Included by the LanesSampling_*.cpp only.
#pragma once

#include "LanesFormats.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** Number of words of a texel; the last word may have fewer than four bytes. */
template<typename FFormat>
constexpr int WordsOf = (FFormat::Bytes + 3) / 4;

/** N neighbouring texels as words. */
template<typename FFormat, int N>
DRYDOCK_LANES_INLINE void LoadWords(const uint8_t* P, TRaw<uint32_t, N>* W)
{
	using FWord = TRaw<uint32_t, N>;
	if constexpr (FFormat::Bytes == 1)
	{
		W[0] = __builtin_convertvector(LoadRaw<TRaw<uint8_t, N>>(P), FWord);
	}
	else if constexpr (FFormat::Bytes == 2)
	{
		W[0] = __builtin_convertvector(LoadRaw<TRaw<uint16_t, N>>(P), FWord);
	}
	else if constexpr (FFormat::Bytes == 4)
	{
		W[0] = LoadRaw<FWord>(P);
	}
	else if constexpr (FFormat::Bytes == 8)
	{
		TLaneOps<N>::Deinterleave(LoadRaw<FWord>(P), LoadRaw<FWord>(P + N * 4), W);
	}
	else
	{
		for (int k = 0; k < WordsOf<FFormat>; ++k)
		{
			W[k] = TLaneOps<N>::Gather(P + 4 * k, LaneIndex<N>().V * FFormat::Bytes);
		}
	}
}

/** The texels at Base + Offsets as words. A gather reads a whole word: the margin of a texture's memory allows it. */
template<typename FFormat, int N>
DRYDOCK_LANES_INLINE void GatherWords(const uint8_t* Base, TRaw<int32_t, N> Offsets, TRaw<uint32_t, N>* W)
{
	for (int k = 0; k < WordsOf<FFormat>; ++k)
	{
		W[k] = TLaneOps<N>::Gather(Base + 4 * k, Offsets);
	}
}

template<typename FFormat, int N>
DRYDOCK_LANES_INLINE void StoreWords(uint8_t* P, const TRaw<uint32_t, N>* W)
{
	if constexpr (FFormat::Bytes == 1)
	{
		StoreRaw(P, __builtin_convertvector(W[0], TRaw<uint8_t, N>));
	}
	else if constexpr (FFormat::Bytes == 2)
	{
		StoreRaw(P, __builtin_convertvector(W[0], TRaw<uint16_t, N>));
	}
	else if constexpr (FFormat::Bytes == 4)
	{
		StoreRaw(P, W[0]);
	}
	else if constexpr (FFormat::Bytes == 8)
	{
		TRaw<uint32_t, N> Rows[2];
		TLaneOps<N>::Interleave(W, Rows);
		StoreRaw(P, Rows);
	}
	else
	{
		for (int Lane = 0; Lane < N; ++Lane)
		{
			for (int k = 0; k < WordsOf<FFormat>; ++k)
			{
				const uint32_t Word = W[k][Lane];
				__builtin_memcpy(P + Lane * FFormat::Bytes + 4 * k, &Word, 4);
			}
		}
	}
}

/** Channels that a format lacks read 0, 0, 1. */
template<int First, int N, typename Scalar>
DRYDOCK_LANES_INLINE void FillChannels(TRaw<Scalar, N> C[4])
{
	for (int c = First; c < 4; ++c)
	{
		C[c] = Broadcast<Scalar, N>(Scalar(c == 3));
	}
}

/** f(FFormat{}) for the formats that hold what a shader reads as float or as uint32_t. */
template<typename Scalar, typename F>
DRYDOCK_LANES_INLINE bool VisitFormatOf(ETexelStorage Storage, F f)
{
	if constexpr (std::is_same_v<Scalar, float>)
	{
		return VisitFormat(Storage, f);
	}
	else
	{
		return VisitUintFormat(Storage, f);
	}
}

template<typename FFormat, typename Scalar, int N>
DRYDOCK_LANES_INLINE void LoadTexelsOf(const uint8_t* P, TRaw<Scalar, N> C[4])
{
	if constexpr (FFormat::bWide)
	{
		TRaw<float, N> A[4];
		for (int k = 0; k < 4; ++k)
		{
			A[k] = FFormat::template Load<N>(P + k * (N / 4) * FFormat::Bytes);
		}
		TLaneOps<N>::Split(A, C);
	}
	else
	{
		TRaw<uint32_t, N> W[WordsOf<FFormat>];
		LoadWords<FFormat, N>(P, W);
		FFormat::template Decode<N>(W, C);
		FillChannels<FFormat::Channels, N, Scalar>(C);
	}
}

template<typename FFormat, typename Scalar, int N>
DRYDOCK_LANES_INLINE void GatherTexelsOf(const uint8_t* Base, const TRaw<int32_t, N>& Offsets, TRaw<Scalar, N> C[4])
{
	if constexpr (FFormat::bWide)
	{
		TRaw<float, 4> Texels[N];
		for (int Lane = 0; Lane < N; ++Lane)
		{
			Texels[Lane] = LoadQuad<FFormat>(Base + Offsets[Lane]);
		}
		TRaw<float, N> A[4];
		for (int k = 0; k < 4; ++k)
		{
			A[k] = TLaneOps<N>::SetQuads(Texels + k * (N / 4));
		}
		TLaneOps<N>::Split(A, C);
	}
	else
	{
		TRaw<uint32_t, N> W[WordsOf<FFormat>];
		GatherWords<FFormat, N>(Base, Offsets, W);
		FFormat::template Decode<N>(W, C);
		FillChannels<FFormat::Channels, N, Scalar>(C);
	}
}

template<typename FFormat, typename Scalar, int N>
DRYDOCK_LANES_INLINE void StoreTexelsOf(uint8_t* P, const TRaw<Scalar, N> C[4])
{
	if constexpr (FFormat::bWide)
	{
		TRaw<float, N> A[4];
		TLaneOps<N>::Join(C, A);
		for (int k = 0; k < 4; ++k)
		{
			FFormat::template Store<N>(P + k * (N / 4) * FFormat::Bytes, A[k]);
		}
	}
	else
	{
		TRaw<uint32_t, N> W[WordsOf<FFormat>] = {};
		FFormat::template Encode<N>(C, W);
		StoreWords<FFormat, N>(P, W);
	}
}

/** N neighbours as channels; false when the storage has no format. */
template<typename Scalar, int N>
__attribute__((noinline)) bool LoadTexels(ETexelStorage Storage, const uint8_t* P, TRaw<Scalar, N>* C)
{
	return VisitFormatOf<Scalar>(Storage,
		[P, C](auto Format)
		{
			LoadTexelsOf<decltype(Format), Scalar, N>(P, C);
			return true;
		});
}

/** The texels at Base + Offsets (bytes) as channels; false when the storage has no format. */
template<typename Scalar, int N>
__attribute__((noinline)) bool GatherTexels(
	ETexelStorage Storage, const uint8_t* Base, const TRaw<int32_t, N>& Offsets, TRaw<Scalar, N>* C)
{
	return VisitFormatOf<Scalar>(Storage,
		[Base, &Offsets, C](auto Format)
		{
			GatherTexelsOf<decltype(Format), Scalar, N>(Base, Offsets, C);
			return true;
		});
}

/** N whole texels to a row, with the bits of EncodeTexel; false when the storage has no format. Value is [4][N].
 *  bSaturate: a finite value beyond the halves becomes the largest one. */
template<typename Scalar, int N>
__attribute__((noinline)) bool StoreTexels(ETexelStorage Storage, bool bSaturate, uint8_t* P, const Scalar* Value)
{
	TRaw<Scalar, N> C[4];
	for (int c = 0; c < 4; ++c)
	{
		C[c] = LoadRaw<TRaw<Scalar, N>>(Value + c * N);
	}
	if constexpr (std::is_same_v<Scalar, float>)
	{
		const FTexelStorageInfo& Info = GetTexelStorageInfo(Storage);
		if (bSaturate && Info.Kind == ETexelKind::Float && Info.BitsPerChannel == 16)
		{
			for (int c = 0; c < 4; ++c)
			{
				const TReal<float, N> X(C[c]);
				const TReal<float, N> Bounded = Max(Min(X, TReal<float, N>(65504.0f)), TReal<float, N>(-65504.0f));
				C[c] = Select(Abs(X) < TReal<float, N>(__builtin_inff()), Bounded, X).V;
			}
		}
	}
	return VisitFormatOf<Scalar>(Storage,
		[P, &C](auto Format)
		{
			StoreTexelsOf<decltype(Format), Scalar, N>(P, C);
			return true;
		});
}

/** f(Size) with the bytes of a texel as a constant, so that a copy is a move. */
template<typename F>
DRYDOCK_LANES_INLINE void VisitTexelSize(int32_t Bytes, F f)
{
	switch (Bytes)
	{
	case 1:
		return f(std::integral_constant<size_t, 1>{});
	case 2:
		return f(std::integral_constant<size_t, 2>{});
	case 4:
		return f(std::integral_constant<size_t, 4>{});
	case 8:
		return f(std::integral_constant<size_t, 8>{});
	case 12:
		return f(std::integral_constant<size_t, 12>{});
	default:
		return f(std::integral_constant<size_t, 16>{});
	}
}

/** All texels of a level have 32-bit offsets, as gathers want them. */
DRYDOCK_LANES_INLINE bool HasSmallOffsets(const FKernelMip& Mip)
{
	return Mip.SlicePitch * Mip.SizeZ <= 0x7FFFFFFF;
}

/** One axis of a sample after addressing: two texels, -1 for the border, and the weight of the second. A tap of
 *  weight 0 is not read. */
template<int N>
struct TTaps
{
	TRaw<int32_t, N> Texels[2];
	TRaw<float, N> Weight;
	bool bTwo;

	TTaps() = default;
	TTaps(const TAxis<float, N>& Axis, int32_t Size, EKernelAddress Mode)
		: Weight(Axis.Weight.V)
		, bTwo(AnyLane(Axis.Weight != TReal<float, N>(0.0f)))
	{
		Texels[0] = AddressTexels(Axis.First, Size, Mode).V;
		const TRaw<int32_t, N> Second = AddressTexels(Axis.First + TInt<N>(1), Size, Mode).V;
		Texels[1] = Weight == 0.0f ? Texels[0] : Second;
	}
};

/** A level of a texture with a sampler, read by lanes. */
template<int N>
struct TTapReader
{
	using FInt = TRaw<int32_t, N>;
	using FFloat = TRaw<float, N>;

	const FKernelTexture& Texture;
	const FKernelSampler& Sampler;
	const FKernelMip& Mip;

	bool CanRead() const { return GetTexelStorageInfo(Texture.Storage).BitsPerChannel <= 32 && HasSmallOffsets(Mip); }

	/** Lanes with a negative index have the border's colour. Neighbours are read as a row. */
	void Read(FInt X, FInt Y, FInt Z, FFloat C[4]) const
	{
		const FInt Outside = (X | Y | Z) < 0;
		const bool bAllOutside = AllLanes(TMask<N>(Outside));
		if (!bAllOutside)
		{
			const FInt Offsets = Z * int32_t(Mip.SlicePitch) + Y * Mip.RowPitch +
								 X * int32_t(GetTexelStorageInfo(Texture.Storage).BytesPerTexel);
			const FInt Inside = Outside != 0 ? FInt{} : Offsets;
			const FInt Row = Inside[0] + LaneIndex<N>().V * int32_t(GetTexelStorageInfo(Texture.Storage).BytesPerTexel);
			if (AllLanes(TMask<N>(Inside == Row)))
			{
				LoadTexels<float, N>(Texture.Storage, Mip.Data + Inside[0], C);
			}
			else
			{
				GatherTexels<float, N>(Texture.Storage, Mip.Data, Inside, C);
			}
		}
		if (bAllOutside || AnyLane(TMask<N>(Outside)))
		{
			for (int c = 0; c < 4; ++c)
			{
				const FFloat Border = Broadcast<float, N>(Sampler.Border[c]);
				C[c] = bAllOutside ? Border : Outside != 0 ? Border : C[c];
			}
		}
	}

	static DRYDOCK_LANES_INLINE void Mix(FFloat A[4], const FFloat B[4], FFloat Weight)
	{
		for (int c = 0; c < 4; ++c)
		{
			A[c] = Weight == 0.0f ? A[c] : A[c] + Weight * (B[c] - A[c]);
		}
	}

	/** Vertical pairs first, then the horizontal one. */
	void Filter2D(const TTaps<N>& X, const TTaps<N>& Y, FInt Z, FFloat C[4]) const
	{
		const auto Column = [&](int i, FFloat Out[4])
		{
			Read(X.Texels[i], Y.Texels[0], Z, Out);
			if (Y.bTwo)
			{
				FFloat Below[4];
				Read(X.Texels[i], Y.Texels[1], Z, Below);
				Mix(Out, Below, Y.Weight);
			}
		};
		Column(0, C);
		if (X.bTwo)
		{
			FFloat Right[4];
			Column(1, Right);
			Mix(C, Right, X.Weight);
		}
	}

	void Filter3D(const TTaps<N>& X, const TTaps<N>& Y, const TTaps<N>& Z, FFloat C[4]) const
	{
		Filter2D(X, Y, Z.Texels[0], C);
		if (Z.bTwo)
		{
			FFloat Far[4];
			Filter2D(X, Y, Z.Texels[1], Far);
			Mix(C, Far, Z.Weight);
		}
	}
};

/** Writes the channels; false when one is NaN, which LanesSamplingReference.inl decides. */
template<int N>
DRYDOCK_LANES_INLINE bool FinishTaps(const TRaw<float, N> C[4], float* Out)
{
	if (TLaneOps<N>::AnyNan(C[0], C[1], C[2], C[3]))
	{
		return false;
	}
	for (int c = 0; c < 4; ++c)
	{
		StoreRaw(Out + c * N, C[c]);
	}
	return true;
}

/** Texels of one mip by their indices, 0 in all channels of lanes outside it and of lanes that are off. False when this
 *  format or size has no lane code. */
template<typename Scalar, int N>
inline bool LoadLanes(const FKernelTexture& Texture, const FKernelMip& Mip, TMask<N> Lanes, const int32_t* X,
	const int32_t* Y, const int32_t* Z, TRaw<Scalar, N> C[4])
{
	using FInt = TRaw<int32_t, N>;
	using FWord = TRaw<uint32_t, N>;
	if (!HasSmallOffsets(Mip))
	{
		return false;
	}
	const FInt Columns = LoadRaw<FInt>(X);
	const FInt Rows = LoadRaw<FInt>(Y);
	const FInt Slices = Z ? LoadRaw<FInt>(Z) : FInt{};
	const int32_t Bytes = GetTexelStorageInfo(Texture.Storage).BytesPerTexel;
	const FInt Inside = Lanes.V & (FWord(Columns) < uint32_t(Mip.SizeX)) & (FWord(Rows) < uint32_t(Mip.SizeY)) &
						(FWord(Slices) < uint32_t(Mip.SizeZ));
	const TInt<N> Offsets =
		TInt<N>(Slices) * int32_t(Mip.SlicePitch) + TInt<N>(Rows) * Mip.RowPitch + TInt<N>(Columns) * Bytes;
	if (!GatherTexels<Scalar, N>(Texture.Storage, Mip.Data, Inside & Offsets.V, C))
	{
		return false;
	}
	if (!AllLanes(TMask<N>(Inside)))
	{
		for (int c = 0; c < 4; ++c)
		{
			C[c] = Inside != 0 ? C[c] : TRaw<Scalar, N>{};
		}
	}
	return true;
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
