// The mark is an instruction without operands and result that no pixel or compute shader has.
#include "FrontEndLoops.h"

#include "FrontEndIntegers.h"

#include <glslang/SPIRV/spirv.hpp>

namespace Drydock
{

namespace
{

constexpr unsigned int Mark = 1u << spv::WordCountShift | spv::OpEmitVertex;

/** Without marks; with one in each loop's header, if so. */
std::vector<unsigned int> CopyWords(const std::vector<unsigned int>& Words, bool bMark)
{
	std::vector<unsigned int> Result(Words.begin(), Words.begin() + GModuleHeaderWords);
	for (size_t At = GModuleHeaderWords; At < Words.size() && Words[At] >> spv::WordCountShift != 0;)
	{
		const std::ptrdiff_t Count = Words[At] >> spv::WordCountShift;
		if (bMark && (Words[At] & spv::OpCodeMask) == spv::OpLoopMerge)
		{
			Result.push_back(Mark);
		}
		if (Words[At] != Mark)
		{
			Result.insert(Result.end(), Words.begin() + std::ptrdiff_t(At), Words.begin() + std::ptrdiff_t(At) + Count);
		}
		At += size_t(Count);
	}
	return Result;
}

} // namespace

void MarkLoops(std::vector<unsigned int>& Words)
{
	Words = CopyWords(Words, true);
}

void UnmarkLoops(std::vector<unsigned int>& Words)
{
	Words = CopyWords(Words, false);
}

} // namespace Drydock
