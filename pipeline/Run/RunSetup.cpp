// Takes a run from its options to blended settings, step by step.
#include "Run/RunSetup.h"

#include "Config/ReadConfig.h"
#include "Budget/BudgetChoice.h"
#include "CodeScope.h"
#include "Config/ConfigPlaces.h"
#include "Config/ConfigReader.h"
#include "Config/FrameSequence.h"
#include "ExtensionFactory.h"
#include "Extensions/ConfigExtensions.h"
#include "Extensions/ExtensionErrors.h"
#include "Extensions/InsertedPass.h"
#include "Extensions/Plugins.h"
#include "Run/FinalSettings.h"
#include "Run/IneffectiveValues.h"
#include "SceneFile/SceneSuggestions.h"
#include "SceneFile/TextureFiles.h"
#include "Screen/TextureAssets.h"

#include <algorithm>
#include <set>
#include <tuple>

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

FConfigDocument OpenDocument(const FRunOptions& Options)
{
	FConfigDocument Document = Options.ConfigText ? ParseConfigDocument(*Options.ConfigText, Options.ConfigFile)
												  : LoadConfigDocument(Options.ConfigFile);
	if (Document.bSyntaxError)
	{
		throw FError(Document.Diagnostics, ExitUsage); // what stands behind it was not read
	}
	for (const std::string& Place : Options.ConfigPlaces)
	{
		SetConfigPlace(Document.Root, Place, Document.File);
	}
	return Document;
}

/** False when the step could not be taken: why is appended to Diagnostics. */
template<typename TStep>
bool Try(std::vector<FDiagnostic>& Diagnostics, const TStep& Step)
{
	try
	{
		Step();
		return true;
	}
	catch (const FError& Error)
	{
		Diagnostics.insert(Diagnostics.end(), Error.GetDiagnostics().begin(), Error.GetDiagnostics().end());
		return false;
	}
}

bool IsError(const FDiagnostic& Diagnostic)
{
	return Diagnostic.Severity == ESeverity::Error;
}

/** Throws all mistakes, in the order of the config; a mistake that two steps found is reported once. Exit code 3 if
 * only files are wrong, else 2. */
void ThrowErrors(const FConfig& Config, std::vector<FDiagnostic> Diagnostics)
{
	if (!HasErrors(Diagnostics))
	{
		return;
	}
	const auto GetOrder = [&](const FDiagnostic& Diagnostic)
	{
		const bool bInConfig = Diagnostic.File == Config.File && Diagnostic.Line > 0;
		return bInConfig ? std::tuple(0, Diagnostic.Line, Diagnostic.Column) : std::tuple(1, 0, 0);
	};
	std::stable_sort(Diagnostics.begin(), Diagnostics.end(),
		[&](const FDiagnostic& A, const FDiagnostic& B) { return GetOrder(A) < GetOrder(B); });
	std::set<std::string> Known;
	std::erase_if(
		Diagnostics, [&](const FDiagnostic& Diagnostic) { return !Known.insert(Diagnostic.ToString()).second; });
	constexpr int FileCodes = 5; // DD5...
	const bool bFilesOnly = std::all_of(Diagnostics.begin(), Diagnostics.end(),
		[](const FDiagnostic& Diagnostic) { return !IsError(Diagnostic) || Diagnostic.Code / 1000 == FileCodes; });
	throw FError(Diagnostics, bFilesOnly ? ExitFiles : ExitUsage);
}

/** An unknown name may belong to a plugin that could not be loaded. */
std::vector<FDiagnostic> MentionPlugins(std::vector<FDiagnostic> Diagnostics)
{
	for (FDiagnostic& Diagnostic : Diagnostics)
	{
		if (Diagnostic.Code == ErrorUnknownVariable || Diagnostic.Code == ErrorUnknownExtension ||
			Diagnostic.Code == ErrorUnknownPass || Diagnostic.Code == ErrorUnknownSetting)
		{
			Diagnostic.Message += " (or a plugin that could not be loaded has it)";
		}
	}
	return Diagnostics;
}

