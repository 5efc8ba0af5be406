// A study as a picture: error against cost, both in steps of ten, a panel for each job. Drawn are the front, whiskers
// between quartiles, a ring around what is in use and one around what is recommended, and the line of the error budget;
// where jobs differ by a number, also cost and error against it. Pure, from plain data to SVG; equal data give equal
// bytes.
#pragma once

#include "Study/StudyResult.h"

namespace Drydock
{

/** Legible on light and dark pages: it follows the reader's colour scheme. */
DRYDOCK_API std::string DrawStudyChart(const FStudyResult& Result, EStudyCost Cost);

} // namespace Drydock
