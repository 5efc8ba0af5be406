// Makes the tables from the exact conversions, once.
#include "LanesSrgb.h"

#include "PixelFormatConversion.h"

#include <array>
#include <bit>
#include <cstddef>

namespace Drydock
{

namespace
{

constexpr size_t GNumEncodes = size_t((0x3F800000 - GSrgb8FirstBits) >> 16) + 1;

uint32_t EncodeBits(uint32_t FloatBits)
{
	return EncodeSrgb8(double(std::bit_cast<float>(FloatBits)));
}

struct FTables
{
	std::array<float, 256> Decodes;
	std::array<uint32_t, GNumEncodes> Encodes;

	FTables()
	{
		for (size_t Code = 0; Code < Decodes.size(); ++Code)
		{
			Decodes[Code] = float(DecodeSrgb8(uint8_t(Code)));
		}
		for (size_t Index = 0; Index < GNumEncodes; ++Index)
		{
			const uint32_t First = uint32_t(GSrgb8FirstBits) + (uint32_t(Index) << 16);
			const uint32_t Code = EncodeBits(First);
			uint32_t Low = 0; // the last place known to have Code
			uint32_t High = 0x10000;
			while (High - Low > 1)
			{
				const uint32_t Middle = (Low + High) / 2;
				(EncodeBits(First + Middle) == Code ? Low : High) = Middle;
			}
			Encodes[Index] = (Code << 20) | High;
		}
	}
};

const FTables& GetTables()
{
	static const FTables Tables;
	return Tables;
}

} // namespace

const float* GetSrgb8Decodes()
{
	return GetTables().Decodes.data();
}

const uint32_t* GetSrgb8Encodes()
{
	return GetTables().Encodes.data();
}

} // namespace Drydock
