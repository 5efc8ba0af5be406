// The vocabulary of generated code: mixes of uniform and varying, masks, assignment, vectors, matrices, buffers.
#include <gtest/gtest.h>

#include "Lanes.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace Drydock::Tests
{
namespace
{

using namespace Drydock::Lanes;

constexpr int N = 4;
using FReal = TReal<float, N>;
using FInt = TInt<N>;
using FUint = TUint<N>;
using FMask = TMask<N>;

const FReal GRamp = ToReal<float>(LaneIndex<N>()); // 0 1 2 3

template<typename T>
std::vector<decltype(T()[0])> Lanes4(T X)
{
	return {X[0], X[1], X[2], X[3]};
}
using FFloats = std::vector<float>;
using FInts = std::vector<int32_t>;
using FUints = std::vector<uint32_t>;
using FBools = std::vector<bool>;

TEST(LanesVocabulary, UniformAndVaryingMix)
{
	EXPECT_EQ((FFloats{1, 3, 5, 7}), Lanes4(GRamp * 2.0f + 1.0f));
	EXPECT_EQ((FFloats{5, 4, 3, 2}), Lanes4(5.0f - GRamp));
	EXPECT_EQ((FBools{false, false, true, true}), Lanes4(GRamp >= 2.0f));
	EXPECT_EQ((FInts{10, 11, 12, 13}), Lanes4(LaneIndex<N>() + 10));
	EXPECT_EQ((FBools{true, false, true, true}), Lanes4(LaneIndex<N>() != 1));
}

TEST(LanesVocabulary, NegativeZeroBroadcastsAsItIs)
{
	EXPECT_TRUE(std::signbit(FReal(-0.0f)[2]));
	EXPECT_TRUE(std::signbit((-FReal(0.0f))[1]));
}

TEST(LanesVocabulary, IntegersWrap)
{
	EXPECT_EQ((FInts{INT32_MIN, INT32_MIN, INT32_MIN, INT32_MIN}), Lanes4(FInt(INT32_MAX) + 1));
	EXPECT_EQ(INT32_MIN, (-FInt(INT32_MIN))[0]);
	EXPECT_EQ(INT32_MIN, Add(INT32_MAX, 1));
	EXPECT_TRUE((FUint(1u) < 0x80000000u)[3]);
}

TEST(LanesVocabulary, Masks)
{
	const FMask Low = GRamp < 2.0f;
	EXPECT_TRUE(AnyLane(Low));
	EXPECT_FALSE(AllLanes(Low));
	EXPECT_EQ(2u, CountLanes(Low));
	EXPECT_EQ((FBools{false, false, true, true}), Lanes4(!Low));
	EXPECT_EQ((FBools{true, true, false, false}), Lanes4(Low && true));
	EXPECT_EQ((FBools{true, true, true, true}), Lanes4(false || (Low | !Low)));
	EXPECT_EQ((FBools{false, false, false, false}), Lanes4(Low ^ Low));
	EXPECT_FALSE(AnyLane(FMask(false)));
	EXPECT_TRUE(AllLanes(FMask(true)));
	EXPECT_TRUE(AnyLane(true));
}

TEST(LanesVocabulary, SelectTakesAnyMix)
{
	const FMask Low = GRamp < 2.0f;
	EXPECT_EQ((FFloats{1, 1, 0, 0}), Lanes4(Select(Low, 1.0f, 0.0f)));
	EXPECT_EQ((FFloats{0, 1, 9, 9}), Lanes4(Select(Low, GRamp, 9.0f)));
	EXPECT_EQ((FFloats{0, 1, 2, 3}), Lanes4(Select(true, GRamp, 9.0f)));
	EXPECT_EQ(3, Select(false, 2, 3));
	EXPECT_EQ((FBools{true, true, false, false}), Lanes4(Select(Low, true, false)));
	const auto V = Select(Low, TVec<float, 2>(1, 2), TVec<FReal, 2>(GRamp, GRamp));
	EXPECT_EQ((FFloats{2, 2, 2, 3}), Lanes4(V[1]));
	const auto W = Select(TVec<FMask, 2>(Low, !Low), TVec<float, 2>(1, 1), TVec<float, 2>(0, 0));
	EXPECT_EQ((FFloats{0, 0, 1, 1}), Lanes4(W[1]));
}

TEST(LanesVocabulary, AssignWritesOnlyTheMaskedLanes)
{
	const FMask Odd = (LaneIndex<N>() & 1) == 1;
	FReal Place = GRamp;
	Assign(Odd, Place, 7.0f);
	EXPECT_EQ((FFloats{0, 7, 2, 7}), Lanes4(Place));
	TVec<FInt, 3> Vector(FInt(1), FInt(2), FInt(3));
	Assign(Odd, Vector, TVec<int32_t, 3>(10, 20, 30));
	EXPECT_EQ((FInts{3, 30, 3, 30}), Lanes4(Vector[2]));
	TArray<FReal, 2> Array = {{FReal(0.0f), FReal(0.0f)}};
	Assign(Odd, Array, TArray<FReal, 2>{{FReal(1.0f), FReal(2.0f)}});
	EXPECT_EQ((FFloats{0, 2, 0, 2}), Lanes4(Array[1]));
	FMask Flag = false;
	Assign(Odd, Flag, true);
	EXPECT_EQ((FBools{false, true, false, true}), Lanes4(Flag));
	float Uniform = 1;
	Assign(false, Uniform, 2.0f);
	EXPECT_EQ(1, Uniform);
}

TEST(LanesVocabulary, DoubleLanesUseTheSameMasks)
{
	using FWide = TReal<double, N>;
	const FWide Ramp = ToReal<double>(LaneIndex<N>());
	FWide Place = Ramp;
	Assign(Ramp > 1.0, Place, -1.0);
	EXPECT_EQ((std::vector<double>{0, 1, -1, -1}), Lanes4(Place));
	EXPECT_EQ((FFloats{0, 1, 2, 3}), Lanes4(GRamp));
	EXPECT_EQ((std::vector<double>{0.1f, 0.1f, 0.1f, 0.1f}), Lanes4(AsReal<double>(AsUint(FWide(0.1)))));
}

TEST(LanesVocabulary, ExtractAndInsertAtAnyIndex)
{
	const TArray<float, 3> Table = {{10, 20, 30}};
	EXPECT_EQ((FFloats{10, 20, 30, 30}), Lanes4(Extract(Table, LaneIndex<N>())));
	EXPECT_EQ(30, Extract(Table, -5));
	EXPECT_EQ((FFloats{30, 30, 30, 30}), Lanes4(Extract(Table, FUint(0xFFFFFFFFu))));
	TVec<FReal, 3> V(FReal(0.0f), FReal(0.0f), FReal(0.0f));
	Insert(FMask(true), V, LaneIndex<N>(), 5.0f);
	EXPECT_EQ((FFloats{5, 0, 0, 0}), Lanes4(V[0]));
	EXPECT_EQ((FFloats{0, 0, 5, 0}), Lanes4(V[2]));
	Insert(LaneIndex<N>() == 0, V, 1, 6.0f);
	EXPECT_EQ((FFloats{6, 5, 0, 0}), Lanes4(V[1]));
}

TEST(LanesVocabulary, VectorsWorkPerComponent)
{
	const TVec<FReal, 3> V(GRamp, GRamp + 1.0f, FReal(2.0f));
	EXPECT_EQ((FFloats{2, 4, 6, 8}), Lanes4((V * 2.0f)[1]));
	EXPECT_EQ((FFloats{1, 2, 3, 4}), Lanes4(Swizzle<1, 0>(V)[0]));
	EXPECT_EQ((FFloats{4, 4, 4, 4}), Lanes4((V + TVec<float, 3>(1, 1, 2))[2]));
	EXPECT_EQ((FFloats{-2, -2, -2, -2}), Lanes4((-V)[2]));
	EXPECT_EQ((FBools{true, true, false, false}), Lanes4(All(V < Splat<3>(FReal(3.0f)) && V < Splat<3>(2.5f))));
	EXPECT_EQ((FBools{false, true, true, true}),
		Lanes4(Any(V == TVec<float, 3>(1, 3, 3) || V == TVec<float, 3>(2, 2, 3) || V == TVec<float, 3>(3, 0, 0))));
}

TEST(LanesVocabulary, Geometry)
{
	const TVec<float, 3> A(1, 2, 3);
	const TVec<float, 3> B(4, -5, 6);
	EXPECT_EQ(12, Dot(A, B));
	EXPECT_EQ(27, Cross(A, B)[0]);
	EXPECT_EQ(6, Cross(A, B)[1]);
	EXPECT_EQ(-13, Cross(A, B)[2]);
	EXPECT_EQ(5, Length(TVec<float, 2>(3, 4)));
	EXPECT_EQ(5, Distance(TVec<float, 2>(4, 5), TVec<float, 2>(1, 1)));
	EXPECT_FLOAT_EQ(0.6f, Normalize(TVec<float, 2>(3, 4))[0]);
	EXPECT_TRUE(std::isnan(Normalize(TVec<float, 2>(0, 0))[0]));
	EXPECT_EQ(-2, Reflect(TVec<float, 2>(1, 2), TVec<float, 2>(0, 1))[1]);
	EXPECT_EQ(-1, FaceForward(TVec<float, 2>(0, 1), TVec<float, 2>(0, 3), TVec<float, 2>(0, 1))[1]);
	EXPECT_EQ(1, FaceForward(TVec<float, 2>(0, 1), TVec<float, 2>(0, -3), TVec<float, 2>(0, 1))[1]);
}

TEST(LanesVocabulary, RefractionBendsAndReflectsTotally)
{
	// 45 degrees into a medium twice as dense: sin = sqrt(1/2) / 2.
	const float S = std::sqrt(0.5f);
	const TVec<float, 2> Bent = Refract(TVec<float, 2>(S, -S), TVec<float, 2>(0, 1), 0.5f);
	EXPECT_NEAR(S / 2, Bent[0], 1e-6);
	EXPECT_NEAR(-std::sqrt(1 - 0.125), Bent[1], 1e-6);
	EXPECT_EQ(0, Refract(TVec<float, 2>(S, -S), TVec<float, 2>(0, 1), 2.0f)[1]);
}

TEST(LanesVocabulary, Matrices)
{
	// Columns (1, 2), (3, 4), (5, 6).
	const TMat<float, 3, 2> M(TVec<float, 2>(1, 2), TVec<float, 2>(3, 4), TVec<float, 2>(5, 6));
	EXPECT_EQ(1 + 6 + 15, Mul(M, TVec<float, 3>(1, 2, 3))[0]);
	EXPECT_EQ(2 + 8 + 18, Mul(M, TVec<float, 3>(1, 2, 3))[1]);
	EXPECT_EQ(10 + 120, Mul(TVec<float, 2>(10, 20), M)[2] - 40);
	EXPECT_EQ(4, Transpose(M)[1][1]);
	EXPECT_EQ(1 + 9 + 25, Mul(M, Transpose(M))[0][0]);
	EXPECT_EQ(6, Mul(M, 2.0f)[1][0]);
	EXPECT_EQ(8, OuterProduct(TVec<float, 2>(1, 2), TVec<float, 2>(3, 4))[1][1]);
	EXPECT_EQ((FFloats{22, 22, 22, 22}), Lanes4(Mul(M, TVec<FReal, 3>(FReal(1.0f), FReal(2.0f), FReal(3.0f)))[0]));
}

TEST(LanesVocabulary, Determinants)
{
	EXPECT_EQ(-2, Determinant(TMat<float, 2, 2>(TVec<float, 2>(1, 3), TVec<float, 2>(2, 4))));
	EXPECT_EQ(
		-3, Determinant(TMat<float, 3, 3>(TVec<float, 3>(1, 4, 7), TVec<float, 3>(2, 5, 8), TVec<float, 3>(3, 6, 10))));
	const TMat<float, 4, 4> M(
		TVec<float, 4>(2, 0, 0, 1), TVec<float, 4>(0, 3, 0, 0), TVec<float, 4>(0, 1, 4, 0), TVec<float, 4>(1, 0, 0, 5));
	EXPECT_EQ(12 * 9, Determinant(M));
}

TEST(LanesVocabulary, BuffersGiveZeroOutsideAndDropStores)
{
	uint32_t Words[4] = {1, 2, 3, 0x3F800000u};
	const FKernelBuffer Buffer = {reinterpret_cast<uint8_t*>(Words), 12, 4, ETexelStorage::R32_UINT};
	EXPECT_EQ(2u, LoadBufferUint(Buffer, 4u));
	EXPECT_EQ(0u, LoadBufferUint(Buffer, 12u));
	EXPECT_EQ(0u, LoadBufferUint(Buffer, 9u));
	EXPECT_EQ(0u, LoadBufferUint(Buffer, 0xFFFFFFFEu));
	EXPECT_EQ((FUints{1, 2, 3, 0}), Lanes4(LoadBufferUint(Buffer, ToUint(LaneIndex<N>()) * 4u)));
	EXPECT_EQ(3u, BufferElements(Buffer));
	StoreBufferReal(FMask(LaneIndex<N>() != 0), Buffer, ToUint(LaneIndex<N>()) * 4u, FReal(1.0f));
	EXPECT_EQ(1u, Words[0]);
	EXPECT_EQ(0x3F800000u, Words[2]);
	EXPECT_EQ(1.0f, LoadBufferReal<float>(Buffer, 8u));
	EXPECT_EQ(1.0, LoadBufferReal<double>(Buffer, 8u));
	EXPECT_EQ(0x3F800000u, Words[3]);
}

TEST(LanesVocabulary, InterpolantsAreTakenAtPixelCentres)
{
	const FKernelInterpolant UV = {{0, 0, 0, 0}, {0.25, 0, 0, 0}, {0, 0.5, 0, 0}};
	EXPECT_EQ((FFloats{0.125f, 0.375f, 0.625f, 0.875f}), Lanes4(Interpolate<float>(UV, 0, LaneIndex<N>(), 7)));
	EXPECT_EQ((FFloats{3.75f, 3.75f, 3.75f, 3.75f}), Lanes4(Interpolate<float>(UV, 1, LaneIndex<N>(), 7)));
}

TEST(LanesVocabulary, TextureSizes)
{
	const FKernelMip Mips[2] = {{nullptr, 8, 6, 3, 0, 0}, {nullptr, 4, 3, 3, 0, 0}};
	const FKernelTexture Texture = {Mips, 2, ETexelStorage::R8_UNORM, 0, 0};
	EXPECT_EQ(3, TextureSize2D(Texture, 1)[1]);
	EXPECT_EQ(0, TextureSize2D(Texture, 2)[0]);
	EXPECT_EQ(3, TextureSize3D(Texture)[2]);
	EXPECT_EQ(2, TextureLevels(Texture));
}

TEST(LanesVocabulary, SamplingThroughTheVocabulary)
{
	float Texels[32] = {};
	for (int i = 0; i < 4; ++i)
	{
		Texels[i] = float(i);
	}
	const FKernelMip Mip = {reinterpret_cast<uint8_t*>(Texels), 4, 1, 1, 64, 64};
	const FKernelTexture Texture = {&Mip, 1, ETexelStorage::R32_FLOAT, 0, 0};
	const FKernelSampler Sampler = {
		EKernelFilter::Bilinear, EKernelAddress::Clamp, EKernelAddress::Clamp, EKernelAddress::Clamp, 8, 0, {}};
	const TVec<FReal, 2> UV((GRamp + 1.0f) / 4.0f, FReal(0.5f));
	const auto Color = SampleLevel2D(Texture, Sampler, UV, 0.0f);
	EXPECT_EQ((FFloats{0.5f, 1.5f, 2.5f, 3}), Lanes4(Color[0]));
	EXPECT_EQ(1, Color[3][0]);
	EXPECT_EQ((FFloats{0, 1, 2, 3}), Lanes4(Load2D<float>(Texture, TVec<FInt, 2>(LaneIndex<N>(), FInt(0)), 0)[0]));
	StoreTexture2D(FMask(true), Texture, TVec<FInt, 2>(LaneIndex<N>(), FInt(0)), Color);
	EXPECT_EQ(2.5f, Texels[2]);
}

} // namespace
} // namespace Drydock::Tests
