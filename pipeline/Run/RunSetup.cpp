// Takes a run from its options to blended settings, step by step.
#include "Run/RunSetup.h"

#include "Config/ReadConfig.h"
#include "Bloom/PostProcessFFTBloom.h"
#include "Budget/BudgetChoice.h"
#include "Config/ConfigReader.h"
#include "Config/FrameSequence.h"
#include "ExtensionFactory.h"
#include "Extensions/ConfigExtensions.h"
#include "Extensions/InsertedPass.h"
#include "Extensions/Plugins.h"
#include "Run/FinalSettings.h"
#include "SceneFile/SceneSuggestions.h"
#include "SceneFile/TextureFiles.h"
#include "Screen/TextureAssets.h"
#include "SettingObjects.h"

#include <algorithm>

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

/** Pictures that the tonemapper would read, but that are names of engine assets. */
void WarnOfMissingPictures(const FFinalPostProcessSettings& Settings, FConfigMessages& Messages)
{
	const auto Check = [&](const char* Setting, const UTexture* Texture)
	{
		if (Texture != nullptr && !FindTexturePixels(Texture))
		{
			Messages.Warn(WarnIneffectiveValue, FConfigPlace(),
				std::string(Setting) + " " + GetObjectPath(Texture) +
					" has no pixels here, and nothing is done with it: name an image file, relative to the config");
		}
	};
	if (Settings.BloomDirtMaskIntensity > 0.0f)
	{
		Check("BloomDirtMask", Settings.BloomDirtMask.Get());
	}
	for (const FFinalPostProcessSettings::FLUTEntry& Entry : Settings.ContributingLUTs)
	{
		Check("ColorGradingLUT", Entry.LUT.Get());
	}
	if (Settings.ToonShadowBlurIntensity > 0.0f && Settings.ToonShadowBlurBlend == EToonShadowBlurBlend::Max)
	{
		Check("ToonShadowBlurRamp", Settings.ToonShadowBlurRamp.Get());
	}
}

/** Values that are valid, but that this build cannot act on. */
void WarnOfIneffectiveValues(const FConfig& Config, const FViewSettings& View, std::vector<FDiagnostic>& Diagnostics)
{
	FConfigMessages Messages(Config.File, Diagnostics);
	const FConfigPlace Nowhere;
	const int32 AntiAliasing = IConsoleManager::Get().FindConsoleVariable(TEXT("r.AntiAliasingMethod"))->GetInt();
	if (AntiAliasing < 0 || AntiAliasing > 1)
	{
		Messages.Warn(WarnIneffectiveValue, Nowhere,
			"r.AntiAliasingMethod " + std::to_string(AntiAliasing) + " is not simulated: no antialiasing runs");
	}
	const std::string Obstacle = View.Settings.BloomMethod == BM_FFT && View.Settings.BloomIntensity > 0.0f
									 ? GetFFTBloomObstacle(View.Settings, true)
									 : std::string();
	if (!Obstacle.empty())
	{
		Messages.Warn(WarnIneffectiveValue, Nowhere, "BloomMethod BM_FFT: " + Obstacle + ", so the Gaussian sum runs");
	}
	if (View.Settings.ToonShadowBlurRamp != nullptr && View.Settings.ToonShadowBlurIntensity > 0.0f &&
		View.Settings.ToonShadowBlurBlend != EToonShadowBlurBlend::Max)
	{
		Messages.Warn(WarnIneffectiveValue, Nowhere,
			"ToonShadowBlurRamp is read with ToonShadowBlurBlend Max only, and nothing is done with it");
	}
	WarnOfMissingPictures(View.Settings, Messages);
}

FConfigDocument OpenDocument(const FRunOptions& Options)
{
	return Options.ConfigText ? ParseConfigDocument(*Options.ConfigText, Options.ConfigFile)
							  : LoadConfigDocument(Options.ConfigFile);
}

void ThrowErrors(const std::vector<FDiagnostic>& Diagnostics)
{
	if (HasErrors(Diagnostics))
	{
		throw FError(Diagnostics, ExitUsage);
	}
}

