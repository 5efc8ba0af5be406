// FApp: the application's state. It has no window and no user, and its time is that of the frame. Source: engine
// Misc/App.h.
#pragma once

#include "CoreTypes.h"

class DRYDOCK_API FApp
{
public:
	static bool CanEverRender() { return true; }
	static bool CanEverRenderOrProduceRenderData() { return true; }
	static bool IsUnattended() { return true; }
	static bool IsGame() { return true; }
	static bool IsBenchmarking() { return false; }

	/** Seconds: the real time of the frame, and of the one before it. Before the first frame 0. */
	static double GetCurrentTime() { return CurrentTime; }
	static double GetLastTime() { return LastTime; }
	static void SetCurrentTime(double Seconds) { CurrentTime = Seconds; }
	static void UpdateLastTime() { LastTime = CurrentTime; }
	/** Seconds between the two. Before the first frame 1 / 60, as in the engine. */
	static double GetDeltaTime() { return DeltaTime; }
	static void SetDeltaTime(double Seconds) { DeltaTime = Seconds; }
	/** Seconds of a step where steps are fixed: 1 / 30 unless set. Time is the config's, whatever is set here. */
	static double GetFixedDeltaTime() { return FixedDeltaTime; }
	static void SetFixedDeltaTime(double Seconds) { FixedDeltaTime = Seconds; }
	static bool UseFixedTimeStep() { return false; }

	/** The .uproject that the running plugin is part of, without a folder and ending; empty without one. */
	static const TCHAR* GetProjectName();
	static bool HasProjectName() { return *GetProjectName() != '\0'; }

private:
	static double CurrentTime;
	static double LastTime;
	static double DeltaTime;
	static double FixedDeltaTime;
};
