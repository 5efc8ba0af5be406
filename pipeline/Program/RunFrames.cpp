// Runs a sequence of frames for `drydock run`, shows how far it is, and sums up what was done.
#include "Program/RunFrames.h"

#include "Config/ReadConfig.h"
#include "Program/ProgramOutput.h"
#include "Program/ProgressBar.h"
#include "Program/ReportOption.h"
#include "Program/VerbOptions.h"
#include "Report/ReportPage.h"
#include "Report/SequencePage.h"
#include "Report/WalkData.h"
#include "Sequence/RunSequence.h"
#include "Sequence/SequenceErrors.h"
#include "Sequence/Video.h"
#include "Text/Fmt.inl"

#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <optional>
#include <set>

namespace Drydock
{

namespace
{

/** The bar, and the rate of the frames of this run: those that were there already took no time. */
class FSequenceProgress
{
public:
	void Show(int Done, int Total, const std::string& What)
	{
		if (!FirstDone)
		{
			FirstDone = Done;
			Begin = std::chrono::steady_clock::now();
		}
		const double Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - Begin).count();
		const std::string Rate = DescribeRate(Done - *FirstDone, Total - Done, Seconds);
		Bar.Show(Done, Total, Rate + (Rate.empty() ? "" : ", ") + What);
	}
	void Clear() { Bar.Clear(); }

private:
	FProgressBar Bar;
	std::optional<int> FirstDone;
	std::chrono::steady_clock::time_point Begin;
};

std::string MakeSequenceSummary(const FSequenceResult& Result, const std::string& ConfigFile, const std::string& Folder)
{
	const int NumThere = static_cast<int>(Result.Frames.size()) - Result.NumRendered;
	const double Rate = Result.Seconds > 0.0 ? Result.NumRendered / Result.Seconds : 0.0;
	std::string Text = fmt::format("{}: frames {} to {}\n", ConfigFile, Result.Frames.front(), Result.Frames.back());
	const std::string Rendered =
		fmt::format("{} rendered in {:.1f} s, {:.2f} frames/s", Result.NumRendered, Result.Seconds, Rate);
	const std::string There = fmt::format("{} already existed", NumThere);
	Text += "frames   " + (Result.NumRendered == 0 ? There : Rendered + (NumThere > 0 ? ", " + There : "")) + "\n";
	if (Result.NumRepeated > 0)
	{
		Text += fmt::format(
			"history  {} of them computed again for their history, with the same result\n", Result.NumRepeated);
	}
	return Text + "folder   " + Folder + "\n";
}

/** They would be loaded once more to blend, and may keep a history. */
bool NamesPlugins(const std::string& ConfigFile)
{
	std::vector<FDiagnostic> Ignored; // the run reports them
	return !LoadConfig(ConfigFile, Ignored).Plugins.empty();
}

} // namespace

int RunFrames(const FFramesOptions& Options)
{
	FSequenceOptions Sequence;
	Sequence.Run = Options.Run;
	Sequence.Frames = Options.Frames;
	Sequence.Folder = ChooseOutputFolder(Options.OutputFolder, Options.Run);
	Sequence.bRestart = Options.bRestart;
	Sequence.Lead = Options.Lead;
	FSequenceProgress Progress;
	Sequence.Progress = [&](int Done, int Total, const std::string& What)
	{
		Progress.Show(Done, Total, What);
	};
	std::set<std::string> Reported; // every frame would say the same
	Sequence.Report = [&](const std::vector<FDiagnostic>& Diagnostics)
	{
		std::vector<FDiagnostic> New;
		for (const FDiagnostic& Diagnostic : Diagnostics)
		{
			if (Reported.insert(Diagnostic.ToString()).second)
			{
				New.push_back(Diagnostic);
			}
		}
		if (!New.empty())
		{
			Progress.Clear();
			PrintDiagnostics(New);
		}
	};
	const bool bPage = ChooseRunReport(Options.Report, Options.Run.ConfigFile, false) != EReport::Off;
	if (bPage)
	{
		FRunOptions WalkOptions = Options.Run;
		WalkOptions.Frame.reset();
		const bool bPlugins = !Options.Run.Plugins.empty() || NamesPlugins(Options.Run.ConfigFile);
		Sequence.MakePage = [&, Walk = bPlugins ? "" : MakeSceneWalkJson(WalkOptions)](const FSequenceResult& Result)
		{
			const std::string Name = std::filesystem::path(Options.Run.ConfigFile).stem().string();
			return MakeReportPage(MakeSequencePageData(Result, Name, Walk, FormatReportTime(std::time(nullptr))));
		};
	}
	const FSequenceResult Result = RunSequence(Sequence);
	Progress.Clear();
	if (!Options.Video.empty())
	{
		const std::string Problem = MakeVideo(Result.Pictures, Result.FramesPerSecond, Options.Video);
		if (!Problem.empty())
		{
			PrintDiagnostics({{ESeverity::Warning, WarnNoVideo, "there is no video: " + Problem, Options.Video}});
		}
	}
	PrintResult(
		Options.bJson ? Result.SequenceJson : MakeSequenceSummary(Result, Options.Run.ConfigFile, Sequence.Folder),
		Options.bJson);
	if (bPage && !Options.bJson)
	{
		PrintPage(std::filesystem::path(Sequence.Folder) / "sequence.html");
	}
	std::fflush(stdout);
	return ExitDone;
}

} // namespace Drydock
