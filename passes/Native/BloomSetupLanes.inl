// The bloom setup of a tile, pack by pack: the shader's operations in its order (PostProcessBloom.usf), on rows that
// are decoded and mixed once. Included by BloomSetup_*.cpp only.
#pragma once

#include "Native/BloomSetupLanes.h"
#include "Native/LocalExposureLanes.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

template<int N>
class TBloomSetupTile
{
	using FLanes = TReal<float, N>;
	using FFloat = TRaw<float, N>;

public:
	TBloomSetupTile(const FBloomSetupJob& InJob, const FKernelTexture& InTarget, const FKernelTile& InTile)
		: Job(InJob)
		, Target(InTarget)
		, Tile(InTile)
	{
	}

	/** False where the shader has to do it. */
	bool Open()
	{
		const size_t Bytes = TSampledTile<N>::GetBytes(Tile.MaxX - Tile.MinX, Tile.MaxY - Tile.MinY);
		auto* const Memory = static_cast<uint8_t*>(GetTapMemory(PlacesMemory, 2 * Bytes));
		constexpr FViewportAxis Centers[2] = {};
		if (!Input.Open(Job.Input, Centers, Tile, 3, 0, Memory) ||
			(Job.bToon && !Toon.Open(Job.Toon, Centers, Tile, 3, 1, Memory + Bytes)) ||
			(Job.bLocalExposure && !LocalExposure.Open(Job.LocalExposure, Job.LocalExposureViewport, Tile, 2)))
		{
			return false;
		}
		const size_t InputFloats = 3 * size_t(Input.Rows.Stride);
		const size_t ToonFloats = Job.bToon ? 3 * size_t(Toon.Rows.Stride) : 0;
		InputMixed = static_cast<float*>(GetTapMemory(MixedRowsMemory, (InputFloats + ToonFloats) * sizeof(float)));
		ToonMixed = InputMixed + InputFloats;
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
				FLanes Color[3];
				RunPack(X, Color);
				const FFloat Values[4] = {Color[0].V, Color[1].V, Color[2].V, FFloat{}};
				StorePack<N>(Target, Place + int64_t(X) * Bytes, Width - X, Values);
			}
		}
	}

private:
	void BeginRow(int32_t Row)
	{
		Input.MixRow(Row, InputMixed, InputRows);
		if (Job.bToon)
		{
			Toon.MixRow(Row, ToonMixed, ToonRows);
		}
		if (Job.bLocalExposure)
		{
			LocalExposure.BeginRow(Row);
		}
	}

	FLanes GetThresholdRamp(const FLanes Linear[3]) const
	{
		const FLanes Luminance = Linear[0] * FLanes(0.3f) + Linear[1] * FLanes(0.59f) + Linear[2] * FLanes(0.11f);
		const FLanes Above = Luminance * FLanes(Job.ExposureScale) - FLanes(Job.Threshold);
		return Clamp(Above * FLanes(0.5f), FLanes(0.0f), FLanes(1.0f));
	}

	DRYDOCK_LANES_INLINE void RunPack(int32_t X, FLanes Out[3]) const
	{
		constexpr float Brightest = 65536.0f;
		FLanes Scene[3];
		for (int c = 0; c < 3; ++c)
		{
			Scene[c] = Input.Columns.template Sample<true>(InputRows[c], X);
		}
		const FLanes Factor = Job.bLocalExposure ? LocalExposure.GetFactor(Scene, X) : FLanes(1.0f);
		FLanes Linear[3];
		for (int c = 0; c < 3; ++c)
		{
			Linear[c] = Scene[c] * FLanes(Job.OneOverPreExposure);
			Linear[c] = Min(Job.bLocalExposure ? Linear[c] * Factor : Linear[c], FLanes(Brightest));
		}
		const FLanes Ramp = Job.bThreshold ? GetThresholdRamp(Linear) : FLanes(1.0f);
		for (int c = 0; c < 3; ++c)
		{
			Out[c] = Job.bThreshold ? Linear[c] * Ramp : Linear[c];
			Out[c] = Out[c] * FLanes(Job.PreExposure);
			if (Job.bToon)
			{
				const FLanes Color = Toon.Columns.template Sample<true>(ToonRows[c], X);
				const FLanes LinearToon = Color * FLanes(Job.OneOverPreExposure);
				const TMask<N> bTouched = Color < Scene[c] || Color > Scene[c];
				const FLanes Limit =
					Select(bTouched, FLanes(Brightest * Max(Job.ToonIntensity, 1.0f)), FLanes(Brightest));
				Out[c] = Min(Job.bLocalExposure ? LinearToon * Factor : LinearToon, Limit);
				Out[c] = (Job.bThreshold ? Out[c] * Ramp : Out[c]) * FLanes(Job.PreExposure);
			}
		}
	}

	const FBloomSetupJob& Job;
	const FKernelTexture& Target;
	const FKernelTile Tile;
	TSampledTile<N> Input;
	TSampledTile<N> Toon;
	TLocalExposure<N> LocalExposure;
	float* InputMixed = nullptr;
	float* ToonMixed = nullptr;
	const float* InputRows[3] = {};
	const float* ToonRows[3] = {};
};

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes

namespace Drydock
{

template<int N>
bool TBloomSetupLanes<N>::Run(const FBloomSetupJob& Job, const FKernelTexture& Target, const FKernelTile& Pixels)
{
	constexpr int32_t Columns = 256; // rows of so many stay in the first cache
	FKernelTile Part = Pixels;
	bool bOpen = true;
	for (; bOpen && Part.MinX < Pixels.MaxX; Part.MinX = Part.MaxX)
	{
		Part.MaxX = Part.MinX + Columns < Pixels.MaxX ? Part.MinX + Columns : Pixels.MaxX;
		Lanes::TBloomSetupTile<N> Tile(Job, Target, Part);
		bOpen = Tile.Open();
		if (bOpen)
		{
			Tile.Run();
		}
	}
	return bOpen;
}

} // namespace Drydock
