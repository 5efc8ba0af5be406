// Numbers of one width made of another. Source: D3D11 functional specification 3.2.2 and 22.11 (conversions saturate, a
// NaN gives 0); IEEE 754 binary16.
#include "SpirvScalarMath.h"

#include <cmath>
#include <limits>

namespace Drydock
{

using namespace Spirv;

namespace
{

/** To the nearest, to even where two are as near. */
uint16_t ToHalfBits(double X)
{
	const uint16_t Sign = std::signbit(X) ? 0x8000 : 0;
	const double Magnitude = std::fabs(X);
	if (Magnitude != Magnitude)
	{
		const uint32_t Bits = __builtin_bit_cast(uint32_t, float(X));
		return uint16_t(Sign | 0x7E00 | ((Bits >> 13) & 0x3FF));
	}
	if (Magnitude >= 65520)
	{
		return Sign | 0x7C00;
	}
	if (Magnitude < 0x1p-14)
	{
		return uint16_t(Sign | uint16_t(std::nearbyint(Magnitude * 0x1p24)));
	}
	int Exponent = 0;
	const double Fraction = std::frexp(Magnitude, &Exponent);  // 0.5 to 1
	const int Mantissa = int(std::nearbyint(Fraction * 2048)); // 1024 to 2048
	return uint16_t(Sign | ((((Exponent + 14) << 10) + Mantissa) - 1024));
}

double FromHalfBits(uint16_t Bits)
{
	const int Exponent = (Bits >> 10) & 31;
	const int Mantissa = Bits & 0x3FF;
	double Magnitude = Exponent == 0 ? Mantissa * 0x1p-24 : std::ldexp(Mantissa + 1024, Exponent - 25);
	if (Exponent == 31)
	{
		const uint32_t Quiet = Mantissa ? 0x7FC00000u | uint32_t(Mantissa) << 13 : 0x7F800000u;
		Magnitude = double(__builtin_bit_cast(float, Quiet));
	}
	return Bits & 0x8000 ? -Magnitude : Magnitude;
}

template<typename To>
To Saturate(double X)
{
	const double Above = std::ldexp(1.0, std::numeric_limits<To>::digits);
	return X != X                                        ? To(0)
		   : X >= Above                                  ? std::numeric_limits<To>::max()
		   : X <= double(std::numeric_limits<To>::min()) ? std::numeric_limits<To>::min()
														 : To(X);
}

uint64_t SaturateTo(ESpirvType Kind, double X)
{
	return Kind == ESpirvType::Short    ? uint32_t(int32_t(Saturate<int16_t>(X)))
		   : Kind == ESpirvType::Ushort ? Saturate<uint16_t>(X)
		   : Kind == ESpirvType::Int    ? uint32_t(Saturate<int32_t>(X))
		   : Kind == ESpirvType::Uint   ? Saturate<uint32_t>(X)
		   : Kind == ESpirvType::Long   ? uint64_t(Saturate<int64_t>(X))
										: Saturate<uint64_t>(X);
}

/** An integer of up to 32 bits as 64 bits, by its sign or with zeros whatever its type says. */
uint64_t Extend(ESpirvType Kind, uint64_t Word, bool bSigned)
{
	const uint32_t Bytes = GetSpirvBytes(Kind);
	const uint32_t Unused = 64 - 8 * Bytes;
	return bSigned ? uint64_t(int64_t(Word << Unused) >> Unused) : (Word << Unused) >> Unused;
}

/** The low bits of an integer as a word of Kind. */
uint64_t MakeInteger(ESpirvType Kind, uint64_t Bits)
{
	const uint64_t Extended = Extend(Kind, Bits, IsSpirvSigned(Kind));
	return GetSpirvBytes(Kind) == 8 ? Extended : uint32_t(Extended);
}

template<typename Real>
double GetNumber(ESpirvType Kind, uint64_t Word)
{
	return Kind == ESpirvType::Double ? ToSpirvReal<double>(Word) : double(ToSpirvReal<Real>(Word));
}

} // namespace

template<typename Real>
uint64_t ConvertSpirv(uint16_t Op, ESpirvType From, ESpirvType To, uint64_t Word)
{
	const bool bSigned = Op == OpConvertSToF || Op == OpSConvert;
	if (!IsSpirvReal(To))
	{
		// The operation sets the range that a real is cut to; its type sets only how the bits are held.
		const ESpirvType Range = Op == OpConvertFToS ? GetSpirvSigned(To) : GetSpirvUnsigned(To);
		const bool bReal = Op == OpConvertFToS || Op == OpConvertFToU;
		return MakeInteger(To, bReal ? SaturateTo(Range, GetNumber<Real>(From, Word)) : Extend(From, Word, bSigned));
	}
	const bool bDouble = To == ESpirvType::Double;
	if (Op == OpFConvert)
	{
		const double Number = GetNumber<Real>(From, Word);
		const double Rounded = To == ESpirvType::Half ? FromHalfBits(ToHalfBits(Number)) : Number;
		return bDouble ? ToSpirvWord<double>(Rounded) : ToSpirvWord<Real>(Real(Rounded));
	}
	const uint64_t Integer = Extend(From, Word, bSigned);
	const Real Narrow = bSigned ? Real(int64_t(Integer)) : Real(Integer);
	const double Exact = bSigned ? double(int64_t(Integer)) : double(Integer);
	return bDouble ? ToSpirvWord<double>(Exact) : ToSpirvWord<Real>(Narrow);
}

template<typename Real>
uint64_t NarrowSpirv(ESpirvType Kind, uint64_t Word)
{
	if (Kind == ESpirvType::Half)
	{
		const double Number = double(ToSpirvReal<Real>(Word));
		constexpr uint16_t NaN = 0x7E00;
		return ToSpirvWord<Real>(Real(FromHalfBits(Number != Number ? NaN : ToHalfBits(Number))));
	}
	return Kind == ESpirvType::Short || Kind == ESpirvType::Ushort ? MakeInteger(Kind, Word) : Word;
}

template<typename Real>
uint64_t ToSpirvMemory(ESpirvType Kind, uint64_t Word)
{
	return Kind == ESpirvType::Float  ? __builtin_bit_cast(uint32_t, float(ToSpirvReal<Real>(Word)))
		   : Kind == ESpirvType::Half ? ToHalfBits(double(ToSpirvReal<Real>(Word)))
		   : GetSpirvBytes(Kind) == 2 ? uint16_t(Word)
									  : Word;
}

template<typename Real>
uint64_t FromSpirvMemory(ESpirvType Kind, uint64_t Bits)
{
	return Kind == ESpirvType::Float  ? ToSpirvWord<Real>(Real(__builtin_bit_cast(float, uint32_t(Bits))))
		   : Kind == ESpirvType::Half ? ToSpirvWord<Real>(Real(FromHalfBits(uint16_t(Bits))))
		   : GetSpirvBytes(Kind) == 2 ? MakeInteger(Kind, Bits)
									  : Bits;
}

template uint64_t ConvertSpirv<float>(uint16_t, ESpirvType, ESpirvType, uint64_t);
template uint64_t ConvertSpirv<double>(uint16_t, ESpirvType, ESpirvType, uint64_t);
template uint64_t NarrowSpirv<float>(ESpirvType, uint64_t);
template uint64_t NarrowSpirv<double>(ESpirvType, uint64_t);
template uint64_t ToSpirvMemory<float>(ESpirvType, uint64_t);
template uint64_t ToSpirvMemory<double>(ESpirvType, uint64_t);
template uint64_t FromSpirvMemory<float>(ESpirvType, uint64_t);
template uint64_t FromSpirvMemory<double>(ESpirvType, uint64_t);

} // namespace Drydock
