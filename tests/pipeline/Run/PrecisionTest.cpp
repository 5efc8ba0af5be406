// What float arithmetic and the engine's texture formats cost, against double arithmetic of the same shaders with
// 64-bit storage: at the tonemapper's inputs (scene colour and bloom) and after it. The figures are printed.
#include <gtest/gtest.h>

#include "Run/Run.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace Drydock;

namespace
{

FRunResult RunToonBloom(bool bDouble, ERunStorage Storage)
{
	FRunOptions Options;
	Options.ConfigFile = DRYDOCK_TEST_SOURCE_DIR "/configs/toon_bloom.json";
	Options.Dump = {"Bloom1Y"};
	Options.bDouble = bDouble;
	Options.Storage = Storage;
	return RunConfig(Options);
}

/** Largest |a - b| / max(|b|, Floor). */
double MaxRelativeDifference(const FImage& Image, const FImage& Reference, double Floor)
{
	EXPECT_EQ(Reference.Values.size(), Image.Values.size());
	double Largest = 0.0;
	for (size_t Index = 0; Index < Image.Values.size(); ++Index)
	{
		const double Scale = std::max(std::fabs(Reference.Values[Index]), Floor);
		Largest = std::max(Largest, std::fabs(Image.Values[Index] - Reference.Values[Index]) / Scale);
	}
	return Largest;
}

struct FDifference
{
	double SceneLinear;
	double Bloom;
	double Final;
};

FDifference Compare(const char* Name, const FRunResult& Run, const FRunResult& Reference)
{
	const FDifference Difference = {
		MaxRelativeDifference(Run.SceneLinear.ToImage(), Reference.SceneLinear.ToImage(), 1e-3),
		MaxRelativeDifference(Run.Dumps.at(0).Image.ToImage(), Reference.Dumps.at(0).Image.ToImage(), 1e-3),
		MaxRelativeDifference(Run.Final.ToImage(), Reference.Final.ToImage(), 1.0)};
	std::printf("%-22s against double: scene colour %.3g, bloom %.3g (of max(|value|, 1e-3)), final %.3g\n", Name,
		Difference.SceneLinear, Difference.Bloom, Difference.Final);
	return Difference;
}

} // namespace

TEST(Precision, FloatArithmeticStaysWithinItsBoundsAndFormatsCostMore)
{
	const FRunResult Double = RunToonBloom(true, ERunStorage::Default);
	ASSERT_EQ("double", Double.Precision);
	ASSERT_EQ("float64", Double.Storage);
	const FDifference Float32 = Compare("float, 32-bit storage", RunToonBloom(false, ERunStorage::Float32), Double);
	const FDifference Native = Compare("float, native formats", RunToonBloom(false, ERunStorage::Native), Double);
	EXPECT_LT(Float32.SceneLinear, 2e-5);
	EXPECT_LT(Float32.Bloom, 2e-5);
	// A position in the combined table is snapped to 1/256 texel: where float rounds to the other side, the value moves
	// by 1/256 of what two neighbouring colours differ, a fifth at most here.
	EXPECT_LT(Float32.Final, 1e-3);
	EXPECT_GT(Float32.Bloom, 0.0) << "double arithmetic must really be another";
	EXPECT_GT(Native.Bloom, 10.0 * Float32.Bloom);
	EXPECT_GT(Native.Final, 10.0 * Float32.Final);
}
