// Changes settings by console variables and show flags: each change is returned as a gate and written to the ledger.
// For the FinalPostProcessSettings*.cpp files.
#pragma once

#include "BlendLedger.h"
#include "FinalPostProcessSettings.h"
#include "HAL/IConsoleManager.h"

#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

namespace Drydock
{

/** The source that changes a setting, and the words for it. */
struct FSettingsEdit
{
	EBlendSource Kind;
	const char* Source; // "r.ExposureOffset"
	const char* Rule;   // "Add"
	std::string Reason; // "r.ExposureOffset is added"
};

inline FSettingsEdit ByVariable(const char* Name, const char* Rule, const char* Predicate)
{
	return {EBlendSource::Variable, Name, Rule, std::string(Name) + " " + Predicate};
}

/** Name: with "ShowFlag." before it. */
inline FSettingsEdit ByFlag(const char* Name)
{
	return {EBlendSource::ShowFlag, Name, "Assign", std::string(Name) + " is off"};
}

class FSettingsEditor
{
public:
	FSettingsEditor(FFinalPostProcessSettings& InSettings, FBlendLedger* InLedger)
		: Settings(InSettings)
		, Ledger(InLedger)
	{
	}

	/** Value: the member of that name. A value that stays as it is makes no record; one that is not finite is not
	 * taken. */
	template<typename T>
	void Assign(const char* Name, T& Value, std::type_identity_t<T> NewValue, const FSettingsEdit& Edit)
	{
		bool bFinite = true;
		if constexpr (std::is_floating_point_v<T>)
		{
			bFinite = std::isfinite(NewValue);
		}
		if (Value == NewValue)
		{
			return;
		}
		const int32 Index = Ledger != nullptr ? FindSettingIndex(Name) : -1;
		FBlendLedgerEntry Entry{Edit.Kind, Edit.Source, Edit.Rule, {}, {}, {}, {}, "", ""};
		if (Index >= 0)
		{
			Entry.Before = GetField(Index).Get(Settings);
		}
		if (bFinite)
		{
			Value = NewValue;
			Gates.push_back({Name, Edit.Reason});
		}
		if (Index >= 0)
		{
			Entry.After = GetField(Index).Get(Settings);
			Entry.Skipped = bFinite ? "" : "the value is not finite";
			Ledger->Add(static_cast<size_t>(Index), std::move(Entry));
		}
	}

	void SwitchOff(bool bOff, const char* Name, float& Value, const FSettingsEdit& Edit)
	{
		if (bOff)
		{
			Assign(Name, Value, 0.0f, Edit);
		}
	}

	std::vector<FSettingGate> Gates;

private:
	static const FSettingField& GetField(int32 Index) { return GetSettingFields()[static_cast<size_t>(Index)]; }

	FFinalPostProcessSettings& Settings;
	FBlendLedger* Ledger;
};

/** A variable that belongs to passes above this storey; Default where they are not there. */
inline float GetVariableOfPasses(const TCHAR* Name, float Default)
{
	const IConsoleVariable* Variable = IConsoleManager::Get().FindConsoleVariable(Name);
	return Variable != nullptr ? Variable->GetFloat() : Default;
}

// A member of Settings after its name, which so cannot differ.
#define DRYDOCK_MEMBER(Name) #Name, Settings.Name

/** Whatever takes the engine's bloom away takes the toon patch's strength along, as the patch's article has it. */
inline void SwitchBloomOff(
	bool bOff, FFinalPostProcessSettings& Settings, FSettingsEditor& Editor, const FSettingsEdit& Edit)
{
	Editor.SwitchOff(bOff, DRYDOCK_MEMBER(BloomIntensity), Edit);
	Editor.SwitchOff(bOff, DRYDOCK_MEMBER(BloomToonIntensity), Edit);
}

} // namespace Drydock
