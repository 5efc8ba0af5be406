// Textures, buffers, constants and render targets as a kernel sees them. Sampling, texel loads and stores run in
// libdrydock, tuned per instruction set; lanes travel by pointer so that no vector type crosses a library border.
// The rules are those of Direct3D 11 and of docs/architecture.md.
//
//   Real textures   SampleLevel2D(Texture, Sampler, Vec2 UV, Level)      Level: Real or TReal
//                   SampleLevel2DArray(Texture, Sampler, Vec3 UVLayer, Level), SampleLevel3D(Texture, Sampler, Vec3
//                   UVW, Level) Gather2D(Texture, Sampler, Vec2 UV, Component) Load2D(Texture, Vec2 XY, Mip),
//                   Load2DArray(Texture, Vec3 XYLayer, Mip), Load3D(Texture, Vec3 XYZ, Mip) Load2DUint.. for integer
//                   textures; Mip: int32_t or TInt; coordinates int or uint vectors
//   RW textures     Load2D.. with Mip 0; StoreTexture2D / 2DArray / 3D (Mask, Texture, Coordinates, Vec4 value), and
//                   StoreTexture2DUint..; StoreTarget(Mask, Target, X0, Y, Vec4 value): lane i is pixel X0 + i
//   Sizes           TextureSize2D(Texture, Mip) TextureSize3D(Texture, Mip) TextureLevels(Texture): uniform int32_t
//   Buffers         LoadBufferReal<Real> / Int / Uint (Buffer, ByteOffset), StoreBufferReal / Int / Uint (Mask, Buffer,
//                   ByteOffset, Value); ByteOffset uint32_t (gives a uniform) or TUint. Elements in memory have 32 bits
//                   LoadTyped<Real, N>(Buffer, Index), LoadTypedUint, StoreTyped, StoreTypedUint: four components
//                   BufferElements(Buffer) = bytes / stride
//   Constants       ReadConstant<float|int32_t|uint32_t>(Data, ByteOffset)
//   Pixel inputs    Interpolate<Real>(Interpolant, Component, TInt X, int32_t Y)
//
// Out-of-bounds loads give 0, out-of-bounds stores are dropped. Results of samples and loads are TVec<TReal<Real, N>,
// 4> (or TUint) with missing channels 0, 0, 1; take the components that the shader wants.
#pragma once

#include "ShaderKernel.h"

#include "LanesMath.h"

