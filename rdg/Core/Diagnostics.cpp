// Writes diagnostics as text, and finds the nearest name to a misspelt one.
#include "Diagnostics.h"

#include <algorithm>

namespace Drydock
{

namespace
{

const char* GetSeverityName(ESeverity Severity)
{
	switch (Severity)
	{
	case ESeverity::Note:
		return "note";
	case ESeverity::Warning:
		return "warning";
	default:
		return "error";
	}
}

std::string JoinLines(const std::vector<FDiagnostic>& Diagnostics)
{
	std::string Text;
	for (const FDiagnostic& Diagnostic : Diagnostics)
	{
		Text += (Text.empty() ? "" : "\n") + Diagnostic.ToString();
	}
	return Text;
}

std::string ToLowerCase(std::string Text)
{
	for (char& Character : Text)
	{
		Character = Character >= 'A' && Character <= 'Z' ? static_cast<char>(Character - 'A' + 'a') : Character;
	}
	return Text;
}

/** No name is longer; a text of megabytes in its place is no misspelling, and would be compared letter by letter. */
constexpr size_t MaxNameLength = 200;

bool IsNearEnough(size_t Distance, size_t LongerLength)
{
	return Distance * 3 <= LongerLength;
}

/** Insertions, deletions, replacements and exchanges of neighbours that lead from A to B (optimal string alignment). */
size_t GetEditDistance(const std::string& A, const std::string& B)
{
	std::vector<std::vector<size_t>> Distance(A.size() + 1, std::vector<size_t>(B.size() + 1));
	for (size_t I = 0; I <= A.size(); ++I)
	{
		for (size_t J = 0; J <= B.size(); ++J)
		{
			if (I == 0 || J == 0)
			{
				Distance[I][J] = I + J;
				continue;
			}
			Distance[I][J] = std::min({Distance[I - 1][J] + 1, Distance[I][J - 1] + 1,
				Distance[I - 1][J - 1] + (A[I - 1] == B[J - 1] ? 0 : 1)});
			if (I > 1 && J > 1 && A[I - 1] == B[J - 2] && A[I - 2] == B[J - 1])
			{
				Distance[I][J] = std::min(Distance[I][J], Distance[I - 2][J - 2] + 1);
			}
		}
	}
	return Distance[A.size()][B.size()];
}

} // namespace

std::string FDiagnostic::ToString() const
{
	std::string Text;
	if (!File.empty())
	{
		Text += File + ":";
		if (Line > 0)
		{
			Text += std::to_string(Line) + ":";
			if (Column > 0)
			{
				Text += std::to_string(Column) + ":";
			}
		}
		Text += " ";
	}
	Text += GetSeverityName(Severity);
	// A line of a shader reads as every shader compiler writes it, so that editors and scripts find it.
	if (Code >= 6000 && Code < 7000 && Line > 0 && Where.empty())
	{
		return Text + ": " + Message + " [DD" + std::to_string(Code) + "]";
	}
	if (Code > 0)
	{
		Text += " DD" + std::to_string(Code);
	}
	if (!Where.empty())
	{
		Text += " at " + Where;
	}
	return Text + ": " + Message;
}

FError::FError(std::vector<FDiagnostic> InDiagnostics, EExitCode InExitCode)
	: std::runtime_error(JoinLines(InDiagnostics))
	, Diagnostics(std::move(InDiagnostics))
	, ExitCode(InExitCode)
{
}

FError::FError(const FDiagnostic& Diagnostic, EExitCode InExitCode)
	: FError(std::vector<FDiagnostic>{Diagnostic}, InExitCode)
{
}

FError::~FError() = default;

std::string FindNearestName(const std::string& Name, const std::vector<std::string>& Candidates)
{
	std::string Nearest;
	if (Name.size() > MaxNameLength)
	{
		return Nearest;
	}
	const std::string LowerName = ToLowerCase(Name);
	size_t NearestDistance = 0;
	for (const std::string& Candidate : Candidates)
	{
		const size_t Longer = std::max(Name.size(), Candidate.size());
		if (!IsNearEnough(Longer - std::min(Name.size(), Candidate.size()), Longer)) // so many are inserted at least
		{
			continue;
		}
		const size_t Distance = GetEditDistance(LowerName, ToLowerCase(Candidate));
		if (IsNearEnough(Distance, Longer) && (Nearest.empty() || Distance < NearestDistance))
		{
			Nearest = Candidate;
			NearestDistance = Distance;
		}
	}
	return Nearest;
}

} // namespace Drydock
