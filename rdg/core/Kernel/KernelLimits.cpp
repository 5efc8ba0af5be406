// Reads the limit, and makes the message.
#include "KernelLimits.h"

#include "Diagnostics.h"
#include "HAL/IConsoleManager.h"
#include "RunningCode.h"

#include <algorithm>
#include <string>

// Loops over all pixels of a picture, by one thread, stay below: 4 million steps. The shortest loop takes them in some
// milliseconds, one with a hundred taps in some seconds.
static TAutoConsoleVariable<int32> CVarDrydockShaderLoopLimit(TEXT("r.Drydock.ShaderLoopLimit"), 1 << 22,
	TEXT("A loop of a shader that goes on after this many turns ends the run with a message (DD6041): it has no end.\n")
		TEXT("Loops from one constant to another do not count.\n") TEXT(" 0: it may take as long as it likes"));

namespace Drydock
{

namespace
{

thread_local FKernelLimits GLimits;

[[noreturn]] void OnEndlessLoop(const char* File, int32_t Line, int32_t X, int32_t Y, int32_t Z)
{
	const FCodeOwner* const Code = GetRunningCode();
	const std::string At = std::to_string(X) + ", " + std::to_string(Y) + (Z ? ", " + std::to_string(Z) : "");
	const std::string Turns = std::to_string(std::max(1, CVarDrydockShaderLoopLimit.GetValueOnAnyThread()));
	throw FError({ESeverity::Error, 6041,
					 "this loop goes on after " + Turns + " turns in the pixel or thread (" + At + ") of " +
						 (Code && !Code->Callback.empty() ? Code->Callback : "a shader") +
						 ": does it have an end? (r.Drydock.ShaderLoopLimit)",
					 File, Line, 0, Code && !Code->Pass.empty() ? "pass " + Code->Pass : ""},
		ExitUsage);
}

} // namespace

const FKernelLimits* GetKernelLimits()
{
	const int32 Turns = CVarDrydockShaderLoopLimit.GetValueOnAnyThread();
	GLimits = {Turns > 0 ? uint32_t(Turns) : 0xFFFFFFFFu, &OnEndlessLoop};
	return &GLimits;
}

} // namespace Drydock
