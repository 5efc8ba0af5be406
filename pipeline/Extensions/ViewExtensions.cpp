// Calls the hooks of view extensions, in the engine's order.
#include "Extensions/ViewExtensions.h"

#include "CodeScope.h"
#include "ExtensionFactory.h"
#include "Extensions/ExtensionErrors.h"
#include "FinalPostProcessSettings.h"
#include "PixelFormat.h"
#include "PostProcessSettingsReflection.h"
#include "RangeTools.h"
#include "TextTools.h"
#include "UnrealClient.h"

#include <algorithm>
#include <unordered_map>

namespace Drydock
{

namespace
{

/** "BloomIntensity 0.675 -> 2, ..." of what differs. */
std::string DescribeChanges(const FPostProcessSettings& Before, const FPostProcessSettings& After)
{
	std::string Text;
	for (const FSettingField& Field : GetSettingFields())
	{
		const std::string Old = SettingToText(Field, Field.Get(Before));
		const std::string New = SettingToText(Field, Field.Get(After));
		if (Old != New)
		{
			Text += (Text.empty() ? "set " : ", ") + std::string(Field.Name) + " " + Old + " -> " + New;
		}
	}
	return Text;
}

/** The passes inside each event scope, by its name without those around it. */
using FPassesByScope = std::unordered_map<std::string, std::vector<const FRDGCompiledPass*>>;

FPassesByScope SortByScope(const FRDGCompiledGraph& Graph)
{
	FPassesByScope Passes;
	for (const FRDGCompiledPass& Pass : Graph.Passes)
	{
		for (const std::string& Scope : SplitText(Pass.Scope, '/'))
		{
			std::vector<const FRDGCompiledPass*>& Inside = Passes[Scope];
			if (Inside.empty() || Inside.back() != &Pass)
			{
				Inside.push_back(&Pass);
			}
		}
	}
	return Passes;
}

std::string DescribePasses(const std::vector<const FRDGCompiledPass*>& Passes)
{
	std::string Names;
	size_t NumCulled = 0;
	for (const FRDGCompiledPass* Pass : Passes)
	{
		NumCulled += Pass->bCulled ? 1 : 0;
		Names += (Names.empty() ? "" : ", ") + Pass->Name;
	}
	const std::string Culled = NumCulled == 0 ? "" : " (" + std::to_string(NumCulled) + " culled)";
	return "added " + std::to_string(Passes.size()) + (Passes.size() == 1 ? " pass" : " passes") + Culled + ": " +
		   Names;
}

} // namespace

FDiagnostic MakeExtensionDiagnostic(
	ESeverity Severity, int Code, const std::string& Extension, const std::string& Message)
{
	FDiagnostic Diagnostic;
	Diagnostic.Severity = Severity;
	Diagnostic.Code = Code;
	Diagnostic.Where = "extension " + Extension;
	Diagnostic.Message = Message;
	return Diagnostic;
}

FViewExtensionFrame::FViewExtensionFrame(const FEngineProfile& InEngine, FHookLog& InLog)
	: Engine(InEngine)
	, Log(InLog)
{
}

void FViewExtensionFrame::Gather(FSceneViewFamily& Family, const std::optional<std::vector<std::string>>& InPlugins)
{
	Plugins = InPlugins.value_or(std::vector<std::string>());
	FSceneViewExtensionContext Context(Family.Scene);
	FViewport Viewport(*Family.RenderTarget);
	Context.Viewport = &Viewport;
	Family.ViewExtensions = GEngine->ViewExtensions->GatherActiveExtensions(Context);
	Family.ViewExtensions.RemoveAll(
		[&](const TSharedRef<ISceneViewExtension, ESPMode::ThreadSafe>& Extension)
		{
			const FExtensionInfo* Info = GEngine->ViewExtensions->FindInfo(*Extension);
			return InPlugins && Info != nullptr && !Info->Plugin.empty() && !Contains(Plugins, Info->Plugin);
		});
	std::unordered_map<std::string, int> Numbers; // how many of a name
	for (const FExtension& Earlier : Extensions)
	{
		++Numbers[Earlier.Info.Name];
	}
	for (const TSharedRef<ISceneViewExtension, ESPMode::ThreadSafe>& Extension : Family.ViewExtensions)
	{
		const FExtensionInfo* Info = GEngine->ViewExtensions->FindInfo(*Extension);
		check(Info);
		const int Number = ++Numbers[Info->Name];
		const std::string Label = Number == 1 ? Info->Name : Info->Name + " #" + std::to_string(Number);
		const bool bFollows = Info->EngineMinor == AnyEngineVersion;
		const int32 EngineMinor = bFollows ? Engine.Minor : GetNearestEngineProfile(Info->EngineMinor).Minor;
		Extensions.push_back({Extension, *Info, Label, EngineMinor});
		ReportVersion(Extensions.back());
	}
}

std::vector<std::string> FViewExtensionFrame::GetNames() const
{
	return ToVector<std::string>(Extensions, [](const FExtension& Extension) { return Extension.Info.Name; });
}

void FViewExtensionFrame::ReportVersion(const FExtension& Extension)
{
	const auto Report = [&](ESeverity Severity, int Code, const std::string& Message)
	{
		Log.Diagnostics.push_back(MakeExtensionDiagnostic(Severity, Code, Extension.Label, Message));
	};
	const std::string Own = GetEngineVersionText(Extension.EngineMinor);
	const bool bFollows = Extension.Info.EngineMinor == AnyEngineVersion;
	if (!bFollows && FindEngineProfile(Extension.Info.EngineMinor) == nullptr)
	{
		Report(ESeverity::Warning, WarnEngineUnknown,
			"it is compiled for engine " + GetEngineVersionText(Extension.Info.EngineMinor) +
				", which drydock does not know (" + ListEngineVersions(", ") + "); it gets the hooks of " + Own);
	}
	if (!bFollows && Extension.EngineMinor != Engine.Minor)
	{
		Report(ESeverity::Warning, WarnEngineDiffers,
			"it is compiled for engine " + Own + " and gets the hooks of that version; the run is " +
				Engine.GetVersion());
	}
	for (const FHookVersions& Hook : GetHookVersions())
	{
		const bool bNever = Extension.Info.Has(Hook.Hook) && !IsHookCalled(Hook.Hook, Extension.EngineMinor);
		if (bNever && !Hook.NeverHere.empty())
		{
			// One that has both is right wherever it runs.
			const bool bHasOther = std::ranges::any_of(GetHookVersions(), [&](const FHookVersions& Other)
				{ return Extension.Info.Has(Other.Hook) && Other.Signature == Hook.Instead; });
			Report(bHasOther ? ESeverity::Note : ESeverity::Warning, WarnHookNeverCalled,
				"it overrides " + Hook.Signature + ", which " + Hook.NeverHere +
					(bHasOther || Hook.Instead.empty() ? "" : "; override " + Hook.Instead));
		}
		else if (bNever && !bFollows && !Hook.Instead.empty())
		{
			Report(ESeverity::Warning, WarnHookNeverCalled,
				"it overrides " + Hook.Signature + ", which engine " + Own + " never calls; override " + Hook.Instead);
		}
	}
}

template<typename TFunction>
void FViewExtensionFrame::Call(
	FExtension& Extension, EExtensionHook Hook, const std::string& ViewName, TFunction Function)
{
	if (!IsHookCalled(Hook, Extension.EngineMinor))
	{
		return;
	}
	if (Extension.Info.Has(Hook))
	{
		Log.Calls.push_back({GetHookName(Hook), ViewName, Extension.Label, "", ""});
	}
	CallCode(Extension.Info.MakeOwner(GetHookName(Hook)), [&] { Function(*Extension.Extension); });
}

template<typename TFunction>
void FViewExtensionFrame::CallInGraph(FRDGBuilder& GraphBuilder, FExtension& Extension, EExtensionHook Hook,
	const std::string& ViewName, TFunction Function)
{
	if (!Extension.Info.Has(Hook))
	{
		Call(Extension, Hook, ViewName, Function);
		return;
	}
	const std::string Scope = GetHookName(Hook) + ": " + Extension.Label + (ViewName.empty() ? "" : ", " + ViewName);
	RDG_EVENT_SCOPE(GraphBuilder, "%s", Scope.c_str());
	Call(Extension, Hook, ViewName,
		[&](ISceneViewExtension& Called)
		{
			Log.Calls.back().Scope = Scope;
			Function(Called);
		});
}

void FViewExtensionFrame::SetupViewFamily(FSceneViewFamily& Family)
{
	for (FExtension& Extension : Extensions)
	{
		Call(Extension, EExtensionHook::SetupViewFamily, "",
			[&](ISceneViewExtension& Called) { Called.SetupViewFamily(Family); });
	}
}

void FViewExtensionFrame::SetupViewPoint(const std::string& ViewName, FMinimalViewInfo& ViewInfo)
{
	for (FExtension& Extension : Extensions)
	{
		Call(Extension, EExtensionHook::SetupViewPoint, ViewName,
			[&](ISceneViewExtension& Called) { Called.SetupViewPoint(nullptr, ViewInfo); });
	}
}

void FViewExtensionFrame::SetupViewProjectionMatrix(
	const std::string& ViewName, FSceneViewProjectionData& ProjectionData)
{
	for (FExtension& Extension : Extensions)
	{
		Call(Extension, EExtensionHook::SetupViewProjectionMatrix, ViewName,
			[&](ISceneViewExtension& Called) { Called.SetupViewProjectionMatrix(ProjectionData); });
	}
}

void FViewExtensionFrame::SetupView(
	FSceneViewFamily& Family, const FNamedView& View, std::vector<FSettingGate>& Gates, FBlendLedger* Ledger)
{
	for (FExtension& Extension : Extensions)
	{
		const FFinalPostProcessSettings Before = View.View->FinalPostProcessSettings;
		Call(Extension, EExtensionHook::SetupView, View.Name,
			[&](ISceneViewExtension& Called) { Called.SetupView(Family, *View.View); });
		if (Extension.Info.Has(EExtensionHook::SetupView) &&
			IsHookCalled(EExtensionHook::SetupView, Extension.EngineMinor))
		{
			const std::vector<FSettingGate> Edits =
				RecordExtensionEdits(Before, View.View->FinalPostProcessSettings, Extension.Label, Ledger);
			Log.Calls.back().Did = DescribeChanges(Before, View.View->FinalPostProcessSettings);
			Gates.insert(Gates.end(), Edits.begin(), Edits.end());
		}
	}
}

void FViewExtensionFrame::BeginRenderViewFamily(FSceneViewFamily& Family)
{
	for (FExtension& Extension : Extensions)
	{
		Call(Extension, EExtensionHook::BeginRenderViewFamily, "",
			[&](ISceneViewExtension& Called) { Called.BeginRenderViewFamily(Family); });
	}
}

void FViewExtensionFrame::PostCreateSceneRenderer(const FSceneViewFamily& Family)
{
	for (FExtension& Extension : Extensions)
	{
		Call(Extension, EExtensionHook::PostCreateSceneRenderer, "",
			[&](ISceneViewExtension& Called) { Called.PostCreateSceneRenderer(Family, nullptr); });
	}
}

void FViewExtensionFrame::PreRender(
	FRDGBuilder& GraphBuilder, FSceneViewFamily& Family, const std::vector<FNamedView>& Views)
{
	for (FExtension& Extension : Extensions)
	{
		CallInGraph(GraphBuilder, Extension, EExtensionHook::PreRenderViewFamily, "",
			[&](ISceneViewExtension& Called) { Called.PreRenderViewFamily_RenderThread(GraphBuilder, Family); });
		for (const FNamedView& View : Views)
		{
			CallInGraph(GraphBuilder, Extension, EExtensionHook::PreRenderView, View.Name,
				[&](ISceneViewExtension& Called) { Called.PreRenderView_RenderThread(GraphBuilder, *View.View); });
		}
	}
}

void FViewExtensionFrame::PreInitViews(FRDGBuilder& GraphBuilder)
{
	for (FExtension& Extension : Extensions)
	{
		CallInGraph(GraphBuilder, Extension, EExtensionHook::PreInitViews, "",
			[&](ISceneViewExtension& Called) { Called.PreInitViews_RenderThread(GraphBuilder); });
	}
}

void FViewExtensionFrame::PreRenderBasePass(FRDGBuilder& GraphBuilder)
{
	for (FExtension& Extension : Extensions)
	{
		CallInGraph(GraphBuilder, Extension, EExtensionHook::PreRenderBasePass, "",
			[&](ISceneViewExtension& Called) { Called.PreRenderBasePass_RenderThread(GraphBuilder, true); });
	}
}

void FViewExtensionFrame::PostRenderBasePass(FRDGBuilder& GraphBuilder, const std::vector<FNamedView>& Views,
	const FRenderTargetBindingSlots& RenderTargets, TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures)
{
	for (FExtension& Extension : Extensions)
	{
		for (const FNamedView& View : Views)
		{
			CallInGraph(GraphBuilder, Extension, EExtensionHook::PostRenderBasePassDeferred, View.Name,
				[&](ISceneViewExtension& Called) {
					Called.PostRenderBasePassDeferred_RenderThread(
						GraphBuilder, *View.View, RenderTargets, SceneTextures);
				});
		}
	}
}

void FViewExtensionFrame::PrePostProcess(
	FRDGBuilder& GraphBuilder, const std::vector<FNamedView>& Views, const FPostProcessingInputs& Inputs)
{
	for (FExtension& Extension : Extensions)
	{
		for (const FNamedView& View : Views)
		{
			CallInGraph(GraphBuilder, Extension, EExtensionHook::PrePostProcessPass, View.Name,
				[&](ISceneViewExtension& Called)
				{ Called.PrePostProcessPass_RenderThread(GraphBuilder, *View.View, Inputs); });
		}
	}
	const FRDGTextureRef SceneColor = (*Inputs.SceneTextures)->SceneColorTexture;
	for (const FNamedView& View : Views)
	{
		FHookPoint Point;
		Point.Point = PrePostProcessPassName;
		Point.View = View.Name;
		Point.Space = ToString(EColorSpace::LinearHDR);
		Point.Resource = SceneColor->Name;
		Point.Format = GetPixelFormatString(SceneColor->Desc.Format);
		Point.Width = View.View->ViewRect.Width();
		Point.Height = View.View->ViewRect.Height();
		for (const FExtension& Extension : Extensions)
		{
			if (Extension.Info.Has(EExtensionHook::PrePostProcessPass))
			{
				Point.Subscribers.push_back(Extension.Label);
			}
		}
		Point.bCalled = !Point.Subscribers.empty();
		Point.Reason = Point.bCalled ? "scene colour may be edited in place" : "nobody overrides it";
		Log.Points.push_back(Point);
	}
}

std::vector<FPassCallback> FViewExtensionFrame::Subscribe(
	ISceneViewExtension::EPostProcessingPass Pass, const FNamedView& View, bool bIsPassEnabled)
{
	FPostProcessingPassDelegateArray Delegates;
	std::vector<const FExtension*> Owners;
	for (FExtension& Extension : Extensions)
	{
		if (!HasInsertionPoint(Pass, Extension.EngineMinor))
		{
			continue;
		}
		// One that follows the run's version has the signature it has.
		const bool bChooses = Extension.Info.EngineMinor == AnyEngineVersion;
		const bool bWithView = bChooses ? Extension.Info.Has(EExtensionHook::SubscribeWithView)
										: IsHookCalled(EExtensionHook::SubscribeWithView, Extension.EngineMinor);
		const int32 NumBefore = Delegates.Num();
		CallCode(Extension.Info.MakeOwner(std::string("SubscribeToPostProcessingPass(") + GetPassName(Pass) + ")"),
			[&]
			{
				if (bWithView)
				{
					Extension.Extension->SubscribeToPostProcessingPass(Pass, *View.View, Delegates, bIsPassEnabled);
				}
				else
				{
					Extension.Extension->SubscribeToPostProcessingPass(Pass, Delegates, bIsPassEnabled);
				}
			});
		// An extension may also take away what others added: whose the rest is stays as it was.
		Owners.resize(static_cast<size_t>(Delegates.Num()), &Extension);
		if (Extension.Info.Has(bWithView ? EExtensionHook::SubscribeWithView : EExtensionHook::Subscribe))
		{
			const int32 NumAdded = Delegates.Num() - NumBefore;
			Log.Calls.push_back({std::string("SubscribeToPostProcessingPass(") + GetPassName(Pass) + ")", View.Name,
				Extension.Label,
				NumAdded == 0 ? ""
							  : "subscribed " + std::to_string(NumAdded) + (bIsPassEnabled ? "" : ", pass disabled"),
				""});
		}
	}
	std::vector<FPassCallback> Callbacks;
	for (int32 Index = 0; Index < Delegates.Num(); ++Index)
	{
		const FExtension& Owner = *Owners[static_cast<size_t>(Index)];
		Callbacks.push_back(
			{Delegates[Index], Owner.Label, Owner.Info.MakeOwner(std::string("the callback at ") + GetPassName(Pass))});
	}
	return Callbacks;
}

void FViewExtensionFrame::PostRender(
	FRDGBuilder& GraphBuilder, FSceneViewFamily& Family, const std::vector<FNamedView>& Views)
{
	for (FExtension& Extension : Extensions)
	{
		for (const FNamedView& View : Views)
		{
			CallInGraph(GraphBuilder, Extension, EExtensionHook::PostRenderView, View.Name,
				[&](ISceneViewExtension& Called) { Called.PostRenderView_RenderThread(GraphBuilder, *View.View); });
		}
		CallInGraph(GraphBuilder, Extension, EExtensionHook::PostRenderViewFamily, "",
			[&](ISceneViewExtension& Called) { Called.PostRenderViewFamily_RenderThread(GraphBuilder, Family); });
	}
}

void FViewExtensionFrame::Finish(const FRDGCompiledGraph& Graph)
{
	const FPassesByScope Passes = SortByScope(Graph);
	for (FHookCall& Call : Log.Calls)
	{
		const auto Inside = Passes.find(Call.Scope);
		if (Inside != Passes.end())
		{
			const bool bAllCulled = std::all_of(Inside->second.begin(), Inside->second.end(),
				[](const FRDGCompiledPass* Pass) { return Pass->bCulled; });
			if (Call.bReturnedInput && bAllCulled)
			{
				Log.Diagnostics.push_back(MakeExtensionDiagnostic(ESeverity::Note, NoteCallbackReturnedInput,
					Call.Extension,
					"its callback at " + Call.Hook +
						" added passes and returned its input: nobody reads what they draw, and they are left out"));
			}
			Call.Did += (Call.Did.empty() ? "" : "; ") + DescribePasses(Inside->second);
		}
		else if (Call.bReturnedInput)
		{
			Log.Diagnostics.push_back(MakeExtensionDiagnostic(ESeverity::Note, NoteCallbackDidNothing, Call.Extension,
				"its callback at " + Call.Hook +
					" added no pass and returned its input: it is off here, by a setting, a console variable, a weight "
					"of 0 or a condition of its own"));
		}
	}
	ReportIdlePlugins();
}

/** A plugin took part where a call of one of its extensions did something that can be seen. */
void FViewExtensionFrame::ReportIdlePlugins()
{
	for (const std::string& Plugin : Plugins)
	{
		const std::vector<std::string> Names = GEngine->ViewExtensions->GetNamesOfPlugin(Plugin);
		std::string Active;
		bool bTookPart = Names.empty(); // it may have passes or settings alone
		for (const FExtension& Extension : Extensions)
		{
			if (Extension.Info.Plugin == Plugin)
			{
				Active += (Active.empty() ? "" : ", ") + Extension.Label;
				bTookPart = bTookPart || std::ranges::any_of(Log.Calls, [&](const FHookCall& Call)
											 { return Call.Extension == Extension.Label && !Call.Did.empty(); });
			}
		}
		if (!bTookPart)
		{
			Log.Diagnostics.push_back({.Severity = ESeverity::Note,
				.Code = NotePluginIdle,
				.Message = Active.empty() ? "no extension of the plugin is active in this frame: " + JoinText(Names) +
												" said no in IsActiveThisFrame_Internal"
										  : "no extension of the plugin took part: " + Active +
												" subscribed nothing, added no pass and changed no setting",
				.Where = "plugin " + Plugin.substr(Plugin.rfind('/') + 1)});
		}
	}
}

} // namespace Drydock
