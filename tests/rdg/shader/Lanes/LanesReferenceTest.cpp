// Every operation on texels, in every format, at every float width, against the one-lane library that goes texel by
// texel: the same bits, from random pictures, coordinates and states; and none of it by the scalar way.
#include "LanesReferenceCases.h"

#include <string>
#include <vector>

namespace Drydock::Tests
{
namespace
{

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
		FLanesRandom Random{uint32_t(Storage)};
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
		[this](FLanesRandom& Random, FTestTexture& T)
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
		[this](FLanesRandom& Random, FTestTexture& T)
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
		[this](FLanesRandom& Random, FTestTexture& T)
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
		[this](FLanesRandom& Random, FTestTexture& T)
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
		[this](FLanesRandom& Random, FTestTexture& T)
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
std::vector<Scalar> RandomValues(FLanesRandom& Random)
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
		[this](FLanesRandom& Random, FTestTexture& T)
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
		[this](FLanesRandom& Random, FTestTexture& T)
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
		[this](FLanesRandom& Random, FTestTexture&)
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

} // namespace
} // namespace Drydock::Tests
