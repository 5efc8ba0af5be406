// FTimespan: a span of time, in ticks of 100 nanoseconds. Source: engine Misc/Timespan.h.
#pragma once

#include "CoreTypes.h"

#include <compare>

namespace ETimespan
{
inline constexpr int64 TicksPerMillisecond = 10000;
inline constexpr int64 TicksPerSecond = 10000000;
inline constexpr int64 TicksPerMinute = 600000000;
inline constexpr int64 TicksPerHour = 36000000000;
inline constexpr int64 TicksPerDay = 864000000000;
} // namespace ETimespan

struct FTimespan
{
	constexpr FTimespan() = default;
	constexpr explicit FTimespan(int64 InTicks)
		: Ticks(InTicks)
	{
	}
	constexpr FTimespan(int32 Hours, int32 Minutes, int32 Seconds)
		: Ticks(((Hours * int64(60) + Minutes) * 60 + Seconds) * ETimespan::TicksPerSecond)
	{
	}

	constexpr auto operator<=>(const FTimespan&) const = default;
	constexpr FTimespan operator+(FTimespan Other) const { return FTimespan(Ticks + Other.Ticks); }
	constexpr FTimespan operator-(FTimespan Other) const { return FTimespan(Ticks - Other.Ticks); }
	constexpr int64 GetTicks() const { return Ticks; }
	constexpr double GetTotalDays() const { return static_cast<double>(Ticks) / ETimespan::TicksPerDay; }
	constexpr double GetTotalHours() const { return static_cast<double>(Ticks) / ETimespan::TicksPerHour; }
	constexpr double GetTotalMinutes() const { return static_cast<double>(Ticks) / ETimespan::TicksPerMinute; }
	constexpr double GetTotalSeconds() const { return static_cast<double>(Ticks) / ETimespan::TicksPerSecond; }
	constexpr double GetTotalMilliseconds() const { return GetTotalSeconds() * 1000.0; }
	// The parts of days, hours, minutes, seconds and a fraction.
	constexpr int32 GetDays() const { return static_cast<int32>(Ticks / ETimespan::TicksPerDay); }
	constexpr int32 GetHours() const { return static_cast<int32>(Ticks / ETimespan::TicksPerHour % 24); }
	constexpr int32 GetMinutes() const { return static_cast<int32>(Ticks / ETimespan::TicksPerMinute % 60); }
	constexpr int32 GetSeconds() const { return static_cast<int32>(Ticks / ETimespan::TicksPerSecond % 60); }
	constexpr int32 GetFractionMilli() const
	{
		return static_cast<int32>(Ticks / ETimespan::TicksPerMillisecond % 1000);
	}

	static FTimespan FromSeconds(double Seconds) { return FTimespan(static_cast<int64>(Seconds * 1e7)); }
	static FTimespan FromMilliseconds(double Milliseconds) { return FromSeconds(Milliseconds * 0.001); }
	static FTimespan FromMinutes(double Minutes) { return FromSeconds(Minutes * 60.0); }
	static FTimespan FromHours(double Hours) { return FromSeconds(Hours * 3600.0); }
	static FTimespan FromDays(double Days) { return FromSeconds(Days * 86400.0); }

private:
	int64 Ticks = 0;
};
