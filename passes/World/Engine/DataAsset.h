// Assets that only hold values. Source: engine file Engine/DataAsset.h.
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"
#include "UObject/ScriptDelegates.h"

class DRYDOCK_API UDataAsset : public UObject
{
public:
	DRYDOCK_CLASS(UDataAsset, UObject)
	using UObject::UObject;
};

class DRYDOCK_API UPrimaryDataAsset : public UDataAsset
{
public:
	DRYDOCK_CLASS(UPrimaryDataAsset, UDataAsset)
	using UDataAsset::UDataAsset;
};
