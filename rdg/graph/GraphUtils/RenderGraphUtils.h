// Small passes that every renderer needs (copies, clears, readbacks, uploads), and compute passes over a shader.
// Source: engine RenderGraphUtils.h.
#pragma once

#include "CoreMinimal.h"
#include "GlobalShader.h"
#include "RHIGPUReadback.h"
#include "RenderGraphBuilder.h"
#include "ShaderParameterStruct.h"
#include "SourceLocation.h"
#include "SystemTextures.h"

#include <type_traits>

namespace Drydock
{

/** Notes on the pass which shader it runs, so that listings know it without executing. */
DRYDOCK_API void AnnotatePass(
	FRDGPassRef Pass, const TShaderRef<FShader>& Shader, const TShaderRef<FShader>& VertexShader = {});

/** Throws DD2006 where a pass would be added without a shader or without parameters. */
DRYDOCK_API void CheckPassArguments(const char* Call, const FRDGEventName& PassName, const TShaderRef<FShader>& Shader,
	const void* Parameters, const Drydock::FSourceLocation& Location);

/** Throws DD2017 for a negative count. */
DRYDOCK_API void CheckGroupCount(
	const FRDGEventName& PassName, const FIntVector& GroupCount, const Drydock::FSourceLocation& Location);

} // namespace Drydock

/** A texture of several samples and the one that it is resolved to. Here one sample is all there is, so both are one.
 */
struct FRDGTextureMSAA
{
	FRDGTextureMSAA() = default;
	FRDGTextureMSAA(FRDGTextureRef InTarget, FRDGTextureRef InResolve)
		: Target(InTarget)
		, Resolve(InResolve)
	{
	}
	FRDGTextureMSAA(FRDGTextureRef InTexture)
		: FRDGTextureMSAA(InTexture, InTexture)
	{
	}

	/** Ours: what reads it wants the resolved one. */
	operator FRDGTextureRef() const { return Resolve; }

	bool IsValid() const { return Target != nullptr && Resolve != nullptr; }
	bool IsSeparate() const { return Target != Resolve; }
	bool operator==(const FRDGTextureMSAA&) const = default;

	FRDGTextureRef Target = nullptr;
	FRDGTextureRef Resolve = nullptr;
};

// Copies ------------------------------------------------------------------------------------------------------------

/** Copies a region of mips and slices; formats must agree. */
DRYDOCK_API void AddCopyTexturePass(FRDGBuilder& GraphBuilder, FRDGTextureRef InputTexture,
	FRDGTextureRef OutputTexture, const FRHICopyTextureInfo& CopyInfo,
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current());

/** Copies Size texels (zero: the whole input) from InputPosition to OutputPosition. */
DRYDOCK_API void AddCopyTexturePass(FRDGBuilder& GraphBuilder, FRDGTextureRef InputTexture,
	FRDGTextureRef OutputTexture, FIntPoint InputPosition = FIntPoint::ZeroValue,
	FIntPoint OutputPosition = FIntPoint::ZeroValue, FIntPoint Size = FIntPoint::ZeroValue,
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current());

DRYDOCK_API void AddCopyBufferPass(FRDGBuilder& GraphBuilder, FRDGBufferRef DstBuffer, uint64 DstOffset,
	FRDGBufferRef SrcBuffer, uint64 SrcOffset, uint64 NumBytes,
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current());
DRYDOCK_API void AddCopyBufferPass(FRDGBuilder& GraphBuilder, FRDGBufferRef DstBuffer, FRDGBufferRef SrcBuffer,
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current());

// Clears ------------------------------------------------------------------------------------------------------------

/** Clears to the texture's own clear value. */
DRYDOCK_API void AddClearRenderTargetPass(FRDGBuilder& GraphBuilder, FRDGTextureRef Texture,
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current());
DRYDOCK_API void AddClearRenderTargetPass(FRDGBuilder& GraphBuilder, FRDGTextureRef Texture,
	const FLinearColor& ClearColor, Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current());
