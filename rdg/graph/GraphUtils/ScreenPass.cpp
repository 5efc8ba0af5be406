// Fills the parameters of screen passes and adds the passes that draw or copy rectangles of textures.
#include "ScreenPass.h"

#include "CommonRenderResources.h"
#include "SystemTextures.h"
#include "VertexDraw.h"

IMPLEMENT_GLOBAL_SHADER_PARAMETER_STRUCT(FDrawRectangleParameters, Drydock::GDrawRectangleParametersName);
IMPLEMENT_GLOBAL_SHADER(FScreenPassVS, "/Engine/Private/ScreenPass.usf", "ScreenPassVS", SF_Vertex);
IMPLEMENT_GLOBAL_SHADER(FCopyRectPS, "/Engine/Private/ScreenPass.usf", "CopyRectPS", SF_Pixel);

namespace
{

FIntRect GetFullRect(FRDGTextureRef Texture)
{
	return Texture ? FIntRect(FIntPoint::ZeroValue, Texture->Desc.Extent) : FIntRect();
}

FIntPoint GetExtent(FRDGTextureRef Texture)
{
	return Texture ? Texture->Desc.Extent : FIntPoint::ZeroValue;
}

FRDGTextureRef GetTexture(FRDGTextureSRVRef TextureSRV)
{
	return TextureSRV ? TextureSRV->Desc.Texture : nullptr;
}

} // namespace

FScreenPassTexture::FScreenPassTexture(FRDGTextureRef InTexture)
	: Texture(InTexture)
	, ViewRect(GetFullRect(InTexture))
{
}

FScreenPassTexture::FScreenPassTexture(const FScreenPassTextureSlice& Slice)
	: Texture(GetTexture(Slice.TextureSRV))
	, ViewRect(Slice.ViewRect)
{
	check(!Texture || !Texture->Desc.IsTextureArray());
}

FScreenPassTexture Drydock::CopyFromSlice(FRDGBuilder& GraphBuilder, const FScreenPassTextureSlice& Slice)
{
	if (Slice.TextureSRV)
	{
		GraphBuilder.CheckArgument(Slice.TextureSRV, "FScreenPassTexture::CopyFromSlice", "Slice");
	}
	FRDGTextureRef Source = GetTexture(Slice.TextureSRV);
	if (!Source || !Source->Desc.IsTextureArray())
	{
		return FScreenPassTexture(Source, Slice.ViewRect);
	}
	FRDGTextureDesc Desc = FRDGTextureDesc::Create2D(Source->Desc.Extent, Source->Desc.Format, Source->Desc.ClearValue,
		TexCreate_ShaderResource | TexCreate_RenderTargetable);
	FRDGTextureRef Texture = GraphBuilder.CreateTexture(Desc, Source->Name);
	FRHICopyTextureInfo CopyInfo;
	CopyInfo.SourceSliceIndex = Slice.TextureSRV->Desc.FirstArraySlice;
	AddCopyTexturePass(GraphBuilder, Source, Texture, CopyInfo);
	return FScreenPassTexture(Texture, Slice.ViewRect);
}

FScreenPassTexture FScreenPassTexture::CopyFromSlice(FRDGBuilder& GraphBuilder, const FScreenPassTextureSlice& Slice)
{
	return Drydock::CopyFromSlice(GraphBuilder, Slice);
}

FScreenPassTexture FScreenPassTexture::CopyFromSlice(
	FRDGBuilder& GraphBuilder, const FScreenPassTextureSlice& Slice, FScreenPassTexture OverrideOutput)
{
	const FScreenPassTexture Input = CopyFromSlice(GraphBuilder, Slice);
	if (!OverrideOutput.IsValid() || !Input.IsValid())
	{
		return Input;
	}
	const bool bWhole = FScreenPassTextureViewport(OverrideOutput).IsFullscreen();
	AddDrawTexturePass(GraphBuilder, FScreenPassViewInfo(GMaxRHIFeatureLevel), Input,
		FScreenPassRenderTarget(
			OverrideOutput, bWhole ? ERenderTargetLoadAction::ENoAction : ERenderTargetLoadAction::ELoad));
	return OverrideOutput;
}

