// The tonemapper of a tile, pack by pack: the shader's operations in its order (PostProcessTonemap.usf,
// TonemapLens.ush), on rows that are decoded and mixed once. Included by Tonemap_*.cpp only.
#pragma once

#include "Native/ColorTable.inl"
#include "Native/LocalExposureLanes.inl"
#include "Native/TapSumStores.inl"
#include "Native/TonemapLanes.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

template<int N>
class TTonemapTile
{
	using FLanes = TReal<float, N>;
	using FFloat = TRaw<float, N>;
	using FInt = TRaw<int32_t, N>;

	/** A pixel and those beside it, along one axis. */
	enum ENeighbor
	{
		Center,
		Before,
		After,
		NumNeighbors
	};
	static constexpr int NumSamples = 5; // the pixel, left, right, above, below

public:
	TTonemapTile(const FTonemapJob& InJob, const FKernelTexture& InTarget, const FKernelTile& InTile)
		: Job(InJob)
		, Target(InTarget)
		, Tile(InTile)
		, NumAround(InJob.bSharpen ? NumNeighbors : 1)
		, NumShifts(InJob.bFringe ? 3 : 1)
	{
	}

	/** False where the shader has to do it. */
	bool Open()
	{
		const int32_t Width = Tile.MaxX - Tile.MinX;
		const int32_t Height = Tile.MaxY - Tile.MinY;
		const size_t Bytes = TSampledTile<N>::GetBytes(Width, Height);
		auto* const Memory =
			static_cast<uint8_t*>(GetTapMemory(PlacesMemory, Bytes * size_t(NumAround * NumShifts + 1)));
		if (!OpenColor(Memory + Bytes) || (Job.bBloom && !Bloom.Open(Job.Bloom, Job.Viewport, Tile, 3, 1, Memory)) ||
			(Job.bLocalExposure && !LocalExposure.Open(Job.LocalExposure, Job.Viewport, Tile, 2)))
		{
			return false;
		}
		const size_t ColorFloats = size_t(3 * NumAround) * size_t(Color.Stride);
		const size_t BloomFloats = Job.bBloom ? 3 * size_t(Bloom.Rows.Stride) : 0;
		ColorMixed = static_cast<float*>(GetTapMemory(MixedRowsMemory, (ColorFloats + BloomFloats) * sizeof(float)));
		BloomMixed = ColorMixed + ColorFloats;
		RowPitch = RoundUpTo(Width, N);
		Looked =
			static_cast<float*>(GetTapMemory(ResampledMemory, size_t(2 * NumRows) * size_t(RowPitch) * sizeof(float)));
		SliceWeights = Looked + NumRows * RowPitch;
		LowPlaces = reinterpret_cast<int32_t*>(SliceWeights + RowPitch);
		HighPlaces = LowPlaces + RowPitch;
		RowPlacesOfTable = HighPlaces + RowPitch;
		Table.Open(*Job.Table, Job.Pass, Job.NumPixels);
		return true;
	}

	void Run()
	{
		const int32_t Width = Tile.MaxX - Tile.MinX;
		const FKernelMip& Mip = Target.Mips[0];
		const int32_t Bytes = GetTexelStorageInfo(Target.Storage).BytesPerTexel;
		const FTableScale Scale(Job);
		for (int32_t Y = Tile.MinY; Y < Tile.MaxY; ++Y)
		{
			BeginRow(Y - Tile.MinY);
			uint8_t* const Place = Mip.Data + int64_t(Y) * Mip.RowPitch + int64_t(Tile.MinX) * Bytes;
			// In three sweeps: what waits in one pack for a logarithm or a texel does not keep the next from beginning.
			for (int32_t X = 0; X < Width; X += N)
			{
				FLanes Linear[3];
				GetLinear(X, Y, Linear);
				FindPlaces(Scale, Linear, X);
			}
			for (int32_t X = 0; X < Width; X += N)
			{
				Table.IsCopied() ? LookUp<true>(X) : LookUp<false>(X);
			}
			StoreSums<N>(FTapSum(), Target, NumRows, Width, RowPitch, Looked, Place);
		}
	}

private:
	/** A position as a channel sees it, or the one beside it. */
	FLanes MovePosition(FLanes Position, int Axis, int Neighbor, int Channel) const
	{
		if (Neighbor != Center)
		{
			const FLanes Step(Job.NeighborSteps[Axis]);
			Position = Neighbor == Before ? Position - Step : Position + Step;
		}
		if (Job.bFringe && Channel < 2)
		{
			const FLanes Centered = Position * FLanes(2.0f) - FLanes(1.0f);
			const FLanes Beyond =
				Sign(Centered) * Clamp(Abs(Centered) - FLanes(Job.FringeStart), FLanes(0.0f), FLanes(1.0f));
			Position = Position - Beyond * FLanes(Job.FringeShifts[Channel]);
		}
		return Position;
	}

