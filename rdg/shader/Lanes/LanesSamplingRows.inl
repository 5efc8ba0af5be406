// The tuned sampling paths for float lanes. Lanes are neighbours along x, so most samples of a full-screen pass fall on
// one row pair with one vertical weight:
//   consecutive   texel x0 + lane, one horizontal weight (blurs, aligned copies): whole-row loads
//   every other   texel x0 + 2 lane, one horizontal weight (2:1 reductions)
//   half steps    texel x0 + lane / 2, two horizontal weights that take turns (2:1 magnification)
//   window        any texels within N or 2 N neighbours (magnification, clamped edges): whole-row
//                 loads, then a permutation picks each lane's pair
//   general       anything else: one footprint per lane (LanesSamplingGeneral.inl)
// All do the operations of LanesSamplingReference.inl in the same order, hence give the same bits. A result that is NaN
// is left to that code. Included by the LanesSampling_*.cpp only.
#pragma once

#include "LanesSamplingGeneral.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** N neighbouring texels of one row, or of two blended (Row1 not null), as channels. */
template<int N, typename FFormat>
DRYDOCK_LANES_INLINE void LoadColumn(
	FFormat Format, const uint8_t* Row0, const uint8_t* Row1, float Weight, TRaw<float, N> C[4])
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
		ReadNeighbours<N>(Format, Row0, C);
		if (Row1)
		{
			TRaw<float, N> D[4];
			ReadNeighbours<N>(Format, Row1, D);
			for (int c = 0; c < FFormat::Channels; ++c)
			{
				C[c] = Blend(C[c], D[c], Weight);
			}
		}
	}
}

/** Lane i samples texels Row + i and Row + i + 1. */
template<int N, typename FFormat>
DRYDOCK_LANES_INLINE void SampleConsecutive(
	FFormat Format, const uint8_t* Row0, const uint8_t* Row1, float WeightX, float WeightY, TRaw<float, N> C[4])
{
	if (WeightX == 0)
	{
		LoadColumn<N>(Format, Row0, Row1, WeightY, C);
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
				const TRaw<float, N> Right = Blend(FFormat::template Load<N>(P + FFormat::Bytes),
					FFormat::template Load<N>(Q + FFormat::Bytes), WeightY);
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
		LoadColumn<N>(Format, Row0, Row1, WeightY, C);
		LoadColumn<N>(Format, Row0 + Format.Bytes, Row1 ? Row1 + Format.Bytes : nullptr, WeightY, Right);
		for (int c = 0; c < FFormat::Channels; ++c)
		{
			C[c] = Blend(C[c], Right[c], WeightX);
		}
	}
}

/** Lane i samples texels Row + 2 i and Row + 2 i + 1; 2 N texels are read. */
template<int N, typename FFormat>
DRYDOCK_LANES_INLINE void SampleEveryOther(
	FFormat Format, const uint8_t* Row0, const uint8_t* Row1, float WeightX, float WeightY, TRaw<float, N> C[4])
{
	using FOps = TLaneOps<N>;
	if constexpr (FFormat::bWide)
	{
		constexpr int Step = N / 4 * FFormat::Bytes;
		TRaw<float, N> A[4];
		for (int k = 0; k < 4; ++k)
		{
			const uint8_t* P = Row0 + 2 * k * Step;
			TRaw<float, N> First = FFormat::template Load<N>(P);
			TRaw<float, N> Second = FFormat::template Load<N>(P + Step);
			if (Row1)
			{
				const uint8_t* Q = Row1 + 2 * k * Step;
				First = Blend(First, FFormat::template Load<N>(Q), WeightY);
				Second = Blend(Second, FFormat::template Load<N>(Q + Step), WeightY);
			}
			A[k] = FOps::EvenTexels(First, Second);
			if (WeightX != 0)
			{
				A[k] = Blend(A[k], FOps::OddTexels(First, Second), WeightX);
			}
		}
		FOps::Split(A, C);
	}
	else
	{
		const int Second = N * Format.Bytes;
		const TRaw<int32_t, N> Even = LaneIndex<N>().V * 2;
		TRaw<float, N> Low[4];
		TRaw<float, N> High[4];
		LoadColumn<N>(Format, Row0, Row1, WeightY, Low);
		LoadColumn<N>(Format, Row0 + Second, Row1 ? Row1 + Second : nullptr, WeightY, High);
		for (int c = 0; c < FFormat::Channels; ++c)
		{
			C[c] = FOps::Permute2(Low[c], High[c], Even);
			if (WeightX != 0)
			{
				C[c] = Blend(C[c], FOps::Permute2(Low[c], High[c], Even + 1), WeightX);
			}
		}
	}
}

