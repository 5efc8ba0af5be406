// Lists the functions of a shader's text, finds its entry points, and gives each of these a text of its own.
#pragma once

#include "HlslTokens.h"
#include "ShaderCompileRequest.h"

namespace Drydock
{

/** A function with a body. Indices are into FHlslText::Tokens. */
struct FFunctionText
{
	size_t Name = 0;
	size_t Parameters = 0; // the ( of its parameters
	size_t Body = 0;       // the { of its body
};

/** In the order of the text. Declarations without a body are not listed. */
std::vector<FFunctionText> ListFunctionTexts(const FHlslText& Text);

/** An entry point as the text declares it. */
struct FShaderEntry
{
	std::string Name;
	EShaderStage Stage = EShaderStage::Compute;
};

/** Finds the entry points of a file that no shader class names: functions with [numthreads] or SV_Target, or those of
 * a SPIR-V module. Request: the file and its defines. Throws FError as FlattenShader does. */
DRYDOCK_API std::vector<FShaderEntry> FindShaderEntries(const FShaderCompileRequest& Request);

/** The flattened text of a file for each of its entry points: without those other entry points that nothing else
 * mentions. So each text parses in a time of its own size. */
class DRYDOCK_API FEntryTexts
{
public:
	/** Flattens the file, of any of its entry points; throws as FlattenShader does. */
	explicit FEntryTexts(const FShaderCompileRequest& Request);

	/** Empty: no such entry point can be distinguished from the others. */
	std::string GetText(const std::string& Entry) const;

private:
	std::vector<std::pair<std::string, std::string>> Parts; // the entry point that needs it, or nothing: all do
};

} // namespace Drydock
