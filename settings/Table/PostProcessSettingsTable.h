// The one list of post-process settings. Members, override bits, reflection, blending, JSON, `--pp`, the config schema
// and `drydock list settings` all come from here: adding a setting is one line. Included several times, hence no guard;
// each time DRYDOCK_SETTING defines what a line becomes.
//
//   DRYDOCK_SETTING(Type, Name, Default, Range, Unit, Category, Blend, Doc)
//   DRYDOCK_SETTING_BIT(Type, Name, Bit, Default, ...)   where the override bit is not bOverride_Name
//
// Type      float, bool, int32, an enum of PostProcessSettingsEnums.h, FLinearColor, FVector2D, FVector4,
//           FLensFlareTints, TObjectPtr of UTexture, UTexture2D, UTextureCube or UCurveFloat
// Range     Anything, AtLeast(ClampMin, UIMax), Between(ClampMin, ClampMax) or Slider(UIMin, UIMax), which warns of
//           nothing; the engine does not enforce clamps at run time
// Unit      of the value, "" where it has none
// Category  as in the editor, levels separated by |
// Blend     what a volume of some weight does with it: ESettingBlend
//
// Sources. Names and defaults: engine FPostProcessSettings 5.4; some fields are older or younger, so that a volume's
// full export is understood, and are marked so. Ranges: the editor's, as far as known. Values that a line calls
// "drydock" are chosen here.

// clang-format off

#ifndef DRYDOCK_SETTING_BIT
#define DRYDOCK_SETTING_BIT(Type, Name, Bit, Default, Range, Unit, Category, Blend, Doc) DRYDOCK_SETTING(Type, Name, Default, Range, Unit, Category, Blend, Doc)
#endif

// White balance
DRYDOCK_SETTING(ETemperatureMethod, TemperatureType, TEMP_WhiteBalance, Anything, "", "Color Grading|Temperature", Set, "TEMP_WhiteBalance: WhiteTemp is what is to look white; TEMP_ColorTemperature: the picture takes on the temperature.")
DRYDOCK_SETTING(float, WhiteTemp, 6500.0f, Slider(1500, 15000), "K", "Color Grading|Temperature", Lerp, "Temperature of white; 6500 leaves the picture as it is.")
DRYDOCK_SETTING(float, WhiteTint, 0.0f, Slider(-1, 1), "", "Color Grading|Temperature", Lerp, "Shift between magenta and green, across the temperature.")

// Colour grading: of all pixels, then of those in the dark, the middle and the bright
DRYDOCK_SETTING(FVector4, ColorSaturation, FVector4(1.0, 1.0, 1.0, 1.0), Slider(0, 2), "", "Color Grading|Global", Lerp, "Distance of colours from grey, everywhere: X, Y, Z per channel, W for all of them.")
DRYDOCK_SETTING(FVector4, ColorContrast, FVector4(1.0, 1.0, 1.0, 1.0), Slider(0, 2), "", "Color Grading|Global", Lerp, "Power around middle grey, everywhere: X, Y, Z per channel, W for all of them.")
DRYDOCK_SETTING(FVector4, ColorGamma, FVector4(1.0, 1.0, 1.0, 1.0), Slider(0, 2), "", "Color Grading|Global", Lerp, "Power of the colour, inverse, everywhere: X, Y, Z per channel, W for all of them.")
DRYDOCK_SETTING(FVector4, ColorGain, FVector4(1.0, 1.0, 1.0, 1.0), Slider(0, 2), "", "Color Grading|Global", Lerp, "Factor of the colour, everywhere: X, Y, Z per channel, W for all of them.")
DRYDOCK_SETTING(FVector4, ColorOffset, FVector4(0.0, 0.0, 0.0, 0.0), Slider(-1, 1), "", "Color Grading|Global", Lerp, "Added to the colour, everywhere: X, Y, Z per channel, W for all of them.")
DRYDOCK_SETTING(FVector4, ColorSaturationShadows, FVector4(1.0, 1.0, 1.0, 1.0), Slider(0, 2), "", "Color Grading|Shadows", Lerp, "Distance of colours from grey, in the shadows: X, Y, Z per channel, W for all of them.")
DRYDOCK_SETTING(FVector4, ColorContrastShadows, FVector4(1.0, 1.0, 1.0, 1.0), Slider(0, 2), "", "Color Grading|Shadows", Lerp, "Power around middle grey, in the shadows: X, Y, Z per channel, W for all of them.")
DRYDOCK_SETTING(FVector4, ColorGammaShadows, FVector4(1.0, 1.0, 1.0, 1.0), Slider(0, 2), "", "Color Grading|Shadows", Lerp, "Power of the colour, inverse, in the shadows: X, Y, Z per channel, W for all of them.")
DRYDOCK_SETTING(FVector4, ColorGainShadows, FVector4(1.0, 1.0, 1.0, 1.0), Slider(0, 2), "", "Color Grading|Shadows", Lerp, "Factor of the colour, in the shadows: X, Y, Z per channel, W for all of them.")
DRYDOCK_SETTING(FVector4, ColorOffsetShadows, FVector4(0.0, 0.0, 0.0, 0.0), Slider(-1, 1), "", "Color Grading|Shadows", Lerp, "Added to the colour, in the shadows: X, Y, Z per channel, W for all of them.")
DRYDOCK_SETTING(FVector4, ColorSaturationMidtones, FVector4(1.0, 1.0, 1.0, 1.0), Slider(0, 2), "", "Color Grading|Midtones", Lerp, "Distance of colours from grey, in the midtones: X, Y, Z per channel, W for all of them.")
DRYDOCK_SETTING(FVector4, ColorContrastMidtones, FVector4(1.0, 1.0, 1.0, 1.0), Slider(0, 2), "", "Color Grading|Midtones", Lerp, "Power around middle grey, in the midtones: X, Y, Z per channel, W for all of them.")
DRYDOCK_SETTING(FVector4, ColorGammaMidtones, FVector4(1.0, 1.0, 1.0, 1.0), Slider(0, 2), "", "Color Grading|Midtones", Lerp, "Power of the colour, inverse, in the midtones: X, Y, Z per channel, W for all of them.")
DRYDOCK_SETTING(FVector4, ColorGainMidtones, FVector4(1.0, 1.0, 1.0, 1.0), Slider(0, 2), "", "Color Grading|Midtones", Lerp, "Factor of the colour, in the midtones: X, Y, Z per channel, W for all of them.")
DRYDOCK_SETTING(FVector4, ColorOffsetMidtones, FVector4(0.0, 0.0, 0.0, 0.0), Slider(-1, 1), "", "Color Grading|Midtones", Lerp, "Added to the colour, in the midtones: X, Y, Z per channel, W for all of them.")
DRYDOCK_SETTING(FVector4, ColorSaturationHighlights, FVector4(1.0, 1.0, 1.0, 1.0), Slider(0, 2), "", "Color Grading|Highlights", Lerp, "Distance of colours from grey, in the highlights: X, Y, Z per channel, W for all of them.")
DRYDOCK_SETTING(FVector4, ColorContrastHighlights, FVector4(1.0, 1.0, 1.0, 1.0), Slider(0, 2), "", "Color Grading|Highlights", Lerp, "Power around middle grey, in the highlights: X, Y, Z per channel, W for all of them.")
DRYDOCK_SETTING(FVector4, ColorGammaHighlights, FVector4(1.0, 1.0, 1.0, 1.0), Slider(0, 2), "", "Color Grading|Highlights", Lerp, "Power of the colour, inverse, in the highlights: X, Y, Z per channel, W for all of them.")
DRYDOCK_SETTING(FVector4, ColorGainHighlights, FVector4(1.0, 1.0, 1.0, 1.0), Slider(0, 2), "", "Color Grading|Highlights", Lerp, "Factor of the colour, in the highlights: X, Y, Z per channel, W for all of them.")
DRYDOCK_SETTING(FVector4, ColorOffsetHighlights, FVector4(0.0, 0.0, 0.0, 0.0), Slider(-1, 1), "", "Color Grading|Highlights", Lerp, "Added to the colour, in the highlights: X, Y, Z per channel, W for all of them.")
DRYDOCK_SETTING(float, ColorCorrectionShadowsMax, 0.09f, Slider(-1, 1), "luminance", "Color Grading|Shadows", Lerp, "Up to here a pixel counts as shadow.")
DRYDOCK_SETTING(float, ColorCorrectionHighlightsMin, 0.5f, Slider(-1, 1), "luminance", "Color Grading|Highlights", Lerp, "From here on a pixel begins to count as highlight.")
DRYDOCK_SETTING(float, ColorCorrectionHighlightsMax, 1.0f, Slider(1, 10), "luminance", "Color Grading|Highlights", Lerp, "From here on a pixel counts as highlight fully.")
DRYDOCK_SETTING(float, ColorGradingIntensity, 1.0f, Between(0, 1), "", "Color Grading|Misc", LUT, "How much of ColorGradingLUT is applied.")
DRYDOCK_SETTING(TObjectPtr<UTexture>, ColorGradingLUT, nullptr, Anything, "", "Color Grading|Misc", LUT, "Table from colour to colour, 256x16 pixels, applied after the film curve.")

