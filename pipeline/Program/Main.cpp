// The program: calls the verb that the arguments name, and turns errors into exit codes.
#include "Diagnostics.h"
#include "Program/CommandLine.h"
#include "Program/ProgramOutput.h"

#include <cstdio>

int main(int NumArguments, char** Arguments)
{
	try
	{
		return Drydock::CallProgram({Arguments + (NumArguments > 0 ? 1 : 0), Arguments + NumArguments});
	}
	catch (const Drydock::FError& Error)
	{
		Drydock::PrintDiagnostics(Error.GetDiagnostics());
		return Error.GetExitCode();
	}
	catch (const std::exception& Error)
	{
		std::fprintf(stderr, "drydock: internal error: %s\n", Error.what());
		return Drydock::ExitInternal;
	}
}
