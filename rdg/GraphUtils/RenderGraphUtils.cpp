// Adds the passes that many graphs need: copies, clears, uploads, read-backs.
#include "RenderGraphUtils.h"

#include "PixelFormatConversion.h"

BEGIN_SHADER_PARAMETER_STRUCT(FCopyTextureParameters, )
	RDG_TEXTURE_ACCESS(Input, ERHIAccess::CopySrc)
	RDG_TEXTURE_ACCESS(Output, ERHIAccess::CopyDest)
END_SHADER_PARAMETER_STRUCT()

BEGIN_SHADER_PARAMETER_STRUCT(FCopyBufferParameters, )
	RDG_BUFFER_ACCESS(SrcBuffer, ERHIAccess::CopySrc)
	RDG_BUFFER_ACCESS(DstBuffer, ERHIAccess::CopyDest)
END_SHADER_PARAMETER_STRUCT()

BEGIN_SHADER_PARAMETER_STRUCT(FClearTextureUAVParameters, )
	SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D, UAV)
END_SHADER_PARAMETER_STRUCT()

BEGIN_SHADER_PARAMETER_STRUCT(FClearBufferUAVParameters, )
	SHADER_PARAMETER_RDG_BUFFER_UAV(RWBuffer<uint>, UAV)
END_SHADER_PARAMETER_STRUCT()

BEGIN_SHADER_PARAMETER_STRUCT(FRenderTargetParameters, )
	RENDER_TARGET_BINDING_SLOTS()
END_SHADER_PARAMETER_STRUCT()

namespace Drydock
{

void AnnotatePass(FRDGPassRef Pass, const TShaderRef<FShader>& Shader)
{
	if (Pass && Shader.IsValid())
	{
		Pass->SetShader(*Shader.GetShader());
	}
}

} // namespace Drydock

void AddCopyTexturePass(FRDGBuilder& GraphBuilder, FRDGTextureRef InputTexture, FRDGTextureRef OutputTexture,
	const FRHICopyTextureInfo& CopyInfo, std::source_location Location)
{
	checkf(InputTexture && OutputTexture, TEXT("AddCopyTexturePass needs an input and an output texture"));
	checkf(InputTexture->Desc.Format == OutputTexture->Desc.Format,
		TEXT("AddCopyTexturePass: %s and %s have different formats; draw it with AddDrawTexturePass"),
		InputTexture->Name, OutputTexture->Name);
	FCopyTextureParameters* Parameters = GraphBuilder.AllocParameters<FCopyTextureParameters>();
	Parameters->Input = InputTexture;
	Parameters->Output = OutputTexture;
	GraphBuilder.AddPass(
		RDG_EVENT_NAME("CopyTexture(%s -> %s)", InputTexture->Name, OutputTexture->Name), Parameters,
		ERDGPassFlags::Copy,
		[InputTexture, OutputTexture, CopyInfo](FRHICommandList& RHICmdList)
		{ RHICmdList.CopyTexture(InputTexture->GetRHI(), OutputTexture->GetRHI(), CopyInfo); },
		Location);
}

void AddCopyTexturePass(FRDGBuilder& GraphBuilder, FRDGTextureRef InputTexture, FRDGTextureRef OutputTexture,
	FIntPoint InputPosition, FIntPoint OutputPosition, FIntPoint Size, std::source_location Location)
{
	FRHICopyTextureInfo CopyInfo;
	CopyInfo.SourcePosition = FIntVector(InputPosition.X, InputPosition.Y, 0);
	CopyInfo.DestPosition = FIntVector(OutputPosition.X, OutputPosition.Y, 0);
	if (Size != FIntPoint::ZeroValue)
	{
		CopyInfo.Size = FIntVector(Size.X, Size.Y, 1);
	}
	AddCopyTexturePass(GraphBuilder, InputTexture, OutputTexture, CopyInfo, Location);
}