// Colour correction that the tonemapper carries
DRYDOCK_SETTING(float, BlueCorrection, 0.6f, Between(0, 1), "", "Color Grading|Misc", Lerp, "Corrects bright blue lights that turn violet in AP1.")
DRYDOCK_SETTING(float, ExpandGamut, 1.0f, Between(0, 1), "", "Color Grading|Misc", Lerp, "Expands bright saturated colours outside the sRGB gamut, to fake wide-gamut rendering.")
DRYDOCK_SETTING(float, ToneCurveAmount, 1.0f, Between(0, 1), "", "Color Grading|Misc", Lerp, "How much of the film curve is applied: 0 none, 1 all.")
DRYDOCK_SETTING(FLinearColor, SceneColorTint, FLinearColor(1.0f, 1.0f, 1.0f, 1.0f), Anything, "", "Color Grading|Misc", Lerp, "Multiplies the scene colour, not the bloom.")

// Film
DRYDOCK_SETTING(float, FilmSlope, 0.88f, Between(0, 1), "", "Film", Lerp, "Steepness of the film curve: larger darkens shadows and brightens highlights.")
DRYDOCK_SETTING(float, FilmToe, 0.55f, Between(0, 1), "", "Film", Lerp, "Dark end of the film curve: larger gives darker darks.")
DRYDOCK_SETTING(float, FilmShoulder, 0.26f, Between(0, 1), "", "Film", Lerp, "Bright end of the film curve: larger compresses highlights more.")
DRYDOCK_SETTING(float, FilmBlackClip, 0.0f, Between(0, 1), "", "Film", Lerp, "Output value at which the darkest end is cut off.")
DRYDOCK_SETTING(float, FilmWhiteClip, 0.04f, Between(0, 1), "", "Film", Lerp, "How far the curve may pass white before it is cut off, in output.")

// Lens: fringe
DRYDOCK_SETTING(float, SceneFringeIntensity, 0.0f, AtLeast(0, 5), "%", "Lens|Chromatic Aberration", Lerp, "Shift of red and green against blue at the edge of the picture.")
DRYDOCK_SETTING(float, ChromaticAberrationStartOffset, 0.0f, Between(0, 1), "", "Lens|Chromatic Aberration", Lerp, "Distance from the centre at which the effect begins.")

// Bloom
DRYDOCK_SETTING(EBloomMethod, BloomMethod, BM_SOG, Anything, "", "Lens|Bloom", Set, "BM_SOG: a sum of Gaussians; BM_FFT: convolution with a kernel picture.")
DRYDOCK_SETTING(float, BloomIntensity, 0.675f, AtLeast(0, 8), "", "Lens|Bloom", Lerp, "Multiplies all bloom; 0 switches it off.")
DRYDOCK_SETTING(float, BloomThreshold, -1.0f, AtLeast(-1, 8), "exposed luminance", "Lens|Bloom", Lerp, "Luminance at which bloom begins, full two units above; -1 lets everything bloom.")
DRYDOCK_SETTING(float, BloomSizeScale, 4.0f, AtLeast(0, 64), "", "Lens|Bloom", Lerp, "Multiplies all bloom sizes.")
DRYDOCK_SETTING(float, Bloom1Size, 0.3f, AtLeast(0, 4), "% of the view's width", "Lens|Bloom", Lerp, "Diameter of the narrowest Gaussian, at half resolution.")
DRYDOCK_SETTING(float, Bloom2Size, 1.0f, AtLeast(0, 8), "% of the view's width", "Lens|Bloom", Lerp, "Diameter of the second Gaussian, at a quarter of the resolution.")
DRYDOCK_SETTING(float, Bloom3Size, 2.0f, AtLeast(0, 16), "% of the view's width", "Lens|Bloom", Lerp, "Diameter of the third Gaussian, at 1/8 of the resolution.")
DRYDOCK_SETTING(float, Bloom4Size, 10.0f, AtLeast(0, 32), "% of the view's width", "Lens|Bloom", Lerp, "Diameter of the fourth Gaussian, at 1/16 of the resolution.")
DRYDOCK_SETTING(float, Bloom5Size, 30.0f, AtLeast(0, 64), "% of the view's width", "Lens|Bloom", Lerp, "Diameter of the fifth Gaussian, at 1/32 of the resolution.")
DRYDOCK_SETTING(float, Bloom6Size, 64.0f, AtLeast(0, 128), "% of the view's width", "Lens|Bloom", Lerp, "Diameter of the widest Gaussian, at 1/64 of the resolution.")
DRYDOCK_SETTING(FLinearColor, Bloom1Tint, FLinearColor(0.3465f, 0.3465f, 0.3465f, 1.0f), Anything, "", "Lens|Bloom", Lerp, "Colour and strength of the narrowest Gaussian.")
DRYDOCK_SETTING(FLinearColor, Bloom2Tint, FLinearColor(0.138f, 0.138f, 0.138f, 1.0f), Anything, "", "Lens|Bloom", Lerp, "Colour and strength of the second Gaussian.")
DRYDOCK_SETTING(FLinearColor, Bloom3Tint, FLinearColor(0.1176f, 0.1176f, 0.1176f, 1.0f), Anything, "", "Lens|Bloom", Lerp, "Colour and strength of the third Gaussian.")
DRYDOCK_SETTING(FLinearColor, Bloom4Tint, FLinearColor(0.066f, 0.066f, 0.066f, 1.0f), Anything, "", "Lens|Bloom", Lerp, "Colour and strength of the fourth Gaussian.")
DRYDOCK_SETTING(FLinearColor, Bloom5Tint, FLinearColor(0.066f, 0.066f, 0.066f, 1.0f), Anything, "", "Lens|Bloom", Lerp, "Colour and strength of the fifth Gaussian.")
DRYDOCK_SETTING(FLinearColor, Bloom6Tint, FLinearColor(0.061f, 0.061f, 0.061f, 1.0f), Anything, "", "Lens|Bloom", Lerp, "Colour and strength of the widest Gaussian.")
DRYDOCK_SETTING(float, BloomConvolutionIntensity, 1.0f, AtLeast(0, 8), "", "Lens|Bloom", Lerp, "BM_FFT: multiplies its bloom, since 5.6.")
DRYDOCK_SETTING(TObjectPtr<UTexture2D>, BloomConvolutionTexture, nullptr, Anything, "", "Lens|Bloom", SetIfNonZero, "BM_FFT: kernel picture; None is the built-in one.")
DRYDOCK_SETTING(float, BloomConvolutionScatterDispersion, 1.0f, AtLeast(0, 20), "", "Lens|Bloom", Lerp, "BM_FFT: energy moved from the kernel's centre outwards.")
DRYDOCK_SETTING(float, BloomConvolutionSize, 1.0f, Between(0, 1), "of the view", "Lens|Bloom", Lerp, "BM_FFT: size of the kernel picture.")
DRYDOCK_SETTING(FVector2D, BloomConvolutionCenterUV, FVector2D(0.5, 0.5), Anything, "UV", "Lens|Bloom", Lerp, "BM_FFT: centre of the kernel picture.")
DRYDOCK_SETTING(float, BloomConvolutionPreFilterMin, 7.0f, AtLeast(0, 1000), "luminance", "Lens|Bloom", Lerp, "BM_FFT: boost pixels above this.")
DRYDOCK_SETTING(float, BloomConvolutionPreFilterMax, 15000.0f, AtLeast(0, 15000), "luminance", "Lens|Bloom", Lerp, "BM_FFT: boost pixels below this.")
DRYDOCK_SETTING(float, BloomConvolutionPreFilterMult, 15.0f, AtLeast(0, 1000), "", "Lens|Bloom", Lerp, "BM_FFT: strength of the boost.")
DRYDOCK_SETTING(float, BloomConvolutionBufferScale, 0.133f, Between(0, 1), "of the view", "Lens|Bloom", SetIfNonZero, "BM_FFT: border added around the picture before the convolution.")
DRYDOCK_SETTING(TObjectPtr<UTexture>, BloomDirtMask, nullptr, Anything, "", "Lens|Dirt Mask", SetIfNonZero, "Picture of the dirt on the lens, lit by the bloom.")
DRYDOCK_SETTING(float, BloomDirtMaskIntensity, 0.0f, AtLeast(0, 8), "", "Lens|Dirt Mask", Lerp, "Strength of the dirt mask on the bloom.")
DRYDOCK_SETTING(FLinearColor, BloomDirtMaskTint, FLinearColor(0.5f, 0.5f, 0.5f, 1.0f), Anything, "", "Lens|Dirt Mask", Lerp, "Colour of the dirt mask.")