FScreenPassTextureSlice FScreenPassTextureSlice::CreateFromScreenPassTexture(
	FRDGBuilder& GraphBuilder, const FScreenPassTexture& ScreenTexture)
{
	if (!ScreenTexture.Texture)
	{
		return FScreenPassTextureSlice();
	}
	return FScreenPassTextureSlice(
		GraphBuilder.CreateSRV(FRDGTextureSRVDesc::Create(ScreenTexture.Texture)), ScreenTexture.ViewRect);
}

FScreenPassRenderTarget FScreenPassRenderTarget::CreateFromInput(FRDGBuilder& GraphBuilder, FScreenPassTexture Input,
	ERenderTargetLoadAction OutputLoadAction, const TCHAR* OutputName)
{
	GraphBuilder.CheckArgument(Input.Texture, "FScreenPassRenderTarget::CreateFromInput", "Input");
	FRDGTextureDesc OutputDesc = Input.Texture->Desc;
	OutputDesc.Reset();
	return FScreenPassRenderTarget(
		GraphBuilder.CreateTexture(OutputDesc, OutputName), Input.ViewRect, OutputLoadAction);
}

FScreenPassRenderTarget FScreenPassRenderTarget::CreateViewFamilyOutput(
	FRDGTextureRef ViewFamilyTexture, FIntRect ViewRect, bool bIsFirstView)
{
	ERenderTargetLoadAction LoadAction = ERenderTargetLoadAction::ELoad;
	if (bIsFirstView)
	{
		LoadAction = ViewRect == GetFullRect(ViewFamilyTexture) ? ERenderTargetLoadAction::ENoAction
																: ERenderTargetLoadAction::EClear;
	}
	return FScreenPassRenderTarget(ViewFamilyTexture, ViewRect, LoadAction);
}

FScreenPassTextureViewport::FScreenPassTextureViewport(FRDGTextureRef InTexture, FIntRect InRect)
	: Extent(GetExtent(InTexture))
	, Rect(InRect)
{
}

FScreenPassTextureViewport::FScreenPassTextureViewport(FRDGTextureRef InTexture)
	: FScreenPassTextureViewport(InTexture, GetFullRect(InTexture))
{
}

FScreenPassTextureViewport::FScreenPassTextureViewport(const FScreenPassTexture& InTexture)
	: FScreenPassTextureViewport(InTexture.Texture, InTexture.ViewRect)
{
}

FScreenPassTextureViewport::FScreenPassTextureViewport(const FScreenPassTextureSlice& InSlice)
	: FScreenPassTextureViewport(GetTexture(InSlice.TextureSRV), InSlice.ViewRect)
{
}

FIntPoint GetDownscaledExtent(FIntPoint Extent, FIntPoint Divisor)
{
	return FIntPoint::DivideAndRoundUp(Extent, Divisor).ComponentMax(FIntPoint(1, 1));
}

FIntRect GetDownscaledRect(FIntRect Rect, FIntPoint Divisor)
{
	return FIntRect(FIntPoint(Rect.Min.X / Divisor.X, Rect.Min.Y / Divisor.Y), GetDownscaledExtent(Rect.Max, Divisor));
}

FScreenPassTextureViewport GetDownscaledViewport(FScreenPassTextureViewport Viewport, FIntPoint Divisor)
{
	return FScreenPassTextureViewport(
		GetDownscaledExtent(Viewport.Extent, Divisor), GetDownscaledRect(Viewport.Rect, Divisor));
}

