// Which effects have nothing to do in this scene, and which of them only in a part of it. Leaving one out, or confining
// it, changes no bit of any output: each rule below says why. Pure: looks at settings, console variables and what was
// measured (ViewContent.h). Source: drydock.
#pragma once

#include "Effects/EffectDecisions.h"

namespace Drydock
{

/** Why bloom adds nothing: no pixel is bright enough for its threshold. Empty: it may. Only where bloom sees the scene
 * as it came (no effect before it changes colours), exposure is a number, and no value is NaN or infinite. Exposed
 * luminance is at most that of the brightest component; a tenth more covers what formats and filters round. The setup
 * pass then gives 0 everywhere, and so does every sum of it. */
DRYDOCK_API std::string FindNothingBright(const FChainSettings& Chain);

/** Takes back the decision of an active ToonBloom, MotionBlur, CharaGlow or ToonShadowBlur that would change nothing,
 * or gives it the region that it can change:
 * - ToonBloom multiplies pixels of the toon model; without one the masked picture is the picture. As printed without a
 *   threshold it brings a pass that rounds: it stays.
 * - ToonShadowBlur lights pixels of the toon model.
 * - CharaGlow adds the widened mask less the mask: of nothing, nothing.
 * - MotionBlur leaves a picture in which nothing moves by half a pixel as it is.
 * A decision that has its region already stays. */
DRYDOCK_API void ApplyContentGate(const FChainSettings& Chain, FEffectDecision& Effect);

/** Says of each active effect that could have had nothing to do why nobody looked. */
DRYDOCK_API void NoteContentUnseen(std::vector<FEffectDecision>& Effects, const std::string& Why);

} // namespace Drydock
