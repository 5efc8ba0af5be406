// Answers about the state's frame that need a run of their own. Asked: the body and the query of the page's request.
#pragma once

#include "Picture/Picture.h"
#include "Text/Json.h"

#include <string>

namespace Drydock
{

class FLiveSession;

/** A texture right after a pass. Asked: pass, resource. Throws FError where there is none. */
FPicture ReadPassPicture(FLiveSession& Session, const FJsonValue& Asked);

/** JSON by report/report.schema.json of the state's frame, without its large pictures. */
std::string MakeLiveReport(FLiveSession& Session, const FJsonValue& Asked);

/** The story of a setting, as `drydock blend --json` has it. Asked: setting. Throws FError where there is none. */
std::string MakeLedgerJson(FLiveSession& Session, const FJsonValue& Asked);

/** {"text", "json"}: the output of `drydock probe` for a texel of the frame. Asked: x, y, pass (a pattern; empty: all).
 */
std::string ProbeLive(FLiveSession& Session, const FJsonValue& Asked);

/** {"text", "json"}: the output of `drydock trace`. Asked: as above. */
std::string TraceLive(FLiveSession& Session, const FJsonValue& Asked);

/** Measures time and error of the state, and keeps them as a dot. Returns the dot as JSON. Throws FError as soon as a
 * change of the state waits. */
std::string MeasurePrice(FLiveSession& Session, const FJsonValue& Asked);

} // namespace Drydock
