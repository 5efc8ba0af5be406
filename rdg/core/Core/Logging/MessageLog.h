// Messages to the editor's list of messages: they go to the log. Source: engine Logging/MessageLog.h.
#pragma once

#include "Internationalization/Text.h"
#include "Logging/LogMacros.h"

namespace EMessageSeverity
{
enum Type : int
{
	CriticalError,
	Error,
	PerformanceWarning,
	Warning,
	Info
};
} // namespace EMessageSeverity

class FMessageLog
{
public:
	explicit FMessageLog(const FName& InLogName)
		: LogName(InLogName.ToString())
	{
	}

	void Message(EMessageSeverity::Type Severity, const FText& Text)
	{
		if (Severity <= EMessageSeverity::Error)
		{
			UE_LOG(LogTemp, Error, TEXT("%s: %s"), *LogName, *Text.ToString());
		}
		else if (Severity <= EMessageSeverity::Warning)
		{
			UE_LOG(LogTemp, Warning, TEXT("%s: %s"), *LogName, *Text.ToString());
		}
		else
		{
			UE_LOG(LogTemp, Log, TEXT("%s: %s"), *LogName, *Text.ToString());
		}
	}
	void CriticalError(const FText& Text) { Message(EMessageSeverity::CriticalError, Text); }
	void Error(const FText& Text) { Message(EMessageSeverity::Error, Text); }
	void PerformanceWarning(const FText& Text) { Message(EMessageSeverity::PerformanceWarning, Text); }
	void Warning(const FText& Text) { Message(EMessageSeverity::Warning, Text); }
	void Info(const FText& Text) { Message(EMessageSeverity::Info, Text); }

private:
	FString LogName;
};