	bool OpenColor(uint8_t* Memory)
	{
		const int32_t Width = Tile.MaxX - Tile.MinX;
		const int32_t Height = Tile.MaxY - Tile.MinY;
		const FKernelMip& Mip = Job.Color.Texture->Mips[0];
		FTexelRange X;
		FTexelRange Y;
		for (int i = 0; i < NumAround; ++i)
		{
			for (int c = 0; c < NumShifts; ++c, Memory += TSampledTile<N>::GetBytes(Width, Height))
			{
				const auto Across = [&](FLanes Position)
				{
					return CoordinateOf<N>(Job.Color.Axes[0], MovePosition(Position, 0, i, c));
				};
				const auto Down = [&](FLanes Position)
				{
					return CoordinateOf<N>(Job.Color.Axes[1], MovePosition(Position, 1, i, c));
				};
				Columns[i][c] = TSampleColumns<N>(Memory, Width);
				RowPlaces[i][c] = reinterpret_cast<int32_t*>(Memory + TSampleColumns<N>::GetBytes(Width));
				if (!FindSampledPlaces<N>(
						Job.Viewport[0], Tile.MinX, Width, Mip.SizeX, Columns[i][c].Below, X, Across) ||
					!FindSampledPlaces<N>(Job.Viewport[1], Tile.MinY, Height, Mip.SizeY, RowPlaces[i][c], Y, Down))
				{
					return false;
				}
			}
		}
		for (int i = 0; i < NumAround * NumShifts; ++i)
		{
			Columns[i / NumShifts][i % NumShifts].Finish(Width, X.Begin);
		}
		constexpr int32_t MostRows = 4096;
		if (Y.End - Y.Begin > MostRows)
		{
			return false;
		}
		Color = OpenRows<N>(Job.Color, X, Y, CountLiveRows(), 3, 0);
		return true;
	}

	int32_t CountLiveRows() const
	{
		int32_t Live = 0;
		for (int32_t Row = 0; Row < Tile.MaxY - Tile.MinY; ++Row)
		{
			FTexelRange Rows;
			for (int i = 0; i < NumAround * NumShifts; ++i)
			{
				const int32_t Below = TexelBelow(RowPlaces[i / NumShifts][i % NumShifts][Row]);
				Rows.Begin = Below < Rows.Begin ? Below : Rows.Begin;
				Rows.End = Below + 2 > Rows.End ? Below + 2 : Rows.End;
			}
			Live = Rows.End - Rows.Begin > Live ? Rows.End - Rows.Begin : Live;
		}
		return Live;
	}

	void BeginRow(int32_t Row)
	{
		for (int i = 0; i < NumAround; ++i)
		{
			for (int c = 0; c < 3; ++c)
			{
				ColorRows[i][c] = MixRows<N>(
					Color, RowPlaces[i][NumShifts == 1 ? 0 : c][Row], c, ColorMixed + (i * 3 + c) * Color.Stride);
			}
		}
		if (Job.bBloom)
		{
			Bloom.MixRow(Row, BloomMixed, BloomRows);
		}
		if (Job.bLocalExposure)
		{
			LocalExposure.BeginRow(Row);
		}
	}

