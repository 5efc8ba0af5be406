// Builds and matches the blurs of a study, and runs them through the graph or, the exact one, as plain code. Each blur
// names its source where it is.
#include "Study/BlurAlgorithms.h"

#include "Math/ToInteger.h"
#include "Study/BlurExact.h"

#include "Bloom/FFTConvolution.h"
#include "Blur/DualKawaseBlurOutput.h"
#include "Blur/DualKawaseBlurPass.h"
#include "Blur/DualKawaseBlurWidth.h"
#include "Blur/FourTapBlur.h"
#include "Blur/GaussianSum.h"
#include "Blur/MatchedGaussianBlur.h"
#include "Picture/Picture.h"
#include "RHICommandList.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphObserver.h"
#include "RenderGraphUtils.h"
#include "RenderTargetPool.h"
#include "Run/RunDump.h"
#include "Run/RunSetup.h"
#include "Run/VariableTaps.h"
#include "SceneRendering.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

namespace Drydock
{

namespace
{

/** Adds a blur to a graph; gives the blurred picture. */
using FAddBlur =
	std::function<FScreenPassTexture(FRDGBuilder&, const FViewInfo&, const FScreenPassTexture& Input, double Sigma)>;

EPixelFormat GetFormat(const std::string& Storage)
{
	return Storage == "float16"     ? PF_FloatRGBA
		   : Storage == "R11G11B10" ? PF_FloatR11G11B10
		   : Storage == "8bit"      ? PF_R8G8B8A8
									: PF_A32B32G32R32F;
}

// The graph's algorithms --------------------------------------------------------------------------------------------

FScreenPassTexture AddMatchedGaussian(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input, double Sigma, bool bSeparable)
{
	FMatchedGaussianBlurInputs Inputs;
	Inputs.SceneColor = Input;
	Inputs.StandardDeviation = Sigma;
	Inputs.bSeparable = bSeparable;
	return AddMatchedGaussianBlurPasses(GraphBuilder, View, Inputs);
}

FScreenPassTexture AddSeparable(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input, double Sigma)
{
	return AddMatchedGaussian(GraphBuilder, View, Input, Sigma, true);
}

FScreenPassTexture AddDirect(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input, double Sigma)
{
	return AddMatchedGaussian(GraphBuilder, View, Input, Sigma, false);
}

FScreenPassTexture AddDualKawase(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input, double Sigma)
{
	const FDualKawaseSetting Setting = MatchDualKawaseWidth(Sigma).Setting;
	FDualKawaseBlurInputs Inputs;
	Inputs.SceneColor = Input;
	Inputs.PassNum = Setting.PassNum;
	Inputs.Offset = static_cast<float>(Setting.Offset);
	return AddDualKawaseBlurPass(GraphBuilder, View, Inputs);
}

FScreenPassTexture AddPyramid(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input, double Sigma)
{
	return AddPyramidBlurPasses(GraphBuilder, View, Input, Sigma);
}

/** The level of the bloom's chain (1: half size) whose blur of this width stays within the engine's 32 taps: its
 * kernel's deviation is 0.173 of a radius of at most 31 texels. */
int32 GetGaussianSumLevel(double Sigma)
{
	int32 Level = 1;
	while (Sigma / std::exp2(Level) > 5.0 && Level < 8)
	{
		++Level;
	}
	return Level;
}

/** One Gaussian of the engine's sum on one level of the chain, stretched back bilinearly as its readers do. */
FAddBlur MakeGaussianSum(double Sigma)
{
	return [Level = GetGaussianSumLevel(Sigma)](
			   FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input, double Requested)
	{
		// exp(-16.7 (x / R)^2) has the deviation R / sqrt(2 * 16.7).
		const double Radius = Requested * std::exp2(-Level) * std::sqrt(2.0 * 16.7);
		int32 LevelWidth = Input.ViewRect.Width();
		for (int32 Halving = 0; Halving < Level; ++Halving)
		{
			LevelWidth = FMath::DivideAndRoundUp(LevelWidth, 2);
		}
		FGaussianSumInputs Inputs;
		for (int32 Stage = 0; Stage < Level; ++Stage)
		{
			Inputs.Stages.Add({TEXT("GaussianSumX"), TEXT("GaussianSumY"),
				Stage == 0 ? static_cast<float>(200.0 * Radius / LevelWidth) : 0.0f});
		}
		Inputs.StageCount = 1;
		Inputs.bClampAddressing = true;
		const FScreenPassTexture Blurred = AddTextureGaussianSumPasses(
			GraphBuilder, View, Input, Input.Texture->Desc.Format, TEXT("GaussianSum"), Inputs);
		return AddBilinearStretchPass(GraphBuilder, View, Blurred, Input);
	};
}

FAddBlur MakeGraphBlur(const std::string& Name, double Sigma)
{
	return Name == "GaussianSum"  ? MakeGaussianSum(Sigma)
		   : Name == "Direct"     ? FAddBlur(AddDirect)
		   : Name == "Kawase"     ? FAddBlur(AddKawaseBlurPasses)
		   : Name == "DualKawase" ? FAddBlur(AddDualKawase)
		   : Name == "Pyramid"    ? FAddBlur(AddPyramid)
								  : FAddBlur(AddSeparable);
}

/** A kernel's spectrum is made once and kept, as the engine does: its passes do not count. */
const char* const GKernelName = "BlurKernel";

class FBlurObserver final : public IRDGObserver
{
public:
	void OnPassExecuted(int32_t, const FRDGPass& Pass, double Milliseconds, const FPassCounters& Counters,
		const std::vector<FRDGTexture*>&) override
	{
		if (std::string(Pass.GetName()).find(GKernelName) != std::string::npos)
		{
			return;
		}
		Run.Milliseconds += Milliseconds;
		const std::optional<uint64_t> Taps = CountTaps(Pass, Counters);
		// By the text of a shader, threads that fill up the last groups tap like the others.
		const double Wanted = Counters.TapCount != ETapCount::Static
								  ? 1.0
								  : static_cast<double>(CountWantedPixels(Pass, Counters)) /
										static_cast<double>(std::max<uint64_t>(1, Counters.Pixels));
		Run.TapsPerPixel += Taps ? static_cast<double>(*Taps) * Wanted : std::nan("");
		Run.BytesPerPixel += static_cast<double>(Counters.BytesRead + Counters.BytesWritten);
		++Run.NumPasses;
	}

