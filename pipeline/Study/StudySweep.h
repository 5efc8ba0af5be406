// Jobs that differ by a number, such as a width: cost and error against it. Inner to StudyChart.
#pragma once

#include "Study/StudyView.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

class FStudySweep
{
public:
	/** Finds the one axis of jobs whose values are three numbers at least, and what other such axes are set to. */
	explicit FStudySweep(const FStudyView& InView);

	/** The jobs that have a panel of their own: of the first of the other values, "scene". Without a sweep all. */
	std::vector<const FStudyJob*> GetShownJobs() const;

	/** Two columns of panels from Y on, which moves below them. Empty without a sweep. */
	std::string Draw(double& Y) const;

private:
	/** A job's values without the number: "scene". */
	std::string GetOther(const FStudyJob& Job) const;
	double GetNumber(const FStudyJob& Job) const;
	/** Cost or error against the number, a line per choice, each named at its end. */
	std::string DrawPanel(const FSvgBox& Plot, const std::string& Other, bool bErrors) const;

	const FStudyView& View;
	std::optional<size_t> Axis;
	std::vector<std::string> Others;
};

} // namespace Drydock
