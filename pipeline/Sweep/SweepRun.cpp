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
#include "Text/Version.h"
#include "TileExecutor.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <unistd.h>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

using FFigureMap = std::map<std::string, double>;

/** A frame of a result. */
struct FSweepFrame
{
	std::optional<int> Frame;
	std::string Picture; // fingerprint
	FFigureMap Figures;
};

/** The fingerprint of the picture's numbers, its mean brightness as displayed, and how many pixels are not finite. */
void MeasureFinal(const FPicture& Picture, FSweepFrame& Frame)
{
	FFingerprint Fingerprint;
	const size_t Width = static_cast<size_t>(Picture.Width), NumChannels = static_cast<size_t>(Picture.NumChannels);
	std::vector<float> Row(Width * NumChannels);
	double Sum = 0.0;
	uint64_t NumNonFinite = 0;
	for (int Y = 0; Y < Picture.Height; ++Y)
	{
		Picture.ReadRow(Y, Row.data());
		Fingerprint.Add(Row.data(), Row.size() * sizeof(float));
		for (size_t X = 0; X < Width; ++X)
		{
			const float* const Color = &Row[X * NumChannels];
			const double Luma = 0.2126 * Color[0] + 0.7152 * Color[1] + 0.0722 * Color[2];
			Sum += std::isfinite(Luma) ? Luma : 0.0;
			NumNonFinite += std::isfinite(Luma) ? 0 : 1;
		}
	}
	Frame.Picture = Fingerprint.Get();
	Frame.Figures["brightness"] = Sum / static_cast<double>(std::max<size_t>(1, Width * size_t(Picture.Height)));
	Frame.Figures["nonFinite"] = static_cast<double>(NumNonFinite);
}

FSweepFrame MeasureFrame(const FRunResult& Result, std::optional<int> Number)
{
	FSweepFrame Frame{Number, "", {}};
	MeasureFinal(Result.Final, Frame);
	Frame.Figures["exposure"] = Result.ExposureScale;
	for (const auto& [Effect, Figures] : Result.Figures)
	{
		for (const FFigureGroup& Group : Figures.Groups)
		{
			for (const FFigure& Figure : Group.Figures)
			{
				const double Value = Figures.Get(Group.Name, Figure.Name);
				if (std::isfinite(Value))
				{
					Frame.Figures[Group.Name + "." + Figure.Name] = Value;
				}
			}
		}
	}
	return Frame;
}

/** The mean over the frames; a figure that not all of them have is left out. */
FFigureMap GetMeans(const std::vector<FSweepFrame>& Frames)
{
	FFigureMap Means = Frames.empty() ? FFigureMap() : Frames[0].Figures;
	for (auto& [Name, Mean] : Means)
	{
		double Sum = 0.0;
		for (const FSweepFrame& Frame : Frames)
		{
			const auto Found = Frame.Figures.find(Name);
			Sum += Found == Frame.Figures.end() ? std::nan("") : Found->second;
		}
		Mean = Sum / static_cast<double>(Frames.size());
	}
	std::erase_if(Means, [](const auto& One) { return !std::isfinite(One.second); });
	return Means;
}

void WriteFigures(FJsonWriter& Writer, const FFigureMap& Figures)
{
	Writer.Object("figures", Figures, [&](const auto& One) { Writer.Member(One.first, One.second); });
}

/** result.json. Messages come once, though each frame has them. */
void WriteResult(const Files::path& Folder, const FSweepTask& Task, const FFigureMap& Figures,
	const std::vector<FSweepFrame>& Frames, const std::vector<FDiagnostic>& Messages)
{
	FJsonWriter Writer('{');
	Writer.Members({{"version", GetVersion()}, {"task", Task.Hash}});
	Writer.Object("set", Task.Set, [&](const auto& One) { Writer.Member(One.first, One.second); });
	WriteFigures(Writer, Figures);
	Writer.Array("frames", Frames,
		[&](const FSweepFrame& Frame)
		{
			Writer.BeginObject(true);
			Writer.Members(
				{{"frame", Frame.Frame}, {"file", NameSweepPicture(Frame.Frame, "png")}, {"picture", Frame.Picture}});
			WriteFigures(Writer, Frame.Figures);
			Writer.EndObject();
		});
	std::vector<std::string> Texts;
	for (const FDiagnostic& Message : Messages)
	{
		AddUnique(Texts, Message.ToString());
	}
	Writer.Key("messages").BeginArray();
	std::ranges::for_each(Texts, [&](const std::string& Text) { Writer.Value(Text); });
	Writer.EndArray();
	WriteWholeFile((Folder / "result.json").string(), Writer.GetText());
}

std::string GetHostName()
{
	char Name[256] = {};
	return gethostname(Name, sizeof(Name) - 1) == 0 ? Name : "";
}

} // namespace

std::string NameSweepPicture(std::optional<int> Frame, const char* Extension)
{
	return Frame ? fmt::format("{:04}.{}", *Frame, Extension) : std::string("final.") + Extension;
}

