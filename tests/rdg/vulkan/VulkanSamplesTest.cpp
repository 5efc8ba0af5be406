// Shaders whose threads work together: kernels against plain C++ and against the Vulkan drivers that run on the CPU.
#include <gtest/gtest.h>

#include "../shader/Compiler/ShaderHarness.h"
#include "ShaderDirectories.h"
#include "VulkanDrivers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numeric>
#include <random>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

constexpr int32_t SizeX = 150; // not a multiple of a group
constexpr int32_t SizeY = 40;

FShaderHarness MakeSample(const std::string& Entry)
{
	AddShaderDirectory("/Samples", DRYDOCK_TEST_SOURCE_DIR "/tests/Shaders");
	FShaderHarness Harness("", Entry, Entry.ends_with("PS") ? EShaderStage::Pixel : EShaderStage::Compute);
	Harness.Request.GeneratedFiles.clear();
	Harness.Request.VirtualPath = "/Samples/Samples.usf";
	return Harness;
}

/** By kernels of every lane count, then by each driver. */
void ForEachMaker(const std::string& Entry, int32_t X, int32_t Y, const std::function<void(FShaderHarness&)>& Fill,
	const std::function<void(FShaderHarness&)>& Check)
{
	for (const int32_t Lanes : GetLaneCounts())
	{
		SCOPED_TRACE(Entry + ", " + std::to_string(Lanes) + " lanes");
		FShaderHarness Harness = MakeSample(Entry);
		Fill(Harness);
		Harness.Run(Lanes, X, Y);
		Check(Harness);
	}
	for (const FVulkanDriver& Driver : GetVulkanDrivers())
	{
		if (!Driver.Backend)
		{
			continue;
		}
		SCOPED_TRACE(Entry + ", " + Driver.Backend->GetDeviceName());
		FShaderHarness Harness = MakeSample(Entry);
		Fill(Harness);
		Harness.WaveSize = Driver.Backend->GetWaveSize();
		Harness.Request.Lanes.WaveSize = Harness.WaveSize;
		Harness.Inspect();
		const auto Kernel = std::make_shared<FShaderReflection>(Harness.GetReflection());
		EXPECT_EQ("", Driver.Backend->Run(Harness.Request, Kernel, Harness.GetArgs(), {0, 0, 0, X, Y, 1}));
		Check(Harness);
	}
}

FTestTexture DrawPicture(uint32_t Seed)
{
	std::mt19937 Random(Seed);
	std::uniform_real_distribution<float> Value(0.0f, 4.0f);
	FTestTexture Picture(SizeX, SizeY);
	for (int32_t i = 0; i < SizeX * SizeY * 4; ++i)
	{
		Picture.Texel(0, 0)[i] = Value(Random);
	}
	return Picture;
}

/** Which neighbours a derivative is the difference of. Source: Vulkan specification, chapter "Shaders", "Derivative
 * Operations": OpDPdx and OpDPdy, of which OpFwidth is made, are fine or coarse as the implementation likes; fine ones
 * are of the pixel's own row and column, coarse ones may be of one row and one column for all pixels of the quad. */
struct FDerivativeForm
{
	std::string Name;
	bool bFine = false;
	int32_t Row = 0; // of the quad, where it is coarse
	int32_t Column = 0;
};

const FDerivativeForm GDerivativeForms[] = {{"fine", true}, {"coarse, upper row, left column", false, 0, 0},
	{"coarse, upper row, right column", false, 0, 1}, {"coarse, lower row, left column", false, 1, 0},
	{"coarse, lower row, right column", false, 1, 1}};

using FField = std::function<float(int32_t X, int32_t Y)>;

float GetWidth(const FField& Field, int32_t X, int32_t Y, const FDerivativeForm& Form)
{
	const int32_t Left = X & ~1;
	const int32_t Top = Y & ~1;
	const int32_t Row = Form.bFine ? Y : Top + Form.Row;
	const int32_t Column = Form.bFine ? X : Left + Form.Column;
	return std::fabs(Field(Left + 1, Row) - Field(Left, Row)) + std::fabs(Field(Column, Top + 1) - Field(Column, Top));
}

void SetSize(FShaderHarness& Harness)
{
	Harness.Constants["Size"] = {uint32_t(SizeX), uint32_t(SizeY)};
}

} // namespace

TEST(VulkanSamples, DriversAreHere)
{
	std::string Missing;
	for (const FVulkanDriver& Driver : GetVulkanDrivers())
	{
		Missing += Driver.Backend ? "" : Driver.Fault + "; ";
	}
	if (!Missing.empty())
	{
		GTEST_SKIP() << Missing << "shaders are not compared with it";
	}
	EXPECT_EQ(0u, GetVulkanDrivers()[0].Backend->GetDeviceName().find("llvmpipe"));
	EXPECT_EQ(0u, GetVulkanDrivers()[1].Backend->GetDeviceName().find("SwiftShader"));
}

