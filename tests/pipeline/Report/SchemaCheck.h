// Checks JSON against a JSON schema as far as report.schema.json goes: type, const, enum, required, properties,
// additionalProperties, items and $ref to its own $defs or those of a schema beside it.
#pragma once

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace ReportTest
{

using FJson = nlohmann::json;

/** A schema of the folder report/ by its name. */
inline FJson ReadSchemaFile(const std::string& Name)
{
	std::ifstream File(DRYDOCK_TEST_SOURCE_DIR "/report/" + Name);
	return FJson::parse(File);
}

class FSchemaCheck
{
public:
	explicit FSchemaCheck(const FJson& InSchema)
		: Schema(InSchema)
	{
	}

	/** What is wrong, each with its place; empty: nothing. */
	std::vector<std::string> Check(const FJson& Value)
	{
		Faults.clear();
		CheckValue(Value, Schema, "");
		return Faults;
	}

private:
	static bool IsOfType(const FJson& Value, const std::string& Type)
	{
		return Type == "object"    ? Value.is_object()
			   : Type == "array"   ? Value.is_array()
			   : Type == "string"  ? Value.is_string()
			   : Type == "boolean" ? Value.is_boolean()
			   : Type == "integer" ? Value.is_number_integer()
			   : Type == "number"  ? Value.is_number()
								   : throw std::invalid_argument("unknown type " + Type);
	}

	void CheckReference(const FJson& Value, const std::string& Reference, const std::string& At)
	{
		const size_t Hash = Reference.find('#');
		const FJson::json_pointer Place(Reference.substr(Hash + 1));
		if (Hash == 0)
		{
			CheckValue(Value, Schema.at(Place), At);
			return;
		}
		const FJson Other = ReadSchemaFile(Reference.substr(0, Hash));
		FSchemaCheck Check(Other);
		Check.CheckValue(Value, Other.at(Place), At);
		Faults.insert(Faults.end(), Check.Faults.begin(), Check.Faults.end());
	}

	void CheckValue(const FJson& Value, const FJson& Rule, const std::string& At)
	{
		if (Rule.contains("$ref"))
		{
			CheckReference(Value, Rule["$ref"], At);
		}
		if (Rule.contains("type") && !IsOfType(Value, Rule["type"]))
		{
			Faults.push_back(At + ": no " + Rule["type"].get<std::string>());
			return;
		}
		if (Rule.contains("const") && Value != Rule["const"])
		{
			Faults.push_back(At + ": not " + Rule["const"].dump());
		}
		if (Rule.contains("enum") && std::find(Rule["enum"].begin(), Rule["enum"].end(), Value) == Rule["enum"].end())
		{
			Faults.push_back(At + ": none of " + Rule["enum"].dump());
		}
		for (const FJson& Name : Rule.value("required", FJson::array()))
		{
			if (!Value.contains(Name.get<std::string>()))
			{
				Faults.push_back(At + ": without " + Name.get<std::string>());
			}
		}
		if (Value.is_object())
		{
			const FJson Properties = Rule.value("properties", FJson::object());
			for (const auto& [Name, Member] : Value.items())
			{
				if (Properties.contains(Name))
				{
					CheckValue(Member, Properties[Name], At + "/" + Name);
				}
				else if (!Rule.value("additionalProperties", true))
				{
					Faults.push_back(At + ": knows no " + Name);
				}
			}
		}
		if (Value.is_array() && Rule.contains("items"))
		{
			for (size_t Index = 0; Index < Value.size(); ++Index)
			{
				CheckValue(Value[Index], Rule["items"], At + "/" + std::to_string(Index));
			}
		}
	}

	const FJson& Schema;
	std::vector<std::string> Faults;
};

} // namespace ReportTest
