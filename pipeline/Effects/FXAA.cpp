// Antialiasing of the displayed picture by FXAA. Source: engine PostProcess/PostProcessAA.cpp (conditions); the wording
// is drydock's.
#include "Effects/Effect.h"
#include "HAL/IConsoleManager.h"
#include "Screen/PostProcessAA.h"

namespace Drydock
{

namespace
{

TAutoConsoleVariable<int32> CVarAntiAliasingMethod(TEXT("r.AntiAliasingMethod"), 0,
	TEXT("0: off (default). 1: FXAA. 2 TAA, 3 MSAA, 4 TSR, 5 SMAA: not simulated."), ECVF_RenderThreadSafe);

FEffectDecision DecideFXAA(const FEffect&, const FEffectInputs& Inputs)
{
	const int32 Method = CVarAntiAliasingMethod.GetValueOnAnyThread();
	const std::string Variable = "r.AntiAliasingMethod is " + std::to_string(Method);
	FEffectDecision Decision;
	Decision.bConfigured = Method != 0;
	if (Method == 0)
	{
		Decision.Reason = Variable;
	}
	else if (Method != 1)
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