/** Clears a rectangle; the rest stays. */
DRYDOCK_API void AddClearRenderTargetPass(FRDGBuilder& GraphBuilder, FRDGTextureRef Texture,
	const FLinearColor& ClearColor, FIntRect Viewport,
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current());

/** Planes that are not cleared keep what they hold. */
DRYDOCK_API void AddClearDepthStencilPass(FRDGBuilder& GraphBuilder, FRDGTextureRef Texture, bool bClearDepth = true,
	float Depth = 0.0f, bool bClearStencil = true, uint8 Stencil = 0,
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current());

/** Values are stored as the format stores them. */
DRYDOCK_API void AddClearUAVPass(FRDGBuilder& GraphBuilder, FRDGBufferUAVRef BufferUAV, uint32 Value,
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current());
DRYDOCK_API void AddClearUAVFloatPass(FRDGBuilder& GraphBuilder, FRDGBufferUAVRef BufferUAV, float Value,
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current());
DRYDOCK_API void AddClearUAVPass(FRDGBuilder& GraphBuilder, FRDGTextureUAVRef TextureUAV,
	const FUintVector4& ClearValues, Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current());
DRYDOCK_API void AddClearUAVPass(FRDGBuilder& GraphBuilder, FRDGTextureUAVRef TextureUAV, const FVector4f& ClearValues,
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current());
DRYDOCK_API void AddClearUAVPass(FRDGBuilder& GraphBuilder, FRDGTextureUAVRef TextureUAV,
	const FLinearColor& ClearColor, Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current());
/** Every channel to that value. */
inline void AddClearUAVPass(FRDGBuilder& GraphBuilder, FRDGTextureUAVRef TextureUAV, float ClearValue,
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current())
{
	AddClearUAVPass(GraphBuilder, TextureUAV, FVector4f(ClearValue, ClearValue, ClearValue, ClearValue), Location);
}
DRYDOCK_API void AddClearUAVPass(FRDGBuilder& GraphBuilder, FRDGTextureUAVRef TextureUAV, const float (&ClearValues)[4],
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current());
DRYDOCK_API void AddClearUAVPass(FRDGBuilder& GraphBuilder, FRDGTextureUAVRef TextureUAV,
	const uint32 (&ClearValues)[4], Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current());

// Readbacks ---------------------------------------------------------------------------------------------------------

/** The readback's data can be read right after Execute. */
DRYDOCK_API void AddEnqueueCopyPass(FRDGBuilder& GraphBuilder, FRHIGPUTextureReadback* Readback,
	FRDGTextureRef SourceTexture, FResolveRect Rect = FResolveRect(),
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current());
DRYDOCK_API void AddEnqueueCopyPass(FRDGBuilder& GraphBuilder, FRHIGPUBufferReadback* Readback,
	FRDGBufferRef SourceBuffer, uint32 NumBytes,
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current());

/** A pass that only needs Texture (or Buffer) ready to be copied from, and is never culled. */
template<typename ExecuteLambdaType>
void AddReadbackTexturePass(FRDGBuilder& GraphBuilder, FRDGEventName&& Name, FRDGTextureRef Texture,
	ExecuteLambdaType&& ExecuteLambda, Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current());
template<typename ExecuteLambdaType>
void AddReadbackBufferPass(FRDGBuilder& GraphBuilder, FRDGEventName&& Name, FRDGBufferRef Buffer,
	ExecuteLambdaType&& ExecuteLambda, Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current());

/** A pass without parameters: it always runs. */
template<typename ExecuteLambdaType>
FRDGPassRef AddPass(FRDGBuilder& GraphBuilder, FRDGEventName&& Name, ExecuteLambdaType&& ExecuteLambda,
	Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current())
{
	return GraphBuilder.AddPass(
		MoveTemp(Name), ERDGPassFlags::None, std::forward<ExecuteLambdaType>(ExecuteLambda), Location);
}

