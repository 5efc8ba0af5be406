// Random expressions of constants, folded and run: the same bits. DRYDOCK_RANDOM_PROGRAMS says how many programs of a
// hundred expressions there are, DRYDOCK_RANDOM_FIRST the first one's seed.
#include "ConstantsCases.h"

#include <algorithm>
#include <cstdlib>

namespace Drydock::Hlsl::Tests
{
namespace
{

constexpr int GConstantsPrograms = 10;
constexpr int GConstantsExpressions = 100;

/** Writes an expression of one kind and size out of the vectors A, B and C of four floats. */
class FConstantsWriter
{
public:
	explicit FConstantsWriter(std::mt19937& InRandom)
		: Random(InRandom)
	{
	}

	/** Kind: f, i, u or b. */
	std::string Write(char Kind, uint32_t Size, int Depth)
	{
		if (Depth == 0)
		{
			return WriteLeaf(Kind, Size);
		}
		std::string Form(PickForm(Kind, Size));
		std::string Text;
		for (size_t At = 0; At < Form.size(); ++At)
		{
			if (Form[At] != '$')
			{
				Text += Form[At];
				continue;
			}
			const char Letter = Form[++At];
			Text += Letter == 'T'                    ? TypeName(Kind, Size)
					: Letter == 'n'                  ? SizeName(Size)
					: Letter >= 'A' && Letter <= 'Z' ? Write(char(Letter - 'A' + 'a'), 1, Depth - 1) // a scalar
													 : Write(Letter, Size, Depth - 1);
		}
		return "(" + Text + ")";
	}

	static std::string TypeName(char Kind, uint32_t Size)
	{
		return (Kind == 'f' ? "float" : Kind == 'i' ? "int" : Kind == 'u' ? "uint" : "bool") + SizeName(Size);
	}

private:
	static std::string SizeName(uint32_t Size) { return Size == 1 ? "" : std::to_string(Size); }

	std::string WriteLeaf(char Kind, uint32_t Size)
	{
		std::string Part(1, "ABC"[Random() % 3]);
		Part += ".";
		for (uint32_t i = 0; i < Size; ++i)
		{
			Part += "xyzw"[Random() % 4];
		}
		static constexpr const char* Floats[] = {"0.5", "2", "-1.25", "3e5", "0"};
		static constexpr const char* Integers[] = {"1", "2", "31", "0", "255"};
		const bool bLiteral = Random() % 4 == 0 && Kind != 'b';
		const std::string Literal = Kind == 'f' ? Floats[Random() % 5] : Integers[Random() % 5];
		return bLiteral      ? "((" + TypeName(Kind, Size) + ")" + Literal + ")"
			   : Kind == 'f' ? Part
			   : Kind == 'b' ? "(" + Part + " < 1)"
			   : Kind == 'i' ? (Random() % 2 ? "asint(" : TypeName(Kind, Size) + "(") + Part + ")"
							 : (Random() % 2 ? "asuint(" : TypeName(Kind, Size) + "(") + Part + ")";
	}

