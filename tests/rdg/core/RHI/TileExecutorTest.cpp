// The tile executor runs every thread once, in tiles, under the right denormal mode.
#include <atomic>
#include <chrono>
#include <limits>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "RHITestHelpers.h"
#include "TileExecutor.h"

using namespace Drydock;
using namespace Drydock::Tests;

namespace
{

const FKernelTile GWhole = {-3, 2, 0, 70, 41, 3};

std::vector<FKernelTile> CollectTiles(const FKernelTile& Whole, FIntVector TileSize)
{
	std::mutex Mutex;
	std::vector<FKernelTile> Tiles;
	ForEachTile(Whole, TileSize,
		[&](const FKernelTile& Tile)
		{
			const std::lock_guard Lock(Mutex);
			Tiles.push_back(Tile);
		});
	return Tiles;
}

/** volatile: the product must be computed now, under the present mode. */
float HalveSmallestNormal()
{
	volatile float Value = std::numeric_limits<float>::min();
	volatile float Half = 0.5f;
	return Value * Half;
}

class Threads : public testing::TestWithParam<int32>
{
	const FScopedCVar Scope{TEXT("r.Drydock.Threads"), GetParam()};
};

} // namespace

TEST_P(Threads, EveryPointIsCoveredOnce)
{
	std::vector<std::atomic<int32>> Hits(73 * 39 * 3);
	ForEachTile(GWhole, FIntPoint(16, 8),
		[&](const FKernelTile& Tile)
		{
			for (int32 Z = Tile.MinZ; Z < Tile.MaxZ; ++Z)
			{
				for (int32 Y = Tile.MinY; Y < Tile.MaxY; ++Y)
				{
					for (int32 X = Tile.MinX; X < Tile.MaxX; ++X)
					{
						++Hits[size_t((Z * 39 + Y - 2) * 73 + X + 3)];
					}
				}
			}
		});
	for (const std::atomic<int32>& Hit : Hits)
	{
		ASSERT_EQ(1, Hit);
	}
}

TEST_P(Threads, TheFirstTilesExceptionLeaves)
{
	for (int32 Repeat = 0; Repeat < 20; ++Repeat)
	{
		try
		{
			ForEachTile(FKernelTile{0, 0, 0, 64, 1, 1}, FIntPoint(1, 1),
				[](const FKernelTile& Tile)
				{
					if (Tile.MinX >= 5)
					{
						throw std::runtime_error(std::to_string(Tile.MinX));
					}
				});
			FAIL() << "nothing was thrown";
		}
		catch (const std::runtime_error& Error)
		{
			ASSERT_STREQ("5", Error.what());
		}
	}
}

TEST(TileExecutor, ALaterTilesExceptionDoesNotReplaceTheFirst)
{
	const FScopedCVar Scope(TEXT("r.Drydock.Threads"), 2);
	std::atomic<bool> bLaterRuns{false};
	std::atomic<bool> bFirstThrew{false};
	const auto Wait = [](const std::atomic<bool>& bFlag)
	{
		for (int32 Milliseconds = 0; Milliseconds < 1000 && !bFlag; ++Milliseconds)
		{
			std::this_thread::sleep_for(std::chrono::milliseconds(1));
		}
	};
	const auto Body = [&](const FKernelTile& Tile)
	{
		if (Tile.MinX == 0)
		{
			Wait(bLaterRuns);
			bFirstThrew = true;
			throw std::runtime_error("first");
		}
		bLaterRuns = true;
		Wait(bFirstThrew);
		std::this_thread::sleep_for(std::chrono::milliseconds(20)); // until the first exception has been recorded
		throw std::runtime_error("later");
	};
	try
	{
		ForEachTile(FKernelTile{0, 0, 0, 2, 1, 1}, FIntPoint(1, 1), Body);
		FAIL() << "nothing was thrown";
	}
	catch (const std::runtime_error& Error)
	{
		EXPECT_STREQ("first", Error.what());
	}
}

TEST_P(Threads, DenormalsAreFlushedInsideWhenAsked)
{
	std::atomic<int32> NumKept{0};
	const auto Count = [&](const FKernelTile&)
	{
		NumKept += HalveSmallestNormal() != 0;
	};
	ForEachTile(FKernelTile{0, 0, 0, 64, 1, 1}, FIntPoint(1, 1), Count, EDenormals::Flush);
	EXPECT_EQ(0, NumKept);
	ForEachTile(FKernelTile{0, 0, 0, 64, 1, 1}, FIntPoint(1, 1), Count, EDenormals::Keep);
	EXPECT_EQ(64, NumKept);
}

