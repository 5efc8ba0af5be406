// Reads which findings a shader lets the portability lint leave out: "// drydock-lint: allow RULE: WHY".
#pragma once

#include "ShaderCompileRequest.h"

#include <map>
#include <set>
#include <string>
#include <utility>

namespace Drydock
{

/** Reads each file of a shader once. Request has to live as long. */
class FLintAllowances
{
public:
	explicit FLintAllowances(const FShaderCompileRequest& InRequest)
		: Request(InRequest)
	{
	}

	/** Whether the line of a finding, or the one above it, allows the rule. Line 0 is the whole shader: an allowance
	 * anywhere in the file counts. */
	bool Allows(const std::string& Rule, const std::string& File, int Line);

private:
	const FShaderCompileRequest& Request;
	std::map<std::string, std::set<std::pair<std::string, int>>> Files; // rule and line; line 0 too for each
};

} // namespace Drydock
