// Memory that lives as long as its graph: parameter structs, arrays, objects. Source: engine RenderGraphAllocator.h.
#pragma once

#include "CoreMinimal.h"

#include <memory>
#include <new>
#include <vector>

namespace Drydock
{

/** Hands out memory from blocks and runs destructors in reverse order at the end. */
class DRYDOCK_API FRDGAllocator : private FNoncopyable
{
public:
	~FRDGAllocator();

	/** Alignment is a power of two. The memory is zeroed. */
	void* Alloc(uint64 SizeInBytes, uint32 AlignInBytes = 16);
	/** The same, with whatever the memory holds: for objects that are constructed in it. */
	void* AllocUninitialized(uint64 SizeInBytes, uint32 AlignInBytes);

	/** The destructor runs when the allocator goes. */
	template<typename T, typename... ArgumentTypes>
	T* AllocObject(ArgumentTypes&&... Arguments)
	{
		T* Object = new (Alloc(sizeof(T), alignof(T))) T(std::forward<ArgumentTypes>(Arguments)...);
		if constexpr (!std::is_trivially_destructible_v<T>)
		{
			Destructors.push_back({Object, [](void* Memory)
				{
					static_cast<T*>(Memory)->~T();
				}});
		}
		return Object;
	}

	uint64 GetAllocatedBytes() const { return AllocatedBytes; }

private:
	struct FDestructor
	{
		void* Object;
		void (*Destroy)(void*);
	};

	static constexpr uint64 FirstBlockSize = 4 * 1024;
	static constexpr uint64 LargestBlockSize = 32 * 1024;

	std::vector<std::unique_ptr<uint8[]>> Blocks;
	std::vector<FDestructor> Destructors;
	uint8* Free = nullptr;
	uint8* End = nullptr;
	uint64 NextBlockSize = FirstBlockSize; // each block is twice as large as the one before
	uint64 AllocatedBytes = 0;
};

} // namespace Drydock
