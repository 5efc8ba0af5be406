// The factor of local exposure for packs of a tile, with the shader's bits: what of the grid the tile needs is copied
// out once and mixed once for a row; a pack then mixes along the row and the depth. Included by lanes code of native
// kernels only.
#pragma once

#include "Native/LocalExposureLanes.h"
#include "Native/SeparableSamples.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

template<int N>
class TLocalExposure
{
	using FLanes = TReal<float, N>;
	using FFloat = TRaw<float, N>;
	using FInt = TRaw<int32_t, N>;

public:
	/** Uses the rows of that number, TableMemory and SumsMemory. False where the shader has to do it. */
	bool Open(const FLocalExposureJob& InJob, const FViewportAxis Viewport[2], const FKernelTile& Tile, int32_t Number)
	{
		Job = &InJob;
		const int32_t Width = Tile.MaxX - Tile.MinX;
		const int32_t Height = Tile.MaxY - Tile.MinY;
		const size_t Bytes = TSampledTile<N>::GetBytes(Width, Height);
		auto* const Memory = static_cast<uint8_t*>(GetTapMemory(TableMemory, 2 * Bytes));
		if (!Blurred.Open(Job->Blurred, Viewport, Tile, 1, Number, Memory))
		{
			return false;
		}
		const FKernelMip& Mip = Job->Grid->Mips[0];
		Columns = TSampleColumns<N>(Memory + Bytes, Width);
		RowPlaces = reinterpret_cast<int32_t*>(Memory + Bytes + TSampleColumns<N>::GetBytes(Width));
		const auto Across = [&](FLanes Position)
		{
			return Position * FLanes(Job->GridScale[0]);
		};
		const auto Down = [&](FLanes Position)
		{
			return Position * FLanes(Job->GridScale[1]);
		};
		FTexelRange X;
		FTexelRange Y;
		if (!FindSampledPlaces<N>(Viewport[0], Tile.MinX, Width, Mip.SizeX, Columns.Below, X, Across) ||
			!FindSampledPlaces<N>(Viewport[1], Tile.MinY, Height, Mip.SizeY, RowPlaces, Y, Down))
		{
			return false;
		}
		Columns.Finish(Width, X.Begin);
		CopyGrid(X, Y);
		LogExposure = Log2(FLanes(Job->EyeAdaptation[0]));
		LogMiddleGrey = Log2(FLanes(0.18f * Job->EyeAdaptation[3] * Job->MiddleGreyExposureCompensation));
		return true;
	}

	void BeginRow(int32_t Row)
	{
		Blurred.MixRow(Row, BlurredMixed, &BlurredRow);
		const int32_t Place = RowPlaces[Row];
		const float Weight = WeightOfNext(Place);
		const float* const A = Grid + size_t(TexelBelow(Place) - FirstGridRow) * RowFloats;
		GridRow = A;
		if (Weight != 0)
		{
			for (size_t i = 0; i < RowFloats; i += N)
			{
				StoreRaw(GridMixed + i, MixCarefully<N>(LoadRaw<FFloat>(A + i), LoadRaw<FFloat>(A + RowFloats + i),
											Broadcast<float, N>(Weight)));
			}
			GridRow = GridMixed;
		}
	}

