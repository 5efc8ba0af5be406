// Tables of HLSL's names.
#include "ShaderTypeNames.h"

#include <algorithm>
#include <map>

namespace Drydock
{

namespace
{

const char* GetDimensionName(EShaderDimension Dimension)
{
	constexpr const char* Names[] = {
		"Texture2D", "Texture2DArray", "Texture3D", "TextureCube", "Buffer", "StructuredBuffer", "ByteAddressBuffer"};
	return Names[size_t(Dimension)];
}

} // namespace

const char* GetScalarName(EShaderScalar Scalar)
{
	constexpr const char* Names[] = {
		"float", "int", "uint", "bool", "float16_t", "int16_t", "uint16_t", "double", "int64_t", "uint64_t"};
	return Names[size_t(Scalar)];
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
	return List == EResourceList::Textures ? BaseType == UBMT_TEXTURE || BaseType == UBMT_SRV ||
												 BaseType == UBMT_RDG_TEXTURE || BaseType == UBMT_RDG_TEXTURE_SRV
		   : List == EResourceList::RWTextures ? BaseType == UBMT_UAV || BaseType == UBMT_RDG_TEXTURE_UAV
		   : List == EResourceList::Samplers   ? BaseType == UBMT_SAMPLER
		   : List == EResourceList::Buffers    ? BaseType == UBMT_SRV || BaseType == UBMT_RDG_BUFFER_SRV
		   : List == EResourceList::RWBuffers  ? BaseType == UBMT_UAV || BaseType == UBMT_RDG_BUFFER_UAV
											   : false;
}

bool TypeTextAgrees(const std::string& MacroText, const std::string& HlslType)
{
	// The macro itself says whether the shader writes. The engine writes SHADER_PARAMETER_RDG_BUFFER_UAV with
	// StructuredBuffer, too.
	const auto WithoutRW = [](const std::string& Kind)
	{
		return Kind.starts_with("RW") ? Kind.substr(2) : Kind;
	};
	const std::string Kind = WithoutRW(MacroText.substr(0, MacroText.find_first_of("< ")));
	static const char* const Kinds[] = {
		"Texture2D", "Texture2DArray", "Texture3D", "TextureCube", "Buffer", "StructuredBuffer", "ByteAddressBuffer"};
	const bool bKnown = std::ranges::any_of(Kinds, [&Kind](const char* Known) { return Kind == Known; });
	return !bKnown || Kind == WithoutRW(HlslType);
}

} // namespace Drydock
