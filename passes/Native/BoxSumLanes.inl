// Box means in lanes. Sums stand in packs of eight doubles whatever the lanes, so that all instruction sets add in the
// same order. Included by BoxSum_*.cpp only.
#pragma once

#include "Native/BoxSum.h"
#include "Native/TexelStrips.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

template<int N>
struct TBoxSum
{
	static constexpr int D = 8;
	using FSums = TRaw<double, D>;
	using FValues = TRaw<float, D>;

	const FBoxSum& Sum;
	const FKernelTexture& Target;
	const FKernelTile& Pixels;
	int32_t FirstX; // of the source, of the first texel that is read
	int32_t FirstY;
	const int32_t Width = Pixels.MaxX - Pixels.MinX;
	const int32_t Height = Pixels.MaxY - Pixels.MinY;
	const int32_t Reach = Sum.Radius + 1;
	const FKernelMip& From = Sum.Source->Mips[0];
	const FKernelMip& To = Target.Mips[0];

	static DRYDOCK_LANES_INLINE FSums Widen(const float* P)
	{
#if DRYDOCK_LANES_LEVEL >= 4
		return FSums(_mm512_cvtps_pd(__m256(LoadRaw<FValues>(P)))); // one instruction, which the compiler does not find
#else
		return __builtin_convertvector(LoadRaw<FValues>(P), FSums);
#endif
	}

	/** Texels X to X + Count of a row, of the one channel; true when all are finite. Whole packs are written. */
	bool Decode(int32_t X, int32_t Y, int32_t Count, float* Out) const
	{
		const int32_t LastRow = Sum.RectMax[1] - 1;
		const int32_t Held = Y < Sum.RectMin[1] ? Sum.RectMin[1] : Y > LastRow ? LastRow : Y;
		const int32_t Next = Held < LastRow ? Held + 1 : Held;
		const uint8_t* const Row = From.Data + int64_t(Held) * From.RowPitch;
		const ETexelStorage Storage = Sum.Source->Storage;
		PrefetchTexels(From, GetTexelStorageInfo(Storage).BytesPerTexel, Next, X, Count);
		const int32_t End = X + Count;
		const int32_t RunBegin = X < Sum.RectMin[0] ? Sum.RectMin[0] : X > Sum.RectMax[0] - 1 ? Sum.RectMax[0] - 1 : X;
		const int32_t RunEnd = End > Sum.RectMax[0] ? Sum.RectMax[0] : End < RunBegin + 1 ? RunBegin + 1 : End;
		// Decoded at the strip's begin and moved, where the strip begins outside.
		const int32_t Before = RunBegin - X < 0 ? 0 : RunBegin - X > Count ? Count : RunBegin - X;
		TRaw<int32_t, N> Wrong = {};
		const auto Run = [&](auto Format, auto Channel)
		{
			const int32_t RunCount = RunEnd - RunBegin;
			float* const RunOut = Out + Before;
			for (int32_t i = 0; i < RunCount; i += N)
			{
				const uint8_t* P = Row + int64_t(RunBegin + i) * Format.Bytes;
				alignas(64) uint8_t Copy[N * 16];
				if (RunCount - i < N)
				{
					// Beyond the last texel lie zeros: numbers.
					__builtin_memset(Copy, 0, sizeof(Copy));
					__builtin_memcpy(Copy, P, size_t(RunCount - i) * size_t(Format.Bytes));
					P = Copy;
				}
				TRaw<float, N> Channels[4];
				if constexpr (std::is_same_v<decltype(Format), FAnyFormat>)
				{
					LoadTexels<float, N>(Format.Storage, P, Channels);
				}
				else
				{
					LoadTexelsOf<decltype(Format), float, N>(P, Channels);
				}
				StoreRaw(RunOut + i, Channels[Channel]);
				const auto Bits = TRaw<int32_t, N>(Channels[Channel]) & 0x7F800000;
				Wrong |= Bits == 0x7F800000;
			}
			return true;
		};
		const auto RunFormat = [&](auto Format)
		{
			switch (Sum.Channel)
			{
			case 0:
				return Run(Format, std::integral_constant<int, 0>{});
			case 1:
				return Run(Format, std::integral_constant<int, 1>{});
			case 2:
				return Run(Format, std::integral_constant<int, 2>{});
			default:
				return Run(Format, std::integral_constant<int, 3>{});
			}
		};
		if (!VisitPictureFormat(Storage, RunFormat))
		{
			RunFormat(FAnyFormat{Storage, GetTexelStorageInfo(Storage).BytesPerTexel});
		}
		const float First = Out[Before];
		const float Last = Out[Before + RunEnd - RunBegin - 1];
		for (int32_t i = 0; i < Before; ++i)
		{
			Out[i] = First;
		}
		for (int32_t i = Before + RunEnd - RunBegin; i < Count; ++i)
		{
			Out[i] = Last;
		}
		return !AnyLane(TMask<N>(Wrong));
	}

