// Makes the axes of charts and their ticks.
#include "Picture/Chart.h"

#include "Math/ToInteger.h"
#include "Picture/SvgTools.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

/** Whether a multiple of a power of ten is worth a tick on a logarithmic axis of so many decades. */
bool IsTick(double Factor, int Power, double Decades)
{
	return Factor == 1.0   ? Power % (Decades > 7.0 ? 2 : 1) == 0
		   : Factor == 2.0 ? Decades < 2.2
		   : Factor == 5.0 ? Decades < 1.6
						   : Decades < 0.75;
}

} // namespace

double FChartAxis::Map(double Value) const
{
	return bLog ? std::log(std::clamp(Value, Low, High) / Low) / std::log(High / Low) : (Value - Low) / (High - Low);
}

std::string FChartAxis::NameValue(double Value) const
{
	const int32_t NumNames = static_cast<int32_t>(ValueNames.size());
	const bool bNamed = Value >= 0.0 && Value < NumNames;
	return bNamed ? ValueNames[static_cast<size_t>(ToIndex(Value, NumNames))] : ShortText(Value);
}

FChartAxis MakeLogAxis(const std::string& Name, const std::vector<double>& Values)
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
	FChartAxis Axis{Name, true, 0.1, 10.0, {}, {}};
	if (Most > 0.0)
	{
		// A twelfth of the span at each end, half a factor of two at least.
		const double Room = std::max(1.4, std::pow(Most / Least, 0.08));
		Axis.Low = Least / Room;
		Axis.High = Most * Room;
	}
	constexpr int Smallest = -324, Largest = 309; // powers of ten that a double can be of
	const int LastPower = ToCount(std::ceil(std::log10(Axis.High)), Smallest, Largest);
	for (int Power = ToCount(std::floor(std::log10(Axis.Low)), Smallest, Largest); Power <= LastPower; ++Power)
	{
		for (const double Factor : {1.0, 1.5, 2.0, 3.0, 5.0, 7.0})
		{
			const double Tick = Factor * std::pow(10.0, Power);
			if (IsTick(Factor, Power, std::log10(Axis.High / Axis.Low)) && Tick >= Axis.Low && Tick <= Axis.High)
			{
				Axis.Ticks.push_back({Tick, NameLogTick(Tick)});
			}
		}
	}
	return Axis;
}

FChartAxis MakeLinearAxis(
	const std::string& Name, double Low, double High, int MaxTicks, const std::vector<std::string>& ValueNames)
{
	constexpr size_t MostCharacters = 17;
	FChartAxis Axis{Name, false, Low, High, {}, ValueNames};
	const double Rough = (High - Low) / MaxTicks;
	const double Power = std::pow(10.0, std::floor(std::log10(Rough)));
	double Step = Power;
	for (const double Factor : {2.0, 5.0, 10.0})
	{
		Step = Step < Rough ? Factor * Power : Step;
	}
	const int Digits = std::max(0, ToInteger<int>(-std::floor(std::log10(Step) + 1e-9)));
	// Counted: between two neighbouring numbers a step is too small to lead from one to the other.
	const double First = std::ceil(Low / Step - 1e-9);
	for (int Tick = 0; Tick <= 2 * MaxTicks && (First + Tick) * Step <= High + Step * 1e-9; ++Tick)
	{
		const double Value = (First + Tick) * Step;
		if (ValueNames.empty() || Value == std::floor(Value))
		{
			Axis.Ticks.push_back({Value,
				ValueNames.empty() ? FixedText(Value, Digits) : ShortenText(Axis.NameValue(Value), MostCharacters)});
		}
	}
	return Axis;
}

std::string NameLogTick(double Value)
{
	static const char* const Raised[] = {
		"\u2070", "\u00B9", "\u00B2", "\u00B3", "\u2074", "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
	const int Power = ToInteger<int>(std::round(std::log10(Value)));
	if (std::abs(std::log10(Value) - Power) >= 1e-9 || (Power >= -3 && Power <= 4))
	{
		return Value < 1e-3 ? ShortText(Value) : FixedText(Value, Value < 1.0 ? 4 : 2);
	}
	std::string Text = Power < 0 ? "10\u207B" : "10";
	for (const char Digit : std::to_string(std::abs(Power)))
	{
		Text += Raised[Digit - '0'];
	}
	return Text;
}

} // namespace Drydock
