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
#include <malloc.h>

namespace Drydock
{

namespace
{

/** Ends a run when a change of the state waits. */
class FGiveWay final : public IDispatchObserver
{
public:
	explicit FGiveWay(const FLiveSession& InSession)
		: Session(InSession)
	{
	}

	void BeforeDispatch(const FBoundShader&, const FKernelArgs&, const FKernelTile&) override
	{
		if (Session.NumChanges > 0)
		{
			throw FError({.Code = ErrorBadEdit, .Message = "the state changed before its price was known"}, ExitUsage);
		}
	}

private:
	const FLiveSession& Session;
};

/** A run beside the frame's, which computes every pass. Its memory is the system's again when it ends: frames do not
 * need so much. */
struct FOwnRun : FNoncopyable
{
	explicit FOwnRun(FLiveSession& Session)
	{
		Session.EndRun();
		Options = Session.MakeOptions();
		Options.ReuseCache = nullptr;
	}

	~FOwnRun() { malloc_trim(0); }

	FRunOptions Options;
};

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

int ReadAskedNumber(const FJsonValue& Asked, const std::string& Name)
{
	const std::string Text = Asked.GetString(Name);
	if (const std::optional<int> Number = ParseAll<int>(Text))
	{
		return *Number;
	}
	throw FError({.Code = ErrorBadEdit, .Message = "'" + Text + "' is not a whole number", .Where = Name}, ExitUsage);
}

FPicture ReadPassPicture(FLiveSession& Session, const FJsonValue& Asked)
{
	const int Pass = ReadAskedNumber(Asked, "pass");
	const std::string Resource = Asked.GetString("resource");
	FOwnRun Own(Session);
	FRunOptions& Options = Own.Options;
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

std::string MakeLiveReport(FLiveSession& Session, const FJsonValue&)
{
	FOwnRun Own(Session);
	FRunOptions& Options = Own.Options;
	Options.bKeepForReport = true;
	const FRunResult Result = RunConfig(Options);
	return MakeRunReportData(Options, Result);
}

std::string MakeLedgerJson(FLiveSession& Session, const FJsonValue& Asked)
{
	const std::vector<size_t> Fields = FindSettings({Asked.GetString("setting")});
	const FOwnRun Own(Session);
	const FRunSetup Setup(Own.Options);
	return MakeBlendJson(MakeBlendReport(Setup, "view", Setup.Config.Plugins.empty()), Fields);
}

std::string ProbeLive(FLiveSession& Session, const FJsonValue& Asked)
{
	const std::string Pass = Asked.GetString("pass");
	FProbeRequest Request;
	Request.X = ReadAskedNumber(Asked, "x");
	Request.Y = ReadAskedNumber(Asked, "y");
	Request.Passes = Pass.empty() ? "*" : Pass;
	const FOwnRun Own(Session);
	const FProbedRun Probed = ProbeRun(Own.Options, Request);
	return MakeAnswer(MakeProbeText(Probed.Passes, {}, Request), MakeProbeJson(Probed.Passes, {}, Request));
}

std::string TraceLive(FLiveSession& Session, const FJsonValue& Asked)
{
	FTraceRequest Request;
	Request.Pass = Asked.GetString("pass");
	Request.At = {ReadAskedNumber(Asked, "x"), ReadAskedNumber(Asked, "y"), 0};
	const FOwnRun Own(Session);
	FTraceCapture Capture(Request);
	{
		const FScopedDispatchObserver Scope(Capture);
		RunConfig(Own.Options);
	}
	std::string Text;
	for (const FCapturedTrace& Captured : Capture.GetTraces())
	{
		Text += (Text.empty() ? "" : "\n") + MakeTraceText(Captured, Request);
	}
	return MakeAnswer(Text, MakeTraceJson(Capture.GetTraces(), Request));
}

std::string MeasurePrice(FLiveSession& Session, const FJsonValue&)
{
	constexpr int NumRuns = 5;
	const FStudy Study = FindStudy(Session);
	const FOwnRun Own(Session);
	const std::unique_ptr<IStudySubject> Subject = MakeFrameSubject(Own.Options, Study);
	FGiveWay GiveWay(Session);
	const FScopedDispatchObserver Scope(GiveWay);
	FMeasured Measured = Subject->Run({}); // warms up
	std::vector<double> Times;
	for (int Run = 0; Run < NumRuns; ++Run)
	{
		Times.push_back(Subject->Run({}).Milliseconds);
	}
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
