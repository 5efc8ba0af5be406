// Antialiasing of the displayed picture by FXAA. Source: engine PostProcess/PostProcessAA.cpp (conditions); the wording
// is drydock's.
#include "Effects/Effect.h"
#include "HAL/IConsoleManager.h"
#include "SceneView.h"
#include "Screen/PostProcessAA.h"

namespace Drydock
{

namespace
{

TAutoConsoleVariable<int32> CVarAntiAliasingMethod(TEXT("r.AntiAliasingMethod"), 0,
	TEXT("0: off (default). 1: FXAA. 2: TAA, over the frames of a sequence. 4: TSR, for which TAA stands in. 3 MSAA "
		 "and 5 SMAA are not simulated."),
	ECVF_RenderThreadSafe);

FEffectDecision DecideFXAA(const FEffect&, const FEffectInputs& Inputs)
{
	const int32 Method = CVarAntiAliasingMethod.GetValueOnAnyThread();
	const std::string Variable = "r.AntiAliasingMethod is " + std::to_string(Method);
	FEffectDecision Decision;
	const bool bTemporal = Method == AAM_TemporalAA || Method == AAM_TSR;
	Decision.bConfigured = Method != AAM_None && !bTemporal;
	if (Method == AAM_None || bTemporal)
	{
		Decision.Reason = Variable;
	}
	else if (Method != AAM_FXAA)
	{
		Decision.Reason = Variable + ", which is not simulated";
	}
	else if (const std::string Off = Inputs.FindShowFlagOff(Inputs.Conditions.ShowFlags.AntiAliasing, "AntiAliasing");
			 !Off.empty())
	{
		Decision.Reason = Off;
	}
	else
	{
		Decision.bActive = true;
		Decision.Reason = Variable + ", r.FXAA.Quality " + std::to_string(static_cast<int32>(GetFXAAQuality()));
	}
	return Decision;
}

} // namespace

const FEffect GFXAAEffect{
	.Id = EEffect::FXAA,
	.Name = "FXAA",
	.Doc = "Smooth edges in the displayed picture.",
	.Settings = NoSettings,
	.bMayBrightenBeforeBloom = false,
	.Decide = &DecideFXAA,
	.Content = FContentGate{},
	.Complete = nullptr,
	.GetPlace = [] { return FChainPlace{EChainPlace::AntiAliasing}; },
	.AddPasses = nullptr,
	.Measurement = FMeasurement{},
};

} // namespace Drydock
