// The dual Kawase blur of the whole picture, by a view extension or by settings alone. Source: docs/dual-kawase.md.
#include "Blur/DualKawaseBlurPass.h"
#include "Effects/Effect.h"
#include "SceneRendering.h"
#include "Text/TextFormat.h"

#include <algorithm>

namespace Drydock
{

namespace
{

constexpr FSettingClaim DualKawaseBlurSettings[] = {{"DualKawaseBlur"}};

FEffectDecision DecideDualKawaseBlur(const FEffect&, const FEffectInputs& Inputs)
{
	const int32 PassNum = Inputs.Settings.DualKawaseBlurPassNum;
	const std::string Setting = "DualKawaseBlurPassNum is " + std::to_string(PassNum);
	FEffectDecision Decision;
	// One of a config bears the name of its type: that of the class without the F.
	Decision.bByExtension = std::any_of(Inputs.Extensions.begin(), Inputs.Extensions.end(),
		[](const std::string& Name) { return Name == "FDualKawaseBlur" || Name == "DualKawaseBlur"; });
	Decision.bActive = Decision.bConfigured = Decision.bByExtension || PassNum > 0;
	if (Decision.bConfigured && !Inputs.Conditions.ShowFlags.PostProcessing)
	{
		Decision.bActive = false;
		Decision.Reason = "ShowFlag.PostProcessing is off";
	}
	else if (Decision.bByExtension)
	{
		Decision.Reason = "a view extension makes it" + (PassNum > 0 ? "; " + Setting : std::string());
	}
	else
	{
		Decision.Reason =
			Setting + (PassNum > 0 ? ", DualKawaseBlurOffset " + NumberText(Inputs.Settings.DualKawaseBlurOffset)
								   : std::string(", and there is no such view extension"));
	}
	return Decision;
}

/** Called for by the settings alone: an extension would have read them. */
FScreenPassTexture AddDualKawaseBlurEffect(const FEffectPassInputs& Inputs)
{
	FDualKawaseBlurInputs Blur;
	Blur.SceneColor = Inputs.SceneColor;
	Blur.Offset = Inputs.View.FinalPostProcessSettings.DualKawaseBlurOffset;
	Blur.PassNum = Inputs.View.FinalPostProcessSettings.DualKawaseBlurPassNum;
	Blur.bAsPrinted = IsDualKawaseAsPrinted();
	return AddDualKawaseBlurPass(Inputs.GraphBuilder, Inputs.View, Blur);
}

} // namespace

const FEffect GDualKawaseBlurEffect{
	.Id = EEffect::DualKawaseBlur,
	.Name = "DualKawaseBlur",
	.Doc = "A wide blur of the picture by halving and doubling it.",
	.Settings = DualKawaseBlurSettings,
	.bMayBrightenBeforeBloom = true,
	.Decide = &DecideDualKawaseBlur,
	.Content = FContentGate{},
	.Complete = nullptr,
	.GetPlace = [] { return FChainPlace{EChainPlace::BeforeBloom}; },
	.AddPasses = &AddDualKawaseBlurEffect,
	.Measurement = FMeasurement{},
};

} // namespace Drydock
