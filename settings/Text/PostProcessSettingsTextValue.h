// One value of the settings table as engine text, both ways. Source: engine text of pasted properties.
#pragma once

#include "PostProcessSettingsReflection.h"
#include "PostProcessSettingsTextTree.h"

#include <string>

namespace Drydock
{

/** Why a value cannot be read. */
struct FSettingTextProblem
{
	ESettingsTextError Code = ErrorTextWrongType;
	size_t Offset = 0;   // of the part that is wrong
	std::string Message; // "expected a number, found True"
};

/** Reads what the field can have into InOutValue; components that a struct does not name stay as they are. Enum names
 * and components ignore case, as in the engine; enums may be qualified (`EBloomMethod::BM_FFT`) or numbers. On failure
 * returns false and leaves InOutValue alone. Elements of arrays: ReadSettingTextElement. */
DRYDOCK_API bool ReadSettingText(const FSettingField& Field, const FEngineTextValue& Text, FSettingValue& InOutValue,
	FSettingTextProblem& OutProblem);

/** Reads the element of `Name[Index]=`. */
DRYDOCK_API bool ReadSettingTextElement(const FSettingField& Field, int Index, const FEngineTextValue& Text,
	FSettingValue& InOutValue, FSettingTextProblem& OutProblem);

/** Elements of a static array, written one by one; 1 for all other fields. */
DRYDOCK_API int GetNumTextElements(const FSettingField& Field);

/** The value, or the Index-th of its elements, as the engine writes it: six decimals, True and False, short enum names.
 */
DRYDOCK_API std::string WriteSettingText(const FSettingField& Field, const FSettingValue& Value, int Index = 0);

/** 1.200000 */
DRYDOCK_API std::string WriteNumberText(double Number);

/** Weights and objects of `(Array=((Weight=1.000000,Object=..),..))`, `(Array=)` or `()`. */
DRYDOCK_API bool ReadBlendablesText(
	const FEngineTextValue& Text, FWeightedBlendables& OutBlendables, FSettingTextProblem& OutProblem);
DRYDOCK_API std::string WriteBlendablesText(const FWeightedBlendables& Blendables);

} // namespace Drydock
