// Where Debian's packages put the Vulkan drivers that run on the CPU, and how the loader is told to take one.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace Drydock::Test
{

struct FVulkanManifest
{
	const char* Driver;
	const char* Package;
	std::vector<std::string> Files; // the first that is there counts

	std::optional<std::string> Find() const
	{
		for (const std::string& File : Files)
		{
			if (std::filesystem::exists(File))
			{
				return File;
			}
		}
		return std::nullopt;
	}
};

inline std::vector<FVulkanManifest> GetVulkanManifests()
{
	return {
		{"lavapipe", "mesa-vulkan-drivers",
			{"/usr/share/vulkan/icd.d/lvp_icd.x86_64.json", "/usr/share/vulkan/icd.d/lvp_icd.json"}},
		{"SwiftShader", "chromium", {"/usr/lib/chromium/vk_swiftshader_icd.json"}},
	};
}

/** The loader, in this process and those that it starts, finds this driver alone. */
class FScopedVulkanDriver
{
public:
	explicit FScopedVulkanDriver(const std::string& Manifest)
	{
		setenv("VK_DRIVER_FILES", Manifest.c_str(), 1);
		setenv("VK_ICD_FILENAMES", Manifest.c_str(), 1); // its older name
#if defined(__SANITIZE_ADDRESS__)
		// Programs that load a driver: it leaves memory behind, in modules that are unloaded when leaks are looked for.
		setenv("ASAN_OPTIONS", "detect_leaks=0", 1);
#endif
	}
	~FScopedVulkanDriver()
	{
		unsetenv("VK_DRIVER_FILES");
		unsetenv("VK_ICD_FILENAMES");
#if defined(__SANITIZE_ADDRESS__)
		unsetenv("ASAN_OPTIONS");
#endif
	}
	FScopedVulkanDriver(const FScopedVulkanDriver&) = delete;
	FScopedVulkanDriver& operator=(const FScopedVulkanDriver&) = delete;
};

} // namespace Drydock::Test
