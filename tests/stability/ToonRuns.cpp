// How the toon-shadow blur's rows are run, and their formulas.
#include "Runs.h"

#include "Cases.h"

#include "Screen/TextureAssets.h"
#include "Toon/ToonShadowBlur.h"

#include <algorithm>
#include <vector>

using namespace Drydock;

namespace Stability
{

namespace
{

constexpr double PlainShadow = 0.4;   // of R; multiples of 1/5 are multiples of 1/255
constexpr double BlurredShadow = 0.6; // of A

/** The picture is the shadow buffer, and the result A in every channel, decoded. */
template<bool bAsPrinted>
FImage RunToonShadowBlur(const FCase& Case)
{
	FCase Stored = Case;
	Stored.Format = PF_R8G8B8A8;
	FFrameRun Run(Stored);
	constexpr EToonShadowBlurStore Store = EToonShadowBlurStore::SqrtEightBit;
	FFinalPostProcessSettings Settings;
	Settings.ToonShadowBlurStore = Store;
	FToonShadowBlurInputs Inputs = FToonShadowBlurInputs::FromSettings(Settings, Run.Input);
	Inputs.bAsPrinted = bAsPrinted;
	for (FGaussianSumStage& Stage : Inputs.Blur.Stages)
	{
		Stage.Size = Case.Sigma ? static_cast<float>(*Case.Sigma) : Stage.Size;
	}
	const FImage Result = Run.Execute(AddToonShadowBlurPasses(Run.GraphBuilder, Run.View, Inputs));
	return FImage::Make(Result.Width, Result.Height,
		[&](int X, int Y)
		{
			const double Blurred = Drydock::DecodeToonShadowBlur(static_cast<float>(Result.At(X, Y)[3]), Store);
			return FTexel{Blurred, Blurred, Blurred, 1};
		});
}

enum ELightingVariant
{
	Screen,
	Max,
	Add,
	MaxWithRamp,
};

/** As many shades as 8 bits have: a shadow term is its own light. */
FTextureRHIRef MakeStraightRamp()
{
	std::vector<FLinearColor> Colors;
	for (int Shade = 0; Shade < 256; ++Shade)
	{
		const float Value = static_cast<float>(Shade) / 255.0f;
		Colors.push_back(FLinearColor(Value, Value, Value, 1.0f));
	}
	return MakePictureTexture(FIntPoint(256, 1), Colors, "Ramp");
}

/** The picture is lit scene colour; the shadow is 0.4, blurred 0.6. */
template<bool bAsPrinted>
FImage RunToonShadowLighting(const FCase& Case)
{
	FFrameRun Run(Case);
	FToonShadowLightingInputs Inputs;
	Inputs.SceneTextures = Run.GetSceneTextures();
	Inputs.SceneColor = Run.Input;
	Inputs.ToonShadow = Run.AddInput(FImage(Case.Image.Width, Case.Image.Height, {PlainShadow, 1, 0, BlurredShadow}),
		PF_R8G8B8A8, TEXT("ToonShadow"));
	Inputs.Intensity = static_cast<float>(Case.Intensity.value_or(1.0));
	Inputs.Blend = Case.Variant == Screen ? EToonShadowBlurBlend::Screen
				   : Case.Variant == Add  ? EToonShadowBlurBlend::Add
										  : EToonShadowBlurBlend::Max;
	Inputs.Ramp = Case.Variant == MaxWithRamp ? MakeStraightRamp() : nullptr;
	Inputs.Store = EToonShadowBlurStore::SixteenBit;
	Inputs.bAsPrinted = bAsPrinted;
	return Run.Execute(AddToonShadowLightingPass(Run.GraphBuilder, Run.View, Inputs));
}

/** The formula for a flat picture. */
FImage ToonShadowBlurFormula(const FCase& Case)
{
	const FTexel& Flat = Case.Image.At(0, 0);
	const double Shadow = Case.Sigma == 0.0 ? 1.0 : std::min(Flat[0], Flat[1]);
	return FImage(Case.Image.Width, Case.Image.Height, {Shadow, Shadow, Shadow, 1});
}

/** White light on a white base. */
FImage ToonShadowLightingFormula(const FCase& Case)
{
	const double Intensity = Case.Intensity.value_or(1.0);
	return FImage::Make(Case.Image.Width, Case.Image.Height,
		[&](int X, int Y)
		{
			FTexel Color = Case.Image.At(X, Y);
			for (int Channel = 0; Channel < 3 && FFrameRun::IsCloth(X); ++Channel)
			{
				double& Value = Color[Channel];
				if (Case.Variant != Screen)
				{
					const double Light =
						(Case.Variant == Add ? BlurredShadow : BlurredShadow - PlainShadow) * Intensity;
					Value += Case.Variant == MaxWithRamp ? std::max(Light, -std::max(Value, 0.0)) : Light;
					continue;
				}
				const double Lit = std::max(Value, 0.0), Light = std::max(BlurredShadow * Intensity, 0.0);
				Value = 1 - (1 - std::min(Lit, 1.0)) * (1 - std::min(Light, 1.0)) + std::max(Lit - 1, 0.0) +
						std::max(Light - 1, 0.0);
			}
			return Color;
		});
}

const FRunRegistration ToonRuns({
	{"Toon-shadow blur", {.Run = RunToonShadowBlur<false>, .Formula = ToonShadowBlurFormula}},
	{"Toon-shadow blur as printed", {.Run = RunToonShadowBlur<true>, .Formula = ToonShadowBlurFormula}},
	{"Toon-shadow lighting",
		{.Run = RunToonShadowLighting<false>, .Formula = ToonShadowLightingFormula, .NumVariants = 4}},
	{"Toon-shadow lighting as printed", {.Run = RunToonShadowLighting<true>, .NumVariants = 2}},
});

} // namespace

} // namespace Stability
