// Samples of one mip by the tuned paths, and taps: what a kernel remembers of a sample or load over a tile, so that
// other packs of the same rows and columns read their texels without asking again where they lie. The functions that a
// tap calls do what the path did that it was learned from. Included by the LanesSampling_*.cpp only.
#pragma once

#include "LanesSamplingRows.inl"
#include "LanesTaps.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** A tap that is to learn, at the pack of pixels (X0.., Y); null: none. */
struct FTapPlace
{
	FKernelTap* Tap = nullptr;
	int32_t X0 = 0;
	int32_t Y = 0;
};

/** Positions of the lanes' samples along y, in 1/256 texels. */
template<int N>
struct TSnappedRow
{
	using FInt = TRaw<int32_t, N>;

	/** A power of two may join either factor of a product without changing its bits. */
	DRYDOCK_LANES_INLINE TSnappedRow(const float* V, const FKernelMip& Mip, bool bPoint)
		: Snapped(TLaneOps<N>::FloorToInt(LoadRaw<TRaw<float, N>>(V) * (float(Mip.SizeY) * 256.0f) + 0.5f))
	{
		constexpr int32_t Far = GFarTexel * 256;
		const int32_t Fixed = int32_t(uint32_t(Snapped[0]) - (bPoint ? 0u : 128u)); // wraps where it does not fit
		bOne =
			TLaneOps<N>::Equal(Snapped, Broadcast<int32_t, N>(Snapped[0])) && Snapped[0] >= -Far && Snapped[0] <= Far;
		First = Fixed >> 8;
		Weight = bPoint ? 0.0f : float(Fixed & 255) * (1.0f / 256);
	}

	FInt Snapped;
	bool bOne; // all lanes are on one pair of rows, the first of which is First
	int32_t First;
	float Weight; // of the second row
};

template<int N>
DRYDOCK_LANES_INLINE void SetRow(
	FKernelTap& Tap, ETexelStorage Storage, int32_t BytesPerTexel, int32_t Y, const FRowPair& Rows)
{
	const bool bWhole = Tap.Stride == BytesPerTexel && Tap.WeightX == 0 && !Rows.Row1;
	Tap.Kind = bWhole && Storage == ETexelStorage::RGBA32_FLOAT            ? EWholeTexels::Float
			   : bWhole && N > 4 && Storage == ETexelStorage::RGBA16_FLOAT ? EWholeTexels::Half
																		   : EWholeTexels::None;
	Tap.Row = Y;
	Tap.Row0 = Rows.Row0;
	Tap.Row1 = Rows.Row1;
	Tap.WeightY = Rows.Weight;
}

/** The pack's first texel is Offset bytes into Rows, those of the next pixels lie Step halves of a texel apart. A pack
 * that does not fit the columns known to the tap is not learned. */
template<int N, typename FFormat, int Step>
DRYDOCK_LANES_INLINE void LearnPack(const FTapPlace& Place, bool (*Function)(const FKernelTap&, int32_t, float*),
	int64_t Offset, float WeightX, const FRowPair& Rows)
{
	FKernelTap& Tap = *Place.Tap;
	static_assert(Step * FFormat::Bytes % 2 == 0);
	constexpr int32_t Stride = Step * FFormat::Bytes / 2;
	const int64_t Column = Offset - int64_t(Place.X0) * Stride;
	if (Tap.Length == 0)
	{
		Tap.Begin = Place.X0;
		Tap.Length = N;
		Tap.WeightX = WeightX;
		Tap.Column = Column;
		Tap.Function = Function;
		Tap.Stride = Stride;
	}
	else if (Tap.Function != Function || Tap.Column != Column || Tap.WeightX != WeightX)
	{
		return;
	}
	else if (int64_t(Place.X0) == int64_t(Tap.Begin) + Tap.Length)
	{
		Tap.Length += N;
	}
	else if (uint32_t(Place.X0) - uint32_t(Tap.Begin) >= Tap.Length)
	{
		return;
	}
	SetRow<N>(Tap, FFormat::Storage, FFormat::Bytes, Place.Y, Rows);
}

