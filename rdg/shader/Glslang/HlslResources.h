// The resources of a shader by number, for those that are in arrays, local variables and structs.
#pragma once

#include "HlslSymbols.h"

#include <map>

namespace Drydock
{

/** An expression whose value is a resource that may have to be a number. */
struct FHlslResourceUse
{
	size_t First = 0;
	size_t End = 0;      // behind the resource itself: at "[" of an element, "." of a method, or what follows its name
	std::string Type;    // "RWBuffer<int>"
	std::string Name;    // of the one resource that it is, where that is known here
	std::string Number;  // an expression of uint
	bool bArray = false; // several resources
	std::vector<std::string> PartNumbers; // of an array of the shader
};

/** One resource that stands in the text as a declaration of its own. */
struct FHlslLeaf
{
	std::string Name;
	std::string Type;
};

class FHlslResourceNumbers
{
public:
	FHlslResourceNumbers(const FHlslText& InText, const FHlslSymbols& InSymbols, std::vector<FDiagnostic>& OutErrors);

	bool IsEmpty() const { return Types.empty(); }

	/** Declares arrays and structs of resources as single ones, everything else of their types as uint. */
	void Declare(FHlslEdits& Edits) const;

	/** The use that the name at At begins, if the name is a resource of the numbered types. */
	std::optional<FHlslResourceUse> FindUse(size_t At) const;

	/** In the order of their numbers. */
	const std::vector<std::string>& GetLeaves(const std::string& Type) const { return Leaves.at(Type); }

private:
	/** A resource, an array or a struct of the shader: where its leaves begin. */
	struct FGlobal
	{
		std::vector<int> Sizes;
		std::vector<FHlslLeaf> Parts; // in the order of memory
		std::string Struct;
	};

	void FindTypes();
	void AddGlobal(const FHlslVariable& Variable);
	void AddLeaves(FGlobal& Global, const FHlslVariable& Variable, const std::string& Name, int Depth);
	bool IsNumbered(const std::string& Type) const { return Types.count(Type) > 0; }
	bool HasResources(const std::string& Struct) const;
	std::vector<int> GetSizes(const FHlslVariable& Variable) const;
	int FindUnboundedSize(const FHlslVariable& Variable) const;
	std::string GetNumber(const FHlslLeaf& Leaf) const;
	/** "A_5_B" of "A[1[2.B", a path whose indices are numbers. */
	std::string GetLeafName(const std::string& Path, const FHlslVariable& Variable) const;
	void DeclareGlobal(FHlslEdits& Edits, const FHlslVariable& Variable, const FGlobal& Global) const;
	std::string GetStructValue(const std::string& Struct, const std::string& Name) const;

	const FHlslText& Text;
	const FHlslSymbols& Symbols;
	std::vector<FDiagnostic>& Errors;
	std::set<std::string> Types;                            // that are numbered
	std::map<std::string, std::vector<std::string>> Leaves; // names, by type
	std::map<size_t, FGlobal> Globals;                      // by the token of the name
};

/** The functions that read, write and call by number. */
class FHlslResourceAccessors
{
public:
	bool empty() const { return Wanted.empty(); }

	// Each gives the name of a function; Read an expression.
	std::string Get(const std::string& Type) { return Want(Type, "Get"); }
	std::string Set(const std::string& Type) { return Want(Type, "Set"); }
	std::string Read(const std::string& Type, const std::string& Number)
	{
		return Want(Type, "Read") + "(" + Number + ")";
	}
	/** Empty for a method that it does not have. */
	std::string Call(const std::string& Type, const std::string& Method);

	std::string GetPrototypes() const;
	std::string GetFunctions(const FHlslResourceNumbers& Numbers) const;

private:
	std::string Want(const std::string& Type, const std::string& Method);

	std::set<std::pair<std::string, std::string>> Wanted; // type, method
};

} // namespace Drydock
