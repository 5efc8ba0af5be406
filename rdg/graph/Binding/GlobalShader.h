// Global shaders: those that belong to no material. Source: engine GlobalShader.h.
#pragma once

#include "CoreMinimal.h"
#include "RHI.h"
#include "RHIDefinitions.h"
#include "Shader.h"
#include "ShaderParameterMacros.h"
#include "ShaderParameterStruct.h"

struct FGlobalShaderPermutationParameters : public FShaderPermutationParameters
{
	explicit FGlobalShaderPermutationParameters(EShaderPlatform InPlatform, int32 InPermutationId = 0)
		: FShaderPermutationParameters(InPlatform, InPermutationId)
	{
	}
};

class DRYDOCK_API FGlobalShaderType : public FShaderType
{
public:
	using FPermutationParameters = FGlobalShaderPermutationParameters;
	using FShaderType::FShaderType;
};

/** Base of every shader class. Its statics may be redefined: ShouldCompilePermutation, ModifyCompilationEnvironment. */
class DRYDOCK_API FGlobalShader : public FShader
{
public:
	using FPermutationParameters = FGlobalShaderPermutationParameters;
	using ShaderMetaType = FGlobalShaderType;

	FGlobalShader() = default;
	FGlobalShader(const ShaderMetaType::CompiledShaderInitializerType& Initializer)
		: FShader(Initializer)
	{
	}

	static bool ShouldCompilePermutation(const FGlobalShaderPermutationParameters&) { return true; }
	static void ModifyCompilationEnvironment(const FGlobalShaderPermutationParameters&, FShaderCompilerEnvironment&) {}

	/** View of a shader that binds by name. Here it comes with the shader's FParameters, which sets it. */
	template<typename TViewUniformShaderParameters>
	static void SetParameters(FRHIBatchedShaderParameters&, FRHIUniformBuffer*)
	{
	}
};

/** Finds global shaders. There is one map: a CPU is one platform. */
class DRYDOCK_API FGlobalShaderMap
{
public:
	/** A check when the class refuses the permutation. */
	template<typename TShaderClass>
	TShaderRef<TShaderClass> GetShader(int32 PermutationId = 0) const
	{
		return TShaderRef<TShaderClass>(
			static_cast<TShaderClass*>(TShaderClass::GetStaticType().FindOrCreateShader(PermutationId)));
	}

	template<typename TShaderClass>
	TShaderRef<TShaderClass> GetShader(const typename TShaderClass::FPermutationDomain& PermutationVector) const
	{
		return GetShader<TShaderClass>(PermutationVector.ToDimensionValueId());
	}
};

DRYDOCK_API FGlobalShaderMap* GetGlobalShaderMap(ERHIFeatureLevel::Type FeatureLevel);
DRYDOCK_API FGlobalShaderMap* GetGlobalShaderMap(EShaderPlatform Platform);

/** `TShaderMapRef<FMyCS> Shader(View.ShaderMap, PermutationVector);` */
template<typename TShaderClass>
class TShaderMapRef : public TShaderRef<TShaderClass>
{
public:
	explicit TShaderMapRef(const FGlobalShaderMap* Map)
		: TShaderRef<TShaderClass>(Map->GetShader<TShaderClass>(0))
	{
	}
	TShaderMapRef(const FGlobalShaderMap* Map, int32 PermutationId)
		: TShaderRef<TShaderClass>(Map->GetShader<TShaderClass>(PermutationId))
	{
	}
	TShaderMapRef(const FGlobalShaderMap* Map, const typename TShaderClass::FPermutationDomain& PermutationVector)
		: TShaderRef<TShaderClass>(Map->GetShader<TShaderClass>(PermutationVector))
	{
	}
};

#define DECLARE_GLOBAL_SHADER(ShaderClass) DECLARE_SHADER_TYPE(ShaderClass, Global)

/** At namespace scope: `IMPLEMENT_GLOBAL_SHADER(FMyPS, "/Project/My.usf", "MainPS", SF_Pixel);` */
#define IMPLEMENT_GLOBAL_SHADER(ShaderClass, SourceFilename, FunctionName, Frequency) \
	IMPLEMENT_SHADER_TYPE(, ShaderClass, TEXT(SourceFilename), TEXT(FunctionName), Frequency)

namespace Drydock
{

/** Calls Function for every global shader class of the library and the plugins loaded so far, ordered by name. */
DRYDOCK_API void ForEachGlobalShader(TFunctionRef<void(const FGlobalShaderType&)> Function);

} // namespace Drydock
