// How far a sweep is, by what lies in its folder.
#pragma once

#include "DrydockAPI.h"
#include "Sweep/SweepFolder.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

struct FSweepStatus
{
	size_t NumTasks = 0;
	size_t NumDone = 0;
	size_t NumRunning = 0; // a process is at them now
	size_t NumFailed = 0;
	size_t NumMissing = 0;               // neither done, nor running, nor failed
	double SecondsPerTask = 0.0;         // mean of tasks that are done; of none, as it was planned
	std::optional<double> SecondsLeft;   // with as many processes as run now; none: none runs
	std::vector<std::string> Failures;   // "HASH values: first message"
	std::vector<std::string> Unfinished; // running and missing: "HASH values"

	bool IsComplete() const { return NumDone == NumTasks; }
	/** All that can be done is done. */
	bool IsSettled() const { return NumDone + NumFailed == NumTasks; }
};

DRYDOCK_API FSweepStatus FindSweepStatus(const FSweepFolder& Folder, const FSweepPlan& Plan);

/** Only how many results are there. */
DRYDOCK_API size_t CountDone(const FSweepFolder& Folder, const FSweepPlan& Plan);

/** "3 h 20 min", "12 s". */
DRYDOCK_API std::string DescribeDuration(double Seconds);
/** "1.2 GB". */
DRYDOCK_API std::string DescribeBytes(double Bytes);

/** One table, and the failures beneath. Width: of the terminal, 0: any. bBar: a bar above it. */
DRYDOCK_API std::string MakeStatusText(const FSweepStatus& Status, int Width, bool bBar);
DRYDOCK_API std::string MakeStatusJson(const FSweepStatus& Status);

} // namespace Drydock
