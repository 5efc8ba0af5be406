// Cubes, comparisons, gathers and offsets at every width against one lane, bit for bit, from random textures, samplers
// and places, some of which are none.
#include "LanesSampleOracle.h"

#include <limits>

namespace Drydock::Tests
{
namespace
{

/** Lanes of a case: the widest pack, two of the middle one, four of the narrowest. */
constexpr int GLanes = 16;

template<typename Real>
struct TLaneInputs
{
	Real At[4][GLanes];
	Real Reference[GLanes];
	Real Levels[GLanes];
	int32_t Offsets[2][GLanes];

	TSamplePlace<Real> MakePlace(int First, bool bCube, bool bArray, bool bCompares, bool bOffsets) const
	{
		TSamplePlace<Real> Place;
		Place.bCube = bCube;
		for (int Axis = 0; Axis < (bCube ? 3 : 2); ++Axis)
		{
			Place.Coordinates[Axis] = &At[Axis][First];
			Place.Offsets[Axis] = bOffsets && !bCube ? &Offsets[Axis][First] : nullptr;
		}
		Place.Layer = bArray ? &At[3][First] : nullptr;
		Place.Reference = bCompares ? &Reference[First] : nullptr;
		return Place;
	}
};

template<typename Real>
void FillInputs(FSampleRandom& Random, TLaneInputs<Real>& Inputs)
{
	const double Inf = std::numeric_limits<double>::infinity();
	const double Strange[] = {std::numeric_limits<double>::quiet_NaN(), Inf, -Inf, 0.0, -0.0, 1.0, -1.0, 1e30};
	for (int Lane = 0; Lane < GLanes; ++Lane)
	{
		for (auto& Axis : Inputs.At)
		{
			Axis[Lane] = Real(Random.Int(0, 5) ? Random.Real(-2, 3) : Random.Pick(Strange));
		}
		Inputs.Reference[Lane] = Real(Random.Int(0, 9) ? Random.Real(0, 1) : Random.Pick(Strange));
		Inputs.Levels[Lane] = Real(Random.Int(0, 9) ? Random.Real(-1, 4) : Random.Pick(Strange));
		Inputs.Offsets[0][Lane] = Random.Int(-8, 7);
		Inputs.Offsets[1][Lane] = Random.Int(-8, 7);
	}
}

TEST(LanesSampleWidths, EveryWidthHasTheBitsOfOneLane)
{
	FSampleRandom Random(9);
	const ETexelStorage Storages[] = {ETexelStorage::RGBA32_FLOAT, ETexelStorage::RGBA16_FLOAT,
		ETexelStorage::R16_UNORM, ETexelStorage::RGBA8_SRGB, ETexelStorage::R11G11B10_FLOAT,
		ETexelStorage::RGBA64_FLOAT};
	for (int Turn = 0; Turn < 1500; ++Turn)
	{
		const bool bCube = Random.Int(0, 1) != 0;
		const int Size = Random.Pick({1, 2, 3, 8});
		FTestTexture Texture(
			Random.Pick(Storages), Size, bCube ? Size : Random.Pick({1, 2, 5}), bCube ? 12 : 3, Size == 8 ? 3 : 1);
		Texture.FillRandom(uint32_t(Turn), -2, 2);
		if (Turn % 7 == 0) // what is no number comes out as one lane has it, too
		{
			Texture.Write({std::numeric_limits<double>::infinity(), 0, 0, 0}, 0, 0);
		}
		FKernelSampler Sampler =
			MakeSampler(Random.Pick({EKernelFilter::Point, EKernelFilter::Bilinear, EKernelFilter::Trilinear}),
				EKernelAddress::Wrap, Random.Int(0, 3) ? 8 : 0);
		Sampler.AddressU = Random.Pick(GSampleAddresses);
		Sampler.AddressV = Random.Pick(GSampleAddresses);
		Sampler.Compare = EKernelCompare::Less;
		const bool bArray = Random.Int(0, 1) != 0;
		const bool bCompares = Random.Int(0, 1) != 0;
		const bool bOffsets = Random.Int(0, 1) != 0;
		const bool bGather = Random.Int(0, 2) == 0;
		const bool bUniform = Random.Int(0, 1) != 0;
		const auto Run = [&]<typename Real, int N>(const TLaneInputs<Real>& In, Real(&Out)[4][GLanes])
		{
			for (int First = 0; First < GLanes; First += N)
			{
				Real Part[4 * N];
				const TSamplePlace<Real> Place = In.MakePlace(First, bCube, bArray, bCompares, bOffsets);
				bGather ? TSampling<Real, N>::Gather(Texture.Texture, Sampler, Place, Turn % 4, Part)
						: TSampling<Real, N>::Sample(
							  Texture.Texture, Sampler, Place, &In.Levels[bUniform ? 0 : First], bUniform, Part);
				for (int i = 0; i < 4 * N; ++i)
				{
					Out[i / N][First + i % N] = Part[i];
				}
			}
		};
		ForEachWidth(
			[&]<typename Real, int N>()
			{
				TLaneInputs<Real> Inputs;
				FSampleRandom Same(static_cast<uint32_t>(Turn));
				FillInputs(Same, Inputs);
				Real Seen[4][GLanes], Expected[4][GLanes];
				Run.template operator()<Real, N>(Inputs, Seen);
				Run.template operator()<Real, 1>(Inputs, Expected);
				for (int i = 0; i < 4 * GLanes && !(bCompares && i >= GLanes && !bGather); ++i)
				{
					const Real A = Expected[i / GLanes][i % GLanes];
					const Real B = Seen[i / GLanes][i % GLanes];
					ASSERT_TRUE(std::memcmp(&A, &B, sizeof(A)) == 0 || (A != A && B != B))
						<< "turn " << Turn << ", " << N << " lanes, value " << i << ": " << A << " and " << B;
				}
			});
	}
}

} // namespace
} // namespace Drydock::Tests