FScreenPassTextureViewportParameters GetScreenPassTextureViewportParameters(
	const FScreenPassTextureViewport& InViewport)
{
	FScreenPassTextureViewportParameters Parameters;
	if (InViewport.IsEmpty())
	{
		return Parameters;
	}
	const FVector2f Extent(InViewport.Extent);
	const FVector2f Min(InViewport.Rect.Min);
	const FVector2f Max(InViewport.Rect.Max);
	const FVector2f Size = Max - Min;
	const FVector2f One(1.0f, 1.0f);

	Parameters.Extent = Extent;
	Parameters.ExtentInverse = One / Extent;
	Parameters.ScreenPosToViewportScale = FVector2f(0.5f, -0.5f) * Size;
	Parameters.ScreenPosToViewportBias = Size * 0.5f + Min;
	Parameters.ViewportMin = InViewport.Rect.Min;
	Parameters.ViewportMax = InViewport.Rect.Max;
	Parameters.ViewportSize = Size;
	Parameters.ViewportSizeInverse = One / Size;
	Parameters.UVViewportMin = Min / Extent;
	Parameters.UVViewportMax = Max / Extent;
	Parameters.UVViewportSize = Parameters.UVViewportMax - Parameters.UVViewportMin;
	Parameters.UVViewportSizeInverse = One / Parameters.UVViewportSize;
	Parameters.UVViewportBilinearMin = Parameters.UVViewportMin + Parameters.ExtentInverse * 0.5f;
	Parameters.UVViewportBilinearMax = Parameters.UVViewportMax - Parameters.ExtentInverse * 0.5f;
	return Parameters;
}

FScreenPassTextureInput GetScreenPassTextureInput(FScreenPassTexture TexturePair, FRHISamplerState* Sampler)
{
	FScreenPassTextureInput Input;
	Input.Viewport = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(TexturePair));
	Input.Texture = TexturePair.Texture;
	Input.Sampler = Sampler;
	return Input;
}

FScreenPassTextureSliceInput GetScreenPassTextureInput(FScreenPassTextureSlice TextureSlice, FRHISamplerState* Sampler)
{
	FScreenPassTextureSliceInput Input;
	Input.Viewport = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(TextureSlice));
	Input.Texture = TextureSlice.TextureSRV;
	Input.Sampler = Sampler;
	return Input;
}

FScreenPassTextureViewportTransform GetScreenPassTextureViewportTransform(const FVector2f& SourceOffset,
	const FVector2f& SourceExtent, const FVector2f& DestinationOffset, const FVector2f& DestinationExtent)
{
	FScreenPassTextureViewportTransform Transform;
	Transform.Scale = DestinationExtent / SourceExtent;
	Transform.Bias = DestinationOffset - Transform.Scale * SourceOffset;
	return Transform;
}

FScreenPassTextureViewportTransform GetScreenPassTextureViewportTransform(
	const FScreenPassTextureViewportParameters& Source, const FScreenPassTextureViewportParameters& Destination)
{
	return GetScreenPassTextureViewportTransform(
		Source.UVViewportMin, Source.UVViewportSize, Destination.UVViewportMin, Destination.UVViewportSize);
}

void SetScreenPassPipelineState(FRHICommandList& RHICmdList, const FScreenPassPipelineState& ScreenPassDraw)
{
	FGraphicsPipelineStateInitializer Initializer;
	RHICmdList.ApplyCachedRenderTargets(Initializer);
	Initializer.BlendState = ScreenPassDraw.BlendState;
	Initializer.RasterizerState = TStaticRasterizerState<>::GetRHI();
	Initializer.DepthStencilState = ScreenPassDraw.DepthStencilState;
	Initializer.BoundShaderState.VertexDeclarationRHI = GFilterVertexDeclaration.VertexDeclarationRHI;
	Initializer.BoundShaderState.VertexShaderRHI = ScreenPassDraw.VertexShader.GetVertexShader();
	Initializer.BoundShaderState.PixelShaderRHI = ScreenPassDraw.PixelShader.GetPixelShader();
	Initializer.PrimitiveType = PT_TriangleList;
	RHICmdList.SetGraphicsPipelineState(Initializer, ScreenPassDraw.StencilRef);
}

