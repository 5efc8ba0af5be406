// An array that a new buffer takes its first contents from. Source: engine Containers/DynamicRHIResourceArray.h.
#pragma once

#include "RHIBuffer.h"

/** Alignments of the arrays that index and vertex buffers are made from, in bytes; 0: the element's. */
inline constexpr uint32 INDEXBUFFER_ALIGNMENT = 0;
inline constexpr uint32 VERTEXBUFFER_ALIGNMENT = 0;

template<typename ElementType, uint32 Alignment = 16>
class TResourceArray : public FResourceArrayInterface, public TArray<ElementType>
{
public:
	using TArray<ElementType>::TArray;

	const void* GetResourceData() const override { return this->GetData(); }
	uint32 GetResourceDataSize() const override { return uint32(this->Num()) * uint32(sizeof(ElementType)); }
	void SetAllowCPUAccess(bool) {}
};
