// TMap: unique keys in the order they were added. Source: engine Containers/Map.h.
#pragma once

#include "Containers/OrderedHash.h"
#include "Templates/Tuple.h"

namespace Drydock::Private
{

template<typename KeyType, typename ValueType>
const KeyType& GetPairKey(const TPair<KeyType, ValueType>& Pair)
{
	return Pair.Key;
}

} // namespace Drydock::Private

template<typename InKeyType, typename InValueType, typename SetAllocator>
class TMap
{
public:
	using KeyType = InKeyType;
	using ValueType = InValueType;
	using ElementType = TPair<KeyType, ValueType>;

	TMap() = default;
	/** If two pairs have one key, the later pair wins. */
	TMap(std::initializer_list<ElementType> Pairs)
	{
		for (const ElementType& Pair : Pairs)
		{
			Add(Pair.Key, Pair.Value);
		}
	}

	int32 Num() const { return Hash.Num(); }
	bool IsEmpty() const { return Num() == 0; }
	ElementType* begin() { return Hash.GetData(); }
	const ElementType* begin() const { return Hash.GetData(); }
	ElementType* end() { return Hash.GetData() + Num(); }
	const ElementType* end() const { return Hash.GetData() + Num(); }

	/** Adds, or replaces the value of an equal key, which keeps its place. */
	ValueType& Add(const KeyType& Key, const ValueType& Value) { return Set(KeyType(Key), ValueType(Value)); }
	ValueType& Add(const KeyType& Key, ValueType&& Value) { return Set(KeyType(Key), std::move(Value)); }
	ValueType& Add(KeyType&& Key, const ValueType& Value) { return Set(std::move(Key), ValueType(Value)); }
	ValueType& Add(KeyType&& Key, ValueType&& Value) { return Set(std::move(Key), std::move(Value)); }
	ValueType& Add(const KeyType& Key) { return Set(KeyType(Key), ValueType()); }
	ValueType& Add(const ElementType& Pair) { return Add(Pair.Key, Pair.Value); }
	template<typename KeyArgument, typename... ValueArguments>
	ValueType& Emplace(KeyArgument&& Key, ValueArguments&&... Arguments)
	{
		return Set(KeyType(std::forward<KeyArgument>(Key)), ValueType(std::forward<ValueArguments>(Arguments)...));
	}
	void Append(const TMap& Other)
	{
		for (const ElementType& Pair : Other)
		{
			Add(Pair.Key, Pair.Value);
		}
	}

	/** The value of a key, which is added with a default value if missing. */
	ValueType& FindOrAdd(const KeyType& Key) { return FindOrAdd(Key, ValueType()); }
	ValueType& FindOrAdd(const KeyType& Key, ValueType Value)
	{
		int32 Index = Hash.FindIndex(Key);
		if (Index == INDEX_NONE)
		{
			Index = Hash.Append(ElementType{Key, std::move(Value)});
		}
		return Hash.GetData()[Index].Value;
	}
	/** Null if the key is not there. Adding or removing makes the pointer stale. */
	ValueType* Find(const KeyType& Key)
	{
		const int32 Index = Hash.FindIndex(Key);
		return Index == INDEX_NONE ? nullptr : &Hash.GetData()[Index].Value;
	}
	const ValueType* Find(const KeyType& Key) const { return const_cast<TMap*>(this)->Find(Key); }
	/** A copy of the value, or a default one. */
	ValueType FindRef(const KeyType& Key) const { return FindRef(Key, ValueType()); }
	ValueType FindRef(const KeyType& Key, ValueType Default) const
	{
		const ValueType* Value = Find(Key);
		return Value != nullptr ? *Value : std::move(Default);
	}
	/** The key must be there. */
	ValueType& FindChecked(const KeyType& Key)
	{
		ValueType* Value = Find(Key);
		check(Value != nullptr);
		return *Value;
	}
	const ValueType& FindChecked(const KeyType& Key) const { return const_cast<TMap*>(this)->FindChecked(Key); }
	ValueType& operator[](const KeyType& Key) { return FindChecked(Key); }
	const ValueType& operator[](const KeyType& Key) const { return FindChecked(Key); }
	bool Contains(const KeyType& Key) const { return Hash.FindIndex(Key) != INDEX_NONE; }
	/** The first key with that value, or null. Linear. */
	const KeyType* FindKey(const ValueType& Value) const
	{
		for (const ElementType& Pair : *this)
		{
			if (Pair.Value == Value)
			{
				return &Pair.Key;
			}
		}
		return nullptr;
	}

