// Registers hand-written kernels that replace a .usf where measurements show a gain. They are registered beside the
// shader class, never instead of it: r.Drydock.NativeKernels 0 runs the .usf, and double precision always does. A
// kernel replaces only the text that it was tested against.
#pragma once

#include "BoundShader.h"
#include "Shader.h"

#include <string>
#include <vector>

namespace Drydock
{

/** A shader class with a hand-written kernel. */
struct FNativeKernel
{
	const FShaderType* Type = nullptr;
	FNativeKernelFunction Function = nullptr;
	std::string Fingerprint; // of the text that the kernel was tested against (FingerprintShader)
};

/** The way in which the shader of a draw or dispatch is to run, so far as its text decides. */
enum class ENativeChoice : uint8_t
{
	Shader, // the class has no kernel, or r.Drydock.NativeKernels is 0, or r.Drydock.Precision is double
	Native,
	Edited // the class has a kernel, and the text is another than the one that the kernel was tested against
};

/** Fingerprint: of the text as it is now. Function is set where the kernel stands in. */
DRYDOCK_API ENativeChoice FindNativeKernel(
	const FShaderType& Type, const std::string& Fingerprint, FNativeKernelFunction& Function);

/** The same for listings: reads the shader's files. Shader where they cannot be read. */
DRYDOCK_API ENativeChoice FindNativeKernel(const FShaderRef& Shader);

/** All of them, by the name of their class. */
DRYDOCK_API std::vector<FNativeKernel> GetNativeKernels();

/** During its scope kernels replace any text, for tests that compare kernels with their shaders. There can be one at a
 * time. */
class DRYDOCK_API FScopedNativeKernelsForAnyText : private FNoncopyable
{
public:
	FScopedNativeKernelsForAnyText();
	~FScopedNativeKernelsForAnyText();

	/** Kernels that have stood in for another text than theirs, each with the fingerprint of that text. */
	std::vector<FNativeKernel> GetStoodIn() const;
};

/** The pass's parameters inside a kernel of TShaderClass. */
template<typename TShaderClass>
const typename TShaderClass::FParameters& GetNativeParameters(const FNativeKernelArgs& Args)
{
	return *static_cast<const typename TShaderClass::FParameters*>(Args.GetParameters());
}

class DRYDOCK_API FNativeKernelRegistrar : private FNoncopyable
{
public:
	FNativeKernelRegistrar(const FShaderType& InType, FNativeKernelFunction Function, const char* Fingerprint);
	~FNativeKernelRegistrar();

private:
	const FShaderType& Type;
};

} // namespace Drydock

/** At namespace scope: `REGISTER_NATIVE_KERNEL(FBloomSetupPS, &RunBloomSetup, "0123456789abcdef");` The kernel serves
 * every permutation of the class, while the text of the class has this fingerprint. test_passes prints the fingerprint
 * of a changed text after the kernel's tests have passed. */
#define REGISTER_NATIVE_KERNEL(ShaderClass, Function, Fingerprint) \
	static const Drydock::FNativeKernelRegistrar DRYDOCK_JOIN(zzNativeKernel, __COUNTER__)( \
		ShaderClass::GetStaticType(), Function, Fingerprint);
