// Levels that drivers choose for samples of cubes and volumes, beside a computation in double, and numbers of 64 bits
// that they change atomically.
#include <gtest/gtest.h>

#include "../shader/Compiler/ImplicitLevels.h"
#include "VulkanDrivers.h"

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

constexpr int32_t NumScenes = 24;

/** The least and the greatest level that a driver may take for a step: Vulkan lets it take anything from the longest
 *  axis to the sum of all for a length (15.6.7, scale factor), at any pixel of the quad. A level of float is off by
 *  little: 1/64 is far more. */
struct FLevelRange
{
	double Low = 1e9;
	double High = -1e9;

	void Add(const FLevelScene::FStep& X, const FLevelScene::FStep& Y)
	{
		const auto Longest = [](const FLevelScene::FStep& Step)
		{
			return std::max({std::abs(Step[0]), std::abs(Step[1]), std::abs(Step[2])});
		};
		const auto Sum = [](const FLevelScene::FStep& Step)
		{
			return std::abs(Step[0]) + std::abs(Step[1]) + std::abs(Step[2]);
		};
		constexpr double Off = 1.0 / 64;
		Low = std::min(Low, std::log2(std::max(Longest(X), Longest(Y))) - Off);
		High = std::max(High, std::log2(std::max(Sum(X), Sum(Y))) + Off);
	}

	/** The mip that all of these take; -1: rounding decides. */
	int GetMip(double Bias, double Clamp) const
	{
		const auto Round = [&](double Level)
		{
			return int(std::floor(std::clamp(std::max(Level + Bias, Clamp), 0.0, FLevelScene::NumMips - 1.0) + 0.5));
		};
		return Round(Low) == Round(High) ? Round(Low) : -1;
	}
};

/** Of the flat texture, the cubes, their array and the volume in the quad at (X, Y). */
std::array<FLevelRange, 4> GetRanges(const FLevelScene& Scene, int32_t X, int32_t Y)
{
	std::array<FLevelRange, 4> Ranges;
	for (int32_t i = 0; i < 4; ++i)
	{
		const Tests::FPoint At = Scene.GetAt(X / 2 * 2 + i % 2, Y / 2 * 2 + i / 2);
		Ranges[0].Add(Scene.GetFlatStep(Scene.AlongX), Scene.GetFlatStep(Scene.AlongY));
		Ranges[1].Add(Scene.GetCubeStep(Scene.AlongX, At), Scene.GetCubeStep(Scene.AlongY, At));
		Ranges[3].Add(Scene.GetVolumeStep(Scene.AlongX), Scene.GetVolumeStep(Scene.AlongY));
	}
	Ranges[2] = Ranges[1];
	return Ranges;
}

/** All pixels of a quad look at one face: what lies between two drivers find each in their own way. */
bool HasOneFace(const FLevelScene& Scene, int32_t X, int32_t Y)
{
	std::array<int, 4> Faces;
	for (int32_t i = 0; i < 4; ++i)
	{
		Faces[size_t(i)] = Tests::FindFace(Scene.GetAt(X / 2 * 2 + i % 2, Y / 2 * 2 + i / 2)).Face;
	}
	return std::count(Faces.begin(), Faces.end(), Faces[0]) == 4;
}

void CheckScenes(bool bClamp)
{
	FLevelTextures Textures;
	int NumDrivers = 0;
	for (const FVulkanDriver& Driver : GetVulkanDrivers())
	{
		int Compared = 0;
		for (uint32_t Seed = 0; Driver.Backend && Seed < NumScenes; ++Seed)
		{
			SCOPED_TRACE(Driver.Backend->GetDeviceName() + ", scene " + std::to_string(Seed));
			const FLevelScene Scene(Seed);
			FShaderHarness Harness(MakeLevelShader(bClamp, false), "MainPS", EShaderStage::Pixel);
			Harness.Request.bQuads = true;
			Harness.Sampler = {EKernelFilter::Bilinear, EKernelAddress::Wrap, EKernelAddress::Wrap,
				EKernelAddress::Wrap, 8, 0, {}, EKernelCompare::Less};
			for (int i = 0; i < 2; ++i)
			{
				Harness.Targets.emplace_back(FLevelScene::Width, FLevelScene::Height);
			}
			Textures.Fill(Harness);
			Scene.Fill(Harness);
			Harness.Inspect();
			const auto Reflection = std::make_shared<FShaderReflection>(Harness.GetReflection());
			const std::string Fault = Driver.Backend->Run(
				Harness.Request, Reflection, Harness.GetArgs(), {0, 0, 0, FLevelScene::Width, FLevelScene::Height, 1});
			if (bClamp && Fault.find("capability 42") != std::string::npos)
			{
				break; // the driver does not clamp levels
			}
			ASSERT_EQ("", Fault);
			for (int32_t i = 0; i < FLevelScene::Width * FLevelScene::Height; ++i)
			{
				const int32_t X = i % FLevelScene::Width;
				const int32_t Y = i / FLevelScene::Width;
				const std::array<FLevelRange, 4> Ranges = GetRanges(Scene, X, Y);
				const auto Check = [&](size_t Target, size_t Channel, const FLevelRange& Range, double Bias)
				{
					const int Mip = Range.GetMip(Bias, bClamp ? double(Scene.Clamp) : -1e9);
					if (Mip >= 0)
					{
						// Weights of a filter sum up to 1 but for their rounding.
						EXPECT_NEAR(Mip, Harness.Targets[Target].Texel(X, Y)[Channel], 1e-5)
							<< X << ", " << Y << ", target " << Target << ", channel " << Channel;
						++Compared;
					}
				};
				const bool bFace = HasOneFace(Scene, X, Y);
				for (size_t c = 0; c < 4; ++c)
				{
					if (bFace || c == 0 || c == 3)
					{
						Check(0, c, Ranges[c], 0);
						Check(1, c, Ranges[c], double(Scene.Bias));
					}
				}
			}
		}
		NumDrivers += Compared > 0;
		EXPECT_TRUE(Compared == 0 || Compared > 2000);
	}
	if (NumDrivers == 0)
	{
		GTEST_SKIP() << "no driver is here that does this";
	}
}

} // namespace

