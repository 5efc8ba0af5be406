// TMap, TSet, TBitArray and TStaticArray do what containers of the standard library do, over random operations. The
// seeds are fixed, and a failure prints its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "ContainersTestHelpers.h"
#include "CoreMinimal.h"

TEST(ContainersModel, Map)
{
	for (uint32 Seed = 1; Seed <= ModelSeeds; ++Seed)
	{
		SCOPED_TRACE("seed " + std::to_string(Seed));
		TModelRandom<FString> Random(Seed);
		TMap<FString, int32> Map;
		std::vector<std::pair<FString, int32>> Model;
		const auto FindInModel = [&Model](const FString& Key)
		{
			return std::find_if(Model.begin(), Model.end(), [&Key](const auto& Pair) { return Pair.first == Key; });
		};
		for (int32 Step = 0; Step < ModelSteps && !HasFailure(); ++Step)
		{
			const FString Key = TModelRandom<FString>::Make(Random.Below(30));
			const int32 Value = Random.Below(5);
			auto Found = FindInModel(Key);
			const bool bFound = Found != Model.end();
			const auto SetInModel = [&](bool bReplace)
			{
				if (!bFound)
				{
					Model.emplace_back(Key, Value);
				}
				else if (bReplace)
				{
					Found->second = Value;
				}
			};
			switch (Random.Below(9))
			{
			case 0:
				EXPECT_EQ(Value, Map.Add(Key, Value));
				SetInModel(true);
				break;
			case 1:
				Map.Add(Key) = Value;
				SetInModel(true);
				break;
			case 2:
				EXPECT_EQ(Value, Map.Emplace(Key, Value));
				SetInModel(true);
				break;
			case 3:
				EXPECT_EQ(bFound ? Found->second : Value, Map.FindOrAdd(Key, Value));
				SetInModel(false);
				break;
			case 4:
				Map.FindOrAdd(Key) = Value;
				SetInModel(true);
				break;
			case 5:
				EXPECT_EQ(bFound ? 1 : 0, Map.Remove(Key));
				std::erase_if(Model, [&Key](const auto& Pair) { return Pair.first == Key; });
				break;
			case 6:
			{
				int32 Removed = -1;
				EXPECT_EQ(bFound, Map.RemoveAndCopyValue(Key, Removed));
				EXPECT_EQ(bFound ? Found->second : -1, Removed);
				std::erase_if(Model, [&Key](const auto& Pair) { return Pair.first == Key; });
				break;
			}
			case 7:
				Map.Append(Map);
				Map.KeySort([](const FString& A, const FString& B) { return A < B; });
				std::stable_sort(
					Model.begin(), Model.end(), [](const auto& A, const auto& B) { return A.first < B.first; });
				break;
			default:
				Map.ValueSort([](int32 A, int32 B) { return A < B; });
				std::stable_sort(
					Model.begin(), Model.end(), [](const auto& A, const auto& B) { return A.second < B.second; });
			}
			Found = FindInModel(Key);
			EXPECT_EQ(Found != Model.end(), Map.Contains(Key));
			EXPECT_EQ(Found != Model.end() ? Found->second : 0, Map.FindRef(Key));
			EXPECT_EQ(Found != Model.end(), Map.Find(Key) != nullptr);
			ASSERT_EQ(static_cast<int32>(Model.size()), Map.Num());
			TArray<FString> Keys;
			TArray<int32> Values;
			EXPECT_EQ(Map.Num(), Map.GetKeys(Keys));
			Map.GenerateValueArray(Values);
			for (int32 Index = 0; Index < Map.Num(); ++Index)
			{
				EXPECT_EQ(Model[Index].first, Keys[Index]);
				EXPECT_EQ(Model[Index].second, Values[Index]);
				EXPECT_EQ(Values[Index], Map.FindChecked(Keys[Index]));
			}
		}
	}
}

