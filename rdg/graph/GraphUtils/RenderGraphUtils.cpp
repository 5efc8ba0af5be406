// Adds the passes that many graphs need: copies, clears, uploads, read-backs.
#include "RenderGraphUtils.h"

#include "PixelFormatConversion.h"
#include "RenderGraphReport.h"

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

namespace Drydock
{

namespace
{

[[noreturn]] void ThrowAt(
	const Drydock::FSourceLocation& Location, int Code, const std::string& Message, const std::string& Where)
{
	FDiagnostic Diagnostic;
	Diagnostic.Code = Code;
	Diagnostic.Message = Message;
	Diagnostic.File = Location.File;
	Diagnostic.Line = int(Location.Line);
	Diagnostic.Where = Where;
	ThrowRDGErrors({Diagnostic});
}

/** "4 x 4 x 1" */
std::string ToText(const FIntVector& Vector)
{
	return std::to_string(Vector.X) + " x " + std::to_string(Vector.Y) + " x " + std::to_string(Vector.Z);
}

} // namespace

void AnnotatePass(FRDGPassRef Pass, const TShaderRef<FShader>& Shader, const TShaderRef<FShader>& VertexShader)
{
	if (Pass && Shader.IsValid())
	{
		Pass->SetShader(*Shader.GetShader());
	}
	if (Pass && VertexShader.IsValid() && VertexShader.GetType()->IsRunByDraws())
	{
		Pass->SetVertexShader(*VertexShader.GetShader());
	}
}

void CheckPassArguments(const char* Call, const FRDGEventName& PassName, const TShaderRef<FShader>& Shader,
	const void* Parameters, const Drydock::FSourceLocation& Location)
{
	const char* const Null = !Shader.IsValid() ? "shader" : !Parameters ? "Parameters" : nullptr;
	if (Null)
	{
		ThrowAt(Location, RDGErrorNullArgument, "the parameter is null",
			std::string("pass ") + PassName.GetTCHAR() + ", " + Call + ", parameter " + Null);
	}
}

void CheckGroupCount(
	const FRDGEventName& PassName, const FIntVector& GroupCount, const Drydock::FSourceLocation& Location)
{
	if (GroupCount.X < 0 || GroupCount.Y < 0 || GroupCount.Z < 0)
	{
		ThrowAt(Location, RDGErrorGroupCount,
			"the number of thread groups (" + std::to_string(GroupCount.X) + ", " + std::to_string(GroupCount.Y) +
				", " + std::to_string(GroupCount.Z) + ") is negative",
			std::string("pass ") + PassName.GetTCHAR());
	}
}

namespace
{

/** Whether Size texels from Position lie within Extent, along one axis. */
bool IsWithin(int64 Position, int64 Size, int64 Extent)
{
	return Position >= 0 && Size > 0 && Position + Size <= Extent;
}

/** One side of a copy at one mip. */
struct FCopySide
{
	FRDGTextureRef Texture;
	uint32 Mip;
	FIntVector Position;
	uint32 Slice;

