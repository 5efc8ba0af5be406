// Renders the frames of a task, or calls a study or the hazards, and writes down figures.
#include "Sweep/SweepRun.h"

#include "Hazards/HazardCapture.h"
#include "Picture/Preview.h"
#include "RangeTools.h"
#include "RenderGraphBuilder.h"
#include "Run/Run.h"
#include "Run/RunOutputs.h"
#include "SceneFile/SceneCache.h"
#include "Study/StudyReport.h"
#include "Study/StudyRun.h"
#include "Text/AsideFile.h"
#include "Text/Fingerprint.h"
#include "Text/Fmt.inl"
#include "Text/JsonWriter.h"
#include "Text/TextFile.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

using FSweepFigures = std::map<std::string, double>;

/** A frame of a result. */
struct FSweepFrame
{
	std::optional<int> Number;
	std::string File;
	std::string Picture; // fingerprint of its numbers
	FSweepFigures Figures;
};

/** Fills in the picture's fingerprint, its mean brightness as displayed, and how many pixels are not finite. */
void MeasureFinal(const FPicture& Picture, FSweepFrame& Frame)
{
	FFingerprint Fingerprint;
	const size_t NumChannels = size_t(Picture.NumChannels);
	std::vector<float> Row(size_t(Picture.Width) * NumChannels);
	double Sum = 0.0, NumNonFinite = 0.0;
	for (int Y = 0; Y < Picture.Height; ++Y)
	{
		Picture.ReadRow(Y, Row.data());
		Fingerprint.Add(Row.data(), Row.size() * sizeof(float));
		for (size_t At = 0; At < Row.size(); At += NumChannels)
		{
			const double Luma = 0.2126 * Row[At] + 0.7152 * Row[At + 1] + 0.0722 * Row[At + 2];
			(std::isfinite(Luma) ? Sum : NumNonFinite) += std::isfinite(Luma) ? Luma : 1.0;
		}
	}
	Frame.Picture = Fingerprint.Get();
	Frame.Figures = {
		{"brightness", Sum / std::max(1.0, double(Picture.Width) * Picture.Height)}, {"nonFinite", NumNonFinite}};
}

FSweepFrame MeasureFrame(const FRunResult& Result, std::optional<int> Number)
{
	FSweepFrame Frame{Number, Number ? fmt::format("{:04}", *Number) : "final", "", {}};
	MeasureFinal(Result.Final, Frame);
	Frame.Figures["exposure"] = Result.ExposureScale;
	for (const auto& [Effect, Figures] : Result.Figures)
	{
		for (const FFigureGroup& Group : Figures.Groups)
		{
			for (const FFigure& Figure : Group.Figures)
			{
				Frame.Figures[Group.Name + "." + Figure.Name] = Figures.Get(Group.Name, Figure.Name);
			}
		}
	}
	std::erase_if(Frame.Figures, [](const auto& One) { return !std::isfinite(One.second); });
	return Frame;
}

/** The mean of each figure over the frames that have it. */
FSweepFigures GetMeans(const std::vector<FSweepFrame>& Frames)
{
	std::map<std::string, std::pair<double, double>> Sums; // and counts
	for (const FSweepFrame& Frame : Frames)
	{
		for (const auto& [Name, Value] : Frame.Figures)
		{
			Sums[Name].first += Value;
			Sums[Name].second += 1.0;
		}
	}
	FSweepFigures Means;
	for (const auto& [Name, Sum] : Sums)
	{
		Means[Name] = Sum.first / Sum.second;
	}
	return Means;
}

/** result.json. Messages come once, though each frame has them. */
void WriteResult(const Files::path& Folder, const FSweepTask& Task, const FSweepFigures& Figures,
	const std::vector<FSweepFrame>& Frames, const std::vector<FDiagnostic>& Messages)
{
	FJsonWriter Writer('{');
	const auto WriteMember = [&](const auto& One)
	{
		Writer.Member(One.first, One.second);
	};
	Writer.Member("task", Task.Hash);
	Writer.Object("set", Task.Set, WriteMember);
	Writer.Object("figures", Figures, WriteMember);
	Writer.Objects("frames", Frames,
		[&](const FSweepFrame& Frame)
		{
			Writer.Members({{"frame", Frame.Number}, {"file", Frame.File + ".png"}, {"picture", Frame.Picture}});
			Writer.Object("figures", Frame.Figures, WriteMember);
		});
	std::vector<std::string> Texts;
	std::ranges::for_each(Messages, [&](const FDiagnostic& Message) { AddUnique(Texts, Message.ToString()); });
	Writer.Member("messages", Texts);
	WriteWholeFile(Folder / "result.json", Writer.GetText());
}

} // namespace

FSweepRunner::FSweepRunner(const FSweepPlan& InPlan, std::optional<int> InThreads)
	: Plan(InPlan)
	, Threads(InThreads)
	, SceneCache(std::make_shared<FSceneCache>())
{
}

FSweepRunner::~FSweepRunner() = default;

FRunOptions FSweepRunner::MakeOptions(const FSweepTask& Task) const
{
	FRunOptions Options = MakeTaskOptions(Plan, Task.Set);
	Options.Threads = Threads;
	Options.SceneCache = SceneCache;
	return Options;
}

