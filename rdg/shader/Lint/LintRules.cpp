// The table of the portability lint.
#include "LintRules.h"

namespace Drydock
{

const std::vector<std::string>& GetLintPlatforms()
{
	static const std::vector<std::string> Names = {"d3d11", "sm6", "vulkan", "metal", "mobile"};
	return Names;
}

std::string DescribeLintPlatforms(uint8_t Platforms)
{
	std::string Text;
	for (size_t i = 0; i < GetLintPlatforms().size(); ++i)
	{
		Text += (Platforms >> i & 1) ? (Text.empty() ? "" : ", ") + GetLintPlatforms()[i] : "";
	}
	return Text;
}

const std::vector<FLintRule>& GetLintRules()
{
	constexpr const char* Limits11 =
		"https://learn.microsoft.com/en-us/windows/win32/direct3d11/overviews-direct3d-11-resources-limits";
	constexpr const char* Tiers12 = "https://learn.microsoft.com/en-us/windows/win32/direct3d12/hardware-support";
	constexpr const char* MetalLimits = "https://developer.apple.com/metal/limits/";
	constexpr const char* NumThreads =
		"https://learn.microsoft.com/en-us/windows/win32/direct3dhlsl/sm5-attributes-numthreads";
	constexpr const char* Model60 = "https://github.com/microsoft/DirectXShaderCompiler/wiki/Shader-Model-6.0";
	static const std::vector<FLintRule> Rules = {
		{"atomics-64", ESeverity::Error, LintD3D11 | LintSM6, "atomics on 64 bits need shader model 6.6",
			"use two of 32 bits, or one that holds which thread goes next",
			"https://microsoft.github.io/DirectX-Specs/d3d/HLSL_SM_6_6_Int64_and_Float_Atomics.html"},
		{"atomics-texture", ESeverity::Warning, LintMetal | LintMobile,
			"not every device and system has atomics on textures in Metal",
			"use a RWStructuredBuffer or RWByteAddressBuffer for what is counted",
			"https://projects.blender.org/blender/blender/pulls/115956"},
		{"barrier-divergent", ESeverity::Error, LintD3D11 | LintSM6 | LintVulkan | LintMetal | LintMobile,
			"a barrier that not all threads of the group are known to come to: where one stays away the others wait "
			"for ever, or go on too early",
			"move it out of the condition or loop, and keep what threads differ in between barriers",
			"https://microsoft.github.io/DirectX-Specs/d3d/archive/D3D11_3_FunctionalSpec.htm"},
		{"buffer-length", ESeverity::Warning, LintMetal | LintMobile,
			"Metal does not know the length of a buffer: GetDimensions of one needs a buffer of sizes from the host",
			"pass the number of elements as a parameter", "https://github.com/KhronosGroup/SPIRV-Cross/pull/994"},
		{"constant-buffer-size", ESeverity::Error, LintD3D11, "a constant buffer has at most 4096 elements of 16 bytes",
			"put the table into a StructuredBuffer", Limits11},
		{"derivative-compute", ESeverity::Error, LintD3D11 | LintSM6,
			"derivatives, and samples that need them, are there in compute shaders from shader model 6.6 on",
			"use SampleLevel or SampleGrad",
			"https://microsoft.github.io/DirectX-Specs/d3d/HLSL_SM_6_6_Derivatives.html"},
		{"derivative-divergent", ESeverity::Warning, LintD3D11 | LintSM6 | LintVulkan | LintMetal | LintMobile,
			"a derivative, or a sample that needs one, where pixels of a quad may have parted is limited or undefined",
			"take it before the branch, or use SampleLevel or SampleGrad",
			"https://msdn.microsoft.com/en-us/library/bb219848.aspx"},
		{"double", ESeverity::Error, LintMetal | LintMobile, "Metal has no double", "use float, or a pair of them",
			"https://developer.apple.com/metal/Metal-Shading-Language-Specification.pdf"},
		{"float3-layout", ESeverity::Warning, LintVulkan,
			"elements of a structured buffer lie one way in Direct3D and another by the rules of std430, which DXC "
			"uses for Vulkan by default",
			"fill up to 16 bytes so that no float3 and no vector lies across them, or compile with -fvk-use-dx-layout",
			"https://github.com/microsoft/DirectXShaderCompiler/blob/main/docs/SPIR-V.rst"},
		{"groupshared-16k", ESeverity::Warning, LintMobile,
			"groups of older phones and tablets share 16352 bytes of memory",
			"use a smaller tile, or half the precision", MetalLimits},
		{"hidden-counter", ESeverity::Warning, LintVulkan,
			"Vulkan has no counter behind a buffer: DXC makes a storage buffer of its own of it, which the host binds",
			"count by InterlockedAdd in a buffer of your own",
			"https://github.com/microsoft/DirectXShaderCompiler/blob/main/docs/SPIR-V.rst"},
		{"int64", ESeverity::Error, LintD3D11,
			"integers of 64 bits need shader model 6.0, and drivers need not have them", "use uint2", Model60},
		{"integer-sample", ESeverity::Error, LintD3D11 | LintSM6,
			"textures of integers have no filter: they are not sampled", "use Load, or Gather",
			"https://learn.microsoft.com/en-us/windows/win32/direct3ddxgi/"
			"format-support-for-direct3d-11-0-feature-level-hardware"},
		{"not-in-engine", ESeverity::Error, LintD3D11 | LintSM6 | LintVulkan | LintMetal | LintMobile,
			"the engine does not have this name, which drydock defines",
			"put it into a file of your own, or use what the engine has",
			"https://dev.epicgames.com/documentation/en-us/unreal-engine/"
			"overview-of-shaders-in-plugins-unreal-engine"},
		{"partial-uav-store", ESeverity::Error, LintD3D11, "a store to a typed UAV writes all components of a texel",
			"read the texel, change it, and write it whole",
			"https://learn.microsoft.com/en-us/windows/win32/direct3dhlsl/store-uav-typed--sm5---asm-"},
		{"render-targets", ESeverity::Warning, LintMobile, "some phones and tablets have 4 render targets",
			"draw the others in a pass of their own", "https://github.com/gpuweb/gpuweb/issues/1863"},
		{"sampler-count", ESeverity::Error, LintD3D11 | LintSM6 | LintMetal | LintMobile,
			"a stage has 16 samplers (Direct3D 12: hardware of tier 1)",
			"let textures share samplers, such as the engine's Global*Sampler", Tiers12},
		{"structure-stride", ESeverity::Error, LintD3D11, "elements of a structured buffer have at most 2048 bytes",
			"split it into several buffers", Limits11},
		{"texture-count", ESeverity::Warning, LintMobile, "older phones and tablets take 31 textures",
			"put pictures into a texture array", MetalLimits},
		{"texture-levels", ESeverity::Warning, LintMobile,
			"OpenGL ES does not know how many mips a texture has: textureQueryLevels is desktop's, from GLSL 4.30 on",
			"use GetDimensions without NumberOfLevels, and pass the number as a parameter",
			"https://docs.gl/sl4/textureQueryLevels"},
		{"texture-read-write", ESeverity::Warning, LintMetal | LintMobile,
			"a texture that one pass reads and writes has the formats R32_FLOAT, R32_UINT and R32_SINT, and others on "
			"newer devices only",
			"read what was written from a texture, write into another one; or pack the texel into a uint",
			"https://developer.apple.com/documentation/metal/mtlreadwritetexturetier"},
		{"threads-1024", ESeverity::Error, LintD3D11 | LintSM6 | LintMetal,
			"a group has at most 1024 threads, and at most 64 of them in z", "use smaller groups, and more of them",
			NumThreads},
		{"threads-512", ESeverity::Warning, LintMobile, "groups of older phones and tablets have at most 512 threads",
			"use smaller groups, and more of them", MetalLimits},
		{"typed-uav-load", ESeverity::Error, LintD3D11,
			"a typed UAV is read in the formats R32_FLOAT, R32_UINT and R32_SINT only",
			"read what was written from a texture, write into another one; or pack the texel into a uint",
			"https://learn.microsoft.com/en-us/windows/win32/direct3d11/typed-unordered-access-view-loads"},
		{"typed-uav-load-optional", ESeverity::Warning, LintSM6,
			"reads of a typed UAV of other formats than R32 are optional (TypedUAVLoadAdditionalFormats)",
			"read what was written from a texture, write into another one; or pack the texel into a uint",
			"https://learn.microsoft.com/en-us/windows/win32/direct3d12/typed-unordered-access-view-loads"},
		{"types-16", ESeverity::Error, LintD3D11, "types of 16 bits need shader model 6.2",
			"use float, or min16float, which may be one",
			"https://github.com/microsoft/DirectXShaderCompiler/wiki/16-Bit-Scalar-Types"},
		{"uav-count", ESeverity::Warning, LintD3D11, "hardware of feature level 11.0 has 8 UAVs",
			"put several results into one texture or buffer", Tiers12},
		{"uav-size", ESeverity::Warning, LintMetal | LintMobile,
			"translators of HLSL to Metal, the engine's older ones too, need not know the size of a RWTexture",
			"pass the size as a parameter", "https://github.com/Temaran/UnrealEngineShaderPluginDemo/pull/14"},
		{"wave-operations", ESeverity::Error, LintD3D11, "wave operations need shader model 6.0",
			"use groupshared memory, and a permutation with waves where they are there",
			"https://learn.microsoft.com/en-us/windows/win32/direct3dhlsl/"
			"hlsl-shader-model-6-0-features-for-direct3d-12"},
	};
	return Rules;
}

} // namespace Drydock
