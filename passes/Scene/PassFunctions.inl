// The pass functions that an engine overlay can replace, one in a row. Headers: below the engine's Renderer/Private.
// Shaders: the main file in /Engine/Private; empty: the pass has none there. Effect: the one of the ledger that adds
// the pass. DRYDOCK_PASS_INPUTS(result, function, header, shader, effect, inputs, members): the function takes graph
// builder, view and a struct. The members are DRYDOCK_MEMBER(Name)...; they are handed over one by one, because an
// overlay's struct of that name may have others. DRYDOCK_PASS(result, scope, function, header, shader, effect,
// parameters, arguments): any other function.
// clang-format off
DRYDOCK_PASS_INPUTS(FScreenPassTexture, AddBloomSetupPass, "PostProcess/PostProcessBloomSetup.h", "PostProcessBloom.usf", "Bloom", FBloomSetupInputs,
	DRYDOCK_MEMBER(SceneColor) DRYDOCK_MEMBER(EyeAdaptationBuffer) DRYDOCK_MEMBER(Threshold) DRYDOCK_MEMBER(EyeAdaptationParameters) DRYDOCK_MEMBER(LocalExposureParameters) DRYDOCK_MEMBER(LocalExposureTexture) DRYDOCK_MEMBER(BlurredLogLuminanceTexture))
DRYDOCK_PASS_INPUTS(FFFTBloomOutput, AddFFTBloomPass, "PostProcess/PostProcessFFTBloom.h", "PostProcessFFTBloom.usf", "FFTBloom", FFFTBloomInputs,
	DRYDOCK_MEMBER(SceneColor) DRYDOCK_MEMBER(HalfResolution) DRYDOCK_MEMBER(QuarterResolution))
DRYDOCK_PASS_INPUTS(FScreenPassTexture, AddDownsamplePass, "PostProcess/PostProcessDownsample.h", "PostProcessDownsample.usf", "Bloom", FDownsamplePassInputs,
	DRYDOCK_MEMBER(Name) DRYDOCK_MEMBER(SceneColor) DRYDOCK_MEMBER(Quality) DRYDOCK_MEMBER(Flags) DRYDOCK_MEMBER(FormatOverride) DRYDOCK_MEMBER(UserSuppliedOutput))
DRYDOCK_PASS_INPUTS(FScreenPassTexture, AddGaussianBlurPass, "PostProcess/PostProcessWeightedSampleSum.h", "FilterPixelShader.usf", "Bloom", FGaussianBlurInputs,
	DRYDOCK_MEMBER(NameX) DRYDOCK_MEMBER(NameY) DRYDOCK_MEMBER(Filter) DRYDOCK_MEMBER(Additive) DRYDOCK_MEMBER(CrossCenterWeight) DRYDOCK_MEMBER(TintColor) DRYDOCK_MEMBER(KernelSizePercent) DRYDOCK_MEMBER(UseMirrorAddressMode))
DRYDOCK_PASS_INPUTS(FScreenPassTexture, AddTonemapPass, "PostProcess/PostProcessTonemap.h", "PostProcessTonemap.usf", "Tonemap", FTonemapInputs,
	DRYDOCK_MEMBER(OverrideOutput) DRYDOCK_MEMBER(SceneColor) DRYDOCK_MEMBER(Bloom) DRYDOCK_MEMBER(SceneColorApplyParamaters) DRYDOCK_MEMBER(EyeAdaptationBuffer) DRYDOCK_MEMBER(EyeAdaptationParameters) DRYDOCK_MEMBER(LocalExposureParameters) DRYDOCK_MEMBER(LocalExposureTexture) DRYDOCK_MEMBER(BlurredLogLuminanceTexture) DRYDOCK_MEMBER(ColorGradingTexture) DRYDOCK_MEMBER(bGammaOnly) DRYDOCK_MEMBER(OutputFormat) DRYDOCK_MEMBER(bWriteAlphaChannel))
DRYDOCK_PASS_INPUTS(FScreenPassTexture, AddFXAAPass, "PostProcess/PostProcessAA.h", "FXAAShader.usf", "FXAA", FFXAAInputs,
	DRYDOCK_MEMBER(OverrideOutput) DRYDOCK_MEMBER(SceneColor) DRYDOCK_MEMBER(Quality) DRYDOCK_MEMBER(bLumaInAlpha))
DRYDOCK_PASS_INPUTS(FScreenPassTexture, AddUpscalePass, "PostProcess/PostProcessUpscale.h", "PostProcessUpscale.usf", "Upscale", FUpscaleInputs,
	DRYDOCK_MEMBER(OverrideOutput) DRYDOCK_MEMBER(SceneColor) DRYDOCK_MEMBER(OutputSize) DRYDOCK_MEMBER(Method))