	/** False when one is NaN. */
	template<bool bCareful>
	DRYDOCK_LANES_INLINE bool SampleColors(int32_t X, FLanes Out[][3]) const
	{
		bool bNan = false;
		for (int Sample = 0; Sample < (NumAround == 1 ? 1 : NumSamples); ++Sample)
		{
			const int Across = Sample == 1 ? Before : Sample == 2 ? After : Center;
			const int Down = Sample == 3 ? Before : Sample == 4 ? After : Center;
			for (int c = 0; c < 3; ++c)
			{
				Out[Sample][c] =
					Columns[Across][NumShifts == 1 ? 0 : c].template Sample<bCareful>(ColorRows[Down][c], X);
			}
			bNan |= TLaneOps<N>::AnyNan(Out[Sample][0].V, Out[Sample][1].V, Out[Sample][2].V, Out[Sample][2].V);
		}
		return !bNan;
	}

	static DRYDOCK_LANES_INLINE FLanes MakePositiveFinite(FLanes X)
	{
		return Clamp(Max(X, FLanes(0.0f)), FLanes(0.0f), FLanes(65504.0f));
	}

	static DRYDOCK_LANES_INLINE FLanes Luminance(const FLanes C[3])
	{
		return C[0] * FLanes(0.3f) + C[1] * FLanes(0.59f) + C[2] * FLanes(0.11f);
	}

	/** C[0] is the pixel, the others are around it. */
	DRYDOCK_LANES_INLINE void Sharpen(FLanes C[][3], FLanes Out[3]) const
	{
		FLanes Luminances[NumSamples];
		for (int Sample = 0; Sample < NumSamples; ++Sample)
		{
			for (int c = 0; c < 3; ++c)
			{
				C[Sample][c] = MakePositiveFinite(C[Sample][c]);
			}
			Luminances[Sample] = Luminance(C[Sample]);
		}
		FLanes Differences[NumSamples];
		for (int Sample = 1; Sample < NumSamples; ++Sample)
		{
			Differences[Sample] = Abs(Luminances[Sample] - Luminances[0]) * FLanes(Job.Exposure);
		}
		const FLanes Edge = Max(Max(Differences[1], Differences[2]), Max(Differences[3], Differences[4]));
		const FLanes Factor =
			-Clamp(FLanes(1.0f) - Edge, FLanes(0.0f), FLanes(1.0f)) * FLanes(Job.SharpenAmount) * FLanes(1.0f / 6.0f);
		for (int c = 0; c < 3; ++c)
		{
			const FLanes Around = C[1][c] + C[2][c] + C[3][c] + C[4][c];
			Out[c] = Max(C[0][c] + (Around - C[0][c] * FLanes(4.0f)) * Factor, FLanes(0.0f));
		}
	}

	FLanes GetVignette(FLanes PositionX, FLanes PositionY) const
	{
		const auto Place = [this](FLanes Position, int Axis)
		{
			return (Position * FLanes(2.0f) - FLanes(1.0f)) * FLanes(Job.VignetteScale[Axis]) *
				   FLanes(Job.VignetteIntensity);
		};
		const FLanes X = Place(PositionX, 0);
		const FLanes Y = Place(PositionY, 1);
		const FLanes Cosine = FLanes(1.0f) / (FLanes(1.0f) + (X * X + Y * Y));
		return Cosine * Cosine;
	}

