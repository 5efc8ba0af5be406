// The passes of the Gaussian with a given standard deviation, and their factory.
#include "Blur/MatchedGaussianBlur.h"

#include "Blur/DualKawaseBlurErrors.h"
#include "Blur/DualKawaseBlurOutput.h"
#include "Blur/DualKawaseBlurWidth.h"
#include "Blur/MatchedGaussianShaders.h"
#include "PassFactory.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphNotes.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"

#include <string>

namespace Drydock
{

IMPLEMENT_GLOBAL_SHADER(FDualKawaseGaussianCS, "/Project/DualKawaseBlur.usf", "GaussianBlurCS", SF_Compute);

namespace
{

/** Per pixel; a frame of 1920x1080 then takes some ten seconds. */
constexpr int64 ManyTaps = 5000;

void NoteTaps(FRDGBuilder& GraphBuilder, int32 Reach)
{
	const int64 Width = 2 * Reach + 1;
	if (Width * Width > ManyTaps)
	{
		FDiagnostic Note;
		Note.Severity = ESeverity::Warning;
		Note.Code = DualKawaseNoteDirect;
		Note.Where = "DualKawaseBlur";
		Note.Message = "the direct Gaussian takes " + std::to_string(Width * Width) +
					   " taps per pixel, which may be minutes; r.DualKawase.SeparableGaussian 1 takes " +
					   std::to_string(2 * Width);
		AddGraphNote(GraphBuilder, Note);
	}
}

void AddPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input,
	const FScreenPassTexture& Output, FRDGBufferRef Weights, FIntPoint Reach)
{
	check(Input.ViewRect.Size() == Output.ViewRect.Size());
	const FIntPoint Size = Output.ViewRect.Size();
	FDualKawaseGaussianCS::FParameters* PassParameters =
		GraphBuilder.AllocParameters<FDualKawaseGaussianCS::FParameters>();
	PassParameters->Input = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Input));
	PassParameters->Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	PassParameters->Weights = GraphBuilder.CreateSRV(Weights);
	PassParameters->Reach = Reach;
	PassParameters->Intexture = Input.Texture;
	PassParameters->OutTexture = GraphBuilder.CreateUAV(Output.Texture);
	FComputeShaderUtils::AddPass(GraphBuilder,
		RDG_EVENT_NAME("%s %dx%d reach %dx%d (CS)", Output.Texture->Name, Size.X, Size.Y, Reach.X, Reach.Y),
		TShaderMapRef<FDualKawaseGaussianCS>(View.ShaderMap), PassParameters,
		FComputeShaderUtils::GetGroupCount(Size, MatchedGaussianGroupSize));
}

const FPassFactoryRegistration GMatchedGaussian({
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
		FMatchedGaussianBlurInputs Inputs;
		Inputs.SceneColor = Arguments.GetInput("Input");
		Inputs.StandardDeviation = Arguments.Values.GetNumber("StandardDeviation");
		Inputs.bSeparable = Arguments.Values.GetBool("Separable");
		return AddMatchedGaussianBlurPasses(GraphBuilder, View, Inputs);
	},
});

} // namespace

FScreenPassTexture AddMatchedGaussianBlurPasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FMatchedGaussianBlurInputs& Inputs)
{
	check(Inputs.SceneColor.IsValid());
	RDG_EVENT_SCOPE(GraphBuilder, "DualKawaseGaussian");

	TArray<float> Weights;
	for (const double Weight : ComputeMatchedGaussian(Inputs.StandardDeviation, Inputs.ReachInDeviations))
	{
		Weights.Add(static_cast<float>(Weight));
	}
	const int32 Reach = Weights.Num() - 1;
	const FRDGBufferRef Buffer = CreateStructuredBuffer(GraphBuilder, TEXT("DualKawaseGaussianWeights"), Weights);

	const FScreenPassTexture& Input = Inputs.SceneColor;
	FScreenPassTexture Rows = Input;
	FIntPoint LastReach(Reach, Reach);
	if (Inputs.bSeparable)
	{
		Rows = FScreenPassTexture(
			CreateBlurTexture(GraphBuilder, Input, Input.ViewRect.Size(), TEXT("DualKawaseGaussianX")));
		AddPass(GraphBuilder, View, Input, Rows, Buffer, FIntPoint(Reach, 0));
		LastReach.X = 0;
	}
	else
	{
		NoteTaps(GraphBuilder, Reach);
	}
	const FScreenPassTexture Output =
		ChooseBlurOutput(GraphBuilder, Input, Inputs.OverrideOutput, TEXT("DualKawaseGaussian"));
	AddPass(GraphBuilder, View, Rows, Output, Buffer, LastReach);
	return FinishBlurOutput(GraphBuilder, View, Output, Inputs.OverrideOutput);
}

} // namespace Drydock
