// Describes a plugin's classes, structs and enums at run time: the names and types of their UPROPERTY fields, so that a
// config's "objects" and ini files can set them. Source of the idea: engine UObject/Class.h and UnrealType.h; names and
// shape are drydock's own.
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"
#include "UObject/PropertyValue.h"

#include <string>
#include <typeinfo>
#include <vector>

namespace Drydock
{

enum class EPropertyKind : uint8
{
	Bool,
	Whole,
	Real,
	Text, // FString, FName
	Enum,
	Vector, // colours, vectors, points, rotators: a number for each component
	Array,  // TArray of any kind but itself
	Struct, // a USTRUCT, or a type that nothing is known of
	Object, // a pointer to an object or to an asset
	Other,  // an array of fixed length and the like
};

/** The functions that read and write values of a type. Address is that of the value; of a bit field that of the object.
 */
struct FPropertyType
{
	EPropertyKind Kind = EPropertyKind::Other;

	// Bool, Whole, Enum
	int64 (*GetWhole)(const void* Address) = nullptr;
	void (*SetWhole)(void* Address, int64 Value) = nullptr;
	// Whole; of Vector where its components are whole
	int64 Least = 0;
	int64 Most = 0;

	// Real: Component 0; Vector
	double (*GetReal)(const void* Address, int32 Component) = nullptr;
	void (*SetReal)(void* Address, int32 Component, double Value) = nullptr;
	bool bFloat = false;                 // Real, Vector: what a float cannot hold is refused
	bool bWholeComponents = false;       // Vector
	std::vector<std::string> Names = {}; // of components
	bool bLastMayBeMissing = false;      // the alpha of a colour: 1, or 255

	// Text
	std::string (*GetText)(const void* Address) = nullptr;
	void (*SetText)(void* Address, const std::string& Text) = nullptr;

	// Object, where it points to a kind of UTexture: a config gives it an asset. SetObject: false for an object of
	// another class; Address null: asks only.
	UObject* (*GetObject)(const void* Address) = nullptr;
	bool (*SetObject)(void* Address, UObject* Object) = nullptr;

	// Enum, Struct: whose names are registered under it
	const std::type_info* Type = nullptr;

	// Array
	const FPropertyType* Element = nullptr;
	int32 (*GetNum)(const void* Address) = nullptr;
	void (*Reset)(void* Address, int32 Num) = nullptr; // to Num new elements
	void* (*GetElement)(void* Address, int32 Index) = nullptr;
};

/** A UPROPERTY. */
struct FReflectedProperty
{
	const TCHAR* Name = nullptr;
	const TCHAR* TypeName = nullptr; // as the header has it
	bool bConfig = false;            // UPROPERTY(config)
	const FPropertyType* Type = nullptr;
	void* (*GetAddress)(void* Container) = nullptr;
};

/** Why a value was not taken. */
struct FPropertyProblem
{
	enum class EKind : uint8
	{
		UnknownProperty,
		WrongValue,
		NotGiven, // of a type that a config cannot give
	};
	EKind Kind = EKind::WrongValue;
	std::string Path;    // from the value on: "/Colors/2/R"; empty: the value itself
	std::string Message; // one sentence
};

/** A UFUNCTION(BlueprintCallable). */
struct FReflectedFunction
{
	const TCHAR* Name = nullptr;
	size_t NumParameters = 0;
	/** Arguments: as many as parameters. Container null: only checks them. False, with the reason, where it cannot be
	 * called so. */
	bool (*Call)(void* Container, const std::vector<FPropertyValue>& Arguments, FPropertyProblem& OutProblem) = nullptr;
};

struct FReflectedEnum
{
	const TCHAR* Name = nullptr;
	const std::type_info* Type = nullptr;
	std::vector<std::pair<const TCHAR*, int64>> Values;
};

/** A UCLASS or a USTRUCT. */
struct FReflectedStruct
{
	const TCHAR* Name = nullptr;   // "UMySettings"
	const TCHAR* Module = nullptr; // "MyPlugin"
	const TCHAR* Config = nullptr; // of UCLASS(config=Game): "Game"; else empty
	const std::type_info* Type = nullptr;
	const std::type_info* Super = nullptr; // null: none
	void* (*ToSuper)(void* Container) = nullptr;
	UObject* (*GetDefault)() = nullptr; // null: a struct, or a class that cannot be made
	void* (*FromObject)(UObject* Object) = nullptr;
	std::vector<FReflectedProperty> Properties = {};
	std::vector<FReflectedFunction> Functions = {};
	void (*Place)() = nullptr; // an actor or component: puts one into the world, as a level has it
};

/** A property, and how to get from an object of some class to the class that has it. */
struct FFoundProperty
{
	const FReflectedProperty* Property = nullptr;
	std::vector<void* (*)(void*)> Steps;