	const char* PickForm(char Kind, uint32_t Size)
	{
		static const std::vector<const char*> Floats = {"$f + $f", "$f - $f", "$f * $f", "$f / $f", "$f % $f", "-$f",
			"+$f", "abs($f)", "floor($f)", "ceil($f)", "trunc($f)", "round($f)", "frac($f)", "sqrt($f)", "rsqrt($f)",
			"rcp($f)", "exp($f)", "exp2($f)", "log($f)", "log2($f)", "log10($f)", "sin($f)", "cos($f)", "tan($f)",
			"asin($f)", "acos($f)", "atan($f)", "sinh($f)", "cosh($f)", "tanh($f)", "degrees($f)", "radians($f)",
			"saturate($f)", "fmod($f, $f)", "atan2($f, $f)", "pow($f, $f)", "step($f, $f)", "min($f, $f)",
			"max($f, $f)", "ldexp($f, $f)", "clamp($f, $f, $f)", "mad($f, $f, $f)", "lerp($f, $f, $f)",
			"smoothstep($f, $f, $f)", "select($b, $f, $f)", "($B ? $f : $f)", "($T)$i", "($T)$u", "($T)$b",
			"f16tof32($u)", "($T)((half$n)$f * (half$n)$f)", "($T)((double$n)$f * (double$n)$f)", "$f * $F", "$F + $f",
			"$f + $i", "$u * $f", "$f + $b", "$f * 0.1", "$f, $f"};
		static const std::vector<const char*> Vectors = {"normalize($f)", "reflect($f, $f)", "refract($f, $f, 0.7)",
			"faceforward($f, $f, $f)", "$f * dot($f, $f)", "$f + length($f)", "$f - distance($f, $f)"};
		static const std::vector<const char*> Integers = {"$i + $i", "$i - $i", "$i * $i", "$i / ($i | 1)",
			"$i % ($i | 1)", "$i & $i", "$i | $i", "$i ^ $i", "~$i", "-$i", "$i << $i", "$i >> $i", "$i << $u",
			"min($i, $i)", "max($i, $i)", "clamp($i, $i, $i)", "mad($i, $i, $i)", "abs($i)", "sign($f)", "sign($i)",
			"reversebits($i)", "($T)$f", "($T)$u", "($T)$b", "asint($u)", "select($b, $i, $i)", "($B ? $i : $i)",
			"($T)((int64_t$n)$i * (int64_t$n)$i >> 9)", "$b + $b", "$i + $I"};
		static const std::vector<const char*> Unsigned = {"$u + $u", "$u - $u", "$u * $u", "$u / ($u | 1)",
			"$u % ($u | 1)", "$u & $u", "$u | $i", "$u ^ $u", "~$u", "-$u", "$u << $u", "$u >> $u", "$u >> $i",
			"min($u, $u)", "max($u, $u)", "clamp($u, $u, $u)", "mad($u, $u, $u)", "countbits($u)", "countbits($i)",
			"firstbithigh($u)", "firstbithigh($i)", "firstbitlow($u)", "reversebits($u)", "($T)$f", "($T)$i", "($T)$b",
			"asuint($i)", "f32tof16($f)", "select($b, $u, $u)", "($B ? $u : $u)",
			"($T)((uint64_t$n)$u * (uint64_t$n)$u >> 7)", "$u + $i", "$u * $U"};
		static const std::vector<const char*> Bools = {"$f < $f", "$f > $f", "$f <= $f", "$f >= $f", "$f == $f",
			"$f != $f", "$i < $i", "$i > $i", "$i <= $u", "$u >= $u", "$u == $u", "$i != $i", "!$b", "!$f",
			"and($b, $b)", "or($b, $b)", "select($b, $b, $b)", "isnan($f)", "isinf($f)", "isfinite($f)", "(bool$n)$f",
			"(bool$n)$i", "($T)any($b)", "($T)all($b)", "($T)($B && $B)", "($T)($B || $B)", "$b == $b", "$b != $b"};
		const std::vector<const char*>& All = Kind == 'f'   ? (Size > 1 && Random() % 6 == 0 ? Vectors : Floats)
											  : Kind == 'i' ? Integers
											  : Kind == 'u' ? Unsigned
															: Bools;
		return All[Random() % All.size()];
	}

	std::mt19937& Random;
};

int ReadConstantsNumber(const char* Name, int Default)
{
	const char* const Asked = std::getenv(Name);
	return Asked ? std::clamp(std::atoi(Asked), 0, 1'000'000) : Default;
}

TEST_F(HlslConstantsRun, RandomExpressions)
{
	const int First = ReadConstantsNumber("DRYDOCK_RANDOM_FIRST", 0);
	const int Last = First + std::max(1, ReadConstantsNumber("DRYDOCK_RANDOM_PROGRAMS", GConstantsPrograms));
	for (int Seed = First; Seed < Last && !HasFailure(); ++Seed)
	{
		SCOPED_TRACE("seed " + std::to_string(Seed));
		Random.seed(uint32_t(Seed));
		FConstantsWriter Writer(Random);
		std::vector<FConstantsCase> Cases;
		for (int i = 0; i < GConstantsExpressions; ++i)
		{
			const char Kind = "ffffiiuub"[Random() % 9];
			const uint32_t Size = 1 + Random() % 4;
			const int Depth = 1 + int(Random() % 4);
			Cases.push_back({"float4", FConstantsWriter::TypeName(Kind, Size), Writer.Write(Kind, Size, Depth)});
		}
		Check(Cases);
		EXPECT_EQ(NumInstructions[0], 0u) << "not everything is folded";
	}
}

} // namespace
} // namespace Drydock::Hlsl::Tests
