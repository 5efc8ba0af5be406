// The passes of CharaGlow and their factories. Source: article "RED post process".
#include "Toon/CharaGlow.h"

#include "HAL/IConsoleManager.h"
#include "Lens/REDPostProcess.h"
#include "Math/ToInteger.h"
#include "PassFactory.h"
#include "PixelShaderUtils.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"
#include "Screen/DrawRegion.h"
#include "Screen/RasterTarget.h"
#include "Toon/CharaGlowShaders.h"

namespace Drydock
{

IMPLEMENT_GLOBAL_SHADER(FCharaGlowBoxPS, "/Project/CharaGlow.usf", "BoxPS", SF_Pixel);

FCharaGlowBox GetCharaGlowBox(float Area, bool bAsPrinted)
{
	const float Clamped = Area > 0.0f ? FMath::Min(Area, MaxCharaGlowArea) : 0.0f; // NaN: no area
	FCharaGlowBox Box;
	Box.Radius = ToInteger<int32>(Clamped);
	Box.Fraction = bAsPrinted ? 0.0f : Clamped - static_cast<float>(Box.Radius);
	Box.Scale = 1.0f / (2.0f * static_cast<float>(Box.Radius) + 1.0f + 2.0f * Box.Fraction);
	return Box;
}

namespace
{

/** The article's double loop. */
class FCharaGlowPrintedPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FCharaGlowPrintedPS);
	SHADER_USE_PARAMETER_STRUCT(FCharaGlowPrintedPS, FGlobalShader);
	using FParameters = FCharaGlowBoxParameters;
};

IMPLEMENT_GLOBAL_SHADER(FCharaGlowPrintedPS, "/Project/CharaGlow.usf", "PrintedPS", SF_Pixel);

class FCharaGlowCompPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FCharaGlowCompPS);
	SHADER_USE_PARAMETER_STRUCT(FCharaGlowCompPS, FGlobalShader);

	class FAsPrintedDimension : SHADER_PERMUTATION_BOOL("AS_PRINTED");
	using FPermutationDomain = TShaderPermutationDomain<FAsPrintedDimension>;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_INCLUDE(FSceneTextureShaderParameters, SceneTextures)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Color)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Blurred)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ColorTexture)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, BlurredTexture)
		SHADER_PARAMETER(FLinearColor, GlowColor)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FCharaGlowCompPS, "/Project/CharaGlow.usf", "CompPS", SF_Pixel);

/** The rect that the glow can reach. Further: texels more, up and down. */
FIntRect FindReach(const FCharaGlowInputs& Inputs, int32 Further = 0)
{
	const FIntRect& ViewRect = Inputs.SceneColor.ViewRect;
	if (!Inputs.MaskBounds || Inputs.OverrideOutput.IsValid())
	{
		return ViewRect;
	}
	const int32 Reach = GetCharaGlowBox(Inputs.Area, Inputs.bAsPrinted).Radius + 1;
	return PlaceRect(GrowRect(*Inputs.MaskBounds, Reach, Reach + Further), ViewRect);
}

/** Source: a texture with the mask's viewport, or the rows. */
FCharaGlowBoxParameters* MakeBoxParameters(FRDGBuilder& GraphBuilder, const FCharaGlowInputs& Inputs,
	const FScreenPassTexture& Source, const FScreenPassRenderTarget& Output)
{
	const FCharaGlowBox Box = GetCharaGlowBox(Inputs.Area, Inputs.bAsPrinted);
	auto* Parameters = GraphBuilder.AllocParameters<FCharaGlowBoxParameters>();
	Parameters->SceneTextures = GetSceneTextureShaderParameters(Inputs.SceneTextures);
	Parameters->Source = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Source));
	Parameters->Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	Parameters->RowsTexture = Source.Texture;
	Parameters->Radius = Box.Radius;
	Parameters->Fraction = Box.Fraction;
	Parameters->Scale = Box.Scale;
	Parameters->RenderTargets[0] = Output.GetRenderTargetBinding();
	return Parameters;
}

FScreenPassTexture AddBoxPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FCharaGlowInputs& Inputs,
	const FScreenPassTexture& Source, bool bColumns)
{
	const TCHAR* const Name = bColumns ? TEXT("CharaGlow") : TEXT("CharaGlowRows");
	const FScreenPassRenderTarget Output = CreateRasterTargetLike(GraphBuilder, Inputs.SceneColor, Name, PF_R16F);
	// Columns read rows beyond their own.
	const int32 Further = bColumns ? 0 : GetCharaGlowBox(Inputs.Area, Inputs.bAsPrinted).Radius + 1;
	const FIntRect Drawn = FindReach(Inputs, Further);
	FCharaGlowBoxPS::FPermutationDomain Permutation;
	Permutation.Set<FCharaGlowBoxPS::FColumnsDimension>(bColumns);
	TShaderMapRef<FCharaGlowBoxPS> PixelShader(View.ShaderMap, Permutation);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
		RDG_EVENT_NAME("%s %dx%d", Name, Drawn.Width(), Drawn.Height()), PixelShader,
		MakeBoxParameters(GraphBuilder, Inputs, Source, Output), Drawn);
	return FScreenPassTexture(Output.Texture, Output.ViewRect);
}

FScreenPassTexture AddPrintedPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FCharaGlowInputs& Inputs)
{
	const FScreenPassRenderTarget Output =
		CreateRasterTargetLike(GraphBuilder, Inputs.SceneColor, TEXT("CharaGlow"), PF_R16F);
	const FIntRect Drawn = FindReach(Inputs);
	TShaderMapRef<FCharaGlowPrintedPS> PixelShader(View.ShaderMap);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
		RDG_EVENT_NAME("CharaGlow %dx%d (as printed)", Drawn.Width(), Drawn.Height()), PixelShader,
		MakeBoxParameters(GraphBuilder, Inputs, Inputs.SceneColor, Output), Drawn);
	return FScreenPassTexture(Output.Texture, Output.ViewRect);
}

