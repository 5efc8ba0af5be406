// How each row's pass is built and run, and the formulas that some are held to. What a case leaves open is chosen by
// the run, and said here.
#pragma once

namespace PassReference
{
struct FImage;
}

namespace Stability
{

using PassReference::FImage;
struct FCase;

// Sampling. Variants of the downsampling: pixel shader, compute.
FImage RunDownsampleLow(const FCase& Case);
FImage RunDownsampleHigh(const FCase& Case);
/** Levels: 3, that is a quarter of the size. */
FImage RunDownsampleChain(const FCase& Case);
/** To twice the size. Variants: nearest, bilinear. */
FImage RunUpscaleBilinear(const FCase& Case);
/** Variants: Catmull-Rom, Lanczos. */
FImage RunUpscaleLobes(const FCase& Case);
/** Variants: directional, Gaussian. */
FImage RunUpscaleSharpened(const FCase& Case);

/** Translucency everywhere: radiance (0.25, 0.5, 0.125), transmittance 0.5. */
FImage RunSeparateTranslucency(const FCase& Case);
FImage SeparateTranslucencyFormula(const FCase& Case);

// Bloom.
/** Threshold: -1, none. Variants: pixel shader, compute. */
FImage RunBloomSetup(const FCase& Case);
FImage BloomSetupFormula(const FCase& Case);
/** Intensity: of the toon, 1. Variants: pixel shader, compute. */
FImage RunToonBloomMask(const FCase& Case);
FImage ToonBloomMaskFormula(const FCase& Case);
/** Intensity: of the bloom, 1. Sigma: half of every stage's size. The default stages. */
FImage RunGaussianBloom(const FCase& Case);
/** Intensity: 1. The built-in kernel, half a picture wide. */
FImage RunFFTBloom(const FCase& Case);
FImage RunFFTConvolution(const FCase& Case);
/** Threshold -1, two iterations, spread (Sigma) 0.6, small target (Levels) half, intensity 1. Variants of the
 * first: sharp, soft knee. */
FImage RunUnityBloom(const FCase& Case);
FImage RunUnityBloomAsPrinted(const FCase& Case);

// Blurs.
/** Sigma: 1, a radius of 6. Intensity: the tint. Variants: clamp, mirror. */
FImage RunGaussianBlur(const FCase& Case);
/** With a black border. */
FImage RunGaussianBlurBorder(const FCase& Case);
/** Levels: 2. Sigma: the offset, 1. */
FImage RunDualKawase(const FCase& Case);
FImage RunDualKawaseAsPrinted(const FCase& Case);
/** Sigma: 2. Variants: separable, direct. */
FImage RunDualKawaseGaussian(const FCase& Case);
/** Sigma: 3. */
FImage RunKawase(const FCase& Case);
FImage RunPyramid(const FCase& Case);
/** Two stages, clamp addressing. Sigma: half the stages' size. */
FImage RunTextureBlur(const FCase& Case);

// Toon shadow: the picture is the shadow buffer, and the result A in every channel, decoded.
FImage RunToonShadowBlur(const FCase& Case);
/** Of a flat picture. */
FImage ToonShadowBlurFormula(const FCase& Case);
FImage RunToonShadowBlurAsPrinted(const FCase& Case);
/** The picture is lit scene colour; the shadow is 0.4, blurred 0.6. Variants: Screen, Max, Add, Max with a ramp. */
FImage RunToonShadowLighting(const FCase& Case);
FImage ToonShadowLightingFormula(const FCase& Case);
FImage RunToonShadowLightingAsPrinted(const FCase& Case);

// RED.
/** Intensity 1, Power 1, luminance threshold 0. Variants: Screen, Max. */
FImage RunREDDiffusion(const FCase& Case);
FImage REDDiffusionFormula(const FCase& Case);
FImage RunREDDiffusionAsPrinted(const FCase& Case);
/** Intensity: the blend, 1; saturation 1. Variants: kernels of the corrected form. */
FImage RunREDSoftFocus(const FCase& Case);
/** Intensity: 1. Threshold: of the luma, -1. */
FImage RunREDGlow(const FCase& Case);
FImage REDGlowFormula(const FCase& Case);
/** Area (Sigma) 3.5; Intensity: alpha of the colour, 1. */
FImage RunCharaGlow(const FCase& Case);
FImage CharaGlowFormula(const FCase& Case);
FImage RunCharaGlowAsPrinted(const FCase& Case);
/** In focus at 300 cm; kernel 4 pixels in diameter (Sigma: half of that). */
FImage RunREDDepthOfField(const FCase& Case);
FImage RunREDDepthOfFieldAsPrinted(const FCase& Case);

// Lens.
/** Sigma: the radius at infinity, 6. */
FImage RunDiaphragmDOF(const FCase& Case);
/** Sigma: the blur's length for a velocity of one pixel, 1. */
FImage RunMotionBlur(const FCase& Case);

// Exposure. Results are numbers laid out as a picture.
/** 64 x 1: the buckets. */
FImage RunHistogram(const FCase& Case);
FImage HistogramFormula(const FCase& Case);
/** 1 x 1: scale, target, average. Variants: histogram, basic. Frames: so many of 1/60 s. */
FImage RunEyeAdaptation(const FCase& Case);
FImage EyeAdaptationFormula(const FCase& Case);
FImage RunExposureCurve(const FCase& Case);
/** The picture times its factor. Intensity: the contrast of highlights, 0.5; Sigma: kernel in percent, 10. */
FImage RunLocalExposure(const FCase& Case);
/** Of a flat picture. */
FImage LocalExposureFormula(const FCase& Case);

// Display.
/** 32 x 32 colours of the table's middle slice. Intensity: the gain; Power: gamma and contrast of the grading, below an
 *  offset of -0.25. Variants: sRGB, the linear device that has the curve. */
FImage RunCombineLUTs(const FCase& Case);
/** Without vignette; grading as for the table. Variants: maths for each pixel, combined table. */
FImage RunTonemap(const FCase& Case);
/** Vignette, fringe, sharpening, grain, and the picture as its own bloom. */
FImage RunTonemapLens(const FCase& Case);
FImage RunTonemapGamma(const FCase& Case);
/** Variants: quality 0 to 5. */
FImage RunFXAA(const FCase& Case);
/** Intensity: the factor, 1. */
FImage RunTint(const FCase& Case);

// The whole frame.
/** Final picture at default settings. Intensity, Threshold: the bloom's; Sigma: its size scale, 4; Power: gamma of the
 *  grading. */
FImage RunFrame(const FCase& Case);
/** By the show flag. */
FImage FrameWithoutBloom(const FCase& Case);

} // namespace Stability
