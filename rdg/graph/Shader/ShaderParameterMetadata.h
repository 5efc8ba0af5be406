// Holds what the parameter-struct macros record of a struct: its members in the order of declaration, their offsets and
// types, and the flat view of them that HLSL sees. Source: engine ShaderParameterMetadata.h; the flat view is
// drydock's.
#pragma once

#include "CoreMinimal.h"

#include <string>
#include <vector>

class FShaderParametersMetadata;

/** Joins two names after expanding them: for objects that a macro declares at namespace scope. */
#define DRYDOCK_JOIN_INNER(A, B) A##B
#define DRYDOCK_JOIN(A, B) DRYDOCK_JOIN_INNER(A, B)

/** Kinds of members of a parameter struct. The order is the engine's. */
enum EUniformBufferBaseType : uint8
{
	UBMT_INVALID,
	UBMT_BOOL, // refused on purpose: its size differs between languages
	UBMT_INT32,
	UBMT_UINT32,
	UBMT_FLOAT32,
	UBMT_TEXTURE,
	UBMT_SRV,
	UBMT_UAV,
	UBMT_SAMPLER,
	UBMT_RDG_TEXTURE,
	UBMT_RDG_TEXTURE_ACCESS,
	UBMT_RDG_TEXTURE_ACCESS_ARRAY,
	UBMT_RDG_TEXTURE_SRV,
	UBMT_RDG_TEXTURE_UAV,
	UBMT_RDG_BUFFER_ACCESS,
	UBMT_RDG_BUFFER_ACCESS_ARRAY,
	UBMT_RDG_BUFFER_SRV,
	UBMT_RDG_BUFFER_UAV,
	UBMT_RDG_UNIFORM_BUFFER,
	UBMT_NESTED_STRUCT,
	UBMT_INCLUDED_STRUCT,
	UBMT_REFERENCED_STRUCT,
	UBMT_RENDER_TARGET_BINDING_SLOTS,
	EUniformBufferBaseType_Num,
};

/** Precision of a member; recorded, and without effect on a CPU. */
namespace EShaderPrecisionModifier
{
enum Type : uint8
{
	Float,
	Half,
	Fixed,
	Invalid
};
}

namespace Drydock
{

/** A member as HLSL names it. Nested structs are flattened (`A_B_Member`, included ones without prefix, arrays of
 * structs and of resources by index: `Name_0_Member`, `Name_0`). Uniform buffers stay one entry that names their
 * struct. */
struct FHlslMember
{
	std::string Name;     // "Input_Texture"
	std::string CodeName; // "Input.Texture", as C++ writes it
	std::string Type;     // "float4", "float4x4", or the text given to the macro: "RWTexture2D<float4>"
	EUniformBufferBaseType BaseType = UBMT_INVALID;
	uint32 Offset = 0; // bytes from the start of the outermost struct
	uint32 NumRows = 0;
	uint32 NumColumns = 0;
	uint32 NumElements = 0;                            // 0: not an array
	const FShaderParametersMetadata* Struct = nullptr; // uniform buffers: what they hold
	const FShaderParametersMetadata* DeclaredIn = nullptr;
	int32 FileLine = 0;

	bool IsConstant() const { return BaseType == UBMT_FLOAT32 || BaseType == UBMT_INT32 || BaseType == UBMT_UINT32; }
	bool IsUniformBuffer() const { return BaseType == UBMT_REFERENCED_STRUCT || BaseType == UBMT_RDG_UNIFORM_BUFFER; }
};

/** "float3", "int", "float4x4". */
DRYDOCK_API std::string GetHlslTypeName(EUniformBufferBaseType BaseType, uint32 NumRows, uint32 NumColumns);

/** "UBMT_RDG_TEXTURE" and so on. */
DRYDOCK_API const TCHAR* GetBaseTypeName(EUniformBufferBaseType BaseType);

} // namespace Drydock

/** Describes one parameter struct or uniform-buffer struct. Immutable; lives as long as the code that declared it. */
class DRYDOCK_API FShaderParametersMetadata : private FNoncopyable
{
public:
	enum class EUseCase : uint8
	{
		ShaderParameterStruct,
		UniformBuffer,
		DataDrivenUniformBuffer,
	};

	class DRYDOCK_API FMember
	{
	public:
		FMember() = default;
		FMember(const TCHAR* InName, const TCHAR* InShaderType, int32 InFileLine, uint32 InOffset,
			EUniformBufferBaseType InBaseType, EShaderPrecisionModifier::Type InPrecision, uint32 InNumRows,
			uint32 InNumColumns, uint32 InNumElements, const FShaderParametersMetadata* InStruct)
			: Name(InName)
			, ShaderType(InShaderType)
			, FileLine(InFileLine)
			, Offset(InOffset)
			, BaseType(InBaseType)
			, Precision(InPrecision)
			, NumRows(InNumRows)
			, NumColumns(InNumColumns)
			, NumElements(InNumElements)
			, Struct(InStruct)
		{
		}

