// Runs the state once more, with what looks into it.
#include "Live/LiveInspect.h"

#include "Blend/MakeBlendReport.h"
#include "DispatchObserver.h"
#include "Inspect/ProbeRun.h"
#include "Inspect/TraceCapture.h"
#include "Live/LiveErrors.h"
#include "Live/LiveSession.h"
#include "Report/RunReport.h"
#include "Run/RunSetup.h"
#include "Study/StudySubject.h"
#include "Text/JsonWriter.h"
#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

namespace
{

/** For a run beside the frame's, which computes every pass. */
FRunOptions BeginOwnRun(FLiveSession& Session)
{
	Session.EndRun();
	FRunOptions Options = Session.MakeOptions();
	Options.ReuseCache = nullptr;
	return Options;
}

std::string MakeAnswer(const std::string& Text, const std::string& Json)
{
	FJsonWriter Writer('{');
	Writer.Member("text", Text);
	Writer.Key("json").Raw(Trim(Json));
	return Writer.GetText();
}

/** The changes since the start, at most a few: "BloomIntensity 2, r.BloomQuality 3". */
std::string DescribeDifference(const FEditHistory& History)
{
	constexpr size_t Most = 3;
	const std::vector<FConfigEdit> Changes = FindChanges(History.GetStart(), History.GetText());
	std::string Label;
	for (size_t Index = 0; Index < std::min(Changes.size(), Most); ++Index)
	{
		const FConfigEdit& Change = Changes[Index];
		const std::string Name = SplitPointer(Change.Pointer).back();
		Label += (Label.empty() ? "" : ", ") + (Change.Value ? Name + " " + *Change.Value : "no " + Name);
	}
	return Changes.empty()         ? "start"
		   : Changes.size() > Most ? Label + " and " + std::to_string(Changes.size() - Most) + " more"
								   : Label;
}

/** The study of a config, else one whose exact frame is in double. */
FStudy FindStudy(FLiveSession& Session)
{
	std::vector<FDiagnostic> Ignored; // the run has told
	FStudy Study = ReadStudy(Session.BeginRun(), Ignored).value_or(FStudy());
	if (Study.bBlur || Study.Reference.empty())
	{
		Study = FStudy();
		Study.Reference = {{"precision", "double", {}}, {"storage", "float64", {}}};
	}
	if (Study.Metrics.empty())
	{
		Study.Metrics = {"rms"};
	}
	return Study;
}

} // namespace

FPicture ReadPassPicture(FLiveSession& Session, int Pass, const std::string& Resource)
{
	FRunOptions Options = BeginOwnRun(Session);
	Options.Dump = {Resource};
	const FRunResult Result = RunConfig(Options);
	for (const FRunDump& Dump : Result.Dumps)
	{
		if (Dump.PassIndex == Pass && Dump.Resource == Resource)
		{
			return Dump.Image;
		}
	}
	throw FError({.Code = ErrorBadEdit,
					 .Message = "pass " + std::to_string(Pass) + " writes no " + Resource,
					 .Where = "resource"},
		ExitUsage);
}

std::string MakeLiveReport(FLiveSession& Session)
{
	FRunOptions Options = BeginOwnRun(Session);
	Options.bKeepForReport = true;
	const FRunResult Result = RunConfig(Options);
	return MakeRunReportData(Options, Result);
}

std::string MakeLedgerJson(FLiveSession& Session, const std::string& Setting)
{
	const std::vector<size_t> Fields = FindSettings({Setting});
	const FRunSetup Setup(BeginOwnRun(Session));
	return MakeBlendJson(MakeBlendReport(Setup, "view", Setup.Config.Plugins.empty()), Fields);
}

std::string ProbeLive(FLiveSession& Session, int X, int Y, const std::string& Pass)
{
	FProbeRequest Request;
	Request.X = X;
	Request.Y = Y;
	Request.Passes = Pass.empty() ? "*" : Pass;
	const FProbedRun Probed = ProbeRun(BeginOwnRun(Session), Request);
	return MakeAnswer(MakeProbeText(Probed.Passes, {}, Request), MakeProbeJson(Probed.Passes, {}, Request));
}

std::string TraceLive(FLiveSession& Session, int X, int Y, const std::string& Pass)
{
	FTraceRequest Request;
	Request.Pass = Pass;
	Request.At = {X, Y, 0};
	FTraceCapture Capture(Request);
	{
		const FScopedDispatchObserver Scope(Capture);
		RunConfig(BeginOwnRun(Session));
	}
	std::string Text;
	for (const FCapturedTrace& Captured : Capture.GetTraces())
	{
		Text += (Text.empty() ? "" : "\n") + MakeTraceText(Captured, Request);
	}
	return MakeAnswer(Text, MakeTraceJson(Capture.GetTraces(), Request));
}

std::string MeasurePrice(FLiveSession& Session, const std::function<bool()>& IsLate)
{
	constexpr int NumRuns = 5;
	const auto CheckTime = [&]
	{
		if (IsLate())
		{
			throw FError({.Code = ErrorBadEdit, .Message = "the state changed before its price was known"}, ExitUsage);
		}
	};
	const FStudy Study = FindStudy(Session);
	const std::unique_ptr<IStudySubject> Subject = MakeFrameSubject(BeginOwnRun(Session), Study);
	FMeasured Measured = Subject->Run({}); // warms up
	std::vector<double> Times;
	for (int Run = 0; Run < NumRuns; ++Run)
	{
		CheckTime();
		Times.push_back(Subject->Run({}).Milliseconds);
	}
	CheckTime();
	std::ranges::sort(Times);
	const FMeasured Exact = Subject->RunReference({});
	FLiveDot Dot{
		.Revision = Session.GetHistory().GetRevision(), .Milliseconds = Times[NumRuns / 2], .Metric = Study.Metrics[0]};
	Dot.Error = GetMetric(CompareImages(Measured.Image, Exact.Image, {.Encoding = Measured.Encoding}), Dot.Metric);
	Dot.Label = DescribeDifference(Session.GetHistory());
	FJsonWriter Writer;
	Writer.Object({{"milliseconds", Dot.Milliseconds}, {"error", Dot.Error}, {"metric", Dot.Metric},
		{"label", Dot.Label}, {"revision", Dot.Revision}});
	Session.AddDot(std::move(Dot));
	return Writer.GetText();
}

} // namespace Drydock
