// Finds the declarations of a preprocessed shader and the types of its expressions, as far as the rewrites before the
// front end need them. An unknown type is empty; a rewrite then leaves the expression alone or refuses it.
#pragma once

#include "HlslTokens.h"

#include <optional>
#include <set>
#include <unordered_map>

namespace Drydock
{

/** A scalar, vector or matrix type. */
struct FHlslNumeric
{
	std::string Scalar; // "float", "int", "uint", "bool", ...
	int Rows = 0;       // of a matrix
	int Columns = 0;    // 0: a scalar

	bool IsMatrix() const { return Rows > 0; }
	bool IsInteger() const { return Scalar == "int" || Scalar == "uint"; }
	int GetCount() const { return (Rows ? Rows : 1) * (Columns ? Columns : 1); }
	std::string GetName() const
	{
		return Scalar + (Rows ? std::to_string(Rows) + "x" : std::string()) +
			   (Columns ? std::to_string(Columns) : std::string());
	}
};

/** float3, half3 and vector<float, 3> are the same; nothing where Type is none of them. */
DRYDOCK_API std::optional<FHlslNumeric> ParseHlslNumeric(const std::string& Type);

struct FHlslVariable
{
	std::string Type; // "float4", "RWTexture2D<float4>", "FItem"
	bool bArray = false;
	bool bConstant = false;  // static const
	bool bStatic = false;    // static, groupshared
	bool bGlobal = false;    // outside functions and structs; members of constant buffers too
	bool bBlock = false;     // a member of a constant buffer
	bool bParameter = false; // of a function
	size_t At = 0;           // the token of the name
	size_t TypeAt = 0;       // the first token of the type
	size_t ScopeEnd = 0;
};

struct FHlslFunction
{
	std::string Type;
	std::vector<FHlslVariable> Parameters;
	size_t At = 0; // the token of the name
};

class DRYDOCK_API FHlslSymbols
{
public:
	explicit FHlslSymbols(const FHlslText& InText);

	/** The variable that Name means at a token; null if none is declared before it. */
	const FHlslVariable* FindVariable(const std::string& Name, size_t At) const;
	const std::vector<FHlslFunction>* FindFunctions(const std::string& Name) const;
	const FHlslVariable* FindMember(const std::string& Struct, const std::string& Member) const;
	bool IsStruct(const std::string& Name) const { return Structs.count(Name) > 0; }
	/** In the order of their declaration. */
	const std::vector<FHlslVariable>* GetMembers(const std::string& Struct) const;
	const std::unordered_map<std::string, std::vector<FHlslVariable>>& GetVariables() const { return Variables; }

	/** The type of the expression [First, End); empty where it is not known. */
	std::string GetType(size_t First, size_t End) const { return GetType(First, End, 0); }

	/** Reads a type at First: "vector<float, 3>" is float3, a typedef what it stands for. End: behind it. Empty where
	 * no type stands. */
	std::string ReadType(size_t First, size_t& End) const;

	/** The first token of `A[i].B.C`, whose last is Last. */
	size_t FindChainStart(size_t Last) const;

private:
	struct FScope
	{
		size_t End = 0;
		std::string Struct; // its name in a struct
		bool bFunction = false;
	};

	void Read();
	void ReadStruct(size_t At);
	void ReadFunction(const std::string& Type, size_t At);
	size_t ReadVariables(size_t TypeAt, const std::string& Type, size_t At);
	void Declare(size_t At, FHlslVariable Variable);
	std::string GetType(size_t First, size_t End, int Depth) const;
	std::string GetPostfixType(size_t First, size_t End, int Depth) const;
	std::string GetCallType(size_t At, size_t Close, int Depth) const;

	const FHlslText& Text;
	std::unordered_map<std::string, std::vector<FHlslVariable>> Variables;
	std::unordered_map<std::string, std::vector<FHlslFunction>> Functions;
	std::unordered_map<std::string, std::vector<FHlslVariable>> Structs;
	std::unordered_map<std::string, std::string> Aliases;
	std::set<std::string> Templates; // types of the text's own that take a list
	std::vector<FScope> Scopes;
	size_t ParametersEnd = 0; // of the function whose head is being read
	size_t BodyEnd = 0;
	size_t BlockEnd = 0; // of the constant buffer that is being read
};

/** The variable that a texel goes through of which parts are written. */
inline constexpr const char* GPartOfTexel = "DrydockTexel";

/** The type of what a texture or buffer holds: float4 of "Texture2D", uint of "RWBuffer<uint>"; empty for others. */
DRYDOCK_API std::string GetHlslElementType(const std::string& Resource);

} // namespace Drydock