// Buffers -----------------------------------------------------------------------------------------------------------

/** A structured buffer of NumElements elements whose first InitialDataSize bytes are InitialData. */
DRYDOCK_API FRDGBufferRef CreateStructuredBuffer(FRDGBuilder& GraphBuilder, const TCHAR* Name, uint32 BytesPerElement,
	uint32 NumElements, const void* InitialData, uint64 InitialDataSize,
	ERDGInitialDataFlags InitialDataFlags = ERDGInitialDataFlags::None);

template<typename ElementType, typename AllocatorType>
FRDGBufferRef CreateStructuredBuffer(FRDGBuilder& GraphBuilder, const TCHAR* Name,
	const TArray<ElementType, AllocatorType>& Container,
	ERDGInitialDataFlags InitialDataFlags = ERDGInitialDataFlags::None)
{
	return CreateStructuredBuffer(GraphBuilder, Name, sizeof(ElementType),
		static_cast<uint32>(FMath::Max(Container.Num(), 1)), Container.GetData(),
		sizeof(ElementType) * static_cast<uint64>(Container.Num()), InitialDataFlags);
}

/** A typed vertex-style buffer with initial contents. */
DRYDOCK_API FRDGBufferRef CreateVertexBuffer(FRDGBuilder& GraphBuilder, const TCHAR* Name, const FRDGBufferDesc& Desc,
	const void* InitialData, uint64 InitialDataSize,
	ERDGInitialDataFlags InitialDataFlags = ERDGInitialDataFlags::None);

DRYDOCK_API FRDGBufferRef CreateUploadBuffer(FRDGBuilder& GraphBuilder, const TCHAR* Name, uint32 BytesPerElement,
	uint32 NumElements, const void* InitialData, uint64 InitialDataSize,
	ERDGInitialDataFlags InitialDataFlags = ERDGInitialDataFlags::None);

// External resources ------------------------------------------------------------------------------------------------

/** Registers an RHI texture under a name. */
DRYDOCK_API FRDGTextureRef RegisterExternalTexture(
	FRDGBuilder& GraphBuilder, FRHITexture* Texture, const TCHAR* NameIfUnregistered);

/** Null in, null out. */
inline FRDGTextureRef TryRegisterExternalTexture(FRDGBuilder& GraphBuilder,
	const TRefCountPtr<IPooledRenderTarget>& ExternalPooledTexture, ERDGTextureFlags Flags = ERDGTextureFlags::None)
{
	return ExternalPooledTexture.IsValid() ? GraphBuilder.RegisterExternalTexture(ExternalPooledTexture, Flags)
										   : nullptr;
}

inline FRDGBufferRef TryRegisterExternalBuffer(FRDGBuilder& GraphBuilder,
	const TRefCountPtr<FRDGPooledBuffer>& ExternalPooledBuffer, ERDGBufferFlags Flags = ERDGBufferFlags::None)
{
	return ExternalPooledBuffer.IsValid() ? GraphBuilder.RegisterExternalBuffer(ExternalPooledBuffer, Flags) : nullptr;
}

/** Makes the texture external now, and hands it over. */
inline void ConvertToExternalTexture(
	FRDGBuilder& GraphBuilder, FRDGTextureRef Texture, TRefCountPtr<IPooledRenderTarget>& OutPooledRenderTarget)
{
	OutPooledRenderTarget = GraphBuilder.ConvertToExternalTexture(Texture);
}

inline void ConvertToExternalBuffer(
	FRDGBuilder& GraphBuilder, FRDGBufferRef Buffer, TRefCountPtr<FRDGPooledBuffer>& OutPooledBuffer)
{
	OutPooledBuffer = GraphBuilder.ConvertToExternalBuffer(Buffer);
}

