// The ledger: the history of every setting's value, from the default to the value that a view renders with. Volumes,
// camera, command line, console variables and show flags change it in between.
#pragma once

#include "PostProcessSettingsReflection.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

enum class EBlendSource : uint8
{
	Default,
	Variable, // a console variable
	Volume,
	Camera,
	CommandLine, // --pp
	ShowFlag,
	Extension, // a view extension that edited the settings
};

/** One thing that changed a setting, or might have. */
struct FBlendLedgerEntry
{
	EBlendSource Kind = EBlendSource::Default;
	std::string Source;             // "default", a volume's name, "camera", "--pp", "r.BloomQuality", "ShowFlag.Bloom"
	std::string Rule;               // "Lerp", "Set", ...; of variables and flags "Assign", "Add", "Scale" or "Limit"
	std::optional<float> Weight;    // of volumes, camera and command line
	std::optional<double> Distance; // cm, of bounded volumes
	FSettingValue Before;
	FSettingValue After;
	std::string Skipped; // why it did nothing; empty: it acted
	std::string Detail;  // of fields that contribute to a list instead of having one value: the list afterwards
};

/** Filled by the functions that blend, where they are given one: without it nothing is recorded, and nothing paid. */
class DRYDOCK_API FBlendLedger
{
public:
	FBlendLedger();

	/** In the order in which things happened; the first is the default. */
	const std::vector<FBlendLedgerEntry>& GetEntries(size_t FieldIndex) const { return Entries[FieldIndex]; }
	/** Setting: must exist. */
	const std::vector<FBlendLedgerEntry>& GetEntries(const std::string& Setting) const;

	void Add(size_t FieldIndex, FBlendLedgerEntry Entry) { Entries[FieldIndex].push_back(std::move(Entry)); }

private:
	std::vector<std::vector<FBlendLedgerEntry>> Entries; // by index in GetSettingFields()
};

/** "default", "variable", "volume", "camera", "commandLine", "showFlag", "extension". */
DRYDOCK_API const char* ToString(EBlendSource Kind);

/** Index in GetSettingFields(); -1 when no field has exactly this name. */
DRYDOCK_API int32 FindSettingIndex(const std::string& Name);

} // namespace Drydock
