// How far passes are from what the machine allows: bytes and multiply-adds a pixel, against the bandwidth of a copy and
// the peak of multiply-adds, both measured in the same rounds; 1920 x 1080, processor time of one thread, medians. So a
// goal that is missed can be judged: a pass that reaches neither of the two is bound by its other instructions, of
// which "cycles" tells how many there can be. Prints a table in Markdown.
//
//     bench_roofline [ROUNDS] [WORDS]        WORDS: only rows whose name begins so
#include "BenchPasses.h"
#include "Blur/GaussianSum.h"
#include "HAL/IConsoleManager.h"
#include "LanesDispatch.h"
#include "RHICommandList.h"
#include "RenderGraphObserver.h"
#include "RenderTargetPool.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <immintrin.h>
#include <set>
#include <string>
#include <vector>

using namespace Drydock;
using namespace Drydock::Bench;

namespace
{

double ThreadSeconds()
{
	timespec Time;
	clock_gettime(CLOCK_THREAD_CPUTIME_ID, &Time);
	return double(Time.tv_sec) + 1e-9 * double(Time.tv_nsec);
}

double Median(std::vector<double> Values)
{
	std::nth_element(Values.begin(), Values.begin() + long(Values.size() / 2), Values.end());
	return Values[Values.size() / 2];
}

/** Cycles a second: each addition waits one for the one before. */
double MeasureClock()
{
	constexpr int NumAdditions = 1 << 20;
	const double Begin = ThreadSeconds();
	uint64_t Sum = 0;
	for (int Index = 0; Index < NumAdditions / 8; ++Index)
	{
		asm volatile("add $1, %0\n\tadd $1, %0\n\tadd $1, %0\n\tadd $1, %0\n\t"
					 "add $1, %0\n\tadd $1, %0\n\tadd $1, %0\n\tadd $1, %0"
					 : "+r"(Sum));
	}
	return NumAdditions / (ThreadSeconds() - Begin);
}

constexpr int GNumChains = 12; // what two units of a latency of four or five take
constexpr int GNumLinks = 1 << 16;

#define DRYDOCK_RUN_CHAINS(Vector, Set, MultiplyAdd) \
	Vector Sums[GNumChains]; \
	for (Vector & Sum : Sums) \
	{ \
		Sum = Set(1.0f); \
	} \
	const Vector Factor = Set(0.5f); \
	for (int Link = 0; Link < GNumLinks; ++Link) \
	{ \
		_Pragma("GCC unroll 12") for (Vector & Sum : Sums) \
		{ \
			Sum = MultiplyAdd(Sum, Factor, Factor); \
		} \
	} \
	for (Vector & Sum : Sums) \
	{ \
		asm volatile("" : : "x"(Sum)); \
	}

__attribute__((target("avx512f"), noinline)) void RunChainsOf16()
{
	DRYDOCK_RUN_CHAINS(__m512, _mm512_set1_ps, _mm512_fmadd_ps)
}

__attribute__((target("avx2,fma"), noinline)) void RunChainsOf8()
{
	DRYDOCK_RUN_CHAINS(__m256, _mm256_set1_ps, _mm256_fmadd_ps)
}

/** Of floats, a second. */
double MeasureMultiplyAdds()
{
	const bool bWide = AreLanesSupported(false, 16);
	const double Begin = ThreadSeconds();
	bWide ? RunChainsOf16() : RunChainsOf8();
	return double(GNumChains) * GNumLinks * (bWide ? 16 : 8) / (ThreadSeconds() - Begin);
}

/** Time of the passes whose name begins so, and what they move. */
class FWatch final : public IRDGObserver
{
public:
	explicit FWatch(std::string InPrefix)
		: Prefix(std::move(InPrefix))
	{
	}

	void OnGraphCompiled(const FRDGCompiledGraph& Graph) override
	{
		std::vector<int> Reads(Graph.Resources.size());
		std::vector<int> Writes(Graph.Resources.size());
		for (const FRDGCompiledPass& Pass : Graph.Passes)
		{
			std::set<std::pair<int32_t, bool>> Known;
			for (const FRDGUse& Use : Pass.Uses)
			{
				if (!Pass.bCulled && !Pass.bIsSentinel && Pass.Name.starts_with(Prefix) &&
					Known.insert({Use.Resource, Use.IsWrite()}).second)
				{
					++(Use.IsWrite() ? Writes : Reads)[Use.Resource];
				}
			}
		}
		for (size_t Index = 0; Index < Graph.Resources.size(); ++Index)
		{
			const FRDGCompiledResource& Resource = Graph.Resources[Index];
			const bool bTexture = Resource.Kind == ERDGResourceKind::Texture;
			const double Bytes = !bTexture ? 0.0
										   : double(GPixelFormats[Resource.Format].BlockBytes) * Resource.Extent.X *
												 Resource.Extent.Y * std::max(Resource.Extent.Z, 1);
			MovedBytes += Bytes * (Reads[Index] + Writes[Index]);
			LeastBytes +=
				Reads[Index] > 0 && Writes[Index] > 0 ? 0.0 : Bytes * std::min(Reads[Index] + Writes[Index], 1);
		}
	}

