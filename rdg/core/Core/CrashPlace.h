// Finds the lines of source where a crash happened: drydock's own, and the plugin's that called it.
#pragma once

#include "CoreTypes.h"

namespace Drydock
{

/** The place of a crash, in texts that need no memory. */
struct FCrashPlace
{
	/** The instruction lies in a library of drydock, or in a header of drydock that a plugin has compiled. */
	bool bOfDrydock = false;
	char Drydock[256] = ""; // "rdg/core/Core/Containers/Array.h:212"; empty: unknown
	char Plugin[512] = "";  // the plugin's innermost line, "/Plugins/Tint/Source/Tint/Tint.cpp:41"; empty: unknown
	const char* Library = nullptr; // "libTint.so", which that line is compiled into; null: none
	uint64 Offset = 0;             // of the instruction in it
};

/** Makes FindCrashPlace ready; once, before anything can crash. */
void PrepareCrashPlaces();

/** For a handler of signals, on the thread that crashed. Context: the ucontext_t that the handler was given; null: the
 * caller's own stack is searched for a plugin, and nothing is drydock's. Lines come from `addr2line`, which g++ brings;
 * they are unknown where it is missing or the plugin was built without -g. A crash in here leaves OutPlace half filled.
 */
void FindCrashPlace(const void* Context, FCrashPlace& OutPlace);

} // namespace Drydock
