// The one list of config keys: the reader, the schema and the suggestions in messages all use it.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <vector>

namespace Drydock
{

enum class EConfigKind
{
	String,
	Number,
	Bool,
	Vector3,     // [x, y, z] or {"X":, "Y":, "Z":}
	Rotator,     // [pitch, yaw, roll], {"Pitch":, "Yaw":, "Roll":}, or {"X":, "Y":, "Z":} in that order
	NumberArray, // of Length numbers
	StringArray,
	Vector3Array,
	Object,      // of the kind named by Of
	ObjectArray, // of the kind named by Of
	StringMap,   // any keys
	NumberMap,   // any keys
	Padding,     // a number, [left, top, right, bottom], or an object of the kind named by Of
	Settings,    // post-process settings and their bOverride_ bits
	Variables,   // console variables
	ShowFlags,   // show flags
	Folders,     // a folder's name, an object of the kind named by Of if there is one, or an array of these
	Anything,
};

/** For messages: "a string". */
const char* GetExpected(EConfigKind Kind);

struct FConfigKey
{
	std::string Object; // kind of object that has it; "" is the root
	std::string Name;   // "*": any further key is accepted
	EConfigKind Kind;
	std::string Of; // kind of nested object; allowed texts of a String or StringArray, separated by |; the text that a
					// Number, or an ObjectArray may be instead, after =
	int Length; // of a NumberArray
	bool bRequired;
	std::string Doc;
};

/** All keys, objects in the order of their first mention. */
DRYDOCK_API const std::vector<FConfigKey>& GetConfigKeys();

/** Null when that kind of object has no such key. */
DRYDOCK_API const FConfigKey* FindConfigKey(const std::string& Object, const std::string& Name);

} // namespace Drydock