namespace Drydock
{

namespace
{

/** One coordinate that is Start at the first edge of a span of target pixels and Start + Length at its end. */
void SetAxis(FKernelInterpolant& Interpolant, double (&Slope)[4], int32 Component, double SpanMin, double SpanSize,
	double Start, double Length)
{
	Slope[Component] = Length / SpanSize;
	Interpolant.Base[Component] = Start - Slope[Component] * SpanMin;
}

FKernelInterpolant MakeScreenPassInterpolant(
	const FVector2f& Position, const FVector2f& Size, const FVector2f& UVMin, const FVector2f& UVSize)
{
	FKernelInterpolant Interpolant = {};
	SetAxis(Interpolant, Interpolant.DX, 0, Position.X, Size.X, UVMin.X, UVSize.X);
	SetAxis(Interpolant, Interpolant.DY, 1, Position.Y, Size.Y, UVMin.Y, UVSize.Y);
	SetAxis(Interpolant, Interpolant.DX, 2, Position.X, Size.X, -1.0, 2.0);
	SetAxis(Interpolant, Interpolant.DY, 3, Position.Y, Size.Y, 1.0, -2.0);
	return Interpolant;
}

void SetRectInterpolants(
	FRHICommandList& RHICmdList, const FIntRect& Target, const FVector2f& UVMin, const FVector2f& UVSize)
{
	RHICmdList.SetViewport(static_cast<float>(Target.Min.X), static_cast<float>(Target.Min.Y), 0.0f,
		static_cast<float>(Target.Max.X), static_cast<float>(Target.Max.Y), 1.0f);
	const FKernelInterpolant Interpolant =
		MakeScreenPassInterpolant(FVector2f(Target.Min), FVector2f(Target.Size()), UVMin, UVSize);
	RHICmdList.SetInterpolants(TConstArrayView<FKernelInterpolant>(&Interpolant, 1));
}

void DrawRectangleOfViewport(FRHICommandList& RHICmdList, const FVector2f& Position, const FVector2f& Size,
	const FVector2f& UVMin, const FVector2f& UVSize, const FVector2f& TargetSize, const FVector2f& TextureSize)
{
	FDrawRectangleParameters Parameters;
	Parameters.PosScaleBias = FVector4f(Size.X, Size.Y, Position.X, Position.Y);
	Parameters.UVScaleBias = FVector4f(UVSize.X, UVSize.Y, UVMin.X, UVMin.Y);
	Parameters.InvTargetSizeAndTextureSize =
		FVector4f(1.0f / TargetSize.X, 1.0f / TargetSize.Y, 1.0f / TextureSize.X, 1.0f / TextureSize.Y);
	RHICmdList.DrawScreenRectangle(&Parameters, sizeof(Parameters));
}

} // namespace

void DrawScreenPassRectangle(FRHICommandList& RHICmdList, const FScreenPassTextureViewport& OutputViewport,
	const FScreenPassTextureViewport& InputViewport)
{
	const FVector2f Extent(InputViewport.Extent);
	const FVector2f UVMin = FVector2f(InputViewport.Rect.Min);
	const FVector2f UVSize = FVector2f(InputViewport.Rect.Size());
	if (RHICmdList.HasVertexShader())
	{
		const FIntRect& Rect = OutputViewport.Rect;
		RHICmdList.SetViewport(static_cast<float>(Rect.Min.X), static_cast<float>(Rect.Min.Y), 0.0f,
			static_cast<float>(Rect.Max.X), static_cast<float>(Rect.Max.Y), 1.0f);
		DrawRectangleOfViewport(
			RHICmdList, FVector2f(0, 0), FVector2f(Rect.Size()), UVMin, UVSize, FVector2f(Rect.Size()), Extent);
		return;
	}
	SetRectInterpolants(RHICmdList, OutputViewport.Rect, UVMin / Extent, UVSize / Extent);
	RHICmdList.DrawPrimitive(0, 1, 1);
}

FRDGPassRef AddScreenPass(FRDGBuilder& GraphBuilder, FRDGEventName&& Name,
	const FScreenPassTextureViewport& OutputViewport, const FScreenPassTextureViewport& InputViewport,
	const FScreenPassPipelineState& PipelineState, const FShaderParametersMetadata* ParametersMetadata,
	const void* Parameters, const Drydock::FSourceLocation& Location)
{
	FRDGPassRef Pass = GraphBuilder.AddPass(
		MoveTemp(Name), ParametersMetadata, Parameters, ERDGPassFlags::Raster,
		[OutputViewport, InputViewport, PipelineState, ParametersMetadata, Parameters](FRHICommandList& RHICmdList)
		{
			SetScreenPassPipelineState(RHICmdList, PipelineState);
			SetShaderParameters(RHICmdList, PipelineState.PixelShader, PipelineState.PixelShader.GetPixelShader(),
				ParametersMetadata, Parameters);
			DrawScreenPassRectangle(RHICmdList, OutputViewport, InputViewport);
		},
		Location);
	AnnotatePass(Pass, PipelineState.PixelShader, PipelineState.VertexShader);
	Pass->SetArea(OutputViewport.Rect.Size());
	return Pass;
}

} // namespace Drydock

