// Classes and functions of the plugin's own, in the global namespace, under the names that the articles use for theirs
// and that drydock has for its versions of them. Layouts and results are others than drydock's.
#pragma once

#include "CoreMinimal.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

/** A class that says 1 when it is the one defined here, with more in it than drydock's of that name. */
#define SAME_NAMES_CLASS(Name) \
	class Name \
	{ \
	public: \
		Name(); \
		virtual ~Name(); \
		virtual int32 GetOwn() const; \
		double Padding[64] = {}; \
	};

// clang-format off
#define SAME_NAMES_ALL_CLASSES(Do) \
	Do(FCharaGlowInputs) Do(FCharaGlowBoxPS) Do(FDualKawaseBlurInputs) Do(FDualKawaseGaussianInputs) \
	Do(FDualKawaseSetting) Do(FGaussianBlurPassesInputs) Do(FGaussianBlurStage) Do(FREDDepthOfFieldInputs) \
	Do(FREDPostProcessParameters) Do(FREDPostProcessPassInputs) Do(FREDPostProcessPS) Do(FTintInputs) \
	Do(FToonBloomInputs) Do(FToonShadowBlurInputs) Do(FToonShadowLightingInputs) Do(FUnityBloomInputs) \
	Do(FUnityBloomPassInputs)
// clang-format on

SAME_NAMES_ALL_CLASSES(SAME_NAMES_CLASS)

/** Passes with drydock's arguments: they say 1 as well, and add nothing. */
#define SAME_NAMES_PASS(Name, Inputs) int32 Name(FRDGBuilder& GraphBuilder, const FViewInfo& View, const Inputs& In);

// clang-format off
#define SAME_NAMES_ALL_PASSES(Do) \
	Do(AddCharaGlow, FCharaGlowInputs) Do(AddCharaGlowPasses, FCharaGlowInputs) \
	Do(AddDualKawaseBlurPass, FDualKawaseBlurInputs) Do(AddDualKawaseGaussianPass, FDualKawaseGaussianInputs) \
	Do(AddREDDepthOfFieldPasses, FREDDepthOfFieldInputs) Do(AddREDPostProcessPass, FREDPostProcessPassInputs) \
	Do(AddTintPass, FTintInputs) Do(AddToonBloomVisualizePass, FToonBloomInputs) \
	Do(AddToonShadowBlurPasses, FToonShadowBlurInputs) \
	Do(AddToonShadowLightingPass, FToonShadowLightingInputs) \
	Do(AddUnityBloomPass, FUnityBloomPassInputs) Do(AddUnityBloomPasses, FUnityBloomInputs)
// clang-format on

SAME_NAMES_ALL_PASSES(SAME_NAMES_PASS)

/** Questions without arguments. */
#define SAME_NAMES_QUESTION(Name) int32 Name();

// clang-format off
#define SAME_NAMES_ALL_QUESTIONS(Do) \
	Do(GetREDPostProcessInsertion) Do(GetToonBloomMode) Do(IsDualKawaseAsPrinted) Do(IsEyeAdaptationAllowed) \
	Do(IsToonBloomAsPrinted) Do(IsToonBloomMaskVisualized) Do(IsUnityBloomAfterTonemap)
// clang-format on

SAME_NAMES_ALL_QUESTIONS(SAME_NAMES_QUESTION)
