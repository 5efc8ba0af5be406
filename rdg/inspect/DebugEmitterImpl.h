// The emitter of debug kernels from the inside.
#pragma once

#include "DebugFunction.h"
#include "InspectedShader.h"

#include <optional>

namespace Drydock
{

/** A place in the author's variables. */
struct FDebugPath
{
	std::string Text;
	uint32_t Type = 0;
};

/** One shader. DebugEmitter.cpp: what is at file scope, and functions; DebugStatements.cpp: instructions. */
class FDebugEmitter
{
public:
	FDebugEmitter(const FInspectedShader& Shader, std::string InEntry);

	std::string Emit();

private:
	struct FNamed
	{
		std::string Name;
		std::string Signature;
		std::string Result; // where callers find what it returned
	};

	// Words
	std::string At(uint32_t Word) const { return "DrydockWords + " + std::to_string(Word); }
	std::string Word(uint32_t Index) const { return "DrydockWords[" + std::to_string(Index) + "]"; }
	/** Address of what the pointer in three words points to. */
	std::string AtPointer(uint32_t Pointer) const { return "DrydockWords + " + Word(Pointer); }
	uint32_t Arg(const FSpirvStep& Step, size_t Operand) const { return Program.Args[Step.FirstArg + Operand]; }
	std::string CopyWords(uint32_t To, uint32_t From, uint32_t Size) const
	{
		return Size ? "__builtin_memcpy(" + At(To) + ", " + At(From) + ", " + std::to_string(8 * Size) + "); "
					: std::string();
	}

	// Module scope
	void FindConstants();
	void AddConstant(uint32_t Variable, uint32_t Member);
	void FindGlobals();
	std::string MakeKernel() const;

	// Functions
	bool IsShownPointer(uint32_t Type) const;
	uint32_t GetReturnType(const FSpirvFunction& Function) const;
	std::string MakeReturnType(const FSpirvFunction& Function);
	void Declare(const FSpirvFunction& Function);
	void Define(const FSpirvFunction& Function);
	void OpenFunction(const FSpirvFunction& Function, const std::vector<FDebugLocal>& Locals);
	std::string OpenScopes(std::vector<FDebugLocal> Locals, size_t Position);
	void SetLine(uint32_t File, int Line);

	// Instructions
	std::optional<FDebugPath> FindPath(uint32_t Pointer);
	std::string MakeStatement(const FSpirvFunction& Function, const FSpirvBlock& Block, uint32_t StepIndex);
	std::string MakeCall(const FSpirvStep& Step);
	std::string MakeReturn(const FSpirvFunction& Function, const FSpirvStep& Step);
	std::string MakeSwitch(const FSpirvStep& Step, const FSpirvBlock& Block);
	std::string Jump(uint32_t From, uint32_t To);

	const FSpirvModule& Module;
	const FSpirvProgram& Program;
	FDebugTypes Types;
	const std::string Entry;
	std::vector<FSpirvFunction> Functions;
	std::string Globals;
	std::string ConstantReads;
	std::string Declarations;
	std::string Definitions;
	std::map<uint32_t, FNamed> Named; // functions, by id
	std::set<std::string> Signatures;
	std::map<std::string, std::string> FunctionNames;               // C++, by HLSL
	std::map<std::pair<uint32_t, uint32_t>, std::string> Constants; // by variable and member
	std::map<uint32_t, FDebugPath> Roots;                           // variables and parameters that are C++'s
	std::map<uint32_t, const FSpirvInstruction*> Chains;            // by result
	std::map<uint32_t, std::string> Files;                          // on disk, by the module's
	std::string LastFile;
	int LastLine = 0;
	size_t NumIncoming = 1; // words of phis that one jump writes
};

} // namespace Drydock
