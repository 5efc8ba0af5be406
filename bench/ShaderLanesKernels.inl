// Body of ShaderLanesKernels.h: included with DRYDOCK_BENCH_LANES and DRYDOCK_BENCH_GETTER set. Lane half: what the
// emitter writes for these shaders, one statement per SPIR-V instruction, by hand. Scalar half: as one would write it
// without lanes, same storage, same maths, F16C for halves.
#include <immintrin.h>

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "Lanes.h"
#include "ShaderLanesKernels.h"

namespace Drydock::Bench
{
namespace
{

// ---- Lanes.

using namespace Drydock::Lanes;

constexpr int N = DRYDOCK_BENCH_LANES;
using FReal = TReal<float, N>;
using FInt1 = TInt<N>;
using FMask1 = TMask<N>;
using FVec2 = TVec<FReal, 2>;
using FVec3 = TVec<FReal, 3>;
using FVec4 = TVec<FReal, 4>;

const FKernelSampler GSampler = {
	EKernelFilter::Bilinear, EKernelAddress::Clamp, EKernelAddress::Clamp, EKernelAddress::Clamp, 8, 0, {0, 0, 0, 0}};

/** Main(X, Y, Mask) for every group of N pixels. */
template<typename F>
void ForEachGroup(const FKernelTexture& Output, F Main)
{
	const FKernelMip& Mip = Output.Mips[0];
	for (int32_t Y = 0; Y < Mip.SizeY; ++Y)
	{
		for (int32_t X0 = 0; X0 < Mip.SizeX; X0 += N)
		{
			const FInt1 X = FInt1(X0) + LaneIndex<N>();
			Main(X, Y, X < FInt1(Mip.SizeX));
		}
	}
}

FKernelTarget MakeTarget(const FKernelTexture& Texture)
{
	return {Texture, 15, 0, EKernelBlendOp::Add, EKernelBlendFactor::One, EKernelBlendFactor::Zero, EKernelBlendOp::Add,
		EKernelBlendFactor::One, EKernelBlendFactor::Zero};
}

void KawaseDownLanes(const FPass& Pass)
{
	const TVec<float, 2> ViewSize(float(Pass.Input.Mips[0].SizeX), float(Pass.Input.Mips[0].SizeY));
	const auto HalfPixel = 0.5f / ViewSize * 1.0f;
	ForEachGroup(Pass.Output,
		[&](FInt1 X, int32_t Y, FMask1 Mask)
		{
			const TVec<FInt1, 2> Id(X, FInt1(Y));
			const auto UV = (ToReal<float>(Id) * 2.0f + 1.0f) / ViewSize;
			auto Sum = SampleLevel2D(Pass.Input, GSampler, UV, 0.0f) * 4.0f;
			Sum = Sum + SampleLevel2D(Pass.Input, GSampler, UV - HalfPixel, 0.0f);
			Sum = Sum + SampleLevel2D(Pass.Input, GSampler, UV + HalfPixel, 0.0f);
			const TVec<float, 2> Other(HalfPixel[0], -HalfPixel[1]);
			Sum = Sum + SampleLevel2D(Pass.Input, GSampler, UV + Other, 0.0f);
			Sum = Sum + SampleLevel2D(Pass.Input, GSampler, UV - Other, 0.0f);
			StoreTexture2D(Mask, Pass.Output, Id, Sum / 8.0f);
		});
}

void BloomSetupLanes(const FPass& Pass)
{
	const TVec<float, 2> Inverse(1.0f / float(Pass.Input.Mips[0].SizeX), 1.0f / float(Pass.Input.Mips[0].SizeY));
	const FKernelTarget Target = MakeTarget(Pass.Output);
	const float Exposure = 1.0f;
	const float Threshold = 0.5f;
	ForEachGroup(Pass.Output,
		[&](FInt1 X, int32_t Y, FMask1 Mask)
		{
			const FVec2 UV = (ToReal<float>(TVec<FInt1, 2>(X, FInt1(Y))) + 0.5f) * Inverse;
			const FVec4 SceneColor = SampleLevel2D(Pass.Input, GSampler, UV, 0.0f);
			FVec3 LinearColor = Min(Swizzle<0, 1, 2>(SceneColor), Splat<3>(65536.0f));
			const FReal Luminance = Dot(LinearColor, TVec<float, 3>(0.3f, 0.59f, 0.11f)) * Exposure;
			LinearColor = LinearColor * Saturate((Luminance - Threshold) * 0.5f);
			StoreTarget(Mask, Target, X[0], Y, FVec4(LinearColor[0], LinearColor[1], LinearColor[2], FReal(0.0f)));
		});
}

constexpr float GWeights[13] = {0.0044f, 0.0175f, 0.0540f, 0.0970f, 0.1210f, 0.1330f, 0.1462f, 0.1330f, 0.1210f,
	0.0970f, 0.0540f, 0.0175f, 0.0044f};

void BlurLanes(const FPass& Pass)
{
	const TVec<float, 2> Inverse(1.0f / float(Pass.Input.Mips[0].SizeX), 1.0f / float(Pass.Input.Mips[0].SizeY));
	const FKernelTarget Target = MakeTarget(Pass.Output);
	ForEachGroup(Pass.Output,
		[&](FInt1 X, int32_t Y, FMask1 Mask)
		{
			const FVec2 UV = (ToReal<float>(TVec<FInt1, 2>(X, FInt1(Y))) + 0.5f) * Inverse;
			FVec4 Sum(FReal(0.0f), FReal(0.0f), FReal(0.0f), FReal(0.0f));
			for (int32_t i = 0; i < 13; ++i)
			{
				const FVec2 Tap(UV[0], UV[1] + Inverse[1] * float(i - 6));
				Sum = Sum + SampleLevel2D(Pass.Input, GSampler, Tap, 0.0f) * GWeights[i];
			}
			StoreTarget(Mask, Target, X[0], Y, Sum);
		});
}

// ---- Scalar, with GLM.

struct FScalarTexture
{
	const FKernelMip& Mip;
	bool bHalf;

