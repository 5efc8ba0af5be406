// The enums of post-process settings. Source: engine Engine/Scene.h; the last section is drydock's.
#pragma once

#include "CoreMinimal.h"

enum ETemperatureMethod : uint8
{
	TEMP_WhiteBalance,
	TEMP_ColorTemperature,
	TEMP_MAX,
};

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

enum class ELocalExposureMethod : uint8
{
	Bilateral,
	Fusion,
};

namespace EDynamicGlobalIlluminationMethod
{
enum Type : uint8
{
	None,
	Lumen,
	ScreenSpace,
	Plugin,
};
}

namespace EReflectionMethod
{
enum Type : uint8
{
	None,
	Lumen,
	ScreenSpace,
};
}

enum class ELumenRayLightingModeOverride : uint8
{
	Default,
	SurfaceCache,
	HitLightingForReflections,
	HitLighting,
};

enum class ETranslucencyType : uint8
{
	Raster,
	RayTracing,
};

enum class EReflectedAndRefractedRayTracedShadows : uint8
{
	Disabled,
	Hard_shadows,
	Area_shadows,
};

/** How lighting uses the blurred shadow: 1-(1-lit)(1-blurred), the greater of shadow and blurred, lit + blurred. */
enum class EToonShadowBlurBlend : uint8
{
	Screen,
	Max,
	Add,
};

/** In what the blurred shadow is computed and kept. */
enum class EToonShadowBlurStore : uint8
{
	EightBit,     // 8-bit temporaries and store: a mosaic
	SixteenBit,   // R16F temporaries, linear 8-bit store: bands
	SqrtEightBit, // R16F temporaries, square root in 8 bit: smooth
};

/** The way in which the diffusion filter combines its blur with the picture. */
enum class EDiffusionFilterBlend : uint8
{
	Screen,
	Max,
};
