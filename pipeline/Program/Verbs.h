// The list of the program's verbs: each registers itself from a file of its own (VerbRun.cpp, ...), with its options
// and its help, so that a new verb needs no other file.
#pragma once

#include "Diagnostics.h"

#include <functional>
#include <memory>
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
	int Place;        // --help lists the verbs of a group by ascending places, which are all different
	EVerbGroup Group;
	const char* Doc; // one line of --help, of 66 characters at most

	/** Adds the options, which the returned call owns. The call is empty for a verb that has only verbs under it. */
	FVerbCall (*AddOptions)(FVerbOptions& Verb);
};

/** `const FVerbRegistration Registration({.Name = "run", ...});` in the verb's file adds it to the program. */
struct FVerbRegistration
{
	explicit FVerbRegistration(const FVerb& Verb);
};

/** All verbs, in ascending order of their places. */
std::vector<FVerb> GetVerbs();

} // namespace Drydock
