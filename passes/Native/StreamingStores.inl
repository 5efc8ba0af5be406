// Stores that go past the caches: to a texture that no cache can hold, they save reading each line before it is
// written. Included by the lanes code of native kernels only.
#pragma once

#include "LanesFormats.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** A wide texture beyond this is out of the caches before the next pass reads it. */
constexpr int64_t GStreamedBytes = 24 << 20;

/** Vectors of N floats to whole texels, of a format that keeps four channels as they are, 32 or 16 bits each. */
template<int N, typename FFormat>
DRYDOCK_LANES_INLINE void StreamTexels(uint8_t* P, TRaw<float, N> X)
{
	if constexpr (FFormat::Storage == ETexelStorage::RGBA32_FLOAT)
	{
#if DRYDOCK_LANES_LEVEL >= 4
		_mm512_stream_ps(reinterpret_cast<float*>(P), __m512(X));
#elif DRYDOCK_LANES_LEVEL >= 3
		_mm256_stream_ps(reinterpret_cast<float*>(P), __m256(X));
#else
		_mm_stream_ps(reinterpret_cast<float*>(P), __m128(X));
#endif
	}
	else
	{
#if DRYDOCK_LANES_LEVEL >= 4
		_mm256_stream_si256(reinterpret_cast<__m256i*>(P), _mm512_cvtps_ph(__m512(X), 0));
#elif DRYDOCK_LANES_LEVEL >= 3
		_mm_stream_si128(reinterpret_cast<__m128i*>(P), _mm256_cvtps_ph(__m256(X), 0));
#else
		FFormat::template Store<N>(P, X);
#endif
	}
}

/** Whether rows of a target may go past the caches: Place is that of the first texel of one. */
inline bool IsStreamed(const FKernelTexture& Target, const uint8_t* Place)
{
	const FKernelMip& Mip = Target.Mips[0];
	const bool bWide = Target.Storage == ETexelStorage::RGBA32_FLOAT || Target.Storage == ETexelStorage::RGBA16_FLOAT;
	return bWide && Target.bSaturateStore == 0 && reinterpret_cast<uintptr_t>(Place) % 64 == 0 &&
		   int64_t(Mip.RowPitch) * Mip.SizeY > GStreamedBytes;
}

/** Before other threads read what was streamed. */
DRYDOCK_LANES_INLINE void FinishStreaming()
{
	_mm_sfence();
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