	FBlurRun Run;
};

FTextureRHIRef MakeTexture(const FImage& Image, EPixelFormat Format)
{
	const FIntPoint Size(Image.Width, Image.Height);
	const FTextureRHIRef Texture = new FRHITexture(
		FRDGTextureDesc::Create2D(Size, Format, FClearValueBinding::None, TexCreate_ShaderResource), TEXT("Input"));
	for (int32 Y = 0; Y < Size.Y; ++Y)
	{
		for (int32 X = 0; X < Size.X; ++X)
		{
			Texture->WriteTexelDouble(
				X, Y, FVector4(Image.Get(X, Y, 0), Image.Get(X, Y, 1), Image.Get(X, Y, 2), Image.Get(X, Y, 3)));
		}
	}
	return Texture;
}

/** Channels that a format lacks: 0, alpha 1. */
FImage ReadRgba(FRHITexture& Texture)
{
	return FPicture(&Texture, FIntRect(FIntPoint(0, 0), Texture.GetSizeXY())).ToImage();
}

FBlurRun RunGraph(const FImage& Image, const FAddBlur& AddBlur, double Sigma, const FBlurArithmetic& Arithmetic)
{
	FRunVariables Variables;
	Variables.Set("r.Drydock.Precision", Arithmetic.bDouble ? "1" : "0");
	Variables.Set("r.Drydock.Storage", Arithmetic.bDouble ? "2" : "0");
	Variables.Set("r.Drydock.SampleBits", Arithmetic.bDouble ? "0" : "8");
	const FTextureRHIRef Texture = MakeTexture(Image, GetFormat(Arithmetic.Storage));
	const FIntPoint Size(Image.Width, Image.Height);
	FBlurObserver Observer;
	FViewInfo View(nullptr, FIntRect(FIntPoint(0, 0), Size), Size);
	FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList(), RDG_EVENT_NAME("Blur"));
	GraphBuilder.SetObserver(&Observer);
	const FScreenPassTexture Input(GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Texture, TEXT("Input"))));
	const FScreenPassTexture Output =
		Arithmetic.ResolutionLevels == 0
			? AddBlur(GraphBuilder, View, Input, Sigma)
			: AddPyramidBlurPasses(GraphBuilder, View, Input, GetPyramidSetting(Sigma, Arithmetic.ResolutionLevels),
				  [&](const FScreenPassTexture& Low, double LowSigma)
				  { return AddBlur(GraphBuilder, View, Low, LowSigma); });
	FBlurRun Run;
	if (Output.Texture == Input.Texture)
	{
		GraphBuilder.Execute();
		Run = Observer.Run;
		Run.Image = ReadRgba(*Texture);
	}
	else
	{
		TRefCountPtr<IPooledRenderTarget> Extracted;
		GraphBuilder.QueueTextureExtraction(Output.Texture, &Extracted);
		GraphBuilder.Execute();
		Run = Observer.Run;
		Run.Image = ReadRgba(*Extracted->GetRHI());
	}
	const double NumPixels = static_cast<double>(Size.X) * Size.Y;
	Run.TapsPerPixel /= NumPixels;
	Run.BytesPerPixel /= NumPixels;
	return Run;
}

