// Writes the suite of a verb, also where the verb fails.
#include "Program/JUnitOption.h"

#include "DiagnosticList.h"
#include "Program/ArgumentParser.h"
#include "Program/ProgramFailure.h"
#include "TextTools.h"

namespace Drydock
{

void AddJUnit(FVerbOptions& Verb, std::string& File, const char* Cases)
{
	Verb.Add("--junit", File, std::string("Write JUnit XML for build servers: a suite with ") + Cases).SetType("FILE");
}

int CallWithJUnit(const std::string& File, const std::string& SuiteName, const std::function<int(FJUnitSuite&)>& Call)
{
	FJUnitSuite Suite{SuiteName};
	if (File.empty())
	{
		return Call(Suite);
	}
	try
	{
		const int ExitCode = Call(Suite);
		WriteJUnit(File, {Suite});
		return ExitCode;
	}
	catch (...)
	{
		const FError Error = ExplainFailure(std::current_exception());
		std::string Message = JoinText(SummarizeDiagnostics(Error.GetDiagnostics()), "\n",
			[&](const FDiagnostic& Diagnostic) { return Diagnostic.ToString(); });
		Suite.Cases.push_back({.Name = "runs", .Outcome = EJUnitOutcome::Broken, .Message = Message});
		WriteJUnit(File, {Suite});
		throw;
	}
}

} // namespace Drydock
