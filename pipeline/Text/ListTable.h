// A table that `drydock list` prints: rows of equal length under a header.
#pragma once

#include "Text/TextTable.h"

#include <string>
#include <vector>

namespace Drydock
{

struct FListTable
{
	std::vector<std::string> Header; // also the keys of the JSON objects
	std::vector<std::vector<std::string>> Rows;
	std::string Remark = {};               // where there is nothing to list
	std::vector<FTextColumn> Columns = {}; // one for each of the header; empty: text
};

} // namespace Drydock