/** --set and --exec in the order of the command line, in which an --exec stands behind a number of --set. */
void AddVariableArguments(FConfig& Config, const FRunOptions& Options, std::vector<FDiagnostic>& Diagnostics)
{
	size_t NumVariables = 0;
	const auto AddVariablesUpTo = [&](size_t Count)
	{
		for (; NumVariables < std::min(Count, Options.Variables.size()); ++NumVariables)
		{
			AddVariableArgument(Config, Options.Variables[NumVariables], Diagnostics);
		}
	};
	for (const FRunOptions::FExec& Exec : Options.Exec)
	{
		AddVariablesUpTo(Exec.NumVariablesBefore);
		AddExecArgument(Config, Exec.Text, Diagnostics);
	}
	AddVariablesUpTo(Options.Variables.size());
}

/** The config with the command line's say. Throws FError with all mistakes of both. */
FConfig ReadWithArguments(
	const FConfigDocument& Document, const FRunOptions& Options, std::vector<FDiagnostic>& Diagnostics)
{
	FConfig Config = ReadConfig(Document, Diagnostics);
	for (const std::string& Argument : Options.Settings)
	{
		AddSettingArgument(Config, Argument, Diagnostics);
	}
	AddVariableArguments(Config, Options, Diagnostics);
	WarnOfUnreadSettings(Config, Diagnostics);
	ThrowErrors(Diagnostics);
	ReadStudy(Config, Diagnostics);
	ThrowErrors(Diagnostics);
	Config.bNoSkip = Options.bNoSkip;
	return Config;
}

/** With what a study chose, where the config has a budget and the options want it. */
FConfigOfRun ChooseBudget(FConfig Config, const FRunOptions& Options, std::vector<FDiagnostic>& Diagnostics)
{
	FConfigOfRun OfRun{std::move(Config), Options, ""};
	if (Options.bUseBudget)
	{
		if (const std::optional<FBudgetChoice> Choice = ReadBudgetChoice(OfRun.Config, Options, Diagnostics))
		{
			OfRun.BudgetReason = Choice->Reason;
			ApplyBudgetChoice(*Choice, OfRun.Config, OfRun.Options);
		}
	}
	return OfRun;
}

void ApplyVariables(
	const FConfig& Config, const FRunOptions& Options, FRunVariables& Variables, std::vector<FDiagnostic>& Diagnostics)
{
	for (const FConfigVariable& Variable : Config.Variables)
	{
		Variables.Apply(Variable, Config.File, Diagnostics);
	}
	if (Options.bDouble)
	{
		Variables.Set("r.Drydock.Precision", "1");
	}
	if (GetStorageValue(Options)[0] != '\0')
	{
		Variables.Set("r.Drydock.Storage", GetStorageValue(Options));
	}
	if (Options.bNoSkip)
	{
		Variables.Set("r.RDG.CullPasses", "0");
	}
	if (Options.Threads)
	{
		Variables.Set("r.Drydock.Threads", std::to_string(*Options.Threads));
	}
	IConsoleManager::Get().CallAllConsoleVariableSinks();
}

/** Mistakes are appended to Diagnostics; then there are no extensions. */
FRunExtensions CreateExtensions(const FConfig& Config, std::vector<FDiagnostic>& Diagnostics)
{
	FRunExtensions Made;
	Made.PassResults = std::make_shared<FPassResults>();
	const std::vector<FExtensionRequest> Requests = ReadExtensionRequests(Config, Diagnostics);
	const std::vector<FPassRequest> PassRequests = ReadPassRequests(Config, Diagnostics);
	if (HasErrors(Diagnostics))
	{
		return Made;
	}
	const auto Add = [&Made](
						 const TSharedRef<ISceneViewExtension, ESPMode::ThreadSafe>& Extension, const std::string& Name)
	{
		if (const FExtensionInfo* Known = GEngine->ViewExtensions->FindInfo(*Extension))
		{
			FExtensionInfo Info = *Known;
			Info.Name = Name;
			Info.EngineMinor = AnyEngineVersion;
			GEngine->ViewExtensions->SetInfo(*Extension, Info);
		}
		Made.Extensions.push_back(Extension);
	};
	for (const FExtensionRequest& Request : Requests)
	{
		Add(FindExtensionFactory(Request.Type)->Create(Request.Arguments), Request.Type);
	}
	for (const FPassRequest& Request : PassRequests)
	{
		Add(CreateInsertedPass(Request, Made.PassResults), Request.Name);
	}
	return Made;
}

