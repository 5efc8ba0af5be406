// The tonemapper's table of colours in lanes: sampled as it is stored or, by passes of many pixels, from a copy in
// floats, where a pixel's two neighbours along a row are one load. Included by TonemapLanes.inl only.
#pragma once

#include "Native/SeparableSamples.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

template<int N>
class TColorTable
{
	using FFloat = TRaw<float, N>;
	using FInt = TRaw<int32_t, N>;

	static constexpr int C = 4; // floats of a texel of the copy

public:
	/** Pass: a number that no other pass has. NumPixels: of the whole pass. */
	void Open(const FKernelTexture& InTable, uint64_t Pass, int64_t NumPixels)
	{
		// To copy a texel takes a fraction of what a pixel gains.
		constexpr int64_t PixelsATexel = 2;
		Table = &InTable;
		Copy = nullptr;
		const FKernelMip& Mip = Table->Mips[0];
		const bool bUnorm = GetTexelStorageInfo(Table->Storage).Kind == ETexelKind::Unorm;
		if (N >= 8 && bUnorm && NumPixels >= PixelsATexel * Mip.SizeX * Mip.SizeY)
		{
			CopyTexels(Pass);
		}
	}

	bool IsCopied() const { return Copy != nullptr; }

	/** Bilinear at places of the table. bCopied: IsCopied. */
	template<bool bCopied>
	DRYDOCK_LANES_INLINE void Sample(FInt PlaceX, FInt PlaceY, FFloat Out[3]) const
	{
		const TInt<N> Column((PlaceX - 128) >> 8);
		const TInt<N> Row((PlaceY - 128) >> 8);
		const FFloat WeightX = __builtin_convertvector((PlaceX - 128) & 255, FFloat) * Broadcast<float, N>(1.0f / 256);
		const FFloat WeightY = __builtin_convertvector((PlaceY - 128) & 255, FFloat) * Broadcast<float, N>(1.0f / 256);
		if constexpr (bCopied)
		{
			SampleCopy(Column, Row, WeightX, WeightY, Out);
		}
		else
		{
			SampleStored(Column, Row, WeightX, WeightY, Out);
		}
	}

private:
	/** The calling thread's copy is that of the last pass that made one. */
	void CopyTexels(uint64_t Pass)
	{
		constexpr size_t HeaderBytes = 64;
		const FKernelMip& Mip = Table->Mips[0];
		Pitch = RoundUpTo((Mip.SizeX + 2) * C, 16);
		const size_t Floats = size_t(Pitch) * size_t(Mip.SizeY + 2) + C * N; // whole steps are written
		auto* const Memory =
			static_cast<uint8_t*>(GetTapMemory(ColorTableMemory, HeaderBytes + Floats * sizeof(float)));
		auto* const Texels = reinterpret_cast<float*>(Memory + HeaderBytes);
		Copy = Texels;
		uint64_t Known;
		__builtin_memcpy(&Known, Memory, sizeof(Known));
		for (int32_t Row = -1; Row <= Mip.SizeY && Known != Pass; ++Row)
		{
			const int32_t Y = Row < 0 ? 0 : Row < Mip.SizeY ? Row : Mip.SizeY - 1;
			DecodeHeldStrip<N, C>(Table->Storage, Mip.Data + int64_t(Y) * Mip.RowPitch, 0, Mip.SizeX, -1, Mip.SizeX + 2,
				Texels + int64_t(Row + 1) * Pitch);
		}
		__builtin_memcpy(Memory, &Pass, sizeof(Pass));
	}

	/** N / 8 pairs of texels at Places. */
	static DRYDOCK_LANES_INLINE FFloat LoadPairs(const float* Texels, const int32_t* Places)
	{
#if DRYDOCK_LANES_LEVEL >= 4
		if constexpr (N == 16)
		{
			const __m256d Low = _mm256_loadu_pd(reinterpret_cast<const double*>(Texels + Places[0]));
			const __m256d High = _mm256_loadu_pd(reinterpret_cast<const double*>(Texels + Places[1]));
			return FFloat(_mm512_insertf64x4(_mm512_castpd256_pd512(Low), High, 1));
		}
#endif
		return LoadRaw<FFloat>(Texels + Places[0]);
	}

