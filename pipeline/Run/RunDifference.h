// Compares the records of two runs: what differs in how they were made, by name, and whether one is faster.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <vector>

namespace Drydock
{

class FJsonWriter;

/** Something that differs. */
struct FRunDifference
{
	std::string Kind; // "setting", "variable", "input", "effect", "pass", "other"
	std::string Name;
	std::string A; // empty: A has none
	std::string B;
};

/** Texts of two run.json; empty if one of them cannot be read. A pass differs if it is not there, did not run, or ran
 * another shader on another number of pixels. */
DRYDOCK_API std::vector<FRunDifference> CompareRuns(const std::string& RunJsonA, const std::string& RunJsonB);

DRYDOCK_API void WriteRunDifferences(
	FJsonWriter& Writer, const char* Key, const std::vector<FRunDifference>& Differences);

/** A table for people, of at most MaxRows rows; a last line counts the others. */
DRYDOCK_API std::string FormatRunDifferences(const std::vector<FRunDifference>& Differences, size_t MaxRows, int Width);

/** The times of one run, measured several times, milliseconds. */
struct FTimeSpread
{
	double Low = 0.0; // the first quartile
	double Median = 0.0;
	double High = 0.0; // the third quartile
};

/** Samples: one at least. */
DRYDOCK_API FTimeSpread MakeTimeSpread(std::vector<double> Samples);

/** One sentence, which names a difference only if the quartiles of both part. */
DRYDOCK_API std::string DescribeTimes(const FTimeSpread& A, const FTimeSpread& B, int NumRepeats);

} // namespace Drydock
