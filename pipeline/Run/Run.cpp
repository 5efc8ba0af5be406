// Runs a config: scene, frame, measurements, report. A little past 500 lines: its steps share one setup.
#include "Run/Run.h"

#include "DiagnosticList.h"
#include "DispatchBackend.h"
#include "DispatchReuse.h"
#include "Frame/Frame.h"
#include "HAL/ConsoleVariableTools.h"
#include "Run/FinalSettings.h"
#include "Run/IneffectiveValues.h"
#include "Run/OverlayUse.h"
#include "Run/PreExposure.h"
#include "Run/RunDump.h"
#include "Run/RunJson.h"
#include "Run/RunObserver.h"
#include "Run/RunSetup.h"
#include "SceneFile/NonFinite.h"
#include "SceneFile/SceneContent.h"
#include "TileExecutor.h"
#include "Tonemap/TonemapOutputDevice.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace Drydock
{

namespace
{

using FClock = std::chrono::steady_clock;

double MillisecondsSince(FClock::time_point Begin)
{
	return std::chrono::duration<double, std::milli>(FClock::now() - Begin).count();
}

int32 GetVariableInt(const char* Name)
{
	const IConsoleVariable* Variable = IConsoleManager::Get().FindConsoleVariable(Name);
	return Variable != nullptr ? Variable->GetInt() : 0;
}

/** A view's rect, which counts in pixels of the picture and is inside it (CheckScene), as a rect of the scene
 * textures. */
FIntRect GetViewRect(const FConfigView& View, const FSceneFile& Scene)
{
	const FIntRect Picture = Scene.GetPictureRect();
	const std::array<int, 4>& Corners = View.Rect.Value;
	return View.Rect.IsSet() ? FIntRect(Corners[0], Corners[1], Corners[2], Corners[3]) + Picture.Min : Picture;
}

/** The part of the result that is known before the graph. */
FRunResult MakeResult(const FRunSetup& Setup, const FSceneFile& Scene)
{
	const char* const StorageNames[] = {"native", "float32", "float64"};
	FRunResult Result;
	Result.Config = Setup.Config;
	Result.Diagnostics = Setup.Diagnostics;
	Result.BudgetReason = Setup.BudgetReason;
	Result.Write = Setup.Write;
	Result.Settings = Setup.Settings.Settings;
	Result.ExposureScale = Setup.Settings.ExposureScale;
	Result.Precision = GetVariableInt("r.Drydock.Precision") == 1 ? "double" : "float";
	if (const IDispatchBackend* const Backend = GetDispatchBackend())
	{
		Result.Device = Backend->GetDeviceName();
	}
	Result.Variables = ListRunVariables();
	Result.Storage = StorageNames[std::clamp(GetVariableInt("r.Drydock.Storage"), 0, 2)];
	Result.Threads = GetNumThreads();
	Result.LightColor = Scene.GetLightColor();
	Result.OutputDevice = GetTonemapperOutputDeviceParameters().OutputDevice;
	Result.SceneExtent = Scene.GetExtent();
	Result.ViewRect = GetViewRect(Setup.Config.View, Scene);
	for (const FConfigView& View : Setup.Config.Views)
	{
		Result.ViewRect.Union(GetViewRect(View, Scene));
	}
	return Result;
}

/** The camera of a view: the config's word, else the scene file's. */
FSceneCamera GetLens(const FConfigView& View, const FSceneFile& Scene)
{
	FSceneCamera Lens = Scene.GetCamera().value_or(FSceneCamera());
	if (View.Location.IsSet())
	{
		const FConfigVector& Location = View.Location.Value;
		Lens.Location = FVector(Location[0], Location[1], Location[2]);
	}
	if (View.Rotation.IsSet())
	{
		Lens.Pitch = View.Rotation.Value[0];
		Lens.Yaw = View.Rotation.Value[1];
		Lens.Roll = View.Rotation.Value[2];
	}
	if (View.Fov.IsSet())
	{
		Lens.HorizontalFov = View.Fov.Value;
		Lens.FocalLength.reset();
	}
	return Lens;
}

/** The regions of the views in scene textures of another resolution; empty: the file's own resolution. */
std::vector<FSceneRegion> MakeRegions(const FRunSetup& Setup, const FSceneFile& Scene)
{
	const double Percentage = GetScreenPercentage(Setup.Settings);
	if (Percentage == 100.0)
	{
		return {};
	}
	const FIntPoint Corner = Scene.GetPictureRect().Min;
	std::vector<FSceneRegion> Regions;
	const auto Add = [&](const FConfigView& View)
	{
		const FIntRect Source = GetViewRect(View, Scene) - Corner;
		Regions.push_back({Source, ScaleRect(Source, Percentage)});
	};
	for (const FConfigView& View : Setup.Config.Views)
	{
		Add(View);
	}
	if (Regions.empty())
	{
		Add(Setup.Config.View);
	}
	return Regions;
}

/** All but the settings. */
FFrameView MakeFrameView(const FRunSetup& Setup, const FConfigView& ConfigView, const FSceneFile& Scene)
{
	FFrameView View;
	View.Rect = GetViewRect(ConfigView, Scene);
	const FIntPoint Corner = Scene.GetPictureRect().Min;
	View.SceneRect = ScaleRect(View.Rect - Corner, GetScreenPercentage(Setup.Settings)) + Corner;
	View.Lens = GetLens(ConfigView, Scene);
	View.Camera.Location = View.Lens.Location;
	View.Camera.Rotation = FRotator(View.Lens.Pitch, View.Lens.Yaw, View.Lens.Roll);
	View.Camera.FOV = static_cast<float>(View.Lens.HorizontalFov);
	View.PictureRect = Scene.GetPictureRect();
	View.PreExposure = static_cast<float>(ConfigView.PreExposure.Value);
	View.MakeSettings = [&Setup, &ConfigView](const FMinimalViewInfo& Camera)
	{
		FConfig Moved = Setup.Config;
		Moved.View = ConfigView;
		Moved.View.Location.Value = {Camera.Location.X, Camera.Location.Y, Camera.Location.Z};
		Moved.View.Location.Place.Line = std::max(Moved.View.Location.Place.Line, 1); // counts as given
		return MakeViewSettings(Moved);
	};
	return View;
}

/** The time of a frame of a sequence, which begins at frame 0; a single scene has no time. Last is the frame before. */
FGameTime GetFrameTime(const FConfigScene& Config, const FSceneFile& Scene, const std::vector<FViewHistory>& Last)
{
	constexpr double DefaultFps = 24.0;
	if (!Config.Frame)
	{
		return {};
	}
	const double Delta = Config.Fps.IsSet() ? 1.0 / Config.Fps.Value : Scene.GetDeltaTime().value_or(1.0 / DefaultFps);
	const int NumFrames = !Last.empty() && Last[0].bValid ? *Config.Frame - static_cast<int>(Last[0].FrameNumber) : 1;
	FGameTime Time;
	Time.WorldTimeSeconds = static_cast<float>(*Config.Frame * Delta);
	Time.RealTimeSeconds = Time.WorldTimeSeconds;
	Time.DeltaWorldTimeSeconds = static_cast<float>(NumFrames * Delta);
	Time.DeltaRealTimeSeconds = Time.DeltaWorldTimeSeconds;
	return Time;
}

/** The state that a frame starts with beside its scene. */
struct FBeforeFrame
{
	const std::vector<FViewHistory>& Last;
	std::vector<std::shared_ptr<FSceneViewState>>& Caches; // by view
};

FFrameInputs MakeFrameInputs(const FRunOptions& Options, const FRunSetup& Setup, FSceneFile& Scene,
	const FBeforeFrame& Before, IRDGObserver& Observer, double& LoadMilliseconds)
{
	FFrameInputs Inputs;
	Inputs.Engine = Setup.Config.GetEngineProfile();
	Inputs.Extent = Scene.GetExtent();
	Inputs.OutputExtent = Scene.GetOutputExtent();
	Inputs.LightColor = Scene.GetLightColor();
	Inputs.ShowFlags = Setup.Settings.ShowFlags;
	Inputs.FrameNumber = static_cast<uint32>(Setup.Config.Scene.Frame.value_or(Options.Frame.value_or(0)));
	Inputs.Time = GetFrameTime(Setup.Config.Scene, Scene, Before.Last);
	Inputs.ViewStates = Before.Last;
	Inputs.Observer = &Observer;
	Inputs.bExecute = Options.bExecute;
	Inputs.bKeepMeasured = Options.bMeasureEffects && Options.bExecute;
	Inputs.RegisterSceneTextures = [&Scene](FRDGBuilder& GraphBuilder)
	{
		return Scene.RegisterTextures(GraphBuilder);
	};
	if (Options.bLookAtContent)
	{
		Inputs.MeasureContent = [&Scene, &LoadMilliseconds](
									const FIntRect& ViewRect, const FContentQuestions& Questions)
		{
			const FClock::time_point Begin = FClock::now();
			const FViewContent Content = MeasureViewContent(Scene, ViewRect, Questions);
			LoadMilliseconds += MillisecondsSince(Begin);
			return Content;
		};
	}
	Inputs.Plugins = Setup.Plugins;
	if (Setup.Config.Views.size() <= 1)
	{
		Inputs.Views.push_back(MakeFrameView(Setup, Setup.Config.View, Scene));
		Inputs.Views[0].Settings = Setup.Settings;
	}
	else
	{
		for (const FConfigView& ConfigView : Setup.Config.Views)
		{
			FFrameView View = MakeFrameView(Setup, ConfigView, Scene);
			View.Name = "View " + std::to_string(Inputs.Views.size());
			View.Settings = View.MakeSettings(View.Camera);
			Inputs.Views.push_back(std::move(View));
		}
	}
	for (FFrameView& View : Inputs.Views)
	{
		const size_t Index = static_cast<size_t>(&View - Inputs.Views.data());
		if (Index >= Before.Caches.size())
		{
			Before.Caches.push_back(std::make_shared<FSceneViewState>(static_cast<uint32>(Index + 1)));
		}
		View.State = Before.Caches[Index];
	}
	return Inputs;
}

/** Returns the result of Function. An error carries what was known before. */
template<typename TFunction>
auto CallWithWarnings(TFunction Function, const std::vector<FDiagnostic>& Before)
{
	try
	{
		return Function();
	}
	catch (const FError& Error)
	{
		std::vector<FDiagnostic> All = Before;
		All.insert(All.end(), Error.GetDiagnostics().begin(), Error.GetDiagnostics().end());
		throw FError(All, Error.GetExitCode());
	}
}

/** Builds the graph and runs or compiles it. */
void RunGraph(const FRunOptions& Options, const FRunSetup& Setup, FSceneFile& Scene, const FBeforeFrame& Before,
	FRunResult& Result)
{
	FRunObserver Observer(Options, Setup, Scene, Result);
	const FFrameInputs Inputs = MakeFrameInputs(Options, Setup, Scene, Before, Observer, Result.Times.Load);
	TakeUncalledReplacements(); // of the frame before
	FFrameResult Frame = CallWithWarnings([&] { return RenderViewFamily(Inputs); }, Result.Graph.Warnings);
	AddNewDiagnostics(Result.Diagnostics, Observer.GetUnwrittenReads());
	AddNewDiagnostics(Result.Diagnostics, FRHICommandListExecutor::GetImmediateCommandList().TakeRemarks());
	const FFrameViewResult& View = Frame.Views[0];
	for (const FFrameViewResult& Other : Frame.Views)
	{
		Result.Views.push_back({Other.Name, Other.Rect, Other.ExposureScale, Other.Effects,
			MeasureEffects(Other.Effects, {Other.Settings, Other.PreExposure, Other.Kept}), Other.Exposure});
	}
	Result.Settings = View.Settings;
	Result.ExposureScale = View.ExposureScale;
	Result.Exposure = View.Exposure;
	Result.Effects = View.Effects;
	Result.Figures = Result.Views[0].Figures;
	Result.HookCalls = std::move(Frame.Log.Calls);
	Result.HookPoints = std::move(Frame.Log.Points);
	Result.Diagnostics.insert(Result.Diagnostics.end(), Frame.Log.Diagnostics.begin(), Frame.Log.Diagnostics.end());
	for (const FRunPass& Pass : Result.Passes)
	{
		Result.Times.Execute += Pass.Milliseconds;
	}
	Result.Times.Compile = Frame.Milliseconds - Result.Times.Execute - Result.Times.Load;
	if (!Options.bExecute)
	{
		Result.Graph = std::move(Frame.Graph);
		return;
	}
	for (const FRunView& View : Result.Views)
	{
		if (View.Exposure && !View.Exposure->IsMetered())
		{
			Result.Diagnostics.push_back(View.Exposure->DescribeUnmetered(View.Name));
		}
	}
	Result.ViewStates = std::move(Frame.ViewStates);
	Result.SceneLinear = std::move(Frame.SceneLinear);
	Result.Final = std::move(Frame.Final);
	Observer.KeepAssets();
}

/** A run before its policies are applied. */
struct FRendered
{
	FRunResult Result;
	std::vector<FNonFiniteChannel> NonFiniteInFile;
};

/** Scene, frame and what they say. */
FRendered RenderScene(const FRunOptions& Options, const FRunSetup& Setup, const FBeforeFrame& Before)
{
	FSceneFile Scene(Setup.Config, Options.SceneCache.get());
	Scene.SetResolution(GetScreenPercentage(Setup.Settings), MakeRegions(Setup, Scene));
	FRendered Rendered{MakeResult(Setup, Scene), {}};
	FRunResult& Result = Rendered.Result;
	Scene.UseKeptTextures(MakePackContext(Setup.Config, Result.ViewRect));
	RunGraph(Options, Setup, Scene, Before, Result);
	WarnOfIdleTemporalAA(Setup.Config, Scene.GetCamera(), Result.Effects, Result.Diagnostics);
	Result.Channels = Scene.GetChannels();
	for (const FRDGCompiledResource& Resource : Result.Graph.Resources)
	{
		Result.SceneTextureBytes += Resource.bExternal && Scene.IsFilled(Resource.Name) ? Resource.Bytes : 0;
	}
	Result.Diagnostics.insert(Result.Diagnostics.end(), Result.Graph.Warnings.begin(), Result.Graph.Warnings.end());
	if (Options.bExecute)
	{
		const std::vector<FDiagnostic> DumpWarnings = CheckDumpPatterns(Setup.Dump, Result);
		Result.Diagnostics.insert(Result.Diagnostics.end(), DumpWarnings.begin(), DumpWarnings.end());
	}
	AddNewDiagnostics(Result.Diagnostics, FindUnusedOfOverlays(Setup.Overlays, TakeUncalledReplacements(), Result));
	Rendered.NonFiniteInFile = Scene.GetNonFinite();
	return Rendered;
}

/** The same. An error comes with what was known before. */
FRendered Render(const FRunOptions& Options, const FRunSetup& Setup, const FBeforeFrame& Before)
{
	return CallWithWarnings([&] { return RenderScene(Options, Setup, Before); }, Setup.Diagnostics);
}

/** The final picture of the same frame with 0 in place of what is not finite. */
FPicture RenderWithZeros(const FRunOptions& Options, const FRunSetup& Setup, const std::vector<FViewHistory>& Last)
{
	const FScopedConsoleVariable Zeros(TEXT("r.Drydock.NonFinite"), static_cast<int32>(ENonFinitePolicy::Zero));
	FRunOptions Plain = Options;
	Plain.Progress = nullptr;
	Plain.bMeasureEffects = false;
	std::vector<std::shared_ptr<FSceneViewState>> Caches;
	return Render(Plain, Setup, {Last, Caches}).Result.Final;
}

/** Reports values of the file's channels that are not finite, of scene colour if the file's is finite, and of the final
 * picture. */
void ReportNonFinite(const std::vector<FNonFiniteChannel>& InFile, FRunResult& Result)
{
	const size_t NumBefore = Result.Diagnostics.size();
	const auto Report = [&Result](const FNonFiniteChannel& Channel, const std::string& File)
	{
		if (Channel.Found.Count > 0)
		{
			Result.Diagnostics.push_back(DescribeNonFinite(Channel, File));
		}
	};
	bool bColorInFile = false;
	for (const FNonFiniteChannel& Channel : InFile)
	{
		Report(Channel, Result.Config.Resolve(Result.Config.Scene.File.Value));
		bColorInFile = bColorInFile || Channel.Where == SceneColorWhere;
	}
	Report({SceneColorWhere, bColorInFile ? FNonFiniteCount() : CountNonFinite(Result.SceneLinear)}, "");
	Report({"final picture", CountNonFinite(Result.Final)}, "");
	if (Result.Diagnostics.size() > NumBefore && GetNonFinitePolicy() == ENonFinitePolicy::Error)
	{
		throw FError(Result.Diagnostics, ExitPolicy);
	}
}

} // namespace

FRunSession::FRunSession(const FRunOptions& InOptions)
	: Begin(FClock::now())
	, StartMilliseconds(InOptions.StartMilliseconds)
	, Options(InOptions)
	, Setup(std::make_unique<FRunSetup>(InOptions, ESceneNeed::Required))
{
}

FRunSession::~FRunSession() = default;

const FConfig& FRunSession::GetConfig() const
{
	return Setup->Config;
}

FRunResult FRunSession::Run(std::optional<int> Frame, const std::vector<FViewHistory>& Last)
{
	// The first frame's setup is the session's.
	const FClock::time_point FrameBegin = std::exchange(Begin, std::nullopt).value_or(FClock::now());
	Setup->BeginFrame(Frame);
	SetPreExposure(Setup->Config, Setup->Settings.ExposureScale, Last);
	const double SetupMs = MillisecondsSince(FrameBegin);
	const FScopedReuse Reuse(Options.ReuseCache.get());
	if (Options.ReuseCache)
	{
		Options.ReuseCache->BeginFrame();
	}
	FRendered Rendered = Render(Options, *Setup, {Last, Caches});
	FRunResult& Result = Rendered.Result;
	if (Options.bExecute)
	{
		const std::vector<FNonFiniteChannel>& InFile = Rendered.NonFiniteInFile;
		ReportNonFinite(InFile, Result);
		if (!InFile.empty() && GetNonFinitePolicy() == ENonFinitePolicy::Propagate)
		{
			if (Setup->Config.Plugins.empty())
			{
				Result.NonFinite.Final = CompareFinal(Result.Final, RenderWithZeros(Options, *Setup, Last));
			}
			Result.Diagnostics.push_back(DescribeSpread(Result.NonFinite, InFile));
		}
	}
	FRunOptions OfFrame = Options;
	OfFrame.Frame = Frame ? Frame : Options.Frame;
	Result.Arguments = ListRunArguments(OfFrame, Result.Config);
	Result.bHistory = std::ranges::any_of(Last, &FViewHistory::bValid);
	if (Options.bRecordInputs)
	{
		Result.Inputs = FindRunInputs(Options, Result.Config);
	}
	Result.RunJson = MakeRunJson(Result);
	Result.Times.Begin = FrameBegin;
	Result.Times.Start = std::exchange(StartMilliseconds, 0.0);
	Result.Times.Setup = SetupMs;
	Result.Times.Report = MillisecondsSince(FrameBegin) + Result.Times.Start - Result.Times.GetSum();
	return std::move(Rendered.Result);
}

FRunResult RunConfig(const FRunOptions& Options)
{
	return FRunSession(Options).Run(std::nullopt, {});
}

FCheckResult CheckConfig(const FRunOptions& Options)
{
	FRunSetup Setup(Options, ESceneNeed::IfNamed);
	return {
		std::move(Setup.Config), std::move(Setup.Diagnostics), Setup.Settings.Settings, DecideEffects(Setup.Settings)};
}

FCheckResult CheckRun(const FRunOptions& Options)
{
	FRunSetup Setup(Options, ESceneNeed::IfNamed);
	FCheckResult Check = {Setup.Config, Setup.Diagnostics, Setup.Settings.Settings, DecideEffects(Setup.Settings)};
	EExitCode ExitCode = ExitDone; // of the first that fails
	const auto Collect = [&](auto Look)
	{
		try
		{
			Look();
		}
		catch (const FError& Error)
		{
			AddNewDiagnostics(Check.Diagnostics, Error.GetDiagnostics());
			ExitCode = ExitCode == ExitDone ? Error.GetExitCode() : ExitCode;
		}
	};
	Collect([&] { Check.Shaders = FindPluginShaders(Setup.Plugins, Setup.Overlays); });
	Collect(
		[&]
		{
			if (Setup.Config.Scene.File.Value.empty())
			{
				return;
			}
			FRunOptions Compiled = Options;
			Compiled.bExecute = false;
			Compiled.bPlanLoads = true; // which takes the shaders
			Compiled.bLookAtContent = false;
			Setup.BeginFrame(std::nullopt);
			SetPreExposure(Setup.Config, Setup.Settings.ExposureScale, {});
			std::vector<std::shared_ptr<FSceneViewState>> Caches;
			const FRunResult Result = Render(Compiled, Setup, {{}, Caches}).Result;
			AddNewDiagnostics(Check.Diagnostics, Result.Diagnostics);
			AddNewDiagnostics(Check.Diagnostics, FindUnseenPasses(Result.Graph, Check.Shaders));
		});
	Collect([&] { ReflectShaders(Check.Shaders); });
	AddNewDiagnostics(Check.Diagnostics, Check.Shaders.Notes);
	if (ExitCode != ExitDone)
	{
		throw FError(Check.Diagnostics, ExitCode);
	}
	return Check;
}

FPluginShaders WarmPluginShaders(const FRunOptions& Options)
{
	const FRunSetup Setup(Options);
	FPluginShaders Shaders = FindPluginShaders(Setup.Plugins);
	WarmShaders(Shaders.Permutations);
	return Shaders;
}

} // namespace Drydock