// By spectra ----------------------------------------------------------------------------------------------------------

/** The image with its edge texels repeated to every side, as the transform knows no edges. */
FImage Extend(const FImage& Image, int Margin)
{
	FImage Extended{Image.Width + 2 * Margin, Image.Height + 2 * Margin, 4, {}};
	Extended.Values.reserve(static_cast<size_t>(Extended.Width) * static_cast<size_t>(Extended.Height) * 4);
	for (int Y = -Margin; Y < Image.Height + Margin; ++Y)
	{
		for (int X = -Margin; X < Image.Width + Margin; ++X)
		{
			for (int Channel = 0; Channel < 4; ++Channel)
			{
				Extended.Values.push_back(
					Image.Get(std::clamp(X, 0, Image.Width - 1), std::clamp(Y, 0, Image.Height - 1), Channel));
			}
		}
	}
	return Extended;
}

/** A Gaussian whose middle is texel 0, going around: weights sum to 1. */
FImage MakeWrappedGaussian(FIntPoint Size, double Sigma)
{
	const auto MakeAxis = [Sigma](int Length)
	{
		std::vector<double> Weights(static_cast<size_t>(Length));
		double Sum = 0.0;
		for (int Index = 0; Index < Length; ++Index)
		{
			const double Distance = std::min(Index, Length - Index) / Sigma;
			Weights[static_cast<size_t>(Index)] = std::exp(-0.5 * Distance * Distance);
			Sum += Weights[static_cast<size_t>(Index)];
		}
		for (double& Weight : Weights)
		{
			Weight /= Sum;
		}
		return Weights;
	};
	const std::vector<double> Columns = MakeAxis(Size.X);
	const std::vector<double> Rows = MakeAxis(Size.Y);
	FImage Kernel{Size.X, Size.Y, 4, {}};
	for (const double Row : Rows)
	{
		for (const double Column : Columns)
		{
			const double Weight = Row * Column;
			Kernel.Values.insert(Kernel.Values.end(), {Weight, Weight, Weight, 0.0});
		}
	}
	return Kernel;
}

