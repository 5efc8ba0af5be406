// Vectors put together of lanes of others, which are chosen when the code is compiled: g++ and clang both have that
// instruction. Included by the lanes code of native kernels only.
#pragma once

#include "LanesTypes.h"

#include <utility>

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

template<typename FChoose, typename V, int... Lane>
DRYDOCK_LANES_INLINE V ShuffleLanes(V A, V B, FChoose, std::integer_sequence<int, Lane...>)
{
	return __builtin_shufflevector(A, B, FChoose()(Lane)...);
}

/** Lane i is lane FChoose()(i) of A and B side by side. */
template<typename FChoose, typename V>
DRYDOCK_LANES_INLINE V ShuffleLanes(V A, V B, FChoose Choose)
{
	return ShuffleLanes(A, B, Choose, std::make_integer_sequence<int, sizeof(V) / sizeof(A[0])>());
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
