// Samples of a tile whose places are separable: rows are decoded and mixed once, columns know how their texels lie. The
// sampler's operations in its order, so its bits. Included by lanes code of native kernels only.
#pragma once

#include "Native/SampledTexture.h"
#include "Native/TapSumRows.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** Coordinate to place in 1/256 texels, as the sampler snaps it. */
template<int N>
DRYDOCK_LANES_INLINE TRaw<int32_t, N> PlaceOf(TReal<float, N> Coordinate, int32_t Size)
{
	return TLaneOps<N>::FloorToInt((Coordinate * TReal<float, N>(float(Size) * 256.0f) + TReal<float, N>(0.5f)).V);
}

/** No lane is NaN or farther away than integers reach. */
template<int N>
DRYDOCK_LANES_INLINE bool AreWithinReach(TRaw<int32_t, N> Places)
{
	constexpr int32_t Far = 1 << 29;
	return !AnyLane(TMask<N>((Places > Far) | (Places < -Far)));
}

/** Positions of Pixels on an axis. */
template<int N>
DRYDOCK_LANES_INLINE TReal<float, N> PositionOf(const FViewportAxis& Axis, TInt<N> Pixels)
{
	using FLanes = TReal<float, N>;
	return (ToReal<float>(Pixels) + FLanes(0.5f) - FLanes(Axis.Origin)) * FLanes(Axis.Inverse);
}

template<int N>
DRYDOCK_LANES_INLINE TReal<float, N> CoordinateOf(const FSampledAxis& Axis, TReal<float, N> Position)
{
	using FLanes = TReal<float, N>;
	return Clamp(Position * FLanes(Axis.Size) + FLanes(Axis.First), FLanes(Axis.Min), FLanes(Axis.Max));
}

/** Texels that places read, half-open. */
struct FTexelRange
{
	int32_t Begin = 1 << 30;
	int32_t End = -(1 << 30);
};

/** Places of Count pixels from First on, in whole packs, and what they read; Map gives the coordinate at a position.
 *  False where one is out of reach. */
template<int N, typename F>
inline bool FindSampledPlaces(const FViewportAxis& Axis, int32_t First, int32_t Count, int32_t Size, int32_t* Out,
	FTexelRange& Range, const F& Map)
{
	bool bFine = true;
	for (int32_t i = 0; i < Count; i += N)
	{
		const TRaw<int32_t, N> Places = PlaceOf<N>(Map(PositionOf<N>(Axis, TInt<N>(First + i) + LaneIndex<N>())), Size);
		bFine = bFine && AreWithinReach<N>(Places);
		StoreRaw(Out + i, Places);
	}
	for (int32_t i = 0; i < Count; ++i)
	{
		const int32_t Below = TexelBelow(Out[i]);
		Range.Begin = Below < Range.Begin ? Below : Range.Begin;
		Range.End = Below + 2 > Range.End ? Below + 2 : Range.End;
	}
	// Past the last pixel lanes stay in step: they read the margin, and nobody looks at them.
	for (int32_t i = Count; i < RoundUpTo(Count, N); ++i)
	{
		Out[i] = Out[i - 1] + 256;
	}
	return bFine;
}

/** How the texels of a pack's lanes lie in their row. */
enum class EPackTexels : uint8_t
{
	Whole,       // texel by texel, nothing to mix
	Consecutive, // texel by texel
	Window,      // all within as many texels as there are lanes
	Scattered,
};

/** The places of a tile's columns along the rows of a texture. */
template<int N>
struct TSampleColumns
{
	int32_t* Below = nullptr; // from the rows' first column on; at first the places
	float* Weights = nullptr;
	EPackTexels* Packs = nullptr;

	static size_t GetBytes(int32_t Width) { return size_t(RoundUpTo(Width, 64)) * 9; }

	explicit TSampleColumns(uint8_t* Memory = nullptr, int32_t Width = 0)
		: Below(reinterpret_cast<int32_t*>(Memory))
		, Weights(reinterpret_cast<float*>(Memory + size_t(RoundUpTo(Width, 64)) * 4))
		, Packs(reinterpret_cast<EPackTexels*>(Memory + size_t(RoundUpTo(Width, 64)) * 8))
	{
	}

	void Finish(int32_t Width, int32_t FirstColumn)
	{
		using FInt = TRaw<int32_t, N>;
		using FFloat = TRaw<float, N>;
		for (int32_t X = 0; X < Width; X += N)
		{
			const FInt Fixed = LoadRaw<FInt>(Below + X) - 128;
			const FInt Columns = (Fixed >> 8) - FirstColumn;
			const FInt Fractions = Fixed & 255;
			StoreRaw(Below + X, Columns);
			StoreRaw(Weights + X, __builtin_convertvector(Fractions, FFloat) * Broadcast<float, N>(1.0f / 256));
			const FInt Steps = Columns - Columns[0];
			const bool bInStep = !AnyLane(TMask<N>(Steps != LaneIndex<N>().V));
			const bool bNear = TLaneOps<N>::bHasPermute && !AnyLane(TMask<N>((Steps < 0) | (Steps > N - 2)));
			Packs[X / N] = !bInStep                            ? (bNear ? EPackTexels::Window : EPackTexels::Scattered)
						   : AnyLane(TMask<N>(Fractions != 0)) ? EPackTexels::Consecutive
															   : EPackTexels::Whole;
		}
	}

