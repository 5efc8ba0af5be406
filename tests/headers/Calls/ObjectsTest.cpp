// Calls on objects: reflection's macros, the world, actors, components, subsystems, textures, modules.
#include "Calls.h"

#include "AbsentClasses.h"
#include "Camera/CameraComponent.h"
#include "Components/DirectionalLightComponent.h"
#include "Components/PrimitiveComponent.h"
#include "Curves/CurveFloat.h"
#include "Engine/BlendableInterface.h"
#include "Engine/DataAsset.h"
#include "Engine/DeveloperSettings.h"
#include "Engine/DirectionalLight.h"
#include "Engine/Engine.h"
#include "Engine/GameViewportClient.h"
#include "Engine/Texture2D.h"
#include "Engine/TextureRenderTarget2D.h"
#include "Engine/TextureRenderTargetVolume.h"
#include "Engine/World.h"
#include "EngineUtils.h"
#include "GameFramework/Actor.h"
#include "GameFramework/WorldSettings.h"
#include "HAL/FileManager.h"
#include "Interfaces/IPluginManager.h"
#include "Kismet/GameplayStatics.h"
#include "Kismet/KismetRenderingLibrary.h"
#include "Kismet/KismetSystemLibrary.h"
#include "Logging/LogMacros.h"
#include "Materials/MaterialInstanceDynamic.h"
#include "Modules/ModuleManager.h"
#include "Subsystems/EngineSubsystem.h"
#include "Subsystems/GameInstanceSubsystem.h"
#include "Subsystems/WorldSubsystem.h"
#include "UObject/ConstructorHelpers.h"
#include "UObject/ScriptDelegates.h"

#include <memory>

DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(FCallsChanged, float, Value);

namespace
{

constexpr Calls::EArea Area = Calls::EArea::Objects;

UENUM(BlueprintType)
enum class ECallsKind : uint8
{
	One UMETA(DisplayName = "One"),
	Two,
};

USTRUCT(BlueprintType)
struct FCallsStruct
{
	GENERATED_BODY()

	UPROPERTY(EditAnywhere)
	float Value = 1.0f;
};

UCLASS(ClassGroup = (Custom), meta = (BlueprintSpawnableComponent))
class UCallsComponent : public USceneComponent
{
	GENERATED_BODY()

public:
	DRYDOCK_CLASS(UCallsComponent, USceneComponent)

	void OnRegister() override { bRegisteredOnce = true; }
	void BeginPlay() override
	{
		USceneComponent::BeginPlay();
		bPlays = true;
	}
	UFUNCTION(BlueprintCallable)
	void Change(float Value) { Last = Value; }

	bool bRegisteredOnce = false;
	bool bPlays = false;
	float Last = 0.0f;
	FCallsChanged OnChanged;
};

class ACallsActor : public AActor
{
public:
	DRYDOCK_CLASS(ACallsActor, AActor)

	ACallsActor()
	{
		PrimaryActorTick.bCanEverTick = true;
		RootComponent = CreateDefaultSubobject<USceneComponent>(TEXT("Root"));
		Part = CreateDefaultSubobject<UCallsComponent>(TEXT("Part"));
		Part->SetupAttachment(RootComponent);
	}
	void BeginPlay() override
	{
		AActor::BeginPlay();
		bPlays = true;
	}

	TObjectPtr<UCallsComponent> Part;
	bool bPlays = false;
};

UCLASS(Config = Game, defaultconfig)
class UCallsSettings : public UDeveloperSettings
{
	GENERATED_BODY()

public:
	UPROPERTY(Config, EditAnywhere)
	float Strength = 0.5f;
};

} // namespace

