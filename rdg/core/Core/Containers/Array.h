// TArray: a dynamic array with the engine's interface over std::vector. Indices are int32; reading outside the array is
// a failed check in every build. "Uninitialized" elements are zeroed here, so that results never depend on old memory.
// Source: engine Containers/Array.h. A little past 500 lines: one class, which cannot be in two files.
#pragma once

#include "Containers/ContainersFwd.h"
#include "Misc/AssertionMacros.h"
#include "Templates/TypeHash.h"
#include "Templates/UnrealTemplate.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <type_traits>
#include <vector>

namespace Drydock::Private
{

// std::vector<bool> has no addressable elements; a box of the same size and layout has.
struct FBoolBox
{
	bool Value = false;

	FBoolBox() = default;
	FBoolBox(bool InValue)
		: Value(InValue)
	{
	}
};

template<typename T>
using TArrayElement = std::conditional_t<std::is_same_v<T, bool>, FBoolBox, T>;

/** Sorting predicates of arrays of pointers receive what the pointers point to, as in the engine. */
template<typename T>
const auto& Dereference(const T& Element)
{
	if constexpr (std::is_pointer_v<T>)
	{
		return *Element;
	}
	else
	{
		return Element;
	}
}

} // namespace Drydock::Private

/** Goes through an array by index: `for (auto It = Array.CreateIterator(); It; ++It)`. */
template<typename ContainerType, typename ElementType>
class TIndexedContainerIterator
{
public:
	explicit TIndexedContainerIterator(ContainerType& InContainer, int32 StartIndex = 0)
		: Container(&InContainer)
		, Index(StartIndex)
	{
	}

	TIndexedContainerIterator& operator++()
	{
		++Index;
		return *this;
	}
	TIndexedContainerIterator& operator--()
	{
		--Index;
		return *this;
	}
	ElementType& operator*() const { return (*Container)[Index]; }
	ElementType* operator->() const { return &(*Container)[Index]; }
	explicit operator bool() const { return Container->IsValidIndex(Index); }
	int32 GetIndex() const { return Index; }
	void Reset() { Index = 0; }
	void SetToEnd() { Index = Container->Num(); }
	/** The next ++ goes to the element behind it. */
	void RemoveCurrent() { Container->RemoveAt(Index--); }

private:
	ContainerType* Container;
	int32 Index;
};

template<typename T, typename Allocator>
class TArray
{
	using FElement = Drydock::Private::TArrayElement<T>;

	template<typename U, typename OtherAllocator>
	friend class TArray;

public:
	using ElementType = T;
	using SizeType = int32;
	using RangedForIteratorType = T*;

	TArray() = default;
	TArray(std::initializer_list<T> Elements)
		: Data(Elements.begin(), Elements.end())
	{
	}
	TArray(const T* Pointer, int32 Count)
		: Data(Pointer, Pointer + Count)
	{
	}
	template<typename OtherAllocator>
	TArray(const TArray<T, OtherAllocator>& Other)
		: Data(Other.Data)
	{
	}
	template<typename OtherAllocator>
	TArray(TArray<T, OtherAllocator>&& Other)
		: Data(std::move(Other.Data))
	{
	}
	explicit TArray(TArrayView<const T> View);
	explicit TArray(TArrayView<T> View) requires(!std::is_const_v<T>);

	TArray& operator=(std::initializer_list<T> Elements)
	{
		Data.assign(Elements.begin(), Elements.end());
		return *this;
	}

	int32 Num() const { return static_cast<int32>(Data.size()); }
	int32 Max() const { return static_cast<int32>(Data.capacity()); }
	int32 GetSlack() const { return Max() - Num(); }
	bool IsEmpty() const { return Data.empty(); }
	bool IsValidIndex(int32 Index) const { return Index >= 0 && Index < Num(); }
	T* GetData() { return reinterpret_cast<T*>(Data.data()); }
	const T* GetData() const { return reinterpret_cast<const T*>(Data.data()); }
	static constexpr uint32 GetTypeSize() { return sizeof(T); }
	SIZE_T NumBytes() const { return Data.size() * sizeof(T); }
	SIZE_T GetAllocatedSize() const { return Data.capacity() * sizeof(T); }

