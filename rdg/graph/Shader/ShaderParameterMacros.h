// The macros that declare parameter structs and uniform buffers, exactly as in Unreal:
//
//     BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
//         SHADER_PARAMETER(float, BloomThreshold)
//         SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
//         RENDER_TARGET_BINDING_SLOTS()
//     END_SHADER_PARAMETER_STRUCT()
//
// How the members find each other: every macro declares its member, a small struct that records it, and ends in an
// unfinished `typedef`, which the next macro completes. So each record names the one before it, the last one is known
// at the end of the struct, and walking the chain gives the members in the order of declaration, without any
// registration at run time. Names that begin with zz are the chain's own. Source: engine ShaderParameterMacros.h.
#pragma once

#include "CoreMinimal.h"
#include "RHIDefinitions.h"
#include "RHIResources.h"
#include "RenderGraphFwd.h"
#include "RenderTargetBinding.h"
#include "ShaderParameterAccess.h"
#include "ShaderParameterMetadata.h"
#include "ShaderParameterTypeInfo.h"
#include "UniformBufferBinding.h"

#include <cstddef>
#include <type_traits>

namespace Drydock
{

/** The shape of every parameter struct. */
struct FParameterStructTypeInfo
{
	static constexpr int32 NumRows = 1;
	static constexpr int32 NumColumns = 1;
	static constexpr int32 NumElements = 0;
	static constexpr int32 Alignment = SHADER_PARAMETER_STRUCT_ALIGNMENT;
	static constexpr bool bIsStoredInConstantBuffer = true;
};

/** Ends the chain of members. */
struct FNoShaderParameter
{
};

/** Walks the chain from its last record back to the first, and appends on the way out. */
template<typename TRecord>
void AppendShaderParameters(TArray<FShaderParametersMetadata::FMember>& Members)
{
	if constexpr (!std::is_same_v<TRecord, FNoShaderParameter>)
	{
		AppendShaderParameters<typename TRecord::FPrevious>(Members);
		TRecord::AppendTo(Members);
	}
}

} // namespace Drydock

// The formatter takes declarations inside macros apart.
// clang-format off

// ---------------------------------------------------------------------------------------------------------------------
// Structs
// ---------------------------------------------------------------------------------------------------------------------

#define DRYDOCK_SHADER_PARAMETER_STRUCT_HEAD(StructTypeName) \
	public: \
		static TArray<FShaderParametersMetadata::FMember> zzGetMembers() \
		{ \
			TArray<FShaderParametersMetadata::FMember> Members; \
			Drydock::AppendShaderParameters<zzLastMember>(Members); \
			return Members; \
		} \
	private: \
		using zzThisStruct = StructTypeName; \
		typedef Drydock::FNoShaderParameter

// The alignment is a GNU attribute because export macros are: GCC takes no alignas beside one.