std::vector<FDiagnostic> Join(std::initializer_list<const std::vector<FDiagnostic>*> Parts)
{
	std::vector<FDiagnostic> All;
	for (const std::vector<FDiagnostic>* const Part : Parts)
	{
		All.insert(All.end(), Part->begin(), Part->end());
	}
	return All;
}

std::vector<TConfigValue<std::string>> ListDumpPatterns(const FConfig& Config, const FRunOptions& Options)
{
	std::vector<TConfigValue<std::string>> Dump = Config.Dump;
	for (const std::string& Pattern : Options.Dump)
	{
		Dump.push_back({Pattern, {0, 0, "--dump"}});
	}
	return Dump;
}

} // namespace

void FRunVariables::Set(const std::string& Name, const std::string& Value)
{
	IConsoleVariable* Variable = IConsoleManager::Get().FindConsoleVariable(Name.c_str());
	checkf(Variable != nullptr, "There is no console variable %s", Name.c_str());
	Variable->Set(Value.c_str(), ECVF_SetByConsole);
}

void FRunVariables::Apply(
	const FConfigVariable& Variable, const std::string& ConfigFile, std::vector<FDiagnostic>& Diagnostics)
{
	IConsoleVariable* Found = IConsoleManager::Get().FindConsoleVariable(Variable.Name.c_str());
	const bool bConsole = Variable.Source == EVariableSource::Console;
	if (Found == nullptr || (bConsole && (Variable.Value.empty() || Variable.Value == "?")))
	{
		IConsoleManager::Get().ProcessUserConsoleInput((Variable.Name + " " + Variable.Value).c_str());
		return;
	}
	const EConsoleVariableFlags SetBy = Variable.Source == EVariableSource::Config ? ECVF_SetByConsoleVariablesIni
										: bConsole                                 ? ECVF_SetByConsole
																				   : ECVF_SetByCommandline;
	const FString Refusal = DescribeRefusedSet(Variable.Name.c_str(), *Found, SetBy);
	if (!Refusal.IsEmpty())
	{
		const std::string File = Variable.Source == EVariableSource::Config ? ConfigFile : "command line";
		FConfigMessages(File, Diagnostics).Warn(WarnIneffectiveValue, Variable.Place, *Refusal);
		return;
	}
	Found->Set(Variable.Value.c_str(), SetBy);
}

FRunSetup::FRunSetup(const FRunOptions& Options)
{
	const FConfigDocument Document = OpenDocument(Options);
	Plugins = LoadPlugins(ReadConfigPlugins(Document), OfConfig);
	Variables.emplace(); // with those that plugins brought
	OfRun = ChooseBudget(ReadWithArguments(Document, Options, OfConfig), Options, OfConfig);
	BudgetReason = OfRun.BudgetReason;
	PlaceFrame(Options.Frame);
	ApplyVariables(Config, OfRun.Options, *Variables, OfExtensions);
	Extensions = CreateExtensions(Config, OfExtensions);
	Diagnostics = Join({&OfConfig, &OfFrame, &OfExtensions});
	ThrowErrors(Diagnostics);
	TextureLoader.emplace(MakeTextureLoader(Config));
	BlendSettings();
	Dump = ListDumpPatterns(Config, Options);
}

void FRunSetup::PlaceFrame(std::optional<int> Frame)
{
	OfFrame.clear();
	Config = OfRun.Config;
	ChooseSceneFrame(Config, Frame);
	if (OfRun.Options.Location)
	{
		Config.View.Location = {*OfRun.Options.Location, {1, 1, "--at"}};
	}
	CompleteFromScene(Config, OfFrame);
}

void FRunSetup::BlendSettings()
{
	Diagnostics = Join({&OfConfig, &OfFrame, &OfExtensions});
	Settings = MakeViewSettings(Config, &Diagnostics);
	WarnOfIneffectiveValues(Config, Settings, Diagnostics);
}

void FRunSetup::BeginFrame(std::optional<int> Frame)
{
	Extensions.PassResults->clear(); // they belong to the graph of the frame before
	if (Frame && Config.Scene.Frame && *Frame != *Config.Scene.Frame)
	{
		PlaceFrame(Frame);
		BlendSettings();
	}
}

} // namespace Drydock
