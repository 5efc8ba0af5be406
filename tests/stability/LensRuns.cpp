// How the rows of depth of field, motion blur and temporal antialiasing are run, and their formulas.
#include "Runs.h"

#include "Cases.h"

#include "Lens/DiaphragmDOF.h"
#include "Lens/PostProcessMotionBlur.h"
#include "Screen/TemporalAA.h"

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

/** One frame with this history; not valid: a first frame. */
Drydock::FTemporalAAOutputs AddTemporalAA(FFrameRun& Run, const FCase& Case, const FScreenPassTexture& History)
{
	Drydock::FTemporalAAInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.SceneTextures = Run.GetSceneTextures();
	Inputs.History = History;
	Inputs.FilterSize = static_cast<float>(Case.Sigma.value_or(1.0));
	return AddTemporalAAPass(Run.GraphBuilder, Run.View, Inputs);
}

/** The picture as the frame after itself. Sigma: the filter's size, 1. */
FImage RunTemporalAA(const FCase& Case)
{
	FFrameRun Run(Case);
	const FScreenPassTexture History = AddTemporalAA(Run, Case, FScreenPassTexture()).History;
	return Run.Execute(AddTemporalAA(Run, Case, History).SceneColor);
}

/** The picture is the history, of eight frames, of one that shows a half everywhere but for a tenth more in every
 * second row. */
FImage RunTemporalAAHistory(const FCase& Case)
{
	FCase Next = Case;
	Next.Image = FImage::Make(Case.Image.Width, Case.Image.Height,
		[](int, int Y)
		{
			const double Light = 0.5 + 0.1 * (Y % 2);
			return FTexel{Light, Light, Light, 1};
		});
	FFrameRun Run(Next);
	FImage Kept = Case.Image;
	for (FTexel& Texel : Kept.Texels)
	{
		Texel[3] = 8;
	}
	const PassReference::FRect Rect{
		Case.Offset.X, Case.Offset.Y, Case.Offset.X + Kept.Width, Case.Offset.Y + Kept.Height};
	const FScreenPassTexture History =
		Run.AddInput(Kept, Rect, Run.Input.Texture->Desc.Extent, PF_A32B32G32R32F, TEXT("History"));
	return Run.Execute(AddTemporalAA(Run, Case, History).SceneColor);
}

const FRunRegistration LensRuns({
	{"Depth of field", {.Run = RunDiaphragmDOF, .Reach = 12}},
	{"Motion blur", {.Run = RunMotionBlur, .Reach = 4}},
	{"Temporal antialiasing", {.Run = RunTemporalAA, .Reach = 8}},
	{"Temporal antialiasing: history", {.Run = RunTemporalAAHistory, .Reach = 8}},
});

} // namespace

} // namespace Stability
