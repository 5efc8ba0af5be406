// The dual Kawase blur against a Gaussian of the same width. Prints tables in Markdown, as docs/dual-kawase.md has
// them: widths measured on the passes, corrected and as printed; what one blur of a scene costs, and how far it is from
// the Gaussian. The three filters alternate inside one measurement; medians of 7.
//
//     bench_kawase [SCENE]
#include "Blur/DualKawaseBlurPass.h"
#include "Blur/DualKawaseBlurWidth.h"
#include "Blur/MatchedGaussianBlur.h"
#include "HAL/IConsoleManager.h"
#include "Picture/ImageFile.h"
#include "RHICommandList.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphObserver.h"
#include "RenderTargetPool.h"
#include "SceneRendering.h"
#include "TileExecutor.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

using namespace Drydock;

namespace
{

constexpr int GRepetitions = 7;
/** The direct Gaussian takes (2 R + 1)^2 taps: beyond these levels, minutes. */
constexpr int32 GMostDirectLevels = 3;

using FAddPasses = std::function<FScreenPassTexture(FRDGBuilder&, const FViewInfo&, const FScreenPassTexture&)>;

FAddPasses Kawase(int32 Levels, double Offset, bool bAsPrinted = false)
{
	return
		[Levels, Offset, bAsPrinted](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input)
	{
		FDualKawaseBlurInputs Inputs;
		Inputs.SceneColor = Input;
		Inputs.PassNum = Levels;
		Inputs.Offset = static_cast<float>(Offset);
		Inputs.bAsPrinted = bAsPrinted;
		return AddDualKawaseBlurPass(GraphBuilder, View, Inputs);
	};
}

FAddPasses Gaussian(double StandardDeviation, bool bSeparable)
{
	return [StandardDeviation, bSeparable](
			   FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input)
	{
		FMatchedGaussianBlurInputs Inputs;
		Inputs.SceneColor = Input;
		Inputs.StandardDeviation = StandardDeviation;
		Inputs.bSeparable = bSeparable;
		return AddMatchedGaussianBlurPasses(GraphBuilder, View, Inputs);
	};
}

/** Adds up the milliseconds of the passes. */
class FPassTimer final : public IRDGObserver
{
public:
	void OnPassExecuted(
		int32_t, const FRDGPass&, double Milliseconds, const FPassCounters&, const std::vector<FRDGTexture*>&) override
	{
		Sum += Milliseconds;
	}
	double Sum = 0.0;
};

FTextureRHIRef MakeTexture(FIntPoint Size, EPixelFormat Format, const std::function<FVector4(int32 X, int32 Y)>& Color)
{
	const FTextureRHIRef Texture = new FRHITexture(
		FRDGTextureDesc::Create2D(Size, Format, FClearValueBinding::None, TexCreate_ShaderResource), TEXT("Input"));
	for (int32 Y = 0; Y < Size.Y; ++Y)
	{
		for (int32 X = 0; X < Size.X; ++X)
		{
			Texture->WriteTexelDouble(X, Y, Color(X, Y));
		}
	}
	return Texture;
}

struct FBlurred
{
	TRefCountPtr<IPooledRenderTarget> Texture;
	double Milliseconds = 0.0;
};

FBlurred Run(FTextureRHIRef Texture, const FAddPasses& AddPasses)
{
	FBlurred Result;
	FPassTimer Timer;
	const FIntPoint Size = Texture->GetSizeXY();
	FViewInfo View(nullptr, FIntRect(FIntPoint(0, 0), Size), Size);
	FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList(), RDG_EVENT_NAME("Bench"));
	GraphBuilder.SetObserver(&Timer);
	const FScreenPassTexture Input(GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Texture, TEXT("Input"))));
	GraphBuilder.QueueTextureExtraction(AddPasses(GraphBuilder, View, Input).Texture, &Result.Texture);
	GraphBuilder.Execute();
	Result.Milliseconds = Timer.Sum;
	return Result;
}

struct FMeasured
{
	double Shift = 0.0; // pixels to the right
	double StandardDeviation = 0.0;
};

