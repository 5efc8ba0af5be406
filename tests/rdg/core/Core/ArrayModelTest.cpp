// Every method of TArray does what the same method of a container of the standard library does, over random operations.
// The seeds are fixed, and a failure prints its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <vector>

#include "ContainersTestHelpers.h"
#include "CoreMinimal.h"

namespace
{

template<typename T>
class TArrayModel
{
public:
	explicit TArrayModel(uint32 Seed)
		: Random(Seed)
	{
	}

	void Step()
	{
		const T Element = Random.Element();
		const int32 Index = Model.empty() ? 0 : Random.Below(Array.Num());
		const auto At = [this](int32 Place)
		{
			return Model.begin() + Place;
		};
		const auto IsElement = [&Element](const T& Other)
		{
			return Other == Element;
		};
		// An element of the array itself, where there is one: a growing array must not lose it.
		const T& Own = Model.empty() ? Element : Array[Index];
		const T OwnCopy = Own;
		const int32 Before = Array.Num();
		switch (Random.Below(34))
		{
		case 0:
			EXPECT_EQ(Before, Array.Add(Own));
			Model.push_back(OwnCopy);
			break;
		case 1:
			Array.Add_GetRef(Own) = Element;
			Model.push_back(Element);
			break;
		case 2:
			Array.Add_GetRef(T(Element)) = OwnCopy;
			Model.push_back(OwnCopy);
			break;
		case 3:
			Array.Emplace_GetRef(OwnCopy) = Element;
			Model.push_back(Element);
			break;
		case 4:
			EXPECT_EQ(T(), Array.AddDefaulted_GetRef());
			Array.Last() = Element;
			Model.push_back(Element);
			break;
		case 5:
			Array.AddDefaulted_GetRef() = Element;
			Model.push_back(Element);
			break;
		case 6:
			Array.AddZeroed_GetRef() = Element;
			Model.push_back(Element);
			break;
		case 7:
			EXPECT_EQ(Before, Array.Emplace(Own));
			Model.push_back(OwnCopy);
			break;
		case 8:
		{
			const auto Found = std::find(Model.begin(), Model.end(), Element);
			const int32 Place = static_cast<int32>(Found - Model.begin());
			EXPECT_EQ(Place, Array.AddUnique(Element));
			Model.resize(std::max(static_cast<int32>(Model.size()), Place + 1), Element);
			break;
		}
		case 9:
			EXPECT_EQ(Before, Array.AddDefaulted(Index % 3));
			Model.resize(Model.size() + Index % 3);
			break;
		case 10:
			EXPECT_EQ(Before, Array.AddZeroed(2));
			Model.resize(Model.size() + 2);
			break;
		case 11:
		{
			Array.Append(Array);
			const std::deque<T> Copy = Model;
			Model.insert(Model.end(), Copy.begin(), Copy.end());
			Halve();
			break;
		}
		case 12:
			Array.Append({Element, OwnCopy});
			Model.insert(Model.end(), {Element, OwnCopy});
			break;
		case 13:
		{
			const std::vector<FBox> Others(3, FBox{Element});
			Array.Append(&Others[0].Value, 3);
			Model.insert(Model.end(), 3, Element);
			break;
		}
		case 14:
			Array += TArray<T>{Element, Element};
			Model.insert(Model.end(), 2, Element);
			break;
		case 15:
			EXPECT_EQ(Index, Array.Insert(Own, Index));
			Model.insert(At(Index), OwnCopy);
			break;
		case 16:
			EXPECT_EQ(Index, Array.Insert({Element, OwnCopy}, Index));
			Model.insert(At(Index), {Element, OwnCopy});
			break;
		case 17:
			Array.EmplaceAt(Index, Element);
			Model.insert(At(Index), Element);
			break;
		case 18:
			if (!Model.empty())
			{
				const int32 Count = Random.Below(Array.Num() - Index + 1);
				Array.RemoveAt(Index, Count);
				Model.erase(At(Index), At(Index + Count));
			}
			break;
		case 19:
			if (!Model.empty())
			{
				Array.RemoveAtSwap(Index);
				Model[Index] = Model.back();
				Model.pop_back();
			}
			break;
		case 20:
			EXPECT_EQ(std::count(Model.begin(), Model.end(), OwnCopy), Array.Remove(Own));
			std::erase(Model, OwnCopy);
			break;
		case 21:
		{
			const auto Found = std::find(Model.begin(), Model.end(), Element);
			const bool bFound = Found != Model.end();
			EXPECT_EQ(bFound ? 1 : 0, Array.RemoveSingle(Element));
			if (bFound)
			{
				Model.erase(Found);
			}
			break;
		}
		case 22:
			EXPECT_EQ(std::count_if(Model.begin(), Model.end(), IsElement), Array.RemoveAll(IsElement));
			std::erase_if(Model, IsElement);
			break;
		case 23:
			EXPECT_EQ(std::count(Model.begin(), Model.end(), Element), Array.RemoveSwap(Element));
			std::erase(Model, Element);
			break;
		case 24:
		{
			const auto Found = std::find(Model.begin(), Model.end(), Element);
			const bool bFound = Found != Model.end();
			EXPECT_EQ(bFound ? 1 : 0, Array.RemoveSingleSwap(Element));
			if (bFound)
			{
				*Found = T(Model.back());
				Model.pop_back();
			}
			break;
		}
		case 25:
			if (!Model.empty())
			{
				EXPECT_EQ(Model.back(), Array.Pop());
				Model.pop_back();
			}
			break;
		case 26:
			Array.SetNum(Index);
			Model.resize(Index);
			break;
		case 27:
			Array.SetNumZeroed(Array.Num() + 3);
			Model.resize(Model.size() + 3);
			break;
		case 28:
			Array.Init(Own, 1 + Index);
			Model.assign(1 + Index, OwnCopy);
			break;
		case 29:
			if (!Model.empty())
			{
				Array.Swap(0, Index);
				std::swap(Model[0], Model[Index]);
			}
			break;
		case 30:
			Array.Sort();
			std::stable_sort(Model.begin(), Model.end());
			break;
		case 31:
			Array.Sort([](const T& A, const T& B) { return B < A; });
			std::stable_sort(Model.begin(), Model.end(), [](const T& A, const T& B) { return B < A; });
			break;
		case 32:
			Array.Reserve(Array.Num() + Index);
			Array.Shrink();
			EXPECT_LE(0, Array.GetSlack());
			break;
		default:
			if (Random.Below(8) == 0)
			{
				Random.Below(2) == 0 ? Array.Empty() : Array.Reset();
				Model.clear();
			}
		}
	}