	T& operator[](int32 Index)
	{
		CheckIndex(Index);
		return GetData()[Index];
	}
	const T& operator[](int32 Index) const
	{
		CheckIndex(Index);
		return GetData()[Index];
	}
	/** The element IndexFromTheEnd before the last. */
	T& Last(int32 IndexFromTheEnd = 0) { return (*this)[Num() - IndexFromTheEnd - 1]; }
	const T& Last(int32 IndexFromTheEnd = 0) const { return (*this)[Num() - IndexFromTheEnd - 1]; }
	T& Top() { return Last(); }
	const T& Top() const { return Last(); }

	T* begin() { return GetData(); }
	const T* begin() const { return GetData(); }
	T* end() { return GetData() + Data.size(); }
	const T* end() const { return GetData() + Data.size(); }

	using TIterator = TIndexedContainerIterator<TArray, T>;
	using TConstIterator = TIndexedContainerIterator<const TArray, const T>;
	TIterator CreateIterator() { return TIterator(*this); }
	TConstIterator CreateConstIterator() const { return TConstIterator(*this); }

	/** Adds at the end and returns the index. Element may lie in this array. */
	int32 Add(const T& Element)
	{
		Data.push_back(Element);
		return Num() - 1;
	}
	int32 Add(T&& Element)
	{
		Data.push_back(std::move(Element));
		return Num() - 1;
	}
	// Functions that end with _GetRef return the new element. The index comes first: adding may move the elements.
	T& Add_GetRef(const T& Element) { return (*this)[Add(Element)]; }
	T& Add_GetRef(T&& Element) { return (*this)[Add(std::move(Element))]; }
	void Push(const T& Element) { Add(Element); }
	void Push(T&& Element) { Add(std::move(Element)); }
	template<typename... ArgumentTypes>
	int32 Emplace(ArgumentTypes&&... Arguments)
	{
		if constexpr (std::is_constructible_v<FElement, ArgumentTypes...>)
		{
			Data.emplace_back(std::forward<ArgumentTypes>(Arguments)...);
		}
		else
		{
			Data.push_back(FElement{std::forward<ArgumentTypes>(Arguments)...});
		}
		return Num() - 1;
	}
	template<typename... ArgumentTypes>
	T& Emplace_GetRef(ArgumentTypes&&... Arguments)
	{
		return (*this)[Emplace(std::forward<ArgumentTypes>(Arguments)...)];
	}
	/** Adds unless an equal element is there; returns the index of the one that is in the array. */
	int32 AddUnique(const T& Element)
	{
		const int32 Index = Find(Element);
		return Index != INDEX_NONE ? Index : Add(Element);
	}
	/** Adds Count elements and returns the index of the first of them. */
	int32 AddDefaulted(int32 Count = 1)
	{
		const int32 Index = Num();
		SetNum(Index + Count);
		return Index;
	}
	T& AddDefaulted_GetRef() { return (*this)[AddDefaulted()]; }
	/** The new elements are all zero bytes, also where T has other defaults; T's defaults if memory cannot be T. */
	int32 AddZeroed(int32 Count = 1)
	{
		const int32 Index = AddDefaulted(Count);
		if constexpr (std::is_trivially_copyable_v<T>)
		{
			std::fill_n(reinterpret_cast<uint8*>(GetData() + Index), Count * sizeof(T), uint8(0));
		}
		return Index;
	}
	T& AddZeroed_GetRef() { return (*this)[AddZeroed()]; }
	int32 AddUninitialized(int32 Count = 1) { return AddDefaulted(Count); }

	void Append(const T* Pointer, int32 Count) { Data.insert(Data.end(), Pointer, Pointer + Count); }
	void Append(std::initializer_list<T> Elements) { Data.insert(Data.end(), Elements.begin(), Elements.end()); }
	template<typename RangeType>
	requires requires(const RangeType& Range)
	{
		Range.GetData();
		Range.Num();
	}
	void Append(const RangeType& Range)
	{
		if (static_cast<const void*>(&Range) == this)
		{
			const TArray Copy(*this);
			Append(Copy.GetData(), Copy.Num());
			return;
		}
		Append(Range.GetData(), Range.Num());
	}
	TArray& operator+=(const TArray& Other)
	{
		Append(Other);
		return *this;
	}
	TArray& operator+=(std::initializer_list<T> Elements)
	{
		Append(Elements);
		return *this;
	}

