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
