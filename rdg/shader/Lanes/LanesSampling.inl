// Defines the members of TSampling for the instruction set of the including file. One float lane has no lane code: it
// is the reference that the others are compared with.
#pragma once

#include "LanesBuffers.inl"
#include "LanesFourTexels.inl"
#include "LanesStores.inl"
#include "LanesTaps.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** Lane code that can read the texture and gave up has met a NaN. */
template<typename Real, int N>
DRYDOCK_LANES_INLINE void CountScalarSample(
	const FKernelTexture& Texture, const FKernelSampler& Sampler, const FKernelMip& Mip)
{
	if constexpr (HasLaneCode<Real, N>)
	{
		AddScalarCall(TTapReader<N>{Texture, Sampler, Mip}.CanRead() ? EScalarCall::NaN : EScalarCall::Sample);
	}
}

/** The rare half of SampleMip2D: 64-bit formats, slices too large for gathers, results that are NaN. */
template<typename Real, int N>
__attribute__((noinline)) void SampleMip2DRare(const FKernelTexture& Texture, const FKernelSampler& Sampler,
	int32_t MipIndex, const Real* U, const Real* V, const Real* Layers, Real* Out)
{
	const FKernelMip& Mip = Texture.Mips[MipIndex];
	CountScalarSample<Real, N>(Texture, Sampler, Mip);
	const bool bPoint = Sampler.Filter == EKernelFilter::Point;
	const TAxis<Real, N> X = MakeAxis<Real, N>(U, Mip.SizeX, bPoint, Sampler.SampleBits);
	const TAxis<Real, N> Y = MakeAxis<Real, N>(V, Mip.SizeY, bPoint, Sampler.SampleBits);
	SampleMip2DReference<Real, N>(Texture, Sampler, MipIndex, X, Y, Layers, Out);
}

/** Lanes in different layers of an array. False where SampleMip2DRare must decide. */
template<int N>
__attribute__((noinline)) bool SampleLayers(const FKernelTexture& Texture, const FKernelSampler& Sampler,
	const FKernelMip& Mip, const float* U, const float* V, const float* Layers, float* Out)
{
	const TTapReader<N> Reader = {Texture, Sampler, Mip};
	if (!Reader.CanRead())
	{
		return false;
	}
	const bool bPoint = Sampler.Filter == EKernelFilter::Point;
	const TAxis<float, N> X = MakeAxis<float, N>(U, Mip.SizeX, bPoint, Sampler.SampleBits);
	const TAxis<float, N> Y = MakeAxis<float, N>(V, Mip.SizeY, bPoint, Sampler.SampleBits);
	TRaw<int32_t, N> Slices;
	for (int Lane = 0; Lane < N; ++Lane)
	{
		Slices[Lane] = SelectLayer(Layers[Lane], Mip.SizeZ);
	}
	TRaw<float, N> C[4];
	Reader.Filter2D(TTaps<N>(X, Mip.SizeX, Sampler.AddressU), TTaps<N>(Y, Mip.SizeY, Sampler.AddressV), Slices, C);
	return FinishTaps<N>(C, Out);
}

