// An action that a Blueprint starts and that ends later. Source: engine file Kismet/BlueprintAsyncActionBase.h.
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"

class DRYDOCK_API UBlueprintAsyncActionBase : public UObject
{
public:
	DRYDOCK_CLASS(UBlueprintAsyncActionBase, UObject)
	using UObject::UObject;

	/** Called by a config's "call" on the action that its function returns, as a Blueprint does. */
	virtual void Activate() {}
	/** In the engine the game keeps the action until it is ready; nothing is collected here. */
	void RegisterWithGameInstance(const UObject*) {}
	virtual void SetReadyToDestroy() {}
};
