// Summarizes a finished run for people.
#pragma once

#include <optional>
#include <string>

namespace Drydock
{

struct FRunResult;

/** Several lines: passes with their times, what was decoded, memory, where the picture is. SaveMs: milliseconds that
 * writing took. PageMs: that report.html took; nothing: there is none. */
std::string MakeRunSummary(
	const FRunResult& Result, const std::string& Folder, double SaveMs, std::optional<double> PageMs, int Width);

} // namespace Drydock