/** Whether there is code for half steps: a vector holds four texels, or two. */
template<int N, typename FFormat>
inline constexpr bool HasHalfSteps = FFormat::bWide && (N == 16 || N == 8);

/** How many texels SampleHalfSteps reads of each row. */
template<int N>
inline constexpr int TexelsOfHalfSteps = N == 16 ? 10 : 7;

/** Lane i samples at Row + WeightX + i / 2, 0 <= WeightX < 1. */
template<int N, typename FFormat>
DRYDOCK_LANES_INLINE void SampleHalfSteps(
	FFormat, const uint8_t* Row0, const uint8_t* Row1, float WeightX, float WeightY, TRaw<float, N> C[4])
{
	using FOps = TLaneOps<N>;
	const TRaw<int32_t, N> Iota = LaneIndex<N>().V;
	const TRaw<int32_t, N> Pixel = Iota >> 2; // in a vector
	const bool bSecondIsNext = WeightX >= 0.5f;
	const float Odd = bSecondIsNext ? WeightX - 0.5f : WeightX + 0.5f;
	const TRaw<float, N> Weight = (Pixel & 1) != 0 ? Broadcast<float, N>(Odd) : Broadcast<float, N>(WeightX);
	const TRaw<int32_t, N> Left = ((Pixel + int32_t(bSecondIsNext)) >> 1) * 4 + (Iota & 3);
	const auto Read = [&](int Texel)
	{
		const TRaw<float, N> Upper = FFormat::template Load<N>(Row0 + Texel * FFormat::Bytes);
		return Row1 ? Blend(Upper, FFormat::template Load<N>(Row1 + Texel * FFormat::Bytes), WeightY) : Upper;
	};
	TRaw<float, N> A[4];
	for (int k = 0; k < 4; ++k)
	{
		const TRaw<float, N> Texels = Read(k * (N / 8));
		TRaw<float, N> L = FOps::Permute(Texels, Left);
		TRaw<float, N> R;
		if constexpr (N == 16)
		{
			R = FOps::Permute(Texels, Left + 4);
		}
		else
		{
			R = FOps::Permute2(Texels, Read(k * (N / 8) + 2), Left + 4);
		}
		A[k] = Weight == 0.0f ? L : Blend(L, R, Weight);
	}
	FOps::Split(A, C);
}

