// Creates states, and translates them to what a kernel needs of them.
#include "RHIStates.h"

#include "HAL/IConsoleManager.h"

static TAutoConsoleVariable<int32> CVarDrydockSampleBits(TEXT("r.Drydock.SampleBits"), 8,
	TEXT("Fraction bits of a texture coordinate, in texels.\n")
		TEXT(" 8: snapped to the nearest 1/256 texel, as GPUs do (default)\n") TEXT(" 0: not snapped"));

Drydock::FKernelSampler FRHISamplerState::GetKernelSampler() const
{
	using namespace Drydock;
	static_assert(int32(EKernelAddress::Wrap) == AM_Wrap && int32(EKernelAddress::Clamp) == AM_Clamp);
	static_assert(int32(EKernelAddress::Mirror) == AM_Mirror && int32(EKernelAddress::Border) == AM_Border);

	FKernelSampler Sampler{};
	switch (Initializer.Filter)
	{
	case SF_Bilinear:
		Sampler.Filter = EKernelFilter::Bilinear;
		break;
	case SF_Trilinear:
	case SF_AnisotropicLinear:
		Sampler.Filter = EKernelFilter::Trilinear;
		break;
	default:
		Sampler.Filter = EKernelFilter::Point;
		break;
	}
	Sampler.AddressU = EKernelAddress(Initializer.AddressU);
	Sampler.AddressV = EKernelAddress(Initializer.AddressV);
	Sampler.AddressW = EKernelAddress(Initializer.AddressW);
	Sampler.SampleBits = CVarDrydockSampleBits.GetValueOnAnyThread() != 0 ? 8 : 0;
	Sampler.MipBias = Initializer.MipBias;
	Sampler.MinLevel = Initializer.MinMipLevel;
	Sampler.MaxLevel = Initializer.MaxMipLevel;
	Sampler.Compare = Initializer.SamplerComparisonFunction == SCF_Less ? EKernelCompare::Less : EKernelCompare::Never;
	const uint32 Color = Initializer.BorderColor;
	Sampler.Border[0] = float((Color >> 16) & 0xff) / 255.0f;
	Sampler.Border[1] = float((Color >> 8) & 0xff) / 255.0f;
	Sampler.Border[2] = float(Color & 0xff) / 255.0f;
	Sampler.Border[3] = float(Color >> 24) / 255.0f;
	return Sampler;
}

FSamplerStateRHIRef RHICreateSamplerState(const FSamplerStateInitializerRHI& Initializer)
{
	return new FRHISamplerState(Initializer);
}

FBlendStateRHIRef RHICreateBlendState(const FBlendStateInitializerRHI& Initializer)
{
	return new FRHIBlendState(Initializer);
}

FRasterizerStateRHIRef RHICreateRasterizerState(const FRasterizerStateInitializerRHI& Initializer)
{
	return new FRHIRasterizerState(Initializer);
}

FDepthStencilStateRHIRef RHICreateDepthStencilState(const FDepthStencilStateInitializerRHI& Initializer)
{
	return new FRHIDepthStencilState(Initializer);
}

FVertexDeclarationRHIRef RHICreateVertexDeclaration(const FVertexDeclarationElementList& Elements)
{
	return new FRHIVertexDeclaration(Elements);
}
