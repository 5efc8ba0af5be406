// The tonemapper of a tile, pack by pack: the shader's operations in its order (PostProcessTonemap.usf,
// TonemapLens.ush), on rows that are decoded and mixed once. Included by Tonemap_*.cpp only.
#pragma once

#include "Native/LocalExposureLanes.inl"
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
		return true;
	}

	void Run()
	{
		const int32_t Width = Tile.MaxX - Tile.MinX;
		const FKernelMip& Mip = Target.Mips[0];
		const int32_t Bytes = GetTexelStorageInfo(Target.Storage).BytesPerTexel;
		for (int32_t Y = Tile.MinY; Y < Tile.MaxY; ++Y)
		{
			BeginRow(Y - Tile.MinY);
			uint8_t* const Place = Mip.Data + int64_t(Y) * Mip.RowPitch + int64_t(Tile.MinX) * Bytes;
			for (int32_t X = 0; X < Width; X += N)
			{
				FFloat Values[4];
				RunPack(X, Y, Values);
				StorePack<N>(Target, Place + int64_t(X) * Bytes, Width - X, Values);
			}
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
		Color = OpenRows<N>(Job.Color, X, Y, 3, 0);
		return true;
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

	/** The words at Offsets and those right after them: half the loads of two gathers. */
	static DRYDOCK_LANES_INLINE void LoadPairs(const uint8_t* Base, FInt Offsets, TRaw<uint32_t, N> Out[2])
	{
		alignas(64) int32_t Places[N];
		alignas(64) uint64_t Pairs[N];
		StoreRaw(Places, Offsets);
		for (int Lane = 0; Lane < N; ++Lane)
		{
			__builtin_memcpy(Pairs + Lane, Base + Places[Lane], sizeof(uint64_t));
		}
		using FUint = TRaw<uint32_t, N>;
		TLaneOps<N>::Deinterleave(LoadRaw<FUint>(Pairs), LoadRaw<FUint>(Pairs + N / 2), Out);
	}

	/** Bilinear, of a place whose rows are known, as offsets; of a table of RGB10A2, two texels wide at least. Numbers
	 *  of 0 and above, so a weight of 0 need not be asked for. */
	DRYDOCK_LANES_INLINE void SamplePackedTable(FInt PlaceX, const FInt Rows[2], FFloat WeightY, FFloat Out[3]) const
	{
		const FKernelMip& Mip = Job.Table->Mips[0];
		const FInt Below = (PlaceX - 128) >> 8;
		const FInt Left = Max(Min(TInt<N>(Below), TInt<N>(Mip.SizeX - 2)), TInt<N>(0)).V;
		const FFloat WeightX = __builtin_convertvector((PlaceX - 128) & 255, FFloat) * Broadcast<float, N>(1.0f / 256);
		FFloat Corners[2][2][4];
		for (int Row = 0; Row < 2; ++Row)
		{
			TRaw<uint32_t, N> Words[2];
			LoadPairs(Mip.Data, Rows[Row] + Left * int32_t(FRgb10A2Format::Bytes), Words);
			// At the table's ends both texels are the same.
			const TRaw<uint32_t, N> First = Below > Left ? Words[1] : Words[0];
			const TRaw<uint32_t, N> Second = Below < Left ? Words[0] : Words[1];
			FRgb10A2Format::Decode<N>(&First, Corners[Row][0]);
			FRgb10A2Format::Decode<N>(&Second, Corners[Row][1]);
		}
		const auto Blend = [](FFloat A, FFloat B, FFloat Weight)
		{
			return A + Weight * (B - A);
		};
		for (int c = 0; c < 3; ++c)
		{
			Out[c] = Blend(Blend(Corners[0][0][c], Corners[1][0][c], WeightY),
				Blend(Corners[0][1][c], Corners[1][1][c], WeightY), WeightX);
		}
	}

	/** The same of any table. */
	DRYDOCK_LANES_INLINE void SampleTable(FInt PlaceX, const FInt Rows[2], FFloat WeightY, FFloat Out[3]) const
	{
		const FKernelMip& Mip = Job.Table->Mips[0];
		const int32_t Bytes = GetTexelStorageInfo(Job.Table->Storage).BytesPerTexel;
		const TInt<N> Below((PlaceX - 128) >> 8);
		const FFloat WeightX = __builtin_convertvector((PlaceX - 128) & 255, FFloat) * Broadcast<float, N>(1.0f / 256);
		const TInt<N> Last(Mip.SizeX - 1);
		const FInt Left = Max(Min(Below, Last), TInt<N>(0)).V;
		const FInt Right = WeightX == 0.0f ? Left : Max(Min(Below + TInt<N>(1), Last), TInt<N>(0)).V;
		FFloat Corners[4][4];
		for (int i = 0; i < 4; ++i)
		{
			const FInt Offsets = Rows[i & 1] + (i < 2 ? Left : Right) * Bytes;
			GatherTexels<float, N>(Job.Table->Storage, Mip.Data, Offsets, Corners[i]);
		}
		for (int c = 0; c < 3; ++c)
		{
			const auto Blended = [](FFloat A, FFloat B, FFloat Weight)
			{
				return Weight == 0.0f ? A : MixCarefully<N>(A, B, Weight);
			};
			Out[c] = Blended(Blended(Corners[0][c], Corners[1][c], WeightY),
				Blended(Corners[2][c], Corners[3][c], WeightY), WeightX);
		}
	}

	/** Exposed scene-linear to code values, by the table. */
	template<bool bPacked>
	DRYDOCK_LANES_INLINE void LookUp(const FLanes Linear[3], FLanes Out[3]) const
	{
		const FLanes Size(Job.TableSize);
		FLanes P[3];
		for (int c = 0; c < 3; ++c)
		{
			// As the shader's compiler folds LinToLog(Linear + LogToLin(0)).
			const FLanes Stops = Log2(MakePositiveFinite(Linear[c]) + FLanes(0.00266771927f));
			P[c] = Clamp(Stops * FLanes(0.0714285746f) + FLanes(0.176709369f) + FLanes(0.434017599f), FLanes(0.0f),
				FLanes(1.0f));
		}
		const FLanes Steps = Size - FLanes(1.0f);
		const FLanes Slice = P[2] * Steps;
		const FLanes First = Min(Floor(Slice), Size - FLanes(2.0f));
		const FLanes Texel = First * Size + (P[0] * Steps + FLanes(0.5f));
		const FLanes U = Texel * (FLanes(1.0f) / (Size * Size));
		const FLanes V = (P[1] * Steps + FLanes(0.5f)) * (FLanes(1.0f) / Size);
		const FLanes Weight = Slice - First;

		const FKernelMip& Mip = Job.Table->Mips[0];
		const FInt PlaceY = PlaceOf<N>(V, Mip.SizeY);
		const TInt<N> Below((PlaceY - 128) >> 8);
		const FFloat WeightY = __builtin_convertvector((PlaceY - 128) & 255, FFloat) * Broadcast<float, N>(1.0f / 256);
		const TInt<N> Last(Mip.SizeY - 1);
		const FInt Top = Max(Min(Below, Last), TInt<N>(0)).V;
		const FInt Bottom = WeightY == 0.0f ? Top : Max(Min(Below + TInt<N>(1), Last), TInt<N>(0)).V;
		const FInt Rows[2] = {Top * Mip.RowPitch, Bottom * Mip.RowPitch};
		FFloat Low[3];
		FFloat High[3];
		const FInt Place = PlaceOf<N>(U, Mip.SizeX);
		const FInt NextPlace = PlaceOf<N>(U + FLanes(1.0f) / Size, Mip.SizeX);
		if constexpr (bPacked)
		{
			SamplePackedTable(Place, Rows, WeightY, Low);
			SamplePackedTable(NextPlace, Rows, WeightY, High);
		}
		else
		{
			SampleTable(Place, Rows, WeightY, Low);
			SampleTable(NextPlace, Rows, WeightY, High);
		}
		for (int c = 0; c < 3; ++c)
		{
			Out[c] = Mix(FLanes(Low[c]), FLanes(High[c]), Weight) * FLanes(1.05f);
		}
	}

	DRYDOCK_LANES_INLINE void RunPack(int32_t X, int32_t Y, FFloat Values[4]) const
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
		FLanes Linear[3] = {Scene[0], Scene[1], Scene[2]};
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
		FLanes Color[3];
		if (Job.Table->Storage == ETexelStorage::RGB10A2_UNORM && Job.Table->Mips[0].SizeX > 1)
		{
			LookUp<true>(Linear, Color);
		}
		else
		{
			LookUp<false>(Linear, Color);
		}
		FLanes Bounded[3];
		for (int c = 0; c < 3; ++c)
		{
			Values[c] = Color[c].V;
			Bounded[c] = Clamp(Color[c], FLanes(0.0f), FLanes(1.0f));
		}
		const FLanes Luma = Bounded[0] * FLanes(0.299f) + Bounded[1] * FLanes(0.587f) + Bounded[2] * FLanes(0.114f);
		Values[3] = (FLanes(Job.LumaToAlpha) * Luma).V;
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
	}
	return bOpen;
}

} // namespace Drydock
