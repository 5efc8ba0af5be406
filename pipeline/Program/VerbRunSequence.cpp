// `drydock run` of a sequence of frames. Source: drydock.
#include "Budget/RunOptions.h"
#include "Program/ProgressBar.h"
#include "Program/Verbs.h"
#include "Run/RunOutputs.h"
#include "Sequence/RunSequence.h"
#include "Sequence/SequenceErrors.h"
#include "Sequence/Video.h"

#include <chrono>
#include <cstdio>
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

std::string MakeSummary(const FSequenceResult& Result, const std::string& ConfigFile, const std::string& Folder)
{
	const int NumThere = static_cast<int>(Result.Frames.size()) - Result.NumRendered;
	char Time[64];
	std::snprintf(Time, sizeof(Time), "%.1f s, %.2f frames/s", Result.Seconds,
		Result.Seconds > 0.0 ? Result.NumRendered / Result.Seconds : 0.0);
	std::string Text = ConfigFile + ": frames " + std::to_string(Result.Frames.front()) + " to " +
					   std::to_string(Result.Frames.back()) + "\n";
	const std::string Rendered = std::to_string(Result.NumRendered) + " rendered in " + Time;
	const std::string There = std::to_string(NumThere) + " were there already";
	Text += "frames   " + (Result.NumRendered == 0 ? There : Rendered + (NumThere > 0 ? ", " + There : "")) + "\n";
	if (Result.NumRepeated > 0)
	{
		Text += "history  " + std::to_string(Result.NumRepeated) +
				" of them computed again for what plugins remember of them; they are what they were\n";
	}
	return Text + "folder   " + Folder + "\n";
}

} // namespace

int RunSequenceVerb(const FVerbOptions& Options)
{
	FSequenceOptions Sequence;
	Sequence.Run = Options.Run;
	Sequence.Frames = Options.Frames;
	Sequence.Folder =
		Options.OutputFolder.empty() ? GetDefaultOutputFolder(Options.Run.ConfigFile) : Options.OutputFolder;
	Sequence.bRestart = Options.bRestart;
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
	std::fputs(
		(Options.bJson ? Result.SequenceJson : MakeSummary(Result, Options.Run.ConfigFile, Sequence.Folder)).c_str(),
		stdout);
	std::fflush(stdout);
	return ExitDone;
}

} // namespace Drydock