/** Step: halves of a texel from pixel to pixel, 1, 2 or 4. */
template<int N, typename FFormat, int Step>
bool SampleKnown(const FKernelTap& Tap, int32_t X, float* Out)
{
	const int64_t Offset = Tap.Column + int64_t(X) * Tap.Stride;
	const uint8_t* const Row0 = Tap.Row0 + Offset;
	const uint8_t* const Row1 = Tap.Row1 ? Tap.Row1 + Offset : nullptr;
	TRaw<float, N> C[4];
	if constexpr (Step == 1)
	{
		SampleHalfSteps<N>(FFormat{}, Row0, Row1, Tap.WeightX, Tap.WeightY, C);
	}
	else if constexpr (Step == 2)
	{
		SampleConsecutive<N>(FFormat{}, Row0, Row1, Tap.WeightX, Tap.WeightY, C);
	}
	else
	{
		SampleEveryOther<N>(FFormat{}, Row0, Row1, Tap.WeightX, Tap.WeightY, C);
	}
	return Finish<FFormat, N>(C, Out);
}

template<int N, typename FFormat>
bool LoadKnown(const FKernelTap& Tap, int32_t X, float* Out)
{
	TRaw<float, N> C[4];
	LoadTexelsOf<FFormat, float, N>(Tap.Row0 + Tap.Column + int64_t(X) * FFormat::Bytes, C);
	StoreRaw(Out, C);
	return true;
}

template<int N, typename FFormat, int Step>
DRYDOCK_LANES_INLINE void Learn(const FTapPlace& Place, int64_t Offset, float WeightX, const FRowPair& Rows)
{
	if constexpr (!std::is_same_v<FFormat, FAnyFormat>)
	{
		if (Place.Tap)
		{
			LearnPack<N, FFormat, Step>(Place, &SampleKnown<N, FFormat, Step>, Offset, WeightX, Rows);
		}
	}
}

/** Learns the rows of a sample whose columns are known at the pack already. False if the rows are not one pair. */
template<int N>
DRYDOCK_LANES_INLINE bool LearnRow(const FKernelTexture& Texture, const FKernelMip& Mip, const FKernelSampler& Sampler,
	const float* V, const FTapPlace& Place)
{
	FKernelTap& Tap = *Place.Tap;
	if (uint32_t(Place.X0) - uint32_t(Tap.Begin) >= Tap.Length || Sampler.SampleBits != 8)
	{
		return false;
	}
	const TSnappedRow<N> Row(V, Mip, Sampler.Filter == EKernelFilter::Point);
	FRowPair Rows;
	if (!Row.bOne || !FindRows(Mip, Mip.Data, Sampler.AddressV, Row.First, Row.Weight, Rows))
	{
		return false;
	}
	SetRow<N>(Tap, Texture.Storage, GetTexelStorageInfo(Texture.Storage).BytesPerTexel, Place.Y, Rows);
	return true;
}

/** A row of texels from First on, as loads read it. */
template<int N>
DRYDOCK_LANES_INLINE void LearnLoad(
	const FTapPlace& Place, ETexelStorage Storage, const FKernelMip& Mip, int32_t X, int32_t Y, int32_t Slice)
{
	VisitPictureFormat(Storage,
		[&](auto Format)
		{
			const FRowPair Rows = {TexelAddress(Mip, Format.Bytes, 0, Y, Slice), nullptr, 0.0f};
			LearnPack<N, decltype(Format), 2>(
				Place, &LoadKnown<N, decltype(Format)>, int64_t(X) * Format.Bytes, 0.0f, Rows);
			return true;
		});
}

