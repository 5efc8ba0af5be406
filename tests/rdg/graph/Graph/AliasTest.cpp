// The placement of transient resources in one heap.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "RenderGraphAlias.h"

#include <algorithm>
#include <random>

using namespace Drydock;
using testing::ElementsAre;

TEST(Alias, NothingTakesNoMemory)
{
	EXPECT_EQ(0u, PlaceInHeap({}).PeakBytes);
}

TEST(Alias, ResourcesThatLiveTogetherLieApart)
{
	const FRDGHeapLayout Layout = PlaceInHeap({{256, 1, 3}, {512, 2, 4}});
	EXPECT_THAT(Layout.Offsets, ElementsAre(0, 256));
	EXPECT_EQ(768u, Layout.PeakBytes);
}

TEST(Alias, ResourcesThatNeverMeetShareTheirPlace)
{
	const FRDGHeapLayout Layout = PlaceInHeap({{256, 1, 2}, {512, 3, 4}});
	EXPECT_THAT(Layout.Offsets, ElementsAre(0, 0));
	EXPECT_EQ(512u, Layout.PeakBytes);
	EXPECT_EQ(768u, Layout.WithoutAliasingBytes);
}

TEST(Alias, ALastPassIsHeldToItsEnd)
{
	EXPECT_THAT(PlaceInHeap({{256, 1, 2}, {256, 2, 3}}).Offsets, ElementsAre(0, 256));
}

TEST(Alias, ThePingPongOfAChainNeedsTwoPlaces)
{
	const FRDGHeapLayout Layout = PlaceInHeap({{256, 1, 2}, {256, 2, 3}, {256, 3, 4}, {256, 4, 5}});
	EXPECT_THAT(Layout.Offsets, ElementsAre(0, 256, 0, 256));
	EXPECT_EQ(512u, Layout.PeakBytes);
}

TEST(Alias, TheLowestGapThatFitsIsTaken)
{
	// A at 0, B at 256, C at 512; B ends, D (256 bytes) goes where B was, E (512) does not fit there.
	EXPECT_THAT(PlaceInHeap({{256, 1, 9}, {256, 1, 2}, {256, 1, 9}, {256, 3, 9}, {512, 4, 9}}).Offsets,
		ElementsAre(0, 256, 512, 256, 768));
}

TEST(Alias, OffsetsAreAligned)
{
	EXPECT_THAT(PlaceInHeap({{1, 1, 2}, {65, 1, 2}, {1, 1, 2}}).Offsets, ElementsAre(0, 64, 192));
}

TEST(Alias, WhatIsNotInTheHeapTakesNoPlace)
{
	const FRDGHeapLayout Layout = PlaceInHeap({{256, -1, -1}, {256, 1, 2}});
	EXPECT_THAT(Layout.Offsets, ElementsAre(-1, 0));
	EXPECT_EQ(256u, Layout.WithoutAliasingBytes);
}

TEST(Alias, TheOrderOfRequestsDoesNotMatterForLaterPasses)
{
	EXPECT_THAT(PlaceInHeap({{256, 3, 4}, {256, 1, 2}}).Offsets, ElementsAre(0, 0));
}

namespace
{

std::vector<FRDGHeapRequest> MakeRandomRequests()
{
	std::vector<FRDGHeapRequest> Requests(*rc::gen::inRange<size_t>(0, 40));
	for (FRDGHeapRequest& Request : Requests)
	{
		Request.Bytes = *rc::gen::inRange<uint64_t>(1, 2000);
		Request.First = *rc::gen::inRange(-1, 20);
		Request.Last = Request.First + *rc::gen::inRange(0, 6);
	}
	return Requests;
}

} // namespace

RC_GTEST_PROP(AliasProperty, WhatLivesTogetherNeverOverlaps, ())
{
	const std::vector<FRDGHeapRequest> Requests = MakeRandomRequests();
	const FRDGHeapLayout Layout = PlaceInHeap(Requests);
	for (size_t A = 0; A < Requests.size(); ++A)
	{
		for (size_t B = A + 1; B < Requests.size(); ++B)
		{
			if (Requests[A].First < 0 || Requests[B].First < 0)
			{
				continue;
			}
			const bool bMeet = Requests[A].First <= Requests[B].Last && Requests[B].First <= Requests[A].Last;
			const bool bOverlap = uint64_t(Layout.Offsets[A]) < uint64_t(Layout.Offsets[B]) + Requests[B].Bytes &&
								  uint64_t(Layout.Offsets[B]) < uint64_t(Layout.Offsets[A]) + Requests[A].Bytes;
			RC_ASSERT(!(bMeet && bOverlap));
		}
	}
}

