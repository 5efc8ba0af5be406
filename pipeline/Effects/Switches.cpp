// Decides by settings that are neutral or not.
#include "Effects/Switches.h"

#include "Text/TextFormat.h"

#include <algorithm>

namespace Drydock
{

FEffectDecision DecideBySwitches(
	const FEffect& Effect, const FEffectInputs& Inputs, std::span<const FSwitch> Switches, const std::string& Place)
{
	FEffectDecision Decision;
	Decision.bConfigured = std::ranges::any_of(
		*Effect.Settings, [&](const FSettingClaim& Claim) { return Inputs.IsNamed(Claim.Beginning); });
	for (const FSwitch& Switch : Switches)
	{
		Decision.Reason += (Decision.Reason.empty() ? "" : ", ") + std::string(Switch.Setting) +
						   (Decision.Reason.empty() ? " is " : " ") + NumberText(Inputs.Settings.*Switch.Member);
	}
	const bool bNeutral = std::all_of(Switches.begin(), Switches.end(),
		[&](const FSwitch& Switch) { return Inputs.Settings.*Switch.Member == Switch.Neutral; });
	if (bNeutral)
	{
		Decision.Reason += Decision.bConfigured ? ": neutral" : ": neutral, and nothing in the config sets it";
	}
	else if (!Inputs.Conditions.ShowFlags.PostProcessing)
	{
		Decision.Reason = "ShowFlag.PostProcessing is off";
	}
	else
	{
		Decision.bActive = true;
		Decision.Reason += Place;
	}
	return Decision;
}

} // namespace Drydock
