// Writes keys of curves and reads them.
#include "CurveKeys.h"

#include "SettingObjects.h"
#include "TextTools.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace Drydock
{

namespace
{

/** A finite number at the beginning of Text, which goes on behind it. */
bool TakeFloat(std::string_view& Text, float& OutNumber)
{
	const std::from_chars_result Result = std::from_chars(Text.data(), Text.data() + Text.size(), OutNumber);
	if (Result.ec != std::errc() || !std::isfinite(OutNumber))
	{
		return false;
	}
	Text.remove_prefix(static_cast<size_t>(Result.ptr - Text.data()));
	return true;
}

bool Take(std::string_view& Text, std::string_view Part)
{
	const bool bFound = Text.starts_with(Part);
	Text.remove_prefix(bFound ? Part.size() : 0);
	return bFound;
}

} // namespace

const std::vector<std::string>& GetCurveInterpNames()
{
	static const std::vector<std::string> Names = {"linear", "constant", "cubic"};
	return Names;
}

std::string WriteCurveKeys(const FRichCurve& Curve)
{
	check(Curve.Keys.Num() > 0);
	std::string Text = JoinText(Curve.Keys, ", ",
		[&](const FRichCurveKey& Key) { return FormatShortest(Key.Time) + " " + FormatShortest(Key.Value); });
	return GetCurveInterpNames()[static_cast<size_t>(Curve.Keys[0].InterpMode)] + "(" + Text + ")";
}

std::optional<FRichCurve> ReadCurveKeys(const std::string& Text)
{
	const std::vector<std::string>& Names = GetCurveInterpNames();
	const size_t Open = Text.find('(');
	const auto Name = std::find(Names.begin(), Names.end(), Text.substr(0, Open));
	if (Open == std::string::npos || Name == Names.end())
	{
		return std::nullopt;
	}
	std::string_view Rest = std::string_view(Text).substr(Open + 1);
	FRichCurve Curve;
	do
	{
		FRichCurveKey Key;
		Key.InterpMode = static_cast<ERichCurveInterpMode>(Name - Names.begin());
		const bool bRead = TakeFloat(Rest, Key.Time) && Take(Rest, " ") && TakeFloat(Rest, Key.Value);
		if (!bRead || (Curve.Keys.Num() > 0 && !(Key.Time > Curve.Keys.Last().Time)))
		{
			return std::nullopt;
		}
		Curve.Keys.Add(Key);
	} while (Take(Rest, ", "));
	if (Rest != ")")
	{
		return std::nullopt;
	}
	Curve.AutoSetTangents();
	return Curve;
}

std::optional<FRichCurve> FindCurveKeys(const UCurveFloat* Curve)
{
	return Curve != nullptr ? ReadCurveKeys(GetObjectPath(Curve)) : std::nullopt;
}

} // namespace Drydock
