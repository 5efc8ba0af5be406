// What is written to the ledger, and how an entry is found by its field.
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
	switch (Kind)
	{
	case EBlendSource::Default:
		return "default";
	case EBlendSource::Variable:
		return "variable";
	case EBlendSource::Volume:
		return "volume";
	case EBlendSource::Camera:
		return "camera";
	case EBlendSource::CommandLine:
		return "commandLine";
	case EBlendSource::ShowFlag:
		return "showFlag";
	case EBlendSource::Extension:
		return "extension";
	}
	return "?";
}

int32 FindSettingIndex(const std::string& Name)
{
	static const std::unordered_map<std::string, int32> Indices = []
	{
		std::unordered_map<std::string, int32> Map;
		for (const FSettingField& Field : GetSettingFields())
		{
			Map.emplace(Field.Name, static_cast<int32>(Map.size()));
		}
		return Map;
	}();
	const auto Found = Indices.find(Name);
	return Found == Indices.end() ? -1 : Found->second;
}

} // namespace Drydock