	void Compare()
	{
		ASSERT_EQ(static_cast<int32>(Model.size()), Array.Num());
		EXPECT_EQ(Model.empty(), Array.IsEmpty());
		ASSERT_TRUE(std::equal(Model.begin(), Model.end(), Array.begin(), Array.end()));
		const T Element = Random.Element();
		const auto IsElement = [&Element](const T& Other)
		{
			return Other == Element;
		};
		const auto First = std::find(Model.begin(), Model.end(), Element);
		const bool bFound = First != Model.end();
		const int32 FirstIndex = bFound ? static_cast<int32>(First - Model.begin()) : INDEX_NONE;
		const auto Last = std::find(Model.rbegin(), Model.rend(), Element);
		const int32 LastIndex = static_cast<int32>(Model.rend() - Last) - 1;
		EXPECT_EQ(FirstIndex, Array.Find(Element));
		int32 OutIndex = 0;
		EXPECT_EQ(bFound, Array.Find(Element, OutIndex));
		EXPECT_EQ(FirstIndex, OutIndex);
		EXPECT_EQ(LastIndex, Array.FindLast(Element));
		EXPECT_EQ(LastIndex, Array.FindLastByPredicate(IsElement));
		EXPECT_EQ(FirstIndex, Array.IndexOfByKey(Element));
		EXPECT_EQ(FirstIndex, Array.IndexOfByPredicate(IsElement));
		EXPECT_EQ(bFound ? &Array[FirstIndex] : nullptr, Array.FindByKey(Element));
		EXPECT_EQ(bFound ? &Array[FirstIndex] : nullptr, Array.FindByPredicate(IsElement));
		EXPECT_EQ(bFound, Array.Contains(Element));
		EXPECT_EQ(bFound, Array.ContainsByPredicate(IsElement));
		EXPECT_EQ(std::count(Model.begin(), Model.end(), Element), Array.FilterByPredicate(IsElement).Num());
		EXPECT_FALSE(Array.IsValidIndex(Array.Num()));
		if (!Model.empty())
		{
			EXPECT_EQ(Model.back(), Array.Last());
			EXPECT_EQ(Model.front(), Array.Last(Array.Num() - 1));
			EXPECT_EQ(Model.back(), Array.Top());
		}
		TArray<T> Copy(Array);
		EXPECT_EQ(Array, Copy);
		TArray<T> Moved(MoveTemp(Copy));
		EXPECT_EQ(Array, Moved);
		EXPECT_EQ(Array, TArray<T>(Array.GetData(), Array.Num()));
		EXPECT_EQ(Array, TArray<T>(MakeArrayView(Array)));
	}

private:
	/** An element with an address, for bool too. */
	struct FBox
	{
		T Value;
	};
	static_assert(sizeof(FBox) == sizeof(T));

