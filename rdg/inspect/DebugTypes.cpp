// Writes types and the copies between variables and words.
#include "DebugTypes.h"

#include "SpirvRefusals.h"
#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

namespace
{

/** Words of C++ that HLSL leaves to its authors. */
bool IsCppKeyword(const std::string& Name)
{
	static const std::set<std::string> Keywords = {"alignas", "alignof", "and", "and_eq", "asm", "auto", "bitand",
		"bitor", "catch", "char", "char8_t", "char16_t", "char32_t", "class", "co_await", "co_return", "co_yield",
		"compl", "concept", "const_cast", "consteval", "constexpr", "constinit", "decltype", "delete", "dynamic_cast",
		"enum", "explicit", "export", "friend", "goto", "long", "main", "mutable", "namespace", "new", "noexcept",
		"not", "not_eq", "nullptr", "operator", "or", "or_eq", "private", "protected", "public", "reinterpret_cast",
		"requires", "short", "signed", "sizeof", "static_assert", "static_cast", "template", "this", "thread_local",
		"throw", "try", "typeid", "typename", "union", "unsigned", "using", "virtual", "wchar_t", "xor", "xor_eq"};
	return Keywords.count(Name) != 0;
}

} // namespace

std::string MakeCppName(const std::string& Name)
{
	std::string Result = Name.empty() ? "_" : Name;
	std::replace_if(
		Result.begin(), Result.end(), [](char Letter) { return !IsWordCharacter(Letter); }, '_');
	if (IsDigit(Result[0]))
	{
		Result.insert(0, "_");
	}
	return IsCppKeyword(Result) ? Result + "_" : Result;
}

FDebugTypes::FDebugTypes(const FSpirvModule& InModule)
	: Module(InModule)
	, Taken({"bool", "int", "uint", "float", "float16_t", "int16_t", "uint16_t", "double", "int64_t", "uint64_t",
		  "Drydock"})
{
	for (const auto& [Id, Type] : Module.Types)
	{
		const bool bVector = Type.Kind == ESpirvType::Vector || Type.Kind == ESpirvType::Matrix;
		if (bVector && IsNumeric(Id))
		{
			NameOf(Id); // before anybody takes the name
		}
	}
}

std::string FDebugTypes::TakeName(const std::string& Name)
{
	const std::string Wanted = MakeCppName(Name);
	std::string Result = Wanted;
	for (int Number = 2; !Taken.insert(Result).second; ++Number)
	{
		Result = Wanted + "_" + std::to_string(Number);
	}
	return Result;
}

bool FDebugTypes::IsArray(uint32_t Type) const
{
	const ESpirvType Kind = Module.GetType(Type).Kind;
	return Kind == ESpirvType::Array || Kind == ESpirvType::Matrix;
}

std::string FDebugTypes::NameOf(uint32_t Type)
{
	const auto Known = Names.find(Type);
	if (Known != Names.end())
	{
		return Known->second;
	}
	const std::string Name = Define(Type);
	return Names[Type] = Name;
}

std::string FDebugTypes::Define(uint32_t TypeId)
{
	const FSpirvType& Type = Module.GetType(TypeId);
	switch (Type.Kind)
	{
	case ESpirvType::Void:
		return "void";
	case ESpirvType::Vector:
	{
		const std::string Scalar = NameOf(Type.Element);
		const std::string Name = Scalar + std::to_string(Type.Count);
		if (Taken.insert(Name).second)
		{
			Definitions += "struct " + Name + " { " + Scalar + " x";
			for (uint32_t i = 1; i < Type.Count; ++i)
			{
				Definitions += std::string(", ") + "xyzw"[i];
			}
			Definitions += "; };\n";
		}
		return "::" + Name;
	}
	case ESpirvType::Matrix:
	{
		// SPIR-V's columns are the rows of HLSL.
		const std::string Row = NameOf(Type.Element);
		const FSpirvType& RowType = Module.GetType(Type.Element);
		const std::string Name = std::string(GetHlslScalarName(Module.GetType(RowType.Element).Kind)) +
								 std::to_string(Type.Count) + "x" + std::to_string(RowType.Count);
		if (Taken.insert(Name).second)
		{
			Definitions += "typedef " + Row + " " + Name + "[" + std::to_string(Type.Count) + "];\n";
		}
		return "::" + Name;
	}
	case ESpirvType::Array:
		return "DrydockArray<" + NameOf(Type.Element) + ", " + std::to_string(Type.Count) + ">";
	case ESpirvType::Struct:
		return "::" + DefineStruct(Type);
	default:
		return GetHlslScalarName(Type.Kind);
	}
}

std::string FDebugTypes::DefineStruct(const FSpirvType& Type)
{
	std::string Body;
	for (const FSpirvMember& Member : Type.Members)
	{
		Body += " " + NameOf(Member.Type) + " " + MakeCppName(Member.Name) + ";";
	}
	// The front end has a type for every layout of one struct.
	std::string Wanted = MakeCppName(Type.Name);
	const auto Known = Structs.find(Wanted);
	if (Known != Structs.end() && Known->second == Body)
	{
		return Wanted;
	}
	const std::string Name = TakeName(Type.Name);
	Structs[Name] = Body;
	Definitions += "struct " + Name + " {" + Body + " };\n";
	return Name;
}

