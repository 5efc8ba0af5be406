// JSON text to a tree in which every value knows its line, column and JSON pointer. Stricter and more helpful than
// plain JSON: duplicate keys, NaN, Infinity and overflowing numbers are reported, all of them, each at its place. `//`
// and block comments are allowed. It stands on nlohmann-json's SAX parser.
#pragma once

#include "Diagnostics.h"

#include <string>
#include <vector>

namespace Drydock
{

enum class EJsonType
{
	Null,
	Bool,
	Number,
	String,
	Array,
	Object,
	Invalid, // a number that was already reported: readers skip it silently
};

struct FJsonMember;

struct FJsonValue
{
	EJsonType Type = EJsonType::Null;
	bool Bool = false;
	double Number = 0.0;
	std::string String;
	std::vector<FJsonValue> Elements; // of an array
	std::vector<FJsonMember> Members; // of an object, in the order of the file, without duplicates

	int Line = 0;    // 1-based, where the value begins
	int Column = 0;  // 1-based, in characters
	int KeyLine = 0; // where its key begins, for members
	int KeyColumn = 0;
	std::string Pointer; // "/volumes/0/Settings"; "" for the root

	/** Null when this is not an object or has no such member. */
	DRYDOCK_API const FJsonValue* Find(const std::string& Key) const;

	/** The member's number; Otherwise where there is none, as where infinite figures are null. */
	DRYDOCK_API double GetNumber(const std::string& Key, double Otherwise) const;

	/** The member's text; "" where there is none. */
	DRYDOCK_API std::string GetString(const std::string& Key) const;

	/** The elements of the member, an array; no elements where there is none. */
	DRYDOCK_API const std::vector<FJsonValue>& GetElements(const std::string& Key) const;

	/** "a number", "an array", ... for messages. */
	DRYDOCK_API const char* Describe() const;
};

struct FJsonMember
{
	std::string Key;
	FJsonValue Value;
};

/** File names the text in messages. Faults are appended to Diagnostics; after a syntax error the result is the part
 * read before it, and OutSyntaxError is true: do not interpret it. */
DRYDOCK_API FJsonValue ParseJson(
	const std::string& Text, const std::string& File, std::vector<FDiagnostic>& Diagnostics, bool& OutSyntaxError);

} // namespace Drydock