FRunSession& FSweepRunner::Begin(const FSweepTask& Task)
{
	FSweepSet Set = Task.Set;
	std::erase_if(Set, [](const auto& One) { return One.first == "frames"; });
	// Plugins may keep a history of their own.
	if (!Session || Set != SessionSet || !Session->GetConfig().Plugins.empty() ||
		!Session->GetConfig().Overlays.empty())
	{
		Session.reset(); // one at a time
		FRunOptions Options = MakeOptions(Task);
		const std::vector<int> Frames = ListTaskFrames(Task.Frames);
		Options.Frame = Frames.empty() ? std::nullopt : std::optional(Frames[0]);
		Session = std::make_unique<FRunSession>(Options);
		SessionSet = Set;
	}
	return *Session;
}

void FSweepRunner::RunFrames(const FSweepTask& Task, const Files::path& Folder, bool bFirstAlone)
{
	FRunSession& Run = Begin(Task);
	std::vector<FViewHistory> History;
	std::vector<FDiagnostic> Messages;
	std::vector<FSweepFrame> Frames;
	const auto Render = [&](std::optional<int> Number, bool bWrite)
	{
		const FRunResult Result = Run.Run(Number, History);
		History = Result.ViewStates;
		FRDGBuilder::TickPoolElements();
		if (!bWrite)
		{
			return;
		}
		Frames.push_back(MeasureFrame(Result, Number));
		Messages.insert(Messages.end(), Result.Diagnostics.begin(), Result.Diagnostics.end());
		const std::string File = (Folder / Frames.back().File).string();
		WriteDisplayPng(File + ".png", Result.Final, Result.OutputDevice);
		if (Plan.bExr)
		{
			WriteFinalExr(Result, File + ".exr");
		}
	};
	std::vector<int> Numbers = ListTaskFrames(Task.Frames);
	if (Numbers.empty())
	{
		Render(std::nullopt, true);
	}
	else if (bFirstAlone)
	{
		Numbers.resize(1);
	}
	for (const int Frame : bFirstAlone ? std::vector<int>() : ListTaskFrames(Task.LeadFrames))
	{
		Render(Frame, false);
	}
	std::ranges::for_each(Numbers, [&](int Frame) { Render(Frame, true); });
	WriteResult(Folder, Task, GetMeans(Frames), Frames, Messages);
}

std::string FSweepRunner::RunStudy(const FSweepTask& Task, const Files::path& Folder)
{
	const FStudyResult Result = FStudyRun(MakeOptions(Task)).Measure();
	std::vector<double> Errors;
	for (const FStudyVariant& Variant : Result.Variants)
	{
		const double Error = GetMetric(Variant.Error, Result.GetMetric());
		if (Variant.Competes() && std::isfinite(Error))
		{
			Errors.push_back(Error);
		}
	}
	FSweepFigures Figures = {{"variants", double(Errors.size())}};
	if (!Errors.empty())
	{
		Figures["least " + Result.GetMetric()] = std::ranges::min(Errors);
		Figures["most " + Result.GetMetric()] = std::ranges::max(Errors);
	}
	WriteWholeFile(Folder / "study.json", MakeStudyJson(Result));
	WriteResult(Folder, Task, Figures, {}, Result.Diagnostics);
	return MakeStudyTimingJson(Result);
}

void FSweepRunner::RunHazards(const FSweepTask& Task, const Files::path& Folder)
{
	FHazardCapture Capture({.Pass = Plan.Pass, .Input = ""});
	FRunOptions Options = MakeOptions(Task);
	Options.Variables.push_back("r.Drydock.NativeKernels=0"); // as `drydock hazards` runs
	std::vector<FDiagnostic> Messages;
	{
		const FScopedDispatchObserver Scope(Capture);
		Messages = RunConfig(Options).Diagnostics;
	}
	FSweepFigures Figures = {{"cases", 0.0}, {"hazards", 0.0}};
	for (const FHazardRow& Row : Capture.GetRows())
	{
		Figures["cases"] += double(Row.Findings.size());
		Figures["hazards"] += double(std::ranges::count_if(Row.Findings, MakesNaNOfFinite));
	}
	WriteWholeFile(Folder / "hazards.json", MakeHazardJson(Capture.GetRows()));
	WriteResult(Folder, Task, Figures, {}, Messages);
}

std::string FSweepRunner::Run(const FSweepTask& Task, const Files::path& Folder, bool bFirstAlone)
{
	if (Plan.Kind == "study")
	{
		return RunStudy(Task, Folder);
	}
	Plan.Kind == "hazards" ? RunHazards(Task, Folder) : RunFrames(Task, Folder, bFirstAlone);
	return "";
}

void MeasureSweep(const Files::path& Folder, FSweepPlan& Plan)
{
	const FAsideFile Aside(Folder / "measured");
	Files::create_directory(Aside.GetPath());
	// The shaders of a frame are compiled first; others run more than one, so that these are a small part.
	for (int Turn = Plan.Kind == "run" ? 0 : 1; Turn < 2; ++Turn)
	{
		const auto Begin = std::chrono::steady_clock::now();
		FSweepRunner(Plan, std::nullopt).Run(Plan.Tasks.at(0), Aside.GetPath(), true);
		Plan.SecondsPerFrame = std::chrono::duration<double>(std::chrono::steady_clock::now() - Begin).count();
	}
	Plan.BytesPerFrame = 0;
	for (const Files::directory_entry& Entry : Files::directory_iterator(Aside.GetPath()))
	{
		Plan.BytesPerFrame += Entry.file_size();
	}
}

} // namespace Drydock
