// Renders the frames that are missing, with the history of those that are there.
#include "Sequence/RunSequence.h"

#include "Config/FrameSequence.h"
#include "RenderGraphBuilder.h"
#include "Run/Run.h"
#include "SceneFile/SceneCamera.h"
#include "Sequence/SequenceErrors.h"
#include "Sequence/SequenceFolder.h"
#include "Sequence/SequenceInputs.h"
#include "Sequence/SequenceJson.h"
#include "Sequence/SequenceSheet.h"
#include "Sequence/ViewStateFile.h"
#include "Text/Fingerprint.h"

#include <algorithm>
#include <chrono>
#include <filesystem>

namespace Drydock
{

namespace
{

using FClock = std::chrono::steady_clock;

[[noreturn]] void Throw(int Code, const std::string& Folder, const std::string& Message)
{
	throw FError({.Code = Code, .Message = Message, .File = Folder}, ExitUsage);
}

std::string Join(const std::vector<std::string>& Parts)
{
	std::string Text;
	for (const std::string& Part : Parts)
	{
		Text += (Text.empty() ? "" : "; ") + Part;
	}
	return Text;
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
		, Inputs(FindSequenceInputs(Options.Run, Session.GetConfig()))
		, Folder(Options.Folder, GetNumDigits(Session.GetConfig().Scene.Sequence))
	{
	}

	FSequenceResult Run()
	{
		const auto Begin = FClock::now();
		const size_t NumFinished = FindFinished();
		if (NumFinished < Frames.size())
		{
			Folder.WriteSequenceJson(MakeSequenceHead(Session.GetConfig(), Inputs));
		}
		for (size_t Index = 0; Index + 1 < NumFinished; ++Index)
		{
			Folder.RemoveViewState(Frames[Index].Number);
		}
		if (NumFinished < Frames.size())
		{
			Resume(NumFinished);
			for (Current = NumFinished; Current < Frames.size(); ++Current)
			{
				RenderFrame(Frames[Current]);
			}
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

	/** Extensions from outside may keep a history where nobody else sees it. */
	bool IsHistoryKnown() const { return Session.GetConfig().Plugins.empty(); }

	/** How many of the frames are there and are of this sequence. */
	size_t FindFinished()
	{
		if (Options.bRestart)
		{
			Folder.Clear();
		}
		std::vector<std::string> Changes;
		const std::string Json = Folder.ReadSequenceJson();
		const std::vector<int> There = Folder.FindFrames();
		if (There.empty())
		{
			return 0;
		}
		if (Json.empty())
		{
			Changes.emplace_back("its frames came without a sequence.json");
		}
		else
		{
			Changes = DescribeChanges(ReadSequenceInputs(Json, GetSequenceJsonPath()), Inputs);
		}
		for (size_t Index = 0; Changes.empty() && Index < There.size(); ++Index)
		{
			if (Index >= Frames.size() || There[Index] != Frames[Index].Number)
			{
				Changes.push_back("frame " + std::to_string(There[Index]) +
								  " is there, and the frames asked for do not begin like that");
			}
			else if (ReadRecord(There[Index]).FileFingerprint != FingerprintFile(Frames[Index].Path))
			{
				Changes.push_back("file " + Frames[Index].Path + " has changed");
			}
		}
		if (!Changes.empty())
		{
			Throw(ErrorSequenceChanged, Folder.GetPath(),
				"the folder holds frames of another sequence: " + Join(Changes) +
					"; --restart renders all frames again, --out writes to another folder");
		}
		return There.size();
	}

	std::string GetSequenceJsonPath() const { return Folder.GetPath() + "/sequence.json"; }

	FFrameRecord ReadRecord(int Frame) const
	{
		return ReadFrameRecord(Folder.ReadFrameJson(Frame), Folder.GetFramePath(Frame) + "/frame.json");
	}

	/** Brings History to where it was after the finished frames. */
	void Resume(size_t NumFinished)
	{
		if (NumFinished == 0)
		{
			return;
		}
		if (IsHistoryKnown())
		{
			const int Frame = Frames[NumFinished - 1].Number;
			History = UnpackViewStates(Folder.ReadViewState(Frame), Folder.GetViewStatePath(Frame));
			FillCaches(NumFinished - 1);
			return;
		}
		for (Current = 0; Current < NumFinished; ++Current)
		{
			const FRunResult Result = Session.Run(Frames[Current].Number, History);
			const FFrameRecord Before = ReadRecord(Frames[Current].Number);
			if (MakeFrameRecord(Result, Before.FileFingerprint) != Before)
			{
				Throw(ErrorSequenceNotRepeatable, Folder.GetFramePath(Frames[Current].Number),
					"computed again for the history that its plugins keep, the frame is not what it was: a plugin "
					"reckons with more than its inputs; --restart renders all frames again");
			}
			EndFrame(Result);
			++NumRepeated;
		}
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

	void RenderFrame(const FSequenceFrame& Frame)
	{
		const FRunResult Result = Session.Run(Frame.Number, History);
		const FFrameRecord Record = MakeFrameRecord(Result, FingerprintFile(Frame.Path));
		Folder.WriteFrame(Frame.Number, Result, MakeFrameJson(Result, Record),
			IsHistoryKnown() ? PackViewStates(Result.ViewStates) : "");
		if (Current > 0)
		{
			Folder.RemoveViewState(Frames[Current - 1].Number);
		}
		if (Options.Report)
		{
			Options.Report(Result.Diagnostics);
		}
		EndFrame(Result);
		++NumRendered;
	}

	void EndFrame(const FRunResult& Result)
	{
		History = Result.ViewStates;
		FRDGBuilder::TickPoolElements();
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
		Result.SequenceJson = Folder.ReadSequenceJson();
		if (!IsSequenceComplete(Result.SequenceJson, GetSequenceJsonPath(), Result.Frames))
		{
			Result.SequenceJson = MakeSequenceJson(Session.GetConfig(), Inputs, Folder, Result.Frames);
			// The sheet first: a complete sequence.json says that everything is there.
			WriteSequenceSheet(Folder.GetPath() + "/sheet.png", Result.Frames, Result.Pictures);
			Folder.WriteSequenceJson(Result.SequenceJson);
		}
		Result.NumRendered = NumRendered;
		Result.NumRepeated = NumRepeated;
		Result.Seconds = std::chrono::duration<double>(FClock::now() - Begin).count();
		Result.FramesPerSecond = GetFramesPerSecond(Session.GetConfig(), Frames.front().Path);
		return Result;
	}

	const FSequenceOptions& Options;
	size_t Current = 0; // in Frames
	FRunSession Session;
	const std::vector<FSequenceFrame> Frames;
	const FSequenceInputs Inputs;
	FSequenceFolder Folder;
	std::vector<FViewHistory> History;
	int NumRendered = 0;
	int NumRepeated = 0;
};

} // namespace

FSequenceResult RunSequence(const FSequenceOptions& Options)
{
	return FSequenceRun(Options).Run();
}

} // namespace Drydock
