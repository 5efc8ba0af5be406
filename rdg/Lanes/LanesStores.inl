// Texel stores of N lanes: conversion to the texture's storage with the same bits as EncodeTexel, masks, blending.
// Included by the LanesSampling_*.cpp only. Source: D3D11 functional specification 3.2.3, 17.6 (blending).
#pragma once

#include "LanesFormats.inl"
#include "LanesSamplingReference.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** Unsigned 5-bit-exponent floats of R11G11B10, in the low bits of each word: rounded once, from the float itself. */
template<int MantissaBits, int N>
DRYDOCK_LANES_INLINE TRaw<uint32_t, N> EncodeMiniFloat(TRaw<float, N> X)
{
	using FInt = TRaw<int32_t, N>;
	using FFloat = TRaw<float, N>;
	constexpr int Shift = 23 - MantissaBits;
	constexpr int32_t Infinity = 31 << MantissaBits;
	const FInt Bits = FInt(X);
	const FInt Magnitude = Bits & 0x7FFFFFFF;
	const FInt Normal = (Magnitude - (112 << 23) + ((1 << (Shift - 1)) - 1) + ((Magnitude >> Shift) & 1)) >> Shift;
	// The unit of a denormal is 2^(-14 - MantissaBits); the last bit of a float in [Magic, 2 Magic) has the same
	// weight.
	const FFloat Magic = Broadcast<float, N>(__builtin_bit_cast(float, (127 - 14 - MantissaBits + 23) << 23));
	const FInt Denormal = FInt(FFloat(FFloat(Magnitude) + Magic)) - FInt(Magic);
	FInt Result = Magnitude < (113 << 23) ? Denormal : Normal;
	Result = Result >= Infinity ? (FInt{} + (Infinity - 1)) : Result;
	Result = Magnitude == 0x7F800000 ? (FInt{} + Infinity) : Result;
	Result = Bits < 0 ? FInt{} : Result;
	const FInt Nan = ((Magnitude >> Shift) & ((1 << MantissaBits) - 1)) | Infinity | (1 << (MantissaBits - 1));
	Result = Magnitude > 0x7F800000 ? Nan : Result;
	return TRaw<uint32_t, N>(Result);
}

/** X * Max rounded to the nearest even integer; the product is exact in double. NaN gives 0. */
template<int N>
DRYDOCK_LANES_INLINE TRaw<uint32_t, N> EncodeUnormField(TRaw<float, N> X, uint32_t Max)
{
	const TRaw<float, N> Clamped = Saturate(TReal<float, N>(X)).V;
	TRaw<uint32_t, N> Result;
	constexpr int H = N / 2;
	TRaw<float, H> Parts[2];
	TRaw<int32_t, H> Codes[2];
	__builtin_memcpy(Parts, &Clamped, sizeof(Parts));
	for (int i = 0; i < 2; ++i)
	{
		const TReal<double, H> Wide(__builtin_convertvector(Parts[i], TRaw<double, H>));
		Codes[i] = __builtin_convertvector(RoundEven(Wide * TReal<double, H>(double(Max))).V, TRaw<int32_t, H>);
	}
	__builtin_memcpy(&Result, Codes, sizeof(Codes));
	return Result;
}

template<int N>
DRYDOCK_LANES_INLINE TRaw<uint32_t, N> EncodeHalfField(TRaw<float, N> X)
{
	return Convert::FloatToHalf(TReal<float, N>(X)).V;
}

