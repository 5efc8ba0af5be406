// The passes of the toon-shadow blur that a config can insert by name, one by one.
#include "Bloom/PostProcessGaussianBloom.h"
#include "PassFactory.h"
#include "Screen/TextureAssets.h"
#include "Toon/ToonShadowBlur.h"

namespace Drydock
{

namespace
{

const FParameterSpec GStore = FParameterSpec::Text("Store", "SqrtEightBit", {"EightBit", "SixteenBit", "SqrtEightBit"},
	"How A keeps the blurred shadow: as it is, or as its square root.");

EToonShadowBlurStore GetStore(const FParameterValues& Values)
{
	const std::string& Store = Values.GetText("Store");
	return Store == "EightBit"     ? EToonShadowBlurStore::EightBit
		   : Store == "SixteenBit" ? EToonShadowBlurStore::SixteenBit
								   : EToonShadowBlurStore::SqrtEightBit;
}

EToonShadowBlurBlend GetBlend(const FParameterValues& Values)
{
	const std::string& Blend = Values.GetText("Blend");
	return Blend == "Max"   ? EToonShadowBlurBlend::Max
		   : Blend == "Add" ? EToonShadowBlurBlend::Add
							: EToonShadowBlurBlend::Screen;
}

constexpr int32 NumStages = 6;
constexpr const TCHAR* StageNamesX[NumStages] = {TEXT("TextureBlur1X"), TEXT("TextureBlur2X"), TEXT("TextureBlur3X"),
	TEXT("TextureBlur4X"), TEXT("TextureBlur5X"), TEXT("TextureBlur6X")};
constexpr const TCHAR* StageNamesY[NumStages] = {TEXT("TextureBlur1Y"), TEXT("TextureBlur2Y"), TEXT("TextureBlur3Y"),
	TEXT("TextureBlur4Y"), TEXT("TextureBlur5Y"), TEXT("TextureBlur6Y")};

std::vector<FParameterSpec> MakeTextureBlurParameters()
{
	const FPostProcessSettings Defaults;
	const float Sizes[NumStages] = {Defaults.ToonShadowBlur1Size, Defaults.ToonShadowBlur2Size,
		Defaults.ToonShadowBlur3Size, Defaults.ToonShadowBlur4Size, Defaults.ToonShadowBlur5Size,
		Defaults.ToonShadowBlur6Size};
	const FLinearColor Tints[NumStages] = {Defaults.ToonShadowBlur1Tint, Defaults.ToonShadowBlur2Tint,
		Defaults.ToonShadowBlur3Tint, Defaults.ToonShadowBlur4Tint, Defaults.ToonShadowBlur5Tint,
		Defaults.ToonShadowBlur6Tint};
	std::vector<FParameterSpec> Parameters = {
		FParameterSpec::Number("SizeScale", 1, 0, 64, "Multiplies every size."),
		FParameterSpec::Integer("Quality", 5, 1, 5, "Stages that run, from the widest on: 3, 3, 4, 5 or 6."),
		FParameterSpec::Bool("Normalize", true, "Divides the tints by their sum, so that a constant stays constant."),
		FParameterSpec::Bool("Clamp", true, "Texels outside: the edge texel, or black."),
		FParameterSpec::Text("Format", "Input", {"Input", "PF_G8", "PF_R16F", "PF_FloatRGBA"},
			"Format of all temporaries; Input: the picture's format."),
	};
	for (int32 Stage = 0; Stage < NumStages; ++Stage)
	{
		const std::string Number = std::to_string(Stage + 1);
		Parameters.push_back(FParameterSpec::Number("Size" + Number, static_cast<double>(Sizes[Stage]), 0, 100,
			"Diameter of Gaussian " + Number + " in percent of the width; 0 leaves it out."));
		Parameters.push_back(FParameterSpec::Color("Tint" + Number, Tints[Stage], "Its weight."));
	}
	return Parameters;
}

FGaussianSumInputs MakeTextureBlur(const FParameterValues& Values)
{
	FGaussianSumInputs Blur;
	for (int32 Stage = NumStages - 1; Stage >= 0; --Stage)
	{
		const std::string Number = std::to_string(Stage + 1);
		Blur.Stages.Add({StageNamesX[Stage], StageNamesY[Stage], Values.GetFloat("Size" + Number),
			Values.GetColor("Tint" + Number)});
	}
	Blur.StageCount = GetBloomStageCount(static_cast<EBloomQuality>(Values.GetInteger("Quality")));
	Blur.SizeScale = Values.GetFloat("SizeScale");
	Blur.bClampAddressing = Values.GetBool("Clamp");
	if (Values.GetBool("Normalize"))
	{
		Blur.TintScale = GetNormalizingTintScale(Blur);
	}
	return Blur;
}

EPixelFormat GetFormat(const std::string& Name, const FScreenPassTexture& Input)
{
	return Name == "PF_G8"          ? PF_G8
		   : Name == "PF_R16F"      ? PF_R16F
		   : Name == "PF_FloatRGBA" ? PF_FloatRGBA
									: Input.Texture->Desc.Format;
}

const FPassFactoryRegistration GToonShadowSetup({
	.Type = "ToonShadowSetup",
	.Doc = "The darker of the two toon shadows, in one channel.",
	.Inputs = {{"Input", "ToonShadow", "R projected shadow, G self shadow; 1 is lit."}},
	.Parameters = {FParameterSpec::Text("Format", "PF_R16F", {"PF_G8", "PF_R16F"}, "Format of the result.")},
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		const bool bEightBit = Arguments.Values.GetText("Format") == "PF_G8";
		return AddToonShadowSetupPass(GraphBuilder, View, Arguments.GetInput("Input"),
			bEightBit ? EToonShadowBlurStore::EightBit : EToonShadowBlurStore::SixteenBit);
	},
});

const FPassFactoryRegistration GTextureBlur({
	.Type = "TextureBlur",
	.Doc = "Half resolution, a downsample chain and the bloom's sum of Gaussians, of any texture.",
	.Inputs = {{"Input", PictureResource, "Picture to blur."}},
	.Parameters = MakeTextureBlurParameters(),
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		const FScreenPassTexture& Input = Arguments.GetInput("Input");
		const FScreenPassTexture Blurred =
			AddTextureGaussianSumPasses(GraphBuilder, View, Input, GetFormat(Arguments.Values.GetText("Format"), Input),
				TEXT("TextureBlurDownsample"), MakeTextureBlur(Arguments.Values));
		return Blurred.IsValid() ? Blurred : Input; // no stage has a size
	},
});