void AddCopyBufferPass(FRDGBuilder& GraphBuilder, FRDGBufferRef DstBuffer, uint64 DstOffset, FRDGBufferRef SrcBuffer,
	uint64 SrcOffset, uint64 NumBytes, std::source_location Location)
{
	FCopyBufferParameters* Parameters = GraphBuilder.AllocParameters<FCopyBufferParameters>();
	Parameters->SrcBuffer = SrcBuffer;
	Parameters->DstBuffer = DstBuffer;
	GraphBuilder.AddPass(
		RDG_EVENT_NAME("CopyBuffer(%s -> %s)", SrcBuffer->Name, DstBuffer->Name), Parameters, ERDGPassFlags::Copy,
		[SrcBuffer, DstBuffer, SrcOffset, DstOffset, NumBytes](FRHICommandList& RHICmdList)
		{ RHICmdList.CopyBufferRegion(DstBuffer->GetRHI(), DstOffset, SrcBuffer->GetRHI(), SrcOffset, NumBytes); },
		Location);
}

void AddCopyBufferPass(
	FRDGBuilder& GraphBuilder, FRDGBufferRef DstBuffer, FRDGBufferRef SrcBuffer, std::source_location Location)
{
	AddCopyBufferPass(GraphBuilder, DstBuffer, 0, SrcBuffer, 0, SrcBuffer->GetSize(), Location);
}

void AddClearRenderTargetPass(FRDGBuilder& GraphBuilder, FRDGTextureRef Texture, std::source_location Location)
{
	FRenderTargetParameters* Parameters = GraphBuilder.AllocParameters<FRenderTargetParameters>();
	Parameters->RenderTargets[0] = FRenderTargetBinding(Texture, ERenderTargetLoadAction::EClear);
	GraphBuilder.AddPass(
		RDG_EVENT_NAME("ClearRenderTarget(%s)", Texture->Name), Parameters, ERDGPassFlags::Raster,
		[](FRHICommandList&) {}, Location);
}

void AddClearRenderTargetPass(
	FRDGBuilder& GraphBuilder, FRDGTextureRef Texture, const FLinearColor& ClearColor, std::source_location Location)
{
	AddClearRenderTargetPass(
		GraphBuilder, Texture, ClearColor, FIntRect(FIntPoint::ZeroValue, Texture->Desc.Extent), Location);
}

void AddClearRenderTargetPass(FRDGBuilder& GraphBuilder, FRDGTextureRef Texture, const FLinearColor& ClearColor,
	FIntRect Viewport, std::source_location Location)
{
	const FIntRect Whole(FIntPoint::ZeroValue, Texture->Desc.Extent);
	Viewport.Clip(Whole);
	FRenderTargetParameters* Parameters = GraphBuilder.AllocParameters<FRenderTargetParameters>();
	Parameters->RenderTargets[0] = FRenderTargetBinding(
		Texture, Viewport == Whole ? ERenderTargetLoadAction::ENoAction : ERenderTargetLoadAction::ELoad);
	GraphBuilder.AddPass(
		RDG_EVENT_NAME("ClearRenderTarget(%s) %dx%d", Texture->Name, Viewport.Width(), Viewport.Height()), Parameters,
		ERDGPassFlags::Raster,
		[Texture, ClearColor, Viewport](FRHICommandList&)
		{
			FRHITexture* TextureRHI = Texture->GetRHI();
			const float Color[4] = {ClearColor.R, ClearColor.G, ClearColor.B, ClearColor.A};
			uint8 Texel[32]; // four doubles are the largest texel there is
			Drydock::EncodeTexel(TextureRHI->GetStorage(), Color, Texel);
			TextureRHI->FillRect(Texel, Viewport, 0);
		},
		Location);
}

void AddClearDepthStencilPass(FRDGBuilder& GraphBuilder, FRDGTextureRef Texture, bool bClearDepth, float Depth,
	bool bClearStencil, uint8 Stencil, std::source_location Location)
{
	using EAccess = FExclusiveDepthStencil;
	const auto GetLoad = [](bool bClear)
	{
		return bClear ? ERenderTargetLoadAction::ENoAction : ERenderTargetLoadAction::ELoad;
	};
	const uint8 Access = (bClearDepth ? EAccess::DepthWrite : EAccess::DepthNop) |
						 (bClearStencil ? EAccess::StencilWrite : EAccess::StencilNop);
	FRenderTargetParameters* Parameters = GraphBuilder.AllocParameters<FRenderTargetParameters>();
	Parameters->RenderTargets.DepthStencil =
		FDepthStencilBinding(Texture, GetLoad(bClearDepth), GetLoad(bClearStencil), EAccess::Type(Access));
	GraphBuilder.AddPass(
		RDG_EVENT_NAME("ClearDepthStencil(%s)", Texture->Name), Parameters, ERDGPassFlags::Raster,
		[Texture, bClearDepth, Depth, bClearStencil, Stencil](FRHICommandList&)
		{
			FRHITexture* TextureRHI = Texture->GetRHI();
			const FIntRect Whole(FIntPoint::ZeroValue, Texture->Desc.Extent);
			if (bClearDepth)
			{
				const float Value[4] = {Depth, 0.0f, 0.0f, 0.0f};
				uint8 Texel[32]; // four doubles are the largest texel there is
				Drydock::EncodeTexel(TextureRHI->GetStorage(), Value, Texel);
				TextureRHI->FillRect(Texel, Whole, 0);
			}
			if (bClearStencil && TextureRHI->GetNumPlanes() > 1)
			{
				TextureRHI->FillRect(&Stencil, Whole, 0, -1, 1);
			}
		},
		Location);
}