	/** Inserts before Index and returns Index. */
	int32 Insert(const T& Element, int32 Index)
	{
		check(Index >= 0 && Index <= Num());
		Data.insert(Data.begin() + Index, Element);
		return Index;
	}
	int32 Insert(T&& Element, int32 Index)
	{
		check(Index >= 0 && Index <= Num());
		Data.insert(Data.begin() + Index, std::move(Element));
		return Index;
	}
	int32 Insert(std::initializer_list<T> Elements, int32 Index)
	{
		check(Index >= 0 && Index <= Num());
		Data.insert(Data.begin() + Index, Elements.begin(), Elements.end());
		return Index;
	}
	template<typename... ArgumentTypes>
	void EmplaceAt(int32 Index, ArgumentTypes&&... Arguments)
	{
		Insert(T(std::forward<ArgumentTypes>(Arguments)...), Index);
	}

	void RemoveAt(int32 Index) { RemoveAt(Index, 1); }
	void RemoveAt(int32 Index, int32 Count, FAllowShrinking = EAllowShrinking::Default)
	{
		checkf(Index >= 0 && Count >= 0 && Index + Count <= Num(),
			"Invalid Count (%d) or Index (%d) in RemoveAt from an array of size %d", Count, Index, Num());
		Data.erase(Data.begin() + Index, Data.begin() + Index + Count);
	}
	/** Removes without keeping the order: the last element takes the place. */
	void RemoveAtSwap(int32 Index)
	{
		CheckIndex(Index);
		if (Index != Num() - 1)
		{
			Data[Index] = std::move(Data.back());
		}
		Data.pop_back();
	}
	/** Removes all equal elements; returns how many. */
	int32 Remove(const T& Element)
	{
		return RemoveAll([Copy = Element](const T& Other) { return Other == Copy; });
	}
	int32 RemoveSingle(const T& Element)
	{
		const int32 Index = Find(Element);
		if (Index == INDEX_NONE)
		{
			return 0;
		}
		RemoveAt(Index);
		return 1;
	}
	int32 RemoveSwap(const T& Element) { return Remove(Element); }
	int32 RemoveSingleSwap(const T& Element)
	{
		const int32 Index = Find(Element);
		if (Index == INDEX_NONE)
		{
			return 0;
		}
		RemoveAtSwap(Index);
		return 1;
	}
	template<typename PredicateType>
	int32 RemoveAll(const PredicateType& Predicate)
	{
		const int32 Before = Num();
		T* const NewEnd = std::remove_if(begin(), end(), Predicate);
		Data.erase(Data.begin() + (NewEnd - begin()), Data.end());
		return Before - Num();
	}
	template<typename PredicateType>
	int32 RemoveAllSwap(const PredicateType& Predicate)
	{
		return RemoveAll(Predicate);
	}
	T Pop() { return Pop(EAllowShrinking::Default); }
	T Pop(FAllowShrinking)
	{
		CheckIndex(Num() - 1);
		T Result = std::move(end()[-1]);
		Data.pop_back();
		return Result;
	}

	void Empty(int32 Slack = 0)
	{
		std::vector<FElement>().swap(Data);
		Data.reserve(Slack);
	}
	/** Empties without giving memory back. */
	void Reset(int32 NewSize = 0)
	{
		Data.clear();
		Data.reserve(NewSize);
	}
	void Reserve(int32 Count) { Data.reserve(Count); }
	void Shrink() { Data.shrink_to_fit(); }
	void SetNum(int32 Count) { SetNum(Count, EAllowShrinking::Default); }
	void SetNum(int32 Count, FAllowShrinking)
	{
		checkf(Count >= 0, "Invalid number of elements in SetNum: %d", Count);
		Data.resize(Count);
	}
	void SetNumZeroed(int32 Count, FAllowShrinking = EAllowShrinking::Default)
	{
		if (Count > Num())
		{
			AddZeroed(Count - Num());
			return;
		}
		SetNum(Count);
	}
	void SetNumUninitialized(int32 Count, FAllowShrinking = EAllowShrinking::Default) { SetNum(Count); }
	/** Count copies of Element. */
	void Init(const T& Element, int32 Count) { Data.assign(Count, Element); }
	void SwapMemory(int32 A, int32 B) { Swap(A, B); }
	void Swap(int32 A, int32 B)
	{
		CheckIndex(A);
		CheckIndex(B);
		std::swap(Data[A], Data[B]);
	}

