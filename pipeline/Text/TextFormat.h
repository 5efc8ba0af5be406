// Small pieces of the texts that verbs print: numbers, and columns.
#pragma once

#include "DrydockAPI.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace Drydock
{

/** The shortest text that reads back as the number: "0.1", "1e+30". */
DRYDOCK_API std::string NumberText(float Number);
DRYDOCK_API std::string NumberText(double Number);

/** The text with _ for all characters outside [A-Za-z0-9_-]. */
DRYDOCK_API std::string MakeFileNamePart(const std::string& Text);

/** Lines of columns two blanks apart, each as wide as its widest cell in bytes, without blanks at the ends of lines.
 * Rows: of equal length, one at least. IsText: columns of text stand at the left, numbers at the right. Indent: before
 * each line. */
DRYDOCK_API std::string AlignColumns(const std::vector<std::vector<std::string>>& Rows,
	const std::function<bool(size_t Column)>& IsText, const std::string& Indent = "");

} // namespace Drydock
