// Source: drydock.
#include "FrameSequence.h"

#include "ConfigErrors.h"

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
	FDiagnostic Diagnostic;
	Diagnostic.Code = ErrorFileMissing;
	Diagnostic.File = Config.File;
	Diagnostic.Line = Config.Scene.File.Place.Line;
	Diagnostic.Column = Config.Scene.File.Place.Column;
	Diagnostic.Where = Config.Scene.File.Place.Pointer;
	Diagnostic.Message = Message;
	throw FError(Diagnostic, ExitFiles);
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
	const std::vector<FSequenceFrame> Frames = FindSequenceFrames(Config.Resolve(File));
	if (Frames.empty())
	{
		ThrowNoFrame(Config, "no file matches " + Config.Resolve(File));
	}
	const auto Found = std::find_if(Frames.begin(), Frames.end(),
		[&](const FSequenceFrame& Candidate) { return !Frame || Candidate.Number == *Frame; });
	if (Found == Frames.end())
	{
		ThrowNoFrame(Config, "there is no frame " + std::to_string(*Frame) + " of " + Config.Resolve(File) +
								 ": there are " + std::to_string(Frames.front().Number) + " to " +
								 std::to_string(Frames.back().Number));
	}
	Config.Scene.Sequence = File;
	Config.Scene.Frame = Found->Number;
	File = (Files::path(File).parent_path() / Files::path(Found->Path).filename()).string();
}

} // namespace Drydock
