// The names of the engine's API that came, went or are deprecated between 5.1 and 5.8: the one table, from which come
// the guards on the declarations, `drydock build --engine-minor`, the column of `drydock matrix` and docs/versions.md.
// A row's macro stands before the declaration. A version counts where the build names one (DRYDOCK_ENGINE_NAMES);
// without it the headers have the names of all versions.
#pragma once

#include "Runtime/Launch/Resources/Version.h"

/** 2: what the version does not have is an error, and a warning where that is uncertain. 1: a warning in both cases. 0:
 * nothing. */
#ifndef DRYDOCK_ENGINE_NAMES
#define DRYDOCK_ENGINE_NAMES 0
#endif

#define DRYDOCK_TEXT_OF_VALUE(Value) DRYDOCK_TEXT_OF_TOKENS(Value)
#define DRYDOCK_TEXT_OF_TOKENS(...) #__VA_ARGS__
#define DRYDOCK_THIS_ENGINE "engine 5." DRYDOCK_TEXT_OF_VALUE(ENGINE_MINOR_VERSION)

#define DRYDOCK_LACKS_Uncertain(Name, When) \
	__attribute__((deprecated(DRYDOCK_THIS_ENGINE " does not have " Name ", which is there " When " (uncertain)")))
#if DRYDOCK_ENGINE_NAMES == 2
#define DRYDOCK_LACKS_Public(Name, When) \
	__attribute__((unavailable(DRYDOCK_THIS_ENGINE " does not have " Name ", which is there " When)))
#else
#define DRYDOCK_LACKS_Public(Name, When) \
	__attribute__((deprecated(DRYDOCK_THIS_ENGINE " does not have " Name ", which is there " When)))
#endif

#if DRYDOCK_ENGINE_NAMES && ENGINE_MINOR_VERSION < 4
#define DRYDOCK_FROM_4(Certainty, Name) DRYDOCK_LACKS_##Certainty(Name, "from 5.4 on")
#else
#define DRYDOCK_FROM_4(Certainty, Name)
#endif
#if DRYDOCK_ENGINE_NAMES && ENGINE_MINOR_VERSION < 5
#define DRYDOCK_FROM_5(Certainty, Name) DRYDOCK_LACKS_##Certainty(Name, "from 5.5 on")
#else
#define DRYDOCK_FROM_5(Certainty, Name)
#endif
#if DRYDOCK_ENGINE_NAMES && ENGINE_MINOR_VERSION < 7
#define DRYDOCK_FROM_7(Certainty, Name) DRYDOCK_LACKS_##Certainty(Name, "from 5.7 on")
#else
#define DRYDOCK_FROM_7(Certainty, Name)
#endif
#if DRYDOCK_ENGINE_NAMES && ENGINE_MINOR_VERSION > 4
#define DRYDOCK_UNTIL_4(Certainty, Name) DRYDOCK_LACKS_##Certainty(Name, "until 5.4")
#else
#define DRYDOCK_UNTIL_4(Certainty, Name)
#endif
#if DRYDOCK_ENGINE_NAMES && ENGINE_MINOR_VERSION > 6
#define DRYDOCK_UNTIL_6(Certainty, Name) DRYDOCK_LACKS_##Certainty(Name, "until 5.6")
#else
#define DRYDOCK_UNTIL_6(Certainty, Name)
#endif
#if DRYDOCK_ENGINE_NAMES && ENGINE_MINOR_VERSION >= 8
#define DRYDOCK_DEPRECATED_8(Certainty, Name, Instead) \
	__attribute__((deprecated(DRYDOCK_THIS_ENGINE " deprecates " Name ": use " Instead)))
#else
#define DRYDOCK_DEPRECATED_8(Certainty, Name, Instead)
#endif

#define DRYDOCK_FROM(Minor, Certainty, Name) DRYDOCK_FROM_##Minor(Certainty, Name)
#define DRYDOCK_UNTIL(Minor, Certainty, Name) DRYDOCK_UNTIL_##Minor(Certainty, Name)
#define DRYDOCK_DEPRECATED(Minor, Certainty, Name, Instead) DRYDOCK_DEPRECATED_##Minor(Certainty, Name, Instead)

// The table. Public: seen in two public sources. Uncertain: inferred, and may be off by a version.
// tests/pipeline/Patch/EngineApiTest.cpp checks that pipeline/Patch/EngineApi.cpp lists every row.
#define DRYDOCK_API_GetFlags DRYDOCK_FROM(7, Public, "ISceneViewExtension::GetFlags")
#define DRYDOCK_API_PostCreateSceneRenderer DRYDOCK_FROM(7, Public, "ISceneViewExtension::PostCreateSceneRenderer")
#define DRYDOCK_API_PostTLASBuild DRYDOCK_FROM(7, Public, "ISceneViewExtension::PostTLASBuild_RenderThread")
#define DRYDOCK_API_PreRenderBasePass DRYDOCK_FROM(4, Uncertain, "ISceneViewExtension::PreRenderBasePass_RenderThread")
#define DRYDOCK_API_SubscribeWithView \
	DRYDOCK_FROM(5, Public, "ISceneViewExtension::SubscribeToPostProcessingPass with a view")
#define DRYDOCK_API_Subscribe \
	DRYDOCK_UNTIL(4, Uncertain, "ISceneViewExtension::SubscribeToPostProcessingPass without a view")
#define DRYDOCK_API_BeforeDOF DRYDOCK_FROM(5, Public, "EPostProcessingPass::BeforeDOF")
#define DRYDOCK_API_AfterDOF DRYDOCK_FROM(5, Public, "EPostProcessingPass::AfterDOF")
#define DRYDOCK_API_TranslucencyAfterDOF DRYDOCK_FROM(5, Uncertain, "EPostProcessingPass::TranslucencyAfterDOF")
#define DRYDOCK_API_ReplacingTonemapper DRYDOCK_FROM(5, Uncertain, "EPostProcessingPass::ReplacingTonemapper")
#define DRYDOCK_API_SMAA DRYDOCK_FROM(7, Public, "EPostProcessingPass::SMAA")
#define DRYDOCK_API_CopyFromSlice DRYDOCK_FROM(4, Public, "FScreenPassTexture::CopyFromSlice")
#define DRYDOCK_API_CopyFromSliceOverride DRYDOCK_FROM(5, Uncertain, "FScreenPassTexture::CopyFromSlice with an output")
#define DRYDOCK_API_FTexture2DRHIRef DRYDOCK_UNTIL(6, Public, "FTexture2DRHIRef")
#define DRYDOCK_API_GetOnPostEngineInit DRYDOCK_FROM(7, Uncertain, "FCoreDelegates::GetOnPostEngineInit")
#define DRYDOCK_API_OnPostEngineInit \
	DRYDOCK_DEPRECATED(8, Public, "FCoreDelegates::OnPostEngineInit", "FCoreDelegates::GetOnPostEngineInit()")
#define DRYDOCK_API_RHICreateTexture \
	DRYDOCK_DEPRECATED(8, Uncertain, "RHICreateTexture", "FRHICommandListBase::CreateTexture")
