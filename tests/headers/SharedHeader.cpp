// What files of plugins use without an include, since the engine's shared precompiled header brings it. This file
// includes that header alone. That it compiles is the test.
#include "EngineSharedPCH.h"

DECLARE_LOG_CATEGORY_EXTERN(LogShared, Log, All);
DEFINE_LOG_CATEGORY(LogShared);

/** The renderer's view is only declared. */
void AddSharedPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View);

class FSharedBaseCS : public FGlobalShader
{
public:
	static constexpr uint32 GroupSize = 8;
};

/** Its base has no constructors: shaders are no polymorphic classes. */
class FSharedCS : public FSharedBaseCS
{
public:
	DECLARE_GLOBAL_SHADER(FSharedCS);
	SHADER_USE_PARAMETER_STRUCT(FSharedCS, FSharedBaseCS);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
		SHADER_PARAMETER_RDG_UNIFORM_BUFFER(FSceneTextureUniformParameters, SceneTextures)
		SHADER_PARAMETER_STRUCT_INCLUDE(FSceneTextureParameters, SceneTextureParameters)
		SHADER_PARAMETER(UINT, MipLevel)
	END_SHADER_PARAMETER_STRUCT()

	static void ModifyCompilationEnvironment(
		const FGlobalShaderPermutationParameters& Parameters, FShaderCompilerEnvironment& OutEnvironment)
	{
		FGlobalShader::ModifyCompilationEnvironment(Parameters, OutEnvironment);
		SET_SHADER_DEFINE(OutEnvironment, GROUP_SIZE, GroupSize);
	}
};
IMPLEMENT_GLOBAL_SHADER(FSharedCS, "/Plugin/Shared/Private/Shared.usf", "MainCS", SF_Compute);

class UShared : public UGameInstanceSubsystem
{
public:
	TObjectPtr<UTextureRenderTarget2D> Target = NULL;
	TSoftObjectPtr<UTexture> Table = TSoftObjectPtr<UTexture>(FSoftObjectPath(TEXT("/Shared/Table")).ResolveObject());

	FTextureResource* FindResource() const
	{
		return Target != nullptr && Target->GetSurfaceWidth() > 0.0f ? Target->GetResource() : nullptr;
	}
	UTextureRenderTarget2D* Load()
	{
		return LoadObject<UTextureRenderTarget2D>(nullptr, TEXT("/Shared/Target.Target"));
	}
	const FTexture* GetWhite() const { return GWhiteTexture; }
};

class FSharedModule : public IModuleInterface
{
public:
	void StartupModule() override
	{
		const FString Folder = FPaths::Combine(FPaths::ProjectPluginsDir(), TEXT("Shared/Shaders"));
		if (!AllShaderSourceDirectoryMappings().Contains(TEXT("/Plugin/Shared")))
		{
			AddShaderSourceDirectoryMapping(TEXT("/Plugin/Shared"), Folder);
		}
		UE_LOG(LogShared, Log, TEXT("%s"), *Folder);
	}

	static AWorldSettings* FindSettings(const UObject* Context)
	{
		UWorld* const World = GEngine->GetWorldFromContextObject(Context, EGetWorldErrorMode::LogAndReturnNull);
		for (const FWorldContext& Other : GEngine->GetWorldContexts())
		{
			if (Other.WorldType == EWorldType::Game && Other.World() == World)
			{
				return World->GetWorldSettings();
			}
		}
		return nullptr;
	}
};

class USharedInterface : public UInterface
{
};

class UMobileShared : public USceneComponent
{
public:
	UMobileShared() { SetMobility(EComponentMobility::Movable); }
	void PostEditChangeProperty(FPropertyChangedEvent& Event) override { Super::PostEditChangeProperty(Event); }
};

static_assert(!GSupportsEfficientAsyncCompute && GNumExplicitGPUsForRendering == 1);

/** What plugins ask before they draw or dispatch. */
bool CanDraw(const FIntVector& GroupCount)
{
	FComputeShaderUtils::ValidateGroupCount(GroupCount);
	FComputeShaderUtils::ValidateIndirectArgsBuffer(12u, 0);
	return !IsMetalMRTPlatform(GMaxRHIShaderPlatform) && !RHISupportsGeometryShaders(GMaxRHIShaderPlatform) &&
		   !RHISupportsVertexShaderLayer(GMaxRHIShaderPlatform) &&
		   !RHIVolumeTextureRenderingSupportGuaranteed(GMaxRHIShaderPlatform);
}
