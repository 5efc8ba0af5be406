// `drydock completion`, `man` and `schema`: print what shells, readers and editors need, made from what the program
// knows.
#include "Extensions/PublishedSchema.h"
#include "PrintText.h"
#include "Program/CommandLine.h"
#include "Program/CompletionScript.h"
#include "Program/ManPage.h"
#include "Program/ProgramOutput.h"
#include "Program/VerbOptions.h"
#include "Run/RunSetup.h"

#include <cstdio>
#include <memory>
#include <optional>

namespace Drydock
{

FVerbCall AddCompletion(FVerbOptions& Verb)
{
	const auto Shell = std::make_shared<std::string>();
	Verb.Add("SHELL", *Shell, "Name of the shell").Require().RequireOneOf({"bash", "zsh"});
	return [Shell]
	{
		const FProgramModel Model = MakeProgramModel();
		PrintText(stdout, (*Shell == "bash" ? MakeBashCompletion : MakeZshCompletion)(Model));
		return ExitDone;
	};
}

FVerbCall AddMan(FVerbOptions&)
{
	return []
	{
		PrintText(stdout, MakeManPage(MakeProgramModel()));
		return ExitDone;
	};
}

FVerbCall AddSchema(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FRunOptions>();
	Verb.Add("CONFIG", Options->ConfigFile, "Add the names that this config's plugins bring; none by default");
	AddTrust(Verb, *Options);
	return [Options]
	{
		std::optional<FRunSetup> Setup; // keeps the plugins
		if (!Options->ConfigFile.empty())
		{
			Setup.emplace(*Options);
			PrintDiagnostics(Setup->Diagnostics);
		}
		PrintText(stdout, MakePublishedSchema());
		return ExitDone;
	};
}

} // namespace Drydock
