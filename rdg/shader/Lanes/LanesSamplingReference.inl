// Sampling texel by texel: every format, filter, address mode and dimension. The tuned paths of LanesSamplingRows.inl
// do the same operations in the same order and hand over to this one what is rare: borders, NaN, unusual formats,
// lanes on different mips or layers. Double lanes use it throughout. Included by the LanesSampling_*.cpp only.
// Source: D3D11 functional specification 7.18; drydock.
#pragma once

#include "LanesCoordinates.inl"
#include "LanesScalarCalls.h"
#include "PixelFormatConversion.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** Double lanes go one by one, and one float lane is the model of the others. */
template<typename Real, int N>
constexpr bool HasLaneCode = sizeof(Real) == 4 && N > 1;

/** A pack of lanes goes one by one though it need not: somebody may want to know. */
template<typename Real, int N>
DRYDOCK_LANES_INLINE void CountScalarCall(EScalarCall Call)
{
	if constexpr (HasLaneCode<Real, N>)
	{
		AddScalarCall(Call);
	}
}

template<typename Real>
struct TTexel
{
	Real C[4];
};

template<typename Source, int Channels, typename Real>
DRYDOCK_LANES_INLINE TTexel<Real> ReadChannels(const uint8_t* Address)
{
	Source Values[Channels];
	__builtin_memcpy(Values, Address, sizeof(Values));
	TTexel<Real> Texel = {{0, 0, 0, 1}};
	for (int c = 0; c < Channels; ++c)
	{
		Texel.C[c] = Real(Values[c]);
	}
	return Texel;
}

/** Missing channels read 0, 0, 0, 1. Real may be uint32_t, for storage of integers. */
template<typename Real>
inline TTexel<Real> ReadTexel(ETexelStorage Storage, const uint8_t* Address)
{
	switch (std::is_floating_point_v<Real> ? Storage : ETexelStorage::Count)
	{
	case ETexelStorage::R32_FLOAT:
		return ReadChannels<float, 1, Real>(Address);
	case ETexelStorage::RG32_FLOAT:
		return ReadChannels<float, 2, Real>(Address);
	case ETexelStorage::RGB32_FLOAT:
		return ReadChannels<float, 3, Real>(Address);
	case ETexelStorage::RGBA32_FLOAT:
		return ReadChannels<float, 4, Real>(Address);
	case ETexelStorage::R64_FLOAT:
		return ReadChannels<double, 1, Real>(Address);
	case ETexelStorage::RGB64_FLOAT:
		return ReadChannels<double, 3, Real>(Address);
	case ETexelStorage::RGBA64_FLOAT:
		return ReadChannels<double, 4, Real>(Address);
	default:
	{
		TTexel<Real> Texel;
		DecodeTexel(Storage, Address, Texel.C);
		return Texel;
	}
	}
}

DRYDOCK_LANES_INLINE const uint8_t* TexelAddress(
	const FKernelMip& Mip, int32_t BytesPerTexel, int32_t X, int32_t Y, int32_t Z)
{
	return Mip.Data + int64_t(Z) * Mip.SlicePitch + int64_t(Y) * Mip.RowPitch + int64_t(X) * BytesPerTexel;
}

/** The one rule of filtering. A weight of 0 does not look at B. The difference form keeps constants as they are, bit
 *  for bit; where it ends in NaN (an infinity minus another) the product form decides, as in hardware. */
template<typename Real>
DRYDOCK_LANES_INLINE Real FilterPair(Real A, Real B, Real Weight)
{
	if (Weight == 0)
	{
		return A;
	}
	const Real Result = A + Weight * (B - A);
	return Result == Result ? Result : A * (Real(1) - Weight) + B * Weight;
}
template<typename Real>
DRYDOCK_LANES_INLINE TTexel<Real> FilterPair(const TTexel<Real>& A, const TTexel<Real>& B, Real Weight)
{
	return {{FilterPair(A.C[0], B.C[0], Weight), FilterPair(A.C[1], B.C[1], Weight), FilterPair(A.C[2], B.C[2], Weight),
		FilterPair(A.C[3], B.C[3], Weight)}};
}

/** One lane's texel and weight on one axis. */
template<typename Real>
struct TTap
{
	int32_t First;
	int32_t Second;
	Real Weight;
};

template<typename Real, int N>
DRYDOCK_LANES_INLINE TTap<Real> MakeTap(const TAxis<Real, N>& Axis, int Lane, int32_t Size, EKernelAddress Mode)
{
	const int32_t First = Axis.First.V[Lane];
	return {AddressTexel(First, Size, Mode), AddressTexel(First + 1, Size, Mode), Axis.Weight.V[Lane]};
}

