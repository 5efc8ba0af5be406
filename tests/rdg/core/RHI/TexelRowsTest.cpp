// Rows of texels are converted to the same bits as single texels are.
#include <gtest/gtest.h>

#include "TexelRows.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

using namespace Drydock;

namespace
{

/** Bit for bit, but for what a NaN carries. */
bool IsSame(float One, float Other)
{
	return std::bit_cast<uint32_t>(One) == std::bit_cast<uint32_t>(Other) || (std::isnan(One) && std::isnan(Other));
}

/** Every storage of real numbers. */
std::vector<ETexelStorage> GetRealStorages()
{
	std::vector<ETexelStorage> Storages;
	for (size_t Index = 0; Index < static_cast<size_t>(ETexelStorage::Count); ++Index)
	{
		if (GTexelStorageInfos[Index].Kind != ETexelKind::Uint)
		{
			Storages.push_back(static_cast<ETexelStorage>(Index));
		}
	}
	return Storages;
}

/** Where halves change, where 8-, 10- and 16-bit codes do, and what is no number. */
std::vector<float> MakeHardValues()
{
	std::vector<float> Values = {0.0f, -0.0f, 1.0f, 65503.99f, 65504.0f, 65519.99f, 65520.0f, 65536.0f, 1e30f, 1e-40f,
		std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(),
		std::numeric_limits<float>::min(), std::numeric_limits<float>::denorm_min()};
	const auto AddAround = [&Values](double Border)
	{
		const float Value = static_cast<float>(Border);
		Values.insert(Values.end(), {std::nextafter(Value, -1e9f), Value, std::nextafter(Value, 1e9f)});
	};
	for (uint32_t Code = 0; Code < 0x7bff; ++Code)
	{
		const uint16_t Bits = static_cast<uint16_t>(Code);
		AddAround(0.5 * (DecodeHalf(Bits) + DecodeHalf(static_cast<uint16_t>(Bits + 1))));
	}
	for (const int Max : {255, 1023, 65535})
	{
		for (int Code = 0; Code < Max; Code += Max / 255)
		{
			AddAround((Code + 0.5) / Max);
		}
	}
	for (size_t Index = 0, Count = Values.size(); Index < Count; ++Index)
	{
		Values.push_back(-Values[Index]);
	}
	return Values;
}

} // namespace

TEST(TexelRows, DecodeToTheBitsOfSingleTexels)
{
	std::mt19937 Random(183);
	constexpr int32_t Count = 5000;
	for (const ETexelStorage Storage : GetRealStorages())
	{
		const size_t TexelBytes = GetTexelStorageInfo(Storage).BytesPerTexel;
		std::vector<uint8_t> Texels(Count * TexelBytes);
		std::generate(Texels.begin(), Texels.end(), [&Random] { return static_cast<uint8_t>(Random()); });
		for (int32_t NumChannels = 1; NumChannels <= 4; ++NumChannels)
		{
			std::vector<float> Row(static_cast<size_t>(Count * NumChannels));
			DecodeTexelRow(Storage, Texels.data(), Count, NumChannels, Row.data());
			size_t NumOther = 0;
			for (size_t Index = 0; Index < Count; ++Index)
			{
				float Texel[4];
				DecodeTexel(Storage, &Texels[Index * TexelBytes], Texel);
				const size_t Size = static_cast<size_t>(NumChannels);
				NumOther += std::equal(Texel, Texel + Size, &Row[Index * Size], IsSame) ? 0 : 1;
			}
			EXPECT_EQ(0u, NumOther) << GetTexelStorageInfo(Storage).Name << ", " << NumChannels << " channels";
		}
	}
}

TEST(TexelRows, EncodeToTheBitsOfSingleTexels)
{
	std::mt19937 Random(184);
	std::vector<float> RGBA = MakeHardValues();
	while (RGBA.size() % 4 != 0 || RGBA.size() < 300'000)
	{
		RGBA.push_back(std::bit_cast<float>(static_cast<uint32_t>(Random())));
	}
	const int32_t Count = static_cast<int32_t>(RGBA.size() / 4);
	for (const ETexelStorage Storage : GetRealStorages())
	{
		for (const bool bSaturate : {false, true})
		{
			const size_t TexelBytes = GetTexelStorageInfo(Storage).BytesPerTexel;
			std::vector<uint8_t> Row(static_cast<size_t>(Count) * TexelBytes), Single(Row.size());
			EncodeTexelRow(Storage, RGBA.data(), Count, Row.data(), bSaturate);
			for (size_t Index = 0; Index < static_cast<size_t>(Count); ++Index)
			{
				EncodeTexel(Storage, &RGBA[Index * 4], &Single[Index * TexelBytes], bSaturate);
			}
			EXPECT_EQ(Single, Row) << GetTexelStorageInfo(Storage).Name << (bSaturate ? ", saturating" : "");
		}
	}
}
