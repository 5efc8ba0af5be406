// Values by name: what generated code registers of a class, and what its fields take.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "CoreMinimal.h"
#include "Subsystems/EngineSubsystem.h"
#include "UObject/ReflectionMake.h"

#include <limits>

using namespace Drydock;
using testing::HasSubstr;

enum class EReflectedMode : uint8
{
	Off,
	On = 7,
};

struct FReflectedInner
{
	float Scale = 1.0f;
	TArray<FString> Names;
};

class UReflectedBase : public UObject
{
public:
	using Super = UObject;
	int32 Count = 3;
};

class UReflectedTest : public UReflectedBase
{
	template<typename>
	friend struct ::Drydock::TReflected;

public:
	using Super = UReflectedBase;

	UReflectedTest()
		: bBit(false)
		, Three(0)
	{
	}
	void PostInitProperties() override { SeenByPostInit = Real; }

	bool bBool = false;
	uint8 Byte = 1;
	int64 Large = 0;
	float Real = 1.0f;
	double Precise = 0.0;
	FString Text;
	FName Name;
	EReflectedMode Mode = EReflectedMode::Off;
	FLinearColor Color;
	FColor Bytes;
	FVector2D Two = FVector2D(1.0, 2.0);
	FIntPoint Point = FIntPoint(1, 2);
	FRotator Rotation = FRotator(0.0, 0.0, 0.0);
	TArray<float> Numbers;
	TArray<FReflectedInner> Inners;
	FReflectedInner Inner;
	TMap<FName, float> Map;
	UObject* Object = nullptr;
	float Fixed[4] = {};
	uint8 bBit : 1;
	uint8 Three : 3;
	float SeenByPostInit = -1.0f;

	int32 GetSecret() const { return Secret; }

private:
	int32 Secret = 0;
};

DRYDOCK_REFLECT_ENUM_BEGIN(EReflectedMode, EReflectedMode)
DRYDOCK_REFLECT_ENUMERATOR(EReflectedMode, Off)
DRYDOCK_REFLECT_ENUMERATOR(EReflectedMode, On)
DRYDOCK_REFLECT_ENUM_END()

DRYDOCK_REFLECT_BEGIN(FReflectedInner, "Test", "")
DRYDOCK_REFLECT(Scale, "float", false)
DRYDOCK_REFLECT(Names, "TArray<FString>", false)
DRYDOCK_REFLECT_END(FReflectedInner)

DRYDOCK_REFLECT_BEGIN(UReflectedBase, "Test", "Game")
DRYDOCK_REFLECT(Count, "int32", true)
DRYDOCK_REFLECT_END(UReflectedBase)

DRYDOCK_REFLECT_BEGIN(UReflectedTest, "Test", "")
DRYDOCK_REFLECT(bBool, "bool", false)
DRYDOCK_REFLECT(Byte, "uint8", false)
DRYDOCK_REFLECT(Large, "int64", false)
DRYDOCK_REFLECT(Real, "float", false)
DRYDOCK_REFLECT(Precise, "double", false)
DRYDOCK_REFLECT(Text, "FString", false)
DRYDOCK_REFLECT(Name, "FName", false)
DRYDOCK_REFLECT(Mode, "EReflectedMode", false)
DRYDOCK_REFLECT(Color, "FLinearColor", false)
DRYDOCK_REFLECT(Bytes, "FColor", false)
DRYDOCK_REFLECT(Two, "FVector2D", false)
DRYDOCK_REFLECT(Point, "FIntPoint", false)
DRYDOCK_REFLECT(Rotation, "FRotator", false)
DRYDOCK_REFLECT(Numbers, "TArray<float>", false)
DRYDOCK_REFLECT(Inners, "TArray<FReflectedInner>", false)
DRYDOCK_REFLECT(Inner, "FReflectedInner", false)
DRYDOCK_REFLECT(Map, "TMap<FName, float>", false)
DRYDOCK_REFLECT(Object, "UObject*", false)
DRYDOCK_REFLECT(Fixed, "float[]", false)
DRYDOCK_REFLECT_BITS(bBit, "uint8", false, 1)
DRYDOCK_REFLECT_BITS(Three, "uint8", false, 3)
DRYDOCK_REFLECT(Secret, "int32", false)
DRYDOCK_REFLECT_END(UReflectedTest)

