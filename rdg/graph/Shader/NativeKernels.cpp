// Keeps the registry of hand-written kernels, by shader class, and says for which text one stands in.
#include "NativeKernels.h"

#include "Diagnostics.h"
#include "HAL/IConsoleManager.h"
#include "RangeTools.h"
#include "ShaderCompilation.h"

#include <algorithm>
#include <map>
#include <mutex>

namespace Drydock
{

namespace
{

TAutoConsoleVariable<int32> CVarNativeKernels(TEXT("r.Drydock.NativeKernels"), 1,
	TEXT("1: hand-written kernels stand in for shaders that have one; 0: every shader runs its .usf."));

struct FNativeKernelRegistry
{
	std::mutex Mutex;
	std::map<const FShaderType*, FNativeKernel> Kernels;
	bool bAnyText = false;
	std::map<const FShaderType*, FNativeKernel> StoodIn; // for another text, while bAnyText

	static FNativeKernelRegistry& Get()
	{
		static FNativeKernelRegistry* Registry = new FNativeKernelRegistry; // outlives registrars of any shared object
		return *Registry;
	}
};

std::vector<FNativeKernel> SortByName(const std::map<const FShaderType*, FNativeKernel>& Kernels)
{
	std::vector<FNativeKernel> Sorted = ToVector<FNativeKernel>(Kernels, [](const auto& Each) { return Each.second; });
	std::ranges::sort(Sorted, [](const FNativeKernel& A, const FNativeKernel& B)
		{ return std::string(A.Type->GetName()) < B.Type->GetName(); });
	return Sorted;
}

} // namespace

FNativeKernelRegistrar::FNativeKernelRegistrar(
	const FShaderType& InType, FNativeKernelFunction Function, const char* Fingerprint)
	: Type(InType)
{
	FNativeKernelRegistry& Registry = FNativeKernelRegistry::Get();
	std::lock_guard Lock(Registry.Mutex);
	Registry.Kernels[&Type] = {&Type, Function, Fingerprint};
}

FNativeKernelRegistrar::~FNativeKernelRegistrar()
{
	FNativeKernelRegistry& Registry = FNativeKernelRegistry::Get();
	std::lock_guard Lock(Registry.Mutex);
	Registry.Kernels.erase(&Type);
}

ENativeChoice FindNativeKernel(const FShaderType& Type, const std::string& Fingerprint, FNativeKernelFunction& Function)
{
	Function = nullptr;
	if (CVarNativeKernels.GetValueOnAnyThread() == 0 || GetShaderLaneConfig().bDouble)
	{
		return ENativeChoice::Shader;
	}
	FNativeKernelRegistry& Registry = FNativeKernelRegistry::Get();
	std::lock_guard Lock(Registry.Mutex);
	const auto Found = Registry.Kernels.find(&Type);
	if (Found == Registry.Kernels.end())
	{
		return ENativeChoice::Shader;
	}
	if (Found->second.Fingerprint != Fingerprint)
	{
		if (!Registry.bAnyText)
		{
			return ENativeChoice::Edited;
		}
		Registry.StoodIn[&Type] = {&Type, Found->second.Function, Fingerprint};
	}
	Function = Found->second.Function;
	return ENativeChoice::Native;
}

ENativeChoice FindNativeKernel(const FShaderRef& Shader)
{
	FNativeKernelRegistry& Registry = FNativeKernelRegistry::Get();
	{
		std::lock_guard Lock(Registry.Mutex);
		if (!Registry.Kernels.contains(Shader.GetType()))
		{
			return ENativeChoice::Shader;
		}
	}
	try
	{
		FNativeKernelFunction Function = nullptr;
		return FindNativeKernel(*Shader.GetType(), GetShaderFingerprint(Shader), Function);
	}
	catch (const FError&)
	{
		return ENativeChoice::Shader; // whoever compiles it reports that
	}
}

std::vector<FNativeKernel> GetNativeKernels()
{
	FNativeKernelRegistry& Registry = FNativeKernelRegistry::Get();
	std::lock_guard Lock(Registry.Mutex);
	return SortByName(Registry.Kernels);
}

FScopedNativeKernelsForAnyText::FScopedNativeKernelsForAnyText()
{
	FNativeKernelRegistry& Registry = FNativeKernelRegistry::Get();
	std::lock_guard Lock(Registry.Mutex);
	Registry.bAnyText = true;
	Registry.StoodIn.clear();
}

FScopedNativeKernelsForAnyText::~FScopedNativeKernelsForAnyText()
{
	FNativeKernelRegistry& Registry = FNativeKernelRegistry::Get();
	std::lock_guard Lock(Registry.Mutex);
	Registry.bAnyText = false;
}

std::vector<FNativeKernel> FScopedNativeKernelsForAnyText::GetStoodIn() const
{
	FNativeKernelRegistry& Registry = FNativeKernelRegistry::Get();
	std::lock_guard Lock(Registry.Mutex);
	return SortByName(Registry.StoodIn);
}

} // namespace Drydock
