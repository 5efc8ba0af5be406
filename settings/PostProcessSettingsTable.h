// The one list of post-process settings. Members, override bits, reflection, blending, JSON, `--pp`, the config schema
// and `drydock list settings` all come from here: adding a setting is one line. Included several times, hence no guard;
// each time DRYDOCK_SETTING says what becomes of a line.
//
//   DRYDOCK_SETTING(Type, Name, Default, Range, Unit, Category, Blend, Doc)
//
// Type      float, bool, int32, an enum of PostProcessSettings.h, FLinearColor, FVector2D or FVector4
// Range     Anything, AtLeast(ClampMin, UIMax) or Between(ClampMin, ClampMax); the engine does not enforce it at run
// time Unit      of the value, "" where it has none Category  as in the editor, levels separated by | Blend     what a
// volume of some weight does with it: ESettingBlend Defaults and ranges: engine FPostProcessSettings 5.3/5.4, except
// where the line says "drydock".

// clang-format off

// Film
DRYDOCK_SETTING(float, FilmSlope, 0.88f, Between(0, 1), "", "Film", Lerp, "Steepness of the film curve: larger darkens shadows and brightens highlights.")
DRYDOCK_SETTING(float, FilmToe, 0.55f, Between(0, 1), "", "Film", Lerp, "Dark end of the film curve: larger gives darker darks.")
DRYDOCK_SETTING(float, FilmShoulder, 0.26f, Between(0, 1), "", "Film", Lerp, "Bright end of the film curve: larger compresses highlights more.")
DRYDOCK_SETTING(float, FilmBlackClip, 0.0f, Between(0, 1), "", "Film", Lerp, "Where the darkest end is cut off, in output.")
DRYDOCK_SETTING(float, FilmWhiteClip, 0.04f, Between(0, 1), "", "Film", Lerp, "How far the curve may pass white before it is cut off, in output.")

// Colour correction that the tonemapper carries
DRYDOCK_SETTING(float, BlueCorrection, 0.6f, Between(0, 1), "", "Color Grading|Misc", Lerp, "Corrects bright blue lights that turn violet in AP1.")
DRYDOCK_SETTING(float, ExpandGamut, 1.0f, Between(0, 1), "", "Color Grading|Misc", Lerp, "Expands bright saturated colours outside the sRGB gamut, to fake wide-gamut rendering.")
DRYDOCK_SETTING(float, ToneCurveAmount, 1.0f, Between(0, 1), "", "Color Grading|Misc", Lerp, "How much of the film curve is applied: 0 none, 1 all.")
DRYDOCK_SETTING(FLinearColor, SceneColorTint, FLinearColor(1.0f, 1.0f, 1.0f, 1.0f), Anything, "", "Color Grading|Misc", Lerp, "Multiplies the scene colour, not the bloom.")