TEST(CallsOfObjects, Objects)
{
	UObject Object;
	CALL("UCLASS, USTRUCT, UENUM, UMETA, UPROPERTY, UFUNCTION, GENERATED_BODY",
		FCallsStruct().Value == 1.0f && ECallsKind::One != ECallsKind::Two);
	const std::unique_ptr<UCallsComponent> Component(NewObject<UCallsComponent>(&Object, TEXT("Name")));
	CALL("NewObject<T>(Outer, Name), GetOuter, GetName, GetFName", Component->GetOuter() == &Object &&
																	   Component->GetName() == TEXT("Name") &&
																	   Component->GetFName() == FName(TEXT("Name")));
	CALL("NewObject<T>(Outer, Class)",
		std::unique_ptr<USceneComponent>(NewObject<USceneComponent>(&Object, UCallsComponent::StaticClass()))
			->IsA<UCallsComponent>());
	CALL("T::StaticClass, UClass::GetName, GetSuperClass",
		UCallsComponent::StaticClass()->GetName() == TEXT("CallsComponent") &&
			UCallsComponent::StaticClass()->GetSuperClass() == USceneComponent::StaticClass());
	CALL("UClass::IsChildOf, GetDefaultObject",
		UCallsComponent::StaticClass()->IsChildOf(UActorComponent::StaticClass()) &&
			UCallsComponent::StaticClass()->GetDefaultObject() != nullptr);
	CALL("UObject::GetClass, IsA",
		Component->GetClass() == UCallsComponent::StaticClass() && Component->IsA<USceneComponent>());
	CALL("TSubclassOf",
		TSubclassOf<USceneComponent>(UCallsComponent::StaticClass()).Get() == UCallsComponent::StaticClass());
	CALL("Cast, CastChecked", Cast<UCallsComponent>(static_cast<UObject*>(Component.get())) == Component.get() &&
								  Cast<AActor>(&Object) == nullptr && CastChecked<UObject>(Component.get()) != nullptr);
	CALL("IsValid", IsValid(&Object) && !IsValid(nullptr));
	CALL("GetDefault, GetMutableDefault", GetDefault<UCallsSettings>()->Strength == 0.5f &&
											  GetMutableDefault<UCallsSettings>() == GetDefault<UCallsSettings>());
	CALL("TObjectPtr", TObjectPtr<UObject>(&Object).Get() == &Object && !TObjectPtr<UObject>());
	CALL("TWeakObjectPtr::IsValid, Get",
		[]
		{
			TWeakObjectPtr<UObject> Weak;
			{
				UObject Short;
				Weak = &Short;
				if (Weak.Get() != &Short)
				{
					return false;
				}
			}
			return !Weak.IsValid();
		}());
	CALL("TStrongObjectPtr", TStrongObjectPtr<UObject>(&Object).IsValid());
	CALL("TSoftObjectPtr, FSoftObjectPath::ToString, IsValid",
		TSoftObjectPtr<UObject>(FSoftObjectPath(TEXT("/Game/A.A"))).ToString() == TEXT("/Game/A.A") &&
			FSoftObjectPath(TEXT("/Game/A.A")).IsValid());
	CALL("UObject::GetWorld", Object.GetWorld() == nullptr);
	CALL("UObject::PostInitProperties, PostLoad, BeginDestroy, PostEditChangeProperty",
		(Object.PostLoad(), Object.BeginDestroy(), true));
	COMPILES("FObjectInitializer, CreateDefaultSubobject",
		FObjectInitializer::Get().CreateDefaultSubobject<UObject>(&Object, TEXT("Part")));
	CALL("DECLARE_DYNAMIC_MULTICAST_DELEGATE, AddDynamic, Broadcast",
		[&]
		{
			Component->OnChanged.AddDynamic(Component.get(), &UCallsComponent::Change);
			Component->OnChanged.Broadcast(3.0f);
			return Component->Last == 3.0f;
		}());
	Calls::FLogLines Log;
	NEUTRAL("LoadObject",
		LoadObject<UTexture2D>(nullptr, TEXT("/Game/Calls.One")) == nullptr && Log.Has("/Game/Calls.One"));
	NEUTRAL("TSoftObjectPtr::LoadSynchronous",
		TSoftObjectPtr<UTexture2D>(FSoftObjectPath(TEXT("/Game/Calls.Two"))).LoadSynchronous() == nullptr &&
			Log.Has("/Game/Calls.Two"));
	NEUTRAL("FSoftObjectPath::TryLoad",
		FSoftObjectPath(TEXT("/Game/Calls.Three")).TryLoad() == nullptr && Log.Has("/Game/Calls.Three"));
	NEUTRAL("ConstructorHelpers::FObjectFinder",
		!ConstructorHelpers::FObjectFinder<UTexture2D>(TEXT("/Game/Calls.Four")).Succeeded() &&
			Log.Has("/Game/Calls.Four"));
	CALL("FindObject (null: objects have no paths)", FindObject<UObject>(nullptr, TEXT("A")) == nullptr);
}

