// Tables of HLSL's names.
#include "ShaderTypeNames.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace Drydock
{

namespace
{

const char* GetDimensionName(EShaderDimension Dimension)
{
	switch (Dimension)
	{
	case EShaderDimension::Texture2DArray:
		return "Texture2DArray";
	case EShaderDimension::Texture3D:
		return "Texture3D";
	case EShaderDimension::TextureCube:
		return "TextureCube";
	case EShaderDimension::TypedBuffer:
		return "Buffer";
	case EShaderDimension::StructuredBuffer:
		return "StructuredBuffer";
	case EShaderDimension::ByteAddressBuffer:
		return "ByteAddressBuffer";
	default:
		return "Texture2D";
	}
}

} // namespace

const char* GetScalarName(EShaderScalar Scalar)
{
	switch (Scalar)
	{
	case EShaderScalar::Int:
		return "int";
	case EShaderScalar::Uint:
		return "uint";
	case EShaderScalar::Bool:
		return "bool";
	case EShaderScalar::Half:
		return "float16_t";
	case EShaderScalar::Short:
		return "int16_t";
	case EShaderScalar::Ushort:
		return "uint16_t";
	case EShaderScalar::Double:
		return "double";
	case EShaderScalar::Long:
		return "int64_t";
	case EShaderScalar::Ulong:
		return "uint64_t";
	default:
		return "float";
	}
}

int GetBits(EShaderScalar Scalar)
{
	return Scalar <= EShaderScalar::Bool ? 32 : Scalar <= EShaderScalar::Ushort ? 16 : 64;
}

int GetElementBits(const std::string& MacroText)
{
	static const std::map<std::string, int> Types = {{"float", 32}, {"int", 32}, {"uint", 32}, {"float16_t", 16},
		{"int16_t", 16}, {"uint16_t", 16}, {"double", 64}, {"int64_t", 64}, {"uint64_t", 64}};
	const size_t Open = MacroText.find('<');
	const size_t Close = MacroText.rfind('>');
	std::string Name = Open < Close && Close != std::string::npos ? MacroText.substr(Open + 1, Close - Open - 1) : "";
	std::erase(Name, ' ');
	if (!Name.empty() && Name.back() >= '1' && Name.back() <= '4')
	{
		Name.pop_back(); // components
	}
	const auto Known = Types.find(Name);
	return Known == Types.end() ? 0 : Known->second;
}

std::string WithElements(const std::string& Type, uint32_t NumElements)
{
	return NumElements ? Type + "[" + std::to_string(NumElements) + "]" : Type;
}

std::string GetTypeName(const FShaderConstant& Constant)
{
	std::string Name = GetScalarName(Constant.Scalar);
	if (Constant.Rows > 1)
	{
		Name += std::to_string(Constant.Rows) + "x" + std::to_string(Constant.Columns);
	}
	else if (Constant.Columns > 1)
	{
		Name += std::to_string(Constant.Columns);
	}
	return WithElements(Name, static_cast<uint32_t>(Constant.NumElements));
}

std::string GetTypeName(EResourceList List, const FShaderResource& Resource)
{
	if (List == EResourceList::Samplers)
	{
		return "SamplerState";
	}
	const bool bWrites = List == EResourceList::RWTextures || List == EResourceList::RWBuffers;
	return std::string(bWrites ? "RW" : "") + GetDimensionName(Resource.Dimension);
}

bool Accepts(EResourceList List, EUniformBufferBaseType BaseType)
{
	switch (List)
	{
	case EResourceList::Textures:
		return BaseType == UBMT_TEXTURE || BaseType == UBMT_SRV || BaseType == UBMT_RDG_TEXTURE ||
			   BaseType == UBMT_RDG_TEXTURE_SRV;
	case EResourceList::RWTextures:
		return BaseType == UBMT_UAV || BaseType == UBMT_RDG_TEXTURE_UAV;
	case EResourceList::Samplers:
		return BaseType == UBMT_SAMPLER;
	case EResourceList::Buffers:
		return BaseType == UBMT_SRV || BaseType == UBMT_RDG_BUFFER_SRV;
	case EResourceList::RWBuffers:
		return BaseType == UBMT_UAV || BaseType == UBMT_RDG_BUFFER_UAV;
	}
	return false;
}

bool TypeTextAgrees(const std::string& MacroText, const std::string& HlslType)
{
	const std::string Kind = MacroText.substr(0, MacroText.find_first_of("< "));
	static const char* const Kinds[] = {"Texture2D", "Texture2DArray", "Texture3D", "TextureCube", "Buffer",
		"StructuredBuffer", "ByteAddressBuffer", "RWTexture2D", "RWTexture2DArray", "RWTexture3D", "RWBuffer",
		"RWStructuredBuffer", "RWByteAddressBuffer"};
	const bool bKnown = std::ranges::any_of(Kinds, [&Kind](const char* Known) { return Kind == Known; });
	return !bKnown || Kind == HlslType;
}

} // namespace Drydock
