// Texel stores of N lanes: conversion to the texture's storage with the same bits as EncodeTexel, masks, blending.
// Included by the LanesSampling_*.cpp only. Source: D3D11 functional specification 3.2.3, 17.6 (blending).
#pragma once

#include "LanesSamplingReference.inl"
#include "LanesTexels.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

template<int N>
DRYDOCK_LANES_INLINE bool IsSame(TRaw<int32_t, N> X)
{
	return MaskBits(TMask<N>(X != X[0])) == 0;
}

/** Lane i is at (X[0] + i, Y[0]). */
template<int N>
DRYDOCK_LANES_INLINE bool IsRow(TRaw<int32_t, N> X, TRaw<int32_t, N> Y)
{
	return IsSame<N>((TInt<N>(X) - LaneIndex<N>()).V) && IsSame<N>(Y);
}

template<typename Real>
DRYDOCK_LANES_INLINE void EncodeOne(const FKernelTexture& Texture, const Real RGBA[4], uint8_t* Address)
{
	if constexpr (std::is_floating_point_v<Real>)
	{
		EncodeTexel(Texture.Storage, RGBA, Address, Texture.bSaturateStore != 0);
	}
	else
	{
		EncodeTexel(Texture.Storage, RGBA, Address);
	}
}

/** Lanes of Scalar to texels of one mip: those outside it or off in the mask are dropped, and where two meet in one
 *  place the higher lane wins. Real: of the kernel. */
template<typename Real, typename Scalar, int N>
inline void StoreLanes(const FKernelTexture& Texture, const int32_t* Mask, const int32_t* X, const int32_t* Y,
	const int32_t* Z, const Scalar* Value)
{
	const FKernelMip& Mip = Texture.Mips[0];
	const int32_t Bytes = GetTexelStorageInfo(Texture.Storage).BytesPerTexel;
	const auto ForEachInside = [&](auto f)
	{
		for (int Lane = 0; Lane < N; ++Lane)
		{
			const int32_t Slice = Z ? Z[Lane] : 0;
			if (Mask[Lane] && uint32_t(X[Lane]) < uint32_t(Mip.SizeX) && uint32_t(Y[Lane]) < uint32_t(Mip.SizeY) &&
				uint32_t(Slice) < uint32_t(Mip.SizeZ))
			{
				f(Lane, const_cast<uint8_t*>(TexelAddress(Mip, Bytes, X[Lane], Y[Lane], Slice)));
			}
		}
	};
	if constexpr (HasLaneCode<Real, N>)
	{
		const bool bWhole = X[0] >= 0 && X[0] <= Mip.SizeX - N && uint32_t(Y[0]) < uint32_t(Mip.SizeY) &&
							uint32_t(Z ? Z[0] : 0) < uint32_t(Mip.SizeZ) &&
							AllLanes(TMask<N>(LoadRaw<TRaw<int32_t, N>>(Mask))) &&
							IsRow<N>(LoadRaw<TRaw<int32_t, N>>(X), LoadRaw<TRaw<int32_t, N>>(Y)) &&
							(!Z || IsSame<N>(LoadRaw<TRaw<int32_t, N>>(Z)));
		// Lanes that are not a whole row go through the same conversion beside the texture.
		alignas(64) uint8_t Row[N * 16];
		uint8_t* const Place = bWhole ? const_cast<uint8_t*>(TexelAddress(Mip, Bytes, X[0], Y[0], Z ? Z[0] : 0)) : Row;
		if (Bytes <= 16 && StoreTexels<Scalar, N>(Texture.Storage, Texture.bSaturateStore != 0, Place, Value))
		{
			if (!bWhole)
			{
				ForEachInside(
					[&](int Lane, uint8_t* Address) { __builtin_memcpy(Address, Row + Lane * Bytes, size_t(Bytes)); });
			}
			return;
		}
	}
	CountScalarCall<Real, N>(EScalarCall::Store);
	ForEachInside(
		[&](int Lane, uint8_t* Address)
		{
			const Scalar RGBA[4] = {Value[Lane], Value[N + Lane], Value[2 * N + Lane], Value[3 * N + Lane]};
			EncodeOne(Texture, RGBA, Address);
		});
}

