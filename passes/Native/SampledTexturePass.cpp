// Between screen passes and lanes code that samples.
#include "Native/SampledTexturePass.h"

#include "LanesDispatch.h"
#include "PixelFormatConversion.h"
#include "ShaderCompilation.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace Drydock
{

void SetViewport(const FScreenPassTextureViewportParameters& Viewport, FViewportAxis Out[2])
{
	for (int Axis = 0; Axis < 2; ++Axis)
	{
		Out[Axis] = {static_cast<float>(Viewport.ViewportMin[Axis]), Viewport.ViewportSizeInverse[Axis]};
	}
}

FSampledTexture MakeSampledTexture(const FNativeKernelArgs& Args, const char* Texture, const char* Sampler,
	const FScreenPassTextureViewportParameters& Viewport)
{
	FSampledTexture Result;
	Result.Texture = Args.FindTexture(Texture);
	Result.Sampler = Args.FindSampler(Sampler);
	for (int Axis = 0; Axis < 2; ++Axis)
	{
		Result.Axes[Axis] = {Viewport.UVViewportSize[Axis], Viewport.UVViewportMin[Axis],
			Viewport.UVViewportBilinearMin[Axis], Viewport.UVViewportBilinearMax[Axis]};
	}
	return Result;
}

bool CanSampleInLanes(const FKernelTexture* Texture, const FKernelSampler* Sampler)
{
	if (!Texture || !Sampler)
	{
		return false;
	}
	const FTexelStorageInfo& Info = GetTexelStorageInfo(Texture->Storage);
	return Sampler->Filter != EKernelFilter::Point && Sampler->SampleBits == 8 && Texture->NumMips == 1 &&
		   !Texture->bIs3D && Texture->Mips[0].SizeZ == 1 && Info.Kind != ETexelKind::Uint && Info.BitsPerChannel <= 32;
}

void ReadEyeAdaptation(const FNativeKernelArgs& Args, const char* Buffer, float Out[4])
{
	const FKernelBuffer* const Found = Args.FindBuffer(Buffer);
	std::fill(Out, Out + 4, 0.0f);
	if (Found && Found->SizeInBytes >= 4 * sizeof(float))
	{
		std::memcpy(Out, Found->Data, 4 * sizeof(float));
	}
}

float GetOneOverPreExposure(const TUniformBufferRef<FViewUniformShaderParameters>& View)
{
	return static_cast<const FViewUniformShaderParameters*>(View->GetContents())->OneOverPreExposure;
}

FSampledTexture MakeUnheldTexture(const FNativeKernelArgs& Args, const char* Texture, const char* Sampler)
{
	constexpr float Infinity = std::numeric_limits<float>::infinity();
	constexpr FSampledAxis Axis = {1.0f, 0.0f, -Infinity, Infinity};
	return {Args.FindTexture(Texture), Args.FindSampler(Sampler), {Axis, Axis}};
}

bool MakeLocalExposureJob(const FNativeKernelArgs& Args, const FLocalExposureParameters& Parameters,
	const FEyeAdaptationParameters& EyeAdaptation, const float EyeAdaptationEntry[4], float OneOverPreExposure,
	FLocalExposureJob& Out)
{
	Out.Blurred = MakeUnheldTexture(Args, "BlurredLogLum", "BlurredLogLumSampler");
	Out.Grid = Args.FindTexture("LumBilateralGrid");
	const FKernelSampler* const GridSampler = Args.FindSampler("LumBilateralGridSampler");
	if (!CanSampleInLanes(Out.Blurred.Texture, Out.Blurred.Sampler) || !Out.Grid || !GridSampler || !Out.Grid->bIs3D ||
		Out.Grid->NumMips != 1 || Out.Grid->Storage != ETexelStorage::RG32_FLOAT ||
		GridSampler->Filter == EKernelFilter::Point || GridSampler->SampleBits != 8)
	{
		return false;
	}
	std::copy_n(EyeAdaptationEntry, 4, Out.EyeAdaptation);
	Out.GridScale[0] = Parameters.BilateralGridUVScale.X;
	Out.GridScale[1] = Parameters.BilateralGridUVScale.Y;
	Out.HighlightContrastScale = Parameters.HighlightContrastScale;
	Out.ShadowContrastScale = Parameters.ShadowContrastScale;
	Out.HighlightThreshold = Parameters.HighlightThreshold;
	Out.ShadowThreshold = Parameters.ShadowThreshold;
	Out.DetailStrength = Parameters.DetailStrength;
	Out.BlurredLuminanceBlend = Parameters.BlurredLuminanceBlend;
	Out.MiddleGreyExposureCompensation = Parameters.MiddleGreyExposureCompensation;
	Out.HistogramScale = EyeAdaptation.HistogramScale;
	Out.HistogramBias = EyeAdaptation.HistogramBias;
	Out.LuminanceMin = EyeAdaptation.LuminanceMin;
	Out.OneOverPreExposure = OneOverPreExposure;
	return GridSampler->AddressU == EKernelAddress::Clamp && GridSampler->AddressV == EKernelAddress::Clamp &&
		   GridSampler->AddressW == EKernelAddress::Clamp;
}

bool IsInsideTarget(const FKernelTexture* Target, const FKernelTile& Pixels)
{
	if (!Target)
	{
		return false;
	}
	const FTexelStorageInfo& Info = GetTexelStorageInfo(Target->Storage);
	const FKernelMip& Mip = Target->Mips[0];
	return Info.Kind != ETexelKind::Uint && Info.BitsPerChannel <= 32 && Pixels.MinX >= 0 && Pixels.MinY >= 0 &&
		   Pixels.MaxX <= Mip.SizeX && Pixels.MaxY <= Mip.SizeY;
}

} // namespace Drydock
