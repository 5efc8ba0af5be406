// Feature levels. One machine, one level: everything asks for SM5 or SM6 and gets it. Source: engine RHIFeatureLevel.h.
#pragma once

#include "CoreMinimal.h"

namespace ERHIFeatureLevel
{
enum Type : int
{
	ES2_REMOVED,
	ES3_1,
	SM4_REMOVED,
	SM5,
	SM6,
	Num,
};
}

/** The level that GetGlobalShaderMap and permutation checks are asked with. */
inline constexpr ERHIFeatureLevel::Type GMaxRHIFeatureLevel = ERHIFeatureLevel::SM5;
