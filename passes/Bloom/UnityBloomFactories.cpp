// The four passes of the Unity-style bloom that a config can insert by name, one by one.
#include "Bloom/UnityBloom.h"
#include "PassFactory.h"

namespace Drydock
{

namespace
{

FPassFactory MakeFactory(EUnityBloomPass Pass, const char* Doc, std::vector<FParameterSpec> Parameters,
	void (*Read)(const FParameterValues&, FUnityBloomPassInputs&))
{
	FPassFactory Factory;
	Factory.Type = std::string("UnityBloom") + ToString(Pass);
	Factory.Doc = Doc;
	Factory.Inputs = {{"Input", PictureResource, "The picture."}};
	if (Pass == EUnityBloomPass::Composite)
	{
		Factory.Inputs.push_back({"Bloom", "", "Picture to add, of any size; stretched over the input."});
	}
	Factory.Parameters = std::move(Parameters);
	Factory.Add = [Pass, Read](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		FUnityBloomPassInputs Inputs;
		Inputs.Pass = Pass;
		Inputs.Source = Arguments.GetInput("Input");
		if (Pass == EUnityBloomPass::Composite)
		{
			Inputs.Bloom = Arguments.GetInput("Bloom");
		}
		Read(Arguments.Values, Inputs);
		return AddUnityBloomPass(GraphBuilder, View, Inputs);
	};
	return Factory;
}

const FParameterSpec GSpread = FParameterSpec::Number("Spread", 1, 0, 64, "Distance of the five taps, in texels.");

void ReadSpread(const FParameterValues& Values, FUnityBloomPassInputs& Inputs)
{
	Inputs.Spread = Values.GetFloat("Spread");
}

const FPassFactoryRegistration GExtract(
	MakeFactory(EUnityBloomPass::Extract, "Keeps what is brighter than a threshold.",
		{FParameterSpec::Number("Threshold", 0.6, -1e6, 1e6, "Taken off the luminance."),
			FParameterSpec::Number("SoftKnee", 0, 0, 1, "Part of the threshold below it where light begins softly.")},
		[](const FParameterValues& Values, FUnityBloomPassInputs& Inputs)
		{
			Inputs.Threshold = Values.GetFloat("Threshold");
			Inputs.SoftKnee = Values.GetFloat("SoftKnee");
		}));

const FPassFactoryRegistration GVertical(
	MakeFactory(EUnityBloomPass::GaussianBlurVertical, "Blurs columns.", {GSpread}, &ReadSpread));

const FPassFactoryRegistration GHorizontal(
	MakeFactory(EUnityBloomPass::GaussianBlurHorizontal, "Blurs rows.", {GSpread}, &ReadSpread));

const FPassFactoryRegistration GComposite(MakeFactory(EUnityBloomPass::Composite, "Adds bloom to a picture.",
	{FParameterSpec::Number("Intensity", 1, 0, 1000, "Scales the bloom.")},
	[](const FParameterValues& Values, FUnityBloomPassInputs& Inputs)
	{ Inputs.Intensity = Values.GetFloat("Intensity"); }));

} // namespace

} // namespace Drydock
