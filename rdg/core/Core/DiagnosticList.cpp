// Counts the messages of each kind and keeps the first of them.
#include "DiagnosticList.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string_view>
#include <utility>

namespace Drydock
{

namespace
{

constexpr std::string_view MoreBegin = "and ";
constexpr std::string_view MoreMiddle = " more like it (DD";
constexpr size_t MaxSentenceBytes = 2000; // up to the first line break
constexpr size_t MaxMessageBytes = 64000; // with the lines of a table

/** Messages of one severity and one number. */
using FKind = std::pair<ESeverity, int>;

/** How many messages it stands for; 0: for itself. The sentence holds the number, and the kind: fields would be some of
 * every message. */
uint64_t GetNumMore(const FDiagnostic& Diagnostic)
{
	return Diagnostic.Code == MoreDiagnosticsCode
			   ? std::strtoull(Diagnostic.Message.c_str() + MoreBegin.size(), nullptr, 10)
			   : 0;
}

FKind GetKind(const FDiagnostic& Diagnostic)
{
	const size_t Middle =
		Diagnostic.Code == MoreDiagnosticsCode ? Diagnostic.Message.find(MoreMiddle) : std::string::npos;
	const bool bMore = Middle != std::string::npos;
	return {Diagnostic.Severity,
		bMore ? std::atoi(Diagnostic.Message.c_str() + Middle + MoreMiddle.size()) : Diagnostic.Code};
}

FDiagnostic MakeMore(FKind Kind, uint64_t NumMore)
{
	FDiagnostic More;
	More.Severity = Kind.first;
	More.Code = MoreDiagnosticsCode;
	More.Message =
		std::string(MoreBegin) + std::to_string(NumMore) + std::string(MoreMiddle) + std::to_string(Kind.second) + ")";
	return More;
}

/** At the beginning of a UTF-8 character. */
void CutMessage(std::string& Message)
{
	const bool bLongSentence = std::min(Message.find('\n'), Message.size()) > MaxSentenceBytes;
	size_t End = bLongSentence ? MaxSentenceBytes : MaxMessageBytes;
	if (Message.size() <= End)
	{
		return;
	}
	while (End > 0 && (static_cast<unsigned char>(Message[End]) & 0xC0) == 0x80)
	{
		--End;
	}
	Message = Message.substr(0, End) + "...";
}

} // namespace

void AddDiagnostic(std::vector<FDiagnostic>& Diagnostics, FDiagnostic Diagnostic)
{
	const FKind Kind = GetKind(Diagnostic);
	size_t NumAlike = 0;
	for (FDiagnostic& Known : Diagnostics)
	{
		if (GetKind(Known) != Kind)
		{
			continue;
		}
		if (const uint64_t NumMore = GetNumMore(Known); NumMore > 0)
		{
			Known = MakeMore(Kind, NumMore + std::max<uint64_t>(1, GetNumMore(Diagnostic)));
			return;
		}
		++NumAlike;
	}
	CutMessage(Diagnostic.Message);
	if (NumAlike >= MaxDiagnostics && GetNumMore(Diagnostic) == 0)
	{
		Diagnostic = MakeMore(Kind, 1);
	}
	Diagnostics.push_back(std::move(Diagnostic));
}

void AddNewDiagnostics(std::vector<FDiagnostic>& Diagnostics, const std::vector<FDiagnostic>& More)
{
	for (const FDiagnostic& Each : More)
	{
		const auto IsSame = [Text = Each.ToString()](const FDiagnostic& Known)
		{
			return Known.ToString() == Text;
		};
		if (std::none_of(Diagnostics.begin(), Diagnostics.end(), IsSame))
		{
			Diagnostics.push_back(Each);
		}
	}
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

std::vector<FDiagnostic> SummarizeDiagnostics(const std::vector<FDiagnostic>& Diagnostics)
{
	std::map<FKind, uint64_t> NumOfKind;
	for (const FDiagnostic& Diagnostic : Diagnostics)
	{
		NumOfKind[GetKind(Diagnostic)] += std::max<uint64_t>(1, GetNumMore(Diagnostic));
	}
	std::map<FKind, uint64_t> NumListed;
	std::vector<FDiagnostic> Summary;
	for (const FDiagnostic& Diagnostic : Diagnostics)
	{
		const FKind Kind = GetKind(Diagnostic);
		const uint64_t Num = NumOfKind[Kind];
		const uint64_t Place = NumListed[Kind]++;
		if (Num <= MaxListedAlike || Place < NumListedOfMany)
		{
			Summary.push_back(Diagnostic);
			CutMessage(Summary.back().Message);
		}
		else if (Place == NumListedOfMany)
		{
			Summary.push_back(MakeMore(Kind, Num - NumListedOfMany));
		}
	}
	return Summary;
}

FError MakeMemoryError(const std::string& What, uint64_t NumBytes)
{
	std::string Message = "out of memory";
	if (!What.empty())
	{
		Message += ": " + std::to_string(NumBytes) + " bytes are needed for " + What;
	}
	return FError(FDiagnostic{ESeverity::Error, 5008, Message}, ExitFiles);
}

} // namespace Drydock
