// TArray, TArrayView, TStaticArray, TMap, TSet and TBitArray behave as the engine's.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <set>

#include "CoreMinimal.h"

TEST(Array, AddReturnsTheIndex)
{
	TArray<int32> Array;
	EXPECT_EQ(0, Array.Add(7));
	EXPECT_EQ(1, Array.Add(8));
	EXPECT_EQ((TArray<int32>{7, 8}), Array);
}

TEST(Array, IteratorsGoByIndexAndMayRemove)
{
	TArray<int32> Array{4, 5, 6, 7};
	for (auto It = Array.CreateIterator(); It; ++It)
	{
		if (*It % 2 != 0)
		{
			It.RemoveCurrent();
			continue;
		}
		*It += 10 * It.GetIndex();
	}
	EXPECT_EQ((TArray<int32>{4, 16}), Array);
	int32 Sum = 0;
	const TArray<int32>& Const = Array;
	for (TArray<int32>::TConstIterator It = Const.CreateConstIterator(); It; ++It)
	{
		Sum += *It;
	}
	EXPECT_EQ(20, Sum);
}

TEST(Array, IndexOutsideFails)
{
	TArray<int32> Array{1, 2};
	EXPECT_EQ(2, Array[1]);
	EXPECT_THROW(Array[2], Drydock::FCheckFailure);
	EXPECT_THROW(Array[-1], Drydock::FCheckFailure);
	EXPECT_THROW(TArray<int32>().Last(), Drydock::FCheckFailure);
}

TEST(Array, BoolsHaveAddresses)
{
	TArray<bool> Array{true, false};
	for (bool& bValue : Array)
	{
		bValue = !bValue;
	}
	EXPECT_EQ(1u, sizeof(*Array.GetData()));
	EXPECT_FALSE(Array[0]);
	EXPECT_TRUE(Array.GetData()[1]);
}

TEST(Array, UninitializedIsZero)
{
	TArray<int32> Array{5};
	Array.SetNumUninitialized(3);
	EXPECT_EQ((TArray<int32>{5, 0, 0}), Array);
}

TEST(Array, FindsByValueKeyAndPredicate)
{
	const TArray<FString> Array{"a", "b", "c"};
	EXPECT_EQ(1, Array.Find("b"));
	EXPECT_EQ(2, Array.IndexOfByPredicate([](const FString& Text) { return Text == "C"; }));
	EXPECT_EQ(nullptr, Array.FindByKey("x"));
	EXPECT_TRUE(Array.Contains(TEXT("a")));
}

TEST(Array, AddUniqueDoesNotRepeat)
{
	TArray<int32> Array{1, 2};
	EXPECT_EQ(0, Array.AddUnique(1));
	EXPECT_EQ(2, Array.AddUnique(3));
	EXPECT_EQ(3, Array.Num());
}

TEST(Array, RemovesAllEqualElements)
{
	TArray<int32> Array{1, 2, 1, 3};
	EXPECT_EQ(2, Array.Remove(1));
	EXPECT_EQ((TArray<int32>{2, 3}), Array);
}

TEST(Array, RemovesAnElementGivenByReferenceIntoItself)
{
	TArray<int32> Array{4, 4, 5};
	Array.Remove(Array[0]);
	EXPECT_EQ((TArray<int32>{5}), Array);
}

TEST(Array, RemoveAtSwapTakesTheLast)
{
	TArray<int32> Array{1, 2, 3};
	Array.RemoveAtSwap(0);
	EXPECT_EQ((TArray<int32>{3, 2}), Array);
	EXPECT_THROW(Array.RemoveAt(1, 2), Drydock::FCheckFailure);
}

TEST(Array, RemoveAtSwapOfTheLastKeepsOwnership)
{
	TArray<TUniquePtr<int32>> Array;
	Array.Add(MakeUnique<int32>(1));
	Array.RemoveAtSwap(0);
	EXPECT_EQ(0, Array.Num());
}

TEST(Array, AppendsItself)
{
	TArray<int32> Array{1, 2};
	Array.Append(Array);
	EXPECT_EQ((TArray<int32>{1, 2, 1, 2}), Array);
}

TEST(Array, SortsPointersByWhatTheyPointTo)
{
	int32 A = 3, B = 1, C = 2;
	TArray<int32*> Array{&A, &B, &C};
	Array.Sort([](const int32& X, const int32& Y) { return X < Y; });
	EXPECT_EQ((TArray<int32*>{&B, &C, &A}), Array);
}

TEST(Array, MovesBetweenAllocators)
{
	TArray<int32, TInlineAllocator<4>> Inline{1, 2};
	const TArray<int32> Plain = Inline;
	EXPECT_EQ((TArray<int32>{1, 2}), Plain);
	EXPECT_TRUE(Inline == Plain);
}

TEST(Array, HoldsMoveOnlyElements)
{
	TArray<TUniquePtr<int32>> Array;
	Array.Emplace(new int32(4));
	Array.Insert(MakeUnique<int32>(3), 0);
	EXPECT_EQ(4, *Array.Pop());
	EXPECT_EQ(3, *Array[0]);
}

TEST(Array, EmplacesAggregates)
{
	struct FPoint
	{
		int32 X;
		int32 Y;
	};
	TArray<FPoint> Array;
	Array.Emplace(1, 2);
	EXPECT_EQ(2, Array[0].Y);
}

