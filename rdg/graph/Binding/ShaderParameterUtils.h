// Sets parameters one by one, by the names that a shader class has bound. Source: engine ShaderParameterUtils.h. A
// value is copied byte by byte to the shader's constant, as the engine does it. A value that is not set is 0; a
// resource that is read and not set is an error (DD2015) of the dispatch or draw.
#pragma once

#include "RHICommandList.h"
#include "ShaderParameterStruct.h"
#include "ShaderParameters.h"

#include <type_traits>

namespace Drydock
{

/** Copies the bytes to the constant, Offset bytes behind its beginning; Bound becomes one of the parameter's shader. */
DRYDOCK_API void SetNamedValue(
	FBoundShader& Bound, const FShaderResourceParameter& Parameter, const void* Value, uint32 NumBytes, uint32 Element);
DRYDOCK_API void SetNamedTexture(FBoundShader& Bound, const FShaderResourceParameter& Parameter, FRHITexture* Texture);
DRYDOCK_API void SetNamedSampler(
	FBoundShader& Bound, const FShaderResourceParameter& Parameter, FRHISamplerState* Sampler);
DRYDOCK_API void SetNamedView(
	FBoundShader& Bound, const FShaderResourceParameter& Parameter, FRHIShaderResourceView* View);
DRYDOCK_API void SetNamedView(
	FBoundShader& Bound, const FShaderResourceParameter& Parameter, FRHIUnorderedAccessView* View);

} // namespace Drydock

template<typename T>
void SetShaderValue(
	FRHIBatchedShaderParameters& Batched, const FShaderParameter& Parameter, const T& Value, uint32 ElementIndex = 0)
{
	static_assert(!std::is_pointer_v<T> && !std::is_same_v<T, double>, "a shader takes no pointers and no doubles");
	if constexpr (std::is_same_v<T, bool>)
	{
		SetShaderValue(Batched, Parameter, uint32(Value), ElementIndex);
	}
	else
	{
		Drydock::SetNamedValue(Batched.Bound, Parameter, &Value, sizeof(T), ElementIndex);
	}
}

template<typename T>
void SetShaderValueArray(FRHIBatchedShaderParameters& Batched, const FShaderParameter& Parameter, const T* Values,
	uint32 NumElements, uint32 BaseElementIndex = 0)
{
	for (uint32 i = 0; i < NumElements; ++i)
	{
		SetShaderValue(Batched, Parameter, Values[i], BaseElementIndex + i);
	}
}

inline void SetTextureParameter(
	FRHIBatchedShaderParameters& Batched, const FShaderResourceParameter& Parameter, FRHITexture* Texture)
{
	Drydock::SetNamedTexture(Batched.Bound, Parameter, Texture);
}

inline void SetSamplerParameter(
	FRHIBatchedShaderParameters& Batched, const FShaderResourceParameter& Parameter, FRHISamplerState* Sampler)
{
	Drydock::SetNamedSampler(Batched.Bound, Parameter, Sampler);
}

inline void SetTextureParameter(FRHIBatchedShaderParameters& Batched, const FShaderResourceParameter& Texture,
	const FShaderResourceParameter& Sampler, FRHISamplerState* SamplerState, FRHITexture* TextureRHI)
{
	SetTextureParameter(Batched, Texture, TextureRHI);
	SetSamplerParameter(Batched, Sampler, SamplerState);
}

inline void SetSRVParameter(
	FRHIBatchedShaderParameters& Batched, const FShaderResourceParameter& Parameter, FRHIShaderResourceView* View)
{
	Drydock::SetNamedView(Batched.Bound, Parameter, View);
}

inline void SetUAVParameter(
	FRHIBatchedShaderParameters& Batched, const FShaderResourceParameter& Parameter, FRHIUnorderedAccessView* View)
{
	Drydock::SetNamedView(Batched.Bound, Parameter, View);
}

/** The forms of engines before 5.3 set at once what the batched forms collect. */
#define DRYDOCK_SET_AT_ONCE(Function) \
	template<typename TRHICmdList, typename TShaderRHI, typename... TArguments> \
	requires(std::is_base_of_v<FRHICommandListBase, TRHICmdList>) void Function( \
		TRHICmdList& RHICmdList, TShaderRHI* ShaderRHI, const TArguments&... Arguments) \
	{ \
		FRHIBatchedShaderParameters Parameters; \
		Parameters.Bound = std::move(RHICmdList.GetBound(ShaderRHI)); \
		Function(Parameters, Arguments...); \
		RHICmdList.GetBound(ShaderRHI) = std::move(Parameters.Bound); \
	}
DRYDOCK_SET_AT_ONCE(SetShaderValue)
DRYDOCK_SET_AT_ONCE(SetShaderValueArray)
DRYDOCK_SET_AT_ONCE(SetTextureParameter)
DRYDOCK_SET_AT_ONCE(SetSamplerParameter)
DRYDOCK_SET_AT_ONCE(SetSRVParameter)
DRYDOCK_SET_AT_ONCE(SetUAVParameter)
#undef DRYDOCK_SET_AT_ONCE

// Parameters of a shader class that sets them by a SetParameters of its own (engine 5.3 and later).
#define DRYDOCK_SET_LEGACY(Function, GetShader) \
	template<typename TRHICmdList, typename TShaderClass, typename... TArguments> \
	void Function(TRHICmdList& RHICmdList, const TShaderRef<TShaderClass>& Shader, TArguments&&... Arguments) \
	{ \
		FRHIBatchedShaderParameters& Parameters = RHICmdList.GetScratchShaderParameters(); \
		Shader->SetParameters(Parameters, std::forward<TArguments>(Arguments)...); \
		RHICmdList.SetBatchedShaderParameters(Shader.GetShader(), Parameters); \
	}
DRYDOCK_SET_LEGACY(SetShaderParametersLegacyCS, GetComputeShader)
DRYDOCK_SET_LEGACY(SetShaderParametersLegacyPS, GetPixelShader)
DRYDOCK_SET_LEGACY(SetShaderParametersLegacyVS, GetVertexShader)
#undef DRYDOCK_SET_LEGACY
