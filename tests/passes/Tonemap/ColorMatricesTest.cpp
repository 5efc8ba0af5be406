// The numbers written in ACESCommon.ush and ACES.ush, derived again in double from published primaries.
#include <gtest/gtest.h>

#include "ToneReference.h"

#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace
{

/** The numbers of `static const float3x3 Name = { ... }` or `static const float3 Name = float3(...)`. */
std::vector<double> ReadConstants(const std::string& Name)
{
	std::stringstream Stream;
	for (const char* const File : {"Engine/Private/ACES/ACESCommon.ush", "Drydock/Private/ACES.ush"})
	{
		Stream << std::ifstream(DRYDOCK_TEST_SOURCE_DIR "/rdg/graph/Shaders/" + std::string(File)).rdbuf();
	}
	const std::string Text = Stream.str();

	const size_t Begin = Text.find(Name + " =");
	EXPECT_NE(std::string::npos, Begin) << Name;
	const std::string Body = Text.substr(Begin, Text.find(';', Begin) - Begin);
	const std::regex Number(R"(-?\d+\.\d+)");
	std::vector<double> Values;
	for (std::sregex_iterator Match(Body.begin(), Body.end(), Number), End; Match != End; ++Match)
	{
		Values.push_back(std::stod(Match->str()));
	}
	return Values;
}

void ExpectMatrix(const ToneReference::FMat& Expected, const std::string& Name)
{
	const std::vector<double> Values = ReadConstants(Name);
	ASSERT_EQ(9u, Values.size()) << Name;
	for (int Index = 0; Index < 9; ++Index)
	{
		EXPECT_NEAR(Expected[Index / 3][Index % 3], Values[Index], 1e-10) << Name << " element " << Index;
	}
}

} // namespace

TEST(ColorMatrices, BetweenRec709AndAP1)
{
	ExpectMatrix(ToneReference::Matrices().Rec709ToAP1, "sRGB_2_AP1_MAT");
	ExpectMatrix(ToneReference::Matrices().AP1ToRec709, "AP1_2_sRGB_MAT");
}

TEST(ColorMatrices, FromAP1ToRec2020)
{
	using namespace ToneReference;
	const FMat Rec2020 = ToXYZ({0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, D65);
	ExpectMatrix(Mul(Inverse(Rec2020), Mul(Bradford(AcesWhite, D65), Matrices().AP1)), "AP1_2_Rec2020_MAT");
}

TEST(ColorMatrices, BetweenAP1AndAP0)
{
	ExpectMatrix(ToneReference::Matrices().AP1ToAP0, "AP1_2_AP0_MAT");
	ExpectMatrix(ToneReference::Matrices().AP0ToAP1, "AP0_2_AP1_MAT");
}

TEST(ColorMatrices, BlueCorrectionAndItsInverse)
{
	ExpectMatrix(ToneReference::Matrices().BlueCorrect, "BlueCorrectAP1_MAT");
	ExpectMatrix(ToneReference::Matrices().BlueCorrectInverse, "BlueCorrectInvAP1_MAT");
}

TEST(ColorMatrices, GamutExpansion)
{
	ExpectMatrix(ToneReference::Matrices().ExpandGamut, "ExpandGamutAP1_MAT");
}

TEST(ColorMatrices, LuminanceOfAP1)
{
	const std::vector<double> Values = ReadConstants("AP1_RGB2Y");
	ASSERT_EQ(3u, Values.size());
	for (int Channel = 0; Channel < 3; ++Channel)
	{
		EXPECT_NEAR(ToneReference::Matrices().LuminanceAP1[Channel], Values[Channel], 1e-10);
	}
}

TEST(ColorMatrices, PublishedMatrixOfRec709)
{
	// IEC 61966-2-1, to its printed digits.
	const double Published[3][3] = {{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}};
	for (int Index = 0; Index < 9; ++Index)
	{
		EXPECT_NEAR(Published[Index / 3][Index % 3], ToneReference::Matrices().Rec709[Index / 3][Index % 3], 6e-5);
	}
}
