// The folder of a sequence: frames/0001, frames/0002, ... each as a single run writes it, with frame.json (its part of
// sequence.json) and a list of its files. A frame's folder is complete from the moment it exists. The latest one holds
// the state that the next frame needs, view_state.bin. One run at a time writes to a folder, and removes only what is
// on lists.
#pragma once

#include "Run/Run.h"
#include "Text/AsideFile.h"
#include "Text/FileList.h"
#include "Text/FolderLock.h"

#include <string>
#include <vector>

namespace Drydock
{

class DRYDOCK_API FSequenceFolder : private FNoncopyable
{
public:
	/** Makes the folder and keeps other runs out until it is destroyed; removes what a killed run left half done.
	 * NumDigits: of a frame's folder, at least. Throws FError: something that drydock did not write is in the way
	 * (DD1080, exit code 2); in use, a list that is damaged, or not to be written (3). */
	FSequenceFolder(const std::string& InPath, int InNumDigits);

	/** The frames that are there, ascending. */
	std::vector<int> FindFrames() const;

	/** "out/walk/frames/0003". */
	std::string GetFramePath(int Frame) const;

	/** The fault of the files of a frame in the folder: "final.png is empty"; nothing where all but the state are as
	 * they were written. Throws FError (exit code 3) when a file cannot be read. */
	std::string FindDamage(int Frame) const;

	/** Throws FError (DD1080, exit code 2) when its folder holds more than drydock wrote. */
	void RequireOwnFrame(int Frame) const;

	/** Writes a frame's folder in place of the existing one. Throws FError as WriteNewRunFolder does. ViewState: empty
	 * where it would not help. */
	void WriteFrame(int Frame, const FRunResult& Result, const std::string& FrameJson, const std::string& ViewState);

	std::string ReadFrameJson(int Frame) const;
	bool HasViewState(int Frame) const;
	std::string ReadViewState(int Frame) const;
	std::string GetViewStatePath(int Frame) const;
	/** Removes the view state of a frame: only the latest frame's is of use. */
	void RemoveViewState(int Frame);

	/** Empty where there is none. Throws FError (exit code 3) when it is not as it was written. */
	std::string ReadSequenceJson() const;
	void WriteSequenceJson(const std::string& Text);

	/** Whether sheet.png is there as it was written. */
	bool HasSheet() const;
	/** Throws FError as WriteSequenceSheet. */
	void WriteSheet(const std::vector<int>& Frames, const std::vector<std::string>& Pictures);

	/** Writes sequence.html, which contains the time, so that no two have the same bytes. */
	void WritePage(const std::string& Text);
	/** Removes the page if there is one: it is of other frames. */
	void RemovePage();

	/** Removes the frames and sequence.json. Throws FError: there is more in a frame's folder than drydock wrote (exit
	 * code 2; then nothing was removed), or it cannot be removed (3). */
	void Clear();

	const std::string& GetPath() const { return Path; }

private:
	/** Throws where a file or folder is in the way that is on no list. */
	void RequireOwn() const;
	void RemoveFrame(int Frame);
	FFileList ReadFrameList(int Frame) const;
	void WriteList() const;
	/** Puts a file in its place, which is on the list before it is there. bSteady: equal runs write equal bytes. */
	void Put(FAsideFile& Aside, const std::string& Name, bool bSteady = true);

	const std::string Path;
	const int NumDigits;
	const FFolderLock Lock;
	FFileList List; // of the files beside the frames
};

} // namespace Drydock
