// Finds the files that a name with #### stands for.
#include "Config/FrameSequence.h"

#include "Config/FrameList.h"
#include "RangeTools.h"
#include "Text/ConfigErrors.h"

#include <algorithm>
#include <charconv>
#include <filesystem>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

/** A file name around its number: "walk." 4 ".exr". */
struct FPattern
{
	explicit FPattern(const std::string& Name)
	{
		const size_t Last = Name.rfind('#');
		const size_t Before = Name.find_last_not_of('#', Last);
		const size_t First = Before == std::string::npos ? 0 : Before + 1;
		Start = Name.substr(0, First);
		NumDigits = Last + 1 - First;
		End = Name.substr(Last + 1);
	}

	std::optional<int> Match(const std::string& Name) const
	{
		if (Name.size() < Start.size() + NumDigits + End.size() || !Name.starts_with(Start) || !Name.ends_with(End))
		{
			return std::nullopt;
		}
		const char* const First = Name.data() + Start.size();
		const char* const Last = Name.data() + Name.size() - End.size();
		const bool bLonger = static_cast<size_t>(Last - First) > NumDigits;
		int Number = 0;
		const std::from_chars_result Result = std::from_chars(First, Last, Number);
		const bool bNumber = Result.ec == std::errc() && Result.ptr == Last && *First != '-';
		return bNumber && !(bLonger && *First == '0') ? std::optional(Number) : std::nullopt;
	}

	std::string Start;
	size_t NumDigits = 0;
	std::string End;
};

[[noreturn]] void ThrowNoFrame(const FConfig& Config, const std::string& Message)
{
	const auto& [Line, Column, Pointer] = Config.Scene.File.Place;
	throw FError({ESeverity::Error, ErrorFileMissing, Message, Config.File, Line, Column, Pointer}, ExitFiles);
}

std::vector<FSequenceFrame> FindFrames(const FConfig& Config, const std::string& Pattern)
{
	std::vector<FSequenceFrame> Frames = FindSequenceFrames(Config.Resolve(Pattern));
	if (Frames.empty())
	{
		const Files::path Resolved = Config.Resolve(Pattern);
		std::error_code Error;
		const Files::directory_iterator Listed(Resolved.has_parent_path() ? Resolved.parent_path() : ".", Error);
		ThrowNoFrame(Config, "no file matches " + Resolved.string() + (Error ? ": " + Error.message() : ""));
	}
	return Frames;
}

const FSequenceFrame& FindFrame(
	const FConfig& Config, const std::string& Pattern, const std::vector<FSequenceFrame>& Frames, int Number)
{
	const auto Found = std::ranges::find(Frames, Number, &FSequenceFrame::Number);
	if (Found == Frames.end())
	{
		ThrowNoFrame(Config, "there is no frame " + std::to_string(Number) + " of " + Config.Resolve(Pattern) +
								 ": there are " + std::to_string(Frames.front().Number) + " to " +
								 std::to_string(Frames.back().Number));
	}
	return *Found;
}

/** The first of scene.frames. */
std::optional<int> GetFirstListed(const FConfigScene& Scene)
{
	std::string Ignored;
	const std::optional<FFrameList> List = ParseFrameList(Scene.Frames.Value, Ignored);
	return Scene.Frames.IsSet() && List && !List->bAll ? std::optional(List->Ranges.front().First) : std::nullopt;
}

} // namespace

bool IsFrameSequence(const std::string& Path)
{
	return Files::path(Path).filename().string().find('#') != std::string::npos;
}

std::vector<FSequenceFrame> FindSequenceFrames(const std::string& Pattern)
{
	std::vector<FSequenceFrame> Frames;
	if (!IsFrameSequence(Pattern))
	{
		return Frames;
	}
	const FPattern Names(Files::path(Pattern).filename().string());
	const Files::path Folder = Files::path(Pattern).parent_path();
	std::error_code Error;
	for (Files::directory_iterator Entry(Folder.empty() ? "." : Folder, Error), End; !Error && Entry != End;
		 Entry.increment(Error))
	{
		const std::string Name = Entry->path().filename().string();
		if (const std::optional<int> Number = Names.Match(Name))
		{
			Frames.push_back({*Number, (Folder / Name).string()});
		}
	}
	std::sort(Frames.begin(), Frames.end(),
		[](const FSequenceFrame& A, const FSequenceFrame& B) { return A.Number < B.Number; });
	return Frames;
}

void ChooseSceneFrame(FConfig& Config, std::optional<int> Frame)
{
	std::string& File = Config.Scene.File.Value;
	if (!IsFrameSequence(File))
	{
		return;
	}
	const std::vector<FSequenceFrame> Frames = FindFrames(Config, File);
	const int Number = Frame.value_or(GetFirstListed(Config.Scene).value_or(Frames.front().Number));
	const FSequenceFrame& Found = FindFrame(Config, File, Frames, Number);
	Config.Scene.Sequence = File;
	Config.Scene.Frame = Found.Number;
	File = (Files::path(File).parent_path() / Files::path(Found.Path).filename()).string();
}

std::vector<FSequenceFrame> ChooseSequenceFrames(
	const FConfig& Config, const std::string& List, const FConfigPlace& Place)
{
	const auto Throw = [&](const std::string& Message)
	{
		throw FError({ESeverity::Error, ErrorBadArgument, Message, Config.File, 0, 0, Place.Pointer}, ExitUsage);
	};
	std::string Error;
	const std::optional<FFrameList> Parsed = ParseFrameList(List, Error);
	if (!Parsed)
	{
		Throw(Error);
	}
	const std::string& Pattern = Config.Scene.Sequence;
	if (Pattern.empty())
	{
		Throw("the scene is not a sequence: scene.file has no #### in its name");
	}
	const std::vector<FSequenceFrame> Existing = FindFrames(Config, Pattern);
	const std::vector<int> Numbers = ToVector<int>(Existing, &FSequenceFrame::Number);
	return ToVector<FSequenceFrame>(
		ListFrames(*Parsed, Numbers), [&](int Number) { return FindFrame(Config, Pattern, Existing, Number); });
}

std::vector<FSequenceFrame> FindFramesBefore(const FConfig& Config, const std::vector<FSequenceFrame>& Frames)
{
	const int First = Frames.front().Number;
	const int Step = Frames.size() > 1 ? Frames[1].Number - First : 1;
	std::vector<FSequenceFrame> All = ChooseSequenceFrames(Config, "all", {});
	std::erase_if(
		All, [&](const FSequenceFrame& Frame) { return Frame.Number >= First || (First - Frame.Number) % Step != 0; });
	return All;
}

} // namespace Drydock