	/** Index of the first equal element or INDEX_NONE. */
	template<typename KeyType>
	int32 Find(const KeyType& Key) const
	{
		return ToIndex(std::find(begin(), end(), Key));
	}
	template<typename KeyType>
	bool Find(const KeyType& Key, int32& OutIndex) const
	{
		OutIndex = Find(Key);
		return OutIndex != INDEX_NONE;
	}
	int32 FindLast(const T& Element) const
	{
		return FindLastByPredicate([&Element](const T& Other) { return Other == Element; });
	}
	template<typename PredicateType>
	int32 FindLastByPredicate(PredicateType Predicate) const
	{
		int32 Index = Num() - 1;
		while (Index >= 0 && !Predicate(GetData()[Index]))
		{
			--Index;
		}
		return Index;
	}
	template<typename KeyType>
	int32 IndexOfByKey(const KeyType& Key) const
	{
		return IndexOfByPredicate([&Key](const T& Element) { return Element == Key; });
	}
	template<typename PredicateType>
	int32 IndexOfByPredicate(PredicateType Predicate) const
	{
		return ToIndex(std::find_if(begin(), end(), Predicate));
	}
	/** The first element equal to Key, or null. */
	template<typename KeyType>
	T* FindByKey(const KeyType& Key)
	{
		return ToPointer(IndexOfByKey(Key));
	}
	template<typename KeyType>
	const T* FindByKey(const KeyType& Key) const
	{
		return ToPointer(IndexOfByKey(Key));
	}
	template<typename PredicateType>
	T* FindByPredicate(PredicateType Predicate)
	{
		return ToPointer(IndexOfByPredicate(Predicate));
	}
	template<typename PredicateType>
	const T* FindByPredicate(PredicateType Predicate) const
	{
		return ToPointer(IndexOfByPredicate(Predicate));
	}
	template<typename KeyType>
	bool Contains(const KeyType& Key) const
	{
		return IndexOfByKey(Key) != INDEX_NONE;
	}
	template<typename PredicateType>
	bool ContainsByPredicate(PredicateType Predicate) const
	{
		return IndexOfByPredicate(Predicate) != INDEX_NONE;
	}
	template<typename PredicateType>
	TArray FilterByPredicate(PredicateType Predicate) const
	{
		TArray Result;
		std::copy_if(begin(), end(), std::back_inserter(Result.Data), Predicate);
		return Result;
	}

	/** Sorts by < or a predicate. Equal elements keep their order, so that results do not depend on the library. */
	void Sort()
	{
		Sort([](const auto& A, const auto& B) { return A < B; });
	}
	template<typename PredicateType>
	void Sort(const PredicateType& Predicate)
	{
		std::stable_sort(begin(), end(),
			[&Predicate](const T& A, const T& B)
			{ return Predicate(Drydock::Private::Dereference(A), Drydock::Private::Dereference(B)); });
	}
	void StableSort() { Sort(); }
	template<typename PredicateType>
	void StableSort(const PredicateType& Predicate)
	{
		Sort(Predicate);
	}

	template<typename OtherAllocator>
	bool operator==(const TArray<T, OtherAllocator>& Other) const
	{
		return std::equal(begin(), end(), Other.begin(), Other.end());
	}

private:
	void CheckIndex(int32 Index) const
	{
		checkf(IsValidIndex(Index), "Array index out of bounds: %d into an array of size %d", Index, Num());
	}
	int32 ToIndex(const T* Found) const { return Found == end() ? INDEX_NONE : static_cast<int32>(Found - begin()); }
	T* ToPointer(int32 Index) { return Index == INDEX_NONE ? nullptr : GetData() + Index; }
	const T* ToPointer(int32 Index) const { return Index == INDEX_NONE ? nullptr : GetData() + Index; }

	std::vector<FElement> Data;
};

#include "Containers/ArrayView.h"

template<typename T, typename Allocator>
TArray<T, Allocator>::TArray(TArrayView<const T> View)
	: Data(View.begin(), View.end())
{
}

template<typename T, typename Allocator>
TArray<T, Allocator>::TArray(TArrayView<T> View) requires(!std::is_const_v<T>)
	: Data(View.begin(), View.end())
{
}

template<typename T, typename Allocator>
uint32 GetTypeHash(const TArray<T, Allocator>& Array)
{
	uint32 Hash = 0;
	for (const T& Element : Array)
	{
		Hash = HashCombine(Hash, GetTypeHash(Element));
	}
	return Hash;
}
