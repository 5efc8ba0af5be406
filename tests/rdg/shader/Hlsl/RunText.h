// Compiles a compute shader by the front end and runs one thread of it by the interpreter.
#pragma once

#include "HlslFrontEnd.h"
#include "SpirvInterpreter.h"
#include "SpirvModule.h"
#include "SpirvReflect.h"
#include "SpirvStructure.h"
#include "TileExecutor.h"

#include <string>
#include <vector>

namespace Drydock::Hlsl::Tests
{

inline FSpirvModule CompileText(const std::string& Text)
{
	FShaderCompileRequest Request;
	Request.VirtualPath = "/Test/Constants.usf";
	Request.EntryPoint = "MainCS";
	Request.Stage = EShaderStage::Compute;
	return ReadSpirv(Compile(Text, Request));
}

/** In: the words of the buffer that is read. What is returned: those of the one that is written; Typed: those of
 * RWBuffer<float> Texels.
 */
inline std::vector<uint32_t> RunModule(const FSpirvModule& Module, const std::string& Text, std::vector<uint32_t>& In,
	size_t NumOut, std::vector<uint32_t>* Typed = nullptr)
{
	const FSpirvReflection Reflection = ReflectSpirv(Module, BuildSpirvStructure(Module), Text);
	std::vector<uint32_t> Out(NumOut, 0xCDCDCDCD);
	const auto View = [](std::vector<uint32_t>& Words, ETexelStorage Storage)
	{
		return FKernelBuffer{reinterpret_cast<uint8_t*>(Words.data()), uint32_t(Words.size() * 4), 4, Storage};
	};
	const FKernelBuffer Ins[1] = {View(In, ETexelStorage::R32_UINT)};
	std::vector<FKernelBuffer> Outs;
	for (const FShaderResource& Resource : Reflection.Reflection.RWBuffers)
	{
		const bool bTyped = Resource.Name == "Texels";
		Outs.push_back(
			View(bTyped && Typed ? *Typed : Out, bTyped ? ETexelStorage::R32_FLOAT : ETexelStorage::R32_UINT));
	}
	FKernelCounters Counters = {};
	FKernelArgs Args = {};
	Args.Buffers = Ins;
	Args.RWBuffers = Outs.data();
	Args.Counters = &Counters;
	FSpirvInterpreter Interpreter(Module, Reflection);
	const FScopedDenormals Denormals(EDenormals::Flush);
	Interpreter.Run(Args, 0, 0, 0);
	return Out;
}

} // namespace Drydock::Hlsl::Tests
