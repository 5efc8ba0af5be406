// The numbers of the messages about view extensions and inserted passes. A number never changes its meaning;
// docs/errors.md explains each one.
#pragma once

namespace Drydock
{

enum EExtensionError
{
	// A callback's result is not valid; the run goes on with the picture untouched unless r.RDG.Validation is 2.
	ErrorCallbackInvalidTexture = 2060, // no texture, or an empty rect
	ErrorCallbackRect = 2061,           // a rect that is not inside the texture
	ErrorCallbackOverride = 2062,       // not OverrideOutput, though that was valid
	ErrorCallbackNotDrawn = 2063,       // OverrideOutput, with nothing drawn to it
	NoteCallbackReturnedInput = 2064,   // though it added passes, which nobody reads
	NoteCallbackDidNothing = 2065,      // it returned its input and added no pass
	NoteCallbackSize = 2066,            // a view of another size than its input
	WarnCallbackFormat = 2067,          // a format that cuts light at 1, before the tonemapper

	WarnHookNeverCalled = 2070,   // an override that this engine version does not call
	WarnEngineDiffers = 2071,     // compiled for another engine version than the run's
	WarnCallbackDropped = 2072,   // a callback after the last enabled pass: its texture is not seen
	WarnCallbackUnbound = 2073,   // the object of a callback is gone
	WarnPointNotReached = 2074,   // subscribed where this frame does not call
	NotePluginIdle = 2076,        // none of its extensions took part
	NotePluginUnmapped = 2077,    // drydock maps its shaders, it does not
	WarnEngineUnknown = 2075,     // compiled for an engine version that there is no row of
	WarnPluginNames = 2078,       // it uses names that its engine version does not have, and nobody named the version
	ErrorPluginRefused = 2079,    // one that a config names in a run without plugins
	ErrorUnknownExtension = 2080, // no extension type of that name
	ErrorUnknownPass = 2081,      // no pass type of that name
	ErrorPassInput = 2082,        // an input that the pass does not have, or a resource that is not there
	ErrorPluginNotLoaded = 2083,  // a shared object that cannot be loaded
	WarnPluginEmpty = 2084,       // it was loaded and registered nothing
	WarnPluginNotReloaded = 2085, // a changed one whose old form cannot be unloaded
};

} // namespace Drydock