RC_GTEST_PROP(AliasProperty, TheHeapHoldsEverythingAndIsNeverLargerThanWithoutAliasing, ())
{
	const std::vector<FRDGHeapRequest> Requests = MakeRandomRequests();
	const FRDGHeapLayout Layout = PlaceInHeap(Requests);
	RC_ASSERT(Layout.PeakBytes <= Layout.WithoutAliasingBytes);
	for (size_t Index = 0; Index < Requests.size(); ++Index)
	{
		RC_ASSERT((Requests[Index].First < 0) == (Layout.Offsets[Index] < 0));
		RC_ASSERT(
			Requests[Index].First < 0 || uint64_t(Layout.Offsets[Index]) + Requests[Index].Bytes <= Layout.PeakBytes);
	}
}

RC_GTEST_PROP(AliasProperty, TheHeapIsAtLeastWhatTheFullestPassHolds, ())
{
	const std::vector<FRDGHeapRequest> Requests = MakeRandomRequests();
	const FRDGHeapLayout Layout = PlaceInHeap(Requests);
	for (int32_t Pass = 0; Pass < 26; ++Pass)
	{
		uint64_t Held = 0;
		for (const FRDGHeapRequest& Request : Requests)
		{
			Held += Request.First >= 0 && Request.First <= Pass && Pass <= Request.Last ? Request.Bytes : 0;
		}
		RC_ASSERT(Held <= Layout.PeakBytes);
	}
}

RC_GTEST_PROP(AliasProperty, EachLiesAtTheLowestPlaceThatIsFree, ())
{
	// A map of the heap, one entry to 64 bytes, for each request anew: no gaps to keep track of.
	const std::vector<FRDGHeapRequest> Requests = MakeRandomRequests();
	const FRDGHeapLayout Layout = PlaceInHeap(Requests);
	const auto Blocks = [](const FRDGHeapRequest& Request)
	{
		return size_t(Request.Bytes + 63) / 64;
	};
	std::vector<size_t> Placed;
	for (int32_t First = 0; First < 20; ++First)
	{
		for (size_t Index = 0; Index < Requests.size(); ++Index)
		{
			if (Requests[Index].First != First)
			{
				continue;
			}
			std::vector<bool> bUsed(4000, false);
			for (const size_t Other : Placed)
			{
				for (size_t Block = 0; Requests[Other].Last >= First && Block < Blocks(Requests[Other]); ++Block)
				{
					bUsed[size_t(Layout.Offsets[Other]) / 64 + Block] = true;
				}
			}
			size_t Begin = 0;
			for (size_t Room = 0; Room < Blocks(Requests[Index]); ++Room)
			{
				if (bUsed[Begin + Room])
				{
					Begin += Room + 1;
					Room = size_t(-1);
				}
			}
			RC_ASSERT(size_t(Layout.Offsets[Index]) == 64 * Begin);
			Placed.push_back(Index);
		}
	}
}

TEST(Alias, ManyRandomRequestsLieWhereAPlainFirstFitPutsThem)
{
	for (uint32_t Seed = 0; Seed < 6; ++Seed)
	{
		std::mt19937 Random(Seed);
		const int32_t NumPasses = 1500;
		const uint32_t Longest = Seed % 2 == 0 ? 20 : 1500; // short lives, and such that make many gaps
		std::vector<FRDGHeapRequest> Requests;
		for (int32_t Pass = 0; Pass < NumPasses; ++Pass)
		{
			const uint64_t Bytes = Seed < 2 ? 64 * (1 + Random() % 8) : 1 + Random() % 100'000;
			Requests.push_back({Bytes, Pass, Pass + int32_t(Random() % Longest)});
		}
		const FRDGHeapLayout Layout = PlaceInHeap(Requests);

		struct FBlock
		{
			uint64_t Begin;
			uint64_t End;
			int32_t Last;
		};
		std::vector<FBlock> Blocks; // alive, by place
		uint64_t Peak = 0;
		for (size_t Index = 0; Index < Requests.size(); ++Index)
		{
			const FRDGHeapRequest& Request = Requests[Index];
			std::erase_if(Blocks, [&](const FBlock& Block) { return Block.Last < Request.First; });
			const uint64_t Bytes = (Request.Bytes + 63) / 64 * 64;
			uint64_t Begin = 0;
			size_t Place = 0;
			while (Place < Blocks.size() && Blocks[Place].Begin < Begin + Bytes)
			{
				Begin = Blocks[Place++].End;
			}
			Blocks.insert(Blocks.begin() + std::ptrdiff_t(Place), FBlock{Begin, Begin + Bytes, Request.Last});
			Peak = std::max(Peak, Begin + Bytes);
			ASSERT_EQ(Begin, uint64_t(Layout.Offsets[Index])) << "seed " << Seed << ", request " << Index;
		}
		EXPECT_EQ(Peak, Layout.PeakBytes) << "seed " << Seed;
	}
}