TEST(CallsOfObjects, WorldAndActors)
{
	CALL("GWorld, GEngine", GWorld != nullptr && GEngine != nullptr);
	CALL("GEngine->GetWorldFromContextObject, EGetWorldErrorMode",
		GEngine->GetWorldFromContextObject(GWorld, EGetWorldErrorMode::ReturnNull) == GWorld);
	CALL("GEngine->GetWorldContexts, FWorldContext::World",
		GEngine->GetWorldContexts().Num() == 1 && GEngine->GetWorldContexts()[0].World() == GWorld);
	CALL("GEngine->GameViewport, UWorld::GetGameViewport (null: no window)",
		GEngine->GameViewport == nullptr && GWorld->GetGameViewport() == nullptr);
	CALL("UGameViewportClient, ULocalPlayer",
		[]
		{
			FVector2D Size(1, 1);
			UGameViewportClient().GetViewportSize(Size);
			return Size == FVector2D(0, 0) && ULocalPlayer().ViewportClient == nullptr;
		}());
	CALL("GEngine->AddOnScreenDebugMessage",
		(GEngine->AddOnScreenDebugMessage(0, 1.0f, FColor::White, TEXT("Calls")), true));
	CALL("GEngine->GetEngineSubsystem, UWorld::GetSubsystem, UGameInstance::GetSubsystem",
		GEngine->GetEngineSubsystem<UEngineSubsystem>() == nullptr &&
			GWorld->GetSubsystem<UWorldSubsystem>() == nullptr &&
			GWorld->GetGameInstance()->GetSubsystem<UGameInstanceSubsystem>() == nullptr);
	CALL("UWorld::WorldType, IsGameWorld, IsPreviewWorld, IsEditorWorld, EWorldType",
		GWorld->WorldType == EWorldType::Game && GWorld->IsGameWorld() && !GWorld->IsEditorWorld());
	CALL("UWorld::Scene, GetGameInstance, GetWorldSettings, HasBegunPlay",
		GWorld->Scene->GetWorld() == GWorld && GWorld->GetWorldSettings() != nullptr && GWorld->HasBegunPlay());
	CALL("UWorld::GetTimeSeconds, GetDeltaSeconds, GetRealTimeSeconds",
		GWorld->GetTimeSeconds() >= 0.0 && GWorld->GetDeltaSeconds() >= 0.0f && GWorld->GetRealTimeSeconds() >= 0.0);
	CALL("UWorld::GetFirstPlayerController (null: nobody plays)", GWorld->GetFirstPlayerController() == nullptr);
	ACallsActor* const Actor = GWorld->SpawnActor<ACallsActor>(FVector(1, 2, 3), FRotator(0, 90, 0));
	CALL("UWorld::SpawnActor<T>(Location, Rotation), AActor::BeginPlay", Actor->bPlays);
	CALL("AActor::GetActorLocation, GetActorRotation, SetActorLocation, SetActorRotation",
		Actor->GetActorLocation() == FVector(1, 2, 3) && Actor->GetActorRotation().Equals(FRotator(0, 90, 0)) &&
			Actor->SetActorLocation(FVector(4, 5, 6)) && Actor->GetActorLocation().X == 4.0);
	CALL("AActor::GetActorForwardVector", Actor->GetActorForwardVector().Equals(FVector(0, 1, 0), 1e-6));
	CALL("AActor::RootComponent, CreateDefaultSubobject, SetupAttachment, GetRootComponent",
		Actor->GetRootComponent() == Actor->RootComponent &&
			Actor->Part->GetAttachParent() == Actor->GetRootComponent());
	CALL("AActor::FindComponentByClass", Actor->FindComponentByClass<UCallsComponent>() == Actor->Part);
	CALL("AActor::PrimaryActorTick, SetActorTickEnabled", Actor->PrimaryActorTick.bCanEverTick);
	CALL("AActor::IsHidden, SetActorHiddenInGame",
		[&]
		{
			Actor->SetActorHiddenInGame(true);
			return Actor->IsHidden();
		}());
	CALL("AActor::GetActorTimeDilation, CustomTimeDilation", Actor->GetActorTimeDilation() == 1.0f);
	CALL("AActor::GetWorld", Actor->GetWorld() == GWorld);
	CALL("UActorComponent::GetOwner, OnRegister, BeginPlay, IsRegistered",
		Actor->Part->GetOwner() == Actor && Actor->Part->bRegisteredOnce && Actor->Part->bPlays &&
			Actor->Part->IsRegistered());
	CALL("UActorComponent::PrimaryComponentTick, Activate, Deactivate, IsActive",
		(Actor->Part->Activate(), Actor->Part->IsActive()) && (Actor->Part->Deactivate(), !Actor->Part->IsActive()));
	CALL("UActorComponent::RegisterComponent, UnregisterComponent, MarkRenderStateDirty",
		[&]
		{
			const std::unique_ptr<UCallsComponent> C(NewObject<UCallsComponent>(Actor));
			C->RegisterComponent();
			const bool b = C->IsRegistered();
			C->UnregisterComponent();
			C->MarkRenderStateDirty();
			return b && !C->IsRegistered();
		}());
	CALL("USceneComponent::GetComponentLocation, SetWorldLocation, GetComponentRotation, SetWorldRotation",
		[&]
		{
			Actor->Part->SetWorldLocation(FVector(7, 8, 9));
			return Actor->Part->GetComponentLocation() == FVector(7, 8, 9);
		}());
	CALL("TActorIterator",
		[&]
		{
			int32 Num = 0;
			for (TActorIterator<ACallsActor> It(GWorld); It; ++It)
			{
				Num += *It == Actor;
			}
			return Num == 1;
		}());
	CALL("UGameplayStatics::GetAllActorsOfClass, GetActorOfClass",
		[&]
		{
			TArray<AActor*> Actors;
			UGameplayStatics::GetAllActorsOfClass(GWorld, ACallsActor::StaticClass(), Actors);
			return Actors.Num() == 1 && UGameplayStatics::GetActorOfClass(GWorld, ACallsActor::StaticClass()) == Actor;
		}());
	CALL("UGameplayStatics::GetWorldDeltaSeconds, GetTimeSeconds",
		UGameplayStatics::GetWorldDeltaSeconds(GWorld) >= 0.0 && UGameplayStatics::GetTimeSeconds(GWorld) >= 0.0);
	Calls::FLogLines Log;
	NEUTRAL("UGameplayStatics::GetPlayerController",
		UGameplayStatics::GetPlayerController(GWorld, 0) == nullptr && Log.Has("GetPlayerController"));
	NEUTRAL("UGameplayStatics::GetPlayerPawn",
		UGameplayStatics::GetPlayerPawn(GWorld, 0) == nullptr && Log.Has("GetPlayerPawn"));
	NEUTRAL("UGameplayStatics::GetPlayerCameraManager",
		UGameplayStatics::GetPlayerCameraManager(GWorld, 0) == nullptr && Log.Has("GetPlayerCameraManager"));
	CALL("UKismetSystemLibrary::PrintString", (UKismetSystemLibrary::PrintString(GWorld, TEXT("CallsPrint")), true));
	static TAutoConsoleVariable<int32> CVar(TEXT("r.CallsObjects"), 1, TEXT("Help"));
	CALL("UKismetSystemLibrary::ExecuteConsoleCommand (a variable)",
		(UKismetSystemLibrary::ExecuteConsoleCommand(GWorld, TEXT("r.CallsObjects 3")),
			CVar.GetValueOnAnyThread() == 3));
	NEUTRAL("UKismetSystemLibrary::ExecuteConsoleCommand (another command)",
		(UKismetSystemLibrary::ExecuteConsoleCommand(GWorld, TEXT("calls nothing")), Log.Has("calls nothing")));
	const std::unique_ptr<UCameraComponent> Camera(NewObject<UCameraComponent>(Actor));
	Camera->SetFieldOfView(60.0f);
	Camera->RegisterComponent();
	NEUTRAL("UCameraComponent", Log.Has("UCameraComponent"));
	CALL("UCameraComponent::SetFieldOfView, GetCameraView",
		[&]
		{
			FMinimalViewInfo View;
			Camera->GetCameraView(0.0f, View);
			return View.FOV == 60.0f;
		}());
	const std::unique_ptr<UPostProcessComponent> PostProcess(NewObject<UPostProcessComponent>(Actor));
	PostProcess->Settings.BloomIntensity = 2.0f;
	PostProcess->RegisterComponent();
	NEUTRAL("UPostProcessComponent::Settings, Priority, BlendWeight, bUnbound",
		Log.Has("UPostProcessComponent") && PostProcess->bUnbound);
	CALL("AActor::Destroy",
		(Actor->Destroy(), UGameplayStatics::GetActorOfClass(GWorld, ACallsActor::StaticClass()) == nullptr));
	CALL("ADirectionalLight, UDirectionalLightComponent",
		UDirectionalLightComponent::StaticClass()->IsChildOf<USceneComponent>());
	CALL("UDataAsset, UPrimaryDataAsset", UPrimaryDataAsset::StaticClass()->IsChildOf<UDataAsset>());
	CALL("UEngineSubsystem, UWorldSubsystem, UGameInstanceSubsystem, FSubsystemCollectionBase",
		UWorldSubsystem::StaticClass()->IsChildOf<USubsystem>());
	CALL("UDeveloperSettings::GetSectionName, CategoryName", UDeveloperSettings::StaticClass()->IsChildOf<UObject>());
	CALL("IBlendableInterface::OverrideBlendableSettings", UMaterialInterface::StaticClass() != nullptr);
	CALL("IPluginManager::Get, FindPlugin, GetBaseDir", !IPluginManager::Get().FindPlugin(TEXT("Nowhere")).IsValid());
	COMPILES("IModuleInterface: StartupModule, ShutdownModule, IMPLEMENT_MODULE", struct FModule
			 : IModuleInterface{void StartupModule() override{} void ShutdownModule() override{}};
			 FModule Module);
	CALL("IFileManager::Get, FileExists, DirectoryExists", IFileManager::Get().DirectoryExists(TEXT("/tmp")));
}

