// Transitions between access states. Source: engine RHITransition.h.
#pragma once

#include "RHIAccess.h"
#include "RHIResource.h"

struct FRHITransitionInfo
{
	FRHITransitionInfo(FRHIResource* InResource, ERHIAccess InBefore, ERHIAccess InAfter)
		: Resource(InResource)
		, AccessBefore(InBefore)
		, AccessAfter(InAfter)
	{
	}

	FRHIResource* Resource;
	ERHIAccess AccessBefore;
	ERHIAccess AccessAfter;
};
