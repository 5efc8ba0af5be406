// The shapes of real post-process shaders agree with direct double computation, at every lane count, and with the model
// bit for bit. The shapes are those measured in the study of the shader tier.
#include <gtest/gtest.h>

#include "ShaderHarness.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

constexpr int32_t Width = 21;
constexpr int32_t Height = 9;

FTestTexture MakeNoise(int32_t X, int32_t Y, uint32_t Seed)
{
	FTestTexture Result(X, Y);
	std::mt19937 Random(Seed);
	std::uniform_real_distribution<float> Values(0.0f, 4.0f);
	for (int32_t y = 0; y < Y; ++y)
	{
		for (int32_t x = 0; x < X; ++x)
		{
			for (int c = 0; c < 4; ++c)
			{
				Result.Texel(x, y)[c] = Values(Random);
			}
		}
	}
	return Result;
}

struct FColor
{
	double C[4] = {};
	FColor operator*(double s) const { return {{C[0] * s, C[1] * s, C[2] * s, C[3] * s}}; }
	FColor operator+(const FColor& o) const { return {{C[0] + o.C[0], C[1] + o.C[1], C[2] + o.C[2], C[3] + o.C[3]}}; }
};

/** Bilinear, clamped, coordinates snapped to 1/256 texel: D3D's sampler written down. */
FColor Sample(FTestTexture& T, double U, double V)
{
	const double X = std::floor(U * T.SizeX * 256 + 0.5) / 256 - 0.5;
	const double Y = std::floor(V * T.SizeY * 256 + 0.5) / 256 - 0.5;
	const double X0 = std::floor(X);
	const double Y0 = std::floor(Y);
	FColor Sum;
	for (int j = 0; j < 2; ++j)
	{
		for (int i = 0; i < 2; ++i)
		{
			const int32_t x = std::clamp(int32_t(X0) + i, 0, T.SizeX - 1);
			const int32_t y = std::clamp(int32_t(Y0) + j, 0, T.SizeY - 1);
			const double Weight = (i ? X - X0 : 1 - (X - X0)) * (j ? Y - Y0 : 1 - (Y - Y0));
			for (int c = 0; c < 4; ++c)
			{
				Sum.C[c] += Weight * T.Texel(x, y)[c];
			}
		}
	}
	return Sum;
}

/** Runs a pixel shader MainPS with input InputTexture at all lane counts and on the model; each result must have the
 *  same bits. Expected(x, y) is compared within Tolerance, relative to max(1, |expected|). */
template<typename F>
void ExpectShape(
	const std::string& Text, F Expected, double Tolerance, const std::function<void(FShaderHarness&)>& SetUp)
{
	FShaderHarness Model(
		"Texture2D InputTexture;\nSamplerState InputSampler;\nfloat2 InvSize;\n" + Text, "MainPS", EShaderStage::Pixel);
	SetUp(Model);
	Model.SetFloats("InvSize", {1.0f / Width, 1.0f / Height});
	Model.Interpolants[0].DX[0] = 1.0 / Width;
	Model.Interpolants[0].DY[1] = 1.0 / Height;
	Model.Targets = {FTestTexture(Width, Height)};
	FShaderHarness Kernel = Model;
	Model.RunModel(Width, Height);
	for (const int32_t Lanes : GetLaneCounts())
	{
		Kernel.Targets = {FTestTexture(Width, Height)};
		Kernel.Run(Lanes, Width, Height);
		for (int32_t y = 0; y < Height; ++y)
		{
			for (int32_t x = 0; x < Width; ++x)
			{
				const FColor Exact = Expected(x, y);
				for (int c = 0; c < 4; ++c)
				{
					const float Got = Kernel.Targets[0].Texel(x, y)[c];
					ASSERT_TRUE(SameFloat(Model.Targets[0].Texel(x, y)[c], Got))
						<< Lanes << " lanes, (" << x << ", " << y << ")." << c;
					ASSERT_NEAR(Exact.C[c], Got, Tolerance * std::max(1.0, std::fabs(Exact.C[c])))
						<< "(" << x << ", " << y << ")." << c;
				}
			}
		}
	}
}

} // namespace

