// Shader classes: the type that IMPLEMENT_ registers, the instance per permutation that TShaderMapRef hands out, and
// the registry of all types loaded so far. Nothing is compiled until a pass binds the shader. Source: engine Shader.h.
#pragma once

#include "CoreMinimal.h"
#include "RHIDefinitions.h"
#include "RHIResources.h"
#include "RunningCode.h"
#include "ShaderCore.h"
#include "ShaderParameterMetadata.h"
#include "ShaderPermutation.h"

#include <map>
#include <memory>
#include <mutex>

class FShader;
class FShaderType;

namespace Drydock
{

struct FShaderState;

/** The functions of a shader class for its permutations, taken from its statics. */
struct FShaderTypeFunctions
{
	int32 PermutationCount = 1;
	std::shared_ptr<FShader> (*Construct)(const FShaderType& Type, int32 PermutationId) = nullptr;
	bool (*ShouldCompilePermutation)(int32 PermutationId) = nullptr;
	void (*ModifyCompilationEnvironment)(int32 PermutationId, FShaderCompilerEnvironment& OutEnvironment) = nullptr;
	const FShaderParametersMetadata* (*GetRootParametersMetadata)() = nullptr;
	bool bScreenRectangle = false;
};

/** A vertex shader whose rectangle every draw knows without running it: the engine's of screen passes. */
template<typename TShaderClass>
inline constexpr bool TIsScreenRectangle = false;

} // namespace Drydock

enum class EShaderPermutationFlags : uint32
{
	None = 0,
	HasEditorOnlyData = 1 << 0,
};
ENUM_CLASS_FLAGS(EShaderPermutationFlags)

/** The argument of a shader class's statics. */
struct FShaderPermutationParameters
{
	explicit FShaderPermutationParameters(EShaderPlatform InPlatform, int32 InPermutationId = 0)
		: Platform(InPlatform)
		, PermutationId(InPermutationId)
	{
	}

	EShaderPlatform Platform;
	int32 PermutationId;
	EShaderPermutationFlags Flags = EShaderPermutationFlags::None;
};

/** Finds the parameters of a compiled shader by name. */
struct FShaderParameterMap
{
	const FShaderType* Type = nullptr;
	int32 PermutationId = 0;
};

/** The arguments that construct a shader instance. Older plugins write such constructors by hand and bind in them. */
struct FShaderCompiledShaderInitializerType
{
	const FShaderType* Type = nullptr;
	int32 PermutationId = 0;
	FShaderParameterMap ParameterMap{Type, PermutationId};
};

/** A registered shader class. One static object per class, made by IMPLEMENT_SHADER_TYPE. */
class DRYDOCK_API FShaderType
{
public:
	using CompiledShaderInitializerType = FShaderCompiledShaderInitializerType;

	FShaderType(const TCHAR* InName, const TCHAR* InSourceFilename, const TCHAR* InFunctionName,
		EShaderFrequency InFrequency, const Drydock::FShaderTypeFunctions& InFunctions);
	virtual ~FShaderType();
	FShaderType(const FShaderType&) = delete;
	FShaderType& operator=(const FShaderType&) = delete;

	const TCHAR* GetName() const { return Name; }
	/** Virtual path, "/Engine/Private/PostProcessBloom.usf". */
	const TCHAR* GetShaderFilename() const { return SourceFilename; }
	const TCHAR* GetFunctionName() const { return FunctionName; }
	EShaderFrequency GetFrequency() const { return Frequency; }
	int32 GetPermutationCount() const { return Functions.PermutationCount; }
	bool ShouldCompilePermutation(int32 PermutationId) const
	{
		return Functions.ShouldCompilePermutation(PermutationId);
	}
	/** True for a vertex shader that draws run. */
	bool IsRunByDraws() const { return Frequency == SF_Vertex && !Functions.bScreenRectangle; }
	/** Null for a class without SHADER_USE_PARAMETER_STRUCT. */
	const FShaderParametersMetadata* GetRootParametersMetadata() const { return Functions.GetRootParametersMetadata(); }

	/** Everything the permutation defines: its dimensions, then what the class adds. */
	FShaderCompilerEnvironment GetCompilationEnvironment(int32 PermutationId) const;

