// Mips, layers, volumes, gathers, texel loads and typed buffers: small textures with known texels, every lane width.
#include <gtest/gtest.h>

#include "LanesResources.h"
#include "LanesTestTexture.h"

#include <cmath>
#include <limits>

namespace Drydock::Tests
{
namespace
{

using Lanes::TSampling;
using FTexel = FTestTexture::FTexel;

template<typename Real, int N>
struct TLaneArray
{
	alignas(64) Real V[N];

	TLaneArray(Real First, Real Step = 0)
	{
		for (int i = 0; i < N; ++i)
		{
			V[i] = First + Step * Real(i);
		}
	}
};

template<typename Real, int N>
FTexel LaneOf(const Real* Out, int Lane)
{
	return {double(Out[Lane]), double(Out[N + Lane]), double(Out[2 * N + Lane]), double(Out[3 * N + Lane])};
}

/** Red of every texel is 100 mip + 10 z + x, green is y. */
void Number(FTestTexture& T)
{
	T.ForEachTexel(
		[&](int32_t X, int32_t Y, int32_t Z, int32_t Mip) {
			T.Write({100.0 * Mip + 10 * Z + X, double(Y), 0, 1}, X, Y, Z, Mip);
		});
}

TEST(LanesMips, TheNearestMipUnlessTrilinear)
{
	FTestTexture T(ETexelStorage::RGBA32_FLOAT, 8, 8, 1, 4);
	Number(T);
	ForEachWidth(
		[&]<typename Real, int N>()
		{
			const TLaneArray<Real, N> Coordinate(0);
			Real Out[4 * N];
			for (const auto& [Level, Mip] :
				{std::pair{-1.0, 0}, {0.49, 0}, {0.5, 1}, {1.4, 1}, {9.0, 3}, {std::nan(""), 0}})
			{
				const Real RealLevel = Real(Level);
				TSampling<Real, N>::Sample2D(T.Texture, MakeSampler(EKernelFilter::Bilinear, EKernelAddress::Clamp),
					Coordinate.V, Coordinate.V, nullptr, &RealLevel, true, Out);
				EXPECT_EQ(100.0 * Mip, Out[N - 1]) << Level;
			}
		});
}

TEST(LanesMips, TrilinearBlendsTwoMips)
{
	FTestTexture T(ETexelStorage::RGBA32_FLOAT, 8, 8, 1, 4);
	Number(T);
	ForEachWidth(
		[&]<typename Real, int N>()
		{
			const TLaneArray<Real, N> Coordinate(0);
			const TLaneArray<Real, N> Levels(Real(1.25));
			Real Out[4 * N];
			TSampling<Real, N>::Sample2D(T.Texture, MakeSampler(EKernelFilter::Trilinear, EKernelAddress::Clamp),
				Coordinate.V, Coordinate.V, nullptr, Levels.V, false, Out);
			EXPECT_EQ(125, Out[0]);
		});
}

TEST(LanesMips, EachLaneHasItsOwnLevel)
{
	FTestTexture T(ETexelStorage::RGBA32_FLOAT, 8, 8, 1, 4);
	Number(T);
	ForEachWidth(
		[&]<typename Real, int N>()
		{
			const TLaneArray<Real, N> Coordinate(0);
			const TLaneArray<Real, N> Levels(0, Real(0.25));
			Real Out[4 * N];
			TSampling<Real, N>::Sample2D(T.Texture, MakeSampler(EKernelFilter::Trilinear, EKernelAddress::Clamp),
				Coordinate.V, Coordinate.V, nullptr, Levels.V, false, Out);
			for (int Lane = 0; Lane < N; ++Lane)
			{
				EXPECT_EQ(std::min(300.0, 25.0 * Lane), Out[Lane]);
			}
		});
}

TEST(LanesMips, TheSamplersBiasIsAdded)
{
	FTestTexture T(ETexelStorage::R32_FLOAT, 8, 8, 1, 4);
	Number(T);
	FKernelSampler S = MakeSampler(EKernelFilter::Point, EKernelAddress::Clamp);
	S.MipBias = 2;
	const TLaneArray<float, 4> Coordinate(0);
	const float Level = 0;
	float Out[16];
	TSampling<float, 4>::Sample2D(T.Texture, S, Coordinate.V, Coordinate.V, nullptr, &Level, true, Out);
	EXPECT_EQ(200, Out[0]);
}

TEST(LanesLayers, TheNearestLayerAtATieTheEvenOneClamped)
{
	FTestTexture T(ETexelStorage::RGBA16_FLOAT, 4, 4, 4);
	Number(T);
	ForEachWidth(
		[&]<typename Real, int N>()
		{
			const TLaneArray<Real, N> Coordinate(0);
			const std::pair<double, double> Pairs[] = {{-1e30, 0}, {-0.5, 0}, {0.5, 0}, {0.50001, 1}, {1.25, 1},
				{1.49999, 1}, {1.5, 2}, {2.5, 2}, {2.50001, 3}, {3.5, 3}, {1e30, 3}, {std::nan(""), 0}};
			const Real Level = 0;
			for (size_t First = 0; First < std::size(Pairs); ++First)
			{
				TLaneArray<Real, N> Layers(0);
				for (size_t Lane = 0; Lane < size_t(N); ++Lane)
				{
					Layers.V[Lane] = Real(Pairs[(First + Lane) % std::size(Pairs)].first);
				}
				Real Out[4 * N];
				TSampling<Real, N>::Sample2D(T.Texture, MakeSampler(EKernelFilter::Bilinear, EKernelAddress::Clamp),
					Coordinate.V, Coordinate.V, Layers.V, &Level, true, Out);
				for (size_t Lane = 0; Lane < size_t(N); ++Lane)
				{
					EXPECT_EQ(10 * Pairs[(First + Lane) % std::size(Pairs)].second, Out[Lane]) << Layers.V[Lane];
				}
			}
		});
}

TEST(LanesLayers, AUniformLayerTakesTheTunedPath)
{
	FTestTexture T(ETexelStorage::RGBA16_FLOAT, 64, 4, 3);
	Number(T);
	ForEachWidth(
		[&]<typename Real, int N>()
		{
			const TLaneArray<Real, N> U(Real(20.5 / 64), Real(1.0 / 64));
			const TLaneArray<Real, N> V(Real(2.5 / 4));
			const TLaneArray<Real, N> Layers(2);
			const Real Level = 0;
			Real Out[4 * N];
			TSampling<Real, N>::Sample2D(T.Texture, MakeSampler(EKernelFilter::Bilinear, EKernelAddress::Clamp), U.V,
				V.V, Layers.V, &Level, true, Out);
			EXPECT_EQ((FTexel{20 + 20 + N - 1, 2, 0, 1}), (LaneOf<Real, N>(Out, N - 1)));
		});
}

TEST(LanesVolumes, TrilinearInTheVolume)
{
	FTestTexture T(ETexelStorage::RGBA32_FLOAT, 4, 3, 5, 2, true);
	Number(T);
	ForEachWidth(
		[&]<typename Real, int N>()
		{
			// Halfway between x 1 and 2, a quarter from y 0 to 1, three quarters from z 2 to 3.
			const TLaneArray<Real, N> U(Real(2.0 / 4));
			const TLaneArray<Real, N> V(Real(0.75 / 3));
			const TLaneArray<Real, N> W(Real(3.25 / 5));
			const Real Level = 0;
			Real Out[4 * N];
			TSampling<Real, N>::Sample3D(T.Texture, MakeSampler(EKernelFilter::Bilinear, EKernelAddress::Clamp), U.V,
				V.V, W.V, &Level, true, Out);
			EXPECT_EQ((FTexel{27.5 + 1.5, 0.25, 0, 1}), (LaneOf<Real, N>(Out, N - 1)));
		});
}

TEST(LanesVolumes, EachAxisHasItsOwnAddressMode)
{
	FTestTexture T(ETexelStorage::R32_FLOAT, 4, 1, 4, 1, true);
	Number(T);
	FKernelSampler S = MakeSampler(EKernelFilter::Point, EKernelAddress::Clamp);
	S.AddressU = EKernelAddress::Wrap;
	S.AddressW = EKernelAddress::Mirror;
	const TLaneArray<float, 4> U(1.1f);
	const TLaneArray<float, 4> V(7);
	const TLaneArray<float, 4> W(1.1f);
	const float Level = 0;
	float Out[16];
	TSampling<float, 4>::Sample3D(T.Texture, S, U.V, V.V, W.V, &Level, true, Out);
	EXPECT_EQ(30, Out[0]);
}

TEST(LanesGather, FourTexelsInTheOrderOfDirect3D)
{
	FTestTexture T(ETexelStorage::RG32_FLOAT, 4, 4);
	Number(T);
	ForEachWidth(
		[&]<typename Real, int N>()
		{
			const TLaneArray<Real, N> Middle(Real(0.5)); // the corner of texels 1 and 2
			Real Out[4 * N];
			TSampling<Real, N>::Gather(
				T.Texture, MakeSampler(EKernelFilter::Bilinear, EKernelAddress::Clamp), {{Middle.V, Middle.V}}, 0, Out);
			EXPECT_EQ((FTexel{1, 2, 2, 1}), (LaneOf<Real, N>(Out, 1)));
			TSampling<Real, N>::Gather(
				T.Texture, MakeSampler(EKernelFilter::Bilinear, EKernelAddress::Clamp), {{Middle.V, Middle.V}}, 1, Out);
			EXPECT_EQ((FTexel{2, 2, 1, 1}), (LaneOf<Real, N>(Out, 1)));
		});
}

TEST(LanesLoad, EveryStorageReadsWhatTheReferenceDecodes)
{
	for (int Storage = 0; Storage < int(ETexelStorage::Count); ++Storage)
	{
		FTestTexture T(ETexelStorage(Storage), 40, 3);
		T.FillRandom(uint32_t(Storage), -2, 300);
		ForEachWidth(
			[&]<typename Real, int N>()
			{
				const TLaneArray<int32_t, N> X(11, 1);
				const TLaneArray<int32_t, N> Y(2);
				const int32_t Mip = 0;
				Real Out[4 * N];
				TSampling<Real, N>::Load(T.Texture, X.V, Y.V, nullptr, &Mip, true, Out);
				for (int Lane = 0; Lane < N; ++Lane)
				{
					Real Expected[4];
					DecodeTexel(ETexelStorage(Storage), T.At(11 + Lane, 2), Expected);
					for (int c = 0; c < 4; ++c)
					{
						ASSERT_EQ(Expected[c], Out[c * N + Lane])
							<< GetTexelStorageInfo(ETexelStorage(Storage)).Name << " lane " << Lane << " channel " << c;
					}
				}
			});
	}
}

TEST(LanesLoad, OutsideIsZeroInEveryChannel)
{
	FTestTexture T(ETexelStorage::RGBA32_FLOAT, 6, 5, 2, 2);
	T.FillRandom(1, 1, 2);
	ForEachWidth(
		[&]<typename Real, int N>()
		{
			const int32_t Places[][4] = {{-1, 0, 0, 0}, {6, 0, 0, 0}, {0, -1, 0, 0}, {0, 5, 0, 0}, {0, 0, 2, 0},
				{0, 0, -1, 0}, {0, 0, 0, 2}, {0, 0, 0, -1}, {3, 0, 0, 1}, {0x7FFFFFFF, 0, 0, 0},
				{int32_t(0x80000000), 0, 0, 0}};
			for (const auto& Place : Places)
			{
				const TLaneArray<int32_t, N> X(Place[0]);
				const TLaneArray<int32_t, N> Y(Place[1]);
				const TLaneArray<int32_t, N> Z(Place[2]);
				Real Out[4 * N];
				TSampling<Real, N>::Load(T.Texture, X.V, Y.V, Z.V, &Place[3], true, Out);
				EXPECT_EQ((FTexel{0, 0, 0, 0}), (LaneOf<Real, N>(Out, N - 1)))
					<< Place[0] << " " << Place[1] << " " << Place[2] << " " << Place[3];
			}
		});
}

TEST(LanesLoad, EachLaneHasItsOwnTexelAndMip)
{
	FTestTexture T(ETexelStorage::RG16_FLOAT, 16, 16, 1, 3);
	Number(T);
	ForEachWidth(
		[&]<typename Real, int N>()
		{
			TLaneArray<int32_t, N> X(3, -1);
			TLaneArray<int32_t, N> Y(0, 1);
			TLaneArray<int32_t, N> Mips(0);
			Mips.V[N - 1] = 2;
			X.V[N - 1] = 1;
			Y.V[N - 1] = 3;
			Real Out[4 * N];
			TSampling<Real, N>::Load(T.Texture, X.V, Y.V, nullptr, Mips.V, false, Out);
			EXPECT_EQ((FTexel{3, 0, 0, 1}), (LaneOf<Real, N>(Out, 0)));
			EXPECT_EQ((FTexel{201, 3, 0, 1}), (LaneOf<Real, N>(Out, N - 1)));
		});
}

TEST(LanesLoad, IntegerTexturesKeepTheirBits)
{
	for (ETexelStorage Storage : {ETexelStorage::R8_UINT, ETexelStorage::RG16_UINT, ETexelStorage::RGBA32_UINT})
	{
		FTestTexture T(Storage, 20, 2);
		const uint32_t Texel[4] = {200, 201, 4000000001u, 7};
		EncodeTexel(Storage, Texel, T.At(5, 1));
		uint32_t Expected[4];
		DecodeTexel(Storage, T.At(5, 1), Expected);
		ForEachWidth(
			[&]<typename Real, int N>()
			{
				const TLaneArray<int32_t, N> X(5);
				const TLaneArray<int32_t, N> Y(1);
				const int32_t Mip = 0;
				uint32_t Out[4 * N];
				TSampling<Real, N>::LoadUint(T.Texture, X.V, Y.V, nullptr, &Mip, true, Out);
				for (int c = 0; c < 4; ++c)
				{
					EXPECT_EQ(Expected[c], Out[c * N]);
				}
			});
	}
}

TEST(LanesTypedBuffer, ReadsWritesAndDropsOutside)
{
	ForEachWidth(
		[&]<typename Real, int N>()
		{
			uint8_t Memory[8 * 4 + 8];
			std::memset(Memory, 0xEE, sizeof(Memory));
			const FKernelBuffer Buffer = {Memory, 8 * 4, 4, ETexelStorage::RG16_FLOAT};
			const TLaneArray<uint32_t, N> Index(7, 1); // only the first lane is inside
			const TLaneArray<int32_t, N> Mask(-1);
			Real Value[4 * N];
			std::fill_n(Value, 4 * N, Real(1.5));
			TSampling<Real, N>::StoreTyped(Buffer, Mask.V, Index.V, Value);
			EXPECT_EQ(0xEE, Memory[8 * 4]);
			EXPECT_EQ(0xEE, Memory[6 * 4]);
			Real Out[4 * N];
			TSampling<Real, N>::LoadTyped(Buffer, Index.V, Out);
			EXPECT_EQ((FTexel{1.5, 1.5, 0, 1}), (LaneOf<Real, N>(Out, 0)));
			EXPECT_EQ((FTexel{0, 0, 0, 0}), (LaneOf<Real, N>(Out, 1)));
		});
}

} // namespace
} // namespace Drydock::Tests
