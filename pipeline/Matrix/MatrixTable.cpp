// Formats a matrix as text.
#include "Matrix/MatrixTable.h"

#include "Matrix/MatrixGroups.h"
#include "Matrix/MatrixSummary.h"
#include "Matrix/MatrixVersions.h"
#include "Text/TextFormat.h"
#include "Text/TextTable.h"
#include "TextTools.h"

#include <regex>

namespace Drydock
{

namespace
{

const char* const Nothing = "-";

std::string FormatPlace(const FMatrixMessage& Message)
{
	return Message.File.empty() ? "no"
								: "no: " + Message.File.substr(Message.File.find_last_of('/') + 1) +
									  (Message.Line > 0 ? ":" + std::to_string(Message.Line) : "");
}

std::string FormatBuild(const FMatrixBuild& Build)
{
	return Build.bBuilt ? "yes" : FormatPlace(Build.FirstError.value_or(FMatrixMessage()));
}

std::string FormatCompilerWarnings(const FMatrixBuild& Build)
{
	const size_t Count = Build.Warnings.size();
	return Count == 0 ? Nothing : std::to_string(Count) + (Count == 1 ? " warning" : " warnings");
}

/** "DD2070 x2, DD2071" */
std::string FormatRunWarnings(const FMatrixRun& Run)
{
	std::vector<std::pair<int, int>> Counts;
	for (const FMatrixMessage& Warning : Run.Warnings)
	{
		if (Counts.empty() || Counts.back().first != Warning.Code)
		{
			Counts.emplace_back(Warning.Code, 0);
		}
		++Counts.back().second;
	}
	const std::string Text = JoinText(Counts, ", ",
		[](const auto& Each)
		{ return FormatCode(Each.first) + (Each.second > 1 ? " x" + std::to_string(Each.second) : ""); });
	return Text.empty() ? Nothing : Text;
}

std::string FormatPicture(const FMatrixPicture& Picture)
{
	if (!Picture.Before)
	{
		constexpr size_t ShownDigits = 8;
		return Picture.Fingerprint.substr(0, ShownDigits);
	}
	if (!Picture.Difference)
	{
		return "same as " + DescribeVersion(*Picture.Before);
	}
	const std::string Again = Picture.SameAs ? "; same as " + DescribeVersion(*Picture.SameAs) : "";
	if (Picture.Difference->bOtherSize)
	{
		return "another size" + Again;
	}
	char Figures[128];
	std::snprintf(Figures, sizeof(Figures), "off by %.3g at %llu %s, first (%d, %d)", Picture.Difference->Max,
		static_cast<unsigned long long>(Picture.Difference->NumPixels),
		Picture.Difference->NumPixels == 1 ? "pixel" : "pixels", Picture.Difference->X, Picture.Difference->Y);
	return Figures + Again;
}

std::vector<std::string> FormatRow(const FMatrixRow& Row)
{
	return {DescribeVersion(Row.Minor), FormatBuild(Row.Build), FormatInEngine(Row.Build),
		FormatCompilerWarnings(Row.Build),
		!Row.Run         ? Nothing
		: Row.Run->Ran() ? "yes"
						 : DescribeEnd(*Row.Run),
		Row.Run ? FormatRunWarnings(*Row.Run) : Nothing, Row.Picture ? FormatPicture(*Row.Picture) : Nothing,
		Row.FirstDifference ? Row.FirstDifference->Pass + " " + Row.FirstDifference->What : Nothing};
}

/** A message without the name of the version that it was said under, so that it is one message under all of them. */
std::string RemoveVersion(std::string Text, int Minor)
{
	const std::string Named = "engine " + DescribeVersion(Minor);
	for (size_t At = Text.find(Named); At != std::string::npos; At = Text.find(Named, At))
	{
		Text.replace(At, Named.size(), "that engine");
	}
	return Text;
}

/** All that was said, each text with the versions it was said under. */
FVersionGroups CollectTexts(const FVersionMatrix& Matrix)
{
	FVersionGroups Texts;
	for (const FMatrixRow& Row : Matrix.Rows)
	{
		for (const std::string& Note : Row.Build.Notes)
		{
			Texts.Add(Note, Row.Minor);
		}
		for (const std::string& Message : Row.Build.InEngine)
		{
			Texts.Add(RemoveVersion(Message, Row.Minor), Row.Minor);
		}
		if (Row.Build.FirstError)
		{
			Texts.Add(DescribeMessage(*Row.Build.FirstError), Row.Minor);
		}
		if (!Row.Build.Warnings.empty())
		{
			const size_t More = Row.Build.Warnings.size() - 1;
			Texts.Add("the compiler warns: " + DescribeMessage(Row.Build.Warnings[0]) +
						  (More > 0 ? " (and " + std::to_string(More) + " more)" : ""),
				Row.Minor);
		}
		if (Row.Run && Row.Run->FirstError)
		{
			Texts.Add(DescribeMessage(*Row.Run->FirstError), Row.Minor);
		}
		for (const FMatrixMessage& Warning : Row.Run ? Row.Run->Warnings : std::vector<FMatrixMessage>())
		{
			Texts.Add(RemoveVersion(DescribeMessage(Warning), Row.Minor), Row.Minor);
		}
	}
	return Texts;
}

} // namespace

std::string FormatInEngine(const FMatrixBuild& Build)
{
	std::string Text = Build.bBuilt ? "yes" : Nothing;
	for (const std::string& Message : Build.InEngine)
	{
		static const std::regex Parts(" (does not have|deprecates) (.*?)(?:, which|: use)");
		std::smatch Match;
		std::regex_search(Message, Match, Parts);
		const bool bLacks = Match[1] == "does not have";
		if (bLacks && !Message.ends_with("(uncertain)"))
		{
			return "no: " + Match[2].str();
		}
		Text = &Message == &Build.InEngine[0] ? (bLacks ? "uncertain: " : "deprecated: ") + Match[2].str() : Text;
	}
	return Text;
}

std::string FormatMatrix(const FVersionMatrix& Matrix, int Width)
{
	std::vector<int> Minors;
	std::vector<std::vector<std::string>> Rows = {
		{"engine", "builds", "in the engine", "compiler", "runs", "warnings", "picture", "first difference"}};
	for (const FMatrixRow& Row : Matrix.Rows)
	{
		Minors.push_back(Row.Minor);
		Rows.push_back(FormatRow(Row));
	}
	std::string Text = Matrix.Name + " under engine " + DescribeVersions(Minors) + ", on " +
					   (Matrix.bStockConfig ? "drydock's own small frame" : Matrix.Config) + "\n\n";
	Text += FTextTable{std::vector<FTextColumn>(Rows[0].size()), Rows}.Format(Width);
	const FVersionGroups Texts = CollectTexts(Matrix);
	Text += Texts.Get().empty() ? "" : "\n";
	for (const FVersionGroup& Said : Texts.Get())
	{
		Text += DescribeVersions(Said.Minors) + ": " + Said.Text + "\n";
	}
	Text += "\n" + SummarizeMatrix(Matrix) + "\n";
	for (const std::string& Advice : AdviseOnMatrix(Matrix))
	{
		Text += "  " + Advice + "\n";
	}
	return Text;
}

std::vector<FJUnitCase> MakeMatrixCases(const FVersionMatrix& Matrix)
{
	std::vector<FJUnitCase> Cases;
	const auto Add = [&Cases](const std::string& Name, bool bAsked, bool bHolds, const std::string& Message)
	{
		Cases.push_back({.Name = Name,
			.Outcome = !bAsked  ? EJUnitOutcome::Skipped
					   : bHolds ? EJUnitOutcome::Passed
								: EJUnitOutcome::Failed,
			.Message = bAsked && bHolds ? "" : Message,
			.Rule = "version"});
	};
	const auto Describe = [](const std::optional<FMatrixMessage>& Error, const std::string& Otherwise)
	{
		return Error ? DescribeMessage(*Error) : Otherwise;
	};
	for (const FMatrixRow& Row : Matrix.Rows)
	{
		const std::string Version = DescribeVersion(Row.Minor);
		Add(Version + " builds", true, Row.Build.bBuilt, Describe(Row.Build.FirstError, "does not compile"));
		const bool bRan = Row.Run && Row.Run->Ran();
		Add(Version + " runs", Row.Run.has_value(), bRan,
			!Row.Run ? "was not built" : DescribeEnd(*Row.Run) + "\n" + Describe(Row.Run->FirstError, ""));
		Add(Version + " picture", Row.Picture.has_value(), true, "did not run");
		if (Row.Picture)
		{
			const std::string First =
				Row.FirstDifference ? "; first in " + Row.FirstDifference->Pass + " " + Row.FirstDifference->What : "";
			Cases.back().Output = FormatPicture(*Row.Picture) + First;
		}
	}
	return Cases;
}

} // namespace Drydock