// Camera
DRYDOCK_SETTING(float, CameraShutterSpeed, 60.0f, AtLeast(1, 2000), "1/s", "Lens|Camera", Lerp, "Shutter speed, as the denominator of a second.")
DRYDOCK_SETTING(float, CameraISO, 100.0f, AtLeast(1, 51200), "ISO", "Lens|Camera", Lerp, "Sensitivity of the sensor.")
DRYDOCK_SETTING(float, DepthOfFieldFstop, 4.0f, AtLeast(1, 32), "f-number", "Lens|Camera", Lerp, "Aperture: a smaller number blurs more, and exposes more with AEM_Manual.")
DRYDOCK_SETTING(float, DepthOfFieldMinFstop, 1.2f, AtLeast(0, 5), "f-number", "Lens|Camera", Lerp, "Widest aperture, where the opening is round: the blades bend as its edge does; 0: straight blades.")
DRYDOCK_SETTING(int32, DepthOfFieldBladeCount, 5, Between(4, 16), "", "Lens|Camera", Set, "Blades of the diaphragm: corners of the bokeh.")

// Exposure
DRYDOCK_SETTING(EAutoExposureMethod, AutoExposureMethod, AEM_Histogram, Anything, "", "Lens|Exposure", Set, "How the exposure is found: AEM_Histogram, AEM_Basic, AEM_Manual.")
DRYDOCK_SETTING(float, AutoExposureBias, 1.0f, Anything, "EV", "Lens|Exposure", Lerp, "Exposure compensation; one more doubles the brightness.")
DRYDOCK_SETTING(float, AutoExposureBiasBackup, 0.0f, Anything, "EV", "Lens|Exposure", Lerp, "The editor's copy of a bias from before 4.25; nothing reads it.")
DRYDOCK_SETTING(bool, AutoExposureApplyPhysicalCameraExposure, true, Anything, "", "Lens|Exposure", Set, "AEM_Manual: exposure from shutter speed, ISO and f-stop.")
DRYDOCK_SETTING(TObjectPtr<UCurveFloat>, AutoExposureBiasCurve, nullptr, Anything, "", "Lens|Exposure", SetIfNonZero, "Exposure compensation over the average scene luminance in EV100, added to the bias.")
DRYDOCK_SETTING(TObjectPtr<UTexture>, AutoExposureMeterMask, nullptr, Anything, "", "Lens|Exposure", SetIfNonZero, "Weights of the metering: bright areas count more.")
DRYDOCK_SETTING(float, AutoExposureLowPercent, 10.0f, Between(0, 100), "%", "Lens|Exposure", Lerp, "AEM_Histogram: share of dark pixels left out.")
DRYDOCK_SETTING(float, AutoExposureHighPercent, 90.0f, Between(0, 100), "%", "Lens|Exposure", Lerp, "AEM_Histogram: pixels above this share are left out.")
DRYDOCK_SETTING(float, AutoExposureMinBrightness, 0.03f, Anything, "luminance", "Lens|Exposure", Lerp, "Least brightness the eye adapts to.")
DRYDOCK_SETTING(float, AutoExposureMaxBrightness, 8.0f, Anything, "luminance", "Lens|Exposure", Lerp, "Greatest brightness the eye adapts to.")
DRYDOCK_SETTING(float, AutoExposureSpeedUp, 3.0f, AtLeast(0.02, 20), "EV per second", "Lens|Exposure", Lerp, "Speed of adaptation from dark to bright.")
DRYDOCK_SETTING(float, AutoExposureSpeedDown, 1.0f, AtLeast(0.02, 20), "EV per second", "Lens|Exposure", Lerp, "Speed of adaptation from bright to dark.")
DRYDOCK_SETTING(float, HistogramLogMin, -8.0f, Anything, "log2 luminance", "Lens|Exposure", Lerp, "AEM_Histogram: lower end.")
DRYDOCK_SETTING(float, HistogramLogMax, 4.0f, Anything, "log2 luminance", "Lens|Exposure", Lerp, "AEM_Histogram: upper end.")
DRYDOCK_SETTING(float, AutoExposureCalibrationConstant, 18.0f, Between(0, 100), "%", "Lens|Exposure", Lerp, "Grey that the exposure aims at. Deprecated in the engine; default and rule: drydock.")

// Local exposure
DRYDOCK_SETTING(ELocalExposureMethod, LocalExposureMethod, ELocalExposureMethod::Bilateral, Anything, "", "Lens|Local Exposure", Set, "Bilateral grid, or fusion of several exposures; since 5.5.")
DRYDOCK_SETTING(float, LocalExposureHighlightContrastScale, 1.0f, Between(0, 1), "", "Lens|Local Exposure", Lerp, "Contrast kept above middle grey; 1 leaves it as it is.")
DRYDOCK_SETTING(float, LocalExposureShadowContrastScale, 1.0f, Between(0, 1), "", "Lens|Local Exposure", Lerp, "Contrast kept below middle grey; 1 leaves it as it is.")
DRYDOCK_SETTING(TObjectPtr<UCurveFloat>, LocalExposureHighlightContrastCurve, nullptr, Anything, "", "Lens|Local Exposure", SetIfNonZero, "Factor of the highlight contrast over EV100 (rule: drydock).")
DRYDOCK_SETTING(TObjectPtr<UCurveFloat>, LocalExposureShadowContrastCurve, nullptr, Anything, "", "Lens|Local Exposure", SetIfNonZero, "Factor of the shadow contrast over EV100 (rule: drydock).")
DRYDOCK_SETTING(float, LocalExposureHighlightThreshold, 0.0f, Between(0, 4), "EV", "Lens|Local Exposure", Lerp, "Distance above middle grey that is left alone.")
DRYDOCK_SETTING(float, LocalExposureShadowThreshold, 0.0f, Between(0, 4), "EV", "Lens|Local Exposure", Lerp, "Distance below middle grey that is left alone.")
DRYDOCK_SETTING(float, LocalExposureHighlightThresholdStrength, 1.0f, Between(0, 1), "", "Lens|Local Exposure", Lerp, "How much the highlight threshold counts, since 5.6 (range: drydock).")
DRYDOCK_SETTING(float, LocalExposureShadowThresholdStrength, 1.0f, Between(0, 1), "", "Lens|Local Exposure", Lerp, "How much the shadow threshold counts, since 5.6 (range: drydock).")
DRYDOCK_SETTING(float, LocalExposureDetailStrength, 1.0f, Between(0, 4), "", "Lens|Local Exposure", Lerp, "Contrast of details finer than the bilateral grid.")
DRYDOCK_SETTING(float, LocalExposureBlurredLuminanceBlend, 0.6f, Between(0, 1), "", "Lens|Local Exposure", Lerp, "Share of the plainly blurred luminance against the bilateral one.")
DRYDOCK_SETTING(float, LocalExposureBlurredLuminanceKernelSizePercent, 50.0f, Between(0, 100), "%", "Lens|Local Exposure", Lerp, "Size of that blur, of the screen.")
DRYDOCK_SETTING(float, LocalExposureMiddleGreyBias, 0.0f, Slider(-15, 15), "EV", "Lens|Local Exposure", Lerp, "Shift of middle grey.")

