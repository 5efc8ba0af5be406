// How the rows of depth of field and motion blur are run, and their formulas.
#include "Runs.h"

#include "Cases.h"

#include "Lens/DiaphragmDOF.h"
#include "Lens/PostProcessMotionBlur.h"

namespace Stability
{

namespace
{

/** Sigma: the radius at infinity, 6. */
FImage RunDiaphragmDOF(const FCase& Case)
{
	FFrameRun Run(Case);
	DiaphragmDOF::FPhysicalCocModel Model;
	Model.FocusDistance = 300.0f;
	Model.InfinityRadius = static_cast<float>(Case.Sigma.value_or(6.0));
	Model.MaxForegroundRadius = Model.MaxBackgroundRadius = 40.0f;
	const auto SceneTextures = Run.GetSceneTextures();
	return Run.Execute(DiaphragmDOF::AddPasses(Run.GraphBuilder, Run.View, SceneTextures, Run.Input, Model, {}));
}

/** Sigma: the blur's length for a velocity of one pixel, 1. */
FImage RunMotionBlur(const FCase& Case)
{
	FFrameRun Run(Case);
	FMotionBlurInputs Inputs;
	Inputs.SceneTextures = Run.GetSceneTextures();
	Inputs.SceneColor = Run.Input;
	Inputs.VelocityScale = static_cast<float>(Case.Sigma.value_or(1.0));
	Inputs.MaxLength = 16.0f;
	return Run.Execute(AddMotionBlurPass(Run.GraphBuilder, Run.View, Inputs));
}

const FRunRegistration LensRuns({
	{"Depth of field", {.Run = RunDiaphragmDOF, .Reach = 12}},
	{"Motion blur", {.Run = RunMotionBlur, .Reach = 4}},
});

} // namespace

} // namespace Stability
