// What a driver is given and what comes back: constants and structured buffers as Direct3D lays them out, discarded
// pixels, components that are not written, typed buffers, samplers; and what is refused. Kernels are the model.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../shader/Compiler/ShaderHarness.h"
#include "VulkanDrivers.h"

#include <functional>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::HasSubstr;

constexpr int32_t Size = 8;

/** By the kernel into the first harness, by each driver into the second; returns what the drivers said. */
void ForEachDriver(const std::string& Text, EShaderStage Stage, const std::function<void(FShaderHarness&)>& Fill,
	const std::function<void(FShaderHarness& Kernel, FShaderHarness& Driver, const std::string& Fault)>& Check)
{
	const std::string Entry = Stage == EShaderStage::Pixel ? "MainPS" : "MainCS";
	FShaderHarness Kernel(Text, Entry, Stage);
	Fill(Kernel);
	Kernel.Run(0, Size, Size);
	for (const FVulkanDriver& One : GetVulkanDrivers())
	{
		if (One.Backend)
		{
			SCOPED_TRACE(One.Backend->GetDeviceName());
			FShaderHarness Driver(Text, Entry, Stage);
			Fill(Driver);
			Driver.Inspect();
			const auto Reflection = std::make_shared<FShaderReflection>(Driver.GetReflection());
			const std::string Fault =
				One.Backend->Run(Driver.Request, Reflection, Driver.GetArgs(), {0, 0, 0, Size, Size, 1});
			Check(Kernel, Driver, Fault);
		}
	}
}

void ExpectSameTargets(FShaderHarness& Kernel, FShaderHarness& Driver, const std::string& Fault)
{
	EXPECT_EQ("", Fault);
	for (int32_t i = 0; i < Size * Size * 4; ++i)
	{
		EXPECT_EQ(Kernel.Targets[0].Texel(0, 0)[i], Driver.Targets[0].Texel(0, 0)[i]) << i;
	}
}

} // namespace

TEST(VulkanRuns, ConstantsLieAsInDirect3D)
{
	const std::string Text = R"(
struct FPair { float A; float3 B; };
float Before;
float3 BehindAFloat;
int Count;
int2 BehindAnInt;
float4x4 Matrix;
float Array[3];
float BehindTheArray;
StructuredBuffer<FPair> Pairs;
void MainPS(float4 P : SV_POSITION, out float4 OutColor : SV_Target0)
{
	const FPair Pair = Pairs[int(P.x)];
	OutColor = mul(float4(BehindAFloat, Before), Matrix) + float4(Count, BehindAnInt, Array[int(P.y) % 3]);
	OutColor += float4(Pair.B, Pair.A) + BehindTheArray;
}
)";
	ForEachDriver(
		Text, EShaderStage::Pixel,
		[](FShaderHarness& H)
		{
			H.SetFloats("Before", {1});
			H.SetFloats("BehindAFloat", {2, 3, 4});
			H.Constants["Count"] = {5};
			H.Constants["BehindAnInt"] = {6, 7};
			std::vector<float> Matrix(16);
			for (size_t i = 0; i < 16; ++i)
			{
				Matrix[i] = float(i * i);
			}
			H.SetFloats("Matrix", Matrix);
			H.SetFloats("Array", {8, 0, 0, 0, 9, 0, 0, 0, 10});
			H.SetFloats("BehindTheArray", {11});
			std::vector<float> Pairs(Size * 4);
			for (size_t i = 0; i < Pairs.size(); ++i)
			{
				Pairs[i] = float(100 * i);
			}
			H.SetFloatBuffer("Pairs", Pairs);
			H.Targets.emplace_back(Size, Size);
		},
		&ExpectSameTargets);
}

