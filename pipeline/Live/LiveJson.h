// Writes JSON for the page: messages, frames, states.
#pragma once

#include "Text/Json.h"

#include <cstdint>
#include <string>
#include <vector>

namespace Drydock
{

struct FRunResult;
class FLiveSession;

/** {"messages": [{severity, code, message, where, file, line}]} */
std::string MakeMessagesJson(const std::vector<FDiagnostic>& Messages);

/** The event "fault": a state of which no frame was made, and why; errors come first. */
std::string MakeFaultJson(uint64_t Revision, std::vector<FDiagnostic> Messages);

/** The event "frame". WholeMs: from the state to its picture. */
std::string MakeFrameJson(uint64_t Revision, const FRunResult& Result, double WholeMs);

/** All that a page shows of a session. Begins its run. */
std::string MakeStateJson(FLiveSession& Session, const FJsonValue& Asked);

/** {"pictures"}: files beside the config and one folder below, at most 200, as the config would name them. */
std::string ListPictures(FLiveSession& Session, const FJsonValue& Asked);

} // namespace Drydock