TEST(VulkanSamples, AGaussianByThreadGroupMemory)
{
	FTestTexture Picture = DrawPicture(1);
	std::vector<float> Weights(12);
	for (size_t k = 0; k < 9; ++k)
	{
		Weights[k] = float(std::exp(-double(k * k) / 18.0) / 7.5);
	}
	ForEachMaker(
		"GaussianCS", (SizeX + 63) / 64 * 64, SizeY,
		[&](FShaderHarness& H)
		{
			H.Textures["Input"] = Picture;
			H.Textures["Output"] = FTestTexture(SizeX, SizeY);
			H.SetFloats("Weights", Weights);
			SetSize(H);
		},
		[&](FShaderHarness& H)
		{
			for (int32_t i = 0; i < SizeX * SizeY * 4; ++i)
			{
				const int32_t X = i / 4 % SizeX;
				const int32_t Y = i / 4 / SizeX;
				double Sum = 0;
				for (int32_t k = -8; k <= 8; ++k)
				{
					Sum += double(Picture.Texel(std::clamp(X + k, 0, SizeX - 1), Y)[i % 4]) *
						   double(Weights[size_t(std::abs(k))]);
				}
				// 17 products and sums below 4, each rounded once to 24 bits.
				ASSERT_NEAR(Sum, H.Textures["Output"].Texel(0, 0)[i], 17 * 4 * 0x1p-23) << X << ", " << Y;
			}
		});
}

TEST(VulkanSamples, AHistogramByAtomics)
{
	FTestTexture Picture = DrawPicture(2);
	std::vector<uint32_t> Expected(64);
	for (int32_t i = 0; i < SizeX * SizeY; ++i)
	{
		const float* const Texel = Picture.Texel(i % SizeX, i / SizeX);
		++Expected[std::min<size_t>(size_t(std::max({Texel[0], Texel[1], Texel[2]}) * 16.0f), 63)];
	}
	ForEachMaker(
		"HistogramCS", (SizeX + 15) / 16 * 16, (SizeY + 15) / 16 * 16,
		[&](FShaderHarness& H)
		{
			H.Textures["Input"] = Picture;
			H.Buffers["Counts"].assign(64, 0);
			SetSize(H);
		},
		[&](FShaderHarness& H) { EXPECT_EQ(Expected, H.Buffers["Counts"]); });
}

TEST(VulkanSamples, ABitonicSort)
{
	std::mt19937 Random(3);
	std::vector<uint32_t> Numbers(128 * 5);
	std::generate(Numbers.begin(), Numbers.end(), [&Random] { return uint32_t(Random()); });
	std::vector<uint32_t> Expected = Numbers;
	for (auto Group = Expected.begin(); Group != Expected.end(); Group += 128)
	{
		std::sort(Group, Group + 128);
	}
	ForEachMaker(
		"BitonicSortCS", int32_t(Numbers.size()), 1, [&](FShaderHarness& H) { H.Buffers["Numbers"] = Numbers; },
		[&](FShaderHarness& H) { EXPECT_EQ(Expected, H.Buffers["Numbers"]); });
}

TEST(VulkanSamples, APrefixSumByWaves)
{
	std::mt19937 Random(4);
	std::vector<uint32_t> Numbers(128 * 5);
	std::generate(Numbers.begin(), Numbers.end(), [&Random] { return uint32_t(Random()) % 1000; });
	std::vector<uint32_t> Expected(Numbers.size());
	for (size_t Group = 0; Group < Numbers.size(); Group += 128)
	{
		std::exclusive_scan(Numbers.begin() + std::ptrdiff_t(Group), Numbers.begin() + std::ptrdiff_t(Group + 128),
			Expected.begin() + std::ptrdiff_t(Group), 0u);
	}
	ForEachMaker(
		"PrefixSumCS", int32_t(Numbers.size()), 1, [&](FShaderHarness& H) { H.Buffers["Numbers"] = Numbers; },
		[&](FShaderHarness& H) { EXPECT_EQ(Expected, H.Buffers["Numbers"]); });
}

TEST(VulkanSamples, BrightPixelsAppendThemselves)
{
	FTestTexture Picture = DrawPicture(5);
	std::vector<std::vector<float>> Expected;
	for (int32_t i = 0; i < SizeX * SizeY; ++i)
	{
		const float* const Texel = Picture.Texel(i % SizeX, i / SizeX);
		const float Brightest = std::max({Texel[0], Texel[1], Texel[2]});
		if (Brightest > 3.5f)
		{
			Expected.push_back({float(i % SizeX), float(i / SizeX), Brightest});
		}
	}
	std::sort(Expected.begin(), Expected.end());
	ForEachMaker(
		"BrightPixelsCS", (SizeX + 15) / 16 * 16, (SizeY + 15) / 16 * 16,
		[&](FShaderHarness& H)
		{
			H.Textures["Input"] = Picture;
			H.Buffers["BrightPixels"].assign(size_t(SizeX) * SizeY * 3, 0);
			H.Buffers["BrightPixels@count"] = {0};
			SetSize(H);
		},
		[&](FShaderHarness& H)
		{
			std::vector<std::vector<float>> Found;
			for (size_t i = 0; i < H.Buffers["BrightPixels@count"][0]; ++i)
			{
				Found.push_back({H.BufferFloat("BrightPixels", i * 3), H.BufferFloat("BrightPixels", i * 3 + 1),
					H.BufferFloat("BrightPixels", i * 3 + 2)});
			}
			std::sort(Found.begin(), Found.end()); // drivers append in an order of their own
			EXPECT_EQ(Expected, Found);
		});
}

