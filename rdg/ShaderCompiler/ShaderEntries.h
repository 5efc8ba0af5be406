// Functions of a shader's text, and which of them are its entry points.
#pragma once

#include "HlslTokens.h"
#include "ShaderCompileRequest.h"

namespace Drydock
{

/** A function of the text: its name, and the tokens of its body. */
struct FFunctionText
{
	size_t Name = 0;
	size_t Parameters = 0; // of its parameters' (
	size_t Body = 0;       // of its {
};

std::vector<FFunctionText> ListFunctionTexts(const FHlslText& Text);

/** An entry point as the text declares it. */
struct FShaderEntry
{
	std::string Name;
	EShaderStage Stage = EShaderStage::Compute;
};

/** Entry points of a file that no shader class names: functions with [numthreads], and those with SV_Target; of
 * SPIR-V the module's. Request: its file and defines. */
DRYDOCK_API std::vector<FShaderEntry> FindShaderEntries(const FShaderCompileRequest& Request);

/** The text of a file for each of its entry points, without the other entry points and what only they use. */
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
