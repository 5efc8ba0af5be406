// Throws the graph's errors and prints its other messages.
#include "RenderGraphReport.h"

#include "CoreMinimal.h"
#include "PrintText.h"

#include <cstdio>
#include <mutex>
#include <set>

namespace Drydock
{

void ThrowRDGError(int Code, const std::string& Message, const std::string& Where)
{
	FDiagnostic Diagnostic;
	Diagnostic.Code = Code;
	Diagnostic.Message = Message;
	Diagnostic.Where = Where;
	ThrowRDGErrors({Diagnostic});
}

void ThrowRDGErrors(const std::vector<FDiagnostic>& Diagnostics)
{
	throw FError(Diagnostics, ExitUsage);
}

void ReportRDGEnsure(const FDiagnostic& Diagnostic)
{
	const std::string Text = Diagnostic.ToString();
	ensureAlwaysMsgf(false, TEXT("%s"), Text.c_str());
}

void ReportRDGWarning(const FDiagnostic& Diagnostic, bool bOnce)
{
	static std::mutex Mutex;
	static std::set<std::string> Printed;
	const std::string Text = Diagnostic.ToString();
	std::lock_guard Lock(Mutex);
	if (Printed.insert(Text).second || !bOnce)
	{
		PrintText(stderr, Text + "\n");
	}
}

} // namespace Drydock
