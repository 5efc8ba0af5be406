// FPostProcessSettings: every post-process setting with its override bit, made from the one table.
// Source: engine Engine/Scene.h (FPostProcessSettings) and FinalPostProcessSettings.h.
#pragma once

#include "CoreMinimal.h"

enum EBloomMethod : uint8
{
	BM_SOG,
	BM_FFT,
	BM_MAX,
};

enum EAutoExposureMethod : uint8
{
	AEM_Histogram,
	AEM_Basic,
	AEM_Manual,
	AEM_MAX,
};

/** Settings as a volume, camera or extension gives them. A value takes part in blending only where its bOverride_ bit
 * is set. A new object holds the engine's defaults and overrides nothing. */
struct FPostProcessSettings
{
#define DRYDOCK_SETTING(Type, Name, Default, Range, Unit, Category, Blend, Doc) uint8 bOverride_##Name : 1 = 0;
#include "PostProcessSettingsTable.h"
#undef DRYDOCK_SETTING

#define DRYDOCK_SETTING(Type, Name, Default, Range, Unit, Category, Blend, Doc) Type Name = Default;
#include "PostProcessSettingsTable.h"
#undef DRYDOCK_SETTING

	/** Defaults for all values and override bits. */
	void SetBaseValues()
	{
		*this = FPostProcessSettings();
	}
};

/** What a view renders with, after defaults, volumes, camera, clamps and show flags. */
struct FFinalPostProcessSettings : public FPostProcessSettings
{
};