	FLanes GetFilmGrain(const FLanes Linear[3], TInt<N> PixelX, TInt<N> PixelY) const
	{
		using FUint = TUint<N>;
		const FLanes C[3] = {
			MakePositiveFinite(Linear[0]), MakePositiveFinite(Linear[1]), MakePositiveFinite(Linear[2])};
		const FLanes Y = Luminance(C);
		const FLanes BeyondShadows = SmoothStep(FLanes(0.0f), FLanes(Job.GrainRanges[0]), Y);
		const FLanes Highlights = SmoothStep(FLanes(Job.GrainRanges[1]), FLanes(Job.GrainRanges[2]), Y);
		const FLanes Intensity = FLanes(Job.GrainIntensities[0]) * (FLanes(1.0f) - BeyondShadows) +
								 FLanes(Job.GrainIntensities[1]) * (BeyondShadows - Highlights) +
								 FLanes(Job.GrainIntensities[2]) * Highlights;
		const auto Texel = [this](TInt<N> Pixel, int Axis)
		{
			const FLanes Inside = ToReal<float>(Pixel) + FLanes(0.5f) - FLanes(Job.Viewport[Axis].Origin);
			return AsUint(ToInt(Floor(Inside * FLanes(Job.GrainRanges[3])))) * FUint(1664525u) + FUint(1013904223u);
		};
		FUint A = Texel(PixelX, 0);
		FUint B = Texel(PixelY, 1);
		FUint C2 = FUint(Job.GrainFrame * 1664525u + 1013904223u);
		A = A + B * C2;
		B = B + C2 * A;
		C2 = C2 + A * B;
		A = A + B * C2;
		B = B + C2 * A;
		const FUint Sum = FUint(A.V >> 16) + FUint(B.V >> 16) + FUint(1u);
		const FLanes Grain = ToReal<float>(Sum) * FLanes(1.0f / 65536.0f);
		return Max(Mix(FLanes(1.0f), Grain, Intensity), FLanes(0.0f));
	}

	/** Factors that places in the table are made with, the same for all pixels. */
	struct FTableScale
	{
		explicit FTableScale(const FTonemapJob& Job)
			: Size(Job.TableSize)
			, Steps(Size - FLanes(1.0f))
			, LastSlice(Size - FLanes(2.0f))
			, ToU(FLanes(1.0f) / (Size * Size))
			, ToV(FLanes(1.0f) / Size)
			, Columns(Job.Table->Mips[0].SizeX)
			, Rows(Job.Table->Mips[0].SizeY)
		{
		}

		FLanes Size;
		FLanes Steps;
		FLanes LastSlice;
		FLanes ToU;
		FLanes ToV; // and from a slice to the next
		int32_t Columns;
		int32_t Rows;
	};

	/** Finds the places of exposed scene-linear colours in the table and keeps them for LookUp. */
	DRYDOCK_LANES_INLINE void FindPlaces(const FTableScale& Scale, const FLanes Linear[3], int32_t X) const
	{
		FLanes P[3];
		for (int c = 0; c < 3; ++c)
		{
			// LinToLog(Linear + LogToLinOfZero)
			const FLanes Stops = Log2(MakePositiveFinite(Linear[c]) + FLanes(0.00266771927f));
			P[c] = Clamp(Stops * FLanes(0.0714285746f) + FLanes(0.176709369f) + FLanes(0.434017599f), FLanes(0.0f),
				FLanes(1.0f));
		}
		const FLanes Slice = P[2] * Scale.Steps;
		const FLanes First = Min(Floor(Slice), Scale.LastSlice);
		const FLanes Texel = First * Scale.Size + (P[0] * Scale.Steps + FLanes(0.5f));
		const FLanes U = Texel * Scale.ToU;
		const FLanes V = (P[1] * Scale.Steps + FLanes(0.5f)) * Scale.ToV;
		StoreRaw(LowPlaces + X, PlaceOf<N>(U, Scale.Columns));
		StoreRaw(HighPlaces + X, PlaceOf<N>(U + Scale.ToV, Scale.Columns));
		StoreRaw(RowPlacesOfTable + X, PlaceOf<N>(V, Scale.Rows));
		StoreRaw(SliceWeights + X, (Slice - First).V);
	}

	/** Code values at the places that were found. */
	template<bool bCopied>
	DRYDOCK_LANES_INLINE void LookUp(int32_t X) const
	{
		const FInt Row = LoadRaw<FInt>(RowPlacesOfTable + X);
		const FLanes Weight(LoadRaw<FFloat>(SliceWeights + X));
		FFloat Low[3];
		FFloat High[3];
		Table.template Sample<bCopied>(LoadRaw<FInt>(LowPlaces + X), Row, Low);
		Table.template Sample<bCopied>(LoadRaw<FInt>(HighPlaces + X), Row, High);
		FLanes Bounded[3];
		for (int c = 0; c < 3; ++c)
		{
			const FLanes Color = Mix(FLanes(Low[c]), FLanes(High[c]), Weight) * FLanes(1.05f);
			StoreRaw(Looked + c * RowPitch + X, Color.V);
			Bounded[c] = Clamp(Color, FLanes(0.0f), FLanes(1.0f));
		}
		const FLanes Luma = Bounded[0] * FLanes(0.299f) + Bounded[1] * FLanes(0.587f) + Bounded[2] * FLanes(0.114f);
		StoreRaw(Looked + 3 * RowPitch + X, (FLanes(Job.LumaToAlpha) * Luma).V);
	}

