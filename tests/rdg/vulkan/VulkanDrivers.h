// The Vulkan drivers that run on the CPU, as Debian's packages bring them: what shaders are compared with.
#pragma once

#include "VulkanBackend.h"
#include "VulkanManifests.h"

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
	std::vector<FVulkanDriver> Drivers;
	for (const FVulkanManifest& Known : GetVulkanManifests())
	{
		FVulkanDriver& Driver = Drivers.emplace_back();
		Driver.Name = Known.Driver;
		Driver.Fault = std::string("there is no ") + Known.Driver + " (Debian package " + Known.Package + ")";
		if (const std::optional<std::string> Manifest = Known.Find())
		{
			const FScopedVulkanDriver Chosen(*Manifest);
			Driver.Backend = FVulkanBackend::Open(Driver.Fault);
		}
	}
	return Drivers;
}

/** Opened once for a test program. */
inline std::vector<FVulkanDriver>& GetVulkanDrivers()
{
	static std::vector<FVulkanDriver> Drivers = OpenVulkanDrivers();
	return Drivers;
}

} // namespace Drydock::Test
