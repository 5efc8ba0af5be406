// Stores a settings object's values of settings that plugins have added (AddedSettingFields.h).
#pragma once

#include "PostProcessSettingsValue.h"

#include <map>
#include <memory>

namespace Drydock
{

/** The values that one settings object has of added settings. Without any, and so in every run without such a plugin,
 * it is a null pointer; copies share what they have until one of them changes. */
class DRYDOCK_API FAddedSettings
{
public:
	struct FEntry
	{
		FSettingValue Value;
		bool bOverridden = false;
	};

	/** Null: the default, and not overridden. */
	const FEntry* Find(uint32 Id) const;
	/** Made with Default where it is not there. */
	FEntry& Edit(uint32 Id, const FSettingValue& Default);

private:
	std::shared_ptr<std::map<uint32, FEntry>> Entries;
};

} // namespace Drydock
