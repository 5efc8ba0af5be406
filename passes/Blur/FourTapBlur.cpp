// The passes of Kawase's blur and of the Gaussian pyramid, and their factories. Source: Kawase, GDC 2003; Burt and
// Adelson, 1983.
#include "Blur/FourTapBlur.h"

#include "Blur/DualKawaseBlurOutput.h"
#include "Blur/FourTapShaders.h"
#include "Blur/MatchedGaussianBlur.h"
#include "PassFactory.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"
#include "Blur/DualKawaseBlurWidth.h"

#include <cmath>

namespace Drydock
{

IMPLEMENT_GLOBAL_SHADER(FFourTapCS, "/Drydock/Private/FourTapBlur.usf", "FourTapCS", SF_Compute);
IMPLEMENT_GLOBAL_SHADER(FOneTapCS, "/Drydock/Private/FourTapBlur.usf", "OneTapCS", SF_Compute);

namespace
{

template<typename ShaderType>
void AddTapPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input,
	const FScreenPassTexture& Output, FVector2f InputPerOutput, double TapDistance = 0.0, float InputOffset = 0.0f)
{
	const FIntPoint Size = Output.ViewRect.Size();
	FFourTapParameters* PassParameters = GraphBuilder.AllocParameters<FFourTapParameters>();
	PassParameters->Input = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Input));
	PassParameters->Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	PassParameters->InputCorner = FVector2f(Input.ViewRect.Min) + FVector2f(InputOffset, InputOffset);
	PassParameters->InputPerOutput = InputPerOutput;
	PassParameters->TapDistance = static_cast<float>(TapDistance);
	PassParameters->Sampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	PassParameters->Intexture = Input.Texture;
	PassParameters->OutTexture = GraphBuilder.CreateUAV(Output.Texture);
	FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("%s %dx%d (CS)", Output.Texture->Name, Size.X, Size.Y),
		TShaderMapRef<ShaderType>(View.ShaderMap), PassParameters,
		FComputeShaderUtils::GetGroupCount(Size, FourTapGroupSize));
}

/** The distance whose tap has this variance: between whole k and k + 1 it is k^2 + (2 k + 1) (d - k). */
double GetDistanceOfVariance(double Variance)
{
	const double Whole = std::floor(std::sqrt(Variance));
	const double Distance = Whole + (Variance - Whole * Whole) / (2.0 * Whole + 1.0);
	return std::nearbyint(Distance * GSubtexelSteps) / GSubtexelSteps;
}

// A level holds texels [-PyramidMargin, Distinct], counted from the rect's corner: beyond them all are the edge texel
// of the input, so that what clamps to them sees what the input's own clamping gives.
constexpr int32 PyramidMargin = 2;

float GetPyramidMargin(int32 Level)
{
	return Level == 0 ? 0.0f : static_cast<float>(PyramidMargin);
}

/** From this texel on a level is constant, given that of the finer one: texel j averages 2 j - 1 to 2 j + 2. */
FIntPoint GetDistinctTexels(FIntPoint Finer)
{
	return FIntPoint::DivideAndRoundUp(Finer + FIntPoint(1, 1), 2);
}

/** Variance of one level's passes, of all levels, in pixels^2: 3/2 (1 + 4 + ... + 4^(N-1)). */
double GetPyramidVariance(int32 Levels)
{
	return (std::exp2(2.0 * Levels) - 1.0) / 2.0;
}

double GetLowStandardDeviation(double StandardDeviation, int32 Levels)
{
	const double Rest = StandardDeviation * StandardDeviation - GetPyramidVariance(Levels);
	return Rest > 0.0 ? std::sqrt(Rest) * std::exp2(-Levels) : 0.0;
}

const FPassFactoryRegistration GKawase({
	.Type = "Kawase",
	.Doc = "Blurs an image by passes of four taps, each further out than the last.",
	.Inputs = {{"Input", PictureResource, "The image."}},
	.Parameters = {FParameterSpec::Number("StandardDeviation", 4, 0, 250, "Pixels.")},
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		return AddKawaseBlurPasses(
			GraphBuilder, View, Arguments.GetInput("Input"), Arguments.Values.GetNumber("StandardDeviation"));
	},
});

const FPassFactoryRegistration GPyramid({
	.Type = "PyramidBlur",
	.Doc = "A Gaussian at a lower resolution: [1 3 3 1] down and up, a small separable Gaussian between.",
	.Inputs = {{"Input", PictureResource, "The image."}},
	.Parameters = {FParameterSpec::Number("StandardDeviation", 8, 0, 1000, "Pixels.")},
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		return AddPyramidBlurPasses(
			GraphBuilder, View, Arguments.GetInput("Input"), Arguments.Values.GetNumber("StandardDeviation"));
	},
});

} // namespace

TArray<double> GetKawaseDistances(double StandardDeviation)
{
	TArray<double> Distances;
	double Rest = StandardDeviation > 0.0 ? StandardDeviation * StandardDeviation : 0.0;
	while (Rest > 0.0 && Distances.Num() < GKawaseMaxPasses)
	{
		const double Whole = Distances.Num();
		const double Variance = Whole * Whole + Whole + 0.5;
		const double Distance = Variance <= Rest ? Whole + 0.5 : GetDistanceOfVariance(Rest);
		if (Distance == 0.0)
		{
			break;
		}
		Distances.Add(Distance);
		Rest = Variance <= Rest ? Rest - Variance : 0.0;
	}
	return Distances;
}

