// Box means in lanes. Sums stand in packs of eight doubles whatever the lanes, so that all instruction sets add in the
// same order, or in integers, where these hold them. Included by BoxSum_*.cpp only.
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
	using FInts = TRaw<int32_t, N>;
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

	/** The part of a strip that lies in the rect: Count texels from Row on, Before texels after the strip's begin. */
	struct FRun
	{
		const uint8_t* Row;
		int32_t Before;
		int32_t Count;
	};

	/** One texel at least: where all of the strip lies outside, the edge. */
	FRun FindRun(int32_t X, int32_t Y, int32_t Count) const
	{
		const int32_t LastRow = Sum.RectMax[1] - 1;
		const int32_t Held = Y < Sum.RectMin[1] ? Sum.RectMin[1] : Y > LastRow ? LastRow : Y;
		const int32_t Next = Held < LastRow ? Held + 1 : Held;
		const int32_t Bytes = GetTexelStorageInfo(Sum.Source->Storage).BytesPerTexel;
		PrefetchTexels(From, Bytes, Next, X, Count);
		const int32_t End = X + Count;
		const int32_t Begin = X < Sum.RectMin[0] ? Sum.RectMin[0] : X > Sum.RectMax[0] - 1 ? Sum.RectMax[0] - 1 : X;
		const int32_t RunEnd = End > Sum.RectMax[0] ? Sum.RectMax[0] : End < Begin + 1 ? Begin + 1 : End;
		// Decoded at the strip's begin and moved, where the strip begins outside.
		const int32_t Before = Begin - X < 0 ? 0 : Begin - X > Count ? Count : Begin - X;
		return {From.Data + int64_t(Held) * From.RowPitch + int64_t(Begin) * Bytes, Before, RunEnd - Begin};
	}

	/** N texels from P on, of which Count are in the row: beyond the last one lie zeros. */
	static DRYDOCK_LANES_INLINE const uint8_t* HoldTexels(const uint8_t* P, int32_t Count, int32_t Bytes, uint8_t* Copy)
	{
		if (Count >= N)
		{
			return P;
		}
		__builtin_memset(Copy, 0, size_t(N) * 16);
		__builtin_memcpy(Copy, P, size_t(Count) * size_t(Bytes));
		return Copy;
	}

	/** The edge texels beyond the run. */
	template<typename T>
	static void FillEnds(const FRun& Run, int32_t Count, T* Out)
	{
		const T First = Out[Run.Before];
		const T Last = Out[Run.Before + Run.Count - 1];
		for (int32_t i = 0; i < Run.Before; ++i)
		{
			Out[i] = First;
		}
		for (int32_t i = Run.Before + Run.Count; i < Count; ++i)
		{
			Out[i] = Last;
		}
	}

	/** Texels X to X + Count of a row, of the one channel; true when all are finite. Whole packs are written. */
	bool Decode(int32_t X, int32_t Y, int32_t Count, float* Out) const
	{
		const ETexelStorage Storage = Sum.Source->Storage;
		const FRun Texels = FindRun(X, Y, Count);
		const uint8_t* const Row = Texels.Row;
		const int32_t Before = Texels.Before;
		TRaw<int32_t, N> Wrong = {};
		const auto Run = [&](auto Format, auto Channel)
		{
			float* const RunOut = Out + Before;
			for (int32_t i = 0; i < Texels.Count; i += N)
			{
				alignas(64) uint8_t Copy[N * 16];
				const uint8_t* const P =
					HoldTexels(Row + int64_t(i) * Format.Bytes, Texels.Count - i, Format.Bytes, Copy);
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
		FillEnds(Texels, Count, Out);
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
		StoreRaw(Out, __builtin_convertvector(Whole, FValues) * Sum.Scale);
	}

	/** The lanes, moved up by Step; zeros below. */
	template<int Step, typename V>
	static DRYDOCK_LANES_INLINE V MoveUp(V Pack)
	{
		constexpr int Count = sizeof(V) / sizeof(Pack[0]);
		return ShuffleLanes(V{}, Pack, [](int Lane) { return Lane < Step ? 0 : Lane + (Count - Step); });
	}

	template<typename V>
	static DRYDOCK_LANES_INLINE V RepeatLast(V Pack)
	{
		return ShuffleLanes(Pack, Pack, [](int) { return int(sizeof(V) / sizeof(Pack[0])) - 1; });
	}

	/** Sums of the values before each index of a strip; Out takes a pack and one more. */
	static void AddUp(const float* Strip, int32_t Count, double* Out)
	{
		FSums Before = {};
		Out[0] = 0.0;
		for (int32_t i = 0; i < Count; i += D)
		{
			FSums Sums = Widen(Strip + i);
			Sums += MoveUp<1>(Sums);
			Sums += MoveUp<2>(Sums);
			Sums += MoveUp<4>(Sums);
			Sums += Before;
			Before = RepeatLast(Sums);
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

	/** Channels of one byte, four to a texel. */
	bool HasCodes() const
	{
		return Sum.Source->Storage == ETexelStorage::RGBA8_UNORM || Sum.Source->Storage == ETexelStorage::BGRA8_UNORM;
	}

	/** Texels X to X + Count of a row, of the one channel, as they are stored. Whole packs are written. */
	void DecodeCodes(int32_t X, int32_t Y, int32_t Count, int32_t* Out) const
	{
		const FRun Texels = FindRun(X, Y, Count);
		const bool bSwapped = Sum.Source->Storage == ETexelStorage::BGRA8_UNORM && Sum.Channel != 3;
		const int32_t Shift = 8 * (bSwapped ? 2 - Sum.Channel : Sum.Channel);
		for (int32_t i = 0; i < Texels.Count; i += N)
		{
			alignas(64) uint8_t Copy[N * 16];
			const uint8_t* const P = HoldTexels(Texels.Row + int64_t(i) * 4, Texels.Count - i, 4, Copy);
			StoreRaw(Out + Texels.Before + i, (LoadRaw<FInts>(P) >> Shift) & 255);
		}
		FillEnds(Texels, Count, Out);
	}

	/** SumRows of what HasCodes, with no fraction: sums of integers. */
	uint64_t SumRowsOfCodes() const
	{
		const int32_t Count = Width + 2 * Reach;
		const size_t Ints = size_t(Count) + 3 * N;
		int32_t* const Strip = static_cast<int32_t*>(GetTapMemory(0, Ints * sizeof(int32_t)));
		int32_t* const Sums = static_cast<int32_t*>(GetTapMemory(1, Ints * sizeof(int32_t)));
		float* const Means = static_cast<float*>(GetTapMemory(2, Ints * sizeof(float)));
		const float Scale = Sum.Scale / 255.0f;
		for (int32_t Y = 0; Y < Height; ++Y)
		{
			DecodeCodes(FirstX, FirstY + Y, Count, Strip);
			StoreRaw(Strip + Count, FInts{}); // the last step reads them, and sums of what memory holds could overflow
			FInts Before = {};
			Sums[0] = 0;
			for (int32_t i = 0; i < Count; i += N)
			{
				FInts Pack = LoadRaw<FInts>(Strip + i);
				Pack += MoveUp<1>(Pack);
				Pack += MoveUp<2>(Pack);
				if constexpr (N > 4)
				{
					Pack += MoveUp<4>(Pack);
				}
				if constexpr (N > 8)
				{
					Pack += MoveUp<8>(Pack);
				}
				Pack += Before;
				Before = RepeatLast(Pack);
				StoreRaw(Sums + i + 1, Pack);
			}
			for (int32_t X = 0; X < Width; X += N)
			{
				const FInts Whole = LoadRaw<FInts>(Sums + X + 2 * Reach) - LoadRaw<FInts>(Sums + X + 1);
				StoreRaw(Means + X, __builtin_convertvector(Whole, TRaw<float, N>) * Scale);
			}
			Encode(Means, Pixels.MinY + Y);
		}
		return 0;
	}

	/** Half floats from 0 to 1 are multiples of this, and so many of them add up in 31 bits. */
	static constexpr float StepOfHalf = 1.0f / (1 << 24);
	static constexpr int32_t MostHalves = 127;

	/** Texels of a row of half floats as multiples of StepOfHalf; false where one is not from 0 to 1. Whole packs are
	 *  written. */
	bool DecodeHalves(int32_t X, int32_t Y, int32_t Count, int32_t* Out) const
	{
		const FRun Texels = FindRun(X, Y, Count);
		FInts Wrong = {};
		for (int32_t i = 0; i < Texels.Count; i += N)
		{
			alignas(64) uint8_t Copy[N * 16];
			const uint8_t* const P = HoldTexels(Texels.Row + int64_t(i) * 2, Texels.Count - i, 2, Copy);
			const TRaw<float, N> Value = TLaneOps<N>::LoadHalves(P);
			constexpr int32_t One = 0x3F800000;
			Wrong |= (FInts(Value) < 0) | (FInts(Value) > One);
			StoreRaw(Out + Texels.Before + i, __builtin_convertvector(Value * (1.0f / StepOfHalf), FInts));
		}
		FillEnds(Texels, Count, Out);
		return !AnyLane(TMask<N>(Wrong));
	}

	/** SumColumns of half floats, with no fraction: the same bits by sums of integers. False, with nothing stored,
	 * where those do not do. */
	bool SumColumnsOfHalves() const
	{
		const int32_t NumRows = Height + 2 * Reach;
		const int32_t Pitch = Width + 2 * N;
		const auto Reserve = [](int32_t Number, int64_t Count)
		{
			return GetTapMemory(Number, size_t(Count) * sizeof(int32_t));
		};
		int32_t* const Texels = static_cast<int32_t*>(Reserve(0, int64_t(NumRows) * Pitch));
		int32_t* const Sums = static_cast<int32_t*>(Reserve(1, Pitch));
		float* const Means = static_cast<float*>(Reserve(2, Pitch));
		bool bFine = Sum.Source->Storage == ETexelStorage::R16_FLOAT && 2 * Sum.Radius + 1 <= MostHalves;
		for (int32_t Row = 0; Row < NumRows && bFine; ++Row)
		{
			bFine = DecodeHalves(FirstX, FirstY + Row, Width, Texels + int64_t(Row) * Pitch);
		}
		for (int32_t X = 0; X < Width && bFine; X += N)
		{
			FInts Whole = {};
			for (int32_t Tap = 1; Tap < 2 * Reach; ++Tap)
			{
				Whole += LoadRaw<FInts>(Texels + int64_t(Tap) * Pitch + X);
			}
			StoreRaw(Sums + X, Whole);
		}
		const float Scale = Sum.Scale * StepOfHalf;
		for (int32_t Y = 0; Y < Height && bFine; ++Y)
		{
			const int32_t* const Removed = Texels + int64_t(Y + 1) * Pitch;
			const int32_t* const Added = Texels + int64_t(Y + 2 * Reach) * Pitch;
			for (int32_t X = 0; X < Width; X += N)
			{
				const FInts Whole = LoadRaw<FInts>(Sums + X);
				StoreRaw(Means + X, __builtin_convertvector(Whole, TRaw<float, N>) * Scale);
				StoreRaw(Sums + X, Whole + (LoadRaw<FInts>(Added + X) - LoadRaw<FInts>(Removed + X)));
			}
			Encode(Means, Pixels.MinY + Y);
		}
		return bFine;
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
	const auto MakePart = [&](const FKernelTile& Part)
	{
		const int32_t Reach = Sum.Radius + 1;
		const int32_t FirstX = Part.MinX + ToSourceX - (Sum.Axis == 0 ? Reach : 0);
		const int32_t FirstY = Part.MinY + ToSourceY - (Sum.Axis == 1 ? Reach : 0);
		return Lanes::TBoxSum<N>{Sum, Target, Part, FirstX, FirstY};
	};
	const bool bEnds = Sum.Fraction != 0.0f;
	const Lanes::TBoxSum<N> Whole = MakePart(Pixels);
	if (Sum.Axis == 1)
	{
		return bEnds                        ? Whole.template SumColumns<true>()
			   : Whole.SumColumnsOfHalves() ? 0
											: Whole.template SumColumns<false>();
	}
	if (!bEnds && Whole.HasCodes())
	{
		return Whole.SumRowsOfCodes();
	}
	uint64_t Left = 0;
	FKernelTile Part = Pixels;
	for (; Part.MinX < Pixels.MaxX; Part.MinX = Part.MaxX)
	{
		const int32_t End = Part.MinX + GColumnsOfBoxGroup;
		Part.MaxX = End < Pixels.MaxX ? End : Pixels.MaxX;
		const Lanes::TBoxSum<N> Columns = MakePart(Part);
		Left |= bEnds ? Columns.template SumRows<true>() : Columns.template SumRows<false>();
	}
	return Left;
}

} // namespace Drydock
