// Checks a second run of the same frame.
#include "Inspect/FirstCause.h"

#include "Inspect/CheckCapture.h"
#include "Run/Run.h"
#include "Text/ConfigErrors.h"

#include <algorithm>

namespace Drydock
{

bool MadeNonFinite(const std::vector<FDiagnostic>& Diagnostics)
{
	const auto Has = [&Diagnostics](int Code)
	{
		return std::any_of(Diagnostics.begin(), Diagnostics.end(),
			[Code](const FDiagnostic& Diagnostic) { return Diagnostic.Code == Code; });
	};
	return (Has(WarnNonFinite) || Has(ErrorNonFinite)) && !Has(WarnNonFiniteSpread);
}

std::vector<FDiagnostic> FindFirstCause(const FRunOptions& Options)
{
	FCheckCapture Capture(MakeCheckSet({"nan", "overflow"}));
	try
	{
		FRunOptions Again = Options;
		Again.Progress = nullptr;
		Again.bMeasureEffects = false;
		const FScopedDispatchObserver Scope(Capture);
		RunConfig(Again);
	}
	catch (const FError&)
	{
		// The run's own error, which has been told.
	}
	std::vector<FDiagnostic> Found = Capture.GetDiagnostics();
	Found.resize(std::min<size_t>(Found.size(), 1));
	return Found;
}

} // namespace Drydock
