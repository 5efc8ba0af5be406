// Changes SPIR-V so that it mostly stays a module: bytes changed anywhere seldom get past the first instruction.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

namespace Drydock
{

constexpr size_t NumSpirvHeaderWords = 5;

/** Where the instructions begin, and where the last one ends. */
inline std::vector<size_t> FindSpirvInstructions(const std::vector<uint32_t>& Words)
{
	std::vector<size_t> Starts;
	size_t At = NumSpirvHeaderWords;
	while (At < Words.size() && (Words[At] >> 16) != 0 && (Words[At] >> 16) <= Words.size() - At)
	{
		Starts.push_back(At);
		At += Words[At] >> 16;
	}
	Starts.push_back(std::min(At, Words.size()));
	return Starts;
}

/** One instruction more, less or other: mostly still a module. */
inline void ChangeSpirv(std::vector<uint32_t>& Words, std::mt19937& Random)
{
	const std::vector<size_t> Starts = FindSpirvInstructions(Words);
	if (Words.size() <= NumSpirvHeaderWords || Starts.size() < 2)
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

inline void MutateSpirv(std::vector<uint32_t>& Words, std::mt19937& Random)
{
	for (uint32_t Changes = 1 + Random() % 3; Changes; --Changes)
	{
		ChangeSpirv(Words, Random);
	}
}

} // namespace Drydock
