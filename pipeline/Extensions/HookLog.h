// Records the calls of a frame's view extensions and what they did, and the points of the chain where they could be
// called. Plain data: for run.json, `drydock list hooks` and tests.
#pragma once

#include "Diagnostics.h"

#include <string>
#include <vector>

namespace Drydock
{

/** One call of a hook that the extension's class overrides, or of a callback it subscribed, in the order of the frame.
 */
struct FHookCall
{
	std::string Hook;            // "SetupView", "SubscribeToPostProcessingPass(Tonemap)", "Tonemap"
	std::string View;            // empty: the whole family
	std::string Extension;       // its class, or its type in the config; the second of a kind is "FTint #2"
	std::string Did;             // what came of it, in words; empty: nothing that can be seen from outside
	std::string Scope;           // event scope of the passes it added; empty: it had no graph
	bool bReturnedInput = false; // of a callback
};

/** One insertion point of one view. */
struct FHookPoint
{
	std::string Point; // "PrePostProcessPass", "MotionBlur", ...
	std::string View;
	std::string Space;    // what its picture is: "linear HDR, pre-exposed" or "display-encoded"
	std::string Resource; // texture that the first callback gets; empty when the point was not reached
	std::string Format;   // "PF_FloatRGBA"
	int Width = 0;        // of the view's rect in it
	int Height = 0;
	std::vector<std::string> Subscribers;
	bool bCalled = false; // somebody was there and was called
	std::string Reason;   // why nobody was called, or what else is to be known
};

struct FHookLog
{
	std::vector<FHookCall> Calls;
	std::vector<FHookPoint> Points;
	std::vector<FDiagnostic> Diagnostics;
};

} // namespace Drydock