/** Means over a block of 2^levels impulses of the place and width of their responses along x. One run for all: columns
 * of a block that hold 1, x and x^2 in their channels, the same in all rows, so that the other axis drops out. */
FMeasured Measure(int32 Levels, double Offset, bool bAsPrinted = false)
{
	const int32 Block = 1 << Levels;
	const int32 Margin = (GetDualKawaseReach(Levels, Offset) / Block + 1) * Block;
	const FIntPoint Size(2 * Margin + Block, 2 * Block);
	const auto Centre = [&](int32 X)
	{
		return X - Margin - Block / 2;
	};
	const FTextureRHIRef Input = MakeTexture(Size, PF_A32B32G32R32F,
		[&](int32 X, int32)
		{
			const double In = Centre(X);
			return X < Margin || X >= Margin + Block ? FVector4(0, 0, 0, 0) : FVector4(1, In, In * In, 0);
		});
	const FBlurred Output = Run(Input, Kawase(Levels, Offset, bAsPrinted));
	double Sum = 0.0;
	double Mean = 0.0;
	double Square = 0.0;
	for (int32 X = 0; X < Size.X; ++X)
	{
		const FVector4 Value = Output.Texture->GetRHI()->ReadTexelDouble(X, Block);
		const double Out = Centre(X);
		Sum += Value.X;
		Mean += Out * Value.X - Value.Y;
		Square += Out * Out * Value.X - 2.0 * Out * Value.Y + Value.Z;
	}
	return {Mean / Sum, std::sqrt(Square / Sum - Mean / Sum * Mean / Sum)};
}

void PrintWidths()
{
	const double Offsets[] = {0.0, 0.5, 1.0, 1.5, 2.0};
	std::printf("Standard deviation in pixels, measured:\n\n| levels |");
	for (const double Offset : Offsets)
	{
		std::printf(" offset %.1f |", Offset);
	}
	std::printf("\n|---|---|---|---|---|---|\n");
	double LargestError = 0.0;
	for (int32 Levels = 1; Levels <= GDualKawaseMaxPasses; ++Levels)
	{
		std::printf("| %d |", Levels);
		for (const double Offset : Offsets)
		{
			const double Measured = Measure(Levels, Offset).StandardDeviation;
			LargestError =
				std::max(LargestError, std::abs(Measured / GetDualKawaseStandardDeviation(Levels, Offset) - 1.0));
			std::printf(" %.2f |", Measured);
		}
		std::printf("\n");
	}
	std::printf("\nLargest relative difference from the closed form: %.1g\n\n", LargestError);

	std::printf(
		"As printed, offset 1, sizes that halve evenly:\n\n| levels | standard deviation | shift |\n|---|---|---|\n");
	for (int32 Levels = 1; Levels <= GDualKawaseMaxPasses; ++Levels)
	{
		const FMeasured Measured = Measure(Levels, 1.0, true);
		std::printf("| %d | %.2f | %.2f |\n", Levels, Measured.StandardDeviation, Measured.Shift);
	}
	std::printf("\n");
}

FTextureRHIRef LoadScene(const std::string& Path)
{
	FImageFile File(Path);
	const std::vector<std::vector<float>> Planes =
		File.Read({File.FindChannel("R"), File.FindChannel("G"), File.FindChannel("B")});
	return MakeTexture(FIntPoint(File.GetWidth(), File.GetHeight()), PF_FloatRGBA,
		[&](int32 X, int32 Y)
		{
			const size_t Index = static_cast<size_t>(Y) * static_cast<size_t>(File.GetWidth()) + static_cast<size_t>(X);
			return FVector4(Planes[0][Index], Planes[1][Index], Planes[2][Index], 1.0);
		});
}

