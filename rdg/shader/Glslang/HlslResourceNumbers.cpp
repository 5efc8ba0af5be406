// Which types of resources are numbered, and what becomes of their declarations.
#include "HlslResources.h"

#include <algorithm>
#include <cstdlib>

namespace Drydock
{

namespace
{

constexpr int MaxStructDepth = 16; // of structs in structs

bool IsWrittenType(const std::string& Type)
{
	return (Type.starts_with("RW") && !Type.starts_with("RWTexture1D")) || Type.starts_with("AppendStructuredBuffer") ||
		   Type.starts_with("ConsumeStructuredBuffer");
}

bool IsBuffer(const std::string& Type)
{
	return Type.starts_with("ByteAddressBuffer") || Type.starts_with("StructuredBuffer") || Type.starts_with("Buffer<");
}

bool IsResource(const std::string& Type)
{
	return IsWrittenType(Type) || IsBuffer(Type) || Type.starts_with("Texture2D<") || Type.starts_with("Texture3D<") ||
		   Type.starts_with("Texture2DArray<") || Type.starts_with("ConstantBuffer<");
}

char GetRegisterClass(const std::string& Type)
{
	return IsWrittenType(Type) ? 'u' : Type.starts_with("ConstantBuffer") ? 'b' : 't';
}

int Multiply(const std::vector<int>& Sizes, size_t First)
{
	int Product = 1;
	for (size_t i = First; i < Sizes.size(); ++i)
	{
		Product *= Sizes[i];
	}
	return Product;
}

} // namespace

FHlslResourceNumbers::FHlslResourceNumbers(
	const FHlslText& InText, const FHlslSymbols& InSymbols, std::vector<FDiagnostic>& OutErrors)
	: Text(InText)
	, Symbols(InSymbols)
	, Errors(OutErrors)
{
	FindTypes();
	std::vector<const FHlslVariable*> Declared;
	for (const auto& [Name, Variables] : Symbols.GetVariables())
	{
		for (const FHlslVariable& Variable : Variables)
		{
			const bool bOfInterest = IsNumbered(Variable.Type) || HasResources(Variable.Type);
			if (!Types.empty() && Variable.bGlobal && !Variable.bStatic && !Variable.bBlock && bOfInterest)
			{
				Declared.push_back(&Variable);
			}
		}
	}
	std::sort(
		Declared.begin(), Declared.end(), [](const FHlslVariable* A, const FHlslVariable* B) { return A->At < B->At; });
	for (const FHlslVariable* Variable : Declared)
	{
		AddGlobal(*Variable);
	}
}

void FHlslResourceNumbers::FindTypes()
{
	for (const auto& [Name, Variables] : Symbols.GetVariables())
	{
		for (const FHlslVariable& Variable : Variables)
		{
			const bool bArray = Variable.bGlobal && Variable.bArray && IsResource(Variable.Type);
			const bool bInside =
				!Variable.bGlobal && !Variable.bParameter && (IsWrittenType(Variable.Type) || IsBuffer(Variable.Type));
			if ((bArray || bInside) && !Variable.bBlock)
			{
				Types.insert(Variable.Type);
				Leaves[Variable.Type];
			}
		}
	}
}

bool FHlslResourceNumbers::HasResources(const std::string& Struct) const
{
	const std::vector<FHlslVariable>* const Members = Symbols.GetMembers(Struct);
	return Members && std::any_of(Members->begin(), Members->end(),
						  [this, &Struct](const FHlslVariable& Member)
						  { return IsNumbered(Member.Type) || (Member.Type != Struct && HasResources(Member.Type)); });
}

std::vector<int> FHlslResourceNumbers::GetSizes(const FHlslVariable& Variable) const
{
	std::vector<int> Sizes;
	for (size_t Open = Variable.At + 1; Text.Is(Open, "["); Open = Text.FindClose(Open) + 1)
	{
		const bool bUnbounded = Text.Is(Open + 1, "]");
		const int Size = bUnbounded ? FindUnboundedSize(Variable) : std::atoi(Text[Open + 1].Text.c_str());
		if (Size < 1 || (!bUnbounded && Text.FindClose(Open) != Open + 2))
		{
			Errors.push_back(Text.MakeError(Variable.At, "the array '" + Text[Variable.At].Text +
															 "' of resources needs a number of them in its "
															 "declaration, since its elements are bound one by one"));
			return {1};
		}
		Sizes.push_back(Size);
	}
	return Sizes;
}

/** One more than the largest index where all are numbers, else 0. */
int FHlslResourceNumbers::FindUnboundedSize(const FHlslVariable& Variable) const
{
	int Size = 0;
	for (size_t At = Variable.At + 1; At < Text.Size(); ++At)
	{
		const bool bUse = Text.Is(At, Text[Variable.At].Text.c_str()) && !Text.Is(At - 1, ".") &&
						  Text.Is(At + 1, "[") && Symbols.FindVariable(Text[At].Text, At) == &Variable;
		if (bUse)
		{
			const bool bNumber = Text.FindClose(At + 1) == At + 3 && Text[At + 2].Kind == EShaderToken::Number;
			const bool bCall = Text.Is(At + 2, "NonUniformResourceIndex") && Text.Is(At + 5, ")") &&
							   Text[At + 4].Kind == EShaderToken::Number;
			if (!bNumber && !bCall)
			{
				return 0;
			}
			Size = std::max(Size, std::atoi(Text[bNumber ? At + 2 : At + 4].Text.c_str()) + 1);
		}
	}
	return Size;
}

void FHlslResourceNumbers::AddGlobal(const FHlslVariable& Variable)
{
	FGlobal Global;
	const std::string Name = Text[Variable.At].Text;
	Global.Sizes = GetSizes(Variable);
	Global.Struct = IsNumbered(Variable.Type) ? std::string() : Variable.Type;
	AddLeaves(Global, Variable, Name, 0);
	for (const FHlslLeaf& Leaf : Global.Parts)
	{
		Leaves[Leaf.Type].push_back(Leaf.Name);
	}
	Globals.emplace(Variable.At, std::move(Global));
}

void FHlslResourceNumbers::AddLeaves(FGlobal& Global, const FHlslVariable& Variable, const std::string& Name, int Depth)
{
	const std::vector<int> Sizes = GetSizes(Variable);
	const std::vector<FHlslVariable>* const Members =
		IsNumbered(Variable.Type) || Depth > MaxStructDepth ? nullptr : Symbols.GetMembers(Variable.Type);
	for (int i = 0; i < Multiply(Sizes, 0); ++i)
	{
		const std::string Element = Sizes.empty() ? Name : Name + "_" + std::to_string(i);
		if (!Members)
		{
			Global.Parts.push_back({Element, Variable.Type});
			continue;
		}
		for (const FHlslVariable& Member : *Members)
		{
			if (!IsNumbered(Member.Type) && !HasResources(Member.Type))
			{
				Errors.push_back(Text.MakeError(
					Variable.At, "'" + Text[Variable.At].Text + "' has resources and the number '" +
									 Text[Member.At].Text + "': make the number a parameter of its own"));
				return;
			}
			AddLeaves(Global, Member, Element + "_" + Text[Member.At].Text, Depth + 1);
		}
	}
}

std::string FHlslResourceNumbers::GetNumber(const FHlslLeaf& Leaf) const
{
	const std::vector<std::string>& Names = Leaves.at(Leaf.Type);
	return std::to_string(std::find(Names.begin(), Names.end(), Leaf.Name) - Names.begin()) + "u";
}

void FHlslResourceNumbers::Declare(FHlslEdits& Edits) const
{
	std::set<size_t> Done; // types that are written once for several names
	for (const auto& [Name, Variables] : Symbols.GetVariables())
	{
		for (const FHlslVariable& Variable : Variables)
		{
			const auto Global = Globals.find(Variable.At);
			if (Global != Globals.end())
			{
				const bool bPlain = Global->second.Sizes.empty() && Global->second.Struct.empty();
				if (!bPlain)
				{
					DeclareGlobal(Edits, Variable, Global->second);
				}
			}
			else if (IsNumbered(Variable.Type) && Done.insert(Variable.TypeAt).second)
			{
				size_t End = 0;
				Symbols.ReadType(Variable.TypeAt, End);
				const bool bBlock = Variable.Type.starts_with("ConstantBuffer");
				Edits.Replace(
					Variable.TypeAt, End, bBlock ? Variable.Type.substr(15, Variable.Type.size() - 16) : "uint");
			}
		}
	}
}

void FHlslResourceNumbers::DeclareGlobal(FHlslEdits& Edits, const FHlslVariable& Variable, const FGlobal& Global) const
{
	size_t End = Variable.At;
	std::map<char, int> Registers; // the next of each class
	std::string Space;
	for (; End < Text.Size() && !Text.Is(End, ";"); ++End)
	{
		if (Text.Is(End, "register") && Text.Is(End + 1, "(") && Text.IsWord(End + 2))
		{
			Registers[Text[End + 2].Text[0]] = std::atoi(Text[End + 2].Text.c_str() + 1);
			Space = Text.Is(End + 3, ",") ? ", " + Text[End + 4].Text : std::string();
		}
		if (Text.Is(End, ","))
		{
			const bool bList = Text.Is(End - 1, "]") || End - 1 == Variable.At;
			if (bList)
			{
				Errors.push_back(Text.MakeError(Variable.At, "arrays of resources are declared one by one"));
				return;
			}
		}
	}
	std::string Words;
	for (const FHlslLeaf& Leaf : Global.Parts)
	{
		const char Class = GetRegisterClass(Leaf.Type);
		const auto Register = Registers.find(Class);
		std::string Place;
		if (Register != Registers.end())
		{
			Place = " : register(" + std::string(1, Class) + std::to_string(Register->second++) + Space + ")";
		}
		const bool bBlock = Leaf.Type.starts_with("ConstantBuffer");
		Words += bBlock ? "cbuffer " + Leaf.Name + "_Block" + Place + " { " +
							  Leaf.Type.substr(15, Leaf.Type.size() - 16) + " " + Leaf.Name + "; }; "
						: Leaf.Type + " " + Leaf.Name + Place + "; ";
	}
	if (!Global.Struct.empty())
	{
		const std::string Name = Text[Variable.At].Text;
		std::string Value;
		for (int i = 0; i < Multiply(Global.Sizes, 0); ++i)
		{
			const std::string Element = Global.Sizes.empty() ? Name : Name + "_" + std::to_string(i);
			Value += (i ? ", " : "") + GetStructValue(Global.Struct, Element);
		}
		// If it were const, the front end would make wrong code of calls of its methods.
		Words += "static " + Global.Struct + " " + Name;
		for (const int Size : Global.Sizes)
		{
			Words += "[" + std::to_string(Size) + "]";
		}
		Words += " = " + (Global.Sizes.empty() ? Value : "{ " + Value + " }") + ";";
	}
	Edits.Replace(Variable.TypeAt, End + 1, Words);
}

std::string FHlslResourceNumbers::GetStructValue(const std::string& Struct, const std::string& Name) const
{
	std::string Value;
	for (const FHlslVariable& Member : *Symbols.GetMembers(Struct))
	{
		const std::string Path = Name + "_" + Text[Member.At].Text;
		const std::vector<int> Sizes = GetSizes(Member);
		std::string Part;
		for (int i = 0; i < Multiply(Sizes, 0); ++i)
		{
			const std::string Element = Sizes.empty() ? Path : Path + "_" + std::to_string(i);
			Part += (i ? ", " : "") + (IsNumbered(Member.Type) ? GetNumber({Element, Member.Type})
															   : GetStructValue(Member.Type, Element));
		}
		Value += (Value.empty() ? "" : ", ") + (Sizes.empty() ? Part : "{ " + Part + " }");
	}
	return "{ " + Value + " }";
}

std::optional<FHlslResourceUse> FHlslResourceNumbers::FindUse(size_t At) const
{
	const FHlslVariable* Variable = nullptr;
	size_t End = At + 1;
	std::string Path; // of a leaf; empty where an index is not a number
	const FGlobal* Global = nullptr;
	if (Text.Is(At, "this") && Text.Is(At + 1, ".") && Text.IsWord(At + 2))
	{
		Variable = Symbols.FindVariable(Text[At + 2].Text, At + 2);
		End = At + 3;
	}
	else
	{
		Variable = Symbols.FindVariable(Text[At].Text, At);
		const auto Found = Variable ? Globals.find(Variable->At) : Globals.end();
		Global = Found == Globals.end() ? nullptr : &Found->second;
		Path = Global ? Text[At].Text : std::string();
	}
	if (!Variable || Variable->At == At)
	{
		return {};
	}
	std::string Type = Variable->Type;
	std::vector<int> Sizes = Variable->bArray ? GetSizes(*Variable) : std::vector<int>();
	size_t NumIndices = 0;
	std::string Flat = "0u"; // the index into the leaves of an array
	for (;;)
	{
		if (NumIndices < Sizes.size() && Text.Is(End, "["))
		{
			const size_t Close = Text.FindClose(End);
			size_t First = End + 1;
			size_t Last = Close;
			if (Text.Is(First, "NonUniformResourceIndex") && Text.FindClose(First + 1) + 1 == Close)
			{
				First += 2;
				Last -= 1;
			}
			const bool bNumber = Last == First + 1 && Text[First].Kind == EShaderToken::Number;
			const int Stride = Multiply(Sizes, NumIndices + 1);
			Flat += " + uint(" + Text.GetText(First, Last) + ") * " + std::to_string(Stride) + "u";
			Path = bNumber && !Path.empty() ? Path + "[" + Text[First].Text : std::string();
			++NumIndices;
			End = Close + 1;
			continue;
		}
		const FHlslVariable* const Member = NumIndices == Sizes.size() && Text.Is(End, ".") && Text.IsWord(End + 1)
												? Symbols.FindMember(Type, Text[End + 1].Text)
												: nullptr;
		if (!Member)
		{
			break;
		}
		Path += Path.empty() ? std::string() : "." + Text[End + 1].Text;
		Type = Member->Type;
		Sizes = Member->bArray ? GetSizes(*Member) : std::vector<int>();
		NumIndices = 0;
		End += 2;
	}
	if (!IsNumbered(Type) || (Type.starts_with("ConstantBuffer") && !Global))
	{
		return {};
	}
	FHlslResourceUse Use{At, End, Type, {}, Text.GetText(At, End), NumIndices < Sizes.size(), {}};
	if (Global && Global->Struct.empty())
	{
		const std::string Base = Global->Parts.empty() ? "0u" : GetNumber(Global->Parts[0]);
		Use.Number = Sizes.empty() ? Base : "(" + Base + " + " + Flat + ")";
		for (int i = 0; i < Multiply(Sizes, NumIndices) && Use.bArray; ++i)
		{
			Use.PartNumbers.push_back(Base + " + " + Flat + " + " + std::to_string(i) + "u");
		}
	}
	// "A[1][2].B" names the leaf A_5_B of an array of [][3].
	for (const FHlslLeaf& Leaf : Global && !Use.bArray ? Global->Parts : std::vector<FHlslLeaf>())
	{
		if (!Path.empty() && Leaf.Name == GetLeafName(Path, *Variable))
		{
			Use.Name = Leaf.Name;
			Use.Number = GetNumber(Leaf);
		}
	}
	return Use;
}

std::string FHlslResourceNumbers::GetLeafName(const std::string& Path, const FHlslVariable& Variable) const
{
	std::string Name;
	const FHlslVariable* Member = &Variable;
	int Index = 0;
	size_t NumIndices = 0;
	for (size_t At = 0; At <= Path.size();)
	{
		const size_t End = std::min(Path.find_first_of(".[", At + 1), Path.size());
		const std::string Part = Path.substr(At, End - At);
		if (Part[0] == '[')
		{
			const std::vector<int> Sizes = GetSizes(*Member);
			Index += std::atoi(Part.c_str() + 1) * Multiply(Sizes, ++NumIndices);
			Name += NumIndices == Sizes.size() ? "_" + std::to_string(Index) : std::string();
		}
		else if (Part[0] == '.')
		{
			Member = Symbols.FindMember(Member->Type, Part.substr(1));
			Name += "_" + Part.substr(1);
			Index = 0;
			NumIndices = 0;
		}
		else
		{
			Name = Part;
		}
		At = End == Path.size() ? Path.size() + 1 : End;
	}
	return Name;
}

} // namespace Drydock
