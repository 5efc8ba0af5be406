// Overriding by weight, and what view extensions edit afterwards. Source: engine SceneView.cpp
// (OverridePostProcessSettings); the record of edits is drydock's.
#include "FinalPostProcessSettings.h"

#include "BlendContributions.h"
#include "BlendLedger.h"
#include "BlendSource.h"

#include <algorithm>

DRYDOCK_DEFINE_COPIES(FPostProcessSettings)
DRYDOCK_DEFINE_COPIES(FFinalPostProcessSettings)

namespace Drydock
{

void OverridePostProcessSettings(FFinalPostProcessSettings& Settings, const FPostProcessSettings& Source, float Weight)
{
	if (!(Weight > 0.0f))
	{
		return;
	}
	const float Clamped = std::min(Weight, 1.0f);
	BlendContributions(Settings, Source, Clamped);
	for (const uint32 Index : FindOverriddenFields(Source).Fields)
	{
		GetSettingFields()[Index].BlendFrom(Settings, Source, Clamped);
		GetSettingFields()[Index].SetOverridden(Settings, true);
	}
}

std::vector<FSettingGate> RecordExtensionEdits(const FFinalPostProcessSettings& Before,
	FFinalPostProcessSettings& After, const std::string& Extension, FBlendLedger* Ledger)
{
	std::vector<FSettingGate> Gates;
	const std::vector<FSettingField>& Fields = GetSettingFields();
	for (size_t Index = 0; Index < Fields.size(); ++Index)
	{
		const FSettingValue Old = Fields[Index].Get(Before);
		const FSettingValue New = Fields[Index].Get(After);
		if (Old == New)
		{
			continue;
		}
		const bool bFinite = New.IsFinite();
		if (!bFinite)
		{
			Fields[Index].Set(After, Old);
		}
		Gates.push_back({Fields[Index].Name,
			Extension + (bFinite ? " set it" : " set it to a value that is not finite; it is put back")});
		if (Ledger != nullptr)
		{
			Ledger->Add(Index, {EBlendSource::Extension, Extension, "Assign", {}, {}, Old, bFinite ? New : Old,
								   bFinite ? "" : "the value is not finite", ""});
		}
	}
	return Gates;
}

} // namespace Drydock
