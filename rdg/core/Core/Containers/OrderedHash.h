// Implements TMap and TSet: elements in a dense array in the order they were added, found by a chained hash over their
// indices. Iteration never depends on hash values, so results do not either. Adding and finding take constant time;
// removing keeps the order and takes linear time.
#pragma once

#include "Containers/Array.h"
#include "Templates/TypeHash.h"

#include <vector>

namespace Drydock::Private
{

/** ElementType is what is stored; GetKey(const ElementType&) gives what it is found by. */
template<typename ElementType, typename KeyType, const KeyType& (*GetKey)(const ElementType&)>
class TOrderedHash
{
public:
	int32 Num() const { return static_cast<int32>(Elements.size()); }
	ElementType* GetData() { return Elements.data(); }
	const ElementType* GetData() const { return Elements.data(); }

	/** Index of the element with this key, or INDEX_NONE. Any key type that hashes and compares alike will do. */
	template<typename ComparableKey>
	int32 FindIndex(const ComparableKey& Key) const
	{
		if (Heads.empty())
		{
			return INDEX_NONE;
		}
		const uint32 Hash = GetTypeHash(Key);
		int32 Index = Heads[Hash & (Heads.size() - 1)];
		while (Index != INDEX_NONE && !(Links[Index].Hash == Hash && GetKey(Elements[Index]) == Key))
		{
			Index = Links[Index].Next;
		}
		return Index;
	}

	/** Appends an element whose key is not there yet; returns its index. */
	int32 Append(ElementType&& Element)
	{
		const uint32 Hash = GetTypeHash(GetKey(Element));
		Elements.push_back(std::move(Element));
		Links.push_back({Hash, INDEX_NONE});
		if (Elements.size() > Heads.size())
		{
			Rehash();
		}
		else
		{
			Link(Num() - 1);
		}
		return Num() - 1;
	}

	void RemoveAt(int32 Index)
	{
		Elements.erase(Elements.begin() + Index);
		Links.erase(Links.begin() + Index);
		Rehash();
	}

	template<typename PredicateType>
	int32 RemoveAll(PredicateType Predicate)
	{
		const int32 Before = Num();
		SIZE_T Kept = 0;
		for (SIZE_T Index = 0; Index < Elements.size(); ++Index)
		{
			if (!Predicate(Elements[Index]))
			{
				if (Kept != Index)
				{
					Elements[Kept] = std::move(Elements[Index]);
					Links[Kept] = Links[Index];
				}
				++Kept;
			}
		}
		Elements.erase(Elements.begin() + Kept, Elements.end());
		Links.resize(Kept);
		Rehash();
		return Before - Num();
	}

	void Reserve(int32 Count)
	{
		Elements.reserve(Count);
		Links.reserve(Count);
	}

	void Reset()
	{
		Elements.clear();
		Links.clear();
		Heads.clear();
	}

	/** Orders the elements by a predicate; equal ones keep their order. */
	template<typename PredicateType>
	void Sort(PredicateType Predicate)
	{
		std::stable_sort(Elements.begin(), Elements.end(), Predicate);
		for (SIZE_T Index = 0; Index < Elements.size(); ++Index)
		{
			Links[Index].Hash = GetTypeHash(GetKey(Elements[Index]));
		}
		Rehash();
	}

private:
	struct FLink
	{
		uint32 Hash;
		int32 Next;
	};

	void Link(int32 Index)
	{
		int32& Head = Heads[Links[Index].Hash & (Heads.size() - 1)];
		Links[Index].Next = Head;
		Head = Index;
	}

	/** Rebuilds the chains over a power of two of heads, at least as many as elements. */
	void Rehash()
	{
		SIZE_T Count = Heads.empty() ? 8 : Heads.size();
		while (Count < Elements.size())
		{
			Count *= 2;
		}
		Heads.assign(Count, INDEX_NONE);
		for (int32 Index = 0; Index < Num(); ++Index)
		{
			Link(Index);
		}
	}

	std::vector<ElementType> Elements;
	std::vector<FLink> Links; // of Elements, same indices
	std::vector<int32> Heads; // first element of each chain
};

} // namespace Drydock::Private
