// Answers which thread this is: every answer is yes, because one thread plays all parts. And which frame this is.
// Source: engine CoreGlobals.h.
#pragma once

#include "CoreTypes.h"
#include "DrydockAPI.h"

inline bool IsInGameThread()
{
	return true;
}
inline bool IsInRenderingThread()
{
	return true;
}
inline bool IsInActualRenderingThread()
{
	return true;
}
inline bool IsInParallelRenderingThread()
{
	return true;
}
inline bool IsInRHIThread()
{
	return true;
}
inline bool IsInAnyRenderingThread()
{
	return true;
}
inline bool IsRunningCommandlet()
{
	return false;
}

inline constexpr bool GIsEditor = false;
inline constexpr bool GIsClient = true;

/** The number of the frame that is rendered; 0 before the first one. */
extern DRYDOCK_API uint32 GFrameNumber;
extern DRYDOCK_API uint32 GFrameNumberRenderThread;
extern DRYDOCK_API uint64 GFrameCounter;
extern DRYDOCK_API uint64 GFrameCounterRenderThread;
