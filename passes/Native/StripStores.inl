// Strips of floats encoded into a row of the target, past the caches where it is too large for them. Included by the
// lanes code of native kernels only.
#pragma once

#include "Native/StreamingStores.inl"
#include "Native/TexelStrips.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

template<int N, typename FFormat>
inline void StreamStrip(const FKernelTexture& Target, const float* Strip, int32_t Count, uint8_t* Place)
{
	constexpr int32_t Step = N / 4;
	const int32_t Whole = Count / Step * Step;
	for (int32_t i = 0; i < Whole; i += Step)
	{
		StreamTexels<N, FFormat>(Place + i * FFormat::Bytes, LoadRaw<TRaw<float, N>>(Strip + 4 * i));
	}
	EncodeStrip<N, 4>(Target, Strip + Whole * 4, Count - Whole, Place + Whole * FFormat::Bytes);
}

/** Count texels of a strip to the target's row Y from column X on. Strip is read in whole steps. */
template<int N, int C>
inline void StoreStrip(const FKernelTexture& Target, const float* Strip, int32_t X, int32_t Y, int32_t Count)
{
	const FKernelMip& Mip = Target.Mips[0];
	uint8_t* const Place =
		Mip.Data + int64_t(Y) * Mip.RowPitch + int64_t(X) * GetTexelStorageInfo(Target.Storage).BytesPerTexel;
	if (C != 4 || !IsStreamed(Target, Place))
	{
		EncodeStrip<N, C>(Target, Strip, Count, Place);
	}
	else if (Target.Storage == ETexelStorage::RGBA32_FLOAT)
	{
		StreamStrip<N, FRgba32Format>(Target, Strip, Count, Place);
	}
	else
	{
		StreamStrip<N, FRgba16Format>(Target, Strip, Count, Place);
	}
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