TEST(VulkanRuns, DiscardedPixelsAndMissingComponentsAreAsInAKernel)
{
	const std::string Text = R"(
void MainPS(float4 P : SV_POSITION, float4 UV : TEXCOORD0, out float2 OutColor : SV_Target0)
{
	if (int(P.x + P.y) % 3 == 0)
	{
		discard;
	}
	OutColor = P.xy + UV.xy;
}
)";
	ForEachDriver(
		Text, EShaderStage::Pixel,
		[](FShaderHarness& H)
		{
			H.Targets.emplace_back(Size, Size);
			H.Interpolants[0] = {{1, 2, 0, 0}, {0.5, 0, 0, 0}, {0, 0.25, 0, 0}}; // exact on every pixel
			for (int32_t i = 0; i < Size * Size * 4; ++i)
			{
				H.Targets[0].Texel(0, 0)[i] = 7;
			}
		},
		&ExpectSameTargets);
}

TEST(VulkanRuns, TexelsOutsideAreZeroAndSamplersWrapAndClamp)
{
	const std::string Text = R"(
Texture2D<float4> Input;
SamplerState InputSampler;
void MainPS(float4 P : SV_POSITION, out float4 OutColor : SV_Target0)
{
	OutColor = Input.Load(int3(int2(P.xy) - 4, 0)) + 64 * Input.SampleLevel(InputSampler, (P.xy - 2) / 8, 0);
}
)";
	for (const EKernelAddress Address : {EKernelAddress::Wrap, EKernelAddress::Clamp, EKernelAddress::Mirror})
	{
		ForEachDriver(
			Text, EShaderStage::Pixel,
			[Address](FShaderHarness& H)
			{
				H.Sampler = {EKernelFilter::Point, Address, Address, Address, 8, 0, {}};
				H.Textures["Input"] = FTestTexture(Size, Size);
				for (int32_t i = 0; i < Size * Size * 4; ++i)
				{
					H.Textures["Input"].Texel(0, 0)[i] = float(i);
				}
				H.Targets.emplace_back(Size, Size);
			},
			&ExpectSameTargets);
	}
}

TEST(VulkanRuns, BuffersComeBack)
{
	const std::string Text = R"(
Buffer<float4> Typed;
ByteAddressBuffer Bytes;
RWBuffer<uint> Numbers;
RWTexture2D<float> Picture;
[numthreads(8, 8, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID)
{
	const uint I = Id.y * 8 + Id.x;
	Numbers[I] = uint(Typed[I % 4].y) + Bytes.Load(4 * (I % 3));
	Picture[Id.xy] += I;
}
)";
	ForEachDriver(
		Text, EShaderStage::Compute,
		[](FShaderHarness& H)
		{
			std::vector<float> Typed(16);
			for (size_t i = 0; i < Typed.size(); ++i)
			{
				Typed[i] = float(i);
			}
			H.SetFloatBuffer("Typed", Typed);
			H.Buffers["Bytes"] = {100, 200, 300};
			H.Buffers["Numbers"].assign(Size * Size, 0);
			H.Textures["Picture"] = FTestTexture(Size, Size);
			*H.Textures["Picture"].Texel(3, 3) = 0.5f;
		},
		[](FShaderHarness& Kernel, FShaderHarness& Driver, const std::string& Fault)
		{
			EXPECT_EQ("", Fault);
			EXPECT_EQ(Kernel.Buffers["Numbers"], Driver.Buffers["Numbers"]);
			for (int32_t i = 0; i < Size * Size; ++i)
			{
				EXPECT_EQ(*Kernel.Textures["Picture"].Texel(i % Size, i / Size),
					*Driver.Textures["Picture"].Texel(i % Size, i / Size));
			}
		});
}

TEST(VulkanRuns, WhatADriverCannotDoIsSaid)
{
	const std::string Waves = R"(
RWStructuredBuffer<uint> Out;
[numthreads(8, 8, 1)]
void MainCS(uint I : SV_GroupIndex) { Out[I] = WaveActiveSum(I); }
)";
	ForEachDriver(
		Waves, EShaderStage::Compute, [](FShaderHarness& H) { H.Buffers["Out"].assign(64, 0); },
		[](FShaderHarness&, FShaderHarness& Driver, const std::string& Fault)
		{
			EXPECT_THAT(Fault, HasSubstr("and drydock's 32; set r.Drydock.WaveSize to "));
			EXPECT_EQ(std::vector<uint32_t>(64), Driver.Buffers["Out"]); // nothing was written
		});
}
