// Defines the members of TSampling for the instruction set of the including file.
#pragma once

#include "LanesSamplingRows.inl"
#include "LanesStores.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** The rare half of SampleMip2D. */
template<typename Real, int N>
__attribute__((noinline)) void SampleMip2DRare(const FKernelTexture& Texture, const FKernelSampler& Sampler,
	int32_t MipIndex, const Real* U, const Real* V, const Real* Layers, Real* Out)
{
	const FKernelMip& Mip = Texture.Mips[MipIndex];
	const bool bPoint = Sampler.Filter == EKernelFilter::Point;
	const TAxis<Real, N> X = MakeAxis<Real, N>(U, Mip.SizeX, bPoint, Sampler.SampleBits);
	const TAxis<Real, N> Y = MakeAxis<Real, N>(V, Mip.SizeY, bPoint, Sampler.SampleBits);
	SampleMip2DReference<Real, N>(Texture, Sampler, MipIndex, X, Y, Layers, Out);
}

/** One mip of a 2D texture or of one layer of an array. */
template<typename Real, int N>
DRYDOCK_LANES_INLINE void SampleMip2D(const FKernelTexture& Texture, const FKernelSampler& Sampler, int32_t MipIndex,
	const Real* U, const Real* V, const Real* Layers, Real* Out)
{
	if constexpr (sizeof(Real) == 4)
	{
		const FKernelMip& Mip = Texture.Mips[MipIndex];
		const uint8_t* Base = Mip.Data;
		bool bOneLayer = true;
		if (Layers)
		{
			const int32_t Layer = SelectLayer(Layers[0], Mip.SizeZ);
			for (int Lane = 1; Lane < N; ++Lane)
			{
				bOneLayer = bOneLayer && SelectLayer(Layers[Lane], Mip.SizeZ) == Layer;
			}
			Base += int64_t(Layer) * Mip.SlicePitch;
		}
		if (bOneLayer && VisitFormat(Texture.Storage, [&](auto Format)
							 { return SampleMip2DTuned<decltype(Format), N>(Mip, Base, Sampler, U, V, Out); }))
		{
			return;
		}
	}
	SampleMip2DRare<Real, N>(Texture, Sampler, MipIndex, U, V, Layers, Out);
}

template<typename Real, int N>
inline void SampleMip3D(const FKernelTexture& Texture, const FKernelSampler& Sampler, int32_t MipIndex, const Real* U,
	const Real* V, const Real* W, Real* Out)
{
	const FKernelMip& Mip = Texture.Mips[MipIndex];
	const bool bPoint = Sampler.Filter == EKernelFilter::Point;
	const TAxis<Real, N> X = MakeAxis<Real, N>(U, Mip.SizeX, bPoint, Sampler.SampleBits);
	const TAxis<Real, N> Y = MakeAxis<Real, N>(V, Mip.SizeY, bPoint, Sampler.SampleBits);
	const TAxis<Real, N> Z = MakeAxis<Real, N>(W, Mip.SizeZ, bPoint, Sampler.SampleBits);
	SampleMip3DReference<Real, N>(Texture, Sampler, MipIndex, X, Y, Z, Out);
}

/** SampleMip(MipIndex, Out) fills [4][N]; picks and blends mips per lane. */
template<typename Real, int N, typename F>
inline void SampleMips(const FKernelTexture& Texture, const FKernelSampler& Sampler, const Real* Levels,
	bool bUniformLevel, Real* Out, F SampleMip)
{
	const TMips<Real> First = SelectMips(Levels[0], Texture.NumMips, Sampler);
	bool bSame = true;
	for (int Lane = 1; Lane < N && !bUniformLevel; ++Lane)
	{
		const TMips<Real> Other = SelectMips(Levels[Lane], Texture.NumMips, Sampler);
		bSame = bSame && Other.First == First.First && Other.Weight == First.Weight;
	}
	if (bSame)
	{
		SampleMip(First.First, Out);
		if (First.Weight != 0)
		{
			alignas(64) Real Next[4 * N];
			SampleMip(First.First + 1, Next);
			for (int i = 0; i < 4 * N; ++i)
			{
				Out[i] = FilterPair(Out[i], Next[i], First.Weight);
			}
		}
		return;
	}
	// Lanes on different mips: one pass over the mips that occur, each lane takes its own.
	alignas(64) Real One[4 * N];
	for (int32_t MipIndex = 0; MipIndex < Texture.NumMips; ++MipIndex)
	{
		bool bSampled = false;
		for (int Lane = 0; Lane < N; ++Lane)
		{
			const TMips<Real> Mips = SelectMips(Levels[Lane], Texture.NumMips, Sampler);
			const bool bFirst = Mips.First == MipIndex;
			const bool bSecond = Mips.First + 1 == MipIndex && Mips.Weight != 0;
			if (!bFirst && !bSecond)
			{
				continue;
			}
			if (!bSampled)
			{
				SampleMip(MipIndex, One);
				bSampled = true;
			}
			for (int c = 0; c < 4; ++c)
			{
				Real& Place = Out[c * N + Lane];
				Place = bFirst ? One[c * N + Lane] : FilterPair(Place, One[c * N + Lane], Mips.Weight);
			}
		}
	}
}

