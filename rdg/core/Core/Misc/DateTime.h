// FDateTime: a date and a time of day, in ticks of 100 nanoseconds since the first day of the year 1. Source: engine
// Misc/DateTime.h.
#pragma once

#include "Containers/UnrealString.h"
#include "Misc/Timespan.h"

struct DRYDOCK_API FDateTime
{
	constexpr FDateTime() = default;
	constexpr explicit FDateTime(int64 InTicks)
		: Ticks(InTicks)
	{
	}
	/** Year 1..9999, Month 1..12, Day from 1; a check where there is no such date. */
	FDateTime(int32 Year, int32 Month, int32 Day, int32 Hour = 0, int32 Minute = 0, int32 Second = 0, int32 Milli = 0);

	constexpr auto operator<=>(const FDateTime&) const = default;
	constexpr FDateTime operator+(FTimespan Span) const { return FDateTime(Ticks + Span.GetTicks()); }
	constexpr FDateTime operator-(FTimespan Span) const { return FDateTime(Ticks - Span.GetTicks()); }
	constexpr FTimespan operator-(FDateTime Other) const { return FTimespan(Ticks - Other.Ticks); }

	constexpr int64 GetTicks() const { return Ticks; }
	int32 GetYear() const;
	int32 GetMonth() const;
	int32 GetDay() const;
	constexpr FTimespan GetTimeOfDay() const { return FTimespan(Ticks % ETimespan::TicksPerDay); }
	constexpr int32 GetHour() const { return GetTimeOfDay().GetHours(); }
	constexpr int32 GetMinute() const { return GetTimeOfDay().GetMinutes(); }
	constexpr int32 GetSecond() const { return GetTimeOfDay().GetSeconds(); }
	constexpr int32 GetMillisecond() const { return GetTimeOfDay().GetFractionMilli(); }
	/** Seconds since 1970. */
	int64 ToUnixTimestamp() const;
	static FDateTime FromUnixTimestamp(int64 Seconds);
	/** "2026.11.28-14.03.05". */
	FString ToString() const { return ToString(TEXT("%Y.%m.%d-%H.%M.%S")); }
	/** strftime's letters, but %s is the milliseconds. */
	FString ToString(const TCHAR* Format) const;
	/** "2026-11-28T14:03:05.250Z". */
	FString ToIso8601() const { return ToString(TEXT("%Y-%m-%dT%H:%M:%S.%sZ")); }

	/** In the machine's time zone. */
	static FDateTime Now();
	static FDateTime UtcNow();

private:
	int64 Ticks = 0;
};