/** Lane i samples texels Left[i] and Right[i] of a window of N (bTwo: 2 N) texels that starts at Row. */
template<int N, bool bTwo, typename FFormat>
DRYDOCK_LANES_INLINE void SampleWindow(FFormat Format, const uint8_t* Row0, const uint8_t* Row1, TRaw<int32_t, N> Left,
	TRaw<int32_t, N> Right, TRaw<float, N> WeightX, float WeightY, TRaw<float, N> C[4])
{
	using FOps = TLaneOps<N>;
	const int Second = N * Format.Bytes;
	TRaw<float, N> Low[4];
	TRaw<float, N> High[4];
	LoadColumn<N>(Format, Row0, Row1, WeightY, Low);
	if constexpr (bTwo)
	{
		LoadColumn<N>(Format, Row0 + Second, Row1 ? Row1 + Second : nullptr, WeightY, High);
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

/** Two rows and the weight of the second; Row1 is null when that is 0. */
struct FRowPair
{
	const uint8_t* Row0;
	const uint8_t* Row1;
	float Weight;
};

/** False when a row is on the border. */
DRYDOCK_LANES_INLINE bool FindRows(
	const FKernelMip& Mip, const uint8_t* Base, EKernelAddress Mode, int32_t First, float Weight, FRowPair& Out)
{
	const int32_t Top = AddressTexel(First, Mip.SizeY, Mode);
	const int32_t Bottom = Weight == 0 ? Top : AddressTexel(First + 1, Mip.SizeY, Mode);
	Out = {Base + int64_t(Top) * Mip.RowPitch, Weight == 0 ? nullptr : Base + int64_t(Bottom) * Mip.RowPitch, Weight};
	return (Top | Bottom) >= 0;
}

/** Lanes on one row pair inside the texture, some of their columns the border's colour: the window of the nearest
 * columns, and a choice. False for other lanes. */
template<int N>
inline bool SampleBorderedWindow(FAnyFormat Format, const FKernelMip& Mip, const uint8_t* Base,
	const FKernelSampler& Sampler, const TAxis<float, N>& X, const TAxis<float, N>& Y, TRaw<float, N> C[4])
{
	using FOps = TLaneOps<N>;
	using FInt = TRaw<int32_t, N>;
	using FFloat = TRaw<float, N>;
	FRowPair Rows;
	if (Sampler.AddressU != EKernelAddress::Border || Mip.SizeX < 2 * N ||
		!FOps::Equal(Y.First.V, Broadcast<int32_t, N>(Y.First.V[0])) || !AllEqual<N>(Y.Weight.V, Y.Weight.V[0]) ||
		!FindRows(Mip, Base, Sampler.AddressV, Y.First.V[0], Y.Weight.V[0], Rows))
	{
		return false;
	}
	const FInt Left = AddressTexels(X.First, Mip.SizeX, EKernelAddress::Clamp).V;
	const FInt Right = AddressTexels(X.First + TInt<N>(1), Mip.SizeX, EKernelAddress::Clamp).V;
	const int32_t Lowest = Left[0] < Left[N - 1] ? Left[0] : Left[N - 1];
	const int32_t Start = Lowest < Mip.SizeX - 2 * N ? Lowest : Mip.SizeX - 2 * N;
	if (!FOps::NoBits((Left - Start) | (Right - Start), -2 * N))
	{
		return false;
	}
	const int64_t Offset = int64_t(Start) * Format.Bytes;
	const int64_t Second = int64_t(N) * Format.Bytes;
	const uint8_t* const Row0 = Rows.Row0 + Offset;
	const uint8_t* const Row1 = Rows.Row1 ? Rows.Row1 + Offset : nullptr;
	FFloat Low[4];
	FFloat High[4];
	LoadColumn<N>(Format, Row0, Row1, Rows.Weight, Low);
	LoadColumn<N>(Format, Row0 + Second, Row1 ? Row1 + Second : nullptr, Rows.Weight, High);
	const FInt bLeftInside = FInt(TRaw<uint32_t, N>(X.First.V) < uint32_t(Mip.SizeX));
	const FInt bRightInside = FInt(TRaw<uint32_t, N>(X.First.V + 1) < uint32_t(Mip.SizeX));
	for (int c = 0; c < 4; ++c)
	{
		// Filtered as any other column is: that makes 0 of -0, and NaN of infinity.
		const float Colour = Sampler.Border[c];
		const FFloat Border = Broadcast<float, N>(Row1 ? Blend(Colour, Colour, Rows.Weight) : Colour);
		const FFloat L = bLeftInside != 0 ? FOps::Permute2(Low[c], High[c], Left - Start) : Border;
		const FFloat R = bRightInside != 0 ? FOps::Permute2(Low[c], High[c], Right - Start) : Border;
		C[c] = X.Weight.V == 0.0f ? L : Blend(L, R, X.Weight.V);
	}
	return true;
}

/** Some texels are the border's colour. False when a result is NaN, or the slice at Base too large for gathers. */
template<int N>
__attribute__((noinline)) bool SampleBordered(const FKernelTexture& Texture, const FKernelMip& Mip, const uint8_t* Base,
	const FKernelSampler& Sampler, const TAxis<float, N>& X, const TAxis<float, N>& Y, float* Out)
{
	TRaw<float, N> C[4];
	if constexpr (TLaneOps<N>::bHasPermute)
	{
		const FAnyFormat Format = {Texture.Storage, GetTexelStorageInfo(Texture.Storage).BytesPerTexel};
		if (SampleBorderedWindow<N>(Format, Mip, Base, Sampler, X, Y, C))
		{
			return FinishTaps<N>(C, Out);
		}
	}
	FKernelMip Slice = Mip;
	Slice.Data = const_cast<uint8_t*>(Base);
	Slice.SizeZ = 1;
	const TTapReader<N> Reader = {Texture, Sampler, Slice};
	if (!Reader.CanRead())
	{
		return false;
	}
	Reader.Filter2D(
		TTaps<N>(X, Mip.SizeX, Sampler.AddressU), TTaps<N>(Y, Mip.SizeY, Sampler.AddressV), TRaw<int32_t, N>{}, C);
	return FinishTaps<N>(C, Out);
}

/** The window and general paths. */
template<int N, typename FFormat>
inline bool SampleFootprints(FFormat Format, const FKernelTexture& Texture, const FKernelMip& Mip, const uint8_t* Base,
	const FKernelSampler& Sampler, const TAxis<float, N>& X, const TAxis<float, N>& Y, float* Out)
{
	using FOps = TLaneOps<N>;
	TRaw<float, N> C[4];
	TFootprints<N> F;
	F.Left = AddressTexels(X.First, Mip.SizeX, Sampler.AddressU).V;
	F.Right = AddressTexels(X.First + TInt<N>(1), Mip.SizeX, Sampler.AddressU).V;
	F.WeightX = X.Weight.V;
	// A tap of weight 0 is not read: it must not send the sample to the border's path either.
	F.Right = F.WeightX == 0.0f ? F.Left : F.Right;
	if (!FOps::NoBits(F.Left | F.Right, int32_t(0x80000000)))
	{
		return SampleBordered<N>(Texture, Mip, Base, Sampler, X, Y, Out);
	}
	if constexpr (FOps::bHasPermute)
	{
		const bool bOneRow =
			FOps::Equal(Y.First.V, Broadcast<int32_t, N>(Y.First.V[0])) && AllEqual<N>(Y.Weight.V, Y.Weight.V[0]);
		FRowPair Rows;
		if (bOneRow && Mip.SizeX >= N && FindRows(Mip, Base, Sampler.AddressV, Y.First.V[0], Y.Weight.V[0], Rows))
		{
			// Lanes rise along x or fall: the window begins at the lower end and stays inside the row.
			const int32_t Lowest = F.Left[0] < F.Left[N - 1] ? F.Left[0] : F.Left[N - 1];
			const int32_t StartOne = Lowest < Mip.SizeX - N ? Lowest : Mip.SizeX - N;
			if (FOps::NoBits((F.Left - StartOne) | (F.Right - StartOne), -N))
			{
				const int64_t Offset = int64_t(StartOne) * Format.Bytes;
				SampleWindow<N, false>(Format, Rows.Row0 + Offset, Rows.Row1 ? Rows.Row1 + Offset : nullptr,
					F.Left - StartOne, F.Right - StartOne, F.WeightX, Rows.Weight, C);
				return Finish<FFormat, N>(C, Out);
			}
			const int32_t StartTwo = Lowest < Mip.SizeX - 2 * N ? Lowest : Mip.SizeX - 2 * N;
			if (StartTwo >= 0 && FOps::NoBits((F.Left - StartTwo) | (F.Right - StartTwo), -2 * N))
			{
				const int64_t Offset = int64_t(StartTwo) * Format.Bytes;
				SampleWindow<N, true>(Format, Rows.Row0 + Offset, Rows.Row1 ? Rows.Row1 + Offset : nullptr,
					F.Left - StartTwo, F.Right - StartTwo, F.WeightX, Rows.Weight, C);
				return Finish<FFormat, N>(C, Out);
			}
		}
	}
	F.Top = AddressTexels(Y.First, Mip.SizeY, Sampler.AddressV).V;
	F.Bottom = AddressTexels(Y.First + TInt<N>(1), Mip.SizeY, Sampler.AddressV).V;
	F.WeightY = Y.Weight.V;
	F.Bottom = F.WeightY == 0.0f ? F.Top : F.Bottom;
	if (!FOps::NoBits(F.Top | F.Bottom, int32_t(0x80000000)))
	{
		return SampleBordered<N>(Texture, Mip, Base, Sampler, X, Y, Out);
	}
	return SampleGeneral<N>(Format, Mip, Base, F, C) && Finish<FFormat, N>(C, Out);
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
