// Snippets of HLSL, one value each, run together in one compute shader: compiling is what costs time.
#pragma once

#include "ShaderHarness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace Drydock::Test
{

/** One expression or block that writes the float R, and what R must be. x is 0, 1, 2, 3 in the four threads. */
struct FSnippet
{
	const char* Name;
	const char* Code;
	std::vector<float> Expected; // one for all threads, or one per thread
};

/** Compiles all snippets into one shader and compares every thread, at every lane count. */
inline void ExpectSnippets(const std::string& Globals, const std::vector<FSnippet>& Snippets,
	const std::function<void(FShaderHarness&)>& SetUp = {})
{
	std::string Text = Globals + "\nRWStructuredBuffer<float> Out;\n[numthreads(4, 1, 1)] void Main(uint3 Id : "
								 "SV_DispatchThreadID)\n{\n\tfloat x = Id.x; int n = Id.x; uint u = Id.x; float R;\n";
	for (size_t i = 0; i < Snippets.size(); ++i)
	{
		Text += "\t{ R = 0; " + std::string(Snippets[i].Code) + " Out[Id.x * " + std::to_string(Snippets.size()) +
				"u + " + std::to_string(i) + "u] = R; }\n";
	}
	FShaderHarness Harness(Text + "}\n", "Main", EShaderStage::Compute);
	if (SetUp)
	{
		SetUp(Harness);
	}
	for (const int32_t Lanes : GetLaneCounts())
	{
		Harness.Buffers["Out"].assign(Snippets.size() * 4, 0);
		Harness.Run(Lanes, 4, 1);
		for (size_t i = 0; i < Snippets.size(); ++i)
		{
			for (size_t Thread = 0; Thread < 4; ++Thread)
			{
				const std::vector<float>& Expected = Snippets[i].Expected;
				const float Wanted = Expected[Expected.size() == 1 ? 0 : Thread];
				const float Got = Harness.BufferFloat("Out", Thread * Snippets.size() + i);
				EXPECT_TRUE(SameFloat(Wanted, Got) || std::fabs(Wanted - Got) <= 1e-6f * std::fabs(Wanted))
					<< Snippets[i].Name << ", thread " << Thread << ", " << Lanes << " lanes: expected " << Wanted
					<< ", got " << Got;
			}
		}
	}
}

} // namespace Drydock::Test
