// Rows of a source as floats, channel by channel, with what lies beyond its rect; and the mixtures of two of them.
// Included by TapSumLanes.inl only.
#pragma once

#include "Native/TapSumPlan.inl"
#include "Native/TexelStrips.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** Rows of pixels that are summed side by side where taps allow it (TapSumColumns.inl). */
constexpr int32_t GRowsOfTapBlock = 4;

/** Vectors that are summed side by side. */
constexpr int GTapGroup = 4;

/** The sampler's rule (FilterPair) for lanes that may be NaN; Weight is not 0. */
template<int N>
DRYDOCK_LANES_INLINE TRaw<float, N> MixCarefully(TRaw<float, N> A, TRaw<float, N> B, TRaw<float, N> Weight)
{
	using FFloat = TRaw<float, N>;
	FFloat Mixed = A + Weight * (B - A);
	if (__builtin_expect(TLaneOps<N>::AnyNan(Mixed, Mixed), 0))
	{
		const FFloat Products = A * (Broadcast<float, N>(1.0f) - Weight) + B * Weight;
		Mixed = Mixed == Mixed ? Mixed : Products;
	}
	return Mixed;
}

/** N texels from P on, of which Readable are in the row, as channels. */
template<int N, typename FFormat>
DRYDOCK_LANES_INLINE void LoadRowTexels(FFormat Format, const uint8_t* P, int32_t Readable, TRaw<float, N> C[4])
{
	alignas(64) uint8_t Copy[N * 16];
	if (Readable < N)
	{
		__builtin_memset(Copy, 0, sizeof(Copy));
		__builtin_memcpy(Copy, P, size_t(Readable) * size_t(Format.Bytes));
		P = Copy;
	}
	if constexpr (std::is_same_v<FFormat, FAnyFormat>)
	{
		LoadTexels<float, N>(Format.Storage, P, C);
	}
	else
	{
		LoadTexelsOf<FFormat, float, N>(P, C);
	}
}

/** The first Count, at most N, texels of a pack to a row of the target. */
template<int N>
DRYDOCK_LANES_INLINE void StorePack(
	const FKernelTexture& Target, uint8_t* Place, int32_t Count, const TRaw<float, N> C[4])
{
	alignas(64) float Values[4 * N];
	for (int c = 0; c < 4; ++c)
	{
		StoreRaw(Values + c * N, C[c]);
	}
	const bool bSaturate = Target.bSaturateStore != 0;
	if (Count >= N)
	{
		StoreTexels<float, N>(Target.Storage, bSaturate, Place, Values);
		return;
	}
	alignas(64) uint8_t Row[N * 16];
	StoreTexels<float, N>(Target.Storage, bSaturate, Row, Values);
	__builtin_memcpy(Place, Row, size_t(Count) * size_t(GetTexelStorageInfo(Target.Storage).BytesPerTexel));
}

/** Rows of one source for the columns of a chunk, decoded when they are first asked for; as many as are live at a time
 *  are kept. With texels two to a pixel, a channel is its even texels, then, Stride / 2 later, its odd ones. */
template<int N>
struct TTexelRows
{
	using FFloat = TRaw<float, N>;

	FTapSource Source;
	FKernelMip Mip;
	int32_t Channels;
	bool bSplit;
	int32_t FirstColumn;
	int32_t NumColumns;
	int32_t FirstRow;
	int32_t LastRow;
	int32_t NumSlots;
	int32_t Stride; // floats of a channel
	float* Texels;
	int32_t* SlotRows; // what the slots hold, counted from the first row; -1: nothing

	TTexelRows() = default;

	/** Number: below 3, another for each of those that are open at a time. */
	TTexelRows(
		const FSourcePlan& Plan, int32_t InChannels, int32_t InFirstColumn, int32_t InNumColumns, int32_t Number = 0)
		: Source(*Plan.Source)
		, Mip(Plan.Source->Texture->Mips[0])
		, Channels(InChannels)
		, bSplit(Plan.Step == 512)
		, FirstColumn(InFirstColumn)
		, NumColumns(InNumColumns)
		, FirstRow(Plan.FirstRow)
		, LastRow(Plan.FirstRow + Plan.NumRows - 1)
		, NumSlots(Plan.LiveRows + (Plan.bInBlocks ? GRowsOfTapBlock - 1 : 0))
	{
		// Whole groups are read from the last columns on.
		constexpr int32_t Beside = (GTapGroup + 1) * N;
		Stride = bSplit ? 2 * (RoundUpTo((NumColumns + 1) / 2, N) + Beside) : RoundUpTo(NumColumns, N) + Beside;
		// One row more than there are, to decode what is split after it.
		Texels = static_cast<float*>(GetTapMemory(Number == 0 ? TexelRowsMemory : TexelRowsMemories + Number - 1,
			size_t(NumSlots + 1) * RowFloats() * sizeof(float)));
		SlotRows = static_cast<int32_t*>(
			GetTapMemory(Number == 0 ? FlagsMemory : FlagsMemories + Number - 1, size_t(NumSlots) * sizeof(int32_t)));
		__builtin_memset(SlotRows, -1, size_t(NumSlots) * sizeof(int32_t));
	}