/** One mip of one slice (Base). Fills Out; false when a result is NaN, which the reference decides. */
template<int N, typename FFormat>
inline bool SampleMip2DTuned(FFormat Format, const FKernelTexture& Texture, const FKernelMip& Mip, const uint8_t* Base,
	const FKernelSampler& Sampler, const float* U, const float* V, float* Out, const FTapPlace& Place)
{
	using FInt = TRaw<int32_t, N>;
	using FFloat = TRaw<float, N>;
	using FOps = TLaneOps<N>;
	const bool bPoint = Sampler.Filter == EKernelFilter::Point;
	if (Sampler.SampleBits != 8)
	{
		const TAxis<float, N> X = MakeAxis<float, N>(U, Mip.SizeX, bPoint, Sampler.SampleBits);
		const TAxis<float, N> Y = MakeAxis<float, N>(V, Mip.SizeY, bPoint, Sampler.SampleBits);
		return SampleFootprints<N>(Format, Texture, Mip, Base, Sampler, X, Y, Out);
	}

	// In 1/256 texels.
	constexpr int32_t Unfit = int32_t(0x80000000);
	constexpr int32_t Far = GFarTexel * 256;
	const FInt SnappedX = FOps::FloorToInt(LoadRaw<FFloat>(U) * (float(Mip.SizeX) * 256.0f) + 0.5f);
	const TSnappedRow<N> Row(V, Mip, bPoint);
	const FInt SnappedY = Row.Snapped;
	const int32_t FixedX = int32_t(
		uint32_t(SnappedX[0]) - (bPoint ? 0u : 128u)); // wraps where it does not fit: then Start is out of range
	const int32_t Start = FixedX >> 8;
	FRowPair Rows;
	if (Row.bOne && uint32_t(Start) < uint32_t(Mip.SizeX) &&
		FindRows(Mip, Base, Sampler.AddressV, Row.First, Row.Weight, Rows))
	{
		const float WeightX = bPoint ? 0.0f : float(FixedX & 255) * (1.0f / 256);
		const int64_t Offset = int64_t(Start) * Format.Bytes;
		const uint8_t* Row0 = Rows.Row0 + Offset;
		const uint8_t* Row1 = Rows.Row1 ? Rows.Row1 + Offset : nullptr;
		const FInt Steps = (TInt<N>(SnappedX) - TInt<N>(SnappedX[0])).V;
		const FInt Iota = LaneIndex<N>().V;
		FFloat C[4];
		if (Start + N + (WeightX != 0) <= Mip.SizeX && FOps::Equal(Steps, Iota * 256))
		{
			Learn<N, FFormat, 2>(Place, Offset, WeightX, Rows);
			SampleConsecutive<N>(Format, Row0, Row1, WeightX, Rows.Weight, C);
			return Finish<FFormat, N>(C, Out);
		}
		if constexpr (FOps::bHasPermute || FFormat::bWide)
		{
			if (Start + 2 * N <= Mip.SizeX && FOps::Equal(Steps, Iota * 512))
			{
				Learn<N, FFormat, 4>(Place, Offset, WeightX, Rows);
				SampleEveryOther<N>(Format, Row0, Row1, WeightX, Rows.Weight, C);
				return Finish<FFormat, N>(C, Out);
			}
		}
		if constexpr (HasHalfSteps<N, FFormat>)
		{
			if (!bPoint && Start + TexelsOfHalfSteps<N> <= Mip.SizeX && FOps::Equal(Steps, Iota * 128))
			{
				Learn<N, FFormat, 1>(Place, Offset, WeightX, Rows);
				SampleHalfSteps<N>(Format, Row0, Row1, WeightX, Rows.Weight, C);
				return Finish<FFormat, N>(C, Out);
			}
		}
	}

	const FInt Limit = Broadcast<int32_t, N>(Far);
	if (MaskBits(TMask<N>((SnappedX == Unfit) | (SnappedY == Unfit))) != 0)
	{
		// NaN, or beyond what an integer holds: once more, with care.
		const TAxis<float, N> X = MakeAxis<float, N>(U, Mip.SizeX, bPoint, 8);
		const TAxis<float, N> Y = MakeAxis<float, N>(V, Mip.SizeY, bPoint, 8);
		return SampleFootprints<N>(Format, Texture, Mip, Base, Sampler, X, Y, Out);
	}
	const auto Bound = [Limit](FInt S)
	{
		return Max(Min(TInt<N>(S), TInt<N>(Limit)), TInt<N>(-Limit));
	};
	return SampleFootprints<N>(Format, Texture, Mip, Base, Sampler, MakeAxisFixed<float, N>(Bound(SnappedX), bPoint),
		MakeAxisFixed<float, N>(Bound(SnappedY), bPoint), Out);
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