// Lens flares
DRYDOCK_SETTING(float, LensFlareIntensity, 1.0f, AtLeast(0, 16), "", "Lens|Lens Flares", Lerp, "Brightness of the flares.")
DRYDOCK_SETTING(FLinearColor, LensFlareTint, FLinearColor(1.0f, 1.0f, 1.0f, 1.0f), Anything, "", "Lens|Lens Flares", Lerp, "Colour of all flares.")
DRYDOCK_SETTING(FLensFlareTints, LensFlareTints, DRYDOCK_LIST(FLinearColor(1.0f, 0.8f, 0.4f, 0.6f), FLinearColor(1.0f, 1.0f, 0.6f, 0.53f), FLinearColor(0.8f, 0.8f, 1.0f, 0.46f), FLinearColor(0.5f, 1.0f, 0.4f, 0.39f), FLinearColor(0.5f, 0.8f, 1.0f, 0.31f), FLinearColor(0.9f, 1.0f, 0.8f, 0.27f), FLinearColor(1.0f, 0.8f, 0.4f, 0.22f), FLinearColor(0.9f, 0.7f, 0.7f, 0.15f)), Anything, "", "Lens|Lens Flares", Lerp, "Colour of each of the eight flares; alpha is its size and place.")
DRYDOCK_SETTING(float, LensFlareBokehSize, 3.0f, AtLeast(0, 32), "% of the view's width", "Lens|Lens Flares", Lerp, "Size of the blur of the flares.")
DRYDOCK_SETTING(float, LensFlareThreshold, 8.0f, AtLeast(0.1, 32), "luminance", "Lens|Lens Flares", Lerp, "Luminance at which a pixel begins to flare.")
DRYDOCK_SETTING(TObjectPtr<UTexture>, LensFlareBokehShape, nullptr, Anything, "", "Lens|Lens Flares", SetIfNonZero, "Shape of the blur; None is a disc.")

// Image effects
DRYDOCK_SETTING(float, VignetteIntensity, 0.4f, Between(0, 1), "", "Lens|Image Effects", Lerp, "Darkening of the picture's corners.")
DRYDOCK_SETTING(float, Sharpen, 0.0f, Between(0, 10), "", "Lens|Image Effects", Lerp, "Sharpening in the tonemapper.")

// Film grain
DRYDOCK_SETTING(float, FilmGrainIntensity, 0.0f, Between(0, 1), "", "Film Grain", Lerp, "Strength of the grain; 0 switches it off.")
DRYDOCK_SETTING(float, FilmGrainIntensityShadows, 1.0f, Between(0, 1), "", "Film Grain", Lerp, "Factor of the strength in the shadows.")
DRYDOCK_SETTING(float, FilmGrainIntensityMidtones, 1.0f, Between(0, 1), "", "Film Grain", Lerp, "Factor of the strength in the midtones.")
DRYDOCK_SETTING(float, FilmGrainIntensityHighlights, 1.0f, Between(0, 1), "", "Film Grain", Lerp, "Factor of the strength in the highlights.")
DRYDOCK_SETTING(float, FilmGrainShadowsMax, 0.09f, Between(0, 1), "luminance", "Film Grain", Lerp, "Up to here a pixel counts as shadow.")
DRYDOCK_SETTING(float, FilmGrainHighlightsMin, 0.5f, Between(0, 1), "luminance", "Film Grain", Lerp, "From here on a pixel begins to count as highlight.")
DRYDOCK_SETTING(float, FilmGrainHighlightsMax, 1.0f, Between(1, 10), "luminance", "Film Grain", Lerp, "From here on a pixel counts as highlight fully.")
DRYDOCK_SETTING(float, FilmGrainTexelSize, 1.0f, Between(0, 4), "px", "Film Grain", Lerp, "Size of a texel of the grain on the screen.")
DRYDOCK_SETTING(TObjectPtr<UTexture2D>, FilmGrainTexture, nullptr, Anything, "", "Film Grain", SetIfNonZero, "Picture of the grain; None is the built-in noise.")

// Depth of field
DRYDOCK_SETTING(float, DepthOfFieldSensorWidth, 24.576f, AtLeast(0.1, 1000), "mm", "Lens|Depth of Field", Lerp, "Width of the sensor: a larger one blurs more.")
DRYDOCK_SETTING(float, DepthOfFieldSqueezeFactor, 1.0f, Between(1, 2), "", "Lens|Depth of Field", Lerp, "Squeeze of an anamorphic lens: makes the bokeh oval.")
DRYDOCK_SETTING(float, DepthOfFieldFocalDistance, 0.0f, AtLeast(0, 10000), "cm", "Lens|Depth of Field", FocalDistance, "Distance in focus; 0 switches the effect off.")
DRYDOCK_SETTING(float, DepthOfFieldDepthBlurAmount, 1.0f, AtLeast(0.000001, 100), "km", "Lens|Depth of Field", Lerp, "Distance at which the blur of the air reaches half of DepthOfFieldDepthBlurRadius.")
DRYDOCK_SETTING(float, DepthOfFieldDepthBlurRadius, 0.0f, AtLeast(0, 4), "px at 1920 wide", "Lens|Depth of Field", Lerp, "Blur of the air at infinity; 0 switches it off.")
DRYDOCK_SETTING(bool, DepthOfFieldUseHairDepth, false, Anything, "", "Lens|Depth of Field", Set, "Takes hair's own depth for the circle of confusion.")
DRYDOCK_SETTING(float, DepthOfFieldPetzvalBokeh, 0.0f, Slider(-5, 5), "", "Lens|Depth of Field", Lerp, "Swirl of the bokeh, since 5.5 (range: drydock).")
DRYDOCK_SETTING(float, DepthOfFieldPetzvalBokehFalloff, 1.0f, AtLeast(0, 10), "", "Lens|Depth of Field", Lerp, "Falloff of the swirl towards the centre, since 5.5 (range: drydock).")
DRYDOCK_SETTING(FVector2D, DepthOfFieldPetzvalExclusionBoxExtents, FVector2D(0.0, 0.0), Between(0, 1), "of the view", "Lens|Depth of Field", Lerp, "Half size of a box in the middle without swirl, since 5.5 (range: drydock).")
DRYDOCK_SETTING(float, DepthOfFieldPetzvalExclusionBoxRadius, 0.0f, Between(0, 1), "of the view", "Lens|Depth of Field", Lerp, "Rounding of that box, since 5.5 (range: drydock).")
DRYDOCK_SETTING(float, DepthOfFieldAspectRatioScalar, 1.0f, AtLeast(0, 2), "", "Lens|Depth of Field", Lerp, "Factor of the aspect ratio that the swirl assumes, since 5.5 (range: drydock).")
DRYDOCK_SETTING(float, DepthOfFieldBarrelRadius, 5.0f, AtLeast(0, 100), "cm", "Lens|Depth of Field", Lerp, "Radius of the lens barrel that cuts the bokeh, since 5.5 (unit and range: drydock).")
DRYDOCK_SETTING(float, DepthOfFieldBarrelLength, 0.0f, AtLeast(0, 100), "cm", "Lens|Depth of Field", Lerp, "Length of the lens barrel; 0 switches it off; since 5.5 (unit and range: drydock).")

