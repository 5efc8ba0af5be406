// Access: members, swizzles, elements of matrices, indices into arrays and resources, members of uniform buffers.
#include "HlslAnalysisImpl.h"

#include <algorithm>

namespace Drydock::Hlsl
{

FStructInfo* FAnalyser::GetInfo(const FType* Type) const
{
	return static_cast<FStructInfo*>(const_cast<void*>(Type->Struct->Scope));
}

/** "View.Foo", which is the variable View_Foo of the text; null where it is none. */
FValue* FAnalyser::FindUniform(const FExpression& Tree)
{
	const FExpression& Object = *Tree.Operands[0];
	const bool bName = Object.Kind == EExpression::Name && Object.Name.Parts.size() == 1 && !Object.bParenthesized;
	if (!bName || FindName(Object.Name.Last()))
	{
		return nullptr;
	}
	const std::string Name(Object.Name.Last());
	const std::string Member(Tree.Name.Last());
	std::vector<std::string> Known;
	for (const auto& [Buffer, Members] : Options.UniformBuffers)
	{
		Known.push_back(Buffer);
		if (Buffer != Name)
		{
			continue;
		}
		const auto Found = File->Symbols.find(std::string_view(Buffer + "_" + Member));
		FNameScope* Where = File;
		return Found != File->Symbols.end() ? MakeNamed(Found->second, Where, Object)
											: Fail(Tree.Place, "uniform buffer '" + Name + "' has no member '" +
																   Member + "'" + SuggestName(Member, Members));
	}
	const std::string Nearest = FindNearestName(Name, Known);
	const bool bVariable = !FindNearestName(Name, ListNames(false, false)).empty();
	return Nearest.empty() || bVariable
			   ? nullptr
			   : Fail(Object.Place, "X3004: undeclared identifier '" + Name +
										"', and no uniform buffer of that name is registered; did you mean " + Nearest +
										"?");
}

FValue* FAnalyser::AnalyseMember(const FExpression& Tree)
{
	if (FValue* const Uniform = FindUniform(Tree))
	{
		return Uniform;
	}
	return MakeMember(Analyse(*Tree.Operands[0]), Tree.Name, Tree.Place);
}

FValue* FAnalyser::MakeMember(FValue* Object, const FName& Name, const FPlace& Place)
{
	if (IsError(Object))
	{
		return Object;
	}
	const FType* const Type = Object->Type;
	const std::string Last(Name.Last());
	if (Type->IsNumeric() && !Type->IsEnum())
	{
		return Type->IsMatrix() ? MakeElements(Object, Name.Last(), Place) : MakeSwizzle(Object, Name.Last(), Place);
	}
	const bool bBlock = Type->IsObject() && Type->Element && Type->Element->IsStruct() &&
						(Type->Object == EObject::ConstantBuffer || Type->Object == EObject::TextureBuffer);
	if (Options.bFxcRules && Last == "Length" && Type->IsObject() && IsTexture(Type->Object))
	{
		const bool bCube = Type->Object == EObject::TextureCube || Type->Object == EObject::TextureCubeArray;
		const uint32_t Count = GetDimensions(Type->Object) - (bCube ? 1 : 0);
		const FType* const Size = Count > 1 ? Types->Vector(EScalar::Uint, Count) : Types->Scalar(EScalar::Uint);
		FValue* const Value = Make(EValue::Method, Size, Place, {Object});
		Value->Name = "Length"; // FXC's: the sizes of the first mip
		return Value;
	}
	if (!Type->IsStruct() && !bBlock)
	{
		const std::string Advice =
			Type->IsArray() ? "; name an element with [ ]"
			: Type->IsObject()
				? (ListMethods(Type).empty() ? ""
											 : SuggestName(Last, ListMethods(Type)) + " (methods are called with ())")
				: "";
		return Fail(Place, "X3018: '" + GetName(Type) + "' has no member '" + Last + "'" + Advice);
	}
	FNameScope* Where = GetInfo(bBlock ? Type->Element : Type)->Scope;
	if (Name.Parts.size() > 1) // of a base
	{
		FName Base = Name;
		Base.Parts.pop_back();
		FSymbol* const Symbol = FindQualified(Base);
		FNameScope* const Scope = Symbol ? FindScopeOf(*Symbol, Base.Parts.back()) : nullptr;
		Where = Scope ? Scope : Where;
	}
	FSymbol* const Symbol = FindIn(*Where, Name.Last(), &Where);
	if (Symbol && Symbol->Kind == ESymbol::Field)
	{
		return MakeField(Object, *Symbol, Place);
	}
	if (Symbol && (Symbol->Kind == ESymbol::Variable || Symbol->Kind == ESymbol::Enumerator))
	{
		FExpression Tree;
		Tree.Place = Place;
		return MakeNamed(*Symbol, Where, Tree);
	}
	if (Symbol && Symbol->Kind == ESymbol::Functions)
	{
		return Fail(Place, "X3005: '" + Last + "' is a method; call it with ()");
	}
	std::vector<std::string> Known;
	for (const FMember& Member : (bBlock ? Type->Element : Type)->Struct->Members)
	{
		Known.push_back(Member.Name);
	}
	return Fail(Place, "X3018: '" + GetName(Type) + "' has no member '" + Last + "'" + SuggestName(Last, Known));
}

FValue* FAnalyser::MakeField(FValue* Object, FSymbol& Field, const FPlace& Place)
{
	if (IsError(Object))
	{
		return Object;
	}
	const bool bBase = Object->Kind == EValue::Cast && Object->Operands[0]->Type->IsStruct() &&
					   FindConversion(*Types, Object->Operands[0]->Type, Object->Type).bPossible;
	Object = bBase ? Object->Operands[0] : Object; // members of bases come first
	const FType* const Type = Object->Type->IsObject() ? Object->Type->Element : Object->Type;
	if (Field.Index >= Type->Struct->Members.size())
	{
		return MakeError(Place);
	}
	const FType* const Own = Type->Struct->Members[Field.Index].Type;
	if (Own->Kind == EType::Error)
	{
		return MakeError(Place);
	}
	FValue* const Value = Make(EValue::Member, Own, Place, {Object});
	Value->Index = Field.Index;
	Value->bPlace = Object->bPlace && !Object->Type->IsObject();
	Value->bConst = Object->bConst || (Type->Struct->Members[Field.Index].Modifiers & ModifierConst) != 0;
	if (Field.Bits.Count == 0)
	{
		return Simplify(Value);
	}
	FValue* const Bits =
		Make(EValue::Bits, Types->Scalar(Field.Bits.bSigned ? EScalar::Int : EScalar::Uint), Place, {Value});
	Bits->Bits = Field.Bits;
	Bits->bPlace = Value->bPlace;
	Bits->bConst = Value->bConst;
	return Bits;
}

FValue* FAnalyser::MakeSwizzle(FValue* Object, std::string_view Text, const FPlace& Place)
{
	const FType* const Type = Object->Type;
	std::vector<uint8_t> Parts;
	for (const std::string_view Set : {std::string_view("xyzw"), std::string_view("rgba")})
	{
		Parts.clear();
		for (const char Letter : Text)
		{
			const size_t At = Set.find(Letter);
			if (At < Type->Columns)
			{
				Parts.push_back(uint8_t(At));
			}
		}
		if (Parts.size() == Text.size())
		{
			break;
		}
	}
	if (Parts.empty() || Parts.size() != Text.size() || Parts.size() > 4)
	{
		const bool bLetters = Text.find_first_not_of("xyzwrgba") == std::string_view::npos && Text.size() <= 4;
		const bool bMixed = Text.find_first_of("xyzw") != std::string_view::npos &&
							Text.find_first_of("rgba") != std::string_view::npos;
		return Fail(Place, "X3018: invalid subscript '" + std::string(Text) + "': '" + GetName(Type) + "' has " +
							   (bLetters && bMixed ? "xyzw or rgba, but not both in one swizzle"
												   : "the components " + std::string("xyzw").substr(0, Type->Columns)));
	}
	std::vector<uint8_t> Sorted = Parts;
	std::ranges::sort(Sorted);
	const uint32_t Count = uint32_t(Parts.size());
	FValue* const Value = Make(EValue::Swizzle,
		Count == 1 ? Types->Scalar(Type->Scalar) : Types->Vector(Type->Scalar, Count), Place, {Object});
	Value->bPlace = Object->bPlace && std::ranges::adjacent_find(Sorted) == Sorted.end();
	Value->bConst = Object->bConst;
	Value->Parts = std::move(Parts);
	return Simplify(Value);
}

/** `_m00_m11` counts from 0, `_11_22` from 1. */
FValue* FAnalyser::MakeElements(FValue* Object, std::string_view Text, const FPlace& Place)
{
	const FType* const Type = Object->Type;
	const bool bZero = Text.starts_with("_m");
	const size_t Width = bZero ? 4 : 3;
	std::vector<uint8_t> Parts;
	bool bGood = !Text.empty() && Text.size() % Width == 0 && Text.size() / Width <= 4;
	for (size_t i = 0; i < Text.size() && bGood; i += Width)
	{
		const int Row = Text[i + Width - 2] - (bZero ? '0' : '1');
		const int Column = Text[i + Width - 1] - (bZero ? '0' : '1');
		bGood = Text[i] == '_' && (!bZero || Text[i + 1] == 'm') && Row >= 0 && Row < Type->Rows && Column >= 0 &&
				Column < Type->Columns;
		Parts.push_back(uint8_t(Row * 4 + Column));
	}
	if (!bGood)
	{
		return Fail(Place, "X3018: invalid subscript '" + std::string(Text) + "': elements of '" + GetName(Type) +
							   "' are written _m00 to _m" + std::to_string(Type->Rows - 1) +
							   std::to_string(Type->Columns - 1) + " or _11 to _" + std::to_string(Type->Rows) +
							   std::to_string(Type->Columns) + ", up to four of one kind");
	}
	std::vector<uint8_t> Sorted = Parts;
	std::ranges::sort(Sorted);
	const uint32_t Count = uint32_t(Parts.size());
	FValue* const Value = Make(EValue::Elements,
		Count == 1 ? Types->Scalar(Type->Scalar) : Types->Vector(Type->Scalar, Count), Place, {Object});
	Value->bPlace = Object->bPlace && std::ranges::adjacent_find(Sorted) == Sorted.end();
	Value->bConst = Object->bConst;
	Value->Parts = std::move(Parts);
	return Simplify(Value);
}

FValue* FAnalyser::AnalyseIndex(const FExpression& Tree)
{
	const FExpression& Inner = *Tree.Operands[0];
	const bool bLevels = Inner.Kind == EExpression::Index && Inner.Operands[0]->Kind == EExpression::Member &&
						 (Inner.Operands[0]->Name.Last() == "mips" || Inner.Operands[0]->Name.Last() == "sample");
	FValue* Object = nullptr;
	if (bLevels)
	{
		const FExpression& Member = *Inner.Operands[0];
		FValue* const Texture = FindUniform(Member) ? nullptr : Analyse(*Member.Operands[0]);
		if (Texture && Texture->Type->IsObject())
		{
			FValue* const Level = Analyse(*Inner.Operands[1]);
			return MakeMip(Member, Texture, Level, Analyse(*Tree.Operands[1]));
		}
		FValue* const Array = Texture ? MakeMember(Texture, Member.Name, Member.Place) : AnalyseMember(Member);
		Object = MakeIndex(Array, Analyse(*Inner.Operands[1]), Inner.Place);
	}
	else
	{
		Object = Analyse(Inner);
	}
	FValue* const Index = Analyse(*Tree.Operands[1]);
	if (IsError(Object) || IsError(Index))
	{
		return MakeError(Tree.Place);
	}
	if (Object->Type->IsStruct())
	{
		return CallOperator("[]", Object, {Index}, Tree.Place);
	}
	return Object->Type->IsObject() ? MakeElement(Object, Index, Tree.Place) : MakeIndex(Object, Index, Tree.Place);
}

FValue* FAnalyser::MakeIndex(FValue* Object, FValue* Index, const FPlace& Place)
{
	if (IsError(Object) || IsError(Index))
	{
		return MakeError(Place);
	}
	const FType* const Type = Object->Type;
	const bool bIndexed = Type->IsArray() || Type->IsVector() || Type->IsMatrix();
	if (!bIndexed)
	{
		return Fail(
			Place, "X3121: array, matrix, vector, or indexable object type expected in index expression, not '" +
					   GetName(Type) + "'");
	}
	if (!Index->Type->IsNumeric() || Index->Type->NumComponents() != 1 || Index->Type->bScoped)
	{
		return Fail(Index->Place, "X3120: invalid type for index: '" + GetName(Index->Type) + "'; it is an integer");
	}
	const uint32_t Count = Type->IsArray() ? Type->Count : Type->IsMatrix() ? Type->Rows : Type->Columns;
	const bool bUnsigned = IsUnsigned(Index->Type->Scalar);
	Index = Convert(Index, Types->Scalar(bUnsigned ? EScalar::Uint : EScalar::Int));
	if (IsError(Index))
	{
		return Index;
	}
	const std::optional<FConstant> Known = IsKnown(*Index) ? Fold(*Types, *Index) : std::nullopt;
	if (Known && Count > 0 && uint32_t(Known->at(0)) >= Count)
	{
		const std::string Number =
			bUnsigned ? std::to_string(uint32_t(Known->at(0))) : std::to_string(int32_t(uint32_t(Known->at(0))));
		return Fail(Index->Place, "X3504: array index out of bounds: '" + GetName(Type) + "' has 0 to " +
									  std::to_string(Count - 1) + ", not " + Number);
	}
	const FType* const Element = Type->IsArray()    ? Type->Element
								 : Type->IsMatrix() ? Types->Vector(Type->Scalar, Type->Columns)
													: Types->Scalar(Type->Scalar);
	FValue* const Value =
		Make(EValue::Index, Element, Place, {Object, Known ? MakeConstant(Index->Type, *Known, Index->Place) : Index});
	Value->bPlace = Object->bPlace;
	Value->bConst = Object->bConst;
	return Simplify(Value);
}

FValue* FAnalyser::MakeElement(FValue* Object, FValue* Index, const FPlace& Place)
{
	const FType* const Type = Object->Type;
	const EObject Kind = Type->Object;
	const bool bCube = Kind == EObject::TextureCube || Kind == EObject::TextureCubeArray;
	const bool bQueue = Kind == EObject::AppendStructuredBuffer || Kind == EObject::ConsumeStructuredBuffer;
	const uint32_t Count = GetDimensions(Kind);
	if (!Type->Element || bCube || bQueue || Count == 0)
	{
		const bool bBytes = Kind == EObject::ByteAddressBuffer || Kind == EObject::RWByteAddressBuffer;
		return Fail(Place, "X3121: '" + GetName(Type) + "' cannot be indexed" +
							   (bBytes ? "; write Load(Address) and Store(Address, Value)"
								   : Kind == EObject::AppendStructuredBuffer  ? "; write Append(Value)"
								   : Kind == EObject::ConsumeStructuredBuffer ? "; write Consume()"
								   : bCube                                    ? "; write SampleLevel(...)"
																			  : ""));
	}
	const bool bIndex = Index->Type->IsNumeric() && !Index->Type->IsMatrix() && !Index->Type->bScoped;
	if (!bIndex || (Count > 1 && Index->Type->NumComponents() < Count))
	{
		const std::string Wanted = Count == 1 ? "uint" : "uint" + std::to_string(Count);
		return Fail(Index->Place,
			"X3120: invalid type for index: '" + GetName(Index->Type) + "'; '" + GetName(Type) + "' takes " + Wanted);
	}
	const EScalar From = Index->Type->Scalar;
	const EScalar Scalar =
		IsInteger(From) && !IsUnsigned(From) && From != EScalar::LiteralInt ? EScalar::Int : EScalar::Uint;
	Index = Convert(Index, Count == 1 ? Types->Scalar(Scalar) : Types->Vector(Scalar, Count));
	if (IsError(Index))
	{
		return Index;
	}
	const FType* const Element =
		Type->Element->IsNumeric() ? Types->WithNorm(Type->Element, false, false) : Type->Element;
	FValue* const Value = Make(EValue::Element, Element, Place, {Object, Index});
	Value->bPlace = IsWritable(Kind);
	Value->bConst = !Value->bPlace;
	return Value;
}

/** `T.mips[Level][Position]`: a Load. */
FValue* FAnalyser::MakeMip(const FExpression& Tree, FValue* Object, FValue* Level, FValue* Index)
{
	if (IsError(Level) || IsError(Index))
	{
		return MakeError(Tree.Place);
	}
	const uint32_t Count = GetDimensions(Object->Type->Object);
	if (Tree.Name.Last() == "sample" || !IsTexture(Object->Type->Object) || IsWritable(Object->Type->Object) ||
		Count == 0)
	{
		return Fail(
			Tree.Place, "X3018: '" + GetName(Object->Type) + "' has no '" + std::string(Tree.Name.Last()) + "'");
	}
	Index = Convert(Index, Count == 1 ? Types->Scalar(EScalar::Int) : Types->Vector(EScalar::Int, Count));
	Level = Convert(Level, Types->Scalar(EScalar::Int));
	if (IsError(Level) || IsError(Index))
	{
		return MakeError(Tree.Place);
	}
	FValue* const Position =
		Simplify(Make(EValue::Compose, Types->Vector(EScalar::Int, Count + 1), Tree.Place, {Index, Level}));
	const FIntrinsicCall Call = FindMethodCall(*Types, Object->Type, "Load", {}, {Position->Type});
	return Call.Error.empty() ? FinishBuiltIn(EValue::Method, Call, {Position}, Object, "Load", Tree.Place)
							  : Fail(Tree.Place, Call.Error);
}

/** The struct that a ConstantBuffer holds, as a value. */
FValue* FAnalyser::OpenConstantBuffer(FValue* Object)
{
	const FType* const Type = Object->Type;
	const bool bBlock =
		Type->IsObject() && (Type->Object == EObject::ConstantBuffer || Type->Object == EObject::TextureBuffer);
	if (!bBlock || !Type->Element || !Type->Element->IsStruct())
	{
		return Object;
	}
	std::vector<FValue*> Members;
	for (size_t i = 0; i < Type->Element->Struct->Members.size(); ++i)
	{
		FSymbol Field;
		Field.Index = uint32_t(i);
		Members.push_back(MakeField(Object, Field, Object->Place));
	}
	return Make(EValue::Compose, Type->Element, Object->Place, std::move(Members));
}

} // namespace Drydock::Hlsl
