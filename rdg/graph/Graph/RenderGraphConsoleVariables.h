// Declares the r.RDG.* console variables. All of the engine's names exist; variables that only steer a GPU or threads
// are not read, and their help reports this. Source: engine RenderGraphPrivate.cpp.
#pragma once

#include "CoreMinimal.h"

namespace Drydock
{

/** Values of one moment. */
struct FRDGSettings
{
	bool bImmediateMode = false;
	bool bValidation = true;
	bool bStrictValidation = false;
	int32 Debug = 0;
	bool bExtendResourceLifetimes = false;
	bool bDisableTransientResources = false;
	int32 ClobberResources = 0; // 1: 1000, 2: NaN, 3: +Inf in what was never written
	bool bOverlapUAVs = true;
	int32 AsyncCompute = 1; // 0 off, 1 tagged passes, 2 all compute passes
	bool bCullPasses = true;
	bool bMergeRenderPasses = true;
	int32 TransientAllocator = 1; // 0 off, 1 on, 2 only for FastVRAM
	bool bTransientIndirectArguments = false;
	int32 Events = 1;
};

DRYDOCK_API FRDGSettings GetRDGSettings();

/** One less on each call while r.RDG.TransitionLog is positive; true when this graph's transitions are to be logged. */
DRYDOCK_API bool ConsumeRDGTransitionLog();

/** r.RDG.Debug.GraphFilter, PassFilter and ResourceFilter: whether Name passes the filter (a substring; "!x" inverts;
 * empty and "None" pass all). */
DRYDOCK_API bool PassesRDGGraphFilter(const TCHAR* Name);
DRYDOCK_API bool PassesRDGPassFilter(const TCHAR* Name);
DRYDOCK_API bool PassesRDGResourceFilter(const TCHAR* Name);

} // namespace Drydock
