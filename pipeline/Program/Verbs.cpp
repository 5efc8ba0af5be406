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
	switch (Group)
	{
	case EVerbGroup::Run:
		return "Run";
	case EVerbGroup::Ask:
		return "Ask what happens in a frame, and why";
	case EVerbGroup::Measure:
		return "Measure and compare";
	case EVerbGroup::LookUp:
		return "Look up, import and export";
	case EVerbGroup::Patch:
		return "Make patches and plugins";
	case EVerbGroup::Shell:
		break;
	}
	return "For shells and editors";
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