	glm::vec4 Load(int X, int Y) const
	{
		const uint8_t* Row = Mip.Data + size_t(Y) * size_t(Mip.RowPitch);
		glm::vec4 Texel;
		if (bHalf)
		{
			const __m128 Values = _mm_cvtph_ps(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(Row + size_t(X) * 8)));
			std::memcpy(&Texel, &Values, sizeof(Texel));
		}
		else
		{
			std::memcpy(&Texel, Row + size_t(X) * 16, sizeof(Texel));
		}
		return Texel;
	}

	glm::vec4 Sample(glm::vec2 UV) const
	{
		const float X = UV.x * float(Mip.SizeX) - 0.5f;
		const float Y = UV.y * float(Mip.SizeY) - 0.5f;
		const float FloorX = std::floor(X);
		const float FloorY = std::floor(Y);
		const int X0 = int(FloorX);
		const int Y0 = int(FloorY);
		const int Left = std::clamp(X0, 0, Mip.SizeX - 1);
		const int Right = std::clamp(X0 + 1, 0, Mip.SizeX - 1);
		const int Top = std::clamp(Y0, 0, Mip.SizeY - 1);
		const int Bottom = std::clamp(Y0 + 1, 0, Mip.SizeY - 1);
		const glm::vec4 Upper = glm::mix(Load(Left, Top), Load(Right, Top), X - FloorX);
		const glm::vec4 Lower = glm::mix(Load(Left, Bottom), Load(Right, Bottom), X - FloorX);
		return glm::mix(Upper, Lower, Y - FloorY);
	}
};

struct FScalarTarget
{
	const FKernelMip& Mip;
	bool bHalf;