namespace
{

using FValue = FPropertyValue;

FValue List(std::initializer_list<FValue> Values)
{
	FValue Result = FValue::MakeList();
	for (const FValue& Value : Values)
	{
		Result.Items.emplace_back("", Value);
	}
	return Result;
}

FValue Number(double Value)
{
	return FValue::MakeNumber(Value);
}

const FReflectedStruct& GetClass()
{
	return *FReflection::Get().FindStruct(typeid(UReflectedTest));
}

class Reflection : public testing::Test
{
protected:
	~Reflection() override { FReflection::Get().TakeBack(); }

	/** Empty: taken. Else the kind of problem, its path and its sentence. */
	std::string Give(const std::string& Name, const FValue& Value)
	{
		FPropertyProblem Problem;
		if (FReflection::Get().Give(GetClass(), Name, Value, Problem))
		{
			return "";
		}
		return std::to_string(static_cast<int>(Problem.Kind)) + Problem.Path + ": " + Problem.Message;
	}

	const UReflectedTest& Object = *GetDefault<UReflectedTest>();
};

} // namespace

TEST_F(Reflection, GivesEveryKind)
{
	EXPECT_EQ("", Give("bBool", FValue::MakeBool(true)));
	EXPECT_EQ("", Give("Byte", Number(255)));
	EXPECT_EQ("", Give("Large", FValue::MakeWhole(9007199254740993)));
	EXPECT_EQ("", Give("Real", Number(0.1)));
	EXPECT_EQ("", Give("Precise", Number(0.1)));
	EXPECT_EQ("", Give("Text", FValue::MakeText("a, b")));
	EXPECT_EQ("", Give("Name", FValue::MakeText("Some")));
	EXPECT_EQ("", Give("Mode", FValue::MakeText("EReflectedMode::on")));
	EXPECT_EQ("", Give("Color", List({Number(1), Number(0.5), Number(0.25)})));
	EXPECT_EQ("", Give("Bytes", List({Number(1), Number(2), Number(3), Number(4)})));
	EXPECT_EQ("", Give("Two", {.Kind = FValue::EKind::Fields, .Items = {{"Y", Number(5)}}}));
	EXPECT_EQ("", Give("Point", List({Number(-4), Number(6)})));
	EXPECT_EQ("", Give("Rotation", {.Kind = FValue::EKind::Fields, .Items = {{"Yaw", Number(90)}}}));
	EXPECT_EQ("", Give("Numbers", List({Number(1), Number(2.5)})));
	EXPECT_EQ("", Give("Inner", {.Kind = FValue::EKind::Fields, .Items = {{"Scale", Number(4)}}}));
	EXPECT_EQ(
		"", Give("Inners", List({{.Kind = FValue::EKind::Fields},
							   {.Kind = FValue::EKind::Fields,
								   .Items = {{"Names", List({FValue::MakeText("x"), FValue::MakeText("y")})}}}})));
	EXPECT_EQ("", Give("bBit", FValue::MakeBool(true)));
	EXPECT_EQ("", Give("Three", Number(7)));
	EXPECT_EQ("", Give("Secret", Number(-11)));
	EXPECT_EQ("", Give("Count", Number(12)));

	EXPECT_TRUE(Object.bBool);
	EXPECT_EQ(255, Object.Byte);
	EXPECT_EQ(9007199254740993, Object.Large);
	EXPECT_EQ(0.1f, Object.Real);
	EXPECT_EQ(0.1, Object.Precise);
	EXPECT_STREQ("a, b", *Object.Text);
	EXPECT_EQ(FName("Some"), Object.Name);
	EXPECT_EQ(EReflectedMode::On, Object.Mode);
	EXPECT_EQ(FLinearColor(1.0f, 0.5f, 0.25f, 1.0f), Object.Color);
	EXPECT_EQ(FColor(1, 2, 3, 4), Object.Bytes);
	EXPECT_EQ(FVector2D(1.0, 5.0), Object.Two);
	EXPECT_EQ(FIntPoint(-4, 6), Object.Point);
	EXPECT_EQ(90.0, Object.Rotation.Yaw);
	ASSERT_EQ(2, Object.Numbers.Num());
	EXPECT_EQ(2.5f, Object.Numbers[1]);
	EXPECT_EQ(4.0f, Object.Inner.Scale);
	ASSERT_EQ(2, Object.Inners.Num());
	EXPECT_EQ(1.0f, Object.Inners[0].Scale);
	ASSERT_EQ(2, Object.Inners[1].Names.Num());
	EXPECT_STREQ("y", *Object.Inners[1].Names[1]);
	EXPECT_EQ(1, Object.bBit);
	EXPECT_EQ(7, Object.Three);
	EXPECT_EQ(-11, Object.GetSecret());
	EXPECT_EQ(12, Object.Count);
}

