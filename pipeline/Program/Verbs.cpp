// Collects the verbs that register themselves.
#include "Program/Verbs.h"

#include <algorithm>

namespace Drydock
{

namespace
{

/** Made by the first registration, because files are initialised in no defined order. */
std::vector<FVerb>& GetRegistered()
{
	static std::vector<FVerb> Verbs;
	return Verbs;
}

} // namespace

const char* ToString(EVerbGroup Group)
{
	constexpr const char* Titles[] = {"Run", "Ask what happens in a frame, and why", "Measure and compare",
		"Look up, import and export", "Make patches and plugins", "For shells and editors"};
	return Titles[size_t(Group)];
}

FVerbRegistration::FVerbRegistration(const FVerb& Verb)
{
	GetRegistered().push_back(Verb);
}

std::vector<FVerb> GetVerbs()
{
	std::vector<FVerb> Verbs = GetRegistered();
	std::sort(Verbs.begin(), Verbs.end(), [](const FVerb& A, const FVerb& B) { return A.Place < B.Place; });
	return Verbs;
}

} // namespace Drydock
