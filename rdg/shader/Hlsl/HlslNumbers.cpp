// Reads the numbers of a text: decimal, hexadecimal, octal and real, with HLSL's suffixes, and characters.
#include "HlslConstantMath.h"
#include "HlslConstants.h"

#include <charconv>
#include <limits>

namespace Drydock::Hlsl
{

namespace
{

template<typename Real>
bool ParseReal(std::string_view Text, Real& Value)
{
	const auto [End, Code] = std::from_chars(Text.data(), Text.data() + Text.size(), Value);
	if (Code == std::errc::result_out_of_range)
	{
		// Too small for the type becomes 0, too large infinity.
		const size_t Exponent = Text.find_first_of("eE");
		const size_t First = Text.find_first_not_of("0.");
		const bool bFraction = First > Text.find('.');
		const bool bSmall = Exponent != std::string_view::npos ? Text[Exponent + 1] == '-' : bFraction;
		Value = bSmall ? Real(0) : std::numeric_limits<Real>::infinity();
	}
	return End == Text.data() + Text.size() && Code != std::errc::invalid_argument;
}

std::optional<FNumber> ReadReal(std::string_view Text, std::string& Error, bool bRealHalf)
{
	const char Last = char(Text.back() | 0x20);
	const bool bSuffix = Last == 'f' || Last == 'h' || Last == 'l';
	const std::string_view Digits = Text.substr(0, Text.size() - (bSuffix ? 1 : 0));
	double Exact = 0;
	float Narrow = 0;
	if (!ParseReal(Digits, Exact) || !ParseReal(Digits, Narrow))
	{
		Error = "X3000: syntax error: '" + std::string(Text) +
				"' is not a number; the suffixes of one with a point are f, h and l";
		return std::nullopt;
	}
	const uint64_t Bits = __builtin_bit_cast(uint64_t, Exact);
	if (Last == 'h' && bRealHalf)
	{
		return FNumber{EScalar::Half, ConvertConstantBits(EScalar::LiteralFloat, EScalar::Half, Bits)};
	}
	if (Last == 'f' || Last == 'h')
	{
		return FNumber{Last == 'f' ? EScalar::Float : EScalar::MinFloat, __builtin_bit_cast(uint32_t, Narrow)};
	}
	return FNumber{Last == 'l' ? EScalar::Double : EScalar::LiteralFloat, Bits};
}

std::optional<EScalar> FindIntegerSuffix(std::string_view Suffix)
{
	std::string Small;
	for (const char Letter : Suffix)
	{
		Small += char(Letter | 0x20);
	}
	return Small.empty()                                    ? std::optional(EScalar::LiteralInt)
		   : Small == "l"                                   ? std::optional(EScalar::Int)
		   : Small == "u" || Small == "ul" || Small == "lu" ? std::optional(EScalar::Uint)
		   : Small == "ll"                                  ? std::optional(EScalar::Long)
		   : Small == "ull" || Small == "llu"               ? std::optional(EScalar::Ulong)
															: std::nullopt;
}

/** 'A' or '\n': the code of the character. */
std::optional<FNumber> ReadCharacter(std::string_view Text, std::string& Error)
{
	constexpr std::string_view Escapes = "0abtnvfr\\'\"?";
	constexpr std::string_view Escaped("\0\a\b\t\n\v\f\r\\'\"?", Escapes.size());
	const std::string_view Inner = Text.substr(1, Text.size() - std::min<size_t>(Text.size(), 2));
	if (Inner.size() == 1 && Inner[0] != '\\')
	{
		return FNumber{EScalar::LiteralInt, uint8_t(Inner[0])};
	}
	const size_t Escape = Inner.size() == 2 && Inner[0] == '\\' ? Escapes.find(Inner[1]) : std::string_view::npos;
	if (Escape == std::string_view::npos)
	{
		Error = "X3000: syntax error: " + std::string(Text) + " is not one character";
		return std::nullopt;
	}
	return FNumber{EScalar::LiteralInt, uint8_t(Escaped[Escape])};
}

} // namespace

std::optional<FNumber> ReadNumber(std::string_view Text, std::string& Error, bool bRealHalf)
{
	const bool bHex = Text.starts_with("0x") || Text.starts_with("0X");
	const bool bBinary = Text.starts_with("0b") || Text.starts_with("0B");
	if (Text.empty())
	{
		Error = "X3000: a number is expected";
		return std::nullopt;
	}
	if (Text[0] == '\'')
	{
		return ReadCharacter(Text, Error);
	}
	if (Text == "1.#INF" || Text == "1.#INFf")
	{
		return FNumber{EScalar::Float, 0x7F800000};
	}
	if (!bHex && Text.find_first_of(".eE") != std::string_view::npos)
	{
		return ReadReal(Text, Error, bRealHalf);
	}
	const bool bOctal = !bHex && Text.size() > 1 && Text[0] == '0' && Text[1] >= '0' && Text[1] <= '9';
	const std::string_view Rest = Text.substr(bHex || bBinary ? 2 : 0);
	uint64_t Value = 0;
	const auto [End, Code] = std::from_chars(Rest.data(), Rest.data() + Rest.size(), Value,
		bHex      ? 16
		: bBinary ? 2
		: bOctal  ? 8
				  : 10);
	const std::string_view Suffix = Rest.substr(size_t(End - Rest.data()));
	const std::optional<EScalar> Scalar = FindIntegerSuffix(Suffix);
	if (Code == std::errc::invalid_argument || !Scalar)
	{
		const bool bReal = Suffix == "f" || Suffix == "F" || Suffix == "h" || Suffix == "H";
		const std::string Digits(Rest.substr(0, Rest.size() - Suffix.size()));
		Error = "X3000: syntax error: '" + std::string(Text) + "' is not a number" +
				(bReal       ? "; write " + Digits + ".0" + std::string(Suffix)
					: bOctal ? "; one that begins with 0 is octal and has the digits 0 to 7"
							 : "; the suffixes of integers are u, l, ul, ll and ull");
		return std::nullopt;
	}
	if (Code == std::errc() && *Scalar == EScalar::LiteralInt && !bHex && !bOctal && !bBinary &&
		Value > uint64_t(INT64_MAX))
	{
		return FNumber{EScalar::Ulong, Value}; // as -9223372036854775808 has it
	}
	const bool b32 = *Scalar == EScalar::Int || *Scalar == EScalar::Uint;
	const bool bSigned64 = *Scalar == EScalar::Long || (*Scalar == EScalar::LiteralInt && !bHex && !bOctal && !bBinary);
	const uint64_t Most = b32 ? UINT32_MAX : bSigned64 ? uint64_t(INT64_MAX) : UINT64_MAX;
	if (Code == std::errc::result_out_of_range || Value > Most)
	{
		Error = "X3000: the integer literal " + std::string(Text) + " is too large: the most is " +
				std::to_string(Most) + (Most != UINT64_MAX ? "; up to 18446744073709551615 takes the suffix ull" : "");
		return std::nullopt;
	}
	return FNumber{*Scalar, Value};
}

} // namespace Drydock::Hlsl
