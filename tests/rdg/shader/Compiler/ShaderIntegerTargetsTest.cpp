// Pixel shaders that return integers: every bit reaches the target, by kernels of every width, with and without quads,
// by the interpreter and by the shader as it is looked into.
#include "ShaderHarness.h"

#include <gtest/gtest.h>

namespace Drydock::Test
{
namespace
{

constexpr int32_t GWidth = 21; // no multiple of a pack
constexpr int32_t GHeight = 3;

using FWords = std::vector<uint32_t>;

/** The words of a target, row by row; Untouched where no pixel was drawn. */
template<typename F>
FWords Collect(const std::string& Text, F Run)
{
	FShaderHarness Harness(Text, "Main", EShaderStage::Pixel);
	Harness.Targets.emplace_back(GWidth, GHeight);
	Run(Harness);
	FWords Words(size_t(GWidth * GHeight * 4));
	for (int32_t i = 0; i < GWidth * GHeight; ++i)
	{
		std::memcpy(&Words[size_t(i) * 4], Harness.Targets[0].Texel(i % GWidth, i / GWidth), 16);
	}
	return Words;
}

/** Expect(x, y, component): what the definition gives. */
template<typename F>
void ExpectWords(const std::string& Text, bool bQuads, F Expect)
{
	FWords Expected;
	for (int32_t i = 0; i < GWidth * GHeight * 4; ++i)
	{
		Expected.push_back(Expect(uint32_t(i / 4 % GWidth), uint32_t(i / 4 / GWidth), i % 4));
	}
	for (const int32_t Lanes : GetLaneCounts())
	{
		EXPECT_EQ(Expected, Collect(Text, [=](FShaderHarness& H) { H.Run(Lanes, GWidth, GHeight); })) << Lanes;
		EXPECT_EQ(Expected, Collect(Text, [=](FShaderHarness& H) { H.Run(Lanes / 2, GWidth, GHeight, 1, true); }))
			<< Lanes;
	}
	EXPECT_EQ(Expected, Collect(Text, [](FShaderHarness& H) { H.RunInspected(GWidth, GHeight); }));
	if (!bQuads)
	{
		EXPECT_EQ(Expected, Collect(Text, [](FShaderHarness& H) { H.RunModel(GWidth, GHeight); }));
	}
}

TEST(ShaderIntegerTargets, EveryBitIsWritten)
{
	// 0x7F800001 and the like: as floats they are numbers that a conversion changes.
	ExpectWords("uint4 Main(float4 P : SV_POSITION) : SV_Target0\n"
				"{ uint X = P.x, Y = P.y; return uint4(X * 0x9E3779B9u, 0x7F800001u + Y, ~X, 16777217u); }\n",
		false,
		[](uint32_t X, uint32_t Y, int C)
		{
			const uint32_t Values[] = {X * 0x9E3779B9u, 0x7F800001u + Y, ~X, 16777217u};
			return Values[C];
		});
}

TEST(ShaderIntegerTargets, MissingComponentsAreZeroAndDiscardedPixelsStay)
{
	ExpectWords("int2 Main(float4 P : SV_POSITION) : SV_Target0\n"
				"{ int X = P.x; if (X % 3 == 1) discard; return int2(-X, 7); }\n",
		false, [](uint32_t X, uint32_t, int C) { return X % 3 == 1 || C > 1 ? 0
														: C == 0            ? 0u - X
																			: 7; });
}

TEST(ShaderIntegerTargets, ByQuads)
{
	ExpectWords("uint Main(float4 P : SV_POSITION) : SV_Target0 { return (uint)(ddx(P.x * P.x) + ddy(P.y)) << 24; }\n",
		true,
		[](uint32_t X, uint32_t, int C)
		{
			const uint32_t Left = X / 2 * 2; // its quad's: (x + 1.5)^2 - (x + 0.5)^2 is 2 x + 2
			return C == 0 ? (2 * Left + 2 + 1) << 24 : 0;
		});
}

} // namespace
} // namespace Drydock::Test