	/** The one instance of a permutation; a check when the id is out of range or the class refuses the permutation. */
	FShader* FindOrCreateShader(int32 PermutationId) const;

	/** Every permutation that was asked for so far. */
	void ForEachShader(TFunctionRef<void(FShader&)> Function) const;

private:
	const TCHAR* Name;
	const TCHAR* SourceFilename;
	const TCHAR* FunctionName;
	EShaderFrequency Frequency;
	Drydock::FShaderTypeFunctions Functions;
	Drydock::FCodeOwner Owner; // of the functions
	mutable std::mutex Mutex;
	mutable std::map<int32, std::shared_ptr<FShader>> Shaders; // which know how to destroy what they hold
};

/** One permutation of a shader class. Lives as long as its type. */
class DRYDOCK_API FShader
{
public:
	using FPermutationDomain = FShaderPermutationNone;
	using FPermutationParameters = FShaderPermutationParameters;
	using CompiledShaderInitializerType = FShaderCompiledShaderInitializerType;
	using ShaderMetaType = FShaderType;

	FShader();
	explicit FShader(const CompiledShaderInitializerType& Initializer);
	/** Not virtual, as in the engine: a class between FGlobalShader and a shader needs no constructors. */
	~FShader();
	FShader& operator=(const FShader&) = delete;

	/** Defaults of the statics that shader classes redefine. */
	static bool ShouldCompilePermutation(const FShaderPermutationParameters&) { return true; }
	static void ModifyCompilationEnvironment(const FShaderPermutationParameters&, FShaderCompilerEnvironment&) {}
	static const FShaderParametersMetadata* GetRootParametersMetadata() { return nullptr; }

	const FShaderType* GetType() const { return Type; }
	int32 GetPermutationId() const { return PermutationId; }
	EShaderFrequency GetFrequency() const { return Type->GetFrequency(); }

	FRHIComputeShader* GetComputeShader() const;
	FRHIPixelShader* GetPixelShader() const;
	FRHIVertexShader* GetVertexShader() const;

	/** The shader tier's state of this permutation: compiled code, reflection, copy plans. */
	Drydock::FShaderState& GetState() const { return *State; }

protected:
	FShader(FShader&& Other) noexcept; // a class without constructors initialises its base with one that is moved

private:
	friend class FShaderType;

	void Adopt(const FShaderType& InType, int32 InPermutationId);

	const FShaderType* Type = nullptr;
	int32 PermutationId = 0;
	std::unique_ptr<Drydock::FShaderState> State;
	FComputeShaderRHIRef ComputeShader;
	FPixelShaderRHIRef PixelShader;
	FVertexShaderRHIRef VertexShader;
};

/** A reference to a permutation of TShaderClass; instances live as long as the class is loaded. */
template<typename TShaderClass>
class TShaderRef
{
public:
	TShaderRef() = default;
	TShaderRef(std::nullptr_t) {}
	explicit TShaderRef(TShaderClass* InShader)
		: Shader(InShader)
	{
	}

	/** From a reference to a derived class. */
	template<typename TOtherClass>
	requires(std::is_convertible_v<TOtherClass*, TShaderClass*> && !std::is_same_v<TOtherClass, TShaderClass>)
		TShaderRef(const TShaderRef<TOtherClass>& Other)
		: Shader(Other.GetShader())
	{
	}

	TShaderClass* GetShader() const { return Shader; }
	const FShaderType* GetType() const { return Shader->GetType(); }
	const FShaderParametersMetadata* GetRootParametersMetadata() const
	{
		return GetType()->GetRootParametersMetadata();
	}

	bool IsValid() const { return Shader != nullptr; }
	bool IsNull() const { return Shader == nullptr; }
	void Reset() { Shader = nullptr; }
	explicit operator bool() const { return IsValid(); }
	TShaderClass* operator->() const { return Shader; }
	bool operator==(const TShaderRef& Other) const { return Shader == Other.Shader; }

	/** The handles that pipeline states take; null when the shader is of another frequency. */
	FRHIComputeShader* GetComputeShader() const { return Shader ? Shader->GetComputeShader() : nullptr; }
	FRHIPixelShader* GetPixelShader() const { return Shader ? Shader->GetPixelShader() : nullptr; }
	FRHIVertexShader* GetVertexShader() const { return Shader ? Shader->GetVertexShader() : nullptr; }

private:
	TShaderClass* Shader = nullptr;
};