/** One mip of a 2D texture or of one layer of an array. */
template<typename Real, int N>
DRYDOCK_LANES_INLINE void SampleMip2D(const FKernelTexture& Texture, const FKernelSampler& Sampler, int32_t MipIndex,
	const Real* U, const Real* V, const Real* Layers, Real* Out, const FTapPlace& Place = {})
{
	if constexpr (HasLaneCode<Real, N>)
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
		const auto Sample = [&](auto Format)
		{
			return SampleMip2DTuned<N>(Format, Texture, Mip, Base, Sampler, U, V, Out, Place);
		};
		const FTexelStorageInfo& Info = GetTexelStorageInfo(Texture.Storage);
		if (!bOneLayer ? SampleLayers<N>(Texture, Sampler, Mip, U, V, Layers, Out)
					   : VisitPictureFormat(Texture.Storage, Sample) ||
							 (Info.BitsPerChannel <= 32 && Sample(FAnyFormat{Texture.Storage, Info.BytesPerTexel})))
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
	if constexpr (HasLaneCode<Real, N>)
	{
		const TTapReader<N> Reader = {Texture, Sampler, Mip};
		if (Reader.CanRead())
		{
			TRaw<float, N> C[4];
			Reader.Filter3D(TTaps<N>(X, Mip.SizeX, Sampler.AddressU), TTaps<N>(Y, Mip.SizeY, Sampler.AddressV),
				TTaps<N>(Z, Mip.SizeZ, Sampler.AddressW), C);
			if (FinishTaps<N>(C, Out))
			{
				return;
			}
		}
	}
	CountScalarSample<Real, N>(Texture, Sampler, Mip);
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

/** One mip for the lanes of the mask; a row of texels inside it is read without gathers. */
template<typename Scalar, int N>
inline bool LoadMip(const FKernelTexture& Texture, int32_t MipIndex, TMask<N> Lanes, const int32_t* X, const int32_t* Y,
	const int32_t* Z, TRaw<Scalar, N> C[4], const FTapPlace& Place = {})
{
	if (uint32_t(MipIndex) >= uint32_t(Texture.NumMips))
	{
		for (int c = 0; c < 4; ++c)
		{
			C[c] = TRaw<Scalar, N>{};
		}
		return true;
	}
	const FKernelMip& Mip = Texture.Mips[MipIndex];
	const int32_t Slice = Z ? Z[0] : 0;
	const bool bRow = X[0] >= 0 && X[0] <= Mip.SizeX - N && uint32_t(Y[0]) < uint32_t(Mip.SizeY) &&
					  uint32_t(Slice) < uint32_t(Mip.SizeZ) && AllLanes(Lanes) &&
					  IsRow<N>(LoadRaw<TRaw<int32_t, N>>(X), LoadRaw<TRaw<int32_t, N>>(Y)) &&
					  (!Z || IsSame<N>(LoadRaw<TRaw<int32_t, N>>(Z)));
	if (bRow)
	{
		const int32_t Bytes = GetTexelStorageInfo(Texture.Storage).BytesPerTexel;
		if (Place.Tap)
		{
			LearnLoad<N>(Place, Texture.Storage, Mip, X[0], Y[0], Slice);
		}
		return LoadTexels<Scalar, N>(Texture.Storage, TexelAddress(Mip, Bytes, X[0], Y[0], Slice), C);
	}
	return LoadLanes<Scalar, N>(Texture, Mip, Lanes, X, Y, Z, C);
}

/** Lanes from one mip or from one each. False when the storage has no lane code. */
template<typename Scalar, int N>
inline bool LoadMips(const FKernelTexture& Texture, const int32_t* X, const int32_t* Y, const int32_t* Z,
	const int32_t* Mips, bool bUniformMip, Scalar* Out)
{
	TRaw<Scalar, N> C[4];
	if (bUniformMip || IsSame<N>(LoadRaw<TRaw<int32_t, N>>(Mips)))
	{
		if (!LoadMip<Scalar, N>(Texture, Mips[0], TMask<N>(true), X, Y, Z, C))
		{
			return false;
		}
		StoreRaw(Out, C);
		return true;
	}
	TRaw<Scalar, N> All[4] = {};
	for (int32_t MipIndex = 0; MipIndex < Texture.NumMips; ++MipIndex)
	{
		const TMask<N> Lanes(LoadRaw<TRaw<int32_t, N>>(Mips) == MipIndex);
		if (!AnyLane(Lanes))
		{
			continue;
		}
		if (!LoadMip<Scalar, N>(Texture, MipIndex, Lanes, X, Y, Z, C))
		{
			return false;
		}
		for (int c = 0; c < 4; ++c)
		{
			All[c] = Lanes.V != 0 ? C[c] : All[c];
		}
	}
	StoreRaw(Out, All);
	return true;
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
void TSampling<Real, N>::LearnSample2D(const FKernelTexture& Texture, const FKernelSampler& Sampler, const Real* U,
	const Real* V, Real Level, Real* Out, FKernelTap& Tap, int32_t X0, int32_t Y)
{
	const TMips<Real> Mips = SelectMips(Level, Texture.NumMips, Sampler);
	if (Texture.NumMips == 1 || Mips.Weight == 0)
	{
		const int32_t MipIndex = Texture.NumMips == 1 ? 0 : Mips.First;
		if constexpr (HasLaneCode<Real, N>)
		{
			if (LearnRow<N>(Texture, Texture.Mips[MipIndex], Sampler, V, {&Tap, X0, Y}) && Tap.Function(Tap, X0, Out))
			{
				return;
			}
		}
		SampleMip2D<Real, N>(Texture, Sampler, MipIndex, U, V, nullptr, Out, {&Tap, X0, Y});
		return;
	}
	Sample2D(Texture, Sampler, U, V, nullptr, &Level, true, Out);
}

template<typename Real, int N>
void TSampling<Real, N>::Sample3D(const FKernelTexture& Texture, const FKernelSampler& Sampler, const Real* U,
	const Real* V, const Real* W, const Real* Levels, bool bUniformLevel, Real* Out)
{
	SampleMips<Real, N>(Texture, Sampler, Levels, bUniformLevel, Out,
		[&](int32_t MipIndex, Real* MipOut) { SampleMip3D<Real, N>(Texture, Sampler, MipIndex, U, V, W, MipOut); });
}

template<typename Real, int N>
void TSampling<Real, N>::Sample(const FKernelTexture& Texture, const FKernelSampler& Sampler,
	const TSamplePlace<Real>& Place, const Real* Levels, bool bUniformLevel, Real* Out)
{
	SampleMips<Real, N>(Texture, Sampler, Levels, bUniformLevel, Out,
		[&](int32_t MipIndex, Real* MipOut)
		{
			const TPlaceAtMip<Real, N> At(Place, Texture.Mips[MipIndex]);
			if (At.bCube || At.Reference)
			{
				SampleFour<Real, N>(Texture, Sampler, MipIndex, At, MipOut);
				return;
			}
			FKernelTexture One = Texture;
			One.Mips += MipIndex;
			One.NumMips = 1;
			const Real* const* const C = At.Coordinates;
			C[2] ? Sample3D(One, Sampler, C[0], C[1], C[2], Levels, true, MipOut)
				 : Sample2D(One, Sampler, C[0], C[1], At.Layer, Levels, true, MipOut);
		});
}

template<typename Real, int N>
void TSampling<Real, N>::Gather(const FKernelTexture& Texture, const FKernelSampler& Sampler,
	const TSamplePlace<Real>& Place, int32_t Component, Real* Out)
{
	GatherFour<Real, N>(Texture, Sampler, TPlaceAtMip<Real, N>(Place, Texture.Mips[0]), Component & 3, Out);
}

template<typename Real, int N>
void TSampling<Real, N>::Load(const FKernelTexture& Texture, const int32_t* X, const int32_t* Y, const int32_t* Z,
	const int32_t* Mips, bool bUniformMip, Real* Out)
{
	if constexpr (HasLaneCode<Real, N>)
	{
		if (LoadMips<float, N>(Texture, X, Y, Z, Mips, bUniformMip, Out))
		{
			return;
		}
	}
	CountScalarCall<Real, N>(EScalarCall::Load);
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
void TSampling<Real, N>::LearnLoad2D(const FKernelTexture& Texture, const int32_t* X, const int32_t* Y, int32_t Mip,
	Real* Out, FKernelTap& Tap, int32_t X0, int32_t Row)
{
	if constexpr (HasLaneCode<Real, N>)
	{
		TRaw<float, N> C[4];
		if (LoadMip<float, N>(Texture, Mip, TMask<N>(true), X, Y, nullptr, C, {&Tap, X0, Row}))
		{
			StoreRaw(Out, C);
			return;
		}
	}
	Load(Texture, X, Y, nullptr, &Mip, true, Out);
}

template<typename Real, int N>
void TSampling<Real, N>::LoadUint(const FKernelTexture& Texture, const int32_t* X, const int32_t* Y, const int32_t* Z,
	const int32_t* Mips, bool bUniformMip, uint32_t* Out)
{
	if constexpr (HasLaneCode<Real, N>)
	{
		if (LoadMips<uint32_t, N>(Texture, X, Y, Z, Mips, bUniformMip, Out))
		{
			return;
		}
	}
	CountScalarCall<Real, N>(EScalarCall::Load);
	for (int Lane = 0; Lane < N; ++Lane)
	{
		const int32_t MipIndex = Mips[bUniformMip ? 0 : Lane];
		const auto Read = [&Texture](const uint8_t* Address)
		{
			return ReadTexel<uint32_t>(Texture.Storage, Address);
		};
		WriteLane<uint32_t, N>(
			Out, Lane, LoadInside<TTexel<uint32_t>>(Texture, X[Lane], Y[Lane], Z ? Z[Lane] : 0, MipIndex, Read));
	}
}

template<typename Real, int N>
void TSampling<Real, N>::Store(const FKernelTexture& Texture, const int32_t* Mask, const int32_t* X, const int32_t* Y,
	const int32_t* Z, const Real* Value)
{
	StoreLanes<Real, Real, N>(Texture, Mask, X, Y, Z, Value);
}

template<typename Real, int N>
void TSampling<Real, N>::StoreUint(const FKernelTexture& Texture, const int32_t* Mask, const int32_t* X,
	const int32_t* Y, const int32_t* Z, const uint32_t* Value)
{
	StoreLanes<Real, uint32_t, N>(Texture, Mask, X, Y, Z, Value);
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
	LoadElements<Real, Real, N>(Buffer, Index, Out);
}

template<typename Real, int N>
void TSampling<Real, N>::LoadTypedUint(const FKernelBuffer& Buffer, const uint32_t* Index, uint32_t* Out)
{
	LoadElements<Real, uint32_t, N>(Buffer, Index, Out);
}

template<typename Real, int N>
void TSampling<Real, N>::StoreTyped(
	const FKernelBuffer& Buffer, const int32_t* Mask, const uint32_t* Index, const Real* Value)
{
	StoreElements<Real, Real, N>(Buffer, Mask, Index, Value);
}

template<typename Real, int N>
void TSampling<Real, N>::StoreTypedUint(
	const FKernelBuffer& Buffer, const int32_t* Mask, const uint32_t* Index, const uint32_t* Value)
{
	StoreElements<Real, uint32_t, N>(Buffer, Mask, Index, Value);
}

} // namespace Drydock::Lanes
