// The dual Kawase blur and its Gaussian as passes that a config can insert by name. Source: drydock.
#include "Blur/DualKawaseBlurPass.h"
#include "Blur/DualKawaseBlurWidth.h"
#include "PassFactory.h"

namespace Drydock
{

namespace
{

const FPassFactoryRegistration GDualKawase({
	.Type = "DualKawase",
	.Doc = "Blurs an image: halves it PassNum times and doubles it again.",
	.Inputs = {{"Input", PictureResource, "The image."}},
	.Parameters =
		{
			FParameterSpec::Number("Offset", 1, 0, 8, "Distance of the taps; 1 is the published filter."),
			FParameterSpec::Integer("PassNum", 3, 1, GDualKawaseMaxPasses, "Levels down, and as many up."),
			FParameterSpec::Bool("AsPrinted", false, "The article's form."),
		},
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		FDualKawaseBlurInputs Inputs;
		Inputs.SceneColor = Arguments.GetInput("Input");
		Inputs.Offset = static_cast<float>(Arguments.Values.GetNumber("Offset"));
		Inputs.PassNum = Arguments.Values.GetInteger("PassNum");
		Inputs.bAsPrinted = Arguments.Values.GetBool("AsPrinted");
		return AddDualKawaseBlurPass(GraphBuilder, View, Inputs);
	},
});

const FPassFactoryRegistration GGaussian({
	.Type = "MatchedGaussian",
	.Doc = "A Gaussian of a given standard deviation, clamped at the edges.",
	.Inputs = {{"Input", PictureResource, "The image."}},
	.Parameters =
		{
			FParameterSpec::Number(
				"StandardDeviation", 7.714, 0.5, 1000, "Pixels; the default is dual Kawase's with 3 levels."),
			FParameterSpec::Bool("Separable", true, "Rows, then columns; else all taps of a square at once."),
		},
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		FDualKawaseGaussianInputs Inputs;
		Inputs.SceneColor = Arguments.GetInput("Input");
		Inputs.StandardDeviation = Arguments.Values.GetNumber("StandardDeviation");
		Inputs.bSeparable = Arguments.Values.GetBool("Separable");
		return AddDualKawaseGaussianPass(GraphBuilder, View, Inputs);
	},
});

} // namespace

} // namespace Drydock