	void Store(int X, int Y, glm::vec4 Value) const
	{
		uint8_t* Row = Mip.Data + size_t(Y) * size_t(Mip.RowPitch);
		if (bHalf)
		{
			_mm_storel_epi64(reinterpret_cast<__m128i*>(Row + size_t(X) * 8),
				_mm_cvtps_ph(_mm_setr_ps(Value.x, Value.y, Value.z, Value.w), 0));
		}
		else
		{
			std::memcpy(Row + size_t(X) * 16, &Value, sizeof(Value));
		}
	}
};

template<typename F>
void ForEachPixel(const FPass& Pass, F Main)
{
	const bool bHalf = Pass.Input.Storage == ETexelStorage::RGBA16_FLOAT;
	const FScalarTexture Input = {Pass.Input.Mips[0], bHalf};
	const FScalarTarget Output = {Pass.Output.Mips[0], bHalf};
	for (int Y = 0; Y < Output.Mip.SizeY; ++Y)
	{
		for (int X = 0; X < Output.Mip.SizeX; ++X)
		{
			Output.Store(X, Y, Main(Input, X, Y));
		}
	}
}

void KawaseDownScalar(const FPass& Pass)
{
	const glm::vec2 ViewSize(Pass.Input.Mips[0].SizeX, Pass.Input.Mips[0].SizeY);
	const glm::vec2 HalfPixel = 0.5f / ViewSize;
	ForEachPixel(Pass,
		[&](const FScalarTexture& Input, int X, int Y)
		{
			const glm::vec2 UV = (glm::vec2(X, Y) * 2.0f + 1.0f) / ViewSize;
			const glm::vec2 Other(HalfPixel.x, -HalfPixel.y);
			glm::vec4 Sum = Input.Sample(UV) * 4.0f;
			Sum += Input.Sample(UV - HalfPixel);
			Sum += Input.Sample(UV + HalfPixel);
			Sum += Input.Sample(UV + Other);
			Sum += Input.Sample(UV - Other);
			return Sum / 8.0f;
		});
}

void BloomSetupScalar(const FPass& Pass)
{
	const glm::vec2 Inverse(1.0f / float(Pass.Input.Mips[0].SizeX), 1.0f / float(Pass.Input.Mips[0].SizeY));
	ForEachPixel(Pass,
		[&](const FScalarTexture& Input, int X, int Y)
		{
			const glm::vec4 SceneColor = Input.Sample((glm::vec2(X, Y) + 0.5f) * Inverse);
			glm::vec3 LinearColor = glm::min(glm::vec3(SceneColor), glm::vec3(65536.0f));
			const float Luminance = glm::dot(LinearColor, glm::vec3(0.3f, 0.59f, 0.11f));
			LinearColor *= glm::clamp((Luminance - 0.5f) * 0.5f, 0.0f, 1.0f);
			return glm::vec4(LinearColor, 0.0f);
		});
}

void BlurScalar(const FPass& Pass)
{
	const glm::vec2 Inverse(1.0f / float(Pass.Input.Mips[0].SizeX), 1.0f / float(Pass.Input.Mips[0].SizeY));
	ForEachPixel(Pass,
		[&](const FScalarTexture& Input, int X, int Y)
		{
			const glm::vec2 UV = (glm::vec2(X, Y) + 0.5f) * Inverse;
			glm::vec4 Sum(0.0f);
			for (int i = 0; i < 13; ++i)
			{
				Sum += Input.Sample(UV + glm::vec2(0.0f, Inverse.y * float(i - 6))) * GWeights[i];
			}
			return Sum;
		});
}

} // namespace

const FKernelPair* DRYDOCK_BENCH_GETTER()
{
	static const FKernelPair Kernels[GNumKernels] = {
		{"KawaseDown", 2, KawaseDownLanes, KawaseDownScalar},
		{"BloomSetup", 1, BloomSetupLanes, BloomSetupScalar},
		{"Blur13", 1, BlurLanes, BlurScalar},
	};
	return Kernels;
}

} // namespace Drydock::Bench