/** Peak signal to noise ratio of the colours clamped to 0..1, in decibels. */
double Compare(const FBlurred& A, const FBlurred& B)
{
	const FIntPoint Size = A.Texture->GetRHI()->GetSizeXY();
	double Sum = 0.0;
	for (int32 Y = 0; Y < Size.Y; ++Y)
	{
		for (int32 X = 0; X < Size.X; ++X)
		{
			const FVector4 First = A.Texture->GetRHI()->ReadTexelDouble(X, Y);
			const FVector4 Second = B.Texture->GetRHI()->ReadTexelDouble(X, Y);
			for (int32 Channel = 0; Channel < 3; ++Channel)
			{
				const double Difference = std::clamp(First[Channel], 0.0, 1.0) - std::clamp(Second[Channel], 0.0, 1.0);
				Sum += Difference * Difference;
			}
		}
	}
	return -10.0 * std::log10(Sum / (3.0 * Size.X * Size.Y));
}

double Median(std::vector<double> Values)
{
	std::nth_element(Values.begin(), Values.begin() + static_cast<long>(Values.size() / 2), Values.end());
	return Values[Values.size() / 2];
}

/** Bilinear taps per pixel of the picture: 5 down and 8 up per pixel of each level. */
double CountKawaseTaps(int32 Levels)
{
	double Taps = 0.0;
	for (int32 Level = 1; Level <= Levels; ++Level)
	{
		Taps += 5.0 * std::exp2(-2.0 * Level) + 8.0 * std::exp2(-2.0 * (Level - 1));
	}
	return Taps;
}

void PrintCosts(const std::string& Scene)
{
	const FTextureRHIRef Input = LoadScene(Scene);
	std::printf("%dx%d RGBA16F, %d threads, medians of %d in milliseconds (taps per pixel):\n\n", Input->GetSizeXY().X,
		Input->GetSizeXY().Y, GetNumThreads(), GRepetitions);
	std::printf(
		"| levels | sigma | dual Kawase | Gaussian, two passes | Gaussian, direct | separable / Kawase | direct / "
		"Kawase | PSNR |\n|---|---|---|---|---|---|---|---|\n");
	for (int32 Levels = 1; Levels <= 6; ++Levels)
	{
		const double Sigma = GetDualKawaseStandardDeviation(Levels, 1.0);
		const double Width = 2.0 * (ComputeMatchedGaussian(Sigma).Num() - 1) + 1.0;
		const FAddPasses Filters[] = {Kawase(Levels, 1.0), Gaussian(Sigma, true), Gaussian(Sigma, false)};
		const size_t NumFilters = Levels <= GMostDirectLevels ? 3 : 2;
		std::vector<double> Times[3];
		double Psnr = 0.0;
		for (int Repetition = -1; Repetition < GRepetitions; ++Repetition)
		{
			FBlurred Results[3];
			for (size_t Filter = 0; Filter < NumFilters; ++Filter)
			{
				Results[Filter] = Run(Input, Filters[Filter]);
				if (Repetition >= 0)
				{
					Times[Filter].push_back(Results[Filter].Milliseconds);
				}
			}
			Psnr = Compare(Results[0], Results[1]);
		}
		const double KawaseMs = Median(Times[0]);
		const double TwoPassMs = Median(Times[1]);
		std::printf("| %d | %.2f | %.1f (%.1f) | %.1f (%.0f) |", Levels, Sigma, KawaseMs, CountKawaseTaps(Levels),
			TwoPassMs, 2.0 * Width);
		if (NumFilters == 3)
		{
			std::printf(" %.0f (%.0f) | %.1f | %.0f |", Median(Times[2]), Width * Width, TwoPassMs / KawaseMs,
				Median(Times[2]) / KawaseMs);
		}
		else
		{
			std::printf(" (%.0f) | %.1f | |", Width * Width, TwoPassMs / KawaseMs);
		}
		std::printf(" %.1f dB |\n", Psnr);
		std::fflush(stdout);
	}
}

} // namespace

int main(int ArgumentCount, char** Arguments)
{
	PrintWidths();
	PrintCosts(ArgumentCount > 1 ? Arguments[1] : DRYDOCK_BENCH_SOURCE_DIR "/configs/scenes/toon_character.exr");
	return 0;
}
