// Curves of settings given by their keys: {"keys": [[time, value], ...], "interp": "linear"}.
#include "Config/ConfigReader.h"

#include "CurveKeys.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

bool IsFloatNumber(const FJsonValue& Value)
{
	return Value.Type == EJsonType::Number && std::isfinite(static_cast<float>(Value.Number));
}

/** False when one is wrong, which is reported. */
bool ReadKeys(const FJsonValue& Keys, const std::string& Setting, FRichCurve& Curve, FConfigMessages& Messages)
{
	bool bRight = true;
	for (const FJsonValue& Element : Keys.Elements)
	{
		const bool bKey = Element.Type == EJsonType::Array && Element.Elements.size() == 2 &&
						  IsFloatNumber(Element.Elements[0]) && IsFloatNumber(Element.Elements[1]);
		if (!bKey)
		{
			Messages.Error(ErrorWrongType, Element, "a key of " + Setting + " must be [time, value], two numbers");
			bRight = false;
			continue;
		}
		FRichCurveKey Key;
		Key.Time = static_cast<float>(Element.Elements[0].Number);
		Key.Value = static_cast<float>(Element.Elements[1].Number);
		if (Curve.Keys.Num() > 0 && !(Key.Time > Curve.Keys.Last().Time))
		{
			Messages.Error(ErrorBadValue, Element, "the times of the keys of " + Setting + " must ascend");
			bRight = false;
		}
		Curve.Keys.Add(Key);
	}
	return bRight;
}

} // namespace

std::optional<std::string> ReadConfigCurve(
	const FJsonValue& Value, const std::string& Setting, FConfigMessages& Messages)
{
	const FJsonValue* const Keys = Value.Find("keys");
	const FJsonValue* const Interp = Value.Find("interp");
	bool bRight = true;
	for (const auto& [Name, Member] : Value.Members)
	{
		if (Name != "keys" && Name != "interp")
		{
			Messages.ErrorAtKey(ErrorUnknownKey, Member,
				"a curve has only \"keys\" and \"interp\", not \"" + Name + "\"" +
					Messages.Suggest(Name, {"keys", "interp"}));
			bRight = false;
		}
	}
	const std::vector<std::string>& Names = GetCurveInterpNames();
	const std::string Mode = Interp != nullptr ? Interp->String : Names[RCIM_Linear];
	const auto Found = std::find(Names.begin(), Names.end(), Mode);
	if (Found == Names.end())
	{
		Messages.Error(ErrorUnknownValue, *Interp,
			"\"interp\" of " + Setting + " must be linear, constant or cubic" + Messages.Suggest(Mode, Names));
		bRight = false;
	}
	if (Keys == nullptr)
	{
		Messages.Error(ErrorMissingKey, Value, "\"keys\" is missing: " + Setting + " is a curve through [time, value]");
		return std::nullopt;
	}
	if (Keys->Type != EJsonType::Array || Keys->Elements.empty())
	{
		Messages.Error(
			ErrorWrongType, *Keys, "\"keys\" of " + Setting + " must be an array of at least one [time, value]");
		return std::nullopt;
	}
	FRichCurve Curve;
	if (!ReadKeys(*Keys, Setting, Curve, Messages) || !bRight)
	{
		return std::nullopt;
	}
	for (FRichCurveKey& Key : Curve.Keys)
	{
		Key.InterpMode = static_cast<ERichCurveInterpMode>(Found - Names.begin());
	}
	return WriteCurveKeys(Curve);
}

} // namespace Drydock
