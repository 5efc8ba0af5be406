// References to uniform buffers, typed by their struct: TUniformBufferRef outside the graph, and the two kinds of
// parameter-struct members that hold one. Source: engine ShaderParameterMacros.h.
#pragma once

#include "CoreMinimal.h"
#include "RHIResource.h"
#include "RenderGraphFwd.h"
#include "ShaderParameterMetadata.h"

#include <cstddef>
#include <vector>

/** How long the contents are meant to live: a hint to a GPU. */
enum EUniformBufferUsage
{
	UniformBuffer_SingleDraw,
	UniformBuffer_SingleFrame,
	UniformBuffer_MultiFrame,
};

enum class EUniformBufferValidation : uint8
{
	None,
	ValidateResources,
};

/** Whether a buffer is bound by shader or by static slot; the same thing here. */
enum class EUniformBufferBindingFlags : uint8
{
	Shader = 1 << 0,
	Static = 1 << 1,
	StaticAndShader = Shader | Static,
};

/** A uniform buffer: a copy of a parameter struct's bytes. The resources that they point to are not kept alive. */
class DRYDOCK_API FRHIUniformBuffer final : public FRHIResource
{
public:
	FRHIUniformBuffer(const FShaderParametersMetadata& InMetadata, const void* InContents);

	const FShaderParametersMetadata& GetMetadata() const { return Metadata; }
	uint32 GetSize() const { return Metadata.GetSize(); }
	const void* GetContents() const { return Contents.data(); }

private:
	struct alignas(16) FBlock
	{
		uint8 Bytes[16];
	};

	const FShaderParametersMetadata& Metadata;
	std::vector<FBlock> Contents;
};

using FUniformBufferRHIRef = TRefCountPtr<FRHIUniformBuffer>;

namespace Drydock
{

/** Makes a uniform buffer with a copy of Contents, which is laid out by Metadata. */
DRYDOCK_API FUniformBufferRHIRef CreateUniformBuffer(const FShaderParametersMetadata& Metadata, const void* Contents);

} // namespace Drydock

/** A counted reference to a uniform buffer that holds a TBufferStruct. */
template<typename TBufferStruct>
class TUniformBufferRef : public FUniformBufferRHIRef
{
public:
	TUniformBufferRef() = default;

	explicit TUniformBufferRef(FRHIUniformBuffer* InBuffer)
		: FUniformBufferRHIRef(InBuffer)
	{
	}
	explicit TUniformBufferRef(const FUniformBufferRHIRef& InBuffer)
		: FUniformBufferRHIRef(InBuffer)
	{
	}

	/** Copies Value. The usage is a hint to a GPU. */
	static TUniformBufferRef CreateUniformBufferImmediate(const TBufferStruct& Value, EUniformBufferUsage,
		EUniformBufferValidation = EUniformBufferValidation::ValidateResources)
	{
		return TUniformBufferRef(Drydock::CreateUniformBuffer(*TBufferStruct::FTypeInfo::GetStructMetadata(), &Value));
	}

	/** A new buffer takes the place of the one before, so passes keep what they were given. */
	template<typename CommandListType>
	void UpdateUniformBufferImmediate(CommandListType&, const TBufferStruct& Value)
	{
		*this = CreateUniformBufferImmediate(Value, UniformBuffer_MultiFrame);
	}

	static TUniformBufferRef CreateEmptyUniformBufferImmediate(EUniformBufferUsage Usage)
	{
		return CreateUniformBufferImmediate(TBufferStruct(), Usage);
	}
};

/** The value that a shader's parameter takes: the buffer itself. */
template<typename TBufferStruct>
const TUniformBufferRef<TBufferStruct>& GetShaderBinding(const TUniformBufferRef<TBufferStruct>& Buffer)
{
	return Buffer;
}

template<typename TBufferStruct>
TUniformBufferRef<TBufferStruct> CreateUniformBufferImmediate(const TBufferStruct& Value, EUniformBufferUsage Usage,
	EUniformBufferValidation Validation = EUniformBufferValidation::ValidateResources)
{
	return TUniformBufferRef<TBufferStruct>::CreateUniformBufferImmediate(Value, Usage, Validation);
}

/** The member type that SHADER_PARAMETER_STRUCT_REF declares. */
template<typename TBufferStruct>
class TUniformBufferBinding
{
public:
	TUniformBufferBinding() = default;
	TUniformBufferBinding(const TUniformBufferRef<TBufferStruct>& InBuffer)
		: Buffer(InBuffer)
	{
	}
	TUniformBufferBinding(const TUniformBufferRef<TBufferStruct>& InBuffer, EUniformBufferBindingFlags)
		: Buffer(InBuffer)
	{
	}
	TUniformBufferBinding(std::nullptr_t) {}

	const TUniformBufferRef<TBufferStruct>& GetUniformBuffer() const { return Buffer; }
	FRHIUniformBuffer* GetReference() const { return Buffer.GetReference(); }
	FRHIUniformBuffer* operator->() const { return Buffer.GetReference(); }
	operator FRHIUniformBuffer*() const { return Buffer.GetReference(); }
	operator const TUniformBufferRef<TBufferStruct>&() const { return Buffer; }
	bool IsValid() const { return Buffer.IsValid(); }
	explicit operator bool() const { return IsValid(); }

private:
	TUniformBufferRef<TBufferStruct> Buffer;
};

/** The member type that SHADER_PARAMETER_RDG_UNIFORM_BUFFER declares. */
template<typename TBufferStruct>
class TRDGUniformBufferBinding
{
public:
	TRDGUniformBufferBinding() = default;
	TRDGUniformBufferBinding(TRDGUniformBufferRef<TBufferStruct> InBuffer)
		: Buffer(InBuffer)
	{
	}
	TRDGUniformBufferBinding(TRDGUniformBufferRef<TBufferStruct> InBuffer, EUniformBufferBindingFlags)
		: Buffer(InBuffer)
	{
	}
	TRDGUniformBufferBinding(std::nullptr_t) {}

	TRDGUniformBufferRef<TBufferStruct> GetUniformBuffer() const { return Buffer; }
	TRDGUniformBufferRef<TBufferStruct> operator->() const { return Buffer; }
	operator TRDGUniformBufferRef<TBufferStruct>() const { return Buffer; }
	bool IsValid() const { return Buffer != nullptr; }
	explicit operator bool() const { return IsValid(); }

private:
	TRDGUniformBufferRef<TBufferStruct> Buffer = nullptr;
};
