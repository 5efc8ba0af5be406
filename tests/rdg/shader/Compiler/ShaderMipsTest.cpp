// Samples of pixel shaders that choose their mips: kernels at every lane count and the interpreter, against the formula
// in docs/shaders.md.
#include <gtest/gtest.h>

#include "ShaderForms.h"

#include <cmath>
#include <functional>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

constexpr int32_t Width = 11;
constexpr int32_t Height = 7;
constexpr int32_t NumMips = 6;

/** 32 x 32 texels; each mip holds its own number, and in green and blue the texel's place. */
FTestTexture MakeNumberedMips()
{
	FTestTexture Texture(32, 32, false, NumMips);
	for (int32_t Mip = 0; Mip < NumMips; ++Mip)
	{
		const int32_t Size = FTestTexture::GetSize(32, Mip);
		for (int32_t i = 0; i < Size * Size; ++i)
		{
			float* const Texel = Texture.Texel(i % Size, i / Size, Mip);
			Texel[0] = float(Mip);
			Texel[1] = float(i % Size);
			Texel[2] = float(i / Size);
		}
	}
	return Texture;
}

/** Runs a body that has UV, steps of which are Scale texels along each pixel, and writes Color. */
void ForEachScale(const std::string& Body, const std::function<void(FKernelSampler&)>& SetSampler,
	const std::function<void(float Scale, const float* Color)>& Check, const std::vector<float>& Scales)
{
	const std::string Text = R"(
Texture2D Source;
SamplerState SourceSampler;
float Scale;
void MainPS(float4 SvPosition : SV_POSITION, out float4 Color : SV_Target0)
{
	const float2 UV = SvPosition.xy * float2(Scale, Scale * 0.5) / 32;
	)" + Body + "\n}\n";
	for (const float Scale : Scales)
	{
		SCOPED_TRACE("scale " + std::to_string(Scale));
		ForEachPixelForm(
			Text, Width, Height,
			[&](FShaderHarness& Harness)
			{
				Harness.Request.bQuads = true;
				Harness.Targets.emplace_back(Width, Height);
				Harness.Textures["Source"] = MakeNumberedMips();
				Harness.SetFloats("Scale", {Scale});
				Harness.Sampler.Filter = EKernelFilter::Trilinear;
				Harness.Sampler.AddressU = Harness.Sampler.AddressV = EKernelAddress::Wrap;
				SetSampler(Harness.Sampler);
			},
			[&](FShaderHarness& Harness)
			{
				for (int32_t i = 0; i < Width * Height; ++i)
				{
					Check(Scale, Harness.Targets[0].Texel(i % Width, i / Width));
				}
			});
	}
}

void Keep(FKernelSampler&) {}

const char* const Sample = "Color = Source.Sample(SourceSampler, UV);";

} // namespace

TEST(ShaderMips, ALevelIsTheLogarithmOfTheLongerStep)
{
	ForEachScale(Sample, Keep,
		[](float Scale, const float* Color)
		{
			const double Level = std::clamp(std::log2(double(Scale)), 0.0, double(NumMips - 1));
			EXPECT_NEAR(Level, double(Color[0]), 1.0 / 256); // of Direct3D's eight bits between two mips
		},
		{0.25f, 1, 1.5f, 3, 4, 9, 100});
}

TEST(ShaderMips, WithoutATrilinearFilterTheNearestMipIsTaken)
{
	ForEachScale(
		Sample, [](FKernelSampler& Sampler) { Sampler.Filter = EKernelFilter::Bilinear; },
		[](float Scale, const float* Color) { EXPECT_EQ(Scale < 2.8 ? 1.0f : 2.0f, Color[0]); }, {2, 2.75f, 2.9f, 4});
}

TEST(ShaderMips, BiasAndBoundsMoveTheLevel)
{
	const auto Expect = [](float Level)
	{
		return [Level](float, const float* Color)
		{
			EXPECT_EQ(Level, Color[0]);
		};
	};
	ForEachScale("Color = Source.SampleBias(SourceSampler, UV, 1.5);", Keep, Expect(2.5f), {2});
	ForEachScale(Sample, [](FKernelSampler& Sampler) { Sampler.MipBias = -0.5f; }, Expect(0.5f), {2});
	ForEachScale(Sample, [](FKernelSampler& Sampler) { Sampler.MinLevel = 1.75f; }, Expect(1.75f), {2});
	ForEachScale(Sample, [](FKernelSampler& Sampler) { Sampler.MaxLevel = 2.25f; }, Expect(2.25f), {16});
}

TEST(ShaderMips, TheLevelCanBeAskedFor)
{
	const char* const Body = "Color = float4(Source.CalculateLevelOfDetail(SourceSampler, UV), "
							 "Source.CalculateLevelOfDetailUnclamped(SourceSampler, UV), 0, 0);";
	ForEachScale(Body, Keep,
		[](float Scale, const float* Color)
		{
			EXPECT_EQ(Scale == 0.25f ? 0.0f : Scale == 8 ? 3.0f : 5.0f, Color[0]);
			EXPECT_EQ(std::log2(Scale), Color[1]);
		},
		{0.25f, 8, 128});
}

TEST(ShaderMips, AnOffsetIsInTexelsOfItsMip)
{
	// Point samples of mip 2, whose 8 texels are 4 pixels apart.
	const auto Point = [](FKernelSampler& Sampler)
	{
		Sampler.Filter = EKernelFilter::Point;
	};
	ForEachScale("Color = Source.Sample(SourceSampler, UV, int2(3, -2)) - Source.Sample(SourceSampler, UV) + "
				 "float4(0, 8, 8, 0);",
		Point,
		[](float, const float* Color)
		{
			EXPECT_EQ(0.0f, Color[0]);
			EXPECT_EQ(3, int(Color[1]) % 8);
			EXPECT_EQ(6, int(Color[2]) % 8);
		},
		{4});
}

TEST(ShaderMips, WithoutDerivativesInTheShaderItsReflectionNamesWhatMayNeedThem)
{
	FShaderHarness Harness("Texture2D A;\nTexture2D B;\nSamplerState S;\n"
						   "float4 MainPS(float4 P : SV_POSITION) : SV_Target0\n{\n"
						   "\treturn A.Sample(S, P.xy) + B.SampleLevel(S, P.xy, 0);\n}\n",
		"MainPS", EShaderStage::Pixel);
	const FShaderReflection Plain = ReflectShader(Harness.Request);
	EXPECT_FALSE(Plain.bQuads);
	ASSERT_EQ(2u, Plain.Textures.size());
	EXPECT_EQ(Plain.Textures[0].Name == "A", Plain.Textures[0].bImplicitLevel);
	EXPECT_EQ(Plain.Textures[1].Name == "A", Plain.Textures[1].bImplicitLevel);
}
