// Renders the frames that are missing, with the history of those that are there.
#include "Sequence/RunSequence.h"

#include "Config/FrameSequence.h"
#include "RenderGraphBuilder.h"
#include "Run/Run.h"
#include "SceneFile/SceneCamera.h"
#include "Sequence/SequenceErrors.h"
#include "Sequence/SequenceFolder.h"
#include "Run/RunInputs.h"
#include "Sequence/SequenceJson.h"
#include "Sequence/ViewStateFile.h"
#include "Text/Fingerprint.h"
#include "TextTools.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <set>

namespace Drydock
{

namespace
{

using FClock = std::chrono::steady_clock;

[[noreturn]] void Throw(int Code, const std::string& Folder, const std::string& Message)
{
	throw FError({.Code = Code, .Message = Message, .File = Folder}, ExitUsage);
}

/** As many digits as the pattern has marks. */
int GetNumDigits(const std::string& Pattern)
{
	const std::string Name = std::filesystem::path(Pattern).filename().string();
	const size_t Last = Name.rfind('#');
	const size_t Before = Name.find_last_not_of('#', Last);
	return static_cast<int>(Last == std::string::npos ? 1 : Last - (Before == std::string::npos ? -1 : Before));
}

double GetFramesPerSecond(const FConfig& Config, const std::string& File)
{
	constexpr double Default = 24.0;
	if (Config.Scene.Fps.IsSet())
	{
		return Config.Scene.Fps.Value;
	}
	const std::optional<double> Delta = ReadSceneDeltaTime(FImageFile(File).GetAttribute("drydock:camera_json"));
	return Delta ? 1.0 / *Delta : Default;
}

class FSequenceRun
{
public:
	explicit FSequenceRun(const FSequenceOptions& InOptions)
		: Options(InOptions)
		, Session(MakeRunOptions())
		, Frames(ChooseFrames())
		, Before(FindFramesBefore(Session.GetConfig(), Frames))
		, Lead(Before.end() - std::min<std::ptrdiff_t>(Options.Lead, std::ssize(Before)), Before.end())
		, Inputs(FindInputs())
		, Folder(Options.Folder, GetNumDigits(Session.GetConfig().Scene.Sequence))
	{
	}

	FSequenceResult Run()
	{
		const auto Begin = FClock::now();
		const std::vector<bool> bFinished = FindFinished();
		for (size_t Index = 0; Index < Frames.size(); ++Index)
		{
			if (!bFinished[Index] || !SawHistoryBefore(Index))
			{
				BringHistoryTo(Index);
				RenderFrame(Index);
			}
		}
		for (size_t Index = 0; Index + 1 < Frames.size(); ++Index)
		{
			Folder.RemoveViewState(Frames[Index].Number);
		}
		return Finish(Begin);
	}

private:
	FRunOptions MakeRunOptions()
	{
		FRunOptions Run = Options.Run;
		Run.Frame.reset();
		Run.Progress = [this](int, int, const std::string& Pass)
		{
			ReportProgress(Pass.empty() ? "" : ": " + Pass);
		};
		return Run;
	}

	std::vector<FSequenceFrame> ChooseFrames() const
	{
		const FConfig& Config = Session.GetConfig();
		return Options.Frames.empty()
				   ? ChooseSequenceFrames(Config, Config.Scene.Frames.Value, Config.Scene.Frames.Place)
				   : ChooseSequenceFrames(Config, Options.Frames, {0, 0, "--frames"});
	}

	/** Frames that lead in count by their contents: nothing of them is written. */
	FRunInputs FindInputs() const
	{
		FRunInputs Found = FindSequenceInputs(Options.Run, Session.GetConfig());
		for (const FSequenceFrame& Frame : Lead)
		{
			Found["file " + Frame.Path] = FingerprintFile(Frame.Path);
		}
		return Found;
	}

	/** Extensions from outside may keep a history where nobody else sees it. */
	bool IsHistoryKnown() const { return Session.GetConfig().Plugins.empty(); }

