// What must hold for any words that claim to be SPIR-V: a module that all later stages can walk and the model can run,
// or a message. Used by the fuzzer, and by a test that runs its corpus.
#pragma once

#include "SpirvEmit.h"
#include "SpirvInterpreter.h"

#include "rdg/shader/Compiler/BlankArguments.h"

#include <algorithm>
#include <string>
#include <vector>

namespace Drydock
{

enum class ESpirvWalk : uint8_t
{
	Refused, // with a message
	Emitted, // as text; the model does not end, or does not know an instruction
	Run
};

/** Everything that is done with a module but compiling its text. Source: the .usf text that bindings are looked up in.
 * Message: of what was refused. Anything thrown but
 * FSpirvError is the caller's to see. */
inline ESpirvWalk WalkSpirv(const std::vector<uint32_t>& Words, std::string& Message, const std::string& Source = {})
{
	ESpirvWalk Result = ESpirvWalk::Refused;
	try
	{
		const FSpirvModule Module = ReadSpirv(Words);
		const FSpirvStructure Structure = BuildSpirvStructure(Module);
		const FSpirvReflection Reflection = ReflectSpirv(Module, Structure, Source);
		const FSpirvUniformity Uniformity = AnalyzeUniformity(Module, Structure);
		EmitKernel({Module, Structure, Uniformity, Reflection}, "fuzzed");
		Result = ESpirvWalk::Emitted;
		const Test::FBlankArguments Arguments(Reflection.Reflection, 1.0f);
		FSpirvInterpreter Interpreter(Module, Reflection);
		for (int32_t X = 0; X < 2; ++X)
		{
			Interpreter.Run(Arguments.Get(), X * 7, 3, 0, 2000);
		}
		Result = ESpirvWalk::Run;
	}
	catch (const FSpirvError& Error)
	{
		Message = Error.what();
	}
	return Result;
}

/** What does not hold, or nothing. */
inline std::string CheckSpirvBytes(const std::string& Bytes)
{
	std::vector<uint32_t> Words(Bytes.size() / 4);
	std::copy_n(Bytes.data(), Words.size() * 4, reinterpret_cast<char*>(Words.data()));
	std::string Message;
	const ESpirvWalk Walk = WalkSpirv(Words, Message);
	return Walk != ESpirvWalk::Run && Message.empty() ? "refused without a message" : "";
}

} // namespace Drydock
