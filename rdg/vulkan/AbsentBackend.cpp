// Stands in for VulkanBackend.cpp where drydock is built without Vulkan's headers.
#include "VulkanBackend.h"

namespace Drydock
{

struct FVulkanBackend::FImplementation
{
};

FVulkanBackend::FVulkanBackend(std::unique_ptr<FImplementation> InImplementation)
	: Implementation(std::move(InImplementation))
{
}

FVulkanBackend::~FVulkanBackend() = default;

std::unique_ptr<FVulkanBackend> FVulkanBackend::Open(std::string& OutFault)
{
	OutFault = "this drydock was built without Vulkan's headers (Debian package libvulkan-dev)";
	return nullptr;
}

std::string FVulkanBackend::Run(const FBoundShader&, const FKernelArgs&, const FKernelTile&)
{
	return {};
}

std::string FVulkanBackend::Run(const FShaderCompileRequest&, const std::shared_ptr<const FShaderReflection>&,
	const FKernelArgs&, const FKernelTile&)
{
	return {};
}

void FVulkanBackend::ForgetShaders() {}

std::string FVulkanBackend::GetDeviceName() const
{
	return {};
}

int32_t FVulkanBackend::GetWaveSize() const
{
	return 0;
}

double FVulkanBackend::GetRunMilliseconds() const
{
	return 0;
}

} // namespace Drydock
