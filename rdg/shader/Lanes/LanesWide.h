// Samples, loads and stores for more lanes than the instruction set has: piece by piece. A wave has as many threads as
// the run says, whatever the machine. Included by generated code only.
#pragma once

#include "LanesResources.h"

namespace Drydock::Lanes
{

/** TSampling of N lanes by that of W. */
template<typename Real, int N, int W>
struct TWideSampling
{
	using FPart = TSampling<Real, W>;

	static void Sample2D(const FKernelTexture& Texture, const FKernelSampler& Sampler, const Real* U, const Real* V,
		const Real* Layer, const Real* Levels, bool bUniformLevel, Real* Out)
	{
		ForEachPart<Real>(Out,
			[&](int First, Real* Part)
			{
				FPart::Sample2D(Texture, Sampler, U + First, V + First, Move(Layer, First),
					Levels + (bUniformLevel ? 0 : First), bUniformLevel, Part);
			});
	}
	static void Sample3D(const FKernelTexture& Texture, const FKernelSampler& Sampler, const Real* U, const Real* V,
		const Real* Depth, const Real* Levels, bool bUniformLevel, Real* Out)
	{
		ForEachPart<Real>(Out,
			[&](int First, Real* Part)
			{
				FPart::Sample3D(Texture, Sampler, U + First, V + First, Depth + First,
					Levels + (bUniformLevel ? 0 : First), bUniformLevel, Part);
			});
	}
	static void Sample(const FKernelTexture& Texture, const FKernelSampler& Sampler, const TSamplePlace<Real>& Place,
		const Real* Levels, bool bUniformLevel, Real* Out)
	{
		ForEachPart<Real>(Out,
			[&](int First, Real* Part)
			{
				FPart::Sample(Texture, Sampler, MovePlace(Place, First), Levels + (bUniformLevel ? 0 : First),
					bUniformLevel, Part);
			});
	}
	static void Gather(const FKernelTexture& Texture, const FKernelSampler& Sampler, const TSamplePlace<Real>& Place,
		int32_t Component, Real* Out)
	{
		ForEachPart<Real>(Out,
			[&](int First, Real* Part) { FPart::Gather(Texture, Sampler, MovePlace(Place, First), Component, Part); });
	}
	static void Load(const FKernelTexture& Texture, const int32_t* X, const int32_t* Y, const int32_t* Z,
		const int32_t* Mips, bool bUniformMip, Real* Out)
	{
		ForEachPart<Real>(Out,
			[&](int First, Real* Part) {
				FPart::Load(
					Texture, X + First, Y + First, Move(Z, First), Mips + (bUniformMip ? 0 : First), bUniformMip, Part);
			});
	}
	static void LoadUint(const FKernelTexture& Texture, const int32_t* X, const int32_t* Y, const int32_t* Z,
		const int32_t* Mips, bool bUniformMip, uint32_t* Out)
	{
		ForEachPart<uint32_t>(Out,
			[&](int First, uint32_t* Part)
			{
				FPart::LoadUint(
					Texture, X + First, Y + First, Move(Z, First), Mips + (bUniformMip ? 0 : First), bUniformMip, Part);
			});
	}
	static void Store(const FKernelTexture& Texture, const int32_t* Mask, const int32_t* X, const int32_t* Y,
		const int32_t* Z, const Real* Value)
	{
		FromEachPart<Real>(Value, [&](int First, const Real* Part)
			{ FPart::Store(Texture, Mask + First, X + First, Y + First, Move(Z, First), Part); });
	}
	static void StoreUint(const FKernelTexture& Texture, const int32_t* Mask, const int32_t* X, const int32_t* Y,
		const int32_t* Z, const uint32_t* Value)
	{
		FromEachPart<uint32_t>(Value, [&](int First, const uint32_t* Part)
			{ FPart::StoreUint(Texture, Mask + First, X + First, Y + First, Move(Z, First), Part); });
	}
	static void StoreTarget(const FKernelTarget& Target, const int32_t* Mask, int32_t X0, int32_t Y, const Real* Value)
	{
		FromEachPart<Real>(
			Value, [&](int First, const Real* Part) { FPart::StoreTarget(Target, Mask + First, X0 + First, Y, Part); });
	}
	static void LoadTyped(const FKernelBuffer& Buffer, const uint32_t* Index, Real* Out)
	{
		ForEachPart<Real>(Out, [&](int First, Real* Part) { FPart::LoadTyped(Buffer, Index + First, Part); });
	}
	static void LoadTypedUint(const FKernelBuffer& Buffer, const uint32_t* Index, uint32_t* Out)
	{
		ForEachPart<uint32_t>(
			Out, [&](int First, uint32_t* Part) { FPart::LoadTypedUint(Buffer, Index + First, Part); });
	}
	static void StoreTyped(const FKernelBuffer& Buffer, const int32_t* Mask, const uint32_t* Index, const Real* Value)
	{
		FromEachPart<Real>(
			Value, [&](int First, const Real* Part) { FPart::StoreTyped(Buffer, Mask + First, Index + First, Part); });
	}
	static void StoreTypedUint(
		const FKernelBuffer& Buffer, const int32_t* Mask, const uint32_t* Index, const uint32_t* Value)
	{
		FromEachPart<uint32_t>(Value,
			[&](int First, const uint32_t* Part) { FPart::StoreTypedUint(Buffer, Mask + First, Index + First, Part); });
	}

private:
	template<typename T>
	static const T* Move(const T* Lanes, int First)
	{
		return Lanes ? Lanes + First : nullptr;
	}
	static TSamplePlace<Real> MovePlace(TSamplePlace<Real> Place, int First)
	{
		for (int Axis = 0; Axis < 3; ++Axis)
		{
			Place.Coordinates[Axis] = Move(Place.Coordinates[Axis], First);
			Place.Offsets[Axis] = Move(Place.Offsets[Axis], First);
		}
		Place.Layer = Move(Place.Layer, First);
		Place.Reference = Move(Place.Reference, First);
		return Place;
	}
	/** Four rows of W lanes each go to four rows of N. */
	template<typename T, typename F>
	static void ForEachPart(T* Out, F f)
	{
		for (int First = 0; First < N; First += W)
		{
			alignas(64) T Part[4 * W];
			f(First, Part);
			for (int Row = 0; Row < 4; ++Row)
			{
				__builtin_memcpy(Out + Row * N + First, Part + Row * W, W * sizeof(T));
			}
		}
	}
	template<typename T, typename F>
	static void FromEachPart(const T* Value, F f)
	{
		for (int First = 0; First < N; First += W)
		{
			alignas(64) T Part[4 * W];
			for (int Row = 0; Row < 4; ++Row)
			{
				__builtin_memcpy(Part + Row * W, Value + Row * N + First, W * sizeof(T));
			}
			f(First, Part);
		}
	}
};

// clang-format off
#if DRYDOCK_LANES_LEVEL >= 4
template<> struct TSampling<float, 32> : TWideSampling<float, 32, 16> {};
template<> struct TSampling<float, 64> : TWideSampling<float, 64, 16> {};
template<> struct TSampling<double, 16> : TWideSampling<double, 16, 8> {};
template<> struct TSampling<double, 32> : TWideSampling<double, 32, 8> {};
template<> struct TSampling<double, 64> : TWideSampling<double, 64, 8> {};
#elif DRYDOCK_LANES_LEVEL >= 3
template<> struct TSampling<float, 16> : TWideSampling<float, 16, 8> {};
template<> struct TSampling<float, 32> : TWideSampling<float, 32, 8> {};
template<> struct TSampling<float, 64> : TWideSampling<float, 64, 8> {};
template<> struct TSampling<double, 8> : TWideSampling<double, 8, 4> {};
template<> struct TSampling<double, 16> : TWideSampling<double, 16, 4> {};
template<> struct TSampling<double, 32> : TWideSampling<double, 32, 4> {};
template<> struct TSampling<double, 64> : TWideSampling<double, 64, 4> {};
#else
template<> struct TSampling<float, 8> : TWideSampling<float, 8, 4> {};
template<> struct TSampling<float, 16> : TWideSampling<float, 16, 4> {};
template<> struct TSampling<float, 32> : TWideSampling<float, 32, 4> {};
template<> struct TSampling<float, 64> : TWideSampling<float, 64, 4> {};
template<> struct TSampling<double, 4> : TWideSampling<double, 4, 2> {};
template<> struct TSampling<double, 8> : TWideSampling<double, 8, 2> {};
template<> struct TSampling<double, 16> : TWideSampling<double, 16, 2> {};
template<> struct TSampling<double, 32> : TWideSampling<double, 32, 2> {};
template<> struct TSampling<double, 64> : TWideSampling<double, 64, 2> {};
#endif
// clang-format on

} // namespace Drydock::Lanes