	FIntVector GetExtent() const
	{
		const FRDGTextureDesc& Desc = Texture->Desc;
		return FIntVector(FMath::Max(1, Desc.Extent.X >> Mip), FMath::Max(1, Desc.Extent.Y >> Mip),
			Desc.IsTexture3D() ? FMath::Max(1, int32(Desc.Depth) >> Mip)
							   : int32(Texture->GetSubresourceLayout().NumArraySlices));
	}
	/** In mips' own texels; slices are the third axis of what has no depth. */
	FIntVector GetFirst(uint32 MipsFurther) const
	{
		return FIntVector(Position.X >> MipsFurther, Position.Y >> MipsFurther,
			Texture->Desc.IsTexture3D() ? Position.Z >> MipsFurther : int32(Slice));
	}
};

/** Refuses at the place of the call what CopyTexture would refuse when the pass runs. */
void CheckCopy(FRDGTextureRef Input, FRDGTextureRef Output, const FRHICopyTextureInfo& Info,
	const Drydock::FSourceLocation& Location)
{
	const std::string Where = std::string("pass CopyTexture(") + Input->Name + " -> " + Output->Name + ")";
	if (Input->Desc.Format != Output->Desc.Format)
	{
		ThrowAt(Location, RDGErrorCopy,
			std::string("a copy does not convert: ") + Input->Name + " is " + GetPixelFormatString(Input->Desc.Format) +
				", " + Output->Name + " is " + GetPixelFormatString(Output->Desc.Format) +
				"; draw it with AddDrawTexturePass",
			Where);
	}
	const bool bWhole = Info.Size.X == 0 && Info.Size.Y == 0 && Info.Size.Z == 0;
	for (uint32 Mip = 0; Mip < Info.NumMips; ++Mip)
	{
		const FCopySide Sides[] = {
			{Input, Info.SourceMipIndex + Mip, Info.SourcePosition, Info.SourceSliceIndex},
			{Output, Info.DestMipIndex + Mip, Info.DestPosition, Info.DestSliceIndex},
		};
		for (const FCopySide& Side : Sides)
		{
			if (Side.Mip >= Side.Texture->Desc.NumMips)
			{
				ThrowAt(Location, RDGErrorCopy,
					"the copy is of mip " + std::to_string(Side.Mip) + ", but " + Side.Texture->Name + " has " +
						std::to_string(Side.Texture->Desc.NumMips),
					Where);
			}
		}
		FIntVector Size(
			FMath::Max(1, Info.Size.X >> Mip), FMath::Max(1, Info.Size.Y >> Mip), FMath::Max(1, Info.Size.Z >> Mip));
		if (bWhole)
		{
			const FIntVector All = Sides[0].GetExtent();
			const FIntVector First = Sides[0].GetFirst(Mip);
			Size = FIntVector(All.X - First.X, All.Y - First.Y, All.Z - First.Z);
		}
		if (!Input->Desc.IsTexture3D())
		{
			Size.Z = int32(Info.NumSlices);
		}
		for (const FCopySide& Side : Sides)
		{
			const FIntVector First = Side.GetFirst(Mip);
			const FIntVector Extent = Side.GetExtent();
			if (!IsWithin(First.X, Size.X, Extent.X) || !IsWithin(First.Y, Size.Y, Extent.Y) ||
				!IsWithin(First.Z, Size.Z, Extent.Z))
			{
				ThrowAt(Location, RDGErrorCopy,
					"the copy of " + ToText(Size) + " texels at " + ToText(First) + " goes beyond mip " +
						std::to_string(Side.Mip) + " of " + Side.Texture->Name + ", which has " + ToText(Extent),
					Where);
			}
		}
	}
}

void CheckBufferCopy(const FRDGBuffer& Buffer, uint64 Offset, uint64 NumBytes, const char* Call,
	const Drydock::FSourceLocation& Location)
{
	if (NumBytes > Buffer.GetSize() || Offset > Buffer.GetSize() - NumBytes)
	{
		ThrowAt(Location, RDGErrorCopy,
			std::to_string(NumBytes) + " bytes at " + std::to_string(Offset) + " go beyond the buffer, which has " +
				std::to_string(Buffer.GetSize()),
			std::string(Call) + ", resource " + Buffer.Name);
	}
}

void CheckReadback(const void* Readback, const Drydock::FSourceLocation& Location)
{
	if (!Readback)
	{
		ThrowAt(Location, RDGErrorNullArgument, "the parameter is null", "AddEnqueueCopyPass, parameter Readback");
	}
}

void CheckReadbackRect(FRDGTextureRef Texture, const FIntRect& Rect, const Drydock::FSourceLocation& Location)
{
	const FIntPoint Extent = Texture->Desc.Extent;
	if (!IsWithin(Rect.Min.X, Rect.Width(), Extent.X) || !IsWithin(Rect.Min.Y, Rect.Height(), Extent.Y))
	{
		ThrowAt(Location, RDGErrorCopy,
			"the readback of " + ToText(FIntVector(Rect.Width(), Rect.Height(), 1)) + " texels at " +
				ToText(FIntVector(Rect.Min.X, Rect.Min.Y, 0)) + " goes beyond the texture, which has " +
				ToText(FIntVector(Extent.X, Extent.Y, 1)),
			std::string("AddEnqueueCopyPass, resource ") + Texture->Name);
	}
}

} // namespace

} // namespace Drydock

