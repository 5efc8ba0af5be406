// Maps each C++ type to a shader parameter: base type, shape and alignment inside a parameter struct, which keeps to
// HLSL's rule that nothing straddles 16 bytes. A type that HLSL cannot take is refused with a sentence. Source: engine
// ShaderParameterMacros.h (TShaderParameterTypeInfo).
#pragma once

#include "CoreMinimal.h"
#include "ShaderParameterMetadata.h"

#include <type_traits>

#define SHADER_PARAMETER_STRUCT_ALIGNMENT 16
#define SHADER_PARAMETER_ARRAY_ELEMENT_ALIGNMENT 16
#define SHADER_PARAMETER_POINTER_ALIGNMENT 8

namespace Drydock
{

template<typename T>
constexpr bool TAlwaysFalse = false;

/** Shape of a numeric parameter. */
template<typename T, EUniformBufferBaseType InBaseType, int32 InNumRows, int32 InNumColumns, int32 InAlignment>
struct TNumericParameterTypeInfo
{
	static constexpr EUniformBufferBaseType BaseType = InBaseType;
	static constexpr int32 NumRows = InNumRows;
	static constexpr int32 NumColumns = InNumColumns;
	static constexpr int32 NumElements = 0;
	static constexpr int32 Alignment = InAlignment;
	static constexpr bool bIsStoredInConstantBuffer = true;

	using TAlignedType = T;

	static const FShaderParametersMetadata* GetStructMetadata() { return nullptr; }

	static_assert(
		sizeof(T) == static_cast<size_t>(NumRows * NumColumns * 4), "the C++ type must be as large as its HLSL type");
};

/** The entry of a refused type, so that one mistake gives one message. */
template<typename T>
struct TRefusedParameterTypeInfo
{
	static constexpr EUniformBufferBaseType BaseType = UBMT_INVALID;
	static constexpr int32 NumRows = 1;
	static constexpr int32 NumColumns = 1;
	static constexpr int32 NumElements = 0;
	static constexpr int32 Alignment = 16;
	static constexpr bool bIsStoredInConstantBuffer = true;

	using TAlignedType = T;

	static const FShaderParametersMetadata* GetStructMetadata() { return nullptr; }
};

} // namespace Drydock

template<typename T>
struct TShaderParameterTypeInfo : Drydock::TRefusedParameterTypeInfo<T>
{
	static_assert(Drydock::TAlwaysFalse<T>,
		"This type is not a shader parameter: use float, int32, uint32, FVector2f, FVector3f, FVector4f, "
		"FLinearColor, FIntPoint, FIntRect, FIntVector, FUintVector4, FMatrix44f or FScreenTransform, or "
		"SHADER_PARAMETER_STRUCT for a struct.");
};

template<>
struct TShaderParameterTypeInfo<bool> : Drydock::TRefusedParameterTypeInfo<uint32>
{
	static constexpr EUniformBufferBaseType BaseType = UBMT_BOOL;
};

#define DRYDOCK_REFUSED_PARAMETER_TYPE(Type) \
	template<> \
	struct TShaderParameterTypeInfo<Type> : Drydock::TRefusedParameterTypeInfo<Type> \
	{ \
	};

DRYDOCK_REFUSED_PARAMETER_TYPE(double)
DRYDOCK_REFUSED_PARAMETER_TYPE(FVector2D)
DRYDOCK_REFUSED_PARAMETER_TYPE(FVector)
DRYDOCK_REFUSED_PARAMETER_TYPE(FVector4)
#undef DRYDOCK_REFUSED_PARAMETER_TYPE

#define DRYDOCK_PARAMETER_TYPE(Type, BaseType, NumRows, NumColumns, Alignment) \
	template<> \
	struct TShaderParameterTypeInfo<Type> \
		: Drydock::TNumericParameterTypeInfo<Type, BaseType, NumRows, NumColumns, Alignment> \
	{ \
	};

DRYDOCK_PARAMETER_TYPE(int32, UBMT_INT32, 1, 1, 4)
DRYDOCK_PARAMETER_TYPE(uint32, UBMT_UINT32, 1, 1, 4)
DRYDOCK_PARAMETER_TYPE(float, UBMT_FLOAT32, 1, 1, 4)
DRYDOCK_PARAMETER_TYPE(FVector2f, UBMT_FLOAT32, 1, 2, 8)
DRYDOCK_PARAMETER_TYPE(FVector3f, UBMT_FLOAT32, 1, 3, 16)
DRYDOCK_PARAMETER_TYPE(FVector4f, UBMT_FLOAT32, 1, 4, 16)
DRYDOCK_PARAMETER_TYPE(FLinearColor, UBMT_FLOAT32, 1, 4, 16)
DRYDOCK_PARAMETER_TYPE(FQuat4f, UBMT_FLOAT32, 1, 4, 16)
DRYDOCK_PARAMETER_TYPE(FMatrix44f, UBMT_FLOAT32, 4, 4, 16)
DRYDOCK_PARAMETER_TYPE(FIntPoint, UBMT_INT32, 1, 2, 8)
DRYDOCK_PARAMETER_TYPE(FIntVector, UBMT_INT32, 1, 3, 16)
DRYDOCK_PARAMETER_TYPE(FIntVector4, UBMT_INT32, 1, 4, 16)
DRYDOCK_PARAMETER_TYPE(FIntRect, UBMT_INT32, 1, 4, 16)
DRYDOCK_PARAMETER_TYPE(FUintVector2, UBMT_UINT32, 1, 2, 8)
DRYDOCK_PARAMETER_TYPE(FUintVector4, UBMT_UINT32, 1, 4, 16)
#undef DRYDOCK_PARAMETER_TYPE