TEST(ContainersModel, Set)
{
	for (uint32 Seed = 1; Seed <= ModelSeeds; ++Seed)
	{
		SCOPED_TRACE("seed " + std::to_string(Seed));
		TModelRandom<FString> Random(Seed);
		TSet<FString> Set;
		std::set<FString> Model;
		for (int32 Step = 0; Step < ModelSteps && !HasFailure(); ++Step)
		{
			const FString Element = TModelRandom<FString>::Make(Random.Below(30));
			const bool bFound = Model.count(Element) != 0;
			switch (Random.Below(4))
			{
			case 0:
			{
				bool bThere = !bFound;
				Set.Add(Element, &bThere);
				EXPECT_EQ(bFound, bThere);
				Model.insert(Element);
				break;
			}
			case 1:
				Set.Append(TArray<FString>{Element, TModelRandom<FString>::Make(1)});
				Model.insert({Element, TModelRandom<FString>::Make(1)});
				break;
			case 2:
				EXPECT_EQ(bFound ? 1 : 0, Set.Remove(Element));
				Model.erase(Element);
				break;
			default:
				Set.Emplace(Element);
				Set.Sort([](const FString& A, const FString& B) { return A < B; });
				Model.insert(Element);
				EXPECT_TRUE(std::equal(Model.begin(), Model.end(), Set.begin(), Set.end()));
			}
			ASSERT_EQ(static_cast<int32>(Model.size()), Set.Num());
			EXPECT_EQ(Model.count(Element) != 0, Set.Contains(Element));
			EXPECT_EQ(Model.count(Element) != 0, Set.Find(Element) != nullptr);
			TSet<FString> Other{Element, TModelRandom<FString>::Make(2)};
			std::set<FString> Both, Without;
			for (const FString& Text : Model)
			{
				(Other.Contains(Text) ? Both : Without).insert(Text);
			}
			EXPECT_EQ(static_cast<int32>(Both.size()), Set.Intersect(Other).Num());
			EXPECT_EQ(static_cast<int32>(Without.size()), Set.Difference(Other).Num());
			EXPECT_EQ(static_cast<int32>(Without.size()) + Other.Num(), Set.Union(Other).Num());
			EXPECT_EQ(Both.size() == static_cast<size_t>(Other.Num()), Set.Includes(Other));
		}
	}
}

TEST(ContainersModel, BitArray)
{
	for (uint32 Seed = 1; Seed <= ModelSeeds; ++Seed)
	{
		SCOPED_TRACE("seed " + std::to_string(Seed));
		TModelRandom<bool> Random(Seed);
		TBitArray<> Bits;
		std::vector<char> Model;
		for (int32 Step = 0; Step < ModelSteps && !HasFailure(); ++Step)
		{
			const bool bValue = Random.Element();
			const int32 Index = Model.empty() ? 0 : Random.Below(Bits.Num());
			const int32 Before = Bits.Num();
			switch (Random.Below(6))
			{
			case 0:
				EXPECT_EQ(Before, Bits.Add(bValue));
				Model.push_back(bValue);
				break;
			case 1:
				EXPECT_EQ(Before, Bits.Add(bValue, 5));
				Model.insert(Model.end(), 5, bValue);
				break;
			case 2:
				Bits.SetNum(Index, bValue);
				Model.resize(Index, bValue);
				break;
			case 3:
				Bits.SetRange(Index, Bits.Num() - Index, bValue);
				std::fill(Model.begin() + Index, Model.end(), bValue);
				break;
			case 4:
				Bits.Init(bValue, Index + 3);
				Model.assign(Index + 3, bValue);
				break;
			default:
				if (!Model.empty())
				{
					Bits[Index] = bValue;
					Model[Index] = bValue;
				}
			}
			ASSERT_EQ(static_cast<int32>(Model.size()), Bits.Num());
			for (int32 Bit = 0; Bit < Bits.Num(); ++Bit)
			{
				EXPECT_EQ(Model[Bit] != 0, Bits[Bit]);
			}
			EXPECT_EQ(std::count(Model.begin(), Model.end(), 1), Bits.CountSetBits());
			const auto Found = std::find(Model.begin(), Model.end(), static_cast<char>(bValue));
			EXPECT_EQ(Found == Model.end() ? INDEX_NONE : static_cast<int32>(Found - Model.begin()), Bits.Find(bValue));
			EXPECT_EQ(Found != Model.end(), Bits.Contains(bValue));
		}
	}
}

TEST(ContainersModel, StaticArray)
{
	TStaticArray<int32, 5> Array(3);
	std::array<int32, 5> Model = {3, 3, 3, 3, 3};
	TModelRandom<int32> Random(1);
	for (int32 Step = 0; Step < ModelSteps; ++Step)
	{
		const int32 Index = Random.Below(5);
		Array[Index] = Model[Index] = Random.Element();
		EXPECT_TRUE(std::equal(Model.begin(), Model.end(), Array.begin(), Array.end()));
		EXPECT_EQ(Array.GetData() + 5, Array.end());
	}
	EXPECT_EQ(5, (TStaticArray<int32, 5>::Num()));
	EXPECT_TRUE((TStaticArray<int32, 2>(4, 6) == TStaticArray<int32, 2>(4, 6)));
}
