// How far numbers may be moved, where it can be said by hand: the tolerances of the oracles.
#include <gtest/gtest.h>

#include "MovedModel.h"
#include "ShaderCompiler.h"

#include <cmath>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

constexpr double Ulp4 = 0x1p-21; // of floats in [4, 8)

struct FModelOf
{
	FModelOf(const std::string& Text, const std::string& Entry, EShaderStage Stage)
		: Request(MakeRequest(Text, Entry, Stage))
		, Reflection(ReflectShader(Request))
		, Shader(Request, Reflection, true)
		, Model(Shader, Reflection, EMadePictures::Smooth)
	{
	}

	static FShaderCompileRequest MakeRequest(const std::string& Text, const std::string& Entry, EShaderStage Stage)
	{
		FShaderCompileRequest Request;
		Request.VirtualPath = "/Test/Shader.usf";
		Request.GeneratedFiles = {{Request.VirtualPath, Text}};
		Request.EntryPoint = Entry;
		Request.Stage = Stage;
		return Request;
	}

	const FShaderCompileRequest Request;
	const FShaderReflection Reflection;
	FInspectedShader Shader;
	const FMovedModel Model;
};

size_t GetNumber(int32_t X, int32_t Y, size_t Channel)
{
	return size_t(Y * GMadeSizeX + X) * 4 + Channel;
}

} // namespace

TEST(MovedModel, OperationsTogetherGoAsFarAsTheSumOfEach)
{
	const FModelOf Of(R"(
void MainPS(float4 P : SV_POSITION, out float4 OutColor : SV_Target0)
{
	const float Once = P.x + 1;
	OutColor = float4(Once, Once + P.y, 1 / (P.x + P.y), max(P.x, P.y));
}
)",
		"MainPS", EShaderStage::Pixel);
	const FMovedModel& Model = Of.Model;
	EXPECT_EQ(5.5, Model.GetNumbers()[GetNumber(4, 0, 0)]);
	EXPECT_EQ(Ulp4, Model.FindFarthest(GetNumber(4, 0, 0)));
	EXPECT_EQ(2 * Ulp4, Model.FindFarthest(GetNumber(4, 0, 1)));
	EXPECT_EQ(0, Model.FindFarthest(GetNumber(4, 0, 3))); // a choice, and SV_Position is exact
	// 1 / 5: 2.5 ulp of its own, and what an ulp of 5 makes; the differences are of numbers that are rounded.
	EXPECT_NEAR(2.5 * 0x1p-26 + Ulp4 / 25, Model.FindFarthest(GetNumber(4, 0, 2)), 2 * 0x1p-26 / FMoves::AloneBy);

	bool bWentAway = false;
	for (uint32_t Seed = 1; Seed < 5; ++Seed)
	{
		const std::vector<double> Walk = Model.Walk(Seed);
		for (size_t Channel = 0; Channel < 4; ++Channel)
		{
			const size_t Number = GetNumber(4, 0, Channel);
			const double Distance = std::fabs(Walk[Number] - Model.GetNumbers()[Number]);
			bWentAway |= Distance > 0;
			EXPECT_LE(Distance, 2 * Model.FindFarthest(Number)) << Channel; // its own roundings come to it
		}
	}
	EXPECT_TRUE(bWentAway);
}

TEST(MovedModel, APowerOfZeroIsThatOfAnyNumberThatMayBeFlushed)
{
	const FModelOf Of(R"(
void MainPS(float4 P : SV_POSITION, out float4 OutColor : SV_Target0)
{
	const float Zero = max(P.x - 100, 0);
	OutColor = float4(pow(Zero, 0.25f), exp2(0.25f * log2(Zero)), pow(P.x, 0.25f), 0);
}
)",
		"MainPS", EShaderStage::Pixel);
	const double Most = std::exp2(-126 * 0.25);
	EXPECT_EQ(0, Of.Model.GetNumbers()[0]);
	EXPECT_NEAR(Most, Of.Model.FindFarthest(0), Most * 0x1p-23);
	EXPECT_EQ(0, Of.Model.GetNumbers()[1]);
	EXPECT_NEAR(Most, Of.Model.FindFarthest(1), Most * 0x1p-20);
	// 0.5^0.25: 0.25 * 2^-21 and a rounding in the exponent, 3 + 2 * 0.25 ulp of the result.
	const double Power = std::pow(0.5, 0.25);
	EXPECT_NEAR(3.5 * 0x1p-24 + Power * std::log(2.0) * (0x1p-23 + 0x1p-25), Of.Model.FindFarthest(2), 0x1p-26);
}

TEST(MovedModel, ThreadsMoveWhatOthersRead)
{
	const FModelOf Of(R"(
RWStructuredBuffer<float> Out;
groupshared float Shared[8];
[numthreads(8, 1, 1)]
void MainCS(uint I : SV_GroupIndex, uint3 Id : SV_DispatchThreadID)
{
	Shared[I] = float(I) + 0.5f;
	GroupMemoryBarrierWithGroupSync();
	Out[Id.x] = Shared[I ^ 1];
}
)",
		"MainCS", EShaderStage::Compute);
	EXPECT_EQ(5.5, Of.Model.GetNumbers()[4]);
	EXPECT_EQ(2 * Ulp4, Of.Model.FindFarthest(4)); // the conversion and the sum of thread 5
}
