// Pipelines of a GPU. Drydock runs one; the graph still reasons with two. Source: engine RHIPipeline.h.
#pragma once

#include "CoreMinimal.h"

enum class ERHIPipeline : uint8
{
	Graphics = 1 << 0,
	AsyncCompute = 1 << 1,
	None = 0,
	All = Graphics | AsyncCompute,
	Num = 2,
};
ENUM_CLASS_FLAGS(ERHIPipeline)