const FPassFactoryRegistration GToonShadowCombine({
	.Type = "ToonShadowCombine",
	.Doc = "The toon shadows with their blur in A.",
	.Inputs = {{"Input", "ToonShadow", "The shadows, which are kept."},
		{"Blurred", "", "Picture of any size; its red is stretched over the shadows."}},
	.Parameters = {GStore},
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		return AddToonShadowCombinePass(
			GraphBuilder, View, Arguments.GetInput("Input"), Arguments.GetInput("Blurred"), GetStore(Arguments.Values));
	},
});

const FPassFactoryRegistration GToonShadowLighting({
	.Type = "ToonShadowLighting",
	.Doc = "Lights the toon pixels of a picture by their blurred shadow.",
	.Inputs = {{"Input", PictureResource, "The picture, lit already."},
		{"Shadow", "", "Result of ToonShadowCombine, with the same Store."}},
	.Parameters = {GStore, FParameterSpec::Number("Intensity", 1, 0, 1000, "Scales the light."),
		FParameterSpec::Text("Blend", "Screen", {"Screen", "Max", "Add"}, "Max: by the brighter of the two shadows."),
		FParameterSpec::Text("Ramp", "", {}, "Max: a picture from dark to lit; empty: each shadow is its own light."),
		FParameterSpec::Color("LightColor", FLinearColor(1.0f, 1.0f, 1.0f, 1.0f), "Colour of the main light."),
		FParameterSpec::Bool("AsPrinted", false, "The article's form, with its faults.")},
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		const std::string& Ramp = Arguments.Values.GetText("Ramp");
		FToonShadowLightingInputs Inputs;
		Inputs.SceneColor = Arguments.GetInput("Input");
		Inputs.ToonShadow = Arguments.GetInput("Shadow");
		Inputs.SceneTextures = CreateSceneTextureUniformBuffer(GraphBuilder, View);
		Inputs.LightColor = Arguments.Values.GetColor("LightColor");
		Inputs.Intensity = Arguments.Values.GetFloat("Intensity");
		Inputs.Blend = GetBlend(Arguments.Values);
		Inputs.Ramp = Ramp.empty() ? nullptr : FindTexturePixels(Ramp);
		Inputs.Store = GetStore(Arguments.Values);
		Inputs.bAsPrinted = Arguments.Values.GetBool("AsPrinted");
		return AddToonShadowLightingPass(GraphBuilder, View, Inputs);
	},
});

} // namespace

} // namespace Drydock
