// Mixes bytes into a fingerprint in four lanes at once.
#include "Text/Fingerprint.h"

#include "Diagnostics.h"
#include "RegularFile.h"
#include "Text/ConfigErrors.h"
#include "Text/Fmt.inl"

#include <algorithm>
#include <bit>
#include <cstring>
#include <vector>

namespace Drydock
{

namespace
{

constexpr uint64_t Prime = 0x9FB21C651E98DF25u;

/** A multiplication alone leaves the difference of one bit where the next word could take it back. */
uint64_t Mix(uint64_t Lane, uint64_t Word)
{
	const uint64_t Product = std::rotl(Lane ^ Word, 29) * Prime;
	return Product ^ (Product >> 32);
}

/** Every bit of the result depends on every bit of Value. */
uint64_t Spread(uint64_t Value)
{
	Value = (Value ^ (Value >> 32)) * Prime;
	Value = (Value ^ (Value >> 29)) * Prime;
	return Value ^ (Value >> 32);
}

} // namespace

void FFingerprint::AddBlock(const uint8_t* Block)
{
	std::array<uint64_t, 4> Words;
	std::memcpy(Words.data(), Block, BlockSize);
	for (size_t Lane = 0; Lane < Lanes.size(); ++Lane)
	{
		Lanes[Lane] = Mix(Lanes[Lane], Words[Lane]);
	}
}

void FFingerprint::Add(const void* Bytes, size_t Count)
{
	const uint8_t* At = static_cast<const uint8_t*>(Bytes);
	const size_t NumPending = Length % BlockSize;
	Length += Count;
	if (NumPending > 0)
	{
		const size_t NumTaken = std::min(Count, BlockSize - NumPending);
		std::copy_n(At, NumTaken, Pending.begin() + static_cast<std::ptrdiff_t>(NumPending));
		At += NumTaken;
		Count -= NumTaken;
		if (NumPending + NumTaken < BlockSize)
		{
			return;
		}
		AddBlock(Pending.data());
	}
	for (; Count >= BlockSize; Count -= BlockSize, At += BlockSize)
	{
		AddBlock(At);
	}
	std::copy_n(At, Count, Pending.begin());
}

void FFingerprint::AddText(const std::string& Text)
{
	const uint64_t Size = Text.size();
	Add(&Size, sizeof(Size));
	Add(Text.data(), Text.size());
}

std::string FFingerprint::Get() const
{
	FFingerprint Last = *this;
	const std::array<uint8_t, BlockSize> Zeros = {};
	Last.Add(Zeros.data(), BlockSize - Length % BlockSize);
	uint64_t First = Spread(Length);
	uint64_t Second = ~First;
	for (const uint64_t Lane : Last.Lanes)
	{
		First = Spread(Mix(First, Lane));
		Second = Spread(Mix(Second, Spread(Lane) + First));
	}
	return fmt::format("{:016x}{:016x}", First, Second);
}

std::string FingerprintFile(const std::string& Path)
{
	FRegularFile File(Path);
	FFingerprint Fingerprint;
	std::vector<char> Buffer(1 << 20);
	for (size_t NumRead; (NumRead = File.Read(Buffer.data(), Buffer.size())) > 0;)
	{
		Fingerprint.Add(Buffer.data(), NumRead);
	}
	if (!File.GetProblem().empty())
	{
		throw FError(
			{.Code = ErrorFileMissing, .Message = "cannot be read: " + File.GetProblem(), .File = Path}, ExitFiles);
	}
	return Fingerprint.Get();
}

} // namespace Drydock