	/** The pack at column X of one channel's row. bCareful: as MixCarefully. */
	template<bool bCareful>
	DRYDOCK_LANES_INLINE TReal<float, N> Sample(const float* Row, int32_t X) const
	{
		using FInt = TRaw<int32_t, N>;
		using FFloat = TRaw<float, N>;
		using FOps = TLaneOps<N>;
		const int32_t First = Below[X];
		FFloat A;
		FFloat B;
		switch (Packs[X / N])
		{
		case EPackTexels::Whole:
			return TReal<float, N>(LoadRaw<FFloat>(Row + First));
		case EPackTexels::Consecutive:
			A = LoadRaw<FFloat>(Row + First);
			B = LoadRaw<FFloat>(Row + First + 1);
			break;
		case EPackTexels::Window:
		{
			const FFloat Texels = LoadRaw<FFloat>(Row + First);
			const FInt Lanes = LoadRaw<FInt>(Below + X) - First;
			A = FOps::Permute(Texels, Lanes);
			B = FOps::Permute(Texels, Lanes + 1);
			break;
		}
		default:
		{
			const auto* const Base = reinterpret_cast<const uint8_t*>(Row);
			const FInt Offsets = LoadRaw<FInt>(Below + X) * 4;
			A = FFloat(FOps::Gather(Base, Offsets));
			B = FFloat(FOps::Gather(Base, Offsets + 4));
			break;
		}
		}
		const FFloat Weight = LoadRaw<FFloat>(Weights + X);
		const FFloat Mixed = bCareful ? MixCarefully<N>(A, B, Weight) : A + Weight * (B - A);
		return TReal<float, N>(Weight == 0.0f ? A : Mixed);
	}
};

/** One channel of the row at a place; Mixed takes it where it is one of two rows. */
template<int N>
inline const float* MixRows(TTexelRows<N>& Rows, int32_t Place, int32_t Channel, float* Mixed)
{
	using FFloat = TRaw<float, N>;
	const float* const A = Rows.Get(TexelBelow(Place)) + Channel * Rows.Stride;
	const float Weight = WeightOfNext(Place);
	if (Weight == 0)
	{
		return A;
	}
	const float* const B = Rows.Get(TexelBelow(Place) + 1) + Channel * Rows.Stride;
	const FFloat Weights = Broadcast<float, N>(Weight);
	for (int32_t X = 0; X < Rows.NumColumns; X += N)
	{
		StoreRaw(Mixed + X, MixCarefully<N>(LoadRaw<FFloat>(A + X), LoadRaw<FFloat>(B + X), Weights));
	}
	return Mixed;
}

/** Rows of a texture as its sampler addresses them, for the texels of two ranges; LiveRows: that a row of pixels reads,
 *  the ones between included. */
template<int N>
inline TTexelRows<N> OpenRows(const FSampledTexture& Sampled, const FTexelRange& X, const FTexelRange& Y,
	int32_t LiveRows, int32_t Channels, int32_t Number)
{
	FTapSource Source;
	Source.Texture = Sampled.Texture;
	Source.Sampler = Sampled.Sampler;
	Source.RectMax[0] = Sampled.Texture->Mips[0].SizeX;
	Source.RectMax[1] = Sampled.Texture->Mips[0].SizeY;
	const FSourcePlan Plan = {&Source, nullptr, 256, Y.Begin, Y.End - Y.Begin, LiveRows};
	return TTexelRows<N>(Plan, Channels, X.Begin, X.End - X.Begin, Number);
}

/** A texture sampled over a tile, with one place to a column and one to a row. */
template<int N>
struct TSampledTile
{
	TSampleColumns<N> Columns;
	int32_t* RowPlaces = nullptr;
	TTexelRows<N> Rows;

	static size_t GetBytes(int32_t Width, int32_t Height)
	{
		return TSampleColumns<N>::GetBytes(Width) + size_t(RoundUpTo(Height, 64)) * 4;
	}

	/** Memory: of GetBytes. Number: of the rows. False where the shader has to do it. */
	bool Open(const FSampledTexture& Sampled, const FViewportAxis Viewport[2], const FKernelTile& Tile,
		int32_t Channels, int32_t Number, uint8_t* Memory)
	{
		using FLanes = TReal<float, N>;
		const int32_t Width = Tile.MaxX - Tile.MinX;
		const int32_t Height = Tile.MaxY - Tile.MinY;
		const FKernelMip& Mip = Sampled.Texture->Mips[0];
		Columns = TSampleColumns<N>(Memory, Width);
		RowPlaces = reinterpret_cast<int32_t*>(Memory + TSampleColumns<N>::GetBytes(Width));
		const auto Across = [&](FLanes Position)
		{
			return CoordinateOf<N>(Sampled.Axes[0], Position);
		};
		const auto Down = [&](FLanes Position)
		{
			return CoordinateOf<N>(Sampled.Axes[1], Position);
		};
		FTexelRange X;
		FTexelRange Y;
		if (!FindSampledPlaces<N>(Viewport[0], Tile.MinX, Width, Mip.SizeX, Columns.Below, X, Across) ||
			!FindSampledPlaces<N>(Viewport[1], Tile.MinY, Height, Mip.SizeY, RowPlaces, Y, Down))
		{
			return false;
		}
		Columns.Finish(Width, X.Begin);
		constexpr int32_t LiveRows = 2; // bilinear
		Rows = OpenRows<N>(Sampled, X, Y, LiveRows, Channels, Number);
		return true;
	}

	/** The channels of a row of the tile; Mixed takes as many rows of Rows.Stride. */
	void MixRow(int32_t Row, float* Mixed, const float* Out[])
	{
		for (int32_t c = 0; c < Rows.Channels; ++c)
		{
			Out[c] = MixRows<N>(Rows, RowPlaces[Row], c, Mixed + c * Rows.Stride);
		}
	}
};

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
