// Makes the samplers that a shader may name without binding them.
#include "StaticSamplers.h"

#include "RHIStaticStates.h"

namespace Drydock
{

FRHISamplerState* FindStaticSampler(const std::string& HlslName)
{
	static const struct
	{
		const char* Name;
		FRHISamplerState* State;
	} Samplers[] = {
		{"GlobalPointClampedSampler", TStaticSamplerState<SF_Point, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI()},
		{"GlobalPointWrappedSampler", TStaticSamplerState<SF_Point, AM_Wrap, AM_Wrap, AM_Wrap>::GetRHI()},
		{"GlobalBilinearClampedSampler", TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI()},
		{"GlobalBilinearWrappedSampler", TStaticSamplerState<SF_Bilinear, AM_Wrap, AM_Wrap, AM_Wrap>::GetRHI()},
		{"GlobalTrilinearClampedSampler", TStaticSamplerState<SF_Trilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI()},
		{"GlobalTrilinearWrappedSampler", TStaticSamplerState<SF_Trilinear, AM_Wrap, AM_Wrap, AM_Wrap>::GetRHI()},
	};
	for (const auto& Sampler : Samplers)
	{
		if (HlslName == Sampler.Name)
		{
			return Sampler.State;
		}
	}
	return nullptr;
}

} // namespace Drydock
