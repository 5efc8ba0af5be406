// The passes of the RED post process that a config can insert by name, one by one.
#include "Lens/REDPostProcess.h"
#include "PassFactory.h"

#include <algorithm>
#include <string>
#include <vector>

namespace Drydock
{

namespace
{

const FParameterSpec GAsPrinted = FParameterSpec::Bool("AsPrinted", false, "The article's form, with its faults.");

FParameterSpec Positive(const char* Name, double Default, const char* Doc)
{
	return FParameterSpec::Number(Name, Default, 0, 1000, Doc);
}

/** Makes what the factories of all passes share. Read reads the pass's own parameters. */
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
	const bool bHasTwoForms = Pass != EREDPostProcessPass::DownSample;
	if (bHasTwoForms)
	{
		Factory.Parameters.push_back(GAsPrinted);
	}
	Factory.Add = [Pass, bReadsBlurred, bHasTwoForms, Read](
					  FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		FREDPostProcessPassInputs Inputs;
		Inputs.Pass = Pass;
		Inputs.SceneColor = Arguments.GetInput("Input");
		if (bReadsBlurred)
		{
			Inputs.Blurred = Arguments.GetInput("Blurred");
		}
		if (bHasTwoForms)
		{
			Inputs.Parameters.bAsPrinted = Arguments.Values.GetBool("AsPrinted");
		}
		Read(Arguments.Values, Inputs.Parameters);
		return AddREDPostProcessPass(GraphBuilder, View, Inputs);
	};
	return Factory;
}

void ReadNothing(const FParameterValues&, FREDPostProcessParameters&) {}

/** As in the names of EREDBlurKernel. */
std::vector<std::string> ListKernels()
{
	std::vector<std::string> Names;
	for (uint8 Kernel = 0; Kernel < static_cast<uint8>(EREDBlurKernel::Printed); ++Kernel)
	{
		Names.emplace_back(ToString(static_cast<EREDBlurKernel>(Kernel)));
	}
	return Names;
}

FParameterSpec MakeKernelSpec()
{
	return FParameterSpec::Text("Kernel", "SevenTaps", ListKernels(), "How the article's weights are read.");
}

void ReadKernel(const FParameterValues& Values, FREDPostProcessParameters& Parameters)
{
	const std::vector<std::string> Names = ListKernels();
	const auto Found = std::find(Names.begin(), Names.end(), Values.GetText("Kernel"));
	Parameters.Kernel = static_cast<EREDBlurKernel>(Found - Names.begin());
}

std::vector<FParameterSpec> MakeExtractSpecs()
{
	return {Positive("LuminancePow", 1, "Power of the luma."), Positive("LuminanceThreshold", 0, "Taken off that.")};
}

void ReadExtract(const FParameterValues& Values, FREDPostProcessParameters& Parameters)
{
	Parameters.LuminancePow = Values.GetFloat("LuminancePow");
	Parameters.LuminanceThreshold = Values.GetFloat("LuminanceThreshold");
}

const FPassFactoryRegistration GDownSample(
	MakeFactory(EREDPostProcessPass::DownSample, "Halves a picture by four taps.", {}, false, &ReadNothing));

const FPassFactoryRegistration GBlurH(MakeFactory(
	EREDPostProcessPass::BlurH, "Blurs rows by the article's weights.", {MakeKernelSpec()}, false, &ReadKernel));

const FPassFactoryRegistration GBlurV(MakeFactory(
	EREDPostProcessPass::BlurV, "Blurs columns by the article's weights.", {MakeKernelSpec()}, false, &ReadKernel));

const FPassFactoryRegistration GDiffusionFilter(MakeFactory(
	EREDPostProcessPass::DiffusionFilter, "Keeps what is bright, by luma.", MakeExtractSpecs(), false, &ReadExtract));

const FPassFactoryRegistration GDiffusionFilter2(
	MakeFactory(EREDPostProcessPass::DiffusionFilter2, "Combines a picture with its blur.",
		{Positive("Intensity", 1, "Scales the blur."), Positive("Power", 1, "Exponent of the combined picture."),
			FParameterSpec::Text("Blend", "Screen", {"Screen", "Max"}, "How the two meet."),
			FParameterSpec::Number("Sepia", 0, 0, 1, "Weight of the sepia picture."),
			FParameterSpec::Color("SepiaTint", FLinearColor(1.0f, 0.82f, 0.6f, 1.0f), "Its colour."),
			Positive("LuminancePow", 1, "As printed: power of the blur's luma, which weighs the blur."),
			Positive("LuminanceThreshold", 0, "As printed: taken off that.")},
		true,
		[](const FParameterValues& Values, FREDPostProcessParameters& Parameters)
		{
			ReadExtract(Values, Parameters);
			Parameters.DiffusionFilterIntensity = Values.GetFloat("Intensity");
			Parameters.DiffusionFilterPower = Values.GetFloat("Power");
			Parameters.DiffusionFilterBlend =
				Values.GetText("Blend") == "Max" ? EDiffusionFilterBlend::Max : EDiffusionFilterBlend::Screen;
			Parameters.Sepia = Values.GetFloat("Sepia");
			Parameters.SepiaTint = Values.GetColor("SepiaTint");
		}));

const FPassFactoryRegistration GSoftFocus(MakeFactory(EREDPostProcessPass::SoftFocus,
	"Mixes a picture with its blur, then saturates.",
	{FParameterSpec::Number("Blend", 0.5, 0, 1, "Share of the blur."), Positive("Saturation", 1, "1 keeps it.")}, true,
	[](const FParameterValues& Values, FREDPostProcessParameters& Parameters)
	{
		Parameters.SoftFocusBlend = Values.GetFloat("Blend");
		Parameters.SoftFocusSaturation = Values.GetFloat("Saturation");
	}));

const FPassFactoryRegistration GGlow(MakeFactory(EREDPostProcessPass::Glow, "Screens a picture with its blur.",
	{Positive("Intensity", 1, "Scales the blur.")}, true,
	[](const FParameterValues& Values, FREDPostProcessParameters& Parameters)
	{ Parameters.GlowIntensity = Values.GetFloat("Intensity"); }));

} // namespace

} // namespace Drydock
