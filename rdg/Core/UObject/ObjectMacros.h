// The macros that Unreal's header tool reads. There is no reflection here, so they say nothing to the compiler; the
// metadata in them may be anything. Source: engine UObject/ObjectMacros.h.
#pragma once

#include "CoreTypes.h"

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
#define GENERATED_BODY(...)
#define GENERATED_UCLASS_BODY(...)
#define GENERATED_USTRUCT_BODY(...)
#define GENERATED_UINTERFACE_BODY(...)
#define GENERATED_IINTERFACE_BODY(...)
#define UE_INLINE_GENERATED_CPP_BY_NAME(Name)
