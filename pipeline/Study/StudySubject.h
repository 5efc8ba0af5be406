// Defines the subject of a study, which runs once with each variant: blurs of an image, or frames of a config.
#pragma once

#include "Budget/RunOptions.h"
#include "Study/StudyResult.h"
#include "Text/ConfigErrors.h"

#include <memory>
#include <string>
#include <vector>

namespace Drydock
{

/** The values that the axes are set to. */
using FStudySet = std::vector<FStudyAssignment>;

FStudySet Join(const FStudySet& A, const FStudySet& B);

/** One run of something: the whole picture, whatever the study's region. Taps and bytes are for each pixel. */
struct FMeasured
{
	FImage Image;
	EImageEncoding Encoding = EImageEncoding::Linear;
	double Milliseconds = 0.0;
	double Taps = 0.0;
	double Bytes = 0.0;
};

/** The subject that a study runs. */
class IStudySubject
{
public:
	virtual ~IStudySubject() = default;

	virtual FMeasured RunReference(const FStudySet& Case) = 0;
	virtual FMeasured Run(const FStudySet& Set) = 0;
	/** Called before anything runs: fills in what is known of a variant without running it, its exclusion included. */
	virtual void Prepare(const FStudySet& Set, FStudyVariant& Variant) = 0;
	/** Key of the measured time: all sets of one key share one time, whatever their input; empty: each set has its own.
	 * For a case alone it is the key of its reference. */
	virtual std::string GetTimeKey(const FStudySet&) { return ""; }
	virtual std::string DescribeReference(const FStudySet& Case) = 0;
};

/** Images, blurred; the reference is the exact Gaussian. Throws FError (exit code 2) for a scene that does not fit. */
std::unique_ptr<IStudySubject> MakeBlurSubject(const FConfig& Config);

/** Frames; the reference is a run as Study.Reference sets it. Study must outlive it. */
std::unique_ptr<IStudySubject> MakeFrameSubject(const FRunOptions& Options, const FStudy& Study);

/** The scene's colour as a study of blurs takes it, RGBA: scene, point or edge. The point is as bright as makes the
 * exact blur's peak 1; the edge is slanted. */
DRYDOCK_API FImage MakeBlurInput(const std::string& Input, const FImage& Scene, double Sigma);

/** A mistake of the config at Place. */
FError MakeStudyError(EConfigError Code, const FConfig& Config, const FConfigPlace& Place, const std::string& Message);

} // namespace Drydock
