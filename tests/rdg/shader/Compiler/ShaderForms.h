// One shader in all forms that it runs in.
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

/** Runs the pixel shader MainPS over X x Y pixels, each form on a harness of its own that Fill has filled. */
inline void ForEachPixelForm(const std::string& Text, int32_t X, int32_t Y,
	const std::function<void(FShaderHarness&)>& Fill, const std::function<void(FShaderHarness&)>& Check)
{
	const auto Run = [&](const std::string& Form, auto RunIt)
	{
		SCOPED_TRACE(Form);
		FShaderHarness Harness(Text, "MainPS", EShaderStage::Pixel);
		Fill(Harness);
		RunIt(Harness);
		Check(Harness);
	};
	for (const int32_t Lanes : GetLaneCounts())
	{
		Run(std::to_string(Lanes) + " lanes", [&](FShaderHarness& Harness) { Harness.Run(Lanes, X, Y); });
	}
	Run("double", [&](FShaderHarness& Harness) { Harness.Run(0, X, Y, 1, true); });
	Run("interpreter", [&](FShaderHarness& Harness) { Harness.RunModel(X, Y); });
	Run("with its functions", [&](FShaderHarness& Harness) { Harness.RunInspected(X, Y); });
	Run("with its functions, in double", [&](FShaderHarness& Harness) { Harness.RunInspected(X, Y, 1, true); });
}

} // namespace Drydock::Test
