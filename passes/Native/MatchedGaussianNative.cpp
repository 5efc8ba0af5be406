// The rows and the columns of the separable Gaussian as sums of texels. Stands in for the Gaussian of
// DualKawaseBlur.usf with its bits; both directions at once, which few texels can afford, are left to the shader.
#include "Blur/MatchedGaussianShaders.h"
#include "NativeFallback.h"
#include "NativeKernels.h"
#include "Native/NativeLanes.h"
#include "Native/SampledTexturePass.h"
#include "Native/TapSumPass.h"
#include "Native/TexelSum.h"
#include "PixelFormatConversion.h"

namespace Drydock
{

namespace
{

/** False where the shader has to do it. */
bool MakeTexelSum(const FNativeKernelArgs& Args, const FDualKawaseGaussianCS::FParameters& Parameters, FTexelSum& Sum)
{
	const FKernelBuffer* const Weights = Args.FindBuffer("Weights");
	const FIntPoint Reach = Parameters.Reach;
	Sum.Source = Args.FindTexture("Intexture");
	Sum.Axis = Reach.X > 0 ? 0 : 1;
	Sum.Reach = Reach[Sum.Axis];
	if (!Sum.Source || !Weights || Sum.Source->bIs3D || !HasFloatLanes(Sum.Source->Storage) || Sum.Reach <= 0 ||
		Reach[1 - Sum.Axis] != 0 || Weights->SizeInBytes / sizeof(float) < uint32(Sum.Reach) + 1)
	{
		return false;
	}
	Sum.Weights = reinterpret_cast<const float*>(Weights->Data);
	const FKernelMip& Mip = Sum.Source->Mips[0];
	const int32 Size[2] = {Mip.SizeX, Mip.SizeY};
	bool bInside = true;
	for (int Axis = 0; Axis < 2; ++Axis)
	{
		Sum.RectMin[Axis] = Parameters.Input.ViewportMin[Axis];
		Sum.RectMax[Axis] = Parameters.Input.ViewportMax[Axis];
		bInside = bInside && Sum.RectMin[Axis] >= 0 && Sum.RectMin[Axis] < Sum.RectMax[Axis] &&
				  Sum.RectMax[Axis] <= Size[Axis];
	}
	return bInside;
}

void RunMatchedGaussian(const FNativeKernelArgs& Args, const FKernelTile& Tile)
{
	const auto& Parameters = GetNativeParameters<FDualKawaseGaussianCS>(Args);
	const FIntPoint Min = Parameters.Output.ViewportMin;
	const FTapTarget Target = GetComputeTarget(Args, Tile, "OutTexture", Min, Parameters.Output.ViewportMax);
	FTexelSum Sum;
	if (!StoresPlainly(Args.GetArgs()) || !IsInsideTarget(Target.Texture, Target.Pixels) ||
		!MakeTexelSum(Args, Parameters, Sum))
	{
		RunShader(Args, Tile);
		return;
	}
	if (Target.Pixels.MaxX <= Target.Pixels.MinX || Target.Pixels.MaxY <= Target.Pixels.MinY)
	{
		return;
	}
	const int32 ToSourceX = Sum.RectMin[0] - Min.X;
	const int32 ToSourceY = Sum.RectMin[1] - Min.Y;
	WithNativeLanes<TTexelSumLanes>(
		[&](auto Lanes) { return Lanes.Run(Sum, *Target.Texture, Target.Pixels, ToSourceX, ToSourceY); });
}

} // namespace

REGISTER_NATIVE_KERNEL(FDualKawaseGaussianCS, &RunMatchedGaussian, "c93cbbe88b4e075f")

} // namespace Drydock