TEST(VulkanLevels, DriversChooseTheSameMips)
{
	CheckScenes(false);
}

TEST(VulkanLevels, DriversClampThemAlike)
{
	CheckScenes(true);
}

TEST(VulkanLevels, InterlockedOfSixtyFourBits)
{
	const std::string Text = R"(
StructuredBuffer<uint64_t> In;
RWStructuredBuffer<uint64_t> Sums;
RWStructuredBuffer<int64_t> Bounds;
groupshared uint64_t Shared;
[numthreads(32, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID, uint I : SV_GroupIndex)
{
	const uint64_t V = In[Id.x];
	if (I == 0)
	{
		Shared = 0;
	}
	GroupMemoryBarrierWithGroupSync();
	InterlockedAdd(Shared, V);
	GroupMemoryBarrierWithGroupSync();
	if (I == 0)
	{
		InterlockedAdd(Sums[0], Shared);
	}
	InterlockedXor(Sums[1], V);
	InterlockedMin(Bounds[0], (int64_t)V);
	InterlockedMax(Bounds[1], (int64_t)V);
}
)";
	Tests::FSampleRandom Random(7);
	std::vector<uint32_t> In(128);
	uint64_t Sum = 0, Bits = 0;
	int64_t Least = std::numeric_limits<int64_t>::max(), Greatest = std::numeric_limits<int64_t>::min();
	for (size_t i = 0; i < 64; ++i)
	{
		const uint64_t V =
			uint64_t(uint32_t(Random.Int(INT32_MIN, INT32_MAX))) << 32 | uint32_t(Random.Int(0, INT32_MAX));
		std::memcpy(&In[i * 2], &V, 8);
		Sum += V;
		Bits ^= V;
		Least = std::min(Least, int64_t(V));
		Greatest = std::max(Greatest, int64_t(V));
	}
	for (const FVulkanDriver& Driver : GetVulkanDrivers())
	{
		if (!Driver.Backend)
		{
			continue;
		}
		SCOPED_TRACE(Driver.Backend->GetDeviceName());
		FShaderHarness Harness(Text, "MainCS", EShaderStage::Compute);
		Harness.Buffers["In"] = In;
		Harness.Buffers["Sums"].assign(4, 0);
		Harness.Buffers["Bounds"].assign(4, 0);
		Harness.Inspect();
		const auto Reflection = std::make_shared<FShaderReflection>(Harness.GetReflection());
		const std::string Fault =
			Driver.Backend->Run(Harness.Request, Reflection, Harness.GetArgs(), {0, 0, 0, 64, 1, 1});
		if (!Fault.empty())
		{
			EXPECT_NE(std::string::npos, Fault.find("capability 11")) << Fault; // SwiftShader has no int64_t
			continue;
		}
		uint64_t Seen[4];
		std::memcpy(Seen, Harness.Buffers["Sums"].data(), 16);
		std::memcpy(Seen + 2, Harness.Buffers["Bounds"].data(), 16);
		EXPECT_EQ(Sum, Seen[0]);
		EXPECT_EQ(Bits, Seen[1]);
		EXPECT_EQ(std::min<int64_t>(Least, 0), int64_t(Seen[2]));
		EXPECT_EQ(std::max<int64_t>(Greatest, 0), int64_t(Seen[3]));
	}
}