double GetKawaseVariance(TConstArrayView<double> Distances)
{
	double Variance = 0.0;
	for (const double Distance : Distances)
	{
		const double Fraction = Distance - std::floor(Distance);
		Variance += Distance * Distance + Fraction * (1.0 - Fraction);
	}
	return Variance;
}

FPyramidSetting GetPyramidSetting(double StandardDeviation)
{
	constexpr double SmallestLow = 3.5;
	constexpr double SmallestOfOneLevel = 0.75;
	int32 Levels = GetLowStandardDeviation(StandardDeviation, 1) >= SmallestOfOneLevel ? 1 : 0;
	while (Levels > 0 && Levels < GPyramidMaxLevels &&
		   GetLowStandardDeviation(StandardDeviation, Levels + 1) >= SmallestLow)
	{
		++Levels;
	}
	return GetPyramidSetting(StandardDeviation, Levels);
}

FPyramidSetting GetPyramidSetting(double StandardDeviation, int32 Levels)
{
	int32 Taken = FMath::Clamp(Levels, 0, GPyramidMaxLevels);
	while (Taken > 0 && GetLowStandardDeviation(StandardDeviation, Taken) < 0.5)
	{
		--Taken;
	}
	return {Taken, GetLowStandardDeviation(StandardDeviation, Taken)};
}

FScreenPassTexture AddKawaseBlurPasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input, double StandardDeviation)
{
	check(Input.IsValid());
	RDG_EVENT_SCOPE(GraphBuilder, "KawaseBlur");
	FScreenPassTexture Current = Input;
	for (const double Distance : GetKawaseDistances(StandardDeviation))
	{
		const FScreenPassTexture Output(
			CreateBlurTexture(GraphBuilder, Input, Input.Texture->Desc.Extent, TEXT("KawaseBlur")), Input.ViewRect);
		AddTapPass<FFourTapCS>(GraphBuilder, View, Current, Output, FVector2f(1.0f, 1.0f), Distance);
		Current = Output;
	}
	return Current;
}

FScreenPassTexture AddPyramidBlurPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FScreenPassTexture& Input, const FPyramidSetting& Setting, FAddLowResolutionBlur Blur)
{
	check(Input.IsValid());
	RDG_EVENT_SCOPE(GraphBuilder, "PyramidBlur");
	/** A quarter bilinear weight on the outer texels: 1/8, 3/8, 3/8, 1/8 along each axis. */
	constexpr double BinomialDistance = 0.75;
	TArray<FScreenPassTexture> Levels;
	Levels.Add(Input);
	FIntPoint Distinct = Input.ViewRect.Size() - FIntPoint(1, 1);
	for (int32 Level = 1; Level <= Setting.Levels; ++Level)
	{
		Distinct = GetDistinctTexels(Distinct);
		const FIntPoint Size = Distinct + FIntPoint(PyramidMargin + 1, PyramidMargin + 1);
		const FScreenPassTexture Output(CreateBlurTexture(GraphBuilder, Input, Size, TEXT("PyramidDown")));
		AddTapPass<FFourTapCS>(GraphBuilder, View, Levels.Last(), Output, FVector2f(2.0f, 2.0f), BinomialDistance,
			GetPyramidMargin(Level - 1) - 2.0f * PyramidMargin);
		Levels.Add(Output);
	}
	FScreenPassTexture Current =
		Setting.LowStandardDeviation > 0.0 ? Blur(Levels.Last(), Setting.LowStandardDeviation) : Levels.Last();
	for (int32 Level = Setting.Levels - 1; Level >= 0; --Level)
	{
		const FIntPoint Extent = Level == 0 ? Input.Texture->Desc.Extent : Levels[Level].ViewRect.Size();
		const FScreenPassTexture Output(
			CreateBlurTexture(GraphBuilder, Input, Extent, TEXT("PyramidUp")), Levels[Level].ViewRect);
		AddTapPass<FOneTapCS>(GraphBuilder, View, Current, Output, FVector2f(0.5f, 0.5f), 0.0,
			PyramidMargin - 0.5f * GetPyramidMargin(Level));
		Current = Output;
	}
	return Current;
}

FScreenPassTexture AddPyramidBlurPasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input, double StandardDeviation)
{
	return AddPyramidBlurPasses(GraphBuilder, View, Input, GetPyramidSetting(StandardDeviation),
		[&](const FScreenPassTexture& Low, double LowStandardDeviation)
		{
			FMatchedGaussianBlurInputs Inputs;
			Inputs.SceneColor = Low;
			Inputs.StandardDeviation = LowStandardDeviation;
			Inputs.ReachInDeviations = 4.0; // at 3 the tails that it lacks are most of the pyramid's error
			Inputs.bSeparable = true;
			return AddMatchedGaussianBlurPasses(GraphBuilder, View, Inputs);
		});
}

FScreenPassTexture AddBilinearStretchPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input, const FScreenPassTexture& Like)
{
	check(Input.IsValid() && Like.IsValid());
	const FScreenPassTexture Output(
		CreateBlurTexture(GraphBuilder, Like, Like.Texture->Desc.Extent, TEXT("BilinearStretch")), Like.ViewRect);
	AddTapPass<FOneTapCS>(
		GraphBuilder, View, Input, Output, FVector2f(Input.ViewRect.Size()) / FVector2f(Like.ViewRect.Size()));
	return Output;
}

} // namespace Drydock
