// Makes an empty ledger, and finds an entry by its field.
#include "BlendLedger.h"

#include <unordered_map>

namespace Drydock
{

FBlendLedger::FBlendLedger()
	: Entries(GetSettingFields().size())
{
}

const std::vector<FBlendLedgerEntry>& FBlendLedger::GetEntries(const std::string& Setting) const
{
	const int32 Index = FindSettingIndex(Setting);
	checkf(Index >= 0, TEXT("no setting is called %s"), Setting.c_str());
	return Entries[static_cast<size_t>(Index)];
}

const char* ToString(EBlendSource Kind)
{
	constexpr const char* Names[] = {"default", "variable", "volume", "camera", "commandLine", "showFlag", "extension"};
	return Names[size_t(Kind)];
}

int32 FindSettingIndex(const std::string& Name)
{
	static const std::unordered_map<std::string, int32> Indices = []
	{
		std::unordered_map<std::string, int32> Map;
		for (const FSettingField& Field : GetSettingFields())
		{
			if (Field.AddedId == 0)
			{
				Map.emplace(Field.Name, static_cast<int32>(Map.size()));
			}
		}
		return Map;
	}();
	if (const auto Found = Indices.find(Name); Found != Indices.end())
	{
		return Found->second;
	}
	const FSettingField* const Added = FindSettingField(Name);
	return Added == nullptr ? -1 : static_cast<int32>(Added - GetSettingFields().data());
}

} // namespace Drydock