// Depth of field of the mobile renderer
DRYDOCK_SETTING_BIT(bool, bMobileHQGaussian, MobileHQGaussian, false, Anything, "", "Lens|Mobile Depth of Field", Set, "Gaussian of high quality.")
DRYDOCK_SETTING(float, DepthOfFieldFocalRegion, 0.0f, AtLeast(0, 10000), "cm", "Lens|Mobile Depth of Field", Lerp, "Depth that is in focus behind the focal distance.")
DRYDOCK_SETTING(float, DepthOfFieldNearTransitionRegion, 300.0f, AtLeast(0, 10000), "cm", "Lens|Mobile Depth of Field", Lerp, "From in focus to fully blurred, towards the camera.")
DRYDOCK_SETTING(float, DepthOfFieldFarTransitionRegion, 500.0f, AtLeast(0, 10000), "cm", "Lens|Mobile Depth of Field", Lerp, "From in focus to fully blurred, away from the camera.")
DRYDOCK_SETTING(float, DepthOfFieldScale, 0.0f, Slider(0, 2), "", "Lens|Mobile Depth of Field", Lerp, "Factor of the blur; 0 switches it off.")
DRYDOCK_SETTING(float, DepthOfFieldNearBlurSize, 15.0f, AtLeast(0, 32), "% of the view's width", "Lens|Mobile Depth of Field", Lerp, "Greatest blur in front.")
DRYDOCK_SETTING(float, DepthOfFieldFarBlurSize, 15.0f, AtLeast(0, 32), "% of the view's width", "Lens|Mobile Depth of Field", Lerp, "Greatest blur behind.")
DRYDOCK_SETTING(float, DepthOfFieldOcclusion, 0.4f, Between(0, 1), "", "Lens|Mobile Depth of Field", Lerp, "How far blurred foreground covers what is behind it.")
DRYDOCK_SETTING(float, DepthOfFieldSkyFocusDistance, 0.0f, AtLeast(0, 200000), "cm", "Lens|Mobile Depth of Field", Lerp, "From here on everything counts as sky and is sharp; 0: no sky.")
DRYDOCK_SETTING(float, DepthOfFieldVignetteSize, 200.0f, Between(0, 100000), "%", "Lens|Mobile Depth of Field", Lerp, "Size of a round area without blur, of the view.")

// Motion blur
DRYDOCK_SETTING(float, MotionBlurAmount, 0.5f, Between(0, 1), "frames", "Motion Blur", Lerp, "Exposure time; 0 switches the effect off.")
DRYDOCK_SETTING(float, MotionBlurMax, 5.0f, Between(0, 100), "% of the view's width", "Motion Blur", Lerp, "Longest blur.")
DRYDOCK_SETTING(int32, MotionBlurTargetFPS, 30, Between(0, 120), "1/s", "Motion Blur", Set, "Rate of frames that the amount refers to; 0: the actual one.")
DRYDOCK_SETTING(float, MotionBlurPerObjectSize, 0.0f, Between(0, 100), "% of the view's width", "Motion Blur", Lerp, "Smallest object on the screen that has velocities of its own.")

// Ambient cubemap: every volume adds its own (the engine has no override bit for the texture)
DRYDOCK_SETTING(FLinearColor, AmbientCubemapTint, FLinearColor(1.0f, 1.0f, 1.0f, 1.0f), Anything, "", "Rendering Features|Ambient Cubemap", Accumulate, "Colour of the cubemap.")
DRYDOCK_SETTING(float, AmbientCubemapIntensity, 1.0f, AtLeast(0, 4), "", "Rendering Features|Ambient Cubemap", Accumulate, "Brightness of the cubemap; its override bit lets the cubemap in.")
DRYDOCK_SETTING(TObjectPtr<UTextureCube>, AmbientCubemap, nullptr, Anything, "", "Rendering Features|Ambient Cubemap", Accumulate, "Cubemap that lights the scene without shadows.")

// Ambient occlusion
DRYDOCK_SETTING(float, AmbientOcclusionIntensity, 0.5f, Between(0, 1), "", "Rendering Features|Ambient Occlusion", Lerp, "Darkening of corners; 0 switches it off.")
DRYDOCK_SETTING(float, AmbientOcclusionStaticFraction, 1.0f, Between(0, 1), "", "Rendering Features|Ambient Occlusion", Lerp, "Share of it on baked lighting.")
DRYDOCK_SETTING(float, AmbientOcclusionRadius, 200.0f, Between(0.1, 500), "cm", "Rendering Features|Ambient Occlusion", Lerp, "Distance at which surfaces shade each other.")
DRYDOCK_SETTING(bool, AmbientOcclusionRadiusInWS, false, Anything, "", "Rendering Features|Ambient Occlusion", Set, "Radius in the world, or in the view at a distance of 400 cm.")
DRYDOCK_SETTING(float, AmbientOcclusionFadeDistance, 8000.0f, Slider(0, 20000), "cm", "Rendering Features|Ambient Occlusion", Lerp, "Distance at which the effect has gone.")
DRYDOCK_SETTING(float, AmbientOcclusionFadeRadius, 5000.0f, Slider(0, 20000), "cm", "Rendering Features|Ambient Occlusion", Lerp, "Distance before it over which the effect goes.")
DRYDOCK_SETTING(float, AmbientOcclusionPower, 2.0f, Between(0.1, 8), "", "Rendering Features|Ambient Occlusion", Lerp, "Power of the darkening.")
DRYDOCK_SETTING(float, AmbientOcclusionBias, 3.0f, Between(0, 10), "cm", "Rendering Features|Ambient Occlusion", Lerp, "Depth that does not count, against self shading.")
DRYDOCK_SETTING(float, AmbientOcclusionQuality, 50.0f, Between(0, 100), "%", "Rendering Features|Ambient Occlusion", Lerp, "Number of samples, with steps.")
DRYDOCK_SETTING(float, AmbientOcclusionMipBlend, 0.6f, Between(0.1, 1), "", "Rendering Features|Ambient Occlusion", Lerp, "Share of the next coarser level.")
DRYDOCK_SETTING(float, AmbientOcclusionMipScale, 1.7f, Between(0.5, 4), "", "Rendering Features|Ambient Occlusion", Lerp, "Factor of the radius from level to level.")
DRYDOCK_SETTING(float, AmbientOcclusionMipThreshold, 0.01f, Between(0, 0.1), "", "Rendering Features|Ambient Occlusion", Lerp, "Difference of depth at which levels are kept apart.")
DRYDOCK_SETTING(float, AmbientOcclusionTemporalBlendWeight, 0.1f, Between(0, 0.5), "", "Rendering Features|Ambient Occlusion", Lerp, "Share of the new frame in the history; 0: no history.")
DRYDOCK_SETTING(bool, RayTracingAO, false, Anything, "", "Rendering Features|Ray Tracing Ambient Occlusion", Set, "Ambient occlusion by rays.")
DRYDOCK_SETTING(int32, RayTracingAOSamplesPerPixel, 1, Between(1, 65536), "", "Rendering Features|Ray Tracing Ambient Occlusion", Set, "Rays per pixel.")
DRYDOCK_SETTING(float, RayTracingAOIntensity, 1.0f, Between(0, 1), "", "Rendering Features|Ray Tracing Ambient Occlusion", Set, "Strength of it.")
DRYDOCK_SETTING(float, RayTracingAORadius, 200.0f, Between(0, 10000), "cm", "Rendering Features|Ray Tracing Ambient Occlusion", Set, "Length of the rays.")

