// Answers about the state's frame that need a run of their own.
#pragma once

#include "Picture/Picture.h"

#include <functional>
#include <string>

namespace Drydock
{

class FLiveSession;

/** A texture right after a pass. Throws FError where there is none. */
FPicture ReadPassPicture(FLiveSession& Session, int Pass, const std::string& Resource);

/** JSON by report/report.schema.json of the state's frame, without its large pictures. */
std::string MakeLiveReport(FLiveSession& Session);

/** The story of a setting, as `drydock blend --json` has it. Throws FError where there is none of this name. */
std::string MakeLedgerJson(FLiveSession& Session, const std::string& Setting);

/** {"text", "json"}: the output of `drydock probe` for a pixel of the frame. Pass: a pattern; empty: all. */
std::string ProbeLive(FLiveSession& Session, int X, int Y, const std::string& Pass);

/** {"text", "json"}: the output of `drydock trace`. */
std::string TraceLive(FLiveSession& Session, int X, int Y, const std::string& Pass);

/** Measures time and error of the state, and keeps them as a dot. Returns the dot as JSON. IsLate: whether another
 * state waits; then it throws FError. */
std::string MeasurePrice(FLiveSession& Session, const std::function<bool()>& IsLate);

} // namespace Drydock