/** The bloom's transforms, over the image and 5 deviations of its edge around it. */
FBlurRun RunFFT(const FImage& Image, double Sigma)
{
	const int Margin = ToCount(std::ceil(5.0 * Sigma), 0, 1 << 14);
	const FImage Extended = Extend(Image, Margin);
	const FIntPoint Size(Extended.Width, Extended.Height);
	const FFFTDomain Domain = FFFTDomain::Make(Size, Size);
	const auto Add = [&](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input, double)
	{
		const FTextureRHIRef KernelTexture =
			MakeTexture(MakeWrappedGaussian(Domain.FrequencySize, Sigma), PF_A32B32G32R32F);
		const FScreenPassTexture Kernel(
			GraphBuilder.RegisterExternalTexture(CreateRenderTarget(KernelTexture, TEXT("BlurKernel"))));
		const TArray<FVector4f> One = {FVector4f(1.0f, 1.0f, 1.0f, 1.0f)};
		const FRDGBufferRef Scale = CreateStructuredBuffer(GraphBuilder, TEXT("BlurScale"), One);
		const FScreenPassTexture Output(
			CreateBlurTexture(GraphBuilder, Input, Size, TEXT("BlurByFFT")), Input.ViewRect);
		AddInverseFFTPasses(GraphBuilder, Domain,
			AddMultiplySpectraPass(GraphBuilder, View, Domain,
				AddForwardFFTPasses(GraphBuilder, Domain, Input, TEXT("BlurSpectrum")),
				AddForwardFFTPasses(GraphBuilder, Domain, Kernel, TEXT("BlurKernel")), Scale),
			Output);
		return Output;
	};
	FBlurRun Run = RunGraph(Extended, Add, Sigma, {});
	FImage Inner{Image.Width, Image.Height, 4, {}};
	for (int Y = 0; Y < Image.Height; ++Y)
	{
		for (int X = 0; X < Image.Width; ++X)
		{
			for (int Channel = 0; Channel < 4; ++Channel)
			{
				Inner.Values.push_back(Run.Image.Get(X + Margin, Y + Margin, Channel));
			}
		}
	}
	Run.Image = std::move(Inner);
	// Per pixel of the image. A line of N texels is transformed in log2 N steps of two reads each, there and back.
	const double NumPixels = static_cast<double>(Image.Width) * Image.Height;
	const double Frequencies = static_cast<double>(Domain.FrequencySize.X) * Domain.FrequencySize.Y;
	Run.BytesPerPixel *= static_cast<double>(Size.X) * Size.Y / NumPixels;
	Run.TapsPerPixel =
		4.0 * (std::log2(Domain.FrequencySize.X) + std::log2(Domain.FrequencySize.Y)) * Frequencies / NumPixels;
	return Run;
}

// Plain code --------------------------------------------------------------------------------------------------------

FBlurRun RunExact(const FImage& Image, double Sigma)
{
	FBlurRun Run;
	const auto Begin = std::chrono::steady_clock::now();
	Run.Image = BlurExact(Image, Sigma);
	Run.Milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - Begin).count();
	Run.TapsPerPixel = GetExactTaps(Sigma);
	Run.BytesPerPixel = 4.0 * sizeof(double) * Image.NumChannels; // along each axis read and written
	Run.NumPasses = 2;
	return Run;
}

} // namespace

FBlur::FBlur(const std::string& Name, double InSigma, const FBlurArithmetic& InArithmetic)
	: Algorithm(*FindBlurAlgorithm(Name))
	, Sigma(InSigma)
	, Requested(InSigma)
	, Arithmetic(InArithmetic)
{
	Match();
}

bool FBlur::IsMatched() const
{
	return std::abs(MeasuredSigma / Sigma - 1.0) <= 0.01;
}

