// Counts of lines and costs of threads of shaders that one can count by hand.
#include <gtest/gtest.h>

#include "CostMap.h"
#include "InspectTestUtils.h"
#include "LineCoverage.h"

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

TEST(LineCoverage, CountsThreadsNotRounds)
{
	FShaderHarness Harness = MakeInspectedPixel("OutColor = 0;\nif (SvPosition.x > 4)\n{\n\tOutColor = 1;\n}\n"
												"for (int i = 0; i < 3; ++i)\n{\n\tOutColor += i;\n}\n"
												"if (Zero > 0)\n{\n\tOutColor = 2;\n}");
	FInspectedShader& Shader = Harness.Inspect();
	const FLineCoverage Coverage = CollectLineCoverage(Shader, MakeBound(Harness), Harness.GetArgs(), InspectWhole);
	EXPECT_EQ(24u, Coverage.Threads);
	const std::map<int, FLineCount>& Lines = Coverage.Files.at("/Test/Shader.usf");
	EXPECT_EQ(24u, Lines.at(5).Threads);
	EXPECT_EQ(8u, Lines.at(8).Threads) << "two columns of four";
	EXPECT_EQ(24u, Lines.at(12).Threads) << "three rounds each";
	EXPECT_EQ(0u, Lines.at(16).Threads);
	EXPECT_EQ(0u, Lines.count(7)) << "a brace";
	FLineCoverage Twice = Coverage;
	AddCoverage(Twice, Coverage);
	EXPECT_EQ(16u, Twice.Files.at("/Test/Shader.usf").at(8).Threads);
	EXPECT_EQ(48u, Twice.Threads);
}

TEST(CostMap, CountsTapsAndOperationsOfEachThread)
{
	FShaderHarness Harness = MakeInspectedPixel("float4 Sum = 0;\n[loop] for (int i = 0; i < int(SvPosition.x); ++i)\n"
												"{\n\tSum += Source.Load(int3(i, 0, 0));\n}\nOutColor = Sum;");
	Harness.Inspect();
	FInspectedShader Kernel(Harness.Request, Harness.GetReflection(), true);
	const FCostMap Map = MakeCostMap(Kernel, MakeBound(Harness), Harness.GetArgs(), InspectWhole);
	ASSERT_EQ(size_t(InspectWidth * InspectHeight), Map.Taps.size());
	const uint64_t Round = Map.Operations[1] - Map.Operations[0];
	EXPECT_LE(4u, Round) << "four additions at least";
	for (int X = 0; X < InspectWidth; ++X)
	{
		EXPECT_EQ(uint64_t(X), Map.Taps[size_t(X)]);
		EXPECT_EQ(Map.Operations[0] + uint64_t(X) * Round, Map.Operations[size_t(X)]);
		EXPECT_EQ(Map.Operations[size_t(X)], Map.Operations[size_t(X + 3 * InspectWidth)]);
	}
}

} // namespace
