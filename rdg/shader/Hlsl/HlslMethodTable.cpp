// The table of the methods of HLSL's resources. Source: Microsoft's reference of HLSL (texture objects, buffer objects,
// shader models 5 to 6.8).
#include "HlslIntrinsicTable.h"

namespace Drydock::Hlsl
{

/** A function of its own, because it opens the enumeration. */
namespace MethodTable
{

template<typename... T>
constexpr uint32_t MakeMethodSet(T... Objects)
{
	return ((1u << uint32_t(Objects)) | ...);
}

using enum EObject;

constexpr uint32_t CubeSet = MakeMethodSet(TextureCube, TextureCubeArray);
constexpr uint32_t GatherSet = MakeMethodSet(Texture2D, Texture2DArray);
constexpr uint32_t SampleSet = CubeSet | GatherSet | MakeMethodSet(Texture1D, Texture1DArray, Texture3D);
constexpr uint32_t CompareSet = SampleSet & ~MakeMethodSet(Texture3D);
constexpr uint32_t MultiSet = MakeMethodSet(Texture2DMS, Texture2DMSArray);
constexpr uint32_t WritableSet =
	MakeMethodSet(RWTexture1D, RWTexture1DArray, RWTexture2D, RWTexture2DArray, RWTexture3D);
constexpr uint32_t TypedSet = MakeMethodSet(Buffer, RWBuffer);
constexpr uint32_t ReadStructuredSet = MakeMethodSet(StructuredBuffer, RWStructuredBuffer);
constexpr uint32_t StructuredSet = ReadStructuredSet | MakeMethodSet(AppendStructuredBuffer, ConsumeStructuredBuffer);
constexpr uint32_t WriteByteSet = MakeMethodSet(RWByteAddressBuffer);
constexpr uint32_t ByteSet = WriteByteSet | MakeMethodSet(ByteAddressBuffer);

// Sets for GetDimensions, by the number of sizes; those with mips know them by level, too.
constexpr uint32_t OneSizeMipSet = MakeMethodSet(Texture1D);
constexpr uint32_t OneSizeSet = OneSizeMipSet | TypedSet | ByteSet | MakeMethodSet(RWTexture1D);
constexpr uint32_t TwoSizesMipSet = MakeMethodSet(Texture1DArray, Texture2D, TextureCube);
constexpr uint32_t TwoSizesSet = TwoSizesMipSet | StructuredSet | MakeMethodSet(RWTexture1DArray, RWTexture2D);
constexpr uint32_t ThreeSizesMipSet = MakeMethodSet(Texture2DArray, Texture3D, TextureCubeArray);
constexpr uint32_t ThreeSizesSet = ThreeSizesMipSet | MakeMethodSet(RWTexture2DArray, RWTexture3D, Texture2DMS);

// clang-format off
constexpr FMethodRow MethodRows[] = {
	// Cubes have no offsets: their rows lack the o.
	{SampleSet, "Sample", "E(z, c, ?o, ?f, ?>u)"},
	{SampleSet, "SampleBias", "E(z, c, f, ?o, ?f, ?>u)"},
	{SampleSet, "SampleGrad", "E(z, c, g, g, ?o, ?f, ?>u)"},
	{SampleSet, "SampleLevel", "E(z, c, f, ?o, ?>u)"},
	{CompareSet, "SampleCmp", "f(Z, c, f, ?o, ?f, ?>u)"},
	{CompareSet, "SampleCmpBias", "f(Z, c, f, f, ?o, ?f, ?>u)"},
	{CompareSet, "SampleCmpGrad", "f(Z, c, f, g, g, ?o, ?f, ?>u)"},
	{CompareSet, "SampleCmpLevel", "f(Z, c, f, f, ?o, ?>u)"},
	{CompareSet, "SampleCmpLevelZero", "f(Z, c, f, ?o, ?>u)"},
	{SampleSet, "CalculateLevelOfDetail CalculateLevelOfDetailUnclamped", "f(z, l)"},
	{GatherSet | CubeSet, "Gather GatherRed GatherGreen GatherBlue GatherAlpha", "V(z, c, ?o, ?>u)"},
	{GatherSet, "GatherRed GatherGreen GatherBlue GatherAlpha", "V(z, c, o, o, o, o, ?>u)"},
	{GatherSet | CubeSet, "GatherCmp GatherCmpRed GatherCmpGreen GatherCmpBlue GatherCmpAlpha", "f4(Z, c, f, ?o, ?>u)"},
	{GatherSet, "GatherCmpRed GatherCmpGreen GatherCmpBlue GatherCmpAlpha", "f4(Z, c, f, o, o, o, o, ?>u)"},
	// A position of a texture that is read only has the level behind it.
	{SampleSet & ~CubeSet, "Load", "E(p, ?o, ?>u)"},
	{MultiSet, "Load", "E(p, s, ?o, ?>u)"},
	{WritableSet | TypedSet | ReadStructuredSet, "Load", "E(p, ?>u)"},
	{MultiSet, "GetSamplePosition", "f2(s)"},
	{OneSizeSet, "GetDimensions", "void(>N)"},
	{OneSizeMipSet, "GetDimensions", "void(u, >N, >N)"},
	{TwoSizesSet, "GetDimensions", "void(>N, >N)"},
	{TwoSizesMipSet, "GetDimensions", "void(u, >N, >N, >N)"},
	{ThreeSizesSet, "GetDimensions", "void(>N, >N, >N)"},
	{ThreeSizesMipSet, "GetDimensions", "void(u, >N, >N, >N, >N)"},
	{MakeMethodSet(Texture2DMSArray), "GetDimensions", "void(>N, >N, >N, >N)"},
	// Bytes
	{ByteSet, "Load", "u(u, ?>u)"},
	{ByteSet, "Load", "B(u, ?>u)"},
	{ByteSet, "Load2", "u2(u, ?>u)"},
	{ByteSet, "Load3", "u3(u, ?>u)"},
	{ByteSet, "Load4", "u4(u, ?>u)"},
	{WriteByteSet, "Store", "void(u, M)"},
	{WriteByteSet, "Store", "void(u, B)"},
	{WriteByteSet, "Store2", "void(u, u2)"},
	{WriteByteSet, "Store3", "void(u, u3)"},
	{WriteByteSet, "Store4", "void(u, u4)"},
	{WriteByteSet, "InterlockedAdd InterlockedAnd InterlockedMax InterlockedMin InterlockedOr InterlockedXor", "void(u, j, ?>j)"},
	{WriteByteSet, "InterlockedExchange", "void(u, j, >j)"},
	{WriteByteSet, "InterlockedCompareStore", "void(u, j, j)"},
	{WriteByteSet, "InterlockedCompareExchange", "void(u, j, j, >j)"},
	{WriteByteSet, "InterlockedAdd64 InterlockedAnd64 InterlockedMax64 InterlockedMin64 InterlockedOr64 InterlockedXor64",
		"void(u, k, ?>k)"},
	{WriteByteSet, "InterlockedExchange64", "void(u, k, >k)"},
	{WriteByteSet, "InterlockedCompareStore64", "void(u, k, k)"},
	{WriteByteSet, "InterlockedCompareExchange64", "void(u, k, k, >k)"},
	{WriteByteSet, "InterlockedExchangeFloat", "void(u, f, >f)"},
	{WriteByteSet, "InterlockedCompareStoreFloatBitwise", "void(u, f, f)"},
	{WriteByteSet, "InterlockedCompareExchangeFloatBitwise", "void(u, f, f, >f)"},
	// Structures
	{MakeMethodSet(RWStructuredBuffer), "DecrementCounter IncrementCounter", "u()"},
	{MakeMethodSet(AppendStructuredBuffer), "Append", "void(E)"},
	{MakeMethodSet(ConsumeStructuredBuffer), "Consume", "E()"},
};
// clang-format on

} // namespace MethodTable

std::span<const FMethodRow> GetMethodRows()
{
	return MethodTable::MethodRows;
}

} // namespace Drydock::Hlsl
