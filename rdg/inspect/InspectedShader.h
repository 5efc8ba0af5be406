// A shader in the form that can be looked into: its SPIR-V with functions and local variables, laid out for the
// interpreter, and matched with the arguments that its kernel gets.
#pragma once

#include "BoundShader.h"
#include "ShaderCompileRequest.h"
#include "ShaderSource.h"
#include "SpirvThread.h"

#include <memory>

namespace Drydock
{

/** The slots of Kernel's arguments that a module of the same shader finds its resources in, by their names. */
DRYDOCK_API FSpirvSlotTable FindKernelSlots(const FSpirvModule& Module, const FShaderReflection& Kernel);

class DRYDOCK_API FInspectedShader
{
public:
	/** Runs the front end. Kernel: the reflection of the compiled shader, whose slots the arguments have. Throws FError
	 * with the front end's messages, DD6020 where the interpreter does not know what the shader does. bAsKernel: the
	 * optimised form that kernels are made of, whose operations are theirs. */
	FInspectedShader(const FShaderCompileRequest& Request, const FShaderReflection& Kernel, bool bAsKernel = false);

	const FSpirvModule& GetModule() const { return Module; }
	/** Not const: hooks are set in it. */
	FSpirvProgram& GetProgram() { return *Program; }
	const FSpirvProgram& GetProgram() const { return *Program; }
	const FSpirvSlotTable& GetSlots() const { return Slots; }
	/** Threads of a group, or pixels of a quad, work together: they are run by TSpirvGroup, with this order and size of
	 * waves. */
	bool HasGroups() const { return Program->Groups.bGroups || Module.bQuads; }
	const FSpirvOrder& GetOrder() const { return Order; }
	uint32_t GetWaveSize() const { return WaveSize; }

	/** The text of a line of a virtual file as its author wrote it; empty: there is none. Lines count from 1. */
	std::string GetLine(const std::string& File, int Line) const;
	/** The same without the blanks around it. */
	std::string GetTrimmedLine(const std::string& File, int Line) const;

	/** Texts that it prints, by number (ShaderPrints.h). */
	const std::vector<std::string>& GetStrings() const { return Strings; }

	/** False where the shader could only be read with its calls inlined: there are lines and no local variables. */
	bool HasVariables() const { return bVariables; }

private:
	void Read(const FShaderCompileRequest& Request, const FShaderReflection& Kernel);

	FSpirvModule Module;
	std::unique_ptr<FSpirvProgram> Program;
	FSpirvSlotTable Slots;
	FSpirvOrder Order;
	uint32_t WaveSize = GDefaultWaveSize;
	std::vector<std::string> Strings;
	bool bVariables = true;
	std::map<std::string, std::string> FilesOnDisk;                // by virtual file, as overlays had them
	mutable std::map<std::string, std::vector<std::string>> Texts; // lines by virtual file
};

} // namespace Drydock