TEST_F(Reflection, RefusesWhatDoesNotFitAndLeavesTheValue)
{
	const double Infinity = std::numeric_limits<double>::infinity();
	EXPECT_THAT(Give("Byte", Number(256)), HasSubstr("expected a whole number from 0 to 255"));
	EXPECT_THAT(Give("Byte", Number(1.5)), HasSubstr("UReflectedTest::Byte (uint8): expected"));
	EXPECT_THAT(Give("Three", Number(8)), HasSubstr("from 0 to 7"));
	EXPECT_THAT(Give("Real", Number(1e39)), HasSubstr("a number that a float holds"));
	EXPECT_THAT(Give("Precise", Number(Infinity)), HasSubstr("expected a number"));
	EXPECT_THAT(Give("bBool", Number(1)), HasSubstr("expected true or false"));
	EXPECT_THAT(Give("Text", Number(1)), HasSubstr("expected a text"));
	EXPECT_THAT(Give("Mode", FValue::MakeText("Of")), HasSubstr("one of Off, On, found \"Of\"; did you mean Off?"));
	EXPECT_THAT(Give("Color", List({Number(1), Number(2)})), HasSubstr("[R, G, B, A]"));
	EXPECT_THAT(Give("Bytes", List({Number(1), Number(2), Number(300)})), HasSubstr("0 to 255"));
	EXPECT_THAT(Give("Numbers", List({Number(1), FValue::MakeText("x")})), HasSubstr("1/1: expected a number"));
	EXPECT_THAT(Give("Inner", {.Kind = FValue::EKind::Fields, .Items = {{"Scal", Number(4)}}}),
		HasSubstr("0/Scal: FReflectedInner has no UPROPERTY Scal; did you mean Scale?"));
	EXPECT_THAT(Give("Map", {.Kind = FValue::EKind::Fields}), HasSubstr("2: "));
	EXPECT_THAT(
		Give("Object", FValue::MakeText("/Game/A.A")), HasSubstr("of objects and assets only textures can be given"));
	EXPECT_THAT(Give("Fixed", List({})), HasSubstr("2: "));
	EXPECT_THAT(Give("Reel", Number(1)), HasSubstr("UReflectedTest has no UPROPERTY Reel; did you mean Real?"));
	EXPECT_EQ(1, Object.Byte);
	EXPECT_EQ(1.0f, Object.Real);
	EXPECT_TRUE(Object.Numbers.IsEmpty());
}

TEST_F(Reflection, NewObjectsBeginWithWhatWasGivenBeforePostInitProperties)
{
	EXPECT_EQ("", Give("Real", Number(0.5)));
	const std::unique_ptr<UReflectedTest> Made(NewObject<UReflectedTest>());
	EXPECT_EQ(0.5f, Made->Real);
	EXPECT_EQ(0.5f, Made->SeenByPostInit);
	const std::unique_ptr<UReflectedBase> Base(NewObject<UReflectedBase>());
	EXPECT_EQ(3, Base->Count);
}

TEST_F(Reflection, TakingBackRestoresTheConstructorsValues)
{
	EXPECT_EQ("", Give("Real", Number(0.5)));
	EXPECT_EQ("", Give("Real", Number(0.75)));
	EXPECT_EQ("", Give("Numbers", List({Number(1)})));
	EXPECT_EQ("", Give("Mode", FValue::MakeText("On")));
	FReflection::Get().TakeBack();
	EXPECT_EQ(1.0f, Object.Real);
	EXPECT_TRUE(Object.Numbers.IsEmpty());
	EXPECT_EQ(EReflectedMode::Off, Object.Mode);
	const std::unique_ptr<UReflectedTest> Made(NewObject<UReflectedTest>());
	EXPECT_EQ(1.0f, Made->Real);
}