void AddCopyTexturePass(FRDGBuilder& GraphBuilder, FRDGTextureRef InputTexture, FRDGTextureRef OutputTexture,
	const FRHICopyTextureInfo& CopyInfo, Drydock::FSourceLocation Location)
{
	GraphBuilder.CheckArgument(InputTexture, "AddCopyTexturePass", "InputTexture", &Location);
	GraphBuilder.CheckArgument(OutputTexture, "AddCopyTexturePass", "OutputTexture", &Location);
	Drydock::CheckCopy(InputTexture, OutputTexture, CopyInfo, Location);
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
	FIntPoint InputPosition, FIntPoint OutputPosition, FIntPoint Size, Drydock::FSourceLocation Location)
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
	uint64 SrcOffset, uint64 NumBytes, Drydock::FSourceLocation Location)
{
	GraphBuilder.CheckArgument(DstBuffer, "AddCopyBufferPass", "DstBuffer", &Location);
	GraphBuilder.CheckArgument(SrcBuffer, "AddCopyBufferPass", "SrcBuffer", &Location);
	Drydock::CheckBufferCopy(*DstBuffer, DstOffset, NumBytes, "AddCopyBufferPass", Location);
	Drydock::CheckBufferCopy(*SrcBuffer, SrcOffset, NumBytes, "AddCopyBufferPass", Location);
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
	FRDGBuilder& GraphBuilder, FRDGBufferRef DstBuffer, FRDGBufferRef SrcBuffer, Drydock::FSourceLocation Location)
{
	GraphBuilder.CheckArgument(SrcBuffer, "AddCopyBufferPass", "SrcBuffer", &Location);
	AddCopyBufferPass(GraphBuilder, DstBuffer, 0, SrcBuffer, 0, SrcBuffer->GetSize(), Location);
}

void AddClearRenderTargetPass(FRDGBuilder& GraphBuilder, FRDGTextureRef Texture, Drydock::FSourceLocation Location)
{
	GraphBuilder.CheckArgument(Texture, "AddClearRenderTargetPass", "Texture", &Location);
	FRenderTargetParameters* Parameters = GraphBuilder.AllocParameters<FRenderTargetParameters>();
	Parameters->RenderTargets[0] = FRenderTargetBinding(Texture, ERenderTargetLoadAction::EClear);
	GraphBuilder.AddPass(
		RDG_EVENT_NAME("ClearRenderTarget(%s)", Texture->Name), Parameters, ERDGPassFlags::Raster,
		[](FRHICommandList&) {}, Location);
}

void AddClearRenderTargetPass(FRDGBuilder& GraphBuilder, FRDGTextureRef Texture, const FLinearColor& ClearColor,
	Drydock::FSourceLocation Location)
{
	GraphBuilder.CheckArgument(Texture, "AddClearRenderTargetPass", "Texture", &Location);
	AddClearRenderTargetPass(
		GraphBuilder, Texture, ClearColor, FIntRect(FIntPoint::ZeroValue, Texture->Desc.Extent), Location);
}

void AddClearRenderTargetPass(FRDGBuilder& GraphBuilder, FRDGTextureRef Texture, const FLinearColor& ClearColor,
	FIntRect Viewport, Drydock::FSourceLocation Location)
{
	GraphBuilder.CheckArgument(Texture, "AddClearRenderTargetPass", "Texture", &Location);
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
	bool bClearStencil, uint8 Stencil, Drydock::FSourceLocation Location)
{
	GraphBuilder.CheckArgument(Texture, "AddClearDepthStencilPass", "Texture", &Location);
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
void AddClearPass(FRDGBuilder& GraphBuilder, UAVType UAV, const Drydock::FSourceLocation& Location, LambdaType&& Clear)
{
	GraphBuilder.CheckArgument(UAV, "AddClearUAVPass", "UAV", &Location);
	ParametersType* Parameters = GraphBuilder.AllocParameters<ParametersType>();
	Parameters->UAV = UAV;
	GraphBuilder.AddPass(
		RDG_EVENT_NAME("ClearUAV(%s)", UAV->GetParent()->Name), Parameters, ERDGPassFlags::Compute,
		[UAV, Clear](FRHIComputeCommandList& RHICmdList) { Clear(RHICmdList, UAV->GetRHI()); }, Location);
}

} // namespace

void AddClearUAVPass(
	FRDGBuilder& GraphBuilder, FRDGBufferUAVRef BufferUAV, uint32 Value, Drydock::FSourceLocation Location)
{
	AddClearPass<FClearBufferUAVParameters>(GraphBuilder, BufferUAV, Location,
		[Value](FRHIComputeCommandList& RHICmdList, FRHIUnorderedAccessView* UAV)
		{ RHICmdList.ClearUAVUint(UAV, FUintVector4(Value, Value, Value, Value)); });
}