/** Opens a parameter struct. The second argument is a module's export macro and may be empty. */
#define BEGIN_SHADER_PARAMETER_STRUCT(StructTypeName, PrefixKeywords) \
	class __attribute__((aligned(SHADER_PARAMETER_STRUCT_ALIGNMENT))) PrefixKeywords StructTypeName \
	{ \
	public: \
		struct FTypeInfo : Drydock::FParameterStructTypeInfo \
		{ \
			using TAlignedType = StructTypeName; \
			static const FShaderParametersMetadata* GetStructMetadata() \
			{ \
				static const FShaderParametersMetadata Metadata( \
					FShaderParametersMetadata::EUseCase::ShaderParameterStruct, TEXT(#StructTypeName), nullptr, \
					nullptr, __FILE__, __LINE__, sizeof(StructTypeName), StructTypeName::zzGetMembers()); \
				return &Metadata; \
			} \
		}; \
	DRYDOCK_SHADER_PARAMETER_STRUCT_HEAD(StructTypeName)

#define END_SHADER_PARAMETER_STRUCT() \
		zzLastMember; \
	};

#define DRYDOCK_BEGIN_UNIFORM_BUFFER_STRUCT(StructTypeName, PrefixKeywords, Constructor) \
	class __attribute__((aligned(SHADER_PARAMETER_STRUCT_ALIGNMENT))) PrefixKeywords StructTypeName \
	{ \
	public: \
		Constructor \
		struct FTypeInfo : Drydock::FParameterStructTypeInfo \
		{ \
			using TAlignedType = StructTypeName; \
			static const FShaderParametersMetadata* GetStructMetadata() \
			{ \
				return &StructTypeName::zzGetStructMetadata(); \
			} \
		}; \
		/* Defined by the IMPLEMENT_ macro, which knows the HLSL name. */ \
		static const FShaderParametersMetadata& zzGetStructMetadata(); \
		static constexpr const ANSICHAR* zzFileName = __FILE__; \
		static constexpr int32 zzFileLine = __LINE__; \
	DRYDOCK_SHADER_PARAMETER_STRUCT_HEAD(StructTypeName)

/** Opens a uniform buffer's struct; one IMPLEMENT_ macro in a .cpp names it for HLSL. */
#define BEGIN_UNIFORM_BUFFER_STRUCT(StructTypeName, PrefixKeywords) \
	DRYDOCK_BEGIN_UNIFORM_BUFFER_STRUCT(StructTypeName, PrefixKeywords, )

/** The same with a default constructor that is defined elsewhere. */
#define BEGIN_UNIFORM_BUFFER_STRUCT_WITH_CONSTRUCTOR(StructTypeName, PrefixKeywords) \
	DRYDOCK_BEGIN_UNIFORM_BUFFER_STRUCT(StructTypeName, PrefixKeywords, StructTypeName();)

#define END_UNIFORM_BUFFER_STRUCT() END_SHADER_PARAMETER_STRUCT()

#define BEGIN_GLOBAL_SHADER_PARAMETER_STRUCT(StructTypeName, PrefixKeywords) \
	BEGIN_UNIFORM_BUFFER_STRUCT(StructTypeName, PrefixKeywords)
#define BEGIN_GLOBAL_SHADER_PARAMETER_STRUCT_WITH_CONSTRUCTOR(StructTypeName, PrefixKeywords) \
	BEGIN_UNIFORM_BUFFER_STRUCT_WITH_CONSTRUCTOR(StructTypeName, PrefixKeywords)
#define END_GLOBAL_SHADER_PARAMETER_STRUCT() END_UNIFORM_BUFFER_STRUCT()

#define DRYDOCK_IMPLEMENT_UNIFORM_BUFFER_STRUCT(StructTypeName, ShaderVariableName, StaticSlotName) \
	const FShaderParametersMetadata& StructTypeName::zzGetStructMetadata() \
	{ \
		static const FShaderParametersMetadata Metadata(FShaderParametersMetadata::EUseCase::UniformBuffer, \
		TEXT(#StructTypeName), \
			TEXT(ShaderVariableName), StaticSlotName, zzFileName, zzFileLine, sizeof(StructTypeName), zzGetMembers()); \
		return Metadata; \
	} \
	static const Drydock::FUniformBufferStructRegistrar DRYDOCK_JOIN(zzUniformBufferStruct, __COUNTER__)( \
		ShaderVariableName, &StructTypeName::zzGetStructMetadata);

/** Names a uniform buffer for HLSL: members are read as `Name.Member`. */
#define IMPLEMENT_UNIFORM_BUFFER_STRUCT(StructTypeName, ShaderVariableName) \
	DRYDOCK_IMPLEMENT_UNIFORM_BUFFER_STRUCT(StructTypeName, ShaderVariableName, nullptr)
#define IMPLEMENT_GLOBAL_SHADER_PARAMETER_STRUCT(StructTypeName, ShaderVariableName) \
	IMPLEMENT_UNIFORM_BUFFER_STRUCT(StructTypeName, ShaderVariableName)

/** Static slots have a name and no further meaning here: every pass binds what its parameter struct holds. */
#define IMPLEMENT_STATIC_UNIFORM_BUFFER_SLOT(SlotName) \
	static_assert(sizeof(#SlotName) > 1, "a static uniform-buffer slot needs a name");
#define IMPLEMENT_STATIC_UNIFORM_BUFFER_STRUCT(StructTypeName, ShaderVariableName, StaticSlotName) \
	DRYDOCK_IMPLEMENT_UNIFORM_BUFFER_STRUCT(StructTypeName, ShaderVariableName, TEXT(#StaticSlotName))
#define IMPLEMENT_STATIC_AND_SHADER_UNIFORM_BUFFER_STRUCT(StructTypeName, ShaderVariableName, StaticSlotName) \
	IMPLEMENT_STATIC_UNIFORM_BUFFER_STRUCT(StructTypeName, ShaderVariableName, StaticSlotName)

// ---------------------------------------------------------------------------------------------------------------------
// Members
// ---------------------------------------------------------------------------------------------------------------------

#define DRYDOCK_SHADER_PARAMETER_MEMBER( \
	BaseType, TypeInfo, ShaderType, MemberType, MemberName, Precision, NumRows, NumColumns, StructMetadata) \
		zzMemberBefore##MemberName; \
	public: \
		alignas(TypeInfo::Alignment) MemberType MemberName{}; \
	private: \
		struct zzMember##MemberName \
		{ \
			using FPrevious = zzMemberBefore##MemberName; \
			static void AppendTo(TArray<FShaderParametersMetadata::FMember>& Members) \
			{ \
				Members.Add(FShaderParametersMetadata::FMember(TEXT(#MemberName), TEXT(ShaderType), __LINE__, \
					static_cast<uint32>(offsetof(zzThisStruct, MemberName)), BaseType, Precision, NumRows, NumColumns, \
					static_cast<uint32>(TypeInfo::NumElements), StructMetadata)); \
			} \
		}; \
		typedef zzMember##MemberName

#define DRYDOCK_SHADER_PARAMETER_RESOURCE(BaseType, ShaderType, MemberType, MemberName) \
	DRYDOCK_SHADER_PARAMETER_MEMBER(BaseType, TShaderResourceParameterTypeInfo<MemberType>, ShaderType, \
		TShaderResourceParameterTypeInfo<MemberType>::TAlignedType, MemberName, EShaderPrecisionModifier::Float, 1, \
		1, nullptr)

#define DRYDOCK_SHADER_PARAMETER_OBJECT(BaseType, ShaderType, MemberType, ObjectAlignment, MemberName, StructMetadata) \
	DRYDOCK_SHADER_PARAMETER_MEMBER(BaseType, Drydock::TObjectParameterTypeInfo<ObjectAlignment>, ShaderType, \
		MemberType, MemberName, EShaderPrecisionModifier::Float, 1, 1, StructMetadata)

namespace Drydock
{

template<int32 InAlignment>
struct TObjectParameterTypeInfo
{
	static constexpr int32 NumElements = 0;
	static constexpr int32 Alignment = InAlignment;
};

} // namespace Drydock

/** A number, vector or matrix: `SHADER_PARAMETER(FVector4f, Tint)` is `float4 Tint;`. */
#define SHADER_PARAMETER(MemberType, MemberName) \
	SHADER_PARAMETER_EX(MemberType, MemberName, EShaderPrecisionModifier::Float)

#define SHADER_PARAMETER_EX(MemberType, MemberName, Precision) \
	DRYDOCK_SHADER_PARAMETER_MEMBER(TShaderParameterTypeInfo<MemberType>::BaseType, \
		TShaderParameterTypeInfo<MemberType>, #MemberType, MemberType, MemberName, Precision, \
		TShaderParameterTypeInfo<MemberType>::NumRows, TShaderParameterTypeInfo<MemberType>::NumColumns, \
		(Drydock::CheckShaderParameterType<MemberType>(), nullptr))

/** `SHADER_PARAMETER_ARRAY(FVector4f, Weights, [8])`; elements are multiples of 16 bytes. */
#define SHADER_PARAMETER_ARRAY(MemberType, MemberName, ArrayDecl) \
	SHADER_PARAMETER_ARRAY_EX(MemberType, MemberName, ArrayDecl, EShaderPrecisionModifier::Float)

#define SHADER_PARAMETER_ARRAY_EX(MemberType, MemberName, ArrayDecl, Precision) \
	DRYDOCK_SHADER_PARAMETER_MEMBER(TShaderParameterTypeInfo<MemberType>::BaseType, \
		TShaderParameterTypeInfo<MemberType ArrayDecl>, #MemberType, \
		TShaderParameterTypeInfo<MemberType ArrayDecl>::TAlignedType, MemberName, Precision, \
		TShaderParameterTypeInfo<MemberType>::NumRows, TShaderParameterTypeInfo<MemberType>::NumColumns, \
		(Drydock::CheckShaderParameterArrayElement<MemberType>(), \
		nullptr))

/** `SHADER_PARAMETER_SCALAR_ARRAY(float, Weights, [7])`: read and written by GET_SCALAR_ARRAY_ELEMENT, in HLSL too. */
#define SHADER_PARAMETER_SCALAR_ARRAY(MemberType, MemberName, ArrayDecl) \
	DRYDOCK_SHADER_PARAMETER_MEMBER(TShaderParameterScalarArrayOf<MemberType ArrayDecl>::BaseType, \
		TShaderParameterScalarArrayOf<MemberType ArrayDecl>, \
		#MemberType, TShaderParameterScalarArrayOf<MemberType ArrayDecl>::TAlignedType, MemberName, \
		EShaderPrecisionModifier::Float, 1, 4, nullptr)

#define DECLARE_SCALAR_ARRAY(ScalarType, ArrayName, ArraySize) \
	TShaderParameterScalarArrayTypeInfo<ScalarType, ArraySize>::TAlignedType ArrayName
#define GET_SCALAR_ARRAY_ELEMENT(ArrayName, ElementIndex) ((ArrayName)[(ElementIndex) / 4][(ElementIndex) % 4])

// Resources outside the graph.
#define SHADER_PARAMETER_TEXTURE(ShaderType, MemberName) \
	DRYDOCK_SHADER_PARAMETER_RESOURCE(UBMT_TEXTURE, #ShaderType, FRHITexture*, MemberName)
#define SHADER_PARAMETER_TEXTURE_ARRAY(ShaderType, MemberName, ArrayDecl) \
	DRYDOCK_SHADER_PARAMETER_RESOURCE(UBMT_TEXTURE, #ShaderType, FRHITexture* ArrayDecl, MemberName)
#define SHADER_PARAMETER_SRV(ShaderType, MemberName) \
	DRYDOCK_SHADER_PARAMETER_RESOURCE(UBMT_SRV, #ShaderType, FRHIShaderResourceView*, MemberName)
#define SHADER_PARAMETER_SRV_ARRAY(ShaderType, MemberName, ArrayDecl) \
	DRYDOCK_SHADER_PARAMETER_RESOURCE(UBMT_SRV, #ShaderType, FRHIShaderResourceView* ArrayDecl, MemberName)
#define SHADER_PARAMETER_UAV(ShaderType, MemberName) \
	DRYDOCK_SHADER_PARAMETER_RESOURCE(UBMT_UAV, #ShaderType, FRHIUnorderedAccessView*, MemberName)
#define SHADER_PARAMETER_SAMPLER(ShaderType, MemberName) \
	DRYDOCK_SHADER_PARAMETER_RESOURCE(UBMT_SAMPLER, #ShaderType, FRHISamplerState*, MemberName)
#define SHADER_PARAMETER_SAMPLER_ARRAY(ShaderType, MemberName, ArrayDecl) \
	DRYDOCK_SHADER_PARAMETER_RESOURCE(UBMT_SAMPLER, #ShaderType, FRHISamplerState* ArrayDecl, MemberName)

// Resources of the graph.
#define SHADER_PARAMETER_RDG_TEXTURE(ShaderType, MemberName) \
	DRYDOCK_SHADER_PARAMETER_RESOURCE(UBMT_RDG_TEXTURE, #ShaderType, FRDGTexture*, MemberName)
#define SHADER_PARAMETER_RDG_TEXTURE_ARRAY(ShaderType, MemberName, ArrayDecl) \
	DRYDOCK_SHADER_PARAMETER_RESOURCE(UBMT_RDG_TEXTURE, #ShaderType, FRDGTexture* ArrayDecl, MemberName)
#define SHADER_PARAMETER_RDG_TEXTURE_SRV(ShaderType, MemberName) \
	DRYDOCK_SHADER_PARAMETER_RESOURCE(UBMT_RDG_TEXTURE_SRV, #ShaderType, FRDGTextureSRV*, MemberName)
#define SHADER_PARAMETER_RDG_TEXTURE_NON_PIXEL_SRV(ShaderType, MemberName) \
	SHADER_PARAMETER_RDG_TEXTURE_SRV(ShaderType, MemberName)
#define SHADER_PARAMETER_RDG_TEXTURE_SRV_ARRAY(ShaderType, MemberName, ArrayDecl) \
	DRYDOCK_SHADER_PARAMETER_RESOURCE(UBMT_RDG_TEXTURE_SRV, #ShaderType, FRDGTextureSRV* ArrayDecl, MemberName)
#define SHADER_PARAMETER_RDG_TEXTURE_UAV(ShaderType, MemberName) \
	DRYDOCK_SHADER_PARAMETER_RESOURCE(UBMT_RDG_TEXTURE_UAV, #ShaderType, FRDGTextureUAV*, MemberName)
#define SHADER_PARAMETER_RDG_TEXTURE_UAV_ARRAY(ShaderType, MemberName, ArrayDecl) \
	DRYDOCK_SHADER_PARAMETER_RESOURCE(UBMT_RDG_TEXTURE_UAV, #ShaderType, FRDGTextureUAV* ArrayDecl, MemberName)
#define SHADER_PARAMETER_RDG_BUFFER_SRV(ShaderType, MemberName) \
	DRYDOCK_SHADER_PARAMETER_RESOURCE(UBMT_RDG_BUFFER_SRV, #ShaderType, FRDGBufferSRV*, MemberName)
#define SHADER_PARAMETER_RDG_BUFFER_SRV_ARRAY(ShaderType, MemberName, ArrayDecl) \
	DRYDOCK_SHADER_PARAMETER_RESOURCE(UBMT_RDG_BUFFER_SRV, #ShaderType, FRDGBufferSRV* ArrayDecl, MemberName)
#define SHADER_PARAMETER_RDG_BUFFER_UAV(ShaderType, MemberName) \
	DRYDOCK_SHADER_PARAMETER_RESOURCE(UBMT_RDG_BUFFER_UAV, #ShaderType, FRDGBufferUAV*, MemberName)
#define SHADER_PARAMETER_RDG_BUFFER_UAV_ARRAY(ShaderType, MemberName, ArrayDecl) \
	DRYDOCK_SHADER_PARAMETER_RESOURCE(UBMT_RDG_BUFFER_UAV, #ShaderType, FRDGBufferUAV* ArrayDecl, MemberName)

// Accesses without a shader binding.
#define RDG_TEXTURE_ACCESS(MemberName, Access) \
	DRYDOCK_SHADER_PARAMETER_OBJECT(UBMT_RDG_TEXTURE_ACCESS, "", TRDGTextureAccess<Access>, \
		SHADER_PARAMETER_POINTER_ALIGNMENT, MemberName, nullptr)
#define RDG_TEXTURE_ACCESS_DYNAMIC(MemberName) \
	DRYDOCK_SHADER_PARAMETER_OBJECT(UBMT_RDG_TEXTURE_ACCESS, "", FRDGTextureAccess, \
		SHADER_PARAMETER_POINTER_ALIGNMENT, MemberName, nullptr)
#define RDG_TEXTURE_ACCESS_ARRAY(MemberName) \
	DRYDOCK_SHADER_PARAMETER_OBJECT(UBMT_RDG_TEXTURE_ACCESS_ARRAY, "", FRDGTextureAccessArray, \
		SHADER_PARAMETER_POINTER_ALIGNMENT, MemberName, nullptr)
#define RDG_BUFFER_ACCESS(MemberName, Access) \
	DRYDOCK_SHADER_PARAMETER_OBJECT(UBMT_RDG_BUFFER_ACCESS, "", TRDGBufferAccess<Access>, \
		SHADER_PARAMETER_POINTER_ALIGNMENT, MemberName, nullptr)
#define RDG_BUFFER_ACCESS_DYNAMIC(MemberName) \
	DRYDOCK_SHADER_PARAMETER_OBJECT(UBMT_RDG_BUFFER_ACCESS, "", FRDGBufferAccess, SHADER_PARAMETER_POINTER_ALIGNMENT, \
		MemberName, nullptr)
#define RDG_BUFFER_ACCESS_ARRAY(MemberName) \
	DRYDOCK_SHADER_PARAMETER_OBJECT(UBMT_RDG_BUFFER_ACCESS_ARRAY, "", FRDGBufferAccessArray, \
		SHADER_PARAMETER_POINTER_ALIGNMENT, MemberName, nullptr)

// Structs in structs, and uniform buffers.
/** By value; HLSL sees `MemberName_Inner`. */
#define SHADER_PARAMETER_STRUCT(StructType, MemberName) \
	DRYDOCK_SHADER_PARAMETER_MEMBER(UBMT_NESTED_STRUCT, TShaderParameterStructTypeInfo<StructType>, #StructType, \
		StructType, MemberName, \
		EShaderPrecisionModifier::Float, 1, 1, TShaderParameterStructTypeInfo<StructType>::GetStructMetadata())

/** HLSL sees `MemberName_0_Inner`, `MemberName_1_Inner`, ... */
#define SHADER_PARAMETER_STRUCT_ARRAY(StructType, MemberName, ArrayDecl) \
	DRYDOCK_SHADER_PARAMETER_MEMBER(UBMT_NESTED_STRUCT, TShaderParameterStructTypeInfo<StructType ArrayDecl>, \
		#StructType, \
		TShaderParameterStructTypeInfo<StructType ArrayDecl>::TAlignedType, MemberName, \
		EShaderPrecisionModifier::Float, 1, 1, \
		TShaderParameterStructTypeInfo<StructType ArrayDecl>::GetStructMetadata())

/** HLSL sees `Inner`, without a prefix. */
#define SHADER_PARAMETER_STRUCT_INCLUDE(StructType, MemberName) \
	DRYDOCK_SHADER_PARAMETER_MEMBER(UBMT_INCLUDED_STRUCT, TShaderParameterStructTypeInfo<StructType>, #StructType, \
		StructType, MemberName, \
		EShaderPrecisionModifier::Float, 1, 1, TShaderParameterStructTypeInfo<StructType>::GetStructMetadata())

/** A uniform buffer outside the graph; HLSL sees `Name.Inner` by the name that IMPLEMENT_ gave it. */
#define SHADER_PARAMETER_STRUCT_REF(StructType, MemberName) \
	DRYDOCK_SHADER_PARAMETER_OBJECT(UBMT_REFERENCED_STRUCT, #StructType, TUniformBufferBinding<StructType>, \
		SHADER_PARAMETER_POINTER_ALIGNMENT, \
		MemberName, StructType::FTypeInfo::GetStructMetadata())

#define SHADER_PARAMETER_RDG_UNIFORM_BUFFER(StructType, MemberName) \
	DRYDOCK_SHADER_PARAMETER_OBJECT(UBMT_RDG_UNIFORM_BUFFER, #StructType, TRDGUniformBufferBinding<StructType>, \
		SHADER_PARAMETER_POINTER_ALIGNMENT, MemberName, StructType::FTypeInfo::GetStructMetadata())

/** The member is always called RenderTargets. */
#define RENDER_TARGET_BINDING_SLOTS() \
	DRYDOCK_SHADER_PARAMETER_OBJECT(UBMT_RENDER_TARGET_BINDING_SLOTS, "", FRenderTargetBindingSlots, \
		SHADER_PARAMETER_STRUCT_ALIGNMENT, \
		RenderTargets, nullptr)
