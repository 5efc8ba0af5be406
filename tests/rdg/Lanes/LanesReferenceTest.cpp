// Every operation on texels, in every format, at every float width, against the one-lane library that goes texel by
// texel: the same bits, from random pictures, coordinates and states; and none of it by the scalar way.
#include <gtest/gtest.h>

#include "LanesResources.h"
#include "LanesScalarCalls.h"
#include "LanesTestTexture.h"

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace Drydock::Tests
{
namespace
{

using Lanes::TSampling;

/** Lanes of a case: the widest pack, two of the middle one, four of the narrowest. */
constexpr int GLanes = 16;

using FFloats = std::array<float, GLanes>;
using FInts = std::array<int32_t, GLanes>;

constexpr EKernelFilter GFilters[] = {EKernelFilter::Point, EKernelFilter::Bilinear, EKernelFilter::Trilinear};
constexpr EKernelAddress GAddresses[] = {
	EKernelAddress::Wrap, EKernelAddress::Clamp, EKernelAddress::Mirror, EKernelAddress::Border};

class FRandom
{
public:
	explicit FRandom(uint32_t Seed)
		: Engine(Seed)
	{
	}
	int32_t Int(int32_t Low, int32_t High) { return std::uniform_int_distribution<int32_t>(Low, High)(Engine); }
	float Float(double Low, double High) { return float(std::uniform_real_distribution<double>(Low, High)(Engine)); }
	template<typename T, size_t Count>
	T Pick(const T (&From)[Count])
	{
		return From[Int(0, int32_t(Count) - 1)];
	}

	FKernelSampler Sampler()
	{
		return {Pick(GFilters), Pick(GAddresses), Pick(GAddresses), Pick(GAddresses), uint8_t(Int(0, 3) ? 8 : 0),
			Int(0, 3) ? 0.0f : Float(-1, 2), {Float(0, 1), Float(0, 1), Float(0, 1), Float(0, 1)}};
	}

	/** Normalised coordinates of a row of pixels or of scattered ones; now and then what is no place at all. */
	FFloats Coordinates(int32_t Size)
	{
		const float Rates[] = {0, 0, 1, 1, 2, 0.5f, -1, 0.3f, 5};
		const float Strange[] = {
			std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1e30f, 12345.678f, -0.0f};
		const float First = Float(-Size, 2 * Size);
		const float Rate = Pick(Rates);
		const bool bScattered = Int(0, 2) == 0;
		FFloats Result;
		for (int Lane = 0; Lane < GLanes; ++Lane)
		{
			const float Texel = bScattered ? Float(-1.5 * Size, 2.5 * Size) : First + Rate * float(Lane);
			Result[size_t(Lane)] = (Int(0, 1) ? Texel : std::floor(Texel) + 0.5f) / float(Size);
			if (Int(0, 99) == 0)
			{
				Result[size_t(Lane)] = Pick(Strange);
			}
		}
		return Result;
	}

	/** Texel indices, a few of them outside. */
	FInts Indices(int32_t Size)
	{
		const int32_t Strange[] = {-1, 0x7FFFFFFF, int32_t(0x80000000), 1 << 24};
		const int32_t Kind = Int(0, 2);
		const int32_t First = Int(-3, Size);
		FInts Result;
		for (int Lane = 0; Lane < GLanes; ++Lane)
		{
			Result[size_t(Lane)] = Kind == 0 ? First : Kind == 1 ? First + Lane : Int(-1, Size);
			if (Int(0, 59) == 0)
			{
				Result[size_t(Lane)] = Pick(Strange);
			}
		}
		return Result;
	}

	FInts Mask()
	{
		const int32_t Kind = Int(0, 2);
		FInts Result;
		for (int32_t& Lane : Result)
		{
			Lane = Kind == 0 ? -Int(0, 1) : -1;
		}
		return Result;
	}

	std::mt19937 Engine;
};

/** f(First lane) of each pack of N of a case. */
template<int N, typename F>
void ForEachPack(F f)
{
	for (int First = 0; First < GLanes; First += N)
	{
		f(First);
	}
}

/** Four channels of all lanes. */
template<typename Scalar>
using TOutput = std::array<std::array<Scalar, GLanes>, 4>;

/** Call(First, Out) for packs of N; Out is [4][N]. */
template<int N, typename Scalar, typename F>
TOutput<Scalar> Collect(F Call)
{
	TOutput<Scalar> Result;
	ForEachPack<N>(
		[&](int First)
		{
			alignas(64) Scalar Out[4 * N];
			Call(First, Out);
			for (int i = 0; i < 4 * N; ++i)
			{
				Result[size_t(i / N)][size_t(First + i % N)] = Out[i];
			}
		});
	return Result;
}

/** Runs f<N>() for one lane and for every width, and compares what it gives. */
template<typename F>
void ExpectTheSame(const std::string& What, F f)
{
	const auto Expected = f.template operator()<1>();
	const uint64_t ScalarCalls = GetScalarCalls();
	const auto Compare = [&](const auto& Actual, int N)
	{
		for (size_t i = 0; i < Expected.size(); ++i)
		{
			ASSERT_EQ(0, std::memcmp(&Expected[i], &Actual[i], sizeof(Expected[i])))
				<< What << ", " << N << " lanes, differs in part " << i;
		}
	};
	ASSERT_NO_FATAL_FAILURE(Compare(f.template operator()<4>(), 4));
	if (AreLanesSupported(false, 8))
	{
		ASSERT_NO_FATAL_FAILURE(Compare(f.template operator()<8>(), 8));
	}
	if (AreLanesSupported(false, 16))
	{
		ASSERT_NO_FATAL_FAILURE(Compare(f.template operator()<16>(), 16));
	}
	ASSERT_EQ(ScalarCalls, GetScalarCalls()) << What << " went lane by lane";
}

/** All but those of 64 bits a channel, which are for reference runs. */
std::vector<ETexelStorage> GetLaneStorages()
{
	std::vector<ETexelStorage> Storages;
	for (int Index = 0; Index < int(ETexelStorage::Count); ++Index)
	{
		if (GetTexelStorageInfo(ETexelStorage(Index)).BitsPerChannel <= 32)
		{
			Storages.push_back(ETexelStorage(Index));
		}
	}
	return Storages;
}

bool IsInteger(ETexelStorage Storage)
{
	return GetTexelStorageInfo(Storage).Kind == ETexelKind::Uint;
}

/** Runs with the processor's mode of kernels half of the time: denormals are zero. */
class FDenormalMode
{
public:
	explicit FDenormalMode(bool bFlush)
		: Mode(__builtin_ia32_stmxcsr())
	{
		__builtin_ia32_ldmxcsr(bFlush ? Mode | 0x8040 : Mode);
	}
	~FDenormalMode() { __builtin_ia32_ldmxcsr(Mode); }

private:
	uint32_t Mode;
};

class FLanesReference : public testing::TestWithParam<ETexelStorage>
{
protected:
	ETexelStorage Storage = GetParam();
	std::string Name = GetTexelStorageInfo(Storage).Name;

	/** f(Random, Texture) with pictures of many sizes. */
	template<typename F>
	void ForEachCase(int Count, int32_t MaxSlices, bool bIs3D, F f)
	{
		FRandom Random{uint32_t(Storage)};
		for (int Size = 0; Size < 6; ++Size)
		{
			FTestTexture T(
				Storage, Random.Int(1, 70), Random.Int(1, 20), Random.Int(1, MaxSlices), Random.Int(1, 3), bIs3D);
			T.FillRandom(Random.Engine(), 0, IsInteger(Storage) ? 300 : 1);
			for (int Case = 0; Case < Count; ++Case)
			{
				const FDenormalMode Mode(Case % 2 == 1);
				f(Random, T);
				if (HasFatalFailure())
				{
					return;
				}
			}
		}
	}
};

TEST_P(FLanesReference, Samples)
{
	ForEachCase(120, 1, false,
		[this](FRandom& Random, FTestTexture& T)
		{
			const FKernelSampler S = Random.Sampler();
			const FFloats U = Random.Coordinates(T.Mips[0].SizeX);
			const FFloats V = Random.Coordinates(T.Mips[0].SizeY);
			FFloats Levels = {};
			std::generate(Levels.begin(), Levels.end(), [&Random] { return Random.Float(-0.5, 3); });
			const bool bUniform = Random.Int(0, 1) != 0;
			ExpectTheSame(Name + " sample",
				[&]<int N>()
				{
					return Collect<N, float>(
						[&](int First, float* Out)
						{
							TSampling<float, N>::Sample2D(T.Texture, S, &U[First], &V[First], nullptr,
								&Levels[bUniform ? 0 : First], bUniform, Out);
						});
				});
		});
}

TEST_P(FLanesReference, LayersPerLane)
{
	ForEachCase(60, 5, false,
		[this](FRandom& Random, FTestTexture& T)
		{
			const FKernelSampler S = Random.Sampler();
			const FFloats U = Random.Coordinates(T.Mips[0].SizeX);
			const FFloats V = Random.Coordinates(T.Mips[0].SizeY);
			FFloats Layers = {};
			std::generate(Layers.begin(), Layers.end(), [&Random] { return Random.Float(-1, 6); });
			const float Level = 0;
			ExpectTheSame(Name + " layer",
				[&]<int N>()
				{
					return Collect<N, float>(
						[&](int First, float* Out) {
							TSampling<float, N>::Sample2D(
								T.Texture, S, &U[First], &V[First], &Layers[First], &Level, true, Out);
						});
				});
		});
}

TEST_P(FLanesReference, Volumes)
{
	ForEachCase(100, 12, true,
		[this](FRandom& Random, FTestTexture& T)
		{
			const FKernelSampler S = Random.Sampler();
			const FFloats U = Random.Coordinates(T.Mips[0].SizeX);
			const FFloats V = Random.Coordinates(T.Mips[0].SizeY);
			const FFloats W = Random.Coordinates(T.Mips[0].SizeZ);
			const float Level = Random.Float(0, 2);
			ExpectTheSame(Name + " volume",
				[&]<int N>()
				{
					return Collect<N, float>(
						[&](int First, float* Out) {
							TSampling<float, N>::Sample3D(
								T.Texture, S, &U[First], &V[First], &W[First], &Level, true, Out);
						});
				});
		});
}

TEST_P(FLanesReference, Gathers)
{
	ForEachCase(60, 1, false,
		[this](FRandom& Random, FTestTexture& T)
		{
			const FKernelSampler S = Random.Sampler();
			const FFloats U = Random.Coordinates(T.Mips[0].SizeX);
			const FFloats V = Random.Coordinates(T.Mips[0].SizeY);
			const int32_t Component = Random.Int(0, 3);
			ExpectTheSame(Name + " gather",
				[&]<int N>()
				{
					return Collect<N, float>(
						[&](int First, float* Out) {
							TSampling<float, N>::Gather(T.Texture, S, {{&U[First], &V[First]}}, Component, Out);
						});
				});
		});
}

TEST_P(FLanesReference, Loads)
{
	ForEachCase(100, 4, false,
		[this](FRandom& Random, FTestTexture& T)
		{
			const FInts X = Random.Indices(T.Mips[0].SizeX);
			const FInts Y = Random.Indices(T.Mips[0].SizeY);
			const FInts Z = Random.Indices(T.Mips[0].SizeZ);
			const FInts Mips = Random.Indices(T.Texture.NumMips);
			const bool bUniform = Random.Int(0, 1) != 0;
			const bool bSlices = Random.Int(0, 1) != 0;
			ExpectTheSame(Name + " load",
				[&]<int N>()
				{
					return Collect<N, float>(
						[&](int First, float* Out)
						{
							TSampling<float, N>::Load(T.Texture, &X[First], &Y[First], bSlices ? &Z[First] : nullptr,
								&Mips[bUniform ? 0 : First], bUniform, Out);
						});
				});
			if (!IsInteger(Storage) || HasFatalFailure())
			{
				return;
			}
			ExpectTheSame(Name + " load of integers",
				[&]<int N>()
				{
					return Collect<N, uint32_t>(
						[&](int First, uint32_t* Out)
						{
							TSampling<float, N>::LoadUint(T.Texture, &X[First], &Y[First],
								bSlices ? &Z[First] : nullptr, &Mips[bUniform ? 0 : First], bUniform, Out);
						});
				});
		});
}

/** Values for all lanes, channel by channel: of every magnitude, and what is no number. */
template<typename Scalar>
std::vector<Scalar> RandomValues(FRandom& Random)
{
	std::vector<Scalar> Values;
	for (int i = 0; i < 4 * GLanes; ++i)
	{
		const float Inf = std::numeric_limits<float>::infinity();
		const float Strange[] = {Inf, -Inf, 0, -0.0f, 65519.9f, 65520, 1, 1e-40f};
		if constexpr (std::is_same_v<Scalar, float>)
		{
			const float Plain = Random.Int(0, 1) ? Random.Float(-0.2, 1.2) : std::exp2(Random.Float(-20, 18));
			Values.push_back(Random.Int(0, 19) ? Plain : Random.Pick(Strange));
		}
		else
		{
			Values.push_back(Random.Engine() >> Random.Int(0, 31));
		}
	}
	return Values;
}

/** Lanes First to First + N of values that lie channel by channel. */
template<int N, typename Scalar>
std::array<Scalar, 4 * N> Cut(const std::vector<Scalar>& Values, int First)
{
	std::array<Scalar, 4 * N> Result;
	for (size_t i = 0; i < 4 * N; ++i)
	{
		Result[i] = Values[i / N * GLanes + size_t(First) + i % N];
	}
	return Result;
}

TEST_P(FLanesReference, Stores)
{
	ForEachCase(60, 3, false,
		[this](FRandom& Random, FTestTexture& T)
		{
			const FInts X = Random.Indices(T.Mips[0].SizeX);
			const FInts Y = Random.Indices(T.Mips[0].SizeY);
			const FInts Z = Random.Indices(T.Mips[0].SizeZ);
			const FInts Mask = Random.Mask();
			const bool bSlices = Random.Int(0, 1) != 0;
			const uint8_t bSaturate = uint8_t(Random.Int(0, 1));
			const std::vector<float> Values = RandomValues<float>(Random);
			const std::vector<uint32_t> Codes = RandomValues<uint32_t>(Random);
			const FKernelMip& M = T.Mips[0];
			const auto Run = [&]<int N>(auto Store)
			{
				FTestTexture Copy(Storage, M.SizeX, M.SizeY, M.SizeZ);
				Copy.Texture.bSaturateStore = bSaturate;
				ForEachPack<N>([&](int First) { Store(Copy.Texture, First, bSlices ? &Z[First] : nullptr); });
				return Copy.GetMemory();
			};
			ExpectTheSame(Name + " store",
				[&]<int N>()
				{
					return Run.template operator()<N>(
						[&](const FKernelTexture& To, int First, const int32_t* Slices) {
							TSampling<float, N>::Store(
								To, &Mask[First], &X[First], &Y[First], Slices, Cut<N>(Values, First).data());
						});
				});
			if (!IsInteger(Storage) || HasFatalFailure())
			{
				return;
			}
			ExpectTheSame(Name + " store of integers",
				[&]<int N>()
				{
					return Run.template operator()<N>(
						[&](const FKernelTexture& To, int First, const int32_t* Slices) {
							TSampling<float, N>::StoreUint(
								To, &Mask[First], &X[First], &Y[First], Slices, Cut<N>(Codes, First).data());
						});
				});
		});
}

TEST_P(FLanesReference, Targets)
{
	ForEachCase(100, 1, false,
		[this](FRandom& Random, FTestTexture& T)
		{
			FKernelTarget State = {};
			State.WriteMask = uint8_t(Random.Int(0, 2) ? 15 : Random.Int(0, 15));
			State.bBlend = uint8_t(Random.Int(0, 3) != 0);
			State.ColorOp = EKernelBlendOp(Random.Int(0, 4));
			State.AlphaOp = EKernelBlendOp(Random.Int(0, 4));
			State.ColorSource = EKernelBlendFactor(Random.Int(0, 11));
			State.ColorDest = EKernelBlendFactor(Random.Int(0, 11));
			State.AlphaSource = EKernelBlendFactor(Random.Int(0, 11));
			State.AlphaDest = EKernelBlendFactor(Random.Int(0, 11));
			const uint8_t bSaturate = uint8_t(Random.Int(0, 1));
			const FKernelMip& M = T.Mips[0];
			const int32_t X = Random.Int(0, M.SizeX - 1);
			const int32_t Y = Random.Int(0, M.SizeY);
			const FInts Mask = Random.Mask();
			const std::vector<float> Values = RandomValues<float>(Random);
			const uint32_t Seed = Random.Engine();
			ExpectTheSame(Name + " target, operations " + std::to_string(int(State.ColorOp)) + " " +
							  std::to_string(int(State.AlphaOp)) + ", write mask " + std::to_string(State.WriteMask),
				[&]<int N>()
				{
					FTestTexture Copy(Storage, M.SizeX, M.SizeY);
					Copy.FillRandom(Seed, 0, IsInteger(Storage) ? 300 : 1);
					FKernelTarget Target = State;
					Target.Texture = Copy.Texture;
					Target.Texture.bSaturateStore = bSaturate;
					ForEachPack<N>(
						[&](int First) {
							TSampling<float, N>::StoreTarget(
								Target, &Mask[First], X + First, Y, Cut<N>(Values, First).data());
						});
					return Copy.GetMemory();
				});
		});
}

TEST_P(FLanesReference, TypedBuffers)
{
	ForEachCase(40, 1, false,
		[this](FRandom& Random, FTestTexture&)
		{
			const uint32_t Bytes = GetTexelStorageInfo(Storage).BytesPerTexel;
			const uint32_t NumElements = uint32_t(Random.Int(1, 50));
			std::vector<uint8_t> Memory(NumElements * Bytes + size_t(Random.Int(0, 3)));
			// Numbers in every format: no exponent of ones.
			std::generate(Memory.begin(), Memory.end(), [&Random] { return uint8_t(Random.Int(0, 0x3B)); });
			const FInts Index = Random.Indices(int32_t(NumElements));
			const FInts Mask = Random.Mask();
			const std::vector<float> Values = RandomValues<float>(Random);
			const auto* const Elements = reinterpret_cast<const uint32_t*>(Index.data());
			const auto View = [&](std::vector<uint8_t>& Data)
			{
				return FKernelBuffer{Data.data(), uint32_t(Data.size()), Bytes, Storage};
			};
			ExpectTheSame(Name + " load of elements",
				[&]<int N>()
				{
					return Collect<N, float>([&](int First, float* Out)
						{ TSampling<float, N>::LoadTyped(View(Memory), Elements + First, Out); });
				});
			ExpectTheSame(Name + " store of elements",
				[&]<int N>()
				{
					std::vector<uint8_t> Copy = Memory;
					ForEachPack<N>(
						[&](int First) {
							TSampling<float, N>::StoreTyped(
								View(Copy), &Mask[First], Elements + First, Cut<N>(Values, First).data());
						});
					return Copy;
				});
			if (!IsInteger(Storage))
			{
				return;
			}
			ExpectTheSame(Name + " integers of elements",
				[&]<int N>()
				{
					return Collect<N, uint32_t>([&](int First, uint32_t* Out)
						{ TSampling<float, N>::LoadTypedUint(View(Memory), Elements + First, Out); });
				});
		});
}

INSTANTIATE_TEST_SUITE_P(EveryStorage, FLanesReference, testing::ValuesIn(GetLaneStorages()),
	[](const testing::TestParamInfo<ETexelStorage>& Info) { return GetTexelStorageInfo(Info.param).Name; });

// ---- Every code, every tie.

/** A row of values in one channel, stored and read back as bytes. */
template<int N>
std::vector<uint8_t> StoreReds(ETexelStorage Storage, const std::vector<float>& Reds)
{
	const size_t Bytes = GetTexelStorageInfo(Storage).BytesPerTexel;
	FTestTexture T(Storage, N, 1);
	std::vector<uint8_t> Result;
	for (size_t i = 0; i + N <= Reds.size(); i += N)
	{
		alignas(64) int32_t X[N], Y[N] = {}, Mask[N];
		float Value[4 * N] = {};
		for (int Lane = 0; Lane < N; ++Lane)
		{
			X[Lane] = Lane;
			Mask[Lane] = -1;
			Value[Lane] = Reds[i + size_t(Lane)];
		}
		TSampling<float, N>::Store(T.Texture, Mask, X, Y, nullptr, Value);
		Result.insert(Result.end(), T.At(0, 0), T.At(0, 0) + N * Bytes);
	}
	return Result;
}

/** Places between codes, and the floats around them. */
std::vector<float> AroundPlaces(const std::function<double(int)>& Place, int Count)
{
	std::vector<float> Values;
	for (int i = 0; i < Count; ++i)
	{
		float X = float(Place(i));
		X = std::nextafter(std::nextafter(X, -1.0f), -1.0f);
		for (int Step = 0; Step < 5; ++Step)
		{
			Values.push_back(X);
			X = std::nextafter(X, 2.0f);
		}
	}
	Values.resize(Values.size() / 16 * 16);
	return Values;
}

TEST(LanesReferenceCodes, UnormIsRoundedToTheNearestAtEveryTie)
{
	for (const auto& [Storage, Max] : {std::pair{ETexelStorage::R8_UNORM, 255}, {ETexelStorage::R16_UNORM, 65535},
			 {ETexelStorage::RGB10A2_UNORM, 1023}})
	{
		const std::vector<float> Values = AroundPlaces([Max = Max](int i) { return (i + 0.5) / Max; }, Max);
		ExpectTheSame("ties", [Storage = Storage, &Values]<int N>() { return StoreReds<N>(Storage, Values); });
	}
}

TEST(LanesReferenceCodes, SrgbChangesAtEveryThreshold)
{
	const auto Threshold = [](int Code)
	{
		const double Encoded = (Code + 0.5) / 255;
		return Encoded <= 0.04045 ? Encoded / 12.92 : std::pow((Encoded + 0.055) / 1.055, 2.4);
	};
	std::vector<float> Values = AroundPlaces(Threshold, 255);
	std::mt19937 Engine(3);
	for (int i = 0; i < 160000; ++i)
	{
		Values.push_back(std::exp2(-float(Engine()) / 4294967296.0f * 15));
	}
	for (float Strange : {0.0f, 1.0f, 2.0f, -1.0f, 1e-30f, 0x1p-13f, std::nextafter(1.0f, 0.0f), -0.0f,
			 std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
	{
		Values.insert(Values.end(), 16, Strange);
	}
	ExpectTheSame("sRGB", [&Values]<int N>() { return StoreReds<N>(ETexelStorage::RGBA8_SRGB, Values); });
}

TEST(LanesReferenceCodes, EveryCodeOf16BitUnormIsDividedExactly)
{
	FTestTexture T(ETexelStorage::R16_UNORM, 65536, 1);
	for (int32_t Code = 0; Code < 65536; ++Code)
	{
		const uint16_t Texel = uint16_t(Code);
		std::memcpy(T.At(Code, 0), &Texel, 2);
	}
	ExpectTheSame("codes",
		[&T]<int N>()
		{
			std::vector<float> Result;
			for (int32_t First = 0; First < 65536; First += N)
			{
				alignas(64) int32_t X[N], Y[N] = {};
				const int32_t Mip = 0;
				float Out[4 * N];
				for (int Lane = 0; Lane < N; ++Lane)
				{
					X[Lane] = First + Lane;
				}
				TSampling<float, N>::Load(T.Texture, X, Y, nullptr, &Mip, true, Out);
				Result.insert(Result.end(), Out, Out + N);
			}
			return Result;
		});
	const int32_t X = 12345, Y = 0, Mip = 0;
	float Out[4];
	TSampling<float, 1>::Load(T.Texture, &X, &Y, nullptr, &Mip, true, Out);
	EXPECT_EQ(float(12345.0 / 65535), Out[0]);
}

TEST(LanesReferenceCodes, TheScalarWayIsCounted)
{
	FTestTexture T(ETexelStorage::RGBA64_FLOAT, 8, 8);
	const float Coordinates[4] = {0.1f, 0.2f, 0.3f, 0.4f};
	const float Level = 0;
	float Out[16];
	const uint64_t Before = GetScalarCalls(EScalarCall::Sample);
	TSampling<float, 4>::Sample2D(T.Texture, MakeSampler(EKernelFilter::Bilinear, EKernelAddress::Clamp), Coordinates,
		Coordinates, nullptr, &Level, true, Out);
	EXPECT_EQ(Before + 1, GetScalarCalls(EScalarCall::Sample));
	EXPECT_STREQ("sample", GetScalarCallName(EScalarCall::Sample));
}

} // namespace
} // namespace Drydock::Tests
