// The program: calls the verb that the arguments name, and turns errors into exit codes.
#include "CodeScope.h"
#include "FaultHandlers.h"
#include "Program/CommandLine.h"
#include "Program/EndingSignals.h"
#include "Program/ProgramFailure.h"
#include "Program/ProgramOutput.h"

int main(int NumArguments, char** Arguments)
{
	Drydock::HoldStandardStreams();
	Drydock::CatchEndingSignals();
	Drydock::InstallFaultHandlers();
	const Drydock::FCodeOwner Verb{.Callback = NumArguments > 1 ? "drydock " + std::string(Arguments[1]) : "drydock"};
	const Drydock::FCodeScope Scope(Verb);
	try
	{
		Drydock::CheckStack();
		return Drydock::CallProgram({Arguments + (NumArguments > 0 ? 1 : 0), Arguments + NumArguments});
	}
	catch (...)
	{
		const Drydock::FError Error = Drydock::ExplainFailure(std::current_exception());
		Drydock::PrintDiagnostics(Error.GetDiagnostics());
		return Error.GetExitCode();
	}
}