	void Encode(const float* Means, int32_t Y) const
	{
		const int32_t Bytes = GetTexelStorageInfo(Target.Storage).BytesPerTexel;
		uint8_t* const Row = To.Data + int64_t(Y) * To.RowPitch + int64_t(Pixels.MinX) * Bytes;
		const bool bSaturate = Target.bSaturateStore != 0;
		const auto Store = [&](auto Format)
		{
			for (int32_t X = 0; X < Width; X += N)
			{
				const TRaw<float, N> Mean = LoadRaw<TRaw<float, N>>(Means + X);
				const TRaw<float, N> Channels[4] = {Mean, Mean, Mean, Broadcast<float, N>(1.0f)};
				alignas(64) uint8_t Copy[N * 16];
				uint8_t* const Place = Width - X < N ? Copy : Row + int64_t(X) * Bytes;
				if constexpr (std::is_same_v<decltype(Format), FAnyFormat>)
				{
					alignas(64) float Values[4 * N];
					__builtin_memcpy(Values, Channels, sizeof(Values));
					StoreTexels<float, N>(Format.Storage, bSaturate, Place, Values);
				}
				else if constexpr (std::is_same_v<decltype(Format), FR16Format>)
				{
					TLaneOps<N>::StoreHalves(Place, Mean);
				}
				else
				{
					StoreTexelsOf<decltype(Format), float, N>(Place, Channels);
				}
				if (Width - X < N)
				{
					__builtin_memcpy(Row + int64_t(X) * Bytes, Copy, size_t(Width - X) * size_t(Bytes));
				}
			}
			return true;
		};
		if (bSaturate || !VisitPictureFormat(Target.Storage, Store))
		{
			Store(FAnyFormat{Target.Storage, Bytes});
		}
	}

	/** bEnds: the fraction is not 0. */
	template<bool bEnds>
	DRYDOCK_LANES_INLINE void StoreMeans(FSums Whole, const float* First, const float* Last, float* Out) const
	{
		if constexpr (bEnds)
		{
			Whole = Whole + (Widen(First) + Widen(Last)) * double(Sum.Fraction);
		}
		StoreRaw(Out, __builtin_convertvector(Whole * double(Sum.Scale), FValues));
	}

	/** Sums of the values before each index of a strip; Out takes a pack and one more. */
	static void AddUp(const float* Strip, int32_t Count, double* Out)
	{
		using FIndex = TRaw<int64_t, D>;
		constexpr FIndex By1 = {0, 8, 9, 10, 11, 12, 13, 14};
		constexpr FIndex By2 = {0, 0, 8, 9, 10, 11, 12, 13};
		constexpr FIndex By4 = {0, 0, 0, 0, 8, 9, 10, 11};
		constexpr FIndex Top = {7, 7, 7, 7, 7, 7, 7, 7};
		const FSums Zeros = {};
		FSums Before = {};
		Out[0] = 0.0;
		for (int32_t i = 0; i < Count; i += D)
		{
			FSums Sums = Widen(Strip + i);
			Sums += __builtin_shuffle(Zeros, Sums, By1);
			Sums += __builtin_shuffle(Zeros, Sums, By2);
			Sums += __builtin_shuffle(Zeros, Sums, By4);
			Sums += Before;
			Before = __builtin_shuffle(Sums, Top);
			StoreRaw(Out + i + 1, Sums);
		}
	}

	static uint64_t GetGroup(int32_t Row)
	{
		return uint64_t(1) << (Row / GRowsOfBoxGroup);
	}

