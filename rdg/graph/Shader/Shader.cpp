// Keeps the registry of shader classes and the instances of their permutations.
#include "Shader.h"

#include "CodeScope.h"
#include "ShaderState.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace
{

struct FShaderTypeRegistry
{
	std::mutex Mutex;
	std::vector<const FShaderType*> Types;

	static FShaderTypeRegistry& Get()
	{
		static FShaderTypeRegistry* Registry = new FShaderTypeRegistry; // outlives the types of any shared object
		return *Registry;
	}
};

} // namespace

FShaderType::FShaderType(const TCHAR* InName, const TCHAR* InSourceFilename, const TCHAR* InFunctionName,
	EShaderFrequency InFrequency, const Drydock::FShaderTypeFunctions& InFunctions)
	: Name(InName)
	, SourceFilename(InSourceFilename)
	, FunctionName(InFunctionName)
	, Frequency(InFrequency)
	, Functions(InFunctions)
	, Owner(Drydock::MakeCodeOwner(std::string("shader class ") + InName))
{
	FShaderTypeRegistry& Registry = FShaderTypeRegistry::Get();
	std::lock_guard Lock(Registry.Mutex);
	Registry.Types.push_back(this);
}

FShaderType::~FShaderType()
{
	FShaderTypeRegistry& Registry = FShaderTypeRegistry::Get();
	std::lock_guard Lock(Registry.Mutex);
	std::erase(Registry.Types, this);
}

FShaderCompilerEnvironment FShaderType::GetCompilationEnvironment(int32 PermutationId) const
{
	FShaderCompilerEnvironment Environment;
	Drydock::CallCode(Owner, [&] { Functions.ModifyCompilationEnvironment(PermutationId, Environment); });
	return Environment;
}

FShader* FShaderType::FindOrCreateShader(int32 PermutationId) const
{
	checkf(PermutationId >= 0 && PermutationId < Functions.PermutationCount,
		TEXT("%s has no permutation %d: its domain has %d"), Name, PermutationId, Functions.PermutationCount);
	std::lock_guard Lock(Mutex);
	std::shared_ptr<FShader>& Shader = Shaders[PermutationId];
	if (!Shader)
	{
		checkf(Drydock::CallCode(Owner, [&] { return Functions.ShouldCompilePermutation(PermutationId); }),
			TEXT("%s was asked for permutation %d, which its ShouldCompilePermutation refuses"), Name, PermutationId);
		Shader = Functions.Construct(*this, PermutationId);
		Shader->Adopt(*this, PermutationId);
	}
	return Shader.get();
}

void FShaderType::ForEachShader(TFunctionRef<void(FShader&)> Function) const
{
	std::lock_guard Lock(Mutex);
	for (const auto& [PermutationId, Shader] : Shaders)
	{
		if (Shader)
		{
			Function(*Shader);
		}
	}
}

FShader::FShader()
	: State(std::make_unique<Drydock::FShaderState>())
{
}

FShader::FShader(const CompiledShaderInitializerType&)
	: FShader()
{
}

FShader::FShader(FShader&& Other) noexcept = default;

FShader::~FShader() = default;

void FShader::Adopt(const FShaderType& InType, int32 InPermutationId)
{
	Type = &InType;
	PermutationId = InPermutationId;
	switch (InType.GetFrequency())
	{
	case SF_Compute:
		ComputeShader = new FRHIComputeShader(this);
		break;
	case SF_Pixel:
		PixelShader = new FRHIPixelShader(this);
		break;
	case SF_Vertex:
		VertexShader = new FRHIVertexShader(InType.IsRunByDraws() ? this : nullptr);
		break;
	default:
		checkf(false, TEXT("%s: only vertex, pixel and compute shaders exist here"), InType.GetName());
	}
}

FRHIComputeShader* FShader::GetComputeShader() const
{
	return ComputeShader.GetReference();
}

FRHIPixelShader* FShader::GetPixelShader() const
{
	return PixelShader.GetReference();
}

FRHIVertexShader* FShader::GetVertexShader() const
{
	return VertexShader.GetReference();
}

namespace Drydock
{

void ForEachShaderType(TFunctionRef<void(const FShaderType&)> Function)
{
	std::vector<const FShaderType*> Types;
	{
		FShaderTypeRegistry& Registry = FShaderTypeRegistry::Get();
		std::lock_guard Lock(Registry.Mutex);
		Types = Registry.Types;
	}
	std::stable_sort(Types.begin(), Types.end(),
		[](const FShaderType* A, const FShaderType* B) { return std::strcmp(A->GetName(), B->GetName()) < 0; });
	for (const FShaderType* Type : Types)
	{
		Function(*Type);
	}
}

} // namespace Drydock
