// Elements of typed buffers, N at a time: gathered into a row, or spread from one, that goes through the lane code of
// texels. Included by the LanesSampling_*.cpp only.
#pragma once

#include "LanesStores.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** f(Lane, Address) for the lanes whose element exists. */
template<int N, typename F>
DRYDOCK_LANES_INLINE void ForEachElement(const FKernelBuffer& Buffer, const uint32_t* Index, F f)
{
	const uint32_t Bytes = GetTexelStorageInfo(Buffer.Storage).BytesPerTexel;
	const uint32_t NumElements = Buffer.SizeInBytes / Bytes;
	for (int Lane = 0; Lane < N; ++Lane)
	{
		if (Index[Lane] < NumElements)
		{
			f(Lane, Buffer.Data + uint64_t(Index[Lane]) * Bytes);
		}
	}
}

/** Elements that do not exist read 0 in all channels. */
template<typename Real, typename Scalar, int N>
inline void LoadElements(const FKernelBuffer& Buffer, const uint32_t* Index, Scalar* Out)
{
	const int32_t Bytes = GetTexelStorageInfo(Buffer.Storage).BytesPerTexel;
	if constexpr (HasLaneCode<Real, N>)
	{
		alignas(64) uint8_t Row[N * 16] = {};
		TRaw<int32_t, N> Inside = {};
		TRaw<Scalar, N> C[4];
		if (Bytes <= 16)
		{
			VisitTexelSize(Bytes,
				[&](auto Size)
				{
					ForEachElement<N>(Buffer, Index,
						[&](int Lane, const uint8_t* Address)
						{
							__builtin_memcpy(Row + Lane * Size(), Address, Size());
							Inside[Lane] = -1;
						});
				});
			if (LoadTexels<Scalar, N>(Buffer.Storage, Row, C))
			{
				for (int c = 0; c < 4; ++c)
				{
					StoreRaw(Out + c * N, Inside != 0 ? C[c] : TRaw<Scalar, N>{});
				}
				return;
			}
		}
	}
	CountScalarCall<Real, N>(EScalarCall::Buffer);
	__builtin_memset(Out, 0, 4 * N * sizeof(Scalar));
	ForEachElement<N>(Buffer, Index,
		[&](int Lane, const uint8_t* Address)
		{ WriteLane<Scalar, N>(Out, Lane, ReadTexel<Scalar>(Buffer.Storage, Address)); });
}

template<typename Real, typename Scalar, int N>
inline void StoreElements(const FKernelBuffer& Buffer, const int32_t* Mask, const uint32_t* Index, const Scalar* Value)
{
	const int32_t Bytes = GetTexelStorageInfo(Buffer.Storage).BytesPerTexel;
	if constexpr (HasLaneCode<Real, N>)
	{
		alignas(64) uint8_t Row[N * 16];
		if (Bytes <= 16 && StoreTexels<Scalar, N>(Buffer.Storage, false, Row, Value))
		{
			VisitTexelSize(Bytes,
				[&](auto Size)
				{
					ForEachElement<N>(Buffer, Index,
						[&](int Lane, uint8_t* Address)
						{
							if (Mask[Lane])
							{
								__builtin_memcpy(Address, Row + Lane * Size(), Size());
							}
						});
				});
			return;
		}
	}
	CountScalarCall<Real, N>(EScalarCall::Buffer);
	ForEachElement<N>(Buffer, Index,
		[&](int Lane, uint8_t* Address)
		{
			if (Mask[Lane])
			{
				const Scalar RGBA[4] = {Value[Lane], Value[N + Lane], Value[2 * N + Lane], Value[3 * N + Lane]};
				EncodeTexel(Buffer.Storage, RGBA, Address);
			}
		});
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
