// The tonemapper with its combined table in lanes. Stands in for PostProcessTonemap.usf with its bits; left to the
// shader are permutations without the table or for devices of high dynamic range, pictures as grain or dirt, noise for
// quantization, and what FFT bloom leaves of the scene.
#include "NativeFallback.h"
#include "NativeKernels.h"
#include "Native/NativeLanes.h"
#include "Native/SampledTexturePass.h"
#include "Native/TapSumPass.h"
#include "Native/TonemapLanes.h"
#include "Tonemap/TonemapShaders.h"

namespace Drydock
{

namespace
{

bool IsKnown(const FTonemapPermutation& Permutation)
{
	const auto Device = Permutation.Get<FColorRemapPermutation>().Get<FOutputDeviceDimension>();
	return Permutation.Get<FTonemapLUTDimension>() && !Permutation.Get<FTonemapGammaOnlyDimension>() &&
		   !Permutation.Get<FTonemapDirtMaskDimension>() && !Permutation.Get<FTonemapFilmGrainTextureDimension>() &&
		   !Permutation.Get<FTonemapGrainQuantizationDimension>() &&
		   !Permutation.Get<FTonemapSceneColorApplyDimension>() &&
		   Device < EDisplayOutputFormat::HDR_ACES_1000nit_ST2084;
}

void SetLens(const FTonemapPermutation& Permutation, const FTonemapParameters& Parameters, FTonemapJob& Job)
{
	Job.bFringe = Permutation.Get<FTonemapColorFringeDimension>();
	Job.FringeShifts[0] = 0.5f * Parameters.ChromaticAberrationParams.X;
	Job.FringeShifts[1] = 0.5f * Parameters.ChromaticAberrationParams.Y;
	Job.FringeStart = Parameters.ChromaticAberrationParams.Z;
	Job.bSharpen = Permutation.Get<FTonemapSharpenDimension>();
	Job.SharpenAmount = Parameters.SharpenAmount;
	Job.bVignette = Permutation.Get<FTonemapVignetteDimension>();
	Job.VignetteIntensity = Parameters.VignetteIntensity;
	for (int Axis = 0; Axis < 2; ++Axis)
	{
		Job.NeighborSteps[Axis] = Parameters.Color.ViewportSizeInverse[Axis];
		Job.VignetteScale[Axis] = Parameters.VignetteScale[Axis];
	}
	Job.bFilmGrain = Permutation.Get<FTonemapFilmGrainDimension>();
	Job.GrainFrame = Parameters.FilmGrainFrame;
	for (int i = 0; i < 3; ++i)
	{
		Job.GrainIntensities[i] = Parameters.FilmGrainIntensities[i];
	}
	for (int i = 0; i < 4; ++i)
	{
		Job.GrainRanges[i] = Parameters.FilmGrainRanges[i];
	}
}

/** False where the shader has to do it. */
bool MakeTonemapJob(const FNativeKernelArgs& Args, const FTonemapPermutation& Permutation,
	const FTonemapParameters& Parameters, FTonemapJob& Job)
{
	Job.Color = MakeSampledTexture(Args, "ColorTexture", "ColorSampler", Parameters.Color);
	Job.Table = Args.FindTexture("ColorGradingLUT");
	const FKernelSampler* const TableSampler = Args.FindSampler("ColorGradingSampler");
	if (!CanSampleInLanes(Job.Color.Texture, Job.Color.Sampler) || !CanSampleInLanes(Job.Table, TableSampler) ||
		TableSampler->AddressU != EKernelAddress::Clamp || TableSampler->AddressV != EKernelAddress::Clamp)
	{
		return false;
	}
	float EyeAdaptation[4];
	ReadEyeAdaptation(Args, "EyeAdaptationBuffer", EyeAdaptation);
	const float OneOverPreExposure = GetOneOverPreExposure(Parameters.View);
	const FIntPoint Size = FIntPoint(Parameters.Output.ViewportMax) - FIntPoint(Parameters.Output.ViewportMin);
	Job.Pass = Args.GetPass();
	Job.NumPixels = int64(Size.X) * Size.Y;
	SetViewport(Parameters.Output, Job.Viewport);
	Job.Exposure = OneOverPreExposure * EyeAdaptation[0];
	Job.ColorScale[0] = Parameters.ColorScale0.R;
	Job.ColorScale[1] = Parameters.ColorScale0.G;
	Job.ColorScale[2] = Parameters.ColorScale0.B;
	Job.TableSize = Parameters.Remap.LUTSize;
	Job.LumaToAlpha = Parameters.bWriteLumaToAlpha;
	SetLens(Permutation, Parameters, Job);
	Job.bBloom = Permutation.Get<FTonemapBloomDimension>();
	if (Job.bBloom)
	{
		Job.Bloom = MakeSampledTexture(Args, "BloomTexture", "BloomSampler", Parameters.Bloom);
		if (!CanSampleInLanes(Job.Bloom.Texture, Job.Bloom.Sampler))
		{
			return false;
		}
	}
	Job.bLocalExposure = Permutation.Get<FTonemapLocalExposureDimension>();
	return !Job.bLocalExposure ||
		   MakeLocalExposureJob(Args, Parameters, EyeAdaptation, OneOverPreExposure, Job.LocalExposure);
}

bool RunTonemapLanes(const FTonemapJob& Job, const FTapTarget& Target)
{
	return WithNativeLanes<TTonemapLanes>([&](auto Lanes) { return Lanes.Run(Job, *Target.Texture, Target.Pixels); });
}

void RunTonemap(const FNativeKernelArgs& Args, const FKernelTile& Tile, const FTonemapParameters& Parameters,
	const FTapTarget& Target)
{
	const FTonemapPermutation Permutation(Args.GetPermutationId());
	const FKernelTile& Pixels = Target.Pixels;
	if (Pixels.MaxX <= Pixels.MinX || Pixels.MaxY <= Pixels.MinY)
	{
		return;
	}
	FTonemapJob Job;
	if (!IsKnown(Permutation) || !StoresPlainly(Args.GetArgs()) || !IsInsideTarget(Target.Texture, Pixels) ||
		!MakeTonemapJob(Args, Permutation, Parameters, Job) || !RunTonemapLanes(Job, Target))
	{
		RunShader(Args, Tile);
	}
}

void RunTonemapPixels(const FNativeKernelArgs& Args, const FKernelTile& Tile)
{
	RunTonemap(Args, Tile, GetNativeParameters<FTonemapPS>(Args).Common, GetPixelTarget(Args, Tile));
}

void RunTonemapThreads(const FNativeKernelArgs& Args, const FKernelTile& Tile)
{
	const FTonemapParameters& Parameters = GetNativeParameters<FTonemapCS>(Args).Common;
	RunTonemap(Args, Tile, Parameters,
		GetComputeTarget(Args, Tile, "RWOutputTexture", Parameters.Output.ViewportMin, Parameters.Output.ViewportMax));
}

} // namespace

REGISTER_NATIVE_KERNEL(FTonemapPS, &RunTonemapPixels, "7c17ef7796637807")
REGISTER_NATIVE_KERNEL(FTonemapCS, &RunTonemapThreads, "7c17ef7796637807")

} // namespace Drydock
