// Builds the data of a report as one JSON: the reports that a run makes anyway, the figures that they lack, and the
// pictures. Its form is report/report.schema.json; docs/report.md describes each member.
#pragma once

#include "Run/RunResult.h"

#include <optional>
#include <set>
#include <string>

namespace Drydock
{

/** Files of the run before, as text; empty where there is none. */
struct FReportBefore
{
	std::string RunJson;
	std::string TimingJson;
	std::string FinalPng; // bytes
	std::string When;     // UTC, as When of FReportInputs
};

/** Reads run.json, timing.json and final.png of a folder. The result is empty if run.json is missing or damaged. */
DRYDOCK_API FReportBefore ReadReportBefore(const std::string& Folder);

struct FReportInputs
{
	const FRunResult& Result;                     // executed, with bKeepForReport
	std::string Name;                             // of the page
	std::string When;                             // UTC, "2025-01-31T12:00:00Z"; empty: now
	std::string TimingJson;                       // of timing.json
	std::string ExplainJson;                      // MakeExplainJson; empty: not known
	std::string BlendJson;                        // MakeBlendJson; empty: not known
	std::string WalkJson;                         // MakeSceneWalkJson; empty: none
	std::optional<std::set<std::string>> Touched; // settings that somebody gives; nothing: not known, all that differ
	std::string Folder;                           // where the run's PNG files lie, and where others are made in passing
	FReportBefore Before;
	bool bFull = false;                   // the values of all pictures go in
	bool bLarge = true;                   // false: of the pictures the thumbnails alone
	size_t MaxThumbnailBytes = 2'000'000; // as PNG, together
};

/** Throws FError (exit code 3) where a picture cannot be written or read. */
DRYDOCK_API std::string MakeReportData(const FReportInputs& Inputs);

} // namespace Drydock
