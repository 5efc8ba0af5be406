// Levels that samples of cubes, arrays of cubes, volumes and comparisons choose, with a bias and with a clamp of their
// own: kernels at every lane count, the interpreter and the shader as it is looked into, against double.
#include <gtest/gtest.h>

#include "ImplicitLevels.h"
#include "ShaderForms.h"

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

constexpr int32_t NumScenes = 24;

/** Eight bits between two mips, the nearest taken; and what float loses: coordinates below 16 have steps of at least
 *  2^-10 off by 2^-20 at most, a thousandth of them, so their logarithm by 2^-9. */
constexpr double Tolerance = 1.0 / 512 + 1.0 / 512;

/** What mips that hold 0 and 1 by turns give at a level. */
double GetCompared(double Level)
{
	const double Odd = std::fmod(Level, 2);
	return Odd < 1 ? Odd : 2 - Odd;
}

/** Of the flat texture, the cubes, the array of cubes and the volume at a pixel. */
std::array<double, 4> GetLevels(const FLevelScene& Scene, int32_t X, int32_t Y)
{
	const Tests::FPoint At = Scene.GetAt(X, Y);
	const double Cube = Scene.GetLevel(Scene.GetCubeStep(Scene.AlongX, At), Scene.GetCubeStep(Scene.AlongY, At));
	return {Scene.GetLevel(Scene.GetFlatStep(Scene.AlongX), Scene.GetFlatStep(Scene.AlongY)), Cube, Cube,
		Scene.GetLevel(Scene.GetVolumeStep(Scene.AlongX), Scene.GetVolumeStep(Scene.AlongY))};
}

/** A direction between two faces may belong to either. */
bool IsOnEdge(const Tests::FPoint& At)
{
	std::array<double, 3> Sizes = {std::abs(At[0]), std::abs(At[1]), std::abs(At[2])};
	std::sort(Sizes.begin(), Sizes.end());
	return Sizes[2] - Sizes[1] < 1e-5 * Sizes[2] || Sizes[2] < 0.02;
}

void CheckScenes(bool bClamp)
{
	FLevelTextures Textures;
	int Compared = 0;
	for (uint32_t Seed = 0; Seed < NumScenes; ++Seed)
	{
		SCOPED_TRACE("scene " + std::to_string(Seed));
		const FLevelScene Scene(Seed);
		const auto Found = [&](double Level, double Bias)
		{
			const double Moved = Level + Bias;
			return std::clamp(bClamp ? std::max(Moved, double(Scene.Clamp)) : Moved, 0.0, FLevelScene::NumMips - 1.0);
		};
		ForEachPixelForm(
			MakeLevelShader(bClamp, true), FLevelScene::Width, FLevelScene::Height,
			[&](FShaderHarness& Harness)
			{
				Harness.Request.bQuads = true;
				Harness.Sampler = {EKernelFilter::Trilinear, EKernelAddress::Wrap, EKernelAddress::Wrap,
					EKernelAddress::Wrap, 8, 0, {}, EKernelCompare::Less};
				for (int i = 0; i < 4; ++i)
				{
					Harness.Targets.emplace_back(FLevelScene::Width, FLevelScene::Height);
				}
				Textures.Fill(Harness);
				Scene.Fill(Harness);
			},
			[&](FShaderHarness& Harness)
			{
				for (int32_t i = 0; i < FLevelScene::Width * FLevelScene::Height; ++i)
				{
					const int32_t X = i % FLevelScene::Width;
					const int32_t Y = i / FLevelScene::Width;
					const std::array<double, 4> Levels = GetLevels(Scene, X, Y);
					const bool bEdge = IsOnEdge(Scene.GetAt(X, Y));
					for (size_t c = 0; c < 4; ++c)
					{
						if (bEdge && (c == 1 || c == 2))
						{
							continue;
						}
						const double Level = Found(Levels[c], 0);
						const auto Seen = [&](size_t Target)
						{
							return double(Harness.Targets[Target].Texel(X, Y)[c]);
						};
						ASSERT_NEAR(Level, Seen(0), Tolerance) << X << ", " << Y << ", " << c;
						ASSERT_NEAR(Found(Levels[c], double(Scene.Bias)), Seen(1), Tolerance)
							<< X << ", " << Y << ", " << c;
						ASSERT_NEAR(Levels[c], Seen(3), Tolerance) << X << ", " << Y << ", " << c;
						++Compared;
					}
					const double Depth[4] = {Levels[0], Levels[0], Levels[1], Levels[1]};
					for (size_t c = 0; c < (bEdge ? 2 : 4); ++c)
					{
						ASSERT_NEAR(
							GetCompared(Found(Depth[c], 0)), double(Harness.Targets[2].Texel(X, Y)[c]), Tolerance)
							<< X << ", " << Y << ", " << c;
					}
				}
			});
	}
	EXPECT_GT(Compared, NumScenes * FLevelScene::Width * FLevelScene::Height * 4);
}

} // namespace

