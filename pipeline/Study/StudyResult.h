// Holds the results of a study. The figures that are the same on every run (errors, taps, bytes, the front over taps)
// and the measured times are kept apart.
#pragma once

#include "Budget/StudyConfig.h"

#include "Picture/ImageMetrics.h"

#include <string>
#include <vector>

namespace Drydock
{

/** Milliseconds of several runs. */
struct FStudyTime
{
	std::vector<double> Runs; // in the order in which they ran
	double Median = 0.0;
	double Low = 0.0;  // first quartile
	double High = 0.0; // third
};

/** The rank of a variant among those of its job, by error and one cost. */
struct FStudyRank
{
	bool bFront = false;
	/** Index of the cheapest variant that is at least as exact and cheaper, or -1. */
	int DominatedBy = -1;
};

/** Why a variant has no rank. */
enum class EStudyExclusion
{
	None,
	NotRun,     // it cannot be made, or would take too long
	WrongWidth, // it runs, and is a blur of another width than was asked for
};

/** A cost that variants are compared by. */
enum class EStudyCost
{
	Milliseconds, // of this CPU
	Taps,         // per pixel: the same everywhere
};

/** One way to do one job. */
struct FStudyVariant
{
	size_t Case = 0;
	size_t Choice = 0;
	std::string Label; // of the choice
	EStudyExclusion Exclusion = EStudyExclusion::None;
	std::string Excluded; // the exclusion in words
	bool bRan = false;
	FImageError Error; // of the study's region, places too are counted from its corner
	/** Relative error of the whole picture, which blurs and frames are computed in. */
	double RelativeWithBorder = 0.0;
	double Taps = 0.0;          // per pixel of the picture
	double Bytes = 0.0;         // per pixel of the picture
	double MeasuredSigma = 0.0; // of blurs
	bool bPlainCode = false;    // not shaders in the graph
	FStudyRank ByTaps;
	bool bCurrent = false;

	// By the clock.
	FStudyTime Time;
	FStudyRank ByTime;
	std::vector<size_t> WithinNoiseOf; // other variants of the job whose quartiles overlap
	bool bRecommended = false;

	/** It ran, and is what was asked for. */
	bool Competes() const { return bRan && Exclusion == EStudyExclusion::None; }
};

/** One job. */
struct FStudyJob
{
	FStudyCase Case;
	std::string Reference; // what errors are measured against, in words
	FStudyTime ReferenceTime;
	double ReferenceTaps = 0.0;
	std::vector<size_t> Variants; // indices into FStudyResult::Variants
	std::string Recommendation;   // a sentence
};

struct FStudyResult
{
	FStudy Study;
	std::string Name; // of the config: "study_blur"
	std::string ConfigFile;
	std::string Fingerprint; // of what was studied: see GetStudyFingerprint
	std::string Scene;
	int Width = 0; // of the pictures; errors are measured on Study.Region of them
	int Height = 0;
	int Threads = 0;
	std::vector<FStudyJob> Jobs;
	std::vector<FStudyVariant> Variants;
	std::vector<FDiagnostic> Diagnostics;
	double Seconds = 0.0; // all of it, by the clock

	const std::string& GetMetric() const { return Study.Metrics[0]; }
};

} // namespace Drydock
