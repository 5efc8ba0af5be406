// What shaders cost that a user writes into a .usf: pointwise work, blurs, taps between texels; no native kernel helps
// them. Prints nanoseconds per pixel and the ratio to a copy of the picture by memcpy, and how long the compiler took
// for the kernel; the fastest of rounds in which everything is measured once, one thread, tiles as in a graph.
//
//     bench_usf [ROUNDS]
#include "LanesDispatch.h"
#include "PixelFormatConversion.h"
#include "ShaderFrontEnd.h"
#include "UsfKernel.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>
#include <random>
#include <unistd.h>

namespace Drydock::Bench
{
namespace
{

constexpr int32_t GSizeX = 960;
constexpr int32_t GSizeY = 270;

const char* const GHead = R"(
Texture2D Input;
SamplerState InputSampler;
float2 Size;
float2 InverseSize;
float Radius;
)";

struct FUserShader
{
	const char* Name;
	const char* Text; // the body of float4 Shade(float2 Position, float2 UV)
};

const FUserShader GShaders[] = {
	{"copy by sample", "return Input.SampleLevel(InputSampler, UV, 0);"},
	{"copy by Load", "return Input.Load(int3(int2(Position), 0));"},
	{"tint", "return Input.SampleLevel(InputSampler, UV, 0) * float4(1.1, 0.9, 0.8, 1) + 0.01;"},
	{"bright, screen, pow", R"(
	float4 C = Input.SampleLevel(InputSampler, UV, 0);
	float Amount = saturate((dot(C.rgb, float3(0.3, 0.59, 0.11)) - 1.0) * 0.5);
	float3 S = saturate(C.rgb);
	float3 B = saturate(C.rgb * Amount);
	return float4(pow(1.0 - (1.0 - S) * (1.0 - B), 1.0 / 2.2), C.a);)"},
	{"Gaussian, 9 taps", R"(
	float4 Sum = 0;
	float Weights = 0;
	for (int i = -4; i <= 4; ++i)
	{
		float W = exp(-0.5 * i * i / (Radius * Radius));
		Sum += W * Input.SampleLevel(InputSampler, UV + float2(i * InverseSize.x, 0), 0);
		Weights += W;
	}
	return Sum / Weights;)"},
	{"Gaussian down, half-texel pairs", R"(
	float4 Sum = 0;
	for (int i = -4; i <= 4; ++i)
	{
		Sum += Input.SampleLevel(InputSampler, UV + float2(0, (2 * i + 0.5) * InverseSize.y), 0);
	}
	return Sum / 9;)"},
	{"box 17, Load", R"(
	float4 Sum = 0;
	for (int i = -8; i <= 8; ++i)
	{
		Sum += Input.Load(int3(clamp(int2(Position) + int2(i, 0), int2(0, 0), int2(Size) - 1), 0));
	}
	return Sum / 17;)"},
	{"four corners, bilinear", R"(
	float2 H = 0.5 * InverseSize;
	return 0.25 * (Input.SampleLevel(InputSampler, UV + H * float2(-1, -1), 0) +
		Input.SampleLevel(InputSampler, UV + H * float2(1, -1), 0) +
		Input.SampleLevel(InputSampler, UV + H * float2(-1, 1), 0) +
		Input.SampleLevel(InputSampler, UV + H * float2(1, 1), 0));)"},
	{"half size, 4 taps", R"(
	float2 At = UV * 0.5;
	return 0.25 * (Input.SampleLevel(InputSampler, At * 2 + InverseSize * float2(-1, -1), 0) +
		Input.SampleLevel(InputSampler, At * 2 + InverseSize * float2(1, -1), 0) +
		Input.SampleLevel(InputSampler, At * 2 + InverseSize * float2(-1, 1), 0) +
		Input.SampleLevel(InputSampler, At * 2 + InverseSize * float2(1, 1), 0));)"},
	{"magnified 2x", "return Input.SampleLevel(InputSampler, UV * 0.5, 0);"},
	{"uniform grading", R"(
	float3 Lift = pow(Size.xyx * InverseSize.xyy, 1 + Radius);
	float3 Gain = exp2(sin(Radius * float3(1, 2, 3)));
	return float4(Input.SampleLevel(InputSampler, UV, 0).rgb * Gain + Lift, 1);)"},
};

class FPicture
{
public:
	explicit FPicture(ETexelStorage Storage)
	{
		const int32_t Bytes = GetTexelStorageInfo(Storage).BytesPerTexel;
		Mip = {nullptr, GSizeX, GSizeY, 1, (GSizeX * Bytes + 63) / 64 * 64, 0};
		Mip.SlicePitch = int64_t(Mip.RowPitch) * GSizeY;
		Memory.resize(size_t(Mip.SlicePitch) + 192);
		Mip.Data = Memory.data() + 128 - reinterpret_cast<uintptr_t>(Memory.data()) % 64;
		Texture = {&Mip, 1, Storage, 0, 0};
		std::mt19937 Engine(1);
		std::uniform_real_distribution<float> Value(0, 1);
		for (int32_t Y = 0; Y < GSizeY; ++Y)
		{
			for (int32_t X = 0; X < GSizeX; ++X)
			{
				const float RGBA[4] = {Value(Engine), Value(Engine), Value(Engine), 0.5f};
				EncodeTexel(Storage, RGBA, Mip.Data + int64_t(Y) * Mip.RowPitch + int64_t(X) * Bytes);
			}
		}
	}
	FPicture(const FPicture&) = delete;
	FPicture& operator=(const FPicture&) = delete;