DRYDOCK_PASS_INPUTS(FScreenPassTexture, AddMotionBlurPass, "PostProcess/PostProcessMotionBlur.h", "PostProcessMotionBlur.usf", "MotionBlur", FMotionBlurInputs,
	DRYDOCK_MEMBER(OverrideOutput) DRYDOCK_MEMBER(SceneColor) DRYDOCK_MEMBER(SceneTextures) DRYDOCK_MEMBER(Quality) DRYDOCK_MEMBER(VelocityScale) DRYDOCK_MEMBER(MaxLength))
DRYDOCK_PASS(FScreenPassTexture, , AddGaussianBloomPasses, "PostProcess/PostProcessBloomSetup.h", "FilterPixelShader.usf", "Bloom",
	(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FTextureDownsampleChain* SceneDownsampleChain),
	(GraphBuilder, View, SceneDownsampleChain))
DRYDOCK_PASS(FRDGTextureRef, , AddHistogramPass, "PostProcess/PostProcessHistogram.h", "", "Exposure",
	(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FEyeAdaptationParameters& Parameters, FScreenPassTexture SceneColor, FRDGTextureRef MeterMask),
	(GraphBuilder, View, Parameters, SceneColor, MeterMask))
DRYDOCK_PASS(FRDGBufferRef, , AddHistogramEyeAdaptationPass, "PostProcess/PostProcessEyeAdaptation.h", "PostProcessEyeAdaptation.usf", "Exposure",
	(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FEyeAdaptationInputs& Inputs, FRDGTextureRef HistogramTexture),
	(GraphBuilder, View, Inputs, HistogramTexture))
DRYDOCK_PASS(FScreenPassTexture, , AddBasicEyeAdaptationSetupPass, "PostProcess/PostProcessEyeAdaptation.h", "PostProcessEyeAdaptation.usf", "Exposure",
	(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FEyeAdaptationParameters& Parameters, FScreenPassTexture SceneColor),
	(GraphBuilder, View, Parameters, SceneColor))
DRYDOCK_PASS(FRDGBufferRef, , AddBasicEyeAdaptationPass, "PostProcess/PostProcessEyeAdaptation.h", "PostProcessEyeAdaptation.usf", "Exposure",
	(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FEyeAdaptationInputs& Inputs, FScreenPassTexture SceneColor, FRDGTextureRef MeterMask),
	(GraphBuilder, View, Inputs, SceneColor, MeterMask))
DRYDOCK_PASS(FRDGTextureRef, , AddLocalExposurePass, "PostProcess/PostProcessLocalExposure.h", "", "LocalExposure",
	(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FEyeAdaptationParameters& EyeAdaptation, FScreenPassTexture SceneColor),
	(GraphBuilder, View, EyeAdaptation, SceneColor))
DRYDOCK_PASS(FRDGTextureRef, , AddLocalExposureBlurredLogLuminancePass, "PostProcess/PostProcessLocalExposure.h", "PostProcessLocalExposure.usf", "LocalExposure",
	(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FEyeAdaptationParameters& EyeAdaptation, FScreenPassTexture SceneColor, float KernelSizePercent),
	(GraphBuilder, View, EyeAdaptation, SceneColor, KernelSizePercent))
DRYDOCK_PASS(FRDGTextureRef, , AddCombineLUTPass, "PostProcess/PostProcessCombineLUTs.h", "", "Tonemap",
	(FRDGBuilder& GraphBuilder, const FViewInfo& View),
	(GraphBuilder, View))
DRYDOCK_PASS(FScreenPassTexture, DiaphragmDOF::, AddPasses, "PostProcess/DiaphragmDOF.h", "", "DepthOfField",
	(FRDGBuilder& GraphBuilder, const FViewInfo& View, TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures, const FScreenPassTexture& SceneColor, const DiaphragmDOF::FPhysicalCocModel& Model, const DiaphragmDOF::FBokehModel& Bokeh),
	(GraphBuilder, View, SceneTextures, SceneColor, Model, Bokeh))
DRYDOCK_PASS(FScreenPassTexture, Drydock::, AddREDPostProcessPasses, "Lens/REDPostProcess.h", "", "RED",
	(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& SceneColor, const Drydock::FREDPostProcessParameters& Parameters, const FScreenPassRenderTarget& OverrideOutput),
	(GraphBuilder, View, SceneColor, Parameters, OverrideOutput))
// clang-format on