	template<bool bEnds>
	uint64_t SumRows() const
	{
		const int32_t Count = Width + 2 * Reach;
		const size_t Floats = size_t(Count) + 2 * N + 2 * D;
		float* const Strip = static_cast<float*>(GetTapMemory(0, Floats * sizeof(float)));
		double* const Sums = static_cast<double*>(GetTapMemory(1, Floats * sizeof(double)));
		float* const Means = static_cast<float*>(GetTapMemory(2, Floats * sizeof(float)));
		uint64_t Left = 0;
		for (int32_t Y = 0; Y < Height; ++Y)
		{
			if (!Decode(FirstX, FirstY + Y, Count, Strip))
			{
				Left |= GetGroup(Y);
				continue;
			}
			AddUp(Strip, Count, Sums);
			for (int32_t X = 0; X < Width; X += D)
			{
				const FSums Whole = LoadRaw<FSums>(Sums + X + 2 * Reach) - LoadRaw<FSums>(Sums + X + 1);
				StoreMeans<bEnds>(Whole, Strip + X, Strip + X + 2 * Reach, Means + X);
			}
			Encode(Means, Pixels.MinY + Y);
		}
		return Left;
	}

	template<bool bEnds>
	uint64_t SumColumns() const
	{
		const int32_t NumRows = Height + 2 * Reach;
		const int32_t Pitch = Width + 2 * N + D;
		float* const Texels = static_cast<float*>(GetTapMemory(0, size_t(NumRows) * size_t(Pitch) * sizeof(float)));
		double* const Sums = static_cast<double*>(GetTapMemory(1, size_t(Pitch) * sizeof(double)));
		float* const Means = static_cast<float*>(GetTapMemory(2, size_t(Pitch) * sizeof(float)));
		uint64_t Left = 0;
		for (int32_t Row = 0; Row < NumRows; ++Row)
		{
			if (!Decode(FirstX, FirstY + Row, Width, Texels + int64_t(Row) * Pitch))
			{
				const int32_t First = Row < 2 * Reach ? 0 : Row - 2 * Reach;
				for (int32_t Y = First; Y <= Row && Y < Height; ++Y)
				{
					Left |= GetGroup(Y);
				}
			}
		}
		const bool bExact = GetTexelStorageInfo(Sum.Source->Storage).BitsPerChannel <= 16;
		for (int32_t Y = 0; Y < Height; ++Y)
		{
			const float* const Row = Texels + int64_t(Y) * Pitch;
			const float* const LastRow = Row + int64_t(2 * Reach) * Pitch;
			if (Left & GetGroup(Y))
			{
				continue;
			}
			const bool bFirst = Y % GRowsOfBoxGroup == 0;
			const bool bAnew = Y == 0 || (bFirst && (!bExact || (Left & GetGroup(Y - 1)) != 0));
			for (int32_t X = 0; X < Width && bAnew; X += D)
			{
				FSums Whole = {};
				for (int32_t Tap = 1; Tap < 2 * Reach; ++Tap)
				{
					Whole += Widen(Row + int64_t(Tap) * Pitch + X);
				}
				StoreRaw(Sums + X, Whole);
			}
			for (int32_t X = 0; X < Width; X += D)
			{
				const FSums Whole = LoadRaw<FSums>(Sums + X);
				StoreMeans<bEnds>(Whole, Row + X, LastRow + X, Means + X);
				StoreRaw(Sums + X, Whole + (Widen(LastRow + X) - Widen(Row + Pitch + X)));
			}
			Encode(Means, Pixels.MinY + Y);
		}
		return Left;
	}
};

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes

namespace Drydock
{

template<int N>
uint64_t TBoxSumLanes<N>::Run(
	const FBoxSum& Sum, const FKernelTexture& Target, const FKernelTile& Pixels, int32_t ToSourceX, int32_t ToSourceY)
{
	const int32_t Reach = Sum.Radius + 1;
	const int32_t FirstX = Pixels.MinX + ToSourceX - (Sum.Axis == 0 ? Reach : 0);
	const int32_t FirstY = Pixels.MinY + ToSourceY - (Sum.Axis == 1 ? Reach : 0);
	const Lanes::TBoxSum<N> Tile{Sum, Target, Pixels, FirstX, FirstY};
	if (Sum.Fraction != 0.0f)
	{
		return Sum.Axis == 0 ? Tile.template SumRows<true>() : Tile.template SumColumns<true>();
	}
	return Sum.Axis == 0 ? Tile.template SumRows<false>() : Tile.template SumColumns<false>();
}

} // namespace Drydock
