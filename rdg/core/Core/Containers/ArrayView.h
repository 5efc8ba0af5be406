// TArrayView: a pointer and a number of elements that somebody else owns. Source: engine Containers/ArrayView.h.
#pragma once

#include "Containers/ContainersFwd.h"
#include "Misc/AssertionMacros.h"

#include <algorithm>
#include <concepts>
#include <initializer_list>
#include <type_traits>

template<typename T>
class TArrayView
{
public:
	using ElementType = T;

	TArrayView() = default;
	template<typename U>
	requires std::is_convertible_v<U (*)[], T (*)[]> TArrayView(U* InData, int32 Count)
		: Data(InData)
		, ArrayNum(Count)
	{
		check(Count >= 0);
	}
	template<SIZE_T Count>
	TArrayView(T (&Array)[Count])
		: Data(Array)
		, ArrayNum(static_cast<int32>(Count))
	{
	}
	/** Lives as long as the full expression: for arguments. */
	TArrayView(std::initializer_list<std::remove_const_t<T>> List) requires std::is_const_v<T>
		: Data(List.begin()), ArrayNum(static_cast<int32>(List.size()))
	{
	}
	/** Views anything with GetData() and Num(). */
	template<typename RangeType>
	requires requires(RangeType& Range)
	{
		{
			Range.GetData()
			} -> std::convertible_to<T*>;
		{
			Range.Num()
			} -> std::convertible_to<int32>;
	}
	TArrayView(RangeType&& Range)
		: Data(Range.GetData())
		, ArrayNum(static_cast<int32>(Range.Num()))
	{
	}

	int32 Num() const { return ArrayNum; }
	bool IsEmpty() const { return ArrayNum == 0; }
	bool IsValidIndex(int32 Index) const { return Index >= 0 && Index < ArrayNum; }
	T* GetData() const { return Data; }
	static constexpr uint32 GetTypeSize() { return sizeof(T); }
	SIZE_T NumBytes() const { return sizeof(T) * ArrayNum; }
	T* begin() const { return Data; }
	T* end() const { return Data + ArrayNum; }

	T& operator[](int32 Index) const
	{
		checkf(IsValidIndex(Index), "Array index out of bounds: %d into an array of size %d", Index, ArrayNum);
		return Data[Index];
	}
	T& Last(int32 IndexFromTheEnd = 0) const { return (*this)[ArrayNum - IndexFromTheEnd - 1]; }

	/** Count elements from Index on; must lie inside. */
	TArrayView Slice(int32 Index, int32 Count) const
	{
		check(Index >= 0 && Count >= 0 && Index + Count <= ArrayNum);
		return TArrayView(Data + Index, Count);
	}
	/** The first Count elements, or fewer if there are fewer. */
	TArrayView Left(int32 Count) const { return Slice(0, std::clamp(Count, 0, ArrayNum)); }
	TArrayView Right(int32 Count) const
	{
		const int32 Taken = std::clamp(Count, 0, ArrayNum);
		return Slice(ArrayNum - Taken, Taken);
	}
	TArrayView RightChop(int32 Count) const { return Right(ArrayNum - Count); }
	TArrayView Mid(int32 Index) const { return RightChop(Index); }

	template<typename KeyType>
	int32 Find(const KeyType& Key) const
	{
		T* const Found = std::find(begin(), end(), Key);
		return Found == end() ? INDEX_NONE : static_cast<int32>(Found - begin());
	}
	template<typename KeyType>
	bool Contains(const KeyType& Key) const
	{
		return Find(Key) != INDEX_NONE;
	}

private:
	T* Data = nullptr;
	int32 ArrayNum = 0;
};

template<typename T>
TArrayView<T> MakeArrayView(T* Data, int32 Count)
{
	return TArrayView<T>(Data, Count);
}

template<typename RangeType>
requires requires(RangeType& Range)
{
	Range.GetData();
	Range.Num();
}
auto MakeArrayView(RangeType&& Range)
{
	return TArrayView<std::remove_pointer_t<decltype(Range.GetData())>>(
		Range.GetData(), static_cast<int32>(Range.Num()));
}

template<typename T, SIZE_T Count>
TArrayView<T> MakeArrayView(T (&Array)[Count])
{
	return TArrayView<T>(Array);
}

template<typename T>
TConstArrayView<T> MakeArrayView(std::initializer_list<T> List)
{
	return TConstArrayView<T>(List.begin(), static_cast<int32>(List.size()));
}

template<typename T>
TConstArrayView<T> MakeConstArrayView(const T* Data, int32 Count)
{
	return TConstArrayView<T>(Data, Count);
}

template<typename RangeType>
requires requires(const RangeType& Range)
{
	Range.GetData();
	Range.Num();
}
auto MakeConstArrayView(const RangeType& Range)
{
	return TArrayView<std::remove_pointer_t<decltype(Range.GetData())>>(
		Range.GetData(), static_cast<int32>(Range.Num()));
}
