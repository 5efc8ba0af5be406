// Holds a study's axes as plain data, and makes the row of its variants. Its keys are in ConfigKeys.txt.
#pragma once

#include "Config/Config.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** One thing set to one value: a console variable, a setting, a place of the config (IsConfigPlace), precision,
 * storage; of a blur also algorithm, sigma, input, resolution. */
struct FStudyAssignment
{
	std::string Name;
	std::string Value; // as the command line takes it
	FConfigPlace Place;
};

struct FStudyValue
{
	std::string Label;
	std::vector<FStudyAssignment> Set;
};

struct FStudyAxis
{
	std::string Name;
	/** Another job for each value, with a reference and a front of its own; else another way to do the same job. */
	bool bEach = false;
	std::vector<FStudyValue> Values;
	FConfigPlace Place;
};

struct FStudyBudget
{
	std::string Metric = "rms";
	std::optional<double> Max; // of the metric; of psnr and ssim the least
	std::optional<double> Ms;
	bool bDefault = true; // no budget in the config: half a step of 8 bits
};

/** A job of the study: one value of every axis whose values are separate jobs. */
struct FStudyCase
{
	std::string Label; // empty where there is one job only
	std::vector<FStudyAssignment> Set;
	std::vector<std::string> Values; // labels, axis by axis of the study; "" for axes of choice
};

/** One way to do it. */
struct FStudyChoice
{
	std::string Label;
	std::vector<FStudyAssignment> Set;
	std::vector<std::string> Values; // labels, axis by axis of the study
};

struct FStudy
{
	bool bBlur = false; // of blur algorithms, alone; else of whole frames
	std::vector<FStudyAxis> Axes;
	/** The settings of the reference, beside the case, for a frame. Empty for a blur: its reference is the exact blur.
	 */
	std::vector<FStudyAssignment> Reference;
	std::string ReferenceName;
	std::vector<std::string> Metrics; // the first one is drawn, and decides what dominates what
	int Repetitions = 7;
	std::optional<std::array<int, 4>> Region; // MinX, MinY, MaxX, MaxY of the picture
	std::string Passes = "*";                 // pattern of those whose time, taps and bytes count
	std::string Measure = "final";            // final, sceneLinear, toonShadow, or a resource
	std::vector<FStudyAssignment> Current;    // of a blur: the variant that is in use now
	FStudyBudget Budget;

	DRYDOCK_API std::vector<FStudyCase> GetCases() const;
	DRYDOCK_API std::vector<FStudyChoice> GetChoices() const;
};

/** Empty where the config has none. Mistakes are appended to Diagnostics. Console variables of plugins must be there.
 */
DRYDOCK_API std::optional<FStudy> ReadStudy(const FConfig& Config, std::vector<FDiagnostic>& Diagnostics);

/** Axes of frames alone, of the member "axes" of Value. FurtherNames: names of axes that the caller knows what to do
 * with, beside those that a study has. */
std::vector<FStudyAxis> ReadAxes(const FConfig& Config, const FJsonValue& Value,
	const std::vector<std::string>& FurtherNames, std::vector<FDiagnostic>& Diagnostics);

/** The value of a name in a list of assignments, or what is given otherwise. */
DRYDOCK_API std::string GetAssigned(
	const std::vector<FStudyAssignment>& Set, const std::string& Name, const std::string& Otherwise);

} // namespace Drydock