TEST(VulkanSamples, CountersAreReadAndWrittenBack)
{
	std::vector<uint32_t> Numbers(200);
	std::iota(Numbers.begin(), Numbers.end(), 1000u);
	ForEachMaker(
		"TakeNumbersCS", 96, 1,
		[&](FShaderHarness& H)
		{
			H.Buffers["FreeNumbers"] = Numbers;
			H.Buffers["FreeNumbers@count"] = {150};
			H.Buffers["UsedNumbers"].assign(200, 0);
			H.Buffers["UsedNumbers@count"] = {4};
			H.Buffers["Visitors"].assign(96, 0);
			H.Buffers["Visitors@count"] = {0};
		},
		[&](FShaderHarness& H)
		{
			EXPECT_EQ(54u, H.Buffers["FreeNumbers@count"][0]);
			EXPECT_EQ(100u, H.Buffers["UsedNumbers@count"][0]);
			EXPECT_EQ(96u, H.Buffers["Visitors@count"][0]);
			std::vector<uint32_t>& Used = H.Buffers["UsedNumbers"];
			std::sort(Used.begin() + 4, Used.begin() + 100);
			EXPECT_TRUE(std::equal(Used.begin() + 4, Used.begin() + 100, Numbers.begin() + 54));
			EXPECT_EQ(0u, Used[3] + Used[100]);
			std::vector<uint32_t>& Visitors = H.Buffers["Visitors"];
			std::sort(Visitors.begin(), Visitors.end());
			for (uint32_t i = 0; i < 96; ++i)
			{
				EXPECT_EQ(i, Visitors[i]);
			}
		});
}

TEST(VulkanSamples, EdgesByDerivatives)
{
	// Odd sizes, so that the last quads have pixels that are not drawn and read 0 outside of the picture. 64ths are
	// exact in every step, whatever its order.
	constexpr int32_t Width = 61;
	constexpr int32_t Height = 35;
	std::mt19937 Random(5);
	FTestTexture Picture(Width, Height);
	for (int32_t i = 0; i < Width * Height * 4; ++i)
	{
		Picture.Texel(0, 0)[i] = float(Random() % 256) / 64.0f;
	}
	const FField Luminance = [&Picture](int32_t X, int32_t Y)
	{
		if (X >= Width || Y >= Height)
		{
			return 0.0f;
		}
		const float* const Texel = Picture.Texel(X, Y);
		return Texel[0] * 0.25f + Texel[1] * 0.5f + Texel[2] * 0.25f;
	};
	const auto IsOf = [&Luminance](const FDerivativeForm& Form, FShaderHarness& H)
	{
		for (int32_t i = 0; i < Width * Height; ++i)
		{
			const float Edge = GetWidth(Luminance, i % Width, i / Width, Form);
			const float Expected[4] = {Edge > 1 ? 1.0f : 0.0f, Edge, Luminance(i % Width, i / Width), 1};
			if (!std::equal(Expected, Expected + 4, H.Targets[0].Texel(i % Width, i / Width)))
			{
				return false;
			}
		}
		return true;
	};
	std::vector<std::string> Forms; // by maker
	ForEachMaker(
		"EdgesPS", Width, Height,
		[&](FShaderHarness& H)
		{
			H.Textures["Input"] = Picture;
			H.Targets.emplace_back(Width, Height);
		},
		[&](FShaderHarness& H)
		{
			const auto Form = std::find_if(std::begin(GDerivativeForms), std::end(GDerivativeForms),
				[&](const FDerivativeForm& One) { return IsOf(One, H); });
			ASSERT_NE(std::end(GDerivativeForms), Form) << "no form is that of all pixels";
			Forms.push_back(Form->Name);
		});
	size_t Maker = 0;
	for (; Maker < std::min(GetLaneCounts().size(), Forms.size()); ++Maker)
	{
		EXPECT_EQ("coarse, upper row, left column", Forms[Maker]); // as docs/shaders.md says
	}
	for (const FVulkanDriver& Driver : GetVulkanDrivers())
	{
		if (Driver.Backend && Maker < Forms.size())
		{
			std::printf("derivatives of %s: %s\n", Driver.Name.c_str(), Forms[Maker++].c_str());
		}
	}
}