/** T: a real or lanes of reals. */
template<typename T>
inline T BlendFactor(EKernelBlendFactor Factor, int Channel, const T Source[4], const T Dest[4])
{
	switch (Factor)
	{
	case EKernelBlendFactor::Zero:
		return T(0);
	case EKernelBlendFactor::One:
		return T(1);
	case EKernelBlendFactor::SourceColor:
		return Source[Channel];
	case EKernelBlendFactor::InverseSourceColor:
		return T(1) - Source[Channel];
	case EKernelBlendFactor::SourceAlpha:
		return Source[3];
	case EKernelBlendFactor::InverseSourceAlpha:
		return T(1) - Source[3];
	case EKernelBlendFactor::DestAlpha:
		return Dest[3];
	case EKernelBlendFactor::InverseDestAlpha:
		return T(1) - Dest[3];
	case EKernelBlendFactor::DestColor:
		return Dest[Channel];
	case EKernelBlendFactor::InverseDestColor:
		return T(1) - Dest[Channel];
	case EKernelBlendFactor::ConstantBlendFactor:
		return T(1); // the blend constant is white, as the engine leaves it
	case EKernelBlendFactor::InverseConstantBlendFactor:
		return T(0);
	}
	return T(0);
}

/** A factor of 0 removes its term even when the term is infinite or NaN: fixed-function blending does not multiply by
 *  a constant 0. Min and Max ignore the factors. */
template<typename T>
inline T BlendChannel(EKernelBlendOp Op, EKernelBlendFactor SourceFactor, EKernelBlendFactor DestFactor, int Channel,
	const T Source[4], const T Dest[4])
{
	const T S = Source[Channel];
	const T D = Dest[Channel];
	if (Op == EKernelBlendOp::Min)
	{
		return Min(S, D);
	}
	if (Op == EKernelBlendOp::Max)
	{
		return Max(S, D);
	}
	const T SourceTerm =
		SourceFactor == EKernelBlendFactor::Zero ? T(0) : S * BlendFactor(SourceFactor, Channel, Source, Dest);
	const T DestTerm =
		DestFactor == EKernelBlendFactor::Zero ? T(0) : D * BlendFactor(DestFactor, Channel, Source, Dest);
	switch (Op)
	{
	case EKernelBlendOp::Subtract:
		return SourceTerm - DestTerm;
	case EKernelBlendOp::ReverseSubtract:
		return DestTerm - SourceTerm;
	default:
		return SourceTerm + DestTerm;
	}
}

template<typename T>
inline void BlendTexel(const FKernelTarget& Target, const T Source[4], const T Dest[4], T Out[4])
{
	for (int c = 0; c < 4; ++c)
	{
		Out[c] = Source[c];
		if (Target.bBlend)
		{
			Out[c] = c < 3 ? BlendChannel(Target.ColorOp, Target.ColorSource, Target.ColorDest, c, Source, Dest)
						   : BlendChannel(Target.AlphaOp, Target.AlphaSource, Target.AlphaDest, c, Source, Dest);
		}
	}
}

/** The bits of a texel that a write mask lets through. */
inline void MakeWriteBits(ETexelStorage Storage, uint8_t WriteMask, uint8_t OutBits[32])
{
	const FTexelStorageInfo& Info = GetTexelStorageInfo(Storage);
	uint64_t FieldBits[4] = {Info.BitsPerChannel, Info.BitsPerChannel, Info.BitsPerChannel, Info.BitsPerChannel};
	if (Storage == ETexelStorage::R11G11B10_FLOAT)
	{
		FieldBits[2] = 10;
	}
	if (Storage == ETexelStorage::RGB10A2_UNORM)
	{
		FieldBits[3] = 2;
	}
	const bool bBgra = Storage == ETexelStorage::BGRA8_UNORM || Storage == ETexelStorage::BGRA8_SRGB;
	__builtin_memset(OutBits, 0, 32);
	uint64_t Bit = 0;
	for (int Field = 0; Field < Info.NumChannels; ++Field)
	{
		const int Channel = bBgra && Field < 3 ? 2 - Field : Field;
		const uint64_t End = Bit + FieldBits[Field];
		for (; Bit < End; ++Bit)
		{
			OutBits[Bit >> 3] |= uint8_t(((WriteMask >> Channel) & 1u) << (Bit & 7));
		}
	}
}

/** Channels that the write mask leaves out keep the bits they have in memory, not the re-encoded value. Bits: of one
 *  texel. */
inline void MergeTexel(uint8_t* Texel, const uint8_t* New, const uint8_t* Bits, int32_t Bytes)
{
	for (int32_t i = 0; i < Bytes; ++i)
	{
		Texel[i] = uint8_t((Texel[i] & ~Bits[i]) | (New[i] & Bits[i]));
	}
}