	void OnPassExecuted(
		int32_t, const FRDGPass& Pass, double, const FPassCounters&, const std::vector<FRDGTexture*>&) override
	{
		const double Now = ThreadSeconds();
		Seconds += std::string(Pass.GetName()).starts_with(Prefix) ? Now - Last : 0.0;
		Last = Now;
	}

	double MovedBytes = 0.0; // each pass by itself
	double LeastBytes = 0.0; // of what comes from outside the passes and leaves them
	double Seconds = 0.0;

private:
	const std::string Prefix;
	double Last = ThreadSeconds();
};

struct FRow
{
	std::string Name;
	EPixelFormat Format;
	FAddPasses AddPasses;
	double MultiplyAdds; // a pixel of the picture
	std::string Pass = {};
};

/** Six levels in half the picture's size, as the peers' benchmark has them; without adding them to the picture. */
FAddPasses Bloom()
{
	return [](FRDGBuilder& GraphBuilder, FViewInfo& View, const FScreenPassTexture& Input)
	{
		constexpr float Percents[] = {0.3f, 1.0f, 2.0f, 10.0f, 30.0f, 64.0f};
		FBloomSetupInputs SetUp;
		SetUp.SceneColor = Downsample(EDownsampleQuality::Low)(GraphBuilder, View, Input);
		SetUp.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(GraphBuilder, 1.0f);
		SetUp.Threshold = 1.0f;
		FTextureDownsampleChain Chain;
		Chain.Init(GraphBuilder, View, AddBloomSetupPass(GraphBuilder, View, SetUp), EDownsampleQuality::Low,
			TEXT("Chain"), std::size(Percents));
		FGaussianSumInputs Sum;
		for (size_t Level = std::size(Percents); Level-- > 0;)
		{
			Sum.Stages.Add({TEXT("BloomX"), TEXT("BloomY"), Percents[Level]});
		}
		Sum.StageCount = std::size(Percents);
		Sum.bClampAddressing = true;
		return AddGaussianSumPasses(GraphBuilder, View, Chain, Sum);
	};
}

/** Taps on both sides share a product: reach + 1 of them, in two directions, on four channels. */
double OfGaussian(double Reach)
{
	return 2.0 * 4.0 * (Reach + 1.0);
}

/** [1 3 3 1] down and two taps up along each axis take 3 a channel and pixel of the finer level each. */
double OfPyramid(double StandardDeviation)
{
	constexpr double Reach = 4.0;
	const FPyramidSetting Setting = GetPyramidSetting(StandardDeviation);
	double Sum = OfGaussian(std::ceil(Reach * Setting.LowStandardDeviation)) * std::exp2(-2.0 * Setting.Levels);
	for (int32 Level = 0; Level < Setting.Levels; ++Level)
	{
		Sum += 4.0 * 6.0 * std::exp2(-2.0 * Level);
	}
	return Sum;
}

std::vector<FRow> GetRows()
{
	constexpr double OfKawase = 49.0;
	constexpr double OfBloom = 28.0;
	constexpr double OfBox = 5.0;                      // two sums and two differences, one product
	constexpr double OfTable = 3 * 14 + 8 * 3 + 7 * 3; // logarithms, texels of three fields, mixtures
	std::vector<FRow> Rows;
	for (const auto& [Format, Suffix] : {std::pair(PF_A32B32G32R32F, ", RGBA32F"), {PF_FloatRGBA, ", RGBA16F"}})
	{
		for (const int32 Sigma : {2, 8, 32})
		{
			Rows.push_back({"exact Gaussian, sigma " + std::to_string(Sigma) + Suffix, Format, Separable(Sigma),
				OfGaussian(3 * Sigma)});
		}
		for (const int32 Sigma : {2, 8, 32, 64})
		{
			Rows.push_back(
				{"pyramid, sigma " + std::to_string(Sigma) + Suffix, Format, Pyramid(Sigma), OfPyramid(Sigma)});
		}
		Rows.push_back({std::string("dual Kawase 5") + Suffix, Format, Kawase(5), OfKawase});
		Rows.push_back({std::string("bloom, 6 levels") + Suffix, Format, Bloom(), OfBloom});
		Rows.push_back(
			{std::string("tonemap by the table") + Suffix, Format, Tonemap(ELens::None), OfTable, "Tonemap"});
	}
	for (const int32 Radius : {1, 8, 32})
	{
		Rows.push_back({"box of a mask, radius " + std::to_string(Radius), PF_B8G8R8A8, Box(float(Radius)), OfBox});
	}
	return Rows;
}

FWatch Run(const FRow& Row, const FTextureRHIRef& Texture)
{
	FWatch Watch(Row.Pass);
	FViewInfo View(nullptr, FIntRect(FIntPoint(0, 0), GSize), GSize);
	FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList(), RDG_EVENT_NAME("Bench"));
	GraphBuilder.SetObserver(&Watch);
	const FScreenPassTexture Input(GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Texture, TEXT("Input"))));
	TRefCountPtr<IPooledRenderTarget> Result;
	GraphBuilder.QueueTextureExtraction(Row.AddPasses(GraphBuilder, View, Input).Texture, &Result);
	GraphBuilder.Execute();
	return Watch;
}

