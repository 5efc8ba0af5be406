// Describes a compiled shader's parameters, read from its SPIR-V: plain data, matched by name and type against the C++
// parameter structs.
#pragma once

#include "DrydockAPI.h"

#include <cstdint>
#include <string>
#include <vector>

namespace Drydock
{

enum class EShaderStage : uint8_t
{
	Pixel,
	Compute,
	Vertex
};
/** Scalar types; of 32 bits, where no width is named. */
enum class EShaderScalar : uint8_t
{
	Float,
	Int,
	Uint,
	Bool,
	Half, // float16_t
	Short,
	Ushort,
	Double,
	Long, // int64_t
	Ulong
};
enum class EShaderDimension : uint8_t
{
	Texture2D,
	Texture2DArray,
	Texture3D,
	TextureCube,
	TypedBuffer,
	StructuredBuffer,
	ByteAddressBuffer
};

/** The flag that the view of a hidden counter needs: any flag that gives it a counter, where the shader does not name
 * one. */
enum class EShaderCounter : uint8_t
{
	Any,
	Atomic, // bSupportsAtomicCounter: a RWStructuredBuffer's
	Append  // bSupportsAppendBuffer: an AppendStructuredBuffer's or ConsumeStructuredBuffer's
};

/** One numeric parameter. Loose globals live in the buffer "$Global", members of `cbuffer X` in the buffer "X". */
struct FShaderConstant
{
	std::string Name;
	EShaderScalar Scalar = EShaderScalar::Float;
	int32_t Rows = 1;        // matrices: as in SHADER_PARAMETER's NumRows
	int32_t Columns = 1;     // 1..4
	int32_t NumElements = 0; // 0: not an array
	uint32_t Buffer = 0;     // index into FShaderReflection::ConstantBuffers
	uint32_t Offset = 0;     // bytes inside that buffer
	uint32_t ArrayStride = 0;
	uint32_t MatrixStride = 0;
	bool bRowMajor = false;
	bool bUsed = false; // read on some path after optimisation
	std::string Where;  // "/Project/X.usf:9", where known
};

struct FShaderConstantBuffer
{
	std::string Name;
	uint32_t Size = 0;
};

/** A texture, sampler or buffer. Only those the optimised shader still uses are listed. */
struct FShaderResource
{
	std::string Name;
	EShaderDimension Dimension = EShaderDimension::Texture2D; // meaningless for samplers
	EShaderScalar Scalar = EShaderScalar::Float;              // component type of the texel or typed element
	int32_t NumComponents = 4;
	uint32_t Stride = 0;   // structured buffers: bytes per element
	std::string CounterOf; // "X": this is the hidden counter of the structured buffer X; else empty
	EShaderCounter Counter = EShaderCounter::Any; // of such a counter
	bool bCompares = false;                       // samplers: of SampleCmp or GatherCmp
	bool bImplicitLevel = false;                  // pixel: sampled without saying at which level
	std::string Where;
};

struct FShaderReflection
{
	EShaderStage Stage = EShaderStage::Compute;
	int32_t GroupSize[3] = {1, 1, 1}; // compute: numthreads; pixel: of what runs together
	std::vector<FShaderConstantBuffer> ConstantBuffers;
	std::vector<FShaderConstant> Constants;
	std::vector<FShaderResource> Textures; // index = FKernelArgs::Textures slot, and so on
	std::vector<FShaderResource> RWTextures;
	std::vector<FShaderResource> Samplers;
	std::vector<FShaderResource> Buffers;
	std::vector<FShaderResource> RWBuffers;
	int32_t NumTargets = 0;           // pixel: 1 + highest SV_TargetN written
	uint32_t IntegerTargets = 0;      // bit N: SV_TargetN is of integers
	bool bWritesDepth = false;        // pixel: SV_Depth
	int32_t NumInterpolants = 0;      // pixel: 1 + highest interpolant read (GMaxInterpolants); vertex: written
	uint32_t IntegerInterpolants = 0; // bit N: the interpolant N is of integers
	std::vector<std::string> NamedInterpolants; // semantics from GFirstNamedInterpolant on; empty: not used
	bool bUsesDiscard = false;
	bool bLoadsStored = false;   // loads texels of a texture that it may store to, or changes them atomically
	bool bGroups = false;        // compute: threads of a group work together, see SpirvGroups.h
	bool bGroupsInOrder = false; // compute: groups run one after the other
	std::string PartedBarrier; // compute: "X.usf:12" of a barrier that not all threads of a group come to; empty: none
	bool bQuads = false;       // pixel: 2 x 2 pixels run together, see SpirvQuads.h
	int32_t StaticSamples =
		-1; // texture samples and loads per pixel where control flow is uniform and bounded, else -1
};

} // namespace Drydock
