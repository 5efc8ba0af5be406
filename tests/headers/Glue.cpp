// UObject, module and engine glue as plugins write it around their passes. That it compiles is the test.
#include "Components/PrimitiveComponent.h"
#include "CompositingElements/CompositingElementPasses.h"
#include "Engine/BlendableInterface.h"
#include "Engine/DeveloperSettings.h"
#include "Engine/Engine.h"
#include "Engine/Texture2D.h"
#include "Engine/TextureRenderTarget2D.h"
#include "Engine/VolumeTexture.h"
#include "EngineUtils.h"
#include "GameFramework/Actor.h"
#include "Interfaces/IPluginManager.h"
#include "Kismet/BlueprintFunctionLibrary.h"
#include "Materials/MaterialInstanceDynamic.h"
#include "Misc/CoreDelegates.h"
#include "Misc/Paths.h"
#include "Modules/ModuleManager.h"
#include "RenderGraphUtils.h"
#include "SceneManagement.h"
#include "SceneViewExtension.h"
#include "ScreenPass.h"
#include "Subsystems/EngineSubsystem.h"
#include "Subsystems/GameInstanceSubsystem.h"
#include "Subsystems/WorldSubsystem.h"
#include "UObject/ConstructorHelpers.h"

#define GLUE_API

DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(FOnGlueChanged, float, NewValue);

UENUM(BlueprintType, meta = (Bitflags, UseEnumValuesAsMaskValuesInEditor = "true"))
enum class EGlueMode : uint8
{
	None = 0 UMETA(Hidden),
	Soft UMETA(DisplayName = "Soft, and a comma"),
	Hard,
};
ENUM_CLASS_FLAGS(EGlueMode)

USTRUCT(BlueprintType)
struct GLUE_API FGlueSettings
{
	GENERATED_USTRUCT_BODY()

	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Glue|Look", meta = (ClampMin = 0, UIMax = 1.0f))
	float Strength = 1.0f;
	UPROPERTY(EditAnywhere, Category = Glue)
	TSoftObjectPtr<UTexture2D> Mask;
	UE_DEPRECATED(5.3, "Use Strength.")
	float GetAmount() const { return Strength; }
};

UCLASS(config = Engine, defaultconfig, meta = (DisplayName = "Glue"))
class GLUE_API UGlueSettings : public UDeveloperSettings
{
	GENERATED_BODY()

public:
	UGlueSettings(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get())
		: Super(ObjectInitializer)
	{
		CategoryName = TEXT("Plugins");
	}
	virtual FName GetSectionName() const override { return FName("Glue"); }
#if WITH_EDITOR
	virtual void PostEditChangeProperty(FPropertyChangedEvent& Event) override;
#endif
	UPROPERTY(config, EditAnywhere, Category = "Glue")
	FGlueSettings Settings;
};

UINTERFACE(MinimalAPI)
class UGlueInterface : public UBlendableInterface
{
	GENERATED_BODY()
};

UCLASS(ClassGroup = (Rendering), meta = (BlueprintSpawnableComponent), hidecategories = (Object, LOD))
class GLUE_API UGlueComponent : public USceneComponent, public IBlendableInterface
{
	GENERATED_BODY()

public:
	UGlueComponent()
	{
		PrimaryComponentTick.bCanEverTick = true;
		bAutoActivate = true;
		static ConstructorHelpers::FObjectFinder<UTexture2D> Finder(TEXT("/Engine/Missing.Missing"));
		Mask = Finder.Succeeded() ? Finder.Object : nullptr;
	}
	virtual void OnRegister() override { Super::OnRegister(); }
	virtual void BeginPlay() override
	{
		Super::BeginPlay();
		OnChanged.AddDynamic(this, &UGlueComponent::SetStrengthTo);
		OnChanged.Broadcast(1.0f);
	}
	virtual void EndPlay(const EEndPlayReason::Type Reason) override { Super::EndPlay(Reason); }
	virtual void TickComponent(
		float DeltaTime, ELevelTick TickType, FActorComponentTickFunction* ThisTickFunction) override
	{
		Super::TickComponent(DeltaTime, TickType, ThisTickFunction);
	}

	UFUNCTION()
	void SetStrengthTo(float NewValue) { Strength = NewValue; }
	UFUNCTION(BlueprintCallable, Category = "Glue")
	void SetStrength(UPARAM(ref) float& InStrength) { Strength = InStrength; }

	UPROPERTY(BlueprintAssignable)
	FOnGlueChanged OnChanged;
	UPROPERTY(EditAnywhere, Category = "Glue")
	TObjectPtr<UTexture2D> Mask;
	UPROPERTY(EditAnywhere, Category = "Glue")
	UTextureRenderTarget2D* Target = nullptr;
	UPROPERTY(Transient)
	UMaterialInstanceDynamic* Material = nullptr;
	float Strength = 1.0f;
};

UCLASS()
class GLUE_API AGlueActor : public AActor
{
	GENERATED_BODY()

public:
	AGlueActor()
	{
		PrimaryActorTick.bCanEverTick = true;
		RootComponent = CreateDefaultSubobject<USceneComponent>(TEXT("Root"));
		Glue = CreateDefaultSubobject<UGlueComponent>(TEXT("Glue"));
		Glue->SetupAttachment(RootComponent);
	}
	virtual void Tick(float DeltaTime) override { Super::Tick(DeltaTime); }

	UPROPERTY(VisibleAnywhere, Category = "Glue")
	TObjectPtr<UGlueComponent> Glue;
};

