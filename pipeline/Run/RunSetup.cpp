// Source: drydock.
#include "Run/RunSetup.h"

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
	const std::string Obstacle = Chain.Settings.BloomMethod == BM_FFT && Chain.Settings.BloomIntensity > 0.0f
									 ? GetFFTBloomObstacle(Chain.Settings, true)
									 : std::string();
	if (!Obstacle.empty())
	{
		Messages.Warn(WarnIneffectiveValue, Nowhere, "BloomMethod BM_FFT: " + Obstacle + ", so the Gaussian sum runs");
	}
	WarnOfMissingPictures(Chain.Settings, Messages);
}

FConfig Read(const FRunOptions& Options, std::vector<FDiagnostic>& Diagnostics)
{
	return Options.ConfigText ? ReadConfig(*Options.ConfigText, Options.ConfigFile, Diagnostics)
							  : LoadConfig(Options.ConfigFile, Diagnostics);
}

/** Mistakes of the rest are reported when it is read with the plugins there. */
std::vector<std::string> LoadPluginsOf(const FRunOptions& Options, std::vector<FDiagnostic>& Diagnostics)
{
	std::vector<FDiagnostic> Ignored;
	return LoadPlugins(Read(Options, Ignored), Diagnostics);
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

void FRunSetup::CreateExtensions()
{
	const std::vector<FExtensionRequest> Requests = ReadExtensionRequests(Config, OfExtensions);
	const std::vector<FPassRequest> PassRequests = ReadPassRequests(Config, OfExtensions);
	if (HasErrors(OfExtensions))
	{
		std::vector<FDiagnostic> All = OfConfig;
		All.insert(All.end(), OfFrame.begin(), OfFrame.end());
		All.insert(All.end(), OfExtensions.begin(), OfExtensions.end());
		throw FError(All, ExitUsage);
	}
	const auto Add = [this](const TSharedRef<ISceneViewExtension, ESPMode::ThreadSafe>& Extension,
						 const std::string& Name, int32 EngineMinor)
	{
		if (const FExtensionInfo* Known = GEngine->ViewExtensions->FindInfo(*Extension))
		{
			FExtensionInfo Info = *Known;
			Info.Name = Name;
			Info.EngineMinor = EngineMinor;
			GEngine->ViewExtensions->SetInfo(*Extension, Info);
		}
		Extensions.push_back(Extension);
	};
	for (const FExtensionRequest& Request : Requests)
	{
		Add(FindExtensionFactory(Request.Type)->Create(Request.Arguments), Request.Type, AnyEngineVersion);
	}
	PassResults = std::make_shared<FPassResults>();
	for (const FPassRequest& Request : PassRequests)
	{
		Add(CreateInsertedPass(Request, PassResults), Request.Name, AnyEngineVersion);
	}
}

void FRunSetup::PlaceFrame(std::optional<int> Frame)
{
	OfFrame.clear();
	Config = ConfigBeforeFrame;
	ChooseSceneFrame(Config, Frame);
	if (Options.Location)
	{
		Config.View.Location = {*Options.Location, {1, 1, "--at"}};
	}
	CompleteFromScene(Config, OfFrame);
}

void FRunSetup::Decide()
{
	Diagnostics = OfConfig;
	Diagnostics.insert(Diagnostics.end(), OfFrame.begin(), OfFrame.end());
	Diagnostics.insert(Diagnostics.end(), OfExtensions.begin(), OfExtensions.end());
	Chain = MakeChainSettings(Config, &Diagnostics);
	WarnOfIneffectiveValues(Config, Chain, Diagnostics);
	Effects = DecideEffects(Chain);
}

void FRunSetup::BeginFrame(std::optional<int> Frame)
{
	PassResults->clear(); // they belong to the graph of the frame before
	if (Frame && Config.Scene.Frame && *Frame != *Config.Scene.Frame)
	{
		PlaceFrame(Frame);
		Decide();
	}
}

FRunSetup::FRunSetup(const FRunOptions& InOptions)
	: Plugins(LoadPluginsOf(InOptions, Diagnostics))
	, Config(Read(InOptions, Diagnostics))
	, Options(InOptions)
{
	for (const std::string& Argument : Options.Settings)
	{
		AddSettingArgument(Config, Argument, Diagnostics);
	}
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
	if (HasErrors(Diagnostics))
	{
		throw FError(Diagnostics, ExitUsage);
	}
	ReadStudy(Config, Diagnostics);
	if (HasErrors(Diagnostics))
	{
		throw FError(Diagnostics, ExitUsage);
	}
	if (Options.bUseBudget)
	{
		if (const std::optional<FBudgetChoice> Choice = ReadBudgetChoice(Config, Options, Diagnostics))
		{
			BudgetReason = Choice->Reason;
			ApplyBudgetChoice(*Choice, Config, Options);
		}
	}
	OfConfig = std::move(Diagnostics);
	ConfigBeforeFrame = Config;
	PlaceFrame(Options.Frame);
	for (const FConfigVariable& Variable : Config.Variables)
	{
		Variables.Apply(Variable, Config.File, OfExtensions);
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
		ConfigBeforeFrame.bNoSkip = true;
		Config.bNoSkip = true;
	}
	if (Options.Threads)
	{
		Variables.Set("r.Drydock.Threads", std::to_string(*Options.Threads));
	}
	IConsoleManager::Get().CallAllConsoleVariableSinks();
	CreateExtensions();
	TextureLoader.emplace(MakeTextureLoader(Config));
	Decide();
	Dump = Config.Dump;
	for (const std::string& Pattern : Options.Dump)
	{
		Dump.push_back({Pattern, {0, 0, "--dump"}});
	}
}

} // namespace Drydock
