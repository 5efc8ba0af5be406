// The one world, its actors and its subsystems.
#include <gtest/gtest.h>

#include "Engine/Engine.h"
#include "EngineUtils.h"
#include "SceneInterface.h"
#include "Subsystems/WorldSubsystem.h"

#include <string>

namespace
{

std::string GPlay;

class UTestComponent : public UActorComponent
{
public:
	void OnRegister() override { GPlay += " register"; }
	void BeginPlay() override { GPlay += " component"; }
	void EndPlay(const EEndPlayReason::Type) override { GPlay += " end"; }
};

class ATestActor : public AActor
{
public:
	ATestActor() { Component = CreateDefaultSubobject<UTestComponent>(TEXT("Test")); }
	void BeginPlay() override { GPlay += " actor"; }
	void Destroyed() override { GPlay += " destroyed"; }
	UTestComponent* Component;
};

class ATickingActor : public AActor
{
public:
	ATickingActor() { PrimaryActorTick.bCanEverTick = true; }
	void Tick(float DeltaSeconds) override
	{
		NumTicks += DeltaSeconds == 0.25f;
		if (NumTicks == 2)
		{
			SetActorTickEnabled(false);
		}
	}
	int32 NumTicks = 0;
};

class UTestWorldSubsystem : public UWorldSubsystem
{
public:
	void OnWorldBeginPlay(UWorld& InWorld) override { World = &InWorld; }
	UWorld* World = nullptr;
};

class UEditorWorldSubsystem : public UWorldSubsystem
{
protected:
	bool DoesSupportWorldType(const EWorldType::Type Type) const override { return Type == EWorldType::Editor; }
};

} // namespace

TEST(World, ItsSceneShowsIt)
{
	EXPECT_EQ(GWorld, GWorld->Scene->GetWorld());
	EXPECT_EQ(GWorld, GEngine->GetCurrentPlayWorld());
	EXPECT_TRUE(GWorld->IsGameWorld());
}

TEST(World, ASpawnedActorPlaysUntilItIsDestroyed)
{
	GPlay.clear();
	ATestActor* const Actor = GWorld->SpawnActor<ATestActor>();
	EXPECT_EQ(" register component actor", GPlay);
	EXPECT_EQ(Actor, Actor->Component->GetOwner());
	int32 NumFound = 0;
	for (TActorIterator<ATestActor> It(GWorld); It; ++It)
	{
		NumFound += *It == Actor;
	}
	EXPECT_EQ(1, NumFound);
	Actor->Destroy();
	EXPECT_EQ(" register component actor end destroyed", GPlay);
	EXPECT_FALSE(TActorIterator<ATestActor>(GWorld));
}

TEST(World, ActorsThatCanTickDoSoUntilTheyStop)
{
	ATickingActor* const Actor = GWorld->SpawnActor<ATickingActor>();
	ATestActor* const Other = GWorld->SpawnActor<ATestActor>();
	for (int32 Frame = 0; Frame < 4; ++Frame)
	{
		GWorld->Tick(0.25f, 0.25 * Frame);
		EXPECT_EQ(0.25 * Frame, GWorld->GetTimeSeconds());
		EXPECT_EQ(0.25f, GWorld->GetDeltaSeconds());
	}
	EXPECT_EQ(2, Actor->NumTicks);
	Actor->Destroy();
	Other->Destroy();
}

TEST(World, PlacesAnActorWhereThereIsNoneOfItsClass)
{
	GWorld->PlaceActor<ATestActor>();
	GWorld->PlaceActor<ATestActor>();
	ATestActor* const Spawned = GWorld->SpawnActor<ATestActor>();
	const auto Count = []
	{
		int32 NumFound = 0;
		for (TActorIterator<ATestActor> It(GWorld); It; ++It)
		{
			++NumFound;
		}
		return NumFound;
	};
	EXPECT_EQ(2, Count());
	GWorld->RemovePlacedActors();
	EXPECT_EQ(1, Count());
	GWorld->PlaceActor<ATestActor>();
	EXPECT_EQ(1, Count());
	Spawned->Destroy();
}

TEST(World, SubsystemsOfItsTypeStart)
{
	const Drydock::TClassRegistration<UTestWorldSubsystem> Game(TEXT("UTestWorldSubsystem"));
	const Drydock::TClassRegistration<UEditorWorldSubsystem> Editor(TEXT("UEditorWorldSubsystem"));
	Drydock::FSubsystems::Get().StartPending(Drydock::ESubsystemKind::World);
	ASSERT_NE(nullptr, GWorld->GetSubsystem<UTestWorldSubsystem>());
	EXPECT_EQ(GWorld, GWorld->GetSubsystem<UTestWorldSubsystem>()->World);
	EXPECT_EQ(GWorld, GWorld->GetSubsystem<UTestWorldSubsystem>()->GetWorld());
	EXPECT_EQ(nullptr, GWorld->GetSubsystem<UEditorWorldSubsystem>());
	EXPECT_EQ(GWorld->GetSubsystem<UTestWorldSubsystem>(), UWorld::GetSubsystem<UTestWorldSubsystem>(GWorld));
	const UWorld* const None = nullptr;
	EXPECT_EQ(nullptr, UWorld::GetSubsystem<UTestWorldSubsystem>(None));
	EXPECT_EQ(nullptr, UGameInstance::GetSubsystem<UTestWorldSubsystem>(GWorld->GetGameInstance()));
}

TEST(World, ActorsHaveAFlagAndATimeOfTheirOwn)
{
	ATestActor* const Actor = GWorld->SpawnActor<ATestActor>();
	EXPECT_FALSE(Actor->IsHidden());
	Actor->SetActorHiddenInGame(true);
	EXPECT_TRUE(Actor->IsHidden());
	EXPECT_EQ(1.0f, Actor->GetActorTimeDilation());
	Actor->CustomTimeDilation = 0.5f;
	EXPECT_EQ(0.5f, Actor->GetActorTimeDilation());
	Actor->Destroy();
}

TEST(World, ConsoleCommandsGetIt)
{
	UWorld* Seen = nullptr;
	const FAutoConsoleCommandWithWorldAndArgs Command(TEXT("Test.World"), TEXT("Help"),
		FConsoleCommandWithWorldAndArgsDelegate::CreateLambda(
			[&Seen](const TArray<FString>&, UWorld* World) { Seen = World; }));
	IConsoleManager::Get().ProcessUserConsoleInput(TEXT("Test.World"));
	EXPECT_EQ(GWorld, Seen);
}
