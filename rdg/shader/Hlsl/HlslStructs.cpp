// Structs and enumerations, when one is first named.
#include "HlslAnalysisImpl.h"

#include <algorithm>

namespace Drydock::Hlsl
{

const FType* FAnalyser::CompleteEnum(FSymbol& Symbol)
{
	if (Symbol.Type)
	{
		return Symbol.Type;
	}
	FPosition Position = Here;
	Position.Scope = Symbol.Inner;
	Position.Order = Symbol.Order ? Symbol.Order : Here.Order;
	const FPositionGuard Guard(*this, Position);
	const FEnum& Enum = *Symbol.Enum;
	const FType* const Base = Enum.Base ? FindType(*Enum.Base, 0) : Types->Scalar(EScalar::Int);
	const bool bGood = Base->IsScalar() && !IsReal(Base->Scalar);
	if (!bGood && Base->Kind != EType::Error)
	{
		Error(Enum.Base->Place, "X3000: an enumeration is of integers, not of '" + GetName(Base) + "'");
	}
	const EScalar Scalar = bGood ? Base->Scalar : EScalar::Int;
	Symbol.Type = Types->Enum(Enum.Name.empty() ? "enum" : Enum.Name, &Symbol, Scalar, Enum.bScoped);
	std::vector<FValue*> Made;
	int64_t Next = 0;
	for (const FEnumerator& Each : Enum.Enumerators)
	{
		if (Each.Value)
		{
			Next = FindInteger(*Each.Value, "the value of '" + std::string(Each.Name) + "'").value_or(Next);
		}
		const auto Found = Symbol.Inner->Symbols.find(Each.Name);
		const uint64_t Bits = Types->GetBits(Scalar) == 64 ? uint64_t(Next) : uint64_t(uint32_t(Next));
		if (Found != Symbol.Inner->Symbols.end())
		{
			// Within its braces it is an integer.
			Found->second.Value =
				MakeConstant(Types->Scalar(Scalar), {Scalar == EScalar::Bool ? Bits & 1 : Bits}, Each.Place);
			Made.push_back(Found->second.Value);
		}
		++Next;
	}
	for (FValue* Each : Made)
	{
		Each->Type = Symbol.Type;
	}
	return Symbol.Type;
}

FStructInfo* FAnalyser::MakeStruct(const FStruct& Struct, FNameScope& Scope, const std::string& Name, uint32_t Order)
{
	FStructInfo& Info = Structs.emplace_back();
	Info.Tree = &Struct;
	Info.Scope = MakeScope(EScopeKind::Struct, &Scope, Name);
	Info.Scope->Struct = &Info;
	Info.Name = Scope.Prefix + Name;
	Info.Order = Order;
	EnterAll(Struct.Members, *Info.Scope);
	return &Info;
}

const FType* FAnalyser::CompleteStruct(FStructInfo& Info, const FPlace& Place)
{
	if (Info.Type)
	{
		return Info.Type;
	}
	if (Info.bBusy)
	{
		Error(Place, "X3000: the struct '" + Info.Name + "' is made of itself");
		return Types->Error();
	}
	const FLevel Level(TypeDepth);
	Info.bBusy = true;
	FPosition Position;
	Position.Scope = Info.Scope;
	Position.Order = Info.Order;
	const FPositionGuard Guard(*this, Position);
	FStructType Type;
	Type.Name = Info.Name;
	Type.Place = Info.Tree->Place;
	Type.Scope = &Info;
	AddMembers(Info, Type);
	if (Info.NumLeaves > MaxLeaves)
	{
		Error(
			Info.Tree->Place, "the struct '" + Info.Name + "' has more than " + std::to_string(MaxLeaves) + " numbers");
		Info.Type = Types->Error();
	}
	else
	{
		Info.Type = Types->Struct(std::move(Type));
	}
	Info.bBusy = false;
	return Info.Type;
}

/** Puts a bit field behind the one before it, in the same integer where there is room. */
bool FAnalyser::AddBits(const FDeclaration& Declaration, FStructInfo& Info, FStructType& Type, FSymbol* Field)
{
	constexpr uint32_t Most = 32;
	const std::string Name = "the bit field '" + std::string(Declaration.Name.Last()) + "'";
	const FType* const Own = FindDeclaredType(Declaration);
	const int64_t Width = FindInteger(*Declaration.Width, "the width of " + Name).value_or(0);
	const bool bInteger =
		Own->IsScalar() && !Own->IsEnum() && (Own->Scalar == EScalar::Int || Own->Scalar == EScalar::Uint);
	const bool bGap = Declaration.Name.Last().empty();
	if (bGap && bInteger && Width == 0)
	{
		Info.NumBits = Most; // the next field begins an integer
		return false;
	}
	if (!bInteger || Width < 1 || Width > Most)
	{
		Error(Declaration.Place, Name + " is of int or uint and has 1 to 32 bits");
		return false;
	}
	const bool bFits = Info.NumBits > 0 && Info.NumBits + Width <= Most;
	if (!bFits)
	{
		FMember Member;
		Member.Name = std::string(Declaration.Name.Last());
		Member.Type = Types->Scalar(EScalar::Uint);
		Member.Place = Declaration.Place;
		Type.Members.push_back(std::move(Member));
		Info.NumBits = 0;
	}
	if (Field)
	{
		Field->Index = uint32_t(Type.Members.size()) - 1;
		Field->Bits = {uint8_t(Info.NumBits), uint8_t(Width), Own->Scalar == EScalar::Int};
	}
	Info.NumBits += uint32_t(Width);
	return !bFits;
}

void FAnalyser::AddMembers(FStructInfo& Info, FStructType& Type)
{
	if (Info.Tree->Bases.size() > 1)
	{
		Error(Info.Tree->Bases[1]->Place, "'" + Info.Name + "' has two bases; a struct of HLSL has one");
	}
	if (!Info.Tree->Bases.empty())
	{
		const FType* const Base = FindType(*Info.Tree->Bases[0], 0);
		if (Base->IsStruct())
		{
			Info.Base = GetInfo(Base);
			Type.Bases.push_back(Base);
			Type.Members = Base->Struct->Members;
			Info.NumLeaves = Info.Base->NumLeaves;
		}
		else if (Base->Kind != EType::Error)
		{
			Error(
				Info.Tree->Bases[0]->Place, "the base '" + GetName(Base) + "' of '" + Info.Name + "' is not a struct");
		}
	}
	for (const FDeclaration* Declaration : Info.Tree->Members)
	{
		if (Declaration->Kind != EDeclaration::Variable || Declaration->Modifiers & ModifierStatic)
		{
			continue;
		}
		const auto Field = Info.Scope->Symbols.find(Declaration->Name.Last());
		const bool bField = Field != Info.Scope->Symbols.end() && Field->second.Declaration == Declaration;
		if (Declaration->Width)
		{
			Info.NumLeaves += AddBits(*Declaration, Info, Type, bField ? &Field->second : nullptr);
			continue;
		}
		Info.NumBits = 0;
		FMember Member;
		Member.Name = std::string(Declaration->Name.Last());
		Member.Type = FindDeclaredType(*Declaration);
		Member.Place = Declaration->Place;
		Member.Semantic = FindSemantic(Declaration->Annotations);
		Member.Modifiers = Declaration->Modifiers | Declaration->Type->Modifiers;
		if (bField)
		{
			Field->second.Index = uint32_t(Type.Members.size());
		}
		if (Declaration->Value)
		{
			Error(Declaration->Value->Place,
				"'" + Member.Name +
					"': members of a struct have no initial values in HLSL; set it where a variable of '" + Info.Name +
					"' is made");
		}
		if (Member.Type->IsArray() && Member.Type->Count == 0)
		{
			Error(Declaration->Place, "X3072: '" + Member.Name + "': the size of an array must be given");
			Member.Type = Types->Error();
		}
		const uint64_t Leaves = CountLeaves(Member.Type);
		Info.NumLeaves = std::min<uint64_t>(Info.NumLeaves + Leaves, MaxLeaves + 1);
		Type.Members.push_back(std::move(Member));
	}
}

} // namespace Drydock::Hlsl
