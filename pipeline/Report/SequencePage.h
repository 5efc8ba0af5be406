// Writes the data of a sequence's page as one JSON: sequence.json, figures of each frame, and small pictures to go
// through.
#pragma once

#include "Sequence/RunSequence.h"

#include <string>

namespace Drydock
{

/** JSON by report/sequence.schema.json, for MakeReportPage. Name: of the config. WalkJson: MakeSceneWalkJson; empty:
 * none. When: UTC, as FormatReportTime has it. If there are more than 96 frames, it has the pictures of 96; all are
 * reduced to the size that the page can hold. Throws FError (exit code 3) where a frame's file cannot be read. */
DRYDOCK_API std::string MakeSequencePageData(
	const FSequenceResult& Result, const std::string& Name, const std::string& WalkJson, const std::string& When);

} // namespace Drydock