	/** The frame before one, by its number; -1 before the first. */
	int GetNumberBefore(size_t Index) const
	{
		return Index > 0 ? Frames[Index - 1].Number : Lead.empty() ? -1 : Lead.back().Number;
	}

	/** For each frame whether it is there, whole and of this sequence. */
	std::vector<bool> FindFinished()
	{
		if (Options.bRestart)
		{
			Folder.Clear();
		}
		std::vector<bool> bFinished(Frames.size(), false);
		std::vector<std::string> Changes;
		const std::string Json = Folder.ReadSequenceJson();
		const std::vector<int> There = Folder.FindFrames();
		if (There.empty())
		{
			return bFinished;
		}
		if (Json.empty())
		{
			Changes.emplace_back("its frames have no sequence.json");
		}
		else
		{
			Changes = DescribeChanges(ReadSequenceInputs(Json, GetSequenceJsonPath()), Inputs);
		}
		std::vector<FDiagnostic> Damages;
		for (size_t At = 0; Changes.empty() && At < There.size(); ++At)
		{
			const auto Frame = std::ranges::find(Frames, There[At], &FSequenceFrame::Number);
			const bool bAskedFor = Frame != Frames.end();
			const std::string Damage = bAskedFor ? Folder.FindDamage(There[At]) : "";
			if (!Damage.empty())
			{
				Folder.RequireOwnFrame(There[At]);
				Damages.push_back(DescribeDamage(There[At], "its " + Damage));
				continue;
			}
			const size_t Index = static_cast<size_t>(Frame - Frames.begin());
			const FFrameRecord Record = bAskedFor ? ReadRecord(There[At]) : FFrameRecord();
			if (!bAskedFor || Record.After != GetNumberBefore(Index))
			{
				Changes.push_back(
					"frame " + std::to_string(There[At]) + " exists, but the requested frames begin differently");
			}
			else if (Record.FileFingerprint != FingerprintFile(Frame->Path))
			{
				Changes.push_back("file " + Frame->Path + " has changed");
			}
			else
			{
				bFinished[Index] = true;
			}
		}
		if (!Changes.empty())
		{
			Throw(ErrorSequenceChanged, Folder.GetPath(),
				"the folder holds frames of another sequence: " + JoinText(Changes, "; ") +
					"; --restart renders all frames again, --out writes to another folder");
		}
		for (size_t Index = 0; Index < Frames.size() && Frames[Index].Number < There.back(); ++Index)
		{
			if (std::find(There.begin(), There.end(), Frames[Index].Number) == There.end())
			{
				Damages.push_back(DescribeDamage(Frames[Index].Number, "it is missing"));
			}
		}
		Report(Damages);
		return bFinished;
	}

	std::string GetSequenceJsonPath() const { return Folder.GetPath() + "/sequence.json"; }

	FFrameRecord ReadRecord(int Frame) const
	{
		return ReadFrameRecord(Folder.ReadFrameJson(Frame), Folder.GetFramePath(Frame) + "/frame.json");
	}

	FDiagnostic DescribeDamage(int Frame, const std::string& Why) const
	{
		return {.Severity = ESeverity::Warning,
			.Code = WarnFrameDamaged,
			.Message = "frame " + std::to_string(Frame) + " is rendered again: " + Why,
			.File = Folder.GetFramePath(Frame)};
	}

	/** Whether a finished frame goes on from what the frame before it is now. Says so where it does not. */
	bool SawHistoryBefore(size_t Index) const
	{
		if (Index == 0 && !Lead.empty())
		{
			return true; // the inputs are the same
		}
		const std::string Left = Index == 0 ? "" : ReadRecord(Frames[Index - 1].Number).State;
		const bool bSaw = ReadRecord(Frames[Index].Number).Seen == Left;
		if (!bSaw)
		{
			Report({DescribeDamage(Frames[Index].Number, "the frame before it has changed")});
		}
		return bSaw;
	}

