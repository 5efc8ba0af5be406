// Samples whose level the quad chooses, of cubes, volumes and comparisons, beside a computation in double of how far a
// step of the coordinates goes across the texture. Level: Direct3D 11.3 functional specification, 7.18.11. Cubes:
// the face of the pixel's direction is kept, and its plane's coordinates are followed along the step.
#pragma once

#include "../Lanes/LanesSampleOracle.h"
#include "ShaderHarness.h"

#include <cmath>

namespace Drydock::Test
{

/** Coordinates of a picture's pixels: Base + AlongX * column + AlongY * row, of which w is the layer of an array. */
struct FLevelScene
{
	static constexpr int32_t Width = 10;
	static constexpr int32_t Height = 6;
	static constexpr int32_t Size = 32; // of faces and of the flat texture
	static constexpr int32_t NumMips = 6;

	float Base[4];
	float AlongX[4];
	float AlongY[4];
	float Bias = 0;
	float Clamp = 0;

	/** Directions anywhere, steps of a fraction of a texel to many. */
	explicit FLevelScene(uint32_t Seed)
	{
		Tests::FSampleRandom Random(Seed);
		const double Step = std::exp2(Random.Real(-7, 0));
		for (int i = 0; i < 4; ++i)
		{
			Base[i] = float(Random.Real(-1.5, 1.5));
			AlongX[i] = float(Random.Real(-Step, Step));
			AlongY[i] = float(Random.Real(-Step, Step));
		}
		// The layer changes from pixel to pixel, which no level may see.
		Base[3] = 0;
		AlongX[3] = 1;
		AlongY[3] = 0;
		Bias = float(Random.Int(-8, 8)) / 4;
		Clamp = float(Random.Int(-4, 18)) / 4;
	}

	Tests::FPoint GetAt(int32_t X, int32_t Y) const
	{
		const auto Part = [&](size_t i)
		{
			return double(Base[i]) + double(AlongX[i]) * X + double(AlongY[i]) * Y;
		};
		return {Part(0), Part(1), Part(2)};
	}

	/** Texels that a step goes, along each axis. */
	using FStep = std::array<double, 3>;

	FStep GetFlatStep(const float (&Along)[4]) const { return {Along[0] * double(Size), Along[1] * double(Size), 0}; }
	FStep GetVolumeStep(const float (&Along)[4]) const
	{
		return {Along[0] * double(Size), Along[1] * double(Size / 2), Along[2] * double(Size / 4)};
	}
	FStep GetCubeStep(const float (&Along)[4], const Tests::FPoint& At) const
	{
		const int Face = Tests::FindFace(At).Face;
		const Tests::FPoint Out = Tests::OnCube(Face, 0, 0);
		const Tests::FPoint Right = Tests::OnCube(Face, 1, 0);
		const Tests::FPoint Down = Tests::OnCube(Face, 0, 1);
		const auto Project = [&](double t, const Tests::FPoint& Axis)
		{
			double Length = 0;
			double Place = 0;
			for (size_t i = 0; i < 3; ++i)
			{
				Length += (At[i] + t * double(Along[i])) * Out[i];
				Place += (At[i] + t * double(Along[i])) * (Axis[i] - Out[i]);
			}
			return Place / Length * (Size / 2.0);
		};
		constexpr double h = 1e-5;
		return {
			(Project(h, Right) - Project(-h, Right)) / (2 * h), (Project(h, Down) - Project(-h, Down)) / (2 * h), 0};
	}

	/** Direct3D's: of the longer step. */
	static double GetLevel(const FStep& X, const FStep& Y)
	{
		return std::log2(std::max(std::hypot(X[0], X[1], X[2]), std::hypot(Y[0], Y[1], Y[2])));
	}

	void Fill(FShaderHarness& Harness) const
	{
		Harness.SetFloats("Base", {Base, Base + 4});
		Harness.SetFloats("AlongX", {AlongX, AlongX + 4});
		Harness.SetFloats("AlongY", {AlongY, AlongY + 4});
		Harness.SetFloats("Bias", {Bias});
		Harness.SetFloats("Clamp", {Clamp});
	}
};

/** Each mip holds its own number; those that are compared 1 and 0 by turns. */
struct FLevelTextures
{
	using FMips = Tests::FTestTexture;
	static constexpr int32_t Size = FLevelScene::Size;
	static constexpr int32_t NumMips = FLevelScene::NumMips;