/** Runs the list's shader, which is Shader. */
template<typename TRHICmdList, typename TShaderClass>
void DispatchComputeShader(TRHICmdList& RHICmdList, const TShaderRef<TShaderClass>&, uint32 ThreadGroupCountX,
	uint32 ThreadGroupCountY, uint32 ThreadGroupCountZ)
{
	RHICmdList.DispatchComputeShader(ThreadGroupCountX, ThreadGroupCountY, ThreadGroupCountZ);
}

namespace Drydock
{

using FShaderRef = TShaderRef<FShader>;

/** Calls Function for every shader class of the library and the plugins loaded so far, ordered by name. */
DRYDOCK_API void ForEachShaderType(TFunctionRef<void(const FShaderType&)> Function);

/** Touches a shader class's static type, which registers it. */
struct FShaderTypeRegistrar
{
	template<typename TType>
	explicit FShaderTypeRegistrar(TType& (*GetStaticType)())
	{
		GetStaticType();
	}
};

/** The functions of a shader class, whose parameters object is made by TPermutationParameters(Name, Platform, Id). */
template<typename TShaderClass, typename TPermutationParameters>
FShaderTypeFunctions MakeShaderTypeFunctions()
{
	FShaderTypeFunctions Functions;
	Functions.PermutationCount = TShaderClass::FPermutationDomain::PermutationCount;
	Functions.Construct = [](const FShaderType& Type, int32 PermutationId) -> std::shared_ptr<FShader>
	{
		if constexpr (std::is_constructible_v<TShaderClass, const FShaderCompiledShaderInitializerType&>)
		{
			return std::make_shared<TShaderClass>(FShaderCompiledShaderInitializerType{&Type, PermutationId});
		}
		else
		{
			return std::make_shared<TShaderClass>();
		}
	};
	Functions.ShouldCompilePermutation = [](int32 PermutationId)
	{
		return TShaderClass::ShouldCompilePermutation(TPermutationParameters(GMaxRHIShaderPlatform, PermutationId));
	};
	Functions.ModifyCompilationEnvironment = [](int32 PermutationId, FShaderCompilerEnvironment& OutEnvironment)
	{
		typename TShaderClass::FPermutationDomain(PermutationId).ModifyCompilationEnvironment(OutEnvironment);
		TShaderClass::ModifyCompilationEnvironment(
			TPermutationParameters(GMaxRHIShaderPlatform, PermutationId), OutEnvironment);
	};
	Functions.GetRootParametersMetadata = []
	{
		return TShaderClass::GetRootParametersMetadata();
	};
	Functions.bScreenRectangle = TIsScreenRectangle<TShaderClass>;
	return Functions;
}

} // namespace Drydock

/** In the body of a shader class; leaves the section public. The short name is Global or Material. */
#define DECLARE_EXPORTED_SHADER_TYPE(ShaderClass, ShaderMetaTypeShortcut, RequiredAPI, ...) \
public: \
	using ShaderMetaType = F##ShaderMetaTypeShortcut##ShaderType; \
	static RequiredAPI ShaderMetaType& GetStaticType();

#define DECLARE_SHADER_TYPE(ShaderClass, ShaderMetaTypeShortcut, ...) \
	DECLARE_EXPORTED_SHADER_TYPE(ShaderClass, ShaderMetaTypeShortcut, , ##__VA_ARGS__)

/** At namespace scope, in a .cpp. TemplatePrefix is empty or `template <>`. */
#define IMPLEMENT_SHADER_TYPE(TemplatePrefix, ShaderClass, SourceFilename, FunctionName, Frequency) \
	TemplatePrefix typename ShaderClass::ShaderMetaType& ShaderClass::GetStaticType() \
	{ \
		static ShaderMetaType StaticType(TEXT(#ShaderClass), SourceFilename, FunctionName, Frequency, \
			Drydock::MakeShaderTypeFunctions<ShaderClass, ShaderMetaType::FPermutationParameters>()); \
		return StaticType; \
	} \
	static const Drydock::FShaderTypeRegistrar DRYDOCK_JOIN(zzShaderType, __COUNTER__)(&ShaderClass::GetStaticType);
