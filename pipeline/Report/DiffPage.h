// Writes the data of a comparison's page as one JSON: figures, both sides' pictures, and the differences in how they
// were made.
#pragma once

#include "Picture/ImageMetrics.h"
#include "Report/ReportPicture.h"

#include <string>
#include <vector>

namespace Drydock
{

/** Gathers the pictures of a comparison one pair after another, so that two of them are in memory at a time. */
class DRYDOCK_API FDiffPage
{
public:
	/** The two pictures, of one size, and where they differ a map of it. Error: CompareImages(A, B). Throws FError
	 * (exit code 3). */
	void AddPair(const std::string& Name, const FComparedImage& A, const FComparedImage& B, const FImageError& Error);

	/** JSON by report/diff.schema.json, for MakeReportPage. A, B: as they were named on the command line, images or
	 * folders of runs, of which run.json and timing.json are read. DiffJson: what `drydock diff --json` prints. When:
	 * UTC, as FormatReportTime has it. Throws FError (exit code 3). */
	std::string MakeData(
		const std::string& A, const std::string& B, const std::string& DiffJson, const std::string& When);

private:
	void AddPicture(const std::string& Name, const char* Role, const FComparedImage& Image, std::string Png);

	std::vector<FReportPicture> Pictures;
	std::vector<std::vector<size_t>> Groups; // one for each pair
};

} // namespace Drydock
