// Chooses among console variable, number and exposure.
#include "Run/PreExposure.h"

#include "Config/Config.h"
#include "HAL/IConsoleManager.h"

#include <cmath>
#include <cstring>
#include <optional>

namespace Drydock
{

namespace
{

TAutoConsoleVariable<float> CVarPreExposureOverride(TEXT("r.EyeAdaptation.PreExposureOverride"), 0.0f,
	TEXT("Above 0: PreExposure of every view, in place of view.preExposure; 0 by default."), ECVF_RenderThreadSafe);

bool IsScale(float Value)
{
	return Value > 0.0f && std::isfinite(Value);
}

/** The exposure scale of the frame before; empty without automatic exposure or without such a frame. */
std::optional<float> FindLastExposureScale(const std::vector<FViewHistory>& Last)
{
	if (Last.empty())
	{
		return std::nullopt;
	}
	const auto Found = Last[0].Buffers.find(EyeAdaptationName);
	if (Found == Last[0].Buffers.end())
	{
		return std::nullopt;
	}
	FVector4f Entry;
	std::memcpy(&Entry, Found->second->GetRHI()->GetData(), sizeof(Entry));
	return Entry.X;
}

double ChoosePreExposure(const FConfigView& View, float ExposureScale, const std::vector<FViewHistory>& Last)
{
	if (const float Override = CVarPreExposureOverride.GetValueOnAnyThread(); IsScale(Override))
	{
		return static_cast<double>(Override);
	}
	if (!View.bAutoPreExposure)
	{
		return View.PreExposure.Value;
	}
	const float Followed = View.bAutoExposure ? FindLastExposureScale(Last).value_or(1.0f) : ExposureScale;
	return IsScale(Followed) ? static_cast<double>(Followed) : 1.0;
}

} // namespace

void SetPreExposure(FConfig& Config, float ExposureScale, const std::vector<FViewHistory>& Last)
{
	const double PreExposure = ChoosePreExposure(Config.View, ExposureScale, Last);
	Config.View.PreExposure.Value = PreExposure;
	for (FConfigView& View : Config.Views)
	{
		View.PreExposure.Value = PreExposure;
	}
}

} // namespace Drydock
