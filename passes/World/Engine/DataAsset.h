// Assets that only hold values. Source: engine file Engine/DataAsset.h.
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"
#include "UObject/ScriptDelegates.h"

class DRYDOCK_API UDataAsset : public UObject
{
public:
	using Super = UDataAsset;
	using UObject::UObject;
};

class DRYDOCK_API UPrimaryDataAsset : public UDataAsset
{
public:
	using Super = UPrimaryDataAsset;
	using UDataAsset::UDataAsset;
};