/** Reads one texel or gives 0 in all channels when it is outside. */
template<typename Texel, typename F>
inline Texel LoadInside(const FKernelTexture& Texture, int32_t X, int32_t Y, int32_t Z, int32_t MipIndex, F Read)
{
	if (uint32_t(MipIndex) < uint32_t(Texture.NumMips))
	{
		const FKernelMip& Mip = Texture.Mips[MipIndex];
		if (uint32_t(X) < uint32_t(Mip.SizeX) && uint32_t(Y) < uint32_t(Mip.SizeY) && uint32_t(Z) < uint32_t(Mip.SizeZ))
		{
			return Read(TexelAddress(Mip, GetTexelStorageInfo(Texture.Storage).BytesPerTexel, X, Y, Z));
		}
	}
	return Texel{};
}

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

/** A row of texels inside one mip, no filter. */
template<int N>
inline bool LoadRowTuned(
	const FKernelTexture& Texture, const int32_t* X, const int32_t* Y, const int32_t* Z, int32_t MipIndex, float* Out)
{
	if (uint32_t(MipIndex) >= uint32_t(Texture.NumMips))
	{
		return false;
	}
	const FKernelMip& Mip = Texture.Mips[MipIndex];
	const int32_t Slice = Z ? Z[0] : 0;
	const TRaw<int32_t, N> Columns = LoadRaw<TRaw<int32_t, N>>(X);
	const TRaw<int32_t, N> Rows = LoadRaw<TRaw<int32_t, N>>(Y);
	const bool bRow = X[0] >= 0 && X[0] <= Mip.SizeX - N && uint32_t(Y[0]) < uint32_t(Mip.SizeY) &&
					  uint32_t(Slice) < uint32_t(Mip.SizeZ) && IsRow<N>(Columns, Rows) &&
					  (!Z || IsSame<N>(LoadRaw<TRaw<int32_t, N>>(Z)));
	if (!bRow)
	{
		return false;
	}
	return VisitFormat(Texture.Storage,
		[&](auto Format)
		{
			using FFormat = decltype(Format);
			TRaw<float, N> C[4];
			LoadColumn<FFormat, N>(TexelAddress(Mip, FFormat::Bytes, X[0], Y[0], Slice), nullptr, 0, C);
			for (int c = 0; c < 4; ++c)
			{
				StoreRaw(Out + c * N, c < FFormat::Channels ? C[c] : Broadcast<float, N>(c == 3 ? 1.0f : 0.0f));
			}
			return true;
		});
}

inline bool IsInsideTyped(const FKernelBuffer& Buffer, uint32_t Index, int32_t BytesPerElement)
{
	return (uint64_t(Index) + 1) * uint64_t(BytesPerElement) <= Buffer.SizeInBytes;
}

} // namespace DRYDOCK_LANES_SET

template<typename Real, int N>
void TSampling<Real, N>::Sample2D(const FKernelTexture& Texture, const FKernelSampler& Sampler, const Real* U,
	const Real* V, const Real* Layer, const Real* Levels, bool bUniformLevel, Real* Out)
{
	if (Texture.NumMips == 1)
	{
		SampleMip2D<Real, N>(Texture, Sampler, 0, U, V, Layer, Out);
		return;
	}
	SampleMips<Real, N>(Texture, Sampler, Levels, bUniformLevel, Out,
		[&](int32_t MipIndex, Real* MipOut) { SampleMip2D<Real, N>(Texture, Sampler, MipIndex, U, V, Layer, MipOut); });
}

template<typename Real, int N>
void TSampling<Real, N>::Sample3D(const FKernelTexture& Texture, const FKernelSampler& Sampler, const Real* U,
	const Real* V, const Real* W, const Real* Levels, bool bUniformLevel, Real* Out)
{
	SampleMips<Real, N>(Texture, Sampler, Levels, bUniformLevel, Out,
		[&](int32_t MipIndex, Real* MipOut) { SampleMip3D<Real, N>(Texture, Sampler, MipIndex, U, V, W, MipOut); });
}

