// Reads what the members of a parameter struct hold, by the offsets of its binding plan. Used by this folder.
#pragma once

#include "RenderGraphResources.h"
#include "RHIResources.h"
#include "ShaderBindingPlan.h"
#include "ShaderParameterMacros.h"
#include "UniformBufferStructs.h"

#include <cstring>

namespace Drydock
{

inline constexpr uint32 PointerSize = 8;

static_assert(sizeof(TUniformBufferBinding<int>) == PointerSize && sizeof(TRDGUniformBufferBinding<int>) == PointerSize,
	"members that hold one resource are one pointer, which the binder reads without knowing their type");

/** The pointer Offset bytes into Contents. */
template<typename T>
T* ReadPointer(const void* Contents, uint32 Offset)
{
	T* Pointer = nullptr;
	std::memcpy(&Pointer, static_cast<const uint8*>(Contents) + Offset, PointerSize);
	return Pointer;
}

/** Contents of a source: the parameter struct itself, or the uniform buffer that its member holds (null when it holds
 * none). */
inline const void* GetContents(const FBindingSource& Source, const void* Parameters)
{
	if (Source.BaseType == UBMT_REFERENCED_STRUCT)
	{
		const FRHIUniformBuffer* Buffer = ReadPointer<const FRHIUniformBuffer>(Parameters, Source.Offset);
		return Buffer ? Buffer->GetContents() : nullptr;
	}
	if (Source.BaseType == UBMT_RDG_UNIFORM_BUFFER)
	{
		const FRDGUniformBuffer* Buffer = ReadPointer<const FRDGUniformBuffer>(Parameters, Source.Offset);
		return Buffer ? Buffer->GetContents() : nullptr;
	}
	return Source.bOfFrame ? GetFrameUniformBufferContents() : Parameters;
}

/** The view that a RWTexture's or RWBuffer's member holds. */
inline const FRHIUnorderedAccessView& GetView(const FResourceCopy& Copy, const void* Contents)
{
	return Copy.BaseType == UBMT_UAV ? *ReadPointer<FRHIUnorderedAccessView>(Contents, Copy.SourceOffset)
									 : *ReadPointer<FRDGBufferUAV>(Contents, Copy.SourceOffset)->GetRHI();
}

} // namespace Drydock
