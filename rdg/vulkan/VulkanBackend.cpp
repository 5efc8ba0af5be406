// Keeps the device and the pipelines of shaders that have run.
#include "VulkanBackend.h"

#include "Shader.h"
#include "ShaderCompilation.h"
#include "VulkanDraw.h"

#include <functional>
#include <map>

namespace Drydock
{

struct FVulkanBackend::FImplementation
{
	struct FEntry
	{
		std::shared_ptr<const FShaderReflection> Kernel; // so that its address stays its own
		std::unique_ptr<FVulkanShader> Shader;           // null: it cannot run
		std::string Fault;
	};

	std::string Run(const std::shared_ptr<const FShaderReflection>& Kernel,
		const std::function<FShaderCompileRequest()>& MakeRequest, const FKernelArgs& Args, const FKernelTile& Whole)
	{
		const auto [Found, bNew] = Entries.try_emplace(Kernel.get());
		FEntry& Entry = Found->second;
		try
		{
			if (bNew)
			{
				Entry.Kernel = Kernel;
				Entry.Shader = std::make_unique<FVulkanShader>(Device, MakeRequest(), *Kernel);
			}
			if (Entry.Shader)
			{
				Milliseconds = RunVulkanShader(*Entry.Shader, Args, Whole);
			}
			return Entry.Fault;
		}
		catch (const FVulkanError& Error)
		{
			Entry.Fault = Entry.Shader ? std::string() : Error.what(); // of these arguments, or of the shader for good
			return Error.what();
		}
		catch (...)
		{
			Entries.erase(Found);
			throw;
		}
	}

	std::shared_ptr<const FVulkanDevice> Device;
	std::map<const FShaderReflection*, FEntry> Entries;
	double Milliseconds = 0;
};

FVulkanBackend::FVulkanBackend(std::unique_ptr<FImplementation> InImplementation)
	: Implementation(std::move(InImplementation))
{
}

FVulkanBackend::~FVulkanBackend() = default;

std::unique_ptr<FVulkanBackend> FVulkanBackend::Open(std::string& OutFault)
{
	auto Made = std::make_unique<FImplementation>();
	Made->Device = FVulkanDevice::Open(OutFault);
	return Made->Device ? std::unique_ptr<FVulkanBackend>(new FVulkanBackend(std::move(Made))) : nullptr;
}

std::string FVulkanBackend::Run(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole)
{
	if (Shader.bDouble)
	{
		return "it has no textures in double precision";
	}
	const auto MakeRequest = [&Shader]
	{
		const FShaderRef Permutation(Shader.Permutation);
		return MakeShaderCompileRequest(Permutation, Permutation.GetRootParametersMetadata());
	};
	return Implementation->Run(Shader.Reflection, MakeRequest, Args, Whole);
}

std::string FVulkanBackend::Run(const FShaderCompileRequest& Request,
	const std::shared_ptr<const FShaderReflection>& Kernel, const FKernelArgs& Args, const FKernelTile& Whole)
{
	return Implementation->Run(
		Kernel, [&Request] { return Request; }, Args, Whole);
}

void FVulkanBackend::ForgetShaders()
{
	Implementation->Entries.clear();
}

std::string FVulkanBackend::GetDeviceName() const
{
	return Implementation->Device->GetName();
}

int32_t FVulkanBackend::GetWaveSize() const
{
	return int32_t(Implementation->Device->SubgroupSize);
}

double FVulkanBackend::GetRunMilliseconds() const
{
	return Implementation->Milliseconds;
}

} // namespace Drydock
