// `drydock prove`: a config under every promised equivalence.
#include "Program/ProgressBar.h"
#include "Program/ProgramOutput.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Prove/Prove.h"

#include <algorithm>
#include <memory>

namespace Drydock
{

namespace
{

struct FProveVerbOptions : FProveOptions
{
	bool bJson = false;
};

int Prove(FProveVerbOptions Options)
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
	const bool bHolds = std::all_of(Proven.begin(), Proven.end(), [](const FProven& One) { return One.Holds(); });
	return bHolds ? ExitDone : ExitPolicy;
}

} // namespace

FVerbCall AddProveOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FProveVerbOptions>();
	AddConfig(Verb, Options->Run);
	Verb.Add("--only", Options->Only, "Check only these equivalences, by name; with * and ?").SetType("PATTERN");
	Verb.AddFlag("--json", Options->bJson, "Print JSON");
	return CallWith(Options, Prove);
}

} // namespace Drydock
