// What kernels know of a pixel's neighbours: samples and loads that are remembered over a tile, and uniform work that
// is done once a tile or once a row, agree with the interpreter bit for bit, wherever the coordinates fall.
#include <gtest/gtest.h>

#include "PixelFormatConversion.h"
#include "ShaderHarness.h"

#include <limits>
#include <random>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

constexpr int32_t Width = 83; // packs of every width, and a rest
constexpr int32_t Height = 7;

const char* const Samples = R"(
Texture2D Input;
SamplerState InputSampler;
float2 Scale;
float2 Offset;
float2 Low;
float2 High;
float2 Step;
float Level;
float Limit;
int Count;
void MainPS(float4 Position : SV_POSITION, float4 UV : TEXCOORD0, out float4 A : SV_Target0, out float4 B : SV_Target1,
	out float4 C : SV_Target2, out float4 D : SV_Target3)
{
	float2 P = Position.xy * Scale + Offset;
	A = Input.SampleLevel(InputSampler, P, Level);
	A += 0.5 * Input.SampleLevel(InputSampler, clamp(P + Step, Low, High), 0);
	A += 0.25 * Input.SampleLevel(InputSampler, UV.xy, 0) + 0.125 * Input.SampleLevel(InputSampler, UV.zw, 0);
	B = 0;
	for (int i = -Count; i <= Count; ++i)
	{
		for (int j = 0; j < 2; ++j)
		{
			B += (i + 10) * Input.SampleLevel(InputSampler, P + Step * float2(i, j), 0);
		}
	}
	// Turns and columns that hang on the row, on the column, or on the picture.
	C = 0;
	for (int k = 0; k < int(Position.y) % 3; ++k)
	{
		C += Input.SampleLevel(InputSampler, P + Step * k, 0);
	}
	for (int l = 0; l < 6; ++l)
	{
		float4 T = Input.SampleLevel(InputSampler, P - Step * l, 0);
		C += T;
		if (T.x > Limit)
			break;
	}
	float Shift = 0;
	for (int m = 0; m < 5; ++m)
	{
		if (Position.y + m > 3 + 10 * Limit)
			break;
		Shift += Scale.x;
	}
	C += Input.SampleLevel(InputSampler, P + float2(Shift, 0), 0);
	C += Input.SampleLevel(InputSampler, P.yx, 0) + Input.SampleLevel(InputSampler, P + P.yx, 0);
	D = 0;
	if (Position.x + 5 * Position.y > 40)
	{
		D += Input.SampleLevel(InputSampler, P + Step, 0);
		for (int n = 0; n < 3; ++n)
		{
			D += Input.SampleLevel(InputSampler, P + n * Step * 0.5, 0);
		}
	}
	float Chosen = P.x;
	if (Position.x > 20)
	{
		Chosen = P.x + Step.x;
	}
	D += Input.SampleLevel(InputSampler, float2(Chosen, P.y), 0);
	if (D.x > 3 * Limit)
		discard;
	D += Input.SampleLevel(InputSampler, P + 2 * Step, 0);
}
)";

const char* const Loads = R"(
Texture2D Input;
float2 Scale;
float2 Offset;
int2 Last;
int Count;
float Limit;
RWTexture2D<float4> Out;
[numthreads(8, 8, 1)]
void MainCS(uint2 Id : SV_DispatchThreadID)
{
	if (any(int2(Id) > Last))
		return;
	float4 Sum = Input.Load(int3(Id, 0)) + Input.Load(int3(int2(Id) - 1, 0)) + Input.Load(int3(Id * 2, 0));
	Sum += Input.Load(int3(int2(floor((Id + 0.5) * Scale + Offset)), 0)) + Input.Load(int3(Id.yx, 0));
	for (int i = -Count; i <= Count; ++i)
	{
		Sum += (i + 10) * Input.Load(int3(clamp(int2(Id) + int2(i, 0), 0, Last), 0));
		if (i > Limit && Id.y % 2 == 0)
			continue;
		Sum += Input[int2(Id) + int2(0, i)];
	}
	Out[Id] = Sum;
}
)";

class FRandom
{
public:
	explicit FRandom(uint32_t Seed)
		: Engine(Seed)
	{
	}
	int32_t Int(int32_t Low, int32_t High) { return std::uniform_int_distribution<int32_t>(Low, High)(Engine); }
	template<typename T, size_t Count>
	T Pick(const T (&From)[Count])
	{
		return From[Int(0, int32_t(Count) - 1)];
	}
	float Unit() { return std::uniform_real_distribution<float>(0, 1)(Engine); }

private:
	std::mt19937 Engine;
};