namespace
{

template<typename ParametersType, typename UAVType, typename LambdaType>
void AddClearPass(FRDGBuilder& GraphBuilder, UAVType UAV, const std::source_location& Location, LambdaType&& Clear)
{
	ParametersType* Parameters = GraphBuilder.AllocParameters<ParametersType>();
	Parameters->UAV = UAV;
	GraphBuilder.AddPass(
		RDG_EVENT_NAME("ClearUAV(%s)", UAV->GetParent()->Name), Parameters, ERDGPassFlags::Compute,
		[UAV, Clear](FRHIComputeCommandList& RHICmdList) { Clear(RHICmdList, UAV->GetRHI()); }, Location);
}

} // namespace

void AddClearUAVPass(FRDGBuilder& GraphBuilder, FRDGBufferUAVRef BufferUAV, uint32 Value, std::source_location Location)
{
	AddClearPass<FClearBufferUAVParameters>(GraphBuilder, BufferUAV, Location,
		[Value](FRHIComputeCommandList& RHICmdList, FRHIUnorderedAccessView* UAV)
		{ RHICmdList.ClearUAVUint(UAV, FUintVector4(Value, Value, Value, Value)); });
}

void AddClearUAVFloatPass(
	FRDGBuilder& GraphBuilder, FRDGBufferUAVRef BufferUAV, float Value, std::source_location Location)
{
	AddClearPass<FClearBufferUAVParameters>(GraphBuilder, BufferUAV, Location,
		[Value](FRHIComputeCommandList& RHICmdList, FRHIUnorderedAccessView* UAV)
		{ RHICmdList.ClearUAVFloat(UAV, FVector4f(Value, Value, Value, Value)); });
}

void AddClearUAVPass(FRDGBuilder& GraphBuilder, FRDGTextureUAVRef TextureUAV, const FUintVector4& ClearValues,
	std::source_location Location)
{
	AddClearPass<FClearTextureUAVParameters>(GraphBuilder, TextureUAV, Location,
		[ClearValues](FRHIComputeCommandList& RHICmdList, FRHIUnorderedAccessView* UAV)
		{ RHICmdList.ClearUAVUint(UAV, ClearValues); });
}

void AddClearUAVPass(FRDGBuilder& GraphBuilder, FRDGTextureUAVRef TextureUAV, const FVector4f& ClearValues,
	std::source_location Location)
{
	AddClearPass<FClearTextureUAVParameters>(GraphBuilder, TextureUAV, Location,
		[ClearValues](FRHIComputeCommandList& RHICmdList, FRHIUnorderedAccessView* UAV)
		{ RHICmdList.ClearUAVFloat(UAV, ClearValues); });
}

void AddClearUAVPass(FRDGBuilder& GraphBuilder, FRDGTextureUAVRef TextureUAV, const FLinearColor& ClearColor,
	std::source_location Location)
{
	AddClearUAVPass(
		GraphBuilder, TextureUAV, FVector4f(ClearColor.R, ClearColor.G, ClearColor.B, ClearColor.A), Location);
}

void AddClearUAVPass(FRDGBuilder& GraphBuilder, FRDGTextureUAVRef TextureUAV, const float (&ClearValues)[4],
	std::source_location Location)
{
	AddClearUAVPass(
		GraphBuilder, TextureUAV, FVector4f(ClearValues[0], ClearValues[1], ClearValues[2], ClearValues[3]), Location);
}

