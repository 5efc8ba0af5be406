// The .usf of three shaders, as the shader tier compiles it, against the same shaders as scalar C++ with GLM and as
// lane code written by hand; 1920x1080, one thread. The three alternate frame by frame inside one measurement, so that
// all see the same state of the machine; the counters give the milliseconds of each, and scalar over .usf as the
// ratio. Wanted: 2 (Kawase 1.2) with AVX-512, 1 with AVX2.
#include <benchmark/benchmark.h>

#include "Bloom/BloomSetupShaders.h"
#include "LanesDispatch.h"
#include "PixelFormatConversion.h"
#include "Shader.h"
#include "ShaderCompilation.h"
#include "ShaderCore.h"
#include "ShaderLanesKernels.h"
#include "UsfKernel.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace Drydock::Bench
{
namespace
{

constexpr int32_t GSizeX = 1920;
constexpr int32_t GSizeY = 1080;

/** Texture memory as the library lays it out: rows of 64 bytes, margins. */
class FImage
{
public:
	FImage(ETexelStorage Storage, int32_t SizeX, int32_t SizeY)
	{
		const int32_t Bytes = GetTexelStorageInfo(Storage).BytesPerTexel;
		const int32_t RowPitch = (SizeX * Bytes + 63) / 64 * 64;
		const size_t Size = size_t(RowPitch) * size_t(SizeY);
		Memory = static_cast<uint8_t*>(std::aligned_alloc(64, Size + 128));
		Mip = {Memory + 64, SizeX, SizeY, 1, RowPitch, int64_t(Size)};
		Texture = {&Mip, 1, Storage, 0, 0};
		std::mt19937 Engine(1);
		std::uniform_real_distribution<float> Value(0, 4);
		for (int32_t Y = 0; Y < SizeY; ++Y)
		{
			for (int32_t X = 0; X < SizeX; ++X)
			{
				const float RGBA[4] = {Value(Engine), Value(Engine), Value(Engine), 1};
				EncodeTexel(Storage, RGBA, Mip.Data + int64_t(Y) * RowPitch + int64_t(X) * Bytes);
			}
		}
	}
	~FImage() { std::free(Memory); }
	FImage(const FImage&) = delete;
	FImage& operator=(const FImage&) = delete;

	FKernelTexture Texture;

private:
	FKernelMip Mip;
	uint8_t* Memory;
};

double TimeMs(FPassFunction Function, const FPass& Pass)
{
	const auto Start = std::chrono::steady_clock::now();
	Function(Pass);
	return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - Start).count();
}

double Median(std::vector<double> Values)
{
	std::nth_element(Values.begin(), Values.begin() + long(Values.size() / 2), Values.end());
	return Values[Values.size() / 2];
}

/** The shader's own .usf. BloomSetup is the library's pass with its threshold on; the others are tests/Shaders. */
FUsfKernel MakeUsfKernel(const std::string& Name, int32_t Lanes)
{
	const float SizeX = GSizeX;
	const float SizeY = GSizeY;
	FShaderCompileRequest Request;
	std::map<std::string, std::vector<float>> Constants = {{"ViewSize", {SizeX, SizeY, 1, 0}},
		{"InvSize", {1 / SizeX, 1 / SizeY}}, {"View_PreExposure", {1}}, {"View_OneOverPreExposure", {1}},
		{"BloomThreshold", {0.5f}}, {"Input_ViewportSizeInverse", {1 / SizeX, 1 / SizeY}},
		{"SvPositionToInputTextureUV", {1 / SizeX, 1 / SizeY, 0, 0}}};
	if (Name == "BloomSetup")
	{
		FBloomSetupPS::FPermutationDomain Permutation;
		Permutation.Set<FThresholdDimension>(true);
		ForEachShaderType(
			[&](const FShaderType& Type)
			{
				if (std::string(Type.GetName()) == "FBloomSetupPS")
				{
					const FShaderRef Shader(Type.FindOrCreateShader(Permutation.ToDimensionValueId()));
					Request = MakeShaderCompileRequest(Shader, Type.GetRootParametersMetadata());
				}
			});
	}
	else
	{
		MapShippedShaders();
		AddShaderDirectory("/Bench", DRYDOCK_BENCH_SOURCE_DIR "/tests/Shaders");
		const bool bKawase = Name == "KawaseDown";
		Request = bKawase ? MakeShaderCompileRequest("/Bench/DualKawase.usf", "DownSampleCS", EShaderStage::Compute)
						  : MakeShaderCompileRequest("/Bench/Blur13.usf", "BlurVerticalPS", EShaderStage::Pixel);
		Request.Defines = {{"NUMTHREADS_X", "8"}, {"NUMTHREADS_Y", "8"}};
	}
	Request.Lanes = {false, Lanes};
	return FUsfKernel(Request, Constants);
}

double TimeUsfMs(const FUsfKernel& Kernel, const FPass& Pass)
{
	const auto Start = std::chrono::steady_clock::now();
	Kernel.Run(Pass.Input, Pass.Output);
	return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - Start).count();
}