	DRYDOCK_API void* GetAddress(void* Container) const;
};

/** All that is registered. Plugins come and go on one thread. */
class DRYDOCK_API FReflection
{
public:
	static FReflection& Get();

	void Register(const FReflectedStruct& Struct);
	void Register(const FReflectedEnum& Enum);
	/** Unregisters a struct, with the values that were given to it. */
	void Unregister(const FReflectedStruct& Struct);
	void Unregister(const FReflectedEnum& Enum);

	/** Classes of a plugin, by the file name of its shared object, in the order of registration. */
	std::vector<const FReflectedStruct*> FindClasses(const std::string& Plugin) const;
	/** Null: nothing is known of the type. */
	const FReflectedStruct* FindStruct(const std::type_info& Type) const;
	const FReflectedEnum* FindEnum(const std::type_info& Type) const;

	/** Finds a property of a class and those it is derived from; ignores case where bIgnoreCase. Property is null if
	 * there is none. */
	FFoundProperty FindProperty(const FReflectedStruct& Struct, const std::string& Name, bool bIgnoreCase) const;
	std::vector<std::string> GetPropertyNames(const FReflectedStruct& Struct) const;

	/** Gives a property of a class's default object, and of its subsystem, a value; objects made later begin with it.
	 * The values given before are kept. False, with the reason, where it cannot have it. */
	bool Give(const FReflectedStruct& Class, const std::string& Name, const FPropertyValue& Value,
		FPropertyProblem& OutProblem);
	/** Calls a function of a class, or of one it is derived from, of Object; null: only checks. False, with the reason
	 * and the place among the arguments, where it cannot be called so. */
	bool Call(const FReflectedStruct& Class, const std::string& Name, const std::vector<FPropertyValue>& Arguments,
		UObject* Object, FPropertyProblem& OutProblem) const;
	/** The class's subsystem that has started, else its default object; null: there is none. */
	UObject* FindObject(const FReflectedStruct& Class) const;
	/** Calls PostInitProperties of the default objects of a plugin that were given something. */
	void FinishDefaults(const std::string& Plugin);
	/** Puts back all that was given, of all plugins. */
	void TakeBack();

	/** Gives a new object of a class the values that were given for it, then calls PostInitProperties. */
	void FinishObject(UObject& Object, const std::type_info& Type);

private:
	FReflection() = default;
};

/** A call gets it for null where it takes any UObject: the world, once there is one. */
DRYDOCK_API UObject*& GetWorldContext();

/** Reads a value; what a type cannot give is None. */
DRYDOCK_API FPropertyValue ReadProperty(const FPropertyType& Type, const void* Address);

/** Writes a value, all of it or nothing: elements of an array are replaced, members and components that are not named
 * stay. */
DRYDOCK_API bool WriteProperty(
	const FPropertyType& Type, void* Address, const FPropertyValue& Value, FPropertyProblem& OutProblem);

/** "a whole number from 0 to 255", "one of Off, On", ... */
DRYDOCK_API std::string DescribeExpected(const FPropertyType& Type);

} // namespace Drydock