FCharaGlowInputs MakeCharaGlow(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
{
	FCharaGlowInputs Inputs;
	Inputs.SceneColor = Arguments.GetInput("Input");
	Inputs.SceneTextures = CreateSceneTextureUniformBuffer(GraphBuilder, View);
	return Inputs;
}

const FParameterSpec GAsPrinted = FParameterSpec::Bool("AsPrinted", false, "The article's form, with its faults.");

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
		Inputs.Area = Arguments.Values.GetFloat("Area");
		Inputs.bAsPrinted = Arguments.Values.GetBool("AsPrinted");
		return AddCharaGlowPasses(GraphBuilder, View, Inputs);
	},
});

const FPassFactoryRegistration GCharaGlowComp({
	.Type = "CharaGlowComp",
	.Doc = "Adds the glow that a widened mask leaves outside the mask.",
	.Inputs = {{"Input", PictureResource, "The picture."}, {"Widened", "", "Result of CharaGlow."}},
	.Parameters = {FParameterSpec::Color("Color", FLinearColor(1.0f, 1.0f, 1.0f, 1.0f), "Alpha is the strength."),
		GAsPrinted},
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		FCharaGlowInputs Inputs = MakeCharaGlow(GraphBuilder, View, Arguments);
		Inputs.Color = Arguments.Values.GetColor("Color");
		Inputs.bAsPrinted = Arguments.Values.GetBool("AsPrinted");
		return AddCharaGlowCompPass(GraphBuilder, View, Inputs, Arguments.GetInput("Widened"));
	},
});

} // namespace

FCharaGlowInputs FCharaGlowInputs::FromSettings(
	const FFinalPostProcessSettings& Settings, const FScreenPassTexture& SceneColor)
{
	FCharaGlowInputs Inputs;
	Inputs.SceneColor = SceneColor;
	Inputs.Area = Settings.CharaGlowArea;
	Inputs.Color = Settings.CharaGlowColor;
	Inputs.bAsPrinted = FREDPostProcessParameters::FromSettings(Settings).bAsPrinted;
	return Inputs;
}

FScreenPassTexture AddCharaGlowPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FCharaGlowInputs& Inputs)
{
	check(Inputs.SceneColor.IsValid());
	check(Inputs.SceneTextures);
	if (!(Inputs.Area > 0.0f))
	{
		return FScreenPassTexture();
	}
	if (Inputs.bAsPrinted)
	{
		return AddPrintedPass(GraphBuilder, View, Inputs);
	}
	const FScreenPassTexture Rows = AddBoxPass(GraphBuilder, View, Inputs, Inputs.SceneColor, false);
	return AddBoxPass(GraphBuilder, View, Inputs, Rows, true);
}

FScreenPassTexture AddCharaGlowCompPass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FCharaGlowInputs& Inputs, const FScreenPassTexture& BlurredMask)
{
	check(Inputs.SceneColor.IsValid());
	check(BlurredMask.IsValid());
	check(Inputs.SceneTextures);

	FScreenPassRenderTarget Output = Inputs.OverrideOutput.IsValid() ? Inputs.OverrideOutput
																	 : CreateRasterTargetLike(GraphBuilder,
																		   Inputs.SceneColor, TEXT("CharaGlowComp"));
	// As printed the pass writes alpha 1, which reaches everywhere.
	const FIntRect Drawn = Inputs.bAsPrinted ? Inputs.SceneColor.ViewRect : FindReach(Inputs);
	if (Drawn != Inputs.SceneColor.ViewRect)
	{
		const FIntRect& Rect = Inputs.SceneColor.ViewRect;
		AddCopyTexturePass(GraphBuilder, Inputs.SceneColor.Texture, Output.Texture, Rect.Min, Rect.Min, Rect.Size());
		Output.LoadAction = ERenderTargetLoadAction::ELoad;
	}

	auto* PassParameters = GraphBuilder.AllocParameters<FCharaGlowCompPS::FParameters>();
	PassParameters->SceneTextures = GetSceneTextureShaderParameters(Inputs.SceneTextures);
	PassParameters->Color = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Inputs.SceneColor));
	PassParameters->Blurred = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(BlurredMask));
	PassParameters->Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	PassParameters->ColorTexture = Inputs.SceneColor.Texture;
	PassParameters->BlurredTexture = BlurredMask.Texture;
	PassParameters->GlowColor = Inputs.Color;
	PassParameters->RenderTargets[0] = Output.GetRenderTargetBinding();

	FCharaGlowCompPS::FPermutationDomain Permutation;
	Permutation.Set<FCharaGlowCompPS::FAsPrintedDimension>(Inputs.bAsPrinted);
	TShaderMapRef<FCharaGlowCompPS> PixelShader(View.ShaderMap, Permutation);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
		RDG_EVENT_NAME("CharaGlowComp %dx%d", Drawn.Width(), Drawn.Height()), PixelShader, PassParameters,
		Drawn == Inputs.SceneColor.ViewRect ? Output.ViewRect : Drawn);
	return FScreenPassTexture(Output.Texture, Output.ViewRect);
}

FScreenPassTexture AddCharaGlow(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FCharaGlowInputs& Inputs)
{
	const FScreenPassTexture BlurredMask = AddCharaGlowPasses(GraphBuilder, View, Inputs);
	return BlurredMask.IsValid() ? AddCharaGlowCompPass(GraphBuilder, View, Inputs, BlurredMask) : Inputs.SceneColor;
}

} // namespace Drydock
