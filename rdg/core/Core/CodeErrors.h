// Numbers the messages about failures of a plugin's code. A number never changes its meaning; docs/errors.md explains
// each one.
#pragma once

namespace Drydock
{

enum ECodeError
{
	ErrorPluginCrashed = 2086, // a signal, exit or std::terminate in its code
	ErrorPluginThrew = 2087,   // an exception, or a failed check of its own
	ErrorPluginCall = 2088,    // a call that drydock refuses by a check
	ErrorPluginSilent = 2089,  // it does not come back
};

} // namespace Drydock
