// Maps numbers to logarithmic axes, draws these, and places labels where nothing is yet.
#include "Study/StudyPanel.h"

#include "Math/ToInteger.h"
#include "Text/Fmt.inl"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

constexpr double LabelSize = 11.0;

} // namespace

FLogAxis::FLogAxis(const std::vector<double>& Values, double InFrom, double InTo)
	: From(InFrom)
	, To(InTo)
{
	double Least = HUGE_VAL;
	double Most = 0.0;
	for (const double Value : Values)
	{
		if (Value > 0.0 && std::isfinite(Value))
		{
			Least = std::min(Least, Value);
			Most = std::max(Most, Value);
		}
	}
	if (Most > 0.0)
	{
		// A tenth of the span at each end, half a factor of two at least.
		const double Room = std::max(1.4, std::pow(Most / Least, 0.08));
		Low = Least / Room;
		High = Most * Room;
	}
}

double FLogAxis::Map(double Value) const
{
	const double Clamped = Value > Low ? std::min(Value, High) : Low;
	return From + std::log(Clamped / Low) / std::log(High / Low) * (To - From);
}

std::vector<double> FLogAxis::GetTicks() const
{
	const double Decades = std::log10(High / Low);
	const int Step = Decades > 7.0 ? 2 : 1;
	std::vector<double> Ticks;
	constexpr int Smallest = -324, Largest = 309; // powers of ten that a double can be of
	const int LastPower = ToCount(std::ceil(std::log10(High)), Smallest, Largest);
	for (int Power = ToCount(std::floor(std::log10(Low)), Smallest, Largest); Power <= LastPower; ++Power)
	{
		for (const double Factor : {1.0, 1.5, 2.0, 3.0, 5.0, 7.0})
		{
			const double Tick = Factor * std::pow(10.0, Power);
			const bool bOften = Factor == 1.5 || Factor == 3.0 || Factor == 7.0;
			const bool bWanted = Factor == 1.0   ? Power % Step == 0
								 : bOften        ? Decades < 0.75
								 : Factor == 2.0 ? Decades < 2.2
												 : Decades < 1.6;
			if (bWanted && Tick >= Low && Tick <= High)
			{
				Ticks.push_back(Tick);
			}
		}
	}
	return Ticks;
}

double EstimateTextWidth(const std::string& Text, double FontSize)
{
	double Width = 0.0;
	for (const char Character : Text)
	{
		const bool bNarrow = std::string("iljt.,:;|'() ").find(Character) != std::string::npos;
		const bool bContinues = (static_cast<unsigned char>(Character) & 0xC0) == 0x80;
		Width += bContinues ? 0.0 : bNarrow ? 0.36 : std::isupper(static_cast<unsigned char>(Character)) ? 0.74 : 0.63;
	}
	return Width * FontSize;
}

std::string TickMarkup(double Value)
{
	const int Power = ToInteger<int>(std::round(std::log10(Value)));
	const bool bPower = std::abs(std::log10(Value) - Power) < 1e-9;
	if (bPower && (Power < -3 || Power > 4))
	{
		return fmt::format(
			"10<tspan dy=\"-4\" font-size=\"8.5\">{}{}</tspan>", Power < 0 ? "\xE2\x88\x92" : "", std::abs(Power));
	}
	return Value < 1e-3 ? ShortText(Value) : FixedText(Value, Value < 1.0 ? 4 : 2);
}

std::string DrawAxes(const FSvgBox& Plot, const FLogAxis& X, const FLogAxis& Y, const std::vector<double>& XTicks,
	const std::string& XName, const std::string& YName)
{
	std::string Svg = SvgRect(Plot, "plot");
	double LastRight = -HUGE_VAL;
	for (const double Tick : XTicks)
	{
		const double Place = X.Map(Tick);
		Svg += SvgLine(Place, Plot.Top, Place, Plot.Bottom, "grid");
		const std::string Markup = TickMarkup(Tick);
		const double Half = Markup.find('<') == std::string::npos ? EstimateTextWidth(Markup, LabelSize) / 2.0 : 12.0;
		if (Place - Half > LastRight)
		{
			Svg += SvgMarkup(Place, Plot.Bottom + 16.0, "tick mid", Markup);
			LastRight = Place + Half + 5.0;
		}
	}
	for (const double Tick : Y.GetTicks())
	{
		const double Place = Y.Map(Tick);
		Svg += SvgLine(Plot.Left, Place, Plot.Right, Place, "grid");
		Svg += SvgMarkup(Plot.Left - 7.0, Place + 4.0, "tick end", TickMarkup(Tick));
	}
	Svg += SvgText((Plot.Left + Plot.Right) / 2.0, Plot.Bottom + 33.0, "tick quiet mid", XName);
	return Svg + fmt::format("<text transform=\"translate({} {}) rotate(-90)\" class=\"tick quiet mid\">{}</text>\n",
					 Px(Plot.Left - 44.0), Px((Plot.Top + Plot.Bottom) / 2.0), EscapeXml(YName));
}

bool FLabelPlacer::IsFree(const FSvgBox& Box) const
{
	return Within.Contains(Box) &&
		   std::none_of(Taken.begin(), Taken.end(), [&](const FSvgBox& Other) { return Other.Overlaps(Box); });
}

std::string FLabelPlacer::Place(double X, double Y, const std::string& Text, const std::string& Class)
{
	const bool bStrong = Class.find("strong") != std::string::npos;
	const double Width = EstimateTextWidth(Text, LabelSize) * (bStrong ? 1.1 : 1.0);
	for (const double Distance : {9.0, 15.0, 24.0, 36.0, 50.0, 66.0})
	{
		const double Diagonal = Distance * 0.75;
		const std::pair<double, double> Anchors[] = {{X + Distance, Y + 4.0}, {X - Distance - Width, Y + 4.0},
			{X + Diagonal, Y - Diagonal}, {X + Diagonal, Y + Diagonal + 7.0}, {X - Diagonal - Width, Y - Diagonal},
			{X - Diagonal - Width, Y + Diagonal + 7.0}, {X - Width / 2.0, Y - Distance},
			{X - Width / 2.0, Y + Distance + 8.0}};
		for (const auto& [TextX, TextY] : Anchors)
		{
			const FSvgBox Box{TextX - 2.0, TextY - 10.0, TextX + Width + 2.0, TextY + 3.0};
			if (IsFree(Box))
			{
				Taken.push_back(Box);
				const double EndX = std::clamp(X, TextX, TextX + Width);
				const double EndY = std::clamp(Y, TextY - 8.0, TextY + 1.0);
				const std::string Leader = Distance > 15.0 ? SvgLine(X, Y, EndX, EndY, "leader") : "";
				return Leader + SvgText(TextX, TextY, Class, Text);
			}
		}
	}
	return "";
}

} // namespace Drydock
