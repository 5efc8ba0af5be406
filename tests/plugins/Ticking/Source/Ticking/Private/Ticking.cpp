// A plugin whose picture shows how often and with how many seconds the engine has called its objects: one colour over
// the whole picture. Red: seconds of the actor, 16 times its component's, and 1024 times what a level's component has.
// Green: calls of a timer, and 16 times
// those for the next tick. Blue: seconds of the subsystem, and 16 times those of an object that ticks by itself.
#include "TickingActor.h"

#include "EngineUtils.h"
#include "Misc/CoreDelegates.h"
#include "Modules/ModuleManager.h"
#include "PostProcess/PostProcessInputs.h"
#include "RenderGraphUtils.h"
#include "SceneView.h"
#include "SceneViewExtension.h"

float ATickingActor::Added = 0.0f;

void ATickingActor::BeginPlay()
{
	Super::BeginPlay();
	GetWorldTimerManager().SetTimer(Timer, this, &ATickingActor::OnTimer, Rate, true);
	GetWorld()->GetTimerManager().SetTimerForNextTick([this] { ++NumNextTicks; });
}

void ATickingActor::OnTimer()
{
	++NumTimerCalls;
}

void ATickingActor::SetGlow(ETickingMode InMode, FLinearColor InColor, const FString& InName)
{
	Mode = InMode;
	Color = InColor;
	Name = InName;
}

void UTickingSubsystem::Start(float InFirst)
{
	First = InFirst;
}

float ULevelComponent::GetSum()
{
	float Sum = 0.0f;
	for (TActorIterator<AActor> It(GWorld); It; ++It)
	{
		Sum += It->FindComponentByClass<UTickingComponent>() && !Cast<ATickingActor>(*It) ? 0.5f : 0.0f;
		if (const ULevelComponent* const Component = It->FindComponentByClass<ULevelComponent>())
		{
			check(It->GetRootComponent() == Component && Component->GetOwner() == *It);
			Sum += Component->IsActive() ? Component->AtPlay + Component->Initialized : -1.0f;
		}
	}
	return Sum;
}

/** It ticks though the engine knows nothing of it. */
class FTickingObject : public FTickableGameObject
{
public:
	virtual void Tick(float DeltaTime) override { Seconds += DeltaTime; }
	virtual TStatId GetStatId() const override { RETURN_QUICK_DECLARE_CYCLE_STAT(FTickingObject, STATGROUP_Tickables); }

	float Seconds = 0.0f;
};

class FTickingExtension : public FSceneViewExtensionBase
{
public:
	FTickingExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
		FCoreDelegates::OnBeginFrame.AddRaw(this, &FTickingExtension::OnBegin);
		FCoreDelegates::OnEndFrame.AddRaw(this, &FTickingExtension::OnEnd);
	}
	virtual ~FTickingExtension()
	{
		FCoreDelegates::OnBeginFrame.RemoveAll(this);
		FCoreDelegates::OnEndFrame.RemoveAll(this);
	}

	virtual void PrePostProcessPass_RenderThread(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessingInputs& Inputs) override
	{
		FLinearColor Shown = FLinearColor::Black;
		for (TActorIterator<ATickingActor> It(GWorld); It; ++It)
		{
			Shown.R = It->Seconds + 16.0f * It->Component->Seconds;
			Shown.G = float(It->NumTimerCalls + 16 * It->NumNextTicks);
			if (It->Mode == ETickingMode::Glowing)
			{
				Shown = It->Color * float(It->Factor) + FLinearColor(It->Added, float(It->Name.Len()), 0.0f);
			}
		}
		const UTickingSubsystem* const Subsystem = GWorld->GetSubsystem<UTickingSubsystem>();
		Shown.B += Subsystem->Seconds + Subsystem->First + 16.0f * Object.Seconds;
		Shown.R += 1024.0f * ULevelComponent::GetSum();
		// Both would differ if a frame had begun or ended twice, or not at all.
		check(NumBegun == NumEnded + 1);
		AddClearRenderTargetPass(GraphBuilder, Inputs.SceneTextures->GetParameters()->SceneColorTexture, Shown);
	}

private:
	void OnBegin() { ++NumBegun; }
	void OnEnd() { ++NumEnded; }

	FTickingObject Object;
	int32 NumBegun = 0;
	int32 NumEnded = 0;
};

class FTickingModule : public IModuleInterface
{
public:
	virtual void StartupModule() override
	{
		FCoreDelegates::OnPostEngineInit.AddLambda(
			[this] { Extension = FSceneViewExtensions::NewExtension<FTickingExtension>(); });
	}
	virtual void ShutdownModule() override { Extension.Reset(); }

private:
	TSharedPtr<FTickingExtension, ESPMode::ThreadSafe> Extension;
};

IMPLEMENT_MODULE(FTickingModule, Ticking)