/** The same for N texels of up to 16 bytes: New becomes what is to be written. */
template<int N>
inline void MergeRow(uint8_t* New, const uint8_t* Old, const uint8_t* Bits, int32_t Bytes)
{
	using FChunk = TRaw<uint64_t, 2>;
	uint8_t Pattern[48]; // whole texels of every size, and whole chunks
	for (int32_t i = 0; i < 48; i += Bytes)
	{
		__builtin_memcpy(Pattern + i, Bits, size_t(Bytes));
	}
	for (int32_t i = 0; i < N * Bytes; i += 16)
	{
		const FChunk Written = LoadRaw<FChunk>(Pattern + i % 48);
		StoreRaw(New + i, (LoadRaw<FChunk>(Old + i) & ~Written) | (LoadRaw<FChunk>(New + i) & Written));
	}
}

/** N texels of a target, as they are in Old, blended with Value and merged, into New; both hold N * 16 bytes. False
 *  when the storage has no lane code. */
template<int N>
inline bool BlendRow(const FKernelTarget& Target, const uint8_t* Old, const float* Value, uint8_t* New)
{
	const FKernelTexture& Texture = Target.Texture;
	TRaw<float, N> Before[4];
	if (!LoadTexels<float, N>(Texture.Storage, Old, Before))
	{
		return false;
	}
	TReal<float, N> Source[4], Dest[4], Blended[4];
	for (int c = 0; c < 4; ++c)
	{
		Source[c] = TReal<float, N>(LoadRaw<TRaw<float, N>>(Value + c * N));
		Dest[c] = TReal<float, N>(Before[c]);
	}
	BlendTexel(Target, Source, Dest, Blended);
	StoreTexels<float, N>(Texture.Storage, Texture.bSaturateStore != 0, New, LanesOf(Blended[0]));
	if ((Target.WriteMask & 15) != 15)
	{
		uint8_t Bits[32];
		MakeWriteBits(Texture.Storage, Target.WriteMask, Bits);
		MergeRow<N>(New, Old, Bits, GetTexelStorageInfo(Texture.Storage).BytesPerTexel);
	}
	return true;
}

template<typename Real, int N>
inline void StoreTargetLanes(const FKernelTarget& Target, const int32_t* Mask, int32_t X0, int32_t Y, const Real* Value)
{
	const FKernelTexture& Texture = Target.Texture;
	const FKernelMip& Mip = Texture.Mips[0];
	if (uint32_t(Y) >= uint32_t(Mip.SizeY))
	{
		return;
	}
	const bool bPlain = !Target.bBlend && (Target.WriteMask & 15) == 15;
	const int32_t Bytes = GetTexelStorageInfo(Texture.Storage).BytesPerTexel;
	uint8_t* const First = Mip.Data + int64_t(Y) * Mip.RowPitch + int64_t(X0) * Bytes;
	const auto ForEachInside = [&](auto f)
	{
		for (int Lane = 0; Lane < N; ++Lane)
		{
			if (Mask[Lane] && uint32_t(X0) + uint32_t(Lane) < uint32_t(Mip.SizeX))
			{
				f(Lane, First + Lane * Bytes);
			}
		}
	};
	if constexpr (HasLaneCode<Real, N>)
	{
		const bool bWhole = X0 >= 0 && X0 <= Mip.SizeX - N && AllLanes(TMask<N>(LoadRaw<TRaw<int32_t, N>>(Mask)));
		const bool bInPlace = bWhole && bPlain;
		alignas(64) uint8_t Old[N * 16] = {};
		alignas(64) uint8_t New[N * 16];
		if (Bytes <= 16 && !bPlain)
		{
			ForEachInside([&](int Lane, const uint8_t* Address)
				{ __builtin_memcpy(Old + Lane * Bytes, Address, size_t(Bytes)); });
		}
		if (Bytes <= 16 &&
			(bPlain ? StoreTexels<float, N>(Texture.Storage, Texture.bSaturateStore != 0, bInPlace ? First : New, Value)
					: BlendRow<N>(Target, Old, Value, New)))
		{
			if (!bInPlace)
			{
				ForEachInside(
					[&](int Lane, uint8_t* Address) { __builtin_memcpy(Address, New + Lane * Bytes, size_t(Bytes)); });
			}
			return;
		}
	}
	CountScalarCall<Real, N>(EScalarCall::Store);
	uint8_t Bits[32];
	MakeWriteBits(Texture.Storage, Target.WriteMask, Bits);
	ForEachInside(
		[&](int Lane, uint8_t* Address)
		{
			const Real Source[4] = {Value[Lane], Value[N + Lane], Value[2 * N + Lane], Value[3 * N + Lane]};
			if (bPlain)
			{
				EncodeOne(Texture, Source, Address);
				return;
			}
			const TTexel<Real> Dest = ReadTexel<Real>(Texture.Storage, Address);
			Real Blended[4];
			BlendTexel(Target, Source, Dest.C, Blended);
			uint8_t New[32];
			EncodeOne(Texture, Blended, New);
			MergeTexel(Address, New, Bits, Bytes);
		});
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
