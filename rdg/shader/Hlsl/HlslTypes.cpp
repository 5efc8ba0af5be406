// Makes and names the types of HLSL, and finds them by their spelling.
#include "HlslTypes.h"

#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

namespace Drydock::Hlsl
{

namespace
{

struct FTypesScalarName
{
	std::string_view Name;
	EScalar Scalar;
	EScalar RealHalf; // where half is a number of 16 bits
};

// The first name of a scalar is the one that messages use. `half` is a MinFloat where it has 32 bits: less than float
// in overloads, and the same number. float16_t and int16_t always have 16.
// clang-format off
constexpr FTypesScalarName TypesScalarNames[] = {
	{"bool", EScalar::Bool, EScalar::Bool}, {"int", EScalar::Int, EScalar::Int}, {"uint", EScalar::Uint, EScalar::Uint},
	{"float", EScalar::Float, EScalar::Float}, {"half", EScalar::MinFloat, EScalar::Half},
	{"double", EScalar::Double, EScalar::Double}, {"min16float", EScalar::MinFloat, EScalar::Half},
	{"min10float", EScalar::MinFloat, EScalar::Half}, {"min16int", EScalar::MinInt, EScalar::Short},
	{"min12int", EScalar::MinInt, EScalar::Short}, {"min16uint", EScalar::MinUint, EScalar::Ushort},
	{"float16_t", EScalar::Half, EScalar::Half}, {"float32_t", EScalar::Float, EScalar::Float},
	{"float64_t", EScalar::Double, EScalar::Double}, {"int16_t", EScalar::Short, EScalar::Short},
	{"int32_t", EScalar::Int, EScalar::Int}, {"int64_t", EScalar::Long, EScalar::Long},
	{"uint16_t", EScalar::Ushort, EScalar::Ushort}, {"uint32_t", EScalar::Uint, EScalar::Uint},
	{"uint64_t", EScalar::Ulong, EScalar::Ulong}, {"dword", EScalar::Uint, EScalar::Uint}};
// clang-format on

// In the order of EObject; then those that are known by name alone.
// clang-format off
constexpr std::string_view TypesObjectNames[] = {"Texture1D", "Texture1DArray", "Texture2D", "Texture2DArray", "Texture2DMS",
	"Texture2DMSArray", "Texture3D", "TextureCube", "TextureCubeArray", "RWTexture1D", "RWTexture1DArray", "RWTexture2D",
	"RWTexture2DArray", "RWTexture3D", "Buffer", "RWBuffer", "StructuredBuffer", "RWStructuredBuffer",
	"AppendStructuredBuffer", "ConsumeStructuredBuffer", "ByteAddressBuffer", "RWByteAddressBuffer", "ConstantBuffer",
	"TextureBuffer", "SamplerState", "SamplerComparisonState",
	"sampler", "sampler1D", "sampler2D", "sampler3D", "samplerCUBE", "sampler_state", "texture", "texture1D", "texture2D",
	"texture3D", "textureCUBE", "InputPatch", "OutputPatch", "PointStream", "LineStream", "TriangleStream", "RayDesc",
	"RayQuery", "RaytracingAccelerationStructure", "FeedbackTexture2D", "FeedbackTexture2DArray", "RWTexture2DMS",
	"RWTexture2DMSArray", "RasterizerOrderedTexture1D", "RasterizerOrderedTexture1DArray", "RasterizerOrderedTexture2D",
	"RasterizerOrderedTexture2DArray", "RasterizerOrderedTexture3D", "RasterizerOrderedBuffer",
	"RasterizerOrderedStructuredBuffer", "RasterizerOrderedByteAddressBuffer"};
// clang-format on
static_assert(TypesObjectNames[size_t(EObject::Unsupported)] == "sampler");

std::string_view GetTypesScalarName(EScalar Scalar)
{
	switch (Scalar)
	{
	case EScalar::LiteralInt:
		return "literal int";
	case EScalar::LiteralFloat:
		return "literal float";
	default:
		return std::find_if(std::begin(TypesScalarNames), std::end(TypesScalarNames),
			[Scalar](const FTypesScalarName& Entry) { return Entry.Scalar == Scalar; })
			->Name;
	}
}

bool IsTypesSize(char Letter)
{
	return Letter >= '1' && Letter <= '4';
}

/** All that makes a type that one and no other. */
auto GetTypesKey(const FType& T)
{
	return std::tie(T.Kind, T.Scalar, T.Shape, T.Rows, T.Columns, T.Order, T.bUnorm, T.bSnorm, T.Element, T.Count,
		T.Samples, T.Object, T.ObjectName, T.Struct, T.EnumKey, T.bScoped);
}

size_t HashType(const FType& Type)
{
	size_t Hash = 0;
	std::apply([&Hash](const auto&... Part)
		{ ((Hash = Hash * 1000003 + std::hash<std::remove_cvref_t<decltype(Part)>>()(Part)), ...); },
		GetTypesKey(Type));
	return Hash;
}

const FStructFacts& GetTypesFacts(FStructType& Struct)
{
	FStructFacts& Facts = Struct.Facts;
	if (Facts.NumCounted != Struct.Members.size())
	{
		Facts.bObject = false;
		uint64_t Count = 0;
		for (const FMember& Member : Struct.Members)
		{
			Count += CountScalars(Member.Type);
			Facts.bObject = Facts.bObject || HasObject(Member.Type);
		}
		Facts.NumScalars = uint32_t(std::min<uint64_t>(Count, UINT32_MAX));
		Facts.NumCounted = Struct.Members.size();
	}
	return Facts;
}

} // namespace

FTypes::FTypes(bool bInRealHalf)
	: bRealHalf(bInRealHalf)
{
	FType Type;
	VoidType = Keep(Type);
	Type.Kind = EType::Error;
	ErrorType = Keep(Type);
	Type.Kind = EType::String;
	StringType = Keep(Type);
}

const FType* FTypes::Keep(FType Type)
{
	const size_t Hash = HashType(Type);
	const auto [First, Last] = ByHash.equal_range(Hash);
	for (auto Found = First; Found != Last; ++Found)
	{
		if (GetTypesKey(*Found->second) == GetTypesKey(Type))
		{
			return Found->second;
		}
	}
	const FType* const Kept = &Types.emplace_back(Type);
	ByHash.emplace(Hash, Kept);
	return Kept;
}

const FType* FTypes::Numeric(EScalar Scalar, EShape Shape, uint32_t Rows, uint32_t Columns, EOrder Order)
{
	FType Type;
	Type.Kind = EType::Numeric;
	Type.Scalar = Scalar;
	Type.Shape = Shape;
	Type.Rows = uint8_t(Rows);
	Type.Columns = uint8_t(Columns);
	Type.Order = Shape != EShape::Matrix ? EOrder::None : Order == EOrder::None ? EOrder::Row : Order;
	return Keep(Type);
}

const FType* FTypes::Array(const FType* Element, uint32_t Count)
{
	FType Type;
	Type.Kind = EType::Array;
	Type.Element = Element;
	Type.Count = Count;
	return Keep(Type);
}

const FType* FTypes::Struct(FStructType Struct)
{
	FType Type;
	Type.Kind = EType::Struct;
	Type.Struct = &Structs.emplace_back(std::move(Struct));
	return Keep(Type);
}

const FType* FTypes::Object(EObject Object, std::string_view Name, const FType* Element, uint32_t Samples)
{
	FType Type;
	Type.Kind = EType::Object;
	Type.Object = Object;
	const auto Known = std::find(std::begin(TypesObjectNames), std::end(TypesObjectNames), Name);
	Type.ObjectName = Known == std::end(TypesObjectNames) ? Name : *Known; // its own text goes away with the tree
	Type.Element = Element;
	Type.Samples = Samples;
	return Keep(Type);
}

const FType* FTypes::Enum(std::string_view Name, const void* Key, EScalar Scalar, bool bScoped)
{
	FType Type;
	Type.Kind = EType::Numeric;
	Type.Scalar = Scalar;
	Type.Enum = Name;
	Type.EnumKey = Key;
	Type.bScoped = bScoped;
	return Keep(Type);
}

const FType* FTypes::WithScalar(const FType* Type, EScalar Scalar)
{
	return Type->IsNumeric() ? Numeric(Scalar, Type->Shape, Type->Rows, Type->Columns, Type->Order) : Type;
}

const FType* FTypes::WithOrder(const FType* Type, EOrder Order)
{
	if (Type->IsArray())
	{
		return Array(WithOrder(Type->Element, Order), Type->Count);
	}
	return Type->IsMatrix() ? Numeric(Type->Scalar, Type->Shape, Type->Rows, Type->Columns, Order) : Type;
}

const FType* FTypes::WithNorm(const FType* Type, bool bUnorm, bool bSnorm)
{
	FType Other = *Type;
	Other.bUnorm = bUnorm;
	Other.bSnorm = bSnorm;
	return Type->IsNumeric() ? Keep(Other) : Type;
}

const FType* FTypes::FindNumeric(std::string_view Name, EOrder Order)
{
	const EOrder MatrixOrder = Order == EOrder::None ? EOrder::Column : Order; // HLSL's own
	if (Name == "vector" || Name == "matrix")
	{
		return Name == "vector" ? Vector(EScalar::Float, 4) : Matrix(EScalar::Float, 4, 4, MatrixOrder);
	}
	for (const FTypesScalarName& Entry : TypesScalarNames)
	{
		if (!Name.starts_with(Entry.Name))
		{
			continue;
		}
		const EScalar Scalar = bRealHalf ? Entry.RealHalf : Entry.Scalar;
		const std::string_view Size = Name.substr(Entry.Name.size());
		if (Size.empty())
		{
			return this->Scalar(Scalar);
		}
		if (Size.size() == 1 && IsTypesSize(Size[0]))
		{
			return Vector(Scalar, uint32_t(Size[0] - '0'));
		}
		if (Size.size() == 3 && IsTypesSize(Size[0]) && Size[1] == 'x' && IsTypesSize(Size[2]))
		{
			return Matrix(Scalar, uint32_t(Size[0] - '0'), uint32_t(Size[2] - '0'), MatrixOrder);
		}
	}
	return nullptr;
}

std::optional<EObject> FTypes::FindObject(std::string_view Name)
{
	const auto Known = std::find(std::begin(TypesObjectNames), std::end(TypesObjectNames), Name);
	return Known == std::end(TypesObjectNames)
			   ? std::nullopt
			   : std::optional(std::min(EObject(Known - std::begin(TypesObjectNames)), EObject::Unsupported));
}

uint32_t FTypes::GetBits(EScalar Scalar) const
{
	constexpr uint32_t Bits[] = {32, 32, 32, 16, 16, 32, 32, 64, 64, 64, 32, 16, 32, 64, 64};
	static_assert(std::size(Bits) == size_t(EScalar::LiteralFloat) + 1);
	return Bits[size_t(Scalar)];
}

std::string GetName(const FType* Type)
{
	if (Type == nullptr)
	{
		return "nothing";
	}
	switch (Type->Kind)
	{
	case EType::Void:
		return "void";
	case EType::Numeric:
	{
		if (Type->IsEnum())
		{
			return std::string(Type->Enum);
		}
		std::string Name = Type->bUnorm ? "unorm " : Type->bSnorm ? "snorm " : "";
		Name += GetTypesScalarName(Type->Scalar);
		Name += IsLiteral(Type->Scalar) && !Type->IsScalar() ? " " : "";
		Name += Type->IsMatrix() ? std::to_string(Type->Rows) + "x" : "";
		return Name + (Type->IsScalar() ? "" : std::to_string(Type->Columns));
	}
	case EType::Array:
	{
		std::string Sizes;
		const FType* Element = Type;
		for (; Element->IsArray(); Element = Element->Element)
		{
			Sizes += "[" + (Element->Count ? std::to_string(Element->Count) : "") + "]";
		}
		return GetName(Element) + Sizes;
	}
	case EType::Struct:
		return Type->Struct->Name.empty() ? "struct without a name" : Type->Struct->Name;
	case EType::Object:
	{
		const std::string Samples = Type->Samples ? ", " + std::to_string(Type->Samples) : "";
		return std::string(Type->ObjectName) + (Type->Element ? "<" + GetName(Type->Element) + Samples + ">" : "");
	}
	case EType::String:
		return "string";
	case EType::Error:
		break;
	}
	return "a type in error";
}

bool IsSame(const FType* A, const FType* B)
{
	if (A == B || A == nullptr || B == nullptr || A->Kind != B->Kind)
	{
		return A == B;
	}
	switch (A->Kind)
	{
	case EType::Numeric:
		return A->Scalar == B->Scalar && A->Shape == B->Shape && A->Rows == B->Rows && A->Columns == B->Columns &&
			   A->EnumKey == B->EnumKey;
	case EType::Array:
		return A->Count == B->Count && IsSame(A->Element, B->Element);
	case EType::Struct:
		return A->Struct == B->Struct;
	case EType::Object:
		return A->Object == B->Object && A->ObjectName == B->ObjectName && A->Samples == B->Samples &&
			   IsSame(A->Element, B->Element);
	default:
		return true;
	}
}

bool HasObject(const FType* Type)
{
	return Type->IsArray()    ? HasObject(Type->Element)
		   : Type->IsStruct() ? GetTypesFacts(*Type->Struct).bObject
							  : Type->IsObject();
}

uint32_t CountScalars(const FType* Type)
{
	if (Type->IsArray())
	{
		return uint32_t(std::min<uint64_t>(uint64_t(Type->Count) * CountScalars(Type->Element), UINT32_MAX));
	}
	return Type->IsNumeric() ? Type->NumComponents() : Type->IsStruct() ? GetTypesFacts(*Type->Struct).NumScalars : 0;
}

EScalar GetScalarAt(const FType* Type, uint32_t Index)
{
	while (!Type->IsNumeric())
	{
		if (Type->IsArray())
		{
			const uint32_t Size = CountScalars(Type->Element);
			Index = Size ? Index % Size : 0;
			Type = Type->Element;
			continue;
		}
		const FType* Part = nullptr;
		for (size_t i = 0; Type->IsStruct() && i < Type->Struct->Members.size() && Part == nullptr; ++i)
		{
			const FType* const Member = Type->Struct->Members[i].Type;
			const uint32_t Size = CountScalars(Member);
			Part = Index < Size ? Member : nullptr;
			Index -= Part ? 0 : Size;
		}
		if (Part == nullptr)
		{
			return EScalar::Float; // there is none
		}
		Type = Part;
	}
	return Type->Scalar;
}

} // namespace Drydock::Hlsl