/** Whether what the config says of its scene is reported already. */
bool IsSceneReported(const std::vector<FDiagnostic>& Diagnostics)
{
	return std::any_of(Diagnostics.begin(), Diagnostics.end(),
		[](const FDiagnostic& Diagnostic)
		{
			const bool bMisspelt =
				Diagnostic.Code == ErrorUnknownKey && Diagnostic.Message.ends_with("; did you mean scene?");
			return IsError(Diagnostic) &&
				   (bMisspelt || Diagnostic.Where == "/scene" || Diagnostic.Where == "/scene/file");
		});
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

void AddPluginArguments(FConfig& Config, const FRunOptions& Options)
{
	for (const std::string& Overlay : Options.Overlays)
	{
		AddOverlayArgument(Config, Overlay);
	}
	for (const std::string& Plugin : Options.Plugins)
	{
		AddPluginArgument(Config, Plugin);
	}
}

/** The config with the command line's say. */
FConfig ReadWithArguments(
	const FConfigDocument& Document, const FRunOptions& Options, std::vector<FDiagnostic>& Diagnostics)
{
	FConfig Config = ReadConfig(Document, Diagnostics);
	if (!Options.Engine.empty())
	{
		SetEngineArgument(Config, Options.Engine, Diagnostics);
	}
	AddPluginArguments(Config, Options);
	for (const std::string& Argument : Options.Settings)
	{
		AddSettingArgument(Config, Argument, Diagnostics);
	}
	AddVariableArguments(Config, Options, Diagnostics);
	WarnOfUnreadSettings(Config, Diagnostics);
	ReadStudy(Config, Diagnostics);
	Config.bNoSkip = Options.bNoSkip;
	return Config;
}

struct FPluginsOfRun
{
	FLoadedPlugins Loaded;
	FOverlaysOfRun Overlays;
	std::vector<FDiagnostic> Diagnostics;
};

FPluginsOfRun LoadPluginsOfRun(const FConfigDocument& Document, const FRunOptions& Options)
{
	FConfig Config = ReadConfigPlugins(Document);
	AddPluginArguments(Config, Options);
	FPluginsOfRun Plugins;
	if (!Config.Overlays.empty())
	{
		if (!Options.Engine.empty())
		{
			SetEngineArgument(Config, Options.Engine, Plugins.Diagnostics);
		}
		Plugins.Overlays = PrepareOverlays(Config, Options.bNoPlugins, Plugins.Diagnostics);
		for (const FOverlayFolder& Folder : Plugins.Overlays.Folders)
		{
			if (!Folder.Library.empty())
			{
				Config.Plugins.push_back({Folder.Library, {0, 0, "/overlay"}});
			}
		}
	}
	if (Options.bNoPlugins)
	{
		RefusePlugins(Config, Plugins.Diagnostics);
	}
	else
	{
		Plugins.Loaded = LoadPlugins(Config, Plugins.Diagnostics);
	}
	if (!Plugins.Overlays.Folders.empty() && !HasErrors(Plugins.Diagnostics))
	{
		ReportOverlays(Config, Plugins.Overlays, Plugins.Diagnostics);
	}
	return Plugins;
}

/** Diagnostics are those of the plugins. */
FConfigOfRun ReadRun(
	const FConfigDocument& Document, const FRunOptions& Options, ESceneNeed Need, std::vector<FDiagnostic> Diagnostics)
{
	FConfigOfRun OfRun{ReadWithArguments(Document, Options, Diagnostics), Options, Need, "", {}};
	if (IsSceneReported(Diagnostics))
	{
		OfRun.Need = ESceneNeed::None;
	}
	if (Options.bUseBudget && !HasErrors(Diagnostics))
	{
		if (const std::optional<FBudgetChoice> Choice = ReadBudgetChoice(OfRun.Config, Options, Diagnostics))
		{
			OfRun.BudgetReason = Choice->Reason;
			ApplyBudgetChoice(*Choice, OfRun.Config, OfRun.Options);
		}
	}
	OfRun.Diagnostics = std::move(Diagnostics);
	return OfRun;
}

std::vector<FDiagnostic> ApplyVariables(const FConfig& Config, const FRunOptions& Options,
	const std::vector<FIniVariable>& IniVariables, FRunVariables& Variables)
{
	std::vector<FDiagnostic> Diagnostics;
	ApplyIniVariables(IniVariables, Diagnostics);
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
	return Diagnostics;
}

struct FRequestsOfRun
{
	std::vector<FExtensionRequest> Extensions;
	std::vector<FPassRequest> Passes;
	std::vector<FDiagnostic> Diagnostics;
};

FRequestsOfRun ReadRequests(const FConfig& Config)
{
	FRequestsOfRun Requests;
	Requests.Extensions = ReadExtensionRequests(Config, Requests.Diagnostics);
	Requests.Passes = ReadPassRequests(Config, Requests.Diagnostics);
	return Requests;
}

FRunExtensions CreateExtensions(const FRequestsOfRun& Requests)
{
	FRunExtensions Made;
	Made.PassResults = std::make_shared<FPassResults>();
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
	for (const FExtensionRequest& Request : Requests.Extensions)
	{
		const FExtensionFactory& Factory = *FindExtensionFactory(Request.Type);
		Add(CallCode(Factory.Owner, [&] { return Factory.Create(Request.Arguments); }), Request.Type);
	}
	for (const FPassRequest& Request : Requests.Passes)
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

/** Size, padding and views that the options give in place of the config's. */
void ApplyLayout(const FRunOptions& Options, FConfig& Config)
{
	Config.Scene.ScreenPercentage = Options.ScreenPercentage.value_or(Config.Scene.ScreenPercentage);
	if (Options.Padding)
	{
		const std::array<int, 4>& Sides = *Options.Padding;
		Config.Scene.Padding = {Sides[0], Sides[1], Sides[2], Sides[3]};
	}
	if (Options.ViewRects.empty())
	{
		return;
	}
	Config.Views.clear();
	for (const std::array<int, 4>& Rect : Options.ViewRects)
	{
		Config.Views.push_back(Config.View);
		Config.Views.back().Rect = {Rect, {1, 1, "the views' rects"}};
	}
	Config.View = Config.Views[0];
	if (Config.Views.size() == 1)
	{
		Config.Views.clear();
	}
}

/** The config of a frame of the run: with the view and the scene of this frame, or the first frame's if Frame is empty.
 */
FFrameOfRun PlaceFrame(const FConfigOfRun& OfRun, std::optional<int> Frame)
{
	FFrameOfRun Placed{OfRun.Config, {}};
	FConfig& Config = Placed.Config;
	std::vector<FDiagnostic>& Diagnostics = Placed.Diagnostics;
	if (OfRun.Options.Location)
	{
		Config.View.Location = {*OfRun.Options.Location, {1, 1, "--at"}};
	}
	ApplyLayout(OfRun.Options, Config);
	if (Try(Diagnostics, [&] { ChooseSceneFrame(Config, Frame); }))
	{
		Try(Diagnostics, [&] { CompleteFromScene(Config, Diagnostics); });
	}
	CheckScene(Config, OfRun.Need, Diagnostics);
	if (OfRun.Need != ESceneNeed::None)
	{
		CheckTextureFiles(Config, Diagnostics);
	}
	return Placed;
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

FRunSetup::FRunSetup(const FRunOptions& Options, ESceneNeed Need)
{
	const FConfigDocument Document = OpenDocument(Options);
	const FPluginsOfRun OfPlugins = LoadPluginsOfRun(Document, Options);
	ActiveOverlays.emplace(OfPlugins.Overlays);
	Overlays = OfPlugins.Overlays.Folders;
	Variables.emplace(); // with those that plugins brought
	OfRun = ReadRun(Document, Options, Need, OfPlugins.Diagnostics);
	FFrameOfRun Frame = PlaceFrame(OfRun, Options.Frame);
	const FRequestsOfRun Requests = ReadRequests(Frame.Config);
	const std::vector<FDiagnostic> Found = Join({&OfRun.Diagnostics, &Frame.Diagnostics, &Requests.Diagnostics});
	ThrowErrors(Frame.Config, HasErrors(OfPlugins.Diagnostics) ? MentionPlugins(Found) : Found);
	const std::vector<FDiagnostic> OfVariables =
		ApplyVariables(Frame.Config, OfRun.Options, OfPlugins.Loaded.IniVariables, *Variables);
	OfExtensions = Join({&Requests.Diagnostics, &OfVariables});
	Extensions = CreateExtensions(Requests);
	TextureLoader.emplace(MakeTextureLoader(Frame.Config));
	Plugins = OfPlugins.Loaded.Files;
	BudgetReason = OfRun.BudgetReason;
	Dump = ListDumpPatterns(Frame.Config, Options);
	Write = Options.Write.value_or(Frame.Config.Write.value_or(Options.WriteByDefault));
	TakeFrame(std::move(Frame));
}

void FRunSetup::TakeFrame(FFrameOfRun Frame)
{
	Config = std::move(Frame.Config);
	Diagnostics = Join({&OfRun.Diagnostics, &Frame.Diagnostics, &OfExtensions});
	Settings = MakeViewSettings(Config, &Diagnostics);
	WarnOfIneffectiveValues(Config, Settings, Diagnostics);
}

void FRunSetup::BeginFrame(std::optional<int> Frame)
{
	Extensions.PassResults->clear(); // they belong to the graph of the frame before
	if (Frame && Config.Scene.Frame && *Frame != *Config.Scene.Frame)
	{
		FFrameOfRun Next = PlaceFrame(OfRun, Frame);
		ThrowErrors(Next.Config, Next.Diagnostics);
		TakeFrame(std::move(Next));
	}
}

} // namespace Drydock
