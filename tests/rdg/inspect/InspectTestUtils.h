// Shaders of a few lines whose threads are looked at.
#pragma once

#include "../shader/Compiler/ShaderHarness.h"
#include "ThreadRuns.h"

namespace Drydock::Test
{

constexpr int32_t InspectWidth = 6;
constexpr int32_t InspectHeight = 4;
constexpr FKernelTile InspectWhole = {0, 0, 0, InspectWidth, InspectHeight, 1};

/** A pixel shader around some lines, of which the first is line 5. Before: what stands before it, in its first line. */
inline FShaderHarness MakeInspectedPixel(const std::string& Lines, const std::string& Before = {})
{
	FShaderHarness Harness(Before +
							   "Texture2D Source;\nfloat Zero;\n"
							   "void MainPS(float4 SvPosition : SV_POSITION, out float4 OutColor : SV_Target0)\n{\n" +
							   Lines + "\n}\n",
		"MainPS", EShaderStage::Pixel);
	Harness.SetFloats("Zero", {0});
	Harness.Textures["Source"] = FTestTexture(InspectWidth, InspectHeight);
	Harness.Targets.emplace_back(InspectWidth, InspectHeight);
	return Harness;
}

inline FBoundShader MakeBound(const FShaderHarness& Harness)
{
	FBoundShader Bound;
	Bound.Reflection = std::make_shared<FShaderReflection>(Harness.GetReflection());
	return Bound;
}

} // namespace Drydock::Test