std::string FDebugTypes::ElementOf(uint32_t TypeId, uint32_t Index) const
{
	const FSpirvType& Type = Module.GetType(TypeId);
	return Type.Kind == ESpirvType::Struct   ? "." + MakeCppName(Type.Members.at(Index).Name)
		   : Type.Kind == ESpirvType::Vector ? std::string(".") + "xyzw"[std::min(Index, Type.Count - 1)]
											 : "[" + std::to_string(std::min(Index, Type.Count - 1)) + "]";
}

void FDebugTypes::AddScalars(uint32_t TypeId, const std::string& Path, std::vector<FScalar>& Scalars) const
{
	const FSpirvType& Type = Module.GetType(TypeId);
	const bool bStruct = Type.Kind == ESpirvType::Struct;
	if (IsSpirvScalar(Type.Kind))
	{
		Scalars.push_back({Path, Type.Kind});
		return;
	}
	for (uint32_t i = 0; i < (bStruct ? uint32_t(Type.Members.size()) : Type.Count); ++i)
	{
		AddScalars(bStruct ? Type.Members[i].Type : Type.Element, Path + ElementOf(TypeId, i), Scalars);
	}
}

bool FDebugTypes::IsCopiedByScalars(uint32_t Type) const
{
	for (uint32_t i = 0; i < Module.GetType(Type).NumScalars; ++i)
	{
		const ESpirvType Kind = Module.GetScalarKind(Type, i);
		if (Kind == ESpirvType::Bool || GetSpirvBytes(Kind) != 4)
		{
			return true;
		}
	}
	return false;
}

std::string FDebugTypes::Copy(uint32_t Type, const std::string& Variable, const std::string& Words, bool bToWords) const
{
	const auto Move = [bToWords](const std::string& Path, const std::string& At, uint32_t NumWords)
	{
		return (bToWords ? "DrydockPut(" + At + ", &" : "DrydockTake(" + At + ", &") + Path + ", " +
			   std::to_string(NumWords) + "); ";
	};
	if (!IsCopiedByScalars(Type))
	{
		return Move(Variable, Words, Module.GetType(Type).NumScalars);
	}
	// A bool of C++ has one byte, an int16_t two.
	std::vector<FScalar> Scalars;
	AddScalars(Type, Variable, Scalars);
	std::string Text;
	for (size_t i = 0; i < Scalars.size(); ++i)
	{
		const std::string At = "(" + Words + ")[" + std::to_string(i) + "]";
		const std::string& Path = Scalars[i].Path;
		switch (Scalars[i].Kind)
		{
		case ESpirvType::Bool:
			Text += bToWords ? At + " = " + Path + "; " : Path + " = " + At + " != 0; ";
			break;
		case ESpirvType::Short: // words hold what fills 32 bits
			Text += bToWords ? At + " = uint(int(" + Path + ")); " : Path + " = short(" + At + "); ";
			break;
		case ESpirvType::Double:
			Text += bToWords ? "__builtin_memcpy(&" + At + ", &" + Path + ", 8); "
							 : "__builtin_memcpy(&" + Path + ", &" + At + ", 8); ";
			break;
		case ESpirvType::Ushort:
		case ESpirvType::Long:
		case ESpirvType::Ulong:
			Text += bToWords ? At + " = " + Path + "; " : Path + " = " + At + "; ";
			break;
		default:
			Text += Move(Path, "&" + At, 1);
			break;
		}
	}
	return Text;
}

std::string FDebugTypes::CopyToWords(uint32_t Type, const std::string& Variable, const std::string& Words) const
{
	return Copy(Type, Variable, Words, true);
}

std::string FDebugTypes::CopyFromWords(uint32_t Type, const std::string& Variable, const std::string& Words) const
{
	return Copy(Type, Variable, Words, false);
}

std::string FDebugTypes::ReadWords(uint32_t Type, const std::string& Words)
{
	// One expression: a variable in a block of its own would be a second place of the same line, where a debugger stops
	// again.
	std::string Text;
	for (uint32_t i = 0; i < Module.GetType(Type).NumScalars; ++i)
	{
		const ESpirvType Kind = Module.GetScalarKind(Type, i);
		const std::string Word = "(" + Words + ")[" + std::to_string(i) + "]";
		Text += Text.empty() ? "" : ", ";
		switch (Kind)
		{
		case ESpirvType::Bool:
			Text += Word + " != 0";
			break;
		case ESpirvType::Float:
		case ESpirvType::Half:
			Text += "__builtin_bit_cast(float, uint(" + Word + "))";
			break;
		case ESpirvType::Double:
			Text += "__builtin_bit_cast(double, " + Word + ")";
			break;
		default:
			Text += std::string(GetHlslScalarName(Kind)) + "(" + Word + ")";
		}
	}
	const std::string Name = NameOf(Type);
	return (IsArray(Type) ? "DrydockValue<" + Name + ">" : Name) + "{" + Text + "}";
}

} // namespace Drydock