void AddClearUAVFloatPass(
	FRDGBuilder& GraphBuilder, FRDGBufferUAVRef BufferUAV, float Value, Drydock::FSourceLocation Location)
{
	AddClearPass<FClearBufferUAVParameters>(GraphBuilder, BufferUAV, Location,
		[Value](FRHIComputeCommandList& RHICmdList, FRHIUnorderedAccessView* UAV)
		{ RHICmdList.ClearUAVFloat(UAV, FVector4f(Value, Value, Value, Value)); });
}

void AddClearUAVPass(FRDGBuilder& GraphBuilder, FRDGTextureUAVRef TextureUAV, const FUintVector4& ClearValues,
	Drydock::FSourceLocation Location)
{
	AddClearPass<FClearTextureUAVParameters>(GraphBuilder, TextureUAV, Location,
		[ClearValues](FRHIComputeCommandList& RHICmdList, FRHIUnorderedAccessView* UAV)
		{ RHICmdList.ClearUAVUint(UAV, ClearValues); });
}

void AddClearUAVPass(FRDGBuilder& GraphBuilder, FRDGTextureUAVRef TextureUAV, const FVector4f& ClearValues,
	Drydock::FSourceLocation Location)
{
	AddClearPass<FClearTextureUAVParameters>(GraphBuilder, TextureUAV, Location,
		[ClearValues](FRHIComputeCommandList& RHICmdList, FRHIUnorderedAccessView* UAV)
		{ RHICmdList.ClearUAVFloat(UAV, ClearValues); });
}

void AddClearUAVPass(FRDGBuilder& GraphBuilder, FRDGTextureUAVRef TextureUAV, const FLinearColor& ClearColor,
	Drydock::FSourceLocation Location)
{
	AddClearUAVPass(
		GraphBuilder, TextureUAV, FVector4f(ClearColor.R, ClearColor.G, ClearColor.B, ClearColor.A), Location);
}

void AddClearUAVPass(FRDGBuilder& GraphBuilder, FRDGTextureUAVRef TextureUAV, const float (&ClearValues)[4],
	Drydock::FSourceLocation Location)
{
	AddClearUAVPass(
		GraphBuilder, TextureUAV, FVector4f(ClearValues[0], ClearValues[1], ClearValues[2], ClearValues[3]), Location);
}

void AddClearUAVPass(FRDGBuilder& GraphBuilder, FRDGTextureUAVRef TextureUAV, const uint32 (&ClearValues)[4],
	Drydock::FSourceLocation Location)
{
	AddClearUAVPass(GraphBuilder, TextureUAV,
		FUintVector4(ClearValues[0], ClearValues[1], ClearValues[2], ClearValues[3]), Location);
}

void AddEnqueueCopyPass(FRDGBuilder& GraphBuilder, FRHIGPUTextureReadback* Readback, FRDGTextureRef SourceTexture,
	FResolveRect Rect, Drydock::FSourceLocation Location)
{
	GraphBuilder.CheckArgument(SourceTexture, "AddEnqueueCopyPass", "SourceTexture", &Location);
	Drydock::CheckReadback(Readback, Location);
	const FIntRect Area = Rect.IsValid() ? FIntRect(Rect.X1, Rect.Y1, Rect.X2, Rect.Y2)
										 : FIntRect(FIntPoint(0, 0), SourceTexture->Desc.Extent);
	Drydock::CheckReadbackRect(SourceTexture, Area, Location);
	AddReadbackTexturePass(
		GraphBuilder, RDG_EVENT_NAME("EnqueueCopy(%s)", SourceTexture->Name), SourceTexture,
		[Readback, SourceTexture, Area](FRHICommandList& RHICmdList)
		{
			Readback->EnqueueCopy(RHICmdList, SourceTexture->GetRHI(), FIntVector(Area.Min.X, Area.Min.Y, 0), 0,
				FIntVector(Area.Width(), Area.Height(), 1));
		},
		Location);
}

void AddEnqueueCopyPass(FRDGBuilder& GraphBuilder, FRHIGPUBufferReadback* Readback, FRDGBufferRef SourceBuffer,
	uint32 NumBytes, Drydock::FSourceLocation Location)
{
	GraphBuilder.CheckArgument(SourceBuffer, "AddEnqueueCopyPass", "SourceBuffer", &Location);
	Drydock::CheckReadback(Readback, Location);
	Drydock::CheckBufferCopy(*SourceBuffer, 0, NumBytes, "AddEnqueueCopyPass", Location);
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
	if (!Texture)
	{
		Drydock::ThrowRDGError(
			Drydock::RDGErrorNullArgument, "the parameter is null", "RegisterExternalTexture, parameter Texture");
	}
	return GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Texture, NameIfUnregistered));
}
