// Classes of objects at run time.
#include <gtest/gtest.h>

#include "Subsystems/EngineSubsystem.h"
#include "UObject/Class.h"

#include <memory>

namespace
{

class UBaseObject : public UObject
{
public:
	DRYDOCK_CLASS(UBaseObject, UObject)

	int32 Value = 3;
};
class UDerivedObject : public UBaseObject
{
public:
	DRYDOCK_CLASS(UDerivedObject, UBaseObject)
};
class UAbstractObject : public UBaseObject
{
public:
	DRYDOCK_CLASS(UAbstractObject, UBaseObject)

	virtual void Act() = 0;
};

} // namespace

TEST(Class, KnowsItsNameAndBase)
{
	UClass* const Class = UDerivedObject::StaticClass();
	EXPECT_EQ(Class, UDerivedObject::StaticClass());
	EXPECT_EQ(FString(TEXT("DerivedObject")), Class->GetName());
	EXPECT_EQ(UBaseObject::StaticClass(), Class->GetSuperClass());
	EXPECT_TRUE(Class->IsChildOf(UObject::StaticClass()));
	EXPECT_TRUE(Class->IsChildOf<UDerivedObject>());
	EXPECT_FALSE(UBaseObject::StaticClass()->IsChildOf(Class));
	EXPECT_TRUE(UEngineSubsystem::StaticClass()->IsChildOf<USubsystem>());
	EXPECT_EQ(nullptr, UObject::StaticClass()->GetSuperClass());
}

TEST(Class, MakesObjects)
{
	const std::unique_ptr<UBaseObject> Object(
		NewObject<UBaseObject>(nullptr, UDerivedObject::StaticClass(), TEXT("Name")));
	EXPECT_EQ(UDerivedObject::StaticClass(), Object->GetClass());
	EXPECT_TRUE(Object->IsA<UDerivedObject>() && Object->IsA(UBaseObject::StaticClass()));
	EXPECT_FALSE(Object->IsA(UEngineSubsystem::StaticClass()));
	EXPECT_EQ(GetDefault<UBaseObject>(), UBaseObject::StaticClass()->GetDefaultObject());
	EXPECT_EQ(3, UBaseObject::StaticClass()->GetDefaultObject<UBaseObject>()->Value);
	EXPECT_EQ(nullptr, UAbstractObject::StaticClass()->GetDefaultObject());
	EXPECT_EQ(nullptr, NewObject<UBaseObject>(nullptr, UAbstractObject::StaticClass()));
}

TEST(Class, ASubclassIsOfItsClass)
{
	const TSubclassOf<UBaseObject> Class = UDerivedObject::StaticClass();
	EXPECT_EQ(UDerivedObject::StaticClass(), Class.Get());
	EXPECT_EQ(3, Class.GetDefaultObject()->Value);
	EXPECT_EQ(nullptr, TSubclassOf<UBaseObject>(UObject::StaticClass()).Get());
	EXPECT_EQ(nullptr, TSubclassOf<UBaseObject>().GetDefaultObject());
}