void RunPair(benchmark::State& State, const FKernelPair& Kernel, ETexelStorage Storage, int32_t Lanes)
{
	const FUsfKernel Usf = MakeUsfKernel(Kernel.Name, Lanes);
	const FImage UsfOutput(Storage, GSizeX / Kernel.OutputDivisor, GSizeY / Kernel.OutputDivisor);
	std::vector<double> UsfMs;
	const FImage Input(Storage, GSizeX, GSizeY);
	const FImage LanesOutput(Storage, GSizeX / Kernel.OutputDivisor, GSizeY / Kernel.OutputDivisor);
	const FImage ScalarOutput(Storage, GSizeX / Kernel.OutputDivisor, GSizeY / Kernel.OutputDivisor);
	std::vector<double> LanesMs;
	std::vector<double> ScalarMs;
	for (auto _ : State)
	{
		LanesMs.push_back(TimeMs(Kernel.Lanes, {Input.Texture, LanesOutput.Texture}));
		ScalarMs.push_back(TimeMs(Kernel.Scalar, {Input.Texture, ScalarOutput.Texture}));
		UsfMs.push_back(TimeUsfMs(Usf, {Input.Texture, UsfOutput.Texture}));
		State.SetIterationTime(UsfMs.back() / 1000);
	}
	State.counters["usf_ms"] = Median(UsfMs);
	State.counters["lanes_ms"] = Median(LanesMs);
	State.counters["scalar_ms"] = Median(ScalarMs);
	State.counters["ratio"] = Median(ScalarMs) / Median(UsfMs);
}

void Register(const char* Set, const FKernelPair* Kernels, int32_t Lanes)
{
	for (ETexelStorage Storage : {ETexelStorage::RGBA16_FLOAT, ETexelStorage::RGBA32_FLOAT})
	{
		for (int i = 0; i < GNumKernels; ++i)
		{
			const std::string Name = std::string(Kernels[i].Name) + "/" + GetTexelStorageInfo(Storage).Name + "/" + Set;
			benchmark::RegisterBenchmark(Name.c_str(), [&Kernel = Kernels[i], Storage, Lanes](benchmark::State& State)
				{ RunPair(State, Kernel, Storage, Lanes); })
				->UseManualTime()
				->Unit(benchmark::kMillisecond)
				->Iterations(15);
		}
	}
}

} // namespace
} // namespace Drydock::Bench

int main(int ArgumentCount, char** Arguments)
{
	using namespace Drydock;
	if (AreLanesSupported(false, 8))
	{
		Bench::Register("AVX2", Bench::GetKernelsAvx2(), 8);
	}
	if (AreLanesSupported(false, 16))
	{
		Bench::Register("AVX-512", Bench::GetKernelsAvx512(), 16);
	}
	benchmark::Initialize(&ArgumentCount, Arguments);
	benchmark::RunSpecifiedBenchmarks();
	return 0;
}
