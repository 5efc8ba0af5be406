// TBitArray: a bit per index. Source: engine Containers/BitArray.h.
#pragma once

#include "Containers/ContainersFwd.h"
#include "Misc/AssertionMacros.h"

#include <algorithm>
#include <vector>

template<typename Allocator = FDefaultAllocator>
class TBitArray
{
public:
	TBitArray() = default;
	TBitArray(bool Value, int32 Count)
		: Bits(Count, Value)
	{
	}

	int32 Num() const { return static_cast<int32>(Bits.size()); }
	bool IsEmpty() const { return Bits.empty(); }
	bool IsValidIndex(int32 Index) const { return Index >= 0 && Index < Num(); }
	void Init(bool Value, int32 Count) { Bits.assign(Count, Value); }
	void Empty(int32 Slack = 0)
	{
		Bits.clear();
		Bits.reserve(Slack);
	}
	void Reset() { Bits.clear(); }
	int32 Add(bool Value)
	{
		Bits.push_back(Value);
		return Num() - 1;
	}
	int32 Add(bool Value, int32 Count)
	{
		Bits.resize(Bits.size() + Count, Value);
		return Num() - Count;
	}
	void SetNum(int32 Count, bool Value) { Bits.resize(Count, Value); }
	void SetRange(int32 Index, int32 Count, bool Value)
	{
		check(Index >= 0 && Count >= 0 && Index + Count <= Num());
		std::fill_n(Bits.begin() + Index, Count, Value);
	}

	typename std::vector<bool>::reference operator[](int32 Index)
	{
		CheckIndex(Index);
		return Bits[Index];
	}
	bool operator[](int32 Index) const
	{
		CheckIndex(Index);
		return Bits[Index];
	}
	/** Index of the first bit that is Value, or INDEX_NONE. */
	int32 Find(bool Value) const
	{
		const auto Found = std::find(Bits.begin(), Bits.end(), Value);
		return Found == Bits.end() ? INDEX_NONE : static_cast<int32>(Found - Bits.begin());
	}
	bool Contains(bool Value) const { return Find(Value) != INDEX_NONE; }
	int32 CountSetBits() const { return static_cast<int32>(std::count(Bits.begin(), Bits.end(), true)); }
	bool operator==(const TBitArray& Other) const { return Bits == Other.Bits; }

private:
	void CheckIndex(int32 Index) const
	{
		checkf(IsValidIndex(Index), "Bit index out of bounds: %d into %d bits", Index, Num());
	}

	std::vector<bool> Bits;
};
