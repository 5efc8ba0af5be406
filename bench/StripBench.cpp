// What passes cost by their native kernels and by their shaders: blurs, boxes and downsamples, bloom setup, tonemapper;
// 1920x1080. Both run alternately in one process, with a copy of the picture by memcpy between them; medians of 7 of
// the processor time of one thread. "copies": time over that of the copy of the picture in its own format. Then, for
// what both formats have, the native time of half storage over that of float32; and CharaGlow's box against running
// sums in plain C++. bench_strips WORDS: only rows whose name begins so.
#include "BenchPasses.h"
#include "HAL/IConsoleManager.h"
#include "RHICommandList.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphObserver.h"
#include "RenderTargetPool.h"
#include "SceneRendering.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <map>
#include <string>
#include <vector>

using namespace Drydock;
using namespace Drydock::Bench;

namespace
{

constexpr int GRepetitions = 7;

struct FRow
{
	std::string Name;
	EPixelFormat Format;
	FAddPasses AddPasses;
	/** Only passes whose name begins so are timed. */
	std::string Pass = {};
	std::vector<double> Native = {};
	std::vector<double> Shader = {};
	std::vector<double> Copy = {};
};

class FPassTimer final : public IRDGObserver
{
public:
	explicit FPassTimer(const std::string& InPrefix)
		: Prefix(InPrefix)
	{
	}

	/** What the process has used up to now. */
	static double GetMilliseconds() { return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

	void OnPassExecuted(
		int32_t, const FRDGPass& Pass, double, const FPassCounters&, const std::vector<FRDGTexture*>&) override
	{
		const double Now = GetMilliseconds();
		Sum += std::string(Pass.GetName()).starts_with(Prefix) ? Now - Last : 0.0;
		Last = Now;
	}

	const std::string Prefix;
	double Last = GetMilliseconds();
	double Sum = 0.0;
};

double Run(const FRow& Row, const FTextureRHIRef& Texture, bool bNative)
{
	IConsoleManager::Get().FindConsoleVariable(TEXT("r.Drydock.NativeKernels"))->Set(bNative ? 1 : 0);
	FPassTimer Timer(Row.Pass);
	FViewInfo View(nullptr, FIntRect(FIntPoint(0, 0), GSize), GSize);
	FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList(), RDG_EVENT_NAME("Bench"));
	GraphBuilder.SetObserver(&Timer);
	const FScreenPassTexture Input(GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Texture, TEXT("Input"))));
	TRefCountPtr<IPooledRenderTarget> Result;
	GraphBuilder.QueueTextureExtraction(Row.AddPasses(GraphBuilder, View, Input).Texture, &Result);
	GraphBuilder.Execute();
	return Timer.Sum;
}

/** The mean of (2 Radius + 1)^2 floats, the usual way: sums of columns that go down with the rows, and a sum that goes
 * along them. */
void AddRunningSums(const std::vector<float>& From, std::vector<float>& To, int32 Radius)
{
	const auto GetRow = [&](int32 Y)
	{
		return From.data() + size_t(std::clamp(Y, 0, GSize.Y - 1)) * size_t(GSize.X);
	};
	const int32 Last = GSize.X - 1;
	std::vector<float> Padded(size_t(GSize.X + 2 * Radius + 2));
	float* const Columns = Padded.data() + Radius;
	for (int32 Y = -Radius; Y <= Radius; ++Y)
	{
		const float* const Row = GetRow(Y);
		for (int32 X = 0; X <= Last; ++X)
		{
			Columns[X] += Row[X];
		}
	}
	const float Scale = 1.0f / static_cast<float>((2 * Radius + 1) * (2 * Radius + 1));
	for (int32 Y = 0; Y < GSize.Y; ++Y)
	{
		std::fill(Padded.begin(), Padded.begin() + Radius, Columns[0]);
		std::fill(Columns + Last + 1, Columns + Last + Radius + 2, Columns[Last]);
		float Sum = 0.0f;
		for (int32 X = -Radius; X <= Radius; ++X)
		{
			Sum += Columns[X];
		}
		float* const Out = To.data() + size_t(Y) * size_t(GSize.X);
		for (int32 X = 0; X <= Last; ++X)
		{
			Out[X] = Sum * Scale;
			Sum += Columns[X + Radius + 1] - Columns[X - Radius];
		}
		const float* const Added = GetRow(Y + Radius + 1);
		const float* const Removed = GetRow(Y - Radius);
		for (int32 X = 0; X <= Last; ++X)
		{
			Columns[X] += Added[X] - Removed[X];
		}
	}
}

