// Checks each state by setting up its run, which the frame then uses.
#include "Live/LiveSession.h"

#include "Config/SettingsJson.h"
#include "DispatchReuse.h"
#include "Live/LiveErrors.h"
#include "Live/LiveJson.h"
#include "RangeTools.h"
#include "Run/RunFiles.h"
#include "SceneFile/SceneCache.h"
#include "Text/JsonWriter.h"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <algorithm>
#include <chrono>

namespace Drydock
{

namespace
{

constexpr size_t MaxPins = 32;
constexpr size_t MaxDots = 1000;

double MillisecondsSince(std::chrono::steady_clock::time_point Begin)
{
	return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - Begin).count();
}

FJsonValue ParseObject(const std::string& Text)
{
	std::vector<FDiagnostic> Faults;
	bool bSyntaxError = false;
	return ParseJson(Text, "", Faults, bSyntaxError);
}

bool EditsVolume(const FJsonValue& Change)
{
	return std::ranges::any_of(Change.GetElements("edits"),
		[](const FJsonValue& Edit) { return Edit.GetString("set").starts_with("/volumes/"); });
}

/** The edits, behind one that writes the volumes of the config into its text. */
void WriteVolumesFirst(const FConfig& Config, FJsonValue& Change)
{
	std::vector<FDiagnostic> Ignored; // shapes that are not boxes, which no scene gives
	FJsonWriter Writer('{');
	Writer.Member("set", "/volumes");
	WriteVolumes(Writer.Key("value"), ToVector<FVolumeText>(Config.Volumes, [&](const FConfigVolume& Volume)
										  { return MakeVolumeText(Volume, Config.File, Ignored); }));
	std::vector<FJsonValue>& Edits = std::ranges::find(Change.Members, "edits", &FJsonMember::Key)->Value.Elements;
	Edits.insert(Edits.begin(), ParseObject(Writer.GetText()));
}

} // namespace

FLiveSession::FLiveSession(
	FLiveOptions InOptions, FEditHistory InHistory, FLiveEvents& InEvents, FLivePictures& InPictures)
	: Options(std::move(InOptions))
	, History(std::move(InHistory))
	, Events(InEvents)
	, Pictures(InPictures)
	, SceneCache(std::make_shared<FSceneCache>())
	, ReuseCache(Options.bReuse ? std::make_shared<FReuseCache>() : nullptr)
	, FileText(TryReadTextFile(History.GetFile()).value_or(""))
{
	if (!Options.Crash.empty())
	{
		CrashJson = MakeFaultJson(History.GetRevision(), {{.Code = ErrorLiveCrash, .Message = Options.Crash}});
		FaultJson = CrashJson;
	}
}

FLiveSession::~FLiveSession() = default;

FRunOptions FLiveSession::MakeOptions() const
{
	FRunOptions Made = Options.Run;
	Made.ConfigText = History.GetText();
	Made.SceneCache = SceneCache;
	Made.ReuseCache = ReuseCache;
	return Made;
}

void FLiveSession::Prepare(const std::string& Text)
{
	if (Run && RunText == Text)
	{
		return;
	}
	Run.reset(); // there is one at a time
	FRunOptions RunOptions = MakeOptions();
	RunOptions.ConfigText = Text;
	Run = std::make_unique<FRunSession>(RunOptions);
	RunText = Text;
}

const FConfig& FLiveSession::BeginRun()
{
	Prepare(History.GetText());
	return Run->GetConfig();
}

void FLiveSession::Change(FJsonValue Asked)
{
	if (EditsVolume(Asked) && BeginRun().VolumesFromScene.Value)
	{
		WriteVolumesFirst(Run->GetConfig(), Asked);
	}
	const FEditHistory::FNext Next = History.Plan(Asked);
	if (Next.bForward && Next.Text == History.GetText())
	{
		return;
	}
	Prepare(Next.Text);
	History.Take(Next);
	CrashJson = "null";
	bFrameWanted = true;
	bNewFiles = true;
	TellState();
}