	/** The pairs of texels from First on, their two rows mixed. */
	template<int First>
	DRYDOCK_LANES_INLINE FFloat MixRows(const int32_t* Places, FFloat WeightY) const
	{
		const FFloat Top = LoadPairs(Copy, Places + First);
		const FFloat Bottom = LoadPairs(Copy + Pitch, Places + First);
		const FFloat Weight = ShuffleLanes(WeightY, WeightY, [](int Lane) { return Lane / (2 * C) + First; });
		return Top + Weight * (Bottom - Top);
	}

	/** Vector i of the texels of N places. */
	template<int i>
	DRYDOCK_LANES_INLINE FFloat MixTexels(const int32_t* Places, FFloat WeightX, FFloat WeightY) const
	{
		constexpr int PairsOfVector = N / 8;
		const FFloat LowPairs = MixRows<2 * i * PairsOfVector>(Places, WeightY);
		const FFloat HighPairs = MixRows<(2 * i + 1) * PairsOfVector>(Places, WeightY);
		const FFloat Left = PickTexels<C, 0>(LowPairs, HighPairs);
		const FFloat Right = PickTexels<C, 1>(LowPairs, HighPairs);
		const FFloat Weight = ShuffleLanes(WeightX, WeightX, [](int Lane) { return Lane / C + i * (N / C); });
		return Left + Weight * (Right - Left);
	}

	/** Numbers of 0 and above: a weight of 0 need not be asked for. */
	DRYDOCK_LANES_INLINE void SampleCopy(
		TInt<N> Column, TInt<N> Row, FFloat WeightX, FFloat WeightY, FFloat Out[3]) const
	{
		if constexpr (N >= 8)
		{
			const FKernelMip& Mip = Table->Mips[0];
			const FInt HeldColumn = Max(Min(Column, TInt<N>(Mip.SizeX - 1)), TInt<N>(-1)).V + 1;
			const FInt HeldRow = Max(Min(Row, TInt<N>(Mip.SizeY - 1)), TInt<N>(-1)).V + 1;
			alignas(64) int32_t Places[N];
			StoreRaw(Places, HeldRow * Pitch + HeldColumn * C);
			const FFloat Texels[C] = {MixTexels<0>(Places, WeightX, WeightY), MixTexels<1>(Places, WeightX, WeightY),
				MixTexels<2>(Places, WeightX, WeightY), MixTexels<3>(Places, WeightX, WeightY)};
			FFloat Channels[C];
			TLaneOps<N>::Split(Texels, Channels);
			for (int c = 0; c < 3; ++c)
			{
				Out[c] = Channels[c];
			}
		}
	}

	DRYDOCK_LANES_INLINE void SampleStored(
		TInt<N> Column, TInt<N> Row, FFloat WeightX, FFloat WeightY, FFloat Out[3]) const
	{
		const FKernelMip& Mip = Table->Mips[0];
		const int32_t Bytes = GetTexelStorageInfo(Table->Storage).BytesPerTexel;
		const auto Hold = [](TInt<N> Index, int32_t Size)
		{
			return Max(Min(Index, TInt<N>(Size - 1)), TInt<N>(0)).V;
		};
		const FInt Left = Hold(Column, Mip.SizeX);
		const FInt Right = WeightX == 0.0f ? Left : Hold(Column + TInt<N>(1), Mip.SizeX);
		const FInt Top = Hold(Row, Mip.SizeY);
		const FInt Bottom = WeightY == 0.0f ? Top : Hold(Row + TInt<N>(1), Mip.SizeY);
		FFloat Corners[4][4];
		for (int i = 0; i < 4; ++i)
		{
			const FInt Offsets = ((i & 1) == 0 ? Top : Bottom) * Mip.RowPitch + (i < 2 ? Left : Right) * Bytes;
			GatherTexels<float, N>(Table->Storage, Mip.Data, Offsets, Corners[i]);
		}
		const auto Blend = [](FFloat A, FFloat B, FFloat Weight)
		{
			return Weight == 0.0f ? A : MixCarefully<N>(A, B, Weight);
		};
		for (int c = 0; c < 3; ++c)
		{
			Out[c] = Blend(
				Blend(Corners[0][c], Corners[1][c], WeightY), Blend(Corners[2][c], Corners[3][c], WeightY), WeightX);
		}
	}

	const FKernelTexture* Table = nullptr; // addressed clamped
	const float* Copy = nullptr;           // with the edge texels once more around it
	int32_t Pitch = 0;                     // floats of its rows
};

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
