// The registry of view extensions: order, activity and whose they are. Source: engine file SceneViewExtension.cpp
// (order and activity); the record of signatures is drydock's.
#include "SceneViewExtension.h"

#include "CodeScope.h"

#include <algorithm>
#include <cxxabi.h>
#include <set>

namespace
{

using FExtensionRef = TSharedRef<ISceneViewExtension, ESPMode::ThreadSafe>;

/** Never destroyed: static variables of any library may hold extensions until the very end. */
UEngine* MakeEngine()
{
	return new UEngine;
}

} // namespace

UEngine* GEngine = MakeEngine();

UEngine::UEngine()
	: ViewExtensions(MakeShared<FSceneViewExtensions>())
{
}

UEngine::~UEngine() = default;

UWorld* UEngine::GetWorldFromContextObject(const UObject* Object, EGetWorldErrorMode ErrorMode) const
{
	UWorld* const World = Object != nullptr ? Object->GetWorld() : nullptr;
	if (World == nullptr && ErrorMode != EGetWorldErrorMode::ReturnNull)
	{
		const FString Name = Object != nullptr ? Object->GetName() : FString(TEXT("null"));
		checkf(ErrorMode != EGetWorldErrorMode::Assert, "%s has no world", *Name);
		UE_LOG(LogRenderer, Warning, "GetWorldFromContextObject: %s has no world", *Name);
	}
	return World;
}

const TArray<FWorldContext>& UEngine::GetWorldContexts() const
{
	static const TArray<FWorldContext> Contexts = {
		FWorldContext{.ContextHandle = TEXT("Context_0"), .OwningGameInstance = GWorld->GetGameInstance()}};
	return Contexts;
}

void UEngine::AddOnScreenDebugMessage(uint64, float, FColor, const FString& DebugMessage, bool, const FVector2D&)
{
	static std::set<std::string> Shown; // frames repeat themselves
	if (Shown.insert(DebugMessage.ToStdString()).second)
	{
		UE_LOG(LogRenderer, Log, "On screen: %s", *DebugMessage);
	}
}

namespace Drydock
{

std::string GetTypeName(const std::type_info& Type)
{
	int Status = 0;
	char* const Demangled = abi::__cxa_demangle(Type.name(), nullptr, nullptr, &Status);
	std::string Name = Demangled != nullptr ? Demangled : Type.name();
	std::free(Demangled);
	const size_t Arguments = std::min(Name.find('<'), Name.size());
	const size_t Scope = Name.rfind("::", Arguments);
	return Scope == std::string::npos ? Name : Name.substr(Scope + 2);
}

} // namespace Drydock

ISceneViewExtension::~ISceneViewExtension() = default;

void ISceneViewExtension::SetupViewFamily(FSceneViewFamily&) {}
void ISceneViewExtension::SetupViewPoint(APlayerController*, FMinimalViewInfo&) {}
void ISceneViewExtension::SetupViewProjectionMatrix(FSceneViewProjectionData&) {}
void ISceneViewExtension::SetupView(FSceneViewFamily&, FSceneView&) {}
void ISceneViewExtension::BeginRenderViewFamily(FSceneViewFamily&) {}
void ISceneViewExtension::PostCreateSceneRenderer(const FSceneViewFamily&, ISceneRenderer*) {}
void ISceneViewExtension::PreRenderViewFamily_RenderThread(FRDGBuilder&, FSceneViewFamily&) {}
void ISceneViewExtension::PreRenderView_RenderThread(FRDGBuilder&, FSceneView&) {}
void ISceneViewExtension::PreInitViews_RenderThread(FRDGBuilder&) {}
void ISceneViewExtension::PreRenderBasePass_RenderThread(FRDGBuilder&, bool) {}
void ISceneViewExtension::PostRenderBasePassDeferred_RenderThread(
	FRDGBuilder&, FSceneView&, const FRenderTargetBindingSlots&, TRDGUniformBufferRef<FSceneTextureUniformParameters>)
{
}
void ISceneViewExtension::PostRenderBasePassMobile_RenderThread(FRHICommandList&, FSceneView&) {}
void ISceneViewExtension::PostRenderBasePassMobile_RenderThread(FRHICommandListImmediate&, FSceneView&) {}
void ISceneViewExtension::PostRenderBasePass_RenderThread(FRHICommandListImmediate&, FSceneView&) {}
void ISceneViewExtension::PostTLASBuild_RenderThread(FRDGBuilder&, FSceneView&) {}
void ISceneViewExtension::PrePostProcessPass_RenderThread(FRDGBuilder&, const FSceneView&, const FPostProcessingInputs&)
{
}
void ISceneViewExtension::PrePostProcessPassMobile_RenderThread(
	FRDGBuilder&, const FSceneView&, const FMobilePostProcessingInputs&)
{
}
void ISceneViewExtension::SubscribeToPostProcessingPass(EPostProcessingPass, FAfterPassCallbackDelegateArray&, bool) {}
void ISceneViewExtension::SubscribeToPostProcessingPass(
	EPostProcessingPass, const FSceneView&, FPostProcessingPassDelegateArray&, bool)
{
}
void ISceneViewExtension::PostRenderView_RenderThread(FRDGBuilder&, FSceneView&) {}
void ISceneViewExtension::PostRenderViewFamily_RenderThread(FRDGBuilder&, FSceneViewFamily&) {}
void ISceneViewExtension::PreRenderViewFamily_RenderThread(FRHICommandListImmediate&, FSceneViewFamily&) {}
void ISceneViewExtension::PreRenderView_RenderThread(FRHICommandListImmediate&, FSceneView&) {}
void ISceneViewExtension::PostRenderView_RenderThread(FRHICommandListImmediate&, FSceneView&) {}
void ISceneViewExtension::PostRenderViewFamily_RenderThread(FRHICommandListImmediate&, FSceneViewFamily&) {}

