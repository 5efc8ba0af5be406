// One compute shader in all forms that it runs in.
#pragma once

#include "ShaderHarness.h"

#include <gtest/gtest.h>

#include <functional>

namespace Drydock::Test
{

/** Runs Text over X x Y x Z threads by kernels of every lane count, in double, and by the interpreter. */
inline void ForEachForm(const std::string& Text, int32_t X, int32_t Y, int32_t Z,
	const std::function<void(FShaderHarness&)>& Fill, const std::function<void(FShaderHarness&)>& Check)
{
	for (const int32_t Lanes : GetLaneCounts())
	{
		SCOPED_TRACE(std::to_string(Lanes) + " lanes");
		FShaderHarness Harness(Text, "MainCS", EShaderStage::Compute);
		Fill(Harness);
		Harness.Run(Lanes, X, Y, Z);
		Check(Harness);
	}
	{
		SCOPED_TRACE("double");
		FShaderHarness Harness(Text, "MainCS", EShaderStage::Compute);
		Fill(Harness);
		Harness.Run(0, X, Y, Z, true);
		Check(Harness);
	}
	{
		SCOPED_TRACE("interpreter");
		FShaderHarness Harness(Text, "MainCS", EShaderStage::Compute);
		Fill(Harness);
		Harness.RunModel(X, Y, Z);
		Check(Harness);
	}
	SCOPED_TRACE("with its functions");
	FShaderHarness Harness(Text, "MainCS", EShaderStage::Compute);
	Fill(Harness);
	Harness.RunInspected(X, Y, Z);
	Check(Harness);
}

} // namespace Drydock::Test