// Global illumination and reflections: read, kept and blended; no pass here traces them
DRYDOCK_SETTING(EDynamicGlobalIlluminationMethod::Type, DynamicGlobalIlluminationMethod, EDynamicGlobalIlluminationMethod::Lumen, Anything, "", "Global Illumination", Set, "How indirect light is found.")
DRYDOCK_SETTING(FLinearColor, IndirectLightingColor, FLinearColor(1.0f, 1.0f, 1.0f, 1.0f), Anything, "", "Global Illumination", Lerp, "Colour of indirect light.")
DRYDOCK_SETTING(float, IndirectLightingIntensity, 1.0f, AtLeast(0, 4), "", "Global Illumination", Lerp, "Strength of indirect light.")
DRYDOCK_SETTING(ELumenRayLightingModeOverride, LumenRayLightingMode, ELumenRayLightingModeOverride::Default, Anything, "", "Global Illumination|Lumen Global Illumination", Set, "How a hit is lit; Default: as the project says.")
DRYDOCK_SETTING(float, LumenSceneLightingQuality, 1.0f, Between(0.25, 2), "", "Global Illumination|Lumen Global Illumination", Set, "Fidelity of the lit scene. (rule of the fact sheet: all of Lumen is set, not blended).")
DRYDOCK_SETTING(float, LumenSceneDetail, 1.0f, Between(0.25, 4), "", "Global Illumination|Lumen Global Illumination", Set, "Size of instances that are in the scene: larger lets smaller ones in.")
DRYDOCK_SETTING(float, LumenSceneViewDistance, 20000.0f, AtLeast(1, 2097152), "cm", "Global Illumination|Lumen Global Illumination", Set, "Greatest distance of the scene from the camera.")
DRYDOCK_SETTING(float, LumenSceneLightingUpdateSpeed, 1.0f, Between(0.5, 4), "", "Global Illumination|Lumen Global Illumination", Set, "How soon the scene follows a change of light.")
DRYDOCK_SETTING(float, LumenFinalGatherQuality, 1.0f, Between(0.25, 2), "", "Global Illumination|Lumen Global Illumination", Set, "Fidelity of the final gather.")
DRYDOCK_SETTING(float, LumenFinalGatherLightingUpdateSpeed, 1.0f, AtLeast(0.5, 4), "", "Global Illumination|Lumen Global Illumination", Set, "How soon the final gather follows a change of light.")
DRYDOCK_SETTING(bool, LumenFinalGatherScreenTraces, true, Anything, "", "Global Illumination|Lumen Global Illumination", Set, "Traces the screen before the scene.")
DRYDOCK_SETTING(float, LumenMaxTraceDistance, 20000.0f, AtLeast(1, 2097152), "cm", "Global Illumination|Lumen Global Illumination", Set, "Longest ray.")
DRYDOCK_SETTING(float, LumenDiffuseColorBoost, 1.0f, Between(1, 4), "", "Global Illumination|Lumen Global Illumination", Set, "Brightens the diffuse colour that light bounces from.")
DRYDOCK_SETTING(float, LumenSkylightLeaking, 0.0f, Between(0, 0.02), "", "Global Illumination|Lumen Global Illumination", Set, "Share of the sky light that leaks in, so that interiors are not black.")
DRYDOCK_SETTING(FLinearColor, LumenSkylightLeakingTint, FLinearColor(1.0f, 1.0f, 1.0f, 1.0f), Anything, "", "Global Illumination|Lumen Global Illumination", Set, "Colour of the leaking, since 5.6 (rule: drydock).")
DRYDOCK_SETTING(float, LumenFullSkylightLeakingDistance, 1000.0f, AtLeast(0.1, 2000), "cm", "Global Illumination|Lumen Global Illumination", Set, "Distance at which all of it leaks.")
DRYDOCK_SETTING(float, LumenSurfaceCacheResolution, 1.0f, Between(0.5, 1), "", "Global Illumination|Lumen Global Illumination", Set, "Resolution of the surface cache.")
DRYDOCK_SETTING(EReflectionMethod::Type, ReflectionMethod, EReflectionMethod::Lumen, Anything, "", "Reflections", Set, "How reflections are found.")
DRYDOCK_SETTING(float, LumenReflectionQuality, 1.0f, Between(0.25, 2), "", "Reflections|Lumen Reflections", Set, "Fidelity of the reflections.")
DRYDOCK_SETTING(bool, LumenReflectionsScreenTraces, true, Anything, "", "Reflections|Lumen Reflections", Set, "Traces the screen before the scene.")
DRYDOCK_SETTING(bool, LumenFrontLayerTranslucencyReflections, false, Anything, "", "Reflections|Lumen Reflections", Set, "Mirror reflections on the frontmost translucent surface.")
DRYDOCK_SETTING(float, LumenMaxRoughnessToTraceReflections, 0.4f, Between(0, 1), "", "Reflections|Lumen Reflections", Set, "Rougher surfaces reuse the diffuse rays.")
DRYDOCK_SETTING(int32, LumenMaxReflectionBounces, 1, Between(1, 64), "", "Reflections|Lumen Reflections", Set, "Bounces of a reflection.")
DRYDOCK_SETTING(int32, LumenMaxRefractionBounces, 0, Between(0, 64), "", "Reflections|Lumen Reflections", Set, "Bounces of a refraction.")
DRYDOCK_SETTING(float, ScreenSpaceReflectionIntensity, 100.0f, Between(0, 100), "%", "Reflections|Screen Space Reflections", Lerp, "Strength of the reflections.")
DRYDOCK_SETTING(float, ScreenSpaceReflectionQuality, 50.0f, Between(0, 100), "%", "Reflections|Screen Space Reflections", Lerp, "Number of samples, with steps.")
DRYDOCK_SETTING(float, ScreenSpaceReflectionMaxRoughness, 0.6f, Between(0.01, 1), "", "Reflections|Screen Space Reflections", Lerp, "Rougher surfaces have none.")
DRYDOCK_SETTING(float, ScreenSpaceReflectionRoughnessScale, 1.0f, Anything, "", "Reflections|Screen Space Reflections", Lerp, "Only its override bit is left in the engine; default and rule: drydock.")
DRYDOCK_SETTING(bool, bMegaLights, true, Anything, "", "Rendering Features|MegaLights", Set, "Many lights by sampling, since 5.5.")