/** Inside a pass: the RHI object; null of null. */
inline FRHITexture* TryGetRHI(FRDGTextureRef Texture)
{
	return Texture ? Texture->GetRHI() : nullptr;
}
inline FRHIBuffer* TryGetRHI(FRDGBufferRef Buffer)
{
	return Buffer ? Buffer->GetRHI() : nullptr;
}

/** Textures of another pass's parameters that are bound as targets or views can be null; this reports whether the
 * binding has one.
 * */
inline bool HasBeenProduced(const FRenderTargetBinding& Binding)
{
	return Binding.GetTexture() && Binding.GetTexture()->HasBeenProduced();
}

// Compute -----------------------------------------------------------------------------------------------------------

/** Parameters of a pass that only draws. Source: engine ShaderParameterStruct.h. */
BEGIN_SHADER_PARAMETER_STRUCT(FRenderTargetParameters, DRYDOCK_API)
	RENDER_TARGET_BINDING_SLOTS()
END_SHADER_PARAMETER_STRUCT()

BEGIN_SHADER_PARAMETER_STRUCT(FTextureAccessDynamicParameters, DRYDOCK_API)
	RDG_TEXTURE_ACCESS(Texture, ERHIAccess::CopySrc)
END_SHADER_PARAMETER_STRUCT()

BEGIN_SHADER_PARAMETER_STRUCT(FBufferAccessDynamicParameters, DRYDOCK_API)
	RDG_BUFFER_ACCESS(Buffer, ERHIAccess::CopySrc)
END_SHADER_PARAMETER_STRUCT()

struct FComputeShaderUtils
{
	/** Good for most 2D work: 8 x 8. */
	static constexpr int32 kGolden2DGroupSize = 8;

	static constexpr int32 WrappedGroupStride = 128;

	/** Thread groups that cover the threads, rounded up on each axis. */
	static FIntVector GetGroupCount(const int32 ThreadCount, const int32 GroupSize)
	{
		return FIntVector(FMath::DivideAndRoundUp(ThreadCount, GroupSize), 1, 1);
	}
	static FIntVector GetGroupCount(const FIntPoint& ThreadCount, const FIntPoint& GroupSize)
	{
		return FIntVector(FMath::DivideAndRoundUp(ThreadCount.X, GroupSize.X),
			FMath::DivideAndRoundUp(ThreadCount.Y, GroupSize.Y), 1);
	}
	static FIntVector GetGroupCount(const FIntPoint& ThreadCount, const int32 GroupSize)
	{
		return GetGroupCount(ThreadCount, FIntPoint(GroupSize, GroupSize));
	}
	static FIntVector GetGroupCount(const FIntPoint& ThreadCount, const FIntVector& GroupSize)
	{
		return GetGroupCount(ThreadCount, FIntPoint(GroupSize.X, GroupSize.Y));
	}
	static FIntVector GetGroupCount(const FIntVector& ThreadCount, const FIntVector& GroupSize)
	{
		return FIntVector(FMath::DivideAndRoundUp(ThreadCount.X, GroupSize.X),
			FMath::DivideAndRoundUp(ThreadCount.Y, GroupSize.Y), FMath::DivideAndRoundUp(ThreadCount.Z, GroupSize.Z));
	}
	static FIntVector GetGroupCount(const FIntVector& ThreadCount, const int32 GroupSize)
	{
		return GetGroupCount(ThreadCount, FIntVector(GroupSize, GroupSize, GroupSize));
	}

	/** One-dimensional counts beyond what a GPU dispatches on one axis, wrapped to rows of WrappedGroupStride. */
	static FIntVector GetGroupCountWrapped(const int32 TargetGroupCount)
	{
		const int32 Stride = WrappedGroupStride;
		return TargetGroupCount <= 65535 ? FIntVector(TargetGroupCount, 1, 1)
										 : FIntVector(Stride, FMath::DivideAndRoundUp(TargetGroupCount, Stride), 1);
	}
	static FIntVector GetGroupCountWrapped(const int32 ThreadCount, const int32 GroupSize)
	{
		return GetGroupCountWrapped(FMath::DivideAndRoundUp(ThreadCount, GroupSize));
	}

