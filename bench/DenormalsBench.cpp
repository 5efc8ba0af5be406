// What denormal numbers cost: blurs and bloom of a picture of denormals against one of ordinary numbers, in 32-bit
// storage, and of denormal halves in half storage. The two alternate inside one measurement; medians of 15. Prints a
// table in Markdown and exits with 1 where a ratio is above 2.
//
//     bench_denormals [WIDTH]
#include "Bloom/PostProcessGaussianBloom.h"
#include "Blur/DualKawaseBlurPass.h"
#include "Blur/FourTapBlur.h"
#include "Blur/PostProcessWeightedSampleSum.h"
#include "HAL/IConsoleManager.h"
#include "RHICommandList.h"
#include "RenderGraphBuilder.h"
#include "RenderTargetPool.h"
#include "SceneRendering.h"
#include "TileExecutor.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>

using namespace Drydock;

namespace
{

constexpr int GRepetitions = 15;
constexpr double GMostRatio = 2.0;

using FAddPasses = std::function<FScreenPassTexture(FRDGBuilder&, const FViewInfo&, const FScreenPassTexture&)>;

struct FEffect
{
	const char* Name;
	FAddPasses Add;
};

FScreenPassTexture AddGaussian(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input)
{
	FGaussianBlurInputs Inputs;
	Inputs.NameX = TEXT("BlurX");
	Inputs.NameY = TEXT("BlurY");
	Inputs.Filter = Input;
	Inputs.KernelSizePercent = 5.0f;
	Inputs.UseClampAddressMode = true;
	return AddGaussianBlurPass(GraphBuilder, View, Inputs);
}

FScreenPassTexture AddDualKawase(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input)
{
	FDualKawaseBlurInputs Inputs;
	Inputs.SceneColor = Input;
	return AddDualKawaseBlurPass(GraphBuilder, View, Inputs);
}

FScreenPassTexture AddBloom(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input)
{
	FTextureDownsampleChain Chain;
	Chain.Init(GraphBuilder, View, Input, EDownsampleQuality::High);
	return AddGaussianBloomPasses(GraphBuilder, View, &Chain);
}

FScreenPassTexture AddPyramid(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input)
{
	return AddPyramidBlurPasses(GraphBuilder, View, Input, 16.0);
}

/** A pattern of values from Scale to 2 Scale. */
FTextureRHIRef MakePicture(FIntPoint Size, EPixelFormat Format, double Scale)
{
	const FTextureRHIRef Texture = new FRHITexture(
		FRDGTextureDesc::Create2D(Size, Format, FClearValueBinding::None, TexCreate_ShaderResource), TEXT("Picture"));
	for (int32 Y = 0; Y < Size.Y; ++Y)
	{
		for (int32 X = 0; X < Size.X; ++X)
		{
			const double Value = Scale * (1.0 + (X * 7 + Y * 13) % 64 / 64.0);
			Texture->WriteTexelDouble(X, Y, FVector4(Value, Value, Value, Value));
		}
	}
	return Texture;
}

double Measure(const FTextureRHIRef& Picture, const FEffect& Effect)
{
	const FIntPoint Size = Picture->GetSizeXY();
	FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList(), RDG_EVENT_NAME("Denormals"));
	FViewInfo View(nullptr, FIntRect(FIntPoint(0, 0), Size), Size);
	const FScreenPassTexture Input(GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Picture, TEXT("Picture"))));
	TRefCountPtr<IPooledRenderTarget> Extracted;
	GraphBuilder.QueueTextureExtraction(Effect.Add(GraphBuilder, View, Input).Texture, &Extracted);
	const auto Start = std::chrono::steady_clock::now();
	GraphBuilder.Execute();
	return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - Start).count();
}

double Median(std::vector<double> Values)
{
	std::nth_element(Values.begin(), Values.begin() + GRepetitions / 2, Values.end());
	return Values[GRepetitions / 2];
}

} // namespace

int main(int NumArguments, char** Arguments)
{
	const int32 Width = NumArguments > 1 ? std::max(16, std::atoi(Arguments[1])) : 960;
	const FIntPoint Size(Width, Width * 9 / 16);
	const FEffect Effects[] = {{"Gaussian blur", AddGaussian}, {"dual Kawase blur", AddDualKawase},
		{"bloom, sum of Gaussians", AddBloom}, {"pyramid blur", AddPyramid}};
	struct FStore
	{
		const char* Name;
		EPixelFormat Format;
		double Denormal;
	};
	const FStore Stores[] = {
		{"32-bit, 1e-40", PF_A32B32G32R32F, 1e-40}, {"half, 2^-24 x 64", PF_FloatRGBA, std::exp2(-18.0)}};

	std::printf(
		"%d x %d, %d threads\n\n| effect | storage | ordinary, ms | denormal, ms | ratio |\n|---|---|--:|--:|--:|\n",
		Size.X, Size.Y, GetNumThreads());
	bool bWithin = true;
	for (const FEffect& Effect : Effects)
	{
		for (const FStore& Store : Stores)
		{
			const FTextureRHIRef Ordinary = MakePicture(Size, Store.Format, 0.5);
			const FTextureRHIRef Denormal = MakePicture(Size, Store.Format, Store.Denormal);
			Measure(Ordinary, Effect); // kernels and memory
			std::vector<double> OrdinaryTimes, DenormalTimes;
			for (int Index = 0; Index < GRepetitions; ++Index)
			{
				OrdinaryTimes.push_back(Measure(Ordinary, Effect));
				DenormalTimes.push_back(Measure(Denormal, Effect));
			}
			const double Ratio = Median(DenormalTimes) / Median(OrdinaryTimes);
			bWithin = bWithin && Ratio <= GMostRatio;
			std::printf("| %s | %s | %.2f | %.2f | %.2f |\n", Effect.Name, Store.Name, Median(OrdinaryTimes),
				Median(DenormalTimes), Ratio);
		}
	}
	return bWithin ? 0 : 1;
}
