// Checks a value against a JSON schema (draft 7) as far as the schema of configs goes. A keyword that is not known here
// is an exception, so that nothing is passed over.
#pragma once

#include <nlohmann/json.hpp>

#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace SchemaTest
{

using FJson = nlohmann::json;

class FSchemaRules
{
public:
	explicit FSchemaRules(FJson InSchema)
		: Schema(std::move(InSchema))
	{
	}

	/** What is wrong, each with its place; empty: nothing. */
	std::vector<std::string> Check(const FJson& Value) const
	{
		std::vector<std::string> Faults;
		CheckValue(Value, Schema, "", Faults);
		return Faults;
	}

private:
	using FFaults = std::vector<std::string>;

	static bool IsOfType(const FJson& Value, const std::string& Type)
	{
		return Type == "object"    ? Value.is_object()
			   : Type == "array"   ? Value.is_array()
			   : Type == "string"  ? Value.is_string()
			   : Type == "boolean" ? Value.is_boolean()
			   : Type == "null"    ? Value.is_null()
			   : Type == "integer"
				   ? Value.is_number() && Value.get<double>() == static_cast<double>(Value.get<int64_t>())
			   : Type == "number" ? Value.is_number()
								  : throw std::invalid_argument("unknown type " + Type);
	}

	bool Fits(const FJson& Value, const FJson& Rule) const
	{
		FFaults Faults;
		CheckValue(Value, Rule, "", Faults);
		return Faults.empty();
	}

	void CheckMembers(const FJson& Value, const FJson& Rule, const std::string& At, FFaults& Faults) const
	{
		const FJson Properties = Rule.value("properties", FJson::object());
		const FJson Further = Rule.value("additionalProperties", FJson(true));
		for (const auto& [Name, Member] : Value.items())
		{
			if (Properties.contains(Name))
			{
				CheckValue(Member, Properties[Name], At + "/" + Name, Faults);
			}
			else if (Further.is_object())
			{
				CheckValue(Member, Further, At + "/" + Name, Faults);
			}
			else if (!Further.get<bool>())
			{
				Faults.push_back(At + ": knows no " + Name);
			}
		}
		for (const FJson& Name : Rule.value("required", FJson::array()))
		{
			if (!Value.contains(Name.get<std::string>()))
			{
				Faults.push_back(At + ": without " + Name.get<std::string>());
			}
		}
		if (Value.size() < Rule.value("minProperties", size_t(0)))
		{
			Faults.push_back(At + ": has too little");
		}
	}

	void CheckValue(const FJson& Value, const FJson& Rule, const std::string& At, FFaults& Faults) const
	{
		static const std::set<std::string> Known = {"$ref", "$schema", "title", "description", "default", "definitions",
			"type", "const", "enum", "properties", "required", "additionalProperties", "minProperties", "items",
			"minItems", "maxItems", "minimum", "maximum", "anyOf", "allOf", "if", "then"};
		for (const auto& [Keyword, Ignored] : Rule.items())
		{
			if (Known.count(Keyword) == 0)
			{
				throw std::invalid_argument("unknown keyword " + Keyword);
			}
		}
		if (Rule.contains("$ref"))
		{
			CheckValue(Value, Schema.at(FJson::json_pointer(Rule["$ref"].get<std::string>().substr(1))), At, Faults);
		}
		const FJson Types = Rule.value("type", FJson::array());
		const FJson List = Types.is_array() ? Types : FJson::array({Types});
		const auto Is = [&Value](const FJson& Type)
		{
			return IsOfType(Value, Type.get<std::string>());
		};
		if (!List.empty() && std::none_of(List.begin(), List.end(), Is))
		{
			Faults.push_back(At + ": is no " + List.dump());
			return;
		}
		if (Rule.contains("const") && Value != Rule["const"])
		{
			Faults.push_back(At + ": is not " + Rule["const"].dump());
		}
		if (Rule.contains("enum") && std::find(Rule["enum"].begin(), Rule["enum"].end(), Value) == Rule["enum"].end())
		{
			Faults.push_back(At + ": " + Value.dump() + " is none of them");
		}
		if (Value.is_number() &&
			(Value.get<double>() < Rule.value("minimum", -1e300) || Value.get<double>() > Rule.value("maximum", 1e300)))
		{
			Faults.push_back(At + ": " + Value.dump() + " is out of range");
		}
		if (Value.is_array() && (Value.size() < Rule.value("minItems", size_t(0)) ||
									Value.size() > Rule.value("maxItems", size_t(1) << 40)))
		{
			Faults.push_back(At + ": has another length");
		}
		if (Value.is_object())
		{
			CheckMembers(Value, Rule, At, Faults);
		}
		for (size_t Index = 0; Value.is_array() && Rule.contains("items") && Index < Value.size(); ++Index)
		{
			CheckValue(Value[Index], Rule["items"], At + "/" + std::to_string(Index), Faults);
		}
		const FJson Any = Rule.value("anyOf", FJson::array());
		if (!Any.empty() && std::none_of(Any.begin(), Any.end(), [&](const FJson& One) { return Fits(Value, One); }))
		{
			Faults.push_back(At + ": " + Value.dump() + " fits none of anyOf");
		}
		for (const FJson& One : Rule.value("allOf", FJson::array()))
		{
			CheckValue(Value, One, At, Faults);
		}
		if (Rule.contains("if") && Fits(Value, Rule["if"]))
		{
			CheckValue(Value, Rule.at("then"), At, Faults);
		}
	}

	const FJson Schema;
};

} // namespace SchemaTest