	/** A check where a count is negative. */
	static void ValidateGroupCount(const FIntVector& GroupCount)
	{
		checkf(GroupCount.X >= 0 && GroupCount.Y >= 0 && GroupCount.Z >= 0, TEXT("a dispatch of %d x %d x %d groups"),
			GroupCount.X, GroupCount.Y, GroupCount.Z);
	}
	/** A check where three counts do not lie in the buffer from the offset on. */
	static void ValidateIndirectArgsBuffer(uint32 IndirectArgsBufferSize, uint32 IndirectArgOffset)
	{
		checkf(IndirectArgOffset % sizeof(uint32) == 0 &&
				   uint64(IndirectArgOffset) + 3 * sizeof(uint32) <= IndirectArgsBufferSize,
			TEXT("arguments of a dispatch at byte %u of a buffer of %u"), IndirectArgOffset, IndirectArgsBufferSize);
	}
	static void ValidateIndirectArgsBuffer(FRDGBufferRef IndirectArgsBuffer, uint32 IndirectArgOffset)
	{
		ValidateIndirectArgsBuffer(static_cast<uint32>(IndirectArgsBuffer->Desc.GetSize()), IndirectArgOffset);
	}

	/** Inside a pass: binds and dispatches. */
	template<typename TShaderClass>
	static void Dispatch(FRHIComputeCommandList& RHICmdList, const TShaderRef<TShaderClass>& ComputeShader,
		const typename TShaderClass::FParameters& Parameters, FIntVector GroupCount)
	{
		Dispatch(RHICmdList, ComputeShader, TShaderClass::FParameters::FTypeInfo::GetStructMetadata(), &Parameters,
			GroupCount);
	}

	template<typename TShaderClass>
	static void Dispatch(FRHIComputeCommandList& RHICmdList, const TShaderRef<TShaderClass>& ComputeShader,
		const FShaderParametersMetadata* ParametersMetadata, const void* Parameters, FIntVector GroupCount)
	{
		FRHIComputeShader* ShaderRHI = ComputeShader.GetComputeShader();
		RHICmdList.SetComputePipelineState(ShaderRHI);
		SetShaderParameters(RHICmdList, ComputeShader, ShaderRHI, ParametersMetadata, Parameters);
		RHICmdList.DispatchComputeShader(
			static_cast<uint32>(GroupCount.X), static_cast<uint32>(GroupCount.Y), static_cast<uint32>(GroupCount.Z));
		UnsetShaderUAVs(RHICmdList, ComputeShader, ShaderRHI);
	}

	template<typename TShaderClass>
	static void DispatchIndirect(FRHIComputeCommandList& RHICmdList, const TShaderRef<TShaderClass>& ComputeShader,
		const typename TShaderClass::FParameters& Parameters, FRHIBuffer* IndirectArgsBuffer, uint32 IndirectArgOffset)
	{
		FRHIComputeShader* ShaderRHI = ComputeShader.GetComputeShader();
		RHICmdList.SetComputePipelineState(ShaderRHI);
		SetShaderParameters(RHICmdList, ComputeShader, ShaderRHI, Parameters);
		RHICmdList.DispatchIndirectComputeShader(IndirectArgsBuffer, IndirectArgOffset);
		UnsetShaderUAVs(RHICmdList, ComputeShader, ShaderRHI);
	}

	template<typename TShaderClass>
	static void DispatchIndirect(FRHIComputeCommandList& RHICmdList, const TShaderRef<TShaderClass>& ComputeShader,
		const typename TShaderClass::FParameters& Parameters, FRDGBufferRef IndirectArgsBuffer,
		uint32 IndirectArgOffset)
	{
		DispatchIndirect(
			RHICmdList, ComputeShader, Parameters, IndirectArgsBuffer->GetIndirectRHICallBuffer(), IndirectArgOffset);
	}

