// `drydock prove`: a config under every promised equivalence.
#include "Program/FindingsOption.h"
#include "Program/ProgressBar.h"
#include "Program/ProgramOutput.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Prove/Prove.h"
#include "RangeTools.h"

#include <algorithm>
#include <memory>

namespace Drydock
{

namespace
{

struct FProveVerbOptions : FProveOptions
{
	FFindingsOptions Findings;
	bool bJson = false;
};

FJUnitCase MakeCase(const FProven& Proven)
{
	FJUnitCase Case{.Name = Proven.Equivalence->Name, .Rule = Proven.Equivalence->Name};
	Case.Outcome = !Proven.NotRun.empty() ? EJUnitOutcome::Skipped
				   : !Proven.Holds()      ? EJUnitOutcome::Failed
										  : EJUnitOutcome::Passed;
	Case.Message = Proven.NotRun + (Proven.Holds() ? "" : DescribeDifference(Proven));
	return Case;
}

int Prove(FProveVerbOptions Options, FJUnitSuite& Suite)
{
	FProgressBar Bar;
	Options.Progress = [&Bar](int Done, int Total, const std::string& Name)
	{
		Bar.Show(Done, Total, Name);
	};
	const std::vector<FProven> Proven = ProveConfig(Options);
	Bar.Clear();
	const std::string& Config = Options.Run.ConfigFile;
	PrintResult(
		Options.bJson ? MakeProveJson(Config, Proven) : MakeProveText(Config, Proven, GetOutputWidth()), Options.bJson);
	Suite.Cases = ToVector<FJUnitCase>(Proven, MakeCase);
	const bool bHolds = std::all_of(Proven.begin(), Proven.end(), [](const FProven& One) { return One.Holds(); });
	return bHolds ? ExitDone : ExitPolicy;
}

} // namespace

FVerbCall AddProveOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FProveVerbOptions>();
	AddConfig(Verb, Options->Run);
	Verb.Add("--only", Options->Only, "Check only these equivalences, by name; with * and ?").SetType("PATTERN");
	AddFindings(Verb, Options->Findings, "a case for each equivalence");
	Verb.AddFlag("--json", Options->bJson, "Print JSON");
	return [Options]
	{
		return CallWithFindings(Options->Findings, "prove", Options->Run.ConfigFile,
			[&Options](FJUnitSuite& Suite) { return Prove(*Options, Suite); });
	};
}

} // namespace Drydock