// Ray-traced reflections, translucency and illumination
DRYDOCK_SETTING(float, RayTracingReflectionsMaxRoughness, 0.6f, Between(0.01, 1), "", "Rendering Features|Ray Tracing Reflections", Set, "Rougher surfaces have none. Only its override bit is left in 5.4; default: drydock.")
DRYDOCK_SETTING(int32, RayTracingReflectionsMaxBounces, 1, Between(0, 50), "", "Rendering Features|Ray Tracing Reflections", Set, "Bounces of a reflection. Only its override bit is left in 5.4; default: drydock.")
DRYDOCK_SETTING(int32, RayTracingReflectionsSamplesPerPixel, 1, Between(1, 65536), "", "Rendering Features|Ray Tracing Reflections", Set, "Rays per pixel. Only its override bit is left in 5.4; default: drydock.")
DRYDOCK_SETTING(EReflectedAndRefractedRayTracedShadows, RayTracingReflectionsShadows, EReflectedAndRefractedRayTracedShadows::Hard_shadows, Anything, "", "Rendering Features|Ray Tracing Reflections", Set, "Shadows in reflections. Only its override bit is left in 5.4; default: drydock.")
DRYDOCK_SETTING(bool, RayTracingReflectionsTranslucency, false, Anything, "", "Rendering Features|Ray Tracing Reflections", Set, "Translucent objects in reflections. Only its override bit is left in 5.4; default: drydock.")
DRYDOCK_SETTING(ETranslucencyType, TranslucencyType, ETranslucencyType::Raster, Anything, "", "Rendering Features|Translucency", Set, "How translucent surfaces are drawn.")
DRYDOCK_SETTING(float, RayTracingTranslucencyMaxRoughness, 0.6f, Between(0.01, 1), "", "Rendering Features|Ray Tracing Translucency", Set, "Rougher surfaces have none.")
DRYDOCK_SETTING(int32, RayTracingTranslucencyRefractionRays, 3, Between(0, 50), "", "Rendering Features|Ray Tracing Translucency", Set, "Refraction rays per pixel.")
DRYDOCK_SETTING(int32, RayTracingTranslucencySamplesPerPixel, 1, Between(1, 65536), "", "Rendering Features|Ray Tracing Translucency", Set, "Rays per pixel.")
DRYDOCK_SETTING(int32, RayTracingTranslucencyMaxPrimaryHitEvents, 4, AtLeast(0, 16), "", "Rendering Features|Ray Tracing Translucency", Set, "Hits along a primary ray, since 5.5 (range: drydock).")
DRYDOCK_SETTING(int32, RayTracingTranslucencyMaxSecondaryHitEvents, 2, AtLeast(0, 16), "", "Rendering Features|Ray Tracing Translucency", Set, "Hits along a secondary ray, since 5.5 (range: drydock).")
DRYDOCK_SETTING(EReflectedAndRefractedRayTracedShadows, RayTracingTranslucencyShadows, EReflectedAndRefractedRayTracedShadows::Hard_shadows, Anything, "", "Rendering Features|Ray Tracing Translucency", Set, "Shadows in what is seen through.")
DRYDOCK_SETTING(bool, RayTracingTranslucencyRefraction, true, Anything, "", "Rendering Features|Ray Tracing Translucency", Set, "Bends rays.")
DRYDOCK_SETTING(bool, RayTracingGI, false, Anything, "", "Rendering Features|Ray Tracing Global Illumination", Set, "Illumination by rays. Only its override bit is left in 5.4; type and default: drydock.")
DRYDOCK_SETTING(int32, RayTracingGIMaxBounces, 1, Between(0, 50), "", "Rendering Features|Ray Tracing Global Illumination", Set, "Bounces of light.")
DRYDOCK_SETTING(int32, RayTracingGISamplesPerPixel, 4, Between(1, 65536), "", "Rendering Features|Ray Tracing Global Illumination", Set, "Rays per pixel.")

// Path tracing
DRYDOCK_SETTING(int32, PathTracingMaxBounces, 32, Between(0, 100), "", "Path Tracing", Set, "Bounces of a path.")
DRYDOCK_SETTING(int32, PathTracingSamplesPerPixel, 2048, Between(1, 65536), "", "Path Tracing", Set, "Samples per pixel.")
DRYDOCK_SETTING(float, PathTracingMaxPathIntensity, 24.0f, Between(1, 65504), "luminance", "Path Tracing", Set, "Limit of a sample, against fireflies.")
DRYDOCK_SETTING(bool, PathTracingEnableEmissiveMaterials, true, Anything, "", "Path Tracing", Set, "Emissive surfaces light the scene.")
DRYDOCK_SETTING(bool, PathTracingEnableReferenceDOF, false, Anything, "", "Path Tracing", Set, "Depth of field by rays.")
DRYDOCK_SETTING(bool, PathTracingEnableReferenceAtmosphere, false, Anything, "", "Path Tracing", Set, "Sky atmosphere by rays.")
DRYDOCK_SETTING(bool, PathTracingEnableDenoiser, true, Anything, "", "Path Tracing", Set, "Denoises the last sample.")
DRYDOCK_SETTING(bool, PathTracingIncludeEmissive, true, Anything, "", "Path Tracing", Set, "Keeps what is seen directly of emissive surfaces.")
DRYDOCK_SETTING(bool, PathTracingIncludeDiffuse, true, Anything, "", "Path Tracing", Set, "Keeps direct diffuse light.")
DRYDOCK_SETTING(bool, PathTracingIncludeIndirectDiffuse, true, Anything, "", "Path Tracing", Set, "Keeps indirect diffuse light.")
DRYDOCK_SETTING(bool, PathTracingIncludeSpecular, true, Anything, "", "Path Tracing", Set, "Keeps direct specular light.")
DRYDOCK_SETTING(bool, PathTracingIncludeIndirectSpecular, true, Anything, "", "Path Tracing", Set, "Keeps indirect specular light.")
DRYDOCK_SETTING(bool, PathTracingIncludeVolume, true, Anything, "", "Path Tracing", Set, "Keeps direct light of volumes.")
DRYDOCK_SETTING(bool, PathTracingIncludeIndirectVolume, true, Anything, "", "Path Tracing", Set, "Keeps indirect light of volumes.")
DRYDOCK_SETTING(int32, UserFlags, 0, Anything, "", "Rendering Features|PostProcess Materials", Set, "Bits that post-process materials can read.")

