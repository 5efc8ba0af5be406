// Half precision: the bits of a float, rounded to eleven digits.
#include "Math/Float16.h"

#include <bit>
#include <cmath>

void FFloat16::Set(float Value)
{
	const uint32 Bits = std::bit_cast<uint32>(Value);
	const uint16 Sign = static_cast<uint16>(Bits >> 16 & 0x8000u);
	const float Magnitude = std::fabs(Value);
	if (std::isnan(Value))
	{
		Encoded = static_cast<uint16>(Sign | 0x7e00u);
	}
	else if (Magnitude >= 65520.0f) // halfway between the greatest half and what would follow it
	{
		Encoded = static_cast<uint16>(Sign | 0x7c00u);
	}
	else if (Magnitude < 6.103515625e-05f) // 2^-14: below, steps are 2^-24
	{
		Encoded = static_cast<uint16>(Sign | Drydock::ToInteger<uint16>(std::nearbyint(Magnitude * 16777216.0f)));
	}
	else
	{
		// Half of a step, less one if the digit before is even: adding it carries into the exponent where it must.
		const uint32 Positive = Bits & 0x7fffffffu;
		const uint32 Rounded = Positive + 0xfffu + (Positive >> 13 & 1u);
		Encoded = static_cast<uint16>(Sign | ((Rounded - (112u << 23)) >> 13));
	}
}

float FFloat16::GetFloat() const
{
	const uint32 Sign = static_cast<uint32>(Encoded & 0x8000u) << 16;
	const uint32 Exponent = Encoded >> 10 & 0x1fu;
	const uint32 Mantissa = Encoded & 0x3ffu;
	if (Exponent == 0)
	{
		const float Magnitude = static_cast<float>(Mantissa) / 16777216.0f;
		return Sign != 0 ? -Magnitude : Magnitude;
	}
	const uint32 Wide = Exponent == 31 ? 255u : Exponent + 112u;
	return std::bit_cast<float>(Sign | Wide << 23 | Mantissa << 13);
}
