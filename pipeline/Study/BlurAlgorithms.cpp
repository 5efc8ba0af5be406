// Source: drydock; algorithms: where they are.
#include "Study/BlurAlgorithms.h"

#include "Study/BlurNative.h"

#include "DualKawaseBlurPass.h"
#include "DualKawaseBlurWidth.h"
#include "FourTapBlur.h"
#include "RHICommandList.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphObserver.h"
#include "RenderTargetPool.h"
#include "RunDump.h"
#include "RunSetup.h"
#include "SceneRendering.h"
#include "TextureBlur.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>

namespace Drydock
{

namespace
{

/** What a blur adds to a graph. */
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
	FDualKawaseGaussianInputs Inputs;
	Inputs.SceneColor = Input;
	Inputs.StandardDeviation = Sigma;
	Inputs.bSeparable = bSeparable;
	return AddDualKawaseGaussianPass(GraphBuilder, View, Inputs);
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
		FGaussianBlurPassesInputs Inputs;
		for (int32 Stage = 0; Stage < Level; ++Stage)
		{
			Inputs.Stages.Add({TEXT("GaussianSumX"), TEXT("GaussianSumY"),
				Stage == 0 ? static_cast<float>(200.0 * Radius / LevelWidth) : 0.0f});
		}
		Inputs.StageCount = 1;
		Inputs.bClampAddressing = true;
		const FScreenPassTexture Blurred =
			AddTextureBlurPass(GraphBuilder, View, Input, Input.Texture->Desc.Format, TEXT("GaussianSum"), Inputs);
		return AddBilinearStretchPass(GraphBuilder, View, Blurred, Input);
	};
}

FAddBlur MakeGraphBlur(const std::string& Name, double Sigma)
{
	if (Name == "GaussianSum")
	{
		return MakeGaussianSum(Sigma);
	}
	return Name == "Direct"       ? FAddBlur(AddDirect)
		   : Name == "Kawase"     ? FAddBlur(AddKawaseBlurPasses)
		   : Name == "DualKawase" ? FAddBlur(AddDualKawase)
		   : Name == "Pyramid"    ? FAddBlur(AddPyramid)
								  : FAddBlur(AddSeparable);
}

/** Taps of the Gaussian's passes: their loops run over a reach that is a parameter, which a static count does not see.
 * The pass says it in its name: "... reach 12x0 ...". */
double CountReachTaps(const std::string& Pass)
{
	int X = 0;
	int Y = 0;
	const size_t At = Pass.find(" reach ");
	return At != std::string::npos && std::sscanf(Pass.c_str() + At, " reach %dx%d", &X, &Y) == 2
			   ? (2.0 * X + 1.0) * (2.0 * Y + 1.0)
			   : 0.0;
}

class FBlurObserver final : public IRDGObserver
{
public:
	void OnPassExecuted(int32_t, const FRDGPass& Pass, double Milliseconds, const FPassCounters& Counters,
		const std::vector<FRDGTexture*>&) override
	{
		Run.Milliseconds += Milliseconds;
		Run.TapsPerPixel += Counters.Taps > 0 ? static_cast<double>(Counters.Taps)
											  : CountReachTaps(Pass.GetName()) * static_cast<double>(Counters.Pixels);
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
	const FImage Image = ReadTexture(Texture);
	return Image.NumChannels == 4 ? Image : CropToRgba(Image, FIntRect(0, 0, Image.Width, Image.Height));
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

// Plain code --------------------------------------------------------------------------------------------------------

FBlurRun RunNative(const FImage& Image, const std::string& Name, double Sigma)
{
	const auto Begin = std::chrono::steady_clock::now();
	FBlurRun Run;
	Run.Image = Name == "Boxes"       ? BlurBoxes(Image, Sigma)
				: Name == "Recursive" ? BlurRecursive(Image, Sigma)
									  : BlurExact(Image, Sigma);
	Run.Milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - Begin).count();
	const FNativeBlurCost Cost = Name == "Boxes"       ? GetBoxesCost()
								 : Name == "Recursive" ? GetRecursiveCost()
													   : GetExactCost(Sigma);
	Run.TapsPerPixel = Cost.Taps;
	Run.BytesPerPixel = Cost.TexelsMoved * static_cast<double>(sizeof(double)) * Image.NumChannels;
	Run.NumPasses = 2;
	return Run;
}

} // namespace

