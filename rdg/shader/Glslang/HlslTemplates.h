// Declarations of templates, read out of a shader's tokens.
#pragma once

#include "HlslTokens.h"

#include <map>
#include <set>

namespace Drydock
{

struct FHlslTemplateParameter
{
	std::string Name;
	std::string Default;
};

struct FHlslTemplate
{
	std::string Name;
	std::vector<FHlslTemplateParameter> Parameters;
	FHlslTokens Declaration; // behind template<...>
	size_t NameAt = 0;       // in Declaration
	bool bStruct = false;
};

/** By name; those of one name differ in their parameters. */
using FHlslTemplates = std::map<std::string, std::vector<FHlslTemplate>>;

/** Takes the declarations out of the text. `template<> float F<int>(...)` becomes a function of the name that F<int>
 * stands for, which is added to Specializations. */
FHlslTemplates TakeHlslTemplates(
	FHlslText& Text, std::set<std::string>& Specializations, std::vector<FDiagnostic>& Errors);

/** "F_float_3" for F<float, 3>. */
std::string MangleHlslName(const std::string& Name, const std::vector<std::string>& Arguments);

/** The arguments of "<A, B<C>>", whose first token is Open and whose last is before End. */
std::vector<std::string> SplitHlslList(const FHlslText& Text, size_t Open, size_t End);

} // namespace Drydock