	/** Brings History to where it was before a frame; all before that are there. */
	void BringHistoryTo(size_t Index)
	{
		if (NumInHistory < Index && IsHistoryKnown() && Folder.HasViewState(Frames[Index - 1].Number))
		{
			ReadHistory(Index - 1);
			FillCaches(Index - 1);
		}
		if (NumInHistory == 0 && LastState.empty())
		{
			LeadIn();
		}
		while (NumInHistory < Index)
		{
			RepeatFrame(NumInHistory);
		}
	}

	/** Renders what is before the first frame, for the history alone. */
	void LeadIn()
	{
		for (const FSequenceFrame& Frame : Lead)
		{
			History = Session.Run(Frame.Number, History).ViewStates;
			LastState = FingerprintViewStates(History);
			FRDGBuilder::TickPoolElements();
		}
	}

	/** As a frame left it. */
	void ReadHistory(size_t Index)
	{
		const int Frame = Frames[Index].Number;
		const std::string File = Folder.GetViewStatePath(Frame);
		History = UnpackViewStates(Folder.ReadViewState(Frame), File);
		LastState = FingerprintViewStates(History);
		NumInHistory = Index + 1;
		if (LastState != ReadRecord(Frame).State)
		{
			throw FError(
				{.Code = ErrorStateBroken, .Message = "the state belongs to another frame", .File = File}, ExitFiles);
		}
	}

	/** For the history alone: it is there already. */
	void RepeatFrame(size_t Index)
	{
		Current = Index;
		const int Frame = Frames[Index].Number;
		const FRunResult Result = Session.Run(Frame, History);
		const FFrameRecord Before = ReadRecord(Frame);
		const FFrameRecord Record = MakeRecord(Result, Before.FileFingerprint);
		if (Record != Before)
		{
			Throw(ErrorSequenceNotRepeatable, Folder.GetFramePath(Frame),
				"the frame changed when it was computed again for its history: a plugin depends on more than its "
				"inputs; --restart renders all frames again");
		}
		EndFrame(Result, Record);
		++NumRepeated;
	}

	FFrameRecord MakeRecord(const FRunResult& Result, const std::string& FileFingerprint) const
	{
		FFrameRecord Record = MakeFrameRecord(Result, FileFingerprint);
		Record.After = GetNumberBefore(Current);
		Record.Seen = LastState;
		return Record;
	}

	/** Caches change no picture, but a frame that finds them filled has fewer passes to report. */
	void FillCaches(size_t Last)
	{
		if (std::any_of(History.begin(), History.end(), [](const FViewHistory& View) { return View.bHasCaches; }))
		{
			Current = Last;
			Session.Run(Frames[Last].Number, History);
		}
	}

	void RenderFrame(size_t Index)
	{
		Current = Index;
		const FSequenceFrame& Frame = Frames[Index];
		if (NumRendered == 0)
		{
			Folder.WriteSequenceJson(MakeSequenceHead(Session.GetConfig(), Inputs));
		}
		FRunResult Result = Session.Run(Frame.Number, History);
		Result.Write.insert(EOutputKind::Png); // the sheet and the video are made of them
		const FFrameRecord Record = MakeRecord(Result, FingerprintFile(Frame.Path));
		Folder.WriteFrame(Frame.Number, Result, MakeFrameJson(Result, Record),
			IsHistoryKnown() ? PackViewStates(Result.ViewStates) : "");
		if (Index > 0)
		{
			Folder.RemoveViewState(Frames[Index - 1].Number);
		}
		Report(Result.Diagnostics);
		if (Index == 0 && Lead.size() < Before.size())
		{
			ReportNoHistory(Result);
		}
		EndFrame(Result, Record);
		++NumRendered;
	}

	void EndFrame(const FRunResult& Result, const FFrameRecord& Record)
	{
		History = Result.ViewStates;
		LastState = Record.State;
		++NumInHistory;
		FRDGBuilder::TickPoolElements();
	}

