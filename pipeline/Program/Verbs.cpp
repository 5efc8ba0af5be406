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
