// Finds, reads and writes the files of a sequence under a lock.
#include "Sequence/SequenceFolder.h"

#include "Run/RunOutputs.h"
#include "Sequence/SequenceErrors.h"
#include "Sequence/SequenceSheet.h"
#include "Text/ConfigErrors.h"
#include "Text/Fingerprint.h"
#include "Text/OutputFolder.h"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <algorithm>
#include <optional>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

const char* const FrameJsonName = "frame.json";
const char* const ViewStateName = "view_state.bin";
const char* const SequenceJsonName = "sequence.json";
const char* const SheetName = "sheet.png";
const char* const PageName = "sequence.html";
const char* const ListName = ".drydock.sequence.files";

Files::path GetFrames(const std::string& Path)
{
	return Files::path(Path) / "frames";
}

/** The number that a frame's folder has for a name. */
std::optional<int> ParseFrame(const std::string& Name)
{
	const std::optional<int> Frame = ParseAll<int>(Name);
	return Frame >= 0 ? Frame : std::nullopt;
}

bool IsThere(const Files::path& Path)
{
	std::error_code Ignored;
	return Files::exists(Files::symlink_status(Path, Ignored));
}

} // namespace

FSequenceFolder::FSequenceFolder(const std::string& InPath, int InNumDigits)
	: Path(InPath)
	, NumDigits(InNumDigits)
	, Lock(InPath)
	, List(FFileList::Read(Files::path(InPath) / ListName))
{
	RequireOwn();
	FAsideFile::RemoveAbandoned(GetFrames(Path), [](const std::string& Name) { return ParseFrame(Name).has_value(); });
	if (List.Settle(Path))
	{
		WriteList();
	}
}

void FSequenceFolder::RequireOwn() const
{
	std::error_code Ignored;
	for (const char* Name : {SequenceJsonName, SheetName, PageName})
	{
		const Files::path File = Files::path(Path) / Name;
		if (IsThere(File) && !List.Has(Name) && (!Files::is_regular_file(File) || Files::file_size(File) > 0))
		{
			throw MakeForeignError(File, "drydock did not write this");
		}
	}
	if (IsThere(GetFrames(Path)) && !Files::is_directory(Files::symlink_status(GetFrames(Path), Ignored)))
	{
		throw MakeForeignError(GetFrames(Path), "drydock did not write this");
	}
	for (const int Frame : FindFrames())
	{
		const Files::path Folder = GetFramePath(Frame);
		if (Files::is_symlink(Folder) || !IsThere(Folder / RunFolderListName))
		{
			throw MakeForeignError(Folder, "drydock did not write this");
		}
	}
}

FFileList FSequenceFolder::ReadFrameList(int Frame) const
{
	return FFileList::Read(Files::path(GetFramePath(Frame)) / RunFolderListName);
}

void FSequenceFolder::RequireOwnFrame(int Frame) const
{
	const std::string Foreign = ReadFrameList(Frame).FindForeign(GetFramePath(Frame), "", {RunFolderListName});
	if (!Foreign.empty())
	{
		throw MakeForeignError(Files::path(GetFramePath(Frame)) / Foreign, "drydock did not write this");
	}
}

void FSequenceFolder::RemoveFrame(int Frame)
{
	const Files::path Folder = GetFramePath(Frame);
	if (!IsThere(Folder))
	{
		return;
	}
	RequireOwnFrame(Frame);
	RemoveFiles(Folder, ReadFrameList(Frame).GetNames());
	RemoveFiles(Folder, {RunFolderListName}); // last: without it, what is left would be nobody's
	RemoveFiles(Folder.parent_path(), {Folder.filename().string()});
}