FBlurRun FBlur::RunAs(const FImage& Image, const FBlurArithmetic& As) const
{
	if (Algorithm.Name == "FFT")
	{
		return RunFFT(Image, Requested);
	}
	const double LowSigma = Sigma * std::exp2(-As.ResolutionLevels);
	return Algorithm.bGraph ? RunGraph(Image, MakeGraphBlur(Algorithm.Name, LowSigma), Requested, As)
							: RunExact(Image, Requested);
}

/** One run for a block of impulses: its columns hold 1, x and x^2 in their channels, the same in all rows, so that the
 * other axis drops out. The block is as wide as the coarsest texel of any level, the margin wider than any response. */
double FBlur::MeasureVariance(bool bVertical) const
{
	int Block = 16;
	while (Block < Sigma)
	{
		Block *= 2;
	}
	const int Margin = (ToCount(10.0 * Sigma, 0, 1 << 14) / Block + 1) * Block;
	const bool bLevels = Arithmetic.ResolutionLevels > 0 || Algorithm.Name == "GaussianSum" ||
						 Algorithm.Name == "DualKawase" || Algorithm.Name == "Pyramid";
	const int Length = 2 * Margin + Block;
	const int Across = bLevels ? 2 * Block : 2;
	const int Middle = Margin + Block / 2;
	const auto Centre = [Middle](int Along)
	{
		return static_cast<double>(Along - Middle);
	};
	FImage Strip{bVertical ? Across : Length, bVertical ? Length : Across, 4, {}};
	for (int Y = 0; Y < Strip.Height; ++Y)
	{
		for (int X = 0; X < Strip.Width; ++X)
		{
			const int Along = bVertical ? Y : X;
			const double In = Centre(Along);
			const double Lit = Along >= Margin && Along < Margin + Block ? 1.0 : 0.0;
			Strip.Values.insert(Strip.Values.end(), {Lit, Lit * In, Lit * In * In, 0.0});
		}
	}
	FBlurArithmetic Float;
	Float.ResolutionLevels = Arithmetic.ResolutionLevels;
	const FImage Blurred = RunAs(Strip, Float).Image;
	double Sum = 0.0;
	double Mean = 0.0;
	double Square = 0.0;
	for (int Along = 0; Along < Length; ++Along)
	{
		const auto Get = [&](int Channel)
		{
			return bVertical ? Blurred.Get(Across / 2, Along, Channel) : Blurred.Get(Along, Across / 2, Channel);
		};
		const double Out = Centre(Along);
		Sum += Get(0);
		Mean += Out * Get(0) - Get(1);
		Square += Out * Out * Get(0) - 2.0 * Out * Get(1) + Get(2);
	}
	return std::max(0.0, Square / Sum - Mean / Sum * Mean / Sum);
}

/** The engine's blur is not equally wide both ways: its horizontal pass may work at half width. */
double FBlur::Measure() const
{
	const double Variance = MeasureVariance(false);
	return std::sqrt(Algorithm.Name == "GaussianSum" ? (Variance + MeasureVariance(true)) / 2.0 : Variance);
}

void FBlur::Match()
{
	constexpr int MostSteps = 4;
	constexpr double GoodEnough = 5e-4;
	double Best = Requested;
	for (int Step = 0; Step < MostSteps; ++Step)
	{
		const double Measured = Measure();
		if (Step == 0 || std::abs(Measured - Sigma) < std::abs(MeasuredSigma - Sigma))
		{
			MeasuredSigma = Measured;
			Best = Requested;
		}
		if (std::abs(Measured / Sigma - 1.0) < GoodEnough)
		{
			break;
		}
		// Halving and stretching add the same variance at every requested sigma.
		Requested = std::sqrt(std::max(0.01, Requested * Requested + Sigma * Sigma - Measured * Measured));
	}
	Requested = Best;
}

double GetDirectTaps(double Sigma)
{
	const double Width = 2.0 * (ComputeMatchedGaussian(Sigma).Num() - 1) + 1.0;
	return Width * Width;
}

} // namespace Drydock
