// The macros that Unreal's header tool reads. Most say nothing to the compiler; the metadata in them may be anything.
// In a plugin built with drydock_add_plugin the generated header of a class gives GENERATED_BODY its Super and
// ThisClass, and the fields marked UPROPERTY are known by name and type (UObject/Reflection.h). Source: engine
// UObject/ObjectMacros.h.
#pragma once

#include "CoreTypes.h"

namespace Drydock
{

/** Generated code makes this a friend of a class, so that private fields are seen (UObject/Reflection.h). */
template<typename T>
struct TReflected;

} // namespace Drydock

// A generated header sets CURRENT_FILE_ID and defines, for the line of each GENERATED_BODY, a macro `, <text>`. Without
// such a macro (no generated header, or one of another line) the second argument is empty, and so is the body.
#define DRYDOCK_SECOND_OF(First, Second, ...) Second
#define DRYDOCK_SECOND(...) DRYDOCK_SECOND_OF(__VA_ARGS__, , )
#define DRYDOCK_BODY_NAME_OF(FileId, Line) FileId##_##Line##_GENERATED_BODY
#define DRYDOCK_BODY_NAME(FileId, Line) DRYDOCK_BODY_NAME_OF(FileId, Line)

#define UCLASS(...)
#define USTRUCT(...)
#define UENUM(...)
#define UINTERFACE(...)
#define UDELEGATE(...)
#define UMETA(...)
#define UPARAM(...)
#ifndef UPROPERTY
#define UPROPERTY(...)
#endif
#define UFUNCTION(...)
#define GENERATED_BODY(...) DRYDOCK_SECOND(DRYDOCK_BODY_NAME(CURRENT_FILE_ID, __LINE__))
/** Leaves the section public, and declares the constructor that such a class defines. */
#define GENERATED_UCLASS_BODY(...) GENERATED_BODY()
#define GENERATED_USTRUCT_BODY(...) GENERATED_BODY()
#define GENERATED_UINTERFACE_BODY(...) GENERATED_BODY()
#define GENERATED_IINTERFACE_BODY(...)
/** `#include UE_INLINE_GENERATED_CPP_BY_NAME(MyFile)` takes in MyFile.gen.cpp. */
#define UE_INLINE_GENERATED_CPP_BY_NAME(Name) DRYDOCK_TEXT_OF(Name.gen.cpp)
#define DRYDOCK_TEXT_OF(...) #__VA_ARGS__
