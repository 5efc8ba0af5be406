// Source: drydock.
#include "RunSetup.h"

#include "ConfigReader.h"
#include "FinalSettings.h"
#include "SceneSuggestions.h"

namespace Drydock
{

namespace
{

const char* GetStorageValue(const FRunOptions& Options)
{
	switch (Options.Storage)
	{
	case ERunStorage::Native:
		return "0";
	case ERunStorage::Float32:
		return "1";
	case ERunStorage::Float64:
		return "2";
	case ERunStorage::Default:
		break;
	}
	return Options.bDouble ? "2" : "";
}

/** Values that are valid, but that this build cannot act on. */
void WarnOfIneffectiveValues(const FConfig& Config, const FChainSettings& Chain, std::vector<FDiagnostic>& Diagnostics)
{
	FConfigMessages Messages(Config.File, Diagnostics);
	const FConfigPlace Nowhere;
	const int32 AntiAliasing = IConsoleManager::Get().FindConsoleVariable(TEXT("r.AntiAliasingMethod"))->GetInt();
	if (AntiAliasing < 0 || AntiAliasing > 1)
	{
		Messages.Warn(WarnIneffectiveValue, Nowhere,
			"r.AntiAliasingMethod " + std::to_string(AntiAliasing) + " is not simulated: no antialiasing runs");
	}
	if (Chain.Settings.BloomMethod != BM_SOG)
	{
		Messages.Warn(WarnNotBuilt, Nowhere, "BloomMethod BM_FFT is not built yet: the Gaussian sum runs");
	}
	if (!Chain.ShowFlags.PostProcessing || !Chain.ShowFlags.Tonemapper)
	{
		Messages.Warn(WarnNotBuilt, Nowhere, "gamma-only output is not built yet: the film curve runs");
	}
}

} // namespace

FRunVariables::~FRunVariables()
{
	while (!Scopes.empty())
	{
		Scopes.pop_back(); // last set, first restored
	}
}

void FRunVariables::Set(const std::string& Name, const std::string& Value)
{
	Scopes.push_back(std::make_unique<FScopedConsoleVariable>(Name.c_str(), FString(Value.c_str())));
}

FRunSetup::FRunSetup(const FRunOptions& Options)
{
	Config = Options.ConfigText ? ReadConfig(*Options.ConfigText, Options.ConfigFile, Diagnostics)
								: LoadConfig(Options.ConfigFile, Diagnostics);
	for (const std::string& Argument : Options.Settings)
	{
		AddSettingArgument(Config, Argument, Diagnostics);
	}
	for (const std::string& Argument : Options.Variables)
	{
		AddVariableArgument(Config, Argument, Diagnostics);
	}
	if (HasErrors(Diagnostics))
	{
		throw FError(Diagnostics, ExitUsage);
	}
	if (Options.Location)
	{
		Config.View.Location = {*Options.Location, {1, 1, "--at"}};
	}
	CompleteFromScene(Config, Diagnostics);
	for (const FConfigVariable& Variable : Config.Variables)
	{
		Variables.Set(Variable.Name, Variable.Value);
	}
	if (Options.bDouble)
	{
		Variables.Set("r.Drydock.Precision", "1");
	}
	if (GetStorageValue(Options)[0] != '\0')
	{
		Variables.Set("r.Drydock.Storage", GetStorageValue(Options));
	}
	if (Options.Threads)
	{
		Variables.Set("r.Drydock.Threads", std::to_string(*Options.Threads));
	}
	Chain = MakeChainSettings(Config, &Diagnostics);
	WarnOfIneffectiveValues(Config, Chain, Diagnostics);
	Effects = DecideEffects(Chain);
	Dump = Config.Dump;
	for (const std::string& Pattern : Options.Dump)
	{
		Dump.push_back({Pattern, {0, 0, "--dump"}});
	}
}

} // namespace Drydock