	/** Adds a pass that dispatches the shader. Members of Parameters that it does not read are dropped first. */
	template<typename TShaderClass>
	static FRDGPassRef AddPass(FRDGBuilder& GraphBuilder, FRDGEventName&& PassName, ERDGPassFlags PassFlags,
		const TShaderRef<TShaderClass>& ComputeShader, typename TShaderClass::FParameters* Parameters,
		FIntVector GroupCount, Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current())
	{
		return AddPass(GraphBuilder, MoveTemp(PassName), PassFlags, ComputeShader,
			TShaderClass::FParameters::FTypeInfo::GetStructMetadata(), Parameters, GroupCount, Location);
	}

	template<typename TShaderClass>
	static FRDGPassRef AddPass(FRDGBuilder& GraphBuilder, FRDGEventName&& PassName,
		const TShaderRef<TShaderClass>& ComputeShader, typename TShaderClass::FParameters* Parameters,
		FIntVector GroupCount, Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current())
	{
		return AddPass(
			GraphBuilder, MoveTemp(PassName), ERDGPassFlags::Compute, ComputeShader, Parameters, GroupCount, Location);
	}

	/** The same with the parameters' metadata given apart. */
	template<typename TShaderClass>
	static FRDGPassRef AddPass(FRDGBuilder& GraphBuilder, FRDGEventName&& PassName, ERDGPassFlags PassFlags,
		const TShaderRef<TShaderClass>& ComputeShader, const FShaderParametersMetadata* ParametersMetadata,
		void* Parameters, FIntVector GroupCount,
		Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current())
	{
		Drydock::CheckGroupCount(PassName, GroupCount, Location);
		Drydock::CheckPassArguments(
			"FComputeShaderUtils::AddPass", PassName, TShaderRef<FShader>(ComputeShader), Parameters, Location);
		ClearUnusedGraphResources(TShaderRef<FShader>(ComputeShader), ParametersMetadata, Parameters);
		FRDGPassRef Pass = GraphBuilder.AddPass(
			MoveTemp(PassName), ParametersMetadata, Parameters, PassFlags,
			[ParametersMetadata, Parameters, ComputeShader, GroupCount](FRHIComputeCommandList& RHICmdList)
			{ Dispatch(RHICmdList, ComputeShader, ParametersMetadata, Parameters, GroupCount); },
			Location);
		Drydock::AnnotatePass(Pass, ComputeShader);
		return Pass;
	}

	/** The same with a group count that is known only when the pass runs. */
	template<typename TShaderClass>
	static FRDGPassRef AddPass(FRDGBuilder& GraphBuilder, FRDGEventName&& PassName,
		const TShaderRef<TShaderClass>& ComputeShader, typename TShaderClass::FParameters* Parameters,
		TFunction<FIntVector()>&& GroupCountCallback,
		Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current())
	{
		return AddPass(GraphBuilder, MoveTemp(PassName), ERDGPassFlags::Compute, ComputeShader, Parameters,
			MoveTemp(GroupCountCallback), Location);
	}

	template<typename TShaderClass>
	static FRDGPassRef AddPass(FRDGBuilder& GraphBuilder, FRDGEventName&& PassName, ERDGPassFlags PassFlags,
		const TShaderRef<TShaderClass>& ComputeShader, typename TShaderClass::FParameters* Parameters,
		TFunction<FIntVector()>&& GroupCountCallback,
		Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current())
	{
		Drydock::CheckPassArguments(
			"FComputeShaderUtils::AddPass", PassName, TShaderRef<FShader>(ComputeShader), Parameters, Location);
		ClearUnusedGraphResources(ComputeShader, Parameters);
		FRDGPassRef Pass = GraphBuilder.AddPass(
			MoveTemp(PassName), Parameters, PassFlags,
			[Parameters, ComputeShader, Callback = MoveTemp(GroupCountCallback)](FRHIComputeCommandList& RHICmdList)
			{ Dispatch(RHICmdList, ComputeShader, *Parameters, Callback()); },
			Location);
		Drydock::AnnotatePass(Pass, ComputeShader);
		return Pass;
	}

