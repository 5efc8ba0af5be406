// Describes the device that the tonemapper's result is for, its encoding and the format that carries it. Source: engine
// HDRHelper.h, PostProcessTonemap.h (names, numbers); the devices of linear light are drydock's reading of their names.
#pragma once

#include "CoreMinimal.h"
#include "PixelFormat.h"

/** r.HDR.Display.OutputDevice. Colours are Rec.709 but for the two ST 2084 devices, which are Rec.2020 (HDR10). */
enum class EDisplayOutputFormat : uint8
{
	SDR_sRGB,                 // film curve, IEC 61966-2-1
	SDR_Rec709,               // film curve, ITU-R BT.709
	SDR_ExplicitGammaMapping, // film curve, power 1 / r.TonemapperGamma
	HDR_ACES_1000nit_ST2084,  // ACES tone scales, perceptual quantizer
	HDR_ACES_2000nit_ST2084,
	HDR_ACES_1000nit_ScRGB, // ACES tone scales, linear, 1 is 80 nits
	HDR_ACES_2000nit_ScRGB,
	HDR_LinearEXR,           // graded, no tone curve, linear, up to 100, in 32-bit float
	HDR_LinearNoToneCurve,   // the same in half float
	HDR_LinearWithToneCurve, // film curve, linear, in half float
	MAX
};

struct FTonemapperOutputDeviceParameters
{
	/** 1 / display gamma, 2.2 / display gamma, 1 / r.TonemapperGamma (1 below it). The display's gamma is 2.2. */
	FVector3f InverseGamma;
	EDisplayOutputFormat OutputDevice;
};

/** The parameters by r.HDR.Display.OutputDevice; r.TonemapperGamma above 0 puts a power in the place of the sRGB or
 * Rec.709 curve.
 * */
DRYDOCK_API FTonemapperOutputDeviceParameters GetTonemapperOutputDeviceParameters();
/** The engine's form. */
inline FTonemapperOutputDeviceParameters GetTonemapperOutputDeviceParameters(const class FSceneViewFamily&)
{
	return GetTonemapperOutputDeviceParameters();
}

namespace Drydock
{

/** Format of the picture from the tonemapper on: 8 bit, 10 bit with ST 2084, half float for linear light, float for
 * EXR. */
DRYDOCK_API EPixelFormat GetDisplayFormat(EDisplayOutputFormat OutputDevice);

/** "sRGB"; what a file that holds the picture is tagged with. */
DRYDOCK_API const char* GetEncodingName(EDisplayOutputFormat OutputDevice);

} // namespace Drydock
