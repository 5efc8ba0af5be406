// Reads single members of a config's objects: a member that is missing, or of another type, which the check of shapes
// has reported, leaves the value as it is.
#pragma once

#include "Config/Config.h"
#include "Config/ConfigReader.h"
#include "Text/Json.h"

#include <string>

namespace Drydock
{

/** Calls Function with the member of that key where it is of that type. */
template<typename TFunction>
void WithMember(const FJsonValue& Object, const char* Key, EJsonType Type, const TFunction& Function)
{
	const FJsonValue* Member = Object.Find(Key);
	if (Member != nullptr && Member->Type == Type)
	{
		Function(*Member);
	}
}

void ReadString(const FJsonValue& Object, const char* Key, TConfigValue<std::string>& OutValue);
void ReadNumber(const FJsonValue& Object, const char* Key, double& OutNumber);
void ReadBool(const FJsonValue& Object, const char* Key, bool& OutBool);

/** A factor of brightness: finite and above 0. */
void ReadScale(const FJsonValue& Object, const char* Key, TConfigValue<double>& OutValue, FConfigMessages& Messages);

/** A weight, clamped to 0..1 with a warning. */
void ReadWeight(const FJsonValue& Object, const char* Key, double& OutWeight, FConfigMessages& Messages);

} // namespace Drydock
