// Checks a second run of the same frame.
#include "Inspect/FirstCause.h"

#include "Inspect/CheckCapture.h"
#include "Run/Run.h"
#include "Text/ConfigErrors.h"

#include <algorithm>

namespace Drydock
{

namespace
{

/** ", which writes Bloom, BloomDepth" */
std::string ListWritten(const FRDGCompiledGraph& Graph, const std::string& PassName)
{
	std::string List;
	for (const FRDGCompiledPass& Pass : Graph.Passes)
	{
		for (size_t i = 0; Pass.Name == PassName && i < Pass.Uses.size(); ++i)
		{
			const FRDGUse& Use = Pass.Uses[i];
			List += Use.IsWrite() ? (List.empty() ? ", which writes " : ", ") +
										Graph.Resources[static_cast<size_t>(Use.Resource)].Name
								  : std::string();
		}
	}
	return List;
}

} // namespace

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
	FRDGCompiledGraph Graph;
	try
	{
		FRunOptions Again = Options;
		Again.Progress = nullptr;
		Again.bMeasureEffects = false;
		const FScopedDispatchObserver Scope(Capture);
		Graph = RunConfig(Again).Graph;
	}
	catch (const FError&)
	{
		// The run's own error, which has been told.
	}
	std::vector<FDiagnostic> Found = Capture.GetDiagnostics();
	Found.resize(std::min<size_t>(Found.size(), 1));
	if (!Found.empty())
	{
		Found[0].Where += ListWritten(Graph, Capture.GetFindings()[0].Pass);
	}
	return Found;
}

} // namespace Drydock