/** N whole texels, all lanes. False when the storage has no tuned store. */
template<int N>
inline bool StoreRow(const FKernelTexture& Texture, uint8_t* Address, const float* Value)
{
	using FFloat = TRaw<float, N>;
	using FWord = TRaw<uint32_t, N>;
	FFloat C[4];
	for (int c = 0; c < 4; ++c)
	{
		C[c] = LoadRaw<FFloat>(Value + c * N);
	}
	const bool bHalf = Texture.Storage == ETexelStorage::RGBA16_FLOAT || Texture.Storage == ETexelStorage::RG16_FLOAT ||
					   Texture.Storage == ETexelStorage::R16_FLOAT;
	if (bHalf && Texture.bSaturateStore)
	{
		return false;
	}
	switch (Texture.Storage)
	{
	case ETexelStorage::RGBA32_FLOAT:
	{
		FFloat A[4];
		TLaneOps<N>::Join(C, A);
		StoreRaw(Address, A);
		return true;
	}
	case ETexelStorage::RGBA16_FLOAT:
	{
		FFloat A[4];
		TLaneOps<N>::Join(C, A);
		for (int k = 0; k < 4; ++k)
		{
			TLaneOps<N>::StoreHalves(Address + k * N * 2, A[k]);
		}
		return true;
	}
	case ETexelStorage::R11G11B10_FLOAT:
		StoreRaw(Address, FWord(EncodeMiniFloat<6, N>(C[0]) | (EncodeMiniFloat<6, N>(C[1]) << 11) |
								(EncodeMiniFloat<5, N>(C[2]) << 22)));
		return true;
	case ETexelStorage::R32_FLOAT:
		StoreRaw(Address, C[0]);
		return true;
	case ETexelStorage::RG16_FLOAT:
		StoreRaw(Address, FWord(EncodeHalfField<N>(C[0]) | (EncodeHalfField<N>(C[1]) << 16)));
		return true;
	case ETexelStorage::R16_FLOAT:
		StoreRaw(Address, __builtin_convertvector(EncodeHalfField<N>(C[0]), TRaw<uint16_t, N>));
		return true;
	case ETexelStorage::RGBA8_UNORM:
	case ETexelStorage::BGRA8_UNORM:
	{
		const bool bSwap = Texture.Storage == ETexelStorage::BGRA8_UNORM;
		const FWord First = EncodeUnormField<N>(C[bSwap ? 2 : 0], 255);
		const FWord Third = EncodeUnormField<N>(C[bSwap ? 0 : 2], 255);
		StoreRaw(Address, FWord(First | (EncodeUnormField<N>(C[1], 255) << 8) | (Third << 16) |
								(EncodeUnormField<N>(C[3], 255) << 24)));
		return true;
	}
	case ETexelStorage::R8_UNORM:
		StoreRaw(Address, __builtin_convertvector(EncodeUnormField<N>(C[0], 255), TRaw<uint8_t, N>));
		return true;
	default:
		return false;
	}
}

template<typename Real, int N>
inline void StoreLane(const FKernelTexture& Texture, uint8_t* Address, const Real* Value, int Lane)
{
	const Real RGBA[4] = {Value[Lane], Value[N + Lane], Value[2 * N + Lane], Value[3 * N + Lane]};
	EncodeTexel(Texture.Storage, RGBA, Address, Texture.bSaturateStore != 0);
}

/** A row piece at (X0, Y) of one mip: lanes outside it or off in the mask are dropped. */
template<typename Real, int N>
inline void StoreConsecutive(const FKernelTexture& Texture, const FKernelMip& Mip, const int32_t* Mask, int32_t X0,
	int32_t Y, int32_t Z, const Real* Value)
{
	if (uint32_t(Y) >= uint32_t(Mip.SizeY) || uint32_t(Z) >= uint32_t(Mip.SizeZ))
	{
		return;
	}
	const int32_t Bytes = GetTexelStorageInfo(Texture.Storage).BytesPerTexel;
	if constexpr (sizeof(Real) == 4)
	{
		const TMask<N> Lanes(LoadRaw<TRaw<int32_t, N>>(Mask));
		const bool bWhole = X0 >= 0 && X0 <= Mip.SizeX - N && AllLanes(Lanes);
		if (bWhole && StoreRow<N>(Texture, const_cast<uint8_t*>(TexelAddress(Mip, Bytes, X0, Y, Z)), Value))
		{
			return;
		}
		// A part of a row goes through the same conversion beside the texture: the tail of a row costs no more than its
		// middle.
		alignas(64) uint8_t Row[N * 16];
		if (StoreRow<N>(Texture, Row, Value))
		{
			for (int Lane = 0; Lane < N; ++Lane)
			{
				if (Mask[Lane] && uint32_t(X0) + uint32_t(Lane) < uint32_t(Mip.SizeX))
				{
					__builtin_memcpy(const_cast<uint8_t*>(TexelAddress(Mip, Bytes, X0 + Lane, Y, Z)),
						Row + Lane * Bytes, size_t(Bytes));
				}
			}
			return;
		}
	}
	for (int Lane = 0; Lane < N; ++Lane)
	{
		if (Mask[Lane] && uint32_t(X0) + uint32_t(Lane) < uint32_t(Mip.SizeX))
		{
			StoreLane<Real, N>(Texture, const_cast<uint8_t*>(TexelAddress(Mip, Bytes, X0 + Lane, Y, Z)), Value, Lane);
		}
	}
}