	void Halve()
	{
		if (Array.Num() > 64)
		{
			Array.SetNum(8);
			Model.resize(8);
		}
	}

	TModelRandom<T> Random;
	TArray<T> Array;
	std::deque<T> Model; // not a vector, so that bool has addresses
};

template<typename T>
void CheckArrayAgainstModel()
{
	for (uint32 Seed = 1; Seed <= ModelSeeds; ++Seed)
	{
		SCOPED_TRACE("seed " + std::to_string(Seed));
		TArrayModel<T> Model(Seed);
		for (int32 Step = 0; Step < ModelSteps && !testing::Test::HasFailure(); ++Step)
		{
			Model.Step();
			Model.Compare();
		}
	}
}

} // namespace

TEST(ArrayModel, OfNumbers)
{
	CheckArrayAgainstModel<int32>();
}

TEST(ArrayModel, OfBools)
{
	CheckArrayAgainstModel<bool>();
}

TEST(ArrayModel, OfTexts)
{
	CheckArrayAgainstModel<FString>();
}

// The array of each of these was null, or had moved, when the reference was made.
TEST(ArrayModel, ReferencesToNewElementsAreNotStale)
{
	TArray<int32> Array;
	Array.Add_GetRef(3) = 5;
	for (int32 Index = 1; Index < 100; ++Index)
	{
		int32& Added = Array.Add_GetRef(0);
		Added = Index;
		int32& Emplaced = Array.Emplace_GetRef(0);
		Emplaced = Index;
		Array.AddDefaulted_GetRef() = Index;
		Array.AddZeroed_GetRef() = Index;
	}
	ASSERT_EQ(397, Array.Num());
	EXPECT_EQ(5, Array[0]);
	for (int32 Index = 1; Index < Array.Num(); ++Index)
	{
		EXPECT_EQ((Index + 3) / 4, Array[Index]);
	}
}

TEST(ArrayModel, ZeroedIsZeroWhateverTheDefault)
{
	struct FWithDefault
	{
		int32 Value = 7;
	};
	TArray<FWithDefault> Array;
	EXPECT_EQ(7, Array.AddDefaulted_GetRef().Value);
	EXPECT_EQ(0, Array.AddZeroed_GetRef().Value);
	Array.SetNumZeroed(4);
	EXPECT_EQ(7, Array[0].Value);
	EXPECT_EQ(0, Array[3].Value);
	Array.SetNumZeroed(1);
	EXPECT_EQ(1, Array.Num());
}
