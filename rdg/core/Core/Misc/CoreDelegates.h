// Moments of the engine's life that modules wait for. Source: engine Misc/CoreDelegates.h.
#pragma once

#include "Delegates/Delegate.h"
#include "Misc/EngineApi.h"

DECLARE_MULTICAST_DELEGATE(FSimpleMulticastDelegate)
DECLARE_DELEGATE(FSimpleDelegate)

class DRYDOCK_API FCoreDelegates
{
public:
	/** Broadcast by FModuleManager::StartupPendingModules, once for each subscriber. */
	DRYDOCK_API_OnPostEngineInit static FSimpleMulticastDelegate OnPostEngineInit;
	/** The spelling of newer engines. */
	DRYDOCK_API_GetOnPostEngineInit static FSimpleMulticastDelegate& GetOnPostEngineInit() { return OnPostEngineInit; }
	static FSimpleMulticastDelegate OnEnginePreExit;
	static FSimpleMulticastDelegate& GetOnEnginePreExit() { return OnEnginePreExit; }
	/** Before a frame's world ticks, and once the frame is drawn. */
	static FSimpleMulticastDelegate OnBeginFrame;
	static FSimpleMulticastDelegate OnEndFrame;
};