/** A texture level with a sampler, read texel by texel. */
template<typename Real>
struct TTexelReader
{
	const FKernelTexture& Texture;
	const FKernelSampler& Sampler;
	const FKernelMip& Mip;
	int32_t BytesPerTexel;

	TTexelReader(const FKernelTexture& InTexture, const FKernelSampler& InSampler, int32_t MipIndex)
		: Texture(InTexture)
		, Sampler(InSampler)
		, Mip(InTexture.Mips[MipIndex])
		, BytesPerTexel(GetTexelStorageInfo(InTexture.Storage).BytesPerTexel)
	{
	}

	TTexel<Real> Read(int32_t X, int32_t Y, int32_t Z) const
	{
		if ((X | Y | Z) < 0)
		{
			const float* B = Sampler.Border;
			return {{Real(B[0]), Real(B[1]), Real(B[2]), Real(B[3])}};
		}
		return ReadTexel<Real>(Texture.Storage, TexelAddress(Mip, BytesPerTexel, X, Y, Z));
	}

	/** Vertical pairs first, then the horizontal one: the order of the tuned paths. */
	TTexel<Real> Filter2D(const TTap<Real>& X, const TTap<Real>& Y, int32_t Z) const
	{
		TTexel<Real> Left = Read(X.First, Y.First, Z);
		if (Y.Weight != 0)
		{
			Left = FilterPair(Left, Read(X.First, Y.Second, Z), Y.Weight);
		}
		if (X.Weight == 0)
		{
			return Left;
		}
		TTexel<Real> Right = Read(X.Second, Y.First, Z);
		if (Y.Weight != 0)
		{
			Right = FilterPair(Right, Read(X.Second, Y.Second, Z), Y.Weight);
		}
		return FilterPair(Left, Right, X.Weight);
	}

	TTexel<Real> Filter3D(const TTap<Real>& X, const TTap<Real>& Y, const TTap<Real>& Z) const
	{
		const TTexel<Real> Near = Filter2D(X, Y, Z.First);
		return Z.Weight == 0 ? Near : FilterPair(Near, Filter2D(X, Y, Z.Second), Z.Weight);
	}
};

template<typename Real, int N>
DRYDOCK_LANES_INLINE void WriteLane(Real* Out, int Lane, const TTexel<Real>& Texel)
{
	for (int c = 0; c < 4; ++c)
	{
		Out[c * N + Lane] = Texel.C[c];
	}
}

/** All lanes from one mip. Layers null: slice 0. */
template<typename Real, int N>
inline void SampleMip2DReference(const FKernelTexture& Texture, const FKernelSampler& Sampler, int32_t MipIndex,
	const TAxis<Real, N>& X, const TAxis<Real, N>& Y, const Real* Layers, Real* Out)
{
	const TTexelReader<Real> Reader(Texture, Sampler, MipIndex);
	for (int Lane = 0; Lane < N; ++Lane)
	{
		const TTap<Real> TapX = MakeTap(X, Lane, Reader.Mip.SizeX, Sampler.AddressU);
		const TTap<Real> TapY = MakeTap(Y, Lane, Reader.Mip.SizeY, Sampler.AddressV);
		const int32_t Layer = Layers ? SelectLayer(Layers[Lane], Reader.Mip.SizeZ) : 0;
		WriteLane<Real, N>(Out, Lane, Reader.Filter2D(TapX, TapY, Layer));
	}
}

template<typename Real, int N>
inline void SampleMip3DReference(const FKernelTexture& Texture, const FKernelSampler& Sampler, int32_t MipIndex,
	const TAxis<Real, N>& X, const TAxis<Real, N>& Y, const TAxis<Real, N>& Z, Real* Out)
{
	const TTexelReader<Real> Reader(Texture, Sampler, MipIndex);
	for (int Lane = 0; Lane < N; ++Lane)
	{
		const TTap<Real> TapX = MakeTap(X, Lane, Reader.Mip.SizeX, Sampler.AddressU);
		const TTap<Real> TapY = MakeTap(Y, Lane, Reader.Mip.SizeY, Sampler.AddressV);
		const TTap<Real> TapZ = MakeTap(Z, Lane, Reader.Mip.SizeZ, Sampler.AddressW);
		WriteLane<Real, N>(Out, Lane, Reader.Filter3D(TapX, TapY, TapZ));
	}
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
