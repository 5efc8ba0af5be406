// Finds the places of inputs and outputs by their semantics.
#include "SpirvReflect.h"
#include "VertexProgram.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace Drydock
{

using namespace Spirv;

std::string NormaliseSemantic(const std::string& Semantic, int32_t More)
{
	const size_t Digits = Semantic.find_last_not_of("0123456789") + 1;
	std::string Name = Semantic.substr(0, Digits);
	std::ranges::transform(Name, Name.begin(), [](unsigned char c) { return char(std::toupper(c)); });
	return Name + std::to_string(std::atoll(Semantic.c_str() + Digits) + More);
}

int32_t GetSemanticIndex(const std::string& Semantic, const std::string& Prefix)
{
	if (Semantic.size() < Prefix.size())
	{
		return -1;
	}
	for (size_t i = 0; i < Semantic.size(); ++i)
	{
		const char c = char(std::toupper(static_cast<unsigned char>(Semantic[i])));
		if (i < Prefix.size() ? c != Prefix[i] : !std::isdigit(static_cast<unsigned char>(c)))
		{
			return -1;
		}
	}
	const int Index = std::atoi(Semantic.c_str() + Prefix.size());
	return Semantic.size() - Prefix.size() <= 2 && Index < 16 ? Index : -1;
}

int32_t GetInterpolantIndex(const FSpirvVariable& Variable)
{
	const std::string Semantic = Variable.BuiltIn == BuiltInNone ? NormaliseSemantic(Variable.Semantic, 0) : "";
	const int32_t Color = GetSemanticIndex(Semantic, "COLOR");
	const int32_t Numbered = Color >= 0 && Color < GFirstNamedInterpolant - GMaxTexCoords
								 ? GMaxTexCoords + Color
								 : GetSemanticIndex(Semantic, "TEXCOORD");
	const bool bNamed = Numbered < 0 && !Variable.Semantic.empty() && !Semantic.empty() &&
						!Semantic.starts_with("SV_") && Variable.Location < GMaxInterpolants - GFirstNamedInterpolant;
	return bNamed ? GFirstNamedInterpolant + int32_t(Variable.Location) : Numbered;
}

} // namespace Drydock
