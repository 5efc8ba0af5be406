// The passes of the dual Kawase blur, corrected and as printed, and their factory.
#include "Blur/DualKawaseBlurPass.h"

#include "Blur/DualKawaseBlurErrors.h"
#include "Blur/DualKawaseBlurOutput.h"
#include "Blur/DualKawaseBlurShaders.h"
#include "Blur/DualKawaseBlurWidth.h"
#include "HAL/IConsoleManager.h"
#include "PassFactory.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphNotes.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"

#include <cmath>

namespace Drydock
{

IMPLEMENT_GLOBAL_SHADER(FDualKawaseDownCS, "/Project/DualKawaseBlur.usf", "DownSampleCS", SF_Compute);
IMPLEMENT_GLOBAL_SHADER(FDualKawaseUpCS, "/Project/DualKawaseBlur.usf", "UpSampleCS", SF_Compute);

namespace
{

TAutoConsoleVariable<int32> CVarAsPrinted(TEXT("r.DualKawase.AsPrinted"), 0,
	TEXT("1: the dual Kawase blur as the article prints it, which loses rows and columns at odd sizes and ignores the "
		 "view rect; 0: corrected (default)."),
	ECVF_RenderThreadSafe);

constexpr const TCHAR* DownNames[GDualKawaseMaxPasses] = {TEXT("DualKawaseDown1"), TEXT("DualKawaseDown2"),
	TEXT("DualKawaseDown3"), TEXT("DualKawaseDown4"), TEXT("DualKawaseDown5"), TEXT("DualKawaseDown6"),
	TEXT("DualKawaseDown7"), TEXT("DualKawaseDown8")};
constexpr const TCHAR* UpNames[GDualKawaseMaxPasses] = {TEXT("DualKawaseUp1"), TEXT("DualKawaseUp2"),
	TEXT("DualKawaseUp3"), TEXT("DualKawaseUp4"), TEXT("DualKawaseUp5"), TEXT("DualKawaseUp6"), TEXT("DualKawaseUp7"),
	TEXT("DualKawaseUp8")};

std::string ToText(FIntPoint Size)
{
	return std::to_string(Size.X) + "x" + std::to_string(Size.Y);
}

void AddNote(FRDGBuilder& GraphBuilder, ESeverity Severity, int Code, const std::string& Message)
{
	FDiagnostic Note;
	Note.Severity = Severity;
	Note.Code = Code;
	Note.Message = Message;
	Note.Where = "DualKawaseBlur";
	AddGraphNote(GraphBuilder, Note);
}

void NoteLevels(FRDGBuilder& GraphBuilder, FIntPoint Size, int32 PassNum, int32 Levels)
{
	if (Levels < PassNum)
	{
		const std::string Reason =
			Levels == GDualKawaseMaxPasses
				? "the blur has at most " + std::to_string(Levels)
				: "a picture of " + ToText(Size) + " pixels has room for " + std::to_string(Levels);
		AddNote(GraphBuilder, ESeverity::Warning, DualKawaseNoteLevels,
			Reason + " of " + std::to_string(PassNum) + " levels; it is narrower than wanted");
	}
}

void NoteOffset(FRDGBuilder& GraphBuilder, float Offset)
{
	if (std::abs(Offset) > GDualKawaseBlockyOffset)
	{
		AddNote(GraphBuilder, ESeverity::Warning, DualKawaseNoteBlocky,
			"an offset above 2 leaves gaps between taps, which show as a grid of blocks; one level more doubles the "
			"width");
	}
}

/** In words, what the article's code would do to a picture of this size. */
void NotePrintedLoss(FRDGBuilder& GraphBuilder, FIntPoint Size, int32 PassNum, bool bAsPrinted)
{
	const FIntPoint Loss = GetDualKawasePrintedLoss(Size, PassNum);
	if (Loss == FIntPoint(0, 0))
	{
		return;
	}
	const FIntPoint Result = Size - Loss;
	const std::string Amount = std::to_string(Loss.X) + (Loss.X == 1 ? " column and " : " columns and ") +
							   std::to_string(Loss.Y) + (Loss.Y == 1 ? " row" : " rows");
	AddNote(GraphBuilder, bAsPrinted ? ESeverity::Warning : ESeverity::Note, DualKawaseNotePrintedLoss,
		"as the article prints it, halving " + ToText(Size) + " and doubling it again " + std::to_string(PassNum) +
			" times " + (bAsPrinted ? "loses " : "would lose ") + Amount + ": the result is " + ToText(Result) +
			", and what follows stretches or crops it" + (bAsPrinted ? "; r.DualKawase.AsPrinted 0 keeps all" : ""));
}

template<typename ShaderType>
void AddCorrectedPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input,
	const FScreenPassTexture& Output, FVector2f InputPerOutput, float Offset, FVector2f TapOffset)
{
	const FIntPoint Size = Output.ViewRect.Size();
	FDualKawaseParameters* PassParameters = GraphBuilder.AllocParameters<FDualKawaseParameters>();
	PassParameters->ViewSize = FVector4f(static_cast<float>(Size.X), static_cast<float>(Size.Y), Offset, 0.0f);
	PassParameters->View = View.ViewUniformBuffer;
	PassParameters->Sampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	PassParameters->Intexture = Input.Texture;
	PassParameters->OutTexture = GraphBuilder.CreateUAV(Output.Texture);
	PassParameters->Input = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Input));
	PassParameters->Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	PassParameters->InputPerOutput = InputPerOutput;
	PassParameters->TapOffset = TapOffset;

	typename ShaderType::FPermutationDomain Permutation;
	Permutation.template Set<FDualKawaseShader::FAsPrintedDimension>(false);
	FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("%s %dx%d (CS)", Output.Texture->Name, Size.X, Size.Y),
		TShaderMapRef<ShaderType>(View.ShaderMap, Permutation), PassParameters,
		FComputeShaderUtils::GetGroupCount(Size, DualKawaseGroupSize));
}

