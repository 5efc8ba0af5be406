// The tuned sampling paths for float lanes. Lanes are neighbours along x, so most samples of a full-screen pass fall on
// one row pair with one vertical weight:
//   consecutive   texel x0 + lane, one horizontal weight (blurs, aligned copies): whole-row loads
//   window        any texels within N or 2 N neighbours (magnification, 2:1 minification, clamped edges): whole-row
//                 loads, then a permutation picks each lane's pair
//   general       anything else: one footprint per lane
// All do the operations of LanesSamplingReference.inl in the same order, hence give the same bits. A result that is NaN
// is left to that code. Included by the LanesSampling_*.cpp only. Source: drydock.
#pragma once

#include "LanesFormats.inl"
#include "LanesSamplingReference.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

template <int N>
DRYDOCK_LANES_INLINE bool AllEqual(TRaw<int32_t, N> A, TRaw<int32_t, N> B)
{
	return MaskBits(TMask<N>(TRaw<int32_t, N>(A != B))) == 0;
}
template <int N>
DRYDOCK_LANES_INLINE bool AllEqual(TRaw<float, N> A, float B)
{
	return MaskBits(TMask<N>(TRaw<int32_t, N>(A != B))) == 0;
}

template <typename V, typename W>
DRYDOCK_LANES_INLINE V Blend(V A, V B, W Weight)
{
	return A + Weight * (B - A);
}

/** N neighbouring texels of one row, or of two blended (Row1 not null), as channels. */
template <typename FFormat, int N>
DRYDOCK_LANES_INLINE void LoadColumn(const uint8_t* Row0, const uint8_t* Row1, float Weight, TRaw<float, N> C[4])
{
	if constexpr (FFormat::bWide)
	{
		constexpr int Step = N / 4 * FFormat::Bytes;
		TRaw<float, N> A[4];
		for (int k = 0; k < 4; ++k)
		{
			A[k] = FFormat::template Load<N>(Row0 + k * Step);
		}
		if (Row1)
		{
			for (int k = 0; k < 4; ++k)
			{
				A[k] = Blend(A[k], FFormat::template Load<N>(Row1 + k * Step), Weight);
			}
		}
		TLaneOps<N>::Split(A, C);
	}
	else
	{
		FFormat::template Decode<N>(LoadWords<FFormat, N>(Row0), C);
		if (Row1)
		{
			TRaw<float, N> D[4];
			FFormat::template Decode<N>(LoadWords<FFormat, N>(Row1), D);
			for (int c = 0; c < FFormat::Channels; ++c)
			{
				C[c] = Blend(C[c], D[c], Weight);
			}
		}
	}
}

/** Lane i samples texels Row + i and Row + i + 1. */
template <typename FFormat, int N>
DRYDOCK_LANES_INLINE void SampleConsecutive(const uint8_t* Row0, const uint8_t* Row1, float WeightX, float WeightY, TRaw<float, N> C[4])
{
	if (WeightX == 0)
	{
		LoadColumn<FFormat, N>(Row0, Row1, WeightY, C);
		return;
	}
	if constexpr (FFormat::bWide)
	{
		constexpr int Step = N / 4 * FFormat::Bytes;
		TRaw<float, N> A[4];
		if (Row1)
		{
			for (int k = 0; k < 4; ++k)
			{
				const uint8_t* P = Row0 + k * Step;
				const uint8_t* Q = Row1 + k * Step;
				const TRaw<float, N> Left = Blend(FFormat::template Load<N>(P), FFormat::template Load<N>(Q), WeightY);
				const TRaw<float, N> Right = Blend(FFormat::template Load<N>(P + FFormat::Bytes), FFormat::template Load<N>(Q + FFormat::Bytes), WeightY);
				A[k] = Blend(Left, Right, WeightX);
			}
		}
		else
		{
			for (int k = 0; k < 4; ++k)
			{
				const uint8_t* P = Row0 + k * Step;
				A[k] = Blend(FFormat::template Load<N>(P), FFormat::template Load<N>(P + FFormat::Bytes), WeightX);
			}
		}
		TLaneOps<N>::Split(A, C);
	}
	else
	{
		TRaw<float, N> Right[4];
		LoadColumn<FFormat, N>(Row0, Row1, WeightY, C);
		LoadColumn<FFormat, N>(Row0 + FFormat::Bytes, Row1 ? Row1 + FFormat::Bytes : nullptr, WeightY, Right);
		for (int c = 0; c < FFormat::Channels; ++c)
		{
			C[c] = Blend(C[c], Right[c], WeightX);
		}
	}
}

