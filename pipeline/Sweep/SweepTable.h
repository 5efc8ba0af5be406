// The figures of all tasks of a sweep as one table, errors against a variant among them, and what follows from
// comparing tasks: axes that change nothing, and what it costs to cut a history into pieces.
#pragma once

#include "DrydockAPI.h"
#include "Sweep/SweepFolder.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** A frame of a task. */
struct FSweepPicture
{
	int Frame = -1;          // -1: the scene is one frame
	std::string File;        // png, from the sweep's folder
	std::string Fingerprint; // of the picture's numbers
};

struct FSweepRow
{
	const FSweepTask* Task = nullptr;      // of the plan
	std::map<std::string, double> Figures; // means over the frames; "error max" and "error rms" of the worst frame
	std::vector<FSweepPicture> Pictures;
	std::vector<std::string> Messages;
	double Seconds = 0.0; // of the task, by the clock
};

/** A piece beside the same frames of the unsplit cut. */
struct FSweepPiece
{
	const FSweepTask* Task = nullptr;
	size_t NumDifferent = 0; // frames whose numbers are not the same bits
	double Max = 0.0;        // largest difference, display-encoded
	double Rms = 0.0;        // of the worst frame
};

struct FSweepTable
{
	std::vector<FSweepRow> Rows;      // in the order of the plan, without the unsplit cut
	std::vector<std::string> Figures; // names, in the order of columns
	std::vector<FSweepPiece> Pieces;  // of the first cut
	std::vector<std::string> Notes;   // sentences: axes that change nothing, what pieces cost
};

/** Reads all results and compares pictures: by final.exr where results keep it, else by the 8 bits of final.png. Plan
 * must outlive the table. Throws FError: results are missing or damaged (DD1144, exit code 1), or cannot be read (3).
 */
DRYDOCK_API FSweepTable MakeSweepTable(const FSweepFolder& Folder, const FSweepPlan& Plan);

/** table.json: {version, config, task, axes, against, comparedBy, figures, rows: [{task, values, set, frames, figures,
 * pictures, messages}], pieces, notes}. Nothing of it depends on times or on who computed what. */
DRYDOCK_API std::string MakeSweepTableJson(const FSweepPlan& Plan, const FSweepTable& Table);

/** table.csv: a line a task, with the values of the axes and the figures; timing.csv: with seconds in place of figures.
 */
DRYDOCK_API std::string MakeSweepCsv(const FSweepPlan& Plan, const FSweepTable& Table, bool bTiming);

} // namespace Drydock