namespace Drydock::Lanes
{

struct FKernelTap;

/** The places where lanes sample, and the options of the sample. Each pointer is to N values; null: there is none. */
template<typename Real>
struct TSamplePlace
{
	const Real* Coordinates[3] = {}; // U, V, W; of a cube the direction
	const Real* Layer = nullptr;     // of an array; which cube of several
	const Real* Reference = nullptr; // what is compared with red texels: the sample is of the answers
	const int32_t* Offsets[3] = {};  // texels of the mip that is sampled
	bool bCube = false;
};

/** The out-of-line half, one per lane type. Lane arrays have N elements; four-component arrays are [4][N]. */
template<typename Real, int N>
struct __attribute__((visibility("default"))) TSampling
{
	/** Layer may be null (a 2D texture). Levels: N values, or one when bUniformLevel. */
	static void Sample2D(const FKernelTexture& Texture, const FKernelSampler& Sampler, const Real* U, const Real* V,
		const Real* Layer, const Real* Levels, bool bUniformLevel, Real* Out);
	/** The same of a 2D texture at the pack of pixels (X0.., Y), which Tap remembers. U must depend on the column
	 * alone, V on the row, and Level on nothing. */
	static void LearnSample2D(const FKernelTexture& Texture, const FKernelSampler& Sampler, const Real* U,
		const Real* V, Real Level, Real* Out, FKernelTap& Tap, int32_t X0, int32_t Y);
	static void Sample3D(const FKernelTexture& Texture, const FKernelSampler& Sampler, const Real* U, const Real* V,
		const Real* W, const Real* Levels, bool bUniformLevel, Real* Out);
	/** Samples a texture of any shape, with an offset or a comparison, whose result is the first channel. */
	static void Sample(const FKernelTexture& Texture, const FKernelSampler& Sampler, const TSamplePlace<Real>& Place,
		const Real* Levels, bool bUniformLevel, Real* Out);
	/** The four texels of a bilinear footprint of mip 0, in the order of D3D: (-,+) (+,+) (+,-) (-,-). */
	static void Gather(const FKernelTexture& Texture, const FKernelSampler& Sampler, const TSamplePlace<Real>& Place,
		int32_t Component, Real* Out);
	/** Z is depth or layer, null for 0. Mips: N values, or one when bUniformMip. */
	static void Load(const FKernelTexture& Texture, const int32_t* X, const int32_t* Y, const int32_t* Z,
		const int32_t* Mips, bool bUniformMip, Real* Out);
	/** As LearnSample2D. */
	static void LearnLoad2D(const FKernelTexture& Texture, const int32_t* X, const int32_t* Y, int32_t Mip, Real* Out,
		FKernelTap& Tap, int32_t X0, int32_t Row);
	static void LoadUint(const FKernelTexture& Texture, const int32_t* X, const int32_t* Y, const int32_t* Z,
		const int32_t* Mips, bool bUniformMip, uint32_t* Out);
	/** Mask: -1 or 0 per lane. Writes mip 0 of the view. */
	static void Store(const FKernelTexture& Texture, const int32_t* Mask, const int32_t* X, const int32_t* Y,
		const int32_t* Z, const Real* Value);
	static void StoreUint(const FKernelTexture& Texture, const int32_t* Mask, const int32_t* X, const int32_t* Y,
		const int32_t* Z, const uint32_t* Value);
	/** Lane i is pixel (X0 + i, Y): blend state, write mask, conversion to the target's storage. */
	static void StoreTarget(const FKernelTarget& Target, const int32_t* Mask, int32_t X0, int32_t Y, const Real* Value);
	static void LoadTyped(const FKernelBuffer& Buffer, const uint32_t* Index, Real* Out);
	static void LoadTypedUint(const FKernelBuffer& Buffer, const uint32_t* Index, uint32_t* Out);
	static void StoreTyped(const FKernelBuffer& Buffer, const int32_t* Mask, const uint32_t* Index, const Real* Value);
	static void StoreTypedUint(
		const FKernelBuffer& Buffer, const int32_t* Mask, const uint32_t* Index, const uint32_t* Value);
};

inline namespace DRYDOCK_LANES_SET
{

template<typename Real, int N>
using TColor = TVec<TReal<Real, N>, 4>;

/** Address of the lanes of a value. A vector type may alias its element type, which both compilers document. */
template<typename T>
DRYDOCK_LANES_INLINE auto* LanesOf(const T& X) requires(CLanes<T>)
{
	return reinterpret_cast<const std::remove_cvref_t<decltype(X.V[0])>*>(&X.V);
}
template<typename T>
DRYDOCK_LANES_INLINE auto* LanesOf(T& X) requires(CLanes<T>)
{
	return reinterpret_cast<std::remove_cvref_t<decltype(X.V[0])>*>(&X.V);
}
template<typename Real>
DRYDOCK_LANES_INLINE const Real* LanesOf(const Real& X) requires(std::is_arithmetic_v<Real>)
{
	return &X;
}
template<int N>
DRYDOCK_LANES_INLINE const int32_t* IndicesOf(const TInt<N>& X)
{
	return LanesOf(X);
}
template<int N>
DRYDOCK_LANES_INLINE const int32_t* IndicesOf(const TUint<N>& X)
{
	return reinterpret_cast<const int32_t*>(&X.V);
}
DRYDOCK_LANES_INLINE const int32_t* IndicesOf(const int32_t& X)
{
	return &X;
}
DRYDOCK_LANES_INLINE const int32_t* IndicesOf(const uint32_t& X)
{
	return reinterpret_cast<const int32_t*>(&X);
}

template<typename Real, int N, typename L>
DRYDOCK_LANES_INLINE TColor<Real, N> SampleLevel2D(
	const FKernelTexture& Texture, const FKernelSampler& Sampler, const TVec<TReal<Real, N>, 2>& UV, const L& Level)
{
	TColor<Real, N> Out;
	TSampling<Real, N>::Sample2D(
		Texture, Sampler, LanesOf(UV.E[0]), LanesOf(UV.E[1]), nullptr, LanesOf(Level), CUniform<L>, LanesOf(Out.E[0]));
	return Out;
}
template<typename Real, int N, typename L>
DRYDOCK_LANES_INLINE TColor<Real, N> SampleLevel2DArray(
	const FKernelTexture& Texture, const FKernelSampler& Sampler, const TVec<TReal<Real, N>, 3>& UV, const L& Level)
{
	TColor<Real, N> Out;
	TSampling<Real, N>::Sample2D(Texture, Sampler, LanesOf(UV.E[0]), LanesOf(UV.E[1]), LanesOf(UV.E[2]), LanesOf(Level),
		CUniform<L>, LanesOf(Out.E[0]));
	return Out;
}
template<typename Real, int N, typename L>
DRYDOCK_LANES_INLINE TColor<Real, N> SampleLevel3D(
	const FKernelTexture& Texture, const FKernelSampler& Sampler, const TVec<TReal<Real, N>, 3>& UVW, const L& Level)
{
	TColor<Real, N> Out;
	TSampling<Real, N>::Sample3D(Texture, Sampler, LanesOf(UVW.E[0]), LanesOf(UVW.E[1]), LanesOf(UVW.E[2]),
		LanesOf(Level), CUniform<L>, LanesOf(Out.E[0]));
	return Out;
}
template<typename Real, int N>
DRYDOCK_LANES_INLINE TColor<Real, N> Gather2D(
	const FKernelTexture& Texture, const FKernelSampler& Sampler, const TVec<TReal<Real, N>, 2>& UV, int32_t Component)
{
	TColor<Real, N> Out;
	const TSamplePlace<Real> Place = {{LanesOf(UV.E[0]), LanesOf(UV.E[1])}};
	TSampling<Real, N>::Gather(Texture, Sampler, Place, Component, LanesOf(Out.E[0]));
	return Out;
}

template<typename Real, int N, template<int> typename I, typename M>
DRYDOCK_LANES_INLINE TColor<Real, N> Load2D(const FKernelTexture& Texture, const TVec<I<N>, 2>& XY, const M& Mip)
{
	TColor<Real, N> Out;
	TSampling<Real, N>::Load(
		Texture, IndicesOf(XY.E[0]), IndicesOf(XY.E[1]), nullptr, IndicesOf(Mip), CUniform<M>, LanesOf(Out.E[0]));
	return Out;
}
template<typename Real, int N, template<int> typename I, typename M>
DRYDOCK_LANES_INLINE TColor<Real, N> Load3D(const FKernelTexture& Texture, const TVec<I<N>, 3>& XYZ, const M& Mip)
{
	TColor<Real, N> Out;
	TSampling<Real, N>::Load(Texture, IndicesOf(XYZ.E[0]), IndicesOf(XYZ.E[1]), IndicesOf(XYZ.E[2]), IndicesOf(Mip),
		CUniform<M>, LanesOf(Out.E[0]));
	return Out;
}
template<typename Real, int N, template<int> typename I, typename M>
DRYDOCK_LANES_INLINE TColor<Real, N> Load2DArray(
	const FKernelTexture& Texture, const TVec<I<N>, 3>& XYLayer, const M& Mip)
{
	return Load3D<Real, N>(Texture, XYLayer, Mip);
}
template<typename Real, int N, template<int> typename I, typename M>
DRYDOCK_LANES_INLINE TVec<TUint<N>, 4> Load2DUint(const FKernelTexture& Texture, const TVec<I<N>, 2>& XY, const M& Mip)
{
	TVec<TUint<N>, 4> Out;
	TSampling<Real, N>::LoadUint(
		Texture, IndicesOf(XY.E[0]), IndicesOf(XY.E[1]), nullptr, IndicesOf(Mip), CUniform<M>, LanesOf(Out.E[0]));
	return Out;
}
template<typename Real, int N, template<int> typename I, typename M>
DRYDOCK_LANES_INLINE TVec<TUint<N>, 4> Load3DUint(const FKernelTexture& Texture, const TVec<I<N>, 3>& XYZ, const M& Mip)
{
	TVec<TUint<N>, 4> Out;
	TSampling<Real, N>::LoadUint(Texture, IndicesOf(XYZ.E[0]), IndicesOf(XYZ.E[1]), IndicesOf(XYZ.E[2]), IndicesOf(Mip),
		CUniform<M>, LanesOf(Out.E[0]));
	return Out;
}
template<typename Real, int N, template<int> typename I, typename M>
DRYDOCK_LANES_INLINE TVec<TUint<N>, 4> Load2DArrayUint(
	const FKernelTexture& Texture, const TVec<I<N>, 3>& XYLayer, const M& Mip)
{
	return Load3DUint<Real, N>(Texture, XYLayer, Mip);
}

template<typename Real, int N, template<int> typename I>
DRYDOCK_LANES_INLINE void StoreTexture2D(
	TMask<N> Mask, const FKernelTexture& Texture, const TVec<I<N>, 2>& XY, const TColor<Real, N>& Value)
{
	TSampling<Real, N>::Store(
		Texture, LanesOf(Mask), IndicesOf(XY.E[0]), IndicesOf(XY.E[1]), nullptr, LanesOf(Value.E[0]));
}
template<typename Real, int N, template<int> typename I>
DRYDOCK_LANES_INLINE void StoreTexture3D(
	TMask<N> Mask, const FKernelTexture& Texture, const TVec<I<N>, 3>& XYZ, const TColor<Real, N>& Value)
{
	TSampling<Real, N>::Store(
		Texture, LanesOf(Mask), IndicesOf(XYZ.E[0]), IndicesOf(XYZ.E[1]), IndicesOf(XYZ.E[2]), LanesOf(Value.E[0]));
}
template<typename Real, int N, template<int> typename I>
DRYDOCK_LANES_INLINE void StoreTexture2DArray(
	TMask<N> Mask, const FKernelTexture& Texture, const TVec<I<N>, 3>& XYLayer, const TColor<Real, N>& Value)
{
	StoreTexture3D(Mask, Texture, XYLayer, Value);
}
template<typename Real, int N, template<int> typename I>
DRYDOCK_LANES_INLINE void StoreTexture2DUint(
	TMask<N> Mask, const FKernelTexture& Texture, const TVec<I<N>, 2>& XY, const TVec<TUint<N>, 4>& Value)
{
	TSampling<Real, N>::StoreUint(
		Texture, LanesOf(Mask), IndicesOf(XY.E[0]), IndicesOf(XY.E[1]), nullptr, LanesOf(Value.E[0]));
}
template<typename Real, int N, template<int> typename I>
DRYDOCK_LANES_INLINE void StoreTexture3DUint(
	TMask<N> Mask, const FKernelTexture& Texture, const TVec<I<N>, 3>& XYZ, const TVec<TUint<N>, 4>& Value)
{
	TSampling<Real, N>::StoreUint(
		Texture, LanesOf(Mask), IndicesOf(XYZ.E[0]), IndicesOf(XYZ.E[1]), IndicesOf(XYZ.E[2]), LanesOf(Value.E[0]));
}
template<typename Real, int N, template<int> typename I>
DRYDOCK_LANES_INLINE void StoreTexture2DArrayUint(
	TMask<N> Mask, const FKernelTexture& Texture, const TVec<I<N>, 3>& XYLayer, const TVec<TUint<N>, 4>& Value)
{
	StoreTexture3DUint<Real, N>(Mask, Texture, XYLayer, Value);
}
template<typename Real, int N>
DRYDOCK_LANES_INLINE void StoreTarget(
	TMask<N> Mask, const FKernelTarget& Target, int32_t X0, int32_t Y, const TColor<Real, N>& Value)
{
	TSampling<Real, N>::StoreTarget(Target, LanesOf(Mask), X0, Y, LanesOf(Value.E[0]));
}
/** The same of integers, which do not blend. Channels that the write mask leaves out are written as they are. */
template<typename Real, int N>
DRYDOCK_LANES_INLINE void StoreTarget(
	TMask<N> Mask, const FKernelTarget& Target, int32_t X0, int32_t Y, const TVec<TUint<N>, 4>& Value)
{
	const TVec<TInt<N>, 2> Place(LaneIndex<N>() + TInt<N>(X0), TInt<N>(Y));
	TVec<TUint<N>, 4> Texel = Value;
	if ((Target.WriteMask & 15) != 15)
	{
		Texel = Load2DUint<Real, N>(Target.Texture, Place, 0);
		for (int c = 0; c < 4; ++c)
		{
			Texel.E[c] = Target.WriteMask >> c & 1 ? Value.E[c] : Texel.E[c];
		}
	}
	StoreTexture2DUint<Real, N>(Mask, Target.Texture, Place, Texel);
}

/** Width and height of a mip of the view; 0 when there is no such mip. */
DRYDOCK_LANES_INLINE TVec<int32_t, 2> TextureSize2D(const FKernelTexture& Texture, int32_t Mip = 0)
{
	const bool bExists = uint32_t(Mip) < uint32_t(Texture.NumMips);
	return bExists ? TVec<int32_t, 2>(Texture.Mips[Mip].SizeX, Texture.Mips[Mip].SizeY) : TVec<int32_t, 2>(0, 0);
}
/** Width, height and depth or layers. */
DRYDOCK_LANES_INLINE TVec<int32_t, 3> TextureSize3D(const FKernelTexture& Texture, int32_t Mip = 0)
{
	const bool bExists = uint32_t(Mip) < uint32_t(Texture.NumMips);
	return bExists ? TVec<int32_t, 3>(Texture.Mips[Mip].SizeX, Texture.Mips[Mip].SizeY, Texture.Mips[Mip].SizeZ)
				   : TVec<int32_t, 3>(0, 0, 0);
}
/** Width and height of a face, and how many cubes. */
DRYDOCK_LANES_INLINE TVec<int32_t, 3> TextureSizeCubes(const FKernelTexture& Texture, int32_t Mip = 0)
{
	const TVec<int32_t, 3> Size = TextureSize3D(Texture, Mip);
	return {Size[0], Size[1], Size[2] / 6};
}
DRYDOCK_LANES_INLINE int32_t TextureLevels(const FKernelTexture& Texture)
{
	return Texture.NumMips;
}

DRYDOCK_LANES_INLINE bool IsInside(const FKernelBuffer& Buffer, uint32_t Offset)
{
	return Offset < Buffer.SizeInBytes && Buffer.SizeInBytes - Offset >= 4;
}
DRYDOCK_LANES_INLINE uint32_t LoadBufferUint(const FKernelBuffer& Buffer, uint32_t Offset)
{
	uint32_t Value = 0;
	if (IsInside(Buffer, Offset))
	{
		__builtin_memcpy(&Value, Buffer.Data + Offset, 4);
	}
	return Value;
}
template<int N>
DRYDOCK_LANES_INLINE TUint<N> LoadBufferUint(const FKernelBuffer& Buffer, TUint<N> Offset)
{
	TUint<N> Value;
	for (int Lane = 0; Lane < N; ++Lane)
	{
		Value.V[Lane] = LoadBufferUint(Buffer, Offset.V[Lane]);
	}
	return Value;
}
template<typename O>
DRYDOCK_LANES_INLINE auto LoadBufferInt(const FKernelBuffer& Buffer, O Offset)
{
	return AsInt(LoadBufferUint(Buffer, Offset));
}
template<typename Real, typename O>
DRYDOCK_LANES_INLINE auto LoadBufferReal(const FKernelBuffer& Buffer, O Offset)
{
	return AsReal<Real>(LoadBufferUint(Buffer, Offset));
}

/** Lanes are written in ascending order: where two lanes meet in one place, the higher one wins. */
template<int N>
DRYDOCK_LANES_INLINE void StoreBufferUint(TMask<N> Mask, const FKernelBuffer& Buffer, TUint<N> Offset, TUint<N> Value)
{
	for (int Lane = 0; Lane < N; ++Lane)
	{
		if (Mask[Lane] && IsInside(Buffer, Offset.V[Lane]))
		{
			const uint32_t Bits = Value.V[Lane];
			__builtin_memcpy(Buffer.Data + Offset.V[Lane], &Bits, 4);
		}
	}
}
template<int N>
DRYDOCK_LANES_INLINE void StoreBufferInt(TMask<N> Mask, const FKernelBuffer& Buffer, TUint<N> Offset, TInt<N> Value)
{
	StoreBufferUint<N>(Mask, Buffer, Offset, AsUint(Value));
}
template<typename Real, int N>
DRYDOCK_LANES_INLINE void StoreBufferReal(
	TMask<N> Mask, const FKernelBuffer& Buffer, TUint<N> Offset, TReal<Real, N> Value)
{
	StoreBufferUint<N>(Mask, Buffer, Offset, AsUint(Value));
}

template<typename Real, int N>
DRYDOCK_LANES_INLINE TColor<Real, N> LoadTyped(const FKernelBuffer& Buffer, TUint<N> Index)
{
	TColor<Real, N> Out;
	TSampling<Real, N>::LoadTyped(Buffer, LanesOf(Index), LanesOf(Out.E[0]));
	return Out;
}
template<typename Real, int N>
DRYDOCK_LANES_INLINE TVec<TUint<N>, 4> LoadTypedUint(const FKernelBuffer& Buffer, TUint<N> Index)
{
	TVec<TUint<N>, 4> Out;
	TSampling<Real, N>::LoadTypedUint(Buffer, LanesOf(Index), LanesOf(Out.E[0]));
	return Out;
}
template<typename Real, int N>
DRYDOCK_LANES_INLINE void StoreTyped(
	TMask<N> Mask, const FKernelBuffer& Buffer, TUint<N> Index, const TColor<Real, N>& Value)
{
	TSampling<Real, N>::StoreTyped(Buffer, LanesOf(Mask), LanesOf(Index), LanesOf(Value.E[0]));
}
template<typename Real, int N>
DRYDOCK_LANES_INLINE void StoreTypedUint(
	TMask<N> Mask, const FKernelBuffer& Buffer, TUint<N> Index, const TVec<TUint<N>, 4>& Value)
{
	TSampling<Real, N>::StoreTypedUint(Buffer, LanesOf(Mask), LanesOf(Index), LanesOf(Value.E[0]));
}
DRYDOCK_LANES_INLINE uint32_t BufferElements(const FKernelBuffer& Buffer)
{
	return Buffer.Stride == 0 ? Buffer.SizeInBytes : Buffer.SizeInBytes / Buffer.Stride;
}

/** One 32-bit constant at a byte offset that the reflection gave. */
template<typename T>
DRYDOCK_LANES_INLINE T ReadConstant(const uint8_t* Data, uint32_t Offset)
{
	static_assert(sizeof(T) == 4);
	T Value;
	__builtin_memcpy(&Value, Data + Offset, 4);
	return Value;
}

/** Pixel-shader input at the centres of pixels (X, Y). The row's part is summed in double, the column's in Real, so
 *  that a lane's bits depend on its pixel only. */
template<typename Real, int N>
DRYDOCK_LANES_INLINE TReal<Real, N> Interpolate(
	const FKernelInterpolant& Interpolant, int Component, TInt<N> X, int32_t Y)
{
	const Real Row = Real(Interpolant.Base[Component] + Interpolant.DY[Component] * (double(Y) + 0.5));
	return TReal<Real, N>(Real(Interpolant.DX[Component])) * (ToReal<Real>(X) + TReal<Real, N>(Real(0.5))) +
		   TReal<Real, N>(Row);
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
