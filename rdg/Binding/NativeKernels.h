// Hand-written kernels that stand in for a .usf where measurements say so. They are registered beside the shader class,
// never instead of it: r.Drydock.NativeKernels 0 runs the .usf, and double precision always does.
#pragma once

#include "BoundShader.h"
#include "Shader.h"

namespace Drydock
{

/** Null when the class has none, or r.Drydock.NativeKernels is 0, or r.Drydock.Precision is double. */
DRYDOCK_API FNativeKernelFunction FindNativeKernel(const FShaderType& Type);

/** The pass's parameters inside a kernel of TShaderClass. */
template<typename TShaderClass>
const typename TShaderClass::FParameters& GetNativeParameters(const FNativeKernelArgs& Args)
{
	return *static_cast<const typename TShaderClass::FParameters*>(Args.GetParameters());
}

class DRYDOCK_API FNativeKernelRegistrar
{
public:
	FNativeKernelRegistrar(const FShaderType& InType, FNativeKernelFunction Function);
	~FNativeKernelRegistrar();
	FNativeKernelRegistrar(const FNativeKernelRegistrar&) = delete;
	FNativeKernelRegistrar& operator=(const FNativeKernelRegistrar&) = delete;

private:
	const FShaderType& Type;
};

} // namespace Drydock

/** At namespace scope: `REGISTER_NATIVE_KERNEL(FBloomSetupPS, &RunBloomSetup);` The kernel serves every permutation. */
#define REGISTER_NATIVE_KERNEL(ShaderClass, Function) \
	static const Drydock::FNativeKernelRegistrar DRYDOCK_JOIN(zzNativeKernel, __COUNTER__)( \
		ShaderClass::GetStaticType(), Function);
