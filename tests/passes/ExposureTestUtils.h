// Runs metering and adaptation on synthetic pictures and reads back what shaders would see.
#pragma once

#include "PassTestUtils.h"

#include "Exposure/PostProcessHistogram.h"
#include "RHIGPUReadback.h"
#include "RenderGraphUtils.h"

#include <array>
#include <functional>
#include <optional>

namespace PassTest
{

/** What varies between tests of metering. */
struct FMetering
{
	EAutoExposureMethod Method = AEM_Histogram;
	std::function<void(FFinalPostProcessSettings&)> Settings = {};
	/** Exposure scale of the last frame; none: there was none. */
	std::optional<float> LastScale = {};
	float DeltaTime = 1.0f / 60.0f;
	bool bCameraCut = false;
	float PreExposure = 1.0f;
	EArithmetic Arithmetic = EArithmetic::Float32;
	/** Weights, empty: none. */
	FImage Mask = {};
};

/** A pass run whose view has the time and settings of a metering. */
class FMeteringRun
{
public:
	FMeteringRun(const FImage& Image, const FMetering& InMetering)
		: FMeteringRun(Image, {0, 0, Image.Width, Image.Height}, FIntPoint(Image.Width, Image.Height), InMetering)
	{
	}
	FMeteringRun(const FImage& Image, const FRect& Rect, FIntPoint Extent, const FMetering& InMetering)
		: Metering(InMetering)
		, Run(Image, Rect, Extent, InMetering.Arithmetic, PF_A32B32G32R32F)
	{
		Family.Time.DeltaWorldTimeSeconds = Metering.DeltaTime;
		Run.View.Family = &Family;
		Run.View.bCameraCut = Metering.bCameraCut;
		Run.View.PreExposure = Metering.PreExposure;
		Run.View.InitViewUniformBuffer(Extent);
		if (Metering.Settings)
		{
			Metering.Settings(Run.View.FinalPostProcessSettings);
		}
		Parameters = GetEyeAdaptationParameters(Run.View, Metering.Method, !Metering.LastScale.has_value());
		if (Metering.Mask.Width > 0)
		{
			Mask = Run.AddInput(Metering.Mask, PF_A32B32G32R32F, TEXT("MeterMask")).Texture;
		}
	}

	std::array<double, Drydock::GHistogramSize> GetHistogram()
	{
		TRefCountPtr<IPooledRenderTarget> Extracted;
		Run.GraphBuilder.QueueTextureExtraction(
			AddHistogramPass(Run.GraphBuilder, Run.View, Parameters, Run.Input, Mask), &Extracted);
		Run.GraphBuilder.Execute();
		return Drydock::ReadHistogram(*Extracted->GetRHI());
	}

	/** The buffer's two entries. */
	std::vector<FVector4f> GetEyeAdaptation()
	{
		FEyeAdaptationInputs Inputs;
		Inputs.Parameters = Parameters;
		if (Metering.LastScale)
		{
			Inputs.LastEyeAdaptationBuffer = Drydock::CreateEyeAdaptationBuffer(Run.GraphBuilder, *Metering.LastScale);
		}
		FRHIGPUBufferReadback Readback(TEXT("EyeAdaptation"));
		const FRDGBufferRef Buffer = AddBuffer(Inputs);
		AddEnqueueCopyPass(Run.GraphBuilder, &Readback, Buffer, Buffer->Desc.GetSize());
		Run.GraphBuilder.Execute();
		const uint32 NumBytes = Drydock::GEyeAdaptationBufferEntries * sizeof(FVector4f);
		const FVector4f* const Entries = static_cast<const FVector4f*>(Readback.Lock(NumBytes));
		const std::vector<FVector4f> Result(Entries, Entries + Drydock::GEyeAdaptationBufferEntries);
		Readback.Unlock();
		return Result;
	}

private:
	FRDGBufferRef AddBuffer(const FEyeAdaptationInputs& Inputs)
	{
		switch (Metering.Method)
		{
		case AEM_Manual:
			return Drydock::CreateManualEyeAdaptationBuffer(Run.GraphBuilder, Parameters);
		case AEM_Basic:
			return AddBasicEyeAdaptationPass(Run.GraphBuilder, Run.View, Inputs,
				AddBasicEyeAdaptationSetupPass(Run.GraphBuilder, Run.View, Parameters, Run.Input), Mask);
		default:
			return AddHistogramEyeAdaptationPass(Run.GraphBuilder, Run.View, Inputs,
				AddHistogramPass(Run.GraphBuilder, Run.View, Parameters, Run.Input, Mask));
		}
	}

	FMetering Metering;
	FSceneViewFamily Family;

public:
	FPassRun Run;
	FEyeAdaptationParameters Parameters;

private:
	FRDGTextureRef Mask = nullptr;
};

inline FImage Grey(double Luminance, int Width = 1, int Height = 1)
{
	return FImage(Width, Height, {Luminance, Luminance, Luminance, 1});
}

inline FVector4f Meter(const FImage& Image, const FMetering& Metering = {})
{
	return FMeteringRun(Image, Metering).GetEyeAdaptation()[0];
}

/** The default histogram's range, -8 to 4, has a step of 12/63 EV between buckets. */
inline double BucketLuminance(double Bucket)
{
	return std::exp2(-8 + 12 * Bucket / 63);
}

/** One pixel for each bucket, from dark to bright. */
inline FImage BucketRamp()
{
	return FImage::Make(64, 1,
		[](int X, int)
		{
			const double Luminance = BucketLuminance(X);
			return FTexel{Luminance, Luminance, Luminance, 1};
		});
}

} // namespace PassTest
