// The table of what is refused. Source of the pairs of SPIR-V and HLSL: Microsoft, "SPIR-V CodeGen" of the DirectX
// shader compiler; Khronos, SPIR-V specification, section 3.
#include "SpirvRefusals.h"

#include <algorithm>

namespace Drydock
{

using namespace Spirv;

namespace
{

const char* const NoDerivatives = "only pixel shaders have derivatives: other threads do not run in quads. Compute the "
								  "step from the texel size, or use "
								  "SampleLevel";
const char* const NoWaves = "wave operations run in compute shaders only: pixels have no order that waves could be "
							"cut from. Read the neighbouring texels instead";
const char* const NoQuads = "quad operations are not supported on the CPU tier: threads do not run in quads. Read the "
							"neighbouring texels instead";
struct FRow
{
	uint16_t Op;
	const char* Name;
	const char* Instead;
	const char* PrefixName = nullptr; // of the scan, where the operation is one
};

constexpr size_t GroupOperation = 1; // operand of wave arithmetic: 0 reduces, all else scans

// clang-format off
const FRow Rows[] = {
	{OpDPdx, "ddx", NoDerivatives}, {OpDPdy, "ddy", NoDerivatives}, {OpFwidth, "fwidth", NoDerivatives},
	{210, "ddx_fine", NoDerivatives}, {211, "ddy_fine", NoDerivatives}, {212, "fwidth", NoDerivatives},
	{213, "ddx_coarse", NoDerivatives}, {214, "ddy_coarse", NoDerivatives}, {OpFwidthCoarse, "fwidth", NoDerivatives},
	{OpImageQueryLod, "CalculateLevelOfDetail",
		"it needs derivatives, which only pixel shaders have. Compute the mip level and use SampleLevel"},
	{OpImageQuerySamples, "GetDimensions of a Texture2DMS",
		"multisampled textures are not supported on the CPU tier. Use Texture2D"},
	{OpGroupNonUniformElect, "WaveIsFirstLane", NoWaves}, {334, "WaveActiveAllTrue", NoWaves},
	{335, "WaveActiveAnyTrue", NoWaves}, {336, "WaveActiveAllEqual", NoWaves}, {337, "WaveReadLaneAt", NoWaves},
	{338, "WaveReadLaneFirst", NoWaves}, {339, "WaveActiveBallot", NoWaves}, {340, "WaveActiveBallot", NoWaves},
	{341, "WaveActiveBallot", NoWaves}, {342, "WaveActiveCountBits", NoWaves, "WavePrefixCountBits"},
	{343, "WaveActiveBallot", NoWaves}, {344, "WaveActiveBallot", NoWaves}, {345, "WaveReadLaneAt", NoWaves},
	{346, "WaveReadLaneAt", NoWaves}, {347, "WaveReadLaneAt", NoWaves}, {348, "WaveReadLaneAt", NoWaves},
	{349, "WaveActiveSum", NoWaves, "WavePrefixSum"}, {350, "WaveActiveSum", NoWaves, "WavePrefixSum"},
	{351, "WaveActiveProduct", NoWaves, "WavePrefixProduct"}, {352, "WaveActiveProduct", NoWaves, "WavePrefixProduct"},
	{353, "WaveActiveMin", NoWaves}, {354, "WaveActiveMin", NoWaves}, {355, "WaveActiveMin", NoWaves},
	{356, "WaveActiveMax", NoWaves}, {357, "WaveActiveMax", NoWaves}, {358, "WaveActiveMax", NoWaves},
	{359, "WaveActiveBitAnd", NoWaves}, {360, "WaveActiveBitOr", NoWaves}, {361, "WaveActiveBitXor", NoWaves},
	{362, "WaveActiveBitAnd", NoWaves}, {363, "WaveActiveBitOr", NoWaves}, {364, "WaveActiveBitXor", NoWaves},
	{365, "QuadReadLaneAt", NoQuads}, {OpGroupNonUniformQuadSwap, "QuadReadAcross*", NoQuads},
};
// clang-format on

std::string GetImageName(const FSpirvModule& Module, const FSpirvType& Type)
{
	const char* const Kind = Type.Dim == Dim1D       ? "Texture1D"
							 : Type.Dim == Dim3D     ? "Texture3D"
							 : Type.Dim == DimCube   ? "TextureCube"
							 : Type.Dim == DimBuffer ? "Buffer"
							 : Type.Dim == Dim2D     ? (Type.bMultisampled ? "Texture2DMS" : "Texture2D")
													 : "SubpassInput";
	return std::string(Type.bStorageImage ? "RW" : "") + Kind + (Type.bArrayed ? "Array" : "") + "<" +
		   GetHlslTypeName(Module, Module.GetType(Type.Element)) + "4>";
}

} // namespace

std::string ExplainRefusedOp(uint16_t Op, const uint32_t* Operands, size_t NumOperands)
{
	const auto Row = std::ranges::find(Rows, Op, &FRow::Op);
	if (Row == std::end(Rows))
	{
		return {};
	}
	const bool bScan = Row->PrefixName && NumOperands > GroupOperation && Operands[GroupOperation] != 0;
	return std::string(bScan ? Row->PrefixName : Row->Name) + ": " + Row->Instead;
}

std::string ExplainRefusedBuiltIn(uint32_t BuiltIn)
{
	const char* const Name = BuiltIn == BuiltInSubgroupSize                ? "WaveGetLaneCount"
							 : BuiltIn == BuiltInSubgroupLocalInvocationId ? "WaveGetLaneIndex"
																		   : nullptr;
	return Name ? std::string(Name) + ": " + NoWaves : std::string();
}

const char* GetHlslScalarName(ESpirvType Kind)
{
	constexpr const char* Names[] = {
		"bool", "int", "uint", "float", "float16_t", "int16_t", "uint16_t", "double", "int64_t", "uint64_t"};
	return IsSpirvScalar(Kind) ? Names[size_t(Kind) - size_t(ESpirvType::Bool)] : "float";
}

std::string GetHlslTypeName(const FSpirvModule& Module, const FSpirvType& Type)
{
	if (IsSpirvScalar(Type.Kind))
	{
		return GetHlslScalarName(Type.Kind);
	}
	switch (Type.Kind)
	{
	case ESpirvType::Void:
		return "void";
	case ESpirvType::Vector:
		return GetHlslTypeName(Module, Module.GetType(Type.Element)) + std::to_string(Type.Count);
	case ESpirvType::Matrix:
	{
		// A row of HLSL is a column of SPIR-V.
		const FSpirvType& Row = Module.GetType(Type.Element);
		const bool bVector = Row.Kind == ESpirvType::Vector;
		return GetHlslTypeName(Module, bVector ? Module.GetType(Row.Element) : Row) + std::to_string(Type.Count) + "x" +
			   std::to_string(bVector ? Row.Count : 1);
	}
	case ESpirvType::Array:
	case ESpirvType::RuntimeArray:
	{
		std::string Dimensions;
		const FSpirvType* Inner = &Type;
		for (; Inner->Kind == ESpirvType::Array || Inner->Kind == ESpirvType::RuntimeArray;
			 Inner = &Module.GetType(Inner->Element))
		{
			Dimensions += "[" + (Inner->Kind == ESpirvType::Array ? std::to_string(Inner->Count) : std::string()) + "]";
		}
		return GetHlslTypeName(Module, *Inner) + Dimensions;
	}
	case ESpirvType::Struct:
		return Type.Name.empty() ? "a struct" : Type.Name;
	case ESpirvType::Pointer:
		return GetHlslTypeName(Module, Module.GetType(Type.Element));
	case ESpirvType::Image:
		return GetImageName(Module, Type);
	case ESpirvType::Sampler:
		return "SamplerState";
	case ESpirvType::SampledImage:
		return GetHlslTypeName(Module, Module.GetType(Type.Element)) + " with its sampler";
	default:
		return "this type";
	}
}

} // namespace Drydock
