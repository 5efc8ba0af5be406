// r.Drydock.Backend: what shaders run on.
#include "Diagnostics.h"
#include "HAL/IConsoleManager.h"
#include "VulkanBackend.h"

namespace Drydock
{

namespace
{

TAutoConsoleVariable<int32> CVarBackend(TEXT("r.Drydock.Backend"), 0,
	TEXT("Device that shaders run on. 0: the CPU, as drydock compiles them; 1: the Vulkan driver that is there. "
		 "Hand-written kernels stay on the CPU."));

/** Opened at the first shader that is to run there, and kept: drivers take a while. */
IDispatchBackend* ChooseBackend()
{
	if (CVarBackend.GetValueOnAnyThread() == 0)
	{
		return nullptr;
	}
	static std::string Fault;
	static const std::unique_ptr<FVulkanBackend> Backend = FVulkanBackend::Open(Fault);
	if (!Backend)
	{
		throw FError({ESeverity::Error, 6070, "shaders cannot run on Vulkan: " + Fault, {}, 0, 0, "r.Drydock.Backend"},
			ExitUsage);
	}
	return Backend.get();
}

[[maybe_unused]] const bool GChooserIsSet = (SetDispatchBackendChooser(&ChooseBackend), true);

} // namespace

} // namespace Drydock
