// The figures of all tasks of a sweep as one table, errors against a variant among them, and what follows from comparing
// tasks: axes that change nothing, and what it costs to cut a history into pieces.
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
	std::optional<int> Frame;
	std::string File;        // png, from the sweep's folder
	std::string Fingerprint; // of the picture's numbers
};

struct FSweepRow
{
	size_t Task = 0;                       // index in the plan
	std::map<std::string, double> Figures; // means over the frames; of an error the largest
	std::vector<FSweepPicture> Pictures;
	std::vector<std::string> Messages;
	double Seconds = 0.0; // of the task, by the clock
};

/** A piece beside the same frames of the unsplit cut. */
struct FSweepPiece
{
	size_t Task = 0;           // of the piece
	size_t NumFrames = 0;      // of it
	size_t NumSame = 0;        // frames whose numbers are the same bits
	double Max = 0.0;          // largest difference, display-encoded
	double Rms = 0.0;          // of the worst frame
	std::optional<int> Worst;  // that frame; none: all are the same
};

struct FSweepTable
{
	FSweepPlan Plan;
	std::vector<FSweepRow> Rows; // in the order of the plan, without unsplit cuts
	std::vector<std::string> Figures; // names, in the order of columns
	std::vector<FSweepPiece> Pieces;  // those whose cut was rendered unsplit
	std::vector<std::string> Notes;   // sentences: axes that change nothing, what pieces cost
};

/** Reads all results and compares pictures: by final.exr where results keep it, else by the 8 bits of final.png. Throws
 * FError: results are missing or damaged (DD1144, exit code 1), or cannot be read (3). */
DRYDOCK_API FSweepTable MakeSweepTable(const FSweepFolder& Folder, const FSweepPlan& Plan);

/** table.json: {version, config, task, axes, against, comparedBy, figures, rows: [{task, values, set, frames, figures,
 * pictures, messages}], pieces, notes}. Nothing of it depends on times or on who computed what. */
DRYDOCK_API std::string MakeSweepTableJson(const FSweepTable& Table);

/** table.csv: a line a task with the values of the axes and the figures; timing.csv: with seconds in place of figures. */
DRYDOCK_API std::string MakeSweepCsv(const FSweepTable& Table, bool bTiming);

/** For the terminal: how each figure changes over each axis, and the notes. */
DRYDOCK_API std::string MakeSweepText(const FSweepTable& Table, int Width);

} // namespace Drydock