// Lens
DRYDOCK_SETTING(float, SceneFringeIntensity, 0.0f, AtLeast(0, 5), "%", "Lens|Chromatic Aberration", Lerp, "Shift of red and green against blue at the edge of the picture.")
DRYDOCK_SETTING(float, ChromaticAberrationStartOffset, 0.0f, Between(0, 1), "", "Lens|Chromatic Aberration", Lerp, "Distance from the centre at which the effect begins.")
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
DRYDOCK_SETTING(float, BloomToonIntensity, 0.675f, AtLeast(0, 8), "", "Lens|Bloom", Lerp, "drydock: multiplies what toon-shaded pixels give to the bloom.")
DRYDOCK_SETTING(float, BloomConvolutionScatterDispersion, 1.0f, AtLeast(0, 20), "", "Lens|Bloom", Lerp, "BM_FFT: energy moved from the kernel's centre outwards.")
DRYDOCK_SETTING(float, BloomConvolutionSize, 1.0f, Between(0, 1), "of the view", "Lens|Bloom", Lerp, "BM_FFT: size of the kernel picture.")
DRYDOCK_SETTING(FVector2D, BloomConvolutionCenterUV, FVector2D(0.5, 0.5), Anything, "UV", "Lens|Bloom", Lerp, "BM_FFT: centre of the kernel picture.")
DRYDOCK_SETTING(float, BloomConvolutionPreFilterMin, 7.0f, AtLeast(0, 1000), "luminance", "Lens|Bloom", Lerp, "BM_FFT: boost pixels above this.")
DRYDOCK_SETTING(float, BloomConvolutionPreFilterMax, 15000.0f, AtLeast(0, 15000), "luminance", "Lens|Bloom", Lerp, "BM_FFT: boost pixels below this.")
DRYDOCK_SETTING(float, BloomConvolutionPreFilterMult, 15.0f, AtLeast(0, 1000), "", "Lens|Bloom", Lerp, "BM_FFT: strength of the boost.")
DRYDOCK_SETTING(float, BloomConvolutionBufferScale, 0.133f, Between(0, 1), "of the view", "Lens|Bloom", SetIfNonZero, "BM_FFT: border added around the picture before the convolution.")
DRYDOCK_SETTING(float, BloomDirtMaskIntensity, 0.0f, AtLeast(0, 8), "", "Lens|Dirt Mask", Lerp, "Strength of the dirt mask on the bloom.")
DRYDOCK_SETTING(FLinearColor, BloomDirtMaskTint, FLinearColor(0.5f, 0.5f, 0.5f, 1.0f), Anything, "", "Lens|Dirt Mask", Lerp, "Colour of the dirt mask.")
DRYDOCK_SETTING(float, VignetteIntensity, 0.4f, Between(0, 1), "", "Lens|Image Effects", Lerp, "Darkening of the picture's corners.")

// Exposure
DRYDOCK_SETTING(EAutoExposureMethod, AutoExposureMethod, AEM_Histogram, Anything, "", "Lens|Exposure", Set, "How the exposure is found: AEM_Histogram, AEM_Basic, AEM_Manual.")
DRYDOCK_SETTING(float, AutoExposureBias, 1.0f, Anything, "EV", "Lens|Exposure", Lerp, "Exposure compensation; one more doubles the brightness.")
DRYDOCK_SETTING(bool, AutoExposureApplyPhysicalCameraExposure, true, Anything, "", "Lens|Exposure", Set, "AEM_Manual: exposure from shutter speed, ISO and f-stop.")
DRYDOCK_SETTING(float, AutoExposureMinBrightness, 0.03f, Anything, "luminance", "Lens|Exposure", Lerp, "Least brightness the eye adapts to.")
DRYDOCK_SETTING(float, AutoExposureMaxBrightness, 8.0f, Anything, "luminance", "Lens|Exposure", Lerp, "Greatest brightness the eye adapts to.")
DRYDOCK_SETTING(float, AutoExposureSpeedUp, 3.0f, AtLeast(0.02, 20), "EV per second", "Lens|Exposure", Lerp, "Speed of adaptation from dark to bright.")
DRYDOCK_SETTING(float, AutoExposureSpeedDown, 1.0f, AtLeast(0.02, 20), "EV per second", "Lens|Exposure", Lerp, "Speed of adaptation from bright to dark.")
DRYDOCK_SETTING(float, AutoExposureLowPercent, 10.0f, Between(0, 100), "%", "Lens|Exposure", Lerp, "AEM_Histogram: share of dark pixels left out.")
DRYDOCK_SETTING(float, AutoExposureHighPercent, 90.0f, Between(0, 100), "%", "Lens|Exposure", Lerp, "AEM_Histogram: pixels above this share are left out.")
DRYDOCK_SETTING(float, HistogramLogMin, -8.0f, Anything, "log2 luminance", "Lens|Exposure", Lerp, "AEM_Histogram: lower end.")
DRYDOCK_SETTING(float, HistogramLogMax, 4.0f, Anything, "log2 luminance", "Lens|Exposure", Lerp, "AEM_Histogram: upper end.")
DRYDOCK_SETTING(float, CameraShutterSpeed, 60.0f, AtLeast(1, 2000), "1/s", "Lens|Camera", Lerp, "Shutter speed, as the denominator of a second.")
DRYDOCK_SETTING(float, CameraISO, 100.0f, AtLeast(1, 51200), "ISO", "Lens|Camera", Lerp, "Sensitivity of the sensor.")

// clang-format on
