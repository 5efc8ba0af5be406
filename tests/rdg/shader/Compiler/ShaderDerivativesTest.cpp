// Derivatives of pixel shaders: kernels at every lane count and the interpreter, against plain C++.
#include <gtest/gtest.h>

#include "ShaderForms.h"

#include <array>
#include <cmath>
#include <functional>
#include <random>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

constexpr int32_t Width = 11; // neither even nor a multiple of a pack
constexpr int32_t Height = 7;

using FField = std::function<float(int32_t X, int32_t Y)>; // a value of each pixel, helpers' too

/** ddx, ddy, ddx_fine, ddy_fine of a pixel, as docs/shaders.md states them. */
std::array<float, 4> GetDerivatives(const FField& V, int32_t X, int32_t Y)
{
	const int32_t X0 = X & ~1;
	const int32_t Y0 = Y & ~1;
	return {V(X0 + 1, Y0) - V(X0, Y0), V(X0, Y0 + 1) - V(X0, Y0), V(X0 + 1, Y) - V(X0, Y), V(X, Y0 + 1) - V(X, Y0)};
}

void AddTargets(FShaderHarness& Harness, int Count)
{
	for (int i = 0; i < Count; ++i)
	{
		Harness.Targets.emplace_back(Width, Height);
	}
}

void ExpectColors(
	FShaderHarness& Harness, size_t Target, const std::function<std::array<float, 4>(int32_t X, int32_t Y)>& Expected)
{
	for (int32_t y = 0; y < Height; ++y)
	{
		for (int32_t x = 0; x < Width; ++x)
		{
			const float* const Color = Harness.Targets[Target].Texel(x, y);
			EXPECT_EQ(Expected(x, y), (std::array<float, 4>{Color[0], Color[1], Color[2], Color[3]}))
				<< "target " << Target << ", pixel " << x << ", " << y;
		}
	}
}

const char* const Everything = R"(
void MainPS(float4 SvPosition : SV_POSITION, out float4 Plain : SV_Target0, out float4 Coarse : SV_Target1)
{
	const float V = SvPosition.x * SvPosition.x + SvPosition.y * SvPosition.y * SvPosition.x * 0.5;
	Plain = float4(ddx(V), ddy(V), ddx_fine(V), ddy_fine(V));
	Coarse = float4(ddx_coarse(V), ddy_coarse(V), fwidth(V), fwidth(V * 2));
}
)";

/** The same in C++; every step is exact. */
float GetEverything(int32_t X, int32_t Y)
{
	const float x = float(X) + 0.5f;
	const float y = float(Y) + 0.5f;
	return x * x + y * y * x * 0.5f;
}

void ExpectEverything(FShaderHarness& Harness)
{
	ExpectColors(Harness, 0, [](int32_t X, int32_t Y) { return GetDerivatives(GetEverything, X, Y); });
	ExpectColors(Harness, 1,
		[](int32_t X, int32_t Y)
		{
			const std::array<float, 4> D = GetDerivatives(GetEverything, X, Y);
			const float Sum = std::fabs(D[0]) + std::fabs(D[1]);
			return std::array<float, 4>{D[0], D[1], Sum, 2 * Sum};
		});
}

float GetNoise(int32_t X, int32_t Y, int32_t Channel)
{
	std::mt19937 Random(uint32_t((Y * 64 + X) * 3 + Channel));
	return float(Random() % 256) / 64.0f;
}

} // namespace

TEST(ShaderDerivatives, AreDifferencesInTheQuad)
{
	ForEachPixelForm(
		Everything, Width, Height, [](FShaderHarness& Harness) { AddTargets(Harness, 2); }, ExpectEverything);
}

TEST(ShaderDerivatives, DoNotDependOnHowTheRectIsCut)
{
	for (const int32_t Lanes : GetLaneCounts())
	{
		SCOPED_TRACE(std::to_string(Lanes) + " lanes");
		FShaderHarness Harness(Everything, "MainPS", EShaderStage::Pixel);
		AddTargets(Harness, 2);
		const std::shared_ptr<const FCompiledShader> Shader = Harness.Run(Lanes, 0, 0);
		for (int32_t y = 0; y < Height; y += 3)
		{
			for (int32_t x = 0; x < Width; x += 5)
			{
				Shader->Run(Harness.GetArgs(), {x, y, 0, std::min(x + 5, Width), std::min(y + 3, Height), 1});
			}
		}
		ExpectEverything(Harness);
	}
}

