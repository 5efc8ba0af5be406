// Counts the messages of each severity and keeps the first of them.
#include "DiagnosticList.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace Drydock
{

namespace
{

constexpr std::string_view MoreBegin = "and ";
constexpr size_t MaxMessageBytes = 2000;

const char* GetPlural(ESeverity Severity)
{
	switch (Severity)
	{
	case ESeverity::Error:
		return " more errors";
	case ESeverity::Warning:
		return " more warnings";
	case ESeverity::Note:
		break;
	}
	return " more notes";
}

/** How many messages it stands for. The sentence itself holds the number: a field would be one of every message. */
uint64_t GetNumMore(const FDiagnostic& Diagnostic)
{
	return Diagnostic.Code == MoreDiagnosticsCode
			   ? std::strtoull(Diagnostic.Message.c_str() + MoreBegin.size(), nullptr, 10)
			   : 0;
}

void SetNumMore(FDiagnostic& Diagnostic, uint64_t NumMore)
{
	Diagnostic.Message = std::string(MoreBegin) + std::to_string(NumMore) + GetPlural(Diagnostic.Severity);
}

/** At the beginning of a UTF-8 character. */
void CutMessage(std::string& Message)
{
	if (Message.size() <= MaxMessageBytes)
	{
		return;
	}
	size_t End = MaxMessageBytes;
	while (End > 0 && (static_cast<unsigned char>(Message[End]) & 0xC0) == 0x80)
	{
		--End;
	}
	Message = Message.substr(0, End) + "...";
}

} // namespace

void AddDiagnostic(std::vector<FDiagnostic>& Diagnostics, FDiagnostic Diagnostic)
{
	size_t NumSame = 0;
	for (FDiagnostic& Known : Diagnostics)
	{
		if (Known.Severity != Diagnostic.Severity)
		{
			continue;
		}
		if (const uint64_t NumMore = GetNumMore(Known); NumMore > 0)
		{
			SetNumMore(Known, NumMore + std::max<uint64_t>(1, GetNumMore(Diagnostic)));
			return;
		}
		++NumSame;
	}
	CutMessage(Diagnostic.Message);
	if (NumSame >= MaxDiagnostics && GetNumMore(Diagnostic) == 0)
	{
		FDiagnostic More;
		More.Severity = Diagnostic.Severity;
		More.Code = MoreDiagnosticsCode;
		SetNumMore(More, 1);
		Diagnostic = std::move(More);
	}
	Diagnostics.push_back(std::move(Diagnostic));
}

std::vector<FDiagnostic> LimitDiagnostics(const std::vector<FDiagnostic>& Diagnostics)
{
	std::vector<FDiagnostic> Limited;
	for (const FDiagnostic& Diagnostic : Diagnostics)
	{
		AddDiagnostic(Limited, Diagnostic);
	}
	return Limited;
}

FError MakeMemoryError(const std::string& What, uint64_t NumBytes)
{
	std::string Message = "the system gives no memory";
	if (!What.empty())
	{
		Message += ": " + std::to_string(NumBytes) + " bytes are wanted for " + What;
	}
	return FError(FDiagnostic{ESeverity::Error, 5008, Message}, ExitFiles);
}

} // namespace Drydock
