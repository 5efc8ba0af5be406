// Multiplies words pairwise to 128 bits, four sums side by side, which keeps up with memory.
#include "TexelBlock.h"

#include "TileExecutor.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <vector>

namespace Drydock
{

namespace
{

__extension__ using FWideUint = unsigned __int128;

// Odd, with about as many ones as zeros: fractional digits of square roots of primes.
constexpr uint64 Keys[4] = {0x6a09e667f3bcc909, 0xbb67ae8584caa73b, 0x3c6ef372fe94f82b, 0xa54ff53a5f1d36f1};

uint64 Fold(uint64 A, uint64 B)
{
	const FWideUint Product = FWideUint(A) * B;
	return uint64(Product) ^ uint64(Product >> 64);
}

/** Takes in 64 bytes. Each word reaches two sums. */
void Mix(uint64 (&Sums)[4], const uint8* Data)
{
	uint64 Words[8];
	std::memcpy(Words, Data, sizeof(Words));
	for (int32 Sum = 0; Sum < 4; ++Sum)
	{
		const uint64 A = Words[2 * Sum];
		const uint64 B = Words[2 * Sum + 1];
		Sums[Sum] = std::rotl(Sums[Sum], 29) + Fold(A ^ Keys[Sum], B ^ Sums[Sum]);
		Sums[Sum ^ 1] += A ^ std::rotl(B, 32);
	}
}

/** Calls Function(Row, bytes of the rows before it), on all threads where it pays. */
template<typename TFunction>
void ForEachRow(const FTexelBlock& Block, const TFunction& Function)
{
	constexpr size_t BytesPerPart = 256 * 1024;
	if (Block.RowBytes == 0)
	{
		return;
	}
	const FKernelTile Whole = {0, 0, 0, 1, Block.NumRows, Block.NumSlices};
	ForEachTile(Whole, FIntVector(1, int32(std::max<size_t>(1, BytesPerPart / Block.RowBytes)), 1),
		[&](const FKernelTile& Part)
		{
			for (int32 Y = Part.MinY; Y < Part.MaxY; ++Y)
			{
				const size_t Before = size_t(Part.MinZ) * size_t(Block.NumRows) + size_t(Y);
				Function(Block.Data + Part.MinZ * Block.SlicePitch + Y * Block.RowPitch, Before * Block.RowBytes);
			}
		});
}

} // namespace

void FMemoryHasher::Add(const void* Data, size_t NumBytes)
{
	constexpr size_t Step = 64;
	const uint8* const Bytes = static_cast<const uint8*>(Data);
	size_t Done = 0;
	for (; Done + Step <= NumBytes; Done += Step)
	{
		Mix(Sums, Bytes + Done);
	}
	uint8 Rest[Step] = {};
	if (NumBytes > Done)
	{
		std::memcpy(Rest, Bytes + Done, NumBytes - Done);
		Mix(Sums, Rest);
	}
	Sums[0] = Fold(Sums[0] ^ Keys[1], uint64(NumBytes) ^ Keys[2]) + Sums[3];
}

FMemoryHash FMemoryHasher::Get() const
{
	FMemoryHash Hash;
	Hash.Low = Fold(Sums[0] ^ Keys[2], Sums[1] ^ Keys[3]) ^ std::rotl(Sums[2], 17);
	Hash.High = Fold(Sums[2] ^ Keys[0], Sums[3] ^ Keys[1]) ^ std::rotl(Sums[1], 41);
	Hash.Low |= Hash.IsKnown() ? 0 : 1;
	return Hash;
}

FMemoryHash HashTexels(const FTexelBlock& Block)
{
	std::vector<FMemoryHash> Rows(size_t(Block.NumRows) * size_t(Block.NumSlices));
	ForEachRow(Block,
		[&](const uint8* Row, size_t Before)
		{
			FMemoryHasher Hasher;
			Hasher.Add(Row, Block.RowBytes);
			Rows[Before / Block.RowBytes] = Hasher.Get();
		});
	FMemoryHasher Sum;
	Sum.Add(Block.RowBytes);
	Sum.Add(Rows.data(), Rows.size() * sizeof(FMemoryHash));
	return Sum.Get();
}

void SaveTexels(const FTexelBlock& Block, uint8* Kept)
{
	ForEachRow(Block, [&](const uint8* Row, size_t Before) { std::memcpy(Kept + Before, Row, Block.RowBytes); });
}

void RestoreTexels(const FTexelBlock& Block, const uint8* Kept)
{
	ForEachRow(Block, [&](uint8* Row, size_t Before) { std::memcpy(Row, Kept + Before, Block.RowBytes); });
}

} // namespace Drydock
