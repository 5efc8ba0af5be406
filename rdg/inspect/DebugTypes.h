// The types of a shader as C++ that a debugger shows well: float3 with x, y and z, arrays and matrices by their
// elements, structs as their author wrote them.
#pragma once

#include "SpirvModule.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace Drydock
{

/** A name that C++ can have, as near as can be to one of HLSL. */
std::string MakeCppName(const std::string& Name);

class FDebugTypes
{
public:
	explicit FDebugTypes(const FSpirvModule& InModule);

	/** "::float3". The type is defined with its first mention. */
	std::string NameOf(uint32_t Type);
	/** All that were mentioned so far. */
	const std::string& GetDefinitions() const { return Definitions; }
	/** A name at file scope that nothing else has. */
	std::string TakeName(const std::string& Name);

	/** Numbers and bools alone, no textures and the like. */
	bool IsNumeric(uint32_t Type) const { return Module.GetType(Type).NumScalars > 0; }
	/** True for a type that C++ neither passes nor returns by value. */
	bool IsArray(uint32_t Type) const;
	/** The text of an element or member behind its object: ".x", "[2]", ".Weight". */
	std::string ElementOf(uint32_t Type, uint32_t Index) const;

	/** Statements that copy a variable to words, and back. Words: an expression for their address. */
	std::string CopyToWords(uint32_t Type, const std::string& Variable, const std::string& Words) const;
	std::string CopyFromWords(uint32_t Type, const std::string& Variable, const std::string& Words) const;
	/** An expression for the value of the words: of arrays and matrices a DrydockValue, whose member Value they are. */
	std::string ReadWords(uint32_t Type, const std::string& Words);

private:
	struct FScalar
	{
		std::string Path;
		ESpirvType Kind = ESpirvType::Float;
	};
	void AddScalars(uint32_t Type, const std::string& Path, std::vector<FScalar>& Scalars) const;
	/** Some of its scalars are not as long in C++ as the interpreter's floats. */
	bool IsCopiedByScalars(uint32_t Type) const;
	std::string Copy(uint32_t Type, const std::string& Variable, const std::string& Words, bool bToWords) const;
	std::string Define(uint32_t Type);
	std::string DefineStruct(const FSpirvType& Type);

	const FSpirvModule& Module;
	std::map<uint32_t, std::string> Names;
	std::map<std::string, std::string> Structs; // what is between the braces, by name
	std::set<std::string> Taken;
	std::string Definitions;
};

} // namespace Drydock
