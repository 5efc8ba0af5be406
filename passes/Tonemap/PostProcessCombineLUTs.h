// The combined table: everything between exposed scene-linear and the output device for 32^3 colours, once for each
// frame, so that the tonemapper needs two bilinear taps for each pixel. Source: engine file PostProcessCombineLUTs.h.
//
// r.LUT.Size (32) colours to a side, laid out flat in a 2D texture (red along x, green along y, slices of blue side by
// side), as the engine does where volume textures cannot be drawn to. PF_A2B10G10R10 holding values / 1.05 (white
// clip); half float for the devices of high dynamic range. Positions: 14 stops around middle grey, black exactly on the
// first texel, values above 43.7 on the last; devices of high dynamic range: ST 2084 of 100 nits for each 1.
//
// Against the same maths for each pixel (r.Drydock.TonemapLUT 0) the table errs, in sRGB code values cut to 0..1,
// default settings, over channels drawn from 2^-8 to 2^5: 0.002 at most and 0.0005 on average for greys; 0.096 at most
// and 0.0008 on average for all, above 0.01 for one colour in fifty: saturated ones, in a channel that comes out near 0
// (docs/tonemapper.md). A step of the table is 1.05 / 1023 = 0.00103.
//
// Source of the order: white balance, gamut expansion, colour correction, blue correction, film curve, legacy tables,
// fade, gamma, encoding: engine file PostProcessCombineLUTs.usf (PostProcessColorRemap.ush here).
//
// Contract. Reads settings, no picture. Every entry is finite: gains of any size and sign, offsets that take colours
// below 0 (which count as 0 before a power), a gamma of 0 (0.0001).
#pragma once

#include "CoreMinimal.h"
#include "RenderGraphFwd.h"
#include "ShaderParameterStruct.h"
#include "ShaderPermutation.h"
#include "Tonemap/TonemapOutputDevice.h"

class FRDGBuilder;
class FViewInfo;

/** The parameters that PostProcessColorRemap.ush reads. */
BEGIN_SHADER_PARAMETER_STRUCT(FColorRemapParameters, DRYDOCK_API)
	SHADER_PARAMETER(FVector4f, FilmSlopeToeShoulderBlackClip)
	SHADER_PARAMETER(float, FilmWhiteClip)
	SHADER_PARAMETER(float, BlueCorrection)
	SHADER_PARAMETER(float, ExpandGamut)
	SHADER_PARAMETER(float, ToneCurveAmount)
	SHADER_PARAMETER(FVector3f, InverseGamma)
	SHADER_PARAMETER(FVector4f, OverlayColor)
	SHADER_PARAMETER(FVector3f, ColorScale)
	SHADER_PARAMETER(float, SceneColorMultiplier)
	SHADER_PARAMETER(float, LUTSize)
	SHADER_PARAMETER_ARRAY(FVector4f, WhiteBalance, [3])
	SHADER_PARAMETER_ARRAY(FVector4f, ColorSaturation, [3])
	SHADER_PARAMETER_ARRAY(FVector4f, ColorContrast, [3])
	SHADER_PARAMETER_ARRAY(FVector4f, ColorGamma, [3])
	SHADER_PARAMETER_ARRAY(FVector4f, ColorGain, [3])
	SHADER_PARAMETER_ARRAY(FVector4f, ColorOffset, [3])
	SHADER_PARAMETER(FVector4f, ColorRanges)
	SHADER_PARAMETER(FVector4f, ColorGradingLUTWeights)
	SHADER_PARAMETER(float, NeutralLUTWeight)
	SHADER_PARAMETER_SAMPLER(SamplerState, ColorGradingLUTSampler)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ColorGradingLUT0)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ColorGradingLUT1)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ColorGradingLUT2)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ColorGradingLUT3)
END_SHADER_PARAMETER_STRUCT()

namespace Drydock
{

/** Legacy tables that are blended at most, beside the neutral one; further ones count as neutral. */
constexpr int32 MaxBlendedLUTs = 4;

class FColorGradingDimension : SHADER_PERMUTATION_BOOL("USE_COLOR_GRADING");
class FLUTBlendCountDimension : SHADER_PERMUTATION_INT("LUT_BLEND_COUNT", 5);
class FOutputDeviceDimension : SHADER_PERMUTATION_ENUM_CLASS("DIM_OUTPUT_DEVICE", EDisplayOutputFormat);

using FColorRemapPermutation =
	TShaderPermutationDomain<FColorGradingDimension, FLUTBlendCountDimension, FOutputDeviceDimension>;

struct FColorRemap
{
	FColorRemapParameters Parameters;
	FColorRemapPermutation Permutation;
};

/** Makes the parameters from the view's final settings, its fade, and the output device. Registers the legacy tables it
 * blends. */
DRYDOCK_API FColorRemap MakeColorRemap(FRDGBuilder& GraphBuilder, const FViewInfo& View);

/** r.LUT.Size, 16 to 65. */
DRYDOCK_API int32 GetLUTSize();

/** r.Drydock.TonemapLUT. */
DRYDOCK_API bool IsTonemapLUTUsed();

} // namespace Drydock

/** The combined table of a view. */
DRYDOCK_API FRDGTextureRef AddCombineLUTPass(FRDGBuilder& GraphBuilder, const FViewInfo& View);
