// Declarations: types from their names, structs and enums when one is first named.
#include "HlslAnalysisImpl.h"

#include <algorithm>
#include <tuple>

namespace Drydock::Hlsl
{

namespace
{

constexpr int MaxTypeDepth = 128;

/** Why an object of this name cannot be used, with a way round; empty: it can. */
std::string ExplainObject(const FType* Type)
{
	const std::string Name(Type->ObjectName);
	if (Type->Object == EObject::Texture2DMS || Type->Object == EObject::Texture2DMSArray)
	{
		return "a multisampled texture ('" + Name +
			   "') does not run on the CPU tier; resolve it into a Texture2D first";
	}
	if (Type->Object != EObject::Unsupported)
	{
		return {};
	}
	const bool bRays = Name.starts_with("Ray") || Name.starts_with("BuiltInTriangle");
	if (bRays)
	{
		return "ray tracing ('" + Name +
			   "') does not run on the CPU tier; march through the depth texture, or read what the G-buffer has";
	}
	if (Name.find("Stream") != std::string::npos || Name.find("Patch") != std::string::npos)
	{
		return "geometry shaders and tessellation ('" + Name +
			   "') do not run on the CPU tier; drydock draws screen passes: do it in a pixel or compute shader";
	}
	if (Name.find("sampler") != std::string::npos || Name.find("texture") != std::string::npos ||
		Name.find("Sampler") != std::string::npos)
	{
		return "'" + Name +
			   "' is of Direct3D 9; declare a Texture2D and a SamplerState, and write Texture.Sample(Sampler, UV)";
	}
	return "'" + Name + "' does not run on the CPU tier; use a Texture2D or a buffer";
}

} // namespace

bool FAnalyser::IsUsable(const FType* Type, const FPlace& Place)
{
	while (Type->IsArray())
	{
		Type = Type->Element;
	}
	const std::string Why = Type->IsObject() ? ExplainObject(Type) : std::string();
	if (!Why.empty())
	{
		Error(Place, Why);
	}
	return Why.empty();
}

const FType* FAnalyser::FindType(const FTypeName& Name, uint32_t Modifiers)
{
	const FLevel Level(TypeDepth);
	if (TypeDepth > MaxTypeDepth)
	{
		Error(Name.Place, "types are nested in each other more than " + std::to_string(MaxTypeDepth) + " times");
		return Types->Error();
	}
	const uint32_t All = Name.Modifiers | Modifiers;
	const FType* Type = nullptr;
	if (Name.Struct)
	{
		FSymbol* const Symbol = Name.Struct->Name.empty() ? nullptr : FindName(Name.Struct->Name);
		FStructInfo* Info =
			Symbol && Symbol->Struct == Name.Struct ? nullptr : StructsByTree[{Name.Struct, Here.Scope}];
		if (Symbol && Symbol->Struct == Name.Struct)
		{
			Type = FindSymbolType(*Symbol, FNamePart());
		}
		else
		{
			const std::string_view Own = Name.Struct->Name.empty() ? "struct" : Name.Struct->Name;
			Info = Info ? Info : MakeStruct(*Name.Struct, *Here.Scope, std::string(Own), Here.Order);
			StructsByTree[{Name.Struct, Here.Scope}] = Info;
			Type = CompleteStruct(*Info, Name.Place);
		}
	}
	else if (Name.Enum)
	{
		EnterEnum(*Name.Enum, *Here.Scope);
		const auto Known = EnumsByTree.find({Name.Enum, Here.Scope});
		Type = Known == EnumsByTree.end() ? Types->Error() : CompleteEnum(*Known->second);
	}
	else
	{
		Type = FindNamedType(Name, All);
	}
	if (All & (ModifierUnorm | ModifierSnorm) && Type->IsNumeric())
	{
		Type = Types->WithNorm(Type, (All & ModifierUnorm) != 0, (All & ModifierSnorm) != 0);
	}
	return AddDimensions(Type, Name.Dimensions, Name.Place);
}

const FType* FAnalyser::FindDeclaredType(const FDeclaration& Declaration, bool bParameter)
{
	const FType* const Type =
		AddDimensions(FindType(*Declaration.Type, Declaration.Modifiers), Declaration.Dimensions, Declaration.Place);
	if (Type->Kind == EType::Void || Type->Kind == EType::String)
	{
		const bool bVoid = Type->Kind == EType::Void;
		Error(Declaration.Place, std::string("X3038: '") + std::string(Declaration.Name.Last()) +
									 (bVoid ? "': variables cannot be void" : "': strings have no variables"));
		return Types->Error();
	}
	const uint32_t Modifiers = Declaration.Modifiers;
	const FType* Inner = Type;
	while (Inner->IsArray())
	{
		Inner = Inner->Element;
	}
	if (Modifiers & (ModifierRowMajor | ModifierColumnMajor) && Inner->IsNumeric() && !Inner->IsMatrix())
	{
		Error(Declaration.Type->Place, "X3077: non-matrix types cannot be declared 'row_major' or 'column_major'");
	}
	if (Modifiers & (ModifierUnorm | ModifierSnorm) && Inner->IsNumeric() && !IsReal(Inner->Scalar))
	{
		Error(Declaration.Type->Place, "X3085: unorm and snorm are of floats, not of '" + GetName(Inner) + "'");
	}
	const bool bOpen = Type->IsArray() && Type->Count == 0;
	if (bParameter && bOpen)
	{
		Error(Declaration.Place, "X3058: array dimensions of function parameters must be explicit ('" +
									 std::string(Declaration.Name.Last()) + "[]')");
		return Types->Error();
	}
	return IsUsable(Type, Declaration.Type->Place) ? Type : Types->Error();
}

const FType* FAnalyser::AddDimensions(
	const FType* Type, const std::vector<FExpression*>& Dimensions, const FPlace& Place)
{
	for (size_t i = Dimensions.size(); i-- > 0;)
	{
		if (Type->Kind == EType::Error)
		{
			return Type;
		}
		int64_t Count = 0;
		if (Dimensions[i])
		{
			const std::optional<int64_t> Found = FindInteger(*Dimensions[i], "the size of an array");
			if (!Found)
			{
				return Types->Error();
			}
			Count = *Found;
			if (Count <= 0)
			{
				Error(Dimensions[i]->Place,
					"X3059: array dimension must be between 1 and 65536, not " + std::to_string(Count));
				return Types->Error();
			}
		}
		else if (i > 0)
		{
			Error(Place, "X3074: only the first size of an array can be left out");
			return Types->Error();
		}
		const uint64_t Leaves = std::max<uint64_t>(CountLeaves(Type), 1);
		if (Type->Kind == EType::Void || uint64_t(Count) > MaxLeaves / Leaves)
		{
			Error(Place, Type->Kind == EType::Void ? std::string("X3038: arrays cannot be of void")
												   : "an array of " + std::to_string(Count) + " " + GetName(Type) +
														 " has more than " + std::to_string(MaxLeaves) + " numbers");
			return Types->Error();
		}
		Type = Types->Array(Type, uint32_t(Count));
	}
	return Type;
}

std::optional<int64_t> FAnalyser::FindInteger(const FExpression& Tree, const std::string& What)
{
	FValue* const Value = Analyse(Tree);
	if (IsError(Value))
	{
		return std::nullopt;
	}
	const bool bInteger = Value->Type->IsNumeric() && Value->Type->NumComponents() == 1 && !IsReal(Value->Type->Scalar);
	const FType* const To = bInteger ? Types->Scalar(Value->Type->Scalar) : nullptr;
	const std::optional<FConstant> Constant = To ? Fold(*Types, *Value) : std::nullopt;
	if (!Constant)
	{
		Error(Tree.Place,
			bInteger ? "X3058: " + What + " must be a constant expression; mark what it depends on as static const"
					 : "X3058: " + What + " must be an integer, not " + GetName(Value->Type));
		return std::nullopt;
	}
	const bool bWide = Types->GetBits(To->Scalar) == 64 || To->Scalar == EScalar::LiteralInt;
	const uint64_t Bits = Constant->at(0);
	return bWide ? int64_t(Bits) : IsUnsigned(To->Scalar) ? int64_t(uint32_t(Bits)) : int64_t(int32_t(uint32_t(Bits)));
}

const FType* FAnalyser::FindNamedType(const FTypeName& Name, uint32_t Modifiers)
{
	const bool bOrdered = (Modifiers & (ModifierRowMajor | ModifierColumnMajor)) != 0;
	const EOrder Order = Modifiers & ModifierColumnMajor ? EOrder::Column : EOrder::Row;
	FSymbol* Symbol = FindQualified(Name.Name);
	const auto IsBehind = [&Name](const FPlace& Place)
	{
		return std::tie(Place.File, Place.Line, Place.Column) >=
			   std::tie(Name.Place.File, Name.Place.Line, Name.Place.Column);
	};
	if (Symbol && Symbol->Kind == ESymbol::Field && IsBehind(Symbol->Place))
	{
		// A member's name is not known before it: struct A { B B; }.
		FPosition Outside = Here;
		Outside.Scope = Symbol->Scope->Parent;
		const FPositionGuard Guard(*this, Outside);
		Symbol = FindQualified(Name.Name);
	}
	const bool bType = Symbol && (Symbol->Kind == ESymbol::Struct || Symbol->Kind == ESymbol::Enum ||
									 Symbol->Kind == ESymbol::Alias || Symbol->Kind == ESymbol::Type);
	if (bType)
	{
		const FType* const Type = FindSymbolType(*Symbol, Name.Name.Parts.back());
		const FType* Inner = Type;
		while (Inner->IsArray())
		{
			Inner = Inner->Element;
		}
		return bOrdered && !(Modifiers & ModifierPacked) && Inner->IsMatrix() ? Types->WithOrder(Type, Order) : Type;
	}
	if (Name.Name.Parts.size() == 1)
	{
		if (const FType* const Type = FindBuiltInType(Name, Order))
		{
			return Type;
		}
	}
	const std::string Text(Name.Name.Last());
	if (Symbol)
	{
		Error(Name.Place, "X3000: '" + Text + "' is not a type here: line " + std::to_string(Symbol->Place.Line) +
							  " declares something else of this name");
		return Types->Error();
	}
	std::vector<std::string> Known = ListNames(false, true);
	Known.insert(Known.end(), {"float", "float2", "float3", "float4", "float4x4", "int", "int2", "uint", "uint2",
								  "uint3", "bool", "half", "double", "Texture2D", "SamplerState", "RWTexture2D"});
	Error(Name.Place, "X3000: unknown type '" + Text + "'" + SuggestName(Text, Known));
	return Types->Error();
}

const FType* FAnalyser::FindBuiltInType(const FTypeName& Name, EOrder Order)
{
	const FNamePart& Part = Name.Name.Parts[0];
	if (Part.Text == "void")
	{
		return Types->Void();
	}
	if (Part.Text == "string")
	{
		return Types->String();
	}
	if ((Part.Text == "vector" || Part.Text == "matrix") && Part.bArguments)
	{
		const bool bMatrix = Part.Text == "matrix";
		const auto& Arguments = Part.Arguments;
		const FType* const Scalar = !Arguments.empty() && Arguments[0].Type ? FindType(*Arguments[0].Type, 0) : nullptr;
		uint32_t Sizes[2] = {4, 4};
		bool bGood = Scalar && Scalar->IsScalar() && Arguments.size() <= (bMatrix ? 3u : 2u);
		for (size_t i = 1; i < Arguments.size() && bGood; ++i)
		{
			const auto Size =
				Arguments[i].Value ? FindInteger(*Arguments[i].Value, "a number of components") : std::nullopt;
			bGood = Size && *Size >= 1 && *Size <= 4;
			Sizes[i - 1] = bGood ? uint32_t(*Size) : 1;
		}
		if (!bGood)
		{
			if (!Scalar || Scalar->Kind != EType::Error)
			{
				Error(Name.Place, bMatrix
									  ? "X3051: matrix<T, Rows, Columns> takes a scalar type and numbers from 1 to 4"
									  : "X3052: vector<T, N> takes a scalar type and a number from 1 to 4");
			}
			return Types->Error();
		}
		return bMatrix ? Types->Matrix(Scalar->Scalar, Sizes[0], Sizes[1], Order)
					   : Types->Vector(Scalar->Scalar, Sizes[0]);
	}
	if (const FType* const Type = FTypes::FindObject(Part.Text) ? nullptr : Types->FindNumeric(Part.Text, Order))
	{
		return Type;
	}
	if (Part.Text == "sampler")
	{
		return Types->Object(EObject::SamplerState, "SamplerState", nullptr);
	}
	const std::optional<EObject> Object = FTypes::FindObject(Part.Text);
	return Object ? FindObjectType(Name, *Object) : nullptr;
}

const FType* FAnalyser::FindObjectType(const FTypeName& Name, EObject Object)
{
	const FNamePart& Part = Name.Name.Parts[0];
	const bool bTexel = IsTexture(Object) || Object == EObject::Buffer || Object == EObject::RWBuffer;
	const bool bStruct = Object == EObject::ConstantBuffer || Object == EObject::TextureBuffer;
	const FType* Element = bTexel && !IsWritable(Object) ? Types->Vector(EScalar::Float, 4) : nullptr;
	if (Object == EObject::Unsupported)
	{
		return Types->Object(Object, Part.Text, nullptr);
	}
	if (!bTexel && !bStruct && !IsStructured(Object))
	{
		return Types->Object(Object, Part.Text, nullptr);
	}
	const FTemplateArgument* const First = Part.Arguments.empty() ? nullptr : &Part.Arguments[0];
	if (First)
	{
		FTemplateParameter Any;
		Any.Place = Part.Place;
		Any.Name = "T";
		const std::optional<FTemplateValue> Value = ReadArgument(*First, Any);
		if (!Value)
		{
			return Types->Error();
		}
		Element = Value->Type;
	}
	const std::string Text(Part.Text);
	if (!Element)
	{
		Error(Name.Place, "X3000: '" + Text + "' needs the type of its elements: " + Text + "<" +
							  (bStruct ? "FMyStruct" : "float4") + ">");
		return Types->Error();
	}
	const bool bBadTexel = bTexel && (!Element->IsNumeric() || Element->IsMatrix() || Element->NumComponents() > 4);
	if (bTexel && !bBadTexel && Types->GetBits(Element->Scalar) * Element->NumComponents() > 128)
	{
		Error(Name.Place, "X3037: elements of typed buffers and textures must fit in four 32-bit quantities, which '" +
							  GetName(Element) + "' does not; use a StructuredBuffer");
		return Types->Error();
	}
	if (Element->Kind == EType::Error || bBadTexel || (bStruct && !Element->IsStruct()) || HasObject(Element) ||
		Element->Kind == EType::Void)
	{
		if (Element->Kind != EType::Error)
		{
			Error(Name.Place, "X3037: '" + Text + "' cannot have elements of '" + GetName(Element) + "'; it takes " +
								  (bTexel       ? "scalars and vectors"
									  : bStruct ? "a struct"
												: "numbers and structs of such"));
		}
		return Types->Error();
	}
	return Types->Object(Object, Part.Text, Element);
}

const FType* FAnalyser::FindSymbolType(FSymbol& Symbol, const FNamePart& Part)
{
	switch (Symbol.Kind)
	{
	case ESymbol::Type:
		return Symbol.Type;
	case ESymbol::Enum:
		return CompleteEnum(Symbol);
	case ESymbol::Alias:
		return Symbol.Declaration->bTemplate ? InstantiateAlias(Symbol, Part) : CompleteAlias(Symbol);
	case ESymbol::Struct:
		break;
	default:
		return Types->Error();
	}
	if (!Symbol.Struct || (Symbol.Declaration && Symbol.Declaration->bTemplate))
	{
		for (const FNameScope* Scope = Here.Scope; Scope && !Part.bArguments; Scope = Scope->Parent)
		{
			if (Scope->Struct && Scope->Struct->Template == &Symbol) // its own name, within it
			{
				return CompleteStruct(*Scope->Struct, Part.Place);
			}
		}
		FStructInfo* const Info = InstantiateStruct(Symbol, Part);
		return Info ? CompleteStruct(*Info, Part.Place) : Types->Error();
	}
	if (!Symbol.Info)
	{
		const uint32_t Order = Symbol.Order ? Symbol.Order : Here.Order;
		Symbol.Info = MakeStruct(*Symbol.Struct, *Symbol.Scope, std::string(Symbol.Name), Order);
	}
	return CompleteStruct(*Symbol.Info, Symbol.Place);
}

const FType* FAnalyser::CompleteAlias(FSymbol& Symbol)
{
	if (Symbol.Type)
	{
		return Symbol.Type;
	}
	if (Symbol.bBusy)
	{
		Error(Symbol.Place, "X3000: the type '" + std::string(Symbol.Name) + "' is made of itself");
		return Types->Error();
	}
	Symbol.bBusy = true;
	FPosition Position;
	Position.Scope = Symbol.Scope;
	Position.Order = Symbol.Order ? Symbol.Order : Here.Order;
	Position.Function = Symbol.Order ? nullptr : Here.Function;
	const FPositionGuard Guard(*this, Position);
	const FDeclaration& Declaration = *Symbol.Declaration;
	Symbol.Type =
		AddDimensions(FindType(*Declaration.Type, Declaration.Modifiers), Declaration.Dimensions, Symbol.Place);
	Symbol.bBusy = false;
	return Symbol.Type;
}

} // namespace Drydock::Hlsl
