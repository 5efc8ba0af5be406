// TSet: unique elements in the order they were added. Source: engine Containers/Set.h.
#pragma once

#include "Containers/OrderedHash.h"

namespace Drydock::Private
{

template<typename T>
const T& GetItself(const T& Element)
{
	return Element;
}

} // namespace Drydock::Private

template<typename T, typename SetAllocator>
class TSet
{
public:
	using ElementType = T;

	TSet() = default;
	TSet(std::initializer_list<T> Elements) { Append(Elements); }
	template<typename Allocator>
	explicit TSet(const TArray<T, Allocator>& Elements)
	{
		Append(Elements);
	}

	int32 Num() const { return Hash.Num(); }
	bool IsEmpty() const { return Num() == 0; }
	const T* begin() const { return Hash.GetData(); }
	const T* end() const { return Hash.GetData() + Num(); }

	/** Adds the element unless it is there already; *bOutAlreadyThere reports that. */
	void Add(T Element, bool* bOutAlreadyThere = nullptr)
	{
		const bool bThere = Contains(Element);
		if (!bThere)
		{
			Hash.Append(std::move(Element));
		}
		if (bOutAlreadyThere != nullptr)
		{
			*bOutAlreadyThere = bThere;
		}
	}
	template<typename... ArgumentTypes>
	void Emplace(ArgumentTypes&&... Arguments)
	{
		Add(T(std::forward<ArgumentTypes>(Arguments)...));
	}
	template<typename RangeType>
	void Append(const RangeType& Elements)
	{
		for (const T& Element : Elements)
		{
			Add(Element);
		}
	}
	bool Contains(const T& Element) const { return Hash.FindIndex(Element) != INDEX_NONE; }
	/** Null if it is not there. */
	const T* Find(const T& Element) const
	{
		const int32 Index = Hash.FindIndex(Element);
		return Index == INDEX_NONE ? nullptr : Hash.GetData() + Index;
	}
	int32 Remove(const T& Element)
	{
		const int32 Index = Hash.FindIndex(Element);
		if (Index == INDEX_NONE)
		{
			return 0;
		}
		Hash.RemoveAt(Index);
		return 1;
	}
	void Empty(int32 Slack = 0)
	{
		Hash.Reset();
		Hash.Reserve(Slack);
	}
	void Reset() { Hash.Reset(); }
	void Reserve(int32 Count) { Hash.Reserve(Count); }
	TArray<T> Array() const { return TArray<T>(begin(), Num()); }
	template<typename PredicateType>
	void Sort(const PredicateType& Predicate)
	{
		Hash.Sort(Predicate);
	}

	TSet Union(const TSet& Other) const
	{
		TSet Result = *this;
		Result.Append(Other);
		return Result;
	}
	TSet Intersect(const TSet& Other) const
	{
		TSet Result = *this;
		Result.Hash.RemoveAll([&Other](const T& Element) { return !Other.Contains(Element); });
		return Result;
	}
	/** The elements that are here and not in Other. */
	TSet Difference(const TSet& Other) const
	{
		TSet Result = *this;
		Result.Hash.RemoveAll([&Other](const T& Element) { return Other.Contains(Element); });
		return Result;
	}
	/** True if every element of Other is here. */
	bool Includes(const TSet& Other) const
	{
		return std::all_of(Other.begin(), Other.end(), [this](const T& Element) { return Contains(Element); });
	}

private:
	Drydock::Private::TOrderedHash<T, T, Drydock::Private::GetItself<T>> Hash;
};
