// Shaders whose threads work together, drydock's kernels against lavapipe: the thread-group Gaussian and the histogram
// of tests/Shaders/Samples.usf over a picture of 1920 x 1080, all cores. The two alternate run by run, so that both see
// the same state of the machine; what is printed are medians, copies to and from the driver not counted. Wanted: at
// most 0.5.
#include "LanesDispatch.h"
#include "ShaderCompiler.h"
#include "TileExecutor.h"
#include "VulkanDrivers.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <random>
#include <vector>

namespace Drydock::Bench
{
namespace
{

constexpr int32_t GSizeX = 1920;
constexpr int32_t GSizeY = 1080;
constexpr int GRuns = 15;

/** RGBA in 32-bit floats, with the margins that kernels may read. */
struct FPicture
{
	FPicture()
		: Memory(size_t(GSizeX) * GSizeY * 16 + 128)
	{
		std::mt19937 Random(1);
		std::uniform_real_distribution<float> Value(0, 4);
		Mip = {Memory.data() + 64, GSizeX, GSizeY, 1, GSizeX * 16, int64_t(GSizeX) * GSizeY * 16};
		for (size_t i = 0; i < size_t(GSizeX) * GSizeY * 4; ++i)
		{
			const float Drawn = Value(Random);
			std::memcpy(Mip.Data + i * 4, &Drawn, 4);
		}
	}

	FKernelTexture GetView() const { return {&Mip, 1, ETexelStorage::RGBA32_FLOAT, 0, 0}; }

	std::vector<uint8_t> Memory;
	FKernelMip Mip;
};

double Median(std::vector<double> Values)
{
	std::nth_element(Values.begin(), Values.begin() + long(Values.size() / 2), Values.end());
	return Values[Values.size() / 2];
}

void Compare(const std::string& Entry, FVulkanBackend& Driver)
{
	AddShaderDirectory("/Samples", DRYDOCK_BENCH_SOURCE_DIR "/tests/Shaders");
	FShaderCompileRequest Request;
	Request.VirtualPath = "/Samples/Samples.usf";
	Request.EntryPoint = Entry;
	const std::shared_ptr<const FCompiledShader> Shader = CompileShader(Request);
	const std::shared_ptr<const FShaderReflection> Reflection(Shader, &Shader->Reflection);

	std::vector<std::vector<uint8_t>> Constants;
	std::vector<const uint8_t*> Pointers;
	for (const FShaderConstantBuffer& Buffer : Reflection->ConstantBuffers)
	{
		Constants.emplace_back(Buffer.Size);
	}
	for (const FShaderConstant& Constant : Reflection->Constants)
	{
		uint8_t* const To = Constants[Constant.Buffer].data() + Constant.Offset;
		for (int k = 0; Constant.Name == "Weights" && k < 9; ++k)
		{
			const float Weight = float(std::exp(-k * k / 18.0) / 7.5);
			std::memcpy(To + k * 4, &Weight, 4);
		}
		const int32_t Size[2] = {GSizeX, GSizeY};
		std::memcpy(To, Size, Constant.Name == "Size" ? sizeof(Size) : 0);
	}
	for (const std::vector<uint8_t>& Buffer : Constants)
	{
		Pointers.push_back(Buffer.data());
	}
	static const FPicture Input;
	static const FPicture Output;
	const FKernelTexture Textures[] = {Input.GetView()};
	const FKernelTexture RWTextures[] = {Output.GetView()};
	std::vector<uint32_t> Counts(64);
	const FKernelBuffer RWBuffers[] = {{reinterpret_cast<uint8_t*>(Counts.data()), 256, 4, ETexelStorage::R32_UINT}};
	const FKernelArgs Args = {
		Pointers.data(), Textures, RWTextures, nullptr, nullptr, RWBuffers, nullptr, nullptr, 0, nullptr, nullptr};

	const auto RoundUp = [&](int32_t Size, int Axis)
	{
		const int32_t Group = Reflection->GroupSize[Axis];
		return (Size + Group - 1) / Group * Group;
	};
	const FKernelTile Whole = {0, 0, 0, RoundUp(GSizeX, 0), RoundUp(GSizeY, 1), 1};
	std::vector<double> Ours;
	std::vector<double> Theirs;
	for (int Run = 0; Run <= GRuns; ++Run)
	{
		const auto Start = std::chrono::steady_clock::now();
		ForEachTile(
			Whole, FIntVector(RoundUp(256, 0), RoundUp(16, 1), 1),
			[&](const FKernelTile& Tile) { Shader->Run(Args, Tile); }, EDenormals::Flush);
		const double Taken =
			std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - Start).count();
		const std::string Fault = Driver.Run(Request, Reflection, Args, Whole);
		if (!Fault.empty())
		{
			std::printf("%s does not run there: %s\n", Entry.c_str(), Fault.c_str());
			return;
		}
		if (Run > 0) // the first one makes what the others find
		{
			Ours.push_back(Taken);
			Theirs.push_back(Driver.GetRunMilliseconds());
		}
	}
	std::printf(
		"%-12s %9.2f %9.2f %7.2f\n", Entry.c_str(), Median(Ours), Median(Theirs), Median(Ours) / Median(Theirs));
}

} // namespace
} // namespace Drydock::Bench

int main()
{
	using namespace Drydock;
	Test::FVulkanDriver& Lavapipe = Test::GetVulkanDrivers().front();
	if (!Lavapipe.Backend)
	{
		std::printf("%s\n", Lavapipe.Fault.c_str());
		return 0;
	}
	std::printf("%s, %d threads here\n%-12s %9s %9s %7s\n", Lavapipe.Backend->GetDeviceName().c_str(), GetNumThreads(),
		"shader", "drydock", "lavapipe", "ratio");
	Bench::Compare("GaussianCS", *Lavapipe.Backend);
	Bench::Compare("HistogramCS", *Lavapipe.Backend);
	return 0;
}
