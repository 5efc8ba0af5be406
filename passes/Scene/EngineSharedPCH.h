// Includes what modules of the engine get without an include. With `PCHUsage = UseExplicitOrSharedPCHs` every file of a
// plugin starts with a shared precompiled header of Core, CoreUObject, RHI, RenderCore and Engine, and published
// plugins lean on it. drydock_add_plugin precompiles this header and begins every file of a plugin with it; drydock's
// own code includes what it names. The renderer's private headers are not included. Source: engine file
// EngineSharedPCH.h.
#pragma once

// Core, CoreUObject, Projects
#include "Async/Async.h"
#include "CoreMinimal.h"
#include "HAL/FileManager.h"
#include "Interfaces/IPluginManager.h"
#include "Misc/CoreDelegates.h"
#include "Misc/FileHelper.h"
#include "Misc/Paths.h"
#include "Modules/ModuleManager.h"
#include "UObject/ConstructorHelpers.h"
#include "UObject/Object.h"
#include "UObject/ScriptDelegates.h"

// RHI, RenderCore
#include "CommonRenderResources.h"
#include "Containers/DynamicRHIResourceArray.h"
#include "GlobalShader.h"
#include "PipelineStateCache.h"
#include "RHI.h"
#include "RHICommandList.h"
#include "RHIResources.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "RenderResource.h"
#include "RenderTargetPool.h"
#include "RenderUtils.h"
#include "RendererInterface.h"
#include "RenderingThread.h"
#include "ShaderCore.h"
#include "ShaderParameterStruct.h"
#include "ShaderParameterUtils.h"
#include "ShaderPermutation.h"
#include "TextureResource.h"
#include "UniformBuffer.h"

// Engine
#include "Components/MeshComponent.h"
#include "Components/PrimitiveComponent.h"
#include "Components/SceneComponent.h"
#include "Engine/BlendableInterface.h"
#include "Engine/DataAsset.h"
#include "Engine/DeveloperSettings.h"
#include "Engine/Engine.h"
#include "Engine/GameViewportClient.h"
#include "Engine/Texture.h"
#include "Engine/TextureRenderTarget2D.h"
#include "Engine/World.h"
#include "EngineUtils.h"
#include "GameFramework/Actor.h"
#include "GameFramework/Pawn.h"
#include "GameFramework/WorldSettings.h"
#include "Kismet/BlueprintFunctionLibrary.h"
#include "Materials/MaterialInterface.h"
#include "PostProcessSettings.h"
#include "PrimitiveSceneProxy.h"
#include "SceneInterface.h"
#include "SceneTextureParameters.h"
#include "SceneView.h"
#include "Subsystems/EngineSubsystem.h"
#include "Subsystems/GameInstanceSubsystem.h"
#include "Subsystems/LocalPlayerSubsystem.h"
#include "Subsystems/WorldSubsystem.h"
#include "UnrealClient.h"

// On Windows its own headers come with the shared one.
using UINT = unsigned int;