TEST(ShaderShapes, KawaseDown)
{
	FTestTexture Input = MakeNoise(Width * 2, Height * 2, 1);
	ExpectShape(R"(
float4 MainPS(float4 P : SV_POSITION) : SV_Target0
{
	float2 UV = P.xy * InvSize;
	float2 Half = 0.25 * InvSize;
	float4 Sum = InputTexture.SampleLevel(InputSampler, UV, 0) * 4.0;
	Sum += InputTexture.SampleLevel(InputSampler, UV - Half, 0);
	Sum += InputTexture.SampleLevel(InputSampler, UV + Half, 0);
	Sum += InputTexture.SampleLevel(InputSampler, UV + float2(Half.x, -Half.y), 0);
	Sum += InputTexture.SampleLevel(InputSampler, UV - float2(Half.x, -Half.y), 0);
	return Sum / 8.0;
}
)",
		[&Input](int32_t x, int32_t y)
		{
			const double U = (x + 0.5) / Width, V = (y + 0.5) / Height, H = 0.25 / Width, K = 0.25 / Height;
			return (Sample(Input, U, V) * 4 + Sample(Input, U - H, V - K) + Sample(Input, U + H, V + K) +
					   Sample(Input, U + H, V - K) + Sample(Input, U - H, V + K)) *
				   0.125;
		},
		2e-6, [&Input](FShaderHarness& H) { H.Textures["InputTexture"] = Input; });
}

TEST(ShaderShapes, ThirteenTapBlurWithAConstantTable)
{
	FTestTexture Input = MakeNoise(Width, Height, 2);
	const double Weights[7] = {0.0044, 0.0115, 0.0257, 0.0488, 0.0799, 0.1129, 0.1377};
	ExpectShape(R"(
static const float Weights[7] = { 0.0044, 0.0115, 0.0257, 0.0488, 0.0799, 0.1129, 0.1377 };
void MainPS(float4 P : SV_POSITION, float2 UV : TEXCOORD0, out float4 OutColor : SV_Target0)
{
	float4 Sum = 0;
	for (int i = -6; i <= 6; ++i)
	{
		Sum += Weights[6 - abs(i)] * InputTexture.SampleLevel(InputSampler, UV + float2(0, i) * InvSize, 0);
	}
	OutColor = Sum;
}
)",
		[&](int32_t x, int32_t y)
		{
			FColor Sum;
			for (int i = -6; i <= 6; ++i)
			{
				Sum = Sum + Sample(Input, (x + 0.5) / Width, (y + 0.5 + i) / Height) * Weights[6 - std::abs(i)];
			}
			return Sum;
		},
		4e-6, [&Input](FShaderHarness& H) { H.Textures["InputTexture"] = Input; });
}

TEST(ShaderShapes, BloomSetupWithABranchPerPixel)
{
	FTestTexture Input = MakeNoise(Width, Height, 3);
	ExpectShape(R"(
float BloomThreshold;
float ToonIntensity;
float4 MainPS(float4 P : SV_POSITION) : SV_Target0
{
	float4 Color = InputTexture.Load(int3(P.xy, 0));
	float Luminance = dot(Color.rgb, float3(0.3, 0.59, 0.11));
	float Amount = saturate((Luminance - BloomThreshold) * 0.5);
	BRANCH_IF (Color.a > 2.0)
	{
		Color.rgb *= ToonIntensity;
	}
	return float4(Color.rgb * Amount, 0);
}
)",
		[&Input](int32_t x, int32_t y)
		{
			const float* C = Input.Texel(x, y);
			const double Luminance = 0.3f * double(C[0]) + 0.59f * double(C[1]) + 0.11f * double(C[2]);
			const double Amount = std::clamp((Luminance - 1.0) * 0.5, 0.0, 1.0) * (C[3] > 2 ? double(0.1f) : 1.0);
			return FColor{{C[0] * Amount, C[1] * Amount, C[2] * Amount, 0}};
		},
		2e-6,
		[&Input](FShaderHarness& H)
		{
			H.Textures["InputTexture"] = Input;
			H.Request.Defines = {{"BRANCH_IF", "[branch] if"}};
			H.SetFloats("BloomThreshold", {1.0f});
			H.SetFloats("ToonIntensity", {0.1f});
		});
}

TEST(ShaderShapes, DoubleLoopWhoseRadiusVariesPerPixel)
{
	FTestTexture Input = MakeNoise(Width, Height, 4);
	ExpectShape(R"(
float4 Glow(float2 UV, int Radius)
{
	if (Radius == 0)
	{
		return InputTexture.SampleLevel(InputSampler, UV, 0);
	}
	float4 Sum = 0;
	float Count = 0;
	for (int y = -Radius; y <= Radius; ++y)
	{
		if (y == 2) break;
		for (int x = -Radius; x <= Radius; ++x)
		{
			if (x * y == 1) continue;
			Sum += InputTexture.SampleLevel(InputSampler, UV + float2(x, y) * InvSize, 0);
			Count += 1;
		}
	}
	return Sum / Count;
}
float4 MainPS(float4 P : SV_POSITION) : SV_Target0
{
	return Glow(P.xy * InvSize, (int)P.x % 4);
}
)",
		[&Input](int32_t px, int32_t py)
		{
			const int Radius = px % 4;
			FColor Sum;
			double Count = 0;
			for (int y = -Radius; y <= Radius && y != 2; ++y)
			{
				for (int x = -Radius; x <= Radius; ++x)
				{
					if (x * y != 1 || Radius == 0)
					{
						Sum = Sum + Sample(Input, (px + 0.5 + x) / Width, (py + 0.5 + y) / Height);
						Count += 1;
					}
				}
			}
			return Sum * (1 / Count);
		},
		4e-6, [&Input](FShaderHarness& H) { H.Textures["InputTexture"] = Input; });
}