	size_t RowFloats() const { return size_t(Channels) * size_t(Stride); }

	/** Row: as if rows went on beyond the rect. */
	const float* Get(int32_t Row)
	{
		const int32_t Index = Row - FirstRow;
		const int32_t Slot = Index % NumSlots;
		float* const Out = Texels + size_t(Slot) * RowFloats();
		if (SlotRows[Slot] != Index)
		{
			SlotRows[Slot] = Index;
			float* const Whole = bSplit ? Texels + size_t(NumSlots) * RowFloats() : Out;
			Decode(Row, Whole);
			if (bSplit)
			{
				Split(Whole, Out);
			}
		}
		return Out;
	}

	/** The same, where rows beyond those of the plan are all the edge's. */
	const float* GetHeld(int32_t Row) { return Get(Row < FirstRow ? FirstRow : Row > LastRow ? LastRow : Row); }

private:
	/** The texel that an index of an axis stands for; -1: the border. */
	int32_t Address(int32_t X, int Axis) const
	{
		if (Source.Beyond == EBeyondRect::Sampler)
		{
			return Axis == 0 ? AddressTexel(X, Mip.SizeX, Source.Sampler->AddressU)
							 : AddressTexel(X, Mip.SizeY, Source.Sampler->AddressV);
		}
		const int32_t First = Source.RectMin[Axis];
		const int32_t Last = Source.RectMax[Axis] - 1;
		if (Source.Beyond == EBeyondRect::Black)
		{
			return X < First || X > Last ? -1 : X;
		}
		return X < First ? First : X > Last ? Last : X;
	}

	float GetBorder(int Channel) const
	{
		return Source.Beyond == EBeyondRect::Sampler ? Source.Sampler->Border[Channel] : 0.0f;
	}

	void Decode(int32_t Row, float* Out) const
	{
		const int32_t Y = Address(Row, 1);
		constexpr int32_t Ahead = 2;
		const int32_t Next = Y < 0 ? -1 : Address(Y + Ahead, 1);
		if (Next >= 0)
		{
			PrefetchTexels(
				Mip, GetTexelStorageInfo(Source.Texture->Storage).BytesPerTexel, Next, FirstColumn, NumColumns);
		}
		const uint8_t* const Base = Mip.Data + int64_t(Y < 0 ? 0 : Y) * Mip.RowPitch;
		const int32_t End = FirstColumn + NumColumns;
		int32_t RunBegin = FirstColumn > Source.RectMin[0] ? FirstColumn : Source.RectMin[0];
		int32_t RunEnd = End < Source.RectMax[0] ? End : Source.RectMax[0];
		if (Y < 0 || RunEnd <= RunBegin)
		{
			RunBegin = RunEnd = FirstColumn;
		}
		DecodeRun(Base, RunBegin, RunEnd, Out);
		DecodeBeyond(Base, Y < 0, FirstColumn, RunBegin, Out);
		DecodeBeyond(Base, Y < 0, RunEnd, End, Out);
	}

	void DecodeRun(const uint8_t* Base, int32_t Begin, int32_t End, float* Out) const
	{
		const auto Run = [&](auto Format)
		{
			for (int32_t X = Begin; X < End; X += N)
			{
				FFloat C[4];
				LoadRowTexels<N>(Format, Base + int64_t(X) * Format.Bytes, Mip.SizeX - X, C);
				for (int32_t c = 0; c < Channels; ++c)
				{
					StoreRaw(Out + c * Stride + (X - FirstColumn), C[c]);
				}
			}
			return true;
		};
		const ETexelStorage Storage = Source.Texture->Storage;
		if (!VisitPictureFormat(Storage, Run))
		{
			Run(FAnyFormat{Storage, GetTexelStorageInfo(Storage).BytesPerTexel});
		}
	}