// The project's own, all drydock: the effects of the five articles
DRYDOCK_SETTING(float, BloomToonIntensity, 0.675f, AtLeast(0, 8), "", "Lens|Bloom", Lerp, "drydock: multiplies what toon-shaded pixels give to the bloom.")
DRYDOCK_SETTING(float, ToonShadowBlurIntensity, 0.0f, Between(0, 1), "", "Toon|Shadow Blur", Lerp, "drydock: strength of the blurred shadow in lighting; 0 switches the effect off.")
DRYDOCK_SETTING(float, ToonShadowBlurSizeScale, 4.0f, AtLeast(0, 64), "", "Toon|Shadow Blur", Lerp, "drydock: multiplies all sizes.")
DRYDOCK_SETTING(int32, ToonShadowBlurQuality, 5, Between(1, 5), "", "Toon|Shadow Blur", Set, "drydock: number of stages as r.BloomQuality: 3, 3, 4, 5, 6.")
DRYDOCK_SETTING(float, ToonShadowBlur1Size, 0.3f, AtLeast(0, 4), "% of the view's width", "Toon|Shadow Blur", Lerp, "drydock: diameter of the narrowest Gaussian.")
DRYDOCK_SETTING(float, ToonShadowBlur2Size, 1.0f, AtLeast(0, 8), "% of the view's width", "Toon|Shadow Blur", Lerp, "drydock: diameter of the second Gaussian.")
DRYDOCK_SETTING(float, ToonShadowBlur3Size, 2.0f, AtLeast(0, 16), "% of the view's width", "Toon|Shadow Blur", Lerp, "drydock: diameter of the third Gaussian.")
DRYDOCK_SETTING(float, ToonShadowBlur4Size, 10.0f, AtLeast(0, 32), "% of the view's width", "Toon|Shadow Blur", Lerp, "drydock: diameter of the fourth Gaussian.")
DRYDOCK_SETTING(float, ToonShadowBlur5Size, 30.0f, AtLeast(0, 64), "% of the view's width", "Toon|Shadow Blur", Lerp, "drydock: diameter of the fifth Gaussian.")
DRYDOCK_SETTING(float, ToonShadowBlur6Size, 64.0f, AtLeast(0, 128), "% of the view's width", "Toon|Shadow Blur", Lerp, "drydock: diameter of the widest Gaussian.")
DRYDOCK_SETTING(FLinearColor, ToonShadowBlur1Tint, FLinearColor(0.3465f, 0.3465f, 0.3465f, 1.0f), Anything, "", "Toon|Shadow Blur", Lerp, "drydock: colour and weight of the narrowest Gaussian; weights are normalised per channel.")
DRYDOCK_SETTING(FLinearColor, ToonShadowBlur2Tint, FLinearColor(0.138f, 0.138f, 0.138f, 1.0f), Anything, "", "Toon|Shadow Blur", Lerp, "drydock: colour and weight of the second Gaussian; weights are normalised per channel.")
DRYDOCK_SETTING(FLinearColor, ToonShadowBlur3Tint, FLinearColor(0.1176f, 0.1176f, 0.1176f, 1.0f), Anything, "", "Toon|Shadow Blur", Lerp, "drydock: colour and weight of the third Gaussian; weights are normalised per channel.")
DRYDOCK_SETTING(FLinearColor, ToonShadowBlur4Tint, FLinearColor(0.066f, 0.066f, 0.066f, 1.0f), Anything, "", "Toon|Shadow Blur", Lerp, "drydock: colour and weight of the fourth Gaussian; weights are normalised per channel.")
DRYDOCK_SETTING(FLinearColor, ToonShadowBlur5Tint, FLinearColor(0.066f, 0.066f, 0.066f, 1.0f), Anything, "", "Toon|Shadow Blur", Lerp, "drydock: colour and weight of the fifth Gaussian; weights are normalised per channel.")
DRYDOCK_SETTING(FLinearColor, ToonShadowBlur6Tint, FLinearColor(0.061f, 0.061f, 0.061f, 1.0f), Anything, "", "Toon|Shadow Blur", Lerp, "drydock: colour and weight of the widest Gaussian; weights are normalised per channel.")
DRYDOCK_SETTING(EToonShadowBlurBlend, ToonShadowBlurBlend, EToonShadowBlurBlend::Screen, Anything, "", "Toon|Shadow Blur", Set, "drydock: how lighting uses the blurred shadow.")
DRYDOCK_SETTING(TObjectPtr<UTexture>, ToonShadowBlurRamp, nullptr, Anything, "", "Toon|Shadow Blur", SetIfNonZero, "drydock: with Max: picture of the light that a shadow term lets through, from dark (left) to lit (right).")
DRYDOCK_SETTING(EToonShadowBlurStore, ToonShadowBlurStore, EToonShadowBlurStore::SqrtEightBit, Anything, "", "Toon|Shadow Blur", Set, "drydock: in what the blurred shadow is computed and kept.")
DRYDOCK_SETTING(float, DiffusionFilterIntensity, 0.0f, AtLeast(0, 8), "", "RED|Diffusion Filter", Lerp, "drydock: scales the blurred part; 0 switches the filter off.")
DRYDOCK_SETTING(float, DiffusionFilterLuminancePow, 1.0f, AtLeast(0, 8), "", "RED|Diffusion Filter", Lerp, "drydock: power of the luma when bright parts are extracted.")
DRYDOCK_SETTING(float, DiffusionFilterLuminanceThreshold, 0.0f, AtLeast(0, 1), "luma", "RED|Diffusion Filter", Lerp, "drydock: taken off that power before it weighs the colour.")
DRYDOCK_SETTING(float, DiffusionFilterPower, 1.0f, AtLeast(0, 8), "", "RED|Diffusion Filter", Lerp, "drydock: power of the combined picture.")
DRYDOCK_SETTING(EDiffusionFilterBlend, DiffusionFilterBlend, EDiffusionFilterBlend::Screen, Anything, "", "RED|Diffusion Filter", Set, "drydock: how the blur meets the picture.")
DRYDOCK_SETTING(float, DiffusionFilterSepia, 0.0f, Between(0, 1), "", "RED|Diffusion Filter", Lerp, "drydock: weight of the sepia picture.")
DRYDOCK_SETTING(FLinearColor, DiffusionFilterSepiaTint, FLinearColor(1.0f, 0.82f, 0.6f, 1.0f), Anything, "", "RED|Diffusion Filter", Lerp, "drydock: colour of the sepia picture.")
DRYDOCK_SETTING(float, SoftFocusBlend, 0.0f, Between(0, 1), "", "RED|Soft Focus", Lerp, "drydock: share of the blurred picture; 0 switches it off.")
DRYDOCK_SETTING(float, SoftFocusSaturation, 1.0f, AtLeast(0, 2), "", "RED|Soft Focus", Lerp, "drydock: saturation after that; 1 leaves it as it is.")
DRYDOCK_SETTING(float, GlowIntensity, 0.0f, AtLeast(0, 8), "", "RED|Glow", Lerp, "drydock: factor of the blurred picture in the screen blend; 0 switches it off.")
DRYDOCK_SETTING(float, GlowLuminanceThreshold, -1.0f, AtLeast(-1, 1), "luma", "RED|Glow", Lerp, "drydock: taken off the luma before it weighs what glows; -1: everything glows.")
DRYDOCK_SETTING(float, CharaGlowArea, 0.0f, AtLeast(0, 16), "px", "RED|Glow", Lerp, "drydock: radius of the glow around characters; 0 switches it off.")
DRYDOCK_SETTING(FLinearColor, CharaGlowColor, FLinearColor(1.0f, 1.0f, 1.0f, 1.0f), Anything, "", "RED|Glow", Lerp, "drydock: colour of that glow; alpha is its strength.")
DRYDOCK_SETTING(float, REDDofFocalDistance, 0.0f, AtLeast(0, 10000), "cm", "RED|Depth of Field", FocalDistance, "drydock: distance in focus; 0 switches the effect off.")
DRYDOCK_SETTING(float, REDDofFocalRegion, 0.0f, AtLeast(0, 10000), "cm", "RED|Depth of Field", Lerp, "drydock: depth that is in focus behind the focal distance.")
DRYDOCK_SETTING(float, REDDofNearTransition, 300.0f, AtLeast(0, 10000), "cm", "RED|Depth of Field", Lerp, "drydock: from in focus to fully blurred, towards the camera.")
DRYDOCK_SETTING(float, REDDofFarTransition, 500.0f, AtLeast(0, 10000), "cm", "RED|Depth of Field", Lerp, "drydock: from in focus to fully blurred, away from the camera.")
DRYDOCK_SETTING(float, REDDofNearBlurSize, 1.0f, AtLeast(0, 15), "% of the view's width", "RED|Depth of Field", Lerp, "drydock: blur in front.")
DRYDOCK_SETTING(float, REDDofFarBlurSize, 1.0f, AtLeast(0, 15), "% of the view's width", "RED|Depth of Field", Lerp, "drydock: blur behind.")
DRYDOCK_SETTING(float, UnityBloomThreshold, 0.6f, AtLeast(0, 4), "luminance", "Unity|Bloom", Lerp, "drydock: taken off the luminance before it weighs the colour.")
DRYDOCK_SETTING(float, UnityBloomSoftKnee, 0.0f, Between(0, 1), "part of the threshold", "Unity|Bloom", Lerp, "drydock: light begins this far below the threshold, and softly; 0 is a sharp threshold.")
DRYDOCK_SETTING(int32, UnityBloomIterations, 3, Between(1, 8), "", "Unity|Bloom", Set, "drydock: rounds of blur.")
DRYDOCK_SETTING(float, UnityBloomSpread, 0.6f, AtLeast(0, 4), "texels", "Unity|Bloom", Lerp, "drydock: iteration i steps 1 + i times this.")
DRYDOCK_SETTING(int32, UnityBloomDownSample, 2, Between(1, 8), "", "Unity|Bloom", Set, "drydock: the blur runs at one part in this many.")
DRYDOCK_SETTING(float, UnityBloomIntensity, 0.0f, AtLeast(0, 8), "", "Unity|Bloom", Lerp, "drydock: factor of the blurred part; 0 switches the effect off.")
DRYDOCK_SETTING(float, DualKawaseBlurOffset, 1.0f, AtLeast(0, 8), "half pixels", "Dual Kawase", Lerp, "drydock: distance of the taps.")
DRYDOCK_SETTING(int32, DualKawaseBlurPassNum, 0, Between(0, 12), "", "Dual Kawase", Set, "drydock: levels down, and as many up; 0 switches the effect off.")

// Lines from outside: the test that one line is enough gives a file of its own.
#ifdef DRYDOCK_EXTRA_SETTINGS
#include DRYDOCK_EXTRA_SETTINGS
#endif

#undef DRYDOCK_SETTING_BIT

// clang-format on
