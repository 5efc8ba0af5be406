// The engine's passes that a config can insert by name. Those of drydock's own register beside themselves. Source:
// drydock.
#include "PassFactory.h"

#include "Bloom/PostProcessBloomSetup.h"
#include "Blur/PostProcessWeightedSampleSum.h"
#include "Exposure/PostProcessEyeAdaptation.h"
#include "Screen/PostProcessDownsample.h"
#include "Tonemap/PostProcessTonemap.h"

using namespace Drydock;

namespace
{

constexpr double MaxExposureScale = 1e9;

const FParameterSpec GExposureScale = FParameterSpec::Number(
	"ExposureScale", 1.0, 1e-9, MaxExposureScale, "What scene colour is multiplied by to be display-referred.");

FRDGBufferRef CreateExposure(FRDGBuilder& GraphBuilder, const FPassArguments& Arguments)
{
	return CreateEyeAdaptationBuffer(GraphBuilder, static_cast<float>(Arguments.Values.GetNumber("ExposureScale")));
}

const FPassFactoryRegistration GDownsample({
	.Type = "Downsample",
	.Doc = "Halves an image.",
	.Inputs = {{"Input", PictureResource, "The image."}},
	.Parameters = {FParameterSpec::Text(
		"Quality", "High", {"Low", "High"}, "Low: one bilinear tap; High: four, a 4x4 box.")},
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		FDownsamplePassInputs Inputs;
		Inputs.Name = TEXT("Downsample");
		Inputs.SceneColor = Arguments.GetInput("Input");
		Inputs.Quality =
			Arguments.Values.GetText("Quality") == "Low" ? EDownsampleQuality::Low : EDownsampleQuality::High;
		return AddDownsamplePass(GraphBuilder, View, Inputs);
	},
});

const FPassFactoryRegistration GGaussianBlur({
	.Type = "GaussianBlur",
	.Doc = "Blurs an image by a separable Gaussian, as the bloom does; darkens towards the edges unless mirrored.",
	.Inputs = {{"Input", PictureResource, "The image."}},
	.Parameters =
		{
			FParameterSpec::Number("KernelSizePercent", 4.0, 0.0, 100.0,
				"Diameter of the kernel in percent of the image's width; at most 63 texels."),
			FParameterSpec::Color("Tint", FLinearColor(1.0f, 1.0f, 1.0f, 1.0f), "Multiplies the result, alpha too."),
			FParameterSpec::Bool("Mirror", true, "What lies outside: the image's mirror, or black."),
		},
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		FGaussianBlurInputs Inputs;
		Inputs.NameX = TEXT("GaussianBlurX");
		Inputs.NameY = TEXT("GaussianBlurY");
		Inputs.Filter = Arguments.GetInput("Input");
		Inputs.KernelSizePercent = static_cast<float>(Arguments.Values.GetNumber("KernelSizePercent"));
		Inputs.TintColor = Arguments.Values.GetColor("Tint");
		Inputs.UseMirrorAddressMode = Arguments.Values.GetBool("Mirror");
		return AddGaussianBlurPass(GraphBuilder, View, Inputs);
	},
});

const FPassFactoryRegistration GBloomSetup({
	.Type = "BloomSetup",
	.Doc = "Keeps what is bright enough to bloom.",
	.Inputs = {{"Input", PictureResource, "Linear, pre-exposed."}},
	.Parameters = {FParameterSpec::Number("Threshold", 1.0, -1.0, 1e6, "In exposed luminance; -1: no threshold."),
		GExposureScale},
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		FBloomSetupInputs Inputs;
		Inputs.SceneColor = Arguments.GetInput("Input");
		Inputs.Threshold = static_cast<float>(Arguments.Values.GetNumber("Threshold"));
		Inputs.EyeAdaptationBuffer = CreateExposure(GraphBuilder, Arguments);
		return AddBloomSetupPass(GraphBuilder, View, Inputs);
	},
});

const FPassFactoryRegistration GTonemap({
	.Type = "Tonemap",
	.Doc = "The film curve and sRGB, by the view's settings, without bloom.",
	.Inputs = {{"Input", PictureResource, "Linear, pre-exposed."}},
	.Parameters = {GExposureScale},
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		FTonemapInputs Inputs;
		Inputs.SceneColor = Arguments.GetInput("Input");
		Inputs.EyeAdaptationBuffer = CreateExposure(GraphBuilder, Arguments);
		return AddTonemapPass(GraphBuilder, View, Inputs);
	},
});

} // namespace