FScreenPassTexture AddCorrectedPasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FDualKawaseBlurInputs& Inputs, int32 PassNum)
{
	const FScreenPassTexture& Input = Inputs.SceneColor;
	const FIntPoint InputSize = Input.ViewRect.Size();
	const TArray<FIntPoint> Sizes = GetDualKawaseLevelSizes(InputSize, PassNum);
	const int32 Levels = Sizes.Num() - 1;
	const FDualKawaseTaps Taps = GetDualKawaseTaps(Inputs.Offset);
	NoteLevels(GraphBuilder, InputSize, Inputs.PassNum, Levels);
	if (Levels > 0)
	{
		NoteOffset(GraphBuilder, Inputs.Offset);
	}
	NotePrintedLoss(GraphBuilder, Input.Texture->Desc.Extent, PassNum, false);

	FScreenPassTexture Current = Input;
	for (int32 Level = 1; Level <= Levels; ++Level)
	{
		const FScreenPassTexture Output(CreateBlurTexture(GraphBuilder, Input, Sizes[Level], DownNames[Level - 1]));
		const FVector2f TapOffset(0.0f, static_cast<float>(Taps.DownDiagonal));
		AddCorrectedPass<FDualKawaseDownCS>(
			GraphBuilder, View, Current, Output, FVector2f(2.0f, 2.0f), Inputs.Offset, TapOffset);
		Current = Output;
	}

	const FVector2f UpOffset(static_cast<float>(Taps.UpAxis), static_cast<float>(Taps.UpDiagonal));
	for (int32 Level = Levels - 1; Level >= 0; --Level)
	{
		const FScreenPassTexture Output =
			Level == 0 ? ChooseBlurOutput(GraphBuilder, Input, Inputs.OverrideOutput, UpNames[0])
					   : FScreenPassTexture(CreateBlurTexture(GraphBuilder, Input, Sizes[Level], UpNames[Level]));
		// One half, but where OverrideOutput has another size than the input.
		const FVector2f InputPerOutput = FVector2f(Sizes[Level]) / (FVector2f(Output.ViewRect.Size()) * 2.0f);
		AddCorrectedPass<FDualKawaseUpCS>(GraphBuilder, View, Current, Output, InputPerOutput, Inputs.Offset, UpOffset);
		Current = Output;
	}
	return FinishBlurOutput(GraphBuilder, View, Current, Inputs.OverrideOutput);
}

template<typename ShaderType>
FRDGTextureRef AddPrintedPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, FRDGTextureRef Input, FIntPoint Size,
	float Offset, const TCHAR* Name)
{
	FRDGTextureDesc Desc = Input->Desc;
	Desc.Reset();
	Desc.Extent = Size;
	Desc.Flags = TexCreate_UAV;

	FDualKawaseParameters* PassParameters = GraphBuilder.AllocParameters<FDualKawaseParameters>();
	FRDGTextureRef Output = GraphBuilder.CreateTexture(Desc, Name);
	PassParameters->ViewSize = FVector4f(static_cast<float>(Size.X), static_cast<float>(Size.Y), Offset, 0.0f);
	PassParameters->View = View.ViewUniformBuffer;
	PassParameters->Sampler = TStaticSamplerState<SF_Point, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	PassParameters->Intexture = Input;
	PassParameters->OutTexture = GraphBuilder.CreateUAV(Output);

	typename ShaderType::FPermutationDomain Permutation;
	Permutation.template Set<FDualKawaseShader::FAsPrintedDimension>(true);
	FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("%s %dx%d (CS, as printed)", Name, Size.X, Size.Y),
		TShaderMapRef<ShaderType>(View.ShaderMap, Permutation), PassParameters,
		FComputeShaderUtils::GetGroupCount(Size, DualKawaseGroupSize));
	return Output;
}

