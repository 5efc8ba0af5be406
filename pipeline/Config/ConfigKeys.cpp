// Reads the table of a config's keys.
#include "Config/ConfigKeys.h"

#include "EngineProfile.h"
#include "Misc/AssertionMacros.h"
#include "RangeTools.h"
#include "TextTools.h"

#include <algorithm>
#include <iterator>

namespace Drydock
{

namespace
{

constexpr const char* KeysText =
#include "ConfigKeys.txt"
	;

struct FKindText
{
	const char* Name; // in the table
	const char* Expected;
};

/** By EConfigKind. */
constexpr FKindText Kinds[] = {
	{"String", "a string"},
	{"Number", "a number"},
	{"Bool", "true or false"},
	{"Vector3", "three numbers: [x, y, z] or {\"X\": x, \"Y\": y, \"Z\": z}"},
	{"Rotator", "an angle each: [pitch, yaw, roll] or {\"Pitch\": p, \"Yaw\": y, \"Roll\": r}"},
	{"NumberArray", "an array of numbers"},
	{"StringArray", "an array of strings"},
	{"Vector3Array", "an array of points [x, y, z]"},
	{"Object", "an object"},
	{"ObjectArray", "an array of objects"},
	{"StringMap", "an object of strings"},
	{"NumberMap", "an object of numbers"},
	{"Padding", "a number, or one for each side: {\"left\", \"top\", \"right\", \"bottom\"}"},
	{"Settings", "an object"},
	{"Variables", "an object"},
	{"ShowFlags", "an object"},
	{"Folders", "a folder's name, or an array of them"},
	{"Anything", "a value"},
};

FConfigKey ReadKey(std::vector<std::string> Columns)
{
	check(Columns.size() == 7);
	std::ranges::replace(Columns, "-", "");
	const auto Kind = std::ranges::find(Kinds, Columns[2], &FKindText::Name);
	check(Kind != std::end(Kinds));
	return {Columns[0], Columns[1], static_cast<EConfigKind>(Kind - std::begin(Kinds)),
		Columns[3] == "{engines}" ? ListEngineVersions("|") : Columns[3], std::stoi(Columns[4]), !Columns[5].empty(),
		Columns[6]};
}

} // namespace

const std::vector<FConfigKey>& GetConfigKeys()
{
	static const std::vector<FConfigKey> Keys = ToVector<FConfigKey>(SplitRows(KeysText), ReadKey);
	return Keys;
}

const char* GetExpected(EConfigKind Kind)
{
	return Kinds[static_cast<size_t>(Kind)].Expected;
}

const FConfigKey* FindConfigKey(const std::string& Object, const std::string& Name)
{
	const std::vector<FConfigKey>& Keys = GetConfigKeys();
	const auto Find = [&](const std::string& Wanted)
	{
		const auto Found = std::find_if(Keys.begin(), Keys.end(),
			[&](const FConfigKey& Key) { return Object == Key.Object && Wanted == Key.Name; });
		return Found == Keys.end() ? nullptr : &*Found;
	};
	const FConfigKey* Exact = Find(Name);
	return Exact != nullptr ? Exact : Find("*");
}

} // namespace Drydock
