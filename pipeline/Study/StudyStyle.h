// Declares the page, style sheet, colours and markers that the drawings of a study share. Inner to Study.
#pragma once

#include <string>

namespace Drydock
{

// Pixels.
constexpr double StudyPageWidth = 1120.0;
constexpr double StudyPageMargin = 24.0;
constexpr double StudyAxisLeft = 62.0;   // of a panel: names and ticks of its error axis
constexpr double StudyAxisBottom = 48.0; // of a panel: names and ticks of its cost axis
constexpr double StudyPanelTitle = 30.0;
constexpr double StudyPanelGap = 18.0;

/** Opens a drawing of that height, in pixels, with page and style sheet. Title: for readers who cannot see the drawing.
 */
std::string BeginStudySvg(double Height, const std::string& Title);

/** "3": the fourth choice has the classes f3 (filled) and s3 (stroked). */
std::string GetStudyColor(size_t Choice);

/** A circle; a diamond for a variant that is not a shader. */
std::string DrawStudyMarker(double X, double Y, double Radius, bool bDiamond, const std::string& Class);

} // namespace Drydock