	FMips T{ETexelStorage::RGBA32_FLOAT, Size, Size, 1, NumMips};
	FMips C{ETexelStorage::RGBA32_FLOAT, Size, Size, 6, NumMips};
	FMips CA{ETexelStorage::RGBA32_FLOAT, Size, Size, 12, NumMips};
	FMips V{ETexelStorage::RGBA32_FLOAT, Size, Size / 2, Size / 4, NumMips, true};
	FMips D{ETexelStorage::R32_FLOAT, Size, Size, 1, NumMips};
	FMips DA{ETexelStorage::R32_FLOAT, Size, Size, 2, NumMips};
	FMips DC{ETexelStorage::R32_FLOAT, Size, Size, 6, NumMips};
	FMips DCA{ETexelStorage::R32_FLOAT, Size, Size, 12, NumMips};

	std::map<std::string, FMips*> Names = {
		{"T", &T}, {"C", &C}, {"CA", &CA}, {"V", &V}, {"D", &D}, {"DA", &DA}, {"DC", &DC}, {"DCA", &DCA}};

	FLevelTextures()
	{
		for (auto& [Name, Texture] : Names)
		{
			const bool bCompared = Name[0] == 'D';
			Texture->ForEachTexel(
				[&](int32_t X, int32_t Y, int32_t Z, int32_t Mip)
				{
					const double Value = bCompared ? Mip % 2 : Mip;
					Texture->Write({Value, double(Z), 0, 0}, X, Y, Z, Mip);
				});
		}
	}

	void Fill(FShaderHarness& Harness) const
	{
		for (const auto& [Name, Texture] : Names)
		{
			Harness.Views[Name] = Texture->Texture;
		}
	}
};

/** Every kind of texture once in each of the targets: sampled, with a bias, and of bAll compared and asked for its
 *  level. bClamp: the samples have a clamp of their own, behind their offset. */
inline std::string MakeLevelShader(bool bClamp, bool bAll)
{
	const std::string Cube = bClamp ? ", Clamp)" : ")";
	const std::string Flat = bClamp ? ", int2(0, 0), Clamp)" : ")";
	const std::string Volume = bClamp ? ", int3(0, 0, 0), Clamp)" : ")";
	const std::string Samples = "Plain = float4(T.Sample(S, A.xy" + Flat + ".x, C.Sample(S, A.xyz" + Cube +
								".x, CA.Sample(S, L" + Cube + ".x, V.Sample(S, A.xyz" + Volume + ".x);\n" +
								"Biased = float4(T.SampleBias(S, A.xy, Bias" + Flat +
								".x, C.SampleBias(S, A.xyz, Bias" + Cube + ".x, CA.SampleBias(S, L, Bias" + Cube +
								".x, V.SampleBias(S, A.xyz, Bias" + Volume + ".x);\n";
	const std::string Compared = "Compared = float4(D.SampleCmp(SC, A.xy, 0.5" + Flat +
								 ", DA.SampleCmp(SC, float3(A.xy, L.w), 0.5" + Flat + ", DC.SampleCmp(SC, A.xyz, 0.5" +
								 Cube + ", DCA.SampleCmp(SC, L, 0.5" + Cube + ");\n";
	const std::string Asked =
		"Asked = float4(T.CalculateLevelOfDetailUnclamped(S, A.xy), "
		"C.CalculateLevelOfDetailUnclamped(S, A.xyz), "
		"CA.CalculateLevelOfDetailUnclamped(S, A.xyz), V.CalculateLevelOfDetailUnclamped(S, A.xyz));\n";
	return "Texture2D T; TextureCube C; TextureCubeArray CA; Texture3D V; Texture2D<float> D; Texture2DArray<float> "
		   "DA;\n"
		   "TextureCube<float> DC; TextureCubeArray<float> DCA; SamplerState S; SamplerComparisonState SC;\n"
		   "float4 Base; float4 AlongX; float4 AlongY; float Bias; float Clamp;\n"
		   "void MainPS(float4 P : SV_POSITION, out float4 Plain : SV_Target0, out float4 Biased : SV_Target1" +
		   std::string(bAll ? ", out float4 Compared : SV_Target2, out float4 Asked : SV_Target3" : "") +
		   ")\n{\nconst float4 A = Base + AlongX * (P.x - 0.5) + AlongY * (P.y - 0.5);\n"
		   "const float4 L = float4(A.xyz, A.w % 2);\n" +
		   Samples + (bAll ? Compared + Asked : std::string()) + "}\n";
}

} // namespace Drydock::Test
