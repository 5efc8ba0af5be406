// The passes of the RED post process, of CharaGlow and RED depth of field that a config can insert by name, one by one.
// Source: drydock.
#include "Lens/REDDepthOfField.h"
#include "Lens/REDPostProcess.h"
#include "PassFactory.h"
#include "Toon/CharaGlow.h"

namespace Drydock
{

namespace
{

const FParameterSpec GAsPrinted = FParameterSpec::Bool("AsPrinted", false, "The article's form, with its faults.");

FParameterSpec Positive(const char* Name, double Default, const char* Doc)
{
	return FParameterSpec::Number(Name, Default, 0, 1000, Doc);
}

/** What all passes share; Read: the pass's own parameters. */
FPassFactory MakeFactory(EREDPostProcessPass Pass, const char* Doc, std::vector<FParameterSpec> Parameters,
	bool bReadsBlurred, void (*Read)(const FParameterValues&, FREDPostProcessParameters&))
{
	FPassFactory Factory;
	Factory.Type = std::string("RED") + ToString(Pass);
	Factory.Doc = Doc;
	Factory.Inputs = {{"Input", PictureResource, "The picture."}};
	if (bReadsBlurred)
	{
		Factory.Inputs.push_back({"Blurred", "", "The blurred picture, of any size; stretched over the input."});
	}
	Factory.Parameters = std::move(Parameters);
	if (Pass != EREDPostProcessPass::DownSample && Pass != EREDPostProcessPass::SoftFocus)
	{
		Factory.Parameters.push_back(GAsPrinted);
	}
	Factory.Add = [Pass, bReadsBlurred, Read](
					  FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		FREDPostProcessPassInputs Inputs;
		Inputs.Pass = Pass;
		Inputs.SceneColor = Arguments.GetInput("Input");
		if (bReadsBlurred)
		{
			Inputs.Blurred = Arguments.GetInput("Blurred");
		}
		if (Pass != EREDPostProcessPass::DownSample && Pass != EREDPostProcessPass::SoftFocus)
		{
			Inputs.Parameters.bAsPrinted = Arguments.Values.GetBool("AsPrinted");
		}
		Read(Arguments.Values, Inputs.Parameters);
		return AddREDPostProcessPass(GraphBuilder, View, Inputs);
	};
	return Factory;
}

float GetFloat(const FParameterValues& Values, const char* Name)
{
	return static_cast<float>(Values.GetNumber(Name));
}

void ReadNothing(const FParameterValues&, FREDPostProcessParameters&) {}

const FPassFactoryRegistration GDownSample(
	MakeFactory(EREDPostProcessPass::DownSample, "Halves a picture by four taps.", {}, false, &ReadNothing));

const FPassFactoryRegistration GBlurH(
	MakeFactory(EREDPostProcessPass::BlurH, "Blurs rows by seven taps.", {}, false, &ReadNothing));

const FPassFactoryRegistration GBlurV(
	MakeFactory(EREDPostProcessPass::BlurV, "Blurs columns by seven taps.", {}, false, &ReadNothing));

const FPassFactoryRegistration GDiffusionFilter(MakeFactory(EREDPostProcessPass::DiffusionFilter,
	"Keeps what is bright, by luma.",
	{Positive("LuminancePow", 1, "Power of the luma."), Positive("LuminanceThreshold", 0, "Taken off that.")}, false,
	[](const FParameterValues& Values, FREDPostProcessParameters& Parameters)
	{
		Parameters.LuminancePow = GetFloat(Values, "LuminancePow");
		Parameters.LuminanceThreshold = GetFloat(Values, "LuminanceThreshold");
	}));

const FPassFactoryRegistration GDiffusionFilter2(
	MakeFactory(EREDPostProcessPass::DiffusionFilter2, "Combines a picture with its blur.",
		{Positive("Intensity", 1, "Scales the blur."), Positive("Power", 1, "Of the combined picture."),
			FParameterSpec::Text("Blend", "Screen", {"Screen", "Max"}, "How the two meet."),
			FParameterSpec::Number("Sepia", 0, 0, 1, "Weight of the sepia picture."),
			FParameterSpec::Color("SepiaTint", FLinearColor(1.0f, 0.82f, 0.6f, 1.0f), "Its colour.")},
		true,
		[](const FParameterValues& Values, FREDPostProcessParameters& Parameters)
		{
			Parameters.DiffusionFilterIntensity = GetFloat(Values, "Intensity");
			Parameters.DiffusionFilterPower = GetFloat(Values, "Power");
			Parameters.DiffusionFilterBlend =
				Values.GetText("Blend") == "Max" ? EDiffusionFilterBlend::Max : EDiffusionFilterBlend::Screen;
			Parameters.Sepia = GetFloat(Values, "Sepia");
			Parameters.SepiaTint = Values.GetColor("SepiaTint");
		}));

const FPassFactoryRegistration GSoftFocus(MakeFactory(EREDPostProcessPass::SoftFocus,
	"Mixes a picture with its blur, then saturates.",
	{FParameterSpec::Number("Blend", 0.5, 0, 1, "Share of the blur."), Positive("Saturation", 1, "1 keeps it.")}, true,
	[](const FParameterValues& Values, FREDPostProcessParameters& Parameters)
	{
		Parameters.SoftFocusBlend = GetFloat(Values, "Blend");
		Parameters.SoftFocusSaturation = GetFloat(Values, "Saturation");
	}));

const FPassFactoryRegistration GGlow(MakeFactory(EREDPostProcessPass::Glow, "Screens a picture with its blur.",
	{Positive("Intensity", 1, "Scales the blur.")}, true,
	[](const FParameterValues& Values, FREDPostProcessParameters& Parameters)
	{ Parameters.GlowIntensity = GetFloat(Values, "Intensity"); }));

FCharaGlowInputs MakeCharaGlow(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
{
	FCharaGlowInputs Inputs;
	Inputs.SceneColor = Arguments.GetInput("Input");
	Inputs.SceneTextures = CreateSceneTextureUniformBuffer(GraphBuilder, View);
	return Inputs;
}

const FPassFactoryRegistration GCharaGlow({
	.Type = "CharaGlow",
	.Doc = "The character mask of the G-buffer, widened by a box.",
	.Inputs = {{"Input", PictureResource, "Gives size and rect."}},
	.Parameters = {FParameterSpec::Number("Area", 4, 0.01, static_cast<double>(MaxCharaGlowArea), "Radius in pixels."),
		GAsPrinted},
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		FCharaGlowInputs Inputs = MakeCharaGlow(GraphBuilder, View, Arguments);
		Inputs.Area = GetFloat(Arguments.Values, "Area");
		Inputs.bAsPrinted = Arguments.Values.GetBool("AsPrinted");
		return AddCharaGlowPasses(GraphBuilder, View, Inputs);
	},
});

const FPassFactoryRegistration GCharaGlowComp({
	.Type = "CharaGlowComp",
	.Doc = "Adds the glow that a widened mask leaves outside the mask.",
	.Inputs = {{"Input", PictureResource, "The picture."}, {"Widened", "", "What CharaGlow gave."}},
	.Parameters = {FParameterSpec::Color("Color", FLinearColor(1.0f, 1.0f, 1.0f, 1.0f), "Alpha is the strength.")},
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		FCharaGlowInputs Inputs = MakeCharaGlow(GraphBuilder, View, Arguments);
		Inputs.Color = Arguments.Values.GetColor("Color");
		return AddCharaGlowCompPass(GraphBuilder, View, Inputs, Arguments.GetInput("Widened"));
	},
});

const FPassFactoryRegistration GREDDepthOfField({
	.Type = "REDDepthOfField",
	.Doc = "Blurs what lies before and behind the focus, by the scene's depth.",
	.Inputs = {{"Input", PictureResource, "The picture."}},
	.Parameters =
		{
			FParameterSpec::Number("FocalDistance", 500, 0.01, 1e7, "In cm."),
			FParameterSpec::Number("FocalRegion", 0, 0, 1e7, "Behind it, in focus too; cm."),
			FParameterSpec::Number(
				"NearTransition", 300, 0, 1e7, "From in focus to all blurred, towards the camera; cm."),
			FParameterSpec::Number("FarTransition", 500, 0, 1e7, "The same, away from it; cm."),
			FParameterSpec::Number("NearBlurSize", 1, 0, 100, "Diameter in percent of the width."),
			FParameterSpec::Number("FarBlurSize", 1, 0, 100, "The same."),
			GAsPrinted,
		},
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		FREDDepthOfFieldInputs Inputs;
		Inputs.SceneColor = Arguments.GetInput("Input");
		Inputs.SceneTextures = CreateSceneTextureUniformBuffer(GraphBuilder, View);
		Inputs.FocalDistance = GetFloat(Arguments.Values, "FocalDistance");
		Inputs.FocalRegion = GetFloat(Arguments.Values, "FocalRegion");
		Inputs.NearTransition = GetFloat(Arguments.Values, "NearTransition");
		Inputs.FarTransition = GetFloat(Arguments.Values, "FarTransition");
		Inputs.NearBlurSize = GetFloat(Arguments.Values, "NearBlurSize");
		Inputs.FarBlurSize = GetFloat(Arguments.Values, "FarBlurSize");
		Inputs.bAsPrinted = Arguments.Values.GetBool("AsPrinted");
		return AddREDDepthOfFieldPasses(GraphBuilder, View, Inputs);
	},
});

} // namespace

} // namespace Drydock