/** Lane i samples texels Left[i] and Right[i] of a window of N (bTwo: 2 N) texels that starts at Row. */
template <typename FFormat, int N, bool bTwo>
DRYDOCK_LANES_INLINE void SampleWindow(const uint8_t* Row0, const uint8_t* Row1, TRaw<int32_t, N> Left, TRaw<int32_t, N> Right, TRaw<float, N> WeightX, float WeightY, TRaw<float, N> C[4])
{
	using FOps = TLaneOps<N>;
	constexpr int Second = N * FFormat::Bytes;
	TRaw<float, N> Low[4];
	TRaw<float, N> High[4];
	LoadColumn<FFormat, N>(Row0, Row1, WeightY, Low);
	if constexpr (bTwo)
	{
		LoadColumn<FFormat, N>(Row0 + Second, Row1 ? Row1 + Second : nullptr, WeightY, High);
	}
	for (int c = 0; c < FFormat::Channels; ++c)
	{
		TRaw<float, N> L;
		TRaw<float, N> R;
		if constexpr (bTwo)
		{
			L = FOps::Permute2(Low[c], High[c], Left);
			R = FOps::Permute2(Low[c], High[c], Right);
		}
		else
		{
			L = FOps::Permute(Low[c], Left);
			R = FOps::Permute(Low[c], Right);
		}
		C[c] = WeightX == 0.0f ? L : Blend(L, R, WeightX);
	}
}

/** Texels and weights of all lanes after addressing; nothing is on the border. */
template <int N>
struct TFootprints
{
	TRaw<int32_t, N> Left;
	TRaw<int32_t, N> Right;
	TRaw<int32_t, N> Top;
	TRaw<int32_t, N> Bottom;
	TRaw<float, N> WeightX;
	TRaw<float, N> WeightY;
};

/** One footprint per lane: whole texels, blended as four channels at once. */
template <typename FFormat, int N>
DRYDOCK_LANES_INLINE void SampleGeneralWide(const FKernelMip& Mip, const uint8_t* Base, const TFootprints<N>& F, TRaw<float, N> C[4])
{
	using FQuad = TRaw<float, 4>;
	alignas(64) int32_t Left[N], Right[N], Top[N], Bottom[N];
	alignas(64) float WeightX[N], WeightY[N];
	StoreRaw(Left, F.Left);
	StoreRaw(Right, F.Right);
	StoreRaw(Top, F.Top);
	StoreRaw(Bottom, F.Bottom);
	StoreRaw(WeightX, F.WeightX);
	StoreRaw(WeightY, F.WeightY);
	FQuad Texels[N];
	for (int Lane = 0; Lane < N; ++Lane)
	{
		const uint8_t* Row0 = Base + int64_t(Top[Lane]) * Mip.RowPitch;
		const uint8_t* Row1 = Base + int64_t(Bottom[Lane]) * Mip.RowPitch;
		const int64_t L = int64_t(Left[Lane]) * FFormat::Bytes;
		const int64_t R = int64_t(Right[Lane]) * FFormat::Bytes;
		const float X = WeightX[Lane];
		const float Y = WeightY[Lane];
		FQuad A = LoadQuad<FFormat>(Row0 + L);
		if (Y != 0)
		{
			A = Blend(A, LoadQuad<FFormat>(Row1 + L), Y);
		}
		if (X != 0)
		{
			FQuad B = LoadQuad<FFormat>(Row0 + R);
			if (Y != 0)
			{
				B = Blend(B, LoadQuad<FFormat>(Row1 + R), Y);
			}
			A = Blend(A, B, X);
		}
		Texels[Lane] = A;
	}
	// Register k of the AoS order holds texels k * N / 4 and on.
	TRaw<float, N> A[4];
	for (int k = 0; k < 4; ++k)
	{
		A[k] = TLaneOps<N>::SetQuads(Texels + k * (N / 4));
	}
	TLaneOps<N>::Split(A, C);
}

