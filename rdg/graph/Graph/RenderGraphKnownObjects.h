// The addresses of a graph's objects and of what kind each is. A pointer is looked up, never looked into. Internal to
// this folder.
#pragma once

#include "RenderGraphObjects.h"

#include <cstdint>
#include <vector>

namespace Drydock
{

/** Open addressing in one block of memory: every parameter of every pass is looked up, and every object added. */
class FRDGKnownObjects
{
public:
	FRDGKnownObjects()
		: Slots(FirstNumSlots)
	{
	}

	void Add(const void* Object, ERDGObject Kind)
	{
		if (2 * ++NumObjects > Slots.size())
		{
			std::vector<FSlot> Old(2 * Slots.size());
			Old.swap(Slots);
			for (const FSlot& Slot : Old)
			{
				if (Slot.Object)
				{
					Slots[Find(Slot.Object)] = Slot;
				}
			}
		}
		Slots[Find(Object)] = {Object, Kind};
	}

	/** Whether Object is known and of one of these kinds. */
	bool Has(const void* Object, ERDGObject Kinds) const
	{
		const FSlot& Slot = Slots[Find(Object)];
		return Object && Slot.Object == Object && EnumHasAnyFlags(Slot.Kind, Kinds);
	}

private:
	struct FSlot
	{
		const void* Object = nullptr;
		ERDGObject Kind = ERDGObject::None;
	};

	/** Its place, or the free one where it would go. */
	size_t Find(const void* Object) const
	{
		const size_t Mask = Slots.size() - 1;
		const uint64_t Hash = static_cast<uint64_t>(reinterpret_cast<uintptr_t>(Object)) * 0x9E3779B97F4A7C15u;
		size_t Place = static_cast<size_t>(Hash >> 32) & Mask;
		while (Slots[Place].Object && Slots[Place].Object != Object)
		{
			Place = (Place + 1) & Mask;
		}
		return Place;
	}

	static constexpr size_t FirstNumSlots = 256; // a power of two, as every later number

	std::vector<FSlot> Slots; // at most half of them are taken
	size_t NumObjects = 0;
};

} // namespace Drydock