TEST(ShaderLevels, CubesVolumesAndComparisonsFollowTheLongerStep)
{
	CheckScenes(false);
}

TEST(ShaderLevels, ASamplesOwnClampIsBehindItsBias)
{
	CheckScenes(true);
}

TEST(ShaderLevels, GradientsAreClampedToo)
{
	const std::string Text = R"(
Texture2D T; TextureCube C; TextureCubeArray CA; Texture3D V; SamplerState S;
StructuredBuffer<float4> In;
RWStructuredBuffer<float4> Out;
[numthreads(16, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID)
{
	const float4 A = In[Id.x * 3], X = In[Id.x * 3 + 1], Y = In[Id.x * 3 + 2];
	const float Clamp = X.w;
	Out[Id.x] = float4(T.SampleGrad(S, A.xy, X.xy, Y.xy, int2(1, 0), Clamp).x,
		C.SampleGrad(S, A.xyz, X.xyz, Y.xyz, Clamp).x, CA.SampleGrad(S, float4(A.xyz, 1), X.xyz, Y.xyz, Clamp).x,
		V.SampleGrad(S, A.xyz, X.xyz, Y.xyz, int3(0, 0, 0), Clamp).x);
}
)";
	constexpr size_t NumThreads = 64;
	FLevelTextures Textures;
	std::vector<float> In;
	for (uint32_t Seed = 0; Seed < NumThreads; ++Seed)
	{
		const FLevelScene Scene(Seed + 100);
		In.insert(In.end(), Scene.Base, Scene.Base + 4);
		In.insert(In.end(), Scene.AlongX, Scene.AlongX + 3);
		In.push_back(Scene.Clamp);
		In.insert(In.end(), Scene.AlongY, Scene.AlongY + 4);
	}
	ForEachForm(
		Text, NumThreads, 1, 1,
		[&](FShaderHarness& Harness)
		{
			Harness.Sampler = {
				EKernelFilter::Trilinear, EKernelAddress::Wrap, EKernelAddress::Wrap, EKernelAddress::Wrap, 8, 0, {}};
			Textures.Fill(Harness);
			Harness.SetFloatBuffer("In", In);
			Harness.Buffers["Out"].assign(NumThreads * 4, 0);
		},
		[&](FShaderHarness& Harness)
		{
			for (uint32_t i = 0; i < NumThreads; ++i)
			{
				const FLevelScene Scene(i + 100);
				const std::array<double, 4> Levels = GetLevels(Scene, 0, 0);
				for (size_t c = 0; c < 4; ++c)
				{
					const double Level =
						std::clamp(std::max(Levels[c], double(Scene.Clamp)), 0.0, FLevelScene::NumMips - 1.0);
					EXPECT_NEAR(Level, double(Harness.BufferFloat("Out", i * 4 + c)), Tolerance) << i << ", " << c;
				}
			}
		});
}
