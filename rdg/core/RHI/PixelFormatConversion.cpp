// Texel conversion in integer arithmetic: the bits of a double are rounded directly, so that nothing rounds twice.
// Source: IEEE 754-2008, D3D11.3 functional specification 3.2, IEC 61966-2-1.
#include "PixelFormatConversion.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace Drydock
{

namespace
{

constexpr int32_t ExponentBits = 5;
constexpr int32_t ExponentBias = 15;
constexpr uint32_t ExponentAllOnes = (1u << ExponentBits) - 1;

/** Rounds the magnitude of a finite double to a 5-bit exponent and MantissaBits of mantissa, to nearest even. The
 * result may be the pattern of infinity: the caller decides what overflow means. */
uint32_t RoundMagnitude(uint64_t DoubleBits, int32_t MantissaBits)
{
	const int32_t Exponent = int32_t((DoubleBits >> 52) & 0x7ff) - 1023;
	if (Exponent > ExponentBias)
	{
		return ExponentAllOnes << MantissaBits;
	}
	if (Exponent < -ExponentBias - MantissaBits)
	{
		return 0; // below half of the smallest denormal; double denormals and zero land here too
	}

	const uint64_t Mantissa = (DoubleBits & 0xfffffffffffffull) | (1ull << 52);
	const int32_t DenormalShift = std::max(0, 1 - ExponentBias - Exponent);
	const int32_t Shift = 52 - MantissaBits + DenormalShift;
	const uint64_t Kept = Mantissa >> Shift;
	const uint64_t Rest = Mantissa & ((1ull << Shift) - 1);
	const uint64_t Half = 1ull << (Shift - 1);
	const uint64_t Rounded = Kept + ((Rest > Half || (Rest == Half && (Kept & 1))) ? 1 : 0);

	// Kept has its leading one at MantissaBits when normal. Adding, not or-ing, lets a carry raise the exponent, and a
	// denormal that rounds up to the smallest normal gets its exponent the same way.
	const uint32_t BiasedExponent = DenormalShift > 0 ? 0 : uint32_t(Exponent + ExponentBias - 1);
	return (BiasedExponent << MantissaBits) + uint32_t(Rounded);
}

/** Infinity's exponent with the double's top mantissa bits and the quiet bit set, as hardware converts. */
uint32_t NaNMagnitude(uint64_t DoubleBits, int32_t MantissaBits)
{
	const uint32_t Payload = uint32_t((DoubleBits & 0xfffffffffffffull) >> (52 - MantissaBits));
	return (ExponentAllOnes << MantissaBits) | (1u << (MantissaBits - 1)) | Payload;
}

double DecodeMagnitude(uint32_t Bits, int32_t MantissaBits)
{
	const uint32_t Exponent = (Bits >> MantissaBits) & ExponentAllOnes;
	const uint64_t Mantissa = Bits & ((1u << MantissaBits) - 1);
	if (Exponent == ExponentAllOnes)
	{
		const uint64_t Quiet = Mantissa ? 1ull << 51 : 0;
		return std::bit_cast<double>((0x7ffull << 52) | Quiet | (Mantissa << (52 - MantissaBits)));
	}
	if (Exponent == 0)
	{
		return std::ldexp(double(Mantissa), 1 - ExponentBias - MantissaBits);
	}
	return std::bit_cast<double>((uint64_t(Exponent - ExponentBias + 1023) << 52) | (Mantissa << (52 - MantissaBits)));
}

/** The 255 linear values at which the sRGB code changes, and the 256 values that codes stand for. Made in extended
 *  precision: no double lies within its error of a threshold, so encoding is correctly rounded. */
struct FSrgbTables
{
	std::array<long double, 255> Thresholds;
	std::array<double, 256> Values;

	static long double Decode(long double Encoded)
	{
		return Encoded <= 0.04045L ? Encoded / 12.92L : std::pow((Encoded + 0.055L) / 1.055L, 2.4L);
	}

	FSrgbTables()
	{
		for (int32_t Code = 0; Code < 256; ++Code)
		{
			Values[Code] = double(Decode(Code / 255.0L));
			if (Code < 255)
			{
				Thresholds[Code] = Decode((Code + 0.5L) / 255.0L);
			}
		}
	}
};

const FSrgbTables& GetSrgbTables()
{
	static const FSrgbTables Tables;
	return Tables;
}

uint32_t EncodeUint(double Value, int32_t Bits)
{
	const double Max = double((1ull << Bits) - 1);
	return Value > 0 ? uint32_t(std::min(Value, Max)) : 0; // NaN compares false
}

uint32_t EncodeSint(double Value)
{
	return std::isnan(Value) ? 0 : uint32_t(int32_t(std::clamp(Value, -2147483648.0, 2147483647.0)));
}

template<typename T>
void StoreChannels(const T* Values, int32_t Count, void* Texel)
{
	std::memcpy(Texel, Values, size_t(Count) * sizeof(T));
}

template<typename T>
void LoadChannels(const void* Texel, int32_t Count, T* OutValues)
{
	std::memcpy(OutValues, Texel, size_t(Count) * sizeof(T));
}

/** Position in memory of red, green, blue and alpha. */
constexpr int32_t GOrderRgba[4] = {0, 1, 2, 3};
constexpr int32_t GOrderBgra[4] = {2, 1, 0, 3};

const int32_t* GetChannelOrder(ETexelStorage Storage)
{
	return Storage == ETexelStorage::BGRA8_UNORM || Storage == ETexelStorage::BGRA8_SRGB ? GOrderBgra : GOrderRgba;
}

template<typename Real>
void EncodeReal(ETexelStorage Storage, const Real RGBA[4], void* Texel, bool bSaturate)
{
	const FTexelStorageInfo& Info = GetTexelStorageInfo(Storage);
	const int32_t Count = Info.NumChannels;

	if (Storage == ETexelStorage::R11G11B10_FLOAT)
	{
		const uint32_t Packed = EncodeUnsignedMiniFloat(RGBA[0], 6) | (EncodeUnsignedMiniFloat(RGBA[1], 6) << 11) |
								(EncodeUnsignedMiniFloat(RGBA[2], 5) << 22);
		StoreChannels(&Packed, 1, Texel);
		return;
	}
	if (Storage == ETexelStorage::RGB10A2_UNORM)
	{
		const uint32_t Packed = EncodeUnorm(RGBA[0], 10) | (EncodeUnorm(RGBA[1], 10) << 10) |
								(EncodeUnorm(RGBA[2], 10) << 20) | (EncodeUnorm(RGBA[3], 2) << 30);
		StoreChannels(&Packed, 1, Texel);
		return;
	}
	if (Info.Kind == ETexelKind::Float && Info.BitsPerChannel == 32)
	{
		const float Values[4] = {float(RGBA[0]), float(RGBA[1]), float(RGBA[2]), float(RGBA[3])};
		StoreChannels(Values, Count, Texel);
		return;
	}
	if (Info.Kind == ETexelKind::Float && Info.BitsPerChannel == 64)
	{
		const double Values[4] = {double(RGBA[0]), double(RGBA[1]), double(RGBA[2]), double(RGBA[3])};
		StoreChannels(Values, Count, Texel);
		return;
	}

	const int32_t* Order = GetChannelOrder(Storage);
	uint32_t Codes[4] = {};
	for (int32_t Channel = 0; Channel < Count; ++Channel)
	{
		uint32_t& Code = Codes[Order[Channel]];
		switch (Info.Kind)
		{
		case ETexelKind::Float:
			Code = EncodeHalf(RGBA[Channel], bSaturate);
			break;
		case ETexelKind::Uint:
			Code = Storage == ETexelStorage::R32_SINT ? EncodeSint(double(RGBA[Channel]))
													  : EncodeUint(RGBA[Channel], Info.BitsPerChannel);
			break;
		case ETexelKind::Srgb:
			Code = Channel < 3 ? EncodeSrgb8(RGBA[Channel]) : EncodeUnorm(RGBA[Channel], 8);
			break;
		case ETexelKind::Unorm:
			Code = EncodeUnorm(RGBA[Channel], Info.BitsPerChannel);
			break;
		}
	}
	for (int32_t Channel = 0; Channel < Count; ++Channel)
	{
		// Little-endian: the low bytes of a code are the channel.
		std::memcpy(
			static_cast<uint8_t*>(Texel) + Channel * Info.BitsPerChannel / 8, &Codes[Channel], Info.BitsPerChannel / 8);
	}
}

/** The integer codes of up to four byte-aligned channels, in memory order. */
void LoadCodes(const FTexelStorageInfo& Info, const void* Texel, uint32_t OutCodes[4])
{
	const int32_t Bytes = Info.BitsPerChannel / 8;
	for (int32_t Channel = 0; Channel < Info.NumChannels; ++Channel)
	{
		OutCodes[Channel] = 0;
		std::memcpy(&OutCodes[Channel], static_cast<const uint8_t*>(Texel) + Channel * Bytes, size_t(Bytes));
	}
}

template<typename Real>
void DecodeReal(ETexelStorage Storage, const void* Texel, Real OutRGBA[4])
{
	const FTexelStorageInfo& Info = GetTexelStorageInfo(Storage);
	double Values[4] = {0, 0, 0, 1};

	if (Storage == ETexelStorage::R11G11B10_FLOAT || Storage == ETexelStorage::RGB10A2_UNORM)
	{
		uint32_t Packed;
		LoadChannels(Texel, 1, &Packed);
		if (Info.Kind == ETexelKind::Float)
		{
			Values[0] = DecodeUnsignedMiniFloat(Packed & 0x7ff, 6);
			Values[1] = DecodeUnsignedMiniFloat((Packed >> 11) & 0x7ff, 6);
			Values[2] = DecodeUnsignedMiniFloat(Packed >> 22, 5);
		}
		else
		{
			Values[0] = DecodeUnorm(Packed & 0x3ff, 10);
			Values[1] = DecodeUnorm((Packed >> 10) & 0x3ff, 10);
			Values[2] = DecodeUnorm((Packed >> 20) & 0x3ff, 10);
			Values[3] = DecodeUnorm(Packed >> 30, 2);
		}
	}
	else if (Info.Kind == ETexelKind::Float && Info.BitsPerChannel == 32)
	{
		float Floats[4] = {0, 0, 0, 1};
		LoadChannels(Texel, Info.NumChannels, Floats);
		std::copy(Floats, Floats + 4, Values);
	}
	else if (Info.Kind == ETexelKind::Float && Info.BitsPerChannel == 64)
	{
		LoadChannels(Texel, Info.NumChannels, Values);
	}
	else
	{
		uint32_t Codes[4];
		LoadCodes(Info, Texel, Codes);
		const int32_t* Order = GetChannelOrder(Storage);
		for (int32_t Channel = 0; Channel < Info.NumChannels; ++Channel)
		{
			const uint32_t Code = Codes[Order[Channel]];
			switch (Info.Kind)
			{
			case ETexelKind::Float:
				Values[Channel] = DecodeHalf(uint16_t(Code));
				break;
			case ETexelKind::Uint:
				Values[Channel] = Storage == ETexelStorage::R32_SINT ? double(int32_t(Code)) : double(Code);
				break;
			case ETexelKind::Srgb:
				Values[Channel] = Channel < 3 ? DecodeSrgb8(uint8_t(Code)) : DecodeUnorm(Code, 8);
				break;
			case ETexelKind::Unorm:
				Values[Channel] = DecodeUnorm(Code, Info.BitsPerChannel);
				break;
			}
		}
	}
	for (int32_t Channel = 0; Channel < 4; ++Channel)
	{
		OutRGBA[Channel] = Real(Values[Channel]);
	}
}

} // namespace

uint16_t EncodeHalf(double Value, bool bSaturate)
{
	const uint64_t Bits = std::bit_cast<uint64_t>(Value);
	const uint32_t Sign = uint32_t(Bits >> 48) & 0x8000;
	if (std::isnan(Value))
	{
		return uint16_t(Sign | NaNMagnitude(Bits, 10));
	}
	const uint32_t Magnitude = RoundMagnitude(Bits, 10);
	const bool bOverflow = Magnitude >= 0x7c00 && !std::isinf(Value);
	return uint16_t(Sign | (bOverflow && bSaturate ? 0x7bff : Magnitude));
}

double DecodeHalf(uint16_t Bits)
{
	const double Magnitude = DecodeMagnitude(Bits & 0x7fff, 10);
	// copysign, not negation: it also carries a NaN's sign.
	return std::copysign(Magnitude, Bits & 0x8000 ? -1.0 : 1.0);
}

uint32_t EncodeUnsignedMiniFloat(double Value, int32_t MantissaBits)
{
	const uint64_t Bits = std::bit_cast<uint64_t>(Value);
	if (std::isnan(Value))
	{
		return NaNMagnitude(Bits, MantissaBits);
	}
	if (Bits >> 63)
	{
		return 0;
	}
	const uint32_t Infinity = ExponentAllOnes << MantissaBits;
	return std::isinf(Value) ? Infinity : std::min(RoundMagnitude(Bits, MantissaBits), Infinity - 1);
}

double DecodeUnsignedMiniFloat(uint32_t Bits, int32_t MantissaBits)
{
	return DecodeMagnitude(Bits, MantissaBits);
}

uint32_t EncodeUnorm(double Value, int32_t Bits)
{
	const double Max = double((1u << Bits) - 1);
	if (!(Value > 0))
	{
		return 0; // NaN too
	}
	if (Value >= 1)
	{
		return uint32_t(Max);
	}
	// Value * Max is not exact in double. Error is what the product lost; it decides only where the product sits on a
	// tie.
	const double Product = Value * Max;
	const double Error = std::fma(Value, Max, -Product);
	const double Floor = std::floor(Product);
	const double Fraction = Product - Floor;
	const uint32_t Code = uint32_t(Floor);
	if (Fraction == 0.5)
	{
		return Code + (Error > 0 || (Error == 0 && (Code & 1)) ? 1 : 0);
	}
	return Code + (Fraction > 0.5 ? 1 : 0);
}

double DecodeUnorm(uint32_t Value, int32_t Bits)
{
	return double(Value) / double((1u << Bits) - 1);
}

uint8_t EncodeSrgb8(double Linear)
{
	const auto& Thresholds = GetSrgbTables().Thresholds;
	if (!(Linear > 0))
	{
		return 0; // NaN too
	}
	return uint8_t(std::ranges::lower_bound(Thresholds, static_cast<long double>(Linear)) - Thresholds.begin());
}

double DecodeSrgb8(uint8_t Code)
{
	return GetSrgbTables().Values[Code];
}

void EncodeTexel(ETexelStorage Storage, const float RGBA[4], void* Texel, bool bSaturate)
{
	EncodeReal(Storage, RGBA, Texel, bSaturate);
}

void EncodeTexel(ETexelStorage Storage, const double RGBA[4], void* Texel, bool bSaturate)
{
	EncodeReal(Storage, RGBA, Texel, bSaturate);
}

void EncodeTexel(ETexelStorage Storage, const uint32_t RGBA[4], void* Texel)
{
	const FTexelStorageInfo& Info = GetTexelStorageInfo(Storage);
	const uint32_t Max = uint32_t((1ull << Info.BitsPerChannel) - 1);
	const int32_t Bytes = Info.BitsPerChannel / 8;
	for (int32_t Channel = 0; Channel < Info.NumChannels; ++Channel)
	{
		const uint32_t Code = std::min(RGBA[Channel], Max);
		std::memcpy(static_cast<uint8_t*>(Texel) + Channel * Bytes, &Code, size_t(Bytes));
	}
}

void DecodeTexel(ETexelStorage Storage, const void* Texel, float OutRGBA[4])
{
	DecodeReal(Storage, Texel, OutRGBA);
}

void DecodeTexel(ETexelStorage Storage, const void* Texel, double OutRGBA[4])
{
	DecodeReal(Storage, Texel, OutRGBA);
}

void DecodeTexel(ETexelStorage Storage, const void* Texel, uint32_t OutRGBA[4])
{
	uint32_t Codes[4] = {0, 0, 0, 1};
	LoadCodes(GetTexelStorageInfo(Storage), Texel, Codes);
	std::copy(Codes, Codes + 4, OutRGBA);
}

ETexelStorage WidenTexelStorage(ETexelStorage Storage, bool b64Bit)
{
	const FTexelStorageInfo& Info = GetTexelStorageInfo(Storage);
	if (Info.Kind == ETexelKind::Uint || Info.BitsPerChannel > (b64Bit ? 64 : 32))
	{
		return Storage;
	}
	const ETexelStorage First = b64Bit ? ETexelStorage::R64_FLOAT : ETexelStorage::R32_FLOAT;
	return ETexelStorage(uint8_t(First) + Info.NumChannels - 1);
}

} // namespace Drydock
