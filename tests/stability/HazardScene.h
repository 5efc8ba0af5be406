// What is stated of the hazard scene's runs.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace Stability
{

/** Pixels of the scene that are not finite in the half floats of scene colour: NaN, both infinities, 65520 and 1e30. */
constexpr std::size_t NumBadPixels = 5;

/** A sample config whose linear picture has other values that are not finite than those of the bad pixels. */
struct FStatedConfig
{
	std::string_view Config;
	std::size_t NumValues; // 0: more
	std::string_view Reason;
};

constexpr std::array<FStatedConfig, 5> StatedConfigs = {{
	{"frame_full", 0, "depth of field, motion blur and the RED chain spread them over their footprints"},
	{"kawase_motionblur", 0, "the dual Kawase blur spreads them over its reach"},
	{"red_depth_of_field", 0, "the blur of what is out of focus spreads them"},
	{"red_diffusion", 0, "the diffusion filter adds the blur of infinities; NaN it makes 0"},
	{"screen_percentage", 12, "at half resolution 65520 is one of four in a mean, which a half holds"},
}};

constexpr const FStatedConfig* FindStatedConfig(std::string_view Config)
{
	for (const FStatedConfig& Stated : StatedConfigs)
	{
		if (Stated.Config == Config)
		{
			return &Stated;
		}
	}
	return nullptr;
}

} // namespace Stability
