// Finds the hooks that an extension's class overrides, when the class is registered, without calling any. Hooks that
// the chosen engine version never calls can be reported.
#pragma once

#include "CoreMinimal.h"
#include "RunningCode.h"
#include "Runtime/Launch/Resources/Version.h"

#include <string>
#include <type_traits>
#include <typeinfo>

class ISceneViewExtension;

namespace Drydock
{

/** Every hook of ISceneViewExtension, in the order of a frame; a hook with two signatures is two. */
enum class EExtensionHook : uint8
{
	SetupViewFamily,
	SetupViewPoint,
	SetupViewProjectionMatrix,
	SetupView,
	BeginRenderViewFamily,
	PostCreateSceneRenderer,
	PreRenderViewFamily,
	PreRenderViewFamilyCommandList, // first argument FRHICommandListImmediate&
	PreRenderView,
	PreRenderViewCommandList,
	PreInitViews,
	PreRenderBasePass,
	PostRenderBasePassDeferred,
	PostRenderBasePassMobile,
	PostRenderBasePassMobileImmediate, // first argument FRHICommandListImmediate&
	PostRenderBasePass,                // of 5.0
	PostTLASBuild,
	PrePostProcessPass,
	PrePostProcessPassMobile,
	Subscribe,         // (Pass, Array&, bool)
	SubscribeWithView, // (Pass, View, Array&, bool)
	PostRenderView,
	PostRenderViewCommandList,
	PostRenderViewFamily,
	PostRenderViewFamilyCommandList,
	Num
};

/** Engine minor version of extensions that follow whatever version a run chooses: those drydock ships. */
constexpr int32 AnyEngineVersion = 0;

/** The description of a registered extension beyond its virtual functions. */
struct FExtensionInfo
{
	std::string Name;                         // its class, without namespaces
	int32 EngineMinor = ENGINE_MINOR_VERSION; // of engine 5, that it was compiled for; AnyEngineVersion
	uint32 Overrides = 0;                     // bits of EExtensionHook that its class declares
	std::string Plugin;                       // file of the plugin whose loading registered it; empty: none did
	std::string Owner;                        // name of the plugin whose code made it, then or later; empty: none

	bool Has(EExtensionHook Hook) const { return (Overrides >> static_cast<uint32>(Hook) & 1u) != 0; }
	/** "SetupView of extension FTint" */
	FCodeOwner MakeOwner(const std::string& Function) const { return {Owner, Function + " of extension " + Name}; }
};

/** Name of a type as a person writes it: no namespaces. */
DRYDOCK_API std::string GetTypeName(const std::type_info& Type);

namespace Private
{

/** The class that declares a member function, found by overload resolution on its signature. */
template<typename TSignature>
struct THookOwner;

template<typename TResult, typename... TArguments>
struct THookOwner<TResult(TArguments...)>
{
	template<typename TOwner>
	static std::type_identity<TOwner> Find(TResult (TOwner::*)(TArguments...));
};

} // namespace Private

/** True when T, or a base between it and the interface, declares Hook with that signature, where the registry can see
 * it (a private override counts as none). */
#define DRYDOCK_HAS_HOOK(T, Hook, ...) \
	requires \
	{ \
		requires !std::is_same_v<typename decltype(::Drydock::Private::THookOwner<void(__VA_ARGS__)>::Find( \
									 &T::Hook))::type, \
			ISceneViewExtension>; \
	}

} // namespace Drydock