/** One footprint per lane by gathers. A gather reads a whole word: the margin of a texture's memory allows it. */
template <typename FFormat, int N>
DRYDOCK_LANES_INLINE void SampleGeneralNarrow(const FKernelMip& Mip, const uint8_t* Base, const TFootprints<N>& F, TRaw<float, N> C[4])
{
	using FInt = TRaw<int32_t, N>;
	using FFloat = TRaw<float, N>;
	const FInt Row0 = F.Top * Mip.RowPitch;
	const FInt Row1 = F.Bottom * Mip.RowPitch;
	const FInt L = F.Left * FFormat::Bytes;
	const FInt R = F.Right * FFormat::Bytes;
	FFloat D[4];
	FFormat::template Decode<N>(TLaneOps<N>::Gather(Base, Row0 + L), C);
	const bool bTwoRows = !AllEqual<N>(F.WeightY, 0.0f);
	const bool bTwoColumns = !AllEqual<N>(F.WeightX, 0.0f);
	if (bTwoRows)
	{
		FFormat::template Decode<N>(TLaneOps<N>::Gather(Base, Row1 + L), D);
		for (int c = 0; c < FFormat::Channels; ++c)
		{
			C[c] = F.WeightY == 0.0f ? C[c] : Blend(C[c], D[c], F.WeightY);
		}
	}
	if (!bTwoColumns)
	{
		return;
	}
	FFloat E[4];
	FFormat::template Decode<N>(TLaneOps<N>::Gather(Base, Row0 + R), E);
	if (bTwoRows)
	{
		FFormat::template Decode<N>(TLaneOps<N>::Gather(Base, Row1 + R), D);
		for (int c = 0; c < FFormat::Channels; ++c)
		{
			E[c] = F.WeightY == 0.0f ? E[c] : Blend(E[c], D[c], F.WeightY);
		}
	}
	for (int c = 0; c < FFormat::Channels; ++c)
	{
		C[c] = F.WeightX == 0.0f ? C[c] : Blend(C[c], E[c], F.WeightX);
	}
}

