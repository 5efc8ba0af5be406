// The types of HLSL: each is made once, so that two types are one where their pointers are.
#pragma once

#include "DrydockAPI.h"
#include "HlslTree.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace Drydock::Hlsl
{

/** In the order of promotion within integers and within reals. */
enum class EScalar : uint8_t
{
	Bool,
	MinInt,  // min16int, min12int: 32 bits here
	MinUint, // min16uint
	Short,   // int16_t
	Ushort,  // uint16_t
	Int,
	Uint,
	Long,       // int64_t
	Ulong,      // uint64_t
	LiteralInt, // 1; becomes int where nothing else decides
	MinFloat,   // min16float, min10float: 32 bits here
	Half,       // half, float16_t: 16 bits where the request asks for it, else 32
	Float,
	Double,
	LiteralFloat, // 1.0; becomes float where nothing else decides
};

enum class EShape : uint8_t
{
	Scalar,
	Vector, // float1 is a vector of one component and not a scalar
	Matrix,
};

enum class EType : uint8_t
{
	Void,
	Numeric,
	Array,
	Struct,
	Object,
	String,
	Error, // of what was reported already; fits everything
};

enum class EObject : uint8_t
{
	Texture1D,
	Texture1DArray,
	Texture2D,
	Texture2DArray,
	Texture2DMS,
	Texture2DMSArray,
	Texture3D,
	TextureCube,
	TextureCubeArray,
	RWTexture1D,
	RWTexture1DArray,
	RWTexture2D,
	RWTexture2DArray,
	RWTexture3D,
	Buffer,
	RWBuffer,
	StructuredBuffer,
	RWStructuredBuffer,
	AppendStructuredBuffer,
	ConsumeStructuredBuffer,
	ByteAddressBuffer,
	RWByteAddressBuffer,
	ConstantBuffer,
	TextureBuffer,
	SamplerState,
	SamplerComparisonState,
	Unsupported, // ray tracing, streams, patches, DX9 samplers: known by name and refused where one is used
};

/** How the rows of a matrix lie in memory. */
enum class EOrder : uint8_t
{
	None,   // not a matrix
	Row,    // row_major
	Column, // column_major
};

struct FType;

struct FMember
{
	std::string Name;
	const FType* Type = nullptr;
	FPlace Place;
	std::string Semantic; // in capital letters, with its index; empty: none
	uint32_t Modifiers = 0;
};

/** Offsets as D3D lays memory out. */
enum class ELayout : uint8_t
{
	Constants,  // cbuffer: registers of 16 bytes, arrays of registers
	Structured, // StructuredBuffer: packed as C++ does, aligned by the largest scalar
};

struct FLayout
{
	uint32_t Size = 0;      // without what fills up to the next register
	uint32_t Alignment = 4; // bytes
	uint32_t Stride = 0;    // of an array's elements; of a matrix: from row to row, or column to column
};

/** Facts of a struct's members, found once: structs in structs would take exponential time. */
struct FStructFacts
{
	size_t NumCounted = SIZE_MAX; // members when it was found out
	uint32_t NumScalars = 0;
	bool bObject = false;
	size_t NumLaidOut = SIZE_MAX;
	FLayout Layouts[2]; // ELayout
};

/** A struct. Base classes come first, each as a member named after its type with bBase. */
struct FStructType
{
	std::string Name; // with its template arguments, as written: "FPair<float, 2>"
	FPlace Place;
	std::vector<FMember>
		Members; // those of bases first, flattened: a shadowed name stands twice, and the last one holds
	std::vector<const FType*> Bases;
	const void* Scope = nullptr; // of the analysis: methods, static members, nested types
	FStructFacts Facts;          // of CountScalars, HasObject and GetLayout
};

struct FType
{
	EType Kind = EType::Void;
	EScalar Scalar = EScalar::Float;
	EShape Shape = EShape::Scalar;
	uint8_t Rows = 1;    // of a matrix; 1 for vectors
	uint8_t Columns = 1; // components of a vector
	EOrder Order = EOrder::None;
	bool bUnorm = false; // of a texel
	bool bSnorm = false;
	const FType* Element = nullptr; // of an array; the texel or the structure of an object
	uint32_t Count = 0;             // of an array; 0: []
	uint32_t Samples = 0;           // Texture2DMS
	EObject Object = EObject::Unsupported;
	std::string_view ObjectName; // as the language has it
	FStructType* Struct = nullptr;
	std::string_view Enum;         // the name of an enumeration whose scalar this is
	const void* EnumKey = nullptr; // which enumeration
	bool bScoped = false;          // of an `enum class`: nothing but itself without a cast

	bool IsNumeric() const { return Kind == EType::Numeric; }
	bool IsScalar() const { return IsNumeric() && Shape == EShape::Scalar; }
	bool IsVector() const { return IsNumeric() && Shape == EShape::Vector; }
	bool IsMatrix() const { return IsNumeric() && Shape == EShape::Matrix; }
	bool IsArray() const { return Kind == EType::Array; }
	bool IsStruct() const { return Kind == EType::Struct; }
	bool IsObject() const { return Kind == EType::Object; }
	bool IsEnum() const { return EnumKey != nullptr; }
	uint32_t NumComponents() const { return uint32_t(Rows) * Columns; } // numeric
};

constexpr bool IsReal(EScalar Scalar)
{
	return Scalar >= EScalar::MinFloat;
}
constexpr bool IsInteger(EScalar Scalar)
{
	return Scalar >= EScalar::MinInt && Scalar <= EScalar::LiteralInt;
}
constexpr bool IsUnsigned(EScalar Scalar)
{
	return Scalar == EScalar::MinUint || Scalar == EScalar::Ushort || Scalar == EScalar::Uint ||
		   Scalar == EScalar::Ulong;
}
constexpr bool IsLiteral(EScalar Scalar)
{
	return Scalar == EScalar::LiteralInt || Scalar == EScalar::LiteralFloat;
}
constexpr bool IsTexture(EObject Object)
{
	return Object <= EObject::RWTexture3D;
}
constexpr bool IsWritable(EObject Object)
{
	return (Object >= EObject::RWTexture1D && Object <= EObject::RWTexture3D) || Object == EObject::RWBuffer ||
		   (Object >= EObject::RWStructuredBuffer && Object <= EObject::ConsumeStructuredBuffer) ||
		   Object == EObject::RWByteAddressBuffer;
}
constexpr bool IsStructured(EObject Object)
{
	return Object >= EObject::StructuredBuffer && Object <= EObject::ConsumeStructuredBuffer;
}

/** Makes types and keeps them. */
class DRYDOCK_API FTypes
{
public:
	/** bRealHalf: half and min16 types have 16 bits, and int16_t, uint16_t and float16_t are there. */
	explicit FTypes(bool bRealHalf);

	const FType* Void() const { return VoidType; }
	const FType* Error() const { return ErrorType; }
	const FType* String() const { return StringType; }
	const FType* Scalar(EScalar Scalar) { return Numeric(Scalar, EShape::Scalar, 1, 1); }
	const FType* Vector(EScalar Scalar, uint32_t Count) { return Numeric(Scalar, EShape::Vector, 1, Count); }
	const FType* Matrix(EScalar Scalar, uint32_t Rows, uint32_t Columns, EOrder Order = EOrder::Row)
	{
		return Numeric(Scalar, EShape::Matrix, Rows, Columns, Order);
	}
	const FType* Numeric(EScalar Scalar, EShape Shape, uint32_t Rows, uint32_t Columns, EOrder Order = EOrder::None);
	const FType* Array(const FType* Element, uint32_t Count);
	const FType* Struct(FStructType Type); // a new type each time
	const FType* Object(EObject Object, std::string_view Name, const FType* Element, uint32_t Samples = 0);
	const FType* Enum(std::string_view Name, const void* Key, EScalar Scalar, bool bScoped = false);

	/** The same shape with another scalar. */
	const FType* WithScalar(const FType* Type, EScalar Scalar);
	const FType* WithOrder(const FType* Type, EOrder Order); // of a matrix, and of an array's elements
	const FType* WithNorm(const FType* Type, bool bUnorm, bool bSnorm);

	/** The type of "float3x2", "uint", "min16float4", "float32_t3", "vector", "matrix" and names of objects; null: it
	 * is none. Arguments: of `vector<float, 3>` and `Texture2D<float4>`, types and numbers in order. */
	const FType* FindNumeric(std::string_view Name, EOrder Order);
	static std::optional<EObject> FindObject(std::string_view Name);

	bool HasRealHalf() const { return bRealHalf; }

	/** Bits that a scalar takes: 16, 32 or 64. A bool has 32 in memory. */
	uint32_t GetBits(EScalar Scalar) const;

private:
	const FType* Keep(FType Type);

	const bool bRealHalf;
	std::deque<FType> Types;
	std::deque<FStructType> Structs;
	std::multimap<size_t, const FType*> ByHash;
	const FType* VoidType = nullptr;
	const FType* ErrorType = nullptr;
	const FType* StringType = nullptr;
};

/** As HLSL writes it: "float3x2", "Texture2D<float4>", "FItem", "float[3]". */
DRYDOCK_API std::string GetName(const FType* Type);

/** The same type but for the order of rows and the norm of texels. */
DRYDOCK_API bool IsSame(const FType* A, const FType* B);

/** Whether an object is in it, at any depth. */
DRYDOCK_API bool HasObject(const FType* Type);

/** Scalars in a numeric type, an array or a struct of such; objects count as none. */
DRYDOCK_API uint32_t CountScalars(const FType* Type);

/** The type of the scalar at Index when all is taken apart, row by row. */
DRYDOCK_API EScalar GetScalarAt(const FType* Type, uint32_t Index);

DRYDOCK_API FLayout GetLayout(const FTypes& Types, const FType* Type, ELayout Layout);

/** The offsets of a struct's members. */
DRYDOCK_API std::vector<uint32_t> GetOffsets(const FTypes& Types, const FStructType& Struct, ELayout Layout);

} // namespace Drydock::Hlsl
