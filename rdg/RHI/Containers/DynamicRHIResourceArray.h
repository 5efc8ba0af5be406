// An array that a new buffer takes its first contents from. Source: engine Containers/DynamicRHIResourceArray.h.
#pragma once

#include "RHIBuffer.h"

template<typename ElementType, uint32 Alignment = 16>
class TResourceArray : public FResourceArrayInterface, public TArray<ElementType>
{
public:
	using TArray<ElementType>::TArray;

	const void* GetResourceData() const override { return this->GetData(); }
	uint32 GetResourceDataSize() const override { return uint32(this->Num()) * uint32(sizeof(ElementType)); }
	void SetAllowCPUAccess(bool) {}
};