ESceneViewExtensionFlags ISceneViewExtension::GetFlags() const
{
	return ESceneViewExtensionFlags::None;
}

int32 ISceneViewExtension::GetPriority() const
{
	return 0;
}

bool ISceneViewExtension::IsActiveThisFrame(const FSceneViewExtensionContext&) const
{
	return true;
}

FSceneViewExtensionBase::FSceneViewExtensionBase(const FAutoRegister&) {}

FSceneViewExtensionBase::~FSceneViewExtensionBase() = default;

bool FSceneViewExtensionBase::IsActiveThisFrame(const FSceneViewExtensionContext& Context) const
{
	for (const FSceneViewExtensionIsActiveFunctor& Functor : IsActiveThisFrameFunctions)
	{
		const TOptional<bool> Answer = Functor(this, Context);
		if (Answer.IsSet())
		{
			return Answer.GetValue();
		}
	}
	return IsActiveThisFrame_Internal(Context);
}

bool FSceneViewExtensionBase::IsActiveThisFrame_Internal(const FSceneViewExtensionContext&) const
{
	return true;
}

FWorldSceneViewExtension::FWorldSceneViewExtension(const FAutoRegister& AutoRegister, UWorld* InWorld)
	: FSceneViewExtensionBase(AutoRegister)
	, World(InWorld)
{
}

bool FWorldSceneViewExtension::IsActiveThisFrame_Internal(const FSceneViewExtensionContext& Context) const
{
	return Context.GetWorld() == nullptr || Context.GetWorld() == World;
}

TArray<FExtensionRef> FSceneViewExtensions::GatherActiveExtensions(const FSceneViewExtensionContext& InContext) const
{
	// Strong references first: an extension may let go of others while it is asked.
	struct FAsked
	{
		FExtensionRef Extension;
		Drydock::FExtensionInfo Info;
		int32 Priority = 0;
	};
	std::vector<FAsked> Active;
	for (const FEntry& Entry : Entries)
	{
		if (const TSharedPtr<ISceneViewExtension, ESPMode::ThreadSafe> Extension = Entry.Extension.Pin())
		{
			Active.push_back({Extension.ToSharedRef(), Entry.Info});
		}
	}
	std::erase_if(Active,
		[&](const FAsked& Asked)
		{
			return !Drydock::CallCode(Asked.Info.MakeOwner("IsActiveThisFrame"),
				[&] { return Asked.Extension->IsActiveThisFrame(InContext); });
		});
	for (FAsked& Asked : Active)
	{
		Asked.Priority =
			Drydock::CallCode(Asked.Info.MakeOwner("GetPriority"), [&] { return Asked.Extension->GetPriority(); });
	}
	std::stable_sort(
		Active.begin(), Active.end(), [](const FAsked& A, const FAsked& B) { return A.Priority > B.Priority; });
	TArray<FExtensionRef> Result;
	for (const FAsked& Asked : Active)
	{
		Result.Add(Asked.Extension);
	}
	return Result;
}

const Drydock::FExtensionInfo* FSceneViewExtensions::FindInfo(const ISceneViewExtension& Extension) const
{
	const FEntry* Entry = const_cast<FSceneViewExtensions*>(this)->FindEntry(Extension);
	return Entry != nullptr ? &Entry->Info : nullptr;
}

void FSceneViewExtensions::SetInfo(const ISceneViewExtension& Extension, const Drydock::FExtensionInfo& Info)
{
	FEntry* Entry = FindEntry(Extension);
	check(Entry);
	Entry->Info = Info;
}

int32 FSceneViewExtensions::MarkPlugin(const std::string& Plugin, uint64 First)
{
	int32 NumMarked = 0;
	for (FEntry& Entry : Entries)
	{
		if (Entry.Registration >= First)
		{
			Entry.Info.Plugin = Plugin;
			++NumMarked;
		}
	}
	return NumMarked;
}

std::vector<std::string> FSceneViewExtensions::GetNamesOfPlugin(const std::string& Plugin) const
{
	std::vector<std::string> Names;
	for (const FEntry& Entry : Entries)
	{
		if (Entry.Info.Plugin == Plugin && Entry.Extension.IsValid())
		{
			Names.push_back(Entry.Info.Name);
		}
	}
	return Names;
}

void FSceneViewExtensions::ForgetPlugin(const std::string& Plugin)
{
	Entries.RemoveAll([&](const FEntry& Entry) { return Entry.Info.Plugin == Plugin; });
}

void FSceneViewExtensions::RegisterExtension(const FExtensionRef& Extension, Drydock::FExtensionInfo Info)
{
	FSceneViewExtensions& Registry = *GEngine->ViewExtensions;
	Info.Owner = Drydock::MakeCodeOwner("").Plugin;
	Registry.Entries.RemoveAll([](const FEntry& Entry) { return !Entry.Extension.IsValid(); });
	Registry.Entries.Add({Extension.ToWeakPtr(), &Extension.Get(), Registry.NextRegistration++, std::move(Info)});
}

FSceneViewExtensions::FEntry* FSceneViewExtensions::FindEntry(const ISceneViewExtension& Extension)
{
	return Entries.FindByPredicate(
		[&](const FEntry& Entry) { return Entry.Address == &Extension && Entry.Extension.IsValid(); });
}
