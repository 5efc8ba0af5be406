// What tests of the RED post process share: a pass run by itself.
#pragma once

#include "PassTestUtils.h"

#include "Lens/REDPostProcess.h"

namespace PassTest
{

/** One pass on an image; Blurred of the size that the blur has in the chain. */
inline FImage RunPass(const FImage& Image, Drydock::EREDPostProcessPass Pass,
	const Drydock::FREDPostProcessParameters& Parameters = {}, const FImage& Blurred = FImage(),
	EArithmetic Arithmetic = EArithmetic::Double)
{
	FPassRun Run(Image, Arithmetic, PF_A32B32G32R32F);
	Drydock::FREDPostProcessPassInputs Inputs;
	Inputs.Pass = Pass;
	Inputs.SceneColor = Run.Input;
	Inputs.Parameters = Parameters;
	if (Blurred.Width > 0)
	{
		Inputs.Blurred = Run.AddInput(Blurred, PF_A32B32G32R32F, TEXT("Blurred"));
	}
	return Run.Execute(Drydock::AddREDPostProcessPass(Run.GraphBuilder, Run.View, Inputs));
}

} // namespace PassTest
