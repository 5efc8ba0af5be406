// Initializers: lists in braces are flat, a scalar after the other, as HLSL has them.
#include "HlslAnalysisImpl.h"

#include <algorithm>

namespace Drydock::Hlsl
{

FValue* FAnalyser::Initialise(const FType* Type, const FExpression& Tree)
{
	if (Tree.Kind != EExpression::List)
	{
		FValue* const Value = Analyse(Tree);
		const bool bOpen = Type->IsArray() && Type->Count == 0 && Value->Type->IsArray() &&
						   IsSame(Type->Element, Value->Type->Element);
		return Convert(Value, bOpen ? Value->Type : Type);
	}
	std::vector<FValue*> Pieces;
	Collect(Tree, Pieces);
	const bool bBad = std::ranges::any_of(Pieces, [](const FValue* Each) { return IsError(Each); });
	if (bBad || Type->Kind == EType::Error)
	{
		return MakeError(Tree.Place);
	}
	return MakeFlat(Type, Pieces, Tree.Place);
}

void FAnalyser::Collect(const FExpression& Tree, std::vector<FValue*>& Pieces)
{
	const FLevel Level(Depth);
	for (const FExpression* Each : Tree.Operands)
	{
		if (Each->Kind != EExpression::List)
		{
			Pieces.push_back(OpenConstantBuffer(Analyse(*Each)));
		}
		else if (Depth > MaxValueDepth)
		{
			Pieces.push_back(Fail(Each->Place, "lists are nested too deeply"));
		}
		else
		{
			Collect(*Each, Pieces);
		}
	}
}

/** The types of all scalars and resources, in order. */
void FAnalyser::ListLeaves(const FType* Type, std::vector<const FType*>& Leaves)
{
	if (Type->IsNumeric())
	{
		Leaves.insert(Leaves.end(), Type->NumComponents(), Type->IsEnum() ? Type : Types->Scalar(Type->Scalar));
	}
	else if (Type->IsArray())
	{
		for (uint32_t i = 0; i < Type->Count; ++i)
		{
			ListLeaves(Type->Element, Leaves);
		}
	}
	else if (Type->IsStruct())
	{
		for (const FMember& Member : Type->Struct->Members)
		{
			ListLeaves(Member.Type, Leaves);
		}
	}
	else if (Type->IsObject())
	{
		Leaves.push_back(Type);
	}
}

FValue* FAnalyser::MakeFlat(const FType* Type, const std::vector<FValue*>& Pieces, const FPlace& Place)
{
	uint64_t Given = 0;
	for (const FValue* Piece : Pieces)
	{
		Given += CountLeaves(Piece->Type);
	}
	if (Type->IsArray() && Type->Count == 0)
	{
		const uint64_t Each = CountLeaves(Type->Element);
		if (Each == 0 || Given == 0 || Given % Each != 0 || Given > MaxLeaves)
		{
			return Fail(Place, "X3037: initializer does not match type '" + GetName(Type) + "': it has " +
								   std::to_string(Given) + " values, and each element takes " + std::to_string(Each));
		}
		Type = Types->Array(Type->Element, uint32_t(Given / Each));
	}
	const uint64_t Wanted = CountLeaves(Type);
	if (Given != Wanted)
	{
		const bool bZero = Given == 1 && Pieces[0]->Kind == EValue::Constant;
		return Fail(Place,
			"X3037: initializer does not match type '" + GetName(Type) + "': it has " + std::to_string(Given) +
				(Given == 1 ? " value" : " values") + ", and the type takes " + std::to_string(Wanted) +
				(bZero && Given < Wanted ? "; for the same value everywhere write (" + GetName(Type) + ")0" : ""));
	}
	if (Pieces.size() == 1 && IsSame(Pieces[0]->Type, Type))
	{
		return Pieces[0];
	}
	std::vector<const FType*> Leaves;
	ListLeaves(Type, Leaves);
	std::vector<FValue*> Parts;
	std::vector<FValue*> Before;
	size_t At = 0;
	for (FValue* Piece : Pieces)
	{
		if (!Spread(Piece, Leaves, At, Parts, Before))
		{
			return MakeError(Place);
		}
	}
	if (Parts.size() == 1 && IsSame(Parts[0]->Type, Type))
	{
		Before.push_back(Parts[0]);
	}
	else
	{
		Before.push_back(Simplify(Make(EValue::Compose, Type, Place, std::move(Parts))));
	}
	return MakeCommas(std::move(Before));
}

/** A piece as the leaves from At on: whole where its scalars become one type, else taken apart. */
bool FAnalyser::Spread(FValue* Piece, const std::vector<const FType*>& Leaves, size_t& At, std::vector<FValue*>& Parts,
	std::vector<FValue*>& Before)
{
	const FType* const Type = Piece->Type;
	const size_t Count = size_t(CountLeaves(Type));
	if (Count == 0)
	{
		return true;
	}
	const FType* const First = Leaves[At];
	const bool bOne = std::all_of(Leaves.begin() + std::ptrdiff_t(At), Leaves.begin() + std::ptrdiff_t(At + Count),
		[First](const FType* Each) { return IsSame(Each, First); });
	if (Type->IsObject() || (Type->IsNumeric() && (Count == 1 || (bOne && !First->IsEnum()))))
	{
		const FType* const To = Type->IsObject() || Count == 1 ? First
								: First->IsNumeric()           ? Types->WithScalar(Type, First->Scalar)
															   : First;
		FValue* const Part = Convert(Piece, To);
		At += Count;
		Parts.push_back(Part);
		return !IsError(Part);
	}
	std::vector<const FType*> Own;
	ListLeaves(Type, Own);
	const bool bSame = !Type->IsNumeric() && std::equal(Own.begin(), Own.end(), Leaves.begin() + std::ptrdiff_t(At),
												 [](const FType* A, const FType* B) { return IsSame(A, B); });
	if (bSame)
	{
		At += Count;
		Parts.push_back(Piece);
		return true;
	}
	Piece = MakeOnce(Piece, Before);
	const size_t NumInner = Type->IsStruct()   ? Type->Struct->Members.size()
							: Type->IsArray()  ? Type->Count
							: Type->IsMatrix() ? Type->Rows
											   : Type->Columns;
	for (size_t i = 0; i < NumInner; ++i)
	{
		FSymbol Field;
		Field.Index = uint32_t(i);
		FValue* const Inner =
			Type->IsStruct()
				? MakeField(Piece, Field, Piece->Place)
				: MakeIndex(Piece, MakeConstant(Types->Scalar(EScalar::Uint), {i}, Piece->Place), Piece->Place);
		if (IsError(Inner) || !Spread(Inner, Leaves, At, Parts, Before))
		{
			return false;
		}
	}
	return true;
}

} // namespace Drydock::Hlsl
