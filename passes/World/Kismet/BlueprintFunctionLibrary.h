// Static functions for blueprints; here for C++ alone. Source: engine file Kismet/BlueprintFunctionLibrary.h.
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"

class DRYDOCK_API UBlueprintFunctionLibrary : public UObject
{
public:
	DRYDOCK_CLASS(UBlueprintFunctionLibrary, UObject)
	using UObject::UObject;
};
