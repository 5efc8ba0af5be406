// Decodes by tables that the conversion of single texels fills; encodes half floats without branches.
#include "TexelRows.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <vector>

namespace Drydock
{

namespace
{

/** Makes the table of values that a channel's codes stand for. */
template<typename TDecode>
std::vector<float> MakeTable(size_t NumCodes, TDecode Decode)
{
	std::vector<float> Table(NumCodes);
	for (size_t Code = 0; Code < NumCodes; ++Code)
	{
		Table[Code] = static_cast<float>(Decode(static_cast<uint32_t>(Code)));
	}
	return Table;
}

const float* GetHalfTable()
{
	static const std::vector<float> Table =
		MakeTable(65536, [](uint32_t Code) { return DecodeHalf(static_cast<uint16_t>(Code)); });
	return Table.data();
}

template<int32_t Bits>
const float* GetUnormTable()
{
	static const std::vector<float> Table =
		MakeTable(size_t(1) << Bits, [](uint32_t Code) { return DecodeUnorm(Code, Bits); });
	return Table.data();
}

const float* GetSrgbTable()
{
	static const std::vector<float> Table =
		MakeTable(256, [](uint32_t Code) { return DecodeSrgb8(static_cast<uint8_t>(Code)); });
	return Table.data();
}

template<int32_t MantissaBits>
const float* GetMiniFloatTable()
{
	static const std::vector<float> Table = MakeTable(
		size_t(32) << MantissaBits, [](uint32_t Code) { return DecodeUnsignedMiniFloat(Code, MantissaBits); });
	return Table.data();
}

/** The place of a channel's codes, and the values that they stand for. */
struct FChannelCodes
{
	const float* Table = nullptr; // null: the format lacks the channel
	uint32_t Shift = 0;           // in the texel's first 8 bytes
	uint32_t Mask = 0;
};

using FTexelCodes = std::array<FChannelCodes, 4>;

/** False: the format has no codes that a table could hold. */
bool FindCodes(ETexelStorage Storage, FTexelCodes& Codes)
{
	const FTexelStorageInfo& Info = GetTexelStorageInfo(Storage);
	if (Storage == ETexelStorage::R11G11B10_FLOAT)
	{
		Codes = {{{GetMiniFloatTable<6>(), 0, 0x7ff}, {GetMiniFloatTable<6>(), 11, 0x7ff},
			{GetMiniFloatTable<5>(), 22, 0x3ff}}};
		return true;
	}
	if (Storage == ETexelStorage::RGB10A2_UNORM)
	{
		Codes = {{{GetUnormTable<10>(), 0, 0x3ff}, {GetUnormTable<10>(), 10, 0x3ff}, {GetUnormTable<10>(), 20, 0x3ff},
			{GetUnormTable<2>(), 30, 3}}};
		return true;
	}
	if (Info.Kind == ETexelKind::Uint || Info.BitsPerChannel > 16)
	{
		return false;
	}
	const bool bWide = Info.BitsPerChannel == 16;
	const bool bBgra = Storage == ETexelStorage::BGRA8_UNORM || Storage == ETexelStorage::BGRA8_SRGB;
	for (uint32_t Channel = 0; Channel < Info.NumChannels; ++Channel)
	{
		const uint32_t Place = bBgra && Channel < 3 ? 2 - Channel : Channel;
		const bool bSrgb = Info.Kind == ETexelKind::Srgb && Channel < 3;
		Codes[Channel].Table = Info.Kind == ETexelKind::Float ? GetHalfTable()
							   : bWide                        ? GetUnormTable<16>()
							   : bSrgb                        ? GetSrgbTable()
															  : GetUnormTable<8>();
		Codes[Channel].Shift = Place * Info.BitsPerChannel;
		Codes[Channel].Mask = bWide ? 0xffff : 0xff;
	}
	return true;
}

template<int32_t TexelBytes>
void DecodeCodes(const FTexelCodes& Codes, const uint8_t* Texels, int32_t Count, int32_t NumChannels, float* OutValues)
{
	for (int32_t Index = 0; Index < Count; ++Index, Texels += TexelBytes)
	{
		uint64_t Texel = 0;
		std::memcpy(&Texel, Texels, TexelBytes);
		for (int32_t Channel = 0; Channel < NumChannels; ++Channel)
		{
			const FChannelCodes& Of = Codes[static_cast<size_t>(Channel)];
			*OutValues++ = Of.Table != nullptr ? Of.Table[(Texel >> Of.Shift) & Of.Mask] : Channel == 3 ? 1.0f : 0.0f;
		}
	}
}

/** A finite float that is less than 65520 in magnitude, to nearest even. */
uint16_t EncodeSmallHalf(uint32_t Bits)
{
	const uint32_t Magnitude = Bits & 0x7fffffff;
	const uint32_t Sign = (Bits >> 16) & 0x8000;
	// Denormal halves: the sum's last bit is worth as much as theirs, and rounds as it should.
	const uint32_t Small =
		std::bit_cast<uint32_t>(std::bit_cast<float>(Magnitude) + 0.5f) - std::bit_cast<uint32_t>(0.5f);
	const uint32_t Normal = (Magnitude + 0xfff + ((Magnitude >> 13) & 1) - (112u << 23)) >> 13;
	return static_cast<uint16_t>(Sign | (Magnitude < (113u << 23) ? Small : Normal));
}

void EncodeHalfRow(const float* Values, size_t Count, uint16_t* OutHalves, bool bSaturate)
{
	constexpr size_t BlockSize = 64; // a block that holds something large or not finite goes one by one
	for (size_t First = 0; First < Count; First += BlockSize)
	{
		const size_t End = std::min(First + BlockSize, Count);
		uint32_t Largest = 0;
		for (size_t Index = First; Index < End; ++Index)
		{
			const uint32_t Bits = std::bit_cast<uint32_t>(Values[Index]);
			Largest = std::max(Largest, Bits & 0x7fffffff);
			OutHalves[Index] = EncodeSmallHalf(Bits);
		}
		for (size_t Index = First; Largest >= std::bit_cast<uint32_t>(65520.0f) && Index < End; ++Index)
		{
			OutHalves[Index] = EncodeHalf(static_cast<double>(Values[Index]), bSaturate);
		}
	}
}

/** The product of a float and up to 16 bits is exact in double, and so is its rounding to nearest even. */
template<typename TCode>
TCode EncodeUnormCode(float Value)
{
	constexpr double Max = std::numeric_limits<TCode>::max();
	constexpr double RoundsToInteger = 6755399441055744.0; // 1.5 * 2^52
	const double Clamped = Value > 0.0f ? std::min(static_cast<double>(Value), 1.0) : 0.0;
	return static_cast<TCode>(std::bit_cast<uint64_t>(Clamped * Max + RoundsToInteger));
}

template<typename TCode>
void EncodeUnormRow(const float* RGBA, int32_t Count, const std::array<size_t, 4>& Order, size_t NumChannels, void* Out)
{
	auto* Codes = static_cast<TCode*>(Out);
	for (int32_t Index = 0; Index < Count; ++Index, RGBA += 4, Codes += NumChannels)
	{
		for (size_t Channel = 0; Channel < NumChannels; ++Channel)
		{
			Codes[Order[Channel]] = EncodeUnormCode<TCode>(RGBA[Channel]);
		}
	}
}

} // namespace

void DecodeTexelRow(ETexelStorage Storage, const void* Texels, int32_t Count, int32_t NumChannels, float* OutValues)
{
	const auto* Bytes = static_cast<const uint8_t*>(Texels);
	const size_t TexelBytes = GetTexelStorageInfo(Storage).BytesPerTexel;
	FTexelCodes Codes;
	if (Storage == ETexelStorage::RGBA32_FLOAT && NumChannels == 4)
	{
		std::memcpy(OutValues, Texels, static_cast<size_t>(Count) * TexelBytes);
		return;
	}
	if (FindCodes(Storage, Codes))
	{
		return TexelBytes == 1   ? DecodeCodes<1>(Codes, Bytes, Count, NumChannels, OutValues)
			   : TexelBytes == 2 ? DecodeCodes<2>(Codes, Bytes, Count, NumChannels, OutValues)
			   : TexelBytes == 4 ? DecodeCodes<4>(Codes, Bytes, Count, NumChannels, OutValues)
								 : DecodeCodes<8>(Codes, Bytes, Count, NumChannels, OutValues);
	}
	for (int32_t Index = 0; Index < Count; ++Index, Bytes += TexelBytes)
	{
		float Value[4];
		DecodeTexel(Storage, Bytes, Value);
		OutValues = std::copy_n(Value, NumChannels, OutValues);
	}
}

void EncodeTexelRow(ETexelStorage Storage, const float* RGBA, int32_t Count, void* OutTexels, bool bSaturate)
{
	if (Storage == ETexelStorage::RGBA16_FLOAT)
	{
		EncodeHalfRow(RGBA, static_cast<size_t>(Count) * 4, static_cast<uint16_t*>(OutTexels), bSaturate);
		return;
	}
	const FTexelStorageInfo& Info = GetTexelStorageInfo(Storage);
	if (Info.Kind == ETexelKind::Unorm && Storage != ETexelStorage::RGB10A2_UNORM)
	{
		const bool bBgra = Storage == ETexelStorage::BGRA8_UNORM;
		const std::array<size_t, 4> Order = {bBgra ? 2u : 0u, 1, bBgra ? 0u : 2u, 3};
		Info.BitsPerChannel == 8 ? EncodeUnormRow<uint8_t>(RGBA, Count, Order, Info.NumChannels, OutTexels)
								 : EncodeUnormRow<uint16_t>(RGBA, Count, Order, Info.NumChannels, OutTexels);
		return;
	}
	auto* Bytes = static_cast<uint8_t*>(OutTexels);
	for (int32_t Index = 0; Index < Count; ++Index, RGBA += 4, Bytes += Info.BytesPerTexel)
	{
		EncodeTexel(Storage, RGBA, Bytes, bSaturate);
	}
}

} // namespace Drydock