FSweepRunner::FSweepRunner(const FSweepPlan& InPlan, std::optional<int> InThreads)
	: Plan(InPlan)
	, Threads(InThreads)
	, SceneCache(std::make_shared<FSceneCache>())
{
}

FSweepRunner::~FSweepRunner() = default;

FRunOptions FSweepRunner::MakeOptions(const FSweepTask& Task) const
{
	FRunOptions Options = MakeTaskOptions(Plan, Task);
	Options.Threads = Threads;
	Options.SceneCache = SceneCache;
	return Options;
}

FRunSession& FSweepRunner::Begin(const FSweepTask& Task)
{
	std::vector<std::pair<std::string, std::string>> Set = Task.Set;
	std::erase_if(Set, [](const auto& One) { return One.first == "frames"; });
	// Plugins may keep a history of their own.
	const bool bAgain = Session && Set == SessionSet && Session->GetConfig().Plugins.empty() &&
						Session->GetConfig().Overlays.empty();
	if (!bAgain)
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

void FSweepRunner::RunFrames(const FSweepTask& Task, const Files::path& Folder, size_t MaxFrames)
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
		WriteDisplayPng((Folder / NameSweepPicture(Number, "png")).string(), Result.Final, Result.OutputDevice);
		if (Plan.bExr)
		{
			WriteFinalExr(Result, (Folder / NameSweepPicture(Number, "exr")).string());
		}
	};
	for (const int Frame : MaxFrames == 0 ? ListTaskFrames(Task.LeadFrames) : std::vector<int>())
	{
		Render(Frame, false);
	}
	std::vector<int> Numbers = ListTaskFrames(Task.Frames);
	if (Numbers.empty())
	{
		Render(std::nullopt, true);
	}
	Numbers.resize(MaxFrames == 0 ? Numbers.size() : std::min(MaxFrames, Numbers.size()));
	for (const int Frame : Numbers)
	{
		Render(Frame, true);
	}
	WriteResult(Folder, Task, GetMeans(Frames), Frames, Messages);
}

std::string FSweepRunner::RunStudy(const FSweepTask& Task, const Files::path& Folder)
{
	const FStudyResult Result = FStudyRun(MakeOptions(Task)).Measure();
	FFigureMap Figures;
	const std::string& Metric = Result.GetMetric();
	for (const FStudyVariant& Variant : Result.Variants)
	{
		const double Error = GetMetric(Variant.Error, Metric);
		if (Variant.Competes() && std::isfinite(Error))
		{
			++Figures["variants"];
			const auto [Least, bNewLeast] = Figures.emplace("least " + Metric, Error);
			const auto [Most, bNewMost] = Figures.emplace("most " + Metric, Error);
			Least->second = std::min(Least->second, Error);
			Most->second = std::max(Most->second, Error);
		}
	}
	WriteWholeFile((Folder / "study.json").string(), MakeStudyJson(Result));
	WriteWholeFile((Folder / "study.csv").string(), MakeStudyCsv(Result, false));
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
	FFigureMap Figures = {{"cases", 0.0}, {"hazards", 0.0}};
	for (const FHazardRow& Row : Capture.GetRows())
	{
		Figures["cases"] += static_cast<double>(Row.Findings.size());
		Figures["hazards"] += static_cast<double>(std::ranges::count_if(Row.Findings, MakesNaNOfFinite));
	}
	WriteWholeFile((Folder / "hazards.json").string(), MakeHazardJson(Capture.GetRows()));
	WriteResult(Folder, Task, Figures, {}, Messages);
}

FSweepTime FSweepRunner::Run(const FSweepTask& Task, const Files::path& Folder, size_t MaxFrames)
{
	const auto Start = std::chrono::steady_clock::now();
	FSweepTime Time;
	switch (Plan.Task)
	{
	case ESweepTask::Run:
		RunFrames(Task, Folder, MaxFrames);
		break;
	case ESweepTask::Study:
		Time.More = RunStudy(Task, Folder);
		break;
	case ESweepTask::Hazards:
		RunHazards(Task, Folder);
		break;
	}
	Time.Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - Start).count();
	Time.Threads = Threads.value_or(0);
	Time.Host = GetHostName();
	return Time;
}

FSweepCost MeasureSweep(const FSweepPlan& Plan, const FSweepFolder& Folder)
{
	if (Plan.Tasks.empty())
	{
		return {};
	}
	const FAsideFile Aside(Folder.GetPath() / "measure");
	std::error_code Error;
	if (!Files::create_directory(Aside.GetPath(), Error))
	{
		throw MakeWriteError(Aside.GetPath().string(), Error.message());
	}
	const auto Measure = [&]
	{
		return FSweepRunner(Plan, std::nullopt).Run(Plan.Tasks[0], Aside.GetPath(), 1).Seconds;
	};
	FSweepCost Cost{Measure(), 0};
	if (Plan.Task == ESweepTask::Run) // others run more than one frame, so their shaders are a small part
	{
		Cost.Seconds = Measure();
	}
	for (const Files::directory_entry& Entry : Files::directory_iterator(Aside.GetPath()))
	{
		Cost.Bytes += Entry.file_size();
	}
	return Cost;
}

} // namespace Drydock