	/** Columns outside the rect, texel by texel. */
	void DecodeBeyond(const uint8_t* Base, bool bBorderRow, int32_t Begin, int32_t End, float* Out) const
	{
		const ETexelStorage Storage = Source.Texture->Storage;
		const int32_t Bytes = GetTexelStorageInfo(Storage).BytesPerTexel;
		float Last[4] = {};
		int32_t LastX = -2;
		for (int32_t Column = Begin; Column < End; ++Column)
		{
			const int32_t X = bBorderRow ? -1 : Address(Column, 0);
			if (X != LastX)
			{
				FFloat C[4];
				if (X >= 0)
				{
					LoadRowTexels<N>(FAnyFormat{Storage, Bytes}, Base + int64_t(X) * Bytes, 1, C);
				}
				for (int c = 0; c < 4; ++c)
				{
					Last[c] = X >= 0 ? C[c][0] : GetBorder(c);
				}
				LastX = X;
			}
			for (int32_t c = 0; c < Channels; ++c)
			{
				Out[c * Stride + (Column - FirstColumn)] = Last[c];
			}
		}
	}

	void Split(const float* Whole, float* Out) const
	{
		using FUint = TRaw<uint32_t, N>;
		for (int32_t c = 0; c < Channels; ++c)
		{
			const float* const From = Whole + c * Stride;
			float* const To = Out + c * Stride;
			for (int32_t X = 0; X < NumColumns; X += 2 * N)
			{
				FUint Halves[2];
				TLaneOps<N>::Deinterleave(LoadRaw<FUint>(From + X), LoadRaw<FUint>(From + X + N), Halves);
				StoreRaw(To + X / 2, Halves[0]);
				StoreRaw(To + Stride / 2 + X / 2, Halves[1]);
			}
		}
	}
};

/** Mixtures of two neighbouring rows, kept for the taps and rows that ask for them again. */
template<int N>
struct TMixedRows
{
	using FFloat = TRaw<float, N>;
	static constexpr int32_t FewTaps = 12;

	TTexelRows<N>& Rows;
	int32_t LookBack;
	int32_t Capacity;
	int32_t Num = 0;
	float* Mixed;
	int32_t* Places;

	/** If there are few taps, those of one row ask for the places of the last row. A place found stays until the row is
	 * done: at most LookBack + NumTaps are newer. */
	TMixedRows(TTexelRows<N>& InRows, int32_t NumTaps)
		: Rows(InRows)
		, LookBack(NumTaps <= FewTaps ? 16 : 1)
		, Capacity(LookBack + NumTaps + 1)
	{
		const size_t PlaceBytes = size_t(RoundUpTo(Capacity * 4, 64));
		auto* const Memory = static_cast<uint8_t*>(
			GetTapMemory(MixedRowsMemory, PlaceBytes + size_t(Capacity) * Rows.RowFloats() * sizeof(float)));
		Places = reinterpret_cast<int32_t*>(Memory);
		Mixed = reinterpret_cast<float*>(Memory + PlaceBytes);
	}

	const float* Get(int32_t Place)
	{
		for (int32_t Index = Num - 1; Index >= 0 && Index >= Num - LookBack; --Index)
		{
			if (Places[Index % Capacity] == Place)
			{
				return Mixed + size_t(Index % Capacity) * Rows.RowFloats();
			}
		}
		const float* const A = Rows.Get(TexelBelow(Place));
		const float* const B = Rows.Get(TexelBelow(Place) + 1);
		const FFloat Weight = Broadcast<float, N>(WeightOfNext(Place));
		const int32_t Slot = Num++ % Capacity;
		Places[Slot] = Place;
		float* const Out = Mixed + size_t(Slot) * Rows.RowFloats();
		const int32_t Used = Rows.bSplit ? (Rows.NumColumns + 1) / 2 : Rows.NumColumns;
		for (int32_t Part = 0; Part < (Rows.bSplit ? 2 : 1) * Rows.Channels; ++Part)
		{
			const int32_t From = Part * (Rows.bSplit ? Rows.Stride / 2 : Rows.Stride);
			for (int32_t X = From; X < From + Used; X += N)
			{
				StoreRaw(Out + X, MixCarefully<N>(LoadRaw<FFloat>(A + X), LoadRaw<FFloat>(B + X), Weight));
			}
		}
		return Out;
	}
};

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