TEST(ShaderDerivatives, AnEdgeDetectMarksWhereTheLuminanceChanges)
{
	const std::string Text = R"(
Texture2D Source;
void MainPS(float4 SvPosition : SV_POSITION, out float4 Color : SV_Target0)
{
	const float Luminance = dot(Source.Load(int3(SvPosition.xy, 0)).rgb, float3(0.25, 0.5, 0.25));
	const float Edge = fwidth(Luminance);
	Color = float4(Edge > 1 ? 1 : 0, Edge, Luminance, 1);
}
)";
	// What lies outside of the texture reads as 0.
	const FField Luminance = [](int32_t X, int32_t Y)
	{
		const bool bInside = X < Width && Y < Height;
		return bInside ? GetNoise(X, Y, 0) * 0.25f + GetNoise(X, Y, 1) * 0.5f + GetNoise(X, Y, 2) * 0.25f : 0.0f;
	};
	ForEachPixelForm(
		Text, Width, Height,
		[](FShaderHarness& Harness)
		{
			AddTargets(Harness, 1);
			FTestTexture& Source = Harness.Textures["Source"] = FTestTexture(Width, Height);
			for (int32_t i = 0; i < Width * Height * 3; ++i)
			{
				Source.Texel(i / 3 % Width, i / 3 / Width)[i % 3] = GetNoise(i / 3 % Width, i / 3 / Width, i % 3);
			}
		},
		[&](FShaderHarness& Harness)
		{
			ExpectColors(Harness, 0,
				[&](int32_t X, int32_t Y)
				{
					const std::array<float, 4> D = GetDerivatives(Luminance, X, Y);
					const float Edge = std::fabs(D[0]) + std::fabs(D[1]);
					return std::array<float, 4>{Edge > 1 ? 1.0f : 0.0f, Edge, Luminance(X, Y), 1};
				});
		});
}

TEST(ShaderDerivatives, OfInterpolatedInputsAreTheirSteps)
{
	const std::string Text = R"(
void MainPS(float4 UV : TEXCOORD0, out float4 Color : SV_Target0)
{
	Color = float4(ddx(UV.xy), ddy(UV.zw));
}
)";
	ForEachPixelForm(
		Text, Width, Height,
		[](FShaderHarness& Harness)
		{
			AddTargets(Harness, 1);
			Harness.Interpolants[0] = {{1, 2, 3, 4}, {0.25, 0.5, 1, 2}, {4, 8, 16, 0.125}};
		},
		[](FShaderHarness& Harness) {
			ExpectColors(Harness, 0, [](int32_t, int32_t) { return std::array<float, 4>{0.25f, 0.5f, 16, 0.125f}; });
		});
}

TEST(ShaderDerivatives, WhatDoesNotRunMakesNoDifference)
{
	const std::string Text = R"(
void MainPS(float4 SvPosition : SV_POSITION, out float4 Color : SV_Target0)
{
	const float V = SvPosition.x * 3 + SvPosition.y * 5;
	Color = -1;
	if (SvPosition.x > 1 || SvPosition.y > 1)
	{
		Color = float4(ddx(V), ddy(V), ddx_fine(V), ddy_fine(V));
	}
}
)";
	ForEachPixelForm(
		Text, Width, Height, [](FShaderHarness& Harness) { AddTargets(Harness, 1); },
		[](FShaderHarness& Harness)
		{
			ExpectColors(Harness, 0,
				[](int32_t X, int32_t Y) -> std::array<float, 4>
				{
					if (X > 1 || Y > 1)
					{
						return {3, 5, 3, 5};
					}
					// The first pixel does not run: nobody's differences from it count.
					return X == 0 && Y == 0 ? std::array<float, 4>{-1, -1, -1, -1}
											: std::array<float, 4>{0, 0, Y == 1 ? 3.0f : 0.0f, X == 1 ? 5.0f : 0.0f};
				});
		});
}

TEST(ShaderDerivatives, DiscardedPixelsGoOnForTheirNeighbours)
{
	const std::string Text = R"(
RWStructuredBuffer<uint> Count;
void MainPS(float4 SvPosition : SV_POSITION, out float4 Color : SV_Target0)
{
	float V = SvPosition.x * 3 + SvPosition.y * 5;
	if (uint(SvPosition.x) % 2 == 0)
	{
		V = 100;
		discard;
	}
	clip(SvPosition.y - 1);
	InterlockedAdd(Count[0], 1);
	Color = float4(ddx(V), ddy(V), ddx_fine(V), ddy_fine(V));
}
)";
	ForEachPixelForm(
		Text, Width, Height,
		[](FShaderHarness& Harness)
		{
			AddTargets(Harness, 1);
			Harness.Buffers["Count"].assign(1, 0);
		},
		[](FShaderHarness& Harness)
		{
			uint32_t Drawn = 0;
			ExpectColors(Harness, 0,
				[&](int32_t X, int32_t Y)
				{
					const bool bDrawn = X % 2 == 1 && Y > 0;
					Drawn += bDrawn;
					return bDrawn ? std::array<float, 4>{3, 5, 3, 5} : std::array<float, 4>{};
				});
			EXPECT_EQ(Drawn, Harness.Buffers["Count"][0]);
		});
}

TEST(ShaderDerivatives, QuadsReadEachOther)
{
	const std::string Text = R"(
void MainPS(float4 SvPosition : SV_POSITION, out float4 Color : SV_Target0)
{
	const float V = floor(SvPosition.y) * 100 + floor(SvPosition.x);
	Color = float4(QuadReadAcrossX(V), QuadReadAcrossY(V), QuadReadAcrossDiagonal(V), QuadReadLaneAt(V, 1));
}
)";
	const FField V = [](int32_t X, int32_t Y)
	{
		return float(Y * 100 + X);
	};
	ForEachPixelForm(
		Text, Width, Height, [](FShaderHarness& Harness) { AddTargets(Harness, 1); },
		[&](FShaderHarness& Harness)
		{
			ExpectColors(Harness, 0,
				[&](int32_t X, int32_t Y) {
					return std::array<float, 4>{V(X ^ 1, Y), V(X, Y ^ 1), V(X ^ 1, Y ^ 1), V(X | 1, Y & ~1)};
				});
		});
}