template<typename Real, int N>
void TSampling<Real, N>::Gather2D(const FKernelTexture& Texture, const FKernelSampler& Sampler, const Real* U,
	const Real* V, int32_t Component, Real* Out)
{
	const TTexelReader<Real> Reader(Texture, Sampler, 0);
	const TAxis<Real, N> X = MakeAxis<Real, N>(U, Reader.Mip.SizeX, false, Sampler.SampleBits);
	const TAxis<Real, N> Y = MakeAxis<Real, N>(V, Reader.Mip.SizeY, false, Sampler.SampleBits);
	for (int Lane = 0; Lane < N; ++Lane)
	{
		const TTap<Real> TapX = MakeTap(X, Lane, Reader.Mip.SizeX, Sampler.AddressU);
		const TTap<Real> TapY = MakeTap(Y, Lane, Reader.Mip.SizeY, Sampler.AddressV);
		Out[Lane] = Reader.Read(TapX.First, TapY.Second, 0).C[Component & 3];
		Out[N + Lane] = Reader.Read(TapX.Second, TapY.Second, 0).C[Component & 3];
		Out[2 * N + Lane] = Reader.Read(TapX.Second, TapY.First, 0).C[Component & 3];
		Out[3 * N + Lane] = Reader.Read(TapX.First, TapY.First, 0).C[Component & 3];
	}
}

template<typename Real, int N>
void TSampling<Real, N>::Load(const FKernelTexture& Texture, const int32_t* X, const int32_t* Y, const int32_t* Z,
	const int32_t* Mips, bool bUniformMip, Real* Out)
{
	if constexpr (sizeof(Real) == 4)
	{
		if (bUniformMip && LoadRowTuned<N>(Texture, X, Y, Z, Mips[0], Out))
		{
			return;
		}
	}
	for (int Lane = 0; Lane < N; ++Lane)
	{
		const int32_t MipIndex = Mips[bUniformMip ? 0 : Lane];
		const auto Read = [&Texture](const uint8_t* Address)
		{
			return ReadTexel<Real>(Texture.Storage, Address);
		};
		WriteLane<Real, N>(
			Out, Lane, LoadInside<TTexel<Real>>(Texture, X[Lane], Y[Lane], Z ? Z[Lane] : 0, MipIndex, Read));
	}
}

template<typename Real, int N>
void TSampling<Real, N>::LoadUint(const FKernelTexture& Texture, const int32_t* X, const int32_t* Y, const int32_t* Z,
	const int32_t* Mips, bool bUniformMip, uint32_t* Out)
{
	for (int Lane = 0; Lane < N; ++Lane)
	{
		const int32_t MipIndex = Mips[bUniformMip ? 0 : Lane];
		const auto Read = [&Texture](const uint8_t* Address)
		{
			TTexel<uint32_t> Texel;
			DecodeTexel(Texture.Storage, Address, Texel.C);
			return Texel;
		};
		WriteLane<uint32_t, N>(
			Out, Lane, LoadInside<TTexel<uint32_t>>(Texture, X[Lane], Y[Lane], Z ? Z[Lane] : 0, MipIndex, Read));
	}
}

template<typename Real, int N>
void TSampling<Real, N>::Store(const FKernelTexture& Texture, const int32_t* Mask, const int32_t* X, const int32_t* Y,
	const int32_t* Z, const Real* Value)
{
	const FKernelMip& Mip = Texture.Mips[0];
	const TRaw<int32_t, N> Columns = LoadRaw<TRaw<int32_t, N>>(X);
	const TRaw<int32_t, N> Rows = LoadRaw<TRaw<int32_t, N>>(Y);
	const bool bRow = IsRow<N>(Columns, Rows) && (!Z || IsSame<N>(LoadRaw<TRaw<int32_t, N>>(Z)));
	if (bRow)
	{
		StoreConsecutive<Real, N>(Texture, Mip, Mask, X[0], Y[0], Z ? Z[0] : 0, Value);
		return;
	}
	const int32_t Bytes = GetTexelStorageInfo(Texture.Storage).BytesPerTexel;
	for (int Lane = 0; Lane < N; ++Lane)
	{
		const int32_t Slice = Z ? Z[Lane] : 0;
		if (Mask[Lane] && uint32_t(X[Lane]) < uint32_t(Mip.SizeX) && uint32_t(Y[Lane]) < uint32_t(Mip.SizeY) &&
			uint32_t(Slice) < uint32_t(Mip.SizeZ))
		{
			StoreLane<Real, N>(
				Texture, const_cast<uint8_t*>(TexelAddress(Mip, Bytes, X[Lane], Y[Lane], Slice)), Value, Lane);
		}
	}
}

