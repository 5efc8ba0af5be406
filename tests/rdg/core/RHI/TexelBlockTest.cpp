// Rows of memory are hashed, saved and put back.
#include "RHITestHelpers.h"
#include "TexelBlock.h"

using namespace Drydock;
using namespace Drydock::Tests;

TEST(TexelBlock, HashesTellRowsApartAndLeaveOutWhatLiesBetween)
{
	std::vector<uint8> Bytes(16 * 1000);
	for (size_t Index = 0; Index < Bytes.size(); ++Index)
	{
		Bytes[Index] = uint8(Index * 7 % 251);
	}
	const FTexelBlock Block = {Bytes.data(), 10, 1000, 1, 16, 16000};
	const FMemoryHash Hash = HashTexels(Block);
	EXPECT_TRUE(Hash.IsKnown());
	Bytes[12] ^= 1; // behind the first row
	EXPECT_EQ(Hash, HashTexels(Block));
	for (const size_t Texel : {size_t(0), size_t(9), size_t(16 * 999 + 9)})
	{
		for (int32 Bit = 0; Bit < 8; ++Bit)
		{
			Bytes[Texel] ^= uint8(1 << Bit);
			EXPECT_NE(Hash, HashTexels(Block));
			Bytes[Texel] ^= uint8(1 << Bit);
		}
	}
	const FScopedCVar Threads(TEXT("r.Drydock.Threads"), 3);
	EXPECT_EQ(Hash, HashTexels(Block));
	std::vector<uint8> Kept(Block.GetNumBytes());
	SaveTexels(Block, Kept.data());
	const std::vector<uint8> Before = Bytes;
	std::fill(Bytes.begin(), Bytes.end(), uint8(0));
	RestoreTexels(Block, Kept.data());
	EXPECT_EQ(Hash, HashTexels(Block));
	EXPECT_EQ(Before[16 * 999 + 9], Bytes[16 * 999 + 9]);
	EXPECT_EQ(0, Bytes[12]);
}