int FLiveSession::Pin(const std::string& Name)
{
	if (Pins.size() >= MaxPins)
	{
		throw FError({.Code = ErrorBadEdit,
						 .Message = "there are " + std::to_string(MaxPins) + " pins already: remove one first"},
			ExitUsage);
	}
	if (bFrameWanted)
	{
		RunFrame(); // its picture is the pin's
	}
	const int Number = ++NumPins;
	Pins.push_back({Number, Name.empty() ? "Pin " + std::to_string(Number) : Name, History.GetRevision()});
	Pictures.Keep("pin-" + std::to_string(Number));
	TellState();
	return Number;
}

void FLiveSession::Unpin(int Number)
{
	if (std::erase_if(Pins, [&](const FLivePin& Pin) { return Pin.Number == Number; }) == 0)
	{
		throw FError({.Code = ErrorBadEdit, .Message = "there is no pin " + std::to_string(Number)}, ExitUsage);
	}
	Pictures.Forget("pin-" + std::to_string(Number));
	TellState();
}

void FLiveSession::AddDot(FLiveDot Dot)
{
	std::erase_if(Dots, [&](const FLiveDot& Other) { return Other.Revision == Dot.Revision; });
	Dots.push_back(std::move(Dot));
	if (Dots.size() > MaxDots)
	{
		Dots.erase(Dots.begin());
	}
}

void FLiveSession::RunStart()
{
	constexpr uint64_t FirstRevision = 1;
	try
	{
		Prepare(History.GetStart());
		const FRunResult Start = Run->Run(std::nullopt, {});
		StartSettings = Start.Settings;
		Pictures.Add(FirstRevision, Start);
	}
	catch (const FError&)
	{
		Run.reset(); // then the first frame that is well counts as the start's
	}
}

void FLiveSession::RunFrame()
{
	const auto Begin = std::chrono::steady_clock::now();
	bFrameWanted = false;
	try
	{
		if (!StartSettings && History.GetText() != History.GetStart())
		{
			RunStart(); // an edit was faster than the first frame, or the session goes on after a crash
		}
		Prepare(History.GetText());
		Frame = Run->Run(std::nullopt, {});
		if (!StartSettings)
		{
			StartSettings = Frame->Settings;
			bNewFiles = true;
		}
		Pictures.Add(History.GetRevision(), *Frame);
		FrameJson = MakeFrameJson(History.GetRevision(), *Frame, MillisecondsSince(Begin));
		FaultJson = CrashJson;
		Events.Send("frame", FrameJson);
		if (Options.OnFrame)
		{
			Options.OnFrame(History);
		}
	}
	catch (...)
	{
		Run.reset();
		TellFault(Options.Explain(std::current_exception()).GetDiagnostics());
	}
}

void FLiveSession::LookAtFiles()
{
	FWatchedFiles Present = FindRunFiles(MakeOptions());
	const std::string& ConfigFile = History.GetFile();
	FWatchedFiles Before = std::exchange(Files, Present);
	if (std::exchange(bNewFiles, false))
	{
		// Another state may name other files, and a plugin's are known once it is loaded: only what both know counts.
		FWatchedFiles Known = Before;
		Known.AddUnknown(Present);
		Present.AddUnknown(Before);
		Before = std::move(Known);
	}
	if (Present == Before)
	{
		return;
	}
	const std::optional<std::vector<std::string>> Edited = Present.FindEdited(Before);
	const std::string Text = TryReadTextFile(ConfigFile).value_or(FileText);
	const bool bConfig = std::exchange(FileText, Text) != Text;
	if (!Edited || Edited->size() > (bConfig ? 1u : 0u))
	{
		Run.reset();
		ForgetEdited(Before, Present);
		History.TakeChange();
		bFrameWanted = true;
		TellState();
	}
	if (!bConfig)
	{
		return;
	}
	if (Text == History.GetText())
	{
		bFrameWanted = true; // where it was broken meanwhile
		return;
	}
	try
	{
		Change(ParseObject("{\"text\": " + FJsonWriter::Quote(Text) + "}"));
	}
	catch (...)
	{
		TellFault(Options.Explain(std::current_exception()).GetDiagnostics());
	}
}

void FLiveSession::TellState()
{
	Events.Send("state", "{\"revision\": " + std::to_string(History.GetRevision()) + "}");
}

void FLiveSession::TellFault(const std::vector<FDiagnostic>& Messages)
{
	FaultJson = MakeFaultJson(History.GetRevision(), Messages);
	Events.Send("fault", FaultJson);
}

} // namespace Drydock
