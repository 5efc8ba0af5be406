// Values of a line for every thread, held against what the line says by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Diagnostics.h"
#include "InspectTestUtils.h"
#include "LineValues.h"

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::HasSubstr;

std::optional<FLineValues> Collect(FShaderHarness& Harness, const std::string& Place, std::string& Problem)
{
	FInspectedShader& Shader = Harness.Inspect();
	return CollectLineValues(
		Shader, MakeBound(Harness), Harness.GetArgs(), InspectWhole, ParseLinePlace(Place), Problem);
}

FLineValues Collect(FShaderHarness& Harness, const std::string& Place)
{
	std::string Problem;
	std::optional<FLineValues> Values = Collect(Harness, Place, Problem);
	EXPECT_TRUE(Values) << Problem;
	return Values.value_or(FLineValues());
}

std::string FindProblem(FShaderHarness& Harness, const std::string& Place)
{
	std::string Problem;
	EXPECT_FALSE(Collect(Harness, Place, Problem));
	return Problem;
}

TEST(LineValues, GivesWhatALineStores)
{
	FShaderHarness Harness = MakeInspectedPixel("float2 Sum = SvPosition.xy * 2;\nSum.y += 1;\nOutColor = Sum.xyxy;");
	const FLineValues Values = Collect(Harness, "Shader.usf:6");
	EXPECT_EQ("Sum", Values.Variable);
	EXPECT_EQ("/Test/Shader.usf", Values.File);
	ASSERT_EQ(2, Values.NumChannels);
	ASSERT_EQ(size_t(InspectWidth * InspectHeight * 2), Values.Values.size());
	for (int Y = 0; Y < InspectHeight; ++Y)
	{
		for (int X = 0; X < InspectWidth; ++X)
		{
			const size_t At = size_t(Y * InspectWidth + X);
			EXPECT_EQ(1, Values.bReached[At]);
			EXPECT_EQ(2 * (float(X) + 0.5f), Values.Values[2 * At]);
			EXPECT_EQ(2 * (float(Y) + 0.5f) + 1, Values.Values[2 * At + 1]);
		}
	}
}

TEST(LineValues, OfALoopTheLastRoundAndOnlyWhereItRan)
{
	FShaderHarness Harness = MakeInspectedPixel("int Sum = 0;\nfor (int i = 0; i < int(SvPosition.x); ++i)\n{\n"
												"\tSum += i - 2;\n}\nOutColor = Sum;");
	const FLineValues Values = Collect(Harness, "/Test/Shader.usf:8");
	for (int X = 0; X < InspectWidth; ++X)
	{
		EXPECT_EQ(X > 0, Values.bReached[size_t(X)] == 1) << X;
		EXPECT_EQ(float(X * (X - 1) / 2 - 2 * X), Values.Values[size_t(X)]) << X;
	}
}

TEST(LineValues, AVariableThatTheLineOnlyReads)
{
	FShaderHarness Harness =
		MakeInspectedPixel("float Half = 0.5 * SvPosition.x;\nfloat Other = 7;\nOutColor = Half + Other;");
	const FLineValues Values = Collect(Harness, "Shader.usf:7:Half");
	EXPECT_EQ("Half", Values.Variable);
	EXPECT_EQ(0.5f * 3.5f, Values.Values[3]);
	EXPECT_EQ("OutColor", Collect(Harness, "Shader.usf:7").Variable);
}

TEST(LineValues, AReturnValueOfAFunction)
{
	FShaderHarness Harness =
		MakeInspectedPixel("OutColor = Twice(SvPosition.y);", "float Twice(float X) { return 2 * X; } ");
	const FLineValues Values = Collect(Harness, "Shader.usf:1");
	EXPECT_EQ("return", Values.Variable);
	EXPECT_EQ(3.0f, Values.Values[InspectWidth]);
}

TEST(LineValues, WhatALineWritesToATexture)
{
	FShaderHarness Harness("RWTexture2D<float4> Out;\n[numthreads(2, 2, 1)]\n"
						   "void MainCS(uint3 Id : SV_DispatchThreadID)\n{\n\tOut[Id.xy] = float4(Id, 9);\n}\n",
		"MainCS", EShaderStage::Compute);
	Harness.Textures["Out"] = FTestTexture(InspectWidth, InspectHeight);
	const FLineValues Values = Collect(Harness, "Shader.usf:5");
	ASSERT_EQ(4, Values.NumChannels);
	const size_t At = 4 * size_t(2 * InspectWidth + 5);
	EXPECT_EQ(5.0f, Values.Values[At]);
	EXPECT_EQ(2.0f, Values.Values[At + 1]);
	EXPECT_EQ(9.0f, Values.Values[At + 3]);
	EXPECT_EQ(0.0f, Harness.Textures["Out"].Texel(5, 2)[3]) << "the picture stays as it is";
}

TEST(LineValues, SaysWhatThereIsInstead)
{
	FShaderHarness Harness = MakeInspectedPixel("float Half = 0.5;\n\nOutColor = Half;");
	EXPECT_EQ("Shader.usf:6 computes no value; lines near it that do: 5 (Half), 7 (OutColor)",
		FindProblem(Harness, "Shader.usf:6"));
	EXPECT_THAT(FindProblem(Harness, "Shader.usf:7:Halv"), HasSubstr("has no variable 'Halv'; there are "));
	EXPECT_THAT(FindProblem(Harness, "Shader.usf:7:Halv"), HasSubstr("Half"));
	EXPECT_EQ("", FindProblem(Harness, "hader.usf:6"));
	for (const char* const Wrong : {"", "X.usf", "X.usf:", "X.usf:0", "X.usf:4x", ":4", "X.usf:-1"})
	{
		EXPECT_THROW(ParseLinePlace(Wrong), FError) << Wrong;
	}
}

} // namespace
