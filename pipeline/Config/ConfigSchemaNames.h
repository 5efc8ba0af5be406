// Parts of the schema that several files write: references and types, and names that an editor completes.
#pragma once

#include "Config/ConfigKeys.h"
#include "Text/JsonWriter.h"

namespace Drydock
{

/** Names that this room does not know. */
struct FSchemaNames
{
	std::vector<std::string> Extensions = {}; // types
	std::vector<std::string> Passes = {};     // types
	std::vector<std::string> Hooks = {};
	std::vector<std::string> Metrics = {};
	/** Writes the elements of "allOf" of the object "extension" or "pass": what else it has, by its type. Null:
	 * nothing. */
	void (*WriteTypeRules)(FJsonWriter& Writer, const std::string& Object) = nullptr;
};

/** A reference to a definition. */
FJsonWriter::FMember ReferTo(const std::string& Definition);

/** "type": Type */
FJsonWriter::FMember TypeOf(const char* Type);

/** Inside an object that has been begun: a reference to a definition. */
void WriteReference(FJsonWriter& Writer, const std::string& Definition);

/** "type": Type */
void WriteType(FJsonWriter& Writer, const char* Type);

/** "enum": [...] */
void WriteEnum(FJsonWriter& Writer, const std::vector<std::string>& Texts);

/** Inside the object of a key whose values have names: writes the names that it takes. For any other key the result is
 * false, and nothing is written. If plugins may add names, any other text is valid too. */
bool WriteKnownNames(FJsonWriter& Writer, const FConfigKey& Key, const FSchemaNames& Names);

/** The definition "variables": all console variables, and any that a plugin brings. */
void WriteVariables(FJsonWriter& Writer);

} // namespace Drydock