template<typename Real, int N>
void TSampling<Real, N>::StoreUint(const FKernelTexture& Texture, const int32_t* Mask, const int32_t* X,
	const int32_t* Y, const int32_t* Z, const uint32_t* Value)
{
	const FKernelMip& Mip = Texture.Mips[0];
	const int32_t Bytes = GetTexelStorageInfo(Texture.Storage).BytesPerTexel;
	for (int Lane = 0; Lane < N; ++Lane)
	{
		const int32_t Slice = Z ? Z[Lane] : 0;
		if (Mask[Lane] && uint32_t(X[Lane]) < uint32_t(Mip.SizeX) && uint32_t(Y[Lane]) < uint32_t(Mip.SizeY) &&
			uint32_t(Slice) < uint32_t(Mip.SizeZ))
		{
			const uint32_t RGBA[4] = {Value[Lane], Value[N + Lane], Value[2 * N + Lane], Value[3 * N + Lane]};
			EncodeTexel(Texture.Storage, RGBA, const_cast<uint8_t*>(TexelAddress(Mip, Bytes, X[Lane], Y[Lane], Slice)));
		}
	}
}

template<typename Real, int N>
void TSampling<Real, N>::StoreTarget(
	const FKernelTarget& Target, const int32_t* Mask, int32_t X0, int32_t Y, const Real* Value)
{
	StoreTargetLanes<Real, N>(Target, Mask, X0, Y, Value);
}

template<typename Real, int N>
void TSampling<Real, N>::LoadTyped(const FKernelBuffer& Buffer, const uint32_t* Index, Real* Out)
{
	const int32_t Bytes = GetTexelStorageInfo(Buffer.Storage).BytesPerTexel;
	for (int Lane = 0; Lane < N; ++Lane)
	{
		const bool bInside = IsInsideTyped(Buffer, Index[Lane], Bytes);
		WriteLane<Real, N>(Out, Lane,
			bInside ? ReadTexel<Real>(Buffer.Storage, Buffer.Data + uint64_t(Index[Lane]) * Bytes) : TTexel<Real>{});
	}
}

template<typename Real, int N>
void TSampling<Real, N>::LoadTypedUint(const FKernelBuffer& Buffer, const uint32_t* Index, uint32_t* Out)
{
	const int32_t Bytes = GetTexelStorageInfo(Buffer.Storage).BytesPerTexel;
	for (int Lane = 0; Lane < N; ++Lane)
	{
		TTexel<uint32_t> Texel = {};
		if (IsInsideTyped(Buffer, Index[Lane], Bytes))
		{
			DecodeTexel(Buffer.Storage, Buffer.Data + uint64_t(Index[Lane]) * Bytes, Texel.C);
		}
		WriteLane<uint32_t, N>(Out, Lane, Texel);
	}
}

template<typename Real, int N>
void TSampling<Real, N>::StoreTyped(
	const FKernelBuffer& Buffer, const int32_t* Mask, const uint32_t* Index, const Real* Value)
{
	const int32_t Bytes = GetTexelStorageInfo(Buffer.Storage).BytesPerTexel;
	for (int Lane = 0; Lane < N; ++Lane)
	{
		if (Mask[Lane] && IsInsideTyped(Buffer, Index[Lane], Bytes))
		{
			const Real RGBA[4] = {Value[Lane], Value[N + Lane], Value[2 * N + Lane], Value[3 * N + Lane]};
			EncodeTexel(Buffer.Storage, RGBA, Buffer.Data + uint64_t(Index[Lane]) * Bytes);
		}
	}
}

template<typename Real, int N>
void TSampling<Real, N>::StoreTypedUint(
	const FKernelBuffer& Buffer, const int32_t* Mask, const uint32_t* Index, const uint32_t* Value)
{
	const int32_t Bytes = GetTexelStorageInfo(Buffer.Storage).BytesPerTexel;
	for (int Lane = 0; Lane < N; ++Lane)
	{
		if (Mask[Lane] && IsInsideTyped(Buffer, Index[Lane], Bytes))
		{
			const uint32_t RGBA[4] = {Value[Lane], Value[N + Lane], Value[2 * N + Lane], Value[3 * N + Lane]};
			EncodeTexel(Buffer.Storage, RGBA, Buffer.Data + uint64_t(Index[Lane]) * Bytes);
		}
	}
}

} // namespace Drydock::Lanes
