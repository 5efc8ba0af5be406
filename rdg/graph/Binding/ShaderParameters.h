// Parameters that a shader class binds one by one, by name, as plugins wrote it before parameter structs. Source:
// engine files ShaderParameters.h, MemoryLayout.h.
#pragma once

#include "CoreMinimal.h"
#include "Shader.h"
#include "ShaderParameterMacros.h"

#include <string>

/** Says if a shader must have a parameter of the name. Nothing happens here in either case, because a shader may have
 * removed a parameter that it does not read. */
enum EShaderParameterFlags
{
	SPF_Optional,
	SPF_Mandatory
};

/** A name, and the shader permutation whose parameter it is. */
class DRYDOCK_API FShaderResourceParameter
{
public:
	void Bind(const FShaderParameterMap& Map, const TCHAR* ParameterName, EShaderParameterFlags = SPF_Optional)
	{
		Type = Map.Type;
		PermutationId = Map.PermutationId;
		Name = ParameterName;
	}
	/** True if the compiled shader reads it. */
	bool IsBound() const;

	FShader* FindShader() const { return Type ? Type->FindOrCreateShader(PermutationId) : nullptr; } // ours
	const std::string& GetName() const { return Name; }                                              // ours

private:
	const FShaderType* Type = nullptr;
	int32 PermutationId = 0;
	std::string Name;
};

/** The same of a number, a vector or a matrix. */
class FShaderParameter : public FShaderResourceParameter
{
public:
	bool IsInitialized() const { return !GetName().empty(); }
};

/** A buffer or texture that one shader reads as NAME and another writes as RWNAME. */
class FRWShaderParameter
{
public:
	void Bind(const FShaderParameterMap& Map, const TCHAR* BaseName)
	{
		SRVParameter.Bind(Map, BaseName);
		UAVParameter.Bind(Map, (std::string("RW") + BaseName).c_str());
	}
	bool IsBound() const { return SRVParameter.IsBound() || UAVParameter.IsBound(); }
	bool IsUAVBound() const { return UAVParameter.IsBound(); }

	/** Sets both, of which the shader has one. */
	template<typename TRHICmdList, typename TShaderRHI>
	void SetTexture(
		TRHICmdList& RHICmdList, TShaderRHI* ShaderRHI, FRHITexture* Texture, FRHIUnorderedAccessView* UAV) const
	{
		SetTextureParameter(RHICmdList, ShaderRHI, SRVParameter, Texture);
		SetUAVParameter(RHICmdList, ShaderRHI, UAVParameter, UAV);
	}
	template<typename TRHICmdList, typename TShaderRHI>
	void UnsetUAV(TRHICmdList&, TShaderRHI*) const
	{
	}

private:
	FShaderResourceParameter SRVParameter;
	FShaderResourceParameter UAVParameter;
};

/** Type with that alignment in bytes. */
template<typename T, int32 Alignment>
struct TAlignedTypedef
{
	typedef T Type __attribute__((aligned(Alignment)));
};

/** Members of a shader class in the engine's frozen memory images; plain members here. */
#define DECLARE_TYPE_LAYOUT(T, Interface)
#define DECLARE_INLINE_TYPE_LAYOUT(T, Interface)
#define DECLARE_EXPORTED_TYPE_LAYOUT(T, RequiredAPI, Interface)
#define DECLARE_INLINE_TYPE_LAYOUT_EXPLICIT_BASES(T, Interface, ...)
#define DECLARE_TYPE_LAYOUT_EXPLICIT_BASES(T, Interface, ...)
#define IMPLEMENT_TYPE_LAYOUT(T)
#define IMPLEMENT_ABSTRACT_TYPE_LAYOUT(T)
#define IMPLEMENT_TEMPLATE_TYPE_LAYOUT(TemplatePrefix, T)
#define LAYOUT_FIELD(T, Name, ...) T Name;
#define LAYOUT_ARRAY(T, Name, NumArray, ...) T Name[NumArray];
