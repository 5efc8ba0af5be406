// Writes the results of a study as text for people and machines. Times, and figures that follow from times, differ from
// run to run and are in separate texts: the others are the same bytes on every run.
#pragma once

#include "Study/StudyResult.h"

namespace Drydock
{

/** Writes tables for the terminal: one per job, with times. */
DRYDOCK_API std::string MakeStudyTable(const FStudyResult& Result, int Width = 0);

/** study.json: {version, config, fingerprint, scene, size, region, subject, reference, metric, budget, axes: [{name,
 * each, values}], jobs: [{label, set, reference, referenceTaps, variants: [{label, set, excluded, max, rms, relative,
 * psnr, ssim, relativeWithBorder, taps, bytes, sigma, plainCode, current, front, dominatedBy}]}]}; front and
 * dominatedBy over taps per pixel; region and relativeWithBorder (the relative error of the whole picture) of a study
 * with a region.
 */
DRYDOCK_API std::string MakeStudyJson(const FStudyResult& Result);

/** study_timing.json: {cpu, threads, repetitions, seconds, jobs: [{label, referenceMs, recommended, recommendation,
 * variants: [{label, medianMs, lowMs, highMs, runsMs, front, dominatedBy, withinNoiseOf}]}]}; milliseconds of this CPU.
 */
DRYDOCK_API std::string MakeStudyTimingJson(const FStudyResult& Result);

/** study.csv: a line per variant, without times; study_timing.csv: a line per variant, with times. */
DRYDOCK_API std::string MakeStudyCsv(const FStudyResult& Result, bool bTiming);

/** "toon.exr, 641 x 359, errors of 512 x 288 at (64, 32)": what was studied. */
DRYDOCK_API std::string DescribeStudied(const FStudyResult& Result);

/** "RMS error", ...: the title of an axis of a drawing. */
DRYDOCK_API std::string GetErrorTitle(const std::string& Metric);

} // namespace Drydock