TEST(ArrayView, SeesChangesOfTheArray)
{
	TArray<int32> Array{1, 2, 3};
	TArrayView<int32> View = Array;
	View[1] = 9;
	EXPECT_EQ(9, Array[1]);
	EXPECT_THROW(View[3], Drydock::FCheckFailure);
}

TEST(ArrayView, SlicesInsideOnly)
{
	const TArray<int32> Array{1, 2, 3, 4};
	const TConstArrayView<int32> View = MakeArrayView(Array);
	EXPECT_EQ((TArray<int32>{2, 3}), TArray<int32>(View.Slice(1, 2)));
	EXPECT_EQ(4, View.Right(1)[0]);
	EXPECT_THROW(View.Slice(3, 2), Drydock::FCheckFailure);
}

TEST(StaticArray, StartsZeroedAndChecksIndices)
{
	TStaticArray<int32, 3> Array;
	EXPECT_EQ(0, Array[2]);
	EXPECT_EQ(3, Array.Num());
	EXPECT_THROW(Array[3], Drydock::FCheckFailure);
}

TEST(Map, IteratesInTheOrderOfAdding)
{
	TMap<FString, int32> Map;
	Map.Add("z", 1);
	Map.Add("a", 2);
	Map.Add("m", 3);
	Map.Add("Z", 4);
	FString Order;
	for (const auto& Pair : Map)
	{
		Order += Pair.Key + FString::FromInt(Pair.Value);
	}
	EXPECT_STREQ("z4a2m3", *Order);
}

TEST(Map, FindGivesNullOrAPointer)
{
	TMap<int32, int32> Map{{1, 10}, {2, 20}};
	*Map.Find(2) = 21;
	EXPECT_EQ(21, Map[2]);
	EXPECT_EQ(nullptr, Map.Find(3));
	EXPECT_EQ(0, Map.FindRef(3));
	EXPECT_THROW(Map[3], Drydock::FCheckFailure);
}

TEST(Map, FindOrAddAddsADefault)
{
	TMap<FName, int32> Map;
	Map.FindOrAdd(TEXT("CoreTestKey")) += 2;
	Map.FindOrAdd(TEXT("coretestkey")) += 3;
	EXPECT_EQ(1, Map.Num());
	EXPECT_EQ(5, Map.FindChecked(TEXT("CoreTestKey")));
}

TEST(Map, RemovingKeepsTheOrder)
{
	TMap<int32, int32> Map{{3, 0}, {1, 0}, {2, 0}};
	EXPECT_EQ(1, Map.Remove(1));
	EXPECT_EQ(0, Map.Remove(1));
	TArray<int32> Keys;
	Map.GenerateKeyArray(Keys);
	EXPECT_EQ((TArray<int32>{3, 2}), Keys);
}

TEST(Map, BindsPairsByName)
{
	int32 Sum = 0;
	const TMap<int32, int32> Map{{1, 10}, {2, 20}};
	for (const auto& [Key, Value] : Map)
	{
		Sum += Key * Value;
	}
	EXPECT_EQ(50, Sum);
}

TEST(Map, SortsByKeyAndStillFinds)
{
	TMap<int32, FString> Map{{3, "c"}, {1, "a"}, {2, "b"}};
	Map.KeySort([](int32 A, int32 B) { return A < B; });
	EXPECT_EQ(1, Map.begin()->Key);
	EXPECT_STREQ("c", *Map[3]);
}

TEST(Map, BehavesAsAStandardMap)
{
	const bool bOk = (rc::check)(
		[](const std::vector<std::pair<int8_t, int>>& Steps)
		{
			TMap<int32, int32> Map;
			std::map<int32, int32> Model;
			for (const auto& [Key, Value] : Steps)
			{
				if (Value % 3 == 0)
				{
					RC_ASSERT(Map.Remove(Key) == static_cast<int32>(Model.erase(Key)));
				}
				else
				{
					Map.Add(Key, Value);
					Model[Key] = Value;
				}
			}
			RC_ASSERT(Map.Num() == static_cast<int32>(Model.size()));
			for (const auto& [Key, Value] : Model)
			{
				RC_ASSERT(Map.FindChecked(Key) == Value);
			}
		});
	EXPECT_TRUE(bOk);
}

TEST(Set, HoldsEachElementOnceInOrder)
{
	TSet<int32> Set{3, 1, 3};
	bool bThere = false;
	Set.Add(1, &bThere);
	EXPECT_TRUE(bThere);
	EXPECT_EQ((TArray<int32>{3, 1}), Set.Array());
}

TEST(Set, CombinesWithOthers)
{
	const TSet<int32> A{1, 2, 3};
	const TSet<int32> B{3, 4};
	EXPECT_EQ((TArray<int32>{1, 2, 3, 4}), A.Union(B).Array());
	EXPECT_EQ((TArray<int32>{3}), A.Intersect(B).Array());
	EXPECT_EQ((TArray<int32>{1, 2}), A.Difference(B).Array());
	EXPECT_FALSE(A.Includes(B));
}

TEST(BitArray, FindsAndCounts)
{
	TBitArray<> Bits(false, 70);
	Bits[65] = true;
	EXPECT_EQ(65, Bits.Find(true));
	EXPECT_EQ(1, Bits.CountSetBits());
	EXPECT_THROW(Bits[70], Drydock::FCheckFailure);
}
