// The list of the program's verbs. Each has a row in VerbTable.inl, and a file of its own (VerbRun.cpp, ...) with its
// options.
#pragma once

#include "Diagnostics.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace Drydock
{

class FVerbOptions;

/** Runs a verb once its options are read; returns the program's exit code. stdout is the result, stderr the log. Throws
 * FError, which the program prints and whose exit code it ends with. */
using FVerbCall = std::function<int()>;

/** The call of a verb's function with its options. */
template<typename TOptions, typename TFunction>
FVerbCall CallWith(std::shared_ptr<TOptions> Options, TFunction Function)
{
	return [Options, Function]
	{
		return Function(*Options);
	};
}

/** The purpose of a verb, by which verbs are listed. */
enum class EVerbGroup
{
	Run,
	Ask,
	Measure,
	LookUp,
	Patch,
	Shell,
};

/** As a heading: "Run". */
const char* ToString(EVerbGroup Group);

struct FVerb
{
	const char* Name; // as it is typed; "settings plan" stands under the verb "settings"
	EVerbGroup Group;
	const char* Doc; // one line of --help, of 66 characters at most

	/** Adds the options, which the returned call owns. The call is empty for a verb that has only verbs under it. Null
	 * for a tool that this build leaves out. */
	FVerbCall (*AddOptions)(FVerbOptions& Verb);
};

#define DRYDOCK_VERB(Name, Group, AddOptions, Doc) FVerbCall AddOptions(FVerbOptions& Verb);
#define DRYDOCK_TOOL DRYDOCK_VERB
#include "Program/VerbTable.inl"
#undef DRYDOCK_TOOL
#undef DRYDOCK_VERB

/** All verbs, in the order of VerbTable.inl. */
const std::vector<FVerb>& GetVerbs();

/** A command that --help prints. */
struct FVerbExample
{
	const char* Verb; // "settings plan"; empty: of the program itself
	const char* Arguments;

	/** As a shell takes it. */
	DRYDOCK_API std::string GetCommand() const;
};

/** In the order in which they run: some read what those before them wrote. */
DRYDOCK_API const std::vector<FVerbExample>& GetVerbExamples();

} // namespace Drydock
