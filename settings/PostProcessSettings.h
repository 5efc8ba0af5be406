// FPostProcessSettings: every post-process setting with its override bit, made from the one table.
// Source: engine Engine/Scene.h (FPostProcessSettings) and FinalPostProcessSettings.h.
#pragma once

#include "CoreMinimal.h"
#include "Curves/CurveFloat.h"
#include "Engine/Texture.h"
#include "PostProcessSettingsEnums.h"
#include "WeightedBlendables.h"

/** One tint per lens flare. */
using FLensFlareTints = FLinearColor[8];

/** Settings as a volume, camera or extension gives them. A value takes part in blending only where its bOverride_ bit
 * is set. A new object holds the engine's defaults and overrides nothing. */
struct FPostProcessSettings
{
#define DRYDOCK_SETTING(Type, Name, Default, Range, Unit, Category, Blend, Doc) uint8 bOverride_##Name : 1 = 0;
#define DRYDOCK_SETTING_BIT(Type, Name, Bit, Default, Range, Unit, Category, Blend, Doc) uint8 bOverride_##Bit : 1 = 0;
#include "PostProcessSettingsTable.h"
#undef DRYDOCK_SETTING

#define DRYDOCK_SETTING(Type, Name, Default, Range, Unit, Category, Blend, Doc) Type Name = Default;
#define DRYDOCK_LIST(...) \
	{ \
		__VA_ARGS__ \
	}
#include "PostProcessSettingsTable.h"
#undef DRYDOCK_LIST
#undef DRYDOCK_SETTING

	/** Beside the table, not in it: it has no override bit, no default to compare with and any number of members, and
	 * it is merged by object instead of blended by value, in this as in the engine. */
	FWeightedBlendables WeightedBlendables;

	/** Defaults for all values and override bits; no blendables. */
	void SetBaseValues()
	{
		*this = FPostProcessSettings();
	}

	/** Adds the object, or gives it the new weight where it is in the list already. Null does nothing. */
	void AddBlendable(UObject* Object, float Weight)
	{
		if (Object == nullptr)
		{
			return;
		}
		for (FWeightedBlendable& Blendable : WeightedBlendables.Array)
		{
			if (Blendable.Object.Get() == Object)
			{
				Blendable.Weight = Weight;
				return;
			}
		}
		WeightedBlendables.Array.Add(FWeightedBlendable(Weight, Object));
	}

	/** Removes every entry of the object. */
	void RemoveBlendable(UObject* Object)
	{
		WeightedBlendables.Array.RemoveAll(
			[Object](const FWeightedBlendable& Blendable) { return Blendable.Object.Get() == Object; });
	}
};

/** The blendables of all sources that act on a view, in the order in which they were blended, each with its weight
 * times that of its source. One that several sources name is there as often. */
struct FBlendableManager
{
	TArray<FWeightedBlendable> Blendables;
};

/** What a view renders with, after defaults, volumes, camera, clamps and show flags. Beside the fields, of which each
 * has one value, it holds what cannot be merged into one: lists of contributions. */
struct FFinalPostProcessSettings : public FPostProcessSettings
{
	struct FCubemapEntry
	{
		/** Tint * intensity * weight, summed over all that name the cubemap. */
		FLinearColor AmbientCubemapTintMulScaleValue;
		TObjectPtr<UTextureCube> AmbientCubemap;
	};

	struct FLUTEntry
	{
		TObjectPtr<UTexture> LUT; // null: the neutral one
		float Weight = 1.0f;
	};

	TArray<FCubemapEntry> ContributingCubemaps;
	TArray<FLUTEntry> ContributingLUTs = {FLUTEntry()}; // weights sum to 1
	FBlendableManager BlendableManager;

	/** Takes Weight (0..1) from all tables and gives it to this one. */
	DRYDOCK_API void LerpTo(UTexture* LUT, float Weight);

	/** Adds a cubemap's colour; null does nothing. */
	DRYDOCK_API void AddCubemap(UTextureCube* Cubemap, const FLinearColor& TintTimesScale);
};