std::vector<int> FSequenceFolder::FindFrames() const
{
	std::vector<int> Frames;
	std::error_code Ignored;
	for (const Files::directory_entry& Entry : Files::directory_iterator(GetFrames(Path), Ignored))
	{
		const std::optional<int> Frame = ParseFrame(Entry.path().filename().string());
		const bool bEmpty = Entry.is_directory(Ignored) && Files::is_empty(Entry.path(), Ignored); // half removed
		if (Frame && Entry.path() == GetFramePath(*Frame) && !bEmpty)
		{
			Frames.push_back(*Frame);
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

std::string FSequenceFolder::FindDamage(int Frame) const
{
	const FFileList Written = ReadFrameList(Frame);
	for (const std::string& Name : Written.GetNames())
	{
		const std::string Fault = Name == ViewStateName ? "" : Written.FindFault(GetFramePath(Frame), Name);
		if (!Fault.empty())
		{
			return Name + " " + Fault;
		}
	}
	return Written.Has(FrameJsonName) ? "" : std::string(FrameJsonName) + " is missing";
}

void FSequenceFolder::WriteFrame(
	int Frame, const FRunResult& Result, const std::string& FrameJson, const std::string& ViewState)
{
	std::map<std::string, std::string> Further = {{FrameJsonName, FrameJson}};
	if (!ViewState.empty())
	{
		Further[ViewStateName] = ViewState;
	}
	RemoveFrame(Frame);
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

bool FSequenceFolder::HasViewState(int Frame) const
{
	return IsThere(GetViewStatePath(Frame));
}

std::string FSequenceFolder::ReadViewState(int Frame) const
{
	return ReadTextFile(GetViewStatePath(Frame), "cannot be read", MaxBinaryBytes);
}

void FSequenceFolder::RemoveViewState(int Frame)
{
	std::error_code Ignored;
	if (ReadFrameList(Frame).Has(ViewStateName))
	{
		Files::remove(GetViewStatePath(Frame), Ignored);
	}
}

std::string FSequenceFolder::ReadSequenceJson() const
{
	const Files::path File = Files::path(Path) / SequenceJsonName;
	if (!IsThere(File))
	{
		return "";
	}
	const std::string Fault = List.FindFault(Path, SequenceJsonName);
	if (!Fault.empty())
	{
		throw FError({.Code = ErrorSequenceBroken,
						 .Message = "this " + Fault + ": --restart renders all frames again",
						 .File = File.string()},
			ExitFiles);
	}
	return ReadTextFile(File.string());
}

void FSequenceFolder::WriteList() const
{
	WriteTextFile((Files::path(Path) / ListName).string(), List.GetText());
}

void FSequenceFolder::Put(FAsideFile& Aside, const std::string& Name, bool bSteady)
{
	const std::string Fingerprint = bSteady ? FingerprintFile(Aside.GetPath().string()) : "";
	const FEndActionsHeld Held;
	List.Add(Name, Fingerprint);
	WriteList();
	Aside.PutInPlace();
	List.Remove(Name);
	List.Add(Name, Fingerprint);
	WriteList();
}

void FSequenceFolder::WriteSequenceJson(const std::string& Text)
{
	FAsideFile Aside(Files::path(Path) / SequenceJsonName);
	WriteWholeFile(Aside.GetPath().string(), Text);
	Put(Aside, SequenceJsonName);
}

bool FSequenceFolder::HasSheet() const
{
	return List.FindFault(Path, SheetName).empty();
}

void FSequenceFolder::WriteSheet(const std::vector<int>& Frames, const std::vector<std::string>& Pictures)
{
	FAsideFile Aside(Files::path(Path) / SheetName);
	WriteSequenceSheet(Aside.GetPath().string(), Frames, Pictures);
	Put(Aside, SheetName);
}

void FSequenceFolder::WritePage(const std::string& Text)
{
	FAsideFile Aside(Files::path(Path) / PageName);
	WriteWholeFile(Aside.GetPath().string(), Text);
	Put(Aside, PageName, false);
}

void FSequenceFolder::RemovePage()
{
	if (List.Has(PageName))
	{
		RemoveFiles(Path, {PageName});
		List.Remove(PageName);
		WriteList();
	}
}

void FSequenceFolder::Clear()
{
	const std::vector<int> Frames = FindFrames();
	for (const int Frame : Frames)
	{
		RequireOwnFrame(Frame);
	}
	for (const int Frame : Frames)
	{
		RemoveFrame(Frame);
	}
	RemoveFiles(Path, {SequenceJsonName}); // last: without it the frames would be nobody's
}

} // namespace Drydock
