// Samples and gathers that read their four texels one by one: of cubes, compared with a reference, or taken as they
// are. Float lanes read one texel of all lanes at a time, all others go lane by lane; same operations, same order, same
// bits. Comparisons come before filters, and after the average that stands beyond a cube's corner. Included by the
// LanesSampling_*.cpp only. Source: Vulkan specification, "Depth Compare Operation".
#pragma once

#include "LanesFootprints.inl"
#include "LanesTexels.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** Formats of 0 to 1 are compared with a value of 0 to 1. */
template<typename Real, int N>
DRYDOCK_LANES_INLINE Real GetReference(const FKernelTexture& Texture, const TSamplePlace<Real>& Place, int Lane)
{
	const Real Reference = Place.Reference[Lane];
	const bool bUnorm = GetTexelStorageInfo(Texture.Storage).Kind == ETexelKind::Unorm;
	return bUnorm ? First(Saturate(TReal<Real, 1>(Reference))) : Reference;
}

/** All lanes, one texel at a time. False where a result is NaN, or the texture has no lane code. */
template<int N>
inline bool ReadFour(const FKernelTexture& Texture, const FKernelSampler& Sampler, const FKernelMip& Mip,
	const TSamplePlace<float>& Place, const TFourTexels<float, N>& Four, TRaw<float, N> Q[4][4])
{
	using FFloat = TRaw<float, N>;
	const TTapReader<N> Reader = {Texture, Sampler, Mip};
	if (!Reader.CanRead())
	{
		return false;
	}
	for (int k = 0; k < 4; ++k)
	{
		Reader.Read(Four.X[k].V, Four.Y[k].V, Four.Z[k].V, Q[k]);
	}
	for (int k = 0; k < 4 && Four.bAnyMissing; ++k)
	{
		for (int c = 0; c < 4; ++c)
		{
			const FFloat Own = Q[k ^ 3][c];
			Q[k][c] = Four.bMissing[k].V != 0 ? Own + ((Q[k ^ 1][c] - Own) + (Q[k ^ 2][c] - Own)) / 3.0f : Q[k][c];
		}
		if (TLaneOps<N>::AnyNan(Q[k][0], Q[k][1], Q[k][2], Q[k][3]))
		{
			return false;
		}
	}
	if (Place.Reference)
	{
		TReal<float, N> Reference;
		for (int Lane = 0; Lane < N; ++Lane)
		{
			Reference.V[Lane] = GetReference<float, N>(Texture, Place, Lane);
		}
		for (int k = 0; k < 4; ++k)
		{
			const TMask<N> bTrue =
				TMask<N>(Sampler.Compare == EKernelCompare::Less) & (Reference < TReal<float, N>(Q[k][0]));
			Q[k][0] = bTrue.V != 0 ? Broadcast<float, N>(1.0f) : FFloat{};
			Q[k][1] = Q[k][2] = Q[k][3] = FFloat{};
		}
	}
	return true;
}

/** One lane. */
template<typename Real, int N>
inline void ReadFour(const TTexelReader<Real>& Reader, const TSamplePlace<Real>& Place,
	const TFourTexels<Real, N>& Four, int Lane, TTexel<Real> (&Q)[4])
{
	for (int k = 0; k < 4; ++k)
	{
		Q[k] = Reader.Read(Four.X[k][Lane], Four.Y[k][Lane], Four.Z[k][Lane]);
	}
	for (int k = 0; k < 4; ++k)
	{
		for (int c = 0; c < 4 && Four.bMissing[k][Lane]; ++c)
		{
			// As filters: the difference form keeps constants as they are, bit for bit.
			const Real Own = Q[k ^ 3].C[c];
			const Real A = Q[k ^ 1].C[c];
			const Real B = Q[k ^ 2].C[c];
			const Real Average = Own + ((A - Own) + (B - Own)) / Real(3);
			Q[k].C[c] = Average == Average ? Average : (Own + A + B) / Real(3);
		}
	}
	for (int k = 0; k < 4 && Place.Reference; ++k)
	{
		const Real Reference = GetReference<Real, N>(Reader.Texture, Place, Lane);
		Q[k] = {{Real(Reader.Sampler.Compare == EKernelCompare::Less && Reference < Q[k].C[0]), 0, 0, 0}};
	}
}

template<typename Real, int N>
__attribute__((noinline)) void SampleFour(const FKernelTexture& Texture, const FKernelSampler& Sampler,
	int32_t MipIndex, const TSamplePlace<Real>& Place, Real* Out)
{
	const FKernelMip& Mip = Texture.Mips[MipIndex];
	TFourTexels<Real, N> Four;
	FindTexels<Real, N>(Mip, Sampler, Place, Sampler.Filter == EKernelFilter::Point, Four);
	if constexpr (HasLaneCode<Real, N>)
	{
		using FReader = TTapReader<N>;
		TRaw<float, N> Q[4][4];
		if (ReadFour<N>(Texture, Sampler, Mip, Place, Four, Q))
		{
			FReader::Mix(Q[0], Q[2], Four.WeightY.V);
			FReader::Mix(Q[1], Q[3], Four.WeightY.V);
			FReader::Mix(Q[0], Q[1], Four.WeightX.V);
			if (FinishTaps<N>(Q[0], Out))
			{
				return;
			}
		}
		AddScalarCall(FReader{Texture, Sampler, Mip}.CanRead() ? EScalarCall::NaN : EScalarCall::Sample);
	}
	const TTexelReader<Real> Reader(Texture, Sampler, MipIndex);
	for (int Lane = 0; Lane < N; ++Lane)
	{
		TTexel<Real> Q[4];
		ReadFour<Real, N>(Reader, Place, Four, Lane, Q);
		const Real WeightY = Four.WeightY[Lane];
		WriteLane<Real, N>(Out, Lane,
			FilterPair(FilterPair(Q[0], Q[2], WeightY), FilterPair(Q[1], Q[3], WeightY), Real(Four.WeightX[Lane])));
	}
}

template<typename Real, int N>
__attribute__((noinline)) void GatherFour(const FKernelTexture& Texture, const FKernelSampler& Sampler,
	const TSamplePlace<Real>& Place, int32_t Component, Real* Out)
{
	constexpr int Order[4] = {2, 3, 1, 0}; // of Direct3D: from the lower left, against the clock
	const FKernelMip& Mip = Texture.Mips[0];
	TFourTexels<Real, N> Four;
	FindTexels<Real, N>(Mip, Sampler, Place, false, Four);
	if constexpr (HasLaneCode<Real, N>)
	{
		TRaw<float, N> Q[4][4];
		if (ReadFour<N>(Texture, Sampler, Mip, Place, Four, Q))
		{
			for (int i = 0; i < 4; ++i)
			{
				StoreRaw(Out + i * N, Q[Order[i]][Component]);
			}
			return;
		}
	}
	CountScalarCall<Real, N>(EScalarCall::Gather);
	const TTexelReader<Real> Reader(Texture, Sampler, 0);
	for (int Lane = 0; Lane < N; ++Lane)
	{
		TTexel<Real> Q[4];
		ReadFour<Real, N>(Reader, Place, Four, Lane, Q);
		for (int i = 0; i < 4; ++i)
		{
			Out[i * N + Lane] = Q[Order[i]].C[Component];
		}
	}
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