double Copy(const FTextureRHIRef& Texture, std::vector<uint8_t>& To)
{
	const FKernelMip& Mip = Texture->GetKernelView().Mips[0];
	const size_t Bytes = size_t(Mip.RowPitch) * size_t(Mip.SizeY);
	To.resize(Bytes);
	const double Start = FPassTimer::GetMilliseconds();
	std::memcpy(To.data(), Mip.Data, Bytes);
	return FPassTimer::GetMilliseconds() - Start;
}

double Median(std::vector<double> Values)
{
	std::sort(Values.begin(), Values.end());
	return Values[Values.size() / 2];
}

/** The engine's mask, blue of four bytes, into half floats, against floats into floats. */
void CompareBoxes()
{
	std::printf("\n| box of a mask, 1920 x 1080, one thread | CharaGlow, ms | running sums in C++, ms | ratio |\n"
				"|---|---|---|---|\n");
	const FTextureRHIRef Mask = MakeNoise(PF_B8G8R8A8);
	std::vector<float> From(size_t(GSize.X) * size_t(GSize.Y), 0.5f);
	std::vector<float> To(From.size());
	for (const int32 Radius : {1, 8, 32})
	{
		const FRow Row = {"", PF_B8G8R8A8, Box(static_cast<float>(Radius))};
		std::vector<double> Native;
		std::vector<double> Plain;
		for (int Repetition = -1; Repetition < 3 * GRepetitions; ++Repetition)
		{
			const double Milliseconds = Run(Row, Mask, true);
			const double Start = FPassTimer::GetMilliseconds();
			AddRunningSums(From, To, Radius);
			if (Repetition >= 0)
			{
				Native.push_back(Milliseconds);
				Plain.push_back(FPassTimer::GetMilliseconds() - Start);
			}
		}
		std::printf("| radius %d | %.2f | %.2f | %.2f |\n", Radius, Median(Native), Median(Plain),
			Median(Native) / Median(Plain));
	}
}

} // namespace

