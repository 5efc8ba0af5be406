// Finds, reads and writes the files of a sequence under a lock.
#include "Sequence/SequenceFolder.h"

#include "Run/RunOutputs.h"
#include "Sequence/SequenceErrors.h"
#include "Text/ConfigErrors.h"
#include "Text/AsideFile.h"
#include "Text/TextFile.h"

#include <algorithm>
#include <charconv>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <unistd.h>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

const char* const FrameJsonName = "frame.json";
const char* const ViewStateName = "view_state.bin";
const char* const SequenceJsonName = "sequence.json";

[[noreturn]] void Throw(int Code, const Files::path& Path, const std::string& Message)
{
	throw FError({.Code = Code, .Message = Message, .File = Path.string()}, ExitFiles);
}

Files::path GetFrames(const std::string& Path)
{
	return Files::path(Path) / "frames";
}

} // namespace

FSequenceFolder::FSequenceFolder(const std::string& InPath, int InNumDigits)
	: Path(InPath)
	, NumDigits(InNumDigits)
{
	std::error_code Error;
	Files::create_directories(GetFrames(Path), Error);
	const std::string LockPath = (Files::path(Path) / ".sequence.lock").string();
	Lock = Error ? -1 : open(LockPath.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
	if (Lock < 0)
	{
		Throw(
			ErrorFileNotWritten, Path, "cannot be written: " + (Error ? Error.message() : "the lock file is refused"));
	}
	if (flock(Lock, LOCK_EX | LOCK_NB) != 0)
	{
		close(Lock);
		Throw(
			ErrorSequenceInUse, Path, "another run is writing to this folder: wait for it, or name another with --out");
	}
	RemoveLeftovers();
}

FSequenceFolder::~FSequenceFolder()
{
	close(Lock); // and with it goes the lock; the file stays, for who would remove it might race another run
}

void FSequenceFolder::RemoveLeftovers()
{
	std::error_code Ignored;
	std::vector<Files::path> Leftovers;
	for (const Files::path& Folder : {Files::path(Path), GetFrames(Path)})
	{
		for (const Files::directory_entry& Entry : Files::directory_iterator(Folder, Ignored))
		{
			if (FAsideFile::IsAside(Entry.path()))
			{
				Leftovers.push_back(Entry.path());
			}
		}
	}
	for (const Files::path& Leftover : Leftovers)
	{
		Files::remove_all(Leftover, Ignored);
	}
}

std::vector<int> FSequenceFolder::FindFrames() const
{
	std::vector<int> Frames;
	std::error_code Ignored;
	for (const Files::directory_entry& Entry : Files::directory_iterator(GetFrames(Path), Ignored))
	{
		const std::string Name = Entry.path().filename().string();
		int Frame = 0;
		const std::from_chars_result Result = std::from_chars(Name.data(), Name.data() + Name.size(), Frame);
		if (Result.ec == std::errc() && Result.ptr == Name.data() + Name.size() && Entry.path() == GetFramePath(Frame))
		{
			Frames.push_back(Frame);
		}
	}
	std::sort(Frames.begin(), Frames.end());
	return Frames;
}

std::string FSequenceFolder::GetFramePath(int Frame) const
{
	const std::string Number = std::to_string(Frame);
	const size_t NumZeros = static_cast<size_t>(std::max(NumDigits - static_cast<int>(Number.size()), 0));
	return (GetFrames(Path) / (std::string(NumZeros, '0') + Number)).string();
}

void FSequenceFolder::WriteFrame(
	int Frame, const FRunResult& Result, const std::string& FrameJson, const std::string& ViewState)
{
	std::map<std::string, std::string> Further = {{FrameJsonName, FrameJson}};
	if (!ViewState.empty())
	{
		Further[ViewStateName] = ViewState;
	}
	WriteNewRunFolder(Result, GetFramePath(Frame), Further);
}

std::string FSequenceFolder::ReadFrameJson(int Frame) const
{
	return ReadTextFile((Files::path(GetFramePath(Frame)) / FrameJsonName).string());
}

std::string FSequenceFolder::GetViewStatePath(int Frame) const
{
	return (Files::path(GetFramePath(Frame)) / ViewStateName).string();
}

std::string FSequenceFolder::ReadViewState(int Frame) const
{
	return ReadTextFile(GetViewStatePath(Frame), "cannot be read", MaxBinaryBytes);
}

void FSequenceFolder::RemoveViewState(int Frame)
{
	std::error_code Ignored;
	Files::remove(GetViewStatePath(Frame), Ignored);
}

std::string FSequenceFolder::ReadSequenceJson() const
{
	const std::string File = (Files::path(Path) / SequenceJsonName).string();
	std::error_code Ignored;
	return Files::exists(File, Ignored) ? ReadTextFile(File) : "";
}

void FSequenceFolder::WriteSequenceJson(const std::string& Text)
{
	WriteTextFile((Files::path(Path) / SequenceJsonName).string(), Text);
}

void FSequenceFolder::Clear()
{
	// sequence.json last: without it the frames would be nobody's.
	std::error_code Error;
	Files::remove_all(GetFrames(Path), Error);
	if (!Error)
	{
		Files::create_directories(GetFrames(Path), Error);
	}
	if (!Error)
	{
		Files::remove(Files::path(Path) / SequenceJsonName, Error);
	}
	if (Error)
	{
		Throw(ErrorFileNotWritten, Path, "cannot be cleared: " + Error.message());
	}
}

} // namespace Drydock