	/** The factor for colours as stored, of the pack at column X. */
	FLanes GetFactor(const FLanes Color[3], int32_t X) const
	{
		constexpr float Third = 1.0f / 3.0f;
		const FLanes Mean = Color[0] * FLanes(Third) + Color[1] * FLanes(Third) + Color[2] * FLanes(Third);
		const FLanes Bounded = Min(Max(Mean, FLanes(0.0f)), FLanes(65536.0f));
		const FLanes LogLuminance = Log2(Max(Bounded * FLanes(Job->OneOverPreExposure), FLanes(Job->LuminanceMin)));
		const FLanes Base = GetBase(LogLuminance, X) + LogExposure;

		const FLanes Zero = 0.0f;
		const FLanes Centered = Base - LogMiddleGrey;
		const TMask<N> bAbove = Centered > Zero;
		const FLanes Contrast = Select(bAbove, FLanes(Job->HighlightContrastScale), FLanes(Job->ShadowContrastScale));
		const FLanes Threshold = Select(bAbove, FLanes(Job->HighlightThreshold), FLanes(Job->ShadowThreshold));
		const FLanes Beyond = Max(Abs(Centered) - Threshold, Zero);
		const FLanes Compression = (Contrast - FLanes(1.0f)) * Beyond;
		const FLanes Detail = FLanes(Job->DetailStrength - 1.0f) * (LogLuminance + LogExposure - Base);
		const FLanes LogFactor = Compression * Select(bAbove, FLanes(1.0f), FLanes(-1.0f)) + Detail;
		return Exp2(Clamp(LogFactor, FLanes(-64.0f), FLanes(64.0f)));
	}

private:
	/** The columns and rows of the grid that the tile reads, each depth by depth, x and y one after the other. */
	void CopyGrid(const FTexelRange& X, const FTexelRange& Y)
	{
		const FKernelMip& Mip = Job->Grid->Mips[0];
		Depth = Mip.SizeZ;
		Stride = RoundUpTo(Depth, N);
		const int32_t NumColumns = X.End - X.Begin;
		const int32_t NumRows = Y.End - Y.Begin;
		FirstGridRow = Y.Begin;
		RowFloats = size_t(NumColumns) * 2 * size_t(Stride);
		const size_t BlurredFloats = size_t(RoundUpTo(Blurred.Rows.Stride, 16));
		auto* const Memory = static_cast<float*>(
			GetTapMemory(SumsMemory, (BlurredFloats + size_t(NumRows + 1) * RowFloats) * sizeof(float)));
		BlurredMixed = Memory;
		GridMixed = Memory + BlurredFloats;
		float* Out = GridMixed + RowFloats;
		Grid = Out;
		for (int32_t Row = Y.Begin; Row < Y.End; ++Row)
		{
			for (int32_t Column = X.Begin; Column < X.End; ++Column, Out += 2 * Stride)
			{
				const uint8_t* Texel = Mip.Data +
									   int64_t(AddressTexel(Row, Mip.SizeY, EKernelAddress::Clamp)) * Mip.RowPitch +
									   int64_t(AddressTexel(Column, Mip.SizeX, EKernelAddress::Clamp)) * 8;
				for (int32_t Z = 0; Z < Depth; ++Z, Texel += Mip.SlicePitch)
				{
					__builtin_memcpy(Out + Z, Texel, 4);
					__builtin_memcpy(Out + Stride + Z, Texel + 4, 4);
				}
			}
		}
	}

	static DRYDOCK_LANES_INLINE FFloat Mix(FFloat A, FFloat B, FFloat Weight)
	{
		const FFloat Mixed = MixCarefully<N>(A, B, Weight);
		return Weight == 0.0f ? A : Mixed;
	}

	/** log2 luminance of the base layer. */
	FLanes GetBase(FLanes LogLuminance, int32_t X) const
	{
		using FOps = TLaneOps<N>;
		const FLanes Around = Blurred.Columns.template Sample<true>(BlurredRow, X);
		const FLanes Position =
			Clamp(LogLuminance * FLanes(Job->HistogramScale) + FLanes(Job->HistogramBias), FLanes(0.0f), FLanes(1.0f));
		const FLanes W = (Position * FLanes(31.0f) + FLanes(0.5f)) * FLanes(1.0f / 32);
		const FInt Fixed = PlaceOf<N>(W, Depth) - 128;
		const FFloat WeightZ = __builtin_convertvector(Fixed & 255, FFloat) * Broadcast<float, N>(1.0f / 256);
		const TInt<N> Below(Fixed >> 8);
		const TInt<N> Last(Depth - 1);
		const FInt Z0 = Max(Min(Below, Last), TInt<N>(0)).V;
		const FInt Z1 = WeightZ == 0.0f ? Z0 : Max(Min(Below + TInt<N>(1), Last), TInt<N>(0)).V;

		const FInt Column = LoadRaw<FInt>(Columns.Below + X) * (2 * Stride);
		const FFloat WeightX = LoadRaw<FFloat>(Columns.Weights + X);
		const auto* const Base = reinterpret_cast<const uint8_t*>(GridRow);
		const auto Read = [&](FInt Z, int32_t Channel)
		{
			const FInt Offsets = (Column + Z) * 4;
			const uint8_t* const From = Base + size_t(Channel) * size_t(Stride) * 4;
			return Mix(
				FFloat(FOps::Gather(From, Offsets)), FFloat(FOps::Gather(From + size_t(Stride) * 8, Offsets)), WeightX);
		};
		const FLanes Sum(Mix(Read(Z0, 0), Read(Z1, 0), WeightZ));
		const FLanes Share(Mix(Read(Z0, 1), Read(Z1, 1), WeightZ));
		const FLanes Bilateral = Select(Share < FLanes(0.001f), Around, Sum / Share);
		return Lanes::Mix(Bilateral, Around, FLanes(Job->BlurredLuminanceBlend));
	}

	const FLocalExposureJob* Job = nullptr;
	TSampledTile<N> Blurred;
	TSampleColumns<N> Columns;
	int32_t* RowPlaces = nullptr;
	int32_t Depth = 0;
	int32_t Stride = 0;
	int32_t FirstGridRow = 0;
	size_t RowFloats = 0;
	const float* Grid = nullptr;
	float* GridMixed = nullptr;
	float* BlurredMixed = nullptr;
	const float* BlurredRow = nullptr;
	const float* GridRow = nullptr;
	FLanes LogExposure;
	FLanes LogMiddleGrey;
};

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