template<typename Real>
inline Real BlendFactor(EKernelBlendFactor Factor, int Channel, const Real Source[4], const Real Dest[4])
{
	switch (Factor)
	{
	case EKernelBlendFactor::Zero:
		return 0;
	case EKernelBlendFactor::One:
		return 1;
	case EKernelBlendFactor::SourceColor:
		return Source[Channel];
	case EKernelBlendFactor::InverseSourceColor:
		return 1 - Source[Channel];
	case EKernelBlendFactor::SourceAlpha:
		return Source[3];
	case EKernelBlendFactor::InverseSourceAlpha:
		return 1 - Source[3];
	case EKernelBlendFactor::DestAlpha:
		return Dest[3];
	case EKernelBlendFactor::InverseDestAlpha:
		return 1 - Dest[3];
	case EKernelBlendFactor::DestColor:
		return Dest[Channel];
	case EKernelBlendFactor::InverseDestColor:
		return 1 - Dest[Channel];
	case EKernelBlendFactor::ConstantBlendFactor:
		return 1; // the blend constant is white, as the engine leaves it
	case EKernelBlendFactor::InverseConstantBlendFactor:
		return 0;
	}
	return 0;
}

/** A factor of 0 removes its term even when the term is infinite or NaN: fixed-function blending does not multiply by
 *  a constant 0. Min and Max ignore the factors. */
template<typename Real>
inline Real BlendChannel(EKernelBlendOp Op, EKernelBlendFactor SourceFactor, EKernelBlendFactor DestFactor, int Channel,
	const Real Source[4], const Real Dest[4])
{
	const Real S = Source[Channel];
	const Real D = Dest[Channel];
	if (Op == EKernelBlendOp::Min)
	{
		return Min(S, D);
	}
	if (Op == EKernelBlendOp::Max)
	{
		return Max(S, D);
	}
	const Real SourceTerm =
		SourceFactor == EKernelBlendFactor::Zero ? Real(0) : S * BlendFactor(SourceFactor, Channel, Source, Dest);
	const Real DestTerm =
		DestFactor == EKernelBlendFactor::Zero ? Real(0) : D * BlendFactor(DestFactor, Channel, Source, Dest);
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

template<typename Real>
inline void BlendTexel(const FKernelTarget& Target, const Real Source[4], const Real Dest[4], Real Out[4])
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

/** Channels that the write mask leaves out keep the bits they have in memory, not the re-encoded value. */
inline void MergeTexel(ETexelStorage Storage, uint8_t WriteMask, const uint8_t* New, uint8_t* Texel)
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
	uint64_t Bit = 0;
	for (int Field = 0; Field < Info.NumChannels; ++Field)
	{
		const int Channel = bBgra && Field < 3 ? 2 - Field : Field;
		if (WriteMask & (1 << Channel))
		{
			for (uint64_t b = Bit; b < Bit + FieldBits[Field]; ++b)
			{
				const uint8_t One = uint8_t(1u << (b & 7));
				Texel[b >> 3] = uint8_t((Texel[b >> 3] & ~One) | (New[b >> 3] & One));
			}
		}
		Bit += FieldBits[Field];
	}
}

template<typename Real, int N>
inline void StoreTargetLanes(const FKernelTarget& Target, const int32_t* Mask, int32_t X0, int32_t Y, const Real* Value)
{
	const FKernelTexture& Texture = Target.Texture;
	const FKernelMip& Mip = Texture.Mips[0];
	if (!Target.bBlend && (Target.WriteMask & 15) == 15)
	{
		StoreConsecutive<Real, N>(Texture, Mip, Mask, X0, Y, 0, Value);
		return;
	}
	if (uint32_t(Y) >= uint32_t(Mip.SizeY))
	{
		return;
	}
	const int32_t Bytes = GetTexelStorageInfo(Texture.Storage).BytesPerTexel;
	for (int Lane = 0; Lane < N; ++Lane)
	{
		if (!Mask[Lane] || uint32_t(X0) + uint32_t(Lane) >= uint32_t(Mip.SizeX))
		{
			continue;
		}
		uint8_t* Address = const_cast<uint8_t*>(TexelAddress(Mip, Bytes, X0 + Lane, Y, 0));
		const Real Source[4] = {Value[Lane], Value[N + Lane], Value[2 * N + Lane], Value[3 * N + Lane]};
		const TTexel<Real> Dest = ReadTexel<Real>(Texture.Storage, Address);
		Real Blended[4];
		BlendTexel(Target, Source, Dest.C, Blended);
		uint8_t New[32];
		EncodeTexel(Texture.Storage, Blended, New, Texture.bSaturateStore != 0);
		MergeTexel(Texture.Storage, Target.WriteMask, New, Address);
	}
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