void DrawRectangle(FRHICommandList& RHICmdList, float X, float Y, float SizeX, float SizeY, float U, float V,
	float SizeU, float SizeV, FIntPoint TargetSize, FIntPoint TextureSize, const TShaderRef<FShader>&,
	EDrawRectangleFlags)
{
	Drydock::DrawRectangleOfViewport(RHICmdList, FVector2f(X, Y), FVector2f(SizeX, SizeY), FVector2f(U, V),
		FVector2f(SizeU, SizeV), FVector2f(TargetSize), FVector2f(TextureSize));
}

void AddDrawTexturePass(FRDGBuilder& GraphBuilder, const FScreenPassViewInfo& ViewInfo, FScreenPassTexture Input,
	FScreenPassRenderTarget Output)
{
	GraphBuilder.CheckArgument(Input.Texture, "AddDrawTexturePass", "Input");
	GraphBuilder.CheckArgument(Output.Texture, "AddDrawTexturePass", "Output");
	const bool bSameSize = Input.ViewRect.Size() == Output.ViewRect.Size();
	const bool bSameFormat = Input.Texture->Desc.Format == Output.Texture->Desc.Format;
	if (bSameSize && bSameFormat && Output.LoadAction != ERenderTargetLoadAction::EClear)
	{
		AddCopyTexturePass(GraphBuilder, Input.Texture, Output.Texture, Input.ViewRect.Min, Output.ViewRect.Min,
			Input.ViewRect.Size());
		return;
	}
	FCopyRectPS::FParameters* Parameters = GraphBuilder.AllocParameters<FCopyRectPS::FParameters>();
	Parameters->InputTexture = Input.Texture;
	Parameters->InputSampler = TStaticSamplerState<SF_Point, AM_Clamp, AM_Clamp>::GetRHI();
	Parameters->RenderTargets[0] = Output.GetRenderTargetBinding();
	AddDrawScreenPass(GraphBuilder, RDG_EVENT_NAME("DrawTexture %s -> %s", Input.Texture->Name, Output.Texture->Name),
		ViewInfo, FScreenPassTextureViewport(Output), FScreenPassTextureViewport(Input),
		TShaderMapRef<FCopyRectPS>(GetGlobalShaderMap(GMaxRHIFeatureLevel)), Parameters);
}

void AddDrawTexturePass(FRDGBuilder& GraphBuilder, const FScreenPassViewInfo& ViewInfo, FRDGTextureRef InputTexture,
	FRDGTextureRef OutputTexture, FIntPoint InputPosition, FIntPoint OutputPosition, FIntPoint Size)
{
	GraphBuilder.CheckArgument(InputTexture, "AddDrawTexturePass", "InputTexture");
	GraphBuilder.CheckArgument(OutputTexture, "AddDrawTexturePass", "OutputTexture");
	if (Size == FIntPoint::ZeroValue)
	{
		Size = (InputTexture->Desc.Extent - InputPosition).ComponentMin(OutputTexture->Desc.Extent - OutputPosition);
	}
	const FIntRect OutputRect(OutputPosition, OutputPosition + Size);
	const bool bCovers = OutputRect == FIntRect(FIntPoint::ZeroValue, OutputTexture->Desc.Extent);
	AddDrawTexturePass(GraphBuilder, ViewInfo,
		FScreenPassTexture(InputTexture, FIntRect(InputPosition, InputPosition + Size)),
		FScreenPassRenderTarget(
			OutputTexture, OutputRect, bCovers ? ERenderTargetLoadAction::ENoAction : ERenderTargetLoadAction::ELoad));
}

FScreenTransform FScreenTransform::ChangeTextureBasisFromTo(
	const FScreenPassTextureViewport& TextureViewport, ETextureBasis SrcBasis, ETextureBasis DestBasis)
{
	return ChangeTextureBasisFromTo(TextureViewport.Extent, TextureViewport.Rect, SrcBasis, DestBasis);
}
