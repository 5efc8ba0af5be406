// Runs a study: everything in one process, all variants in turn again and again, so that a temporary slowdown of the
// machine affects all of them.
#pragma once

#include "Study/StudyResult.h"

#include "Budget/RunOptions.h"

#include <memory>

namespace Drydock
{

/** A picture of one job: what the reference or a variant gives there. */
struct FStudyPicture
{
	FImage Image;
	EImageEncoding Encoding = EImageEncoding::Linear;
};

/** One study. Its preparations, above all the matched widths of blurs, serve its figures and its pictures. */
class DRYDOCK_API FStudyRun
{
public:
	/** Options: config and command line, as of a run; its precision and storage do not matter. Throws FError: a config
	 * without a study, mistakes of the config. */
	explicit FStudyRun(const FRunOptions& Options);
	~FStudyRun();

	/** Runs everything. Progress of Options is called before each run. Throws FError: a run that fails. */
	FStudyResult Measure();

	/** Runs once more to see; of the study's region. */
	FStudyPicture RunReference(const FStudyJob& Job);
	/** Runs a variant once more to see; as large. */
	FStudyPicture RunVariant(const FStudyResult& Result, const FStudyVariant& Variant);

private:
	struct FState;
	std::unique_ptr<FState> State;
};

/** The figures alone. Throws as FStudyRun does. */
DRYDOCK_API FStudyResult RunStudy(const FRunOptions& Options);

} // namespace Drydock