UCLASS()
class UGlueLibrary : public UBlueprintFunctionLibrary
{
	GENERATED_BODY()

public:
	UFUNCTION(BlueprintPure, Category = "Glue", meta = (WorldContext = "WorldContextObject"))
	static float GetStrength(const UObject* WorldContextObject)
	{
		UWorld* World = WorldContextObject ? WorldContextObject->GetWorld() : nullptr;
		return IsValid(World) ? GetDefault<UGlueSettings>()->Settings.Strength : 0.0f;
	}
};

UCLASS()
class UGlueTicker : public UTickableWorldSubsystem
{
	GENERATED_BODY()

public:
	virtual bool ShouldCreateSubsystem(UObject* Outer) const override { return Super::ShouldCreateSubsystem(Outer); }
	virtual void Tick(float DeltaTime) override { Super::Tick(DeltaTime); }
	virtual TStatId GetStatId() const override { RETURN_QUICK_DECLARE_CYCLE_STAT(UGlueTicker, STATGROUP_Tickables); }
};

class FGlueModule : public IModuleInterface
{
public:
	virtual void StartupModule() override
	{
		TSharedPtr<IPlugin> Plugin = IPluginManager::Get().FindPlugin(TEXT("Glue"));
		const FString ShaderDir = FPaths::Combine(Plugin->GetBaseDir(), TEXT("Shaders"));
		AddShaderSourceDirectoryMapping(TEXT("/Plugin/Glue"), ShaderDir);
		FCoreDelegates::OnPostEngineInit.AddRaw(this, &FGlueModule::OnPostEngineInit);
		FCoreDelegates::GetOnPostEngineInit().AddLambda([]() {});
	}
	virtual void ShutdownModule() override { FCoreDelegates::OnPostEngineInit.RemoveAll(this); }
	static FGlueModule& Get() { return FModuleManager::LoadModuleChecked<FGlueModule>("Glue"); }

private:
	void OnPostEngineInit() { check(GEngine); }
};

IMPLEMENT_MODULE(FGlueModule, Glue)

/** The renderer by its name; what shaders take in two steps; the working colour space. */
void SetGlueParameters(FRHICommandList& RHICmdList, const TShaderRef<FCopyRectPS>& Shader,
	const FCopyRectPS::FParameters& Parameters, const FSceneView& View)
{
	IRendererModule* RendererModule = &FModuleManager::LoadModuleChecked<IRendererModule>(TEXT("Renderer"));
	check(RendererModule);
	FRHIBatchedShaderParameters& BatchedParameters = RHICmdList.GetScratchShaderParameters();
	FGlobalShader::SetParameters<FViewUniformShaderParameters>(BatchedParameters, View.ViewUniformBuffer);
	SetShaderParameters(BatchedParameters, Shader, Parameters);
	RHICmdList.SetBatchedShaderParameters(RHICmdList.GetBoundPixelShader(), BatchedParameters);
	TUniformBufferRef<FWorkingColorSpaceShaderParameters> Buffer =
		GDefaultWorkingColorSpaceUniformBuffer.GetUniformBufferRef();
	Buffer.UpdateUniformBufferImmediate(RHICmdList, FWorkingColorSpaceShaderParameters());
	const EDrawRectangleFlags Flags = EDRF_UseTriangleOptimization;
	DrawRectangle(RHICmdList, 0, 0, 1, 1, 0, 0, 1, 1, FIntPoint(1, 1), FIntPoint(1, 1), Shader, Flags);
}

/** A pass of a compositing element, which none runs here. */
UCLASS()
class UGluePass : public UCompositingElementTransform
{
	GENERATED_BODY()

public:
	virtual UTexture* ApplyTransform_Implementation(
		UTexture* Input, UComposurePostProcessingPassProxy* PostProcessProxy, ACameraActor* TargetCamera) override
	{
		UTextureRenderTarget2D* Target = RequestRenderTarget(FIntPoint(1, 1), PF_FloatRGBA);
		return Target ? Target : Input;
	}

	FTimerHandle Timer;
};

/** An external target and an external texture, into the graph. */
FRDGTextureRef RegisterTextures(FRDGBuilder& GraphBuilder, UGlueComponent& Component)
{
	FTextureRenderTargetResource* Resource = Component.Target->GameThread_GetRenderTargetResource();
	FRDGTextureRef Target = GraphBuilder.RegisterExternalTexture(
		CreateRenderTarget(Resource->GetRenderTargetTexture(), TEXT("GlueTarget")));
	if (Component.Mask && Component.Mask->GetResource())
	{
		FTextureRHIRef MaskRHI = Component.Mask->GetResource()->TextureRHI;
		return RegisterExternalTexture(GraphBuilder, MaskRHI, TEXT("GlueMask"));
	}
	return Target;
}

/** Worlds, subsystems and weak pointers. */
int32 CountGlue(const FSceneViewFamily& Family)
{
	UWorld* World = Family.Scene->GetWorld();
	TWeakObjectPtr<UGlueTicker> Ticker = World->GetSubsystem<UGlueTicker>();
	TStrongObjectPtr<UGlueSettings> Settings(GetMutableDefault<UGlueSettings>());
	int32 Count = Ticker.IsValid() && Settings.IsValid() ? 1 : 0;
	for (TActorIterator<AGlueActor> It(World); It; ++It)
	{
		Count += It->Glue->IsRegistered();
	}
	return Count;
}
