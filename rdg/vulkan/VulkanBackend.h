// Shaders on a Vulkan driver instead of their kernels: a graphics card, or lavapipe and SwiftShader, which run on the
// CPU and are independent witnesses of what a shader means. r.Drydock.Backend 1 chooses it.
#pragma once

#include "DispatchBackend.h"
#include "ShaderCompileRequest.h"

namespace Drydock
{

class DRYDOCK_API FVulkanBackend final : public IDispatchBackend
{
public:
	/** The device that Vulkan's loader finds, a graphics card first; VK_DRIVER_FILES names the driver's manifest where
	 * there are several. Null: there is none; OutFault is the reason. */
	static std::unique_ptr<FVulkanBackend> Open(std::string& OutFault);

	~FVulkanBackend() override;

	/** Shaders in double precision are refused; all else as IDispatchBackend. Vertex shaders do not come here. */
	std::string Run(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) override;

	/** The same for a shader without a shader class. Args have the slots of Kernel; the pipeline is kept as long as
	 * Kernel is the same object. Throws FError with the front end's messages. */
	std::string Run(const FShaderCompileRequest& Request, const std::shared_ptr<const FShaderReflection>& Kernel,
		const FKernelArgs& Args, const FKernelTile& Whole);

	/** Lets go of all pipelines; shaders that run again are made anew. */
	void ForgetShaders();

	/** As the driver gives it: "llvmpipe (LLVM 15.0.6, 256 bits)". */
	std::string GetDeviceName() const override;

	/** Threads of a wave, which r.Drydock.WaveSize has to be for shaders with waves. */
	int32_t GetWaveSize() const;

	/** Wall time of the last run on the device, without copies to and from it. */
	double GetRunMilliseconds() const;

private:
	struct FImplementation;

	explicit FVulkanBackend(std::unique_ptr<FImplementation> InImplementation);

	std::unique_ptr<FImplementation> Implementation;
};

} // namespace Drydock
