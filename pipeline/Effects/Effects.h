// Declares the table of all effects, and the three steps from settings to decisions. Decide looks at settings, Gate at
// what the scene holds, Complete at the outcome; none of them comes back to an earlier one.
#pragma once

#include "Effects/Effect.h"

#include <map>

namespace Drydock
{

using FEffectTable = std::span<const FEffect* const>;

/** Every effect there is, in the order of reports. */
DRYDOCK_API FEffectTable GetEffects();

/** Finds an effect by its name, as a config or the command line has it; null where there is none. */
DRYDOCK_API const FEffect* FindEffectByName(std::string_view Name);

/** First step: one decision per effect of the table, in its order, from settings alone. Reasons are not complete. */
DRYDOCK_API std::vector<FEffectDecision> DecideBySettings(
	const FEffectInputs& Inputs, FEffectTable Table = GetEffects());

/** The contents of the scene that have to be looked at before the second step. With bNoSkip: none. */
DRYDOCK_API FContentQuestions AskContent(const FEffectInputs& Inputs, const std::vector<FEffectDecision>& Decided);

/** Second step: takes back what has nothing to do in the scene, and confines what has only in a part of it. */
DRYDOCK_API std::vector<FEffectDecision> GateByContent(
	const FEffectInputs& Inputs, const FViewContent& Content, const std::vector<FEffectDecision>& Decided);

/** Replaces the second step: adds to each active effect that asks for contents the reason why they were not examined.
 */
DRYDOCK_API std::vector<FEffectDecision> NoteContentUnseen(
	const FEffectInputs& Inputs, const std::vector<FEffectDecision>& Decided, const std::string& Why);

/** Last step: completes the reasons. */
DRYDOCK_API std::vector<FEffectDecision> CompleteReasons(
	const FEffectInputs& Inputs, std::vector<FEffectDecision> Effects);

/** All steps at once, with what is known of the scene; without: settings alone decide. */
DRYDOCK_API std::vector<FEffectDecision> DecideEffects(const FEffectInputs& Inputs, const FViewContent& Content = {});

/** Rendered size in percent of the output's: 100 where ShowFlag.ScreenPercentage is off. */
DRYDOCK_API double GetScreenPercentage(const FViewConditions& Conditions);

using FFiguresByEffect = std::map<EEffect, FEffectFigures>;

/** Figures of the active effects of an executed frame; effects whose textures were not kept are left out. */
DRYDOCK_API FFiguresByEffect MeasureEffects(const std::vector<FEffectDecision>& Effects, const FMeasureInputs& Inputs);

/** The effect that owns a setting, by the longest claim on its name; null: no effect reads it. */
DRYDOCK_API const FEffect* FindSettingOwner(std::string_view Setting);

/** Why a setting does nothing here; empty where it acts. */
DRYDOCK_API std::string GetSettingNotBuiltReason(std::string_view Setting);

/** Active effects of a place, or such as are called for and have nothing to do in the scene, in their order. */
DRYDOCK_API std::vector<const FEffectDecision*> FindEffectsAt(
	EChainPlace Place, const std::vector<FEffectDecision>& Effects);

} // namespace Drydock