/** Fills Out; false when a lane is on the border or a result is NaN, which the reference decides. */
template <typename FFormat, int N>
inline bool SampleMip2DTuned(const FKernelMip& Mip, const uint8_t* Base, const FKernelSampler& Sampler, const TAxis<float, N>& X, const TAxis<float, N>& Y, float* Out)
{
	using FInt = TRaw<int32_t, N>;
	using FFloat = TRaw<float, N>;
	using FOps = TLaneOps<N>;
	FFloat C[4];
	const FInt Iota = LaneIndex<N>().V;
	const float FirstX = X.Weight.V[0];
	const float FirstY = Y.Weight.V[0];
	const bool bOneRow = AllEqual<N>(Y.First.V, Broadcast<int32_t, N>(Y.First.V[0])) && AllEqual<N>(Y.Weight.V, FirstY);

	bool bDone = false;
	const uint8_t* Row0 = nullptr;
	const uint8_t* Row1 = nullptr;
	if (bOneRow)
	{
		const int32_t Top = AddressTexel(Y.First.V[0], Mip.SizeY, Sampler.AddressV);
		const int32_t Bottom = FirstY == 0 ? Top : AddressTexel(Y.First.V[0] + 1, Mip.SizeY, Sampler.AddressV);
		if ((Top | Bottom) < 0)
		{
			return false;
		}
		Row0 = Base + int64_t(Top) * Mip.RowPitch;
		Row1 = FirstY == 0 ? nullptr : Base + int64_t(Bottom) * Mip.RowPitch;
		const int32_t Start = X.First.V[0];
		if (Start >= 0 && Start + N + (FirstX == 0 ? 0 : 1) <= Mip.SizeX && AllEqual<N>(X.First.V, Iota + Start) && AllEqual<N>(X.Weight.V, FirstX))
		{
			const int64_t Offset = int64_t(Start) * FFormat::Bytes;
			SampleConsecutive<FFormat, N>(Row0 + Offset, Row1 ? Row1 + Offset : nullptr, FirstX, FirstY, C);
			bDone = true;
		}
	}

	if (!bDone)
	{
		TFootprints<N> F;
		F.Left = AddressTexels(X.First, Mip.SizeX, Sampler.AddressU).V;
		F.Right = AddressTexels(X.First + TInt<N>(1), Mip.SizeX, Sampler.AddressU).V;
		F.WeightX = X.Weight.V;
		// A tap of weight 0 is not read: it must not send the sample to the border's path either.
		F.Right = F.WeightX == 0.0f ? F.Left : F.Right;
		if (MaskBits(TMask<N>((F.Left | F.Right) < 0)) != 0)
		{
			return false;
		}
		if constexpr (FOps::bHasPermute)
		{
			if (bOneRow && Mip.SizeX >= N)
			{
				const auto Fits = [&F](int32_t Start, int32_t Count)
				{
					const TRaw<uint32_t, N> Limit = Broadcast<uint32_t, N>(uint32_t(Count));
					return AllLanes(TUint<N>(TRaw<uint32_t, N>(F.Left - Start)) < TUint<N>(Limit)) && AllLanes(TUint<N>(TRaw<uint32_t, N>(F.Right - Start)) < TUint<N>(Limit));
				};
				const int32_t Lowest = F.Left[0];
				const int32_t StartOne = Lowest < Mip.SizeX - N ? Lowest : Mip.SizeX - N;
				const int32_t StartTwo = Lowest < Mip.SizeX - 2 * N ? Lowest : Mip.SizeX - 2 * N;
				if (Fits(StartOne, N))
				{
					const int64_t Offset = int64_t(StartOne) * FFormat::Bytes;
					SampleWindow<FFormat, N, false>(Row0 + Offset, Row1 ? Row1 + Offset : nullptr, F.Left - StartOne, F.Right - StartOne, F.WeightX, FirstY, C);
					bDone = true;
				}
				else if (StartTwo >= 0 && Fits(StartTwo, 2 * N))
				{
					const int64_t Offset = int64_t(StartTwo) * FFormat::Bytes;
					SampleWindow<FFormat, N, true>(Row0 + Offset, Row1 ? Row1 + Offset : nullptr, F.Left - StartTwo, F.Right - StartTwo, F.WeightX, FirstY, C);
					bDone = true;
				}
			}
		}
		if (!bDone)
		{
			F.Top = AddressTexels(Y.First, Mip.SizeY, Sampler.AddressV).V;
			F.Bottom = AddressTexels(Y.First + TInt<N>(1), Mip.SizeY, Sampler.AddressV).V;
			F.WeightY = Y.Weight.V;
			F.Bottom = F.WeightY == 0.0f ? F.Top : F.Bottom;
			if (MaskBits(TMask<N>((F.Top | F.Bottom) < 0)) != 0)
			{
				return false;
			}
			if constexpr (FFormat::bWide)
			{
				SampleGeneralWide<FFormat, N>(Mip, Base, F, C);
			}
			else
			{
				// Gathers take 32-bit offsets.
				if (int64_t(Mip.RowPitch) * Mip.SizeY > 0x7FFFFFFF)
				{
					return false;
				}
				SampleGeneralNarrow<FFormat, N>(Mip, Base, F, C);
			}
		}
	}

	FInt Nan = C[0] != C[0];
	for (int c = 1; c < FFormat::Channels; ++c)
	{
		Nan |= C[c] != C[c];
	}
	if (MaskBits(TMask<N>(Nan)) != 0)
	{
		return false;
	}
	for (int c = 0; c < 4; ++c)
	{
		StoreRaw(Out + c * N, c < FFormat::Channels ? C[c] : Broadcast<float, N>(c == 3 ? 1.0f : 0.0f));
	}
	return true;
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
