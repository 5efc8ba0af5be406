// Takes the signals of each frame and hands them to the meters.
#include "Flicker/FlickerRun.h"

#include "Config/FrameSequence.h"
#include "DiagnosticList.h"
#include "RHITexture.h"
#include "RenderGraphPass.h"
#include "Run/PassWrites.h"
#include "Run/Run.h"
#include "Text/ConfigErrors.h"
#include "Text/Fmt.inl"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace Drydock
{

namespace
{

constexpr const char* PictureName = "picture";

double GetLuminance(const double* Color)
{
	return 0.3 * Color[0] + 0.59 * Color[1] + 0.11 * Color[2];
}

/** Luminances of a picture, times Scale. */
FFlickerSignal MakeSignal(const FPicture& Picture, double Scale)
{
	FFlickerSignal Signal{Picture.Width, Picture.Height, {}};
	for (int Y = 0; Y < Signal.Height; ++Y)
	{
		for (int X = 0; X < Signal.Width; ++X)
		{
			const double Color[] = {Picture.Get(X, Y, 0), Picture.Get(X, Y, 1), Picture.Get(X, Y, 2)};
			Signal.Light.push_back(Scale * GetLuminance(Color));
		}
	}
	return Signal;
}

/** The signals of one frame, by name; effects in the order of their last passes. */
struct FFrameSignals
{
	std::vector<std::pair<std::string, FFlickerSignal>> Signals;

	const FFlickerSignal* Find(const std::string& Name) const
	{
		const auto Found = std::ranges::find_if(Signals, [&](const auto& Signal) { return Signal.first == Name; });
		return Found == Signals.end() ? nullptr : &Found->second;
	}
};

/** A run of the sequence, frame by frame. */
class FFlickerRun
{
public:
	explicit FFlickerRun(const FRunOptions& InOptions)
		: Session(Listen(InOptions))
	{
	}

	FFrameSignals RunFrame(int Frame, std::vector<FDiagnostic>& Diagnostics)
	{
		Written.clear();
		FRunResult Result = Session.Run(Frame, Last);
		Last = std::move(Result.ViewStates);
		AddNewDiagnostics(Diagnostics, Result.Diagnostics);
		constexpr double Codes = 255.0;
		FFrameSignals Frames;
		Frames.Signals.emplace_back(PictureName, MakeSignal(Result.Final, Codes));
		for (auto& [Effect, Picture] : Written)
		{
			Frames.Signals.emplace_back(Effect, MakeSignal(Picture, static_cast<double>(Result.ExposureScale)));
		}
		return Frames;
	}

	const FConfig& GetConfig() const { return Session.GetConfig(); }

private:
	FRunOptions Listen(FRunOptions Options)
	{
		Options.OnPassExecuted = [this](const FPassWrites& Writes)
		{
			const std::string& Effect = Writes.Pass.GetEffect();
			if (Effect.empty() || Effect == "Tonemap" || Writes.Mips.empty())
			{
				return; // the display's passes show in the picture itself
			}
			std::erase_if(Written, [&](const auto& Entry) { return Entry.first == Effect; });
			FWrittenMip Mip = Writes.Mips.front();
			const FPicture Whole = FPicture::Copy(*Mip.Texture, Mip.Mip);
			const FIntRect All(0, 0, Whole.Width, Whole.Height);
			Mip.Window.Clip(All);
			Written.emplace_back(Effect, Whole.Crop(Mip.Window.Area() > 0 ? Mip.Window : All));
		};
		return Options;
	}

	std::vector<std::pair<std::string, FPicture>> Written; // what the last pass of each effect wrote, in their order
	FRunSession Session;
	std::vector<FViewHistory> Last;
};

/** "line.truth.####.exr" for "line.####.exr"; empty where the file's name has no such place. */
std::string MakeTruthPattern(const std::string& Pattern)
{
	const size_t Hashes = Pattern.find(".#");
	return Hashes == std::string::npos ? std::string() : Pattern.substr(0, Hashes) + ".truth" + Pattern.substr(Hashes);
}

/** The truth's pattern relative to the config; empty: there is none. Throws where a frame of it is missing. */
std::string ChooseTruth(const FFlickerOptions& Options, const FConfig& Config, const std::vector<int>& Frames)
{
	const bool bAsked = !Options.Truth.empty();
	const std::string Pattern = bAsked ? Options.Truth : MakeTruthPattern(Config.Scene.Sequence);
	std::set<int> Existing;
	for (const FSequenceFrame& Frame :
		Pattern.empty() ? std::vector<FSequenceFrame>() : FindSequenceFrames(Config.Resolve(Pattern)))
	{
		Existing.insert(Frame.Number);
	}
	const auto Missing = std::ranges::find_if(Frames, [&](int Frame) { return !Existing.contains(Frame); });
	if (Missing == Frames.end())
	{
		return Pattern;
	}
	if (bAsked || !Existing.empty())
	{
		throw FError(
			{.Code = ErrorFileMissing, .Message = fmt::format("the truth has no frame {}: {}", *Missing, Pattern)},
			ExitFiles);
	}
	return "";
}

void MeasureVariant(const FFlickerOptions& Options, const std::vector<int>& Frames,
	const std::vector<FFrameSignals>& Truths, FFlickerVariant& Variant, FFlickerResult& Result)
{
	FRunOptions RunOptions = Options.Run;
	RunOptions.Frame = Frames.front();
	RunOptions.Variables.insert(RunOptions.Variables.end(), Variant.Variables.begin(), Variant.Variables.end());
	FFlickerRun Run(RunOptions);
	std::vector<std::string> Names;
	std::map<std::string, FFlickerMeter> Meters;
	for (size_t Index = 0; Index < Frames.size(); ++Index)
	{
		const FFrameSignals Signals = Run.RunFrame(Frames[Index], Result.Diagnostics);
		for (const auto& [Name, Signal] : Signals.Signals)
		{
			const FFlickerSignal* const Truth = Truths.empty() ? nullptr : Truths[Index].Find(Name);
			const bool bSameSize = Truth != nullptr && Truth->Light.size() == Signal.Light.size();
			if (!Truths.empty() && !bSameSize)
			{
				if (std::ranges::find(Result.Unmeasured, Name) == Result.Unmeasured.end())
				{
					Result.Unmeasured.push_back(Name);
				}
				continue;
			}
			if (!Meters.contains(Name))
			{
				Names.push_back(Name);
			}
			Meters[Name].Add(Frames[Index], Signal, Truth);
		}
		if (Options.Progress)
		{
			Options.Progress(static_cast<int>(Index + 1), static_cast<int>(Frames.size()), Variant.Name);
		}
	}
	for (const std::string& Name : Names)
	{
		Variant.Rows.push_back({Name, Meters[Name].Get()});
	}
}

} // namespace

FFlickerResult MeasureFlicker(const FFlickerOptions& Options)
{
	FFlickerResult Result;
	Result.Variants = Options.Variants;
	std::vector<FFrameSignals> Truths;
	{
		FRunOptions First = Options.Run;
		First.Frame.reset();
		const FConfig Config = FRunSession(First).GetConfig();
		const FConfigPlace ListPlace =
			Options.Frames.empty() ? Config.Scene.Frames.Place : FConfigPlace{0, 0, "--frames"};
		const std::string List = !Options.Frames.empty()       ? Options.Frames
								 : Config.Scene.Frames.IsSet() ? Config.Scene.Frames.Value
															   : "all";
		for (const FSequenceFrame& Frame : ChooseSequenceFrames(Config, List, ListPlace))
		{
			Result.Frames.push_back(Frame.Number);
		}
		Result.Truth = ChooseTruth(Options, Config, Result.Frames);
		const size_t Needed = Result.Truth.empty() ? 3 : 2;
		if (Result.Frames.size() < Needed)
		{
			throw BadArgument(fmt::format("flicker needs {} frames at least, and there {} {}", Needed,
								  Result.Frames.size() == 1 ? "is" : "are", Result.Frames.size()),
				ListPlace.Pointer);
		}
	}
	if (!Result.Truth.empty())
	{
		FRunOptions RunOptions = Options.Run;
		RunOptions.Frame = Result.Frames.front();
		RunOptions.ConfigPlaces.push_back("/scene/file=" + Result.Truth);
		RunOptions.Variables.push_back("r.AntiAliasingMethod=0");
		FFlickerRun Run(RunOptions);
		std::vector<FDiagnostic> Ignored; // the variants' runs have the same
		for (const int Frame : Result.Frames)
		{
			Truths.push_back(Run.RunFrame(Frame, Ignored));
		}
	}
	for (FFlickerVariant& Variant : Result.Variants)
	{
		MeasureVariant(Options, Result.Frames, Truths, Variant, Result);
	}
	return Result;
}

} // namespace Drydock