void PrintRow(const FRow& Row, int Rounds)
{
	const FTextureRHIRef Texture = MakeNoise(Row.Format);
	const FWatch First = Run(Row, Texture);
	const size_t HalfBytes = size_t(First.LeastBytes / 2);
	std::vector<uint8_t> From(HalfBytes, 1);
	std::vector<uint8_t> To(HalfBytes, 2);
	std::vector<double> Times;
	std::vector<double> Copies;
	std::vector<double> Clocks;
	std::vector<double> MultiplyAdds;
	for (int Round = 0; Round < Rounds; ++Round)
	{
		Times.push_back(Run(Row, Texture).Seconds);
		const double Begin = ThreadSeconds();
		std::memcpy(To.data(), From.data(), HalfBytes);
		Copies.push_back(ThreadSeconds() - Begin);
		asm volatile("" : : "r"(To.data()) : "memory");
		Clocks.push_back(MeasureClock());
		MultiplyAdds.push_back(MeasureMultiplyAdds());
	}
	const double Pixels = double(GSize.X) * GSize.Y;
	const double Time = Median(Times);
	const double Copy = Median(Copies);
	const double Bandwidth = First.LeastBytes / Copy;
	const double Peak = Median(MultiplyAdds);
	const double OfMemory = First.MovedBytes / Bandwidth / Time;
	const double OfSums = Row.MultiplyAdds * Pixels / Peak / Time;
	const char* const Bound = std::max(OfMemory, OfSums) < 0.5 ? "instructions"
							  : OfMemory > OfSums              ? "memory"
															   : "multiply-adds";
	std::printf("| %s | %.2f | %.1f | %.0f | %.0f | %.1f | %.0f %% | %.0f | %.0f | %.0f %% | %.0f | %s |\n",
		Row.Name.c_str(), Time * 1e3, Time / Copy, First.LeastBytes / Pixels, First.MovedBytes / Pixels,
		Bandwidth * 1e-9, OfMemory * 100, Row.MultiplyAdds, Peak * 1e-9, OfSums * 100,
		Time * Median(Clocks) * 16 / Pixels, Bound);
	std::fflush(stdout);
}

} // namespace

int main(int NumArguments, char** Arguments)
{
	const int Rounds = NumArguments > 1 ? std::max(1, std::atoi(Arguments[1])) : 15;
	const std::string Words = NumArguments > 2 ? Arguments[2] : "";
	if (!AreLanesSupported(false, 8))
	{
		std::fprintf(stderr, "bench_roofline needs AVX2\n");
		return 0;
	}
	IConsoleManager::Get().FindConsoleVariable(TEXT("r.Drydock.Threads"))->Set(1);
	std::printf(
		"| one thread, 1920 x 1080 | ms | copies | bytes a pixel, least | by its passes | a copy, GB/s | part of it "
		"| multiply-adds a pixel | peak a ns | part of it | cycles for 16 pixels | bound by |\n"
		"|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|---|\n");
	for (const FRow& Row : GetRows())
	{
		if (Row.Name.starts_with(Words))
		{
			PrintRow(Row, Rounds);
		}
	}
	return 0;
}
