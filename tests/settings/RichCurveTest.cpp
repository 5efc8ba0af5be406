// Curves by their keys: evaluated as the engine does, and the text that stands for them in settings.
#include <gtest/gtest.h>

#include "CurveKeys.h"
#include "SettingObjects.h"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace Drydock;

namespace
{

FRichCurve Make(const std::string& Text)
{
	const std::optional<FRichCurve> Curve = ReadCurveKeys(Text);
	EXPECT_TRUE(Curve.has_value()) << Text;
	return Curve.value_or(FRichCurve());
}

} // namespace

TEST(RichCurve, LinearAndConstantBetweenKeysAndConstantBeyondThem)
{
	const FRichCurve Linear = Make("linear(-4 1, 0 0, 4 -2)");
	EXPECT_EQ(1.0f, Linear.Eval(-100));
	EXPECT_EQ(0.75f, Linear.Eval(-3));
	EXPECT_EQ(0.0f, Linear.Eval(0));
	EXPECT_EQ(-0.5f, Linear.Eval(1));
	EXPECT_EQ(-2.0f, Linear.Eval(4));
	EXPECT_EQ(-2.0f, Linear.Eval(std::numeric_limits<float>::infinity()));
	const FRichCurve Constant = Make("constant(-4 1, 0 0, 4 -2)");
	EXPECT_EQ(1.0f, Constant.Eval(-0.001f));
	EXPECT_EQ(0.0f, Constant.Eval(0));
	EXPECT_EQ(-2.0f, Constant.Eval(5));
	EXPECT_EQ(3.0f, Make("cubic(7 3)").Eval(0));
}

TEST(RichCurve, WithoutKeysOrTimeItIsTheDefault)
{
	EXPECT_EQ(0.0f, FRichCurve().Eval(1));
	EXPECT_EQ(5.0f, FRichCurve().Eval(1, 5));
	EXPECT_EQ(5.0f, Make("linear(0 1, 1 2)").Eval(std::nanf(""), 5));
}

TEST(RichCurve, CubicIsHermitesPieceByTheSlopeOfTheNeighbours)
{
	std::mt19937 Random(20240607);
	std::uniform_real_distribution<double> Step(0.1, 3), Value(-4, 4), Part(0, 1);
	for (int Curve = 0; Curve < 50; ++Curve)
	{
		std::vector<double> Times = {Value(Random)}, Values = {Value(Random)};
		for (int Key = 1; Key < 5; ++Key)
		{
			Times.push_back(Times.back() + Step(Random));
			Values.push_back(Value(Random));
		}
		FRichCurve Made;
		for (size_t Key = 0; Key < Times.size(); ++Key)
		{
			Made.Keys.Add({RCIM_Cubic, static_cast<float>(Times[Key]), static_cast<float>(Values[Key]), 0, 0});
		}
		Made.AutoSetTangents();
		const auto Slope = [&](size_t Key)
		{
			const bool bEnd = Key == 0 || Key + 1 == Times.size();
			return bEnd ? 0.0 : (Values[Key + 1] - Values[Key - 1]) / (Times[Key + 1] - Times[Key - 1]);
		};
		for (size_t Key = 0; Key + 1 < Times.size(); ++Key)
		{
			const double T = Part(Random), Length = Times[Key + 1] - Times[Key];
			const double Expected =
				(2 * T * T * T - 3 * T * T + 1) * Values[Key] + (T * T * T - 2 * T * T + T) * Length * Slope(Key) +
				(3 * T * T - 2 * T * T * T) * Values[Key + 1] + (T * T * T - T * T) * Length * Slope(Key + 1);
			EXPECT_NEAR(Expected, Made.Eval(static_cast<float>(Times[Key] + T * Length)), 3e-4);
		}
	}
}

TEST(CurveKeys, TextIsReadAsItIsWritten)
{
	for (const char* Text : {"linear(0 1)", "constant(-4 1, 0 0.1, 4 -2)", "cubic(-1e-07 3.4e+38, 65504 0.333333)"})
	{
		EXPECT_EQ(Text, WriteCurveKeys(Make(Text)));
		EXPECT_EQ(Text, WriteCurveKeys(FindCurveKeys(FindOrAddCurve(Text)).value()));
	}
}

TEST(CurveKeys, OtherTextsAreNoKeys)
{
	for (const char* Text :
		{"", "None", "/Game/C.C", "linear", "linear()", "linear(0)", "linear(0 1", "linear(0 1) ", "linear(0 1,1 2)",
			"linear(1 1, 1 2)", "linear(1 1, 0 2)", "linear(nan 1)", "linear(0 inf)", "spline(0 1)"})
	{
		EXPECT_FALSE(ReadCurveKeys(Text).has_value()) << Text;
	}
	EXPECT_FALSE(FindCurveKeys(nullptr).has_value());
	EXPECT_FALSE(FindCurveKeys(FindOrAddCurve("/Game/C.C")).has_value());
}
