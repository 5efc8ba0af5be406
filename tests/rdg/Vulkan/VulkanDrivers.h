// The Vulkan drivers that run on the CPU, as Debian's packages bring them: what shaders are compared with.
#pragma once

#include "VulkanBackend.h"

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace Drydock::Test
{

struct FVulkanDriver
{
	std::string Name;
	std::unique_ptr<FVulkanBackend> Backend; // null: it is not here, and Fault says why
	std::string Fault;
};

/** Each in its place, whether it is here or not. */
inline std::vector<FVulkanDriver> OpenVulkanDrivers()
{
	struct FKnown
	{
		const char* Name;
		const char* Package;
		std::vector<std::string> Manifests;
	};
	const FKnown Known[] = {
		{"lavapipe", "mesa-vulkan-drivers",
			{"/usr/share/vulkan/icd.d/lvp_icd.x86_64.json", "/usr/share/vulkan/icd.d/lvp_icd.json"}},
		{"SwiftShader", "chromium", {"/usr/lib/chromium/vk_swiftshader_icd.json"}},
	};
	std::vector<FVulkanDriver> Drivers;
	for (const FKnown& One : Known)
	{
		FVulkanDriver& Driver = Drivers.emplace_back();
		Driver.Name = One.Name;
		Driver.Fault = std::string("there is no ") + One.Name + " (Debian package " + One.Package + ")";
		for (const std::string& Manifest : One.Manifests)
		{
			if (!Driver.Backend && std::filesystem::exists(Manifest))
			{
				setenv("VK_DRIVER_FILES", Manifest.c_str(), 1);
				setenv("VK_ICD_FILENAMES", Manifest.c_str(), 1); // its older name
				Driver.Backend = FVulkanBackend::Open(Driver.Fault);
			}
		}
	}
	unsetenv("VK_DRIVER_FILES");
	unsetenv("VK_ICD_FILENAMES");
	return Drivers;
}

/** Opened once for a test program. */
inline std::vector<FVulkanDriver>& GetVulkanDrivers()
{
	static std::vector<FVulkanDriver> Drivers = OpenVulkanDrivers();
	return Drivers;
}

} // namespace Drydock::Test
