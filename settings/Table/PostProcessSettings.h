// FPostProcessSettings: every post-process setting with its override bit, made from the one table.
// Source: engine Engine/Scene.h (FPostProcessSettings) and FinalPostProcessSettings.h.
#pragma once

#include "CoreMinimal.h"
#include "AddedSettings.h"
#include "Curves/CurveFloat.h"
#include "Engine/Texture.h"
#include "PostProcessSettingsEnums.h"
#include "WeightedBlendables.h"

// Made for the code of an engine overlay (docs/overlays.md): enums of the settings that its Scene.h adds.
#ifdef DRYDOCK_OVERLAY_TYPES
#include DRYDOCK_OVERLAY_TYPES
#endif

/** One tint per lens flare. */
using FLensFlareTints = FLinearColor[8];

/** Settings as a volume, camera or extension gives them. A value takes part in blending only where its bOverride_ bit
 * is set. A new object holds the engine's defaults and overrides nothing. */
struct FPostProcessSettings
{
	DRYDOCK_DECLARE_COPIES(FPostProcessSettings)

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

	/** Ours: values of settings that plugins have added; read and set by their TPostProcessSetting. */
	Drydock::FAddedSettings AddedSettings;

// Empty members of the same settings, which read AddedSettings under the engine's names.
#ifdef DRYDOCK_OVERLAY_SETTINGS
#include DRYDOCK_OVERLAY_SETTINGS
#endif

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

/** The objects that a view's blendables have pushed, one entry each. */
struct FBlendableEntry
{
	float Weight = 0.0f; // 0..1

	/** Ours: the name that its type bears (GetFName), and the data, which copies of the settings share. */
	FName Type;
	std::shared_ptr<void> Data;
};

/** The blendables of all sources that act on a view, in the order in which they were blended, each with its weight
 * times that of its source. One that several sources name is there as often. */
struct FBlendableManager
{
	TArray<FWeightedBlendable> Blendables;

	/** Adds data for whoever asks for its type; T has a static GetFName. Weight: 0..1. Returns the copy. */
	template<typename T>
	T* PushBlendableData(float Weight, const T& Data)
	{
		const std::shared_ptr<T> Copy = std::make_shared<T>(Data);
		Entries.push_back(std::make_shared<FBlendableEntry>(FBlendableEntry{Weight, T::GetFName(), Copy}));
		return Copy.get();
	}

	/** The data after Iterator (null: the first) of that type, and Iterator becomes its entry; null when there is no
	 * more. */
	template<typename T>
	T* IterateBlendables(FBlendableEntry*& Iterator) const
	{
		bool bBehind = Iterator == nullptr;
		for (const std::shared_ptr<FBlendableEntry>& Entry : Entries)
		{
			if (bBehind && Entry->Type == T::GetFName())
			{
				Iterator = Entry.get();
				return static_cast<T*>(Entry->Data.get());
			}
			bBehind = bBehind || Entry.get() == Iterator;
		}
		Iterator = nullptr;
		return nullptr;
	}

	/** The last that was pushed of that type, or null. */
	template<typename T>
	T* GetSingleFinalData() const
	{
		T* Last = nullptr;
		FBlendableEntry* Iterator = nullptr;
		while (T* const Data = IterateBlendables<T>(Iterator))
		{
			Last = Data;
		}
		return Last;
	}

private:
	std::vector<std::shared_ptr<FBlendableEntry>> Entries; // whose addresses stay
};

/** The settings that a view renders with, after defaults, volumes, camera, clamps and show flags. Beside the fields, of
 * which each has one value, it holds what cannot be merged into one: lists of contributions. */
struct FFinalPostProcessSettings : public FPostProcessSettings
{
	DRYDOCK_DECLARE_COPIES(FFinalPostProcessSettings)

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