	/** Result is the first frame's. Says so where frames before it exist and it keeps something for the next one. */
	void ReportNoHistory(const FRunResult& Result) const
	{
		std::set<std::string> Kept;
		for (const FViewHistory& View : Result.ViewStates)
		{
			for (const auto& [Name, Texture] : View.Textures)
			{
				Kept.insert(Name);
			}
			for (const auto& [Name, Buffer] : View.Buffers)
			{
				Kept.insert(Name);
			}
		}
		if (!IsHistoryKnown())
		{
			Kept.insert("the state of its plugins");
		}
		if (Kept.empty())
		{
			return;
		}
		const std::string Number = std::to_string(Before.size());
		Report({{.Severity = ESeverity::Note,
			.Code = NoteNoHistory,
			.Message =
				"frame " + std::to_string(Frames.front().Number) + " begins with the history of " +
				(Lead.empty() ? "no frame" : std::to_string(Lead.size()) + (Lead.size() == 1 ? " frame" : " frames")) +
				", and " + Number + (Before.size() == 1 ? " is" : " are") + " before it (" + JoinText(Kept) +
				"): its picture, and the pictures after it, may differ from the whole sequence; --lead " + Number +
				" avoids this",
			.File = Frames.front().Path}});
	}

	void Report(const std::vector<FDiagnostic>& Diagnostics) const
	{
		if (Options.Report && !Diagnostics.empty())
		{
			Options.Report(Diagnostics);
		}
	}

	void ReportProgress(const std::string& What) const
	{
		if (Options.Progress && Current < Frames.size())
		{
			Options.Progress(static_cast<int>(Current), static_cast<int>(Frames.size()),
				"frame " + std::to_string(Frames[Current].Number) + What);
		}
	}

	FSequenceResult Finish(FClock::time_point Begin)
	{
		FSequenceResult Result;
		for (const FSequenceFrame& Frame : Frames)
		{
			Result.Frames.push_back(Frame.Number);
			Result.Pictures.push_back(Folder.GetFramePath(Frame.Number) + "/final.png");
		}
		Result.NumRendered = NumRendered;
		Result.NumRepeated = NumRepeated;
		Result.Seconds = std::chrono::duration<double>(FClock::now() - Begin).count();
		Result.FramesPerSecond = GetFramesPerSecond(Session.GetConfig(), Frames.front().Path);
		Result.SequenceJson = Folder.ReadSequenceJson();
		const bool bComplete = IsSequenceComplete(Result.SequenceJson, GetSequenceJsonPath(), Result.Frames);
		if (!Folder.HasSheet() || !bComplete)
		{
			Result.SequenceJson = MakeSequenceJson(Session.GetConfig(), Inputs, Folder, Result.Frames);
			// The sheet first: a complete sequence.json says that everything is there.
			Folder.WriteSheet(Result.Frames, Result.Pictures);
			Folder.RemovePage();
			Folder.WriteSequenceJson(Result.SequenceJson);
		}
		if (Options.MakePage)
		{
			Folder.WritePage(Options.MakePage(Result));
		}
		return Result;
	}

	const FSequenceOptions& Options;
	size_t Current = 0; // in Frames
	FRunSession Session;
	const std::vector<FSequenceFrame> Frames;
	const std::vector<FSequenceFrame> Before;
	const std::vector<FSequenceFrame> Lead; // the last of Before
	const FRunInputs Inputs;
	FSequenceFolder Folder;
	std::vector<FViewHistory> History;
	std::string LastState;   // its fingerprint; empty before the first frame
	size_t NumInHistory = 0; // how many of the frames it comes from
	int NumRendered = 0;
	int NumRepeated = 0;
};

} // namespace

FSequenceResult RunSequence(const FSequenceOptions& Options)
{
	return FSequenceRun(Options).Run();
}

} // namespace Drydock