/** The printed form reads the texture from edge to edge, and nobody need have written outside of the rect: there it
 * reads black. */
FRDGTextureRef BlackenOutsideRect(FRDGBuilder& GraphBuilder, const FScreenPassTexture& Picture)
{
	const FRDGTextureDesc& Whole = Picture.Texture->Desc;
	if (Picture.ViewRect == FIntRect(FIntPoint::ZeroValue, Whole.Extent))
	{
		return Picture.Texture;
	}
	FRDGTextureRef Output =
		GraphBuilder.CreateTexture(FRDGTextureDesc::Create2D(Whole.Extent, Whole.Format, FClearValueBinding::Black,
									   TexCreate_UAV | TexCreate_ShaderResource),
			TEXT("DualKawaseInput"));
	AddClearUAVPass(GraphBuilder, GraphBuilder.CreateUAV(Output), FVector4f(0.0f, 0.0f, 0.0f, 0.0f));
	FRHICopyTextureInfo Rect;
	Rect.SourcePosition = FIntVector(Picture.ViewRect.Min.X, Picture.ViewRect.Min.Y, 0);
	Rect.DestPosition = Rect.SourcePosition;
	Rect.Size = FIntVector(Picture.ViewRect.Width(), Picture.ViewRect.Height(), 1);
	AddCopyTexturePass(GraphBuilder, Picture.Texture, Output, Rect);
	return Output;
}

FScreenPassTexture AddPrintedPasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FDualKawaseBlurInputs& Inputs, int32 PassNum)
{
	const FIntPoint Size = Inputs.SceneColor.Texture->Desc.Extent;
	const TArray<FIntPoint> Sizes = GetDualKawasePrintedSizes(Size, PassNum);
	const int32 Levels = Sizes.Num() / 2;
	NoteLevels(GraphBuilder, Size, Inputs.PassNum, Levels);
	NotePrintedLoss(GraphBuilder, Size, PassNum, true);
	if (Levels == 0)
	{
		return Inputs.SceneColor;
	}

	FRDGTextureRef Current = BlackenOutsideRect(GraphBuilder, Inputs.SceneColor);
	for (int32 Pass = 0; Pass < Levels; ++Pass)
	{
		Current =
			AddPrintedPass<FDualKawaseDownCS>(GraphBuilder, View, Current, Sizes[Pass], Inputs.Offset, DownNames[Pass]);
	}
	for (int32 Pass = 0; Pass < Levels; ++Pass)
	{
		Current = AddPrintedPass<FDualKawaseUpCS>(
			GraphBuilder, View, Current, Sizes[Levels + Pass], Inputs.Offset, UpNames[Levels - 1 - Pass]);
	}
	return FScreenPassTexture(Current);
}

const FPassFactoryRegistration GDualKawase({
	.Type = "DualKawase",
	.Doc = "Blurs an image: halves it PassNum times and doubles it again.",
	.Inputs = {{"Input", PictureResource, "The image."}},
	.Parameters =
		{
			FParameterSpec::Number("Offset", 1, 0, 8, "Distance of the taps; 1 is the published filter."),
			FParameterSpec::Integer(
				"PassNum", 3, 0, GDualKawaseMaxPasses, "Levels down, and as many up; 0 leaves the image as it is."),
			FParameterSpec::Bool("AsPrinted", false, "The article's form."),
		},
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		FDualKawaseBlurInputs Inputs;
		Inputs.SceneColor = Arguments.GetInput("Input");
		Inputs.Offset = Arguments.Values.GetFloat("Offset");
		Inputs.PassNum = Arguments.Values.GetInteger("PassNum");
		Inputs.bAsPrinted = Arguments.Values.GetBool("AsPrinted");
		return AddDualKawaseBlurPass(GraphBuilder, View, Inputs);
	},
});

} // namespace

bool IsDualKawaseAsPrinted()
{
	return CVarAsPrinted.GetValueOnRenderThread() != 0;
}

FScreenPassTexture AddDualKawaseBlurPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FDualKawaseBlurInputs& Inputs)
{
	check(Inputs.SceneColor.IsValid());
	checkf(std::isfinite(Inputs.Offset), TEXT("the dual Kawase blur's Offset is not a number"));
	const int32 PassNum = FMath::Clamp(Inputs.PassNum, 0, GDualKawaseMaxPasses);
	RDG_EVENT_SCOPE(GraphBuilder, "DualKawaseBlur");
	return Inputs.bAsPrinted ? AddPrintedPasses(GraphBuilder, View, Inputs, PassNum)
							 : AddCorrectedPasses(GraphBuilder, View, Inputs, PassNum);
}

} // namespace Drydock
