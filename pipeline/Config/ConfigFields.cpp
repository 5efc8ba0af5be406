// Reads strings, numbers and switches of a config's objects.
#include "Config/ConfigFields.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

void ReadString(const FJsonValue& Object, const char* Key, TConfigValue<std::string>& OutValue)
{
	WithMember(Object, Key, EJsonType::String,
		[&](const FJsonValue& Member) {
			OutValue = {Member.String, PlaceOf(Member)};
		});
}

void ReadNumber(const FJsonValue& Object, const char* Key, double& OutNumber)
{
	WithMember(Object, Key, EJsonType::Number, [&](const FJsonValue& Member) { OutNumber = Member.Number; });
}

void ReadBool(const FJsonValue& Object, const char* Key, bool& OutBool)
{
	WithMember(Object, Key, EJsonType::Bool, [&](const FJsonValue& Member) { OutBool = Member.Bool; });
}

void ReadScale(const FJsonValue& Object, const char* Key, TConfigValue<double>& OutValue, FConfigMessages& Messages)
{
	WithMember(Object, Key, EJsonType::Number,
		[&](const FJsonValue& Member)
		{
			if (!(Member.Number > 0.0) || !std::isfinite(static_cast<float>(Member.Number)) ||
				static_cast<float>(Member.Number) == 0.0f)
			{
				Messages.Error(ErrorBadValue, Member, std::string(Key) + " must be above 0");
				return;
			}
			OutValue = {Member.Number, PlaceOf(Member)};
		});
}

void ReadWeight(const FJsonValue& Object, const char* Key, double& OutWeight, FConfigMessages& Messages)
{
	WithMember(Object, Key, EJsonType::Number,
		[&](const FJsonValue& Member)
		{
			OutWeight = std::clamp(Member.Number, 0.0, 1.0);
			if (OutWeight != Member.Number)
			{
				Messages.Warn(WarnWeightClamped, Member, std::string(Key) + " is clamped to 0..1");
			}
		});
}

} // namespace Drydock
