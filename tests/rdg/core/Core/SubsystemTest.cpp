// Subsystems: who is made when, what Super means with a generated header, and parts of objects.
#include <gtest/gtest.h>

#include "CodeScope.h"
#include "CoreMinimal.h"
#include "Misc/CoreDelegates.h"
#include "Modules/ModuleManager.h"
#include "Subsystems/EngineSubsystem.h"
#include "Subsystems/GameInstanceSubsystem.h"

#include <string>

// What drydock_add_plugin generates for the GENERATED_BODY of line 1000.
#undef CURRENT_FILE_ID
#define CURRENT_FILE_ID FID_SubsystemTest
#define FID_SubsystemTest_1000_GENERATED_BODY \
	, public : using Super = UObject; \
	using ThisClass = UWithBody; \
\
private:

namespace
{

std::string GOrder;

class UFirstSubsystem : public UEngineSubsystem
{
public:
	void Initialize(FSubsystemCollectionBase& Collection) override;
	void Deinitialize() override { GOrder += "-First"; }
};

class USecondSubsystem : public UEngineSubsystem
{
public:
	void Initialize(FSubsystemCollectionBase&) override { GOrder += " Second"; }
	void Deinitialize() override { GOrder += "-Second"; }
};

class URefusedSubsystem : public UEngineSubsystem
{
public:
	bool ShouldCreateSubsystem(UObject*) const override { return false; }
	void Initialize(FSubsystemCollectionBase&) override { GOrder += " Refused"; }
};

class UGameSubsystem : public UGameInstanceSubsystem
{
public:
	void Initialize(FSubsystemCollectionBase&) override { GOrder += " Game"; }
};

class UAbstractSubsystem : public UEngineSubsystem
{
public:
	virtual void Do() = 0;
};

void UFirstSubsystem::Initialize(FSubsystemCollectionBase& Collection)
{
	Collection.InitializeDependency<USecondSubsystem>();
	GOrder += " First";
}

struct FPart : public UObject
{
	~FPart() override { GOrder += " Part"; }
};

class UWhole : public UObject
{
public:
	explicit UWhole(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get())
		: Super(ObjectInitializer)
	{
		Part = ObjectInitializer.CreateDefaultSubobject<FPart>(this, TEXT("Part"));
	}
	FPart* Part;
};

// clang-format off
class UWithBody : public UObject
{
#line 1000
	GENERATED_BODY()
public:
	Super* AsSuper() { return this; }
	ThisClass* AsThis() { return this; }
};

class UWithoutBody : public UObject
{
	GENERATED_BODY()
public:
	Super* AsSuper() { return this; }
};
// clang-format on

} // namespace

TEST(Subsystems, StartInTheEnginesOrder)
{
	GOrder.clear();
	const Drydock::TClassRegistration<UGameSubsystem> Game(TEXT("UGameSubsystem"));
	const Drydock::TClassRegistration<URefusedSubsystem> Refused(TEXT("URefusedSubsystem"));
	FCoreDelegates::OnPostEngineInit.AddLambda([] { GOrder += " PostEngineInit"; });
	{
		const Drydock::TClassRegistration<UFirstSubsystem> First(TEXT("UFirstSubsystem"));
		const Drydock::TClassRegistration<USecondSubsystem> Second(TEXT("USecondSubsystem"));
		FModuleManager::Get().StartupPendingModules();
		FModuleManager::Get().StartupPendingModules();
		// The first one asked for the second.
		EXPECT_EQ(" Second First PostEngineInit Game", GOrder);
		EXPECT_NE(nullptr, Drydock::FSubsystems::Get().Find<UFirstSubsystem>(Drydock::ESubsystemKind::Engine));
		EXPECT_EQ(nullptr, Drydock::FSubsystems::Get().Find<URefusedSubsystem>(Drydock::ESubsystemKind::Engine));
		GOrder.clear();
	}
	EXPECT_EQ("-Second-First", GOrder);
	EXPECT_EQ(nullptr, Drydock::FSubsystems::Get().Find<UFirstSubsystem>(Drydock::ESubsystemKind::Engine));
}

TEST(Subsystems, AbstractClassesAndOtherObjectsAreNotMade)
{
	GOrder.clear();
	const Drydock::TClassRegistration<UAbstractSubsystem> Abstract(TEXT("UAbstractSubsystem"));
	const Drydock::TClassRegistration<UWhole> Whole(TEXT("UWhole"));
	FModuleManager::Get().StartupPendingModules();
	EXPECT_EQ("", GOrder);
}

TEST(Objects, PartsEndWithTheirOwner)
{
	GOrder.clear();
	{
		const UWhole Whole;
		EXPECT_EQ(&Whole, Whole.Part->GetOuter());
		EXPECT_EQ("", GOrder);
	}
	EXPECT_EQ(" Part", GOrder);
}

TEST(Objects, AGeneratedBodyNamesTheClassAndItsBase)
{
	UWithBody WithBody;
	EXPECT_EQ(&WithBody, WithBody.AsSuper());
	EXPECT_EQ(&WithBody, WithBody.AsThis());
	UWithoutBody WithoutBody;
	EXPECT_EQ(&WithoutBody, WithoutBody.AsSuper());
}

namespace
{

class USameName : public UEngineSubsystem
{
};

TEST(Subsystems, OfOneClassNameInTwoPluginsAreBothMade)
{
	Drydock::FSubsystems& Subsystems = Drydock::FSubsystems::Get();
	const Drydock::FSubsystemClass Class{TEXT("USameName"), Drydock::ESubsystemKind::Engine, &typeid(USameName),
		[]() -> USubsystem*
		{
			return new USameName;
		}};
	USameName* Found[2] = {};
	const Drydock::FCodeOwner Owners[2] = {
		{.Plugin = "libA.so", .Callback = "a test"}, {.Plugin = "libB.so", .Callback = "a test"}};
	for (const Drydock::FCodeOwner& Owner : Owners)
	{
		Drydock::CallCode(Owner, [&] { Subsystems.Register(Class); });
	}
	Subsystems.StartPending(Drydock::ESubsystemKind::Engine);
	for (int32 Index : {0, 1})
	{
		Drydock::CallCode(
			Owners[Index], [&] { Found[Index] = Subsystems.Find<USameName>(Drydock::ESubsystemKind::Engine); });
	}
	EXPECT_NE(nullptr, Found[0]);
	EXPECT_NE(nullptr, Found[1]);
	EXPECT_NE(Found[0], Found[1]);
	Subsystems.Unregister(typeid(USameName));
	Subsystems.Unregister(typeid(USameName));
	EXPECT_EQ(nullptr, Subsystems.Find<USameName>(Drydock::ESubsystemKind::Engine));
}

} // namespace
