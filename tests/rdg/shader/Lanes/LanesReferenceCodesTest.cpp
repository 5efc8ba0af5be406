// Every code of a format and every tie between two, at every width; and that calls of the scalar way are counted.
#include "LanesReferenceCases.h"

#include <functional>
#include <utility>
#include <vector>

namespace Drydock::Tests
{
namespace
{

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