/** An array: elements lie 16 bytes apart in HLSL, so each must fill its 16 bytes. */
template<typename T, size_t N>
struct TShaderParameterTypeInfo<T[N]>
{
	using FElementInfo = TShaderParameterTypeInfo<T>;

	static constexpr EUniformBufferBaseType BaseType = FElementInfo::BaseType;
	static constexpr int32 NumRows = FElementInfo::NumRows;
	static constexpr int32 NumColumns = FElementInfo::NumColumns;
	static constexpr int32 NumElements = static_cast<int32>(N);
	static constexpr int32 Alignment = SHADER_PARAMETER_ARRAY_ELEMENT_ALIGNMENT;
	static constexpr bool bIsStoredInConstantBuffer = true;

	using TAlignedType = TStaticArray<T, N>;

	static const FShaderParametersMetadata* GetStructMetadata() { return nullptr; }
};

/** A scalar array: four to a register, element i is component i % 4 of register i / 4 (GET_SCALAR_ARRAY_ELEMENT). */
template<typename T, size_t N>
struct TShaderParameterScalarArrayTypeInfo
{
	static_assert(std::is_same_v<T, float> || std::is_same_v<T, int32> || std::is_same_v<T, uint32>,
		"SHADER_PARAMETER_SCALAR_ARRAY takes float, int32 or uint32.");

	using FRegister = std::conditional_t<std::is_same_v<T, float>, FVector4f,
		std::conditional_t<std::is_same_v<T, int32>, FIntVector4, FUintVector4>>;
	using TAlignedType = TStaticArray<FRegister, (N + 3) / 4>;

	static constexpr EUniformBufferBaseType BaseType = TShaderParameterTypeInfo<T>::BaseType;
	static constexpr int32 NumRows = 1;
	static constexpr int32 NumColumns = 4;
	static constexpr int32 NumElements = static_cast<int32>((N + 3) / 4);
	static constexpr int32 Alignment = SHADER_PARAMETER_ARRAY_ELEMENT_ALIGNMENT;
	static constexpr bool bIsStoredInConstantBuffer = true;

	static const FShaderParametersMetadata* GetStructMetadata() { return nullptr; }
};

/** Lets a scalar-array macro write `float[7]` for one template argument. */
template<typename TArrayType>
struct TShaderParameterScalarArrayOf;

template<typename T, size_t N>
struct TShaderParameterScalarArrayOf<T[N]> : TShaderParameterScalarArrayTypeInfo<T, N>
{
};

/** A nested struct, or an array of them. */
template<typename TStruct>
struct TShaderParameterStructTypeInfo
{
	static constexpr int32 NumElements = 0;
	static constexpr int32 Alignment = TStruct::FTypeInfo::Alignment;

	using TAlignedType = TStruct;

	static const FShaderParametersMetadata* GetStructMetadata() { return TStruct::FTypeInfo::GetStructMetadata(); }
};

template<typename TStruct, size_t N>
struct TShaderParameterStructTypeInfo<TStruct[N]>
{
	static constexpr int32 NumElements = static_cast<int32>(N);
	static constexpr int32 Alignment = TStruct::FTypeInfo::Alignment;

	using TAlignedType = TStaticArray<TStruct, N>;

	static const FShaderParametersMetadata* GetStructMetadata() { return TStruct::FTypeInfo::GetStructMetadata(); }
};

/** A pointer to a resource, or an array of them. */
template<typename TPointer>
struct TShaderResourceParameterTypeInfo
{
	static constexpr int32 NumElements = 0;
	static constexpr int32 Alignment = SHADER_PARAMETER_POINTER_ALIGNMENT;

	using TAlignedType = TPointer;
};

template<typename TPointer, size_t N>
struct TShaderResourceParameterTypeInfo<TPointer[N]>
{
	static constexpr int32 NumElements = static_cast<int32>(N);
	static constexpr int32 Alignment = SHADER_PARAMETER_POINTER_ALIGNMENT;

	using TAlignedType = TStaticArray<TPointer, N>;
};

namespace Drydock
{

/** Refuses what the engine refuses, in words. */
template<typename T>
constexpr void CheckShaderParameterType()
{
	static_assert(!std::is_same_v<T, bool>,
		"bool is not a shader parameter: its size differs between C++ and HLSL. Use uint32; HLSL may read it as bool.");
	static_assert(!std::is_same_v<T, double>, "double is not a shader parameter: use float.");
	static_assert(
		!std::is_same_v<T, FVector2D>, "FVector2D is double precision and not a shader parameter: use FVector2f.");
	static_assert(
		!std::is_same_v<T, FVector>, "FVector is double precision and not a shader parameter: use FVector3f.");
	static_assert(
		!std::is_same_v<T, FVector4>, "FVector4 is double precision and not a shader parameter: use FVector4f.");
}

template<typename T>
constexpr void CheckShaderParameterArrayElement()
{
	CheckShaderParameterType<T>();
	static_assert(std::is_same_v<T, bool> || sizeof(T) % SHADER_PARAMETER_ARRAY_ELEMENT_ALIGNMENT == 0,
		"SHADER_PARAMETER_ARRAY elements must be a multiple of 16 bytes, as HLSL spaces them: use "
		"SHADER_PARAMETER_SCALAR_ARRAY for scalars, "
		"or pack the values into FVector4f.");
}

} // namespace Drydock
