// Decides for effects that run where one of their settings is not neutral.
#pragma once

#include "Effects/Effect.h"

namespace Drydock
{

/** A setting that switches an effect on, and the value at which it does nothing. */
struct FSwitch
{
	const char* Setting;
	float FPostProcessSettings::*Member;
	float Neutral;
};

/** Active where one of Switches is not neutral; the reason lists them. Place: ends the reason of an active one. */
FEffectDecision DecideBySwitches(
	const FEffect& Effect, const FEffectInputs& Inputs, std::span<const FSwitch> Switches, const std::string& Place);

} // namespace Drydock
