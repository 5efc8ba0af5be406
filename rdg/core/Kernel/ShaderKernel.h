// The binary interface between a compiled shader (a shared object made by the shader tier) and the library that runs
// it: plain structs of pointers and sizes, without C++ runtime types. One compiled shader serves any build of the
// library with the same version number.
#pragma once

#include <cstdint>

namespace Drydock
{

/** Bumped whenever a struct or a meaning below changes; part of the cache key of every compiled shader. */
constexpr uint32_t GShaderKernelVersion = 2;

/** The layout of one texel in memory. A texture's storage follows from its EPixelFormat and from r.Drydock.Storage. */
enum class ETexelStorage : uint8_t
{
	R8_UNORM,
	RG8_UNORM,
	RGBA8_UNORM,
	BGRA8_UNORM,
	RGBA8_SRGB,
	BGRA8_SRGB,
	RGB10A2_UNORM,
	R16_UNORM,
	RG16_UNORM,
	RGBA16_UNORM,
	R16_FLOAT,
	RG16_FLOAT,
	RGBA16_FLOAT,
	R11G11B10_FLOAT,
	R32_FLOAT,
	RG32_FLOAT,
	RGB32_FLOAT,
	RGBA32_FLOAT,
	R64_FLOAT,
	RG64_FLOAT,
	RGB64_FLOAT,
	RGBA64_FLOAT,
	R8_UINT,
	R16_UINT,
	R32_UINT,
	RG8_UINT,
	RG16_UINT,
	RG32_UINT,
	RGBA8_UINT,
	RGBA16_UINT,
	RGBA32_UINT,
	R32_SINT,
	Count
};

/** Whether atomic operations work on its texels. */
constexpr bool HoldsWords(ETexelStorage Storage)
{
	return Storage == ETexelStorage::R32_UINT || Storage == ETexelStorage::R32_SINT;
}

/** One mip level. Rows are RowPitch bytes apart, slices (3D depth or array layers) SlicePitch bytes apart. */
struct FKernelMip
{
	uint8_t* Data;
	int32_t SizeX;
	int32_t SizeY;
	int32_t SizeZ;
	int32_t RowPitch;
	int64_t SlicePitch;
};

/** A texture as a shader sees it through one view: Mips[0] is the view's first mip. Memory is readable for 64 bytes
 *  before the first and past the last texel. */
struct FKernelTexture
{
	const FKernelMip* Mips;
	int32_t NumMips;
	ETexelStorage Storage;
	uint8_t bIs3D;
	uint8_t bSaturateStore; // r.Drydock.StoreOverflow 1: finite overflow of a half store gives the largest finite value
};

enum class EKernelFilter : uint8_t
{
	Point,
	Bilinear,
	Trilinear
};
enum class EKernelAddress : uint8_t
{
	Wrap,
	Clamp,
	Mirror,
	Border
};

/** How a comparison sampler compares the shader's value with a texel: 1 where it holds, else 0. */
enum class EKernelCompare : uint8_t
{
	Never,
	Less
};

struct FKernelSampler
{
	EKernelFilter Filter;
	EKernelAddress AddressU;
	EKernelAddress AddressV;
	EKernelAddress AddressW;
	uint8_t SampleBits; // 8: coordinates snapped to 1/256 texel; 0: not snapped
	float MipBias;
	float Border[4];
	EKernelCompare Compare = EKernelCompare::Never;
	float MinLevel = 0; // levels with their bias are clamped to this range
	float MaxLevel = 1000;
};

/** A (RW)StructuredBuffer, (RW)ByteAddressBuffer or typed (RW)Buffer. */
struct FKernelBuffer
{
	uint8_t* Data;
	uint32_t SizeInBytes;
	uint32_t Stride;       // bytes per element; structured: the struct's size
	ETexelStorage Storage; // typed buffers only
};

enum class EKernelBlendOp : uint8_t
{
	Add,
	Subtract,
	Min,
	Max,
	ReverseSubtract
};
enum class EKernelBlendFactor : uint8_t
{
	Zero,
	One,
	SourceColor,
	InverseSourceColor,
	SourceAlpha,
	InverseSourceAlpha,
	DestAlpha,
	InverseDestAlpha,
	DestColor,
	InverseDestColor,
	ConstantBlendFactor,
	InverseConstantBlendFactor
};

/** One bound render target of a pixel shader. */
struct FKernelTarget
{
	FKernelTexture Texture; // one mip, one slice
	uint8_t WriteMask;      // bit 0 red .. bit 3 alpha
	uint8_t bBlend;
	EKernelBlendOp ColorOp;
	EKernelBlendFactor ColorSource;
	EKernelBlendFactor ColorDest;
	EKernelBlendOp AlphaOp;
	EKernelBlendFactor AlphaSource;
	EKernelBlendFactor AlphaDest;
};

/** An interpolated pixel-shader input (TEXCOORDn): value = Base + DX * (x + 0.5) + DY * (y + 0.5), x and y in target
 *  pixels. */
struct FKernelInterpolant
{
	double Base[4];
	double DX[4];
	double DY[4];
};

/** Counters of one run of a kernel over one tile; null when nothing is counted. */
struct FKernelCounters
{
	uint64_t Samples;
	uint64_t Loads;
	uint64_t Stores;
};

/** The limits of a kernel, and the functions that it calls when it exceeds them (KernelLimits.h). */
struct FKernelLimits
{
	uint32_t LoopTurns; // of a loop that the shader's text does not bound
	/** A loop of the thread at X, Y, Z took more turns. File and Line are the shader's. Does not return: throws through
	 * the kernel, which has nothing to clean up. */
	void (*OnEndlessLoop)(const char* File, int32_t Line, int32_t X, int32_t Y, int32_t Z);
};

/** The target of SV_Depth; it lies behind those of colours. */
constexpr int32_t GDepthTarget = 8;

/** Everything a kernel reads. Slots are the indices of the shader's FShaderReflection lists. */
struct FKernelArgs
{
	const uint8_t* const* ConstantBuffers; // laid out as the reflection says; float32 and int32 members
	const FKernelTexture* Textures;
	const FKernelTexture* RWTextures;
	const FKernelSampler* Samplers;
	const FKernelBuffer* Buffers;
	const FKernelBuffer* RWBuffers;
	const FKernelTarget* Targets;           // pixel shaders: NumTargets of them, index = SV_TargetN or GDepthTarget
	const FKernelInterpolant* Interpolants; // pixel shaders: index = input location
	int32_t NumTargets;
	FKernelCounters* Counters;
	const FKernelLimits* Limits; // null: none
};

/** Half-open box of work. Pixel shaders: target pixels, Z 0..1. Compute: dispatch thread ids. */
struct FKernelTile
{
	int32_t MinX;
	int32_t MinY;
	int32_t MinZ;
	int32_t MaxX;
	int32_t MaxY;
	int32_t MaxZ;
};

using FKernelFunction = void (*)(const FKernelArgs& Args, const FKernelTile& Tile);

/** The data that a compiled shader exports under the C name "DrydockShaderKernel". */
struct FKernelModule
{
	uint32_t Version; // GShaderKernelVersion
	uint32_t Lanes;
	uint32_t RealSize; // 4 float, 8 double
	FKernelFunction Run;
};

} // namespace Drydock