	size_t GetBytes() const { return size_t(Mip.SlicePitch); }

	FKernelTexture Texture;
	FKernelMip Mip;

private:
	std::vector<uint8_t> Memory;
};

double ThreadSeconds()
{
	timespec Time;
	clock_gettime(CLOCK_THREAD_CPUTIME_ID, &Time);
	return double(Time.tv_sec) + 1e-9 * double(Time.tv_nsec);
}

double Fastest(const std::vector<double>& Values)
{
	return *std::min_element(Values.begin(), Values.end());
}

struct FMeasured
{
	std::string Name;
	std::unique_ptr<FUsfKernel> Kernel;
	double CompileSeconds = 0;
	std::vector<double> Times[2] = {};
};

double WallSeconds()
{
	timespec Time;
	clock_gettime(CLOCK_MONOTONIC, &Time);
	return double(Time.tv_sec) + 1e-9 * double(Time.tv_nsec);
}

int Main(int Rounds)
{
	const std::map<std::string, std::vector<float>> Constants = {
		{"Size", {float(GSizeX), float(GSizeY)}}, {"InverseSize", {1.0f / GSizeX, 1.0f / GSizeY}}, {"Radius", {2.0f}}};
	std::vector<FMeasured> All;
	for (const FUserShader& User : GShaders)
	{
		FShaderCompileRequest Request;
		Request.VirtualPath = "/Bench/User.usf";
		Request.GeneratedFiles = {{Request.VirtualPath,
			std::string(GHead) + "float4 Shade(float2 Position, float2 UV)\n{\n" + User.Text +
				"\n}\nvoid MainPS(float4 Position : SV_POSITION, out float4 Color : SV_Target0)\n{\n"
				"\tColor = Shade(Position.xy, Position.xy * InverseSize);\n}\n"}};
		Request.EntryPoint = "MainPS";
		Request.Stage = EShaderStage::Pixel;
		const double Start = WallSeconds();
		FMeasured Measured;
		Measured.Name = User.Name;
		Measured.Kernel = std::make_unique<FUsfKernel>(Request, Constants);
		Measured.CompileSeconds = WallSeconds() - Start;
		All.push_back(std::move(Measured));
	}
	const ETexelStorage Storages[2] = {ETexelStorage::RGBA32_FLOAT, ETexelStorage::RGBA16_FLOAT};
	std::vector<double> Copies[2];
	for (int Format = 0; Format < 2; ++Format)
	{
		const FPicture Input(Storages[Format]);
		const FPicture Output(Storages[Format]);
		for (int Round = -1; Round < Rounds; ++Round)
		{
			const double CopyStart = ThreadSeconds();
			std::memcpy(Output.Mip.Data, Input.Mip.Data, Input.GetBytes());
			Copies[Format].push_back(ThreadSeconds() - CopyStart);
			for (FMeasured& Measured : All)
			{
				const double Start = ThreadSeconds();
				Measured.Kernel->Run(Input.Texture, Output.Texture, 2048, 64);
				if (Round >= 0)
				{
					Measured.Times[Format].push_back(ThreadSeconds() - Start);
				}
			}
		}
	}
	std::printf(
		"| shader | ready in ms | RGBA32F ns/px | copies | RGBA16F ns/px | copies |\n|---|---|---|---|---|---|\n");
	for (const FMeasured& Measured : All)
	{
		std::printf("| %s | %.0f |", Measured.Name.c_str(), Measured.CompileSeconds * 1e3);
		for (int Format = 0; Format < 2; ++Format)
		{
			const double Time = Fastest(Measured.Times[Format]);
			std::printf(" %.2f | %.1f |", Time * 1e9 / (GSizeX * GSizeY), Time / Fastest(Copies[Format]));
		}
		std::printf("\n");
	}
	return 0;
}

} // namespace
} // namespace Drydock::Bench

int main(int NumArguments, char** Arguments)
{
	// A shader cache of its own: "ready" is what compiling takes.
	const std::filesystem::path Cache =
		std::filesystem::temp_directory_path() / ("drydock_bench_usf_" + std::to_string(getpid()));
	setenv("DRYDOCK_CACHE_DIR", Cache.c_str(), 1);
	const int Result = Drydock::Bench::Main(NumArguments > 1 ? std::max(1, std::atoi(Arguments[1])) : 15);
	std::filesystem::remove_all(Cache);
	return Result;
}
