// Finds and changes the values that a settings object has of added settings.
#include "AddedSettings.h"

namespace Drydock
{

const FAddedSettings::FEntry* FAddedSettings::Find(uint32 Id) const
{
	if (Entries == nullptr)
	{
		return nullptr;
	}
	const auto Found = Entries->find(Id);
	return Found != Entries->end() ? &Found->second : nullptr;
}

FAddedSettings::FEntry& FAddedSettings::Edit(uint32 Id, const FSettingValue& Default)
{
	if (Entries == nullptr)
	{
		Entries = std::make_shared<std::map<uint32, FEntry>>();
	}
	else if (Entries.use_count() > 1)
	{
		Entries = std::make_shared<std::map<uint32, FEntry>>(*Entries);
	}
	return Entries->try_emplace(Id, FEntry{Default, false}).first->second;
}

} // namespace Drydock
