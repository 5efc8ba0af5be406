// Objects that take part in a view by weight, such as post-process materials. Source: engine Engine/Scene.h.
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"

struct FWeightedBlendable
{
	float Weight = 0.0f; // 0..1
	TObjectPtr<UObject> Object;

	FWeightedBlendable() = default;
	FWeightedBlendable(float InWeight, UObject* InObject)
		: Weight(InWeight)
		, Object(InObject)
	{
	}

	bool operator==(const FWeightedBlendable& Other) const
	{
		return Weight == Other.Weight && Object.Get() == Other.Object.Get();
	}
};

struct FWeightedBlendables
{
	TArray<FWeightedBlendable> Array;
};