	/** Number of pairs removed: 0 or 1. */
	int32 Remove(const KeyType& Key)
	{
		const int32 Index = Hash.FindIndex(Key);
		if (Index == INDEX_NONE)
		{
			return 0;
		}
		Hash.RemoveAt(Index);
		return 1;
	}
	bool RemoveAndCopyValue(const KeyType& Key, ValueType& OutValue)
	{
		ValueType* Value = Find(Key);
		if (Value == nullptr)
		{
			return false;
		}
		OutValue = std::move(*Value);
		Remove(Key);
		return true;
	}
	ValueType FindAndRemoveChecked(const KeyType& Key)
	{
		ValueType Result = std::move(FindChecked(Key));
		Remove(Key);
		return Result;
	}
	void Empty(int32 Slack = 0)
	{
		Hash.Reset();
		Hash.Reserve(Slack);
	}
	void Reset() { Hash.Reset(); }
	void Reserve(int32 Count) { Hash.Reserve(Count); }

	/** Goes through the pairs; after RemoveCurrent ++ comes to the next one. */
	class TIterator
	{
	public:
		explicit TIterator(TMap& InMap)
			: Map(InMap)
		{
		}

		explicit operator bool() const { return Index < Map.Num(); }
		TIterator& operator++()
		{
			++Index;
			return *this;
		}
		ElementType& operator*() const { return Map.begin()[Index]; }
		ElementType* operator->() const { return Map.begin() + Index; }
		const KeyType& Key() const { return Map.begin()[Index].Key; }
		ValueType& Value() const { return Map.begin()[Index].Value; }
		void RemoveCurrent() { Map.Hash.RemoveAt(Index--); }

	private:
		TMap& Map;
		int32 Index = 0;
	};
	TIterator CreateIterator() { return TIterator(*this); }

	template<typename Allocator>
	void GenerateKeyArray(TArray<KeyType, Allocator>& OutKeys) const
	{
		OutKeys.Reset(Num());
		for (const ElementType& Pair : *this)
		{
			OutKeys.Add(Pair.Key);
		}
	}
	template<typename Allocator>
	void GenerateValueArray(TArray<ValueType, Allocator>& OutValues) const
	{
		OutValues.Reset(Num());
		for (const ElementType& Pair : *this)
		{
			OutValues.Add(Pair.Value);
		}
	}
	template<typename Allocator>
	int32 GetKeys(TArray<KeyType, Allocator>& OutKeys) const
	{
		GenerateKeyArray(OutKeys);
		return OutKeys.Num();
	}
	template<typename PredicateType>
	void KeySort(const PredicateType& Predicate)
	{
		Hash.Sort([&Predicate](const ElementType& A, const ElementType& B) { return Predicate(A.Key, B.Key); });
	}
	template<typename PredicateType>
	void ValueSort(const PredicateType& Predicate)
	{
		Hash.Sort([&Predicate](const ElementType& A, const ElementType& B) { return Predicate(A.Value, B.Value); });
	}
	/** Equal if both hold the same pairs, in any order. */
	bool OrderIndependentCompareEqual(const TMap& Other) const
	{
		return Num() == Other.Num() && std::all_of(begin(), end(),
										   [&Other](const ElementType& Pair)
										   {
											   const ValueType* Value = Other.Find(Pair.Key);
											   return Value != nullptr && *Value == Pair.Value;
										   });
	}

private:
	ValueType& Set(KeyType&& Key, ValueType&& Value)
	{
		int32 Index = Hash.FindIndex(Key);
		if (Index == INDEX_NONE)
		{
			Index = Hash.Append(ElementType{std::move(Key), std::move(Value)});
		}
		else
		{
			Hash.GetData()[Index].Value = std::move(Value);
		}
		return Hash.GetData()[Index].Value;
	}

	Drydock::Private::TOrderedHash<ElementType, KeyType, Drydock::Private::GetPairKey<KeyType, ValueType>> Hash;
};
