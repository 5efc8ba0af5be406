// Writes diagnostics as text, and finds the nearest name to a misspelt one.
#include "Diagnostics.h"

#include "PrintText.h"
#include "TextTools.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace Drydock
{

namespace
{

const char* GetSeverityName(ESeverity Severity)
{
	return Severity == ESeverity::Note ? "note" : Severity == ESeverity::Warning ? "warning" : "error";
}

/** No name is longer; a text of megabytes in its place is not a misspelling, and would be compared letter by letter. */
constexpr size_t MaxNameLength = 200;

/** How far a name may be from one that it stands for, by the length of the longer one. */
size_t GetFarthest(size_t LongerLength)
{
	return LongerLength / 3;
}

/** Insertions, deletions, replacements and exchanges of neighbours that lead from A to B (optimal string alignment);
 * where they are more than Most, any number above it. */
size_t GetEditDistance(const std::string& A, const std::string& B, size_t Most)
{
	if (std::max(A.size(), B.size()) - std::min(A.size(), B.size()) > Most) // so many are inserted at least
	{
		return Most + 1;
	}
	std::array<std::vector<size_t>, 3> Rows; // of the table: this one and the two before it
	Rows.fill(std::vector<size_t>(B.size() + 1));
	std::iota(Rows[0].begin(), Rows[0].end(), size_t(0));
	size_t LeastBefore = 0;
	for (size_t I = 1; I <= A.size(); ++I)
	{
		std::vector<size_t>& Row = Rows[I % 3];
		const std::vector<size_t>& Before = Rows[(I + 2) % 3];
		const std::vector<size_t>& BeforeThat = Rows[(I + 1) % 3];
		Row[0] = I;
		size_t Least = I;
		for (size_t J = 1; J <= B.size(); ++J)
		{
			Row[J] = std::min({Before[J] + 1, Row[J - 1] + 1, Before[J - 1] + (A[I - 1] == B[J - 1] ? 0 : 1)});
			if (I > 1 && J > 1 && A[I - 1] == B[J - 2] && A[I - 2] == B[J - 1])
			{
				Row[J] = std::min(Row[J], BeforeThat[J - 2] + 1);
			}
			Least = std::min(Least, Row[J]);
		}
		if (Least > Most && LeastBefore >= Most)
		{
			return Most + 1; // no way leads back down
		}
		LeastBefore = Least;
	}
	return Rows[A.size() % 3][B.size()];
}

} // namespace

std::string FDiagnostic::ToString() const
{
	std::string Text;
	if (!File.empty())
	{
		Text += MakePrintable(File, false) + ":";
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
	const std::string Said = MakePrintable(Message);
	// A line of a shader reads as every shader compiler writes it, so that editors and scripts find it.
	if (Code >= 6000 && Code < 7000 && Line > 0 && Where.empty())
	{
		const size_t Sentence = std::min(Said.find('\n'), Said.size()); // lines of source may follow
		return Text + ": " + Said.substr(0, Sentence) + " [DD" + std::to_string(Code) + "]" + Said.substr(Sentence);
	}
	if (Code > 0)
	{
		Text += " DD" + std::to_string(Code);
	}
	if (!Where.empty())
	{
		Text += " at " + MakePrintable(Where, false);
	}
	return Text + ": " + Said;
}

std::string FindNearestName(const std::string& Name, const std::vector<std::string>& Candidates)
{
	std::string Nearest;
	if (Name.size() > MaxNameLength)
	{
		return Nearest;
	}
	const std::string LowerName = ToLowerCase(Name);
	size_t Nearer = MaxNameLength; // than this
	for (const std::string& Candidate : Candidates)
	{
		const size_t Farthest = std::min(GetFarthest(std::max(Name.size(), Candidate.size())), Nearer - 1);
		const size_t Distance = GetEditDistance(LowerName, ToLowerCase(Candidate), Farthest);
		if (Distance <= Farthest)
		{
			Nearest = Candidate;
			Nearer = Distance;
		}
		if (Nearer == 0)
		{
			break;
		}
	}
	return Nearest;
}

std::string SuggestName(const std::string& Name, const std::vector<std::string>& Candidates)
{
	const std::string Nearest = FindNearestName(Name, Candidates);
	return Nearest.empty() ? "" : "; did you mean " + Nearest + "?";
}

} // namespace Drydock
