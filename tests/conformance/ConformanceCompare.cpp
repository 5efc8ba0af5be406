// Exact bits, distances in units of the last place and absolute ones, for floats of 16, 32 and 64 bits.
#include "ConformanceCompare.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

namespace Drydock::Conformance
{

namespace
{

/** A value of 16 bits as a double, which has all of them. */
double DecodeHalf(uint16_t Bits)
{
	const int Exponent = Bits >> 10 & 31;
	const int Fraction = Bits & 1023;
	const double Sign = Bits >> 15 ? -1.0 : 1.0;
	if (Exponent == 31)
	{
		return Fraction ? std::numeric_limits<double>::quiet_NaN() : Sign * std::numeric_limits<double>::infinity();
	}
	return Sign * (Exponent == 0 ? std::ldexp(Fraction, -24) : std::ldexp(Fraction + 1024, Exponent - 25));
}

/** One float of a buffer: its value, and its bits as a number that grows with the value. */
struct FFloat
{
	double Value = 0;
	int64_t Order = 0;
	bool bDenormal = false;
};

FFloat ReadFloat(const uint8_t* Data, EFormat Format)
{
	const int Bits = int(GetSize(Format)) * 8;
	uint64_t Word = 0;
	std::memcpy(&Word, Data, GetSize(Format));
	FFloat Result;
	if (Format == EFormat::Float16)
	{
		Result.Value = DecodeHalf(uint16_t(Word));
	}
	else if (Format == EFormat::Float32)
	{
		float Value;
		std::memcpy(&Value, Data, 4);
		Result.Value = double(Value);
		Result.bDenormal = std::fpclassify(Value) == FP_SUBNORMAL;
	}
	else
	{
		std::memcpy(&Result.Value, Data, 8);
		Result.bDenormal = std::fpclassify(Result.Value) == FP_SUBNORMAL;
	}
	const int64_t Magnitude = int64_t(Word & ~(uint64_t(1) << (Bits - 1)));
	Result.Order = Word >> (Bits - 1) & 1 ? -Magnitude : Magnitude;
	return Result;
}

bool IsNear(const FFloat& Actual, const FFloat& Expected, const FResult& Result)
{
	if (Actual.Value == Expected.Value)
	{
		return true;
	}
	if (std::isnan(Actual.Value) || std::isnan(Expected.Value))
	{
		return std::isnan(Actual.Value) && std::isnan(Expected.Value);
	}
	const bool bFlushed =
		Expected.bDenormal && Actual.Value == 0 && std::signbit(Actual.Value) == std::signbit(Expected.Value);
	if (bFlushed && Result.bDenormalMayBeZero)
	{
		return true;
	}
	const double Distance = std::fabs(Actual.Value - Expected.Value);
	if (Result.Rule == ERule::BufferFloatEpsilon)
	{
		return Distance < Result.Epsilon;
	}
	const double Zero = Result.ZeroTolerance;
	if (Zero > 0 && (std::fabs(Actual.Value) <= Zero || std::fabs(Expected.Value) <= Zero))
	{
		return Distance <= Zero;
	}
	const uint64_t Ulps = Actual.Order > Expected.Order ? uint64_t(Actual.Order) - uint64_t(Expected.Order)
														: uint64_t(Expected.Order) - uint64_t(Actual.Order);
	return Ulps <= Result.Ulps;
}

bool IsFloat(EFormat Format)
{
	return Format == EFormat::Float16 || Format == EFormat::Float32 || Format == EFormat::Float64;
}

std::string Describe(const uint8_t* Data, EFormat Format)
{
	uint64_t Word = 0;
	std::memcpy(&Word, Data, GetSize(Format));
	char Text[64];
	if (IsFloat(Format))
	{
		std::snprintf(Text, sizeof Text, "%.9g (0x%llx)", ReadFloat(Data, Format).Value, (unsigned long long)Word);
	}
	else
	{
		std::snprintf(Text, sizeof Text, "0x%llx", (unsigned long long)Word);
	}
	return Text;
}

} // namespace

std::string FindDifference(const FBuffer& Actual, const FBuffer& Expected, const FResult& Result)
{
	const bool bExact = Result.Rule == ERule::BufferExact;
	if (Actual.Members.size() != Expected.Members.size() || (!bExact && Actual.Format != Expected.Format))
	{
		return Actual.Name + " and " + Expected.Name + " are of two kinds";
	}
	const size_t Size = GetSize(Expected.Format);
	for (size_t m = 0; m < Actual.Members.size(); ++m)
	{
		const std::vector<uint8_t>& Left = Actual.Members[m];
		const std::vector<uint8_t>& Right = Expected.Members[m];
		if (Result.bFirstOnly ? Left.size() < Right.size() : Left.size() != Right.size())
		{
			return Actual.Name + " has " + std::to_string(Left.size()) + " bytes, not " + std::to_string(Right.size());
		}
		for (size_t At = 0; At + Size <= Right.size(); At += Size)
		{
			const bool bEqual =
				bExact ? std::memcmp(&Left[At], &Right[At], Size) == 0
					   : IsNear(ReadFloat(&Left[At], Expected.Format), ReadFloat(&Right[At], Expected.Format), Result);
			if (!bEqual)
			{
				return Actual.Name + "[" + std::to_string(At / Size) + "] is " + Describe(&Left[At], Expected.Format) +
					   ", not " + Describe(&Right[At], Expected.Format);
			}
		}
	}
	return {};
}

size_t CountValues(const FBuffer& Buffer)
{
	size_t Bytes = 0;
	for (const std::vector<uint8_t>& Member : Buffer.Members)
	{
		Bytes += Member.size();
	}
	return Bytes / GetSize(Buffer.Format);
}

void ChangeValue(FBuffer& Buffer, size_t Index)
{
	const size_t Size = GetSize(Buffer.Format);
	size_t At = Index * Size;
	size_t Member = 0;
	while (At >= Buffer.Members[Member].size())
	{
		At -= Buffer.Members[Member++].size();
	}
	uint8_t* const Data = &Buffer.Members[Member][At];
	uint64_t Word = 1;
	if (!IsFloat(Buffer.Format))
	{
		std::memcpy(&Word, Data, Size);
		Word ^= 1;
	}
	else if (const double Value = ReadFloat(Data, Buffer.Format).Value; std::isfinite(Value))
	{
		// A power of two that no test's tolerance reaches; what is that large becomes zero.
		static const uint64_t Large16 = 0x7400; // 16384
		static const float Large32 = 0x1p100f;
		static const double Large64 = 0x1p900;
		const void* const Large = Size == 2   ? static_cast<const void*>(&Large16)
								  : Size == 4 ? static_cast<const void*>(&Large32)
											  : static_cast<const void*>(&Large64);
		const bool bLarge = std::fabs(Value) > (Size == 2 ? 4096.0 : Size == 4 ? 0x1p90 : 0x1p800);
		Word = 0;
		std::memcpy(&Word, Large, bLarge ? 0 : Size);
	}
	else
	{
		Word = 0; // neither infinite nor NaN
	}
	std::memcpy(Data, &Word, Size);
}

} // namespace Drydock::Conformance
