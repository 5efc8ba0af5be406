// libFuzzer's entry for SPIR-V modules, and a mutator that keeps them modules: bytes changed anywhere seldom get past
// the first instruction.
#include "FuzzSpirvChecks.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <vector>

extern "C" size_t LLVMFuzzerMutate(uint8_t* Data, size_t Size, size_t MaxSize);

namespace
{

constexpr size_t NumHeaderWords = 5;

/** Where the instructions begin, and where the last one ends. */
std::vector<size_t> FindInstructions(const std::vector<uint32_t>& Words)
{
	std::vector<size_t> Starts;
	size_t At = NumHeaderWords;
	while (At < Words.size() && (Words[At] >> 16) != 0 && (Words[At] >> 16) <= Words.size() - At)
	{
		Starts.push_back(At);
		At += Words[At] >> 16;
	}
	Starts.push_back(std::min(At, Words.size()));
	return Starts;
}

void Change(std::vector<uint32_t>& Words, std::mt19937& Random)
{
	const std::vector<size_t> Starts = FindInstructions(Words);
	if (Words.size() <= NumHeaderWords || Starts.size() < 2)
	{
		return;
	}
	const auto Pick = [&Random](size_t Count)
	{
		return size_t(Random() % std::max<size_t>(1, Count));
	};
	const size_t One = Pick(Starts.size() - 1);
	const size_t Other = Pick(Starts.size() - 1);
	const std::vector<uint32_t> Instruction(Words.begin() + long(Starts[One]), Words.begin() + long(Starts[One + 1]));
	const size_t At = Starts[One] + Pick(Instruction.size());
	const bool bHead = At == Starts[One]; // its length is better left alone
	switch (Pick(9))
	{
	case 0:
		Words.erase(Words.begin() + long(Starts[One]), Words.begin() + long(Starts[One + 1]));
		break;
	case 1:
		Words.insert(Words.begin() + long(Starts[Other]), Instruction.begin(), Instruction.end());
		break;
	case 2:
		Words[At] = bHead ? (Words[At] & 0xffff0000u) | uint32_t(Pick(400)) : uint32_t(Pick(8));
		break;
	case 3:
		Words[At] ^= 1u << Pick(bHead ? 16 : 32);
		break;
	case 4: // an operand less
		if (Instruction.size() > 1)
		{
			Words[Starts[One]] -= 1u << 16;
			Words.erase(Words.begin() + long(std::max(At, Starts[One] + 1)));
		}
		break;
	case 5: // an operand more
		Words[Starts[One]] += 1u << 16;
		Words.insert(Words.begin() + long(Starts[One + 1]), uint32_t(Pick(Words[3])));
		break;
	case 6:
		Words[At] = bHead ? Words[At] : Words[Starts[Other]];
		break;
	default:
		Words[At] = bHead ? Words[At] : uint32_t(Pick(Words[3])); // another id
		break;
	}
}

} // namespace

extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* Data, size_t Size, size_t MaxSize, unsigned int Seed)
{
	std::mt19937 Random(Seed);
	if (Size < 4 * NumHeaderWords || Random() % 8 == 0)
	{
		return LLVMFuzzerMutate(Data, Size, MaxSize);
	}
	std::vector<uint32_t> Words(Size / 4);
	std::memcpy(Words.data(), Data, Words.size() * 4);
	for (uint32_t Changes = 1 + Random() % 3; Changes; --Changes)
	{
		Change(Words, Random);
	}
	const size_t NewSize = std::min(Words.size(), MaxSize / 4) * 4;
	std::memcpy(Data, Words.data(), NewSize);
	return NewSize;
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* Data, size_t Size)
{
	const std::string Problem = Drydock::CheckSpirvBytes(std::string(reinterpret_cast<const char*>(Data), Size));
	if (!Problem.empty())
	{
		std::fprintf(stderr, "%s\n", Problem.c_str());
		std::abort();
	}
	return 0;
}
