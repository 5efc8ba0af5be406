// Summarizes a finished run for people.
#pragma once

#include <string>

namespace Drydock
{

struct FRunResult;

/** Several lines: passes with their times, what was decoded, memory, where the picture is. SaveMs: milliseconds that
 * writing took. */
std::string MakeRunSummary(const FRunResult& Result, const std::string& Folder, double SaveMs, int Width);

} // namespace Drydock
