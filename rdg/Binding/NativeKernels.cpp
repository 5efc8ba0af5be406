// Keeps the registry of hand-written kernels, by shader class.
#include "NativeKernels.h"

#include "HAL/IConsoleManager.h"
#include "ShaderCompilation.h"

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
	std::map<const FShaderType*, FNativeKernelFunction> Kernels;

	static FNativeKernelRegistry& Get()
	{
		static FNativeKernelRegistry* Registry = new FNativeKernelRegistry; // outlives registrars of any shared object
		return *Registry;
	}
};

} // namespace

FNativeKernelRegistrar::FNativeKernelRegistrar(const FShaderType& InType, FNativeKernelFunction Function)
	: Type(InType)
{
	FNativeKernelRegistry& Registry = FNativeKernelRegistry::Get();
	std::lock_guard Lock(Registry.Mutex);
	Registry.Kernels[&Type] = Function;
}

FNativeKernelRegistrar::~FNativeKernelRegistrar()
{
	FNativeKernelRegistry& Registry = FNativeKernelRegistry::Get();
	std::lock_guard Lock(Registry.Mutex);
	Registry.Kernels.erase(&Type);
}

FNativeKernelFunction FindNativeKernel(const FShaderType& Type)
{
	if (CVarNativeKernels.GetValueOnAnyThread() == 0 || GetShaderLaneConfig().bDouble)
	{
		return nullptr;
	}
	FNativeKernelRegistry& Registry = FNativeKernelRegistry::Get();
	std::lock_guard Lock(Registry.Mutex);
	const auto Found = Registry.Kernels.find(&Type);
	return Found == Registry.Kernels.end() ? nullptr : Found->second;
}

} // namespace Drydock