/** A picture in another format; its floats become what that format keeps of them. */
class FEncodedPicture
{
public:
	FEncodedPicture(FTestTexture& Picture, ETexelStorage Storage)
	{
		const int32_t Bytes = GetTexelStorageInfo(Storage).BytesPerTexel;
		Memory.resize(size_t(Picture.SizeX * Picture.SizeY * Bytes) + 128);
		for (int32_t i = 0; i < Picture.SizeX * Picture.SizeY; ++i)
		{
			EncodeTexel(Storage, Picture.Texel(0, 0) + 4 * i, Memory.data() + 64 + i * Bytes);
			DecodeTexel(Storage, Memory.data() + 64 + i * Bytes, Picture.Texel(0, 0) + 4 * i);
		}
		Mip = {Memory.data() + 64, Picture.SizeX, Picture.SizeY, 1, Picture.SizeX * Bytes,
			int64_t(Picture.SizeX) * Picture.SizeY * Bytes};
		Texture = {&Mip, 1, Storage, 0, 0};
	}

	FKernelTexture Texture;

private:
	FKernelMip Mip;
	std::vector<uint8_t> Memory;
};

constexpr ETexelStorage Storages[] = {ETexelStorage::RGBA32_FLOAT, ETexelStorage::RGBA16_FLOAT,
	ETexelStorage::RGBA16_FLOAT, ETexelStorage::R11G11B10_FLOAT, ETexelStorage::BGRA8_UNORM, ETexelStorage::R8_UNORM,
	ETexelStorage::RGBA8_SRGB};

/** The same state for kernel and model. */
void Fill(FShaderHarness& Harness, uint32_t Seed, int32_t NumTargets)
{
	FRandom Random(Seed);
	const float Rates[] = {1, 1, 1, 2, 0.5f, -1, 0, 0.3f, 7, 1e30f, std::numeric_limits<float>::quiet_NaN()};
	const float Offsets[] = {0, 0, 0.5f, -0.5f, 1, -2, 0.25f, -1e9f};
	const EKernelAddress Addresses[] = {
		EKernelAddress::Wrap, EKernelAddress::Clamp, EKernelAddress::Mirror, EKernelAddress::Border};
	const EKernelFilter Filters[] = {EKernelFilter::Point, EKernelFilter::Bilinear, EKernelFilter::Trilinear};
	const int32_t SizeX = Random.Int(0, 1) ? Width : Random.Int(1, 67);
	const int32_t SizeY = Random.Int(0, 1) ? Height : Random.Int(1, 9);
	FTestTexture Input(SizeX, SizeY);
	for (int32_t i = 0; i < SizeX * SizeY * 4; ++i)
	{
		Input.Texel(0, 0)[i] = Random.Unit();
	}
	if (Random.Int(0, 1))
	{
		const float Strange[] = {
			std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -0.0f, -1e-40f};
		Input.Texel(Random.Int(0, SizeX - 1), Random.Int(0, SizeY - 1))[Random.Int(0, 3)] = Random.Pick(Strange);
	}
	FEncodedPicture(Input, Storages[Seed % std::size(Storages)]);
	Harness.Textures["Input"] = Input;
	Harness.Textures["Out"] = FTestTexture(Width, Height);
	Harness.Targets.assign(size_t(NumTargets), FTestTexture(Width, Height));
	Harness.Sampler = {Random.Pick(Filters), Random.Pick(Addresses), Random.Pick(Addresses), EKernelAddress::Clamp,
		uint8_t(Random.Int(0, 7) ? 8 : 0), 0, {0.5f, 1, -0.0f, 2}};
	const float TexelX = 1.0f / float(SizeX);
	const float TexelY = 1.0f / float(SizeY);
	const float RateX = Random.Pick(Rates);
	const float RateY = Random.Pick(Rates);
	const bool bLoads = NumTargets == 0;
	Harness.SetFloats("Scale", {bLoads ? RateX : RateX * TexelX, bLoads ? RateY : RateY * TexelY});
	Harness.SetFloats("Offset", {Random.Pick(Offsets) * TexelX, Random.Pick(Offsets) * TexelY});
	Harness.SetFloats("Step", {Random.Pick(Offsets) * TexelX, Random.Pick(Offsets) * TexelY});
	Harness.SetFloats("Low", {0.5f * TexelX, 0.5f * TexelY});
	Harness.SetFloats("High", {1 - 0.5f * TexelX, 1 - 0.5f * TexelY});
	Harness.SetFloats("Level", {Random.Pick(Offsets)});
	Harness.SetFloats("Limit", {Random.Unit()});
	Harness.Constants["Count"] = {uint32_t(Random.Int(0, 40))};
	Harness.Constants["Last"] = {uint32_t(SizeX - 1), uint32_t(SizeY - 1)};
	FKernelInterpolant& UV = Harness.Interpolants[0];
	UV = {{0.0, 0.0, Random.Unit(), 0.5}, {TexelX, 0.0, 2 * TexelX, 0.0}, {0.0, TexelY, 0.0, 0.25 * TexelY}};
	if (Random.Int(0, 3) == 0)
	{
		UV.DX[Random.Int(0, 3)] += 0.01; // no triangle that fills the screen
		UV.DY[Random.Int(0, 3)] -= 0.02;
	}
}

