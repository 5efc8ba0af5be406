// What public test suites once found wrong or refused without a reason, each in its smallest form: the numbers are
// worked out by hand, and the interpreter computes what the kernels do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ShaderHarness.h"

#include <cmath>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

/** The first four words of Out, by the kernels of every lane count and by the interpreter. */
void ExpectOut(const std::string& Globals, const std::string& Body, const std::vector<float>& Expected)
{
	FShaderHarness Harness(
		"RWStructuredBuffer<float> Out;\n" + Globals +
			"\n[numthreads(1, 1, 1)] void Main(uint3 Id : SV_DispatchThreadID)\n{\n\tuint u = Id.x + 1; "
			"int n = Id.x + 1; float x = Id.x + 1;\n" +
			Body + "\n}\n",
		"Main", EShaderStage::Compute);
	const auto Check = [&](const std::string& How)
	{
		for (size_t i = 0; i < Expected.size(); ++i)
		{
			const float Value = Harness.BufferFloat("Out", i);
			EXPECT_NEAR(Expected[i], Value, 1e-6f * std::fabs(Expected[i])) << How << ", value " << i;
		}
	};
	const auto Reset = [&]
	{
		Harness.Buffers["Out"].assign(4, 0);
		Harness.Buffers["Bytes"] = {1, 2, 3};
	};
	for (const int32_t Lanes : GetLaneCounts())
	{
		Reset();
		Harness.Run(Lanes, 1, 1);
		Check(std::to_string(Lanes) + " lanes");
	}
	Reset();
	Harness.RunModel(1, 1);
	Check("interpreter");
}

std::string ErrorsOf(const std::string& Globals, const std::string& Body)
{
	return ErrorOf(
		[&]
		{
			ReflectShader(FShaderHarness("RWStructuredBuffer<float> Out;\n" + Globals +
											 "\n[numthreads(1, 1, 1)] void Main(uint3 Id : SV_DispatchThreadID)\n{\n" +
											 Body + "\n}\n",
				"Main", EShaderStage::Compute)
							  .Request);
		});
}

} // namespace

TEST(ConformanceFaults, MadOfIntegersIsExact)
{
	ExpectOut("", "\tOut[0] = mad(n * 3, 5, 7); Out[1] = mad(u * 16777217u, 1u, 0u) == 16777217u;", {22, 1});
}

TEST(ConformanceFaults, ByteBuffersHaveTheirSizeInBytes)
{
	ExpectOut("ByteAddressBuffer Bytes;", "\tuint Size; Bytes.GetDimensions(Size); Out[0] = Size;", {12});
}

TEST(ConformanceFaults, DeepNestingIsCounted)
{
	std::string Body;
	for (int i = 0; i < 30; ++i)
	{
		Body += "\tif (Id.x > " + std::to_string(i) + "u) {";
	}
	Body += " Out[Id.x] = Texture.Load(int3(Id.x, 0, 0)).x; " + std::string(30, '}');
	EXPECT_EQ("", ErrorsOf("Texture2D<float4> Texture;", Body));
}

TEST(ConformanceFaults, DeterminantFaceforwardAndRefractHaveAModel)
{
	ExpectOut("",
		"Out[0] = determinant(float2x2(x, 2, 3, 4));\nOut[1] = determinant(float3x3(2, 0, 1, 0, 3, 0, 0, 0, x * 4));\n"
		"Out[2] = faceforward(float3(1, 2, 3), float3(0, 0, -1) * x, float3(0, 0, 1)).y;\n"
		"Out[3] = refract(float3(0, 0, -1) * x, float3(0, 0, 1), 0.5f).z;",
		{-2, 24, 2, -1});
}

TEST(ConformanceFaults, AStructIsStoredIntoABufferAsAWhole)
{
	const std::string Text =
		"struct FItem { float A; float2 B; uint C[2]; };\nRWStructuredBuffer<FItem> Items;\n"
		"[numthreads(4, 1, 1)] void Main(uint3 Id : SV_DispatchThreadID)\n{\n\tFItem Item;\n"
		"\tItem.A = Id.x;\n\tItem.B = float2(Id.x, 3) * 2;\n\tItem.C[0] = Id.x + 7;\n\tItem.C[1] = 9;\n"
		"\tItems[3 - Id.x] = Item;\n\tItems[3 - Id.x].C[Id.x & 1] += 1;\n}\n";
	for (const bool bModel : {false, true})
	{
		FShaderHarness Harness(Text, "Main", EShaderStage::Compute);
		Harness.Buffers["Items"].assign(20, 0);
		bModel ? Harness.RunModel(4, 1) : void(Harness.Run(0, 4, 1));
		for (uint32_t i = 0; i < 4; ++i)
		{
			const size_t At = size_t(3 - i) * 5;
			EXPECT_EQ(float(i), Harness.BufferFloat("Items", At));
			EXPECT_EQ(float(i) * 2, Harness.BufferFloat("Items", At + 1));
			EXPECT_EQ(6.0f, Harness.BufferFloat("Items", At + 2));
			EXPECT_EQ(i + 7 + (i % 2 == 0), Harness.Buffers["Items"][At + 3]);
			EXPECT_EQ(9u + i % 2, Harness.Buffers["Items"][At + 4]);
		}
	}
}

TEST(ConformanceFaults, LoadsAndSamplesWithAnOffsetHaveAModel)
{
	const std::string Text =
		"Texture2D<float4> In;\nSamplerState InSampler;\nRWStructuredBuffer<float> Out;\n"
		"[numthreads(1, 1, 1)] void Main(uint3 Id : SV_DispatchThreadID)\n{\n"
		"\tOut[Id.x * 2] = In.Load(int3(Id.x, 0, 0), int2(1, 1)).x;\n"
		"\tOut[Id.x * 2 + 1] = In.SampleLevel(InSampler, float2((Id.x + 0.5f) / 4, 0.25f), 0, int2(1, 1)).x;\n}\n";
	for (const bool bModel : {false, true})
	{
		FShaderHarness Harness(Text, "Main", EShaderStage::Compute);
		Harness.Textures["In"] = FTestTexture(4, 2);
		for (int32_t i = 0; i < 8; ++i)
		{
			*Harness.Textures["In"].Texel(i % 4, i / 4) = float(i);
		}
		Harness.Buffers["Out"].assign(6, 0);
		bModel ? Harness.RunModel(3, 1) : void(Harness.Run(0, 3, 1));
		for (size_t i = 0; i < 3; ++i)
		{
			EXPECT_EQ(float(i + 5), Harness.BufferFloat("Out", i * 2)) << (bModel ? "interpreter" : "kernel");
			EXPECT_EQ(float(i + 5), Harness.BufferFloat("Out", i * 2 + 1)) << (bModel ? "interpreter" : "kernel");
		}
	}
}