		const TCHAR* GetName() const { return Name; }
		/** The type as the macro was given it: "Texture2D", "StructuredBuffer<float4>", "FVector4f". */
		const TCHAR* GetShaderType() const { return ShaderType; }
		int32 GetFileLine() const { return FileLine; }
		/** Bytes from the start of the struct that declares the member. */
		uint32 GetOffset() const { return Offset; }
		EUniformBufferBaseType GetBaseType() const { return BaseType; }
		EShaderPrecisionModifier::Type GetPrecision() const { return Precision; }
		uint32 GetNumRows() const { return NumRows; }
		uint32 GetNumColumns() const { return NumColumns; }
		/** 0: not an array. A scalar array counts its scalars' registers: ceil(N / 4) elements of four columns. */
		uint32 GetNumElements() const { return NumElements; }
		/** Nested, included and referenced structs only. */
		const FShaderParametersMetadata* GetStructMetadata() const { return Struct; }

		bool IsVariableNativeType() const
		{
			return BaseType == UBMT_INT32 || BaseType == UBMT_UINT32 || BaseType == UBMT_FLOAT32;
		}
		/** Bytes that the member takes in the struct. */
		uint32 GetMemberSize() const;
		/** The HLSL type, with `[N]` for arrays. */
		void GenerateShaderParameterType(FString& Result) const;

	private:
		const TCHAR* Name = TEXT("");
		const TCHAR* ShaderType = TEXT("");
		int32 FileLine = 0;
		uint32 Offset = 0;
		EUniformBufferBaseType BaseType = UBMT_INVALID;
		EShaderPrecisionModifier::Type Precision = EShaderPrecisionModifier::Float;
		uint32 NumRows = 0;
		uint32 NumColumns = 0;
		uint32 NumElements = 0;
		const FShaderParametersMetadata* Struct = nullptr;
	};

	/** ShaderVariableName: what HLSL calls the uniform buffer, null for plain parameter structs. */
	FShaderParametersMetadata(EUseCase InUseCase, const TCHAR* InStructTypeName, const TCHAR* InShaderVariableName,
		const TCHAR* InStaticSlotName, const ANSICHAR* InFileName, int32 InFileLine, uint32 InSize,
		TArray<FMember> InMembers);

	const TCHAR* GetStructTypeName() const { return StructTypeName; }
	const TCHAR* GetShaderVariableName() const { return ShaderVariableName; }
	const TCHAR* GetStaticSlotName() const { return StaticSlotName; }
	bool HasStaticSlot() const { return StaticSlotName != nullptr; }
	const ANSICHAR* GetFileName() const { return FileName; }
	int32 GetFileLine() const { return FileLine; }
	/** Bytes; a multiple of SHADER_PARAMETER_STRUCT_ALIGNMENT. */
	uint32 GetSize() const { return Size; }
	EUseCase GetUseCase() const { return UseCase; }
	/** In the order of declaration. */
	const TArray<FMember>& GetMembers() const { return Members; }

	/** Null when there is none. Own members only, not those of nested structs. */
	const FMember* FindMemberByName(const TCHAR* Name) const;

	/** The innermost member at this offset: its C++ name through nested structs ("A.B[1].Member"), "" when none starts
	 * there. */
	FString GetFullMemberCodeName(uint32 MemberOffset) const;

	/** Everything in the struct, flat, in the order of declaration; made once. */
	const std::vector<Drydock::FHlslMember>& GetHlslMembers() const { return HlslMembers; }

private:
	void AppendHlslMembers(std::vector<Drydock::FHlslMember>& Result, const std::string& Prefix,
		const std::string& CodePrefix, uint32 BaseOffset) const;

	EUseCase UseCase;
	const TCHAR* StructTypeName;
	const TCHAR* ShaderVariableName;
	const TCHAR* StaticSlotName;
	const ANSICHAR* FileName;
	int32 FileLine;
	uint32 Size;
	TArray<FMember> Members;
	std::vector<Drydock::FHlslMember> HlslMembers;
};

namespace Drydock
{

/** Every uniform-buffer struct that an IMPLEMENT_ macro registered in the code loaded so far, by HLSL name; null when
 * none. */
DRYDOCK_API const FShaderParametersMetadata* FindUniformBufferStruct(const std::string& HlslName);

/** Makes a uniform-buffer struct known while it lives. Made by the IMPLEMENT_ macros, before main or when a plugin is
 * loaded. */
class DRYDOCK_API FUniformBufferStructRegistrar : private FNoncopyable
{
public:
	using FGetMetadata = const FShaderParametersMetadata& (*)();

	FUniformBufferStructRegistrar(const char* InHlslName, FGetMetadata InGetMetadata);
	~FUniformBufferStructRegistrar();

	const char* HlslName;
	FGetMetadata GetMetadata;
};

} // namespace Drydock
