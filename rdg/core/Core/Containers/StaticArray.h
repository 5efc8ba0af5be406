// TStaticArray: an array of fixed size whose elements are aligned by default. Source: engine Containers/StaticArray.h.
#pragma once

#include "Containers/ContainersFwd.h"
#include "Misc/AssertionMacros.h"

template<typename T, uint32 NumElements>
class TStaticArray
{
public:
	using ElementType = T;

	TStaticArray() = default;
	/** Every element is Value. */
	explicit TStaticArray(const T& Value)
	{
		for (T& Element : Elements)
		{
			Element = Value;
		}
	}
	template<typename... ArgumentTypes>
	requires(sizeof...(ArgumentTypes) == NumElements && NumElements > 1) TStaticArray(ArgumentTypes&&... Values)
		: Elements{static_cast<T>(Values)...}
	{
	}

	static constexpr int32 Num() { return NumElements; }
	static constexpr bool IsEmpty() { return NumElements == 0; }
	T* GetData() { return Elements; }
	const T* GetData() const { return Elements; }
	T* begin() { return Elements; }
	const T* begin() const { return Elements; }
	T* end() { return Elements + NumElements; }
	const T* end() const { return Elements + NumElements; }

	T& operator[](uint32 Index)
	{
		checkf(Index < NumElements, "Array index out of bounds: %u into an array of size %u", Index, NumElements);
		return Elements[Index];
	}
	const T& operator[](uint32 Index) const
	{
		checkf(Index < NumElements, "Array index out of bounds: %u into an array of size %u", Index, NumElements);
		return Elements[Index];
	}

	bool operator==(const TStaticArray& Other) const = default;

private:
	T Elements[NumElements] = {};
};