void AddClearUAVPass(FRDGBuilder& GraphBuilder, FRDGTextureUAVRef TextureUAV, const uint32 (&ClearValues)[4],
	std::source_location Location)
{
	AddClearUAVPass(GraphBuilder, TextureUAV,
		FUintVector4(ClearValues[0], ClearValues[1], ClearValues[2], ClearValues[3]), Location);
}

void AddEnqueueCopyPass(FRDGBuilder& GraphBuilder, FRHIGPUTextureReadback* Readback, FRDGTextureRef SourceTexture,
	FResolveRect Rect, std::source_location Location)
{
	AddReadbackTexturePass(
		GraphBuilder, RDG_EVENT_NAME("EnqueueCopy(%s)", SourceTexture->Name), SourceTexture,
		[Readback, SourceTexture, Rect](FRHICommandList& RHICmdList)
		{
			const FIntVector Position(Rect.X1 >= 0 ? Rect.X1 : 0, Rect.Y1 >= 0 ? Rect.Y1 : 0, 0);
			const FIntVector Size(Rect.X2 - Position.X, Rect.Y2 - Position.Y, 1);
			Readback->EnqueueCopy(
				RHICmdList, SourceTexture->GetRHI(), Position, 0, Rect.IsValid() ? Size : FIntVector(0, 0, 0));
		},
		Location);
}

void AddEnqueueCopyPass(FRDGBuilder& GraphBuilder, FRHIGPUBufferReadback* Readback, FRDGBufferRef SourceBuffer,
	uint32 NumBytes, std::source_location Location)
{
	AddReadbackBufferPass(
		GraphBuilder, RDG_EVENT_NAME("EnqueueCopy(%s)", SourceBuffer->Name), SourceBuffer,
		[Readback, SourceBuffer, NumBytes](FRHICommandList& RHICmdList)
		{ Readback->EnqueueCopy(RHICmdList, SourceBuffer->GetRHI(), NumBytes); },
		Location);
}

namespace
{

FRDGBufferRef CreateBufferWithData(FRDGBuilder& GraphBuilder, const FRDGBufferDesc& Desc, const TCHAR* Name,
	const void* InitialData, uint64 InitialDataSize, ERDGInitialDataFlags InitialDataFlags)
{
	FRDGBufferRef Buffer = GraphBuilder.CreateBuffer(Desc, Name);
	if (InitialData && InitialDataSize > 0)
	{
		GraphBuilder.QueueBufferUpload(Buffer, InitialData, InitialDataSize, InitialDataFlags);
	}
	return Buffer;
}

} // namespace

FRDGBufferRef CreateStructuredBuffer(FRDGBuilder& GraphBuilder, const TCHAR* Name, uint32 BytesPerElement,
	uint32 NumElements, const void* InitialData, uint64 InitialDataSize, ERDGInitialDataFlags InitialDataFlags)
{
	return CreateBufferWithData(GraphBuilder, FRDGBufferDesc::CreateStructuredDesc(BytesPerElement, NumElements), Name,
		InitialData, InitialDataSize, InitialDataFlags);
}

FRDGBufferRef CreateVertexBuffer(FRDGBuilder& GraphBuilder, const TCHAR* Name, const FRDGBufferDesc& Desc,
	const void* InitialData, uint64 InitialDataSize, ERDGInitialDataFlags InitialDataFlags)
{
	return CreateBufferWithData(GraphBuilder, Desc, Name, InitialData, InitialDataSize, InitialDataFlags);
}

FRDGBufferRef CreateUploadBuffer(FRDGBuilder& GraphBuilder, const TCHAR* Name, uint32 BytesPerElement,
	uint32 NumElements, const void* InitialData, uint64 InitialDataSize, ERDGInitialDataFlags InitialDataFlags)
{
	return CreateBufferWithData(GraphBuilder, FRDGBufferDesc::CreateUploadDesc(BytesPerElement, NumElements), Name,
		InitialData, InitialDataSize, InitialDataFlags);
}

FRDGTextureRef RegisterExternalTexture(FRDGBuilder& GraphBuilder, FRHITexture* Texture, const TCHAR* NameIfUnregistered)
{
	if (FRDGTextureRef Registered = GraphBuilder.FindExternalTexture(Texture))
	{
		return Registered;
	}
	return GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Texture, NameIfUnregistered));
}