TEST(ShaderShapes, PowerFilterAndScreenBlend)
{
	FTestTexture Input = MakeNoise(Width, Height, 5);
	ExpectShape(R"(
float Power;
float4 MainPS(float4 P : SV_POSITION) : SV_Target0
{
	float3 C = InputTexture.Load(int3(P.xy, 0)).rgb;
	float3 A = min(C * 0.25, 1);
	float3 B = pow(A, Power);
	return float4(1 - (1 - A) * (1 - B), exp2(-C.x) + log2(1 + C.y) + sqrt(C.z));
}
)",
		[&Input](int32_t x, int32_t y)
		{
			const float* C = Input.Texel(x, y);
			FColor Result;
			for (int c = 0; c < 3; ++c)
			{
				const double A = std::min(C[c] * 0.25, 1.0);
				Result.C[c] = 1 - (1 - A) * (1 - std::pow(A, double(1.7f)));
			}
			Result.C[3] = std::exp2(-double(C[0])) + std::log2(1 + double(C[1])) + std::sqrt(double(C[2]));
			return Result;
		},
		2e-6,
		[&Input](FShaderHarness& H)
		{
			H.Textures["InputTexture"] = Input;
			H.SetFloats("Power", {1.7f});
		});
}

TEST(ShaderShapes, GaussianOverAUniformCountWithDynamicConstants)
{
	FTestTexture Input = MakeNoise(Width, Height, 6);
	std::vector<float> Offsets;
	std::vector<float> Weights;
	for (int i = 0; i < 8; ++i)
	{
		Offsets.insert(Offsets.end(), {(float(i) - 2) / Width, 0, (float(i) - 1.5f) / Width, 0});
		Weights.insert(Weights.end(), {0.1f * float(i + 1), 0.2f, 0.3f, 1.0f / float(i + 2)});
	}
	ExpectShape(R"(
float4 SampleOffsets[8];
float4 SampleWeights[8];
int SampleCount;
float4 MainPS(float2 UV : TEXCOORD0) : SV_Target0
{
	float4 Sum = 0;
	for (int i = 0; i < SampleCount; ++i)
	{
		Sum += InputTexture.SampleLevel(InputSampler, UV + SampleOffsets[i].xy, 0) * SampleWeights[i];
	}
	return Sum;
}
)",
		[&](int32_t x, int32_t y)
		{
			FColor Sum;
			for (size_t i = 0; i < 5; ++i)
			{
				const FColor Tap = Sample(Input, (x + 0.5) / Width + (double(i) - 2) / Width, (y + 0.5) / Height);
				for (size_t c = 0; c < 4; ++c)
				{
					Sum.C[c] += Tap.C[c] * double(Weights[i * 4 + c]);
				}
			}
			return Sum;
		},
		4e-6,
		[&](FShaderHarness& H)
		{
			H.Textures["InputTexture"] = Input;
			H.SetFloats("SampleOffsets", Offsets);
			H.SetFloats("SampleWeights", Weights);
			H.Constants["SampleCount"] = {5};
		});
}

TEST(ShaderShapes, DoubleLanesGiveWhatDoubleArithmeticGives)
{
	// A difference of nearly equal numbers shows in what arithmetic they were computed.
	FShaderHarness Harness("float A;\nfloat4 MainPS() : SV_Target0 { return (A * A * A - 1.331) * 1e6; }\n", "MainPS",
		EShaderStage::Pixel);
	Harness.SetFloats("A", {1.1f});
	Harness.Targets = {FTestTexture(4, 1)};
	const double Exact = (double(1.1f) * double(1.1f) * double(1.1f) - double(1.331f)) * 1e6;
	Harness.Run(2, 4, 1, 1, true);
	EXPECT_NEAR(Exact, Harness.Targets[0].Texel(1, 0)[0], 1e-6);
	Harness.Run(4, 4, 1);
	EXPECT_GT(std::fabs(Exact - Harness.Targets[0].Texel(1, 0)[0]), 1e-3);
}
