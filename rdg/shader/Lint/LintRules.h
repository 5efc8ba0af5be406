// Lists the rules of the portability lint: rules that a public document states, each with its address. The one source
// of `drydock lint --list`, of docs/lint.md and of the findings' words.
#pragma once

#include "Diagnostics.h"
#include "DrydockAPI.h"

#include <cstdint>
#include <string>
#include <vector>

namespace Drydock
{

/** Platforms where a shader may have to run; bits of FLintRule::Platforms. */
enum ELintPlatform : uint8_t
{
	LintD3D11 = 1,  // Direct3D 11, feature level 11.0, shader model 5
	LintSM6 = 2,    // Direct3D 12, shader models 6.0 to 6.5
	LintVulkan = 4, // Vulkan with the layouts that DXC gives by default
	LintMetal = 8,  // Metal on a Mac
	LintMobile = 16 // Metal on phones and tablets, and Vulkan there
};

/** In the order of the bits: "d3d11", "sm6", "vulkan", "metal", "mobile". */
DRYDOCK_API const std::vector<std::string>& GetLintPlatforms();

/** "d3d11, sm6". */
DRYDOCK_API std::string DescribeLintPlatforms(uint8_t Platforms);

struct FLintRule
{
	std::string Id;
	ESeverity Severity; // Error: does not compile or run there; Warning: on some of it, or not as meant
	uint8_t Platforms;
	std::string Sentence; // what is wrong
	std::string WayRound;
	std::string Source; // address of the document that states it
};

/** All rules, sorted by their ids. */
DRYDOCK_API const std::vector<FLintRule>& GetLintRules();

} // namespace Drydock
