// Texel stores and render targets: the bits of EncodeTexel in every storage at every width, masks, edges, blending.
#include <gtest/gtest.h>

#include "LanesResources.h"
#include "LanesTestTexture.h"

#include <bit>
#include <cmath>
#include <limits>

namespace Drydock::Tests
{
namespace
{

using Lanes::TSampling;
using FTexel = FTestTexture::FTexel;

/** Values that rounding, clamping and overflow treat differently, and random ones of every magnitude. */
template<typename Real>
std::vector<Real> StrangeValues(uint32_t Seed, size_t Count)
{
	const double Inf = std::numeric_limits<double>::infinity();
	std::vector<Real> Values;
	for (double X :
		{0.0, -0.0, 1.0, -1.0, 0.5, 0.5 / 255, 1.5 / 255, 2.5 / 255, 254.5 / 255, 65504.0, 65519.99, 65520.0, 65535.9,
			1e6, -65520.0, 64512.0, 65024.0, 65280.0, 5.9e-8, 2.9802322387695312e-8, 2.98023259e-8, 6.1e-5,
			6.09755516e-5, 7.4e-6, 4.7e-7, 1e-30, 3e38, Inf, -Inf, std::nan(""), 254.5, 255.5, 300.0, 4294967295.0, 5e9,
			1 + 1.0 / 2048, 1 + 3.0 / 2048, 1 + 1.0 / 128, 1 + 3.0 / 128, 1 + 1.0 / 64, 1 + 1.0 / 32})
	{
		Values.push_back(Real(X));
	}
	std::mt19937 Engine(Seed);
	std::uniform_real_distribution<double> Exponent(-30, 18);
	while (Values.size() < Count)
	{
		Values.push_back(Real(std::exp2(Exponent(Engine)) * (Engine() % 4 ? 1 : -1)));
	}
	return Values;
}

TEST(LanesStore, EveryStorageGetsTheBitsOfTheReference)
{
	for (int Index = 0; Index < int(ETexelStorage::Count); ++Index)
	{
		const ETexelStorage Storage = ETexelStorage(Index);
		const size_t Bytes = GetTexelStorageInfo(Storage).BytesPerTexel;
		for (uint8_t bSaturate : {0, 1})
		{
			ForEachWidth(
				[&]<typename Real, int N>()
				{
					const std::vector<Real> Values = StrangeValues<Real>(uint32_t(Index), 4096);
					FTestTexture T(Storage, N, 1);
					T.Texture.bSaturateStore = bSaturate;
					for (size_t First = 0; First + 4 * N <= Values.size(); First += N)
					{
						alignas(64) int32_t X[N], Y[N], Mask[N];
						for (int Lane = 0; Lane < N; ++Lane)
						{
							X[Lane] = Lane;
							Y[Lane] = 0;
							Mask[Lane] = -1;
						}
						TSampling<Real, N>::Store(T.Texture, Mask, X, Y, nullptr, &Values[First]);
						for (int Lane = 0; Lane < N; ++Lane)
						{
							const size_t i = First + size_t(Lane);
							const Real RGBA[4] = {Values[i], Values[i + N], Values[i + 2 * N], Values[i + 3 * N]};
							uint8_t Expected[32];
							EncodeTexel(Storage, RGBA, Expected, bSaturate != 0);
							ASSERT_EQ(0, std::memcmp(Expected, T.At(Lane, 0), Bytes))
								<< GetTexelStorageInfo(Storage).Name << " of " << RGBA[0] << " " << RGBA[1] << " "
								<< RGBA[2] << " " << RGBA[3] << " saturate " << int(bSaturate) << " lanes " << N;
						}
					}
				});
			if (HasFatalFailure())
			{
				return;
			}
		}
	}
}

TEST(LanesStore, R11G11B10RoundsEveryTieToEven)
{
	// Midpoints of all neighbours with 6 mantissa bits, and one float below and above them.
	for (uint32_t Code = 0; Code + 1 < 0x7C0; Code += 4)
	{
		float Values[16] = {};
		for (int Lane = 0; Lane < 4; ++Lane)
		{
			const double Middle = (DecodeUnsignedMiniFloat(Code + uint32_t(Lane), 6) +
									  DecodeUnsignedMiniFloat(std::min(Code + uint32_t(Lane) + 1, 0x7BFu), 6)) /
								  2;
			Values[Lane] = float(Middle);
			Values[4 + Lane] = std::nextafter(float(Middle), 0.0f);
			Values[8 + Lane] = std::nextafter(float(Middle), 1e9f);
		}
		FTestTexture T(ETexelStorage::R11G11B10_FLOAT, 4, 1);
		const int32_t X[4] = {0, 1, 2, 3};
		const int32_t Y[4] = {};
		const int32_t Mask[4] = {-1, -1, -1, -1};
		TSampling<float, 4>::Store(T.Texture, Mask, X, Y, nullptr, Values);
		for (int Lane = 0; Lane < 4; ++Lane)
		{
			uint32_t Packed;
			std::memcpy(&Packed, T.At(Lane, 0), 4);
			ASSERT_EQ(EncodeUnsignedMiniFloat(Values[Lane], 6), Packed & 0x7FF) << Values[Lane];
			ASSERT_EQ(EncodeUnsignedMiniFloat(Values[4 + Lane], 6), (Packed >> 11) & 0x7FF) << Values[4 + Lane];
			ASSERT_EQ(EncodeUnsignedMiniFloat(Values[8 + Lane], 5), Packed >> 22) << Values[8 + Lane];
		}
	}
}

TEST(LanesStore, MaskedAndOutsideLanesLeaveMemoryAlone)
{
	ForEachWidth(
		[&]<typename Real, int N>()
		{
			for (ETexelStorage Storage : {ETexelStorage::RGBA32_FLOAT, ETexelStorage::RGBA16_FLOAT,
					 ETexelStorage::R8_UNORM, ETexelStorage::RG8_UNORM})
			{
				FTestTexture T(Storage, N + 1, 3);
				alignas(64) int32_t X[N], Y[N], Mask[N];
				Real Value[4 * N];
				for (int Lane = 0; Lane < N; ++Lane)
				{
					X[Lane] = 2 + Lane; // the last lane is outside
					Y[Lane] = 1;
					Mask[Lane] = Lane == 0 ? 0 : -1;
				}
				std::fill_n(Value, 4 * N, Real(1));
				TSampling<Real, N>::Store(T.Texture, Mask, X, Y, nullptr, Value);
				T.ForEachTexel([&](int32_t PX, int32_t PY, int32_t, int32_t)
					{ EXPECT_EQ(PY == 1 && PX >= 3 ? 1 : 0, T.Read(PX, PY)[0]) << PX << "," << PY << " lanes " << N; });
				uint8_t Margin = *(T.At(N, 2) + GetTexelStorageInfo(Storage).BytesPerTexel + 64);
				EXPECT_EQ(0xA5, Margin);
			}
		});
}

TEST(LanesStore, ScatteredLanesFindTheirTexels)
{
	ForEachWidth(
		[&]<typename Real, int N>()
		{
			FTestTexture T(ETexelStorage::R32_FLOAT, 8, 8, 2, 1, true);
			alignas(64) int32_t X[N], Y[N], Z[N], Mask[N];
			Real Value[4 * N];
			for (int Lane = 0; Lane < N; ++Lane)
			{
				X[Lane] = (Lane * 3) % 8;
				Y[Lane] = Lane / 2;
				Z[Lane] = Lane % 2;
				Mask[Lane] = -1;
				Value[Lane] = Real(Lane + 1);
			}
			TSampling<Real, N>::Store(T.Texture, Mask, X, Y, Z, Value);
			for (int Lane = 0; Lane < N; ++Lane)
			{
				EXPECT_EQ(Lane + 1, T.Read(X[Lane], Y[Lane], Z[Lane])[0]);
			}
		});
}

TEST(LanesStore, IntegersAreClampedToTheChannel)
{
	ForEachWidth(
		[&]<typename Real, int N>()
		{
			FTestTexture T(ETexelStorage::RG8_UINT, N, 1);
			alignas(64) int32_t X[N], Y[N], Mask[N];
			uint32_t Value[4 * N];
			for (int Lane = 0; Lane < N; ++Lane)
			{
				X[Lane] = Lane;
				Y[Lane] = 0;
				Mask[Lane] = -1;
			}
			std::fill_n(Value, 4 * N, 1000u);
			TSampling<Real, N>::StoreUint(T.Texture, Mask, X, Y, nullptr, Value);
			EXPECT_EQ((FTexel{255, 255, 0, 1}), T.Read(N - 1, 0));
		});
}

// ---- Render targets.

FKernelTarget MakeTarget(const FKernelTexture& Texture)
{
	return {Texture, 15, 0, EKernelBlendOp::Add, EKernelBlendFactor::One, EKernelBlendFactor::Zero, EKernelBlendOp::Add,
		EKernelBlendFactor::One, EKernelBlendFactor::Zero};
}

/** Stores one colour over a cleared one-texel target and reads it back. */
template<typename Real, int N>
FTexel StoreOver(FTestTexture& T, const FKernelTarget& Target, const FTexel& Old, const FTexel& New)
{
	T.Write(Old, 0, 0);
	alignas(64) int32_t Mask[N];
	Real Value[4 * N];
	for (int Lane = 0; Lane < N; ++Lane)
	{
		Mask[Lane] = -1;
		for (int c = 0; c < 4; ++c)
		{
			Value[c * N + Lane] = Real(New[size_t(c)]);
		}
	}
	TSampling<Real, N>::StoreTarget(Target, Mask, 0, 0, Value);
	return T.Read(0, 0);
}

TEST(LanesTarget, BlendOperationsAndFactors)
{
	const FTexel Old = {1, 2, 3, 0.5};
	const FTexel New = {4, 5, 6, 0.25};
	struct FCase
	{
		EKernelBlendOp Op;
		EKernelBlendFactor Source;
		EKernelBlendFactor Dest;
		FTexel Expected;
	};
	using Op = EKernelBlendOp;
	using Factor = EKernelBlendFactor;
	const FCase Cases[] = {
		{Op::Add, Factor::One, Factor::One, {5, 7, 9, 0.75}},
		{Op::Add, Factor::SourceAlpha, Factor::InverseSourceAlpha, {1.75, 2.75, 3.75, 0.4375}},
		{Op::Add, Factor::DestColor, Factor::Zero, {4, 10, 18, 0.125}},
		{Op::Add, Factor::Zero, Factor::SourceColor, {4, 10, 18, 0.125}},
		{Op::Add, Factor::DestAlpha, Factor::InverseDestAlpha, {2.5, 3.5, 4.5, 0.375}},
		{Op::Add, Factor::InverseSourceColor, Factor::InverseDestColor, {-12, -22, -36, 0.4375}},
		{Op::Add, Factor::ConstantBlendFactor, Factor::InverseConstantBlendFactor, {4, 5, 6, 0.25}},
		{Op::Subtract, Factor::One, Factor::One, {3, 3, 3, -0.25}},
		{Op::ReverseSubtract, Factor::One, Factor::One, {-3, -3, -3, 0.25}},
		{Op::Min, Factor::Zero, Factor::Zero, {1, 2, 3, 0.25}},
		{Op::Max, Factor::Zero, Factor::Zero, {4, 5, 6, 0.5}},
	};
	for (const FCase& Case : Cases)
	{
		ForEachWidth(
			[&]<typename Real, int N>()
			{
				FTestTexture T(ETexelStorage::RGBA32_FLOAT, 1, 1);
				const FKernelTarget Target = {
					T.Texture, 15, 1, Case.Op, Case.Source, Case.Dest, Case.Op, Case.Source, Case.Dest};
				EXPECT_EQ(Case.Expected, (StoreOver<Real, N>(T, Target, Old, New)))
					<< int(Case.Op) << " " << int(Case.Source) << " " << int(Case.Dest);
			});
	}
}

TEST(LanesTarget, ColourAndAlphaBlendApart)
{
	FTestTexture T(ETexelStorage::RGBA32_FLOAT, 1, 1);
	FKernelTarget Target = MakeTarget(T.Texture);
	Target.bBlend = 1;
	Target.ColorDest = EKernelBlendFactor::One;
	EXPECT_EQ((FTexel{3, 3, 3, 7}), (StoreOver<float, 4>(T, Target, {1, 1, 1, 1}, {2, 2, 2, 7})));
}

TEST(LanesTarget, AFactorOfZeroRemovesNan)
{
	FTestTexture T(ETexelStorage::RGBA32_FLOAT, 1, 1);
	FKernelTarget Target = MakeTarget(T.Texture);
	Target.bBlend = 1;
	const double Nan = std::nan("");
	EXPECT_EQ((FTexel{2, 2, 2, 2}), (StoreOver<float, 4>(T, Target, {Nan, Nan, Nan, Nan}, {2, 2, 2, 2})));
}

TEST(LanesTarget, TheWriteMaskKeepsTheOtherChannels)
{
	for (ETexelStorage Storage : {ETexelStorage::RGBA8_UNORM, ETexelStorage::BGRA8_UNORM, ETexelStorage::RGB10A2_UNORM,
			 ETexelStorage::RGBA16_FLOAT, ETexelStorage::RGBA64_FLOAT})
	{
		ForEachWidth(
			[&]<typename Real, int N>()
			{
				FTestTexture T(Storage, 1, 1);
				FKernelTarget Target = MakeTarget(T.Texture);
				Target.WriteMask = 1 | 4;
				EXPECT_EQ((FTexel{1, 0, 1, 0}), (StoreOver<Real, N>(T, Target, {0, 0, 0, 0}, {1, 1, 1, 1})))
					<< GetTexelStorageInfo(Storage).Name;
			});
	}
	FTestTexture T(ETexelStorage::R11G11B10_FLOAT, 1, 1);
	FKernelTarget Target = MakeTarget(T.Texture);
	Target.WriteMask = 2;
	EXPECT_EQ((FTexel{1, 8, 4, 1}), (StoreOver<float, 4>(T, Target, {1, 2, 4, 0}, {8, 8, 8, 8})));
}

TEST(LanesTarget, IntegersAreClampedToTheFormatAndMasked)
{
	using Lanes::TInt, Lanes::TUint;
	FTestTexture T(ETexelStorage::RGBA8_UINT, 5, 1);
	T.Write({1, 2, 3, 4}, 4, 0);
	FKernelTarget Target = MakeTarget(T.Texture);
	Target.WriteMask = 5;
	const TInt<4> Lane = Lanes::LaneIndex<4>();
	const TUint<4> Value = AsUint(Lane) + TUint<4>(252u);
	StoreTarget<float, 4>(
		Lane != TInt<4>(1), Target, 1, 0, Lanes::TVec<TUint<4>, 4>(Value, Value + Value, Value, Value));
	EXPECT_EQ((FTexel{0, 0, 0, 0}), T.Read(0, 0));
	EXPECT_EQ((FTexel{252, 0, 252, 0}), T.Read(1, 0));
	EXPECT_EQ((FTexel{0, 0, 0, 0}), T.Read(2, 0)); // off
	EXPECT_EQ((FTexel{255, 2, 255, 4}), T.Read(4, 0));
	Target.WriteMask = 15;
	StoreTarget<float, 4>(
		Lane == TInt<4>(0), Target, 0, 0, Lanes::TVec<TUint<4>, 4>(Value, Value + Value, Value, Value));
	EXPECT_EQ((FTexel{252, 255, 252, 252}), T.Read(0, 0)); // 504 is above the range
}

TEST(LanesTarget, TheTailOfARowIsMasked)
{
	ForEachWidth(
		[&]<typename Real, int N>()
		{
			FTestTexture T(ETexelStorage::RGBA16_FLOAT, N + 1, 2);
			alignas(64) int32_t Mask[N];
			Real Value[4 * N];
			std::fill_n(Mask, N, -1);
			std::fill_n(Value, 4 * N, Real(3));
			TSampling<Real, N>::StoreTarget(MakeTarget(T.Texture), Mask, N, 0, Value);
			EXPECT_EQ(3, T.Read(N, 0)[0]);
			EXPECT_EQ(0, T.Read(N - 1, 0)[0]);
			EXPECT_EQ(0, T.Read(0, 1)[0]);
		});
}

} // namespace
} // namespace Drydock::Tests
