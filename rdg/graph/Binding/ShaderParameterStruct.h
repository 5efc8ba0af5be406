// Shaders whose parameters are a struct: binding it, checking it, and dropping what the shader does not read.
// Source: engine ShaderParameterStruct.h; ClearUnusedGraphResources is the engine's RenderGraphUtils.h.
#pragma once

#include "CoreMinimal.h"
#include "RHICommandList.h"
#include "Shader.h"
#include "ShaderBinding.h"
#include "ShaderParameterMacros.h"

#include <initializer_list>

/** In the body of a shader class that has an FParameters: constructors, and the struct as its root parameters. */
#define SHADER_USE_PARAMETER_STRUCT(ShaderClass, ShaderParentClass) \
public: \
	ShaderClass() = default; \
	ShaderClass(const ShaderMetaType::CompiledShaderInitializerType& Initializer) \
		: ShaderParentClass(Initializer) \
	{ \
	} \
	static const FShaderParametersMetadata* GetRootParametersMetadata() \
	{ \
		return FParameters::FTypeInfo::GetStructMetadata(); \
	}

/** The same: the difference in the engine is how older base classes bind. */
#define SHADER_USE_PARAMETER_STRUCT_WITH_LEGACY_BASE(ShaderClass, ShaderParentClass) \
	SHADER_USE_PARAMETER_STRUCT(ShaderClass, ShaderParentClass)
#define SHADER_USE_ROOT_PARAMETER_STRUCT(ShaderClass, ShaderParentClass) \
	SHADER_USE_PARAMETER_STRUCT(ShaderClass, ShaderParentClass)

/** Throws DD2015 when a resource that the shader reads is null; the message names shader, struct and member. */
DRYDOCK_API void ValidateShaderParameters(
	const TShaderRef<FShader>& Shader, const FShaderParametersMetadata* ParametersMetadata, const void* Parameters);

template<typename TShaderClass>
void ValidateShaderParameters(
	const TShaderRef<TShaderClass>& Shader, const typename TShaderClass::FParameters& Parameters)
{
	ValidateShaderParameters(
		TShaderRef<FShader>(Shader), TShaderClass::FParameters::FTypeInfo::GetStructMetadata(), &Parameters);
}

/** Nulls the graph resources (textures, views, uniform buffers) that none of the shaders reads, so that the pass does
 * not depend on them. Render targets and bare accesses stay. ExcludeList: resources to keep in any case. */
DRYDOCK_API void ClearUnusedGraphResources(const TShaderRef<FShader>& Shader,
	const FShaderParametersMetadata* ParametersMetadata, void* InoutParameters,
	std::initializer_list<FRDGResource*> ExcludeList = {});
DRYDOCK_API void ClearUnusedGraphResources(const TShaderRef<FShader>& ShaderA, const TShaderRef<FShader>& ShaderB,
	const FShaderParametersMetadata* ParametersMetadata, void* InoutParameters,
	std::initializer_list<FRDGResource*> ExcludeList = {});

template<typename TShaderClass>
void ClearUnusedGraphResources(const TShaderRef<TShaderClass>& Shader,
	typename TShaderClass::FParameters* InoutParameters, std::initializer_list<FRDGResource*> ExcludeList = {})
{
	ClearUnusedGraphResources(TShaderRef<FShader>(Shader), TShaderClass::FParameters::FTypeInfo::GetStructMetadata(),
		InoutParameters, ExcludeList);
}

template<typename TShaderClassA, typename TShaderClassB, typename TPassParameters>
void ClearUnusedGraphResources(const TShaderRef<TShaderClassA>& ShaderA, const TShaderRef<TShaderClassB>& ShaderB,
	TPassParameters* InoutParameters, std::initializer_list<FRDGResource*> ExcludeList = {})
{
	ClearUnusedGraphResources(TShaderRef<FShader>(ShaderA), TShaderRef<FShader>(ShaderB),
		TPassParameters::FTypeInfo::GetStructMetadata(), InoutParameters, ExcludeList);
}

/** Inside a pass: binds Parameters to the shader for the dispatches and draws that follow, with the same checks. */
template<typename TRHICmdList, typename TShaderClass, typename TShaderRHI>
void SetShaderParameters(TRHICmdList& RHICmdList, const TShaderRef<TShaderClass>& Shader, TShaderRHI*,
	const FShaderParametersMetadata* ParametersMetadata, const void* Parameters)
{
	if (!Drydock::IsRun(TShaderRef<FShader>(Shader)))
	{
		return;
	}
	Drydock::FBoundShader Bound;
	Drydock::BindShaderParameters(TShaderRef<FShader>(Shader), *ParametersMetadata, Parameters, Bound);
	if constexpr (std::is_same_v<TShaderRHI, FRHIComputeShader>)
	{
		RHICmdList.SetBoundComputeShader(std::move(Bound));
	}
	else if constexpr (std::is_same_v<TShaderRHI, FRHIVertexShader>)
	{
		RHICmdList.SetBoundVertexShader(std::move(Bound));
	}
	else
	{
		RHICmdList.SetBoundPixelShader(std::move(Bound));
	}
}

template<typename TRHICmdList, typename TShaderClass, typename TShaderRHI>
void SetShaderParameters(TRHICmdList& RHICmdList, const TShaderRef<TShaderClass>& Shader, TShaderRHI* ShaderRHI,
	const typename TShaderClass::FParameters& Parameters)
{
	SetShaderParameters(
		RHICmdList, Shader, ShaderRHI, TShaderClass::FParameters::FTypeInfo::GetStructMetadata(), &Parameters);
}

/** The same in two steps: FRHICommandList::SetBatchedShaderParameters sets what is bound here. */
template<typename TShaderClass>
void SetShaderParameters(FRHIBatchedShaderParameters& BatchedParameters, const TShaderRef<TShaderClass>& Shader,
	const FShaderParametersMetadata* ParametersMetadata, const void* Parameters)
{
	if (Drydock::IsRun(TShaderRef<FShader>(Shader)))
	{
		Drydock::BindShaderParameters(
			TShaderRef<FShader>(Shader), *ParametersMetadata, Parameters, BatchedParameters.Bound);
	}
}

template<typename TShaderClass>
void SetShaderParameters(FRHIBatchedShaderParameters& BatchedParameters, const TShaderRef<TShaderClass>& Shader,
	const typename TShaderClass::FParameters& Parameters)
{
	SetShaderParameters(
		BatchedParameters, Shader, TShaderClass::FParameters::FTypeInfo::GetStructMetadata(), &Parameters);
}

/** Nothing to undo: bound views end with the pass. */
template<typename TRHICmdList, typename TShaderClass>
void UnsetShaderUAVs(TRHICmdList&, const TShaderRef<TShaderClass>&, FRHIComputeShader*)
{
}

template<typename TRHICmdList, typename TShaderClass>
void UnsetShaderSRVs(TRHICmdList&, const TShaderRef<TShaderClass>&, FRHIComputeShader*)
{
}
