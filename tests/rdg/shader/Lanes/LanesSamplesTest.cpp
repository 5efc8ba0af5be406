// Cubes, comparisons, gathers, offsets and gradients against geometry and arithmetic in double.
#include "LanesLod.h"
#include "LanesSampleOracle.h"

#include <limits>

namespace Drydock::Tests
{
namespace
{

template<typename Real>
void ExpectNear(const FTexel& Expected, const std::array<Real, 4>& Seen, int NumChannels = 4)
{
	const double Tolerance = sizeof(Real) == 4 ? 2e-6 : 1e-14; // texels are below 4, of three products each
	for (int c = 0; c < NumChannels; ++c)
	{
		EXPECT_NEAR(Expected[size_t(c)], double(Seen[size_t(c)]), 4 * Tolerance) << "channel " << c;
	}
}

constexpr int GSizes[] = {1, 2, 3, 5};

TEST(LanesSamples, CubesAreWhatGeometrySays)
{
	FSampleRandom Random(1);
	int Compared = 0;
	for (int Turn = 0; Turn < 3000; ++Turn)
	{
		FTestTexture Cube(ETexelStorage::RGBA32_FLOAT, GSizes[Turn % 4], GSizes[Turn % 4], 12);
		Cube.FillRandom(uint32_t(Turn), -4, 4);
		const FSampleCase Case = MakeSampleCase(Random, Cube, true);
		if (const std::optional<FTexel> Expected = Case.Sample(0))
		{
			ExpectNear(*Expected, Case.RunSample<float>());
			ExpectNear(*Expected, Case.RunSample<double>());
			++Compared;
		}
	}
	EXPECT_GT(Compared, 2900);
}

/** Directions close to edges and corners, where the texels of two and three faces meet. */
TEST(LanesSamples, CubesHaveNoSeams)
{
	FSampleRandom Random(2);
	int Corners = 0;
	for (int Turn = 0; Turn < 3000; ++Turn)
	{
		FTestTexture Cube(ETexelStorage::RGBA32_FLOAT, GSizes[Turn % 4], GSizes[Turn % 4], 6);
		Cube.FillRandom(uint32_t(Turn), -4, 4);
		FSampleCase Case = MakeSampleCase(Random, Cube, true);
		Case.bArray = false;
		Case.Sampler.Filter = EKernelFilter::Bilinear;
		const bool bCorner = Random.Int(0, 1) != 0;
		for (int Axis = 0; Axis < 3; ++Axis)
		{
			Case.At[Axis] = (Random.Int(0, 1) ? 1 : -1) * Random.Real(0.9, 1);
		}
		Case.At[Random.Int(0, 2)] *= bCorner ? 1 : 0.3;
		if (const std::optional<FTexel> Expected = Case.Sample(0))
		{
			ExpectNear(*Expected, Case.RunSample<float>());
			ExpectNear(*Expected, Case.RunSample<double>());
			Corners += bCorner;
		}
	}
	EXPECT_GT(Corners, 1000);
}

TEST(LanesSamples, ACubeOfOneColourHasItEverywhere)
{
	FTestTexture Cube(ETexelStorage::RGBA32_FLOAT, 3, 3, 6);
	const FTexel Colour = {double(1.1f), double(-7e-3f), 1e30, 3};
	Cube.ForEachTexel([&](int32_t X, int32_t Y, int32_t Z, int32_t Mip) { Cube.Write(Colour, X, Y, Z, Mip); });
	FSampleRandom Random(3);
	for (int Turn = 0; Turn < 500; ++Turn)
	{
		FSampleCase Case = MakeSampleCase(Random, Cube, true);
		Case.At[Turn % 3] = Case.At[(Turn + 1) % 3] * (Turn % 2 ? 1 : -0.9999);
		const std::array<float, 4> Seen = Case.RunSample<float>();
		for (size_t c = 0; c < 4; ++c)
		{
			EXPECT_EQ(float(Colour[c]), Seen[c]);
		}
	}
}

TEST(LanesSamples, WhereAxesAreEquallyLongZComesFirst)
{
	FTestTexture Cube(ETexelStorage::RGBA32_FLOAT, 1, 1, 6);
	Cube.ForEachTexel(
		[&](int32_t X, int32_t Y, int32_t Z, int32_t Mip) {
			Cube.Write({double(Z), 0, 0, 0}, X, Y, Z, Mip);
		});
	FSampleCase Case;
	Case.Texture = &Cube;
	Case.Sampler = MakeSampler(EKernelFilter::Point, EKernelAddress::Wrap);
	Case.bCube = true;
	const double Directions[][4] = {
		{1, 1, 1, 4}, {-1, -1, -1, 5}, {1, -1, 0, 3}, {-1, 1, 0.5, 2}, {-1, 0, -1, 5}, {-2, 1, 1, 1}, {2, -1, 1, 0}};
	for (const auto& Direction : Directions)
	{
		std::copy_n(Direction, 3, Case.At);
		EXPECT_EQ(float(Direction[3]), Case.RunSample<float>()[0]);
	}
}

TEST(LanesSamples, ComparisonsAreFilteredAnswers)
{
	FSampleRandom Random(4);
	int Between = 0;
	for (int Turn = 0; Turn < 4000; ++Turn)
	{
		const bool bCube = Turn % 3 == 0;
		FTestTexture Texture(Turn % 2 ? ETexelStorage::R32_FLOAT : ETexelStorage::R16_UNORM, GSizes[Turn % 4],
			bCube ? GSizes[Turn % 4] : GSizes[Turn / 4 % 4], bCube ? 12 : 3);
		// Few values, so that some are equal to the reference.
		Texture.ForEachTexel(
			[&](int32_t X, int32_t Y, int32_t Z, int32_t Mip) {
				Texture.Write({Random.Int(0, 4) / 4.0, 0, 0, 1}, X, Y, Z, Mip);
			});
		FSampleCase Case = MakeSampleCase(Random, Texture, bCube);
		Case.bCompares = true;
		Case.Sampler.Compare = Random.Int(0, 9) ? EKernelCompare::Less : EKernelCompare::Never;
		// Averages of three texels are no quarters: the reference must not be one of these.
		Case.Reference = bCube ? Random.Pick({0.1, 0.3, 0.55, 0.8}) : Random.Int(0, 4) / 4.0;
		if (const std::optional<FTexel> Expected = Case.Sample(0))
		{
			ExpectNear(*Expected, Case.RunSample<float>(), 1);
			ExpectNear(*Expected, Case.RunSample<double>(), 1);
			Between += (*Expected)[0] > 0 && (*Expected)[0] < 1;
		}
	}
	EXPECT_GT(Between, 500);
}

TEST(LanesSamples, FormatsOfZeroToOneAreComparedWithinThat)
{
	for (const ETexelStorage Storage : {ETexelStorage::R16_UNORM, ETexelStorage::R32_FLOAT})
	{
		FTestTexture Texture(Storage, 1, 1);
		FSampleCase Case;
		Case.Texture = &Texture;
		Case.Sampler = MakeSampler(EKernelFilter::Point, EKernelAddress::Clamp);
		Case.Sampler.Compare = EKernelCompare::Less;
		Case.bCompares = true;
		Case.Reference = -1; // is 0 for the first, and not less than a texel of 0
		EXPECT_EQ(Storage == ETexelStorage::R32_FLOAT ? 1.0f : 0.0f, Case.RunSample<float>()[0]);
		Case.Reference = std::numeric_limits<double>::quiet_NaN();
		EXPECT_EQ(0.0f, Case.RunSample<float>()[0]);
	}
}

TEST(LanesSamples, GathersTakeTheTexelsOfTheFootprint)
{
	constexpr size_t Order[4] = {2, 3, 1, 0}; // left below, right below, right above, left above
	FSampleRandom Random(5);
	for (int Turn = 0; Turn < 4000; ++Turn)
	{
		const bool bCube = Turn % 3 == 0;
		FTestTexture Texture(ETexelStorage::RGBA32_FLOAT, GSizes[Turn % 4],
			bCube ? GSizes[Turn % 4] : GSizes[Turn / 4 % 4], bCube ? 12 : 3);
		Texture.FillRandom(uint32_t(Turn), 0, 1);
		FSampleCase Case = MakeSampleCase(Random, Texture, bCube);
		Case.bCompares = Turn % 5 == 0;
		Case.Sampler.Compare = EKernelCompare::Less;
		Case.Reference = Random.Real(0, 1);
		for (int& Offset : Case.Offset)
		{
			Offset = bCube ? 0 : Random.Int(-8, 7);
		}
		const int Component = Case.bCompares ? 0 : Random.Int(0, 3);
		if (const std::optional<FSampleCase::FFour> Four = Case.FindFour(0, false))
		{
			FTexel Expected;
			for (size_t i = 0; i < 4; ++i)
			{
				Expected[i] = Four->Texels[Order[i]][size_t(Component)];
			}
			ExpectNear(Expected, Case.RunGather<float>(Component));
			ExpectNear(Expected, Case.RunGather<double>(Component));
		}
	}
}

TEST(LanesSamples, OffsetsAreTexelsOfTheMipThatIsSampled)
{
	FSampleRandom Random(6);
	for (int Turn = 0; Turn < 2000; ++Turn)
	{
		FTestTexture Texture(ETexelStorage::RGBA32_FLOAT, 13, 7, 3, 3);
		Texture.FillRandom(uint32_t(Turn), 0, 1);
		FSampleCase Case = MakeSampleCase(Random, Texture, false);
		Case.Offset[0] = Random.Int(-8, 7);
		Case.Offset[1] = Random.Int(-8, 7);
		Case.Level = Turn % 3;
		if (const std::optional<FTexel> Expected = Case.Sample(Turn % 3))
		{
			ExpectNear(*Expected, Case.RunSample<double>());
		}
	}
}

TEST(LanesSamples, LevelsStayInTheSamplersRange)
{
	FTestTexture Texture(ETexelStorage::R32_FLOAT, 8, 8, 1, 4);
	Texture.ForEachTexel(
		[&](int32_t X, int32_t Y, int32_t Z, int32_t Mip) {
			Texture.Write({double(Mip), 0, 0, 1}, X, Y, Z, Mip);
		});
	FSampleCase Case;
	Case.Texture = &Texture;
	Case.Sampler = MakeSampler(EKernelFilter::Trilinear, EKernelAddress::Clamp);
	Case.Sampler.MinLevel = 0.5f;
	Case.Sampler.MaxLevel = 2.25f;
	Case.Sampler.MipBias = 0.25f;
	const double Levels[][2] = {{-5, 0.5}, {0.25, 0.5}, {1, 1.25}, {2, 2.25}, {9, 2.25},
		{std::numeric_limits<double>::quiet_NaN(), 0.5}, {std::numeric_limits<double>::infinity(), 2.25}};
	for (const auto& [Level, Expected] : Levels)
	{
		Case.Level = Level;
		EXPECT_EQ(float(Expected), Case.RunSample<float>()[0]) << Level;
	}
}

template<typename T>
T MakeVector(const double* V);
template<>
Lanes::TVec<double, 2> MakeVector(const double* V)
{
	return {V[0], V[1]};
}
template<>
Lanes::TVec<double, 3> MakeVector(const double* V)
{
	return {V[0], V[1], V[2]};
}

TEST(LanesSamples, GradientsGiveTheLogarithmOfTheLongerStep)
{
	FTestTexture Texture(ETexelStorage::R32_FLOAT, 64, 16, 4, 3, true);
	FSampleRandom Random(7);
	for (int Turn = 0; Turn < 200; ++Turn)
	{
		double DX[3], DY[3];
		double LengthX = 0, LengthY = 0;
		for (int Axis = 0; Axis < 3; ++Axis)
		{
			const int Sizes[] = {64, 16, 4};
			DX[Axis] = Random.Real(-1, 1);
			DY[Axis] = Random.Real(-1, 1);
			LengthX = std::hypot(LengthX, Axis < 2 || Turn % 2 ? DX[Axis] * Sizes[Axis] : 0);
			LengthY = std::hypot(LengthY, Axis < 2 || Turn % 2 ? DY[Axis] * Sizes[Axis] : 0);
		}
		const double Expected = std::log2(std::max(LengthX, LengthY));
		const double Seen = Turn % 2 ? Lanes::GradientLevel(Texture.Texture, MakeVector<Lanes::TVec<double, 3>>(DX),
										   MakeVector<Lanes::TVec<double, 3>>(DY))
									 : Lanes::GradientLevel(Texture.Texture, MakeVector<Lanes::TVec<double, 2>>(DX),
										   MakeVector<Lanes::TVec<double, 2>>(DY));
		EXPECT_NEAR(Expected, Seen, 1e-12);
	}
	const Lanes::TVec<float, 2> None(0, 0);
	EXPECT_EQ(-std::numeric_limits<float>::infinity(), Lanes::GradientLevel(Texture.Texture, None, None));
}

TEST(LanesSamples, GradientsOfCubesAreThoseOnTheFace)
{
	FTestTexture Cube(ETexelStorage::R32_FLOAT, 32, 32, 6);
	FSampleRandom Random(8);
	for (int Turn = 0; Turn < 500; ++Turn)
	{
		double At[3], DX[3], DY[3];
		for (int Axis = 0; Axis < 3; ++Axis)
		{
			At[Axis] = Random.Real(-3, 3);
			DX[Axis] = Random.Real(-1, 1);
			DY[Axis] = Random.Real(-1, 1);
		}
		const FPlaceOnFace Place = FindFace({At[0], At[1], At[2]});
		const auto GetTexels = [&](const double* Step)
		{
			constexpr double Small = 1e-7;
			const FPlaceOnFace Moved =
				FindFace({At[0] + Small * Step[0], At[1] + Small * Step[1], At[2] + Small * Step[2]});
			return std::hypot(Moved.S - Place.S, Moved.T - Place.T) / Small * 16;
		};
		const FPoint Sorted = {std::abs(At[0]), std::abs(At[1]), std::abs(At[2])};
		if (std::abs(Sorted[0] - Sorted[1]) < 1e-3 || std::abs(Sorted[1] - Sorted[2]) < 1e-3 ||
			std::abs(Sorted[0] - Sorted[2]) < 1e-3)
		{
			continue;
		}
		using FVector = Lanes::TVec<double, 3>;
		EXPECT_NEAR(std::log2(std::max(GetTexels(DX), GetTexels(DY))),
			Lanes::GradientLevelCube(
				Cube.Texture, MakeVector<FVector>(At), MakeVector<FVector>(DX), MakeVector<FVector>(DY)),
			1e-4);
	}
}

} // namespace
} // namespace Drydock::Tests
