// Puts versions with the same outcome together and describes them.
#include "Matrix/MatrixSummary.h"

#include "Diagnostics.h"
#include "Matrix/MatrixGroups.h"
#include "Matrix/MatrixVersions.h"
#include "Text/TextFormat.h"

#include <algorithm>

namespace Drydock
{

namespace
{

/** Numbers of the messages that end a run by a plugin's fault, and what became of it then. */
const char* GetVerb(int Code)
{
	constexpr int Crash = 2086;
	constexpr int Throw = 2087;
	constexpr int Hang = 2089;
	return Code == Crash ? "crashes: " : Code == Throw ? "throws: " : Code == Hang ? "hangs: " : nullptr;
}

/** "SetupView of extension FTint" of "plugin libTint.so, SetupView of extension FTint". */
std::string DropPlugin(const std::string& Where)
{
	const size_t Comma = Where.find(", ");
	return Where.starts_with("plugin ") && Comma != std::string::npos ? Where.substr(Comma + 2) : Where;
}

/** Describes why a row failed; empty: it succeeded. */
std::string DescribeFailure(const FMatrixRow& Row)
{
	if (!Row.Build.bBuilt)
	{
		const FMatrixMessage Error = Row.Build.FirstError.value_or(FMatrixMessage());
		const std::string Place = Error.Line > 0 ? Error.File + ":" + std::to_string(Error.Line) : Error.File;
		return "does not compile, " + Error.Text + (Place.empty() ? "" : " (" + Place + ")");
	}
	if (Row.Run && !Row.Run->Ran())
	{
		const FMatrixMessage Error = Row.Run->FirstError.value_or(FMatrixMessage());
		return GetVerb(Error.Code) != nullptr ? DescribeEnd(*Row.Run) : "does not run, " + DescribeMessage(Error);
	}
	return "";
}

FVersionGroups GroupFailures(const FVersionMatrix& Matrix)
{
	FVersionGroups Failures;
	for (const FMatrixRow& Row : Matrix.Rows)
	{
		const std::string Failure = DescribeFailure(Row);
		if (!Failure.empty())
		{
			Failures.Add(Failure, Row.Minor);
		}
	}
	return Failures;
}

/** "Builds, runs and draws the same under ...", and where a picture parts from the one before. */
std::string DescribeSuccesses(const FVersionMatrix& Matrix)
{
	std::vector<int> Succeeded;
	std::vector<int> All;
	FVersionGroups Pictures;
	for (const FMatrixRow& Row : Matrix.Rows)
	{
		All.push_back(Row.Minor);
		if (Row.Succeeded())
		{
			Succeeded.push_back(Row.Minor);
			Pictures.Add(Row.Picture ? Row.Picture->Fingerprint : "", Row.Minor);
		}
	}
	if (Succeeded.empty())
	{
		return All.size() == 1 ? "Fails under " + DescribeVersions(All)
							   : "Fails under each of " + DescribeVersions(All);
	}
	if (Pictures.Get().size() == 1)
	{
		return (Succeeded.size() == 1 ? "Builds and runs under " : "Builds, runs and draws the same under ") +
			   DescribeVersions(Succeeded);
	}
	std::string Text = "Builds and runs under " + DescribeVersions(Succeeded) + ", and draws " +
					   std::to_string(Pictures.Get().size()) + " pictures: ";
	for (const FVersionGroup& Picture : Pictures.Get())
	{
		Text +=
			(&Picture == Pictures.Get().data() ? "one under " : "; another under ") + DescribeVersions(Picture.Minors);
	}
	for (const FMatrixRow& Row : Matrix.Rows)
	{
		if (Row.Picture && Row.Picture->Difference && Row.Picture->Before && Row.FirstDifference)
		{
			Text += "; " + DescribeVersion(Row.Minor) + " parts from " + DescribeVersion(*Row.Picture->Before) +
					" at pass " + Row.FirstDifference->Pass + ", which " + Row.FirstDifference->What;
		}
	}
	return Text;
}

/** How to write code for versions of which some do not take it; empty where no single version parts them. */
std::string AdviseGuard(const FVersionMatrix& Matrix)
{
	std::vector<int> Built;
	std::vector<int> Broken;
	for (const FMatrixRow& Row : Matrix.Rows)
	{
		(Row.Build.bBuilt ? Built : Broken).push_back(Row.Minor);
	}
	if (Built.empty() || Broken.empty())
	{
		return "";
	}
	if (Broken.back() < Built.front())
	{
		return "what " + DescribeVersions(Broken) + (Broken.size() > 1 ? " do" : " does") +
			   " not have goes between #if !UE_VERSION_OLDER_THAN(5, " + std::to_string(Built.front()) +
			   ", 0) and #endif (Misc/EngineVersionComparison.h)";
	}
	if (Built.back() < Broken.front())
	{
		return "what " + DescribeVersions(Broken) + (Broken.size() > 1 ? " have" : " has") +
			   " no more goes between #if UE_VERSION_OLDER_THAN(5, " + std::to_string(Broken.front()) +
			   ", 0) and #endif (Misc/EngineVersionComparison.h)";
	}
	return "";
}

} // namespace

std::string DescribeMessage(const FMatrixMessage& Message)
{
	std::string Text = Message.File;
	Text += Message.Line > 0 ? ":" + std::to_string(Message.Line) : "";
	Text += Text.empty() ? "" : ": ";
	if (Message.Code > 0)
	{
		Text += FormatCode(Message.Code) + (Message.Where.empty() ? "" : " at " + Message.Where) + ": ";
	}
	return Text + Message.Text;
}

std::string DescribeEnd(const FMatrixRun& Run)
{
	const FMatrixMessage Error = Run.FirstError.value_or(FMatrixMessage());
	if (const char* const Verb = GetVerb(Error.Code))
	{
		return Verb + DropPlugin(Error.Where);
	}
	constexpr int FirstSignal = 128;
	const std::string End = Run.ExitCode > FirstSignal ? "signal " + std::to_string(Run.ExitCode - FirstSignal)
													   : "exit " + std::to_string(Run.ExitCode);
	return End + (Error.Code > 0 ? ", " + FormatCode(Error.Code) : "");
}

std::string SummarizeMatrix(const FVersionMatrix& Matrix)
{
	std::string Text = DescribeSuccesses(Matrix);
	const FVersionGroups Failures = GroupFailures(Matrix);
	for (const FVersionGroup& Failure : Failures.Get())
	{
		Text += "; " + DescribeVersions(Failure.Minors) + ": " + Failure.Text;
	}
	return Text + ".";
}

std::vector<std::string> AdviseOnMatrix(const FVersionMatrix& Matrix)
{
	std::vector<std::string> Advice;
	const std::string Guard = AdviseGuard(Matrix);
	if (!Guard.empty())
	{
		Advice.push_back(Guard);
	}
	const auto Failed = std::find_if(
		Matrix.Rows.begin(), Matrix.Rows.end(), [](const FMatrixRow& Row) { return Row.Run && !Row.Run->Ran(); });
	if (Failed != Matrix.Rows.end())
	{
		Advice.push_back("once more by itself: drydock run " + Matrix.Config + " --engine " +
						 DescribeVersion(Failed->Minor) + " --plugin " + Failed->Build.Library);
	}
	const auto TakesNoPart = [](const FMatrixRow& Row)
	{
		return Row.Succeeded() && Row.Run->Extensions.empty();
	};
	if (std::any_of(Matrix.Rows.begin(), Matrix.Rows.end(), TakesNoPart))
	{
		std::vector<int> Idle;
		for (const FMatrixRow& Row : Matrix.Rows)
		{
			if (TakesNoPart(Row))
			{
				Idle.push_back(Row.Minor);
			}
		}
		Advice.push_back("no extension took part in the frame under " + DescribeVersions(Idle) +
						 ", so the picture says nothing of the plugin: name a config that switches it on");
	}
	return Advice;
}

int GetMatrixExitCode(const FVersionMatrix& Matrix)
{
	int ExitCode = ExitDone;
	for (const FMatrixRow& Row : Matrix.Rows)
	{
		if (Row.Succeeded())
		{
			continue;
		}
		const bool bFiles = Row.Run && Row.Run->ExitCode == ExitFiles;
		ExitCode = bFiles && ExitCode != ExitUsage ? ExitFiles : ExitUsage;
	}
	return ExitCode;
}

} // namespace Drydock
