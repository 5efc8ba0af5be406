// The built-in kernels: energy, symmetry, and what tells them apart.
#include <gtest/gtest.h>

#include "Screen/BuiltinTextures.h"

#include <string>
#include <vector>

class BuiltinKernels : public testing::TestWithParam<std::string>
{
};
INSTANTIATE_TEST_SUITE_P(Names, BuiltinKernels, testing::ValuesIn(Drydock::GetBuiltinTextureNames()),
	[](const testing::TestParamInfo<std::string>& Info) { return Info.param.substr(8); });

TEST_P(BuiltinKernels, SumToOneWithMostInTheMiddle)
{
	const std::vector<float> Kernel = Drydock::MakeBuiltinKernel(GetParam());
	ASSERT_EQ(size_t(513 * 513), Kernel.size());
	double Sum = 0;
	for (const float Value : Kernel)
	{
		ASSERT_GE(Value, 0.0f);
		Sum += double(Value);
	}
	EXPECT_NEAR(1, Sum, 1e-5);
	EXPECT_NEAR(13.0 / 15, double(Kernel[256 * 513 + 256]), 1e-6);
}

TEST_P(BuiltinKernels, AreTheSameUpsideDownAndMirrored)
{
	const std::vector<float> Kernel = Drydock::MakeBuiltinKernel(GetParam());
	for (const int Offset : {1, 8, 100, 200})
	{
		EXPECT_NEAR(1, Kernel[(256 + Offset) * 513 + 256] / Kernel[(256 - Offset) * 513 + 256], 1e-4) << Offset;
		EXPECT_NEAR(1, Kernel[256 * 513 + 256 + Offset] / Kernel[256 * 513 + 256 - Offset], 1e-4) << Offset;
	}
}

TEST_P(BuiltinKernels, AreBlackInTheCorners)
{
	EXPECT_EQ(0.0f, Drydock::MakeBuiltinKernel(GetParam())[0]);
}

TEST(BuiltinKernel, TheFirstDarkRingOfAiry)
{
	// At 256.5 / 32 = 8.0156 texels from the middle.
	const std::vector<float> Kernel = Drydock::MakeBuiltinKernel("Builtin/Airy");
	EXPECT_LT(Kernel[256 * 513 + 256 + 8], 1e-4f * Kernel[256 * 513 + 256 + 1]);
	EXPECT_GT(Kernel[256 * 513 + 256 + 11], 1e-2f * Kernel[256 * 513 + 256 + 1]);
}

TEST(BuiltinKernel, OthersAreUnknown)
{
	EXPECT_TRUE(Drydock::MakeBuiltinKernel("Builtin/Square").empty());
}