	/** Indirect: the group count is in IndirectArgsBuffer, which must be the parameters' IndirectArgs access. */
	template<typename TShaderClass>
	static FRDGPassRef AddPass(FRDGBuilder& GraphBuilder, FRDGEventName&& PassName, ERDGPassFlags PassFlags,
		const TShaderRef<TShaderClass>& ComputeShader, typename TShaderClass::FParameters* Parameters,
		FRDGBufferRef IndirectArgsBuffer, uint32 IndirectArgsOffset,
		Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current())
	{
		GraphBuilder.CheckArgument(IndirectArgsBuffer, "FComputeShaderUtils::AddPass", "IndirectArgsBuffer", &Location);
		Drydock::CheckPassArguments(
			"FComputeShaderUtils::AddPass", PassName, TShaderRef<FShader>(ComputeShader), Parameters, Location);
		ClearUnusedGraphResources(ComputeShader, Parameters, {IndirectArgsBuffer});
		FRDGPassRef Pass = GraphBuilder.AddPass(
			MoveTemp(PassName), Parameters, PassFlags,
			[Parameters, ComputeShader, IndirectArgsBuffer, IndirectArgsOffset](FRHIComputeCommandList& RHICmdList)
			{
				DispatchIndirect(RHICmdList, ComputeShader, *Parameters, IndirectArgsBuffer->GetIndirectRHICallBuffer(),
					IndirectArgsOffset);
			},
			Location);
		Drydock::AnnotatePass(Pass, ComputeShader);
		return Pass;
	}

	template<typename TShaderClass>
	static FRDGPassRef AddPass(FRDGBuilder& GraphBuilder, FRDGEventName&& PassName,
		const TShaderRef<TShaderClass>& ComputeShader, typename TShaderClass::FParameters* Parameters,
		FRDGBufferRef IndirectArgsBuffer, uint32 IndirectArgsOffset,
		Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current())
	{
		return AddPass(GraphBuilder, MoveTemp(PassName), ERDGPassFlags::Compute, ComputeShader, Parameters,
			IndirectArgsBuffer, IndirectArgsOffset, Location);
	}
};

template<typename ExecuteLambdaType>
void AddReadbackTexturePass(FRDGBuilder& GraphBuilder, FRDGEventName&& Name, FRDGTextureRef Texture,
	ExecuteLambdaType&& ExecuteLambda, Drydock::FSourceLocation Location)
{
	GraphBuilder.CheckArgument(Texture, "AddReadbackTexturePass", "Texture", &Location);
	auto* Parameters = GraphBuilder.AllocParameters<FTextureAccessDynamicParameters>();
	Parameters->Texture = Texture;
	GraphBuilder.AddPass(
		MoveTemp(Name), Parameters, ERDGPassFlags::Readback, std::forward<ExecuteLambdaType>(ExecuteLambda), Location);
}

template<typename ExecuteLambdaType>
void AddReadbackBufferPass(FRDGBuilder& GraphBuilder, FRDGEventName&& Name, FRDGBufferRef Buffer,
	ExecuteLambdaType&& ExecuteLambda, Drydock::FSourceLocation Location)
{
	GraphBuilder.CheckArgument(Buffer, "AddReadbackBufferPass", "Buffer", &Location);
	auto* Parameters = GraphBuilder.AllocParameters<FBufferAccessDynamicParameters>();
	Parameters->Buffer = Buffer;
	GraphBuilder.AddPass(
		MoveTemp(Name), Parameters, ERDGPassFlags::Readback, std::forward<ExecuteLambdaType>(ExecuteLambda), Location);
}
