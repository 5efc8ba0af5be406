// Plans the run once, for the size that the probe's pixel counts in.
#include "Inspect/ProbeRun.h"

#include "Run/Run.h"
#include "Text/ConfigErrors.h"

namespace Drydock
{

FProbedRun ProbeRun(const FRunOptions& Run, FProbeRequest& Request)
{
	FRunOptions Plan = Run;
	Plan.bExecute = false;
	const FIntRect View = RunConfig(Plan).ViewRect;
	Request.Frame = {View.Width(), View.Height()};
	const bool bInside = Request.X >= 0 && Request.Y >= 0 && Request.Width >= 1 && Request.Height >= 1 &&
						 int64_t(Request.X) + Request.Width <= View.Width() &&
						 int64_t(Request.Y) + Request.Height <= View.Height();
	if (!bInside)
	{
		throw BadArgument(std::to_string(Request.X) + "," + std::to_string(Request.Y) +
							  " with its region leaves the frame, which is " + std::to_string(View.Width()) + " x " +
							  std::to_string(View.Height()),
			"X,Y");
	}
	FProbeCapture Capture(Request);
	const FScopedDispatchObserver Scope(Capture);
	FProbedRun Probed;
	Probed.Diagnostics = RunConfig(Run).Diagnostics;
	if (Capture.GetPasses().empty())
	{
		throw BadArgument("no pass of this run that a shader draws matches '" + Request.Passes + "'", "--pass");
	}
	Probed.Passes = Capture.GetPasses();
	return Probed;
}

} // namespace Drydock