TEST(CallsOfObjects, TexturesAndCurves)
{
	const std::unique_ptr<UTexture2D> Texture(UTexture2D::CreateTransient(2, 1, PF_B8G8R8A8));
	CALL("UTexture2D::CreateTransient, GetSizeX, GetSizeY", Texture->GetSizeX() == 2 && Texture->GetSizeY() == 1);
	CALL("UTexture2D::GetPlatformData, Mips, BulkData.Lock, Unlock",
		[&]
		{
			static_cast<uint8*>(Texture->GetPlatformData()->Mips[0].BulkData.Lock(LOCK_READ_WRITE))[2] = 255;
			Texture->GetPlatformData()->Mips[0].BulkData.Unlock();
			return Texture->GetPlatformData()->PixelFormat == PF_B8G8R8A8;
		}());
	Texture->SRGB = false;
	Texture->Filter = TF_Nearest;
	Texture->AddressX = TA_Clamp;
	Texture->AddressY = TA_Clamp;
	Texture->UpdateResource();
	CALL("UTexture2D::UpdateResource, SRGB, Filter, AddressX, AddressY",
		Texture->GetResource()->TextureRHI->ReadTexel(0, 0).R == 1.0f);
	Texture->CompressionSettings = TC_VectorDisplacementmap;
	Texture->MipGenSettings = TMGS_NoMipmaps;
	Texture->LODGroup = TEXTUREGROUP_Pixels2D;
	Texture->NeverStream = true;
	CALL("UTexture2D::CompressionSettings, MipGenSettings, LODGroup, NeverStream (no mips are made, nothing is packed)",
		Texture->GetResource()->TextureRHI->GetNumMips() == 1);
	CALL("UTexture::GetResource, Resource, FTextureResource::TextureRHI, GetTexture2DRHI",
		Texture->GetResource() == Texture->Resource &&
			Texture->GetResource()->GetTexture2DRHI() == Texture->GetResource()->TextureRHI);
	CALL("UTexture::GetSurfaceWidth, GetSurfaceHeight",
		Texture->GetSurfaceWidth() == 2.0f && Texture->GetSurfaceHeight() == 1.0f);
	UTextureRenderTarget2D Target;
	Target.ClearColor = FLinearColor(1, 0, 0, 1);
	Target.RenderTargetFormat = RTF_RGBA8;
	Target.bCanCreateUAV = true;
	Target.InitAutoFormat(2, 2);
	CALL("UTextureRenderTarget2D::InitAutoFormat, ClearColor, RenderTargetFormat, bCanCreateUAV, SizeX, SizeY",
		Target.SizeX == 2 && Target.GetFormat() == PF_B8G8R8A8);
	TArray<FColor> Pixels;
	CALL("GameThread_GetRenderTargetResource, ReadPixels",
		Target.GameThread_GetRenderTargetResource()->ReadPixels(Pixels) && Pixels.Num() == 4 &&
			Pixels[0] == FColor(255, 0, 0));
	TArray<FLinearColor> LinearPixels;
	CALL(
		"FRenderTarget::ReadLinearColorPixels", Target.GetRenderTargetResource()->ReadLinearColorPixels(LinearPixels) &&
													LinearPixels[3] == FLinearColor(1, 0, 0, 1));
	CALL("GetRenderTargetResource, GetRenderTargetTexture, GetSizeXY",
		Target.GetRenderTargetResource()->GetRenderTargetTexture().IsValid() &&
			Target.GetRenderTargetResource()->GetSizeXY() == FIntPoint(2, 2));
	CALL("UTextureRenderTarget2D::InitCustomFormat, UpdateResource, UpdateResourceImmediate, ResizeTarget",
		(Target.InitCustomFormat(4, 4, PF_R32_FLOAT, true), Target.UpdateResourceImmediate(),
			Target.GetRenderTargetResource()->TextureRHI->GetFormat() == PF_R32_FLOAT));
	CALL("GetPixelFormatFromRenderTargetFormat", GetPixelFormatFromRenderTargetFormat(RTF_RGBA16f) == PF_FloatRGBA);
	UTextureRenderTargetVolume Volume;
	Volume.Init(2, 3, 4, PF_FloatRGBA);
	CALL("UTextureRenderTargetVolume::Init",
		Volume.GetRenderTargetResource()->TextureRHI->GetSizeXYZ() == FIntVector(2, 3, 4) &&
			Volume.GetRenderTargetResource()->TextureRHI->ReadTexel(1, 2, 0, 3).A == 1.0f);
	CALL("UKismetRenderingLibrary::CreateRenderTarget2D, ClearRenderTarget2D",
		[]
		{
			const std::unique_ptr<UTextureRenderTarget2D> T(
				UKismetRenderingLibrary::CreateRenderTarget2D(GWorld, 2, 2, RTF_RGBA16f));
			UKismetRenderingLibrary::ClearRenderTarget2D(GWorld, T.get(), FLinearColor::White);
			return T->SizeX == 2;
		}());
	Calls::FLogLines Log;
	UKismetRenderingLibrary::DrawMaterialToRenderTarget(GWorld, &Target, nullptr);
	NEUTRAL("UKismetRenderingLibrary::DrawMaterialToRenderTarget", Log.Has("DrawMaterialToRenderTarget"));
	const std::unique_ptr<UMaterialInstanceDynamic> Material(UMaterialInstanceDynamic::Create(nullptr, nullptr));
	Material->SetScalarParameterValue(TEXT("A"), 2.0f);
	Material->SetVectorParameterValue(TEXT("B"), FLinearColor::White);
	CALL("UMaterialInstanceDynamic::Create, SetScalarParameterValue, SetVectorParameterValue",
		Material->GetScalarParameterValue(TEXT("A")) == 2.0f);
	UCurveFloat Curve;
	NEUTRAL(
		"UCurveFloat::GetFloatValue (of an asset's name)", Curve.GetFloatValue(0.5f) == 0.0f && Log.Has("UCurveFloat"));
	Curve.FloatCurve.Keys = {{RCIM_Linear, 0.0f, 1.0f}, {RCIM_Linear, 1.0f, 3.0f}};
	CALL("UCurveFloat::FloatCurve, GetFloatValue, FRichCurve::Eval, FRichCurveKey", Curve.GetFloatValue(0.5f) == 2.0f);
	UCurveLinearColor Color;
	Color.FloatCurves[0].Keys = {{RCIM_Linear, 0.0f, 0.0f}, {RCIM_Linear, 1.0f, 1.0f}};
	CALL("UCurveLinearColor::GetLinearColorValue", Color.GetLinearColorValue(0.25f) == FLinearColor(0.25f, 0, 0, 1));
	USceneCaptureComponent2D Capture;
	Capture.TextureTarget = &Target;
	CALL(
		"USceneCaptureComponent2D::TextureTarget, CaptureSource, FOVAngle", Capture.CaptureSource == SCS_SceneColorHDR);
	CALL("USceneCaptureComponent2D::PrimitiveRenderMode, ShowOnlyActors, HiddenActors, ProjectionType, OrthoWidth",
		Capture.PrimitiveRenderMode != ESceneCapturePrimitiveRenderMode::PRM_UseShowOnlyList &&
			Capture.ShowOnlyActors.IsEmpty());
	Capture.CaptureScene();
	NEUTRAL("USceneCaptureComponent2D::CaptureScene, CaptureSceneDeferred", Log.Has("USceneCaptureComponent2D"));
	Material->SetTextureParameterValue(TEXT("C"), Texture.get());
	CALL("UMaterialInstanceDynamic::SetTextureParameterValue, K2_GetTextureParameterValue, K2_GetVectorParameterValue",
		Material->K2_GetTextureParameterValue(TEXT("C")) == Texture.get() &&
			Material->K2_GetVectorParameterValue(TEXT("B")) == FLinearColor::White);
	Texture->LODGroup = TEXTUREGROUP_EffectsNotFiltered;
	CALL("TextureGroup", TEXTUREGROUP_EffectsNotFiltered == 14 && TEXTUREGROUP_Pixels2D == 28);
}
