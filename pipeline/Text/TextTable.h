// A table as text, which fits the terminal: cells are wrapped or shortened, columns left out, as each column says.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <vector>

namespace Drydock
{

/** The alignment of a column, and the way it gives way where the table is too wide. */
enum class ETextColumn
{
	Number, // at the right, kept whole
	Name,   // at the left; shortened in the middle, when wrapping others was not enough
	Text    // at the left; wrapped at blanks
};

struct FTextColumn
{
	ETextColumn Kind = ETextColumn::Text;
	int LeaveOut = 0; // the highest goes first where even the narrowest cells do not fit; 0: stays
};

struct FTextTable
{
	std::vector<FTextColumn> Columns;
	std::vector<std::vector<std::string>> Rows; // of one cell per column each; a header is a row like others
	std::vector<std::string> Colors = {};       // escape sequence before each row; empty, or fewer than rows: none

	/** Lines of columns two blanks apart, without blanks at the ends of lines; a row may take several. Width: of the
	 * terminal, 0: as wide as the cells are. Indent: before each line. If columns are left out, a last line names them,
	 * by the first row. */
	DRYDOCK_API std::string Format(int Width = 0, const std::string& Indent = "") const;
};

/** "configs/sce...mera.exr": the text in no more than Columns characters, of which the middle is missing. */
DRYDOCK_API std::string ShortenMiddle(const std::string& Text, size_t Columns);

} // namespace Drydock