const std::vector<FBlurAlgorithm>& GetBlurAlgorithms()
{
	static const std::vector<FBlurAlgorithm> Algorithms = {
		{"Exact", "True Gaussian convolution in double, cut where double ends: the reference.", false},
		{"Direct", "All taps of a square at once, 3 deviations to each side.", true, 0.5, 8.0},
		{"Separable", "Rows, then columns, 3 deviations to each side."},
		{"GaussianSum",
			"One Gaussian of the engine's bloom: on a level of the chain, in at most 32 taps, stretched back.", true,
			1.5, 1000.0},
		{"Kawase", "Passes of four taps at full size, each further out.", true, 0.5, 250.0},
		{"DualKawase", "Halved and doubled again by 5 and 8 taps.", true, 1.0, 426.0},
		{"Pyramid", "[1 3 3 1] down and up, a small separable Gaussian between."},
		{"Boxes", "Three running averages.", false},
		{"Recursive", "Young and van Vliet's third-order recursive filter.", false},
	};
	return Algorithms;
}

const FBlurAlgorithm* FindBlurAlgorithm(const std::string& Name)
{
	const std::vector<FBlurAlgorithm>& Algorithms = GetBlurAlgorithms();
	const auto Found = std::find_if(
		Algorithms.begin(), Algorithms.end(), [&](const FBlurAlgorithm& Algorithm) { return Algorithm.Name == Name; });
	return Found == Algorithms.end() ? nullptr : &*Found;
}

const std::vector<std::string>& GetBlurStorages()
{
	static const std::vector<std::string> Storages = {"float32", "float16", "R11G11B10", "8bit"};
	return Storages;
}

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
	return Algorithm.bGraph
			   ? RunGraph(Image, MakeGraphBlur(Algorithm.Name, Sigma * std::exp2(-As.ResolutionLevels)), Requested, As)
			   : RunNative(Image, Algorithm.Name, Requested);
}

/** One run for a block of impulses: its columns hold 1, x and x^2 in their channels, the same in all rows, so that the
 * other axis drops out. The block is as wide as the coarsest texel of any level, the margin wider than any response. */
double FBlur::Measure() const
{
	int Block = 16;
	while (Block < Sigma)
	{
		Block *= 2;
	}
	const int Margin = (static_cast<int>(10.0 * Sigma) / Block + 1) * Block;
	const bool bLevels =
		Algorithm.bGraph && Algorithm.Name != "Separable" && Algorithm.Name != "Direct" && Algorithm.Name != "Kawase";
	FImage Strip;
	Strip.Width = 2 * Margin + Block;
	Strip.Height = bLevels || Arithmetic.ResolutionLevels > 0 ? 2 * Block : 2;
	Strip.NumChannels = 4;
	const auto Centre = [&](int X)
	{
		return static_cast<double>(X - Margin - Block / 2);
	};
	for (int Y = 0; Y < Strip.Height; ++Y)
	{
		for (int X = 0; X < Strip.Width; ++X)
		{
			const double In = Centre(X);
			const double Lit = X >= Margin && X < Margin + Block ? 1.0 : 0.0;
			Strip.Values.insert(Strip.Values.end(), {Lit, Lit * In, Lit * In * In, 0.0});
		}
	}
	FBlurArithmetic Float;
	Float.ResolutionLevels = Arithmetic.ResolutionLevels;
	const FImage Blurred = RunAs(Strip, Float).Image;
	double Sum = 0.0;
	double Mean = 0.0;
	double Square = 0.0;
	for (int X = 0; X < Strip.Width; ++X)
	{
		const double Out = Centre(X);
		const double Weight = Blurred.Get(X, Strip.Height / 2, 0);
		const double First = Blurred.Get(X, Strip.Height / 2, 1);
		Sum += Weight;
		Mean += Out * Weight - First;
		Square += Out * Out * Weight - 2.0 * Out * First + Blurred.Get(X, Strip.Height / 2, 2);
	}
	return std::sqrt(std::max(0.0, Square / Sum - Mean / Sum * Mean / Sum));
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
		// What halving and stretching add to the variance they add whatever is asked for.
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
