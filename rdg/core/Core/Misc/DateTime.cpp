// Dates, by the calendar of the standard library.
#include "Misc/DateTime.h"

#include "Misc/AssertionMacros.h"

#include <chrono>
#include <ctime>

namespace
{

using std::chrono::sys_days;
using std::chrono::year_month_day;

/** Days from the first day of the year 1 to that of 1970. */
constexpr int64 DaysTo1970 = 719162;

year_month_day GetCalendarDay(int64 Ticks)
{
	return year_month_day(sys_days(std::chrono::days(Ticks / ETimespan::TicksPerDay - DaysTo1970)));
}

} // namespace

FDateTime::FDateTime(int32 Year, int32 Month, int32 Day, int32 Hour, int32 Minute, int32 Second, int32 Milli)
{
	const year_month_day Date(std::chrono::year(Year), std::chrono::month(static_cast<unsigned>(Month)),
		std::chrono::day(static_cast<unsigned>(Day)));
	check(Date.ok() && Year >= 1 && Year <= 9999 && Hour >= 0 && Hour < 24 && Minute >= 0 && Minute < 60);
	check(Second >= 0 && Second < 60 && Milli >= 0 && Milli < 1000);
	Ticks = (sys_days(Date).time_since_epoch().count() + DaysTo1970) * ETimespan::TicksPerDay +
			FTimespan(Hour, Minute, Second).GetTicks() + Milli * ETimespan::TicksPerMillisecond;
}

int32 FDateTime::GetYear() const
{
	return static_cast<int>(GetCalendarDay(Ticks).year());
}

int32 FDateTime::GetMonth() const
{
	return static_cast<int32>(static_cast<unsigned>(GetCalendarDay(Ticks).month()));
}

int32 FDateTime::GetDay() const
{
	return static_cast<int32>(static_cast<unsigned>(GetCalendarDay(Ticks).day()));
}

int64 FDateTime::ToUnixTimestamp() const
{
	return Ticks / ETimespan::TicksPerSecond - DaysTo1970 * 86400;
}

FDateTime FDateTime::FromUnixTimestamp(int64 Seconds)
{
	return FDateTime((Seconds + DaysTo1970 * 86400) * ETimespan::TicksPerSecond);
}

FString FDateTime::ToString(const TCHAR* Format) const
{
	const std::time_t Seconds = static_cast<std::time_t>(ToUnixTimestamp());
	std::tm Parts = {};
	gmtime_r(&Seconds, &Parts);
	const FString Milli = FString::Printf("%03d", GetMillisecond());
	char Text[256] = "";
	std::strftime(Text, sizeof(Text), *FString(Format).Replace("%s", *Milli, ESearchCase::CaseSensitive), &Parts);
	return Text;
}

FDateTime FDateTime::UtcNow()
{
	const auto Since = std::chrono::system_clock::now().time_since_epoch();
	return FDateTime(std::chrono::duration_cast<std::chrono::nanoseconds>(Since).count() / 100 +
					 DaysTo1970 * ETimespan::TicksPerDay);
}

FDateTime FDateTime::Now()
{
	const FDateTime Utc = UtcNow();
	const std::time_t Seconds = static_cast<std::time_t>(Utc.ToUnixTimestamp());
	std::tm Local = {};
	localtime_r(&Seconds, &Local);
	return Utc + FTimespan(Local.tm_gmtoff * ETimespan::TicksPerSecond);
}
