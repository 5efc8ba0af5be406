// Cuts work into tiles, sets the denormal mode of each thread, and carries exceptions out.
#include "TileExecutor.h"

#include "FaultHandlers.h"
#include "HAL/IConsoleManager.h"
#include "ParallelFor.h"
#include "RunningCode.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

static TAutoConsoleVariable<int32> CVarDrydockThreads(TEXT("r.Drydock.Threads"), 0,
	TEXT("Number of threads that run passes. The result is the same bits for any number.\n")
		TEXT(" 0: all of the machine's (default)"));

namespace Drydock
{

namespace
{

#if defined(__x86_64__)
constexpr uint64 GFlushBits = 0x8040; // MXCSR: flush to zero, denormals are zero
#elif defined(__aarch64__)
constexpr uint64 GFlushBits = 1ull << 24; // FPCR: flush to zero, inputs and results
#else
constexpr uint64 GFlushBits = 0;
#endif

void SetControlWord(uint64 Word)
{
#if defined(__x86_64__)
	_mm_setcsr(uint32(Word));
#elif defined(__aarch64__)
	asm volatile("msr fpcr, %0" : : "r"(Word));
#else
	(void)Word;
#endif
}

/** More threads than this gain nothing and may exhaust the system. */
constexpr int32 GMaxThreads = 1024;

thread_local bool bInsideTile = false;

/** One ForEachTile at a time uses the workers; a second caller runs its tiles itself. */
std::mutex GExecutorMutex;

int32 CountTiles(int32 Size, int32 TileSize)
{
	return (Size + TileSize - 1) / TileSize;
}

/** The tiles of a box, numbered row by row, slice by slice. */
struct FTiling
{
	FTiling(const FKernelTile& InWhole, FIntVector InSize)
		: Whole(InWhole)
		, Size(InSize)
	{
		const FIntVector Extent(Whole.MaxX - Whole.MinX, Whole.MaxY - Whole.MinY, Whole.MaxZ - Whole.MinZ);
		if (Extent.X <= 0 || Extent.Y <= 0 || Extent.Z <= 0)
		{
			return;
		}
		Size.X = Size.X < 1 ? Extent.X : Size.X;
		Size.Y = Size.Y < 1 ? Extent.Y : Size.Y;
		Size.Z = Size.Z < 1 ? Extent.Z : Size.Z;
		Counts = FIntVector(CountTiles(Extent.X, Size.X), CountTiles(Extent.Y, Size.Y), CountTiles(Extent.Z, Size.Z));
	}

	int32 Num() const { return Counts.X * Counts.Y * Counts.Z; }

	FKernelTile Get(int32 Index) const
	{
		FKernelTile Tile;
		Tile.MinX = Whole.MinX + Index % Counts.X * Size.X;
		Tile.MinY = Whole.MinY + Index / Counts.X % Counts.Y * Size.Y;
		Tile.MinZ = Whole.MinZ + Index / Counts.X / Counts.Y * Size.Z;
		Tile.MaxX = std::min(Whole.MaxX, Tile.MinX + Size.X);
		Tile.MaxY = std::min(Whole.MaxY, Tile.MinY + Size.Y);
		Tile.MaxZ = std::min(Whole.MaxZ, Tile.MinZ + Size.Z);
		return Tile;
	}

	FKernelTile Whole;
	FIntVector Size;
	FIntVector Counts = FIntVector(0, 0, 0);
};

/** Keeps the exception of the first tile that threw one. */
class FFirstException
{
public:
	/** A tile before this one has thrown: this one need not run. */
	bool IsAfterFailure(int32 Index) const { return Index > FailedIndex.load(std::memory_order_relaxed); }

	void Record(int32 Index, std::exception_ptr InException)
	{
		std::lock_guard Lock(Mutex);
		if (Index < FailedIndex.load(std::memory_order_relaxed))
		{
			FailedIndex.store(Index, std::memory_order_relaxed);
			Exception = std::move(InException);
		}
	}

	void Rethrow() const
	{
		if (Exception)
		{
			std::rethrow_exception(Exception);
		}
	}

private:
	std::mutex Mutex;
	std::atomic<int32> FailedIndex{INT32_MAX};
	std::exception_ptr Exception;
};

} // namespace

FScopedDenormals::FScopedDenormals(EDenormals Mode)
	: SavedControlWord(GetControlWord())
{
	SetControlWord(Mode == EDenormals::Flush ? SavedControlWord | GFlushBits : SavedControlWord & ~GFlushBits);
}

FScopedDenormals::~FScopedDenormals()
{
	SetControlWord(SavedControlWord);
}

uint64 FScopedDenormals::GetControlWord()
{
#if defined(__x86_64__)
	// The low six bits are sticky exception flags: state of the arithmetic, not of its control.
	return _mm_getcsr() & ~0x3fu;
#elif defined(__aarch64__)
	uint64 Word;
	asm volatile("mrs %0, fpcr" : "=r"(Word));
	return Word;
#else
	return 0;
#endif
}

int32 GetNumThreads()
{
	const int32 Wanted = CVarDrydockThreads.GetValueOnAnyThread();
	// Counting them reads a file, and every dispatch asks.
	static const int32 All = std::max(1, int32(std::thread::hardware_concurrency()));
	return Wanted <= 0 ? All : std::min(Wanted, GMaxThreads);
}

void ForEachTile(
	const FKernelTile& Whole, FIntVector TileSize, TFunctionRef<void(const FKernelTile&)> Body, EDenormals Denormals)
{
	const FTiling Tiling(Whole, TileSize);
	FFirstException FirstException;
	const FCodeOwner* const Owner = GetRunningCode();
	const FRunningWords& Words = GetRunningWords();
	const auto RunTile = [&](int32 Index)
	{
		if (FirstException.IsAfterFailure(Index))
		{
			return;
		}
		// Whoever called is to blame on the workers, too.
		std::optional<FBorrowedCode> Borrowed;
		if (Owner != GetRunningCode())
		{
			EnsureFaultStack();
			Borrowed.emplace(Owner, Words);
		}
		const FScopedDenormals Scope(Denormals);
		const bool bNested = std::exchange(bInsideTile, true);
		try
		{
			Body(Tiling.Get(Index));
		}
		catch (...)
		{
			FirstException.Record(Index, std::current_exception());
		}
		bInsideTile = bNested;
	};

	const int32 NumThreads = std::min(GetNumThreads(), Tiling.Num());
	std::unique_lock Workers(GExecutorMutex, std::defer_lock);
	if (NumThreads > 1 && !bInsideTile && Workers.try_lock())
	{
		ParallelFor(GetNumThreads(), Tiling.Num(), RunTile);
	}
	else
	{
		for (int32 Index = 0; Index < Tiling.Num(); ++Index)
		{
			RunTile(Index);
		}
	}
	FirstException.Rethrow();
}

void ForEachTile(
	const FKernelTile& Whole, FIntPoint TileSize, TFunctionRef<void(const FKernelTile&)> Body, EDenormals Denormals)
{
	ForEachTile(Whole, FIntVector(TileSize.X, TileSize.Y, 1), Body, Denormals);
}

} // namespace Drydock