TEST_P(Threads, TheControlWordIsRestoredAlsoAfterAnException)
{
	const uint64 Before = FScopedDenormals::GetControlWord();
	EXPECT_THROW(ForEachTile(
					 FKernelTile{0, 0, 0, 64, 1, 1}, FIntPoint(1, 1),
					 [](const FKernelTile&) { throw std::runtime_error(""); }, EDenormals::Flush),
		std::runtime_error);
	EXPECT_EQ(Before, FScopedDenormals::GetControlWord());
	EXPECT_NE(0.0f, HalveSmallestNormal());
}

TEST_P(Threads, ANestedCallRunsOnItsOwnThread)
{
	std::atomic<int32> NumStrangers{0};
	std::atomic<int32> NumInner{0};
	ForEachTile(FKernelTile{0, 0, 0, 8, 1, 1}, FIntPoint(1, 1),
		[&](const FKernelTile&)
		{
			const std::thread::id Outer = std::this_thread::get_id();
			ForEachTile(FKernelTile{0, 0, 0, 8, 1, 1}, FIntPoint(1, 1),
				[&](const FKernelTile&)
				{
					++NumInner;
					NumStrangers += std::this_thread::get_id() != Outer;
				});
		});
	EXPECT_EQ(64, NumInner);
	EXPECT_EQ(0, NumStrangers);
}

INSTANTIATE_TEST_SUITE_P(Counts, Threads, testing::Values(1, 2, 7, 0));

TEST(TileExecutor, TilesAreNoLargerThanAskedAndStartAtTheMinimum)
{
	for (const FKernelTile& Tile : CollectTiles(GWhole, FIntVector(16, 8, 2)))
	{
		EXPECT_LE(Tile.MaxX - Tile.MinX, 16);
		EXPECT_LE(Tile.MaxY - Tile.MinY, 8);
		EXPECT_EQ(0, (Tile.MinX + 3) % 16);
		EXPECT_EQ(0, (Tile.MinY - 2) % 8);
	}
	EXPECT_EQ(size_t(5 * 5 * 2), CollectTiles(GWhole, FIntVector(16, 8, 2)).size());
}

TEST(TileExecutor, ANonPositiveSizeIsNotCut)
{
	EXPECT_EQ(size_t(5), CollectTiles(GWhole, FIntVector(0, 8, -1)).size());
}

TEST(TileExecutor, AnEmptyBoxRunsNothing)
{
	EXPECT_TRUE(CollectTiles(FKernelTile{0, 0, 0, 5, 0, 1}, FIntVector(4, 4, 1)).empty());
	EXPECT_TRUE(CollectTiles(FKernelTile{5, 0, 0, 3, 4, 1}, FIntVector(4, 4, 1)).empty());
}

TEST(TileExecutor, OneThreadIsTheCaller)
{
	const FScopedCVar Scope(TEXT("r.Drydock.Threads"), 1);
	std::set<std::thread::id> Ids;
	ForEachTile(FKernelTile{0, 0, 0, 64, 1, 1}, FIntPoint(1, 1),
		[&](const FKernelTile&) { Ids.insert(std::this_thread::get_id()); });
	EXPECT_EQ(std::set<std::thread::id>{std::this_thread::get_id()}, Ids);
}

TEST(TileExecutor, ThreadCountFollowsTheConsoleVariable)
{
	const FScopedCVar Seven(TEXT("r.Drydock.Threads"), 7);
	EXPECT_EQ(7, GetNumThreads());
	const FScopedCVar All(TEXT("r.Drydock.Threads"), 0);
	EXPECT_EQ(int32(std::max(1u, std::thread::hardware_concurrency())), GetNumThreads());
}

TEST(Denormals, ScopesNestAndRestore)
{
	{
		const FScopedDenormals Flush(EDenormals::Flush);
		EXPECT_EQ(0.0f, HalveSmallestNormal());
		{
			const FScopedDenormals Keep(EDenormals::Keep);
			EXPECT_NE(0.0f, HalveSmallestNormal());
		}
		EXPECT_EQ(0.0f, HalveSmallestNormal());
	}
	EXPECT_NE(0.0f, HalveSmallestNormal());
}

TEST(Denormals, TextureStoresKeepHalfDenormalsWhileFlushing)
{
	const FScopedDenormals Flush(EDenormals::Flush);
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(1, 1), PF_R16F);
	const float SmallestHalf = 5.9604645e-8f;
	Texture->WriteTexel(0, 0, FLinearColor(SmallestHalf, 0, 0, 0));
	EXPECT_EQ(SmallestHalf, Texture->ReadTexel(0, 0).R);
}