	/** The picture with its lens, exposed. */
	DRYDOCK_LANES_INLINE void GetLinear(int32_t X, int32_t Y, FLanes Linear[3]) const
	{
		const TInt<N> PixelX = TInt<N>(Tile.MinX + X) + LaneIndex<N>();
		const FLanes PositionX = PositionOf<N>(Job.Viewport[0], PixelX);
		const FLanes PositionY = PositionOf<N>(Job.Viewport[1], TInt<N>(Y));
		FLanes Samples[NumSamples][3];
		if (__builtin_expect(!SampleColors<false>(X, Samples), 0))
		{
			SampleColors<true>(X, Samples);
		}
		const FLanes Scene[3] = {Samples[0][0], Samples[0][1], Samples[0][2]};
		for (int c = 0; c < 3; ++c)
		{
			Linear[c] = Scene[c];
		}
		if (Job.bSharpen)
		{
			Sharpen(Samples, Linear);
		}
		FLanes Exposure(Job.Exposure);
		if (Job.bVignette)
		{
			Exposure = Exposure * GetVignette(PositionX, PositionY);
		}
		for (int c = 0; c < 3; ++c)
		{
			Linear[c] = Linear[c] * FLanes(Job.ColorScale[c]) * Exposure;
		}
		if (Job.bLocalExposure)
		{
			const FLanes Factor = LocalExposure.GetFactor(Scene, X);
			for (int c = 0; c < 3; ++c)
			{
				Linear[c] = Linear[c] * Factor;
			}
		}
		if (Job.bBloom)
		{
			for (int c = 0; c < 3; ++c)
			{
				Linear[c] = Linear[c] + Bloom.Columns.template Sample<true>(BloomRows[c], X) * Exposure;
			}
		}
		if (Job.bFilmGrain)
		{
			const FLanes Grain = GetFilmGrain(Linear, PixelX, TInt<N>(Y));
			for (int c = 0; c < 3; ++c)
			{
				Linear[c] = Linear[c] * Grain;
			}
		}
	}

	const FTonemapJob& Job;
	const FKernelTexture& Target;
	const FKernelTile Tile;
	const int NumAround;
	const int NumShifts;
	TTexelRows<N> Color;
	TSampleColumns<N> Columns[NumNeighbors][3];
	int32_t* RowPlaces[NumNeighbors][3] = {};
	const float* ColorRows[NumNeighbors][3] = {};
	float* ColorMixed = nullptr;
	TSampledTile<N> Bloom;
	const float* BloomRows[3] = {};
	float* BloomMixed = nullptr;
	TLocalExposure<N> LocalExposure;
	TColorTable<N> Table;
	// Rows of the tile, RowPitch apart: places in the table and the weight of the next slice, then what was looked up.
	static constexpr int32_t NumRows = 4;
	int32_t RowPitch = 0;
	int32_t* LowPlaces = nullptr;
	int32_t* HighPlaces = nullptr;
	int32_t* RowPlacesOfTable = nullptr;
	float* SliceWeights = nullptr;
	float* Looked = nullptr;
};

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes

namespace Drydock
{

template<int N>
bool TTonemapLanes<N>::Run(const FTonemapJob& Job, const FKernelTexture& Target, const FKernelTile& Pixels)
{
	Lanes::TTonemapTile<N> Tile(Job, Target, Pixels);
	const bool bOpen = Tile.Open();
	if (bOpen)
	{
		Tile.Run();
		Lanes::FinishStreaming();
	}
	return bOpen;
}

} // namespace Drydock
