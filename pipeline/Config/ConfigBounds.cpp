// Shapes of bounded volumes.
#include "Config/ConfigReader.h"

#include <algorithm>
#include <array>
#include <map>

namespace Drydock
{

bool ReadConfigVector(const FJsonValue& Value, FConfigVector& OutVector)
{
	const bool bArray = Value.Type == EJsonType::Array && Value.Elements.size() == 3;
	const bool bObject = Value.Type == EJsonType::Object && Value.Members.size() == 3;
	for (size_t Index = 0; Index < 3; ++Index)
	{
		const FJsonValue* Component = bArray    ? &Value.Elements[Index]
									  : bObject ? Value.Find(std::string(1, "XYZ"[Index]))
												: nullptr;
		if (Component == nullptr || Component->Type != EJsonType::Number)
		{
			return false;
		}
		OutVector[Index] = Component->Number;
	}
	return true;
}

bool ReadConfigRotator(const FJsonValue& Value, FConfigVector& OutRotator)
{
	if (Value.Type != EJsonType::Object || Value.Find("X") != nullptr)
	{
		return ReadConfigVector(Value, OutRotator);
	}
	constexpr std::array Names = {"Pitch", "Yaw", "Roll"};
	OutRotator = {};
	for (const auto& [Name, Angle] : Value.Members)
	{
		const auto Found = std::find(Names.begin(), Names.end(), Name);
		if (Found == Names.end() || Angle.Type != EJsonType::Number)
		{
			return false;
		}
		OutRotator[static_cast<size_t>(Found - Names.begin())] = Angle.Number;
	}
	return !Value.Members.empty();
}

namespace
{

/** The required keys of each shape; a box may have min and max instead. */
const std::map<std::string, std::vector<std::string>>& GetRequiredKeys()
{
	static const std::map<std::string, std::vector<std::string>> Keys = {
		{"box", {"center", "extent"}},
		{"sphere", {"center", "radius"}},
		{"capsule", {"center", "radius", "halfHeight"}},
		{"convex", {"points"}},
	};
	return Keys;
}

FConfigVector ReadVector(const FJsonValue& Object, const char* Key)
{
	FConfigVector Vector = {};
	const FJsonValue* Value = Object.Find(Key);
	if (Value != nullptr)
	{
		ReadConfigVector(*Value, Vector);
	}
	return Vector;
}

/** min and max to centre and extent. */
bool ReadCorners(const FJsonValue& Value, FConfigBounds& Bounds, FConfigMessages& Messages)
{
	const FConfigVector Min = ReadVector(Value, "min");
	const FConfigVector Max = ReadVector(Value, "max");
	for (size_t Index = 0; Index < 3; ++Index)
	{
		if (Min[Index] > Max[Index])
		{
			Messages.Error(ErrorBadValue, Value, "min must not be above max in " + std::string(1, "XYZ"[Index]));
			return false;
		}
		Bounds.Center[Index] = 0.5 * (Min[Index] + Max[Index]);
		Bounds.Extent[Index] = 0.5 * (Max[Index] - Min[Index]);
	}
	return true;
}

} // namespace

std::optional<FConfigBounds> ReadConfigBounds(const FJsonValue& Value, FConfigMessages& Messages)
{
	const FJsonValue* TypeValue = Value.Find("type");
	const std::string Type = TypeValue != nullptr ? TypeValue->String : "box";
	const auto Required = GetRequiredKeys().find(Type);
	if (Required == GetRequiredKeys().end())
	{
		return std::nullopt; // reported as an unknown value
	}
	FConfigBounds Bounds;
	const bool bCorners = Type == "box" && (Value.Find("min") != nullptr || Value.Find("max") != nullptr);
	const std::vector<std::string> Keys = bCorners ? std::vector<std::string>{"min", "max"} : Required->second;
	bool bComplete = true;
	for (const std::string& Key : Keys)
	{
		if (Value.Find(Key) == nullptr)
		{
			const std::string Alternative = Type == "box" && !bCorners ? " (or min and max)" : "";
			Messages.Error(ErrorMissingKey, Value, "a " + Type + " needs \"" + Key + "\"" + Alternative);
			bComplete = false;
		}
	}
	if (!bComplete || (bCorners && !ReadCorners(Value, Bounds, Messages)))
	{
		return std::nullopt;
	}
	Bounds.Shape = Type == "sphere"    ? EConfigShape::Sphere
				   : Type == "capsule" ? EConfigShape::Capsule
				   : Type == "convex"  ? EConfigShape::Convex
									   : EConfigShape::Box;
	if (!bCorners)
	{
		Bounds.Center = ReadVector(Value, "center");
		Bounds.Extent = ReadVector(Value, "extent");
	}
	if (const FJsonValue* Rotation = Value.Find("rotation"))
	{
		ReadConfigRotator(*Rotation, Bounds.Rotation);
	}
	Bounds.Radius = Value.GetNumber("radius", 0.0);
	Bounds.HalfHeight = Value.GetNumber("halfHeight", 0.0);
	for (const FJsonValue& Point : Value.GetElements("points"))
	{
		FConfigVector Vector;
		if (ReadConfigVector(Point, Vector))
		{
			Bounds.Points.push_back(Vector);
		}
	}
	if (Bounds.Shape == EConfigShape::Convex && Value.GetElements("points").empty())
	{
		Messages.Error(ErrorBadValue, Value, "a convex needs at least one point");
		return std::nullopt;
	}
	const bool bNegative = Bounds.Radius < 0.0 || Bounds.HalfHeight < 0.0 || Bounds.Extent[0] < 0.0 ||
						   Bounds.Extent[1] < 0.0 || Bounds.Extent[2] < 0.0;
	if (bNegative)
	{
		Messages.Error(ErrorBadValue, Value, "the sizes of the bounds must not be negative");
		return std::nullopt;
	}
	return Bounds;
}

} // namespace Drydock
