// Ends the program when a kernel does not end.
#include "KernelWatch.h"

#include "Diagnostics.h"
#include "HAL/IConsoleManager.h"
#include "PrintText.h"

#include <cstdio>
#include <cstdlib>

static TAutoConsoleVariable<float> CVarDrydockShaderSeconds(TEXT("r.Drydock.ShaderSeconds"), 300.0f,
	TEXT("A shader of which no tile ends for this many seconds ends the program with a message: its loop has no end.\n")
		TEXT(" 0: it may take as long as it likes"));

namespace Drydock
{

namespace
{

[[noreturn]] void EndForSilence(const std::string& Shader, const std::string& EntryPoint, double Limit)
{
	char Seconds[32];
	std::snprintf(Seconds, sizeof(Seconds), "%g", Limit);
	const FDiagnostic Diagnostic = {ESeverity::Error, 6040,
		"shader " + Shader + " (entry point '" + EntryPoint + "') has not ended one tile for " + Seconds +
			" s: does each of its loops have an end? (r.Drydock.ShaderSeconds)",
		{}, 0, 0, {}};
	PrintText(stderr, Diagnostic.ToString() + "\n");
	std::fflush(nullptr);
	std::_Exit(ExitUsage);
}

} // namespace

FKernelWatch::FKernelWatch(const std::string& Shader, const std::string& EntryPoint)
{
	const double Limit = CVarDrydockShaderSeconds.GetValueOnAnyThread();
	if (Limit > 0.0)
	{
		Watch.emplace(Limit, [&Shader, &EntryPoint, Limit] { EndForSilence(Shader, EntryPoint, Limit); });
	}
}

FKernelWatch::~FKernelWatch() = default;

} // namespace Drydock
