// The table of the names that shaders find below /Engine (rdg/graph/Shaders/EngineNames.txt), and what a shader uses of
// drydock's own that is not in it.
#pragma once

#include "HlslTokens.h"
#include "ShaderCompileRequest.h"

namespace Drydock
{

/** A row of the table; its head documents the columns. */
struct FEngineName
{
	std::string Name;
	std::string File; // virtual path; it ends with the name where the row is the file's own
	std::string From;
	std::string Until;
	std::string Deprecated;
	std::string Certainty; // "public", "uncertain", "article" or "drydock"

	bool IsFile() const { return File.ends_with("/" + Name); }
	bool IsEngines() const { return Certainty == "public" || Certainty == "uncertain"; }
};

/** The rows in the order of the file. */
DRYDOCK_API const std::vector<FEngineName>& GetEngineNames();

/** The tokens of the names that a text defines at file scope: functions, structs, constants. */
DRYDOCK_API std::vector<size_t> ListDefinitions(const FHlslText& Text);

/** Whether the virtual path is a file that drydock ships, and no other in its place. */
DRYDOCK_API bool IsShipped(const std::string& File, const FShaderCompileRequest& Request);

struct FNotInEngine
{
	std::string File; // virtual path
	int Line = 0;
	std::string What; // the name, where it is defined, and what the engine has
};

/** The engine 5.X that names must be of; 0, as at first: any. Not for several threads. */
DRYDOCK_API void SetLintEngine(int Minor);

/** The includes and names of drydock's own in those files of a flattened text that drydock does not ship; and the
 * engine's names that the version of SetLintEngine does not have. */
std::vector<FNotInEngine> FindNotInEngine(const FHlslText& Text, const FShaderCompileRequest& Request);

} // namespace Drydock
