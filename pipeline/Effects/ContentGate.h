// Declares what gates by content have in common: taking a decision back, and confining an effect to a part of the view.
#pragma once

#include "Effects/Effect.h"

namespace Drydock
{

/** Bounds are known, and no pixel is inside. */
bool HasNone(const std::optional<FIntRect>& Bounds);

/** Takes an active decision back: the scene gives it nothing to do. */
void Skip(FEffectDecision& Effect, const std::string& Why);

/** Gives the effect Bounds as its region, unless they hold most of the view, because pixels outside have to be copied.
 * Regions are drawn: there is none with r.PostProcessing.PreferCompute, whose entries dispatch over the whole view. The
 * argument What names the bounds, "the mask". */
void Confine(const FViewContent& Content, const FIntRect& Bounds, const char* What, FEffectDecision& Effect);

/** r.PostProcessing.PreferCompute. */
bool IsComputePreferred();

} // namespace Drydock
