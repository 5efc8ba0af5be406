// What the tests of convolution bloom and of its kernel share: a kernel as a texture, settings of one texel to a pixel,
// runs of the pass.
#pragma once

#include "PassTestUtils.h"

#include "PostProcess/PostProcessFFTBloom.h"
#include "RenderGraphObserver.h"
#include "SceneViewState.h"
#include "Screen/TextureAssets.h"
#include "SettingObjects.h"

#include <algorithm>

namespace PassTest
{

inline constexpr const char* KernelPath = "Test/Kernel";

/** The pixels of KernelPath while it lives. */
class FTestKernel
{
public:
	explicit FTestKernel(const FImage& Picture)
		: Loader([Picture](const std::string& Path) { return Path == KernelPath ? MakeTexture(Picture) : nullptr; })
	{
	}

private:
	static FTextureRHIRef MakeTexture(const FImage& Picture)
	{
		std::vector<FLinearColor> Colors;
		for (const FTexel& Texel : Picture.Texels)
		{
			Colors.push_back(FLinearColor(float(Texel[0]), float(Texel[1]), float(Texel[2]), 1.0f));
		}
		return Drydock::MakePictureTexture(FIntPoint(Picture.Width, Picture.Height), Colors, KernelPath);
	}

	Drydock::FScopedTextureLoader Loader;
};

/** One texel of the kernel to a pixel, no pre-filter, padding for the whole kernel, s = 1. */
inline FFinalPostProcessSettings MakeSettings(const FImage& Picture, const FImage& Kernel)
{
	FFinalPostProcessSettings Settings;
	Settings.BloomMethod = BM_FFT;
	Settings.BloomIntensity = 1.0f;
	Settings.BloomConvolutionTexture = Drydock::FindOrAddTexture(KernelPath);
	Settings.BloomConvolutionScatterDispersion = 1.0f;
	Settings.BloomConvolutionSize = float(Kernel.Width) / float(Picture.Width);
	Settings.BloomConvolutionPreFilterMin = Settings.BloomConvolutionPreFilterMax = 0.0f;
	Settings.BloomConvolutionBufferScale = 0.0f;
	return Settings;
}

struct FBloom
{
	FImage Bloom;
	FTexel SceneColor{}; // what multiplies it
	std::vector<std::string> Passes;
};

/** Notes the passes that ran. */
class FPassNames final : public Drydock::IRDGObserver
{
public:
	void OnPassExecuted(
		int32_t, const FRDGPass& Pass, double, const Drydock::FPassCounters&, const std::vector<FRDGTexture*>&) override
	{
		Names.push_back(Pass.GetName());
	}

	std::vector<std::string> Names;
};

inline FBloom Execute(FPassRun& Run, const FFFTBloomInputs& Inputs)
{
	FPassNames Names;
	Run.GraphBuilder.SetObserver(&Names);
	const FFFTBloomOutput Output = AddFFTBloomPass(Run.GraphBuilder, Run.View, Inputs);
	TRefCountPtr<FRDGPooledBuffer> Buffer;
	Run.GraphBuilder.QueueBufferExtraction(Output.SceneColorApplyParameters, &Buffer);
	FBloom Result;
	Result.Bloom = Run.Execute(Output.BloomTexture);
	Run.GraphBuilder.SetObserver(nullptr);
	const float* const Factor = reinterpret_cast<const float*>(Buffer->GetRHI()->GetData());
	Result.SceneColor = {double(Factor[0]), double(Factor[1]), double(Factor[2]), double(Factor[3])};
	Result.Passes = Names.Names;
	return Result;
}

inline FBloom MakeBloom(const FImage& Picture, const FFinalPostProcessSettings& Settings,
	EArithmetic Arithmetic = EArithmetic::Native, FSceneViewState* State = nullptr)
{
	FPassRun Run(Picture, Arithmetic, PF_A32B32G32R32F);
	Run.View.FinalPostProcessSettings = Settings;
	Run.View.State = State;
	return Execute(Run, {Run.Input, {}, {}});
}

/** Asymmetric in both directions and by channel; its brightest texel is the middle one. */
inline FImage MakeAsymmetricKernel(int Width, int Height)
{
	FImage Kernel = FImage::Noise(Width, Height, 1.0, 7);
	Kernel.At(0, 0) = {2, 3, 1, 1};
	Kernel.At(Width / 2, Height / 2) = {40, 40, 40, 1};
	return Kernel;
}

/** Grey, and its middle a part of the rest: Scatter is 1/3 of Total. */
inline FImage MakeGreyKernel(int Size)
{
	FImage Kernel(Size, Size, {1, 1, 1, 1});
	const double Others = Size * Size - 1;
	Kernel.At(Size / 2, Size / 2) = {2 * Others, 2 * Others, 2 * Others, 1};
	return Kernel;
}

/** Black but for the middle. */
inline FImage MakeImpulse(int Width, int Height, double Value = 1)
{
	FImage Picture(Width, Height);
	Picture.At(Width / 2, Height / 2) = {Value, Value, Value, 1};
	return Picture;
}

inline bool Contains(const std::vector<std::string>& Passes, const std::string& Beginning)
{
	return std::any_of(
		Passes.begin(), Passes.end(), [&](const std::string& Pass) { return Pass.starts_with(Beginning); });
}

} // namespace PassTest