int main(int NumArguments, char** Arguments)
{
	const std::string Words = NumArguments > 1 ? Arguments[1] : "";
	IConsoleManager::Get().FindConsoleVariable(TEXT("r.Drydock.Threads"))->Set(1);
	std::vector<FRow> Rows;
	for (const auto& [Format, Name] :
		{std::pair(PF_FloatR11G11B10, "R11G11B10"), {PF_FloatRGBA, "RGBA16F"}, {PF_A32B32G32R32F, "RGBA32F"}})
	{
		for (const float Radius : {4.0f, 6.0f, 12.0f, 31.0f})
		{
			Rows.push_back({"Gaussian radius " + std::to_string(int(Radius)) + ", " + Name, Format, Gaussian(Radius)});
		}
		for (const int32 Sigma : {2, 8, 32})
		{
			Rows.push_back({"exact Gaussian, sigma " + std::to_string(Sigma) + ", " + Name, Format, Separable(Sigma)});
		}
		for (const int32 Sigma : {8, 32})
		{
			Rows.push_back({"pyramid, sigma " + std::to_string(Sigma) + ", " + Name, Format, Pyramid(Sigma)});
		}
		for (const int32 Radius : {1, 8, 32})
		{
			Rows.push_back(
				{"box, radius " + std::to_string(Radius) + ", " + Name, Format, Box(static_cast<float>(Radius))});
		}
		for (const int32 Levels : {1, 3, 5})
		{
			Rows.push_back({"dual Kawase " + std::to_string(Levels) + ", " + Name, Format, Kawase(Levels)});
		}
		Rows.push_back({std::string("downsample low, ") + Name, Format, Downsample(EDownsampleQuality::Low)});
		Rows.push_back({std::string("downsample high, ") + Name, Format, Downsample(EDownsampleQuality::High)});
		Rows.push_back({std::string("bloom setup, ") + Name, Format, SetUpBloom(false), "BloomSetup"});
		Rows.push_back(
			{std::string("bloom setup with local exposure, ") + Name, Format, SetUpBloom(true), "BloomSetup"});
		Rows.push_back({std::string("tonemap by the table, ") + Name, Format, Tonemap(ELens::None), "Tonemap"});
		Rows.push_back({std::string("tonemap, bloom, ") + Name, Format, Tonemap(ELens::Bloom), "Tonemap"});
		Rows.push_back({std::string("tonemap, everything, ") + Name, Format, Tonemap(ELens::Everything), "Tonemap"});
	}
	std::erase_if(Rows, [&](const FRow& Row) { return !Row.Name.starts_with(Words); });
	std::map<std::string, double> NativeTimes;
	std::vector<uint8_t> To;
	std::printf(
		"Passes at %dx%d, one thread, medians of %d\n\n| pass | native ms | shader ms | shader / native | native, "
		"copies | shader, copies |\n|---|---|---|---|---|---|\n",
		GSize.X, GSize.Y, GRepetitions);
	for (FRow& Row : Rows)
	{
		const FTextureRHIRef Texture = MakeNoise(Row.Format);
		for (int Repetition = -1; Repetition < GRepetitions; ++Repetition)
		{
			const double Native = Run(Row, Texture, true);
			const double Copied = Copy(Texture, To);
			const double Shader = Run(Row, Texture, false);
			if (Repetition >= 0) // the first round warms up
			{
				Row.Native.push_back(Native);
				Row.Copy.push_back(Copied);
				Row.Shader.push_back(Shader);
			}
		}
		const double Native = Median(Row.Native);
		const double Shader = Median(Row.Shader);
		const double Copied = Median(Row.Copy);
		std::printf("| %s | %.2f | %.2f | %.1f | %.1f | %.1f |\n", Row.Name.c_str(), Native, Shader, Shader / Native,
			Native / Copied, Shader / Copied);
		std::fflush(stdout);
		NativeTimes[Row.Name] = Native;
	}
	if (Words.empty() || Words.starts_with("box"))
	{
		CompareBoxes();
	}
	if (!Words.empty())
	{
		return 0;
	}
	// Sigma 8 and 32 end at 24 and 96 texels: two directions of 49 and 193 taps.
	constexpr double MoreTaps = 2 * (193 - 49);
	std::printf("\n| exact Gaussian of | a tap, ms | products and sums a ns |\n|---|---|---|\n");
	for (const auto& [Name, Channels] : {std::pair("R11G11B10", 3), {"RGBA16F", 4}, {"RGBA32F", 4}})
	{
		const double Milliseconds = (NativeTimes[std::string("exact Gaussian, sigma 32, ") + Name] -
										NativeTimes[std::string("exact Gaussian, sigma 8, ") + Name]) /
									MoreTaps;
		const double Operations = 2.0 * Channels * GSize.X * GSize.Y;
		std::printf("| %s | %.3f | %.0f |\n", Name, Milliseconds, Operations / (Milliseconds * 1e6));
	}
	std::printf("\n| pass | half / float32 |\n|---|---|\n");
	for (const FRow& Row : Rows)
	{
		const size_t Suffix = Row.Name.rfind(", RGBA16F");
		if (Suffix != std::string::npos)
		{
			const std::string Name = Row.Name.substr(0, Suffix);
			std::printf("| %s | %.2f |\n", Name.c_str(), NativeTimes[Row.Name] / NativeTimes[Name + ", RGBA32F"]);
		}
	}
	return 0;
}