void ExpectSame(FTestTexture& Model, FTestTexture& Kernel, const std::string& What)
{
	for (int32_t i = 0; i < Width * Height * 4; ++i)
	{
		const float Expected = Model.Texel(0, 0)[i];
		const float Actual = Kernel.Texel(0, 0)[i];
		ASSERT_TRUE(SameFloat(Expected, Actual)) << What << " at (" << i / 4 % Width << ", " << i / 4 / Width
												 << ") channel " << i % 4 << ": " << Expected << ", " << Actual;
	}
}

/** The shader's pictures by the interpreter, and by kernels of every width from the floats and from their format. */
void ExpectTheModel(const char* Text, const char* EntryPoint, EShaderStage Stage, int32_t NumTargets)
{
	for (uint32_t Seed = 0; Seed < 70; ++Seed)
	{
		FShaderHarness Model(Text, EntryPoint, Stage);
		Fill(Model, Seed, NumTargets);
		Model.RunModel(Width, Height);
		for (const int32_t Lanes : GetLaneCounts())
		{
			FShaderHarness Kernel(Text, EntryPoint, Stage);
			Fill(Kernel, Seed, NumTargets);
			const auto Compare = [&](const char* Source)
			{
				const std::string What =
					"seed " + std::to_string(Seed) + ", " + std::to_string(Lanes) + " lanes, " + Source;
				ExpectSame(Model.Textures["Out"], Kernel.Textures["Out"], What);
				for (size_t t = 0; t < Kernel.Targets.size() && !testing::Test::HasFailure(); ++t)
				{
					ExpectSame(Model.Targets[t], Kernel.Targets[t], What + ", target " + std::to_string(t));
				}
			};
			const std::shared_ptr<const FCompiledShader> Shader = Kernel.Run(Lanes, Width, Height);
			Compare("floats");
			const FEncodedPicture Encoded(Kernel.Textures["Input"], Storages[Seed % std::size(Storages)]);
			FKernelArgs Args = Kernel.GetArgs();
			Args.Textures = &Encoded.Texture;
			Shader->Run(Args, {0, 0, 0, Width, Height, 1});
			Compare("encoded");
			ASSERT_FALSE(testing::Test::HasFailure());
		}
	}
}

} // namespace

TEST(FKernelTaps, SamplesAreThoseOfTheModel)
{
	ExpectTheModel(Samples, "MainPS", EShaderStage::Pixel, 4);
}

TEST(FKernelTaps, LoadsAreThoseOfTheModel)
{
	ExpectTheModel(Loads, "MainCS", EShaderStage::Compute, 0);
}

// A transposed matrix mixes columns that differ between pixels with such that do not.
TEST(FKernelTaps, UniformWorkInBranchesAndLoopsIsThatOfTheModel)
{
	const std::string Text = R"(
float4 Uniform;
int Count;
RWStructuredBuffer<float4> Out;
[numthreads(8, 8, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID)
{
	float4 Sum = 0;
	float2x2 M = transpose(float2x2(Id.x, Uniform.x, Uniform.y, Id.y));
	Sum.xy = mul(M, float2(Uniform.z, Id.y)) + M[0] * M[1];
	for (int i = 0; i < Count; ++i)
	{
		if ((Id.x + i) % 3 == 0)
			continue;
		float Row = pow(abs(Uniform.w) + Id.y, 1.5) / (1 + i);
		if (Id.y > 1)
			Sum.z += Row * exp2(Uniform.x) + float(int(Id.y) / Count);
		else
			Sum.w += log2(Row) + clamp(float2(Id.x, Uniform.y), Uniform.z, 3 + Id.y).y;
	}
	Out[Id.x + 83 * (Id.y + 7 * Id.z)] = Sum * (Id.z + 1);
}
)";
	for (uint32_t Seed = 0; Seed < 4; ++Seed)
	{
		FRandom Random(Seed);
		const std::vector<float> Uniform = {Random.Unit(), -Random.Unit(), Random.Unit(), 5 * Random.Unit()};
		const auto Prepare = [&](FShaderHarness& Harness)
		{
			Harness.SetFloats("Uniform", Uniform);
			Harness.Constants["Count"] = {Seed * 2};
			Harness.Buffers["Out"].assign(size_t(Width) * Height * 2 * 4, 0);
		};
		FShaderHarness Model(Text, "MainCS", EShaderStage::Compute);
		Prepare(Model);
		Model.RunModel(Width, Height, 2);
		for (const int32_t Lanes : GetLaneCounts())
		{
			FShaderHarness Kernel(Text, "MainCS", EShaderStage::Compute);
			Prepare(Kernel);
			Kernel.Run(Lanes, Width, Height, 2);
			for (size_t i = 0; i < Model.Buffers["Out"].size(); ++i)
			{
				ASSERT_TRUE(SameFloat(Model.BufferFloat("Out", i), Kernel.BufferFloat("Out", i)))
					<< "seed " << Seed << ", " << Lanes << " lanes, float " << i;
			}
		}
	}
}
